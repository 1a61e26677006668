"""Comments of declarations: what `describe` says, with references as JavaScript writes what they refer to."""

from __future__ import annotations

from collections.abc import Iterable

from mipgen import model as m
from mipgen.emit.wrapping import wrapped
from mipgen.facts import describe
from mipgen.facts.describe import Fact, Ref

from .members import hint
from .names import constant, home, member, module, reference

WIDTH = 120


def say(text: Iterable[str | Ref], where: str) -> str:
    """A text of `describe`, for the module `where`."""
    return describe.say(text, lambda ref: named(ref, where))


def named(ref: Ref, where: str) -> str:
    """What JavaScript calls something that a text names."""
    match ref.thing:
        case m.Field() | m.Enum() | m.Bitfield() | m.Struct():
            return f"`{reference(ref.thing, where)}`"
        case m.EnumValue() | m.Bits():
            assert isinstance(ref.within, (m.Enum, m.Bitfield))
            holder, dot, _ = ref.words.rpartition(".")  # valid_flags.tow: the member that has the bit
            name = f"`{reference(ref.within, where)}.{constant(ref.thing.name)}`"
            return f"{name} of `{member(holder)}`" if dot else name
        case m.Parameter() | m.Function():
            return f"`{member(ref.thing.name)}`"
        case _:
            return ref.words


def of_family(x: m.Family, model: m.Model) -> str:
    numbers, where = ", ".join(f"0x{s.number:02X}" for s in x.sets), module(x.name)
    unsure = sentences(describe.uncertain(x, model), where)
    several = [_set(s, where, model) for s in x.sets] if len(x.sets) > 1 else []
    described = say(describe.prose(x.description, model), where)
    return comment([f"{x.title} ({numbers}).", described, unsure, "\n".join(several), sources(x)], 0)


def _set(s: m.Set, where: str, model: m.Model) -> str:
    return f"- {s.name} (0x{s.number:02X}): {_text(s.description, describe.uncertain(s, model), where, model)}"


def of_field(f: m.Field, model: m.Model) -> str:
    facts, where = describe.in_code(f, model), home(f)
    notes = describe.topics(facts, "note")
    several = len(f.occurrences) > 1
    place = f"0x{f.descriptor:02X}" if several else f"0x{f.set:02X},0x{f.descriptor:02X}"
    return comment(
        [
            f"{f.title} ({place}).",
            say(describe.prose(f.description, model), where),
            sentences([fact for fact in facts if fact not in notes], where),
            sentences(notes, where),
            sources(f),
        ],
        0,
    )


def of_type(t: m.Type, model: m.Model) -> str:
    description = _text(t.description, describe.type(t, model), home(t), model)
    if isinstance(t, m.Vector):
        return comment([f"{description} Elements: {', '.join(t.elements)}."], 0)
    return comment([description, sources(t)], 0)


def of_function(f: m.Function) -> str:
    return comment([f.description], 4)


def of_value(v: m.EnumValue, t: m.Enum, model: m.Model) -> str:
    return comment([_text(v.description, describe.value(v, model), home(t), model)], 4)


def of_bits(b: m.Bits, t: m.Bitfield, model: m.Model) -> str:
    return comment([_text(b.description, describe.bits(b, model), home(t), model)], 4)


def of_member(p: m.Parameter, record: m.Record, model: m.Model) -> str:
    facts, where = describe.parameter(p, record, model), home(record)
    variants = describe.topics(facts, "variant")
    choices = [say(fact.sentence, where) for fact in variants]
    choices += [_case(c, p, record, model) for c in p.cases]
    text = _text(p.description, [fact for fact in facts if fact not in variants], where, model)
    if p.derived:
        text = f"On the wire only: {p.name}. {text}"
    return comment([text, items(choices)], 4)


def _case(c: m.Case, union: m.Parameter, record: m.Record, model: m.Model) -> str:
    """What a union holds for one value of its tag."""
    where, p = home(record), c.parameter
    condition = say(describe.case(c, union, record).value, where)
    if p is None:
        return f"If {condition}: `{{}}`."
    text = _text(p.description, describe.parameter(p, record, model), where, model)
    return f"If {condition}: `{member(p.name)}: {hint(p, record)}`. {text}".strip()


def _text(description: str, facts: Iterable[Fact], where: str, model: m.Model) -> str:
    return f"{say(describe.prose(description, model), where)} {sentences(facts, where)}".strip()


def sentences(facts: Iterable[Fact], where: str) -> str:
    return " ".join(say(fact.sentence, where) for fact in facts)


def sources(thing: m.Field | m.Family | m.Enum | m.Bitfield | m.Struct) -> str:
    return items(describe.sources(thing))


def items(texts: Iterable[str]) -> str:
    """A list, as one paragraph."""
    return "\n".join(f"- {text}" for text in texts)


def comment(paragraphs: Iterable[str], indent: int) -> str:
    """A comment of these paragraphs with a line end behind it, indented; nothing if they are empty.

    >>> comment(["Short."], 4)
    '    /** Short. */\\n'
    """
    text = "\n\n".join(filter(None, paragraphs)).replace("*/", "*\u200b/")
    if not text:
        return ""
    margin = " " * indent
    lines = [line for long in text.split("\n") for line in _wrapped(long, WIDTH - indent - 3)]
    if len(lines) == 1 and indent + len(lines[0]) + 7 <= WIDTH:
        return f"{margin}/** {lines[0]} */\n"
    return "\n".join([f"{margin}/**", *(f"{margin} * {line}".rstrip() for line in lines), f"{margin} */", ""])


def _wrapped(text: str, width: int) -> list[str]:
    """The lines of a paragraph or of an item of a list, which hangs below its dash."""
    return wrapped(text, width, "  " if text.startswith("- ") else "") or [""]
