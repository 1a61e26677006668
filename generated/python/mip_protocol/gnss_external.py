"""External GNSS data (0x94).

What an external GNSS receiver tells the device by NMEA sentences. A field may need several
sentences; a value that NMEA does not give is not valid. Times are those of the sentences.

- 3dm-cv7-gnss-ins: GNSS External (0x94)
- 3dm-cv7-gnss-ins: NMEA Input
"""

from __future__ import annotations

from . import gnss_1
from .field import Field


class GnssLlhPosition(gnss_1.GnssLlhPosition):
    """GNSS LLH position (0x94,0x03).

    GNSS position as latitude, longitude and height.

    Has the layout of `gnss_1.GnssLlhPosition`. Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: GNSS LLH Position (0x94,0x03)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.gnss_llh_position"


class NedVelocity(gnss_1.NedVelocity):
    """NED velocity (0x94,0x05).

    GNSS velocity in the local level frame.

    Has the layout of `gnss_1.NedVelocity`. Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: NED Velocity (0x94,0x05)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.ned_velocity"


class UtcTime(gnss_1.UtcTime):
    """UTC time (0x94,0x08).

    Coordinated universal time as the receiver knows it.

    Has the layout of `gnss_1.UtcTime`. Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: UTC Time (0x94,0x08)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.utc_time"


class FixInfo(gnss_1.FixInfo):
    """Fix info (0x94,0x0B).

    Type of the position fix and what it is made of.

    Has the layout of `gnss_1.FixInfo`. Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Fix Info (0x94,0x0B)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.fix_info"


class SatelliteStatus(gnss_1.SatelliteStatus):
    """Satellite status (0x94,0x20).

    Where one satellite stands, and its health.

    Has the layout of `gnss_1.SatelliteStatus`. Supported by 3DM-CV7-GNSS/INS.

    An epoch is sent as one field for each satellite; index and count number the fields.

    - 3dm-cv7-gnss-ins: Satellite Status (0x94,0x20)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.satellite_status"


#: The types of each descriptor; several where constants in the data tell layouts apart.
FIELDS: dict[int, tuple[type[Field], ...]] = {
    0x03: (GnssLlhPosition,),
    0x05: (NedVelocity,),
    0x08: (UtcTime,),
    0x0B: (FixInfo,),
    0x20: (SatelliteStatus,),
}
