"""Decodes the fields of a packet: the values, or the reason why there are none."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from ..binding import DecodeError, Field, Packet, PacketError, RawField, chosen, registry


class DecodedField(NamedTuple):
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


def decoded_field(raw: RawField) -> DecodedField:
    """Decodes a field."""
    types = registry.types(raw.set, raw.descriptor)
    kind = chosen(types, raw)
    if kind is None:
        return DecodedField(raw, None, None, error="no known layout fits its data" if types else "")
    try:
        value, trailing = kind.decode_with_trailing(raw.data)
    except DecodeError as error:
        return DecodedField(raw, kind, None, error=error.detail)
    return DecodedField(raw, kind, value, trailing)


def name_of(field: DecodedField) -> str:
    """Returns the name of a field, or its numbers if it is unknown."""
    if field.kind is not None:
        return field.kind.name_in(field.raw.set)
    return f"0x{field.raw.set:02X}:0x{field.raw.descriptor:02X}"
