"""External GNSS data (0x94).

What an external GNSS receiver tells the device by NMEA sentences. A field may need several
sentences; a value that NMEA does not give is not valid. Times are those of the sentences.
"""

from __future__ import annotations

from .field import Field
from .gnss_1 import FixInfo, GnssLlhPosition, NedVelocity, SatelliteStatus, UtcTime

#: The types of each descriptor; several where constants in the data tell layouts apart.
FIELDS: dict[int, tuple[type[Field], ...]] = {
    0x03: (GnssLlhPosition,),
    0x05: (NedVelocity,),
    0x08: (UtcTime,),
    0x0B: (FixInfo,),
    0x20: (SatelliteStatus,),
}
