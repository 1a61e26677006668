"""Structures and fields in Rust: their members and encoding, and the methods that make and read them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate
from typing import TYPE_CHECKING

from mipgen import model as m
from mipgen.facts import measures
from mipgen.lower import calls, extent, validity

from .. import names
from ..docs import Block, prose

if TYPE_CHECKING:
    from . import Crate

SET = "crate::DescriptorSet"
BOOL = names.scalar(m.SCALARS["bool"])
DEFAULT = "core::default::Default::default()"

#: Records up to this size on the wire are `Copy`. Larger ones are not, so that copies are explicit.
MAX_COPIED = 64


@dataclass(frozen=True, slots=True)
class Member:
    """A member of a record: a parameter that does not follow from others."""

    record: Record
    parameter: m.Parameter
    name: str
    type: str
    may_be_absent: bool

    @property
    def doc(self) -> tuple[Block, ...]:
        return self.record.crate.docs.parameter(self.parameter, self.record.of)

    @property
    def whole_type(self) -> str:
        return f"Option<{self.type}>" if self.may_be_absent else self.type

    @property
    def argument(self) -> str:
        """The type of an argument that becomes this member, in a form that is easy to pass."""
        if self.type == BOOL:
            return "bool"
        easy = self.parameter.vector or self.parameter.shown == "set" or self.type.startswith("crate::List<")
        return f"impl Into<{self.type}>" if easy else self.type

    @property
    def default(self) -> str:
        """Its default value, as an expression."""
        if self.may_be_absent:
            return "None"
        return sent_value(self.parameter) if self.parameter.reserved else default_value(self.parameter)

    @property
    def serde(self) -> list[str]:
        """The arguments of its attributes for serde."""
        other_name = self.name != self.parameter.name
        return serde(self.parameter, self.may_be_absent, self.parameter.name if other_name else "")


@dataclass(frozen=True, slots=True)
class Constructor:
    name: str
    doc: list[Block]
    function: m.Function | None
    call_type: str
    arguments: tuple[Member, ...]
    values: tuple[tuple[str, str], ...]  # of other members


@dataclass(frozen=True, slots=True)
class Case:
    """An alternative of a union."""

    doc: list[Block]
    serde: list[str]
    tag: str
    variant: str
    content: str  # its type, and its name in the specification


@dataclass(frozen=True, slots=True)
class Union:
    record: Record  # beside which it is defined
    parameter: m.Parameter
    of: m.Union
    name: str
    tag_type: str

    @property
    def doc(self) -> list[Block]:
        return [f"The alternatives of `{self.parameter.name}` in [`{self.record.name}`]."]

    @property
    def derives(self) -> list[str]:
        return derives([self.parameter], extent.size(self.parameter)[1])

    @property
    def cases(self) -> Iterator[Case]:
        crate, record = self.record.crate, self.record
        for case in self.of.cases:
            p, tag = case.parameter, case.tag.name
            content = f'({crate.type_of(p, record.home)}) "{p.name}"' if p else ""
            doc = crate.docs.case(case, self.parameter, record.of)
            yield Case(doc, serde(p, False, tag), names.constant(tag), names.variant(tag), content)

    @property
    def ranged(self) -> list[str]:
        """The alternatives whose values have ranges."""
        cases = (c for c in self.of.cases if c.parameter and is_ranged(c.parameter))
        return [names.variant(c.tag.name) for c in cases]

    @property
    def default(self) -> str:
        """The alternative of tag 0, as an expression."""
        case = next((c for c in self.of.cases if c.tag.value == 0), None)
        if case is None:
            return f"{self.name}::Other({self.tag_type}(0))"
        value = f"({default_value(case.parameter)})" if case.parameter else ""
        return f"{self.name}::{names.variant(case.tag.name)}{value}"


@dataclass(frozen=True, slots=True)
class Reading:
    """A method that reads a member as the type that names its values."""

    name: str
    type: str
    member: Member
    variants: tuple[m.Variant, ...]
    tag: Member | None  # the parameter that selects the type, unless the device does

    @property
    def doc(self) -> list[Block]:
        return [f"Reads `{self.member.name}` as [`{self.type}`].", self.applies(self.member.record.home)]

    def applies(self, here: str) -> str:
        """Describes where the type applies."""
        record = self.member.record
        return record.crate.docs.variants(self.member.parameter, record.of, self.variants, here)

    @property
    def returns(self) -> str:
        return f"Option<{self.type}>" if self.tag or self.member.may_be_absent else self.type

    @property
    def lines(self) -> list[str]:
        """The statements; with a tag, `named` states whether its value selects the type."""
        value, absent, tag = f"self.{self.member.name}", self.member.may_be_absent, self.tag
        if tag is None:
            return [f"{value}.map(Into::into)" if absent else f"{value}.into()"]
        tags = " | ".join(f"{tag.type}::{names.constant(v.key)}" for v in self.variants)
        named = f"let named = matches!(self.{tag.name}, {f'Some({tags})' if tag.may_be_absent else tags});"
        return [named, f"{value}.filter(|_| named).map(Into::into)" if absent else f"named.then(|| {value}.into())"]


@dataclass(frozen=True, slots=True)
class Validity:
    """A method that returns whether a member is valid."""

    member: Member
    readings: tuple[validity.Reading, ...]

    @property
    def name(self) -> str:
        return f"{self.member.parameter.name}_is_valid"

    @property
    def usual(self) -> str:
        """The members and masks, for the macro `valid!`."""
        return " && ".join(self._flags(self.readings[-1]))

    @property
    def cases(self) -> list[tuple[tuple[str, ...], str, str]]:
        """The readings, the usual one last: devices, how one is recognized without them, and its condition."""
        holder = next(f.parameter for r in self.readings for f in r.flags)
        cases = []
        for reading in self.readings:
            bits = f"flags!(self {names.member(holder)}) & 0x{reading.fewer:X} == 0"
            recognized = bits if reading.fewer else ""
            condition = " && ".join(f"flag!(self {x})" for x in self._flags(reading))
            cases.append((reading.devices, recognized, condition or "true"))
        return cases

    def _flags(self, reading: validity.Reading) -> list[str]:
        flags = [f"{names.member(f.parameter)} 0x{f.mask:X}" for f in dict.fromkeys(reading.flags)]
        return [*([self.member.name] if self.member.may_be_absent else []), *flags]


@dataclass(frozen=True, eq=False)
class Record:
    """What structures and fields have in common."""

    crate: Crate
    of: m.Record

    @cached_property
    def name(self) -> str:
        return names.type_name(self.of.name)

    @cached_property
    def home(self) -> str:
        return names.home(self.of)

    @property
    def is_command(self) -> bool:
        return isinstance(self.of, m.Field) and self.of.role == m.COMMAND

    @property
    def derives(self) -> list[str]:
        """The traits that it derives besides those of all records."""
        default = [] if self.of.selector or self.needs_default else ["Default"]
        return sorted([*default, *derives(self.of.parameters, self.of.max_size)])

    @property
    def needs_default(self) -> bool:
        """True if its default is not the default of each member's type. Records with a selector have none."""
        return not self.of.selector and any(x.default not in ("None", DEFAULT) for x in self.members)

    @cached_property
    def members(self) -> list[Member]:
        return [
            Member(self, p, names.member(p.name), self.crate.type_of(p, self.home), p.name in self.of.present_with)
            for p in calls.members(self.of)
        ]

    @property
    def unions(self) -> list[Union]:
        """The unions that are defined beside it."""
        return [u for u in self.crate.unions if u.record is self]

    # ------------------------------------------------------------------ the wire

    @property
    def steps(self) -> list[tuple[str, list[str]]]:
        """How its parameters are encoded: one by one, or several that are present together; empty if it consists only
        of its members, in order."""
        if not self._is_special and all(names.member(p.name) == p.name for p in self.of.parameters):
            return []
        return [*((step(p), []) for p in self.of.always), *map(self._group, self.of.groups)]

    def _group(self, group: m.Group) -> tuple[str, list[str]]:
        required = group.parameters[0].required_for
        when = f"for {names.selector_macros(required)}" if required else "optional"
        if len(group.parameters) == 1:
            return f"{step(group.parameters[0])} {when}", []
        members = ", ".join(x.name for x in self.members if x.parameter in group.parameters)
        return f"({members}) {when}", [step(p) for p in group.parameters]

    @property
    def _is_special(self) -> bool:
        """True if its wire format contains more than its members, or sometimes not all of them."""
        special = any(p.kind in ("constant", "counter", "switch") or p.selector for p in self.of.parameters)
        return special or bool(self.of.groups)

    @property
    def places(self) -> list[tuple[str, str, int]]:
        """The members, with the types that a view returns, and their offsets; none unless all are always present at
        fixed offsets. A view of a structure returns another view."""
        sizes = [extent.size(p) for p in self.of.parameters]
        if self.is_command or self._is_special or any(least != most for least, most in sizes):
            return []
        offsets = accumulate((least for least, _ in sizes), initial=0)
        types = (f"{' as ' if x.parameter.struct else ': '}{x.type}" for x in self.members)
        return [(x.name, t, offset) for x, t, offset in zip(self.members, types, offsets, strict=False)]

    @property
    def ranges(self) -> list[str]:
        """The ranges of its values, for the macro `ranges!`; those of data serve no command."""
        if isinstance(self.of, m.Field) and not self.is_command:
            return []
        lines = [line for x in self.members if (line := ranged(x))]
        return [*lines, *(f"[{x.name}]" for x in self.members if is_ranged(x.parameter))]

    # ------------------------------------------------------------------ methods

    @property
    def constructors(self) -> list[Constructor]:
        """Simulators and tests use the constructors of data and responses."""
        ways = self.of.calls if isinstance(self.of, m.Field) and self.of.parameters else calls.constructors(self.of)
        return [self._constructor(way) for way in ways]

    def _constructor(self, way: m.Call) -> Constructor:
        """Makes a constructor. A caller passes neither reserved values nor the tag of a union."""
        arguments, values = [], []
        for x in self.members:
            p = x.parameter
            if p in way.values and p.name not in way.unions:
                arguments.append(x)
            elif p in way.values:
                values.append((x.name, f"{names.member(way.unions[p.name].name)}.tag()"))
            elif p in way.required:
                values.append((x.name, sent_value(p)))
            elif not way.function:
                values.append((x.name, "None"))
        name, call_type = "new", ""
        doc = f"Creates {'the command from its parameters' if self.is_command else 'it from its values'}."
        if way.function:
            name, call_type = names.constructor(way.function), names.call_type(way.function)
            doc = prose(way.function.description)
        return Constructor(name, [doc], way.function, call_type, tuple(arguments), tuple(values))

    @property
    def settable(self) -> list[Member]:
        """The optional parameters that a caller may set in a command."""
        return [x for x in self.members if self.is_command and x.parameter.optional]

    @property
    def readings(self) -> list[Reading]:
        """A method for each type that names the values of a member on a device or for a value of another parameter."""
        members, readings = {x.parameter.name: x for x in self.members}, []
        for x in self.members:
            raw = names.inner(x.parameter.named) if x.parameter.named else x.type
            for t in {id(v.type): v.type for v in x.parameter.readings}.values():
                if t is None or names.inner(t) != raw:
                    continue
                variants = tuple(v for v in x.parameter.readings if v.type is t)
                by = {v.by for v in variants}
                tag = None if m.DEVICE in by else members[by.pop()]
                readings.append(Reading(f"{x.parameter.name}_as_{t.name}", names.path(t, self.home), x, variants, tag))
        return readings

    @cached_property
    def validity(self) -> tuple[list[Validity], list[Validity]]:
        """The members with flags: those whose flags are the same on all devices, and others."""
        described = [(x, validity.readings([x.parameter], self.of)) for x in self.members]
        every = [Validity(x, readings) for x, readings in described if readings]
        return [x for x in every if len(x.readings) == 1], [x for x in every if len(x.readings) > 1]

    @property
    def methods(self) -> list[str]:
        setters = [f"with_{x.parameter.name}" for x in self.settable]
        same, by_device = self.validity
        valid = [*(x.name for x in (*same, *by_device)), *(f"{x.name}_on" for x in by_device)]
        return [*(x.name for x in self.constructors), *setters, *(x.name for x in self.readings), *valid]

    @property
    def used_types(self) -> Iterator[m.Type]:
        yield from (v.type for p in self.of.parameters for v in p.readings if v.type)
        yield from (t for p in nested(self.of.parameters) if (t := p.named or p.struct))


@dataclass(frozen=True, eq=False)
class Struct(Record):
    of: m.Struct
    macro = "record"
    deprecated = None
    needs = ""

    @property
    def doc(self) -> list[Block]:
        return self.crate.docs.type(self.of)

    @property
    def convertible(self) -> list[Member]:
        """The members to which a tuple of two to four values converts; none if there are others, too."""
        (way,) = self.constructors
        return list(way.arguments) if 2 <= len(way.arguments) <= 4 and not way.values else []


def bounds(p: m.Parameter) -> list[tuple[str, float | int]]:
    """Returns the bounds of a value, unless they depend on the device."""
    if any(v.minimum is not None or v.maximum is not None for v in p.variants):
        return []
    every = (("From", p.minimum), ("Above", p.above), ("To", p.maximum), ("Below", p.below))
    return [(word, bound) for word, bound in every if bound is not None]


def ranged(x: Member) -> str:
    p = x.parameter
    limits = " ".join(f"{word} {float(bound)!r}" for word, bound in bounds(p))
    said = measures.limits_text(p.minimum, p.maximum, p.above, p.below, lambda n: measures.numeral(p, n))
    return f'{x.name} "{p.name}" in "{said}" {limits}' if limits else ""


def is_ranged(p: m.Parameter) -> bool:
    """Is it a structure, or a union of structures, that contains values with ranges?"""
    members = p.item.struct.parameters if p.item.struct else ()
    return any(is_ranged(q) for q in p.alternatives) or any(
        q.counts is None and (bounds(q) or is_ranged(q)) for q in members
    )


def nested(parameters: Iterable[m.Parameter]) -> Iterator[m.Parameter]:
    """Yields the parameters and those nested in them."""
    for p in parameters:
        yield p
        yield from nested(p.inside)


def derives(parameters: Iterable[m.Parameter], size: int) -> list[str]:
    """Returns `Copy` for small records without lists, and `Eq` and `Hash` for records without floats."""
    every = list(nested(parameters))
    lists = size > MAX_COPIED or any(p.open for p in every)
    floats = any(p.kind == "scalar" and p.scalar.kind == "float" for p in every)
    return [*([] if lists else ["Copy"]), *([] if floats else ["Eq", "Hash"])]


def step(p: m.Parameter) -> str:
    """Writes how a parameter is encoded, for the macro `wire!`."""
    name = names.with_words(names.member, p.name)
    match p.kind:
        case "constant":
            number = "u8" if p.scalar.kind == "bool" else names.scalar(p.scalar)
            return f"{names.member(p.name)}: {number} = {p.constant}"
        case "counter":
            return f"{name}: {names.scalar(p.scalar)} counts {names.with_words(names.member, str(p.counts))}"
        case "switch":
            return f"{name} as {names.member(str(p.tag))}"
    return f"{name} by {names.member(p.counter)}" if p.counter else f"{name} selects" if p.selector else name


def default_value(p: m.Parameter) -> str:
    """Writes the default of a parameter's type."""
    return f"[{DEFAULT}; {p.count}]" if is_long(p) else DEFAULT


def sent_value(p: m.Parameter) -> str:
    """Writes the value that is sent for a reserved parameter."""
    return f"[{p.reserved}; {p.length}]" if isinstance(p.length, int) else str(p.reserved)


def serde(p: m.Parameter | None, may_be_absent: bool, name: str) -> list[str]:
    """Returns the arguments of attributes for serde: a module for values that it cannot write itself, and a name."""
    module, default = serde_module(p) if p else "", "default, " if may_be_absent else ""
    return [*([f'{default}with = "{module}"'] if module else []), *([f'rename = "{name}"'] if name else [])]


def serde_module(p: m.Parameter) -> str:
    """Returns the module for floats, because a format may lack NaN, and for arrays that are too long."""
    item = p
    while item.kind == "array" and item.vector is None:
        item = item.item
    if item.kind == "scalar" and item.named is None and item.scalar.kind == "float":
        return "crate::readable"
    return "crate::list::long_array" if is_long(p) else ""


def is_long(p: m.Parameter) -> bool:
    """Is it an array that is too long for the traits of Rust and serde?"""
    return p.kind == "array" and p.vector is None and (p.count or 0) > 32
