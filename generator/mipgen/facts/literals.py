"""Values as programs in any language write them: with the names of enumeration values and bits."""

from __future__ import annotations

import struct
from collections.abc import Mapping
from dataclasses import dataclass
from decimal import ROUND_HALF_UP, Context
from typing import Any, TypeAlias

from mipgen import model as m

from .descriptors import hexadecimal


@dataclass(frozen=True, slots=True)
class Decimal:
    """A floating-point number."""

    text: str  # the shortest decimal with these bits; it has a point or an exponent
    size: int


@dataclass(frozen=True, slots=True)
class Truth:
    byte: int  # 0 or 1, or another number, which also means true

    @property
    def value(self) -> bool:
        return bool(self.byte)


@dataclass(frozen=True, slots=True)
class Whole:
    text: str  # in the usual notation
    value: int
    size: int


@dataclass(frozen=True, slots=True)
class Choice:
    """A value of an enumeration."""

    type: m.Enum
    number: Whole
    value: m.EnumValue | None


@dataclass(frozen=True, slots=True)
class Flags:
    """A bitfield in a number."""

    type: m.Bitfield
    number: Whole
    names: tuple[m.Bits, ...]  # the flags that make it up; none if it also has other bits, or numbers


@dataclass(frozen=True, slots=True)
class Octets:
    """A bitfield in bytes, least significant byte first."""

    type: m.Bitfield
    bytes: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Text:
    text: str
    count: int | None  # of characters, if it is always the same


@dataclass(frozen=True, slots=True)
class Items:
    """An array, or a vector."""

    items: tuple[Literal, ...]
    vector: m.Vector | None


@dataclass(frozen=True, slots=True)
class Structure:
    """A structure: its values by the names of its parameters."""

    type: m.Struct
    members: dict[str, Literal]


@dataclass(frozen=True, slots=True)
class Alternative:
    """A union with one of its cases."""

    union: m.Union
    case: m.Case | None  # None: the specification does not define its tag
    value: Literal | None  # None: it is empty


Literal: TypeAlias = "Decimal | Truth | Whole | Choice | Flags | Octets | Text | Items | Structure | Alternative"


def record_values(parameters: tuple[m.Parameter, ...], values: Mapping[str, Any]) -> dict[str, Literal]:
    """Converts the given values of some parameters, in wire order."""
    return {p.name: literal(p, values[p.name]) for p in parameters if p.constant is None and p.name in values}


def literal(p: m.Parameter, value: Any) -> Literal:
    """Converts a value of a parameter from the form of the codec."""
    if p.struct:
        return Structure(p.struct, record_values(p.struct.parameters, value))
    if p.union:
        return _alternative(p.union, value)
    if p.kind == "bits" and isinstance(p.element, m.Bitfield):
        return Octets(p.element, tuple(value))
    if p.kind == "text":
        return Text(value, p.count)
    if p.kind == "array":
        return Items(tuple(literal(p.item, v) for v in value), p.vector)
    return _number(p, value)


def _alternative(union: m.Union, value: Mapping[str, Any]) -> Alternative:
    for case in union.cases:
        if case.parameter is not None and case.parameter.name in value:
            return Alternative(union, case, literal(case.parameter, value[case.parameter.name]))
    return Alternative(union, next((c for c in union.cases if c.parameter is None), None), None)


def _number(p: m.Parameter, value: Any) -> Literal:
    scalar, named = p.scalar, p.named
    if scalar.kind == "float":
        return Decimal(decimal(value), scalar.size)
    if scalar.kind == "bool":
        return Truth(value)
    number = Whole(hexadecimal(p, value) if p.shown and value >= 0 else str(value), value, scalar.size)
    if isinstance(named, m.Enum):
        return Choice(named, number, next((v for v in named.values if v.value == value), None))
    if isinstance(named, m.Bitfield):
        return Flags(named, number, flags_of_value(named, value))
    return number


def flags_of_value(t: m.Bitfield, value: int) -> tuple[m.Bits, ...]:
    """Returns the flags that make up a value; none if it also has other bits, or numbers.

    >>> t = m.Bitfield("b", m.SCALARS["u8"], 1, (m.Bits("a", 0, 0, "", False), m.Bits("n", 1, 2, "", False)), "", None)
    >>> [b.name for b in flags_of_value(t, 1)], flags_of_value(t, 3), flags_of_value(t, 128)
    (['a'], (), ())
    """
    named = tuple(b for b in t.bits if b.width == 1 and not b.alias and value & b.mask)
    return named if sum(b.mask for b in named) == value else ()


def decimal(bits: str) -> str:
    """Writes the shortest decimal with the bits of a finite number; it has a point or an exponent.

    >>> decimal("0x3dcccccd"), decimal("0x42480000"), decimal("0x3ff0000000000000"), decimal("0x7149f2ca")
    ('0.1', '50.0', '1.0', '1e+30')
    >>> decimal("0xca5f4ab5")  # -3658413.25
    '-3658413.3'
    """
    raw = bytes.fromhex(bits[2:])
    form = ">f" if len(raw) == 4 else ">d"
    (value,) = struct.unpack(form, raw)
    for digits in range(1, 18):
        # A tie is rounded away from zero, as in JavaScript, because the workbench writes the same programs.
        short = float(Context(prec=digits, rounding=ROUND_HALF_UP).create_decimal_from_float(value))
        try:
            if struct.pack(form, short) == raw:
                return repr(short)
        except OverflowError:
            continue
    raise AssertionError(bits)
