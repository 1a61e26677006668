"""Complete records of values: given values, and for the rest simple values within their ranges."""

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
    """Consistent values for some parameters: given values, and simple ones for the rest."""

    parameters: tuple[m.Parameter, ...]
    stated: Mapping[str, Any]
    made_up: list[str]  # receives the paths of the rest
    path: str = ""
    complete: codec.Values = field(default_factory=dict)

    def values(self) -> codec.Values:
        for p in self.parameters:
            if p.constant is None:
                self.complete[p.name] = self.value_of(p)
                counter = next((q.name for q in self.parameters if q.counts == p.name), None)
                if counter is not None:
                    self.complete[counter] = len(self.complete[p.name])
        return self.complete

    def value_of(self, p: m.Parameter) -> Any:
        if p.counts is not None:
            return 0  # its array determines it
        if p.reserved is not None:
            value = p.reserved if p.length is None else [p.reserved] * int(p.length)
            return codec.canonical(p, value, p.name)
        union = next((q for q in self.parameters if q.tag == p.name), None)
        if union is not None and p.name not in self.stated and p.typical is None:
            self.made_up.append(f"{self.path}{p.name}")
            return next((c for c in union.cases if c.parameter is not None), union.cases[0]).tag.value
        if p.union:
            return self.alternative(p, p.union)
        entry = self.stated.get(p.name, p.typical)
        return self.value(p, entry, f"{self.path}{p.name}")

    def alternative(self, p: m.Parameter, union: m.Union) -> Any:
        case = next((c for c in union.cases if c.tag.value == self.complete[union.tag]), None)
        q = case.parameter if case else None
        if q is None:
            return {}
        entry = self.stated.get(p.name, {})
        return {q.name: self.value(q, entry.get(q.name, q.typical), f"{self.path}{p.name}.{q.name}")}

    def value(self, p: m.Parameter, value: Any, path: str) -> Any:
        if p.struct:
            return Filled(p.struct.parameters, value or {}, self.made_up, f"{path}.").values()
        if p.several and p.item.struct:
            items = value if value is not None else [{}] * _usual_count(p)
            return [self.value(p.item, item, path) for item in items]
        if value is not None:
            return value
        if p.default is not None:
            try:
                return codec.canonical(p, lists(p.default), p.name)
            except ValueError:
                pass  # a default in words
        self.made_up.append(path)
        return _simple(p)


def _usual_count(p: m.Parameter) -> int:
    return min(1, p.capacity) if p.count is None else p.count


def _simple(p: m.Parameter) -> Any:
    if p.kind == "bits":
        return [1, *[0] * (p.size - 1)]
    if p.kind == "text":
        return TEXT[: p.capacity].ljust(p.count or 0)
    if p.vector:
        return [_element(p.item, i, p.capacity) for i in range(p.capacity)]
    if p.kind == "array":
        return [_simple(p.item) for _ in range(_usual_count(p))]
    return _scalar(p)


def _scalar(p: m.Parameter) -> Any:
    if isinstance(p.named, m.Enum):
        return next((v.value for v in p.named.values if not v.deprecated), 0)
    if isinstance(p.named, m.Bitfield):
        return next((1 << b.first for b in p.named.bits if not b.alias), 0)
    if p.scalar.kind in ("bool", "char"):
        return 1 if p.scalar.kind == "bool" else ord("a")
    return _number(p.scalar, _within(p, 1))


def _element(p: m.Parameter, i: int, count: int) -> Any:
    """Returns an element of a vector of length 1, or of the identity matrix."""
    side = math.isqrt(count)
    is_diagonal = i % (side + 1) == 0 if count > 4 and side * side == count else i == 0
    return _number(p.scalar, _within(p, 1 if is_diagonal else 0))


def _within(p: m.Parameter, value: float) -> float:
    low = p.minimum if p.minimum is not None else value
    high = p.maximum if p.maximum is not None else value
    if p.below is not None and value >= p.below:
        value = p.below / 2
    if p.above is not None and value <= p.above:
        value = p.above + 1
    return min(max(value, low), high)


def _number(scalar: m.Scalar, value: float) -> Any:
    if scalar.kind == "float":
        return "0x" + struct.pack(">f" if scalar.size == 4 else ">d", value).hex()
    return int(value)


def lists(value: object) -> Any:
    """Converts a default, whose lists are tuples, to the form of the codec."""
    return [lists(v) for v in value] if isinstance(value, (list, tuple)) else value
