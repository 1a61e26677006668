"""Rows of the `_meaning` modules: descriptions of fields, structures, enumerations and bitfields at run time.

A row contains the attributes of an object from `info` or `parameter` as Python source, without empty ones.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import Any

from mipgen import model as m
from mipgen.facts import describe
from mipgen.lower.numbers import in_numbers

from .names import constant, member, qualified

Row = dict[str, str]


def shown(values: dict[str, Any]) -> Row:
    """Returns the values as Python source, without empty ones."""
    return {k: code(v) for k, v in values.items() if v not in (None, "", (), False)}


def code(value: object) -> str:
    """Like `repr`, but with double quotes around texts.

    >>> print(code((1, "a", ("it's",))))
    (1, "a", ("it's",))
    """
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, tuple):
        return f"({', '.join(map(code, value))}{',' if len(value) == 1 else ''})"
    return repr(value)


# --------------------------------------------------------------------------- fields, enumerations, bitfields


def of_field(f: m.Field, model: m.Model) -> Row:
    return shown(
        {
            "functions": tuple(member(x.name) for x in f.functions),
            "devices": tuple(d.id for d in model.devices_of(f)),
            "perhaps": tuple(d.id for d in model.devices_of(f, certain=False)),
            "deprecated": bool(f.deprecated),
            "advanced": f.advanced,
            "max_rate": f.max_rate,
        }
    )


def of_enumeration(t: m.Enum) -> Row:
    deprecated = tuple(v.name for v in t.values if v.deprecated)
    return shown({"deprecated": deprecated}) | _spelled(v.name for v in t.values)


def of_bitfield(t: m.Bitfield) -> Row:
    numbers = {b.name: qualified(b.enum) for b in t.bits if b.enum}
    row = shown({"aliases": tuple(b.name for b in t.bits if b.alias)}) | _spelled(b.name for b in t.bits)
    concerns = {b.name: code(b.concerns) for b in t.bits if b.concerns}
    row |= {"concerns": _mapping(concerns)} if concerns else {}
    return row | ({"numbers": _mapping(numbers)} if numbers else {})


def _spelled(names: Iterable[str]) -> Row:
    """Returns the names that differ from the class's names in lower case."""
    other = {constant(name): code(name) for name in names if constant(name).lower() != name}
    return {"spelled": _mapping(other)} if other else {}


# --------------------------------------------------------------------------- parameters


def of_parameter(p: m.Parameter, record: m.Record, model: m.Model) -> Row:
    """Returns the description of a parameter without its name, kind and cases."""
    values = {
        "scalar": _scalar(p.leaf),
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
    zero = {k: code(values[k]) for k in ("length", "constant", "minimum", "maximum", "above", "below", "default")
            if values[k] is not None}  # fmt: skip
    row = shown(values) | zero
    if t := p.leaf.named or p.leaf.struct:
        row["type"] = qualified(t)
    vouching = flags(p.valid, record)
    if vouching:
        row["flags"] = _flags(vouching)
    row |= _variants(p, record, model)
    return row


def _scalar(p: m.Parameter) -> str:
    if p.struct or p.union:
        return ""
    return "bits" if p.kind == "bits" else p.scalar.name


def _variants(p: m.Parameter, record: m.Record, model: m.Model) -> Row:
    """Returns the differences by device or by another parameter, and the valid flags that some devices define
    differently."""
    rows = []
    for group, _ in describe.variants(p, record, model):
        v = group[0]
        keys = tuple(x.key for x in group) if v.by_device else (v.value,)
        changes = _changes(v, p, record)
        by = v.by if v.by_device else member(v.by)
        arguments = [code(by), code(keys), _mapping(changes)]
        if v.member:
            arguments.append(f"member={code(member(v.member))}")
        rows.append(f"Variant({', '.join(arguments)})")
    row: Row = {"variants": f"({', '.join(rows)},)"} if rows else {}
    others = _flags_on(p, record)
    if others:
        row["flags_on"] = _mapping({d: _flags(x) for d, x in others.items()})
    return row


def _mapping(row: Row) -> str:
    return f"{{{', '.join(f'{code(k)}: {x}' for k, x in row.items())}}}"


def _changes(v: m.Variant, p: m.Parameter, record: m.Record) -> Row:
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
    }
    row = {k: code(x) for k, x in changes.items() if x is not None}
    if v.type is not None:
        row["type"] = qualified(v.type)
    elif v.unknown:
        row["type"] = "None"
    if v.valid is not None and not v.by_device:
        row["flags"] = _flags(flags(v.valid, record))
    return row


# --------------------------------------------------------------------------- valid flags

Flags = list[tuple[str, str, int]]


def flags(paths: Iterable[str], record: m.Record, device: str | None = None) -> Flags:
    """Returns path, attribute and mask of each flag that marks a value as valid; the mask of a bool is 0.

    Empty if the bit depends on the device and the device is not known.
    """
    flags = []
    for path in paths:
        name, _, bit = path.partition(".")
        mask = _mask(next(q for q in record.parameters if q.name == name), bit, device) if bit else 0
        if mask is None:
            return []
        flags.append((path, member(name), mask))
    return flags


def _mask(holder: m.Parameter, bit: str, device: str | None) -> int | None:
    """Returns the mask of a bit on the device; None if it depends on the device and the device is not known."""
    own = next((v.type for v in holder.readings if v.by_device and v.key == device), None)
    types: list[object] = [own or holder.element]
    if not own and not _masks(types, bit):
        types = [*(v.type for v in holder.readings)]
    masks = set(_masks(types, bit))
    return masks.pop() if len(masks) == 1 else None


def _masks(types: Iterable[object], bit: str) -> list[int]:
    return [b.mask for t in types if isinstance(t, m.Bitfield) for b in t.bits if b.name == bit]


def _flags_on(p: m.Parameter, record: m.Record) -> dict[str, Flags]:
    """Returns the flags on devices where a parameter has a different valid flag, or its flag is a different bit."""
    own = {v.key: v.valid for v in p.variants if v.by_device and v.valid is not None and not v.member}
    holders = {path.partition(".")[0] for paths in (p.valid, *own.values()) for path in paths}
    readings = (v for q in record.parameters if q.name in holders for v in q.readings if v.by_device)
    usual = flags(p.valid, record)
    by_device = {d: flags(own.get(d, p.valid), record, d) for d in dict.fromkeys((*own, *(v.key for v in readings)))}
    return {d: vouching for d, vouching in by_device.items() if vouching != usual}


def _flags(flags: Flags) -> str:
    rows = [f"Flag({code(path)}, {code(attribute)}, 0x{mask:X})" for path, attribute, mask in flags]
    return f"({', '.join(rows)}{',' if len(rows) == 1 else ''})"


# --------------------------------------------------------------------------- names


def fields(model: m.Model) -> list[m.Field]:
    return [*model.fields, model.protocol.acknowledge]


def called(d: m.Device) -> tuple[str, ...]:
    """Returns the title of a device and its other names."""
    return (d.title, *d.also)


def named(d: m.NamedDevice) -> tuple[str, ...]:
    """Returns the device that is most like it, its title and its other names."""
    return (d.like, d.title, *d.also)
