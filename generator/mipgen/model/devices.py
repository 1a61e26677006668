"""Devices: the fields that each supports, and the values that have another meaning there."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from mipgen.read.position import Position

from .details import Detail, Prose
from .fields import Field, Set
from .parameters import Parameter, Variant
from .types import Function, Source

#: Does a device have a field? Without a source, it is unknown.
Answer = Literal["yes", "probable", "no", "unknown"]

#: The kinds of evidence, strongest first, and what each states about the fields that it names.
EVIDENCE: dict[str, Answer] = {
    "documented": "yes",  # in the manual of the device
    "listed": "yes",  # by the device itself
    "transcribed": "probable",  # by others, after its manual
    "example": "probable",  # of the vendor, for this very device
    "software": "probable",  # that uses the device
    "family": "probable",  # of devices of the same generation
    "sister": "probable",  # a nearly equal device
    "refused": "no",  # by the device itself
}


def strength(kind: str) -> int:
    """The place of a kind of evidence: 0 is the strongest."""
    return list(EVIDENCE).index(kind)


@dataclass(frozen=True, slots=True)
class ProtocolFirmware:
    """The versions whose port has a protocol."""

    protocol: str
    versions: str  # "> 1.0.07"


@dataclass(frozen=True, slots=True)
class Port:
    name: str
    id: int | None
    baud_rates: Detail[tuple[int, ...]]
    receives: Detail[tuple[str, ...]]  # protocols
    sends: Detail[tuple[str, ...]]
    firmware: Detail[tuple[ProtocolFirmware, ...]] = ()  # of the protocols that not all versions have


@dataclass(frozen=True, slots=True)
class Limit:
    name: str
    value: Detail[float | int]
    unit: Detail[str | None]
    description: Prose
    firmware: Detail[str | None] = None  # ">= 1.0.04": the versions that have it; None if all have


@dataclass(frozen=True, slots=True)
class Note:
    """A note about a device that is not a rate, a port or a limit, perhaps with a table."""

    name: str
    title: Prose
    description: Prose
    rows: Detail[tuple[tuple[str, ...], ...]] = ()  # the first row is the heading


@dataclass(frozen=True, slots=True)
class Evidence:
    """Why a device is believed to have some fields, or not to have them."""

    kind: str  # a key of EVIDENCE
    sources: tuple[Source, ...] = ()  # none: the manual of the device
    of: tuple[str, ...] = ()  # the devices from which it is concluded
    firmware: Detail[str | None] = None  # of the device that was asked
    date: Detail[str | None] = None  # when it was
    note: Prose = ""
    undefined: Detail[tuple[tuple[int, int], ...]] = ()  # further sets and descriptors, without a layout

    @property
    def answer(self) -> Answer:
        return EVIDENCE[self.kind]


@dataclass(frozen=True, slots=True)
class Support:
    """A command or data field in one descriptor set that a device has, or has not, and the functions that it
    accepts."""

    field: Field
    set: int
    functions: tuple[Function, ...]
    evidence: Evidence
    firmware: Detail[str | None] = None  # "> 1.0.07": the versions that have it; None if all have, or it is not known
    deprecated: Prose | None = None  # what to use instead on the device

    @property
    def name(self) -> str:
        """The full name of the field in that set."""
        return self.field.name_in(self.set)

    @property
    def certain(self) -> bool:
        return self.evidence.answer == "yes"

    @property
    def differs(self) -> bool:
        """Does the device accept other functions than the definition states?"""
        return self.functions != self.field.functions

    @property
    def responds(self) -> bool:
        """Does the device accept a function that has a response, or has the command no functions?"""
        return not self.field.functions or any(f.responds for f in self.functions)


@dataclass(frozen=True, slots=True)
class Rate:
    """The rate at which a device samples the fields of a data set."""

    set: Set
    hertz: Detail[float | int]  # 0: sent as the data arrives


@dataclass(frozen=True, slots=True)
class DeviceVariant:
    """A parameter with another meaning on a device."""

    field: Field
    parameter: Parameter
    variant: Variant

    @property
    def path(self) -> str:
        """The name of the parameter in the specification: "filter_data.status.filter_state"."""
        return f"{self.field.full_name}.{self.parameter.name}"


@dataclass(frozen=True, slots=True)
class Device:
    id: str
    name: str
    title: Prose
    description: Prose
    also: tuple[Prose, ...] = ()  # other names
    model_number: int | None = None
    generation: int | None = None
    manual: Detail[str | None] = None
    sources: tuple[Source, ...] = ()
    like: str | None = None  # the device that it is like
    evidence: tuple[Evidence, ...] = ()  # strongest first
    supports: tuple[Support, ...] = ()  # the fields that it certainly or probably has, by set and descriptor
    refuses: tuple[Support, ...] = ()  # the fields that it does not have
    base_rates: tuple[Rate, ...] = ()
    ports: tuple[Port, ...] = ()
    limits: tuple[Limit, ...] = ()
    notes: tuple[Note, ...] = ()
    variants: tuple[DeviceVariant, ...] = ()
    ack_codes: tuple[int, ...] = ()
    incomplete: tuple[Prose, ...] = ()  # statements on what is unknown; more may be supported than is listed
    uncertain: tuple[Prose, ...] = ()
    position: Position | None = field(default=None, compare=False)

    @property
    def certain(self) -> tuple[Support, ...]:
        """The fields that it certainly supports."""
        return tuple(s for s in self.supports if s.certain)

    @property
    def probable(self) -> tuple[Support, ...]:
        """The fields that it probably supports."""
        return tuple(s for s in self.supports if not s.certain)

    @property
    def absent(self) -> Answer:
        """The answer for a field that no evidence names: with a complete profile, the device does not have it."""
        return "unknown" if self.incomplete else "no"
