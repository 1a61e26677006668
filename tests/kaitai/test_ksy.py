"""The text of mip.ksy, without a compiler: names, references, and that nothing of the specification is missing."""

from __future__ import annotations

import dataclasses
import json
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from ksy_driver import Tree, file, ksy
from mipgen import model as m
from mipgen.facts import describe
from mipgen.targets.kaitai import expressions, view
from mipgen.targets.kaitai.names import MODULES, member, type_name, value
from support import SPECS, all_fields, model

specs = pytest.mark.parametrize("spec", sorted(SPECS))


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


def test_the_version_of_the_compiler_is_the_tested_one() -> None:
    packages = json.loads(Path(__file__).with_name("package.json").read_text("utf-8"))["dependencies"]
    version = packages["kaitai-struct-compiler"].removesuffix(".0")
    assert ksy(file("real"))["meta"]["ks-version"] == version
    assert f"kaitai-struct-compiler {version} or later" in (file("real").parent / "README.md").read_text("utf-8")


def test_all_modules_of_this_python_are_known() -> None:
    """A package of such a name would hide it; the answer must not depend on the Python that generates."""
    assert {name for name in sys.stdlib_module_names if not name.startswith("_")} <= MODULES


def test_types_of_the_framing_are_escaped() -> None:
    framing = [name for name, t in ksy(file("invented"))["types"].items() if not any(key[0] == "-" for key in t)]
    names = [type_name(m.Vector(name, m.SCALARS["u8"], ("x",), "")) for name in ("kind", "skipped", "packet")]
    assert names == ["kind_type", "skipped_type", "packet_type"] and {"skipped", "packet"} <= set(framing)


@specs
def test_what_readers_are_told(spec: str) -> None:
    """Titles, descriptions and units of everything that has a type, and the descriptions of values and bits."""
    of, tree = model(spec), ksy(file(spec))

    def told(text: str) -> str:
        return view.say(describe.prose(text, of))

    told_of = 0
    holders = [t for t in of.all_types if isinstance(t, m.Struct)]
    for record in (*holders, *all_fields(of)):
        t = tree["types"][type_name(record)]
        for words in (told(record.description), *(view.say(x.sentence) for x in describe.caveats(record, of))):
            assert words in t["doc"]
        assert not isinstance(record, m.Field) or t["doc"].startswith(record.title)
        seq = {a["id"]: a for a in t.get("seq", ())}
        assert set(seq) == {member(p.name) for p in record.parameters}
        for p in record.parameters:
            doc = seq[member(p.name)].get("doc", "")
            assert told(p.description) in doc
            assert not p.units or f"Unit{'s' if len(p.units) > 1 else ''}: {', '.join(p.units)}." in doc
            told_of += len(p.units)
            topics = ("positive", "valid", "variant", "note", "uncertain")
            for fact in describe.topics(describe.parameter(p, record, of), *topics):
                assert view.say(fact.sentence) in doc
    for e in (t for t in of.all_types if isinstance(t, m.Enum)):
        values = tree["enums"][type_name(e)]
        assert set(values) == {v.value for v in e.values}
        for v in e.values:
            entry = values[v.value] if isinstance(values[v.value], dict) else {"id": values[v.value], "doc": ""}
            doubts = [view.say(fact.sentence) for fact in describe.uncertain(v, of)]
            assert entry["id"] == value(v.name)
            assert " ".join(filter(None, (told(v.description), *doubts))) == entry.get("doc", "")
    assert told_of


def test_descriptors_of_a_set_go_before_shared_ones() -> None:
    of = model("invented")
    expression = expressions.kind(of)
    assert "set == " not in expression
    shared = next(f for f in of.fields if f.everywhere)
    other = next(f for f in of.fields if f.role == m.DATA and not f.everywhere)
    moved = dataclasses.replace(other, descriptor=shared.descriptor)
    families = [dataclasses.replace(x, fields=(*x.fields, moved)) if x.name == other.family else x for x in of.families]
    expression = expressions.kind(dataclasses.replace(of, families=tuple(families)))
    assert f"not (set == {other.set:#04x} and descriptor == {moved.descriptor:#04x})" in expression
