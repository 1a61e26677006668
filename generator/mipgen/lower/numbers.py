"""Conversion of named values to numbers."""

from __future__ import annotations

from mipgen import model as m


def in_numbers(value: object, element: m.Scalar | m.Enum | m.Bitfield | m.Vector | m.Struct | None) -> object:
    """Converts a checked default: names of values and bits become numbers, lists become tuples."""
    if isinstance(element, m.Enum) and isinstance(value, str):
        member = element.by_name(value)
        return member.value if member else 0
    if isinstance(element, m.Bitfield) and isinstance(value, list) and all(isinstance(x, str) for x in value):
        return sum({b.name: b.mask for b in element.bits}.get(str(x), 0) for x in value)
    return tuple(in_numbers(x, element) for x in value) if isinstance(value, list) else value
