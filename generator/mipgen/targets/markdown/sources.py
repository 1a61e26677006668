"""What the manuals state, and their mistakes: citations and errata."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from mipgen import model as m
from mipgen.facts import describe
from mipgen.lower.lengths import computed_length, same
from mipgen.model.guides import Guide

from .fields import length
from .places import Page, errata_page, label
from .text import code, inline, table

SEVERITIES = ("wire", "meaning")


def of_manual(things: Sequence[Any], manual: m.Manual) -> list[Any]:
    """Returns the examples or errata of a manual."""
    return [t for t in things if t.manual == manual.id]


# --------------------------------------------------------------------------- citations


def citations(page: Page, thing: m.Field | m.Type | m.Set | m.Family | m.Chapter | m.Device | Guide) -> list[str]:
    """Lists the sections of the manuals that describe a thing, one line for each."""
    return [_citation(page, thing, s) for s in getattr(thing, "sources", ())]


def _citation(page: Page, thing: object, s: m.Source) -> str:
    remark = _length_remark(page, thing, s) if isinstance(thing, m.Field) else ""
    return f"{_manual(page, s)}: {inline(s.section)}{f' ({remark})' if remark else ''}"


def occurrences(page: Page, f: m.Field) -> str:
    """Lists the sets in which a field occurs, if there are several: its name there, the devices and the sources."""
    if len(f.occurrences) == 1:
        return ""
    rows = []
    for o in f.occurrences:
        of = page.model.set(o.set)
        assert of is not None
        devices = page.links(page.model.devices_of(f, number=o.set))
        probable = page.links(page.model.devices_of(f, certain=False, number=o.set))
        devices = "; ".join([*([devices] if devices else []), *([f"probably {probable}"] if probable else [])])
        cited = "; ".join(_citation(page, f, s) for s in o.sources)
        unsure = " ".join(page.say(x.sentence) for x in describe.uncertain(o, page.model))
        rows.append([page.link(of), code(f.name_in(o.set)), devices, f"{cited} {unsure}".strip()])
    return table(rows, ["Set", "Name", "Devices", "In the manuals"])


def field_lengths(page: Page, manual: m.Manual) -> str:
    """States how a manual counts field lengths."""
    return page.say(describe.lengths(manual, page.model))


def length_remarks(page: Page, f: m.Field) -> list[str]:
    """Lists the manuals that state a different length for a response, in the sections about its command."""
    remarks = [(_manual(page, s), _length_remark(page, f, s)) for s in f.sources]
    return list(dict.fromkeys(f"{manual}: {remark}" for manual, remark in remarks if remark))


def _manual(page: Page, s: m.Source) -> str:
    return page.link(next(x for x in page.model.protocol.manuals if x.id == s.manual))


def _length_remark(page: Page, f: m.Field, s: m.Source) -> str:
    if s.length is None or s.length == "unavailable":
        return ""
    right = length(f.parameters)
    wrong = page.index.errata_of_length(f, s.manual)
    if wrong:
        by = ", ".join(page.link(e, f"erratum {label(e)}") for e in wrong)
        return f"length given as {code(s.length)} instead of {right}: {by}"
    if same(s.length, right.strip("`")) or same(s.length, computed_length(f, "wire")):
        return ""
    return f"length given as {code(s.length)} without vectors, structures and unions, instead of {right}"


def defined(thing: m.Field) -> str:
    """States where the specification defines a field: the file, and the name in it. A line number would change with
    every edit above it."""
    if thing.position is None:
        return ""
    return f"{code('/'.join(thing.position.file.split('/')[-2:]))}, {code(f'name: {thing.name}')}"


# --------------------------------------------------------------------------- errata


@dataclass(frozen=True, slots=True)
class Part:
    """The errata of a page."""

    path: str
    manual: m.Manual
    severity: str
    errata: tuple[m.Erratum, ...]


def parts(model: m.Model) -> list[Part]:
    """Returns a page for each manual and severity, worst first. The errata are in the order of the manual's
    sections."""
    found = []
    for manual in model.protocol.manuals:
        order = {section: i for i, section in enumerate(manual.sections)}
        own = sorted(of_manual(model.errata, manual), key=lambda e: order.get(e.section.partition(" > ")[0], -1))
        for severity in SEVERITIES:
            shown = tuple(e for e in own if e.severity == severity)
            if shown:
                found.append(Part(errata_page(shown[0]), manual, severity, shown))
    return found


def subjects(page: Page, e: m.Erratum) -> list[str]:
    """Lists the subjects of an erratum: links to fields and examples."""
    model, subjects = page.model, []
    examples = {x.id: x for x in model.examples}
    for c in e.claims:
        f = model.field(c.subject)
        if c.kind == "length" and f is not None:
            subjects.append("length of " + page.link(f))
        elif c.kind == "example":
            subjects.append("example " + page.link(examples[c.subject]))
        elif c.kind == "reference":
            subjects.append(f"reference to {inline(f'({c.subject})')}, which no manual defines")
    claimed = {c.subject for c in e.claims if c.kind == "length"}
    fields = {f.full_name: f for f in page.index.fields_of_section(e)}
    return subjects + [page.link(f) for name, f in fields.items() if name not in claimed]
