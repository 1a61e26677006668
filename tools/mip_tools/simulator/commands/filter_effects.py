"""Effects of commands on the filter, the receivers and the calibration of sensors, by their names in `spec/simulation`.

A setting affects only later results: the filter first advances to the present.
"""

from __future__ import annotations

from collections.abc import Callable
from math import inf, radians
from typing import Any

from ...geometry import earth
from ...geometry.attitude import euler, euler_rotation
from ...geometry.rotations import transposed
from ..filter.estimate import SOURCES
from ..state import DeviceState
from ..streams.values import receiver_of
from .knowledge import RANGES

Values = dict[str, Any]  # argument of the effect -> its value
Act = Callable[[DeviceState, Values], None]

#: Type of a range -> sensor, and the factor to the unit of the world.
_SENSORS = {1: ("accel", 9.80665), 2: ("gyro", radians(1)), 3: ("mag", 1.0)}


def _names(bits: Any) -> frozenset[str]:
    """Returns the names of the bits that are set."""
    return frozenset(member.name.lower() for member in type(bits) if member & bits)


# --------------------------------------------------------------------------- sensors


def _sensor_range(device: DeviceState, v: Values) -> None:
    sensor = _SENSORS.get(v["sensor"])
    most = dict(RANGES.get(v["sensor"], ())).get(v["setting"])
    if sensor is not None and most is not None:
        device.world.ranges[sensor[0]] = most * sensor[1]


def _low_pass(device: DeviceState, v: Values) -> None:
    """Sets or removes the cutoff of one field."""
    cutoffs = device.world.cutoffs
    at = (int(v["set"]), int(v["field"]))
    cutoffs.pop(at, None)
    if not v["enable"]:
        cutoffs[at] = inf
    elif v["manual"]:
        cutoffs[at] = float(v["frequency"])


def _complementary(device: DeviceState, v: Values) -> None:
    up = v["up_constant"] if v["up"] else inf
    device.world.complementary.constants = [up, up, v["north_constant"] if v["north"] else inf]


# --------------------------------------------------------------------------- places


def _antenna(device: DeviceState, v: Values) -> None:
    """Sets the error of an antenna offset: its difference from the factory default, which is correct."""
    receiver = v["receiver"] if v["receiver"] in (1, 2) else receiver_of(v["receiver"])
    if receiver:
        device.world.filter.options.offsets[receiver] = tuple(v["offset"])


def _tare(device: DeviceState, v: Values) -> None:
    """Makes the current roll, pitch or yaw of the vehicle zero."""
    world, axes = device.world, _names(v["axes"])
    if axes:
        angles = (0.0 if name in axes else x for name, x in zip(("roll", "pitch", "yaw"), euler(world.dcm)))
        world.sensor_to_vehicle = earth.product(euler_rotation(*angles)[1], transposed(world.state.dcm))


def _relative_position(device: DeviceState, v: Values) -> None:
    place = tuple(v["place"])
    if not v["manual"]:
        device.world.reference = None
    else:
        device.world.reference = place if v["frame"] == 1 else earth.ecef(*_radians(place))


def _radians(place: tuple[float, float, float]) -> earth.Vector:
    return radians(place[0]), radians(place[1]), place[2]


# --------------------------------------------------------------------------- the filter


def _initialization(device: DeviceState, v: Values) -> None:
    """Sets the options of initialization; angles are in degrees."""
    o = device.world.filter.options
    o.waits, o.initial_conditions, o.alignment = bool(v["wait"]), v["given"].name, _names(v["alignment"])
    o.attitude = (radians(v["roll"]), radians(v["pitch"]), radians(v["heading"]))
    place, velocity = tuple(v["position"]), tuple(v["velocity"])
    if v["frame"] == 1 and any(place):
        o.place = earth.llh(*place)
        o.velocity = earth.to_ned(o.place[0], o.place[1], velocity)
    else:
        o.place, o.velocity = _radians(place), velocity


def _attitude(device: DeviceState, v: Values) -> None:
    """Sets all angles, or only the heading, to those from the user."""
    world = device.world
    if "roll" in v or not world.filter.level:
        world.filter.set_attitude(world.state, v.get("roll"), v.get("pitch"), v["heading"])
    world.filter.set_heading(world.state, v["heading"])


def _attitude_from_sensors(device: DeviceState, v: Values) -> None:
    world = device.world
    yaw = earth.heading_of(world.dcm[0], world.dcm[1]) + v["declination"] - world.declination
    world.filter.set_attitude(world.state, None, None, yaw)
    world.filter.set_heading(world.state, yaw)


def _aiding(device: DeviceState, v: Values) -> None:
    o = device.world.filter.options
    kind = SOURCES.get(v["source"].name.lower(), v["source"].name.lower())
    o.disabled = o.disabled - {kind} if v["enable"] else o.disabled | {kind}


def _heading_source(device: DeviceState, v: Values) -> None:
    name = v["source"].name.lower()
    every = ("mag", "gnss_velocity", "external")
    device.world.filter.options.headings = frozenset(
        every if name == "all" else (x for x in every if x in name.split("_and_"))
    )


def _measurements(device: DeviceState, v: Values) -> None:
    o, used = device.world.filter.options, _names(v["used"])
    o.gravity, o.magnetometer = "accel" in used, "mag" in used


# --------------------------------------------------------------------------- measurements of the user


def _heading_measured(device: DeviceState, v: Values) -> None:
    if v.get("valid", 1):
        magnetic = "type" in v and v["type"].name == "MAGNETIC_HEADING"
        device.world.filter.heading(v["kind"], v["heading"], v["uncertainty"], magnetic)


def _position_measured(device: DeviceState, v: Values) -> None:
    """Applies a position in degrees and metres."""
    place = _radians((v["latitude"], v["longitude"], v["height"]))
    device.world.filter.position(v["kind"], place, tuple(v["uncertainty"]))
    if "velocity" in v:
        device.world.filter.velocity(v["kind"], tuple(v["velocity"]), tuple(v["velocity_uncertainty"]))


def _height_measured(device: DeviceState, v: Values) -> None:
    s = device.world.state
    if v["valid"]:
        place = (s.latitude, s.longitude, v["height"])
        device.world.filter.position(v["kind"], place, (v["uncertainty"],) * 3, (False, False, True))


def _pressure_measured(device: DeviceState, v: Values) -> None:
    if v["valid"]:
        world = device.world
        _, pressure, density = world.air
        metre = density * world.gravity / 100  # mbar
        height = world.state.height - (v["pressure"] - pressure) / metre
        place = (world.state.latitude, world.state.longitude, height)
        world.filter.position(v["kind"], place, (v["uncertainty"] / metre,) * 3, (False, False, True))


def _fixed_velocity_measured(device: DeviceState, v: Values) -> None:
    s = device.world.state
    velocity = earth.to_ned(s.latitude, s.longitude, tuple(v["velocity"]))
    device.world.filter.velocity(v["kind"], velocity, tuple(v["uncertainty"]))


def _body_velocity_measured(device: DeviceState, v: Values) -> None:
    """Applies a velocity in the vehicle frame."""
    velocity = earth.turned_back(device.world.dcm, tuple(v["velocity"]))
    device.world.filter.velocity(v["kind"], velocity, tuple(v["uncertainty"]))


def _speed_measured(device: DeviceState, v: Values) -> None:
    """Applies a forward speed. A vehicle is assumed not to move sideways or vertically in its own frame."""
    velocity = earth.turned_back(device.world.dcm, (v["speed"], 0.0, 0.0))
    device.world.filter.velocity(v["kind"], velocity, (max(v["uncertainty"], 1e-3),) * 3)


def _world(name: str, value: Callable[[Values], Any]) -> Act:
    """Makes an effect that sets an attribute of the world."""
    return lambda device, v: setattr(device.world, name, value(v))


def _option(name: str, value: Callable[[Values], Any]) -> Act:
    """Makes an effect that sets an option of the filter."""
    return lambda device, v: setattr(device.world.filter.options, name, value(v))


def _noise(v: Values) -> Any:
    return v["noise"] if isinstance(v["noise"], float) else tuple(v["noise"])


def _threshold(v: Values) -> float:
    return float(v["threshold"]) if v["enable"] else 0.0


_RECEIVERS = {"ALL_INTERNAL": (1, 2), "INTERNAL_1": (1,), "INTERNAL_2": (2,)}
_SYSTEMS = ("gps", "glonass", "galileo", "beidou")

FILTER_EFFECTS: dict[str, Act] = {
    "accel_bias_noise": _option("accel_bias_noise", _noise),
    "accel_noise": _option("accel_noise", _noise),
    "aiding_source": _aiding,
    "altitude_source": _option("pressure", lambda v: v["source"].name == "PRESSURE"),
    "antenna_offset": _antenna,
    "augmentation": _world("augmented", lambda v: bool(v["enable"])),
    "automatic_initialization": _option("automatic", lambda v: bool(v["enable"])),
    "body_velocity_measured": _body_velocity_measured,
    "complementary_filter": _complementary,
    "constellations": _world(
        "signals_off", lambda v: frozenset(e.constellation_id.name.lower() for e in v["entries"] if not e.enable)
    ),
    "declination": _option("declination", lambda v: {"NONE": 0.0, "MANUAL": v["declination"]}.get(v["source"].name)),
    "dynamics": _option("dynamics", lambda v: v["mode"].name.lower()),
    "estimated_states": _option("estimated", lambda v: _names(v["states"])),
    "filter_reset": lambda device, v: device.world.filter.reset(),
    "filter_run": lambda device, v: device.world.filter.run(),
    "fixed_position_measured": lambda device, v: (
        device.world.filter.position(  # its deviations are taken as north, east, down
            v["kind"], earth.llh(*v["position"]), tuple(v["uncertainty"])
        )
    ),
    "fixed_velocity_measured": _fixed_velocity_measured,
    "gnss_source": _option("receivers", lambda v: frozenset(_RECEIVERS.get(v["source"].name, ()))),
    "gravity_noise": _option("gravity_noise", _noise),
    "gyro_bias_noise": _option("gyro_bias_noise", _noise),
    "gyro_noise": _option("gyro_noise", _noise),
    "hard_iron": _world("hard_iron", lambda v: tuple(v["offset"])),
    "heading_measured": _heading_measured,
    "heading_source": _heading_source,
    "height_measured": _height_measured,
    "initial_attitude": _attitude,
    "initial_attitude_from_sensors": _attitude_from_sensors,
    "initialization": _initialization,
    "level_source": _option("gravity", lambda v: v["source"].name == "GRAVITY_VECTOR"),
    "low_pass": _low_pass,
    "mag_noise": _option("mag_noise", lambda v: max(v["noise"])),
    "measurements": _measurements,
    "no_rotation": lambda device, v: device.world.filter.rests(),
    "no_velocity": lambda device, v: device.world.filter.stands(),
    "odometer": _world("odometer", lambda v: max(v["uncertainty"], 1e-3) if v["mode"] else 0.0),
    "position_measured": _position_measured,
    "pressure_measured": _pressure_measured,
    "pressure_noise": _option("pressure_noise", _noise),
    "pulse": lambda device, v: device.world.select_pulse(v["source"].name.lower()),
    "reference_point": _world("offset", lambda v: tuple(v["offset"])),
    "reference_position": _world(
        "model", lambda v: _radians((v["latitude"], v["longitude"], v["height"])) if v["enable"] else None
    ),
    "relative_position": _relative_position,
    "sensor_range": _sensor_range,
    "signals": _world("signals_off", lambda v: frozenset(name for name in _SYSTEMS if not v[name])),
    "soft_iron": _world("soft_iron", lambda v: tuple(v["matrix"])),
    "speed_measured": _speed_measured,
    "tare": _tare,
    "velocity_measured": lambda device, v: device.world.filter.velocity(  # along north, east and down
        v["kind"], tuple(v["velocity"]), tuple(v["uncertainty"])
    ),
    "zero_rotation": _option("turns_above", _threshold),
    "zero_velocity": _option("stops_below", _threshold),
}
