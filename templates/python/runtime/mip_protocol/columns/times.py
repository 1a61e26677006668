"""The time of rows: by the timestamps of packets, in the clocks that the specification names."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, partial
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from .. import registry
from .._clocks import CLOCKS, LEAP_SECONDS, TIMESTAMPS
from ..field import Field
from .scan import Array

if TYPE_CHECKING:
    from .column import Column
    from .log import Log

#: How far before a packet without a timestamp the last one of its set is looked for, in bytes. The
#: same for every way of cutting a file.
REACH = 1 << 20

_NONE = np.iinfo(np.int64).min  # what NumPy calls NaT
_UNITS = {"week": 604_800_000_000_000, "s": 1_000_000_000, "ms": 1_000_000, "us": 1000, "ns": 1}
_MOST = 4e18  # nanoseconds of which two fit into 64 bits


class Times(NamedTuple):
    """The time of each row."""

    #: The clock. "" if the log has no timestamp of the sets at hand.
    clock: str
    #: `datetime64[ns]`, UTC, of a clock that has a date; of another one `timedelta64[ns]` since its
    #: start. NaT where it is not known or not valid.
    values: Array
    #: True where it is the timestamp of the packet itself, False where it is the last one before it
    #: in a packet of the same set, up to `REACH` bytes away.
    own: Array


class Stamps(NamedTuple):
    """The first timestamp of each packet that has one."""

    packet: Array
    offset: Array
    value: Array  # nanoseconds
    some: bool  # is any of them valid?


def of(log: Log, column: Column[Any], clock: str | None) -> Times:
    """The times of the rows of a column. Raises ValueError if there is no such clock."""
    if clock is not None and clock not in CLOCKS:
        raise ValueError(f"{clock!r} is not a clock; one of {', '.join(CLOCKS)} is")
    numbers = column.sets
    clock = clock or chosen(log, numbers)
    if len(numbers) == 1 and clock:
        values, own = at(log, numbers[0], clock, column.packet, lambda: column.offset)
        return Times(clock, values.view(dtype(clock)), own)
    values = np.full(len(column), _NONE, np.int64)
    own = np.zeros(len(column), bool)
    for number in numbers if clock else ():
        rows = np.flatnonzero(column.set == number)
        part = at(log, number, clock, column.packet[rows], partial(column.offset.take, rows))
        values[rows], own[rows] = part
    return Times(clock, values.view(dtype(clock)), own)


def dtype(clock: str) -> str:
    """The type of times of a clock."""
    return "datetime64[ns]" if CLOCKS.get(clock) else "timedelta64[ns]"


def chosen(log: Log, sets: list[int]) -> str:
    """The first clock that has a valid timestamp in packets of each of these sets, else of any."""
    has = {clock: [stamps(log, number, clock).some for number in sets] for clock in CLOCKS}
    every = [clock for clock, found in has.items() if found and all(found)]
    return next(iter([*every, *(clock for clock, found in has.items() if any(found)), ""]))


def rate(log: Log, set: int, count: int, first: int, last: int) -> float | None:
    """How often a field comes, in Hz, by the steadiest clock: that of the device, if it is there."""
    for clock in reversed(CLOCKS):
        known = stamps(log, set, clock)
        if len(known.packet):
            where = np.searchsorted(known.packet, [first, last], side="right") - 1
            if where[0] >= 0:
                begin, end = (int(value) for value in known.value[where])
                if begin != _NONE and end > begin:
                    return (count - 1) / (end - begin) * 1e9
    return None


def at(
    log: Log, set: int, clock: str, packet: Array, offset: Callable[[], Array]
) -> tuple[Array, Array]:
    """The times of some packets of a set, in their order, and whether these are their own."""
    known = stamps(log, set, clock)
    if not len(known.packet) or not len(packet):
        return np.full(len(packet), _NONE, np.int64), np.zeros(len(packet), bool)
    if len(known.packet) == len(packet) and (known.packet == packet).all():
        return known.value, np.ones(len(packet), bool)
    where = _before(known.packet, packet)
    own = known.packet[where] == packet
    values = known.value[where]
    if not own.all():
        missing = where < 0
        missing |= offset() - known.offset[where] > REACH
        values[missing] = _NONE
        own &= where >= 0
    return values, own


def _before(known: Array, packet: Array) -> Array:
    """The number of the last of some sorted numbers that is not above each of others; -1 for none."""
    low, high = int(min(known[0], packet[0])), int(max(known[-1], packet[-1]))
    if high - low > 16 * len(packet):
        return np.asarray(np.searchsorted(known, packet, side="right") - 1)
    steps = np.zeros(high - low + 1, np.int64)
    steps[known - low] = 1
    return np.asarray(np.cumsum(steps)[packet - low] - 1)


def stamps(log: Log, set: int, clock: str) -> Stamps:
    """The timestamps of a set, of packets shortly before a part of a log too."""
    if (set, clock) not in log.stamps:
        log.stamps[set, clock] = _joined(log, set, clock)
    return log.stamps[set, clock]


def _joined(log: Log, set: int, clock: str) -> Stamps:
    own = _read(log, set, clock)
    before = log.before(REACH)
    if before is None:
        return own
    earlier = _read(before, set, clock)
    return Stamps(
        np.concatenate((earlier.packet - before.packets, own.packet)),
        np.concatenate((earlier.offset, own.offset)),
        np.concatenate((earlier.value, own.value)),
        own.some,
    )


def _read(log: Log, set: int, clock: str) -> Stamps:
    columns = log.columns(list(_kinds(set, clock)), set)
    columns = [column for column in columns if len(column)]
    if not columns:
        nothing = np.zeros(0, np.int64)
        return Stamps(nothing, nothing, nothing, False)
    packet, offset, value = (
        parts[0] if len(parts) == 1 else np.concatenate(parts)
        for parts in zip(*((c.packet, c.offset, nanoseconds(c, clock)) for c in columns))
    )
    if not (packet[1:] > packet[:-1]).all():  # of several in a packet the first by descriptor
        order = np.argsort(packet, kind="stable")
        packet, offset, value = packet[order], offset[order], value[order]
        first = np.ones(len(packet), bool)
        first[1:] = packet[1:] != packet[:-1]
        packet, offset, value = packet[first], offset[first], value[first]
    return Stamps(packet, offset, value, bool((value != _NONE).any()))


def _kinds(set: int, clock: str) -> list[type[Field]]:
    """The types of a set that have the time of a clock."""
    own = [d for (s, d), c in TIMESTAMPS.items() if c == clock and s in (set, registry.SHARED_SET)]
    return [kind for d in sorted(dict.fromkeys(own)) for kind in registry.types(set, d)]


def nanoseconds(column: Column[Any], clock: str) -> Array:
    """The sum of what a timestamp says in weeks, seconds, nanoseconds; UTC if the clock has a date."""
    total = np.zeros(len(column), np.int64)
    bad = np.zeros(len(column), bool)
    for name, p in column.parameters.items():
        scale = _UNITS.get(p.units[0]) if len(p.units) == 1 else None
        if scale is None:
            continue
        values = np.asarray(column[name])
        with np.errstate(all="ignore"):
            if values.dtype.kind == "f":
                values = np.rint(values * scale)
                bad |= ~(np.abs(values) < _MOST)
                total += values.astype(np.int64)
            else:
                if len(values) and max(int(values.max()), -int(values.min())) * scale >= _MOST:
                    bad |= np.abs(values.astype(np.float64)) * scale >= _MOST
                total += values.astype(np.int64) * scale
        if p.valid:
            bad |= ~column.valid(name)
    if CLOCKS[clock]:
        total[bad] = 0
        total = utc(total, clock)
    total[bad] = _NONE
    return total


def utc(value: Array, clock: str) -> Array:
    """Nanoseconds of a clock as those since 1970 in UTC; during a leap second the next one begins."""
    epoch, begins, seconds = _leaps(clock)
    leap = seconds[np.searchsorted(begins, value, side="right")]
    return np.asarray(value - leap * 1_000_000_000 + epoch)


@cache
def _leaps(clock: str) -> tuple[int, Array, Array]:
    """The epoch of a clock since 1970, when leap seconds came, by the clock, and how many there are."""
    epoch = _date(CLOCKS[clock] or "1970-01-01")
    begins = [_date(day) - epoch + ahead * 1_000_000_000 for day, ahead in LEAP_SECONDS]
    return epoch, np.array(begins, np.int64), np.array([0, *(n for _, n in LEAP_SECONDS)], np.int64)


def _date(day: str) -> int:
    return int(np.datetime64(day, "ns").astype(np.int64))
