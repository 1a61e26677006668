"""The comparison of devices agrees with the model, and distinguishes what is unknown from what is absent."""

from __future__ import annotations

import re

import pytest
from mipgen import model as m
from mipgen.facts import describe
from reference import Manual, heading, number, seen, tables, words
from test_reference_things import letters

FIELD = re.compile(r"\]\([^)#]*#([\w.]+)\)")
DEVICE = re.compile(r"\]\(\.\./devices/([^)/]+)\.md\)")


def compared(manual: Manual) -> list[m.Device]:
    return [d for d in manual.model.devices if d.certain]


def missing(d: m.Device) -> str:
    return "?" if d.incomplete else "no"


def by_device(row: dict[str, str]) -> dict[str, str]:
    return {found[1]: words(cell) for heading, cell in row.items() if (found := DEVICE.search(heading))}


def matrix(manual: Manual, page: str, title: str) -> dict[str, dict[str, str]]:
    """The cells of a table: row -> device -> text."""
    section = manual.page(page).partition(f"\n## {title}\n")[2].partition("\n## ")[0]
    return {words(next(iter(row.values()))): by_device(row) for t in tables(section) for row in t}


Known = tuple[dict[tuple[str, int], m.Support], set[tuple[str, int]]]


def known(manual: Manual) -> dict[str, Known]:
    """Device -> what it has and what it rejects, by the name of a field and a set."""
    return {d.id: known_of(d) for d in compared(manual)}


def known_of(d: m.Device) -> Known:
    return {(s.field.full_name, s.set): s for s in d.supports}, {(s.field.full_name, s.set) for s in d.refuses}


def expected(d: m.Device, f: m.Field, number: int, of: Known) -> str:
    supported, refused = of
    if (f.full_name, number) in refused:
        return "no"
    s = supported.get((f.full_name, number))
    if s is None:
        return missing(d)
    said = letters(s.functions) or ("yes" if s.certain else "")
    return f"{'' if s.certain else s.evidence.answer + ' '}{said}".strip() + (", deprecated" if s.deprecated else "")


@pytest.mark.parametrize(("page", "role"), [("commands", m.COMMAND), ("data", m.DATA)])
def test_what_devices_support(manual: Manual, page: str, role: str) -> None:
    """Every command and data field once in each of its sets, with a cell for each device with known fields."""
    of, told = manual.model, known(manual)
    _, *sections = (
        manual.page(f"compare/{page}.md").partition("\n## Devices without certain fields\n")[0].split("\n## ")
    )
    in_sets = [(s, [f for f in of.fields_in(s) if f.role == role]) for s in of.sets]
    wanted = [(s, fields) for s, fields in in_sets if fields]
    assert [text.partition("\n")[0] for text in sections] == [heading(s) for s, _ in wanted]
    for (s, fields), text in zip(wanted, sections, strict=True):
        rows = [row for t in tables(text) for row in t]
        assert [FIELD.findall(row["Field"])[0] for row in rows] == [f.full_name for f in fields]
        for f, row in zip(fields, rows, strict=True):
            assert words(row["Descriptor"]) == f"0x{f.descriptor:02X}" and words(row["Field"]) == f.title
            wanted_of = {d.id: expected(d, f, s.number, told[d.id]) for d in compared(manual)}
            assert by_device(row) == wanted_of, f.name_in(s.number)


@pytest.mark.parametrize(("page", "role"), [("commands", m.COMMAND), ("data", m.DATA)])
def test_what_other_devices_may_support(manual: Manual, page: str, role: str) -> None:
    text = manual.page(f"compare/{page}.md").partition("\n## Devices without certain fields\n")[2]
    others = [d for d in manual.model.devices if not d.certain]
    rows = {DEVICE.findall(row["Device"])[0]: row for t in tables(text) for row in t}
    wanted = {
        d.id: [[s.field.full_name for s in x if s.field.role == role] for x in (d.likely, d.assumed)] for d in others
    }
    assert sorted(DEVICE.findall(text)) == sorted(wanted)
    assert bool(rows) == any(map(any, wanted.values()))
    for d in others if rows else ():
        assert words(rows[d.id]["Generation"]) == str(d.generation or "?")
        assert [FIELD.findall(rows[d.id].get(x, "")) for x in ("Likely", "Assumed")] == wanted[d.id]
        assert FIELD.findall(rows[d.id].get("Not supported", "")) == [
            s.field.full_name for s in d.refuses if s.field.role == role
        ]


def test_rates(manual: Manual) -> None:
    rows = matrix(manual, "compare/rates.md", "Base rates")
    sets = [s for s in manual.model.sets if s.kind == "data"]
    assert list(rows) == [heading(s) for s in sets]
    for s, row in zip(sets, rows.values(), strict=True):
        for d in compared(manual):
            rate = next((r.hertz for r in d.base_rates if r.set == s), None)
            has = any(x.set == s.number for x in d.supports)
            unknown = "?" if has else missing(d)
            assert row[d.id] == (unknown if rate is None else f"{rate:g} Hz" if rate else "sent as it arrives")


def test_ports(manual: Manual) -> None:
    ports = matrix(manual, "compare/rates.md", "Ports and their protocols")
    bauds = matrix(manual, "compare/rates.md", "Baud rates")
    assert set(ports) == {p.name for d in compared(manual) for p in d.ports}
    assert list(map(int, bauds)) == sorted({b for d in compared(manual) for p in d.ports for b in p.baud_rates})
    for d in compared(manual):
        absent = missing(d) if d.ports else "?"
        own = {p.name: p for p in d.ports}
        for name, row in ports.items():
            p = own.get(name)
            number_ = f"0x{p.id:02X}: " if p and p.id is not None else ""
            only = [f"{x} (receives only)" for x in (p.receives if p else ()) if p and x not in p.sends]
            assert row[d.id] == (number_ + (", ".join([*p.sends, *only]) or "?") if p else absent)
        for baud, row in bauds.items():
            assert row[d.id] == (", ".join(p.name for p in d.ports if int(baud) in p.baud_rates) or absent)


def test_meanings(manual: Manual) -> None:
    """Each parameter that differs on a device has a row that names the device, and nothing else has one."""
    rows = [row for t in tables(manual.page("compare/meanings.md")) for row in t]
    said = {
        (*(words(row[x]) for x in ("Field", "Parameter", "Difference")), device)
        for row in rows
        for device in DEVICE.findall(row["Devices"])
    }
    wanted = set()
    for d, v in ((of, variant) for of in manual.model.devices for variant in of.variants):
        difference = seen(describe.variant_text(v.variant, v.parameter, v.field, manual.model))
        wanted.add((f"{v.field.title} {number(v.field)}", v.parameter.name, difference, d.id))
    assert said == wanted


def test_pages_lead_to_each_other(manual: Manual) -> None:
    pages = ["overview", "commands", "data", "rates", "meanings"]
    for name in pages:
        first = manual.page(f"compare/{name}.md").split("\n\n")[1]
        assert re.findall(r"\]\((\w+)\.md\)", first) == [other for other in pages if other != name]
    for d in manual.model.devices:
        page = manual.page(f"devices/{d.id}.md")
        assert re.findall(rf"\.\./compare/(\w+)\.md\?devices={d.id}\)", page) == pages[1:]
