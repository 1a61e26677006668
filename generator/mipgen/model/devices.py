"""Devices: what each supports, and where a value has a meaning of its own there."""

from __future__ import annotations

from dataclasses import dataclass, field

from mipgen.read.position import Position

from .details import Detail, Prose
from .fields import Field, Set
from .parameters import Parameter, Variant
from .types import Function, Source


@dataclass(frozen=True, slots=True)
class Port:
    name: str
    id: int | None
    baud_rates: Detail[tuple[int, ...]]
    protocols: Detail[tuple[str, ...]]


@dataclass(frozen=True, slots=True)
class Limit:
    name: str
    value: Detail[float | int]
    unit: Detail[str | None]
    description: Prose


@dataclass(frozen=True, slots=True)
class Note:
    """A note about a device that is not a rate, a port or a limit, perhaps with a table."""

    name: str
    title: Prose
    description: Prose
    rows: Detail[tuple[tuple[str, ...], ...]] = ()  # the first row is the heading


@dataclass(frozen=True, slots=True)
class Support:
    """A command or data field that a device supports in one descriptor set, and the functions that it takes there."""

    field: Field
    set: int
    functions: tuple[Function, ...]
    evidence: Prose | None = None  # why the device is believed to support it; None if that is certain
    deprecated: Prose | None = None  # what to use instead on the device

    @property
    def name(self) -> str:
        """The full name of the field in that set."""
        return self.field.name_in(self.set)

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
    hertz: Detail[float | int]  # 0: sent as the data arise


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
    title: Prose
    description: Prose
    also: tuple[Prose, ...] = ()  # what others call it
    model_number: int | None = None
    generation: int | None = None
    manual: Detail[str | None] = None
    sources: tuple[Source, ...] = ()
    like: str | None = None  # the device that it is like
    supports: tuple[Support, ...] = ()  # by set and descriptor, those that are not certain included
    base_rates: tuple[Rate, ...] = ()
    ports: tuple[Port, ...] = ()
    limits: tuple[Limit, ...] = ()
    notes: tuple[Note, ...] = ()
    variants: tuple[DeviceVariant, ...] = ()
    ack_codes: tuple[int, ...] = ()
    incomplete: tuple[Prose, ...] = ()  # what is not known; more may be supported than is listed
    uncertain: tuple[Prose, ...] = ()
    position: Position | None = field(default=None, compare=False)

    @property
    def certain(self) -> tuple[Support, ...]:
        """What it supports without a doubt."""
        return tuple(s for s in self.supports if s.evidence is None)
