"""Combines what a device has measured at one time and sent in several packets.

A message that does not fit into one packet continues in further packets of the same set. The shared
fields at its front, such as a timestamp, are repeated in each of them.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from typing import Generic, Protocol, TypeAlias, TypeVar

from ._clocks import TIMESTAMPS
from .packet import MAX_PAYLOAD, Packet, RawField

#: The set of the fields that all data sets share, their first descriptor, and those that contain a time.
SHARED = 0xFF
FIRST_SHARED = 0xD0
TIMES = frozenset(descriptor for number, descriptor in TIMESTAMPS if number == SHARED)
#: A list ends with this many packets, so that a clock that stands still takes no memory.
MOST = 256


class HasPacket(Protocol):
    """An object with a packet, such as an `Arrival`."""

    @property
    def packet(self) -> Packet: ...


P = TypeVar("P", bound="Packet | HasPacket")
_Fields: TypeAlias = tuple[RawField, ...]


@dataclass
class _Group(Generic[P]):
    """The packets of one set that belong together, as far as they have arrived."""

    shared: _Fields
    items: list[P] = field(default_factory=list)
    own: set[int] = field(default_factory=set)  # descriptors that are not shared
    last: int = -1  # the last of them
    room: int = 0  # in the last packet


class Samples(Generic[P]):
    """Takes packets as they arrive and returns those that belong together, as lists.

    A packet belongs to the one of its set before it if the shared fields at their front are the
    same, its own fields have not arrived yet, and either the shared fields contain a time or its first
    field had no room in the packet before. A list of several fields of one descriptor may also
    continue. A packet of commands is a list of its own.
    """

    def __init__(self) -> None:
        self._groups: dict[int, _Group[P]] = {}

    def add(self, item: P) -> list[list[P]]:
        """A packet, or an object with a `packet`; returns what is complete now.

        A list is complete when the next one of its set begins, because more could follow.
        """
        packet = item if isinstance(item, Packet) else item.packet
        if packet.set < 0x80:
            return [[item]]
        shared, own = _parts(packet)
        group = self._groups.get(packet.set)
        complete: list[list[P]] = []
        if group is None or not _continues(group, shared, own):
            if group is not None:
                complete.append(group.items)
            group = self._groups[packet.set] = _Group(shared)
        group.items.append(item)
        group.own.update(raw.descriptor for raw in own)
        group.last = own[-1].descriptor if own else -1
        group.room = MAX_PAYLOAD - len(packet.payload)
        return complete

    def flush(self) -> list[list[P]]:
        """The packets that have not been returned yet, for example at the end of a log."""
        complete = [group.items for group in self._groups.values()]
        self._groups.clear()
        return complete


def samples(packets: Iterable[P]) -> Iterator[list[P]]:
    """The packets, or objects with a `packet`, that belong together; see `Samples`."""
    together: Samples[P] = Samples()
    for packet in packets:
        yield from together.add(packet)
    yield from together.flush()


def _parts(packet: Packet) -> tuple[_Fields, _Fields]:
    """The shared fields at the front, and the fields after them up to a malformed one."""
    fields = packet.fields
    count = next((i for i, f in enumerate(fields) if f.descriptor < FIRST_SHARED), len(fields))
    return fields[:count], fields[count:]


def _continues(group: _Group[P], shared: _Fields, own: _Fields) -> bool:
    if not own or shared != group.shared or len(group.items) >= MOST:
        return False
    first = own[0]
    full = len(first.data) + 2 > group.room
    new = first.descriptor not in group.own
    timed = any(raw.descriptor in TIMES for raw in shared)
    return (new or (full and first.descriptor == group.last)) and (full or timed)
