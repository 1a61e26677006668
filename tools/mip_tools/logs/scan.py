"""Finds the packets of a stream, and the bytes between them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from ..binding import MAX_PAYLOAD, OVERHEAD, Packet, Parser

#: The number of bytes needed to decide whether a packet begins at the first of them.
REACH = MAX_PAYLOAD + OVERHEAD + 1
_MOST = 1 << 16  # skipped bytes that are kept


class Piece(NamedTuple):
    """A packet, or bytes outside packets (`packet` is None), at an offset of the stream."""

    offset: int
    data: bytes
    packet: Packet | None


class Scanner:
    """A parser that reports offsets. The pieces together are the whole stream. Memory is bounded."""

    def __init__(self) -> None:
        self._parser = Parser()
        self._offset = 0

    def feed(self, data: bytes) -> Iterator[Piece]:
        """Adds bytes, and yields the pieces that they complete."""
        return self._pieces(self._parser.feed_all(data))

    def flush(self) -> Iterator[Piece]:
        """Yields the remaining pieces, at the end of a file or after a silence."""
        return self._pieces(self._parser.flush_all())

    def _pieces(self, items: list[Packet | bytes]) -> Iterator[Piece]:
        for item in items:
            data = bytes(item)
            yield Piece(self._offset, data, item if isinstance(item, Packet) else None)
            self._offset += len(data)


class Damaged:
    """Counts the packets that skipped bytes seem to have contained; only those with intact sync bytes are found."""

    def __init__(self) -> None:
        self.count = 0
        #: The number of runs of skipped bytes.
        self.runs = 0
        self._run = bytearray()

    def feed(self, data: bytes | memoryview) -> None:
        """Adds the next skipped bytes of a run."""
        self.runs += not self._run
        self._run += data
        if len(self._run) > _MOST:
            del self._run[: self._counted(len(self._run) - REACH)]

    def end(self) -> None:
        """Ends a run, before a packet or at the end."""
        if self._run:
            self._counted(len(self._run))
            self._run.clear()

    def _counted(self, stop: int) -> int:
        """Counts the packets that begin before an offset; returns where to continue."""
        run, at = self._run, 0
        while at < stop:
            start = run.find(b"\x75\x65", at)
            if start < 0 or start >= stop:
                return stop
            at = start + 2
            if len(run) - start > 3 and run[start + 2] != 0:
                self.count += 1
                size = run[start + 3] + OVERHEAD
                if bytes(run[start + size : start + size + 1]) in (b"", b"\x75"):
                    at = start + size
        return at
