"""A setting changes the data on the simulated device that the specification says it changes, and no other."""

from __future__ import annotations

from typing import Any

import pytest
from mip_protocol import base, mip_3dm
from mip_protocol import filter as commands
from mip_tools.simulator import VirtualDevice
from mip_tools.simulator.motion import Circle
from mip_tools.simulator.values import encoder
from mipgen import model as m
from simulated_world import SETS, TYPES
from simulator_host import Host
from support import model

#: Without the sets in which a device counts its packets and events.
SHOWN = [name for name in TYPES if name.split(".")[0] in ("sensor", "filter_data")]


#: The simulated device rotates the complementary filter on every device, the 3DM-GX5-15 does not.
ROTATED = {name for name in SHOWN if name.startswith("sensor.comp_")}


def shown(device: str, command: Any) -> dict[str, list[bytes]]:
    """All data of a device, a while after a command."""
    host = Host(VirtualDevice(device, motion=Circle(20, 5), seed=1, noise=0))
    host.ok(command)
    host.device.advance(30 - host.now)
    world = host.device.world
    return {name: encoder(TYPES[name], host.device.profile, world, SETS[name])() for name in SHOWN}


def stated(command: str, certain: bool) -> set[str]:
    of = model("real")
    f = of.field(command)
    assert f is not None
    found = set()
    for x in of.affected(f, certain):
        fields = of.fields_in(x) if isinstance(x, m.Set) else (x,)
        found |= {g.full_name for g in fields}
    return found


@pytest.mark.parametrize(
    ("device", "name", "command"),
    [
        ("3dm-cv7-gnss-ins", "3dm.accel_bias", mip_3dm.AccelBias.write((0.1, 0.2, 0.3))),
        ("3dm-cv7-gnss-ins", "3dm.gyro_bias", mip_3dm.GyroBias.write((0.1, 0.2, 0.3))),
        ("3dm-cv7-gnss-ins", "3dm.sensor_to_vehicle_transform_euler",
         mip_3dm.SensorToVehicleTransformEuler.write(0.1, 0.2, 0.3)),
        ("3dm-gx5-15", "filter.sensor_to_vehicle_rotation_euler",
         commands.SensorToVehicleRotationEuler.write(0.1, 0.2, 0.3)),
    ],
)  # fmt: skip
def test_what_a_setting_changes(device: str, name: str, command: Any) -> None:
    before, after = shown(device, base.Ping()), shown(device, command)
    changed = {x for x in before if before[x] != after[x]}
    assert changed, "nothing changes"
    if device == "3dm-gx5-15":
        changed -= ROTATED
    assert changed <= stated(name, True) | stated(name, False)
    simulated = {x for x in stated(name, True) if x in SHOWN}
    assert simulated <= changed
