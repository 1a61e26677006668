"""The C target's interface for other targets: names of fields and types, and programs in C and C++."""

from __future__ import annotations

from collections.abc import Iterator

from mipgen import model as m
from mipgen.emit.symbols import Symbols, named_parts, types_and_fields

from . import calls, cpp, names
from .cpp_snippets import Programs as CppPrograms
from .identifiers import of_field, of_type
from .snippets import Programs

__all__ = ["CppPrograms", "Programs", "cpp_symbol", "cpp_symbols", "symbol", "symbols"]


symbol = names.symbol


def cpp_symbol(thing: m.Type | m.Field) -> str:
    """Returns the C++ name of a field's type or of a type; empty for vectors, which are arrays, and for commands."""
    if isinstance(thing, m.Vector) or (isinstance(thing, m.Field) and thing.role == m.COMMAND):
        return ""
    return cpp.qualified(thing)


def symbols(model: m.Model) -> Iterator[Symbols]:
    for x in types_and_fields(model):
        if isinstance(x, m.Field):
            others = [i.name for i in of_field(x, model) if i.scope == "C"] + [*calls.identifiers(x, model)]
            name = symbol(x)
        elif isinstance(x, m.Vector):
            continue  # an array
        else:
            typed = not isinstance(x, m.Enum) or names.is_enum(x)  # else it has constants, but no type
            others = [i.name for i in of_type(x, model) if i.scope == "C" and (typed or i.name != symbol(x))]
            name = symbol(x) if typed else f"{symbol(x)}_name"
        yield Symbols(x, name, tuple(n for n in others if n != name))


def cpp_symbols(model: m.Model) -> Iterator[Symbols]:
    """Yields the same for C++: for a command, the structures to send; for other fields, the functions that read
    values."""
    for x in types_and_fields(model):
        if isinstance(x, m.Vector):
            continue
        others = [cpp.word(v.name) for v in named_parts(x)] if not isinstance(x, m.Field) else []
        name = cpp.qualified(x)
        if isinstance(x, m.Field) and x.role == m.COMMAND:
            name, *others = [f"{cpp.scope(x)}::{c.name}" for c in cpp.commands(x, model)] or [name]
        elif isinstance(x, m.Field):
            others = [f"{a.name}()" for a in cpp.accessors(x)]
        elif names.in_bytes(x):
            others = [f"{name}_bits::{other}" for other in others]
        elif not isinstance(x, m.Struct):
            others = [f"{name}::{other}" for other in others]
        yield Symbols(x, name, tuple(others))
