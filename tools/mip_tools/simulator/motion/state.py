"""Position, velocity and attitude of a moving body."""

from __future__ import annotations

from math import cos, sin, sqrt
from typing import NamedTuple, Protocol

from ...geometry.attitude import Quaternion
from ...geometry.earth import E2, A, Matrix, Vector, radii


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


class Motion(Protocol):
    """A motion as a function of time. It may define the GPS time at which it begins (`start`, in ns)."""

    def at(self, t: float) -> State:
        """Returns the state at a time in seconds since the start of the simulation."""
        ...


class Plane:
    """The surroundings of a position, as a plane in metres north and east whose grid follows the meridians."""

    __slots__ = ("across", "along", "height", "latitude", "longitude")

    def __init__(self, latitude: float, longitude: float, height: float) -> None:
        self.latitude, self.longitude, self.height = latitude, longitude, height
        m, n = radii(latitude)
        self.along = m + height
        self.across = (n + height) * cos(latitude)

    def state(
        self, north: float, east: float, up: float, direction: tuple[float, float], speed: float,
        acceleration: float = 0.0, curvature: float = 0.0, grade: float = 0.0, bend: float = 0.0,
    ) -> State:  # fmt: skip
        """Returns the state of a vehicle that points in the direction of its motion.

        `direction` is a unit vector. Speed and acceleration are relative to the plane. `grade` is the climb per metre,
        `bend` the change of the grade per metre.
        """
        latitude = self.latitude + north / self.along
        longitude = self.longitude + east / self.across
        height = self.height + up
        s, c = sin(latitude), cos(latitude)
        w = 1 - E2 * s * s
        n = A / sqrt(w)
        # The plane is stretched because the meridians converge; velocities are those on the Earth.
        kn = (n * (1 - E2) / w + height) / self.along
        ke = (n + height) * c / self.across
        dn, de = direction
        tn, te = dn * kn, de * ke
        k2 = tn * tn + te * te
        k = sqrt(k2)
        turn = curvature * speed
        sideways = turn * speed
        climb, g2 = grade * speed, grade / k
        narrows = -s / c * speed * dn / self.along  # relative rate of ke; that of kn is negligible
        pitch_rate = bend * speed / k / (1 + g2 * g2)
        cp = 1 / sqrt(1 + g2 * g2)
        sp = g2 * cp
        cy, sy = tn / k, te / k
        yaw_rate = turn * kn * ke / k2 + cy * sy * narrows
        # Halves of the angles, without their functions: pitch is less than a right angle.
        hp = sqrt((1 + cp) / 2)
        hq = sp / (2 * hp)
        if cy > -0.5:
            hy = sqrt((1 + cy) / 2)
            hz = sy / (2 * hy)
        else:
            hz = sqrt((1 - cy) / 2)
            hy = sy / (2 * hz)
            if hy < 0:
                hy, hz = -hy, -hz
        return State(
            latitude, longitude, height,
            (speed * tn, speed * te, -climb),
            (
                (acceleration * dn - sideways * de) * kn,
                (acceleration * de + sideways * dn + speed * de * narrows) * ke,
                -grade * acceleration - bend * speed * speed,
            ),
            (hy * hp, -hz * hq, hy * hq, hz * hp),
            (cp * cy, cp * sy, -sp, -sy, cy, 0.0, sp * cy, sp * sy, cp),
            (-yaw_rate * sp, pitch_rate, yaw_rate * cp),
        )  # fmt: skip
