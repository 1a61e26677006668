"""Documentation comments: the facts of `describe`, with the names of C, wrapped."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from mipgen import model as m
from mipgen.emit.wrapping import wrapped
from mipgen.facts import describe
from mipgen.lower.memory import stored

from . import names
from .literals import hexadecimal

#: The line length of clang-format, which moves comments but need not wrap these.
WIDTH = 100


#: Headers leave the devices that support a field to the profiles.
EVIDENCE = ("devices", "likely", "assumed")
ELSEWHERE = "The devices that support a field are in mip/extra/profiles.h."


def comment(paragraphs: Sequence[str], indent: int = 0) -> str:
    """Writes a comment and a line break; empty without a text. The lines of a paragraph are not joined.

    >>> print(comment(["Speed.", "- a manual\\n- a leaflet"]), end="")
    /**
     * Speed.
     *
     * - a manual
     * - a leaflet
     */
    """
    blocks = [_wrapped(p, WIDTH - indent - len(" * ")) for p in paragraphs]
    lines = [line for i, block in enumerate(blocks) for line in (["", *block] if i else block)]
    if not lines:
        return ""
    if len(lines) == 1 and indent + len(lines[0]) + len("/**  */") <= WIDTH:
        return f"/** {lines[0]} */\n"
    return "\n".join(["/**", *(f" * {line}".rstrip() for line in lines), " */\n"])


def inert(text: str) -> str:
    """Writes a text for a comment, so that it neither ends that nor begins another."""
    return text.replace("*/", "* /").replace("/*", "/ *")


def _wrapped(paragraph: str, width: int) -> list[str]:
    lines: list[str] = []
    for line in inert(paragraph).splitlines():
        lines += wrapped(line, width, "  " * line.startswith("- "))
    return lines


def reference(r: describe.Ref) -> str:
    """Returns the name of a thing in a comment."""
    match r.thing, r.within:
        case m.Field() as f, _:
            return names.field_name(f)
        case m.Set() as s, _:
            return names.set_constant(s)
        case m.Parameter() as p, _:
            return names.member(p.name) if p.constant is None else p.name
        case m.EnumValue() as v, m.Enum() as e:
            return names.constant(e, v)
        case m.Bits() as b, m.Bitfield(scalar=m.Scalar()) as t:
            flags, dot, _ = r.words.rpartition(".")
            return names.constant(t, b) + (f" in {names.member(flags)}" if dot else "")
        case m.Enum() as t, _:
            return f"enum {names.type_name(t)}"
        case (m.Bitfield() | m.Struct()) as t, _:
            return names.type_name(t)
        case _:
            return r.words


def sentences(facts: Iterable[describe.Fact]) -> list[str]:
    return [describe.say(f.sentence, reference) for f in facts]


@dataclass(frozen=True, slots=True)
class Comments:
    """Composes the comment of each thing, in paragraphs."""

    model: m.Model

    def family(self, x: m.Family) -> list[str]:
        """Composes the comment of a header: the facts about its set, or about the family of sets that share it."""
        place = f" ({hexadecimal(x.number)})" if len(x.sets) == 1 else ""
        what = " ".join([f"{x.title}{place}.", *self._prose(x.description)])
        return ["@file", " ".join([what, *sentences(describe.uncertain(x, self.model))]), ELSEWHERE]

    def set(self, s: m.Set, family: m.Family) -> list[str]:
        """Composes the comment of a set's constant; it describes the set if the header covers several."""
        if len(family.sets) == 1:
            return ["Descriptor set of these fields."]
        what = " ".join([f"Descriptor set: {s.title}.", *self._prose(s.description)])
        return [" ".join([what, *sentences(describe.uncertain(s, self.model))])]

    def field(self, f: m.Field) -> list[str]:
        single = f.set and len(f.occurrences) == 1
        place = f"({hexadecimal(f.set)},{hexadecimal(f.descriptor)})" if single else hexadecimal(f.descriptor)
        return [
            f"{f.title}: {f.role} {place}.",
            *self._prose(f.description),
            *_in_full(f),
            *_paragraphs([], [x for x in describe.in_code(f, self.model) if x.topic not in EVIDENCE]),
            *self._without_member(f),
            *_cited(f),
        ]

    def key(self, f: m.Field) -> list[str]:
        """Composes the comment of a field's constant."""
        if len(self.model.layouts(f)) == 1:
            return []
        return ["Other layouts share this descriptor: _decode rejects those with MIP_ERROR_LAYOUT."]

    def present(self, f: m.Field) -> list[str]:
        """Composes the comment of the member that counts the present parameters."""
        return ["Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant."]

    def type(self, t: m.Enum | m.Bitfield | m.Struct) -> list[str]:
        more = self._without_member(t) if isinstance(t, m.Struct) else []
        texts = [*self._prose(t.description), *_in_full(t)]
        return [*_paragraphs(texts, describe.type_facts(t, self.model)), *more, *_cited(t)]

    def member(self, p: m.Parameter, record: m.Record) -> list[str]:
        empty = [describe.case(c, p, record) for c in p.cases if c.parameter is None]
        text = [*self._prose(p.description), *_values(p)]
        return _paragraphs(text, [*describe.parameter(p, record, self.model), *empty])

    def arguments(self, parameters: Sequence[m.Parameter], f: m.Field) -> list[str]:
        """Describes the arguments of a function with the comments of the members."""
        items = [f"- {names.argument_name(p.name)}: {' '.join(self.member(p, f))}" for p in parameters]
        return ["\n".join(items)] if items else []

    def case(self, c: m.Case, union: m.Parameter, record: m.Record) -> list[str]:
        """Composes the comment of an alternative: when it is present, then the documentation of its parameter."""
        assert c.parameter is not None
        text = [*self._prose(c.parameter.description or c.tag.description), *_values(c.parameter)]
        when = sentences([describe.case(c, union, record)])
        return _paragraphs([*when, *text], describe.parameter(c.parameter, record, self.model))

    def value(self, v: m.EnumValue) -> list[str]:
        return _paragraphs([*self._prose(v.description), *_in_full(v)], describe.value(v, self.model))

    def bits(self, b: m.Bits) -> list[str]:
        place, *facts = describe.bits(b, self.model)
        return _paragraphs([*sentences([place]), *self._prose(b.description), *_in_full(b)], facts)

    def device(self, d: m.Device) -> list[str]:
        facts = sentences(describe.device(d, self.model))
        return [" ".join([f"{d.title}:", *self._prose(d.description)]), " ".join(facts), *_cited(d)]

    def _prose(self, text: str) -> list[str]:
        """Writes a text of the specification, if there is one."""
        return [describe.say(describe.prose(text, self.model), reference)] if text else []

    def _without_member(self, record: m.Record) -> list[str]:
        """Describes parameters that exist only on the wire."""
        left = [p for p in record.parameters if p not in stored(record)]
        items = [f"- {p.name}: {' '.join(self.member(p, record))}" for p in left]
        return ["\n".join(["Parameters without a member, on the wire only:", *items])] if items else []


def _values(p: m.Parameter) -> list[str]:
    """Names the enumeration of a member, whose C type is only a number."""
    if not isinstance(p.element, m.Enum):
        return []
    kind = "enum " if names.is_enum(p.element) else ""
    return [f"{'A value' if p.length is None else 'Values'} of {kind}{names.type_name(p.element)}."]


def _paragraphs(texts: list[str], facts: Sequence[describe.Fact]) -> list[str]:
    """Joins texts and facts into one paragraph; each note is a paragraph of its own."""
    notes = describe.topics(facts, "note")
    first = " ".join([*texts, *sentences(f for f in facts if f not in notes)])
    return [*([first] if first else []), *sentences(notes)]


def _in_full(thing: m.Field | m.Enum | m.Bitfield | m.Struct | m.EnumValue | m.Bits) -> list[str]:
    """States the name in the specification, if C uses a shorter one."""
    return [f"Full name: {thing.full_name if isinstance(thing, m.Field) else thing.name}."] if thing.short else []


def _cited(thing: m.Field | m.Enum | m.Bitfield | m.Struct | m.Device) -> list[str]:
    cited = describe.sources(thing)
    return ["\n".join(f"- {source}" for source in cited)] if cited else []
