"""Programs in C that use a field: a few lines for documentation, with sample values."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from mipgen import model as m
from mipgen.emit.wrapping import Brackets, Expression, after, laid_out
from mipgen.facts import literals
from mipgen.facts.literals import Literal
from mipgen.facts.sample_values import GivenValues, SampleValues, title_of
from mipgen.lower.memory import members

from .calls import Call, calls
from .literals import number, string
from .members import constructors, takes_enum
from .names import argument_name, c_type, constant, field_name, member, module, type_name, union_name


@dataclass(frozen=True)
class Programs:
    samples: SampleValues

    def command(self, f: m.Field) -> str:
        """Composes the call of a command at a device; a complete program checks the result."""
        lines = [f'#include "mip/{module(f.family)}_commands.h"']
        for i, shown in enumerate(self.samples.shown(f)):
            lines += _call(f, shown, self.samples, "result = " if i else "struct mip_result result = ")
        return "\n".join(lines)

    def sequence(self, name: str, steps: Sequence[tuple[m.Field, GivenValues]]) -> str:
        """Composes a function that sends several commands and stops at the first one that is not acknowledged."""
        needs = sorted({f'#include "mip/{module(f.family)}_commands.h"' for f, _ in steps})
        lines = ['#include "mip/device.h"', *needs, "", f"struct mip_result {name}(struct mip_device *device) {{"]
        calls = [
            _call(f, given.call, given, "result = " if i else "struct mip_result result = ", 88)
            for i, (f, given) in enumerate(steps)
        ]
        lines += in_turn(steps, calls, "/* {} */", "mip_succeeded(result)")
        return "\n".join([*lines, "    return result;", "}"])

    def data(self, f: m.Field) -> str:
        """Composes the lines that read a data field of a packet; a complete program handles errors."""
        names = [f"value.{member(p.name)}" for p in members(f)]
        read = ", ".join(names[:3]) + (" …" if len(names) > 3 else "")
        return "\n".join([
            f'#include "mip/{module(f.family)}.h"',
            f"struct {field_name(f)} value;",
            f"if ({field_name(f)}_decode(&value, &field) == MIP_OK) {{",
            f"    /* {read or 'it has no values'} */",
            *(["    /* field.descriptor_set is the set of its packet */"] if len(f.occurrences) > 1 else []),
            "}",
        ])  # fmt: skip


def in_turn(
    steps: Sequence[tuple[m.Field, GivenValues]], calls: Sequence[list[str]], remark: str, succeeded: str
) -> list[str]:
    """Writes the statements of a function that makes these calls until one fails."""
    lines: list[str] = []
    for i, ((f, given), call) in enumerate(zip(steps, calls, strict=True), 1):
        title = remark.format(f"{i}: {title_of(f, given)}")
        body = "\n".join(call + ([remark.format(given.host)] if given.host else [])).split("\n")
        if i == 1:
            lines += [f"    {line}" for line in (title, *body)]
        else:
            lines += [f"    if ({succeeded}) {{ {title}", *(f"        {line}" for line in body), "    }"]
    return lines


def _call(f: m.Field, shown: m.Call, samples: SampleValues, result: str, width: int = 96) -> list[str]:
    """Writes the declarations for a call, and the call, whose result is assigned."""
    values = literals.record(f.parameters, samples.values(f, shown))
    chosen = call_of(f, shown, samples)
    before: list[Expression] = []
    given: list[Expression] = ["device"]
    if chosen.whole:  # all of it is reserved
        before.append(after(f"const struct {field_name(f)} command = ", record(values)))
        given.append("&command")
    for p in chosen.given:
        declared, arguments = _argument(p, f, values[p.name])
        before += declared
        given += arguments
    if chosen.response is not None:
        before.append(f"struct {field_name(chosen.response)} response")
        given.append("&response")
    asked = Brackets(f"{result}{chosen.name}(", given, ")", comma="")
    return [laid_out(statement(line), width) for line in (*before, asked)]


def statement(x: Expression) -> Expression:
    return f"{x};" if isinstance(x, str) else replace(x, tail=f"{x.tail};")


def call_of(f: m.Field, shown: m.Call, samples: SampleValues) -> Call:
    """Returns the C function that sends the command in this form and decodes its response."""
    replies = samples.replies(f, shown)
    wanted = replies[0].layouts[0] if replies else None
    way = next((c.name for c in constructors(f) if c.function == shown.function), None)
    fitting = [c for c in calls(f, samples.model) if (c.way.name if c.way else None) == way]
    return next((c for c in fitting if c.response == wanted), fitting[0])


def _argument(p: m.Parameter, f: m.Field, x: Literal) -> tuple[list[Expression], list[Expression]]:
    """Writes the declarations that an argument of a call needs, and the argument."""
    name = argument_name(p.name)
    match x:
        case literals.Alternative():
            return [after(f"const union {union_name(p, f)} {name} = ", value(x))], [f"&{name}"]
        case literals.Text():
            return [], [*_count(p, x.text), value(x)]
        case literals.Items(items=()):
            return [], [*_count(p, ()), "NULL"]
        case literals.Items(items=(first, *_)):
            inner = f"[{len(first.items)}]" if isinstance(first, literals.Items) else ""
            return [after(f"const {_type(p)} {name}[]{inner} = ", value(x))], [*_count(p, x.items), name]
        case literals.Structure() | literals.Octets():
            return [after(f"const {_type(p)} {name} = ", value(x))], [f"&{name}"]
        case literals.Choice(known=None) if takes_enum(p):
            return [], [f"(enum {type_name(x.type)}){x.number.value}"]
        case literals.Choice(known=m.EnumValue() as known) if takes_enum(p):
            return [], [constant(x.type, known)]
    return [], [value(x)]


def _type(p: m.Parameter) -> str:
    assert p.element is not None
    return c_type(p.element)


def _count(p: m.Parameter, items: Sequence[object]) -> list[str]:
    """Writes the number of elements, if the array fills the field."""
    return [str(len(items))] if p.fills else []


def record(values: dict[str, Literal]) -> Brackets:
    """Writes the initializer of a structure. A union without a value is omitted, because {0} would lack braces."""
    held = {k: x for k, x in values.items() if not (isinstance(x, literals.Alternative) and x.value is None)}
    return Brackets("{", [after(f".{member(k)} = ", value(x)) for k, x in held.items()] or ["0"], "}")


def value(x: Literal) -> Expression:
    match x:
        case literals.Decimal():
            return x.text + ("F" if x.size == 4 else "")
        case literals.Truth():
            return "true" if x.value else "false"
        case literals.Whole():
            return str(x.value) if x.value < 0 else number(x.value, x.size, x.text)
        case literals.Choice():
            return constant(x.type, x.known) if x.known else value(x.number)
        case literals.Flags():
            return " | ".join(constant(x.type, b) for b in x.names) or number(x.number.value, x.number.size)
        case literals.Octets():
            return Brackets("{", [Brackets("{", [*map(str, x.bytes)], "}")], "}")
        case literals.Text():
            return string(x.text)
        case literals.Items():
            return Brackets("{", [*map(value, x.items)] or ["0"], "}")
        case literals.Structure():
            return record(x.members)
        case literals.Alternative():
            held = x.case.parameter if x.case and x.value else None
            return Brackets("{", [after(f".{member(held.name)} = ", value(x.value)) if held and x.value else "0"], "}")
