"""Motions: their values agree with each other, nothing jumps, and bad descriptions are refused."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from math import atan2, cos, degrees, dist, hypot, isclose, sin, sqrt
from pathlib import Path
from tempfile import NamedTemporaryFile
from typing import Any

import pytest
from mip_simulator.motion import (
    Circle,
    Motion,
    MotionError,
    Standing,
    Trajectory,
    parse_motion,
)  # fmt: skip
from mip_tools.geometry.attitude import attitude_matrix, euler, euler_rotation, quaternion, rotation_vector
from support import rounds

A, F = 6378137.0, 1 / 298.257223563
YEAR = 365 * 86_400.0


def trajectory(head: str, *rows: Sequence[float], **options: Any) -> Trajectory:
    """A motion from a file with these rows."""
    with NamedTemporaryFile("w+", suffix=".csv") as file:
        file.write("\n".join((head, *(",".join(map(str, row)) for row in rows))))
        file.flush()
        return Trajectory(file.name, **options)


#: A flight with bends, climbs and rolls; the heading passes south.
FLIGHT = [
    (
        t / 2,
        4e-3 * sin(t / 30),
        179.999 + 2e-4 * t,
        900 + 40 * cos(t / 20),
        40 * sin(t / 7),
        80 * sin(t / 11),
        150 + 3 * t,
    )
    for t in range(0, 1400, 3)
]
ANGLES = "roll [deg],pitch [deg],yaw [deg]"
#: Each is made when a test needs it: reading long ones takes half a second.
MOTIONS: dict[str, Callable[[], Motion]] = {
    "standing": lambda: Standing(-33.0, 151.0, 20.0, heading=200, pitch=12, roll=-7),
    "circle": lambda: Circle(20, 5),
    "fast circle": lambda: Circle(300, 60, -78.0, 170.0),
    "trajectory": lambda: trajectory(
        f"time [s],latitude [deg],longitude [deg],height [m],{ANGLES}",
        *((*row[:2], (row[2] + 180) % 360 - 180, *row[3:6], (row[6] + 180) % 360 - 180) for row in FLIGHT),
    ),
    "local trajectory": lambda: trajectory(
        f"time [ms],east [km],north [ft],down [m],{ANGLES}",
        *((500 * t, sin(t / 5), 900 * cos(t / 5), t, 0, 3, 20 * t) for t in range(0, 1200)),
        latitude=-60.0,
    ),
}
each = pytest.mark.parametrize("motion", MOTIONS, indirect=True)
made = cache(lambda name: MOTIONS[name]())


@pytest.fixture
def motion(request: pytest.FixtureRequest) -> Motion:
    return made(request.param)


STEP = 1e-3


def times(motion: Motion) -> list[float]:
    """Irregular moments, and some a year later."""
    early = [1.37 * i + 0.011 for i in range(1, rounds(160, 600))]
    return early + [YEAR + t for t in early[:40]]


def radii(latitude: float, height: float) -> tuple[float, float]:
    e2 = F * (2 - F)
    w = 1 - e2 * sin(latitude) ** 2
    return A * (1 - e2) / w**1.5 + height, (A / sqrt(w) + height) * cos(latitude)


@each
def test_attitude_in_all_forms(motion: Motion) -> None:
    for t in times(motion):
        s = motion.at(t)
        assert isclose(hypot(*s.quaternion), 1, abs_tol=1e-12) and s.quaternion[0] >= 0
        assert dist(attitude_matrix(s.quaternion), s.dcm) < 1e-12
        roll, pitch, yaw = euler(s.dcm)
        assert dist(euler_rotation(roll, pitch, yaw)[1], s.dcm) < 1e-12
        assert dist(quaternion(s.dcm), s.quaternion) < 1e-9


@each
def test_velocity_is_the_change_of_the_position(motion: Motion) -> None:
    """To 1 mm/s: within a step the speed changes by up to acceleration * step = 2 mm/s, half of it on average."""
    for t in times(motion):
        a, b = motion.at(t - STEP / 2), motion.at(t + STEP / 2)
        north, east = radii(a.latitude, a.height)
        moved = (
            (b.latitude - a.latitude) * north / STEP,
            (b.longitude - a.longitude) * east / STEP,
            (a.height - b.height) / STEP,
        )
        middle = [(x + y) / 2 for x, y in zip(a.velocity, b.velocity)]
        assert dist(moved, middle) < 1e-3 + 1e-7 * t / 60, t


@each
def test_acceleration_is_the_change_of_the_velocity(motion: Motion) -> None:
    """Where the acceleration steps, the change lies between both values."""
    for t in times(motion)[:600]:
        a, b = motion.at(t), motion.at(t + STEP)
        change = [(y - x) / STEP for x, y in zip(a.velocity, b.velocity)]
        middle = [(x + y) / 2 for x, y in zip(a.acceleration, b.acceleration)]
        assert dist(change, middle) <= dist(a.acceleration, b.acceleration) / 2 + 2e-5, t


@each
def test_rate_is_the_change_of_the_attitude(motion: Motion) -> None:
    for t in times(motion)[:600]:
        a, b = motion.at(t), motion.at(t + STEP)
        turned = [x / STEP for x in rotation_vector(a.quaternion, b.quaternion)]
        middle = [(x + y) / 2 for x, y in zip(a.rate, b.rate)]
        assert dist(turned, middle) <= dist(a.rate, b.rate) / 2 + 1e-6, t


@pytest.mark.parametrize("name", ["circle", "fast circle"])
def test_vehicles_point_where_they_go(name: str) -> None:
    moving = [s for s in map(made(name).at, times(made(name))) if hypot(*s.velocity) > 0.01]
    assert moving
    for s in moving:
        north, east, down = s.velocity
        roll, pitch, yaw = euler(s.dcm)
        assert roll == 0 and isclose(pitch, atan2(-down, hypot(north, east)), abs_tol=1e-9)
        assert hypot(sin(yaw) - east / hypot(north, east), cos(yaw) - north / hypot(north, east)) < 1e-9


# --------------------------------------------------------------------------- descriptions


def test_motions_by_name() -> None:
    described = {
        "standing": Standing(), "standing:heading=90,roll=2": Standing(heading=90, roll=2),
        "circle:radius=7,speed=3,latitude=-10": Circle(7, 3, -10),
    }  # fmt: skip
    for text, motion in described.items():
        for t in (0.0, 3.7, 20.0):
            assert parse_motion(text).at(t) == motion.at(t), text


@pytest.mark.parametrize(
    "text, message",
    {
        "fly": "'fly' is not a motion; use one of standing, circle, trajectory, replay",
        "circle:size=3": "circle: unknown option 'size'; it has radius, speed, latitude, longitude, height",
        "circle:radius": "circle: option 'radius' has no value; write radius=...",
        "circle:radius=1,radius=2": "circle: option 'radius' is given twice",
        "circle:radius=big": "circle: radius: 'big' is not a number",
        "circle:radius=nan": "circle: radius: 'nan' is not a number",
        "circle:radius=0": "circle: radius=0 must be above 0, and at most 1e6",
        "circle:speed=1e7": "circle: speed=1e+07 must be above 0, and at most 1e6",
        "circle:height=1e7":
            "circle: latitude 47, longitude 8, height 1e+07 is not a place; use degrees, with a latitude of -89 to 89, "
            "and a height of -10 to 1000 km",
        "standing:latitude=95":
            "standing: latitude 95, longitude 8, height 500 is not a place; use degrees, with a latitude of -89 to 89, "
            "and a height of -10 to 1000 km",
        "trajectory": "trajectory: needs a file; write trajectory:file=PATH",
        "trajectory:file=": "trajectory: needs a file; write trajectory:file=PATH",
        "trajectory:file=x,loop=maybe": "trajectory: loop: 'maybe' is neither yes nor no",
        "replay": "replay: needs a file; write replay:file=PATH",
    }.items(),
)  # fmt: skip
def test_descriptions_that_are_wrong(text: str, message: str) -> None:
    with pytest.raises(MotionError) as error:
        parse_motion(text)
    assert str(error.value) == message


def test_a_trajectory_passes_its_rows() -> None:
    motion = made("trajectory")
    for t, latitude, longitude, height, roll, pitch, yaw in FLIGHT:
        state = motion.at(t)
        assert isclose(degrees(state.latitude), latitude, abs_tol=1e-12) and isclose(state.height, height)
        assert isclose((degrees(state.longitude) - longitude + 180) % 360, 180, abs_tol=1e-9)
        for angle, wanted in zip(euler(state.dcm), (roll, pitch, yaw), strict=True):
            assert isclose((degrees(angle) - wanted + 180) % 360, 180, abs_tol=1e-6)
    assert motion.at(FLIGHT[-1][0] + 1).velocity == (0, 0, 0)


def test_a_trajectory_stays_between_its_rows() -> None:
    """A device that rests in the file is at rest, and does not swing before it starts."""
    motion = trajectory(
        "time [s],north [m],east [m],down [m]", (5, 0, 0, 0), (15, 0, 0, 0), (16, 5, 0, 0), (17, 20, 0, 0)
    )
    assert all(motion.at(t / 10).velocity == (0, 0, 0) for t in range(100))
    assert all(motion.at(10 + t / 10).velocity[0] >= 0 for t in range(20)) and motion.at(11.5).velocity[0] > 10


@pytest.mark.parametrize(
    "rows, message",
    [
        ("", ":1:1: a trajectory needs a line with names and units, and lines of numbers"),
        ("time [s],north\n0,1", ":1:10: 'north' has no unit; write north [m] or north [km] or north [ft]"),
        ("time [s],north [mi]\n0,1", ":1:10: 'north' cannot have the unit 'mi'; write north [m] or north [km] or"),
        ("time [s], norht [m]\n0,1", ":1:11: 'norht' is not a column of a trajectory; do you mean 'north'?"),
        ("time [s],time [s]\n0,1", ":1:10: 'time' is there twice; remove one"),
        ("north [m],east [m],down [m]\n1,1,1", ":1:1: the column time is missing"),
        ("time [s],north [m]\n0,1", ":1:1: the column east is missing"),
        ("time [s]\n0", ":1:1: the file has no place; it needs one of: latitude, longitude, height; "),
        ("time [s],height [m],north [m]\n0,1,1", ":1:1: the file has more than one kind of place; it needs"),
        ("# a\ntime [s],north [m],east [m],down [m]\n0,1,1,1\n\n1, x,1,1", ":5:4: 'x' is not a number; north needs"),
        ("time [s],north [m],east [m],down [m]\n0,1,1,nan", ":2:7: 'nan' is not a number; down needs one"),
        ("time [s],north [m],east [m],down [m]\n0,1", ":2:1: 2 values for 4 columns"),
        ("time [s],north [m],east [m],down [m]\n1,1,1,1\n1,2,2,2", ":3:1: time 1 is not later than that on line 2"),
        ("time [s],latitude [deg],longitude [deg],height [m]\n0,1,1,1\n1,95,0,0", ":3:1: the device is at 95°, 0 m"),
    ],
)  # fmt: skip
def test_trajectories_that_are_wrong(tmp_path: Path, rows: str, message: str) -> None:
    (tmp_path / "t.csv").write_text(rows)
    with pytest.raises(MotionError) as error:
        parse_motion(f"trajectory:file={tmp_path}/t.csv")
    assert f"t.csv{message}" in str(error.value) and "\n" not in str(error.value)
