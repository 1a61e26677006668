"""The times of the rows of tables."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from ..errors import Failure

if TYPE_CHECKING:
    from ..columns.tables import Series
    from ..columns.timeline import Clocks


def shown_clocks(wanted: str | None, clocks: Clocks, why: str) -> tuple[str, ...] | None:
    """Returns the clocks that have a column, for `--time`; None for all. Raises Failure if the log lacks them; `why` it
    does."""
    if wanted in ("utc", "unix") and not clocks.dated:
        raise Failure(f"{why}; use --time clock, --time start or --time none")
    if wanted in ("start", "clock") and not clocks.best:
        raise Failure(f"{why}; use --time none")
    if wanted == "none":
        return ()
    if wanted in ("utc", "unix"):
        return (clocks.dated,)
    return (clocks.steady,) if wanted in ("start", "clock") else None


class Time:
    """Converts the columns of times to the requested form."""

    def __init__(self, wanted: str | None) -> None:
        self._wanted = wanted
        self._first: int | None = None

    def converted(self, columns: Sequence[Series]) -> Sequence[Series]:
        """Converts the first of the columns of a part, which is the time."""
        import numpy as np

        time, *others = columns
        if self._wanted not in ("unix", "start", "clock") or time.name not in ("time", "time_device"):
            return columns
        there = np.ones(len(time.values), bool) if time.mask is None else ~time.mask
        dates = time.values.dtype.kind == "M"
        numbers = time.values.view(np.int64) if dates else np.rint(time.values * 1e9).astype(np.int64)
        if self._wanted == "start" and self._first is None and there.any():
            self._first = int(numbers[there][0])
        seconds = np.where(there, numbers - (self._first or 0), 0) / 1e9
        name = "time" if self._wanted == "unix" else "time_device"
        return [time._replace(name=name, values=seconds, mask=~there, facts=time.facts | {"unit": "s"}), *others]
