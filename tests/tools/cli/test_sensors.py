"""`mip calibrate-mag` and `mip noise`, with virtual devices whose iron and noise are known."""

from __future__ import annotations

import json
import re
from functools import cache
from math import sin, tau
from pathlib import Path
from random import Random
from struct import pack
from typing import Any

import numpy as np
import pytest
from mip_simulator import VirtualDevice
from mip_simulator.motion import Trajectory
from mip_simulator.surroundings.noise import Noise
from mip_tools.analysis import allan, ellipsoid
from mip_tools.devices.facts import NOISE
from program import mip, sent, simulated, streaming
from timed_packets import packet

IRON = (0.08, -0.05, 0.11)
SCENARIO = f"events:\n  - {{at: 0, event: magnetic_disturbance, field: [{', '.join(map(str, IRON))}]}}\n"


def tumbling(folder: Path) -> Path:
    """A motion through all attitudes."""
    path = folder / "tumble.csv"
    rows = [f"{t},0,0,0,{t * 51:.3f},{60 * sin(t * tau / 23):.3f},{t * 11.6:.3f}" for t in range(0, 90)]
    head = "time [s],north [m],east [m],down [m],roll [deg],pitch [deg],yaw [deg]"
    path.write_text("\n".join([head, *rows]), "utf-8")
    return path


def recorded(path: Path, descriptors: tuple[int, ...], seconds: int, decimation: int = 10, **world: Any) -> Path:
    device = VirtualDevice("3dm-cv7-ahrs", **world)
    device.advance(1)
    link = streaming(device, {0x80: tuple((one, decimation) for one in (0xD5, *descriptors))})
    path.write_bytes(sent(device, link, seconds))
    return path


@cache
def ball(count: int = 4000) -> Any:
    """Directions in all of space."""
    directions = np.random.default_rng(1).normal(size=(count, 3))
    return directions / np.linalg.norm(directions, axis=1)[:, None]


@pytest.mark.parametrize("soft", [True, False])
def test_an_ellipsoid_is_found(soft: bool) -> None:
    shape = np.array([[1.1, 0.05, -0.02], [0.05, 0.9, 0.03], [-0.02, 0.03, 1.0]]) if soft else np.eye(3)
    noise = np.random.default_rng(2).normal(size=(4000, 3)) * 0.001
    fit = ellipsoid.fitted(0.5 * ball() @ np.linalg.inv(shape) + IRON + noise, soft, 0.5)
    assert np.allclose(fit.offset, IRON, atol=2e-4) and np.allclose(fit.matrix, shape, atol=1e-3)
    assert fit.before > 0.05 and fit.after == pytest.approx(0.001, rel=0.2)


def test_a_pause_does_not_decide() -> None:
    stretched = ball(1000) * (0.5, 0.45, 0.55)
    paused = np.vstack([stretched, np.repeat(stretched[:1] + 0.01, 100_000, axis=0)])
    assert np.allclose(ellipsoid.fitted(paused).offset, 0, atol=5e-4)


def test_what_is_no_ellipsoid() -> None:
    plane = ball() * (1, 1, 0)
    for points in (np.ones((100, 3)), np.ones((100, 3)) + 1e-3 * ball(100), plane):
        with pytest.raises(ValueError, match="the measurements are all alike"):
            ellipsoid.sphere_centre(points)
    with pytest.raises(ValueError, match="no ellipsoid fits"):
        ellipsoid.fitted(np.vstack([ball(), 3 * ball() + 2, ball() - 4]) * (1, 1, 9))


def test_iron_of_a_log(tmp_path: Path) -> None:
    log = recorded(tmp_path / "log", (6,), 60, 20, motion=Trajectory(tumbling(tmp_path)))
    picture = tmp_path / "mag.png"
    code, out, error = mip("calibrate-mag", log, "--picture", picture)
    assert (code, error) == (0, "") and picture.read_bytes().startswith(b"\x89PNG")
    measured, after, note, hard, soft = out.splitlines()
    assert re.fullmatch(r"3000 measurements, coverage [67]\d%, field 0.48\d\d gauss", measured)
    assert re.fullmatch(r"deviation of the field strength: 0.000\d gauss before, 0.000\d gauss after", after)
    assert "--apply PORT" in note and hard.startswith("mip send PORT 3dm.mag_hard_iron_offset write ")
    assert np.allclose([float(x) for x in soft.split()[-1].split(",")], np.eye(3).ravel(), atol=2e-3)
    assert mip(*hard.replace("PORT", "--hex").split()[1:])[0] == 0


def test_a_device_is_calibrated(tmp_path: Path) -> None:
    """Also if it is mounted in another direction, and has been calibrated before."""
    (tmp_path / "scenario.yaml").write_text(SCENARIO, "utf-8")
    words = ("--motion", f"trajectory:file={tumbling(tmp_path)},loop=yes", "--scenario", f"{tmp_path}/scenario.yaml")
    with simulated("--speed", "40", *words, device="3dm-cv7-ahrs") as place:
        for setting in (
            "sensor_to_vehicle_transform_euler write 0.5 0.2 1",
            "mag_hard_iron_offset write 0.02,0.03,-0.01",
            "mag_soft_iron_matrix write 1.1,0.05,0,0.05,0.9,0,0,0,1",
        ):
            assert mip("send", place, *f"3dm.{setting}".split())[0] == 0
        code, out, error = mip("calibrate-mag", place, "--duration", "5", "--rate", "20", "--apply", "--save")
        assert code == 0 and out.endswith("\nwritten and saved\n"), error
        values = [[float(x) for x in line.split()[-1].split(",")] for line in out.splitlines()[2:4]]
        assert np.allclose(values[0], IRON, atol=0.003)
        matrix = np.array(values[1]).reshape(3, 3)
        assert np.allclose(matrix / matrix[2, 2], np.eye(3), atol=0.01)
        read = json.loads(mip("send", place, "3dm.mag_hard_iron_offset", "read", "--json")[1])
        assert list(read["response"]["offset"].values()) == pytest.approx(values[0], rel=1e-4)


def test_what_cannot_be_calibrated(tmp_path: Path) -> None:
    still = recorded(tmp_path / "still", (6,), 5)
    code, _, error = mip("calibrate-mag", still)
    assert code == 1 and error == "mip calibrate-mag: the measurements are all alike: turn the device about all axes\n"
    part = recorded(tmp_path / "part", (6,), 16, motion=Trajectory(tumbling(tmp_path)))
    code, _, error = mip("calibrate-mag", part)
    assert code == 1 and re.search(r"the measurements cover \d\d% of all directions, and 50% are needed: turn", error)
    assert "--hard-iron-only needs 25%" in error and mip("calibrate-mag", part, "--hard-iron-only")[0] == 0
    other = recorded(tmp_path / "other", (4,), 1)
    assert "has no sensor.scaled_mag; record a log" in mip("calibrate-mag", other)[2]
    assert "3DM-GX5-15 has no magnetometer" in mip("calibrate-mag", still, "--device", "3dm-gx5-15")[2]
    assert mip("calibrate-mag", still, "--save")[2] == "mip calibrate-mag: --save is for --apply\n"
    assert mip("calibrate-mag", still, "--apply")[0] == 2
    for name in ("calibrate-mag", "noise"):
        assert "'.txt' is not a known format; name a file" in mip(name, still, "--picture", "x.txt")[2]


# --------------------------------------------------------------------------- noise


def test_the_noise_of_a_log(tmp_path: Path) -> None:
    log = recorded(tmp_path / "log", (4, 5), 60)
    picture = tmp_path / "noise.svg"
    code, out, error = mip("noise", log, "--picture", picture)
    assert (code, error) == (0, "") and b"<svg" in picture.read_bytes()
    accel, gyro = (NOISE[f"measured.{name}"]["density"] for name in ("specific_force", "angular_rate"))
    for unit, true in (("µg/√Hz", accel / 9.80665 * 1e6), ("°/s/√Hz", np.degrees(gyro))):
        found = [float(x) for x in re.findall(rf"white noise (\S+) {unit}, bias instability (?:≤ )?\S+ \S+ at", out)]
        assert len(found) == 3 and found == pytest.approx([true] * 3, rel=0.1)


@pytest.mark.parametrize("dated", [500, 3700])
def test_noise_by_the_clock_of_all_packets(dated: int, tmp_path: Path) -> None:
    """The first packets have no date."""
    values = np.random.default_rng(1).normal(size=(4200, 3)) * 1e-3 - [0, 0, 1]
    stamps = [(0.5 + i / 100, 0, 0) if i < 4200 - dated else (345_600 + i / 100, 2300, 3) for i in range(4200)]
    own = [((0xD3, pack(">dHH", *time)), (0x04, pack(">3f", *value))) for time, value in zip(stamps, values)]
    (tmp_path / "log").write_bytes(b"".join(packet(0x80, *fields) for fields in own))
    assert "sensor.scaled_accel: 42 s at 100 Hz" in mip("noise", tmp_path / "log")[1]


def test_the_bias_instability_of_a_drift() -> None:
    """That of white noise and a Gauss-Markov process, whose Allan variance is known in closed form."""
    figures = NOISE["measured.angular_rate"]
    noise, step = Noise(3, Random(3), **figures), 0.5
    integrals = np.array([noise.integral(round(i * step * 1e9)) for i in range(20_000)])
    times, found = allan.deviation(np.diff(integrals, axis=0) / step, 1 / step)
    x = times / figures["period"]
    drift = 2 * figures["drift"] ** 2 / x * (1 - (3 - 4 * np.exp(-x) + np.exp(-2 * x)) / (2 * x))
    true = np.sqrt(figures["density"] ** 2 / times + drift)
    assert allan.white_noise(times, found) == pytest.approx([figures["density"]] * 3, rel=0.1)
    instabilities = [allan.bias_instability(times, axis) for axis in found.T]
    first = true[times < figures["period"]].min() / allan.FLICKER
    assert [one.value for one in instabilities] == pytest.approx([first] * 3, rel=0.1)
    assert not any(one.limit for one in instabilities)
    assert allan.bias_instability(times[:9], found[:9, 0]).limit


def test_what_is_no_noise(tmp_path: Path) -> None:
    moving = recorded(tmp_path / "moving", (4, 5), 40, motion="circle:radius=20,speed=5")
    assert mip("noise", moving)[2] == (
        "mip noise: sensor.scaled_gyro: the device moves: it measures 0.25 rad/s; record it at rest\n"
    )
    short = recorded(tmp_path / "short", (4,), 5)
    assert "sensor.scaled_accel: 5 s without a gap; 30 s are needed at least" in mip("noise", short)[2]
    assert "has no measurements of sensor.scaled_mag" in mip("noise", short, "scaled_mag")[2]
    assert "has no measurements of sensor.scaled_accel" in mip("noise", recorded(tmp_path / "mag", (6,), 1))[2]


def test_motions() -> None:
    noise = np.random.default_rng(4).normal(size=(6000, 1)) * 0.001
    assert allan.motion(noise, 100, "rad/s") == "" and allan.motion(noise + 1, 100, "g") == ""
    bumped, waving = noise.copy(), noise + np.sin(np.arange(6000) / 300)[:, None] * 0.1
    bumped[3000:3100] += 0.1
    assert allan.motion(bumped, 100, "g/s") == "moves after 30 s"
    assert allan.motion(waving, 100, "") == "moves all the time"
    assert allan.motion(noise + 1.2, 100, "g").startswith("moves: it measures 1.2 g")
