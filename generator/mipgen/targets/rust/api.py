"""The Rust target's interface for other targets: names of fields and types, and programs."""

from __future__ import annotations

from mipgen import model as m

from . import names
from .snippets import Programs

__all__ = ["Programs", "symbol"]


def symbol(thing: m.Type | m.Field) -> str:
    """Returns the path of a field's type, or of a type."""
    return f"mip_protocol::{names.home(thing)}::{names.type_name(thing.name)}"
