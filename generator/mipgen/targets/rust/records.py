"""Records: their members, and the methods that make and read them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import accumulate

from mipgen import model as m
from mipgen.lower import calls, extent
from mipgen.model.parameters import alike

from .names import (
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

#: Records up to this size on the wire are `Copy`. Larger ones are not, so that copies are explicit.
MAX_COPIED = 64


@dataclass(frozen=True, slots=True)
class Member:
    """A member of a record: a parameter that does not follow from others."""

    name: str
    type: str
    may_be_absent: bool
    parameter: m.Parameter

    @property
    def whole_type(self) -> str:
        return f"Option<{self.type}>" if self.may_be_absent else self.type

    @property
    def argument(self) -> str:
        """The type of an argument that becomes this member, in a form that is easy to pass."""
        if self.type == BOOL:
            return "bool"
        return f"impl Into<{self.type}>" if self.parameter.vector or self.type.startswith("crate::List<") else self.type

    @property
    def default(self) -> str:
        """Its default value, as an expression."""
        if self.may_be_absent:
            return "None"
        return reserved(self.parameter) if self.parameter.reserved else default(self.parameter)


@dataclass(frozen=True, slots=True)
class Place:
    """A member at a fixed offset."""

    member: Member
    offset: int

    @property
    def type(self) -> str:
        """The type that a view returns: another view of a structure, the value of anything else."""
        return f"{' as ' if self.member.parameter.struct else ': '}{self.member.type}"


@dataclass(frozen=True, slots=True)
class Constructor:
    name: str
    description: str
    function: m.Function | None
    given: tuple[Member, ...]  # the arguments
    set: tuple[tuple[str, str], ...]  # other members, and their values


@dataclass(frozen=True, slots=True)
class Union:
    name: str
    record: m.Record  # the record beside which it is defined
    parameter: m.Parameter
    of: m.Union

    @property
    def default(self) -> str:
        """The alternative of tag 0, as an expression."""
        case = next((c for c in self.of.cases if c.tag.value == 0), None)
        if case is None:
            return f"{self.name}::Other({path(self.of.type, home(self.record))}(0))"
        value = f"({default(case.parameter)})" if case.parameter else ""
        return f"{self.name}::{variant(case.tag.name)}{value}"


@dataclass(frozen=True, slots=True)
class Reading:
    """A method that reads a member as the type that names its values."""

    name: str
    type: str
    member: Member
    variants: tuple[m.Variant, ...]
    tag: Member | None  # the parameter that selects the type, unless the device does

    @property
    def pattern(self) -> str:
        """The values of the other parameter that select the type."""
        assert self.tag is not None
        values = " | ".join(f"{self.tag.type}::{constant(v.key)}" for v in self.variants)
        return f"Some({values})" if self.tag.may_be_absent else values


@dataclass(frozen=True, slots=True)
class Conversion:
    """A conversion from one named type to another, as which its values can be read."""

    of: m.Enum | m.Bitfield
    to: m.Enum | m.Bitfield
    record: m.Record  # the first record that needs it
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
        self._members: dict[int, list[Member]] = {}  # by the identity of a record
        for record in self.all():
            for p in record.parameters:
                if p.union and self._union(p.union, home(record)) is None:
                    self.unions.append(Union(type_name(f"{record.name}_{p.name}"), record, p, p.union))

    def all(self) -> Iterator[m.Record]:
        yield from m.structs(self.model.types)
        yield self.model.protocol.acknowledge
        for family in self.model.families:
            yield from m.structs(family.types)
            yield from family.fields

    # ------------------------------------------------------------------ types

    def unions_of(self, record: m.Record) -> list[Union]:
        return [u for u in self.unions if u.record is record]

    def union(self, of: m.Union, here: str) -> Union:
        """Returns a union's type; unions with the same alternatives in one module share it."""
        union = self._union(of, here)
        assert union is not None
        return union

    def _union(self, of: m.Union, here: str) -> Union | None:
        same = (u for u in self.unions if home(u.record) == here and u.of.type is of.type)
        return next((u for u in same if alike(u.of.cases, of.cases)), None)

    def rust(self, p: m.Parameter, here: str) -> str:
        """Returns the type of a parameter."""
        if p.union:
            return self.union(p.union, here).name
        if t := p.named or p.vector or p.struct:
            return path(t, here)
        if p.kind == "text":
            return f"crate::VarText<{p.capacity}>" if p.open else f"crate::Text<{p.count}>"
        if p.kind == "array":
            item = self.rust(p.item, here)
            return f"crate::List<{item}, {p.capacity}>" if p.open else f"[{item}; {p.count}]"
        return scalar(p.scalar)

    # ------------------------------------------------------------------ members

    def members(self, record: m.Record) -> list[Member]:
        if id(record) not in self._members:
            self._members[id(record)] = self._made(record)
        return self._members[id(record)]

    def _made(self, record: m.Record) -> list[Member]:
        return [
            Member(member(p.name), self.rust(p, home(record)), p.name in record.present_with, p)
            for p in calls.members(record)
        ]

    def places(self, record: m.Record) -> list[Place]:
        """Returns the members and their offsets; nothing unless all are always present at fixed offsets."""
        sizes = [extent.size(p) for p in record.parameters]
        if is_special(record) or any(least != most for least, most in sizes):
            return []
        offsets = accumulate((least for least, _ in sizes), initial=0)
        return [Place(x, offset) for x, offset in zip(self.members(record), offsets, strict=False)]

    def members_of(self, group: m.Group, record: m.Record) -> list[Member]:
        return [x for x in self.members(record) if x.parameter in group.parameters]

    def derives(self, record: m.Record) -> list[str]:
        """Returns the traits that a record derives besides those of all records."""
        default = ["Default"] if self.derives_default(record) and not record.selector else []
        return sorted([*default, *_derives(record.parameters, record.max_size)])

    def derives_default(self, record: m.Record) -> bool:
        """Is the default of each member the default of its type?"""
        return all(x.default in ("None", DEFAULT) for x in self.members(record))

    # ------------------------------------------------------------------ constructors and setters

    def constructors(self, record: m.Record) -> list[Constructor]:
        """Returns the constructors of a record. Simulators and tests use those of data and responses."""
        ways = calls.constructors(record)
        if isinstance(record, m.Field) and record.role != m.COMMAND and record.parameters:
            ways = record.calls
        return [self._constructor(record, way) for way in ways]

    def _constructor(self, record: m.Record, way: m.Call) -> Constructor:
        """Makes a constructor. A caller passes neither reserved values nor the tag of a union."""
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
        command = isinstance(record, m.Field) and record.role == m.COMMAND
        what = "the command from its parameters" if command else "it from its values"
        return Constructor("new", f"Creates {what}.", None, tuple(given), tuple(values))

    def tuple_of(self, record: m.Struct) -> list[Member]:
        """Returns the members to which a tuple of two to four values converts; none if it has other members, too."""
        (way,) = self.constructors(record)
        return list(way.given) if 2 <= len(way.given) <= 4 and not way.set else []

    def settable(self, record: m.Record) -> list[Member]:
        """Returns the optional parameters that a caller may set in a command."""
        command = isinstance(record, m.Field) and record.role == m.COMMAND
        return [x for x in self.members(record) if command and x.parameter.optional]

    # ------------------------------------------------------------------ readings

    def readings(self, record: m.Record) -> list[Reading]:
        """Returns a method for each type that names the values of a member on a device or for a value of another
        parameter."""
        here, members = home(record), {x.parameter.name: x for x in self.members(record)}
        readings = []
        for x in members.values():
            for t in {id(v.type): v.type for v in x.parameter.readings}.values():
                if t is None or inner(t) != raw(x):
                    continue
                variants = tuple(v for v in x.parameter.readings if v.type is t)
                by = {v.by for v in variants}
                tag = None if m.DEVICE in by else members[by.pop()]
                readings.append(Reading(f"{x.parameter.name}_as_{t.name}", path(t, here), x, variants, tag))
        return readings

    def needs(self, family: m.Family) -> list[str]:
        """Returns the features of the families whose types a family's fields use."""
        records: list[m.Record] = [*family.fields, *m.structs(family.types)]
        used = [t for record in records for t in self._types(record)]
        used += [b.enum for t in (*family.types, *used) if isinstance(t, m.Bitfield) for b in t.bits if b.enum]
        return sorted({home(t) for t in used} - {"types", module(family.name)})

    def _types(self, record: m.Record) -> Iterator[m.Type]:
        yield from (v.type for p in record.parameters for v in p.readings if v.type)
        yield from (t for p in _parts(record.parameters) if (t := p.named or p.struct))

    def conversions(self) -> list[Conversion]:
        """Returns the conversions from the named types of members to the types as which they can be read."""
        conversions: dict[tuple[str, str], Conversion] = {}
        for record in self.all():
            for reading in self.readings(record):
                of, to = reading.member.parameter.element, reading.variants[0].type
                if isinstance(of, (m.Enum, m.Bitfield)) and to is not None:
                    conversions.setdefault((of.name, to.name), Conversion(of, to, record, reading))
        return list(conversions.values())


def union_derives(union: Union) -> list[str]:
    return _derives([union.parameter], extent.size(union.parameter)[1])


def responses_derive(responses: Iterable[m.Field]) -> list[str]:
    """Returns the traits that the enumeration of responses derives: those that all responses derive."""
    derived = [_derives(r.parameters, r.max_size) for r in responses]
    return [name for name in ("Copy", "Eq", "Hash") if all(name in names for names in derived)]


def _derives(parameters: Iterable[m.Parameter], size: int) -> list[str]:
    """Returns `Copy` for small records without lists, and `Eq` and `Hash` for records without floats."""
    parts = list(_parts(parameters))
    lists = size > MAX_COPIED or any(p.open for p in parts)
    floats = any(p.kind == "scalar" and p.scalar.kind == "float" for p in parts)
    return [*([] if lists else ["Copy"]), *([] if floats else ["Eq", "Hash"])]


def _parts(parameters: Iterable[m.Parameter]) -> Iterator[m.Parameter]:
    """Yields the parameters and those nested in them."""
    for p in parameters:
        yield p
        yield from _parts(p.inside)


def is_sequence(record: m.Record) -> bool:
    """Does its wire format consist only of its members, in order?"""
    return not is_special(record) and all(member(p.name) == p.name for p in record.parameters)


def is_special(record: m.Record) -> bool:
    """Does its wire format contain more than its members, or sometimes not all of them?"""
    special = any(p.kind in ("constant", "counter", "switch") or p.selector for p in record.parameters)
    return special or bool(record.groups)


def when(group: m.Group, record: m.Field) -> str:
    """Writes which functions require a group, or that it is optional."""
    required = record.counted[group.first - 1].required_for
    return f"for {constants(required)}" if required else "optional"


def default(p: m.Parameter) -> str:
    """Writes the default of a parameter's type."""
    return f"[{DEFAULT}; {p.count}]" if is_long(p) else DEFAULT


def raw(x: Member) -> str:
    """Returns the type of a member's number or bytes."""
    named = x.parameter.named
    return inner(named) if named else x.type


def reserved(p: m.Parameter) -> str:
    """Writes the value that is sent for a reserved parameter."""
    return f"[{p.reserved}; {p.length}]" if isinstance(p.length, int) else str(p.reserved)


def serde_module(p: m.Parameter) -> str:
    """Returns the module that serde needs for floats, because a format may lack NaN, and for arrays that are too
    long."""
    item = p
    while item.kind == "array" and item.vector is None:
        item = item.item
    if item.kind == "scalar" and item.named is None and item.scalar.kind == "float":
        return "crate::readable"
    return "crate::list::long_array" if is_long(p) else ""


def is_long(p: m.Parameter) -> bool:
    """Is it an array that is too long for the traits of Rust and serde?"""
    return p.kind == "array" and p.vector is None and (p.count or 0) > 32
