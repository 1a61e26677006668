"""Facts about parameters, types and their parts."""

from __future__ import annotations

from collections.abc import Iterator

from mipgen import model as m

from .measures import measures, numeral, validity
from .texts import Fact, Ref, fact, field_ref, functions, joined, needed, remarks, uncertain
from .variants import variants


def parameter_facts(p: m.Parameter, record: m.Record, model: m.Model) -> list[Fact]:
    """Composes the facts about a parameter, or the parameter of a union's case, besides its description."""
    beside = {q.name: q for q in record.parameters}
    facts: list[Fact] = []
    if p.deprecated:
        facts.append(fact("deprecated", (), "Deprecated."))
    if p.constant is not None:
        facts.append(fact("constant", (numeral(p, p.constant),), "Always {}."))
    if p.reserved is not None:
        sent = not isinstance(record, m.Field) or record.role == m.COMMAND
        value = (str(p.reserved),) if sent else ()
        facts.append(fact("reserved", value, "Reserved: send {}." if sent else "Reserved."))
    if p.counts:
        facts.append(fact("counts", (Ref(beside[p.counts], p.counts, record),), "Counts the elements of {}."))
    if p.tag:
        facts.append(fact("tag", (Ref(beside[p.tag], p.tag, record),), "Selected by {}."))
    if p.fields_of:
        facts.append(fact("fields_of", (_owner(p, beside, record, model),), "Refers to fields of {}."))
    facts += measures(p, p, model)
    if p.valid:
        facts.append(validity(p.valid, p, record))
    facts += _presence(p, record)
    facts += [difference for _, difference in variants(p, record, model)]
    return [*facts, *remarks(p, model)]


def _owner(p: m.Parameter, beside: dict[str, m.Parameter], record: m.Record, model: m.Model) -> str | Ref:
    """Refers to the set to which a parameter's field descriptors belong; a partial specification may lack it."""
    if p.fields_of in beside:
        return Ref(beside[p.fields_of], p.fields_of, record)
    data_set = model.set_named(p.fields_of)
    return Ref(data_set, data_set.title) if data_set else p.fields_of


def _presence(p: m.Parameter, record: m.Record) -> Iterator[Fact]:
    """States the conditions under which a parameter may be omitted."""
    if p.optional:
        yield fact("optional", (), "Optional.")
    elif isinstance(record, m.Field) and p in record.counted and len(p.required_for) < len(record.functions):
        yield fact("required", functions(p.required_for), "Required for {}.")


def case(c: m.Case, union: m.Parameter, record: m.Record) -> Fact:
    """States the condition for an alternative of a union."""
    tag = next(q for q in record.parameters if q.name == union.tag)
    assert isinstance(tag.element, m.Enum)
    value = (Ref(tag, tag.name, record), " is ", Ref(c.tag, c.tag.name, tag.element))
    return fact("case", value, "If {}." if c.parameter else "Empty if {}.")


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
