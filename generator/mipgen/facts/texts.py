"""The parts of facts: words and references, in order.

A target only decides the form of words and references in its language; see `say`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass

from mipgen import model as m

from .references import DESCRIPTOR

Thing = (
    m.Field
    | m.Set
    | m.Enum
    | m.Bitfield
    | m.Struct
    | m.EnumValue
    | m.Bits
    | m.Parameter
    | m.Function
    | m.Device
    | m.Manual
    | m.Word
)


@dataclass(frozen=True, slots=True)
class Ref:
    """A reference to a part of the model."""

    thing: Thing
    words: str  # its name in the specification
    within: m.Record | m.Enum | m.Bitfield | None = None  # the record of a parameter; the type of a value or a bit


#: Words and references, in order.
Text = tuple["str | Ref", ...]


@dataclass(frozen=True, slots=True)
class Fact:
    """One fact about a field, a parameter, a value or a bit."""

    topic: str
    value: Text
    sentence: Text


def say(text: Iterable[str | Ref], ref: Callable[[Ref], str], words: Callable[[str], str] = str) -> str:
    """Writes a text in a language.

    >>> say(("Default: ", Ref(m.EnumValue("off", 0, ""), "off"), "."), lambda r: f"`{r.words}`")
    'Default: `off`.'
    """
    return "".join([words(part) if isinstance(part, str) else ref(part) for part in text])


def topics(facts: Iterable[Fact], *wanted: str) -> list[Fact]:
    """Returns the facts with these topics, in order."""
    return [f for f in facts if f.topic in wanted]


# --------------------------------------------------------------------------- of the specification

_CODE = re.compile(r"`([^`]*)`")


def prose(text: str, model: m.Model) -> Text:
    """Parses a text of the specification. The name of a field or a type in backticks, `base.ping`, becomes a reference;
    other text between backticks stays as it is."""

    def named(match: re.Match[str]) -> Ref | None:
        f, t = model.field(match[1]), model.type(match[1])
        if f is not None:
            return field_ref(f)
        return None if t is None or isinstance(t, m.Vector) else Ref(t, t.name)

    return _referring(text, _CODE, named) if "`" in text else (text,)


def quotation(text: str, model: m.Model) -> Text:
    """Parses a quotation of a manual, which names fields by their descriptors, such as (0x0C,0x28)."""

    def described(match: re.Match[str]) -> Ref | None:
        fields = model.candidates(int(match["set"], 16), int(match["descriptor"], 16))
        return Ref(fields[0], match[0]) if fields else None

    return _referring(text, DESCRIPTOR, described)


def _referring(text: str, pattern: re.Pattern[str], refer: Callable[[re.Match[str]], Ref | None]) -> Text:
    """Replaces the matches of a pattern by references."""
    parts: list[str | Ref] = []
    at = 0
    for match in pattern.finditer(text):
        ref = refer(match)
        if ref is not None:
            parts += [text[at : match.start()], ref]
            at = match.end()
    return tuple(part for part in (*parts, text[at:]) if part)


def number(value: object) -> str:
    """
    >>> number(2.50), number(10.0), number(7)
    ('2.5', '10', '7')
    """
    return str(int(value)) if isinstance(value, float) and value.is_integer() and abs(value) < 1e15 else str(value)


def measured(number: str, unit: str | None, model: m.Model) -> str:
    """Adds the unit to a number or a list of numbers: 3 m, week 2412, 253 bytes."""
    word = next((w for w in model.protocol.units if w.key == unit), None)
    if word is None or word.key == "1":
        return number
    if word.numbered:
        return f"{word.symbol} {number}"
    return f"{number} {word.plural if word.plural and number != '1' else word.symbol}"


def joined(items: Sequence[Text], last: str = "and") -> Text:
    """
    >>> joined([("a",), ("b",), ("c",)])
    ('a', ', ', 'b', ' and ', 'c')
    """
    if len(items) < 2:
        return items[0] if items else ()
    return (*interleaved(items[:-1], ", "), f" {last} ", *items[-1])


def interleaved(items: Sequence[Text], between: str) -> Text:
    parts: list[str | Ref] = []
    for i, item in enumerate(items):
        parts += [between, *item] if i else item
    return tuple(parts)


def fact(topic: str, value: Text, sentence: str) -> Fact:
    """Makes a fact whose sentence contains its value at `{}`."""
    head, mark, tail = sentence.partition("{}")
    whole = (head, *value, tail) if mark else (sentence,)
    return Fact(topic, value, tuple(part for part in whole if part))


def field_ref(f: m.Field) -> Ref:
    return Ref(f, f.full_name)


def thing_ref(x: m.Field | m.Set) -> Ref:
    """Refers to a field or a set."""
    return field_ref(x) if isinstance(x, m.Field) else Ref(x, f"{x.name} (0x{x.number:02X})")


def device_ref(d: m.Device) -> Ref:
    return Ref(d, d.title)


def device_refs(devices: Iterable[m.Device]) -> Text:
    return joined([(device_ref(d),) for d in devices])


def functions(several: Iterable[m.Function]) -> Text:
    return joined([(Ref(f, f.name),) for f in several])


# --------------------------------------------------------------------------- in the author's words


def remarks(of: m.Field | m.Parameter, model: m.Model) -> Iterator[Fact]:
    """Yields facts in the author's words: notes and uncertainties."""
    yield from needed(of.needs if isinstance(of, m.Field) else ())
    yield from (fact("note", prose(note, model), "{}") for note in of.notes)
    yield from uncertain(of, model)


def needed(needs: tuple[str, ...]) -> Iterator[Fact]:
    """States the hardware that a field, a value or a bit requires."""
    if needs:
        yield fact("needs", (" and ".join(map(m.worded, needs)),), "Requires {}.")


Doubtful = m.Field | m.Family | m.Set | m.Parameter | m.Type | m.EnumValue | m.Bits | m.Device


def uncertain(of: Doubtful, model: m.Model) -> list[Fact]:
    """Returns the uncertainties, each with the known and the inferred facts."""
    return [fact("uncertain", prose(text.rstrip("."), model), "Uncertain: {}.") for text in of.uncertain]


def sources(thing: m.Field | m.Occurrence | m.Family | m.Set | m.Type | m.Device) -> list[str]:
    """Returns the manuals and sections that describe it: "3dm-gx5-15: 4.1.1 Ping (0x01, 0x01)"."""
    return [f"{s.manual}: {s.section}" for s in thing.sources]
