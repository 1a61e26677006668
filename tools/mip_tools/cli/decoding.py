"""Decodes the fields of a packet: the values, or the reason why there are none."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from ..binding import DecodeError, Field, Packet, PacketError, RawField, chosen, registry


class Found(NamedTuple):
    """A field of a packet. `value` is None if there is an `error`, or if the descriptor is unknown."""

    raw: RawField
    kind: type[Field] | None
    value: Field | None
    trailing: int = 0
    error: str = ""


def raw_fields(packet: Packet) -> Iterator[RawField]:
    """Yields the fields up to the first malformed one."""
    try:
        yield from packet
    except PacketError:
        return


def malformed(packet: Packet) -> str:
    """Describes the first malformed field of a packet; empty if there is none."""
    try:
        for _ in packet:
            pass
    except PacketError as error:
        return error.detail
    return ""


def decoded(raw: RawField) -> Found:
    """Decodes a field."""
    types = registry.types(raw.set, raw.descriptor)
    kind = chosen(types, raw)
    if kind is None:
        return Found(raw, None, None, error="no known layout fits its data" if types else "")
    try:
        value, trailing = kind.decode_with_trailing(raw.data)
    except DecodeError as error:
        return Found(raw, kind, None, error=error.detail)
    return Found(raw, kind, value, trailing)


def name_of(found: Found) -> str:
    """Returns the name of a field, or its numbers if it is unknown."""
    if found.kind is not None:
        return found.kind.name_in(found.raw.set)
    return f"0x{found.raw.set:02X}:0x{found.raw.descriptor:02X}"


__all__ = ["Found", "decoded", "malformed", "name_of", "raw_fields"]
