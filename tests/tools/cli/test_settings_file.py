"""`mip config`: whatever settings a virtual device has, another one has them too after a file has carried them over."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

import pytest
from mip_protocol import Device, devices
from mip_simulator import LivePort, VirtualDevice
from mip_tools.configuration import parsed, talk
from mip_tools.configuration.written import file_text
from mipgen import model as m
from mipgen.lower import codec
from support import PATIENCE, heavy, model
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


#: Settings that a device has in a form of its own: a rotation that was written as a matrix is read as a quaternion.
ROUNDED = ("transform", "rotation")


def kept(virtual: VirtualDevice) -> dict[Any, Any]:
    return {place: value for place, value in virtual.settings.items() if place[0] not in LEFT_OUT}


#: The devices that `make test` samples: of each generation, with few settings and with many.
SAMPLE = ("3dm-cv7-gnss-ins", "3dm-gx5-45", "3dm-gq7", "3dm-gx3-35", "3dm-mv5-ar")
#: A device, and which third of the values it has; one of the sample has all.
CASES = [*((SAMPLE[0], only) for only in range(3)), *((device_id, i % 3) for i, device_id in enumerate(SAMPLE[1:]))]
ALL = [(device_id, only) for device_id in sorted(devices.DEVICES) for only in range(3)]


@pytest.mark.parametrize(
    ("device_id", "only"), [*CASES, *(pytest.param(*x, marks=heavy("all models")) for x in ALL if x not in CASES)]
)
def test_all_settings_of_a_device(tmp_path: Path, device_id: str, only: int) -> None:
    found = model("real").device(device_id)
    assert found is not None
    first, second = VirtualDevice(device_id), VirtualDevice(device_id)
    names = told(found, first, only)
    assert names or only or not settable(found)
    path = tmp_path / "settings.yaml"
    path.write_text(pulled(first))
    done = pushed(second, path)
    assert not done.refused and not done.read_differently
    assert pulled(second) == path.read_text()
    for place, value in kept(first).items():
        if not any(word in place[0] for word in ROUNDED):
            assert second.settings.current(value) == value, place


def test_what_acts_only_once_is_no_setting() -> None:
    virtual = VirtualDevice("3dm-gx5-25")
    assert virtual.knows("filter.tare_orientation") and "tare_orientation" not in pulled(virtual)
