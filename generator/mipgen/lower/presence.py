"""Which parameters of a field may be absent, and how many come."""

from __future__ import annotations

from mipgen import model as m

Record = m.Field | m.Struct


def last(record: Record) -> dict[str, int]:
    """Parameter -> how many are present when it is, for those that may be absent."""
    return {p.name: group.last for group in record.groups for p in group.parameters}


def required(f: m.Field) -> dict[int, int]:
    """Function -> how many parameters must be present."""
    return {c.function.value: len(c.required) for c in f.calls if c.function}
