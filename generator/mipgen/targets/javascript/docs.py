"""Comments of declarations, as JavaScript lays them out."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from mipgen import model as m
from mipgen.emit.wrapping import wrapped
from mipgen.facts.comments import Comments

from . import names
from .members import hint

WIDTH = 120


def _alternative(p: m.Parameter | None, record: m.Record) -> str:
    return f"{names.member(p.name)}: {hint(p, record)}" if p else "{}"


COMMENTS = Comments(names, _alternative)


def filters(model: m.Model) -> dict[str, Callable[..., str]]:
    """Returns the filters that write comments."""

    def documented(paragraphs: Callable[..., list[str]], indent: int) -> Callable[..., str]:
        return lambda *thing: comment(paragraphs(*thing, model), indent)

    return {
        "family_doc": documented(COMMENTS.family, 0),
        "field_doc": documented(COMMENTS.field, 0),
        "type_doc": documented(COMMENTS.type, 0),
        "value_doc": documented(COMMENTS.value, 4),
        "bits_doc": documented(COMMENTS.bits, 4),
        "member_doc": documented(COMMENTS.member, 4),
        "function_doc": lambda f: comment([f.description], 4),
    }


def comment(paragraphs: Iterable[str], indent: int) -> str:
    """Writes an indented comment of these paragraphs, and a line end; nothing if they are empty.

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
    """Wraps a paragraph, or a list item with a hanging indent."""
    return wrapped(text, width, "  " if text.startswith("- ") else "") or [""]
