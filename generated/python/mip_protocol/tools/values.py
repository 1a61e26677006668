"""Values of fields as text, and as numbers and strings for JSON and tables."""

from __future__ import annotations

import math
import struct
from collections.abc import Iterator
from enum import IntEnum, IntFlag
from typing import Any

from ..field import Structure
from ..parameter import Parameter
from ..reflection import PARAMETERS

_SINGLE = struct.Struct(">f")


def single(value: float) -> str:
    """The shortest text that gives the same number of 32 bits again."""
    if value != value or value in (math.inf, -math.inf):
        return repr(value)
    for digits in (6, 7, 8):
        text = f"{value:.{digits}g}"
        try:
            if _SINGLE.unpack(_SINGLE.pack(float(text)))[0] == value:
                break
        except OverflowError:  # rounded up, beyond the greatest number
            continue
    else:
        text = f"{value:.9g}"
    return text if "." in text or "e" in text else text + ".0"


def number(value: float, scalar: str) -> str:
    """A number as text, with as many digits as its type on the wire has."""
    return single(value) if scalar == "float" else repr(value)


def meant(value: Structure, p: Parameter, device: str | None = None) -> Any:
    """A value, as the enumeration or bitfield that it has on this device."""
    found = getattr(value, p.attribute)
    if p.attribute in value.READINGS:
        try:
            return value.meaning(p.attribute, device)
        except (ValueError, TypeError):
            return found
    return found


def members(value: Structure) -> Iterator[Parameter]:
    """The parameters of a field that its object holds: no counters, constants or reserved bytes."""
    for p in PARAMETERS.get(type(value), ()):
        if p.attribute and hasattr(value, p.attribute):
            yield p


def names(value: Any) -> str:
    """The name of an enumeration's value; the names of a bitfield's bits, joined by |."""
    if isinstance(value, IntFlag):
        return "|".join(_bits(value)) or "0"
    if isinstance(value, IntEnum):
        name = getattr(value, "_name_", None)
        known = name in type(value).__members__
        return str(name) if known else str(int(value))
    return str(int(value))


def _bits(value: IntFlag) -> Iterator[str]:
    left = int(value)
    for name, bits in type(value).__members__.items():
        mask = int(bits)
        if mask & (mask - 1):  # a number of several bits
            inner = getattr(value, name.lower(), None)
            if inner is not None and mask & int(value):
                left &= ~mask
                yield f"{name}={names(inner)}"
        elif mask & int(value):
            left &= ~mask
            yield name
    if left:
        yield f"0x{left:X}"


def text(value: Any, p: Parameter, device: str | None = None) -> str:
    """A parameter's value for people, without its unit."""
    if value is None:
        return "-"
    if isinstance(value, Structure):
        inner = [f"{m.name}={text(meant(value, m, device), m, device)}" for m in members(value)]
        return "{" + ", ".join(inner) + "}"
    if isinstance(value, (IntEnum, IntFlag)):
        return names(value)
    if isinstance(value, (bytes, bytearray)):
        if p.kind == "text":
            return quoted(bytes(value))
        return value.hex() or "empty"
    if isinstance(value, str):
        return quoted(value.encode("latin-1", "replace"))
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        return number(value, scalar_of(value, p))
    if isinstance(value, int):
        return str(value)
    if p.kind == "switch":
        return text_of_sequence(value, _case(p), device)
    return text_of_sequence(value, p, device)


def text_of_sequence(value: Any, p: Parameter, device: str | None) -> str:
    parts = [text(v, p, device) for v in value]
    if p.elements and len(parts) == len(p.elements):
        return " ".join(f"{e}={part}" for e, part in zip(p.elements, parts))
    return "[" + ", ".join(parts) + "]"


def _case(p: Parameter) -> Parameter:
    """A member of a union that is no structure, for its scalar."""
    return next((c for c in p.cases.values() if c is not None and c.kind == "array"), p)


def scalar_of(value: float, p: Parameter) -> str:
    return p.scalar or "float"


def quoted(data: bytes) -> str:
    """Characters on the wire, without the blanks and zeros around them."""
    shown = data.decode("latin-1").strip(" \0")
    return '"' + "".join(c if c.isprintable() else f"\\x{ord(c):02x}" for c in shown) + '"'


def unit(p: Parameter) -> str:
    """The unit of a parameter; those of its elements joined by commas if they differ."""
    different = list(dict.fromkeys(p.units))
    shown = p.units if len(different) > 1 else different
    return ", ".join(shown) if shown not in ([], ["1"]) else ""


def plain(value: Any, p: Parameter | None = None, named: bool = True) -> Any:
    """A value as JSON has it: names of enumerations and bits (or numbers), lists, objects.

    Numbers that JSON does not have are strings: "nan", "inf", "-inf".
    """
    if isinstance(value, Structure):
        return {m.name: plain(getattr(value, m.attribute), m, named) for m in members(value)}
    if isinstance(value, (IntEnum, IntFlag)):
        return names(value) if named else int(value)
    if value is None or isinstance(value, (bool, int)):
        return value
    if isinstance(value, float):
        if not math.isfinite(value):
            return repr(value)
        return float(single(value)) if p is not None and p.scalar == "float" else value
    if isinstance(value, (bytes, bytearray)):
        if p is not None and p.kind == "text":
            return bytes(value).decode("latin-1").strip(" \0")
        return value.hex()
    if isinstance(value, str):
        return value.strip(" \0")
    return [plain(v, p, named) for v in value]


__all__ = ["meant", "members", "names", "number", "plain", "quoted", "single", "text", "unit"]
