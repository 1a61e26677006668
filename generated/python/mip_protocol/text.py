"""Converts objects to dictionaries and to text."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from enum import IntEnum, IntFlag
from functools import lru_cache
from math import isfinite
from struct import pack
from typing import Any, NamedTuple

from .codec import with_article
from .described import Described
from .errors import EncodeError
from .parameter import Parameter

#: The differences for the members of a structure, by attribute.
Inside = dict[str, dict[str, Any]]


class Item(NamedTuple):
    """One value of an object."""

    parameter: Parameter  # as it applies to these values and this device
    value: Any
    text: str  # with its unit
    valid: bool  # according to its flags


# --------------------------------------------------------------------------- meaning


def meant(p: Parameter, value: Any) -> Any:
    """Converts a value to its parameter's enumeration or bitfield, an array item by item. Other
    values are returned unchanged.

    Raises EncodeError if the value is not a number.
    """
    kind = p.type
    if value is None or not isinstance(kind, type) or not issubclass(kind, (IntEnum, IntFlag)):
        return value
    needs = with_article(kind)
    try:
        if not _several(value):
            return kind(value)
        if p.scalar == "u8" and issubclass(kind, IntFlag) and _bits(kind)[1] > 0xFF:
            needs = "numbers from 0 to 255"
            return kind(int.from_bytes(bytes(value), "little"))  # an array of bytes holds it
        return tuple(map(kind, value))
    except (TypeError, ValueError):
        raise EncodeError("range", f"{p.attribute} is {value!r}, needs {needs}") from None


def _several(value: object) -> bool:
    return hasattr(value, "__len__") and not isinstance(value, (str, bytes, int))


@lru_cache(maxsize=256)
def _values(kind: type[IntEnum]) -> dict[int, str]:
    """Returns a table: value -> its name."""
    from .reflection import info

    return {v.value: v.name for v in info(kind).values}


@lru_cache(maxsize=256)
def _bits(kind: type[IntFlag]) -> tuple[tuple[tuple[str, int, int, Any], ...], int]:
    """Returns name, mask, first bit and enumeration of a bitfield's numbers, and all masks."""
    from .reflection import info

    rows = [(b.name, b.mask, b.first, b.type) for b in info(kind).bits if not b.alias]
    return tuple(rows), sum(mask for _, mask, _, _ in rows)


@lru_cache(maxsize=1024)
def _set_bits(kind: type[IntFlag], value: int) -> tuple[str, ...]:
    """Returns the names of the bits that are set, and all numbers of several bits, even if 0."""
    named, known = _bits(kind)
    words = []
    for name, mask, first, type in named:
        number = (value & mask) >> first
        if mask >> first != 1:
            words.append(f"{name}={_values(type).get(number, number) if type else number}")
        elif number:
            words.append(name)
    rest = value & ~known
    return (*words, f"0x{rest:X}") if rest else tuple(words)


# --------------------------------------------------------------------------- dictionaries


def as_dict(
    holder: Described, names: bool, json: bool, device: str | None, inside: Inside | None = None
) -> dict[str, Any]:
    values = {}
    for p in holder.INFO.members:
        value = getattr(holder, p.attribute)
        if value is not None:
            value = _plain(_here(p, holder, device, inside), value, holder, names, json, device)
        values[p.name] = value
    return values


def _here(p: Parameter, holder: Described, device: str | None, inside: Inside | None) -> Parameter:
    """Returns a parameter as it is in an object with its other values."""
    if p.variants or p.flags_on:
        p = p.of(holder, device)
    return replace(p, **inside[p.attribute]) if inside and p.attribute in inside else p


def _plain(
    p: Parameter, value: Any, holder: Described, names: bool, json: bool, device: str | None
) -> Any:
    """Converts a value to JSON's types: dicts, lists, numbers, text."""
    if p.tag:
        case = _case(p, holder)
        return _plain(case, value, holder, names, json, device) if case else _number(value, json)
    value = meant(p, value) if names else value
    if isinstance(p.type, type) and issubclass(p.type, Described):
        inside = p.inside(holder, device) if p.variants else None
        alone = p.length is None or not _several(value)
        dicts = [
            as_dict(x, names, json, device, inside) if isinstance(x, Described) else x
            for x in ((value,) if alone else value)
        ]
        return dicts[0] if alone else dicts
    if p.elements and _several(value):
        vectors = value if p.length is not None else (value,)
        made = [_vector(p, x, names, json) for x in vectors]
        return made if p.length is not None else made[0]
    if _several(value):
        return [_one(x, names, json) for x in value]
    return _one(value, names, json)


def _case(p: Parameter, holder: Described) -> Parameter | None:
    """Returns the case of a union that is present."""
    tag = getattr(holder, p.tag)
    return p.cases.get(tag) if isinstance(tag, int) else None


def _vector(p: Parameter, value: Any, names: bool, json: bool) -> Any:
    numbers = [_number(x, json) for x in value] if _several(value) else []
    if names and len(numbers) == len(p.elements):
        return dict(zip(p.elements, numbers))
    return numbers


def _one(value: Any, names: bool, json: bool) -> Any:
    if names and isinstance(value, IntEnum):
        return _values(type(value)).get(int(value), int(value))
    if names and isinstance(value, IntFlag):
        return list(_set_bits(type(value), int(value)))
    return _number(value, json)


def named(p: Parameter, value: Any) -> Any:
    """Converts a value of an enumeration, a bitfield or a Boolean as `to_dict` does for JSON."""
    return _one(meant(p, value), True, True)


def _number(value: Any, json: bool) -> Any:
    if isinstance(value, float):
        return float(value) if isfinite(value) or not json else None
    return value if isinstance(value, (bool, str)) or not isinstance(value, int) else int(value)


# --------------------------------------------------------------------------- text


def as_text(holder: Described, device: str | None) -> str:
    try:
        name = holder._called(holder.INFO.name)
    except AttributeError:
        return repr(holder)  # the user's own class
    try:
        known = items(holder, device)
    except EncodeError:
        return repr(holder)  # a value cannot be sent
    return f"{name}: {_words(known)}" if known else name


def items(holder: Described, device: str | None = None) -> list[Item]:
    """Returns an object's values, without absent ones, each with its text and its validity."""
    return _items(holder, device, None)


def _items(holder: Described, device: str | None, inside: Inside | None) -> list[Item]:
    items = []
    for p in holder.INFO.members:
        value = getattr(holder, p.attribute)
        if value is not None:
            p = _here(p, holder, device, inside)
            valid = not p.flags or holder.is_valid(p.name, device)
            items.append(Item(p, value, _text(p, value, holder, device), valid))
    return items


def formatted(p: Parameter, value: Any) -> str:
    return _text(p, value, None, None)


def _text(p: Parameter, value: Any, holder: Described | None, device: str | None) -> str:
    if value is None:
        return "-"
    if p.tag:
        case = _case(p, holder) if holder is not None else None
        return _text(case, value, holder, device) if case else str(value)
    value = meant(p, value)
    if isinstance(p.type, type) and issubclass(p.type, Described):
        inside = p.inside(holder, device) if p.variants and holder is not None else None
        if p.length is None or not _several(value):
            return _structure(value, device, inside)
        return _list(_structure(x, device, inside) for x in value)
    if p.elements and _several(value):
        many = len(set(p.units)) > 1  # a unit for each element
        unit = "" if many else _unit(p.units)
        if p.length is None:
            return _elements(p, value, many) + unit
        return _list(_elements(p, x, many) for x in value) + unit
    if _several(value):
        many = len(set(p.units)) > 1
        units = p.units if many else ("",) * len(value)
        shown = (_word(p, x) + _unit((unit,)) for x, unit in zip(value, units))
        return _list(shown) + ("" if many else _unit(p.units))
    return _word(p, value) + _unit(p.units)


def _unit(units: tuple[str, ...]) -> str:
    return f" {units[0]}" if units and units[0] not in ("", "1") else ""


def _list(texts: Iterable[str]) -> str:
    return f"[{', '.join(texts)}]"


def _structure(value: Any, device: str | None, inside: Inside | None) -> str:
    if not isinstance(value, Described):
        return repr(value)
    return f"({_words(_items(value, device, inside))})"


def _words(items: list[Item]) -> str:
    shown = (f"{x.parameter.name} = {x.text}{'' if x.valid else ' (invalid)'}" for x in items)
    return ", ".join(shown)


def _elements(p: Parameter, value: Any, many: bool) -> str:
    """Formats a vector, or a matrix without its elements' names, which would only add noise."""
    if not _several(value):
        return repr(value)
    shown = [_word(p, x) for x in value]
    if len(shown) != len(p.elements) or len(shown) > 4:
        return f"({', '.join(shown)})"
    units = p.units if many else ("",) * len(shown)
    words = (f"{name}={x}{_unit((unit,))}" for name, x, unit in zip(p.elements, shown, units))
    return f"({', '.join(words)})"


def _word(p: Parameter, value: Any) -> str:
    match value:
        case IntEnum():
            return _values(type(value)).get(int(value), str(int(value)))
        case IntFlag():
            return "|".join(_set_bits(type(value), int(value))) or "0"
        case bool():
            return "true" if value else "false"
        case str():
            return repr(value.strip("\0 "))
        case float() if p.scalar == "float":
            return shortest(value)
        case int():
            return str(int(value))
    return repr(value)


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
