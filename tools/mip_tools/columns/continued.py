"""Lets times go on where their clock restarts."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from .scan import Array
from .stamps import NONE


class Continued:
    """The times of one part of a log after another."""

    def __init__(self) -> None:
        self._last: int | None = None  # the last time, if no restart had set the clock back
        self._added = 0  # what the clock lacks since its last restart
        self._restarted = False  # has it restarted since the last time?

    def add(self, time: Array, restarts: Iterable[int]) -> None:
        """Changes the times of the next part, which has restarts before these places."""
        ends = [*restarts, len(time)]
        for i, (begin, end) in enumerate(zip([0, *ends], ends)):
            self._restarted |= i > 0
            there = begin + np.flatnonzero(time[begin:end] != NONE)
            if len(there):
                if self._restarted and self._last is not None:
                    self._added = self._last - int(time[there[0]])
                self._restarted = False
                time[there] += self._added
                self._last = int(time[there[-1]])
