"""Motions of the simulated device, and how they are written."""

from __future__ import annotations

from collections.abc import Callable
from math import atan2, cos, fmod, inf, isfinite, pi, radians, sin
from pathlib import Path
from typing import Any

from mip_tools.geometry.attitude import euler_rotation
from mip_tools.geometry.earth import radii

from .replay import Replay
from .state import HEIGHT, LATITUDE, LONGITUDE, Motion, MotionError, State, check_place, state
from .trajectory import Trajectory


class Standing:
    """Stays at rest. Angles are in degrees."""

    def __init__(
        self, latitude: float = LATITUDE, longitude: float = LONGITUDE, height: float = HEIGHT, *,
        heading: float = 0.0, pitch: float = 0.0, roll: float = 0.0,
    ) -> None:  # fmt: skip
        check_place("standing", latitude, longitude, height)
        q, m = euler_rotation(radians(roll), radians(pitch), radians(heading))
        zero = (0.0, 0.0, 0.0)
        self._state = State(radians(latitude), radians(longitude), height, zero, zero, q, m, zero)

    def at(self, t: float) -> State:
        return self._state


class Circle:
    """Moves clockwise at a constant speed (m/s), from the northernmost point of a circle of `radius` metres."""

    def __init__(
        self, radius: float = 20.0, speed: float = 5.0, latitude: float = LATITUDE, longitude: float = LONGITUDE,
        height: float = HEIGHT,
    ) -> None:  # fmt: skip
        for name, value in (("radius", radius), ("speed", speed)):
            if not 0 < value <= 1e6:
                raise MotionError(f"circle: {name}={value:g} must be above 0, and at most 1e6")
        check_place("circle", latitude, longitude, height)
        self._radius, self._speed = radius, speed
        self._latitude, self._longitude, self._height = radians(latitude), radians(longitude), height
        along, across = radii(self._latitude)
        self._along, self._across = along + height, (across + height) * cos(self._latitude)

    def at(self, t: float) -> State:
        w, r = self._speed / self._radius, self._radius
        angle = fmod(t, 2 * pi / w) * w
        north, east = r * cos(angle), r * sin(angle)
        latitude = (self._latitude + north / self._along, -w * east / self._along, -w * w * north / self._along)
        longitude = (self._longitude + east / self._across, w * north / self._across, -w * w * east / self._across)
        still = (0.0, 0.0, 0.0)
        level = state(latitude, longitude, (self._height, 0.0, 0.0), still, still, still)
        (u, v, _), (a, b, _) = level.velocity, level.acceleration
        q, m = euler_rotation(0.0, 0.0, atan2(v, u))
        return level._replace(quaternion=q, dcm=m, rate=(0.0, 0.0, (u * b - v * a) / (u * u + v * v)))


def _yes(text: str) -> bool:
    answers = {"yes": True, "no": False}
    if text not in answers:
        raise ValueError(f"'{text}' is neither yes nor no")
    return answers[text]


def _number(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = inf
    if not isfinite(value):
        raise ValueError(f"'{text}' is not a number")
    return value


_PLACE: dict[str, Callable[[str], Any]] = {"latitude": _number, "longitude": _number, "height": _number}

#: Name of a motion -> its class, and its options with the functions that parse them.
MOTIONS: dict[str, tuple[Callable[..., Motion], dict[str, Callable[[str], Any]]]] = {
    "standing": (Standing, _PLACE | {"heading": _number, "pitch": _number, "roll": _number}),
    "circle": (Circle, {"radius": _number, "speed": _number} | _PLACE),
    "trajectory": (Trajectory, _PLACE | {"file": str, "loop": _yes}),
    "replay": (Replay, {"file": str, "loop": _yes, "rate": _number}),
}  # fmt: skip
_REQUIRED = dict.fromkeys(("trajectory", "replay"), "file")


def parse_motion(text: str, folder: Path = Path()) -> Motion:
    """Parses a motion: a name, optionally followed by options. Its file is relative to `folder`. Raises MotionError.

    >>> round(parse_motion("circle:radius=20,speed=5").at(0).velocity[1], 3)
    5.0
    """
    name, _, rest = text.partition(":")
    if name not in MOTIONS:
        raise MotionError(f"'{name}' is not a motion; use one of {', '.join(MOTIONS)}")
    motion, options = MOTIONS[name]
    values: dict[str, Any] = {}
    for part in rest.split(",") if rest else ():
        key, equals, value = part.partition("=")
        if key not in options:
            raise MotionError(f"{name}: unknown option '{key}'; it has {', '.join(options)}")
        if not equals:
            raise MotionError(f"{name}: option '{key}' has no value; write {key}=...")
        if key in values:
            raise MotionError(f"{name}: option '{key}' is given twice")
        try:
            values[key] = options[key](value)
        except ValueError as error:
            raise MotionError(f"{name}: {key}: {error}") from None
    required = _REQUIRED.get(name)
    if required is None:
        return motion(**values)
    if not values.get(required):
        raise MotionError(f"{name}: needs a {required}; write {name}:{required}=PATH")
    return motion(folder / values.pop(required), **values)


__all__ = ["MOTIONS", "Circle", "Motion", "MotionError", "Replay", "Standing", "State", "Trajectory", "parse_motion"]
