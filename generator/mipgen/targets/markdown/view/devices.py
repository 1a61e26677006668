"""Devices: the fields that each supports, and how it differs."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from mipgen import model as m
from mipgen.facts import describe

from ..places import COMPARISON, Page
from ..text import code, count, hexadecimal, inline, table
from .base import View
from .fields import ENTRY, entry


@dataclass(frozen=True, slots=True)
class Section:
    title: str
    body: str  # a table or a list
    about: str = ""  # before it


class Device(View[m.Device]):
    @property
    def remarks(self) -> list[str]:
        """What is unknown or uncertain about the device."""
        facts = describe.device(self.of, self.model)
        return self.page.sentences(describe.topics(facts, "incomplete", "uncertain"))

    @property
    def properties(self) -> str:
        d, link = self.of, self.page.link
        like = self.model.device(d.like) if d.like else None
        compared = [link(f"{path}?devices={d.id}", title.lower()) for path, title in [*COMPARISON.items()][1:]]
        differing = {(v.field.full_name, v.parameter.name) for v in d.variants}
        compared[-1] += f" ({count([*differing], 'parameter')})" if differing else ""
        codes = ", ".join(map(str, d.ack_codes))
        hardware = describe.topics(describe.device(d, self.model), "sensors", *m.COUNTED, "complete")
        rows = [
            ["Id", f"`{d.id}`"],
            ["Also called", ", ".join(map(inline, d.also))],
            ["Generation", "" if d.generation is None else str(d.generation)],
            [
                "Model number",
                "" if d.model_number is None else f"{d.model_number} (`{hexadecimal(d.model_number, 2)}`)",
            ],
            *([self.page.markdown(x.sentence).partition(":")[0], self.page.markdown(x.value)] for x in hardware),
            ["Similar to", link(like) if like else ""],
            *self._manual(),
            ["Sources", "; ".join(self.citations)],
            ["Comparison", ", ".join(compared)],
            [
                "Acknowledge codes",
                f"{codes} ({link(self.model.protocol.acknowledge, 'acknowledge')})" if codes else "",
            ],
        ]
        return table([row for row in rows if row[1]], ["Property", "Value"])

    def _manual(self) -> list[list[str]]:
        manual = next((x for x in self.model.protocol.manuals if x.id == self.of.manual), None)
        if manual is None:
            return [["Manual", "none known"]]
        errata = [e for e in self.model.errata if e.manual == manual.id]
        list_of_errata = self.page.link(f"docs/errata.md#manual.{manual.id}", count(errata, "erratum", "errata"))
        title = f"{self.page.link(manual, inline(manual.title))}, {inline(manual.document)}"
        return [["Manual", title], ["Errata of the manual", list_of_errata if errata else ""]]

    # ----------------------------------------------------------------------- fields

    @property
    def certain(self) -> list[Section]:
        """The fields of a device that is wholly known, with the functions that it accepts, set by set."""
        sections = []
        for s in self.model.sets:
            rows = [entry(self.page, x.field, x.functions, self.of) for x in self.of.certain if x.set == s.number]
            if rows:
                rate = base_rate(self.of, s)
                sections.append(Section(self.page.link(s), table(rows, ENTRY), rate and f"Base rate: {rate}."))
        return sections

    def evident(self, answer: m.Answer) -> Iterator[Section]:
        """Yields the fields for which there is evidence with an answer, a section for each piece of evidence, with a
        line for each set; the list of those that require hardware is the same for all devices, and on one page."""
        for e in self.of.evidence:
            supports = [x for x in (*self.of.supports, *self.of.refuses) if x.evidence == e and e.answer == answer]
            lines = fields_by_set(self.page, supports)
            if e.undefined:
                lines.append(
                    f"- Without a known layout: {', '.join(code(f'(0x{s:02X},0x{d:02X})') for s, d in e.undefined)}"
                )
            about = self.page.markdown(describe.evidence(e, self.model))
            if e.needs:
                hardware = m.worded(e.needs)
                about = about.replace(hardware, self.page.link(requirement(e.needs), hardware))
            if lines:
                yield Section("", "" if e.needs else "\n".join(lines), about)

    @property
    def deprecated(self) -> str:
        rows = [[self.page.link(s.field), self.page.prose(s.deprecated)] for s in self.of.supports if s.deprecated]
        return table(rows, ["Deprecated on this device", "Instead"])

    @property
    def differing(self) -> str:
        """The commands that accept other functions on the device than in their definition."""
        differing = [(s.field, s.functions, s.field.functions) for s in self.of.supports if s.differs]
        rows = [[self.page.link(f), code(m.letters(own)), code(m.letters(usual))] for f, own, usual in differing]
        return table(rows, ["Command", "Functions on this device", "All functions"])

    # ----------------------------------------------------------------------- rates, ports, limits

    @property
    def base_rates(self) -> str:
        return table([[self.page.link(r.set), hertz(r)] for r in self.of.base_rates], ["Set", "Base rate"])

    @property
    def ports(self) -> str:
        rows = [
            [
                inline(p.name),
                "" if p.id is None else code(hexadecimal(p.id)),
                ", ".join(map(str, p.baud_rates)),
                protocols(p, p.receives),
                protocols(p, p.sends),
            ]
            for p in self.of.ports
        ]
        return table(rows, ["Port", "Id", "Baud rates", "Receives", "Sends"])

    @property
    def limits(self) -> str:
        page = self.page
        rows = [[page.prose(x.description.rstrip(".")), code(x.name), limit(page, x)] for x in self.of.limits]
        return table(rows, ["Limit", "Name", "Value"])

    @property
    def firmware(self) -> str:
        """The fields that only some versions of its firmware have."""
        some = [s for s in self.of.supports if s.firmware and s.field.role != m.RESPONSE]
        rows = [[self.page.link(s.field), inline(describe.firmware(s.firmware or ""))] for s in some]
        return table(rows, ["Field", "Requires"])

    @property
    def notes(self) -> list[Section]:
        """Notes; a table that several devices have is on the page of the first one."""
        sections = []
        for x in self.of.notes:
            first = next(d for d in self.model.devices if any((n.title, n.rows) == (x.title, x.rows) for n in d.notes))
            elsewhere = bool(x.rows) and first.id != self.of.id
            body = f"The table is on the page of the {self.page.link(first)}." if elsewhere else _note_table(x)
            sections.append(Section(inline(x.title), body, self.page.prose(x.description)))
        return sections


def _note_table(note: m.Note) -> str:
    """Writes a note's rows as a table; the first row is the heading, and short rows are padded."""
    if not note.rows:
        return ""
    width = max(map(len, note.rows))
    head, *rows = [[*map(inline, row), *[""] * (width - len(row))] for row in note.rows]
    return "\n".join("| " + " | ".join(row) + " |" for row in [head, ["---"] * width, *rows])


def fields_by_set(page: Page, of: Iterable[m.Support]) -> list[str]:
    """Lists fields, with the functions that a device accepts, in a line for each set."""

    def brief(x: m.Support) -> str:
        functions = f" {code(m.letters(x.functions))}" if x.functions else ""
        return f"{page.link(x.field, inline(x.field.title))}{functions}"

    fields = [*of]
    sets = [(s, [brief(x) for x in fields if x.set == s.number]) for s in page.model.sets]
    return [f"- {page.link(s)}: {', '.join(own)}" for s, own in sets if own]


def requirement(needs: str) -> str:
    """Returns the place of the list of fields that require hardware."""
    return f"docs/compare/overview.md#requires.{needs.replace(' ', '_')}"


def hertz(rate: m.Rate) -> str:
    return f"{describe.number(rate.hertz)} Hz" if rate.hertz else "sent as it arrives"


def base_rate(d: m.Device, s: m.Set) -> str:
    """Returns the base rate of a set on a device; empty if none is documented."""
    return next((hertz(r) for r in d.base_rates if r.set.number == s.number), "")


def protocols(of: m.Port, names: Iterable[str]) -> str:
    """Lists the protocols of a port, with the firmware that supports them."""
    versions = {f.protocol: f.versions for f in of.firmware}
    return ", ".join(inline(f"{x} ({describe.firmware(versions[x])})" if x in versions else x) for x in names)


def limit(page: Page, of: m.Limit) -> str:
    """Writes the value of a limit with its unit."""
    value = inline(describe.measured(describe.number(of.value), of.unit, page.model))
    return f"{value} ({inline(describe.firmware(of.firmware))})" if of.firmware else value
