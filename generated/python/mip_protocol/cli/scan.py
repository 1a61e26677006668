"""Where the packets of a stream are, and the bytes between them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from ..packet import Packet
from ..parser import Parser


class Piece(NamedTuple):
    """A packet, or bytes that belong to none (`packet` is None), at an offset of the stream."""

    offset: int
    data: bytes
    packet: Packet | None


class Scanner:
    """The parser, with offsets. All pieces together are the stream; memory is bounded."""

    def __init__(self) -> None:
        self._parser = Parser()
        self._held = b""
        self._offset = 0

    def feed(self, data: bytes) -> Iterator[Piece]:
        """The pieces that are complete with these bytes."""
        return self._pieces(data, self._parser.feed(data))

    def flush(self) -> Iterator[Piece]:
        """The pieces of what is left, at the end of a file or after a silence."""
        return self._pieces(b"", self._parser.flush())

    def _pieces(self, data: bytes, packets: list[Packet]) -> Iterator[Piece]:
        held = self._held + data
        end = len(held) - self._parser.pending
        start = self._offset
        self._held, self._offset = held[end:], start + end
        at = 0
        for packet in packets:
            raw = bytes(packet)
            # The parser tries every sync after the packet before, so the first occurrence is it.
            found = at if held.startswith(raw, at) else held.find(raw, at)
            if found > at:
                yield Piece(start + at, held[at:found], None)
            at = found + len(raw)
            yield Piece(start + found, raw, packet)
        if end > at:
            yield Piece(start + at, held[at:end], None)


def damaged(data: bytes) -> int:
    """How many packets these skipped bytes seem to have held, as far as their syncs are whole."""
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
