"""Counts, sizes and times as text."""

from __future__ import annotations


def spent(seconds: float) -> str:
    """Formats a waiting time: `12 s`, `3:05 min`, `1:02:03 h`."""
    whole = round(seconds)
    if whole < 60:
        return f"{whole} s"
    minutes, rest = divmod(whole, 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02}:{rest:02} h" if hours else f"{minutes}:{rest:02} min"


def hertz(rate: float) -> str:
    """Formats a rate in Hz with five digits.

    >>> hertz(1000 / 3), hertz(177412), hertz(100)
    ('333.33', '177410', '100')
    """
    return f"{float(f'{rate:.5g}'):.10g}"


def readable(size: float) -> str:
    """Formats a number of bytes with a unit: `12 kB`."""
    for unit in ("B", "kB", "MB", "GB"):
        if size < 1000 or unit == "GB":
            return f"{size:.0f} {unit}" if unit == "B" else f"{size:.3g} {unit}"
        size /= 1000
    raise AssertionError


def count_text(number: int, what: str) -> str:
    """Formats a count: `1 byte`, `2 bytes`."""
    return f"{number} {what}{'s' * (number != 1)}"
