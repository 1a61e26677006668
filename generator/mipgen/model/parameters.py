"""Parameters: the named values of a field or a structure, in wire order, and how they vary.

A parameter states both what it means and how it is encoded. If that changes, so do `lower` and the codec of each
target: in C `targets/c/bytecode` and program.h, in Python `targets/python/codecs` and codec.py.
`tests/conformance` compares all languages.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from typing import Final, Literal

from mipgen.read.problems import Position

from .types import SCALARS, Bitfield, Bits, Enum, EnumValue, Function, Scalar, Struct, Type, Unit, Vector

#: The meaning of a number in hexadecimal: a plain number, a descriptor set, or a field descriptor.
Shown = Literal["hex", "set", "field"]

#: The encoding of a parameter: a codec has one branch, or one opcode, for each.
Shape = Literal["scalar", "constant", "counter", "bits", "text", "array", "struct", "switch"]

#: The length of an array or a text that fills the field.
REST: Final = "rest"

#: `Variant.by` of a variant that depends on the device.
DEVICE: Final = "device"


@dataclass(frozen=True, slots=True)
class Case:
    """One alternative of a union. `parameter` is None for the empty one."""

    tag: EnumValue
    parameter: Parameter | None


@dataclass(frozen=True, slots=True)
class Union:
    """The alternatives of a parameter; the parameter `tag` selects one, or none if its value is unknown.

    A union is always the last of its record, so that nothing after an unknown tag is lost.
    """

    tag: str
    type: Enum  # of the tag
    cases: tuple[Case, ...]
    name: str = ""  # of its type; empty: that of its record and its own


def alike(cases: Sequence[Case], others: Sequence[Case]) -> bool:
    """True if two unions have the same alternatives."""
    pairs = list(zip(cases, others, strict=False))
    same = all(a.parameter.alike(b.parameter) if a.parameter and b.parameter else a == b for a, b in pairs)
    return same and [c.tag for c in cases] == [c.tag for c in others]


@dataclass(frozen=True, slots=True)
class Variant:
    """A parameter on one device, or with one value of a sibling. Attributes not given are unchanged."""

    by: str  # "device", or the name of a parameter of the same record
    key: str  # a device id, or a value name of that parameter's enumeration
    value: int | None = None  # the number of that value; None if it is by device
    member: str = ""  # of a structure: the member that differs, instead of the whole
    type: Enum | Bitfield | None = None  # names the values or bits of a plain number
    elements: tuple[str, ...] = ()  # of a vector, in its frame
    units: tuple[Unit, ...] = ()
    frame: str | None = None
    minimum: float | int | None = None
    maximum: float | int | None = None
    default: object = None
    valid: tuple[str, ...] | None = None  # as for a parameter; empty: no flag marks it as valid
    constant: int | None = None  # it always has this value
    only: tuple[EnumValue | Bits, ...] = ()  # the values or bits of its type that exist
    deprecated: bool | None = None
    unknown: bool = False  # its values are unknown
    description: str = ""
    inferred: str = ""  # the reasoning, if no source states it for the device

    @property
    def by_device(self) -> bool:
        return self.by == DEVICE

    def alike(self, other: Variant) -> bool:
        """True if they differ only in the device or the value."""
        pairs = ((getattr(self, f.name), getattr(other, f.name)) for f in fields(self) if f.name != "key")
        return all(a is b or a == b for a, b in pairs)


@dataclass(frozen=True, eq=False)  # comparing all of it would take long; see `alike`
class Parameter:
    """One named value of a field or a structure, in wire order: its meaning, and how it is read and written.

    `element` is the type of one item; `length` is None for a single value, a number for a fixed array, the
    counter's name for a counted array, REST for an array that fills the field.
    """

    name: str
    element: Scalar | Enum | Bitfield | Vector | Struct | None  # None: a union
    length: int | str | None
    description: str = ""
    units: tuple[Unit, ...] = ()  # one for all elements, or one for each
    any_unit: bool = False  # the unit cannot be stated: another value determines it, or it is unknown
    frame: str | None = None
    minimum: float | int | None = None
    maximum: float | int | None = None
    above: float | int | None = None  # exclusive bounds: greater than `above`, less than `below`
    below: float | int | None = None
    magnitude: tuple[float | int | None, float | int | None] = (None, None)  # bounds of a vector's length
    at_rest: tuple[float | int | None, ...] = ()  # on a level device at rest, for each element or one
    positive: str = ""  # what a positive value means: "nose up"
    default: object = None
    typical: object = None  # a typical value, in the form of the codec; of a structure, members
    shown: Shown | None = None  # usually written in hexadecimal; may be the number of a set or a field
    fields_of: str = ""  # the set of these field descriptors: its name, or the parameter with its number
    valid: tuple[str, ...] = ()  # the flags: the bit "valid_flags.tow" or the bool "fix_ok"; one, or each's
    variants: tuple[Variant, ...] = ()
    constant: int | None = None
    reserved: int | float | None = None  # the value to send; any value may be received
    counts: str | None = None  # the array that this parameter counts
    union: Union | None = None
    by_device: bool = False  # every device that supports it defines its type
    required_for: tuple[Function, ...] = ()  # the functions that require it; empty without a selector
    optional: bool = False  # no function requires it
    selector: bool = False  # the function selector itself
    deprecated: bool = False
    notes: tuple[str, ...] = ()
    uncertain: tuple[str, ...] = ()
    most: int = field(default=0, compare=False)  # the maximum number of items in a field, if it varies
    stated: int = field(default=0, compare=False)  # likewise, as the range of its counter states
    position: Position | None = field(default=None, compare=False)

    @property
    def derived(self) -> bool:
        """True if its value follows from the rest of the record: a constant, or the number of an array's elements."""
        return self.constant is not None or self.counts is not None

    @property
    def readings(self) -> tuple[Variant, ...]:
        """The variants that name its values or bits, without those that concern a member."""
        return tuple(v for v in self.variants if v.type is not None and not v.member)

    @property
    def tag(self) -> str | None:
        """The parameter that selects the alternative of a union."""
        return self.union.tag if self.union else None

    @property
    def cases(self) -> tuple[Case, ...]:
        """The alternatives of a union."""
        return self.union.cases if self.union else ()

    @cached_property
    def alternatives(self) -> tuple[Parameter, ...]:
        """The content of the alternatives of a union, without the empty ones."""
        return tuple(c.parameter for c in self.cases if c.parameter is not None)

    def alike(self, other: Parameter) -> bool:
        """True if they differ only in their positions. The content of a type that both share is not read."""
        pairs = ((getattr(self, f.name), getattr(other, f.name)) for f in fields(self) if f.compare)
        return all(a is b or a == b for a, b in pairs)

    # ------------------------------------------------------------------ how it is read and written

    @cached_property
    def kind(self) -> Shape:
        if self.constant is not None:
            return "constant"
        if self.counts is not None:
            return "counter"
        if self.union is not None:
            return "switch"
        if self.length is not None:
            return "text" if isinstance(self.element, Scalar) and self.element.kind == "char" else "array"
        if isinstance(self.element, Bitfield) and self.element.scalar is None:
            return "bits"
        return "struct" if self.struct else "array" if self.vector else "scalar"

    @property
    def struct(self) -> Struct | None:
        """Its structure, if it is one; the structure of an array's elements is in its `item`."""
        return self.element if isinstance(self.element, Struct) and self.length is None else None

    @property
    def vector(self) -> Vector | None:
        """Its vector, matrix or quaternion, if it is one; for an array of vectors, see its `item`."""
        return self.element if isinstance(self.element, Vector) and self.length is None else None

    @property
    def elements(self) -> tuple[str, ...]:
        """The names of the elements of a vector, or of each vector of an array."""
        return self.element.elements if isinstance(self.element, Vector) else ()

    @property
    def named(self) -> Enum | Bitfield | None:
        """The type that names its values or bits; for an array, see its `leaf`."""
        return self.element if isinstance(self.element, (Enum, Bitfield)) and self.length is None else None

    @cached_property
    def scalar(self) -> Scalar:
        """The type of its number or numbers; structures and unions have none."""
        scalar = self.element if isinstance(self.element, Scalar) else getattr(self.element, "scalar", None)
        return scalar or SCALARS["u8"]

    @property
    def size(self) -> int:
        """The size of a single number or a bitfield in bytes."""
        return self.element.size if isinstance(self.element, Bitfield) else self.scalar.size

    @property
    def octets(self) -> bytes:
        """The bytes of a constant."""
        return (self.constant or 0).to_bytes(self.size, "big")

    @property
    def count(self) -> int | None:
        """The number of items of an array, a vector or a text, if it is fixed."""
        if self.vector:
            return len(self.vector.elements)
        return self.length if isinstance(self.length, int) else None

    @property
    def counter(self) -> str | None:
        """The parameter that contains the number of items, if it is neither fixed nor fills the field."""
        return self.length if isinstance(self.length, str) and self.length != REST else None

    @property
    def capacity(self) -> int:
        """The maximum number of items of an array, a vector or a text."""
        return self.most if self.count is None else self.count

    @property
    def several(self) -> bool:
        """True for an array, a vector or a text."""
        return self.kind in ("array", "text")

    @property
    def open(self) -> bool:
        """True for an array or a text of variable length."""
        return isinstance(self.length, str)

    @cached_property
    def item(self) -> Parameter:
        """One item of an array or a vector, with the same meaning; for anything else, the parameter itself."""
        if not self.several:
            return self
        element = self.vector.scalar if self.vector else self.element
        return replace(self, name="item", element=element, length=None, default=None, typical=None)

    @property
    def leaf(self) -> Parameter:
        """One item of an array, of an array's vectors, or of a vector; for anything else, the parameter itself."""
        return self.item.leaf if self.kind == "array" else self

    @property
    def fills(self) -> bool:
        """True for an array or a text that fills the field."""
        return self.length == REST

    @property
    def types(self) -> tuple[Type, ...]:
        """The types that it uses: its own, and those of its variants and alternatives."""
        own = () if self.element is None or isinstance(self.element, Scalar) else (self.element,)
        variants = (v.type for v in self.variants if v.type is not None)
        return (*own, *variants, *(t for p in self.alternatives for t in p.types))

    @property
    def inside(self) -> tuple[Parameter, ...]:
        """The parameters of which it consists."""
        if self.struct:
            return self.struct.parameters
        return (self.item,) if self.several else self.alternatives


@dataclass(frozen=True, slots=True)
class Group:
    """Parameters of a field that are present or absent together: one, or a counter up to its array.

    They are numbered `first` to `last` (from 1, not counting the function selector). The group is required if
    `last` <= the number of parameters that the function requires; otherwise it is read only if it is complete.
    """

    first: int
    last: int
    parameters: tuple[Parameter, ...]


def optional_groups(parameters: Sequence[Parameter], before: int) -> Iterator[Group]:
    """Yields the groups of parameters that may be absent, after `before` others; a counter stays with its array."""
    group, arrays, names = list[Parameter](), set[str](), {p.name for p in parameters}
    for number, p in enumerate(parameters, before + 1):
        group.append(p)
        arrays.discard(p.name)
        if p.counts in names:
            arrays.add(p.counts)
        if not arrays:
            yield Group(number - len(group) + 1, number, tuple(group))
            group = []
