"""The rhythm of a field: its usual interval, gaps in it, and when it changes."""

from __future__ import annotations

from typing import NamedTuple

#: So many equal intervals are a rhythm.
STEADY = 5
#: Intervals that differ by less are equal.
EQUAL = 0.1
#: An interval of so many times the usual one is a gap.
GAP = 1.5


class Moment(NamedTuple):
    """A packet of a field: when, where it begins and ends, and how many packets of other sets came before."""

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
    """Follows a field. A gap is known when the usual interval comes again, a change when another one repeats."""

    def __init__(self) -> None:
        self.usual: float | None = None
        self.first: Moment | None = None
        self.last: Moment | None = None
        self._run = 0.0
        self._count = 0
        self._began: Moment | None = None
        self._gaps: list[Gap] = []

    def add(self, now: Moment) -> list[Gap | Change]:
        """What is known with one more packet."""
        before, self.last = self.last, now
        self.first = self.first or now
        if before is None:
            return []
        step = now.time - before.time
        if step <= 0:
            return []
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

    def restart(self) -> None:
        """The clock begins anew; the usual interval remains."""
        usual = self.usual
        self.__init__()  # type: ignore[misc]
        self.usual = usual


__all__ = ["Change", "Gap", "Moment", "Rhythm"]
