"""Converts the model to JSON values. References in the model become names.

An attribute is omitted if it has its default: null, false, or an empty text or list. All other attributes of the
model's classes are written, so that nothing is forgotten; the exceptions are listed here.
"""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from operator import attrgetter
from typing import Any

from mipgen import model as m
from mipgen.emit.target import Identifier
from mipgen.facts import describe
from mipgen.facts.sample_values import SampleValues
from mipgen.lower import validity
from mipgen.lower.lists import Listing, listings
from mipgen.lower.session import Rate, session
from mipgen.model import guides, simulation
from mipgen.model.simulation import Quantity
from mipgen.targets.c import api as c
from mipgen.targets.javascript import api as javascript
from mipgen.targets.python import api as python
from mipgen.targets.rust import api as rust

#: The version of the document's format, which the README explains; the schema states it too.
FORMAT = "1.0"

#: Attributes that are not written: positions in the sources, and those written in another place or form.
LEFT_OUT: dict[type, tuple[str, ...]] = {
    m.Parameter: ("element", "typical", "most", "stated"),  # typical values are with the calls of fields
    Quantity: ("typical",),
    m.Field: ("family", "occurrences", "everywhere", "functions"),
    m.Struct: ("owner",),
    m.Enum: ("owner",),
    m.Bitfield: ("owner",),
    m.Device: ("variants", "evidence", "supports", "refuses"),  # a variant is with its parameter
    m.Support: ("field", "set", "functions", "evidence"),
    m.Word: ("equals",),
    simulation.Source: ("set",),
    m.Erratum: ("named",),  # in its texts
    m.Variant: ("only",),
    guides.Shown: ("data",),  # in the packet
    guides.Guide: ("picture",),  # on its page only
}

#: Attributes that are written under another name: a union is represented by its tag.
RENAMED = {"union": "tag"}


@dataclass(frozen=True)
class Document:
    """What the templates print."""

    model: m.Model
    format = FORMAT

    @cached_property
    def text(self) -> str:
        """The document, with one line for each item of a list."""
        parts = ",\n".join(f"{json.dumps(key)}: {_laid_out(value)}" for key, value in _parts(self.model).items())
        return f"{{\n{parts}\n}}"

    @cached_property
    def example(self) -> str:
        """A short field with a selector and an enumeration, with one line for each attribute."""
        fields = self.model.fields
        commands = [f for f in fields if f.functions and any(isinstance(p.element, m.Enum) for p in f.counted)]
        attributes = _with_samples(
            min(commands or fields, key=lambda f: len(f.parameters)), self.model.derived(SampleValues)
        )
        return "{\n" + ",\n".join(f"  {json.dumps(k)}: {line(v)}" for k, v in attributes.items()) + "\n}"


def _laid_out(value: Any) -> str:
    if isinstance(value, list) and value:
        return "[\n" + ",\n".join(map(line, value)) + "\n]"
    if isinstance(value, dict) and value and all(isinstance(v, (dict, list)) for v in value.values()):
        return "{\n" + ",\n".join(f"{json.dumps(k)}: {_laid_out(v)}" for k, v in value.items()) + "\n}"
    return line(value)


#: Writes a value on one line.
line = json.JSONEncoder(ensure_ascii=False, separators=(",", ":")).encode


def _parts(model: m.Model) -> dict[str, Any]:
    p, samples = model.protocol, model.derived(SampleValues)
    return {
        "$schema": "mip.schema.json",
        "format": FORMAT,
        "name": p.name,
        "title": p.title,
        "package": p.package,
        "version": p.version,
        "packet": {"sync": list(p.sync), "max_payload": p.max_payload, "max_field_data": m.MAX_FIELD_DATA},
        "acknowledge": p.acknowledge.full_name,
        "barrier": dict(zip(("set", "descriptor"), p.barrier, strict=True)),
        "ack_code": type_name(p.ack_code),
        "function_selector": type_name(p.function_selector),
        **_session(model),
        "lists": [_list(x) for x in listings(model)],
        "scalars": {s.name: {"size": s.size, "kind": s.kind} for s in m.SCALARS.values()},
        "functions": [_attributes(f) for f in p.functions],
        "units": json_value(p.units),
        "frames": json_value(p.frames),
        "manuals": json_value(p.manuals),
        "notes": json_value(p.notes),
        "vocabulary": json_value(p.vocabulary),
        "synonyms": json_value(p.synonyms),
        "clocks": [_clock(c, model) for c in p.clocks],
        "leap_seconds": dict(p.leap_seconds),
        "types": [_attributes(t) for t in types(model)],
        "sets": [_set(s, model) for s in model.sets],
        "fields": [_with_samples(f, samples) for f in (p.acknowledge, *model.fields)],
        "devices": [_device(d, model) for d in model.devices],
        "named_devices": [_attributes(d) for d in model.named],
        "examples": [_attributes(x) for x in model.examples],
        "errata": [_attributes(e) for e in model.errata],
        "simulation": _attributes(model.simulation),
        "guides": [_attributes(g) for g in model.guides],
    }


def _session(model: m.Model) -> dict[str, Any]:
    """Returns the commands that start data, if the specification names them."""
    start = session(model)
    if start is None:
        return {}
    item = start.entries.item.struct
    assert item is not None
    older = [
        {"set": x.set, **_rate(x.base_rate), "format": x.format.full_name, "stream": x.stream} for x in start.older
    ]
    commands = {"identify": start.identify, "format": start.format, "stream": start.stream, "resume": start.resume}
    names = {key: f.full_name for key, f in commands.items()}
    more = {"descriptors": json_value(start.descriptors), "item": type_name(item), "older": older}
    return {"session": {**_rate(start.base_rate), **names, **more}}


def _list(x: Listing) -> dict[str, Any]:
    """Returns the places of the fields that a command lists; attributes that do not apply are omitted."""
    values = {f.name: getattr(x, f.name) for f in dataclasses.fields(x)} | {"command": x.command.full_name}
    if x.set is not None:
        del values["set_at"]
    if x.first is None or x.count_at is None:
        del values["stride"]
    if x.tag_at is None:
        del values["tag"]
    return {name: value for name, value in values.items() if value is not None}


def _rate(r: Rate) -> dict[str, str]:
    return {"base_rate": r.command.full_name, "rate": r.parameter.name}


def types(model: m.Model) -> list[m.Type]:
    """Returns all types, each after those that it uses."""
    selector, *rest = model.protocol.function_selector, *model.all_types
    codes = [] if model.protocol.ack_code in rest else [model.protocol.ack_code]
    return [selector, *codes, *rest]


def identifiers(model: m.Model) -> Iterator[Identifier]:
    """Yields the names that references to fields and types use. Scalars are types too."""
    for f in (model.protocol.acknowledge, *model.fields):
        yield Identifier("fields", f.full_name, f"field {f.full_name}", f.position)
    for name in m.SCALARS:
        yield Identifier("types", name, f"scalar {name}", None)
    for t in types(model):
        yield Identifier("types", type_name(t), f"type {t.name}", t.position)


# --------------------------------------------------------------------------- values


def json_value(value: Any) -> Any:
    """Converts a value inside another; an object that is listed elsewhere is represented by its name."""
    kind = type(value)
    if kind in (str, int, float, bool):
        return value
    if kind in _PLAIN:
        return _PLAIN[kind](value)
    if isinstance(value, (tuple, list)):
        return [json_value(v) for v in value]
    return _attributes(value) if dataclasses.is_dataclass(kind) else value


def _source(source: simulation.Source) -> dict[str, Any]:
    return _attributes(source) | ({"field": source.field.name_in(source.set)} if source.set is not None else {})


def type_name(t: m.Scalar | m.Type) -> str:
    """Returns the name of a type, prefixed with the set that owns it."""
    return t.name if isinstance(t, m.Scalar) else t.full_name


#: Class -> the value that represents an object inside another.
_PLAIN: dict[type, Callable[[Any], Any]] = {
    m.Field: attrgetter("full_name"),
    **dict.fromkeys((m.Scalar, m.Enum, m.Bitfield, m.Vector, m.Struct), type_name),
    **dict.fromkeys((m.Function, m.Set), attrgetter("name")),
    m.Union: attrgetter("tag"),
    m.Device: attrgetter("id"),
    m.Unit: attrgetter("symbol"),
    simulation.Source: _source,
    bytes: bytes.hex,
    dict: lambda values: {key: json_value(v) for key, v in values.items()},
}


def _attributes(thing: Any) -> dict[str, Any]:
    """Returns the attributes of an object of the model, and the added ones."""
    attributes = {
        RENAMED.get(name, name): json_value(v)
        for name, default in _written(type(thing))
        if (v := getattr(thing, name)) is not default and _is_written(v, default)  # most are the default itself
    }
    more = _MORE.get(type(thing))
    return more(thing, attributes) if more else attributes


#: Class -> the attributes that are written, and their defaults.
_WRITTEN: dict[type, list[tuple[str, Any]]] = {}


def _written(kind: type) -> list[tuple[str, Any]]:
    if kind not in _WRITTEN:
        left_out = ("position", *LEFT_OUT.get(kind, ()))
        _WRITTEN[kind] = [(f.name, f.default) for f in dataclasses.fields(kind) if f.name not in left_out]
    return _WRITTEN[kind]


def _behind(attributes: dict[str, Any], place: str, name: str, value: Any) -> dict[str, Any]:
    """Returns the attributes with one more after the attribute `place`."""
    at = [*attributes].index(place) + 1
    items = [*attributes.items()]
    return dict([*items[:at], (name, value), *items[at:]])


def _is_written(value: Any, default: Any) -> bool:
    return value is not None and not (type(value) is type(default) and value == default)


def _variant(v: m.Variant, attributes: dict[str, Any]) -> dict[str, Any]:
    return {**attributes, "only": [x.name for x in v.only]} if v.only else attributes


def _word(w: m.Word, attributes: dict[str, Any]) -> dict[str, Any]:
    return attributes if w.key != w.symbol else {name: value for name, value in attributes.items() if name != "key"}


def _vector(t: m.Vector, attributes: dict[str, Any]) -> dict[str, Any]:
    return {"kind": t.kind, **attributes}


def _type(t: m.Enum | m.Bitfield | m.Struct, attributes: dict[str, Any]) -> dict[str, Any]:
    return {"kind": t.kind, **attributes, "name": type_name(t), "symbols": symbols(t)}


def _struct(t: m.Struct, attributes: dict[str, Any]) -> dict[str, Any]:
    return _type(t, _record(t, attributes))


def _record(r: m.Record, attributes: dict[str, Any]) -> dict[str, Any]:
    """Adds the codec's operations, and the valid flags of parameters that have others on some devices."""
    for p, shown in zip(r.parameters, attributes["parameters"], strict=True):
        readings = validity.readings([p], r)
        if len(readings) > 1:
            shown["readings"] = [_reading(x) for x in readings]
    return _behind(attributes, "parameters", "operations", operations(r))


def _reading(r: validity.Reading) -> dict[str, Any]:
    flags = [dataclasses.asdict(flag) for flag in r.flags]
    return {"devices": list(r.devices), "flags": flags, "fewer": r.fewer}


def _parameter(p: m.Parameter, attributes: dict[str, Any]) -> dict[str, Any]:
    head = {"name": attributes.pop("name"), **({"type": type_name(p.element)} if p.element is not None else {})}
    cases = [{"tag": c.tag.name, **({"parameter": json_value(c.parameter)} if c.parameter else {})} for c in p.cases]
    return {**head, **attributes, **({"cases": cases} if cases else {})}


def _field(f: m.Field, attributes: dict[str, Any]) -> dict[str, Any]:
    """Adds the attributes of a field. Names of its responses or of its command become full names."""
    attributes = _record(f, attributes)
    attributes = {"set": f.set, **attributes, "name": f.full_name, "symbols": symbols(f)}
    if len(f.names) > 1:
        attributes["occurrences"] = [_occurrence(o, f) for o in f.occurrences]
    if f.functions:
        attributes["calls"] = [
            {"function": c.function.name, "required": _names(c.required), "optional": _names(c.optional)}
            for c in f.calls
            if c.function is not None
        ]
    if f.responses:
        attributes["responses"] = [f"{f.family}.{name}" for name in f.responses]
    if f.command:
        attributes["command"] = f"{f.family}.{f.command}"
    if f.signature:
        attributes["constants"] = [
            {"offset": at, "size": len(octets), "value": int.from_bytes(octets, "big")} for at, octets in f.signature
        ]
    return attributes


#: Class -> the function that adds attributes to those of an object.
_MORE: dict[type, Callable[[Any, dict[str, Any]], dict[str, Any]]] = {
    m.Word: _word,
    m.Parameter: _parameter,
    m.Field: _field,
    m.Variant: _variant,
    m.Vector: _vector,
    m.Struct: _struct,
    m.Enum: _type,
    m.Bitfield: _type,
}


def _clock(c: m.Clock, model: m.Model) -> dict[str, Any]:
    """Returns a clock, without timestamps that a part of a specification lacks."""
    return _attributes(c) | {"timestamps": [name for name in c.timestamps if model.field(name)]}


def _set(s: m.Set, model: m.Model) -> dict[str, Any]:
    """Returns a set with the fields that occur in it and the types of its family."""
    family = model.family(s.family)
    assert family is not None
    more = {"types": json_value(family.types), "fields": json_value(model.fields_in(s))}
    return _attributes(s) | more | ({"named": json_value(family.named)} if family.named else {})


def _occurrence(o: m.Occurrence, f: m.Field) -> dict[str, Any]:
    attributes = _attributes(o)
    del attributes["set_name"]
    if o.title == f.title:
        del attributes["title"]
    return {"set": o.set, "name": f.name_in(o.set)} | attributes


def _with_samples(f: m.Field, samples: SampleValues) -> dict[str, Any]:
    """Returns a field with the values that a user would send or see."""
    attributes = _attributes(f)
    values = [samples.whole(f, c) for c in f.calls]
    if f.functions:
        calls = zip(attributes["calls"], values, strict=True)
        attributes["calls"] = [{**c, "typical": v} if v else c for c, v in calls]
    elif values[0]:
        attributes["typical"] = values[0]
    return attributes


def _device(d: m.Device, model: m.Model) -> dict[str, Any]:
    """Returns a device; statements about a field refer to their evidence by its index in the list."""
    attributes = _attributes(d)
    if d.evidence:
        attributes["evidence"] = [
            {"answer": e.answer, **_attributes(e), **_absence(e), "why": describe.why(e, model)} for e in d.evidence
        ]
    distinct = {id(s.evidence): s.evidence for s in (*d.supports, *d.refuses)}
    places = {key: d.evidence.index(evidence) for key, evidence in distinct.items()}
    for name, statements in (("supports", d.supports), ("refuses", d.refuses)):
        if statements:
            attributes[name] = [_support(s, places[id(s.evidence)]) for s in statements]
    return attributes


def _absence(e: m.Evidence) -> dict[str, str]:
    return {"absence": e.absence} if e.absence else {}


def _support(s: m.Support, evidence: int) -> dict[str, Any]:
    functions = {"functions": _names(s.functions)} if s.differs else {}
    return {"field": s.name, "evidence": evidence, **functions, **_attributes(s)}


def _names(things: Iterable[m.Parameter | m.Function]) -> list[str]:
    return [x.name for x in things]


# --------------------------------------------------------------------------- operations


#: Attributes of an operation by the kind of its parameter: name in the document -> name in the model.
_OPERATIONS: dict[m.Shape, dict[str, str]] = {
    "scalar": {"scalar": "scalar", "type": "named"},
    "constant": {"scalar": "scalar", "value": "constant"},
    "counter": {"scalar": "scalar", "array": "counts"},
    "bits": {"type": "named", "size": "size"},
    "text": {"count": "count", "counter": "counter", "capacity": "capacity"},
    "array": {"item": "item", "count": "count", "counter": "counter", "capacity": "capacity", "vector": "vector"},
    "struct": {"struct": "struct"},
    "switch": {"tag": "tag"},
}


def operations(record: m.Field | m.Struct) -> list[dict[str, Any]]:
    """Returns the steps of a codec: the parameters as it reads and writes them, without their meaning."""
    groups = [
        {"kind": "group", "first": g.first, "last": g.last, "body": [*map(_operation, g.parameters)]}
        for g in record.groups
    ]
    return [*map(_operation, record.always), *groups]


def _operation(p: m.Parameter) -> dict[str, Any]:
    attributes: dict[str, Any] = {"kind": p.kind, "member": p.name}
    for name, attribute in _OPERATIONS[p.kind].items():
        value = getattr(p, attribute)
        if value is not None:
            attributes[name] = _operation(value) if name == "item" else json_value(value)
    if p.union:
        attributes["tag_type"] = json_value(p.union.type)
        attributes["cases"] = [_case(c) for c in p.cases]
    return attributes


def _case(c: m.Case) -> dict[str, Any]:
    return {"value": c.tag.value, **({"operation": _operation(c.parameter)} if c.parameter else {})}


def symbols(thing: m.Type | m.Field) -> dict[str, str]:
    """Returns the names in the bindings of a field's type, or of a type. C++ has no type for a command, but one for
    each way to send it."""
    names = {"c": c.symbol(thing), "cpp": c.cpp_symbol(thing), "python": python.symbol(thing)}
    names |= {"rust": rust.symbol(thing), "javascript": javascript.symbol(thing)}
    return {language: name for language, name in names.items() if name}
