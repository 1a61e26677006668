"""The form of references, and the names of fields and types in the bindings."""

from __future__ import annotations

from typing import Any

from mipgen import model as m
from mipgen.targets.c import api as c
from mipgen.targets.javascript import api as javascript
from mipgen.targets.python import api as python
from mipgen.targets.rust import api as rust


def type_name(t: m.Scalar | m.Type) -> str:
    """The name of a type, after the set that owns it."""
    return t.name if isinstance(t, m.Scalar) else t.full_name


def symbols(thing: m.Type | m.Field) -> dict[str, str]:
    """The names in the bindings of the type of a field, or of a type of the specification. C++ has no type for a
    command: each way to send it has one."""
    names = {"c": c.symbol(thing), "cpp": c.cpp_symbol(thing), "python": python.symbol(thing)}
    names |= {"rust": rust.symbol(thing), "javascript": javascript.symbol(thing)}
    return {language: name for language, name in names.items() if name}


def programs(model: m.Model) -> dict[str, dict[str, Any]]:
    """The data that a tool needs, besides `symbols`, to write calls of the bindings.

    A table has the names that a language writes in another way than the specification; all others stay as they are.
    """
    return {
        "c": c.writing(model),
        "cpp": c.cpp_writing(model),
        "python": python.writing(model),
        "rust": rust.writing(model),
        "javascript": javascript.writing(model),
    }
