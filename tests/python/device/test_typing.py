"""What type checkers know about the answers of commands, and the programs of the README."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from mip_protocol import mip_3dm, registry, types
from mip_protocol.field import Command
from mip_tools.simulator.device import VirtualDevice
from mip_tools.simulator.endpoints import tcp_at
from support import ROOT, model, mypy
from test_ports import DEVICE, serving

PACKAGE = ROOT / "generated/python"

CHECKED = """
from typing_extensions import assert_type
from mip_protocol import Arrival, Command, Data, Device, Response, aio, base, gnss_data, mip_3dm, sensor
from mip_protocol.base import GpsTimeUpdateTowResponse, GpsTimeUpdateWeekNumberResponse

def requests(device: Device, some: Command, kind: base.GpsTimeUpdate) -> None:
    assert_type(device.request(base.Ping()), None)
    assert_type(device.request(base.GetDeviceInfo()), base.GetDeviceInfoResponse)
    assert_type(device.request(base.CommSpeed.read(1)), base.CommSpeedResponse)
    assert_type(device.request(base.CommSpeed.write(1, 115200)), None)
    assert_type(device.request(base.CommSpeed.save(1)), None)
    assert_type(device.request(kind), Response | None)
    assert_type(device.request(some), Response | None)
    assert_type(
        device.request(base.GpsTimeUpdate.read(base.GpsTimeField.TOW)),
        GpsTimeUpdateWeekNumberResponse | GpsTimeUpdateTowResponse,
    )
    assert_type(
        device.request_all(mip_3dm.GetBaseRate(0x80), base.Ping(), base.CommSpeed.read(1)),
        tuple[mip_3dm.GetBaseRateResponse, None, base.CommSpeedResponse],
    )
    commands: list[Command] = [base.Ping(), base.CommSpeed.read(1)]
    device.exchange(*commands)
    for arrival in device:
        assert_type(arrival, Arrival)
        assert_type(arrival.find(sensor.ScaledAccel), sensor.ScaledAccel | None)
    for time, accel in device.fields(sensor.ScaledAccel):
        assert_type(time, float)
        assert_type(accel, sensor.ScaledAccel)
    for _, field in device.fields(sensor.ScaledAccel, sensor.ScaledGyro):
        assert_type(field, sensor.ScaledAccel | sensor.ScaledGyro)
    kinds: list[type[Data]] = [sensor.ScaledAccel, sensor.ScaledGyro]
    for _, any_field in device.fields(*kinds):
        assert_type(any_field, Data)

async def asynchronous(device: aio.Device) -> None:
    assert_type(await device.request(base.GetDeviceInfo()), base.GetDeviceInfoResponse)
    assert_type(
        await device.request_all(mip_3dm.GetBaseRate(0x80), base.Ping()), tuple[mip_3dm.GetBaseRateResponse, None]
    )
    async for arrival in device:
        assert_type(arrival, Arrival)
    async with aio.open_port("socket://localhost:5000") as other:
        assert_type(other, aio.Device)
    assert_type(await aio.open_port("socket://localhost:5000"), aio.Device)
    async for _, accel in other.fields(sensor.ScaledAccel):
        assert_type(accel, sensor.ScaledAccel)
    async for _, field in other.fields(sensor.ScaledAccel, sensor.ScaledGyro, gnss_data.SatelliteStatus):
        assert_type(field, sensor.ScaledAccel | sensor.ScaledGyro | gnss_data.SatelliteStatus)
"""


def test_the_answer_of_a_command_is_known_to_type_checkers(tmp_path: Path) -> None:
    right, wrong = tmp_path / "right.py", tmp_path / "wrong.py"
    right.write_text(CHECKED, encoding="utf-8")
    wrong.write_text(CHECKED.replace("base.Ping()), None)", "base.Ping()), int)"), encoding="utf-8")
    said = mypy(PACKAGE, "--python-version", "3.10", right, wrong).stdout
    assert re.findall(r"(\w+)\.py:\d+: error: Expression is of type", said) == ["wrong"], said
    assert "Found 1 error " in said, said


def test_settings_that_silence_are_those_of_the_specification() -> None:
    of = model("real")
    known = {kind.NAME: kind for _, kind in registry.all_types() if issubclass(kind, Command)}
    for f in of.fields:
        if f.role == "command":
            wanted = [(of.field(c.command or ""), c) for c in f.silenced_by]
            found = known[f.full_name].SILENCED_BY
            assert [(s.set, s.descriptor, c.parameter, c.value) for s, c in wanted if s] == list(found)
            for number, descriptor, member, _ in found:
                (setting,) = registry.types(number, descriptor)
                assert member in setting.__annotations__


def blocks() -> list[str]:
    section = (PACKAGE / "README.md").read_text("utf-8").split("## A device")[1].split("\n## ")[0]
    return [part.split("```")[0] for part in section.split("```python\n")[1:]]


@pytest.mark.parametrize("number", [0, 1])
def test_the_programs_of_the_readme(number: int) -> None:
    program = blocks()[number]
    virtual = VirtualDevice(DEVICE)
    link = virtual.connect()
    if number == 1:  # it reads what the device already sends
        link.write(bytes(mip_3dm.MessageFormat.write(0x80, (types.DescriptorRate(0x04, 100),)).packet()))
        link.write(bytes(mip_3dm.DataStreamControl.write(0x80, True).packet()))
    with serving(virtual, tcp_at("localhost:0")) as (url,):
        opened = '"/dev/ttyACM0"' if number == 0 else '"socket://localhost:5000"'
        assert opened in program
        process = subprocess.Popen(
            [sys.executable, "-uc", program.replace(opened, repr(url))], stdout=subprocess.PIPE, text=True,
            env={**os.environ, "PYTHONPATH": str(PACKAGE), "PYTHONDONTWRITEBYTECODE": "1"},
        )  # fmt: skip
        assert process.stdout is not None
        try:
            lines = [process.stdout.readline() for _ in range(4)]
        finally:
            process.terminate()
            process.communicate()
    assert lines[0].strip() == "3DM-CV7-GNSS/INS"
    assert all("-1.0" in line or "-0.99" in line for line in lines[1:]), lines
