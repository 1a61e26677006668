"""Sensor noise is the same in rates and deltas, at every rate, and as large as the specification says."""

from __future__ import annotations

from math import dist, hypot, sqrt
from random import Random

import pytest
from mip_protocol import mip_3dm, sensor, types
from mip_simulator import VirtualDevice
from mip_simulator.motion import Standing
from mip_simulator.surroundings.noise import Noise
from mip_tools.devices.facts import NOISE
from simulated_world import Shown
from simulator_host import Host

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
    layout = (types.DescriptorRate(sensor.ScaledGyro.DESCRIPTOR, decimation),)
    host.ok(mip_3dm.MessageFormat.write(0x80, layout))
    device.advance(600 * decimation / 1000)
    host.data.clear()
    host.ok(mip_3dm.MessageFormat.read(0x80))
    rates = [x.scaled_gyro for x in (sensor.ScaledGyro.find(p) for p in host.data) if x is not None]
    means = [sum(axis) / len(rates) for axis in zip(*rates)]
    return sqrt(sum(hypot(*(x - m for x, m in zip(rate, means))) ** 2 for rate in rates) / len(rates) / 3)


@pytest.mark.parametrize("decimation", [1, 10, 40])
def test_noise_follows_the_rate(decimation: int) -> None:
    """The bandwidth is half the rate of the field."""
    found = spread(VirtualDevice("3dm-cv7-gnss-ins", seed=2), decimation)
    assert found == pytest.approx(NOISE[GYRO]["density"] * sqrt(1000 / decimation), rel=0.12)


def test_without_noise_there_is_none() -> None:
    assert spread(VirtualDevice("3dm-cv7-gnss-ins", noise=0), 1) == 0
