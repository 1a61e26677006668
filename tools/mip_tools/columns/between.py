"""Finds the bytes of a log that belong to no packet."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from .piece import Piece

#: Bytes of the log that are searched at once.
PART = 1 << 23


class Gap(NamedTuple):
    """The bytes between two packets that are in one piece."""

    offset: int  # in the file
    data: bytes
    goes_on: bool  # it continues the previous gap


class Gaps:
    """Finds the gaps of a log, piece by piece."""

    def __init__(self) -> None:
        self._free = 0  # the end of the last packet
        self._end = -1  # of the last gap

    def in_piece(self, piece: Piece) -> Iterator[Gap]:
        """Yields the gaps in the next piece."""
        first = max(0, self._free - piece.begin)
        begins = np.concatenate(([first], piece.end))
        ends = np.concatenate((piece.at, [max(first, piece.size)]))
        places = np.flatnonzero(ends > begins)
        if len(piece.at):
            self._free = piece.begin + int(piece.end[-1])
        for begin, end in zip(begins[places].tolist(), ends[places].tolist()):
            offset = piece.begin + begin
            goes_on, self._end = offset == self._end, piece.begin + end
            yield Gap(offset, piece.data[begin:end].tobytes(), goes_on)
