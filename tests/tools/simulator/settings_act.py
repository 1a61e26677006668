"""Which data each setting of a virtual device changes; as a program, writes the table of docs/simulate-reference.md."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

from mip_protocol import Command, aiding, base, mip_3dm, reflection, registry
from mip_protocol import filter as commands
from mip_simulator import VirtualDevice
from mip_simulator.motion import Circle
from mip_simulator.streams.values import encoder
from mip_tools.devices import facts
from mip_tools.devices.checks import NOTHING
from mip_tools.devices.codes import SETS as FUNCTIONS
from simulated import SETS, TYPES, Host

ROOT = Path(__file__).parents[3]
PAGE = ROOT / "docs/simulate-reference.md"
HEAD = "| Setting | Tried on | Data fields that it changes |\n|---|---|---|\n"
BEGIN, NO_EFFECT, END = "<!-- settings and data -->\n", "<!-- no effect -->\n", "<!-- end -->"

CV7, GX5, AR = "3dm-cv7-gnss-ins", "3dm-gx5-45", "3dm-gx5-15"

#: Without the sets in which a device counts its packets and events.
SHOWN = [name for name in TYPES if not name.startswith(("shared.", "displacement_data."))]

TIME = aiding.MeasurementTime(timebase=aiding.Timebase(3), nanoseconds=0)


#: A device, a command, and the noise with which its effect shows.
COMMANDS: list[tuple[str, Any, float]] = [
    (CV7, mip_3dm.AccelBias.write((0.1, 0.2, 0.3)), 0),
    (CV7, mip_3dm.GyroBias.write((0.1, 0.2, 0.3)), 0),
    (CV7, mip_3dm.MagHardIronOffset.write((0.1, 0.0, 0.0)), 0),
    (CV7, mip_3dm.MagSoftIronMatrix.write((1.1, 0, 0, 0, 1, 0, 0, 0, 1)), 0),
    (AR, commands.TareOrientation.write(7), 0),
    ("3dm-gq7", mip_3dm.PpsSourceControl.write(0), 0),
    ("3dm-gq7", mip_3dm.OdometerConfig.write(2, 100.0, 0.1), 0),
    (CV7, commands.Reset(), 0),
    (CV7, commands.SetInitialHeading(1.0), 0),
    (GX5, commands.VehicleDynamicsMode.write(2), 0),
    (GX5, commands.SensorToVehicleOffset.write((1.0, 2.0, 0.0)), 0),
    (CV7, commands.ReferencePointLeverArm.write(1, (1.0, 2.0, 0.0)), 0),
    (CV7, commands.GnssSource.write(3), 1),
    (CV7, commands.AidingMeasurementEnable.write(0, False), 0),
    (CV7, commands.RelativePositionConfig.write(1, 2, (47.0, 8.0, 0.0)), 0),
    (CV7, commands.ExternalHeadingUpdate(1.6, 0.01, 1), 0),
    (CV7, aiding.LlhPosition(TIME, 1, 47.0, 8.0, 500.0, (20.0, 20.0, 20.0), 7), 0),
    (CV7, aiding.NedVelocity(TIME, 1, (1.0, 2.0, 0.0), (1.0, 1.0, 1.0), 7), 0),
    (CV7, aiding.BodyFrameVelocity(TIME, 1, (1.0, 2.0, 0.0), (1.0, 1.0, 1.0), 7), 0),
    (CV7, aiding.HeightAboveEllipsoid(TIME, 1, 501.0, 1.0, 1), 0),
    (CV7, aiding.Pressure(TIME, 1, 955.0, 0.1, 1), 0),
    (CV7, aiding.EcefPosition(TIME, 1, (4315559.0, 606465.0, 4642190.0), (20.0,) * 3, 7), 0),
    (CV7, aiding.EcefVelocity(TIME, 1, (1.0, 2.0, 0.0), (1.0, 1.0, 1.0), 7), 0),
    (CV7, commands.ExternalHeadingUpdateWithTime(0.0, 2296, 1.6, 0.01, 1), 0),
    (CV7, aiding.TrueHeading(TIME, 1, 1.6, 0.01, 1), 0),
]  # fmt: skip


@cache
def untouched(device: str, noise: float) -> dict[str, list[bytes]]:
    return after(device, base.Ping(), noise)


def changed(device: str, command: Any, noise: float) -> list[str]:
    """The data fields that this command changes."""
    before, now = untouched(device, noise), after(device, command, noise)
    return [x for x in before if before[x] != now[x]]


def after(name: str, command: Any, noise: float) -> dict[str, list[bytes]]:
    """All data of a device that runs for a second, gets a command, and runs on."""
    host = Host(VirtualDevice(name, motion=Circle(20, 5), seed=1, noise=noise))
    device = host.device
    device.advance(1)
    device.world.filter.advance()
    host.ok(command)
    encoders = {x: encoder(TYPES[x], device.profile, device.world, SETS[x]) for x in SHOWN}
    for _ in range(3):
        device.advance(0.1)
        found = {x: encode() for x, encode in encoders.items()}
    return found


#: Commands whose effects need a special state; other tests have them.
ELSEWHERE = {
    "3dm.sensor_range": "test_filter.py",
    "filter.run": "test_filter.py",
    "filter.initialization_config": "test_filter.py",
    "filter.auto_initialization_control": "test_it_waits_for_an_attitude",
    "filter.set_initial_attitude": "test_it_waits_for_an_attitude",
    "filter.heading_source": "test_filter.py",
    "filter.set_initial_attitude_from_imu": "as filter.set_initial_attitude",
    "filter.speed_measurement": "no device is known to have it",
    "filter.external_gnss_update": "as aiding.llh_position",
}


def row(device: str, command: Any, changed: list[str]) -> str:
    """The row of the table, with the fields that this device sends."""
    virtual = VirtualDevice(device)
    found: dict[str, list[str]] = {}
    for x in changed:
        if virtual.sends(SETS[x], TYPES[x].DESCRIPTOR):
            set_, _, name = x.partition(".")
            found.setdefault(set_, []).append(f"`{name}`")
    data = "<br>".join(f"{set_}: {', '.join(names)}" for set_, names in found.items())
    return f"| `{command.NAME}` | {device} | {data} |\n"


def without_effect() -> str:
    """The commands without effect on a virtual device, which only remembers their settings: a line for each set."""
    kinds = [kind for _, kind in registry.all_types() if issubclass(kind, Command)]
    silencing = {(number, descriptor) for kind in kinds for number, descriptor, _, _ in kind.SILENCED_BY}
    found: dict[str, list[str]] = {}
    for kind in kinds:
        sets = reflection.info(kind).parameters if not kind.RESPONSES else any(x in kind.REQUIRED for x in FUNCTIONS)
        effect = facts.COMMANDS.get(kind.NAME, NOTHING).effect
        if sets and not effect and (kind.SET, kind.DESCRIPTOR) not in silencing:
            found.setdefault(kind.NAME.partition(".")[0], []).append(f"`{kind.NAME.partition('.')[2]}`")
    return "".join(f"- {name}: {', '.join(names)}\n" for name, names in found.items())


def block(text: str, begin: str) -> str:
    """What is between two marks of the page."""
    return text.partition(begin)[2].partition(END)[0]


if __name__ == "__main__":
    page = PAGE.read_text("utf-8")
    table = HEAD + "".join(row(x[0], x[1], changed(*x)) for x in COMMANDS)
    for mark, text in ((BEGIN, table), (NO_EFFECT, without_effect())):
        page = page.replace(mark + block(page, mark), mark + text)
    PAGE.write_text(page, "utf-8")
