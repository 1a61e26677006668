"""Virtual devices with settings of all kinds, and files that carry them over."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import pytest
from mip_protocol import Device
from mip_tools.configuration import parsed, talk
from mip_tools.configuration.written import file_text
from mip_tools.simulator import LivePort, VirtualDevice
from mipgen import model as m
from mipgen.lower import codec
from support import PATIENCE, model
from virtual.commands import commands, trials

#: Settings that no file has: actions, values that all select an instance, and what ends the conversation.
LEFT_OUT = {"filter.tare_orientation", "3dm.data_stream_format"}
ENDS = {"system.comm_mode", "system.interface_control"}


def settable(device: m.Device) -> list[m.Support]:
    """The commands that can be written, read and saved; a demodulator has none."""

    def letters(functions: Iterable[m.Function]) -> set[str]:
        return {f.letter for f in functions}

    return [
        support
        for support in commands(device)
        if {"W", "R"} <= letters(support.functions)
        and "S" in letters(support.field.functions)
        and support.field.full_name not in LEFT_OUT | ENDS
    ]


def told(device: m.Device, virtual: VirtualDevice, only: int) -> set[str]:
    """Writes values of every command that can be written, read and saved; of each, every `only`-th good one."""
    link = virtual.connect()
    virtual.idle = True
    names = set()
    for support in settable(device):
        f = support.field
        every = next((dict(b.all) for b in model("real").simulation.behaviors if b.command is f), {})
        written = [t for t in trials(support, device) if t.good and t.function and t.function.letter == "W"]
        good = [t for t in written if not any(t.values[name] == number for name, number in every.items())]
        for trial in good[only::3]:
            data = codec.encode(f, trial.values)
            link.write(codec.build(model("real"), support.set, [(f.descriptor, data)]))
            virtual.advance(0.02)
            names.add(f.full_name)
    virtual.disconnect(link)
    virtual.idle = False
    return names


def pulled(virtual: VirtualDevice) -> str:
    with Device(LivePort(virtual, speed=20), timeout=PATIENCE) as link:
        it = talk.Talk(link, "PORT", pytest.fail)
        return file_text(it.pull(), it.profile, it.model.id, it.listing.firmware, "2026-01-31")


def pushed(virtual: VirtualDevice, path: Path) -> talk.Pushed:
    with Device(LivePort(virtual, speed=20), timeout=PATIENCE) as link:
        it = talk.Talk(link, "PORT", pytest.fail)
        return it.push(parsed.parsed_settings(path, it.profile).commands)
