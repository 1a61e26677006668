"""Rates and gaps of repeated packets, in bounded memory."""

from __future__ import annotations

import heapq
import math
from collections import Counter
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from ..binding import SECOND
from .timeline import BACK

#: An interval of this many times the usual one is a gap.
GAP = 1.5
#: The number of gaps and jumps that are kept, with their positions.
KEPT = 10
#: The number of restarts that are counted.
MOST = 1000


#: Different steps below this many nanoseconds remain different as floats in seconds; longer ones are added one by one.
_EXACT = 2**51


class Place(NamedTuple):
    """A gap or a jump between two packets: its seconds, and where the second packet begins."""

    seconds: float
    offset: int
    time: int


@dataclass
class Intervals:
    """The intervals between packets of one kind, in the order of the log."""

    count: int = 0
    first: int | None = None
    last: int | None = None
    begins: list[int] = field(default_factory=list)  # the first time, and those after the clock went back
    ends: list[int] = field(default_factory=list)  # the times before
    backward: list[Place] = field(default_factory=list)
    backwards: int = 0
    _bins: Counter[int] = field(default_factory=Counter)
    _longest: list[Place] = field(default_factory=list)
    _sums: Counter[int] = field(default_factory=Counter)

    def add_all(self, times: Any, offsets: Any) -> None:
        """Adds packets as NumPy arrays, in the order of the log, with the same result as `add` for each."""
        if self.last is None and len(times):
            self.add(int(times[0]), int(offsets[0]))
            times, offsets = times[1:], offsets[1:]
        if not len(times):
            return
        before: Any = np.concatenate((np.array([self.last], np.int64), times[:-1]))
        if (np.abs(times.astype(np.float64) - before.astype(np.float64)) >= _EXACT).any():
            for time, offset in zip(times.tolist(), offsets.tolist()):
                self.add(time, offset)
            return
        steps = times - before
        self.count += len(steps)
        self.last = int(times[-1])
        back = np.flatnonzero(steps < 0)
        self.backwards += len(back)
        for i in np.flatnonzero(steps < -BACK)[: MOST - len(self.ends)].tolist():
            self._restart(int(before[i]), int(times[i]))
        for i in back[: KEPT - len(self.backward)].tolist():
            self.backward.append(Place(int(steps[i]) / SECOND, int(offsets[i]), int(times[i])))
        for step, count in zip(*(a.tolist() for a in np.unique(steps, return_counts=True))):
            if step > 0:
                place_of = _bin(step)
                self._bins[place_of] += count
                self._sums[place_of] += step * count
        least = max(1, int(np.partition(steps, -KEPT)[-KEPT])) if len(steps) > KEPT else 1
        equal = np.flatnonzero(steps == least)[-KEPT:]  # of equal steps, the last ones are kept
        for i in [*equal.tolist(), *np.flatnonzero(steps > least).tolist()]:
            self._keep(Place(int(steps[i]) / SECOND, int(offsets[i]), int(times[i])))

    def add(self, time: int, offset: int) -> None:
        """Adds a packet, at a time in ns."""
        self.count += 1
        if self.last is None:
            self.first = time
            self.begins.append(time)
        else:
            step = time - self.last
            if step < 0:
                self.backwards += 1
                if step < -BACK and len(self.ends) < MOST:
                    self._restart(self.last, time)
                if len(self.backward) < KEPT:
                    self.backward.append(Place(step / SECOND, offset, time))
            elif step > 0:
                place_of = _bin(step)
                self._bins[place_of] += 1
                self._sums[place_of] += step
                self._keep(Place(step / SECOND, offset, time))
        self.last = time

    def _restart(self, end: int, begin: int) -> None:
        self.ends.append(end)
        self.begins.append(begin)

    @property
    def spans(self) -> list[tuple[int, int]]:
        """The first and the last time of each part in which the clock does not go back."""
        return list(zip(self.begins, [*self.ends, *([] if self.last is None else [self.last])]))

    def _keep(self, place: Place) -> None:
        """Keeps the interval if it is one of the longest."""
        if len(self._longest) < KEPT:
            heapq.heappush(self._longest, place)
        elif place > self._longest[0]:
            heapq.heapreplace(self._longest, place)

    @property
    def usual(self) -> float | None:
        """The median interval, in seconds."""
        total = sum(self._bins.values())
        passed = 0
        for place in sorted(self._bins):
            passed += self._bins[place]
            if passed * 2 >= total:
                return self._sums[place] / self._bins[place] / SECOND
        return None

    @property
    def rate(self) -> float | None:
        """The rate in Hz, without gaps and jumps."""
        usual = self.usual
        if usual is None:
            return None
        limit = math.log(usual * SECOND * GAP) * 1000
        near = [place for place in self._bins if place <= limit]
        spent = sum(self._sums[place] for place in near) / SECOND
        return sum(self._bins[place] for place in near) / spent if spent else None

    def rate_of(self, packets: int, of: int) -> float | None:
        """Returns the rate in Hz of a field that some of these packets contain: `packets` of the `of` packets of the
        set from the first to the last one that does."""
        rate = self.rate
        return None if rate is None or of < 2 else rate * (packets - 1) / (of - 1)

    @property
    def gaps(self) -> tuple[int, float, list[Place]]:
        """The number of gaps, the missing seconds, and the longest gaps in order."""
        usual = self.usual
        if usual is None or self.count < 4:
            return 0, 0.0, []
        limit = math.log(usual * SECOND * GAP) * 1000
        wide = [place for place in self._bins if place > limit]
        count = sum(self._bins[place] for place in wide)
        missing = sum(self._sums[place] for place in wide) / SECOND - usual * count
        places = [p for p in self._longest if p.seconds > usual * GAP]
        return count, missing, sorted(places, key=lambda p: p.offset)


def _bin(step: int) -> int:
    """Returns the bin of a step: steps that differ by less than 0.1 % are counted together."""
    return round(math.log(step) * 1000)
