"""The Python package as its users see it: constructors, accessors, errors, parser, client, vendoring."""

from __future__ import annotations

import os
import pickle
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from mipgen import model as m
from mipgen.emit import output, render
from mipgen.facts import describe
from mipgen.resolve.load import load_model
from mipgen.targets.python import names
from packages import INVENTED, REAL, Package, mip, real
from spec_defaults import filled
from support import ROOT, SPECS, all_fields, another_python, heavy, model, mypy, packaging, parse_as


def user(folder: Path, code: str, python: str = sys.executable, **environment: str) -> str:
    """Runs a program as a user would, with the package on its path."""
    done = subprocess.run(
        [python, "-c", code], capture_output=True, text=True, cwd="/",
        env={**os.environ, "PYTHONPATH": str(folder), "PYTHONDONTWRITEBYTECODE": "1", **environment},
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    return done.stdout


# --------------------------------------------------------------------------- types


def test_unknown_values_survive() -> None:
    mode = mip.types.Mode(77)
    assert mode == 77 and mode.name == "UNKNOWN_77" and isinstance(mode, mip.types.Mode)
    flags = mip.types.StateFlags(0xFFFF)
    assert int(flags & ~mip.types.StateFlags.READY) == 0xFFFE
    assert int(flags.with_level(0)) == 0xFF8F
    with pytest.raises(mip.errors.EncodeError, match="3 bits"):
        flags.with_level(8)
    assert flags.mode == 3 and isinstance(flags.mode, mip.types.Mode)
    rest = ~mip.types.StateFlags.READY
    assert int(rest) == 0xFFFE and isinstance(rest, mip.types.StateFlags) and ~rest == mip.types.StateFlags.READY


# --------------------------------------------------------------------------- constructors


def test_constructors_build_the_shortest_form() -> None:
    settings, mode = mip.tools.Settings, mip.types.Mode
    assert settings.write(1, mode.SLOW, 9600).encode().hex() == "01010200002580"
    assert settings.write(1, mode.SLOW, 9600, limit=5).encode().hex() == "010102000025800005"
    assert settings.read(1, mode.FAST).encode().hex() == "020101"
    assert settings.save(1).encode().hex() == "0301"
    assert settings.load(0).encode().hex() == "0400"
    assert settings.default(2).encode().hex() == "0502"
    assert settings.apply(1, mode.FAST, 1).encode().hex() == "06010100000001"
    assert not settings.apply(1, mode.FAST, 1).answered and settings.save(1).answered


def test_complaints_have_the_path_and_the_type() -> None:
    """None of them is one of the module `struct`."""
    dm, types, sensor, tools, data = real.mip_3dm, real.types, real.sensor, mip.tools, mip.measurements
    zero = mip.types.Point(0, 0)
    arrays = ((zero, zero), mip.types.Segment(zero, zero, (0, 0)))
    rates = (types.DescriptorRate(4, 1), types.DescriptorRate(4, 1))
    rates[1].decimation = 70000  # a part that was changed after it was made
    for make, text in (
        (lambda: dm.MessageFormat.write(0x80, rates), "range: descriptors[1].decimation is 70000, needs 0 to 65535"),
        (lambda: dm.MessageFormat.write(0x80, (rates[0], 4)), "range: descriptors[1] is 4, needs a DescriptorRate"),
        (lambda: dm.MessageFormat.write(0x80, (None,)), "missing: descriptors[0] is None"),
        (lambda: dm.MessageFormat.write(0x80, (types.DescriptorRate(None, 1),)), "missing: descriptor is None"),
        (
            lambda: dm.MessageFormat.write("sensor", ()),
            "range: descriptor_set is 'sensor', needs a whole number from 0 to 255",
        ),
        (lambda: dm.PpsSourceControl.write("GPIO"), "range: source is 'GPIO', needs a PpsSource"),
        (lambda: dm.PpsSourceControl.write(256), "range: source is 256, needs 0 to 255"),
        (lambda: dm.DataStreamControl.write(0x80, "on"), "range: enable is 'on', needs True or False"),
        (lambda: sensor.ScaledAccel((1, None, 3)), "missing: scaled_accel[1] is None"),
        (lambda: sensor.ScaledAccel((1, 2, "3")), "count: scaled_accel is (1, 2, '3'), needs 3 numbers"),
        (
            lambda: sensor.ScaledAccel((1e300, 2, 3)),
            "range: scaled_accel[0] is 1e+300, needs -3.4028235e+38 to 3.4028235e+38",
        ),
        (lambda: tools.List.write(tuple(range(200))), "count: items has 200 elements, a field holds 125"),
        (lambda: tools.List.write((1, 1 << 16)), "range: items[1] is 65536, needs 0 to 65535"),
        (
            lambda: data.Arrays((0, 0, 0), (0, 0), ((0, 0, 0), (0, 0)), *arrays),
            "count: vectors[1] has 2 elements, needs 3",
        ),
        (lambda: data.Health("1", 0), "range: result is '1', needs a Health"),
    ):
        with pytest.raises((real.errors.EncodeError, mip.errors.EncodeError)) as error:
            make()
        assert str(error.value) == text


def test_a_port_may_be_a_path() -> None:
    ours, theirs = os.openpty()
    try:
        real.device.open_port(Path(os.ttyname(theirs))).close()
        assert real.port.address(Path("localhost:1")) == ("localhost", 1)
    finally:
        os.close(ours)
        os.close(theirs)


def test_errors_can_be_pickled() -> None:
    """A pool of processes passes them on in this way."""
    e = real.errors
    for error in (e.Truncated(2, 1), e.PacketError("sync", "y"), e.EncodeError("range", "z"), e.MissingResponse("x")):
        again = pickle.loads(pickle.dumps(error))
        assert (type(again), str(again), again.kind) == (type(error), str(error), error.kind), again
    assert str(e.Truncated(2, 1)) == "truncated: 2 bytes needed, 1 left"


def test_repeated_fields_belong_to_their_own_set() -> None:
    """Two receivers send the same fields; what is decoded knows its set, and no set is assumed."""
    kind = real.gnss_data.FixInfo
    sent = kind(*[0] * 4)
    with pytest.raises(real.errors.EncodeError, match=r"set: .*packet\(set\)"):
        sent.packet()
    with pytest.raises(real.errors.EncodeError, match="does not occur in packets of the set 0x80"):
        sent.packet(0x80)
    for number in kind.SETS:
        packet = sent.packet(number)
        got = kind.find(packet)
        assert packet.set == number and got == sent and got.packet_set == number
        assert real.registry.decode(next(iter(packet))).packet_set == number
        assert got.packet() == packet
    assert kind.find(real.packet.PacketBuilder(0x80).add(kind.DESCRIPTOR, sent.encode()).build()) is None
    assert not hasattr(kind, "SET") and real.registry.by_name("gnss_2.fix_info") is kind


# --------------------------------------------------------------------------- client


def reply(*fields: str, set_number: int = 1) -> bytes:
    builder = mip.packet.PacketBuilder(set_number)
    for f in fields:
        data = bytes.fromhex(f)
        builder.add(data[0], data[1:])
    return bytes(builder.build())


def test_a_command_that_is_changed_after_it_was_sent() -> None:
    client, slow = mip.top.Client(), mip.tools.SetTime.read(mip.types.Mode.SLOW)
    client.send(slow, now=0.0)
    slow.part = mip.types.Mode.FAST
    (event,) = client.receive(reply("f1 03 00", "83 00000001"), now=0.1)
    assert isinstance(event, mip.top.Received)
    (event,) = client.receive(reply("f1 03 00", "84 00000001"), now=0.1)
    assert event.response == mip.tools.SetTimeSlowResponse(1)


def test_client_deadline_and_cancel() -> None:
    client, ping = mip.top.Client(timeout=1.0), mip.tools.Ping()
    assert client.deadline is None
    client.send(ping, now=5.0)
    assert client.deadline == 6.0
    client.cancel(ping)
    assert client.pending == () and client.deadline is None
    for wrong in ((), (mip.measurements.Accel((0, 0, 0), 0),)):
        with pytest.raises(mip.errors.EncodeError):
            client.send(*wrong, now=0.0)


# --------------------------------------------------------------------------- devices


@pytest.mark.parametrize("spec", sorted(SPECS))
def test_devices(spec: str) -> None:
    package, of = (mip if spec == "invented" else real), model(spec)
    assert sorted(package.devices.DEVICES) == [d.id for d in of.devices]
    for d in of.devices:
        device = package.devices.DEVICES[d.id]
        keys = {(s.set, s.field.descriptor): s for s in d.supports}
        sure = {(s.set, s.field.descriptor) for s in d.certain}
        assert device.certain == sure and device.fields == keys.keys() and device.incomplete == d.incomplete
        for key, s in {(s.set, s.field.descriptor): s for s in (*d.supports, *d.refuses)}.items():
            assert device.support(*key).value == s.evidence.answer and device.has(*key) == (key in keys)
            why = device.why(*key)
            assert (why.kind, why.why, why.undefined) == (
                s.evidence.kind, describe.why(s.evidence, of), s.evidence.undefined
            )  # fmt: skip
        assert device.support(0x01, 0xEE).value == d.absent and device.why(0x01, 0xEE) is None
        assert (device.also, device.generation, device.manual) == (d.also, d.generation, d.manual)
        assert all(package.devices.by_name(name) is device for name in (d.id, d.title, *d.also))
        assert d.model_number is None or package.devices.by_model(d.model_number) is device
        assert device.functions == {key: m.letters(s.functions) for key, s in keys.items() if s.differs}
        assert device.base_rates == {rate.set.number: rate.hertz for rate in d.base_rates}
        assert [(p.name, p.id, p.baud_rates, p.receives, p.sends) for p in device.ports] == [
            (p.name, p.id, p.baud_rates, p.receives, p.sends) for p in d.ports
        ]
        assert device.firmware == {key: s.firmware for key, s in keys.items() if s.firmware}
        assert {k: (x.value, x.unit, x.description, x.firmware) for k, x in device.limits.items()} == {
            x.name: (x.value, x.unit, x.description, x.firmware) for x in d.limits
        }
        assert {k: (x.title, x.description, x.rows) for k, x in device.notes.items()} == {
            x.name: (x.title, x.description, x.rows) for x in d.notes
        }
        readings = {v.path: names.qualified(v.variant.type) for v in d.variants if v.variant.type}
        assert {k: f"{t.__module__.rpartition('.')[2]}.{t.__name__}" for k, t in device.readings.items()} == readings
        assert device.ack_codes == set(d.ack_codes)


@pytest.mark.parametrize(
    ("text", "number"),
    [
        *((t, 6254) for t in ("6254", "  6254-4220      ", "6254.12345", "6254 x", "6254\0\0", "06254")),
        *(("65535", 65535), ("625", 625), (" 42-1234", 42)),
        *((t, None) for t in ("", " ", "-", "GX5-15", "6254x", "-6254", "65536", "9" * 11, "0000")),
        *((t, None) for t in ("+6254", "6254\xb2", "\u0666\u0662\u0665\u0664")),
    ],
)
def test_model_number(text: str, number: int | None) -> None:
    assert real.devices.model_number(text) == number


def test_identify() -> None:
    def info(model: str, serial: str) -> Any:
        texts = {"model_name": "3DM-GX5-15", "lot_number": "", "device_options": ""}
        return real.base.BaseDeviceInfo(1000, model_number=model, serial_number=serial, **texts)

    devices = real.devices
    assert devices.identify(info("6254-4220", "6254.12345")) is devices.GX5_15
    assert devices.identify(info("", "  6254.12345")) is devices.GX5_15
    assert devices.identify(info("7999-1234", "6254.1")) is None and devices.identify(info("", "")) is None
    assert mip.devices.by_model(4001) is mip.devices.OLD_1 and mip.devices.by_model(4003) is None


# --------------------------------------------------------------------------- a specification that is hard on Python

AWKWARD = """set: 0x62
name: awkward
title: 'A "quoted" \\title\\'
description: Names that generated code uses itself, and groups of several steps.
types:
  pair: {struct: [{name: one, type: u16}, {name: two, type: u16}]}
  kind: {enum: u8, values: {a: 1}}
  long_bits: {bitfield: u8, bits: {a_name_that_leaves_hardly_any_room_in_a_line: {bit: 0-3}}}
fields:
  - command: 0x01
    name: halves
    title: Halves
    description: A counter whose array comes late.
    functions: WR
    parameters:
      - {name: count, type: u8, for: W}
      - {name: first, type: pair, for: W}
      - {name: second, type: pair, for: W}
      - {name: bools, type: bool, count: count, for: W}
    responses: [{response: 0x81, parameters: as_command}]
  - command: 0x02
    name: words
    title: Words
    description: Names of functions.
    functions: WR
    parameters:
      - {name: len, type: u8, for: W}
      - {name: map, type: kind, count: 2, for: W}
      - {name: gap, type: u8, optional: true, reserved: 7}
      - {name: field, type: u8, optional: true}
    responses: [{response: 0x82, parameters: as_command}]
  - command: 0x03
    name: kept
    title: Kept
    description: A reserved value in front.
    parameters:
      - {name: field, type: u8, reserved: 3}
      - {name: gap, type: u8, reserved: 0}
      - {name: isinstance, type: kind, count: 5}
"""


@pytest.fixture(scope="module")
def awkward(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("awkward")
    spec, out = folder / "spec", folder / "python"
    shutil.copytree(SPECS["invented"][0], spec)
    (spec / "sets/awkward.yaml").write_text(filled(AWKWARD), "utf-8")
    output.write(render.render("python", load_model(spec)), out)
    return out


@heavy("mypy on Python packages and their users")
def test_strict_types(awkward: Path) -> None:
    done = mypy(awkward, "mip_protocol")
    assert done.returncode == 0, done.stdout


def test_awkward_specification(awkward: Path) -> None:
    for check in (["format", "--check"], ["check"]):
        command = [Path(sys.executable).parent / "ruff", *check, "--no-cache", awkward]
        done = subprocess.run(command, capture_output=True)
        assert done.returncode == 0, done.stdout.decode()
    it = Package(awkward / "mip_protocol", "awkward_mip").awkward
    whole = bytes.fromhex("01 02 00010002 00030004 0100")
    assert it.Halves.decode(whole).encode() == whole and it.Halves.decode(whole).bools == (True, False)
    assert all(type(b) is bool for b in it.Halves.decode(whole).bools)
    for n in range(1, 10):  # a read may contain what it does not need, but only as a whole
        short, trailing = it.Halves.decode_with_trailing(b"\x02" + whole[1:n])
        assert (short, trailing) == (it.Halves.read(), n - 1) and short.encode() == b"\x02"
    words = it.Words.write(1, (it.Kind.A, 9))
    assert it.Words.decode(words.encode()) == words and words.encode().hex() == "01010109"
    assert it.Words.write(1, (1, 2), 5).encode().hex() == "010101020705"
    kept = it.Kept((1, 2, 3, 4, 5))
    assert kept.encode().hex() == "03000102030405" and it.Kept.decode(kept.encode()) == kept


# --------------------------------------------------------------------------- vendoring


@packaging
def test_folder_alone_installs_and_runs(tmp_path: Path) -> None:
    """Copied into an empty folder, installed, used from another one."""
    copy = tmp_path / "vendored"
    shutil.copytree(REAL, copy, ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("README.md", "LICENSE", "pyproject.toml", "mip_protocol/py.typed"):
        assert (copy / name).is_file()
    site = tmp_path / "site"
    done = subprocess.run(
        [sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--no-build-isolation", "--no-index",
         "--disable-pip-version-check", "--target", str(site), str(copy)],
        capture_output=True, text=True,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    package = copy / "mip_protocol"
    assert {p.relative_to(package) for p in package.rglob("*") if p.suffix in (".py", ".typed")} == {
        p.relative_to(site / "mip_protocol")
        for p in (site / "mip_protocol").rglob("*")
        if p.suffix in (".py", ".typed")
    }
    shutil.rmtree(package)
    version = model("real").protocol.version
    assert user(site, "import mip_protocol; print(mip_protocol.__version__)") == f"{version}\n"
    quickstart = (REAL / "quickstart.py").read_text("utf-8")
    assert user(site, quickstart).splitlines()[0].startswith("75 65 01 02")
    (metadata,) = site.glob("*.dist-info/METADATA")
    said = metadata.read_text("utf-8").partition("\n\n")[0].splitlines()
    assert {f"Version: {version}", "License-Expression: MIT", "License-File: LICENSE"} <= set(said)
    assert "Requires-Python: >=3.10" in said and not [x for x in said if x.startswith("Classifier: License")]
    assert [x for x in said if x.startswith("Keywords: ")] and "Classifier: Typing :: Typed" in said
    assert next(site.glob("*.dist-info/licenses/LICENSE")).read_bytes() == (ROOT / "LICENSE").read_bytes()


def test_python_inside_the_folder_says_what_is_wrong() -> None:
    """types.py is found there instead of that of the standard library."""
    done = subprocess.run(
        [sys.executable, "-S", "-c", "import enum"], cwd=REAL / "mip_protocol", capture_output=True, text=True,
        env={"PYTHONDONTWRITEBYTECODE": "1"},
    )  # fmt: skip
    assert done.returncode != 0 and "run Python in another folder" in done.stderr, done.stderr


def test_readme_shows_the_program_that_is_run() -> None:
    code = (REAL / "quickstart.py").read_text("utf-8").partition('"""\n\n')[2].rstrip()
    assert code in (REAL / "README.md").read_text("utf-8")


def test_nothing_but_the_standard_library() -> None:
    code = """
import sys, mip_protocol
from mip_protocol import registry, devices, reflection
registry.all_types()
print(sorted({k.partition('.')[0] for k in sys.modules} - set(sys.stdlib_module_names) - {'__main__', 'mip_protocol'}))
"""
    found = user(REAL, "import sys; sys.path = [p for p in sys.path if 'site-packages' not in p]\n" + code)
    assert found in ("[]\n", "['_distutils_hack']\n", "['sitecustomize']\n", "['_distutils_hack', 'sitecustomize']\n")


def test_syntax_of_the_oldest_python() -> None:
    """What it accepts, newer ones accept."""
    parse_as("3.10", INVENTED / "mip_protocol")


@heavy("other Pythons")
@pytest.mark.parametrize("version", ["3.10", "3.11", "3.12", "3.13"])
def test_other_python_versions(version: str) -> None:
    code = (
        "from mip_protocol import registry, devices, reflection, types\n"
        "F = types.GpioPinMode\n"
        "assert int(F(0xFF) & ~F.PULLUP) == 0xFB and int(F(0x80) | F.PULLUP) == 0x84 and F.PULLUP in F(0xFF)\n"
        "assert isinstance(~F.PULLUP, F) and ~~F.PULLUP is F.PULLUP\n"
        "assert types.AckCode(200) == 200 and types.AckCode(0) is types.AckCode.OK\n"
        "print(len(registry.all_types()))"
    )
    count = sum(len(f.occurrences) for f in all_fields(model("real")))
    assert user(REAL, code, python=another_python(version)) == f"{count}\n"


@pytest.mark.parametrize("spec", sorted(SPECS))
def test_decimations(spec: str) -> None:
    of = model(spec)
    for d in of.devices:
        device = (mip if spec == "invented" else real).devices.DEVICES[d.id]
        rates = {rate.set.name: rate.hertz for rate in d.base_rates}
        for s in of.sets:
            base = rates.get(s.name, 0)
            if base:
                assert [device.decimation(s.number, base / n) for n in (1, 2, 10)] == [1, 2, 10]
            else:
                with pytest.raises(ValueError, match="no fixed rate"):
                    device.decimation(s.number, 1)
