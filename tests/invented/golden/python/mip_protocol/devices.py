"""What each device supports, and how it reads values that devices read differently."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from . import (
    tools,
    types,
)


@dataclass(frozen=True)
class Port:
    name: str
    id: int | None
    baud_rates: tuple[int, ...]
    protocols: tuple[str, ...]


@dataclass(frozen=True)
class Limit:
    value: float
    unit: str | None
    description: str


@dataclass(frozen=True)
class Note:
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
    base_rates: dict[int, float]  # data set -> Hz, 0: sent as it comes
    ports: tuple[Port, ...]
    limits: dict[str, Limit]
    notes: dict[str, Note]
    readings: dict[str, Any]  # parameter or type -> the enumeration or bitfield to read it as
    ack_codes: frozenset[int] = field(default_factory=frozenset)

    def supports(self, set: int, descriptor: int) -> bool:
        """Does it know this command or send these data? Shared data count in every data set."""
        shared = set >= 0x80 and (0xFF, descriptor) in self.fields
        return (set, descriptor) in self.fields or shared

    def decimation(self, set: int, rate: float) -> int:
        """The decimation that comes closest to a wanted rate in Hz; at least 1.

        Ask the device itself for its base rate where that is possible.
        """
        base = self.base_rates.get(set, 0.0)
        if not rate > 0:
            raise ValueError(f"a rate of {rate} Hz is none; it must be above 0")
        if base <= 0:
            raise ValueError(f"{self.title} sends set 0x{set:02X} at no fixed rate")
        return max(1, min(0xFFFF, round(base / rate)))


MODEL_A = Device(
    id="model-a",
    title="Model A",
    description="Supports nearly everything.",
    model_number=4711,
    fields=frozenset(
        {
            (0x01, 0x01),  # tools.ping
            (0x01, 0x02),  # tools.settings
            (0x01, 0x03),  # tools.set_time
            (0x01, 0x04),  # tools.status
            (0x01, 0x05),  # tools.bias
            (0x01, 0x06),  # tools.capture_bias
            (0x01, 0x07),  # tools.formats
            (0x01, 0x08),  # tools.choice
            (0x01, 0x09),  # tools.list
            (0x01, 0x0A),  # tools.inventory
            (0x01, 0x0B),  # tools.pin
            (0x0C, 0x10),  # 3d.default
            (0x80, 0x01),  # measurements.accel
            (0x80, 0x02),  # measurements.numbers
            (0x80, 0x03),  # measurements.strings
            (0x80, 0x04),  # measurements.health
            (0x80, 0x05),  # measurements.arrays
            (0x80, 0x06),  # measurements.growing
            (0x80, 0x07),  # measurements.cloud
            (0x81, 0x01),  # more.accel
            (0x81, 0x03),  # more.strings
            (0x81, 0x07),  # more.own
            (0xFF, 0xD3),  # shared.timestamp
        }
    ),
    functions={},
    base_rates={0x80: 1000, 0x81: 500},
    ports=(
        Port(
            "Main",
            17,
            (9600, 115200),
            ("MIP", "NMEA"),
        ),
        Port(
            "USB",
            None,
            (),
            ("MIP",),
        ),
    ),
    limits={
        "segments": Limit(12, None, "In a format."),
        "range": Limit(2.5, "g", "Of the sensor."),
    },
    notes={
        "pins": Note(
            "Pins",
            "What each pin can do.",
            (("Pin", "Use"), ("1", "pulse"), ("2", "serial")),
        ),
    },
    readings={
        "tools.status_short.flags": tools.ModelAFaults,
        "tools.status_long.flags": tools.ModelAFaults,
    },
    ack_codes=frozenset([0, 1, 3]),
)

MODEL_B = Device(
    id="model-b",
    title="Model B",
    description="Small, and reads the acknowledge code in its own way.",
    model_number=None,
    fields=frozenset(
        {
            (0x01, 0x01),  # tools.ping
            (0x01, 0x02),  # tools.settings
            (0x01, 0x04),  # tools.status
            (0x80, 0x01),  # measurements.accel
        }
    ),
    functions={(0x01, 0x02): "WR"},
    base_rates={0x80: 0},
    ports=(),
    limits={},
    notes={},
    readings={
        "tools.status_short.flags": tools.ModelBFaults,
        "tools.status_long.flags": tools.ModelBFaults,
        "ack_code": types.Mode,
    },
    ack_codes=frozenset([0, 1]),
)

#: All devices by id.
DEVICES: dict[str, Device] = {d.id: d for d in (MODEL_A, MODEL_B)}
