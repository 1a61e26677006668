"""The points of a track, and the files that list them."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from math import isfinite
from pathlib import Path
from typing import NamedTuple

from .state import PLACES, MotionError, is_place


class Waypoint(NamedTuple):
    """A point of a track, and the speed from there on; None: the speed of the track."""

    latitude: float  # deg
    longitude: float  # deg
    height: float  # m
    speed: float | None = None  # m/s


def check_track(points: Sequence[Waypoint], loop: bool) -> None:
    """Raises MotionError if the points do not form a track."""
    least = 3 if loop else 2
    if len(points) < least:
        raise MotionError(f"track: {len(points)} waypoints; a track{' that loops' * loop} needs at least {least}")
    for i, p in enumerate(points, 1):
        if not all(isfinite(x) for x in p if x is not None):
            raise MotionError(f"track: waypoint {i} has a value that is not a number")
        if not is_place(p.latitude, p.longitude, p.height):
            raise MotionError(f"track: waypoint {i} is at {p.latitude:g}, {p.longitude:g}, {p.height:g}; {PLACES}")
        if p.speed is not None and p.speed <= 0:
            raise MotionError(f"track: the speed at waypoint {i} is {p.speed:g} m/s; it must be above 0")


def read_text(path: str | Path, motion: str) -> str:
    """Reads the text of a file for a motion. Raises MotionError."""
    try:
        return Path(path).read_text("utf-8-sig")
    except OSError as error:
        raise MotionError(f"{motion}: cannot read {path}: {error.strerror}") from None
    except UnicodeDecodeError:
        raise MotionError(f"{motion}: {path} is not a text file in UTF-8") from None


def read_waypoints(path: str | Path) -> list[Waypoint]:
    """Reads waypoints from a CSV file: latitude, longitude (degrees), height (m), and optionally speed (m/s).

    A heading, empty lines and lines that begin with # are ignored.
    """
    text = read_text(path, "track")
    waypoints: list[Waypoint] = []
    first = True
    for number, row in enumerate(csv.reader(text.splitlines()), 1):
        cells = [cell.strip() for cell in row]
        if not any(cells) or cells[0].startswith("#"):
            continue
        try:
            values = [float(cell) for cell in cells if cell]
        except ValueError:
            if not first:
                raise MotionError(f"{path}:{number}: '{','.join(cells)}' has a value that is not a number") from None
            first = False
            continue
        first = False
        if len(values) not in (3, 4):
            raise MotionError(
                f"{path}:{number}: {len(values)} numbers; a waypoint has latitude, longitude, height and optionally "
                "speed"
            )
        waypoints.append(Waypoint(*values))
    return waypoints
