"""Records: their members, and the methods that make and read them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from mipgen import model as m
from mipgen.base.reads import Memo
from mipgen.lower import calls, extent, presence
from mipgen.model.parameters import alike

from .names import (
    Record,
    constant,
    constants,
    constructor,
    home,
    inner,
    member,
    module,
    path,
    scalar,
    type_name,
    variant,
)

BOOL = scalar(m.SCALARS["bool"])
DEFAULT = "core::default::Default::default()"

#: Records are `Copy` up to this size on the wire, and larger ones are not: a copy should be seen.
MAX_COPIED = 64


@dataclass(frozen=True, slots=True)
class Member:
    """A parameter that a record holds: whatever does not follow from others."""

    name: str
    type: str
    may_be_absent: bool
    parameter: m.Parameter

    @property
    def whole_type(self) -> str:
        return f"Option<{self.type}>" if self.may_be_absent else self.type

    @property
    def argument(self) -> str:
        """The type of an argument that becomes this member: what is easy to give."""
        if self.type == BOOL:
            return "bool"
        vector = isinstance(self.parameter.element, m.Vector) and self.parameter.length is None
        return f"impl Into<{self.type}>" if vector or self.type.startswith("crate::List<") else self.type

    @property
    def default(self) -> str:
        """What it is by default, as an expression."""
        if self.may_be_absent:
            return "None"
        return reserved(self.parameter) if self.parameter.reserved else default(self.parameter.operation)


@dataclass(frozen=True, slots=True)
class Constructor:
    name: str
    description: str
    function: m.Function | None
    given: tuple[Member, ...]  # the arguments
    set: tuple[tuple[str, str], ...]  # other members, and what they become


@dataclass(frozen=True, slots=True)
class Union:
    name: str
    record: Record  # that it is defined beside
    operation: m.SwitchOp

    @property
    def default(self) -> str:
        """The alternative of tag 0, as an expression."""
        case = next((c for c in self.operation.cases if c.tag.value == 0), None)
        if case is None:
            return f"{self.name}::Other({path(self.operation.tag_type, home(self.record))}(0))"
        value = f"({default(case.operation)})" if case.operation else ""
        return f"{self.name}::{variant(case.tag.name)}{value}"


@dataclass(frozen=True, slots=True)
class Reading:
    """A method that reads a member as the type that names its values."""

    name: str
    type: str
    member: Member
    variants: tuple[m.Variant, ...]
    tag: Member | None  # the sibling that decides, if it is not the device

    @property
    def pattern(self) -> str:
        """The values of the sibling that select the type."""
        assert self.tag is not None
        values = " | ".join(f"{self.tag.type}::{constant(v.key)}" for v in self.variants)
        return f"Some({values})" if self.tag.may_be_absent else values


@dataclass(frozen=True, slots=True)
class Conversion:
    """From one named type to another that it is read as."""

    of: m.Enum | m.Bitfield
    to: m.Enum | m.Bitfield
    record: Record  # where it is read so first
    reading: Reading

    @property
    def needs(self) -> list[str]:
        """The features of the families that own the types."""
        return sorted({home(self.of), home(self.to)} - {"types"})


class Records:
    """The records of a model."""

    def __init__(self, model: m.Model) -> None:
        self.model = model
        self.unions: list[Union] = []
        self._members: Memo[int, list[Member]] = Memo()  # those of a record, by its identity
        for record in self.all():
            for p in record.parameters:
                if isinstance(p.operation, m.SwitchOp) and self._union(p.operation, home(record)) is None:
                    self.unions.append(Union(type_name(f"{record.name}_{p.name}"), record, p.operation))

    def all(self) -> Iterator[Record]:
        yield from structs(self.model.types)
        yield self.model.protocol.acknowledge
        for family in self.model.families:
            yield from structs(family.types)
            yield from family.fields

    # ------------------------------------------------------------------ types

    def unions_of(self, record: Record) -> list[Union]:
        return [u for u in self.unions if u.record is record]

    def union(self, op: m.SwitchOp, here: str) -> Union:
        """Unions of a module that have the same alternatives are one type."""
        found = self._union(op, here)
        assert found is not None
        return found

    def _union(self, op: m.SwitchOp, here: str) -> Union | None:
        same = (u for u in self.unions if home(u.record) == here and u.operation.tag_type == op.tag_type)
        return next((u for u in same if alike(u.operation.cases, op.cases)), None)

    def rust(self, op: m.Operation, here: str) -> str:
        """The type of what an operation reads."""
        match op:
            case m.ScalarOp() | m.BitsOp() if op.type:
                return path(op.type, here)
            case m.ScalarOp():
                return scalar(op.scalar)
            case m.TextOp():
                return f"crate::Text<{op.count}>" if op.count is not None else f"crate::VarText<{op.capacity}>"
            case m.ArrayOp() if op.vector is not None:
                return path(op.vector, here)
            case m.ArrayOp():
                item = self.rust(op.item, here)
                return f"[{item}; {op.count}]" if op.count is not None else f"crate::List<{item}, {op.capacity}>"
            case m.StructOp():
                return path(op.struct, here)
            case m.SwitchOp():
                return self.union(op, here).name
        raise AssertionError(op)

    # ------------------------------------------------------------------ members

    def members(self, record: Record) -> list[Member]:
        return self._members.get(id(record), self._made, record)

    def _made(self, record: Record) -> list[Member]:
        absent = presence.last(record)
        return [
            Member(member(p.name), self.rust(p.operation, home(record)), p.name in absent, p)
            for p in record.parameters
            if not p.derived
        ]

    def members_of(self, group: m.GroupOp, record: Record) -> list[Member]:
        return [x for x in self.members(record) if x.parameter.operation in group.body]

    def derives(self, record: Record) -> list[str]:
        """The traits that a record derives besides those of all records."""
        selects = isinstance(record, m.Field) and record.selector
        default = ["Default"] if self.derives_default(record) and not selects else []
        return sorted([*default, *_derives(record.operations, record.max_size)])

    def derives_default(self, record: Record) -> bool:
        """Is the default of each member the one of its type?"""
        return all(x.default in ("None", DEFAULT) for x in self.members(record))

    # ------------------------------------------------------------------ constructors and setters

    def constructors(self, record: Record) -> list[Constructor]:
        return [self._constructor(record, way) for way in calls.constructors(record)]

    def _constructor(self, record: Record, way: calls.Constructor) -> Constructor:
        """The caller gives no reserved values, and no tag whose union is given."""
        given, values = [], []
        for x in self.members(record):
            p = x.parameter
            if p in way.values and p.name not in way.unions:
                given.append(x)
            elif p in way.values:
                values.append((x.name, f"{member(way.unions[p.name].name)}.tag()"))
            elif p in way.required:
                values.append((x.name, reserved(p)))
            elif not way.function:
                values.append((x.name, "None"))
        if way.function:
            return Constructor(
                constructor(way.function), way.function.description, way.function, tuple(given), tuple(values)
            )
        what = "the command from its parameters" if isinstance(record, m.Field) else "it from its values"
        return Constructor("new", f"Creates {what}.", None, tuple(given), tuple(values))

    def settable(self, record: Record) -> list[Member]:
        """What a caller may add to a command."""
        command = isinstance(record, m.Field) and record.role == m.COMMAND
        return [x for x in self.members(record) if command and x.parameter.optional]

    # ------------------------------------------------------------------ readings

    def readings(self, record: Record) -> list[Reading]:
        """One for each type that names the values of a member, on a device or beside a value of a sibling."""
        here, members = home(record), {x.parameter.name: x for x in self.members(record)}
        found = []
        for x in members.values():
            for t in dict.fromkeys(v.type for v in x.parameter.readings):
                if t is None or inner(t) != raw(x):
                    continue
                variants = tuple(v for v in x.parameter.readings if v.type == t)
                by = {v.by for v in variants}
                tag = None if m.DEVICE in by else members[by.pop()]
                found.append(Reading(f"{x.parameter.name}_as_{t.name}", path(t, here), x, variants, tag))
        return found

    def needs(self, family: m.Family) -> list[str]:
        """The features of the families whose types the fields of a family have."""
        records: list[Record] = [*family.fields, *structs(family.types)]
        used = [t for record in records for t in self._types(record)]
        used += [b.enum for t in (*family.types, *used) if isinstance(t, m.Bitfield) for b in t.bits if b.enum]
        return sorted({home(t) for t in used} - {"types", module(family.name)})

    def _types(self, record: Record) -> Iterator[m.Type]:
        yield from (v.type for p in record.parameters for v in p.readings if v.type)
        for op in _parts(record.operations):
            if op.named:
                yield op.named
            elif isinstance(op, m.StructOp):
                yield op.struct

    def conversions(self) -> list[Conversion]:
        """From the named types of members to the types that they are read as."""
        found: dict[tuple[str, str], Conversion] = {}
        for record in self.all():
            for reading in self.readings(record):
                of, to = reading.member.parameter.element, reading.variants[0].type
                if isinstance(of, (m.Enum, m.Bitfield)) and to is not None:
                    found.setdefault((of.name, to.name), Conversion(of, to, record, reading))
        return list(found.values())


def structs(types: Iterable[m.Type]) -> list[m.Struct]:
    return [t for t in types if isinstance(t, m.Struct)]


def union_derives(union: Union) -> list[str]:
    return _derives([union.operation], extent.size(union.operation)[1])


def responses_derive(responses: Iterable[m.Field]) -> list[str]:
    """What all responses derive, their enumeration does too."""
    found = [_derives(r.operations, r.max_size) for r in responses]
    return [name for name in ("Copy", "Eq", "Hash") if all(name in names for names in found)]


def _derives(operations: Iterable[m.Operation], size: int) -> list[str]:
    """`Copy` of what is small and has no lists, `Eq` and `Hash` of what has no floats."""
    parts = list(_parts(operations))
    lists = size > MAX_COPIED or any(op.open for op in parts)
    floats = any(isinstance(op, m.ScalarOp) and op.scalar.kind == "float" for op in parts)
    return [*([] if lists else ["Copy"]), *([] if floats else ["Eq", "Hash"])]


def _parts(operations: Iterable[m.Operation]) -> Iterator[m.Operation]:
    """The operations, and those inside of them."""
    for op in operations:
        yield op
        yield from _parts(op.inside)


def is_sequence(record: Record) -> bool:
    """Has it just its members on the wire, one after another?"""
    plain = not any(op.kind in ("constant", "counter", "switch", "group") for op in record.operations)
    return plain and not any(p.selector or member(p.name) != p.name for p in record.parameters)


def is_selector(op: m.Operation, record: Record) -> bool:
    return any(p.selector and p.operation is op for p in record.parameters)


def when(group: m.GroupOp, record: m.Field) -> str:
    """When a group must be there: for some functions, or never."""
    required = record.counted[group.first - 1].required_for
    return f"for {constants(required)}" if required else "optional"


def default(op: m.Operation) -> str:
    """The default of what an operation reads."""
    return f"[{DEFAULT}; {op.count}]" if is_long(op) and isinstance(op, m.ArrayOp) else DEFAULT


def raw(x: Member) -> str:
    """The type of its number, or of its bytes."""
    named = x.parameter.operation.named
    return inner(named) if named else x.type


def reserved(p: m.Parameter) -> str:
    """What is sent for a reserved parameter."""
    return f"[{p.reserved}; {p.length}]" if isinstance(p.length, int) else str(p.reserved)


def is_long(op: m.Operation) -> bool:
    """Is it an array that is too long for the traits of Rust and serde?"""
    return isinstance(op, m.ArrayOp) and op.vector is None and (op.count or 0) > 32
