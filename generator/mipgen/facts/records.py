"""Whole records of values: what is given, and simple values within their range for the rest."""

from __future__ import annotations

import math
import struct
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from mipgen import model as m
from mipgen.lower import codec

TEXT = "text"


@dataclass(frozen=True)
class Filled:
    """Values for some parameters, which do not contradict each other: what is given, and simple ones for the rest."""

    parameters: tuple[m.Parameter, ...]
    given: Mapping[str, Any]
    made_up: list[str]  # the paths of the rest are added
    path: str = ""
    found: codec.Values = field(default_factory=dict)

    def values(self) -> codec.Values:
        for p in self.parameters:
            if p.constant is None:
                self.found[p.name] = self.one(p)
                counter = next((q.name for q in self.parameters if q.counts == p.name), None)
                if counter is not None:
                    self.found[counter] = len(self.found[p.name])
        return self.found

    def one(self, p: m.Parameter) -> Any:
        if p.counts is not None:
            return 0  # its array says
        if p.reserved is not None:
            value = p.reserved if p.length is None else [p.reserved] * int(p.length)
            return codec.canonical(p.operation, value, p.name)
        union = next((q for q in self.parameters if q.tag == p.name), None)
        if union is not None and p.name not in self.given and p.typical is None:
            self.made_up.append(f"{self.path}{p.name}")
            return next((c for c in union.cases if c.parameter is not None), union.cases[0]).tag.value
        if isinstance(p.operation, m.SwitchOp):
            return self.alternative(p, p.operation.tag)
        given = self.given.get(p.name, p.typical)
        return self.value(p, p.operation, given, f"{self.path}{p.name}")

    def alternative(self, union: m.Parameter, tag: str) -> Any:
        case = next((c for c in union.cases if c.tag.value == self.found[tag]), None)
        q = case.parameter if case else None
        if q is None:
            return {}
        given = self.given.get(union.name, {})
        return {q.name: self.value(q, q.operation, given.get(q.name, q.typical), f"{self.path}{union.name}.{q.name}")}

    def value(self, p: m.Parameter, op: m.Operation, given: Any, path: str) -> Any:
        if isinstance(op, m.StructOp):
            return Filled(op.struct.parameters, given or {}, self.made_up, f"{path}.").values()
        if isinstance(op, m.ArrayOp) and isinstance(op.item, m.StructOp):
            count = op.count if op.count is not None else min(1, op.capacity)
            items = given if given is not None else [{}] * count
            return [self.value(p, op.item, one, path) for one in items]
        if given is not None:
            return given
        if p.default is not None:
            try:
                return codec.canonical(op, lists(p.default), p.name)
            except ValueError:
                pass  # a default in words
        self.made_up.append(path)
        return _simple(p, op)


def _simple(p: m.Parameter, op: m.Operation) -> Any:
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
            return [_simple(p, item) for _ in range(count)]
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


def lists(value: object) -> Any:
    """A default, whose lists are tuples, in the form of the codec."""
    return [lists(v) for v in value] if isinstance(value, (list, tuple)) else value
