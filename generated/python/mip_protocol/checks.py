"""Fast checks of checksums.

A checksum is two 8-bit sums. `zlib.adler32` computes the same sums modulo 65521. Over at most 22
bytes they cannot reach that, so they are exact. The sums of such pieces are combined with weights
that depend only on the length.
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Sequence
from typing import Any, Generic, TypeVar
from zlib import adler32

#: The most bytes whose second sum stays below 65521.
PIECE = 22
#: The largest remainder of the first sum of a whole packet if that has reached 65521.
WRAPPED = 259 * 255 - 65521
#: A header that has occurred this often will occur again.
TIMES = 8

T = TypeVar("T")

#: Does the packet at an offset, which is complete, have the correct checksum?
Check = Callable[[bytes, int], bool]


def checksum(data: bytes) -> bytes:
    """Computes the two checksum bytes of a header and its payload.

    >>> checksum(bytes.fromhex("756501020201")).hex()
    'e0c6'
    """
    first = second = 0
    for at in range(0, len(data), PIECE):
        piece = data[at : at + PIECE]
        sums = adler32(piece, 0)
        second += len(piece) * first + (sums >> 16)
        first += sums & 0xFFFF
    return bytes((first & 0xFF, second & 0xFF))


def is_correct(data: bytes) -> bool:
    """Does a packet have the correct checksum? Most wrong ones fail at the first sum."""
    body = data[:-2]
    first = adler32(body, 0) & 0xFFFF
    if first > WRAPPED and first & 0xFF != data[-2]:
        return False
    return checksum(body) == data[-2:]


def check_source(header: bytes, names: dict[str, Any]) -> tuple[list[str], str]:
    """Returns source code that checks packets beginning with these four bytes: lines and a
    condition.

    The code uses `buffer`, `at` and what is added to `names`.
    """
    size = header[3]
    first, second = sum(header), sum(n * byte for n, byte in zip(range(size + 4, size, -1), header))
    pieces = [min(PIECE, size - at) for at in range(0, size, PIECE)]
    behind = [size - sum(pieces[: i + 1]) for i in range(len(pieces))]
    sums = [f"s{i}" for i in range(len(pieces))]
    ones = [str(first & 255), *sums]
    weighted = [
        str(second & 255),
        *[f"(s{i} >> 16) + {n} * s{i}" if n else f"(s{i} >> 16)" for i, n in enumerate(behind)],
    ]
    lines = [
        f"{', '.join([*sums, 'found'])}, = split(buffer, at)",
        *[f"{s} = adler32({s}, 0)" for s in sums],
    ]
    names["adler32"] = adler32
    names["split"] = struct.Struct(">4x" + "".join(f"{n}s" for n in pieces) + "H").unpack_from
    return lines, f"found == (({' + '.join(ones)}) & 255) << 8 | ({' + '.join(weighted)}) & 255"


def make_check(header: bytes) -> Check:
    """Compiles the check for packets that begin with these four bytes."""
    names: dict[str, Any] = {}
    lines, condition = check_source(header, names)
    made: Check = function("check", [*lines, f"return {condition}"], names)
    return made


def function(name: str, lines: Sequence[str], names: dict[str, Any]) -> Any:
    """Compiles a function of `buffer` and `at` from these lines, which may use these names."""
    exec(f"def {name}(buffer, at):\n " + "\n ".join(lines), names)
    return names[name]


class Often(Generic[T]):
    """A cache of objects that are only made for frequent keys; at most `most` of them."""

    def __init__(self, make: Callable[[bytes], T], most: int) -> None:
        self.made: dict[bytes, T] = {}
        self._make = make
        self._most = most
        self._counts: dict[bytes, int] = {}

    def count(self, key: bytes) -> None:
        """Counts an occurrence of a key, and makes its object when there have been enough."""
        seen = self._counts.get(key, 0) + 1
        if seen < TIMES:
            if len(self._counts) >= 4 * self._most:
                self._counts.clear()
            self._counts[key] = seen
            return
        self._counts.pop(key, None)
        if len(self.made) >= self._most:
            self.made.clear()
        self.made[key] = self._make(key)


#: Header -> size of the packet and check of its checksum.
HEADS = Often(lambda header: (header[3] + 6, make_check(header)), 1024)
