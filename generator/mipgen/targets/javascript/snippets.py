"""Programs in JavaScript that use a field: a few lines for documentation, with sample values."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from mipgen import model as m
from mipgen.emit.wrapping import Brackets, Expression, after, laid_out
from mipgen.facts import literals
from mipgen.facts.literals import Literal
from mipgen.facts.sample_values import SampleValues
from mipgen.facts.snippets import Statements
from mipgen.lower.calls import constructors, members

from .names import camel, class_name, constant, home, member

WIDTH = 84


class Programs(Statements):
    def program(self) -> _Program:
        return _Program()

    def data(self, f: m.Field) -> str:
        """Composes a program that reads the field from the data of a device."""
        program = self.program()
        read = [f"value.{member(p.name)}" for p in members(f)]
        shown = laid_out(Brackets("console.log(", read[:3] or ["value"], ");", comma=""), WIDTH)
        return program.text([f"for await (const value of device.fields({program.name(f)})) {{", f"    {shown}", "}"])


@dataclass
class _Program:
    """One program, and what it imports."""

    modules: dict[str, set[str]] = field(default_factory=dict)

    def text(self, lines: Sequence[str]) -> str:
        """Returns the complete program, with its imports first."""
        needs = [
            f'import {{ {", ".join(sorted(names))} }} from "mip-protocol/{module}";'
            for module, names in sorted(self.modules.items())
        ]
        return "\n".join([*needs, *lines])

    def name(self, thing: m.Type | m.Field) -> str:
        """Returns the name of a class, or of an object with named numbers, and imports it."""
        self.modules.setdefault(home(thing), set()).add(class_name(thing))
        return class_name(thing)

    def sent(self, f: m.Field, samples: SampleValues) -> list[str]:
        """Returns the lines that send a command and print its response."""
        lines = []
        ways = {way.function: way for way in constructors(f)}
        for shown in samples.shown(f):
            way, values = ways[shown.function], literals.record_values(f.parameters, samples.values(f, shown))
            arguments = self.members({p.name: values[p.name] for p in way.values})
            made = f"{self.name(f)}.{camel(way.function.name)}(" if way.function else f"new {self.name(f)}("
            asks = bool(samples.replies(f, shown))
            head, tail = ("console.log(", ")") if asks else ("", "")
            call = replace(arguments, tail=f"{arguments.tail})){tail};").after(f"{head}await device.request({made}")
            if way.function and not arguments.items:
                call = Brackets(f"{head}await device.request({made}", [], f")){tail};")
            lines.append(laid_out(call, WIDTH))
        return lines

    def members(self, values: dict[str, Literal]) -> Brackets:
        items = [after(f"{member(name)}: ", self.value(x)) for name, x in values.items()]
        return Brackets("{", items, "}", pad=" ")

    def value(self, x: Literal) -> Expression:
        match x:
            case literals.Decimal():
                return x.text
            case literals.Truth():
                return "true" if x.value else "false"
            case literals.Whole():
                return f"{x.text}n" if x.size == 8 else x.text
            case literals.Choice():
                return f"{self.name(x.type)}.{constant(x.value.name)}" if x.value else self.value(x.number)
            case literals.Flags():
                return self.flags(x)
            case literals.Octets():
                return f"{int.from_bytes(bytes(x.bytes), 'little'):#x}n"
            case literals.Text():
                return json.dumps(x.text)
            case literals.Items():
                return Brackets("[", [*map(self.value, x.items)], "]")
            case literals.Structure():
                stored = [p for p in members(x.type) if p.reserved is None]
                return self.members({p.name: x.members[p.name] for p in stored})
            case literals.Alternative():
                assert x.case is not None
                parameter = x.case.parameter
                return self.members({parameter.name: x.value} if parameter and x.value else {})

    def flags(self, x: literals.Flags) -> str:
        """Joins flags with an operator; adds them if a bitwise operator would make the number negative."""
        names = [f"{self.name(x.type)}.{constant(b.name)}" for b in x.names]
        joint = " + " if x.number.size == 4 and x.number.value >= 1 << 31 else " | "
        return joint.join(names) or f"{x.number.value:#x}{'n' if x.number.size == 8 else ''}"
