"""How a program in Rust uses a field: a few lines for documentation, with typical values."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

from ... import model as m
from ...descriptors import hexadecimal
from ...typical import Given, Typical, decimal, flags, title_of
from ...wrapping import call
from .names import Record, constant, home, path, variant
from .records import Records


class Snippets:
    def __init__(self, typical: Typical) -> None:
        self.typical = typical
        self.records = Records(typical.model)

    def command(self, f: m.Field) -> str:
        """Sends it to a device."""
        return _uses("\n".join(self._sent(f, self.typical)))

    def sequence(self, steps: Sequence[tuple[m.Field, Given]]) -> str:
        """Sends several commands; one that is not acknowledged returns its error."""
        lines = []
        for i, (f, given) in enumerate(steps):
            lines += [f"// {i + 1}: {title_of(f, given)}", *self._sent(f, given)]
            lines += [f"// {given.host}"] if given.host else []
        return _uses("\n".join(lines))

    def _sent(self, f: m.Field, typical: Typical) -> list[str]:
        lines = []
        constructors = self.records.constructors(f)
        for shown in typical.shown(f):
            values = typical.values(f, shown)
            made = next(c for c in constructors if c.function == shown.function)
            arguments = [self._value(x.parameter, values[x.parameter.name], f) for x in made.given]
            asks = bool(typical.replies(f, shown))
            head = f"{'let response = device.request' if asks else 'device.run'}(&{_name(f)}::{made.name}("
            lines.append(call(head, arguments, "))?;", 84))
            lines += ['println!("{response:?}");'] if asks else []
        return lines

    def data(self, f: m.Field) -> str:
        """Takes it from a packet."""
        read = next((f"value.{x.name}" for x in self.records.members(f)), "value")
        found = f"packet.find::<{_name(f)}>().transpose()?"  # a broken one is an error, as a refused command is
        return _uses(f'if let Some(value) = {found} {{\n    println!("{{:?}}", {read});\n}}')

    def _value(self, p: m.Parameter, value: Any, record: Record, op: m.Operation | None = None) -> str:
        """A value of a parameter, or of an item of its array."""
        op = op or p.operation
        match op:
            case m.ScalarOp():
                return _number(p, op, value)
            case m.BitsOp():
                return f"{_name(op.type)}({value})"
            case m.TextOp():
                text = value.replace("\\", "\\\\").replace('"', '\\"')
                return f'~Text(*b"{text}")' if op.count is not None else f'~VarText::new("{text}").unwrap()'
            case m.ArrayOp():
                array = f"[{', '.join(self._inner(p, v, record, op.item) for v in value)}]"
                return f"{_name(op.vector)}::from({array})" if op.vector else array
            case m.StructOp():
                (made,) = self.records.constructors(op.struct)
                given = [self._value(x.parameter, value[x.parameter.name], op.struct) for x in made.given]
                return f"{_name(op.struct)}::{made.name}({', '.join(given)})"
            case m.SwitchOp():
                return self._union(op, value, record)
        raise AssertionError(op)

    def _union(self, op: m.SwitchOp, value: Any, record: Record) -> str:
        union = f"~{home(record)}::{self.records.union(op, home(record)).name}"
        case = next((c for c in op.cases if c.parameter and c.parameter.name in value), None)
        if case is None or case.parameter is None:
            case = next(c for c in op.cases if c.parameter is None)
            return f"{union}::{variant(case.tag.name)}"
        inner = self._inner(case.parameter, value[case.parameter.name], record)
        return f"{union}::{variant(case.tag.name)}({inner})"

    def _inner(self, p: m.Parameter, value: Any, record: Record, op: m.Operation | None = None) -> str:
        """Constructors take a `bool`, everything else holds a `Bool`."""
        op = op or p.operation
        if isinstance(op, m.ScalarOp) and op.scalar.kind == "bool":
            return f"~Bool({value})"
        return self._value(p, value, record, op)


def _name(thing: m.Type | Record) -> str:
    return "~" + path(thing, "").removeprefix("crate::")


def _uses(text: str) -> str:
    """What it needs, in front of it."""
    used = sorted(set(re.findall(r"~(\w+)", text)))
    names = used[0] if len(used) == 1 else f"{{{', '.join(used)}}}"
    return f"use mip_protocol::{names};\n\n{text.replace('~', '')}"


def _number(p: m.Parameter, op: m.ScalarOp, value: Any) -> str:
    if op.scalar.kind == "float":
        return decimal(value)
    if op.scalar.kind == "bool":
        return "true" if value else "false"
    if isinstance(op.type, m.Enum):
        known = next((v for v in op.type.values if v.value == value), None)
        return f"{_name(op.type)}::{constant(known.name)}" if known else f"{_name(op.type)}({value})"
    if isinstance(op.type, m.Bitfield):
        named = flags(op.type, value)
        return " | ".join(f"{_name(op.type)}::{constant(b.name)}" for b in named) or f"{_name(op.type)}({value:#x})"
    return hexadecimal(p, value) if p.shown else str(value)
