"""The steps of a codec, made from types, and their sizes."""

from __future__ import annotations

from dataclasses import replace

from . import model as m

REST = "rest"


def operation(name: str, element: m.Scalar | m.Type, length: int | str | None) -> m.Operation:
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


def _single(name: str, element: m.Scalar | m.Type) -> m.Operation:
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


def size(op: m.Operation | None) -> tuple[int, int]:
    """The fewest and the most bytes of an operation."""
    match op:
        case None:
            return 0, 0
        case m.ScalarOp() | m.ConstantOp() | m.CounterOp() | m.BitsOp():
            return op.size, op.size
        case m.TextOp():
            return op.count or 0, op.capacity
        case m.ArrayOp():
            item = size(op.item)[1]
            return (op.count or 0) * item, op.capacity * item
        case m.StructOp():
            return op.struct.min_size, op.struct.max_size
        case m.SwitchOp():
            sizes = [size(c.operation) for c in op.cases] or [(0, 0)]
            return 0, max(s[1] for s in sizes)
        case m.GroupOp():
            return 0, sum(size(o)[1] for o in op.body)


def with_capacity(op: m.Operation, capacities: dict[str, int]) -> m.Operation:
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
