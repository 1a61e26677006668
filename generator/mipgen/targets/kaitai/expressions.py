"""Expressions for the presence of a parameter, the limit of a count, and the layout of data."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from mipgen import model as m
from mipgen.lower import extent
from mipgen.lower.extent import Extent

from .names import member, type_name, value


def least(parameters: Iterable[m.Parameter]) -> Extent:
    """Returns the bytes that must be present, once counters are known."""
    return extent.shortest_size(parameters).counted


def bytes_of(e: Extent) -> str:
    """
    >>> bytes_of(Extent(2) + Extent(0, (extent.Term(3, "body.points"),)))
    '2 + body.points * 3'
    """
    counted = [_path(t.counter) + (f" * {t.size}" if t.size > 1 else "") for t in e.terms]
    return " + ".join([*([str(e.fixed)] if e.fixed or not counted else []), *counted])


def _path(words: str) -> str:
    return ".".join(map(member, words.split(".")))


# --------------------------------------------------------------------------- counts


def count_condition(p: m.Parameter, record: m.Record) -> str:
    """Writes the condition for a count: the elements fit into the rest of the data and into a field."""
    after = record.parameters[record.parameters.index(p) + 1 :]
    at = next(i for i, q in enumerate(after) if q.name == p.counts)
    array, before = after[at], least(after[:at])
    each, between = extent.item_size(array), bytes_of(before)
    needed = f"_ * {each}" if each > 1 else "_"
    if before == Extent():
        return f"_ <= {array.capacity} and {needed} <= _io.size - _io.pos"
    fits = f"_ <= {array.capacity} and {needed} + {between} <= _io.size - _io.pos"
    # Data that ends before the array is a different error, which occurs when reading continues.
    return f"_io.size - _io.pos < {between} or ({fits})"


@dataclass(frozen=True, slots=True)
class Rest:
    """The number of elements of an array that reaches to the end of the data. It is an instance, computed once, because
    some languages evaluate the expression of a repetition again for every element."""

    name: str
    array: str
    each: int


def rests(record: m.Record) -> list[Rest]:
    return [
        Rest(f"{member(p.name)}_count", p.name, extent.item_size(p))
        for p in record.parameters
        if p.kind == "array" and p.fills
    ]


# --------------------------------------------------------------------------- presence


@dataclass(frozen=True, slots=True)
class Peek:
    """The tag of a union in a structure. It is read first, because it determines whether the structure is complete."""

    name: str
    place: Extent
    tag: m.Parameter

    @property
    def at(self) -> str:
        return bytes_of(self.place)

    @property
    def end(self) -> str:
        return bytes_of(self.place + least([self.tag]))


def presence_condition(group: m.Group, f: m.Field) -> str:
    """Writes the condition for the parameters of a group to be present; empty if they always are."""
    required = [c.function for c in f.calls if len(c.required) >= group.last]
    if required == [None]:
        return ""
    functions = [f"{member('function')} == function_selector::{value(x.name)}" for x in required if x is not None]
    room = " and ".join(_room(group, f, []))
    return " or ".join([*functions, f"({room})" if functions and " and " in room else room])


def peeks(record: m.Record) -> list[Peek]:
    """Returns the tags that `presence_condition` reads ahead."""
    ahead: list[Peek] = []
    for group in record.groups:
        if isinstance(record, m.Field) and presence_condition(group, record):
            list(_room(group, record, ahead))
    return ahead


def _room(group: m.Group, f: m.Field, peeks: list[Peek]) -> Iterator[str]:
    """Yields the conditions under which a group that no function requires is present: the data contains all of it, and
    it is not empty.

    Array elements are not checked, because a count that is too large is a different error.
    """
    begin = least(f.parameters[: f.parameters.index(group.parameters[0])])
    if begin.terms:  # the counters must be present first
        yield f"_io.size >= {begin.fixed}"
    at = begin
    for p in group.parameters:
        if p.union:
            yield f"_io.size > {bytes_of(at)}"
            whole = [
                f"({tag} and {' and '.join(inside)})" for tag, inside in _cases(p.union, member(p.union.tag), at, peeks)
            ]
            yield f"({' or '.join(whole)})" if whole else "false"
            return
        if p.struct:
            yield from _whole(p, at, peeks)
        at += _head(p)
    yield f"_io.size {'>' if at == begin else '>='} {bytes_of(at)}"


def _head(p: m.Parameter) -> Extent:
    return Extent() if p.open else least([p])


def _cases(union: m.Union, tag: str, at: Extent, peeks: list[Peek]) -> Iterator[tuple[str, list[str]]]:
    """Yields, for each case with data, the condition that selects it and the conditions for its data to be complete."""
    for c in union.cases:
        if c.parameter is not None:
            yield f"{tag} == {type_name(union.type)}::{value(c.tag.name)}", list(_whole(c.parameter, at, peeks))


def _whole(p: m.Parameter, at: Extent, peeks: list[Peek]) -> Iterator[str]:
    """Yields the conditions for a parameter at this offset to fit into the data."""
    if not p.struct:
        yield f"_io.size >= {bytes_of(at + _head(p))}"
        return
    places: dict[str, tuple[Extent, m.Parameter]] = {}
    for q in p.struct.parameters:
        if q.union:
            yield f"_io.size >= {bytes_of(at)}"
            peek = Peek(f"{member(p.name)}_{member(q.union.tag)}", *places[q.union.tag])
            peeks.append(peek)
            for tag, inside in _cases(q.union, peek.name, at, peeks):
                yield f"(not ({tag}) or ({' and '.join(inside)}))"
            return
        places[q.name] = at, q
        at += _head(q)
    yield f"_io.size >= {bytes_of(at)}"


# --------------------------------------------------------------------------- layouts


def kind(model: m.Model) -> str:
    """Writes the number of a descriptor in `kinds`, where acknowledge and shared fields have one number for many
    sets."""
    ack = model.protocol.acknowledge.descriptor
    numbers = {f.descriptor for f in model.fields if f.everywhere}
    every = ((o.set, f.descriptor) for f in model.fields if not f.everywhere for o in f.occurrences)
    own = sorted({(s, d) for s, d in every if s in m.DATA_SETS and d in numbers})
    terms = [f"set < 0x80 and descriptor == {ack:#04x} ? {ack:#06x}"]
    if numbers:
        but = "".join(f" and not (set == {s:#04x} and descriptor == {d:#04x})" for s, d in own)
        inside = f"descriptor >= {min(numbers):#04x} and descriptor <= {max(numbers):#04x}"
        terms.append(f"set >= 0x80 and {inside}{but} ? {m.SHARED_SET << 8:#06x} | descriptor")
    return " : ".join([*terms, "set << 8 | descriptor"])


@dataclass(frozen=True, slots=True)
class Layouts:
    """The expressions that distinguish the layouts of one descriptor."""

    bytes: tuple[int, ...]  # offsets of the bytes of constants; data may end inside a constant
    fits: tuple[str, ...]  # for each layout: the constants do not contradict it
    number: str  # the index of the layout that fits the data, -1 if none does


def layouts(fields: Sequence[m.Field]) -> Layouts:
    constants = [{at + i: byte for at, constant in f.signature for i, byte in enumerate(constant)} for f in fields]
    fits = [
        " and ".join(f"(_io.size <= {at} or byte_{at} == {byte:#04x})" for at, byte in sorted(c.items())) or "true"
        for c in constants
    ]
    order = sorted(range(len(fields)), key=lambda i: fields[i].min_size)
    longest = sorted(range(len(fields)), key=lambda i: -fields[i].min_size)
    whole = [f"fits_{i} and _io.size >= {fields[i].min_size} ? {i}" for i in longest]
    part = [f"fits_{i} ? {i}" for i in order]
    return Layouts(tuple(sorted({at for c in constants for at in c})), tuple(fits), " : ".join([*whole, *part, "-1"]))


# --------------------------------------------------------------------------- bitfields


@dataclass(frozen=True, slots=True)
class Segment:
    """Bits that are read together: named ones, or unused ones between them."""

    name: str
    first: int
    width: int
    bits: m.Bits | None


#: The attribute that contains all bits of a bitfield as a number.
NUMBER = "number"


def segments(t: m.Bitfield) -> list[Segment]:
    """Returns all bits of a bitfield in the order in which they are read: the most significant first in a number, the
    least significant first in bytes."""
    parts, at = [], 0
    for b in sorted((b for b in t.bits if not b.alias), key=lambda b: b.first):
        parts += [*_unused(at, b.first), Segment(member(b.name), b.first, b.width, b)]
        at = b.last + 1
    parts += _unused(at, t.width)
    return parts if t.scalar is None else parts[::-1]


def _unused(first: int, end: int) -> Iterator[Segment]:
    while first < end:
        width = min(end - first, 32)  # JavaScript reads no more at once
        yield Segment(f"unused_{first}", first, width, None)
        first += width


def bits_as_number(t: m.Bitfield) -> str:
    """Writes all bits of a bitfield as one number."""
    return _together(t, 0, t.width - 1)


def alias(b: m.Bits, t: m.Bitfield) -> str:
    """Writes an alias: a number whose bits also have other names."""
    return _together(t, b.first, b.last)


def _together(t: m.Bitfield, first: int, last: int) -> str:
    """Writes bits as a number. It multiplies, because a shift would make 32-bit numbers negative in some languages."""
    terms = []
    for s in sorted(segments(t), key=lambda s: s.first):
        low, high = max(s.first, first), min(s.first + s.width, last + 1)
        if low >= high:
            continue
        if s.width == 1 and not (s.bits and s.bits.enum):
            term = f"({s.name} ? {1 << (low - first)} : 0)" if last > first else s.name
        else:
            value = f"{s.name}.to_i" if s.bits and s.bits.enum else s.name
            term = f"({value} >> {low - s.first})" if low > s.first else value
            term = f"({term} & {(1 << (high - low)) - 1})" if high < s.first + s.width else term
            term = f"({term} * {1 << (low - first)})" if low > first else term
        terms.append(term)
    return " + ".join(terms)
