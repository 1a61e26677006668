"""Displacement data (0x90).

Measurements of the DEMOD-DC, a digital demodulator for displacement sensors.

- mscl: Displacement Data (0x90)
"""

from __future__ import annotations

from enum import IntFlag

from . import codec
from .field import Data, Field


@codec.open_flag(8)
class TimestampFlags(IntFlag):
    """Validity of the displacement timestamp. Uncertain: That it is a bitfield. MSCL considers the
    time valid if the number is 1.
    """

    TIME = 1 << 0
    """The clock has been set; `time` is valid. Bit 0."""


class DisplacementRaw(Data):
    """Raw displacement (0x90,0x01).

    Displacement in ADC counts.

    No device is known for certain to support it. Known only from the MicroStrain Communication
    Library.

    - mscl: Raw displacement (0x90,0x01)
    """

    __slots__ = ("counts",)
    __match_args__ = ("counts",)

    SET = 0x90
    SETS = (0x90,)
    DESCRIPTOR = 0x01
    NAME = "displacement_data.displacement_raw"
    ROLE = "data"
    _LAYOUT = (("counts", "I", None),)

    counts: int
    """Output of the analog-to-digital converter. Unit: 1."""

    def __init__(self, counts: int) -> None:
        self.counts = counts


class Displacement(Data):
    """Displacement (0x90,0x02).

    Displacement of the sensor, computed with its calibration.

    No device is known for certain to support it. Known only from the MicroStrain Communication
    Library.

    - mscl: Displacement (0x90,0x02)
    """

    __slots__ = ("displacement",)
    __match_args__ = ("displacement",)

    SET = 0x90
    SETS = (0x90,)
    DESCRIPTOR = 0x02
    NAME = "displacement_data.displacement"
    ROLE = "data"
    _LAYOUT = (("displacement", "f", None),)

    displacement: float
    """Position of the sensor along its axis. Unit: mm."""

    def __init__(self, displacement: float) -> None:
        self.displacement = displacement


class Timestamp(Data):
    """Displacement Device Timestamp (0x90,0x04).

    Time of the measurement by the clock of the device.

    No device is known for certain to support it. Also called `displacement_timestamp`. Known only
    from the MicroStrain Communication Library.

    - mscl: Displacement Device Timestamp (0x90,0x04)
    """

    __slots__ = ("flags", "time")
    __match_args__ = ("flags", "time")

    SET = 0x90
    SETS = (0x90,)
    DESCRIPTOR = 0x04
    NAME = "displacement_data.timestamp"
    ROLE = "data"
    _LAYOUT = (("flags", "B", TimestampFlags), ("time", "Q", None))

    flags: TimestampFlags
    """Validity of the displacement timestamp."""
    time: int
    """UTC since 1970-01-01, without leap seconds, if the clock was set to it. Unit: ns. Valid if
    `TimestampFlags.TIME` of `flags` is set.
    """

    def __init__(self, flags: TimestampFlags, time: int) -> None:
        self.flags = flags
        self.time = time


#: Descriptor -> its types; several if constants or the size of the data distinguish layouts.
FIELDS: dict[int, tuple[type[Field], ...]] = {
    0x01: (DisplacementRaw,),
    0x02: (Displacement,),
    0x04: (Timestamp,),
}
