"""The timestamps of packets, and the times of rows."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from typing import NamedTuple

import numpy as np

from .scan import Array

NONE = np.iinfo(np.int64).min  # NaT in NumPy
LACKING = NONE + 1


class Times(NamedTuple):
    """The time of each row."""

    #: The clock; "" if the log has no timestamp of these sets.
    clock: str
    #: `datetime64[ns]` in UTC for a clock with a date, otherwise `timedelta64[ns]` since its start. NaT
    #: if the time is unknown or not valid.
    values: Array
    #: True for the timestamp of the packet itself, False for the last one before it in a packet of
    #: the same set, up to `REACH` bytes away.
    own: Array


class Stamps:
    """The first timestamp of each packet of a set that has one."""

    def __init__(self, packet: Array, value: Array, offset: Callable[[], Array]) -> None:
        self.packet = packet  # packet numbers; negative for packets before a part of a log
        self.value = value  # nanoseconds
        self._offset = offset
        #: Is any timestamp valid?
        self.some = bool(len(value)) and bool((value != NONE).any())

    @cached_property
    def offset(self) -> Array:
        """The offsets of the packets in the file."""
        return self._offset()

    @cached_property
    def by_packet(self) -> Array:
        """The value of each packet from the first to the last one; `LACKING` for packets without one."""
        table = np.full(int(self.packet[-1] - self.packet[0]) + 1, LACKING, np.int64)
        table[self.packet - self.packet[0]] = self.value
        return table
