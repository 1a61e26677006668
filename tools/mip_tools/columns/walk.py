"""Finds the well-formed fields of the packets in a piece of a log."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any, NamedTuple, TypeVar

import numpy as np

from . import native
from .scan import HEADER, Array

T = TypeVar("T")


class Run(NamedTuple):
    """Fields of one set, descriptor and length, in the order of their packets."""

    set: int
    descriptor: int
    length: int  # of the data
    packet: Array  # numbers of the packets in the piece
    offset: int | Array  # of the data in the payload


def find_runs(data: Array, at: Array, sets: Array) -> list[Run]:
    """Finds all fields of packets that begin at these places, given their descriptor sets."""
    if native.kernel is not None and (rows := native.kernel.fields(data, at)) is not None:
        return [Run(*fields) for fields in rows]
    keys = [sets.astype(np.uint16), *_fields(data, at)]
    mixed = keys[0].copy()
    for key in keys[1:]:
        mixed *= 31
        mixed += key
    order = np.argsort(mixed, kind="stable")  # much faster than sorting by all keys
    keys = [key[order] for key in keys]
    new = np.ones(len(order), bool)  # the first packet of a layout; two layouts may have the same sum
    new[1:] = False
    for key in keys:
        new[1:] |= key[1:] != key[:-1]
    first = np.flatnonzero(new)
    alike = zip(first.tolist(), [*first[1:].tolist(), len(order)], *(key[first].tolist() for key in keys))
    return [run for begin, stop, *layout in alike for run in _layout(order[begin:stop], *layout)]


def _layout(packet: Array, number: int, *keys: int) -> Iterator[Run]:
    """Yields the fields of packets of one set that all have the same fields."""
    offset = 2
    for key in keys:
        if not key:
            break
        yield Run(number, key >> 8, (key & 255) - 2, packet, offset)
        offset += key & 255


def _fields(data: Array, at: Array) -> Iterator[Array]:
    """Yields descriptor and length of the first field of each packet, then of the second, …; 0 if there is none."""
    packet: Any = slice(None)
    place, left = at + HEADER, data[at + 3]
    while True:
        length = data[place]
        whole = length <= left
        whole &= length > 1
        more = np.flatnonzero(whole)
        if not len(more):
            return
        if 2 * len(more) < len(whole):  # drops packets without further fields, as soon as that is worth it
            packet = np.arange(len(at))[packet][more]
            place, left, length = place[more], left[more], length[more]
        else:
            left *= whole
            length *= whole
        descriptor = data[place + 1].astype(np.uint16)
        descriptor *= length > 0
        key = np.zeros(len(at), np.uint16)
        key[packet] = descriptor << 8 | length
        yield key
        place += length
        left -= length


def packets_and_offsets(runs: list[Run], packets: int) -> tuple[Array, Array]:
    """Returns the packets of all fields of these runs, and the offsets in their payloads, in the order of the log."""
    if len(runs) == 1:
        return runs[0].packet, _filled(runs[0], runs[0].offset)
    slot = np.zeros(packets, np.uint8)
    for run in runs:
        slot[run.packet.astype(np.intp, copy=False)] = run.offset  # much faster than indexes of 32 bits
    packet = np.flatnonzero(slot != 0)  # much faster than for numbers
    if len(packet) == sum(len(run.packet) for run in runs):  # no packet has two of them
        return packet, slot[packet]
    packet = np.concatenate([run.packet for run in runs])
    offset = np.concatenate([_filled(run, run.offset) for run in runs])
    order = np.lexsort((offset, packet))
    return packet[order], offset[order]


def in_order(
    field_runs: Iterable[Run], made: Callable[[int, int, list[Run]], tuple[Array, Array, list[T]]]
) -> tuple[Array, list[T], Array]:
    """Sorts rows into the order of the log. Returns their packets, the rows, and their order.

    `made` is called once for each set and descriptor, with their runs. It returns the packets of its rows, their
    offsets in the payloads, which determine the order within a packet, and the rows.
    """
    alike: dict[tuple[int, int], list[Run]] = {}
    for run in field_runs:
        alike.setdefault((run.set, run.descriptor), []).append(run)
    packets, offsets = [np.zeros(0, np.int64)], [np.zeros(0, np.uint8)]
    rows: list[T] = []
    for key, runs in alike.items():
        packet, offset, more = made(*key, runs)
        packets.append(packet)
        offsets.append(offset)
        rows += more
    packet = np.concatenate(packets)
    order = np.lexsort((np.concatenate(offsets), packet))
    return packet[order], [rows[row] for row in order.tolist()], order


def _filled(run: Run, value: int | Array) -> Array:
    """Repeats one value for each row."""
    return np.full(len(run.packet), value, np.uint8) if isinstance(value, int) else value
