"""GNSS data (0x81, 0x91, 0x92, 0x93, 0x94, 0x95).

Measurements and status of GNSS receivers. Each receiver has a descriptor set; all have the same
fields.

Uncertain: Which devices send the fields that no manual lists for a set. The SDK lists the same
fields for all GNSS data sets.

- gnss_data (0x81): Measurements and status of the GNSS receiver of 4-series and 5-series devices.
- gnss_1 (0x91): Measurements and status of the first internal GNSS receiver.
- gnss_2 (0x92): Measurements and status of the second internal GNSS receiver.
- gnss_corrections (0x93): RTK corrections that the device receives. Data is sent as it is received.
- gnss_external (0x94): Data that an external GNSS receiver sends to the device in NMEA sentences. A
  field may need several sentences; a value that NMEA does not provide is not valid. Times are taken
  from the sentences.
- gnss_external_2 (0x95): Data that a second external GNSS receiver sends to the device. Uncertain:
  The name. It is from a page on the 3DM-CV7-INS that the vendor published for trial; the SDK calls
  the set GNSS 5.
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import IntFlag

from . import codec, types
from .field import Data, Field, Shared


@codec.open_flag(16)
class LlhPositionFlags(IntFlag):
    """Validity flags for the position."""

    LAT_LON = 1 << 0
    """`latitude` and `longitude` are valid. Bit 0."""
    ELLIPSOID_HEIGHT = 1 << 1
    """`ellipsoid_height` is valid. Bit 1."""
    MSL_HEIGHT = 1 << 2
    """`msl_height` is valid. Bit 2."""
    HORIZONTAL_ACCURACY = 1 << 3
    """`horizontal_accuracy` is valid. Bit 3."""
    VERTICAL_ACCURACY = 1 << 4
    """`vertical_accuracy` is valid. Bit 4."""
    FLAGS = 0x1F
    """All values are valid. Bits 0 to 4. Overlaps other bits."""


@codec.open_flag(16)
class EcefPositionFlags(IntFlag):
    """Validity flags for the position."""

    POSITION = 1 << 0
    """`position` is valid. Bit 0."""
    POSITION_ACCURACY = 1 << 1
    """`position_accuracy` is valid. Bit 1."""
    FLAGS = 0x3
    """All values are valid. Bits 0 to 1. Overlaps other bits."""


@codec.open_flag(16)
class NedVelocityFlags(IntFlag):
    """Validity flags for the velocity."""

    VELOCITY = 1 << 0
    """`velocity` is valid. Bit 0."""
    SPEED_3D = 1 << 1
    """`speed` is valid. Bit 1."""
    GROUND_SPEED = 1 << 2
    """`ground_speed` is valid. Bit 2."""
    HEADING = 1 << 3
    """`heading` is valid. Bit 3."""
    SPEED_ACCURACY = 1 << 4
    """`speed_accuracy` is valid. Bit 4."""
    HEADING_ACCURACY = 1 << 5
    """`heading_accuracy` is valid. Bit 5."""
    FLAGS = 0x3F
    """All values are valid. Bits 0 to 5. Overlaps other bits."""


@codec.open_flag(16)
class EcefVelocityFlags(IntFlag):
    """Validity flags for the velocity."""

    VELOCITY = 1 << 0
    """`velocity` is valid. Bit 0."""
    VELOCITY_ACCURACY = 1 << 1
    """`velocity_accuracy` is valid. Bit 1."""
    FLAGS = 0x3
    """All values are valid. Bits 0 to 1. Overlaps other bits."""


@codec.open_flag(16)
class DopFlags(IntFlag):
    """Validity flags for the dilutions of precision."""

    GDOP = 1 << 0
    """`gdop` is valid. Bit 0."""
    PDOP = 1 << 1
    """`pdop` is valid. Bit 1."""
    HDOP = 1 << 2
    """`hdop` is valid. Bit 2."""
    VDOP = 1 << 3
    """`vdop` is valid. Bit 3."""
    TDOP = 1 << 4
    """`tdop` is valid. Bit 4."""
    NDOP = 1 << 5
    """`ndop` is valid. Bit 5."""
    EDOP = 1 << 6
    """`edop` is valid. Bit 6."""
    FLAGS = 0x7F
    """All values are valid. Bits 0 to 6. Overlaps other bits."""


@codec.open_flag(16)
class UtcTimeFlags(IntFlag):
    """Validity flags for the UTC time."""

    GNSS_DATE_TIME = 1 << 0
    """Date and time come from GNSS. Bit 0."""
    LEAP_SECONDS_KNOWN = 1 << 1
    """The leap seconds between GPS time and UTC are known. Bit 1."""
    FLAGS = 0x3
    """All values are valid. Bits 0 to 1. Overlaps other bits."""


@codec.open_flag(16)
class GpsTimeFlags(IntFlag):
    """Validity flags for the time."""

    TOW = 1 << 0
    """`tow` is valid. Bit 0."""
    WEEK_NUMBER = 1 << 1
    """`week_number` is valid. Bit 1."""
    FLAGS = 0x3
    """All values are valid. Bits 0 to 1. Overlaps other bits."""


@codec.open_flag(16)
class ClockInfoFlags(IntFlag):
    """Validity flags for the clock parameters."""

    BIAS = 1 << 0
    """`bias` is valid. Bit 0."""
    DRIFT = 1 << 1
    """`drift` is valid. Bit 1."""
    ACCURACY_ESTIMATE = 1 << 2
    """`accuracy_estimate` is valid. Bit 2."""
    FLAGS = 0x7
    """All values are valid. Bits 0 to 2. Overlaps other bits."""


@codec.open_flag(16)
class FixFlags(IntFlag):
    """Corrections and satellite systems of the fix."""

    SBAS_USED = 1 << 0
    """SBAS corrections were used in the fix. Bit 0."""
    DGNSS_USED = 1 << 1
    """Differential corrections were used in the fix. Bit 1."""


@codec.open_flag(16)
class FixInfoFlags(IntFlag):
    """Validity flags for the fix information."""

    FIX_TYPE = 1 << 0
    """`fix_type` is valid. Bit 0."""
    NUM_SV = 1 << 1
    """`num_sv` is valid. Bit 1."""
    FIX_FLAGS = 1 << 2
    """`fix_flags` is valid. Bit 2."""
    FLAGS = 0x7
    """All values are valid. Bits 0 to 2. Overlaps other bits."""


@codec.open_flag(16)
class SvFlags(IntFlag):
    """State of a satellite."""

    USED_FOR_NAVIGATION = 1 << 0
    """The satellite is used in the position fix. Bit 0."""
    HEALTHY = 1 << 1
    """The satellite reports that its signals can be used. Bit 1."""


@codec.open_flag(16)
class SvInfoFlags(IntFlag):
    """Validity flags for the satellite info."""

    CHANNEL = 1 << 0
    """`channel` is valid. Bit 0."""
    SATELLITE_ID = 1 << 1
    """`satellite_id` is valid. Bit 1."""
    CARRIER_NOISE_RATIO = 1 << 2
    """`carrier_noise_ratio` is valid. Bit 2."""
    AZIMUTH = 1 << 3
    """`azimuth` is valid. Bit 3."""
    ELEVATION = 1 << 4
    """`elevation` is valid. Bit 4."""
    SV_FLAGS = 1 << 5
    """`sv_flags` is valid. Bit 5."""
    FLAGS = 0x3F
    """All values are valid. Bits 0 to 5. Overlaps other bits."""


class ReceiverState(codec.OpenEnum):
    """Operating state of a GNSS receiver."""

    OFF = 0
    ON = 1
    UNKNOWN = 2
    """Not known."""


class AntennaState(codec.OpenEnum):
    """Electrical condition of a GNSS antenna."""

    INIT = 1
    """Being initialized."""
    SHORT = 2
    """Short circuit."""
    OPEN = 3
    """Open circuit, no antenna."""
    GOOD = 4
    UNKNOWN = 5
    """Not known."""


class AntennaPower(codec.OpenEnum):
    """State of the antenna's power supply."""

    OFF = 0
    ON = 1
    UNKNOWN = 2
    """Not known."""


@codec.open_flag(16)
class HardwareStatusFlags(IntFlag):
    """Validity flags for the hardware status."""

    SENSOR_STATE = 1 << 0
    """`receiver_state` is valid. Bit 0."""
    ANTENNA_STATE = 1 << 1
    """`antenna_state` is valid. Bit 1."""
    ANTENNA_POWER = 1 << 2
    """`antenna_power` is valid. Bit 2."""
    FLAGS = 0x7
    """All values are valid. Bits 0 to 2. Overlaps other bits."""


@codec.open_flag(16)
class DgpsInfoFlags(IntFlag):
    """Validity flags for the state of the corrections."""

    AGE = 1 << 0
    """`age` is valid. Bit 0."""
    BASE_STATION_ID = 1 << 1
    """`base_station_id` is valid. Bit 1."""
    BASE_STATION_STATUS = 1 << 2
    """`base_station_status` is valid. Bit 2."""
    NUM_CHANNELS = 1 << 3
    """`num_channels` is valid. Bit 3."""
    FLAGS = 0xF
    """All values are valid. Bits 0 to 3. Overlaps other bits."""


@codec.open_flag(16)
class DgpsChannelFlags(IntFlag):
    """Validity flags for a differential correction."""

    SATELLITE_ID = 1 << 0
    """`satellite_id` is valid. Bit 0."""
    AGE = 1 << 1
    """`age` is valid. Bit 1."""
    RANGE_CORRECTION = 1 << 2
    """`range_correction` is valid. Bit 2."""
    RANGE_RATE_CORRECTION = 1 << 3
    """`range_rate_correction` is valid. Bit 3."""
    FLAGS = 0xF
    """All values are valid. Bits 0 to 3. Overlaps other bits."""


@codec.open_flag(16)
class ClockInfo2Flags(IntFlag):
    """Validity flags for the clock parameters."""

    BIAS = 1 << 0
    """`bias` is valid. Bit 0."""
    DRIFT = 1 << 1
    """`drift` is valid. Bit 1."""
    BIAS_ACCURACY = 1 << 2
    """`bias_accuracy_estimate` is valid. Bit 2."""
    DRIFT_ACCURACY = 1 << 3
    """`drift_accuracy_estimate` is valid. Bit 3."""
    FLAGS = 0xF
    """All values are valid. Bits 0 to 3. Overlaps other bits."""


@codec.open_flag(16)
class GpsLeapSecondsFlags(IntFlag):
    """Validity of the leap seconds. Bit 0 is not used."""

    LEAP_SECONDS = 1 << 1
    """`leap_seconds` is valid. Bit 1."""


class SbasSystem(codec.OpenEnum):
    """Satellite-based augmentation system (SBAS)."""

    UNKNOWN = 0
    """Not known."""
    WAAS = 1
    """WAAS, the North American system."""
    EGNOS = 2
    """EGNOS, the European system."""
    MSAS = 3
    """MSAS, the Japanese system."""
    GAGAN = 4
    """GAGAN, the Indian system."""


@codec.open_flag(8)
class SbasStatus(IntFlag):
    """Services of an SBAS system."""

    RANGE_AVAILABLE = 1 << 0
    """Ranging is available. Bit 0."""
    CORRECTIONS_AVAILABLE = 1 << 1
    """Corrections are available. Bit 1."""
    INTEGRITY_AVAILABLE = 1 << 2
    """Integrity information is available. Bit 2."""
    TEST_MODE = 1 << 3
    """The service is in test mode. Bit 3."""


@codec.open_flag(16)
class SbasInfoFlags(IntFlag):
    """Validity flags for the SBAS status."""

    TOW = 1 << 0
    """`tow` is valid. Bit 0."""
    WEEK_NUMBER = 1 << 1
    """`week_number` is valid. Bit 1."""
    SBAS_SYSTEM = 1 << 2
    """`sbas_system` is valid. Bit 2."""
    SBAS_ID = 1 << 3
    """`sbas_id` is valid. Bit 3."""
    COUNT = 1 << 4
    """`count` is valid. Bit 4."""
    SBAS_STATUS = 1 << 5
    """`sbas_status` is valid. Bit 5."""
    FLAGS = 0x3F
    """All values are valid. Bits 0 to 5. Overlaps other bits."""


@codec.open_flag(16)
class SbasCorrectionFlags(IntFlag):
    """Validity flags for an SBAS correction."""

    UDREI = 1 << 0
    """`udrei` is valid. Bit 0."""
    PSEUDORANGE_CORRECTION = 1 << 1
    """`pseudorange_correction` is valid. Bit 1."""
    IONO_CORRECTION = 1 << 2
    """`iono_correction` is valid. Bit 2."""
    FLAGS = 0x7
    """All values are valid. Bits 0 to 2. Overlaps other bits."""


class RfBand(codec.OpenEnum):
    """Frequency band of GNSS signals."""

    UNKNOWN = 0
    """Not known."""
    L1 = 1
    L2 = 2
    L5 = 5


class JammingState(codec.OpenEnum):
    """Severity of jamming."""

    UNKNOWN = 0
    """Not known."""
    NONE = 1
    """Not jammed."""
    PARTIAL = 2
    """Partly jammed."""
    SIGNIFICANT = 3
    """Heavily jammed."""


class SpoofingState(codec.OpenEnum):
    """Severity of spoofing."""

    UNKNOWN = 0
    """Not known."""
    NONE = 1
    """Not spoofed."""
    PARTIAL = 2
    """Partly spoofed."""
    SIGNIFICANT = 3
    """Heavily spoofed."""


@codec.open_flag(16)
class RfErrorDetectionFlags(IntFlag):
    """Validity flags for the detection."""

    RF_BAND = 1 << 0
    """`rf_band` is valid. Bit 0."""
    JAMMING_STATE = 1 << 1
    """`jamming_state` is valid. Bit 1."""
    SPOOFING_STATE = 1 << 2
    """`spoofing_state` is valid. Bit 2."""
    FREQUENCY = 1 << 3
    """`frequency` is valid; set only by firmware that sends the frequency. Bit 3."""
    FLAGS = 0xF
    """All values are valid. Bits 0 to 3. Overlaps other bits."""


class HeadingFixType(codec.OpenEnum):
    """Resolution of the carrier phase ambiguities for a heading."""

    UNKNOWN = 0
    """Not known."""
    FLOAT = 1
    """The ambiguities are real numbers, which is less accurate."""
    FIXED = 2
    """The ambiguities are fixed to whole numbers of cycles."""


@codec.open_flag(16)
class HeadingFlags(IntFlag):
    """Validity flags for the heading."""

    HEADING = 1 << 0
    """`heading` is valid. Bit 0."""
    UNCERTAINTY = 1 << 1
    """`uncertainty` is valid. Bit 1."""
    FIX_TYPE = 1 << 2
    """`fix_type` is valid. Bit 2."""
    FLAGS = 0x7
    """All values are valid. Bits 0 to 2. Overlaps other bits."""


@codec.open_flag(16)
class SatelliteStatusFlags(IntFlag):
    """Validity flags for the satellite status."""

    TOW = 1 << 0
    """`tow` is valid. Bit 0."""
    WEEK_NUMBER = 1 << 1
    """`week_number` is valid. Bit 1."""
    GNSS_ID = 1 << 2
    """`gnss_id` is valid. Bit 2."""
    SATELLITE_ID = 1 << 3
    """`satellite_id` is valid. Bit 3."""
    ELEVATION = 1 << 4
    """`elevation` is valid. Bit 4."""
    AZIMUTH = 1 << 5
    """`azimuth` is valid. Bit 5."""
    HEALTH = 1 << 6
    """`health` is valid. Bit 6."""
    FLAGS = 0x7F
    """All values are valid. Bits 0 to 6. Overlaps other bits."""


class SignalQuality(codec.OpenEnum):
    """Tracking quality of a signal."""

    NONE = 0
    """No signal."""
    SEARCHING = 1
    """The signal is being searched for."""
    ACQUIRED = 2
    """The signal is acquired."""
    UNUSABLE = 3
    """The signal is found but cannot be used."""
    TIME_LOCKED = 4
    """Time-locked."""
    FULLY_LOCKED = 5


@codec.open_flag(16)
class RawFlags(IntFlag):
    """Validity flags for the observation."""

    TOW = 1 << 0
    """`tow` is valid. Bit 0."""
    WEEK_NUMBER = 1 << 1
    """`week_number` is valid. Bit 1."""
    RECEIVER_ID = 1 << 2
    """`receiver_id` is valid. Bit 2."""
    TRACKING_CHANNEL = 1 << 3
    """`tracking_channel` is valid. Bit 3."""
    GNSS_ID = 1 << 4
    """`gnss_id` is valid. Bit 4."""
    SATELLITE_ID = 1 << 5
    """`satellite_id` is valid. Bit 5."""
    SIGNAL_ID = 1 << 6
    """`signal_id` is valid. Bit 6."""
    SIGNAL_STRENGTH = 1 << 7
    """`signal_strength` is valid. Bit 7."""
    QUALITY = 1 << 8
    """`quality` is valid. Bit 8."""
    PSEUDORANGE = 1 << 9
    """`pseudorange` is valid. Bit 9."""
    CARRIER_PHASE = 1 << 10
    """`carrier_phase` is valid. Bit 10."""
    DOPPLER = 1 << 11
    """`doppler` is valid. Bit 11."""
    RANGE_UNCERTAINTY = 1 << 12
    """`range_uncertainty` is valid. Bit 12."""
    CARRIER_PHASE_UNCERTAINTY = 1 << 13
    """`phase_uncertainty` is valid. Bit 13."""
    DOPPLER_UNCERTAINTY = 1 << 14
    """`doppler_uncertainty` is valid. Bit 14."""
    LOCK_TIME = 1 << 15
    """`lock_time` is valid. Bit 15."""
    FLAGS = 0xFFFF
    """All values are valid. Bits 0 to 15. Overlaps other bits."""


@codec.open_flag(16)
class BaseStationIndicators(IntFlag):
    """Properties of a base station, as in its RTCM message."""

    GPS = 1 << 0
    """GPS is supported. Bit 0."""
    GLONASS = 1 << 1
    """GLONASS is supported. Bit 1."""
    GALILEO = 1 << 2
    """Galileo is supported. Bit 2."""
    BEIDOU = 1 << 3
    """BeiDou is supported. Bit 3."""
    REFERENCE_STATION = 1 << 4
    """Reference station indicator. Bit 4."""
    SINGLE_RECEIVER = 1 << 5
    """Single receiver oscillator indicator. Bit 5."""
    QUARTER_CYCLE_BIT1 = 1 << 6
    """First bit of the quarter cycle indicator. Bit 6."""
    QUARTER_CYCLE_BIT2 = 1 << 7
    """Second bit of the quarter cycle indicator. Bit 7."""
    QUARTER_CYCLE_BITS = 0xC0
    """Quarter cycle indicator. Bits 6 to 7. Overlaps other bits."""


@codec.open_flag(16)
class BaseStationInfoFlags(IntFlag):
    """Valid values."""

    TOW = 1 << 0
    """`tow` is valid. Bit 0."""
    WEEK_NUMBER = 1 << 1
    """`week_number` is valid. Bit 1."""
    ECEF_POSITION = 1 << 2
    """`ecef_position` is valid. Bit 2."""
    HEIGHT = 1 << 3
    """`height` is valid. Bit 3."""
    STATION_ID = 1 << 4
    """`station_id` is valid. Bit 4."""
    INDICATORS = 1 << 5
    """`indicators` is valid. Bit 5."""
    FLAGS = 0x3F
    """All values are valid. Bits 0 to 5. Overlaps other bits."""


@codec.open_flag(16)
class RtkEpochStatus(IntFlag):
    """Corrections received during an epoch."""

    ANTENNA_LOCATION_RECEIVED = 1 << 0
    """The position of the base station's antenna has arrived. Bit 0."""
    ANTENNA_DESCRIPTION_RECEIVED = 1 << 1
    """The description of the base station's antenna has arrived. Bit 1."""
    GPS_RECEIVED = 1 << 2
    """GPS corrections have arrived. Bit 2."""
    GLONASS_RECEIVED = 1 << 3
    """GLONASS corrections have arrived. Bit 3."""
    GALILEO_RECEIVED = 1 << 4
    """Galileo corrections have arrived. Bit 4."""
    BEIDOU_RECEIVED = 1 << 5
    """BeiDou corrections have arrived. Bit 5."""
    USING_GPS_MSM_MESSAGES = 1 << 6
    """GPS corrections are received in MSM messages, not in the RTCM messages 1001-1004. Bit 6."""
    USING_GLONASS_MSM_MESSAGES = 1 << 7
    """GLONASS corrections are received in MSM messages, not in the RTCM messages 1009-1012. Bit 7.
    """
    DONGLE_STATUS_READ_FAILED = 1 << 8
    """The status of the dongle could not be read. Bit 8."""


@codec.open_flag(16)
class RtkCorrectionsStatusFlags(IntFlag):
    """Valid values."""

    TOW = 1 << 0
    """`tow` is valid. Bit 0."""
    WEEK_NUMBER = 1 << 1
    """`week_number` is valid. Bit 1."""
    EPOCH_STATUS = 1 << 2
    """`epoch_status` is valid. Bit 2."""
    DONGLE_STATUS = 1 << 3
    """`dongle_status` is valid. Bit 3."""
    GPS_LATENCY = 1 << 4
    """`gps_correction_latency` is valid. Bit 4."""
    GLONASS_LATENCY = 1 << 5
    """`glonass_correction_latency` is valid. Bit 5."""
    GALILEO_LATENCY = 1 << 6
    """`galileo_correction_latency` is valid. Bit 6."""
    BEIDOU_LATENCY = 1 << 7
    """`beidou_correction_latency` is valid. Bit 7."""
    FLAGS = 0xFF
    """All values are valid. Bits 0 to 7. Overlaps other bits."""


@codec.open_flag(16)
class EphemerisFlags(IntFlag):
    """Contents of a GPS, Galileo or BeiDou ephemeris."""

    EPHEMERIS = 1 << 0
    """The ephemeris is valid. Bit 0."""
    MODERN_DATA = 1 << 1
    """Data of the modernized navigation message is included. Bit 1."""
    ISC_L5 = 1 << 2
    """`isc_l2c` is the correction for L5, not for L2. Bit 2."""
    FLAGS = 0x7
    """All values are valid. Bits 0 to 2. Overlaps other bits."""


class GlonassSatelliteType(codec.OpenEnum):
    """Generation of a GLONASS satellite."""

    GLONASS = 0
    GLONASS_M = 1


@codec.open_flag(16)
class GlonassEphemerisFlags(IntFlag):
    """Validity of the ephemeris."""

    EPHEMERIS = 1 << 0
    """The ephemeris is valid. Bit 0."""
    FLAGS = 1 << 0
    """All values are valid. Bit 0. Overlaps other bits."""


@codec.open_flag(16)
class GpsIonoCorrectionFlags(IntFlag):
    """Validity flags for the model."""

    TOW = 1 << 0
    """`tow` is valid. Bit 0."""
    WEEK_NUMBER = 1 << 1
    """`week_number` is valid. Bit 1."""
    ALPHA = 1 << 2
    """`alpha` is valid. Bit 2."""
    BETA = 1 << 3
    """`beta` is valid. Bit 3."""
    FLAGS = 0xF
    """All values are valid. Bits 0 to 3. Overlaps other bits."""


@codec.open_flag(16)
class GalileoIonoCorrectionFlags(IntFlag):
    """Validity flags for the model."""

    TOW = 1 << 0
    """`tow` is valid. Bit 0."""
    WEEK_NUMBER = 1 << 1
    """`week_number` is valid. Bit 1."""
    ALPHA = 1 << 2
    """`alpha` is valid. Bit 2."""
    DISTURBANCE_FLAGS = 1 << 3
    """`disturbance_flags` is valid. Bit 3."""
    FLAGS = 0xF
    """All values are valid. Bits 0 to 3. Overlaps other bits."""


@codec.open_flag(16)
class BeidouIonoCorrectionFlags(IntFlag):
    """Validity flags for the model."""

    TOW = 1 << 0
    """`tow` is valid. Bit 0."""
    WEEK_NUMBER = 1 << 1
    """`week_number` is valid. Bit 1."""
    ALPHA = 1 << 2
    """`alpha` is valid. Bit 2."""
    BETA = 1 << 3
    """`beta` is valid. Bit 3."""
    ALPHA_CORRECTION = 1 << 4
    """`alpha_correction` is valid. Bit 4."""
    FLAGS = 0x1F
    """All values are valid. Bits 0 to 4. Overlaps other bits."""


class LlhPosition(Shared, Data):
    """GNSS LLH position (0x03).

    GNSS position as latitude, longitude and height.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Also called `pos_llh`. Supported by 3DM-CV7-GNSS/INS,
    3DM-CV7-INS and 3DM-GQ7-GNSS/INS.

    - 3dm-cv7-gnss-ins: GNSS LLH Position (0x91,0x03)
    - 3dm-cv7-gnss-ins: GNSS LLH Position (0x92,0x03)
    - 3dm-cv7-gnss-ins: GNSS LLH Position (0x94,0x03)
    """

    __slots__ = (
        "latitude",
        "longitude",
        "ellipsoid_height",
        "msl_height",
        "horizontal_accuracy",
        "vertical_accuracy",
        "valid_flags",
    )
    __match_args__ = (
        "latitude",
        "longitude",
        "ellipsoid_height",
        "msl_height",
        "horizontal_accuracy",
        "vertical_accuracy",
        "valid_flags",
    )

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x03
    NAME = "gnss_data.llh_position"
    ROLE = "data"
    _LAYOUT = (
        ("latitude", "d", None),
        ("longitude", "d", None),
        ("ellipsoid_height", "d", None),
        ("msl_height", "d", None),
        ("horizontal_accuracy", "f", None),
        ("vertical_accuracy", "f", None),
        ("valid_flags", "H", LlhPositionFlags),
    )

    latitude: float
    """Geodetic latitude. Unit: deg. Frame: llh. Range: -90 to 90. Positive: north. Valid if
    `LlhPositionFlags.LAT_LON` of `valid_flags` is set.
    """
    longitude: float
    """Geodetic longitude. Unit: deg. Frame: llh. Range: -180 to 180. Positive: east. Valid if
    `LlhPositionFlags.LAT_LON` of `valid_flags` is set.
    """
    ellipsoid_height: float
    """Height above the ellipsoid. Unit: m. Frame: llh. Valid if `LlhPositionFlags.ELLIPSOID_HEIGHT`
    of `valid_flags` is set.
    """
    msl_height: float
    """Height above mean sea level. Unit: m. Valid if `LlhPositionFlags.MSL_HEIGHT` of `valid_flags`
    is set.
    """
    horizontal_accuracy: float
    """Estimated error of latitude and longitude. Unit: m. Range: at least 0. Valid if
    `LlhPositionFlags.HORIZONTAL_ACCURACY` of `valid_flags` is set.
    """
    vertical_accuracy: float
    """Estimated error of the heights. Unit: m. Range: at least 0. Valid if
    `LlhPositionFlags.VERTICAL_ACCURACY` of `valid_flags` is set.
    """
    valid_flags: LlhPositionFlags
    """Validity flags for the position."""

    def __init__(
        self,
        latitude: float,
        longitude: float,
        ellipsoid_height: float,
        msl_height: float,
        horizontal_accuracy: float,
        vertical_accuracy: float,
        valid_flags: LlhPositionFlags,
    ) -> None:
        self.latitude = latitude
        self.longitude = longitude
        self.ellipsoid_height = ellipsoid_height
        self.msl_height = msl_height
        self.horizontal_accuracy = horizontal_accuracy
        self.vertical_accuracy = vertical_accuracy
        self.valid_flags = valid_flags


class EcefPosition(Shared, Data):
    """GNSS ECEF position (0x04).

    GNSS position in Earth-fixed coordinates.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Also called `pos_ecef`. Supported by 3DM-CV7-GNSS/INS,
    3DM-CV7-INS and 3DM-GQ7-GNSS/INS.

    - 3dm-cv7-gnss-ins: GNSS ECEF Position (0x91,0x04)
    - 3dm-cv7-gnss-ins: GNSS ECEF Position (0x92,0x04)
    """

    __slots__ = ("position", "position_accuracy", "valid_flags")
    __match_args__ = ("position", "position_accuracy", "valid_flags")

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x04
    NAME = "gnss_data.ecef_position"
    ROLE = "data"
    _LAYOUT = (
        ("position", "ddd", types.Vector3d),
        ("position_accuracy", "f", None),
        ("valid_flags", "H", EcefPositionFlags),
    )

    _VECTORS = {"position": (types.Vector3d,)}

    position: types.Vector3d
    """Position of the antenna. Elements: x, y, z. Unit: m. Frame: ecef. Valid if
    `EcefPositionFlags.POSITION` of `valid_flags` is set.
    """
    position_accuracy: float
    """Estimated error of the position. Unit: m. Range: at least 0. Valid if
    `EcefPositionFlags.POSITION_ACCURACY` of `valid_flags` is set.
    """
    valid_flags: EcefPositionFlags
    """Validity flags for the position."""

    def __init__(
        self,
        position: types.Vector3d | codec.Numbers,
        position_accuracy: float,
        valid_flags: EcefPositionFlags,
    ) -> None:
        self.position = codec.vector(position, types.Vector3d)
        self.position_accuracy = position_accuracy
        self.valid_flags = valid_flags


class NedVelocity(Shared, Data):
    """NED velocity (0x05).

    GNSS velocity in the local level frame.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Also called `vel_ned`. Supported by 3DM-CV7-GNSS/INS,
    3DM-CV7-INS and 3DM-GQ7-GNSS/INS.

    - 3dm-cv7-gnss-ins: NED Velocity (0x91,0x05)
    - 3dm-cv7-gnss-ins: NED Velocity (0x92,0x05)
    - 3dm-cv7-gnss-ins: NED Velocity (0x94,0x05)
    """

    __slots__ = (
        "velocity",
        "speed",
        "ground_speed",
        "heading",
        "speed_accuracy",
        "heading_accuracy",
        "valid_flags",
    )
    __match_args__ = (
        "velocity",
        "speed",
        "ground_speed",
        "heading",
        "speed_accuracy",
        "heading_accuracy",
        "valid_flags",
    )

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x05
    NAME = "gnss_data.ned_velocity"
    ROLE = "data"
    _LAYOUT = (
        ("velocity", "fff", types.Ned3f),
        ("speed", "f", None),
        ("ground_speed", "f", None),
        ("heading", "f", None),
        ("speed_accuracy", "f", None),
        ("heading_accuracy", "f", None),
        ("valid_flags", "H", NedVelocityFlags),
    )

    _VECTORS = {"velocity": (types.Ned3f,)}

    velocity: types.Ned3f
    """Velocity of the antenna. Elements: north, east, down. Unit: m/s. Frame: ned. At rest and
    level: north 0, east 0, down 0. Valid if `NedVelocityFlags.VELOCITY` of `valid_flags` is set.
    """
    speed: float
    """Speed in space. Unit: m/s. Range: at least 0. Valid if `NedVelocityFlags.SPEED_3D` of
    `valid_flags` is set.
    """
    ground_speed: float
    """Speed over ground. Unit: m/s. Range: at least 0. Valid if `NedVelocityFlags.GROUND_SPEED` of
    `valid_flags` is set.
    """
    heading: float
    """Direction of the motion over ground. Unit: deg. Frame: ned. Positive: clockwise seen from
    above. Valid if `NedVelocityFlags.HEADING` of `valid_flags` is set.
    """
    speed_accuracy: float
    """Estimated error of the speed. Unit: m/s. Range: at least 0. Valid if
    `NedVelocityFlags.SPEED_ACCURACY` of `valid_flags` is set.
    """
    heading_accuracy: float
    """Estimated error of the heading. Unit: deg. Range: at least 0. Valid if
    `NedVelocityFlags.HEADING_ACCURACY` of `valid_flags` is set.
    """
    valid_flags: NedVelocityFlags
    """Validity flags for the velocity."""

    def __init__(
        self,
        velocity: types.Ned3f | codec.Numbers,
        speed: float,
        ground_speed: float,
        heading: float,
        speed_accuracy: float,
        heading_accuracy: float,
        valid_flags: NedVelocityFlags,
    ) -> None:
        self.velocity = codec.vector(velocity, types.Ned3f)
        self.speed = speed
        self.ground_speed = ground_speed
        self.heading = heading
        self.speed_accuracy = speed_accuracy
        self.heading_accuracy = heading_accuracy
        self.valid_flags = valid_flags


class EcefVelocity(Shared, Data):
    """GNSS ECEF velocity (0x06).

    GNSS velocity in Earth-fixed coordinates.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Also called `vel_ecef`. Supported by 3DM-CV7-GNSS/INS,
    3DM-CV7-INS, 3DM-GQ7-GNSS/INS and 3DM-GX5-35.

    - 3dm-gx5-35: 5.2.4 ECEF Velocity (0x81, 0x06)
    - 3dm-cv7-gnss-ins: GNSS ECEF Velocity (0x91,0x06)
    - 3dm-cv7-gnss-ins: GNSS ECEF Velocity (0x92,0x06)
    """

    __slots__ = ("velocity", "velocity_accuracy", "valid_flags")
    __match_args__ = ("velocity", "velocity_accuracy", "valid_flags")

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x06
    NAME = "gnss_data.ecef_velocity"
    ROLE = "data"
    _LAYOUT = (
        ("velocity", "fff", types.Vector3f),
        ("velocity_accuracy", "f", None),
        ("valid_flags", "H", EcefVelocityFlags),
    )

    _VECTORS = {"velocity": (types.Vector3f,)}

    velocity: types.Vector3f
    """Velocity of the antenna. Elements: x, y, z. Unit: m/s. Frame: ecef. At rest and level: x 0, y
    0, z 0. Valid if `EcefVelocityFlags.VELOCITY` of `valid_flags` is set.
    """
    velocity_accuracy: float
    """Estimated error of the velocity. Unit: m/s. Range: at least 0. Valid if
    `EcefVelocityFlags.VELOCITY_ACCURACY` of `valid_flags` is set.
    """
    valid_flags: EcefVelocityFlags
    """Validity flags for the velocity."""

    def __init__(
        self,
        velocity: types.Vector3f | codec.Numbers,
        velocity_accuracy: float,
        valid_flags: EcefVelocityFlags,
    ) -> None:
        self.velocity = codec.vector(velocity, types.Vector3f)
        self.velocity_accuracy = velocity_accuracy
        self.valid_flags = valid_flags


class Dop(Shared, Data):
    """DOP (0x07).

    Dilution of precision of the satellite geometry.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Supported by 3DM-CV7-GNSS/INS and 3DM-CV7-INS.

    - 3dm-cv7-gnss-ins: DOP (0x91,0x07)
    - 3dm-cv7-gnss-ins: DOP (0x92,0x07)
    """

    __slots__ = ("gdop", "pdop", "hdop", "vdop", "tdop", "ndop", "edop", "valid_flags")
    __match_args__ = ("gdop", "pdop", "hdop", "vdop", "tdop", "ndop", "edop", "valid_flags")

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x07
    NAME = "gnss_data.dop"
    ROLE = "data"
    _LAYOUT = (
        ("gdop", "f", None),
        ("pdop", "f", None),
        ("hdop", "f", None),
        ("vdop", "f", None),
        ("tdop", "f", None),
        ("ndop", "f", None),
        ("edop", "f", None),
        ("valid_flags", "H", DopFlags),
    )

    gdop: float
    """Geometric dilution. Unit: 1. Range: at least 0. Valid if `DopFlags.GDOP` of `valid_flags` is
    set.
    """
    pdop: float
    """Position dilution. Unit: 1. Range: at least 0. Valid if `DopFlags.PDOP` of `valid_flags` is
    set.
    """
    hdop: float
    """Horizontal dilution. Unit: 1. Range: at least 0. Valid if `DopFlags.HDOP` of `valid_flags` is
    set.
    """
    vdop: float
    """Vertical dilution. Unit: 1. Range: at least 0. Valid if `DopFlags.VDOP` of `valid_flags` is
    set.
    """
    tdop: float
    """Time dilution. Unit: 1. Range: at least 0. Valid if `DopFlags.TDOP` of `valid_flags` is set.
    """
    ndop: float
    """Northing dilution. Unit: 1. Range: at least 0. Valid if `DopFlags.NDOP` of `valid_flags` is
    set.
    """
    edop: float
    """Easting dilution. Unit: 1. Range: at least 0. Valid if `DopFlags.EDOP` of `valid_flags` is
    set.
    """
    valid_flags: DopFlags
    """Validity flags for the dilutions of precision."""

    def __init__(
        self,
        gdop: float,
        pdop: float,
        hdop: float,
        vdop: float,
        tdop: float,
        ndop: float,
        edop: float,
        valid_flags: DopFlags,
    ) -> None:
        self.gdop = gdop
        self.pdop = pdop
        self.hdop = hdop
        self.vdop = vdop
        self.tdop = tdop
        self.ndop = ndop
        self.edop = edop
        self.valid_flags = valid_flags


class UtcTime(Shared, Data):
    """UTC time (0x08).

    Coordinated universal time (UTC) according to the receiver.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Supported by 3DM-CV7-GNSS/INS and 3DM-CV7-INS.

    - 3dm-cv7-gnss-ins: UTC Time (0x91,0x08)
    - 3dm-cv7-gnss-ins: UTC Time (0x92,0x08)
    - 3dm-cv7-gnss-ins: UTC Time (0x94,0x08)
    """

    __slots__ = ("year", "month", "day", "hour", "min", "sec", "msec", "valid_flags")
    __match_args__ = ("year", "month", "day", "hour", "min", "sec", "msec", "valid_flags")

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x08
    NAME = "gnss_data.utc_time"
    ROLE = "data"
    _LAYOUT = (
        ("year", "H", None),
        ("month", "B", None),
        ("day", "B", None),
        ("hour", "B", None),
        ("min", "B", None),
        ("sec", "B", None),
        ("msec", "I", None),
        ("valid_flags", "H", UtcTimeFlags),
    )

    year: int
    """Year with four digits. Valid if `UtcTimeFlags.GNSS_DATE_TIME` of `valid_flags` is set."""
    month: int
    """Month, 1 for January. Range: 1 to 12. Valid if `UtcTimeFlags.GNSS_DATE_TIME` of `valid_flags`
    is set.
    """
    day: int
    """Day of the month. Range: 1 to 31. Valid if `UtcTimeFlags.GNSS_DATE_TIME` of `valid_flags` is
    set.
    """
    hour: int
    """Hour of the day. Range: 0 to 23. Valid if `UtcTimeFlags.GNSS_DATE_TIME` of `valid_flags` is
    set.
    """
    min: int
    """Minute. Range: 0 to 59. Valid if `UtcTimeFlags.GNSS_DATE_TIME` of `valid_flags` is set."""
    sec: int
    """Second. Unit: s. Range: 0 to 59. Valid if `UtcTimeFlags.GNSS_DATE_TIME` of `valid_flags` is
    set.
    """
    msec: int
    """Fraction of the second. Unit: ms. Range: 0 to 999. Valid if `UtcTimeFlags.GNSS_DATE_TIME` of
    `valid_flags` is set.
    """
    valid_flags: UtcTimeFlags
    """Validity flags for the time."""

    def __init__(
        self,
        year: int,
        month: int,
        day: int,
        hour: int,
        min: int,
        sec: int,
        msec: int,
        valid_flags: UtcTimeFlags,
    ) -> None:
        self.year = year
        self.month = month
        self.day = day
        self.hour = hour
        self.min = min
        self.sec = sec
        self.msec = msec
        self.valid_flags = valid_flags


class GpsTime(Shared, Data):
    """GPS time (0x09).

    GPS time according to the receiver.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: GPS Time (0x91,0x09)
    - 3dm-cv7-gnss-ins: GPS Time (0x92,0x09)
    """

    __slots__ = ("tow", "week_number", "valid_flags")
    __match_args__ = ("tow", "week_number", "valid_flags")

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x09
    NAME = "gnss_data.gps_time"
    ROLE = "data"
    _LAYOUT = (("tow", "d", None), ("week_number", "H", None), ("valid_flags", "H", GpsTimeFlags))

    tow: float
    """GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if `GpsTimeFlags.TOW`
    of `valid_flags` is set.
    """
    week_number: int
    """GPS week number. Unit: week. Valid if `GpsTimeFlags.WEEK_NUMBER` of `valid_flags` is set."""
    valid_flags: GpsTimeFlags
    """Validity flags for the time."""

    def __init__(self, tow: float, week_number: int, valid_flags: GpsTimeFlags) -> None:
        self.tow = tow
        self.week_number = week_number
        self.valid_flags = valid_flags


class ClockInfo(Shared, Data):
    """Clock info (0x0A).

    Bias and drift of the receiver clock.

    No device is known for certain to support it. Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2
    (0x92), gnss_corrections (0x93), gnss_external (0x94) and gnss_external_2 (0x95). Known only
    from the MicroStrain MIP SDK.

    Clock info 2 supersedes it and is more detailed.

    - mip-sdk-4: Clock Info (0x81,0x0A)
    """

    __slots__ = ("bias", "drift", "accuracy_estimate", "valid_flags")
    __match_args__ = ("bias", "drift", "accuracy_estimate", "valid_flags")

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x0A
    NAME = "gnss_data.clock_info"
    ROLE = "data"
    _LAYOUT = (
        ("bias", "d", None),
        ("drift", "d", None),
        ("accuracy_estimate", "d", None),
        ("valid_flags", "H", ClockInfoFlags),
    )

    bias: float
    """Bias of the clock. Unit: s. Valid if `ClockInfoFlags.BIAS` of `valid_flags` is set."""
    drift: float
    """Drift of the clock. Unit: s/s. Valid if `ClockInfoFlags.DRIFT` of `valid_flags` is set."""
    accuracy_estimate: float
    """Estimated error of the bias. Unit: s. Range: at least 0. Valid if
    `ClockInfoFlags.ACCURACY_ESTIMATE` of `valid_flags` is set.
    """
    valid_flags: ClockInfoFlags
    """Validity flags for the clock parameters."""

    def __init__(
        self, bias: float, drift: float, accuracy_estimate: float, valid_flags: ClockInfoFlags
    ) -> None:
        self.bias = bias
        self.drift = drift
        self.accuracy_estimate = accuracy_estimate
        self.valid_flags = valid_flags


class FixInfo(Shared, Data):
    """Fix info (0x0B).

    Type of the position fix, with the satellites and corrections used.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Supported by 3DM-CV7-GNSS/INS, 3DM-CV7-INS and
    3DM-GQ7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Fix Info (0x91,0x0B)
    - 3dm-cv7-gnss-ins: Fix Info (0x92,0x0B)
    - 3dm-cv7-gnss-ins: Fix Info (0x94,0x0B)
    """

    __slots__ = ("fix_type", "num_sv", "fix_flags", "valid_flags")
    __match_args__ = ("fix_type", "num_sv", "fix_flags", "valid_flags")

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x0B
    NAME = "gnss_data.fix_info"
    ROLE = "data"
    _LAYOUT = (
        ("fix_type", "B", types.GnssFixType),
        ("num_sv", "B", None),
        ("fix_flags", "H", FixFlags),
        ("valid_flags", "H", FixInfoFlags),
    )

    fix_type: types.GnssFixType
    """Quantities that the receiver can determine at present. Valid if `FixInfoFlags.FIX_TYPE` of
    `valid_flags` is set.
    """
    num_sv: int
    """Number of satellites used in the fix. Unit: 1. Valid if `FixInfoFlags.NUM_SV` of
    `valid_flags` is set.
    """
    fix_flags: FixFlags
    """Corrections and satellite systems of the fix. Valid if `FixInfoFlags.FIX_FLAGS` of
    `valid_flags` is set.
    """
    valid_flags: FixInfoFlags
    """Validity flags for the fix information."""

    def __init__(
        self,
        fix_type: types.GnssFixType,
        num_sv: int,
        fix_flags: FixFlags,
        valid_flags: FixInfoFlags,
    ) -> None:
        self.fix_type = fix_type
        self.num_sv = num_sv
        self.fix_flags = fix_flags
        self.valid_flags = valid_flags


class SvInfo(Shared, Data):
    """Satellite info (0x0C).

    State of one tracked satellite.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Supported by 3DM-GX5-45. Known only from the MicroStrain MIP
    SDK. Uncertain: Whether a packet holds one of these fields or several.

    Each satellite is sent as one field, in packets separate from other GNSS data.

    - mip-sdk-4: Sv Info (0x81,0x0C)
    """

    __slots__ = (
        "channel",
        "satellite_id",
        "carrier_noise_ratio",
        "azimuth",
        "elevation",
        "sv_flags",
        "valid_flags",
    )
    __match_args__ = (
        "channel",
        "satellite_id",
        "carrier_noise_ratio",
        "azimuth",
        "elevation",
        "sv_flags",
        "valid_flags",
    )

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x0C
    NAME = "gnss_data.sv_info"
    ROLE = "data"
    _LAYOUT = (
        ("channel", "B", None),
        ("satellite_id", "B", None),
        ("carrier_noise_ratio", "H", None),
        ("azimuth", "h", None),
        ("elevation", "h", None),
        ("sv_flags", "H", SvFlags),
        ("valid_flags", "H", SvInfoFlags),
    )

    channel: int
    """Channel of the receiver that tracks the satellite. Valid if `SvInfoFlags.CHANNEL` of
    `valid_flags` is set.
    """
    satellite_id: int
    """Number of the satellite. Valid if `SvInfoFlags.SATELLITE_ID` of `valid_flags` is set."""
    carrier_noise_ratio: int
    """Carrier to noise density ratio. Unit: dB-Hz. Valid if `SvInfoFlags.CARRIER_NOISE_RATIO` of
    `valid_flags` is set.
    """
    azimuth: int
    """Direction of the satellite, from north. Unit: deg. Valid if `SvInfoFlags.AZIMUTH` of
    `valid_flags` is set.
    """
    elevation: int
    """Angle of the satellite above the horizon. Unit: deg. Range: -90 to 90. Valid if
    `SvInfoFlags.ELEVATION` of `valid_flags` is set.
    """
    sv_flags: SvFlags
    """State of the satellite. Valid if `SvInfoFlags.SV_FLAGS` of `valid_flags` is set."""
    valid_flags: SvInfoFlags
    """Validity flags for the satellite info."""

    def __init__(
        self,
        channel: int,
        satellite_id: int,
        carrier_noise_ratio: int,
        azimuth: int,
        elevation: int,
        sv_flags: SvFlags,
        valid_flags: SvInfoFlags,
    ) -> None:
        self.channel = channel
        self.satellite_id = satellite_id
        self.carrier_noise_ratio = carrier_noise_ratio
        self.azimuth = azimuth
        self.elevation = elevation
        self.sv_flags = sv_flags
        self.valid_flags = valid_flags


class HardwareStatus(Shared, Data):
    """GNSS hardware status (0x0D).

    State of the receiver and of its antenna.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Also called `hw_status`. Supported by 3DM-CV7-GNSS/INS,
    3DM-GQ7-GNSS/INS and 3DM-GX5-45.

    - 3dm-cv7-gnss-ins: GNSS Hardware Status (0x91,0x0D)
    - 3dm-cv7-gnss-ins: GNSS Hardware Status (0x92,0x0D)
    """

    __slots__ = ("receiver_state", "antenna_state", "antenna_power", "valid_flags")
    __match_args__ = ("receiver_state", "antenna_state", "antenna_power", "valid_flags")

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x0D
    NAME = "gnss_data.hardware_status"
    ROLE = "data"
    _LAYOUT = (
        ("receiver_state", "B", ReceiverState),
        ("antenna_state", "B", AntennaState),
        ("antenna_power", "B", AntennaPower),
        ("valid_flags", "H", HardwareStatusFlags),
    )

    receiver_state: ReceiverState
    """Operating state of the receiver. Valid if `HardwareStatusFlags.SENSOR_STATE` of `valid_flags`
    is set.
    """
    antenna_state: AntennaState
    """Electrical condition of the antenna. Valid if `HardwareStatusFlags.ANTENNA_STATE` of
    `valid_flags` is set.
    """
    antenna_power: AntennaPower
    """State of the antenna's power supply. Valid if `HardwareStatusFlags.ANTENNA_POWER` of
    `valid_flags` is set.
    """
    valid_flags: HardwareStatusFlags
    """Validity flags for the hardware status."""

    def __init__(
        self,
        receiver_state: ReceiverState,
        antenna_state: AntennaState,
        antenna_power: AntennaPower,
        valid_flags: HardwareStatusFlags,
    ) -> None:
        self.receiver_state = receiver_state
        self.antenna_state = antenna_state
        self.antenna_power = antenna_power
        self.valid_flags = valid_flags


class DgpsInfo(Shared, Data):
    """DGPS info (0x0E).

    State of the differential corrections.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Distinguished from `DgpsInfoSatellite` by the size of its
    data. Supported by 3DM-GX5-35 and 3DM-GX5-45. Uncertain: Whether any device sends
    `DgpsInfoSatellite`, the layout of the SDK, instead. Only this one agrees with the valid flags,
    which are the same in all sources.

    The sources contradict each other. This layout is in a manual of the 3DM-GX5-35, in MSCL and in
    the SDK of 2014.

    - 3dm-gx5-35: 5.2.12 DGNSS Information (0x81, 0x0E)
    - mscl: DGPS Info (0x81,0x0E)
    - mip-sdk-2014: DGPS Info (0x81,0x0E)
    """

    __slots__ = ("age", "base_station_id", "base_station_status", "num_channels", "valid_flags")
    __match_args__ = (
        "age",
        "base_station_id",
        "base_station_status",
        "num_channels",
        "valid_flags",
    )

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x0E
    NAME = "gnss_data.dgps_info"
    ROLE = "data"
    _LAYOUT = (
        ("age", "f", None),
        ("base_station_id", "h", None),
        ("base_station_status", "h", None),
        ("num_channels", "H", None),
        ("valid_flags", "H", DgpsInfoFlags),
    )

    age: float
    """Age of the corrections. Unit: s. Range: at least 0. Valid if `DgpsInfoFlags.AGE` of
    `valid_flags` is set. Uncertain: The unit, which follows from `DgpsChannel`.
    """
    base_station_id: int
    """Number of the base station. Valid if `DgpsInfoFlags.BASE_STATION_ID` of `valid_flags` is set.
    """
    base_station_status: int
    """State of the base station: 0 to 5 are factors of the user differential range error, which are
    1.0, 0.75, 0.5, 0.3, 0.2 and 0.1; 6 is not monitored, 7 not working. Valid if
    `DgpsInfoFlags.BASE_STATION_STATUS` of `valid_flags` is set.
    """
    num_channels: int
    """Number of channels that have corrections. Unit: 1. Valid if `DgpsInfoFlags.NUM_CHANNELS` of
    `valid_flags` is set.
    """
    valid_flags: DgpsInfoFlags
    """Validity flags for the state of the corrections."""

    def __init__(
        self,
        age: float,
        base_station_id: int,
        base_station_status: int,
        num_channels: int,
        valid_flags: DgpsInfoFlags,
    ) -> None:
        self.age = age
        self.base_station_id = base_station_id
        self.base_station_status = base_station_status
        self.num_channels = num_channels
        self.valid_flags = valid_flags

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return len(data) < 15


class DgpsInfoSatellite(Shared, Data):
    """DGPS info for one satellite (0x0E).

    Differential correction for one satellite, in the SDK's layout of DGPS info.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Distinguished from `DgpsInfo` by the size of its data. Not
    listed in any device profile. Known only from the MicroStrain MIP SDK. Uncertain: Whether any
    device sends it. The values are those of `DgpsChannel`, but the flags are those of `DgpsInfo`,
    so a mistake in the SDK is likely.

    The sources contradict each other. The manual of the 3DM-GX5-35 and MSCL document `DgpsInfo`
    instead. The flags of `base_station_id`, `base_station_status` and `num_channels` correspond to
    no value in this layout.

    - mip-sdk-4: Dgps Info (0x81,0x0E)
    """

    __slots__ = ("satellite_id", "age", "range_correction", "range_rate_correction", "valid_flags")
    __match_args__ = (
        "satellite_id",
        "age",
        "range_correction",
        "range_rate_correction",
        "valid_flags",
    )

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x0E
    NAME = "gnss_data.dgps_info_satellite"
    ROLE = "data"
    _LAYOUT = (
        ("satellite_id", "B", None),
        ("age", "f", None),
        ("range_correction", "f", None),
        ("range_rate_correction", "f", None),
        ("valid_flags", "H", DgpsInfoFlags),
    )

    satellite_id: int
    """Number of the satellite."""
    age: float
    """Age of the correction. Unit: s. Range: at least 0. Valid if `DgpsInfoFlags.AGE` of
    `valid_flags` is set. Uncertain: The unit, which follows from `DgpsChannel`.
    """
    range_correction: float
    """Differential correction of the pseudorange. Unit: m. Uncertain: The unit, which follows from
    `DgpsChannel`.
    """
    range_rate_correction: float
    """Rate of change of the correction. Unit: m/s. Uncertain: The unit, which follows from
    `DgpsChannel`.
    """
    valid_flags: DgpsInfoFlags
    """Validity flags for the state of the corrections."""

    def __init__(
        self,
        satellite_id: int,
        age: float,
        range_correction: float,
        range_rate_correction: float,
        valid_flags: DgpsInfoFlags,
    ) -> None:
        self.satellite_id = satellite_id
        self.age = age
        self.range_correction = range_correction
        self.range_rate_correction = range_rate_correction
        self.valid_flags = valid_flags

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return 15 <= len(data)


class DgpsChannel(Shared, Data):
    """DGPS channel (0x0F).

    Differential correction for one satellite.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Supported by 3DM-GX5-45. Known only from the MIP SDK of 2014,
    MicroStrain Communication Library and MicroStrain MIP SDK.

    Each active satellite is sent as one field, all in one packet.

    - mip-sdk-4: Dgps Channel (0x81,0x0F)
    - mscl: DGPS Channel Status (0x81,0x0F)
    - mip-sdk-2014: DGPS Channel (0x81,0x0F)
    """

    __slots__ = ("satellite_id", "age", "range_correction", "range_rate_correction", "valid_flags")
    __match_args__ = (
        "satellite_id",
        "age",
        "range_correction",
        "range_rate_correction",
        "valid_flags",
    )

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x0F
    NAME = "gnss_data.dgps_channel"
    ROLE = "data"
    _LAYOUT = (
        ("satellite_id", "B", None),
        ("age", "f", None),
        ("range_correction", "f", None),
        ("range_rate_correction", "f", None),
        ("valid_flags", "H", DgpsChannelFlags),
    )

    satellite_id: int
    """Number of the satellite. Valid if `DgpsChannelFlags.SATELLITE_ID` of `valid_flags` is set."""
    age: float
    """Age of the correction. Unit: s. Range: at least 0. Valid if `DgpsChannelFlags.AGE` of
    `valid_flags` is set.
    """
    range_correction: float
    """Differential correction of the pseudorange. Unit: m. Valid if
    `DgpsChannelFlags.RANGE_CORRECTION` of `valid_flags` is set.
    """
    range_rate_correction: float
    """Rate of change of the correction. Unit: m/s. Valid if
    `DgpsChannelFlags.RANGE_RATE_CORRECTION` of `valid_flags` is set.
    """
    valid_flags: DgpsChannelFlags
    """Validity flags for a differential correction."""

    def __init__(
        self,
        satellite_id: int,
        age: float,
        range_correction: float,
        range_rate_correction: float,
        valid_flags: DgpsChannelFlags,
    ) -> None:
        self.satellite_id = satellite_id
        self.age = age
        self.range_correction = range_correction
        self.range_rate_correction = range_rate_correction
        self.valid_flags = valid_flags


class ClockInfo2(Shared, Data):
    """Clock info 2 (0x10).

    Bias and drift of the receiver clock.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Supported by 3DM-CV7-GNSS/INS and 3DM-CV7-INS.

    It supersedes clock info.

    - 3dm-cv7-gnss-ins: Clock Info 2 (0x91,0x10)
    - 3dm-cv7-gnss-ins: Clock Info 2 (0x92,0x10)
    """

    __slots__ = (
        "bias",
        "drift",
        "bias_accuracy_estimate",
        "drift_accuracy_estimate",
        "valid_flags",
    )
    __match_args__ = (
        "bias",
        "drift",
        "bias_accuracy_estimate",
        "drift_accuracy_estimate",
        "valid_flags",
    )

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x10
    NAME = "gnss_data.clock_info_2"
    ROLE = "data"
    _LAYOUT = (
        ("bias", "d", None),
        ("drift", "d", None),
        ("bias_accuracy_estimate", "d", None),
        ("drift_accuracy_estimate", "d", None),
        ("valid_flags", "H", ClockInfo2Flags),
    )

    bias: float
    """Bias of the clock. Unit: s. Valid if `ClockInfo2Flags.BIAS` of `valid_flags` is set."""
    drift: float
    """Drift of the clock. Unit: s/s. Valid if `ClockInfo2Flags.DRIFT` of `valid_flags` is set."""
    bias_accuracy_estimate: float
    """Estimated error of the bias. Unit: s. Range: at least 0. Valid if
    `ClockInfo2Flags.BIAS_ACCURACY` of `valid_flags` is set.
    """
    drift_accuracy_estimate: float
    """Estimated error of the drift. Unit: s/s. Range: at least 0. Valid if
    `ClockInfo2Flags.DRIFT_ACCURACY` of `valid_flags` is set.
    """
    valid_flags: ClockInfo2Flags
    """Validity flags for the clock parameters."""

    def __init__(
        self,
        bias: float,
        drift: float,
        bias_accuracy_estimate: float,
        drift_accuracy_estimate: float,
        valid_flags: ClockInfo2Flags,
    ) -> None:
        self.bias = bias
        self.drift = drift
        self.bias_accuracy_estimate = bias_accuracy_estimate
        self.drift_accuracy_estimate = drift_accuracy_estimate
        self.valid_flags = valid_flags


class GpsLeapSeconds(Shared, Data):
    """GPS leap seconds (0x11).

    Difference between GPS time and UTC.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Supported by 3DM-CV7-GNSS/INS and 3DM-CV7-INS.

    - 3dm-cv7-gnss-ins: GPS Leap Seconds (0x91,0x11)
    - 3dm-cv7-gnss-ins: GPS Leap Seconds (0x92,0x11)
    """

    __slots__ = ("leap_seconds", "valid_flags")
    __match_args__ = ("leap_seconds", "valid_flags")

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x11
    NAME = "gnss_data.gps_leap_seconds"
    ROLE = "data"
    _LAYOUT = (("leap_seconds", "B", None), ("valid_flags", "H", GpsLeapSecondsFlags))

    leap_seconds: int
    """GPS time minus UTC. Unit: s. Valid if `GpsLeapSecondsFlags.LEAP_SECONDS` of `valid_flags` is
    set.
    """
    valid_flags: GpsLeapSecondsFlags
    """Validity of the leap seconds."""

    def __init__(self, leap_seconds: int, valid_flags: GpsLeapSecondsFlags) -> None:
        self.leap_seconds = leap_seconds
        self.valid_flags = valid_flags


class SbasInfo(Shared, Data):
    """SBAS info (0x12).

    Status of the satellite-based augmentation (SBAS).

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Supported by 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS.

    - 3dm-cv7-gnss-ins: SBAS Info (0x91,0x12)
    - 3dm-cv7-gnss-ins: SBAS Info (0x92,0x12)
    """

    __slots__ = (
        "tow",
        "week_number",
        "sbas_system",
        "sbas_id",
        "count",
        "sbas_status",
        "valid_flags",
    )
    __match_args__ = (
        "tow",
        "week_number",
        "sbas_system",
        "sbas_id",
        "count",
        "sbas_status",
        "valid_flags",
    )

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x12
    NAME = "gnss_data.sbas_info"
    ROLE = "data"
    _LAYOUT = (
        ("tow", "d", None),
        ("week_number", "H", None),
        ("sbas_system", "B", SbasSystem),
        ("sbas_id", "B", None),
        ("count", "B", None),
        ("sbas_status", "B", SbasStatus),
        ("valid_flags", "H", SbasInfoFlags),
    )

    tow: float
    """GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if `SbasInfoFlags.TOW`
    of `valid_flags` is set.
    """
    week_number: int
    """GPS week number. Unit: week. Valid if `SbasInfoFlags.WEEK_NUMBER` of `valid_flags` is set."""
    sbas_system: SbasSystem
    """System in use. Valid if `SbasInfoFlags.SBAS_SYSTEM` of `valid_flags` is set."""
    sbas_id: int
    """SBAS satellite. Valid if `SbasInfoFlags.SBAS_ID` of `valid_flags` is set."""
    count: int
    """Number of SBAS corrections. Unit: 1. Valid if `SbasInfoFlags.COUNT` of `valid_flags` is set.
    """
    sbas_status: SbasStatus
    """Status of the service. Valid if `SbasInfoFlags.SBAS_STATUS` of `valid_flags` is set."""
    valid_flags: SbasInfoFlags
    """Validity flags for the SBAS status."""

    def __init__(
        self,
        tow: float,
        week_number: int,
        sbas_system: SbasSystem,
        sbas_id: int,
        count: int,
        sbas_status: SbasStatus,
        valid_flags: SbasInfoFlags,
    ) -> None:
        self.tow = tow
        self.week_number = week_number
        self.sbas_system = sbas_system
        self.sbas_id = sbas_id
        self.count = count
        self.sbas_status = sbas_status
        self.valid_flags = valid_flags


class SbasCorrection(Shared, Data):
    """SBAS correction (0x13).

    SBAS correction for one satellite.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Not listed in any device profile. Known only from the
    MicroStrain MIP SDK.

    An epoch is sent as one field for each satellite; `index` and `count` number the fields. For
    `udrei` 0 to 13, the variances in m^2 are 0.0520, 0.0924, 0.1444, 0.2830, 0.4678, 0.8315,
    1.2992, 1.8709, 2.5465, 3.3260, 5.1968, 20.7870, 230.9661, 2078.695.

    - mip-sdk-4: Sbas Correction (0x81,0x13)
    """

    __slots__ = (
        "index",
        "count",
        "tow",
        "week_number",
        "gnss_id",
        "satellite_id",
        "udrei",
        "pseudorange_correction",
        "iono_correction",
        "valid_flags",
    )
    __match_args__ = (
        "index",
        "count",
        "tow",
        "week_number",
        "gnss_id",
        "satellite_id",
        "udrei",
        "pseudorange_correction",
        "iono_correction",
        "valid_flags",
    )

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x13
    NAME = "gnss_data.sbas_correction"
    ROLE = "data"
    _LAYOUT = (
        ("index", "B", None),
        ("count", "B", None),
        ("tow", "d", None),
        ("week_number", "H", None),
        ("gnss_id", "B", types.GnssConstellation),
        ("satellite_id", "B", None),
        ("udrei", "B", None),
        ("pseudorange_correction", "f", None),
        ("iono_correction", "f", None),
        ("valid_flags", "H", SbasCorrectionFlags),
    )

    index: int
    """Index of this field within the epoch."""
    count: int
    """Number of such fields in the epoch."""
    tow: float
    """GPS time of week of the reception. Unit: s. Range: at least 0, less than 604800."""
    week_number: int
    """GPS week number. Unit: week."""
    gnss_id: types.GnssConstellation
    """Constellation."""
    satellite_id: int
    """Satellite within the constellation."""
    udrei: int
    """Indicator of the range error that remains after fast and long-term corrections, not counting
    the atmosphere; 14 is not monitored, 15 not usable. Range: 0 to 15. Valid if
    `SbasCorrectionFlags.UDREI` of `valid_flags` is set.
    """
    pseudorange_correction: float
    """Correction of the pseudorange by the augmentation system. Unit: m. Valid if
    `SbasCorrectionFlags.PSEUDORANGE_CORRECTION` of `valid_flags` is set.
    """
    iono_correction: float
    """Correction of the ionospheric delay. Unit: m. Valid if `SbasCorrectionFlags.IONO_CORRECTION`
    of `valid_flags` is set.
    """
    valid_flags: SbasCorrectionFlags
    """Validity flags for an SBAS correction."""

    def __init__(
        self,
        index: int,
        count: int,
        tow: float,
        week_number: int,
        gnss_id: types.GnssConstellation,
        satellite_id: int,
        udrei: int,
        pseudorange_correction: float,
        iono_correction: float,
        valid_flags: SbasCorrectionFlags,
    ) -> None:
        self.index = index
        self.count = count
        self.tow = tow
        self.week_number = week_number
        self.gnss_id = gnss_id
        self.satellite_id = satellite_id
        self.udrei = udrei
        self.pseudorange_correction = pseudorange_correction
        self.iono_correction = iono_correction
        self.valid_flags = valid_flags


class RfErrorDetection(Shared, Data):
    """RF error detection (0x14).

    Jamming and spoofing that the receiver detects in one band.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Supported by 3DM-CV7-INS and 3DM-GQ7-GNSS/INS. Known only
    from the MicroStrain MIP SDK.

    Version 4.0.0 of the SDK reserves the two bytes of `frequency`. Firmware from that time sends 0
    there and does not set its flag.

    - mip-sdk-4: Rf Error Detection (0x81,0x14)
    """

    __slots__ = (
        "rf_band",
        "jamming_state",
        "spoofing_state",
        "frequency",
        "reserved",
        "valid_flags",
    )
    __match_args__ = ("rf_band", "jamming_state", "spoofing_state", "frequency", "valid_flags")

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x14
    NAME = "gnss_data.rf_error_detection"
    ROLE = "data"
    _LAYOUT = (
        ("rf_band", "B", RfBand),
        ("jamming_state", "B", JammingState),
        ("spoofing_state", "B", SpoofingState),
        ("frequency", "H", None),
        ("reserved", "BB", tuple),
        ("valid_flags", "H", RfErrorDetectionFlags),
    )

    rf_band: RfBand
    """Band to which the states apply. Valid if `RfErrorDetectionFlags.RF_BAND` of `valid_flags` is
    set.
    """
    jamming_state: JammingState
    """State of jamming in this band. Valid if `RfErrorDetectionFlags.JAMMING_STATE` of
    `valid_flags` is set.
    """
    spoofing_state: SpoofingState
    """State of spoofing in this band. Valid if `RfErrorDetectionFlags.SPOOFING_STATE` of
    `valid_flags` is set.
    """
    frequency: int
    """Centre frequency of the band. Unit: MHz. Valid if `RfErrorDetectionFlags.FREQUENCY` of
    `valid_flags` is set.
    """
    reserved: tuple[int, int]
    """Reserved."""
    valid_flags: RfErrorDetectionFlags
    """Validity flags for the detection."""

    def __init__(
        self,
        rf_band: RfBand,
        jamming_state: JammingState,
        spoofing_state: SpoofingState,
        frequency: int,
        valid_flags: RfErrorDetectionFlags,
        *,
        reserved: Sequence[int] = (0, 0),
    ) -> None:
        self.rf_band = rf_band
        self.jamming_state = jamming_state
        self.spoofing_state = spoofing_state
        self.frequency = frequency
        self.reserved = codec.several(reserved)
        self.valid_flags = valid_flags


class Heading(Shared, Data):
    """GNSS heading (0x15).

    Heading that the receiver computes from its antennas.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Not listed in any device profile. Known only from the
    MicroStrain MIP SDK. Uncertain: Which devices send it. The SDK does not name any.

    - mip-sdk-4: Heading (0x81,0x15)
    """

    __slots__ = ("heading", "uncertainty", "fix_type", "valid_flags")
    __match_args__ = ("heading", "uncertainty", "fix_type", "valid_flags")

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x15
    NAME = "gnss_data.heading"
    ROLE = "data"
    _LAYOUT = (
        ("heading", "f", None),
        ("uncertainty", "f", None),
        ("fix_type", "B", HeadingFixType),
        ("valid_flags", "H", HeadingFlags),
    )

    heading: float
    """Heading of the baseline between the antennas. Unit: deg. Valid if `HeadingFlags.HEADING` of
    `valid_flags` is set. Uncertain: The reference and the range. Clockwise from true north is
    usual; the SDK only states degrees.
    """
    uncertainty: float
    """Uncertainty of the heading. Unit: deg. Range: at least 0. Valid if `HeadingFlags.UNCERTAINTY`
    of `valid_flags` is set. Uncertain: Whether it is one standard deviation.
    """
    fix_type: HeadingFixType
    """Kind of the fix. Valid if `HeadingFlags.FIX_TYPE` of `valid_flags` is set."""
    valid_flags: HeadingFlags
    """Validity flags for the heading."""

    def __init__(
        self,
        heading: float,
        uncertainty: float,
        fix_type: HeadingFixType,
        valid_flags: HeadingFlags,
    ) -> None:
        self.heading = heading
        self.uncertainty = uncertainty
        self.fix_type = fix_type
        self.valid_flags = valid_flags


class SatelliteStatus(Shared, Data):
    """Satellite status (0x20).

    Direction to one satellite, and its health.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Supported by 3DM-CV7-GNSS/INS and 3DM-CV7-INS.

    An epoch is sent as one field for each satellite; `index` and `count` number the fields.

    - 3dm-cv7-gnss-ins: Satellite Status (0x91,0x20)
    - 3dm-cv7-gnss-ins: Satellite Status (0x92,0x20)
    - 3dm-cv7-gnss-ins: Satellite Status (0x94,0x20)
    """

    __slots__ = (
        "index",
        "count",
        "tow",
        "week_number",
        "gnss_id",
        "satellite_id",
        "elevation",
        "azimuth",
        "health",
        "valid_flags",
    )
    __match_args__ = (
        "index",
        "count",
        "tow",
        "week_number",
        "gnss_id",
        "satellite_id",
        "elevation",
        "azimuth",
        "health",
        "valid_flags",
    )

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x20
    NAME = "gnss_data.satellite_status"
    ROLE = "data"
    _LAYOUT = (
        ("index", "B", None),
        ("count", "B", None),
        ("tow", "d", None),
        ("week_number", "H", None),
        ("gnss_id", "B", types.GnssConstellation),
        ("satellite_id", "B", None),
        ("elevation", "f", None),
        ("azimuth", "f", None),
        ("health", "B", codec.truth),
        ("valid_flags", "H", SatelliteStatusFlags),
    )

    index: int
    """Index of this field within the epoch."""
    count: int
    """Number of such fields in the epoch."""
    tow: float
    """GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if
    `SatelliteStatusFlags.TOW` of `valid_flags` is set.
    """
    week_number: int
    """GPS week number. Unit: week. Valid if `SatelliteStatusFlags.WEEK_NUMBER` of `valid_flags` is
    set.
    """
    gnss_id: types.GnssConstellation
    """Constellation. Valid if `SatelliteStatusFlags.GNSS_ID` of `valid_flags` is set."""
    satellite_id: int
    """Satellite within the constellation. Valid if `SatelliteStatusFlags.SATELLITE_ID` of
    `valid_flags` is set.
    """
    elevation: float
    """Elevation, as seen from the rover. Unit: deg. Range: -90 to 90. Valid if
    `SatelliteStatusFlags.ELEVATION` of `valid_flags` is set.
    """
    azimuth: float
    """Azimuth, as seen from the rover. Unit: deg. Valid if `SatelliteStatusFlags.AZIMUTH` of
    `valid_flags` is set.
    """
    health: bool
    """True if the satellite is healthy. Valid if `SatelliteStatusFlags.HEALTH` of `valid_flags` is
    set.
    """
    valid_flags: SatelliteStatusFlags
    """Validity flags for the satellite status."""

    def __init__(
        self,
        index: int,
        count: int,
        tow: float,
        week_number: int,
        gnss_id: types.GnssConstellation,
        satellite_id: int,
        elevation: float,
        azimuth: float,
        health: bool,
        valid_flags: SatelliteStatusFlags,
    ) -> None:
        self.index = index
        self.count = count
        self.tow = tow
        self.week_number = week_number
        self.gnss_id = gnss_id
        self.satellite_id = satellite_id
        self.elevation = elevation
        self.azimuth = azimuth
        self.health = health
        self.valid_flags = valid_flags


class Raw(Shared, Data):
    """Raw (0x22).

    Raw observation of one signal of one satellite.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Supported by 3DM-CV7-GNSS/INS.

    An epoch is sent as one field for each signal; `index` and `count` number the fields. The
    greatest lock time depends on the receiver.

    - 3dm-cv7-gnss-ins: Raw (0x91,0x22)
    - 3dm-cv7-gnss-ins: Raw (0x92,0x22)
    """

    __slots__ = (
        "index",
        "count",
        "tow",
        "week_number",
        "receiver_id",
        "tracking_channel",
        "gnss_id",
        "satellite_id",
        "signal_id",
        "signal_strength",
        "quality",
        "pseudorange",
        "carrier_phase",
        "doppler",
        "range_uncertainty",
        "phase_uncertainty",
        "doppler_uncertainty",
        "lock_time",
        "valid_flags",
    )
    __match_args__ = (
        "index",
        "count",
        "tow",
        "week_number",
        "receiver_id",
        "tracking_channel",
        "gnss_id",
        "satellite_id",
        "signal_id",
        "signal_strength",
        "quality",
        "pseudorange",
        "carrier_phase",
        "doppler",
        "range_uncertainty",
        "phase_uncertainty",
        "doppler_uncertainty",
        "lock_time",
        "valid_flags",
    )

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x22
    NAME = "gnss_data.raw"
    ROLE = "data"
    _LAYOUT = (
        ("index", "B", None),
        ("count", "B", None),
        ("tow", "d", None),
        ("week_number", "H", None),
        ("receiver_id", "H", None),
        ("tracking_channel", "B", None),
        ("gnss_id", "B", types.GnssConstellation),
        ("satellite_id", "B", None),
        ("signal_id", "B", types.GnssSignal),
        ("signal_strength", "f", None),
        ("quality", "B", SignalQuality),
        ("pseudorange", "d", None),
        ("carrier_phase", "d", None),
        ("doppler", "f", None),
        ("range_uncertainty", "f", None),
        ("phase_uncertainty", "f", None),
        ("doppler_uncertainty", "f", None),
        ("lock_time", "f", None),
        ("valid_flags", "H", RawFlags),
    )

    index: int
    """Index of this field within the epoch."""
    count: int
    """Number of such fields in the epoch."""
    tow: float
    """GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if `RawFlags.TOW` of
    `valid_flags` is set.
    """
    week_number: int
    """GPS week number. Unit: week. Valid if `RawFlags.WEEK_NUMBER` of `valid_flags` is set."""
    receiver_id: int
    """Receiver, counted from 1; for a measurement from RTCM, the reference station. Valid if
    `RawFlags.RECEIVER_ID` of `valid_flags` is set.
    """
    tracking_channel: int
    """Channel that tracks the satellite. Valid if `RawFlags.TRACKING_CHANNEL` of `valid_flags` is
    set.
    """
    gnss_id: types.GnssConstellation
    """Constellation. Valid if `RawFlags.GNSS_ID` of `valid_flags` is set."""
    satellite_id: int
    """Satellite within the constellation. Valid if `RawFlags.SATELLITE_ID` of `valid_flags` is set.
    """
    signal_id: types.GnssSignal
    """Signal of the satellite that was tracked. Valid if `RawFlags.SIGNAL_ID` of `valid_flags` is
    set.
    """
    signal_strength: float
    """Carrier to noise density ratio. Unit: dB-Hz. Valid if `RawFlags.SIGNAL_STRENGTH` of
    `valid_flags` is set.
    """
    quality: SignalQuality
    """Tracking quality of the signal. Valid if `RawFlags.QUALITY` of `valid_flags` is set."""
    pseudorange: float
    """Measured distance, with the clock errors of receiver and satellite. Unit: m. Range: at least
    0. Valid if `RawFlags.PSEUDORANGE` of `valid_flags` is set.
    """
    carrier_phase: float
    """Accumulated phase of the carrier; its initial number of cycles is arbitrary. Unit: cycle.
    Valid if `RawFlags.CARRIER_PHASE` of `valid_flags` is set.
    """
    doppler: float
    """Doppler shift. Unit: Hz. Valid if `RawFlags.DOPPLER` of `valid_flags` is set."""
    range_uncertainty: float
    """Uncertainty of the pseudorange. Unit: m. Range: at least 0. Valid if
    `RawFlags.RANGE_UNCERTAINTY` of `valid_flags` is set.
    """
    phase_uncertainty: float
    """Uncertainty of the carrier phase. Unit: cycle. Range: at least 0. Valid if
    `RawFlags.CARRIER_PHASE_UNCERTAINTY` of `valid_flags` is set.
    """
    doppler_uncertainty: float
    """Uncertainty of the Doppler shift. Unit: Hz. Range: at least 0. Valid if
    `RawFlags.DOPPLER_UNCERTAINTY` of `valid_flags` is set.
    """
    lock_time: float
    """Minimum time for which the carrier phase has been locked. Unit: s. Range: at least 0. Valid
    if `RawFlags.LOCK_TIME` of `valid_flags` is set.
    """
    valid_flags: RawFlags
    """Validity flags for the observation."""

    def __init__(
        self,
        index: int,
        count: int,
        tow: float,
        week_number: int,
        receiver_id: int,
        tracking_channel: int,
        gnss_id: types.GnssConstellation,
        satellite_id: int,
        signal_id: types.GnssSignal,
        signal_strength: float,
        quality: SignalQuality,
        pseudorange: float,
        carrier_phase: float,
        doppler: float,
        range_uncertainty: float,
        phase_uncertainty: float,
        doppler_uncertainty: float,
        lock_time: float,
        valid_flags: RawFlags,
    ) -> None:
        self.index = index
        self.count = count
        self.tow = tow
        self.week_number = week_number
        self.receiver_id = receiver_id
        self.tracking_channel = tracking_channel
        self.gnss_id = gnss_id
        self.satellite_id = satellite_id
        self.signal_id = signal_id
        self.signal_strength = signal_strength
        self.quality = quality
        self.pseudorange = pseudorange
        self.carrier_phase = carrier_phase
        self.doppler = doppler
        self.range_uncertainty = range_uncertainty
        self.phase_uncertainty = phase_uncertainty
        self.doppler_uncertainty = doppler_uncertainty
        self.lock_time = lock_time
        self.valid_flags = valid_flags


class BaseStationInfo(Shared, Data):
    """Base station info (0x30).

    Base station that sends the corrections, from RTCM message 1005 or 1006.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Supported by 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS.

    - mip-sdk-4: Base Station Info (0x81,0x30)
    - 3dm-cv7-gnss-ins: Base Station Info (0x93,0x30)
    """

    __slots__ = (
        "tow",
        "week_number",
        "ecef_position",
        "height",
        "station_id",
        "indicators",
        "valid_flags",
    )
    __match_args__ = (
        "tow",
        "week_number",
        "ecef_position",
        "height",
        "station_id",
        "indicators",
        "valid_flags",
    )

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x30
    NAME = "gnss_data.base_station_info"
    ROLE = "data"
    _LAYOUT = (
        ("tow", "d", None),
        ("week_number", "H", None),
        ("ecef_position", "ddd", types.Vector3d),
        ("height", "f", None),
        ("station_id", "H", None),
        ("indicators", "H", BaseStationIndicators),
        ("valid_flags", "H", BaseStationInfoFlags),
    )

    _VECTORS = {"ecef_position": (types.Vector3d,)}

    tow: float
    """GPS time of week at which the message was received. Unit: s. Range: at least 0, less than
    604800. Valid if `BaseStationInfoFlags.TOW` of `valid_flags` is set.
    """
    week_number: int
    """GPS week number. Unit: week. Valid if `BaseStationInfoFlags.WEEK_NUMBER` of `valid_flags` is
    set.
    """
    ecef_position: types.Vector3d
    """Position of the station. Elements: x, y, z. Unit: m. Frame: ecef. Valid if
    `BaseStationInfoFlags.ECEF_POSITION` of `valid_flags` is set.
    """
    height: float
    """Height of the antenna above the surveyed marker. Unit: m. Valid if
    `BaseStationInfoFlags.HEIGHT` of `valid_flags` is set.
    """
    station_id: int
    """Number of the station. Range: 0 to 4095. Valid if `BaseStationInfoFlags.STATION_ID` of
    `valid_flags` is set.
    """
    indicators: BaseStationIndicators
    """Properties of the station. Valid if `BaseStationInfoFlags.INDICATORS` of `valid_flags` is
    set.
    """
    valid_flags: BaseStationInfoFlags
    """Valid values."""

    def __init__(
        self,
        tow: float,
        week_number: int,
        ecef_position: types.Vector3d | codec.Numbers,
        height: float,
        station_id: int,
        indicators: BaseStationIndicators,
        valid_flags: BaseStationInfoFlags,
    ) -> None:
        self.tow = tow
        self.week_number = week_number
        self.ecef_position = codec.vector(ecef_position, types.Vector3d)
        self.height = height
        self.station_id = station_id
        self.indicators = indicators
        self.valid_flags = valid_flags


class RtkCorrectionsStatus(Shared, Data):
    """RTK corrections status (0x31).

    Received corrections and their age.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Supported by 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS.

    - mip-sdk-4: Rtk Corrections Status (0x81,0x31)
    - 3dm-cv7-gnss-ins: RTK Corrections Status (0x93,0x31)
    """

    __slots__ = (
        "tow",
        "week_number",
        "epoch_status",
        "dongle_status",
        "gps_correction_latency",
        "glonass_correction_latency",
        "galileo_correction_latency",
        "beidou_correction_latency",
        "reserved",
        "valid_flags",
    )
    __match_args__ = (
        "tow",
        "week_number",
        "epoch_status",
        "dongle_status",
        "gps_correction_latency",
        "glonass_correction_latency",
        "galileo_correction_latency",
        "beidou_correction_latency",
        "valid_flags",
    )

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x31
    NAME = "gnss_data.rtk_corrections_status"
    ROLE = "data"
    _LAYOUT = (
        ("tow", "d", None),
        ("week_number", "H", None),
        ("epoch_status", "H", RtkEpochStatus),
        ("dongle_status", "I", types.RtkStatusFlags),
        ("gps_correction_latency", "f", None),
        ("glonass_correction_latency", "f", None),
        ("galileo_correction_latency", "f", None),
        ("beidou_correction_latency", "f", None),
        ("reserved", "IIII", tuple),
        ("valid_flags", "H", RtkCorrectionsStatusFlags),
    )

    tow: float
    """GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if
    `RtkCorrectionsStatusFlags.TOW` of `valid_flags` is set.
    """
    week_number: int
    """GPS week number. Unit: week. Valid if `RtkCorrectionsStatusFlags.WEEK_NUMBER` of
    `valid_flags` is set.
    """
    epoch_status: RtkEpochStatus
    """Corrections received during this epoch. Valid if `RtkCorrectionsStatusFlags.EPOCH_STATUS` of
    `valid_flags` is set.
    """
    dongle_status: types.RtkStatusFlags
    """Status flags of the RTK dongle, meaningful only if one is connected. Valid if
    `RtkCorrectionsStatusFlags.DONGLE_STATUS` of `valid_flags` is set. The same word as in the
    response to `rtk.GetStatusFlags`, in one of its two forms.
    """
    gps_correction_latency: float
    """Latency of the last GPS correction. Unit: s. Range: at least 0. Valid if
    `RtkCorrectionsStatusFlags.GPS_LATENCY` of `valid_flags` is set.
    """
    glonass_correction_latency: float
    """Latency of the last GLONASS correction. Unit: s. Range: at least 0. Valid if
    `RtkCorrectionsStatusFlags.GLONASS_LATENCY` of `valid_flags` is set.
    """
    galileo_correction_latency: float
    """Latency of the last Galileo correction. Unit: s. Range: at least 0. Valid if
    `RtkCorrectionsStatusFlags.GALILEO_LATENCY` of `valid_flags` is set.
    """
    beidou_correction_latency: float
    """Latency of the last BeiDou correction. Unit: s. Range: at least 0. Valid if
    `RtkCorrectionsStatusFlags.BEIDOU_LATENCY` of `valid_flags` is set.
    """
    reserved: tuple[int, int, int, int]
    """Reserved."""
    valid_flags: RtkCorrectionsStatusFlags
    """Valid values."""

    def __init__(
        self,
        tow: float,
        week_number: int,
        epoch_status: RtkEpochStatus,
        dongle_status: types.RtkStatusFlags,
        gps_correction_latency: float,
        glonass_correction_latency: float,
        galileo_correction_latency: float,
        beidou_correction_latency: float,
        valid_flags: RtkCorrectionsStatusFlags,
        *,
        reserved: Sequence[int] = (0, 0, 0, 0),
    ) -> None:
        self.tow = tow
        self.week_number = week_number
        self.epoch_status = epoch_status
        self.dongle_status = dongle_status
        self.gps_correction_latency = gps_correction_latency
        self.glonass_correction_latency = glonass_correction_latency
        self.galileo_correction_latency = galileo_correction_latency
        self.beidou_correction_latency = beidou_correction_latency
        self.reserved = codec.several(reserved)
        self.valid_flags = valid_flags


class GpsEphemeris(Shared, Data):
    """GPS ephemeris (0x61).

    Broadcast orbit and clock of one GPS satellite.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Supported by 3DM-CV7-GNSS/INS.

    `iodc` changes with the clock data; according to the manual, it rolls over at 4.

    - 3dm-cv7-gnss-ins: GPS Ephemeris (0x91,0x61)
    - 3dm-cv7-gnss-ins: GPS Ephemeris (0x92,0x61)
    """

    __slots__ = (
        "index",
        "count",
        "tow",
        "week_number",
        "satellite_id",
        "health",
        "iodc",
        "iode",
        "t_oc",
        "af0",
        "af1",
        "af2",
        "t_gd",
        "isc_l1ca",
        "isc_l2c",
        "t_oe",
        "a",
        "a_dot",
        "mean_anomaly",
        "delta_mean_motion",
        "delta_mean_motion_dot",
        "eccentricity",
        "argument_of_perigee",
        "omega",
        "omega_dot",
        "inclination",
        "inclination_dot",
        "c_ic",
        "c_is",
        "c_uc",
        "c_us",
        "c_rc",
        "c_rs",
        "valid_flags",
    )
    __match_args__ = (
        "index",
        "count",
        "tow",
        "week_number",
        "satellite_id",
        "health",
        "iodc",
        "iode",
        "t_oc",
        "af0",
        "af1",
        "af2",
        "t_gd",
        "isc_l1ca",
        "isc_l2c",
        "t_oe",
        "a",
        "a_dot",
        "mean_anomaly",
        "delta_mean_motion",
        "delta_mean_motion_dot",
        "eccentricity",
        "argument_of_perigee",
        "omega",
        "omega_dot",
        "inclination",
        "inclination_dot",
        "c_ic",
        "c_is",
        "c_uc",
        "c_us",
        "c_rc",
        "c_rs",
        "valid_flags",
    )

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x61
    NAME = "gnss_data.gps_ephemeris"
    ROLE = "data"
    _LAYOUT = (
        ("index", "B", None),
        ("count", "B", None),
        ("tow", "d", None),
        ("week_number", "H", None),
        ("satellite_id", "B", None),
        ("health", "B", None),
        ("iodc", "B", None),
        ("iode", "B", None),
        ("t_oc", "d", None),
        ("af0", "d", None),
        ("af1", "d", None),
        ("af2", "d", None),
        ("t_gd", "d", None),
        ("isc_l1ca", "d", None),
        ("isc_l2c", "d", None),
        ("t_oe", "d", None),
        ("a", "d", None),
        ("a_dot", "d", None),
        ("mean_anomaly", "d", None),
        ("delta_mean_motion", "d", None),
        ("delta_mean_motion_dot", "d", None),
        ("eccentricity", "d", None),
        ("argument_of_perigee", "d", None),
        ("omega", "d", None),
        ("omega_dot", "d", None),
        ("inclination", "d", None),
        ("inclination_dot", "d", None),
        ("c_ic", "d", None),
        ("c_is", "d", None),
        ("c_uc", "d", None),
        ("c_us", "d", None),
        ("c_rc", "d", None),
        ("c_rs", "d", None),
        ("valid_flags", "H", EphemerisFlags),
    )

    index: int
    """Index of this field within the epoch."""
    count: int
    """Number of such fields in the epoch."""
    tow: float
    """GPS time of week. Unit: s. Range: at least 0, less than 604800."""
    week_number: int
    """GPS week number. Unit: week."""
    satellite_id: int
    """Satellite within the constellation."""
    health: int
    """Health of satellite and signals. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    iodc: int
    """Issue of data, clock. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags` is set."""
    iode: int
    """Issue of data, ephemeris. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags` is set."""
    t_oc: float
    """Reference time of the clock data. Unit: s. Range: at least 0, less than 604800. Valid if
    `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    af0: float
    """Clock bias. Unit: s. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags` is set."""
    af1: float
    """Clock drift. Unit: s/s. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags` is set."""
    af2: float
    """Clock drift rate. Unit: s/s^2. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    t_gd: float
    """Group delay. Unit: s. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags` is set."""
    isc_l1ca: float
    """Inter-signal correction for L1. Unit: s. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags`
    is set.
    """
    isc_l2c: float
    """Inter-signal correction for L2, or for L5 if `isc_l5` is set. Unit: s. Valid if
    `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    t_oe: float
    """Reference time of the ephemeris. Unit: s. Range: at least 0, less than 604800. Valid if
    `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    a: float
    """Semi-major axis. Unit: m. Range: greater than 0. Valid if `EphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    a_dot: float
    """Rate of the semi-major axis. Unit: m/s. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags`
    is set.
    """
    mean_anomaly: float
    """Mean anomaly at the reference time. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    delta_mean_motion: float
    """Correction of the mean motion. Unit: rad/s. Valid if `EphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    delta_mean_motion_dot: float
    """Rate of the correction of the mean motion. Unit: rad/s^2. Valid if `EphemerisFlags.EPHEMERIS`
    of `valid_flags` is set.
    """
    eccentricity: float
    """Eccentricity of the orbit. Unit: 1. Range: at least 0, less than 1. Valid if
    `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    argument_of_perigee: float
    """Angle from the ascending node to the perigee. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS`
    of `valid_flags` is set.
    """
    omega: float
    """Longitude of the ascending node. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    omega_dot: float
    """Rate of the right ascension. Unit: rad/s. Valid if `EphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    inclination: float
    """Inclination of the orbit at the reference time. Unit: rad. Valid if
    `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    inclination_dot: float
    """Rate of the inclination. Unit: rad/s. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags` is
    set.
    """
    c_ic: float
    """Cosine harmonic correction of the inclination. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS`
    of `valid_flags` is set.
    """
    c_is: float
    """Sine harmonic correction of the inclination. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS`
    of `valid_flags` is set.
    """
    c_uc: float
    """Cosine harmonic correction of the argument of latitude. Unit: rad. Valid if
    `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    c_us: float
    """Sine harmonic correction of the argument of latitude. Unit: rad. Valid if
    `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    c_rc: float
    """Cosine harmonic correction of the orbit radius. Unit: m. Valid if `EphemerisFlags.EPHEMERIS`
    of `valid_flags` is set.
    """
    c_rs: float
    """Sine harmonic correction of the orbit radius. Unit: m. Valid if `EphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    valid_flags: EphemerisFlags
    """Contents of the ephemeris."""

    def __init__(
        self,
        index: int,
        count: int,
        tow: float,
        week_number: int,
        satellite_id: int,
        health: int,
        iodc: int,
        iode: int,
        t_oc: float,
        af0: float,
        af1: float,
        af2: float,
        t_gd: float,
        isc_l1ca: float,
        isc_l2c: float,
        t_oe: float,
        a: float,
        a_dot: float,
        mean_anomaly: float,
        delta_mean_motion: float,
        delta_mean_motion_dot: float,
        eccentricity: float,
        argument_of_perigee: float,
        omega: float,
        omega_dot: float,
        inclination: float,
        inclination_dot: float,
        c_ic: float,
        c_is: float,
        c_uc: float,
        c_us: float,
        c_rc: float,
        c_rs: float,
        valid_flags: EphemerisFlags,
    ) -> None:
        self.index = index
        self.count = count
        self.tow = tow
        self.week_number = week_number
        self.satellite_id = satellite_id
        self.health = health
        self.iodc = iodc
        self.iode = iode
        self.t_oc = t_oc
        self.af0 = af0
        self.af1 = af1
        self.af2 = af2
        self.t_gd = t_gd
        self.isc_l1ca = isc_l1ca
        self.isc_l2c = isc_l2c
        self.t_oe = t_oe
        self.a = a
        self.a_dot = a_dot
        self.mean_anomaly = mean_anomaly
        self.delta_mean_motion = delta_mean_motion
        self.delta_mean_motion_dot = delta_mean_motion_dot
        self.eccentricity = eccentricity
        self.argument_of_perigee = argument_of_perigee
        self.omega = omega
        self.omega_dot = omega_dot
        self.inclination = inclination
        self.inclination_dot = inclination_dot
        self.c_ic = c_ic
        self.c_is = c_is
        self.c_uc = c_uc
        self.c_us = c_us
        self.c_rc = c_rc
        self.c_rs = c_rs
        self.valid_flags = valid_flags


class GlonassEphemeris(Shared, Data):
    """GLONASS ephemeris (0x62).

    Broadcast orbit and clock of one GLONASS satellite.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Also called `glo_ephemeris`. Supported by 3DM-CV7-GNSS/INS.

    The GLONASS interface control document explains p and ft. A period of four years has 1461 days;
    no source states how nt, a u8, counts them.

    - 3dm-cv7-gnss-ins: Glonass Ephemeris (0x91,0x62)
    - 3dm-cv7-gnss-ins: Glonass Ephemeris (0x92,0x62)
    """

    __slots__ = (
        "index",
        "count",
        "tow",
        "week_number",
        "satellite_id",
        "frequency_number",
        "tk",
        "tb",
        "satellite_type",
        "gamma",
        "tau_n",
        "position",
        "velocity",
        "accel",
        "health",
        "p",
        "nt",
        "delta_tau_n",
        "ft",
        "en",
        "p1",
        "p2",
        "p3",
        "p4",
        "valid_flags",
    )
    __match_args__ = (
        "index",
        "count",
        "tow",
        "week_number",
        "satellite_id",
        "frequency_number",
        "tk",
        "tb",
        "satellite_type",
        "gamma",
        "tau_n",
        "position",
        "velocity",
        "accel",
        "health",
        "p",
        "nt",
        "delta_tau_n",
        "ft",
        "en",
        "p1",
        "p2",
        "p3",
        "p4",
        "valid_flags",
    )

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x62
    NAME = "gnss_data.glonass_ephemeris"
    ROLE = "data"
    _LAYOUT = (
        ("index", "B", None),
        ("count", "B", None),
        ("tow", "d", None),
        ("week_number", "H", None),
        ("satellite_id", "B", None),
        ("frequency_number", "b", None),
        ("tk", "I", None),
        ("tb", "I", None),
        ("satellite_type", "B", GlonassSatelliteType),
        ("gamma", "d", None),
        ("tau_n", "d", None),
        ("position", "ddd", types.Vector3d),
        ("velocity", "fff", types.Vector3f),
        ("accel", "fff", types.Vector3f),
        ("health", "B", None),
        ("p", "B", None),
        ("nt", "B", None),
        ("delta_tau_n", "f", None),
        ("ft", "B", None),
        ("en", "B", None),
        ("p1", "B", None),
        ("p2", "B", None),
        ("p3", "B", None),
        ("p4", "B", None),
        ("valid_flags", "H", GlonassEphemerisFlags),
    )

    _VECTORS = {
        "position": (types.Vector3d,),
        "velocity": (types.Vector3f,),
        "accel": (types.Vector3f,),
    }

    index: int
    """Index of this field within the epoch."""
    count: int
    """Number of such fields in the epoch."""
    tow: float
    """GPS time of week. Unit: s. Range: at least 0, less than 604800."""
    week_number: int
    """GPS week number. Unit: week."""
    satellite_id: int
    """Satellite within the constellation."""
    frequency_number: int
    """GLONASS frequency number. Range: -7 to 24. Valid if `GlonassEphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    tk: int
    """Start of the frame within the day. Unit: s. Valid if `GlonassEphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    tb: int
    """Reference time of the ephemeris. Unit: s. Valid if `GlonassEphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    satellite_type: GlonassSatelliteType
    """Generation of the satellite (M). Valid if `GlonassEphemerisFlags.EPHEMERIS` of `valid_flags`
    is set.
    """
    gamma: float
    """Relative deviation of the carrier frequency from its nominal value. Unit: 1. Valid if
    `GlonassEphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    tau_n: float
    """Correction of the satellite time relative to GLONASS time. Unit: s. Valid if
    `GlonassEphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    position: types.Vector3d
    """Position of the satellite in PZ-90. Elements: x, y, z. Unit: m. Valid if
    `GlonassEphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    velocity: types.Vector3f
    """Velocity of the satellite in PZ-90. Elements: x, y, z. Unit: m/s. Valid if
    `GlonassEphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    accel: types.Vector3f
    """Acceleration of the satellite due to perturbations, in PZ-90. Elements: x, y, z. Unit: m/s^2.
    Valid if `GlonassEphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    health: int
    """Health (Bn); nonzero if the satellite is malfunctioning. Valid if
    `GlonassEphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    p: int
    """Mode of operation of the satellite. Valid if `GlonassEphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    nt: int
    """Day within a period of four years. Unit: day. Valid if `GlonassEphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    delta_tau_n: float
    """Time difference between L1 and L2. Unit: s. Valid if `GlonassEphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    ft: int
    """Code of the user range accuracy. Valid if `GlonassEphemerisFlags.EPHEMERIS` of `valid_flags`
    is set.
    """
    en: int
    """Age of the information. Unit: day. Valid if `GlonassEphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    p1: int
    """Time between adjacent values of tb. Unit: min. Valid if `GlonassEphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    p2: int
    """1 if tb is odd, 0 if it is even. Range: 0 to 1. Valid if `GlonassEphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    p3: int
    """Number of satellites in the almanac of the frame. Unit: 1. Valid if
    `GlonassEphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    p4: int
    """Presence of ephemeris parameters. Valid if `GlonassEphemerisFlags.EPHEMERIS` of `valid_flags`
    is set.
    """
    valid_flags: GlonassEphemerisFlags
    """Validity of the ephemeris."""

    def __init__(
        self,
        index: int,
        count: int,
        tow: float,
        week_number: int,
        satellite_id: int,
        frequency_number: int,
        tk: int,
        tb: int,
        satellite_type: GlonassSatelliteType,
        gamma: float,
        tau_n: float,
        position: types.Vector3d | codec.Numbers,
        velocity: types.Vector3f | codec.Numbers,
        accel: types.Vector3f | codec.Numbers,
        health: int,
        p: int,
        nt: int,
        delta_tau_n: float,
        ft: int,
        en: int,
        p1: int,
        p2: int,
        p3: int,
        p4: int,
        valid_flags: GlonassEphemerisFlags,
    ) -> None:
        self.index = index
        self.count = count
        self.tow = tow
        self.week_number = week_number
        self.satellite_id = satellite_id
        self.frequency_number = frequency_number
        self.tk = tk
        self.tb = tb
        self.satellite_type = satellite_type
        self.gamma = gamma
        self.tau_n = tau_n
        self.position = codec.vector(position, types.Vector3d)
        self.velocity = codec.vector(velocity, types.Vector3f)
        self.accel = codec.vector(accel, types.Vector3f)
        self.health = health
        self.p = p
        self.nt = nt
        self.delta_tau_n = delta_tau_n
        self.ft = ft
        self.en = en
        self.p1 = p1
        self.p2 = p2
        self.p3 = p3
        self.p4 = p4
        self.valid_flags = valid_flags


class GalileoEphemeris(Shared, Data):
    """Galileo ephemeris (0x63).

    Broadcast orbit and clock of one Galileo satellite.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Supported by 3DM-CV7-GNSS/INS.

    It has the layout of the GPS ephemeris. No source states what the two inter-signal corrections
    mean here. `iodc` changes with the clock data; according to the manual, it rolls over at 4.

    - 3dm-cv7-gnss-ins: Galileo Ephemeris (0x91,0x63)
    - 3dm-cv7-gnss-ins: Galileo Ephemeris (0x92,0x63)
    """

    __slots__ = (
        "index",
        "count",
        "tow",
        "week_number",
        "satellite_id",
        "health",
        "iodc",
        "iode",
        "t_oc",
        "af0",
        "af1",
        "af2",
        "t_gd",
        "isc_l1ca",
        "isc_l2c",
        "t_oe",
        "a",
        "a_dot",
        "mean_anomaly",
        "delta_mean_motion",
        "delta_mean_motion_dot",
        "eccentricity",
        "argument_of_perigee",
        "omega",
        "omega_dot",
        "inclination",
        "inclination_dot",
        "c_ic",
        "c_is",
        "c_uc",
        "c_us",
        "c_rc",
        "c_rs",
        "valid_flags",
    )
    __match_args__ = (
        "index",
        "count",
        "tow",
        "week_number",
        "satellite_id",
        "health",
        "iodc",
        "iode",
        "t_oc",
        "af0",
        "af1",
        "af2",
        "t_gd",
        "isc_l1ca",
        "isc_l2c",
        "t_oe",
        "a",
        "a_dot",
        "mean_anomaly",
        "delta_mean_motion",
        "delta_mean_motion_dot",
        "eccentricity",
        "argument_of_perigee",
        "omega",
        "omega_dot",
        "inclination",
        "inclination_dot",
        "c_ic",
        "c_is",
        "c_uc",
        "c_us",
        "c_rc",
        "c_rs",
        "valid_flags",
    )

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x63
    NAME = "gnss_data.galileo_ephemeris"
    ROLE = "data"
    _LAYOUT = (
        ("index", "B", None),
        ("count", "B", None),
        ("tow", "d", None),
        ("week_number", "H", None),
        ("satellite_id", "B", None),
        ("health", "B", None),
        ("iodc", "B", None),
        ("iode", "B", None),
        ("t_oc", "d", None),
        ("af0", "d", None),
        ("af1", "d", None),
        ("af2", "d", None),
        ("t_gd", "d", None),
        ("isc_l1ca", "d", None),
        ("isc_l2c", "d", None),
        ("t_oe", "d", None),
        ("a", "d", None),
        ("a_dot", "d", None),
        ("mean_anomaly", "d", None),
        ("delta_mean_motion", "d", None),
        ("delta_mean_motion_dot", "d", None),
        ("eccentricity", "d", None),
        ("argument_of_perigee", "d", None),
        ("omega", "d", None),
        ("omega_dot", "d", None),
        ("inclination", "d", None),
        ("inclination_dot", "d", None),
        ("c_ic", "d", None),
        ("c_is", "d", None),
        ("c_uc", "d", None),
        ("c_us", "d", None),
        ("c_rc", "d", None),
        ("c_rs", "d", None),
        ("valid_flags", "H", EphemerisFlags),
    )

    index: int
    """Index of this field within the epoch."""
    count: int
    """Number of such fields in the epoch."""
    tow: float
    """GPS time of week. Unit: s. Range: at least 0, less than 604800."""
    week_number: int
    """GPS week number. Unit: week."""
    satellite_id: int
    """Satellite within the constellation."""
    health: int
    """Health of satellite and signals. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    iodc: int
    """Issue of data, clock. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags` is set."""
    iode: int
    """Issue of data, ephemeris. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags` is set."""
    t_oc: float
    """Reference time of the clock data. Unit: s. Range: at least 0, less than 604800. Valid if
    `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    af0: float
    """Clock bias. Unit: s. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags` is set."""
    af1: float
    """Clock drift. Unit: s/s. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags` is set."""
    af2: float
    """Clock drift rate. Unit: s/s^2. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    t_gd: float
    """Group delay. Unit: s. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags` is set."""
    isc_l1ca: float
    """Value in the position of the GPS inter-signal correction for L1. Unit: s. Valid if
    `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    isc_l2c: float
    """Value in the position of the GPS inter-signal correction for L2 or L5. Unit: s. Valid if
    `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    t_oe: float
    """Reference time of the ephemeris. Unit: s. Range: at least 0, less than 604800. Valid if
    `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    a: float
    """Semi-major axis. Unit: m. Range: greater than 0. Valid if `EphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    a_dot: float
    """Rate of the semi-major axis. Unit: m/s. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags`
    is set.
    """
    mean_anomaly: float
    """Mean anomaly at the reference time. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    delta_mean_motion: float
    """Correction of the mean motion. Unit: rad/s. Valid if `EphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    delta_mean_motion_dot: float
    """Rate of the correction of the mean motion. Unit: rad/s^2. Valid if `EphemerisFlags.EPHEMERIS`
    of `valid_flags` is set.
    """
    eccentricity: float
    """Eccentricity of the orbit. Unit: 1. Range: at least 0, less than 1. Valid if
    `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    argument_of_perigee: float
    """Angle from the ascending node to the perigee. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS`
    of `valid_flags` is set.
    """
    omega: float
    """Longitude of the ascending node. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    omega_dot: float
    """Rate of the right ascension. Unit: rad/s. Valid if `EphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    inclination: float
    """Inclination of the orbit at the reference time. Unit: rad. Valid if
    `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    inclination_dot: float
    """Rate of the inclination. Unit: rad/s. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags` is
    set.
    """
    c_ic: float
    """Cosine harmonic correction of the inclination. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS`
    of `valid_flags` is set.
    """
    c_is: float
    """Sine harmonic correction of the inclination. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS`
    of `valid_flags` is set.
    """
    c_uc: float
    """Cosine harmonic correction of the argument of latitude. Unit: rad. Valid if
    `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    c_us: float
    """Sine harmonic correction of the argument of latitude. Unit: rad. Valid if
    `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    c_rc: float
    """Cosine harmonic correction of the orbit radius. Unit: m. Valid if `EphemerisFlags.EPHEMERIS`
    of `valid_flags` is set.
    """
    c_rs: float
    """Sine harmonic correction of the orbit radius. Unit: m. Valid if `EphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    valid_flags: EphemerisFlags
    """Contents of the ephemeris."""

    def __init__(
        self,
        index: int,
        count: int,
        tow: float,
        week_number: int,
        satellite_id: int,
        health: int,
        iodc: int,
        iode: int,
        t_oc: float,
        af0: float,
        af1: float,
        af2: float,
        t_gd: float,
        isc_l1ca: float,
        isc_l2c: float,
        t_oe: float,
        a: float,
        a_dot: float,
        mean_anomaly: float,
        delta_mean_motion: float,
        delta_mean_motion_dot: float,
        eccentricity: float,
        argument_of_perigee: float,
        omega: float,
        omega_dot: float,
        inclination: float,
        inclination_dot: float,
        c_ic: float,
        c_is: float,
        c_uc: float,
        c_us: float,
        c_rc: float,
        c_rs: float,
        valid_flags: EphemerisFlags,
    ) -> None:
        self.index = index
        self.count = count
        self.tow = tow
        self.week_number = week_number
        self.satellite_id = satellite_id
        self.health = health
        self.iodc = iodc
        self.iode = iode
        self.t_oc = t_oc
        self.af0 = af0
        self.af1 = af1
        self.af2 = af2
        self.t_gd = t_gd
        self.isc_l1ca = isc_l1ca
        self.isc_l2c = isc_l2c
        self.t_oe = t_oe
        self.a = a
        self.a_dot = a_dot
        self.mean_anomaly = mean_anomaly
        self.delta_mean_motion = delta_mean_motion
        self.delta_mean_motion_dot = delta_mean_motion_dot
        self.eccentricity = eccentricity
        self.argument_of_perigee = argument_of_perigee
        self.omega = omega
        self.omega_dot = omega_dot
        self.inclination = inclination
        self.inclination_dot = inclination_dot
        self.c_ic = c_ic
        self.c_is = c_is
        self.c_uc = c_uc
        self.c_us = c_us
        self.c_rc = c_rc
        self.c_rs = c_rs
        self.valid_flags = valid_flags


class BeidouEphemeris(Shared, Data):
    """BeiDou ephemeris (0x64).

    Broadcast orbit and clock of one BeiDou satellite.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Supported by 3DM-CV7-GNSS/INS.

    It has the layout of the GPS ephemeris. No source states what the two inter-signal corrections
    mean here. `iodc` changes with the clock data; according to the manual, it rolls over at 4.

    - 3dm-cv7-gnss-ins: BeiDou Ephemeris (0x91,0x64)
    - 3dm-cv7-gnss-ins: BeiDou Ephemeris (0x92,0x64)
    """

    __slots__ = (
        "index",
        "count",
        "tow",
        "week_number",
        "satellite_id",
        "health",
        "iodc",
        "iode",
        "t_oc",
        "af0",
        "af1",
        "af2",
        "t_gd",
        "isc_l1ca",
        "isc_l2c",
        "t_oe",
        "a",
        "a_dot",
        "mean_anomaly",
        "delta_mean_motion",
        "delta_mean_motion_dot",
        "eccentricity",
        "argument_of_perigee",
        "omega",
        "omega_dot",
        "inclination",
        "inclination_dot",
        "c_ic",
        "c_is",
        "c_uc",
        "c_us",
        "c_rc",
        "c_rs",
        "valid_flags",
    )
    __match_args__ = (
        "index",
        "count",
        "tow",
        "week_number",
        "satellite_id",
        "health",
        "iodc",
        "iode",
        "t_oc",
        "af0",
        "af1",
        "af2",
        "t_gd",
        "isc_l1ca",
        "isc_l2c",
        "t_oe",
        "a",
        "a_dot",
        "mean_anomaly",
        "delta_mean_motion",
        "delta_mean_motion_dot",
        "eccentricity",
        "argument_of_perigee",
        "omega",
        "omega_dot",
        "inclination",
        "inclination_dot",
        "c_ic",
        "c_is",
        "c_uc",
        "c_us",
        "c_rc",
        "c_rs",
        "valid_flags",
    )

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x64
    NAME = "gnss_data.beidou_ephemeris"
    ROLE = "data"
    _LAYOUT = (
        ("index", "B", None),
        ("count", "B", None),
        ("tow", "d", None),
        ("week_number", "H", None),
        ("satellite_id", "B", None),
        ("health", "B", None),
        ("iodc", "B", None),
        ("iode", "B", None),
        ("t_oc", "d", None),
        ("af0", "d", None),
        ("af1", "d", None),
        ("af2", "d", None),
        ("t_gd", "d", None),
        ("isc_l1ca", "d", None),
        ("isc_l2c", "d", None),
        ("t_oe", "d", None),
        ("a", "d", None),
        ("a_dot", "d", None),
        ("mean_anomaly", "d", None),
        ("delta_mean_motion", "d", None),
        ("delta_mean_motion_dot", "d", None),
        ("eccentricity", "d", None),
        ("argument_of_perigee", "d", None),
        ("omega", "d", None),
        ("omega_dot", "d", None),
        ("inclination", "d", None),
        ("inclination_dot", "d", None),
        ("c_ic", "d", None),
        ("c_is", "d", None),
        ("c_uc", "d", None),
        ("c_us", "d", None),
        ("c_rc", "d", None),
        ("c_rs", "d", None),
        ("valid_flags", "H", EphemerisFlags),
    )

    index: int
    """Index of this field within the epoch."""
    count: int
    """Number of such fields in the epoch."""
    tow: float
    """GPS time of week. Unit: s. Range: at least 0, less than 604800."""
    week_number: int
    """GPS week number. Unit: week."""
    satellite_id: int
    """Satellite within the constellation."""
    health: int
    """Health of satellite and signals. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    iodc: int
    """Issue of data, clock. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags` is set."""
    iode: int
    """Issue of data, ephemeris. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags` is set."""
    t_oc: float
    """Reference time of the clock data. Unit: s. Range: at least 0, less than 604800. Valid if
    `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    af0: float
    """Clock bias. Unit: s. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags` is set."""
    af1: float
    """Clock drift. Unit: s/s. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags` is set."""
    af2: float
    """Clock drift rate. Unit: s/s^2. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    t_gd: float
    """Group delay. Unit: s. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags` is set."""
    isc_l1ca: float
    """Value in the position of the GPS inter-signal correction for L1. Unit: s. Valid if
    `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    isc_l2c: float
    """Value in the position of the GPS inter-signal correction for L2 or L5. Unit: s. Valid if
    `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    t_oe: float
    """Reference time of the ephemeris. Unit: s. Range: at least 0, less than 604800. Valid if
    `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    a: float
    """Semi-major axis. Unit: m. Range: greater than 0. Valid if `EphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    a_dot: float
    """Rate of the semi-major axis. Unit: m/s. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags`
    is set.
    """
    mean_anomaly: float
    """Mean anomaly at the reference time. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    delta_mean_motion: float
    """Correction of the mean motion. Unit: rad/s. Valid if `EphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    delta_mean_motion_dot: float
    """Rate of the correction of the mean motion. Unit: rad/s^2. Valid if `EphemerisFlags.EPHEMERIS`
    of `valid_flags` is set.
    """
    eccentricity: float
    """Eccentricity of the orbit. Unit: 1. Range: at least 0, less than 1. Valid if
    `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    argument_of_perigee: float
    """Angle from the ascending node to the perigee. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS`
    of `valid_flags` is set.
    """
    omega: float
    """Longitude of the ascending node. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    omega_dot: float
    """Rate of the right ascension. Unit: rad/s. Valid if `EphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    inclination: float
    """Inclination of the orbit at the reference time. Unit: rad. Valid if
    `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    inclination_dot: float
    """Rate of the inclination. Unit: rad/s. Valid if `EphemerisFlags.EPHEMERIS` of `valid_flags` is
    set.
    """
    c_ic: float
    """Cosine harmonic correction of the inclination. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS`
    of `valid_flags` is set.
    """
    c_is: float
    """Sine harmonic correction of the inclination. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS`
    of `valid_flags` is set.
    """
    c_uc: float
    """Cosine harmonic correction of the argument of latitude. Unit: rad. Valid if
    `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    c_us: float
    """Sine harmonic correction of the argument of latitude. Unit: rad. Valid if
    `EphemerisFlags.EPHEMERIS` of `valid_flags` is set.
    """
    c_rc: float
    """Cosine harmonic correction of the orbit radius. Unit: m. Valid if `EphemerisFlags.EPHEMERIS`
    of `valid_flags` is set.
    """
    c_rs: float
    """Sine harmonic correction of the orbit radius. Unit: m. Valid if `EphemerisFlags.EPHEMERIS` of
    `valid_flags` is set.
    """
    valid_flags: EphemerisFlags
    """Contents of the ephemeris."""

    def __init__(
        self,
        index: int,
        count: int,
        tow: float,
        week_number: int,
        satellite_id: int,
        health: int,
        iodc: int,
        iode: int,
        t_oc: float,
        af0: float,
        af1: float,
        af2: float,
        t_gd: float,
        isc_l1ca: float,
        isc_l2c: float,
        t_oe: float,
        a: float,
        a_dot: float,
        mean_anomaly: float,
        delta_mean_motion: float,
        delta_mean_motion_dot: float,
        eccentricity: float,
        argument_of_perigee: float,
        omega: float,
        omega_dot: float,
        inclination: float,
        inclination_dot: float,
        c_ic: float,
        c_is: float,
        c_uc: float,
        c_us: float,
        c_rc: float,
        c_rs: float,
        valid_flags: EphemerisFlags,
    ) -> None:
        self.index = index
        self.count = count
        self.tow = tow
        self.week_number = week_number
        self.satellite_id = satellite_id
        self.health = health
        self.iodc = iodc
        self.iode = iode
        self.t_oc = t_oc
        self.af0 = af0
        self.af1 = af1
        self.af2 = af2
        self.t_gd = t_gd
        self.isc_l1ca = isc_l1ca
        self.isc_l2c = isc_l2c
        self.t_oe = t_oe
        self.a = a
        self.a_dot = a_dot
        self.mean_anomaly = mean_anomaly
        self.delta_mean_motion = delta_mean_motion
        self.delta_mean_motion_dot = delta_mean_motion_dot
        self.eccentricity = eccentricity
        self.argument_of_perigee = argument_of_perigee
        self.omega = omega
        self.omega_dot = omega_dot
        self.inclination = inclination
        self.inclination_dot = inclination_dot
        self.c_ic = c_ic
        self.c_is = c_is
        self.c_uc = c_uc
        self.c_us = c_us
        self.c_rc = c_rc
        self.c_rs = c_rs
        self.valid_flags = valid_flags


class GpsIonoCorrection(Shared, Data):
    """GPS ionospheric correction (0x71).

    Ionospheric model that GPS broadcasts.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Also called `gps_iono_corr`. Not listed in any device
    profile. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: Gps Iono Corr (0x81,0x71)
    """

    __slots__ = ("tow", "week_number", "alpha", "beta", "valid_flags")
    __match_args__ = ("tow", "week_number", "alpha", "beta", "valid_flags")

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x71
    NAME = "gnss_data.gps_iono_correction"
    ROLE = "data"
    _LAYOUT = (
        ("tow", "d", None),
        ("week_number", "H", None),
        ("alpha", "dddd", tuple),
        ("beta", "dddd", tuple),
        ("valid_flags", "H", GpsIonoCorrectionFlags),
    )

    tow: float
    """GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if
    `GpsIonoCorrectionFlags.TOW` of `valid_flags` is set.
    """
    week_number: int
    """GPS week number. Unit: week. Valid if `GpsIonoCorrectionFlags.WEEK_NUMBER` of `valid_flags`
    is set.
    """
    alpha: tuple[float, float, float, float]
    """Coefficients alpha 0 to 3. Valid if `GpsIonoCorrectionFlags.ALPHA` of `valid_flags` is set.
    Uncertain: The units.
    """
    beta: tuple[float, float, float, float]
    """Coefficients beta 0 to 3. Valid if `GpsIonoCorrectionFlags.BETA` of `valid_flags` is set.
    Uncertain: The units.
    """
    valid_flags: GpsIonoCorrectionFlags
    """Validity flags for the model."""

    def __init__(
        self,
        tow: float,
        week_number: int,
        alpha: Sequence[float],
        beta: Sequence[float],
        valid_flags: GpsIonoCorrectionFlags,
    ) -> None:
        self.tow = tow
        self.week_number = week_number
        self.alpha = codec.several(alpha)
        self.beta = codec.several(beta)
        self.valid_flags = valid_flags


class GalileoIonoCorrection(Shared, Data):
    """Galileo ionospheric correction (0x73).

    Ionospheric model that Galileo broadcasts.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Also called `galileo_iono_corr`. Not listed in any device
    profile. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: Galileo Iono Corr (0x81,0x73)
    """

    __slots__ = ("tow", "week_number", "alpha", "disturbance_flags", "valid_flags")
    __match_args__ = ("tow", "week_number", "alpha", "disturbance_flags", "valid_flags")

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x73
    NAME = "gnss_data.galileo_iono_correction"
    ROLE = "data"
    _LAYOUT = (
        ("tow", "d", None),
        ("week_number", "H", None),
        ("alpha", "ddd", tuple),
        ("disturbance_flags", "B", None),
        ("valid_flags", "H", GalileoIonoCorrectionFlags),
    )

    tow: float
    """GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if
    `GalileoIonoCorrectionFlags.TOW` of `valid_flags` is set.
    """
    week_number: int
    """GPS week number. Unit: week. Valid if `GalileoIonoCorrectionFlags.WEEK_NUMBER` of
    `valid_flags` is set.
    """
    alpha: tuple[float, float, float]
    """The three coefficients of the model. Valid if `GalileoIonoCorrectionFlags.ALPHA` of
    `valid_flags` is set. Uncertain: The units.
    """
    disturbance_flags: int
    """Ionospheric storms, one bit (1 to 5) for each of five regions. Valid if
    `GalileoIonoCorrectionFlags.DISTURBANCE_FLAGS` of `valid_flags` is set. Uncertain: Whether the
    bits count from 0 or from 1, and which region each represents.
    """
    valid_flags: GalileoIonoCorrectionFlags
    """Validity flags for the model."""

    def __init__(
        self,
        tow: float,
        week_number: int,
        alpha: Sequence[float],
        disturbance_flags: int,
        valid_flags: GalileoIonoCorrectionFlags,
    ) -> None:
        self.tow = tow
        self.week_number = week_number
        self.alpha = codec.several(alpha)
        self.disturbance_flags = disturbance_flags
        self.valid_flags = valid_flags


class BeidouIonoCorrection(Shared, Data):
    """BeiDou ionospheric correction (0x74).

    Ionospheric model that BeiDou broadcasts.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Also called `beidou_iono_corr`. Not listed in any device
    profile. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: Beidou Iono Corr (0x81,0x74)
    """

    __slots__ = ("tow", "week_number", "alpha", "beta", "alpha_correction", "valid_flags")
    __match_args__ = ("tow", "week_number", "alpha", "beta", "alpha_correction", "valid_flags")

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x74
    NAME = "gnss_data.beidou_iono_correction"
    ROLE = "data"
    _LAYOUT = (
        ("tow", "d", None),
        ("week_number", "H", None),
        ("alpha", "dddd", tuple),
        ("beta", "dddd", tuple),
        ("alpha_correction", "ddddddddd", tuple),
        ("valid_flags", "H", BeidouIonoCorrectionFlags),
    )

    tow: float
    """GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if
    `BeidouIonoCorrectionFlags.TOW` of `valid_flags` is set.
    """
    week_number: int
    """GPS week number. Unit: week. Valid if `BeidouIonoCorrectionFlags.WEEK_NUMBER` of
    `valid_flags` is set.
    """
    alpha: tuple[float, float, float, float]
    """Coefficients alpha 0 to 3. Valid if `BeidouIonoCorrectionFlags.ALPHA` of `valid_flags` is
    set. Uncertain: The units.
    """
    beta: tuple[float, float, float, float]
    """Coefficients beta 0 to 3. Valid if `BeidouIonoCorrectionFlags.BETA` of `valid_flags` is set.
    Uncertain: The units.
    """
    alpha_correction: tuple[float, ...]
    """Nine further coefficients of the delay. Valid if `BeidouIonoCorrectionFlags.ALPHA_CORRECTION`
    of `valid_flags` is set. Uncertain: The units.
    """
    valid_flags: BeidouIonoCorrectionFlags
    """Validity flags for the model."""

    def __init__(
        self,
        tow: float,
        week_number: int,
        alpha: Sequence[float],
        beta: Sequence[float],
        alpha_correction: Sequence[float],
        valid_flags: BeidouIonoCorrectionFlags,
    ) -> None:
        self.tow = tow
        self.week_number = week_number
        self.alpha = codec.several(alpha)
        self.beta = codec.several(beta)
        self.alpha_correction = codec.several(alpha_correction)
        self.valid_flags = valid_flags


#: Descriptor -> its types; several if constants or the size of the data distinguish layouts.
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
    0x0E: (DgpsInfo, DgpsInfoSatellite),
    0x0F: (DgpsChannel,),
    0x10: (ClockInfo2,),
    0x11: (GpsLeapSeconds,),
    0x12: (SbasInfo,),
    0x13: (SbasCorrection,),
    0x14: (RfErrorDetection,),
    0x15: (Heading,),
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
