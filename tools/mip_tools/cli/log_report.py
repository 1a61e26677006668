"""Reports the types, rates, gaps and damage of a log, in bounded memory."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from ..binding import OVERHEAD, RawField
from ..columns import times
from ..columns.between import Gaps
from ..columns.scan import HEADER
from ..sentences import Sentences
from . import inputs, scan
from .clocks import CLOCKS
from .decoding import Found, decoded, name_of
from .intervals import Intervals

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
    packets: int = 0


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

    @property
    def clock(self) -> str | None:
        """The best clock that the log has."""
        return next((clock for clock in CLOCKS if self.clocks[clock]), None)

    @property
    def times(self) -> dict[int, Intervals]:
        """Set -> the intervals between its packets, by the best clock."""
        return self.clocks[self.clock] if self.clock else {}


def examine(log: Log) -> Report:
    """Reads a log once."""
    report, between = Report(), _Between()
    progress = inputs.Progress(log.size)
    for part in log.parts(PART):
        for piece in part.pieces():
            progress.at(piece.begin)
            between.add(piece)
            _add(report, piece)
        _add_times(report, part)
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
        for gap in self._gaps.of(piece):
            if not gap.goes_on:
                self.damaged.end()
            self.skipped += len(gap.data)
            self.damaged.feed(gap.data)
            self.sentences += len(self._sentences.feed(gap.data))


def _add(report: Report, piece: Piece) -> None:
    """Counts the packets of a piece, and their fields."""
    count = len(piece.at)
    report.packets += count
    for number, several in enumerate(np.bincount(piece.sets()).tolist()):
        if several:
            report.sets[number] = report.sets.get(number, 0) + several
    covered = np.zeros(count, np.int64)
    fields: dict[tuple[int, int], list[Any]] = {}
    for run in piece.runs or ():
        covered += np.bincount(run.packet, minlength=count) * (run.length + 2)
        fields.setdefault((run.set, run.descriptor), []).append(run)
    report.malformed += int((covered != piece.end - piece.at - OVERHEAD).sum())
    for key, runs in fields.items():
        if key not in report.fields:
            report.fields[key] = Kind(name_of(first(piece, runs)))
        kind = report.fields[key]
        has = np.zeros(count, bool)
        for run in runs:
            kind.count += len(run.packet)
            has[run.packet] = True
        kind.packets += int(has.sum())


def first(piece: Piece, runs: list[Any]) -> Found:
    """Decodes the first of some fields."""
    firsts = [(int(r.packet[0]), r.offset if isinstance(r.offset, int) else int(r.offset[0]), r) for r in runs]
    packet, offset, run = min(firsts, key=lambda first: first[:2])
    begin = int(piece.at[packet]) + HEADER + offset
    data = piece.data[begin : begin + run.length].tobytes()
    return decoded(RawField(run.set, run.descriptor, data))


def _add_times(report: Report, part: Log) -> None:
    """Adds the times of the packets of each set."""
    for number in sorted(n for n in report.sets if n >= 0x80):
        for clock in CLOCKS:
            known = times.read(part, number, clock)
            valid = known.value != times.NONE
            if known.some:
                sets = report.clocks[clock]
                intervals = sets.setdefault(number, Intervals())
                intervals.add_all(known.value[valid], known.offset[valid])


__all__ = ["Kind", "Report", "examine", "first"]
