"""Fields and the descriptor sets in which they occur."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Final, Literal

from mipgen.read.problems import Position

from .parameters import Group, Parameter, optional_groups
from .types import Function, Source, Struct, Type

COMMAND: Final = "command"
RESPONSE: Final = "response"
DATA: Final = "data"
Role = Literal["command", "response", "data"]

#: The content of a set or a family; shared data occurs in every data set.
Kind = Literal["command", "data", "shared"]

#: The numbers of command sets, and of data sets.
COMMAND_SETS: Final = range(0x01, 0x80)
DATA_SETS: Final = range(0x80, 0xFF)

#: The number under which shared fields of all data sets are listed; no packet has it.
SHARED_SET: Final = 0xFF

#: The numbers that no packet contains: they represent every command set, and every data set.
NO_SETS: Final = (0, SHARED_SET)

#: The descriptors of shared fields; descriptors in other data sets are lower.
SHARED_DESCRIPTORS = range(0xD0, 0x100)

#: A field has at most 255 bytes, of which two are its length and its descriptor.
MAX_FIELD_DATA = 253


@dataclass(frozen=True)
class Call:
    """One form of a field: with one of its functions, or the only form if there is no selector."""

    function: Function | None
    required: tuple[Parameter, ...]  # must be present, in wire order; the selector is not counted
    optional: tuple[Parameter, ...]  # may follow these: no function requires them

    @cached_property
    def passed(self) -> tuple[Parameter, ...]:
        """The parameters without constants and reserved values, for a caller who provides counters and tags."""
        return tuple(p for p in self.required if p.constant is None and p.reserved is None)

    @cached_property
    def values(self) -> tuple[Parameter, ...]:
        """The same without counters, for languages whose arrays know their length."""
        return tuple(p for p in self.passed if p.counts is None)

    @cached_property
    def unions(self) -> dict[str, Parameter]:
        """Tag -> the union whose alternative it selects. Languages whose unions know their alternative derive it."""
        return {p.tag: p for p in self.required if p.tag}

    @property
    def addable(self) -> tuple[Parameter, ...]:
        """The optional parameters that a caller may provide."""
        return tuple(p for p in self.optional if p.reserved is None and not p.derived)


@dataclass(frozen=True, slots=True)
class Condition:
    """A condition: a parameter of this command, or the setting of another command, has this value."""

    parameter: str
    value: int
    label: str  # the value as the specification writes it
    command: str | None = None  # "aiding.echo_control": another command, whose setting it is

    @property
    def boolean(self) -> bool:
        return self.label in ("true", "false")

    def holds(self, value: object) -> bool:
        """True if the condition is met. For a Boolean, everything except 0 is true."""
        return bool(value) == bool(self.value) if self.boolean and value is not None else value == self.value


@dataclass(frozen=True, slots=True)
class Set:
    """A descriptor set: the third byte of a packet. Its fields and types belong to its family."""

    number: int
    name: str
    kind: Kind
    title: str
    description: str
    family: str
    sources: tuple[Source, ...] = ()
    uncertain: tuple[str, ...] = ()
    needs: tuple[str, ...] = ()  # the hardware that each of its fields requires
    position: Position | None = field(default=None, compare=False)


@dataclass(frozen=True, slots=True)
class Occurrence:
    """A field in one descriptor set, with the facts about it there."""

    set: int
    set_name: str
    title: str
    sources: tuple[Source, ...] = ()
    position: Position | None = field(default=None, compare=False)


@dataclass(frozen=True)
class Field:
    """One layout of one descriptor in one role: one type in every language, whatever sets it occurs in."""

    family: str
    occurrences: tuple[Occurrence, ...]  # by set; one, numbered 0 or SHARED_SET, if it occurs `everywhere`
    name: str
    descriptor: int
    role: Role
    title: str
    description: str
    parameters: tuple[Parameter, ...]
    min_size: int
    max_size: int
    sources: tuple[Source, ...]
    functions: tuple[Function, ...] = ()  # by value; empty without a selector
    command: str | None = None  # of a response: the (first) command that owns it
    when: tuple[Condition, ...] = ()  # of a response: the conditions in the command that select it
    devices: tuple[str, ...] = ()  # of a response: the devices that send this layout; see `answers`
    responses: tuple[str, ...] = ()  # of a command: names of its responses, in the same set
    silent_when: tuple[Condition, ...] = ()  # of a command: conditions under which it is not acknowledged
    sent_by: Literal["host", "device"] = "host"  # of a command: the sender
    silenced_by: tuple[Condition, ...] = ()  # likewise: settings of other commands
    everywhere: range | None = None  # the sets of a field of every command set, or every data set
    affects: tuple[str, ...] = ()  # of a command: the data fields, or whole sets, that it changes
    may_affect: tuple[str, ...] = ()  # the same, inferred
    alternatives: tuple[str, ...] = ()  # of a command: those that do the same on devices that lack it
    timeout: float | None = None
    advanced: bool = False
    deprecated: str | None = None
    also: tuple[str, ...] = ()  # other names
    keywords: tuple[str, ...] = ()  # search words that its texts do not contain
    needs: tuple[str, ...] = ()  # the hardware that it requires, besides what its set requires
    notes: tuple[str, ...] = ()
    uncertain: tuple[str, ...] = ()
    short: str | None = None
    position: Position | None = field(default=None, compare=False)

    @cached_property
    def full_name(self) -> str:
        return f"{self.family}.{self.name}"

    @cached_property
    def names(self) -> tuple[str, ...]:
        """The field's full name, and its name in each of its sets."""
        return tuple(dict.fromkeys((self.full_name, *self._names_in.values())))

    @property
    def owner(self) -> str:
        """The field's family, which defines it, as for a type."""
        return self.family

    @cached_property
    def sets(self) -> Sequence[int]:
        """The descriptor sets in which the field occurs."""
        return self.everywhere or tuple(o.set for o in self.occurrences)

    @property
    def set(self) -> int:
        """The number under which the field is listed: its only or first set, SHARED_SET, or 0 (the acknowledge)."""
        return self.occurrences[0].set

    def name_in(self, number: int) -> str:
        """Returns the field's full name in a set: "gnss_2.dop". A field that occurs everywhere has one name."""
        return self._names_in.get(number, self.full_name)

    @cached_property
    def _names_in(self) -> dict[int, str]:
        return {o.set: f"{o.set_name}.{self.name}" for o in self.occurrences}

    @property
    def selector(self) -> bool:
        """True if the field starts with a function selector."""
        return bool(self.functions)

    @cached_property
    def calls(self) -> tuple[Call, ...]:
        """The forms of the field: one for each function, or just one."""
        optional = tuple(p for p in self.counted if p.optional)
        if not self.functions:
            return (Call(None, tuple(p for p in self.parameters if not p.optional), optional),)
        return tuple(
            Call(f, tuple(p for p in self.counted if f in p.required_for), optional if f.sets else ())
            for f in self.functions
        )

    def required(self, function: int | None = None) -> int:
        """Returns the number of required parameters, without the selector; an unknown function requires none."""
        return self.requires.get(function if self.selector else None, 0)

    @cached_property
    def requires(self) -> dict[int | None, int]:
        """Function -> the number of parameters that must be present; None: it has no selector."""
        return {c.function.value if c.function else None: len(c.required) for c in self.calls}

    @cached_property
    def present_with(self) -> dict[str, int]:
        """Parameter that may be absent -> the number of present parameters if it is the last one."""
        return {p.name: group.last for group in self.groups for p in group.parameters}

    @property
    def optional(self) -> bool:
        """True if parameters may be absent."""
        return bool(self.groups)

    @property
    def counted(self) -> tuple[Parameter, ...]:
        """The parameters that are counted in a number of present parameters: all except the selector."""
        return tuple(p for p in self.parameters if not p.selector)

    @cached_property
    def always(self) -> tuple[Parameter, ...]:
        """The parameters that are always present: the selector, or all before the first optional one."""
        first = (i for i, p in enumerate(self.parameters) if p.optional)
        return self.parameters[: 1 if self.selector else next(first, None)]

    @cached_property
    def groups(self) -> tuple[Group, ...]:
        """The parameters that may be absent."""
        return tuple(optional_groups(self.parameters[len(self.always) :], 0 if self.selector else len(self.always)))

    @cached_property
    def signature(self) -> tuple[tuple[int, bytes], ...]:
        """The constants at known offsets in the data, which distinguish the layouts of a descriptor. Layouts with the
        same constants are distinguished by the size of the data."""
        constants, offset = [], 0
        for p in self.always:
            if p.kind not in ("scalar", "constant", "counter", "bits"):
                break
            if p.kind == "constant":
                constants.append((offset, p.octets))
            offset += p.size
        return tuple(constants)


#: Anything that has parameters.
Record = Field | Struct


@dataclass(frozen=True, slots=True)
class Reply:
    """The response to a command, in each of its layouts. It is sent if all conditions in `when` are met and, if the
    command has a selector, the function is one of `functions`."""

    layouts: tuple[Field, ...]
    functions: tuple[Function, ...]
    when: tuple[Condition, ...]


@dataclass(frozen=True, slots=True)
class Named:
    """A descriptor that a source names without a layout; its data cannot be decoded."""

    descriptor: int
    role: Role
    name: str
    title: str
    sources: tuple[Source, ...]
    position: Position | None = field(default=None, compare=False)


@dataclass(frozen=True, slots=True)
class Family:
    """Fields and their types, and the descriptor sets in which they occur: one, several, or all of a kind."""

    name: str
    kind: Kind
    title: str
    description: str
    sets: tuple[Set, ...]  # by number
    types: tuple[Type, ...]
    fields: tuple[Field, ...]  # by descriptor, commands before responses
    sources: tuple[Source, ...] = ()
    named: tuple[Named, ...] = ()  # by descriptor, commands before responses
    uncertain: tuple[str, ...] = ()
    position: Position | None = field(default=None, compare=False)

    @property
    def number(self) -> int:
        """The number under which the family is listed: the number of its first set."""
        return self.sets[0].number
