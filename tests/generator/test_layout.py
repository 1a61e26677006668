"""What the wire looks like: sizes, capacities, presence; and how manuals count and print it."""

from __future__ import annotations

from dataclasses import replace

import pytest
from mipgen import model as m
from mipgen.facts.examples import misprint_text
from mipgen.lower.extent import computed_length
from mipgen.targets.c import names as c
from small_specs import field, load
from support import model, some

INVENTED = model("invented")


def invented(name: str) -> m.Field:
    return some(INVENTED.field(name))


def kinds(f: m.Field) -> list[str]:
    return [*(p.kind for p in f.always), *("group" for _ in f.groups)]


@pytest.mark.parametrize(
    ("parameters", "least", "most", "wire", "scalars"),
    [
        ("[]", 0, 0, "2", "2"),
        ("[{name: a, type: u8}, {name: b, type: double}]", 9, 9, "11", "11"),
        ("[{name: a, type: vector3f}]", 12, 12, "14", "2"),
        ("[{name: a, type: vector3f, count: 2}]", 24, 24, "26", "2"),
        ("[{name: a, type: u16, count: rest}]", 0, 252, "2 + 2*rest", "2 + 2*rest"),
        ("[{name: a, type: char, count: rest}]", 0, 253, "2 + rest", "2 + rest"),
        ("[{name: a, type: mode}, {name: b, switch: a, cases: {slow: {}, fast: {type: u32}}}]", 1, 5, "3", "3"),
        ("[{name: a, type: u16}, {name: b, type: mode}, {name: c, type: flags}]", 5, 5, "7", "7"),
        ("[{name: a, type: point, count: 3}]", 12, 12, "14", "2"),
        ("[{name: a, type: u32, count: 2}, {name: b, type: mode, count: 3}]", 11, 11, "13", "13"),
        ("[{name: a, type: char, count: 16}, {name: b, type: health}]", 20, 20, "22", "22"),
        ("[{name: a, type: u8, const: 5}, {name: b, type: u8, count: 2, reserved: 0}]", 3, 3, "5", "5"),
        ("[{name: n, type: u8}, {name: a, type: u16, count: n}]", 1, 253, "3 + 2*n", "3 + 2*n"),
        ("[{name: n, type: u8}, {name: a, type: point, count: n}]", 1, 253, "3 + 4*n", "3 + 4*n"),
        ("[{name: n, type: u8}, {name: a, type: u8, count: n}, {name: z, type: u8}]", 2, 253, "4 + n", "4 + n"),
        ("[{name: a, type: u8}, {name: b, type: u8, optional: true}]", 1, 2, "4", "4"),
    ],
)
def test_sizes(parameters: str, least: int, most: int, wire: str, scalars: str) -> None:
    """Of the data; and of the whole field, as manuals print it."""
    f = field(parameters)
    assert (f.min_size, f.max_size) == (least, most)
    assert (computed_length(f, "wire"), computed_length(f, "scalars")) == (wire, scalars)


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


def test_an_open_array_in_a_case_has_the_room_that_is_left() -> None:
    f = field("[{name: a, type: mode}, {name: b, switch: a, cases: {slow: {}, fast: {type: u16, count: rest}}}]")
    (open_array,) = f.parameters[1].alternatives
    assert open_array.kind == "array" and open_array.capacity == 126


def test_a_union_has_the_name_that_the_specification_states() -> None:
    """Its type is beside others in the languages that name it."""
    union = "{name: a, type: mode}, {name: b, switch: a, %scases: {slow: {}, fast: {type: u16}}}"
    plain, named = (field(f"[{union % name}]") for name in ("", "union: outline, "))
    own, other = (next(p for p in f.parameters if p.union) for f in (plain, named))
    assert c.union_name(own, plain).removeprefix(c.symbol(plain)) == "_b"
    assert c.union_name(other, named) == c.symbol(named).removesuffix(named.name) + "outline"


def test_required_by_function() -> None:
    f = invented("tools.settings")
    assert {n: f.required(n) for n in (1, 2, 3, 4, 5, 6, 9)} == {1: 3, 2: 2, 3: 1, 4: 1, 5: 1, 6: 3, 9: 0}
    assert kinds(f) == ["scalar"] + ["group"] * 5
    assert [(g.first, g.last) for g in f.groups] == [(i, i) for i in range(1, 6)]
    assert (f.min_size, f.max_size) == (1, 10)
    assert f.parameters[0].selector and len(f.counted) == 5
    assert m.letters(f.parameters[3].required_for) == "WA" and f.parameters[4].optional


def test_groups_keep_what_stands_between_a_counter_and_its_array() -> None:
    f = field(
        "[{name: n, type: u8, for: W}, {name: k, type: u8, for: W}, {name: a, type: u8, count: n, for: W},"
        " {name: b, type: u8, count: k, for: W}, {name: z, type: u8, for: W}]",
        functions="W",
    )
    assert [(g.first, g.last) for g in f.groups] == [(1, 4), (5, 5)]


def test_constants_have_offsets() -> None:
    f = invented("tools.status_long")
    assert f.signature == ((0, (4711).to_bytes(2, "big")), (2, b"\x02"))
    f = field("[{name: n, type: char, count: 2}, {name: c, type: u8, const: 1}]")
    assert f.signature == ()


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
            parameters: [{name: a, type: u8}, {include: list}, {include: unused_by_others}]
        """
    )
    found = some(model.field("it.it"))
    assert replace(found, parameters=()) == replace(written, parameters=())
    both = model.type("it.both")
    assert isinstance(both, m.Struct)
    for made, right in ((found.parameters, written.parameters), (both.parameters, written.parameters[1:])):
        assert len(made) == len(right) and all(p.alike(q) for p, q in zip(made, right, strict=True))
    assert not any(p.alike(replace(p, description="Another.")) for p in written.parameters)


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
            valid: flags.ready
            parameters: [{name: a, type: u8}, {name: flags, type: flags}]
            responses:
              - {response: 0x81, parameters: as_command}
              - {response: 0x82, name: other, parameters: as_command, valid: flags.ready}
        """
    valid = {f.name: f.parameters[0].valid for f in load(text).families[1].fields}
    assert valid == {"it": ("flags.ready",), "it_response": (), "other": ("flags.ready",)}


def test_bits_describe_the_values_that_they_mark() -> None:
    f = field(
        "[{name: a, type: u8, unit: s, description: It., valid: f.a}, "
        "{name: b, type: u8, unit: s, description: It., valid: f.both},"
        " {name: c, type: u8, unit: s, description: It., valid: f.both}, {name: f, type: marks}]",
        types="{marks: {bitfield: u8, description: It., bits: {a: 0, both: 1, c: 2}}}",
        role="data",
    )
    of_dop = some(model("real").field("gnss_data.dop")).parameters[-1].element
    assert isinstance(of_dop, m.Bitfield)
    assert of_dop.bits[-1].alias and of_dop.bits[-1].description == "All values are valid."
    flags = f.parameters[-1].element
    assert isinstance(flags, m.Bitfield)
    assert [b.description for b in flags.bits] == ["`a` is valid.", "`b` and `c` are valid.", ""]


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


def test_a_field_may_be_full() -> None:
    """Of 255 bytes, two are its length and its descriptor."""
    assert field("[{name: a, type: u8, count: 251}, {name: b, type: u16}]").max_size == 253
    assert field("[{name: n, type: u8}, {name: a, type: u16, count: n}]").max_size == 253


# --------------------------------------------------------------------------- what manuals print


def test_the_selector_counts() -> None:
    f = field("[{name: a, type: u16, for: W}]", functions="W")
    assert computed_length(f, "wire") == "5"


def test_a_structure_that_varies_counts_as_its_counter_says() -> None:
    types = "{tail: {struct: [{name: n, type: u8}, {name: a, type: u8, count: n}]}}"
    f = field("[{name: a, type: tail}]", types=types)
    assert (computed_length(f, "wire"), computed_length(f, "scalars")) == ("3 + a.n", "2")


def example(string: str | None = None, table: str | None = None, role: str = "command") -> m.Example:
    cells = None if table is None else tuple(None if "?" in x else int(x, 16) for x in table.split())
    packet = bytes.fromhex("756501020201e0c6")
    return m.Example("x", "guide", "", "", role, string, cells, packet, (), "")  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("printed", "found"),
    [
        (example("7565 0102 0201 E0C6", "75 65 01 02 02 01 E0 C6"), []),
        (example("7565 0102 0201 e0c6", "75 65 01 02 02 01 ?? ??"), []),
        (example("7565 0102 0201"), ["string has 6 bytes, should have 8"]),
        (example(table="75 65 ?? 03 02 01 ?? ??"), ["table byte at offset 3 is 03, should be 02"]),
        (example("02 01", role="field"), []),
        (example("02 02", role="field"), ["string byte at offset 1 is 02, should be 01"]),
    ],
)
def test_differences(printed: m.Example, found: list[str]) -> None:
    assert misprint_text(printed) == found
