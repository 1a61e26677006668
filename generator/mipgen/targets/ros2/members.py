"""Contents of messages: the members of fields and structures, and the constants for their values."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from mipgen import model as m
from mipgen.facts import describe

from . import names


@dataclass(frozen=True, slots=True)
class Member:
    """A line of a message, and the lines before it."""

    type: str
    name: str
    comment: list[str]
    constants: list[str]


def of_record(record: m.Record, model: m.Model) -> list[Member]:
    """Returns the members of a message in wire order, without counters and constants.

    A value that may be absent is an array, which is then empty.
    """
    members = []
    for p in record.parameters:
        if p.derived:
            continue
        optional = isinstance(record, m.Field) and p.optional
        for q in p.alternatives if p.union else (p,):
            comment = list(_comment(q, record, model))
            absent = bool(p.union) or optional
            if absent and q.kind != "text":
                comment.append("Empty if absent.")
            members.append(Member(_type(q, absent), names.member(q.name), comment, list(_constants(q))))
    return members


def nested(records: list[m.Field]) -> list[m.Struct]:
    """Returns the structures that messages contain; each is also a message."""
    messages: dict[str, m.Struct] = {}

    def collect(record: m.Record) -> None:
        for p in record.parameters:
            for q in p.alternatives if p.union else (p,):
                t = q.leaf.element
                if isinstance(t, m.Struct) and names.message(t) not in messages:
                    messages[names.message(t)] = t
                    collect(t)

    for f in records:
        collect(f)
    return list(messages.values())


def _type(p: m.Parameter, absent: bool) -> str:
    if p.kind == "text":
        return "string"
    one, count = _element(p.leaf), _count(p)
    if p.kind == "bits":
        one, count = "uint8", p.size
    if absent:
        return f"{one}[<={count or 1}]" if count is not None or not p.several else f"{one}[]"
    if p.kind in ("array", "bits"):
        return f"{one}[]" if count is None else f"{one}[{count}]"
    return one


def _element(p: m.Parameter) -> str:
    if isinstance(p.element, m.Struct):
        return names.message(p.element)
    return names.SCALARS["u8" if p.kind == "bits" else p.scalar.name]


def _count(p: m.Parameter) -> int | None:
    """Returns the length of an array, with the elements of all its vectors; None if it varies or there is no array."""
    if p.kind != "array" or p.count is None:
        return None
    return p.count * (_count(p.item) or 1) if p.item.kind == "array" else p.count


def _comment(p: m.Parameter, record: m.Record, model: m.Model) -> Iterator[str]:
    if p.description:
        yield describe.say(describe.prose(p.description, model), named)
    elements = p.elements or (p.item.elements if p.kind == "array" else ())
    if elements:
        yield f"Elements: {', '.join(elements)}{' of each' if p.elements == () else ''}."
    facts = describe.topics(describe.parameter(p, record, model), "unit", "frame", "range", "valid", "reserved")
    yield from (describe.say(f.sentence, named) for f in facts)


def named(ref: describe.Ref) -> str:
    match ref.thing:
        case m.Field() | m.Struct():
            return f"`{names.message(ref.thing)}`" if ref.thing.name and _is_message(ref.thing) else f"`{ref.words}`"
        case m.Parameter():
            return f"`{names.member(ref.thing.name)}`"
        case _:
            return f"`{ref.words}`" if isinstance(ref.thing, (m.Bits, m.EnumValue)) else ref.words


def _is_message(thing: m.Field | m.Struct) -> bool:
    return isinstance(thing, m.Struct) or thing.role == m.DATA


def _constants(p: m.Parameter) -> Iterator[str]:
    """Yields the values of an enumeration or the masks of a bitfield; none if they depend on the device."""
    kind = p.leaf.named
    if kind is None or p.by_device or p.leaf.kind == "bits":
        return
    scalar = names.SCALARS[p.leaf.scalar.name]
    if isinstance(kind, m.Enum):
        for v in kind.values:
            yield f"{scalar} {names.constant(p, v.name)}={v.value}"
    elif isinstance(kind, m.Bitfield):
        for b in kind.bits:
            yield f"{scalar} {names.constant(p, b.name)}={b.mask}"
