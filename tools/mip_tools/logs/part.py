"""Cuts a part out of a log."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from ..binding import SECOND
from ..columns import Log, cut, timeline, times
from ..columns.scan import Array
from ..columns.sender import identifies, near_replies
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
        self._last: int | None = None  # the last time, if no restart had set the clock back
        self._added = 0  # what the clock lacks since its last restart
        self._read = 0  # packets
        self._count = 0  # packets within the bounds
        #: The offset of the first packet behind the range of bytes and packet numbers; None until it is reached.
        self.end: int | None = None
        #: Are the bytes before the first packet within the bounds?
        self.first = not bounds.bytes.first and not bounds.packets.first and bounds.begin is None

    def description(self) -> str:
        """Describes the log, for the message that nothing was found in the range."""
        if self._count:
            return "has only other fields there; `mip info` lists them"
        if self._now is None or self._start is None or self.end is not None:
            return f"has {count_text(self._read, 'packet')}{' up to there' * (self.end is not None)}"
        begin = ""
        if self._bounds.dated:
            begin = f"begins at {clocks.stamp(self._clock or '', self._start, 2)} and "
        return f"{begin}lasts {(self._now - self._start) / SECOND:.2f} s"

    def by_time(self, part: Log) -> Array:
        """Returns which packets of the next part are within the limits of time."""
        if self._clock is None:
            return np.ones(part.packets, bool)
        own = times.of_packets(part, self._clock)
        last = np.maximum.accumulate(np.where(own == NONE, 0, np.arange(1, len(own) + 1)))
        if not clocks.dated(self._clock):
            self._continue(part, own)
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

    def _continue(self, part: Log, time: Array) -> None:
        """Lets times continue where the clock restarts."""
        places = [at for at in timeline.of_log(part).restarts(self._clock or "") if part.begin <= at < part.end]
        restarts = [part.before_offset(at) for at in places]
        for begin, end in zip([0, *restarts], [*restarts, len(time)]):
            there = begin + np.flatnonzero(time[begin:end] != NONE)
            if len(there):
                if begin in restarts and self._last is not None:
                    self._added = self._last - int(time[there[0]])
                time[there] += self._added
                self._last = int(time[there[-1]])

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
        self.end = int(offset[ended][0]) if ended.any() else None
        self._read += int((~ended).sum())
        return np.asarray(within & ~ended)

    def count(self, within: Array) -> None:
        """Counts the packets within the bounds."""
        self._count += int(within.sum())


def _identifying(log: Log, begin: int) -> Iterator[bytes]:
    """Yields the packets that identify the device and begin at this offset or later."""
    for part in near_replies(log, begin):
        for piece in part.pieces():
            for at, end in zip(piece.at.tolist(), piece.end.tolist()):
                yield piece.data[at:end].tobytes()


def kept(
    parts: Iterable[tuple[int, Log]], within: Within, selection: Selection, skipped: bool, whole_log: Log | None = None
) -> Iterator[tuple[bytes, int]]:
    """Yields the bytes of the packets within the bounds, and the number of these packets.

    `parts` are logs, each with the offset at which its bytes begin; `skipped` also keeps the bytes behind each packet.
    Packets that identify the device are kept anywhere in `whole_log`, without it only before the end of the range.
    """
    before, free = within.first, 0  # the last packet: is it within the bounds, and where does it end?
    for place, part in parts:
        by_time = within.by_time(part)
        for piece in part.pieces(fields=not selection.everything):
            count = len(piece.at)
            offset = place + piece.begin + piece.at
            here: Array = within.by_place(offset) & by_time[piece.number : piece.number + count]
            within.count(here)
            spans: list[cut.Spans] = []
            if skipped:
                spans.append(cut.gaps(piece, free - place, np.concatenate(([before], here))))
            if count:
                before, free = bool(here[-1]), place + piece.begin + int(piece.end[-1])
            # without the name of the device, flags could mean something else
            whole, identifying = here, identifies(piece.data, piece.at)
            if within.end is not None:
                identifying &= offset < within.end
            mixed: Array = np.zeros(count, bool)
            if not selection.everything:
                fields = cut.Fields(piece, selection.has)
                whole, mixed = here & fields.whole, here & fields.mixed
                spans += fields.spans(mixed & ~identifying)
            count = int((whole | mixed).sum())
            whole, mixed = whole | identifying, mixed & ~identifying
            spans.append((piece.at[whole], piece.end[whole]))
            yield cut.cut(piece, spans, mixed), count
            if within.end is not None:
                if whole_log is not None:
                    yield b"".join(_identifying(whole_log, within.end)), 0
                return
