"""Descriptions of fields, structures, enumerations, bitfields and sets; see `reflection.info`."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

from .parameter import Parameter


@dataclass(frozen=True)
class Info:
    """The common part of all descriptions."""

    name: str  # in the specification: "sensor.scaled_accel"; of a value or a bit its own
    description: str = ""
    facts: tuple[str, ...] = ()  # further sentences
    sources: tuple[str, ...] = ()  # manual and section: "3dm-gx5-15: 5.1.1 …"

    @property
    def text(self) -> str:
        """Its full description in sentences."""
        return " ".join(filter(None, (self.description, *self.facts)))


@dataclass(frozen=True)
class ValueInfo(Info):
    """A value of an enumeration."""

    value: int = 0
    deprecated: bool = False


@dataclass(frozen=True)
class EnumInfo(Info):
    type: Any = None
    values: tuple[ValueInfo, ...] = ()

    @cached_property
    def names(self) -> dict[int, str]:
        """Value -> its name."""
        return {v.value: v.name for v in self.values}


@dataclass(frozen=True)
class BitInfo(Info):
    """A flag, or a number of several bits, in a bitfield."""

    first: int = 0
    last: int = 0
    alias: bool = False  # it overlaps other bits
    type: Any = None  # the enumeration of a number

    @property
    def mask(self) -> int:
        return (1 << self.last + 1) - (1 << self.first)


@dataclass(frozen=True)
class BitsInfo(Info):
    type: Any = None
    bits: tuple[BitInfo, ...] = ()


@dataclass(frozen=True)
class StructureInfo(Info):
    """A structure, or what a field has in common with one."""

    type: Any = None
    parameters: tuple[Parameter, ...] = ()  # in wire order, with counters and constants

    @cached_property
    def members(self) -> tuple[Parameter, ...]:
        """The parameters that objects hold."""
        return tuple(p for p in self.parameters if not p.derived)

    @cached_property
    def _by_name(self) -> dict[str, Parameter]:
        return {p.name: p for p in self.parameters} | {p.attribute: p for p in self.parameters}

    def __getitem__(self, name: str) -> Parameter:
        """A parameter by its name in the specification, or in Python. Raises UnknownName."""
        found = self._by_name.get(name)
        if found is None:
            from .lookup import unknown

            raise unknown(name, f"a parameter of {self.name}", [p.name for p in self.parameters])
        return found


@dataclass(frozen=True)
class FieldInfo(StructureInfo):
    title: str = ""
    also: tuple[str, ...] = ()  # other names: the vendor's
    functions: tuple[str, ...] = ()  # "write", "read", …
    devices: tuple[str, ...] = ()  # ids of those that support it
    perhaps: tuple[str, ...] = ()  # ids of those that may support it
    deprecated: str = ""  # what to use instead
    advanced: bool = False
    max_rate: float | None = None  # Hz

    @property
    def set(self) -> int:
        return int(self.type.SET)

    @property
    def descriptor(self) -> int:
        return int(self.type.DESCRIPTOR)

    @property
    def role(self) -> str:
        """ "command", "response" or "data"."""
        return str(self.type.ROLE)


@dataclass(frozen=True)
class SetInfo(Info):
    """A descriptor set."""

    number: int = 0
    title: str = ""


__all__ = [
    "BitInfo",
    "BitsInfo",
    "EnumInfo",
    "FieldInfo",
    "Info",
    "SetInfo",
    "StructureInfo",
    "ValueInfo",
]
