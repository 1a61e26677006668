"""What every codec needs: extents, runs, presence, memory, calls."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from mipgen import model as m
from mipgen.lower import calls, codec, extent, memory, runs
from mipgen.lower.extent import Extent
from small_specs import field
from support import model, some

INVENTED = model("invented")


def invented(name: str) -> m.Field:
    return some(INVENTED.field(name))


# --------------------------------------------------------------------------- extents


def test_a_counter_inside_a_structure_has_its_path() -> None:
    f = field(
        "[{name: a, type: tail}]", types="{tail: {struct: [{name: n, type: u8}, {name: b, type: u16, count: n}]}}"
    )
    assert str(extent.exact_size(f.parameters[0], "it.")) == "1 + 2*it.a.n"
    assert extent.size(f.parameters[0]) == (1, 253)


def test_what_has_no_exact_extent() -> None:
    f = field("[{name: a, type: mode}, {name: b, switch: a, cases: {slow: {}, fast: {type: u16, count: rest}}}]")
    union = f.parameters[1]
    assert extent.exact_size(union) is None and extent.exact_size(union.alternatives[0]) is None
    assert extent.size(union) == (0, 252)


def test_an_unknown_tag_has_no_data() -> None:
    f = field("[{name: a, type: mode}, {name: b, switch: a, cases: {slow: {type: u16}, fast: {type: u32}}}]")
    assert [e.fixed for e in extent.extents(f.parameters[1])] == [2, 4]
    assert extent.shortest_size([f.parameters[1]]) == Extent()


def test_no_field_is_larger_than_the_largest() -> None:
    assert extent.most([m.Parameter("a", m.SCALARS["char"], 200)] * 2) == m.MAX_FIELD_DATA
    assert all(f.max_size <= m.MAX_FIELD_DATA for f in INVENTED.fields)


# --------------------------------------------------------------------------- runs


def at(values: Any, path: runs.Path) -> Any:
    for part in path:
        values = values[part]
    return values


def test_runs_are_where_the_codec_reads() -> None:
    """Every number of a fixed layout, at its offset."""
    found = [(f, runs.runs(f)) for f in INVENTED.fields]
    assert sum(bool(r) for _, r in found) > 5
    for f, each in found:
        data = bytes((7 * i + 1) % 256 for i in range(f.max_size))
        if each:
            values, left = codec.decode(f, data)
            assert (
                left == 0
                and [r.offset for r in each] == list(starts(each))
                and each[-1].offset + each[-1].size == len(data)
            )
            for r in each:
                value = at(values, r.path)
                raw = bytes_of(r, value)
                assert raw == data[r.offset : r.offset + r.size], (f.full_name, r.path)


def starts(each: list[runs.Run]) -> Iterator[int]:
    offset = 0
    for r in each:
        yield offset
        offset += r.size


def bytes_of(r: runs.Run, value: Any) -> bytes:
    if isinstance(value, str) and r.scalar.kind == "char":
        return value.encode("latin-1")
    one = m.Parameter("item", r.scalar, None)
    return b"".join(codec.encode_value(one, v) for v in (value if r.count is not None else [value]))


@pytest.mark.parametrize(
    "parameters",
    [
        "[{name: a, type: u8}, {name: b, type: u8, optional: true}]",
        "[{name: a, type: u8, const: 1}]",
        "[{name: n, type: u8}, {name: a, type: u8, count: n}]",
        "[{name: a, type: char, count: rest}]",
    ],
)
def test_what_varies_or_is_checked_has_no_runs(parameters: str) -> None:
    assert runs.runs(field(parameters)) == []


# --------------------------------------------------------------------------- memory


def test_memory() -> None:
    f = field("[{name: a, type: u8}, {name: b, type: double}, {name: c, type: char, count: 3}, {name: d, type: u16}]")
    assert memory.record_memory(f) == memory.Room(24, 8, 20)  # 1, 7 unused, 8, 3 and a NUL, 2, 2 unused
    assert memory.record_memory(field("[]")).size == 1
    optional = field("[{name: a, type: u32, optional: true}]")
    assert memory.record_memory(optional) == memory.Room(8, 4, 4)
    filling = field("[{name: a, type: u16, count: rest}]")
    assert memory.record_memory(filling) == memory.Room(2 + 2 * 126, 2, 2)


def test_the_widest_gaps_are_never_less() -> None:
    for record in INVENTED.records:
        usual, most = memory.record_memory(record), memory.record_memory(record, memory.widest)
        assert usual.size <= most.size and usual.last <= most.last
    assert memory.largest(INVENTED) % memory.MAX_ALIGNMENT == 0
    assert memory.largest(INVENTED) >= max(memory.record_memory(f).size for f in INVENTED.fields)


# --------------------------------------------------------------------------- calls


def names(parameters: tuple[m.Parameter, ...]) -> list[str]:
    return [p.name for p in parameters]


def test_constructors() -> None:
    f = field(
        "[{name: n, type: u8, for: W}, {name: a, type: u16, count: n, for: W},"
        " {name: z, type: u8, reserved: 0, for: W}, {name: o, type: u8, optional: true}]",
        functions="WR",
    )
    write, read = calls.constructors(f)
    assert [w.function.name for w in (write, read) if w.function] == ["write", "read"]
    assert (names(write.passed), names(write.values), names(write.addable)) == (["n", "a"], ["a"], ["o"])
    assert (names(read.passed), names(read.optional)) == ([], [])


def test_only_hosts_make_commands() -> None:
    assert calls.constructors(field("[{name: a, type: u8}]", role="data")) == ()
    assert [w.function for t in INVENTED.all_types if isinstance(t, m.Struct) for w in calls.constructors(t)]
