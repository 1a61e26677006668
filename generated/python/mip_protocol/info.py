"""Descriptions of fields, structures, enumerations, bitfields and sets; see `reflection.info`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, NamedTuple

from . import prose
from .described import Described
from .exceptions import EncodeError
from .parameter import Inside, Parameter, here, meant, to_json, to_text


class Item(NamedTuple):
    """One value of an object."""

    parameter: Parameter  # as it applies to these values and this device
    value: Any
    text: str  # with its unit
    valid: bool  # according to its flags


@dataclass(frozen=True)
class Info:
    """The base of all descriptions."""

    name: str  # in the specification: "sensor.scaled_accel"
    type: Any = None

    @property
    def text(self) -> str:
        """Its documentation, without its title and sources."""
        return prose.text(self.type)

    @property
    def sources(self) -> tuple[str, ...]:
        """Manuals and sections: "3dm-gx5-15: 5.1.1 …"."""
        return prose.sources(self.type)


@dataclass(frozen=True)
class MemberInfo:
    """A value of an enumeration, or a part of a bitfield."""

    name: str  # in the specification
    owner: Any  # its class
    member: str  # its name in that class

    @property
    def text(self) -> str:
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
    #: The attribute and its values with which the bit means something; None: always.
    state: tuple[str, tuple[int, ...]] | None = None

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
    states: dict[str, tuple[str, tuple[int, ...]]] = field(default_factory=dict)

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
                self.states.get(name),
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

    # What the methods of an object do; see `described`.

    def is_valid(self, holder: Described, name: str, device: str | None) -> bool:
        name, _, element = name.partition(".")
        p = self[name].of(holder, device)
        if getattr(holder, p.attribute) is None:
            return False
        flags = p.flags
        if element:
            if element not in p.elements:
                from .lookup import unknown

                raise unknown(element, f"an element of {p.name}", p.elements)
            flags = flags[p.elements.index(element) :][:1] if len(flags) > 1 else flags
        values = [(flag, getattr(holder, flag.attribute)) for flag in flags]
        try:
            return all(value is not None and flag.holds(value) for flag, value in values)
        except TypeError:
            wrong = ", ".join({f"{f.attribute} is {value!r}": None for f, value in values})
            raise EncodeError("range", f"{wrong}, needs a whole number") from None

    def meaning(self, holder: Described, name: str, device: str | None) -> Any:
        p = self[name].of(holder, device)
        return meant(p, getattr(holder, p.attribute))

    def to_dict(
        self,
        holder: Described,
        names: bool,
        json: bool,
        device: str | None,
        inside: Inside | None = None,
    ) -> dict[str, Any]:
        values = {}
        for p in self.members:
            value = getattr(holder, p.attribute)
            if value is not None:
                value = to_json(here(p, holder, device, inside), value, holder, names, json, device)
            values[p.name] = value
        return values

    def to_text(self, holder: Described, device: str | None) -> str:
        name = holder._called(self.name)
        try:
            words = self.words(holder, device)
        except EncodeError:
            return repr(holder)  # a value cannot be sent
        return f"{name}: {words}" if words else str(name)

    def words(self, holder: Described, device: str | None, inside: Inside | None = None) -> str:
        return ", ".join(
            f"{x.parameter.name} = {x.text}{'' if x.valid else ' (invalid)'}"
            for x in self.items(holder, device, inside)
        )

    def items(
        self, holder: Described, device: str | None = None, inside: Inside | None = None
    ) -> list[Item]:
        """Returns an object's values, without absent ones."""
        items = []
        for p in self.members:
            value = getattr(holder, p.attribute)
            if value is not None:
                p = here(p, holder, device, inside)
                valid = not p.flags or holder.is_valid(p.name, device)
                items.append(Item(p, value, to_text(p, value, holder, device), valid))
        return items


@dataclass(frozen=True)
class FieldInfo(StructureInfo):
    functions: tuple[str, ...] = ()  # "write", "read", …
    devices: tuple[str, ...] = ()  # ids of those that support it
    likely: tuple[str, ...] = ()  # ids of those for which programs or examples name it
    assumed: tuple[str, ...] = ()  # ids of those whose family has it
    deprecated: bool = False
    advanced: bool = False

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
