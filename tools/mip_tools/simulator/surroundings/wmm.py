"""Computes the Earth's magnetic field from the published coefficients of the World Magnetic Model."""

from __future__ import annotations

import csv
from functools import cache, lru_cache
from math import cos, degrees, hypot, radians, sin, sqrt
from pathlib import Path

from ...geometry.earth import SECOND, Vector, ecef, gps_to_utc

_RADIUS = 6371200.0
_DEGREE = 12
_DAY = 86400 * SECOND

#: Degree and order -> g, h in nT, and their changes per year.
Coefficients = dict[tuple[int, int], tuple[float, float, float, float]]


@cache
def models() -> dict[int, Coefficients]:
    """Reads the models, by the year in which each begins."""
    by_epoch: dict[int, Coefficients] = {}
    with Path(__file__).with_name("wmm.csv").open(encoding="utf-8") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            for epoch in (name[1:] for name in row if name.startswith("g")):
                g, h, dg, dh = (float(row[x + epoch]) for x in ("g", "h", "dg", "dh"))
                by_epoch.setdefault(int(epoch), {})[int(row["n"]), int(row["m"])] = g, h, dg, dh
    return by_epoch


def field_in_year(year: float, latitude: float, longitude: float, height: float) -> Vector:
    """Returns the field in gauss (north, east, down) at a geodetic position in radians and metres.

    The model for this year is used. Before the first model, and from five years after the last one began, the field is
    constant.
    """
    by_epoch = models()
    epoch = max((x for x in by_epoch if x <= year), default=min(by_epoch))
    years = min(max(year - epoch, 0.0), 5.0)
    # Geocentric position: distance, sine and cosine of the latitude.
    x, y, z = ecef(latitude, longitude, height)
    out = hypot(x, y)
    r = hypot(out, z)
    s, c = z / r, max(out / r, 1e-10)
    # Associated Legendre functions (Schmidt), and derivatives with respect to latitude, times powers of the distance.
    north = east = down = 0.0
    sectoral, its_slope = 1.0, 0.0
    for m in range(_DEGREE + 1):
        if m:
            k = 1.0 if m == 1 else sqrt((2 * m - 1) / (2 * m))
            sectoral, its_slope = k * c * sectoral, k * (c * its_slope - s * sectoral)
        cm, sm = cos(m * longitude), sin(m * longitude)
        before, slope_before, p, slope = 0.0, 0.0, sectoral, its_slope
        for n in range(max(m, 1), _DEGREE + 1):
            if n > m:
                a, b, d = 2 * n - 1, sqrt((n - 1) ** 2 - m * m) if n - 1 > m else 0.0, sqrt(n * n - m * m)
                before, slope_before, p, slope = (
                    p,
                    slope,
                    (a * s * p - b * before) / d,
                    (a * (s * slope + c * p) - b * slope_before) / d,
                )
            g0, h0, dg, dh = by_epoch[epoch][n, m]
            g, h = g0 + years * dg, h0 + years * dh
            scale = (_RADIUS / r) ** (n + 2)
            along = g * cm + h * sm
            north -= scale * slope * along
            east += scale * m * p * (g * sm - h * cm) / c
            down -= scale * (n + 1) * p * along
    # From the geocentric to the geodetic vertical.
    turn_s, turn_c = sin(latitude) * c - cos(latitude) * s, cos(latitude) * c + sin(latitude) * s
    return (
        (north * turn_c + down * turn_s) * 1e-5,
        east * 1e-5,
        (down * turn_c - north * turn_s) * 1e-5,
    )


@lru_cache(256)
def _cell(day: int, latitude: int, longitude: int, height: int) -> Vector:
    date = gps_to_utc(day * _DAY)
    year = date.year + (date.timetuple().tm_yday - 1) / 365.25
    return field_in_year(year, radians(latitude / 1000), radians(longitude / 1000), height * 100.0)


def magnetic_field(gps: int, latitude: float, longitude: float, height: float) -> Vector:
    """Returns the field in gauss (north, east, down) at a time in nanoseconds since the GPS epoch.

    The inputs are rounded to a day, a thousandth of a degree, and 100 m: each step changes the field by less than 1 nT.
    """
    return _cell(gps // _DAY, round(degrees(latitude) * 1000), round(degrees(longitude) * 1000), round(height / 100))
