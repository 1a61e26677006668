"""The limits of a part of a log."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple


class Range(NamedTuple):
    """The numbers from `first` up to, but not including, `end`."""

    first: int = 0
    end: int | None = None


class When(NamedTuple):
    """A time in ns: from the start of the log, or since 1970 in UTC."""

    time: int
    absolute: bool


@dataclass(frozen=True)
class Bounds:
    """The requested part of a log: all limits apply together."""

    begin: When | None
    end: When | None
    bytes: Range
    packets: Range

    @property
    def timed(self) -> bool:
        """Is the part limited by time?"""
        return self.begin is not None or self.end is not None

    @property
    def dated(self) -> bool:
        """Is the part limited by a date?"""
        return any(when is not None and when.absolute for when in (self.begin, self.end))
