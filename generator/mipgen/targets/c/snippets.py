"""Programs in C that use a field: a few lines for documentation, with sample values."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import islice

from mipgen import model as m
from mipgen.emit.wrapping import Brackets, Expression, after, laid_out
from mipgen.facts import literals
from mipgen.facts.literals import Literal
from mipgen.facts.sample_values import GivenValues, SampleValues, title_of
from mipgen.lower.memory import stored

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
        for i, form in enumerate(self.samples.shown(f)):
            lines += _call(f, form, self.samples, "result = " if i else "struct mip_result result = ")
            if response := call_of(f, form, self.samples).response:
                lines.append(braced("if (mip_succeeded(result))", printed(response, "response.")))
        return "\n".join(lines)

    def sequence(self, name: str, steps: Sequence[tuple[m.Field, GivenValues]]) -> str:
        """Composes a function that sends several commands and stops at the first one that is not acknowledged."""
        needs = sorted({f'#include "mip/{module(f.family)}_commands.h"' for f, _ in steps})
        lines = ['#include "mip/device.h"', *needs, "", f"struct mip_result {name}(struct mip_device *device) {{"]
        return sequence(lines, steps, _call, "struct mip_result", "/* {} */", "mip_succeeded(result)")

    def data(self, f: m.Field) -> str:
        """Composes the lines that read a data field of a packet; a complete program handles errors."""
        return "\n".join([
            f'#include "mip/{module(f.family)}.h"',
            f"struct {field_name(f)} value;",
            f"if ({field_name(f)}_decode(&value, &field) == MIP_OK) {{",
            printed(f, "value."),
            *(["    /* field.descriptor_set is the set of its packet */"] if len(f.occurrences) > 1 else []),
            "}",
        ])  # fmt: skip


def numbers(
    record: m.Record, path: str, name: Callable[[m.Parameter], str] = lambda p: member(p.name)
) -> Iterator[tuple[str, m.Scalar]]:
    """Yields the first numbers and texts of a structure, except those that may be absent, each with its type."""
    return islice((x for p in stored(record) if not p.optional for x in _numbers(p, path + name(p))), 3)


def _numbers(p: m.Parameter, path: str) -> Iterator[tuple[str, m.Scalar]]:
    if p.struct:
        yield from numbers(p.struct, f"{path}.")
    elif p.kind == "array" and p.fills:
        yield f"{path}.size()" if path.endswith("()") else f"{path}_count", m.SCALARS["u8"]
    elif p.kind == "array" and p.count:
        yield from (x for i in range(p.count) for x in _numbers(p.item, f"{path}[{i}]"))
    elif p.kind == "bits":
        yield f"{path}.bytes[0]", p.scalar
    elif p.kind in ("scalar", "counter", "text"):
        yield path, p.scalar


def printed(record: m.Record, path: str) -> str:
    """Writes the statement that prints the first values of a structure."""
    shown = [(at, *_format(scalar)) for at, scalar in numbers(record, path)] or [(record.name, "%s", '"{}"')]
    text = " ".join(conversion for _, conversion, _ in shown)
    arguments = [f'"{text}\\n"', *(argument.format(at) for at, _, argument in shown)]
    return "\n".join(f"    {x}" for x in laid_out(Brackets("printf(", arguments, ");", comma=""), 96).split("\n"))


def braced(head: str, body: str) -> str:
    """Writes a block on one line if it fits."""
    line = f"{head} {{ {body.strip()} }}"
    return line if "\n" not in body and len(line) <= 100 else f"{head} {{\n{body}\n}}"


def _format(scalar: m.Scalar) -> tuple[str, str]:
    """Returns the conversion of `printf` for a number or a text, and its argument: small integers need no cast."""
    if scalar.kind == "float":
        return ("%.10g" if scalar.size == 8 else "%g"), "{}"
    if scalar.kind == "char":
        return "%s", "{}"
    return ("%u" if scalar.kind == "unsigned" else "%d", "{}") if scalar.size <= 2 else ("%lld", "(long long){}")


def sequence(
    head: list[str],
    steps: Sequence[tuple[m.Field, GivenValues]],
    call: Callable[[m.Field, m.Call, SampleValues, str, int], list[str]],
    result: str,
    remark: str,
    succeeded: str,
) -> str:
    """Completes a function that makes calls until one fails."""
    lines = list(head)
    for i, (f, values) in enumerate(steps):
        title = remark.format(f"{i + 1}: {title_of(f, values)}")
        code = call(f, values.call, values, "result = " if i else f"{result} result = ", 88)
        body = "\n".join(code + ([remark.format(values.host)] if values.host else [])).split("\n")
        if i == 0:
            lines += [f"    {line}" for line in (title, *body)]
        else:
            lines += [f"    if ({succeeded}) {{ {title}", *(f"        {line}" for line in body), "    }"]
    return "\n".join([*lines, "    return result;", "}"])


def _call(f: m.Field, form: m.Call, samples: SampleValues, result: str, width: int = 96) -> list[str]:
    """Writes the declarations for a call, and the call, whose result is assigned."""
    values = literals.record_values(f.parameters, samples.values(f, form))
    call = call_of(f, form, samples)
    before: list[Expression] = []
    arguments: list[Expression] = ["device"]
    if call.whole:  # all of it is reserved
        before.append(after(f"const struct {field_name(f)} command = ", initializer(values)))
        arguments.append("&command")
    for p in call.parameters:
        declared, expressions = _argument(p, f, values[p.name])
        before += declared
        arguments += expressions
    if call.response is not None:
        before.append(f"struct {field_name(call.response)} response")
        arguments.append("&response")
    called = Brackets(f"{result}{call.name}(", arguments, ")", comma="")
    return [laid_out(statement(line), width) for line in (*before, called)]


def statement(x: Expression) -> Expression:
    return f"{x};" if isinstance(x, str) else replace(x, tail=f"{x.tail};")


def call_of(f: m.Field, form: m.Call, samples: SampleValues) -> Call:
    """Returns the C function that sends the command in this form and decodes its response."""
    replies = samples.replies(f, form)
    wanted = replies[0].layouts[0] if replies else None
    way = next((c.name for c in constructors(f) if c.function == form.function), None)
    fitting = [c for c in calls(f, samples.model) if (c.way.name if c.way else None) == way]
    return next((c for c in fitting if c.response == wanted), fitting[0])


def _argument(p: m.Parameter, f: m.Field, x: Literal) -> tuple[list[Expression], list[Expression]]:
    """Writes the declarations that an argument of a call needs, and the argument."""
    name, element = argument_name(p.name), c_type(p.element) if p.element else ""
    match x:
        case literals.Alternative():
            return [after(f"const union {union_name(p, f)} {name} = ", literal(x))], [f"&{name}"]
        case literals.Text():
            return [], [*_count(p, x.text), literal(x)]
        case literals.Items(items=()):
            return [], [*_count(p, ()), "NULL"]
        case literals.Items(items=(first, *_)):
            inner = f"[{len(first.items)}]" if isinstance(first, literals.Items) else ""
            return [after(f"const {element} {name}[]{inner} = ", literal(x))], [*_count(p, x.items), name]
        case literals.Structure() | literals.Octets():
            return [after(f"const {element} {name} = ", literal(x))], [f"&{name}"]
        case literals.Choice(value=None) if takes_enum(p):
            return [], [f"(enum {type_name(x.type)}){x.number.value}"]
        case literals.Choice(value=m.EnumValue() as named) if takes_enum(p):
            return [], [constant(x.type, named)]
    return [], [literal(x)]


def _count(p: m.Parameter, items: Sequence[object]) -> list[str]:
    """Writes the number of elements, if the array fills the field."""
    return [str(len(items))] if p.fills else []


def initializer(values: dict[str, Literal]) -> Brackets:
    """Writes the initializer of a structure. A union without a value is omitted, because {0} would lack braces."""
    members = {k: x for k, x in values.items() if not (isinstance(x, literals.Alternative) and x.value is None)}
    return Brackets("{", [after(f".{member(k)} = ", literal(x)) for k, x in members.items()] or ["0"], "}")


def literal(x: Literal) -> Expression:
    match x:
        case literals.Decimal():
            return x.text + ("F" if x.size == 4 else "")
        case literals.Truth():
            return "true" if x.value else "false"
        case literals.Whole():
            return str(x.value) if x.value < 0 else number(x.value, x.size, x.text)
        case literals.Choice():
            return constant(x.type, x.value) if x.value else literal(x.number)
        case literals.Flags():
            return " | ".join(constant(x.type, b) for b in x.names) or number(x.number.value, x.number.size)
        case literals.Octets():
            return Brackets("{", [Brackets("{", [*map(str, x.bytes)], "}")], "}")
        case literals.Text():
            return string(x.text)
        case literals.Items():
            return Brackets("{", [*map(literal, x.items)] or ["0"], "}")
        case literals.Structure():
            return initializer(x.members)
        case literals.Alternative():
            p = x.case.parameter if x.case and x.value else None
            return Brackets("{", [after(f".{member(p.name)} = ", literal(x.value)) if p and x.value else "0"], "}")
