"""What each device supports, and what values mean there that differ between devices."""

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
            "Its documentation has it.",
            frozenset(
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
                    (0x01, 0x0D),  # tools.readings
                    (0x0C, 0x10),  # 3d.default
                    (0x80, 0x01),  # measurements.accel
                    (0x80, 0x02),  # measurements.numbers
                    (0x80, 0x03),  # measurements.strings
                    (0x80, 0x04),  # measurements.health
                    (0x80, 0x05),  # measurements.arrays
                    (0x80, 0x06),  # measurements.growing
                    (0x80, 0x08),  # measurements.cloud
                    (0x80, 0x0A),  # measurements.breeze
                    (0x81, 0x01),  # more.accel
                    (0x81, 0x03),  # more.strings
                    (0x81, 0x07),  # more.own
                    (0xFF, 0xD3),  # shared.timestamp
                }
            ),
            (),
        ),
    ),
    functions={},
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
    incomplete=(),
    also=(),
    generation=None,
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
            "Its documentation has it.",
            frozenset(
                {
                    (0x01, 0x01),  # tools.ping
                    (0x01, 0x02),  # tools.settings
                    (0x01, 0x04),  # tools.status
                    (0x80, 0x01),  # measurements.accel
                }
            ),
            (),
        ),
    ),
    functions={(0x01, 0x02): "WR"},
    base_rates={0x80: 0},
    ports=(),
    limits={},
    notes={},
    readings={
        "protocol.acknowledge.code": types.Mode,
        "tools.status_short.flags": tools.ModelBFaults,
        "tools.status_long.flags": tools.ModelBFaults,
    },
    ack_codes=frozenset([0, 1]),
    incomplete=(),
    also=(),
    generation=None,
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
            "Its documentation has it.",
            frozenset(
                {
                    (0x01, 0x01),  # tools.ping
                    (0x01, 0x02),  # tools.settings
                    (0x01, 0x03),  # tools.set_time
                    (0x01, 0x04),  # tools.status
                    (0x01, 0x05),  # tools.bias
                    (0x01, 0x06),  # tools.capture_bias
                    (0x01, 0x07),  # tools.formats
                    (0x01, 0x09),  # tools.list
                    (0x01, 0x0A),  # tools.inventory
                    (0x01, 0x0B),  # tools.pin
                    (0x01, 0x0D),  # tools.readings
                    (0x80, 0x01),  # measurements.accel
                    (0x80, 0x02),  # measurements.numbers
                    (0x80, 0x03),  # measurements.strings
                    (0x80, 0x04),  # measurements.health
                    (0x80, 0x05),  # measurements.arrays
                    (0x80, 0x06),  # measurements.growing
                    (0x80, 0x07),  # measurements.radio
                    (0x80, 0x08),  # measurements.cloud
                    (0x80, 0x0A),  # measurements.breeze
                    (0x81, 0x01),  # more.accel
                    (0x81, 0x07),  # more.own
                    (0xFF, 0xD3),  # shared.timestamp
                }
            ),
            (),
        ),
        Evidence(
            Support.YES,
            "listed",
            "The device lists it (firmware 1.0.07; 2026-11-23).",
            frozenset(
                {
                    (0x01, 0x0E)  # tools.poll
                }
            ),
            ((1, 110), (1, 111)),
        ),
        Evidence(
            Support.PROBABLE,
            "transcribed",
            "A list by others after its manual has it (Kit of names: Names). It names tools.hello.",
            frozenset(
                {
                    (0x01, 0x0C),  # tools.hello
                    (0x92, 0x01),  # copy.accel
                }
            ),
            (),
        ),
        Evidence(
            Support.NO,
            "refused",
            "The device refuses it (firmware 1.2).",
            frozenset(
                {
                    (0x01, 0x08)  # tools.choice
                }
            ),
            (),
        ),
    ),
    functions={(0x01, 0x02): "WRS"},
    base_rates={0x80: 1000, 0x81: 250},
    ports=(Port("Main", 18, (9600,), ("MIP",), ("MIP",)), Port("CAN", None, (), (), ())),
    limits={"segments": Limit(6, None, "In a format.")},
    notes={},
    readings={"tools.status_short.flags": tools.ModelAFaults},
    ack_codes=frozenset([0, 1, 3]),
    incomplete=(),
    also=("Model See", "c"),
    generation=3,
    manual=None,
)
"""Like the model A, with a radio and without a choice. Also called Model See and c. Generation 3.
Model number 4713. Like the Model A, except as stated here. No manual is known. Uncertain: Whether
it has a model number of its own.

- sheet: Radio
"""

OLD_1 = Device(
    id="old-1",
    title="Old 1",
    description="Known by its name and number.",
    model_number=4001,
    evidence=(
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it.",
            frozenset(
                {
                    (0x01, 0x01)  # tools.ping
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it, Model A and Model B.",
            frozenset(
                {
                    (0x80, 0x02)  # measurements.numbers
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={},
    readings={},
    ack_codes=frozenset([]),
    incomplete=("No manual is known; see `tools.ping`.",),
    also=("First",),
    generation=1,
    manual=None,
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
            "Devices of its generation have it, Model A and Model B.",
            frozenset(
                {
                    (0x01, 0x01),  # tools.ping
                    (0x80, 0x02),  # measurements.numbers
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={},
    readings={},
    ack_codes=frozenset([]),
    incomplete=("Nothing is known of its data.",),
    also=(),
    generation=1,
    manual=None,
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


def find(name: str) -> Device | None:
    """A device by its id, its title or another name."""
    return next((d for d in DEVICES.values() if name in (d.id, d.title, *d.also)), None)


def by_name(name: str) -> Device:
    """The same for any spelling, or for its last words ("gx5 15"); raises UnknownName, which gives the nearest."""
    return DEVICES[device_id(name)]


def by_model(number: int) -> Device | None:
    """A device by its model number; None if it is unknown, for example of a newer device."""
    return next((d for d in DEVICES.values() if d.model_number == number), None)


def identify(info: DeviceInfo) -> Device | None:
    """The device that sent this device information; None if it is unknown."""
    number = model_number(info.model_number) or model_number(info.serial_number)
    return by_model(number) if number else None


# fmt: off
__all__ = [
    "DEVICES", "Device", "DeviceInfo", "Evidence", "Limit", "Note", "Port", "Support", "by_model", "by_name", "find",
    "identify", "model_number",
    "MODEL_A",
    "MODEL_B",
    "MODEL_C",
    "OLD_1",
    "OLD_2",
]
