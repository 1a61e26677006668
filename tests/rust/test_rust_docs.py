"""Every fact about each field, parameter, value and bit is in the documentation of the crate, at that very item.

The comments are read from the generated source, by item.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest
from crates import rendered, specification
from mipgen import model as m
from mipgen.facts import describe
from mipgen.targets.rust import names
from mipgen.targets.rust.view import Crate

#: Module, type and member ("" for the type itself).
Item = tuple[str, str, str]

TYPE = re.compile(r"(?:    pub (?:struct|enum) (\w+)|    (\w+): [^!]+ \{$|pub (?:type|static|const) (\w+))")
MEMBER = re.compile(r"        (?:pub )?(\w+)(?:: | = | =>|,)")


def comments(files: dict[str, bytes]) -> dict[Item, str]:
    """The documentation of all items, as plain words."""
    found: dict[Item, str] = {}
    for path, data in files.items():
        if not re.fullmatch(r"src/(sets/\w+|types|protocol|devices/known)\.rs", path):
            continue
        module, owner, lines = path.removesuffix(".rs").rpartition("/")[2], "", []
        for line in data.decode("utf-8").splitlines():
            text = line.strip()
            if text.startswith("//!"):
                found[module, "", ""] = f"{found.get((module, '', ''), '')} {text[3:]}"
            elif text.startswith("///"):
                lines.append(text[3:])
            elif not text.startswith("#["):
                if match := TYPE.match(line):
                    owner = next(filter(None, match.groups()))
                    found[module, owner, ""] = " ".join(lines)
                elif lines and (match := MEMBER.match(line)):
                    found[module, owner, match[1]] = " ".join(lines)
                lines = []
    return {item: plain(unmarked(text)) for item, text in found.items()}


def unmarked(markdown: str) -> str:
    """The text without the marks of links and escapes."""
    return re.sub(r"\\(.)", r"\1", re.sub(r"(?<!\\)\[((?:[^][\\]|\\.)*)\](?:\([\w:]+\))?", r"\1", markdown))


def plain(text: str) -> str:
    """Words in lower case, because a sentence may begin inside another; code is not marked."""
    return " ".join(text.replace("`", "").split()).lower()


def said(text: describe.Text, here: str) -> str:
    """A text as the crate must have it."""

    def ref(r: describe.Ref) -> str:
        if isinstance(r.thing, m.Field):
            return r.words if r.words.startswith("(") else names.path(r.thing, here).removeprefix("crate::")
        if isinstance(r.thing, (m.Enum, m.Bitfield, m.Struct)):
            return names.path(r.thing, here).removeprefix("crate::")
        if isinstance(r.thing, m.EnumValue) and isinstance(r.within, m.Enum):
            return f"{names.path(r.within, here).removeprefix('crate::')}::{names.constant(r.thing.name)}"
        return names.member(r.words) if isinstance(r.thing, m.Parameter) else r.words

    return describe.say(text, ref)


class Expected:
    """The texts that must be there, by item."""

    def __init__(self, model: m.Model) -> None:
        self.model = model
        self.unions = Crate(model).unions

    def all(self) -> Iterator[tuple[Item, str]]:
        for x in self.model.families:
            module, several = names.module(x.name), len(x.sets) > 1
            items = [("", x), *((names.set_constant(s, x) if several else "", s) for s in x.sets)]
            for item, of in items:
                unsure = [said(fact.sentence, module) for fact in describe.uncertain(of, self.model)]
                texts = [of.title, self.prose(of.description, module), *unsure, *describe.sources(of)]
                yield from (((module, item, ""), text) for text in texts)
            for f in x.fields:
                yield from self.field(f)
            for f in x.fields:
                yield from self.parameters(f)
        yield from self.field(self.model.protocol.acknowledge)
        yield from self.parameters(self.model.protocol.acknowledge)
        for t in (self.model.protocol.function_selector, *self.model.all_types):
            yield from self.type(t)
        for u in self.unions:
            yield from self.union(u.record.of, u.name, u.of)
        for d in self.model.devices:
            item = ("known", names.constant(d.name), "")
            prose = [self.prose(text, "devices") for text in (d.description, *(n.description for n in d.notes))]
            words = [text for n in d.notes for text in (n.title, *(cell for row in n.rows for cell in row))]
            facts = [said(fact.sentence, "devices") for fact in describe.device(d, self.model)]
            yield from ((item, text) for text in (d.title, *prose, *words, *facts, *describe.sources(d)))

    def prose(self, text: str, here: str) -> str:
        return said(describe.prose(text, self.model), here)

    def field(self, f: m.Field) -> Iterator[tuple[Item, str]]:
        item = (names.home(f), names.type_name(f.name), "")
        texts = [self.prose(f.description, item[0]), *describe.sources(f)]
        texts += [said(fact.sentence, item[0]) for fact in describe.in_code(f, self.model)]
        key = f"0x{f.descriptor:02X}" if len(f.occurrences) > 1 else f"0x{f.set:02X},0x{f.descriptor:02X}"
        yield from ((item, text) for text in (f"{f.title} ({key})", *texts))

    def parameters(self, record: m.Record) -> Iterator[tuple[Item, str]]:
        """The texts about a parameter without a member are at the record, after the name of the parameter."""
        here, owner = names.home(record), names.type_name(record.name)
        for p in record.parameters:
            texts = [self.prose(p.description, here), *self.facts(p, record)]
            if p.derived:
                yield (here, owner, ""), f"{p.name}: {' '.join(filter(None, texts))}"
            else:
                yield from (((here, owner, names.member(p.name)), text) for text in texts)

    def facts(self, p: m.Parameter, record: m.Record) -> list[str]:
        return [said(fact.sentence, names.home(record)) for fact in describe.parameter(p, record, self.model)]

    def union(self, record: m.Record, name: str, union: m.Union) -> Iterator[tuple[Item, str]]:
        here = names.home(record)
        for case in union.cases:
            description = (case.parameter and case.parameter.description) or case.tag.description
            texts = [self.prose(description, here)]
            texts += self.facts(case.parameter, record) if case.parameter else []
            yield from (((here, name, names.constant(case.tag.name)), text) for text in texts)

    def type(self, t: m.Type) -> Iterator[tuple[Item, str]]:
        here, owner = names.home(t), names.type_name(t.name)
        sources = [] if isinstance(t, m.Vector) else describe.sources(t)
        yield from (((here, owner, ""), text) for text in (self.prose(t.description, here), *sources))
        match t:
            case m.Struct():
                yield from self.parameters(t)
            case m.Enum():
                for v in t.values:
                    texts = [
                        self.prose(v.description, here),
                        *(said(fact.sentence, here) for fact in describe.value(v, self.model)),
                    ]
                    yield from (((here, owner, names.constant(v.name)), text) for text in texts)
            case m.Bitfield():
                for b in t.bits:
                    facts = describe.bits(b, self.model)
                    texts = [self.prose(b.description, here), *(said(fact.sentence, here) for fact in facts)]
                    yield from (((here, owner, names.constant(b.name)), text) for text in texts)


def missing(model: m.Model, files: dict[str, bytes]) -> list[str]:
    """The texts that are missing where they must be."""
    there = comments(files)
    return [f"{item}: {text}" for item, text in Expected(model).all() if plain(text) not in there.get(item, "")]


@pytest.mark.parametrize("spec", ["difficult", "invented", "real"])
def test_every_fact_is_told_where_it_belongs(spec: str) -> None:
    assert missing(specification(spec), rendered(spec)) == []
