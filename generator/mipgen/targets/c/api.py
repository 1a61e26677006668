"""The C target's interface for other targets: names of fields and types, and programs in C and C++."""

from __future__ import annotations

from mipgen import model as m

from . import cpp, names
from .cpp_snippets import Programs as CppPrograms
from .snippets import Programs

__all__ = ["CppPrograms", "Programs", "cpp_symbol", "symbol"]


symbol = names.symbol


def cpp_symbol(thing: m.Type | m.Field) -> str:
    """Returns the C++ name of a field's type or of a type; empty for vectors, which are arrays, and for commands."""
    if isinstance(thing, m.Vector) or (isinstance(thing, m.Field) and thing.role == m.COMMAND):
        return ""
    return cpp.qualified(thing)
