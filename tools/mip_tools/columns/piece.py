"""A part of a log that is read at once."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from ..binding import RawField
from .scan import HEADER, Array
from .walk import Run

NOTHING = np.zeros(0, np.uint8)


class Piece:
    """The packets that begin in a piece of a log, and their fields once they are requested."""

    __slots__ = ("at", "begin", "data", "end", "number", "runs", "sets", "size")

    def __init__(self, begin: int, size: int, number: int, at: Array, end: Array, sets: Array) -> None:
        self.begin = begin  # in the file
        self.size = size  # bytes that the packets begin in
        self.number = number  # of the first packet
        self.at, self.end = at, end  # of packets, in the piece
        self.sets = sets  # of packets
        self.data = NOTHING  # its bytes, while it is read
        self.runs: list[Run] | None = None

    def fields(self, descriptor: int, packet: Array, offset: Array) -> Iterator[RawField]:
        """Yields fields with this descriptor, given their packets, and the offsets of their data in the payloads."""
        place = self.at[packet] + HEADER + offset
        sizes = self.data[place - 2]
        for number, begin, size in zip(self.sets[packet].tolist(), place.tolist(), sizes.tolist()):
            yield RawField(number, descriptor, self.data[begin : begin + size - 2].tobytes())

    def bare(self) -> Piece:
        """Returns a copy of the piece without the fields."""
        return Piece(self.begin, self.size, self.number, self.at, self.end, self.sets)

    def with_data(self, data: Array) -> Piece:
        """Returns a copy of the piece with the fields and its bytes."""
        copy = self.bare()
        copy.runs, copy.data = self.runs, data
        return copy


class Where:
    """The source of a column's rows; each property is computed when it is first used."""

    def __init__(self, only: int) -> None:
        """`only` is the set of all rows, or 0 if there are several."""
        self._only = only
        self._rows: list[tuple[Piece, Array]] = []
        self._valid: Array | None = None

    def add(self, piece: Piece, packet: Array) -> None:
        """Adds the rows of a piece."""
        self._rows.append((piece, packet))

    def keep(self, valid: Array | None) -> None:
        """Keeps only these rows; None keeps all."""
        self._valid = valid

    def __getstate__(self) -> dict[str, Any]:
        """Returns the state that copies of a column need."""
        return self.__dict__ | {"_rows": [(piece.bare(), packet) for piece, packet in self._rows]}

    def packet(self) -> Array:
        """The numbers of the packets in the log."""
        numbers = [_from(piece.number, packet) for piece, packet in self._rows]
        return self._joined(numbers, np.int64)

    def offset(self) -> Array:
        """The offsets of the packets in the file."""
        places = [_from(piece.begin, piece.at[packet]) for piece, packet in self._rows]
        return self._joined(places, np.int64)

    def set(self) -> Array:
        """The descriptor sets of the packets."""
        if self._only:
            total = sum(len(packet) for _, packet in self._rows)
            return self._joined([np.full(total, self._only, np.uint8)], np.uint8)
        return self._joined([piece.sets[packet] for piece, packet in self._rows], np.uint8)

    def sets(self) -> list[int]:
        """The descriptor sets of the packets, each once."""
        if self._only:
            return [self._only]
        numbers: list[int] = np.flatnonzero(np.bincount(self.set(), minlength=1)).tolist()
        return numbers

    def _joined(self, parts: list[Array], dtype: type[Any]) -> Array:
        whole = np.concatenate(parts) if parts else np.zeros(0, dtype)
        whole = whole.astype(dtype, copy=False)
        return whole if self._valid is None else whole[self._valid]

    def __len__(self) -> int:
        if self._valid is not None:
            return int(self._valid.sum())
        return sum(len(packet) for _, packet in self._rows)


def _from(first: int, numbers: Array) -> Array:
    """Adds `first` to numbers within a piece: in a whole log, they need 64 bits."""
    return np.add(numbers, first, dtype=np.int64)
