"""Responses to commands."""

from __future__ import annotations

from collections.abc import Iterable

from mipgen import model as m

from .names import constant, responses_name, type_name
from .records import BOOL, Records


def response(command: m.Field) -> str:
    """Returns the response type of a command whose function is known only at run time."""
    whole = whole_response(command)
    return f"Option<{whole}>" if command.selector and whole != "()" else whole


def answers(command: m.Field) -> list[tuple[str, list[m.Function]]]:
    """Returns the response types of a command's functions: those without a response, then those with one."""
    whole = whole_response(command)
    plain = [f for f in command.functions if not f.responds or whole == "()"]
    return [
        (answer, functions)
        for answer, functions in (("()", plain), (whole, [f for f in command.functions if f not in plain]))
        if functions
    ]


def whole_response(command: m.Field) -> str:
    """Returns the type of a command's responses."""
    if len(command.responses) > 1:
        return responses_name(command)
    return type_name(command.responses[0]) if command.responses else "()"


def silent(command: m.Field) -> list[m.Function]:
    """Returns the functions to which the device never replies."""
    return [f for f in command.functions if not f.reply]


def holding(conditions: Iterable[m.Condition], command: m.Field, records: Records) -> list[str]:
    """Writes conditions on a command as members and their values: `part = types::Mode::FAST`."""
    members = {x.parameter.name: x for x in records.members(command)}
    tests = []
    for c in conditions:
        x = members[c.parameter]
        element = x.parameter.element
        known = element.by_name(c.label) if isinstance(element, m.Enum) else None
        value = str(c.value)
        if known:
            value = f"{x.type}::{constant(known.name)}"
        elif isinstance(element, m.Enum) or x.type == BOOL:
            value = f"{x.type}({c.value})"
        tests.append(f"{x.name} = {f'Some({value})' if x.may_be_absent else value}")
    return tests
