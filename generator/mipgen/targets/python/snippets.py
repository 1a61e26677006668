"""Programs in Python that use a field: a few lines for documentation, with sample values."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from mipgen import model as m
from mipgen.emit.wrapping import Brackets, Expression, after, laid_out
from mipgen.facts import literals
from mipgen.facts.literals import Literal
from mipgen.facts.sample_values import SampleValues
from mipgen.facts.snippets import Statements
from mipgen.lower.calls import constructors, members

from .members import Member
from .names import class_name, constant, hides_builtin, home, member

WIDTH = 84


class Programs(Statements):
    remark = "#"

    def program(self) -> _Program:
        return _Program()

    def data(self, f: m.Field) -> str:
        """Composes a program that reads the field from the data of a device."""
        program = self.program()
        read = [f"value.{member(p.name)}" for p in members(f)]
        shown = laid_out(Brackets("print(", ["stamp.device", *read[:3]], ")"), WIDTH)
        return program.text([f"for stamp, value in device.fields({program.name(f)}):", f"    {shown}"])


@dataclass
class _Program:
    """One program, and the modules that it needs."""

    modules: set[str] = field(default_factory=set)

    def text(self, lines: Sequence[str]) -> str:
        """Returns the complete program, with its imports first."""
        names = [x if local(x) == x else f"{x} as {local(x)}" for x in sorted(self.modules)]
        return "\n".join([f"from mip_protocol import {', '.join(names)}", *lines])

    def name(self, thing: m.Type | m.Field) -> str:
        module = home(thing)
        self.modules.add(module)
        return f"{local(module)}.{class_name(thing)}"

    def sent(self, f: m.Field, samples: SampleValues) -> list[str]:
        """Returns the lines that send a command and print its response."""
        lines = []
        calls = {call.function: call for call in constructors(f)}
        for shown in samples.shown(f):
            call, values = calls[shown.function], literals.record_values(f.parameters, samples.values(f, shown))
            arguments = [self.value(values[p.name]) for p in call.values]
            command = f"{self.name(f)}.{member(call.function.name)}" if call.function else self.name(f)
            head, tail = ("print(", ")") if samples.replies(f, shown) else ("", "")
            lines.append(laid_out(Brackets(f"{head}device.request({command}(", arguments, f")){tail}"), WIDTH))
        return lines

    def value(self, x: Literal) -> Expression:
        match x:
            case literals.Decimal():
                return x.text
            case literals.Truth():
                return str(x.value)
            case literals.Whole():
                return x.text
            case literals.Choice():
                name = self.name(x.type)
                return f"{name}.{constant(x.value.name)}" if x.value else f"{name}({x.number.value})"
            case literals.Flags():
                name = self.name(x.type)
                return " | ".join(f"{name}.{constant(b.name)}" for b in x.names) or f"{name}({x.number.value:#x})"
            case literals.Octets():
                return f"{self.name(x.type)}({int.from_bytes(bytes(x.bytes), 'little'):#x})"
            case literals.Text():
                return '"' + x.text.replace("\\", "\\\\").replace('"', '\\"') + '"'
            case literals.Items():
                return Brackets("(", [*map(self.value, x.items)], ")", alone=",")
            case literals.Structure():
                return Brackets(f"{self.name(x.type)}(", self.arguments(x), ")")
            case literals.Alternative():
                return self.value(x.value) if x.value else "None"

    def arguments(self, x: literals.Structure) -> list[Expression]:
        """Writes the arguments of a structure's class; reserved ones are omitted, unless they are positional."""
        own = [(p, Member(p, x.type).keyword_only) for p in members(x.type)]
        return [
            after(f"{member(p.name)}=" if by_name else "", self.value(x.members[p.name]))
            for p, by_name in own
            if p.reserved is None or not by_name
        ]


def local(module: str) -> str:
    """Returns the name under which a program imports a module."""
    return f"mip_{module}" if hides_builtin(module) else module
