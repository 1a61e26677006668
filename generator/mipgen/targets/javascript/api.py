"""The JavaScript target's interface for other targets: names of fields and types, and programs."""

from __future__ import annotations

from collections.abc import Iterator

from mipgen import model as m
from mipgen.emit.symbols import Symbols, named_parts, types_and_fields

from . import names
from .snippets import Programs

__all__ = ["Programs", "symbol", "symbols"]


def symbol(thing: m.Type | m.Field) -> str:
    """Returns the class of a field or the name of a type, prefixed with the module that exports it."""
    return f"mip-protocol/{names.home(thing)}.{names.class_name(thing)}"


def symbols(model: m.Model) -> Iterator[Symbols]:
    for x in types_and_fields(model):
        if isinstance(x, (m.Struct, m.Vector)):
            continue  # objects and arrays, which have a name in TypeScript only
        if isinstance(x, m.Field):
            others = [names.camel(f.name) for f in x.functions]
        else:
            others = [names.constant(part.name) for part in named_parts(x)]
        name = names.class_name(x)
        yield Symbols(x, symbol(x), tuple(f"{name}.{other}" for other in others))
