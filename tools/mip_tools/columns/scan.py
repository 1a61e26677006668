"""Finds the packets in a piece of a log: exactly those that `Parser` finds."""

from __future__ import annotations

import numpy as np

from ..binding import MAX_PAYLOAD, OVERHEAD, SYNC
from . import native
from .native import Array as Array

#: The size of a packet's header, in bytes.
HEADER = OVERHEAD - 2
#: The greatest distance from the first byte of a packet to its end.
REACH = MAX_PAYLOAD + OVERHEAD - 1
#: The number of bytes that must follow a piece, for packets that begin in it and for whole words of the last one.
AHEAD = REACH + 8

_PART = 1 << 18  # bytes that are searched at once: intermediate results stay in the cache


def find_packets(data: Array, first: int, limit: int, length: int) -> tuple[Array, Array]:
    """Finds the packets that begin in `first` … `limit`. Returns their beginnings and ends.

    The first `length` bytes of `data` belong to the log; at least 8 more must follow.
    """
    if native.kernel is not None:
        return native.kernel.packets(data, first, limit, length, False)
    at, end = candidates(data, first, limit, length)
    if (at[1:] < end[:-1]).any():
        keep = without_overlap(at, end)
        return at[keep], end[keep]
    return at, end


def without_overlap(at: Array, end: Array) -> Array:
    """Removes overlapping candidates: the first one wins."""
    keep, stop = np.zeros(len(at), bool), 0
    for number, (begin, after) in enumerate(zip(at.tolist(), end.tolist())):
        if begin >= stop:
            keep[number], stop = True, after
    return keep


def candidates(data: Array, first: int, limit: int, length: int, only: int | None = None) -> tuple[Array, Array]:
    """Finds byte sequences with the form and the checksum of a packet, of any descriptor set or of only one. Returns
    their beginnings and ends."""
    if native.kernel is not None and only is None:
        return native.kernel.packets(data, first, limit, length, True)
    limit = min(limit, length - OVERHEAD + 1)
    spans: list[tuple[Array, Array]] = [(np.zeros(0, np.intp),) * 2]
    for begin in range(0, limit, _PART):
        at, end = _forms(data, max(begin, first), min(begin + _PART, limit), length, only)
        if len(at):
            right = _checksums_match(data[begin:], at - begin, end - begin)
            spans.append((at, end) if right.all() else (at[right], end[right]))
    at, end = (np.concatenate(parts) for parts in zip(*spans))
    return at, end


def clear(data: Array, begin: int, length: int, whole: bool) -> int | None:
    """Returns where the first packet at or after `begin` may begin, because one before it may reach beyond it.

    `whole`: nothing precedes the data. Returns None if candidates overlap so far back that these data do not suffice.
    """
    at, end = candidates(data, 0, begin, length)
    reach_before = 0 if whole else REACH  # any packet that begins before the data ends here at the latest
    reach = np.maximum.accumulate(np.concatenate(([reach_before], end)))
    # the last position that no candidate spans: there the parser certainly starts afresh
    free = np.flatnonzero(np.concatenate((at, [begin])) >= reach)
    if not len(free):
        return None
    at, end = at[free[-1] :], end[free[-1] :]
    kept = end[without_overlap(at, end)]
    return max(begin, int(kept[-1])) if len(kept) else begin


def _forms(data: Array, first: int, limit: int, length: int, only: int | None) -> tuple[Array, Array]:
    """Finds byte sequences with the form of a packet. Returns their beginnings and ends."""
    at = np.flatnonzero(data[first:limit] == SYNC[0])
    at += first
    at = at[data[at + 1] == SYNC[1]]
    if only is not None:
        at = at[data[at + 2] == only]
    end = at + OVERHEAD
    end += data[at + 3]
    right = data[at + 2] - np.uint8(1) < 0xFE  # no packet has descriptor set 0 or 0xFF
    right &= end <= length
    return (at, end) if right.all() else (at[right], end[right])


_LOW = np.uint64(0x00FF00FF00FF00FF)
_ONCE = np.uint64(0x0001000100010001)
_EVEN = np.uint64(0x0008000600040002)  # from the last even byte to the first one
_ODD = np.uint64(0x0007000500030001)
_TOP = np.uint64(48)
_BYTE = np.uint64(8)


def _checksums_match(data: Array, at: Array, end: Array) -> Array:
    """Returns, for each packet, whether its checksum is correct.

    The sums of a packet come from running sums of all the data: of the bytes, and of these sums.
    Everything is modulo 256, as the checksum is.
    """
    words = data[: (int(end.max()) | 7) + 1].view("<u8")
    ones, twos = _sums(words)
    running = np.cumsum(ones)
    running -= ones
    ones = running.astype(np.uint8)  # before each word
    running *= _BYTE
    twos += running
    running = np.cumsum(twos)
    running -= twos
    twos = running.astype(np.uint8)

    def before(place: Array) -> tuple[Array, Array]:
        word = place >> 3
        more = (place & 7).astype(np.uint8)  # bytes of this word
        first, second = _sums(words[word] << ((64 - 8 * more).astype(np.uint64)))
        start = ones[word]
        return first.astype(np.uint8) + start, second.astype(np.uint8) + twos[word] + more * start

    first, second = before(np.append(at, end[-1]))
    one_end, two_end = first[1:].copy(), second[1:].copy()  # most packets end where the next one begins
    apart = np.flatnonzero(at[1:] != end[:-1])
    one_end[apart], two_end[apart] = before(end[apart])
    first, second = first[:-1], second[:-1]
    # the checksum itself was added, too: S(end) = S(end - 2) + a + b, where S(end - 2) - S(at) = a
    a, b = data[end - 2], data[end - 1]
    right = one_end - first == 2 * a + b
    right &= two_end - second == 2 * one_end + ((end - at).astype(np.uint8) - 2) * first
    return np.asarray(right)


def _sums(words: Array) -> tuple[Array, Array]:
    """Returns the sum of the eight bytes of each word, and the sum of the sums after each byte."""
    even = words & _LOW
    odd = words >> _BYTE
    odd &= _LOW
    twos = even * _EVEN
    even += odd
    odd *= _ODD
    twos += odd
    twos >>= _TOP
    even *= _ONCE
    even >>= _TOP
    return even, twos


def gather(data: Array, at: Array, size: int) -> Array:
    """Copies `size` bytes at each of these offsets to a row; all must be inside the data."""
    if not size or not len(at):
        return np.zeros((len(at), size), np.uint8)
    rows: Array = np.ndarray((len(data) - size + 1,), f"V{size}", data, 0, (1,))[at]
    return rows.view(np.uint8).reshape(len(at), size)
