"""Rotations in the forms that commands give them, as matrices in row-major order."""

from __future__ import annotations

import math
from collections.abc import Sequence

Matrix = tuple[float, ...]

IDENTITY: Matrix = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)


def transposed(m: Matrix) -> Matrix:
    return (m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8])


def of_euler(roll: float, pitch: float, yaw: float) -> Matrix:
    """`Rz(yaw) * Ry(pitch) * Rx(roll)`."""
    sr, cr, sp, cp = math.sin(roll), math.cos(roll), math.sin(pitch), math.cos(pitch)
    sy, cy = math.sin(yaw), math.cos(yaw)
    return (
        cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr,
        sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr,
        -sp, cp * sr, cp * cr,
    )  # fmt: skip


def to_euler(m: Matrix) -> tuple[float, float, float]:
    """Roll, pitch and yaw; the yaw is 0 where it cannot be told from the roll."""
    pitch = math.asin(max(-1.0, min(1.0, -m[6])))
    if abs(m[6]) > 1 - 1e-12:
        return math.atan2(-m[5], m[4]), pitch, 0.0
    return math.atan2(m[7], m[8]), pitch, math.atan2(m[3], m[0])


def of_quaternion(q: Sequence[float]) -> Matrix:
    """`v' = q * v * q^-1`; the length of the quaternion does not matter."""
    n = math.hypot(*q) or 1.0
    w, x, y, z = (c / n for c in q)
    return (
        1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
        2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
        2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y),
    )  # fmt: skip


def to_quaternion(m: Matrix) -> tuple[float, float, float, float]:
    """The quaternion with a scalar part that is not negative."""
    squares = (
        1 + m[0] + m[4] + m[8],
        1 + m[0] - m[4] - m[8],
        1 - m[0] + m[4] - m[8],
        1 - m[0] - m[4] + m[8],
    )
    largest = max(range(4), key=lambda i: squares[i])
    s = 2 * math.sqrt(max(squares[largest], 0.0))
    products = (
        (s * s / 4, m[7] - m[5], m[2] - m[6], m[3] - m[1]),
        (m[7] - m[5], s * s / 4, m[1] + m[3], m[2] + m[6]),
        (m[2] - m[6], m[1] + m[3], s * s / 4, m[5] + m[7]),
        (m[3] - m[1], m[2] + m[6], m[5] + m[7], s * s / 4),
    )[largest]
    w, x, y, z = (c / s for c in products)
    return (w, x, y, z) if w >= 0 else (-w, -x, -y, -z)


__all__ = [
    "IDENTITY",
    "Matrix",
    "of_euler",
    "of_quaternion",
    "to_euler",
    "to_quaternion",
    "transposed",
]
