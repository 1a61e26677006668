"""Interprets timestamps, both of single packets and of columns."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable
from datetime import datetime, timedelta
from functools import cache, lru_cache
from typing import NamedTuple

from . import registry
from ._clocks import CLOCKS, LEAP_SECONDS, TIMESTAMPS, UNIT_KEYS
from .exceptions import DecodeError
from .field import Field
from .packet import Packet
from .parameter import Parameter

SECOND = 1_000_000_000
#: A packet without a timestamp may use one of the same set up to this many bytes before it. The
#: distance is in bytes so that the result does not depend on how a file is split.
REACH = 1 << 20
#: Each part of a timestamp must be below this many nanoseconds, positive or negative, so that the
#: sum of two parts fits into a signed 64-bit integer.
MOST = 4 * 10**18

#: Nanoseconds of a week. A time without a date does not count them.
WEEK = 604_800 * SECOND
_UNITS = {"week": WEEK, "s": SECOND, "ms": 1_000_000, "us": 1000, "ns": 1}
_UNIX = datetime(1970, 1, 1)


def scale(parameter: Parameter) -> int | None:
    """Returns the nanoseconds in the parameter's unit; None if it is not a unit of time. A
    timestamp is the sum of all parameters with one."""
    if len(parameter.units) != 1:
        return None
    unit = parameter.units[0]
    return _UNITS.get(UNIT_KEYS.get(unit, unit))


@cache
def clocks_of(set: int, descriptor: int) -> tuple[str, ...]:
    """Returns the clocks whose time the field can contain, if the field is its packet's timestamp:
    the second has the time of week when it is not valid as a date."""
    kinds = registry.types(set, descriptor)
    if set < 0x80 or len(kinds) != 1:
        return ()
    return TIMESTAMPS.get((getattr(kinds[0], "SET", set), descriptor), ())


@cache
def kinds(set: int, clock: str) -> tuple[type[Field], ...]:
    """Returns the fields of a set that contain the time of a clock, in order of precedence."""
    known = sorted({d for _, d in TIMESTAMPS if clock in clocks_of(set, d)})
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


class _Part(NamedTuple):
    parameter: Parameter
    scale: int  # nanoseconds
    undated: bool  # does it count in a time without a date?


class _Source(NamedTuple):
    clock: str  # the clock of a time that is valid
    other: str  # the clock of a time of week that is not; "" if there is none
    kind: type[Field]
    parts: tuple[_Part, ...]
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


def moments(packet: Packet, device: str | None = None) -> dict[str, int | None]:
    """Returns the times in a packet by clock, in nanoseconds; None for a time that is not valid.

    They count from 1970 in UTC if the clock has a date, otherwise from the clock's start. A time of
    week that is not valid is that of the clock "device". If several fields contain the time of one
    clock, the one with the lowest descriptor counts. `device` is the device's id; without it, the
    flags are read as `Parameter.recognized` says.
    """
    data = bytes(packet)
    return moments_of(data, headers(data), device) if packet.set >= 0x80 else {}


def moments_of(data: bytes, headers: bytes, device: str | None = None) -> dict[str, int | None]:
    """Like `moments`, from the bytes of a data packet and its field headers."""
    moments: dict[str, int | None] = {}
    for source, begin, end in _places(data[2], headers):
        try:
            value = source.kind.decode(data[begin:end])
        except DecodeError:
            moments.setdefault(source.clock, None)
            continue
        for clock, time in _times(source, value, device).items():
            moments.setdefault(clock, time)
    return moments


@lru_cache(maxsize=4096)
def _places(number: int, headers: bytes) -> tuple[tuple[_Source, int, int], ...]:
    """Returns where packets with these fields contain times: source, begin and end of each, in the
    order of their descriptors."""
    places: dict[int, tuple[_Source, int, int]] = {}
    at = 4
    for length, descriptor in zip(headers[::2], headers[1::2]):
        source = _source(number, descriptor)
        if source is not None and length >= source.size + 2:
            places.setdefault(descriptor, (source, at + 2, at + length))
        at += length
    return tuple(place for _, place in sorted(places.items()))


@cache
def _source(set: int, descriptor: int) -> _Source | None:
    clocks = clocks_of(set, descriptor)
    if not clocks:
        return None
    (kind,) = registry.types(set, descriptor)
    scales = ((p, scale(p)) for p in kind.INFO.parameters)
    dated = CLOCKS[clocks[0]] is not None
    parts = (_Part(p, n, not dated or n != WEEK) for p, n in scales if n is not None)
    return _Source(clocks[0], clocks[1] if clocks[1:] else "", kind, tuple(parts), _size(kind))


def _size(kind: type[Field]) -> int:
    """Returns the number of zero bytes that are needed to decode a field of this type."""
    for size in range(254):
        try:
            kind.decode(bytes(size))
            return size
        except DecodeError:
            continue
    return 254


def time_of(field: Field, device: str | None = None) -> int | None:
    """Returns the time in a field such as `shared.GpsTimestamp`, in the same form as `moments`;
    None if it is not valid. Raises ValueError if the field is not a packet's timestamp."""
    source = _source(field.packet_set or field.SETS[0], field.DESCRIPTOR)
    if source is None:
        raise ValueError(f"{field.NAME} does not contain the time of its packet")
    return _times(source, field, device)[source.clock]


def _times(source: _Source, value: Field, device: str | None) -> dict[str, int | None]:
    weeks = not all(part.undated for part in source.parts)
    of_week = _sum((part for part in source.parts if part.undated), value)
    if weeks and of_week is not None and not 0 <= of_week <= WEEK:
        of_week = None
    total = None if of_week is None else _sum(source.parts, value)
    if total is not None and of_week is not None and (total > of_week or not weeks):  # not week 0
        if all(_is_valid(part.parameter, value, device) for part in source.parts):
            return {source.clock: utc(source.clock, total) if CLOCKS[source.clock] else total}
    return {source.clock: None, **({source.other: of_week} if source.other else {})}


def _is_valid(p: Parameter, value: Field, device: str | None) -> bool:
    for flag in p.flags_of(value, device):
        if not flag.holds(int(getattr(value, flag.attribute))):
            return False
    return True


def _sum(parts: Iterable[_Part], value: Field) -> int | None:
    total = 0
    for p, scale, _ in parts:
        number = getattr(value, p.attribute)
        if not -MOST < number * scale < MOST:  # NaN is not, either
            return None
        total += round(number * scale)
    return total


def utc(clock: str, time: int) -> int:
    """Converts a time of a clock with a date to UTC; a leap second becomes the second after it."""
    begins, shifts = leaps(clock)
    return time + shifts[bisect_right(begins, time)]
