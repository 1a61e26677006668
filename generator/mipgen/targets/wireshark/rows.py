"""Rows of the tables that the dissector interprets: one for each operation, with what its parameter says."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from mipgen import model as m
from mipgen.lower import extent

from . import texts

Record = m.Field | m.Struct
Named = m.Enum | m.Bitfield


@dataclass(frozen=True, slots=True)
class Row:
    """One operation. A template has one branch per `kind` and takes what it needs."""

    kind: str
    name: str
    op: m.Operation
    parameter: m.Parameter | None  # None: an item of an array
    record: Record | None
    type: Named | None = None
    item: Row | None = None
    size: int = 0  # of one item of an array
    body: tuple[Row, ...] = ()
    cases: tuple[tuple[m.Case, Row | None], ...] = ()

    @property
    def units(self) -> tuple[str, ...]:
        """What is shown after values; nothing after plain numbers."""
        found = self.parameter.units if self.parameter else ()
        return tuple("" if unit == "1" else unit for unit in found) if set(found) - {"1"} else ()

    @property
    def readings(self) -> tuple[m.Variant, ...]:
        return tuple(v for v in self.parameter.variants if v.type is not None) if self.parameter else ()


def rows(record: Record) -> list[Row]:
    return list(_rows(record.operations, record))


def _rows(operations: tuple[m.Operation, ...], record: Record) -> Iterator[Row]:
    parameters = {p.name: p for p in record.parameters}
    for op in operations:
        if isinstance(op, m.GroupOp):
            yield Row("group", "", op, None, record, body=tuple(_rows(op.body, record)))
        else:
            yield _row(op, parameters[op.member], record)


def _row(op: m.ValueOp, p: m.Parameter | None, record: Record | None) -> Row:
    row = Row(op.kind, op.member, op, p, record, op.named)
    if isinstance(op, m.ArrayOp):
        return replace(row, item=_row(op.item, None, None), size=extent.element(op))
    cases = ((c, _row(c.operation, c.parameter, record) if c.operation else None) for c in (p.cases if p else ()))
    return replace(row, cases=tuple(cases))


# --------------------------------------------------------------------------- bits


@dataclass(frozen=True, slots=True)
class Place:
    """Where bits are: bytes from the first one of the bitfield, and a mask in their number."""

    at: int
    size: int
    mask: int
    little: bool = False  # the bytes of the number are in reverse order

    @property
    def shift(self) -> int:
        return (self.mask & -self.mask).bit_length() - 1


def place(b: m.Bits, t: m.Bitfield) -> Place:
    """The bytes with which Wireshark shows them: the whole of a short bitfield, the fewest of a long one.

    >>> health = m.Bitfield("h", None, 16, (), "", None)
    >>> place(m.Bits("a", 20, 23, "", False), health), place(m.Bits("b", 30, 33, "", False), health)
    (Place(at=2, size=1, mask=240, little=False), Place(at=3, size=2, mask=960, little=True))
    >>> place(m.Bits("c", 9, 9, "", False), m.Bitfield("i", m.SCALARS["u16"], 2, (), "", None))
    Place(at=0, size=2, mask=512, little=False)
    """
    if t.scalar is not None and t.size <= 4:
        return Place(0, t.size, b.mask)
    first, last = b.first // 8, b.last // 8
    size = last - first + 1
    mask = b.mask >> (8 * first)
    if t.scalar is None:
        return Place(first, size, mask, size > 1)
    return Place(t.size - 1 - last, size, mask)


def types(model: m.Model) -> list[Named]:
    """Every enumeration and bitfield, once."""
    known = [model.protocol.function_selector, model.protocol.ack_code, *model.all_types]
    return list({texts.qualified(t): t for t in known if isinstance(t, (m.Enum, m.Bitfield))}.values())


def structs(model: m.Model) -> list[m.Struct]:
    """Every structure, those that others hold before these."""
    return [t for t in model.all_types if isinstance(t, m.Struct)]
