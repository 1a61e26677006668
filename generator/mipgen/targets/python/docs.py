"""Docstrings and comments, as Python lays them out."""

from __future__ import annotations

from collections.abc import Iterable

from mipgen import model as m
from mipgen.emit.wrapping import wrapped
from mipgen.facts.comments import Comments

from . import names
from .members import annotation

WIDTH = 100  # of generated lines; pyproject.toml of the package says the same to ruff


def _alternative(p: m.Parameter | None, record: m.Record) -> str:
    return annotation(p, record) if p else "None"


COMMENTS = Comments(names, _alternative)


def of_family(x: m.Family, model: m.Model) -> str:
    return literal(COMMENTS.family(x, model), 0)


def of_field(f: m.Field, model: m.Model) -> str:
    return literal(COMMENTS.field(f, model), 4)


def of_type(t: m.Type, model: m.Model) -> str:
    return literal(COMMENTS.type(t, model), 0 if isinstance(t, m.Vector) else 4)


def of_function(f: m.Function) -> str:
    return literal([f.description], 8)


def of_device(d: m.Device, model: m.Model) -> str:
    return literal(COMMENTS.device(d, model), 0)


def of_value(v: m.EnumValue, t: m.Enum, model: m.Model) -> str:
    return literal(COMMENTS.value(v, t, model), 4)


def of_bits(b: m.Bits, t: m.Bitfield, model: m.Model) -> str:
    return literal(COMMENTS.bits(b, t, model), 4)


def of_member(p: m.Parameter, record: m.Record, model: m.Model) -> str:
    return literal(COMMENTS.member(p, record, model), 4)


def of_unheld(p: m.Parameter, record: m.Record, model: m.Model) -> str:
    """A comment on a parameter that objects do not hold, as it follows from the rest."""
    return comment(" ".join(filter(None, COMMENTS.member(p, record, model))), 4)


# --------------------------------------------------------------------------- layout


def literal(paragraphs: Iterable[str], indent: int) -> str:
    """A docstring of these paragraphs, indented; nothing if they are empty.

    >>> literal(["Short."], 4)
    '\"""Short.\"""'
    >>> print(literal(["Short.", "- one\\n- two"], 4))
    \"""Short.
    <BLANKLINE>
        - one
        - two
        \"""
    """
    text = "\n\n".join(filter(None, paragraphs)).replace("\\", "\\\\").replace('"""', r"\"\"\"")
    if not text:
        return ""
    lines = [line for long in f'"""{text}'.split("\n") for line in _wrapped(long, WIDTH - indent)]
    if len(lines) == 1 and indent + len(lines[0]) + 3 <= WIDTH:
        return lines[0] + (' """' if text.endswith('"') else '"""')
    return _indented([*lines, '"""'], indent)


def comment(text: str, indent: int) -> str:
    """A comment, indented."""
    return _indented([f"# {line}" for line in _wrapped(text, WIDTH - indent - 2)], indent)


def _wrapped(text: str, width: int) -> list[str]:
    """The lines of a paragraph or of an item of a list, which hangs below its dash."""
    return wrapped(text, width, "  " if text.lstrip('"').startswith("- ") else "") or [""]


def _indented(lines: Iterable[str], indent: int) -> str:
    """Lines, indented except for the first one, whose indentation is already there."""
    return "\n".join(" " * indent + line if line else "" for line in lines).lstrip()
