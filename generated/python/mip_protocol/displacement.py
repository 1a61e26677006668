"""Displacement commands (0x11).

Commands of the DEMOD-DC, a demodulator for displacement sensors. Inertial sensors do not support
them.

- mscl: Displacement Commands (0x11)
"""

from __future__ import annotations

from .field import Command, Field, Response, ResponseClasses
from .protocol import FunctionSelector


class GetCalibrationResponse(Response):
    """Get Analog to Displacement Calibration response (0x11,0x81).

    No device is known for certain to support it. Also called
    `get_analog_displacement_calibration_response`. Response to `GetCalibration`. Known only from
    the MicroStrain Communication Library.

    - mscl: Get Analog to Displacement Calibration (0x11,0x01)
    """

    __slots__ = ("slope", "offset")
    __match_args__ = ("slope", "offset")

    SET = 0x11
    SETS = (0x11,)
    DESCRIPTOR = 0x81
    NAME = "displacement.get_calibration_response"
    ROLE = "response"
    _LAYOUT = (("slope", "f", None), ("offset", "f", None))

    slope: float
    """Displacement per ADC count. Uncertain: The unit; mm per count is likely."""
    offset: float
    """Displacement at zero counts. Uncertain: The unit; mm is likely."""

    def __init__(self, slope: float, offset: float) -> None:
        self.slope = slope
        self.offset = offset


class OutputRateResponse(Response):
    """Displacement Output Data Rate response (0x11,0x82).

    No device is known for certain to support it. Also called `displacement_output_rate_response`.
    Response to `OutputRate`. Known only from the MicroStrain Communication Library.

    - mscl: Displacement Output Data Rate (0x11,0x02)
    """

    __slots__ = ("rate",)
    __match_args__ = ("rate",)

    SET = 0x11
    SETS = (0x11,)
    DESCRIPTOR = 0x82
    NAME = "displacement.output_rate_response"
    ROLE = "response"
    _LAYOUT = (("rate", "I", None),)

    rate: int
    """Rate of displacement data. Unit: Hz."""

    def __init__(self, rate: int) -> None:
        self.rate = rate


class GetCalibration(Command[GetCalibrationResponse]):
    """Get Analog to Displacement Calibration (0x11,0x01).

    Reads the slope and offset with which the device converts ADC counts to displacement.

    No device is known for certain to support it. Also called `get_analog_displacement_calibration`.
    Response: `GetCalibrationResponse`. Known only from the MicroStrain Communication Library.

    - mscl: Get Analog to Displacement Calibration (0x11,0x01)
    """

    __slots__ = ()

    SET = 0x11
    SETS = (0x11,)
    DESCRIPTOR = 0x01
    NAME = "displacement.get_calibration"
    ROLE = "command"
    RESPONSES = (GetCalibrationResponse,)


class OutputRate(Command[OutputRateResponse]):
    """Displacement Output Data Rate (0x11,0x02).

    Reads the rate at which displacement is measured.

    No device is known for certain to support it. Also called `displacement_output_rate`. Functions:
    `read`. Response: `OutputRateResponse`. Known only from the MicroStrain Communication Library.
    Uncertain: Whether the rate can be written. MSCL only reads it.

    - mscl: Displacement Output Data Rate (0x11,0x02)
    """

    __slots__ = ("function",)
    __match_args__ = ("function",)

    SET = 0x11
    SETS = (0x11,)
    DESCRIPTOR = 0x02
    NAME = "displacement.output_rate"
    ROLE = "command"
    RESPONSES = (OutputRateResponse,)
    REQUIRED = {2: 0}
    _LAYOUT = (("function", "B", FunctionSelector),)

    function: FunctionSelector
    """Operation on the setting."""

    def __init__(self, function: FunctionSelector) -> None:
        self.function = function

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
    """Displacement Device Time (0x11,0x04).

    Sets the clock of the device, from which `displacement_data.Timestamp` is taken.

    No device is known for certain to support it. Also called `displacement_device_time`. Functions:
    `write`. Changes `displacement_data.Timestamp`. Known only from the MicroStrain Communication
    Library. Uncertain: Whether the time can be read. MSCL only writes it.

    - mscl: Displacement Device Time (0x11,0x04)
    """

    __slots__ = ("function", "time")
    __match_args__ = ("function", "time")

    SET = 0x11
    SETS = (0x11,)
    DESCRIPTOR = 0x04
    NAME = "displacement.device_time"
    ROLE = "command"
    REQUIRED = {1: 1}
    _LAYOUT = (("function", "B", FunctionSelector), ("time", "Q", None))
    _ALWAYS = 1

    function: FunctionSelector
    """Operation on the setting."""
    time: int | None
    """UTC since 1970-01-01, without leap seconds. Unit: ns."""

    def __init__(self, function: FunctionSelector, time: int | None = None) -> None:
        self.function = function
        self.time = time

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
