"""The parts of a device profile; the profiles are in `devices`."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from enum import Enum
from functools import cached_property
from typing import Any, Protocol


class Support(Enum):
    """Does a device support a command or a data field?"""

    YES = "yes"
    LIKELY = "likely"  # an example, a program or a list of others names this very model
    ASSUMED = "assumed"  # its family or a nearly identical device has it
    NO = "no"
    UNKNOWN = "unknown"


@dataclass(frozen=True)
class Evidence:
    """Why a device is believed to have some fields, or not to have them."""

    answer: Support
    kind: str  # "documented" in its manual, "listed" by the device, ... concluded from a "sister"
    why: str
    descriptors: dict[int, bytes]  # set -> descriptors of commands and data; none: all of the set
    undefined: tuple[tuple[int, int], ...] = ()  # others that it lists, without a known layout
    absence: str = ""  # what the device lacks: "has no magnetometer"


@dataclass(frozen=True)
class Port:
    """A port, and the protocols that it receives and sends."""

    name: str
    id: int | None  # the number that commands use
    baud_rates: tuple[int, ...]
    receives: tuple[str, ...]
    sends: tuple[str, ...]


@dataclass(frozen=True)
class Limit:
    """A number that the device cannot exceed, or that it guarantees."""

    value: float
    unit: str | None
    description: str
    firmware: str | None = None  # the versions that it applies to: ">= 1.0.04"


@dataclass(frozen=True)
class Note:
    """A fact about a device that is not a rate, a port or a limit, perhaps with a table."""

    title: str
    description: str
    rows: tuple[tuple[str, ...], ...]  # the first row is the heading


class DeviceInfo(Protocol):
    """The identity of a device, as in `base.BaseDeviceInfo`."""

    @property
    def model_number(self) -> str: ...
    @property
    def serial_number(self) -> str: ...


@dataclass(frozen=True, repr=False)
class Device:
    """A device profile."""

    id: str
    title: str
    description: str
    model_number: int | None
    evidence: tuple[Evidence, ...]  # strongest first
    base_rates: dict[int, float]  # data set -> Hz; 0: sent as the data arrives
    functions: dict[tuple[int, int], str] = field(default_factory=dict)  # if not those of the set
    firmware: dict[tuple[int, int], str] = field(default_factory=dict)  # if not all: "> 1.0.07"
    ports: tuple[Port, ...] = ()
    limits: dict[str, Limit] = field(default_factory=dict)
    notes: dict[str, Note] = field(default_factory=dict)
    readings: dict[str, Any] = field(default_factory=dict)  # "set.field.parameter" -> its type
    ack_codes: frozenset[int] = field(default_factory=frozenset)
    incomplete: tuple[str, ...] = ()  # the gaps: it may support more than is listed
    also: tuple[str, ...] = ()  # other names
    generation: int | None = None
    manual: str | None = None

    def __repr__(self) -> str:
        return f"<Device {self.id}: {self.title}>"

    @cached_property
    def fields(self) -> frozenset[tuple[int, int]]:
        """(set, descriptor) of the commands and data that it supports, or is believed to support."""
        return self.certain | self.likely | self.assumed

    @cached_property
    def certain(self) -> frozenset[tuple[int, int]]:
        return frozenset(key for key, e in self._evidence.items() if e.answer is Support.YES)

    @cached_property
    def likely(self) -> frozenset[tuple[int, int]]:
        return frozenset(key for key, e in self._evidence.items() if e.answer is Support.LIKELY)

    @cached_property
    def assumed(self) -> frozenset[tuple[int, int]]:
        return frozenset(key for key, e in self._evidence.items() if e.answer is Support.ASSUMED)

    @cached_property
    def _evidence(self) -> dict[tuple[int, int], Evidence]:
        return {(s, d): e for e in self.evidence for s, ds in e.descriptors.items() for d in ds}

    @cached_property
    def _whole(self) -> dict[int, Evidence]:
        """Data set of which the device has no field -> why."""
        return {s: e for e in self.evidence for s, ds in e.descriptors.items() if not ds}

    def has(self, set: int, descriptor: int) -> bool:
        """Does it support this command or data field, certainly or as is believed?"""
        return self.support(set, descriptor) not in (Support.NO, Support.UNKNOWN)

    def support(self, set: int, descriptor: int) -> Support:
        """Returns whether the device supports a command or data field. A shared field is found in
        every data set; what a complete profile does not list is not supported."""
        found = self.why(set, descriptor)
        return found.answer if found else Support.UNKNOWN if self.incomplete else Support.NO

    def why(self, set: int, descriptor: int) -> Evidence | None:
        """Returns the evidence for the answer of `support`; None if there is none."""
        shared = self._evidence.get((0xFF, descriptor)) if set >= 0x80 else None
        return self._evidence.get((set, descriptor)) or self._whole.get(set, shared)

    def decimation(self, set: int, rate: float) -> int:
        """Returns the decimation, at least 1, for the rate closest to a desired one in Hz. If the
        device can report its base rate, read that from the device instead."""
        base = self.base_rates.get(set, 0.0)
        if not rate > 0:
            raise ValueError(f"a rate must be above 0 Hz, not {rate}")
        if base <= 0:
            raise ValueError(f"{self.title} sends set 0x{set:02X} at no fixed rate")
        return max(1, min(0xFFFF, round(base / rate)))


def model_number(text: str) -> int | None:
    """Returns the number with which a model or serial number of the device information begins.

    Spaces may precede it; a dot, dash, space, NUL or the end of the text must follow it.
    """
    match = re.match(r" *([0-9]+)(?=[-. \0]|\Z)", text)
    number = int(match[1]) if match else 0
    return number if 0 < number <= 0xFFFF else None
