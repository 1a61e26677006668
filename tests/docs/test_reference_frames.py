"""The formulas of the reference for NED, ENU and REP-103, evaluated and compared with rotation matrices."""

from __future__ import annotations

import math
import re

from random_values import chance
from reference import manual_of, words

Vector = tuple[float, ...]
Matrix = tuple[Vector, ...]

#: The axes of the other frame in the frame of MIP, as rows: east, north, up in NED; forward, left, up in the vehicle.
ENU: Matrix = ((0, 1, 0), (1, 0, 0), (0, 0, -1))
FLU: Matrix = ((1, 0, 0), (0, -1, 0), (0, 0, -1))


def product(a: Matrix, b: Matrix) -> Matrix:
    return tuple(tuple(sum(x * y for x, y in zip(row, column, strict=True)) for column in zip(*b)) for row in a)


def turn(axis: int, angle: float) -> Matrix:
    """The right-handed rotation about an axis."""
    i, j = (axis + 1) % 3, (axis + 2) % 3
    rows = [[float(r == c) for c in range(3)] for r in range(3)]
    rows[i][i] = rows[j][j] = math.cos(angle)
    rows[i][j], rows[j][i] = -math.sin(angle), math.sin(angle)
    return tuple(map(tuple, rows))


def attitude(roll: float, pitch: float, yaw: float) -> Matrix:
    """The matrix from vectors of the vehicle to those of the world: yaw, then pitch, then roll."""
    return product(product(turn(2, yaw), turn(1, pitch)), turn(0, roll))


def matrix(w: float, x: float, y: float, z: float) -> Matrix:
    """The matrix of a quaternion, found by turning vectors: v + 2 r × (r × v + w v)."""

    def cross(a: Vector, b: Vector) -> Vector:
        return tuple(a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3] for i in range(3))

    def turned(v: Vector) -> Vector:
        inner = tuple(c + w * e for c, e in zip(cross((x, y, z), v), v, strict=True))
        return tuple(e + 2 * c for e, c in zip(v, cross((x, y, z), inner), strict=True))

    return tuple(zip(*(turned(tuple(float(i == j) for j in range(3))) for i in range(3)), strict=True))


def quaternion(roll: float, pitch: float, yaw: float) -> Vector:
    """The quaternion from half angles, as devices send it."""
    (a, b, c), (d, e, f) = ([g(angle / 2) for angle in (roll, pitch, yaw)] for g in (math.cos, math.sin))
    return a * b * c + d * e * f, d * b * c - a * e * f, a * e * c + d * b * f, a * b * f - d * e * c


def near(a: Matrix, b: Matrix) -> bool:
    return all(math.isclose(x, y, abs_tol=1e-12) for r, s in zip(a, b, strict=True) for x, y in zip(r, s, strict=True))


def evaluated(formula: str, **values: float) -> float:
    """A formula of the page: names, signs, the four operations and pi."""
    assert re.fullmatch(r"[-+*/(). \w]+", formula)
    return float(eval(formula, {"__builtins__": {}}, {"pi": math.pi, "sqrt": math.sqrt, **values}))


def test_formulas_of_the_pages() -> None:
    chances = chance("frames")
    pages = [words(manual_of("real").page(page)) for page in ("guides/axes_and_signs.md", "units.md")]
    quaternions = [re.search(r"becomes \(([^()]*)\) / sqrt\(2\)", page) for page in pages]
    yaws = [re.search(r"yaw becomes (pi/2 - yaw)", page) for page in pages]
    elements = re.search(r"\| ned \|.*?\| (y, x, -z) \|", pages[1])
    body = re.search(r"\| vehicle \|.*?\| (x, -y, -z) \|", pages[1])
    assert all(quaternions) and all(yaws) and elements and body
    assert "east = NED y, north = NED x, up = -NED z" in pages[0] and "x is unchanged, y and z change sign" in pages[0]
    for _ in range(50):
        roll, yaw = (chances.uniform(-math.pi, math.pi) for _ in range(2))
        pitch = chances.uniform(-math.pi / 2, math.pi / 2)
        ned = attitude(roll, pitch, yaw)
        w, x, y, z = quaternion(roll, pitch, yaw)
        assert near(matrix(w, x, y, z), ned)
        wanted = product(product(ENU, ned), tuple(zip(*FLU, strict=True)))
        for found in quaternions:
            assert found
            made = [evaluated(part, w=w, x=x, y=y, z=z) / math.sqrt(2) for part in found[1].split(",")]
            assert math.isclose(sum(q * q for q in made), 1) and near(matrix(*made), wanted)
        for found in yaws:
            assert found
            assert near(attitude(roll, -pitch, evaluated(found[1], yaw=yaw)), wanted)
        vector = tuple(chances.uniform(-9, 9) for _ in range(3))
        for found, axes in ((elements, ENU), (body, FLU)):
            made = [evaluated(part, **dict(zip("xyz", vector, strict=True))) for part in found[1].split(",")]
            assert near((tuple(made),), tuple(zip(*product(axes, tuple((v,) for v in vector)), strict=True)))
