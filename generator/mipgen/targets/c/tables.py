"""Rows of the tables that programs search: registry and reflection."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from mipgen import model as m
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


def parameter(p: m.Parameter, record: m.Record, union: m.Parameter | None = None) -> str:
    """Writes the members of struct mip_parameter; `union` is the union that contains the parameter, if one does."""
    item, full = p.leaf, bare(record)
    numbers = {q.name: i for i, q in enumerate(record.parameters)}
    by = p.tag or p.counts or p.counter
    scalar = upper(item.scalar.name) if item.kind in ("scalar", "constant", "counter") else "U8"
    length = {int: "FIXED", str: "REST" if p.fills else "COUNTED"}.get(type(p.length), "ONE")
    readings = () if union else p.readings
    row = [
        literals.string(p.name),
        literals.string(", ".join(p.units)),
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
    return ", ".join(row)


def _place(p: m.Parameter, record: m.Record, union: m.Parameter | None) -> tuple[str, str]:
    """Writes the location of a member, and the offset of its item count."""
    if not union and p not in members(record):
        return "0, 0", "0"
    within = f"union {union_name(union, record)}" if union else f"struct {symbol(record)}"
    name = (home(p) if union else "") + member(p.name)
    size = "ONE" if p.length is None else "MANY"
    return f"{size}({within}, {name})", f"offsetof({within}, {name}_count)" if p.fills else "0"


def reflection(f: m.Field) -> str:
    """Writes the members of struct mip_reflection."""
    name, table = field_name(f), f"required_{bare(f)}"
    row = [
        f"&{name}_codec",
        f"&record_{bare(f)}",
        "true" if f.functions else "false",
        "true" if f.optional else "false",
        table if f.functions else "NULL",
        f"sizeof({table})" if f.functions else "0",
        f"offsetof(struct {name}, present)" if f.optional else "0",
    ]
    return ", ".join(row)


def readings(p: m.Parameter, record: m.Record) -> Iterator[str]:
    """Yields the members of struct mip_reading: device, or index and value of the selecting parameter; and the
    names."""
    numbers = {q.name: i for i, q in enumerate(record.parameters)}
    for v in p.readings:
        assert v.type is not None
        device = literals.string(v.key if v.by_device else None)
        yield f"{device}, {numbers.get(v.by, 0)}, {v.value or 0}, &{names(v.type)}"
