"""The times of packets, in the clocks that the specification names."""

from __future__ import annotations

from datetime import datetime, timedelta

from ..binding import CLOCKS, SECOND

_UNIX = datetime(1970, 1, 1)


def dated(clock: str | None) -> bool:
    """Does the clock have a date? If so, its times are UTC."""
    return clock is not None and CLOCKS[clock] is not None


def stamp(clock: str, time: int, digits: int = 9) -> str:
    """Formats a time: UTC in ISO 8601 for clocks with a date, seconds for others."""
    if not dated(clock):
        return in_seconds(time, digits)
    unit = 10 ** (9 - digits)
    second, rest = divmod((time + unit // 2) // unit * unit, SECOND)
    try:
        date = (_UNIX + timedelta(seconds=second)).isoformat(timespec="seconds")
    except OverflowError:  # after the year 9999
        return in_seconds(time, digits)
    return f"{date}.{rest // unit:0{digits}d}Z"


def in_seconds(time: int, digits: int = 9) -> str:
    """Formats nanoseconds as a decimal number of seconds."""
    unit = 10 ** (9 - digits)
    whole, rest = divmod((abs(time) + unit // 2) // unit, 10**digits)
    return f"{'-' if time < 0 else ''}{whole}.{rest:0{digits}d}"
