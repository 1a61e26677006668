"""The Rust target's interface for other targets: names of fields and types, and programs."""

from __future__ import annotations

from collections.abc import Iterator

from mipgen import model as m
from mipgen.emit import symbols as words
from mipgen.emit.symbols import Symbols

from . import names
from .snippets import Programs
from .view import Crate, part_names

__all__ = ["Programs", "symbol", "symbols"]


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
