"""Every fact that `describe` knows is in the reference, where its readers look for it, and nothing else is."""

from __future__ import annotations

import functools
import operator
import re
from collections.abc import Iterable

from mipgen import model as m
from mipgen.facts import describe
from reference import (
    ANCHOR,
    Manual,
    Place,
    bullets,
    heading,
    manual_of,
    number,
    path_of,
    places,
    prose,
    rows_of,
    seen,
    table_with,
    words,
)
from support import some

#: Facts about a field that have sections of their own, with a line each.
RELATIONS = ("alternatives", "affects", "may_affect", "affected", "flags")
DEVICES = ("devices", "likely", "assumed", "refused", "deprecation", "support")

#: Which column of the table of parameters has which facts.
COLUMNS = {
    "required": "Required for", "optional": "Required for", "unit": "Unit", "frame": "Frame", "range": "Range",
    "default": "Default", "valid": "Valid flag",
}  # fmt: skip


def sentences(facts: Iterable[describe.Fact], prefix: str = "") -> list[str]:
    return [seen(f.sentence, prefix) for f in facts]


def paragraphs(section: str) -> list[str]:
    return [words(p) for p in section.strip("\n").split("\n\n")]


# --------------------------------------------------------------------------- fields


def test_every_fact_of_a_field(manual: Manual) -> None:
    """Heading, description, a paragraph of facts, notes, devices and relations; functions and replies are in tables."""
    for f in manual.model.fields:
        first, what, *rest = paragraphs(manual.field(f))
        level = "##" if f.role == m.RESPONSE else "#"
        assert first == f"{level} {f.title} {number(f)}"
        is_ = f"{f.full_name}, {f.role}. {prose(f.description, manual.model)}".strip()
        above = ["commands"] if f.role == m.RESPONSE and len(manual.model.commands(f)) == 1 else []
        facts = [x for x in describe.field(f, manual.model) if x.topic not in ("functions", "responses", *above)]
        said = " ".join(sentences([x for x in facts if x.topic not in (*RELATIONS, *DEVICES, "firmware", "note")]))
        notes = sentences(describe.topics(facts, "note", *(["firmware"] if f.role != m.RESPONSE else [])))
        wanted = [x for x in (said, "\n".join(f"- {n}" for n in notes)) if x]
        if f.role == m.RESPONSE:  # in one paragraph
            assert what.startswith(" ".join([is_, *([said] if said else []), "Field length: "])), f.full_name
            wanted = wanted[bool(said) :]
        else:
            assert what == is_, f.full_name
        assert rest[: len(wanted)] == wanted, f.full_name
        of_devices, relations = (sentences(describe.topics(facts, *topics)) for topics in (DEVICES, RELATIONS))
        if f.role != m.RESPONSE:
            both = of_devices + relations
            assert listed(manual.field(f), "Evidence")[: len(both)] == both
        elif not set(of_devices) <= {*listed(manual.page(path_of(f)), "Evidence")}:  # those of the command
            assert set(of_devices + relations) <= {*bullets(manual.field(f))}, f.full_name


def listed(page: str, title: str) -> list[str]:
    """The lines of a section; none if it is missing."""
    return bullets(page.partition(f"\n## {title}\n")[2].partition("\n## ")[0])


def test_sources_of_a_field(manual: Manual) -> None:
    """Its sections in the manuals, and wrong lengths given there; a response cites what its command cites."""
    for f in manual.fields:
        section = manual.field(f)
        listed = [x for row in in_sets(section) for x in words(row["In the manuals"]).split("; ")] or bullets(section)
        listed += [x for b in listed if b.startswith("In the manuals: ") for x in b[16:].split("; ")]
        for s, cited in zip(f.sources, describe.sources(f), strict=True):
            assert (f.role == m.RESPONSE and f.set) or any(b.startswith(cited) for b in listed), cited
            if f.min_size == f.max_size and s.length is not None and s.length.isdigit():
                remark = f"{s.manual}: length" if f.role == m.RESPONSE else f"{cited} (length"
                said = [b for b in (*bullets(section), *listed) if b.startswith(f"{remark} given as {s.length}")]
                others = [x for x in f.sources if x is not s and x.length == s.length]
                assert bool(said) == (int(s.length) != f.max_size + 2) or others, f.full_name
                assert all(f"instead of {f.max_size + 2}" in b for b in said)


def in_sets(section: str) -> list[dict[str, str]]:
    """The sets in which a field occurs, if they are several."""
    return table_with(section, "Set", "Name", "In the manuals")


def test_sets_of_a_field(manual: Manual) -> None:
    """Each set with the field's name in it, the devices that send it in this set, and its sections in the manuals."""
    of = manual.model
    several = [f for f in of.fields if len(f.occurrences) > 1]
    assert several
    for f in (f for f in of.fields if f.role != m.RESPONSE):
        rows = in_sets(manual.field(f))
        assert len(rows) == (len(f.occurrences) if f in several else 0)
        for o, row in zip(f.occurrences, rows, strict=False):
            s = some(of.set(o.set))
            assert words(row["Set"]) == heading(s) and f"(../../sets/{s.name}.md)" in row["Set"]
            assert words(row["Name"]) == f"{s.name}.{f.name}"
            known = {x: ", ".join(d.title for d in of.devices_of(f, x, o.set)) for x in m.SUPPORTED}
            said = [titles if x == "yes" else f"{x}: {titles}" for x, titles in known.items() if titles]
            assert words(row.get("Devices", "")) == "; ".join(said)
            said = words(row["In the manuals"])
            assert all(f"{c.manual}: {c.section}" in said for c in o.sources)


# --------------------------------------------------------------------------- parameters


def test_every_fact_of_a_parameter(manual: Manual) -> None:
    for f in manual.fields:
        section, _ = manual.parameters(f)
        check_parameters(manual, f, section)
    for t in manual.model.all_types:
        if isinstance(t, m.Struct):
            check_parameters(manual, t, manual.type(t))


def check_parameters(manual: Manual, record: m.Record, section: str) -> None:
    rows = table_with(section, "Offset", "Name")
    if isinstance(record, m.Field) and record.role == m.RESPONSE:  # the table may be that of its command
        rows = [{**row, "Required for": ""} for row in rows if words(row["Name"]) != "function"]
    listed = list(places(record))
    assert [words(row["Name"]) for row in rows] == [place.path for place in listed]
    below: list[str] = []
    for place, row in zip(listed, rows, strict=True):
        if isinstance(record, m.Field) and place.parameter is not None:
            path = re.sub(r"\[\w\]", "", place.path)
            assert f'<a id="{record.full_name}.{path}"></a>`{place.path}`' in manual.field(record)
        facts = describe.parameter(place.parameter, place.record, manual.model) if place.parameter else []
        cells = {column: words(row.get(column, "")) for column in [*COLUMNS.values(), "Description"]}
        wanted = dict.fromkeys(COLUMNS.values(), "")
        for fact in facts:
            if fact.topic in COLUMNS:
                wanted[COLUMNS[fact.topic]] = seen(fact.value or fact.sentence, place.prefix)
        rest = [x for x in facts if x.topic not in (*COLUMNS, "variant", "note")]
        case = [describe.case(*place.case, place.record)] if place.case else []
        what = told(place.parameter.description if place.parameter else "", manual)
        wanted["Description"] = " ".join([*sentences(case, place.prefix), *what, *sentences(rest, place.prefix)])
        assert cells == wanted, (record.name, place.path)
        below += [f"{place.path}: {x}" for x in sentences(describe.topics(facts, "variant", "note"), place.prefix)]
        check_type(manual, place, row)
    text = re.sub(r"<details.*>\n<summary>.* remarks .*</summary>\n\n", "", section)
    lists = text.partition("| Name | Type |")[2].partition("\n\n")[2].split("\n\n")
    shown = [x for x in bullets(lists[0]) if " Ignore the other bits. Type: " not in x]  # see below
    assert shown == below or (not below and not lists[0].startswith("- "))


def check_type(manual: Manual, place: Place, row: dict[str, str]) -> None:
    p = place.parameter
    if p is None or p.element is None:
        assert words(row["Type"]) == ("union" if p else "")
        return
    scalar = p.element.scalar if isinstance(p.element, (m.Enum, m.Bitfield)) else None
    count = "" if p.length == "rest" else place.prefix + p.length if isinstance(p.length, str) else p.length
    many = "" if p.length is None else f"[{count}]"
    assert words(row["Type"]) == p.element.name + many + (f" {scalar.name}" if scalar else "")


def test_values_beside_parameters(manual: Manual) -> None:
    """The values and bits of each type that a parameter may have, those that overlap included, on the same page."""
    for f in manual.fields:
        page = manual.page(path_of(f)) if f.set else manual.page("packets.md")
        found = re.findall(r"^##+ Values of ([^\n]*?)(?: \(`(\w+)`\))?$(.*?)(?=^#)", page + "\n#", re.M | re.S)
        found = [(users, name or users.strip("`"), text) for users, name, text in found]
        for place in places(f):
            p = place.parameter
            for t in [p.element, *(v.type for v in p.readings)] if p and not p.selector else []:
                if isinstance(t, m.Bitfield) and len(t.bits) == 1 and t.scalar:
                    (bit, mask, bit_name, about), *_ = wanted_rows(t, manual)
                    said = f": {bit}, {bit_name} ({mask}): {about} Ignore the other bits. Type: {t.name}."
                    lines = re.findall(rf"^- .*`{re.escape(place.path)}`.*: .*$", page, re.M)
                    (line,) = [x for x in lines if words(x).endswith(said)]
                    assert [a.rpartition(".")[2] for a in ANCHOR.findall(line)] == [bit_name]
                elif isinstance(t, (m.Enum, m.Bitfield)):
                    (text,) = [x for users, name, x in found if f"`{place.path}`" in users and name == t.name]
                    rows = wanted_rows(t, manual)
                    assert rows_of(text)[2:] == rows, (f.full_name, t.name)
                    parts = t.values if isinstance(t, m.Enum) else t.bits
                    anchors = ANCHOR.findall("".join(re.findall(r"^\|.*", text, re.M)))
                    assert [a.rpartition(".")[2] for a in anchors] == [x.name for x in parts]


# --------------------------------------------------------------------------- values and bits


def test_every_fact_of_a_value_and_a_bit(manual: Manual) -> None:
    for t in manual.model.all_types:
        wanted = wanted_rows(t, manual)
        assert rows_of(manual.type(t))[2 : 2 + len(wanted)] == wanted, t.name


def wanted_rows(t: m.Type, manual: Manual) -> list[list[str]]:
    """The table of values or bits."""
    wanted = []
    if isinstance(t, m.Enum):
        for v in t.values:
            text = " ".join([*told(v.description, manual), *sentences(describe.value(v, manual.model))])
            wanted.append([str(v.value), f"0x{v.value:0{2 * t.scalar.size}X}", v.name, text])
    elif isinstance(t, m.Bitfield):
        for b in t.bits:
            place, *facts = describe.bits(b, manual.model)
            mask = f"0x{b.mask:0{2 * t.size}X}" if t.scalar else f"{b.first // 8}.{b.first % 8}"
            text = " ".join([*told(b.description, manual), *sentences(facts)])
            wanted.append([seen(place.value), mask, b.name, text])
        free = (1 << 8 * t.size) - 1 & ~functools.reduce(operator.or_, (b.mask for b in t.bits), 0)
        if free and t.scalar:
            row = ["other bits", f"0x{free:0{2 * t.size}X}", "", "Reserved or unknown: ignore them."]
            wanted.append(row)
    if wanted and not any(row[-1] for row in wanted):
        wanted = [row[:-1] for row in wanted]
    return wanted


def told(description: str, manual: Manual) -> list[str]:
    return [prose(description, manual.model)] if description else []


def test_examples_name_what_descriptors_mean() -> None:
    page = words(manual_of("invented").page("fields/tools/poll.md"))
    assert "| 0x80 Measurements |" in page and "| 0x01 Acceleration, 0x02 Numbers, 0xD3 Timestamp, 0x7F |" in page
