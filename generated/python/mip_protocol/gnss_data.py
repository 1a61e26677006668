"""GNSS data (0x81).

Measurements and status of the GNSS receiver of 4-series and 5-series devices.

Uncertain: Which devices send the fields that no manual lists for this set. The SDK gives all GNSS
data sets the same fields.

- mip-sdk-4: Gnss Data (0x81)
"""

from __future__ import annotations

from . import gnss_1
from .field import Field


class LlhPosition(gnss_1.LlhPosition):
    """GNSS LLH position (0x81,0x03).

    GNSS position as latitude, longitude and height.

    Has the layout of `gnss_1.LlhPosition`. Also called `pos_llh`. May be supported by 3DM-GX5-35
    and 3DM-GX5-45. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.llh_position"


class EcefPosition(gnss_1.EcefPosition):
    """GNSS ECEF position (0x81,0x04).

    GNSS position in Earth-fixed coordinates.

    Has the layout of `gnss_1.EcefPosition`. Also called `pos_ecef`. May be supported by 3DM-GX5-35
    and 3DM-GX5-45. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.ecef_position"


class NedVelocity(gnss_1.NedVelocity):
    """NED velocity (0x81,0x05).

    GNSS velocity in the local level frame.

    Has the layout of `gnss_1.NedVelocity`. Also called `vel_ned`. May be supported by 3DM-GX5-35
    and 3DM-GX5-45. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.ned_velocity"


class EcefVelocity(gnss_1.EcefVelocity):
    """GNSS ECEF velocity (0x81,0x06).

    GNSS velocity in Earth-fixed coordinates.

    Has the layout of `gnss_1.EcefVelocity`. Also called `vel_ecef`. Supported by 3DM-GX5-35. May be
    supported by 3DM-GX5-45.

    - 3dm-gx5-35: 5.2.4 ECEF Velocity (0x81, 0x06)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.ecef_velocity"


class Dop(gnss_1.Dop):
    """DOP (0x81,0x07).

    Dilution of precision of the satellite geometry.

    Has the layout of `gnss_1.Dop`. May be supported by 3DM-GX5-35 and 3DM-GX5-45. Known only from
    the MicroStrain MIP SDK.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.dop"


class UtcTime(gnss_1.UtcTime):
    """UTC time (0x81,0x08).

    Coordinated universal time as the receiver knows it.

    Has the layout of `gnss_1.UtcTime`. May be supported by 3DM-GX5-35 and 3DM-GX5-45. Known only
    from the MicroStrain MIP SDK.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.utc_time"


class GpsTime(gnss_1.GpsTime):
    """GPS time (0x81,0x09).

    GPS time as the receiver knows it.

    Has the layout of `gnss_1.GpsTime`. May be supported by 3DM-GX5-35 and 3DM-GX5-45. Known only
    from the MicroStrain MIP SDK.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.gps_time"


class ClockInfo(gnss_1.ClockInfo):
    """Clock info (0x81,0x0A).

    Bias and drift of the receiver clock.

    Has the layout of `gnss_1.ClockInfo`. May be supported by 3DM-GX5-35 and 3DM-GX5-45. Known only
    from the MicroStrain MIP SDK.

    Clock info 2 replaces it and gives more detail.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.clock_info"


class FixInfo(gnss_1.FixInfo):
    """Fix info (0x81,0x0B).

    Type of the position fix and what it is based on.

    Has the layout of `gnss_1.FixInfo`. May be supported by 3DM-GX5-35 and 3DM-GX5-45. Known only
    from the MicroStrain MIP SDK.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.fix_info"


class SvInfo(gnss_1.SvInfo):
    """Satellite info (0x81,0x0C).

    One satellite that is tracked.

    Has the layout of `gnss_1.SvInfo`. Supported by 3DM-GX5-45. May be supported by 3DM-GX5-35.
    Known only from the MicroStrain MIP SDK. Uncertain: Whether a packet holds one of these fields
    or several.

    Each satellite is sent as one field, in packets separate from other GNSS data.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.sv_info"


class HardwareStatus(gnss_1.HardwareStatus):
    """GNSS hardware status (0x81,0x0D).

    State of the receiver and of its antenna.

    Has the layout of `gnss_1.HardwareStatus`. Also called `hw_status`. Supported by 3DM-GX5-45. May
    be supported by 3DM-GX5-35. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.hardware_status"


class DgpsInfo(gnss_1.DgpsInfo):
    """DGPS info (0x81,0x0E).

    State of the differential corrections.

    Has the layout of `gnss_1.DgpsInfo`. Supported by 3DM-GX5-35 and 3DM-GX5-45. Uncertain: The
    layout is from a manual of the 3DM-GX5-35 and from MSCL, another library of the vendor. It
    agrees with the valid flags. Uncertain: The SDK has another layout: u8, three floats and u16. It
    is that of `gnss_1.DgpsChannel` and does not agree with its own valid flags (age, base station
    id, base station status, number of channels).

    - 3dm-gx5-35: 5.2.12 DGNSS Information (0x81, 0x0E)
    - mip-sdk-4: Dgps Info (0x81,0x0E)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.dgps_info"


class DgpsChannel(gnss_1.DgpsChannel):
    """DGPS channel (0x81,0x0F).

    Differential correction for one satellite.

    Has the layout of `gnss_1.DgpsChannel`. Supported by 3DM-GX5-45. May be supported by 3DM-GX5-35.
    Known only from the MicroStrain MIP SDK.

    Each active satellite is sent as one field, all in one packet.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.dgps_channel"


class ClockInfo2(gnss_1.ClockInfo2):
    """Clock info 2 (0x81,0x10).

    Bias and drift of the receiver clock.

    Has the layout of `gnss_1.ClockInfo2`. Not listed in any device profile. Known only from the
    MicroStrain MIP SDK.

    It supersedes clock info.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.clock_info_2"


class GpsLeapSeconds(gnss_1.GpsLeapSeconds):
    """GPS leap seconds (0x81,0x11).

    Difference between GPS time and UTC.

    Has the layout of `gnss_1.GpsLeapSeconds`. Not listed in any device profile. Known only from the
    MicroStrain MIP SDK.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.gps_leap_seconds"


class SbasInfo(gnss_1.SbasInfo):
    """SBAS info (0x81,0x12).

    Status of the satellite based augmentation.

    Has the layout of `gnss_1.SbasInfo`. Not listed in any device profile. Known only from the
    MicroStrain MIP SDK.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.sbas_info"


class SbasCorrection(gnss_1.SbasCorrection):
    """SBAS correction (0x81,0x13).

    SBAS correction for one satellite.

    Has the layout of `gnss_1.SbasCorrection`. Not listed in any device profile. Known only from the
    MicroStrain MIP SDK.

    An epoch is sent as one field for each satellite; `index` and `count` number the fields. For
    `udrei` 0 to 13, the variances in m^2 are 0.0520, 0.0924, 0.1444, 0.2830, 0.4678, 0.8315,
    1.2992, 1.8709, 2.5465, 3.3260, 5.1968, 20.7870, 230.9661, 2078.695.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.sbas_correction"


class RfErrorDetection(gnss_1.RfErrorDetection):
    """RF error detection (0x81,0x14).

    Jamming and spoofing that the receiver detects in one band.

    Has the layout of `gnss_1.RfErrorDetection`. Not listed in any device profile. Known only from
    the MicroStrain MIP SDK.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.rf_error_detection"


class SatelliteStatus(gnss_1.SatelliteStatus):
    """Satellite status (0x81,0x20).

    Direction to one satellite, and its health.

    Has the layout of `gnss_1.SatelliteStatus`. Not listed in any device profile. Known only from
    the MicroStrain MIP SDK.

    An epoch is sent as one field for each satellite; `index` and `count` number the fields.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.satellite_status"


class Raw(gnss_1.Raw):
    """Raw (0x81,0x22).

    Raw observation of one signal of one satellite.

    Has the layout of `gnss_1.Raw`. Not listed in any device profile. Known only from the
    MicroStrain MIP SDK.

    An epoch is sent as one field for each signal; `index` and `count` number the fields. The
    greatest lock time depends on the receiver.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.raw"


class BaseStationInfo(gnss_1.BaseStationInfo):
    """Base station info (0x81,0x30).

    The base station of the corrections, from an RTCM message 1005 or 1006.

    Has the layout of `gnss_1.BaseStationInfo`. Not listed in any device profile. Known only from
    the MicroStrain MIP SDK.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.base_station_info"


class RtkCorrectionsStatus(gnss_1.RtkCorrectionsStatus):
    """RTK corrections status (0x81,0x31).

    Which corrections are received, and how old they are.

    Has the layout of `gnss_1.RtkCorrectionsStatus`. Not listed in any device profile. Known only
    from the MicroStrain MIP SDK.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.rtk_corrections_status"


class GpsEphemeris(gnss_1.GpsEphemeris):
    """GPS ephemeris (0x81,0x61).

    Broadcast orbit and clock of one GPS satellite.

    Has the layout of `gnss_1.GpsEphemeris`. Not listed in any device profile. Known only from the
    MicroStrain MIP SDK.

    `iodc` changes with the clock data; according to the manual, it rolls over at 4.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.gps_ephemeris"


class GlonassEphemeris(gnss_1.GlonassEphemeris):
    """GLONASS ephemeris (0x81,0x62).

    Broadcast orbit and clock of one GLONASS satellite.

    Has the layout of `gnss_1.GlonassEphemeris`. Also called `glo_ephemeris`. Not listed in any
    device profile. Known only from the MicroStrain MIP SDK.

    The interface control document of GLONASS explains p and ft. A period of four years has 1461
    days; no source says how nt, a u8, counts them.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.glonass_ephemeris"


class GalileoEphemeris(gnss_1.GalileoEphemeris):
    """Galileo ephemeris (0x81,0x63).

    Broadcast orbit and clock of one Galileo satellite.

    Has the layout of `gnss_1.GalileoEphemeris`. Not listed in any device profile. Known only from
    the MicroStrain MIP SDK.

    The layout is that of the GPS ephemeris. No source says what the two inter-signal corrections
    mean here. `iodc` changes with the clock data; according to the manual, it rolls over at 4.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.galileo_ephemeris"


class BeidouEphemeris(gnss_1.BeidouEphemeris):
    """BeiDou ephemeris (0x81,0x64).

    Broadcast orbit and clock of one BeiDou satellite.

    Has the layout of `gnss_1.BeidouEphemeris`. Not listed in any device profile. Known only from
    the MicroStrain MIP SDK.

    The layout is that of the GPS ephemeris. No source says what the two inter-signal corrections
    mean here. `iodc` changes with the clock data; according to the manual, it rolls over at 4.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.beidou_ephemeris"


class GpsIonoCorrection(gnss_1.GpsIonoCorrection):
    """GPS ionospheric correction (0x81,0x71).

    Model of the ionosphere that GPS broadcasts.

    Has the layout of `gnss_1.GpsIonoCorrection`. Also called `gps_iono_corr`. Not listed in any
    device profile. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.gps_iono_correction"


class GalileoIonoCorrection(gnss_1.GalileoIonoCorrection):
    """Galileo ionospheric correction (0x81,0x73).

    Model of the ionosphere that Galileo broadcasts.

    Has the layout of `gnss_1.GalileoIonoCorrection`. Also called `galileo_iono_corr`. Not listed in
    any device profile. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.galileo_iono_correction"


class BeidouIonoCorrection(gnss_1.BeidouIonoCorrection):
    """BeiDou ionospheric correction (0x81,0x74).

    Model of the ionosphere that BeiDou broadcasts.

    Has the layout of `gnss_1.BeidouIonoCorrection`. Also called `beidou_iono_corr`. Not listed in
    any device profile. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: Gnss Data (0x81)
    """

    __slots__ = ()

    SET = 0x81
    NAME = "gnss_data.beidou_iono_correction"


#: The types of each descriptor; several if constants or the size of the data distinguish layouts.
FIELDS: dict[int, tuple[type[Field], ...]] = {
    0x03: (LlhPosition,),
    0x04: (EcefPosition,),
    0x05: (NedVelocity,),
    0x06: (EcefVelocity,),
    0x07: (Dop,),
    0x08: (UtcTime,),
    0x09: (GpsTime,),
    0x0A: (ClockInfo,),
    0x0B: (FixInfo,),
    0x0C: (SvInfo,),
    0x0D: (HardwareStatus,),
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
