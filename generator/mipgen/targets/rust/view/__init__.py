"""A model as Rust sees it: what the templates print."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

from mipgen import model as m
from mipgen.facts import describe
from mipgen.model.parameters import alike

from .. import docs, names
from ..docs import Block
from . import clocks
from .fields import Field, set_numbers
from .records import SET, Constructor, Record, Struct, Union

__all__ = ["Constructor", "Crate", "Record", "Union", "clocks", "part_names"]


class Crate:
    def __init__(self, model: m.Model) -> None:
        self.model = model
        self.docs = docs.Docs(model)
        records: list[m.Record] = [*m.structs(model.types), model.protocol.acknowledge]
        for x in model.families:
            records += (*m.structs(x.types), *x.fields)
        self.records: dict[tuple[str | None, str], Record] = {
            (r.owner, r.name): Field(self, r) if isinstance(r, m.Field) else Struct(self, r) for r in records
        }
        self.unions: list[Union] = []
        for record in self.records.values():
            for p in record.of.parameters:
                if p.union and self._union(p.union, record.home) is None:
                    name = names.type_name(p.union.name or f"{record.of.name}_{p.name}")
                    self.unions.append(Union(record, p, p.union, name, names.path(p.union.type, record.home)))

    def record(self, record: m.Record) -> Record:
        return self.records[record.owner, record.name]

    def type(self, t: m.Type) -> Type | Record:
        if isinstance(t, m.Struct):
            return self.record(t)
        macro = "open_enum" if isinstance(t, m.Enum) else t.kind
        inner = names.inner(t)
        for named in {b.when.type for b in (t.bits if isinstance(t, m.Bitfield) else ()) if b.when}:
            state = self.model.type(named)
            assert state is not None
            inner += f" while {names.path(state, names.home(t))}"
        needs = self.needs.get(t.name, "") if names.home(t) == "types" else ""
        return Type(self.docs.type(t), macro, names.type_name(t.name), inner, list(parts(t, self.docs)), needs)

    @cached_property
    def needs(self) -> dict[str, str]:
        """The condition under which an enumeration or a bitfield of several families is used, by its name. Each takes
        as long to compile as some fields, so that a program with few sets should not have all of them."""
        users: dict[str, set[str]] = {}
        for record in self.records.values():
            for t in record.used_types:
                bits = t.bits if isinstance(t, m.Bitfield) else ()
                named = (x for b in bits for x in (b.enum, self.model.type(b.when.type) if b.when else None))
                for used in (t, *named):
                    if isinstance(used, (m.Enum, m.Bitfield)):
                        users.setdefault(used.name, set()).add(record.home)
        conditions: dict[str, str] = {}
        families = {names.module(x.name) for x in self.model.families}
        for everywhere in (self.model.protocol.function_selector, self.model.protocol.ack_code):
            users.pop(everywhere.name, None)
        for name, homes in users.items():
            features = [f'feature = "{home}"' for home in sorted(homes)]
            if len(features) < 3 and homes <= families:  # structures of several families are always there
                conditions[name] = features[0] if len(features) == 1 else f"any({', '.join(features)})"
        return conditions

    @property
    def types(self) -> list[Type | Record]:
        """The types that several families use."""
        return [self.type(t) for t in (self.model.protocol.function_selector, *self.model.types)]

    @cached_property
    def families(self) -> list[Family]:
        return [Family(self, x) for x in self.model.families]

    @property
    def acknowledge(self) -> Record:
        return self.record(self.model.protocol.acknowledge)

    @property
    def ack_code(self) -> str:
        return names.type_name(self.model.protocol.ack_code.name)

    @property
    def sets(self) -> list[tuple[str, m.Set]]:
        return [(names.module(s.name).upper(), s) for s in self.model.sets]

    @property
    def functions(self) -> list[tuple[str, str]]:
        """The constant of each function selector, and the type of a command with it."""
        return [(names.constant(f.name), names.call_type(f)) for f in self.model.protocol.functions]

    @property
    def groups(self) -> Iterator[tuple[str, str, list[Record]]]:
        """All fields in the order in which the registry searches them, by family, the acknowledge last: the feature
        that they need, and the sets in which any of them occurs."""
        for x in self.families:
            if x.fields:
                everywhere = x.of.fields[0].everywhere
                sets = everywhere or sorted({n for f in x.of.fields for n in f.sets})
                yield f'feature = "{x.name}"', set_numbers(sets, " | "), x.fields
        yield "all()", set_numbers(self.model.protocol.acknowledge.sets, " | "), [self.acknowledge]

    @property
    def conversions(self) -> Iterator[tuple[list[Block], list[str], str, str]]:
        """The conversions between named types that readings need: comment, conditions, the type, and the new one."""
        done: set[tuple[str, str]] = set()
        for reading in (reading for record in self.records.values() for reading in record.readings):
            source, target = reading.member.parameter.element, reading.variants[0].type
            if isinstance(source, (m.Enum, m.Bitfield)) and target and (source.name, target.name) not in done:
                done.add((source.name, target.name))
                features = [f'feature = "{x}"' for x in {names.home(x): None for x in (source, target)} if x != "types"]
                needs = (self.needs.get(x.name, "") for x in (source, target) if names.home(x) == "types")
                conditions = sorted({*features, *needs} - {""})
                yield [reading.applies("types")], conditions, names.path(source, "types"), names.path(target, "types")

    @property
    def devices(self) -> Iterator[Device]:
        for d in self.model.devices:
            name = names.constant(d.name)
            constants = {e: f"{name}_{i}" for i, e in enumerate(d.evidence, 1)}
            codes = {v.value: f"AckCode::{names.constant(v.name)}" for v in self.model.protocol.ack_code.values}
            fields = [
                (member, [(s, names.selector_macros(s.functions), constants[s.evidence]) for s in supports])
                for member, supports in (("fields", d.supports), ("refuses", d.refuses))
            ]
            yield Device(
                of=d,
                name=name,
                doc=self.docs.device(d),
                evidence=[(constants[e], e, describe.why(e, self.model)) for e in d.evidence],
                fields=fields,
                absent_sets=[(s.number, constants[e]) for e in d.evidence for s in e.sets],
                variants=[(v, self.docs.difference(v)) for v in d.variants],
                ack_codes=[codes[code] for code in d.ack_codes],
            )

    # ------------------------------------------------------------------ the types of parameters

    def type_of(self, p: m.Parameter, here: str) -> str:
        """Returns the type of a parameter inside the module `here`."""
        if p.union:
            return self.union(p.union, here).name
        if t := p.named or p.vector or p.struct:
            return names.path(t, here)
        if p.kind == "text":
            return f"crate::VarText<{p.capacity}>" if p.open else f"crate::Text<{p.count}>"
        if p.kind == "array":
            item = self.type_of(p.item, here)
            return f"crate::List<{item}, {p.capacity}>" if p.open else f"[{item}; {p.count}]"
        return SET if p.shown == "set" and not p.readings else names.scalar(p.scalar)

    def union(self, union: m.Union, here: str) -> Union:
        """Returns a union's type; unions with the same alternatives in one module share it."""
        view = self._union(union, here)
        assert view is not None
        return view

    def _union(self, union: m.Union, here: str) -> Union | None:
        same = (u for u in self.unions if u.record.home == here and u.of.type is union.type)
        return next((u for u in same if alike(u.of.cases, union.cases)), None)


@dataclass(frozen=True)
class Family:
    """A family of descriptor sets: a module, and a feature of the same name."""

    crate: Crate
    of: m.Family

    @cached_property
    def name(self) -> str:
        return names.module(self.of.name)

    @property
    def numbers(self) -> str:
        return docs.set_numbers(self.of)

    @property
    def doc(self) -> list[Block]:
        return self.crate.docs.family(self.of)

    @property
    def sets(self) -> list[tuple[list[Block], str, int]]:
        """The sets whose numbers packets contain: each with its comment and its constant."""
        single: list[Block] = ["The number of the descriptor set."]
        return [
            (self.crate.docs.set(s) if len(self.of.sets) > 1 else single, name, s.number)
            for s in self.of.sets
            if (name := names.set_constant(s, self.of))
        ]

    @property
    def types(self) -> list[Type | Record]:
        return [self.crate.type(t) for t in self.of.types]

    @cached_property
    def fields(self) -> list[Record]:
        return [self.crate.record(f) for f in self.of.fields]

    @property
    def needs(self) -> list[str]:
        """The features of the families whose types its fields use."""
        records: list[m.Record] = [*self.of.fields, *m.structs(self.of.types)]
        used = [t for record in records for t in self.crate.record(record).used_types]
        used += [b.enum for t in (*self.of.types, *used) if isinstance(t, m.Bitfield) for b in t.bits if b.enum]
        return sorted({names.home(t) for t in used} - {"types", self.name})


@dataclass(frozen=True, slots=True)
class Type:
    """An enumeration, a bitfield or a vector."""

    doc: list[Block]
    macro: str
    name: str
    inner: str
    parts: list[tuple[list[Block], list[str]]]  # the comment and the lines of each value, bit or element
    needs: str = ""  # the condition under which it is there


def parts(t: m.Enum | m.Bitfield | m.Vector, about: docs.Docs) -> Iterator[tuple[list[Block], list[str]]]:
    match t:
        case m.Enum():
            for v in t.values:
                yield about.part(v, t), [f'{names.constant(v.name)} = {v.value}, "{v.name}";']
        case m.Bitfield():
            for b in t.bits:
                last = f"..={b.last}" if b.width > 1 else ""
                state = f" while [{', '.join(map(str, b.when.numbers))}]" if b.when else ""
                place = f"{names.constant(b.name)}: {names.bits_type(b, names.home(t))} = {b.first}{last}{state},"
                methods = f"    {names.with_words(names.method, b.name)}, set_{b.name}, with_{b.name};"
                yield about.part(b, t), [place, methods]
        case m.Vector():
            for e in t.elements:
                yield [f"The element {e}."], [f"{names.member(e)},"]


def part_names(t: m.Type) -> Iterator[tuple[str, m.EnumValue | m.Bits]]:
    """Yields the names of the constants and methods of values and bits, and what each is named after."""
    for part in m.named_parts(t):
        yield names.constant(part.name), part
        if isinstance(part, m.Bits):
            yield from ((name, part) for name in (names.method(part.name), f"set_{part.name}", f"with_{part.name}"))


@dataclass(frozen=True, slots=True)
class Device:
    of: m.Device
    name: str
    doc: list[Block]
    evidence: list[tuple[str, m.Evidence, str]]  # the constant and the reason
    fields: list[tuple[str, list[tuple[m.Support, str, str]]]]  # by member: the functions, and a constant of evidence
    absent_sets: list[tuple[int, str]]
    variants: list[tuple[m.DeviceVariant, str]]
    ack_codes: list[str]
