"""The members of structures and commands, their constructors, and the possible responses to a command."""

from __future__ import annotations

from mipgen import model as m


def members(record: m.Record) -> list[m.Parameter]:
    """Returns the parameters that an object stores: the others follow from these."""
    return [p for p in record.parameters if not p.derived]


def constructors(record: m.Record) -> tuple[m.Call, ...]:
    """Returns the constructors of a record: one for each function of a command, or just one; none if a device sends
    it."""
    if isinstance(record, m.Struct):
        return (m.Call(None, record.parameters, ()),)
    return record.calls if record.role == m.COMMAND else ()


def replies(f: m.Field, function: m.Function | None, model: m.Model) -> list[m.Reply]:
    """Returns the possible responses to a command with this function."""
    return [r for r in model.replies(f) if function is None or function in r.functions]


def possible_layouts(f: m.Field, function: m.Function | None, model: m.Model) -> list[m.Field]:
    """Returns the layouts of the possible responses to a command with this function."""
    return [layout for r in replies(f, function, model) for layout in r.layouts]
