"""The JavaScript target's interface for other targets: names of fields and types, and programs."""

from __future__ import annotations

from mipgen import model as m

from . import names
from .snippets import Programs

__all__ = ["Programs", "symbol"]


def symbol(thing: m.Type | m.Field) -> str:
    """Returns the class of a field or the name of a type, prefixed with the module that exports it."""
    return f"mip-protocol/{names.home(thing)}.{names.class_name(thing)}"
