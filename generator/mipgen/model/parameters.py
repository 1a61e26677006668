"""Parameters: the named values of a field or a structure, in wire order, and how they vary."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING, Final, Literal

from mipgen.read.position import Position

from .details import Detail, Prose
from .types import Bitfield, Bits, Enum, EnumValue, Function, Scalar, Struct, Vector

if TYPE_CHECKING:
    from .operations import ValueOp

#: How a number that people know in hexadecimal is meant: as such, as that of a descriptor set, as a field descriptor.
Shown = Literal["hex", "set", "field"]

#: `Variant.by` of a variant that depends on the device.
DEVICE: Final = "device"


@dataclass(frozen=True, slots=True)
class Case:
    """One alternative of a union. `parameter` is None for the empty one."""

    tag: EnumValue
    parameter: Parameter | None
    operation: ValueOp | None


@dataclass(frozen=True, slots=True)
class Variant:
    """How a parameter differs on one device, or with one value of a sibling. Attributes not given are unchanged."""

    by: str  # "device", or the name of a parameter of the same record
    key: str  # a device id, or a value name of that parameter's enumeration
    value: int | None = None  # the number of that value; None if it is by device
    member: str = ""  # of a structure: the member that differs, in place of the whole
    type: Enum | Bitfield | None = None  # names the values or bits of a plain number
    elements: tuple[str, ...] = ()  # of a vector, in its frame
    units: Detail[tuple[str, ...]] = ()
    frame: Detail[str | None] = None
    minimum: Detail[float | int | None] = None
    maximum: Detail[float | int | None] = None
    default: Detail[object] = None
    valid: Detail[tuple[str, ...] | None] = None  # as of a parameter; empty: nothing says that it is valid
    constant: int | None = None  # it always has this value
    only: tuple[EnumValue | Bits, ...] = ()  # of the values or bits that its type names, those that there are
    deprecated: bool | None = None
    unknown: bool = False  # nobody knows what its values are
    description: Prose = ""

    @property
    def by_device(self) -> bool:
        return self.by == DEVICE


@dataclass(frozen=True, slots=True, eq=False)  # to compare all of it takes long; see `alike`
class Parameter:
    """One named value of a field or a structure, in wire order.

    `element` is what one item is; `length` says how many: None for a single value, a number for a
    fixed array, the counter's name for a counted one, "rest" for one that fills the field.
    """

    name: str
    element: Scalar | Enum | Bitfield | Vector | Struct | None  # None: a union
    length: int | str | None
    operation: ValueOp = field(compare=False)
    description: Prose = ""
    units: Detail[tuple[str, ...]] = ()  # one for all elements, or one for each
    any_unit: bool = False  # no unit can be named: another value decides it, or it is not known
    frame: Detail[str | None] = None
    minimum: Detail[float | int | None] = None
    maximum: Detail[float | int | None] = None
    above: Detail[float | int | None] = None  # open bounds: the value is greater than `above`, less than `below`
    below: Detail[float | int | None] = None
    magnitude: Detail[tuple[float | int | None, float | int | None]] = (None, None)  # least and most length of a vector
    default: Detail[object] = None
    typical: Detail[object] = None  # what a user would send or see, in the form of the codec; of a structure, members
    shown: Shown | None = None  # its number is known in hexadecimal, and may be that of a set or a field
    fields_of: str = ""  # the set of these field descriptors: its name, or the parameter that holds its number
    valid: Detail[tuple[str, ...]] = ()  # what says so: the bit "valid_flags.tow" or the bool "fix_ok"; one, or each's
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
    notes: tuple[Prose, ...] = ()
    uncertain: tuple[Prose, ...] = ()
    position: Position | None = field(default=None, compare=False)

    def alike(self, other: Parameter) -> bool:
        """Do they differ at most in their places?"""
        return all(getattr(self, f.name) == getattr(other, f.name) for f in fields(self) if f.compare)

    @property
    def derived(self) -> bool:
        """Does its value follow from the rest of the record: a constant, or the number of an array's elements?"""
        return self.constant is not None or self.counts is not None

    @property
    def readings(self) -> tuple[Variant, ...]:
        """The variants that name its values or bits; those that name the ones of a member are not among them."""
        return tuple(v for v in self.variants if v.type is not None and not v.member)


def alike(cases: Sequence[Case], others: Sequence[Case]) -> bool:
    """Have two unions the same alternatives?"""
    return len(cases) == len(others) and all(
        a.tag == b.tag
        and (a.parameter.alike(b.parameter) if a.parameter and b.parameter else a.parameter is b.parameter)
        for a, b in zip(cases, others, strict=True)
    )
