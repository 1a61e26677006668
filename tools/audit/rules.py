"""Compares the model with rules: facts that follow from the kind of quantity, such as the range of a latitude.

Rules are the witness for facts that no source documents. A rule selects parameters by their names and other facts,
never by the fact that it checks.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from fnmatch import fnmatchcase
from itertools import pairwise
from typing import Any

from mipgen import model as m


@dataclass(frozen=True)
class Finding:
    at: str
    text: str
    position: m.Position | None


def compare_rules(model: m.Model, rules: list[dict[str, Any]]) -> Iterator[tuple[str, Finding | None]]:
    """Yields the kind of each fact that a rule checks, and the difference or None. The first applicable rule counts."""
    for at, record in _records(model):
        for p in record:
            stated = set[str]()
            for rule in rules:
                if not _about(rule, at, p):
                    continue
                for kind in sorted({*_SAYS} & {*rule} - stated):
                    stated.add(kind)
                    text = _SAYS[kind](rule[kind], p, record)
                    if text is not None:
                        yield kind, Finding(at, f"{p.name}: {text}", p.position) if text else None


def compare_constants(model: m.Model, stated: dict[str, Any]) -> Iterator[tuple[str, Finding | None]]:
    """Yields the kind of each fact of the protocol, a unit, a clock, a command or a formula, and the difference or
    None."""
    protocol, fields = model.protocol, {f.full_name: f for f in model.fields}
    ours: dict[str, dict[str, Any]] = {
        "units": {word.key: dict([word.equals]) for word in protocol.units if word.equals},
        "epochs": {clock.name: clock.epoch for clock in protocol.clocks if clock.epoch},
        "timeouts": {name: f.timeout for name, f in fields.items() if f.timeout is not None},
        "formulas": {name: formulas for name, f in fields.items() if (formulas := _formulas(f))},
    }
    for kind, found in ours.items():
        for name in sorted({*found, *stated.get(kind, {})} if stated else ()):
            here, wanted = found.get(name), stated.get(kind, {}).get(name)
            differs = here != wanted and (here is not None or wanted is not None)
            yield kind, Finding(name, f"{kind}: {here}, a rule has {wanted}", None) if differs else None
    for (_, before), (day, seconds) in pairwise((("", 0), *protocol.leap_seconds)) if stated else ():
        text = f"leap seconds: {seconds} on {day} after {before}; each adds one, in January or July"
        wrong = seconds != before + 1 or day[4:] not in ("-01-01", "-07-01")
        yield "leap seconds", Finding("protocol", text, None) if wrong else None
    for device in model.devices if stated else ():
        for port in device.ports:
            if values := _values_named(model, port.name.lower().replace(" ", "_")) if port.id is not None else None:
                text = f"the id of port {port.name} is {port.id}; the enumeration has {_all(map(str, values))}"
                yield "ids of ports", Finding(device.id, text, None) if port.id not in values else None


def _values_named(model: m.Model, name: str) -> list[int]:
    return [value.value for t in model.types if t.kind == "enum" for value in t.values if value.name == name]


def _formulas(field: m.Field) -> list[str]:
    texts = " ".join(field.notes)
    return [code for code in re.findall("`([^`]*)`", texts) if " = " in code]


def _records(model: m.Model) -> Iterator[tuple[str, tuple[m.Parameter, ...]]]:
    """Yields the name and the parameters of each field and, once, of each structure that fields contain."""
    seen = set[str]()
    for field in model.fields:
        yield field.full_name, field.parameters
        open_ones = list(field.parameters)
        while open_ones:
            p = open_ones.pop()
            open_ones += p.alternatives
            if isinstance(p.element, m.Struct) and p.element.name not in seen:
                seen.add(p.element.name)
                open_ones += p.element.parameters
                yield p.element.name, p.element.parameters


def _about(rule: dict[str, Any], at: str, p: m.Parameter) -> bool:
    scalar = _scalar(p)
    return (
        not p.selector
        and p.reserved is None
        and _any(rule.get("names"), p.name)
        and _any(rule.get("fields"), at)
        and not ("not_fields" in rule and _any(rule["not_fields"], at))
        and ("of" not in rule or (bool(scalar) and m.SCALARS[scalar].kind == rule["of"]))
        and ("units_are" not in rule or (bool(p.units) and {*p.units} <= {*rule["units_are"]}))
    )


def _any(patterns: list[str] | None, name: str) -> bool:
    return patterns is None or any(fnmatchcase(name, pattern) for pattern in patterns)


def _scalar(p: m.Parameter) -> str:
    """Returns the scalar type of a plain number or of a vector's elements; empty for any other type."""
    return p.element.name if isinstance(p.element, m.Scalar) else getattr(_vector(p), "name", "")


def _vector(p: m.Parameter) -> m.Scalar | None:
    return p.element.scalar if isinstance(p.element, m.Vector) else None


# ----------------------------------------- differences: None if there is nothing to compare, empty if there is none


def _range(limits: list[float | None], p: m.Parameter, _: object) -> str | None:
    bounds = (p.minimum if p.minimum is not None else p.above, p.maximum if p.maximum is not None else p.below)
    if all(wanted is None or bound == wanted for bound, wanted in zip(bounds, limits, strict=True)):
        return ""
    return f"range {_bounds(bounds)}, a rule has {_bounds(limits)}"


def _if_range(limits: list[float | None], p: m.Parameter, record: object) -> str | None:
    """Like `_range`, but only if the specification limits the parameter."""
    return _range(limits, p, record) if (p.minimum, p.maximum, p.above, p.below) != (None,) * 4 else None


def _frame(frames: list[str], p: m.Parameter, _: object) -> str | None:
    if p.frame is None:
        return None
    return "" if p.frame in frames else f"frame {p.frame}, a rule has {'/'.join(frames)}"


def _reference(frames: list[str], p: m.Parameter, record: object) -> str | None:
    """Like `_frame`, but the frame must be stated, except of what has no sign, such as an error."""
    if p.frame is None and not _signed(p):
        return None
    return f"no frame, a rule has {'/'.join(frames)}" if p.frame is None else _frame(frames, p, record)


def _signed(p: m.Parameter) -> bool:
    low = p.minimum if p.minimum is not None else p.above
    return low is None or low < 0


def _positive(phrases: list[str], p: m.Parameter, _: object) -> str | None:
    """Requires the meaning of a positive value, except of what has no sign and of vectors, whose axes state it."""
    framed = p.frame or (p.variants and all(v.frame for v in p.variants))
    if not _signed(p) or (not p.positive and framed and (p.elements or p.name in _AXES)):
        return None
    return (
        "" if _any(phrases, p.positive) and p.positive else f"positive {p.positive!r}, a rule has {'/'.join(phrases)}"
    )


def _at_rest(values: list[float | None], p: m.Parameter, _: object) -> str | None:
    if not p.at_rest:
        return None
    same = len(values) == len(p.at_rest) and all(a is None or a == b for a, b in zip(values, p.at_rest, strict=True))
    return "" if same else f"at rest {_listed(p.at_rest)}, a rule has {_listed(values)}"


def _listed(values: Iterable[float | None]) -> str:
    return ", ".join("~" if x is None else f"{x:g}" for x in values)


#: Components of a vector that are parameters of their own: the axis of their frame is the meaning of a positive value.
_AXES = ("north", "east", "down")


def _unit(units: list[str], p: m.Parameter, _: object) -> str | None:
    if p.any_unit:
        return None
    return "" if p.units and {*p.units} <= {*units} else f"unit {_all(p.units)}, a rule has {_all(units)}"


def _unit_of(pair: str, p: m.Parameter, record: tuple[m.Parameter, ...]) -> str | None:
    """Requires the unit of a similar parameter, whose name lacks this part or has another one instead."""
    old, _, new = pair.partition(" -> ")
    twin = next((q for q in record if q is not p and q.name == p.name.replace(old, new)), None)
    if twin is None or not twin.units:
        return None
    return "" if twin.units == p.units else f"unit {_all(p.units)}, that of {twin.name} is {_all(twin.units)}"


def _type(type_name: str, p: m.Parameter, _: object) -> str | None:
    scalar = _scalar(p)
    if not scalar:
        return None
    return "" if m.SCALARS[scalar].kind == type_name else f"type {scalar}, a rule has {type_name}"


def _default(defaults: list[str | float], p: m.Parameter, _: object) -> str | None:
    """Compares a default with the rule's number, or with the first of its names that is a value of the enumeration."""
    values = [v.name for v in p.element.values] if isinstance(p.element, m.Enum) else []
    wanted = next((x for x in defaults if x in values or not isinstance(x, str)), None)
    if wanted is None or p.default is None:
        return None
    return "" if p.default == wanted else f"default {p.default}, a rule has {wanted}"


def _flags(flag_name: str, p: m.Parameter, record: tuple[m.Parameter, ...]) -> str | None:
    """Checks that valid flags are in the order of the parameters: no bit is skipped, and no parameter between two with
    flags lacks one."""
    places = [(q, *_bits(q, record)) for q in record if q.valid]
    before = [last for q, _, last in places if record.index(q) < record.index(p)]
    after = [first for q, first, _ in places if record.index(q) > record.index(p)]
    if not p.valid:
        return None if not (before and after) else "no valid flag, a rule has one between two"
    first = _bits(p, record)[0]
    return "" if not before or first in (before[-1], before[-1] + 1) else f"valid by bit {first} after bit {before[-1]}"


def _bits(p: m.Parameter, record: tuple[m.Parameter, ...]) -> tuple[int, int]:
    """Returns the bits that validate a parameter's first and last elements; 0 for a bool."""
    numbers = []
    for path in (p.valid[0], p.valid[-1]):
        holder, _, name = path.partition(".")
        flags = next((q.element for q in record if q.name == holder), None)
        bits = flags.bits if isinstance(flags, m.Bitfield) else ()
        numbers.append(next((b.first for b in bits if b.name == name), 0))
    return numbers[0], numbers[1]


_SAYS: dict[str, Callable[[Any, m.Parameter, tuple[m.Parameter, ...]], str | None]] = {
    "range": _range,
    "if_range": _if_range,
    "frame": _frame,
    "reference": _reference,
    "positive": _positive,
    "at_rest": _at_rest,
    "unit": _unit,
    "unit_of": _unit_of,
    "type": _type,
    "default": _default,
    "flags": _flags,
}


def _all(units: Iterable[str]) -> str:
    return "/".join(units) or "none"


def _bounds(bounds: Any) -> str:
    low, high = bounds
    return f"{'none' if low is None else f'{low:g}'} to {'none' if high is None else f'{high:g}'}"
