"""The resolved model: what MIP is, with every reference followed and every size computed.

Frozen dataclasses that know the protocol and nothing of any language. `resolve` builds them,
`checks` judges them, targets and templates read them. Names are words in lower case joined by
underscores, as the specification gives them; `naming` turns them into each language's case.

Layouts reach the templates as *operations*: the ordered steps of one codec. A template has one
branch per `Operation.kind` and computes nothing.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Final, Literal

COMMAND: Final = "command"
RESPONSE: Final = "response"
DATA: Final = "data"
Role = Literal["command", "response", "data"]

#: A field is at most 255 bytes long and spends two of them on its length and its descriptor.
MAX_FIELD_DATA = 253


@dataclass(frozen=True, slots=True)
class Position:
    """A place in a specification file; lines and columns count from 1."""

    file: str
    line: int
    column: int

    def __str__(self) -> str:
        return f"{self.file}:{self.line}:{self.column}"


@dataclass(frozen=True, slots=True)
class Source:
    """Where a manual says it, and the field length that it prints there."""

    manual: str
    section: str
    length: str | None = None  # "14", "4 + 3*count", or None where the manual prints none
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
    position: Position | None = field(default=None, compare=False)


@dataclass(frozen=True, slots=True)
class Enum:
    """An open enumeration: other values may come and must survive."""

    name: str
    scalar: Scalar
    values: tuple[EnumValue, ...]
    description: str
    owner: str | None  # the set that defines it, None when it stands in spec/types
    sources: tuple[Source, ...] = ()
    kind: Literal["enum"] = "enum"
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
    alias: bool  # overlaps other bits on purpose
    enum: Enum | None = None
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
    kind: Literal["bitfield"] = "bitfield"
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
    kind: Literal["vector"] = "vector"


@dataclass(frozen=True, slots=True)
class Struct:
    """A named group of parameters that stands inside fields."""

    name: str
    parameters: tuple[Parameter, ...]
    operations: tuple[Operation, ...]
    min_size: int
    max_size: int
    description: str
    owner: str | None
    sources: tuple[Source, ...] = ()
    kind: Literal["struct"] = "struct"
    position: Position | None = field(default=None, compare=False)

    @property
    def fixed(self) -> bool:
        return self.min_size == self.max_size


Type = Enum | Bitfield | Vector | Struct


# --------------------------------------------------------------------------- parameters


@dataclass(frozen=True, slots=True)
class Case:
    """One alternative of a union. `parameter` is None for the empty one."""

    tag: EnumValue
    parameter: Parameter | None
    operation: Operation | None


@dataclass(frozen=True, slots=True)
class Reading:
    """The type that gives a raw value its meaning, by device or by a sibling's value."""

    by: str  # "device", or the name of a parameter before this one
    types: tuple[tuple[str, Enum | Bitfield], ...]  # key: a device id, or a value name of the sibling's enum


@dataclass(frozen=True, slots=True)
class Variant:
    """What a value means on one device, or beside one value of another parameter."""

    by: str  # "device", or the name of a parameter
    key: str  # a device id, or a value name of that parameter's enumeration
    units: tuple[str, ...] = ()
    frame: str | None = None
    minimum: float | int | None = None
    maximum: float | int | None = None
    default: object = None
    description: str = ""

    @property
    def sentence(self) -> str:
        facts = []
        if self.units:
            facts.append(f"unit {', '.join(self.units)}")
        if self.frame:
            facts.append(f"frame {self.frame}")
        if self.minimum is not None and self.maximum is not None:
            facts.append(f"range {self.minimum} to {self.maximum}")
        elif self.minimum is not None or self.maximum is not None:
            facts.append(f"at least {self.minimum}" if self.maximum is None else f"at most {self.maximum}")
        if self.default is not None:
            shown = str(self.default).lower() if isinstance(self.default, bool) else self.default
            facts.append(f"factory default {shown}")
        head = f"On {self.key}" if self.by == "device" else f"If {self.by} is {self.key}"
        said = "; ".join(x for x in (", ".join(facts), self.description.rstrip(".")) if x)
        return f"{head}: {said}."


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
    any_unit: bool = False  # no unit can be named: another value decides it
    frame: str | None = None
    minimum: float | int | None = None
    maximum: float | int | None = None
    default: object = None
    valid: tuple[str, ...] = ()  # "valid_flags.tow": the bit that vouches for it, or one for each element
    variants: tuple[Variant, ...] = ()
    constant: int | None = None
    reserved: int | None = None  # the value to send; any value may come
    counts: str | None = None  # the array that this parameter counts
    tag: str | None = None  # a union's tag
    cases: tuple[Case, ...] = ()
    reading: Reading | None = None
    functions: str | None = None  # letters of the functions that require it; None where there is no selector
    optional: bool = False  # no function requires it
    selector: bool = False  # the function selector itself
    deprecated: bool = False
    notes: tuple[str, ...] = ()
    position: Position | None = field(default=None, compare=False)

    @property
    def unit(self) -> str | None:
        return ", ".join(self.units) or None

    @property
    def valid_when(self) -> str | None:
        return ", ".join(dict.fromkeys(self.valid)) or None

    @property
    def remarks(self) -> tuple[str, ...]:
        """What else a reader must know: the notes, and how the meaning varies."""
        return (*self.notes, *(v.sentence for v in self.variants))


# --------------------------------------------------------------------------- operations


@dataclass(frozen=True, slots=True)
class ScalarOp:
    """One number. `type` names its values or bits, if it has such."""

    member: str
    scalar: Scalar
    type: Enum | Bitfield | None
    size: int
    kind: Literal["scalar"] = "scalar"


@dataclass(frozen=True, slots=True)
class ConstantOp:
    """A number that is always the same: written by encode, demanded by decode, kept nowhere."""

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

    Always the last operation of its record, so that nothing is lost behind an unknown tag.
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
class Function:
    """A function selector: what a settings command is asked to do."""

    name: str
    letter: str
    value: int
    reply: bool  # False: the device sends no acknowledge
    responds: bool  # True: a response with the current setting follows the acknowledge
    description: str


@dataclass(frozen=True, slots=True)
class Condition:
    """A parameter of the command has this value."""

    parameter: str
    value: int
    label: str  # the value as the specification writes it


@dataclass(frozen=True, slots=True)
class Field:
    """One descriptor of one set in one role: a type in every language.

    `required` gives, per function value, how many parameters (the selector not counted) must be
    there; a function that it does not list requires none. For fields without a selector,
    `required` is empty and `required_count` holds. Parameters beyond may be absent.
    """

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
    functions: tuple[Function, ...] = ()
    required: tuple[tuple[int, int], ...] = ()
    required_count: int = 0
    command: str | None = None  # of a response: the (first) command that owns it
    when: tuple[Condition, ...] = ()  # of a response: what in the command selects it
    responses: tuple[str, ...] = ()  # of a command: names of its responses, in the same set
    silent_when: tuple[Condition, ...] = ()  # of a command: it is not acknowledged then
    definition: str | None = None  # "gnss_1.dop": the field of another set that this one repeats
    devices: tuple[str, ...] = ()  # titles of the devices that support it; of a response: its command
    max_rate: float | None = None
    timeout: float | None = None
    advanced: bool = False
    deprecated: str | None = None
    notes: tuple[str, ...] = ()
    position: Position | None = field(default=None, compare=False)

    @property
    def full_name(self) -> str:
        return f"{self.set_name}.{self.name}"

    @property
    def selector(self) -> bool:
        """Does it start with a function selector?"""
        return bool(self.functions)

    @property
    def optional(self) -> bool:
        """May parameters be absent?"""
        return any(op.kind == "group" for op in self.operations)

    @property
    def counted_parameters(self) -> tuple[Parameter, ...]:
        """The parameters that a count of present ones counts: all but the selector."""
        return tuple(p for p in self.parameters if not p.selector)

    @property
    def constants(self) -> tuple[tuple[int, ConstantOp], ...]:
        """The constants at known offsets in the data: what tells two layouts of a descriptor apart."""
        found, offset = [], 0
        for op in self.operations:
            if not isinstance(op, (ScalarOp, ConstantOp, CounterOp, BitsOp)):
                break
            if isinstance(op, ConstantOp):
                found.append((offset, op))
            offset += op.size
        return tuple(found)


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
    """A table or a fact of a device that is neither a rate, a port nor a limit."""

    name: str
    title: str
    description: str
    rows: tuple[tuple[str, ...], ...] = ()  # the first row is the heading


@dataclass(frozen=True, slots=True)
class Device:
    id: str
    name: str
    title: str
    manual: str
    description: str
    model_number: int | None
    fields: tuple[str, ...]  # full names of the commands and data fields that it supports
    functions: tuple[tuple[str, str], ...]  # full name -> letters, where they differ from the definition
    base_rates: tuple[tuple[str, float], ...]  # set name -> Hz; 0: sent as it comes
    ports: tuple[Port, ...]
    limits: tuple[Limit, ...]
    notes: tuple[Note, ...]
    readings: tuple[tuple[str, Enum | Bitfield], ...]  # "filter_data.status.status_flags" or a type name
    ack_codes: tuple[int, ...]
    position: Position | None = field(default=None, compare=False)


@dataclass(frozen=True, slots=True)
class ExampleField:
    """A field inside an example packet; values in the form that the conformance drivers use."""

    field: str | None  # full name, None for a descriptor that the specification does not know
    descriptor: int
    data: bytes
    values: dict[str, object] | None
    trailing: int
    stated: dict[str, object] | None  # what the manual says beside the bytes


@dataclass(frozen=True, slots=True)
class Example:
    id: str
    manual: str
    section: str
    title: str
    role: Literal["command", "reply", "data", "field"]
    string: str | None  # as printed to copy and paste, misprints and all
    table: tuple[int | None, ...] | None  # as printed in a table; None for a byte that is left open
    packet: bytes  # right, always
    fields: tuple[ExampleField, ...]
    note: str
    synthetic: bool = False  # not printed as bytes: given by its parameters only
    position: Position | None = field(default=None, compare=False)

    @property
    def set(self) -> int:
        return self.packet[2]


@dataclass(frozen=True, slots=True)
class Claim:
    """What an erratum says that the manual prints and that `mipgen` can see to be wrong."""

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
    lengths: Literal["wire", "scalars"]  # how it counts the field lengths that it prints
    sections: tuple[str, ...] = ()  # its headings that may be cited; none: any


@dataclass(frozen=True, slots=True)
class Word:
    """An entry of a controlled vocabulary: a unit or a frame of reference."""

    symbol: str
    title: str
    description: str


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


@dataclass(frozen=True, slots=True)
class Model:
    protocol: Protocol
    types: tuple[Type, ...]  # of spec/types, in dependency order
    sets: tuple[Set, ...]  # by number
    devices: tuple[Device, ...]
    examples: tuple[Example, ...]
    errata: tuple[Erratum, ...]
    tastes: tuple[tuple[str, str], ...] = ()  # programs that show the bindings with fields of this specification

    def taste(self, name: str) -> str:
        """The text of one of them; empty if the specification brings none of that name."""
        return dict(self.tastes).get(name, "")

    @property
    def fields(self) -> tuple[Field, ...]:
        """Every field of every set, repeated ones included; the acknowledge field is not among them."""
        return tuple(f for s in self.sets for f in s.fields)

    def set(self, number: int) -> Set | None:
        return next((s for s in self.sets if s.number == number), None)

    def field(self, full_name: str) -> Field | None:
        if full_name == self.protocol.acknowledge.full_name:
            return self.protocol.acknowledge
        return next((f for f in self.fields if f.full_name == full_name), None)

    def candidates(self, set_number: int, descriptor: int) -> tuple[Field, ...]:
        """The layouts that a descriptor may have inside a packet of that set."""
        ack = self.protocol.acknowledge
        if set_number < 0x80 and descriptor == ack.descriptor:
            return (ack,)
        own = self.set(set_number)
        found = tuple(f for f in own.fields if f.descriptor == descriptor) if own else ()
        if not found and set_number >= 0x80:
            shared = self.set(0xFF)
            found = tuple(f for f in shared.fields if f.descriptor == descriptor) if shared else ()
        return found
