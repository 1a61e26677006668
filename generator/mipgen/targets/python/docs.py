"""Docstrings: what `describe` says, with references as Python writes what they refer to."""

from __future__ import annotations

from collections.abc import Iterable

from mipgen import model as m
from mipgen.emit.wrapping import wrapped
from mipgen.facts import describe
from mipgen.facts.describe import Fact, Ref

from .members import annotation
from .names import constant, home, member, module, reference

WIDTH = 100  # of generated lines; pyproject.toml of the package says the same to ruff


def say(text: Iterable[str | Ref], where: str) -> str:
    """A text of `describe`, for the module `where`."""
    return describe.say(text, lambda ref: named(ref, where))


def named(ref: Ref, where: str) -> str:
    """What Python calls something that a text names."""
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


# --------------------------------------------------------------------------- docstrings


def of_family(x: m.Family, model: m.Model) -> str:
    numbers, where = ", ".join(f"0x{s.number:02X}" for s in x.sets), module(x.name)
    unsure = sentences(describe.uncertain(x, model), where)
    several = [_set(s, where, model) for s in x.sets] if len(x.sets) > 1 else []
    described = say(describe.prose(x.description, model), where)
    return literal([f"{x.title} ({numbers}).", described, unsure, "\n".join(several), sources(x)], 0)


def _set(s: m.Set, where: str, model: m.Model) -> str:
    return f"- {s.name} (0x{s.number:02X}): {_text(s.description, describe.uncertain(s, model), where, model)}"


def of_field(f: m.Field, model: m.Model) -> str:
    facts, where = describe.in_code(f, model), home(f)
    notes = describe.topics(facts, "note")
    return literal(
        [
            f"{f.title} ({descriptors(f)}).",
            say(describe.prose(f.description, model), where),
            sentences([fact for fact in facts if fact not in notes], where),
            sentences(notes, where),
            sources(f),
        ],
        4,
    )


def descriptors(f: m.Field) -> str:
    """ "0x80,0x04"; of a field of several sets the descriptor alone."""
    several = len(f.occurrences) > 1
    return f"0x{f.descriptor:02X}" if several else f"0x{f.set:02X},0x{f.descriptor:02X}"


def of_type(t: m.Type, model: m.Model) -> str:
    description = _text(t.description, describe.type(t, model), home(t), model)
    if isinstance(t, m.Vector):
        return literal([f"{description} Elements: {', '.join(t.elements)}."], 0)
    return literal([description, sources(t)], 4)


def of_function(f: m.Function) -> str:
    return literal([f.description], 8)


def of_device(d: m.Device, model: m.Model) -> str:
    text = _text(d.description, describe.device(d, model), "devices", model)
    return literal([text, sources(d)], 0)


def of_value(v: m.EnumValue, t: m.Enum, model: m.Model) -> str:
    return literal([_text(v.description, describe.value(v, model), home(t), model)], 4)


def of_bits(b: m.Bits, t: m.Bitfield, model: m.Model) -> str:
    return literal([_text(b.description, describe.bits(b, model), home(t), model)], 4)


def of_member(p: m.Parameter, record: m.Record, model: m.Model) -> str:
    facts, where = describe.parameter(p, record, model), home(record)
    variants = describe.topics(facts, "variant")
    choices = [say(fact.sentence, where) for fact in variants]
    choices += [_case(c, p, record, model) for c in p.cases]
    text = _text(p.description, [fact for fact in facts if fact not in variants], where, model)
    return literal([text, items(choices)], 4)


def _case(c: m.Case, union: m.Parameter, record: m.Record, model: m.Model) -> str:
    """What a union holds for one value of its tag."""
    where, p = home(record), c.parameter
    condition = say(describe.case(c, union, record).value, where)
    if p is None:
        return f"If {condition}: `None`."
    text = _text(p.description, describe.parameter(p, record, model), where, model)
    return f"If {condition}: `{annotation(p, record)}`. {text}".strip()


def of_unheld(p: m.Parameter, record: m.Record, model: m.Model) -> str:
    """A comment on a parameter that objects do not hold, as it follows from the rest."""
    text = _text(p.description, describe.parameter(p, record, model), home(record), model)
    return comment(f"On the wire only: {p.name}. {text}", 4)


def _text(description: str, facts: Iterable[Fact], where: str, model: m.Model) -> str:
    return f"{say(describe.prose(description, model), where)} {sentences(facts, where)}".strip()


def sentences(facts: Iterable[Fact], where: str) -> str:
    return " ".join(say(fact.sentence, where) for fact in facts)


def sources(thing: m.Field | m.Family | m.Enum | m.Bitfield | m.Struct | m.Device) -> str:
    return items(describe.sources(thing))


def items(texts: Iterable[str]) -> str:
    """A list, as one paragraph."""
    return "\n".join(f"- {text}" for text in texts)


# --------------------------------------------------------------------------- layout


def literal(paragraphs: Iterable[str], indent: int) -> str:
    """A docstring of these paragraphs, indented; nothing if they are empty.

    >>> literal(["Short."], 4)
    '\"""Short.\"""'
    >>> print(literal(["Short.", "- one\\n- two"], 4))
    \"""Short.
    <BLANKLINE>
        - one
        - two
        \"""
    """
    text = "\n\n".join(filter(None, paragraphs)).replace("\\", "\\\\").replace('"""', r"\"\"\"")
    if not text:
        return ""
    lines = [line for long in f'"""{text}'.split("\n") for line in _wrapped(long, WIDTH - indent)]
    if len(lines) == 1 and indent + len(lines[0]) + 3 <= WIDTH:
        return lines[0] + (' """' if text.endswith('"') else '"""')
    return _indented([*lines, '"""'], indent)


def comment(text: str, indent: int) -> str:
    """A comment, indented."""
    return _indented([f"# {line}" for line in _wrapped(text, WIDTH - indent - 2)], indent)


def _wrapped(text: str, width: int) -> list[str]:
    """The lines of a paragraph or of an item of a list, which hangs below its dash."""
    return wrapped(text, width, "  " if text.lstrip('"').startswith("- ") else "") or [""]


def _indented(lines: Iterable[str], indent: int) -> str:
    """Lines, indented except for the first one, whose indentation is already there."""
    return "\n".join(" " * indent + line if line else "" for line in lines).lstrip()
