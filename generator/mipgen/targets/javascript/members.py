"""The members of objects, as TypeScript declares them."""

from __future__ import annotations

import json

from mipgen import model as m
from mipgen.lower import calls
from mipgen.lower.calls import constructors, members

from .names import SCALARS, home, member, reference


def key(p: m.Parameter) -> str:
    """Returns the name of a member in its declaration."""
    return member(p.name)


def may_be_absent(p: m.Parameter, record: m.Record) -> bool:
    """Can it be missing from a received field?"""
    return p.name in record.present_with


def hint(p: m.Parameter, record: m.Record) -> str:
    """Returns the type of a member."""
    if p.element is None:
        cases = [f"{key(c.parameter)}?: {hint(c.parameter, record)}" for c in p.cases if c.parameter is not None]
        return f"{{ {'; '.join(dict.fromkeys(cases))} }}"
    if p.kind == "text":
        return "string"
    one = _one(p, record)
    if not p.several or p.vector:
        return one
    plain = isinstance(p.element, m.Scalar) and p.count is not None and p.count <= 4
    return f"[{', '.join([one] * (p.count or 0))}]" if plain else f"{one}[]"


def _one(p: m.Parameter, record: m.Record) -> str:
    return SCALARS[p.element.name] if isinstance(p.element, m.Scalar) else reference(_named(p), home(record))


def _named(p: m.Parameter) -> m.Type:
    assert p.element is not None and not isinstance(p.element, m.Scalar)
    return p.element


def number(t: m.Enum | m.Bitfield) -> str:
    """Returns the type of its values: BigInt for a bitfield that is an array of bytes."""
    return SCALARS[t.scalar.name] if t.scalar else "bigint"


def unneeded(record: m.Record) -> str:
    """Writes the keys of the members that a caller may omit, as a type; empty if there are none."""
    return " | ".join(json.dumps(key(p)) for p in members(record) if p.reserved is not None)


def given(way: m.Call, record: m.Field) -> str:
    """Writes the parameter of the constructor for a function; empty if it has none."""
    asked = [f"{key(p)}: {hint(p, record)}" for p in way.values]
    asked += [f"{key(p)}?: {hint(p, record)}" for p in way.addable]
    return f"values{'' if way.values else '?'}: {{ {'; '.join(asked)} }}" if asked else ""


def answer(function: m.Function | None, f: m.Field, model: m.Model) -> str:
    """Returns the result type of a command with this function."""
    layouts = calls.answers(f, function, model)
    return " | ".join(dict.fromkeys(reference(layout, home(f)) for layout in layouts)) or "undefined"


def answers(f: m.Field, model: m.Model) -> str:
    """Returns the possible result types of a command with any function."""
    types = dict.fromkeys(t for way in constructors(f) for t in answer(way.function, f, model).split(" | "))
    return " | ".join(types)


def depends(f: m.Field, model: m.Model) -> bool:
    """Does the result type depend on the function?"""
    return len({answer(way.function, f, model) for way in constructors(f)}) > 1
