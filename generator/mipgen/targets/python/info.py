"""Descriptions of fields, structures, enumerations and bitfields at run time, in the `_meaning` modules."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from mipgen import model as m
from mipgen.facts import describe
from mipgen.lower import validity
from mipgen.lower.codec import in_numbers

from .names import class_name, constant, member, qualified


@dataclass(frozen=True, slots=True)
class Description:
    """The object that describes a class."""

    name: str  # of the class
    info: str  # the class of the object
    arguments: str
    parameters: list[str] | None  # of an object that has them


_QUOTED = json.JSONEncoder(ensure_ascii=False).encode


class Source(str):
    """A value as Python source."""


def quoted(value: object) -> str:
    """Like `repr`, but with double quotes around texts.

    >>> print(quoted((1, "a", {"b": ("it's",)}, Source("c"))))
    (1, "a", {"b": ("it's",)}, c)
    """
    match value:
        case Source():
            return value
        case str():
            return _QUOTED(value)
        case tuple():
            return f"({', '.join(map(quoted, value))}{',' if len(value) == 1 else ''})"
        case dict():
            return f"{{{', '.join(f'{quoted(k)}: {quoted(x)}' for k, x in value.items())}}}"
    return repr(value)


def _filled(values: dict[str, Any]) -> dict[str, Any]:
    return {k: v for k, v in values.items() if v not in (None, "", (), {}, False)}


# --------------------------------------------------------------------------- fields, enumerations, bitfields


def describe_class(thing: m.Enum | m.Bitfield | m.Struct | m.Field, model: m.Model) -> Description:
    match thing:
        case m.Enum() as t:
            deprecated = tuple(v.name for v in t.values if v.deprecated)
            return _description(
                t, "EnumInfo", {"deprecated": deprecated, "spelled": _spelled(v.name for v in t.values)}
            )
        case m.Bitfield() as t:
            attributes: dict[str, Any] = {
                "aliases": tuple(b.name for b in t.bits if b.alias),
                "spelled": _spelled(b.name for b in t.bits),
                "concerns": {b.name: b.concerns for b in t.bits if b.concerns},
                "numbers": {b.name: Source(qualified(b.enum)) for b in t.bits if b.enum},
                "states": {b.name: (b.when.parameter, b.when.numbers) for b in t.bits if b.when},
            }
            return _description(t, "BitsInfo", attributes)
        case m.Struct() as t:
            return _description(t, "StructureInfo", {}, [_parameter(p, t, model) for p in t.parameters])
        case f:
            attributes = {
                "functions": tuple(member(x.name) for x in f.functions),
                "devices": tuple(d.id for d in model.devices_of(f)),
                "likely": tuple(d.id for d in model.devices_of(f, "likely")),
                "assumed": tuple(d.id for d in model.devices_of(f, "assumed")),
                "deprecated": bool(f.deprecated),
                "advanced": f.advanced,
            }
            return _description(f, "FieldInfo", attributes, [_parameter(p, f, model) for p in f.parameters])


def _description(
    of: m.Type | m.Field, info: str, attributes: dict[str, Any], parameters: list[str] | None = None
) -> Description:
    named = [f"{name}={quoted(value)}" for name, value in _filled(attributes).items()]
    return Description(class_name(of), info, ", ".join([quoted(of.full_name), qualified(of), *named]), parameters)


def _spelled(names: Iterable[str]) -> dict[str, str]:
    """Returns the names that differ from the class's names in lower case."""
    return {constant(name): name for name in names if constant(name).lower() != name}


# --------------------------------------------------------------------------- parameters


def _parameter(p: m.Parameter, record: m.Record, model: m.Model) -> str:
    attributes = [f"{name}={quoted(value)}" for name, value in _attributes(p, record, model).items()]
    if p.tag:
        cases = [(c.tag.value, _parameter(c.parameter, record, model) if c.parameter else None) for c in p.cases]
        attributes.append(f"cases={{{''.join(f'{value}: {case}, ' for value, case in cases)}}}")
    return f"Parameter({', '.join([quoted(p.name), quoted(member(p.name)), quoted(p.kind), *attributes])})"


def _attributes(p: m.Parameter, record: m.Record, model: m.Model) -> dict[str, Any]:
    """Returns the attributes of a parameter without its name, kind and cases."""
    values = {
        "scalar": "" if p.leaf.struct or p.leaf.union else "bits" if p.leaf.kind == "bits" else p.leaf.scalar.name,
        "size": p.size if p.kind == "bits" else 0,
        "elements": p.elements,
        "length": p.length,
        "constant": p.constant,
        "counts": p.counts and member(p.counts),
        "tag": p.tag and member(p.tag),
        "units": m.unit_symbols(p.units),
        "valid": p.valid,
        "minimum": p.minimum,
        "maximum": p.maximum,
        "above": p.above,
        "below": p.below,
        "magnitude": p.magnitude if p.magnitude != (None, None) else None,
        "default": p.reserved if p.default is None else in_numbers(p.default, p.element),
        "frame": p.frame,
        "required": tuple(member(x.name) for x in p.required_for),
        "optional": p.optional,
        "reserved": p.reserved is not None,
        "deprecated": p.deprecated,
        "refers": p.shown if p.shown in ("set", "field") else "",
        "fields_of": p.fields_of,
    }
    numbers = ("length", "constant", "minimum", "maximum", "above", "below", "default")
    attributes = _filled(values) | {k: values[k] for k in numbers if values[k] is not None}  # which may be 0
    if t := p.leaf.named or p.leaf.struct:
        attributes["type"] = Source(qualified(t))
    readings = validity.readings([p], record)
    if readings and readings[-1].flags:
        attributes["flags"] = _flags(readings[-1].flags)
    if len(readings) > 1:
        sources = [f"Reading({quoted(r.devices)}, {quoted(_flags(r.flags))}, 0x{r.fewer:X})" for r in readings]
        attributes["readings"] = tuple(map(Source, sources))
    if variants := _variants(p, record, model):
        attributes["variants"] = Source(f"({', '.join(variants)},)")
    return attributes


def _variants(p: m.Parameter, record: m.Record, model: m.Model) -> list[str]:
    """Returns the differences by device or by another parameter."""
    variants = []
    for group, _ in describe.variants(p, record, model):
        v = group[0]
        keys = tuple(x.key for x in group) if v.by_device else (v.value,)
        arguments = [quoted(x) for x in (v.by if v.by_device else member(v.by), keys, _changes(v, p, record))]
        if v.member:
            arguments.append(f"member={quoted(member(v.member))}")
        variants.append(f"Variant({', '.join(arguments)})")
    return variants


def _changes(v: m.Variant, p: m.Parameter, record: m.Record) -> dict[str, object]:
    """Returns the attributes of a parameter that differ in a variant."""
    if v.member and isinstance(p.element, m.Struct):
        p = next(q for q in p.element.parameters if q.name == v.member)
    changes: dict[str, object] = {
        "elements": v.elements or None,
        "units": m.unit_symbols(v.units) or None,
        "frame": v.frame,
        "minimum": v.minimum,
        "maximum": v.maximum,
        "default": in_numbers(v.default, v.type or p.element),
        "valid": v.valid,
        "constant": v.constant,
        "only": tuple(x.name for x in v.only) or None,
        "deprecated": v.deprecated,
        "type": Source(qualified(v.type)) if v.type else Source(None) if v.unknown else None,
        "flags": _flags(validity.flags_named(v.valid, record)) if v.valid is not None and not v.by_device else None,
    }
    return {k: x for k, x in changes.items() if x is not None}


def _flags(flags: tuple[validity.Flag, ...]) -> tuple[Source, ...]:
    return tuple(Source(f"Flag({quoted(f.path)}, {quoted(member(f.parameter))}, 0x{f.mask:X})") for f in flags)
