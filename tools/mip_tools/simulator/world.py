"""The world around a simulated device, at one time."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import cos, hypot, pi, sin
from random import Random
from typing import Any, TypeVar

from . import earth
from .earth import SECOND, Matrix, Vector, turned, turned_back
from .satellites import DAY, Dop, Seen, dop, seen
from .state import Motion, Quaternion, State, quaternion

T = TypeVar("T")

#: When a simulation starts, unless it is told: the start of a GPS week, 7 January 2024.
START = 2296 * earth.WEEK

_IDENTITY: Matrix = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
_GEOID = 45.0
_ANTENNAS = {1: (-0.5, 0.0, -0.2), 2: (0.5, 0.0, -0.2)}


def _random(source: Random, limit: float) -> Vector:
    return (source.uniform(-limit, limit), source.uniform(-limit, limit), source.uniform(-limit, limit))


class Output:
    """One stream's view of quantities that count from the last time that they were sent."""

    __slots__ = ("attitude", "previous", "rate", "velocity")

    def __init__(self, rate: float) -> None:
        self.rate = rate  # base rate of the data, Hz
        self.previous: int | None = None  # ns
        self.attitude: Quaternion = (1.0, 0.0, 0.0, 0.0)
        self.velocity: Vector = (0.0, 0.0, 0.0)

    def begin(self, world: World) -> None:
        """Before a value is sent: after a start, it counts from one base period before."""
        if self.previous is None or self.previous < world.booted:
            period = round(SECOND / self.rate) if self.rate > 0 else SECOND
            self.previous = max(world.booted, world.now - period)
            state = world.motion.at(self.previous / SECOND)
            self.attitude, self.velocity = state.quaternion, state.velocity

    def end(self, world: World) -> None:
        """After all values of a field are sent."""
        self.previous = world.now
        self.attitude, self.velocity = world.state.quaternion, world.state.velocity


class Antenna:
    """Where the antenna of a GNSS receiver is and how it moves."""

    __slots__ = ("ecef", "height", "latitude", "longitude", "velocity")

    def __init__(self, state: State, offset: Vector) -> None:
        n, e, d = turned_back(state.dcm, offset)
        (m, across), height = earth.radii(state.latitude), state.height
        self.latitude = state.latitude + n / (m + height)
        self.longitude = state.longitude + e / ((across + height) * cos(state.latitude))
        self.height = height - d
        self.ecef = earth.ecef(self.latitude, self.longitude, self.height)
        p, q, r = state.rate
        x, y, z = offset
        a, b, c = turned_back(state.dcm, (q * z - r * y, r * x - p * z, p * y - q * x))
        u, v, w = state.velocity
        self.velocity = (u + a, v + b, w + c)


class World:
    """The source of the quantities. The device moves it through time and sets what its settings say.

    `sensor_to_vehicle` turns vectors of the sensor, which is fixed to the moving body, into the vehicle frame.
    """

    def __init__(self, motion: Motion, *, seed: int | str = 0, start: int | None = None, noise: float = 1.0) -> None:
        self.motion = motion
        self.seed = seed
        self.start: int = start if start is not None else getattr(motion, "start", None) or START
        self.noise = noise  # 0: none
        self.now = 0  # ns since the start
        self.booted = 0  # when the device was last restarted
        self.time = 0.0  # the same in seconds
        self.gps = self.start  # ns since the GPS epoch
        self.accel_bias: Vector = (0.0, 0.0, 0.0)  # settings: the sensors subtract them, m/s^2 and rad/s
        self.gyro_bias: Vector = (0.0, 0.0, 0.0)
        self.pins: dict[int, bool] = {}  # levels of outputs, by pin from 1
        self.signals: dict[int, bool] = {}  # levels that come from outside
        self.pulled_up: set[int] = set()  # pins that are high without a signal
        self.trigger = 0  # the event trigger that causes what is sent now; 0: none
        bias = Random(f"{seed}:bias")
        #: The whole biases of the sensors.
        self.accel_error = _random(bias, 0.02)
        self.gyro_error = _random(bias, 5e-4)
        self._outputs: dict[tuple[int, str, str], Output] = {}
        self._state: State | None = None
        self._known: dict[str, Any] = {}
        self._turn: Matrix | None = None
        first = motion.at(0.0)
        #: Reference point of the relative position.
        self.origin: Vector = earth.ecef(first.latitude, first.longitude, first.height)

    def move_to(self, nanoseconds: int) -> None:
        """The time since the start."""
        self.now = nanoseconds
        self.time = nanoseconds / SECOND
        self.gps = self.start + nanoseconds
        self._state = None
        if self._known:
            self._known = {}

    @property
    def state(self) -> State:
        """How the body moves, at this time."""
        state = self._state
        if state is None:
            state = self._state = self.motion.at(self.time)
        return state

    def once(self, name: str, make: Callable[[], T]) -> T:
        """What is made at most once at each time."""
        found: T | None = self._known.get(name)
        if found is None:
            found = self._known[name] = make()
        return found

    def restart(self) -> None:
        """The device restarts: its own clock is at 0, and it removes no bias."""
        self.booted = self.now
        self.accel_bias = self.gyro_bias = (0.0, 0.0, 0.0)

    def set_gps(self, week: int | None = None, tow: float | None = None) -> None:
        """Sets the GPS week, or the whole seconds of the time of week."""
        own_week, rest = divmod(self.gps, earth.WEEK)
        if tow is not None:
            rest = int(tow) * SECOND + rest % SECOND
        self.start += (own_week if week is None else week) * earth.WEEK + rest - self.gps
        self.move_to(self.now)

    def level(self, pin: int) -> bool:
        """Is a pin high?"""
        return self.pins.get(pin, self.signals.get(pin, pin in self.pulled_up))

    def output(self, set: int, quantity: str, rate: float, channel: str = "") -> Output:
        """What all fields of a set that show a quantity count from: sending any of them restarts it.

        Channels count on their own: scheduled data, and each event action.
        """
        return self._outputs.setdefault((set, quantity, channel), Output(rate))

    def quantity(self, name: str, item: Any = None) -> Any:
        """A quantity by its name in the specification."""
        from .quantities import QUANTITIES

        return QUANTITIES[name](self, item)

    # ------------------------------------------------------------------ frames

    @property
    def sensor_to_vehicle(self) -> Matrix:
        return self._turn or _IDENTITY

    @sensor_to_vehicle.setter
    def sensor_to_vehicle(self, m: Sequence[float]) -> None:
        a, b, c, d, e, f, g, h, i = m
        self._turn = (a, b, c, d, e, f, g, h, i)
        if self._turn == _IDENTITY:
            self._turn = None
        self._known = {}

    def vehicle(self, v: Vector) -> Vector:
        """A vector of the sensor frame in the vehicle frame."""
        return v if self._turn is None else turned(self._turn, v)

    def body(self, v: Vector) -> Vector:
        """A vector of the local level frame in the vehicle frame."""
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
    def accel_bias_left(self) -> Vector:
        """The part that the setting does not remove."""
        (a, b, c), (x, y, z) = self.accel_error, self.accel_bias
        return a - x, b - y, c - z

    @property
    def gyro_bias_left(self) -> Vector:
        (a, b, c), (x, y, z) = self.gyro_error, self.gyro_bias
        return a - x, b - y, c - z

    @property
    def magnetic_field(self) -> Vector:
        """North, east, down."""
        s = self.state
        return earth.magnetic_field(s.latitude, s.longitude, s.height)

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
        return self.once(f"antenna {receiver}", lambda: Antenna(self.state, _ANTENNAS[receiver]))

    def clock(self, receiver: int) -> tuple[float, float]:
        """Bias and drift of the clock of a receiver: it swings once a day."""
        rate = 2 * pi / 86_400
        angle = self.gps % DAY / SECOND * rate + receiver
        return 1e-4 * sin(angle), 1e-4 * rate * cos(angle)

    def satellites(self, receiver: int) -> tuple[Seen, ...]:
        def look() -> tuple[Seen, ...]:
            a = self.antenna(receiver)
            moves = earth.from_ned(a.latitude, a.longitude, a.velocity)
            return seen(self.gps, a.latitude, a.longitude, a.height, moves, *self.clock(receiver))

        return self.once(f"satellites {receiver}", look)

    @property
    def dop(self) -> Dop:
        return self.once("dop", lambda: dop(self.satellites(1)))

    def course(self, velocity: Vector) -> float:
        """Direction over ground, 0 to 2 pi; at rest, that of the vehicle."""
        n, e, _ = velocity
        if hypot(n, e) < 0.02:
            m = self.dcm
            n, e = m[0], m[1]
        return earth.heading(n, e)


__all__ = ["START", "Antenna", "Output", "World"]
