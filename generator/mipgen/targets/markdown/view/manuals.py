"""The examples and the errata of the manuals."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Generic, TypeVar

from mipgen import model as m

from ..places import label
from ..text import hexadecimal, inline
from .base import View

Entry = TypeVar("Entry", m.Example, m.Erratum)


@dataclass(frozen=True, slots=True)
class Part(Generic[Entry]):
    """The examples of a manual and family, or the errata of a manual and severity, in the order of its sections."""

    manual: m.Manual
    anchor: str
    title: str  # Markdown
    entries: Sequence[Entry]


def parts_of_examples(model: m.Model) -> list[Part[m.Example]]:
    """Returns a part for each manual and family."""

    def place(x: m.Example) -> tuple[str, str]:
        s = model.set(x.set)
        family = model.family(s.family) if s else None
        return label(family) if family else hexadecimal(x.set), x.section

    return list(_parts(model, sorted(model.examples, key=lambda x: x.set), place))


def parts_of_errata(model: m.Model) -> list[Part[m.Erratum]]:
    """Returns a part for each manual and severity, worst first."""
    worst_first = sorted(model.errata, key=lambda e: e.severity, reverse=True)
    return list(_parts(model, worst_first, lambda e: (e.severity, e.section.partition(" > ")[0])))


def _parts(
    model: m.Model, entries: Iterable[Entry], place: Callable[[Entry], tuple[str, str]]
) -> Iterator[Part[Entry]]:
    """Yields the parts of each manual; `place` returns the title of the part, and the section of an entry."""
    for manual in model.protocol.manuals:
        order = {section: i for i, section in enumerate(manual.sections)}
        parts: dict[str, list[tuple[int, Entry]]] = {}
        for x in entries:
            if x.manual == manual.id:
                title, section = place(x)
                parts.setdefault(title, []).append((order.get(section, -1), x))
        for i, (title, placed) in enumerate(parts.items()):
            anchor = f"manual.{manual.id}" + (f".{i + 1}" if i else "")
            yield Part(manual, anchor, title, [x for _, x in sorted(placed, key=lambda entry: entry[0])])


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
