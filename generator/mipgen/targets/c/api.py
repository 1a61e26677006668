"""The C target's interface for other targets: names of fields and types, programs in C and C++, and data for tools that
write programs."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from mipgen import model as m
from mipgen.emit.symbols import Symbols, constant_names, named_parts, parameter_names, types_and_fields, unusual_names

from . import calls, cpp, names
from .cpp_snippets import Programs as CppPrograms
from .identifiers import of_field, of_type
from .members import constructors
from .snippets import Programs

__all__ = ["CppPrograms", "Programs", "cpp_symbol", "cpp_symbols", "cpp_writing", "symbol", "symbols", "writing"]


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


def writing(model: m.Model) -> dict[str, Any]:
    """Returns data for tools that write programs: names that differ between C and the specification, and the calls."""
    words, commands = parameter_names(model), [f for f in model.fields if f.role == m.COMMAND]
    return {
        "scalars": {name: names.c_type(scalar) for name, scalar in m.SCALARS.items()},
        "headers": {x.name: names.module(x.name) for x in model.families},
        "members": unusual_names(words, names.member),
        "arguments": unusual_names(words, names.argument_name),
        "calls": {f.full_name: list(_calls(f, model)) for f in commands},
    }


def cpp_writing(model: m.Model) -> dict[str, Any]:
    """Returns the same for C++, without what it shares with C."""
    return {
        "members": unusual_names(parameter_names(model), cpp.word),
        "constants": unusual_names(constant_names(model), cpp.word),
    }


def _calls(f: m.Field, model: m.Model) -> Iterator[dict[str, Any]]:
    """Yields the functions that call a command, each with its C++ structure, function selector, arguments and decoded
    response. A command with only reserved values is passed as a whole structure."""
    made = constructors(f)
    for call in calls.calls(f, model):
        if call.whole and made:
            continue  # with optional parameters
        row: dict[str, Any] = {"name": call.name}
        if not call.whole:
            row["cpp"] = f"mip::{cpp.namespace(f.family)}::{cpp.command_name(f, call)}"
        if call.way is not None and call.way.function is not None:
            row["function"] = call.way.function.name
        if call.way is not None:
            row["takes"] = [p.name for p in call.parameters]
        if call.whole:
            row["whole"] = True
        if call.response is not None:
            row["response"] = call.response.full_name
        yield row
