"""Straight-line code for fixed layouts: the bytes of each member."""

from __future__ import annotations

from dataclasses import dataclass

from mipgen import model as m
from mipgen.lower import runs
from mipgen.lower.runs import Path, Run

from .names import LANGUAGE, member

_SCALARS: dict[str, str] = LANGUAGE["scalars"]


@dataclass(frozen=True, slots=True)
class Access:
    """One member, or one of the numbers or texts inside it."""

    path: str
    offset: int  # in the data of the field
    type: str  # name of the scalar
    size: int  # bytes of one number
    count: int  # of an array; 0 for a single number
    text: bool = False  # followed by a NUL

    @property
    def bytes(self) -> bool:
        """Are the bytes copied unchanged?"""
        return self.count > 0 and self.size == 1

    @property
    def memory(self) -> int:
        return m.SCALARS[self.type].memory

    @property
    def real(self) -> bool:
        return self.type in ("float", "double")

    @property
    def cast(self) -> str:
        """The type of a signed number or a character, to which the unsigned one is cast; empty for others."""
        return _SCALARS[self.type] if m.SCALARS[self.type].kind in ("signed", "char") else ""


def direct(f: m.Field) -> list[Access]:
    """Returns the members of a field in wire order; none if its layout varies or has constants, which need checks."""
    return [_access(run) for run in runs.runs(f)]


def _access(r: Run) -> Access:
    path = _path(r.path) + (".bytes" if r.parameter.kind == "bits" else "")
    return Access(path, r.offset, r.scalar.name, r.scalar.size, r.count or 0, text=r.parameter.kind == "text")


def _path(parts: Path) -> str:
    """
    >>> _path(("points", 1, "x"))
    'points[1].x'
    """
    return "".join(f"[{x}]" if isinstance(x, int) else f".{member(x)}" for x in parts).removeprefix(".")
