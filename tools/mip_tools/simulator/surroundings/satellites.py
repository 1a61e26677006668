"""Satellites on Kepler orbits, as a receiver sees them, and their ephemerides."""

from __future__ import annotations

from collections.abc import Sequence
from math import asin, cos, pi, radians, sin, sqrt
from typing import NamedTuple

from ...geometry.earth import GM, LIGHT, ROTATION, SECOND, Vector, ecef, heading_of, to_ned

NODE_RATE = -8.0e-9
LOWEST = radians(10)
DAY = 86_400 * SECOND
ECCENTRICITY = 0.005
ARGUMENT = 0.7


class Satellite(NamedTuple):
    """A satellite and its orbit; angles are those at GPS time 0."""

    constellation: str
    id: int
    signal: str
    frequency: float  # of the signal, Hz
    frequency_number: int  # GLONASS
    axis: float
    inclination: float
    node: float  # longitude of the ascending node
    anomaly: float
    motion: float  # mean motion, rad/s
    clock_bias: float


class Seen(NamedTuple):
    """A satellite as one antenna sees it."""

    number: int  # within the list, from 1
    of: int  # the length of the list
    satellite: Satellite
    elevation: float
    azimuth: float
    pseudorange: float
    doppler: float

    @property
    def strength(self) -> float:
        """Carrier to noise density ratio in dB-Hz."""
        return 35 + 15 * sin(self.elevation)


def _constellation(
    name: str, signal: str, frequency: float, planes: int, axis: float, inclination: float, step: float = 0.0
) -> list[Satellite]:
    satellites = []
    for i in range(24):
        plane, slot = i % planes, i // planes
        number = (i * 5) % 14 - 7 if step else 0
        node, anomaly = (2 * pi * plane / planes + axis * 1e-7, 2 * pi * (slot / (24 // planes) + plane / 24))
        bias = ((i * 7) % 24 - 11.5) * 1e-5
        satellites.append(
            Satellite(
                name, i + 1, signal, frequency + number * step, number, axis, radians(inclination), node, anomaly,
                sqrt(GM / axis**3), bias,
            )
        )  # fmt: skip
    return satellites


SATELLITES: tuple[Satellite, ...] = (
    *_constellation("gps", "gps_l1ca", 1575.42e6, 6, 26_559_700.0, 55.0),
    *_constellation("glonass", "glonass_g1ca", 1602.0e6, 3, 25_508_000.0, 64.8, 562_500.0),
    *_constellation("galileo", "galileo_e1bc", 1575.42e6, 3, 29_600_000.0, 56.0),
    *_constellation("beidou", "beidou_b1i", 1561.098e6, 3, 27_906_000.0, 55.0),
)


def position_at(s: Satellite, t: float) -> Vector:
    """Returns the Earth-fixed position at a GPS time in seconds."""
    mean = s.anomaly + s.motion * t
    e = mean + ECCENTRICITY * sin(mean)
    for _ in range(3):
        e = mean + ECCENTRICITY * sin(e)
    ce, se = cos(e) - ECCENTRICITY, sqrt(1 - ECCENTRICITY**2) * sin(e)
    ca, sa = cos(ARGUMENT), sin(ARGUMENT)
    x, y = s.axis * (ce * ca - se * sa), s.axis * (ce * sa + se * ca)
    node = s.node + (NODE_RATE - ROTATION) * t
    cn, sn = cos(node), sin(node)
    ci = cos(s.inclination)
    return x * cn - y * ci * sn, x * sn + y * ci * cn, y * sin(s.inclination)


def velocity(s: Satellite, t: float) -> Vector:
    """Returns the Earth-fixed velocity."""
    (a, b, c), (d, e, f) = position_at(s, t - 0.5), position_at(s, t + 0.5)
    return d - a, e - b, f - c


def _line(s: Satellite, t: float, antenna: Vector) -> tuple[Vector, float, float]:
    """Returns the vector from an antenna to where the satellite sent the arriving signal, its length, and the delay."""
    delay, length = 0.075, 0.0
    line = (0.0, 0.0, 0.0)
    for _ in range(3):
        x, y, z = position_at(s, t - delay)
        turn = ROTATION * delay
        x, y = x + y * turn, y - x * turn
        line = (x - antenna[0], y - antenna[1], z - antenna[2])
        length = sqrt(line[0] ** 2 + line[1] ** 2 + line[2] ** 2)
        delay = length / LIGHT
    return line, length, delay


def in_view(
    gps: int, latitude: float, longitude: float, height: float, moves: Vector, bias: float, drift: float
) -> tuple[Seen, ...]:
    """Returns satellites in view of an antenna that `moves` (Earth-fixed), with the `bias` of the receiver clock."""
    t = gps / SECOND
    antenna = ecef(latitude, longitude, height)
    up = (cos(latitude) * cos(longitude), cos(latitude) * sin(longitude), sin(latitude))
    rows = []
    for s in SATELLITES:
        x, y, z = position_at(s, t)
        above = (x - antenna[0]) * up[0] + (y - antenna[1]) * up[1] + (z - antenna[2]) * up[2]
        if above < 1e6:
            continue
        line, length, delay = _line(s, t, antenna)
        n, e, d = to_ned(latitude, longitude, line)
        elevation = asin(-d / length)
        if elevation < LOWEST:
            continue
        v = velocity(s, t - delay)
        rate = sum((a - b) * c for a, b, c in zip(v, moves, line)) / length
        doppler = -(rate + LIGHT * drift) * s.frequency / LIGHT
        rows.append((s, elevation, heading_of(n, e), length + LIGHT * (bias - s.clock_bias), doppler))
    return tuple(Seen(i, len(rows), *row) for i, row in enumerate(rows, 1))


def only(satellites: Sequence[Seen], constellation: str) -> tuple[Seen, ...]:
    """Returns the satellites of one constellation, renumbered."""
    kept = [s for s in satellites if s.satellite.constellation == constellation]
    return tuple(s._replace(number=i, of=len(kept)) for i, s in enumerate(kept, 1))


class Dop(NamedTuple):
    gdop: float
    pdop: float
    hdop: float
    vdop: float
    tdop: float
    ndop: float
    edop: float


def dop(satellites: Sequence[Seen]) -> Dop:
    """Computes the dilution of precision; 99.9 if there are too few satellites."""
    rows = []
    for s in satellites:
        c = cos(s.elevation)
        rows.append((c * cos(s.azimuth), c * sin(s.azimuth), -sin(s.elevation), 1.0))
    normal = [[sum((r[i] * r[j] for r in rows), 0.0) for j in range(4)] for i in range(4)]
    q = _inverse(normal) if len(rows) >= 4 else None
    if q is None:
        return Dop(*[99.9] * 7)
    n, e, d, t = (q[i][i] for i in range(4))
    return Dop(sqrt(n + e + d + t), sqrt(n + e + d), sqrt(n + e), sqrt(d), sqrt(t), sqrt(n), sqrt(e))


def _inverse(m: list[list[float]]) -> list[list[float]] | None:
    size = len(m)
    rows = [[*row, *(1.0 if i == j else 0.0 for j in range(size))] for i, row in enumerate(m)]
    for i in range(size):
        best = max(range(i, size), key=lambda j: abs(rows[j][i]))
        if abs(rows[best][i]) < 1e-9:
            return None
        rows[i], rows[best] = rows[best], rows[i]
        pivot = rows[i][i]
        rows[i] = [x / pivot for x in rows[i]]
        for j in range(size):
            if j != i:
                k = rows[j][i]
                rows[j] = [x - k * y for x, y in zip(rows[j], rows[i])]
    return [row[size:] for row in rows]
