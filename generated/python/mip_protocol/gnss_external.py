"""External GNSS data (0x94).

What an external GNSS receiver tells the device by NMEA sentences. A field may need several
sentences; a value that NMEA does not give is not valid. Times are those of the sentences.
"""

from __future__ import annotations

from . import gnss_1
from .field import Field


class GnssLlhPosition(gnss_1.GnssLlhPosition):
    """GNSS LLH position (0x94,0x03).

    Has the values of gnss_1.GnssLlhPosition.
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: GNSS LLH Position (0x94,0x03)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.gnss_llh_position"


class GnssEcefPosition(gnss_1.GnssEcefPosition):
    """GNSS ECEF position (0x94,0x04).

    Has the values of gnss_1.GnssEcefPosition.

    - mip-sdk-4: Gnss4 Data (0x94)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.gnss_ecef_position"


class NedVelocity(gnss_1.NedVelocity):
    """NED velocity (0x94,0x05).

    Has the values of gnss_1.NedVelocity.
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: NED Velocity (0x94,0x05)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.ned_velocity"


class GnssEcefVelocity(gnss_1.GnssEcefVelocity):
    """GNSS ECEF velocity (0x94,0x06).

    Has the values of gnss_1.GnssEcefVelocity.

    - mip-sdk-4: Gnss4 Data (0x94)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.gnss_ecef_velocity"


class Dop(gnss_1.Dop):
    """DOP (0x94,0x07).

    Has the values of gnss_1.Dop.

    - mip-sdk-4: Gnss4 Data (0x94)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.dop"


class UtcTime(gnss_1.UtcTime):
    """UTC time (0x94,0x08).

    Has the values of gnss_1.UtcTime.
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: UTC Time (0x94,0x08)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.utc_time"


class GpsTime(gnss_1.GpsTime):
    """GPS time (0x94,0x09).

    Has the values of gnss_1.GpsTime.

    - mip-sdk-4: Gnss4 Data (0x94)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.gps_time"


class ClockInfo(gnss_1.ClockInfo):
    """Clock info (0x94,0x0A).

    Has the values of gnss_1.ClockInfo.

    - mip-sdk-4: Gnss4 Data (0x94)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.clock_info"


class FixInfo(gnss_1.FixInfo):
    """Fix info (0x94,0x0B).

    Has the values of gnss_1.FixInfo.
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Fix Info (0x94,0x0B)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.fix_info"


class SvInfo(gnss_1.SvInfo):
    """Satellite info (0x94,0x0C).

    Has the values of gnss_1.SvInfo.

    - mip-sdk-4: Gnss4 Data (0x94)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.sv_info"


class GnssHardwareStatus(gnss_1.GnssHardwareStatus):
    """GNSS hardware status (0x94,0x0D).

    Has the values of gnss_1.GnssHardwareStatus.

    - mip-sdk-4: Gnss4 Data (0x94)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.gnss_hardware_status"


class DgpsInfo(gnss_1.DgpsInfo):
    """DGPS info (0x94,0x0E).

    Has the values of gnss_1.DgpsInfo.

    - mip-sdk-4: Gnss4 Data (0x94)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.dgps_info"


class DgpsChannel(gnss_1.DgpsChannel):
    """DGPS channel (0x94,0x0F).

    Has the values of gnss_1.DgpsChannel.

    - mip-sdk-4: Gnss4 Data (0x94)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.dgps_channel"


class ClockInfo2(gnss_1.ClockInfo2):
    """Clock info 2 (0x94,0x10).

    Has the values of gnss_1.ClockInfo2.

    - mip-sdk-4: Gnss4 Data (0x94)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.clock_info_2"


class GpsLeapSeconds(gnss_1.GpsLeapSeconds):
    """GPS leap seconds (0x94,0x11).

    Has the values of gnss_1.GpsLeapSeconds.

    - mip-sdk-4: Gnss4 Data (0x94)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.gps_leap_seconds"


class SbasInfo(gnss_1.SbasInfo):
    """SBAS info (0x94,0x12).

    Has the values of gnss_1.SbasInfo.

    - mip-sdk-4: Gnss4 Data (0x94)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.sbas_info"


class SbasCorrection(gnss_1.SbasCorrection):
    """SBAS correction (0x94,0x13).

    Has the values of gnss_1.SbasCorrection.

    - mip-sdk-4: Gnss4 Data (0x94)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.sbas_correction"


class RfErrorDetection(gnss_1.RfErrorDetection):
    """RF error detection (0x94,0x14).

    Has the values of gnss_1.RfErrorDetection.

    - mip-sdk-4: Gnss4 Data (0x94)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.rf_error_detection"


class SatelliteStatus(gnss_1.SatelliteStatus):
    """Satellite status (0x94,0x20).

    Has the values of gnss_1.SatelliteStatus.
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Satellite Status (0x94,0x20)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.satellite_status"


class Raw(gnss_1.Raw):
    """Raw (0x94,0x22).

    Has the values of gnss_1.Raw.

    - mip-sdk-4: Gnss4 Data (0x94)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.raw"


class BaseStationInfo(gnss_1.BaseStationInfo):
    """Base station info (0x94,0x30).

    Has the values of gnss_1.BaseStationInfo.

    - mip-sdk-4: Gnss4 Data (0x94)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.base_station_info"


class RtkCorrectionsStatus(gnss_1.RtkCorrectionsStatus):
    """RTK corrections status (0x94,0x31).

    Has the values of gnss_1.RtkCorrectionsStatus.

    - mip-sdk-4: Gnss4 Data (0x94)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.rtk_corrections_status"


class GpsEphemeris(gnss_1.GpsEphemeris):
    """GPS ephemeris (0x94,0x61).

    Has the values of gnss_1.GpsEphemeris.

    - mip-sdk-4: Gnss4 Data (0x94)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.gps_ephemeris"


class GlonassEphemeris(gnss_1.GlonassEphemeris):
    """GLONASS ephemeris (0x94,0x62).

    Has the values of gnss_1.GlonassEphemeris.

    - mip-sdk-4: Gnss4 Data (0x94)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.glonass_ephemeris"


class GalileoEphemeris(gnss_1.GalileoEphemeris):
    """Galileo ephemeris (0x94,0x63).

    Has the values of gnss_1.GalileoEphemeris.

    - mip-sdk-4: Gnss4 Data (0x94)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.galileo_ephemeris"


class BeidouEphemeris(gnss_1.BeidouEphemeris):
    """BeiDou ephemeris (0x94,0x64).

    Has the values of gnss_1.BeidouEphemeris.

    - mip-sdk-4: Gnss4 Data (0x94)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.beidou_ephemeris"


class GpsIonoCorrection(gnss_1.GpsIonoCorrection):
    """GPS ionospheric correction (0x94,0x71).

    Has the values of gnss_1.GpsIonoCorrection.

    - mip-sdk-4: Gnss4 Data (0x94)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.gps_iono_correction"


class GalileoIonoCorrection(gnss_1.GalileoIonoCorrection):
    """Galileo ionospheric correction (0x94,0x73).

    Has the values of gnss_1.GalileoIonoCorrection.

    - mip-sdk-4: Gnss4 Data (0x94)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.galileo_iono_correction"


class BeidouIonoCorrection(gnss_1.BeidouIonoCorrection):
    """BeiDou ionospheric correction (0x94,0x74).

    Has the values of gnss_1.BeidouIonoCorrection.

    - mip-sdk-4: Gnss4 Data (0x94)
    """

    __slots__ = ()

    SET = 0x94
    NAME = "gnss_external.beidou_iono_correction"


#: The types of each descriptor; several where constants in the data tell layouts apart.
FIELDS: dict[int, tuple[type[Field], ...]] = {
    0x03: (GnssLlhPosition,),
    0x04: (GnssEcefPosition,),
    0x05: (NedVelocity,),
    0x06: (GnssEcefVelocity,),
    0x07: (Dop,),
    0x08: (UtcTime,),
    0x09: (GpsTime,),
    0x0A: (ClockInfo,),
    0x0B: (FixInfo,),
    0x0C: (SvInfo,),
    0x0D: (GnssHardwareStatus,),
    0x0E: (DgpsInfo,),
    0x0F: (DgpsChannel,),
    0x10: (ClockInfo2,),
    0x11: (GpsLeapSeconds,),
    0x12: (SbasInfo,),
    0x13: (SbasCorrection,),
    0x14: (RfErrorDetection,),
    0x20: (SatelliteStatus,),
    0x22: (Raw,),
    0x30: (BaseStationInfo,),
    0x31: (RtkCorrectionsStatus,),
    0x61: (GpsEphemeris,),
    0x62: (GlonassEphemeris,),
    0x63: (GalileoEphemeris,),
    0x64: (BeidouEphemeris,),
    0x71: (GpsIonoCorrection,),
    0x73: (GalileoIonoCorrection,),
    0x74: (BeidouIonoCorrection,),
}
