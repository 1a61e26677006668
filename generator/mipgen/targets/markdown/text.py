"""Markdown: escaped text, code, numbers, tables. Independent of MIP."""

from __future__ import annotations

import re
import struct
from collections.abc import Iterable, Sequence
from functools import cache

_SPECIAL = re.compile(r"[\\`*\[\]|<~$]|(?<![A-Za-z0-9])_|_(?![A-Za-z0-9])|&(?=#?\w+;)")
_ENTITIES = {"<": "&lt;", "&": "&amp;", "~": "&#126;", "$": "&#36;"}
_CODE_ENTITIES = str.maketrans(
    {"&": "&amp;", "<": "&lt;", "|": "&#124;", "`": "&#96;", "*": "&#42;", "_": "&#95;"},
)


@cache
def inline(text: object) -> str:
    r"""Escapes a part of a line, so that it contains no Markdown or HTML except code in backticks.

    >>> print(inline("4 + 3*a | <b> _c_ d_e"), inline("state `a_b*c` and `"))
    4 + 3\*a \| &lt;b> \_c\_ d_e state `a_b*c` and \`
    """
    parts = re.split(r"(`[^`|]+`)", re.sub(r"\s+", " ", str(text)))
    escaped = (_SPECIAL.sub(lambda x: _ENTITIES.get(x[0], "\\" + x[0]), part) for part in parts[::2])
    return "".join(a + b for a, b in zip(escaped, [*parts[1::2], ""], strict=True))


@cache
def opening(markdown: str) -> str:
    r"""Escapes the beginning of a line of Markdown, so that it does not begin a list, a heading or a quotation.

    >>> print(opening("1. a"), opening("- b"), opening("3.1 c"))
    1\. a \- b 3.1 c
    """
    numbered = re.sub(r"^(\d+)([.)])(?= |$)", r"\1\\\2", markdown.strip())
    return re.sub(r"^([-+#>=])", r"\\\1", numbered)


def escaped_line(text: object) -> str:
    """Escapes a text that is a whole line, cell or heading."""
    return opening(inline(text))


def code(text: object) -> str:
    """
    >>> code("a_b*c"), code("a|b")
    ('`a_b*c`', '<code>a&#124;b</code>')
    """
    whole = str(text)
    if "`" in whole or "|" in whole or whole != whole.strip() or not whole:
        return f"<code>{whole.translate(_CODE_ENTITIES)}</code>"
    return f"`{whole}`"


def table(rows: Iterable[Sequence[str]], headings: Sequence[str]) -> str:
    """Writes a table of finished cells; empty columns are omitted, and so is a table without rows."""
    whole = [list(row) for row in rows]
    if not whole:
        return ""
    kept = [i for i in range(len(headings)) if i == 0 or any(row[i] for row in whole)]
    lines = [[headings[i] for i in kept], ["---"] * len(kept), *([row[i] for i in kept] for row in whole)]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


# --------------------------------------------------------------------------- numbers and bytes


def hexadecimal(value: int, size: int = 1) -> str:
    """
    >>> hexadecimal(10), hexadecimal(1, 2)
    ('0x0A', '0x0001')
    """
    return f"0x{value:0{2 * size}X}"


def spaced(data: Iterable[int | None]) -> str:
    """
    >>> spaced([0x75, 0x65, None])
    '75 65 ??'
    """
    return " ".join("??" if b is None else f"{b:02X}" for b in data)


def count(things: Sequence[object], word: str, several: str = "") -> str:
    """
    >>> count([7], "bit"), count([], "entry", "entries")
    ('1 bit', '0 entries')
    """
    n = len(things)
    return f"{n} {word if n == 1 else several or word + 's'}"


def decimal(bits: str) -> str:
    """Writes the shortest decimal number with these bits.

    >>> decimal("0x3dcccccd"), decimal("0x3fb999999999999a"), decimal("0xbf800000"), decimal("0x7fe5bf7f")
    ('0.1', '0.1', '-1', 'NaN (0x7FE5BF7F)')
    """
    raw = bytes.fromhex(bits[2:])
    form = ">f" if len(raw) == 4 else ">d"
    value = struct.unpack(form, raw)[0]
    if value != value:
        return f"NaN (0x{raw.hex().upper()})"
    for digits in range(6, 18):
        text = f"{value:.{digits}g}"
        try:
            if struct.pack(form, float(text)) == raw:
                return text
        except OverflowError:
            continue
    raise AssertionError(bits)
