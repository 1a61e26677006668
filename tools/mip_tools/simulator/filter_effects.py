"""Effects of commands on the filter, the receivers and the calibration of sensors, by their names in `spec/simulation`.

A setting affects only later results: the filter first advances to the present.
"""

from __future__ import annotations

from collections.abc import Callable
from math import inf, radians
from typing import TYPE_CHECKING, Any

from . import earth
from .estimate import SOURCES
from .knowledge import RANGES
from .rotations import transposed
from .state import euler, rotation
from .values import receiver_of

if TYPE_CHECKING:
    from .device import VirtualDevice

Values = dict[str, Any]  # argument of the effect -> its value
Act = Callable[["VirtualDevice", Values], None]

#: Type of a range -> sensor, and the factor to the unit of the world.
_SENSORS = {1: ("accel", 9.80665), 2: ("gyro", radians(1)), 3: ("mag", 1.0)}


def _names(bits: Any) -> frozenset[str]:
    """Returns the names of the bits that are set."""
    return frozenset(member.name.lower() for member in type(bits) if member & bits)


# --------------------------------------------------------------------------- sensors


def _hard_iron(device: VirtualDevice, v: Values) -> None:
    device.world.hard_iron = tuple(v["offset"])


def _soft_iron(device: VirtualDevice, v: Values) -> None:
    device.world.soft_iron = tuple(v["matrix"])


def _sensor_range(device: VirtualDevice, v: Values) -> None:
    known = _SENSORS.get(v["sensor"])
    most = dict(RANGES.get(v["sensor"], ())).get(v["setting"])
    if known is not None and most is not None:
        device.world.ranges[known[0]] = most * known[1]


def _low_pass(device: VirtualDevice, v: Values) -> None:
    """Sets or removes the cutoff of one field."""
    cutoffs = device.world.cutoffs
    at = (int(v["set"]), int(v["field"]))
    cutoffs.pop(at, None)
    if not v["enable"]:
        cutoffs[at] = inf
    elif v["manual"]:
        cutoffs[at] = float(v["frequency"])


def _complementary(device: VirtualDevice, v: Values) -> None:
    up = v["up_constant"] if v["up"] else inf
    device.world.complementary.constants = [up, up, v["north_constant"] if v["north"] else inf]


def _odometer(device: VirtualDevice, v: Values) -> None:
    device.world.odometer = max(v["uncertainty"], 1e-3) if v["mode"] else 0.0


# --------------------------------------------------------------------------- places


def _point(device: VirtualDevice, v: Values) -> None:
    """Sets the point whose position and velocity the device reports."""
    device.world.offset = tuple(v["offset"])


def _antenna(device: VirtualDevice, v: Values) -> None:
    """Sets the error of an antenna offset: its difference from the factory default, which is correct."""
    receiver = v["receiver"] if v["receiver"] in (1, 2) else receiver_of(v["receiver"])
    if receiver:
        device.world.filter.options.offsets[receiver] = tuple(v["offset"])


def _tare(device: VirtualDevice, v: Values) -> None:
    """Makes the current roll, pitch or yaw of the vehicle zero."""
    world, axes = device.world, _names(v["axes"])
    if axes:
        angles = (0.0 if name in axes else x for name, x in zip(("roll", "pitch", "yaw"), euler(world.dcm)))
        world.sensor_to_vehicle = earth.product(rotation(*angles)[1], transposed(world.state.dcm))


def _relative_position(device: VirtualDevice, v: Values) -> None:
    place = tuple(v["place"])
    if not v["manual"]:
        device.world.reference = None
    else:
        device.world.reference = place if v["frame"] == 1 else earth.ecef(*_radians(place))


def _reference_position(device: VirtualDevice, v: Values) -> None:
    place = (v["latitude"], v["longitude"], v["height"])
    device.world.model = _radians(place) if v["enable"] else None


def _radians(place: tuple[float, float, float]) -> earth.Vector:
    return radians(place[0]), radians(place[1]), place[2]


def _declination(device: VirtualDevice, v: Values) -> None:
    name = v["source"].name
    device.world.filter.options.declination = {"NONE": 0.0, "MANUAL": v["declination"]}.get(name)


# --------------------------------------------------------------------------- receivers


def _signals(device: VirtualDevice, v: Values) -> None:
    device.world.signals_off = frozenset(name for name in ("gps", "glonass", "galileo", "beidou") if not v[name])


def _constellations(device: VirtualDevice, v: Values) -> None:
    off = (e.constellation_id.name.lower() for e in v["entries"] if not e.enable)
    device.world.signals_off = frozenset(off)


def _augmentation(device: VirtualDevice, v: Values) -> None:
    device.world.augmented = bool(v["enable"])


def _pulse(device: VirtualDevice, v: Values) -> None:
    device.world.pulse = v["source"].name != "DISABLED"


# --------------------------------------------------------------------------- the filter


def _filter_reset(device: VirtualDevice, v: Values) -> None:
    device.world.filter.reset()


def _filter_run(device: VirtualDevice, v: Values) -> None:
    device.world.filter.run()


def _initialization(device: VirtualDevice, v: Values) -> None:
    """Sets the options of initialization; angles are in degrees."""
    o = device.world.filter.options
    o.waits, o.given, o.alignment = bool(v["wait"]), v["given"].name, _names(v["alignment"])
    o.attitude = (radians(v["roll"]), radians(v["pitch"]), radians(v["heading"]))
    place, velocity = tuple(v["position"]), tuple(v["velocity"])
    if v["frame"] == 1 and any(place):
        o.place = earth.llh(*place)
        o.velocity = earth.to_ned(o.place[0], o.place[1], velocity)
    else:
        o.place, o.velocity = _radians(place), velocity


def _automatic(device: VirtualDevice, v: Values) -> None:
    device.world.filter.options.automatic = bool(v["enable"])


def _attitude(device: VirtualDevice, v: Values) -> None:
    """Sets all angles, or only the heading, to those from the user."""
    world = device.world
    if "roll" in v or not world.filter.level:
        world.filter.set_attitude(world.state, v.get("roll"), v.get("pitch"), v["heading"])
    world.filter.set_heading(world.state, v["heading"])


def _attitude_from_sensors(device: VirtualDevice, v: Values) -> None:
    world = device.world
    yaw = earth.heading(world.dcm[0], world.dcm[1]) + v["declination"] - world.declination
    world.filter.set_attitude(world.state, None, None, yaw)
    world.filter.set_heading(world.state, yaw)


def _aiding(device: VirtualDevice, v: Values) -> None:
    o = device.world.filter.options
    kind = SOURCES.get(v["source"].name.lower(), v["source"].name.lower())
    o.disabled = o.disabled - {kind} if v["enable"] else o.disabled | {kind}


def _heading_source(device: VirtualDevice, v: Values) -> None:
    name = v["source"].name.lower()
    every = ("mag", "gnss_velocity", "external")
    device.world.filter.options.headings = frozenset(
        every if name == "all" else (x for x in every if x in name.split("_and_"))
    )


def _gnss_source(device: VirtualDevice, v: Values) -> None:
    receivers = {"ALL_INTERNAL": (1, 2), "INTERNAL_1": (1,), "INTERNAL_2": (2,)}
    device.world.filter.options.receivers = frozenset(receivers.get(v["source"].name, ()))


def _altitude_source(device: VirtualDevice, v: Values) -> None:
    device.world.filter.options.pressure = v["source"].name == "PRESSURE"


def _level_source(device: VirtualDevice, v: Values) -> None:
    device.world.filter.options.gravity = v["source"].name == "GRAVITY_VECTOR"


def _measurements(device: VirtualDevice, v: Values) -> None:
    o, used = device.world.filter.options, _names(v["used"])
    o.gravity, o.magnetometer = "accel" in used, "mag" in used


def _states(device: VirtualDevice, v: Values) -> None:
    device.world.filter.options.estimated = _names(v["states"])


def _dynamics(device: VirtualDevice, v: Values) -> None:
    device.world.filter.options.dynamics = v["mode"].name.lower()


def _stops(device: VirtualDevice, v: Values) -> None:
    device.world.filter.options.stops_below = v["threshold"] if v["enable"] else 0.0


def _turns(device: VirtualDevice, v: Values) -> None:
    device.world.filter.options.turns_above = v["threshold"] if v["enable"] else 0.0


def _noise(name: str) -> Act:
    """Sets a deviation that the filter assumes."""

    def act(device: VirtualDevice, v: Values) -> None:
        given = v["noise"]
        setattr(device.world.filter.options, name, given if isinstance(given, float) else tuple(given))

    return act


def _mag_noise(device: VirtualDevice, v: Values) -> None:
    device.world.filter.options.mag_noise = max(v["noise"])


# --------------------------------------------------------------------------- measurements of the user


def _stands(device: VirtualDevice, v: Values) -> None:
    device.world.filter.stands()


def _rests(device: VirtualDevice, v: Values) -> None:
    device.world.filter.rests()


def _heading_measured(device: VirtualDevice, v: Values) -> None:
    if v.get("valid", 1):
        magnetic = "type" in v and v["type"].name == "MAGNETIC_HEADING"
        device.world.filter.heading(v["kind"], v["heading"], v["uncertainty"], magnetic)


def _position_measured(device: VirtualDevice, v: Values) -> None:
    """Applies a position in degrees and metres."""
    place = _radians((v["latitude"], v["longitude"], v["height"]))
    device.world.filter.position(v["kind"], place, tuple(v["uncertainty"]))
    if "velocity" in v:
        device.world.filter.velocity(v["kind"], tuple(v["velocity"]), tuple(v["velocity_uncertainty"]))


def _fixed_position_measured(device: VirtualDevice, v: Values) -> None:
    """Applies an Earth-fixed position, with its deviations taken as north, east and down."""
    device.world.filter.position(v["kind"], earth.llh(*v["position"]), tuple(v["uncertainty"]))


def _height_measured(device: VirtualDevice, v: Values) -> None:
    s = device.world.state
    if v["valid"]:
        place = (s.latitude, s.longitude, v["height"])
        device.world.filter.position(v["kind"], place, (v["uncertainty"],) * 3, (False, False, True))


def _pressure_measured(device: VirtualDevice, v: Values) -> None:
    if v["valid"]:
        world = device.world
        _, pressure, density = world.air
        metre = density * world.gravity / 100  # mbar
        height = world.state.height - (v["pressure"] - pressure) / metre
        place = (world.state.latitude, world.state.longitude, height)
        world.filter.position(v["kind"], place, (v["uncertainty"] / metre,) * 3, (False, False, True))


def _velocity_measured(device: VirtualDevice, v: Values) -> None:
    """Applies a velocity along north, east and down."""
    device.world.filter.velocity(v["kind"], tuple(v["velocity"]), tuple(v["uncertainty"]))


def _fixed_velocity_measured(device: VirtualDevice, v: Values) -> None:
    s = device.world.state
    velocity = earth.to_ned(s.latitude, s.longitude, tuple(v["velocity"]))
    device.world.filter.velocity(v["kind"], velocity, tuple(v["uncertainty"]))


def _body_velocity_measured(device: VirtualDevice, v: Values) -> None:
    """Applies a velocity in the vehicle frame."""
    velocity = earth.turned_back(device.world.dcm, tuple(v["velocity"]))
    device.world.filter.velocity(v["kind"], velocity, tuple(v["uncertainty"]))


def _speed_measured(device: VirtualDevice, v: Values) -> None:
    """Applies a forward speed. A vehicle is assumed not to move sideways or vertically in its own frame."""
    velocity = earth.turned_back(device.world.dcm, (v["speed"], 0.0, 0.0))
    device.world.filter.velocity(v["kind"], velocity, (max(v["uncertainty"], 1e-3),) * 3)


FILTER_EFFECTS: dict[str, Act] = {
    "accel_bias_noise": _noise("accel_bias_noise"),
    "accel_noise": _noise("accel_noise"),
    "aiding_source": _aiding,
    "altitude_source": _altitude_source,
    "antenna_offset": _antenna,
    "augmentation": _augmentation,
    "automatic_initialization": _automatic,
    "body_velocity_measured": _body_velocity_measured,
    "complementary_filter": _complementary,
    "constellations": _constellations,
    "declination": _declination,
    "dynamics": _dynamics,
    "estimated_states": _states,
    "filter_reset": _filter_reset,
    "filter_run": _filter_run,
    "fixed_position_measured": _fixed_position_measured,
    "fixed_velocity_measured": _fixed_velocity_measured,
    "gnss_source": _gnss_source,
    "gravity_noise": _noise("gravity_noise"),
    "gyro_bias_noise": _noise("gyro_bias_noise"),
    "gyro_noise": _noise("gyro_noise"),
    "hard_iron": _hard_iron,
    "heading_measured": _heading_measured,
    "heading_source": _heading_source,
    "height_measured": _height_measured,
    "initial_attitude": _attitude,
    "initial_attitude_from_sensors": _attitude_from_sensors,
    "initialization": _initialization,
    "level_source": _level_source,
    "low_pass": _low_pass,
    "mag_noise": _mag_noise,
    "measurements": _measurements,
    "no_rotation": _rests,
    "no_velocity": _stands,
    "odometer": _odometer,
    "position_measured": _position_measured,
    "pressure_measured": _pressure_measured,
    "pressure_noise": _noise("pressure_noise"),
    "pulse": _pulse,
    "reference_point": _point,
    "reference_position": _reference_position,
    "relative_position": _relative_position,
    "sensor_range": _sensor_range,
    "signals": _signals,
    "soft_iron": _soft_iron,
    "speed_measured": _speed_measured,
    "tare": _tare,
    "velocity_measured": _velocity_measured,
    "zero_rotation": _turns,
    "zero_velocity": _stops,
}

__all__ = ["FILTER_EFFECTS"]
