"""The parts of a device profile; the profiles are in `devices`."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True)
class Port:
    """A port, and the protocols that it speaks."""

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


@dataclass(frozen=True)
class Device:
    """A device profile."""

    id: str
    title: str
    description: str
    model_number: int | None
    fields: frozenset[tuple[int, int]]  # (set, descriptor) of commands and data
    functions: dict[tuple[int, int], str]  # letters, where they differ from the definition
    base_rates: dict[int, float]  # data set -> Hz; 0: sent as the data arise
    ports: tuple[Port, ...]
    limits: dict[str, Limit]
    notes: dict[str, Note]
    readings: dict[str, Any]  # "set.field.parameter" -> enumeration or bitfield to read it as
    ack_codes: frozenset[int] = field(default_factory=frozenset)

    def supports(self, set: int, descriptor: int) -> bool:
        """Does it support this command, or send these data? Shared data belong to every data set."""
        shared = set >= 0x80 and (0xFF, descriptor) in self.fields
        return (set, descriptor) in self.fields or shared

    def decimation(self, set: int, rate: float) -> int:
        """The decimation that comes closest to a wanted rate in Hz; at least 1.

        If the device can report its base rate, ask the device.
        """
        base = self.base_rates.get(set, 0.0)
        if not rate > 0:
            raise ValueError(f"a rate must be above 0 Hz, not {rate}")
        if base <= 0:
            raise ValueError(f"{self.title} sends set 0x{set:02X} at no fixed rate")
        return max(1, min(0xFFFF, round(base / rate)))
