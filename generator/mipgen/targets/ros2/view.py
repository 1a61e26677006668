"""Messages: the members of fields and structures, and the constants for their values."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

from mipgen import model as m
from mipgen.facts import describe

from . import names


@dataclass(frozen=True, slots=True)
class Member:
    """A line of a message, and the lines before it."""

    type: str
    name: str
    comment: list[str]
    constants: list[tuple[str, list[tuple[str, str, int]]]]  # comments, each with types, names and values


@dataclass(frozen=True)
class Message:
    """The message for a field, or for a structure that another message contains."""

    record: m.Record
    model: m.Model

    @property
    def name(self) -> str:
        return names.message(self.record)

    @property
    def has_header(self) -> bool:
        return isinstance(self.record, m.Field)

    @property
    def comment(self) -> list[str]:
        record, title, description = self.record, "", self.record.description
        if isinstance(record, m.Field):
            title = f"{record.full_name}: {record.title}"
            description = "" if description == record.title else description
        caveats = (say(fact.sentence) for fact in describe.caveats(record, self.model))
        return list(filter(None, (title, say(describe.prose(description, self.model)), *caveats)))

    @cached_property
    def members(self) -> list[Member]:
        return _members(self.record, self.model)


def data_fields(model: m.Model) -> list[m.Field]:
    """Returns the fields that have messages."""
    return [f for f in model.fields if f.role == m.DATA]


def messages(model: m.Model) -> list[Message]:
    fields = data_fields(model)
    records: list[m.Record] = [*_nested(fields), *fields]
    return [Message(record, model) for record in records]


def _members(record: m.Record, model: m.Model) -> list[Member]:
    """Returns the members of a message in wire order, without counters and constants.

    A value that may be absent is an array, which is then empty.
    """
    members = []
    sets = [s for s in model.sets if s.number in record.sets] if isinstance(record, m.Field) else []
    if len(sets) > 1:
        numbers = [("uint8", names.constant("descriptor_set", s.name), s.number) for s in sets]
        members.append(Member("uint8", "descriptor_set", ["Descriptor set of the packet."], [("", numbers)]))
    for p in record.parameters:
        if p.derived:
            continue
        optional = isinstance(record, m.Field) and p.optional
        for q in p.alternatives if p.union else (p,):
            comment = list(_comment(q, record, model))
            absent = bool(p.union) or optional
            if absent and q.kind != "text":
                comment.append("Empty if absent.")
            members.append(Member(_type(q, absent), names.member(q.name), comment, list(_constants(q, record))))
    return members


def _nested(fields: list[m.Field]) -> list[m.Struct]:
    """Returns the structures that messages contain; each is also a message."""
    structs: dict[str, m.Struct] = {}

    def collect(record: m.Record) -> None:
        for p in record.parameters:
            for q in p.alternatives if p.union else (p,):
                t = q.leaf.element
                if isinstance(t, m.Struct) and names.message(t) not in structs:
                    structs[names.message(t)] = t
                    collect(t)

    for f in fields:
        collect(f)
    return list(structs.values())


def _type(p: m.Parameter, absent: bool) -> str:
    if p.kind == "text":
        return "string"
    element, count = _element(p.leaf), _count(p)
    if absent:
        return f"{element}[<={count or 1}]" if count is not None or not p.several else f"{element}[]"
    if p.kind in ("array", "bits"):
        return f"{element}[]" if count is None else f"{element}[{count}]"
    return element


def _element(p: m.Parameter) -> str:
    if isinstance(p.element, m.Struct):
        return names.message(p.element)
    return names.SCALARS["u8" if p.kind == "bits" else p.scalar.name]


def _count(p: m.Parameter) -> int | None:
    """Returns the length of an array, with the elements of all its vectors; None if it varies or there is no array."""
    if p.kind == "bits":
        return p.size
    if p.kind != "array" or p.count is None:
        return None
    return p.count * (_count(p.item) or 1) if p.item.kind == "array" else p.count


def _comment(p: m.Parameter, record: m.Record, model: m.Model) -> Iterator[str]:
    if p.description:
        yield say(describe.prose(p.description, model))
    elements = p.elements or (p.item.elements if p.kind == "array" else ())
    if elements:
        yield f"Elements: {', '.join(elements)}{' of each' if p.elements == () else ''}."
    topics = ("deprecated", "unit", "frame", "range", "positive", "valid", "reserved", "variant", "note", "uncertain")
    yield from (say(f.sentence) for f in describe.topics(describe.parameter(p, record, model), *topics))


def say(text: describe.Text) -> str:
    return describe.say(text, _reference)


def _reference(ref: describe.Ref) -> str:
    match ref.thing:
        case m.Field() | m.Struct():
            return f"`{names.message(ref.thing)}`" if ref.thing.name and _is_message(ref.thing) else f"`{ref.words}`"
        case m.Parameter():
            return f"`{names.member(ref.thing.name)}`"
        case _:
            return f"`{ref.words}`" if isinstance(ref.thing, (m.Bits, m.EnumValue)) else ref.words


def _is_message(thing: m.Field | m.Struct) -> bool:
    return isinstance(thing, m.Struct) or thing.role == m.DATA


def _constants(p: m.Parameter, record: m.Record) -> Iterator[tuple[str, list[tuple[str, str, int]]]]:
    """Yields the values of an enumeration, or the masks of a bitfield, as each type of the parameter names them."""
    scalar, usual = names.SCALARS[p.leaf.scalar.name], p.leaf.named
    for t in {t.full_name: t for t in (usual, *(v.type for v in p.readings)) if t is not None}.values():
        own = "" if t is usual else f"_{t.name}_".replace(f"_{p.name}_", "_").replace(f"_{record.name}_", "_")
        if isinstance(t, m.Bitfield) and t.scalar is None:  # too long for a mask
            bits = [(scalar, names.constant(p.name, f"{own}_{b.name}_bit"), b.first) for b in t.bits]
            yield f"Bits of {t.name}, the lowest of each, numbered from bit 0 of the first byte:", bits
        else:
            parts = ((x.name, x.mask if isinstance(x, m.Bits) else x.value) for x in m.named_parts(t))
            made = [(scalar, names.constant(p.name, f"{own}_{name}"), number) for name, number in parts]
            yield (f"{t.name}:" if own else ""), made
