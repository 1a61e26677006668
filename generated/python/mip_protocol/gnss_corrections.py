"""GNSS corrections data (0x93).

What the device receives of RTK corrections. Data are sent as they are received.

- 3dm-cv7-gnss-ins: GNSS Corrections (0x93)
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import IntFlag

from . import codec, types
from .field import Data, Field


@codec.open_flag(16)
class BaseStationIndicators(IntFlag):
    """Properties of a base station, as its RTCM message gives them."""

    GPS = 1 << 0
    """GPS is supported. Bit 0."""
    GLONASS = 1 << 1
    """GLONASS is supported. Bit 1."""
    GALILEO = 1 << 2
    """Galileo is supported. Bit 2."""
    BEIDOU = 1 << 3
    """BeiDou is supported. Bit 3."""
    REF_STATION = 1 << 4
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
    """Which values are valid."""

    TOW = 1 << 0
    """Time of week. Bit 0."""
    WEEK_NUMBER = 1 << 1
    """Week number. Bit 1."""
    ECEF_POSITION = 1 << 2
    """Position. Bit 2."""
    HEIGHT = 1 << 3
    """Antenna height. Bit 3."""
    STATION_ID = 1 << 4
    """Station. Bit 4."""
    INDICATORS = 1 << 5
    """Indicators. Bit 5."""
    FLAGS = 0x3F
    """All of them. Bits 0 to 5. Overlaps other bits."""


@codec.open_flag(16)
class RtkEpochStatus(IntFlag):
    """Corrections that came during an epoch."""

    ANTENNA_LOCATION_RECEIVED = 1 << 0
    """Antenna location. Bit 0."""
    ANTENNA_DESCRIPTION_RECEIVED = 1 << 1
    """Antenna description. Bit 1."""
    GPS_RECEIVED = 1 << 2
    """GPS corrections. Bit 2."""
    GLONASS_RECEIVED = 1 << 3
    """GLONASS corrections. Bit 3."""
    GALILEO_RECEIVED = 1 << 4
    """Galileo corrections. Bit 4."""
    BEIDOU_RECEIVED = 1 << 5
    """BeiDou corrections. Bit 5."""
    USING_GPS_MSM_MESSAGES = 1 << 6
    """GPS corrections come in MSM messages, not in the RTCM messages 1001-1004. Bit 6."""
    USING_GLONASS_MSM_MESSAGES = 1 << 7
    """GLONASS corrections come in MSM messages, not in the RTCM messages 1009-1012. Bit 7."""
    DONGLE_STATUS_READ_FAILED = 1 << 8
    """The status of the dongle could not be read. Bit 8."""


@codec.open_flag(16)
class RtkCorrectionsStatusFlags(IntFlag):
    """Which values are valid."""

    TOW = 1 << 0
    """Time of week. Bit 0."""
    WEEK_NUMBER = 1 << 1
    """Week number. Bit 1."""
    EPOCH_STATUS = 1 << 2
    """Epoch status. Bit 2."""
    DONGLE_STATUS = 1 << 3
    """Status of the dongle. Bit 3."""
    GPS_LATENCY = 1 << 4
    """Latency of GPS corrections. Bit 4."""
    GLONASS_LATENCY = 1 << 5
    """Latency of GLONASS corrections. Bit 5."""
    GALILEO_LATENCY = 1 << 6
    """Latency of Galileo corrections. Bit 6."""
    BEIDOU_LATENCY = 1 << 7
    """Latency of BeiDou corrections. Bit 7."""
    FLAGS = 0xFF
    """All of them. Bits 0 to 7. Overlaps other bits."""


_BASE_STATION_INFO_0 = codec.Block(
    "dHdddfHHH",
    "time_of_week",
    "week_number",
    *["ecef_pos"] * 3,
    "height",
    "station_id",
    "indicators",
    "valid_flags",
)


@dataclass(slots=True)
class BaseStationInfo(Data):
    """Base station info (0x93,0x30).

    The base station of the corrections, from an RTCM message 1005 or 1006.

    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Base Station Info (0x93,0x30)
    """

    SET = 0x93
    DESCRIPTOR = 0x30
    NAME = "gnss_corrections.base_station_info"
    ROLE = "data"

    time_of_week: float
    """GPS time of week at which the message was received. Unit: s. Valid if
    `BaseStationInfoFlags.TOW` of `valid_flags` is set.
    """
    week_number: int
    """GPS week number. Unit: week. Valid if `BaseStationInfoFlags.WEEK_NUMBER` of `valid_flags` is
    set.
    """
    ecef_pos: types.Vector3d
    """Position of the station. Elements: x, y, z. Unit: m. Frame: ecef. Valid if
    `BaseStationInfoFlags.ECEF_POSITION` of `valid_flags` is set.
    """
    height: float
    """Height of the antenna above the marker that was surveyed. Unit: m. Valid if
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
    """Which values are valid."""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[BaseStationInfo, int]:
        v = _BASE_STATION_INFO_0.read(raw, at)
        at += 44
        time_of_week = v[0]
        week_number = v[1]
        ecef_pos = v[2:5]
        height = v[5]
        station_id = v[6]
        indicators = BaseStationIndicators(v[7])
        valid_flags = BaseStationInfoFlags(v[8])
        return cls(
            time_of_week, week_number, ecef_pos, height, station_id, indicators, valid_flags
        ), at

    def _write(self) -> bytes:
        out = _BASE_STATION_INFO_0.write(
            self.time_of_week,
            self.week_number,
            *codec.exactly("ecef_pos", self.ecef_pos, 3),
            self.height,
            self.station_id,
            self.indicators,
            self.valid_flags,
        )
        return codec.finished(out)


_RTK_CORRECTIONS_STATUS_0 = codec.Block(
    "dHHIffffIIIIH",
    "time_of_week",
    "week_number",
    "epoch_status",
    "dongle_status",
    "gps_correction_latency",
    "glonass_correction_latency",
    "galileo_correction_latency",
    "beidou_correction_latency",
    *["reserved"] * 4,
    "valid_flags",
)


@dataclass(slots=True)
class RtkCorrectionsStatus(Data):
    """RTK corrections status (0x93,0x31).

    Which corrections come, and how old they are.

    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: RTK Corrections Status (0x93,0x31)
    """

    SET = 0x93
    DESCRIPTOR = 0x31
    NAME = "gnss_corrections.rtk_corrections_status"
    ROLE = "data"

    time_of_week: float
    """GPS time of week. Unit: s. Valid if `RtkCorrectionsStatusFlags.TOW` of `valid_flags` is set.
    """
    week_number: int
    """GPS week number. Unit: week. Valid if `RtkCorrectionsStatusFlags.WEEK_NUMBER` of
    `valid_flags` is set.
    """
    epoch_status: RtkEpochStatus
    """Corrections that came during this epoch. Valid if `RtkCorrectionsStatusFlags.EPOCH_STATUS` of
    `valid_flags` is set.
    """
    dongle_status: int
    """Status flags of the RTK dongle; of use only with a dongle. Valid if
    `RtkCorrectionsStatusFlags.DONGLE_STATUS` of `valid_flags` is set. The manual does not define
    the flags.
    """
    gps_correction_latency: float
    """Latency of the last GPS correction. Unit: s. Valid if `RtkCorrectionsStatusFlags.GPS_LATENCY`
    of `valid_flags` is set.
    """
    glonass_correction_latency: float
    """Latency of the last GLONASS correction. Unit: s. Valid if
    `RtkCorrectionsStatusFlags.GLONASS_LATENCY` of `valid_flags` is set.
    """
    galileo_correction_latency: float
    """Latency of the last Galileo correction. Unit: s. Valid if
    `RtkCorrectionsStatusFlags.GALILEO_LATENCY` of `valid_flags` is set.
    """
    beidou_correction_latency: float
    """Latency of the last BeiDou correction. Unit: s. Valid if
    `RtkCorrectionsStatusFlags.BEIDOU_LATENCY` of `valid_flags` is set.
    """
    reserved: tuple[int, int, int, int] = field(default=(0, 0, 0, 0), kw_only=True)
    """Reserved."""
    valid_flags: RtkCorrectionsStatusFlags
    """Which values are valid."""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[RtkCorrectionsStatus, int]:
        v = _RTK_CORRECTIONS_STATUS_0.read(raw, at)
        at += 50
        time_of_week = v[0]
        week_number = v[1]
        epoch_status = RtkEpochStatus(v[2])
        dongle_status = v[3]
        gps_correction_latency = v[4]
        glonass_correction_latency = v[5]
        galileo_correction_latency = v[6]
        beidou_correction_latency = v[7]
        reserved = v[8:12]
        valid_flags = RtkCorrectionsStatusFlags(v[12])
        return cls(
            time_of_week,
            week_number,
            epoch_status,
            dongle_status,
            gps_correction_latency,
            glonass_correction_latency,
            galileo_correction_latency,
            beidou_correction_latency,
            valid_flags,
            reserved=reserved,
        ), at

    def _write(self) -> bytes:
        out = _RTK_CORRECTIONS_STATUS_0.write(
            self.time_of_week,
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
        return codec.finished(out)


#: The types of each descriptor; several where constants in the data tell layouts apart.
FIELDS: dict[int, tuple[type[Field], ...]] = {
    0x30: (BaseStationInfo,),
    0x31: (RtkCorrectionsStatus,),
}
