"""Effects of commands on the filter, the receivers and the calibration of sensors, by their names in `spec/simulation`.

A setting affects only later results: the filter first advances to the present.
"""

from __future__ import annotations

from collections.abc import Callable
from math import radians
from typing import Any

from mip_tools.devices.codes import COMMAND_FAILED, INVALID_PARAMETER, Refused
from mip_tools.geometry import earth
from mip_tools.geometry.attitude import euler

from ..filter.estimate import HEADING_UPDATES, SOURCES
from ..state import DeviceState
from .knowledge import RANGES

Values = dict[str, Any]  # argument of the effect -> its value
Act = Callable[[DeviceState, Values], None]

#: Type of a range -> sensor, and the factor to the unit of the world.
_SENSORS = {1: ("accel", 9.80665), 2: ("gyro", radians(1)), 3: ("mag", 1.0)}


def names_of_bits(bits: Any) -> frozenset[str]:
    """Returns the names of the bits that are set."""
    return frozenset(member.name.lower() for member in type(bits) if member & bits)


def _sensor_range(device: DeviceState, v: Values) -> None:
    sensor = _SENSORS.get(v["sensor"])
    most = dict(RANGES.get(v["sensor"], ())).get(v["setting"])
    if most is None and v["writes"]:
        raise Refused(INVALID_PARAMETER)
    if sensor is not None and most is not None:
        device.world.ranges[sensor[0]] = most * sensor[1]


def _relative_position(device: DeviceState, v: Values) -> None:
    x, y, z = v["place"]
    fixed = (x, y, z) if v["frame"] == 1 else earth.ecef(radians(x), radians(y), z)
    device.world.reference = fixed if v["manual"] else None


def _initialization(device: DeviceState, v: Values) -> None:
    o = device.world.filter.options
    o.waits, o.alignment = bool(v["wait"]), names_of_bits(v["alignment"])
    o.heading = None if v["given"].name == "AUTO_POSITION_VELOCITY_ATTITUDE" else radians(v["heading"])
    o.place = v["given"].name == "MANUAL"


def _attitude(device: DeviceState, v: Values) -> None:
    """Levels the filter, with the heading of the user, or else that of the sensors.

    Devices up to the generation `initial` accept it only in the initialization state.
    """
    world = device.world
    if (device.profile.generation or 0) <= v.get("initial", -1) and "run_solution_valid" in world.filter.state:
        raise Refused(COMMAND_FAILED)
    yaw = v["heading"] if "heading" in v else euler(world.dcm)[2] + v["declination"] - world.declination
    world.filter.set_heading(world.state, yaw)
    world.filter.aligned = True


def _aiding(device: DeviceState, v: Values) -> None:
    o = device.world.filter.options
    kind = SOURCES.get(v["source"].name.lower(), v["source"].name.lower())
    o.disabled = o.disabled - {kind} if v["enable"] else o.disabled | {kind}


def _measured(device: DeviceState, v: Values) -> None:
    o = device.world.filter.options
    if v["kind"] in HEADING_UPDATES and ("heading" in o.disabled or not o.external_heading):
        raise Refused(COMMAND_FAILED)
    if v.get("valid", 1):
        device.world.filter.hear(v["kind"])


def _world(name: str, value: Callable[[Values], Any]) -> Act:
    """Makes an effect that sets an attribute of the world."""
    return lambda device, v: setattr(device.world, name, value(v))


def _option(name: str, value: Callable[[Values], Any]) -> Act:
    """Makes an effect that sets an option of the filter."""
    return lambda device, v: setattr(device.world.filter.options, name, value(v))


_RECEIVERS = {"ALL_INTERNAL": (1, 2), "INTERNAL_1": (1,), "INTERNAL_2": (2,)}

FILTER_EFFECTS: dict[str, Act] = {
    "aiding_source": _aiding,
    "automatic_initialization": _option("automatic", lambda v: bool(v["enable"])),
    "dynamics": _option("dynamics", lambda v: v["mode"].name.lower()),
    "filter_reset": lambda device, v: device.world.filter.reset(),
    "filter_run": lambda device, v: device.world.filter.run(),
    "gnss_source": _option("receivers", lambda v: frozenset(_RECEIVERS.get(v["source"].name, ()))),
    "heading_source": _option("external_heading", lambda v: v["source"].name.endswith(("EXTERNAL", "ALL"))),
    "hard_iron": _world("hard_iron", lambda v: tuple(v["offset"])),
    "initial_attitude": _attitude,
    "initialization": _initialization,
    "measured": _measured,
    "odometer": _world("odometer", lambda v: max(v["uncertainty"], 1e-3) if v["mode"] else 0.0),
    "pulse": lambda device, v: device.world.select_pulse(v["source"].name.lower()),
    "reference_point": _world("offset", lambda v: tuple(v["offset"])),
    "relative_position": _relative_position,
    "sensor_range": _sensor_range,
    "soft_iron": _world("soft_iron", lambda v: tuple(v["matrix"])),
}
