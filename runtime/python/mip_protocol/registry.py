"""Finds the type of any field. Sets are imported on first use."""

from __future__ import annotations

from functools import cache
from importlib import import_module

from ._sets import MODULES as MODULES
from .field import Field, chosen
from .layouts import Layouts
from .packet import Packet, RawField
from .protocol import Acknowledge

SHARED_SET = 0xFF


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
    from .lookup import field

    return field(name)


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
    return list(LAYOUTS.decode(packet))


#: Decodes whole packets, and keeps the functions compiled for their layouts.
LAYOUTS = Layouts(types)
