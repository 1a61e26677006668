"""The Python target's interface for other targets: names of fields and types, and programs."""

from __future__ import annotations

from mipgen import model as m

from . import PACKAGE, names
from .snippets import Programs

__all__ = ["Programs", "symbol"]


def symbol(thing: m.Type | m.Field) -> str:
    """Returns the class of a field or a type, as programs import it."""
    return f"{PACKAGE}.{names.qualified(thing).removeprefix('protocol.')}"
