"""What a command is answered with, and when."""

from __future__ import annotations

from dataclasses import dataclass

from . import model as m


@dataclass(frozen=True, slots=True)
class Reply:
    """A response of a command. It is sent if the function is one of `functions`, where the command has a
    selector, and if all of `when` holds."""

    response: m.Field
    functions: tuple[m.Function, ...]
    when: tuple[m.Condition, ...]


def replies(command: m.Field, model: m.Model) -> tuple[Reply, ...]:
    """The responses of a command, in order. Conditions are on the parameters of the command that owns a
    response; another command that has the same response is answered with it always."""
    of = model.set(command.set)
    known = {f.name: f for f in of.fields if f.role == m.RESPONSE} if of else {}
    functions = tuple(f for f in command.functions if f.responds)
    found = (known[name] for name in command.responses)
    return tuple(Reply(r, functions, r.when if r.command == command.name else ()) for r in found)
