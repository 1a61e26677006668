"""Fits an ellipsoid or a sphere to measurements of a constant field: hard and soft iron of a magnetometer."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from ..columns.distinct import distinct

#: Latitudes and longitudes into which the directions are divided, in cells of equal area.
_BANDS, _SECTORS = 10, 20
#: Measurements closer together than this share of the field count once, so that a pause does not decide the fit.
_GRAIN = 0.03
#: How far measurements are apart at least, as a share of the largest one.
_ALIKE = 0.1
#: The elements of a symmetric matrix: row and column of each.
_ROWS, _COLUMNS = np.triu_indices(3)
_DIAGONAL = _ROWS == _COLUMNS


class Fit(NamedTuple):
    """`matrix @ (measured - offset)` has the length `field` in all directions."""

    offset: Any
    matrix: Any
    field: float
    before: float
    """The standard deviation of the measured field strength."""
    after: float
    """That of the corrected one."""


def sphere_centre(points: Any) -> Any:
    """Returns the centre of the sphere through the points. Raises ValueError if they do not determine one."""
    mean = points.mean(axis=0)
    centred = points - mean
    design = np.column_stack([2 * centred, np.ones(len(points))])
    solution, _, rank, _ = np.linalg.lstsq(design, (centred**2).sum(axis=1), rcond=1e-6)
    if rank < 4 or np.linalg.norm(centred, axis=1).max() < _ALIKE * np.linalg.norm(points, axis=1).max():
        raise ValueError("the measurements are all alike: turn the device about all axes")
    return mean + solution[:3]


def coverage(points: Any, centre: Any) -> float:
    """Computes the share of all directions, seen from the centre, in which there are points."""
    directions = points - centre
    x, y, z = directions.T / np.maximum(np.linalg.norm(directions, axis=1), 1e-12)
    band = np.minimum((z + 1) / 2 * _BANDS, _BANDS - 1).astype(int)
    sector = ((np.arctan2(y, x) / (2 * np.pi) + 0.5) * _SECTORS).astype(int) % _SECTORS
    return len(distinct(band * _SECTORS + sector)) / (_BANDS * _SECTORS)


def fitted(points: Any, soft: bool = True, field: float | None = None) -> Fit:
    """Fits an ellipsoid, or a sphere without `soft`. `field`: the true strength; None: the measured one is kept.

    Raises ValueError if the points do not determine one.
    """
    centre = sphere_centre(points)
    radius = float(np.linalg.norm(points - centre, axis=1).mean())
    cells = np.floor(points / (_GRAIN * radius))
    thinned = (points[np.unique(cells, axis=0, return_index=True)[1]] - centre) / radius
    values = _refined(thinned, np.concatenate([_DIAGONAL, np.zeros(3)]), soft)
    offset, matrix = centre + radius * values[6:], _symmetric(values)
    sizes = np.linalg.eigvalsh(matrix)
    if sizes[0] <= 0.2 or sizes[-1] > 5 or np.linalg.norm(values[6:]) > 1:
        raise ValueError("no ellipsoid fits the measurements; did the field change meanwhile?")
    if field is None:
        field = float(np.linalg.norm(points - offset, axis=1).mean())
    matrix *= field / radius
    before, after = (float(np.linalg.norm(each, axis=1).std()) for each in (points, (points - offset) @ matrix))
    return Fit(offset, matrix, field, before, after)


def _refined(points: Any, values: Any, soft: bool) -> Any:
    """Minimizes the differences of the corrected field from 1, by the method of Levenberg and Marquardt."""
    free = np.eye(9) if soft else np.column_stack([np.append(_DIAGONAL, np.zeros(3)), np.eye(9)[:, 6:]])
    rest, slopes = _differences(points, values, free)
    damping = 1e-3
    for _ in range(100):
        normal = slopes.T @ slopes
        step = free @ np.linalg.solve(normal + damping * np.diag(normal.diagonal()), -slopes.T @ rest)
        new_rest, new_slopes = _differences(points, values + step, free)
        if new_rest @ new_rest > rest @ rest:
            damping *= 10
            continue
        values, rest, slopes, damping = values + step, new_rest, new_slopes, damping / 10
        if np.abs(step).max() < 1e-8:
            break
    return values


def _symmetric(values: Any) -> Any:
    matrix = np.zeros((3, 3))
    matrix[_ROWS, _COLUMNS] = matrix[_COLUMNS, _ROWS] = values[:6]
    return matrix


def _differences(points: Any, values: Any, free: Any) -> tuple[Any, Any]:
    """Returns the differences of the corrected field from 1, and their derivatives."""
    matrix, from_centre = _symmetric(values), points - values[6:]
    corrected = from_centre @ matrix
    length = np.linalg.norm(corrected, axis=1)
    direction = corrected / length[:, None]
    by_matrix = direction[:, _ROWS] * from_centre[:, _COLUMNS]
    by_matrix += np.where(_DIAGONAL, 0, direction[:, _COLUMNS] * from_centre[:, _ROWS])
    return length - 1, np.hstack([by_matrix, -direction @ matrix]) @ free
