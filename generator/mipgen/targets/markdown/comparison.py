"""Compares devices: commands, data, rates, and the meaning of values.

The tables have a column for each device with known fields. For the other devices, too many for columns, a list shows
the fields that they probably support. Unknown support is distinguished from no support.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from itertools import groupby
from typing import TypeVar

from mipgen import model as m
from mipgen.facts import describe

from .devices import base_rate, limit
from .offsets import layout
from .places import Page, label
from .text import code, hexadecimal, inline, table

YES = "yes"
PROBABLE = "probable"
NO = "no"
UNKNOWN = "?"
NOT_GIVEN = "–"

Key = TypeVar("Key")


@dataclass(frozen=True, slots=True)
class Section:
    """A section of a page, which consists of a table."""

    title: str
    table: str


# --------------------------------------------------------------------------- devices


def compared(model: m.Model) -> list[m.Device]:
    """Returns the devices that have columns: those with certain fields."""
    return [d for d in _by_generation(model) if d.certain]


def others(model: m.Model) -> list[m.Device]:
    return [d for d in _by_generation(model) if not d.certain]


def _by_generation(model: m.Model) -> list[m.Device]:
    return sorted(model.devices, key=lambda d: (d.generation is None, d.generation or 0, d.id))


def generations(page: Page) -> list[Section]:
    """Lists all devices, with the completeness of their profiles."""
    headings = [
        "Device",
        "Also called",
        "Model number",
        "Known",
        "Commands",
        "Data fields",
        "Probable",
        "Acknowledge codes",
    ]
    return [
        Section(
            "Generation not known" if generation is None else f"Generation {generation}",
            table([_device(page, d) for d in devices], headings),
        )
        for generation, devices in groupby(_by_generation(page.model), key=lambda d: d.generation)
    ]


def _device(page: Page, d: m.Device) -> list[str]:
    roles = [s.field.role for s in d.certain]
    return [
        page.link(d),
        ", ".join(map(inline, d.also)),
        "" if d.model_number is None else str(d.model_number),
        known(d),
        str(roles.count(m.COMMAND)),
        str(roles.count(m.DATA)),
        str(len(d.probable)),
        ", ".join(map(str, d.ack_codes)) or UNKNOWN,
    ]


def known(d: m.Device) -> str:
    """States how complete the profile of a device is."""
    if not d.certain:
        return "by name"
    return "in part" if d.incomplete else "whole"


# --------------------------------------------------------------------------- commands and data fields


def fields(page: Page, role: m.Role) -> list[Section]:
    """Lists, in a table for each set, which devices support its commands or data fields, and with which functions."""
    devices = compared(page.model)
    support = {(d.id, s.name): s for d in devices for s in (*d.supports, *d.refuses)}

    def row(f: m.Field, number: int) -> list[str]:
        cells = [supported(d, support.get((d.id, f.name_in(number)))) for d in devices]
        measured = [", ".join(map(inline, units(f)))] if role == m.DATA else []
        return [code(hexadecimal(f.descriptor)), page.link(f, inline(f.title)), *measured, *cells]

    headings = ["Descriptor", "Field", *(["Units"] if role == m.DATA else []), *map(page.link, devices)]
    of = page.model.fields_in
    by_set = [(s, [row(f, s.number) for f in of(s) if f.role == role]) for s in page.model.sets]
    return [Section(label(s), table(rows, headings)) for s, rows in by_set if rows]


def supported(d: m.Device, s: m.Support | None) -> str:
    """States whether a device supports a field, and with which functions."""
    if s is None:
        return missing(d)
    if s.evidence.answer == "no":
        return NO
    functions = code(m.letters(s.functions)) if s.functions else ""
    said = functions or YES if s.certain else f"{PROBABLE} {functions}".strip()
    return f"{said}, deprecated" if s.deprecated else said


def missing(d: m.Device) -> str:
    """Returns the mark of a field that a profile does not list: NO only if the profile is complete."""
    return UNKNOWN if d.absent == "unknown" else NO


def units(f: m.Field) -> list[str]:
    """Returns the symbols of the units of a field's values."""
    symbols = (u.symbol for row in layout(f) if row.parameter for u in row.parameter.units)
    return list(dict.fromkeys(symbols))


def perhaps(page: Page, role: m.Role) -> str:
    """Lists the devices without columns, with their probable fields; empty if none has any."""
    rows = []
    for d in others(page.model):
        fields = [s.field for s in d.supports if s.field.role == role]
        generation = UNKNOWN if d.generation is None else str(d.generation)
        refused = [s.field for s in d.refuses if s.field.role == role]
        rows.append([page.link(d), generation, page.links(fields) or UNKNOWN, page.links(refused)])
    headings = ["Device", "Generation", "Probable", "Not supported"]
    return table(rows, headings) if any(row[2] != UNKNOWN for row in rows) else ""


# --------------------------------------------------------------------------- rates, ports, limits


def rates(page: Page) -> list[Section]:
    """Compares base rates, ports, baud rates and limits."""
    model = page.model
    ports = dict.fromkeys(p.name for d in compared(model) for p in d.ports)
    bauds = sorted({baud for d in compared(model) for p in d.ports for baud in p.baud_rates})
    limits = dict[str, m.Limit]()
    for x in (x for d in compared(model) for x in d.limits):
        limits.setdefault(x.name, x)
    sections = [
        _matrix(page, "Base rates", "Set", [s for s in model.sets if s.kind == "data"], page.link, _rate),
        _matrix(page, "Ports and their protocols", "Port", ports, inline, _port),
        _matrix(page, "Baud rates", "Baud rate", bauds, str, _baud),
        _matrix(
            page, "Limits", "Limit", limits.values(), lambda x: _named(page, x), lambda d, x: _limit(page, d, x.name)
        ),
    ]
    return [s for s in sections if s.table]


def _matrix(
    page: Page,
    title: str,
    of: str,
    keys: Iterable[Key],
    words: Callable[[Key], str],
    cell: Callable[[m.Device, Key], str],
) -> Section:
    """Writes a table with a row for each key and a column for each device."""
    devices = compared(page.model)
    rows = [[words(key), *(cell(d, key) for d in devices)] for key in keys]
    return Section(title, table(rows, [of, *map(page.link, devices)]) if rows else "")


def _rate(d: m.Device, s: m.Set) -> str:
    """Returns the base rate; unknown if a device supports the set but no rate is documented."""
    has = any(x.set == s.number for x in d.supports)
    return base_rate(d, s) or (UNKNOWN if has else missing(d))


def _port(d: m.Device, name: str) -> str:
    for p in d.ports:
        if p.name == name:
            number = f"{code(hexadecimal(p.id))}: " if p.id is not None else ""
            known = [*p.sends, *(f"{name} (receives only)" for name in p.receives if name not in p.sends)]
            return number + (", ".join(map(inline, known)) or UNKNOWN)
    return missing(d) if d.ports else UNKNOWN


def _baud(d: m.Device, baud: int) -> str:
    ports = [inline(p.name) for p in d.ports if baud in p.baud_rates]
    return ", ".join(ports) or (missing(d) if d.ports else UNKNOWN)


def _named(page: Page, limit: m.Limit) -> str:
    """Writes the description of a limit, and its name in programs."""
    return f"{page.prose(limit.description.rstrip('.'))} ({code(limit.name)})"


def _limit(page: Page, d: m.Device, name: str) -> str:
    known = next((x for x in d.limits if x.name == name), None)
    if known is None:
        return UNKNOWN if d.incomplete else NOT_GIVEN
    return limit(page, known)


# --------------------------------------------------------------------------- the meaning of values


def meanings(page: Page) -> str:
    """Lists the parameters with a different meaning on some devices."""
    rows = [
        [page.link(f), code(p.name), page.say(said), page.links(devices)] for f, p, said, devices in _differing(page)
    ]
    return table(rows, ["Field", "Parameter", "Difference", "Devices"]) if rows else ""


def _differing(page: Page) -> Iterator[tuple[m.Field, m.Parameter, describe.Text, list[m.Device]]]:
    model = page.model
    for f in (model.protocol.acknowledge, *model.fields):
        for p in f.parameters:
            for group, fact in describe.variants(p, f, model):
                devices = [d for v in group if v.by_device and (d := model.device(v.key))]
                if devices:
                    yield f, p, fact.value, devices
