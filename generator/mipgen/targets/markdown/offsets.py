"""Where each parameter is in the data of a field: offsets and sizes, which may depend on counters."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from ... import codec
from ... import model as m
from ...describe import Record

#: The number of elements of an array that fills the field, as the specification calls it.
REST = "rest"


@dataclass(frozen=True, slots=True)
class Extent:
    """A number of bytes. It may depend on counters, and on the number of an element.

    >>> str(Extent(4) + Extent(0, ((3, "count"),))), str(Extent(7)), str(Extent(0, ((1, "n"),)))
    ('4 + 3*count', '7', 'n')
    """

    fixed: int = 0
    terms: tuple[tuple[int, str], ...] = ()

    def __add__(self, other: Extent) -> Extent:
        return Extent(self.fixed + other.fixed, self.terms + other.terms)

    def __str__(self) -> str:
        parts = [str(self.fixed)] if self.fixed or not self.terms else []
        parts += [name if size == 1 else f"{size}*{name}" for size, name in self.terms]
        return " + ".join(parts)


@dataclass(frozen=True, slots=True)
class Row:
    """A parameter at its place."""

    name: str  # with those of the records around it: "parameters.gpio.pin"
    offset: Extent
    size: Extent | None  # None: it reaches to the end of the field, or is a union
    parameter: m.Parameter | None  # None: the empty alternative of a union
    record: Record  # the field or structure that it belongs to
    case: tuple[m.Case, m.Parameter] | None = None  # it is this alternative of that union

    def beside(self, name: str) -> str:
        """The full name of a parameter of the same record."""
        last = 2 if self.case and self.parameter else 1
        around = self.name.split(".")[:-last]
        return ".".join([*around, name])


def layout(record: Record, at: Extent = Extent(), prefix: str = "", depth: int = 0) -> Iterator[Row]:
    """Every parameter at its place, with what is inside structures and unions."""
    for p in record.parameters:
        row = Row(prefix + p.name, at, extent(p.operation, prefix), p, record)
        yield row
        yield from _inside(row, p, depth)
        if row.size is not None:  # else nothing follows
            at += row.size


def _inside(row: Row, p: m.Parameter, depth: int) -> Iterator[Row]:
    match p.operation:
        case m.StructOp(struct=inner):
            yield from layout(inner, row.offset, f"{row.name}.", depth)
        case m.ArrayOp(item=m.StructOp(struct=inner)):
            index = "ijklmn"[depth]
            step = Extent(0, ((inner.max_size, index),))
            yield from layout(inner, row.offset + step, f"{row.name}[{index}].", depth + 1)
        case m.SwitchOp(cases=cases):
            for c in cases:
                q = c.parameter
                name = f"{row.name}.{q.name}" if q else row.name
                size = extent(q.operation, f"{row.name}.") if q else Extent()
                member = Row(name, row.offset, size, q, row.record, (c, p))
                yield member
                if q is not None:
                    yield from _inside(member, q, depth)
        case _:
            pass


# --------------------------------------------------------------------------- sizes


def extent(op: m.Operation, prefix: str = "") -> Extent | None:
    """The bytes of an operation, if those before it determine them."""
    found = extents(op, prefix)
    return found[0] if len(found) == 1 and all(name != REST for _, name in found[0].terms) else None


def extents(op: m.Operation, prefix: str = "") -> list[Extent]:
    """The bytes that an operation may have: one for each alternative of a union."""
    match op:
        case m.ScalarOp() | m.ConstantOp() | m.CounterOp() | m.BitsOp():
            return [Extent(op.size)]
        case m.TextOp() | m.ArrayOp():
            item = 1 if isinstance(op, m.TextOp) else codec.size_of(op.item)
            if op.count is not None:
                return [Extent(op.count * item)]
            return [Extent(0, ((item, prefix + op.counter if op.counter is not None else REST),))]
        case m.StructOp():
            return totals([p.operation for p in op.struct.parameters], Extent(), f"{prefix}{op.member}.")
        case m.SwitchOp():
            members = [c.operation for c in op.cases]
            inner = f"{prefix}{op.member}."
            return _distinct(e for one in members for e in (extents(one, inner) if one is not None else [Extent()]))
        case m.GroupOp():
            return totals(op.body, Extent(), prefix)


def totals(operations: Iterable[m.Operation], start: Extent, prefix: str = "") -> list[Extent]:
    """The bytes that some operations may have together, beside those before them."""
    found = [start]
    for op in operations:
        found = [a + b for a in found for b in extents(op, prefix)]
    return _distinct(found)


def _distinct(found: Iterable[Extent]) -> list[Extent]:
    return sorted(dict.fromkeys(found), key=lambda e: (e.fixed, e.terms))
