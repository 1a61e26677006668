"""Runs: numbers that follow each other at fixed offsets, which a codec reads and writes together.

Python joins them into one `struct`, C copies them without interpreting anything.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from mipgen import model as m

from . import extent

#: Names of members, and numbers of elements.
Path = tuple[str | int, ...]


@dataclass(frozen=True, slots=True)
class Run:
    """Consecutive numbers of one kind."""

    path: Path
    parameter: m.Parameter  # the numbers' parameter
    count: int | None  # None: a single number
    offset: int

    @property
    def scalar(self) -> m.Scalar:
        return self.parameter.scalar

    @property
    def size(self) -> int:
        return self.scalar.size * (1 if self.count is None else self.count)


def run(p: m.Parameter, path: Path = (), offset: int = 0) -> Run | None:
    """Returns the run of a parameter that consists of a fixed number of numbers of one kind; else None."""
    if p.kind in ("struct", "switch") or p.open or (p.several and p.item.kind != "scalar"):
        return None
    return Run(path, p, p.size if p.kind == "bits" else p.count, offset)


def runs(f: m.Field) -> list[Run]:
    """Returns the runs that make up a field; none if its layout varies or has constants, which need checks."""
    if f.min_size != f.max_size or f.optional or not all(map(_fixed, f.parameters)):
        return []
    return [*_all(f.parameters, (), 0)]


def _fixed(p: m.Parameter) -> bool:
    return p.kind not in ("constant", "counter", "switch") and not p.open and all(map(_fixed, p.inside))


def _all(parameters: Sequence[m.Parameter], path: Path, offset: int) -> Iterator[Run]:
    for p in parameters:
        yield from _inside(p, (*path, p.name), offset)
        offset += extent.size(p)[0]


def _inside(p: m.Parameter, path: Path, offset: int) -> Iterator[Run]:
    inner = run(p, path, offset)
    if inner is not None:
        yield inner
    elif p.struct:
        yield from _all(p.struct.parameters, path, offset)
    else:
        for i in range(p.count or 0):
            yield from _inside(p.item, (*path, i), offset + i * extent.item_size(p))
