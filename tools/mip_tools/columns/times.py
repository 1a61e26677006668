"""Finds the times of rows from the timestamps of packets, by the clocks that the specification names."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from ..binding import CLOCKS, REACH
from . import timeline
from .column import Column
from .packets import Packets
from .raw_times import raw
from .scan import Array
from .stamps import LACKING, NONE, Stamps, Times


def row_times(log: Packets, column: Column[Any], clock: str | None) -> Times:
    """Finds the times of the rows of a column. Raises ValueError if there is no such clock."""
    if clock is not None and clock not in CLOCKS:
        raise ValueError(f"{clock!r} is not a clock; use one of {', '.join(CLOCKS)}")
    numbers = column.sets
    clock = clock or chosen_clock(log, numbers)
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


def exact_times(stamps: Stamps, packet: Array) -> Array:
    """Returns the times of packets that have a valid timestamp; NONE for other packets."""
    if np.array_equal(packet, stamps.packet):
        return stamps.value
    if not len(stamps.packet):
        return np.full(len(packet), NONE, np.int64)
    where = np.maximum(np.searchsorted(stamps.packet, packet, side="right") - 1, 0)
    return np.where(stamps.packet[where] == packet, stamps.value[where], NONE)


def dtype(clock: str) -> str:
    """Returns the NumPy type for times of a clock."""
    return "datetime64[ns]" if CLOCKS.get(clock) else "timedelta64[ns]"


def chosen_clock(log: Packets, sets: list[int]) -> str:
    """Chooses the clock for packets of these sets: that of dates if there is any date, else one without."""
    return timeline.of_log(log).clocks(sets).best


def of_packets(log: Packets, clock: str) -> Array:
    """Returns the valid timestamp of each packet of a log; NONE for packets without one."""
    values = np.full(log.packets, NONE, np.int64)
    for number in log.sets():
        if number >= 0x80:
            stamps_of_set = read_timestamps(log, number, clock)
            values[stamps_of_set.packet] = stamps_of_set.value
    return values


def steady_timestamps(log: Packets, set_number: int) -> Stamps | None:
    """Returns the timestamps of a set by the first of the log's clocks that the set has; None if it has none."""
    line = timeline.of_log(log)
    every = (read_timestamps(log, set_number, clock) for clock in line.clocks(line.sets).in_order)
    return next((stamps_of_set for stamps_of_set in every if stamps_of_set.some), None)


def at(log: Packets, set_number: int, clock: str, packet: Array, offset: Callable[[], Array]) -> tuple[Array, Array]:
    """Returns the times of some packets of a set, in their order, and whether each is in the packet itself."""
    stamps_of_set = stamps(log, set_number, clock, int(packet[0]) if len(packet) else None)
    if not len(stamps_of_set.packet) or not len(packet):
        return np.full(len(packet), NONE, np.int64), np.zeros(len(packet), bool)
    if np.array_equal(packet, stamps_of_set.packet):  # as in most logs
        return stamps_of_set.value.copy(), np.ones(len(packet), bool)
    first = int(stamps_of_set.packet[0])
    inside = int(packet[0]) >= first and int(packet[-1]) <= int(stamps_of_set.packet[-1])
    if inside and len(stamps_of_set.by_packet) < 16 * len(packet):
        values = stamps_of_set.by_packet[packet - first if first else packet]
        own = values != LACKING
        if own.all():
            return values, own
    where = np.searchsorted(stamps_of_set.packet, packet, side="right") - 1
    values, own = stamps_of_set.value[where], stamps_of_set.packet[where] == packet
    missing = where < 0
    missing |= offset() - stamps_of_set.offset[where] > REACH
    values[missing] = NONE
    own &= where >= 0
    return values, own


def stamps(log: Packets, set_number: int, clock: str, first: int | None = None) -> Stamps:
    """Returns the timestamps of a set. They include those shortly before a part of a log if the first packet of
    interest precedes all timestamps in the part."""
    own = read_timestamps(log, set_number, clock)
    if first is not None and len(own.packet) and own.packet[0] <= first:
        return own
    before = log.before(REACH)
    if before is None:
        return own
    if (set_number, clock) not in log.stamps:
        earlier = read_timestamps(before, set_number, clock)
        log.stamps[set_number, clock] = Stamps(
            np.concatenate((earlier.packet - before.packets, own.packet)),
            np.concatenate((earlier.value, own.value)),
            lambda: np.concatenate((earlier.offset, own.offset)),
        )
    return log.stamps[set_number, clock]


def read_timestamps(log: Packets, set_number: int, clock: str) -> Stamps:
    """Returns the timestamps of a set in this part of a log alone. The device's clock continues when it synchronizes;
    a log in which all times have a date lacks it."""
    if clock != timeline.DEVICE:
        return raw(log, set_number, clock)
    key = set_number, "joined"
    if key not in log.own_stamps:
        line = timeline.of_log(log)
        if any(times_of_set.alone.get(clock) for times_of_set in line.sets.values()):
            log.own_stamps[key] = line.stamps(log, set_number)
        else:
            log.own_stamps[key] = Stamps(np.zeros(0, np.int64), np.zeros(0, np.int64), lambda: np.zeros(0, np.int64))
    return log.own_stamps[key]
