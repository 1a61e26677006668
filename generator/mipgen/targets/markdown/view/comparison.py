"""Compares devices: commands, data, rates, and the meaning of values.

The tables have a column for each device with known fields. For the other devices, too many for columns, a list shows
the fields that they are believed to support. Unknown support is distinguished from no support.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cached_property
from itertools import groupby
from typing import TypeVar

from mipgen import model as m
from mipgen.facts import describe

from ..offsets import parameter_offsets
from ..places import Page, label
from ..text import code, hexadecimal, inline, table
from .devices import Section, base_rate, fields_by_set, limit, requirement

YES = "yes"
NO = "no"
UNKNOWN = "?"
NOT_GIVEN = "–"

Key = TypeVar("Key")


@dataclass(frozen=True)
class Comparison:
    page: Page

    @cached_property
    def _devices(self) -> list[m.Device]:
        devices = self.page.model.devices
        return sorted(devices, key=lambda d: (d.generation is None, d.generation or 0, d.id))

    @cached_property
    def columns(self) -> list[m.Device]:
        """The devices that have columns: those with certain fields."""
        return [d for d in self._devices if d.certain]

    @property
    def others(self) -> list[m.Device]:
        return [d for d in self._devices if not d.certain]

    @property
    def generations(self) -> list[Section]:
        """All devices, with the completeness of their profiles."""
        headings = ["Device", "Also called", "Model number", "Known", "Commands", "Data fields", "Likely", "Assumed"]
        return [
            Section(
                "Generation not known" if generation is None else f"Generation {generation}",
                table(map(self._device, devices), [*headings, "Acknowledge codes"]),
            )
            for generation, devices in groupby(self._devices, key=lambda d: d.generation)
        ]

    @property
    def requirements(self) -> list[tuple[str, Section]]:
        """The fields that some device lacks the hardware for: the address of each list, and the list."""
        lacking: dict[str, dict[str, m.Support]] = {}
        for x in (x for d in self._devices for x in d.refuses if x.evidence.needs):
            lacking.setdefault(x.evidence.needs, {})[f"{x.set} {x.field.name}"] = x
        return [
            (
                requirement(needs).partition("#")[2],
                Section(m.worded(needs), "\n".join(fields_by_set(self.page, [*fields.values()]))),
            )
            for needs, fields in sorted(lacking.items())
        ]

    def _device(self, d: m.Device) -> list[str]:
        roles = [s.field.role for s in d.certain]
        return [
            self.page.link(d),
            ", ".join(map(inline, d.also)),
            "" if d.model_number is None else str(d.model_number),
            completeness(d),
            str(roles.count(m.COMMAND)),
            str(roles.count(m.DATA)),
            str(len(d.likely)),
            str(len(d.assumed)),
            ", ".join(map(str, d.ack_codes)) or UNKNOWN,
        ]

    # ----------------------------------------------------------------------- commands and data fields

    def fields(self, role: m.Role) -> list[Section]:
        """Lists, in a table for each set, which devices support its fields, and with which functions."""
        support = {(d.id, s.name): s for d in self.columns for s in (*d.supports, *d.refuses)}

        def row(f: m.Field, number: int) -> list[str]:
            cells = [supported(d, support.get((d.id, f.name_in(number)))) for d in self.columns]
            measured = [", ".join(map(inline, unit_symbols(f)))] if role == m.DATA else []
            return [code(hexadecimal(f.descriptor)), self.page.link(f, inline(f.title)), *measured, *cells]

        headings = ["Descriptor", "Field", *(["Units"] if role == m.DATA else []), *map(self.page.link, self.columns)]
        of = self.page.model.fields_in
        by_set = [(s, [row(f, s.number) for f in of(s) if f.role == role]) for s in self.page.model.sets]
        return [Section(label(s), table(rows, headings)) for s, rows in by_set if rows]

    def believed(self, role: m.Role) -> str:
        """Lists the devices without columns, with the fields that they are believed to have; empty if none has any."""
        rows = []
        for d in self.others:
            fields = [[s.field for s in x if s.field.role == role] for x in (d.likely, d.assumed)]
            generation = UNKNOWN if d.generation is None else str(d.generation)
            refused = [s.field for s in d.refuses if s.field.role == role]
            rows.append([self.page.link(d), generation, *map(self.page.links, (*fields, refused))])
        headings = ["Device", "Generation", "Likely", "Assumed", "Not supported"]
        return table(rows, headings) if any(row[2] or row[3] for row in rows) else ""

    # ----------------------------------------------------------------------- rates, ports, limits

    @property
    def rates(self) -> list[Section]:
        """Base rates, ports, baud rates and limits."""
        sets = [s for s in self.page.model.sets if s.kind == "data"]
        ports = dict.fromkeys(p.name for d in self.columns for p in d.ports)
        bauds = sorted({baud for d in self.columns for p in d.ports for baud in p.baud_rates})
        limits: dict[str, m.Limit] = {}
        for x in (x for d in self.columns for x in d.limits):
            limits.setdefault(x.name, x)
        sections = [
            self._matrix("Base rates", "Set", sets, self.page.link, _rate),
            self._matrix("Ports and their protocols", "Port", ports, inline, _port),
            self._matrix("Baud rates", "Baud rate", bauds, str, _baud),
            self._matrix("Limits", "Limit", limits.values(), self._named, self._limit),
        ]
        return [s for s in sections if s.body]

    def _matrix(
        self,
        title: str,
        of: str,
        keys: Iterable[Key],
        words: Callable[[Key], str],
        cell: Callable[[m.Device, Key], str],
    ) -> Section:
        """Writes a table with a row for each key and a column for each device."""
        rows = [[words(key), *(cell(d, key) for d in self.columns)] for key in keys]
        return Section(title, table(rows, [of, *map(self.page.link, self.columns)]))

    def _named(self, of: m.Limit) -> str:
        """Writes the description of a limit, and its name in programs."""
        return f"{self.page.prose(of.description.rstrip('.'))} ({code(of.name)})"

    def _limit(self, d: m.Device, of: m.Limit) -> str:
        own = next((x for x in d.limits if x.name == of.name), None)
        if own is None:
            return UNKNOWN if d.incomplete else NOT_GIVEN
        return limit(self.page, own)

    # ----------------------------------------------------------------------- the meaning of values

    @property
    def meanings(self) -> str:
        """The parameters with a different meaning on some devices."""
        page, model = self.page, self.page.model
        rows = []
        for f in (model.protocol.acknowledge, *model.fields):
            for p in f.parameters:
                for group, fact in describe.variants(p, f, model):
                    devices = [d for v in group if v.by_device and (d := model.device(v.key))]
                    if devices:
                        rows.append([page.link(f), code(p.name), page.markdown(fact.value), page.links(devices)])
        return table(rows, ["Field", "Parameter", "Difference", "Devices"])


def completeness(d: m.Device) -> str:
    """States how complete the profile of a device is."""
    if not d.certain:
        return "by name"
    return "in part" if d.incomplete else "whole"


def supported(d: m.Device, s: m.Support | None) -> str:
    """States whether a device supports a field, and with which functions."""
    if s is None:
        return missing(d)
    if s.evidence.answer == "no":
        return NO
    functions = code(m.letters(s.functions)) if s.functions else ""
    support = functions or YES if s.certain else f"{s.evidence.answer} {functions}".strip()
    return f"{support}, deprecated" if s.deprecated else support


def missing(d: m.Device) -> str:
    """Returns the mark of a field that a profile does not list: NO only if the profile is complete."""
    return UNKNOWN if d.absent == "unknown" else NO


def unit_symbols(f: m.Field) -> list[str]:
    """Returns the symbols of the units of a field's values."""
    symbols = (u.symbol for row in parameter_offsets(f) if row.parameter for u in row.parameter.units)
    return list(dict.fromkeys(symbols))


def _rate(d: m.Device, s: m.Set) -> str:
    """Returns the base rate; unknown if a device supports the set but no rate is documented."""
    has = any(x.set == s.number for x in d.supports)
    return base_rate(d, s) or (UNKNOWN if has else missing(d))


def _port(d: m.Device, name: str) -> str:
    for p in d.ports:
        if p.name == name:
            number = f"{code(hexadecimal(p.id))}: " if p.id is not None else ""
            protocols = [*p.sends, *(f"{name} (receives only)" for name in p.receives if name not in p.sends)]
            return number + (", ".join(map(inline, protocols)) or UNKNOWN)
    return missing(d) if d.ports else UNKNOWN


def _baud(d: m.Device, baud: int) -> str:
    ports = [inline(p.name) for p in d.ports if baud in p.baud_rates]
    return ", ".join(ports) or (missing(d) if d.ports else UNKNOWN)
