"""Selects the values of an example that can serve as typical values."""

from __future__ import annotations

import math
import struct
from typing import Any

from mipgen import model as m
from mipgen.lower import codec


def is_plain(parameters: tuple[m.Parameter, ...], values: codec.Values) -> bool:
    """True if all values and bits have names, numbers and texts can be written, and no set depends on the device."""
    return all(
        _is_plain(p, values[p.name])
        and not (p.shown == "set" and any(v.by_device and v.type is not None for v in p.variants))
        for p in parameters
        if p.name in values
    )


def _is_plain(p: m.Parameter, value: Any) -> bool:
    if p.struct:
        return is_plain(p.struct.parameters, value)
    if p.union:
        return all(_is_plain(q, value[q.name]) for q in p.alternatives if q.name in value)
    if p.kind == "text":
        return all(" " <= c <= "~" for c in value)
    if p.kind == "array":
        return all(_is_plain(p.item, v) for v in value)
    if p.kind == "scalar" and p.scalar.kind == "float":
        return math.isfinite(struct.unpack(">f" if p.size == 4 else ">d", bytes.fromhex(value[2:]))[0])
    if isinstance(p.named, m.Enum):
        return any(v.value == value for v in p.named.values)
    if isinstance(p.named, m.Bitfield) and p.kind == "scalar":
        return not value & ~p.named.known_mask
    return True
