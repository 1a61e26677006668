"""Examples: values that can serve as typical ones, and differences between the printed and the correct bytes."""

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


def misprint_text(e: m.Example) -> list[str]:
    """Words the differences between the bytes of an example in the manual and the correct ones."""
    correct = e.packet[4:-2] if e.role == "field" else e.packet
    sentences = []
    if e.string is not None:
        digits = "".join(e.string.split())
        if len(digits) % 2:
            sentences.append(f"string has an odd number of digits, {len(digits)}")
        elif bytes.fromhex(digits) != correct:
            sentences.append(f"string {_where(tuple(bytes.fromhex(digits)), correct)}")
    if e.table is not None and (
        len(e.table) != len(correct) or any(a is not None and a != b for a, b in zip(e.table, correct, strict=False))
    ):
        sentences.append(f"table {_where(e.table, correct)}")
    return sentences


def _where(printed: tuple[int | None, ...], correct: bytes) -> str:
    for i, (a, b) in enumerate(zip(printed, correct, strict=False)):
        if a is not None and a != b:
            return f"byte at offset {i} is {a:02X}, should be {b:02X}"
    return f"has {len(printed)} bytes, should have {len(correct)}"
