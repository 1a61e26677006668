"""Programs in Rust that use a field: a few lines for documentation, with sample values."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from mipgen import model as m
from mipgen.emit.wrapping import Brackets, Expression, laid_out
from mipgen.facts import literals
from mipgen.facts.literals import Literal
from mipgen.facts.sample_values import SampleValues
from mipgen.facts.snippets import Statements

from .names import constant, home, path, variant
from .view import Constructor, Crate

WIDTH = 84


class Programs(Statements):
    def program(self) -> _Program:
        return _Program(self.samples.model.derived(Crate))

    def data(self, f: m.Field) -> str:
        """Composes a program that reads the field from a packet."""
        program = self.program()
        read = next((f"value.{x.name}" for x in program.crate.record(f).members), "value")
        # A field that cannot be decoded is an error, like a rejected command.
        search = f"packet.find::<{program.name(f)}>()?"
        return program.text([f"if let Some(value) = {search} {{", f'    println!("{{:?}}", {read});', "}"])


@dataclass
class _Program:
    """One program, and the items of the crate that it needs."""

    crate: Crate
    uses: set[str] = field(default_factory=set)

    def text(self, lines: Sequence[str]) -> str:
        """Returns the complete program, with its imports and declarations first."""
        used = sorted(self.uses)
        names = used[0] if len(used) == 1 else f"{{{', '.join(used)}}}"
        return "\n".join([f"use mip_protocol::{names};", *lines])

    def item(self, words: str) -> str:
        """Imports an item of the crate, or the module that contains it, and returns the item."""
        self.uses.add(words.partition("::")[0])
        return words

    def name(self, thing: m.Type | m.Record) -> str:
        return self.item(path(thing, "").removeprefix("crate::"))

    def sent(self, f: m.Field, samples: SampleValues) -> list[str]:
        lines = []
        ways = {way.function: way for way in self.crate.record(f).constructors}
        for call in samples.shown(f):
            way, asks = ways[call.function], bool(samples.replies(f, call))
            arguments = self.arguments(way, literals.record_values(f.parameters, samples.values(f, call)), f)
            before, behind = ('println!("{:?}", ', ")") if asks else ("", "")
            head = f"{before}device.request(&{self.name(f)}::{way.name}("
            lines.append(laid_out(Brackets(head, arguments, f"))?{behind};"), WIDTH))
        return lines

    def arguments(self, way: Constructor, values: dict[str, Literal], record: m.Record) -> list[Expression]:
        return [self.value(values[x.parameter.name], record) for x in way.arguments]

    def value(self, x: Literal, record: m.Record) -> Expression:
        match x:
            case literals.Decimal():
                return x.text
            case literals.Truth():
                return "true" if x.value else "false"
            case literals.Whole():
                return x.text
            case literals.Choice():
                name = self.name(x.type)
                return f"{name}::{constant(x.value.name)}" if x.value else f"{name}({x.number.value})"
            case literals.Flags():
                name = self.name(x.type)
                return " | ".join(f"{name}::{constant(b.name)}" for b in x.names) or f"{name}({x.number.value:#x})"
            case literals.Octets():
                return Brackets(f"{self.name(x.type)}(", [Brackets("[", [*map(str, x.bytes)], "]")], ")")
            case literals.Text():
                text = x.text.replace("\\", "\\\\").replace('"', '\\"')
                return f'{self.item("VarText")}::new("{text}").unwrap()' if x.count is None else self.fixed(text)
            case literals.Items():
                array = Brackets("[", [self.inner(item, record) for item in x.items], "]")
                return Brackets(f"{self.name(x.vector)}::from(", [array], ")") if x.vector else array
            case literals.Structure():
                (way,) = self.crate.record(x.type).constructors
                return Brackets(f"{self.name(x.type)}::{way.name}(", self.arguments(way, x.members, x.type), ")")
            case literals.Alternative():
                return self.alternative(x, record)

    def fixed(self, text: str) -> Expression:
        return Brackets(f"{self.item('Text')}(", [f'*b"{text}"'], ")")

    def alternative(self, x: literals.Alternative, record: m.Record) -> Expression:
        name = self.item(f"{home(record)}::{self.crate.union(x.union, home(record)).name}")
        assert x.case is not None
        case = f"{name}::{variant(x.case.tag.name)}"
        return Brackets(f"{case}(", [self.inner(x.value, record)], ")") if x.value else case

    def inner(self, x: Literal, record: m.Record) -> Expression:
        """Writes a nested value: a `Bool`, where constructors accept a `bool`."""
        if isinstance(x, literals.Truth):
            return f"{self.item('Bool')}({x.byte})"
        return self.value(x, record)
