"""Comments of declarations, as JavaScript lays them out."""

from __future__ import annotations

from collections.abc import Iterable

from mipgen import model as m
from mipgen.emit.wrapping import wrapped
from mipgen.facts.comments import Comments

from . import names
from .members import hint

WIDTH = 120


def _alternative(p: m.Parameter | None, record: m.Record) -> str:
    return f"{names.member(p.name)}: {hint(p, record)}" if p else "{}"


COMMENTS = Comments(names, _alternative)


def of_family(x: m.Family, model: m.Model) -> str:
    return comment(COMMENTS.family(x, model), 0)


def of_field(f: m.Field, model: m.Model) -> str:
    return comment(COMMENTS.field(f, model), 0)


def of_type(t: m.Type, model: m.Model) -> str:
    return comment(COMMENTS.type(t, model), 0)


def of_function(f: m.Function) -> str:
    return comment([f.description], 4)


def of_value(v: m.EnumValue, t: m.Enum, model: m.Model) -> str:
    return comment(COMMENTS.value(v, t, model), 4)


def of_bits(b: m.Bits, t: m.Bitfield, model: m.Model) -> str:
    return comment(COMMENTS.bits(b, t, model), 4)


def of_member(p: m.Parameter, record: m.Record, model: m.Model) -> str:
    return comment(COMMENTS.member(p, record, model), 4)


def comment(paragraphs: Iterable[str], indent: int) -> str:
    """A comment of these paragraphs with a line end behind it, indented; nothing if they are empty.

    >>> comment(["Short."], 4)
    '    /** Short. */\\n'
    """
    text = "\n\n".join(filter(None, paragraphs)).replace("*/", "*\u200b/")
    if not text:
        return ""
    margin = " " * indent
    lines = [line for long in text.split("\n") for line in _wrapped(long, WIDTH - indent - 3)]
    if len(lines) == 1 and indent + len(lines[0]) + 7 <= WIDTH:
        return f"{margin}/** {lines[0]} */\n"
    return "\n".join([f"{margin}/**", *(f"{margin} * {line}".rstrip() for line in lines), f"{margin} */", ""])


def _wrapped(text: str, width: int) -> list[str]:
    """The lines of a paragraph or of an item of a list, which hangs below its dash."""
    return wrapped(text, width, "  " if text.startswith("- ") else "") or [""]
