"""Decodes the fields of a stream to objects, with their times."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from ..binding import REACH, Field, Packet, Structure, chosen, info, registry
from ..occurrence import Occurrence, of
from .clocks import CLOCKS, moments
from .decoding import decoded, raw_fields
from .scan import Piece
from .selection import Selection


class Sample(NamedTuple):
    """A field of a log, with its packet and its time."""

    packet: int
    offset: int
    time: int | None
    own: bool
    kind: Occurrence
    value: Field


# --------------------------------------------------------------------------- what is in a log


def survey(pieces: Iterable[Piece | None], selection: Selection) -> tuple[list[Occurrence], str | None]:
    """Finds the types of the selected fields in a log, in the order of their numbers, and its best clock."""
    first: dict[Occurrence, tuple[int, int]] = {}
    single: set[tuple[int, int]] = set()  # fields with one layout that have been found
    clocks: set[str] = set()
    for piece in pieces:
        if piece is None or piece.packet is None:
            continue
        if next(iter(CLOCKS), None) not in clocks:
            said = moments(piece.packet)
            clocks.update(clock for clock, time in said.items() if time is not None)
        for raw in raw_fields(piece.packet):
            key = (raw.set, raw.descriptor)
            if key in single or not selection.has(*key):
                continue
            types = registry.types(*key)
            kind = chosen(types, raw)
            if kind is not None and decoded(raw).value is not None:
                first.setdefault(of(raw.set, kind), key)
                if len(types) == 1:
                    single.add(key)
    best = next((clock for clock in CLOCKS if clock in clocks), None)
    return sorted(first, key=lambda kind: first[kind]), best


class Timeline:
    """Finds the time of each packet: the one in the packet, else the last one of its set."""

    def __init__(self, clock: str | None) -> None:
        self._clock = clock
        self._last: dict[int, tuple[int | None, int]] = {}

    def at(self, packet: Packet, offset: int) -> tuple[int | None, bool]:
        """Returns the time, None if it is unknown or not valid, and whether it is in the packet itself."""
        if self._clock is None:
            return None, False
        own = moments(packet)
        if self._clock in own:
            self._last[packet.set] = own[self._clock], offset
            return own[self._clock], True
        time, place = self._last.get(packet.set, (None, offset))
        return (time if offset - place <= REACH else None), False


def samples(
    pieces: Iterable[Piece], wanted: Sequence[Occurrence] | None, selection: Selection, clock: str | None
) -> Iterator[list[Sample]]:
    """Yields the selected fields of these types (None: all), in a list for each packet."""
    line = Timeline(clock)
    number = -1
    selected = None if wanted is None else set(wanted)
    keys: dict[tuple[int, int], bool] = {}
    for piece in pieces:
        if piece.packet is None:
            continue
        number += 1
        time, own = line.at(piece.packet, piece.offset)
        row = []
        for raw in raw_fields(piece.packet):
            key = (raw.set, raw.descriptor)
            asked = keys.get(key)
            if asked is None:
                asked = selected is None or any(of(raw.set, t) in selected for t in registry.types(*key))
                asked = keys[key] = asked and selection.has(*key)
            if asked:
                field = decoded(raw)
                if field.value is None or field.kind is None:
                    continue
                one = of(raw.set, field.kind)
                if selected is None or one in selected:
                    row.append(Sample(number, piece.offset, time, own, one, field.value))
        if row:
            yield row


def kept(packets: Iterator[list[Sample]], invalid: str) -> Iterator[list[Sample]]:
    """Drops fields that have an invalid value, if `invalid` is "drop"."""
    if invalid != "drop":
        return packets
    return (left for p in packets if (left := [s for s in p if valid(s.value)]))


def valid(record: Structure) -> bool:
    """Are all values of a record valid according to its flags?"""
    for p in info(type(record)).parameters:
        for flag in p.flags:
            bits = getattr(record, flag.attribute)
            if bits is None or not flag.holds(bits):
                return False
        if p.kind == "struct" and not valid(getattr(record, p.attribute)):
            return False
    return True


__all__ = ["Sample", "kept", "samples", "survey", "valid"]
