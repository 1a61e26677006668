"""The Earth of the simulation: WGS84, its gravity, the standard atmosphere, and time.

This Earth does not rotate: a gyroscope at rest measures no rate, and there is no Coriolis acceleration.
"""

from __future__ import annotations

from bisect import bisect_right
from datetime import datetime, timedelta
from math import atan2, cos, exp, hypot, radians, sin, sqrt

from ..binding import LEAP_SECONDS

Vector = tuple[float, float, float]
Matrix = tuple[float, float, float, float, float, float, float, float, float]

A = 6378137.0
F = 1 / 298.257223563
E2 = F * (2 - F)
LIGHT = 299792458.0

SECOND = 1_000_000_000
WEEK = 604_800 * SECOND
LAST_WEEK = 0xFFFF  # the last GPS week that data can represent, in the year 3236
_EPOCH = datetime(1980, 1, 6)
_LEAPS = [datetime.fromisoformat(day) for day, _ in LEAP_SECONDS]
#: GPS times in nanoseconds at which UTC falls 1, 2, 3 … seconds behind.
_LEAP_TIMES = [(round((day - _EPOCH).total_seconds()) + count) * SECOND for count, day in enumerate(_LEAPS)]


def leap_seconds(gps: int) -> int:
    """Returns GPS time minus UTC, in seconds, at a time in nanoseconds since the GPS epoch."""
    return bisect_right(_LEAP_TIMES, gps)


def gps_to_utc(gps: int) -> datetime:
    """Converts GPS time to UTC, without a time zone; truncates to microseconds. A leap second repeats 23:59:59."""
    return _EPOCH + timedelta(microseconds=gps // 1000, seconds=-leap_seconds(gps))


def from_utc(time: datetime) -> int:
    """Converts a UTC time without a time zone to nanoseconds since the GPS epoch."""
    behind = bisect_right(_LEAPS, time)
    return (time - _EPOCH) // timedelta(microseconds=1) * 1000 + behind * SECOND


def radii(latitude: float) -> tuple[float, float]:
    """Returns the radii of curvature: along the meridian, and across it."""
    s = sin(latitude)
    w = 1 - E2 * s * s
    across = A / sqrt(w)
    return across * (1 - E2) / w, across


def ecef(latitude: float, longitude: float, height: float) -> Vector:
    """Converts a position in radians and metres to Earth-fixed coordinates."""
    s, c = sin(latitude), cos(latitude)
    n = A / sqrt(1 - E2 * s * s)
    r = (n + height) * c
    return r * cos(longitude), r * sin(longitude), (n * (1 - E2) + height) * s


def llh(x: float, y: float, z: float) -> Vector:
    """Converts Earth-fixed coordinates to latitude, longitude, height, within a micrometre near the surface."""
    p = hypot(x, y)
    latitude = atan2(z, p * (1 - E2))
    for _ in range(6):
        s = sin(latitude)
        n = A / sqrt(1 - E2 * s * s)
        latitude = atan2(z + E2 * n * s, p)
    s, c = sin(latitude), cos(latitude)
    n = A / sqrt(1 - E2 * s * s)
    height = p * c + z * s - n * (1 - E2 * s * s)
    return latitude, atan2(y, x), height


def from_ned(latitude: float, longitude: float, v: Vector) -> Vector:
    """Rotates a vector from the local level frame to Earth-fixed axes."""
    s, c, sl, cl = sin(latitude), cos(latitude), sin(longitude), cos(longitude)
    n, e, d = v
    across = -s * n - c * d
    return cl * across - sl * e, sl * across + cl * e, c * n - s * d


def to_ned(latitude: float, longitude: float, v: Vector) -> Vector:
    """Rotates a vector from Earth-fixed axes to the local level frame."""
    s, c, sl, cl = sin(latitude), cos(latitude), sin(longitude), cos(longitude)
    x, y, z = v
    out = cl * x + sl * y
    return c * z - s * out, cl * y - sl * x, -c * out - s * z


def gravity(latitude: float, height: float) -> float:
    """Returns the magnitude of gravity by the WGS84 formula, with the height to second order."""
    s2 = sin(latitude) ** 2
    normal = 9.7803253359 * (1 + 0.00193185265241 * s2) / sqrt(1 - E2 * s2)
    m = 0.00344978650684
    ratio = height / A
    return normal * (1 - 2 * (1 + F + m - 2 * F * s2) * ratio + 3 * ratio * ratio)


#: The direction of the northern geomagnetic pole, Earth-fixed, and the field at the geomagnetic equator in gauss.
_POLE = (0.0484, -0.1553, 0.9867)
_FIELD = 0.298


def magnetic_field(latitude: float, longitude: float) -> Vector:
    """Returns the magnetic field in gauss, north, east, down: that of a dipole near the centre of the Earth."""
    up = (cos(latitude) * cos(longitude), cos(latitude) * sin(longitude), sin(latitude))
    along = sum(a * b for a, b in zip(_POLE, up))
    x, y, z = (_FIELD * (pole - 3 * along * out) for pole, out in zip(_POLE, up))
    return to_ned(latitude, longitude, (x, y, z))


def geopotential(height: float) -> float:
    """Converts a height above mean sea level to a geopotential height."""
    return 6356766.0 * height / (6356766.0 + height)


def atmosphere(height: float) -> tuple[float, float, float]:
    """Returns temperature in degrees Celsius, pressure in mbar, density in kg/m^3 at a geopotential height.

    These are of the US Standard Atmosphere 1976 up to 20 km; above, the temperature stays the same.
    """
    t = 288.15 - 0.0065 * min(max(height, -5000.0), 11000.0)
    p = 1013.25 * (t / 288.15) ** 5.255877 * exp(-max(height - 11000.0, 0.0) / 6341.62)
    return t - 273.15, p, 100 * p / (287.05287 * t)


def turned(m: Matrix, v: Vector) -> Vector:
    """Multiplies a matrix and a vector."""
    x, y, z = v
    return (m[0] * x + m[1] * y + m[2] * z, m[3] * x + m[4] * y + m[5] * z, m[6] * x + m[7] * y + m[8] * z)


def turned_back(m: Matrix, v: Vector) -> Vector:
    """Multiplies a transposed matrix and a vector."""
    x, y, z = v
    return (m[0] * x + m[3] * y + m[6] * z, m[1] * x + m[4] * y + m[7] * z, m[2] * x + m[5] * y + m[8] * z)


def product(a: Matrix, b: Matrix) -> Matrix:
    rows = [[sum(a[3 * i + k] * b[3 * k + j] for k in range(3)) for j in range(3)] for i in range(3)]
    (p, q, r), (s, t, u), (v, w, x) = rows
    return p, q, r, s, t, u, v, w, x


def heading_of(north: float, east: float) -> float:
    """Returns the angle of a direction from north, 0 to 2 pi."""
    angle = atan2(east, north)
    return angle if angle >= 0 else angle + radians(360)
