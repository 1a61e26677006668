"""What the templates print: types, fields, families and devices as Python sees them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property

from mipgen import model as m
from mipgen.facts import describe
from mipgen.lower import calls

from . import members, names
from .codecs import Codec
from .docs import COMMENTS
from .members import Member
from .names import class_name, constant, home, member, qualified, reference

# --------------------------------------------------------------------------- types


@dataclass(frozen=True, slots=True)
class Constant:
    """A value of an enumeration, or bits of a bitfield."""

    name: str
    value: str
    doc: list[str]


@dataclass(frozen=True, slots=True)
class Number:
    """A number inside a bitfield, of more than one bit."""

    of: m.Bits
    name: str  # of the property that reads it
    type: str
    mask: str
    mask_in_place: str


@dataclass(frozen=True)
class Class:
    of: m.Type | m.Field
    model: m.Model

    @property
    def name(self) -> str:
        return class_name(self.of)

    @property
    def doc(self) -> list[str]:
        of, model = self.of, self.model
        return COMMENTS.field(of, model) if isinstance(of, m.Field) else COMMENTS.type(of, model)


class Type(Class):
    """An enumeration, a bitfield or a vector."""

    @property
    def constants(self) -> list[Constant]:
        match self.of:
            case m.Enum() as t:
                values = ((v, str(v.value) if v.value < 256 else f"0x{v.value:X}") for v in t.values)
                return [Constant(constant(v.name), value, COMMENTS.value(v, t, self.model)) for v, value in values]
            case m.Bitfield() as t:
                masks = ((b, f"1 << {b.first}" if b.width == 1 else f"0x{b.mask:X}") for b in t.bits)
                return [Constant(constant(b.name), value, COMMENTS.bits(b, t, self.model)) for b, value in masks]
        return []

    @property
    def numbers(self) -> list[Number]:
        assert isinstance(self.of, m.Bitfield)
        numbers = ((b, reference(b.enum, home(self.of)) if b.enum else "int") for b in self.of.bits if not b.alias)
        return [
            Number(b, names.prop(b.name), number, f"0x{2**b.width - 1:X}", f"0x{b.mask:X}")
            for b, number in numbers
            if b.width > 1
        ]

    @property
    def elements(self) -> list[str]:
        assert isinstance(self.of, m.Vector)
        return [*map(names.element, self.of.elements)]

    @cached_property
    def columns(self) -> int:
        """The number of columns of a matrix; 0 for any other vector."""
        return members.matrix_columns(self.of) if isinstance(self.of, m.Vector) else 0


def types(of: Iterable[m.Type], model: m.Model) -> list[Type | Record]:
    return [Record(t, model) if isinstance(t, m.Struct) else Type(t, model) for t in of]


def blocks(of: Iterable[Class]) -> list[str]:
    """Lists the formats of the blocks that the records of a module use."""
    return sorted({layout for x in of if isinstance(x, Record) for layout in x.codec.blocks})


# --------------------------------------------------------------------------- structures and fields


class Record(Class):
    """A class with members: a structure, or a field."""

    of: m.Record

    @cached_property
    def members(self) -> list[Member]:
        return [Member(p, self.of) for p in calls.members(self.of)]

    @cached_property
    def codec(self) -> Codec:
        """The functions that read and write it."""
        return Codec(self.of)

    @cached_property
    def parameters(self) -> list[tuple[Member, list[str]]]:
        """All parameters, with comments; some are only on the wire."""
        return [(Member(p, self.of), COMMENTS.member(p, self.of, self.model)) for p in self.of.parameters]


@dataclass(frozen=True, slots=True)
class Constructor:
    """The constructor of a command for one function."""

    of: m.Function
    name: str
    function: str  # its constant
    parameters: list[str]
    arguments: list[str]  # that it passes on, after the function
    response: str


class Field(Record):
    of: m.Field

    @property
    def bases(self) -> str:
        base = self.of.role.capitalize()
        base += f"[{self.response or 'R'}]" if self.of.role == m.COMMAND else ""
        return f"Shared, {base}" if len(self.of.sets) > 1 else base

    @property
    def sets(self) -> str:
        """The sets in which it occurs; empty if that is only `SET`."""
        if everywhere := self.of.everywhere:
            return f"range(0x{everywhere.start:02X}, 0x{everywhere.stop:02X})"
        return f"({', '.join(f'0x{n:02X}' for n in self.of.sets)},)" if self.of.sets != (self.of.set,) else ""

    @property
    def counterparts(self) -> list[str]:
        """The responses to a command; the commands to which the device sends a response."""
        return [class_name(f) for f in (*self.model.responses(self.of), *self.model.commands(self.of))]

    @cached_property
    def response(self) -> str:
        """The type of the response to a command; empty if it depends on the function."""
        responses = {self._response(call) for call in calls.constructors(self.of)}
        return responses.pop() if len(responses) == 1 else ""

    def _response(self, call: m.Call) -> str:
        """Returns the type of the response to a call: a response, one of several, or None."""
        layouts = calls.possible_layouts(self.of, call.function, self.model)
        return " | ".join(dict.fromkeys(reference(layout, home(self.of)) for layout in layouts)) or "None"

    @property
    def constructors(self) -> list[Constructor]:
        return [self._constructor(call, call.function) for call in calls.constructors(self.of) if call.function]

    def _constructor(self, call: m.Call, function: m.Function) -> Constructor:
        required, optional = ([Member(p, self.of) for p in parameters] for parameters in (call.values, call.addable))
        parameters = [f"{x.name}: {x.required_argument}" for x in required]
        parameters += [f"{x.name}: {x.argument} = None" for x in optional]
        name, arguments = member(function.name), _passed(call, self.of)
        return Constructor(function, name, constant(function.name), parameters, arguments, self._response(call))

    @property
    def silencers(self) -> list[str]:
        """The settings that suppress the acknowledge of a command: set, descriptor, member and value."""
        settings = [(self.model.field(c.command or ""), c) for c in self.of.silenced_by]
        return [f'(0x{f.set:02X}, 0x{f.descriptor:02X}, "{member(c.parameter)}", {c.value})' for f, c in settings if f]

    @cached_property
    def matches(self) -> str:
        """The condition that `data` belongs to the field; empty if any data may."""
        sizes = self.model.sizes(self.of)
        tests = [f"{sizes.start} <= len(data)"] if sizes.start else []
        if sizes.stop <= m.MAX_FIELD_DATA:
            tests = [f"{sizes.start} <= len(data) < {sizes.stop}" if sizes.start else f"len(data) < {sizes.stop}"]
        tests += [f"{octets!r}.startswith(data[{at}:{at + len(octets)}])" for at, octets in self.of.signature]
        return " and ".join(tests)

    @property
    def acknowledged(self) -> str:
        """The condition under which the device sends an acknowledge; empty if it always does."""
        tests = [f"self.function != FunctionSelector.{constant(x.name)}" for x in self.of.functions if not x.reply]
        if self.of.silent_when:
            tests.append(f"({' or '.join(_condition(c, negated=True) for c in self.of.silent_when)})")
        return " and ".join(tests)

    @property
    def expected(self) -> list[tuple[str, list[str]]]:
        """The condition under which each response of a command is sent, and its layouts; empty if there are no
        conditions."""
        responses = []
        for reply in self.model.replies(self.of):
            functions = [f"self.function == FunctionSelector.{constant(x.name)}" for x in reply.functions]
            tests = [" or ".join(functions)] if functions else []
            tests += [_condition(c) for c in reply.when]
            condition = " and ".join(f"({t})" if " or " in t and len(tests) > 1 else t for t in tests)
            responses.append((condition or "True", [reference(layout, home(self.of)) for layout in reply.layouts]))
        return responses if any(condition != "True" for condition, _ in responses) else []


def _condition(c: m.Condition, negated: bool = False) -> str:
    """Writes a condition on a member of a command, or its negation; for a Boolean, everything but 0 is true."""
    value = f"self.{member(c.parameter)}"
    if c.boolean:
        return value if bool(c.value) != negated else f"not {value}"
    return f"{value} {'!=' if negated else '=='} {c.value}"


def _passed(call: m.Call, record: m.Field) -> list[str]:
    """Writes the arguments that a constructor passes on after the function."""
    required = [Member(p, record) for p in call.required if not p.derived]
    passed = [f"{x.name}={x.name if x.of.reserved is None else x.reserved}" for x in required]
    for i, p in enumerate(call.optional):
        x, later = Member(p, record), [q for q in call.optional[i:] if q in call.addable]
        if p in call.addable:
            passed.append(f"{x.name}={x.name}")
        elif p.reserved is not None and later:  # sent only with the parameters after it
            passed.append(f"{x.name}={x.reserved} if {member(later[0].name)} is not None else None")
    return passed


# --------------------------------------------------------------------------- families and devices


@dataclass(frozen=True)
class Family:
    """The module of a family of sets."""

    of: m.Family
    model: m.Model

    @property
    def module(self) -> str:
        return names.module(self.of.name)

    @property
    def hides_builtin(self) -> bool:
        return names.hides_builtin(self.module)

    @property
    def doc(self) -> list[str]:
        return COMMENTS.family(self.of, self.model)

    @cached_property
    def types(self) -> list[Type | Record]:
        return types(self.of.types, self.model)

    @property
    def blocks(self) -> list[str]:
        return blocks([*self.types, *self.fields])

    @cached_property
    def fields(self) -> list[Field]:
        """Its fields: responses before the commands that name them."""
        return [Field(f, self.model) for f in sorted(self.of.fields, key=lambda f: f.role, reverse=True)]

    @property
    def by_descriptor(self) -> dict[int, list[str]]:
        """The classes of each descriptor."""
        classes: dict[int, list[str]] = {}
        for f in sorted(self.of.fields, key=lambda f: f.descriptor):
            classes.setdefault(f.descriptor, []).append(class_name(f))
        return classes


@dataclass(frozen=True)
class Device:
    of: m.Device
    model: m.Model

    @property
    def name(self) -> str:
        return constant(self.of.name)

    @property
    def doc(self) -> list[str]:
        return COMMENTS.device(self.of, self.model)

    @property
    def evidence(self) -> list[tuple[m.Evidence, str, list[str]]]:
        """Each reason to believe that it supports fields, or does not, in words; and their descriptors in each set."""
        fields: dict[m.Evidence, dict[int, str]] = {e: {} for e in self.of.evidence}
        for s in sorted(self.of.supports + self.of.refuses, key=lambda s: s.set):
            sets = fields[s.evidence]
            sets[s.set] = f"{sets.get(s.set, '')} {s.field.descriptor:02X}".strip()
        for e in self.of.evidence:
            fields[e] |= dict.fromkeys((of.number for of in e.sets), "")
        texts = {e: [f'0x{n:02X}: bytes.fromhex("{text}")' for n, text in of.items()] for e, of in fields.items()}
        return [(e, describe.why(e, self.model), texts[e]) for e in self.of.evidence]

    @property
    def functions(self) -> list[tuple[m.Support, str]]:
        """The fields of which it accepts other functions than the definition states, with the letters of these."""
        return [(s, m.letters(s.functions)) for s in self.of.supports if s.differs]

    @property
    def firmware(self) -> list[tuple[m.Support, str]]:
        """The fields that need a version of its firmware, and the versions."""
        return [(s, s.firmware) for s in self.of.supports if s.firmware]

    @property
    def readings(self) -> list[tuple[str, str]]:
        """The parameters that have a type of their own on it, with that type."""
        return [(v.path, qualified(v.variant.type)) for v in self.of.variants if v.variant.type]
