"""Groups the packets of one message: data of one time that a device has sent in several packets.

A message that does not fit into one packet continues in further packets of the same set. Each
repeats the shared fields at the front, such as a timestamp.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from typing import Generic, Protocol, TypeAlias, TypeVar

from ._clocks import TIMESTAMPS
from .packet import MAX_PAYLOAD, Packet, RawField

#: The set of the fields that all data sets share, their lowest descriptor, and the descriptors of
#: those that contain a time.
SHARED = 0xFF
FIRST_SHARED = 0xD0
TIMES = frozenset(descriptor for number, descriptor in TIMESTAMPS if number == SHARED)
#: A list ends with this many packets, so that a clock that stops does not make it grow forever.
MOST = 256


class HasPacket(Protocol):
    """An object with a packet, such as an `Arrival`."""

    @property
    def packet(self) -> Packet: ...


P = TypeVar("P", bound="Packet | HasPacket")
_Fields: TypeAlias = tuple[RawField, ...]


@dataclass
class _Group(Generic[P]):
    """The packets of one set's current message that have arrived so far."""

    shared: _Fields
    items: list[P] = field(default_factory=list)
    own: set[int] = field(default_factory=set)  # descriptors of fields that are not shared
    last: int = -1  # descriptor of the last field that is not shared
    room: int = 0  # bytes left in the last packet


class Samples(Generic[P]):
    """Accepts packets as they arrive and returns those that belong together, as lists.

    A packet continues the previous one of its set if both begin with the same shared fields, its
    first other field has a descriptor that the list does not contain yet, and either the shared
    fields contain a time or that field had no room in the previous packet. A field that had no room
    may also repeat the last descriptor. A packet of commands is always a list of its own.
    """

    def __init__(self) -> None:
        self._groups: dict[int, _Group[P]] = {}

    def add(self, item: P) -> list[list[P]]:
        """Adds a packet, or an object with a `packet`; returns the lists that are now complete.

        A list is complete only when the next one of its set begins, because more could follow.
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
        """Returns the packets that have not been returned yet, for example at the end of a log."""
        complete = [group.items for group in self._groups.values()]
        self._groups.clear()
        return complete


def samples(packets: Iterable[P]) -> Iterator[list[P]]:
    """Yields lists of the packets, or objects with one, that belong together; see `Samples`."""
    together: Samples[P] = Samples()
    for packet in packets:
        yield from together.add(packet)
    yield from together.flush()


def _parts(packet: Packet) -> tuple[_Fields, _Fields]:
    """Splits a packet's fields into the shared ones at the front and the others."""
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
