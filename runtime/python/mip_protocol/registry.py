"""Finds the type of any field. Sets are imported on first use."""

from __future__ import annotations

from functools import cache
from importlib import import_module
from typing import Any

from ._sets import MODULES as MODULES
from .exceptions import DecodeError
from .field import Field, Shared, chosen
from .packet import Packet, RawField, Undecoded
from .protocol import Acknowledge

SHARED_SET = 0xFF
#: The fields of a packet.
Fields = tuple["Field | RawField", ...]


@cache
def types(set: int, descriptor: int) -> tuple[type[Field], ...]:
    """Returns the types of a descriptor in packets of a set; empty if it is unknown.

    If there are several, constants in the data or the data's size distinguish them.
    """
    own = _in_set(set, descriptor)
    everywhere: list[type[Field]] = [Acknowledge, *_fields(SHARED_SET).get(descriptor, ())]
    return own or tuple(t for t in everywhere if t.DESCRIPTOR == descriptor and set in t.SETS)


def _in_set(set: int, descriptor: int) -> tuple[type[Field], ...]:
    return tuple(t for t in _fields(set).get(descriptor, ()) if set in t.SETS or set == SHARED_SET)


@cache
def _fields(set: int) -> dict[int, tuple[type[Field], ...]]:
    name = MODULES.get(set)
    if name is None:
        return {}
    fields: dict[int, tuple[type[Field], ...]] = import_module(f".{name}", __package__).FIELDS
    return fields


def by_name(name: str) -> type[Field]:
    """Finds the type of a field: by its full name ("sensor.scaled_accel"), class name
    ("sensor.ScaledAccel"), title, descriptors ("0x80,0x04") or the vendor's name.

    The set's name may be left out if the rest is unambiguous. Raises UnknownName, which lists the
    nearest names.
    """
    from .lookup import descriptors, field_home

    numbers = descriptors(name)
    module, kind = field_home(name, [t.NAME for t in types(*numbers)] if numbers else None)
    field_type: type[Field] = getattr(import_module(f".{module}", __package__), kind)
    return field_type


def set_by_name(name: str) -> int:
    """Finds the number of a descriptor set by its name ("sensor", "3dm"), title or number ("0x80").
    Raises UnknownName."""
    from .lookup import set_number

    return set_number(name)


def names() -> tuple[str, ...]:
    """Returns the full names of all fields, by set, without importing the sets."""
    from ._index import FIELDS

    return tuple(FIELDS)


def all_types() -> list[tuple[int, type[Field]]]:
    """Returns every (set, type) of the specification, in order."""
    types: list[tuple[int, type[Field]]] = [(0, Acknowledge)]
    for number in MODULES:
        for descriptor in _fields(number):
            types += [(number, t) for t in _in_set(number, descriptor)]
    return types


def decode(raw: RawField) -> Field | None:
    """Decodes a field; returns None if its descriptor is unknown. Raises DecodeError."""
    kind = chosen(types(raw.set, raw.descriptor), raw)
    return None if kind is None else kind._received(raw)


def decode_packet(packet: Packet) -> list[Field | RawField]:
    """Decodes all fields of a packet; those that are unknown or cannot be decoded stay raw.

    A raw field's `error` is the reason why it cannot be decoded. Decoding stops at a malformed
    field, because no field can be found after it; see `Packet.malformed`.
    """
    data = bytes(packet)
    return list(decode_bytes(data, 0, len(data)))


def decode_field(raw: RawField) -> Field | RawField:
    """Decodes a field; one that is unknown or cannot be decoded stays raw."""
    try:
        return decode(raw) or raw
    except DecodeError as error:
        return Undecoded.because(raw, error)


#: A class whose fields consist of plain numbers, the function that reads one, its size with the
#: header, whether it is shared. Size 0: all others.
Plain = tuple[Any, Any, int, bool]
_OTHER: Plain = (None, None, 0, False)
#: Set -> these facts for each descriptor, once a packet of the set has been decoded.
_PLAIN: list[list[Plain]] = [[] for _ in range(256)]


def _plain(set: int) -> list[Plain]:
    facts = []
    for descriptor in range(256):
        kinds = types(set, descriptor)
        one, made = kinds[0] if len(kinds) == 1 else Field, _OTHER
        if one._SIZE:
            made = (one, one._read, one._SIZE + 2, issubclass(one, Shared))
        facts.append(made)
    _PLAIN[set] = facts
    return facts


def decode_bytes(buffer: bytes, at: int, end: int) -> Fields:
    """Decodes the fields of the packet from `at` to `end`, which has the correct checksum."""
    number = buffer[at + 2]
    plain, new = _PLAIN[number] or _plain(number), object.__new__
    at, end = at + 4, end - 2
    fields: list[Field | RawField] = []
    while at < end:
        length, descriptor = buffer[at], buffer[at + 1]
        if length > end - at or length < 2:
            break  # no field can be found after a malformed one
        kind, read, size, shared = plain[descriptor]
        if size == length:
            field = new(kind)
            at = read(field, buffer, at + 2)
            if shared:
                field._packet_set = number
            fields.append(field)
        else:
            raw = RawField(number, descriptor, buffer[at + 2 : at + length])
            fields.append(decode_field(raw))
            at += length
    return tuple(fields)
