"""The Python target's interface for other targets: names of fields and types, programs, and data for writing
programs."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from mipgen import model as m
from mipgen.emit.naming import upper
from mipgen.emit.symbols import Symbols, constant_names, parameter_names, types_and_fields, unusual_names

from . import PACKAGE, attributes, names
from .snippets import Programs, local

__all__ = ["Programs", "symbol", "symbols", "writing"]


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


def writing(model: m.Model) -> dict[str, Any]:
    """Returns data for tools that write programs: names that differ between Python and the specification."""
    functions = [f.name for f in model.protocol.functions]
    modules = [names.module(x.name) for x in model.families]
    return {
        "modules": {module: local(module) for module in modules},
        "members": unusual_names([*parameter_names(model), *functions], names.member),
        "constants": unusual_names(constant_names(model), names.constant, upper),
    }
