"""Every name that the output defines in C. All are in one scope, except the members of structures."""

from __future__ import annotations

from collections.abc import Iterator

from mipgen import model as m
from mipgen.emit.naming import Identifier
from mipgen.lower.memory import members

from . import calls, cpp, names, runtime, tables
from .direct import direct
from .members import constructors, has_accessor, last_present
from .names import (  # fmt: skip
    accessor,
    constant,
    field_name,
    macro,
    member,
    set_constant,
    symbol,
    type_name,
    union_name,
)


def identifiers(model: m.Model) -> Iterator[Identifier]:
    for name in runtime.names():
        yield Identifier("C", name, f"{name} of the core", None)
    for t in (*model.types, model.protocol.function_selector):
        yield from of_type(t)
    yield from of_field(model.protocol.acknowledge)
    for s in model.sets:
        yield Identifier("C", set_constant(s), f"set {s.name}", s.position)
    for x in model.families:
        for t in x.types:
            yield from of_type(t)
        for f in x.fields:
            yield from of_field(f)
            for name in calls.identifiers(f, model):
                yield Identifier("C", name, f.full_name, f.position)
    for d in model.devices:
        yield Identifier("C", f"mip_profile_{d.name}", f"device {d.id}", d.position)
    yield from cpp.identifiers(model)
    yield from package(model)


def package(model: m.Model) -> Iterator[Identifier]:
    """Yields the name of the package, which `rename` puts in the place of `mip`, and those that it cannot have."""
    for place, taken in names.LANGUAGE["packages"].items():
        for name in taken:
            yield Identifier(place, name, f"{name} of {place}", None, word=False)
        yield Identifier(place, "mip", "the package", model.protocol.position, word=place == "C++")


def of_type(t: m.Type) -> Iterator[Identifier]:
    name, place = type_name(t), getattr(t, "position", None)
    yield Identifier("C", name, t.name, place)
    if isinstance(t, (m.Enum, m.Bitfield)):
        yield Identifier("C", tables.names(t), t.name, place)
    if isinstance(t, m.Enum):
        yield Identifier("C", f"{name}_name", t.name, place)
        for v in t.values:
            yield Identifier("C", constant(t, v), f"{t.name}.{v.name}", v.position)
    elif isinstance(t, m.Bitfield):
        for b in t.bits:
            yield Identifier("C", constant(t, b), f"{t.name}.{b.name}", b.position)
            for verb in ("get", "set") if has_accessor(b, t) else ():
                yield Identifier("C", accessor(t, verb, b), f"{t.name}.{b.name}", b.position)
    elif isinstance(t, m.Struct):
        yield from _members(t)


def of_field(f: m.Field) -> Iterator[Identifier]:
    name = field_name(f)
    yield Identifier("C", name, f.full_name, f.position)
    yield Identifier("C", macro(name), f.full_name, f.position)
    for end in ("DESCRIPTOR", "NAME", *(macro(f"with_{p.name}") for p, _ in last_present(f))):
        yield Identifier("C", f"{macro(name)}_{end}", f.full_name, f.position)
    both = ("decode", "encode")
    inline = [f"{end}_inline" for end in both] if direct(f) else []
    for end in ("codec", *both, *inline, *(c.name for c in constructors(f))):
        yield Identifier("C", f"{name}_{end}", f.full_name, f.position)
    yield from _members(f)


def _members(record: m.Record) -> Iterator[Identifier]:
    scope = f"struct {symbol(record)}"
    for p in members(record):
        yield Identifier(scope, member(p.name), p.name, p.position)
        if p.fills:
            yield Identifier(scope, f"{member(p.name)}_count", p.name, p.position)
        if p.element is None:
            yield Identifier("C", union_name(p, record), p.name, p.position)
            for a in p.alternatives:
                yield Identifier(f"union {union_name(p, record)}", member(a.name), a.name, p.position)
