"""The Python target's interface for other targets: names of fields and types, and programs."""

from __future__ import annotations

from collections.abc import Iterator

from mipgen import model as m
from mipgen.emit.symbols import Symbols, types_and_fields

from . import PACKAGE, attributes, names
from .snippets import Programs

__all__ = ["Programs", "symbol", "symbols"]


def symbol(thing: m.Type | m.Field) -> str:
    """Returns the class of a field or a type, as programs import it."""
    return f"{PACKAGE}.{names.qualified(thing).removeprefix('protocol.')}"


def symbols(model: m.Model) -> Iterator[Symbols]:
    for x in types_and_fields(model):
        of = names.class_name(x)
        if isinstance(x, m.Field):
            others = [names.member(f.name) for f in x.functions]
        else:
            others = [name for name, *_ in attributes(x)] if not isinstance(x, m.Struct) else []
        yield Symbols(x, f"{PACKAGE}.{names.qualified(x)}", tuple(f"{of}.{name}" for name in others))
