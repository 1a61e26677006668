"""The times of the rows of tables."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from ..errors import Failure

if TYPE_CHECKING:
    from ..columns import Log
    from ..columns.scan import Array
    from ..columns.tables import Series, Table
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
        from ..columns.continued import Continued

        self._wanted = wanted
        self._first: int | None = None
        self._continued = Continued()
        self._log: Log | None = None
        self._at = -1  # the offset of the last row

    def converted(self, table: Table, log: Log) -> Sequence[Series]:
        """Converts the first of the columns of the next part of a log, which is the time."""
        import numpy as np

        from ..columns.stamps import NONE

        columns = table.columns
        time, *others = columns
        if self._wanted not in ("unix", "start", "clock") or time.name not in ("time", "time_device"):
            return columns
        there = np.ones(len(time.values), bool) if time.mask is None else ~time.mask
        dates = time.values.dtype.kind == "M"
        numbers = time.values.view(np.int64) if dates else np.rint(time.values * 1e9).astype(np.int64)
        if self._wanted == "start":
            if not dates:
                numbers = np.where(there, numbers, NONE)
                self._continued.add(numbers, self._restarts(table.begin, log, time.facts["clock"]))
            if self._first is None and there.any():
                self._first = int(numbers[there][0])
        seconds = np.where(there, numbers - (self._first or 0), 0) / 1e9
        name = "time" if self._wanted == "unix" else "time_device"
        return [time._replace(name=name, values=seconds, mask=~there, facts=time.facts | {"unit": "s"}), *others]

    def _restarts(self, begin: Array, log: Log, clock: str) -> list[int]:
        """Returns the next rows before which the clock restarts. Each log of a stream has offsets from 0."""
        from ..columns import timeline

        before = self._at if log is self._log else -1
        self._log, self._at = log, int(begin[-1]) if len(begin) else before
        places = [at for at in timeline.of_log(log).restarts(clock) if before < at <= self._at]
        return [int(begin.searchsorted(at)) for at in places]
