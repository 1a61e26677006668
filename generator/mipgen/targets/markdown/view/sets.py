"""Sets: their fields, and the descriptors whose layout is not known."""

from __future__ import annotations

import re

from mipgen import model as m
from mipgen.facts import describe
from mipgen.lower.extent import Extent, totals

from ..places import Page
from ..text import code, hexadecimal, inline, table
from .base import View, manual_link
from .devices import base_rate
from .fields import ENTRY, entry


class Set(View[m.Set]):
    @property
    def family(self) -> m.Family:
        return next(x for x in self.model.families if x.name == self.of.family)

    @property
    def rates(self) -> str:
        """The base rates of the set on all devices."""
        rows = [[self.page.link(d), rate] for d in self.model.devices if (rate := base_rate(d, self.of))]
        return table(rows, ["Device", "Base rate"])

    @property
    def remarks(self) -> list[str]:
        """The commands that may change every field of the set, and uncertainties; those about a field are among its
        facts."""
        things = (self.family, self.of) if len(self.family.sets) > 1 else (self.family,)
        facts = [
            *describe.changed(self.of, self.model),
            *(x for t in things for x in describe.uncertain(t, self.model)),
        ]
        return self.page.sentences(facts)

    # ----------------------------------------------------------------------- fields

    def contents(self, supported: bool) -> str:
        """Lists the commands or data fields that a device supports, or is believed to, or the others."""
        page, s = self.page, self.of
        rows = [
            [
                *entry(page, f, f.functions),
                length_text(f),
                *([page.links(self.model.devices_of(f, number=s.number))] if supported else []),
                first_sentence(page, f),
            ]
            for f in self.model.fields_in(s)
            if f.role != m.RESPONSE and self._is_supported(f) == supported
        ]
        return table(rows, [*ENTRY, "Field length", *(["Supported by"] if supported else []), "Description"])

    def _is_supported(self, f: m.Field) -> bool:
        """Returns true for all fields if the model has no devices."""
        devices_of = self.model.devices_of
        return not self.model.devices or any(devices_of(f, x, self.of.number) for x in m.SUPPORTED)

    @property
    def without_layout(self) -> str:
        """The descriptors that sources name without a layout."""
        roles = self.of.kind == "command"
        rows = [
            [
                code(hexadecimal(x.descriptor)),
                inline(x.title),
                code(f"{self.of.name}.{x.name}"),
                *([x.role] if roles else []),
                "; ".join(f"{manual_link(self.page, c)}: {inline(c.section)}" for c in x.sources),
            ]
            for x in self.family.named
        ]
        return table(rows, ["Descriptor", "Title", "Name", *(["Role"] if roles else []), "Sources"])


def first_sentence(page: Page, f: m.Field) -> str:
    """Describes a field in one line."""
    return page.prose(re.split(r"(?<=\w\w[.!?]) (?=[A-Z`])", " ".join(f.description.split()))[0])


def length_text(f: m.Field) -> str:
    """Writes the length of a field, from the shortest form to the longest."""
    shortest = [totals(c.required, Extent(1 if c.function else 0))[0].fixed for c in f.calls]
    low = min(shortest) if f.role == m.COMMAND else f.min_size
    return f"{low + 2}" if low == f.max_size else f"{low + 2} to {f.max_size + 2}"
