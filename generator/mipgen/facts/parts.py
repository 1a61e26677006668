"""Facts about types and their parts."""

from __future__ import annotations

from mipgen import model as m

from .remarks import needed, uncertain
from .texts import Fact, Ref, fact, field_ref, joined


def bits_place(b: m.Bits) -> str:
    """
    >>> bits_place(m.Bits("a", 3, 3, "", False)), bits_place(m.Bits("b", 4, 7, "", False))
    ('bit 3', 'bits 4 to 7')
    """
    return f"bit {b.first}" if b.width == 1 else f"bits {b.first} to {b.last}"


def type_facts(t: m.Type, model: m.Model) -> list[Fact]:
    """Returns the facts about a type besides its description."""
    return uncertain(t, model)


def bits(b: m.Bits, model: m.Model) -> list[Fact]:
    place = bits_place(b)
    facts = [Fact("place", (place,), (f"{place.capitalize()}.",))]
    if b.enum is not None:
        facts.append(fact("values", (Ref(b.enum, b.enum.name),), "A value of {}."))
    if b.alias:
        facts.append(fact("alias", (), "Overlaps other bits."))
    if b.when is not None:
        states = model.type(b.when.type)
        assert isinstance(states, m.Enum)
        values = [(Ref(v, v.name, states),) for v in states.values if v.name in b.when.values]
        facts.append(fact("when", (f"`{b.when.parameter}` is ", *joined(values, "or")), "Only while {}."))
    about = [f for name in b.concerns if (f := model.field(name)) is not None]
    if about:
        facts.append(fact("concerns", joined([(field_ref(f),) for f in about]), "Affects {}."))
    return [*facts, *needed(b.needs), *uncertain(b, model)]


def value(v: m.EnumValue, model: m.Model) -> list[Fact]:
    return [*([fact("deprecated", (), "Deprecated.")] if v.deprecated else []), *needed(v.needs), *uncertain(v, model)]
