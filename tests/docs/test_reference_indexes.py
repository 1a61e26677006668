"""Everything in the model is in its index once, with a link to its place."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from mipgen import model as m
from reference import LINK, Manual, number, places, tables, words

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
    found, titles = [], {u.symbol: u.title for u in manual.model.protocol.units}
    for part in manual.page("indexes/units.md").split("\n## ")[1:]:
        unit = words(part.partition(": ")[0])
        assert words(part.partition("\n")[0]) == f"{unit}: {titles[unit]}"
        for row in (row for t in tables(part) for row in t):
            (field,) = ANCHORED.findall(row["Field"])
            found += [(unit, field, link) for link in ANCHORED.findall(row["Parameters"])]
    assert len(found) == len(set(found)) and set(found) == wanted


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


@pytest.mark.parametrize("name", ["descriptors", "names", "types", "units", "vendor"])
def test_size_and_links(manual: Manual, name: str) -> None:
    """A page is small enough for a browser; it can be reached from the start and the navigation."""
    assert len(manual.page(f"indexes/{name}.md")) < 600_000
    assert f"(indexes/{name}.md)" in manual.page("index.md")
