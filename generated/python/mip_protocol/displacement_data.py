"""Displacement data (0x90).

Measurements of the DEMOD-DC, a digital demodulator for displacement sensors.

- mscl: Displacement Data (0x90)
"""

from __future__ import annotations

from enum import IntFlag
from typing import Any

from . import codec
from .field import Data, Field

# Numbers that are read and written together, by their letters for `struct`.
_BQ = codec.Block("BQ")

_I = codec.Block("I")

_f = codec.Block("f")


@codec.open_flag(8)
class TimestampFlags(IntFlag):
    """Validity of the displacement timestamp. Uncertain: The number is possibly no bitfield,
    because MSCL considers the time valid if it is 1.
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
    DESCRIPTOR = 0x01
    NAME = "displacement_data.displacement_raw"
    _SIZE = 4

    counts: int
    """Output of the analog-to-digital converter. Unit: 1."""

    def __init__(self, counts: int) -> None:
        self.counts = counts

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.counts = _I.unpack(raw, at)[0]
        return at + 4

    def _write(self) -> bytes:
        return _I.write("counts", self.counts)


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
    DESCRIPTOR = 0x02
    NAME = "displacement_data.displacement"
    _SIZE = 4

    displacement: float
    """Position of the sensor along its axis. Unit: mm."""

    def __init__(self, displacement: float) -> None:
        self.displacement = displacement

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _f.unpack(raw, at)
        if v[0] != v[0]:
            v = _f.keep_nan_bits(v, raw, at)
        self.displacement = v[0]
        return at + 4

    def _write(self) -> bytes:
        return _f.write("displacement", self.displacement)


class Timestamp(Data):
    """Displacement device timestamp (0x90,0x04).

    Time of the measurement by the clock of the device.

    No device is known for certain to support it. Also called `displacement_timestamp`. Known only
    from the MicroStrain Communication Library.

    - mscl: Displacement device timestamp (0x90,0x04)
    """

    __slots__ = ("flags", "time")
    __match_args__ = ("flags", "time")

    SET = 0x90
    DESCRIPTOR = 0x04
    NAME = "displacement_data.timestamp"
    _SIZE = 9

    flags: TimestampFlags
    """Validity of the displacement timestamp."""
    time: int
    """UTC since 1970-01-01, without leap seconds, if the clock was set to it. Unit: ns. Valid if
    `TimestampFlags.TIME` of `flags` is set.
    """

    def __init__(self, flags: TimestampFlags, time: int) -> None:
        self.flags = flags
        self.time = time

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _BQ.unpack(raw, at)
        self.flags = codec.KNOWN[TimestampFlags][v[0]]
        self.time = v[1]
        return at + 9

    def _write(self) -> bytes:
        return _BQ.write("flags time", self.flags, self.time)


#: Descriptor -> its types; several if constants or the size of the data distinguish layouts.
FIELDS: dict[int, tuple[type[Field], ...]] = {
    0x01: (DisplacementRaw,),
    0x02: (Displacement,),
    0x04: (Timestamp,),
}
