"""The steps of a codec, made from types."""

from __future__ import annotations

from dataclasses import replace

from mipgen import model as m

from .extent import REST


def operation(name: str, element: m.Scalar | m.Type, length: int | str | None) -> m.ValueOp:
    """How one value, or `length` of them, are read and written."""
    single = _single(name if length is None else "item", element)
    if length is None:
        return single
    count = length if isinstance(length, int) else None
    counter = length if isinstance(length, str) and length != REST else None
    if isinstance(element, m.Scalar) and element.kind == "char":
        return m.TextOp(name, count, counter, count or 0)
    assert isinstance(single, (m.ScalarOp, m.StructOp, m.ArrayOp))
    return m.ArrayOp(name, single, count, counter, count or 0)


def _single(name: str, element: m.Scalar | m.Type) -> m.ValueOp:
    match element:
        case m.Scalar():
            return m.ScalarOp(name, element, None, element.size)
        case m.Enum():
            return m.ScalarOp(name, element.scalar, element, element.scalar.size)
        case m.Bitfield():
            if element.scalar is None:
                return m.BitsOp(name, element, element.size)
            return m.ScalarOp(name, element.scalar, element, element.size)
        case m.Vector():
            item = m.ScalarOp("item", element.scalar, None, element.scalar.size)
            count = len(element.elements)
            return m.ArrayOp(name, item, count, None, count, element)
        case m.Struct():
            return m.StructOp(name, element)


def with_capacity(op: m.ValueOp, capacities: dict[str, int]) -> m.ValueOp:
    if isinstance(op, (m.ArrayOp, m.TextOp)) and op.count is None:
        return replace(op, capacity=capacities.get(op.member, 0))
    return op


def open_ended(op: m.Operation) -> bool:
    """Does it, or could it, reach to the end of the field?"""
    match op:
        case m.SwitchOp():
            return True
        case m.ArrayOp() | m.TextOp():
            return op.count is None and op.counter is None
        case m.StructOp():
            return bool(op.struct.operations) and open_ended(op.struct.operations[-1])
        case _:
            return False
