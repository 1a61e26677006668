"""The Rust target's interface for other targets: names of fields and types, programs, and data for writing programs."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from mipgen import model as m
from mipgen.emit import symbols as of
from mipgen.emit.naming import upper
from mipgen.emit.symbols import Symbols

from . import names
from .records import Records
from .snippets import Programs

__all__ = ["Programs", "symbol", "symbols", "writing"]


def symbol(thing: m.Type | m.Field) -> str:
    """Returns the path of a field's type, or of a type."""
    return f"mip_protocol::{names.home(thing)}::{names.type_name(thing.name)}"


def symbols(model: m.Model) -> Iterator[Symbols]:
    records = model.derived(Records)
    for x in of.things(model):
        yield Symbols(x, symbol(x), tuple(_belonging(x, names.type_name(x.name), records)))


def _belonging(x: m.Type | m.Field, name: str, records: Records) -> Iterator[str]:
    match x:
        case m.Enum():
            yield from (f"{name}::{names.constant(v.name)}" for v in x.values)
        case m.Bitfield():
            for b in x.bits:
                yield from (f"{name}::{names.constant(b.name)}", f"{name}::{names.method(b.name)}")
                yield from (f"{name}::set_{b.name}", f"{name}::with_{b.name}")
        case m.Field() | m.Struct():
            yield from (f"{name}::{c.name}" for c in records.constructors(x))
            yield from (f"{name}::with_{p.parameter.name}" for p in records.settable(x))
            yield from (f"{name}::{r.name}" for r in records.readings(x))
            for union in records.unions_of(x):
                yield union.name
                yield from (f"{union.name}::{names.variant(k.tag.name)}" for k in union.of.cases)
    if isinstance(x, m.Field) and len(x.responses) > 1:
        yield names.responses_name(x)


def writing(model: m.Model) -> dict[str, Any]:
    """Returns data for tools that write programs: names that differ between Rust and the specification, and unions."""
    return {
        "members": of.others(of.parameters(model), names.member),
        "constants": of.others(of.constants(model), names.constant, upper),
        "constructors": {f.name: names.constructor(f) for f in model.protocol.functions},
        "unions": _unions(model),
        "vectors": {t.name: names.path(t, "") for t in model.types if isinstance(t, m.Vector)},
        "variants": {tag: names.variant(tag) for tag in of.tags(model)},
    }


def _unions(model: m.Model) -> dict[str, str]:
    """Returns the union of each parameter; unions with the same alternatives in one module share a type."""
    records, unions = model.derived(Records), {}
    for r in of.records(model):
        for p in r.parameters:
            if p.union:
                where = names.home(r)
                unions[f"{r.full_name}.{p.name}"] = f"{where}::{records.union(p.union, where).name}"
    return unions
