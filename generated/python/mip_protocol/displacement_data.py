"""Displacement data (0x90).

Measurements of the DEMOD-DC, a digital demodulator for displacement sensors.

- mscl: Displacement Data (0x90)
"""

from __future__ import annotations

from . import codec
from .field import Data, Field

_DISPLACEMENT_RAW_0 = codec.Block("I", "counts")


class DisplacementRaw(Data):
    """Raw displacement (0x90,0x01).

    Displacement in counts of the converter.

    Not listed in any device profile. Known only from the MicroStrain Communication Library.

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
    """Displacement in counts. Unit: 1."""

    def __init__(self, counts: int) -> None:
        self.counts = counts

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[DisplacementRaw, int]:
        v = _DISPLACEMENT_RAW_0.read(raw, at)
        at += 4
        counts = v[0]
        return cls(counts), at

    def _write(self) -> bytes:
        out = _DISPLACEMENT_RAW_0.write(self.counts)
        return codec.finished(out)


_DISPLACEMENT_0 = codec.Block("f", "displacement")


class Displacement(Data):
    """Displacement (0x90,0x02).

    Calibrated displacement of the sensor.

    Not listed in any device profile. Known only from the MicroStrain Communication Library.

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
    """Displacement. Unit: mm."""

    def __init__(self, displacement: float) -> None:
        self.displacement = displacement

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[Displacement, int]:
        v = _DISPLACEMENT_0.read(raw, at)
        at += 4
        displacement = v[0]
        return cls(displacement), at

    def _write(self) -> bytes:
        out = _DISPLACEMENT_0.write(self.displacement)
        return codec.finished(out)


#: The types of each descriptor; several if constants or the size of the data distinguish layouts.
FIELDS: dict[int, tuple[type[Field], ...]] = {0x01: (DisplacementRaw,), 0x02: (Displacement,)}
