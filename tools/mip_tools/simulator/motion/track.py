"""A drive along waypoints."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import atan2, cos, degrees, hypot, isfinite, pi, radians, sin, sqrt, tan
from pathlib import Path
from typing import NamedTuple

from .state import MotionError, Plane, State
from .waypoints import Waypoint, check_track, read_waypoints

SHARPEST = radians(170)
STEEPEST = 1.0


@dataclass(frozen=True)
class _Piece:
    """A straight line or an arc of the path."""

    start: float  # m along the path
    length: float
    north: float
    east: float
    heading: float
    curvature: float
    limit: float  # of the speed

    def place(self, s: float) -> tuple[float, float, float]:
        """Returns north, east and heading at `s` metres from the start of the piece."""
        turn = self.curvature * s
        if abs(turn) < 1e-9:
            a = self.heading
            return self.north + s * cos(a), self.east + s * sin(a), a
        a, r = self.heading + turn, 1 / self.curvature
        north = self.north + r * (sin(a) - sin(self.heading))
        return north, self.east - r * (cos(a) - cos(self.heading)), a


class _Phase(NamedTuple):
    """A time of constant acceleration on one piece."""

    time: float
    piece: int
    at: float  # m from the start of the piece
    speed: float
    acceleration: float


class _Lap:
    """The phases from one end of the path to the other."""

    def __init__(self, pieces: Sequence[_Piece], speeds: Sequence[float], acceleration: float) -> None:
        self.phases: list[_Phase] = []
        t, a = 0.0, acceleration
        for i, (piece, u, v) in enumerate(zip(pieces, speeds, speeds[1:])):
            top = min(piece.limit, sqrt((2 * a * piece.length + u * u + v * v) / 2))
            top = max(top, u, v)
            up, down = (top * top - u * u) / (2 * a), (top * top - v * v) / (2 * a)
            steps = [(0.0, u, a, (top - u) / a), (up, top, 0.0, max(0.0, piece.length - up - down) / top)]
            steps.append((piece.length - down, top, -a, (top - v) / a))
            for at, speed, rate, duration in steps:
                if duration > 0:
                    self.phases.append(_Phase(t, i, at, speed, rate))
                    t += duration
        self.duration = t
        self.times = [phase.time for phase in self.phases]

    def at(self, t: float) -> tuple[int, float, float, float]:
        """Returns the piece, the metres from its start, the speed and the acceleration."""
        phase = self.phases[max(0, bisect_right(self.times, t) - 1)]
        dt = t - phase.time
        speed = phase.speed + phase.acceleration * dt
        return (phase.piece, phase.at + (phase.speed + speed) / 2 * dt, max(0.0, speed), phase.acceleration)


class Track:
    """Drives along waypoints. Starts at rest at the first one, and stops at the last one or repeats forever (`loop`).

    Corners are rounded with a radius of `corner` metres, or less between short legs. The climb between two waypoints
    begins and ends level. No acceleration, along or across the path or vertical, exceeds `acceleration`.
    """

    def __init__(
        self, points: Iterable[Waypoint] | str | Path, speed: float = 10.0, *, acceleration: float = 2.0,
        corner: float = 10.0, loop: bool = False,
    ) -> None:  # fmt: skip
        for name, value in (("speed", speed), ("acceleration", acceleration), ("corner", corner)):
            if not (isfinite(value) and value > 0):
                raise MotionError(f"track: {name}={value:g} must be above 0")
        points = read_waypoints(points) if isinstance(points, (str, Path)) else list(points)
        check_track(points, loop)
        first = points[0]
        self._plane = Plane(radians(first.latitude), radians(first.longitude), first.height)
        self._limit, self._loop = acceleration, loop
        self._lay(points, speed, corner)
        self._drive()

    def _lay(self, points: list[Waypoint], speed: float, corner: float) -> None:
        """Builds the path of lines and arcs, with the distances at which the heights of the waypoints are reached."""
        plane, count = self._plane, len(points)
        places = []
        for p in points:
            east = (radians(p.longitude) - plane.longitude + pi) % (2 * pi) - pi
            places.append(((radians(p.latitude) - plane.latitude) * plane.along, east * plane.across))
        legs = []
        for i in range(count if self._loop else count - 1):
            (n, e), (n2, e2) = places[i], places[(i + 1) % count]
            length = hypot(n2 - n, e2 - e)
            if length < 0.01:
                pair = f"{i + 1} and {(i + 1) % count + 1}"
                raise MotionError(f"track: waypoints {pair} are at the same place; remove one")
            legs.append((length, atan2(e2 - e, n2 - n)))
        arcs = [self._arc(legs, i, corner) for i in range(len(legs) if self._loop else len(legs) + 1)]
        self._pieces: list[_Piece] = []
        s, self._marks, self._heights = (0.0, [-arcs[0][1] / 2], [p.height - points[0].height for p in points])
        if self._loop:
            self._heights.append(0.0)
        limits = [self._fastest(i, legs, arcs, points[i].speed or speed) for i in range(len(legs))]
        for i, (length, heading) in enumerate(legs):
            (cut, *_), (end_cut, arc, bend) = arcs[i], arcs[(i + 1) % len(arcs)]
            n, e = places[i][0] + cut * cos(heading), places[i][1] + cut * sin(heading)
            line = length - cut - end_cut
            if line > 1e-6:  # otherwise the two corners meet
                self._pieces.append(_Piece(s, line, n, e, heading, 0.0, limits[i]))
                s += line
                n, e, _ = self._pieces[-1].place(line)
            self._marks.append(s + arc / 2)
            if arc > 0:
                limit = min(limits[i], limits[(i + 1) % len(limits)], sqrt(self._limit / abs(bend)))
                self._pieces.append(_Piece(s, arc, n, e, heading, bend, limit))
                s += arc
        self._length = s

    def _fastest(
        self, i: int, legs: list[tuple[float, float]], arcs: list[tuple[float, float, float]], speed: float
    ) -> float:
        """Returns the speed, at most `speed`, at which the climb of a leg does not exceed the acceleration."""
        (cut, arc, _), (end_cut, end_arc, _) = arcs[i], arcs[(i + 1) % len(arcs)]
        climb = abs(self._heights[i + 1] - self._heights[i])
        way = legs[i][0] - cut - end_cut + (arc + end_arc) / 2
        if 1.875 * climb > STEEPEST * way:
            raise MotionError(
                f"track: from waypoint {i + 1} the path climbs {climb:g} m in {way:.0f} m; "
                "move the waypoints farther apart"
            )
        return min(speed, sqrt(self._limit * way * way / (5.7736 * climb))) if climb else speed

    def _arc(self, legs: list[tuple[float, float]], i: int, corner: float) -> tuple[float, float, float]:
        """Returns the length that the corner at waypoint `i` cuts off its legs, its arc length, and its curvature."""
        if not self._loop and i in (0, len(legs)):
            return 0.0, 0.0, 0.0
        (before, a), (after, b) = legs[i - 1], legs[i % len(legs)]
        turn = (b - a + pi) % (2 * pi) - pi
        if abs(turn) < 1e-6:
            return 0.0, 0.0, 0.0
        if abs(turn) > SHARPEST:
            raise MotionError(
                f"track: at waypoint {i + 1} the path turns back by {abs(degrees(turn)):.0f} degrees; "
                "add another waypoint beside it"
            )
        cut = min(corner * tan(abs(turn) / 2), before / 2, after / 2)
        radius = cut / tan(abs(turn) / 2)
        return cut, radius * abs(turn), (1 if turn > 0 else -1) / radius

    def _drive(self) -> None:
        """Computes the speed at each joint of two pieces, then the times."""
        pieces, a = self._pieces, self._limit
        count = len(pieces)
        most = [min(pieces[i - 1].limit, pieces[i % count].limit) for i in range(count + 1)]
        if not self._loop:
            most[0] = most[-1] = 0.0
        speeds = list(most)
        for _ in range(3 if self._loop else 1):
            if self._loop:
                speeds[-1] = speeds[0] = min(speeds[0], speeds[-1])
            for i in reversed(range(count)):
                speeds[i] = min(speeds[i], sqrt(speeds[i + 1] ** 2 + 2 * a * pieces[i].length))
            if self._loop:
                speeds[-1] = speeds[0] = min(speeds[0], speeds[-1])
            self._hasten(speeds)
        self._first: list[_Lap] = []
        if not self._loop:
            self._lap = _Lap(pieces, speeds, a)
            self._begin = 0.0
            return
        speeds[0] = speeds[-1] = min(speeds[0], speeds[-1])
        self._lap = _Lap(pieces, speeds, a)
        begin = 0.0
        while begin < speeds[0] - 1e-9:
            lap = [begin, *speeds[1:]]
            self._hasten(lap)
            self._first.append(_Lap(pieces, lap, a))
            begin = lap[-1]
        self._begin = sum(lap.duration for lap in self._first)

    def _hasten(self, speeds: list[float]) -> None:
        """Limits the speed at each joint to what is reachable from the joint before it."""
        for i, piece in enumerate(self._pieces):
            speeds[i + 1] = min(speeds[i + 1], sqrt(speeds[i] ** 2 + 2 * self._limit * piece.length))

    @property
    def duration(self) -> float | None:
        """The duration in seconds; None if the track repeats."""
        return None if self._loop else self._lap.duration

    def at(self, t: float) -> State:
        t = max(0.0, t)
        lap = self._lap
        if self._loop:
            if t >= self._begin:
                t = (t - self._begin) % lap.duration
            else:
                for lap in self._first:
                    if t < lap.duration:
                        break
                    t -= lap.duration
        if not self._loop and t >= lap.duration:
            index, along, speed, rate = len(self._pieces) - 1, self._pieces[-1].length, 0.0, 0.0
        else:
            index, along, speed, rate = lap.at(t)
        piece = self._pieces[index]
        north, east, heading = piece.place(along)
        up, grade, bend = self._climb(piece.start + along)
        return self._plane.state(
            north, east, up, (cos(heading), sin(heading)), speed, rate, piece.curvature, grade, bend
        )

    def _climb(self, s: float) -> tuple[float, float, float]:
        """Returns the height above the first waypoint, the grade, and the change of the grade."""
        marks, heights = self._marks, self._heights
        if s > marks[-1]:
            s -= self._length if self._loop else s - marks[-1]
        i = min(bisect_right(marks, s) - 1, len(marks) - 2)
        way, climb = marks[i + 1] - marks[i], heights[i + 1] - heights[i]
        if climb == 0:
            return heights[i], 0.0, 0.0
        u = (s - marks[i]) / way
        up = climb * u * u * u * (10 + u * (6 * u - 15))
        grade = climb / way * 30 * u * u * (u - 1) * (u - 1)
        return heights[i] + up, grade, climb / (way * way) * 60 * u * (1 + u * (2 * u - 3))
