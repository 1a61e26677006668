"""Computes the quantities that the specification names: (world, item) -> value in the unit of the specification.

The item is an item of a list (`for_each`), an `Output` for other data, or, for responses, the values of the command.
"""

from __future__ import annotations

from collections.abc import Callable
from math import atan2, hypot, pi, sin
from typing import Any, NamedTuple

from mip_tools.geometry import earth
from mip_tools.geometry.attitude import (
    attitude_matrix,
    conjugate,
    euler,
    multiplied,
    quaternion,
    rotation_vector,
)
from mip_tools.geometry.earth import SECOND, WEEK, Vector

from ..filter.estimate import Filter, rotated
from ..surroundings.surroundings import Output, scaled, summed
from .receivers import GNSS, Function
from .world import World


class Receiver(NamedTuple):
    id: int
    clock: tuple[float, float]


_RECEIVERS = (1, 2)
#: Sensors, by what they measure.
ACCEL, GYRO, MAG = "measured.specific_force", "measured.angular_rate", "measured.magnetic_field"
PRESSURE, SPEED = "measured.pressure", "measured.speed"


def _flags(w: World) -> tuple[str, ...]:
    flags = tuple(f"{part}_valid" for part in w.valid_parts)
    flags += ("pps_valid",) * w.synchronized + ("time_initialized",) * w.initialized
    updates = w.updates + (w.clock // SECOND if w.dated and w.synchronized else 0)
    return (*flags, "time_refresh") if updates % 2 else flags


def _measured(w: World, sensor: str, true: Vector, constant: Vector, out: Any) -> Vector:
    """Returns the mean of an inertial sensor since the last output, in its own frame. `constant` is its bias without
    the drift, which is part of the noise."""
    noise = w.mean_noise(sensor, out)
    return summed(true, constant) if noise is None else summed(summed(true, constant), noise)


def _force(w: World, out: Any) -> Vector:
    force = w.within("accel", _measured(w, ACCEL, w.specific_force, w.accel_constant_left, out))
    return w.vehicle(force)


def _rate(w: World, out: Any) -> Vector:
    rate = w.within("gyro", _measured(w, GYRO, w.state.rate, w.gyro_constant_left, out))
    return w.vehicle(rate)


def _magnetic(w: World, out: Any) -> Vector:
    field = summed(_raw_magnetic(w, out), scaled(w.hard_iron, -1.0))
    return w.vehicle(w.within("mag", earth.turned(w.soft_iron, field)))


def _raw_magnetic(w: World, out: Any) -> Vector:
    noise = w.mean_noise(MAG, out)
    true = summed(earth.turned(w.state.dcm, w.magnetic_field), w.disturbance)
    return true if noise is None else summed(true, noise)


def _single(sensor: str, true: float, w: World, out: Any) -> float:
    noise = w.mean_noise(sensor, out)
    return true if noise is None else true + noise[0]


def _compensated(sensor: str, bias: str, true: Callable[[World], Vector]) -> Function:
    """Makes a quantity: what a sensor measures, without the bias that the filter estimates."""

    def value(w: World, out: Any) -> Vector:
        w.filter.advance()
        v = summed(true(w), scaled(w.filter.error(bias), -1.0))
        noise = _white(w, sensor, out)
        return w.vehicle(v if noise is None else summed(v, noise))

    return value


def _white(w: World, sensor: str, out: Any) -> Vector | None:
    """Returns the noise without the drift, because the filter estimates the drift with the bias."""
    noise = w.mean_noise(sensor, out)
    return None if noise is None else summed(noise, scaled(w.sensors[sensor].bias, -w.noise))


def _overrange(w: World, _: Any) -> tuple[str, ...]:
    """Lists the axes that are near the end of their range."""
    field = _raw_magnetic(w, None)
    values = {"accel": summed(w.specific_force, w.accel_bias_left), "gyro": summed(w.state.rate, w.gyro_bias_left)}
    values["mag"] = field
    return tuple(
        f"{sensor}_{axis}"
        for sensor, v in values.items()
        if sensor in w.ranges
        for axis, x in zip("xyz", v)
        if abs(x) > 0.98 * w.ranges[sensor]
    )


def _seconds(w: World, out: Output) -> float:
    return (w.now - (out.previous or 0)) / SECOND


def _rotation(w: World, out: Output) -> Vector:
    turn = summed(rotation_vector(out.attitude, w.state.quaternion), scaled(w.gyro_constant_left, _seconds(w, out)))
    noise = w.added_noise(GYRO, out)
    return w.vehicle(turn if noise is None else summed(turn, noise))


def _velocity(w: World, out: Output) -> Vector:
    t = _seconds(w, out)
    (n, e, d), (a, b, c) = w.state.velocity, out.velocity
    change = earth.turned(attitude_matrix(out.attitude), (n - a, e - b, d - c - w.gravity * t))
    change = summed(change, scaled(w.accel_constant_left, t))
    noise = w.added_noise(ACCEL, out)
    return w.vehicle(change if noise is None else summed(change, noise))


def _matrix(w: World, out: Output) -> tuple[float, ...]:
    m = attitude_matrix(multiplied(conjugate(out.attitude), w.state.quaternion))
    if not w.complementary_turns:
        return m
    turn = w.sensor_to_vehicle
    columns = (turn[0], turn[3], turn[6], turn[1], turn[4], turn[7], turn[2], turn[5], turn[8])
    return earth.product(turn, earth.product(m, columns))


def _relative(w: World, _: Any) -> Vector:
    x, y, z = (a - b for a, b in zip(_ecef(w), w.origin))
    latitude, longitude, _height = earth.llh(*w.origin)
    return earth.to_ned(latitude, longitude, (x, y, z))


def _ecef(w: World) -> Vector:
    x = w.place
    return earth.ecef(x.latitude, x.longitude, x.height)


def _deviation(what: str, axis: int | None = None) -> Function:
    """Makes a quantity: what a property of the filter states, for all axes or one."""

    def value(w: World, _: Any) -> Any:
        w.filter.advance()
        values = getattr(w.filter, what)
        return values if axis is None else values[axis]

    return value


def _earth_fixed(what: str) -> Function:
    return lambda w, _: rotated(_deviation(what)(w, None), w.state.latitude, w.state.longitude)


def _of_quaternion(w: World, _: Any) -> tuple[float, ...]:
    """Returns an upper bound for the deviation of each element: half the deviation of the whole rotation."""
    return (hypot(*_deviation("attitude")(w, None)) / 2,) * 4


def _of_filter(read: Callable[[Filter], Any]) -> Function:
    def value(w: World, _: Any) -> Any:
        w.filter.advance()
        return read(w.filter)

    return value


def _ticks(now: int, out: Any) -> int:
    rate = out.rate if isinstance(out, Output) and out.rate > 0 else 1.0
    return round(now * rate / SECOND) % 2**32


def _temperature(extreme: float) -> Function:
    return lambda w, _: 35.0 + extreme * (1 + 0.5 * sin(2 * pi * (w.now % (3600 * SECOND)) / (3600 * SECOND)))


_TIME: dict[str, Function] = {
    "gps.tow": lambda w, _: w.gps % WEEK / SECOND,
    "gps.week": lambda w, _: w.gps // WEEK,
    "clock.tow": lambda w, _: w.clock % WEEK / SECOND,
    "clock.week": lambda w, _: w.clock // WEEK,
    "clock.seconds": lambda w, _: w.clock // SECOND,
    "clock.microseconds": lambda w, _: w.clock % SECOND // 1000,
    "clock.time": lambda w, _: w.clock,
    "clock.flags": lambda w, _: _flags(w),
    "clock.parts": lambda w, _: w.valid_parts,
    "clock.dated": lambda w, _: int(w.dated),
    "clock.pulse": lambda w, _: w.synchronized,
    "gps.leap_seconds": lambda w, _: earth.leap_seconds(w.gps),
    "clock.pulse_age": lambda w, _: 0 if w.synchronized else 255,
    "utc.year": lambda w, _: earth.gps_to_utc(w.gps).year,
    "utc.month": lambda w, _: earth.gps_to_utc(w.gps).month,
    "utc.day": lambda w, _: earth.gps_to_utc(w.gps).day,
    "utc.hour": lambda w, _: earth.gps_to_utc(w.gps).hour,
    "utc.minute": lambda w, _: earth.gps_to_utc(w.gps).minute,
    "utc.second": lambda w, _: earth.gps_to_utc(w.gps).second,
    "utc.millisecond": lambda w, _: w.gps % SECOND // 1_000_000,
    "reference.time": lambda w, _: w.now - w.booted,
    "reference.delta": lambda w, out: w.now - out.previous,
    "external.delta": lambda w, out: w.now - out.previous,
    "reference.counts": lambda w, _: (w.now - w.booted) // 16000 % 2**32,
    "ticks.count": lambda w, out: _ticks(w.now - w.booted, out),
    "ticks.delta": lambda w, out: _ticks(w.now, out) - _ticks(out.previous, out) & 0xFFFFFFFF,
    "event.trigger": lambda w, _: 0,
}

_SENSORS: dict[str, Function] = {
    "measured.specific_force": _force,
    "measured.angular_rate": _rate,
    "measured.magnetic_field": _magnetic,
    "measured.pressure": lambda w, out: _single(PRESSURE, w.air[1], w, out),
    "measured.speed": lambda w, out: _single(SPEED, earth.turned(w.state.dcm, w.state.velocity)[0], w, out),
    "odometer.uncertainty": lambda w, _: max(0.01, w.odometer * hypot(*w.state.velocity)),
    "odometer.configured": lambda w, _: w.odometer > 0,
    "overrange.axes": _overrange,
    "counts.specific_force": lambda w, out: scaled(
        _measured(w, ACCEL, w.specific_force, w.accel_constant, out), 1000.0
    ),
    "counts.angular_rate": lambda w, out: scaled(_measured(w, GYRO, w.state.rate, w.gyro_constant, out), 5000.0),
    "counts.magnetic_field": lambda w, out: scaled(_raw_magnetic(w, out), 5000.0),
    "counts.pressure": lambda w, out: 100 * _single(PRESSURE, w.air[1], w, out),
    "counts.temperature": lambda w, _: (2350, 2350, 2350, 2400),
    "delta.rotation": _rotation,
    "delta.velocity": _velocity,
    "delta.matrix": _matrix,
    "stabilized.up": lambda w, _: earth.turned(w.state.dcm, (0.0, 0.0, -w.gravity)),
    "stabilized.north": lambda w, _: earth.turned(w.state.dcm, w.magnetic_field),
    "temperature.min": _temperature(-2.0),
    "temperature.max": _temperature(2.0),
    "temperature.mean": _temperature(0.0),
    "gpio.states": lambda w, _: sum(1 << (pin - 1) for pin in {*w.pins, *w.pulled_up} if w.level(pin)),
    "gpio.voltage": lambda w, _: 0.0,
}

_MOTION: dict[str, Function] = {
    "attitude.quaternion": lambda w, _: w.attitude[0],
    "attitude.dcm": lambda w, _: w.attitude[1],
    "attitude.roll": lambda w, _: euler(w.attitude[1])[0],
    "attitude.pitch": lambda w, _: euler(w.attitude[1])[1],
    "attitude.yaw": lambda w, _: euler(w.attitude[1])[2],
    "attitude.sensor_heading": lambda w, _: euler(w.state.dcm)[2],
    "complementary.quaternion": lambda w, _: quaternion(m) if (m := w.complementary) is not w.dcm else w.quaternion,
    "complementary.dcm": lambda w, _: w.complementary,
    "complementary.roll": lambda w, _: euler(w.complementary)[0],
    "complementary.pitch": lambda w, _: euler(w.complementary)[1],
    "complementary.yaw": lambda w, _: euler(w.complementary)[2],
    "motion.angular_rate": _compensated(GYRO, "gyro_bias", lambda w: w.state.rate),
    "motion.specific_force": _compensated(ACCEL, "accel_bias", lambda w: w.specific_force),
    "motion.acceleration": _compensated(ACCEL, "accel_bias", lambda w: earth.turned(w.state.dcm, w.state.acceleration)),
    "gravity.vector": lambda w, _: earth.turned(w.attitude[1], (0.0, 0.0, w.gravity)),
    "gravity.magnitude": lambda w, _: w.gravity,
    "bias.angular_rate": lambda w, _: summed(w.gyro_bias_left, w.filter.error("gyro_bias")),
    "bias.specific_force": lambda w, _: summed(w.accel_bias_left, w.filter.error("accel_bias")),
    "bias.gyro_setting": lambda w, _: w.gyro_bias,
    "identity.matrix": lambda w, _: (1, 0, 0, 0, 1, 0, 0, 0, 1),
    "identity.quaternion": lambda w, _: (1, 0, 0, 0),
    "covariance.magnetic_field": lambda w, _: (1e-6, 0, 0, 0, 1e-6, 0, 0, 0, 1e-6),
    "position.latitude": lambda w, _: w.place.latitude,
    "position.longitude": lambda w, _: w.place.longitude,
    "position.height": lambda w, _: w.place.height,
    "position.msl_height": lambda w, _: w.msl_height,
    "position.ecef": lambda w, _: _ecef(w),
    "position.relative": _relative,
    "velocity.north": lambda w, _: w.place.velocity[0],
    "velocity.east": lambda w, _: w.place.velocity[1],
    "velocity.down": lambda w, _: w.place.velocity[2],
    "velocity.ecef": lambda w, _: earth.from_ned(w.place.latitude, w.place.longitude, w.place.velocity),
}


_SURROUNDINGS: dict[str, Function] = {
    "magnetic.north": lambda w, _: w.magnetic_field[0],
    "magnetic.east": lambda w, _: w.magnetic_field[1],
    "magnetic.down": lambda w, _: w.magnetic_field[2],
    "magnetic.inclination": lambda w, _: atan2(w.magnetic_field[2], hypot(*w.magnetic_field[:2])),
    "magnetic.declination": lambda w, _: w.declination,
    "air.altitude": lambda w, _: w.altitude,
    "air.temperature": lambda w, _: w.air[0],
    "air.pressure": lambda w, _: w.air[1],
    "air.density": lambda w, _: w.air[2],
    "uncertainty.roll": _deviation("attitude", 0),
    "uncertainty.pitch": _deviation("attitude", 1),
    "uncertainty.yaw": _deviation("attitude", 2),
    "uncertainty.quaternion": _of_quaternion,
    "uncertainty.gyro_bias": _deviation("gyro_bias"),
    "uncertainty.accel_bias": _deviation("accel_bias"),
    "uncertainty.north": _deviation("position", 0),
    "uncertainty.east": _deviation("position", 1),
    "uncertainty.down": _deviation("position", 2),
    "uncertainty.position": _earth_fixed("position"),
    "uncertainty.velocity_north": _deviation("velocity", 0),
    "uncertainty.velocity_east": _deviation("velocity", 1),
    "uncertainty.velocity_down": _deviation("velocity", 2),
    "uncertainty.velocity": _earth_fixed("velocity"),
    "filter.has_attitude": _of_filter(lambda f: f.level),
    "filter.has_position": _of_filter(lambda f: f.placed),
    "filter.state": _of_filter(lambda f: f.state),
    "filter.dynamics": lambda w, _: (w.filter.options.dynamics, "default", "portable"),
    "filter.flags": _of_filter(lambda f: f.flags),
    "filter.headings": _of_filter(lambda f: f.headings),
    "filter.aids": _of_filter(lambda f: tuple(f.aids())),
    "aid.source": lambda w, aid: aid.source,
    "aid.type": lambda w, aid: aid.type,
    "aid.indicator": lambda w, aid: aid.indicator,
    "filter.receivers": lambda w, _: tuple(Receiver(i, w.receiver_clock(i)) for i in _RECEIVERS),
    "receiver.id": lambda w, receiver: receiver.id,
    "receiver.clock_bias": lambda w, receiver: receiver.clock[0],
    "receiver.clock_drift": lambda w, receiver: receiver.clock[1],
}

QUANTITIES: dict[str, Function] = {**_TIME, **_SENSORS, **_MOTION, **_SURROUNDINGS, **GNSS}

#: Quantities that count from the last output. Their item must be an `Output`.
INTERVALS = frozenset(
    ("reference.delta", "external.delta", "ticks.delta", "delta.rotation", "delta.velocity", "delta.matrix")
)

#: Means since the last output. Their item must also be an `Output`, one for each field.
MEANS = frozenset(
    name
    for name in QUANTITIES
    if name.partition(".")[0] in ("measured", "counts", "motion") and name != "counts.temperature"
)


def quantity(world: World, name: str, item: Any = None) -> Any:
    """Computes a quantity by its name in the specification."""
    return QUANTITIES[name](world, item)
