"""The estimation filter of a device: its states, and the errors of its estimates.

An estimate is the truth plus an error. Errors and variances change by the same steps, those of a Kalman filter for
each axis, so the errors match the uncertainties: they grow without aiding, and shrink with it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from math import atan2, cos, exp, hypot, inf, pi, remainder, sqrt
from random import Random
from typing import NamedTuple

from ...geometry import earth
from ...geometry.attitude import euler
from ...geometry.earth import SECOND, Vector, turned_back
from ..motion.state import State
from ..surroundings.surroundings import Surroundings
from .kalman import Pair

#: The step of the filter, and of GNSS receivers, in nanoseconds.
STEP = SECOND // 5
#: The maximum number of steps at once; a longer time is divided into this many longer steps.
MOST_STEPS = 3000
#: For how many seconds the filter of a new simulation has run; the number of long steps, and then of short ones.
SETTLED, SETTLING_STEPS = 600.0, 100
#: Seconds from the start of the filter until it has leveled itself, a heading, and a position.
LEVELED, ALIGNED, PLACED = 1.0, 1.5, 2.0
#: The speed in m/s from which on the direction of motion is used as the heading.
KINEMATIC = 2.0
#: Seconds for which a measurement from the user is considered recent.
FRESH = 5.0

# Deviations of a new filter, and of measurements in each step.
NEW_TILT, NEW_HEADING, NEW_GYRO_BIAS, NEW_ACCEL_BIAS = 0.03, 0.05, 3e-4, 0.012
DUAL_ANTENNA, STANDS, RESTS, ACCEL_BIAS = 0.01, 0.01, 2e-4, 0.05
#: Deviations of GNSS positions along horizontal and vertical axes, and of velocities.
FIX = (sqrt(0.5), sqrt(0.5), 1.5)
FIX_VELOCITY = 0.1 / sqrt(3)
UNKNOWN_HEADING = pi / sqrt(3)
#: Deviations above which the filter is still converging, and warns: tilt, gyroscope bias, heading, position, velocity.
CONVERGED = (0.01, 6e-5, 0.05, 2.0, 0.3)
WARNED = (0.03, inf, 0.2, 10.0, 1.0)
#: The gyroscope bias, and the error of an antenna offset, above which the filter warns.
HIGH_GYRO_BIAS, WRONG_OFFSET = 0.01, 0.5
#: The random walk of the complementary filter's attitude, in rad per square root of a second.
WANDERS = 1e-3
#: The largest error, which stands for an unknown value.
MOST = 1e12

#: Headings that the user sends, by their names in the commands.
HEADINGS = ("filter_external_heading_update", "filter_external_heading_update_with_time", "aiding_true_heading")
#: Source in `aiding_measurement_enable` -> kinds of measurements.
SOURCES = {
    "gnss_position_velocity": "gnss", "gnss_heading": "dual_antenna", "altimeter": "pressure", "speed": "speed",
    "mag": "mag", "external_heading": "heading", "external_altimeter": "aiding_height_above_ellipsoid",
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
    initial_conditions: str = "AUTO_POSITION_VELOCITY_ATTITUDE"  # which initial conditions the user specifies
    alignment: frozenset[str] = frozenset(("dual_antenna", "kinematic", "mag"))
    attitude: Vector = (0.0, 0.0, 0.0)  # given: roll, pitch, yaw
    place: Vector | None = None  # given: latitude, longitude, height
    velocity: Vector = (0.0, 0.0, 0.0)
    disabled: frozenset[str] = frozenset()  # kinds of measurements
    headings: frozenset[str] | None = None  # sources of the heading; None: all that are enabled
    receivers: frozenset[int] = frozenset((1, 2))
    gravity: bool = True  # levels the attitude
    magnetometer: bool = True
    pressure: bool = True
    estimated: frozenset[str] | None = None  # biases; None: all
    dynamics: str = ""
    declination: float | None = None  # that the filter assumes; None: the true one
    accel_noise: Vector = (0.2, 0.2, 0.2)
    gyro_noise: Vector = (2e-4, 2e-4, 2e-4)
    gravity_noise: Vector = (0.02, 0.02, 0.02)
    mag_noise: float = 0.02
    pressure_noise: float = 0.5
    accel_bias_noise: Vector = (1e-4, 1e-4, 1e-4)
    gyro_bias_noise: Vector = (1e-6, 1e-6, 1e-6)
    stops_below: float = 0.0  # m/s; below this, it is at rest
    turns_above: float = 0.0  # rad/s; below this, it does not turn
    offsets: dict[int, Vector] = field(default_factory=dict)  # receiver -> error of its antenna offset


class Filter:
    """The filter of a world. `settled`: it has already converged at the start."""

    def __init__(self, world: Surroundings, settled: bool) -> None:
        self._world = world
        self.options = Options()
        self._settled, self._settling = settled, False
        self._began = world.now
        self._time: int | None = None  # of the last step
        self._random = Random(f"{world.seed}:filter:{world.now}")
        self._fixes = Random(f"{world.seed}:gnss:{world.now}")
        self.fix_errors: dict[int, tuple[Vector, Vector]] = {}
        self._heard: dict[str, float] = {}  # kinds of measurements that the user sends -> when, in seconds
        self._external: tuple[Vector | None, Vector | None] = (None, None)  # the last position and velocity among them
        self.reset()
        self._fix_all()

    def _gauss(self) -> float:
        return self._world.noise * self._random.gauss(0.0, 1.0)

    def reset(self) -> None:
        """Returns to initialization."""
        self.level = self.aligned = self.placed = False
        self._age = 0.0
        self._ran = False
        self._flags: tuple[str, ...] | None = None  # since the last step
        self._used: dict[str, bool] = {}
        self._strange: set[str] = set()
        self.attitude = tuple(Pair(self._gauss) for _ in range(3))
        self.navigation = tuple(Pair(self._gauss) for _ in range(3))
        self.accel_bias = tuple(Pair(self._gauss) for _ in range(3))

    def run(self) -> None:
        self._ran = True

    # ------------------------------------------------------------------ time

    def advance(self) -> None:
        """Advances the filter to the time of the world."""
        if self._time is None:
            self._time = self._began
            if self._settled and not self.options.waits:
                state = self._world.motion.at(self._began / SECOND)
                self._age, self._settling = SETTLED, True
                for _ in range(SETTLING_STEPS):
                    self._step(SETTLED / SETTLING_STEPS, state)
                for _ in range(SETTLING_STEPS):
                    self._step(STEP / SECOND, state)
                self._settling = False
                if not self.aligned:
                    self.attitude[2].error = remainder(self.options.attitude[2] - self._yaw(state), 2 * pi)
        late = self._world.now - self._time
        if late < STEP:
            return
        length = max(STEP, late // MOST_STEPS)
        while self._time + length <= self._world.now:
            self._time += length
            self._step(length / SECOND, self._world.motion.at(self._time / SECOND))

    @property
    def since(self) -> float:
        """Seconds since the last step."""
        return max(0.0, (self._world.now - (self._time or 0)) / SECOND)

    @property
    def left(self) -> float:
        """The part of the change of the last step that is not shown yet."""
        return max(0.0, 1.0 - self.since * SECOND / STEP)

    def _step(self, time: float, state: State) -> None:
        often = sqrt(STEP / SECOND / time)  # a long step has many measurements
        self._used.clear()
        self._flags = None
        self._fix_all()
        options = self.options
        if options.waits and not self._ran:
            return
        self._age += time
        for i, pair in enumerate(self.attitude):
            if self.level:
                pair.predict(time, options.gyro_noise[i] ** 2, options.gyro_bias_noise[i] ** 2)
        if self.placed:
            tilt = earth.gravity(state.latitude, state.height) * sqrt(self.attitude[0].p + self.attitude[1].p)
            for i, pair in enumerate(self.navigation):
                noise = options.accel_noise[i] ** 2 + (tilt * tilt if i < 2 else 0.0)
                pair.predict(time, 0.0, noise)
                if pair.p > MOST:
                    pair.begin(sqrt(MOST), sqrt(pair.r))
        for i, pair in enumerate(self.accel_bias):
            pair.predict(time, options.accel_bias_noise[i] ** 2, 0.0)
        self._initialize(state)
        self._level(state, often)
        self._head(state, often)
        self._navigate(state, often)

    def _fix_all(self) -> None:
        for receiver in (1, 2):
            self._fix(receiver)

    def _fix(self, receiver: int) -> None:
        """Changes the position error of a receiver: north, east, down."""
        noise, gauss = self._world.noise, self._fixes.gauss
        n, e, d = (noise * deviation * gauss(0.0, 1.0) for deviation in FIX)
        u, v, w = (noise * FIX_VELOCITY * gauss(0.0, 1.0) for _ in range(3))
        self.fix_errors[receiver] = ((n, e, d), (u, v, w))

    # ------------------------------------------------------------------ initialization

    def _initialize(self, state: State) -> None:
        options, initial_conditions = self.options, self.options.initial_conditions
        if not options.automatic:
            return
        if not self.level and self._age >= LEVELED:
            user = initial_conditions in ("AUTO_POSITION_VELOCITY", "MANUAL")
            self.set_attitude(
                state,
                options.attitude[0] if user else None,
                options.attitude[1] if user else None,
                None if self._settling else options.attitude[2],
            )
        if self.level and not self.aligned and self._age >= ALIGNED:
            if initial_conditions != "AUTO_POSITION_VELOCITY_ATTITUDE":
                self.set_heading(state, options.attitude[2])
            else:
                self._align(state)
        if self.aligned and not self.placed and self._age >= PLACED and self._can_navigate:
            if initial_conditions == "MANUAL" and options.place is not None:
                self.set_place(state, options.place, options.velocity)
            elif self._receivers:
                self._place()
            elif self._external[0] is not None and self._external[1] is not None:
                self.set_place(state, *self._external)  # type: ignore[arg-type]

    def _align(self, state: State) -> None:
        """Determines the heading by one of the permitted methods."""
        allowed, yaw = self.options.alignment, self.attitude[2]
        speed = hypot(*state.velocity[:2])
        if "dual_antenna" in allowed and self._has("dual_antenna"):
            yaw.measure(DUAL_ANTENNA)
        elif "kinematic" in allowed and speed >= KINEMATIC and self._has("gnss"):
            course = atan2(state.velocity[1], state.velocity[0])
            yaw.measure(NEW_HEADING, remainder(course - self._yaw(state), 2 * pi))
        elif "mag" in allowed and self._has("mag"):
            yaw.measure(NEW_HEADING, self._declination_error)
        elif "external" in allowed and any(self._fresh(kind) for kind in HEADINGS):
            pass  # what the user sent has been used
        else:
            return
        self.aligned = True

    def set_attitude(self, state: State, roll: float | None, pitch: float | None, yaw: float | None) -> None:
        """Levels the filter, by gravity or as given. Without a yaw, the heading is relative to the initial one."""
        true = euler(self._world.vehicle_of(state))
        left = self._world.gyro_bias_left
        for i, angle in enumerate((roll, pitch, yaw)):
            pair = self.attitude[i]
            pair.begin(UNKNOWN_HEADING if i == 2 else NEW_TILT, NEW_GYRO_BIAS)
            if not self._settling:
                pair.rate = left[i]  # the estimate of the bias begins at 0
            if angle is not None:
                pair.error = remainder(angle - true[i], 2 * pi)
        for pair, x in zip(self.accel_bias, self._world.accel_bias_left):
            pair.begin(NEW_ACCEL_BIAS, 0.0)
            if not self._settling:
                pair.error = -x
        self.level = True

    def set_heading(self, state: State, yaw: float) -> None:
        """Sets the heading to the one from the user."""
        self.attitude[2].begin(NEW_HEADING, sqrt(self.attitude[2].r))
        self.attitude[2].error = remainder(yaw - self._yaw(state), 2 * pi)
        self.aligned = True

    def set_place(self, state: State, place: Vector, velocity: Vector) -> None:
        """Sets the position and the velocity to those from the user."""
        wrong = self._from(state, place)
        for i, pair in enumerate(self.navigation):
            pair.begin(FIX[i], FIX_VELOCITY)
            pair.error, pair.rate = wrong[i], velocity[i] - state.velocity[i]
        self.placed = True

    def _place(self) -> None:
        for i, pair in enumerate(self.navigation):
            pair.begin(FIX[i], FIX_VELOCITY)
        self.placed = True

    # ------------------------------------------------------------------ aiding

    def _has(self, kind: str) -> bool:
        """Does the device have this kind of measurement, and is it enabled?"""
        options, world = self.options, self._world
        if ("heading" if kind in HEADINGS else kind) in options.disabled:
            return False
        by = options.headings
        if kind == "gnss":
            return bool(self._receivers)
        if kind == "dual_antenna":
            return by is None and len(self._receivers) == 2
        if kind == "mag":
            return options.magnetometer and world.has("mag") and (by is None or "mag" in by)
        if kind in HEADINGS:
            return by is None or "external" in by
        if kind == "pressure":
            return options.pressure and world.has("pressure")
        return True

    @property
    def _receivers(self) -> tuple[int, ...]:
        """The receivers whose positions the filter uses."""
        if not self._world.gnss or "gnss" in self.options.disabled:
            return ()
        return tuple(r for r in sorted(self.options.receivers) if self._world.has(f"gnss_{r}"))

    @property
    def _can_navigate(self) -> bool:
        return self._world.has("position")

    @property
    def _declination_error(self) -> float:
        """The error of a heading from the magnetometer."""
        assumed = self.options.declination
        return 0.0 if assumed is None else assumed - self._world.declination

    def _level(self, state: State, often: float) -> None:
        """Levels the attitude by gravity, which counts less while the device accelerates, and by the GNSS velocity."""
        if not self.level:
            return
        if self.options.gravity:
            disturbed = hypot(*state.acceleration) / earth.gravity(state.latitude, state.height)
            if self.placed and self._receivers:
                disturbed /= 10
            for pair, noise in zip(self.attitude[:2], self.options.gravity_noise):
                pair.measure(often * hypot(noise, disturbed))
            self.accel_bias[2].measure(often * ACCEL_BIAS)
        if hypot(*state.rate) < self.options.turns_above:
            for pair in self.attitude:
                pair.measure_rate(often * RESTS)

    def _head(self, state: State, often: float) -> None:
        if not self.aligned:
            return
        yaw, by = self.attitude[2], self.options.headings
        if self._has("dual_antenna"):
            yaw.measure(often * DUAL_ANTENNA)
            self._used["dual_antenna"] = True
        if self._has("mag"):
            north, east, _ = self._world.magnetic_field
            yaw.measure(often * self.options.mag_noise / max(hypot(north, east), 0.01), self._with_noise(often))
            self._used["mag"] = True
        speed = hypot(*state.velocity[:2])
        if by is not None and "gnss_velocity" in by and speed >= KINEMATIC and self._has("gnss"):
            yaw.measure(often * hypot(NEW_HEADING, FIX_VELOCITY / speed))

    def _with_noise(self, often: float) -> float | None:
        """Returns the error of the magnetometer heading if it is more than noise, else None."""
        wrong = self._declination_error
        if not wrong:
            return None
        north, east, _ = self._world.magnetic_field
        return wrong + often * self.options.mag_noise / max(hypot(north, east), 0.01) * self._gauss()

    def _navigate(self, state: State, often: float) -> None:
        if not self.placed:
            return
        for receiver in self._receivers:
            wrong, faster = self.fix_errors[receiver]
            shift = turned_back(state.dcm, self.options.offsets.get(receiver, (0.0, 0.0, 0.0)))
            for i, pair in enumerate(self.navigation):
                pair.measure(often * FIX[i], often * wrong[i] - shift[i])
                pair.measure_rate(often * FIX_VELOCITY, often * faster[i])
            for pair in self.accel_bias[:2]:
                pair.measure(often * ACCEL_BIAS)
            self._used[f"gnss {receiver}"] = True
        if self._has("pressure"):
            self.navigation[2].measure(often * self.options.pressure_noise * 10)
            self._used["pressure"] = True
        if hypot(*state.velocity) < self.options.stops_below:
            for pair in self.navigation:
                pair.measure_rate(often * STANDS)
        if self._world.odometer and self._has("speed"):
            self._used["speed"] = True
            for pair in self.navigation[:2]:
                pair.measure_rate(often * self._world.odometer)

    # ------------------------------------------------------------------ measurements from the user

    def stands(self) -> None:
        """Applies the measurement that the device is stationary."""
        for pair in self.navigation if self.placed else ():
            pair.measure_rate(STANDS)

    def rests(self) -> None:
        """Applies the measurement that the device does not turn."""
        for pair in self.attitude if self.level else ():
            pair.measure_rate(RESTS)

    def heading(self, kind: str, value: float, deviation: float, magnetic: bool) -> None:
        state = self._world.state
        true = self._yaw(state)
        if magnetic:
            true -= self._world.declination
        wrong = remainder(value - true, 2 * pi)
        if self._has(kind) and self.level:
            self._take(kind, self.attitude[2], wrong, deviation, snap=not self.aligned)
        self._hear(kind)

    def position(self, kind: str, place: Vector, deviations: Vector, axes: tuple[bool, ...] = (True,) * 3) -> None:
        wrong = self._from(self._world.state, place)
        for i, pair in enumerate(self.navigation):
            if self.placed and axes[i] and kind not in self.options.disabled:
                self._take(kind, pair, wrong[i], deviations[i])
        if all(axes):
            self._external = (place, self._external[1])
        self._hear(kind)

    def velocity(self, kind: str, velocity: Vector, deviations: Vector, axes: tuple[bool, ...] = (True,) * 3) -> None:
        """Applies a measured velocity: north, east, down."""
        true = self._world.state.velocity
        for i, pair in enumerate(self.navigation):
            if self.placed and axes[i] and kind not in self.options.disabled:
                pair.measure_rate(deviations[i], velocity[i] - true[i])
                self._used[kind] = True
        self._external = (self._external[0], velocity)
        self._hear(kind)

    def _take(self, kind: str, pair: Pair, wrong: float, deviation: float, snap: bool = False) -> None:
        """Uses a measurement if it agrees with the estimate."""
        if snap or pair.likely(wrong, deviation):
            pair.measure(deviation, wrong)
            self._used[kind] = True
            self._strange.discard(kind)
        else:
            self._strange.add(kind)

    def _hear(self, kind: str) -> None:
        self._heard[kind] = self._world.time

    def _fresh(self, kind: str) -> bool:
        heard = self._heard.get(kind)
        return heard is not None and self._world.time - heard <= FRESH

    # ------------------------------------------------------------------ outputs

    def _yaw(self, state: State) -> float:
        return euler(self._world.vehicle_of(state))[2]

    @staticmethod
    def _from(state: State, place: Vector) -> Vector:
        """Returns north, east and down from the true position to another one."""
        m, across = earth.radii(state.latitude)
        latitude, longitude, height = place
        return (
            (latitude - state.latitude) * (m + state.height),
            remainder(longitude - state.longitude, 2 * pi) * (across + state.height) * cos(state.latitude),
            state.height - height,
        )

    @property
    def _complete(self) -> bool:
        """Has the filter reached the last of the states that this device can have?"""
        world = self._world
        if self._can_navigate and (world.has("gnss_1") or world.has("gnss_2")):
            return self.placed
        return self.aligned if world.has("mag") and self._has("mag") else self.level

    @property
    def state(self) -> tuple[str, ...]:
        """The state, with the names of both generations of devices."""
        name = "full_nav" if self.placed else "ahrs" if self.aligned else "vertical_gyro" if self.level else "init"
        return name, "run_solution_valid" if self._complete else "init" if self.level else "startup", "init"

    def deviations(self) -> tuple[float, ...]:
        """The deviations of tilt, gyroscope bias, heading, position and velocity."""
        roll, pitch, yaw = self.attitude
        return (
            sqrt(max(roll.p, pitch.p)), sqrt(max(roll.r, pitch.r)), sqrt(yaw.p),
            sqrt(max(x.p for x in self.navigation)), sqrt(max(x.r for x in self.navigation)),
        )  # fmt: skip

    @property
    def flags(self) -> tuple[str, ...]:
        """Condition and warnings, with the names of both generations of devices."""
        if self._flags is None:
            self._flags = self._find_flags()
        return self._flags

    def _find_flags(self) -> tuple[str, ...]:
        if not self._complete and not self.level:
            return "filter_condition.converging", "init_no_attitude", "init_no_position_velocity"
        counts = (self.level, self.level, self.aligned, self.placed, self.placed)
        values = self.deviations()
        converging = any(c and x > limit for c, x, limit in zip(counts, values, CONVERGED)) or not self._complete
        tilt, _, heading, position, velocity = (c and x > limit for c, x, limit in zip(counts, values, WARNED))
        world = self._world
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
            "run_gps_unavailable": world.has("gnss_1") and not world.gnss and self._can_navigate,
            "imu_bias_warning": max(map(abs, world.gyro_bias_left)) > HIGH_GYRO_BIAS,
            "run_gyro_bias_est_high_warning": max(map(abs, world.gyro_bias_left)) > HIGH_GYRO_BIAS,
            "antenna_lever_arm_warning": any(hypot(*x) > WRONG_OFFSET for x in self.options.offsets.values()),
            "time_sync_warning": not world.synchronized,
            "init_no_position_velocity": self._can_navigate and not self._complete,
        }
        return tuple(name for name, applies in flags.items() if applies)

    @property
    def headings(self) -> tuple[str, ...]:
        """The sources of the heading, as in `heading_update_state`."""
        names = {"mag": "mag", "dual_antenna": "external", **dict.fromkeys(HEADINGS, "external")}
        return tuple(sorted({names[kind] for kind in self._used if kind in names}))

    def aids(self) -> Iterator[Aid]:
        """Yields the aiding measurements, of the device and from the user."""
        receivers = self._receivers
        for receiver in (1, 2):
            if self._world.has(f"gnss_{receiver}"):
                enabled = receiver in self.options.receivers and "gnss" not in self.options.disabled
                yield self._aid(receiver, "gnss", enabled, receiver in receivers and f"gnss {receiver}" in self._used)
        if self._world.has("gnss_1") and self._world.has("gnss_2"):
            yield self._aid(0, "dual_antenna", "dual_antenna" not in self.options.disabled)
        for kind in ("mag", "pressure"):
            if self._world.has(kind):
                yield self._aid(0, kind, self._has(kind))
        for kind in sorted(self._heard):
            if self._fresh(kind):
                name = "heading" if kind in HEADINGS[:2] else kind
                yield self._aid(1, name, self._has(kind), kind not in self._strange)

    def _aid(self, source: int, kind: str, enabled: bool, used: bool | None = None) -> Aid:
        used = self._used.get(kind, False) if used is None else used
        names = ("enabled",) * enabled + ("used",) * (enabled and used)
        return Aid(source, kind, names + ("residual_high_warning",) * (kind in self._strange))


class Complementary:
    """The complementary filter: an attitude from the gyroscopes, slowly corrected by gravity and the magnetic field."""

    def __init__(self, world: Surroundings) -> None:
        self._world = world
        self._random = Random(f"{world.seed}:complementary")
        self._time: int | None = None
        self.constants = [10.0, 10.0, 10.0]  # time constant of each angle in s; inf: it is not corrected
        self._errors = [0.0, 0.0, 0.0]

    @property
    def errors(self) -> Vector:
        """The errors of roll, pitch and yaw."""
        now, noise = self._world.now, self._world.noise
        passed = STEP / SECOND * 1000 if self._time is None else (now - self._time) / SECOND
        if self._time is None or now - self._time >= STEP:
            self._time = now
            left = self._world.gyro_bias_left
            for i, constant in enumerate(self.constants):
                if constant == inf:
                    self._errors[i] += left[i] * passed + noise * WANDERS * sqrt(passed) * self._random.gauss(0.0, 1.0)
                    continue
                decay = exp(-passed / constant) if constant > 0 else 0.0
                deviation = noise * WANDERS * sqrt(constant / 2 * (1 - decay * decay))
                self._errors[i] = self._errors[i] * decay + deviation * self._random.gauss(0.0, 1.0)
        x, y, z = self._errors
        return x, y, z


def rotated(deviations: Vector, latitude: float, longitude: float) -> Vector:
    """Converts deviations along north, east and down to deviations along Earth-fixed axes."""
    rows = [earth.from_ned(latitude, longitude, v) for v in ((1.0, 0, 0), (0, 1.0, 0), (0, 0, 1.0))]
    x, y, z = (sqrt(sum((row[i] * d) ** 2 for row, d in zip(rows, deviations))) for i in range(3))
    return x, y, z
