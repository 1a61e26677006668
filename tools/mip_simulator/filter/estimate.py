"""The estimation filter of a device: its states follow from the time and the sources that it has, and its errors are as
large as the uncertainties that it states.

An estimate is the truth plus an error, which wanders within the uncertainty. An uncertainty shrinks after a start, and
grows while the filter has no source.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from math import exp, hypot, pi, remainder, sin, sqrt
from random import Random
from typing import NamedTuple

from mip_tools.geometry import earth
from mip_tools.geometry.attitude import euler
from mip_tools.geometry.earth import SECOND, Vector

from ..motion.state import State
from ..surroundings.surroundings import Surroundings

#: The step at which the filter looks at its sources, and of GNSS receivers, in nanoseconds.
STEP = SECOND // 5
#: The maximum number of steps at once; of a longer time, only the end matters.
MOST_STEPS = 500
#: For how many seconds the filter of a new simulation has run.
SETTLED = 600 * SECOND
#: Seconds from the start of the filter until it has leveled itself, a heading, and a position.
LEVELED, ALIGNED, PLACED = 1.0, 1.5, 2.0
#: The speed in m/s from which on the direction of motion is used as the heading.
KINEMATIC = 2.0
#: Seconds for which a measurement from the user is considered recent, and after which a start has faded.
FRESH, FADES = 5.0, 15.0

# Deviations of a filter that has settled, and what is added at its start.
TILT, NEW_TILT = 0.002, 0.03
HEADING, NEW_HEADING, UNKNOWN_HEADING = 0.02, 0.05, pi / sqrt(3)
DUAL_ANTENNA = 0.01
POSITION, VELOCITY = (0.5, 0.5, 0.8), (0.03, 0.03, 0.05)
GYRO_BIAS, NEW_GYRO_BIAS, ACCEL_BIAS, NEW_ACCEL_BIAS = 2e-5, 3e-4, 0.004, 0.012
#: Without a source, a heading turns by so many rad per second, and a position accelerates by so many m/s^2.
TURNS, DRIFTS = 2e-4, 0.025
#: Deviations of GNSS positions and velocities along north, east and down.
FIX, FIX_VELOCITY = (sqrt(0.5), sqrt(0.5), 1.5), 0.1 / sqrt(3)
#: Deviations above which the filter is still converging, and warns: tilt, heading, position, velocity.
CONVERGED, WARNED = (0.01, 0.05, 2.0, 0.3), (0.03, 0.2, 10.0, 1.0)
#: The gyroscope bias above which the filter warns.
HIGH_GYRO_BIAS = 0.01
#: The deviation of the complementary filter's angles.
COMPLEMENTARY = 0.002

#: Headings that the user sends, by their names in the commands.
HEADING_UPDATES = ("filter_external_heading_update", "filter_external_heading_update_with_time")
HEADINGS = (*HEADING_UPDATES, "aiding_true_heading")
#: Source in `aiding_measurement_enable` -> kinds of measurements.
SOURCES = {
    "gnss_position_velocity": "gnss", "gnss_heading": "dual_antenna", "altimeter": "pressure", "mag": "mag",
    "external_heading": "heading", "external_altimeter": "aiding_height_above_ellipsoid",
    "body_frame_velocity": "aiding_body_frame_velocity",
}  # fmt: skip


class Aid(NamedTuple):
    """A kind of aiding measurement, from one source, and its use."""

    source: int
    type: str
    indicator: tuple[str, ...]


@dataclass
class Options:
    """The settings of the filter."""

    waits: bool = False  # for the command `filter.run`
    automatic: bool = True  # initializes itself
    alignment: frozenset[str] = frozenset(("dual_antenna", "kinematic", "mag"))
    heading: float | None = None  # given by the user
    place: bool = False  # the initial position and velocity are given by the user
    external_heading: bool = True  # heading updates are accepted
    disabled: frozenset[str] = frozenset()  # kinds of measurements
    receivers: frozenset[int] = frozenset((1, 2))
    dynamics: str = ""


class Filter:
    """The filter of a world. `settled`: it has already converged at the start."""

    def __init__(self, world: Surroundings, settled: bool) -> None:
        self._world = world
        self.options = Options()
        self._heard: dict[str, float] = {}  # kinds of measurements that the user sends -> when, in seconds
        self.reset()
        self._starts = settled
        if settled:
            self._began -= SETTLED

    def reset(self) -> None:
        """Returns to initialization."""
        self.level = self.aligned = self.placed = False
        self._ran = False
        self._began = self._time = self._world.now
        self._turned = 0.0  # the error of a heading that nothing corrects
        self._headed = self._located = self._began  # when the heading and the position last had a source

    def run(self) -> None:
        self._ran = True
        self._began = self._world.now

    # ------------------------------------------------------------------ time

    def advance(self) -> None:
        """Advances the filter to the time of the world."""
        now = self._world.now
        if self._starts:  # with the settings that it has by then
            self._starts = False
            self._step(self._world.motion.at(self._time / SECOND))
        self._time = max(self._time, now - MOST_STEPS * STEP)
        while self._time + STEP <= now:
            self._time += STEP
            self._step(self._world.motion.at(self._time / SECOND))

    def _step(self, state: State) -> None:
        if self.options.waits and not self._ran:
            self._began = self._headed = self._located = self._time
            return
        age = self._age
        if not self.options.automatic and not self.level:
            return
        if not self.level and age >= LEVELED:
            self.set_heading(state, self.options.heading or 0.0)
        if self.level and not self.aligned and age >= ALIGNED:
            self.aligned = self.options.heading is not None or self._aligns(state)
            if self.options.heading is None and self.aligned:
                self._turned = 0.0
        if self.aligned and not self.placed and age >= PLACED and self._world.has("position"):
            self.placed = self._has_place or self.options.place
        if not self.aligned or self._has_heading(state):
            self._headed = self._time
        if self.aligned and self._has_heading(state):
            self._turned *= exp(-STEP / SECOND)
        if not self.placed or self._has_place:
            self._located = self._time

    @property
    def _age(self) -> float:
        return (self._time - self._began) / SECOND

    def set_heading(self, state: State, yaw: float) -> None:
        """Levels the filter, with a heading that is wrong until a source corrects it."""
        self.level = True
        self._turned = remainder(yaw - euler(self._world.vehicle_of(state))[2], 2 * pi)

    # ------------------------------------------------------------------ sources

    def _has(self, kind: str) -> bool:
        """Does the device have this kind of measurement, and is it enabled?"""
        world = self._world
        if ("heading" if kind in HEADINGS else kind) in self.options.disabled:
            return False
        if kind in ("gnss", "dual_antenna"):
            return len(self._receivers) >= (2 if kind == "dual_antenna" else 1)
        return world.has(kind) if kind in ("mag", "pressure") else True

    @property
    def _receivers(self) -> tuple[int, ...]:
        """The receivers whose positions the filter uses."""
        if not self._world.gnss or "gnss" in self.options.disabled:
            return ()
        return tuple(r for r in sorted(self.options.receivers) if self._world.has(f"gnss_{r}"))

    def _sources(self, state: State) -> dict[str, bool]:
        """The sources of a heading, by their names in `filter.initialization_config`."""
        return {
            "dual_antenna": self._has("dual_antenna"),
            "mag": self._has("mag"),
            "kinematic": hypot(*state.velocity[:2]) >= KINEMATIC and self._has("gnss"),
            "external": any(self._fresh(kind) and self._has(kind) for kind in HEADINGS),
        }

    def _aligns(self, state: State) -> bool:
        return any(has and name in self.options.alignment for name, has in self._sources(state).items())

    def _has_heading(self, state: State) -> bool:
        return any(self._sources(state).values())

    @property
    def _has_place(self) -> bool:
        return bool(self._receivers) or any("position" in kind or "gnss" in kind for kind in self._recent)

    def hear(self, kind: str) -> None:
        """Uses a measurement from the user, which is taken to be right."""
        self._heard[kind] = self._world.time

    @property
    def _recent(self) -> list[str]:
        return [kind for kind in sorted(self._heard) if self._fresh(kind) and self._has(kind)]

    def _fresh(self, kind: str) -> bool:
        heard = self._heard.get(kind)
        return heard is not None and self._time / SECOND - heard <= FRESH

    # ------------------------------------------------------------------ uncertainties and errors

    @property
    def _new(self) -> float:
        """How much of the uncertainty of a start is left: 1 to 0."""
        return exp(-(self._world.now - self._began) / SECOND / FADES)

    @property
    def attitude(self) -> Vector:
        """Standard deviations of roll, pitch and yaw."""
        tilt = TILT + NEW_TILT * self._new
        alone = (self._world.now - self._headed) / SECOND
        settled = DUAL_ANTENNA if self._has("dual_antenna") else HEADING
        yaw = settled + NEW_HEADING * self._new + TURNS * alone if self.aligned else UNKNOWN_HEADING
        return tilt, tilt, min(yaw, UNKNOWN_HEADING)

    @property
    def position(self) -> Vector:
        """Standard deviations north, east and down; those of an outage grow with the square of the time."""
        moved = DRIFTS / 2 * ((self._world.now - self._located) / SECOND) ** 2
        n, e, d = (hypot(x * (1 + 2 * self._new), moved) for x in POSITION)
        return n, e, d

    @property
    def velocity(self) -> Vector:
        faster = DRIFTS * (self._world.now - self._located) / SECOND
        n, e, d = (hypot(x * (1 + 2 * self._new), faster) for x in VELOCITY)
        return n, e, d

    @property
    def gyro_bias(self) -> Vector:
        return (GYRO_BIAS + NEW_GYRO_BIAS * self._new,) * 3

    @property
    def accel_bias(self) -> Vector:
        return (ACCEL_BIAS + NEW_ACCEL_BIAS * self._new,) * 3

    def error(self, what: str) -> Vector:
        """The errors of what a property of this name has the deviations of."""
        k, world = self._world.noise, self._world
        x, y, z = (
            k * deviation * wandering(f"{world.seed}:{what}:{i}", world.time)
            for i, deviation in enumerate(getattr(self, what))
        )
        if what != "attitude":
            return x, y, z
        return x, y, (z if self.aligned else 0.0) + self._turned

    def fix_error(self, receiver: int) -> tuple[Vector, Vector]:
        """The errors of the position and the velocity of a receiver, new in each step."""
        gauss = Random(f"{self._world.seed}:gnss {receiver}:{self._world.now // STEP}").gauss
        n, e, d = (self._world.noise * x * gauss(0.0, 1.0) for x in FIX)
        u, v, w = (self._world.noise * FIX_VELOCITY * gauss(0.0, 1.0) for _ in range(3))
        return (n, e, d), (u, v, w)

    # ------------------------------------------------------------------ outputs

    @property
    def _complete(self) -> bool:
        """Has the filter reached the last of the states that this device can have?"""
        world = self._world
        if world.has("position") and (world.has("gnss_1") or world.has("gnss_2")):
            return self.placed
        return self.aligned if self._has("mag") else self.level

    @property
    def state(self) -> tuple[str, ...]:
        """The state, with the names of both generations of devices."""
        name = "full_nav" if self.placed else "ahrs" if self.aligned else "vertical_gyro" if self.level else "init"
        return name, "run_solution_valid" if self._complete else "init" if self.level else "startup", "init"

    @property
    def flags(self) -> tuple[str, ...]:
        """Condition and warnings, with the names of both generations of devices."""
        if not self._complete and not self.level:
            return "filter_condition.converging", "init_no_attitude", "init_no_position_velocity"
        world, counts = self._world, (self.level, self.aligned, self.placed, self.placed)
        values = (self.attitude[0], self.attitude[2], max(self.position), max(self.velocity))
        converging = any(c and x > limit for c, x, limit in zip(counts, values, CONVERGED)) or not self._complete
        tilt, heading, position, velocity = (c and x > limit for c, x, limit in zip(counts, values, WARNED))
        biased = max(map(abs, world.gyro_bias_left)) > HIGH_GYRO_BIAS
        flags = {
            "filter_condition.converging": converging,
            "filter_condition.stable": not converging,
            "roll_pitch_warning": tilt,
            "heading_warning": heading,
            "run_attitude_covariance_warning": tilt or heading,
            "position_warning": position,
            "run_position_covariance_warning": position,
            "velocity_warning": velocity,
            "run_velocity_covariance_warning": velocity,
            "run_gps_unavailable": world.has("gnss_1") and not world.gnss and world.has("position"),
            "imu_bias_warning": biased,
            "run_gyro_bias_est_high_warning": biased,
            "time_sync_warning": not world.synchronized,
            "init_no_position_velocity": world.has("position") and not self._complete,
        }
        return tuple(name for name, applies in flags.items() if applies)

    @property
    def headings(self) -> tuple[str, ...]:
        """The sources of the heading, as in `heading_update_state`."""
        used = self._sources(self._world.state) if self.aligned else {}
        outside = used.get("dual_antenna") or used.get("external")
        return ("external",) * bool(outside) + ("mag",) * used.get("mag", False)

    def aids(self) -> Iterator[Aid]:
        """Yields the aiding measurements, of the device and from the user."""
        world, disabled = self._world, self.options.disabled
        receivers = [r for r in (1, 2) if world.has(f"gnss_{r}")]
        for r in receivers:
            enabled = r in self.options.receivers and "gnss" not in disabled
            yield _aid(r, "gnss", enabled, self.placed and r in self._receivers)
        if len(receivers) == 2:
            yield _aid(0, "dual_antenna", "dual_antenna" not in disabled, self.aligned and self._has("dual_antenna"))
        for kind, used in (("mag", self.aligned), ("pressure", self.placed)):
            if world.has(kind):
                yield _aid(0, kind, self._has(kind), used)
        for kind in sorted(self._heard):
            if self._fresh(kind):
                yield _aid(1, "heading" if kind in HEADING_UPDATES else kind, self._has(kind), True)


def _aid(source: int, kind: str, enabled: bool, used: bool) -> Aid:
    return Aid(source, kind, ("enabled",) * enabled + ("used",) * (enabled and used))


@cache
def _waves(name: str) -> tuple[tuple[float, float], ...]:
    random = Random(name)
    return tuple((2 * pi / random.uniform(30, 200), random.uniform(0, 2 * pi)) for _ in range(4))


def wandering(name: str, seconds: float) -> float:
    """Returns a value that changes slowly, with a mean of 0 and a standard deviation of 1; each name has its own."""
    return sum(sin(rate * seconds + phase) for rate, phase in _waves(name)) / sqrt(2)


def rotated(deviations: Vector, latitude: float, longitude: float) -> Vector:
    """Converts deviations along north, east and down to deviations along Earth-fixed axes."""
    rows = [earth.from_ned(latitude, longitude, v) for v in ((1.0, 0, 0), (0, 1.0, 0), (0, 0, 1.0))]
    x, y, z = (sqrt(sum((row[i] * d) ** 2 for row, d in zip(rows, deviations))) for i in range(3))
    return x, y, z
