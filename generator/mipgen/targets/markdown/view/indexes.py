"""Indexes by descriptor, name, type, unit, and the vendor's name."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass

from mipgen import model as m

from ..offsets import parameter_offsets
from ..places import Page, label
from ..text import code, hexadecimal, inline, table
from .devices import Section
from .parameters import parameter_anchor
from .types import nature


@dataclass(frozen=True, slots=True)
class IndexPage:
    name: str  # of the file
    title: str  # in lists of pages
    heading: str
    about: str
    contents: Callable[[Page], Iterable[Section]]

    @property
    def path(self) -> str:
        return f"docs/indexes/{self.name}.md"


def descriptor_table(page: Page) -> Iterator[Section]:
    """Lists every descriptor of every set in order, including those without a layout."""
    headings = ["Descriptor", "Short", "Field", "Name", "Role"]
    yield Section("Every command set", table([_described(page, page.model.protocol.acknowledge, 0)], headings))
    for s in page.model.sets:
        yield Section(label(s), table(_of_set(page, s), headings))


def _of_set(page: Page, s: m.Set) -> list[list[str]]:
    rows = [(f.descriptor, _described(page, f, s.number)) for f in page.model.fields_in(s)]
    family = page.model.family(s.family)
    for x in family.named if family else ():
        link = page.link(s, inline(x.title))
        rows.append((x.descriptor, [*_spelled(s.number, x.descriptor), link, code(f"{s.name}.{x.name}"), x.role]))
    return [row for _, row in sorted(rows, key=lambda row: row[0])]


def _described(page: Page, f: m.Field, number: int) -> list[str]:
    title = next((o.title for o in f.occurrences if o.set == number), f.title)
    return [*_spelled(number, f.descriptor), page.link(f, inline(title)), code(f.name_in(number)), f.role]


def _spelled(set_: int, descriptor: int) -> list[str]:
    """Writes set and descriptor in both notations; for the acknowledge, which has no set of its own, the descriptor."""
    second = hexadecimal(descriptor)
    if not set_:
        return [code(second), ""]
    return [code(f"{hexadecimal(set_)},{second}"), code(f"{hexadecimal(set_)}{second[2:]}")]


# --------------------------------------------------------------------------- by letters


def by_title(page: Page) -> list[Section]:
    """Lists every field by its title."""
    rows = [
        (f.title, [page.link(f), code(f.full_name), f.role])
        for f in (page.model.protocol.acknowledge, *page.model.fields)
    ]
    return lettered(rows, ["Field", "Name", "Role"])


def type_users(page: Page) -> list[Section]:
    """Lists every type, and the fields and types that use it."""
    rows = [
        (t.name, [page.link(t), inline(getattr(t, "owner", None) or ""), nature(t), page.links(page.index.users(t))])
        for t in page.model.all_types
    ]
    return lettered(rows, ["Type", "Set", "Kind", "Used by"])


def vendor(page: Page) -> list[Section]:
    """Lists other names of fields and devices."""
    rows = [
        (name, [code(name), page.link(f), code(f.full_name)])
        for f in (page.model.protocol.acknowledge, *page.model.fields)
        for name in f.also
    ]
    rows += [(name, [code(name), page.link(d), ""]) for d in page.model.devices for name in d.also]
    return lettered(rows, ["Vendor's name", "Here", "Name"])


def lettered(rows: Iterable[tuple[str, Sequence[str]]], headings: Sequence[str]) -> list[Section]:
    """Writes a table for each letter; entries that begin with a digit come first."""
    by_letter: dict[str, list[Sequence[str]]] = {}
    for word, row in sorted(rows, key=lambda row: (row[0].lower(), row[1])):
        by_letter.setdefault("0 to 9" if word[:1].isdigit() else word[:1].upper(), []).append(row)
    return [Section(letter, table(group, headings)) for letter, group in by_letter.items()]


# --------------------------------------------------------------------------- by unit


def unit_table(page: Page) -> list[Section]:
    """Lists, for each unit, the parameters that use it, also on single devices."""
    by_unit: dict[str, list[list[str]]] = {u.key: [] for u in page.model.protocol.units}
    for f in (page.model.protocol.acknowledge, *page.model.fields):
        of_field: dict[str, dict[str, None]] = {}
        for key, link in _measured(page, f):
            of_field.setdefault(key, {})[link] = None
        for key, links in of_field.items():
            by_unit[key].append([page.link(f), ", ".join(links)])
    titles = {u.key: u for u in page.model.protocol.units}
    return [
        Section(f"{inline(titles[key].symbol)}: {inline(titles[key].title)}", table(rows, ["Field", "Parameters"]))
        for key, rows in by_unit.items()
        if rows
    ]


def _measured(page: Page, f: m.Field) -> Iterator[tuple[str, str]]:
    """Yields the keys of the units in a field, each with a link to a parameter that uses it."""
    for row in parameter_offsets(f):
        if row.parameter is None:
            continue
        link = f"[{code(row.name)}]({page.url(f).partition('#')[0]}#{parameter_anchor(f, row)})"
        own = (u for v in row.parameter.variants for u in v.units)
        for key in dict.fromkeys((*row.parameter.units, *own)):
            yield key, link


# --------------------------------------------------------------------------- all of them

INDEXES = (
    IndexPage(
        "descriptors", "By descriptor", "Index by descriptor",
        "Every descriptor of every set in order: commands, responses and data fields.", descriptor_table,
    ),
    IndexPage("names", "By name", "Index by name", "Every command, response and data field by its title.", by_title),
    IndexPage("types", "By type", "Index by type", "Every type, and the fields and types that use it.", type_users),
    IndexPage(
        "units", "By unit", "Index by unit",
        "For each [unit](../units.md), the parameters that use it, at least on some devices.", unit_table,
    ),
    IndexPage(
        "vendor", "By the vendor's names", "Index by the vendor's names",
        "Other names of fields and devices, as used in the vendor's manuals and software.", vendor,
    ),
)  # fmt: skip
