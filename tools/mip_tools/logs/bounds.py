"""The limits of a part of a log."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple


class When(NamedTuple):
    """A time in ns: from the start of the log, or since 1970 in UTC."""

    time: int
    absolute: bool


@dataclass(frozen=True)
class Bounds:
    """The requested part of a log: both limits apply together."""

    begin: When | None
    end: When | None

    @property
    def timed(self) -> bool:
        """Is the part limited by time?"""
        return self.begin is not None or self.end is not None

    @property
    def dated(self) -> bool:
        """Is the part limited by a date?"""
        return any(when is not None and when.absolute for when in (self.begin, self.end))
