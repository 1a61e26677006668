"""Which values of an example a reader would take for typical."""

from __future__ import annotations

import math
import struct
from typing import Any

from mipgen import model as m
from mipgen.lower import codec


def plain(parameters: tuple[m.Parameter, ...], found: codec.Values) -> bool:
    """Has it names for all values and bits, and only numbers that can be written, of sets that all devices take?"""
    return all(
        _is_plain(p, p.operation, found[p.name])
        and not (p.shown == "set" and any(v.by_device and v.type is not None for v in p.variants))
        for p in parameters
        if p.name in found
    )


def _is_plain(p: m.Parameter, op: m.Operation, value: Any) -> bool:
    match op:
        case m.ScalarOp():
            if op.scalar.kind == "float":
                return math.isfinite(struct.unpack(">f" if op.size == 4 else ">d", bytes.fromhex(value[2:]))[0])
            if isinstance(op.type, m.Enum):
                return any(v.value == value for v in op.type.values)
            return not isinstance(op.type, m.Bitfield) or not value & ~op.type.known_mask
        case m.ArrayOp(item=item):
            return all(_is_plain(p, item, v) for v in value)
        case m.TextOp():
            return all(" " <= c <= "~" for c in value)
        case m.StructOp():
            return plain(op.struct.parameters, value)
        case m.SwitchOp():
            return all(
                c.parameter is None or _is_plain(c.parameter, c.parameter.operation, value[c.parameter.name])
                for c in p.cases
                if c.parameter is not None and c.parameter.name in value
            )
    return True
