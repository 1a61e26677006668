"""Converts values to names, numbers and text."""

from __future__ import annotations

from collections.abc import Iterable
from enum import IntEnum, IntFlag
from functools import lru_cache
from math import isfinite
from struct import pack
from typing import Any

from .described import description


def several(value: object) -> bool:
    return hasattr(value, "__len__") and not isinstance(value, (str, bytes, int))


@lru_cache(maxsize=256)
def names_of(kind: type[IntEnum]) -> dict[int, str]:
    """Returns a table: value -> its name."""
    return {v.value: v.name for v in description(kind).values}


@lru_cache(maxsize=256)
def bits_of(kind: type[IntFlag]) -> tuple[tuple[tuple[str, int, int, Any], ...], int]:
    """Returns name, mask, first bit and enumeration of a bitfield's numbers, and all masks."""
    rows = [(b.name, b.mask, b.first, b.type) for b in description(kind).bits if not b.alias]
    return tuple(rows), sum(mask for _, mask, _, _ in rows)


@lru_cache(maxsize=256)
def _states(kind: type[IntFlag]) -> dict[str, tuple[str, tuple[int, ...]]]:
    """Returns the bits that mean something in some states only, with these."""
    return {b.name: b.state for b in description(kind).bits if b.state}


def bits_in(value: IntFlag, holder: object) -> tuple[str, ...]:
    """Returns the names of the bits that are set, in the state that an object contains."""
    states = _states(type(value))
    if not states or not any(hasattr(holder, attribute) for attribute, _ in states.values()):
        return bits_set(type(value), int(value))
    here = {
        name
        for name, (attribute, numbers) in states.items()
        if getattr(holder, attribute, None) in numbers
    }
    return bits_set(type(value), int(value), frozenset(here))


@lru_cache(maxsize=1024)
def bits_set(
    kind: type[IntFlag], value: int, state: frozenset[str] | None = None
) -> tuple[str, ...]:
    """Returns the names of the bits that are set, and all numbers of several bits, even if 0.

    `state`: of the bits that depend on a state, those that mean something in the current one.
    """
    rows, every = bits_of(kind)
    if state is not None:
        bits = description(kind).bits
        shown = [b for b in bits if b.name in state or (b.state is None and not b.alias)]
        rows = tuple((b.name, b.mask, b.first, b.type) for b in shown)
        every = sum({mask for _, mask, _, _ in rows})
    words = []
    for name, mask, first, type in rows:
        number = (value & mask) >> first
        if mask >> first != 1:
            words.append(f"{name}={names_of(type).get(number, number) if type else number}")
        elif number:
            words.append(name)
    rest = value & ~every
    return (*words, f"0x{rest:X}") if rest else tuple(words)


def json_value(value: Any, names: bool, json: bool, holder: object = None) -> Any:
    """Converts one value to JSON's types; a member of an enumeration or bitfield, to its names."""
    if names and isinstance(value, IntEnum):
        return names_of(type(value)).get(int(value), int(value))
    if names and isinstance(value, IntFlag):
        return list(bits_in(value, holder))
    return number(value, json)


def number(value: Any, json: bool) -> Any:
    if isinstance(value, float):
        return float(value) if isfinite(value) or not json else None
    return value if isinstance(value, (bool, str)) or not isinstance(value, int) else int(value)


def word(value: Any, single: bool, holder: object = None) -> str:
    """Formats one value. `single`: a float has four bytes."""
    match value:
        case IntEnum():
            return names_of(type(value)).get(int(value), str(int(value)))
        case IntFlag():
            return "|".join(bits_in(value, holder)) or "0"
        case bool():
            return "true" if value else "false"
        case str():
            return repr(value.strip("\0 "))
        case float() if single:
            return shortest(value)
        case int():
            return str(int(value))
    return repr(value)


def with_unit(text: str, units: tuple[str, ...]) -> str:
    return f"{text} {units[0]}" if units and units[0] not in ("", "1") else text


def listed(texts: Iterable[str]) -> str:
    return f"[{', '.join(texts)}]"


def shortest(value: float) -> str:
    """Returns the shortest text that denotes a four-byte float.

    >>> shortest(0.10000000149011612)
    '0.1'
    """
    try:
        wanted = pack(">f", value)
    except OverflowError:
        return repr(value)
    if not isfinite(value):
        return repr(value)
    for digits in (6, 7, 8):
        text = f"{value:.{digits}g}"
        if pack(">f", float(text)) == wanted:
            return repr(float(text))
    return repr(float(f"{value:.9g}"))
