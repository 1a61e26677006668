"""Numbers and strings as C writes them."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import count

from mipgen import model as m


def hexadecimal(value: int) -> str:
    """
    >>> hexadecimal(1)
    '0x01'
    """
    return f"0x{value:02X}"


def key(f: m.Field) -> str:
    """Writes descriptor set and descriptor of a field as one number."""
    return f"0x{f.set:02X}{f.descriptor:02X}"


def belongs(numbers: Sequence[int], name: str) -> str:
    """Writes the condition that the variable `name` is one of these ascending numbers.

    >>> belongs((0x81, 0x91, 0x92, 0x93), "set")
    'set == 0x81 || (set >= 0x91 && set <= 0x93)'
    """
    tests = []
    for first in (n for n in numbers if n - 1 not in numbers):
        last = next(n for n in count(first) if n + 1 not in numbers)
        inside = f"({name} >= {hexadecimal(first)} && {name} <= {hexadecimal(last)})"
        tests.append(inside if first < last else f"{name} == {hexadecimal(first)}")
    return " || ".join(tests)


def number(value: int, size: int, text: str = "") -> str:
    """Writes an unsigned number of `size` bytes; `text`, if given, is its notation.

    >>> number(3, 1), number(0xFFFF0000, 4), number(1, 8)
    ('3', 'UINT32_C(0xFFFF0000)', 'UINT64_C(1)')
    """
    text = text or (str(value) if value < 0x8000 else f"0x{value:X}")
    return f"UINT64_C({text})" if size == 8 else f"UINT32_C({text})" if value > 0x7FFF and size == 4 else text


def mask(b: m.Bits, t: m.Bitfield) -> str:
    """Writes a mask of bits, wide enough that its complement clears no other bits."""
    text = f"0x{b.mask:0{2 * t.size}X}"
    return f"UINT{8 * t.size}_C({text})" if t.size > 2 else f"{text}U"


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
