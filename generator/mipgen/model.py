"""The resolved model: what MIP is, with every reference followed and every size computed.

Frozen dataclasses that describe the protocol, independent of any language. `resolve` builds them,
`checks` checks them, targets and templates read them. Names are words in lower case joined by
underscores, as the specification gives them; `naming` turns them into each language's case.
Languages that limit the length of identifiers take `short` in place of a name, where there is one.

Templates get layouts as *operations*, the ordered steps of one codec. A template has one branch
per `Operation.kind` and computes nothing.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Final, Literal, NamedTuple, TypeVar

from .guided import Guide
from .simulated import Simulation

COMMAND: Final = "command"
RESPONSE: Final = "response"
DATA: Final = "data"
Role = Literal["command", "response", "data"]

#: How a number that people know in hexadecimal is meant: as such, as that of a descriptor set, as a field descriptor.
Shown = Literal["hex", "set", "field"]

Key = TypeVar("Key")
Item = TypeVar("Item")

#: The set whose fields are valid in every data set.
SHARED_SET: Final = 0xFF

#: `Variant.by` of a variant that depends on the device.
DEVICE: Final = "device"

#: A field is at most 255 bytes long and spends two of them on its length and its descriptor.
MAX_FIELD_DATA = 253


class Position(NamedTuple):
    """A place in a specification file; lines and columns count from 1."""

    file: str
    line: int
    column: int

    def __str__(self) -> str:
        return f"{self.file}:{self.line}:{self.column}"


@dataclass(frozen=True, slots=True)
class Source:
    """The place in a manual that states a fact, and the field length printed there."""

    manual: str
    section: str
    length: str | None = None  # "14", "4 + 3*count", or None if the manual gives none
    position: Position | None = field(default=None, compare=False)


@dataclass(frozen=True, slots=True)
class Scalar:
    """A number on the wire, always big-endian."""

    name: str
    size: int
    kind: Literal["unsigned", "signed", "float", "bool", "char"]


SCALARS: dict[str, Scalar] = {
    s.name: s
    for s in (
        *(Scalar(f"u{8 * n}", n, "unsigned") for n in (1, 2, 4, 8)),
        *(Scalar(f"s{8 * n}", n, "signed") for n in (1, 2, 4, 8)),
        Scalar("float", 4, "float"),
        Scalar("double", 8, "float"),
        Scalar("bool", 1, "bool"),
        Scalar("char", 1, "char"),
    )
}


# --------------------------------------------------------------------------- types


@dataclass(frozen=True, slots=True)
class EnumValue:
    name: str
    value: int
    description: str
    deprecated: bool = False
    uncertain: tuple[str, ...] = ()
    short: str | None = None
    position: Position | None = field(default=None, compare=False)


@dataclass(frozen=True, slots=True)
class Enum:
    """An open enumeration: unnamed values may be received and are preserved."""

    name: str
    scalar: Scalar
    values: tuple[EnumValue, ...]
    description: str
    owner: str | None  # the set that defines it, None if it is defined in spec/types
    sources: tuple[Source, ...] = ()
    uncertain: tuple[str, ...] = ()
    kind: Literal["enum"] = "enum"
    short: str | None = None
    position: Position | None = field(default=None, compare=False)

    def by_name(self, name: str) -> EnumValue | None:
        return next((v for v in self.values if v.name == name), None)


@dataclass(frozen=True, slots=True)
class Bits:
    """One flag (first == last) or one unsigned number inside a bitfield."""

    name: str
    first: int
    last: int
    description: str
    alias: bool  # intentionally overlaps other bits
    enum: Enum | None = None
    uncertain: tuple[str, ...] = ()
    short: str | None = None
    position: Position | None = field(default=None, compare=False)

    @property
    def width(self) -> int:
        return self.last - self.first + 1

    @property
    def mask(self) -> int:
        return ((1 << self.width) - 1) << self.first


@dataclass(frozen=True, slots=True)
class Bitfield:
    """Named bits of an unsigned scalar, or of `size` bytes, least significant byte first."""

    name: str
    scalar: Scalar | None  # None: a byte array
    size: int
    bits: tuple[Bits, ...]
    description: str
    owner: str | None
    sources: tuple[Source, ...] = ()
    uncertain: tuple[str, ...] = ()
    kind: Literal["bitfield"] = "bitfield"
    short: str | None = None
    position: Position | None = field(default=None, compare=False)

    @property
    def known_mask(self) -> int:
        mask = 0
        for b in self.bits:
            mask |= b.mask
        return mask


@dataclass(frozen=True, slots=True)
class Vector:
    """A fixed array whose elements have names: vector3f is (x, y, z), quatf is (w, x, y, z)."""

    name: str
    scalar: Scalar
    elements: tuple[str, ...]
    description: str
    uncertain: tuple[str, ...] = ()
    kind: Literal["vector"] = "vector"


@dataclass(frozen=True, slots=True)
class Struct:
    """A named group of parameters, used inside fields."""

    name: str
    parameters: tuple[Parameter, ...]
    operations: tuple[Operation, ...]
    min_size: int
    max_size: int
    description: str
    owner: str | None
    sources: tuple[Source, ...] = ()
    uncertain: tuple[str, ...] = ()
    kind: Literal["struct"] = "struct"
    short: str | None = None
    position: Position | None = field(default=None, compare=False)

    @property
    def fixed(self) -> bool:
        return self.min_size == self.max_size


Type = Enum | Bitfield | Vector | Struct


@dataclass(frozen=True, slots=True)
class Function:
    """A function selector: what a settings command is asked to do."""

    name: str
    letter: str
    value: int
    reply: bool  # False: the device sends no acknowledge
    responds: bool  # True: a response with the current setting follows the acknowledge
    sets: bool  # True: it gives new values, so it may carry optional parameters
    like: str | None  # the function whose parameters it requires
    description: str


def letters(functions: Iterable[Function]) -> str:
    """Functions as the specification writes them: "WRSLD"."""
    return "".join(f.letter for f in functions)


# --------------------------------------------------------------------------- parameters


@dataclass(frozen=True, slots=True)
class Case:
    """One alternative of a union. `parameter` is None for the empty one."""

    tag: EnumValue
    parameter: Parameter | None
    operation: Operation | None


@dataclass(frozen=True, slots=True)
class Variant:
    """How a parameter differs on one device, or with one value of a sibling. Attributes not given are unchanged."""

    by: str  # "device", or the name of a parameter of the same record
    key: str  # a device id, or a value name of that parameter's enumeration
    value: int | None = None  # the number of that value; None if it is by device
    member: str = ""  # of a structure: the member that differs, in place of the whole
    type: Enum | Bitfield | None = None  # names the values or bits of a plain number
    elements: tuple[str, ...] = ()  # of a vector, in its frame
    units: tuple[str, ...] = ()
    frame: str | None = None
    minimum: float | int | None = None
    maximum: float | int | None = None
    default: object = None
    valid: tuple[str, ...] | None = None  # as of a parameter; empty: nothing says that it is valid
    constant: int | None = None  # it always has this value
    only: tuple[EnumValue | Bits, ...] = ()  # of the values or bits that its type names, those that there are
    deprecated: bool | None = None
    unknown: bool = False  # nobody knows what its values are
    description: str = ""

    @property
    def by_device(self) -> bool:
        return self.by == DEVICE


@dataclass(frozen=True, slots=True)
class Parameter:
    """One named value of a field or a structure, in wire order.

    `element` is what one item is; `length` says how many: None for a single value, a number for a
    fixed array, the counter's name for a counted one, "rest" for one that fills the field.
    """

    name: str
    element: Scalar | Enum | Bitfield | Vector | Struct | None  # None: a union
    length: int | str | None
    operation: Operation = field(compare=False)
    description: str = ""
    units: tuple[str, ...] = ()  # one for all elements, or one for each
    any_unit: bool = False  # no unit can be named: another value decides it, or it is not known
    frame: str | None = None
    minimum: float | int | None = None
    maximum: float | int | None = None
    above: float | int | None = None  # open bounds: the value is greater than `above`, less than `below`
    below: float | int | None = None
    magnitude: tuple[float | int | None, float | int | None] = (None, None)  # least and most length of a vector
    default: object = None
    typical: object = None  # a value that a user would send or see, in the form of the codec; of a structure, members
    shown: Shown | None = None  # its number is known in hexadecimal, and may be that of a set or a field
    fields_of: str = ""  # the set of these field descriptors: its name, or the parameter that holds its number
    valid: tuple[
        str, ...
    ] = ()  # what says that it is valid: the bit "valid_flags.tow" or the bool "fix_ok"; one, or each's
    variants: tuple[Variant, ...] = ()
    constant: int | None = None
    reserved: int | float | None = None  # the value to send; any value may be received
    counts: str | None = None  # the array that this parameter counts
    tag: str | None = None  # a union's tag
    cases: tuple[Case, ...] = ()
    by_device: bool = False  # every device that supports it has a type for it
    required_for: tuple[Function, ...] = ()  # the functions that require it; none where there is no selector
    optional: bool = False  # no function requires it
    selector: bool = False  # the function selector itself
    deprecated: bool = False
    notes: tuple[str, ...] = ()
    uncertain: tuple[str, ...] = ()
    position: Position | None = field(default=None, compare=False)

    @property
    def derived(self) -> bool:
        """Does its value follow from the rest of the record: a constant, or the number of an array's elements?"""
        return self.constant is not None or self.counts is not None

    @property
    def readings(self) -> tuple[Variant, ...]:
        """The variants that name its values or bits; those that name the ones of a member are not among them."""
        return tuple(v for v in self.variants if v.type is not None and not v.member)


# --------------------------------------------------------------------------- operations


@dataclass(frozen=True, slots=True)
class ScalarOp:
    """One number. `type` names its values or bits, if it has any."""

    member: str
    scalar: Scalar
    type: Enum | Bitfield | None
    size: int
    kind: Literal["scalar"] = "scalar"


@dataclass(frozen=True, slots=True)
class ConstantOp:
    """A constant: written by encode, checked by decode, not stored."""

    member: str
    scalar: Scalar
    value: int
    size: int
    kind: Literal["constant"] = "constant"


@dataclass(frozen=True, slots=True)
class CounterOp:
    """The number of elements of `array`, which comes later in the same record."""

    member: str
    scalar: Scalar
    array: str
    size: int
    kind: Literal["counter"] = "counter"


@dataclass(frozen=True, slots=True)
class BitsOp:
    """A bitfield in `size` bytes, least significant byte first."""

    member: str
    type: Bitfield
    size: int
    kind: Literal["bits"] = "bits"


@dataclass(frozen=True, slots=True)
class TextOp:
    """Characters, one byte each: `count` of them, as many as `counter` says, or the rest."""

    member: str
    count: int | None
    counter: str | None
    capacity: int
    kind: Literal["text"] = "text"


@dataclass(frozen=True, slots=True)
class ArrayOp:
    """Items of one kind: `count` of them, as many as `counter` says, or as many as still fit.

    `item` is a ScalarOp, a StructOp or an ArrayOp (of vectors) whose member is "item";
    `vector` names the elements when the array is a vector, matrix or quaternion.
    """

    member: str
    item: ScalarOp | StructOp | ArrayOp
    count: int | None
    counter: str | None
    capacity: int
    vector: Vector | None = None
    kind: Literal["array"] = "array"


@dataclass(frozen=True, slots=True)
class StructOp:
    member: str
    struct: Struct
    kind: Literal["struct"] = "struct"


@dataclass(frozen=True, slots=True)
class SwitchOp:
    """The one alternative that the enumeration in `tag` selects; nothing for an unknown tag.

    Always the last operation of its record, so that nothing after an unknown tag is lost.
    """

    member: str
    tag: str
    tag_type: Enum
    cases: tuple[Case, ...]
    kind: Literal["switch"] = "switch"


@dataclass(frozen=True, slots=True)
class GroupOp:
    """Parameters that are present or absent together: one, or a counter up to its array.

    The parameters are numbers `first` to `last` (from 1, the function selector not counted).
    The group is required when `last` <= the number that the selected function requires;
    otherwise it is read only if it is wholly there.
    """

    first: int
    last: int
    body: tuple[Operation, ...]
    kind: Literal["group"] = "group"


Operation = ScalarOp | ConstantOp | CounterOp | BitsOp | TextOp | ArrayOp | StructOp | SwitchOp | GroupOp


# --------------------------------------------------------------------------- fields and sets


@dataclass(frozen=True, slots=True)
class Call:
    """One way to send a field: by one of its functions, or the only way where there is no selector."""

    function: Function | None
    required: tuple[Parameter, ...]  # must be there, in wire order; the selector is not counted
    optional: tuple[Parameter, ...]  # may follow these: no function requires them

    @property
    def asked(self) -> tuple[Parameter, ...]:
        """What a caller must give: neither constants nor reserved values."""
        return tuple(p for p in self.required if p.constant is None and p.reserved is None)


@dataclass(frozen=True, slots=True)
class Condition:
    """A parameter of the command has this value, or that of another command was last set to it."""

    parameter: str
    value: int
    label: str  # the value as the specification writes it
    command: str | None = None  # "aiding.echo_control": another command, whose setting it is

    @property
    def boolean(self) -> bool:
        return self.label in ("true", "false")

    def holds(self, value: object) -> bool:
        """Of a Boolean, everything but 0 is true."""
        return bool(value) == bool(self.value) if self.boolean and value is not None else value == self.value


@dataclass(frozen=True)
class Field:
    """One descriptor of one set in one role: a type in every language."""

    set: int
    set_name: str
    name: str
    descriptor: int
    role: Role
    title: str
    description: str
    parameters: tuple[Parameter, ...]
    operations: tuple[Operation, ...]
    min_size: int
    max_size: int
    sources: tuple[Source, ...]
    functions: tuple[Function, ...] = ()  # by value; none where there is no selector
    command: str | None = None  # of a response: the (first) command that owns it
    when: tuple[Condition, ...] = ()  # of a response: what in the command selects it
    devices: tuple[str, ...] = ()  # of a response: the devices that send this one of several layouts; see `answers`
    responses: tuple[str, ...] = ()  # of a command: names of its responses, in the same set
    silent_when: tuple[Condition, ...] = ()  # of a command: it is not acknowledged then
    sent_by: Literal["host", "device"] = "host"  # of a command: who sends it
    silenced_by: tuple[Condition, ...] = ()  # likewise: settings of other commands
    definition: str | None = None  # "gnss_1.dop": the field of another set that this one repeats
    max_rate: float | None = None
    timeout: float | None = None
    advanced: bool = False
    deprecated: str | None = None
    also: tuple[str, ...] = ()  # other names
    keywords: tuple[str, ...] = ()  # words by which people look for it, and which it does not contain
    notes: tuple[str, ...] = ()
    uncertain: tuple[str, ...] = ()
    short: str | None = None
    position: Position | None = field(default=None, compare=False)

    @cached_property
    def full_name(self) -> str:
        return f"{self.set_name}.{self.name}"

    @property
    def selector(self) -> bool:
        """Does it start with a function selector?"""
        return bool(self.functions)

    @cached_property
    def calls(self) -> tuple[Call, ...]:
        """The ways to send it: one for each function, or just one."""
        optional = tuple(p for p in self.counted if p.optional)
        if not self.functions:
            return (Call(None, tuple(p for p in self.parameters if not p.optional), optional),)
        return tuple(
            Call(f, tuple(p for p in self.counted if f in p.required_for), optional if f.sets else ())
            for f in self.functions
        )

    def required(self, function: int | None = None) -> int:
        """How many parameters (the selector not counted) must be there; an unknown function requires none."""
        value = function if self.selector else None
        return next((len(c.required) for c in self.calls if (c.function and c.function.value) == value), 0)

    @property
    def optional(self) -> bool:
        """May parameters be absent?"""
        return any(op.kind == "group" for op in self.operations)

    @property
    def counted(self) -> tuple[Parameter, ...]:
        """The parameters that a count of present ones counts: all but the selector."""
        return tuple(p for p in self.parameters if not p.selector)

    @property
    def constants(self) -> tuple[tuple[int, ConstantOp], ...]:
        """The constants at known offsets in the data, which distinguish two layouts of a descriptor."""
        found, offset = [], 0
        for op in self.operations:
            if not isinstance(op, (ScalarOp, ConstantOp, CounterOp, BitsOp)):
                break
            if isinstance(op, ConstantOp):
                found.append((offset, op))
            offset += op.size
        return tuple(found)

    @property
    def signature(self) -> tuple[tuple[int, int, int], ...]:
        """Its constants as offset, size and value: layouts that share them are distinguished by the size of the
        data."""
        return tuple((at, op.size, op.value) for at, op in self.constants)


@dataclass(frozen=True, slots=True)
class Reply:
    """The response of a command, in each of its layouts. It is sent if the function is one of `functions`, where the
    command has a selector, and if all of `when` holds."""

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
class Set:
    number: int
    name: str
    kind: Literal["command", "data", "shared"]
    title: str
    description: str
    types: tuple[Type, ...]
    fields: tuple[Field, ...]  # by descriptor, commands before responses
    sources: tuple[Source, ...] = ()
    named: tuple[Named, ...] = ()  # by descriptor, commands before responses
    uncertain: tuple[str, ...] = ()
    position: Position | None = field(default=None, compare=False)

    @property
    def own_fields(self) -> tuple[Field, ...]:
        """Without those that repeat another set's."""
        return tuple(f for f in self.fields if f.definition is None)


# --------------------------------------------------------------------------- devices, examples, errata


@dataclass(frozen=True, slots=True)
class Port:
    name: str
    id: int | None
    baud_rates: tuple[int, ...]
    protocols: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Limit:
    name: str
    value: float | int
    unit: str | None
    description: str


@dataclass(frozen=True, slots=True)
class Note:
    """A note about a device that is not a rate, a port or a limit, perhaps with a table."""

    name: str
    title: str
    description: str
    rows: tuple[tuple[str, ...], ...] = ()  # the first row is the heading


@dataclass(frozen=True, slots=True)
class Support:
    """A command or data field that a device supports, and the functions that it takes there."""

    field: Field
    functions: tuple[Function, ...]
    evidence: str | None = None  # why the device is believed to support it; None if that is certain
    deprecated: str | None = None  # what to use instead on the device

    @property
    def differs(self) -> bool:
        """Does the device take other functions than the definition says?"""
        return self.functions != self.field.functions

    @property
    def responds(self) -> bool:
        """Does the device take a function that is answered by a response, or has the command no functions?"""
        return not self.field.functions or any(f.responds for f in self.functions)


@dataclass(frozen=True, slots=True)
class Rate:
    """How often a device samples the fields of a data set."""

    set: Set
    hertz: float | int  # 0: sent as the data arise


@dataclass(frozen=True, slots=True)
class DeviceVariant:
    """A parameter with another meaning on a device."""

    field: Field
    parameter: Parameter
    variant: Variant

    @property
    def path(self) -> str:
        """As the specification names the parameter: "filter_data.status.filter_state"."""
        return f"{self.field.full_name}.{self.parameter.name}"


@dataclass(frozen=True, slots=True)
class Device:
    id: str
    name: str
    title: str
    description: str
    also: tuple[str, ...] = ()  # what others call it
    model_number: int | None = None
    generation: int | None = None
    manual: str | None = None
    sources: tuple[Source, ...] = ()
    like: str | None = None  # the device that it is like
    supports: tuple[Support, ...] = ()  # by set and descriptor, those that are not certain included
    base_rates: tuple[Rate, ...] = ()
    ports: tuple[Port, ...] = ()
    limits: tuple[Limit, ...] = ()
    notes: tuple[Note, ...] = ()
    variants: tuple[DeviceVariant, ...] = ()
    ack_codes: tuple[int, ...] = ()
    incomplete: tuple[str, ...] = ()  # what is not known; more may be supported than is listed
    uncertain: tuple[str, ...] = ()
    position: Position | None = field(default=None, compare=False)

    @property
    def certain(self) -> tuple[Support, ...]:
        """What it supports without a doubt."""
        return tuple(s for s in self.supports if s.evidence is None)


@dataclass(frozen=True, slots=True)
class ExampleField:
    """A field inside an example packet; values in the form that the conformance drivers use."""

    field: str | None  # full name, None for a descriptor that the specification does not know
    descriptor: int
    data: bytes
    values: dict[str, object] | None
    trailing: int
    stated: dict[str, object] | None  # values that the manual states


@dataclass(frozen=True, slots=True)
class Example:
    id: str
    manual: str
    section: str
    title: str
    role: Literal["command", "reply", "data", "field"]
    string: str | None  # the copy-and-paste string of the manual, with its misprints
    table: tuple[int | None, ...] | None  # as in a table of the manual; None for a byte that is left open
    packet: bytes  # always the right bytes
    fields: tuple[ExampleField, ...]
    note: str
    device: Device | None = None  # what sends or takes it; None if its manual is for several and it names none
    synthetic: bool = False  # given by its parameters only, not as bytes
    position: Position | None = field(default=None, compare=False)

    @property
    def set(self) -> int:
        return self.packet[2]


@dataclass(frozen=True, slots=True)
class Claim:
    """A mistake in a manual that `mipgen` can verify."""

    kind: Literal["length", "example", "reference"]
    subject: str
    position: Position | None = field(default=None, compare=False)


@dataclass(frozen=True, slots=True)
class Erratum:
    id: str
    manual: str
    section: str
    severity: Literal["wire", "meaning", "editorial"]
    printed: str
    right: str
    reason: str
    claims: tuple[Claim, ...]
    position: Position | None = field(default=None, compare=False)


@dataclass(frozen=True, slots=True)
class Manual:
    id: str
    title: str
    document: str
    lengths: Literal["wire", "scalars", "none"]  # how it counts field lengths
    sections: tuple[str, ...] = ()  # its headings that may be cited; none: any
    kind: Literal["manual", "sdk"] = "manual"  # sdk: source code of the vendor, not a text for readers


@dataclass(frozen=True, slots=True)
class Word:
    """An entry of a controlled vocabulary: a unit or a frame of reference."""

    symbol: str
    title: str
    description: str
    plural: str = ""  # of a unit that is a word: what more than one are called
    numbered: bool = False  # of a unit: a value is the number of one, "week 2412"
    elements: tuple[str, ...] = ()  # of a frame: what vectors in it have, if not x, y, z


@dataclass(frozen=True, slots=True)
class Chapter:
    """Notes on the protocol for programmers, besides its fields."""

    title: str
    text: tuple[str, ...]  # sentences that belong together, each
    sources: tuple[Source, ...]


@dataclass(frozen=True, slots=True)
class Clock:
    """A clock whose time packets have."""

    name: str
    title: str
    description: str
    epoch: str | None  # "1980-01-06"; without it, it starts with the device
    timestamps: tuple[str, ...]  # full names of the data fields that hold it
    position: Position | None = field(default=None, compare=False)


@dataclass(frozen=True, slots=True)
class Usage:
    """The word that names use for a thing, and those that they do not use."""

    word: str
    instead_of: tuple[str, ...]
    position: Position | None = field(default=None, compare=False)


@dataclass(frozen=True, slots=True)
class Protocol:
    name: str
    version: str
    sync: tuple[int, int]
    max_payload: int
    functions: tuple[Function, ...]
    acknowledge: Field
    ack_code: Enum
    function_selector: Enum
    units: tuple[Word, ...]
    frames: tuple[Word, ...]
    manuals: tuple[Manual, ...]
    notes: tuple[Chapter, ...] = ()
    vocabulary: tuple[Usage, ...] = ()
    clocks: tuple[Clock, ...] = ()  # preferred clocks come first
    leap_seconds: tuple[tuple[str, int], ...] = ()  # day -> seconds that clocks with an epoch are ahead of UTC


@dataclass(frozen=True)
class Model:
    """A whole specification, with lookups of references, which are indexed once."""

    protocol: Protocol
    types: tuple[Type, ...]  # of spec/types, in dependency order
    sets: tuple[Set, ...]  # by number
    devices: tuple[Device, ...] = ()
    examples: tuple[Example, ...] = ()
    errata: tuple[Erratum, ...] = ()
    simulation: Simulation = field(default_factory=Simulation)
    guides: tuple[Guide, ...] = ()
    tastes: tuple[tuple[str, str], ...] = ()  # programs that show the bindings with fields of this specification

    def taste(self, name: str) -> str:
        """The text of one of them; empty if the specification brings none of that name."""
        return dict(self.tastes).get(name, "")

    @cached_property
    def fields(self) -> tuple[Field, ...]:
        """Every field of every set, including repeated ones, without the acknowledge field."""
        return tuple(f for s in self.sets for f in s.fields)

    @cached_property
    def all_types(self) -> tuple[Type, ...]:
        """Those of spec/types, then those of the sets."""
        return (*self.types, *(t for s in self.sets for t in s.types))

    def set(self, number: int) -> Set | None:
        return self._sets.get(number)

    def field(self, full_name: str) -> Field | None:
        return self._fields.get(full_name)

    def type(self, name: str) -> Type | None:
        """A type by its full name: "set.type", or the name alone for one of spec/types."""
        return self._types.get(name)

    def candidates(self, set_number: int, descriptor: int) -> tuple[Field, ...]:
        """The layouts that a descriptor may have inside a packet of that set."""
        ack = self.protocol.acknowledge
        if set_number < 0x80 and descriptor == ack.descriptor:
            return (ack,)
        found = self._descriptors.get((set_number, descriptor), ())
        if not found and set_number >= 0x80:
            found = self._descriptors.get((SHARED_SET, descriptor), ())
        return found

    def layouts(self, f: Field) -> tuple[Field, ...]:
        """The layouts of the descriptor of a field: itself, and those that it must be distinguished from."""
        return self._descriptors.get((f.set, f.descriptor), (f,))

    def sizes(self, f: Field) -> range:
        """The sizes of data with which the descriptor has this layout, given its constants.

        Of several with the same constants it is the longest that the data hold, else the shortest.
        """
        others = [g.min_size for g in self.layouts(f) if g.signature == f.signature]
        first = f.min_size if min(others) < f.min_size else 0
        return range(first, min((n for n in others if n > f.min_size), default=MAX_FIELD_DATA + 1))

    def responses(self, command: Field) -> tuple[Field, ...]:
        """What a command may be answered with."""
        return tuple(self._fields[f"{command.set_name}.{name}"] for name in command.responses)

    def replies(self, command: Field) -> tuple[Reply, ...]:
        """What a command is answered with, and when. Conditions are on the parameters of the command that owns a
        response; another command that has the same response is answered with it always."""
        functions = tuple(f for f in command.functions if f.responds)
        layouts = _grouped((r.when if r.command == command.name else (), r) for r in self.responses(command))
        return tuple(Reply(found, functions, when) for when, found in layouts.items())

    def answers(self, command: Field, device: str) -> tuple[Field, ...]:
        """The same for one device: of the layouts of a response its own, else those that name no devices."""
        found: list[Field] = []
        for reply in self.replies(command):
            own = [f for f in reply.layouts if device in f.devices]
            found += own or [f for f in reply.layouts if not f.devices] or reply.layouts
        return tuple(found)

    def commands(self, response: Field) -> tuple[Field, ...]:
        """The commands that a response answers."""
        return self._commands.get(response.full_name, ())

    def original(self, f: Field) -> Field:
        """The field of another set that this one repeats, or the field itself."""
        return self._fields[f.definition] if f.definition else f

    def repeats(self, f: Field) -> tuple[Field, ...]:
        """The fields of other sets that repeat this one."""
        return self._repeats.get(f.full_name, ())

    def supports(self, f: Field) -> tuple[tuple[Device, Support], ...]:
        """The devices that support a command or data field, those of which it is not certain included."""
        return self._supports.get(f.full_name, ())

    def devices_of(self, f: Field, certain: bool = True) -> tuple[Device, ...]:
        """The devices that support a field, or may support it; a response if they answer a command with it."""
        if f.role == RESPONSE:
            asked = [(c, d, s) for c in self.commands(f) for d, s in self.supports(c) if s.responds]
            found = [(d, s) for c, d, s in asked if f.full_name in {r.full_name for r in self.answers(c, d.id)}]
        else:
            found = list(self.supports(f))
        known = {d.id for d, s in found if s.evidence is None}
        names = known if certain else {d.id for d, _ in found} - known
        return tuple(d for d in self.devices if d.id in names)

    def taken(self, command: Field) -> tuple[Function, ...]:
        """The functions that at least one device takes; all of them where no device is known."""
        found = [x for _, s in self.supports(command) for x in s.functions]
        return tuple(x for x in command.functions if x in found) or command.functions

    def device(self, id: str) -> Device | None:
        return next((d for d in self.devices if d.id == id), None)

    # ----------------------------------------------------------------------- indexes

    @cached_property
    def _sets(self) -> dict[int, Set]:
        return {s.number: s for s in self.sets}

    @cached_property
    def _fields(self) -> dict[str, Field]:
        return {f.full_name: f for f in (*self.fields, self.protocol.acknowledge)}

    @cached_property
    def _types(self) -> dict[str, Type]:
        own = {f"{s.name}.{t.name}": t for s in self.sets for t in s.types}
        return {**own, **{t.name: t for t in self.types}}

    @cached_property
    def _descriptors(self) -> dict[tuple[int, int], tuple[Field, ...]]:
        return _grouped(((f.set, f.descriptor), f) for f in self.fields)

    @cached_property
    def _commands(self) -> dict[str, tuple[Field, ...]]:
        return _grouped((f"{f.set_name}.{name}", f) for f in self.fields for name in f.responses)

    @cached_property
    def _repeats(self) -> dict[str, tuple[Field, ...]]:
        return _grouped((f.definition, f) for f in self.fields if f.definition)

    @cached_property
    def _supports(self) -> dict[str, tuple[tuple[Device, Support], ...]]:
        return _grouped((s.field.full_name, (d, s)) for d in self.devices for s in d.supports)


def _grouped(pairs: Iterable[tuple[Key, Item]]) -> dict[Key, tuple[Item, ...]]:
    found: dict[Key, tuple[Item, ...]] = {}
    for key, item in pairs:
        found[key] = (*found.get(key, ()), item)
    return found
