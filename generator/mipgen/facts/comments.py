"""Comments in code: the facts about each part of a model, as paragraphs, with the names of one language."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Protocol

from mipgen import model as m

from . import describe
from .describe import Fact, Ref


class Names(Protocol):
    """The names in a language, as the module `names` of its target defines them."""

    @property
    def module(self) -> Callable[[str], str]: ...
    @property
    def member(self) -> Callable[[str], str]: ...
    @property
    def constant(self) -> Callable[[str], str]: ...
    @property
    def home(self) -> Callable[[m.Type | m.Field], str]: ...
    @property
    def reference(self) -> Callable[[m.Type | m.Field, str], str]: ...


@dataclass(frozen=True)
class Comments:
    """Composes comments. Each method returns paragraphs; a list item begins with a dash, on a line of its own."""

    names: Names
    alternative: Callable[[m.Parameter | None, m.Record], str]  # the content of a union

    def family(self, x: m.Family, model: m.Model) -> list[str]:
        numbers, where = ", ".join(f"0x{s.number:02X}" for s in x.sets), self.names.module(x.name)
        described = self.say(describe.prose(x.description, model), where)
        several = x.sets if len(x.sets) > 1 else ()
        sets = [f"{s.name} (0x{s.number:02X}): {self._uncertain(s, where, model)}" for s in several]
        unsure = self._sentences(describe.uncertain(x, model), where)
        return [f"{x.title} ({numbers}).", described, unsure, _items(sets), _sources(x)]

    def _uncertain(self, s: m.Set, where: str, model: m.Model) -> str:
        return self._text(s.description, describe.uncertain(s, model), where, model)

    def field(self, f: m.Field, model: m.Model) -> list[str]:
        facts, where = describe.in_code(f, model), self.names.home(f)
        notes = describe.topics(facts, "note")
        return [
            f"{f.title} ({descriptors(f)}).",
            self.say(describe.prose(f.description, model), where),
            self._sentences([fact for fact in facts if fact not in notes], where),
            self._sentences(notes, where),
            _sources(f),
        ]

    def type(self, t: m.Type, model: m.Model) -> list[str]:
        description = self._text(t.description, describe.type_facts(t, model), self.names.home(t), model)
        if isinstance(t, m.Vector):
            return [f"{description} Elements: {', '.join(t.elements)}."]
        return [description, _sources(t)]

    def value(self, v: m.EnumValue, t: m.Enum, model: m.Model) -> list[str]:
        return [self._text(v.description, describe.value(v, model), self.names.home(t), model)]

    def bits(self, b: m.Bits, t: m.Bitfield, model: m.Model) -> list[str]:
        return [self._text(b.description, describe.bits(b, model), self.names.home(t), model)]

    def member(self, p: m.Parameter, record: m.Record, model: m.Model) -> list[str]:
        facts, where = describe.parameter(p, record, model), self.names.home(record)
        variants = describe.topics(facts, "variant")
        choices = [self.say(fact.sentence, where) for fact in variants]
        choices += [self._case(c, p, record, model) for c in p.cases]
        text = self._text(p.description, [fact for fact in facts if fact not in variants], where, model)
        return [f"On the wire only: {p.name}. {text}" if p.derived else text, _items(choices)]

    def _case(self, c: m.Case, union: m.Parameter, record: m.Record, model: m.Model) -> str:
        """Describes the content of a union for one value of its tag."""
        where, p = self.names.home(record), c.parameter
        text = f"If {self.say(describe.case(c, union, record).value, where)}: `{self.alternative(p, record)}`."
        facts = describe.parameter(p, record, model) if p else []
        return f"{text} {self._text(p.description if p else '', facts, where, model)}".strip()

    def device(self, d: m.Device, model: m.Model) -> list[str]:
        return [self._text(d.description, describe.device(d, model), "devices", model), _sources(d)]

    # ------------------------------------------------------------------------ words

    def _text(self, description: str, facts: Iterable[Fact], where: str, model: m.Model) -> str:
        return f"{self.say(describe.prose(description, model), where)} {self._sentences(facts, where)}".strip()

    def _sentences(self, facts: Iterable[Fact], where: str) -> str:
        return " ".join(self.say(fact.sentence, where) for fact in facts)

    def say(self, text: Iterable[str | Ref], where: str) -> str:
        return describe.say(text, lambda ref: self._named(ref, where))

    def _named(self, ref: Ref, where: str) -> str:
        """Returns the name that the module `where` uses for a reference in a text."""
        names = self.names
        match ref.thing:
            case m.Field() | m.Enum() | m.Bitfield() | m.Struct():
                return f"`{names.reference(ref.thing, where)}`"
            case m.EnumValue() | m.Bits():
                assert isinstance(ref.within, (m.Enum, m.Bitfield))
                holder, dot, _ = ref.words.rpartition(".")  # valid_flags.tow: the member that contains the bit
                name = f"`{names.reference(ref.within, where)}.{names.constant(ref.thing.name)}`"
                return f"{name} of `{names.member(holder)}`" if dot else name
            case m.Parameter() | m.Function():
                return f"`{names.member(ref.thing.name)}`"
            case _:
                return ref.words


def descriptors(f: m.Field) -> str:
    """Writes set and descriptor, "0x80,0x04"; for a field of several sets, only the descriptor."""
    return f"0x{f.descriptor:02X}" if len(f.occurrences) > 1 else f"0x{f.set:02X},0x{f.descriptor:02X}"


def _sources(thing: m.Field | m.Family | m.Enum | m.Bitfield | m.Struct | m.Device) -> str:
    """Lists manuals and sections."""
    return _items(describe.sources(thing))


def _items(texts: Iterable[str]) -> str:
    return "\n".join(f"- {text}" for text in texts)
