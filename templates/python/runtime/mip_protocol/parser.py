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
        """Gives up an incomplete packet, as after a time-out, and searches the bytes in it."""
        return self._scan(final=True)

    def give_up(self) -> list[Packet]:
        """Gives up only the candidate that holds back what follows it."""
        dropped = self._buffer[:1]
        del self._buffer[:1]
        self.skipped += len(dropped)
        return self._scan(final=False)

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
