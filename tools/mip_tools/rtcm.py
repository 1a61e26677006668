"""Finds RTCM 3 messages among other bytes."""

from __future__ import annotations

#: What a frame has besides the message: preamble, length, and the checksum.
_OVERHEAD = 6


class Frames:
    """Accepts bytes in pieces of any size, and returns complete frames with a correct checksum.

    >>> frames = Frames()
    >>> frames.feed(bytes.fromhex("20 d3 00 02 fd"))
    []
    >>> [number(frame) for frame in frames.feed(bytes.fromhex("c0 09 cc 8c"))]
    [4060]
    """

    def __init__(self) -> None:
        self._data = b""

    def feed(self, data: bytes) -> list[bytes]:
        """Returns the frames that these bytes complete."""
        self._data += data
        found: list[bytes] = []
        while (at := self._data.find(b"\xd3")) >= 0:
            self._data = self._data[at:]
            size = int.from_bytes(self._data[1:3].ljust(2, b"\0"), "big") + _OVERHEAD
            if size > 0x3FF + _OVERHEAD or (size <= len(self._data) and checksum(self._data[:size])):
                self._data = self._data[1:]
                continue
            if len(self._data) < max(size, 3):
                return found
            found.append(self._data[:size])
            self._data = self._data[size:]
        self._data = b""
        return found


def number(frame: bytes) -> int:
    """Returns the type of a frame's message, such as 1005."""
    return int.from_bytes(frame[3:5], "big") >> 4


def checksum(data: bytes) -> int:
    """Computes the CRC-24Q; 0 for a frame with its checksum."""
    value = 0
    for byte in data:
        value ^= byte << 16
        for _ in range(8):
            value = value << 1 ^ (0x1864CFB if value & 0x800000 else 0)
    return value
