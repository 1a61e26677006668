"""Line breaking of paragraphs, and of expressions in programming languages."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TypeAlias

#: So many items without brackets are elements of an array, several of which are on a line.
_ARRAY = 13


def wrapped(text: str, width: int, hang: str = "") -> list[str]:
    """Breaks a paragraph into lines; all but the first begin with `hang`. Words are never broken.

    >>> wrapped("one two three", 9, "  "), wrapped("one two", 9), wrapped("", 9)
    (['one two', '  three'], ['one two'], [])
    >>> wrapped("one  two", 5), wrapped("eleven a", 5, " "), wrapped("a eleven", 5), wrapped(" a b ", 3)
    (['one', 'two'], ['eleven', ' a'], ['a', 'eleven'], [' a', 'b'])
    """
    if " ".join(text.split()) != text or not text:  # rare, and slow
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


@dataclass(frozen=True, slots=True)
class Brackets:
    """An expression of a programming language with others in brackets: a call, a list, a structure."""

    head: str  # up to the opening bracket
    items: Sequence[Expression]
    tail: str  # from the closing bracket on
    comma: str = ","  # after the last item, if each item has its own line
    alone: str = ""  # after the only item, on one line
    pad: str = ""  # inside the brackets, on one line

    def after(self, text: str) -> Brackets:
        return replace(self, head=text + self.head)


#: A text that is never broken, or brackets.
Expression: TypeAlias = "str | Brackets"


def after(text: str, expression: Expression) -> Expression:
    """Puts a text before an expression: `x = [1]`."""
    return text + expression if isinstance(expression, str) else expression.after(text)


def flat(expression: Expression) -> str:
    """Writes an expression on one line.

    >>> flat(Brackets("f(", ["a", Brackets("[", ["b"], "]")], ")")), flat(Brackets("(", ["a"], ")", alone=","))
    ('f(a, [b])', '(a,)')
    >>> flat(Brackets("{", ["a"], "}", pad=" ")), flat(Brackets("{", [], "}", pad=" "))
    ('{ a }', '{}')
    """
    if isinstance(expression, str):
        return expression
    alone = expression.alone if len(expression.items) == 1 else ""
    pad = expression.pad if expression.items else ""
    return f"{expression.head}{pad}{', '.join(map(flat, expression.items))}{alone}{pad}{expression.tail}"


def laid_out(expression: Expression, width: int) -> str:
    """Writes an expression. If it does not fit on one line, its items are on a separate line, or on one line
    each. Those of long arrays fill lines.

    >>> inner = Brackets("f(", ["3", "')'"], ")")
    >>> print(laid_out(Brackets("x = {", [Brackets("{", ["1", "2"], "}"), inner], "};"), 14))
    x = {
        {1, 2},
        f(3, ')'),
    };
    >>> print(laid_out(Brackets("list[] = {", ["1", "2"], "};"), 14))
    list[] = {
        1, 2
    };
    >>> print(laid_out(Brackets("{", list("0123456789abcdef"), "}"), 34))
    {
        0, 1, 2, 3, 4, 5, 6, 7, 8, 9,
        a, b, c, d, e, f,
    }
    >>> print(laid_out(Brackets("g(", [inner], ")", comma=""), 9))
    g(
        f(
            3,
            ')',
        )
    )
    """
    line = flat(expression)
    if len(line) <= width or isinstance(expression, str) or not expression.items:
        return line
    inner = ", ".join(map(flat, expression.items)) + (expression.alone if len(expression.items) == 1 else "")
    if len(inner) <= width - 4:
        return f"{expression.head}\n    {inner}\n{expression.tail}"
    if len(expression.items) >= _ARRAY and all(isinstance(item, str) for item in expression.items):
        filled = "\n    ".join(wrapped(inner + expression.comma, width - 4))
        return f"{expression.head}\n    {filled}\n{expression.tail}"
    each = [laid_out(item, width - 5).replace("\n", "\n    ") for item in expression.items]
    return "".join([expression.head, "\n    ", ",\n    ".join(each), expression.comma, "\n", expression.tail])
