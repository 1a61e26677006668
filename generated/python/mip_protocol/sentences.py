"""NMEA sentences in the bytes between packets."""

from __future__ import annotations

import re
from functools import reduce
from operator import xor

#: A sentence has at most 82 characters; some devices send longer ones of their own.
LONGEST = 1024

_SENTENCE = re.compile(rb"[$!]([\x20-\x7e]+)\*([0-9A-Fa-f]{2})\r?\Z")


class Sentences:
    """Takes bytes in pieces of any size and returns the whole sentences with a right checksum.

    >>> sentences = Sentences()
    >>> sentences.feed(b"ue$GPZDA,,,,,,*48" + bytes([13]))
    []
    >>> sentences.feed(bytes([10]))
    ['$GPZDA,,,,,,*48']
    """

    def __init__(self) -> None:
        self._line = bytearray()

    def feed(self, data: bytes) -> list[str]:
        """The sentences that are complete with these bytes, without the ends of their lines."""
        self._line += data
        *lines, rest = self._line.split(b"\n")
        self._line = rest[-LONGEST:]
        return [found for line in lines if (found := _sentence(line[-LONGEST:]))]


def _sentence(line: bytearray) -> str | None:
    """The sentence at the end of a line; what is before it is noise."""
    start = max(line.rfind(b"$"), line.rfind(b"!"))
    match = _SENTENCE.match(line, start) if start >= 0 else None
    if match is None or reduce(xor, match[1]) != int(match[2], 16):
        return None
    return line[start:].rstrip(b"\r").decode("ascii")


__all__ = ["LONGEST", "Sentences"]
