"""The clocks of a whole log. A device without GPS time sends the time since power-on instead: the clock `device`, which
continues when the device synchronizes. A clock that goes back is a restart of the device."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from copy import deepcopy
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from ..binding import CLOCKS, DEVICE_CLOCK, SECOND, timestamps
from .distinct import distinct
from .packets import Packets
from .raw_times import raw, read
from .runs import Runs
from .scan import Array
from .stamps import NONE, Stamps

#: The clock of devices without GPS time; "" if the specification has none.
DEVICE = DEVICE_CLOCK
#: A clock that goes back by more than this restarts; packets may be out of order.
BACK = SECOND // 10
#: Dates and the device's clock that differ less than this from what they were are still the same.
_NEAR = 10 * SECOND
#: A time of week without a date may continue the time of week of a date, or a week before, after at most this time.
_HOUR = 3600 * SECOND
#: The number of events of a set that are kept.
_KEPT = 1000
#: The size in bytes of a log that is read only once, and whose times are all in memory; of a larger one, those of an
#: eighth.
PART = 1 << 26

_DATED = [clock for clock in CLOCKS if CLOCKS[clock]]
_UNDATED = [clock for clock in CLOCKS if not CLOCKS[clock]]


class Clocks(NamedTuple):
    """The clocks of the times of some sets: one with a date, and one for packets without; "" if there is none."""

    dated: str
    undated: str
    covers: bool = True  # have all sets with a date times of the other clock, too?

    @property
    def best(self) -> str:
        """The clock with a date if there is one, else the other."""
        return self.dated or self.undated

    @property
    def in_order(self) -> list[str]:
        """The clocks for intervals: those of the whole log before others."""
        return [clock for clock in dict.fromkeys((self.steady, self.dated, *CLOCKS)) if clock]

    @property
    def steady(self) -> str:
        """The clock that has a time for all packets that have any, or for most sets."""
        return self.undated if self.undated and (self.covers or not self.dated) else self.dated


@dataclass
class Lost:
    """A time without a date after one with a date, by the device's clock, until there is a date again."""

    offset: int
    begin: int
    end: int | None = None


@dataclass
class TimesOfSet:
    """What is known of the times of one set."""

    valid: dict[str, int] = field(default_factory=dict)  # clock -> packets with a time
    alone: dict[str, int] = field(default_factory=dict)  # clock -> packets with such a time, but without a date
    stamped: int = 0  # packets with a timestamp that could have a date, or with timestamps of which none is valid
    lost: list[Lost] = field(default_factory=list)
    _runs: dict[str, Runs] = field(default_factory=dict)  # clock -> those of its times
    _last: dict[str, tuple[int, int]] = field(default_factory=dict)  # clock -> the last offset and time

    @property
    def stuck(self) -> dict[str, tuple[int, int]]:
        """Clock -> where it was first stuck, and the time."""
        found = {clock: runs.stuck() for clock, runs in self._runs.items()}
        return {clock: place for clock, place in found.items() if place}

    def follow(self, clock: str, offset: Array, value: Array) -> Iterator[tuple[int, int]]:
        """Adds the next times by a clock. Yields where it goes back: the packets before and after."""
        there = value != NONE
        if not there.all():
            offset, value = offset[there], value[there]
        self.valid[clock] = self.valid.get(clock, 0) + len(value)
        if not len(value):
            return
        self._runs.setdefault(clock, Runs()).add(offset, value)
        before = self._last.get(clock, (int(offset[0]), int(value[0])))
        for i in np.flatnonzero(np.diff(value, prepend=before[1]) < -BACK).tolist():
            yield int(offset[i - 1]) if i else before[0], int(offset[i])
        self._last[clock] = int(offset[-1]), int(value[-1])


class _Times(NamedTuple):
    """The times of the packets of a set that could have a date, with or without one; NONE for packets without any."""

    packet: Array
    offset: Array
    value: Array
    dated: Array


class _Event(NamedTuple):
    """A packet whose time continues the one before it in another way."""

    offset: int
    set: int
    before: tuple[int, int, bool] | None  # its offset, its value, whether that is a date
    value: int
    dated: bool
    usual: int  # interval


@dataclass
class _State:
    """The last time of a set, and how times become those of the device's clock, from some offsets on."""

    last: tuple[int, int, bool] | None = None
    usual: int = 0
    begins: list[int] = field(default_factory=list)
    bases: list[int] = field(default_factory=list)  # the date at which the clock is 0
    shifts: list[int] = field(default_factory=list)  # what a time without a date lacks


class Timeline:
    """Follows the clocks of all sets, part by part."""

    def __init__(self) -> None:
        #: Data set -> its times.
        self.sets: dict[int, TimesOfSet] = {}
        self._states: dict[int, _State] = {}
        self._base: int | None = None
        self._near = False  # is the base estimated from the packets of another set?
        self._since: int | None = None  # the first time, if it is a time of week: the clock may have begun at any other
        self._shift = 0
        self._backs: dict[str, list[tuple[int, int]]] = {clock: [] for clock in CLOCKS}

    def add(self, log: Packets) -> None:
        """Adds the next part of a log."""
        numbers = [number for number in log.sets() if number >= 0x80]
        read(log, numbers)
        both = {number: _times(log, number) for number in numbers}
        for event in sorted(event for number, own in both.items() for event in self._events(number, own)):
            self._continue(event, both)
        for number in numbers:
            times_of_set = self.sets.setdefault(number, TimesOfSet())
            has_date = np.zeros(log.packets, bool)
            has_date[both[number].packet] = both[number].dated
            stamped, timed = np.zeros(log.packets, bool), np.zeros(log.packets, bool)
            for clock in CLOCKS:
                stamps = self.stamps(log, number) if clock == DEVICE else raw(log, number, clock)
                backs = list(times_of_set.follow(clock, stamps.offset, stamps.value))
                if clock != DEVICE:
                    self._backs[clock] += backs
                packet = stamps.packet[stamps.value != NONE]
                stamped[stamps.packet], timed[packet] = True, True
                if clock in _UNDATED:
                    alone = len(packet) - int(np.count_nonzero(has_date[packet]))
                    times_of_set.alone[clock] = times_of_set.alone.get(clock, 0) + alone
            timed[both[number].packet] = False  # they could have a date
            times_of_set.stamped += int(np.count_nonzero(stamped & ~timed))

    def _events(self, number: int, own: _Times) -> Iterator[_Event]:
        """Yields where the date of a set appears or disappears, or its time without a date goes back."""
        state = self._states.setdefault(number, _State())
        there = own.value != NONE
        offset, value, dated = own.offset[there], own.value[there], own.dated[there]
        if not len(value):
            return
        _, last, mode = state.last or (0, int(value[0]), bool(dated[0]))
        steps = np.diff(value, prepend=last)
        turns = dated != np.append(mode, dated[:-1])
        rows = np.flatnonzero(turns | (~dated & (steps < -BACK))).tolist()
        if state.last is None:
            rows = [0, *rows]
        for begin, row in zip([0, *rows], [*rows, len(value)]):
            near = steps[max(begin + 1, row - 100) : row]
            if not len(near) and not state.usual:
                near = steps[row + 1 : row + 10]
            near = near[near > 0]
            state.usual = int(np.median(near)) if len(near) else state.usual
            if row < len(value):
                before = (int(offset[row - 1]), int(value[row - 1]), bool(dated[row - 1])) if row else state.last
                yield _Event(int(offset[row]), number, before, int(value[row]), bool(dated[row]), state.usual)
        state.last = int(offset[-1]), int(value[-1]), bool(dated[-1])

    def _continue(self, event: _Event, both: dict[int, _Times]) -> None:
        """Decides how the times of a set become those of the device's clock, from a packet on."""
        state = self._states[event.set]
        base, shift = (state.bases[-1], state.shifts[-1]) if state.begins else (self._base, self._shift)
        value, before = event.value, event.before
        if before is None:
            if event.dated and base is None:
                near = self._undated_near(event, both)
                base = value - (_of_week(value) if near is None else near)
                self._near, self._since = near is not None, value - base if near is None else None
        else:
            lost = self.sets.setdefault(event.set, TimesOfSet()).lost
            was = before[1] - (base or 0) if before[2] else before[1] + shift
            expected = was + event.usual
            if event.dated:
                base = value - expected
                if self._base is not None and not self._near and abs(base - self._base) < _NEAR:
                    base = self._base
                self._near = False
                if lost and lost[-1].end is None:
                    lost[-1].end = expected
            else:
                week = before[1] - _of_week(before[1]) - (base or 0) if before[2] else shift
                shifts = (0, week, week + timestamps.WEEK, self._shift)
                shift = min(shifts, key=lambda each: abs(value + each - expected))
                if abs(value + shift - expected) > _HOUR:
                    # Seconds since power-on. A device that was on before the log began continues.
                    before_log = self._since is not None and value >= was - self._since
                    shift = expected - value if before_log else 0
                self._since = None
                if value + shift < was - BACK:  # it restarts
                    self._base = None
                    self._backs[DEVICE].append((before[0], event.offset))
                elif before[2] and len(lost) < _KEPT:
                    lost.append(Lost(event.offset, expected))
        if event.dated:
            self._base = base
        else:
            self._shift = shift
        state.begins.append(event.offset)
        state.bases.append(base or 0)
        state.shifts.append(shift)

    def _undated_near(self, event: _Event, both: dict[int, _Times]) -> int | None:
        """Returns the time of another set that has no date near a packet."""
        for number, own in both.items():
            rows = np.flatnonzero(own.value != NONE)
            if number != event.set and len(rows):
                row = rows[int(np.abs(own.offset[rows] - event.offset).argmin())]
                if not own.dated[row]:
                    state = self._states[number]
                    return int(own.value[row]) + (state.shifts[-1] if state.shifts else self._shift)
        return None

    def stamps(self, log: Packets, number: int) -> Stamps:
        """Returns the times of a set by the device's clock in a part of the log; those with a date are converted."""
        own, state = _times(log, number), self._states.get(number)
        if state is None or not state.begins:
            return Stamps(own.packet, own.value, lambda: own.offset)
        which: Any = 0  # often, there is one only
        if len(state.begins) > 1:
            which = np.maximum(np.searchsorted(state.begins, own.offset, side="right") - 1, 0)
        value = own.value + np.where(own.dated, -np.array(state.bases)[which], np.array(state.shifts)[which])
        return Stamps(own.packet, np.where(own.value == NONE, NONE, value), lambda: own.offset)

    # ----------------------------------------------------------------- results

    def clocks(self, numbers: Iterable[int]) -> Clocks:
        """Chooses the clocks of some sets: the first that all of them have, else the first that any of them has."""
        own = [self.sets.get(number, TimesOfSet()) for number in numbers]

        def first(clocks: list[str]) -> str:
            has = {clock: [bool(times.valid.get(clock)) for times in own] for clock in clocks}
            return next((clock for which in (all, any) for clock in clocks if own and which(has[clock])), "")

        dated, undated = first(_DATED), first([c for c in _UNDATED if any(times.alone.get(c) for times in own)])
        return Clocks(dated, undated, all(times.valid.get(undated) for times in own if times.valid.get(dated)))

    def restarts(self, clock: str) -> list[int]:
        """Returns the offsets of the first packets after the clock went back."""
        spans: list[tuple[int, int]] = []
        for begin, end in sorted(self._backs.get(clock, ())):
            if spans and begin < spans[-1][1]:  # another set sees the same one
                spans[-1] = max(begin, spans[-1][0]), min(end, spans[-1][1])
            else:
                spans.append((begin, end))
        return [end for _, end in spans]

    def following(self) -> Timeline:
        """Returns the timeline for the next piece of a stream, whose offsets begin with 0."""
        next_one = deepcopy(self)
        next_one._backs = {clock: [] for clock in CLOCKS}
        for times in next_one.sets.values():
            times._last = {clock: (-1, value) for clock, (_, value) in times._last.items()}
        for state in next_one._states.values():
            state.last = state.last and (-1, *state.last[1:])
            state.begins, state.bases, state.shifts = [-1] * bool(state.begins), state.bases[-1:], state.shifts[-1:]
        return next_one


def of_log(log: Packets) -> Timeline:
    """Returns the timeline of the whole log of which this is a part."""
    notes = log.source.notes
    if "timeline" not in notes:
        made, whole = Timeline(), log.whole()
        for part in whole.parts(PART // 8) if whole.size > PART else (whole,):
            made.add(part)
        notes["timeline"] = made
    made = notes["timeline"]
    assert isinstance(made, Timeline)
    return made


def _times(log: Packets, number: int) -> _Times:
    """Returns the times of a set that are a date, and those of the same timestamps that are none."""
    nothing = Stamps(np.zeros(0, np.int64), np.zeros(0, np.int64), lambda: np.zeros(0, np.int64))
    dates = [raw(log, number, clock) for clock in _DATED]
    date, other = (dates or [nothing])[0], raw(log, number, DEVICE) if DEVICE in CLOCKS else nothing
    if not other.some:
        return _Times(date.packet, date.offset, date.value, date.value != NONE)
    if np.array_equal(date.packet, other.packet):
        dated = date.value != NONE
        return _Times(date.packet, date.offset, np.where(dated, date.value, other.value), dated)
    packet = distinct(date.packet, other.packet)
    offset, value, dated = np.zeros(len(packet), np.int64), np.full(len(packet), NONE, np.int64), packet < packet
    for stamps in (other, date):
        where = np.searchsorted(packet, stamps.packet)
        offset[where] = stamps.offset
        where = where[stamps.value != NONE]
        value[where] = stamps.value[stamps.value != NONE]
        dated[where] = stamps is date
    return _Times(packet, offset, value, dated)


def _of_week(date: int) -> int:
    """Returns the time of the week of a date."""
    begins, shifts = timestamps.leaps(_DATED[0])
    which = next((i for i in reversed(range(len(begins))) if date - shifts[i + 1] >= begins[i]), -1)
    return (date - shifts[which + 1]) % timestamps.WEEK
