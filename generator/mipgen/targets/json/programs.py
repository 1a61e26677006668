"""What programs in C, Python and Rust need besides `symbols`, so that a tool can write calls of the bindings.

A table has the names that a language writes in another way than the specification; all others stay as they are.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any

from ... import model as m
from ..c import calls as c_calls
from ..c import members as c_members
from ..c import names as c
from ..python import names as python
from ..rust import names as rust
from ..rust.records import Records
from .names import type_name

Record = m.Field | m.Struct


def programs(model: m.Model) -> dict[str, Any]:
    parameters = sorted({p.name for r in _records(model) for p in _parameters(r)})
    functions = [f.name for f in model.protocol.functions]
    constants = sorted({x.name for t in (model.protocol.function_selector, *model.all_types) for x in _parts(t)})
    commands = [f for f in model.fields if f.role == m.COMMAND]
    return {
        "c": {
            "scalars": {name: c.c_type(scalar) for name, scalar in m.SCALARS.items()},
            "headers": {s.name: c.module(s.name) for s in model.sets},
            "members": _others(parameters, c.member),
            "arguments": _others(parameters, c.argument_name),
            "calls": {f.full_name: list(_calls(f, model)) for f in commands},
        },
        "python": {
            "modules": {python.module(s.name): _module(python.module(s.name)) for s in model.sets},
            "members": _others([*parameters, *functions], python.member),
            "constants": _others(constants, python.constant, c.macro),
        },
        "rust": {
            "members": _others(parameters, rust.member),
            "constants": _others(constants, rust.constant, c.macro),
            "constructors": {f.name: rust.constructor(f) for f in model.protocol.functions},
            "unions": _unions(model),
            "vectors": {t.name: rust.path(t, "") for t in model.types if isinstance(t, m.Vector)},
            "variants": {tag: rust.variant(tag) for tag in sorted(_tags(model))},
        },
    }


def _records(model: m.Model) -> list[Record]:
    return [*model.fields, *(t for t in model.all_types if isinstance(t, m.Struct))]


def _parameters(record: Record) -> Iterator[m.Parameter]:
    for p in record.parameters:
        yield p
        yield from (c.parameter for c in p.cases if c.parameter is not None)


def _parts(t: m.Type) -> Iterable[m.EnumValue | m.Bits]:
    return t.values if isinstance(t, m.Enum) else t.bits if isinstance(t, m.Bitfield) else ()


def _others(names: Iterable[str], of: Callable[[str], str], usual: Callable[[str], str] = str) -> dict[str, str]:
    return {name: of(name) for name in names if of(name) != usual(name)}


def _module(name: str) -> str:
    """What a program calls a module that it imports."""
    return f"mip_{name}" if python.hides_builtin(name) else name


def _calls(f: m.Field, model: m.Model) -> Iterator[dict[str, Any]]:
    """The functions that call a command: the function selector, what they take, and the response that they decode.
    One that takes nothing of a command with reserved values alone takes the whole structure."""
    made = {x.name: x for x in c_members.constructors(f)}
    for call in c_calls.calls(f, model):
        way = made.get(call.value.partition("(")[0].removeprefix(f"{c.field_name(f)}_"))
        if call.value == "command" and made:
            continue  # with optional parameters
        found: dict[str, Any] = {"name": call.name}
        if way is not None and way.function is not None:
            found["function"] = way.function.name
        if way is not None:
            found["takes"] = [p.name for p in way.asked if c_members.argument(p, f) in call.arguments]
        if call.value == "command":
            found["whole"] = True
        if call.response is not None:
            found["response"] = call.response.full_name
        yield found


def _unions(model: m.Model) -> dict[str, str]:
    """The union of a parameter in Rust: those of a module that have the same alternatives are one type."""
    records, found = Records(model), {}
    for r in _records(model):
        for p in r.parameters:
            if isinstance(p.operation, m.SwitchOp):
                name = r.full_name if isinstance(r, m.Field) else type_name(r)
                found[f"{name}.{p.name}"] = f"{rust.home(r)}::{records.union(p.operation, rust.home(r)).name}"
    return found


def _tags(model: m.Model) -> set[str]:
    return {c.tag.name for r in _records(model) for p in r.parameters for c in p.cases}
