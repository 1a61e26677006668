"""Rates and gaps of repeated packets, in bounded memory."""

from __future__ import annotations

import heapq
import math
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from ..binding import SECOND
from .distinct import places_among
from .stamps import LACKING, NONE, Stamps
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


class Share(NamedTuple):
    """The instants of a set that have a field: their number, and the numbers of the first and the last one."""

    instants: int = 0
    first: int = 0
    last: int = 0

    @classmethod
    def of(cls, numbers: Any) -> Share:
        """Returns the instants of some fields, in the order of the log; 0 is none."""
        numbers = numbers[numbers > 0]
        return cls(1 + int(np.count_nonzero(np.diff(numbers))), *numbers[[0, -1]].tolist()) if len(numbers) else cls()

    def and_(self, later: Share) -> Share:
        """Returns these instants and those of fields that are later in the log."""
        if not self.instants or not later.instants:
            return self if self.instants else later
        return Share(self.instants + later.instants - (self.last == later.first), self.first, later.last)

    @property
    def part(self) -> float:
        """The share of the instants from the first to the last one that has the field."""
        return (self.instants - 1) / (self.last - self.first)


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
    _instants: Counter[int] = field(default_factory=Counter)  # those without a timestamp, by the bin of the step
    _shares: dict[int, Share] = field(default_factory=dict)
    _number: int = 0  # of the last instant
    _at: int = 0  # the number of the last instant with a time
    _timed: bool = False  # is the last timestamp valid?

    def add_set(self, packets: Any, stamps: Stamps, fields: dict[int, Any]) -> Any:
        """Adds packets of a set, in the order of the log, with their timestamps; `fields` are the places among them of
        those that have a field, each once, by any key.

        Returns the number of the instant of each packet. Packets with the same time have the same one, and a packet
        without a timestamp one of its own: devices may add timestamps seldom. It is 0 while times are not valid.
        """
        value = np.full(len(packets), LACKING, np.int64)
        value[places_among(packets, stamps.packet)] = stamps.value
        valid, lacks = value > LACKING, value == LACKING
        last = np.maximum.accumulate(np.where(lacks, -1, np.arange(len(value))))
        timed = np.where(last < 0, self._timed, valid[last])
        rows = np.flatnonzero(valid)
        new = timed & lacks
        new[rows] = np.diff(value[rows], prepend=value[rows[:1]] if self.last is None else self.last) != 0
        if self.last is None:
            new[rows[:1]] = True
        number = self._number + np.cumsum(new)
        there = stamps.value != NONE
        self._lacking(value[rows], number[rows])
        self.add_all(stamps.value[there], stamps.offset[there])
        if len(number):
            self._number, self._timed = int(number[-1]), bool(timed[-1])
        number = np.where(timed, number, 0)
        whole = Share.of(number)  # for most fields
        for key, places in fields.items():
            share = whole if len(places) == len(number) else Share.of(number[places])
            if share.instants:
                self._shares[key] = self._shares.get(key, Share()).and_(share)
        return number

    def _lacking(self, times: Any, numbers: Any) -> None:
        """Counts the instants without a timestamp in each step of the time."""
        steps = np.diff(times, prepend=times[:1] if self.last is None else self.last)
        rows = np.flatnonzero(steps)
        numbers = np.append(self._at or numbers[:1], numbers[rows])
        counts = np.diff(numbers) - 1
        some = (counts > 0) & (steps[rows] > 0)
        lengths, which = np.unique(steps[rows][some], return_inverse=True)
        for step, count in zip(lengths.tolist(), np.bincount(which, counts[some]).tolist()):
            self._instants[_bin(step)] += round(count)
        if len(numbers):
            self._at = int(numbers[-1])

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
        """The rate in Hz, without gaps and jumps: that of the timestamps, or of a field that occurs more often."""
        rates = [self._rate(instants=False), *map(self.rate_of, self._shares)]
        return max((rate for rate in rates if rate is not None), default=None)

    def _rate(self, instants: bool) -> float | None:
        """The rate in Hz of the timestamps, or of all instants."""
        usual = self.usual
        if usual is None:
            return None
        limit = math.log(usual * SECOND * GAP) * 1000
        near = [place for place in self._bins if place <= limit]
        spent = sum(self._sums[place] for place in near) / SECOND
        count = sum(self._bins[place] + instants * self._instants[place] for place in near)
        return count / spent if spent else None

    def rate_of(self, key: int) -> float | None:
        """Returns the rate in Hz of a field that was added by a key."""
        share = self._shares.get(key)
        return None if share is None else self.rate_of_share(share)

    def rate_of_share(self, share: Share) -> float | None:
        """Returns the rate in Hz of a field that some instants have, from the first to the last one that does."""
        rate = self._rate(instants=True)
        return None if rate is None or share.last <= share.first else rate * share.part

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


def common_spans(sets: Iterable[Intervals]) -> list[tuple[int, int]]:
    """Returns the times of all sets together, from each restart of their clock to the next."""
    spans = [intervals.spans for intervals in sets]
    most = max(map(len, spans), default=0)
    alike = [own for own in spans if len(own) == most]
    return [(min(s[i][0] for s in alike), max(s[i][1] for s in alike)) for i in range(most)]


def seconds_of(spans: Iterable[tuple[int, int]]) -> float:
    """Returns the seconds in some spans."""
    return sum(last - first for first, last in spans) / SECOND


def _bin(step: int) -> int:
    """Returns the bin of a step: steps that differ by less than 0.1 % are counted together."""
    return round(math.log(step) * 1000)
