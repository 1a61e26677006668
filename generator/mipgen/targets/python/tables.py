"""Rows of the tables that tools read: the types of descriptors."""

from __future__ import annotations

from mipgen import model as m


def by_descriptor(s: m.Family) -> dict[int, list[m.Field]]:
    """Returns the layouts of each descriptor."""
    fields: dict[int, list[m.Field]] = {}
    for f in sorted(s.fields, key=lambda f: f.descriptor):
        fields.setdefault(f.descriptor, []).append(f)
    return fields
