"""Separates packets from the bytes between them."""

from __future__ import annotations

from .packet import Packet
from .parser import Parser


class Splitter:
    """A parser that also returns what is between packets, in order: nothing of the stream is lost.

    >>> splitter = Splitter()
    >>> splitter.feed(b"$GP*00" + bytes.fromhex("756501020201e0c6"))
    [b'$GP*00', Packet(756501020201e0c6)]
    """

    def __init__(self) -> None:
        self._parser = Parser()
        self._kept = bytearray()  # what the parser has not decided about
        self._returned = 0  # bytes between packets

    @property
    def skipped(self) -> int:
        """Bytes that belong to no packet."""
        return self._parser.skipped

    @property
    def pending(self) -> int:
        """The number of bytes that may be the start of a packet."""
        return self._parser.pending

    def feed(self, data: bytes) -> list[Packet | bytes]:
        """The packets that are complete with these bytes, and the bytes that belong to none.

        What is between two packets may come in several pieces.
        """
        self._kept += data
        return self._split(self._parser.feed(data))

    def flush(self) -> list[Packet | bytes]:
        """Gives up an incomplete packet, as at the end of a file, and searches the bytes in it."""
        return self._split(self._parser.flush())

    def look_behind(self) -> list[Packet | bytes]:
        """As `Parser.look_behind`."""
        return self._split(self._parser.look_behind())

    def _split(self, packets: list[Packet]) -> list[Packet | bytes]:
        found: list[Packet | bytes] = []
        kept, at = self._kept, 0
        between = self._parser.skipped - self._returned
        end = between + sum(map(len, packets))
        for packet in packets:
            # The first place with these bytes is the right one: the parser takes any whole packet.
            start = kept.find(bytes(packet), at, end)
            if start > at:
                found.append(bytes(kept[at:start]))
            found.append(packet)
            at = start + len(packet)
        if end > at:
            found.append(bytes(kept[at:end]))
        del kept[:end]
        self._returned += between
        return found


__all__ = ["Splitter"]
