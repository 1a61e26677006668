"""Numbers that follow each other at fixed places: what a codec reads and writes at once.

Python joins them into one `struct`, C copies them without interpreting anything.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from mipgen import model as m

from . import extent
from .presence import single

#: Names of members, and numbers of elements.
Path = tuple[str | int, ...]


@dataclass(frozen=True, slots=True)
class Run:
    """Numbers of one kind, one behind the other."""

    path: Path
    op: m.ValueOp  # what they are
    scalar: m.Scalar
    count: int | None  # None: a single number
    offset: int

    @property
    def size(self) -> int:
        return self.scalar.size * (1 if self.count is None else self.count)


def run(op: m.Operation, path: Path = (), offset: int = 0) -> Run | None:
    """The numbers of an operation, if it is nothing but numbers of one kind, and always as many."""
    match op:
        case m.ScalarOp() | m.ConstantOp() | m.CounterOp():
            return Run(path, op, op.scalar, None, offset)
        case m.BitsOp():
            return Run(path, op, m.SCALARS["u8"], op.size, offset)
        case m.TextOp(count=int(count)):
            return Run(path, op, m.SCALARS["char"], count, offset)
        case m.ArrayOp(item=m.ScalarOp() as item, count=int(count)):
            return Run(path, op, item.scalar, count, offset)
    return None


def runs(f: m.Field) -> list[Run]:
    """Those that a whole field consists of; none if its layout varies or has constants, which need checks."""
    if f.min_size != f.max_size or not all(map(_fixed, f.operations)):
        return []
    return [*_all(single(f.operations), (), 0)]


def _fixed(op: m.Operation) -> bool:
    if op.kind in ("constant", "counter", "switch", "group") or op.open:
        return False
    return all(map(_fixed, op.inside))


def _all(operations: Sequence[m.ValueOp], path: Path, offset: int) -> Iterator[Run]:
    for op in operations:
        yield from _inside(op, (*path, op.member), offset)
        offset += extent.size(op)[0]


def _inside(op: m.ValueOp, path: Path, offset: int) -> Iterator[Run]:
    one = run(op, path, offset)
    if one is not None:
        yield one
    elif isinstance(op, m.ArrayOp):
        for i in range(op.count or 0):
            yield from _inside(op.item, (*path, i), offset + i * extent.element(op))
    elif isinstance(op, m.StructOp):
        yield from _all(op.struct.operations, path, offset)
