"""What a program does with a command: send it, and get its response."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from ... import model as m
from .names import field_name


@dataclass(frozen=True, slots=True)
class Send:
    """A function of the client that sends a command."""

    name: str
    response: m.Field | None
    doc: list[str]


def commands(s: m.Set) -> list[m.Field]:
    return [f for f in s.fields if f.role == m.COMMAND]


def sends(f: m.Field, model: m.Model) -> list[Send]:
    """One function; for a command that has several responses, or layouts of them, one for each."""
    what = f"Adds the command to a packet and waits for its answer: see mip_client_send. {f.title}."
    found = model.responses(f)
    if len(found) == 1:
        where = "The response goes to `response`, which may be NULL, if the command asks for it."
        return [Send(_sent(field_name(f)), found[0], [f"{what} {where}"])]
    plain = Send(_sent(field_name(f)), None, [what])
    return [plain, *(Send(_sent(f"for_{_bare(r)}"), r, [f"{what} It is answered by this response."]) for r in found)]


def identifiers(f: m.Field, model: m.Model) -> Iterator[str]:
    if f.role == m.COMMAND:
        yield f"{field_name(f)}_command"
        yield from (s.name for s in sends(f, model))


def _bare(f: m.Field) -> str:
    return field_name(f).removeprefix("mip_")


def _sent(name: str) -> str:
    return f"mip_send_{name.removeprefix('mip_')}"
