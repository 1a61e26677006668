"""Numbers that stand for sets, fields and instances, and their words in a file."""

from __future__ import annotations

from functools import cache

from ..binding import SETS, Device, Parameter, registry
from .settings import named

SHARED = 0xFF


def word(p: Parameter, number: int, set: int | None, profile: Device) -> str:
    """The word for a number: the name of a value, of a set or of a field of this set, else the number itself."""
    values = named(p, profile)
    if not values and p.refers == "set":
        return SETS[number][0] if number in SETS else f"0x{number:02X}"
    if p.refers == "field":
        names = {descriptor: name for name, descriptor in fields(set).items()}
        return names.get(number, f"0x{number:02X}")
    return values.get(number, str(number))


def numbers(p: Parameter, set: int | None, profile: Device) -> dict[str, int]:
    """The words that a parameter may have, with their numbers."""
    values = named(p, profile)
    if not values and p.refers == "set":
        return {name: number for number, names in SETS.items() for name in names}
    if p.refers == "field":
        return fields(set)
    return {name: number for number, name in values.items()}


@cache
def fields(set: int | None) -> dict[str, int]:
    """The data fields of a set, and the shared ones, by their names without that of the set."""
    found: dict[str, int] = {}
    for number, kind in registry.all_types():
        if kind.ROLE == "data" and number in (SHARED, set):
            found.setdefault(kind.name_in(number).partition(".")[2], kind.DESCRIPTOR)
    return found


__all__ = ["fields", "numbers", "word"]
