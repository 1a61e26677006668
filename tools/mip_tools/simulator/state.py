"""Position, velocity and attitude of a moving body."""

from __future__ import annotations

from math import acos, atan2, cos, hypot, sin, sqrt
from typing import NamedTuple, Protocol

from .earth import E2, A, Matrix, Vector, radii

Quaternion = tuple[float, float, float, float]


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


def rotation(roll: float, pitch: float, yaw: float) -> tuple[Quaternion, Matrix]:
    """Converts Euler angles, applied in the order yaw, pitch, roll, to a quaternion and a matrix."""
    q = multiplied(
        multiplied((cos(yaw / 2), 0.0, 0.0, sin(yaw / 2)), (cos(pitch / 2), 0.0, sin(pitch / 2), 0.0)),
        (cos(roll / 2), sin(roll / 2), 0.0, 0.0),
    )
    return q if q[0] >= 0 else (-q[0], -q[1], -q[2], -q[3]), matrix(q)


def multiplied(a: Quaternion, b: Quaternion) -> Quaternion:
    p, q, r, s = a
    w, x, y, z = b
    return (
        p * w - q * x - r * y - s * z,
        p * x + q * w + r * z - s * y,
        p * y - q * z + r * w + s * x,
        p * z + q * y - r * x + s * w,
    )


def conjugate(q: Quaternion) -> Quaternion:
    return q[0], -q[1], -q[2], -q[3]


def matrix(q: Quaternion) -> Matrix:
    """Returns the matrix with `m * v = q^-1 * v * q`."""
    w, x, y, z = q
    return (
        1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y),
        2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x),
        2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y),
    )  # fmt: skip


def quaternion(m: Matrix) -> Quaternion:
    """Inverts `matrix`: returns the quaternion with a scalar part that is not negative."""
    squares = (
        1 + m[0] + m[4] + m[8], 1 + m[0] - m[4] - m[8], 1 - m[0] + m[4] - m[8], 1 - m[0] - m[4] + m[8],
    )  # fmt: skip
    most = max(range(4), key=lambda i: squares[i])
    k = sqrt(squares[most]) * 2
    a, b, c = m[5] - m[7], m[6] - m[2], m[1] - m[3]
    d, e, f = m[1] + m[3], m[2] + m[6], m[5] + m[7]
    q = (
        (k / 4, a / k, b / k, c / k),
        (a / k, k / 4, d / k, e / k),
        (b / k, d / k, k / 4, f / k),
        (c / k, e / k, f / k, k / 4),
    )[most]
    return q if q[0] >= 0 else (-q[0], -q[1], -q[2], -q[3])


def euler(m: Matrix) -> Vector:
    """Returns roll, pitch, yaw."""
    return atan2(m[5], m[8]), atan2(-m[2], hypot(m[0], m[1])), atan2(m[1], m[0])


def rotation_vector(a: Quaternion, b: Quaternion) -> Vector:
    """Returns the rotation of the body from one attitude to another: the integral of its rate."""
    w, x, y, z = multiplied(conjugate(a), b)
    if w < 0:
        w, x, y, z = -w, -x, -y, -z
    length = sqrt(x * x + y * y + z * z)
    k = 2 * atan2(length, w) / length if length > 1e-12 else 2.0
    return k * x, k * y, k * z


def between(a: Quaternion, b: Quaternion, part: float) -> Quaternion:
    """Interpolates between two attitudes, at a constant rate."""
    dot = sum(x * y for x, y in zip(a, b))
    if dot < 0:
        b, dot = (-b[0], -b[1], -b[2], -b[3]), -dot
    angle = acos(min(dot, 1.0))
    if angle < 1e-6:
        p, q = 1 - part, part
    else:
        p, q = sin((1 - part) * angle) / sin(angle), sin(part * angle) / sin(angle)
    w, x, y, z = (p * i + q * j for i, j in zip(a, b))
    return w, x, y, z


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
