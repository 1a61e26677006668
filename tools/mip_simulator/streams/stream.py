"""Sends streams at the base rate divided by decimations, and combines fields to packets."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any

from mip_tools.binding import MAX_PAYLOAD, PacketBuilder, RawField
from mip_tools.geometry.earth import SECOND

#: Descriptors of shared fields, which are repeated in continuation packets.
SHARED = 0xD0


class Stream:
    """Items that are sent at a base rate, each with its decimation. Ticks count from power-up, without drift."""

    def __init__(
        self, rate: float, items: Sequence[tuple[int, Any]], fire: Callable[[list[Any]], None], origin: int, now: int
    ) -> None:
        self._numerator, self._denominator = float(rate).as_integer_ratio()
        self._items = items
        self._decimations = sorted({decimation for decimation, _ in items})
        self._fire = fire
        self._origin = origin
        self._tick = (now - origin) * self._numerator // (SECOND * self._denominator)
        self._every = [item for _, item in items] if len(self._decimations) == 1 else None
        self._advance()

    def _advance(self) -> None:
        tick = self._tick
        self._tick = min(d * (tick // d + 1) for d in self._decimations)
        # Rounded up: a stream that starts at the time of a tick continues with the next one.
        self.next = self._origin - -self._tick * SECOND * self._denominator // self._numerator

    def skip(self, until: int) -> None:
        """Sends nothing until this time."""
        while self.next < until:
            self._tick = max(self._tick, (until - self._origin) * self._numerator // (SECOND * self._denominator) - 1)
            self._advance()

    def fire(self) -> None:
        """Sends the items that are due now."""
        due = self._every
        if due is None:
            due = [item for decimation, item in self._items if self._tick % decimation == 0]
        self._fire(due)
        self._advance()


def combined_fields(set_number: int, fields: Iterable[RawField]) -> list[bytes]:
    """Combines fields to as few packets as their order permits; shared fields at the front are repeated in each."""
    packets: list[bytes] = []
    front: list[RawField] = []
    builder, size, leading = PacketBuilder(set_number), 0, True
    for field in fields:
        more = len(field.data) + 2
        if size + more > MAX_PAYLOAD:
            packets.append(bytes(builder.build()))
            builder, size = PacketBuilder(set_number), 0
            room = MAX_PAYLOAD - more
            for shared in front if sum(len(s.data) + 2 for s in front) <= room else ():
                builder.add(shared.descriptor, shared.data)
                size += len(shared.data) + 2
        if leading and field.descriptor >= SHARED:
            front.append(field)
        else:
            leading = False
        builder.add(field.descriptor, field.data)
        size += more
    packets.append(bytes(builder.build()))
    return packets


def combined_answers(set_number: int, groups: Iterable[Sequence[RawField]]) -> list[bytes]:
    """Combines answers to as few packets as possible; an acknowledge is never separated from its response."""
    packets: list[bytes] = []
    builder, size = PacketBuilder(set_number), 0
    for group in groups:
        more = sum(len(f.data) + 2 for f in group)
        if size and size + more > MAX_PAYLOAD:
            packets.append(bytes(builder.build()))
            builder, size = PacketBuilder(set_number), 0
        for field in group:
            builder.add(field.descriptor, field.data)
        size += more
    if size:
        packets.append(bytes(builder.build()))
    return packets
