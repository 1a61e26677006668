"""Devices: the fields that each supports, and the values that have a different meaning there."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from mipgen.read.problems import Position

from .fields import Field, Set
from .parameters import Parameter, Variant
from .types import Function, Source, Unit

#: Answers to whether a device supports a field; without a source, that is unknown.
Answer = Literal["yes", "likely", "assumed", "no", "unknown"]

#: The answers with which a device is believed to support a field, strongest first.
SUPPORTED: tuple[Answer, ...] = ("yes", "likely", "assumed")

#: Hardware of which a device has a number, and the word for one of it; everything else that a device has is a sensor.
COUNTED = {"receivers": "receiver", "antennas": "antenna"}

#: The kinds of evidence, strongest first, and what each states about the fields that it names.
EVIDENCE: dict[str, Answer] = {
    "documented": "yes",  # in the manual of the device
    "listed": "yes",  # by the device itself
    "transcribed": "likely",  # from its manual, by others
    "example": "likely",  # of the vendor, for exactly this device
    "software": "likely",  # of programs that use the device
    "family": "assumed",  # of devices of the same generation
    "sister": "assumed",  # of a nearly identical device
    "refused": "no",  # by the device itself
    "unlisted": "no",  # by its manual, whose list of the set is known completely
    "hardware": "no",  # it requires hardware that the device lacks
}


def strength(kind: str) -> int:
    """Returns the rank of a kind of evidence: 0 is the strongest."""
    return list(EVIDENCE).index(kind)


def worded(need: str) -> str:
    """
    >>> worded("magnetometer"), worded("accelerometer"), worded("pressure_sensor"), worded("2 antennas")
    ('a magnetometer', 'an accelerometer', 'a pressure sensor', '2 antennas')
    """
    words = need.replace("_", " ")
    return words if need[0].isdigit() else f"{'an' if need[0] in 'aeiou' else 'a'} {words}"


def absence(need: str) -> str:
    """
    >>> absence("magnetometer"), absence("receiver"), absence("2 antennas")
    ('has no magnetometer', 'has no GNSS receiver', 'has fewer than 2 GNSS antennas')
    """
    number, _, word = need.replace("_", " ").rpartition(" ")
    counted = word in {x for pair in COUNTED.items() for x in pair}
    kind = f"GNSS {word}" if counted else need.replace("_", " ")
    return f"has fewer than {number} {kind}" if counted and number else f"has no {kind}"


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
    needs: str = ""  # of hardware: what the device lacks
    sets: tuple[Set, ...] = ()  # of hardware: data sets of which every field needs it, none of which is listed

    @property
    def answer(self) -> Answer:
        return EVIDENCE[self.kind]

    @property
    def absence(self) -> str:
        """What the device lacks: "has no magnetometer"; empty if no hardware is concerned."""
        return absence(self.needs) if self.needs else ""


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
class Hardware:
    """The sensors, GNSS receivers and antenna connectors of a device; None if they are not known."""

    sensors: tuple[str, ...] | None = None
    receivers: int | None = None
    antennas: int | None = None

    def lacking(self, needs: tuple[str, ...]) -> str | None:
        """Returns the first need that the device is known not to meet.

        >>> Hardware(("gyroscope",), receivers=1).lacking(("2 receivers",))
        '2 receivers'
        >>> Hardware(("gyroscope",)).lacking(("receiver", "gyroscope"))
        """
        return next((need for need in needs if not self._meets(need)), None)

    def none_of(self, need: str | None) -> str | None:
        """Returns the need for one of something, if the device lacks several of it and has none.

        >>> Hardware(receivers=0).none_of("2 receivers"), Hardware(receivers=1).none_of("2 receivers")
        ('receiver', '2 receivers')
        """
        word = (need or "").rpartition(" ")[2]
        return COUNTED[word] if word in COUNTED and getattr(self, word) == 0 else need

    def _meets(self, need: str) -> bool:
        number, _, word = need.rpartition(" ")
        for key, singular in COUNTED.items():
            if word in (key, singular):
                count = getattr(self, key)
                return count is None or count >= int(number or 1)
        return self.sensors is None or need in self.sensors


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
    hardware: Hardware = Hardware()
    complete: tuple[Set, ...] = ()  # the sets whose list in the manual is known completely
    evidence: tuple[Evidence, ...] = ()  # strongest first
    supports: tuple[Support, ...] = ()  # fields that it certainly has, likely, or as is assumed, by set and descriptor
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
        return self.answered("yes")

    @property
    def likely(self) -> tuple[Support, ...]:
        """The fields that an example, a program or a list of others names for this very model."""
        return self.answered("likely")

    @property
    def assumed(self) -> tuple[Support, ...]:
        """The fields that only its family or a nearly identical device is known to have."""
        return self.answered("assumed")

    def answered(self, answer: Answer) -> tuple[Support, ...]:
        return tuple(s for s in (*self.supports, *self.refuses) if s.evidence.answer == answer)

    @property
    def absent(self) -> Answer:
        """The answer for a field that no evidence names: with a complete profile, the device does not support it."""
        return "unknown" if self.incomplete else "no"
