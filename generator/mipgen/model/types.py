"""Types: numbers, enumerations, bitfields, vectors and structures; and the source of a fact."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal, Protocol

from mipgen.read.problems import Position

if TYPE_CHECKING:
    from .parameters import Group, Parameter


@dataclass(frozen=True, slots=True)
class Source:
    """The section of a manual that states a fact, and the field length printed there."""

    manual: str
    section: str
    length: str | None = None  # "14", "4 + 3*count", or None if the manual states none
    position: Position | None = field(default=None, compare=False)


@dataclass(frozen=True, slots=True)
class Scalar:
    """A number on the wire, always big-endian."""

    name: str
    size: int
    kind: Literal["unsigned", "signed", "float", "bool", "char"]

    @property
    def width(self) -> int:
        """The number of bits."""
        return 8 * self.size

    @property
    def memory(self) -> int:
        """The size in bytes of the smallest number of a machine that can hold it."""
        return 1 << (self.size - 1).bit_length()


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


class Unit(str):
    """The key of a unit, which fields of the specification state, with the symbol that is shown for it."""

    symbol: str

    def __new__(cls, key: str, symbol: str = "") -> Unit:
        unit = super().__new__(cls, key)
        unit.symbol = symbol or key
        return unit


def unit_symbols(units: Iterable[Unit]) -> tuple[str, ...]:
    return tuple(unit.symbol for unit in units)


@dataclass(frozen=True, slots=True)
class EnumValue:
    name: str
    value: int
    description: str
    deprecated: bool = False
    uncertain: tuple[str, ...] = ()
    short: str | None = None
    needs: tuple[str, ...] = ()  # the hardware that it requires
    position: Position | None = field(default=None, compare=False)


class _Owned(Protocol):
    @property
    def name(self) -> str: ...
    @property
    def owner(self) -> str | None: ...


class _Type:
    __slots__ = ()

    @property
    def full_name(self: _Owned) -> str:
        """The name, prefixed with the set or family that defines it, if one does: "sensor.status"."""
        return f"{self.owner}.{self.name}" if self.owner else self.name


@dataclass(frozen=True, slots=True)
class Enum(_Type):
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
class State:
    """The state in which a bit means something: values of a parameter of the same record."""

    parameter: str
    type: str  # the full name of the enumeration of the states
    values: tuple[str, ...]
    numbers: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Bits:
    """One flag (first == last) or one unsigned number inside a bitfield."""

    name: str
    first: int
    last: int
    description: str
    alias: bool  # intentionally overlaps other bits
    enum: Enum | None = None
    concerns: tuple[str, ...] = ()  # full names of the fields or commands that it is about
    uncertain: tuple[str, ...] = ()
    short: str | None = None
    needs: tuple[str, ...] = ()  # the hardware that it requires
    position: Position | None = field(default=None, compare=False)
    when: State | None = None  # None: in every state

    @property
    def width(self) -> int:
        return self.last - self.first + 1

    @property
    def mask(self) -> int:
        return ((1 << self.width) - 1) << self.first


@dataclass(frozen=True, slots=True)
class Bitfield(_Type):
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
    def width(self) -> int:
        return 8 * self.size

    @property
    def known_mask(self) -> int:
        mask = 0
        for b in self.bits:
            mask |= b.mask
        return mask


@dataclass(frozen=True, slots=True)
class Vector(_Type):
    """A fixed array whose elements have names: vector3f is (x, y, z), quatf is (w, x, y, z)."""

    name: str
    scalar: Scalar
    elements: tuple[str, ...]
    description: str
    uncertain: tuple[str, ...] = ()
    kind: Literal["vector"] = "vector"
    position: Position | None = field(default=None, compare=False)

    @property
    def owner(self) -> None:
        """None: vectors belong to no set. They also have no sources."""

    @property
    def sources(self) -> tuple[Source, ...]:
        return ()


@dataclass(frozen=True, slots=True)
class Struct(_Type):
    """A named group of parameters, used inside fields."""

    name: str
    parameters: tuple[Parameter, ...]
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
    def always(self) -> tuple[Parameter, ...]:
        """The parameters that are always present: in a structure, all."""
        return self.parameters

    @property
    def groups(self) -> tuple[Group, ...]:
        """Empty: in a structure, no parameters may be absent."""
        return ()

    @property
    def present_with(self) -> dict[str, int]:
        return {}

    @property
    def optional(self) -> bool:
        return False

    @property
    def selector(self) -> bool:
        return False

    @property
    def fixed(self) -> bool:
        return self.min_size == self.max_size


Type = Enum | Bitfield | Vector | Struct


def structs(types: Iterable[Type]) -> list[Struct]:
    return [t for t in types if isinstance(t, Struct)]


def named_parts(t: Type) -> Iterable[EnumValue | Bits]:
    return t.values if isinstance(t, Enum) else t.bits if isinstance(t, Bitfield) else ()


@dataclass(frozen=True, slots=True)
class Function:
    """A function selector: the action that a settings command requests."""

    name: str
    letter: str
    value: int
    reply: bool  # False: the device sends no acknowledge
    responds: bool  # True: a response with the current setting follows the acknowledge
    sets: bool  # True: it sets new values, so it may have optional parameters
    like: str | None  # the function whose parameters it requires
    description: str
    position: Position | None = field(default=None, compare=False)


def letters(functions: Iterable[Function]) -> str:
    """Writes functions as letters, as the specification does: "WRSLD"."""
    return "".join(f.letter for f in functions)
