"""The times of packets, in the clocks that the specification names."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Iterable
from datetime import datetime, timedelta
from functools import cache, lru_cache
from typing import NamedTuple

from .. import registry, timestamps
from .._clocks import CLOCKS
from ..errors import DecodeError
from ..field import Field
from ..packet import Packet
from ..parameter import Flag
from ..reflection import info
from ..timestamps import MOST, REACH, SECOND, from_date

_UNIX = datetime(1970, 1, 1)


class _Source(NamedTuple):
    clock: str
    kind: type[Field]
    scales: tuple[tuple[str, int], ...]  # attribute -> nanoseconds
    flags: tuple[Flag, ...]
    size: int  # bytes that its data have at least


def dated(clock: str | None) -> bool:
    """Does it have a date? Then its times are UTC."""
    return clock is not None and CLOCKS[clock] is not None


def headers(data: bytes) -> bytes:
    """The lengths and descriptors of the fields of a packet, up to a malformed one."""
    found = bytearray()
    at, end = 4, len(data) - 2
    while at < end:
        length = data[at]
        if length < 2 or length > end - at:
            break
        found += data[at : at + 2]
        at += length
    return bytes(found)


def moments(packet: Packet) -> dict[str, int | None]:
    """The times in a packet, in nanoseconds, by their clocks; None if they are not valid.

    They are since 1970 in UTC if the clock has a date, else since its start. Of several fields for
    one clock, that with the lowest descriptor counts.
    """
    data = bytes(packet)
    return moments_of(data, headers(data)) if packet.set >= 0x80 else {}


def moments_of(data: bytes, headers: bytes) -> dict[str, int | None]:
    """The same of the bytes of a packet of data, with the headers of its fields."""
    places = _places(data[2], headers)
    return {source.clock: _time(source, data[begin:end]) for source, begin, end in places}


@lru_cache(maxsize=4096)
def _places(number: int, headers: bytes) -> tuple[tuple[_Source, int, int], ...]:
    """Where packets with these fields have their times."""
    found: dict[str, tuple[int, _Source, int, int]] = {}
    at = 4
    for length, descriptor in zip(headers[::2], headers[1::2]):
        source = _source(number, descriptor)
        if source is not None and found.get(source.clock, (0x100,))[0] > descriptor:
            if length >= source.size + 2:
                found[source.clock] = (descriptor, source, at + 2, at + length)
        at += length
    return tuple(place[1:] for place in found.values())


@cache
def _source(set: int, descriptor: int) -> _Source | None:
    clock = timestamps.clock_of(set, descriptor)
    if clock is None:
        return None
    (kind,) = registry.types(set, descriptor)
    parts = [(p, n) for p in info(kind).parameters if (n := timestamps.scale(p)) is not None]
    flags = dict.fromkeys(flag for p, _ in parts for flag in p.flags)
    scales = tuple((p.attribute, n) for p, n in parts)
    return _Source(clock, kind, scales, tuple(flags), _size(kind))


def _size(kind: type[Field]) -> int:
    """How many bytes of zeros are needed to decode one."""
    for size in range(254):
        try:
            kind.decode(bytes(size))
            return size
        except DecodeError:
            continue
    return 254


def _time(source: _Source, data: bytes) -> int | None:
    try:
        value = source.kind.decode(data)
    except DecodeError:
        return None
    for flag in source.flags:
        if not flag.holds(int(getattr(value, flag.attribute))):
            return None
    total = 0
    for attribute, scale in source.scales:
        number = getattr(value, attribute)
        if not -MOST < number * scale < MOST:  # NaN is not, either
            return None
        total += round(number * scale)
    return utc(source.clock, total) if CLOCKS[source.clock] else total


def utc(clock: str, time: int) -> int:
    """A time of a clock with a date as UTC; during a leap second the next one begins."""
    begins, shifts = timestamps.leaps(clock)
    return time + shifts[bisect_right(begins, time)]


class Timeline:
    """The time of each packet: its own, else the last one of its set."""

    def __init__(self, clock: str | None) -> None:
        self._clock = clock
        self._last: dict[int, tuple[int | None, int]] = {}

    def at(self, packet: Packet, offset: int) -> tuple[int | None, bool]:
        """The time, None if none is known or it is not valid, and whether it is the packet's own."""
        if self._clock is None:
            return None, False
        own = moments(packet)
        if self._clock in own:
            self._last[packet.set] = own[self._clock], offset
            return own[self._clock], True
        time, place = self._last.get(packet.set, (None, offset))
        return (time if offset - place <= REACH else None), False


def best(found: Callable[[], Iterable[Packet]]) -> str | None:
    """The first clock that has a valid time in these packets; looks no further than that needs."""
    seen: set[str] = set()
    for packet in found():
        seen.update(clock for clock, time in moments(packet).items() if time is not None)
        if next(iter(CLOCKS), None) in seen:
            break
    return next((clock for clock in CLOCKS if clock in seen), None)


def stamp(clock: str, time: int, digits: int = 9) -> str:
    """A time as text: UTC in ISO 8601 for clocks with a date, seconds for others."""
    if not dated(clock):
        return seconds(time, digits)
    unit = 10 ** (9 - digits)
    second, rest = divmod((time + unit // 2) // unit * unit, SECOND)
    try:
        date = (_UNIX + timedelta(seconds=second)).isoformat(timespec="seconds")
    except OverflowError:  # after the year 9999
        return seconds(time, digits)
    return f"{date}.{rest // unit:0{digits}d}Z"


def seconds(time: int, digits: int = 9) -> str:
    """Nanoseconds as a decimal number of seconds."""
    unit = 10 ** (9 - digits)
    whole, rest = divmod((abs(time) + unit // 2) // unit, 10**digits)
    return f"{'-' if time < 0 else ''}{whole}.{rest:0{digits}d}"


__all__ = [
    "CLOCKS",
    "SECOND",
    "Timeline",
    "best",
    "dated",
    "from_date",
    "headers",
    "moments",
    "moments_of",
    "seconds",
    "stamp",
    "utc",
]
