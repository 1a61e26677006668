"""Follows the rhythm of a field: its usual interval, its gaps, and when the interval changes."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from ..columns.scan import Array

#: The number of equal intervals after which the usual interval is known.
STEADY = 5
#: Intervals whose relative difference is smaller are equal.
EQUAL = 0.1
#: An interval of this many times the usual one is a gap.
GAP = 1.5
#: The number of intervals that are compared at once.
_WINDOW = 1024
#: The number of intervals, and the multiple, up to which packets that are missing all the time are recognized.
_MANY, _MOST = 20, 5
#: The longest interval in ns: the difference of two still fits into 64 bits.
_LONGEST = 1 << 61


class Moment(NamedTuple):
    """A packet with the field: its time, where it begins and ends, and the number of packets of each set before it."""

    time: int
    begin: int
    end: int
    others: int = 0


class Gap(NamedTuple):
    before: Moment
    after: Moment
    usual: float  # ns


class Change(NamedTuple):
    at: Moment
    old: float  # intervals in ns
    new: float


class Rhythm:
    """Follows a field. A gap is known when the usual interval returns, a change when another interval repeats."""

    def __init__(self, usual: float | None = None) -> None:
        self.usual = usual
        self.first: Moment | None = None
        self.last: Moment | None = None
        self._run = 0.0
        self._count = 0
        self._began: Moment | None = None
        self._gaps: list[Gap] = []
        self._first_steps: list[int] = []  # until the usual interval is known

    def lossy(self) -> int | None:
        """Returns the interval in ns of which all intervals are multiples, as if packets were missing all the time, so
        that none became usual."""
        least = min(self._first_steps, default=0)
        multiples = [step / least for step in self._first_steps if least]
        few = len(multiples) < _MANY or self.usual is not None or not 1.5 < max(multiples) < _MOST
        if few or any(abs(multiple - round(multiple)) > EQUAL for multiple in multiples):
            return None
        return least if sum(multiple < 1.5 for multiple in multiples) > len(multiples) // 4 else None

    def follow(self, times: Array, moment: Callable[[int], Moment]) -> Iterator[tuple[int, Gap | Change]]:
        """Yields the gaps and changes that further packets reveal, each with the number of the packet that revealed it.

        `moment` describes a packet by its number."""
        if not len(times):
            return
        before, self.last = self.last, moment(len(times) - 1)
        self.first = self.first or moment(0)
        steps = intervals(np.append(times[0] if before is None else before.time, times))
        forward = np.flatnonzero(steps > 0)
        steps = steps[forward]
        at = 0
        while at < len(steps):
            window = steps[at : at + _WINDOW]
            steady = self._as_usual(window)
            at += steady
            if steady < len(window):
                number = int(forward[at])
                earlier = moment(number - 1) if number or before is None else before
                yield from ((number, change) for change in self._add(int(steps[at]), earlier, moment(number)))
                at += 1

    def _as_usual(self, steps: Array) -> int:
        """Counts how many of these intervals, from the first on, equal the last interval and the usual one."""
        if self.usual is None or self._gaps or not self._count:
            return 0
        same = np.abs(steps - self._run) < EQUAL * self._run
        same &= np.abs(steps - self.usual) < EQUAL * self.usual
        count = len(steps) if same.all() else int(same.argmin())
        self._count += count
        return count

    def _add(self, step: int, before: Moment, now: Moment) -> list[Gap | Change]:
        """Returns the gaps and changes that one more interval reveals."""
        if self.usual is None and len(self._first_steps) < _WINDOW:
            self._first_steps.append(step)
        if self._count and abs(step - self._run) < EQUAL * self._run:
            self._count += 1
        else:
            self._run, self._count, self._began = float(step), 1, before
        if self.usual is not None and abs(step - self.usual) < EQUAL * self.usual:
            gaps, self._gaps = self._gaps, []
            return list(gaps)
        if self._count >= STEADY:
            old, self.usual, self._gaps = self.usual, self._run, []
            assert self._began is not None
            return [] if old is None else [Change(self._began, old, self._run)]
        if self.usual is not None and step > GAP * self.usual:
            self._gaps.append(Gap(before, now, self.usual))
        return []


def intervals(times: Array) -> Array:
    """Returns the time from each one to the next, limited to the longest interval."""
    about = np.diff(times.astype(np.float64))
    steps: Array = np.where(np.abs(about) < _LONGEST, np.diff(times), np.copysign(_LONGEST, about).astype(np.int64))
    return steps
