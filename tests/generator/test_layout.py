"""What the wire looks like: sizes, capacities, presence."""

from __future__ import annotations

from dataclasses import replace

import pytest
from mipgen import model as m
from mipgen.resolve.layout import open_ended
from small_specs import field, load
from support import model

INVENTED = model("invented")


def invented(name: str) -> m.Field:
    found = INVENTED.field(name)
    assert found is not None
    return found


def kinds(f: m.Field) -> list[str]:
    return [*(p.kind for p in f.always), *("group" for _ in f.groups)]


@pytest.mark.parametrize(
    ("parameters", "least", "most"),
    [
        ("[]", 0, 0),
        ("[{name: a, type: u8}, {name: b, type: double}]", 9, 9),
        ("[{name: a, type: vector3f}]", 12, 12),
        ("[{name: a, type: vector3f, count: 2}]", 24, 24),
        ("[{name: a, type: mode, count: 3}, {name: b, type: flags}, {name: c, type: health}]", 9, 9),
        ("[{name: a, type: point, count: 2}]", 8, 8),
        ("[{name: a, type: char, count: 16}]", 16, 16),
        ("[{name: a, type: u16, count: rest}]", 0, 252),
        ("[{name: a, type: char, count: rest}]", 0, 253),
        ("[{name: n, type: u8}, {name: a, type: u32, count: n}]", 1, 253),
        ("[{name: a, type: mode}, {name: b, switch: a, cases: {slow: {}, fast: {type: u32}}}]", 1, 5),
        ("[{name: a, type: u16, const: 5}, {name: b, type: u8, count: 3, reserved: 0}]", 5, 5),
        ("[{name: a, type: u8}, {name: b, type: u16, optional: true}]", 1, 3),
    ],
)
def test_sizes(parameters: str, least: int, most: int) -> None:
    f = field(parameters)
    assert (f.min_size, f.max_size) == (least, most)


@pytest.mark.parametrize(
    ("parameters", "capacity"),
    [
        ("[{name: a, type: u8, count: rest}]", 253),
        ("[{name: x, type: u32}, {name: a, type: u16, count: rest}]", 124),
        ("[{name: n, type: u8}, {name: a, type: u8, count: n}]", 252),
        ("[{name: n, type: u8}, {name: a, type: point, count: n}, {name: z, type: u64}]", 61),
        ("[{name: n, type: u16}, {name: a, type: vector3f, count: n}]", 20),
        ("[{name: n, type: u8}, {name: a, type: char, count: n}, {name: b, type: char, count: rest}]", 252),
        ("[{name: a, type: u8, count: 7}]", 7),
    ],
)
def test_capacities(parameters: str, capacity: int) -> None:
    (p,) = (p for p in field(parameters).parameters if p.name == "a")
    assert p.several and p.capacity == capacity


def test_the_selector_takes_a_byte_of_the_capacity() -> None:
    f = field("[{name: a, type: u8, count: rest, for: W}]", functions="W")
    assert f.parameters[1].kind == "array" and f.parameters[1].capacity == 252


def test_an_open_array_in_a_case_has_the_room_that_is_left() -> None:
    f = field("[{name: a, type: mode}, {name: b, switch: a, cases: {slow: {}, fast: {type: u16, count: rest}}}]")
    (open_array,) = f.parameters[1].alternatives
    assert open_array.kind == "array" and open_array.capacity == 126


def test_required_by_function() -> None:
    f = invented("tools.settings")
    assert {n: f.required(n) for n in (1, 2, 3, 4, 5, 6, 9)} == {1: 3, 2: 2, 3: 1, 4: 1, 5: 1, 6: 3, 9: 0}
    assert kinds(f) == ["scalar"] + ["group"] * 5
    assert [(g.first, g.last) for g in f.groups] == [(i, i) for i in range(1, 6)]
    assert (f.min_size, f.max_size) == (1, 10)
    assert f.parameters[0].selector and len(f.counted) == 5
    assert m.letters(f.parameters[3].required_for) == "WA" and f.parameters[4].optional


def test_as_command_drops_selector_and_presence() -> None:
    f = invented("tools.settings_response")
    assert [p.name for p in f.parameters] == ["port", "mode", "baud", "limit", "reserved"]
    assert "group" not in kinds(f) and not f.optional and f.required() == 5


def test_a_counter_and_its_array_are_one_group() -> None:
    f = invented("tools.list")
    assert [(g.first, g.last, [p.kind for p in g.parameters]) for g in f.groups] == [(1, 2, ["counter", "array"])]
    assert f.parameters[1].counts == "items" and [f.required(n) for n in (1, 2, 3)] == [2, 0, 0]


def test_groups_keep_what_stands_between_a_counter_and_its_array() -> None:
    f = field(
        "[{name: n, type: u8, for: W}, {name: k, type: u8, for: W}, {name: a, type: u8, count: n, for: W},"
        " {name: b, type: u8, count: k, for: W}, {name: z, type: u8, for: W}]",
        functions="W",
    )
    assert [(g.first, g.last) for g in f.groups] == [(1, 4), (5, 5)]


def test_optional_without_selector() -> None:
    f = invented("measurements.growing")
    assert kinds(f) == ["scalar", "group", "group"] and f.required() == 1 and f.functions == ()
    assert [(g.first, g.last) for g in f.groups] == [(2, 2), (3, 3)]


def test_constants_have_offsets() -> None:
    f = invented("tools.status_long")
    assert f.signature == ((0, (4711).to_bytes(2, "big")), (2, b"\x02"))
    f = field("[{name: n, type: char, count: 2}, {name: c, type: u8, const: 1}]")
    assert f.signature == ()


def test_bits() -> None:
    flags = next(t for t in INVENTED.types if t.name == "state_flags")
    assert isinstance(flags, m.Bitfield)
    masks = {b.name: b.mask for b in flags.bits}
    assert masks == {"ready": 1, "hot": 2, "level": 0x70, "mode": 0x300, "any": 3}
    assert flags.known_mask == 0x373 and flags.bits[2].width == 3
    assert flags.bits[3].enum is not None and flags.bits[3].enum.name == "mode"


def test_types_come_after_those_that_they_use() -> None:
    tools = INVENTED.family("tools")
    assert tools is not None
    order = [t.name for t in tools.types]
    assert order.index("fill") < order.index("circle") and order.index("stripes") < order.index("circle")
    shared = [t.name for t in INVENTED.types]
    assert shared.index("point") < shared.index("segment") and shared.index("mode") < shared.index("state_flags")


def test_responses() -> None:
    command = invented("tools.capture_bias")
    assert command.responses == ("bias_vector",)
    first = invented("tools.set_time_fast_response")
    assert first.command == "set_time" and [(c.parameter, c.value, c.label) for c in first.when] == [
        ("part", 1, "fast")
    ]
    silent = invented("tools.formats").silent_when
    assert [(c.parameter, c.value) for c in silent] == [("suppress_ack", 1)]


def test_what_a_parameter_means() -> None:
    f = field(
        "[{name: a, type: vector3f, unit: [m, m, s], frame: sensor, range: [~, 5], default: [0, 1.5, 2],"
        " valid: flags.ready, notes: [One.]}, {name: flags, type: flags, default: [ready]}]",
        role="data",
    )
    a, flags = f.parameters
    assert (a.units, a.frame, a.minimum, a.maximum) == (("m", "m", "s"), "sensor", None, 5)
    assert (a.default, a.valid, a.notes, flags.default) == ([0, 1.5, 2], ("flags.ready",), ("One.",), ["ready"])


def test_a_part_is_what_it_holds() -> None:
    written = field(
        "[{name: a, type: u8}, {name: n, type: u8, valid: flags.ready}, {name: x, type: u8, count: n},"
        " {name: flags, type: flags}]",
        role="data",
    )
    model = load(
        """\
        set: 0x90
        name: it
        title: It
        description: It.
        parts:
          list: [{name: n, type: u8, valid: flags.ready}, {name: x, type: u8, count: n}]
          unused_by_others: [{name: flags, type: flags}]
        types:
          both: {struct: [{include: list}, {include: unused_by_others}]}
        fields:
          - data: 0x01
            name: it
            title: It
            description: It.
            sources: [{manual: guide, section: It}]
            parameters: [{name: a, type: u8}, {include: list}, {include: unused_by_others}]
        """
    )
    found = model.field("it.it")
    assert found is not None
    assert replace(found, parameters=()) == replace(written, parameters=())
    both = model.type("it.both")
    assert isinstance(both, m.Struct)
    for made, right in ((found.parameters, written.parameters), (both.parameters, written.parameters[1:])):
        assert len(made) == len(right) and all(p.alike(q) for p, q in zip(made, right, strict=True))


def test_one_valid_flag_for_a_whole_field() -> None:
    f = invented("measurements.gust")
    assert {p.name: p.valid for p in f.parameters if p.valid} == dict.fromkeys(
        ("place", "height", "speed"), ("valid_flags.ready",)
    )
    radio = {p.name: p.valid for p in invented("measurements.radio").parameters}
    assert radio == {"connected": (), "strength": ("connected",), "noise": ("connected",), "gap": (), "gaps": ()}


def test_a_response_does_not_take_the_valid_flag_of_its_command() -> None:
    text = """\
        set: 0x05
        name: it
        title: It
        description: It.
        fields:
          - command: 0x01
            name: it
            title: It
            description: It.
            sources: [{manual: guide, section: It}]
            valid: flags.ready
            parameters: [{name: a, type: u8}, {name: flags, type: flags}]
            responses:
              - {response: 0x81, parameters: as_command}
              - {response: 0x82, name: other, parameters: as_command, valid: flags.ready}
        """
    valid = {f.name: f.parameters[0].valid for f in load(text).families[1].fields}
    assert valid == {"it": ("flags.ready",), "it_response": (), "other": ("flags.ready",)}


def test_calls() -> None:
    write, read, *_, apply = invented("tools.settings").calls
    assert [p.name for p in write.required] == ["port", "mode", "baud"] == [p.name for p in apply.required]
    assert [p.name for p in write.optional] == ["limit", "reserved"] == [p.name for p in apply.optional]
    assert [p.name for p in read.required] == ["port", "mode"] and read.optional == ()
    (only,) = invented("tools.status").calls
    assert [p.name for p in only.required] == ["model", "selector"] and [p.name for p in only.given] == ["selector"]
    (growing,) = invented("measurements.growing").calls
    assert len(growing.required) == 1 and len(growing.optional) == 2


def test_variants() -> None:
    flags = invented("tools.status_short").parameters[2]
    assert flags.by_device and [(v.by, v.key, v.type and v.type.name) for v in flags.readings] == [
        ("device", "model-a", "model_a_faults"), ("device", "model-b", "model_b_faults"),
        ("device", "model-c", "model_a_faults"),
    ]  # fmt: skip
    use = invented("tools.pin").parameters[2]
    assert [(v.by, v.key, v.value) for v in use.readings] == [("drive", "pulse", 1), ("drive", "serial", 2)]
    readings = invented("tools.readings_response").parameters[2]
    assert not readings.readings and [(v.member, v.key, v.type and v.type.name) for v in readings.variants] == [
        ("kind", "pulse", "pulse_use"), ("kind", "serial", "serial_use")
    ]  # fmt: skip
    accel = invented("measurements.accel").parameters[0]
    assert [(v.key, v.units, v.frame, v.type) for v in accel.variants] == [
        ("model-b", ("m", "m", "s"), "ned", None), ("model-c", (), None, None)
    ]  # fmt: skip
    assert [v.valid for v in accel.variants] == [("valid_flags.hot", "valid_flags.ready", "valid_flags.hot"), ()]
    device = INVENTED.device("model-b")
    assert device is not None and [v.path for v in device.variants] == [
        "protocol.acknowledge.code", "tools.status_short.flags", "tools.status_long.flags",
        "measurements.accel.scaled_accel",
    ]  # fmt: skip


def test_references() -> None:
    bias, shared = invented("tools.bias"), invented("tools.bias_vector")
    assert INVENTED.responses(bias) == (shared,)
    assert INVENTED.commands(shared) == (bias, invented("tools.capture_bias"))
    assert invented("more.accel") is invented("copy.accel") is invented("measurements.accel")
    assert [d.id for d in INVENTED.devices_of(shared)] == ["model-a", "model-c"]
    ((first, a), (second, b), _) = INVENTED.supports(invented("tools.settings"))
    assert (first.id, m.letters(a.functions), a.differs) == ("model-a", "WRSLDA", False)
    assert (second.id, m.letters(b.functions), b.differs) == ("model-b", "WR", True)


def test_sets_are_sorted_and_fields_too() -> None:
    assert [s.number for s in INVENTED.sets] == [0x01, 0x0C, 0x80, 0x81, 0x92, 0xFF]
    assert [s.kind for s in INVENTED.sets] == ["command", "command", "data", "data", "data", "shared"]
    for x in INVENTED.families:
        keys = [(f.role == m.RESPONSE, f.descriptor) for f in x.fields]
        assert keys == sorted(keys)


def test_a_family_of_sets() -> None:
    """A field occurs in the sets with every field, in those that it lists, or only in some."""
    family = INVENTED.family("measurements")
    assert family is not None and [s.name for s in family.sets] == ["measurements", "more", "copy"]
    there = {s.name: [f.name for f in INVENTED.fields_in(s)] for s in family.sets}
    assert there["copy"] == there["measurements"] and len(there["copy"]) > 5
    assert there["more"] == ["accel", "strings", "own"]
    accel, radio, own = (invented(f"measurements.{name}") for name in ("accel", "radio", "own"))
    assert (accel.sets, radio.sets, own.sets) == ((0x80, 0x81, 0x92), (0x80, 0x92), (0x81,))
    assert (accel.name_in(0x92), own.name_in(0x81), own.full_name) == ("copy.accel", "more.own", "measurements.own")
    assert [o.title for o in accel.occurrences] == ["Acceleration", "Second acceleration", "Third acceleration"]
    cited = {o.set_name: [s.section for s in o.sources] for o in (*accel.occurrences, *radio.occurrences[1:])}
    assert cited["more"] == ["Second acceleration"] and cited["copy"] == ["Copied measurements"]
    assert [x.name for x in family.named] == ["shade", "ghost"]
    assert [f.name for f in INVENTED.candidates(0x81, 0x07)] == ["own"] != INVENTED.candidates(0x80, 0x07)
    assert INVENTED.set_of("copy.accel") == 0x92 and INVENTED.set_of("measurements.own") == 0x80


def test_every_field_has_sources() -> None:
    """A specification of one's own needs none; here they say where a fact comes from, in each set."""
    assert [f.full_name for f in model("real").fields if not all(o.sources for o in f.occurrences)] == []


def test_what_occurs_everywhere() -> None:
    acknowledge, timestamp = INVENTED.protocol.acknowledge, invented("shared.timestamp")
    assert (acknowledge.sets, timestamp.sets) == (range(0x01, 0x80), range(0x80, 0xFF))
    assert timestamp.name_in(0x80) == timestamp.full_name and acknowledge.name_in(0x0C) == acknowledge.full_name


def test_descriptors_that_are_only_named() -> None:
    tools = INVENTED.family("tools")
    assert tools is not None
    assert [(x.descriptor, x.role, x.name) for x in tools.named] == [
        (0x20, "command", "farewell"),
        (0xA0, "response", "farewell_answer"),
    ]
    assert INVENTED.candidates(0x01, 0x20) == ()


def test_what_is_uncertain_is_kept_apart() -> None:
    copy, radio, answer = INVENTED.set(0x92), invented("measurements.radio"), invented("tools.hello_response")
    assert copy is not None and copy.uncertain == ("Which device sends it.",)
    assert len(radio.uncertain) == 2 and radio.notes == () and answer.uncertain == ("When it comes.",)
    strength = radio.parameters[1]
    assert (strength.uncertain, strength.valid, strength.notes) == (("Its unit.",), ("connected",), ())
    types = {t.name: t for t in INVENTED.types}
    mode, flags = types["mode"], types["state_flags"]
    assert isinstance(mode, m.Enum) and isinstance(flags, m.Bitfield)
    assert mode.uncertain and [v.uncertain for v in mode.values] == [(), ("How quick.",), ()]
    assert [b.name for b in flags.bits if b.uncertain] == ["hot"]


def test_open_bounds() -> None:
    _, strength, noise, *_ = invented("measurements.radio").parameters
    assert (strength.minimum, strength.maximum, strength.above, strength.below) == (None, None, None, 1)
    assert (noise.minimum, noise.maximum, noise.above, noise.below) == (None, 10, 0, None)


def test_a_command_that_the_device_sends() -> None:
    hello = invented("tools.hello")
    assert hello.sent_by == "device" and invented("tools.ping").sent_by == "host"
    assert [p.reserved for p in hello.parameters] == [1.0, 0.0]


def test_what_others_call_it() -> None:
    assert invented("measurements.radio").also == invented("copy.radio").also == ("modem", "rf")
    assert invented("tools.hello_response").also == ("keep_alive_response", "welcome")


def test_candidates() -> None:
    names = {n: [f.name for f in INVENTED.candidates(*n)] for n in ((1, 0xF1), (1, 0x90), (0x80, 0xD3), (1, 0xD3))}
    assert names == {
        (1, 0xF1): ["acknowledge"],
        (1, 0x90): ["status_paged", "status_short", "status_long", "status_old", "status_full"],
        (0x80, 0xD3): ["timestamp"],
        (1, 0xD3): [],
    }


def test_positions_are_those_of_the_file() -> None:
    head = "set: 5\nname: it\ntitle: It\ndescription: It.\n"
    model = load(f"{head}types:\n  kind:\n    enum: u8\n    values:\n      a: 1\n")
    t = model.families[1].types[0]
    assert isinstance(t, m.Enum) and t.position is not None and t.values[0].position is not None
    assert (t.position.line, t.position.column) == (6, 3)
    assert (t.values[0].position.line, t.values[0].position.column) == (9, 7)


def test_open_ended() -> None:
    u8 = m.SCALARS["u8"]
    assert open_ended(m.Parameter("a", u8, m.REST)) and not open_ended(m.Parameter("a", u8, "n"))


def test_a_field_may_be_full() -> None:
    """Of 255 bytes, two are its length and its descriptor."""
    assert field("[{name: a, type: u8, count: 251}, {name: b, type: u16}]").max_size == 253
    assert field("[{name: n, type: u8}, {name: a, type: u16, count: n}]").max_size == 253
