"""Reads the timestamps of packets as they are."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from ..binding import CLOCKS, MOST, timestamps
from .column import Column
from .packets import Packets
from .scan import Array
from .stamps import NONE, Stamps


def raw(log: Packets, set_number: int, clock: str) -> Stamps:
    """Reads the timestamps of a set as they are."""
    if (set_number, clock) not in log.own_stamps:
        read(log, [set_number], [clock])
    return log.own_stamps[set_number, clock]


def read(log: Packets, sets: Iterable[int], clocks: Iterable[str] = tuple(CLOCKS)) -> None:
    """Reads the timestamps of several sets in one pass."""
    kinds = {(number, clock): timestamps.kinds(number, clock) for number in sets for clock in clocks}
    types = list(dict.fromkeys((number, kind) for (number, _), own in kinds.items() for kind in own))
    columns = {key: (column, nanoseconds(column)) for key, column in zip(types, log.columns(types)) if len(column)}
    for (number, clock), own in kinds.items():
        if (number, clock) not in log.own_stamps:
            log.own_stamps[number, clock] = _stamps([columns[number, k] for k in own if (number, k) in columns], clock)


def _stamps(columns_and_values: list[tuple[Column[Any], dict[str, Array]]], clock: str) -> Stamps:
    columns = [column for column, _ in columns_and_values]
    packet = _whole([column.packet for column in columns])
    value = _whole([values[clock] for _, values in columns_and_values])
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


def nanoseconds(column: Column[Any]) -> dict[str, Array]:
    """Adds the weeks, seconds and other parts of timestamps, in nanoseconds, for each clock of the field; in UTC if the
    clock has a date. NONE for times of another clock: one that is valid has a date, one that is not is the time of week
    of the device's clock."""
    clocks = timestamps.clocks_of(column.type.SETS[0], column.type.DESCRIPTOR)
    weeks, of_week = np.zeros((2, len(column)), np.int64)
    valid, absurd, has_weeks = np.ones(len(column), bool), np.zeros(len(column), bool), False
    for name, p in column.parameters.items():
        scale = timestamps.scale(p)
        if scale is None:
            continue
        if p.flags:
            valid &= column.valid(name)
        value, bad = _scaled(np.asarray(column[name]), scale)
        if scale == timestamps.WEEK and CLOCKS[clocks[0]]:
            weeks, has_weeks = weeks + value, True
            valid &= ~bad
        else:
            of_week += value
            absurd |= bad
    if has_weeks:
        valid &= weeks > 0
        absurd |= (of_week < 0) | (of_week > timestamps.WEEK)
    good = valid & ~absurd
    total = np.where(good, weeks + of_week, 0)
    total = np.where(good, clock_to_utc(total, clocks[0]) if CLOCKS[clocks[0]] else total, NONE)
    return {clocks[0]: total} | {clock: np.where(valid | absurd, NONE, of_week) for clock in clocks[1:]}


def _scaled(values: Array, scale: int) -> tuple[Array, Array]:
    """Multiplies numbers; returns also which are none, or too large."""
    if values.dtype.kind == "f":
        with np.errstate(all="ignore"):
            values = np.rint(values.astype(np.float64) * scale)
            return values.astype(np.int64), ~(np.abs(values) < MOST)
    most = (MOST - 1) // scale  # in integers, because a float would round it
    extremes = len(values) and (int(values.max()) > most or int(values.min()) < -most)
    bad = (values > most) | (values < -most) if extremes else np.zeros(len(values), bool)
    return values.astype(np.int64) * scale, bad


def clock_to_utc(value: Array, clock: str) -> Array:
    """Converts nanoseconds of a clock to nanoseconds since 1970 in UTC; a leap second counts as the next one."""
    begins, shifts = (np.array(numbers, np.int64) for numbers in timestamps.leaps(clock))
    first, last = np.searchsorted(begins, [value.min(initial=MOST), value.max(initial=-MOST)], side="right")
    which = first if first >= last else np.searchsorted(begins, value, side="right")  # few logs see a leap second
    return np.asarray(value + shifts[which])
