"""A motion from a CSV file: a recorded or computed trajectory with attitude."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator, Sequence
from difflib import get_close_matches
from itertools import pairwise
from math import cos, degrees, inf, isfinite, pi, radians
from pathlib import Path

from mip_tools.geometry.earth import Vector, radii

from .state import PLACES, MotionError, State, check_place, is_place, state

_TIME = {"s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9}
_LENGTH = {"m": 1.0, "km": 1e3, "ft": 0.3048}
_ANGLE = {"deg": radians(1), "rad": 1.0}
PLACE, LOCAL = ("latitude", "longitude", "height"), ("north", "east", "down")
ATTITUDE = ("roll", "pitch", "yaw")

#: The columns of a file, and the units that each may have.
COLUMNS = {
    "time": _TIME, "latitude": _ANGLE, "longitude": _ANGLE, "height": _LENGTH, **dict.fromkeys(LOCAL, _LENGTH),
    **dict.fromkeys(ATTITUDE, _ANGLE),
}  # fmt: skip

_HEADING = re.compile(r"\s*([a-z]+)\s*(?:\[([^\]]*)\])?\s*\Z")


class Curve:
    """A smooth curve through values: cubic pieces with a slope at each value. It is constant before and after them."""

    def __init__(self, times: Sequence[float], values: Sequence[float]) -> None:
        """The slopes keep the curve between neighbouring values."""
        self.times, self.values, self.slopes = times, values, _slopes(times, values)

    def at(self, t: float) -> Vector:
        """Returns the value, and its first and second derivatives."""
        i = bisect_right(self.times, t)
        if i == 0 or i == len(self.times):
            return self.values[min(i, len(self.times) - 1)], 0.0, 0.0
        h = self.times[i] - self.times[i - 1]
        s = (t - self.times[i - 1]) / h
        a, b = self.values[i - 1], h * self.slopes[i - 1]
        rise = self.values[i] - a
        last = h * self.slopes[i]
        c, d = 3 * rise - 2 * b - last, b + last - 2 * rise
        return a + s * (b + s * (c + s * d)), (b + s * (2 * c + 3 * s * d)) / h, (2 * c + 6 * s * d) / (h * h)


def _slopes(times: Sequence[float], values: Sequence[float]) -> list[float]:
    """Computes slopes (Fritsch and Butland): harmonic means of neighbours, 0 where values turn back or are equal."""
    if len(times) < 2:
        return [0.0] * len(times)
    steps = [b - a for a, b in pairwise(times)]
    rises = [(b - a) / h for a, b, h in zip(values, values[1:], steps)]
    slopes = [rises[0]]
    for h, k, u, v in zip(steps, steps[1:], rises, rises[1:]):
        slopes.append(3 * (h + k) / ((2 * k + h) / u + (k + 2 * h) / v) if u * v > 0 else 0.0)
    return [*slopes, rises[-1]]


class Trajectory:
    """Follows the positions and the attitudes in a CSV file. At its end, the device stays there.

    The first line names the columns, each with its unit: `time [s]`, then `latitude [deg]`, `longitude [deg]`,
    `height [m]`, or `north [m]`, `east [m]`, `down [m]` relative to the options' position; and `roll [deg]`,
    `pitch [deg]`, `yaw [deg]`, each 0 if left out.
    """

    def __init__(
        self, path: str | Path, latitude: float = 47.0, longitude: float = 8.0, height: float = 500.0, *,
        loop: bool = False,
    ) -> None:  # fmt: skip
        check_place("trajectory", latitude, longitude, height)
        table = _Table(path)
        times = [t - table.times[0] for t in table.times]
        self.duration = times[-1]
        self._loop = loop
        still = [0.0] * len(times)
        self._angles = [Curve(times, _unwound(table.columns.get(name, still))) for name in ATTITUDE]
        start = (radians(latitude), radians(longitude), height)
        if table.place == PLACE:
            latitudes, longitudes, heights = (table.columns[name] for name in PLACE)
            self._place = [Curve(times, latitudes), Curve(times, _unwound(longitudes)), Curve(times, heights)]
        else:
            (m, n), c = radii(start[0]), cos(start[0])
            scales = ((m + height, start[0]), ((n + height) * c, start[1]), (-1.0, height))
            self._place = [
                Curve(times, [origin + x / scale for x in table.columns[name]])
                for name, (scale, origin) in zip(LOCAL, scales)
            ]
        for i, t in enumerate(self._place[0].times):
            where = [curve.values[i] for curve in self._place]
            if not is_place(degrees(where[0]), 0.0, where[2]):
                at = table.line(t + table.times[0])
                raise MotionError(f"{path}:{at}:1: the device is at {degrees(where[0]):g}°, {where[2]:g} m; {PLACES}")

    def at(self, t: float) -> State:
        if self._loop and self.duration > 0:
            t %= self.duration
        return state(*(curve.at(t) for curve in (*self._place, *self._angles)))


def _unwound(angles: Sequence[float]) -> list[float]:
    """Removes jumps from angles, which may then exceed a whole turn."""
    unwound: list[float] = []
    for x in angles:
        unwound.append(x - 2 * pi * round((x - unwound[-1]) / (2 * pi)) if unwound else x)
    return unwound


# --------------------------------------------------------------------------- the file


class _Table:
    """The columns of a file, in seconds, metres and radians. Raises MotionError, with line and column."""

    def __init__(self, path: str | Path) -> None:
        self._path = path
        try:
            text = Path(path).read_text("utf-8-sig")
        except OSError as error:
            raise MotionError(f"trajectory: cannot read {path}: {error.strerror}") from None
        except UnicodeDecodeError:
            raise MotionError(f"trajectory: {path} is not a text file in UTF-8") from None
        lines = [(i, line) for i, line in enumerate(text.splitlines(), 1) if line.strip() and line.lstrip()[0] != "#"]
        if len(lines) < 2:
            raise MotionError(f"{path}:1:1: a trajectory needs a line with names and units, and lines of numbers")
        self.place: tuple[str, ...] = ()
        heads = self._headings(*lines[0])
        self.columns: dict[str, list[float]] = {name: [] for name, _ in heads}
        self.times = self.columns["time"]
        self._lines: list[int] = []
        for number, line in lines[1:]:
            self._row(number, line, heads)

    def _wrong(self, line: int, column: int, text: str) -> MotionError:
        return MotionError(f"{self._path}:{line}:{column}: {text}")

    def _headings(self, number: int, line: str) -> list[tuple[str, float]]:
        heads: list[tuple[str, float]] = []
        for column, cell in _cells(line):
            match = _HEADING.match(cell)
            name, unit = match.groups() if match else (cell, None)
            if name not in COLUMNS:
                near = get_close_matches(name, COLUMNS, 1)
                hint = f"do you mean '{near[0]}'?" if near else f"there are {', '.join(COLUMNS)}"
                raise self._wrong(number, column, f"'{name}' is not a column of a trajectory; {hint}")
            units = " or ".join(f"{name} [{unit}]" for unit in COLUMNS[name])
            if unit is None:
                raise self._wrong(number, column, f"'{name}' has no unit; write {units}")
            if unit.strip() not in COLUMNS[name]:
                raise self._wrong(number, column, f"'{name}' cannot have the unit '{unit}'; write {units}")
            if name in (heading for heading, _ in heads):
                raise self._wrong(number, column, f"'{name}' is there twice; remove one")
            heads.append((name, COLUMNS[name][unit.strip()]))
        names = {name for name, _ in heads}
        groups = [kind for kind in (PLACE, LOCAL) if names.intersection(kind)]
        if len(groups) != 1:
            what = "no place" if not groups else "more than one kind of place"
            kinds = "; ".join(", ".join(kind) for kind in (PLACE, LOCAL))
            raise self._wrong(number, 1, f"the file has {what}; it needs one of: {kinds}")
        self.place = groups[0]
        if missing := [name for name in ("time", *self.place) if name not in names]:
            raise self._wrong(number, 1, f"the column {missing[0]} is missing")
        return heads

    def _row(self, number: int, line: str, heads: Sequence[tuple[str, float]]) -> None:
        cells = list(_cells(line))
        if len(cells) != len(heads):
            raise self._wrong(number, 1, f"{len(cells)} values for {len(heads)} columns")
        for (column, cell), (name, scale) in zip(cells, heads):
            try:
                value = float(cell) * scale
            except ValueError:
                value = inf
            if not isfinite(value):
                raise self._wrong(number, column, f"'{cell}' is not a number; {name} needs one")
            if name == "time" and self.times and value <= self.times[-1]:
                raise self._wrong(number, column, f"time {cell} is not later than that on line {self._lines[-1]}")
            self.columns[name].append(value)
        self._lines.append(number)

    def line(self, time: float) -> int:
        """Returns the line of the file that applies at a time."""
        return self._lines[max(0, bisect_right(self.times, time + 1e-9) - 1)]


def _cells(line: str) -> Iterator[tuple[int, str]]:
    """Yields the texts between commas, each with its column."""
    column = 1
    for cell in line.split(","):
        yield column + len(cell) - len(cell.lstrip()), cell.strip()
        column += len(cell) + 1
