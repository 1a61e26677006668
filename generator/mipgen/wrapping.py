"""Lines of texts: where a paragraph breaks."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Sequence
from itertools import pairwise

#: Other than single spaces between words.
_UNEVEN = re.compile(r"[\t\n\v\f\r]|^ |  | $")


def wrapped(text: str, width: int, hang: str = "") -> list[str]:
    """The lines of a paragraph; those after the first begin with `hang`. Words are never broken.

    >>> wrapped("one two three", 9, "  "), wrapped("one two", 9), wrapped("", 9)
    (['one two', '  three'], ['one two'], [])
    >>> wrapped("one  two", 5), wrapped("eleven a", 5, " "), wrapped("a eleven", 5), wrapped(" a b ", 3)
    (['one', 'two'], ['eleven', ' a'], ['a', 'eleven'], [' a', 'b'])
    """
    if _UNEVEN.search(text) or not text:  # rare, and slow
        return textwrap.wrap(text, width, subsequent_indent=hang, break_long_words=False, break_on_hyphens=False)
    lines: list[str] = []
    line = text
    while len(line) > width:
        start = len(hang) if lines else 0
        at = line.rfind(" ", start, width + 1) if start <= width else -1
        at = line.find(" ", start) if at < 0 else at
        if at < 0:
            break  # one long word
        lines.append(line[:at])
        line = hang + line[at + 1 :]
    return [*lines, line]


def call(head: str, arguments: Sequence[str], tail: str, width: int = 100, comma: str = ",") -> str:
    """A call in a programming language, with a line for each argument if one line is too long.

    >>> print(call("f(", ["a", "b"], ")"), call("f(", ["a", "b"], ")", 3), sep="; ")
    f(a, b); f(
        a,
        b,
    )
    """
    line = f"{head}{', '.join(arguments)}{tail}"
    if len(line) <= width or not arguments:
        return line
    each = [broken(a, width - 5).replace("\n", "\n    ") for a in arguments]
    return "".join([head, "\n    ", ",\n    ".join(each), comma, "\n", tail])


def broken(text: str, width: int) -> str:
    """An expression that ends with brackets, with a line for each of what is in them if one line is too long.

    >>> print(broken("x = {{1, 2}, f(3, ')')};", 14))
    x = {
        {1, 2},
        f(3, ')'),
    };
    >>> print(broken("x = {{1, 2}, f(3, ')')};", 12))
    x = {
        {1, 2},
        f(
            3,
            ')',
        ),
    };
    >>> broken("[(1 | 2)]", 1), broken("(a | b)", 1)  # a comma would make another value of it
    ('[\\n    (1 | 2),\\n]', '(a | b)')
    """
    if len(text) <= width or not text.endswith((")", "]", "}", "};")):
        return text
    start, commas = _last_brackets(text)
    end = len(text.removesuffix(";")) - 1
    edges = [start, *commas, end]
    parts = [text[a + 1 : b].strip() for a, b in pairwise(edges)]
    if len(parts) == 1 and text[start] == "(" and not text[start - 1 : start].isalnum():
        return text
    return call(text[: start + 1], [p for p in parts if p], text[end:], width)


def _last_brackets(text: str) -> tuple[int, list[int]]:
    """Where the brackets that end last begin, and the commas between the things in them."""
    opened: list[tuple[int, list[int]]] = []
    last: tuple[int, list[int]] = (0, [])
    quote = ""
    escaped = False
    for i, c in enumerate(text):
        if quote:
            quote = "" if c == quote and not escaped else quote
            escaped = c == "\\" and not escaped
        elif c in "\"'":
            quote = c
        elif c in "([{":
            opened.append((i, []))
        elif c in ")]}":
            last = opened.pop()
        elif c == "," and opened:
            opened[-1][1].append(i)
    return last
