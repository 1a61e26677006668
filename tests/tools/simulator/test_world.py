"""Data fields agree with each other and with the motion, in attitude, motion, surroundings, time, GNSS and noise; at
rest, they have the values that the specification states."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import astuple, is_dataclass
from datetime import datetime, timedelta
from math import atan2, cos, degrees, dist, hypot, isclose, pi, radians, sin, sqrt
from random import Random
from typing import Any

import pytest
from mip_protocol import filter_data, mip_3dm, sensor
from mip_simulator import VirtualDevice
from mip_simulator.motion import Circle, Motion, Standing
from mip_simulator.surroundings.noise import Noise
from mip_simulator.surroundings.surroundings import START
from mip_tools.devices.facts import NOISE
from mip_tools.geometry import earth
from mipgen import model as m
from rotations import of_euler, of_quaternion, product, times, transposed
from simulated import Host, Shown
from support import model

G = 9.80665
FLOAT = 1.2e-7  # relative error of a float of four bytes, twice the error of rounding
TURNED = (0.0, 1.0, 0.0, -0.6, 0.0, 0.8, 0.8, 0.0, 0.6)  # a rotation of the sensor frame into the vehicle frame

MOTIONS: dict[str, Motion] = {
    "standing": Standing(-33.0, 151.0, 20.0, heading=200, pitch=12, roll=-7),
    "circle": Circle(20, 5),
    "fast circle": Circle(300, 60, -70.0, 170.0),
}
TIMES = (0.5, 3.0, 7.77, 21.0, 60.123)


@pytest.fixture(params=[None, TURNED], ids=["sensor frame", "vehicle frame"])
def turn(request: pytest.FixtureRequest) -> Any:
    return request.param


@pytest.fixture(params=MOTIONS)
def shown(request: pytest.FixtureRequest, turn: Any) -> Shown:
    found = Shown(MOTIONS[request.param])
    if turn:
        found.world.sensor_to_vehicle = turn
    return found


def close(a: Any, b: Any, scale: float) -> bool:
    """Equal up to the rounding of floats of this size."""
    return dist(a, b) <= scale * 2 * FLOAT


# --------------------------------------------------------------------------- attitude


def test_attitude(shown: Shown) -> None:
    for t in TIMES:
        shown.at(t)
        dcm = shown("filter_data.attitude_dcm").dcm
        e = shown("filter_data.euler_angles")
        assert close(of_euler(e.roll, e.pitch, e.yaw), dcm, 4)
        assert close(of_quaternion(shown("filter_data.attitude_quaternion").q), dcm, 4)
        assert close(shown("sensor.comp_orientation_matrix").m, dcm, 1)
        assert close(of_quaternion(shown("sensor.comp_quaternion").q), dcm, 4)
        c = shown("sensor.comp_euler_angles")
        assert (c.roll, c.pitch, c.yaw) == (e.roll, e.pitch, e.yaw)
        body = shown.world.state.dcm
        assert close(product(shown.world.sensor_to_vehicle, body), dcm, 2), "v_vehicle = turn * v_sensor"


# --------------------------------------------------------------------------- inertial


def test_accelerations(shown: Shown) -> None:
    for t in TIMES:
        shown.at(t)
        dcm = shown("filter_data.attitude_dcm").dcm
        force = shown("filter_data.comp_accel").accel
        gravity = shown("filter_data.gravity_vector").gravity
        linear = shown("filter_data.linear_accel").accel
        magnitude = shown("filter_data.wgs84_gravity_magnitude").gravity_magnitude
        assert isclose(hypot(*gravity), magnitude, rel_tol=FLOAT)
        assert close(gravity, times(dcm, (0, 0, magnitude)), 20)
        assert close([f + g for f, g in zip(force, gravity)], linear, 20)
        assert close(linear, times(dcm, shown.world.state.acceleration), 20)
        assert close([G * x for x in shown("sensor.scaled_accel").scaled_accel], force, 30)
        up = shown("sensor.up_vector").stabilized_accel
        turned = times(shown.world.sensor_to_vehicle, [-G * x for x in up])
        assert close(turned, gravity, 30)


def test_rates(shown: Shown) -> None:
    for t in TIMES:
        rate = shown.at(t)("filter_data.comp_angular_rate").gyro
        assert close(shown("sensor.scaled_gyro").scaled_gyro, rate, 1)
        assert close(rate, times(shown.world.sensor_to_vehicle, shown.world.state.rate), 2)


def test_integrals_of_the_rate_turn_the_attitude(shown: Shown) -> None:
    """Ten rotations of 0.1 s make the change of the attitude in a second."""
    shown.at(5.0).raw("sensor.delta_theta")
    dcm = shown("filter_data.attitude_dcm").dcm
    for i in range(10):
        x, y, z = shown.at(5.1 + i / 10)("sensor.delta_theta").delta_theta
        angle = hypot(x, y, z)
        half = sin(angle / 2) / angle if angle else 0.5
        dcm = product(of_quaternion((cos(angle / 2), half * x, half * y, half * z)), dcm)
    assert close(dcm, shown("filter_data.attitude_dcm").dcm, 30)


def test_integrals_of_the_acceleration_change_the_velocity(shown: Shown) -> None:
    """v1 = v0 + C^T * dv + g * t, where C is the attitude at the start; to 0.1 mm/s."""
    velocity = shown.at(5.0).world.state.velocity
    shown.raw("sensor.delta_velocity")
    for i in range(10):
        dcm, g = shown("filter_data.attitude_dcm").dcm, shown.world.gravity
        shown.at(5.1 + i / 10)
        change = times(transposed(dcm), [G * x for x in shown("sensor.delta_velocity").delta_velocity])
        velocity = tuple(v + c + down for v, c, down in zip(velocity, change, (0, 0, g * 0.1)))
    n = shown("filter_data.ned_velocity")
    assert dist(velocity, (n.north, n.east, n.down)) < 1e-4


def test_the_update_matrix_is_the_change_of_the_attitude(shown: Shown) -> None:
    shown.at(5.0).raw("sensor.comp_orientation_update_matrix")
    before = shown("filter_data.attitude_dcm").dcm
    update = shown.at(6.0)("sensor.comp_orientation_update_matrix").m
    assert close(product(update, before), shown("filter_data.attitude_dcm").dcm, 6)


# --------------------------------------------------------------------------- position and velocity


def ecef(latitude: float, longitude: float, height: float) -> tuple[float, float, float]:
    e2 = 6.69437999014e-3
    n = 6378137.0 / sqrt(1 - e2 * sin(latitude) ** 2)
    across = (n + height) * cos(latitude)
    return across * cos(longitude), across * sin(longitude), (n * (1 - e2) + height) * sin(latitude)


@pytest.mark.parametrize("source", ["filter_data", "gnss_1", "gnss_2"])
def test_position_and_velocity(shown: Shown, source: str) -> None:
    for t in TIMES:
        shown.at(t)
        p = shown(f"{source}.llh_position")
        fixed = shown(f"{source}.ecef_position").position
        assert dist(ecef(radians(p.latitude), radians(p.longitude), p.ellipsoid_height), fixed) < 1e-5
        assert dist(earth.llh(*fixed), (radians(p.latitude), radians(p.longitude), p.ellipsoid_height)) < 1e-5
        v = shown(f"{source}.ned_velocity")
        ned = (v.north, v.east, v.down) if source == "filter_data" else v.velocity
        moves = shown(f"{source}.ecef_velocity").velocity
        assert isclose(hypot(*moves), hypot(*ned), rel_tol=1e-6, abs_tol=1e-6)
        before = shown.at(t - 0.01)(f"{source}.ecef_position").position
        after = shown.at(t + 0.01)(f"{source}.ecef_position").position
        assert dist([(b - a) / 0.02 for a, b in zip(before, after)], moves) < 0.02, "2 m/s^2 for 0.01 s"


def test_gnss_speed_and_course(shown: Shown) -> None:
    for t in TIMES:
        v = shown.at(t)("gnss_1.ned_velocity")
        north, east, _down = v.velocity
        assert isclose(v.speed, hypot(*v.velocity), rel_tol=FLOAT, abs_tol=1e-9)
        assert isclose(v.ground_speed, hypot(north, east), rel_tol=FLOAT, abs_tol=1e-9)
        if v.ground_speed > 0.02:
            assert isclose(v.heading, degrees(atan2(east, north)) % 360, rel_tol=1e-6)
        else:
            dcm = shown("filter_data.attitude_dcm").dcm
            assert isclose(v.heading, degrees(atan2(dcm[1], dcm[0])) % 360, rel_tol=1e-6), "at rest, the heading"


# --------------------------------------------------------------------------- surroundings


@pytest.mark.parametrize("height", [-30.0, 0.0, 455.0, 3000.0, 10_900.0])
def test_pressure_follows_from_the_height(height: float) -> None:
    """By the usual formula of the troposphere, which takes a geopotential height, to 0.05 %."""
    shown = Shown(Standing(height=height + 45)).at(1)
    pressure = shown("sensor.scaled_pressure").scaled_pressure
    assert isclose(pressure, 1013.25 * (1 - 2.25577e-5 * height / (1 + height / 6.357e6)) ** 5.25588, rel_tol=5e-4)
    air = shown("filter_data.standard_atmosphere")
    assert isclose(air.standard_pressure, pressure, rel_tol=FLOAT)
    assert isclose(air.geometric_altitude, height, abs_tol=1e-3)
    assert shown("filter_data.pressure_altitude").pressure_altitude == air.geopotential_altitude
    assert isclose(air.standard_density, pressure * 100 / (287.05 * (air.standard_temperature + 273.15)), rel_tol=1e-4)
    assert shown("gnss_1.llh_position").msl_height == pytest.approx(height + 0.2, abs=1e-6)


@pytest.mark.parametrize(
    "geopotential, temperature, pressure",
    [(0, 15.0, 1013.25), (11_000, -56.5, 226.32), (20_000, -56.5, 54.749)],
)  # fmt: skip
def test_layers_of_the_standard_atmosphere(geopotential: float, temperature: float, pressure: float) -> None:
    """The tables of 1976; the layers meet."""
    for h in (geopotential - 0.01, geopotential):
        t, p, _ = earth.atmosphere(h)
        assert isclose(t, temperature, abs_tol=1e-3) and isclose(p, pressure, rel_tol=2e-5)


def test_gravity() -> None:
    """WGS84: 9.7803253 at the equator, 9.8321849 at the poles, less by 3.086e-6 per metre of height."""
    assert isclose(earth.gravity(0, 0), 9.7803253359, rel_tol=1e-9)
    assert isclose(earth.gravity(pi / 2, 0), 9.8321849379, rel_tol=1e-8)
    assert isclose(earth.gravity(0.8, 0) - earth.gravity(0.8, 1000), 3.086e-3, rel_tol=1e-3)


def test_magnetic_field(shown: Shown) -> None:
    for t in TIMES:
        shown.at(t)
        m = shown("filter_data.magnetic_model")
        field = (m.intensity_north, m.intensity_east, m.intensity_down)
        assert close(times(shown("filter_data.attitude_dcm").dcm, field), shown("sensor.scaled_mag").scaled_mag, 1)
        assert isclose(m.declination, atan2(field[1], field[0]), rel_tol=1e-6)
        assert isclose(m.inclination, atan2(field[2], hypot(*field[:2])), rel_tol=1e-6)
        turned = times(shown.world.sensor_to_vehicle, shown("sensor.north_vector").stabilized_mag)
        assert close(turned, shown("sensor.scaled_mag").scaled_mag, 1)


def test_the_magnetic_field_is_that_of_a_dipole() -> None:
    """In Europe it points north and down; everywhere it has the right strength, within a third."""
    north, east, down = earth.magnetic_field(radians(47), radians(8))
    assert 0.15 < north < 0.3 and abs(east) < 0.06 and 0.35 < down < 0.5
    assert earth.magnetic_field(radians(-89), 0.0)[2] < -0.5 < 0.5 < earth.magnetic_field(radians(89), 0.0)[2]
    assert 0.25 < hypot(*earth.magnetic_field(0.0, 2.0)) < 0.4


# --------------------------------------------------------------------------- time


def test_times_of_one_moment() -> None:
    for seconds in (0.0, 12.5, 604_799.999, 31_536_000.001):
        shown = Shown(Standing()).at(seconds)
        gps = START + round(seconds * 1e9)
        stamps = [
            shown(f"{name}")
            for name in ("shared.gps_timestamp", "filter_data.timestamp", "gnss_1.gps_time", "sensor.gps_timestamp")
        ]
        for stamp in stamps:
            assert round(stamp.tow * 1e9) == gps % (604_800 * 10**9) // 1 or isclose(
                stamp.tow, gps / 1e9 % 604_800, abs_tol=2e-7
            )
            assert stamp.week_number == gps // (604_800 * 10**9)
        assert shown("shared.external_timestamp").nanoseconds == gps
        assert shown("shared.reference_timestamp").nanoseconds == round(seconds * 1e9)
        u = shown("gnss_1.utc_time")
        utc = datetime(1980, 1, 6) + timedelta(seconds=gps // 10**9 - 18, milliseconds=gps % 10**9 // 10**6)
        assert datetime(u.year, u.month, u.day, u.hour, u.min, u.sec, u.msec * 1000) == utc
        assert shown("gnss_1.gps_leap_seconds").leap_seconds == 18
        assert dist([shown("filter_data.gnss_dual_antenna_status").tow], [stamps[0].tow]) < 0.04


def test_the_refresh_bit_toggles_each_second() -> None:
    shown = Shown(Standing())
    bits = [
        bool(
            shown.at(t / 2)("sensor.gps_timestamp").valid_flags.TIME_REFRESH & shown("sensor.gps_timestamp").valid_flags
        )
        for t in range(8)
    ]
    assert bits == [False, False, True, True] * 2


@pytest.mark.parametrize(
    "utc, behind",
    [("1980-01-06", 0), ("1981-06-30T23:59:59", 0), ("1981-07-01", 1), ("2005-12-31T23:59:59", 13), ("2006-01-01", 14),
     ("2016-12-31T23:59:59", 17), ("2017-01-01", 18), ("2030-05-05", 18)],
)  # fmt: skip
def test_leap_seconds(utc: str, behind: int) -> None:
    time = datetime.fromisoformat(utc)
    gps = earth.from_utc(time)
    assert gps == ((time - datetime(1980, 1, 6)) // timedelta(seconds=1) + behind) * 10**9
    assert earth.leap_seconds(gps) == behind and earth.gps_to_utc(gps) == time


def test_a_leap_second_repeats_the_last_one() -> None:
    begin = earth.from_utc(datetime(2017, 1, 1))
    assert [earth.gps_to_utc(begin + d * 10**9).second for d in (-2, -1, 0, 1)] == [59, 59, 0, 1]


def test_counters_since_the_last_output() -> None:
    shown = Shown(Standing())
    assert shown.at(1)("shared.delta_ticks").ticks == 1, "the first counts from one base period before"
    assert shown("shared.reference_time_delta").dt_nanos == 1_000_000_000, "no base rate is known for the shared set"
    for t, before in ((1.25, 1.0), (4.0, 1.25)):
        assert shown.at(t)("shared.reference_time_delta").dt_nanos == round((t - before) * 1e9)
        assert isclose(shown("shared.delta_time").seconds, t - before if t > 1.25 else 1.0)


def test_a_restart_begins_the_reference_clock_anew() -> None:
    shown = Shown(Standing())
    shown.at(10).raw("shared.reference_time_delta")
    shown.world.restart()
    assert shown("shared.reference_timestamp").nanoseconds == 0
    assert shown.at(10.5)("shared.reference_time_delta").dt_nanos == 500_000_000
    assert shown("shared.gps_timestamp").tow == 0.5, "so does the time of week, until a receiver sets it"
    shown.world.synchronize()
    assert shown("shared.gps_timestamp").tow == 10.5


def test_the_time_can_be_set() -> None:
    shown = Shown(Standing()).at(2.25)
    shown.world.set_gps(week=2300)
    shown.world.set_gps(tow=1000)
    s = shown("shared.gps_timestamp")
    assert (s.week_number, s.tow) == (2300, 1000.25)


# --------------------------------------------------------------------------- GNSS


def test_dilution_of_precision() -> None:
    """The parts add up."""
    d = Shown(Standing())("gnss_1.dop")
    for whole, parts in (("gdop", ("pdop", "tdop")), ("pdop", ("hdop", "vdop")), ("hdop", ("ndop", "edop"))):
        assert isclose(getattr(d, whole), hypot(*(getattr(d, part) for part in parts)), rel_tol=1e-2)


def test_satellites_are_numbered() -> None:
    shown = Shown(Standing())
    status = shown.all("gnss_1.satellite_status")
    assert [s.index for s in status] == list(range(1, 21)) and {s.count for s in status} == {20}
    assert shown("gnss_1.fix_info").num_sv == 20 and len(shown.all("gnss_2.raw")) == 20
    shown.world.gnss = False
    assert shown.all("gnss_1.satellite_status") == [] and shown("gnss_1.fix_info").num_sv == 0


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


# --------------------------------------------------------------------------- at rest


def stated() -> Iterator[tuple[str, m.Field, m.Parameter]]:
    for f in model("real").fields:
        for p in f.parameters:
            if p.at_rest and f.role == m.DATA:
                yield f"{f.name_in(f.sets[-1])}.{p.name}", f, p


def numbers(value: Any) -> list[float]:
    """The elements of a vector, or the number."""
    if isinstance(value, (int, float)):
        return [value]
    return list(astuple(value)) if is_dataclass(value) and not isinstance(value, type) else list(value)


@pytest.mark.parametrize("heading", [0.0, 60.0, -150.0])
def test_what_a_level_device_at_rest_shows(heading: float) -> None:
    """To half a percent, as gravity depends on the place."""
    shown, wrong = Shown(Standing(heading=heading)).at(20.0), []
    for name, f, p in stated():
        set_name = name.split(".")[0]
        value = numbers(getattr(shown(f"{set_name}.{f.name}"), p.name))
        for element, got, want in zip(p.elements or ("",), value, p.at_rest, strict=True):
            if want is not None and abs(got - want) > 0.005 * max(abs(want), 0.02):
                wrong.append(f"{name}.{element}: {got:g}, stated {want}")
    assert not wrong, "\n".join(wrong)


def test_physical_quantities_state_it() -> None:
    found = {name for name, _, _ in stated()}
    assert found >= {
        "sensor.scaled_accel.scaled_accel", "sensor.scaled_gyro.scaled_gyro", "filter_data.comp_accel.accel",
        "filter_data.gravity_vector.gravity", "filter_data.euler_angles.roll", "filter_data.attitude_dcm.dcm",
    }  # fmt: skip


@pytest.mark.parametrize(
    ("motion", "name", "sign"),
    [
        (Standing(roll=10), "roll", 1), (Standing(pitch=10), "pitch", 1), (Standing(heading=10), "yaw", 1),
    ],
)  # fmt: skip
def test_signs_of_angles_are_those_of_the_axes(motion: Standing, name: str, sign: int) -> None:
    """Right side down, nose up, clockwise: gravity, which points down, shows itself on y and z, or x and z."""
    shown = Shown(motion).at(20.0)
    angles, gravity = shown("filter_data.euler_angles"), numbers(shown("filter_data.gravity_vector").gravity)
    assert getattr(angles, name) * sign == pytest.approx(0.17453, abs=1e-3)
    x, y, _ = gravity
    assert (y > 1) == (name == "roll") and (x < -1) == (name == "pitch")


# --------------------------------------------------------------------------- noise

GYRO = "measured.angular_rate"


def allan(integrals: list[float], step: float, steps: int) -> float:
    """The overlapping Allan deviation at `steps` steps, of rates whose integrals are given."""
    x, n, t = integrals, steps, step * steps
    squares = [(x[i + 2 * n] - 2 * x[i + n] + x[i]) ** 2 for i in range(len(x) - 2 * n)]
    return sqrt(sum(squares) / len(squares) / 2) / t


def test_white_noise_has_its_allan_deviation() -> None:
    """The density divided by the square root of the time, whatever the steps are."""
    figures = NOISE[GYRO]
    for step in (0.001, 0.1):
        noise = Noise(3, Random(5), **figures)
        rows = [noise.integral(round(i * step * 1e9)) for i in range(6000)]
        for steps in (1, 10):
            found = sum(allan(list(axis), step, steps) for axis in zip(*rows)) / 3
            assert found == pytest.approx(figures["density"] / sqrt(step * steps), rel=0.1)


def test_drift_has_its_allan_deviation() -> None:
    """The Allan deviation of a Gauss-Markov process peaks at 1.89 of its correlation time, at 0.618 of its sigma."""
    noise = Noise(3, Random(1), 1e-9, drift=4e-5, period=200.0)
    step = 37.8
    rows = [noise.integral(round(i * step * 1e9)) for i in range(12000)]
    found = sum(allan(list(axis), step, 10) for axis in zip(*rows)) / 3
    assert found == pytest.approx(0.618 * 4e-5, rel=0.1)


def test_rates_and_deltas_agree() -> None:
    """At rest, a delta is the rate of the same sample times the interval, noise and bias included."""
    shown = Shown(Standing(), exact=False, seed=3)
    for i in range(1, 50):
        shown.at(i * 0.02 + (i % 3) * 0.001)
        rate, delta = shown("sensor.scaled_gyro").scaled_gyro, shown("sensor.delta_theta").delta_theta
        force, change = shown("sensor.scaled_accel").scaled_accel, shown("sensor.delta_velocity").delta_velocity
        raw = shown("sensor.raw_gyro").raw_gyro
        if i > 1:
            passed = 0.02 + ((i % 3) - (i - 1) % 3) * 0.001
            assert dist([x * passed for x in rate], delta) < 1e-9
            assert dist([x * passed for x in force], change) < 1e-7
            assert dist([x / 5000 for x in raw], rate) < 1e-7


def spread(device: VirtualDevice, decimation: int) -> float:
    """The standard deviation of the angular rate at 1000 Hz divided by a decimation."""
    host = Host(device)
    host.stream(0x80, (sensor.ScaledGyro, decimation))
    rates = [x.scaled_gyro for x in host.received(600 * decimation / 1000, sensor.ScaledGyro)]
    means = [sum(axis) / len(rates) for axis in zip(*rates)]
    return sqrt(sum(hypot(*(x - m for x, m in zip(rate, means))) ** 2 for rate in rates) / len(rates) / 3)


@pytest.mark.parametrize("decimation", [1, 10, 40])
def test_noise_follows_the_rate(decimation: int) -> None:
    """The bandwidth is half the rate of the field."""
    found = spread(VirtualDevice("3dm-cv7-gnss-ins", seed=2), decimation)
    assert found == pytest.approx(NOISE[GYRO]["density"] * sqrt(1000 / decimation), rel=0.12)


def test_without_noise_there_is_none() -> None:
    assert spread(VirtualDevice("3dm-cv7-gnss-ins", noise=0), 1) == 0


# --------------------------------------------------------------------------- settings of a device


def mean(values: list[Any]) -> list[float]:
    return [sum(column) / len(values) for column in zip(*values)]


def test_a_captured_bias_is_removed() -> None:
    """What is left is noise: 87e-6 rad/s over a second."""
    host = Host(VirtualDevice("3dm-cv7-gnss-ins", motion=Standing()))
    host.stream(0x80, (sensor.ScaledGyro, 1))
    before = mean([x.scaled_gyro for x in host.received(1, sensor.ScaledGyro)])
    bias = host.ok(mip_3dm.CaptureGyroBias(1000)).bias
    assert hypot(*bias) > 1e-4 and dist(before, bias) < 2e-4
    assert host.ok(mip_3dm.GyroBias.read()).bias == bias
    host.received(0.01, sensor.ScaledGyro)
    assert hypot(*mean([x.scaled_gyro for x in host.received(1, sensor.ScaledGyro)])) < 2e-4
    host.ok(mip_3dm.GyroBias.default())
    host.received(0.01, sensor.ScaledGyro)
    assert dist(mean([x.scaled_gyro for x in host.received(1, sensor.ScaledGyro)]), before) < 2e-4


def test_a_bias_that_is_set_is_subtracted() -> None:
    host = Host(VirtualDevice("3dm-cv7-gnss-ins", motion=Standing()))
    host.stream(0x80, (sensor.ScaledAccel, 10))
    before = mean([x.scaled_accel for x in host.received(1, sensor.ScaledAccel)])
    host.ok(mip_3dm.AccelBias.write((9.80665, 0.0, -9.80665)))
    host.received(0.01, sensor.ScaledAccel)
    after = mean([x.scaled_accel for x in host.received(1, sensor.ScaledAccel)])
    assert dist(before, [a + b for a, b in zip(after, (1, 0, -1))]) < 2e-3
    host.device.reset()
    host.device.advance(5)
    assert host.device.world.accel_bias == (0, 0, 0), "it was not saved"


def test_the_mounting_turns_what_is_sent() -> None:
    """A sensor that is turned by 90 degrees about the vertical."""
    host = Host(VirtualDevice("3dm-cv7-gnss-ins", motion=Circle(20, 5)))
    host.stream(0x82, (filter_data.LinearAccel, 10), (filter_data.EulerAngles, 10))
    plain = host.received(1, filter_data.LinearAccel)[-1].accel
    assert dist(plain, (0, 25 / 20, 0)) < 0.03, "to the right, where the centre is"
    host.ok(mip_3dm.SensorToVehicleTransformEuler.write(0.0, 0.0, pi / 2))
    turned = host.received(1, filter_data.LinearAccel)[-1].accel
    assert dist((abs(turned[0]), turned[1], turned[2]), (25 / 20, 0, 0)) < 0.03


@pytest.mark.parametrize("steps", [1, 7, 100])
def test_time_may_be_cut_in_any_way(steps: int) -> None:
    """The same bytes, noise and integrals included."""

    def run(pieces: int, seed: int = 3) -> bytes:
        host = Host(VirtualDevice("3dm-cv7-gnss-ins", motion=Circle(), seed=seed))
        host.stream(0x80, (sensor.ScaledAccel, 10), (sensor.DeltaTheta, 20), (sensor.ScaledPressure, 50))
        read = bytearray()
        for _ in range(pieces):
            host.device.run_until(host.device.now + 2_000_000_000 // pieces)
            read += host.link.read()
        return bytes(read)

    whole, cut = run(1), run(steps)
    assert len(cut) > 2000 and cut == whole[: len(cut)] != run(1, 4)[: len(cut)]
