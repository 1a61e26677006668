"""What references look like, and what the bindings call fields and types."""

from __future__ import annotations

from ... import model as m
from ..c import names as c
from ..python import names as python
from ..rust import names as rust


def type_name(t: m.Scalar | m.Type) -> str:
    """The name of a type, after the set that owns it."""
    owner = None if isinstance(t, (m.Scalar, m.Vector)) else t.owner
    return f"{owner}.{t.name}" if owner else t.name


def symbols(thing: m.Type | m.Field) -> dict[str, str]:
    """What C, Python and Rust call the type of a field, or a type of the specification."""
    home = python.qualified(thing).removeprefix("protocol.")
    return {
        "c": c.field_name(thing) if isinstance(thing, m.Field) else c.type_name(thing),
        "python": f"mip_protocol.{home}",
        "rust": f"mip_protocol::{rust.home(thing)}::{rust.type_name(thing.name)}",
    }
