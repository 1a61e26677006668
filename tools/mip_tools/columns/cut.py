"""Removes packets and fields from the bytes of a piece."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..binding import OVERHEAD
from .piece import Piece
from .scan import HEADER, Array

#: The beginnings and ends of bytes that do not overlap.
Spans = tuple[Array, Array]


class Fields:
    """The selected fields of a piece, by set and descriptor."""

    def __init__(self, piece: Piece, has: Callable[[int, int], bool]) -> None:
        self._piece = piece
        self._runs = [run for run in piece.runs or () if has(run.set, run.descriptor)]
        count = len(piece.at)
        total, wanted = np.zeros(count, np.int64), np.zeros(count, np.int64)
        for runs, numbers in ((piece.runs or (), total), (self._runs, wanted)):
            for run in runs:
                numbers += np.bincount(run.packet, minlength=count)
        #: Packets with only selected fields, and packets that also have others.
        self.whole, self.mixed = (wanted > 0) & (wanted == total), (wanted > 0) & (wanted < total)

    def spans(self, packets: Array) -> list[Spans]:
        """Returns the spans of the selected fields of these packets, with the header and checksum of each packet."""
        at, end = self._piece.at, self._piece.end
        spans = [(at[packets], at[packets] + HEADER), (end[packets] - (OVERHEAD - HEADER), end[packets])]
        for run in self._runs:
            begin = at[run.packet] + (HEADER - 2) + run.offset
            begin = begin[packets[run.packet]]
            spans.append((begin, begin + (run.length + 2)))
        return spans


def cut(piece: Piece, spans: list[Spans], changed: Array) -> bytes:
    """Joins the bytes of these spans. Packets in `changed` get a new length and checksum."""
    steps = np.zeros(len(piece.data) + 1, np.int8)
    for begin, end in spans:
        steps[begin] += 1
        steps[end] -= 1
    kept = np.cumsum(steps[:-1], dtype=np.int8).view(bool)
    out: Array = piece.data[kept]
    if changed.any():
        before = np.cumsum(kept)
        begin, end = before[piece.at[changed]] - 1, before[piece.end[changed] - 1]
        out[begin + HEADER - 1] = end - begin - OVERHEAD
        out[end - 2], out[end - 1] = _checksums(out, begin, end - 2)
    return out.tobytes()


def _checksums(data: Array, begin: Array, end: Array) -> Spans:
    """Computes both bytes of the checksums of some spans, from running sums of all data."""
    first = np.cumsum(np.concatenate(([0], data)), dtype=np.uint8)
    second = np.cumsum(first, dtype=np.uint8)
    return first[end] - first[begin], second[end] - second[begin] - (end - begin).astype(np.uint8) * first[begin]
