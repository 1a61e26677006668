"""What the Wireshark dissector shows, run by tshark. That it decodes as the reference does is in tests/conformance."""

from __future__ import annotations

import struct
from collections import Counter
from pathlib import Path
from typing import Any

import captures
import pytest
from conformance.test_conformance import random_values
from dissected import Element, accel, acknowledge, broken, field_bytes, packet, shark, shown, trees
from mipgen import model as m
from mipgen.lower import codec
from mipgen.targets import wireshark
from support import (
    SPECS,
    all_fields,
    heavy,
    model,
    set_of,
)

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


def check_names(p: m.Parameter, value: Any, name: str, parts: list[Element], frame: Element) -> None:
    if isinstance(p.element, m.Enum):
        known = next((v.name for v in p.element.values if v.value == value), "Unknown")
        assert parts[0].get("showname") == f"{p.name}: {known} ({value})"
    elif isinstance(p.element, m.Bitfield):
        number = value if isinstance(value, int) else int.from_bytes(bytes(value), "little")
        for b in p.element.bits:
            (found,) = shown(frame, f"{name}.{b.name}")
            assert int(found, 0) == (number & b.mask) >> b.first, (name, b.name)
    elif p.units and p.units != ("1",):
        names = [f"{name}.{e}" for e in p.element.elements] if isinstance(p.element, m.Vector) else [name]
        texts = [part.get("showname", "") for part in frame.iter("field") if part.get("name") in names]
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
            texts = [part.get("showname", "") for part in frame.iter("field")]
            if isinstance(t, m.Enum):
                assert any(text.startswith(f"{p.name}: ") and f"({t.values[0].name})" in text for text in texts), texts
            else:
                assert isinstance(t, m.Bitfield)
                assert {f"{b.name}: true" for b in t.bits if b.width == 1} <= set(texts)


@each_spec
def test_a_sibling_names_values(spec: str, tmp_path: Path) -> None:
    of, seen = model(spec), 0
    for f in of.fields:
        for p in f.parameters:
            by_sibling = [v for v in p.readings if not v.by_device and isinstance(v.type, m.Enum)]
            if not by_sibling:
                continue
            values = next((x for g, x in random_values(spec) if g is f and p.name in x), {})
            packets = []
            for v in by_sibling:
                assert isinstance(v.type, m.Enum)
                given = {**values, v.by: v.value, p.name: v.type.values[-1].value}
                packets.append(codec.build(of, set_of(f, of), [(f.descriptor, codec.encode(f, given))]))
            for v, frame in zip(by_sibling, trees(tmp_path, captures.serial(packets), spec=spec), strict=True):
                texts = [part.get("showname", "") for part in frame.iter("field")]
                assert isinstance(v.type, m.Enum)
                assert f"{p.name}: {v.type.values[-1].value} ({v.type.values[-1].name})" in texts
                seen += 1
    assert seen


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
