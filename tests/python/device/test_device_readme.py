"""Settings that silence commands, and the programs of the README."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest
from mip_protocol import mip_3dm, registry, types
from mip_protocol.field import Command
from mip_simulator.device import VirtualDevice
from mip_simulator.endpoints.endpoint import tcp_at
from support import ROOT, model
from test_ports import DEVICE, serving

PACKAGE = ROOT / "generated/python"


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
