"""Everything in the model is in its index once, with a link to its place."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from mipgen import model as m
from reference import LINK, Manual, manual_of, number, places, tables, words
from support import SPECS, need, small, uses

with_node = uses("node")

ANCHORED = re.compile(r"\]\([^)]*?#([\w.]+)\)")


def rows(manual: Manual, name: str) -> list[dict[str, str]]:
    return [row for t in tables(manual.page(f"indexes/{name}.md")) for row in t]


def anchor(t: m.Type | m.Field) -> str:
    if isinstance(t, m.Field):
        return t.full_name
    return f"protocol.{t.name}" if t.name == "function_selector" else f"{getattr(t, 'owner', None) or 'types'}.{t.name}"


def test_by_descriptor(manual: Manual) -> None:
    of = manual.model
    entries = [(o.set, f.descriptor, f.role, f.name_in(o.set)) for f in manual.fields for o in f.occurrences]
    known = {f.name_in(o.set): f for f in manual.fields for o in f.occurrences}
    named = [(s, x) for y in of.families for s in y.sets for x in y.named]
    entries += [(s.number, x.descriptor, x.role, f"{s.name}.{x.name}") for s, x in named]
    found = rows(manual, "descriptors")
    places_ = []
    for row in found:
        role, name = words(row["Role"]), words(row["Name"])
        numbers = [int(n, 16) for n in words(row["Descriptor"]).split(",")]
        set_, descriptor = numbers if len(numbers) == 2 else (0, *numbers)
        assert words(row.get("Short", "")) == (f"0x{set_:02X}{descriptor:02X}" if set_ else "")
        to = f"#{known[name].full_name})" if name in known else f"/{name.partition('.')[0]}.md)"
        assert to in row["Field"]
        places_.append((set_, descriptor, role, name))
    assert sorted(places_) == sorted(entries)
    assert [p[:2] for p in places_] == sorted(p[:2] for p in places_)


def test_by_name(manual: Manual) -> None:
    found = rows(manual, "names")
    assert sorted(ANCHORED.findall(row["Field"])[0] for row in found) == sorted(f.full_name for f in manual.fields)
    by_name = {f.full_name: f for f in manual.fields}
    for row in found:
        f = by_name[words(row["Name"])]
        assert words(row["Field"]) == f"{f.title} {number(f)}" and words(row["Role"]) == f.role
    letters_in_order(manual, "names", [by_name[words(row["Name"])].title for row in found])


def letters_in_order(manual: Manual, page: str, entries: list[str]) -> None:
    """Entries are sorted, below a heading for each letter."""
    assert [e.lower() for e in entries] == sorted(e.lower() for e in entries)
    headings = re.findall(r"^## (.*)$", manual.page(f"indexes/{page}.md"), re.M)
    assert headings == list(dict.fromkeys("0 to 9" if e[0].isdigit() else e[0].upper() for e in entries))


def test_by_type(manual: Manual) -> None:
    of, found = manual.model, rows(manual, "types")
    types = {anchor(t): t for t in of.all_types}
    assert sorted(ANCHORED.findall(row["Type"])[0] for row in found) == sorted(types)
    users: dict[str, set[str]] = {name: set() for name in types}
    records = [*manual.fields, *m.structs(of.all_types)]
    for record in records:
        for t in used(record.parameters):
            users.setdefault(anchor(t), set()).add(anchor(record))
    for t in of.all_types:
        for b in t.bits if isinstance(t, m.Bitfield) else ():
            if b.enum:
                users[anchor(b.enum)].add(anchor(t))
    for row in found:
        name = ANCHORED.findall(row["Type"])[0]
        links = ANCHORED.findall(row.get("Used by", ""))
        assert len(links) == len(set(links)) and set(links) == users[name], name
    letters_in_order(manual, "types", [words(row["Type"]) for row in found])


def used(parameters: tuple[m.Parameter, ...]) -> Iterator[m.Type]:
    for p in parameters:
        if isinstance(p.element, (m.Enum, m.Bitfield, m.Struct, m.Vector)):
            yield p.element
        yield from (v.type for v in p.variants if v.type)
        yield from used(tuple(c.parameter for c in p.cases if c.parameter))


def test_by_unit(manual: Manual) -> None:
    wanted = set()
    for f in manual.fields:
        for place in places(f):
            p = place.parameter
            for unit in {*p.units, *(u for v in p.variants for u in v.units)} if p else ():
                path = re.sub(r"\[.\]", "", place.path)
                wanted.add((unit, f.full_name, f"{f.full_name}.{path}"))
    found = []
    for part in manual.page("indexes/units.md").split("\n## ")[1:]:
        unit = words(part.partition(": ")[0])
        assert words(part.partition("\n")[0]) == f"{unit}: {titles(manual)[unit]}"
        for row in (row for t in tables(part) for row in t):
            (field,) = ANCHORED.findall(row["Field"])
            found += [(unit, field, link) for link in ANCHORED.findall(row["Parameters"])]
    assert len(found) == len(set(found)) and set(found) == wanted


def titles(manual: Manual) -> dict[str, str]:
    return {u.symbol: u.title for u in manual.model.protocol.units}


def test_by_the_names_of_the_vendor(manual: Manual) -> None:
    wanted = [(name, f.full_name) for f in manual.fields for name in f.also]
    wanted += [(name, d.id) for d in manual.model.devices for name in d.also]
    found = rows(manual, "vendor")
    said = [
        (words(row["Vendor's name"]), words(row.get("Name", "")) or Path(LINK.findall(row["Here"])[0][1]).stem)
        for row in found
    ]
    assert sorted(said) == sorted(wanted)
    letters_in_order(manual, "vendor", [words(row["Vendor's name"]) for row in found])


@pytest.mark.parametrize(
    "name", ["descriptors", "names", "types", "units", "vendor", "c", "cpp", "python", "rust", "javascript"]
)
def test_size_and_links(manual: Manual, name: str) -> None:
    """A page is small enough for a browser; it can be reached from the start and the navigation."""
    assert len(manual.page(f"indexes/{name}.md")) < 600_000
    assert f"(indexes/{name}.md)" in manual.page("index.md")


# --------------------------------------------------------------------------- symbols


def symbols(manual: Manual, language: str) -> dict[str, tuple[str, list[str]]]:
    """Symbol of a field or type -> the anchor to which it leads, and its other symbols."""
    found = [
        (words(row["Symbol"]), ANCHORED.findall(row["Field or type"])[0], re.findall(r"`([^`]+)`", others))
        for row in rows(manual, language)
        for others in (row.get("Functions and constants", ""),)
    ]
    assert len({name for name, *_ in found}) == len(found)
    return {name: (to, others) for name, to, others in found}


def test_every_type_and_field_has_symbols(manual: Manual) -> None:
    of = manual.model
    every = [*manual.fields, *of.all_types, of.protocol.function_selector]
    absent = {
        "c": m.Vector,
        "cpp": m.Vector,
        "javascript": (m.Vector, m.Struct),
    }  # arrays and objects have no name in programs
    for language in ("c", "cpp", "python", "rust", "javascript"):
        shown = [to for to, _ in symbols(manual, language).values()]
        wanted = [anchor(t) for t in every if not isinstance(t, absent.get(language, ()))]
        assert sorted(shown) == sorted(wanted), language


def listed(manual: Manual, language: str) -> set[str]:
    shown = [x for name, (_, others) in symbols(manual, language).items() for x in (name, *others)]
    assert language != "c" or len(shown) == len(set(shown))
    return set(shown)


DECLARED_IN_C = re.compile(
    r"^#define (MIP_\w+)[ (]|^(?:enum|struct|union) (mip_\w+) (?:MIP_ENUM_\d+ )?\{|^typedef \w+ (mip_\w+);"
    r"|^\s+(MIP_\w+) = |^extern MIP_API const [\w ]*?(mip_\w+)[;\[]|^(?:\w[\w ]*[ *])?(mip_\w+)\(",
    re.M,
)


@small("symbols of the real bindings")
def test_symbols_of_c(spec: str) -> None:
    """The index has the symbols of the headers, without those of sets; some are declared by macros."""
    manual, source = manual_of(spec), SPECS[spec][1] / "c/src/mip"
    modules = [re.sub(r"\W", "_", x.name) for x in manual.model.families]
    headers = ["types.h", "protocol.h", "extra/names.h", *(f"{name}.h" for name in modules)]
    further = [f"{name}_{end}.h" for name in (*modules, "protocol") for end in ("commands", "inline")]
    headers += [name for name in further if (source / name).exists()]
    declared = {
        next(filter(None, found))
        for name in headers
        for found in DECLARED_IN_C.findall((source / name).read_text("utf-8"))
    }
    of_sets = {f"MIP_{s.name.upper()}_SET" for s in manual.model.sets}
    of_core = {"MIP_BARRIER_SET", "MIP_BARRIER_DESCRIPTOR"}  # which a firmware may define
    written = {name for name in declared - of_sets - of_core if not name.endswith("_H")}
    headers = "".join(f'#include "mip/{name}"\n' for name in headers)
    command = [need("cc"), "-E", "-P", f"-I{source.parent}", "-x", "c", "-"]
    expanded = subprocess.run(command, input=headers, capture_output=True, text=True, check=True).stdout
    index = listed(manual, "c")
    assert written <= index and index - written <= set(re.findall(r"\bmip_\w+", expanded))


@uses("g++")
@small("names of the real C++ library")
def test_symbols_of_cpp(spec: str, tmp_path: Path) -> None:
    """Programs can use each: types, functions of fields, values of enumerations."""
    uses = []
    for name, (_, others) in symbols(manual_of(spec), "cpp").items():
        uses.append(f"static_assert(sizeof({name}) > 0);")
        uses += [f"static_assert(sizeof({f'{name}{{}}.{x}' if x.endswith('()') else x}) > 0);" for x in others]
    program = tmp_path / "symbols.cpp"
    program.write_text('#include "mip/cpp/mip.hpp"\n' + "\n".join(uses) + "\n")
    source = SPECS[spec][1] / "c/src"
    done = subprocess.run(
        [need("g++"), "-std=c++17", "-fsyntax-only", f"-I{source}", program], capture_output=True, text=True
    )
    assert done.returncode == 0 and len(uses) > 50, done.stderr[-2000:]


LOOK_UP = """
import importlib, json, pkgutil, sys
import mip_protocol
from mip_protocol import codec, field
asked = json.load(sys.stdin)
modules = [importlib.import_module(f"mip_protocol.{name}") for name in {n.split(".")[1] for n in asked}]
kinds = (field.Field, field.Structure, codec.OpenEnum, __import__("enum").IntFlag)
there = [f"{m.__name__}.{name}" for m in modules for name, c in vars(m).items()
         if isinstance(c, type) and c.__module__ == m.__name__ and (issubclass(c, kinds) or hasattr(c, "_fields"))]
absent = []
for name, others in asked.items():
    package, module, cls = name.split(".")
    c = getattr(importlib.import_module(f"{package}.{module}"), cls)
    absent += [o for o in others if o.split(".")[0] != cls or not hasattr(c, o.split(".")[1])]
print(json.dumps([there, absent]))
"""


@small("symbols of the real bindings")
def test_symbols_of_python(spec: str) -> None:
    """All classes of the package that are fields or types; the symbols listed with them exist."""
    found = {name: others for name, (_, others) in symbols(manual_of(spec), "python").items()}
    done = subprocess.run(
        [sys.executable, "-c", LOOK_UP], cwd=SPECS[spec][1] / "python", input=json.dumps(found),
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    there, absent = json.loads(done.stdout)
    assert sorted(there) == sorted(found) and not absent


@small("symbols of the real bindings")
def test_symbols_of_rust(spec: str) -> None:
    """All types of the modules; the symbols listed with them are in the same module."""
    manual, source = manual_of(spec), SPECS[spec][1] / "rust/src"
    texts = {path.stem: path.read_text("utf-8") for path in (source / "sets").glob("*.rs")}
    texts |= {name: (source / f"{name}.rs").read_text("utf-8") for name in ("types", "protocol")}
    declared = {
        f"mip_protocol::{module}::{name}"
        for module, text in texts.items()
        for name in re.findall(r"^ +pub (?:struct|enum) (\w+)|", text, re.M)
        + re.findall(r"^(?:open_enum|bitfield|vector)! \{\n(?: +(?:///|#).*\n)* +(\w+):", text, re.M)
        if name
    }
    found = symbols(manual, "rust")
    unions = {
        f"{name.rpartition('::')[0]}::{other}"
        for name, (_, others) in found.items()
        for other in others
        if "::" not in other
    }
    assert declared - {"mip_protocol::protocol::DescriptorSet"} == {*found, *unions}  # it is no type of a specification
    for name, (_, others) in found.items():
        text = texts[name.split("::")[1]]
        for other in others:
            assert re.search(rf"\b{other.rpartition('::')[2]}\b", text), other


EXPORTED = """
import fs from "node:fs";
const asked = JSON.parse(fs.readFileSync(0, "utf8"));
const modules = {};
for (const [name] of asked) modules[name.split(".")[0]] ??= await import(name.split(".")[0]);
const listed = new Map(asked.map(([name, others]) => {
    const [module, cls] = name.split(".");
    return [modules[module][cls], others.map((one) => one.split("."))];
}));
const all = Object.values(modules).flatMap((module) => Object.values(module));
const unlisted = all.filter((thing) => (thing.nameOf || thing.namesOf || thing.NAME) && !listed.has(thing));
const absent = [...listed].filter(([thing, others]) => !thing || others.some(([, one]) => thing[one] === undefined));
console.log(listed.size, unlisted.length, absent.length);
"""


@small("symbols of the real bindings")
@with_node
def test_symbols_of_javascript(spec: str, tmp_path: Path) -> None:
    """Every export that is a field or has names for numbers; the symbols listed with it exist."""
    found = [(name, others) for name, (_, others) in symbols(manual_of(spec), "javascript").items()]
    (tmp_path / "node_modules").mkdir()
    (tmp_path / "node_modules/mip-protocol").symlink_to(SPECS[spec][1] / "javascript")
    (tmp_path / "look_up.mjs").write_text(EXPORTED)
    done = subprocess.run(
        [need("node"), tmp_path / "look_up.mjs"], input=json.dumps(found), capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stdout) == (0, f"{len(found)} 0 0\n"), done.stderr
