"""Interprets timestamps, both of single packets and of columns."""

from __future__ import annotations

from bisect import bisect_right
from datetime import datetime, timedelta
from functools import cache, lru_cache
from typing import NamedTuple

from . import registry
from ._clocks import CLOCKS, LEAP_SECONDS, TIMESTAMPS, UNIT_KEYS
from .errors import DecodeError
from .field import Field
from .packet import Packet
from .parameter import Flag, Parameter

SECOND = 1_000_000_000
#: A packet without a timestamp may use one of the same set up to this many bytes before it. The
#: distance is in bytes so that the result does not depend on how a file is split.
REACH = 1 << 20
#: Each part of a timestamp must be below this many nanoseconds, positive or negative, so that the
#: sum of two parts fits into a signed 64-bit integer.
MOST = 4 * 10**18

_UNITS = {"week": 604_800 * SECOND, "s": SECOND, "ms": 1_000_000, "us": 1000, "ns": 1}
_UNIX = datetime(1970, 1, 1)


def scale(parameter: Parameter) -> int | None:
    """Returns the nanoseconds in the parameter's unit; None if it is not a unit of time. A
    timestamp is the sum of all parameters with one."""
    if len(parameter.units) != 1:
        return None
    unit = parameter.units[0]
    return _UNITS.get(UNIT_KEYS.get(unit, unit))


@cache
def clock_of(set: int, descriptor: int) -> str | None:
    """Returns the clock whose time the field contains, if the field is its packet's timestamp. Of
    several for one clock, the one with the lowest descriptor counts."""
    kinds = registry.types(set, descriptor)
    if set < 0x80 or len(kinds) != 1:
        return None
    return TIMESTAMPS.get((getattr(kinds[0], "SET", set), descriptor))


@cache
def kinds(set: int, clock: str) -> tuple[type[Field], ...]:
    """Returns the fields of a set that contain the time of a clock, in order of precedence."""
    known = sorted({d for _, d in TIMESTAMPS if clock_of(set, d) == clock})
    return tuple(registry.types(set, d)[0] for d in known)


class Leaps(NamedTuple):
    """The conversion of a clock to UTC: add `shifts[i + 1]` to times from `begins[i]` on, and
    `shifts[0]` to earlier ones."""

    begins: tuple[int, ...]
    shifts: tuple[int, ...]


@cache
def leaps(clock: str) -> Leaps:
    """Returns the leap seconds of a clock, in nanoseconds; `begins` count from the clock's epoch,
    and shifted times from 1970. A leap second becomes the second after it."""
    epoch = from_date(datetime.fromisoformat(CLOCKS[clock] or "1970-01-01"))
    days = [(from_date(datetime.fromisoformat(day)), ahead) for day, ahead in LEAP_SECONDS]
    begins = [day - epoch + ahead * SECOND for day, ahead in days]
    return Leaps(tuple(begins), (epoch, *(epoch - ahead * SECOND for _, ahead in days)))


def from_date(time: datetime) -> int:
    """Returns a UTC time as nanoseconds since 1970."""
    return (time - _UNIX) // timedelta(microseconds=1) * 1000


class _Source(NamedTuple):
    clock: str
    kind: type[Field]
    scales: tuple[tuple[str, int], ...]  # attribute -> nanoseconds
    flags: tuple[Flag, ...]
    size: int  # the smallest size of its data


def headers(data: bytes) -> bytes:
    """Returns the length and descriptor of each field in a packet, up to a malformed one."""
    headers = bytearray()
    at, end = 4, len(data) - 2
    while at < end:
        length = data[at]
        if length < 2 or length > end - at:
            break
        headers += data[at : at + 2]
        at += length
    return bytes(headers)


def moments(packet: Packet) -> dict[str, int | None]:
    """Returns the times in a packet by clock, in nanoseconds; None for a time that is not valid.

    They count from 1970 in UTC if the clock has a date, otherwise from the clock's start. If
    several fields contain the time of one clock, the one with the lowest descriptor counts.
    """
    data = bytes(packet)
    return moments_of(data, headers(data)) if packet.set >= 0x80 else {}


def moments_of(data: bytes, headers: bytes) -> dict[str, int | None]:
    """Like `moments`, from the bytes of a data packet and its field headers."""
    places = _places(data[2], headers)
    return {source.clock: _decoded(source, data[begin:end]) for source, begin, end in places}


@lru_cache(maxsize=4096)
def _places(number: int, headers: bytes) -> tuple[tuple[_Source, int, int], ...]:
    """Returns where packets with these fields contain times: source, begin and end of each."""
    places: dict[str, tuple[int, _Source, int, int]] = {}
    at = 4
    for length, descriptor in zip(headers[::2], headers[1::2]):
        source = _source(number, descriptor)
        if source is not None and places.get(source.clock, (0x100,))[0] > descriptor:
            if length >= source.size + 2:
                places[source.clock] = (descriptor, source, at + 2, at + length)
        at += length
    return tuple(place[1:] for place in places.values())


@cache
def _source(set: int, descriptor: int) -> _Source | None:
    clock = clock_of(set, descriptor)
    if clock is None:
        return None
    from .reflection import info

    (kind,) = registry.types(set, descriptor)
    parts = [(p, n) for p in info(kind).parameters if (n := scale(p)) is not None]
    flags = dict.fromkeys(flag for p, _ in parts for flag in p.flags)
    scales = tuple((p.attribute, n) for p, n in parts)
    return _Source(clock, kind, scales, tuple(flags), _size(kind))


def _size(kind: type[Field]) -> int:
    """Returns the number of zero bytes that are needed to decode a field of this type."""
    for size in range(254):
        try:
            kind.decode(bytes(size))
            return size
        except DecodeError:
            continue
    return 254


def time_of(field: Field) -> int | None:
    """Returns the time in a field such as `shared.GpsTimestamp`, in the same form as `moments`;
    None if it is not valid. Raises ValueError if the field is not a packet's timestamp."""
    source = _source(field.packet_set or field.SETS[0], field.DESCRIPTOR)
    if source is None:
        raise ValueError(f"{field.NAME} does not contain the time of its packet")
    return _time(source, field)


def _decoded(source: _Source, data: bytes) -> int | None:
    try:
        return _time(source, source.kind.decode(data))
    except DecodeError:
        return None


def _time(source: _Source, value: Field) -> int | None:
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
    """Converts a time of a clock with a date to UTC; a leap second becomes the second after it."""
    begins, shifts = leaps(clock)
    return time + shifts[bisect_right(begins, time)]
