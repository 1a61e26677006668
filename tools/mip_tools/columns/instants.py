"""Assigns the fields of a log to the rows of a table: a row for each instant, or for each packet."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from .scan import Array
from .times import NONE

#: Packets with the same timestamp are of one instant if they begin within so many bytes: a clock may start again.
TOGETHER = 1 << 16
_MOST = 1 << 32  # fields of one type in an instant


class Fields(NamedTuple):
    """The fields of one type."""

    offset: Array  # of their packets in the file
    time: Array  # of their packets, in nanoseconds; NONE where these have no valid timestamp of their own
    once: bool  # an instant has one: those of further packets are the same


class Instants(NamedTuple):
    """Rows in the order of their first packets, and where the fields of each type are."""

    begin: Array  # of each row: where the first packet of its instant begins
    kept: list[Array]  # of each type, the numbers of the fields that have a place, …
    place: list[Array]  # … and their rows
    packets: Array  # where the packets begin, …
    first: Array  # … and where the first one of their instant does


def found(fields: Sequence[Fields], by: str) -> Instants:
    """The rows of some types of fields. `by` is "time" or "packet"."""
    packets = np.unique(np.concatenate([f.offset for f in fields]))
    first = packets if by == "packet" else _first(packets, fields)
    begins = np.unique(first)
    number = np.searchsorted(begins, first)
    kept, keys = [], []
    for f in fields:
        row = number[np.searchsorted(packets, f.offset)]
        turn = _turn(row)
        only = np.flatnonzero(turn == 0) if f.once and by == "time" else np.arange(len(row))
        kept.append(only)
        keys.append(row[only] * _MOST + turn[only])
    rows = np.unique(np.concatenate(keys))
    return Instants(begins[rows // _MOST], kept, [np.searchsorted(rows, key) for key in keys], packets, first)


def _first(packets: Array, fields: Sequence[Fields]) -> Array:
    """The offset of the first packet of the same instant. A packet without a timestamp is an instant by itself."""
    time = np.full(len(packets), NONE, np.int64)
    for f in fields:
        time[np.searchsorted(packets, f.offset)] = f.time
    stamped = np.flatnonzero(time != NONE)
    order = stamped[np.argsort(time[stamped], kind="stable")]
    when, where = time[order], packets[order]
    new = np.ones(len(order), bool)
    new[1:] = when[1:] != when[:-1]
    begin = np.flatnonzero(new)
    group = np.cumsum(new) - 1
    first = where[begin][group]
    if (where - first > TOGETHER).any():
        for a, b in zip(begin.tolist(), [*begin[1:].tolist(), len(order)]):
            first[a:b] = _near(where[a:b])
    all_first = packets.copy()
    all_first[order] = first
    return all_first


def _near(places: Array) -> Array:
    """For each of these places, which are sorted, the first of those that are near to each other."""
    first, at = places.copy(), 0
    while at < len(places):
        end = int(np.searchsorted(places, places[at] + TOGETHER, side="right"))
        first[at:end] = places[at]
        at = end
    return first


def _turn(row: Array) -> Array:
    """0 for the first field of a row, 1 for the second one, …"""
    numbers = np.arange(len(row))
    if (row[1:] > row[:-1]).all():
        return np.zeros(len(row), np.int64)
    order = np.argsort(row, kind="stable")
    new = np.ones(len(row), bool)
    new[1:] = row[order[1:]] != row[order[:-1]]
    turn = np.empty(len(row), np.int64)
    turn[order] = numbers - np.maximum.accumulate(np.where(new, numbers, 0))
    return turn
