"""Rotations from first principles, to compare those of others with: matrices of nine numbers, row by row."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, sin

Numbers = Sequence[float]


def times(m: Numbers, v: Numbers) -> tuple[float, ...]:
    return tuple(sum(m[3 * i + j] * v[j] for j in range(3)) for i in range(3))


def transposed(m: Numbers) -> tuple[float, ...]:
    return tuple(m[3 * j + i] for i in range(3) for j in range(3))


def product(a: Numbers, b: Numbers) -> tuple[float, ...]:
    return tuple(sum(a[3 * i + k] * b[3 * k + j] for k in range(3)) for i in range(3) for j in range(3))


def of_euler(roll: float, pitch: float, yaw: float) -> tuple[float, ...]:
    """The matrix from NED to the vehicle, as rotations about one axis after the other."""
    cr, sr, cp, sp, cy, sy = cos(roll), sin(roll), cos(pitch), sin(pitch), cos(yaw), sin(yaw)
    about_x = (1, 0, 0, 0, cr, sr, 0, -sr, cr)
    about_y = (cp, 0, -sp, 0, 1, 0, sp, 0, cp)
    about_z = (cy, sy, 0, -sy, cy, 0, 0, 0, 1)
    return product(about_x, product(about_y, about_z))


def of_quaternion(q: Numbers) -> tuple[float, ...]:
    """The matrix of v -> q^-1 * v * q, a unit vector at a time."""
    inverse = (q[0], -q[1], -q[2], -q[3])
    columns = [hamilton(hamilton(inverse, (0, *v)), q)[1:] for v in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    return tuple(columns[j][i] for i in range(3) for j in range(3))


def hamilton(a: Numbers, b: Numbers) -> tuple[float, ...]:
    (p, x, y, z), (r, i, j, k) = a, b
    return (
        p * r - x * i - y * j - z * k, p * i + x * r + y * k - z * j,
        p * j - x * k + y * r + z * i, p * k + x * j - y * i + z * r,
    )  # fmt: skip
