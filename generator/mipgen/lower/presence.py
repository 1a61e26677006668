"""Which parameters of a field may be absent: groups that come or stay away together, and how many come."""

from __future__ import annotations

from collections.abc import Iterable

from mipgen import model as m

Record = m.Field | m.Struct


def groups(record: Record) -> tuple[m.GroupOp, ...]:
    return tuple(op for op in record.operations if isinstance(op, m.GroupOp))


def single(operations: Iterable[m.Operation]) -> list[m.ValueOp]:
    """The operations in order, those of groups too."""
    return [inner for op in operations for inner in (op.body if isinstance(op, m.GroupOp) else (op,))]


def last(record: Record) -> dict[str, int]:
    """Parameter -> how many are present when it is, for those that may be absent."""
    return {op.member: group.last for group in groups(record) for op in group.body}


def required(f: m.Field) -> dict[int, int]:
    """Function -> how many parameters must be present."""
    return {c.function.value: len(c.required) for c in f.calls if c.function}
