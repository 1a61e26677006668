"""Every name that the output defines in C. All are in one scope, except the members of structures."""

from __future__ import annotations

from collections.abc import Iterator

from mipgen import model as m
from mipgen.emit.naming import Identifier
from mipgen.lower.memory import stored

from . import calls, cpp, names, runtime
from .direct import is_direct
from .members import constructors, has_accessor, last_present, write_from_response
from .names import (
    accessor,
    constant,
    field_name,
    macro,
    member,
    names_table,
    set_constant,
    symbol,
    type_name,
    union_name,
    union_owner,
)

#: What the names of every command end with, so that none of its constructors can.
ENDS = ("codec", "command", "decode", "decode_inline", "encode", "encode_inline", "exchange")


def identifiers(model: m.Model) -> Iterator[Identifier]:
    for name in runtime.runtime_names():
        yield Identifier("C", name, f"{name} of the core", None)
    for end in ENDS:
        yield Identifier("the names of a command", end, f"{end} of every command", None)
    for function in model.protocol.functions:
        what = f"function {function.name}"
        yield Identifier("the names of a command", function.name, what, function.position, word=False)
    for t in (*model.types, model.protocol.function_selector):
        yield from of_type(t, model)
    yield from of_field(model.protocol.acknowledge, model)
    for s in model.sets:
        yield Identifier("C", set_constant(s), f"set {s.name}", s.position)
    for x in model.families:
        for t in x.types:
            yield from of_type(t, model)
        for f in x.fields:
            yield from of_field(f, model)
            for name in calls.identifiers(f, model):
                yield Identifier("C", name, f.full_name, f.position)
    for d in model.devices:
        yield Identifier("C", f"mip_profile_{d.name}", f"device {d.id}", d.position)
    yield from cpp.identifiers(model)
    yield from package_names(model)


def package_names(model: m.Model) -> Iterator[Identifier]:
    """Yields the name of the package, which `rename` puts in the place of `mip`, and those that it cannot have."""
    for place, taken in names.LANGUAGE["packages"].items():
        for name in taken:
            yield Identifier(place, name, f"{name} of {place}", None, word=False)
        yield Identifier(place, "mip", "the package", model.protocol.position, word=place == "C++")


def of_type(t: m.Type, model: m.Model) -> Iterator[Identifier]:
    place, own = getattr(t, "position", None), [type_name(t)]
    own += [names_table(t)] if isinstance(t, (m.Enum, m.Bitfield)) else []
    own += [f"{type_name(t)}_name"] if isinstance(t, m.Enum) else []
    yield from (Identifier("C", name, t.name, place) for name in own)
    if isinstance(t, m.Enum):
        for v in t.values:
            yield Identifier("C", constant(t, v), f"{t.name}.{v.name}", v.position)
    elif isinstance(t, m.Bitfield):
        for b in t.bits:
            accessors = [accessor(t, verb, b) for verb in ("get", "set") if has_accessor(b, t)]
            yield from (Identifier("C", n, f"{t.name}.{b.name}", b.position) for n in (constant(t, b), *accessors))
    elif isinstance(t, m.Struct):
        yield from _members(t, model)


def of_field(f: m.Field, model: m.Model) -> Iterator[Identifier]:
    name, inline = field_name(f), ("decode_inline", "encode_inline") if is_direct(f) else ()
    macros = ("descriptor", *(f"with_{p.name}" for p, _ in last_present(f)))
    ends = ("codec", "decode", "encode", *inline, *(c.name for c in constructors(f) if c.name not in ENDS))
    fills = [w.name for w in [write_from_response(f, model)] if w]
    for own in (name, macro(name), *(macro(f"{name}_{x}") for x in macros), *(f"{name}_{end}" for end in ends), *fills):
        yield Identifier("C", own, f.full_name, f.position)
    yield from _members(f, model)


def _members(record: m.Record, model: m.Model) -> Iterator[Identifier]:
    scope = f"struct {symbol(record)}"
    for p in stored(record):
        yield Identifier(scope, member(p.name), p.name, p.position)
        if p.fills:
            yield Identifier(scope, f"{member(p.name)}_count", p.name, p.position)
        if p.element is None and union_owner(p, record, model) is record:
            yield Identifier("C", union_name(p, record), p.name, p.position)
            for a in p.alternatives:
                yield Identifier(f"union {union_name(p, record)}", member(a.name), a.name, p.position)
