"""Names in the texts of a specification: fields, types and other names in backticks; descriptors only in quotations.

A text names a field by its full name, `3dm.pps_source_control`, and a type of a set likewise; `describe` turns
these into references. Other names in backticks are names of parameters, values and the like. Descriptors, such as
(0x0C,0x28), are the manuals' notation; only quotations of a manual contain them.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import islice

from mipgen import model as m
from mipgen.read.nodes import Node
from mipgen.read.problems import Problems, nearest

#: Keys with texts for readers, and keys with quotations of a manual.
PROSE = (
    "description", "notes", "uncertain", "incomplete", "evidence", "deprecated", "reason", "text", "question",
    "answer", "before", "on_event", "positive", "origin",
)  # fmt: skip
QUOTATIONS = ("printed", "right")

#: Keys with lists of sentences. In a list in brackets, YAML takes a comma for the end of an item.
SENTENCES = ("notes", "uncertain", "incomplete")
_SENTENCE = re.compile(r"(?![a-z]).*[.!?`\"')]", re.DOTALL)

DESCRIPTOR = re.compile(r"\(0x(?P<set>[0-9A-Fa-f]{2}),\s?0x(?P<descriptor>[0-9A-Fa-f]{2})\)")

_CODE = re.compile(r"`([^`]*)`")
_NAME = re.compile(r"[a-z0-9_]+(\.[a-z0-9_]+)?")
_COMMAND = re.compile(r"((?:[^\s.,;:]+\s+){1,8})commands?\b", re.IGNORECASE)
_REPLY = re.compile(r"\b(?:answer|reply|response)s? (?:of|to) (?:the )?((?:[^\s.,;:]+[\s.,;:]*){1,8})", re.IGNORECASE)
_BARE = re.compile(r"(?<![\w.`])[a-z0-9]+(?:_[a-z0-9]+)+(?![\w])|(?<![\w.])\w+\.\w+(?![\w*])")


def check_references(roots: Iterable[Node], model: m.Model, problems: Problems) -> None:
    """Reports malformed names, and names of things that do not exist."""
    names = _Names(model, problems.add)
    for root in roots:
        names.inside(root)


@dataclass(frozen=True)
class _Names:
    model: m.Model
    problem: Callable[[m.Position, str], None]

    def inside(self, node: Node) -> None:
        if isinstance(node.value, list):
            for item in node:
                if not isinstance(item.value, str):
                    self.inside(item)
        elif isinstance(node.value, dict):
            for key, entry in node.items():
                if key in SENTENCES and isinstance(entry.value, list):
                    self.sentences(entry)
                if key in PROSE:
                    for text in _texts(entry):
                        self.prose(text)
                elif key in QUOTATIONS:
                    for text in _texts(entry):
                        self.quotation(text, node)
                if not isinstance(entry.value, str) and key != "without":  # which lists names of notes
                    self.inside(entry)

    # ----------------------------------------------------------------------- texts

    def sentences(self, node: Node) -> None:
        for item in node:
            if isinstance(item.value, str) and not _SENTENCE.fullmatch(item.value):
                remedy = "begin with a capital letter and end with a full stop; if a comma ends it or the one before"
                self.problem(item.position, f"'{item.value}' is not a sentence: {remedy}, put the whole text in quotes")

    def prose(self, node: Node) -> None:
        for name in _CODE.findall(node.value):
            if _NAME.fullmatch(name):
                self.name(name, node.position)
        plain = _CODE.sub("", node.value)
        for match in DESCRIPTOR.finditer(plain):
            fields = [f"`{f.full_name}`" for f in self.fields(match)]
            remedy = f"write {' or '.join(fields)}" if fields else "no field has this descriptor; describe it in words"
            self.problem(node.position, f"a text must name a field, not quote its descriptor {match[0]}; {remedy}")
        for match in _BARE.finditer(plain):
            if "_" in match[0] or self.exists(match[0]):
                self.problem(node.position, f"'{match[0]}' is a name; put it in backticks: `{match[0]}`")

        for title in self.titled(plain):
            names = " or ".join(f"`{name}`" for name in self.titles[title.lower()])
            self.problem(node.position, f"'{title}' is the title of a command; refer to it as {names}")

    def titled(self, text: str) -> Iterator[str]:
        """Yields titles by which a text names commands: "the device reset command" or "the reply to device reset"."""
        lower = text.lower()
        for match in _COMMAND.finditer(text) if "command" in lower else ():  # most have none; searching is slow
            words = match[1].split()
            tails = (" ".join(words[at:]) for at in range(len(words)))
            yield from islice((x for x in tails if x.lower() in self.titles), 1)
        for match in _REPLY.finditer(text) if " to " in lower or " of " in lower else ():
            words = [word.rstrip(".,;:") for word in match[1].split()]
            heads = (" ".join(words[:end]) for end in range(len(words), 0, -1))
            yield from islice((x for x in heads if x.lower() in self.titles), 1)

    def quotation(self, node: Node, erratum: Node) -> None:
        """Reports descriptors that do not exist, unless the erratum claims that they do not."""
        claims = [c["reference"].value for c in erratum.get("claims") or () if "reference" in c]
        for match in DESCRIPTOR.finditer(node.value):
            subject = f"0x{match['set'].upper()},0x{match['descriptor'].upper()}"
            if subject not in claims and not self.fields(match):
                self.problem(node.position, f'no field has {match[0]}; add a claim: claims: [reference: "{subject}"]')

    def name(self, name: str, place: m.Position) -> None:
        if self.exists(name):
            return
        if "." in name:
            self.problem(place, f"no field or type '{name}'{nearest(name, self.full_names)}")
        elif name not in self.words:
            whole = sorted(f"`{x}`" for x in self.full_names if x.endswith(f".{name}"))
            remedy = f"; write {' or '.join(whole)}" if whole else nearest(name, self.words)
            self.problem(place, f"no parameter, value or bit is called '{name}'{remedy}")

    # ----------------------------------------------------------------------- what there is

    def fields(self, match: re.Match[str]) -> tuple[m.Field, ...]:
        return self.model.candidates(int(match["set"], 16), int(match["descriptor"], 16))

    def exists(self, name: str) -> bool:
        """True for the name of a field, a type, or a descriptor without a layout."""
        return self.model.field(name) is not None or self.model.type(name) is not None or name in self.full_names

    @cached_property
    def titles(self) -> dict[str, list[str]]:
        """Maps the title of a command, or its name in words, to the full names of such commands."""
        names: dict[str, list[str]] = {}
        for f in self.model.fields:
            if f.role == m.COMMAND:
                for words in {f.title.lower(), *(name.replace("_", " ") for name in (f.name, *f.also))}:
                    names.setdefault(words, []).append(f.full_name)
        return names

    @cached_property
    def full_names(self) -> set[str]:
        types = {f"{x.name}.{t.name}" for x in self.model.families for t in x.types}
        named = {f"{s.name}.{n.name}" for x in self.model.families for s in x.sets for n in x.named}
        return {*self.model.names, *types, *named}

    @cached_property
    def words(self) -> set[str]:
        """Returns the names that need no set: parameters, values, bits, sets, families, types, frames and devices."""
        protocol, types = self.model.protocol, (*self.model.all_types, self.model.protocol.function_selector)
        records = (*self.model.records, protocol.acknowledge)
        names = {q.name for r in records for p in r.parameters for q in (p, *p.alternatives)}
        names |= {v.name for t in types if isinstance(t, m.Enum) for v in t.values}
        names |= {b.name for t in types if isinstance(t, m.Bitfield) for b in t.bits}
        names |= {s.name for s in self.model.sets} | {x.name for x in self.model.families}
        names |= {t.name for t in self.model.types}
        return names | {w.symbol for w in protocol.frames} | {d.name for d in self.model.devices}


def _texts(node: Node) -> Iterator[Node]:
    if isinstance(node.value, str):
        yield node
    elif isinstance(node.value, list):
        yield from (item for item in node if isinstance(item.value, str))
    elif isinstance(node.value, dict):
        yield from (item for item in node.value.values() if isinstance(item.value, str))
