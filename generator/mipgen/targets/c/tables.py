"""Rows of the tables that programs search: registry and reflection."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass

from mipgen import model as m
from mipgen.emit.formatting import CLANG_FORMAT
from mipgen.emit.naming import upper
from mipgen.lower.memory import members

from . import literals
from .members import home
from .names import bare, field_name, member, symbol, union_name


def required(f: m.Field) -> list[int]:
    """Returns the number of parameters that each function requires; the index is the function's value."""
    return [f.required(value) for value in range(max(x.value for x in f.functions) + 1)]


# --------------------------------------------------------------------------- registry


@dataclass(frozen=True, slots=True)
class Entry:
    field: m.Field
    first_link: int
    links: tuple[int, ...]  # the entries of its responses or commands


@dataclass(frozen=True, slots=True)
class SetEntry:
    number: int
    name: str
    first: int  # the entry of the first field of its family
    count: int


def _ordered(model: m.Model) -> list[m.Field]:
    """Returns the acknowledge, then all fields by family, descriptor and order in the specification."""
    families = (sorted(x.fields, key=lambda f: f.descriptor) for x in model.families)
    return [model.protocol.acknowledge, *(f for fields in families for f in fields)]


def entry(e: Entry) -> list[str]:
    """Returns the members of struct mip_entry."""
    name = field_name(e.field)
    return [
        literals.hexadecimal(e.field.descriptor),
        f"MIP_{upper(e.field.role)}",
        str(len(e.links)),
        str(e.first_link),
        literals.string(e.field.name),
        f"&{name}_codec",
        f"&{name}_command" if e.field.role == m.COMMAND else "NULL",
    ]


def sets(model: m.Model) -> Iterator[SetEntry]:
    """Yields all descriptor sets by number, after set 0 of the acknowledge, which represents all command sets."""
    acknowledge = model.protocol.acknowledge
    yield SetEntry(acknowledge.set, acknowledge.family, 0, 1)
    places: dict[str, tuple[int, int]] = {}
    first = 1
    for x in model.families:
        places[x.name] = first, len(x.fields)
        first += len(x.fields)
    yield from (SetEntry(s.number, s.name, *places[s.family]) for s in model.sets)


def entries(model: m.Model) -> Iterator[Entry]:
    order = _ordered(model)
    index = {f.full_name: i for i, f in enumerate(order)}
    first = 0
    for f in order:
        linked = model.responses(f) if f.role == m.COMMAND else model.commands(f)
        yield Entry(f, first, tuple(index[x.full_name] for x in linked))
        first += len(linked)


# --------------------------------------------------------------------------- reflection

_WIDTH = 100  # columns, as in .clang-format

#: Kinds of parameters with a different name in C.
_KINDS = {"scalar": "NUMBER", "switch": "UNION"}


def names(t: m.Enum | m.Bitfield) -> str:
    """Returns the name of the table with the names of a type's values or bits."""
    return f"mip_names_{bare(t)}"


def labels(parts: Sequence[m.EnumValue | m.Bits]) -> str:
    """Writes names as one string, each followed by a NUL; after the last name, it is the string's own."""
    return " ".join([*(f'"{part.name}\\0"' for part in parts[:-1]), *(f'"{part.name}"' for part in parts[-1:])]) or '""'


def numbers(t: m.Enum) -> str:
    return ", ".join(literals.number(v.value, t.scalar.size) for v in t.values)


def array(declaration: str, rows: Iterable[Sequence[str]], length: Callable[[str], int] = len) -> str:
    """Defines an array of structures in its final layout: that of clang-format, which takes long, and much memory, for
    such tables. `length` is that of a text in which the package is renamed later.

    >>> a, b, c = "a" * 60, "b" * 30, "c" * 60
    >>> print(array("static const struct pair pairs[]", [[a, b, "1"], [b, f"f({a}, {c})", "2"]]))
    // final: begin
    static const struct pair pairs[] = {
        {aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa, bbbbbbbbbbbbbbbbbbbbbbbbbbbbbb,
         1},
        {bbbbbbbbbbbbbbbbbbbbbbbbbbbbbb,
         f(aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa,
           cccccccccccccccccccccccccccccccccccccccccccccccccccccccccccc),
         2},
    };
    // final: end
    """
    begin, indent = (" = {", 4) if length(declaration) + len(" = {") <= _WIDTH else (" =\n    {", 8)
    lines = [line for row in rows for line in _row(row, " " * indent, length)]
    return CLANG_FORMAT.final("\n".join([declaration + begin, *lines, "};"]))


def _row(members: Sequence[str], indent: str, length: Callable[[str], int]) -> list[str]:
    """Returns the lines of a structure: as many members on a line as fit, and a call on two lines if it is too long."""
    lines, end = [f"{indent}{{{members[0]},"], len(indent) + length(members[0]) + 2
    for text in (*(f"{each}," for each in members[1:-1]), f"{members[-1]}}},"):
        size = 1 + length(text)
        if end + size <= _WIDTH:
            lines[-1] += f" {text}"
            end += size
        elif len(indent) + size <= _WIDTH or ", " not in text:
            lines.append(f"{indent} {text}")
            end = len(indent) + size
        else:
            call, _, rest = text.partition(", ")
            lines += [f"{indent} {call},", " " * (len(indent) + 2 + length(call[: call.index("(")])) + rest, indent]
            end = len(indent)
    return [line for line in lines if line.strip()]


def parameter(p: m.Parameter, record: m.Record, union: m.Parameter | None = None) -> list[str]:
    """Returns the members of struct mip_parameter; `union` is the union that contains the parameter, if one does."""
    item, full = p.leaf, bare(record)
    numbers = {q.name: i for i, q in enumerate(record.parameters)}
    by = p.tag or p.counts or p.counter
    scalar = upper(item.scalar.name) if item.kind in ("scalar", "constant", "counter") else "U8"
    length = {int: "FIXED", str: "REST" if p.fills else "COUNTED"}.get(type(p.length), "ONE")
    readings = () if union else p.readings
    return [
        literals.string(p.name),
        literals.string(", ".join(m.unit_symbols(p.units))),
        f"MIP_KIND_{_KINDS.get(item.kind, upper(item.kind))}",
        f"MIP_SCALAR_{scalar}",
        f"MIP_LENGTH_{length}",
        str(p.capacity if p.length is not None else 1),
        str(len(p.elements) or 1),
        str(numbers.get(by or "", 0)),
        str(0 if union else record.present_with.get(p.name, 0)),
        literals.number(p.constant or 0, p.size if p.kind == "constant" else 1),
        *_place(p, record, union),
        f"&{names(item.named)}" if item.named else "NULL",
        f"readings_{full}_{p.name}" if readings else "NULL",
        f"&record_{bare(item.struct)}" if item.struct else "NULL",
        f"cases_{full}_{p.name}" if p.cases else "NULL",
        str(len(readings or p.cases)),
    ]


def _place(p: m.Parameter, record: m.Record, union: m.Parameter | None) -> tuple[str, ...]:
    """Writes the offset and size of a member, and the offset of its item count."""
    if not union and p not in members(record):
        return "0", "0", "0"
    within = f"union {union_name(union, record)}" if union else f"struct {symbol(record)}"
    name = (home(p) if union else "") + member(p.name)
    size = "ONE" if p.length is None else "MANY"
    return f"{size}({within}, {name})", f"offsetof({within}, {name}_count)" if p.fills else "0"


def cases(p: m.Parameter, record: m.Record) -> Iterator[tuple[str, str]]:
    """Yields the members of struct mip_case: the value of the tag, and the parameter that it selects."""
    for case in p.cases:
        place = p.alternatives.index(case.parameter) if case.parameter else 0
        member = f"&members_{bare(record)}_{p.name}[{place}]" if case.parameter else "NULL"
        yield literals.number(case.tag.value, 4), member


def reflection(f: m.Field) -> list[str]:
    """Returns the members of struct mip_reflection."""
    name, table = field_name(f), f"required_{bare(f)}"
    return [
        f"&{name}_codec",
        f"&record_{bare(f)}",
        "true" if f.functions else "false",
        "true" if f.optional else "false",
        table if f.functions else "NULL",
        f"sizeof({table})" if f.functions else "0",
        f"offsetof(struct {name}, present)" if f.optional else "0",
    ]


def readings(p: m.Parameter, record: m.Record) -> Iterator[list[str]]:
    """Yields the members of struct mip_reading: device, or index and value of the selecting parameter; and the
    names."""
    numbers = {q.name: i for i, q in enumerate(record.parameters)}
    for v in p.readings:
        assert v.type is not None
        device = literals.string(v.key if v.by_device else None)
        yield [device, str(numbers.get(v.by, 0)), str(v.value or 0), f"&{names(v.type)}"]
