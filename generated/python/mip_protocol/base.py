"""Base (0x01).

Commands common to all devices: identity, supported descriptors, idle and resume, self test, reset.

- 3dm-gx5-15: 4.1 Base Commands
- 3dm-cv7-gnss-ins: Base (0x01)
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from . import codec
from .field import ClassOf, Command, Field, R, Response, ResponseClasses, Structure
from .protocol import FunctionSelector

# Numbers that are read and written together, by their letters for `struct`.
_16B = codec.Block("16B")

_B = codec.Block("B")

_BI = codec.Block("BI")

_H = codec.Block("H")

_I = codec.Block("I")


class BaseDeviceInfo(Structure):
    """Identity of a device. The strings are padded with spaces.

    - 3dm-gx5-15: 4.1.3 Get Device Information (0x01, 0x03)
    - 3dm-cv7-gnss-ins: Get device information (0x01,0x03)
    """

    __slots__ = (
        "firmware_version",
        "model_name",
        "model_number",
        "serial_number",
        "lot_number",
        "device_options",
    )
    __match_args__ = (
        "firmware_version",
        "model_name",
        "model_number",
        "serial_number",
        "lot_number",
        "device_options",
    )

    firmware_version: int
    """Firmware version as one decimal number: 1202 means 1.2.02."""
    model_name: str
    """Product name, such as 3DM-GQ7."""
    model_number: str
    """Part number of the model."""
    serial_number: str
    """Serial number, which begins with the model number."""
    lot_number: str
    """Lot number; reserved and blank on some devices."""
    device_options: str
    """Options of the unit, such as its sensor ranges."""

    def __init__(
        self,
        firmware_version: int,
        model_name: str,
        model_number: str,
        serial_number: str,
        lot_number: str,
        device_options: str,
    ) -> None:
        self.firmware_version = firmware_version
        self.model_name = model_name
        self.model_number = model_number
        self.serial_number = serial_number
        self.lot_number = lot_number
        self.device_options = device_options

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.firmware_version = _H.read(raw, at)[0]
        at += 2
        n = 16
        self.model_name = codec.take(raw, at, n).decode("latin-1")
        at += n
        n = 16
        self.model_number = codec.take(raw, at, n).decode("latin-1")
        at += n
        n = 16
        self.serial_number = codec.take(raw, at, n).decode("latin-1")
        at += n
        n = 16
        self.lot_number = codec.take(raw, at, n).decode("latin-1")
        at += n
        n = 16
        self.device_options = codec.take(raw, at, n).decode("latin-1")
        at += n
        return at

    def _write(self) -> bytes:
        out = _H.write("firmware_version", self.firmware_version)
        out += codec.padded("model_name", self.model_name, 16)
        out += codec.padded("model_number", self.model_number, 16)
        out += codec.padded("serial_number", self.serial_number, 16)
        out += codec.padded("lot_number", self.lot_number, 16)
        out += codec.padded("device_options", self.device_options, 16)
        return out


class GpsTimeField(codec.OpenEnum):
    """The part of the GPS time that a value contains."""

    WEEK_NUMBER = 1
    TOW = 2
    """Time of week in whole seconds."""


class GetDeviceInfoResponse(Response):
    """Get device information response (0x01,0x81).

    Response to `GetDeviceInfo`. Supported by all devices; confirmed on 3DM-CV5-10, 3DM-CV5-15,
    3DM-CV7-GNSS/INS, 3DM-CX5-10, 3DM-GQ4-45, 3DM-GQ7-GNSS/INS, 3DM-GX5-15, 3DM-GX5-35, 3DM-GX5-45,
    3DM-RQ1-45-LT and 3DM-RQ1-45-ST.

    - 3dm-gx5-15: 4.1.3 Get Device Information (0x01, 0x03)
    - 3dm-cv7-gnss-ins: Get device information (0x01,0x03)
    """

    __slots__ = ("device_info",)
    __match_args__ = ("device_info",)

    SET = 0x01
    DESCRIPTOR = 0x81
    NAME = "base.get_device_info_response"

    device_info: BaseDeviceInfo
    """Identity of the device."""

    def __init__(self, device_info: BaseDeviceInfo) -> None:
        self.device_info = device_info

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.device_info, at = BaseDeviceInfo._decoded(raw, at)
        return at

    def _write(self) -> bytes:
        out = codec.structure("device_info", self.device_info, BaseDeviceInfo)
        return codec.finished(out)


class GetDeviceDescriptorsResponse(Response):
    """Get device descriptors response (0x01,0x82).

    Response to `GetDeviceDescriptors`. Supported by all devices; confirmed on 3DM-CV5-10,
    3DM-CV5-15, 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-CX5-10, 3DM-GQ4-45,
    3DM-GQ7-GNSS/INS, 3DM-GX5-15, 3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.

    - 3dm-gx5-15: 4.1.4 Get Device Descriptor Sets (0x01, 0x04)
    - 3dm-cv7-gnss-ins: Get device descriptors (0x01,0x04)
    """

    __slots__ = ("descriptors",)
    __match_args__ = ("descriptors",)

    SET = 0x01
    DESCRIPTOR = 0x82
    NAME = "base.get_device_descriptors_response"

    descriptors: tuple[int, ...]
    """Supported descriptors: the descriptor set in the high byte, the field descriptor in the low
    byte.
    """

    def __init__(self, descriptors: Sequence[int]) -> None:
        self.descriptors = codec.several(descriptors)

    def _read(self: Any, raw: bytes, at: int) -> int:
        n = codec.remaining(raw, at, 2)
        self.descriptors = codec.read_numbers("H", raw, at, n)
        at += n * 2
        return at

    def _write(self) -> bytes:
        out = codec.write_numbers(
            "descriptors", "H", codec.at_most("descriptors", self.descriptors, 126)
        )
        return codec.finished(out)


class BuiltInTestResponse(Response):
    """Built-in test response (0x01,0x83).

    Response to `BuiltInTest`. Confirmed on 3DM-CV5-10, 3DM-CV5-15, 3DM-CV7-GNSS/INS, 3DM-CX5-10,
    3DM-GQ4-45, 3DM-GX5-15, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 27 more.

    - 3dm-gx5-15: 4.1.5 Device Built-In Test (0x01, 0x05)
    - 3dm-cv7-gnss-ins: Built in test (0x01,0x05)
    - 3dm-cv7-gnss-ins: Commanded Built-in Test
    """

    __slots__ = ("result",)
    __match_args__ = ("result",)

    SET = 0x01
    DESCRIPTOR = 0x83
    NAME = "base.built_in_test_response"
    _SIZE = 4

    result: int
    """Failure flags, defined by each device. Zero means that every test passed.

    - On the 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25 and 3DM-GX5-25:
      values of `types.Gx5BuiltInTest` (inferred: the 3DM-GX5-15 has it).
    - On the 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-INS, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-CX7-INS,
      3DM-GQ7-GNSS/INS, 3DM-GV7-AHRS, 3DM-GV7-AR, 3DM-GV7-INS and 3DM-RTK: values of
      `types.Cv7BuiltInTest` (inferred: the 3DM-CV7-GNSS/INS has it).
    - On the 3DM-CV7-GNSS/INS: values of `types.Cv7BuiltInTest`.
    - On the 3DM-CX5-45, 3DM-GQ4-45, 3DM-GX3-15, 3DM-GX3-25, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15,
      3DM-GX4-25, 3DM-GX4-45, 3DM-GX4-IMU, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and
      3DM-RQ1-IMU: the values are unknown.
    - On the 3DM-GX5-15: values of `types.Gx5BuiltInTest`.
    """

    def __init__(self, result: int) -> None:
        self.result = result

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.result = _I.unpack(raw, at)[0]
        return at + 4

    def _write(self) -> bytes:
        return _I.write("result", self.result)


class GpsTimeUpdateWeekNumberResponse(Response):
    """GPS time update, week number (0x01,0x84).

    The current week number.

    Response to `GpsTimeUpdate`. Sent if `field_id` is `GpsTimeField.WEEK_NUMBER`. Confirmed on
    3DM-CV5-10, 3DM-CV5-15, 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15 and 3DM-GX5-35; likely or assumed on
    16 more.

    - 3dm-gx5-15: 4.1.8 GPS Time Update (0x01, 0x72)
    - 3dm-cv7-gnss-ins: GPS Time Update Command (0x01,0x72)
    - 3dm-cv7-gnss-ins: Timestamps
    """

    __slots__ = ("week_number",)
    __match_args__ = ("week_number",)

    SET = 0x01
    DESCRIPTOR = 0x84
    NAME = "base.gps_time_update_week_number_response"
    _SIZE = 4

    week_number: int
    """GPS week number. Unit: week."""

    def __init__(self, week_number: int) -> None:
        self.week_number = week_number

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.week_number = _I.unpack(raw, at)[0]
        return at + 4

    def _write(self) -> bytes:
        return _I.write("week_number", self.week_number)


class GpsTimeUpdateTowResponse(Response):
    """GPS time update, time of week (0x01,0x85).

    The current time of week.

    Response to `GpsTimeUpdate`. Sent if `field_id` is `GpsTimeField.TOW`. Confirmed on 3DM-CV5-10,
    3DM-CV5-15, 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15 and 3DM-GX5-35; likely or assumed on 16 more.

    - 3dm-gx5-15: 4.1.8 GPS Time Update (0x01, 0x72)
    - 3dm-cv7-gnss-ins: GPS Time Update Command (0x01,0x72)
    - 3dm-cv7-gnss-ins: Timestamps
    """

    __slots__ = ("tow",)
    __match_args__ = ("tow",)

    SET = 0x01
    DESCRIPTOR = 0x85
    NAME = "base.gps_time_update_tow_response"
    _SIZE = 4

    tow: int
    """GPS time of week in whole seconds. Unit: s."""

    def __init__(self, tow: int) -> None:
        self.tow = tow

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.tow = _I.unpack(raw, at)[0]
        return at + 4

    def _write(self) -> bytes:
        return _I.write("tow", self.tow)


class GetExtendedDescriptorsResponse(Response):
    """Get device descriptors (extended) response (0x01,0x86).

    Response to `GetExtendedDescriptors`. Confirmed on 3DM-CV5-15, 3DM-CV7-AHRS, 3DM-CV7-AR,
    3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS, 3DM-GX5-15, 3DM-GX5-35 and 3DM-GX5-45; likely or assumed on
    12 more.

    - 3dm-gx5-15: 4.1.7 Get Extended Device Descriptor Sets (0x01, 0x07)
    - 3dm-cv7-gnss-ins: Get device descriptors (extended) (0x01,0x07)
    """

    __slots__ = ("descriptors",)
    __match_args__ = ("descriptors",)

    SET = 0x01
    DESCRIPTOR = 0x86
    NAME = "base.get_extended_descriptors_response"

    descriptors: tuple[int, ...]
    """Supported descriptors: the descriptor set in the high byte, the field descriptor in the low
    byte.
    """

    def __init__(self, descriptors: Sequence[int]) -> None:
        self.descriptors = codec.several(descriptors)

    def _read(self: Any, raw: bytes, at: int) -> int:
        n = codec.remaining(raw, at, 2)
        self.descriptors = codec.read_numbers("H", raw, at, n)
        at += n * 2
        return at

    def _write(self) -> bytes:
        out = codec.write_numbers(
            "descriptors", "H", codec.at_most("descriptors", self.descriptors, 126)
        )
        return codec.finished(out)


class ContinuousBuiltInTestResponse(Response):
    """Continuous built-in test response (0x01,0x88).

    Also called `continuous_bit_response`. Response to `ContinuousBuiltInTest`. Confirmed on
    3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 9 more.

    - 3dm-cv7-gnss-ins: Continuous built-in test (0x01,0x08)
    """

    __slots__ = ("result",)
    __match_args__ = ("result",)

    SET = 0x01
    DESCRIPTOR = 0x88
    NAME = "base.continuous_built_in_test_response"
    _SIZE = 16

    result: tuple[int, ...]
    """Flags, defined by each device, least significant byte first: bit 8 is bit 0 of the second
    byte.

    - On the 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-INS, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-CX7-INS,
      3DM-GV7-AHRS, 3DM-GV7-AR and 3DM-GV7-INS: values of `types.Cv7InertialContinuousBuiltInTest`.
    - On the 3DM-CV7-GNSS/INS: values of `types.Cv7ContinuousBuiltInTest`.
    - On the 3DM-GQ7-GNSS/INS: values of `types.Gq7ContinuousBuiltInTest` (inferred: the sources are
      about `system_data.BuiltInTest`, whose flags are the same on the 3DM-CV7-GNSS/INS).
    """

    def __init__(self, result: Sequence[int]) -> None:
        self.result = codec.several(result)

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.result = _16B.unpack(raw, at)
        return at + 16

    def _write(self) -> bytes:
        return _16B.write("result*16", *codec.exactly("result", self.result, 16))


class CommSpeedResponse(Response):
    """Comm port speed response (0x01,0x89).

    Response to `CommSpeed`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS and
    3DM-GQ7-GNSS/INS; likely or assumed on 8 more.

    - 3dm-cv7-gnss-ins: Comm Port Speed (0x01,0x09)
    """

    __slots__ = ("port", "baud")
    __match_args__ = ("port", "baud")

    SET = 0x01
    DESCRIPTOR = 0x89
    NAME = "base.comm_speed_response"
    _SIZE = 5

    port: int
    """Port id of the device.

    - On the 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-GV7-AHRS and 3DM-GV7-AR: values
      of `types.CommInterface`; only `types.CommInterface.MAIN`, `types.CommInterface.UART_1` and
      `types.CommInterface.USB_1`.
    - On the 3DM-CV7-GNSS/INS: values of `types.CommInterface`.
    - On the 3DM-CV7-INS and 3DM-CX7-INS: values of `types.CommInterface`; only
      `types.CommInterface.MAIN`, `types.CommInterface.UART_1`, `types.CommInterface.UART_2`,
      `types.CommInterface.UART_3` and `types.CommInterface.USB_1`.
    - On the 3DM-GQ7-GNSS/INS: 1 is the main port, 2 the auxiliary one.
    - On the 3DM-GV7-INS: values of `types.CommInterface`; only `types.CommInterface.MAIN`,
      `types.CommInterface.UART_1`, `types.CommInterface.UART_2` and `types.CommInterface.USB_1`.
    - On the 3DM-RTK: the values are unknown.
    """
    baud: int
    """Baud rate of the port. Unit: Bd."""

    def __init__(self, port: int, baud: int) -> None:
        self.port = port
        self.baud = baud

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.port, self.baud = _BI.unpack(raw, at)
        return at + 5

    def _write(self) -> bytes:
        return _BI.write("port baud", self.port, self.baud)


class Ping(Command[None]):
    """Ping (0x01,0x01).

    Checks whether a device is present and replies to commands.

    Supported by all devices; confirmed on 3DM-CV5-10, 3DM-CV5-15, 3DM-CV7-GNSS/INS, 3DM-CX5-10,
    3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.

    A device that is not in a normal operating mode may reject the command.

    - 3dm-gx5-15: 4.1.1 Ping (0x01, 0x01)
    - 3dm-cv7-gnss-ins: Ping (0x01,0x01)
    """

    __slots__ = ()

    SET = 0x01
    DESCRIPTOR = 0x01
    NAME = "base.ping"


class SetIdle(Command[None]):
    """Set to idle (0x01,0x02).

    Stops all data streams, and wakes a sleeping device, so that it can be configured.

    Supported by all devices; confirmed on 3DM-CV5-10, 3DM-CV5-15, 3DM-CV7-GNSS/INS, 3DM-CX5-10,
    3DM-GQ4-45, 3DM-GX5-15, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.

    `Resume` restores the previous mode. While idle, the device does not send NMEA sentences either.

    - 3dm-gx5-15: 4.1.2 Set To Idle (0x01, 0x02)
    - 3dm-cv7-gnss-ins: Set to idle (0x01,0x02)
    """

    __slots__ = ()

    SET = 0x01
    DESCRIPTOR = 0x02
    NAME = "base.set_idle"


class GetDeviceInfo(Command[GetDeviceInfoResponse]):
    """Get device information (0x01,0x03).

    Gets the firmware version and the identity strings of the device.

    Response: `GetDeviceInfoResponse`. Supported by all devices; confirmed on 3DM-CV5-10,
    3DM-CV5-15, 3DM-CV7-GNSS/INS, 3DM-CX5-10, 3DM-GQ4-45, 3DM-GQ7-GNSS/INS, 3DM-GX5-15, 3DM-GX5-35,
    3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.

    - 3dm-gx5-15: 4.1.3 Get Device Information (0x01, 0x03)
    - 3dm-cv7-gnss-ins: Get device information (0x01,0x03)
    """

    __slots__ = ()

    SET = 0x01
    DESCRIPTOR = 0x03
    NAME = "base.get_device_info"
    RESPONSES = (GetDeviceInfoResponse,)


class GetDeviceDescriptors(Command[GetDeviceDescriptorsResponse]):
    """Get device descriptors (0x01,0x04).

    Gets the command and data descriptors that the device supports.

    Response: `GetDeviceDescriptorsResponse`. Supported by all devices; confirmed on 3DM-CV5-10,
    3DM-CV5-15, 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-CX5-10, 3DM-GQ4-45,
    3DM-GQ7-GNSS/INS, 3DM-GX5-15, 3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.

    If the list contains the descriptor of `GetExtendedDescriptors`, that command returns further
    descriptors.

    - 3dm-gx5-15: 4.1.4 Get Device Descriptor Sets (0x01, 0x04)
    - 3dm-cv7-gnss-ins: Get device descriptors (0x01,0x04)
    """

    __slots__ = ()

    SET = 0x01
    DESCRIPTOR = 0x04
    NAME = "base.get_device_descriptors"
    RESPONSES = (GetDeviceDescriptorsResponse,)


class BuiltInTest(Command[BuiltInTestResponse]):
    """Built-in test (0x01,0x05).

    Runs the self test of the device and gets its result.

    Response: `BuiltInTestResponse`. The device may take 10 s to reply. Confirmed on 3DM-CV5-10,
    3DM-CV5-15, 3DM-CV7-GNSS/INS, 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15, 3DM-RQ1-45-LT and
    3DM-RQ1-45-ST; likely or assumed on 27 more. Uncertain: The maximum duration of 10 s is assumed;
    the manual of the 3DM-CV7 states several seconds.

    The test interrupts normal operation for up to several seconds; no data is available meanwhile.
    The device must be at rest; acceleration, rotation or vibration cause false failures. The
    continuous built-in test, if the device has it, describes a failure in more detail.

    - 3dm-gx5-15: 4.1.5 Device Built-In Test (0x01, 0x05)
    - 3dm-cv7-gnss-ins: Built in test (0x01,0x05)
    - 3dm-cv7-gnss-ins: Commanded Built-in Test
    """

    __slots__ = ()

    SET = 0x01
    DESCRIPTOR = 0x05
    NAME = "base.built_in_test"
    RESPONSES = (BuiltInTestResponse,)
    TIMEOUT = 10.0


class Resume(Command[None]):
    """Resume (0x01,0x06).

    Ends idle mode and returns the device to the mode that it was in before.

    Supported by all devices; confirmed on 3DM-CV5-10, 3DM-CV5-15, 3DM-CV7-GNSS/INS, 3DM-CX5-10,
    3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.

    If the device was not idle, it enters its default mode (3DM-GX5-15).

    - 3dm-gx5-15: 4.1.6 Resume (0x01, 0x06)
    - 3dm-cv7-gnss-ins: Resume (0x01,0x06)
    """

    __slots__ = ()

    SET = 0x01
    DESCRIPTOR = 0x06
    NAME = "base.resume"


class GetExtendedDescriptors(Command[GetExtendedDescriptorsResponse]):
    """Get device descriptors (extended) (0x01,0x07).

    Gets the supported descriptors that did not fit into the reply of `GetDeviceDescriptors`.

    Response: `GetExtendedDescriptorsResponse`. Confirmed on 3DM-CV5-15, 3DM-CV7-AHRS, 3DM-CV7-AR,
    3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS, 3DM-GX5-15, 3DM-GX5-35 and 3DM-GX5-45; likely or assumed on
    12 more.

    Some devices lack this command; `GetDeviceDescriptors` lists it if the device has it.

    - 3dm-gx5-15: 4.1.7 Get Extended Device Descriptor Sets (0x01, 0x07)
    - 3dm-cv7-gnss-ins: Get device descriptors (extended) (0x01,0x07)
    """

    __slots__ = ()

    SET = 0x01
    DESCRIPTOR = 0x07
    NAME = "base.get_extended_descriptors"
    RESPONSES = (GetExtendedDescriptorsResponse,)


class ContinuousBuiltInTest(Command[ContinuousBuiltInTestResponse]):
    """Continuous built-in test (0x01,0x08).

    Gets the flags of the tests that run all the time. It does not interrupt operation.

    Also called `continuous_bit`. Response: `ContinuousBuiltInTestResponse`. Confirmed on 3DM-CV7-AR
    and 3DM-CV7-GNSS/INS; likely or assumed on 9 more.

    It is less thorough than `BuiltInTest`. Each flag stays set until this command reports it; the
    streamed field has its own copy of the flags. The self-test flags change only when `BuiltInTest`
    runs.

    - 3dm-cv7-gnss-ins: Continuous built-in test (0x01,0x08)
    """

    __slots__ = ()

    SET = 0x01
    DESCRIPTOR = 0x08
    NAME = "base.continuous_built_in_test"
    RESPONSES = (ContinuousBuiltInTestResponse,)


class CommSpeed(Command[R]):
    """Comm port speed (0x01,0x09).

    Sets the baud rate of one communication port.

    Functions: `write`, `read`, `save`, `load` and `default`. Response: `CommSpeedResponse`. Devices
    without it may have `mip_3dm.UartBaudRate`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR,
    3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed on 8 more.

    The change takes effect once pending data is sent and received, after at most 250 ms. Send it
    alone in a packet while the device is idle, and wait 250 ms before you continue. Commands and
    data during the change may be lost, or sent at either rate.

    - 3dm-cv7-gnss-ins: Comm Port Speed (0x01,0x09)
    """

    __slots__ = ("function", "port", "baud")
    __match_args__ = ("function", "port", "baud")

    SET = 0x01
    DESCRIPTOR = 0x09
    NAME = "base.comm_speed"
    RESPONSES = (CommSpeedResponse,)
    REQUIRED = {1: 2, 2: 1, 3: 1, 4: 1, 5: 1}

    function: FunctionSelector
    """Operation on the setting."""
    port: int | None
    """Port id of the device; 0 means all ports, and is for save, load and default only.

    - On the 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-GV7-AHRS and 3DM-GV7-AR: values
      of `types.CommInterface`; only `types.CommInterface.MAIN`, `types.CommInterface.UART_1` and
      `types.CommInterface.USB_1`.
    - On the 3DM-CV7-GNSS/INS: values of `types.CommInterface`.
    - On the 3DM-CV7-INS and 3DM-CX7-INS: values of `types.CommInterface`; only
      `types.CommInterface.MAIN`, `types.CommInterface.UART_1`, `types.CommInterface.UART_2`,
      `types.CommInterface.UART_3` and `types.CommInterface.USB_1`.
    - On the 3DM-GQ7-GNSS/INS: 1 is the main port, 2 the auxiliary one.
    - On the 3DM-GV7-INS: values of `types.CommInterface`; only `types.CommInterface.MAIN`,
      `types.CommInterface.UART_1`, `types.CommInterface.UART_2` and `types.CommInterface.USB_1`.
    - On the 3DM-RTK: the values are unknown.
    """
    baud: int | None
    """New baud rate; the port must support it. Unit: Bd. Required for `write`."""

    def __init__(
        self, function: FunctionSelector, port: int | None = None, baud: int | None = None
    ) -> None:
        self.function = function
        self.port = port
        self.baud = baud

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 1, 5))
        self.port = _B.read(raw, at)[0] if there >= 1 else None
        self.baud = _I.read(raw, at + 1)[0] if there >= 2 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self, self.REQUIRED.get(self.function, 0), (1, "port"), (2, "baud")
        )
        out += _B.write("port", self.port) if there >= 1 else b""
        out += _I.write("baud", self.baud) if there >= 2 else b""
        return codec.finished(out)

    @classmethod
    def write(cls: ClassOf[CommSpeed[Any]], port: int, baud: int) -> CommSpeed[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, port=port, baud=baud)

    @classmethod
    def read(cls: ClassOf[CommSpeed[Any]], port: int) -> CommSpeed[CommSpeedResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ, port=port)

    @classmethod
    def save(cls: ClassOf[CommSpeed[Any]], port: int) -> CommSpeed[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE, port=port)

    @classmethod
    def load(cls: ClassOf[CommSpeed[Any]], port: int) -> CommSpeed[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD, port=port)

    @classmethod
    def default(cls: ClassOf[CommSpeed[Any]], port: int) -> CommSpeed[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT, port=port)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (CommSpeedResponse,)
        return ()


class GpsTimeUpdate(Command[R]):
    """GPS time update (0x01,0x72).

    Sets the week number or the time of week of the external (GPS) time.

    Functions: `write`, `read` and `apply`. Response: `GpsTimeUpdateWeekNumberResponse` or
    `GpsTimeUpdateTowResponse`. Affects `filter_data.Timestamp`, `sensor.GpsTimestamp`,
    `shared.GpsTimestamp` and `shared.ExternalTimestamp`. Confirmed on 3DM-CV5-10, 3DM-CV5-15,
    3DM-CV7-GNSS/INS, 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15 and 3DM-GX5-35; likely or assumed on 16
    more. On the 3DM-CV7-GNSS/INS: `write` only.

    Send it once for the time of week and once for the week number after the PPS is locked. On the
    3DM-CV7-GNSS/INS, the time may have a different epoch from GPS time, for example the Unix epoch;
    `shared.ExternalTimestamp` then has the same epoch. The PPS supplies the fraction of the second;
    send the whole second that began at its last edge. Send it within 250 ms after the rising edge
    of the PPS. Once per second is recommended for the 3DM-GX5-15; the 3DM-CV7-GNSS/INS needs it at
    least once. Send it again after a PPS glitch. It is usually not needed if an internal GNSS
    receiver is the PPS source.

    - 3dm-gx5-15: 4.1.8 GPS Time Update (0x01, 0x72)
    - 3dm-cv7-gnss-ins: GPS Time Update Command (0x01,0x72)
    - 3dm-cv7-gnss-ins: Timestamps
    """

    __slots__ = ("function", "field_id", "value")
    __match_args__ = ("function", "field_id", "value")

    SET = 0x01
    DESCRIPTOR = 0x72
    NAME = "base.gps_time_update"
    RESPONSES = (GpsTimeUpdateWeekNumberResponse, GpsTimeUpdateTowResponse)
    REQUIRED = {1: 2, 2: 1, 6: 2}

    function: FunctionSelector
    """Operation on the setting."""
    field_id: GpsTimeField | None
    """Meaning of the value."""
    value: int | None
    """Week or seconds, as selected by `field_id`. Required for `write` and `apply`.

    - If `field_id` is `GpsTimeField.WEEK_NUMBER`: unit week. GPS week number since 6 January 1980.
    - If `field_id` is `GpsTimeField.TOW`: unit s. Whole seconds of the GPS week.
    """

    def __init__(
        self,
        function: FunctionSelector,
        field_id: GpsTimeField | None = None,
        value: int | None = None,
    ) -> None:
        self.function = function
        self.field_id = field_id
        self.value = value

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 1, 5))
        self.field_id = codec.KNOWN[GpsTimeField][_B.read(raw, at)[0]] if there >= 1 else None
        self.value = _I.read(raw, at + 1)[0] if there >= 2 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self, self.REQUIRED.get(self.function, 0), (1, "field_id"), (2, "value")
        )
        out += _B.write("field_id", self.field_id) if there >= 1 else b""
        out += _I.write("value", self.value) if there >= 2 else b""
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[GpsTimeUpdate[Any]], field_id: GpsTimeField, value: int
    ) -> GpsTimeUpdate[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, field_id=field_id, value=value)

    @classmethod
    def read(
        cls: ClassOf[GpsTimeUpdate[Any]], field_id: GpsTimeField
    ) -> GpsTimeUpdate[GpsTimeUpdateWeekNumberResponse | GpsTimeUpdateTowResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ, field_id=field_id)

    @classmethod
    def apply(
        cls: ClassOf[GpsTimeUpdate[Any]], field_id: GpsTimeField, value: int
    ) -> GpsTimeUpdate[None]:
        """Apply the new setting without sending an ACK (5-series devices)."""
        return cls(FunctionSelector.APPLY, field_id=field_id, value=value)

    @property
    def answered(self) -> bool:
        return self.function != FunctionSelector.APPLY

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ and self.field_id == 1:
            return (GpsTimeUpdateWeekNumberResponse,)
        if self.function == FunctionSelector.READ and self.field_id == 2:
            return (GpsTimeUpdateTowResponse,)
        return ()


class SoftReset(Command[None]):
    """Reset device (0x01,0x7E).

    Acknowledges the command, then resets the device immediately.

    Confirmed on 3DM-CV5-10, 3DM-CV5-15, 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-CX5-10,
    3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 18
    more.

    - 3dm-gx5-15: 4.1.9 Device Reset (0x01, 0x7E)
    - 3dm-cv7-gnss-ins: Reset device (0x01,0x7E)
    """

    __slots__ = ()

    SET = 0x01
    DESCRIPTOR = 0x7E
    NAME = "base.soft_reset"


GetDeviceInfoResponse.COMMANDS = (GetDeviceInfo,)
GetDeviceDescriptorsResponse.COMMANDS = (GetDeviceDescriptors,)
BuiltInTestResponse.COMMANDS = (BuiltInTest,)
GpsTimeUpdateWeekNumberResponse.COMMANDS = (GpsTimeUpdate,)
GpsTimeUpdateTowResponse.COMMANDS = (GpsTimeUpdate,)
GetExtendedDescriptorsResponse.COMMANDS = (GetExtendedDescriptors,)
ContinuousBuiltInTestResponse.COMMANDS = (ContinuousBuiltInTest,)
CommSpeedResponse.COMMANDS = (CommSpeed,)

#: Descriptor -> its types; several if constants or the size of the data distinguish layouts.
FIELDS: dict[int, tuple[type[Field], ...]] = {
    0x01: (Ping,),
    0x02: (SetIdle,),
    0x03: (GetDeviceInfo,),
    0x04: (GetDeviceDescriptors,),
    0x05: (BuiltInTest,),
    0x06: (Resume,),
    0x07: (GetExtendedDescriptors,),
    0x08: (ContinuousBuiltInTest,),
    0x09: (CommSpeed,),
    0x72: (GpsTimeUpdate,),
    0x7E: (SoftReset,),
    0x81: (GetDeviceInfoResponse,),
    0x82: (GetDeviceDescriptorsResponse,),
    0x83: (BuiltInTestResponse,),
    0x84: (GpsTimeUpdateWeekNumberResponse,),
    0x85: (GpsTimeUpdateTowResponse,),
    0x86: (GetExtendedDescriptorsResponse,),
    0x88: (ContinuousBuiltInTestResponse,),
    0x89: (CommSpeedResponse,),
}
