"""Programs in C++ that use a field: a few lines for documentation, with sample values."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from mipgen import model as m
from mipgen.emit.wrapping import Brackets, Expression, after, laid_out
from mipgen.facts import literals
from mipgen.facts.literals import Literal
from mipgen.facts.sample_values import GivenValues, SampleValues

from . import snippets
from .cpp import accessors, command_name, namespace, qualified, word
from .literals import string
from .names import c_type, field_name, member, module, union_name


@dataclass(frozen=True)
class Programs:
    samples: SampleValues

    def command(self, f: m.Field) -> str:
        """Composes the call of a command at a device."""
        lines = [f'#include "mip/cpp/{module(f.family)}_commands.hpp"']
        for i, form in enumerate(self.samples.shown(f)):
            name = "answer" if i else "result"
            lines += _call(f, form, self.samples, f"const auto {name} = ")
            if response := snippets.call_of(f, form, self.samples).response:
                lines.append(snippets.braced(f"if ({name})", _printed(response, f"{name}->")))
        return "\n".join(lines)

    def sequence(self, name: str, steps: Sequence[tuple[m.Field, GivenValues]]) -> str:
        """Composes a function that sends several commands and stops at the first one that is not acknowledged."""
        lines = sorted({f'#include "mip/cpp/{module(f.family)}_commands.hpp"' for f, _ in steps})
        lines += ["", f"mip::result<> {name}(mip::device<> &device) {{"]
        return snippets.sequence(lines, steps, _call, "mip::result<>", "// {}", "result")

    def data(self, f: m.Field) -> str:
        """Composes the lines that read a data field of a packet."""
        return "\n".join([
            f'#include "mip/cpp/{module(f.family)}.hpp"',
            f"if (const auto value = field.as<{qualified(f)}>()) {{",
            _printed(f, "value->"),
            *(["    // field.descriptor_set is the set of its packet"] if len(f.occurrences) > 1 else []),
            "}",
        ])  # fmt: skip


def _printed(f: m.Field, path: str) -> str:
    """Writes the statement that prints the first values of data or a response."""
    called = {a.name for a in accessors(f)}

    def name(p: m.Parameter) -> str:
        return f"{word(p.name)}()" if word(p.name) in called else member(p.name)

    shown = [
        f"+{at}" if scalar.size == 1 and scalar.kind != "char" and not at.endswith(")") else at
        for at, scalar in snippets.numbers(f, path, name)
    ] or [string(f.name)]
    line = "    std::cout << " + " << ' ' << ".join(shown) + " << '\\n';"
    return line if len(line) <= 96 else line.replace(" << ' '", "\n              << ' '")


def _call(f: m.Field, form: m.Call, samples: SampleValues, result: str, width: int = 96) -> list[str]:
    """Writes the declarations for a call, and the call, whose result is assigned."""
    values = literals.record_values(f.parameters, samples.values(f, form))
    call = snippets.call_of(f, form, samples)
    before: list[Expression] = []
    if call.whole:  # all of it is reserved
        before.append(f"{field_name(f)} command = {{}}")
        before += (line for k, x in values.items() for line in _assignments(f"command.{member(k)}", x))
        called = Brackets(f"{result}device.call(", ["command"], ");", comma="")
        return [laid_out(line, width) for line in (*(snippets.statement(x) for x in before), called)]
    counted = {p.counter for p in call.parameters if p.counter}
    arguments: list[Expression] = []
    for p in call.parameters:
        if p.name in counted:
            continue
        declared, value = _argument(p, f, values[p.name])
        before += declared
        arguments.append(value)
    command = f"mip::{namespace(f.family)}::{command_name(f, call)}"
    called = Brackets(f"{result}device.call({command}{{", arguments, "});", comma="")
    return [laid_out(line, width) for line in (*(snippets.statement(x) for x in before), called)]


def _argument(p: m.Parameter, f: m.Field, x: Literal) -> tuple[list[Expression], Expression]:
    """Writes the declarations that a member of a command needs, and the member's value."""
    match x:
        case literals.Alternative(value=None):
            return [], "{}"
        case literals.Alternative():
            declared = f"{union_name(p, f)} {word(p.name)} = {{}}"  # an initializer would set its first member
            return [declared, *_assignments(word(p.name), x)], word(p.name)
        case literals.Choice(value=None):
            return [], f"static_cast<{qualified(x.type)}>({x.number.value})"
        case literals.Choice(value=m.EnumValue() as named):
            return [], f"{qualified(x.type)}::{word(named.name)}"
        case literals.Flags(names=()):
            return [], f"static_cast<{qualified(x.type)}>({x.number.text})"
        case literals.Flags():
            return [], " | ".join(f"{qualified(x.type)}::{word(b.name)}" for b in x.names)
        case literals.Text():
            return [], string(x.text)
        case literals.Items(items=(first, *_)) if p.counter or p.fills:
            assert p.element is not None
            element = qualified(p.element) if isinstance(p.element, m.Struct) else c_type(p.element)
            inner = f"[{len(first.items)}]" if isinstance(first, literals.Items) else ""
            return [after(f"const {element} {word(p.name)}[]{inner} = ", _literal(x))], word(p.name)
        case literals.Items(items=()):
            return [], "{}"
    return [], _literal(x)


def _literal(x: Literal) -> Expression:
    """Writes a value by position: C++17 has no designated initializers."""
    match x:
        case literals.Structure():
            return Brackets("{", [*map(_literal, x.members.values())], "}")
        case literals.Items():
            return Brackets("{", [*map(_literal, x.items)], "}")
    return snippets.literal(x)


def _assignments(path: str, x: Literal) -> Iterator[Expression]:
    """Writes the assignments of the numbers of a value."""
    match x:
        case literals.Structure():
            for name, value in x.members.items():
                yield from _assignments(f"{path}.{member(name)}", value)
        case literals.Items():
            for i, value in enumerate(x.items):
                yield from _assignments(f"{path}[{i}]", value)
        case literals.Alternative():
            if x.case and x.case.parameter and x.value:
                yield from _assignments(f"{path}.{member(x.case.parameter.name)}", x.value)
        case _:
            yield after(f"{path} = ", snippets.literal(x))
