"""Finds the packets in a piece of a log: exactly those that `Parser` finds."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from ..binding import MAX_PAYLOAD, OVERHEAD, SYNC
from . import native
from .native import Array as Array

#: Bytes of a packet before its payload.
HEADER = OVERHEAD - 2
#: How far a packet can reach beyond the byte it begins with.
REACH = MAX_PAYLOAD + OVERHEAD - 1
#: Bytes behind a piece that must be there, for packets and for whole words of the last of them.
AHEAD = REACH + 8

_PART = 1 << 18  # bytes that are searched at once: what is computed of them stays in the cache
_ROWS = 1 << 14  # packets whose checksum is computed at once, for the same reason
_MANY = 64  # packets of one set and length that are worth a group of their own
_NONE = np.zeros(0, np.intp)


class Group(NamedTuple):
    """Packets of one set and length."""

    key: int  # the set, and the length of the payload
    number: Array  # in the order of the piece
    rows: Array  # their bytes without the checksum, and a few more


class Found(NamedTuple):
    """Packets in a piece."""

    at: Array  # where they begin
    end: Array
    groups: list[Group]  # those of which there are many alike; none from compiled code


def packets(data: Array, first: int, limit: int, length: int) -> Found:
    """The packets that begin in `first` … `limit`.

    Of `data`, `length` bytes belong to the log; at least 8 more must be there.
    """
    if native.kernel is not None:
        return Found(*native.kernel.packets(data, first, limit, length, False), [])
    at, end, key = _forms(data, first, limit, length)
    right, groups = _checked(data, at, end, key)
    if not right.all():
        at, end, groups = _only(right, at, end, groups)
    if (at[1:] < end[:-1]).any():
        at, end, groups = _only(without_overlap(at, end), at, end, groups)
    return Found(at, end, groups)


def _only(keep: Array, at: Array, end: Array, groups: list[Group]) -> tuple[Array, Array, list[Group]]:
    """Some of the packets, numbered anew."""
    number = np.cumsum(keep)
    number -= 1
    left = []
    for group in groups:
        there = keep[group.number]
        if there.all():
            left.append(group._replace(number=number[group.number]))
        else:
            left.append(Group(group.key, number[group.number[there]], group.rows[there]))
    return at[keep], end[keep], left


def without_overlap(at: Array, end: Array) -> Array:
    """The candidates that remain, as the first of those that overlap wins."""
    keep, stop = np.zeros(len(at), bool), 0
    for number, (begin, after) in enumerate(zip(at.tolist(), end.tolist())):
        if begin >= stop:
            keep[number], stop = True, after
    return keep


def candidates(data: Array, first: int, limit: int, length: int) -> tuple[Array, Array]:
    """Where byte sequences with the form and the checksum of a packet begin and end."""
    if native.kernel is not None:
        return native.kernel.packets(data, first, limit, length, True)
    at, end, key = _forms(data, first, limit, length)
    right, _ = _checked(data, at, end, key)
    return at[right], end[right]


def clear(data: Array, begin: int, length: int, whole: bool) -> int | None:
    """Where the first packet at or behind `begin` may begin: one before it may reach beyond it.

    `whole` says that nothing comes before the data. If candidates overlap so far back that these
    data do not tell, the result is None.
    """
    at, end = candidates(data, 0, begin, length)
    known = 0 if whole else REACH  # whatever begins before the data ends here
    reach = np.maximum.accumulate(np.concatenate(([known], end)))
    # the last place that no candidate reaches across: there the parser surely begins anew
    free = np.flatnonzero(np.concatenate((at, [begin])) >= reach)
    if not len(free):
        return None
    at, end = at[free[-1] :], end[free[-1] :]
    kept = end[without_overlap(at, end)]
    return max(begin, int(kept[-1])) if len(kept) else begin


def _forms(data: Array, first: int, limit: int, length: int) -> tuple[Array, Array, Array]:
    """Begin, end, and set with length, of byte sequences with the form of a packet."""
    limit = min(limit, length - OVERHEAD + 1)
    forms = []
    for begin in range(first, limit, _PART):
        at = np.flatnonzero(data[begin : min(begin + _PART, limit)] == SYNC[0])
        at += begin
        at = at[data[at + 1] == SYNC[1]]
        key = data[at + 2].astype(np.uint16)
        key <<= 8
        key |= data[at + 3]
        end = at + OVERHEAD
        end += key & 0xFF
        right = (key > 0xFF) & (key < 0xFF00)  # no packet has descriptor set 0 or 0xFF
        right &= end <= length
        if not right.all():
            at, end, key = at[right], end[right], key[right]
        forms.append((at, end, key))
    if not forms:
        return _NONE, _NONE, _NONE.astype(np.uint16)
    at, end, key = (np.concatenate(parts) for parts in zip(*forms))
    return at, end, key


def grouped(data: Array, at: Array) -> list[Group]:
    """The groups of packets that are known already."""
    if native.kernel is not None:
        return []
    key = data[at + 2].astype(np.uint16) << 8 | data[at + 3]
    return [
        Group(what, some, gather(data, at[some], (what & 0xFF) + OVERHEAD - 2))
        for what, some in groups_of(key)
        if len(some) >= _MANY
    ]


def groups_of(key: Array) -> Iterator[tuple[int, Array]]:
    """Each key of a packet, and the numbers of the packets that have it."""
    order = np.argsort(key, kind="stable")
    ordered = key[order]
    cuts = (np.flatnonzero(ordered[1:] != ordered[:-1]) + 1).tolist()
    for begin, stop in zip([0, *cuts], [*cuts, len(order)]):
        if stop > begin:
            yield int(ordered[begin]), order[begin:stop]


def _checked(data: Array, at: Array, end: Array, key: Array) -> tuple[Array, list[Group]]:
    """Which checksums are right, and the packets in groups; those of small groups stay apart."""
    right, groups, rest = np.zeros(len(at), bool), [], []
    for what, chosen in groups_of(key):
        if len(chosen) < _MANY:
            rest.append(chosen)
            continue
        size = (what & 0xFF) + OVERHEAD - 2
        for part in range(0, len(chosen), _ROWS):
            some = chosen[part : part + _ROWS]
            rows, good = _right(data, at[some], end[some], size, -(-size // 8))
            right[some] = good
            groups.append(Group(what, some, rows))
    if rest:
        left = np.concatenate(rest)
        size = end[left] - at[left] - 2
        for width, some in groups_of(((size + 7) >> 3).astype(np.uint8)):
            for part in range(0, len(some), _ROWS):
                few = left[some[part : part + _ROWS]]
                _, good = _right(data, at[few], end[few], size[some[part : part + _ROWS]], width)
                right[few] = good
    return right, groups


_LOW = np.uint64(0x00FF00FF00FF00FF)
_SUM = np.uint64(0x0001000100010001)
_EVEN = np.uint64(0x0000_0002_0004_0006)  # weights of the bytes 6, 4, 2, 0
_ODD = np.uint64(0x0001_0003_0005_0007)  # … 7, 5, 3, 1
_EIGHT = np.uint64(8)
_TOP = np.uint64(48)
_KEEP = np.array([(1 << 8 * left) - 1 for left in range(9)], np.uint64)


def _right(data: Array, at: Array, end: Array, size: int | Array, width: int) -> tuple[Array, Array]:
    """The bytes of packets, and which of them have the right checksum.

    It covers `size` bytes, which are `width` words of eight at most. Each of the eight bytes of a
    word has its own sums, modulo 256, which are put together at last.
    """
    rows = gather(data, at, 8 * width)
    words = np.array(rows.view("<u8").T, order="C")  # always a copy: it is changed
    words[-1] &= _KEEP[size - 8 * (width - 1)]
    first = words[0]
    second = first.copy()
    ones, twos = first.view(np.uint8), second.view(np.uint8)
    for word in words[1:]:
        ones += word.view(np.uint8)
        twos += ones
    even = first & _LOW
    first >>= _EIGHT
    first &= _LOW
    place = even * _EVEN
    place >>= _TOP
    even += first
    even *= _SUM
    even >>= _TOP
    first *= _ODD
    first >>= _TOP
    place += first
    a = even.astype(np.uint8)
    first = second & _LOW
    second >>= _EIGHT
    second &= _LOW
    second += first
    second *= _SUM
    second >>= _TOP
    b = second.astype(np.uint8)
    b <<= 3
    b -= place.astype(np.uint8)
    lacking = 8 * width - size  # bytes of the last word
    b -= a * (lacking if isinstance(lacking, int) else lacking.astype(np.uint8))
    a ^= data[end - 2]
    b ^= data[end - 1]
    a |= b
    return rows, a == 0


def gather(data: Array, at: Array, size: int) -> Array:
    """As many bytes at each of these places, one row for each; the places must be inside."""
    if not size or not len(at):
        return np.zeros((len(at), size), np.uint8)
    rows: Array = np.ndarray((len(data) - size + 1,), f"V{size}", data, 0, (1,))[at]
    return rows.view(np.uint8).reshape(len(at), size)
