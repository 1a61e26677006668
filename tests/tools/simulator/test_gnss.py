"""GNSS data: satellites, ephemerides and raw measurements lead to the position that the receiver shows."""

from __future__ import annotations

from math import cos, hypot, isclose, radians, sin, sqrt

import pytest
from mip_tools.simulator.motion import Circle, Standing
from simulated_world import Shown

LIGHT, OMEGA, GM = 299792458.0, 7.2921151467e-5, 3.986004418e14
WEEK = 604_800
PLACES = {"alps": (47.0, 8.0), "south": (-41.3, 174.8), "equator": (0.2, -91.0), "north": (78.2, 15.6)}
each_place = pytest.mark.parametrize("place", PLACES.values(), ids=PLACES)
EPHEMERIDES = {1: "gps_ephemeris", 3: "galileo_ephemeris", 4: "beidou_ephemeris"}


def solved(columns: list[list[float]], right: list[float]) -> list[float]:
    """Least squares by the normal equations."""
    size = len(columns[0])
    rows = [
        [sum(c[i] * c[j] for c in columns) for j in range(size)] + [sum(c[i] * r for c, r in zip(columns, right))]
        for i in range(size)
    ]
    for i in range(size):
        rows[i] = [x / rows[i][i] for x in rows[i]]
        for j in range(size):
            if j != i:
                rows[j] = [x - rows[j][i] * y for x, y in zip(rows[j], rows[i])]
    return [row[-1] for row in rows]


def test_phase_and_doppler_are_rates_of_the_pseudorange() -> None:
    """Over a second around the moment, to 0.1 Hz; the pseudorange is of the right order of magnitude."""
    shown = Shown(Circle(50, 10))
    before, now, after = (
        {(m.gnss_id, m.satellite_id): m for m in shown.at(t).all("gnss_1.raw")} for t in (99.5, 100.0, 100.5)
    )
    assert len(now) > 16
    for key, m in now.items():
        if key not in before or key not in after:
            continue
        assert isclose(m.doppler, before[key].carrier_phase - after[key].carrier_phase, abs_tol=0.1)
        wave = m.pseudorange / m.carrier_phase
        assert isclose(after[key].pseudorange - before[key].pseudorange, -m.doppler * wave, abs_tol=0.02)
        assert 1.9e7 < m.pseudorange < 3.0e7 and abs(m.doppler) < 5500 and 30 < m.signal_strength < 55
        assert m.lock_time == 100


def test_dilution_of_precision() -> None:
    """The parts add up, and follow from the directions of the satellites."""
    shown = Shown(Standing()).at(777)
    d = shown("gnss_1.dop")
    for whole, parts in (("gdop", ("pdop", "tdop")), ("pdop", ("hdop", "vdop")), ("hdop", ("ndop", "edop"))):
        assert isclose(getattr(d, whole), hypot(*(getattr(d, part) for part in parts)), rel_tol=1e-6)
    rows = []
    for s in shown.all("gnss_1.satellite_status"):
        el, az = radians(s.elevation), radians(s.azimuth)
        rows.append([cos(el) * cos(az), cos(el) * sin(az), -sin(el), 1.0])
    north = solved(rows, [r[0] for r in rows])
    assert isclose(north[0], 1, abs_tol=1e-9)
    # The variance of the north error is that of the weights which solve for it.
    unit = [[sum(r[i] * r[j] for r in rows) for j in range(4)] for i in range(4)]
    weights = solved(unit, [1.0, 0.0, 0.0, 0.0])
    assert isclose(d.ndop, sqrt(weights[0]), rel_tol=1e-5)
    assert 0.3 < d.hdop < d.pdop < d.gdop < 4


def test_the_receiver_clock_swings() -> None:
    """Its drift is the rate of its bias; a year later it is no farther away."""
    shown = Shown(Standing())
    for t in (1.0, 40_000.0, 365 * 86_400.0 + 3):
        a, b = (shown.at(t + d)("gnss_1.clock_info_2") for d in (-50, 50))
        drift = shown.at(t)("gnss_1.clock_info_2").drift
        assert isclose((b.bias - a.bias) / 100, drift, abs_tol=1e-13) and abs(a.bias) <= 1e-4
    assert shown("gnss_2.clock_info_2").bias != shown("gnss_1.clock_info_2").bias
    corrections = shown.all("filter_data.clock_correction")
    assert [c.receiver_id for c in corrections] == [1, 2]
    assert [c.bias for c in corrections] == pytest.approx(
        [shown(f"gnss_{i}.clock_info_2").bias for i in (1, 2)], rel=1e-6
    )
