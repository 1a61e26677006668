"""The surroundings of a simulated device at one point in time, and the biases and the noise of its sensors."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import atan2, cos, hypot, pi, sin
from random import Random
from typing import Any, TypeVar

from mip_tools.devices.facts import NOISE
from mip_tools.geometry import earth
from mip_tools.geometry.attitude import Quaternion, quaternion
from mip_tools.geometry.earth import SECOND, Matrix, Vector, turned, turned_back

from ..motion.state import Motion, State
from .noise import Noise, Values
from .satellites import IN_VIEW, Seen

T = TypeVar("T")

#: The default start of a simulation: the start of a GPS week, 7 January 2024.
START = 2296 * earth.WEEK

IDENTITY: Matrix = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
_GEOID = 45.0
_SINGLE = ("measured.pressure", "measured.speed")  # sensors of one axis
ANTENNAS = {1: (-0.5, 0.0, -0.2), 2: (0.5, 0.0, -0.2)}


ZERO: Vector = (0.0, 0.0, 0.0)


def summed(a: Sequence[float], b: Sequence[float]) -> Vector:
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def scaled(v: Sequence[float], k: float) -> Vector:
    x, y, z = v
    return x * k, y * k, z * k


def _random(source: Random, limit: float) -> Vector:
    return (source.uniform(-limit, limit), source.uniform(-limit, limit), source.uniform(-limit, limit))


class Output:
    """The state of one stream for quantities that count from its last output, or are the mean since then."""

    __slots__ = ("attitude", "integrals", "previous", "rate", "velocity")

    def __init__(self, rate: float) -> None:
        self.rate = rate  # base rate of the data, Hz
        self.previous: int | None = None  # ns
        self.integrals: dict[str, Values] = {}  # integrals of the noise at the last output
        self.attitude: Quaternion = (1.0, 0.0, 0.0, 0.0)
        self.velocity: Vector = (0.0, 0.0, 0.0)

    def begin(self, surroundings: Surroundings) -> None:
        """Prepares for a value. At the first output, quantities count from one base period before."""
        if self.previous is None or self.previous < surroundings.booted:
            period = round(SECOND / self.rate) if self.rate > 0 else SECOND
            self.previous = max(surroundings.booted, surroundings.now - period)
            state = surroundings.motion.at(self.previous / SECOND)
            self.attitude, self.velocity = state.quaternion, state.velocity
            self.integrals.clear()

    def end(self, surroundings: Surroundings) -> None:
        """Ends an output, after all values of a field were sent."""
        self.previous = surroundings.now
        self.attitude, self.velocity = surroundings.state.quaternion, surroundings.state.velocity


class Antenna:
    """Position and velocity of the antenna of a GNSS receiver."""

    __slots__ = ("ecef", "height", "latitude", "longitude", "velocity")

    def __init__(self, state: State, offset: Vector, wrong: Vector = ZERO, faster: Vector = ZERO) -> None:
        """`wrong` and `faster`: errors of the position and the velocity, north, east, down."""
        n, e, d = summed(turned_back(state.dcm, offset), wrong)
        (m, across), height = earth.radii(state.latitude), state.height
        self.latitude = state.latitude + n / (m + height)
        self.longitude = state.longitude + e / ((across + height) * cos(state.latitude))
        self.height = height - d
        self.ecef = earth.ecef(self.latitude, self.longitude, self.height)
        p, q, r = state.rate
        x, y, z = offset
        turning = turned_back(state.dcm, (q * z - r * y, r * x - p * z, p * y - q * x))
        self.velocity = summed(summed(state.velocity, turning), faster)


class Surroundings:
    """The true motion, sensors and surroundings. The device advances their time and applies the settings.

    `sensor_to_vehicle` rotates vectors from the frame of the sensor, which is fixed to the moving body, to the vehicle
    frame.
    """

    def __init__(self, motion: Motion, *, seed: int | str = 0, start: int | None = None, noise: float = 1.0) -> None:
        self.motion = motion
        self.seed = seed
        self.start: int = start if start is not None else getattr(motion, "start", None) or START
        self.noise = noise  # 0: none
        self.now = 0  # ns since the start
        self.booted = 0  # when the device was last restarted
        self.time = 0.0  # `now` in seconds
        self.gps = self.start  # ns since the GPS epoch
        self.pins: dict[int, bool] = {}  # levels of outputs, by pin from 1
        self.pulled_up: set[int] = set()  # inputs that are high
        self.senses: frozenset[str] | None = None  # what the device measures: mag, pressure, position, …; None: all
        self.gnss = True  # the receivers receive satellites
        self.outside = False  # a pulse per second and its time arrive from outside
        self.disturbance: Vector = ZERO  # of the magnetic field, in the sensor frame
        self.started = False  # whether the settings have been applied
        self.set_up()
        self.synchronize()
        bias = Random(f"{seed}:bias")
        #: The total biases of the sensors.
        self._accel_error = _random(bias, 0.02)
        self._gyro_error = _random(bias, 5e-4)
        self.sensors = {
            name: Noise(1 if name in _SINGLE else 3, Random(f"{seed}:{name}"), **figures)
            for name, figures in NOISE.items()
        }
        self._outputs: dict[tuple[int, str], Output] = {}
        self._state: State | None = None
        self._cache: dict[str, Any] = {}
        self._turn: Matrix | None = None
        first = motion.at(0.0)
        #: Reference point of the relative position.
        self.start_place: Vector = earth.ecef(first.latitude, first.longitude, first.height)

    def set_up(self) -> None:
        """Resets everything that settings change to its state on a new device."""
        self.accel_bias = self.gyro_bias = ZERO
        self.hard_iron: Vector = ZERO
        self.soft_iron: Matrix = IDENTITY
        self.ranges: dict[str, float] = {}  # of sensors: accel in m/s^2, gyro in rad/s, mag in gauss
        self.complementary_turns = True  # whether the mounting rotates the complementary filter, too
        self.offset: Vector = ZERO  # offset of the point whose position is reported, in the vehicle frame
        self.reference: Vector | None = None  # point of the relative position, Earth-fixed; None: the start
        self.odometer = 0.0  # relative uncertainty; 0: no odometer
        self.pulse_source = ""  # as `3dm.pps_source_control` names it; "": the device has no such setting
        self.ahead = -self.booted  # ns from the time of the simulation to that of the device
        self.parts_set: frozenset[str] = frozenset()  # the parts of the time that are set: tow, week_number
        self.initialized = False  # the time has been set once
        self.updates = 0  # how often a host has set the time
        self.corrected: int | None = None  # when RTCM corrections last arrived

    @property
    def origin(self) -> Vector:
        """Reference point of the relative position."""
        return self.reference or self.start_place

    def move_to(self, nanoseconds: int) -> None:
        """Sets the time since the start."""
        self.now = nanoseconds
        self.time = nanoseconds / SECOND
        self.gps = self.start + nanoseconds
        self._state = None
        if self._cache:
            self._cache = {}

    @property
    def state(self) -> State:
        """The motion of the body at this time."""
        state = self._state
        if state is None:
            state = self._state = self.motion.at(self.time)
        return state

    def once(self, name: str, make: Callable[[], T]) -> T:
        """Computes a result at most once per point in time."""
        item: T | None = self._cache.get(name)
        if item is None:
            item = self._cache[name] = make()
        return item

    def restart(self) -> None:
        """Restarts the device: its clock is at 0, and its settings have not been applied yet."""
        self.booted = self.now
        self.set_up()
        self.started = False

    # ------------------------------------------------------------------ the device's time

    @property
    def clock(self) -> int:
        """The device's time in ns since the GPS epoch. Until it is set, it counts from power-up, without a date."""
        return self.now + self.ahead

    @property
    def synchronized(self) -> bool:
        """Does the device receive a pulse per second?"""
        return self.pulse_source == "generated" or self._timed

    @property
    def _timed(self) -> bool:
        """Does the source of the pulse also set the time?"""
        source = self.pulse_source
        if source.startswith("receiver_"):
            return self.gnss and self.has("gnss_" + source[-1])
        if source:
            return source == "gpio" and self.outside
        return self.outside or (self.gnss and self.has("gnss_1"))

    @property
    def valid_parts(self) -> frozenset[str]:
        """The valid parts of the time. A device that selects its source needs the pulse, others only a first time."""
        return self.parts_set if self.synchronized or not self.pulse_source else frozenset()

    @property
    def dated(self) -> bool:
        return len(self.valid_parts) == 2

    def select_pulse(self, source: str) -> None:
        """Selects the source of the pulse; another one must set the time again."""
        if source != self.pulse_source:
            self.pulse_source, self.parts_set = source, frozenset()
        self.synchronize()

    def synchronize(self) -> None:
        """Takes the time of the source, which may have begun to send it."""
        if self._timed:
            self.ahead, self.parts_set, self.initialized = self.start, frozenset(("tow", "week_number")), True

    def set_gps(self, week: int | None = None, tow: float | None = None) -> None:
        """Sets the GPS week, or the whole seconds of the time of week, which began at the last pulse."""
        own_week, rest = divmod(self.clock, earth.WEEK)
        if tow is not None:
            rest = int(tow) * SECOND + (self.gps if self._timed else rest) % SECOND
        self.ahead = (own_week if week is None else week) * earth.WEEK + rest - self.now
        self.parts_set |= {"week_number"} if tow is None else {"tow"}
        self.initialized |= len(self.parts_set) == 2
        self.updates += 1

    def level(self, pin: int) -> bool:
        """Is a pin high?"""
        return self.pins.get(pin, pin in self.pulled_up)

    def output(self, set_number: int, quantity: str, rate: float) -> Output:
        """Returns the output that all fields of a set with this quantity share."""
        return self._outputs.setdefault((set_number, quantity), Output(rate))

    # ------------------------------------------------------------------ frames

    @property
    def sensor_to_vehicle(self) -> Matrix:
        return self._turn or IDENTITY

    @sensor_to_vehicle.setter
    def sensor_to_vehicle(self, m: Sequence[float]) -> None:
        a, b, c, d, e, f, g, h, i = m
        self._turn = (a, b, c, d, e, f, g, h, i)
        if self._turn == IDENTITY:
            self._turn = None
        self._cache = {}

    def vehicle(self, v: Vector) -> Vector:
        """Rotates a vector from the sensor frame to the vehicle frame."""
        return v if self._turn is None else turned(self._turn, v)

    def vehicle_of(self, state: State) -> Matrix:
        """Returns the attitude of the vehicle in a state."""
        return state.dcm if self._turn is None else earth.product(self._turn, state.dcm)

    def body(self, v: Vector) -> Vector:
        """Rotates a vector from the local level frame to the vehicle frame."""
        return self.vehicle(turned(self.state.dcm, v))

    @property
    def dcm(self) -> Matrix:
        """v_vehicle = dcm * v_ned."""
        turn = self._turn
        if turn is None:
            return self.state.dcm
        return self.once("dcm", lambda: earth.product(turn, self.state.dcm))

    @property
    def quaternion(self) -> Quaternion:
        """v_vehicle = q^-1 * v_ned * q."""
        if self._turn is None:
            return self.state.quaternion
        return self.once("quaternion", lambda: quaternion(self.dcm))

    # ------------------------------------------------------------------ sensors, in the sensor frame

    @property
    def gravity(self) -> float:
        return earth.gravity(self.state.latitude, self.state.height)

    @property
    def specific_force(self) -> Vector:
        """Acceleration minus gravity, without bias."""
        n, e, d = self.state.acceleration
        return turned(self.state.dcm, (n, e, d - self.gravity))

    @property
    def accel_error(self) -> Vector:
        """The total bias of the sensor at this time."""
        return self._error("measured.specific_force", self._accel_error)

    @property
    def gyro_error(self) -> Vector:
        return self._error("measured.angular_rate", self._gyro_error)

    @property
    def accel_constant(self) -> Vector:
        """The part of the bias that does not change."""
        return self._accel_error

    @property
    def gyro_constant(self) -> Vector:
        return self._gyro_error

    @property
    def accel_constant_left(self) -> Vector:
        return summed(self._accel_error, scaled(self.accel_bias, -1.0))

    @property
    def gyro_constant_left(self) -> Vector:
        return summed(self._gyro_error, scaled(self.gyro_bias, -1.0))

    def _error(self, sensor: str, constant: Vector) -> Vector:
        noise = self.sensors.get(sensor)
        if noise is None or not self.noise:
            return constant
        noise.integral(self.now)
        return summed(constant, scaled(noise.bias, self.noise))

    @property
    def accel_bias_left(self) -> Vector:
        """The part of the bias that the setting does not remove."""
        return summed(self.accel_error, scaled(self.accel_bias, -1.0))

    @property
    def gyro_bias_left(self) -> Vector:
        return summed(self.gyro_error, scaled(self.gyro_bias, -1.0))

    def mean_noise(self, sensor: str, out: Any) -> Values | None:
        """Returns the mean noise of a sensor since the last output, including the drift; None without noise."""
        added = self.added_noise(sensor, out)
        passed = (self.now - out.previous) / SECOND if added else 0.0
        return tuple([x / passed for x in added]) if added and passed > 0 else None

    def added_noise(self, sensor: str, out: Any) -> Values | None:
        """Returns the integral of the same noise."""
        noise = self.sensors.get(sensor)
        if noise is None or not self.noise or not isinstance(out, Output):
            return None
        now = noise.integral(self.now)
        before = out.integrals.get(sensor)
        if before is None:
            before = noise.before(out.previous or 0, self.now)
        out.integrals[sensor] = now
        return tuple([self.noise * (x - y) for x, y in zip(now, before)])

    def within(self, sensor: str, v: Vector) -> Vector:
        """Limits a measurement to the range of its sensor."""
        most = self.ranges.get(sensor)
        if most is None:
            return v
        x, y, z = v
        return min(max(x, -most), most), min(max(y, -most), most), min(max(z, -most), most)

    @property
    def magnetic_field(self) -> Vector:
        """The magnetic field of the Earth along north, east and down, in gauss."""
        return self.once("magnetic field", lambda: earth.magnetic_field(*self.state[:2]))

    @property
    def declination(self) -> float:
        north, east, _ = self.magnetic_field
        return atan2(east, north)

    def has(self, sense: str) -> bool:
        """Does the device measure or estimate this?"""
        return self.senses is None or sense in self.senses

    # ------------------------------------------------------------------ surroundings

    @property
    def ecef(self) -> Vector:
        s = self.state
        return self.once("ecef", lambda: earth.ecef(s.latitude, s.longitude, s.height))

    @property
    def msl_height(self) -> float:
        return self.state.height - _GEOID

    @property
    def geoid(self) -> float:
        """Height of the mean sea level above the ellipsoid."""
        return _GEOID

    @property
    def altitude(self) -> float:
        return earth.geopotential(self.msl_height)

    @property
    def air(self) -> tuple[float, float, float]:
        """Temperature, pressure, density."""
        return self.once("air", lambda: earth.atmosphere(self.altitude))

    # ------------------------------------------------------------------ GNSS

    def antenna(self, receiver: int) -> Antenna:
        return self.once(f"antenna {receiver}", lambda: Antenna(self.state, ANTENNAS[receiver]))

    def receiver_clock(self, receiver: int) -> tuple[float, float]:
        """Returns bias and drift of a receiver's clock, which oscillates once a day."""
        rate = 2 * pi / 86_400
        angle = self.gps % (86_400 * SECOND) / SECOND * rate + receiver
        return 1e-4 * sin(angle), 1e-4 * rate * cos(angle)

    @property
    def satellites(self) -> tuple[Seen, ...]:
        return IN_VIEW if self.gnss else ()

    def course(self, velocity: Vector) -> float:
        """Returns the direction over ground, 0 to 2 pi; at rest, the heading of the vehicle."""
        n, e, _ = velocity
        if hypot(n, e) < 0.02:
            m = self.dcm
            n, e = m[0], m[1]
        return earth.heading_of(n, e)
