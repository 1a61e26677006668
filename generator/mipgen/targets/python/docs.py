"""Docstrings and comments, as Python lays them out."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from mipgen import model as m
from mipgen.emit.wrapping import wrapped
from mipgen.facts.comments import Comments

from . import names
from .members import annotation

WIDTH = 100  # of generated lines; the package's pyproject.toml sets the same for ruff


def _alternative(p: m.Parameter | None, record: m.Record) -> str:
    return annotation(p, record) if p else "None"


COMMENTS = Comments(names, _alternative)


def filters(model: m.Model) -> dict[str, Callable[..., str]]:
    """Returns the filters that write docstrings, and comments for things without one."""

    def documented(paragraphs: Callable[..., list[str]], indent: int) -> Callable[..., str]:
        return lambda *thing: literal(paragraphs(*thing, model), indent)

    return {
        "family_doc": documented(COMMENTS.family, 0),
        "field_doc": documented(COMMENTS.field, 4),
        "type_doc": documented(COMMENTS.type, 4),
        "vector_doc": documented(COMMENTS.type, 0),  # the elements of a matrix in one line
        "value_doc": documented(COMMENTS.value, 4),
        "bits_doc": documented(COMMENTS.bits, 4),
        "member_doc": documented(COMMENTS.member, 4),
        "function_doc": lambda f: literal([f.description], 8),
        "device_doc": documented(COMMENTS.device, 0),
        # a parameter without a member, because it follows from the others
        "unheld_doc": lambda p, record: comment(" ".join(filter(None, COMMENTS.member(p, record, model))), 4),
    }


# --------------------------------------------------------------------------- layout


def literal(paragraphs: Iterable[str], indent: int) -> str:
    """Writes an indented docstring of these paragraphs; nothing if they are empty.

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
    """Writes an indented comment."""
    return _indented([f"# {line}" for line in _wrapped(text, WIDTH - indent - 2)], indent)


def _wrapped(text: str, width: int) -> list[str]:
    """Wraps a paragraph, or a list item with a hanging indent."""
    return wrapped(text, width, "  " if text.lstrip('"').startswith("- ") else "") or [""]


def _indented(lines: Iterable[str], indent: int) -> str:
    """Indents all lines except the first one, whose indentation is already there."""
    return "\n".join(" " * indent + line if line else "" for line in lines).lstrip()
