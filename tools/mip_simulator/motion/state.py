"""Position, velocity and attitude of a moving body."""

from __future__ import annotations

from math import cos, radians, sin
from typing import NamedTuple, Protocol

from mip_tools.geometry.attitude import Quaternion, euler_rotation
from mip_tools.geometry.earth import E2, Matrix, Vector, radii

#: The default position: degrees and metres.
LATITUDE, LONGITUDE, HEIGHT = 47.0, 8.0, 500.0


class MotionError(ValueError):
    """An impossible motion, or a text or a file that does not describe one."""


def is_place(latitude: float, longitude: float, height: float) -> bool:
    """Can the device be at this position (degrees, metres)? The poles, and extreme heights, are not supported."""
    return abs(latitude) <= 89 and abs(longitude) <= 360 and -1e4 <= height <= 1e6


PLACES = "use degrees, with a latitude of -89 to 89, and a height of -10 to 1000 km"


def check_place(motion: str, latitude: float, longitude: float, height: float) -> None:
    """Raises MotionError if a motion cannot be at this place."""
    if not is_place(latitude, longitude, height):
        raise MotionError(
            f"{motion}: latitude {latitude:g}, longitude {longitude:g}, height {height:g} is not a place; {PLACES}"
        )


class State(NamedTuple):
    """All values agree with each other. The body's axes point forward, right and down."""

    latitude: float  # rad
    longitude: float  # rad
    height: float  # m above the ellipsoid
    velocity: Vector  # north, east, down, m/s
    acceleration: Vector  # rate of the velocity, m/s^2
    quaternion: Quaternion  # v_body = q^-1 * v_ned * q
    dcm: Matrix  # v_body = dcm * v_ned
    rate: Vector  # of the body relative to north, east, down, in the axes of the body, rad/s


#: At rest at the default position, level, to the north.
REST = State(
    radians(LATITUDE), radians(LONGITUDE), HEIGHT, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0),
    (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0), (0.0, 0.0, 0.0),
)  # fmt: skip


class Motion(Protocol):
    """A motion as a function of time. It may define the GPS time at which it begins (`start`, in ns)."""

    def at(self, t: float) -> State:
        """Returns the state at a time in seconds since the start of the simulation."""
        ...


#: A quantity with its first and second derivatives.
Moving = tuple[float, float, float]


def state(latitude: Moving, longitude: Moving, height: Moving, roll: Moving, pitch: Moving, yaw: Moving) -> State:
    """Computes the state of a body from its position and its angles (rad, m), which change over time."""
    (place, dn, ddn), (meridian, de, dde), (above, up, faster) = latitude, longitude, height
    s, c = sin(place), cos(place)
    along, across = radii(place)
    w = 1 - E2 * s * s
    m, n = along + above, (across + above) * c
    dm = 3 * along * E2 * s * c / w * dn + up
    dr = (across * E2 * s * c / w * dn + up) * c - (across + above) * s * dn
    (a, p, _), (b, q, _), (y, r, _) = roll, pitch, yaw
    sr, cr, sp, cp = sin(a), cos(a), sin(b), cos(b)
    return State(
        place, meridian, above,
        (m * dn, n * de, -up),
        (m * ddn + dm * dn, n * dde + dr * de, -faster),
        *euler_rotation(a, b, y),
        (p - r * sp, q * cr + r * cp * sr, r * cp * cr - q * sr),
    )  # fmt: skip
