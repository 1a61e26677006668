"""The fields that each device supports, and the meanings of values that differ between devices."""

from __future__ import annotations

from . import tools, types
from .lookup import device_id
from .profile import Device, DeviceInfo, Evidence, Limit, Note, Port, Support, model_number

MODEL_A = Device(
    id="model-a",
    title="Model A",
    description="Supports nearly everything.",
    model_number=4711,
    evidence=(
        Evidence(
            Support.YES,
            "documented",
            "Documented.",
            {
                0x01: bytes.fromhex("01 02 03 04 05 06 07 08 09 0A 0B 0D"),
                0x0C: bytes.fromhex("10"),
                0x80: bytes.fromhex("01 02 03 04 05 06 08 0A"),
                0x81: bytes.fromhex("01 03 07"),
                0xFF: bytes.fromhex("D3"),
            },
        ),
    ),
    base_rates={0x80: 1000, 0x81: 500},
    ports=(
        Port("Main", 17, (9600, 115200), ("MIP", "NMEA"), ("MIP", "NMEA")),
        Port("USB", None, (), ("MIP",), ("MIP",)),
    ),
    limits={
        "segments": Limit(12, None, "In a format."),
        "range": Limit(2.5, "g", "Of the sensor."),
    },
    notes={
        "pins": Note(
            "Pins", "What each pin can do.", (("Pin", "Use"), ("1", "pulse"), ("2", "serial"))
        )
    },
    readings={
        "tools.status_short.flags": tools.ModelAFaults,
        "tools.status_long.flags": tools.ModelAFaults,
    },
    ack_codes=frozenset([0, 1, 3]),
    manual="guide",
)
"""Supports nearly everything. Model number 4711. Manual: A guide to devices that do not exist, 1.
"""

MODEL_B = Device(
    id="model-b",
    title="Model B",
    description="Small, and reads the acknowledge code in its own way.",
    model_number=None,
    evidence=(
        Evidence(
            Support.YES,
            "documented",
            "Documented.",
            {0x01: bytes.fromhex("01 02 04"), 0x80: bytes.fromhex("01")},
        ),
    ),
    functions={(0x01, 0x02): "WR"},
    base_rates={0x80: 0},
    readings={
        "protocol.acknowledge.code": types.Mode,
        "tools.status_short.flags": tools.ModelBFaults,
        "tools.status_long.flags": tools.ModelBFaults,
    },
    ack_codes=frozenset([0, 1]),
    manual="leaflet",
)
"""Small, and reads the acknowledge code in its own way. Manual: A leaflet about one of them, 2."""

MODEL_C = Device(
    id="model-c",
    title="Model C",
    description="Like the model A, with a radio and without a choice.",
    model_number=4713,
    evidence=(
        Evidence(
            Support.YES,
            "documented",
            "Documented.",
            {
                0x01: bytes.fromhex("01 02 03 04 05 06 07 09 0A 0B 0D"),
                0x80: bytes.fromhex("01 02 03 04 05 06 07 08 0A"),
                0x81: bytes.fromhex("01 07"),
                0xFF: bytes.fromhex("D3"),
            },
        ),
        Evidence(
            Support.YES,
            "listed",
            "Listed by the device (firmware 1.0.07; 2026-11-23).",
            {0x01: bytes.fromhex("0E")},
            ((1, 110), (1, 111)),
        ),
        Evidence(
            Support.PROBABLE,
            "transcribed",
            "Transcribed from the manual by others (Kit of names: Names). It names tools.hello.",
            {0x01: bytes.fromhex("0C"), 0x92: bytes.fromhex("01")},
        ),
        Evidence(
            Support.NO,
            "refused",
            "Rejected by the device (firmware 1.2).",
            {0x01: bytes.fromhex("08")},
        ),
    ),
    functions={(0x01, 0x02): "WRS"},
    firmware={(0x01, 0x06): ">= 1.0, < 1.1", (0x81, 0x01): "> 1.0.07", (0x81, 0x07): "> 1.0.07"},
    base_rates={0x80: 1000, 0x81: 250},
    ports=(Port("Main", 18, (9600,), ("MIP",), ("MIP",)), Port("CAN", None, (), (), ())),
    limits={"segments": Limit(6, None, "In a format.", "< 2.0")},
    readings={"tools.status_short.flags": tools.ModelAFaults},
    ack_codes=frozenset([0, 1, 3]),
    also=("Model See", "c"),
    generation=3,
)
"""Like the model A, with a radio and without a choice. Also called Model See and c. Generation 3.
Model number 4713. Same as the Model A, except as stated here. No manual is known. Uncertain:
Whether it has a model number of its own.

- sheet: Radio
"""

OLD_1 = Device(
    id="old-1",
    title="Old 1",
    description="Known by its name and number.",
    model_number=4001,
    evidence=(
        Evidence(Support.YES, "documented", "Documented.", {0x01: bytes.fromhex("01")}),
        Evidence(
            Support.PROBABLE,
            "family",
            "Supported by devices of the same generation, Model A and Model B.",
            {0x80: bytes.fromhex("02")},
        ),
    ),
    base_rates={},
    incomplete=("No manual is known; see `tools.ping`.",),
    also=("First",),
    generation=1,
)
"""Known by its name and number. Also called First. Generation 1. Model number 4001. No manual is
known. This profile is incomplete: No manual is known; see `tools.Ping`.

- sheet: Names
"""

OLD_2 = Device(
    id="old-2",
    title="Old 2",
    description="Known by its name and number.",
    model_number=4002,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "family",
            "Supported by devices of the same generation, Model A and Model B.",
            {0x01: bytes.fromhex("01"), 0x80: bytes.fromhex("02")},
        ),
    ),
    base_rates={},
    incomplete=("Nothing is known of its data.",),
    generation=1,
)
"""Known by its name and number. Generation 1. Model number 4002. No manual is known. This profile
is incomplete: Nothing is known of its data.

- sheet: Names
"""

#: All devices by id.
DEVICES: dict[str, Device] = {
    "model-a": MODEL_A,
    "model-b": MODEL_B,
    "model-c": MODEL_C,
    "old-1": OLD_1,
    "old-2": OLD_2,
}


def by_name(name: str) -> Device:
    """Finds a device by its id, title, other name or last words ("gx5 15"), in any spelling; raises UnknownName."""
    return DEVICES[device_id(name)]


def by_model(number: int) -> Device | None:
    """Finds a device by its model number; None if the number is unknown, for example of a newer device."""
    return next((d for d in DEVICES.values() if d.model_number == number), None)


def identify(info: DeviceInfo) -> Device | None:
    """Finds the device that sent this device information; None if it is unknown."""
    number = model_number(info.model_number) or model_number(info.serial_number)
    return by_model(number) if number else None


# fmt: off
__all__ = [
    "DEVICES", "Device", "DeviceInfo", "Evidence", "Limit", "Note", "Port", "Support", "by_model", "by_name",
    "identify", "model_number",
    "MODEL_A",
    "MODEL_B",
    "MODEL_C",
    "OLD_1",
    "OLD_2",
]
