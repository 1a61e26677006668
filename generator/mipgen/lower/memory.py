"""The memory layout of records in C, with any compiler.

A record contains counters and tags, but no constants. A text ends with a NUL, an array that fills a field is preceded
by its number of elements, and a field whose parameters may be absent begins with the number of present ones.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from mipgen import model as m

#: The maximum alignment of a number on any machine with C, which limits the padding before a member.
MAX_ALIGNMENT = 8


@dataclass(frozen=True, slots=True)
class Room:
    """The memory of a member or a record."""

    size: int
    alignment: int = 1
    last: int = 0  # offset of the last number, including numbers inside structures, but not the items of arrays


#: Offset, alignment -> the number of padding bytes there.
Gap = Callable[[int, int], int]


def natural(place: int, alignment: int) -> int:
    """Returns the padding if each number is aligned to its own size; some machines have less."""
    return -place % alignment


def widest(_place: int, _alignment: int) -> int:
    """Returns the maximum padding of any compiler."""
    return MAX_ALIGNMENT - 1


def packed(_place: int, _alignment: int) -> int:
    """Returns 0: no padding."""
    return 0


def has_gaps(of: m.Field) -> bool:
    """True if a structure may have bytes before its last number that the field lacks: padding, or the NUL of a text."""
    tight = record_memory(of, packed)
    return tight.size != of.max_size or tight.last != record_memory(of).last


def stored(record: m.Record) -> list[m.Parameter]:
    """Returns the parameters with a member: all except constants and unions without alternatives."""
    return [p for p in record.parameters if p.constant is None and (not p.union or p.alternatives)]


def largest(model: m.Model) -> int:
    """Returns an upper bound of the size of any field's structure, a multiple of the largest alignment."""
    sizes = [record_memory(f).size for f in (model.protocol.acknowledge, *model.fields)]
    return max(size + natural(size, MAX_ALIGNMENT) for size in sizes)


def record_memory(of: m.Record, gap: Gap = natural) -> Room:
    """Computes the memory of a structure."""
    rooms = [Room(1)] if isinstance(of, m.Field) and of.optional else []
    for p in stored(of):
        rooms += [Room(1)] if p.fills else []
        rooms.append(_room(p, gap))
    return _in_a_row(rooms or [Room(1)], gap)


def _room(p: m.Parameter, gap: Gap) -> Room:
    if p.struct:
        return record_memory(p.struct, gap)
    if p.union:
        return _union([_alternative(q, gap) for q in p.alternatives], gap)
    if p.kind == "text":
        return Room(p.capacity + 1)
    if p.kind == "array":
        item = _room(p.item, gap)
        return Room(max(1, p.capacity) * (item.size + gap(item.size, item.alignment)), item.alignment)
    return Room(p.size) if p.kind == "bits" else Room(p.scalar.memory, p.scalar.memory)


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
