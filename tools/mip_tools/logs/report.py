"""Reports the types, rates, gaps and damage of a log, in bounded memory."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from ..binding import CLOCKS, OVERHEAD, RawField
from ..columns.between import Gaps
from ..columns.distinct import places_among
from ..columns.intervals import Intervals
from ..columns.raw_times import raw
from ..columns.scan import HEADER, Array
from ..columns.timeline import DEVICE, Clocks, Timeline
from ..sentences import Sentences
from ..text.decoding import DecodedField, decoded_field, name_of
from . import inputs, scan

if TYPE_CHECKING:
    from ..columns import Log
    from ..columns.piece import Piece

#: Bytes of the log whose times are in memory at the same time.
PART = 1 << 23


@dataclass
class Kind:
    """The counts of one descriptor in one set."""

    name: str
    count: int = 0


@dataclass
class Report:
    """The findings, in bounded memory."""

    size: int = 0
    packets: int = 0
    malformed: int = 0
    skipped: int = 0
    runs: int = 0
    damaged: int = 0
    sentences: int = 0
    sets: dict[int, int] = field(default_factory=dict)
    fields: dict[tuple[int, int], Kind] = field(default_factory=dict)
    clocks: dict[str, dict[int, Intervals]] = field(default_factory=lambda: {clock: {} for clock in CLOCKS})
    timeline: Timeline = field(default_factory=Timeline)
    assumed: list[str] = field(default_factory=list)

    @property
    def best(self) -> Clocks:
        """The clocks of the log: the one with a date, and the one of packets without."""
        return self.timeline.clocks(self.timeline.sets)

    def clock_of(self, number: int) -> str:
        """Returns the clock of the intervals of a set: the same for all sets, if they have it."""
        return next((clock for clock in self.best.in_order if number in self.clocks[clock]), "")

    @property
    def times(self) -> dict[int, Intervals]:
        """Set -> the intervals between its packets."""
        clocks = {number: self.clock_of(number) for number in self.sets}
        return {number: self.clocks[clock][number] for number, clock in clocks.items() if clock}

    def rate(self, number: int, descriptor: int) -> float | None:
        """Returns the rate of a field in Hz."""
        times = self.times.get(number)
        return times.rate_of(descriptor) if times else None


def report_on(log: Log) -> Report:
    """Reads a log once."""
    report, between = Report(), _Between()
    progress = inputs.Progress(log.size)
    for part in log.parts(PART):
        sets: list[Array] = []
        packets: dict[tuple[int, int], list[Array]] = {}
        for piece in part.pieces():
            progress.at(piece.begin)
            between.add(piece)
            sets.append(piece.sets)
            for key, has in _add(report, piece):
                if key[0] >= 0x80:
                    packets.setdefault(key, []).append(has + piece.number)
        _add_times(report, part, sets, {key: np.concatenate(own) for key, own in packets.items()})
    if not any(times.alone.get(DEVICE) for times in report.timeline.sets.values()) and DEVICE in CLOCKS:
        report.clocks[DEVICE] = {}
    if log.whole() is log:
        log.source.notes.setdefault("timeline", report.timeline)
    report.assumed = log.assumed()
    progress.clear()
    between.damaged.end()
    report.size = log.size
    report.skipped, report.sentences = between.skipped, between.sentences
    report.runs, report.damaged = between.damaged.runs, between.damaged.count
    return report


class _Between:
    """The bytes that belong to no packet."""

    def __init__(self) -> None:
        self.damaged = scan.Damaged()
        self.skipped = 0
        self.sentences = 0
        self._sentences = Sentences()
        self._gaps = Gaps()

    def add(self, piece: Piece) -> None:
        """Adds the packets of a piece."""
        for gap in self._gaps.in_piece(piece):
            if not gap.goes_on:
                self.damaged.end()
            self.skipped += len(gap.data)
            self.damaged.feed(gap.data)
            self.sentences += len(self._sentences.feed(gap.data))


def count_malformed(piece: Piece) -> int:
    """Counts the packets with a field that runs past their end."""
    covered = np.zeros(len(piece.at), np.int64)
    for run in piece.runs or ():
        covered += np.bincount(run.packet, minlength=len(covered)) * (run.length + 2)
    return int((covered != piece.end - piece.at - OVERHEAD).sum())


def _add(report: Report, piece: Piece) -> Iterator[tuple[tuple[int, int], Array]]:
    """Counts the packets of a piece, and their fields. Yields the packets that have each field."""
    count = len(piece.at)
    report.packets += count
    for number, several in enumerate(np.bincount(piece.sets).tolist()):
        if several:
            report.sets[number] = report.sets.get(number, 0) + several
    report.malformed += count_malformed(piece)
    fields: dict[tuple[int, int], list[Any]] = {}
    for run in piece.runs or ():
        fields.setdefault((run.set, run.descriptor), []).append(run)
    for key, runs in fields.items():
        if key not in report.fields:
            report.fields[key] = Kind(name_of(first(piece, runs)))
        has = np.zeros(count, bool)
        for run in runs:
            report.fields[key].count += len(run.packet)
            has[run.packet] = True
        yield key, np.flatnonzero(has)


def first(piece: Piece, runs: list[Any]) -> DecodedField:
    """Decodes the first of some fields."""
    firsts = [(int(r.packet[0]), r.offset if isinstance(r.offset, int) else int(r.offset[0]), r) for r in runs]
    packet, offset, run = min(firsts, key=lambda first: first[:2])
    begin = int(piece.at[packet]) + HEADER + offset
    data = piece.data[begin : begin + run.length].tobytes()
    return decoded_field(RawField(run.set, run.descriptor, data))


def _add_times(report: Report, part: Log, sets: list[Array], packets: dict[tuple[int, int], Array]) -> None:
    """Adds the times of the packets of each set; `packets` are those that have each field."""
    report.timeline.add(part)
    set_of = np.concatenate(sets) if sets else np.zeros(0, np.uint8)
    for number in sorted(n for n in report.sets if n >= 0x80):
        own = np.flatnonzero(set_of == number)
        fields = {key[1]: places_among(own, has) for key, has in packets.items() if key[0] == number}
        for clock in CLOCKS:
            device = clock == DEVICE  # also of packets with a date: there may be others later
            stamps = report.timeline.stamps(part, number) if device else raw(part, number, clock)
            if stamps.some or number in report.clocks[clock]:
                report.clocks[clock].setdefault(number, Intervals()).add_set(own, stamps, fields)
