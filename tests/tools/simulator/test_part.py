"""The virtual device in packages of a part of the specification, and of another one."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest
from c_build import run
from mipgen import cli
from support import ROOT, SPECS, model


def path(package: Path) -> dict[str, str]:
    """The environment of a program that uses the tools on top of this package."""
    return {"PYTHONPATH": os.pathsep.join((str(ROOT / "tools"), str(package)))}


#: Sends every command with several functions, requests data, and prints the replies.
CONVERSATION = """
import sys
from mip_protocol import PacketBuilder, registry
from mip_simulator import VirtualDevice

device = VirtualDevice(sys.argv[1])
link = device.connect()
data = [set for set, _ in sorted(device.profile.fields) if 0x80 <= set < 0xFF]
for number, descriptor in sorted(x for x in device.profile.fields if x[0] < 0x80 and x[1] < 0x80):
    for function in (1, 2, 5, 2):
        for rest in (bytes(20), bytes((1, 4, 0, 10)), bytes((data[0], 1, 4, 0, 10))):
            builder = PacketBuilder(number)
            builder.add(descriptor, bytes((function,)) + rest)
            link.write(bytes(builder.build()))
            device.advance(0.1)
            answer = link.read()
            for _ in range(40):  # seconds that a command may take
                if not answer:
                    device.advance(1.0)
                    answer = link.read()
            print(number, descriptor, function, answer.hex())
"""


@pytest.mark.parametrize("device", ["3dm-gx5-15", "3dm-gx5-45"])
def test_it_does_what_it_does_in_the_whole_package(device: str, tmp_path: Path) -> None:
    """Even for settings that are stored by a command which this device does not have."""
    part = ["generate", "--spec", str(ROOT / "spec"), "--out", str(tmp_path), "--target", "python", "--device", device]
    assert cli.main(part) == 0
    whole, alone = (
        run(sys.executable, "-c", CONVERSATION, device, **path(package)).splitlines()
        for package in (ROOT / "generated/python", tmp_path / "python")
    )
    assert whole == alone
    assert any(line.count("756580") > 1 for line in whole)  # data are streamed


def test_data_of_any_form() -> None:
    """Fields that the simulation does not describe show their defaults, be they texts, unions or counted arrays."""
    code = """
from mip_protocol import Parser, devices, registry
from mip_simulator import VirtualDevice
from mip_tools.devices.facts import VALUES

for name in devices.DEVICES:
    device = VirtualDevice(name)
    link = device.connect()
    for set, descriptor in sorted(x for x in device.profile.fields if 0x80 <= x[0] < 0xFF):
        kind = registry.types(set, descriptor)[0]
        if kind.NAME not in VALUES:
            device.send_data(set, [descriptor])
            (field,) = [f for p in Parser().feed(link.read()) for f in p]
            assert kind.decode(field.data).encode() == field.data
            print(kind.NAME)
"""
    names = run(sys.executable, "-c", code, **path(SPECS["invented"][1] / "python")).split()
    forms = {p.kind for f in model("invented").fields if f.full_name in names for p in f.parameters}
    assert len(forms) > 3, forms


def test_commands_of_any_form() -> None:
    """Every command of another specification has an answer, or none; it does not end the device."""
    code = """
from mip_protocol import PacketBuilder, devices
from mip_simulator import VirtualDevice

for name in devices.DEVICES:
    device = VirtualDevice(name)
    link = device.connect()
    for number, descriptor in sorted(x for x in device.profile.fields if x[0] < 0x80 and x[1] < 0x80):
        for data in [bytes((function,)) + rest for function in range(7) for rest in (b"", bytes(30), b"\\\\1" * 30)]:
            builder = PacketBuilder(number)
            builder.add(descriptor, data)
            link.write(bytes(builder.build()))
            device.advance(3)
        print(number, descriptor, len(link.read()))
"""
    assert run(sys.executable, "-c", code, **path(SPECS["invented"][1] / "python"))
