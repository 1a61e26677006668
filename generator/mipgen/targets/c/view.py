"""What the templates print: types, fields and families of sets as C sees them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property

from mipgen import model as m
from mipgen.lower import memory

from . import bytecode, calls, cpp, direct, literals, members, names, profiles, tables
from .comments import Comments
from .literals import hexadecimal
from .members import CFunction
from .names import macro


@dataclass(frozen=True, slots=True)
class Constant:
    """A constant: a set, a value of an enumeration, bits of a bitfield, or a value of `present`."""

    of: m.Set | m.EnumValue | m.Bits | m.Parameter
    name: str
    word: str  # its name in C++
    value: str
    doc: list[str]


# --------------------------------------------------------------------------- types


@dataclass(frozen=True, slots=True)
class Named:
    """A type that names values or bits."""

    of: m.Enum | m.Bitfield
    form: str  # "enumeration", "macros", "flags" or "bytes"
    name: str
    bare: str  # without the prefix of the library
    word: str  # in C++
    type: str  # of a member
    scalar: str  # the number in which it is stored; empty for bytes
    doc: list[str]
    constants: list[Constant]
    accessors: list[CFunction]  # get and set a number inside a bitfield

    @property
    def labels(self) -> str:
        """The names as one string, each followed by a NUL; after the last name, it is the string's own. A digit would
        belong to the escape sequence."""
        first, *others = [c.of.name for c in self.constants] or [""]
        parts = (rf'\0" "{name}' if name[0].isdigit() else rf"\0{name}" for name in others)
        return f'"{first}{"".join(parts)}"'

    @property
    def numbers(self) -> str:
        assert isinstance(self.of, m.Enum)
        return ", ".join(literals.number(v.value, self.of.scalar.size) for v in self.of.values)

    @property
    def bits(self) -> list[str]:
        """The rows of struct mip_named_bits."""
        assert isinstance(self.of, m.Bitfield)
        enums = [(b, f"&{names.names_table(b.enum)}" if b.enum else "NULL") for b in self.of.bits]
        return [f"{{{b.first}, {b.width}, {_states(b)}, {enum}}}" for b, enum in enums]


def _states(b: m.Bits) -> int:
    return sum(1 << number for number in b.when.numbers) if b.when else 0


def named_type(t: m.Enum | m.Bitfield, model: m.Model) -> Named:
    docs, scalar = Comments(model), names.c_type(t.scalar) if t.scalar else ""
    common = names.type_name(t), names.bare(t), cpp.bare(t), names.c_type(t), scalar, docs.type(t)
    if isinstance(t, m.Enum):
        form = "enumeration" if names.is_enum(t) else "macros"
        return Named(t, form, *common, [_value(v, t, form, docs) for v in t.values], [])
    masks = [Constant(b, names.constant(t, b), cpp.word(b.name), _mask(b, t), docs.bits(b)) for b in t.bits]
    accessors = [x for b, mask in zip(t.bits, masks, strict=True) for x in _accessors(b, t, mask)]
    return Named(t, "flags" if t.scalar else "bytes", *common, masks, accessors)


def _value(v: m.EnumValue, t: m.Enum, form: str, docs: Comments) -> Constant:
    """Values that a C enumeration cannot contain are macros; the comment of the first one describes them all."""
    name, word, doc = names.constant(t, v), cpp.word(v.name), docs.value(v)
    if form == "enumeration":
        return Constant(v, name, word, str(v.value), doc or [f"The value `{v.name}`."])
    doc = docs.type(t) + doc if v is t.values[0] else doc or docs.type(t)
    return Constant(v, name, word, literals.number(v.value, t.scalar.size), doc)


def _mask(b: m.Bits, t: m.Bitfield) -> str:
    """Writes a mask of bits, wide enough that its complement clears no other bits."""
    if t.scalar is None:
        return f"MIP_BITS({b.first}, {b.width})"
    text = f"0x{b.mask:0{2 * t.size}X}"
    return f"UINT{t.width}_C({text})" if t.size > 2 else f"{text}U"


def _accessors(b: m.Bits, t: m.Bitfield, mask: Constant) -> Iterator[CFunction]:
    """Yields the functions that get and set a number inside a bitfield."""
    if not members.has_accessor(b, t):
        return
    name, number, wide = names.type_name(t), members.bits_type(b), "uint64_t" if t.size == 8 else "uint32_t"
    down, up = (f"(bits >> {b.first})", f"({wide})value << {b.first}") if b.first else ("bits", "value")
    get = [f"const {wide} bits = flags & {mask.name};", f"return ({number}){down};"]
    put = [f"const {wide} mask = {mask.name};", f"const {wide} bits = {up};"]
    put.append(f"*flags = ({name})((*flags & ~mask) | (bits & mask));")
    yield CFunction(names.accessor(t, "get", b), mask.doc, f"static inline {number}", [f"{name} flags"], get)
    arguments = [f"{name} *flags", f"{number} value"]
    yield CFunction(names.accessor(t, "set", b), ["Sets it."], "static inline void", arguments, put)


def types(of: Iterable[m.Type], model: m.Model) -> list[Named | Record]:
    own = [t for t in of if not isinstance(t, m.Vector)]
    return [record(t, model) if isinstance(t, m.Struct) else named_type(t, model) for t in own]


# --------------------------------------------------------------------------- structures


@dataclass(frozen=True, slots=True)
class Member:
    """A member of a structure or of a union."""

    doc: list[str]
    declaration: str


@dataclass(frozen=True, slots=True)
class Union:
    """The type of a member whose alternatives another one, the tag, selects. One alternative that fills the field is a
    structure, whose name is given, with its number of elements."""

    name: str
    doc: list[str]
    alternatives: list[tuple[str, list[Member]]]


@dataclass(frozen=True, slots=True)
class Record:
    """A structure: a type, or the value of a field."""

    of: m.Record
    form = "structure"
    name: str
    bare: str  # without the prefix of the library
    word: str  # in C++
    doc: list[str]
    unions: list[Union]
    members: list[Member]
    model: m.Model

    @property
    def tables(self) -> list[str]:
        """The tables that describe its parameters."""
        return [tables.array(declaration, rows) for declaration, rows in tables.reflected(self.of, self.model)]


def record(r: m.Record, model: m.Model) -> Record:
    docs, own = Comments(model), memory.stored(r)
    present = [Member(docs.present(r), "uint8_t present")] if isinstance(r, m.Field) and r.optional else []
    unused = Member(["Not used: there are no parameters."], "uint8_t empty")
    return Record(
        of=r,
        name=names.symbol(r),
        bare=names.bare(r),
        word=cpp.bare(r),
        doc=docs.field(r) if isinstance(r, m.Field) else docs.type(r),
        unions=[_union(p, r, docs) for p in own if p.element is None and names.union_owner(p, r, model) is r],
        members=[*present, *(x for p in own for x in _members(p, r, docs.member(p, r), model))] or [unused],
        model=model,
    )


def _members(p: m.Parameter, r: m.Record, doc: list[str], model: m.Model) -> list[Member]:
    """Returns the member of a parameter, after the number of elements of an array that fills the field."""
    name = names.member(p.name)
    count = Member([f"The number of elements of {name}."], f"uint8_t {name}_count")
    return [*([count] if p.fills else []), Member(doc, members.declaration(p, r, model))]


def _union(p: m.Parameter, r: m.Record, docs: Comments) -> Union:
    doc = [f"The member of {names.symbol(r)} that `{names.member(p.tag or '')}` selects."]
    parts = [(c.parameter, _members(c.parameter, r, docs.case(c, p, r), docs.model)) for c in p.cases if c.parameter]
    return Union(
        names.union_name(p, r),
        doc,
        [(names.member(q.name) if q.fills else "", inside) for q, inside in parts],
    )


# --------------------------------------------------------------------------- fields and families


@dataclass(frozen=True, slots=True)
class Field:
    """A field: its structure, its wire format and, for a command, what fills the structure, sends it, and replies."""

    of: m.Field
    name: str
    record: Record
    short: str  # the name without that of its family
    specified_name: str  # in the specification, in the first of its sets
    more_sets: int  # the number of sets besides the first one
    key: str  # descriptor set and descriptor; of several sets, the first one
    key_doc: list[str]
    last_present: list[Constant]  # the values of `present`, by the last parameter that is present
    fill_macros: list[tuple[str, str, str]]  # the functions of a command that have no parameters
    call_macros: list[tuple[str, ...]]  # the calls of these
    sent_with: tuple[str, ...]  # the function that sends a command and its types, if these are two structures
    fills: list[CFunction]  # a response fills its command
    writes: str  # the one that fills this command from its response; empty if there is none
    codec: bytecode.Codec
    quarters: int  # the time-out in quarters of a second; 0 if it is that of any command
    replies: list[str]
    sends: list[CFunction]
    required: str  # the number of parameters that each function requires; empty without a function selector
    reflection: list[str]
    accessors: list[cpp.Accessor]  # the functions that C++ adds to the structure
    commands: list[cpp.Command]  # the structures of C++ that send a command
    response: str  # of a command, in C++
    decoder: str  # the end of the name of the function by which C++ decodes it


def field(f: m.Field, model: m.Model) -> Field:
    docs, is_command, write_from = Comments(model), f.role == m.COMMAND, members.write_from_response(f, model)
    owners = [c for c in model.commands(f) if c.name == f.command] if f.role == m.RESPONSE else []
    return Field(
        of=f,
        name=names.field_name(f),
        record=record(f, model),
        short=names.short(f),
        specified_name=f.name_in(f.set),
        more_sets=len(f.occurrences) - 1,
        key=f"0x{f.set:02X}{f.descriptor:02X}",
        key_doc=docs.key(f),
        last_present=[_last_present(p, number, f) for p, number in members.last_present(f)],
        fill_macros=[made for c in members.constructors(f) if (made := c.macro)],
        call_macros=[x for c in calls.calls(f, model) if (x := c.macro)] if is_command else [],
        sent_with=calls.sent_with(f, model) if is_command else (),
        fills=[
            *(c.fill() for c in members.constructors(f) if not c.macro),
            *(w for c in owners if (w := members.write_from_response(c, model))),
        ],
        writes=write_from.name if write_from else "",
        codec=bytecode.codec(f, model),
        quarters=math.ceil((f.timeout or 0) * 4),
        replies=members.reply_rows(f, model) if is_command else [],
        sends=calls.functions(f, model) if is_command else [],
        required=", ".join(map(str, tables.required(f))) if f.functions else "",
        reflection=tables.reflection(f),
        accessors=cpp.accessors(f),
        commands=cpp.commands(f, model) if is_command else [],
        response=cpp.only_response(*model.responses(f)),
        decoder="decode_inline" if direct.is_direct(f) else "decode",
    )


def _last_present(p: m.Parameter, number: int, f: m.Field) -> Constant:
    doc = [f"The value of `present` if {names.member(p.name)} is the last parameter that is present."]
    return Constant(p, macro(f"{names.field_name(f)}_with_{p.name}"), "", str(number), doc)


@dataclass(frozen=True)
class Family:
    """The headers of a family of sets."""

    of: m.Family
    model: m.Model

    @property
    def name(self) -> str:
        """The name of the headers."""
        return names.module(self.of.name)

    @property
    def namespace(self) -> str:
        return cpp.namespace(self.of.name)

    @property
    def numbers(self) -> str:
        return ", ".join(hexadecimal(s.number) for s in self.of.sets)

    @property
    def doc(self) -> list[str]:
        return Comments(self.model).family(self.of)

    @property
    def sets(self) -> list[Constant]:
        docs, rows = Comments(self.model), [(s, f"{cpp.namespace(s.name)}_set") for s in self.of.sets]
        return [Constant(s, names.set_constant(s), w, hexadecimal(s.number), docs.set(s, self.of)) for s, w in rows]

    @cached_property
    def types(self) -> list[Named | Record]:
        return types(self.of.types, self.model)

    @cached_property
    def fields(self) -> list[Field]:
        """The fields, each command followed by its own responses."""
        return [field(f, self.model) for f in members.in_order(self.of)]

    @cached_property
    def inline(self) -> list[direct.Inline]:
        return [direct.inline_view(f, self.model) for f in members.in_order(self.of) if direct.is_direct(f)]

    @property
    def specified(self) -> list[Field]:
        """The fields in the order of the specification."""
        made = {f.of.name: f for f in self.fields}
        return [made[f.name] for f in self.of.fields]

    @property
    def commands(self) -> list[Field]:
        return [f for f in self.fields if f.of.role == m.COMMAND]

    @property
    def has_commands(self) -> bool:
        return any(f.role == m.COMMAND for f in self.of.fields)


@dataclass(frozen=True)
class Library:
    """The whole library."""

    model: m.Model
    max_field_data = m.MAX_FIELD_DATA
    first_shared = m.SHARED_DESCRIPTORS.start

    @cached_property
    def families(self) -> list[Family]:
        return [Family(x, self.model) for x in self.model.families]

    @cached_property
    def types(self) -> list[Named | Record]:
        """The types that several sets use."""
        return types(self.model.types, self.model)

    @property
    def shared_types(self) -> list[Named | Record]:
        return [self.function_selector, *self.types]

    @property
    def all_types(self) -> list[Named | Record]:
        return [*self.shared_types, *(t for x in self.families for t in x.types)]

    @property
    def ack_code(self) -> Named:
        """The enumeration of acknowledge codes, which the runtime uses."""
        return next(t for t in self.types if isinstance(t, Named) and t.of is self.model.protocol.ack_code)

    @property
    def named(self) -> list[Named]:
        """All enumerations and bitfields."""
        return [t for t in self.all_types if isinstance(t, Named)]

    @property
    def fields(self) -> list[Field]:
        """The acknowledge and all fields, in the order of the specification."""
        return [self.acknowledge, *(f for x in self.families for f in x.specified)]

    @cached_property
    def profiles(self) -> list[profiles.Profile]:
        return profiles.profiles(self.model)

    @property
    def max_value_size(self) -> int:
        return memory.largest(self.model)

    @cached_property
    def registry(self) -> tables.Registry:
        return tables.registry(self.model)

    @property
    def reflections(self) -> str:
        """The table of all fields."""
        rows = [f.reflection for f in self.fields]
        return tables.array("const struct mip_reflection mip_reflections[]", rows)

    @cached_property
    def function_selector(self) -> Named:
        return named_type(self.model.protocol.function_selector, self.model)

    @property
    def inline(self) -> list[direct.Inline]:
        """The acknowledge, if its layout is fixed."""
        acknowledge = self.model.protocol.acknowledge
        return [direct.inline_view(acknowledge, self.model)] if direct.is_direct(acknowledge) else []

    @cached_property
    def acknowledge(self) -> Field:
        return field(self.model.protocol.acknowledge, self.model)
