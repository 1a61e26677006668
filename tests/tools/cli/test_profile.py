"""`mip profile`: data from a device as a file that mipgen accepts."""

from __future__ import annotations

import os
import re
import shutil
import sys
from collections.abc import Iterable
from dataclasses import replace
from datetime import date
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from c_build import run
from mip_protocol import Device, _sets, base, devices
from mip_protocol import profile as profiles
from mip_simulator import LivePort, VirtualDevice
from mip_simulator.faults import Faults
from mip_simulator.faults.kinds import parse_faults
from mip_tools.errors import Failure
from mip_tools.ports import device_file, listing
from mipgen import model as m
from mipgen.resolve.load import load_model
from program import mip, simulated, streaming
from support import ROOT, SPECS, heavy

SPEC = SPECS["real"][0]
SETS = {number: names[0] for number, names in _sets.SETS.items()}
DAY = "2026-01-31"


def told(device: VirtualDevice) -> listing.Listing:
    with Device(LivePort(device, speed=50)) as link:
        return listing.ask(link, "PORT")


def facts(device: VirtualDevice | str) -> device_file.Facts:
    it = told_of(device) if isinstance(device, str) else told(device)
    return device_file.Facts(device_file.model(it), it, DAY)


@cache
def told_of(device_id: str) -> listing.Listing:
    return told(VirtualDevice(device_id))


def listed(device_id: str) -> set[tuple[int, int]]:
    """What the virtual device has: not what its firmware lacks."""
    return VirtualDevice(device_id).field_keys


def unknown(**changes: Any) -> profiles.Device:
    """A device that no package knows: a GQ7 with another number and name."""
    of = devices.DEVICES["3dm-gq7"]
    return replace(of, **{"title": "3DM-XY9: INS", "model_number": 6999, **changes})


def loaded(folder: Path, device_id: str) -> m.Device:
    """A device as mipgen reads it, with the folder over the specification."""
    found = load_model(SPEC, folder).device(device_id)
    assert found is not None
    return found


def put(folder: Path, device_id: str, text: str) -> Path:
    path = folder / "devices" / f"{device_id}.yaml"
    path.parent.mkdir(exist_ok=True)
    path.write_bytes(text.encode())
    return path


# --------------------------------------------------------------------------- a new file


def test_the_file_of_a_model_that_is_known() -> None:
    assert device_file.file_text(facts("3dm-mv5-ar"), SPEC.parent) == (
        "extend: 3dm-mv5-ar\n"
        "evidence:\n"
        "  - kind: listed\n"
        "    firmware: 5.0.00\n"
        "    date: 2026-01-31\n"
        "    fields:\n"
        "      base: [ping, set_idle, get_device_info, get_device_descriptors, resume]\n"
        "      3dm: [data_stream_control]\n"
    )


def test_the_file_of_a_model_that_is_not_known(tmp_path: Path) -> None:
    device = VirtualDevice(unknown())
    device.field_keys |= {(0x80, 0x7E), (0x3F, 0x01), (0x3F, 0x02)}
    it = facts(device)
    text = device_file.file_text(it, tmp_path)
    assert text.startswith(
        "device: 3dm-xy9-ins\n"
        "name: xy9_ins\n"
        'title: "3DM-XY9: INS"\n'
        "model_number: 6999\n"
        "description: Device with the model number 6999.\n"
        "incomplete: [Only what the device itself reported is known.]\n"
        "evidence:\n"
        "  - kind: listed\n"
    )
    assert "    undefined:\n      0x3F: [0x01, 0x02]\n      sensor: [0x7E]\n" in text
    put(tmp_path, "3dm-xy9-ins", text)
    made = loaded(tmp_path, "3dm-xy9-ins")
    assert {(s.set, s.field.descriptor) for s in made.certain} == listed("3dm-gq7")
    assert not made.likely and not made.assumed and made.incomplete and made.model_number == 6999
    assert [e.undefined for e in made.evidence] == [((0x3F, 0x01), (0x3F, 0x02), (0x80, 0x7E))]
    assert made.ports == ()  # it has no command that reads the protocols
    assert made.evidence[0].note == "Main was set to 115200 Bd."


def test_ports_of_a_model_that_is_not_known(tmp_path: Path) -> None:
    of = devices.DEVICES["3dm-cv7-gnss-ins"]
    device = VirtualDevice(replace(of, title="3DM-XY8", model_number=6998))
    put(tmp_path, "3dm-xy8", device_file.file_text(facts(device), tmp_path))
    made = loaded(tmp_path, "3dm-xy8")
    assert {p.id: p.name for p in made.ports} == {p.id: p.name for p in of.ports}
    (first,) = (p for p in made.ports if p.name == "UART 1")
    assert first.baud_rates == (115200,) and {*first.receives} >= {"MIP"} and {*first.sends} >= {"MIP"}
    (closed,) = (p for p in made.ports if p.name == "UART 2")
    assert (closed.receives, closed.sends) == ((), ())  # as they were set
    assert {r.set.number: r.hertz for r in made.base_rates} == {**of.base_rates, 0x93: 0, 0x94: 0}
    assert "UART 2 is listed with the settings that it had." in made.certain[0].evidence.note


@pytest.mark.parametrize(
    ("title", "number", "device_id", "shown"),
    [
        ("3DM-GQ7-GNSS/INS", 6284, "3dm-gq7", "3DM-GQ7-GNSS/INS"),
        ("Something", 6284, "3dm-gq7", "3DM-GQ7-GNSS/INS"),  # the number says what it is
        ("3DM-GQ7-GNSS/INS", 6997, "3dm-gq7-gnss-ins-6997", "3DM-GQ7-GNSS/INS (6997)"),  # another device of this name
        ("3dm-gx5-25", None, "3dm-gx5-25", "3DM-GX5-25"),
        ("  ", 6997, "model-6997", "Model 6997"),
        ("\x00\x07Ä 1", None, "1", "Ä 1"),
    ],
)
def test_which_model_it_is(title: str, number: int | None, device_id: str, shown: str) -> None:
    info = base.BaseDeviceInfo(1202, title, f"{number or 0:04}-4220", "0000.12345", "", "")
    found = device_file.model(listing.Listing(info, ()))
    assert (found.id, found.title) == (device_id, shown)
    assert listing.Listing(info, ()).firmware == "1.2.02"


def test_rates_that_a_device_does_not_tell(tmp_path: Path) -> None:
    """They are not known, unless the profile of the package has them."""
    device, known = VirtualDevice(unknown()), VirtualDevice("3dm-gq7")
    for one in (device, known):
        one.field_keys -= {(0x0C, 0x0E)}
    text = device_file.file_text(facts(device), tmp_path)
    names = ("sensor", "filter_data", "gnss_1", "gnss_2", "gnss_corrections", "system_data")
    assert f"\nbase_rates: {{{', '.join(f'{name}: ~' for name in names)}}}\n" in text
    put(tmp_path, "3dm-xy9-ins", text)
    assert loaded(tmp_path, "3dm-xy9-ins").base_rates == ()
    missing = {SETS[n] for n in {s for s, _ in known.field_keys if 0x80 <= s < 0xFF} - known.profile.base_rates.keys()}
    assert facts(known).rates() == dict.fromkeys(missing)


def test_shared_data_that_is_listed_in_data_sets() -> None:
    """As devices do: 0x80D3 and 0x82D3, and not 0xFFD3."""
    device = VirtualDevice("3dm-gq7")
    own = {key for key in device.field_keys if key[0] != 0xFF}
    device.field_keys = frozenset(own | {(0x80, 0xD3), (0x82, 0xD3), (0x01, 0xF1), (0x01, 0x81)})
    it = facts(device)
    assert it.fields()["shared"] == ["gps_timestamp"] and not it.undefined()
    assert "Shared data is listed in 0x80, 0x82 only." in it.note()
    assert "get_device_info_response" not in it.fields()["base"]


# --------------------------------------------------------------------------- a file that is there


def wholes() -> Iterable[str]:
    """The devices that have a file of their own in the specification."""
    return [p.stem for p in sorted(SPEC.glob("devices/*.yaml")) if f"\ndevice: {p.stem}\n" in p.read_text("utf-8")]


def test_a_file_beside_another(tmp_path: Path) -> None:
    """The list of each firmware is in a file of its own, and mipgen accepts all of them beside what people wrote."""
    spec = tmp_path / "spec"
    shutil.copytree(SPEC, spec)
    found = list(wholes())
    assert len(found) > 5
    for device_id in found:
        it = facts(device_id)
        path = device_file.place(it, spec)
        assert path == spec / f"devices/{device_id}-{it.listing.firmware}.yaml"
        path.write_text(device_file.file_text(it, spec), "utf-8")
        with pytest.raises(Failure, match=re.escape(f"{path} has the list of firmware {it.listing.firmware}; ")):
            device_file.place(it, spec)
    made = load_model(spec)
    for device_id in found:
        of, kept = made.device(device_id), devices.DEVICES[device_id]
        assert of is not None and {(s.set, s.field.descriptor) for s in of.certain} == kept.fields, device_id
        assert {r.set.number: r.hertz for r in of.base_rates}.items() >= kept.base_rates.items(), device_id


def test_a_further_firmware_of_a_model_that_is_not_known(tmp_path: Path) -> None:
    it = facts(VirtualDevice(unknown()))
    first = device_file.place(it, tmp_path)
    put(tmp_path, first.stem, device_file.file_text(it, tmp_path))
    with pytest.raises(Failure, match=re.escape(f"{first} has the list of firmware 7.0.00; ")):
        device_file.place(it, tmp_path)
    later = replace(it, listing=replace(it.listing, info=replace(it.listing.info, firmware_version=7001)))
    further = device_file.place(later, tmp_path)
    assert (first.name, further.name) == ("3dm-xy9-ins.yaml", "3dm-xy9-ins-7.0.01.yaml")
    text = device_file.file_text(later, tmp_path)
    put(tmp_path, further.stem, text)
    assert text.startswith("extend: 3dm-xy9-ins\nevidence:\n  - kind: listed\n    firmware: 7.0.01\n")
    assert loaded(tmp_path, "3dm-xy9-ins").certain


def test_a_device_of_another_file_is_extended(tmp_path: Path) -> None:
    """One that the specification knows and the package does not, yet."""
    put(tmp_path, "mine", "devices:\n  - device: 3dm-xy9-ins\n    name: xy9\n    title: XY9\n    description: Mine.\n")
    assert device_file.file_text(facts(VirtualDevice(unknown())), tmp_path).startswith("extend: 3dm-xy9-ins\n")


# --------------------------------------------------------------------------- the device


def test_the_streams_go_on(monkeypatch: pytest.MonkeyPatch) -> None:
    """After all questions, after an interrupt, and after an error."""
    device = VirtualDevice("3dm-cv7-gnss-ins")
    device.disconnect(streaming(device, {0x80: ((0x04, 10),)}))
    idle = []
    asked = listing._Questions.listing

    def watched(self: Any) -> Any:
        idle.append(device.idle)
        return asked(self)

    monkeypatch.setattr(listing._Questions, "listing", watched)
    told(device)
    assert idle == [True] and not device.idle and device.busy

    def interrupted(self: Any, profile: Any) -> Any:
        raise KeyboardInterrupt

    monkeypatch.setattr(listing._Questions, "_ports", interrupted)
    with pytest.raises(KeyboardInterrupt):
        told(device)
    assert idle == [True, True] and not device.idle and device.busy
    device.field_keys -= {(0x01, 0x04), (0x01, 0x06)}
    said: list[str] = []
    with pytest.raises(Failure), Device(LivePort(device, speed=50)) as link:
        listing.ask(link, "PORT", said.append)
    assert said == ["PORT did not acknowledge base.resume, so it may be idle; send it again"] and device.idle
    device.field_keys |= {(0x01, 0x06)}
    with pytest.raises(Failure, match=r"the device refused base\.get_device_descriptors: unknown_command") as caught:
        told(device)
    assert caught.value.status == 3 and not device.idle and device.busy


def test_an_answer_that_is_missing_is_reported() -> None:
    device = VirtualDevice("3dm-gx5-15", faults=Faults(plans=parse_faults("lose_answer@6")))
    said: list[str] = []
    with Device(LivePort(device, speed=50), timeout=1.0) as link:
        it = listing.ask(link, "PORT", said.append)
    missing = "3dm.get_imu_base_rate"
    assert said == [f"the device has not answered {missing} in time; the data of {missing} is left out"]
    assert it.base_rates == {0x82: 500} and len(it.descriptors) == len(device.field_keys)


@pytest.fixture(scope="module")
def place() -> Iterable[str]:
    with simulated("--seed", "54321", device="3dm-gq7") as found:
        yield found


def test_command_line(place: str, tmp_path: Path) -> None:
    path = tmp_path / "devices/3dm-gq7.yaml"
    code, out, error = mip("profile", place, "--spec", tmp_path, "--dry-run")
    assert (code, error) == (0, "") and not path.parent.exists()
    assert "54321" in mip("send", place, "base.get_device_info")[1]
    assert "54321" not in out and f"    date: {date.today().isoformat()}\n" in out
    code, said, error = mip("profile", place, "--spec", tmp_path, extras=False)
    assert (code, error) == (0, "") and path.read_text("utf-8") == out
    number = len(listed("3dm-gq7"))
    title = "3DM-GQ7-GNSS/INS, firmware 7.0.00"
    assert said == f"{path}: {title}: {number} commands and data fields, 0 undefined descriptors\n"
    error = f"mip profile: {path} has the list of firmware 7.0.00; --dry-run prints it as it is now\n"
    assert mip("profile", place, "--spec", tmp_path) == (1, "", error)
    code, out, error = mip("profile", place, "--spec", tmp_path, "--dry-run", "--device", "3dm-gx5-45")
    assert code == 0 and out.startswith("extend: 3dm-gx5-45\n")
    assert "device 3DM-GX5-45 (named), although it is a 3DM-GQ7-GNSS/INS at the port\n" in error


def test_what_cannot_be(place: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    missing = tmp_path / "missing"
    error = f"mip profile: {missing} is not a folder; create it, or name another one with --spec\n"
    assert mip("profile", place, "--spec", missing) == (1, "", error)
    path = put(tmp_path, "3dm-gq7", "extend: 3dm-gq7\n")
    further = path.with_name("3dm-gq7-7.0.00.yaml")

    def full(*_: object) -> None:
        raise OSError(28, os.strerror(28))

    monkeypatch.setattr(os, "replace", full)
    code, out, error = mip("profile", place, "--spec", tmp_path)
    assert (code, out) == (1, "") and error == f"mip profile: {further} cannot be written: No space left on device\n"
    assert [*path.parent.iterdir()] == [path]


# --------------------------------------------------------------------------- there and back

ALL = list(devices.DEVICES)
FEW = ["3dm-cv7-gnss-ins", "3dm-gx4-25"]

AGAIN = """\
import sys
from pathlib import Path
from mip_protocol import Device, devices
from mip_tools.ports import device_file, listing
from mip_simulator import LivePort, VirtualDevice
from mip_tools.devices.profiles import certain

out = Path(sys.argv[1])
for id in sys.argv[2:]:
    device = VirtualDevice(certain(devices.DEVICES[id]))
    with Device(LivePort(device, speed=50)) as link:
        told = listing.ask(link, "PORT")
    ports = sorted(told.ports, key=lambda port: port.id)
    print(id, sorted(told.descriptors), sorted(told.base_rates.items()), ports, sep="|")
"""


@pytest.mark.parametrize("ids", [pytest.param(FEW, id="few"), pytest.param(ALL, id="all", marks=heavy("all models"))])
def test_there_and_back(tmp_path: Path, ids: list[str]) -> None:
    """A device is queried, mipgen generates a package with the result, and a device of this package is queried: it has
    the same for certain. The devices of the first package have yes, likely and assumed together."""
    over, package = tmp_path / "over", tmp_path / "package"
    over.mkdir()
    first = {}
    for device_id in ids:
        it = facts(device_id)
        assert it.model.id == device_id and {*it.listing.descriptors} == listed(device_id)
        first[device_id] = it.listing
        put(over, device_id, device_file.file_text(it, over))
    words = ["generate", "--spec", SPEC, "--spec", over, "--target", "python", "--out", package]
    words += [word for device_id in ids if ids == FEW for word in ("--device", device_id)]
    run(sys.executable, "-m", "mipgen", *words, PYTHONPATH=str(ROOT / "generator"))
    folders = os.pathsep.join((str(ROOT / "tools"), str(package / "python")))
    lines = run(sys.executable, "-c", AGAIN, over, *ids, PYTHONPATH=folders).splitlines()
    second = {line.split("|")[0]: line.split("|")[1:] for line in lines}
    wanted = {}
    for device_id, t in first.items():
        parts = (sorted(t.descriptors), sorted(t.base_rates.items()), sorted(t.ports, key=lambda p: p.id))
        wanted[device_id] = [*map(str, parts)]
    assert second == wanted
