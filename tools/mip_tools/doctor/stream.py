"""Examines the packets of a stream, from a log or as they arrive, in one pass and in bounded memory."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

from ..binding import CLOCKS, SECOND, SYNC, BitsInfo, Packet, info
from ..cli import show
from ..cli.clocks import dated, moments
from ..cli.decoding import decoded, name_of, raw_fields
from ..cli.scan import Piece
from .events import Event, merged
from .rhythm import Change, Gap, Moment, Rhythm

_SENTENCE = re.compile(rb"\$[ -~]*\r?\n")
#: A field has stopped, or was started, if it is so many of its intervals and seconds away from the end or the begin.
_AWAY, _AWAY_SECONDS = 5, 1.0
#: The time by one clock and that by another may drift apart by so much between two packets.
_STEP = SECOND // 20
#: A shorter gap is not a pause.
_SHORT = 0.5
#: How many events are kept; more are counted.
MOST = 5000


@dataclass
class Warned:
    """A bit that is set in data, with what it is about."""

    field: str
    bit: str
    text: str
    concerns: tuple[str, ...]
    count: int
    total: int
    last: bool  # is it set in the last field?


@dataclass
class Examined:
    """What was found."""

    size: int = 0
    packets: int = 0
    clock: str | None = None
    events: list[Event] = field(default_factory=list)
    warned: list[Warned] = field(default_factory=list)
    unsynchronized: dict[int, tuple[int, int]] = field(default_factory=dict)  # set -> invalid times, and all
    untimed: list[int] = field(default_factory=list)  # sets without timestamps
    rates: dict[tuple[int, int], float] = field(default_factory=dict)  # set and descriptor -> Hz, the last rhythm
    names: dict[tuple[int, int], str] = field(default_factory=dict)
    spans: dict[int, list[tuple[int, int]]] = field(default_factory=dict)  # set -> when its packets came, in ns
    sentences: int = 0
    unnamed: list[str] = field(default_factory=list)  # fields whose flags depend on the device


class Examination:
    """Takes packets, and the bytes between them, in order."""

    def __init__(self, device: str | None = None) -> None:
        self._device = device
        self.result = Examined()
        self._events: list[Event] = []
        self._rhythms: dict[tuple[int, int], Rhythm] = {}
        self._names: dict[tuple[int, int], str] = {}
        self._last: dict[int, dict[str, int]] = {}  # set -> clock -> time of its last packet
        self._ends: dict[int, int] = {}  # set -> where its last packet ended
        self._base: dict[int, str] = {}  # set -> the clock by which its rhythm is followed
        self._origins: dict[str, int] = {}  # clock -> its first time
        self._latest: dict[str, int] = {}  # clock -> its last time
        self._reset = False
        self._bits: dict[tuple[int, int], Counter[str]] = {}
        self._counts: Counter[tuple[int, int]] = Counter()
        self._now: dict[tuple[int, int], int] = {}
        self._flags: dict[tuple[int, int], Any] = {}
        self._damage: tuple[int, bytes] | None = None
        self._time: int | None = None
        self._timed: set[int] = set()
        self._sets: Counter[int] = Counter()
        self._invalid: dict[int, list[int]] = {}
        self._at = 0

    def feed(self, pieces: Iterable[Piece]) -> None:
        for piece in pieces:
            self._at = piece.offset + len(piece.data)
            self.result.size += len(piece.data)
            if piece.packet is None:
                begin, held = self._damage or (piece.offset, b"")
                self._damage = begin, (held + piece.data)[-65536:]
            else:
                self._between(False)
                self._packet(piece.packet, piece.offset, piece.offset + len(piece.data))

    def end(self) -> Examined:
        """What was found, when there is no more."""
        self._between(True)
        self._started_and_stopped()
        result = self.result
        result.events = merged(self._events)
        result.untimed = [number for number in self._sets if number >= 0x80 and number not in self._timed]
        result.unsynchronized = {n: (bad, all) for n, (bad, all) in self._invalid.items() if bad}
        result.rates = {k: SECOND / r.usual for k, r in self._rhythms.items() if r.usual}
        result.names = dict(self._names)
        result.warned = list(self._warned())
        return result

    # ------------------------------------------------------------------ bytes between packets

    def _between(self, at_end: bool) -> None:
        if self._damage is None:
            return
        (begin, data), self._damage = self._damage, None
        self.result.sentences += len(_SENTENCE.findall(data))
        rest = _SENTENCE.sub(b"", data).strip(b"\r\n")
        cut_off = at_end and ((SYNC.startswith(rest[:2]) and len(rest) < 4) or "missing" in show.damage(rest))
        if not rest or begin == 0 or cut_off:
            return  # a recording begins and ends anywhere
        said = f"{len(rest)} bytes are not packets{': ' if show.damage(rest) else ''}{show.damage(rest)}"
        self._note(Event("line damage", begin, begin + len(data), self._time, details=[said]))

    def _note(self, event: Event) -> None:
        last = next((e for e in reversed(self._events[-8:]) if e.cause == event.cause and e.overlaps(event)), None)
        if last is not None:
            last.absorb(event)
        elif len(self._events) < MOST:
            self._events.append(event)

    # ------------------------------------------------------------------ packets

    def _packet(self, packet: Packet, begin: int, end: int) -> None:
        self.result.packets += 1
        number = packet.set
        self._sets[number] += 1
        if number < 0x80:
            return
        said = moments(packet)
        for clock, time in said.items():
            if dated(clock):
                counts = self._invalid.setdefault(number, [0, 0])
                counts[0] += time is None
                counts[1] += 1
        times = {clock: time for clock, time in said.items() if time is not None}
        if times:
            self._timed.add(number)
            self._clocks(number, times, begin, end)
        beat = times.get(self._base.get(number, ""))
        others = self.result.packets - self._sets[number]
        for raw in raw_fields(packet):
            key = number, raw.descriptor
            self._counts[key] += 1
            if key not in self._names:
                self._names[key] = name_of(decoded(raw))
            self._look(key, raw)
            if beat is not None:
                self._beat(key, Moment(beat, begin, end, others))
        self._ends[number] = end

    def _clocks(self, number: int, times: dict[str, int], begin: int, end: int) -> None:
        """Compares the clocks with those of the last packet of the set."""
        best = next(c for c in CLOCKS if c in times)
        if self.result.clock is None or list(CLOCKS).index(best) < list(CLOCKS).index(self.result.clock):
            self.result.clock, self._time = best, times[best]
            self.result.spans.clear()
        if self.result.clock in times:
            self._time = times[self.result.clock]
            self._span(number, self._time)
        before = self._last.get(number, {})
        at = self._ends.get(number, begin)
        steps = {c: times[c] - before[c] for c in times if c in before}
        # The clock that has no date runs on when the date is set.
        base = self._base.setdefault(number, next(c for c in reversed(list(CLOCKS)) if c in times))
        if base in times:
            self._origins.setdefault(base, times[base])
            self._latest[base] = times[base]
        if steps.get(base, 0) < 0:
            cause = "clock step" if dated(base) else "reset"
            note = f"the {base} clock goes back by {-steps[base] / SECOND:.3f} s"
            self._note(Event(cause, at, begin, self._time, sets={number}, details=[note]))
            self._restart(number, cause == "reset")
        elif base in steps:
            for clock, step in steps.items():
                apart = step - steps[base]
                if abs(apart) > _STEP:
                    note = f"the {clock} clock jumps by {apart / SECOND:+.3f} s against the {base} clock"
                    self._note(Event("clock step", at, begin, self._time, sets={number}, details=[note]))
        self._last[number] = times

    def _restart(self, number: int, reset: bool) -> None:
        for (set, _), rhythm in self._rhythms.items():
            if set == number:
                rhythm.restart()
        self._reset = self._reset or reset

    def _span(self, number: int, time: int) -> None:
        """Packets that follow each other within a second, or three usual intervals, are one span."""
        spans = self.result.spans.setdefault(number, [])
        usual = max((r.usual or 0 for (n, _), r in self._rhythms.items() if n == number), default=0)
        if spans and 0 <= time - spans[-1][1] <= max(SECOND // 4, 1.5 * usual):
            spans[-1] = spans[-1][0], time
        elif len(spans) < MOST:
            spans.append((time, time))

    def _beat(self, key: tuple[int, int], moment: Moment) -> None:
        rhythm = self._rhythms.get(key)
        if rhythm is None:
            rhythm = self._rhythms[key] = Rhythm()
        for change in rhythm.add(moment):
            if isinstance(change, Gap):
                self._gap(key, change)
            else:
                self._changed(key, change)

    def _gap(self, key: tuple[int, int], gap: Gap) -> None:
        seconds = (gap.after.time - gap.before.time - gap.usual) / SECOND
        # When all pause, each other set may still have a packet at the begin and one at the end.
        went_on = gap.after.others - gap.before.others > 2 * (len(self._ends) - 1)
        cause = "overload" if went_on or seconds < _SHORT else "pause"
        event = Event(cause, gap.before.end, gap.after.begin, self._time, seconds, {key[0]})
        if cause == "pause" and dated(self._base[key[0]]):
            event.details.append("or the time was set: there is no clock without a date to compare it with")
        self._note(event)

    def _changed(self, key: tuple[int, int], change: Change) -> None:
        note = f"{self._names[key]}: {SECOND / change.old:.4g} Hz became {SECOND / change.new:.4g} Hz"
        at = change.at
        self._note(Event("changed format", at.begin, at.end, self._time, sets={key[0]}, details=[note]))

    def _started_and_stopped(self) -> None:
        """Fields that came later than the others, or ended before them."""
        for key, rhythm in self._rhythms.items():
            if rhythm.usual is None or rhythm.last is None or rhythm.first is None:
                continue
            away = max(_AWAY * rhythm.usual, _AWAY_SECONDS * SECOND)
            name, base = self._names[key], self._base[key[0]]
            if self._latest[base] - rhythm.last.time > away:
                at = rhythm.last
                event = Event("changed format", at.end, at.end + 1, self._time, sets={key[0]})
                event.details.append(f"{name} stopped")
                self._note(event)
            if not self._reset and rhythm.first.time - self._origins[base] > away:
                at = rhythm.first
                event = Event("changed format", at.begin, at.begin + 1, self._time, sets={key[0]})
                event.details.append(f"{name} started")
                self._note(event)

    # ------------------------------------------------------------------ flags

    def _look(self, key: tuple[int, int], raw: Any) -> None:
        """Counts the bits that concern something."""
        places = self._flags.get(key)
        if places is None:
            places = self._flags[key] = self._places(decoded(raw).kind)
        if not places:
            return
        value = decoded(raw).value
        if value is None:
            return
        bits = self._bits.setdefault(key, Counter())
        for attribute, members in places:
            number = int(getattr(value, attribute) or 0)
            for bit in members:
                if number & bit.mask:
                    bits[bit.name] += 1
                    self._now[key] = self._counts[key]

    def _places(self, kind: Any) -> list[tuple[str, list[Any]]]:
        if kind is None:
            return []
        places = []
        for p in info(kind).parameters:
            if p.variants and self._device is None and any("type" in v.changes for v in p.variants):
                self.result.unnamed += [kind.NAME] if kind.NAME not in self.result.unnamed else []
            here = p.on(self._device) if self._device is not None else p
            if here.type is None or p.kind != "scalar":
                continue
            said = info(here.type)
            if isinstance(said, BitsInfo):
                places.append((p.attribute, [bit for bit in said.bits if bit.concerns]))
        return [(name, bits) for name, bits in places if bits]

    def _warned(self) -> Iterable[Warned]:
        for key, bits in self._bits.items():
            known = {bit.name: bit for _, members in self._flags[key] for bit in members}
            for name, count in bits.items():
                bit = known[name]
                last = self._now.get(key) == self._counts[key]
                yield Warned(self._names[key], name, bit.text, bit.concerns, count, self._counts[key], last)


__all__ = ["Examination", "Examined", "Warned"]
