"""Cuts a part out of a log."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from ..binding import SECOND
from ..columns import Log, cut, timeline, times
from ..columns.continued import Continued
from ..columns.scan import Array
from ..columns.sender import identifies
from ..columns.stamps import NONE
from ..names.selection import Selection
from ..text import clocks
from ..text.numbers import count_text
from .bounds import Bounds, When


class Within:
    """Finds the packets that are within bounds, in one part of a log after another."""

    def __init__(self, bounds: Bounds, clock: str | None) -> None:
        self._bounds, self._clock = bounds, clock
        self._start: int | None = None
        self._now: int | None = None
        self._continued = Continued()
        self._read = 0  # packets
        self._count = 0  # packets within the bounds

    def description(self) -> str:
        """Describes the log, for the message that nothing was found in the range."""
        if self._count:
            return "has only other fields there; `mip info` lists them"
        if self._now is None or self._start is None:
            return f"has {count_text(self._read, 'packet')}"
        begin = ""
        if self._bounds.dated:
            begin = f"begins at {clocks.stamp(self._clock or '', self._start, 2)} and "
        return f"{begin}lasts {(self._now - self._start) / SECOND:.2f} s"

    def by_time(self, part: Log) -> Array:
        """Returns which packets of the next part are within the limits of time."""
        self._read += part.packets
        if self._clock is None:
            return np.ones(part.packets, bool)
        own = times.of_packets(part, self._clock)
        last = np.maximum.accumulate(np.where(own == NONE, 0, np.arange(1, len(own) + 1)))
        if not clocks.dated(self._clock):
            restarts = timeline.of_log(part).restarts(self._clock)
            self._continued.add(own, [part.before_offset(at) for at in restarts if part.begin <= at < part.end])
        time = np.concatenate(([NONE if self._now is None else self._now], own))[last]
        valid = time[time != NONE]
        if len(valid):
            self._start = int(valid[0]) if self._start is None else self._start
            self._now = int(valid[-1])
        begin, end = self._bounds.begin, self._bounds.end
        within = np.ones(len(time), bool)
        if begin is not None:
            within &= time >= self._limit(begin)
        if end is not None:
            within &= time < self._limit(end)
        return np.asarray(np.where(time == NONE, begin is None, within))

    def _limit(self, when: When) -> int:
        return when.time + (0 if when.absolute else self._start or 0)

    def count(self, within: Array) -> None:
        """Counts the packets within the bounds."""
        self._count += int(within.sum())


def kept(parts: Iterable[tuple[int, Log]], within: Within, selection: Selection) -> Iterator[tuple[bytes, int]]:
    """Yields the bytes of the packets within the bounds, and the number of these packets.

    `parts` are logs, each with the offset at which its bytes begin. Packets that identify the device are kept anywhere.
    """
    for _, part in parts:
        by_time = within.by_time(part)
        for piece in part.pieces(fields=not selection.everything):
            count = len(piece.at)
            here: Array = by_time[piece.number : piece.number + count]
            within.count(here)
            spans: list[cut.Spans] = []
            # without the name of the device, flags could mean something else
            whole, identifying = here, identifies(piece.data, piece.at)
            mixed: Array = np.zeros(count, bool)
            if not selection.everything:
                fields = cut.Fields(piece, selection.has)
                whole, mixed = here & fields.whole, here & fields.mixed
                spans += fields.spans(mixed & ~identifying)
            count = int((whole | mixed).sum())
            whole, mixed = whole | identifying, mixed & ~identifying
            spans.append((piece.at[whole], piece.end[whole]))
            yield cut.cut(piece, spans, mixed), count
