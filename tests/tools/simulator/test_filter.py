"""The filter of the virtual device: its states, and errors that are as large as its uncertainties."""

from __future__ import annotations

from itertools import pairwise
from math import cos, degrees, pi, radians, remainder, sin
from typing import Any

import pytest
from mip_protocol import aiding, filter_data, mip_3dm
from mip_protocol import filter as commands
from mip_simulator import VirtualDevice
from mip_simulator.motion import Circle, Standing
from mip_tools.geometry.attitude import euler
from mip_tools.geometry.earth import radii
from simulated import TYPES, Host, show

CV7 = "3dm-cv7-gnss-ins"
INIT, VERTICAL_GYRO, AHRS, FULL_NAV = 1, 2, 3, 4
STABLE, CONVERGING, HEADING, POSITION, VELOCITY, NO_PULSE = 1, 2, 8, 16, 32, 1024


def state(device: VirtualDevice) -> int:
    return int(show(device, "filter_data.status").filter_state)


def flags(device: VirtualDevice) -> int:
    return int(show(device, "filter_data.status").status_flags)


def initialization(alignment: Any, wait: int = 0, heading: float = 0.0, given: int = 0) -> Any:
    zero = (0.0, 0.0, 0.0)
    return commands.InitializationConfig.write(wait, given, alignment, heading, 0.0, 0.0, zero, zero, 2)


DUAL_ANTENNA, KINEMATIC, MAG, EXTERNAL = 1, 2, 4, 8


# --------------------------------------------------------------------------- states


def test_states_after_a_reset() -> None:
    """Nothing, then the level, then a heading and a position."""
    host = Host(VirtualDevice(CV7, motion=Circle(20, 5)))
    assert (state(host.device), flags(host.device)) == (FULL_NAV, STABLE)
    host.ok(commands.Reset())
    assert state(host.device) == INIT
    assert show(host.device, "filter_data.euler_angles").valid_flags == 0
    states = []
    for _ in range(30):
        host.device.advance(0.2)
        states.append(state(host.device))
        position = show(host.device, "filter_data.llh_position")
        assert (position.valid_flags == 1) == (state(host.device) == FULL_NAV) == (position.latitude != 0)
    assert states == sorted(states) and set(states) == {INIT, VERTICAL_GYRO, AHRS, FULL_NAV}
    assert flags(host.device) & 3 == CONVERGING
    host.device.advance(120)
    assert flags(host.device) == STABLE


@pytest.mark.parametrize(
    ("alignment", "motion", "reached"),
    [
        (DUAL_ANTENNA, Standing(), FULL_NAV), (MAG, Standing(), FULL_NAV), (KINEMATIC, Circle(20, 5), FULL_NAV),
        (KINEMATIC, Standing(), VERTICAL_GYRO), (KINEMATIC, Circle(20, 1.5), VERTICAL_GYRO),
        (0, Circle(), VERTICAL_GYRO), (EXTERNAL, Standing(), VERTICAL_GYRO),
    ],
)  # fmt: skip
def test_ways_to_align_the_heading(alignment: int, motion: Any, reached: int) -> None:
    """Kinematic alignment begins at 2 m/s."""
    host = Host(VirtualDevice(CV7, motion=motion))
    host.ok(initialization(alignment))
    host.ok(commands.Reset())
    host.device.advance(10)
    assert state(host.device) == reached


def heading(value: float) -> Any:
    return aiding.TrueHeading(aiding.MeasurementTime(timebase=3, nanoseconds=0), 1, value, 0.01, 1)


def test_alignment_by_the_user() -> None:
    host = Host(VirtualDevice(CV7, motion=Standing(heading=60), noise=0))
    host.ok(aiding.FrameConfig.write(1, 1, False, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)))
    host.ok(initialization(EXTERNAL))
    host.ok(commands.Reset())
    host.device.advance(2)
    assert state(host.device) == VERTICAL_GYRO
    for _ in range(5):
        host.ok(heading(radians(60)))
        host.device.advance(0.5)
    assert state(host.device) == FULL_NAV
    assert show(host.device, "filter_data.euler_angles").yaw == pytest.approx(radians(60), abs=0.03)


def test_a_given_heading_and_the_command_to_run() -> None:
    host = Host(VirtualDevice(CV7, motion=Standing(heading=10), noise=0))
    for source in (1, 4):
        host.ok(commands.AidingMeasurementEnable.write(source, False))
    host.ok(initialization(0, wait=1, heading=15.0, given=1))
    host.ok(commands.Reset())
    host.device.advance(20)
    assert state(host.device) == INIT
    host.ok(commands.Run())
    host.device.advance(1.8)
    assert state(host.device) >= AHRS
    assert degrees(show(host.device, "filter_data.euler_angles").yaw) == pytest.approx(15, abs=3)


def test_a_place_that_the_user_gives() -> None:
    """It leads to full navigation without reception. A new mounting resets the filter."""
    host = Host(VirtualDevice(CV7, sync=False))
    host.ok(initialization(0, heading=15.0, given=2))
    host.ok(commands.Reset())
    host.device.advance(3)
    assert state(host.device) == AHRS
    host.ok(initialization(0, heading=15.0, given=3))
    host.device.advance(1)
    assert state(host.device) == FULL_NAV
    host.ok(mip_3dm.SensorToVehicleTransformEuler.write(0.0, 0.0, 1.0))
    assert state(host.device) == INIT
    host.device.advance(3)
    assert state(host.device) == FULL_NAV


def test_what_the_filter_accepts_in_one_state_only() -> None:
    host, new, failed = Host(VirtualDevice("3dm-gx5-15", noise=0)), Host(VirtualDevice(CV7)), 4
    new.ok(commands.SetInitialHeading(1.0))
    for command in (commands.SetInitialHeading(1.0), commands.SetInitialAttitude(0.0, 0.0, 1.0)):
        assert host.refused(command) == failed
        host.ok(commands.Reset())
        assert host.refused(commands.TareOrientation.write(7)) == failed, "it has no attitude"
        host.ok(command)
        assert host.refused(command) == failed, "it is initialized"
        assert show(host.device, "filter_data.euler_angles").yaw == pytest.approx(1.0, abs=1e-3)
    update = commands.ExternalHeadingUpdate(1.0, 0.1, 1)
    assert host.refused(update) == failed
    host.ok(commands.HeadingSource.write(commands.HeadingUpdateSource.EXTERNAL))
    host.ok(update)
    new.ok(update)
    new.ok(commands.AidingMeasurementEnable.write(5, False))
    assert new.refused(update) == failed


def test_a_tare_sets_the_mounting() -> None:
    tare, mounting = commands.TareOrientation, commands.SensorToVehicleRotationEuler
    host = Host(VirtualDevice("3dm-gx5-15", motion=Standing(roll=10, pitch=5), noise=0))

    def angles() -> list[float]:
        e, set_ = show(host.device, "filter_data.euler_angles"), host.ok(mounting.read())
        return [abs(x) for x in (e.roll, e.pitch, set_.roll, set_.pitch)]

    tilted = pytest.approx([radians(10), radians(5), 0, 0], abs=1e-4)
    assert angles() == tilted
    host.ok(tare.write(3))
    tared = pytest.approx([0, 0, radians(10), radians(5)], abs=0.02)
    assert angles() == tared
    host.ok(tare.save())
    host.ok(tare.write(0))
    assert angles() == tilted
    host.device.reset()
    host.device.advance(5)
    assert angles() == tared
    host.ok(tare.default())
    assert angles() == tilted
    host.ok(mounting.load())
    assert angles() == tared


def test_a_heading_that_is_not_aided_is_relative() -> None:
    """A 3DM-GX5-15 has no reference for its heading: it begins at 0, and its solution is valid."""
    device = VirtualDevice("3dm-gx5-15", motion=Standing(heading=90))
    assert abs(show(device, "filter_data.euler_angles").yaw) < 0.2
    assert int(show(device, "filter_data.status").filter_state) == 2, "a valid solution"
    assert show(device, "filter_data.euler_angles_uncertainty").yaw > 1


# --------------------------------------------------------------------------- aiding


def errors(device: VirtualDevice) -> list[float]:
    """Errors divided by their uncertainties: angles, velocity, position."""
    s, u = device.world.state, show(device, "filter_data.euler_angles_uncertainty")
    e, v, p = (show(device, f"filter_data.{x}") for x in ("euler_angles", "ned_velocity", "llh_position"))
    uv, up = (show(device, f"filter_data.{x}_uncertainty") for x in ("ned_velocity", "llh_position"))
    wrong = [remainder(a - b, 2 * pi) for a, b in zip((e.roll, e.pitch, e.yaw), euler(s.dcm))]
    wrong += [a - b for a, b in zip((v.north, v.east, v.down), s.velocity)]
    along, across = radii(s.latitude)
    wrong.append((radians(p.latitude) - s.latitude) * (along + s.height))
    wrong.append((radians(p.longitude) - s.longitude) * (across + s.height) * cos(s.latitude))
    wrong.append(s.height - p.ellipsoid_height)
    deviations = [u.roll, u.pitch, u.yaw, uv.north, uv.east, uv.down, up.north, up.east, up.down]
    return [x / d for x, d in zip(wrong, deviations, strict=True)]


def aiding_of(device: VirtualDevice) -> list[Any]:
    kind: Any = TYPES["filter_data.aiding_measurement_summary"]
    return [kind.decode(x.data) for x in device.encoder(0x82, 0x46)()]


@pytest.mark.parametrize("gnss", [True, False])
def test_errors_are_as_large_as_the_uncertainties(gnss: bool) -> None:
    """The mean square of ten devices, each with errors of its own, in an outage, too."""
    squares = []
    for seed in range(10):
        device = VirtualDevice(CV7, motion=Circle(50, 5), seed=seed)
        device.world.advance()
        device.world.gnss = gnss
        device.advance(100)
        squares += [x * x for x in errors(device)]
    assert 0.6 < sum(squares) / len(squares) < 1.4 and max(squares) < 9


def test_an_outage_of_gnss_and_the_recovery() -> None:
    device = VirtualDevice(CV7, motion=Circle(50, 5), seed=4)
    device.advance(1)
    before = show(device, "filter_data.llh_position_uncertainty").north
    device.world.advance()
    device.world.gnss = False
    grown = []
    for _ in range(3):
        device.advance(40)
        grown.append(show(device, "filter_data.llh_position_uncertainty").north)
    assert before < 1 and 10 < grown[0] < grown[1] < grown[2] and grown[2] > 5 * grown[0], "faster than the time"
    assert state(device) == FULL_NAV and flags(device) == CONVERGING | POSITION | VELOCITY | NO_PULSE
    assert show(device, "gnss_1.fix_info").fix_type.name == "FIX_NONE"
    assert show(device, "gnss_1.llh_position").valid_flags == 0
    assert all(not a.indicator.USED & a.indicator for a in aiding_of(device) if a.type.name in ("GNSS", "DUAL_ANTENNA"))
    device.world.gnss = True
    device.advance(60)
    assert flags(device) == STABLE and show(device, "filter_data.llh_position_uncertainty").north < 1
    assert max(map(abs, errors(device))) < 3


def test_aiding_that_is_switched_off_is_not_used() -> None:
    host = Host(VirtualDevice(CV7, motion=Circle(50, 5)))
    for source in (0, 1, 4):
        host.ok(commands.AidingMeasurementEnable.write(source, False))
    host.device.advance(600)
    aids = {(a.type.name, a.source): int(a.indicator) for a in aiding_of(host.device)}
    assert aids["GNSS", 1] == aids["DUAL_ANTENNA", 0] == 0
    assert flags(host.device) & POSITION
    host.ok(commands.AidingMeasurementEnable.default(0))
    host.device.advance(60)
    assert not flags(host.device) & POSITION


def test_the_estimate_does_not_depend_on_when_it_is_read() -> None:
    often, once = (VirtualDevice(CV7, motion=Circle(50, 5), seed=9) for _ in range(2))
    for _ in range(100):
        often.advance(0.37)
        show(often, "filter_data.euler_angles")
    once.advance(37)
    assert show(often, "filter_data.euler_angles") == show(once, "filter_data.euler_angles")


def test_a_range_limits_a_sensor() -> None:
    """Turned by 90 degrees, it measures 1 g along x; the smallest range of the gyroscope is 75 degrees a second."""
    host = Host(VirtualDevice(CV7, motion=Circle(1, 2)))
    host.ok(mip_3dm.SensorRange.write(2, 1))
    assert show(host.device, "sensor.overrange_status").status == 1 << 6
    rate = show(host.device, "sensor.scaled_gyro").scaled_gyro[2]
    assert rate == pytest.approx(radians(75), rel=1e-6) and sin(rate) > 0
    host.ok(mip_3dm.SensorRange.write(2, 4))
    assert show(host.device, "sensor.overrange_status").status == 0
    assert host.refused(mip_3dm.SensorRange.write(2, 5)) == 3, "no such range"
    assert filter_data.Status.DESCRIPTOR == 0x10


def test_estimates_change_gradually() -> None:
    device = VirtualDevice(CV7)
    speeds = []
    for _ in range(100):
        device.advance(0.2)
        speeds.append(device.world.place.velocity)
    assert max(abs(a - b) for v, w in pairwise(speeds) for a, b in zip(v, w)) < 0.01
    assert max(abs(a - b) for a, b in zip(speeds[0], speeds[-1])) > 0.01, "yet they change"
