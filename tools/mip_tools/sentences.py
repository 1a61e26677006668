"""NMEA sentences in the bytes between packets."""

from __future__ import annotations

import re

#: A sentence has at most 82 characters; some devices send longer ones of their own.
LONGEST = 1024

_END = re.compile(rb"\*([0-9A-Fa-f]{2})\r?\Z")


class Sentences:
    """Takes bytes in pieces of any size and returns the whole sentences with a correct checksum.

    >>> sentences = Sentences()
    >>> sentences.feed(b"ue$GPZDA,,,,,,*48" + bytes([13]))
    []
    >>> sentences.feed(bytes([10]))
    ['$GPZDA,,,,,,*48']
    """

    def __init__(self) -> None:
        self._line = bytearray()
        self._taken = 0  # bytes before this line

    def feed(self, data: bytes) -> list[str]:
        """The sentences that are complete with these bytes, without the ends of their lines."""
        return [sentence for _, sentence in self.placed(data)]

    def placed(self, data: bytes) -> list[tuple[int, str]]:
        """The same, and where each begins, counted in all the bytes that were fed."""
        self._line += data
        *lines, rest = self._line.split(b"\n")
        found = []
        for line in lines:
            if (sentence := last(line[-LONGEST:])) is not None:
                begin, text = sentence
                found.append((self._taken + max(0, len(line) - LONGEST) + begin, text))
            self._taken += len(line) + 1
        self._taken += max(0, len(rest) - LONGEST)
        self._line = rest[-LONGEST:]
        return found


def last(line: bytes | bytearray) -> tuple[int, str] | None:
    """The sentence at the end of a line, and where it begins; any bytes before it are noise."""
    end = _END.search(line)
    if end is None:
        return None
    wanted, checksum = int(end[1], 16), 0
    for at in range(end.start() - 1, -1, -1):
        byte = line[at]
        if not 0x20 <= byte <= 0x7E:
            return None
        # Texts may contain such a character, too: the checksum decides.
        if byte in b"$!" and checksum == wanted and at + 1 < end.start():
            return at, line[at:].rstrip(b"\r").decode("ascii")
        checksum ^= byte
    return None


__all__ = ["LONGEST", "Sentences", "last"]
