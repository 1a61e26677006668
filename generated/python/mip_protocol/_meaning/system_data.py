"""What the types of `system_data` mean."""

from __future__ import annotations

from .. import system_data, types
from ..info import BitInfo, BitsInfo, FieldInfo, Info, SetInfo
from ..parameter import Parameter, Variant

# fmt: off
SET = SetInfo("system_data", number=0xA0, title="System data", description="State of the device as a whole.", sources=("3dm-cv7-gnss-ins: System (0xA0)",))

#: Class -> what is known of it.
TYPES: dict[str, Info] = {
    "GpioPinStates": BitsInfo(
        "system_data.gpio_pin_states", type=system_data.GpioPinStates, description="Level of each GPIO pin, set for high. Bits of pins that do not exist read 0.",
        bits=(
            BitInfo("pin_1", first=0, last=0, description="GPIO pin 1."),
            BitInfo("pin_2", first=1, last=1, description="GPIO pin 2."),
            BitInfo("pin_3", first=2, last=2, description="GPIO pin 3."),
            BitInfo("pin_4", first=3, last=3, description="GPIO pin 4."),
        ),
    ),
    "BuiltInTest": FieldInfo(
        "system_data.built_in_test", type=system_data.BuiltInTest,
        title="Built-in test",
        description="Flags of the tests that run all the time.",
        facts=("Supported by 3DM-CV7-GNSS/INS.", "The field is long; stream it at a low rate or poll it.", "A fault is reported even if it has passed by the time of the next message, because its flag remains until it is sent.", "Each stream and each event action keeps its own copy of the flags.", "Some flags may be set without a fault, for instance a receiver without a position fix.", "Unnamed bits are reserved and must be ignored."),
        sources=("3dm-cv7-gnss-ins: Built In Test (0xA0,0x01)",),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("result", "result", "array", description="Flags, defined by each device, least significant byte first: bit 8 is bit 0 of the second byte.", facts=("On the 3DM-CV7-GNSS/INS: values of `types.Cv7ContinuousBuiltInTest`.",), scalar="u8", length=16, variants=(Variant("device", ("3dm-cv7-gnss-ins",), "On the 3DM-CV7-GNSS/INS: values of `types.Cv7ContinuousBuiltInTest`.", {"type": types.Cv7ContinuousBuiltInTest}),)),
        ),
    ),
    "TimeSyncStatus": FieldInfo(
        "system_data.time_sync_status", type=system_data.TimeSyncStatus,
        title="Time sync status",
        description="Whether the device time is locked to the pulse per second.",
        facts=("Supported by 3DM-CV7-GNSS/INS.",),
        sources=("3dm-cv7-gnss-ins: Time Sync Status (0xA0,0x02)",),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("time_sync", "time_sync", "scalar", description="True while the lock is valid; false if the PPS is disabled or no pulse is found.", scalar="bool"),
            Parameter("last_pps_received", "last_pps_received", "scalar", description="Time since the last pulse, at most 255.", facts=("Unit: s.",), scalar="u8", units=("s",)),
        ),
    ),
    "GpioState": FieldInfo(
        "system_data.gpio_state", type=system_data.GpioState,
        title="GPIO state",
        description="Levels of all user GPIO pins.",
        facts=("Supported by 3DM-CV7-GNSS/INS.", "A pulse that is shorter than the period at which the field is sent is missed.", "The pins are sampled within one base period of this set.", "Levels are guaranteed to be valid only for pins that `mip_3dm.GpioConfig` configures for the GPIO feature.", "For fast signals and exact times use the timestamp feature and the event system."),
        sources=("3dm-cv7-gnss-ins: GPIO State (0xA0,0x03)",),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("states", "states", "scalar", description="One bit for each pin.", scalar="u8", type=system_data.GpioPinStates),
        ),
    ),
    "GpioAnalogValue": FieldInfo(
        "system_data.gpio_analog_value", type=system_data.GpioAnalogValue,
        title="GPIO analog value",
        description="Voltage at one GPIO pin.",
        facts=("Not listed in any device profile.", "Known only from the MicroStrain MIP SDK.", "Only for pins that are configured as analog inputs."),
        sources=("mip-sdk-4: Gpio Analog Value (0xA0,0x04)",),
        parameters=(
            Parameter("gpio_id", "gpio_id", "scalar", description="GPIO pin, counted from 1.", facts=("Range: at least 1.",), scalar="u8", minimum=1),
            Parameter("value", "value", "scalar", description="Scaled voltage.", facts=("Unit: V.",), scalar="float", units=("V",)),
        ),
    ),
}
