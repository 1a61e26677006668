"""The meaning of the types of `system_data`."""

from __future__ import annotations

from .. import system_data, types
from ..info import BitsInfo, FieldInfo, Info
from ..parameter import Parameter, Variant

# fmt: off

#: Class -> its description.
TYPES: dict[str, Info] = {
    "GpioPinStates": BitsInfo("system_data.gpio_pin_states", system_data.GpioPinStates),
    "BuiltInTest": FieldInfo(
        "system_data.built_in_test", system_data.BuiltInTest, devices=("3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gq7"), assumed=("3dm-cv7-ahrs", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("result", "result", "array", scalar="u8", length=16, variants=(Variant("device", ("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), {"type": types.Cv7InertialContinuousBuiltInTest}), Variant("device", ("3dm-cv7-gnss-ins",), {"type": types.Cv7ContinuousBuiltInTest}), Variant("device", ("3dm-gq7",), {"type": types.Gq7ContinuousBuiltInTest}),)),
        )),
    "TimeSyncStatus": FieldInfo(
        "system_data.time_sync_status", system_data.TimeSyncStatus, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins"), likely=("3dm-cv7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar"), assumed=("3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ins"), parameters=(
            Parameter("time_sync", "time_sync", "scalar", scalar="bool"),
            Parameter("last_pps_received", "last_pps_received", "scalar", scalar="u8", units=("s",)),
        )),
    "GpioState": FieldInfo(
        "system_data.gpio_state", system_data.GpioState, devices=("3dm-cv7-ar", "3dm-cv7-gnss-ins"), assumed=("3dm-cv7-ahrs", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("states", "states", "scalar", scalar="u8", type=system_data.GpioPinStates),
        )),
    "GpioAnalogValue": FieldInfo(
        "system_data.gpio_analog_value", system_data.GpioAnalogValue, parameters=(
            Parameter("gpio_id", "gpio_id", "scalar", scalar="u8", minimum=1),
            Parameter("value", "value", "scalar", scalar="float", units=("V",)),
        )),
}
