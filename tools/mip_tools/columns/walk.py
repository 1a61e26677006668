"""Finds the fields of the packets in a piece of a log, as far as they are well formed."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from . import native, scan
from .scan import HEADER, Array

#: Packets of one set and length are compared with the first of them as long as there are so many …
_MANY = 64
#: … and so often; the others are walked through field by field.
_LAYOUTS = 12


class Run(NamedTuple):
    """Fields of one set, descriptor and length, in the order of their packets."""

    set: int
    descriptor: int
    length: int  # of the data
    packet: Array  # numbers of the packets in the piece
    offset: int | Array  # of the data in the payload


def runs(data: Array, packets: scan.Found) -> list[Run]:
    """All fields of these packets."""
    if native.kernel is not None and (known := native.kernel.fields(data, packets.at)) is not None:
        return [Run(*fields) for fields in known]
    fields: list[Run] = []
    alone = np.ones(len(packets.at), bool)
    for group in packets.groups:
        alone[group.number] = False
        number, rows = group.number, group.rows
        for _ in range(_LAYOUTS):
            if len(number) < _MANY:
                break
            number, rows = _alike(group.key, number, rows, fields)
        alone[number] = True
    left = np.flatnonzero(alone)
    if len(left):
        _walk(data, packets.at, packets.end, left, fields)
    return fields


def _alike(key: int, number: Array, rows: Array, runs: list[Run]) -> tuple[Array, Array]:
    """Adds the fields of the packets that have the layout of the first one; returns the others."""
    fields, heads = _layout(rows[0, : HEADER + (key & 0xFF)].tobytes())
    same = np.ones(len(rows), bool)
    for place, byte in heads:
        same &= rows[:, place] == byte
    alike = same.all()
    these = number if alike else number[same]
    runs += [Run(key >> 8, d, size, these, offset) for d, size, offset in fields]
    if alike:
        return number[:0], rows[:0]
    np.logical_not(same, out=same)
    return number[same], rows[same]


def _layout(row: bytes) -> tuple[list[tuple[int, int, int]], list[tuple[int, int]]]:
    """Descriptor, size and offset of each field, and the bytes that tell this layout."""
    fields, heads = [], []
    at = HEADER
    while at < len(row):
        length = row[at]
        heads.append((at, length))
        if length < 2 or length > len(row) - at:
            break
        heads.append((at + 1, row[at + 1]))
        fields.append((row[at + 1], length - 2, at + 2 - HEADER))
        at += length
    return fields, heads


def _walk(data: Array, at: Array, end: Array, packet: Array, runs: list[Run]) -> None:
    """Adds the fields of these packets: the first ones of all, the second ones, …"""
    begin = at[packet]
    stop, place = end[packet] - 2, begin + HEADER
    seen: list[tuple[Array, Array, Array, Array]] = []
    while len(packet):
        length = data[place]
        whole = length >= 2
        whole &= length <= stop - place
        if not whole.all():
            packet, begin, stop, place, length = (values[whole] for values in (packet, begin, stop, place, length))
        descriptor = data[place + 1].astype(np.uint16)
        offset = (place + (2 - HEADER) - begin).astype(np.uint8)
        seen.append((packet, offset, descriptor << 8 | length, data[begin + 2]))
        place = place + length
    packet, offset, key, number = (np.concatenate(values) for values in zip(*seen))
    order = np.lexsort((offset, packet, key, number))
    packet, offset, key, number = packet[order], offset[order], key[order], number[order]
    new = key[1:] != key[:-1]
    new |= number[1:] != number[:-1]
    cuts = (np.flatnonzero(new) + 1).tolist()
    if len(key):
        for first, after in zip([0, *cuts], [*cuts, len(key)]):
            what = int(key[first])
            rows = slice(first, after)
            runs.append(Run(int(number[first]), what >> 8, (what & 255) - 2, packet[rows], offset[rows]))


def places(runs: list[Run], packets: int) -> tuple[Array, Array]:
    """Packet, and offset in its payload, of all fields of these runs, in the order of the log."""
    if len(runs) == 1:
        return runs[0].packet, _filled(runs[0], runs[0].offset)
    slot = np.zeros(packets, np.uint8)
    for run in runs:
        slot[run.packet.astype(np.intp, copy=False)] = run.offset  # much faster than indexes of 32 bits
    packet = np.flatnonzero(slot != 0)  # much faster than of numbers
    if len(packet) == sum(len(run.packet) for run in runs):  # no packet has two of them
        return packet, slot[packet]
    packet = np.concatenate([run.packet for run in runs])
    offset = np.concatenate([_filled(run, run.offset) for run in runs])
    order = np.lexsort((offset, packet))
    return packet[order], offset[order]


def _filled(run: Run, value: int | Array) -> Array:
    """One value for each row."""
    return np.full(len(run.packet), value, np.uint8) if isinstance(value, int) else value
