"""Ways to make a structure or a command, and what may answer it."""

from __future__ import annotations

from mipgen import model as m


def constructors(record: m.Record) -> tuple[m.Call, ...]:
    """One for each function of a command, or just one; none of what a device sends."""
    if isinstance(record, m.Struct):
        return (m.Call(None, record.parameters, ()),)
    return record.calls if record.role == m.COMMAND else ()


def replies(f: m.Field, function: m.Function | None, model: m.Model) -> list[m.Reply]:
    """The possible responses to a command with this function."""
    return [r for r in model.replies(f) if function is None or function in r.functions]
