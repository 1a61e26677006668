"""What is in a log, by its columns: the same as packet by packet, but faster."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..binding import OVERHEAD, RawField
from ..columns import times
from ..columns.scan import HEADER
from ..sentences import Sentences
from . import inputs, scan
from .clocks import CLOCKS
from .decoding import decoded, name_of
from .intervals import Intervals

if TYPE_CHECKING:
    from ..columns import Log
    from ..columns.piece import Piece
    from .info import Report

#: Bytes of the log whose times are in memory together.
PART = 1 << 26


def examine(report: Report, log: Log) -> None:
    """Adds what is in a log to a report that is empty."""
    between = _Between()
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


class _Between:
    """The bytes that belong to no packet."""

    def __init__(self) -> None:
        self.damaged = scan.Damaged()
        self.skipped = 0
        self.sentences = 0
        self._sentences = Sentences()
        self._free = 0

    def add(self, piece: Piece) -> None:
        """Those of a piece."""
        first = max(0, self._free - piece.begin)
        begins = np.concatenate(([first], piece.end))
        ends = np.concatenate((piece.at, [max(first, piece.size)]))
        places = np.flatnonzero(ends > begins)
        if len(piece.at):
            self._free = piece.begin + int(piece.end[-1])
            if not len(places) or places[0]:
                self.damaged.end()
        for place, begin, end in zip(places.tolist(), begins[places].tolist(), ends[places].tolist()):
            data = piece.data[begin:end].tobytes()
            self.skipped += len(data)
            self.damaged.feed(data)
            self.sentences += len(self._sentences.feed(data))
            if place < len(piece.at):
                self.damaged.end()


def _add(report: Report, piece: Piece) -> None:
    """Counts the packets of a piece, and their fields."""
    from .info import Kind

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
            report.fields[key] = Kind(_name(piece, runs))
        kind = report.fields[key]
        has = np.zeros(count, bool)
        for run in runs:
            kind.count += len(run.packet)
            has[run.packet] = True
        kind.packets += int(has.sum())


def _name(piece: Piece, runs: list[Any]) -> str:
    """The name of the first one of some fields."""
    firsts = [(int(r.packet[0]), r.offset if isinstance(r.offset, int) else int(r.offset[0]), r) for r in runs]
    packet, offset, run = min(firsts, key=lambda first: first[:2])
    begin = int(piece.at[packet]) + HEADER + offset
    data = piece.data[begin : begin + run.length].tobytes()
    return name_of(decoded(RawField(run.set, run.descriptor, data)))


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
