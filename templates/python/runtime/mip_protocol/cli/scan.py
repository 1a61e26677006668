"""Where the packets of a stream are, and the bytes between them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from ..packet import Packet
from ..parser import Parser


class Piece(NamedTuple):
    """A packet, or bytes outside packets (`packet` is None), at an offset of the stream."""

    offset: int
    data: bytes
    packet: Packet | None


class Scanner:
    """The parser, with offsets. All pieces together are the stream; memory is bounded."""

    def __init__(self) -> None:
        self._parser = Parser()
        self._offset = 0

    def feed(self, data: bytes) -> Iterator[Piece]:
        """The pieces that are complete with these bytes."""
        return self._pieces(self._parser.feed_all(data))

    def flush(self) -> Iterator[Piece]:
        """The pieces of what is left, at the end of a file or after a silence."""
        return self._pieces(self._parser.flush_all())

    def _pieces(self, found: list[Packet | bytes]) -> Iterator[Piece]:
        for item in found:
            data = bytes(item)
            yield Piece(self._offset, data, item if isinstance(item, Packet) else None)
            self._offset += len(data)


def damaged(data: bytes) -> int:
    """How many packets these skipped bytes seem to have contained, as far as their syncs are
    complete."""
    count = at = 0
    while (at := data.find(b"\x75\x65", at)) >= 0:
        if len(data) - at > 3 and data[at + 2] != 0:
            count += 1
            size = data[at + 3] + 6
            at += size if data[at + size : at + size + 1] in (b"", b"\x75") else 2
        else:
            at += 2
    return count


def sentences(data: bytes) -> int:
    """How many lines of these skipped bytes look like NMEA sentences."""
    return sum(
        line[:1] in (b"$", b"!") and line[1:6].isalnum() and line[-3:-2] == b"*"
        for line in (part.strip() for part in data.split(b"\n"))
    )


__all__ = ["Piece", "Scanner", "damaged", "sentences"]
