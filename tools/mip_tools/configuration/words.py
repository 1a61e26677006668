"""Translates the numbers of sets, fields and instances to their names in a file, and back."""

from __future__ import annotations

from functools import cache

from ..binding import SETS, Device, Parameter, registry
from .settings import value_names

SHARED = 0xFF


def name_for(p: Parameter, number: int, set_number: int | None, profile: Device) -> str:
    """Returns the name for a number: a value, a set or a field in this set; the number itself if it has no name."""
    values = value_names(p, profile)
    if not values and p.refers == "set":
        return SETS[number][0] if number in SETS else f"0x{number:02X}"
    if p.refers == "field":
        names = {descriptor: name for name, descriptor in data_fields(set_number).items()}
        return names.get(number, f"0x{number:02X}")
    return values.get(number, str(number))


def accepted_names(p: Parameter, set_number: int | None, profile: Device) -> dict[str, int]:
    """Returns the names that a parameter accepts, with their numbers."""
    values = value_names(p, profile)
    if not values and p.refers == "set":
        return {name: number for number, names in SETS.items() for name in names}
    if p.refers == "field":
        return data_fields(set_number)
    return {name: number for number, name in values.items()}


@cache
def data_fields(set_number: int | None) -> dict[str, int]:
    """Returns the data fields of a set and the shared ones, by name without the set."""
    descriptors: dict[str, int] = {}
    for number, kind in registry.all_types():
        if kind.ROLE == "data" and number in (SHARED, set_number):
            descriptors.setdefault(kind.name_in(number).partition(".")[2], kind.DESCRIPTOR)
    return descriptors
