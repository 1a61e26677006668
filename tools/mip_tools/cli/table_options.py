"""Options for the rows of a table, for logs and for live data."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from ..errors import Failure
from . import clocks

if TYPE_CHECKING:
    from ..columns.tables import Series

TIMES = ("utc", "unix", "start", "clock", "none")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    add: Any = parser.add_argument
    add("--by", choices=("time", "packet"), default="time", help="a row for each instant (default) or each packet")
    add("--time", choices=TIMES, help="time of each row (default: utc if there is a date, else clock)")
    add(
        "--invalid",
        choices=("keep", "mask", "drop"),
        default="keep",
        help="values whose flags mark them as invalid: keep them (default), leave them empty, or drop their rows",
    )
    add("--names", action="store_true", dest="named", help="names of values and flags instead of numbers")


def check_clock(wanted: str | None, clock: str) -> None:
    """Raises Failure if the log lacks the requested times."""
    if wanted in ("utc", "unix") and not clocks.dated(clock or None):
        raise Failure("the log has no dates; use --time clock, --time start or --time none")
    if wanted in ("start", "clock") and not clock:
        raise Failure("the log has no valid times; use --time none")


class Time:
    """Converts the column of times to the requested form."""

    def __init__(self, wanted: str | None, clock: str) -> None:
        self._seconds = wanted in ("unix", "start", "clock") and bool(clock)
        self._from_start = wanted == "start"
        self._first: int | None = None

    def of(self, columns: Sequence[Series]) -> Sequence[Series]:
        """Converts the first of the columns of a part, which is the time."""
        import numpy as np

        if not self._seconds:
            return columns
        time, *others = columns
        known = ~np.isnat(time.values)
        numbers = time.values.view(np.int64)
        if self._from_start and self._first is None and known.any():
            self._first = int(numbers[known][0])
        seconds = np.where(known, numbers - (self._first or 0), 0) / 1e9
        return [time._replace(values=seconds, mask=~known, facts=time.facts | {"unit": "s"}), *others]


__all__ = ["TIMES", "Time", "add_arguments", "check_clock"]
