"""Rotations in the forms that commands use, as matrices of `v' = m * v`."""

from __future__ import annotations

import math
from collections.abc import Sequence

from .attitude import Quaternion, attitude_matrix, euler, euler_rotation, quaternion
from .earth import Matrix, Vector


def transposed(m: Matrix) -> Matrix:
    return m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]


def of_euler(roll: float, pitch: float, yaw: float) -> Matrix:
    """Computes `Rz(yaw) * Ry(pitch) * Rx(roll)`."""
    return transposed(euler_rotation(roll, pitch, yaw)[1])


def to_euler(m: Matrix) -> Vector:
    """Returns roll, pitch and yaw; the yaw is 0 if it cannot be distinguished from the roll."""
    roll, pitch, yaw = euler(transposed(m))
    if abs(m[6]) > 1 - 1e-12:
        return math.atan2(-m[5], m[4]), pitch, 0.0
    return roll, pitch, yaw


def of_quaternion(q: Sequence[float]) -> Matrix:
    """Returns the matrix of `v' = q * v * q^-1`; the length of the quaternion does not matter."""
    n = math.hypot(*q) or 1.0
    w, x, y, z = (c / n for c in q)
    return transposed(attitude_matrix((w, x, y, z)))


def to_quaternion(m: Matrix) -> Quaternion:
    """Returns the quaternion whose scalar part is not negative."""
    return quaternion(transposed(m))
