"""What timestamps say, for single packets and for columns alike."""

from __future__ import annotations

from datetime import datetime, timedelta
from functools import cache
from typing import NamedTuple

from . import registry
from ._clocks import CLOCKS, LEAP_SECONDS, TIMESTAMPS
from .field import Field
from .parameter import Parameter

SECOND = 1_000_000_000
#: How far before a packet without a timestamp the last one of its set may be, in bytes. The same
#: for every way of cutting a file.
REACH = 1 << 20
#: A part of a timestamp is not valid if it is so many nanoseconds or more: two of them fit into 64 bits.
MOST = 4 * 10**18

_UNITS = {"week": 604_800 * SECOND, "s": SECOND, "ms": 1_000_000, "us": 1000, "ns": 1}
_UNIX = datetime(1970, 1, 1)


def scale(parameter: Parameter) -> int | None:
    """The nanoseconds of its unit. A timestamp is the sum of all parameters that have such a unit."""
    return _UNITS.get(parameter.units[0]) if len(parameter.units) == 1 else None


@cache
def clock_of(set: int, descriptor: int) -> str | None:
    """The clock of a field, if it holds the time of its packet. Of several in a packet, the lowest counts."""
    kinds = registry.types(set, descriptor)
    if set < 0x80 or len(kinds) != 1:
        return None
    return TIMESTAMPS.get((kinds[0].SET, descriptor))


@cache
def kinds(set: int, clock: str) -> tuple[type[Field], ...]:
    """The fields of a set that hold the time of a clock, in the order in which they count."""
    known = sorted({d for _, d in TIMESTAMPS if clock_of(set, d) == clock})
    return tuple(registry.types(set, d)[0] for d in known)


class Leaps(NamedTuple):
    """How a clock becomes UTC: times from `begins[i]` on are moved by `shifts[i + 1]`, earlier ones by `shifts[0]`."""

    begins: tuple[int, ...]
    shifts: tuple[int, ...]


@cache
def leaps(clock: str) -> Leaps:
    """In nanoseconds, since the beginning of the clock; `shifts` lead to 1970. During a leap second the next one begins."""
    epoch = from_date(datetime.fromisoformat(CLOCKS[clock] or "1970-01-01"))
    days = [(from_date(datetime.fromisoformat(day)), ahead) for day, ahead in LEAP_SECONDS]
    begins = [day - epoch + ahead * SECOND for day, ahead in days]
    return Leaps(tuple(begins), (epoch, *(epoch - ahead * SECOND for _, ahead in days)))


def from_date(time: datetime) -> int:
    """Nanoseconds since 1970 of a time in UTC."""
    return (time - _UNIX) // timedelta(microseconds=1) * 1000


__all__ = ["MOST", "REACH", "SECOND", "Leaps", "clock_of", "from_date", "kinds", "leaps", "scale"]
