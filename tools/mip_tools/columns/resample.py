"""Makes tables with equal steps, with values between the times at which they were measured."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

import numpy as np

from ..binding import UNIT_KEYS
from . import tables, timeline, times
from .column import Column
from .distinct import distinct
from .packets import Packets
from .scan import Array
from .stamps import NONE
from .tables import Form, Series

METHODS = ("linear", "nearest", "last")
_SECOND = 1_000_000_000
#: If no packet has a time for this long, or if time goes back this far, the grid ends and a new one begins.
PAUSE = 10 * _SECOND
#: A value remains valid for this many usual intervals of its field.
_USUAL = 2.5
_CIRCLES = {"rad": 2 * np.pi, "deg": 360.0}
_QUATERNION = ("w", "x", "y", "z")
_RATE = re.compile(r"\s*([0-9.eE+-]+)\s*(Hz|kHz|s|ms|us)\s*")
_UNITS = {"Hz": 1.0, "kHz": 1000.0, "s": 1.0, "ms": 1e-3, "us": 1e-6}


def parse_step(rate: str | float) -> int:
    """Returns the nanoseconds between two rows for "100Hz", "10ms", or a number in Hz. Raises ValueError."""
    match = _RATE.fullmatch(rate if isinstance(rate, str) else f"{rate}Hz")
    try:
        value = float(match[1]) * _UNITS[match[2]] if match else 0.0
        nanoseconds = round(_SECOND / value if match and match[2].endswith("Hz") else _SECOND * value)
    except (ValueError, OverflowError, ZeroDivisionError):
        nanoseconds = 0
    if not 1000 <= nanoseconds <= 3600 * _SECOND:
        raise ValueError(f"rate {rate!r}: write '100Hz', '10ms', or a number in Hz, from once an hour to 1 MHz")
    return nanoseconds


def resampled(log: Packets, columns: Sequence[Column[Any]], every: int, method: str, form: Form) -> list[Series]:
    """Makes the columns of the table, with a row every `every` nanoseconds. Raises ValueError."""
    if method not in METHODS:
        raise ValueError(f"method {method!r}: {', '.join(METHODS)}")
    clock = timeline.Clocks(form.dated, form.undated, form.covers).steady
    if not clock:
        raise ValueError("the log has no valid timestamps to resample by")
    row_times: list[Array] = []
    converted: dict[str, str] = {}
    for column in columns:
        time, others = times.merged_times(log, column, clock)
        row_times.append(time)
        converted |= others
    if not any((time != NONE).any() for time in row_times):
        raise ValueError(f"none of these fields is in packets with a time by the {clock} clock; leave out the rate")
    spans = _spans(columns, row_times, timeline.of_log(log).restarts(clock))
    grids = [np.arange(-(-first // every) * every, last + 1, every) for first, last, *_ in spans]
    facts = {}
    if converted:
        facts["converted"] = ", ".join(f"{set_number} from {other}" for set_number, other in sorted(converted.items()))
    grid = np.concatenate(grids) if grids else np.zeros(0, np.int64)
    series = [tables.time_column(grid, clock, **facts)]
    if form.dated and form.undated and (form.shown is None or form.dated in form.shown):
        dates = [times.dates(log, part, span[2:], clock, form.dated) for part, span in zip(grids, spans)]
        series.insert(0, tables.time_column(np.concatenate([*dates, np.zeros(0, np.int64)]), form.dated))
    for column, time in zip(columns, row_times):
        usual = _usual(time)
        for group in tables.column_groups(column, form, len(columns) == 1):
            parts: list[list[Series]] = []
            for (_, _, begin, end), grid in zip(spans, grids):
                here = (column.offset >= begin) & (column.offset < end) & (time != NONE)
                parts.append(_sampled(group, time, here, grid, method, max(usual, every)))
            series += [_after_each_other(list(same)) for same in zip(*parts)]
    return series


def _after_each_other(parts: list[Series]) -> Series:
    masks = [np.zeros(len(p.values), bool) if p.mask is None else p.mask for p in parts]
    return parts[0]._replace(values=np.concatenate([p.values for p in parts]), mask=np.concatenate(masks))


def _spans(
    columns: Sequence[Column[Any]], merged: Sequence[Array], restarts: list[int]
) -> list[tuple[int, int, int, int]]:
    """Returns the first and the last time of each part without a pause, and where it begins and ends in the file."""
    offset = np.concatenate([column.offset for column in columns])
    time = np.concatenate(merged)
    there = time != NONE
    offset, time = offset[there], time[there]
    order = np.argsort(offset, kind="stable")
    offset, time = offset[order], time[order]
    steps = np.diff(time)
    begins = np.searchsorted(offset, restarts)
    cuts = distinct(np.flatnonzero((steps > PAUSE) | (steps < -PAUSE)) + 1, begins[begins < len(time)])
    spans = []
    for begin, end in zip([0, *cuts.tolist()], [*cuts.tolist(), len(time)]):
        if end > begin:
            part = time[begin:end]
            stop = int(offset[end]) if end < len(time) else int(offset[-1]) + 1
            spans.append((int(part.min()), int(part.max()), int(offset[begin]), stop))
    return spans


def _usual(time: Array) -> float:
    """Returns the time for which a value remains valid, in nanoseconds."""
    steps = np.diff(distinct(time[time != NONE]))
    return float(np.median(steps)) * _USUAL if len(steps) else 0.0


def _sampled(group: list[Series], time: Array, here: Array, grid: Array, method: str, reach: float) -> list[Series]:
    """Resamples a group of columns on a grid; values further away than `reach` nanoseconds are not used."""
    there = here.copy()
    for series in group:
        if series.mask is not None:
            there &= ~series.mask
    rows = np.flatnonzero(there)
    rows = rows[np.argsort(time[rows], kind="stable")]
    when = time[rows]
    last = np.ones(len(when), bool)  # of several values at one time, the last one is used
    last[:-1] = when[1:] != when[:-1]
    rows, when = rows[last], when[last]
    if not len(rows):
        size, gone = len(grid), np.ones(len(grid), bool)
        empty = [np.zeros((size, *series.values.shape[1:]), series.values.dtype) for series in group]
        return [series._replace(values=values, mask=gone) for series, values in zip(group, empty)]
    left = np.clip(np.searchsorted(when, grid, side="right") - 1, 0, len(rows) - 1)
    right = np.clip(left + 1, 0, len(rows) - 1)
    right = np.where(when[left] >= grid, left, right)  # there is a value at that very time, or none before it
    before, after = when[left] <= grid, when[right] >= grid
    floats = all(series.values.dtype.kind == "f" and series.values.ndim == 1 for series in group) and len(group) < 9
    if method == "linear" and floats:
        missing = ~(before & after) | (when[right] - when[left] > reach)
        span = np.maximum(when[right] - when[left], 1)
        weight = np.where(missing, 0.0, (grid - when[left]) / span)
        a = [series.values[rows[left]].astype(np.float64) for series in group]
        b = [series.values[rows[right]].astype(np.float64) for series in group]
        results = _between(group, a, b, weight, [series.values[rows] for series in group])
        return [
            series._replace(values=v.astype(series.values.dtype), mask=missing) for series, v in zip(group, results)
        ]
    chosen = left
    if method == "nearest":
        chosen = np.where(np.abs(when[right] - grid) < np.abs(grid - when[left]), right, left)
        missing = np.abs(when[chosen] - grid) > reach / 2
    else:
        missing = ~before | (grid - when[left] > reach)
    return [series._replace(values=series.values[rows[chosen]], mask=missing) for series in group]


def _between(group: list[Series], a: list[Array], b: list[Array], weight: Array, every: list[Array]) -> list[Array]:
    """Interpolates between two values: quaternions by direction, angles the short way round."""
    if tuple(series.name.rpartition(".")[2] for series in group) == _QUATERNION:
        sign = np.where(sum(x * y for x, y in zip(a, b)) < 0, -1.0, 1.0)  # both are the same rotation
        mixed = [x + weight * (sign * y - x) for x, y in zip(a, b)]
        size = np.sqrt(np.sum(np.square(mixed), axis=0))
        exact = (weight == 0) | (size == 0)
        return [np.where(exact, x, m / np.where(exact, 1.0, size)) for x, m in zip(a, mixed)]
    results: list[Array] = []
    for series, x, y, values in zip(group, a, b, every):
        unit = series.facts.get("unit", "")
        circle = _CIRCLES.get(UNIT_KEYS.get(unit, unit), 0.0)
        low = _lowest(values, circle)
        if low is None:
            results.append(x + weight * (y - x))
            continue
        way = (y - x + circle / 2) % circle - circle / 2
        angle = x + weight * way
        outside = (angle < low) | (angle >= low + circle)
        results.append(np.where(outside & (weight > 0), (angle - low) % circle + low, angle))
    return results


def _lowest(values: Array, circle: float) -> float | None:
    """Returns the lower end of the range of angles: 0, or minus half a turn; None if they have neither range."""
    if not circle:
        return None
    least, most = float(np.nanmin(values, initial=0.0)), float(np.nanmax(values, initial=0.0))
    if least >= -circle * 0.5001 and most <= circle * 0.5001:
        return -circle / 2
    return 0.0 if least >= 0 and most <= circle * 1.0001 else None
