"""The quantities that the specification names: world, and an item -> value in the unit of the specification.

The item is that of a list (`for_each`), an `Output` for other data, and the values of the command for responses.
"""

from __future__ import annotations

from math import atan2, hypot, pi, sin
from typing import Any, NamedTuple

from . import earth
from .earth import SECOND, WEEK, Vector
from .receivers import GNSS, Function
from .state import conjugate, euler, matrix, multiplied, rotation_vector
from .world import Output, World


class Receiver(NamedTuple):
    id: int
    clock: tuple[float, float]


class Aid(NamedTuple):
    source: int
    type: str


_RECEIVERS = (1, 2)
_FLAGS = (("pps_valid", "time_initialized"), ("pps_valid", "time_initialized", "time_refresh"))
_AIDS = (Aid(1, "gnss"), Aid(2, "gnss"), Aid(0, "dual_antenna"), Aid(0, "mag"), Aid(0, "pressure"))


def _sum(a: Vector, b: Vector) -> Vector:
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def _scaled(v: Vector, k: float) -> Vector:
    return v[0] * k, v[1] * k, v[2] * k


def _force(w: World, _: Any) -> Vector:
    return w.vehicle(_sum(w.specific_force, w.accel_bias_left))


def _rate(w: World, _: Any) -> Vector:
    return w.vehicle(_sum(w.state.rate, w.gyro_bias_left))


def _seconds(w: World, out: Output) -> float:
    return (w.now - (out.previous or 0)) / SECOND


def _rotation(w: World, out: Output) -> Vector:
    turn = rotation_vector(out.attitude, w.state.quaternion)
    return w.vehicle(_sum(turn, _scaled(w.gyro_bias_left, _seconds(w, out))))


def _velocity(w: World, out: Output) -> Vector:
    t = _seconds(w, out)
    (n, e, d), (a, b, c) = w.state.velocity, out.velocity
    change = earth.turned(matrix(out.attitude), (n - a, e - b, d - c - w.gravity * t))
    return w.vehicle(_sum(change, _scaled(w.accel_bias_left, t)))


def _matrix(w: World, out: Output) -> tuple[float, ...]:
    m = matrix(multiplied(conjugate(out.attitude), w.state.quaternion))
    turn = w.sensor_to_vehicle
    columns = (turn[0], turn[3], turn[6], turn[1], turn[4], turn[7], turn[2], turn[5], turn[8])
    return earth.product(turn, earth.product(m, columns))


def _relative(w: World, _: Any) -> Vector:
    x, y, z = (a - b for a, b in zip(w.ecef, w.origin))
    latitude, longitude, _height = earth.llh(*w.origin)
    return earth.to_ned(latitude, longitude, (x, y, z))


def _ticks(now: int, out: Any) -> int:
    rate = out.rate if isinstance(out, Output) and out.rate > 0 else 1.0
    return round(now * rate / SECOND) % 2**32


def _temperature(extreme: float) -> Function:
    return lambda w, _: 35.0 + extreme * (1 + 0.5 * sin(2 * pi * (w.now % (3600 * SECOND)) / (3600 * SECOND)))


_TIME: dict[str, Function] = {
    "gps.tow": lambda w, _: w.gps % WEEK / SECOND,
    "gps.week": lambda w, _: w.gps // WEEK,
    "gps.seconds": lambda w, _: w.gps // SECOND,
    "gps.microseconds": lambda w, _: w.gps % SECOND // 1000,
    "gps.time": lambda w, _: w.gps,
    "gps.flags": lambda w, _: _FLAGS[w.gps // SECOND % 2],
    "gps.leap_seconds": lambda w, _: earth.leap_seconds(w.gps),
    "gps.pulse_age": lambda w, _: 0,
    "utc.year": lambda w, _: earth.utc(w.gps).year,
    "utc.month": lambda w, _: earth.utc(w.gps).month,
    "utc.day": lambda w, _: earth.utc(w.gps).day,
    "utc.hour": lambda w, _: earth.utc(w.gps).hour,
    "utc.minute": lambda w, _: earth.utc(w.gps).minute,
    "utc.second": lambda w, _: earth.utc(w.gps).second,
    "utc.millisecond": lambda w, _: w.gps % SECOND // 1_000_000,
    "reference.time": lambda w, _: w.now - w.booted,
    "reference.delta": lambda w, out: w.now - out.previous,
    "external.delta": lambda w, out: w.now - out.previous,
    "reference.counts": lambda w, _: (w.now - w.booted) // 16000 % 2**32,
    "ticks.count": lambda w, out: _ticks(w.now - w.booted, out),
    "ticks.delta": lambda w, out: _ticks(w.now, out) - _ticks(out.previous, out) & 0xFFFFFFFF,
    "event.trigger": lambda w, _: w.trigger,
}

_SENSORS: dict[str, Function] = {
    "measured.specific_force": _force,
    "measured.angular_rate": _rate,
    "measured.magnetic_field": lambda w, _: w.body(w.magnetic_field),
    "measured.pressure": lambda w, _: w.air[1],
    "measured.speed": lambda w, _: earth.turned(w.state.dcm, w.state.velocity)[0],
    "counts.specific_force": lambda w, _: _scaled(_sum(w.specific_force, w.accel_error), 1000.0),
    "counts.angular_rate": lambda w, _: _scaled(_sum(w.state.rate, w.gyro_error), 5000.0),
    "counts.magnetic_field": lambda w, _: _scaled(earth.turned(w.state.dcm, w.magnetic_field), 5000.0),
    "counts.pressure": lambda w, _: w.air[1] * 100,
    "counts.temperature": lambda w, _: (2350, 2350, 2350, 2400),
    "delta.rotation": _rotation,
    "delta.velocity": _velocity,
    "delta.matrix": _matrix,
    "stabilized.up": lambda w, _: earth.turned(w.state.dcm, (0.0, 0.0, -w.gravity)),
    "stabilized.north": lambda w, _: earth.turned(w.state.dcm, w.magnetic_field),
    "temperature.min": _temperature(-2.0),
    "temperature.max": _temperature(2.0),
    "temperature.mean": _temperature(0.0),
    "gpio.states": lambda w, _: sum(1 << (pin - 1) for pin in {*w.pins, *w.signals, *w.pulled_up} if w.level(pin)),
    "gpio.voltage": lambda w, _: 0.0,
}

_MOTION: dict[str, Function] = {
    "attitude.quaternion": lambda w, _: w.quaternion,
    "attitude.dcm": lambda w, _: w.dcm,
    "attitude.roll": lambda w, _: euler(w.dcm)[0],
    "attitude.pitch": lambda w, _: euler(w.dcm)[1],
    "attitude.yaw": lambda w, _: euler(w.dcm)[2],
    "attitude.sensor_heading": lambda w, _: euler(w.state.dcm)[2],
    "motion.angular_rate": lambda w, _: w.vehicle(w.state.rate),
    "motion.specific_force": lambda w, _: w.vehicle(w.specific_force),
    "motion.acceleration": lambda w, _: w.body(w.state.acceleration),
    "gravity.vector": lambda w, _: w.body((0.0, 0.0, w.gravity)),
    "gravity.magnitude": lambda w, _: w.gravity,
    "bias.angular_rate": lambda w, _: w.gyro_bias_left,
    "bias.specific_force": lambda w, _: w.accel_bias_left,
    "bias.gyro_setting": lambda w, _: w.gyro_bias,
    "identity.matrix": lambda w, _: (1, 0, 0, 0, 1, 0, 0, 0, 1),
    "identity.quaternion": lambda w, _: (1, 0, 0, 0),
    "covariance.magnetic_field": lambda w, _: (1e-6, 0, 0, 0, 1e-6, 0, 0, 0, 1e-6),
    "position.latitude": lambda w, _: w.state.latitude,
    "position.longitude": lambda w, _: w.state.longitude,
    "position.height": lambda w, _: w.state.height,
    "position.msl_height": lambda w, _: w.msl_height,
    "position.ecef": lambda w, _: w.ecef,
    "position.relative": _relative,
    "velocity.north": lambda w, _: w.state.velocity[0],
    "velocity.east": lambda w, _: w.state.velocity[1],
    "velocity.down": lambda w, _: w.state.velocity[2],
    "velocity.ecef": lambda w, _: earth.from_ned(w.state.latitude, w.state.longitude, w.state.velocity),
}

_SURROUNDINGS: dict[str, Function] = {
    "magnetic.north": lambda w, _: w.magnetic_field[0],
    "magnetic.east": lambda w, _: w.magnetic_field[1],
    "magnetic.down": lambda w, _: w.magnetic_field[2],
    "magnetic.inclination": lambda w, _: atan2(w.magnetic_field[2], hypot(*w.magnetic_field[:2])),
    "magnetic.declination": lambda w, _: atan2(w.magnetic_field[1], w.magnetic_field[0]),
    "air.altitude": lambda w, _: w.altitude,
    "air.temperature": lambda w, _: w.air[0],
    "air.pressure": lambda w, _: w.air[1],
    "air.density": lambda w, _: w.air[2],
    "filter.position_uncertainty": lambda w, _: 0.6,
    "filter.aids": lambda w, _: _AIDS,
    "aid.source": lambda w, aid: aid.source,
    "aid.type": lambda w, aid: aid.type,
    "filter.receivers": lambda w, _: tuple(Receiver(i, w.clock(i)) for i in _RECEIVERS),
    "receiver.id": lambda w, receiver: receiver.id,
    "receiver.clock_bias": lambda w, receiver: receiver.clock[0],
    "receiver.clock_drift": lambda w, receiver: receiver.clock[1],
}

QUANTITIES: dict[str, Function] = {**_TIME, **_SENSORS, **_MOTION, **_SURROUNDINGS, **GNSS}

#: Those that count from the last time: their item must be an `Output`.
INTERVALS = frozenset(
    ("reference.delta", "external.delta", "ticks.delta", "delta.rotation", "delta.velocity", "delta.matrix")
)

#: Standard deviation of what is measured, in the unit of the quantity.
NOISE = {
    "measured.specific_force": 0.01,
    "measured.angular_rate": 0.001,
    "measured.magnetic_field": 0.0005,
    "measured.pressure": 0.02,
    "measured.speed": 0.01,
}
"""White noise, drawn for each field and element."""

__all__ = ["INTERVALS", "NOISE", "QUANTITIES", "Function"]
