"""Typical values of fields, for what shows how they are used: packets and programs in documentation.

A value is, in this order: that of an example in a manual, what the specification states as `typical`, what a simulated
device shows, the factory default, what a new device has set. Where there is none of these, it is simple and within its
range; `made_up` lists those.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from . import codec
from . import model as m
from .simulated import Value

TEXT = "text"


@dataclass(frozen=True)
class Typical:
    model: m.Model

    def values(self, f: m.Field, call: m.Call) -> codec.Values:
        """The values that a field requires if it is sent in this way, in the form of the codec. Do not change them:
        they are made once."""
        key = (f.full_name, call.function.value if call.function else None)
        if key not in self._values:
            self._values[key] = self._made(f, call, [])
        return self._values[key]

    def whole(self, f: m.Field, call: m.Call) -> codec.Values:
        """The same without the function, and with those that are optional."""
        found = self.values(f, call)
        if call.optional:
            asked = tuple(p for p in (*call.required, *call.optional) if p.constant is None)
            found = _Record(asked, self._stated(f) | found, []).values()
        return {name: value for name, value in found.items() if name != "function" or not f.selector}

    def made_up(self, f: m.Field, call: m.Call) -> list[str]:
        """The parameters among these, and members of their structures, whose values nothing states."""
        found: list[str] = []
        self._made(f, call, found)
        return found

    def _made(self, f: m.Field, call: m.Call, made_up: list[str]) -> codec.Values:
        found: codec.Values = {"function": call.function.value} if call.function else {}
        printed = self._printed.get(f.full_name, {}).get(found.get("function"), {})
        needed = [p for p in call.required if p.constant is None]
        if needed and all(p.name in printed for p in needed):
            tags = {q.tag for q in needed}  # what a union holds depends on them
            own = {p.name: p.typical for p in needed if p.typical is not None and p.name not in tags}
            values = found | {p.name: printed[p.name] for p in needed} | own
            return values | {p.name: len(values[p.counts]) for p in needed if p.counts is not None}
        return found | _Record(tuple(needed), self._stated(f), made_up).values()

    def _stated(self, f: m.Field) -> codec.Values:
        """What is known of its values one by one, in the form of the codec; those of structures may lack members."""
        by_name = {p.name: p for p in f.parameters}
        found: codec.Values = {}
        for name, value in self._initial.get(f.full_name, ()):
            if value is not None:
                _state(found, by_name[name], value)
        for p in f.parameters:
            if p.default is not None:
                _state(found, p, p.default)
        found |= self._asked(f)
        found |= self._simulated(f)
        if f.role == m.COMMAND:
            for values in self._printed.get(f.full_name, {}).values():
                found |= {key: value for key, value in values.items() if key != "function"}
        return found | {p.name: p.typical for p in f.parameters if p.typical is not None}

    def _asked(self, f: m.Field) -> codec.Values:
        """Of a response: what its command sets, where it is answered with the same."""
        command = self.model.field(f"{f.set_name}.{f.command}") if f.command else None
        if command is None:
            return {}
        same = {p.name: p for p in command.counted if p.constant is None}
        values = self.values(command, command.calls[0])
        found = {
            p.name: values[p.name]
            for p in f.parameters
            if p.name in values and (p.element, p.length, p.cases) == _form(same[p.name])
        }
        return found | {c.parameter: c.value for c in f.when if c.parameter in {p.name for p in f.parameters}}

    def _simulated(self, f: m.Field) -> codec.Values:
        """What a simulated device shows, and flags that say that it is valid."""
        source = self._sources.get(f.full_name) or self._sources.get(f.definition or "")
        if source is None:
            return {}
        found: codec.Values = {}
        for v in source:
            p = _at(f.parameters, v.path)
            value = None if p is None else self._shown(v, p)
            if value is not None:
                _place(found, v.path, value)
        for flags, bits in _valid(f.parameters).items():
            found[flags] = found.get(flags, 0) | bits
        return found

    def _shown(self, v: Value, p: m.Parameter) -> Any:
        if v.names or v.bits:
            return _named(p, v)
        given: Any = v.number if v.number is not None else v.text
        if v.quantity:
            given = self._quantities.get(v.quantity)  # one that is missing is reported elsewhere
        if given is None:
            return None
        return shown(p, given, v.factor)

    def shown(self, f: m.Field) -> list[m.Call]:
        """The ways to send a command that show how it is used: its first one, and the first that requests values."""
        calls = self.sent(f)
        asking = next((c for c in calls if self.replies(f, c)), calls[0])
        return [calls[0]] if asking is calls[0] else [calls[0], asking]

    def sent(self, f: m.Field) -> list[m.Call]:
        """The ways to send a field that some device takes."""
        return [c for c in f.calls if c.function is None or c.function in self.model.taken(f)]

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
    def _values(self) -> dict[tuple[str, int | None], codec.Values]:
        return {}

    @cached_property
    def _quantities(self) -> dict[str, Any]:
        return {q.name: q.typical for q in self.model.simulation.quantities}

    @cached_property
    def _sources(self) -> dict[str, tuple[Value, ...]]:
        return {s.field.full_name: s.values for s in self.model.simulation.sources}

    @cached_property
    def _initial(self) -> dict[str, list[tuple[str, Any]]]:
        """Command -> the values that a new device has."""
        found: dict[str, list[tuple[str, Any]]] = {}
        for b in self.model.simulation.behaviors:
            found.setdefault(b.command.full_name, []).extend(b.initial)
        return found

    @cached_property
    def _printed(self) -> dict[str, dict[int | None, codec.Values]]:
        """Field -> function -> the values of the first example that a reader would take for typical."""
        found: dict[str, dict[int | None, codec.Values]] = {}
        for x in self.model.examples:
            for part in x.fields:
                f = self.model.field(part.field) if part.field else None
                if f is None or part.values is None or part.trailing or not _plain(f.parameters, part.values):
                    continue
                function: Any = part.values.get("function") if f.selector else None
                found.setdefault(f.full_name, {}).setdefault(function, part.values)
        return found


@dataclass(frozen=True)
class Given(Typical):
    """Has the values that one field is sent with, in place of typical ones."""

    call: m.Call
    given: codec.Values
    host: str = ""  # what a program does after the answer

    def values(self, f: m.Field, call: m.Call) -> codec.Values:
        return self.given

    def shown(self, f: m.Field) -> list[m.Call]:
        return [self.call]


def title_of(f: m.Field, given: Given) -> str:
    """What a line of a program sends, in a comment."""
    return f"{f.title}, {given.call.function.name}" if given.call.function else f.title


def _form(p: m.Parameter) -> tuple[object, object, object]:
    return p.element, p.length, p.cases


def _state(found: codec.Values, p: m.Parameter, value: object) -> None:
    """Adds a default, unless it is in words."""
    try:
        found[p.name] = codec.canonical(p.operation, _lists(value), p.name)
    except ValueError:
        pass


def _lists(value: object) -> Any:
    return [_lists(v) for v in value] if isinstance(value, (list, tuple)) else value


# --------------------------------------------------------------------------- what a simulated device shows


def shown(p: m.Parameter, given: Any, factor: float) -> Any:
    """A quantity as a parameter shows it, in the form of the codec. Raises ValueError if it cannot.

    >>> p = m.Parameter("a", m.SCALARS["float"], None, m.ScalarOp("a", m.SCALARS["float"], None, 4))
    >>> shown(p, 9.80665, 1 / 9.80665)
    '0x3f800000'
    """
    op = p.operation
    if isinstance(given, list) and isinstance(op, m.ArrayOp):
        return codec.canonical(op, [_scaled(p, one, factor) for one in given], p.name)
    if isinstance(op, m.ArrayOp) and op.count is not None:  # one number for all elements
        return codec.canonical(op, [_scaled(p, given, factor)] * op.count, p.name)
    return codec.canonical(op, _scaled(p, given, factor), p.name)


def _scaled(p: m.Parameter, given: Any, factor: float) -> Any:
    """A quantity in the unit of a parameter, with as many digits as a reader would write."""
    scalar = p.element.scalar if isinstance(p.element, m.Vector) else p.element
    if not isinstance(given, (int, float)) or not isinstance(scalar, m.Scalar):
        return given
    if scalar.kind != "float":
        return round(given * factor)
    return given if factor == 1 else float(f"{given * factor:.{6 if scalar.size == 4 else 10}g}")


def _named(p: m.Parameter, v: Value) -> Any:
    """The first of the names that a type of the parameter has; or all bits."""
    types = [p.element, *(x.type for x in p.readings)]
    if v.names:
        enums = [t for t in types if isinstance(t, m.Enum)]
        return next((x.value for name in v.names for t in enums if (x := t.by_name(name))), None)
    for t in types:
        if isinstance(t, m.Bitfield) and t.scalar is not None:
            masks = [_mask(t, name) for name in v.bits]
            if None not in masks:
                return sum(mask for mask in masks if mask is not None)
    return None


def _mask(t: m.Bitfield, name: str) -> int | None:
    """A bit, or a value of a number inside the bitfield: bits.value."""
    bits, _, value = name.partition(".")
    b = next((b for b in t.bits if b.name == bits), None)
    if b is None or not value:
        return b.mask if b else None
    known = b.enum.by_name(value) if b.enum else None
    return known.value << b.first if known else None


def _at(parameters: tuple[m.Parameter, ...], path: str) -> m.Parameter | None:
    name, _, rest = path.partition(".")
    p = next((p for p in parameters if p.name == name), None)
    return _at(p.element.parameters, rest) if p and rest and isinstance(p.element, m.Struct) else p


def _place(found: codec.Values, path: str, value: Any) -> None:
    name, _, rest = path.partition(".")
    if rest:
        _place(found.setdefault(name, {}), rest, value)
    else:
        found[name] = value


def _valid(parameters: tuple[m.Parameter, ...]) -> codec.Values:
    """The flags of what is valid: all that values refer to."""
    found: codec.Values = {}
    by_name = {p.name: p for p in parameters}
    for p in parameters:
        for path in p.valid:
            flags, _, bit = path.partition(".")
            t = by_name[flags].element
            if not bit:
                found[flags] = 1
            elif isinstance(t, m.Bitfield) and t.scalar is not None:
                found[flags] = found.get(flags, 0) | (_mask(t, bit) or 0)
    return found


# --------------------------------------------------------------------------- records


@dataclass(frozen=True)
class _Record:
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
            return _Record(op.struct.parameters, given or {}, self.made_up, f"{path}.").values()
        if isinstance(op, m.ArrayOp) and isinstance(op.item, m.StructOp):
            count = op.count if op.count is not None else min(1, op.capacity)
            items = given if given is not None else [{}] * count
            return [self.value(p, op.item, one, path) for one in items]
        if given is not None:
            return given
        if p.default is not None:
            try:
                return codec.canonical(op, _lists(p.default), p.name)
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

    >>> decimal("0x3dcccccd"), decimal("0x42480000"), decimal("0x3ff0000000000000"), decimal("0x7149f2ca")
    ('0.1', '50.0', '1.0', '1e+30')
    """
    raw = bytes.fromhex(bits[2:])
    form = ">f" if len(raw) == 4 else ">d"
    (value,) = struct.unpack(form, raw)
    for digits in range(1, 18):
        text = f"{value:.{digits}g}"
        try:
            if struct.pack(form, float(text)) == raw:
                return repr(float(text))
        except OverflowError:
            continue
    raise AssertionError(bits)


# --------------------------------------------------------------------------- what readers take for typical


def _plain(parameters: tuple[m.Parameter, ...], found: codec.Values) -> bool:
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
            return _plain(op.struct.parameters, value)
        case m.SwitchOp():
            return all(
                c.parameter is None or _is_plain(c.parameter, c.parameter.operation, value[c.parameter.name])
                for c in p.cases
                if c.parameter is not None and c.parameter.name in value
            )
    return True
