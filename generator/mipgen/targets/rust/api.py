"""The Rust target's interface for other targets: names of fields and types, programs, and data for writing programs."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from mipgen import model as m
from mipgen.emit import symbols as words
from mipgen.emit.naming import upper
from mipgen.emit.symbols import Symbols

from . import names
from .snippets import Programs
from .view import Crate, part_names

__all__ = ["Programs", "symbol", "symbols", "writing"]


def symbol(thing: m.Type | m.Field) -> str:
    """Returns the path of a field's type, or of a type."""
    return f"mip_protocol::{names.home(thing)}::{names.type_name(thing.name)}"


def symbols(model: m.Model) -> Iterator[Symbols]:
    crate = model.derived(Crate)
    for x in words.types_and_fields(model):
        yield Symbols(x, symbol(x), tuple(_belonging(x, names.type_name(x.name), crate)))


def _belonging(x: m.Type | m.Field, name: str, crate: Crate) -> Iterator[str]:
    if isinstance(x, (m.Field, m.Struct)):
        record = crate.record(x)
        yield from (f"{name}::{method}" for method in record.methods)
        for union in record.unions:
            yield union.name
            yield from (f"{union.name}::{names.variant(k.tag.name)}" for k in union.of.cases)
    else:
        yield from (f"{name}::{part}" for part, _ in part_names(x))
    if isinstance(x, m.Field) and len(x.responses) > 1:
        yield names.response_type(x)


def writing(model: m.Model) -> dict[str, Any]:
    """Returns data for tools that write programs: names that differ between Rust and the specification, and unions."""
    return {
        "members": words.unusual_names(words.parameter_names(model), names.member),
        "constants": words.unusual_names(words.constant_names(model), names.constant, upper),
        "constructors": {f.name: names.constructor(f) for f in model.protocol.functions},
        "unions": _unions(model),
        "vectors": {t.name: names.path(t, "") for t in model.types if isinstance(t, m.Vector)},
        "variants": {tag: names.variant(tag) for tag in words.tag_names(model)},
    }


def _unions(model: m.Model) -> dict[str, str]:
    """Returns the union of each parameter; unions with the same alternatives in one module share a type."""
    crate, unions = model.derived(Crate), {}
    for r in model.records:
        for p in r.parameters:
            if p.union:
                where = names.home(r)
                unions[f"{r.full_name}.{p.name}"] = f"{where}::{crate.union(p.union, where).name}"
    return unions
