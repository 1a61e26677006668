"""How large structures are in memory."""

from __future__ import annotations

from ... import model as m
from .members import alternatives, members

#: No machine that C runs on aligns the numbers of structures more than this.
MAX_ALIGNMENT = 8


def max_value_size(model: m.Model) -> int:
    """At least the size of the largest structure of a field, a multiple of the largest alignment."""
    return max(_padded(record_size(f)[0], MAX_ALIGNMENT) for f in (model.protocol.acknowledge, *model.fields))


def record_size(record: m.Field | m.Struct) -> tuple[int, int]:
    """Size and alignment where each number is aligned to its own size; elsewhere there is less padding."""
    sizes = [(1, 1)] if isinstance(record, m.Field) and record.optional else []  # present
    for p in members(record):
        sizes += [(1, 1)] if p.length == "rest" else []  # the number of elements
        sizes.append(_member(p))
    return _in_a_row(sizes or [(1, 1)])


def _member(p: m.Parameter) -> tuple[int, int]:
    if p.element is None:
        sizes = [_in_a_row([(1, 1), _operation(a.operation)]) if a.length == "rest" else _operation(a.operation)
                 for a in alternatives(p)]  # fmt: skip
        alignment = max(alignment for _, alignment in sizes)
        return _padded(max(size for size, _ in sizes), alignment), alignment
    return _operation(p.operation)


def _operation(op: m.Operation) -> tuple[int, int]:
    match op:
        case m.ScalarOp() | m.CounterOp():
            return op.size, op.size
        case m.BitsOp():
            return op.size, 1
        case m.TextOp():
            return op.capacity + 1, 1
        case m.ArrayOp():
            size, alignment = _operation(op.item)
            return max(1, op.capacity) * size, alignment
        case m.StructOp():
            return record_size(op.struct)
    raise AssertionError(op)


def _in_a_row(sizes: list[tuple[int, int]]) -> tuple[int, int]:
    at = 0
    for size, alignment in sizes:
        at = _padded(at, alignment) + size
    alignment = max(alignment for _, alignment in sizes)
    return _padded(at, alignment), alignment


def _padded(size: int, alignment: int) -> int:
    return -(-size // alignment) * alignment
