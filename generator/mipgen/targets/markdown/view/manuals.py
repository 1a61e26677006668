"""The examples and the errata of the manuals, a page for each part of a manual."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Generic, TypeVar

from mipgen import model as m

from ..places import errata_page, examples_page, label
from ..text import hexadecimal, inline
from .base import View

Entry = TypeVar("Entry", m.Example, m.Erratum)


@dataclass(frozen=True, slots=True)
class Part(Generic[Entry]):
    """The examples or errata of a manual that are on one page, in the order of the manual's sections."""

    path: str
    manual: m.Manual
    first: bool  # of its manual
    title: str  # Markdown
    entries: Sequence[Entry]


def parts_of_examples(model: m.Model) -> list[Part[m.Example]]:
    """Returns a page for each manual and family."""

    def place(x: m.Example) -> tuple[str, str, str]:
        s = model.set(x.set)
        family = model.family(s.family) if s else None
        return examples_page(x, model), label(family) if family else hexadecimal(x.set), x.section

    return list(_parts(model, sorted(model.examples, key=lambda x: place(x)[0]), place))


def parts_of_errata(model: m.Model) -> list[Part[m.Erratum]]:
    """Returns a page for each manual and severity, worst first."""
    worst_first = sorted(model.errata, key=lambda e: e.severity, reverse=True)
    return list(_parts(model, worst_first, lambda e: (errata_page(e), e.severity, e.section.partition(" > ")[0])))


def _parts(
    model: m.Model, entries: Iterable[Entry], place: Callable[[Entry], tuple[str, str, str]]
) -> Iterator[Part[Entry]]:
    """Yields the pages of each manual; `place` returns the page, its title, and the section of an entry."""
    for manual in model.protocol.manuals:
        order = {section: i for i, section in enumerate(manual.sections)}
        pages: dict[tuple[str, str], list[tuple[int, Entry]]] = {}
        for x in entries:
            if x.manual == manual.id:
                path, title, section = place(x)
                pages.setdefault((path, title), []).append((order.get(section, -1), x))
        for i, ((path, title), placed) in enumerate(pages.items()):
            yield Part(path, manual, i == 0, title, [x for _, x in sorted(placed, key=lambda entry: entry[0])])


class Erratum(View[m.Erratum]):
    @property
    def subjects(self) -> list[str]:
        """Links to the fields and examples that it is about."""
        model, subjects = self.page.model, []
        examples = {x.id: x for x in model.examples}
        for c in self.of.claims:
            f = model.field(c.subject)
            if c.kind == "length" and f is not None:
                subjects.append("length of " + self.page.link(f))
            elif c.kind == "example":
                subjects.append("example " + self.page.link(examples[c.subject]))
            elif c.kind == "reference":
                subjects.append(f"reference to {inline(f'({c.subject})')}, which no manual defines")
        claimed = {c.subject for c in self.of.claims if c.kind == "length"}
        fields = {f.full_name: f for f in self.page.index.fields_of_section(self.of)}
        return subjects + [self.page.link(f) for name, f in fields.items() if name not in claimed]
