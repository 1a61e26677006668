"""Cuts a part out of a log."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from ..columns import Log, cut, times
from ..columns.scan import Array
from . import clocks, inputs
from .bounds import Bounds, When
from .selection import Selection


class Within:
    """Finds the packets that are within bounds, in one part of a log after another."""

    def __init__(self, bounds: Bounds, clock: str | None) -> None:
        self._bounds, self._clock = bounds, clock
        self._start: int | None = None
        self._now: int | None = None
        self._read = 0  # packets
        self._found = 0  # packets within the bounds
        #: Is the end of the range reached?
        self.ended = False
        #: Are the bytes before the first packet within the bounds?
        self.first = not bounds.bytes.first and not bounds.packets.first and bounds.begin is None

    def known(self) -> str:
        """Describes the log, for the message that nothing was found in the range."""
        if self._found:
            return "has only other fields there; `mip info` lists them"
        if self._now is None or self._start is None or self.ended:
            return f"has {inputs.counted(self._read, 'packet')}{' up to there' * self.ended}"
        begin = ""
        if self._bounds.dated:
            begin = f"begins at {clocks.stamp(self._clock or '', self._start, 2)} and "
        return f"{begin}lasts {(self._now - self._start) / clocks.SECOND:.2f} s"

    def by_time(self, part: Log) -> Array:
        """Returns which packets of the next part are within the limits of time."""
        if self._clock is None:
            return np.ones(part.packets, bool)
        own = times.of_packets(part, self._clock)
        last = np.maximum.accumulate(np.where(own == times.NONE, 0, np.arange(1, len(own) + 1)))
        time = np.concatenate(([times.NONE if self._now is None else self._now], own))[last]
        known = time[time != times.NONE]
        if len(known):
            self._start = int(known[0]) if self._start is None else self._start
            self._now = int(known[-1])
        begin, end = self._bounds.begin, self._bounds.end
        within = np.ones(len(time), bool)
        if begin is not None:
            within &= time >= self._limit(begin)
        if end is not None:
            within &= time < self._limit(end)
        return np.asarray(np.where(time == times.NONE, begin is None, within))

    def _limit(self, when: When) -> int:
        return when.time + (0 if when.absolute else self._start or 0)

    def by_place(self, offset: Array) -> Array:
        """Returns which of the next packets are within the limits of bytes and packet numbers."""
        number = self._read + np.arange(len(offset))
        ended = np.zeros(len(offset), bool)
        within = np.ones(len(offset), bool)
        for places, limits in ((offset, self._bounds.bytes), (number, self._bounds.packets)):
            within &= places >= limits.first
            if limits.end is not None:
                ended |= places >= limits.end
        self.ended = bool(ended.any())
        self._read += int((~ended).sum())
        return np.asarray(within & ~ended)

    def found(self, within: Array) -> None:
        """Counts the packets within the bounds."""
        self._found += int(within.sum())


def kept(
    parts: Iterable[tuple[int, Log]], within: Within, selection: Selection, skipped: bool
) -> Iterator[tuple[bytes, int]]:
    """Yields the bytes of the packets within the bounds, and the number of these packets.

    `parts` are logs, each with the offset at which its bytes begin; `skipped` also keeps the bytes behind each packet.
    """
    before, free = within.first, 0  # the last packet: is it within the bounds, and where does it end?
    for place, part in parts:
        by_time = within.by_time(part)
        for piece in part.pieces(fields=not selection.everything):
            count = len(piece.at)
            here: Array = within.by_place(place + piece.begin + piece.at) & by_time[piece.number : piece.number + count]
            within.found(here)
            spans: list[cut.Spans] = []
            if skipped:
                spans.append(cut.gaps(piece, free - place, np.concatenate(([before], here))))
            if count:
                before, free = bool(here[-1]), place + piece.begin + int(piece.end[-1])
            whole: Array = here
            mixed: Array = np.zeros(count, bool)
            if not selection.everything:
                fields = cut.Fields(piece, selection.has)
                whole, mixed = here & fields.whole, here & fields.mixed
                spans += fields.spans(mixed)
            spans.append((piece.at[whole], piece.end[whole]))
            yield cut.cut(piece, spans, mixed), int(whole.sum() + mixed.sum())
            if within.ended:
                return


__all__ = ["Within", "kept"]
