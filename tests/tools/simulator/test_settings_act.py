"""Settings act on the virtual device: each is sent to one of two equal devices, and all their data are compared."""

from __future__ import annotations

from typing import Any

import pytest
from mip_protocol import filter as commands
from mip_protocol import mip_3dm
from mip_simulator import VirtualDevice
from mip_simulator.commands.filter_effects import FILTER_EFFECTS
from mip_simulator.world import quantities
from mip_tools.devices import facts
from mipgen import model as m
from settings_act import (
    AR,
    BEGIN,
    COMMANDS,
    CV7,
    ELSEWHERE,
    NO_EFFECT,
    PAGE,
    SHOWN,
    block,
    changed,
    row,
    without_effect,
)
from simulated import Host
from support import model


def stated(command: str, *certain: bool) -> set[str]:
    """The data that a command changes (`True`), or may change (`False`), by the specification."""
    of = model("real")
    f = of.field(command)
    assert f is not None
    found = set()
    for x in (x for c in certain for x in of.affected(f, c)):
        fields = of.fields_in(x) if isinstance(x, m.Set) else (x,)
        found |= {g.name_in(number) for g in fields for number in g.sets}
    return found


@pytest.mark.parametrize(("device", "command", "noise"), COMMANDS, ids=[c.NAME for _, c, _ in COMMANDS])
def test_it_acts(device: str, command: Any, noise: float) -> None:
    """On something that the specification names, and on no other set, except for those of filters and receivers, which
    depend on everything."""
    fields = changed(device, command, noise)
    found, known = set(fields), stated(command.NAME, True, False)
    assert found & known if known else found
    assert {x.partition(".")[0] for x in found} <= {x.partition(".")[0] for x in known} | {"filter_data"}
    assert row(device, command, fields) in table(), "the table: python tests/tools/simulator/settings_act.py"


ANGLES = (0.1, 0.2, 0.3)


@pytest.mark.parametrize(
    ("device", "command"),
    [
        (CV7, mip_3dm.AccelBias.write(ANGLES)), (CV7, mip_3dm.GyroBias.write(ANGLES)),
        (CV7, mip_3dm.SensorToVehicleTransformEuler.write(*ANGLES)),
        (AR, commands.SensorToVehicleRotationEuler.write(*ANGLES)),
    ],
)  # fmt: skip
def test_biases_and_mountings_change_all_that_is_stated(device: str, command: Any) -> None:
    """And nothing else, such as the complementary filter of the 5-series; but a mounting of the 3DM-CV7 also resets its
    filter."""
    found = {x for x in changed(device, command, 0) if x.startswith(("sensor.", "filter_data."))}
    certain = {x for x in stated(command.NAME, True) if x.startswith(("sensor.", "filter_data."))}
    if isinstance(command, mip_3dm.SensorToVehicleTransformEuler):
        found -= set(changed(device, commands.Reset(), 0)) - certain
    assert certain & set(SHOWN) <= found <= stated(command.NAME, True, False)


def table() -> list[str]:
    return block(PAGE.read_text("utf-8"), BEGIN).splitlines(keepends=True)


def test_the_table_is_whole() -> None:
    """Its rows are compared where their settings are tried; there are no others."""
    assert [line.split("`")[1] for line in table()[2:]] == [command.NAME for _, command, _ in COMMANDS]


def test_every_command_with_an_effect_on_the_data_is_tried() -> None:
    """And all others are named on the page."""
    tried = {c.NAME for _, c, _ in COMMANDS} | ELSEWHERE.keys()
    assert {name for name, b in facts.COMMANDS.items() if b.effect in FILTER_EFFECTS} <= tried
    page = PAGE.read_text("utf-8")
    assert all(f"`{name}`" in page for name in ELSEWHERE)
    assert block(page, NO_EFFECT) == without_effect()


def test_it_waits_for_an_attitude() -> None:
    host = Host(VirtualDevice(AR, noise=0))
    host.ok(commands.AutoInitializationControl.write(0))
    host.ok(commands.Reset())
    host.device.advance(10)
    assert not host.device.world.filter.level
    host.ok(commands.SetInitialAttitude(0.0, 0.0, 1.0))
    assert quantities.quantity(host.device.world, "attitude.yaw") == pytest.approx(1.0, abs=1e-6)
