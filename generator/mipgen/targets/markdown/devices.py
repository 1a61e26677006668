"""Devices: the fields that each supports, and how it differs."""

from __future__ import annotations

from mipgen import model as m
from mipgen.facts import describe

from .fields import ENTRY, entry
from .places import Page
from .text import code, hexadecimal, inline, opening, table


def supported(page: Page, d: m.Device, s: m.Set) -> str:
    """Lists the fields of a set that a device supports, with the functions that it accepts; empty if there are none."""
    rows = [entry(page, x.field, x.functions, d) for x in d.certain if x.set == s.number]
    return table(rows, ENTRY) if rows else ""


def evident(page: Page, d: m.Device, answer: m.Answer) -> list[tuple[str, str]]:
    """Lists the fields that a device probably supports, or does not, in one table for each piece of evidence."""
    tables = []
    for e in d.evidence:
        rows = []
        for x in (*d.supports, *d.refuses):
            if x.evidence == e and e.answer == answer:
                of = page.model.set(x.set)
                assert of is not None
                rows.append([page.link(of), *entry(page, x.field, x.functions, d)])
        if rows:
            tables.append((page.say(describe.evidence(e, page.model)), table(rows, ["Set", *ENTRY])))
    return tables


def witnesses(page: Page, d: m.Device) -> str:
    """Lists the sources of the certain fields, unless the device's manual is the only one."""
    said = [(e, sum(x.evidence == e for x in d.supports)) for e in d.evidence if e.answer == "yes"]
    if all(e == m.Evidence("documented") for e, _ in said):
        return ""
    rows = [[page.say(describe.evidence(e, page.model)), str(n), _undefined(e)] for e, n in said]
    return table(rows, ["Evidence", "Fields", "Without a known layout"])


def _undefined(e: m.Evidence) -> str:
    return ", ".join(code(f"(0x{number:02X},0x{descriptor:02X})") for number, descriptor in e.undefined)


def differing(page: Page, d: m.Device) -> str:
    """Lists the commands that accept other functions on a device than in their definition."""
    differing = [s for s in d.supports if s.differs]
    rows = [[page.link(s.field), code(m.letters(s.functions)), code(m.letters(s.field.functions))] for s in differing]
    return table(rows, ["Command", "Functions on this device", "All functions"]) if rows else ""


def deprecated(page: Page, d: m.Device) -> str:
    rows = [[page.link(s.field), page.prose(s.deprecated)] for s in d.supports if s.deprecated]
    return table(rows, ["Deprecated on this device", "Instead"]) if rows else ""


def remarks(page: Page, d: m.Device) -> list[str]:
    """Lists what is unknown or uncertain about a device."""
    return [
        opening(page.say(x.sentence))
        for x in describe.topics(describe.device(d, page.model), "incomplete", "uncertain")
    ]


def listed(page: Page) -> str:
    """Lists all devices, grouped by the completeness of their profiles."""
    whole = [d for d in page.model.devices if not d.incomplete]
    part = [d for d in page.model.devices if d.incomplete and d.certain]
    named = [d for d in page.model.devices if d.incomplete and not d.certain]
    parts = []
    if whole:
        rows = [[*_identity(page, d), str(len(d.certain)), page.prose(d.description)] for d in whole]
        parts.append("### The whole manual is known\n\n" + table(rows, [*IDENTITY, "Fields", "Description"]))
    if part:
        rows = [
            [*_identity(page, d), str(len(d.certain)), str(len(d.probable)), page.prose(d.description)] for d in part
        ]
        headings = [*IDENTITY, "Certain fields", "Probable fields", "Description"]
        parts.append("### Some fields are known\n\n" + table(rows, headings))
    if named:
        about = "None of their fields is certain. Their pages list the probable fields, with the evidence."
        parts.append(f"### Probable fields only\n\n{about}\n")
        for generation in sorted({d.generation for d in named}, key=lambda x: -(x or 0)):
            title = "Generation not known" if generation is None else f"Generation {generation}"
            links = ", ".join(_named(page, d) for d in named if d.generation == generation)
            parts[-1] += f"\n- {title}: {links}"
    if page.model.named:
        known = {d.id: d for d in page.model.devices}
        rows = [[*_names(d), page.link(known[d.like])] for d in page.model.named]
        about = (
            "No source states any of their fields. The tools have no profile of them; choose the most similar device."
        )
        parts.append(f"### Names only\n\n{about}\n\n" + table(rows, [*IDENTITY, "Most similar"]))
    return "\n\n".join(parts)


IDENTITY = ("Device", "Also called", "Model number")


def _identity(page: Page, d: m.Device) -> list[str]:
    return [page.link(d), *_names(d)[1:]]


def _names(d: m.Device | m.NamedDevice) -> list[str]:
    return [inline(d.title), ", ".join(map(inline, d.also)), "" if d.model_number is None else str(d.model_number)]


def _named(page: Page, d: m.Device) -> str:
    """Writes a device without certain fields: its link, its other names and its number."""
    more = [*map(inline, d.also), *([] if d.model_number is None else [str(d.model_number)])]
    return page.link(d) + (f" ({', '.join(more)})" if more else "")


def hertz(rate: m.Rate) -> str:
    return f"{describe.number(rate.hertz)} Hz" if rate.hertz else "sent as it arrives"


def base_rate(d: m.Device, s: m.Set) -> str:
    """Returns the base rate of a set on a device; empty if none is documented."""
    return next((hertz(r) for r in d.base_rates if r.set.number == s.number), "")


def base_rates(page: Page, d: m.Device) -> str:
    return table([[page.link(r.set), hertz(r)] for r in d.base_rates], ["Set", "Base rate"]) if d.base_rates else ""


def rates_of_set(page: Page, s: m.Set) -> str:
    """Lists the base rates of a set on all devices."""
    rows = [[page.link(d), rate] for d in page.model.devices if (rate := base_rate(d, s))]
    return table(rows, ["Device", "Base rate"]) if rows else ""


def protocols(of: m.Port, names: tuple[str, ...]) -> str:
    """Lists the protocols of a port, with the firmware that supports them."""
    versions = {f.protocol: f.versions for f in of.firmware}
    return ", ".join(inline(f"{x} (firmware {versions[x]})" if x in versions else x) for x in names)


def ports(d: m.Device) -> str:
    rows = [
        [
            inline(p.name),
            "" if p.id is None else code(hexadecimal(p.id)),
            ", ".join(map(str, p.baud_rates)),
            protocols(p, p.receives),
            protocols(p, p.sends),
        ]
        for p in d.ports
    ]
    return table(rows, ["Port", "Id", "Baud rates", "Receives", "Sends"])


def limit(page: Page, of: m.Limit) -> str:
    """Writes the value of a limit with its unit."""
    said = inline(describe.measured(describe.number(of.value), of.unit, page.model))
    return f"{said} (firmware {inline(of.firmware)})" if of.firmware else said


def limits(page: Page, d: m.Device) -> str:
    rows = [[page.prose(x.description.rstrip(".")), code(x.name), limit(page, x)] for x in d.limits]
    return table(rows, ["Limit", "Name", "Value"]) if rows else ""


def variants(page: Page, d: m.Device) -> str:
    """Lists the parameters with a different meaning on a device."""
    rows = []
    for v in d.variants:
        said = describe.difference(v.variant, v.parameter, v.field, page.model)
        rows.append([page.link(v.field), code(v.parameter.name), page.say(said)])
    return table(rows, ["Field", "Parameter", "On this device"]) if rows else ""


def note_table(note: m.Note) -> str:
    """Writes a note's rows as a table; the first row is the heading, and short rows are padded."""
    width = max(map(len, note.rows))
    head, *rows = [[*map(inline, row), *[""] * (width - len(row))] for row in note.rows]
    return "\n".join("| " + " | ".join(row) + " |" for row in [head, ["---"] * width, *rows])
