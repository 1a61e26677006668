"""The tables that programs search: registry and reflection."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from mipgen import model as m
from mipgen.emit.naming import upper
from mipgen.lower.memory import stored

from . import literals
from .members import capacity, union_prefix
from .names import bare, field_name, member, names_table, symbol, union_name, union_owner


def required(f: m.Field) -> list[int]:
    """Returns the number of parameters that each function requires; the index is the function's value."""
    return [f.required(value) for value in range(max(x.value for x in f.functions) + 1)]


# --------------------------------------------------------------------------- registry


@dataclass(frozen=True, slots=True)
class Registry:
    """The tables of runtime/c/src/mip/extra/registry.h."""

    entries: str
    sets: list[str]
    links: list[str]  # for each entry with responses or commands, the entries of these


def registry(model: m.Model) -> Registry:
    """Lists the acknowledge, then all fields by family, descriptor and order in the specification."""
    acknowledge, places, links = model.protocol.acknowledge, dict[str, str](), list[list[str]]()
    order = [acknowledge]
    for x in model.families:
        places[x.name] = f"{len(order)}, {len(x.fields)}"
        order += sorted(x.fields, key=lambda f: f.descriptor)
    index = {f.full_name: str(i) for i, f in enumerate(order)}
    entries = []
    for f in order:
        linked, name = model.responses(f) if f.role == m.COMMAND else model.commands(f), field_name(f)
        entries.append([
            literals.hexadecimal(f.descriptor),
            f"MIP_{upper(f.role)}",
            str(len(linked)),
            str(sum(map(len, links))),
            literals.string(f.name),
            f"&{name}_codec",
            f"&{name}_command" if f.role == m.COMMAND else "NULL",
        ])  # fmt: skip
        links.append([index[x.full_name] for x in linked])
    # set 0 is that of the acknowledge, and represents all command sets
    sets = [(acknowledge.set, "0, 1", acknowledge.family), *((s.number, places[s.family], s.name) for s in model.sets)]
    rows = [f"{{{literals.hexadecimal(number)}, {place}, {literals.string(name)}}}" for number, place, name in sets]
    table = array("const struct mip_entry mip_registry[]", entries)
    return Registry(table, rows, [", ".join(x) for x in links if x])


# --------------------------------------------------------------------------- reflection

#: Kinds of parameters with a different name in C.
_KINDS = {"scalar": "NUMBER", "switch": "UNION"}


def array(declaration: str, rows: Sequence[Sequence[str]]) -> str:
    """Defines an array of structures, each of which begins a line."""
    return "\n".join([f"{declaration} = {{", *(f"{{{', '.join(row)}}}," for row in rows), "};"])


def reflected(r: m.Record, model: m.Model) -> Iterator[tuple[str, list[list[str]]]]:
    """Yields the tables of a record, each with its declaration: the types that its parameters may have, the
    alternatives of its unions, and its parameters."""
    name = bare(r)
    for p in r.parameters:
        if p.readings:
            yield f"static const struct mip_reading readings_{name}_{p.name}[]", [*_readings(p, r)]
    for p in r.parameters:
        if p.alternatives:
            rows = [_parameter(a, r, model, p) for a in p.alternatives]
            yield f"static const struct mip_parameter members_{name}_{p.name}[]", rows
        if p.cases:
            yield f"static const struct mip_case cases_{name}_{p.name}[]", [*_cases(p, r)]
    if r.parameters:
        yield f"static const struct mip_parameter parameters_{name}[]", [_parameter(p, r, model) for p in r.parameters]


def _parameter(p: m.Parameter, record: m.Record, model: m.Model, union: m.Parameter | None = None) -> list[str]:
    """Returns the members of struct mip_parameter; `union` is the union that contains the parameter, if one does."""
    item, full = p.leaf, bare(record)
    scalar = upper(item.scalar.name) if item.kind in ("scalar", "constant", "counter") else "U8"
    kind = f"MIP_KIND_{_KINDS.get(item.kind, upper(item.kind))}", f"MIP_SCALAR_{scalar}", *_length(p)
    numbers = {q.name: i for i, q in enumerate(record.parameters)}
    by = p.tag or p.counts or p.counter or _state(p)
    readings = () if union else p.readings
    types = (
        f"&{names_table(item.named)}" if item.named else "NULL",
        f"readings_{full}_{p.name}" if readings else "NULL",
        f"&record_{bare(item.struct)}" if item.struct else "NULL",
        f"cases_{full}_{p.name}" if p.cases else "NULL",
        str(len(readings or p.cases)),
    )
    # what most rows contain has a name, see reflection.c.j2
    return [
        literals.string(p.name),
        literals.string(", ".join(m.unit_symbols(p.units))),
        *([f"NUMBER({scalar})"] if item.kind == "scalar" and _length(p) == _ONE else kind),
        str(numbers.get(by or "", 0)),
        str(0 if union else record.present_with.get(p.name, 0)),
        literals.number(p.constant or 0, p.size if p.kind == "constant" else 1),
        *_place(p, record, model, union),
        *(types if item.named or readings or item.struct or p.cases else ["NONE"]),
    ]


def _state(p: m.Parameter) -> str | None:
    """Returns the parameter on which the meaning of bits depends."""
    types = [p.leaf.named, *(v.type for v in p.readings)]
    bits = (b for t in types if isinstance(t, m.Bitfield) for b in t.bits)
    return next((b.when.parameter for b in bits if b.when), None)


#: The length of a parameter that is no array: how it is stated, the capacity, and the number of elements of a union.
_ONE = ("MIP_LENGTH_ONE", "1", "1")


def _length(p: m.Parameter) -> tuple[str, str, str]:
    length = {int: "FIXED", str: "REST" if p.fills else "COUNTED"}.get(type(p.length), "ONE")
    return f"MIP_LENGTH_{length}", capacity(p) if p.length is not None else "1", str(len(p.elements) or 1)


def _place(p: m.Parameter, record: m.Record, model: m.Model, union: m.Parameter | None) -> tuple[str, ...]:
    """Writes the offset and size of a member, and the offset of its item count."""
    if not union and p not in stored(record):
        return "0", "0", "0"
    within = f"union {union_name(union, union_owner(union, record, model))}" if union else f"struct {symbol(record)}"
    name = (union_prefix(p) if union else "") + member(p.name)
    size = "ONE" if p.length is None else "MANY"
    return f"{size}({within}, {name})", f"offsetof({within}, {name}_count)" if p.fills else "0"


def _cases(p: m.Parameter, record: m.Record) -> Iterator[list[str]]:
    """Yields the members of struct mip_case: the value of the tag, and the parameter that it selects."""
    for case in p.cases:
        place = p.alternatives.index(case.parameter) if case.parameter else 0
        member = f"&members_{bare(record)}_{p.name}[{place}]" if case.parameter else "NULL"
        yield [literals.number(case.tag.value, 4), member]


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


def _readings(p: m.Parameter, record: m.Record) -> Iterator[list[str]]:
    """Yields the members of struct mip_reading: device, or index and value of the selecting parameter; and the
    names."""
    numbers = {q.name: i for i, q in enumerate(record.parameters)}
    for v in p.readings:
        assert v.type is not None
        device = literals.string(v.key if v.by_device else None)
        yield [device, str(numbers.get(v.by, 0)), str(v.value or 0), f"&{names_table(v.type)}"]
