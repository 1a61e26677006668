"""How a program in Python uses a field: a few lines for documentation, with typical values."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

from ... import model as m
from ...descriptors import hexadecimal
from ...typical import Given, Typical, decimal, flags, title_of
from ...wrapping import call
from .members import keyword_only, members
from .names import class_name, constant, hides_builtin, home, member


def command(f: m.Field, typical: Typical) -> str:
    """Sends it to a device."""
    return _imports("\n".join(_sent(f, typical)))


def sequence(steps: Sequence[tuple[m.Field, Given]]) -> str:
    """Sends several commands; one that is not acknowledged raises an exception."""
    lines = []
    for i, (f, given) in enumerate(steps):
        lines += [f"# {i + 1}: {title_of(f, given)}", *_sent(f, given, "print(")]
        lines += [f"# {given.host}"] if given.host else []
    return _imports("\n".join(lines))


def _sent(f: m.Field, typical: Typical, before: str = "response = ") -> list[str]:
    """The lines that send it; a response is kept, or it is printed at once."""
    at_once = before == "print("
    lines = []
    for shown in typical.shown(f):
        values = typical.values(f, shown)
        given = [_argument(p, f, values) for p in shown.asked if not p.derived]
        made = f".{member(shown.function.name)}" if shown.function else ""
        asks = bool(typical.replies(f, shown))
        head, tail = (before, ")" if at_once else "") if asks else ("", "")
        lines.append(call(f"{head}device.request({_name(f)}{made}(", given, f")){tail}", 84))
        lines += ["print(response)"] if asks and not at_once else []
    return lines


def data(f: m.Field) -> str:
    """Takes it from what a device sends."""
    read = [f"value.{member(p.name)}" for p in members(f)]
    return _imports(
        f"for time, value in device.fields({_name(f)}):\n    " + call("print(", ["time", *read[:3]], ")", 84)
    )


def _imports(text: str) -> str:
    """What it needs, in front of it."""
    modules = sorted(set(re.findall(r"(?<![\w.])~(\w+)\.", text)))
    names = [f"{x} as mip_{x}" if hides_builtin(x) else x for x in modules]
    text = re.sub(r"~(\w+)\.", lambda x: f"mip_{x[1]}." if hides_builtin(x[1]) else f"{x[1]}.", text)
    return f"from mip_protocol import {', '.join(names)}\n\n{text}"


def _name(thing: m.Type | m.Field) -> str:
    return f"~{home(thing)}.{class_name(thing)}"


def _argument(p: m.Parameter, record: m.Field | m.Struct, values: dict[str, Any]) -> str:
    return _value(p, values[p.name])


def _value(p: m.Parameter, value: Any, op: m.Operation | None = None) -> str:
    """A value of a parameter, or of an item of its array."""
    op = op or p.operation
    match op:
        case m.ScalarOp():
            return _number(p, op, value)
        case m.TextOp():
            text: str = value
            return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'
        case m.BitsOp():
            return f"{_name(op.type)}({int.from_bytes(bytes(value), 'little'):#x})"
        case m.ArrayOp():
            items = [_value(p, v, op.item) for v in value]
            return f"({', '.join(items)}{',' if len(items) == 1 else ''})"
        case m.StructOp():
            given = [
                f"{member(q.name)}={_argument(q, op.struct, value)}"
                if keyword_only(q, op.struct)
                else _argument(q, op.struct, value)
                for q in members(op.struct)
                if q.reserved is None or not keyword_only(q, op.struct)
            ]
            return f"{_name(op.struct)}({', '.join(given)})"
        case m.SwitchOp():
            case = next((c for c in op.cases if c.parameter and c.parameter.name in value), None)
            return _value(case.parameter, value[case.parameter.name]) if case and case.parameter else "None"
    raise AssertionError(op)


def _number(p: m.Parameter, op: m.ScalarOp, value: Any) -> str:
    if op.scalar.kind == "float":
        return decimal(value)
    if op.scalar.kind == "bool":
        return str(bool(value))
    if isinstance(op.type, m.Enum):
        known = next((v for v in op.type.values if v.value == value), None)
        return f"{_name(op.type)}.{constant(known.name)}" if known else f"{_name(op.type)}({value})"
    if isinstance(op.type, m.Bitfield):
        named = flags(op.type, value)
        return " | ".join(f"{_name(op.type)}.{constant(b.name)}" for b in named) or f"{_name(op.type)}({value:#x})"
    return hexadecimal(p, value) if p.shown else str(value)
