"""Finds packets in a stream of bytes."""

from __future__ import annotations

from .packet import OVERHEAD, SYNC, Packet, checksum


class Parser:
    """Takes bytes in pieces of any size and returns the packets in them.

    Anything else in the stream (NMEA sentences, noise, packets with a bad checksum) is skipped and
    counted in `skipped`. The result does not depend on how the stream is cut.

    >>> parser = Parser()
    >>> parser.feed(b"$GP*00" + bytes.fromhex("756501020201e0"))
    []
    >>> parser.feed(b"\\xc6")
    [Packet(756501020201e0c6)]
    >>> parser.skipped
    6
    """

    def __init__(self) -> None:
        self._buffer = bytearray()
        self.skipped = 0

    @property
    def pending(self) -> int:
        """The number of bytes that may be the start of a packet."""
        return len(self._buffer)

    def feed(self, data: bytes) -> list[Packet]:
        """The packets that are complete with these bytes."""
        self._buffer += data
        return self._scan(final=False)

    def flush(self) -> list[Packet]:
        """Gives up an incomplete packet, as at the end of a file, and searches the bytes in it."""
        return self._scan(final=True)

    def look_behind(self) -> list[Packet]:
        """Gives up the incomplete packet only if a whole one is behind its first bytes.

        The first was noise then. Otherwise nothing changes.
        """
        buffer, at = self._buffer, 0
        while (at := buffer.find(SYNC, at + 1)) >= 0 and len(buffer) - at >= OVERHEAD:
            candidate = bytes(buffer[at : at + buffer[at + 3] + OVERHEAD])
            whole = len(candidate) == candidate[3] + OVERHEAD and candidate[2] != 0
            if whole and checksum(candidate[:-2]) == candidate[-2:]:
                self.skipped += at
                del buffer[:at]
                return self._scan(final=False)
        return []

    def _scan(self, final: bool) -> list[Packet]:
        buffer, at, packets = self._buffer, 0, []
        end = len(buffer)
        while True:
            found = buffer.find(SYNC, at)
            if found < 0:
                last = not final and end > at and buffer[end - 1] == SYNC[0]
                found = end - 1 if last else end
                self.skipped += found - at
                at = found
                break
            self.skipped += found - at
            at = found
            size = buffer[at + 3] + OVERHEAD if end - at > 3 else OVERHEAD
            candidate = b""
            if end - at < 3 or buffer[at + 2] != 0:  # no packet has descriptor set 0
                if end - at >= size:
                    candidate = bytes(buffer[at : at + size])
                elif not final:
                    break
            if candidate and checksum(candidate[:-2]) == candidate[-2:]:
                packets.append(Packet._trusted(candidate))
                at += size
            else:
                self.skipped += 1
                at += 1
        del buffer[:at]
        return packets
