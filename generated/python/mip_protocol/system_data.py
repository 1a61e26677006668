"""System data (0xA0).

State of the device as a whole.

- 3dm-cv7-gnss-ins: System (0xA0)
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import IntFlag
from typing import Any

from . import codec
from .field import Data, Field

# Numbers that are read and written together, by their letters for `struct`.
_16B = codec.Block("16B")

_2B = codec.Block("2B")

_B = codec.Block("B")

_Bf = codec.Block("Bf")


@codec.open_flag(8)
class GpioPinStates(IntFlag):
    """Level of each GPIO pin, set for high. Bits of pins that do not exist read 0."""

    PIN_1 = 1 << 0
    """GPIO pin 1 is high. Bit 0."""
    PIN_2 = 1 << 1
    """GPIO pin 2 is high. Bit 1."""
    PIN_3 = 1 << 2
    """GPIO pin 3 is high. Bit 2."""
    PIN_4 = 1 << 3
    """GPIO pin 4 is high. Bit 3."""


class BuiltInTest(Data):
    """Built-in test (0xA0,0x01).

    Flags of the tests that run all the time.

    Confirmed on 3DM-CV7-AR, 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed on 8 more.
    Requires firmware later than 1.0.10 on the 3DM-GQ7-GNSS/INS.

    The field is long; stream it at a low rate or poll it. A fault that has passed before the next
    message is still reported, because its flag stays set until it is sent. Each stream and each
    event action keeps its own copy of the flags. Some flags may be set without a fault, for
    instance a receiver without a position fix. Unnamed bits are reserved and must be ignored.

    - 3dm-cv7-gnss-ins: Built In Test (0xA0,0x01)
    """

    __slots__ = ("result",)
    __match_args__ = ("result",)

    SET = 0xA0
    DESCRIPTOR = 0x01
    NAME = "system_data.built_in_test"
    _SIZE = 16

    result: tuple[int, ...]
    """Flags, defined by each device, least significant byte first: bit 8 is bit 0 of the second
    byte.

    - On the 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-INS, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-CX7-INS,
      3DM-GV7-AHRS, 3DM-GV7-AR and 3DM-GV7-INS: values of `types.Cv7InertialContinuousBuiltInTest`.
    - On the 3DM-CV7-GNSS/INS: values of `types.Cv7ContinuousBuiltInTest`.
    - On the 3DM-GQ7-GNSS/INS: values of `types.Gq7ContinuousBuiltInTest`.
    """

    def __init__(self, result: Sequence[int]) -> None:
        self.result = codec.several(result)

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.result = _16B.unpack(raw, at)
        return at + 16

    def _write(self) -> bytes:
        return _16B.write("result*16", *codec.exactly("result", self.result, 16))


class TimeSyncStatus(Data):
    """Time sync status (0xA0,0x02).

    Synchronization of the device time with the pulse per second.

    Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 8 more.
    Requires firmware later than 1.0.10 on the 3DM-GQ7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Time Sync Status (0xA0,0x02)
    """

    __slots__ = ("time_sync", "last_pps_received")
    __match_args__ = ("time_sync", "last_pps_received")

    SET = 0xA0
    DESCRIPTOR = 0x02
    NAME = "system_data.time_sync_status"
    _SIZE = 2

    time_sync: bool
    """True while the lock is valid; false if the PPS is disabled or no pulse is found."""
    last_pps_received: int
    """Time since the last pulse, at most 255. Unit: s."""

    def __init__(self, time_sync: bool, last_pps_received: int) -> None:
        self.time_sync = time_sync
        self.last_pps_received = last_pps_received

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2B.unpack(raw, at)
        self.time_sync = codec.TRUTH[v[0]]
        self.last_pps_received = v[1]
        return at + 2

    def _write(self) -> bytes:
        return _2B.write("time_sync last_pps_received", self.time_sync, self.last_pps_received)


class GpioState(Data):
    """GPIO state (0xA0,0x03).

    Levels of all user GPIO pins.

    Confirmed on 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 9 more. Requires firmware
    later than 1.0.10 on the 3DM-GQ7-GNSS/INS.

    A pulse that is shorter than the period at which the field is sent is missed. The pins are
    sampled within one base period of this set. Levels are guaranteed to be valid only for pins that
    `mip_3dm.GpioConfig` configures for the GPIO feature. For fast signals and exact times use the
    timestamp feature and the event system.

    - 3dm-cv7-gnss-ins: GPIO State (0xA0,0x03)
    """

    __slots__ = ("states",)
    __match_args__ = ("states",)

    SET = 0xA0
    DESCRIPTOR = 0x03
    NAME = "system_data.gpio_state"
    _SIZE = 1

    states: GpioPinStates
    """One bit for each pin."""

    def __init__(self, states: GpioPinStates) -> None:
        self.states = states

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.states = codec.KNOWN[GpioPinStates][_B.unpack(raw, at)[0]]
        return at + 1

    def _write(self) -> bytes:
        return _B.write("states", self.states)


class GpioAnalogValue(Data):
    """GPIO analog value (0xA0,0x04).

    Voltage at one GPIO pin.

    Not listed in any device profile. Known only from the MicroStrain MIP SDK.

    The pin must be configured as an analog input.

    - mip-sdk-4: GPIO analog value (0xA0,0x04)
    """

    __slots__ = ("gpio_id", "value")
    __match_args__ = ("gpio_id", "value")

    SET = 0xA0
    DESCRIPTOR = 0x04
    NAME = "system_data.gpio_analog_value"
    _SIZE = 5

    gpio_id: int
    """GPIO pin, counted from 1. Range: at least 1."""
    value: float
    """Scaled voltage. Unit: V."""

    def __init__(self, gpio_id: int, value: float) -> None:
        self.gpio_id = gpio_id
        self.value = value

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _Bf.unpack(raw, at)
        if v[1] != v[1]:
            v = _Bf.keep_nan_bits(v, raw, at)
        self.gpio_id, self.value = v
        return at + 5

    def _write(self) -> bytes:
        return _Bf.write("gpio_id value", self.gpio_id, self.value)


#: Descriptor -> its types; several if constants or the size of the data distinguish layouts.
FIELDS: dict[int, tuple[type[Field], ...]] = {
    0x01: (BuiltInTest,),
    0x02: (TimeSyncStatus,),
    0x03: (GpioState,),
    0x04: (GpioAnalogValue,),
}
