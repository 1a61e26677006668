"""Finds the times of rows from the timestamps of packets, by the clocks that the specification names."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..binding import CLOCKS, MOST, REACH, SETS, timestamps
from .scan import Array

if TYPE_CHECKING:
    from .column import Column
    from .log import Log

NONE = np.iinfo(np.int64).min  # NaT in NumPy
_LACKING = NONE + 1


class Times(NamedTuple):
    """The time of each row."""

    #: The clock; "" if the log has no timestamp of these sets.
    clock: str
    #: `datetime64[ns]` in UTC for a clock with a date, otherwise `timedelta64[ns]` since its start. NaT
    #: if the time is unknown or not valid.
    values: Array
    #: True for the timestamp of the packet itself, False for the last one before it in a packet of
    #: the same set, up to `REACH` bytes away.
    own: Array


class Stamps:
    """The first timestamp of each packet of a set that has one."""

    def __init__(self, packet: Array, value: Array, offset: Callable[[], Array]) -> None:
        self.packet = packet  # packet numbers; negative for packets before a part of a log
        self.value = value  # nanoseconds
        self._offset = offset
        #: Is any timestamp valid?
        self.some = bool(len(value)) and bool((value != NONE).any())

    @cached_property
    def offset(self) -> Array:
        """The offsets of the packets in the file."""
        return self._offset()

    @cached_property
    def by_packet(self) -> Array:
        """The value of each packet from the first to the last one; `_LACKING` for packets without one."""
        table = np.full(int(self.packet[-1] - self.packet[0]) + 1, _LACKING, np.int64)
        table[self.packet - self.packet[0]] = self.value
        return table


def of(log: Log, column: Column[Any], clock: str | None) -> Times:
    """Finds the times of the rows of a column. Raises ValueError if there is no such clock."""
    if clock is not None and clock not in CLOCKS:
        raise ValueError(f"{clock!r} is not a clock; use one of {', '.join(CLOCKS)}")
    numbers = column.sets
    clock = clock or chosen(log, numbers)
    if len(numbers) == 1 and clock:
        values, own = at(log, numbers[0], clock, column.packet, lambda: column.offset)
        return Times(clock, values.view(dtype(clock)), own)
    values = np.full(len(column), NONE, np.int64)
    own = np.zeros(len(column), bool)
    for number in numbers if clock else ():
        rows = np.flatnonzero(column.set == number)
        part = at(log, number, clock, column.packet[rows], partial(column.offset.take, rows))
        values[rows], own[rows] = part
    return Times(clock, values.view(dtype(clock)), own)


def merged(log: Log, column: Column[Any], clock: str) -> tuple[Array, dict[str, str]]:
    """Returns the times of the packets of a column in nanoseconds, NONE for packets without a timestamp.

    The times of a set without this clock are converted from another clock, using packets that
    have both; the second result has the name of the set and of that clock.
    """
    total = np.full(len(column), NONE, np.int64)
    converted = {}
    for number in column.sets:
        rows = np.flatnonzero(column.set == number)
        own = read(log, number, clock)
        if own.some:
            total[rows] = exact(own, column.packet[rows])
            continue
        for other in CLOCKS:
            pairs = _pairs(log, other, clock) if read(log, number, other).some else None
            if pairs is not None:
                total[rows] = _converted(exact(read(log, number, other), column.packet[rows]), *pairs)
                converted[SETS[number][0] if number in SETS else f"0x{number:02X}"] = other
                break
    return total, converted


def exact(known: Stamps, packet: Array) -> Array:
    """Returns the times of packets that have a valid timestamp; NONE for other packets."""
    if np.array_equal(packet, known.packet):
        return known.value
    if not len(known.packet):
        return np.full(len(packet), NONE, np.int64)
    where = np.maximum(np.searchsorted(known.packet, packet, side="right") - 1, 0)
    return np.where(known.packet[where] == packet, known.value[where], NONE)


def _pairs(log: Log, other: str, clock: str) -> tuple[Array, Array] | None:
    """Returns the times, by both clocks, of packets that have both; None if there are none."""
    found = []
    for number in (n for n in log.sets() if n >= 0x80):
        if not timestamps.kinds(number, other) or not timestamps.kinds(number, clock):
            continue
        first, second = read(log, number, other), read(log, number, clock)
        if first.some and second.some:
            _, a, b = np.intersect1d(first.packet, second.packet, return_indices=True)
            both = np.stack((first.value[a], second.value[b]))
            found.append(both[:, (both != NONE).all(axis=0)])
    pairs = np.concatenate(found, axis=1) if found else np.zeros((2, 0), np.int64)
    pairs = pairs[:, np.unique(pairs[0], return_index=True)[1]]
    return (pairs[0], pairs[1]) if pairs.shape[1] else None


def _converted(time: Array, other: Array, clock: Array) -> Array:
    """Converts times of one clock to another. Before the first and after the last pair, the difference is constant."""
    begin = int(clock[0] - other[0])
    more = np.interp(time.astype(np.float64), other.astype(np.float64), (clock - other - begin).astype(np.float64))
    return np.where(time == NONE, NONE, time + begin + np.rint(more).astype(np.int64))


def dtype(clock: str) -> str:
    """Returns the NumPy type for times of a clock."""
    return "datetime64[ns]" if CLOCKS.get(clock) else "timedelta64[ns]"


def chosen(log: Log, sets: list[int]) -> str:
    """Chooses the first clock with a valid timestamp in packets of each of these sets, else of any of them."""
    has = {}
    for clock in CLOCKS:
        has[clock] = [stamps(log, number, clock).some for number in sets]
        if has[clock] and all(has[clock]):
            break  # no other clock can be better
    every = [clock for clock, present in has.items() if present and all(present)]
    return next(iter([*every, *(clock for clock, present in has.items() if any(present)), ""]))


def best(parts: Iterable[Log]) -> str | None:
    """Finds the first clock that has a valid timestamp in a log. Reads no more parts than necessary."""
    seen: set[str] = set()
    for part in parts:
        sets = [number for number in part.sets() if number >= 0x80]
        seen.update(clock for clock in CLOCKS if any(read(part, number, clock).some for number in sets))
        if next(iter(CLOCKS), None) in seen:
            break
    return next((clock for clock in CLOCKS if clock in seen), None)


def of_packets(log: Log, clock: str) -> Array:
    """Returns the valid timestamp of each packet of a log; NONE for packets without one."""
    values = np.full(log.packets, NONE, np.int64)
    for number in log.sets():
        if number >= 0x80:
            known = read(log, number, clock)
            values[known.packet] = known.value
    return values


def rate(log: Log, set: int, count: int, first: int, last: int) -> float | None:
    """Computes the rate of a field in Hz, by the steadiest clock, which is the device's own if the log has it."""
    for clock in reversed(CLOCKS):
        known = stamps(log, set, clock)
        if len(known.packet):
            where = np.searchsorted(known.packet, [first, last], side="right") - 1
            if where[0] >= 0:
                begin, end = (int(value) for value in known.value[where])
                if begin != NONE and end > begin:
                    return (count - 1) / (end - begin) * 1e9
    return None


def at(log: Log, set: int, clock: str, packet: Array, offset: Callable[[], Array]) -> tuple[Array, Array]:
    """Returns the times of some packets of a set, in their order, and whether each is in the packet itself."""
    known = stamps(log, set, clock, int(packet[0]) if len(packet) else None)
    if not len(known.packet) or not len(packet):
        return np.full(len(packet), NONE, np.int64), np.zeros(len(packet), bool)
    if np.array_equal(packet, known.packet):  # as in most logs
        return known.value.copy(), np.ones(len(packet), bool)
    first = int(known.packet[0])
    inside = int(packet[0]) >= first and int(packet[-1]) <= int(known.packet[-1])
    if inside and len(known.by_packet) < 16 * len(packet):
        values = known.by_packet[packet - first if first else packet]
        own = values != _LACKING
        if own.all():
            return values, own
    where = np.searchsorted(known.packet, packet, side="right") - 1
    values, own = known.value[where], known.packet[where] == packet
    missing = where < 0
    missing |= offset() - known.offset[where] > REACH
    values[missing] = NONE
    own &= where >= 0
    return values, own


def stamps(log: Log, set: int, clock: str, first: int | None = None) -> Stamps:
    """Returns the timestamps of a set. They include those shortly before a part of a log if the first packet of
    interest precedes all timestamps in the part."""
    own = read(log, set, clock)
    if first is not None and len(own.packet) and own.packet[0] <= first:
        return own
    before = log.before(REACH)
    if before is None:
        return own
    if (set, clock) not in log.stamps:
        earlier = read(before, set, clock)
        log.stamps[set, clock] = Stamps(
            np.concatenate((earlier.packet - before.packets, own.packet)),
            np.concatenate((earlier.value, own.value)),
            lambda: np.concatenate((earlier.offset, own.offset)),
        )
    return log.stamps[set, clock]


def read(log: Log, set: int, clock: str) -> Stamps:
    """Reads the timestamps of a set in this part of a log alone."""
    if (set, clock) not in log.own_stamps:
        log.own_stamps[set, clock] = _read(log, set, clock)
    return log.own_stamps[set, clock]


def _read(log: Log, set: int, clock: str) -> Stamps:
    kinds = timestamps.kinds(set, clock)
    columns = [c for c in log.columns(kinds, set) if len(c)] if kinds else []
    packet = _whole([column.packet for column in columns])
    value = _whole([nanoseconds(column, clock) for column in columns])
    places = [column.where.offset for column in columns]  # storing the columns would make a cycle with the log
    if (packet[1:] > packet[:-1]).all():
        return Stamps(packet, value, lambda: _whole([offset() for offset in places]))
    order = np.argsort(packet, kind="stable")  # of several timestamps in a packet, the lowest descriptor is first
    first = np.ones(len(packet), bool)
    first[1:] = packet[order[1:]] != packet[order[:-1]]
    order = order[first]
    return Stamps(packet[order], value[order], lambda: _whole([offset() for offset in places])[order])


def _whole(parts: list[Array]) -> Array:
    return parts[0] if len(parts) == 1 else np.concatenate([np.zeros(0, np.int64), *parts])


def nanoseconds(column: Column[Any], clock: str) -> Array:
    """Adds the weeks, seconds and other parts of timestamps, in nanoseconds; in UTC if the clock has a date."""
    total = np.zeros(len(column), np.int64)
    bad = np.zeros(len(column), bool)
    for name, p in column.parameters.items():
        scale = timestamps.scale(p)
        if scale is None:
            continue
        values = np.asarray(column[name])
        with np.errstate(all="ignore"):
            if values.dtype.kind == "f":
                values = np.rint(values.astype(np.float64) * scale)
                bad |= ~(np.abs(values) < MOST)
                total += values.astype(np.int64)
            else:
                most = (MOST - 1) // scale  # in integers, because a float would round it
                if len(values) and (int(values.max()) > most or int(values.min()) < -most):
                    bad |= (values > most) | (values < -most)
                total += values.astype(np.int64) * scale
        if p.flags:
            bad |= ~column.valid(name)
    if CLOCKS[clock]:
        total[bad] = 0
        total = utc(total, clock)
    total[bad] = NONE
    return total


def utc(value: Array, clock: str) -> Array:
    """Converts nanoseconds of a clock to nanoseconds since 1970 in UTC; a leap second counts as the next one."""
    begins, shifts = (np.array(numbers, np.int64) for numbers in timestamps.leaps(clock))
    return np.asarray(value + shifts[np.searchsorted(begins, value, side="right")])
