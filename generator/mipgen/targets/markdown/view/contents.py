"""The first page, and the navigation of the site: lists of sets, devices and manuals."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from mipgen import model as m
from mipgen.facts import describe

from ..places import Page, descriptors, field_page
from ..text import hexadecimal, inline, table
from .devices import Section

#: A title, and the titles and addresses of pages.
Pages = tuple[str, list[tuple[str, str]]]

IDENTITY = ("Device", "Also called", "Model number")


@dataclass(frozen=True)
class Contents:
    page: Page

    def sets(self, *kinds: str) -> str:
        model = self.page.model
        rows = [
            [
                f"`{hexadecimal(s.number)}`",
                self.page.link(s, inline(s.title)),
                str(sum(f.role != m.RESPONSE for f in model.fields_in(s))),
                self.page.prose(s.description),
            ]
            for s in model.sets
            if s.kind in kinds
        ]
        return table(rows, ["Set", "Title", "Fields", "Description"])

    # ----------------------------------------------------------------------- the navigation

    def pages(self, *kinds: str) -> list[Pages]:
        """Returns the pages of each family: its sets, and its fields but responses."""
        lists = []
        for x in self.page.model.families:
            sets = [(f"{s.title} ({hexadecimal(s.number)})", self.page.url(s)) for s in x.sets]
            fields = [(f"{f.title} ({descriptors(f)})", field_page(f)) for f in x.fields if f.role != m.RESPONSE]
            if x.kind in kinds:
                pages = sets + [(title, self.page.url(path)) for title, path in fields]
                lists.append((f"{hexadecimal(x.number)} {x.title}", pages))
        return lists

    # ----------------------------------------------------------------------- devices and manuals

    @property
    def devices(self) -> list[Section]:
        """All devices, grouped by the completeness of their profiles."""
        model = self.page.model
        whole = [d for d in model.devices if not d.incomplete]
        part = [d for d in model.devices if d.incomplete and d.certain]
        others = [d for d in model.devices if d.incomplete and not d.certain]
        like = {d.id: self.page.link(d) for d in model.devices}
        sections = [
            Section("Complete", self._table(whole, ["Fields"])),
            Section("Partly documented", self._table(part, ["Certain fields", "Likely", "Assumed"])),
            Section(
                "Likely and assumed fields only",
                "\n".join(self._by_generation(others)),
                "None of their fields is certain. Their pages list the likely and the assumed ones, with the evidence.",
            ),
            Section(
                "Names only",
                table(([*_identity(d), like[d.like]] for d in model.named), [*IDENTITY, "Most similar"]),
                "No source states any of their fields. "
                "The tools have no profile of them; choose the most similar device.",
            ),
        ]
        return [x for x in sections if x.body]

    def _table(self, devices: Sequence[m.Device], counts: Sequence[str]) -> str:
        rows = []
        for d in devices:
            numbers = [str(len(d.answered(x))) for x in m.SUPPORTED][: len(counts)]
            rows.append([self.page.link(d), *_identity(d)[1:], *numbers, self.page.prose(d.description)])
        return table(rows, [*IDENTITY, *counts, "Description"])

    def _by_generation(self, devices: Sequence[m.Device]) -> Iterator[str]:
        """Yields a line for each generation, with links, other names and numbers of its devices."""
        for generation in sorted({d.generation for d in devices}, key=lambda x: -(x or 0)):
            title = "Generation not known" if generation is None else f"Generation {generation}"
            own = [(self.page.link(d), _identity(d)[1:]) for d in devices if d.generation == generation]
            links = [f"{link} ({', '.join(filter(None, more))})" if any(more) else link for link, more in own]
            yield f"- {title}: {', '.join(links)}"

    @property
    def manuals(self) -> str:
        rows = [
            [
                self.page.anchor(x) + inline(x.id),
                inline(x.title),
                inline(x.document),
                self.page.markdown(describe.length_facts(x, self.page.model)),
                self._number(x, "errata", self.page.model.errata),
                self._number(x, "examples", self.page.model.examples),
            ]
            for x in self.page.model.protocol.manuals
        ]
        return table(rows, ["Id", "Title", "Document", "Field lengths", "Errata", "Examples"])

    def _number(self, manual: m.Manual, kind: str, entries: Sequence[m.Example | m.Erratum]) -> str:
        """Returns the number of examples or errata of a manual, as a link to their list."""
        number = sum(x.manual == manual.id for x in entries)
        return self.page.link(f"docs/{kind}.md#manual.{manual.id}", str(number)) if number else "0"


def _identity(d: m.Device | m.NamedDevice) -> list[str]:
    return [inline(d.title), ", ".join(map(inline, d.also)), "" if d.model_number is None else str(d.model_number)]
