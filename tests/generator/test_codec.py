"""The reference codec: what it decodes, encodes and rejects."""

from __future__ import annotations

from typing import Any

import pytest
from mipgen import model as m
from mipgen.lower import codec
from mipgen.lower.codec import CodecError
from support import model, some

MODEL = model("invented")


def field(name: str) -> m.Field:
    return some(MODEL.field(name))


GOOD: list[tuple[str, str, dict[str, Any], int]] = [
    ("tools.ping", "", {}, 0),
    ("tools.ping", "0102", {}, 2),
    ("tools.settings", "02 05 01", {"function": 2, "port": 5, "mode": 1}, 0),
    ("tools.settings", "03 05", {"function": 3, "port": 5}, 0),
    ("tools.settings", "03 05 01", {"function": 3, "port": 5, "mode": 1}, 0),
    ("tools.settings", "03 05 01 0000", {"function": 3, "port": 5, "mode": 1}, 2),
    ("tools.settings", "01 05 01 00002580", {"function": 1, "port": 5, "mode": 1, "baud": 9600}, 0),
    ("tools.settings", "01 05 01 00002580 0007 FF EE",
     {"function": 1, "port": 5, "mode": 1, "baud": 9600, "limit": 7, "reserved": 255}, 1),
    ("tools.settings", "63", {"function": 99}, 0),
    ("tools.list", "01 02 0001 FFFF", {"function": 1, "count": 2, "items": [1, 65535]}, 0),
    ("tools.list", "02", {"function": 2}, 0),
    ("tools.list", "02 00", {"function": 2, "count": 0, "items": []}, 0),
    ("tools.list_response", "00", {"count": 0, "items": []}, 0),
    ("tools.inventory_response", "0101 0102 01", {"descriptors": [0x101, 0x102]}, 1),
    ("tools.status_short", "1267 01 00000001", {"flags": 1}, 0),
    ("tools.choice", "01 01 00", {"function": 1, "instance": 1, "shape": 0, "parameters": {}}, 0),
    ("tools.choice", "01 01 63 AABB", {"function": 1, "instance": 1, "shape": 99, "parameters": {}}, 2),
    ("tools.choice", "01 01 02 01 01 0001 FFFF",
     {"function": 1, "instance": 1, "shape": 2,
      "parameters": {"path": {"closed": 1, "num_points": 1, "points": [{"x": 1, "y": -1}]}}}, 0),
    ("tools.choice", "01 01 04 4142432020202020",
     {"function": 1, "instance": 1, "shape": 4, "parameters": {"label": "ABC     "}}, 0),
    ("measurements.accel", "7FE5BF7F 00000000 80000000 FFFF",
     {"scaled_accel": ["0x7fe5bf7f", "0x00000000", "0x80000000"], "valid_flags": 0xFFFF}, 0),
    ("measurements.health", "01 02" + "00" * 14 + "FFFF0000",
     {"result": [1, 2] + [0] * 14, "code": 0xFFFF0000}, 0),
    ("measurements.strings", "41" * 16 + "02 4243 FF00",
     {"model": "A" * 16, "length": 2, "name": "BC", "rest": "\xff\x00"}, 0),
    ("measurements.growing", "0001", {"first": 1}, 0),
    ("measurements.growing", "0001 0002 000000", {"first": 1, "second": 2}, 3),
]  # fmt: skip


@pytest.mark.parametrize(("name", "data", "values", "trailing"), GOOD)
def test_both_ways(name: str, data: str, values: dict[str, Any], trailing: int) -> None:
    raw = bytes.fromhex(data)
    assert codec.decode(field(name), raw) == (values, trailing)
    assert codec.encode(field(name), values) == raw[: len(raw) - trailing]


@pytest.mark.parametrize(
    ("name", "data", "kind"),
    [
        ("tools.settings", "", "truncated"),
        ("tools.settings", "01 05 01 000025", "truncated"),
        ("tools.list", "01 03 0001 0002", "count"),
        ("tools.list_response", "01", "count"),
        ("tools.list", "02 01 00", "count"),
        ("tools.status_short", "1268 01 00000001", "constant"),
        ("tools.choice", "01 01 02 01 02 0001 FFFF", "count"),
        ("measurements.growing", "00", "truncated"),
    ],
)
def test_refused_bytes(name: str, data: str, kind: str) -> None:
    with pytest.raises(CodecError) as caught:
        codec.decode(field(name), bytes.fromhex(data))
    assert caught.value.kind == kind


@pytest.mark.parametrize(
    ("name", "values", "kind"),
    [
        ("tools.settings", {"function": 1, "port": 5}, "missing"),
        ("tools.settings", {"port": 5}, "missing"),
        ("tools.settings", {"function": 3, "port": 5, "baud": 1}, "missing"),
        ("tools.settings", {"function": 2, "port": 256, "mode": 1}, "range"),
        ("tools.settings", {"function": 2, "port": 5, "mode": 1, "other": 1}, "unknown"),
        ("tools.list", {"function": 1, "count": 1, "items": []}, "count"),
        ("tools.list", {"function": 2, "count": 0}, "missing"),
        ("tools.list_response", {"count": 200, "items": [0] * 200}, "count"),
        ("tools.choice", {"function": 1, "instance": 1, "shape": 0, "parameters": {"label": "A" * 8}}, "tag"),
        ("tools.choice", {"function": 1, "instance": 1, "shape": 4, "parameters": {"label": "A" * 9}}, "count"),
        ("measurements.health", {"result": [0] * 15, "code": 0}, "count"),
        ("measurements.strings", {"model": "\u2028" * 16, "length": 0, "name": "", "rest": ""}, "range"),
        ("measurements.strings", {"model": "A" * 16, "length": 200, "name": "A" * 200, "rest": "A" * 100}, "length"),
        ("measurements.growing", {"first": 1, "third": "0x00000000"}, "missing"),
        ("measurements.accel", {"scaled_accel": ["0x00", "0x00000000", "0x00000000"], "valid_flags": 0}, "range"),
    ],
)
def test_refused_values(name: str, values: dict[str, Any], kind: str) -> None:
    with pytest.raises(CodecError) as caught:
        codec.encode(field(name), values)
    assert caught.value.kind == kind


@pytest.mark.parametrize(
    ("packet", "kind"),
    [
        ("7566 0102 0201 E1C8", "sync"),
        ("7565 0102 0201 E0C7", "checksum"),
        ("7565 0102 0201", "length"),
        ("7565 0002 0201 DFC2", "length"),
        ("7565 0102 0101", "field_length"),
        ("7565 0102 0301", "field_length"),
        ("7565 0101 02", "field_length"),
    ],
)
def test_refused_packets(packet: str, kind: str) -> None:
    raw = bytes.fromhex(packet)
    if kind == "field_length":
        raw += codec.checksum(raw)
    with pytest.raises(CodecError) as caught:
        codec.split(MODEL, raw)
    assert caught.value.kind == kind


def test_packets() -> None:
    built = codec.build(MODEL, 1, [(1, b""), (9, b"\x02")])
    assert codec.split(MODEL, built) == [(1, b""), (9, b"\x02")]
    assert codec.split(MODEL, codec.build(MODEL, 0x80, [])) == []
    for fields in ([(1, bytes(254))], [(1, bytes(200)), (1, bytes(60))]):
        with pytest.raises(CodecError):
            codec.build(MODEL, 1, fields)


STATUS = MODEL.candidates(1, 0x90)


@pytest.mark.parametrize(
    ("head", "chosen"),
    [
        ("126701", {0: "status_paged", 4: "status_short"}),
        ("126702", {0: "status_old", 15: "status_long", 16: "status_full"}),
        ("126703", {0: None}),
        ("126802", {0: None}),
    ],
)
def test_layouts_are_told_apart_by_their_constants_then_by_size(head: str, chosen: dict[int, str | None]) -> None:
    """`chosen`: the size of the data from which each layout is chosen."""
    for size in range(3, m.MAX_FIELD_DATA + 1):
        data = bytes.fromhex(head).ljust(size, b"\0")
        f = codec.choose(STATUS, data)
        assert (f.name if f else None) == chosen[max(n for n in chosen if n <= size)], size
        fitting = [g for g in STATUS if all(data[at : at + len(c)] in (c, b"") for at, c in g.signature)]
        fitting = [g for g in fitting if size in MODEL.sizes(g)] if len(fitting) > 1 else fitting
        assert f in (fitting or [None])


def test_one_layout_has_all_sizes() -> None:
    assert MODEL.sizes(field("tools.ping")) == range(m.MAX_FIELD_DATA + 1)


def test_data_that_end_before_a_constant_do_not_speak_against_a_layout() -> None:
    assert [codec.choose(STATUS, bytes.fromhex(d)) for d in ("", "12", "1267")] == [STATUS[0]] * 3
    assert codec.choose(STATUS, b"\x13") is None and codec.choose((), b"") is None


@pytest.mark.parametrize(
    ("name", "stated", "canonical"),
    [
        ("tools.settings", {"function": "write", "mode": "slow"}, {"function": 1, "mode": 2}),
        ("tools.settings", {"function": 99}, {"function": 99}),
        ("measurements.accel", {"scaled_accel": [1, -0.5, "0x7FE5BF7F"], "valid_flags": ["ready", "any", "hot"]},
         {"scaled_accel": ["0x3f800000", "0xbf000000", "0x7fe5bf7f"], "valid_flags": 3}),
        ("measurements.strings", {"model": "ABC", "name": "BC"}, {"model": "ABC".ljust(16), "name": "BC"}),
        ("measurements.health", {"result": "01" + "00" * 15}, {"result": [1] + [0] * 15}),
        ("tools.formats", {"suppress_ack": True}, {"suppress_ack": 1}),
    ],
)  # fmt: skip
def test_values_as_people_write_them(name: str, stated: dict[str, Any], canonical: dict[str, Any]) -> None:
    assert codec.canonical_record(field(name).parameters, stated, name) == canonical


@pytest.mark.parametrize(
    ("name", "stated"),
    [
        ("tools.settings", {"mode": "solw"}), ("tools.settings", {"mode": None}), ("tools.settings", {"mode": 1.5}),
        ("tools.settings", [1]), ("measurements.accel", {"valid_flags": ["raedy"]}),
        ("measurements.accel", {"valid_flags": [{}]}), ("measurements.accel", {"scaled_accel": 1}),
        ("measurements.accel", {"scaled_accel": [True, 0, 0]}),
        ("measurements.accel", {"scaled_accel": ["0xZZZZZZZZ"]}),
        ("measurements.accel", {"scaled_accel": [1e39]}), ("measurements.accel", {"scaled_accel": [1 << 2000]}),
        ("measurements.accel", {"scaled_accel": [{}]}), ("measurements.health", {"result": 5}),
        ("measurements.health", {"result": "xy"}), ("measurements.health", {"result": [None] * 16}),
        ("measurements.strings", {"model": 5}), ("tools.choice", {"parameters": 5}),
        ("tools.choice", {"parameters": {"square": 5}}),
    ],
)  # fmt: skip
def test_values_that_mean_nothing(name: str, stated: Any) -> None:
    with pytest.raises(ValueError, match=name):
        codec.canonical_record(field(name).parameters, stated, name)
