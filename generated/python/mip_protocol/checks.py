"""Fast checks of checksums.

A checksum is two 8-bit sums. `zlib.adler32` computes the same sums modulo 65521, and continues from
earlier ones. If these have eight bits, no sum of 21 more bytes reaches 65521: it is exact.
"""

from __future__ import annotations

import struct
from functools import cache
from typing import Any
from zlib import adler32

#: The most bytes whose second sum stays below 65521, after sums of eight bits.
PIECE = 21
#: Eight bits of each sum.
SUMS = 0x00FF00FF
#: The largest remainder of the first sum of a whole packet if that has reached 65521.
WRAPPED = 259 * 255 - 65521
#: What is known of packets with the same header: size, sums of the header, the function that splits
#: the payload into pieces.
Head = tuple[int, int, Any]
#: The most headers that are known at the same time.
MOST = 1024


def sums(data: bytes) -> int:
    """Computes the two sums: the first in the low bits, the second in the high ones."""
    value = 0
    for at in range(0, len(data), PIECE):
        value = adler32(data[at : at + PIECE], value) & SUMS
    return value


def checksum(data: bytes) -> bytes:
    """Computes the two checksum bytes of a header and its payload.

    >>> checksum(bytes.fromhex("756501020201")).hex()
    'e0c6'
    """
    value = sums(data)
    return bytes((value & 0xFF, value >> 16))


def is_correct(data: bytes) -> bool:
    """Does a packet have the correct checksum? Most wrong ones fail at the first sum."""
    body = data[:-2]
    first = adler32(body, 0) & 0xFFFF
    if first > WRAPPED and first & 0xFF != data[-2]:
        return False
    return checksum(body) == data[-2:]


@cache
def splitter(size: int) -> Any:
    """Returns the function that splits the payload of a packet into pieces."""
    pieces = [min(PIECE, size - at) for at in range(0, size, PIECE)]
    return struct.Struct(">4x" + "".join([f"{n}s" for n in pieces])).unpack_from


class Heads(dict[bytes, Head]):
    """Header -> what is known of packets that begin with it. It is bounded."""

    def add_header(self, header: bytes) -> None:
        """Adds a header, which a packet with a correct checksum has."""
        if len(self) >= MOST:
            self.clear()
        self[header] = (header[3] + 6, sums(header), splitter(header[3]))


def has_checksum(buffer: bytes, at: int, head: Head) -> bool:
    """Does the packet at an offset, which is complete and has this header, have the correct
    checksum?"""
    size, value, split = head
    for piece in split(buffer, at):
        value = adler32(piece, value) & SUMS
    at += size
    return value & 0xFF == buffer[at - 2] and value >> 16 == buffer[at - 1]


HEADS = Heads()
