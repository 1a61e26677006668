"""Attitudes as quaternions, matrices and Euler angles: rotations from north, east, down to the axes of a body."""

from __future__ import annotations

from math import acos, atan2, cos, hypot, sin, sqrt

from .earth import Matrix, Vector

Quaternion = tuple[float, float, float, float]


def euler_rotation(roll: float, pitch: float, yaw: float) -> tuple[Quaternion, Matrix]:
    """Converts Euler angles, applied in the order yaw, pitch, roll, to a quaternion and a matrix."""
    q = multiplied(
        multiplied((cos(yaw / 2), 0.0, 0.0, sin(yaw / 2)), (cos(pitch / 2), 0.0, sin(pitch / 2), 0.0)),
        (cos(roll / 2), sin(roll / 2), 0.0, 0.0),
    )
    return q if q[0] >= 0 else (-q[0], -q[1], -q[2], -q[3]), attitude_matrix(q)


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


def attitude_matrix(q: Quaternion) -> Matrix:
    """Returns the matrix with `m * v = q^-1 * v * q`."""
    w, x, y, z = q
    return (
        1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y),
        2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x),
        2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y),
    )  # fmt: skip


def quaternion(m: Matrix) -> Quaternion:
    """Inverts `attitude_matrix`: returns the quaternion with a scalar part that is not negative."""
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
