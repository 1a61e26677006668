"""GNSS receiver 2 data (0x92).

Measurements and status of the second internal GNSS receiver.
"""

from __future__ import annotations

from .field import Field
from .gnss_1 import (
    BeidouEphemeris,
    ClockInfo2,
    Dop,
    FixInfo,
    GalileoEphemeris,
    GlonassEphemeris,
    GnssEcefPosition,
    GnssEcefVelocity,
    GnssHardwareStatus,
    GnssLlhPosition,
    GpsEphemeris,
    GpsLeapSeconds,
    GpsTime,
    NedVelocity,
    Raw,
    SatelliteStatus,
    SbasInfo,
    UtcTime,
)

#: The types of each descriptor; several where constants in the data tell layouts apart.
FIELDS: dict[int, tuple[type[Field], ...]] = {
    0x03: (GnssLlhPosition,),
    0x04: (GnssEcefPosition,),
    0x05: (NedVelocity,),
    0x06: (GnssEcefVelocity,),
    0x07: (Dop,),
    0x08: (UtcTime,),
    0x09: (GpsTime,),
    0x0B: (FixInfo,),
    0x0D: (GnssHardwareStatus,),
    0x10: (ClockInfo2,),
    0x11: (GpsLeapSeconds,),
    0x12: (SbasInfo,),
    0x20: (SatelliteStatus,),
    0x22: (Raw,),
    0x61: (GpsEphemeris,),
    0x62: (GlonassEphemeris,),
    0x63: (GalileoEphemeris,),
    0x64: (BeidouEphemeris,),
}
