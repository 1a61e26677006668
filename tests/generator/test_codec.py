"""The reference codec, besides what tests/conformance shows: generated code decodes and encodes as it does."""

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


def test_a_field_that_is_too_long_is_refused() -> None:
    values = {"model": "A" * 16, "length": 200, "name": "A" * 200, "rest": "A" * 37}
    with pytest.raises(CodecError, match="254 bytes do not fit in a field"):
        codec.encode(field("measurements.strings"), values)


@pytest.mark.parametrize("payload", ["0101", "0301", "02"])
def test_fields_that_are_no_fields_are_refused(payload: str) -> None:
    head = bytes([0x75, 0x65, 1, len(payload) // 2]) + bytes.fromhex(payload)
    with pytest.raises(CodecError, match="a field of length"):
        codec.split(MODEL, head + codec.checksum(head))


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
        ("measurements.strings", {"model": "AÿC", "name": "BC"}, {"model": "AÿC".ljust(16), "name": "BC"}),
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
