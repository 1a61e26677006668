"""The names of types in references, and the names of fields and types in the bindings."""

from __future__ import annotations

from typing import Any

from mipgen import model as m
from mipgen.targets.c import api as c
from mipgen.targets.javascript import api as javascript
from mipgen.targets.python import api as python
from mipgen.targets.rust import api as rust


def type_name(t: m.Scalar | m.Type) -> str:
    """Returns the name of a type, prefixed with the set that owns it."""
    return t.name if isinstance(t, m.Scalar) else t.full_name


def symbols(thing: m.Type | m.Field) -> dict[str, str]:
    """Returns the names in the bindings of a field's type, or of a type. C++ has no type for a command, but one for
    each way to send it."""
    names = {"c": c.symbol(thing), "cpp": c.cpp_symbol(thing), "python": python.symbol(thing)}
    names |= {"rust": rust.symbol(thing), "javascript": javascript.symbol(thing)}
    return {language: name for language, name in names.items() if name}


def call_data(model: m.Model) -> dict[str, dict[str, Any]]:
    """Returns the data that a tool needs, besides `symbols`, to write calls of the bindings.

    Its tables contain only names that differ between a language and the specification.
    """
    return {
        "c": c.writing(model),
        "cpp": c.cpp_writing(model),
        "python": python.writing(model),
        "rust": rust.writing(model),
        "javascript": javascript.writing(model),
    }
