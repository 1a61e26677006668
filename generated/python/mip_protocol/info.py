"""Descriptions of fields, structures, enumerations, bitfields and sets; see `reflection.info`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from .parameter import Parameter


@dataclass(frozen=True)
class Info:
    """The base of all descriptions."""

    name: str  # in the specification: "sensor.scaled_accel"
    type: Any = None

    @property
    def text(self) -> str:
        """Its documentation, without its title and sources."""
        from . import prose

        return prose.text(self.type)

    @property
    def sources(self) -> tuple[str, ...]:
        """Manuals and sections: "3dm-gx5-15: 5.1.1 …"."""
        from . import prose

        return prose.sources(self.type)


@dataclass(frozen=True)
class MemberInfo:
    """A value of an enumeration, or a part of a bitfield."""

    name: str  # in the specification
    owner: Any  # its class
    member: str  # its name in that class

    @property
    def text(self) -> str:
        from . import prose

        return prose.text(self.owner, self.member)


@dataclass(frozen=True)
class ValueInfo(MemberInfo):
    """A value of an enumeration."""

    value: int = 0
    deprecated: bool = False


@dataclass(frozen=True)
class BitInfo(MemberInfo):
    """A flag, or a number of several bits, in a bitfield."""

    mask: int = 0
    alias: bool = False  # it overlaps other bits
    concerns: tuple[str, ...] = ()  # names of the fields and commands that it concerns
    type: Any = None  # the enumeration of a number

    @property
    def first(self) -> int:
        return (self.mask & -self.mask).bit_length() - 1

    @property
    def last(self) -> int:
        return self.mask.bit_length() - 1


@dataclass(frozen=True)
class _Members(Info):
    #: Names that are not in lower case in the specification.
    spelled: dict[str, str] = field(default_factory=dict)

    def _named(self) -> Iterator[tuple[str, str, int]]:
        """Yields the specification's name, the member's name and its number."""
        for member, number in self.type.__members__.items():
            yield self.spelled.get(member) or str.lower(member), member, int(number)


@dataclass(frozen=True)
class EnumInfo(_Members):
    deprecated: tuple[str, ...] = ()  # names of values

    @cached_property
    def values(self) -> tuple[ValueInfo, ...]:
        return tuple(
            ValueInfo(name, self.type, member, value, name in self.deprecated)
            for name, member, value in self._named()
        )

    @cached_property
    def names(self) -> dict[int, str]:
        """Value -> its name."""
        return {v.value: v.name for v in self.values}


@dataclass(frozen=True)
class BitsInfo(_Members):
    aliases: tuple[str, ...] = ()  # names of bits that overlap others
    #: Bit -> the fields and commands that it concerns.
    concerns: dict[str, tuple[str, ...]] = field(default_factory=dict)
    numbers: dict[str, Any] = field(default_factory=dict)  # name -> its enumeration

    @cached_property
    def bits(self) -> tuple[BitInfo, ...]:
        return tuple(
            BitInfo(
                name,
                self.type,
                member,
                mask,
                name in self.aliases,
                self.concerns.get(name, ()),
                self.numbers.get(name),
            )
            for name, member, mask in self._named()
        )


@dataclass(frozen=True)
class StructureInfo(Info):
    """A structure, or the part of a field's description that structures have, too."""

    parameters: tuple[Parameter, ...] = ()  # in wire order, with counters and constants

    def __post_init__(self) -> None:
        for p in self.parameters:
            if p.owner is None:  # otherwise shared with a field of the same layout
                object.__setattr__(p, "owner", self.type)

    @cached_property
    def members(self) -> tuple[Parameter, ...]:
        """The parameters that objects contain: all but counters and constants."""
        return tuple(p for p in self.parameters if not p.derived)

    @cached_property
    def _by_name(self) -> dict[str, Parameter]:
        return {p.name: p for p in self.parameters} | {p.attribute: p for p in self.parameters}

    def __getitem__(self, name: str) -> Parameter:
        """Returns a parameter by its name in the specification or in Python. Raises UnknownName."""
        found = self._by_name.get(name)
        if found is None:
            from .lookup import unknown

            raise unknown(name, f"a parameter of {self.name}", [p.name for p in self.parameters])
        return found


@dataclass(frozen=True)
class FieldInfo(StructureInfo):
    functions: tuple[str, ...] = ()  # "write", "read", …
    devices: tuple[str, ...] = ()  # ids of those that support it
    perhaps: tuple[str, ...] = ()  # ids of those that may support it
    deprecated: bool = False
    advanced: bool = False
    max_rate: float | None = None  # Hz

    @property
    def title(self) -> str:
        from ._index import FIELDS

        return FIELDS[self.name][3]

    @property
    def also(self) -> tuple[str, ...]:
        """Other names, used by the vendor."""
        from ._index import FIELDS

        return FIELDS[self.name][4]

    @property
    def sets(self) -> Sequence[int]:
        """The descriptor sets in which it occurs."""
        return tuple(self.type.SETS)

    @property
    def descriptor(self) -> int:
        return int(self.type.DESCRIPTOR)

    @property
    def role(self) -> str:
        """ "command", "response" or "data"."""
        return str(self.type.ROLE)


@dataclass(frozen=True)
class SetInfo:
    """A descriptor set."""

    name: str
    number: int
    title: str
    text: str = ""
