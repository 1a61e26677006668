"""Finds the bytes of a log that belong to no packet, and the NMEA sentences in them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

import numpy as np

from ..binding import REACH
from ..sentences import Sentences
from . import times
from .packets import Packets
from .piece import Piece
from .scan import Array
from .stamps import NONE
from .tables import Series, Table, time_column

#: Bytes of the log that are searched at once.
PART = 1 << 23


class Gap(NamedTuple):
    """The bytes between two packets that are in one piece."""

    offset: int  # in the file
    data: bytes
    goes_on: bool  # it continues the previous gap


class Gaps:
    """Finds the gaps of a log, piece by piece."""

    def __init__(self) -> None:
        self._free = 0  # the end of the last packet
        self._end = -1  # of the last gap

    def in_piece(self, piece: Piece) -> Iterator[Gap]:
        """Yields the gaps in the next piece."""
        first = max(0, self._free - piece.begin)
        begins = np.concatenate(([first], piece.end))
        ends = np.concatenate((piece.at, [max(first, piece.size)]))
        places = np.flatnonzero(ends > begins)
        if len(piece.at):
            self._free = piece.begin + int(piece.end[-1])
        for begin, end in zip(begins[places].tolist(), ends[places].tolist()):
            offset = piece.begin + begin
            goes_on, self._end = offset == self._end, piece.begin + end
            yield Gap(offset, piece.data[begin:end].tobytes(), goes_on)


def nmea_sentences(log: Packets) -> Iterator[tuple[int, str]]:
    """Yields the NMEA sentences of a log that have a correct checksum, each with its offset in the file."""
    gaps, finder = Gaps(), Sentences()
    fed, places = 0, [(0, 0)]  # for each gap: the bytes fed to the parser before it, and its offset
    for part in log.parts(PART):
        for piece in part.pieces(fields=False):
            for gap in gaps.in_piece(piece):
                places.append((fed, gap.offset))
                for place, text in finder.placed(gap.data):
                    while len(places) > 1 and places[1][0] <= place:
                        places.pop(0)
                    yield places[0][1] + place - places[0][0], text
                fed += len(gap.data)


def nmea_table(log: Packets, clocks: Iterable[str]) -> Table:
    """Makes the table of the NMEA sentences of a log, with the times of the last packet before each."""
    rows = list(nmea_sentences(log))
    offset = np.array([at for at, _ in rows], np.int64)
    columns = [time_column(_before(log, clock, offset), clock) for clock in clocks if clock]
    if columns:
        columns.append(Series("time_own", np.zeros(len(rows), bool), None, {}))
    columns.append(Series("offset", offset, None, {}))
    parts = [text[1:].rpartition("*")[0].split(",") for _, text in rows]
    for name, values in (
        ("talker", [head[:1] if head.startswith("P") else head[:2] for head, *_ in parts]),
        ("type", [head[1:] if head.startswith("P") else head[2:] for head, *_ in parts]),
        ("sentence", [text for _, text in rows]),
    ):
        texts = np.empty(len(rows), object)
        texts[:] = values
        columns.append(Series(name, texts, None, {}))
    fields = np.empty(len(rows), object)
    fields[:] = [rest for _, *rest in parts] if rows else []
    columns.append(Series("fields", fields, None, {}, (1, "|O")))
    return Table(columns, [])


def _before(log: Packets, clock: str, offset: Array) -> Array:
    """Returns the last valid timestamp of any packet shortly before each offset."""
    stamps = [times.read_timestamps(log, number, clock) for number in log.sets() if number >= 0x80]
    where = np.concatenate([s.offset for s in stamps if s.some] or [np.zeros(0, np.int64)])
    value = np.concatenate([s.value for s in stamps if s.some] or [np.zeros(0, np.int64)])
    there = value != NONE
    order = np.argsort(where[there], kind="stable")
    where, value = where[there][order], value[there][order]
    last = np.searchsorted(where, offset) - 1
    before = np.full(len(offset), NONE, np.int64)
    near = (last >= 0) & (offset - where[last] <= REACH) if len(where) else np.zeros(len(offset), bool)
    before[near] = value[last[near]]
    return before
