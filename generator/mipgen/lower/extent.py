"""How many bytes things take on the wire: the fewest, the most, and formulas where counters decide.

All sizes follow from `extents`; what a target shows of them is up to the target.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import NamedTuple

from mipgen import model as m

#: What counts the elements of an array that fills the field, as the specification calls it.
REST = "rest"


class Term(NamedTuple):
    """The bytes of an array whose length varies."""

    size: int  # of one element
    counter: str  # its path: "list.count"; or REST
    most: int = 0  # elements


@dataclass(frozen=True, slots=True)
class Extent:
    """A number of bytes. It may depend on counters, and on the number of an element.

    >>> str(Extent(4) + Extent(0, (Term(3, "count"),))), str(Extent(7)), str(Extent(0, (Term(1, "n"),)))
    ('4 + 3*count', '7', 'n')
    """

    fixed: int = 0
    terms: tuple[Term, ...] = ()

    def __add__(self, other: Extent) -> Extent:
        return Extent(self.fixed + other.fixed, self.terms + other.terms)

    def __str__(self) -> str:
        parts = [str(self.fixed)] if self.fixed or not self.terms else []
        parts += [t.counter if t.size == 1 else f"{t.size}*{t.counter}" for t in self.terms]
        return " + ".join(parts)

    @property
    def most(self) -> int:
        """With as many elements as there may be."""
        return self.fixed + sum(t.size * t.most for t in self.terms)

    @property
    def filling(self) -> bool:
        """Does it end with the field, so that no counter decides?"""
        return any(t.counter == REST for t in self.terms)

    @property
    def counted(self) -> Extent:
        """Without what fills the field."""
        return Extent(self.fixed, tuple(t for t in self.terms if t.counter != REST))


def extents(op: m.Operation, prefix: str = "", unknown: bool = False) -> list[Extent]:
    """The bytes that an operation may take: one for each alternative of a union, the shortest first.

    `prefix` leads to the record of the operation. `unknown`: a tag may be one that the specification does not know.
    """
    match op:
        case m.TextOp() | m.ArrayOp():
            size = element(op)
            if op.count is not None:
                return [Extent(op.count * size)]
            return [Extent(0, (Term(size, REST if op.counter is None else prefix + op.counter, op.capacity),))]
        case m.StructOp():
            return totals(op.struct.operations, Extent(), f"{prefix}{op.member}.", unknown)
        case m.SwitchOp():
            inner = f"{prefix}{op.member}."
            found = [e for c in op.cases if c.operation for e in extents(c.operation, inner, unknown)]
            empty = unknown or any(c.operation is None for c in op.cases)
            return _distinct([*found, *([Extent()] if empty else [])])
        case m.GroupOp():
            return totals(op.body, Extent(), prefix, unknown)
        case _:
            return [Extent(op.size)]


def totals(operations: Iterable[m.Operation], start: Extent, prefix: str = "", unknown: bool = False) -> list[Extent]:
    """The bytes that some operations may take together, after those before them."""
    found = [start]
    for op in operations:
        found = [a + b for a in found for b in extents(op, prefix, unknown)]
    return _distinct(found)


def _distinct(found: Iterable[Extent]) -> list[Extent]:
    return sorted(dict.fromkeys(found), key=lambda e: (e.fixed, e.terms))


# --------------------------------------------------------------------------- what is asked of them


def exact(op: m.Operation, prefix: str = "") -> Extent | None:
    """The bytes of an operation, if those before it determine them."""
    found = extents(op, prefix)
    return found[0] if len(found) == 1 and not found[0].filling else None


def shortest(operations: Iterable[m.Operation], prefix: str = "") -> Extent:
    """The bytes that operations take at least, given their counters."""
    return totals(operations, Extent(), prefix, unknown=True)[0]


def size(op: m.Operation) -> tuple[int, int]:
    """The fewest and the most bytes of an operation."""
    if isinstance(op, m.StructOp):
        return op.struct.min_size, op.struct.max_size
    found = extents(op, unknown=True)
    return min(e.fixed for e in found), max(e.most for e in found)


def fewest(operations: Iterable[m.Operation]) -> int:
    return sum(size(op)[0] for op in operations)


def most(operations: Iterable[m.Operation]) -> int:
    """As many as fit into a field."""
    return min(m.MAX_FIELD_DATA, sum(size(op)[1] for op in operations))


def element(op: m.TextOp | m.ArrayOp) -> int:
    """The bytes of one element."""
    return 1 if isinstance(op, m.TextOp) else size(op.item)[1]
