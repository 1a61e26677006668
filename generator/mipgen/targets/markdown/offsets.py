"""Offsets and sizes of the parameters in the data of a field; they may depend on counters."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from mipgen import model as m
from mipgen.lower.extent import Extent, Term, exact_size, totals

from .text import code

#: The beginning of a record.
BEGIN = Extent()


@dataclass(frozen=True, slots=True)
class Row:
    """A parameter with its offset."""

    name: str  # with the names of the records around it: "parameters.gpio.pin"
    offset: Extent
    size: Extent | None  # None: it reaches to the end of the field, or is a union
    parameter: m.Parameter | None  # None: the empty alternative of a union
    record: m.Record  # the field or structure that contains it
    case: tuple[m.Case, m.Parameter] | None = None  # for an alternative: its case, and its union

    def beside(self, name: str) -> str:
        """Returns the full name of another parameter of the same record."""
        last = 2 if self.case and self.parameter else 1
        around = self.name.split(".")[:-last]
        return ".".join([*around, name])


def parameter_offsets(record: m.Record, at: Extent = BEGIN, prefix: str = "", depth: int = 0) -> Iterator[Row]:
    """Yields every parameter with its offset, including those inside structures and unions."""
    for p in record.parameters:
        row = Row(prefix + p.name, at, exact_size(p, prefix), p, record)
        yield row
        yield from _inside(row, p, depth)
        if row.size is not None:  # else nothing follows
            at += row.size


def _inside(row: Row, p: m.Parameter, depth: int) -> Iterator[Row]:
    if p.struct:
        yield from parameter_offsets(p.struct, row.offset, f"{row.name}.", depth)
    elif p.item.struct:
        index = "ijklmn"[depth]
        step = Extent(0, (Term(p.item.struct.max_size, index),))
        yield from parameter_offsets(p.item.struct, row.offset + step, f"{row.name}[{index}].", depth + 1)
    for c in p.cases:
        q = c.parameter
        name = f"{row.name}.{q.name}" if q else row.name
        size = exact_size(q, f"{row.name}.") if q else Extent()
        member = Row(name, row.offset, size, q, row.record, (c, p))
        yield member
        if q is not None:
            yield from _inside(member, q, depth)


def length(parameters: Sequence[m.Parameter], head: int = 2) -> str:
    """Writes the length of a field with these parameters after `head` bytes, as Markdown."""
    lengths = [code(e) if e.terms else str(e) for e in totals(parameters, Extent(head))]
    return " or ".join([", ".join(lengths[:-1]), lengths[-1]] if len(lengths) > 1 else lengths)
