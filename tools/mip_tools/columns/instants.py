"""Assigns the fields of a log to the rows of a table: a row for each instant, or for each packet."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from .distinct import distinct, places_among
from .scan import Array
from .stamps import NONE

#: Packets with the same timestamp belong to one instant if they begin within this many bytes: a clock may restart.
TOGETHER = 1 << 16
_MOST = 1 << 32  # fields of one type in an instant


class Fields(NamedTuple):
    """The fields of one type."""

    offset: Array  # of their packets in the file
    time: Array  # of their packets, in nanoseconds; NONE for packets without a valid timestamp
    once: bool  # an instant has only one, because all its packets have the same


class Instants(NamedTuple):
    """Rows in the order of their first packets, and the rows of the fields of each type."""

    begin: Array  # for each row, the offset of the first packet of its instant
    kept: list[Array]  # for each type, the numbers of the fields that are in a row, …
    place: list[Array]  # … and their rows
    packets: Array  # the offsets of the packets, …
    first: Array  # … and, for each, the offset of the first packet of its instant


def assign(fields: Sequence[Fields], by: str) -> Instants:
    """Finds the rows of some types of fields. `by` is "time" or "packet"."""
    packets = distinct(*(f.offset for f in fields))
    packets_of_fields = [places_among(packets, f.offset) for f in fields]
    first = packets if by == "packet" else _first(packets, packets_of_fields, fields)
    begins = distinct(first)
    number = places_among(begins, first)
    places_of_fields = [number[which] for which in packets_of_fields]
    turns = [_turn(row) for row in places_of_fields]
    if not any(turn.any() for turn in turns):
        return Instants(begins, [np.arange(len(row)) for row in places_of_fields], places_of_fields, packets, first)
    kept, keys = [], []
    for f, row, turn in zip(fields, places_of_fields, turns):
        only = np.flatnonzero(turn == 0) if f.once and by == "time" else np.arange(len(row))
        kept.append(only)
        keys.append(row[only] * _MOST + turn[only])
    rows = distinct(*keys)
    return Instants(begins[rows // _MOST], kept, [places_among(rows, key) for key in keys], packets, first)


def _first(packets: Array, packets_of_fields: list[Array], fields: Sequence[Fields]) -> Array:
    """Returns, for each packet, the offset of the first packet of its instant. A packet without a timestamp is an
    instant by itself."""
    time = np.full(len(packets), NONE, np.int64)
    for which, f in zip(packets_of_fields, fields):
        time[which] = f.time
    stamped = np.flatnonzero(time != NONE)
    if (np.diff(time[stamped]) > 0).all():
        return packets
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
    """Groups sorted offsets that are near each other. Returns, for each, the first of its group."""
    first, at = places.copy(), 0
    while at < len(places):
        end = int(np.searchsorted(places, places[at] + TOGETHER, side="right"))
        first[at:end] = places[at]
        at = end
    return first


def _turn(row: Array) -> Array:
    """Numbers the fields within each row: 0 for the first, 1 for the second, …"""
    numbers = np.arange(len(row))
    if (row[1:] > row[:-1]).all():
        return np.zeros(len(row), np.int64)
    order = np.argsort(row, kind="stable")
    new = np.ones(len(row), bool)
    new[1:] = row[order[1:]] != row[order[:-1]]
    turn = np.empty(len(row), np.int64)
    turn[order] = numbers - np.maximum.accumulate(np.where(new, numbers, 0))
    return turn
