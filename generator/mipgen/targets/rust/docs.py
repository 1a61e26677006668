"""Documentation comments: the texts of `describe`, as Markdown with links between the items of the crate."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache

from mipgen import model as m
from mipgen.emit.wrapping import wrapped
from mipgen.facts import describe

from .names import constant, home, member, method, module, path

WIDTH = 100

#: A paragraph, the items of a list, or the rows of a table.
Block = str | list[str] | list[tuple[str, ...]]


class Docs:
    """The documentation of each item, in blocks."""

    def __init__(self, model: m.Model) -> None:
        self.model = model

    # ------------------------------------------------------------------ sets, fields and parameters

    def family(self, family: m.Family) -> list[Block]:
        if len(family.sets) == 1:
            return self.set(family.sets[0])
        return self._set(family, f"{prose(family.title)} ({set_numbers(family)})", module(family.name))

    def set(self, s: m.Set) -> list[Block]:
        return self._set(s, f"{prose(s.title)} (0x{s.number:02X})", module(s.family))

    def _set(self, thing: m.Set | m.Family, head: str, here: str) -> list[Block]:
        uncertain, _ = self._facts(describe.uncertain(thing, self.model), here)
        return [f"{head}: {self._prose(thing.description, here)}", uncertain, sources_line(thing)]

    def field(self, f: m.Field) -> list[Block]:
        facts, notes = self._facts(describe.in_code(f, self.model), home(f))
        description = self._prose(f.description, home(f))
        return [f"{title(f)}.", description, facts, *self._only_on_the_wire(f), notes, sources_line(f)]

    def parameter(self, p: m.Parameter, record: m.Record) -> tuple[str, str, list[str]]:
        facts, notes = self._facts(describe.parameter(p, record, self.model), home(record))
        return self._prose(p.description, home(record)) or ("" if facts else name_in_words(p.name)), facts, notes

    def _only_on_the_wire(self, record: m.Record) -> list[Block]:
        """Describes the parameters that have no member."""
        blocks: list[Block] = []
        for p in record.parameters:
            if p.derived:
                description, facts, notes = self.parameter(p, record)
                texts = " ".join(filter(None, (description, facts, *notes)))
                blocks.append(f"The wire format also contains `{p.name}`: {texts}")
        return blocks

    # ------------------------------------------------------------------ types and their parts

    def type(self, t: m.Type) -> list[Block]:
        facts, _ = self._facts(describe.type_facts(t, self.model), home(t))
        parameters = self._only_on_the_wire(t) if isinstance(t, m.Struct) else []
        return [self._prose(t.description, home(t)) or name_in_words(t.name), facts, *parameters, sources_line(t)]

    def part(self, part: m.EnumValue | m.Bits, of: m.Enum | m.Bitfield) -> list[Block]:
        model = self.model
        composed = describe.value(part, model) if isinstance(part, m.EnumValue) else describe.bits(part, model)
        facts, _ = self._facts(composed, home(of))
        return [f"{self._prose(part.description, home(of)) or name_in_words(part.name)} {facts}".strip()]

    def case(self, case: m.Case, union: m.Parameter, record: m.Record) -> list[Block]:
        composed = [describe.case(case, union, record)]
        composed += describe.parameter(case.parameter, record, self.model) if case.parameter else []
        facts, notes = self._facts(composed, home(record))
        description = (case.parameter and case.parameter.description) or case.tag.description
        return [self._prose(description, home(record)) or name_in_words(case.tag.name), facts, notes]

    def variants(self, p: m.Parameter, record: m.Record, variants: Iterable[m.Variant], here: str) -> str:
        """Describes where these variants of a parameter apply."""
        grouped = describe.variants(p, record, self.model)
        return self._facts([fact for group, fact in grouped if any(v in variants for v in group)], here)[0]

    # ------------------------------------------------------------------ devices

    def device(self, d: m.Device) -> list[Block]:
        facts, _ = self._facts(describe.device(d, self.model), "devices")
        blocks: list[Block] = [prose(d.title), self._prose(d.description, "devices"), facts, sources_line(d)]
        for n in d.notes:
            rows = [tuple(map(prose, row)) for row in n.rows]
            rule = [("---",) * len(rows[0])] if rows else []
            blocks += [f"# {prose(n.title)}", self._prose(n.description, "devices"), rows[:1] + rule + rows[1:]]
        return blocks

    def difference(self, v: m.DeviceVariant) -> str:
        """Describes the difference on a device, as plain text."""
        text = describe.variant_text(v.variant, v.parameter, v.field, self.model)
        return describe.say(text, lambda r: r.words)

    # ------------------------------------------------------------------ texts of the specification

    def _prose(self, text: str, here: str) -> str:
        return describe.say(describe.prose(text, self.model), lambda r: reference(r, here), prose)

    def _facts(self, facts: Iterable[describe.Fact], here: str) -> tuple[str, list[str]]:
        """Returns the facts as one paragraph, and the notes."""
        sentences: list[str] = []
        notes: list[str] = []
        for fact in facts:
            sentence = describe.say(fact.sentence, lambda r: reference(r, here), prose)
            (notes if fact.topic == "note" else sentences).append(sentence[:1].upper() + sentence[1:])
        return " ".join(sentences), notes


def title(f: m.Field) -> str:
    """Returns the title of a field with its key; without the set, if there are several."""
    key = f"0x{f.descriptor:02X}" if len(f.occurrences) > 1 else f"0x{f.set:02X},0x{f.descriptor:02X}"
    return f"{prose(f.title)} ({key})"


def set_numbers(family: m.Family) -> str:
    """Writes the descriptor sets of a family, as people read them."""
    return ", ".join(f"0x{s.number:02X}" for s in family.sets)


def sources_line(thing: m.Field | m.Family | m.Set | m.Type | m.Device) -> str:
    cited = "; ".join(map(prose, describe.sources(thing)))
    return f"Source: {cited}." if cited else ""


def name_in_words(name: str) -> str:
    """Writes a name as a sentence, if there is no description.

    >>> name_in_words("time_of_week")
    'Time of week.'
    """
    return f"{name.replace('_', ' ').capitalize()}."


@cache
def prose(text: str) -> str:
    """Escapes words for Markdown: only code in backticks remains markup.

    >>> prose("a[1] < `b[2]`")
    'a\\\\[1\\\\] \\\\< `b[2]`'
    """
    parts = text.split("`")
    for i in range(0, len(parts), 2):
        for character in "[]<>*|":
            parts[i] = parts[i].replace(character, f"\\{character}")
    return "`".join(parts)


# --------------------------------------------------------------------------- references


def reference(r: describe.Ref, here: str) -> str:
    """Writes a link to an item, or its words if the crate has no such item."""
    match r.thing, r.within:
        case m.Field() as f, _:
            return link(path(f, here))
        case (m.Enum() | m.Bitfield() | m.Struct()) as t, _:
            return link(path(t, here))
        case m.EnumValue() as v, m.Enum() as t:
            return link(f"{path(t, here)}::{constant(v.name)}")
        case m.Bits() as b, m.Bitfield() as t:
            return link(f"{path(t, here)}::{method(b.name)}", f"`{r.words}`")
        case m.Parameter() as p, (m.Field() | m.Struct()) as record if not p.derived:
            return link(f"{path(record, here)}::{member(p.name)}", f"`{member(p.name)}`")
        case m.Parameter() as p, _:
            return f"`{member(p.name)}`"
        case m.Device() as d, _:
            return link(f"crate::devices::{constant(d.name)}", prose(r.words))
        case m.Function() as f, _:
            return link(f"{'' if here == 'types' else 'types::'}FunctionSelector::{constant(f.name)}", prose(r.words))
    return prose(r.words)


def link(target: str, text: str = "") -> str:
    """
    >>> link("Mode::FAST"), link("crate::gnss_data::Dop"), link("Flags::hot", "`flags.hot`")
    ('[`Mode::FAST`]', '[`gnss_data::Dop`](crate::gnss_data::Dop)', '[`flags.hot`](Flags::hot)')
    """
    text = text or f"`{target.removeprefix('crate::')}`"
    return f"[{text}]" if text == f"`{target}`" else f"[{text}]({target})"


# --------------------------------------------------------------------------- layout


def comment(blocks: Iterable[Block], indent: int = 0, marker: str = "///") -> str:
    """Writes the lines of a documentation comment.

    >>> print(comment(["One.", ["two", "three"], ""], 4))
        /// One.
        ///
        /// - two
        /// - three
    """
    margin = " " * indent
    width = WIDTH - indent - len(marker) - 1
    lines: list[str] = []
    for block in filter(None, blocks):
        lines += [""] if lines else []
        if isinstance(block, str):
            lines += wrapped(block, width)
        else:
            for item in block:
                lines += wrapped(f"- {item}", width, "  ") if isinstance(item, str) else [f"| {' | '.join(item)} |"]
    return "\n".join(f"{margin}{marker} {line}".rstrip() for line in lines)
