"""Lines of texts: where a paragraph breaks."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Sequence

_OTHER_SPACE = re.compile(r"[\t\n\v\f\r]")


def wrapped(text: str, width: int, hang: str = "") -> list[str]:
    """The lines of a paragraph; those after the first begin with `hang`. Words are never broken.

    >>> wrapped("one two three", 9, "  "), wrapped("one two", 9), wrapped("", 9)
    (['one two', '  three'], ['one two'], [])
    >>> wrapped("one  two", 5), wrapped("eleven a", 5, " "), wrapped("a eleven", 5), wrapped(" a b ", 3)
    (['one', 'two'], ['eleven', ' a'], ['a', 'eleven'], [' a', 'b'])
    """
    first, *words = text.split(" ")
    if not first or "" in words or _OTHER_SPACE.search(text):  # rare, and slow
        return textwrap.wrap(text, width, subsequent_indent=hang, break_long_words=False, break_on_hyphens=False)
    lines = [first]
    for word in words:
        if len(lines[-1]) + 1 + len(word) <= width:
            lines[-1] += f" {word}"
        else:
            lines.append(hang + word)
    return lines


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
    each = "".join(f"    {a}," + "\n" for a in arguments)
    return f"{head}\n{each}".removesuffix(",\n") + f"{comma}\n{tail}"
