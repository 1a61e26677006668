"""Finds the numbers for names in the specification."""

from __future__ import annotations

from enum import IntEnum, IntFlag
from functools import cache
from typing import Any


def value_named(kind: Any, names: tuple[str, ...]) -> int:
    """Returns the first value with one of these names in an enumeration, or all bits with these names in a bitfield.

    `bits.value` names a value of a multi-bit field in a bitfield. Names that the type does not have are ignored.
    """
    return _named(kind, names)


@cache
def _named(kind: Any, names: tuple[str, ...]) -> int:
    if not isinstance(kind, type) or not issubclass(kind, (IntEnum, IntFlag)):
        return 0
    members = kind.__members__
    if issubclass(kind, IntEnum):
        return next((int(members[n.upper()]) for n in names if n.upper() in members), 0)
    number = 0
    for name in names:
        bits, _, inner = name.partition(".")
        if bits.upper() not in members:
            continue
        mask = int(members[bits.upper()])
        if inner:
            numbers: Any = type(getattr(kind(mask), bits))
            number |= value_named(numbers, (inner,)) * (mask & -mask)
        else:
            number |= mask
    return number
