"""The packets of a log, which are found once. `log` adds the columns of their fields."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from typing import Any, TypeAlias, TypeVar

import numpy as np

from ..binding import Field
from ..devices.known import read_by_device
from . import scan, walk
from .column import Column
from .piece import NOTHING, Piece
from .sender import Sender
from .source import Source
from .stamps import Stamps, Times

F = TypeVar("F", bound=Field)
P = TypeVar("P", bound="Packets")

#: A type of field: its class, its name, or a set and a class as in `registry.all_types`.
Kind: TypeAlias = "type[Field] | str | tuple[int, type[Field]]"

_PIECE = 1 << 20  # bytes that are read at once
#: The number of packets whose offsets are stored, so that they are found only once: some 250 MB. Later
#: packets are found again for each request.
_KEPT = 10_000_000


class Packets(ABC):
    """The packets that begin within a range of bytes of a log."""

    def __init__(self, source: Any, begin: int = 0, end: int | None = None, device: str | Sender | None = None) -> None:
        """See `read_log`."""
        #: What is known of the device that sent the log; parts of a log have the same.
        self.sender = device if isinstance(device, Sender) else Sender(device)
        if begin < 0 or (end is not None and end < begin):
            raise ValueError(f"bytes {begin} to {end}: `begin` must be 0 or more, and not after `end`")
        self._earlier: Packets | None = None
        self.source = source if isinstance(source, Source) else Source(source)
        #: The size of the whole file, in bytes.
        self.size = self.source.size
        #: The range of bytes in which the packets begin.
        self.begin = min(begin, self.size)
        self.end = self.size if end is None else min(end, self.size)
        self._kept: dict[int, Piece] = {}
        self._first: int | None = None
        self._sets: list[int] | None = None
        self._counts: tuple[int, int] | None = None  # of packets, of skipped bytes
        #: (set, clock) -> timestamps, for `times`, including those of packets shortly before this part.
        self.own_stamps: dict[tuple[int, str], Stamps] = {}
        self.stamps: dict[tuple[int, str], Stamps] = {}

    def parts(self: P, size: int = 1 << 26) -> Iterator[P]:
        """Yields the log in parts of this many bytes; together they have every packet once."""
        if size < 1:
            raise ValueError(f"a part must have 1 byte or more, not {size}")
        for begin in range(self.begin, self.end, size):
            yield self.part(begin, min(begin + size, self.end))

    def part(self: P, begin: int, end: int) -> P:
        """Returns the part whose packets begin within these bytes."""
        return type(self)(self.source, begin, end, self.sender)

    @property
    def is_whole(self) -> bool:
        """Is this no part of a log, but all of it?"""
        return (self.begin, self.end) == (0, self.size)

    @property
    def found(self) -> bool:
        """Have all packets been found, and are their offsets stored?"""
        return self._counts is not None and self._counts[0] <= _KEPT

    def whole(self: P) -> P:
        """Returns the log of which this is a part."""
        return self if self.is_whole else self.part(0, self.size)

    @property
    def device(self) -> str | None:
        """The id of the device that sent the log: the named one, else that of the replies in the log, if there are
        any."""
        return self.sender.device(self)

    def reads(self, kind: type[Field]) -> str | None:
        """Returns the id of the device as which a field is read: that of the log, else one that stands for all that may
        have sent it, if they read the field alike."""
        if self.device is None and read_by_device(kind):
            self.sender.survey(self)
        return self.sender.reads(kind)

    # ----------------------------------------------------------------- packets

    @property
    def packets(self) -> int:
        """The number of packets."""
        return self._counted()[0]

    @property
    def skipped(self) -> int:
        """The number of bytes that are not part of a packet."""
        return self._counted()[1]

    def _counted(self) -> tuple[int, int]:
        if self._counts is None:
            for _ in self.pieces(fields=False):
                pass
        assert self._counts is not None
        return self._counts

    def pieces(self, fields: bool = True) -> Iterator[Piece]:
        """Yields the pieces of the log in order, with their packets and the fields in them. For `Reader`."""
        if self._first is None:
            self._first = self._beginning()
        free, number = self._first, 0
        covered = min(free, self.end) - self.begin
        for begin in range(self.begin, self.end, _PIECE):
            limit = min(_PIECE, self.end - begin)
            data, length = self.source.piece(begin, limit, scan.AHEAD)
            piece = self._kept.get(begin)
            if piece is None:
                at, end = scan.find_packets(data, max(0, free - begin), limit, length)
                piece = Piece(begin, limit, number, at, end, data[at + 2])
                if number < _KEPT:
                    self._kept[begin] = piece
            if fields and piece.runs is None:
                piece.runs = walk.find_runs(data, piece.at, piece.sets)
            own = piece.with_data(data)  # other requests may use the same piece meanwhile
            yield own
            own.data = NOTHING
            self.source.forget(begin, begin + limit)
            number += len(piece.at)
            if len(piece.end):
                free = begin + int(piece.end[-1])
                covered += int((piece.end - piece.at).sum())
        if number:  # the last packet may end after this part
            covered -= max(0, free - self.end)
        self._counts = number, self.end - self.begin - covered

    def _beginning(self) -> int:
        """Returns the offset at which the first packet may begin: after one that reaches into this part."""
        back = 8 * scan.REACH
        while True:
            begin = max(0, self.begin - back)
            data, length = self.source.piece(begin, self.begin - begin, scan.AHEAD)
            at = scan.clear(data, self.begin - begin, length, begin == 0)
            if at is not None:
                return begin + at
            back *= 4

    def sets(self) -> list[int]:
        """Returns the descriptor sets of the packets, each once."""
        if self._sets is None:
            counts = np.zeros(256, np.int64)
            for piece in self.pieces(fields=False):
                counts += np.bincount(piece.sets, minlength=256)
            self._sets = np.flatnonzero(counts).tolist()
        return self._sets

    def before_offset(self, offset: int) -> int:
        """Counts the packets that begin before an offset in the file."""
        return sum(int(np.searchsorted(piece.at, offset - piece.begin)) for piece in self.pieces(fields=False))

    def before(self, size: int) -> Packets | None:
        """Returns the part of this many bytes before this one, if there is any. For `times`."""
        if not self.begin:
            return None
        if self._earlier is None:
            self._earlier = self.part(max(0, self.begin - size), self.begin)
        return self._earlier

    # ----------------------------------------------------------------- columns

    @abstractmethod
    def column(self, kind: Kind, set_number: int | None = None) -> Column[Any]:
        """Returns the fields of a type."""

    @abstractmethod
    def columns(self, kinds: Sequence[Kind] | None = None, set_number: int | None = None) -> list[Column[Any]]:
        """Returns the columns of several types."""

    @abstractmethod
    def objects(self, kind: type[F], set_number: int | None = None) -> Iterator[F]:
        """Yields the fields of a type as objects."""

    @abstractmethod
    def times(self, column: Column[Any], clock: str | None = None) -> Times:
        """Returns the time of each row of a column."""
