"""Examines a log, or data received from a device, in one pass and in bounded memory."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import partial
from typing import NamedTuple

import numpy as np

from ..binding import CLOCKS, SECOND
from ..columns import Log, timeline, times
from ..columns.distinct import distinct, places_among
from ..columns.intervals import Intervals, common_spans, seconds_of
from ..columns.scan import Array
from ..columns.stamps import NONE
from ..logs import inputs, recognize
from ..logs.report import count_malformed
from ..text.clocks import dated
from ..text.decoding import name_of
from ..text.numbers import hertz
from .events import Event, merged_events
from .examined import Examined, Key
from .flags import Flags
from .part import Line, Part
from .rhythm import Change, Gap, Moment, Rhythm, intervals
from .skipped import Damage, Skipped
from .values import Values

#: Bytes of the log that are examined at once.
PART = 1 << 23
#: A field has stopped, or was started, if this many intervals and seconds separate it from the end or the beginning.
_AWAY, _AWAY_SECONDS = 5, 1.0
#: The times of two clocks may drift apart by this much between two packets.
_STEP = SECOND // 20
#: A shorter gap is not a pause.
_SHORT = 0.5
#: The number of packets with a time like that of an earlier one that are compared with it, and the bytes before them.
_COMPARED, _BEFORE = 1000, 1 << 17
#: The number of packets before one that is out of order in which its place is looked for.
_NEAR = 200
#: The number of events that are kept.
MOST = 5000


def examine_log(log: Log) -> Examined:
    """Examines a log, reading it once."""
    examination, progress = Examination(log), inputs.Progress(log.size)
    for part in log.parts(PART):
        examination.add(part, progress)
    progress.clear()
    return examination.end()


@dataclass
class _Set:
    """What is known of a descriptor set so far."""

    first: int  # offset of its first packet
    count: int = 0
    end: int | None = None  # of its last packet
    base: str = ""  # the clock by which its rhythm is followed
    last: dict[str, int] = field(default_factory=dict)  # clock -> time of its last packet
    intervals: Intervals = field(default_factory=Intervals)


class _Noted(NamedTuple):
    """An event, and where it was detected: the packet, and the position in it."""

    at: int
    order: int
    event: Event


class Examination:
    """Examines the parts of a log in order."""

    def __init__(self, log: Log) -> None:
        line = timeline.of_log(log)
        begin = recognize.begin_of(log)
        self.result = Examined(log.size, begin, clock=line.clocks(line.sets).steady or None, times=line.sets)
        self._events: list[Event] = []
        self._noted: list[_Noted] = []
        self._skipped = Skipped()
        self._flags = Flags(log)
        self._sender = log.sender
        self._values = Values()
        self._sets: dict[int, _Set] = {}
        self._in_order = line.clocks(line.sets).in_order
        self._rhythms: dict[Key, Rhythm] = {}
        self._origins: dict[str, tuple[int, int]] = {}  # clock -> the offset of its first time, and this time
        self._latest: dict[str, tuple[int, int]] = {}  # clock -> the offset of its last time, and this time
        self._reset = False
        self._time: int | None = None

    def add(self, log: Log, progress: inputs.Progress) -> None:
        """Examines the next part."""
        part = Part(log, self.result.names)
        for piece in log.pieces():
            progress.at(piece.begin)
            part.add(piece)
            self.result.malformed += count_malformed(piece)
            self._damaged(self._skipped.add(piece))
        part.complete()
        for key, first in part.new.items():
            self.result.names[key] = name_of(first)
            self._flags.watch(key, first.kind)
            self._values.watch(key, first.kind, self.result.names[key])
        self._flags.add(log)
        for number, packets in part.sets.items():
            self._sets.setdefault(number, _Set(int(part.at[packets[0]])))
        for number in part.sets:
            self._rhythm(part, number, self._clocks(part, number))
            self._spans(part, number)
            self._intervals(part, number)
        for number, packets in part.sets.items():
            self._sets[number].count += len(packets)
            self._sets[number].end = int(part.end[packets[-1]])
        self.result.packets += len(part.at)
        clock = self.result.clock
        valid = [part.valid(number, clock) for number in part.sets] if clock else []
        line = Line([(part.at[packets], time) for packets, time in valid], self._time)
        self._values.add(log, line.at)
        self._note(line)

    def end(self) -> Examined:
        """Ends the examination, and returns the results."""
        self._damaged(self._skipped.end())
        self._note(Line([], self._time))
        self._started_and_stopped()
        result = self.result
        result.events = merged_events([*self._events, *self._values.events()])
        result.untimed = [n for n, state in self._sets.items() if not state.base and not result.times[n].stamped]
        rates = {
            (number, descriptor): self._sets[number].intervals.rate_of(descriptor)
            for number, descriptor in result.names
            if number in self._sets
        }
        same = [s.intervals for n, s in self._sets.items() if result.clock and result.times[n].valid.get(result.clock)]
        result.seconds = seconds_of(common_spans(same))
        result.rates = {key: rate for key, rate in rates.items() if rate}
        result.sentences = self._skipped.sentences
        result.unnamed = self._flags.unnamed
        result.devices = self._sender.titles
        result.warned = list(self._flags.warned(result.names))
        result.seldom_valid = list(self._flags.seldom_valid())
        return result

    # ------------------------------------------------------------------ events

    def _damaged(self, damages: Iterator[Damage]) -> None:
        for begin, end, text, cause in damages:
            self._noted.append(_Noted(begin, 0, Event(cause, begin, end, None, details=[text])))

    def _note(self, line: Line) -> None:
        """Stores the detected events with their times, in the order in which they were detected."""
        for noted in sorted(self._noted, key=lambda noted: noted[:2]):
            noted.event.time = line.at(noted.at)
            self._keep(noted.event)
        self._noted.clear()
        self._time = line.last

    def _keep(self, event: Event) -> None:
        last = next((e for e in reversed(self._events[-8:]) if e.cause == event.cause and e.overlaps(event)), None)
        if last is not None:
            last.absorb(event)
        elif len(self._events) < MOST:
            self._events.append(event)

    # ------------------------------------------------------------------ clocks

    def _clocks(self, part: Part, number: int) -> Array:
        """Compares the clocks of a set. Returns the packets at which the clock that times its rhythm restarts."""
        state, sets = self._sets[number], part.sets[number]
        stamps_by_clock = {clock: part.times(number, clock) for clock in CLOCKS}
        packets = distinct(*(part.valid(number, clock)[0] for clock in CLOCKS))
        if not len(packets):
            return np.asarray(packets)
        value = {clock: times.exact_times(stamps, packets) for clock, stamps in stamps_by_clock.items()}
        # The clock without a date continues when the date is set.
        state.base = state.base or next(c for c in reversed(list(CLOCKS)) if value[c][0] != NONE)
        value = {clock: np.append(state.last.get(clock, NONE), value[clock]) for clock in CLOCKS}
        there = {clock: value[clock] != NONE for clock in CLOCKS}
        both = {clock: there[clock][1:] & there[clock][:-1] for clock in CLOCKS}
        steps = {clock: np.where(both[clock], intervals(value[clock]), 0) for clock in CLOCKS}

        def note(row: int, cause: str, text: str, whole: bool = False) -> None:
            packet = int(packets[row])
            begin, earlier = int(part.at[packet]), part.before(number, packet)
            end = int(part.end[sets[earlier - 1]]) if earlier else state.end
            event = Event(cause, begin if end is None else end, begin, None, sets={number}, details=[text])
            if whole:  # with the packets before and after, whose intervals are not those of the device
                event.begin, event.end = int(part.at[sets[max(earlier - 1, 0)]]), int(part.end[packet])
            self._noted.append(_Noted(begin, 0, event))

        def step(row: int, clock: str) -> int:
            return int(value[clock][row + 1]) - int(value[clock][row])

        for row in np.flatnonzero(both[state.base] & (steps[state.base] == 0))[:_COMPARED].tolist():
            if _repeats(part, int(packets[row])):
                note(row, "duplicated", "a packet is repeated")
        back = np.flatnonzero(steps[state.base] < 0)
        explained = []
        for row in back[:_COMPARED].tolist():
            seconds = -step(row, state.base) / SECOND
            if _repeats(part, int(packets[row])):
                note(row, "duplicated", f"the packets of {seconds:.3f} s are repeated")
                explained.append(row)
            elif _fills_a_hole(value[state.base][max(0, row - _NEAR) : row + 1], int(value[state.base][row + 1])):
                note(row, "out of order", f"a packet is {seconds:.3f} s older than the one before", whole=True)
                explained.append(row)
        back = back[~np.isin(back, explained)]
        for row in back.tolist():
            dates = any(both[clock][row] for clock in CLOCKS if dated(clock))
            cause = "clock step" if dated(state.base) or (dates and state.base == timeline.DEVICE) else "reset"
            self._reset = self._reset or cause == "reset"
            note(row, cause, f"the {state.base} clock goes back by {-step(row, state.base) / SECOND:.3f} s")
        runs_on = both[state.base] & (steps[state.base] >= 0)
        for clock in CLOCKS:
            apart = both[clock] & runs_on & (np.abs(steps[clock] - steps[state.base]) > _STEP)
            for row in np.flatnonzero(apart).tolist():
                seconds = (step(row, clock) - step(row, state.base)) / SECOND
                note(row, "clock step", f"the {clock} clock jumps by {seconds:+.3f} s against the {state.base} clock")
        state.last = {clock: int(value[clock][-1]) for clock in CLOCKS if value[clock][-1] != NONE}
        return np.asarray(packets[back])

    def _spans(self, part: Part, number: int) -> None:
        """Collects the spans of a set: packets within a quarter of a second, or 1.5 usual intervals, are one span."""
        if self.result.clock is None:
            return
        spans = self.result.spans.setdefault(number, [])
        _, time = part.valid(number, self.result.clock)
        usual = max((r.usual or 0 for (n, _), r in self._rhythms.items() if n == number), default=0)
        if not len(time):
            return
        steps = intervals(np.append(spans[-1][1] if spans else time[0], time))
        new = (steps < 0) | (steps > max(SECOND // 4, 1.5 * usual))
        new[0] |= not spans
        begins = np.flatnonzero(new).tolist()
        ends = [*begins, len(time)]
        if ends[0]:
            spans[-1] = spans[-1][0], int(time[ends[0] - 1])
        for begin, end in zip(begins[: MOST - len(spans)], ends[1:]):
            spans.append((int(time[begin]), int(time[end - 1])))

    def _intervals(self, part: Part, number: int) -> None:
        """Adds what the rates of the fields of a set follow from, as in `mip info`."""
        state, valid = self._sets[number], self.result.times[number].valid
        clock = next((clock for clock in self._in_order if valid.get(clock)), "")
        if clock:
            own = part.sets[number]
            having = {key[1]: distinct(packets) for key, packets in part.packets.items() if key[0] == number}
            fields = {descriptor: places_among(own, packets) for descriptor, packets in having.items()}
            state.intervals.add_set(own, times.read_timestamps(part.log, number, clock), fields)

    # ------------------------------------------------------------------ rhythms

    def _rhythm(self, part: Part, number: int, restarts: Array) -> None:
        """Follows the fields of a set."""
        base = self._sets[number].base
        if not base:
            return
        packets, beats = part.valid(number, base)
        if len(packets):
            first, last = ((int(part.at[packets[i]]), int(beats[i])) for i in (0, -1))
            self._origins[base] = min(first, self._origins.get(base, first))
            self._latest[base] = max(last, self._latest.get(base, last))
        for key in dict.fromkeys((*self._rhythms, *part.packets)):
            if key[0] == number:
                packets = part.packets.get(key, packets[:0])
                beats = times.exact_times(part.times(number, base), packets)
                self._follow(part, key, packets[beats != NONE], beats[beats != NONE], restarts)

    def _follow(self, part: Part, key: Key, packets: Array, beats: Array, restarts: Array) -> None:
        """Follows a field in packets that have a time."""
        if key not in self._rhythms:
            if not len(packets):
                return
            self._rhythms[key] = Rhythm()
        number = key[0]
        cuts = np.searchsorted(packets, restarts)
        for i, (some, when) in enumerate(zip(np.split(packets, cuts), np.split(beats, cuts))):
            if i:  # the clock restarts; the usual interval remains
                self._rhythms[key] = Rhythm(self._rhythms[key].usual)
            for row, change in self._rhythms[key].follow(when, partial(self._moment, part, number, some, when)):
                at = int(part.at[some[row]])
                event = self._gap(number, change, at) if isinstance(change, Gap) else self._changed(key, change)
                self._noted.append(_Noted(at, part.order[key], event))

    def _moment(self, part: Part, number: int, packets: Array, beats: Array, row: int) -> Moment:
        """Describes one of the packets of a field."""
        packet = int(packets[row])
        same = self._sets[number].count + part.before(number, packet)
        others = self.result.packets + packet - same
        return Moment(int(beats[row]), int(part.at[packet]), int(part.end[packet]), others)

    def _gap(self, number: int, gap: Gap, seen_before: int) -> Event:
        """Makes the event of a gap, which was detected when packets arrived on time again, at offset `seen_before`."""
        seconds = (gap.after.time - gap.before.time - gap.usual) / SECOND
        # Even if all sets pause, each other set may have a packet at the beginning of the gap and one at its end.
        sets = sum(state.first < seen_before for state in self._sets.values())
        went_on = gap.after.others - gap.before.others > 2 * (sets - 1)
        cause = "overload" if went_on or seconds < _SHORT else "pause"
        event = Event(cause, gap.before.end, gap.after.begin, None, seconds, {number})
        if cause == "pause" and dated(self._sets[number].base):
            event.details.append("or the time was set: no clock without a date allows a comparison")
        return event

    def _changed(self, key: Key, change: Change) -> Event:
        text = f"{self.result.names[key]}: {hertz(SECOND / change.old)} Hz became {hertz(SECOND / change.new)} Hz"
        return Event("changed format", change.at.begin, change.at.end, None, sets={key[0]}, details=[text])

    def _started_and_stopped(self) -> None:
        """Finds fields that began later than the others, or ended before them."""
        for key, name in self.result.names.items():
            rhythm = self._rhythms.get(key)
            if rhythm and rhythm.first and (least := rhythm.lossy()):
                text = f"{name}: intervals are multiples of {least / SECOND:.3g} s: packets are missing all the time"
                at = rhythm.first
                self._keep(Event("overload", at.begin, at.end, at.time, sets={key[0]}, details=[text]))
            if rhythm is None or rhythm.usual is None or rhythm.last is None or rhythm.first is None:
                continue
            away = max(_AWAY * rhythm.usual, _AWAY_SECONDS * SECOND)
            base = self._sets[key[0]].base
            if self._latest[base][1] - rhythm.last.time > away:
                self._limit(key, rhythm.last.end, f"{name} stopped")
            if not self._reset and rhythm.first.time - self._origins[base][1] > away:
                self._limit(key, rhythm.first.begin, f"{name} started")

    def _limit(self, key: Key, at: int, text: str) -> None:
        self._keep(Event("changed format", at, at + 1, self._time, sets={key[0]}, details=[text]))


def _fills_a_hole(times: Array, late: int) -> bool:
    """Is there a place for a time among those before it, because a later packet arrived first?"""
    times = np.sort(times[times != NONE])
    steps = np.diff(times)
    place = int(np.searchsorted(times, late))
    return 0 < place < len(times) and bool(steps[place - 1] > 1.5 * np.median(steps[steps > 0]))


def _repeats(part: Part, packet: int) -> bool:
    """Does a packet also occur in the bytes before it?"""
    begin, end = int(part.at[packet]), int(part.end[packet])
    first = max(0, begin - _BEFORE)
    data, _ = part.log.source.piece(first, end - first, 0)
    text = data.tobytes()
    return text.find(text[begin - first :], 0, begin - first) >= 0
