"""The parts of a device profile; the profiles are in `devices`."""

from __future__ import annotations

import re
from collections.abc import Container
from dataclasses import dataclass, field
from typing import Any, Protocol


@dataclass(frozen=True)
class Port:
    """A port, and the protocols that it supports."""

    name: str
    id: int | None  # the number that commands use
    baud_rates: tuple[int, ...]
    protocols: tuple[str, ...]


@dataclass(frozen=True)
class Limit:
    """A number that the device cannot exceed, or that it guarantees."""

    value: float
    unit: str | None
    description: str


@dataclass(frozen=True)
class Note:
    """A note that is not a rate, a port or a limit, perhaps with a table."""

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
    fields: frozenset[tuple[int, int]]  # (set, descriptor) of commands and data
    functions: dict[tuple[int, int], str]  # letters, where they differ from the definition
    base_rates: dict[int, float]  # data set -> Hz; 0: sent as the data arrives
    ports: tuple[Port, ...]
    limits: dict[str, Limit]
    notes: dict[str, Note]
    readings: dict[str, Any]  # "set.field.parameter" -> enumeration or bitfield to read it as
    ack_codes: frozenset[int] = field(default_factory=frozenset)
    perhaps: dict[tuple[int, int], str] = field(default_factory=dict)
    """(set, descriptor) of commands and data that it may have -> why this is believed."""
    incomplete: tuple[str, ...] = ()
    """What is not known of it. If there are any sentences, it may have more than is listed."""
    also: tuple[str, ...] = ()  # other names
    generation: int | None = None
    manual: str | None = None

    def __repr__(self) -> str:
        return f"<Device {self.id}: {self.title}>"

    def supports(self, set: int, descriptor: int) -> bool:
        """Does it support this command or data field? Shared fields are supported in every data
        set."""
        return _has(self.fields, set, descriptor)

    def may_support(self, set: int, descriptor: int) -> bool:
        """The same, including support that is not certain."""
        return self.supports(set, descriptor) or _has(self.perhaps, set, descriptor)

    def decimation(self, set: int, rate: float) -> int:
        """The decimation that is closest to a desired rate in Hz; at least 1.

        If the device can report its base rate, read it from the device.
        """
        base = self.base_rates.get(set, 0.0)
        if not rate > 0:
            raise ValueError(f"a rate must be above 0 Hz, not {rate}")
        if base <= 0:
            raise ValueError(f"{self.title} sends set 0x{set:02X} at no fixed rate")
        return max(1, min(0xFFFF, round(base / rate)))


def _has(known: Container[tuple[int, int]], set: int, descriptor: int) -> bool:
    return (set, descriptor) in known or (set >= 0x80 and (0xFF, descriptor) in known)


def model_number(text: str) -> int | None:
    """The number with which the model and serial numbers of the device information begin.

    Spaces may precede it, and a dot, a dash, a space, a NUL or the end of the text follows it.
    """
    match = re.match(r" *([0-9]+)(?=[-. \0]|\Z)", text)
    number = int(match[1]) if match else 0
    return number if 0 < number <= 0xFFFF else None
