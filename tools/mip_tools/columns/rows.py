"""Collects the bytes of the fields of one type."""

from __future__ import annotations

import sys

import numpy as np

from . import native
from .layout import Layout
from .piece import Piece
from .scan import HEADER, Array, gather

_MOST = 1 << 26  # the maximum size of memory that is allocated for rows that are only expected


class Rows:
    """Rows of bytes, one for each field."""

    def __init__(self, shape: Layout, end: int) -> None:
        """`end` is the size of the log, in bytes."""
        self._size, self._end = shape.dtype.itemsize, end
        item = 1 if shape.base is None else shape.base.itemsize
        #: Do items of one size, which are big-endian in the log, have the byte order of this machine?
        self.turned = item == 1 or (native.kernel is not None and sys.byteorder == "little")
        self._item = item if self.turned else 1
        self._room = np.empty((0, self._size), np.uint8)
        self._count = 0

    def add(self, piece: Piece, packet: Array, offset: Array) -> None:
        """Adds fields, given their packets in a piece, and the offsets of their data in the payloads."""
        count = self._count + len(packet)
        if count > len(self._room):
            self._grow(count, len(packet) * (self._end - piece.begin) // len(piece.data))
        rows = self._room[self._count : count]
        if native.kernel is None:
            rows[:] = gather(piece.data, piece.at[packet] + HEADER + offset, self._size)
        else:
            native.kernel.gather(piece.data, piece.at, packet, offset, self._item, rows)
        self._count = count

    def _grow(self, least: int, expected: int) -> None:
        """Makes room for the expected rows: unused memory costs nothing, but copies do."""
        room = least + max(least, min(expected, _MOST // max(1, self._size)))
        old, self._room = self._room, np.empty((room, self._size), np.uint8)
        self._room[: self._count] = old[: self._count]

    def whole(self) -> Array:
        """Returns all rows."""
        return self._room[: self._count]
