"""Typical values of fields, for what shows how they are used: packets and programs in documentation.

They are those of the first example that states them, else defaults, and what is simple and within its range.
"""

from __future__ import annotations

import math
import re
import struct
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from . import codec
from . import model as m

TEXT = "text"


@dataclass(frozen=True)
class Typical:
    model: m.Model

    def values(self, f: m.Field, call: m.Call) -> codec.Values:
        """The values that a field requires if it is sent in this way, in the form of the codec."""
        found: codec.Values = {"function": call.function.value} if call.function else {}
        printed = self._printed.get((f.full_name, found.get("function")), {})
        needed = [p for p in call.required if p.constant is None]
        if needed and all(p.name in printed for p in needed):
            return found | {p.name: printed[p.name] for p in needed}
        return found | record(tuple(needed))

    def shown(self, f: m.Field) -> list[m.Call]:
        """The ways to send a command that show how it is used: its first one, and the first that requests values."""
        asking = next((c for c in f.calls if self.replies(f, c)), f.calls[0])
        return [f.calls[0]] if asking is f.calls[0] else [f.calls[0], asking]

    def replies(self, f: m.Field, call: m.Call) -> list[m.Reply]:
        """What answers a command that is sent in this way."""
        values = self.values(f, call)
        return [
            r
            for r in self.model.replies(f)
            if (call.function is None or call.function in r.functions)
            and all(c.holds(values.get(c.parameter)) for c in r.when)
        ]

    def data(self, f: m.Field, call: m.Call | None = None) -> bytes:
        return codec.encode(f, self.values(f, call or f.calls[0]))

    def packet(self, f: m.Field, call: m.Call | None = None) -> bytes:
        """A packet of this field alone; one that is valid in every data set is sent in the first of them."""
        sets = [s.number for s in self.model.sets if s.kind == "data"]
        number = sets[0] if f.set == m.SHARED_SET and sets else f.set
        return codec.build(self.model, number, [(f.descriptor, self.data(f, call))])

    @cached_property
    def _printed(self) -> dict[tuple[str, int | None], codec.Values]:
        """(field, function) -> the values of the first example that a reader would take for typical."""
        found: dict[tuple[str, int | None], codec.Values] = {}
        for x in self.model.examples:
            for part in x.fields:
                f = self.model.field(part.field) if part.field else None
                if f is None or part.values is None or part.trailing or not _plain(f.parameters, part.values):
                    continue
                function: Any = part.values.get("function") if f.selector else None
                found.setdefault((f.full_name, function), part.values)
        return found


def record(parameters: tuple[m.Parameter, ...]) -> codec.Values:
    """Values for some parameters, which do not contradict each other."""
    found: codec.Values = {}
    for p in parameters:
        if p.constant is not None:
            continue
        union = next((q for q in parameters if q.tag == p.name), None)
        if p.reserved is not None:
            value = p.reserved if p.length is None else [p.reserved] * int(p.length)
            found[p.name] = codec.canonical(p.operation, value, p.name)
        elif union is not None:
            case = next((c for c in union.cases if c.parameter is not None), union.cases[0])
            found[p.name] = case.tag.value
        elif isinstance(p.operation, m.SwitchOp):
            case = next(c for c in p.cases if c.tag.value == found[p.operation.tag])
            q = case.parameter
            found[p.name] = {q.name: _value(q, q.operation)} if q else {}
        elif p.counts is not None:
            found[p.name] = 0  # its array says
        else:
            found[p.name] = _value(p, p.operation)
            counter = next((q.name for q in parameters if q.counts == p.name), None)
            if counter is not None:
                found[counter] = len(found[p.name])
    return found


def _value(p: m.Parameter, op: m.Operation) -> Any:
    if p.default is not None:
        value = list(p.default) if isinstance(p.default, tuple) else p.default
        try:
            return codec.canonical(op, value, p.name)
        except ValueError:
            pass  # a default in words
    match op:
        case m.ScalarOp():
            return _scalar(p, op)
        case m.BitsOp():
            return [1, *[0] * (op.size - 1)]
        case m.TextOp():
            return TEXT[: op.capacity] if op.count is None else TEXT[: op.count].ljust(op.count)
        case m.ArrayOp(item=item):
            if op.vector is not None and isinstance(item, m.ScalarOp):
                return [_element(p, item, i, op.count or 0) for i in range(op.count or 0)]
            count = op.count if op.count is not None else min(1, op.capacity)
            return [_value(p, item) for _ in range(count)]
        case m.StructOp():
            return record(op.struct.parameters)
    raise AssertionError(op)


def _scalar(p: m.Parameter, op: m.ScalarOp) -> Any:
    if isinstance(op.type, m.Enum):
        return next((v.value for v in op.type.values if not v.deprecated), 0)
    if isinstance(op.type, m.Bitfield):
        return next((1 << b.first for b in op.type.bits if not b.alias), 0)
    if op.scalar.kind in ("bool", "char"):
        return 1 if op.scalar.kind == "bool" else ord("a")
    return _number(op, _within(p, 1))


def _element(p: m.Parameter, op: m.ScalarOp, i: int, count: int) -> Any:
    """Of a vector: of length 1, and a rotation that does not turn where it is a matrix."""
    side = math.isqrt(count)
    one = i % (side + 1) == 0 if count > 4 and side * side == count else i == 0
    return _number(op, _within(p, 1 if one else 0))


def _within(p: m.Parameter, value: float) -> float:
    low = p.minimum if p.minimum is not None else value
    high = p.maximum if p.maximum is not None else value
    if p.below is not None and value >= p.below:
        value = p.below / 2
    if p.above is not None and value <= p.above:
        value = p.above + 1
    return min(max(value, low), high)


def _number(op: m.ScalarOp, value: float) -> Any:
    if op.scalar.kind == "float":
        return "0x" + struct.pack(">f" if op.size == 4 else ">d", value).hex()
    return int(value)


# --------------------------------------------------------------------------- values in programs


def flags(t: m.Bitfield, value: int) -> list[m.Bits]:
    """The flags that make up a value; none if it has other bits, or numbers, too.

    >>> t = m.Bitfield("b", m.SCALARS["u8"], 1, (m.Bits("a", 0, 0, "", False), m.Bits("n", 1, 2, "", False)), "", None)
    >>> [b.name for b in flags(t, 1)], flags(t, 3), flags(t, 128)
    (['a'], [], [])
    """
    named = [b for b in t.bits if b.width == 1 and not b.alias and value & b.mask]
    return named if sum(b.mask for b in named) == value else []


def decimal(bits: str) -> str:
    """The shortest decimal that has the bits of a finite number; it has a point or an exponent.

    >>> decimal("0x3dcccccd"), decimal("0x3ff0000000000000"), decimal("0x7149f2ca")
    ('0.1', '1.0', '1e+30')
    """
    raw = bytes.fromhex(bits[2:])
    form = ">f" if len(raw) == 4 else ">d"
    (value,) = struct.unpack(form, raw)
    for digits in range(1, 18):
        text = f"{value:.{digits}g}"
        try:
            if struct.pack(form, float(text)) == raw:
                return text if re.search(r"[.e]", text) else f"{text}.0"
        except OverflowError:
            continue
    raise AssertionError(bits)


# --------------------------------------------------------------------------- what readers take for typical


def _plain(parameters: tuple[m.Parameter, ...], found: codec.Values) -> bool:
    """Has it names for all values and bits, and only numbers that can be written as such?"""
    return all(_is_plain(p, p.operation, found[p.name]) for p in parameters if p.name in found)


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
            return _plain(op.struct.parameters, value)
        case m.SwitchOp():
            return all(
                c.parameter is None or _is_plain(c.parameter, c.parameter.operation, value[c.parameter.name])
                for c in p.cases
                if c.parameter is not None and c.parameter.name in value
            )
    return True
