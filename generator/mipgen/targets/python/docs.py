"""Docstrings and comments, as Python lays them out."""

from __future__ import annotations

from collections.abc import Iterable

from mipgen import model as m
from mipgen.emit.wrapping import wrapped
from mipgen.facts.comments import Comments

from . import names
from .members import Member

WIDTH = 100  # of generated lines; the package's pyproject.toml sets the same for ruff


def _alternative(p: m.Parameter | None, record: m.Record) -> str:
    return Member(p, record).annotation if p else "None"


COMMENTS = Comments(names, _alternative)


def docstring(paragraphs: Iterable[str], indent: int = 0) -> str:
    """Writes an indented docstring of these paragraphs; nothing if they are empty.

    >>> docstring(["Short."], 4)
    '\"""Short.\"""'
    >>> print(docstring(["Short.", "- one\\n- two"], 4))
    \"""Short.
    <BLANKLINE>
        - one
        - two
        \"""
    """
    text = escaped("\n\n".join(filter(None, paragraphs)))
    if not text:
        return ""
    lines = [line for long in f'"""{text}'.split("\n") for line in _wrapped(long, WIDTH - indent)]
    if len(lines) == 1 and indent + len(lines[0]) + 3 <= WIDTH:
        return lines[0] + (' """' if text.endswith('"') else '"""')
    return _indented([*lines, '"""'], indent)


def escaped(text: str) -> str:
    """Writes a text inside a docstring."""
    return text.replace("\\", "\\\\").replace('"""', r"\"\"\"")


def comment(paragraphs: Iterable[str], indent: int = 0) -> str:
    """Writes an indented comment of these paragraphs."""
    return _indented([f"# {line}" for line in _wrapped(" ".join(filter(None, paragraphs)), WIDTH - indent - 2)], indent)


def _wrapped(text: str, width: int) -> list[str]:
    """Wraps a paragraph, or a list item with a hanging indent."""
    return wrapped(text, width, "  " if text.lstrip('"').startswith("- ") else "") or [""]


def _indented(lines: Iterable[str], indent: int) -> str:
    """Indents all lines except the first one, whose indentation is already there."""
    return "\n".join(" " * indent + line if line else "" for line in lines).lstrip()
