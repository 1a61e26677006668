"""Reverse references: the errata, examples, guides and users of a thing, each computed once."""

from __future__ import annotations

from collections.abc import Hashable, Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import TypeVar

from mipgen import model as m
from mipgen.facts.sample_values import SampleValues
from mipgen.model.guides import Guide

Key = TypeVar("Key", bound=Hashable)
Item = TypeVar("Item")

User = m.Field | m.Struct | m.Bitfield


@dataclass(frozen=True)
class Index:
    model: m.Model

    @property
    def samples(self) -> SampleValues:
        return self.model.derived(SampleValues)

    def typical(self, f: m.Field) -> m.Call:
        """Returns the form whose typical values pages show: for a command, the first that a device accepts."""
        return self.samples.sent(f)[0] if f.role == m.COMMAND else f.calls[0]

    # ----------------------------------------------------------------------- errata

    def errata(self, f: m.Field) -> list[m.Erratum]:
        """Returns the errata about the sections that a field cites, about its printed lengths, and about its
        examples."""
        errata = [e for s in f.sources for e in self.errata_of_length(f, s.manual)]
        errata += [e for x in self.examples(f) for e in self.errata_of_example(x)]
        if f.role != m.RESPONSE:  # a response cites the sections of its command
            errata += [e for s in f.sources for e in self._of_section.get((s.manual, s.section), ())]
        return sorted({e.id: e for e in errata}.values(), key=lambda e: e.id)

    def errata_naming(self, f: m.Field) -> list[m.Erratum]:
        """Returns the other errata whose texts mention a field."""
        own = {e.id for e in self.errata(f)}
        return list({e.id: e for e in self._naming.get(f.full_name, ()) if e.id not in own}.values())

    def errata_of_example(self, x: m.Example) -> list[m.Erratum]:
        return self._of_example.get(x.id, [])

    def errata_of_length(self, f: m.Field, manual: str) -> list[m.Erratum]:
        names = (f.name_in(o.set) for o in f.occurrences)
        return [e for name in names for e in self._of_length.get((manual, name), ())]

    def fields_of_section(self, e: m.Erratum) -> list[m.Field]:
        """Returns the fields that cite the section of an erratum."""
        return self._fields_of_section.get(_section(e), [])

    @cached_property
    def _claims(self) -> list[tuple[m.Erratum, m.Claim]]:
        return [(e, c) for e in self.model.errata for c in e.claims]

    @cached_property
    def _of_section(self) -> dict[tuple[str, str], list[m.Erratum]]:
        return _grouped((_section(e), e) for e in self.model.errata)

    @cached_property
    def _of_example(self) -> dict[str, list[m.Erratum]]:
        return _grouped((c.subject, e) for e, c in self._claims if c.kind == "example")

    @cached_property
    def _of_length(self) -> dict[tuple[str, str], list[m.Erratum]]:
        return _grouped(((e.manual, c.subject), e) for e, c in self._claims if c.kind == "length")

    @cached_property
    def _naming(self) -> dict[str, list[m.Erratum]]:
        """Field -> the errata whose texts name it, in its section or elsewhere."""
        pairs = [(name, e) for e in self.model.errata for name in e.named]
        return _grouped((f.full_name, e) for name, e in pairs if (f := self.model.field(name)) is not None)

    @cached_property
    def _fields_of_section(self) -> dict[tuple[str, str], list[m.Field]]:
        fields = [f for f in self.model.fields if f.role != m.RESPONSE]
        return _grouped(((s.manual, s.section), f) for f in fields for s in f.sources)

    # ----------------------------------------------------------------------- examples

    def examples(self, f: m.Field) -> list[m.Example]:
        return list({x.id: x for x in self._examples.get(f.full_name, ())}.values())

    def shown(self, x: m.Example, part: m.ExampleField) -> list[str]:
        """Returns the names of the fields that a part of an example shows: its own, or the commands that it
        acknowledges."""
        if part.field != self.model.protocol.acknowledge.full_name or not part.data:
            f = self.model.field(part.field) if part.field else None
            return [f.full_name] if f else []
        return [f.full_name for f in self.model.candidates(x.set, part.data[0]) if f.role == m.COMMAND]

    @cached_property
    def _examples(self) -> dict[str, list[m.Example]]:
        parts = [(x, part) for x in self.model.examples for part in x.fields]
        return _grouped((name, x) for x, part in parts for name in self.shown(x, part))

    @cached_property
    def guides(self) -> dict[str, list[Guide]]:
        """Field -> the guides that use it in a step or in data."""
        used = [(g, set[str]().union(*(s.used for s in g.sequences))) for g in self.model.guides]
        return _grouped((name, g) for g, names in used for name in names)

    # ----------------------------------------------------------------------- users of types

    def users(self, t: m.Type) -> list[User]:
        """Returns the fields and types whose parameters, bits or variants use a type."""
        return self._users.get(_name(t), [])

    @cached_property
    def _users(self) -> dict[tuple[str | None, str], list[User]]:
        records: list[m.Struct | m.Field] = [*m.structs(self.model.all_types)]
        records += [self.model.protocol.acknowledge, *self.model.fields]
        users: list[tuple[User, m.Type]] = [(r, t) for r in records for p in r.parameters for t in p.types]
        bitfields = [t for t in self.model.all_types if isinstance(t, m.Bitfield)]
        users += [(t, b.enum) for t in bitfields for b in t.bits if b.enum is not None]
        once = {(_name(t), _name(user)): user for user, t in users}
        return _grouped((used, user) for (used, _), user in once.items())


def _name(thing: m.Type | m.Field) -> tuple[str | None, str]:
    """Returns a key, which is unique because a field and a type of its set never have the same name."""
    return thing.owner, thing.name


def _section(e: m.Erratum) -> tuple[str, str]:
    """Returns the section as fields cite it, without the part of it that an erratum may add after " > "."""
    return e.manual, e.section.partition(" > ")[0]


def _grouped(pairs: Iterable[tuple[Key, Item]]) -> dict[Key, list[Item]]:
    groups: dict[Key, list[Item]] = {}
    for key, item in pairs:
        groups.setdefault(key, []).append(item)
    return groups
