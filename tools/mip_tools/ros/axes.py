"""Converts the axes of MIP (NED; forward, right, down) to those of REP 103 (ENU; forward, left, up)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np

from ..columns.scan import Array

#: Each element is a number, or an array of numbers for many vectors at once.
Vector = tuple[Any, Any, Any]
Numbers: TypeAlias = "Sequence[Any] | Array"
#: w, x, y, z.
Quaternion = tuple[Any, Any, Any, Any]

NOT_ROTATED: Quaternion = (1.0, 0.0, 0.0, 0.0)


def body(v: Numbers) -> Vector:
    """Converts forward, right, down to forward, left, up: y and z change their signs."""
    x, y, z = v
    return x, -y, -z


def world(v: Numbers) -> Vector:
    """Converts north, east, down to east, north, up."""
    north, east, down = v
    return east, north, -down


def attitude(q: Numbers) -> Quaternion:
    """Converts an attitude in NED, as a device sends it, to the rotation from the body of REP 103 to ENU."""
    w, x, y, z = q
    length = np.sqrt(2 * (w * w + x * x + y * y + z * z))
    length = np.where(length == 0, 1.0, length)
    return (w + z) / length, (x + y) / length, (x - y) / length, (w - z) / length


def rotation_matrix(q: Quaternion) -> list[list[Any]]:
    """Returns the rotation matrix of a unit quaternion."""
    w, x, y, z = q
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]


def into_body(q: Quaternion, v: Numbers) -> Vector:
    """Rotates a vector from the world to the axes of a body with this attitude."""
    m = rotation_matrix(q)
    x, y, z = (sum(m[k][i] * v[k] for k in range(3)) for i in range(3))
    return x, y, z


def variances_into_body(q: Quaternion, variances: Numbers) -> list[Any]:
    """Converts variances along the axes of the world to the covariance (3 x 3, row by row) in the body."""
    m = rotation_matrix(q)
    return [sum(m[k][i] * variances[k] * m[k][j] for k in range(3)) for i in range(3) for j in range(3)]
