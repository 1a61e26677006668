"""GNSS data: satellites, ephemerides and raw measurements lead to the position that the receiver shows."""

from __future__ import annotations

from math import atan2, cos, degrees, dist, hypot, isclose, pi, radians, sin, sqrt
from typing import Any

import pytest
from mip_tools.geometry import earth
from mip_tools.simulator.motion import Circle, Standing
from pairs import pairwise
from simulated_world import Shown

LIGHT, OMEGA, GM = 299792458.0, 7.2921151467e-5, 3.986004418e14
WEEK = 604_800
PLACES = {"alps": (47.0, 8.0), "south": (-41.3, 174.8), "equator": (0.2, -91.0), "north": (78.2, 15.6)}
each_place = pytest.mark.parametrize("place", PLACES.values(), ids=PLACES)
EPHEMERIDES = {1: "gps_ephemeris", 3: "galileo_ephemeris", 4: "beidou_ephemeris"}


def position(e: Any, tow: float) -> tuple[float, float, float]:
    """The position of a satellite from its broadcast ephemeris, by the interface specification of GPS."""
    t = tow - e.t_oe
    t += WEEK if t < -WEEK / 2 else -WEEK if t > WEEK / 2 else 0
    mean = e.mean_anomaly + (sqrt(GM / e.a**3) + e.delta_mean_motion) * t
    anomaly = mean
    for _ in range(10):
        anomaly = mean + e.eccentricity * sin(anomaly)
    true = atan2(sqrt(1 - e.eccentricity**2) * sin(anomaly), cos(anomaly) - e.eccentricity)
    u, r = true + e.argument_of_perigee, e.a * (1 - e.eccentricity * cos(anomaly))
    x, y = r * cos(u), r * sin(u)
    node = e.omega + (e.omega_dot - OMEGA) * t - OMEGA * e.t_oe
    i = e.inclination + e.inclination_dot * t
    return x * cos(node) - y * cos(i) * sin(node), x * sin(node) + y * cos(i) * cos(node), y * sin(i)


def arriving(e: Any, tow: float, delay: float) -> tuple[float, float, float]:
    """The position of a satellite at transmission, in the axes at the time of arrival."""
    x, y, z = position(e, tow - delay)
    turn = OMEGA * delay
    return x * cos(turn) + y * sin(turn), y * cos(turn) - x * sin(turn), z


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


@pairwise(place=PLACES.values(), receiver=[1, 2], seconds=[10.0, 604_790.5])
def test_raw_measurements_and_ephemerides_give_the_position(place: Any, receiver: int, seconds: float) -> None:
    """To 5 cm, from the data of the device alone; and the clock bias to 0.1 ns."""
    shown = Shown(Circle(50, 10, *place)).at(seconds)
    broadcast = {
        (number, e.satellite_id): e for number, name in EPHEMERIDES.items() for e in shown.all(f"gnss_1.{name}")
    }
    seen = [
        (m, broadcast[m.gnss_id, m.satellite_id]) for m in shown.all(f"gnss_{receiver}.raw") if m.gnss_id in EPHEMERIDES
    ]
    assert len(seen) >= 8
    x = [0.0, 0.0, 0.0, 0.0]
    for _ in range(8):
        columns, rest = [], []
        for m, e in seen:
            delay = (m.pseudorange - x[3]) / LIGHT + e.af0
            satellite = arriving(e, m.tow, delay)
            length = dist(satellite, x[:3])
            columns.append([*((a - b) / length for a, b in zip(x, satellite)), 1.0])
            rest.append(m.pseudorange + LIGHT * e.af0 - length - x[3])
        x = [a + b for a, b in zip(x, solved(columns, rest))]
    assert dist(x[:3], shown(f"gnss_{receiver}.ecef_position").position) < 0.05
    assert isclose(x[3] / LIGHT, shown(f"gnss_{receiver}.clock_info_2").bias, abs_tol=2e-10)


@each_place
def test_satellites_stand_where_their_ephemerides_put_them(place: Any) -> None:
    shown = Shown(Standing(*place)).at(5000)
    p = shown("gnss_1.llh_position")
    here = shown("gnss_1.ecef_position").position
    status = {(s.gnss_id, s.satellite_id): s for s in shown.all("gnss_1.satellite_status")}
    checked = 0
    for number, name in EPHEMERIDES.items():
        for e in shown.all(f"gnss_1.{name}"):
            s = status[number, e.satellite_id]
            line = [a - b for a, b in zip(arriving(e, s.tow, 0.08), here)]
            n, east, down = earth.to_ned(radians(p.latitude), radians(p.longitude), tuple(line))  # type: ignore[arg-type]
            assert isclose(s.elevation, degrees(atan2(-down, hypot(n, east))), abs_tol=1e-3)
            away = (s.azimuth - degrees(atan2(east, n)) + 180) % 360 - 180
            assert abs(away) * cos(radians(s.elevation)) < 1e-3
            checked += 1
    assert checked > 8
    for s in status.values():
        assert 10 <= s.elevation <= 90 and 0 <= s.azimuth <= 360 and s.health is True
    assert {s.index for s in status.values()} == set(range(1, len(status) + 1)) and {
        s.count for s in status.values()
    } == {len(status)}
    assert shown("gnss_1.fix_info").num_sv == len(status)


def test_glonass_ephemerides_place_the_satellites() -> None:
    """Position and velocity at the reference time, which is at most half an hour ago."""
    shown = Shown(Standing()).at(100.0)
    p, here = shown("gnss_1.llh_position"), shown("gnss_1.ecef_position").position
    status = {s.satellite_id: s for s in shown.all("gnss_1.satellite_status") if s.gnss_id == 2}
    found = shown.all("gnss_1.glonass_ephemeris")
    assert {e.satellite_id for e in found} == set(status)
    moscow = (shown.world.gps // 10**9 - 18 + 3 * 3600) % 86_400
    for e in found:
        ago = (moscow - e.tb) % 86_400
        assert 0 <= ago < 1800 and 0 <= e.tb - e.tk < 30
        assert isclose(hypot(*e.position), 25_508_000, rel_tol=0.006) and 2500 < hypot(*e.velocity) < 4500
        line = [a + v * ago - b for a, v, b in zip(e.position, e.velocity, here)]
        n, east, down = earth.to_ned(radians(p.latitude), radians(p.longitude), tuple(line))  # type: ignore[arg-type]
        assert isclose(status[e.satellite_id].elevation, degrees(atan2(-down, hypot(n, east))), abs_tol=0.5)


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


def test_orbits_do_not_age() -> None:
    """After twenty years of GPS time, the angles are still within one turn."""
    for seconds in (0.0, 20 * 365.25 * 86_400):
        for e in Shown(Standing()).at(seconds).all("gnss_1.gps_ephemeris"):
            assert abs(e.mean_anomaly) <= pi and abs(e.omega) <= pi and 0 <= e.t_oe < WEEK
