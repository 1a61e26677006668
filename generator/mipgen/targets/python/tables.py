"""Rows of the tables that tools read: the reflection of parameters, the types of descriptors."""

from __future__ import annotations

from ... import meaning
from ... import model as m
from .names import member, qualified


def properties(p: m.Parameter) -> dict[str, str]:
    """What `reflection` says of a parameter beside its name and kind, as Python writes it; cases apart."""
    e = p.element
    found: dict[str, object] = {}
    if isinstance(e, m.Bitfield) and e.scalar is None:
        found |= {"scalar": "bits", "size": e.size}
    elif isinstance(e, m.Scalar):
        found["scalar"] = e.name
    elif isinstance(e, (m.Enum, m.Bitfield, m.Vector)) and e.scalar is not None:
        found["scalar"] = e.scalar.name
    if isinstance(e, m.Vector):
        found["elements"] = e.elements
    if p.length is not None:
        found["length"] = p.length
    if p.constant is not None:
        found["constant"] = p.constant
    if p.counts:
        found["counts"] = member(p.counts)
    if p.tag:
        found["tag"] = member(p.tag)
    if p.units:
        found["units"] = p.units
    if p.valid:
        found["valid"] = p.valid
    bounds = {"minimum": p.minimum, "maximum": p.maximum, "above": p.above, "below": p.below}
    found |= {key: bound for key, bound in bounds.items() if bound is not None}
    if p.magnitude != (None, None):
        found["magnitude"] = p.magnitude
    default = p.reserved if p.default is None else meaning.in_numbers(p.default, e)
    if default is not None:
        found["default"] = default
    if p.frame:
        found["frame"] = p.frame
    shown = {key: repr(value) for key, value in found.items()}
    if isinstance(e, (m.Enum, m.Bitfield, m.Struct)):
        shown["type"] = qualified(e)
    return shown


def by_descriptor(s: m.Set) -> dict[int, list[m.Field]]:
    """The layouts of each descriptor."""
    found: dict[int, list[m.Field]] = {}
    for f in sorted(s.fields, key=lambda f: f.descriptor):
        found.setdefault(f.descriptor, []).append(f)
    return found
