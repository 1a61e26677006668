"""The text of mip.ksy, without a compiler: names, references, and that nothing of the specification is missing."""

from __future__ import annotations

import dataclasses
import re
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from ksy_driver import Tree, file, ksy
from mipgen import cli
from mipgen import model as m
from mipgen.facts import describe
from mipgen.targets import kaitai
from mipgen.targets.kaitai.names import member, type_name, value
from spec_defaults import filled
from support import SPECS, all_fields, model

specs = pytest.mark.parametrize("spec", sorted(SPECS))
BUILT_IN = re.compile(r"[us][1248]|f[48]|b\d+|str")


def types(tree: Tree, path: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], Tree]]:
    for name, t in tree.get("types", {}).items():
        yield (*path, name), t
        yield from types(t, (*path, name))


@specs
def test_every_descriptor_is_a_kind_with_a_type(spec: str) -> None:
    of, tree = model(spec), ksy(file(spec))
    kinds = tree["enums"]["kind"]
    assert set(kinds) == {o.set << 8 | f.descriptor for f in all_fields(of) for o in f.occurrences}
    homes = tree["types"]["field"]["instances"]["data"]["type"]["cases"]
    assert set(homes) == {f"kind::{k['id']}" for k in kinds.values()}
    for f, o in ((x, o) for x in all_fields(of) for o in x.occurrences):
        kind = kinds[o.set << 8 | f.descriptor]
        layouts = tuple(g for g in of.layouts(f) if o.set in g.sets) or (f,)
        assert kind["-role"] == f.role and kind["-orig-id"] == layouts[0].name_in(o.set)
        home = tree["types"][homes[f"kind::{kind['id']}"]]
        if len(layouts) > 1:
            chosen = home["seq"][0]["type"]["cases"]
            assert [tree["types"][t]["-orig-id"] for t in chosen.values()] == [g.full_name for g in layouts]
        else:
            assert home["-orig-id"] == f.full_name
    assert sum("-orig-id" in t for _, t in types(tree)) == len(all_fields(of))


@specs
def test_a_packet_begins_with_the_sync_bytes(spec: str) -> None:
    first, second = model(spec).protocol.sync
    assert f"sync == 0x{first:02x}{second:02x} " in re.sub(r"\s+", " ", file(spec).read_text("utf-8")).lower()


def test_what_a_count_must_obey() -> None:
    """The array must fit, with the bytes between it and its counter; without those bytes, nothing is counted."""
    known = ksy(file("invented"))["types"]
    assert {
        (kind, a["id"]): a["valid"]["expr"]
        for kind in ("tools_path", "tools_formats")
        for a in known[kind]["seq"]
        if "expr" in a.get("valid", {})
    } == {
        ("tools_path", "num_points"): "_ <= 62 and _ * 4 <= _io.size - _io.pos",
        ("tools_formats", "num_segments"): "_io.size - _io.pos < 1 or (_ <= 25 and _ * 10 + 1 <= _io.size - _io.pos)",
    }


def test_a_union_has_a_type_of_its_own() -> None:
    circle = ksy(file("invented"))["types"]["tools_circle"]
    assert [(a["id"], a["type"]) for a in circle["seq"]] == [
        ("center", "point"), ("fill", "u1"), ("filling", "filling_cases"),
    ]  # fmt: skip
    chosen = {a["id"]: (a["type"], a["if"]) for a in circle["types"]["filling_cases"]["seq"]}
    assert chosen["striped"] == ("tools_stripes", "_parent.fill == tools_fill::striped")


def test_after_an_impossible_length_nothing_is_a_field() -> None:
    conditions = {a["id"]: a.get("if") for a in ksy(file("invented"))["types"]["field"]["seq"]}
    assert conditions == {
        "length": None, "malformed": "not is_sound", "descriptor": "is_sound", "content": "is_sound",
    }  # fmt: skip


@specs
def test_what_is_referred_to_exists(spec: str) -> None:
    tree = ksy(file(spec))
    known = set(tree["types"])
    for path, t in types(tree):
        near = known | set(t.get("types", {}))
        for a in [*t.get("seq", ()), *t.get("instances", {}).values()]:
            kind = a.get("type", "str")
            for name in kind["cases"].values() if isinstance(kind, dict) else [kind.partition("(")[0]]:
                assert BUILT_IN.fullmatch(name) or name in near, (path, name)
            assert a.get("enum") is None or a["enum"] in tree["enums"], (path, a)
    for enum, name in re.findall(r"(\w+)::(\w+)", file(spec).read_text("utf-8")):
        assert any(name == (v if isinstance(v, str) else v["id"]) for v in tree["enums"][enum].values()), (enum, name)


@specs
def test_identifiers_are_legal(spec: str) -> None:
    tree = ksy(file(spec))
    names = [n for path, _ in types(tree) for n in path] + list(tree["enums"])
    for _, t in types(tree):
        names += [a["id"] for a in t.get("seq", ())] + list(t.get("instances", {}))
    for e in tree["enums"].values():
        names += [v if isinstance(v, str) else v["id"] for v in e.values()]
    wrong = [n for n in names if not re.fullmatch(r"[a-z][a-z0-9_]*", n)]
    assert not wrong and len(names) > len(tree["types"])


@specs
def test_what_readers_are_told(spec: str) -> None:
    """Titles, descriptions and units of everything that has a type, and the descriptions of values and bits."""
    of, tree = model(spec), ksy(file(spec))

    def told(text: str) -> str:
        return kaitai.say(describe.prose(text, of))

    told_of = 0
    holders = [t for t in of.all_types if isinstance(t, m.Struct)]
    for record in (*holders, *all_fields(of)):
        t = tree["types"][type_name(record)]
        assert told(record.description) in t["doc"]
        assert not isinstance(record, m.Field) or t["doc"].startswith(record.title)
        seq = {a["id"]: a for a in t.get("seq", ())}
        assert set(seq) == {member(p.name) for p in record.parameters}
        for p in record.parameters:
            doc = seq[member(p.name)].get("doc", "")
            assert told(p.description) in doc
            assert not p.units or f"Unit{'s' if len(p.units) > 1 else ''}: {', '.join(p.units)}." in doc
            told_of += len(p.units)
    for e in (t for t in of.all_types if isinstance(t, m.Enum)):
        values = tree["enums"][type_name(e)]
        assert set(values) == {v.value for v in e.values}
        for v in e.values:
            entry = values[v.value] if isinstance(values[v.value], dict) else {"id": values[v.value], "doc": ""}
            assert entry["id"] == value(v.name) and told(v.description) == entry.get("doc", "")
    assert told_of


def generated(tmp_path: Path, text: str) -> tuple[int, Path]:
    """A specification with one more set."""
    spec = tmp_path / "spec"
    shutil.copytree(SPECS["invented"][0], spec)
    (spec / "sets/extra.yaml").write_text(filled(text), "utf-8")
    out = tmp_path / "out"
    return cli.main(["generate", "--spec", str(spec), "--out", str(out), "--target", "kaitai"]), out / "kaitai/mip.ksy"


def test_names_that_only_case_would_join_collide(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code, _ = generated(
        tmp_path,
        """
set: 0x61
name: extra
title: Extra
description: "Names that Java, C# and JavaScript write alike."
fields:
  - command: 0x01
    name: field
    title: Field
    description: D.
    sources: [{manual: leaflet, section: S}]
    parameters: [{name: pos_1, type: u8}, {name: pos1, type: u8}]
""",
    )
    assert code == 1
    assert "'pos1' and 'pos_1' both become pos1 in the type extra_field of the target kaitai" in capsys.readouterr().err


def test_descriptors_of_a_set_go_before_shared_ones() -> None:
    of = model("invented")
    expression = kaitai.kind(of)
    assert "set == " not in expression
    shared = next(f for f in of.fields if f.everywhere)
    other = next(f for f in of.fields if f.role == m.DATA and not f.everywhere)
    moved = dataclasses.replace(other, descriptor=shared.descriptor)
    families = [dataclasses.replace(x, fields=(*x.fields, moved)) if x.name == other.family else x for x in of.families]
    expression = kaitai.kind(dataclasses.replace(of, families=tuple(families)))
    assert f"not (set == {other.set:#04x} and descriptor == {moved.descriptor:#04x})" in expression
