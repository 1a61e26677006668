"""What classes and objects know at run time: meaning, validity, text, names."""

from __future__ import annotations

import json
import math
import pickle
import pydoc
import random
import struct
import subprocess
import sys
from collections.abc import Iterator
from functools import partial
from itertools import islice
from types import SimpleNamespace
from typing import Any

import pytest
from mipgen import model as m
from mipgen.facts import describe
from mipgen.lower.codec import in_numbers
from mipgen.targets.python import names
from mipgen.targets.python.docs import COMMENTS
from packages import REAL, Package, mip, real
from support import SEED, all_fields, model, rounds
from timed_packets import cases_of_devices

say = COMMENTS.say

PACKAGES = {"real": real, "invented": mip}
both = pytest.mark.parametrize("spec", sorted(PACKAGES))


def records(of: m.Model) -> list[m.Record]:
    return [*all_fields(of), *(t for t in of.all_types if isinstance(t, m.Struct))]


def kind(package: Package, thing: m.Field | m.Type) -> Any:
    return getattr(getattr(package, names.home(thing)), names.class_name(thing))


def said(known: Any, description: str, facts: list[describe.Fact], thing: m.Field | m.Type, of: m.Model) -> None:
    """The text begins with the description, contains every fact, and has neither lists nor lines."""
    where = names.home(thing)
    prose = say(describe.prose(description, of), where)
    assert known.text.startswith(prose) and "\n" not in known.text and not known.text.startswith("- "), known.name
    for fact in facts:
        assert say(fact.sentence, where) in known.text, (known.name, fact)


def objects(package: Package, f: m.Field, chance: random.Random, count: int = 6) -> Iterator[Any]:
    """Objects with random values, of data of every length that the field can have."""
    for _ in range(count):
        data = bytearray(chance.randbytes(chance.randint(f.min_size, min(f.max_size, 253))))
        if chance.random() < 0.1:
            data[:] = bytes([7]) * len(data)  # a constant
        elif chance.random() < 0.5:
            data[:8] = bytes(x % 4 for x in data[:8])  # enumerations and counters
        for at, constant in f.signature:
            data[at : at + len(constant)] = constant
        try:
            yield kind(package, f).decode(bytes(data))
        except package.errors.DecodeError:
            pass


# --------------------------------------------------------------------------- meaning


@both
def test_fields_and_structures_know_what_they_mean(spec: str) -> None:
    package, of = PACKAGES[spec], model(spec)
    for r in records(of):
        info = kind(package, r).INFO
        assert info.type is kind(package, r)
        facts = describe.in_code(r, of) if isinstance(r, m.Field) else describe.type_facts(r, of)
        said(info, r.description, facts, r, of)
        assert info.sources == tuple(describe.sources(r))
        assert [p.name for p in info.parameters] == [p.name for p in r.parameters]
        assert [p.name for p in info.members] == [p.name for p in r.parameters if not p.derived]
        if isinstance(r, m.Struct):
            continue
        assert (info.name, info.title, info.also, info.advanced) == (r.full_name, r.title, r.also, r.advanced)
        assert (tuple(info.sets), info.descriptor, info.role) == (tuple(r.sets), r.descriptor, r.role)
        assert info.deprecated == bool(r.deprecated)
        assert not info.text.startswith(r.title + " (")
        assert info.devices == tuple(d.id for d in of.devices_of(r))
        assert info.likely == tuple(d.id for d in of.devices_of(r, "likely"))
        assert info.assumed == tuple(d.id for d in of.devices_of(r, "assumed"))
        assert info.functions == tuple(names.member(x.name) for x in r.functions)


@both
def test_parameters_know_what_they_mean(spec: str) -> None:
    package, of = PACKAGES[spec], model(spec)
    for r in records(of):
        for p in r.parameters:
            row = kind(package, r).INFO[p.name]
            assert row is kind(package, r).INFO[names.member(p.name)] or p.name in [q.attribute for q in r.parameters]
            check(package, p, r, row, of)
            holder = r
            said(row, p.description, describe.parameter(p, holder, of), holder, of)
            for c in p.cases:
                assert say(describe.case(c, p, holder).value, names.home(holder)) in row.text
                if c.parameter is not None:
                    check(package, c.parameter, r, row.cases[c.tag.value], of)
                    assert say(describe.prose(c.parameter.description, of), names.home(holder)) in row.text


def check(package: Package, p: m.Parameter, r: m.Record, row: Any, of: m.Model) -> None:
    """What the conformance driver does not need to know."""
    assert (row.name, row.attribute, row.constant) == (p.name, names.member(p.name), p.constant)
    assert (row.units, row.frame, row.valid) == (p.units, p.frame or "", p.valid)
    assert (row.minimum, row.maximum, row.above, row.below) == (p.minimum, p.maximum, p.above, p.below)
    assert row.magnitude == p.magnitude
    default = p.reserved if p.default is None else in_numbers(p.default, p.element)
    assert row.default == default and type(row.default) is type(default)
    assert (row.optional, row.reserved, row.deprecated) == (p.optional, p.reserved is not None, p.deprecated)
    assert row.required == tuple(names.member(f.name) for f in p.required_for)
    bounds = describe.limits_text(p.minimum, p.maximum, p.above, p.below)
    assert row.range.replace(".0", "") == bounds.replace(".0", "")


@both
def test_what_differs_by_device_or_beside_other_values(spec: str) -> None:
    package, of = PACKAGES[spec], model(spec)
    seen = 0
    for r in records(of):
        for p in r.parameters:
            row = kind(package, r).INFO[p.name]
            for v in p.variants:
                if v.member:
                    continue
                held = row.on(v.key) if v.by_device else beside(package, r, p, v)
                seen += 1
                if v.type is not None:
                    assert held.type is kind(package, v.type)
                if v.unknown:
                    assert held.type is None
                assert held.units == (v.units or p.units) and held.frame == (v.frame or p.frame or "")
                assert held.minimum == (p.minimum if v.minimum is None else v.minimum)
                assert held.maximum == (p.maximum if v.maximum is None else v.maximum)
                assert held.constant == (p.constant if v.constant is None else v.constant)
                assert held.valid == (p.valid if v.valid is None else v.valid)
                assert held.deprecated == (p.deprecated if v.deprecated is None else v.deprecated)
                assert held.only == tuple(x.name for x in v.only)
                if v.default is not None:
                    assert held.default == in_numbers(v.default, v.type or p.element)
    assert seen > 10


def beside(package: Package, r: m.Record, p: m.Parameter, v: m.Variant) -> Any:
    """The parameter in an object in which the other value is the one of the variant."""
    holder = object.__new__(kind(package, r))
    setattr(holder, names.member(v.by), v.value)
    return kind(package, r).INFO[p.name].of(holder)


@both
def test_types_know_their_values_and_bits(spec: str) -> None:
    package, of = PACKAGES[spec], model(spec)
    info = package.reflection.info
    for t in (*of.all_types, of.protocol.function_selector):
        if isinstance(t, m.Enum):
            known = info(kind(package, t))
            assert [(v.name, v.value, v.deprecated) for v in known.values] == [
                (v.name, v.value, v.deprecated) for v in t.values
            ]
            for row, v in zip(known.values, t.values):
                said(row, v.description, describe.value(v, of), t, of)
            assert known.names == {v.value: v.name for v in t.values}
            assert all(kind(package, t)[names.constant(v.name)] == v.value for v in t.values)
        elif isinstance(t, m.Bitfield):
            known = info(kind(package, t))
            assert [(b.name, b.first, b.last, b.mask, b.alias) for b in known.bits] == [
                (b.name, b.first, b.last, b.mask, b.alias) for b in t.bits
            ]
            for row, b in zip(known.bits, t.bits):
                said(row, b.description, describe.bits(b, of), t, of)
            assert [b.type for b in known.bits] == [kind(package, b.enum) if b.enum else None for b in t.bits]
            for b in t.bits:
                assert int(getattr(kind(package, t), names.constant(b.name))) == b.mask
                if b.width > 1 and not b.alias:
                    changed = getattr(kind(package, t)(0), f"with_{b.name}")((1 << b.width) - 1)
                    assert int(changed) == b.mask and int(getattr(changed, b.name)) == (1 << b.width) - 1
        else:
            continue
        said(known, t.description, describe.type_facts(t, of), t, of)
        assert known.sources == tuple(describe.sources(t))
    for s in of.sets:
        found = package.reflection.set_info(s.number)
        assert (found.name, found.number, found.title) == (s.name, s.number, s.title)
        assert found.text.startswith(say(describe.prose(s.description, of), names.module(s.family)))


def test_settings_that_silence_are_those_of_the_specification() -> None:
    of = model("real")
    known = {kind.NAME: kind for _, kind in real.registry.all_types() if issubclass(kind, real.field.Command)}
    for f in of.fields:
        if f.role == "command":
            wanted = [(of.field(c.command or ""), c) for c in f.silenced_by]
            found = known[f.full_name].SILENCED_BY
            assert [(s.set, s.descriptor, c.parameter, c.value) for s, c in wanted if s] == list(found)
            for number, descriptor, member, _ in found:
                (setting,) = real.registry.types(number, descriptor)
                assert member in setting.__annotations__


def test_only_types_of_the_specification_are_known() -> None:
    class Mine(real.sensor.ScaledAccel):  # type: ignore[name-defined,misc]
        __slots__ = ()

    assert Mine.INFO is real.sensor.ScaledAccel.INFO
    for other in (int, real.field.Data, real.codec.OpenEnum):
        with pytest.raises(LookupError, match="is not a type of the specification"):
            real.reflection.info(other)
    assert not hasattr(real.field.Field, "INFO")


def test_a_set_is_loaded_when_it_is_asked_for() -> None:
    code = """if True:
        import sys
        from mip_protocol import sensor
        def loaded(): return sorted(x.partition("_protocol.")[2] for x in sys.modules if "mip_protocol." in x)
        before = loaded()
        assert not {"info", "parameter", "text", "lookup", "reflection", "_index", "simulator"} & {*before}, before
        sensor.ScaledAccel.INFO
        print([x for x in loaded() if x not in before])
    """
    done = subprocess.run([sys.executable, "-S", "-c", code], capture_output=True, text=True, cwd=REAL, check=True)
    assert "_meaning.sensor" in done.stdout and "_meaning.filter" not in done.stdout
    assert "mip_3dm" not in done.stdout and "_index" not in done.stdout


def test_help_says_it() -> None:
    text = pydoc.plain(pydoc.render_doc(real.gnss_data.LlhPosition))
    assert " |  latitude\n |      Geodetic latitude. Unit: deg. Frame: llh. " in text
    assert "Valid if `LlhPositionFlags.LAT_LON` of `valid_flags` is set." in " ".join(text.replace("|", "").split())


# --------------------------------------------------------------------------- validity


@both
def test_flags_vouch_for_values(spec: str) -> None:
    """A value is valid if exactly the bits that the specification names are set."""
    package, of = PACKAGES[spec], model(spec)
    seen = 0
    for r in records(of):
        for p in r.parameters:
            others = {v.key for v in p.variants if v.by_device and v.valid is not None}
            for device in (None, of.devices[0].id, *others):
                own = next((v for v in p.variants if v.by_device and v.key == device and v.valid is not None), None)
                paths = p.valid if own is None else own.valid
                if paths is not None and not p.derived:
                    seen += vouching(package, r, p, paths, device)
    assert seen > {"real": 150, "invented": 10}[spec]


def vouching(package: Package, r: m.Record, p: m.Parameter, paths: tuple[str, ...], device: str | None) -> int:
    flags = [flag(r, path, device) for path in paths]
    if None in flags:
        assert not kind(package, r).INFO[p.name].of(empty(package, r), device).flags
        return 0
    holder = empty(package, r)
    assert holder.is_valid(p.name, device) == (not flags)
    elements = p.element.elements if isinstance(p.element, m.Vector) else ()
    for attribute, mask in flags:  # type: ignore[misc]
        setattr(holder, attribute, 0xFF if mask else 0)
    for attribute, mask in flags:  # type: ignore[misc]
        setattr(holder, attribute, getattr(holder, attribute) & ~mask)
    given = set()
    for attribute, mask in flags:  # type: ignore[misc]
        assert not holder.is_valid(p.name, device) or given == {*flags}
        setattr(holder, attribute, getattr(holder, attribute) | mask or 2)
        given.add((attribute, mask))
        assert holder.is_valid(p.name, device) == (given == {*flags})
        if len(flags) == len(elements):
            for element, wanted in zip(elements, flags):
                assert holder.is_valid(f"{p.name}.{element}", device) == (wanted in given)
    setattr(holder, names.member(p.name), None)
    assert not holder.is_valid(p.name, device)
    return 1


def flag(r: m.Record, path: str, device: str | None) -> tuple[str, int] | None:
    name, _, bit = path.partition(".")
    holder = next(q for q in r.parameters if q.name == name)
    types = [v.type for v in holder.readings if v.key == device] or [holder.element]
    masks = [b.mask for t in types if isinstance(t, m.Bitfield) for b in t.bits if b.name == bit]
    return None if bit and not masks else (names.member(name), masks[0] if bit else 0)


def empty(package: Package, r: m.Record) -> Any:
    """An object whose values are all 0."""
    found = object.__new__(kind(package, r))
    for p in kind(package, r).INFO.members:
        setattr(found, p.attribute, 0)
    return found


def test_elements_have_their_own_flags() -> None:
    position = real.aiding.EcefPosition
    holder = empty(real, model("real").field("aiding.ecef_position"))  # type: ignore[arg-type]
    holder.valid_flags = position.INFO["valid_flags"].type.X
    assert holder.is_valid("position.x") and not holder.is_valid("position.y") and not holder.is_valid("position")
    with pytest.raises(real.errors.UnknownName, match="'w' is not an element of position; known: x, y, z"):
        holder.is_valid("position.w")


def test_times_of_devices() -> None:
    for device, data, *wanted in cases_of_devices():
        moments = real.timestamps.moments(real.packet.Packet(data), device)
        assert [moments.get("gps"), moments.get("device")] == wanted, (device, data.hex())


def test_flags_of_an_unknown_device_are_recognized() -> None:
    """Devices up to generation 5 have three flags, the last of which marks the time as valid; later ones have five."""
    three, five = real.sensor.GpsTimestamp(1.0, 2, 5), real.sensor.GpsTimestamp(1.0, 2, 0xD)
    assert three.is_valid("tow") and three.is_valid("week_number") and "(invalid)" not in str(three)
    assert five.is_valid("tow") and not five.is_valid("week_number")
    assert not real.sensor.GpsTimestamp(1.0, 2, 3).is_valid("tow")
    tow = three.INFO["tow"]
    assert [[flag.mask for flag in tow.recognized(flags).flags] for flags in (5, 13)] == [[4], [8]]


def test_a_device_has_its_own_flags() -> None:
    stamp = real.sensor.GpsTimestamp(1.0, 2, 8)
    assert stamp.is_valid("tow") and stamp.is_valid("tow", "3dm-cv7-gnss-ins")
    assert not stamp.is_valid("tow", "3dm-gx5-15") and "(invalid)" in stamp.to_text("3dm-gx5-15")


# --------------------------------------------------------------------------- meaning of one value


def test_meaning_of_arrays_of_bytes() -> None:
    """The continuous built-in test is sixteen bytes for most devices, and a bitfield for one."""
    tests = real.types.Cv7ContinuousBuiltInTest
    for field in (real.base.ContinuousBuiltInTestResponse, real.system_data.BuiltInTest):
        value = field.decode(bytes((1, 0, 2, *[0] * 13)))
        found = value.meaning("result", "3dm-cv7-gnss-ins")
        assert type(found) is tests and int(found) == 0x20001
        assert value.meaning("result") == value.result and value.meaning("result", "3dm-gx5-15") == value.result
        for wrong in ((1, 2, 256), (-1,), ("a",)):
            value.result = wrong
            with pytest.raises(real.errors.EncodeError, match="needs numbers from 0 to 255"):
                value.meaning("result", "3dm-cv7-gnss-ins")


# --------------------------------------------------------------------------- dictionaries and text


@both
def test_every_object_is_a_dictionary_and_a_text(spec: str) -> None:
    package, of, chance = PACKAGES[spec], model(spec), random.Random(SEED)
    seen = set()
    for f in all_fields(of):
        for value in islice(objects(package, f, chance, 60), rounds(8, 60)):
            seen.add(f.full_name)
            for device in (None, of.devices[0].id):
                for named in (True, False):
                    held = value.to_dict(names=named, json=True, device=device)
                    assert list(held) == [p.name for p in f.parameters if not p.derived]
                    assert json.loads(json.dumps(held, allow_nan=False)) == held
                    assert plain(held) and plain(value.to_dict(names=named, device=device))
                line = value.to_text(device)
                assert line.startswith((f.full_name, *(f.name_in(o.set) for o in f.occurrences)))
                assert line.isprintable()
            assert str(value) == value.to_text()
    assert seen == {f.full_name for f in all_fields(of)}


def plain(value: Any) -> bool:
    if isinstance(value, dict):
        return all(type(k) is str and plain(v) for k, v in value.items())
    return all(map(plain, value)) if type(value) is list else type(value) in (int, float, str, bool, type(None))


def test_dictionaries() -> None:
    tools, types, data = mip.tools, mip.types, mip.measurements
    nan, infinite = math.nan, math.inf
    accel = data.Accel((1.5, nan, -infinite), types.StateFlags(0x8000 | 1 << 4))
    held = accel.to_dict()
    assert held["scaled_accel"]["x"] == 1.5 and math.isnan(held["scaled_accel"]["y"])
    assert accel.to_dict(json=True)["scaled_accel"] == {"x": 1.5, "y": None, "z": None}
    assert accel.to_dict(names=False, json=True) == {"scaled_accel": [1.5, None, None], "valid_flags": 0x8010}
    settings = tools.Settings.write(1, types.Mode.SLOW, 9600)
    assert settings.to_dict() == {
        "function": "write", "port": 1, "mode": "slow", "baud": 9600, "limit": None, "reserved": None,
    }  # fmt: skip
    assert tools.Settings.write(1, 77, 9600).to_dict()["mode"] == 77
    pin = tools.Pin.write(tools.Drive.SERIAL, 0x21)
    assert pin.meaning("use") is tools.SerialUse.TRANSMIT and tools.Pin.write(tools.Drive.OFF, 1).meaning("use") == 1
    assert pin.to_dict()["use"] == "transmit" and pin.to_dict(names=False)["use"] == 0x21
    status = tools.StatusShort(1 << 12)
    assert tools.ModelBFaults.ACCEL in status.meaning("flags", "model-b")
    assert tools.ModelAFaults.CLOCK not in status.meaning("flags", "model-a")
    assert status.to_dict()["flags"] == 4096 and status.to_dict(device="model-b")["flags"] == ["accel"]


def test_text() -> None:
    accel = real.sensor.ScaledAccel.decode(bytes.fromhex("3dcccccd 3e4ccccd bf800000"))
    assert str(accel) == "sensor.scaled_accel: scaled_accel = (x=0.1, y=0.2, z=-1.0) g"
    assert str(real.base.Ping()) == "base.ping"
    flags = real.gnss_data.LlhPosition.INFO["valid_flags"].type
    position = real.gnss_data.LlhPosition(44.5, -73.25, 12.0, math.nan, 0.5, 1.5, flags.LAT_LON | 0x8000)
    assert str(position) == (
        "gnss_data.llh_position: latitude = 44.5 deg, longitude = -73.25 deg, ellipsoid_height = 12.0 m (invalid), "
        "msl_height = nan m (invalid), horizontal_accuracy = 0.5 m (invalid), vertical_accuracy = 1.5 m (invalid), "
        "valid_flags = lat_lon|0x8000"
    )
    assert repr(position).startswith("LlhPosition(latitude=44.5, ")
    pin = mip.tools.Pin.write(mip.tools.Drive.SERIAL, 0x21)
    assert str(pin) == "tools.pin: function = write, drive = serial, use = transmit"
    info = real.base.GetDeviceInfoResponse.decode(b"\0\1" + b"      3DM-GX5-15".ljust(80, b"\0"))
    assert "model_name = '3DM-GX5-15'" in str(info)


def test_numbers_of_four_bytes_are_short_and_exact() -> None:
    pack, chance = struct.Struct(">f"), random.Random(5)
    form = real.sensor.ScaledAccel.INFO["scaled_accel"].format
    for _ in range(2000):
        (number,) = pack.unpack(chance.randbytes(4))
        if math.isfinite(number):
            text = form((number,) * 3).partition("=")[2].partition(",")[0]
            digits = next(d for d in range(6, 10) if pack.pack(float(f"{number:.{d}g}")) == pack.pack(number))
            assert text == repr(float(f"{number:.{digits}g}"))
    assert form((1e300, math.inf, math.nan)) == "(x=1e+300, y=inf, z=nan) g"


def test_members_of_structures_depend_on_what_holds_them() -> None:
    tools = mip.tools
    reply = tools.ReadingsResponse(tools.Drive.SERIAL, (tools.Reading(0x21, 1.0),), tools.Reading(1, 2.0))
    assert reply.to_dict()["readings"][0]["kind"] == "transmit"
    reply = tools.ReadingsResponse(tools.Drive.PULSE, (tools.Reading(1, 1.0),), tools.Reading(1, 2.0))
    assert reply.to_dict()["readings"][0]["kind"] == "input"
    unit = model("invented").field("tools.readings_response").parameters[-1].variants[0].units[0]  # type: ignore[union-attr]
    assert f"value = 2.0 {unit}" in str(reply)


def test_elements_of_vectors_are_those_of_their_frame() -> None:
    velocity = real.gnss_data.NedVelocity.INFO["velocity"]
    assert velocity.elements == real.types.Ned3f._fields == ("north", "east", "down")
    assert velocity.format((1.0, 2.0, 3.0)) == "(north=1.0, east=2.0, down=3.0) m/s"
    assert real.filter_data.EcefVelocity.INFO["velocity"].elements == ("x", "y", "z")
    kind, frame = real.filter.InitializationConfig, real.filter.ReferenceFrame
    sent = kind.write(0, 0, 0, 0, 0, 0, (47, 8, 500), (0, 0, 0), frame.LLH)
    assert "initial_position = (latitude=47 deg, longitude=8 deg, height=500 m)" in str(sent)
    assert "initial_velocity = (north=0, east=0, down=0) m/s" in str(sent)
    assert sent.to_dict()["initial_position"] == {"latitude": 47, "longitude": 8, "height": 500}
    there = sent.__replace__(reference_frame_selector=frame.ECEF)
    assert "initial_position = (x=47, y=8, z=500) m" in str(there)


def test_values_that_cannot_be_sent_have_a_text() -> None:
    """The other methods reject them, as sending does."""
    package, chance, refused = mip, random.Random(8), 0
    for _, kind in package.registry.all_types():
        for _ in range(5):
            wrong = ("write", b"1", 1.5, {}, {1}, [], ["x"], (None,), object(), range(3), iter((1, 2)), 1 << 70, -1)
            value = kind.__new__(kind)  # its constructor would reject them
            for name in kind._MEMBERS:
                setattr(value, name, chance.choice(wrong))
            assert str(value) and value.to_text()
            calls: list[Any] = [value.to_dict, partial(value.to_dict, json=True)]
            for p in kind.INFO.members:
                calls += [partial(value.is_valid, p.name), partial(value.meaning, p.name)]
            for call in calls:
                try:
                    call()
                except package.errors.EncodeError:
                    refused += 1
    assert refused > 100


def test_the_program_of_the_readme_runs() -> None:
    text = (REAL / "README.md").read_text("utf-8")
    program = text.split("## What fields mean")[1].split("```python\n")[1].split("```")[0]
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, cwd=REAL, check=True)
    lines = done.stdout.splitlines()
    assert lines[0] == "GNSS LLH position is sent by 3dm-cv7-gnss-ins 3dm-cv7-ins 3dm-gq7"
    assert lines[1].startswith(
        "deg ('valid_flags.lat_lon',) - Geodetic latitude. Unit: deg. Frame: llh. Range: -90 to 90. Positive: north. "
    )
    assert lines[2].startswith("gnss_data.llh_position: latitude = 44.5 deg, ") and lines[3] == "True False"
    assert "'valid_flags': ['lat_lon']" in lines[4] and lines[5] == "sensor.temperature_statistics"


# --------------------------------------------------------------------------- names


@both
def test_every_name_finds_its_field(spec: str) -> None:
    package, of = PACKAGES[spec], model(spec)
    find = package.registry.by_name
    assert package.registry.names() == tuple(f.full_name for f in all_fields(of))
    for f in of.fields:
        wanted = kind(package, f)
        assert find(f.full_name) is wanted
        assert find(f"{names.home(f)}.{names.class_name(f)}") is wanted
        for name in (*f.also, f.title, f.name, names.class_name(f)):
            try:
                found = [find(f"{f.family}.{name}")]
            except package.errors.UnknownName as error:
                assert error.kind == "ambiguous"
                found = [find(x) for x in error.near]
            assert wanted in found, name
    for s in of.sets:
        for name in (s.name, s.title, hex(s.number)):
            assert package.registry.set_by_name(name) == s.number
    for d in of.devices:
        for name in (d.id, d.title, d.title.lower()):
            assert package.devices.by_name(name) is package.devices.DEVICES[d.id]


def test_names_of_the_vendor() -> None:
    find = real.registry.by_name
    assert find("continuous_bit") is real.base.ContinuousBuiltInTest
    assert find("gnss_1.pos_llh") is real.gnss_data.LlhPosition
    assert find("mip_sensor_scaled_accel_data") is real.sensor.ScaledAccel
    assert find("data_sensor::ScaledAccel") is real.sensor.ScaledAccel
    assert find("commands_base::ContinuousBit") is real.base.ContinuousBuiltInTest
    assert find("mip_filter_status_data") is real.filter_data.Status
    assert find("mip_accel_bias_data") is real.filter_data.AccelBias
    assert find("commands_3dm::AccelBias") is find("mip_3dm_accel_bias_command") is real.mip_3dm.AccelBias
    assert find("0x80,0x04") is find("(0x80, 0x04)") is real.sensor.ScaledAccel


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("sensor.scaled_acel", "'sensor.scaled_acel' is not a field; did you mean sensor.scaled_accel"),
        ("3dm.mesage_format", "did you mean 3dm.message_format"),
        ("pos_llh", "'pos_llh' may be aiding.llh_position or "),
        ("xyzzy", "'xyzzy' is not a field$"),
        ("", "'' is not a field$"),
        ("0x80,0x99", "is not a field$"),
        ("0x0C,0x90", "may be 3dm.device_status"),
    ],
)
def test_unknown_names_suggest_the_nearest(name: str, message: str) -> None:
    with pytest.raises(LookupError, match=message) as error:
        real.registry.by_name(name)
    assert isinstance(error.value, real.errors.UnknownName) and isinstance(error.value, real.errors.MipError)
    assert all(x in real.registry.names() for x in error.value.near)


def test_other_unknown_names() -> None:
    unknown = real.errors.UnknownName
    with pytest.raises(unknown, match="'sensr' is not a descriptor set; did you mean sensor"):
        real.registry.set_by_name("sensr")
    for name in ("0x99", "0xzz"):
        with pytest.raises(unknown, match="is not a descriptor set"):
            real.registry.set_by_name(name)
    with pytest.raises(unknown, match="'3dm-gx5-14' is not a device; did you mean 3dm-gx5-"):
        real.sensor.GpsTimestamp(1.0, 2, 8).is_valid("tow", "3dm-gx5-14")
    with pytest.raises(unknown, match=r"'acel' is not a parameter of sensor.scaled_accel; .*scaled_accel"):
        real.sensor.ScaledAccel.INFO["acel"]
    with pytest.raises(unknown):
        real.sensor.ScaledAccel((1.0, 2.0, 3.0)).is_valid("nothing")
    for find in (real.registry.by_name, real.registry.set_by_name, real.devices.by_name):
        for wrong in (4, None, int):
            with pytest.raises(unknown, match="is not the name of a"):
                find(wrong)
    with pytest.raises(unknown) as error:
        real.devices.by_name("gx5")
    again = pickle.loads(pickle.dumps(error.value))
    assert (str(again), again.near, again.kind) == (str(error.value), error.value.near, "unknown_name")


def test_names_of_devices() -> None:
    find, known = real.devices.by_name, real.devices.DEVICES
    for name in ("GX5-45", "gx5 45", "3DM-GX5-45", "gx545", "GX5-GNSS/INS", "3dm gx5 gnss ins"):
        assert find(name) is known["3dm-gx5-45"], name
    nearest = {"GX5-46": "3dm-gx5-45", "cv7": "3dm-cv7-ar", "3DM-GQ77": "3dm-gq7", "3dm-gx5": "3dm-gx5-15"}
    for name, near in nearest.items():
        with pytest.raises(real.errors.UnknownName, match=f"{name!r} is not a device; did you mean .*{near}") as found:
            find(name)
        assert near in found.value.near and len(found.value.near) <= 4
    with pytest.raises(real.errors.UnknownName, match=r"'45' may be 3dm-cx5-45, .* or 3dm-gx5-45"):
        find("45")
    for name in ("3dm-gx5-10", "3DM-GX5-IMU"):
        only = "only the name of the 3DM-GX5-10 is known; choose 3dm-cx5-10"
        with pytest.raises(real.errors.UnknownName, match=only):
            find(name)
    assert repr(find("gx5 15")) == "<Device 3dm-gx5-15: 3DM-GX5-15>"


def test_bits_are_read_in_the_state_of_their_record() -> None:
    """Bit 12 of a 5-series device means another thing while its filter initializes; other bits then mean nothing."""
    status = real.filter_data.Status
    words = {
        (1, 0x1000): ["init_no_attitude"],
        (2, 0x1000): ["run_mag_bias_est_high_warning"],
        (1, 0x1100): ["init_no_attitude", "0x100"],
        (0, 0x0001): ["0x1"],
    }
    for (state, flags), expected in words.items():
        read = status(filter_state=state, dynamics_mode=1, status_flags=flags)
        assert read.to_dict(names=True, device="3dm-gx5-15")["status_flags"] == expected
        assert f"status_flags = {'|'.join(expected)}" in read.to_text("3dm-gx5-15")


def test_bits_of_a_state_that_their_record_lacks(monkeypatch: pytest.MonkeyPatch) -> None:
    """The bits of one type may depend on different parameters, of which a record may have only some."""
    states = {"init_no_attitude": ("filter_state", (1,)), "init_no_position_velocity": ("elsewhere", (1,))}
    monkeypatch.setattr(real.text, "_states", lambda kind: states)
    names = real.text.bits_in(real.filter_data.Gx5StatusFlags(0x3000), SimpleNamespace(filter_state=1))
    assert "init_no_attitude" in names and "init_no_position_velocity" not in names
