"""A part of a log, prepared for examination."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np

from ..columns import Log, times, walk
from ..columns.piece import Piece
from ..columns.scan import Array
from ..columns.stamps import NONE, Stamps
from ..logs.report import first
from ..text.decoding import DecodedField
from .examined import Key


class Part:
    """The packets of a part of a log, numbered from 0, and the data fields in them."""

    def __init__(self, log: Log, known_fields: Collection[Key]) -> None:
        """`known_fields` are the fields of earlier parts."""
        self.log = log
        #: All other fields, each with its first occurrence.
        self.new: dict[Key, DecodedField] = {}
        #: The position of each field in its packet, by which fields are sorted.
        self.order: dict[Key, int] = {}
        self._known_fields = known_fields
        self._places: list[tuple[Array, Array, Array]] = []
        self._packets: dict[Key, list[Array]] = {}

    def add(self, piece: Piece) -> None:
        """Adds the next piece of the part."""
        self._places.append((piece.begin + piece.at, piece.begin + piece.end, piece.sets))
        fields: dict[Key, list[walk.Run]] = {}
        for run in piece.runs or ():
            if run.set >= 0x80:
                fields.setdefault((run.set, run.descriptor), []).append(run)
        for key, runs in fields.items():
            packet, offset = walk.packets_and_offsets(runs, len(piece.at))
            self._packets.setdefault(key, []).append(packet + piece.number)
            self.order.setdefault(key, int(offset[0]))
            if key not in self._known_fields and key not in self.new:
                self.new[key] = first(piece, runs)

    def complete(self) -> None:
        """Computes the attributes below, once all pieces are added."""
        nothing = (np.zeros(0, np.int64), np.zeros(0, np.int64), np.zeros(0, np.uint8))
        #: The offsets in the file at which the packets begin and end.
        self.at, self.end, sets = (np.concatenate(parts) for parts in zip(nothing, *self._places))
        numbers = {n: np.flatnonzero(sets == n) for n in np.flatnonzero(np.bincount(sets, minlength=256)).tolist()}
        #: Data set -> its packets; sets are sorted by their first packets.
        self.sets = dict(sorted(((n, p) for n, p in numbers.items() if n >= 0x80), key=lambda entry: int(entry[1][0])))
        #: Field -> the packets that have it.
        self.packets = {key: np.concatenate(packets) for key, packets in self._packets.items()}
        self.new = dict(sorted(self.new.items(), key=lambda entry: (self.packets[entry[0]][0], self.order[entry[0]])))

    def times(self, number: int, clock: str) -> Stamps:
        """Returns the timestamps of a set."""
        return times.read_timestamps(self.log, number, clock)

    def valid(self, number: int, clock: str) -> tuple[Array, Array]:
        """Returns the packets of a set with valid timestamps, and their times."""
        stamps = times.read_timestamps(self.log, number, clock)
        right = stamps.value != NONE
        return stamps.packet[right], stamps.value[right]

    def before(self, number: int, packet: int) -> int:
        """Counts the packets of a set before a packet."""
        return int(np.searchsorted(self.sets[number], packet))


class Line:
    """The times of a part by one clock, of all sets together."""

    def __init__(self, spans: list[tuple[Array, Array]], before: int | None) -> None:
        """`spans`: for each set, the file offsets of its packets, and their times. `before`: the last time before this
        part."""
        at, time = (np.concatenate(parts) for parts in zip((np.zeros(0, np.int64),) * 2, *spans))
        order = np.argsort(at, kind="stable")
        self._at, self._time = at[order], time[order]
        self._before = before

    @property
    def last(self) -> int | None:
        """The last time."""
        return int(self._time[-1]) if len(self._time) else self._before

    def at(self, offset: int) -> int | None:
        """Returns the last time of the packets up to an offset in the file."""
        count = int(np.searchsorted(self._at, offset, side="right"))
        return int(self._time[count - 1]) if count else self._before
