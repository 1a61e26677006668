"""What the Wireshark dissector shows, run by tshark. That it decodes as the reference does is in tests/conformance."""

from __future__ import annotations

import struct
from collections import Counter
from pathlib import Path
from typing import Any

import pytest
import shark as captures
from conformance.test_conformance import random_values
from dissected import Element, accel, acknowledge, broken, copied, field_bytes, packet, shark, shown, trees
from mip_protocol import Data, Packet, registry
from mip_protocol.devices import DEVICES
from mipgen import model as m
from mipgen.emit import render
from mipgen.facts import describe
from mipgen.lower import codec
from mipgen.resolve.load import load_model
from mipgen.targets import wireshark
from random_values import chance, record
from shark import Shark
from support import SPECS, all_fields, heavy, model, set_of
from timed_packets import cases_of_devices

pytestmark = heavy("tshark")

each_spec = pytest.mark.parametrize("spec", sorted(SPECS))


# --------------------------------------------------------------------------- values


@each_spec
def test_what_is_shown_is_what_the_bytes_say(spec: str, tmp_path: Path) -> None:
    """Numbers as Wireshark prints and filters them, names of values, bits and units."""
    of = model(spec)
    cases = random_values(spec)
    packets = [codec.build(of, set_of(f, of), [(f.descriptor, codec.encode(f, v))]) for f, v in cases]
    frames = trees(tmp_path, captures.serial(packets), spec=spec)
    types, seen = shark(spec).types(), Counter[str]()
    for (f, values), frame in zip(cases, frames, strict=True):
        assert shown(frame, "mip.field.name") == [f.name_in(set_of(f, of))]
        assert shown(frame, "mip.field.role") == [f.role]
        for part in frame.iter("field"):
            kind = types.get(part.get("name", ""), "")
            raw, text = part.get("value", ""), part.get("show", "")
            if kind in ("FT_FLOAT", "FT_DOUBLE"):
                check_float(bytes.fromhex(raw), text)
            elif kind.startswith("FT_INT"):
                assert int(text) == int.from_bytes(bytes.fromhex(raw), "big", signed=True)
            seen[kind] += 1
        path = f"mip.{f.name_in(set_of(f, of))}"
        for p in f.parameters:
            name = path if p.name == f.name else f"{path}.{p.name}"
            parts = [part for part in frame.iter("field") if part.get("name") == name]
            if p.name in values and p.length is None:
                check_names(p, values[p.name], name, parts, frame)
    assert min(seen[k] for k in ("FT_FLOAT", "FT_DOUBLE", "FT_UINT8", "FT_INT16", "FT_BOOLEAN", "FT_STRING")) > 0


def check_float(raw: bytes, text: str) -> None:
    (value,) = struct.unpack(">f" if len(raw) == 4 else ">d", raw)
    if value == value:
        assert float(text) == pytest.approx(value, rel=1e-5), text
    else:
        assert "nan" in text.lower()


def texts(frame: Element) -> list[str]:
    """What is shown of each part."""
    return [part.get("showname", "") for part in frame.iter("field")]


def check_names(p: m.Parameter, value: Any, name: str, parts: list[Element], frame: Element) -> None:
    if isinstance(p.element, m.Enum):
        known = next((v.name for v in p.element.values if v.value == value), "Unknown")
        assert parts[0].get("showname", "").removesuffix(" (invalid)") == f"{p.name}: {known} ({value})"
    elif isinstance(p.element, m.Bitfield):
        number = value if isinstance(value, int) else int.from_bytes(bytes(value), "little")
        for b in p.element.bits:
            (found,) = shown(frame, f"{name}.{b.name}")
            assert int(found, 0) == (number & b.mask) >> b.first, (name, b.name)
    elif p.units and p.units != ("1",):
        names = [f"{name}.{e}" for e in p.element.elements] if isinstance(p.element, m.Vector) else [name]
        shownames = [part.get("showname", "") for part in frame.iter("field") if part.get("name") in names]
        texts = [text.removesuffix(" (invalid)") for text in shownames]
        units = p.units if len(p.units) == len(texts) else p.units * len(texts)
        assert all(text.endswith(f" {unit}") for text, unit in zip(texts, units, strict=True) if unit != "1"), texts


def readings(spec: str) -> list[tuple[m.Device, m.Field, m.Parameter, m.Variant]]:
    """The parameters that devices with a manual read in their own way."""
    devices = [d for d in model(spec).devices if d.manual]
    return [(d, v.field, v.parameter, v.variant) for d in devices for v in d.variants if v.variant.type]


@each_spec
def test_a_device_names_values_and_bits_in_its_way(spec: str, tmp_path: Path) -> None:
    of, cases = model(spec), readings(spec)
    assert cases
    for device in {d.id: d for d, *_ in cases}.values():
        mine = [(f, p, v.type) for d, f, p, v in cases if d is device and not v.member]
        packets = []
        for f, p, t in mine:
            values = next(values for g, values in random_values(spec) if g is f and p.name in values)
            ones = [255] * len(values[p.name]) if p.length else (1 << 8 * p.size) - 1
            data = codec.encode(f, {**values, p.name: t.values[0].value if isinstance(t, m.Enum) else ones})
            packets.append(codec.build(of, set_of(f, of), [(f.descriptor, data)]))
        frames = trees(tmp_path, captures.serial(packets), "-o", f"mip_protocol.device:{device.title}", spec=spec)
        for (_, p, t), frame in zip(mine, frames, strict=True):
            said = texts(frame)
            if isinstance(t, m.Enum):
                assert any(text.startswith(f"{p.name}: ") and f"({t.values[0].name})" in text for text in said), said
            else:
                assert isinstance(t, m.Bitfield)
                assert {f"{b.name}: true" for b in t.bits if b.width == 1} <= set(said)


def flagged() -> list[bytes]:
    """Packets of every field with flags, and those of GPS times with all flags that a model may set."""
    of = model("real")
    random = [(f, v) for f, v in random_values("real") if f.role == m.DATA and any(p.valid for p in f.parameters)]
    packets = [codec.build(of, set_of(f, of), [(f.descriptor, codec.encode(f, v))]) for f, v in random]
    return [*packets, *{data: None for _, data, *_ in cases_of_devices()}]


def invalid(data: bytes, device: str | None) -> list[str]:
    """The values that their flags do not mark as valid, as `mip dump` says."""
    fields = [x for x in registry.decode_packet(Packet(data)) if isinstance(x, Data)]
    return [item.parameter.name for x in fields for item in x.INFO.items(x, device) if not item.valid]


@pytest.mark.parametrize("name", ["", "3dm-gx5-25", "3dm-cv7-ar", "3dm-gq7", "3dm-cx5-45", "3dm-gx3-35"])
def test_values_are_invalid_as_on_the_device_that_is_chosen(name: str, tmp_path: Path) -> None:
    chosen = ["-o", f"mip_protocol.device:{DEVICES[name].title}"] if name else []
    packets = flagged()
    frames = trees(tmp_path, captures.serial(packets), *chosen)
    seen = [(shown(frame, "mip.field.invalid"), invalid(data, name or None)) for frame, data in zip(frames, packets)]
    assert all(here == wanted for here, wanted in seen) and len(seen) == len(packets)
    assert any(wanted for _, wanted in seen) and not all(wanted for _, wanted in seen)
    texts = [part.get("showname", part.get("show", "")) for part in frames[-1].iter("field")]
    assert any("(invalid)" in text for text in texts) == bool(seen[-1][1]), texts


def identity(number: int) -> bytes:
    names = b"A device".ljust(16) + f"{number}-4220".encode().ljust(16) + b"6286.99999".ljust(16) + bytes(32)
    return codec.build(model("real"), 0x01, [(0xF1, bytes((3, 0))), (0x81, bytes(2) + names)])


def test_the_device_that_names_itself_in_the_capture(tmp_path: Path) -> None:
    """Until then, it is not known; a device that is chosen counts more; two that name themselves leave it open."""
    stamp = next(data for device, data, date, _ in cases_of_devices() if device == "3dm-cv7-ahrs" and date is None)
    gx5, cv7 = (DEVICES[name].model_number or 0 for name in ("3dm-gx5-25", "3dm-cv7-ahrs"))
    assert invalid(stamp, "3dm-cv7-ahrs") and not invalid(stamp, "3dm-gx5-25") and not invalid(stamp, None)
    capture = captures.serial([stamp, identity(cv7), stamp, identity(gx5), stamp])
    found = [bool(shown(frame, "mip.field.invalid")) for frame in trees(tmp_path, capture)]
    assert found == [False, False, True, False, False]
    twice = trees(tmp_path, captures.serial([stamp, identity(cv7)]), "-2")
    assert shown(twice[0], "mip.field.invalid")
    chosen = trees(tmp_path, capture, "-o", "mip_protocol.device:3DM-CV7-AHRS")
    assert [bool(shown(frame, "mip.field.invalid")) for frame in chosen] == [True, False, True, False, True]


@each_spec
def test_a_sibling_names_values(spec: str, tmp_path: Path) -> None:
    of, seen = model(spec), 0
    for f, p in [(g, p) for g in of.fields for p in g.parameters]:
        by_sibling = [(v, v.type.values[-1]) for v in p.readings if not v.by_device and isinstance(v.type, m.Enum)]
        values = next((x for g, x in random_values(spec) if by_sibling and g is f and p.name in x), {})
        packets = []
        for v, last in by_sibling:
            data = codec.encode(f, {**values, v.by: v.value, p.name: last.value})
            packets.append(codec.build(of, set_of(f, of), [(f.descriptor, data)]))
        frames = trees(tmp_path, captures.serial(packets), spec=spec) if packets else []
        for (_, last), frame in zip(by_sibling, frames, strict=True):
            assert f"{p.name}: {last.value} ({last.name})" in texts(frame)
            seen += 1
    assert seen


def test_a_sibling_has_units(tmp_path: Path) -> None:
    """Of a number, of the members of structures in an array, and of each element of a vector."""
    ranges, position = "3dm.get_calibrated_sensor_ranges_response", "filter.initialization_config"
    cases: list[tuple[str, dict[str, Any], str]] = [
        ("base.gps_time_update", {"field_id": 1, "value": 2300}, "value: 2300 week"),
        ("base.gps_time_update", {"field_id": 2, "value": 60}, "value: 60 s"),
        (ranges, {"sensor": 2, "num_ranges": 1, "ranges": [{"setting": 1, "range": "0x43960000"}]}, "range: 300 deg/s"),
        (position, {"reference_frame_selector": 1}, "initial_position: 1, 2, 3 m"),
        (position, {"reference_frame_selector": 2}, "initial_position: 1 deg, 2 deg, 3 m"),
    ]
    of, packets = model("real"), []
    for name, given, _ in cases:
        f = next(f for f in of.fields if f.full_name == name)
        values = record(chance(name), f.parameters, 40)
        if f is of.field(position):
            values |= {"function": 1, "initial_position": ["0x3F800000", "0x40000000", "0x40400000"]}
        data = codec.encode(f, {**values, **({"function": 1} if f.selector else {}), **given})
        packets.append(codec.build(of, set_of(f, of), [(f.descriptor, data)]))
    for frame, (_, _, wanted) in zip(trees(tmp_path, captures.serial(packets)), cases, strict=True):
        assert any(text == wanted for text in texts(frame)), (wanted, texts(frame))


#: Numbers that are equal as doubles, or too large for a mask that is one.
LARGE = """
set: 0xA0
name: large
title: Large numbers
description: Values above 2^53.
types:
  wide:
    enum: u64
    description: Neighbours.
    values:
      one: {value: 1, description: A small one.}
      last_exact: {value: 0x1FFFFFFFFFFFFF, description: The largest with an exact successor.}
      odd: {value: 0x20000000000001, description: Equals the number below as a double.}
      all: {value: 0xFFFFFFFFFFFFFFFF, description: Every bit.}
  parts:
    bitfield: u64
    description: One wide number.
    bits:
      low: {bit: 0-3, description: Four bits.}
      high: {bit: 4-63, description: Sixty bits.}
fields:
  - data: 0x01
    name: numbers
    title: Numbers
    description: A value of each type.
    parameters:
      - {name: kind, type: wide, description: A number with a name.}
      - {name: flags, type: parts, description: A number with parts.}
"""


def test_large_numbers_are_exact(tmp_path: Path) -> None:
    mine = tmp_path / "mine"
    (mine / "sets").mkdir(parents=True)
    (mine / "sets/large.yaml").write_text(LARGE, "utf-8")
    of = load_model(SPECS["invented"][0], mine)
    (tmp_path / "mip.lua").write_bytes(render.render("wireshark", of)["mip.lua"])
    names = {1: "one", (1 << 53) - 1: "last_exact", 1 << 53: None, (1 << 53) + 1: "odd", (1 << 64) - 1: "all"}
    packets = [codec.build(of, 0xA0, [(1, struct.pack(">QQ", kind, kind))]) for kind in names]
    (tmp_path / "capture.pcap").write_bytes(captures.serial(packets))
    frames = map(copied, Shark(tmp_path / "mip.lua").trees(tmp_path / "capture.pcap"))
    for (number, name), frame in zip(names.items(), frames, strict=True):
        (kind,) = (part for part in frame.iter("field") if part.get("name") == "mip.large.numbers.kind")
        assert kind.get("showname") == f"kind: {name or 'Unknown'} ({number})"
        assert [int(x) for x in shown(frame, "mip.large.numbers.flags.high")] == [number >> 4]


# --------------------------------------------------------------------------- filters


@each_spec
def test_every_filter_is_registered_once(spec: str) -> None:
    rows = [line.split("\t") for line in shark(spec).run("-G", "fields").splitlines()]
    found = Counter(row[2] for row in rows if row[0] == "F" and row[4] == "mip_protocol")
    wanted = {i.name for i in wireshark.identifiers(model(spec)) if i.scope != "the protocols"}
    assert set(found) == wanted
    assert set(found.values()) == {1}


@each_spec
def test_filters_say_what_they_are_for(spec: str) -> None:
    of = model(spec)
    rows = [line.split("\t") for line in shark(spec).run("-G", "fields").splitlines()]
    docs = {row[2]: row[7] for row in rows if row[0] == "F" and row[4] == "mip_protocol" and len(row) > 7}
    for f, o in [(g, o) for g in all_fields(of) for o in g.occurrences]:
        for p in f.parameters:
            if p.length is None and p.name != f.name and "`" not in p.description:
                text = docs[f"mip.{o.set_name}.{f.name}.{p.name}"]
                assert p.description in text
                for fact in describe.topics(describe.parameter(p, f, of), "positive", "note", "uncertain"):
                    assert describe.say(fact.sentence, lambda ref: ref.words) in text
                assert p.frame is None or "Frame: " in text


@pytest.mark.parametrize(
    ("expression", "frames"),
    [
        ("mip.sensor.scaled_accel.x > 0.5", [2]),
        ("mip.sensor.scaled_accel", [1, 2, 7]),
        ("mip.set == 0x80", [1, 2, 6, 7]),
        ("mip.shared.gps_timestamp.valid_flags.tow == 1", [6]),
        ("mip.shared.gps_timestamp.valid_flags.week_number", [6]),
        ("mip.shared.gps_timestamp.tow >= 1.5 && mip.shared.gps_timestamp.week_number == 2300", [6]),
        ('mip.base.comm_speed.function == "write"', [3]),
        ("mip.base.comm_speed.baud == 115200", [3]),
        ("mip.protocol.acknowledge.code != 0", [5]),
        ("mip.expert.refused", [5]),
        ("mip.checksum.status == 0", [7]),
        ("mip.expert.checksum", [7]),
        ("mip.field.name matches \"^base[.]\"", [3]),
        ("mip.direction == 1", [3]),
        ("mip.skipped", [8]),
        ("mip_protocol", [1, 2, 3, 4, 5, 6, 7]),
    ],
)  # fmt: skip
def test_filters_select(expression: str, frames: list[int], tmp_path: Path) -> None:
    speed = field_bytes("base.comm_speed", function="write", port=1, baud=115200)
    time = field_bytes("shared.gps_timestamp", tow=1.5, week_number=2300, valid_flags=["tow"])
    sent = [
        accel(0.25), accel(0.75), packet(speed), acknowledge(0x01, 0x09, 0), acknowledge(0x01, 0x09, 3),
        packet((0x80, *time[1:])), broken(accel(0.3)), b"$GNRMC,1*22\r\n",
    ]  # fmt: skip
    found = trees(tmp_path, captures.serial(sent), "-Y", expression)
    assert [int(shown(frame, "frame.number")[0]) for frame in found] == frames
