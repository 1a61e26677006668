"""Numbers and strings as C writes them."""

from __future__ import annotations

import re


def hexadecimal(value: int) -> str:
    """
    >>> hexadecimal(1)
    '0x01'
    """
    return f"0x{value:02X}"


def number(value: int, size: int, text: str = "") -> str:
    """Writes an unsigned number of `size` bytes; `text`, if given, is its notation.

    >>> number(3, 1), number(0xFFFF0000, 4), number(1, 8)
    ('3', 'UINT32_C(0xFFFF0000)', 'UINT64_C(1)')
    """
    text = text or (str(value) if value < 0x8000 else f"0x{value:X}")
    return f"UINT64_C({text})" if size == 8 else f"UINT32_C({text})" if value > 0x7FFF and size == 4 else text


def decimal(value: float | int) -> str:
    return repr(float(value)) if isinstance(value, float) else str(value)


def string(text: str | None) -> str:
    """
    >>> string('a "b" °')
    '"a \\\\"b\\\\" \\\\302\\\\260"'
    """
    if text is None:
        return "NULL"
    out = _SPECIAL.sub(_escaped, " ".join(text.split()))
    return f'"{out.replace("??", "?" + chr(92) + "?")}"'


def plain(text: str) -> str:
    """Writes a text without the characters that mean something to build systems.

    >>> plain('a "b" ${c} @d@ 1')
    'a b {c} d 1'
    """
    return " ".join(re.sub(r'["#$@\\]', " ", text).split())


_SPECIAL = re.compile(r'["\\]|[^ -~]')


def _escaped(match: re.Match[str]) -> str:
    return f"\\{match[0]}" if match[0] in '"\\' else "".join(f"\\{byte:03o}" for byte in match[0].encode("utf-8"))


def version_number(version: str) -> int:
    """
    >>> version_number("1.2.3")
    10203
    """
    major, minor, patch = (int(part) for part in re.split(r"[.+-]", version)[:3])
    return 10000 * major + 100 * minor + patch
