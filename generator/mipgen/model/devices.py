"""Devices: the fields that each supports, and the values that have a different meaning there."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from mipgen.read.position import Position

from .fields import Field, Set
from .parameters import Parameter, Variant
from .types import Function, Source, Unit

#: Answers to whether a device supports a field; without a source, that is unknown.
Answer = Literal["yes", "probable", "no", "unknown"]

#: The kinds of evidence, strongest first, and what each states about the fields that it names.
EVIDENCE: dict[str, Answer] = {
    "documented": "yes",  # in the manual of the device
    "listed": "yes",  # by the device itself
    "transcribed": "probable",  # from its manual, by others
    "example": "probable",  # of the vendor, for exactly this device
    "software": "probable",  # of programs that use the device
    "family": "probable",  # of devices of the same generation
    "sister": "probable",  # of a nearly identical device
    "refused": "no",  # by the device itself
}


def strength(kind: str) -> int:
    """Returns the rank of a kind of evidence: 0 is the strongest."""
    return list(EVIDENCE).index(kind)


@dataclass(frozen=True, slots=True)
class ProtocolFirmware:
    """The firmware versions in which a port supports a protocol."""

    protocol: str
    versions: str  # "> 1.0.07"


@dataclass(frozen=True, slots=True)
class Port:
    name: str
    id: int | None
    baud_rates: tuple[int, ...]
    receives: tuple[str, ...]  # protocols
    sends: tuple[str, ...]
    firmware: tuple[ProtocolFirmware, ...] = ()  # of the protocols that only some versions support


@dataclass(frozen=True, slots=True)
class Limit:
    name: str
    value: float | int
    unit: Unit | None
    description: str
    firmware: str | None = None  # ">= 1.0.04": the versions with this limit; None if all


@dataclass(frozen=True, slots=True)
class Note:
    """A note about a device besides its rates, ports and limits, perhaps with a table."""

    name: str
    title: str
    description: str
    rows: tuple[tuple[str, ...], ...] = ()  # the first row is the heading


@dataclass(frozen=True, slots=True)
class Evidence:
    """The reason to believe that a device supports some fields, or does not."""

    kind: str  # a key of EVIDENCE
    sources: tuple[Source, ...] = ()  # none: the manual of the device
    of: tuple[str, ...] = ()  # the devices from which it is inferred
    firmware: str | None = None  # of the device that was queried
    date: str | None = None  # of the query
    note: str = ""
    undefined: tuple[tuple[int, int], ...] = ()  # further sets and descriptors, without a layout

    @property
    def answer(self) -> Answer:
        return EVIDENCE[self.kind]


@dataclass(frozen=True, slots=True)
class Support:
    """A command or data field in one descriptor set that a device supports, or does not, and the accepted
    functions."""

    field: Field
    set: int
    functions: tuple[Function, ...]
    evidence: Evidence
    firmware: str | None = None  # "> 1.0.07": the versions that support it; None: all, or unknown
    deprecated: str | None = None  # the replacement on the device

    @property
    def name(self) -> str:
        """The full name of the field in that set."""
        return self.field.name_in(self.set)

    @property
    def certain(self) -> bool:
        return self.evidence.answer == "yes"

    @property
    def differs(self) -> bool:
        """True if the device accepts different functions than the definition states."""
        return self.functions != self.field.functions

    @property
    def responds(self) -> bool:
        """True if the device accepts a function with a response, or the command has no functions."""
        return not self.field.functions or any(f.responds for f in self.functions)


@dataclass(frozen=True, slots=True)
class Rate:
    """The base rate of a data set on a device."""

    set: Set
    hertz: float | int  # 0: fields are sent as their data arrives


@dataclass(frozen=True, slots=True)
class DeviceVariant:
    """A parameter with a different meaning on a device."""

    field: Field
    parameter: Parameter
    variant: Variant

    @property
    def path(self) -> str:
        """The name of the parameter in the specification: "filter_data.status.filter_state"."""
        return f"{self.field.full_name}.{self.parameter.name}"


@dataclass(frozen=True, slots=True)
class NamedDevice:
    """A device of which only the names and the number are known."""

    id: str
    title: str
    like: str  # the known device that resembles it most
    also: tuple[str, ...] = ()
    model_number: int | None = None

    @property
    def sentence(self) -> str:
        return f"only the name of the {self.title} is known; choose {self.like}, the device most like it"


@dataclass(frozen=True, slots=True)
class Device:
    id: str
    name: str
    title: str
    description: str
    also: tuple[str, ...] = ()  # other names
    model_number: int | None = None
    generation: int | None = None
    manual: str | None = None
    sources: tuple[Source, ...] = ()
    like: str | None = None  # the similar device
    evidence: tuple[Evidence, ...] = ()  # strongest first
    supports: tuple[Support, ...] = ()  # certainly or probably supported fields, by set and descriptor
    refuses: tuple[Support, ...] = ()  # the fields that it does not support
    base_rates: tuple[Rate, ...] = ()
    ports: tuple[Port, ...] = ()
    limits: tuple[Limit, ...] = ()
    notes: tuple[Note, ...] = ()
    variants: tuple[DeviceVariant, ...] = ()
    ack_codes: tuple[int, ...] = ()
    incomplete: tuple[str, ...] = ()  # statements on what is unknown; more may be supported than is listed
    uncertain: tuple[str, ...] = ()
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
        """The answer for a field that no evidence names: with a complete profile, the device does not support it."""
        return "unknown" if self.incomplete else "no"
