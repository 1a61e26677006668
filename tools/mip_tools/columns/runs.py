"""Finds clocks that are stuck."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field

import numpy as np

from .scan import Array

#: A clock with this many equal times in a row is stuck, if that is also this many times what is usual in the set: a
#: receiver sends its signals in many packets of one time.
STUCK, _UNUSUAL = 10, 3
#: The same if the log has no other instant to compare with.
_ALONE = 50


@dataclass
class Runs:
    """The runs of packets with the same time."""

    lengths: Counter[int] = field(default_factory=Counter)  # of those that have ended
    places: dict[int, tuple[int, int]] = field(default_factory=dict)  # long length -> the first one's offset and time
    first: int = 0  # the length of the first one, which may have begun before the log
    length: int = 0  # of the one that goes on, …
    offset: int = 0
    value: int = 0

    def add(self, offset: Array, value: Array) -> None:
        """Adds the next packets."""
        if not len(value):
            return
        new = np.ones(len(value), bool)
        new[1:] = value[1:] != value[:-1]
        new[0] = not self.length or int(value[0]) != self.value
        begins = np.flatnonzero(new)
        if not len(begins):
            self.length += len(value)
            return
        self.length += int(begins[0])
        if self.length:
            self._ended()
        self.first = self.first or (int(begins[1]) if len(begins) > 1 else 0)
        found = np.unique(np.diff(begins), return_index=True, return_counts=True)
        for length, row, count in zip(*(a.tolist() for a in found)):
            self.lengths[length] += count
            if length >= STUCK:
                self.places.setdefault(length, (int(offset[begins[row]]), int(value[begins[row]])))
        self.length = len(value) - int(begins[-1])
        self.offset, self.value = int(offset[begins[-1]]), int(value[begins[-1]])

    def _ended(self) -> None:
        self.lengths[self.length] += 1
        self.first = self.first or self.length
        if self.length >= STUCK:
            self.places.setdefault(self.length, (self.offset, self.value))

    def stuck(self) -> tuple[int, int] | None:
        """Returns where the clock was first stuck, and the time; None if it never was."""
        every = self.lengths + Counter([self.length])
        longest = max(every)
        if longest < STUCK:
            return None
        # The first and the last one may be cut.
        others = every - Counter({longest}) - Counter(n for n in (self.first, self.length) if n and n != longest)
        least, passed = _ALONE, 0
        for length in sorted(others):
            least = max(STUCK, _UNUSUAL * length)
            passed += others[length]
            if passed > 0.95 * others.total():
                break
        places = {**self.places}
        places.setdefault(self.length, (self.offset, self.value))
        return min((place for length, place in places.items() if length >= least), default=None)
