"""Straight code for layouts that never vary: which bytes hold which member."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from ... import model as m
from ... import operations
from .names import LANGUAGE, member

_SCALARS: dict[str, str] = LANGUAGE["scalars"]


@dataclass(frozen=True, slots=True)
class Access:
    """One member, or one of the numbers or texts inside of it."""

    path: str
    offset: int  # in the data of the field
    type: str  # name of the scalar
    size: int  # bytes of one number
    count: int  # of an array; 0 for a single number
    text: bool = False  # followed by a NUL

    @property
    def bytes(self) -> bool:
        """Are they copied as they are?"""
        return self.count > 0 and self.size == 1

    @property
    def real(self) -> bool:
        return self.type in ("float", "double")

    @property
    def cast(self) -> str:
        """The type of the number, where it is not the unsigned one."""
        return _SCALARS[self.type] if m.SCALARS[self.type].kind in ("signed", "char") else ""


def direct(f: m.Field) -> list[Access]:
    """The members of a field in wire order; none if its layout varies or has constants, which need checks."""
    if f.min_size != f.max_size or not all(_plain(op) for op in f.operations):
        return []
    return [*_accesses(f.operations, "", 0)]


def _plain(op: m.Operation) -> bool:
    match op:
        case m.ScalarOp() | m.BitsOp():
            return True
        case m.TextOp():
            return op.count is not None
        case m.ArrayOp():
            return op.count is not None and _plain(op.item)
        case m.StructOp():
            return all(_plain(inner) for inner in op.struct.operations)
        case _:
            return False


def _accesses(ops: Sequence[m.Operation], of: str, offset: int) -> Iterator[Access]:
    for op in ops:
        yield from _access(op, f"{of}{member(op.member)}", offset)  # type: ignore[union-attr]
        offset += operations.size(op)[0]


def _access(op: m.Operation, path: str, offset: int) -> Iterator[Access]:
    match op:
        case m.ScalarOp():
            yield Access(path, offset, op.scalar.name, op.size, 0)
        case m.BitsOp():
            yield Access(f"{path}.bytes", offset, "u8", 1, op.size)
        case m.TextOp():
            yield Access(path, offset, "char", 1, op.capacity, text=True)
        case m.StructOp():
            yield from _accesses(op.struct.operations, f"{path}.", offset)
        case m.ArrayOp(item=m.ScalarOp() as item):
            yield Access(path, offset, item.scalar.name, item.size, op.capacity)
        case m.ArrayOp():
            for i in range(op.capacity):
                yield from _access(op.item, f"{path}[{i}]", offset + i * operations.size(op.item)[0])
