"""The layout of records in the memory of a program in C, whatever the compiler.

A record has no constants, but it has counters and tags. A text ends with a NUL, an array that fills a field has its
number of elements before it, and a field whose parameters may be absent begins with their number.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from mipgen import model as m

#: No machine that C runs on aligns numbers more than this, so no compiler leaves more bytes unused before a member.
MAX_ALIGNMENT = 8


@dataclass(frozen=True, slots=True)
class Room:
    """The memory of a member or a record."""

    size: int
    alignment: int = 1
    last: int = 0  # offset of the last number, including those inside structures, but not the items of arrays


#: The bytes that may be unused before something that begins at some place, or ends there, and its alignment.
Gap = Callable[[int, int], int]


def natural(place: int, alignment: int) -> int:
    """Each number is aligned to its own size; elsewhere there is less padding."""
    return -place % alignment


def widest(_place: int, _alignment: int) -> int:
    """The most that any compiler may leave."""
    return MAX_ALIGNMENT - 1


def packed(_place: int, _alignment: int) -> int:
    """None."""
    return 0


def has_gaps(of: m.Field) -> bool:
    """May a structure have bytes before its last number that the field lacks: padding, or the NUL of a text?"""
    tight = record(of, packed)
    return tight.size != of.max_size or tight.last != record(of).last


def members(record: m.Record) -> list[m.Parameter]:
    """The parameters that have a member: no constants, and no unions without alternatives."""
    return [p for p in record.parameters if p.constant is None and (not p.union or p.alternatives)]


def largest(model: m.Model) -> int:
    """At least the size of the largest structure of a field, a multiple of the largest alignment."""
    sizes = [record(f).size for f in (model.protocol.acknowledge, *model.fields)]
    return max(size + natural(size, MAX_ALIGNMENT) for size in sizes)


def record(of: m.Record, gap: Gap = natural) -> Room:
    """The memory of a structure."""
    rooms = [Room(1)] if isinstance(of, m.Field) and of.optional else []
    for p in members(of):
        rooms += [Room(1)] if p.fills else []
        rooms.append(_room(p, gap))
    return _in_a_row(rooms or [Room(1)], gap)


def _room(p: m.Parameter, gap: Gap) -> Room:
    if p.struct:
        return record(p.struct, gap)
    if p.union:
        return _union([_alternative(q, gap) for q in p.alternatives], gap)
    if p.kind == "text":
        return Room(p.capacity + 1)
    if p.kind == "array":
        item = _room(p.item, gap)
        return Room(max(1, p.capacity) * (item.size + gap(item.size, item.alignment)), item.alignment)
    return Room(p.size, 1 if p.kind == "bits" else p.size)


def _alternative(p: m.Parameter, gap: Gap) -> Room:
    room = _room(p, gap)
    return _in_a_row([Room(1), room], gap) if p.fills else room


def _union(rooms: Sequence[Room], gap: Gap) -> Room:
    size, alignment = max(r.size for r in rooms), max(r.alignment for r in rooms)
    return Room(size + gap(size, alignment), alignment, max(r.last for r in rooms))


def _in_a_row(rooms: Sequence[Room], gap: Gap) -> Room:
    at = last = 0
    for room in rooms:
        at += gap(at, room.alignment)
        last = max(last, at + room.last)
        at += room.size
    alignment = max(room.alignment for room in rooms)
    return Room(at + gap(at, alignment), alignment, last)
