"""GNSS data (0x81, 0x91, 0x92, 0x93, 0x94, 0x95).

Measurements and status of GNSS receivers. Each receiver has a descriptor set; all have the same
fields.

Uncertain: Some devices may not send a field in every set: the SDK lists the same fields for all
GNSS data sets, the manuals fewer.

- gnss_data (0x81): Measurements and status of the GNSS receiver of 4-series and 5-series devices.
- gnss_1 (0x91): Measurements and status of the first internal GNSS receiver.
- gnss_2 (0x92): Measurements and status of the second internal GNSS receiver.
- gnss_corrections (0x93): RTK corrections that the device receives. Data is sent as it is received.
- gnss_external (0x94): Data that an external GNSS receiver sends to the device in NMEA sentences. A
  field may need several sentences; a value that NMEA does not provide is not valid. Times are taken
  from the sentences.
- gnss_external_2 (0x95): Data that a second external GNSS receiver sends to the device. Uncertain:
  The name is from a page on the 3DM-CV7-INS that the vendor published for trial; the SDK calls the
  set GNSS 5.
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import IntFlag
from typing import Any

from . import codec, types
from .field import Data, Field, Shared

# Numbers that are read and written together, by their letters for `struct`.
_2B2H = codec.Block("2B2H")

_2BH2h2H = codec.Block("2BH2h2H")

_2Bd2H4BfB2d5fH = codec.Block("2Bd2H4BfB2d5fH")

_2BdH2B2fBH = codec.Block("2BdH2B2fBH")

_2BdH3B2fH = codec.Block("2BdH3B2fH")

_2BdH4B25dH = codec.Block("2BdH4B25dH")

_2BdHBb2IB5d6f3Bf6BH = codec.Block("2BdHBb2IB5d6f3Bf6BH")

_2fBH = codec.Block("2fBH")

_3BH = codec.Block("3BH")

_3BH2BH = codec.Block("3BH2BH")

_3dH = codec.Block("3dH")

_3dfH = codec.Block("3dfH")

_4d2fH = codec.Block("4d2fH")

_4dH = codec.Block("4dH")

_4fH = codec.Block("4fH")

_7fH = codec.Block("7fH")

_8fH = codec.Block("8fH")

_B3fH = codec.Block("B3fH")

_BH = codec.Block("BH")

_H5BIH = codec.Block("H5BIH")

_d2H = codec.Block("d2H")

_d2HI4f4IH = codec.Block("d2HI4f4IH")

_dH17dH = codec.Block("dH17dH")

_dH3dBH = codec.Block("dH3dBH")

_dH3df3H = codec.Block("dH3df3H")

_dH4BH = codec.Block("dH4BH")

_dH8dH = codec.Block("dH8dH")

_f2h2H = codec.Block("f2h2H")


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
    """Date and time come from GNSS, and the leap seconds are known. Bits 0 to 1. Overlaps other
    bits.
    """


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
    """The ephemeris is valid, with modernized data and the correction for L5. Bits 0 to 2. Overlaps
    other bits.
    """


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
    (0x94) and gnss_external_2 (0x95). Also called `pos_llh`. Confirmed on 3DM-CV7-GNSS/INS,
    3DM-CV7-INS and 3DM-GQ7-GNSS/INS; likely or assumed on 11 more.

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
    _SIZE = 42

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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _4d2fH.unpack(raw, at)
        if (total := v[4] + v[5]) != total:
            v = _4d2fH.keep_nan_bits(v, raw, at)
        self.latitude = v[0]
        self.longitude = v[1]
        self.ellipsoid_height = v[2]
        self.msl_height = v[3]
        self.horizontal_accuracy = v[4]
        self.vertical_accuracy = v[5]
        self.valid_flags = codec.KNOWN[LlhPositionFlags][v[6]]
        return at + 42

    def _write(self) -> bytes:
        return _4d2fH.write(
            "latitude longitude ellipsoid_height msl_height horizontal_accuracy vertical_accuracy valid_flags",
            self.latitude,
            self.longitude,
            self.ellipsoid_height,
            self.msl_height,
            self.horizontal_accuracy,
            self.vertical_accuracy,
            self.valid_flags,
        )


class EcefPosition(Shared, Data):
    """GNSS ECEF position (0x04).

    GNSS position in Earth-fixed coordinates.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Also called `pos_ecef`. Confirmed on 3DM-CV7-GNSS/INS,
    3DM-CV7-INS and 3DM-GQ7-GNSS/INS; likely or assumed on 3 more.

    - 3dm-cv7-gnss-ins: GNSS ECEF Position (0x91,0x04)
    - 3dm-cv7-gnss-ins: GNSS ECEF Position (0x92,0x04)
    """

    __slots__ = ("position", "position_accuracy", "valid_flags")
    __match_args__ = ("position", "position_accuracy", "valid_flags")

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x04
    NAME = "gnss_data.ecef_position"
    _SIZE = 30
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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _3dfH.unpack(raw, at)
        if v[3] != v[3]:
            v = _3dfH.keep_nan_bits(v, raw, at)
        self._position = v[:3]
        self.position_accuracy = v[3]
        self.valid_flags = codec.KNOWN[EcefPositionFlags][v[4]]
        return at + 30

    def _write(self) -> bytes:
        return _3dfH.write(
            "position*3 position_accuracy valid_flags",
            *codec.elements("position", self.position, 3),
            self.position_accuracy,
            self.valid_flags,
        )


class NedVelocity(Shared, Data):
    """NED velocity (0x05).

    GNSS velocity in the local level frame.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Also called `vel_ned`. Confirmed on 3DM-CV7-GNSS/INS,
    3DM-CV7-INS and 3DM-GQ7-GNSS/INS; likely or assumed on 11 more.

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
    _SIZE = 34
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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _8fH.unpack(raw, at)
        if (total := sum(v[0:8])) != total:
            v = _8fH.keep_nan_bits(v, raw, at)
        self._velocity = v[:3]
        self.speed = v[3]
        self.ground_speed = v[4]
        self.heading = v[5]
        self.speed_accuracy = v[6]
        self.heading_accuracy = v[7]
        self.valid_flags = codec.KNOWN[NedVelocityFlags][v[8]]
        return at + 34

    def _write(self) -> bytes:
        return _8fH.write(
            "velocity*3 speed ground_speed heading speed_accuracy heading_accuracy valid_flags",
            *codec.elements("velocity", self.velocity, 3),
            self.speed,
            self.ground_speed,
            self.heading,
            self.speed_accuracy,
            self.heading_accuracy,
            self.valid_flags,
        )


class EcefVelocity(Shared, Data):
    """GNSS ECEF velocity (0x06).

    GNSS velocity in Earth-fixed coordinates.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Also called `vel_ecef`. Confirmed on 3DM-CV7-GNSS/INS,
    3DM-CV7-INS, 3DM-GQ7-GNSS/INS and 3DM-GX5-35; likely or assumed on 2 more.

    - 3dm-gx5-35: 5.2.4 ECEF Velocity (0x81, 0x06)
    - 3dm-cv7-gnss-ins: GNSS ECEF Velocity (0x91,0x06)
    - 3dm-cv7-gnss-ins: GNSS ECEF Velocity (0x92,0x06)
    """

    __slots__ = ("velocity", "velocity_accuracy", "valid_flags")
    __match_args__ = ("velocity", "velocity_accuracy", "valid_flags")

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x06
    NAME = "gnss_data.ecef_velocity"
    _SIZE = 18
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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _4fH.unpack(raw, at)
        if (total := v[0] + v[1] + v[2] + v[3]) != total:
            v = _4fH.keep_nan_bits(v, raw, at)
        self._velocity = v[:3]
        self.velocity_accuracy = v[3]
        self.valid_flags = codec.KNOWN[EcefVelocityFlags][v[4]]
        return at + 18

    def _write(self) -> bytes:
        return _4fH.write(
            "velocity*3 velocity_accuracy valid_flags",
            *codec.elements("velocity", self.velocity, 3),
            self.velocity_accuracy,
            self.valid_flags,
        )


class Dop(Shared, Data):
    """DOP (0x07).

    Dilution of precision of the satellite geometry.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Confirmed on 3DM-CV7-GNSS/INS and 3DM-CV7-INS; likely or
    assumed on 4 more.

    - 3dm-cv7-gnss-ins: DOP (0x91,0x07)
    - 3dm-cv7-gnss-ins: DOP (0x92,0x07)
    """

    __slots__ = ("gdop", "pdop", "hdop", "vdop", "tdop", "ndop", "edop", "valid_flags")
    __match_args__ = ("gdop", "pdop", "hdop", "vdop", "tdop", "ndop", "edop", "valid_flags")

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x07
    NAME = "gnss_data.dop"
    _SIZE = 30

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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _7fH.unpack(raw, at)
        if (total := sum(v[0:7])) != total:
            v = _7fH.keep_nan_bits(v, raw, at)
        self.gdop = v[0]
        self.pdop = v[1]
        self.hdop = v[2]
        self.vdop = v[3]
        self.tdop = v[4]
        self.ndop = v[5]
        self.edop = v[6]
        self.valid_flags = codec.KNOWN[DopFlags][v[7]]
        return at + 30

    def _write(self) -> bytes:
        return _7fH.write(
            "gdop pdop hdop vdop tdop ndop edop valid_flags",
            self.gdop,
            self.pdop,
            self.hdop,
            self.vdop,
            self.tdop,
            self.ndop,
            self.edop,
            self.valid_flags,
        )


class UtcTime(Shared, Data):
    """UTC time (0x08).

    Coordinated universal time (UTC) according to the receiver.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Confirmed on 3DM-CV7-GNSS/INS and 3DM-CV7-INS; likely or
    assumed on 6 more.

    - 3dm-cv7-gnss-ins: UTC Time (0x91,0x08)
    - 3dm-cv7-gnss-ins: UTC Time (0x92,0x08)
    - 3dm-cv7-gnss-ins: UTC Time (0x94,0x08)
    """

    __slots__ = ("year", "month", "day", "hour", "min", "sec", "msec", "valid_flags")
    __match_args__ = ("year", "month", "day", "hour", "min", "sec", "msec", "valid_flags")

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x08
    NAME = "gnss_data.utc_time"
    _SIZE = 13

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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _H5BIH.unpack(raw, at)
        self.year = v[0]
        self.month = v[1]
        self.day = v[2]
        self.hour = v[3]
        self.min = v[4]
        self.sec = v[5]
        self.msec = v[6]
        self.valid_flags = codec.KNOWN[UtcTimeFlags][v[7]]
        return at + 13

    def _write(self) -> bytes:
        return _H5BIH.write(
            "year month day hour min sec msec valid_flags",
            self.year,
            self.month,
            self.day,
            self.hour,
            self.min,
            self.sec,
            self.msec,
            self.valid_flags,
        )


class GpsTime(Shared, Data):
    """GPS time (0x09).

    GPS time according to the receiver.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10 more.

    - 3dm-cv7-gnss-ins: GPS Time (0x91,0x09)
    - 3dm-cv7-gnss-ins: GPS Time (0x92,0x09)
    """

    __slots__ = ("tow", "week_number", "valid_flags")
    __match_args__ = ("tow", "week_number", "valid_flags")

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x09
    NAME = "gnss_data.gps_time"
    _SIZE = 12

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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _d2H.unpack(raw, at)
        self.tow = v[0]
        self.week_number = v[1]
        self.valid_flags = codec.KNOWN[GpsTimeFlags][v[2]]
        return at + 12

    def _write(self) -> bytes:
        return _d2H.write(
            "tow week_number valid_flags", self.tow, self.week_number, self.valid_flags
        )


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
    _SIZE = 26

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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _3dH.unpack(raw, at)
        self.bias = v[0]
        self.drift = v[1]
        self.accuracy_estimate = v[2]
        self.valid_flags = codec.KNOWN[ClockInfoFlags][v[3]]
        return at + 26

    def _write(self) -> bytes:
        return _3dH.write(
            "bias drift accuracy_estimate valid_flags",
            self.bias,
            self.drift,
            self.accuracy_estimate,
            self.valid_flags,
        )


class FixInfo(Shared, Data):
    """Fix info (0x0B).

    Type of the position fix, with the satellites and corrections used.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Confirmed on 3DM-CV7-GNSS/INS, 3DM-CV7-INS and
    3DM-GQ7-GNSS/INS; likely or assumed on 5 more.

    - 3dm-cv7-gnss-ins: Fix Info (0x91,0x0B)
    - 3dm-cv7-gnss-ins: Fix Info (0x92,0x0B)
    - 3dm-cv7-gnss-ins: Fix Info (0x94,0x0B)
    """

    __slots__ = ("fix_type", "num_sv", "fix_flags", "valid_flags")
    __match_args__ = ("fix_type", "num_sv", "fix_flags", "valid_flags")

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x0B
    NAME = "gnss_data.fix_info"
    _SIZE = 6

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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2B2H.unpack(raw, at)
        self.fix_type = codec.KNOWN[types.GnssFixType][v[0]]
        self.num_sv = v[1]
        self.fix_flags = codec.KNOWN[FixFlags][v[2]]
        self.valid_flags = codec.KNOWN[FixInfoFlags][v[3]]
        return at + 6

    def _write(self) -> bytes:
        return _2B2H.write(
            "fix_type num_sv fix_flags valid_flags",
            self.fix_type,
            self.num_sv,
            self.fix_flags,
            self.valid_flags,
        )


class SvInfo(Shared, Data):
    """Satellite info (0x0C).

    State of one tracked satellite.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Confirmed on 3DM-GX5-45; likely or assumed on 2 more. Known
    only from the MicroStrain MIP SDK. Uncertain: It is not known whether a packet contains one of
    these fields or several.

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
    _SIZE = 12

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
    """Direction of the satellite, from true north. Unit: deg. Frame: ned. Positive: clockwise seen
    from above. Valid if `SvInfoFlags.AZIMUTH` of `valid_flags` is set.
    """
    elevation: int
    """Angle between the horizon and the satellite. Unit: deg. Frame: ned. Range: -90 to 90.
    Positive: above the horizon. Valid if `SvInfoFlags.ELEVATION` of `valid_flags` is set.
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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2BH2h2H.unpack(raw, at)
        self.channel = v[0]
        self.satellite_id = v[1]
        self.carrier_noise_ratio = v[2]
        self.azimuth = v[3]
        self.elevation = v[4]
        self.sv_flags = codec.KNOWN[SvFlags][v[5]]
        self.valid_flags = codec.KNOWN[SvInfoFlags][v[6]]
        return at + 12

    def _write(self) -> bytes:
        return _2BH2h2H.write(
            "channel satellite_id carrier_noise_ratio azimuth elevation sv_flags valid_flags",
            self.channel,
            self.satellite_id,
            self.carrier_noise_ratio,
            self.azimuth,
            self.elevation,
            self.sv_flags,
            self.valid_flags,
        )


class HardwareStatus(Shared, Data):
    """GNSS hardware status (0x0D).

    State of the receiver and of its antenna.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Also called `hw_status`. Confirmed on 3DM-CV7-GNSS/INS,
    3DM-GQ7-GNSS/INS and 3DM-GX5-45; likely or assumed on 2 more.

    - 3dm-cv7-gnss-ins: GNSS Hardware Status (0x91,0x0D)
    - 3dm-cv7-gnss-ins: GNSS Hardware Status (0x92,0x0D)
    """

    __slots__ = ("receiver_state", "antenna_state", "antenna_power", "valid_flags")
    __match_args__ = ("receiver_state", "antenna_state", "antenna_power", "valid_flags")

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x0D
    NAME = "gnss_data.hardware_status"
    _SIZE = 5

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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _3BH.unpack(raw, at)
        self.receiver_state = codec.KNOWN[ReceiverState][v[0]]
        self.antenna_state = codec.KNOWN[AntennaState][v[1]]
        self.antenna_power = codec.KNOWN[AntennaPower][v[2]]
        self.valid_flags = codec.KNOWN[HardwareStatusFlags][v[3]]
        return at + 5

    def _write(self) -> bytes:
        return _3BH.write(
            "receiver_state antenna_state antenna_power valid_flags",
            self.receiver_state,
            self.antenna_state,
            self.antenna_power,
            self.valid_flags,
        )


class DgpsInfo(Shared, Data):
    """DGPS info (0x0E).

    State of the differential corrections.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). The size of its data distinguishes it from
    `DgpsInfoSatellite`. Confirmed on 3DM-GX5-35 and 3DM-GX5-45; likely or assumed on 1 more.
    Uncertain: Devices could also send `DgpsInfoSatellite`, the layout of the SDK, but only this one
    agrees with the valid flags, which are the same in all sources.

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
    _SIZE = 12

    age: float
    """Age of the corrections. Unit: s. Range: at least 0. Valid if `DgpsInfoFlags.AGE` of
    `valid_flags` is set. Uncertain: The unit is that of `DgpsChannel`; no source states it here.
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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _f2h2H.unpack(raw, at)
        if v[0] != v[0]:
            v = _f2h2H.keep_nan_bits(v, raw, at)
        self.age = v[0]
        self.base_station_id = v[1]
        self.base_station_status = v[2]
        self.num_channels = v[3]
        self.valid_flags = codec.KNOWN[DgpsInfoFlags][v[4]]
        return at + 12

    def _write(self) -> bytes:
        return _f2h2H.write(
            "age base_station_id base_station_status num_channels valid_flags",
            self.age,
            self.base_station_id,
            self.base_station_status,
            self.num_channels,
            self.valid_flags,
        )

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return len(data) < 15


class DgpsInfoSatellite(Shared, Data):
    """DGPS info for one satellite (0x0E).

    Differential correction for one satellite, in the SDK's layout of DGPS info.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). The size of its data distinguishes it from `DgpsInfo`. Not
    listed in any device profile. Known only from the MicroStrain MIP SDK. Uncertain: Possibly no
    device sends it: the values are those of `DgpsChannel`, but the flags those of `DgpsInfo`, so a
    mistake in the SDK is likely.

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
    _SIZE = 15

    satellite_id: int
    """Number of the satellite."""
    age: float
    """Age of the correction. Unit: s. Range: at least 0. Valid if `DgpsInfoFlags.AGE` of
    `valid_flags` is set. Uncertain: The unit is that of `DgpsChannel`; no source states it here.
    """
    range_correction: float
    """Differential correction of the pseudorange. Unit: m. Uncertain: The unit is that of
    `DgpsChannel`; no source states it here.
    """
    range_rate_correction: float
    """Rate of change of the correction. Unit: m/s. Uncertain: The unit is that of `DgpsChannel`; no
    source states it here.
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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _B3fH.unpack(raw, at)
        if (total := v[1] + v[2] + v[3]) != total:
            v = _B3fH.keep_nan_bits(v, raw, at)
        self.satellite_id = v[0]
        self.age = v[1]
        self.range_correction = v[2]
        self.range_rate_correction = v[3]
        self.valid_flags = codec.KNOWN[DgpsInfoFlags][v[4]]
        return at + 15

    def _write(self) -> bytes:
        return _B3fH.write(
            "satellite_id age range_correction range_rate_correction valid_flags",
            self.satellite_id,
            self.age,
            self.range_correction,
            self.range_rate_correction,
            self.valid_flags,
        )

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return 15 <= len(data)


class DgpsChannel(Shared, Data):
    """DGPS channel (0x0F).

    Differential correction for one satellite.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Confirmed on 3DM-GX5-45; likely or assumed on 2 more. Known
    only from the MIP SDK of 2014, MicroStrain Communication Library and MicroStrain MIP SDK.

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
    _SIZE = 15

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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _B3fH.unpack(raw, at)
        if (total := v[1] + v[2] + v[3]) != total:
            v = _B3fH.keep_nan_bits(v, raw, at)
        self.satellite_id = v[0]
        self.age = v[1]
        self.range_correction = v[2]
        self.range_rate_correction = v[3]
        self.valid_flags = codec.KNOWN[DgpsChannelFlags][v[4]]
        return at + 15

    def _write(self) -> bytes:
        return _B3fH.write(
            "satellite_id age range_correction range_rate_correction valid_flags",
            self.satellite_id,
            self.age,
            self.range_correction,
            self.range_rate_correction,
            self.valid_flags,
        )


class ClockInfo2(Shared, Data):
    """Clock info 2 (0x10).

    Bias and drift of the receiver clock.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Confirmed on 3DM-CV7-GNSS/INS and 3DM-CV7-INS; likely or
    assumed on 1 more. Uncertain: The units are inferred from those of the ephemerides; no source
    states them.

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
    _SIZE = 34

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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _4dH.unpack(raw, at)
        self.bias = v[0]
        self.drift = v[1]
        self.bias_accuracy_estimate = v[2]
        self.drift_accuracy_estimate = v[3]
        self.valid_flags = codec.KNOWN[ClockInfo2Flags][v[4]]
        return at + 34

    def _write(self) -> bytes:
        return _4dH.write(
            "bias drift bias_accuracy_estimate drift_accuracy_estimate valid_flags",
            self.bias,
            self.drift,
            self.bias_accuracy_estimate,
            self.drift_accuracy_estimate,
            self.valid_flags,
        )


class GpsLeapSeconds(Shared, Data):
    """GPS leap seconds (0x11).

    Difference between GPS time and UTC.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Confirmed on 3DM-CV7-GNSS/INS and 3DM-CV7-INS; likely or
    assumed on 1 more.

    - 3dm-cv7-gnss-ins: GPS Leap Seconds (0x91,0x11)
    - 3dm-cv7-gnss-ins: GPS Leap Seconds (0x92,0x11)
    """

    __slots__ = ("leap_seconds", "valid_flags")
    __match_args__ = ("leap_seconds", "valid_flags")

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x11
    NAME = "gnss_data.gps_leap_seconds"
    _SIZE = 3

    leap_seconds: int
    """GPS time minus UTC. Unit: s. Valid if `GpsLeapSecondsFlags.LEAP_SECONDS` of `valid_flags` is
    set.
    """
    valid_flags: GpsLeapSecondsFlags
    """Validity of the leap seconds."""

    def __init__(self, leap_seconds: int, valid_flags: GpsLeapSecondsFlags) -> None:
        self.leap_seconds = leap_seconds
        self.valid_flags = valid_flags

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _BH.unpack(raw, at)
        self.leap_seconds = v[0]
        self.valid_flags = codec.KNOWN[GpsLeapSecondsFlags][v[1]]
        return at + 3

    def _write(self) -> bytes:
        return _BH.write("leap_seconds valid_flags", self.leap_seconds, self.valid_flags)


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
    _SIZE = 16

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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _dH4BH.unpack(raw, at)
        self.tow = v[0]
        self.week_number = v[1]
        self.sbas_system = codec.KNOWN[SbasSystem][v[2]]
        self.sbas_id = v[3]
        self.count = v[4]
        self.sbas_status = codec.KNOWN[SbasStatus][v[5]]
        self.valid_flags = codec.KNOWN[SbasInfoFlags][v[6]]
        return at + 16

    def _write(self) -> bytes:
        return _dH4BH.write(
            "tow week_number sbas_system sbas_id count sbas_status valid_flags",
            self.tow,
            self.week_number,
            self.sbas_system,
            self.sbas_id,
            self.count,
            self.sbas_status,
            self.valid_flags,
        )


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
    _SIZE = 25

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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2BdH3B2fH.unpack(raw, at)
        if (total := v[7] + v[8]) != total:
            v = _2BdH3B2fH.keep_nan_bits(v, raw, at)
        self.index = v[0]
        self.count = v[1]
        self.tow = v[2]
        self.week_number = v[3]
        self.gnss_id = codec.KNOWN[types.GnssConstellation][v[4]]
        self.satellite_id = v[5]
        self.udrei = v[6]
        self.pseudorange_correction = v[7]
        self.iono_correction = v[8]
        self.valid_flags = codec.KNOWN[SbasCorrectionFlags][v[9]]
        return at + 25

    def _write(self) -> bytes:
        return _2BdH3B2fH.write(
            "index count tow week_number gnss_id satellite_id udrei pseudorange_correction iono_correction valid_flags",
            self.index,
            self.count,
            self.tow,
            self.week_number,
            self.gnss_id,
            self.satellite_id,
            self.udrei,
            self.pseudorange_correction,
            self.iono_correction,
            self.valid_flags,
        )


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
    _SIZE = 9

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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _3BH2BH.unpack(raw, at)
        self.rf_band = codec.KNOWN[RfBand][v[0]]
        self.jamming_state = codec.KNOWN[JammingState][v[1]]
        self.spoofing_state = codec.KNOWN[SpoofingState][v[2]]
        self.frequency = v[3]
        self.reserved = v[4:6]
        self.valid_flags = codec.KNOWN[RfErrorDetectionFlags][v[6]]
        return at + 9

    def _write(self) -> bytes:
        return _3BH2BH.write(
            "rf_band jamming_state spoofing_state frequency reserved*2 valid_flags",
            self.rf_band,
            self.jamming_state,
            self.spoofing_state,
            self.frequency,
            *codec.exactly("reserved", self.reserved, 2),
            self.valid_flags,
        )


class Heading(Shared, Data):
    """GNSS heading (0x15).

    Heading that the receiver computes from its antennas.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Not listed in any device profile. Known only from the
    MicroStrain MIP SDK. Uncertain: The SDK names no device that sends it.

    - mip-sdk-4: Heading (0x81,0x15)
    """

    __slots__ = ("heading", "uncertainty", "fix_type", "valid_flags")
    __match_args__ = ("heading", "uncertainty", "fix_type", "valid_flags")

    SETS = (0x81, 0x91, 0x92, 0x93, 0x94, 0x95)
    DESCRIPTOR = 0x15
    NAME = "gnss_data.heading"
    _SIZE = 11

    heading: float
    """Heading of the baseline between the antennas, from true north. Unit: deg. Frame: ned.
    Positive: clockwise seen from above. Valid if `HeadingFlags.HEADING` of `valid_flags` is set.
    Uncertain: Clockwise from true north is usual; the SDK only states degrees, and no range.
    Uncertain: No source states from which antenna to which the baseline points. The opposite one
    differs by 180 degrees.
    """
    uncertainty: float
    """Uncertainty of the heading. Unit: deg. Range: at least 0. Valid if `HeadingFlags.UNCERTAINTY`
    of `valid_flags` is set. Uncertain: It is not known whether this is one standard deviation.
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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2fBH.unpack(raw, at)
        if (total := v[0] + v[1]) != total:
            v = _2fBH.keep_nan_bits(v, raw, at)
        self.heading = v[0]
        self.uncertainty = v[1]
        self.fix_type = codec.KNOWN[HeadingFixType][v[2]]
        self.valid_flags = codec.KNOWN[HeadingFlags][v[3]]
        return at + 11

    def _write(self) -> bytes:
        return _2fBH.write(
            "heading uncertainty fix_type valid_flags",
            self.heading,
            self.uncertainty,
            self.fix_type,
            self.valid_flags,
        )


class SatelliteStatus(Shared, Data):
    """Satellite status (0x20).

    Direction to one satellite, and its health.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Confirmed on 3DM-CV7-GNSS/INS and 3DM-CV7-INS; likely or
    assumed on 3 more.

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
    _SIZE = 25

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
    """Angle between the horizon and the satellite, seen from the rover. Unit: deg. Frame: ned.
    Range: -90 to 90. Positive: above the horizon. Valid if `SatelliteStatusFlags.ELEVATION` of
    `valid_flags` is set.
    """
    azimuth: float
    """Direction of the satellite from the rover, from true north. Unit: deg. Frame: ned. Positive:
    clockwise seen from above. Valid if `SatelliteStatusFlags.AZIMUTH` of `valid_flags` is set.
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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2BdH2B2fBH.unpack(raw, at)
        if (total := v[6] + v[7]) != total:
            v = _2BdH2B2fBH.keep_nan_bits(v, raw, at)
        self.index = v[0]
        self.count = v[1]
        self.tow = v[2]
        self.week_number = v[3]
        self.gnss_id = codec.KNOWN[types.GnssConstellation][v[4]]
        self.satellite_id = v[5]
        self.elevation = v[6]
        self.azimuth = v[7]
        self.health = codec.TRUTH[v[8]]
        self.valid_flags = codec.KNOWN[SatelliteStatusFlags][v[9]]
        return at + 25

    def _write(self) -> bytes:
        return _2BdH2B2fBH.write(
            "index count tow week_number gnss_id satellite_id elevation azimuth health valid_flags",
            self.index,
            self.count,
            self.tow,
            self.week_number,
            self.gnss_id,
            self.satellite_id,
            self.elevation,
            self.azimuth,
            self.health,
            self.valid_flags,
        )


class Raw(Shared, Data):
    """Raw (0x22).

    Raw observation of one signal of one satellite.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 1 more.

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
    _SIZE = 61

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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2Bd2H4BfB2d5fH.unpack(raw, at)
        if (total := sum(v[9:18])) != total:
            v = _2Bd2H4BfB2d5fH.keep_nan_bits(v, raw, at)
        self.index = v[0]
        self.count = v[1]
        self.tow = v[2]
        self.week_number = v[3]
        self.receiver_id = v[4]
        self.tracking_channel = v[5]
        self.gnss_id = codec.KNOWN[types.GnssConstellation][v[6]]
        self.satellite_id = v[7]
        self.signal_id = codec.KNOWN[types.GnssSignal][v[8]]
        self.signal_strength = v[9]
        self.quality = codec.KNOWN[SignalQuality][v[10]]
        self.pseudorange = v[11]
        self.carrier_phase = v[12]
        self.doppler = v[13]
        self.range_uncertainty = v[14]
        self.phase_uncertainty = v[15]
        self.doppler_uncertainty = v[16]
        self.lock_time = v[17]
        self.valid_flags = codec.KNOWN[RawFlags][v[18]]
        return at + 61

    def _write(self) -> bytes:
        return _2Bd2H4BfB2d5fH.write(
            "index count tow week_number receiver_id tracking_channel gnss_id satellite_id signal_id signal_strength quality pseudorange carrier_phase doppler range_uncertainty phase_uncertainty doppler_uncertainty lock_time valid_flags",
            self.index,
            self.count,
            self.tow,
            self.week_number,
            self.receiver_id,
            self.tracking_channel,
            self.gnss_id,
            self.satellite_id,
            self.signal_id,
            self.signal_strength,
            self.quality,
            self.pseudorange,
            self.carrier_phase,
            self.doppler,
            self.range_uncertainty,
            self.phase_uncertainty,
            self.doppler_uncertainty,
            self.lock_time,
            self.valid_flags,
        )


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
    _SIZE = 44
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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _dH3df3H.unpack(raw, at)
        if v[5] != v[5]:
            v = _dH3df3H.keep_nan_bits(v, raw, at)
        self.tow = v[0]
        self.week_number = v[1]
        self._ecef_position = v[2:5]
        self.height = v[5]
        self.station_id = v[6]
        self.indicators = codec.KNOWN[BaseStationIndicators][v[7]]
        self.valid_flags = codec.KNOWN[BaseStationInfoFlags][v[8]]
        return at + 44

    def _write(self) -> bytes:
        return _dH3df3H.write(
            "tow week_number ecef_position*3 height station_id indicators valid_flags",
            self.tow,
            self.week_number,
            *codec.elements("ecef_position", self.ecef_position, 3),
            self.height,
            self.station_id,
            self.indicators,
            self.valid_flags,
        )


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
    _SIZE = 50

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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _d2HI4f4IH.unpack(raw, at)
        if (total := v[4] + v[5] + v[6] + v[7]) != total:
            v = _d2HI4f4IH.keep_nan_bits(v, raw, at)
        self.tow = v[0]
        self.week_number = v[1]
        self.epoch_status = codec.KNOWN[RtkEpochStatus][v[2]]
        self.dongle_status = codec.KNOWN[types.RtkStatusFlags][v[3]]
        self.gps_correction_latency = v[4]
        self.glonass_correction_latency = v[5]
        self.galileo_correction_latency = v[6]
        self.beidou_correction_latency = v[7]
        self.reserved = v[8:12]
        self.valid_flags = codec.KNOWN[RtkCorrectionsStatusFlags][v[12]]
        return at + 50

    def _write(self) -> bytes:
        return _d2HI4f4IH.write(
            "tow week_number epoch_status dongle_status gps_correction_latency glonass_correction_latency galileo_correction_latency beidou_correction_latency reserved*4 valid_flags",
            self.tow,
            self.week_number,
            self.epoch_status,
            self.dongle_status,
            self.gps_correction_latency,
            self.glonass_correction_latency,
            self.galileo_correction_latency,
            self.beidou_correction_latency,
            *codec.exactly("reserved", self.reserved, 4),
            self.valid_flags,
        )


class GpsEphemeris(Shared, Data):
    """GPS ephemeris (0x61).

    Broadcast orbit and clock of one GPS satellite.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 1 more.

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
    _SIZE = 218

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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2BdH4B25dH.unpack(raw, at)
        self.index = v[0]
        self.count = v[1]
        self.tow = v[2]
        self.week_number = v[3]
        self.satellite_id = v[4]
        self.health = v[5]
        self.iodc = v[6]
        self.iode = v[7]
        self.t_oc = v[8]
        self.af0 = v[9]
        self.af1 = v[10]
        self.af2 = v[11]
        self.t_gd = v[12]
        self.isc_l1ca = v[13]
        self.isc_l2c = v[14]
        self.t_oe = v[15]
        self.a = v[16]
        self.a_dot = v[17]
        self.mean_anomaly = v[18]
        self.delta_mean_motion = v[19]
        self.delta_mean_motion_dot = v[20]
        self.eccentricity = v[21]
        self.argument_of_perigee = v[22]
        self.omega = v[23]
        self.omega_dot = v[24]
        self.inclination = v[25]
        self.inclination_dot = v[26]
        self.c_ic = v[27]
        self.c_is = v[28]
        self.c_uc = v[29]
        self.c_us = v[30]
        self.c_rc = v[31]
        self.c_rs = v[32]
        self.valid_flags = codec.KNOWN[EphemerisFlags][v[33]]
        return at + 218

    def _write(self) -> bytes:
        return _2BdH4B25dH.write(
            "index count tow week_number satellite_id health iodc iode t_oc af0 af1 af2 t_gd isc_l1ca isc_l2c t_oe a a_dot mean_anomaly delta_mean_motion delta_mean_motion_dot eccentricity argument_of_perigee omega omega_dot inclination inclination_dot c_ic c_is c_uc c_us c_rc c_rs valid_flags",
            self.index,
            self.count,
            self.tow,
            self.week_number,
            self.satellite_id,
            self.health,
            self.iodc,
            self.iode,
            self.t_oc,
            self.af0,
            self.af1,
            self.af2,
            self.t_gd,
            self.isc_l1ca,
            self.isc_l2c,
            self.t_oe,
            self.a,
            self.a_dot,
            self.mean_anomaly,
            self.delta_mean_motion,
            self.delta_mean_motion_dot,
            self.eccentricity,
            self.argument_of_perigee,
            self.omega,
            self.omega_dot,
            self.inclination,
            self.inclination_dot,
            self.c_ic,
            self.c_is,
            self.c_uc,
            self.c_us,
            self.c_rc,
            self.c_rs,
            self.valid_flags,
        )


class GlonassEphemeris(Shared, Data):
    """GLONASS ephemeris (0x62).

    Broadcast orbit and clock of one GLONASS satellite.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Also called `glo_ephemeris`. Confirmed on 3DM-CV7-GNSS/INS;
    likely or assumed on 1 more.

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
    _SIZE = 102
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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2BdHBb2IB5d6f3Bf6BH.unpack(raw, at)
        if (total := sum(v[14:24])) != total:
            v = _2BdHBb2IB5d6f3Bf6BH.keep_nan_bits(v, raw, at)
        self.index = v[0]
        self.count = v[1]
        self.tow = v[2]
        self.week_number = v[3]
        self.satellite_id = v[4]
        self.frequency_number = v[5]
        self.tk = v[6]
        self.tb = v[7]
        self.satellite_type = codec.KNOWN[GlonassSatelliteType][v[8]]
        self.gamma = v[9]
        self.tau_n = v[10]
        self._position = v[11:14]
        self._velocity = v[14:17]
        self._accel = v[17:20]
        self.health = v[20]
        self.p = v[21]
        self.nt = v[22]
        self.delta_tau_n = v[23]
        self.ft = v[24]
        self.en = v[25]
        self.p1 = v[26]
        self.p2 = v[27]
        self.p3 = v[28]
        self.p4 = v[29]
        self.valid_flags = codec.KNOWN[GlonassEphemerisFlags][v[30]]
        return at + 102

    def _write(self) -> bytes:
        return _2BdHBb2IB5d6f3Bf6BH.write(
            "index count tow week_number satellite_id frequency_number tk tb satellite_type gamma tau_n position*3 velocity*3 accel*3 health p nt delta_tau_n ft en p1 p2 p3 p4 valid_flags",
            self.index,
            self.count,
            self.tow,
            self.week_number,
            self.satellite_id,
            self.frequency_number,
            self.tk,
            self.tb,
            self.satellite_type,
            self.gamma,
            self.tau_n,
            *codec.elements("position", self.position, 3),
            *codec.elements("velocity", self.velocity, 3),
            *codec.elements("accel", self.accel, 3),
            self.health,
            self.p,
            self.nt,
            self.delta_tau_n,
            self.ft,
            self.en,
            self.p1,
            self.p2,
            self.p3,
            self.p4,
            self.valid_flags,
        )


class GalileoEphemeris(Shared, Data):
    """Galileo ephemeris (0x63).

    Broadcast orbit and clock of one Galileo satellite.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 1 more.

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
    _SIZE = 218

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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2BdH4B25dH.unpack(raw, at)
        self.index = v[0]
        self.count = v[1]
        self.tow = v[2]
        self.week_number = v[3]
        self.satellite_id = v[4]
        self.health = v[5]
        self.iodc = v[6]
        self.iode = v[7]
        self.t_oc = v[8]
        self.af0 = v[9]
        self.af1 = v[10]
        self.af2 = v[11]
        self.t_gd = v[12]
        self.isc_l1ca = v[13]
        self.isc_l2c = v[14]
        self.t_oe = v[15]
        self.a = v[16]
        self.a_dot = v[17]
        self.mean_anomaly = v[18]
        self.delta_mean_motion = v[19]
        self.delta_mean_motion_dot = v[20]
        self.eccentricity = v[21]
        self.argument_of_perigee = v[22]
        self.omega = v[23]
        self.omega_dot = v[24]
        self.inclination = v[25]
        self.inclination_dot = v[26]
        self.c_ic = v[27]
        self.c_is = v[28]
        self.c_uc = v[29]
        self.c_us = v[30]
        self.c_rc = v[31]
        self.c_rs = v[32]
        self.valid_flags = codec.KNOWN[EphemerisFlags][v[33]]
        return at + 218

    def _write(self) -> bytes:
        return _2BdH4B25dH.write(
            "index count tow week_number satellite_id health iodc iode t_oc af0 af1 af2 t_gd isc_l1ca isc_l2c t_oe a a_dot mean_anomaly delta_mean_motion delta_mean_motion_dot eccentricity argument_of_perigee omega omega_dot inclination inclination_dot c_ic c_is c_uc c_us c_rc c_rs valid_flags",
            self.index,
            self.count,
            self.tow,
            self.week_number,
            self.satellite_id,
            self.health,
            self.iodc,
            self.iode,
            self.t_oc,
            self.af0,
            self.af1,
            self.af2,
            self.t_gd,
            self.isc_l1ca,
            self.isc_l2c,
            self.t_oe,
            self.a,
            self.a_dot,
            self.mean_anomaly,
            self.delta_mean_motion,
            self.delta_mean_motion_dot,
            self.eccentricity,
            self.argument_of_perigee,
            self.omega,
            self.omega_dot,
            self.inclination,
            self.inclination_dot,
            self.c_ic,
            self.c_is,
            self.c_uc,
            self.c_us,
            self.c_rc,
            self.c_rs,
            self.valid_flags,
        )


class BeidouEphemeris(Shared, Data):
    """BeiDou ephemeris (0x64).

    Broadcast orbit and clock of one BeiDou satellite.

    Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external
    (0x94) and gnss_external_2 (0x95). Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 1 more.

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
    _SIZE = 218

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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2BdH4B25dH.unpack(raw, at)
        self.index = v[0]
        self.count = v[1]
        self.tow = v[2]
        self.week_number = v[3]
        self.satellite_id = v[4]
        self.health = v[5]
        self.iodc = v[6]
        self.iode = v[7]
        self.t_oc = v[8]
        self.af0 = v[9]
        self.af1 = v[10]
        self.af2 = v[11]
        self.t_gd = v[12]
        self.isc_l1ca = v[13]
        self.isc_l2c = v[14]
        self.t_oe = v[15]
        self.a = v[16]
        self.a_dot = v[17]
        self.mean_anomaly = v[18]
        self.delta_mean_motion = v[19]
        self.delta_mean_motion_dot = v[20]
        self.eccentricity = v[21]
        self.argument_of_perigee = v[22]
        self.omega = v[23]
        self.omega_dot = v[24]
        self.inclination = v[25]
        self.inclination_dot = v[26]
        self.c_ic = v[27]
        self.c_is = v[28]
        self.c_uc = v[29]
        self.c_us = v[30]
        self.c_rc = v[31]
        self.c_rs = v[32]
        self.valid_flags = codec.KNOWN[EphemerisFlags][v[33]]
        return at + 218

    def _write(self) -> bytes:
        return _2BdH4B25dH.write(
            "index count tow week_number satellite_id health iodc iode t_oc af0 af1 af2 t_gd isc_l1ca isc_l2c t_oe a a_dot mean_anomaly delta_mean_motion delta_mean_motion_dot eccentricity argument_of_perigee omega omega_dot inclination inclination_dot c_ic c_is c_uc c_us c_rc c_rs valid_flags",
            self.index,
            self.count,
            self.tow,
            self.week_number,
            self.satellite_id,
            self.health,
            self.iodc,
            self.iode,
            self.t_oc,
            self.af0,
            self.af1,
            self.af2,
            self.t_gd,
            self.isc_l1ca,
            self.isc_l2c,
            self.t_oe,
            self.a,
            self.a_dot,
            self.mean_anomaly,
            self.delta_mean_motion,
            self.delta_mean_motion_dot,
            self.eccentricity,
            self.argument_of_perigee,
            self.omega,
            self.omega_dot,
            self.inclination,
            self.inclination_dot,
            self.c_ic,
            self.c_is,
            self.c_uc,
            self.c_us,
            self.c_rc,
            self.c_rs,
            self.valid_flags,
        )


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
    _SIZE = 76

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
    Uncertain: No source states the units.
    """
    beta: tuple[float, float, float, float]
    """Coefficients beta 0 to 3. Valid if `GpsIonoCorrectionFlags.BETA` of `valid_flags` is set.
    Uncertain: No source states the units.
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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _dH8dH.unpack(raw, at)
        self.tow = v[0]
        self.week_number = v[1]
        self.alpha = v[2:6]
        self.beta = v[6:10]
        self.valid_flags = codec.KNOWN[GpsIonoCorrectionFlags][v[10]]
        return at + 76

    def _write(self) -> bytes:
        return _dH8dH.write(
            "tow week_number alpha*4 beta*4 valid_flags",
            self.tow,
            self.week_number,
            *codec.exactly("alpha", self.alpha, 4),
            *codec.exactly("beta", self.beta, 4),
            self.valid_flags,
        )


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
    _SIZE = 37

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
    `valid_flags` is set. Uncertain: No source states the units.
    """
    disturbance_flags: int
    """Ionospheric storms, one bit (1 to 5) for each of five regions. Valid if
    `GalileoIonoCorrectionFlags.DISTURBANCE_FLAGS` of `valid_flags` is set. Uncertain: No source
    states whether the bits count from 0 or from 1, or the region of each.
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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _dH3dBH.unpack(raw, at)
        self.tow = v[0]
        self.week_number = v[1]
        self.alpha = v[2:5]
        self.disturbance_flags = v[5]
        self.valid_flags = codec.KNOWN[GalileoIonoCorrectionFlags][v[6]]
        return at + 37

    def _write(self) -> bytes:
        return _dH3dBH.write(
            "tow week_number alpha*3 disturbance_flags valid_flags",
            self.tow,
            self.week_number,
            *codec.exactly("alpha", self.alpha, 3),
            self.disturbance_flags,
            self.valid_flags,
        )


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
    _SIZE = 148

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
    set. Uncertain: No source states the units.
    """
    beta: tuple[float, float, float, float]
    """Coefficients beta 0 to 3. Valid if `BeidouIonoCorrectionFlags.BETA` of `valid_flags` is set.
    Uncertain: No source states the units.
    """
    alpha_correction: tuple[float, ...]
    """Nine further coefficients of the delay. Valid if `BeidouIonoCorrectionFlags.ALPHA_CORRECTION`
    of `valid_flags` is set. Uncertain: No source states the units.
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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _dH17dH.unpack(raw, at)
        self.tow = v[0]
        self.week_number = v[1]
        self.alpha = v[2:6]
        self.beta = v[6:10]
        self.alpha_correction = v[10:19]
        self.valid_flags = codec.KNOWN[BeidouIonoCorrectionFlags][v[19]]
        return at + 148

    def _write(self) -> bytes:
        return _dH17dH.write(
            "tow week_number alpha*4 beta*4 alpha_correction*9 valid_flags",
            self.tow,
            self.week_number,
            *codec.exactly("alpha", self.alpha, 4),
            *codec.exactly("beta", self.beta, 4),
            *codec.exactly("alpha_correction", self.alpha_correction, 9),
            self.valid_flags,
        )


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
