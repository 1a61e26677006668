"""Displacement commands (0x11).

Commands of the DEMOD-DC, a demodulator for displacement sensors. Inertial sensors do not support
them.

- mscl: Displacement Commands (0x11)
"""

from __future__ import annotations

from typing import Any

from . import codec
from .field import Command, Field, Response, ResponseClasses
from .protocol import FunctionSelector

# Numbers that are read and written together, by their letters for `struct`.
_2f = codec.Block("2f")

_B = codec.Block("B")

_I = codec.Block("I")

_Q = codec.Block("Q")


class GetCalibrationResponse(Response):
    """Get analog to displacement calibration response (0x11,0x81).

    No device is known for certain to support it. Also called
    `get_analog_displacement_calibration_response`. Response to `GetCalibration`. Known only from
    the MicroStrain Communication Library.

    - mscl: Get analog to displacement calibration (0x11,0x01)
    """

    __slots__ = ("slope", "offset")
    __match_args__ = ("slope", "offset")

    SET = 0x11
    DESCRIPTOR = 0x81
    NAME = "displacement.get_calibration_response"
    _SIZE = 8

    slope: float
    """Displacement per ADC count. Uncertain: No source states the unit; mm per count is likely."""
    offset: float
    """Displacement at zero counts. Uncertain: No source states the unit; mm is likely."""

    def __init__(self, slope: float, offset: float) -> None:
        self.slope = slope
        self.offset = offset

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2f.unpack(raw, at)
        if (total := v[0] + v[1]) != total:
            v = _2f.keep_nan_bits(v, raw, at)
        self.slope, self.offset = v
        return at + 8

    def _write(self) -> bytes:
        return _2f.write("slope offset", self.slope, self.offset)


class OutputRateResponse(Response):
    """Displacement output data rate response (0x11,0x82).

    No device is known for certain to support it. Also called `displacement_output_rate_response`.
    Response to `OutputRate`. Known only from the MicroStrain Communication Library.

    - mscl: Displacement output data rate (0x11,0x02)
    """

    __slots__ = ("rate",)
    __match_args__ = ("rate",)

    SET = 0x11
    DESCRIPTOR = 0x82
    NAME = "displacement.output_rate_response"
    _SIZE = 4

    rate: int
    """Rate of displacement data. Unit: Hz."""

    def __init__(self, rate: int) -> None:
        self.rate = rate

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.rate = _I.unpack(raw, at)[0]
        return at + 4

    def _write(self) -> bytes:
        return _I.write("rate", self.rate)


class GetCalibration(Command[GetCalibrationResponse]):
    """Get analog to displacement calibration (0x11,0x01).

    Reads the slope and offset with which the device converts ADC counts to displacement.

    No device is known for certain to support it. Also called `get_analog_displacement_calibration`.
    Response: `GetCalibrationResponse`. Known only from the MicroStrain Communication Library.

    - mscl: Get analog to displacement calibration (0x11,0x01)
    """

    __slots__ = ()

    SET = 0x11
    DESCRIPTOR = 0x01
    NAME = "displacement.get_calibration"
    RESPONSES = (GetCalibrationResponse,)


class OutputRate(Command[OutputRateResponse]):
    """Displacement output data rate (0x11,0x02).

    Reads the rate at which displacement is measured.

    No device is known for certain to support it. Also called `displacement_output_rate`. Functions:
    `read`. Response: `OutputRateResponse`. Known only from the MicroStrain Communication Library.
    Uncertain: MSCL only reads the rate; a write may not be supported.

    - mscl: Displacement output data rate (0x11,0x02)
    """

    __slots__ = ("function",)
    __match_args__ = ("function",)

    SET = 0x11
    DESCRIPTOR = 0x02
    NAME = "displacement.output_rate"
    RESPONSES = (OutputRateResponse,)
    REQUIRED = {2: 0}
    _SIZE = 1

    function: FunctionSelector
    """Operation on the setting."""

    def __init__(self, function: FunctionSelector) -> None:
        self.function = function

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.unpack(raw, at)[0]]
        return at + 1

    def _write(self) -> bytes:
        return _B.write("function", self.function)

    @classmethod
    def read(cls) -> OutputRate:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (OutputRateResponse,)
        return ()


class DeviceTime(Command[None]):
    """Displacement device time (0x11,0x04).

    Sets the clock of the device, from which `displacement_data.Timestamp` is taken.

    No device is known for certain to support it. Also called `displacement_device_time`. Functions:
    `write`. Affects `displacement_data.Timestamp`. Known only from the MicroStrain Communication
    Library. Uncertain: MSCL only writes the time; a read may not be supported.

    - mscl: Displacement device time (0x11,0x04)
    """

    __slots__ = ("function", "time")
    __match_args__ = ("function", "time")

    SET = 0x11
    DESCRIPTOR = 0x04
    NAME = "displacement.device_time"
    REQUIRED = {1: 1}

    function: FunctionSelector
    """Operation on the setting."""
    time: int | None
    """UTC since 1970-01-01, without leap seconds. Unit: ns."""

    def __init__(self, function: FunctionSelector, time: int | None = None) -> None:
        self.function = function
        self.time = time

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 8))
        self.time = _Q.read(raw, at)[0] if there >= 1 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(self, self.REQUIRED.get(self.function, 0), (1, "time"))
        out += _Q.write("time", self.time) if there >= 1 else b""
        return codec.finished(out)

    @classmethod
    def write(cls, time: int) -> DeviceTime:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, time=time)


GetCalibrationResponse.COMMANDS = (GetCalibration,)
OutputRateResponse.COMMANDS = (OutputRate,)

#: Descriptor -> its types; several if constants or the size of the data distinguish layouts.
FIELDS: dict[int, tuple[type[Field], ...]] = {
    0x01: (GetCalibration,),
    0x02: (OutputRate,),
    0x04: (DeviceTime,),
    0x81: (GetCalibrationResponse,),
    0x82: (OutputRateResponse,),
}
