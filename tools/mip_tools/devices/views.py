"""Converts settings that several commands have in different forms: the sensor mounting, the rotation of a frame.

In `spec/simulation`, the effect of a command names the form, and the arguments are its parameters.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ..geometry.earth import Matrix
from ..geometry.rotations import of_euler, of_quaternion, to_euler, to_quaternion, transposed

Values = dict[str, Any]  # argument of the effect -> its value


def _euler(values: Values) -> Matrix:
    return of_euler(values["roll"], values["pitch"], values["yaw"])


def _to_euler(matrix: Matrix) -> Values:
    return dict(zip(("roll", "pitch", "yaw"), to_euler(matrix)))


#: Effect -> the conversion to the matrix from sensor to vehicle, and the conversion back.
ORIENTATIONS: dict[str, tuple[Callable[[Values], Matrix], Callable[[Matrix], Values]]] = {
    "orientation_euler": (_euler, _to_euler),
    # p_vehicle = q^-1 * p_sensor * q: the inverse of the usual product
    "orientation_quaternion": (
        lambda v: transposed(of_quaternion(v["q"])),
        lambda matrix: {"q": to_quaternion(transposed(matrix))},
    ),
    "orientation_dcm": (lambda v: tuple(v["dcm"]), lambda matrix: {"dcm": matrix}),
}

EULER, QUATERNION = 1, 2


def vehicle_matrix(effect: str, values: Values) -> Matrix:
    """Returns the matrix from the sensor to the vehicle. Some devices expect the inverse."""
    made = ORIENTATIONS[effect][0](values)
    return transposed(made) if values.get("inverse") else made


def orientation_values(effect: str, matrix: Matrix, inverse: bool) -> Values:
    return ORIENTATIONS[effect][1](transposed(matrix) if inverse else matrix)


def is_rotation(m: Matrix) -> bool:
    """Are the rows orthogonal unit vectors, within the precision of four-byte floats?"""
    rows = (m[:3], m[3:6], m[6:])
    products = (sum(a * b for a, b in zip(rows[i], rows[j])) - (i == j) for i in range(3) for j in range(i, 3))
    return all(abs(x) < 1e-3 for x in products)


def frame_rotation(value: Any, as_given: int, wanted: int) -> Any:
    """Converts the rotation of a frame to Euler angles or to a quaternion."""
    if value is None or as_given == wanted:
        return value
    matrix = of_euler(*value) if as_given == EULER else of_quaternion(value)
    return to_euler(matrix) if wanted == EULER else to_quaternion(matrix)
