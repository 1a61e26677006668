"""How a program in C uses a field: a few lines for documentation, with typical values."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ... import model as m
from ...descriptors import hexadecimal
from ...typical import Given, Typical, decimal, flags, title_of
from ...wrapping import broken, call
from .calls import Call, calls
from .literals import number, string
from .members import argument, constructors, members, takes_enum
from .names import argument_name, c_type, constant, field_name, is_struct, member, module, type_name, union_name


def command(f: m.Field, typical: Typical) -> str:
    """Calls it at a device."""
    lines = [f'#include "mip/{module(f.set_name)}_commands.h"', ""]
    for i, shown in enumerate(typical.shown(f)):
        lines += [""] if i else []
        lines += _call(f, shown, typical, "result = " if i else "struct mip_result result = ")
    lines += ["if (!mip_succeeded(result)) {", "    /* mip_result_reason(result) says why */", "}"]
    return "\n".join(lines)


def sequence(name: str, steps: Sequence[tuple[m.Field, Given]]) -> str:
    """A function that sends several commands; it ends with the first one that is not acknowledged."""
    needs = sorted({f'#include "mip/{module(f.set_name)}_commands.h"' for f, _ in steps})
    lines = ['#include "mip/device.h"', *needs, "", f"struct mip_result {name}(struct mip_device *device) {{"]
    for i, (f, given) in enumerate(steps):
        asked = _call(f, given.call, given, "result = " if i else "struct mip_result result = ", 88)
        title = f"/* {i + 1}: {title_of(f, given)} */"
        body = "\n".join(asked + ([f"/* {given.host} */"] if given.host else [])).split("\n")
        if i == 0:
            lines += [f"    {line}" for line in (title, *body)]
        else:
            lines += [f"    if (mip_succeeded(result)) {{ {title}", *(f"        {line}" for line in body), "    }"]
    return "\n".join([*lines, "    return result;", "}"])


def data(f: m.Field) -> str:
    """Reads it from a field of a packet."""
    names = [f"value.{member(p.name)}" for p in members(f)]
    read = ", ".join(names[:3]) + (" …" if len(names) > 3 else "")
    return "\n".join([
        f'#include "mip/{module(f.set_name)}.h"',
        "",
        f"struct {field_name(f)} value;",
        f"const mip_error error = {field_name(f)}_decode(&value, &field);",
        "if (error == MIP_OK) {",
        f"    /* {read or 'it holds nothing'} */",
        "} else {",
        "    /* mip_error_name(error) says why */",
        "}",
    ])  # fmt: skip


def _call(f: m.Field, shown: m.Call, typical: Typical, result: str, width: int = 96) -> list[str]:
    """What must be declared before, and the call, whose result is assigned."""
    values = typical.values(f, shown)
    replies = typical.replies(f, shown)
    wanted = replies[0].layouts[0] if replies else None
    made = next((c for c in constructors(f) if c.function == shown.function), None)
    start = f"{field_name(f)}_{made.name}(" if made else "command" if members(f) else "NULL"
    found = [c for c in calls(f, typical.model) if c.value.startswith(start)]
    chosen: Call = next((c for c in found if c.response == wanted), found[0])
    before: list[str] = []
    given = ["device"]
    if chosen.value == "command":  # all of it is reserved
        name = f"struct {field_name(f)}"
        before.append(f"const {name} command = {_record(f.parameters, values)};")
        given.append("&command")
    for p in made.asked if made else ():
        if argument(p, f) in chosen.arguments:
            declared, arguments = _argument(p, f, values[p.name])
            before += declared
            given += arguments
    if chosen.response is not None:
        before.append(f"struct {field_name(chosen.response)} response;")
        given.append("&response")
    asked = call(f"{result}{chosen.name}(", given, ");", width, comma="")
    return [*(broken(line, width) for line in before), asked]


def _argument(p: m.Parameter, f: m.Field, value: Any) -> tuple[list[str], list[str]]:
    """What must be declared before, and what is passed."""
    name, op = argument_name(p.name), p.operation
    if p.element is None:
        return [f"const union {union_name(p, f)} {name} = {_union(p, value)};"], [f"&{name}"]
    if isinstance(op, m.TextOp):
        count = [str(len(value))] if p.length == "rest" else []
        return [], [*count, string(value)]
    if isinstance(op, m.ArrayOp):
        count = [str(len(value))] if p.length == "rest" else []
        if not value:
            return [], [*count, "NULL"]
        inner = f"[{op.item.count}]" if isinstance(op.item, m.ArrayOp) else ""
        return [f"const {c_type(p.element)} {name}[]{inner} = {_value(p, value)};"], [*count, name]
    if is_struct(p.element):
        return [f"const {c_type(p.element)} {name} = {_value(p, value)};"], [f"&{name}"]
    if takes_enum(p):
        assert isinstance(p.element, m.Enum)
        known = next((v for v in p.element.values if v.value == value), None)
        return [], [constant(p.element, known) if known else f"(enum {type_name(p.element)}){value}"]
    return [], [_value(p, value)]


def _record(parameters: tuple[m.Parameter, ...], values: dict[str, Any]) -> str:
    """A union without a value is left out: compilers want more braces than {0} for it."""
    held = [
        f".{member(p.name)} = {_union(p, values[p.name]) if p.element is None else _value(p, values[p.name])}"
        for p in parameters
        if p.constant is None and p.name in values and (p.element is not None or _alternative(p, values[p.name]))
    ]
    return f"{{{', '.join(held) or '0'}}}"


def _union(p: m.Parameter, value: Any) -> str:
    alternative = _alternative(p, value)
    held = f".{member(alternative.name)} = {_value(alternative, value[alternative.name])}" if alternative else "0"
    return f"{{{held}}}"


def _alternative(p: m.Parameter, value: Any) -> m.Parameter | None:
    """The one case that a union has."""
    return next((c.parameter for c in p.cases if c.parameter and c.parameter.name in value), None)


def _value(p: m.Parameter, value: Any, op: m.Operation | None = None) -> str:
    """A value of a parameter, or of an item of its array."""
    op = op or p.operation
    match op:
        case m.ScalarOp():
            return _number(p, op, value)
        case m.CounterOp():
            return str(value)
        case m.TextOp():
            return string(value)
        case m.BitsOp():
            return f"{{{{{', '.join(map(str, value))}}}}}"
        case m.ArrayOp():
            return f"{{{', '.join(_value(p, v, op.item) for v in value) or '0'}}}"
        case m.StructOp():
            return _record(op.struct.parameters, value)
    raise AssertionError(op)


def _number(p: m.Parameter, op: m.ScalarOp, value: Any) -> str:
    if op.scalar.kind == "float":
        return decimal(value) + ("F" if op.size == 4 else "")
    if op.scalar.kind == "bool":
        return "true" if value else "false"
    if isinstance(op.type, m.Enum):
        known = next((v for v in op.type.values if v.value == value), None)
        if known:
            return constant(op.type, known)
    if isinstance(op.type, m.Bitfield):
        named = flags(op.type, value)
        if named:
            return " | ".join(constant(op.type, b) for b in named)
        return number(value, op.size)
    if value < 0:
        return str(value)
    return number(value, op.size, hexadecimal(p, value) if p.shown else str(value))
