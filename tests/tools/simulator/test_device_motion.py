"""The world inside the virtual device: how settings change what its streams show of it."""

from __future__ import annotations

from math import dist, hypot, pi
from typing import Any

import pytest
from mip_protocol import filter_data, mip_3dm, sensor, types
from mip_simulator import VirtualDevice
from mip_simulator.motion import Circle, Standing
from simulator_host import Host


def format_of(set_number: int, *fields: tuple[Any, int]) -> Any:
    return mip_3dm.MessageFormat.write(
        set_number, tuple(types.DescriptorRate(kind.DESCRIPTOR, n) for kind, n in fields)
    )


def received(host: Host, kind: Any, seconds: float) -> list[Any]:
    host.device.advance(seconds)
    host.data.clear()
    host.ok(mip_3dm.MessageFormat.read(0x80))
    return [found for found in (kind.find(p) for p in host.data) if found is not None]


def mean(values: list[Any]) -> list[float]:
    return [sum(column) / len(values) for column in zip(*values)]


def test_a_captured_bias_is_removed() -> None:
    """What is left is noise: 87e-6 rad/s over a second."""
    host = Host(VirtualDevice("3dm-cv7-gnss-ins", motion=Standing()))
    host.ok(format_of(0x80, (sensor.ScaledGyro, 1)))
    before = mean([x.scaled_gyro for x in received(host, sensor.ScaledGyro, 1)])
    bias = host.ok(mip_3dm.CaptureGyroBias(1000)).bias
    assert hypot(*bias) > 1e-4 and dist(before, bias) < 2e-4
    assert host.ok(mip_3dm.GyroBias.read()).bias == bias
    received(host, sensor.ScaledGyro, 0.01)
    assert hypot(*mean([x.scaled_gyro for x in received(host, sensor.ScaledGyro, 1)])) < 2e-4
    host.ok(mip_3dm.GyroBias.default())
    received(host, sensor.ScaledGyro, 0.01)
    assert dist(mean([x.scaled_gyro for x in received(host, sensor.ScaledGyro, 1)]), before) < 2e-4


def test_a_bias_that_is_set_is_subtracted() -> None:
    host = Host(VirtualDevice("3dm-cv7-gnss-ins", motion=Standing()))
    host.ok(format_of(0x80, (sensor.ScaledAccel, 10)))
    before = mean([x.scaled_accel for x in received(host, sensor.ScaledAccel, 1)])
    host.ok(mip_3dm.AccelBias.write((9.80665, 0.0, -9.80665)))
    received(host, sensor.ScaledAccel, 0.01)
    after = mean([x.scaled_accel for x in received(host, sensor.ScaledAccel, 1)])
    assert dist(before, [a + b for a, b in zip(after, (1, 0, -1))]) < 2e-3
    host.device.reset()
    host.device.advance(5)
    assert host.device.world.accel_bias == (0, 0, 0), "it was not saved"


def test_the_mounting_turns_what_is_sent() -> None:
    """A sensor that is turned by 90 degrees about the vertical."""
    host = Host(VirtualDevice("3dm-cv7-gnss-ins", motion=Circle(20, 5)))
    host.ok(format_of(0x82, (filter_data.LinearAccel, 10), (filter_data.EulerAngles, 10)))
    plain = received(host, filter_data.LinearAccel, 1)[-1].accel
    assert dist(plain, (0, 25 / 20, 0)) < 0.03, "to the right, where the centre is"
    host.ok(mip_3dm.SensorToVehicleTransformEuler.write(0.0, 0.0, pi / 2))
    turned = received(host, filter_data.LinearAccel, 1)[-1].accel
    assert dist((abs(turned[0]), turned[1], turned[2]), (25 / 20, 0, 0)) < 0.03


@pytest.mark.parametrize("steps", [1, 7, 100])
def test_time_may_be_cut_in_any_way(steps: int) -> None:
    """The same bytes, noise and integrals included."""

    def run(pieces: int, seed: int = 3) -> bytes:
        host = Host(VirtualDevice("3dm-cv7-gnss-ins", motion=Circle(), seed=seed))
        host.ok(format_of(0x80, (sensor.ScaledAccel, 10), (sensor.DeltaTheta, 20), (sensor.ScaledPressure, 50)))
        read = bytearray()
        for _ in range(pieces):
            host.device.run_until(host.device.now + 2_000_000_000 // pieces)
            read += host.link.read()
        return bytes(read)

    whole, cut = run(1), run(steps)
    assert len(cut) > 2000 and cut == whole[: len(cut)] != run(1, 4)[: len(cut)]
