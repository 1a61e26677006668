"""3DM (0x0C).

Commands that set up the sensors, the outputs, the pins and the events of a device.

- 3dm-gx5-15: 4.2 3DM Commands
- 3dm-cv7-gnss-ins: 3DM (0x0C)
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import IntFlag
from typing import Any

from . import codec, types
from .field import ClassOf, Command, Field, R, Response, ResponseClasses, Structure
from .protocol import FunctionSelector

# Numbers that are read and written together, by their letters for `struct`.
_2B = codec.Block("2B")

_2B2f = codec.Block("2B2f")

_2BIH5IH4I2H6I2H6I = codec.Block("2BIH5IH4I2H6I2H6I")

_2BIHI = codec.Block("2BIHI")

_2H2B2HBH = codec.Block("2H2B2HBH")

_2HB = codec.Block("2HB")

_2I = codec.Block("2I")

_2I2BHB3fIB2IB5I = codec.Block("2I2BHB3fIB2IB5I")

_2I3B2HIfIB2IB5I = codec.Block("2I3B2HIfIB2IB5I")

_3B = codec.Block("3B")

_3BHB = codec.Block("3BHB")

_3f = codec.Block("3f")

_4B = codec.Block("4B")

_4BH = codec.Block("4BH")

_4Bf = codec.Block("4Bf")

_4I2B13I = codec.Block("4I2B13I")

_4f = codec.Block("4f")

_9f = codec.Block("9f")

_B = codec.Block("B")

_B2f = codec.Block("B2f")

_BH = codec.Block("BH")

_BHB = codec.Block("BHB")

_BI = codec.Block("BI")

_Bf = codec.Block("Bf")

_H = codec.Block("H")

_HB = codec.Block("HB")

_I = codec.Block("I")

_IHI = codec.Block("IHI")

_IHI2B9I = codec.Block("IHI2B9I")

_IHI2Bf3I3B13I = codec.Block("IHI2Bf3I3B13I")

_IHIB2I3B13I = codec.Block("IHIB2I3B13I")

_IHIB2I3B13I3B = codec.Block("IHIB2I3B13I3B")

_IQ = codec.Block("IQ")

_IQfI3B2IBIH5I = codec.Block("IQfI3B2IBIH5I")

_d = codec.Block("d")

_dHf = codec.Block("dHf")

_f = codec.Block("f")


class PollEntry(Structure):
    """A field requested by a poll.

    - 3dm-gx5-15: 4.2.1 Poll IMU Data (0x0C, 0x01)
    """

    __slots__ = ("descriptor", "reserved")
    __match_args__ = ("descriptor", "reserved")

    _SIZE = 3

    descriptor: int
    """Field descriptor."""
    reserved: int
    """Reserved; occupies the position of a decimation. Reserved: send 0."""

    def __init__(self, descriptor: int, reserved: int = 0) -> None:
        self.descriptor = descriptor
        self.reserved = reserved

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.descriptor, self.reserved = _BH.unpack(raw, at)
        return at + 3

    def _write(self) -> bytes:
        return _BH.write("descriptor reserved", self.descriptor, self.reserved)


class FactoryStreamingAction(codec.OpenEnum):
    """Treatment of the existing message formats.

    - 3dm-cv7-gnss-ins: Factory Streaming (0x0C,0x10)
    """

    OVERWRITE = 0
    """The formats are replaced."""
    MERGE = 1
    """The support fields are merged into the formats; the order may change."""
    ADD = 2
    """The support fields are appended to the formats; fields may occur twice."""


class ConstellationId(codec.OpenEnum):
    """Constellation in receiver settings. The values differ from those of
    `types.GnssConstellation`, which GNSS data uses.

    - mip-sdk-4: Constellation Settings (0x0C,0x21)
    """

    GPS = 0
    """GPS, satellites G1 to G32."""
    SBAS = 1
    """SBAS, satellites S120 to S158."""
    GALILEO = 2
    """Galileo, satellites E1 to E36."""
    BEIDOU = 3
    """BeiDou, satellites B1 to B37."""
    QZSS = 5
    """QZSS, satellites Q1 to Q5."""
    GLONASS = 6
    """GLONASS, satellites R1 to R32."""


@codec.open_flag(16)
class ConstellationOptions(IntFlag):
    """Options of a constellation.

    - mip-sdk-4: Constellation Settings (0x0C,0x21)
    """

    L1SAIF = 1 << 0
    """The L1-SAIF signal; QZSS only. Bit 0."""


class ConstellationSettingsEntry(Structure):
    """Settings for the tracking of one constellation.

    - mip-sdk-4: Constellation Settings (0x0C,0x21)
    """

    __slots__ = ("constellation_id", "enable", "reserved_channels", "max_channels", "option_flags")
    __match_args__ = (
        "constellation_id",
        "enable",
        "reserved_channels",
        "max_channels",
        "option_flags",
    )

    _SIZE = 6

    constellation_id: ConstellationId
    """Constellation that this entry configures."""
    enable: int
    """1 enables the constellation, 0 disables it. Range: 0 to 1."""
    reserved_channels: int
    """Number of channels reserved for the constellation. Unit: 1. Range: 0 to 32."""
    max_channels: int
    """Maximum number of channels for the constellation. Unit: 1. Range: 0 to 32."""
    option_flags: ConstellationOptions
    """Options of this constellation."""

    def __init__(
        self,
        constellation_id: ConstellationId,
        enable: int,
        reserved_channels: int,
        max_channels: int,
        option_flags: ConstellationOptions,
    ) -> None:
        self.constellation_id = constellation_id
        self.enable = enable
        self.reserved_channels = reserved_channels
        self.max_channels = max_channels
        self.option_flags = option_flags

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _4BH.unpack(raw, at)
        self.constellation_id = codec.KNOWN[ConstellationId][v[0]]
        self.enable = v[1]
        self.reserved_channels = v[2]
        self.max_channels = v[3]
        self.option_flags = codec.KNOWN[ConstellationOptions][v[4]]
        return at + 6

    def _write(self) -> bytes:
        return _4BH.write(
            "constellation_id enable reserved_channels max_channels option_flags",
            self.constellation_id,
            self.enable,
            self.reserved_channels,
            self.max_channels,
            self.option_flags,
        )


@codec.open_flag(16)
class SbasOptions(IntFlag):
    """Purposes for which SBAS is used.

    - 3dm-cv7-gnss-ins: GNSS SBAS Settings (0x0C,0x22)
    """

    ENABLE_RANGING = 1 << 0
    """SBAS pseudoranges are used in the position solution. Bit 0."""
    ENABLE_CORRECTIONS = 1 << 1
    """SBAS differential corrections are applied. Bit 1."""
    APPLY_INTEGRITY = 1 << 2
    """Only GPS satellites with SBAS integrity information are used. Bit 2."""


class AssistedFixOption(codec.OpenEnum):
    """Use of a receiver's last fix at power-up.

    - mip-sdk-4: Gnss Assisted Fix (0x0C,0x23)
    """

    NONE = 0
    """The receiver ignores its last fix."""
    ENABLED = 1
    """The receiver starts from its last fix."""


class PpsSource(codec.OpenEnum):
    """Source of the pulse per second.

    - 3dm-cv7-gnss-ins: PPS Source Control (0x0C,0x28)
    - 3dm-cv7-gnss-ins: RECEIVER Source
    """

    DISABLED = 0
    """No pulse."""
    RECEIVER_1 = 1
    """From GNSS receiver 1. The external time is GPS time, and valid only while the receiver has a
    fix. Requires a receiver.
    """
    RECEIVER_2 = 2
    """From GNSS receiver 2. The external time is GPS time, and valid only while the receiver has a
    fix. Requires 2 receivers.
    """
    GPIO = 3
    """From a GPIO pin that is configured as a PPS input."""
    GENERATED = 4
    """From the oscillator of the device."""


class EventSupportQuery(codec.OpenEnum):
    """The part of the event system that is queried.

    - 3dm-cv7-gnss-ins: Get Supported Events (0x0C,0x2A)
    """

    TRIGGER_TYPES = 1
    """Supported types of triggers."""
    ACTION_TYPES = 2
    """Supported types of actions."""


class EventSupportInfo(Structure):
    """Capacity of a device for one trigger or action type.

    - 3dm-cv7-gnss-ins: Info
    """

    __slots__ = ("type", "count")
    __match_args__ = ("type", "count")

    _SIZE = 2

    type: int
    """Trigger type or action type."""
    count: int
    """Maximum number of instances of this type. Unit: 1."""

    def __init__(self, type: int, count: int) -> None:
        self.type = type
        self.count = count

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.type, self.count = _2B.unpack(raw, at)
        return at + 2

    def _write(self) -> bytes:
        return _2B.write("type count", self.type, self.count)


class EventTriggerStatusEntry(Structure):
    """Type and state of one trigger.

    - 3dm-cv7-gnss-ins: Get Event Trigger Status (0x0C,0x2C)
    """

    __slots__ = ("type", "status")
    __match_args__ = ("type", "status")

    _SIZE = 2

    type: types.EventTriggerType
    """Configured type."""
    status: types.EventTriggerStatus
    """State."""

    def __init__(self, type: types.EventTriggerType, status: types.EventTriggerStatus) -> None:
        self.type = type
        self.status = status

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2B.unpack(raw, at)
        self.type = codec.KNOWN[types.EventTriggerType][v[0]]
        self.status = codec.KNOWN[types.EventTriggerStatus][v[1]]
        return at + 2

    def _write(self) -> bytes:
        return _2B.write("type status", self.type, self.status)


class EventActionStatusEntry(Structure):
    """Type and trigger of one action.

    - 3dm-cv7-gnss-ins: Get Event Action Status (0x0C,0x2D)
    """

    __slots__ = ("action_type", "trigger_id")
    __match_args__ = ("action_type", "trigger_id")

    _SIZE = 2

    action_type: types.EventActionType
    """Configured type."""
    trigger_id: int
    """Trigger instance that the action follows."""

    def __init__(self, action_type: types.EventActionType, trigger_id: int) -> None:
        self.action_type = action_type
        self.trigger_id = trigger_id

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2B.unpack(raw, at)
        self.action_type = codec.KNOWN[types.EventActionType][v[0]]
        self.trigger_id = v[1]
        return at + 2

    def _write(self) -> bytes:
        return _2B.write("action_type trigger_id", self.action_type, self.trigger_id)


class ReceiverDynamics(codec.OpenEnum):
    """Motion that a GNSS receiver assumes. Uncertain: The SDK of 2014 numbers the modes 0 to 8, but
    the list in its comments lacks `fixed`, which u-blox receivers do not have either. Uncertain:
    The sources list only names; the descriptions of the modes are inferred from them.

    - mip-sdk-2014: GPS Dynamics Mode (0x0C,0x34)
    """

    PORTABLE = 0
    """Low accelerations; fits most applications."""
    FIXED = 1
    """Fixed installation."""
    STATIONARY = 2
    """At rest."""
    PEDESTRIAN = 3
    """Walking speed."""
    AUTOMOTIVE = 4
    """Road vehicles."""
    SEA = 5
    """Vessels at sea level."""
    AIRBORNE_1G = 6
    """Aircraft with accelerations below 1 g."""
    AIRBORNE_2G = 7
    """Aircraft with accelerations below 2 g."""
    AIRBORNE_4G = 8
    """Aircraft with accelerations below 4 g."""


@codec.open_flag(16)
class DataConditioningFlags(IntFlag):
    """Processing steps of 3-series devices. Uncertain: Bits 4, 5, 9 and 12 are from the single-byte
    protocol of the 3DM-GX3. MSCL has the quaternion as 0x10000, which exceeds 16 bits. Uncertain:
    The sources list only names; the descriptions of the bits are inferred from them.

    - mip-sdk-2014: IMU Signal Conditioning (0x0C,0x35)
    - mscl: IMU Signal Conditioning (0x0C,0x35)
    """

    ORIENTATION_CALCULATION = 1 << 0
    """Computes the orientation. Bit 0."""
    CONING_SCULLING = 1 << 1
    """Corrects coning and sculling. Bit 1."""
    LITTLE_ENDIAN_FLOATS = 1 << 4
    """Sends floats with the least significant byte first. Bit 4."""
    NAN_SUPPRESSED = 1 << 5
    """Suppresses values that are NaN (not a number). Bit 5."""
    FINITE_SIZE_CORRECTION = 1 << 6
    """Compensates for the distance between the accelerometers. Bit 6."""
    DISABLE_MAG = 1 << 8
    """Switches the magnetometer off. Bit 8."""
    MAG_LOW_POWER = 1 << 9
    """Reduces the power of the magnetometer. Bit 9."""
    DISABLE_NORTH_COMPENSATION = 1 << 10
    """Disables the heading correction. Bit 10."""
    DISABLE_UP_COMPENSATION = 1 << 11
    """Disables the pitch and roll correction. Bit 11."""
    QUATERNION_CALCULATION = 1 << 12
    """Computes the quaternion. Bit 12."""


class MagBandwidth(codec.OpenEnum):
    """Bandwidth of the magnetometer of 3-series devices.

    - mip-sdk-2014: IMU Signal Conditioning (0x0C,0x35)
    """

    HIGH = 0
    """High bandwidth."""
    LOW = 1
    """Low bandwidth."""


class ImuTimestampSelector(codec.OpenEnum):
    """A time counter of the sensor data.

    - mip-sdk-2014: IMU Timestamp (0x0C,0x36)
    """

    BEACON_SECONDS = 1
    """Seconds of the time beacon."""
    BEACON_NANOSECONDS = 2
    """Nanoseconds of the time beacon."""
    INTERNAL_TICKS = 3
    """Ticks of the internal clock. Uncertain: The source states 2 both for this value and for the
    nanoseconds.
    """


class OdometerMode(codec.OpenEnum):
    """Operating mode of the odometer input.

    - 3dm-cv7-gnss-ins: Odometer Configuration (0x0C,0x43)
    """

    DISABLED = 0
    """Not used."""
    QUADRATURE = 2
    """Quadrature encoder on two pins."""


class SensorRangeType(codec.OpenEnum):
    """A sensor whose range can be set.

    - 3dm-cv7-gnss-ins: Sensor Range (0x0C,0x52)
    """

    ALL = 0
    """All sensors; for save, load and default only."""
    ACCEL = 1
    GYRO = 2
    MAG = 3
    """On models with a magnetometer. Requires a magnetometer."""
    PRESSURE = 4
    """The pressure sensor. Requires a pressure sensor."""


class SensorRangeEntry(Structure):
    """A range that a sensor supports.

    - 3dm-cv7-gnss-ins: Get Calibrated Sensor Ranges (0x0C,0x53)
    """

    __slots__ = ("setting", "range")
    __match_args__ = ("setting", "range")

    _SIZE = 5

    setting: int
    """Value for `SensorRange`."""
    range: float
    """Largest measurable value."""

    def __init__(self, setting: int, range: float) -> None:
        self.setting = setting
        self.range = range

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _Bf.unpack(raw, at)
        if v[1] != v[1]:
            v = _Bf.keep_nan_bits(v, raw, at)
        self.setting, self.range = v
        return at + 5

    def _write(self) -> bytes:
        return _Bf.write("setting range", self.setting, self.range)


class InternalSensor(codec.OpenEnum):
    """A sensor inside a 3-series device.

    - mip-sdk-2014: Device Power State (0x0C,0x61)
    """

    IMU = 1
    """The inertial sensor."""
    GNSS = 2
    """The GNSS receiver. Requires a receiver."""


class StreamFormat(codec.OpenEnum):
    """Format of a data stream.

    - mip-sdk-2014: Data Stream Format (0x0C,0x60)
    """

    STANDARD = 1
    """MIP data fields."""
    WRAPPED_RAW = 2
    """The sensor's own packets, each in a MIP field."""


class SensorPowerState(codec.OpenEnum):
    """Power state of an internal sensor.

    - mip-sdk-2014: Device Power State (0x0C,0x61)
    """

    ON = 1
    """Full power."""
    LOW_POWER = 2
    """On with reduced power."""
    SLEEP = 3
    """Very low power; starts quickly."""
    OFF = 4
    """Off or in deep sleep."""


class DeviceStatusSelector(codec.OpenEnum):
    """Level of detail of a device status.

    - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
    """

    BASIC = 1
    """State and timer."""
    DIAGNOSTIC = 2
    """State, timer, and the counters of streams and port."""


class LegacyDataStream(codec.OpenEnum):
    """A data stream of a device of the generations 3 to 5.

    - 3dm-gx5-15: 4.2.7 Enable/Disable Continuous Data Stream (0x0C, 0x11)
    """

    ALL_STREAMS = 0
    """All streams; for save, load and default only."""
    IMU = 1
    """Sensor data (0x80)."""
    GNSS = 2
    """GNSS data. Requires a receiver."""
    FILTER = 3
    """Estimation filter data (0x82)."""


class Gx4SystemState(codec.OpenEnum):
    """State of the system in the device status of the 3DM-GX4-45 and the 3DM-RQ1-45.

    - mip-sdk-2014: Device Status (0x0C,0x64)
    """

    INIT = 1
    """The system is starting."""
    SENSOR_STARTUP = 2
    """The sensors are starting."""
    RUNNING = 3
    """The system is running."""


class ImuMessageFormatResponse(Response):
    """IMU message format response (0x0C,0x80).

    Response to `ImuMessageFormat`. Confirmed on 3DM-CV5-10, 3DM-CV5-15, 3DM-CX5-10, 3DM-GQ4-45,
    3DM-GX5-15, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 14
    more.

    - 3dm-gx5-15: 4.2.5 IMU Message Format (0x0C, 0x08)
    """

    __slots__ = ("descriptors",)
    __match_args__ = ("descriptors",)

    SET = 0x0C
    DESCRIPTOR = 0x80
    NAME = "3dm.imu_message_format_response"

    # On the wire only: num_descriptors. Number of fields. Counts the elements of `descriptors`.
    descriptors: tuple[types.DescriptorRate, ...]
    """Fields and decimations. Refers to fields of Sensor data."""

    def __init__(self, descriptors: Sequence[types.DescriptorRate]) -> None:
        self.descriptors = codec.several(descriptors)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _B.read(raw, at)
        n_num_descriptors = v[0]
        at += 1
        n = codec.counted(raw, at, n_num_descriptors, 3, 84)
        self.descriptors, at = codec.read_structures(types.DescriptorRate, raw, at, n)
        return at

    def _write(self) -> bytes:
        out = _B.write("num_descriptors", codec.count("descriptors", self.descriptors, 84))
        out += codec.write_structures(
            "descriptors", codec.at_most("descriptors", self.descriptors, 84), types.DescriptorRate
        )
        return codec.finished(out)


class GnssMessageFormatResponse(Response):
    """GNSS message format response (0x0C,0x81).

    Response to `GnssMessageFormat`. Confirmed on 3DM-GQ4-45, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT
    and 3DM-RQ1-45-ST; likely or assumed on 4 more.

    - mip-sdk-4: GNSS message format (0x0C,0x09)
    - 3dm-gx5-35: 4.2.6 GNSS Message Format (0x0C, 0x09)
    """

    __slots__ = ("descriptors",)
    __match_args__ = ("descriptors",)

    SET = 0x0C
    DESCRIPTOR = 0x81
    NAME = "3dm.gnss_message_format_response"

    # On the wire only: num_descriptors. Number of fields. Counts the elements of `descriptors`.
    # Range: 0 to 82.
    descriptors: tuple[types.DescriptorRate, ...]
    """Fields and decimations. Refers to fields of GNSS data."""

    def __init__(self, descriptors: Sequence[types.DescriptorRate]) -> None:
        self.descriptors = codec.several(descriptors)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _B.read(raw, at)
        n_num_descriptors = v[0]
        at += 1
        n = codec.counted(raw, at, n_num_descriptors, 3, 84)
        self.descriptors, at = codec.read_structures(types.DescriptorRate, raw, at, n)
        return at

    def _write(self) -> bytes:
        out = _B.write("num_descriptors", codec.count("descriptors", self.descriptors, 84))
        out += codec.write_structures(
            "descriptors", codec.at_most("descriptors", self.descriptors, 84), types.DescriptorRate
        )
        return codec.finished(out)


class FilterMessageFormatResponse(Response):
    """Estimation filter message format response (0x0C,0x82).

    Response to `FilterMessageFormat`. Confirmed on 3DM-CV5-15, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-45,
    3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 9 more.

    - 3dm-gx5-15: 4.2.6 Estimation Filter Message Format (0x0C, 0x0A)
    """

    __slots__ = ("descriptors",)
    __match_args__ = ("descriptors",)

    SET = 0x0C
    DESCRIPTOR = 0x82
    NAME = "3dm.filter_message_format_response"

    # On the wire only: num_descriptors. Number of fields. Counts the elements of `descriptors`.
    descriptors: tuple[types.DescriptorRate, ...]
    """Fields and decimations. Refers to fields of Filter data."""

    def __init__(self, descriptors: Sequence[types.DescriptorRate]) -> None:
        self.descriptors = codec.several(descriptors)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _B.read(raw, at)
        n_num_descriptors = v[0]
        at += 1
        n = codec.counted(raw, at, n_num_descriptors, 3, 84)
        self.descriptors, at = codec.read_structures(types.DescriptorRate, raw, at, n)
        return at

    def _write(self) -> bytes:
        out = _B.write("num_descriptors", codec.count("descriptors", self.descriptors, 84))
        out += codec.write_structures(
            "descriptors", codec.at_most("descriptors", self.descriptors, 84), types.DescriptorRate
        )
        return codec.finished(out)


class GetImuBaseRateResponse(Response):
    """Get IMU data base rate response (0x0C,0x83).

    Also called `imu_get_base_rate_response`. Response to `GetImuBaseRate`. Confirmed on 3DM-CV5-10,
    3DM-CV5-15, 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST;
    likely or assumed on 15 more.

    - 3dm-gx5-15: 4.2.3 Get IMU Data Base Rate (0x0C, 0x06)
    """

    __slots__ = ("rate",)
    __match_args__ = ("rate",)

    SET = 0x0C
    DESCRIPTOR = 0x83
    NAME = "3dm.get_imu_base_rate_response"
    _SIZE = 2

    rate: int
    """Base rate of the sensor data. Unit: Hz."""

    def __init__(self, rate: int) -> None:
        self.rate = rate

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.rate = _H.unpack(raw, at)[0]
        return at + 2

    def _write(self) -> bytes:
        return _H.write("rate", self.rate)


class GetGnssBaseRateResponse(Response):
    """Get GNSS data base rate response (0x0C,0x84).

    Also called `gnss_get_base_rate_response`. Response to `GetGnssBaseRate`. Confirmed on
    3DM-GQ4-45, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 4
    more. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: Gnss Get Base Rate (0x0C,0x07)
    """

    __slots__ = ("rate",)
    __match_args__ = ("rate",)

    SET = 0x0C
    DESCRIPTOR = 0x84
    NAME = "3dm.get_gnss_base_rate_response"
    _SIZE = 2

    rate: int
    """Base rate of the GNSS data. Unit: Hz."""

    def __init__(self, rate: int) -> None:
        self.rate = rate

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.rate = _H.unpack(raw, at)[0]
        return at + 2

    def _write(self) -> bytes:
        return _H.write("rate", self.rate)


class DataStreamControlResponse(Response):
    """Data stream control response (0x0C,0x85).

    Also called `datastream_control_response`. Response to `DataStreamControl`. Confirmed on
    3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35,
    3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 25 more.

    - 3dm-gx5-15: 4.2.7 Enable/Disable Continuous Data Stream (0x0C, 0x11)
    - 3dm-cv7-gnss-ins: Data Stream Control (0x0C,0x11)
    """

    __slots__ = ("descriptor_set", "enabled")
    __match_args__ = ("descriptor_set", "enabled")

    SET = 0x0C
    DESCRIPTOR = 0x85
    NAME = "3dm.data_stream_control_response"
    _SIZE = 2

    descriptor_set: int
    """Stream specified in the command.

    - On the 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-GX3-15,
      3DM-GX3-25, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX5-25 and 3DM-MV5-AR: values of `LegacyDataStream`;
      only `LegacyDataStream.ALL_STREAMS`, `LegacyDataStream.IMU` and `LegacyDataStream.FILTER`.
    - On the 3DM-CX5-45, 3DM-DH3, 3DM-GQ4-45, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-45, 3DM-GX4-IMU,
      3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and 3DM-RQ1-IMU: values of
      `LegacyDataStream`.
    - On the 3DM-GX5-15: values of `LegacyDataStream`; only `LegacyDataStream.IMU` and
      `LegacyDataStream.FILTER`.
    """
    enabled: bool
    """True if the stream is sent."""

    def __init__(self, descriptor_set: int, enabled: bool) -> None:
        self.descriptor_set = descriptor_set
        self.enabled = enabled

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2B.unpack(raw, at)
        self.descriptor_set = v[0]
        self.enabled = codec.TRUTH[v[1]]
        return at + 2

    def _write(self) -> bytes:
        return _2B.write("descriptor_set enabled", self.descriptor_set, self.enabled)


class ImuSignalConditioningResponse(Response):
    """IMU signal conditioning response (0x0C,0x86).

    No device is known for certain to support it. Response to `ImuSignalConditioning`. Known only
    from the MIP SDK of 2014 and MicroStrain Communication Library.

    - mip-sdk-2014: IMU signal conditioning (0x0C,0x35)
    - mscl: IMU signal conditioning (0x0C,0x35)
    """

    __slots__ = (
        "orientation_decimation",
        "data_conditioning_flags",
        "inertial_filter_width",
        "mag_filter_width",
        "up_compensation",
        "north_compensation",
        "mag_bandwidth",
        "reserved",
    )
    __match_args__ = (
        "orientation_decimation",
        "data_conditioning_flags",
        "inertial_filter_width",
        "mag_filter_width",
        "up_compensation",
        "north_compensation",
        "mag_bandwidth",
        "reserved",
    )

    SET = 0x0C
    DESCRIPTOR = 0x86
    NAME = "3dm.imu_signal_conditioning_response"
    _SIZE = 13

    orientation_decimation: int
    """Divisor of 1000 Hz that sets the rate at which the orientation is computed. Unit: 1. Range: 1
    to 1000.
    """
    data_conditioning_flags: DataConditioningFlags
    """Processing steps. Default: 3."""
    inertial_filter_width: int
    """Width of the accelerometer and gyroscope filter in samples. Unit: 1. Range: 1 to 32. Default:
    15.
    """
    mag_filter_width: int
    """Width of the magnetometer filter in samples. Unit: 1. Range: 1 to 32. Default: 17."""
    up_compensation: int
    """Time constant of the pitch and roll correction. Unit: s. Range: 1 to 1000. Default: 10."""
    north_compensation: int
    """Time constant of the heading correction. Unit: s. Range: 1 to 1000. Default: 10."""
    mag_bandwidth: MagBandwidth
    """Bandwidth of the magnetometer of 3-series devices."""
    reserved: int
    """Reserved."""

    def __init__(
        self,
        orientation_decimation: int,
        data_conditioning_flags: DataConditioningFlags,
        inertial_filter_width: int,
        mag_filter_width: int,
        up_compensation: int,
        north_compensation: int,
        mag_bandwidth: MagBandwidth,
        reserved: int = 0,
    ) -> None:
        self.orientation_decimation = orientation_decimation
        self.data_conditioning_flags = data_conditioning_flags
        self.inertial_filter_width = inertial_filter_width
        self.mag_filter_width = mag_filter_width
        self.up_compensation = up_compensation
        self.north_compensation = north_compensation
        self.mag_bandwidth = mag_bandwidth
        self.reserved = reserved

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2H2B2HBH.unpack(raw, at)
        self.orientation_decimation = v[0]
        self.data_conditioning_flags = codec.KNOWN[DataConditioningFlags][v[1]]
        self.inertial_filter_width = v[2]
        self.mag_filter_width = v[3]
        self.up_compensation = v[4]
        self.north_compensation = v[5]
        self.mag_bandwidth = codec.KNOWN[MagBandwidth][v[6]]
        self.reserved = v[7]
        return at + 13

    def _write(self) -> bytes:
        return _2H2B2HBH.write(
            "orientation_decimation data_conditioning_flags inertial_filter_width mag_filter_width up_compensation north_compensation mag_bandwidth reserved",
            self.orientation_decimation,
            self.data_conditioning_flags,
            self.inertial_filter_width,
            self.mag_filter_width,
            self.up_compensation,
            self.north_compensation,
            self.mag_bandwidth,
            self.reserved,
        )


class UartBaudRateResponse(Response):
    """UART baud rate response (0x0C,0x87).

    Also called `uart_baudrate_response`. Response to `UartBaudRate`. Confirmed on 3DM-CV7-GNSS/INS,
    3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 12
    more.

    - 3dm-gx5-15: 4.2.13 UART Baud Rate (0x0C, 0x40)
    - 3dm-cv7-gnss-ins: UART Baudrate (0x0C,0x40)
    """

    __slots__ = ("baud",)
    __match_args__ = ("baud",)

    SET = 0x0C
    DESCRIPTOR = 0x87
    NAME = "3dm.uart_baud_rate_response"
    _SIZE = 4

    baud: int
    """New baud rate; the port must support it. Unit: Bd."""

    def __init__(self, baud: int) -> None:
        self.baud = baud

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.baud = _I.unpack(raw, at)[0]
        return at + 4

    def _write(self) -> bytes:
        return _I.write("baud", self.baud)


class DataStreamFormatResponse(Response):
    """Data stream format response (0x0C,0x88).

    No device is known for certain to support it. Response to `DataStreamFormat`. Known only from
    the MIP SDK of 2014 and MicroStrain Communication Library.

    - mip-sdk-2014: Data stream format (0x0C,0x60)
    - mscl: Data stream format (0x0C,0x60)
    """

    __slots__ = ("stream", "format")
    __match_args__ = ("stream", "format")

    SET = 0x0C
    DESCRIPTOR = 0x88
    NAME = "3dm.data_stream_format_response"
    _SIZE = 2

    stream: InternalSensor
    """Stream whose format is set or read."""
    format: StreamFormat
    """Format of a data stream."""

    def __init__(self, stream: InternalSensor, format: StreamFormat) -> None:
        self.stream = stream
        self.format = format

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2B.unpack(raw, at)
        self.stream = codec.KNOWN[InternalSensor][v[0]]
        self.format = codec.KNOWN[StreamFormat][v[1]]
        return at + 2

    def _write(self) -> bytes:
        return _2B.write("stream format", self.stream, self.format)


class DevicePowerStateResponse(Response):
    """Device power state response (0x0C,0x89).

    No device is known for certain to support it. Response to `DevicePowerState`. Known only from
    the MIP SDK of 2014 and MicroStrain Communication Library.

    - mip-sdk-2014: Device power state (0x0C,0x61)
    - mscl: Device power state (0x0C,0x61)
    """

    __slots__ = ("device", "state")
    __match_args__ = ("device", "state")

    SET = 0x0C
    DESCRIPTOR = 0x89
    NAME = "3dm.device_power_state_response"
    _SIZE = 2

    device: InternalSensor
    """The sensor."""
    state: SensorPowerState
    """Power state of an internal sensor."""

    def __init__(self, device: InternalSensor, state: SensorPowerState) -> None:
        self.device = device
        self.state = state

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2B.unpack(raw, at)
        self.device = codec.KNOWN[InternalSensor][v[0]]
        self.state = codec.KNOWN[SensorPowerState][v[1]]
        return at + 2

    def _write(self) -> bytes:
        return _2B.write("device state", self.device, self.state)


class GetFilterBaseRateResponse(Response):
    """Get estimation filter data base rate response (0x0C,0x8A).

    Also called `filter_get_base_rate_response`. Response to `GetFilterBaseRate`. Confirmed on
    3DM-CV5-15, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or
    assumed on 9 more.

    - 3dm-gx5-15: 4.2.4 Get Estimation Filter Data Base Rate (0x0C, 0x0B)
    """

    __slots__ = ("rate",)
    __match_args__ = ("rate",)

    SET = 0x0C
    DESCRIPTOR = 0x8A
    NAME = "3dm.get_filter_base_rate_response"
    _SIZE = 2

    rate: int
    """Base rate of the filter data. Unit: Hz."""

    def __init__(self, rate: int) -> None:
        self.rate = rate

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.rate = _H.unpack(raw, at)[0]
        return at + 2

    def _write(self) -> bytes:
        return _H.write("rate", self.rate)


class ImuLowPassFilterResponse(Response):
    """Advanced low-pass filter settings response (0x0C,0x8B).

    Also called `imu_lowpass_filter_response`. Response to `ImuLowPassFilter`. Confirmed on
    3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GQ7-GNSS/INS, 3DM-GX5-15,
    3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 20 more.

    - 3dm-gx5-15: 4.2.14 Advanced Low-Pass Filter Settings (0x0C, 0x50)
    - 3dm-cv7-gnss-ins: Advanced Low-Pass Filter Settings (0x0C,0x50)
    """

    __slots__ = ("target_descriptor", "enable", "manual", "frequency", "reserved")
    __match_args__ = ("target_descriptor", "enable", "manual", "frequency", "reserved")

    SET = 0x0C
    DESCRIPTOR = 0x8B
    NAME = "3dm.imu_low_pass_filter_response"
    _SIZE = 6

    target_descriptor: int
    """Field descriptor in the sensor data set: scaled acceleration 0x04, angular rate 0x05,
    magnetic field 0x06 or pressure 0x17. Refers to fields of Sensor data.
    """
    enable: bool
    """True if the quantity is filtered. Default: true."""
    manual: bool
    """True uses `frequency`; false uses half the rate of the message format. Default: false."""
    frequency: int
    """Cutoff (-3 dB). It has no meaning if `manual` is false. Unit: Hz."""
    reserved: int
    """Reserved."""

    def __init__(
        self, target_descriptor: int, enable: bool, manual: bool, frequency: int, reserved: int = 0
    ) -> None:
        self.target_descriptor = target_descriptor
        self.enable = enable
        self.manual = manual
        self.frequency = frequency
        self.reserved = reserved

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _3BHB.unpack(raw, at)
        self.target_descriptor = v[0]
        self.enable = codec.TRUTH[v[1]]
        self.manual = codec.TRUTH[v[2]]
        self.frequency = v[3]
        self.reserved = v[4]
        return at + 6

    def _write(self) -> bytes:
        return _3BHB.write(
            "target_descriptor enable manual frequency reserved",
            self.target_descriptor,
            self.enable,
            self.manual,
            self.frequency,
            self.reserved,
        )


class NmeaMessageFormatResponse(Response):
    """NMEA message format response (0x0C,0x8C).

    Response to `NmeaMessageFormat`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 4 more.

    - 3dm-cv7-gnss-ins: NMEA Message Format (0x0C,0x0C)
    """

    __slots__ = ("format_entries",)
    __match_args__ = ("format_entries",)

    SET = 0x0C
    DESCRIPTOR = 0x8C
    NAME = "3dm.nmea_message_format_response"

    # On the wire only: count. Number of sentences. Counts the elements of `format_entries`.
    format_entries: tuple[types.NmeaMessage, ...]
    """Sentences to stream."""

    def __init__(self, format_entries: Sequence[types.NmeaMessage]) -> None:
        self.format_entries = codec.several(format_entries)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _B.read(raw, at)
        n_count = v[0]
        at += 1
        n = codec.counted(raw, at, n_count, 5, 50)
        self.format_entries, at = codec.read_structures(types.NmeaMessage, raw, at, n)
        return at

    def _write(self) -> bytes:
        out = _B.write("count", codec.count("format_entries", self.format_entries, 50))
        out += codec.write_structures(
            "format_entries",
            codec.at_most("format_entries", self.format_entries, 50),
            types.NmeaMessage,
        )
        return codec.finished(out)


class GetBaseRateResponse(Response):
    """Get data base rate response (0x0C,0x8E).

    Response to `GetBaseRate`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS and
    3DM-GQ7-GNSS/INS; likely or assumed on 7 more.

    - 3dm-cv7-gnss-ins: Get Data Base Rate (0x0C,0x0E)
    """

    __slots__ = ("descriptor_set", "rate")
    __match_args__ = ("descriptor_set", "rate")

    SET = 0x0C
    DESCRIPTOR = 0x8E
    NAME = "3dm.get_base_rate_response"
    _SIZE = 3

    descriptor_set: int
    """Data descriptor set specified in the command."""
    rate: int
    """Base rate; 0 if the rate is variable or unknown and data is sent as it arrives. Unit: Hz."""

    def __init__(self, descriptor_set: int, rate: int) -> None:
        self.descriptor_set = descriptor_set
        self.rate = rate

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.descriptor_set, self.rate = _BH.unpack(raw, at)
        return at + 3

    def _write(self) -> bytes:
        return _BH.write("descriptor_set rate", self.descriptor_set, self.rate)


class MessageFormatResponse(Response):
    """Message format response (0x0C,0x8F).

    Response to `MessageFormat`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10 more.

    - 3dm-cv7-gnss-ins: Message Format (0x0C,0x0F)
    """

    __slots__ = ("descriptor_set", "descriptors")
    __match_args__ = ("descriptor_set", "descriptors")

    SET = 0x0C
    DESCRIPTOR = 0x8F
    NAME = "3dm.message_format_response"

    descriptor_set: int
    """Data descriptor set."""
    # On the wire only: num_descriptors. Number of fields. Counts the elements of `descriptors`.
    descriptors: tuple[types.DescriptorRate, ...]
    """Fields and decimations. Refers to fields of `descriptor_set`."""

    def __init__(self, descriptor_set: int, descriptors: Sequence[types.DescriptorRate]) -> None:
        self.descriptor_set = descriptor_set
        self.descriptors = codec.several(descriptors)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2B.read(raw, at)
        self.descriptor_set = v[0]
        n_num_descriptors = v[1]
        at += 2
        n = codec.counted(raw, at, n_num_descriptors, 3, 83)
        self.descriptors, at = codec.read_structures(types.DescriptorRate, raw, at, n)
        return at

    def _write(self) -> bytes:
        out = _2B.write(
            "descriptor_set num_descriptors",
            self.descriptor_set,
            codec.count("descriptors", self.descriptors, 83),
        )
        out += codec.write_structures(
            "descriptors", codec.at_most("descriptors", self.descriptors, 83), types.DescriptorRate
        )
        return codec.finished(out)


class DeviceStatusBasicRq1ImuResponse(Response):
    """Basic device status (inertial sensor of the 3DM-RQ1-45) (0x0C,0x90).

    Timer only, in microseconds.

    No device is known for certain to support it. Response to `DeviceStatus`. Sent if
    `status_selector` is `DeviceStatusSelector.BASIC`. Uncertain: The SDK of 2014 lists the names of
    the values and the unit of the timer; the descriptions are inferred from the names.

    - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
    - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
    - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
    - mscl: Device status (0x0C,0x64)
    """

    __slots__ = ("status_flags", "system_timer")
    __match_args__ = ("status_flags", "system_timer")

    SET = 0x0C
    DESCRIPTOR = 0x90
    NAME = "3dm.device_status_basic_rq1_imu_response"

    # On the wire only: model_number. Model number of the inertial sensor. Always 6238.
    # On the wire only: status_selector. Basic status. Always 1.
    status_flags: int
    """Reserved."""
    system_timer: int
    """Time since start-up. Unit: us."""

    def __init__(self, status_flags: int, system_timer: int) -> None:
        self.status_flags = status_flags
        self.system_timer = system_timer

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _H.read(raw, at)
        codec.constant(v[0], 6238)
        at += 2
        v = _B.read(raw, at)
        codec.constant(v[0], 1)
        at += 1
        self.status_flags, self.system_timer = _IQ.read(raw, at)
        at += 12
        return at

    def _write(self) -> bytes:
        out = _H.write("model_number", 6238)
        out += _B.write("status_selector", 1)
        out += _IQ.write("status_flags system_timer", self.status_flags, self.system_timer)
        return codec.finished(out)

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return 15 <= len(data) and b"\x18^".startswith(data[0:2]) and b"\x01".startswith(data[2:3])


class DeviceStatusBasicResponse(Response):
    """Basic device status (0x0C,0x90).

    State and timer.

    Response to `DeviceStatus`. The size of its data distinguishes it from
    `DeviceStatusBasicWithoutStateResponse` and `DeviceStatusBasicGx3Response`. Sent if
    `status_selector` is `DeviceStatusSelector.BASIC`. Confirmed on 3DM-GQ4-45, 3DM-GX5-15,
    3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 9 more.

    - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
    - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
    - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
    - mscl: Device status (0x0C,0x64)
    """

    __slots__ = ("model_number", "status_flags", "system_state", "system_timer")
    __match_args__ = ("model_number", "status_flags", "system_state", "system_timer")

    SET = 0x0C
    DESCRIPTOR = 0x90
    NAME = "3dm.device_status_basic_response"

    model_number: int
    """Model number of the device."""
    # On the wire only: status_selector. Basic status. Always 1.
    status_flags: int
    """Reserved."""
    system_state: int
    """State of the system; the meaning of its values is not documented.

    - On the 3DM-GX4-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: values of `Gx4SystemState`.
    """
    system_timer: int
    """Time since start-up. Unit: ms."""

    def __init__(
        self, model_number: int, status_flags: int, system_state: int, system_timer: int
    ) -> None:
        self.model_number = model_number
        self.status_flags = status_flags
        self.system_state = system_state
        self.system_timer = system_timer

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _HB.read(raw, at)
        self.model_number = v[0]
        codec.constant(v[1], 1)
        at += 3
        self.status_flags, self.system_state, self.system_timer = _IHI.read(raw, at)
        at += 10
        return at

    def _write(self) -> bytes:
        out = _HB.write("model_number status_selector", self.model_number, 1)
        out += _IHI.write(
            "status_flags system_state system_timer",
            self.status_flags,
            self.system_state,
            self.system_timer,
        )
        return codec.finished(out)

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return 13 <= len(data) < 15 and b"\x01".startswith(data[2:3])


class DeviceStatusBasicWithoutStateResponse(Response):
    """Basic device status (without state) (0x0C,0x90).

    Timer only.

    No device is known for certain to support it. Response to `DeviceStatus`. The size of its data
    distinguishes it from `DeviceStatusBasicResponse` and `DeviceStatusBasicGx3Response`. Sent if
    `status_selector` is `DeviceStatusSelector.BASIC`. Uncertain: MSCL uses it for the 3DM-GX4-15,
    3DM-GX4-25, 3DM-GX5-10, 3DM-CX5-10 and 3DM-CV5-10, the SDK of 2014 for the 3DM-GX4-15, the
    3DM-GX4-25 and the inertial sensor of the 3DM-GX4-45; that the 3DM-CL5-10 has it is inferred.
    Uncertain: The manual of the 3DM-GX5-45 documents it too, but for the model number of another
    device; MSCL uses the layout with a state for that device.

    - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
    - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
    - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
    - mscl: Device status (0x0C,0x64)
    """

    __slots__ = ("model_number", "status_flags", "system_timer")
    __match_args__ = ("model_number", "status_flags", "system_timer")

    SET = 0x0C
    DESCRIPTOR = 0x90
    NAME = "3dm.device_status_basic_without_state_response"

    model_number: int
    """Model number of the device."""
    # On the wire only: status_selector. Basic status. Always 1.
    status_flags: int
    """Reserved."""
    system_timer: int
    """Time since start-up. Unit: ms."""

    def __init__(self, model_number: int, status_flags: int, system_timer: int) -> None:
        self.model_number = model_number
        self.status_flags = status_flags
        self.system_timer = system_timer

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _HB.read(raw, at)
        self.model_number = v[0]
        codec.constant(v[1], 1)
        at += 3
        self.status_flags, self.system_timer = _2I.read(raw, at)
        at += 8
        return at

    def _write(self) -> bytes:
        out = _HB.write("model_number status_selector", self.model_number, 1)
        out += _2I.write("status_flags system_timer", self.status_flags, self.system_timer)
        return codec.finished(out)

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return len(data) < 13 and b"\x01".startswith(data[2:3])


class DeviceStatusDiagnosticResponse(Response):
    """Diagnostic device status (0x0C,0x90).

    State, timer, and the counters of streams and port.

    Response to `DeviceStatus`. The size of its data distinguishes it from
    `DeviceStatusDiagnosticGnssResponse`, `DeviceStatusDiagnosticGq4_45Response`,
    `DeviceStatusDiagnosticRq1_45Response`, `DeviceStatusDiagnosticGx4Response`,
    `DeviceStatusDiagnosticImuResponse`, `DeviceStatusDiagnosticGx4ImuResponse`,
    `DeviceStatusDiagnosticRq1ImuResponse` and `DeviceStatusDiagnosticGx3Response`. Sent if
    `status_selector` is `DeviceStatusSelector.DIAGNOSTIC`. Confirmed on 3DM-GX5-15; likely or
    assumed on 7 more.

    - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
    - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
    - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
    - mscl: Device status (0x0C,0x64)
    """

    __slots__ = (
        "model_number",
        "status_flags",
        "system_state",
        "system_timer",
        "imu_stream_enabled",
        "filter_stream_enabled",
        "imu_dropped_packets",
        "filter_dropped_packets",
        "comm_port_bytes_written",
        "comm_port_bytes_read",
        "comm_port_write_overruns",
        "comm_port_read_overruns",
        "imu_parser_errors",
        "imu_message_count",
        "imu_last_message_time",
    )
    __match_args__ = (
        "model_number",
        "status_flags",
        "system_state",
        "system_timer",
        "imu_stream_enabled",
        "filter_stream_enabled",
        "imu_dropped_packets",
        "filter_dropped_packets",
        "comm_port_bytes_written",
        "comm_port_bytes_read",
        "comm_port_write_overruns",
        "comm_port_read_overruns",
        "imu_parser_errors",
        "imu_message_count",
        "imu_last_message_time",
    )

    SET = 0x0C
    DESCRIPTOR = 0x90
    NAME = "3dm.device_status_diagnostic_response"

    model_number: int
    """Model number of the device."""
    # On the wire only: status_selector. Diagnostic status. Always 2.
    status_flags: int
    """Reserved."""
    system_state: int
    """State of the system; the meaning of its values is not documented."""
    system_timer: int
    """Time since start-up. Unit: ms."""
    imu_stream_enabled: bool
    """True if sensor data is streamed."""
    filter_stream_enabled: bool
    """True if filter data is streamed."""
    imu_dropped_packets: int
    """Sensor data packets that were not sent. Unit: 1."""
    filter_dropped_packets: int
    """Filter data packets that were not sent. Unit: 1."""
    comm_port_bytes_written: int
    """Bytes sent over the port. Unit: byte."""
    comm_port_bytes_read: int
    """Bytes received over the port. Unit: byte."""
    comm_port_write_overruns: int
    """Overruns while writing to the port. Unit: 1."""
    comm_port_read_overruns: int
    """Overruns while reading from the port. Unit: 1."""
    imu_parser_errors: int
    """IMU messages that could not be parsed. Unit: 1."""
    imu_message_count: int
    """IMU messages that were read. Unit: 1."""
    imu_last_message_time: int
    """System timer at the last IMU message. Unit: ms."""

    def __init__(
        self,
        model_number: int,
        status_flags: int,
        system_state: int,
        system_timer: int,
        imu_stream_enabled: bool,
        filter_stream_enabled: bool,
        imu_dropped_packets: int,
        filter_dropped_packets: int,
        comm_port_bytes_written: int,
        comm_port_bytes_read: int,
        comm_port_write_overruns: int,
        comm_port_read_overruns: int,
        imu_parser_errors: int,
        imu_message_count: int,
        imu_last_message_time: int,
    ) -> None:
        self.model_number = model_number
        self.status_flags = status_flags
        self.system_state = system_state
        self.system_timer = system_timer
        self.imu_stream_enabled = imu_stream_enabled
        self.filter_stream_enabled = filter_stream_enabled
        self.imu_dropped_packets = imu_dropped_packets
        self.filter_dropped_packets = filter_dropped_packets
        self.comm_port_bytes_written = comm_port_bytes_written
        self.comm_port_bytes_read = comm_port_bytes_read
        self.comm_port_write_overruns = comm_port_write_overruns
        self.comm_port_read_overruns = comm_port_read_overruns
        self.imu_parser_errors = imu_parser_errors
        self.imu_message_count = imu_message_count
        self.imu_last_message_time = imu_last_message_time

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _HB.read(raw, at)
        self.model_number = v[0]
        codec.constant(v[1], 2)
        at += 3
        v = _IHI2B9I.read(raw, at)
        self.status_flags = v[0]
        self.system_state = v[1]
        self.system_timer = v[2]
        self.imu_stream_enabled = codec.TRUTH[v[3]]
        self.filter_stream_enabled = codec.TRUTH[v[4]]
        self.imu_dropped_packets = v[5]
        self.filter_dropped_packets = v[6]
        self.comm_port_bytes_written = v[7]
        self.comm_port_bytes_read = v[8]
        self.comm_port_write_overruns = v[9]
        self.comm_port_read_overruns = v[10]
        self.imu_parser_errors = v[11]
        self.imu_message_count = v[12]
        self.imu_last_message_time = v[13]
        at += 48
        return at

    def _write(self) -> bytes:
        out = _HB.write("model_number status_selector", self.model_number, 2)
        out += _IHI2B9I.write(
            "status_flags system_state system_timer imu_stream_enabled filter_stream_enabled imu_dropped_packets filter_dropped_packets comm_port_bytes_written comm_port_bytes_read comm_port_write_overruns comm_port_read_overruns imu_parser_errors imu_message_count imu_last_message_time",
            self.status_flags,
            self.system_state,
            self.system_timer,
            self.imu_stream_enabled,
            self.filter_stream_enabled,
            self.imu_dropped_packets,
            self.filter_dropped_packets,
            self.comm_port_bytes_written,
            self.comm_port_bytes_read,
            self.comm_port_write_overruns,
            self.comm_port_read_overruns,
            self.imu_parser_errors,
            self.imu_message_count,
            self.imu_last_message_time,
        )
        return codec.finished(out)

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return len(data) < 60 and b"\x02".startswith(data[2:3])


class DeviceStatusDiagnosticGnssResponse(Response):
    """Diagnostic device status (with GNSS) (0x0C,0x90).

    State, timer, and the counters of pulses, streams, port and receiver.

    Response to `DeviceStatus`. The size of its data distinguishes it from
    `DeviceStatusDiagnosticResponse`, `DeviceStatusDiagnosticGq4_45Response`,
    `DeviceStatusDiagnosticRq1_45Response`, `DeviceStatusDiagnosticGx4Response`,
    `DeviceStatusDiagnosticImuResponse`, `DeviceStatusDiagnosticGx4ImuResponse`,
    `DeviceStatusDiagnosticRq1ImuResponse` and `DeviceStatusDiagnosticGx3Response`. Sent if
    `status_selector` is `DeviceStatusSelector.DIAGNOSTIC`. Confirmed on 3DM-GX5-35 and 3DM-GX5-45;
    likely or assumed on 2 more. Uncertain: MSCL uses it for the 3DM-GX4-45 and the -35 and -45 of
    GX5 and CX5; its length is from a manual. Uncertain: MSCL lists only the names of the values,
    from which the descriptions are inferred; the times are assumed to be in ms like the system
    timer.

    - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
    - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
    - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
    - mscl: Device status (0x0C,0x64)
    """

    __slots__ = (
        "model_number",
        "status_flags",
        "system_state",
        "system_timer",
        "gnss_power_state",
        "pps_count",
        "pps_last_time",
        "imu_stream_enabled",
        "gnss_stream_enabled",
        "filter_stream_enabled",
        "imu_dropped_packets",
        "gnss_dropped_packets",
        "filter_dropped_packets",
        "comm_port_bytes_written",
        "comm_port_bytes_read",
        "comm_port_write_overruns",
        "comm_port_read_overruns",
        "imu_parser_errors",
        "imu_message_count",
        "imu_last_message_time",
        "gnss_parser_errors",
        "gnss_message_count",
        "gnss_last_message_time",
    )
    __match_args__ = (
        "model_number",
        "status_flags",
        "system_state",
        "system_timer",
        "gnss_power_state",
        "pps_count",
        "pps_last_time",
        "imu_stream_enabled",
        "gnss_stream_enabled",
        "filter_stream_enabled",
        "imu_dropped_packets",
        "gnss_dropped_packets",
        "filter_dropped_packets",
        "comm_port_bytes_written",
        "comm_port_bytes_read",
        "comm_port_write_overruns",
        "comm_port_read_overruns",
        "imu_parser_errors",
        "imu_message_count",
        "imu_last_message_time",
        "gnss_parser_errors",
        "gnss_message_count",
        "gnss_last_message_time",
    )

    SET = 0x0C
    DESCRIPTOR = 0x90
    NAME = "3dm.device_status_diagnostic_gnss_response"

    model_number: int
    """Model number of the device."""
    # On the wire only: status_selector. Diagnostic status. Always 2.
    status_flags: int
    """Reserved."""
    system_state: int
    """State of the system; the meaning of its values is not documented."""
    system_timer: int
    """Time since start-up. Unit: ms."""
    gnss_power_state: int
    """Power state of the GNSS receiver."""
    pps_count: int
    """Number of PPS pulses counted. Unit: 1."""
    pps_last_time: int
    """System timer at the last pulse. Unit: ms."""
    imu_stream_enabled: bool
    """True if sensor data is streamed."""
    gnss_stream_enabled: bool
    """True if GNSS data is streamed."""
    filter_stream_enabled: bool
    """True if filter data is streamed."""
    imu_dropped_packets: int
    """Sensor data packets that were not sent. Unit: 1."""
    gnss_dropped_packets: int
    """GNSS data packets that were not sent. Unit: 1."""
    filter_dropped_packets: int
    """Filter data packets that were not sent. Unit: 1."""
    comm_port_bytes_written: int
    """Bytes sent over the port. Unit: byte."""
    comm_port_bytes_read: int
    """Bytes received over the port. Unit: byte."""
    comm_port_write_overruns: int
    """Overruns while writing to the port. Unit: 1."""
    comm_port_read_overruns: int
    """Overruns while reading from the port. Unit: 1."""
    imu_parser_errors: int
    """IMU messages that could not be parsed. Unit: 1."""
    imu_message_count: int
    """IMU messages that were read. Unit: 1."""
    imu_last_message_time: int
    """System timer at the last IMU message. Unit: ms."""
    gnss_parser_errors: int
    """Receiver messages that could not be parsed. Unit: 1."""
    gnss_message_count: int
    """Receiver messages that were read. Unit: 1."""
    gnss_last_message_time: int
    """System timer at the last receiver message. Unit: ms."""

    def __init__(
        self,
        model_number: int,
        status_flags: int,
        system_state: int,
        system_timer: int,
        gnss_power_state: int,
        pps_count: int,
        pps_last_time: int,
        imu_stream_enabled: bool,
        gnss_stream_enabled: bool,
        filter_stream_enabled: bool,
        imu_dropped_packets: int,
        gnss_dropped_packets: int,
        filter_dropped_packets: int,
        comm_port_bytes_written: int,
        comm_port_bytes_read: int,
        comm_port_write_overruns: int,
        comm_port_read_overruns: int,
        imu_parser_errors: int,
        imu_message_count: int,
        imu_last_message_time: int,
        gnss_parser_errors: int,
        gnss_message_count: int,
        gnss_last_message_time: int,
    ) -> None:
        self.model_number = model_number
        self.status_flags = status_flags
        self.system_state = system_state
        self.system_timer = system_timer
        self.gnss_power_state = gnss_power_state
        self.pps_count = pps_count
        self.pps_last_time = pps_last_time
        self.imu_stream_enabled = imu_stream_enabled
        self.gnss_stream_enabled = gnss_stream_enabled
        self.filter_stream_enabled = filter_stream_enabled
        self.imu_dropped_packets = imu_dropped_packets
        self.gnss_dropped_packets = gnss_dropped_packets
        self.filter_dropped_packets = filter_dropped_packets
        self.comm_port_bytes_written = comm_port_bytes_written
        self.comm_port_bytes_read = comm_port_bytes_read
        self.comm_port_write_overruns = comm_port_write_overruns
        self.comm_port_read_overruns = comm_port_read_overruns
        self.imu_parser_errors = imu_parser_errors
        self.imu_message_count = imu_message_count
        self.imu_last_message_time = imu_last_message_time
        self.gnss_parser_errors = gnss_parser_errors
        self.gnss_message_count = gnss_message_count
        self.gnss_last_message_time = gnss_last_message_time

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _HB.read(raw, at)
        self.model_number = v[0]
        codec.constant(v[1], 2)
        at += 3
        v = _IHIB2I3B13I.read(raw, at)
        self.status_flags = v[0]
        self.system_state = v[1]
        self.system_timer = v[2]
        self.gnss_power_state = v[3]
        self.pps_count = v[4]
        self.pps_last_time = v[5]
        self.imu_stream_enabled = codec.TRUTH[v[6]]
        self.gnss_stream_enabled = codec.TRUTH[v[7]]
        self.filter_stream_enabled = codec.TRUTH[v[8]]
        self.imu_dropped_packets = v[9]
        self.gnss_dropped_packets = v[10]
        self.filter_dropped_packets = v[11]
        self.comm_port_bytes_written = v[12]
        self.comm_port_bytes_read = v[13]
        self.comm_port_write_overruns = v[14]
        self.comm_port_read_overruns = v[15]
        self.imu_parser_errors = v[16]
        self.imu_message_count = v[17]
        self.imu_last_message_time = v[18]
        self.gnss_parser_errors = v[19]
        self.gnss_message_count = v[20]
        self.gnss_last_message_time = v[21]
        at += 74
        return at

    def _write(self) -> bytes:
        out = _HB.write("model_number status_selector", self.model_number, 2)
        out += _IHIB2I3B13I.write(
            "status_flags system_state system_timer gnss_power_state pps_count pps_last_time imu_stream_enabled gnss_stream_enabled filter_stream_enabled imu_dropped_packets gnss_dropped_packets filter_dropped_packets comm_port_bytes_written comm_port_bytes_read comm_port_write_overruns comm_port_read_overruns imu_parser_errors imu_message_count imu_last_message_time gnss_parser_errors gnss_message_count gnss_last_message_time",
            self.status_flags,
            self.system_state,
            self.system_timer,
            self.gnss_power_state,
            self.pps_count,
            self.pps_last_time,
            self.imu_stream_enabled,
            self.gnss_stream_enabled,
            self.filter_stream_enabled,
            self.imu_dropped_packets,
            self.gnss_dropped_packets,
            self.filter_dropped_packets,
            self.comm_port_bytes_written,
            self.comm_port_bytes_read,
            self.comm_port_write_overruns,
            self.comm_port_read_overruns,
            self.imu_parser_errors,
            self.imu_message_count,
            self.imu_last_message_time,
            self.gnss_parser_errors,
            self.gnss_message_count,
            self.gnss_last_message_time,
        )
        return codec.finished(out)

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return 77 <= len(data) < 80 and b"\x02".startswith(data[2:3])


class DeviceStatusDiagnosticGq4_45Response(Response):
    """Diagnostic device status (3DM-GQ4-45) (0x0C,0x90).

    The layout with GNSS, plus flags for parts that could not be started.

    Response to `DeviceStatus`. The size of its data distinguishes it from
    `DeviceStatusDiagnosticResponse`, `DeviceStatusDiagnosticGnssResponse`,
    `DeviceStatusDiagnosticRq1_45Response`, `DeviceStatusDiagnosticGx4Response`,
    `DeviceStatusDiagnosticImuResponse`, `DeviceStatusDiagnosticGx4ImuResponse`,
    `DeviceStatusDiagnosticRq1ImuResponse` and `DeviceStatusDiagnosticGx3Response`. Sent if
    `status_selector` is `DeviceStatusSelector.DIAGNOSTIC`. Supported by 3DM-GQ4-45. Uncertain: No
    known manual documents it. Uncertain: MSCL lists only the names of the values, from which the
    descriptions are inferred; the times are assumed to be in ms like the system timer.

    - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
    - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
    - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
    - mscl: Device status (0x0C,0x64)
    """

    __slots__ = (
        "model_number",
        "status_flags",
        "system_state",
        "system_timer",
        "gnss_power_state",
        "pps_count",
        "pps_last_time",
        "imu_stream_enabled",
        "gnss_stream_enabled",
        "filter_stream_enabled",
        "imu_dropped_packets",
        "gnss_dropped_packets",
        "filter_dropped_packets",
        "comm_port_bytes_written",
        "comm_port_bytes_read",
        "comm_port_write_overruns",
        "comm_port_read_overruns",
        "imu_parser_errors",
        "imu_message_count",
        "imu_last_message_time",
        "gnss_parser_errors",
        "gnss_message_count",
        "gnss_last_message_time",
        "mag_init_failed",
        "pressure_init_failed",
        "receiver_init_failed",
    )
    __match_args__ = (
        "model_number",
        "status_flags",
        "system_state",
        "system_timer",
        "gnss_power_state",
        "pps_count",
        "pps_last_time",
        "imu_stream_enabled",
        "gnss_stream_enabled",
        "filter_stream_enabled",
        "imu_dropped_packets",
        "gnss_dropped_packets",
        "filter_dropped_packets",
        "comm_port_bytes_written",
        "comm_port_bytes_read",
        "comm_port_write_overruns",
        "comm_port_read_overruns",
        "imu_parser_errors",
        "imu_message_count",
        "imu_last_message_time",
        "gnss_parser_errors",
        "gnss_message_count",
        "gnss_last_message_time",
        "mag_init_failed",
        "pressure_init_failed",
        "receiver_init_failed",
    )

    SET = 0x0C
    DESCRIPTOR = 0x90
    NAME = "3dm.device_status_diagnostic_gq4_45_response"

    model_number: int
    """Model number of the device."""
    # On the wire only: status_selector. Diagnostic status. Always 2.
    status_flags: int
    """Reserved."""
    system_state: int
    """State of the system; the meaning of its values is not documented."""
    system_timer: int
    """Time since start-up. Unit: ms."""
    gnss_power_state: int
    """Power state of the GNSS receiver."""
    pps_count: int
    """Number of PPS pulses counted. Unit: 1."""
    pps_last_time: int
    """System timer at the last pulse. Unit: ms."""
    imu_stream_enabled: bool
    """True if sensor data is streamed."""
    gnss_stream_enabled: bool
    """True if GNSS data is streamed."""
    filter_stream_enabled: bool
    """True if filter data is streamed."""
    imu_dropped_packets: int
    """Sensor data packets that were not sent. Unit: 1."""
    gnss_dropped_packets: int
    """GNSS data packets that were not sent. Unit: 1."""
    filter_dropped_packets: int
    """Filter data packets that were not sent. Unit: 1."""
    comm_port_bytes_written: int
    """Bytes sent over the port. Unit: byte."""
    comm_port_bytes_read: int
    """Bytes received over the port. Unit: byte."""
    comm_port_write_overruns: int
    """Overruns while writing to the port. Unit: 1."""
    comm_port_read_overruns: int
    """Overruns while reading from the port. Unit: 1."""
    imu_parser_errors: int
    """IMU messages that could not be parsed. Unit: 1."""
    imu_message_count: int
    """IMU messages that were read. Unit: 1."""
    imu_last_message_time: int
    """System timer at the last IMU message. Unit: ms."""
    gnss_parser_errors: int
    """Receiver messages that could not be parsed. Unit: 1."""
    gnss_message_count: int
    """Receiver messages that were read. Unit: 1."""
    gnss_last_message_time: int
    """System timer at the last receiver message. Unit: ms."""
    mag_init_failed: bool
    """True if the magnetometer could not be started."""
    pressure_init_failed: bool
    """True if the pressure sensor could not be started."""
    receiver_init_failed: bool
    """True if the GNSS receiver could not be started."""

    def __init__(
        self,
        model_number: int,
        status_flags: int,
        system_state: int,
        system_timer: int,
        gnss_power_state: int,
        pps_count: int,
        pps_last_time: int,
        imu_stream_enabled: bool,
        gnss_stream_enabled: bool,
        filter_stream_enabled: bool,
        imu_dropped_packets: int,
        gnss_dropped_packets: int,
        filter_dropped_packets: int,
        comm_port_bytes_written: int,
        comm_port_bytes_read: int,
        comm_port_write_overruns: int,
        comm_port_read_overruns: int,
        imu_parser_errors: int,
        imu_message_count: int,
        imu_last_message_time: int,
        gnss_parser_errors: int,
        gnss_message_count: int,
        gnss_last_message_time: int,
        mag_init_failed: bool,
        pressure_init_failed: bool,
        receiver_init_failed: bool,
    ) -> None:
        self.model_number = model_number
        self.status_flags = status_flags
        self.system_state = system_state
        self.system_timer = system_timer
        self.gnss_power_state = gnss_power_state
        self.pps_count = pps_count
        self.pps_last_time = pps_last_time
        self.imu_stream_enabled = imu_stream_enabled
        self.gnss_stream_enabled = gnss_stream_enabled
        self.filter_stream_enabled = filter_stream_enabled
        self.imu_dropped_packets = imu_dropped_packets
        self.gnss_dropped_packets = gnss_dropped_packets
        self.filter_dropped_packets = filter_dropped_packets
        self.comm_port_bytes_written = comm_port_bytes_written
        self.comm_port_bytes_read = comm_port_bytes_read
        self.comm_port_write_overruns = comm_port_write_overruns
        self.comm_port_read_overruns = comm_port_read_overruns
        self.imu_parser_errors = imu_parser_errors
        self.imu_message_count = imu_message_count
        self.imu_last_message_time = imu_last_message_time
        self.gnss_parser_errors = gnss_parser_errors
        self.gnss_message_count = gnss_message_count
        self.gnss_last_message_time = gnss_last_message_time
        self.mag_init_failed = mag_init_failed
        self.pressure_init_failed = pressure_init_failed
        self.receiver_init_failed = receiver_init_failed

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _HB.read(raw, at)
        self.model_number = v[0]
        codec.constant(v[1], 2)
        at += 3
        v = _IHIB2I3B13I3B.read(raw, at)
        self.status_flags = v[0]
        self.system_state = v[1]
        self.system_timer = v[2]
        self.gnss_power_state = v[3]
        self.pps_count = v[4]
        self.pps_last_time = v[5]
        self.imu_stream_enabled = codec.TRUTH[v[6]]
        self.gnss_stream_enabled = codec.TRUTH[v[7]]
        self.filter_stream_enabled = codec.TRUTH[v[8]]
        self.imu_dropped_packets = v[9]
        self.gnss_dropped_packets = v[10]
        self.filter_dropped_packets = v[11]
        self.comm_port_bytes_written = v[12]
        self.comm_port_bytes_read = v[13]
        self.comm_port_write_overruns = v[14]
        self.comm_port_read_overruns = v[15]
        self.imu_parser_errors = v[16]
        self.imu_message_count = v[17]
        self.imu_last_message_time = v[18]
        self.gnss_parser_errors = v[19]
        self.gnss_message_count = v[20]
        self.gnss_last_message_time = v[21]
        self.mag_init_failed = codec.TRUTH[v[22]]
        self.pressure_init_failed = codec.TRUTH[v[23]]
        self.receiver_init_failed = codec.TRUTH[v[24]]
        at += 77
        return at

    def _write(self) -> bytes:
        out = _HB.write("model_number status_selector", self.model_number, 2)
        out += _IHIB2I3B13I3B.write(
            "status_flags system_state system_timer gnss_power_state pps_count pps_last_time imu_stream_enabled gnss_stream_enabled filter_stream_enabled imu_dropped_packets gnss_dropped_packets filter_dropped_packets comm_port_bytes_written comm_port_bytes_read comm_port_write_overruns comm_port_read_overruns imu_parser_errors imu_message_count imu_last_message_time gnss_parser_errors gnss_message_count gnss_last_message_time mag_init_failed pressure_init_failed receiver_init_failed",
            self.status_flags,
            self.system_state,
            self.system_timer,
            self.gnss_power_state,
            self.pps_count,
            self.pps_last_time,
            self.imu_stream_enabled,
            self.gnss_stream_enabled,
            self.filter_stream_enabled,
            self.imu_dropped_packets,
            self.gnss_dropped_packets,
            self.filter_dropped_packets,
            self.comm_port_bytes_written,
            self.comm_port_bytes_read,
            self.comm_port_write_overruns,
            self.comm_port_read_overruns,
            self.imu_parser_errors,
            self.imu_message_count,
            self.imu_last_message_time,
            self.gnss_parser_errors,
            self.gnss_message_count,
            self.gnss_last_message_time,
            self.mag_init_failed,
            self.pressure_init_failed,
            self.receiver_init_failed,
        )
        return codec.finished(out)

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return 80 <= len(data) < 86 and b"\x02".startswith(data[2:3])


class DeviceStatusDiagnosticRq1_45Response(Response):
    """Diagnostic device status (3DM-RQ1-45) (0x0C,0x90).

    The layout with GNSS, plus the temperature.

    Response to `DeviceStatus`. The size of its data distinguishes it from
    `DeviceStatusDiagnosticResponse`, `DeviceStatusDiagnosticGnssResponse`,
    `DeviceStatusDiagnosticGq4_45Response`, `DeviceStatusDiagnosticGx4Response`,
    `DeviceStatusDiagnosticImuResponse`, `DeviceStatusDiagnosticGx4ImuResponse`,
    `DeviceStatusDiagnosticRq1ImuResponse` and `DeviceStatusDiagnosticGx3Response`. Sent if
    `status_selector` is `DeviceStatusSelector.DIAGNOSTIC`. Supported by 3DM-RQ1-45-LT and
    3DM-RQ1-45-ST. Uncertain: No known manual documents it. Uncertain: MSCL lists only the names of
    the values, from which the descriptions are inferred; the times are assumed to be in ms like the
    system timer.

    - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
    - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
    - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
    - mscl: Device status (0x0C,0x64)
    """

    __slots__ = (
        "model_number",
        "status_flags",
        "system_state",
        "system_timer",
        "gnss_power_state",
        "cold_start_on_power_on",
        "temperature",
        "temperature_last_time",
        "pps_count",
        "pps_last_time",
        "imu_stream_enabled",
        "gnss_stream_enabled",
        "filter_stream_enabled",
        "imu_dropped_packets",
        "gnss_dropped_packets",
        "filter_dropped_packets",
        "comm_port_bytes_written",
        "comm_port_bytes_read",
        "comm_port_write_overruns",
        "comm_port_read_overruns",
        "imu_parser_errors",
        "imu_message_count",
        "imu_last_message_time",
        "gnss_parser_errors",
        "gnss_message_count",
        "gnss_last_message_time",
    )
    __match_args__ = (
        "model_number",
        "status_flags",
        "system_state",
        "system_timer",
        "gnss_power_state",
        "cold_start_on_power_on",
        "temperature",
        "temperature_last_time",
        "pps_count",
        "pps_last_time",
        "imu_stream_enabled",
        "gnss_stream_enabled",
        "filter_stream_enabled",
        "imu_dropped_packets",
        "gnss_dropped_packets",
        "filter_dropped_packets",
        "comm_port_bytes_written",
        "comm_port_bytes_read",
        "comm_port_write_overruns",
        "comm_port_read_overruns",
        "imu_parser_errors",
        "imu_message_count",
        "imu_last_message_time",
        "gnss_parser_errors",
        "gnss_message_count",
        "gnss_last_message_time",
    )

    SET = 0x0C
    DESCRIPTOR = 0x90
    NAME = "3dm.device_status_diagnostic_rq1_45_response"

    model_number: int
    """Model number of the device."""
    # On the wire only: status_selector. Diagnostic status. Always 2.
    status_flags: int
    """Reserved."""
    system_state: int
    """State of the system; the meaning of its values is not documented."""
    system_timer: int
    """Time since start-up. Unit: ms."""
    gnss_power_state: int
    """Power state of the GNSS receiver."""
    cold_start_on_power_on: int
    """True if the receiver starts cold at power-up."""
    temperature: float
    """Temperature of the board. Unit: degC. Uncertain: The unit is inferred."""
    temperature_last_time: int
    """System timer at the last temperature measurement. Unit: ms."""
    pps_count: int
    """Number of PPS pulses counted. Unit: 1."""
    pps_last_time: int
    """System timer at the last pulse. Unit: ms."""
    imu_stream_enabled: bool
    """True if sensor data is streamed."""
    gnss_stream_enabled: bool
    """True if GNSS data is streamed."""
    filter_stream_enabled: bool
    """True if filter data is streamed."""
    imu_dropped_packets: int
    """Sensor data packets that were not sent. Unit: 1."""
    gnss_dropped_packets: int
    """GNSS data packets that were not sent. Unit: 1."""
    filter_dropped_packets: int
    """Filter data packets that were not sent. Unit: 1."""
    comm_port_bytes_written: int
    """Bytes sent over the port. Unit: byte."""
    comm_port_bytes_read: int
    """Bytes received over the port. Unit: byte."""
    comm_port_write_overruns: int
    """Overruns while writing to the port. Unit: 1."""
    comm_port_read_overruns: int
    """Overruns while reading from the port. Unit: 1."""
    imu_parser_errors: int
    """IMU messages that could not be parsed. Unit: 1."""
    imu_message_count: int
    """IMU messages that were read. Unit: 1."""
    imu_last_message_time: int
    """System timer at the last IMU message. Unit: ms."""
    gnss_parser_errors: int
    """Receiver messages that could not be parsed. Unit: 1."""
    gnss_message_count: int
    """Receiver messages that were read. Unit: 1."""
    gnss_last_message_time: int
    """System timer at the last receiver message. Unit: ms."""

    def __init__(
        self,
        model_number: int,
        status_flags: int,
        system_state: int,
        system_timer: int,
        gnss_power_state: int,
        cold_start_on_power_on: int,
        temperature: float,
        temperature_last_time: int,
        pps_count: int,
        pps_last_time: int,
        imu_stream_enabled: bool,
        gnss_stream_enabled: bool,
        filter_stream_enabled: bool,
        imu_dropped_packets: int,
        gnss_dropped_packets: int,
        filter_dropped_packets: int,
        comm_port_bytes_written: int,
        comm_port_bytes_read: int,
        comm_port_write_overruns: int,
        comm_port_read_overruns: int,
        imu_parser_errors: int,
        imu_message_count: int,
        imu_last_message_time: int,
        gnss_parser_errors: int,
        gnss_message_count: int,
        gnss_last_message_time: int,
    ) -> None:
        self.model_number = model_number
        self.status_flags = status_flags
        self.system_state = system_state
        self.system_timer = system_timer
        self.gnss_power_state = gnss_power_state
        self.cold_start_on_power_on = cold_start_on_power_on
        self.temperature = temperature
        self.temperature_last_time = temperature_last_time
        self.pps_count = pps_count
        self.pps_last_time = pps_last_time
        self.imu_stream_enabled = imu_stream_enabled
        self.gnss_stream_enabled = gnss_stream_enabled
        self.filter_stream_enabled = filter_stream_enabled
        self.imu_dropped_packets = imu_dropped_packets
        self.gnss_dropped_packets = gnss_dropped_packets
        self.filter_dropped_packets = filter_dropped_packets
        self.comm_port_bytes_written = comm_port_bytes_written
        self.comm_port_bytes_read = comm_port_bytes_read
        self.comm_port_write_overruns = comm_port_write_overruns
        self.comm_port_read_overruns = comm_port_read_overruns
        self.imu_parser_errors = imu_parser_errors
        self.imu_message_count = imu_message_count
        self.imu_last_message_time = imu_last_message_time
        self.gnss_parser_errors = gnss_parser_errors
        self.gnss_message_count = gnss_message_count
        self.gnss_last_message_time = gnss_last_message_time

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _HB.read(raw, at)
        self.model_number = v[0]
        codec.constant(v[1], 2)
        at += 3
        v = _IHI2Bf3I3B13I.read(raw, at)
        self.status_flags = v[0]
        self.system_state = v[1]
        self.system_timer = v[2]
        self.gnss_power_state = v[3]
        self.cold_start_on_power_on = v[4]
        self.temperature = v[5]
        self.temperature_last_time = v[6]
        self.pps_count = v[7]
        self.pps_last_time = v[8]
        self.imu_stream_enabled = codec.TRUTH[v[9]]
        self.gnss_stream_enabled = codec.TRUTH[v[10]]
        self.filter_stream_enabled = codec.TRUTH[v[11]]
        self.imu_dropped_packets = v[12]
        self.gnss_dropped_packets = v[13]
        self.filter_dropped_packets = v[14]
        self.comm_port_bytes_written = v[15]
        self.comm_port_bytes_read = v[16]
        self.comm_port_write_overruns = v[17]
        self.comm_port_read_overruns = v[18]
        self.imu_parser_errors = v[19]
        self.imu_message_count = v[20]
        self.imu_last_message_time = v[21]
        self.gnss_parser_errors = v[22]
        self.gnss_message_count = v[23]
        self.gnss_last_message_time = v[24]
        at += 83
        return at

    def _write(self) -> bytes:
        out = _HB.write("model_number status_selector", self.model_number, 2)
        out += _IHI2Bf3I3B13I.write(
            "status_flags system_state system_timer gnss_power_state cold_start_on_power_on temperature temperature_last_time pps_count pps_last_time imu_stream_enabled gnss_stream_enabled filter_stream_enabled imu_dropped_packets gnss_dropped_packets filter_dropped_packets comm_port_bytes_written comm_port_bytes_read comm_port_write_overruns comm_port_read_overruns imu_parser_errors imu_message_count imu_last_message_time gnss_parser_errors gnss_message_count gnss_last_message_time",
            self.status_flags,
            self.system_state,
            self.system_timer,
            self.gnss_power_state,
            self.cold_start_on_power_on,
            self.temperature,
            self.temperature_last_time,
            self.pps_count,
            self.pps_last_time,
            self.imu_stream_enabled,
            self.gnss_stream_enabled,
            self.filter_stream_enabled,
            self.imu_dropped_packets,
            self.gnss_dropped_packets,
            self.filter_dropped_packets,
            self.comm_port_bytes_written,
            self.comm_port_bytes_read,
            self.comm_port_write_overruns,
            self.comm_port_read_overruns,
            self.imu_parser_errors,
            self.imu_message_count,
            self.imu_last_message_time,
            self.gnss_parser_errors,
            self.gnss_message_count,
            self.gnss_last_message_time,
        )
        return codec.finished(out)

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return 86 <= len(data) < 105 and b"\x02".startswith(data[2:3])


class DeviceStatusDiagnosticGx4Response(Response):
    """Diagnostic device status (3DM-GX4-15, 3DM-GX4-25) (0x0C,0x90).

    Timer, and counters of pulses, streams, port and USB.

    No device is known for certain to support it. Response to `DeviceStatus`. The size of its data
    distinguishes it from `DeviceStatusDiagnosticResponse`, `DeviceStatusDiagnosticGnssResponse`,
    `DeviceStatusDiagnosticGq4_45Response`, `DeviceStatusDiagnosticRq1_45Response`,
    `DeviceStatusDiagnosticImuResponse`, `DeviceStatusDiagnosticGx4ImuResponse`,
    `DeviceStatusDiagnosticRq1ImuResponse` and `DeviceStatusDiagnosticGx3Response`. Sent if
    `status_selector` is `DeviceStatusSelector.DIAGNOSTIC`. Uncertain: No known manual documents it
    for these devices; the offsets 49 to 69 in the manual of the 3DM-GX5-45 agree. Uncertain: MSCL
    lists only the names of the values, from which the descriptions are inferred; the times are
    assumed to be in ms like the system timer.

    - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
    - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
    - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
    - mscl: Device status (0x0C,0x64)
    """

    __slots__ = (
        "model_number",
        "status_flags",
        "system_timer",
        "pps_count",
        "pps_last_time",
        "imu_stream_enabled",
        "filter_stream_enabled",
        "imu_dropped_packets",
        "filter_dropped_packets",
        "comm_port_bytes_written",
        "comm_port_bytes_read",
        "comm_port_write_overruns",
        "comm_port_read_overruns",
        "usb_bytes_written",
        "usb_bytes_read",
        "usb_write_overruns",
        "usb_read_overruns",
        "imu_parser_errors",
        "imu_message_count",
        "imu_last_message_time",
    )
    __match_args__ = (
        "model_number",
        "status_flags",
        "system_timer",
        "pps_count",
        "pps_last_time",
        "imu_stream_enabled",
        "filter_stream_enabled",
        "imu_dropped_packets",
        "filter_dropped_packets",
        "comm_port_bytes_written",
        "comm_port_bytes_read",
        "comm_port_write_overruns",
        "comm_port_read_overruns",
        "usb_bytes_written",
        "usb_bytes_read",
        "usb_write_overruns",
        "usb_read_overruns",
        "imu_parser_errors",
        "imu_message_count",
        "imu_last_message_time",
    )

    SET = 0x0C
    DESCRIPTOR = 0x90
    NAME = "3dm.device_status_diagnostic_gx4_response"

    model_number: int
    """Model number of the device."""
    # On the wire only: status_selector. Diagnostic status. Always 2.
    status_flags: int
    """Reserved."""
    system_timer: int
    """Time since start-up. Unit: ms."""
    pps_count: int
    """Number of PPS pulses counted. Unit: 1."""
    pps_last_time: int
    """System timer at the last pulse. Unit: ms."""
    imu_stream_enabled: bool
    """True if sensor data is streamed."""
    filter_stream_enabled: bool
    """True if filter data is streamed."""
    imu_dropped_packets: int
    """Sensor data packets that were not sent. Unit: 1."""
    filter_dropped_packets: int
    """Filter data packets that were not sent. Unit: 1."""
    comm_port_bytes_written: int
    """Bytes sent over the port. Unit: byte."""
    comm_port_bytes_read: int
    """Bytes received over the port. Unit: byte."""
    comm_port_write_overruns: int
    """Overruns while writing to the port. Unit: 1."""
    comm_port_read_overruns: int
    """Overruns while reading from the port. Unit: 1."""
    usb_bytes_written: int
    """Bytes sent over USB. Unit: byte."""
    usb_bytes_read: int
    """Bytes received over USB. Unit: byte."""
    usb_write_overruns: int
    """Overruns while writing to USB. Unit: 1."""
    usb_read_overruns: int
    """Overruns while reading from USB. Unit: 1."""
    imu_parser_errors: int
    """IMU messages that could not be parsed. Unit: 1."""
    imu_message_count: int
    """IMU messages that were read. Unit: 1."""
    imu_last_message_time: int
    """System timer at the last IMU message. Unit: ms."""

    def __init__(
        self,
        model_number: int,
        status_flags: int,
        system_timer: int,
        pps_count: int,
        pps_last_time: int,
        imu_stream_enabled: bool,
        filter_stream_enabled: bool,
        imu_dropped_packets: int,
        filter_dropped_packets: int,
        comm_port_bytes_written: int,
        comm_port_bytes_read: int,
        comm_port_write_overruns: int,
        comm_port_read_overruns: int,
        usb_bytes_written: int,
        usb_bytes_read: int,
        usb_write_overruns: int,
        usb_read_overruns: int,
        imu_parser_errors: int,
        imu_message_count: int,
        imu_last_message_time: int,
    ) -> None:
        self.model_number = model_number
        self.status_flags = status_flags
        self.system_timer = system_timer
        self.pps_count = pps_count
        self.pps_last_time = pps_last_time
        self.imu_stream_enabled = imu_stream_enabled
        self.filter_stream_enabled = filter_stream_enabled
        self.imu_dropped_packets = imu_dropped_packets
        self.filter_dropped_packets = filter_dropped_packets
        self.comm_port_bytes_written = comm_port_bytes_written
        self.comm_port_bytes_read = comm_port_bytes_read
        self.comm_port_write_overruns = comm_port_write_overruns
        self.comm_port_read_overruns = comm_port_read_overruns
        self.usb_bytes_written = usb_bytes_written
        self.usb_bytes_read = usb_bytes_read
        self.usb_write_overruns = usb_write_overruns
        self.usb_read_overruns = usb_read_overruns
        self.imu_parser_errors = imu_parser_errors
        self.imu_message_count = imu_message_count
        self.imu_last_message_time = imu_last_message_time

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _HB.read(raw, at)
        self.model_number = v[0]
        codec.constant(v[1], 2)
        at += 3
        v = _4I2B13I.read(raw, at)
        self.status_flags = v[0]
        self.system_timer = v[1]
        self.pps_count = v[2]
        self.pps_last_time = v[3]
        self.imu_stream_enabled = codec.TRUTH[v[4]]
        self.filter_stream_enabled = codec.TRUTH[v[5]]
        self.imu_dropped_packets = v[6]
        self.filter_dropped_packets = v[7]
        self.comm_port_bytes_written = v[8]
        self.comm_port_bytes_read = v[9]
        self.comm_port_write_overruns = v[10]
        self.comm_port_read_overruns = v[11]
        self.usb_bytes_written = v[12]
        self.usb_bytes_read = v[13]
        self.usb_write_overruns = v[14]
        self.usb_read_overruns = v[15]
        self.imu_parser_errors = v[16]
        self.imu_message_count = v[17]
        self.imu_last_message_time = v[18]
        at += 70
        return at

    def _write(self) -> bytes:
        out = _HB.write("model_number status_selector", self.model_number, 2)
        out += _4I2B13I.write(
            "status_flags system_timer pps_count pps_last_time imu_stream_enabled filter_stream_enabled imu_dropped_packets filter_dropped_packets comm_port_bytes_written comm_port_bytes_read comm_port_write_overruns comm_port_read_overruns usb_bytes_written usb_bytes_read usb_write_overruns usb_read_overruns imu_parser_errors imu_message_count imu_last_message_time",
            self.status_flags,
            self.system_timer,
            self.pps_count,
            self.pps_last_time,
            self.imu_stream_enabled,
            self.filter_stream_enabled,
            self.imu_dropped_packets,
            self.filter_dropped_packets,
            self.comm_port_bytes_written,
            self.comm_port_bytes_read,
            self.comm_port_write_overruns,
            self.comm_port_read_overruns,
            self.usb_bytes_written,
            self.usb_bytes_read,
            self.usb_write_overruns,
            self.usb_read_overruns,
            self.imu_parser_errors,
            self.imu_message_count,
            self.imu_last_message_time,
        )
        return codec.finished(out)

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return 73 <= len(data) < 77 and b"\x02".startswith(data[2:3])


class DeviceStatusDiagnosticImuResponse(Response):
    """Diagnostic device status (IMU) (0x0C,0x90).

    Timer, available sensors, temperature, and the counters of pulses, stream and port.

    No device is known for certain to support it. Response to `DeviceStatus`. The size of its data
    distinguishes it from `DeviceStatusDiagnosticResponse`, `DeviceStatusDiagnosticGnssResponse`,
    `DeviceStatusDiagnosticGq4_45Response`, `DeviceStatusDiagnosticRq1_45Response`,
    `DeviceStatusDiagnosticGx4Response`, `DeviceStatusDiagnosticGx4ImuResponse`,
    `DeviceStatusDiagnosticRq1ImuResponse` and `DeviceStatusDiagnosticGx3Response`. Sent if
    `status_selector` is `DeviceStatusSelector.DIAGNOSTIC`. Uncertain: MSCL uses it for the
    3DM-GX5-10, 3DM-CX5-10 and 3DM-CV5-10; no known manual documents it. Uncertain: MSCL lists only
    the names of the values, from which the descriptions are inferred; the times are assumed to be
    in ms like the system timer. Uncertain: The units of the ranges are not known.

    - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
    - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
    - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
    - mscl: Device status (0x0C,0x64)
    """

    __slots__ = (
        "model_number",
        "status_flags",
        "system_timer",
        "has_mag",
        "has_pressure",
        "power_state",
        "gyro_range",
        "accel_range",
        "reserved",
        "temperature",
        "temperature_last_time",
        "temperature_error",
        "pps_count",
        "pps_last_time",
        "imu_stream_enabled",
        "imu_dropped_packets",
        "comm_port_bytes_written",
        "comm_port_bytes_read",
        "comm_port_write_overruns",
        "comm_port_read_overruns",
    )
    __match_args__ = (
        "model_number",
        "status_flags",
        "system_timer",
        "has_mag",
        "has_pressure",
        "power_state",
        "gyro_range",
        "accel_range",
        "temperature",
        "temperature_last_time",
        "temperature_error",
        "pps_count",
        "pps_last_time",
        "imu_stream_enabled",
        "imu_dropped_packets",
        "comm_port_bytes_written",
        "comm_port_bytes_read",
        "comm_port_write_overruns",
        "comm_port_read_overruns",
    )

    SET = 0x0C
    DESCRIPTOR = 0x90
    NAME = "3dm.device_status_diagnostic_imu_response"

    model_number: int
    """Model number of the device."""
    # On the wire only: status_selector. Diagnostic status. Always 2.
    status_flags: int
    """Reserved."""
    system_timer: int
    """Time since start-up. Unit: ms."""
    has_mag: bool
    """True if the device has a magnetometer."""
    has_pressure: bool
    """True if the device has a pressure sensor."""
    power_state: int
    """Power state of the sensors."""
    gyro_range: int
    """Largest measurable angular rate."""
    accel_range: int
    """Largest measurable acceleration."""
    reserved: int
    """Reserved."""
    temperature: float
    """Temperature of the board. Unit: degC. Uncertain: The unit is inferred."""
    temperature_last_time: int
    """System timer at the last temperature measurement. Unit: ms."""
    temperature_error: int
    """State of the temperature measurement."""
    pps_count: int
    """Number of PPS pulses counted. Unit: 1."""
    pps_last_time: int
    """System timer at the last pulse. Unit: ms."""
    imu_stream_enabled: bool
    """True if sensor data is streamed."""
    imu_dropped_packets: int
    """Sensor data packets that were not sent. Unit: 1."""
    comm_port_bytes_written: int
    """Bytes sent over the port. Unit: byte."""
    comm_port_bytes_read: int
    """Bytes received over the port. Unit: byte."""
    comm_port_write_overruns: int
    """Overruns while writing to the port. Unit: 1."""
    comm_port_read_overruns: int
    """Overruns while reading from the port. Unit: 1."""

    def __init__(
        self,
        model_number: int,
        status_flags: int,
        system_timer: int,
        has_mag: bool,
        has_pressure: bool,
        power_state: int,
        gyro_range: int,
        accel_range: int,
        temperature: float,
        temperature_last_time: int,
        temperature_error: int,
        pps_count: int,
        pps_last_time: int,
        imu_stream_enabled: bool,
        imu_dropped_packets: int,
        comm_port_bytes_written: int,
        comm_port_bytes_read: int,
        comm_port_write_overruns: int,
        comm_port_read_overruns: int,
        *,
        reserved: int = 0,
    ) -> None:
        self.model_number = model_number
        self.status_flags = status_flags
        self.system_timer = system_timer
        self.has_mag = has_mag
        self.has_pressure = has_pressure
        self.power_state = power_state
        self.gyro_range = gyro_range
        self.accel_range = accel_range
        self.reserved = reserved
        self.temperature = temperature
        self.temperature_last_time = temperature_last_time
        self.temperature_error = temperature_error
        self.pps_count = pps_count
        self.pps_last_time = pps_last_time
        self.imu_stream_enabled = imu_stream_enabled
        self.imu_dropped_packets = imu_dropped_packets
        self.comm_port_bytes_written = comm_port_bytes_written
        self.comm_port_bytes_read = comm_port_bytes_read
        self.comm_port_write_overruns = comm_port_write_overruns
        self.comm_port_read_overruns = comm_port_read_overruns

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _HB.read(raw, at)
        self.model_number = v[0]
        codec.constant(v[1], 2)
        at += 3
        v = _2I3B2HIfIB2IB5I.read(raw, at)
        self.status_flags = v[0]
        self.system_timer = v[1]
        self.has_mag = codec.TRUTH[v[2]]
        self.has_pressure = codec.TRUTH[v[3]]
        self.power_state = v[4]
        self.gyro_range = v[5]
        self.accel_range = v[6]
        self.reserved = v[7]
        self.temperature = v[8]
        self.temperature_last_time = v[9]
        self.temperature_error = v[10]
        self.pps_count = v[11]
        self.pps_last_time = v[12]
        self.imu_stream_enabled = codec.TRUTH[v[13]]
        self.imu_dropped_packets = v[14]
        self.comm_port_bytes_written = v[15]
        self.comm_port_bytes_read = v[16]
        self.comm_port_write_overruns = v[17]
        self.comm_port_read_overruns = v[18]
        at += 57
        return at

    def _write(self) -> bytes:
        out = _HB.write("model_number status_selector", self.model_number, 2)
        out += _2I3B2HIfIB2IB5I.write(
            "status_flags system_timer has_mag has_pressure power_state gyro_range accel_range reserved temperature temperature_last_time temperature_error pps_count pps_last_time imu_stream_enabled imu_dropped_packets comm_port_bytes_written comm_port_bytes_read comm_port_write_overruns comm_port_read_overruns",
            self.status_flags,
            self.system_timer,
            self.has_mag,
            self.has_pressure,
            self.power_state,
            self.gyro_range,
            self.accel_range,
            self.reserved,
            self.temperature,
            self.temperature_last_time,
            self.temperature_error,
            self.pps_count,
            self.pps_last_time,
            self.imu_stream_enabled,
            self.imu_dropped_packets,
            self.comm_port_bytes_written,
            self.comm_port_bytes_read,
            self.comm_port_write_overruns,
            self.comm_port_read_overruns,
        )
        return codec.finished(out)

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return 60 <= len(data) < 61 and b"\x02".startswith(data[2:3])


class DeviceStatusDiagnosticGx4ImuResponse(Response):
    """Diagnostic device status (inertial sensor of the 3DM-GX4-45) (0x0C,0x90).

    Timer, available sensors and their ranges, temperature, and the counters of pulses, stream and
    port.

    No device is known for certain to support it. Response to `DeviceStatus`. The size of its data
    distinguishes it from `DeviceStatusDiagnosticResponse`, `DeviceStatusDiagnosticGnssResponse`,
    `DeviceStatusDiagnosticGq4_45Response`, `DeviceStatusDiagnosticRq1_45Response`,
    `DeviceStatusDiagnosticGx4Response`, `DeviceStatusDiagnosticImuResponse`,
    `DeviceStatusDiagnosticRq1ImuResponse` and `DeviceStatusDiagnosticGx3Response`. Sent if
    `status_selector` is `DeviceStatusSelector.DIAGNOSTIC`. Uncertain: The SDK of 2014 lists the
    names of the values and the units of temperature and times; the descriptions are inferred from
    the names. Uncertain: The units of the ranges are not known.

    - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
    - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
    - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
    - mscl: Device status (0x0C,0x64)
    """

    __slots__ = (
        "model_number",
        "status_flags",
        "system_timer",
        "has_mag",
        "has_pressure",
        "gyro_range",
        "accel_range",
        "mag_range",
        "pressure_range",
        "temperature",
        "temperature_last_time",
        "temperature_error",
        "pps_count",
        "pps_last_time",
        "imu_stream_enabled",
        "imu_dropped_packets",
        "comm_port_bytes_written",
        "comm_port_bytes_read",
        "comm_port_write_overruns",
        "comm_port_read_overruns",
    )
    __match_args__ = (
        "model_number",
        "status_flags",
        "system_timer",
        "has_mag",
        "has_pressure",
        "gyro_range",
        "accel_range",
        "mag_range",
        "pressure_range",
        "temperature",
        "temperature_last_time",
        "temperature_error",
        "pps_count",
        "pps_last_time",
        "imu_stream_enabled",
        "imu_dropped_packets",
        "comm_port_bytes_written",
        "comm_port_bytes_read",
        "comm_port_write_overruns",
        "comm_port_read_overruns",
    )

    SET = 0x0C
    DESCRIPTOR = 0x90
    NAME = "3dm.device_status_diagnostic_gx4_imu_response"

    model_number: int
    """Model number of the inertial sensor."""
    # On the wire only: status_selector. Diagnostic status. Always 2.
    status_flags: int
    """Reserved."""
    system_timer: int
    """Time since start-up. Unit: ms."""
    has_mag: bool
    """True if the device has a magnetometer."""
    has_pressure: bool
    """True if the device has a pressure sensor."""
    gyro_range: int
    """Largest measurable angular rate."""
    accel_range: int
    """Largest measurable acceleration."""
    mag_range: float
    """Largest measurable magnetic field."""
    pressure_range: float
    """Largest measurable pressure."""
    temperature: float
    """Temperature of the board. Unit: degC. Uncertain: The unit is inferred."""
    temperature_last_time: int
    """System timer at the last temperature measurement. Unit: ms."""
    temperature_error: int
    """State of the temperature measurement; 0 is normal."""
    pps_count: int
    """Number of PPS pulses counted. Unit: 1."""
    pps_last_time: int
    """System timer at the last pulse. Unit: ms."""
    imu_stream_enabled: bool
    """True if sensor data is streamed."""
    imu_dropped_packets: int
    """Sensor data packets that were not sent. Unit: 1."""
    comm_port_bytes_written: int
    """Bytes sent over the port. Unit: byte."""
    comm_port_bytes_read: int
    """Bytes received over the port. Unit: byte."""
    comm_port_write_overruns: int
    """Overruns while writing to the port. Unit: 1."""
    comm_port_read_overruns: int
    """Overruns while reading from the port. Unit: 1."""

    def __init__(
        self,
        model_number: int,
        status_flags: int,
        system_timer: int,
        has_mag: bool,
        has_pressure: bool,
        gyro_range: int,
        accel_range: int,
        mag_range: float,
        pressure_range: float,
        temperature: float,
        temperature_last_time: int,
        temperature_error: int,
        pps_count: int,
        pps_last_time: int,
        imu_stream_enabled: bool,
        imu_dropped_packets: int,
        comm_port_bytes_written: int,
        comm_port_bytes_read: int,
        comm_port_write_overruns: int,
        comm_port_read_overruns: int,
    ) -> None:
        self.model_number = model_number
        self.status_flags = status_flags
        self.system_timer = system_timer
        self.has_mag = has_mag
        self.has_pressure = has_pressure
        self.gyro_range = gyro_range
        self.accel_range = accel_range
        self.mag_range = mag_range
        self.pressure_range = pressure_range
        self.temperature = temperature
        self.temperature_last_time = temperature_last_time
        self.temperature_error = temperature_error
        self.pps_count = pps_count
        self.pps_last_time = pps_last_time
        self.imu_stream_enabled = imu_stream_enabled
        self.imu_dropped_packets = imu_dropped_packets
        self.comm_port_bytes_written = comm_port_bytes_written
        self.comm_port_bytes_read = comm_port_bytes_read
        self.comm_port_write_overruns = comm_port_write_overruns
        self.comm_port_read_overruns = comm_port_read_overruns

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _HB.read(raw, at)
        self.model_number = v[0]
        codec.constant(v[1], 2)
        at += 3
        v = _2I2BHB3fIB2IB5I.read(raw, at)
        self.status_flags = v[0]
        self.system_timer = v[1]
        self.has_mag = codec.TRUTH[v[2]]
        self.has_pressure = codec.TRUTH[v[3]]
        self.gyro_range = v[4]
        self.accel_range = v[5]
        self.mag_range = v[6]
        self.pressure_range = v[7]
        self.temperature = v[8]
        self.temperature_last_time = v[9]
        self.temperature_error = v[10]
        self.pps_count = v[11]
        self.pps_last_time = v[12]
        self.imu_stream_enabled = codec.TRUTH[v[13]]
        self.imu_dropped_packets = v[14]
        self.comm_port_bytes_written = v[15]
        self.comm_port_bytes_read = v[16]
        self.comm_port_write_overruns = v[17]
        self.comm_port_read_overruns = v[18]
        at += 59
        return at

    def _write(self) -> bytes:
        out = _HB.write("model_number status_selector", self.model_number, 2)
        out += _2I2BHB3fIB2IB5I.write(
            "status_flags system_timer has_mag has_pressure gyro_range accel_range mag_range pressure_range temperature temperature_last_time temperature_error pps_count pps_last_time imu_stream_enabled imu_dropped_packets comm_port_bytes_written comm_port_bytes_read comm_port_write_overruns comm_port_read_overruns",
            self.status_flags,
            self.system_timer,
            self.has_mag,
            self.has_pressure,
            self.gyro_range,
            self.accel_range,
            self.mag_range,
            self.pressure_range,
            self.temperature,
            self.temperature_last_time,
            self.temperature_error,
            self.pps_count,
            self.pps_last_time,
            self.imu_stream_enabled,
            self.imu_dropped_packets,
            self.comm_port_bytes_written,
            self.comm_port_bytes_read,
            self.comm_port_write_overruns,
            self.comm_port_read_overruns,
        )
        return codec.finished(out)

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return 62 <= len(data) < 73 and b"\x02".startswith(data[2:3])


class DeviceStatusDiagnosticRq1ImuResponse(Response):
    """Diagnostic device status (inertial sensor of the 3DM-RQ1-45) (0x0C,0x90).

    Timer, temperature and supply, and the counters of pulses, stream and port.

    No device is known for certain to support it. Response to `DeviceStatus`. The size of its data
    distinguishes it from `DeviceStatusDiagnosticResponse`, `DeviceStatusDiagnosticGnssResponse`,
    `DeviceStatusDiagnosticGq4_45Response`, `DeviceStatusDiagnosticRq1_45Response`,
    `DeviceStatusDiagnosticGx4Response`, `DeviceStatusDiagnosticImuResponse`,
    `DeviceStatusDiagnosticGx4ImuResponse` and `DeviceStatusDiagnosticGx3Response`. Sent if
    `status_selector` is `DeviceStatusSelector.DIAGNOSTIC`. Uncertain: The SDK of 2014 lists the
    names of the values and the units of temperature and times; the descriptions are inferred from
    the names.

    - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
    - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
    - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
    - mscl: Device status (0x0C,0x64)
    """

    __slots__ = (
        "model_number",
        "status_flags",
        "system_timer",
        "temperature",
        "temperature_last_time",
        "bad_temperature_sensor_detected",
        "cold_temperature_detected",
        "bad_voltage_detected",
        "pps_count",
        "pps_last_time",
        "imu_stream_enabled",
        "imu_dropped_packets",
        "comm_port_state",
        "comm_port_baud_rate",
        "comm_port_bytes_written",
        "comm_port_bytes_read",
        "comm_port_write_overruns",
        "comm_port_read_overruns",
    )
    __match_args__ = (
        "model_number",
        "status_flags",
        "system_timer",
        "temperature",
        "temperature_last_time",
        "bad_temperature_sensor_detected",
        "cold_temperature_detected",
        "bad_voltage_detected",
        "pps_count",
        "pps_last_time",
        "imu_stream_enabled",
        "imu_dropped_packets",
        "comm_port_state",
        "comm_port_baud_rate",
        "comm_port_bytes_written",
        "comm_port_bytes_read",
        "comm_port_write_overruns",
        "comm_port_read_overruns",
    )

    SET = 0x0C
    DESCRIPTOR = 0x90
    NAME = "3dm.device_status_diagnostic_rq1_imu_response"

    model_number: int
    """Model number of the inertial sensor."""
    # On the wire only: status_selector. Diagnostic status. Always 2.
    status_flags: int
    """Reserved."""
    system_timer: int
    """Time since start-up. Unit: us."""
    temperature: float
    """Temperature of the board. Unit: degC. Uncertain: The unit is inferred."""
    temperature_last_time: int
    """System timer at the last temperature measurement. Unit: ms."""
    bad_temperature_sensor_detected: bool
    """True if a temperature sensor is faulty."""
    cold_temperature_detected: bool
    """True if the temperature is too low."""
    bad_voltage_detected: bool
    """True if a supply voltage is out of range."""
    pps_count: int
    """Number of PPS pulses counted. Unit: 1."""
    pps_last_time: int
    """System timer at the last pulse. Unit: ms."""
    imu_stream_enabled: bool
    """True if sensor data is streamed."""
    imu_dropped_packets: int
    """Sensor data packets that were not sent. Unit: 1."""
    comm_port_state: int
    """State of the port; the meaning of its values is not known."""
    comm_port_baud_rate: int
    """Present baud rate of the port. Unit: Bd."""
    comm_port_bytes_written: int
    """Bytes sent over the port. Unit: byte."""
    comm_port_bytes_read: int
    """Bytes received over the port. Unit: byte."""
    comm_port_write_overruns: int
    """Overruns while writing to the port. Unit: 1."""
    comm_port_read_overruns: int
    """Overruns while reading from the port. Unit: 1."""

    def __init__(
        self,
        model_number: int,
        status_flags: int,
        system_timer: int,
        temperature: float,
        temperature_last_time: int,
        bad_temperature_sensor_detected: bool,
        cold_temperature_detected: bool,
        bad_voltage_detected: bool,
        pps_count: int,
        pps_last_time: int,
        imu_stream_enabled: bool,
        imu_dropped_packets: int,
        comm_port_state: int,
        comm_port_baud_rate: int,
        comm_port_bytes_written: int,
        comm_port_bytes_read: int,
        comm_port_write_overruns: int,
        comm_port_read_overruns: int,
    ) -> None:
        self.model_number = model_number
        self.status_flags = status_flags
        self.system_timer = system_timer
        self.temperature = temperature
        self.temperature_last_time = temperature_last_time
        self.bad_temperature_sensor_detected = bad_temperature_sensor_detected
        self.cold_temperature_detected = cold_temperature_detected
        self.bad_voltage_detected = bad_voltage_detected
        self.pps_count = pps_count
        self.pps_last_time = pps_last_time
        self.imu_stream_enabled = imu_stream_enabled
        self.imu_dropped_packets = imu_dropped_packets
        self.comm_port_state = comm_port_state
        self.comm_port_baud_rate = comm_port_baud_rate
        self.comm_port_bytes_written = comm_port_bytes_written
        self.comm_port_bytes_read = comm_port_bytes_read
        self.comm_port_write_overruns = comm_port_write_overruns
        self.comm_port_read_overruns = comm_port_read_overruns

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _HB.read(raw, at)
        self.model_number = v[0]
        codec.constant(v[1], 2)
        at += 3
        v = _IQfI3B2IBIH5I.read(raw, at)
        self.status_flags = v[0]
        self.system_timer = v[1]
        self.temperature = v[2]
        self.temperature_last_time = v[3]
        self.bad_temperature_sensor_detected = codec.TRUTH[v[4]]
        self.cold_temperature_detected = codec.TRUTH[v[5]]
        self.bad_voltage_detected = codec.TRUTH[v[6]]
        self.pps_count = v[7]
        self.pps_last_time = v[8]
        self.imu_stream_enabled = codec.TRUTH[v[9]]
        self.imu_dropped_packets = v[10]
        self.comm_port_state = v[11]
        self.comm_port_baud_rate = v[12]
        self.comm_port_bytes_written = v[13]
        self.comm_port_bytes_read = v[14]
        self.comm_port_write_overruns = v[15]
        self.comm_port_read_overruns = v[16]
        at += 58
        return at

    def _write(self) -> bytes:
        out = _HB.write("model_number status_selector", self.model_number, 2)
        out += _IQfI3B2IBIH5I.write(
            "status_flags system_timer temperature temperature_last_time bad_temperature_sensor_detected cold_temperature_detected bad_voltage_detected pps_count pps_last_time imu_stream_enabled imu_dropped_packets comm_port_state comm_port_baud_rate comm_port_bytes_written comm_port_bytes_read comm_port_write_overruns comm_port_read_overruns",
            self.status_flags,
            self.system_timer,
            self.temperature,
            self.temperature_last_time,
            self.bad_temperature_sensor_detected,
            self.cold_temperature_detected,
            self.bad_voltage_detected,
            self.pps_count,
            self.pps_last_time,
            self.imu_stream_enabled,
            self.imu_dropped_packets,
            self.comm_port_state,
            self.comm_port_baud_rate,
            self.comm_port_bytes_written,
            self.comm_port_bytes_read,
            self.comm_port_write_overruns,
            self.comm_port_read_overruns,
        )
        return codec.finished(out)

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return 61 <= len(data) < 62 and b"\x02".startswith(data[2:3])


class DeviceStatusBasicGx3Response(Response):
    """Basic device status (3DM-GX3-35, 3DM-GX3-45) (0x0C,0x90).

    State of the port.

    No device is known for certain to support it. Response to `DeviceStatus`. The size of its data
    distinguishes it from `DeviceStatusBasicResponse` and `DeviceStatusBasicWithoutStateResponse`.
    Sent if `status_selector` is `DeviceStatusSelector.BASIC`. Uncertain: Only the SDK of 2014
    contains it, with the names of the values; the descriptions are inferred from the names.

    - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
    - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
    - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
    - mscl: Device status (0x0C,0x64)
    """

    __slots__ = (
        "model_number",
        "comm_mode",
        "comm_device",
        "settings_flags",
        "comm_state",
        "comm_baud_rate",
    )
    __match_args__ = (
        "model_number",
        "comm_mode",
        "comm_device",
        "settings_flags",
        "comm_state",
        "comm_baud_rate",
    )

    SET = 0x0C
    DESCRIPTOR = 0x90
    NAME = "3dm.device_status_basic_gx3_response"

    model_number: int
    """Model number of the device."""
    # On the wire only: status_selector. Basic status. Always 1.
    comm_mode: int
    """Part of the device that the port is connected to."""
    comm_device: int
    """Port in use."""
    settings_flags: int
    """Settings of the data streams; the meaning of the bits is not known."""
    comm_state: int
    """State of the port; the meaning of its values is not known."""
    comm_baud_rate: int
    """Baud rate of the port. Unit: Bd."""

    def __init__(
        self,
        model_number: int,
        comm_mode: int,
        comm_device: int,
        settings_flags: int,
        comm_state: int,
        comm_baud_rate: int,
    ) -> None:
        self.model_number = model_number
        self.comm_mode = comm_mode
        self.comm_device = comm_device
        self.settings_flags = settings_flags
        self.comm_state = comm_state
        self.comm_baud_rate = comm_baud_rate

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _HB.read(raw, at)
        self.model_number = v[0]
        codec.constant(v[1], 1)
        at += 3
        (
            self.comm_mode,
            self.comm_device,
            self.settings_flags,
            self.comm_state,
            self.comm_baud_rate,
        ) = _2BIHI.read(raw, at)
        at += 12
        return at

    def _write(self) -> bytes:
        out = _HB.write("model_number status_selector", self.model_number, 1)
        out += _2BIHI.write(
            "comm_mode comm_device settings_flags comm_state comm_baud_rate",
            self.comm_mode,
            self.comm_device,
            self.settings_flags,
            self.comm_state,
            self.comm_baud_rate,
        )
        return codec.finished(out)

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return 15 <= len(data) and b"\x01".startswith(data[2:3])


class DeviceStatusDiagnosticGx3Response(Response):
    """Diagnostic device status (3DM-GX3-35, 3DM-GX3-45) (0x0C,0x90).

    State of the port, and the counters of the port, USB, receiver and IMU.

    No device is known for certain to support it. Response to `DeviceStatus`. The size of its data
    distinguishes it from `DeviceStatusDiagnosticResponse`, `DeviceStatusDiagnosticGnssResponse`,
    `DeviceStatusDiagnosticGq4_45Response`, `DeviceStatusDiagnosticRq1_45Response`,
    `DeviceStatusDiagnosticGx4Response`, `DeviceStatusDiagnosticImuResponse`,
    `DeviceStatusDiagnosticGx4ImuResponse` and `DeviceStatusDiagnosticRq1ImuResponse`. Sent if
    `status_selector` is `DeviceStatusSelector.DIAGNOSTIC`. Uncertain: Only the SDK of 2014 contains
    it, with the names of the values; the descriptions are inferred from the names.

    - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
    - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
    - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
    - mscl: Device status (0x0C,0x64)
    """

    __slots__ = (
        "model_number",
        "comm_mode",
        "comm_device",
        "settings_flags",
        "comm_state",
        "comm_baud_rate",
        "comm_port_bytes_written",
        "comm_port_bytes_read",
        "comm_port_write_overruns",
        "comm_port_read_overruns",
        "usb_state",
        "usb_bytes_written",
        "usb_bytes_read",
        "usb_write_overruns",
        "usb_read_overruns",
        "gnss_driver_state",
        "gnss_port_state",
        "gnss_bytes_written",
        "gnss_bytes_read",
        "gnss_write_overruns",
        "gnss_read_overruns",
        "gnss_message_count",
        "gnss_delayed_message_count",
        "imu_driver_state",
        "imu_port_state",
        "imu_bytes_written",
        "imu_bytes_read",
        "imu_write_overruns",
        "imu_read_overruns",
        "imu_message_count",
        "imu_delayed_message_count",
    )
    __match_args__ = (
        "model_number",
        "comm_mode",
        "comm_device",
        "settings_flags",
        "comm_state",
        "comm_baud_rate",
        "comm_port_bytes_written",
        "comm_port_bytes_read",
        "comm_port_write_overruns",
        "comm_port_read_overruns",
        "usb_state",
        "usb_bytes_written",
        "usb_bytes_read",
        "usb_write_overruns",
        "usb_read_overruns",
        "gnss_driver_state",
        "gnss_port_state",
        "gnss_bytes_written",
        "gnss_bytes_read",
        "gnss_write_overruns",
        "gnss_read_overruns",
        "gnss_message_count",
        "gnss_delayed_message_count",
        "imu_driver_state",
        "imu_port_state",
        "imu_bytes_written",
        "imu_bytes_read",
        "imu_write_overruns",
        "imu_read_overruns",
        "imu_message_count",
        "imu_delayed_message_count",
    )

    SET = 0x0C
    DESCRIPTOR = 0x90
    NAME = "3dm.device_status_diagnostic_gx3_response"

    model_number: int
    """Model number of the device."""
    # On the wire only: status_selector. Diagnostic status. Always 2.
    comm_mode: int
    """Part of the device that the port is connected to."""
    comm_device: int
    """Port in use."""
    settings_flags: int
    """Settings of the data streams; the meaning of the bits is not known."""
    comm_state: int
    """State of the port; the meaning of its values is not known."""
    comm_baud_rate: int
    """Baud rate of the port. Unit: Bd."""
    comm_port_bytes_written: int
    """Bytes sent over the port. Unit: byte."""
    comm_port_bytes_read: int
    """Bytes received over the port. Unit: byte."""
    comm_port_write_overruns: int
    """Overruns while writing to the port. Unit: 1."""
    comm_port_read_overruns: int
    """Overruns while reading from the port. Unit: 1."""
    usb_state: int
    """State of the USB port; the meaning of its values is not known."""
    usb_bytes_written: int
    """Bytes sent over USB. Unit: byte."""
    usb_bytes_read: int
    """Bytes received over USB. Unit: byte."""
    usb_write_overruns: int
    """Overruns while writing to USB. Unit: 1."""
    usb_read_overruns: int
    """Overruns while reading from USB. Unit: 1."""
    gnss_driver_state: int
    """State of the receiver's driver; the meaning of its values is not known."""
    gnss_port_state: int
    """State of the port to the receiver; the meaning of its values is not known."""
    gnss_bytes_written: int
    """Bytes sent to the receiver. Unit: byte."""
    gnss_bytes_read: int
    """Bytes received from the receiver. Unit: byte."""
    gnss_write_overruns: int
    """Overruns while writing to the receiver. Unit: 1."""
    gnss_read_overruns: int
    """Overruns while reading from the receiver. Unit: 1."""
    gnss_message_count: int
    """Receiver messages that were read. Unit: 1."""
    gnss_delayed_message_count: int
    """Receiver messages that arrived late. Unit: 1."""
    imu_driver_state: int
    """State of the IMU's driver; the meaning of its values is not known."""
    imu_port_state: int
    """State of the port to the IMU; the meaning of its values is not known."""
    imu_bytes_written: int
    """Bytes sent to the IMU. Unit: byte."""
    imu_bytes_read: int
    """Bytes received from the IMU. Unit: byte."""
    imu_write_overruns: int
    """Overruns while writing to the IMU. Unit: 1."""
    imu_read_overruns: int
    """Overruns while reading from the IMU. Unit: 1."""
    imu_message_count: int
    """IMU messages that were read. Unit: 1."""
    imu_delayed_message_count: int
    """IMU messages that arrived late. Unit: 1."""

    def __init__(
        self,
        model_number: int,
        comm_mode: int,
        comm_device: int,
        settings_flags: int,
        comm_state: int,
        comm_baud_rate: int,
        comm_port_bytes_written: int,
        comm_port_bytes_read: int,
        comm_port_write_overruns: int,
        comm_port_read_overruns: int,
        usb_state: int,
        usb_bytes_written: int,
        usb_bytes_read: int,
        usb_write_overruns: int,
        usb_read_overruns: int,
        gnss_driver_state: int,
        gnss_port_state: int,
        gnss_bytes_written: int,
        gnss_bytes_read: int,
        gnss_write_overruns: int,
        gnss_read_overruns: int,
        gnss_message_count: int,
        gnss_delayed_message_count: int,
        imu_driver_state: int,
        imu_port_state: int,
        imu_bytes_written: int,
        imu_bytes_read: int,
        imu_write_overruns: int,
        imu_read_overruns: int,
        imu_message_count: int,
        imu_delayed_message_count: int,
    ) -> None:
        self.model_number = model_number
        self.comm_mode = comm_mode
        self.comm_device = comm_device
        self.settings_flags = settings_flags
        self.comm_state = comm_state
        self.comm_baud_rate = comm_baud_rate
        self.comm_port_bytes_written = comm_port_bytes_written
        self.comm_port_bytes_read = comm_port_bytes_read
        self.comm_port_write_overruns = comm_port_write_overruns
        self.comm_port_read_overruns = comm_port_read_overruns
        self.usb_state = usb_state
        self.usb_bytes_written = usb_bytes_written
        self.usb_bytes_read = usb_bytes_read
        self.usb_write_overruns = usb_write_overruns
        self.usb_read_overruns = usb_read_overruns
        self.gnss_driver_state = gnss_driver_state
        self.gnss_port_state = gnss_port_state
        self.gnss_bytes_written = gnss_bytes_written
        self.gnss_bytes_read = gnss_bytes_read
        self.gnss_write_overruns = gnss_write_overruns
        self.gnss_read_overruns = gnss_read_overruns
        self.gnss_message_count = gnss_message_count
        self.gnss_delayed_message_count = gnss_delayed_message_count
        self.imu_driver_state = imu_driver_state
        self.imu_port_state = imu_port_state
        self.imu_bytes_written = imu_bytes_written
        self.imu_bytes_read = imu_bytes_read
        self.imu_write_overruns = imu_write_overruns
        self.imu_read_overruns = imu_read_overruns
        self.imu_message_count = imu_message_count
        self.imu_delayed_message_count = imu_delayed_message_count

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _HB.read(raw, at)
        self.model_number = v[0]
        codec.constant(v[1], 2)
        at += 3
        (
            self.comm_mode,
            self.comm_device,
            self.settings_flags,
            self.comm_state,
            self.comm_baud_rate,
            self.comm_port_bytes_written,
            self.comm_port_bytes_read,
            self.comm_port_write_overruns,
            self.comm_port_read_overruns,
            self.usb_state,
            self.usb_bytes_written,
            self.usb_bytes_read,
            self.usb_write_overruns,
            self.usb_read_overruns,
            self.gnss_driver_state,
            self.gnss_port_state,
            self.gnss_bytes_written,
            self.gnss_bytes_read,
            self.gnss_write_overruns,
            self.gnss_read_overruns,
            self.gnss_message_count,
            self.gnss_delayed_message_count,
            self.imu_driver_state,
            self.imu_port_state,
            self.imu_bytes_written,
            self.imu_bytes_read,
            self.imu_write_overruns,
            self.imu_read_overruns,
            self.imu_message_count,
            self.imu_delayed_message_count,
        ) = _2BIH5IH4I2H6I2H6I.read(raw, at)
        at += 102
        return at

    def _write(self) -> bytes:
        out = _HB.write("model_number status_selector", self.model_number, 2)
        out += _2BIH5IH4I2H6I2H6I.write(
            "comm_mode comm_device settings_flags comm_state comm_baud_rate comm_port_bytes_written comm_port_bytes_read comm_port_write_overruns comm_port_read_overruns usb_state usb_bytes_written usb_bytes_read usb_write_overruns usb_read_overruns gnss_driver_state gnss_port_state gnss_bytes_written gnss_bytes_read gnss_write_overruns gnss_read_overruns gnss_message_count gnss_delayed_message_count imu_driver_state imu_port_state imu_bytes_written imu_bytes_read imu_write_overruns imu_read_overruns imu_message_count imu_delayed_message_count",
            self.comm_mode,
            self.comm_device,
            self.settings_flags,
            self.comm_state,
            self.comm_baud_rate,
            self.comm_port_bytes_written,
            self.comm_port_bytes_read,
            self.comm_port_write_overruns,
            self.comm_port_read_overruns,
            self.usb_state,
            self.usb_bytes_written,
            self.usb_bytes_read,
            self.usb_write_overruns,
            self.usb_read_overruns,
            self.gnss_driver_state,
            self.gnss_port_state,
            self.gnss_bytes_written,
            self.gnss_bytes_read,
            self.gnss_write_overruns,
            self.gnss_read_overruns,
            self.gnss_message_count,
            self.gnss_delayed_message_count,
            self.imu_driver_state,
            self.imu_port_state,
            self.imu_bytes_written,
            self.imu_bytes_read,
            self.imu_write_overruns,
            self.imu_read_overruns,
            self.imu_message_count,
            self.imu_delayed_message_count,
        )
        return codec.finished(out)

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return 105 <= len(data) and b"\x02".startswith(data[2:3])


class GpsDynamicsModeResponse(Response):
    """GPS dynamics mode response (0x0C,0x92).

    No device is known for certain to support it. Response to `GpsDynamicsMode`. Known only from the
    MIP SDK of 2014 and MicroStrain Communication Library.

    - mip-sdk-2014: GPS dynamics mode (0x0C,0x34)
    - mscl: GPS dynamics mode (0x0C,0x34)
    """

    __slots__ = ("mode",)
    __match_args__ = ("mode",)

    SET = 0x0C
    DESCRIPTOR = 0x92
    NAME = "3dm.gps_dynamics_mode_response"
    _SIZE = 1

    mode: ReceiverDynamics
    """Assumed dynamics."""

    def __init__(self, mode: ReceiverDynamics) -> None:
        self.mode = mode

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.mode = codec.KNOWN[ReceiverDynamics][_B.unpack(raw, at)[0]]
        return at + 1

    def _write(self) -> bytes:
        return _B.write("mode", self.mode)


class ImuTimestampResponse(Response):
    """IMU timestamp response (0x0C,0x93).

    No device is known for certain to support it. Response to `ImuTimestamp`. Known only from the
    MIP SDK of 2014.

    - mip-sdk-2014: IMU timestamp (0x0C,0x36)
    """

    __slots__ = ("selector", "time")
    __match_args__ = ("selector", "time")

    SET = 0x0C
    DESCRIPTOR = 0x93
    NAME = "3dm.imu_timestamp_response"
    _SIZE = 5

    selector: ImuTimestampSelector
    """Counter to set or read."""
    time: int
    """Value of the counter, in the unit that `selector` selects."""

    def __init__(self, selector: ImuTimestampSelector, time: int) -> None:
        self.selector = selector
        self.time = time

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _BI.unpack(raw, at)
        self.selector = codec.KNOWN[ImuTimestampSelector][v[0]]
        self.time = v[1]
        return at + 5

    def _write(self) -> bytes:
        return _BI.write("selector time", self.selector, self.time)


class ComplementaryFilterResponse(Response):
    """Complementary filter configuration response (0x0C,0x97).

    Response to `ComplementaryFilter`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15 and
    3DM-GX5-35; likely or assumed on 22 more.

    - 3dm-gx5-15: 4.2.15 Complementary Filter Settings (0x0C, 0x51)
    - 3dm-cv7-gnss-ins: Complementary Filter Configuration (0x0C,0x51)
    """

    __slots__ = (
        "pitch_roll_enable",
        "heading_enable",
        "pitch_roll_time_constant",
        "heading_time_constant",
    )
    __match_args__ = (
        "pitch_roll_enable",
        "heading_enable",
        "pitch_roll_time_constant",
        "heading_time_constant",
    )

    SET = 0x0C
    DESCRIPTOR = 0x97
    NAME = "3dm.complementary_filter_response"
    _SIZE = 10

    pitch_roll_enable: bool
    """True enables the pitch and roll correction, which 5-series manuals call up compensation."""
    heading_enable: bool
    """True enables the heading correction, which 5-series manuals call north compensation."""
    pitch_roll_time_constant: float
    """Time constant of the pitch and roll correction. Unit: s. Range: 1 to 1000. Default: 10."""
    heading_time_constant: float
    """Time constant of the heading correction. Unit: s. Range: 1 to 1000. Default: 10."""

    def __init__(
        self,
        pitch_roll_enable: bool,
        heading_enable: bool,
        pitch_roll_time_constant: float,
        heading_time_constant: float,
    ) -> None:
        self.pitch_roll_enable = pitch_roll_enable
        self.heading_enable = heading_enable
        self.pitch_roll_time_constant = pitch_roll_time_constant
        self.heading_time_constant = heading_time_constant

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2B2f.unpack(raw, at)
        if (total := v[2] + v[3]) != total:
            v = _2B2f.keep_nan_bits(v, raw, at)
        self.pitch_roll_enable = codec.TRUTH[v[0]]
        self.heading_enable = codec.TRUTH[v[1]]
        self.pitch_roll_time_constant = v[2]
        self.heading_time_constant = v[3]
        return at + 10

    def _write(self) -> bytes:
        return _2B2f.write(
            "pitch_roll_enable heading_enable pitch_roll_time_constant heading_time_constant",
            self.pitch_roll_enable,
            self.heading_enable,
            self.pitch_roll_time_constant,
            self.heading_time_constant,
        )


class AccelBiasResponse(Response):
    """Accelerometer bias configuration response (0x0C,0x9A).

    Response to `AccelBias`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35,
    3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 24 more.

    - 3dm-gx5-15: 4.2.9 Accel Bias (0x0C, 0x37)
    - 3dm-cv7-gnss-ins: Accelerometer Bias Configuration (0x0C,0x37)
    """

    __slots__ = ("bias",)
    __match_args__ = ("bias",)

    SET = 0x0C
    DESCRIPTOR = 0x9A
    NAME = "3dm.accel_bias_response"
    _SIZE = 12
    _VECTORS = {"bias": (types.Vector3f,)}

    bias: types.Vector3f
    """Bias that the device subtracts from the measured acceleration. Elements: x, y, z. Unit: g.
    Frame: sensor.
    """

    def __init__(self, bias: types.Vector3f | codec.Numbers) -> None:
        self.bias = codec.vector(bias, types.Vector3f)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _3f.unpack(raw, at)
        if (total := v[0] + v[1] + v[2]) != total:
            v = _3f.keep_nan_bits(v, raw, at)
        self._bias = v
        return at + 12

    def _write(self) -> bytes:
        return _3f.write("bias*3", *codec.elements("bias", self.bias, 3))


class GyroBiasResponse(Response):
    """Gyroscope bias configuration response (0x0C,0x9B).

    The bias in use.

    Also called `capture_gyro_bias_response`. Response to `GyroBias` and `CaptureGyroBias`.
    Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GQ7-GNSS/INS,
    3DM-GX5-15, 3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 21 more.

    - 3dm-gx5-15: 4.2.10 Gyro Bias (0x0C, 0x38)
    - 3dm-cv7-gnss-ins: Gyroscope Bias Configuration (0x0C,0x38)
    """

    __slots__ = ("bias",)
    __match_args__ = ("bias",)

    SET = 0x0C
    DESCRIPTOR = 0x9B
    NAME = "3dm.gyro_bias_response"
    _SIZE = 12
    _VECTORS = {"bias": (types.Vector3f,)}

    bias: types.Vector3f
    """Bias that the device subtracts from the measured angular rate. Elements: x, y, z. Unit:
    rad/s. Frame: sensor.
    """

    def __init__(self, bias: types.Vector3f | codec.Numbers) -> None:
        self.bias = codec.vector(bias, types.Vector3f)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _3f.unpack(raw, at)
        if (total := v[0] + v[1] + v[2]) != total:
            v = _3f.keep_nan_bits(v, raw, at)
        self._bias = v
        return at + 12

    def _write(self) -> bytes:
        return _3f.write("bias*3", *codec.elements("bias", self.bias, 3))


class MagHardIronOffsetResponse(Response):
    """Magnetometer hard iron offset response (0x0C,0x9C).

    Response to `MagHardIronOffset`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-GNSS/INS, 3DM-GQ4-45,
    3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 14 more.

    - 3dm-cv7-gnss-ins: Magnetometer Hard Iron Offset (0x0C,0x3A)
    - 3dm-gx5-45: (0x0C, 0x3A)
    """

    __slots__ = ("offset",)
    __match_args__ = ("offset",)

    SET = 0x0C
    DESCRIPTOR = 0x9C
    NAME = "3dm.mag_hard_iron_offset_response"
    _SIZE = 12
    _VECTORS = {"offset": (types.Vector3f,)}

    offset: types.Vector3f
    """Offset that the device subtracts from the measured magnetic field. Elements: x, y, z. Unit:
    gauss. Frame: sensor.
    """

    def __init__(self, offset: types.Vector3f | codec.Numbers) -> None:
        self.offset = codec.vector(offset, types.Vector3f)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _3f.unpack(raw, at)
        if (total := v[0] + v[1] + v[2]) != total:
            v = _3f.keep_nan_bits(v, raw, at)
        self._offset = v
        return at + 12

    def _write(self) -> bytes:
        return _3f.write("offset*3", *codec.elements("offset", self.offset, 3))


class MagSoftIronMatrixResponse(Response):
    """Magnetometer soft iron matrix response (0x0C,0x9D).

    Response to `MagSoftIronMatrix`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-GNSS/INS, 3DM-GQ4-45,
    3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 14 more.

    - 3dm-cv7-gnss-ins: Magnetometer Soft Iron Matrix (0x0C,0x3B)
    - 3dm-gx5-35: (0x0C, 0x3B)
    """

    __slots__ = ("matrix",)
    __match_args__ = ("matrix",)

    SET = 0x0C
    DESCRIPTOR = 0x9D
    NAME = "3dm.mag_soft_iron_matrix_response"
    _SIZE = 36
    _VECTORS = {"matrix": (types.Matrix3f,)}

    matrix: types.Matrix3f
    """Soft iron matrix in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33.
    Unit: 1. Frame: sensor.
    """

    def __init__(self, matrix: types.Matrix3f | codec.Rows) -> None:
        self.matrix = codec.vector(matrix, types.Matrix3f)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _9f.unpack(raw, at)
        if (total := sum(v)) != total:
            v = _9f.keep_nan_bits(v, raw, at)
        self._matrix = v
        return at + 36

    def _write(self) -> bytes:
        return _9f.write("matrix*9", *codec.elements("matrix", self.matrix, 9))


class ConingScullingEnableResponse(Response):
    """Coning and sculling enable response (0x0C,0x9E).

    Response to `ConingScullingEnable`. Confirmed on 3DM-GQ4-45, 3DM-GX5-15, 3DM-RQ1-45-LT and
    3DM-RQ1-45-ST; likely or assumed on 15 more.

    - 3dm-gx5-15: 4.2.12 Coning and Sculling Enable (0x0C, 0x3E)
    """

    __slots__ = ("enable",)
    __match_args__ = ("enable",)

    SET = 0x0C
    DESCRIPTOR = 0x9E
    NAME = "3dm.coning_sculling_enable_response"
    _SIZE = 1

    enable: bool
    """True if the compensation is on. Default: true."""

    def __init__(self, enable: bool) -> None:
        self.enable = enable

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.enable = codec.TRUTH[_B.unpack(raw, at)[0]]
        return at + 1

    def _write(self) -> bytes:
        return _B.write("enable", self.enable)


class ConstellationSettingsResponse(Response):
    """Constellation settings response (0x0C,0xA0).

    Tracking channels of the receiver and the setting of each constellation.

    Response to `ConstellationSettings`. Confirmed on 3DM-GQ4-45 and 3DM-GX5-35; likely or assumed
    on 2 more.

    - mip-sdk-4: Constellation settings (0x0C,0x21)
    - 3dm-gx5-35: 4.2.8 GNSS Constellation Settings (0x0C, 0x21)
    """

    __slots__ = ("max_channels_available", "max_channels_use", "settings")
    __match_args__ = ("max_channels_available", "max_channels_use", "settings")

    SET = 0x0C
    DESCRIPTOR = 0xA0
    NAME = "3dm.constellation_settings_response"

    max_channels_available: int
    """Number of channels of the receiver. Unit: 1."""
    max_channels_use: int
    """Maximum number of channels in use. Unit: 1."""
    # On the wire only: config_count. Number of entries. Counts the elements of `settings`. Range: 0
    # to 41.
    settings: tuple[ConstellationSettingsEntry, ...]
    """One entry for each constellation."""

    def __init__(
        self,
        max_channels_available: int,
        max_channels_use: int,
        settings: Sequence[ConstellationSettingsEntry],
    ) -> None:
        self.max_channels_available = max_channels_available
        self.max_channels_use = max_channels_use
        self.settings = codec.several(settings)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2HB.read(raw, at)
        self.max_channels_available = v[0]
        self.max_channels_use = v[1]
        n_config_count = v[2]
        at += 5
        n = codec.counted(raw, at, n_config_count, 6, 41)
        self.settings, at = codec.read_structures(ConstellationSettingsEntry, raw, at, n)
        return at

    def _write(self) -> bytes:
        out = _2HB.write(
            "max_channels_available max_channels_use config_count",
            self.max_channels_available,
            self.max_channels_use,
            codec.count("settings", self.settings, 41),
        )
        out += codec.write_structures(
            "settings", codec.at_most("settings", self.settings, 41), ConstellationSettingsEntry
        )
        return codec.finished(out)


class GnssSbasSettingsResponse(Response):
    """GNSS SBAS settings response (0x0C,0xA1).

    Response to `GnssSbasSettings`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-GQ4-45 and 3DM-GX5-35; likely
    or assumed on 3 more.

    - 3dm-cv7-gnss-ins: GNSS SBAS Settings (0x0C,0x22)
    """

    __slots__ = ("enable_sbas", "sbas_options", "included_prns")
    __match_args__ = ("enable_sbas", "sbas_options", "included_prns")

    SET = 0x0C
    DESCRIPTOR = 0xA1
    NAME = "3dm.gnss_sbas_settings_response"

    enable_sbas: int
    """1 enables SBAS, 0 disables it. Range: 0 to 1."""
    sbas_options: SbasOptions
    """Purposes of SBAS."""
    # On the wire only: num_included_prns. Number of satellites listed; 0 searches for all. Counts
    # the elements of `included_prns`.
    included_prns: tuple[int, ...]
    """PRN numbers of the SBAS satellites to search for."""

    def __init__(
        self, enable_sbas: int, sbas_options: SbasOptions, included_prns: Sequence[int]
    ) -> None:
        self.enable_sbas = enable_sbas
        self.sbas_options = sbas_options
        self.included_prns = codec.several(included_prns)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _BHB.read(raw, at)
        self.enable_sbas = v[0]
        self.sbas_options = codec.KNOWN[SbasOptions][v[1]]
        n_num_included_prns = v[2]
        at += 4
        n = codec.counted(raw, at, n_num_included_prns, 2, 124)
        self.included_prns = codec.read_numbers("H", raw, at, n)
        at += n * 2
        return at

    def _write(self) -> bytes:
        out = _BHB.write(
            "enable_sbas sbas_options num_included_prns",
            self.enable_sbas,
            self.sbas_options,
            codec.count("included_prns", self.included_prns, 124),
        )
        out += codec.write_numbers(
            "included_prns", "H", codec.at_most("included_prns", self.included_prns, 124)
        )
        return codec.finished(out)


class GnssAssistedFixResponse(Response):
    """GNSS assisted fix response (0x0C,0xA2).

    Response to `GnssAssistedFix`. Confirmed on 3DM-GX5-35; likely or assumed on 2 more. Known only
    from the MicroStrain MIP SDK.

    - mip-sdk-4: GNSS assisted fix (0x0C,0x23)
    """

    __slots__ = ("option", "flags")
    __match_args__ = ("option", "flags")

    SET = 0x0C
    DESCRIPTOR = 0xA2
    NAME = "3dm.gnss_assisted_fix_response"
    _SIZE = 2

    option: AssistedFixOption
    """Storage of data for a faster first fix. Default: `AssistedFixOption.NONE`."""
    flags: int
    """Reserved."""

    def __init__(self, option: AssistedFixOption, flags: int = 255) -> None:
        self.option = option
        self.flags = flags

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2B.unpack(raw, at)
        self.option = codec.KNOWN[AssistedFixOption][v[0]]
        self.flags = v[1]
        return at + 2

    def _write(self) -> bytes:
        return _2B.write("option flags", self.option, self.flags)


class GnssTimeAssistanceResponse(Response):
    """GNSS time assistance response (0x0C,0xA3).

    Response to `GnssTimeAssistance`. Confirmed on 3DM-GX5-35; likely or assumed on 2 more. Known
    only from the MicroStrain MIP SDK.

    - mip-sdk-4: GNSS time assistance (0x0C,0x24)
    """

    __slots__ = ("tow", "week_number", "accuracy")
    __match_args__ = ("tow", "week_number", "accuracy")

    SET = 0x0C
    DESCRIPTOR = 0xA3
    NAME = "3dm.gnss_time_assistance_response"
    _SIZE = 14

    tow: float
    """GPS time of week. Unit: s. Range: at least 0, less than 604800."""
    week_number: int
    """GPS week number since 1980. Unit: week."""
    accuracy: float
    """Estimated accuracy of the time that is sent. Unit: s. Range: at least 0."""

    def __init__(self, tow: float, week_number: int, accuracy: float) -> None:
        self.tow = tow
        self.week_number = week_number
        self.accuracy = accuracy

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _dHf.unpack(raw, at)
        if v[2] != v[2]:
            v = _dHf.keep_nan_bits(v, raw, at)
        self.tow, self.week_number, self.accuracy = v
        return at + 14

    def _write(self) -> bytes:
        return _dHf.write("tow week_number accuracy", self.tow, self.week_number, self.accuracy)


class PpsSourceControlResponse(Response):
    """PPS source control response (0x0C,0xA8).

    Also called `pps_source_response`. Response to `PpsSourceControl`. Confirmed on
    3DM-CV7-GNSS/INS; likely or assumed on 10 more.

    - 3dm-cv7-gnss-ins: PPS Source Control (0x0C,0x28)
    """

    __slots__ = ("source",)
    __match_args__ = ("source",)

    SET = 0x0C
    DESCRIPTOR = 0xA8
    NAME = "3dm.pps_source_control_response"
    _SIZE = 1

    source: PpsSource
    """Source of the pulse."""

    def __init__(self, source: PpsSource) -> None:
        self.source = source

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.source = codec.KNOWN[PpsSource][_B.unpack(raw, at)[0]]
        return at + 1

    def _write(self) -> bytes:
        return _B.write("source", self.source)


class SensorToVehicleTransformEulerResponse(Response):
    """Sensor-to-vehicle frame transformation Euler response (0x0C,0xB1).

    Also called `sensor_2_vehicle_transform_euler_response`. Response to
    `SensorToVehicleTransformEuler`. Confirmed on 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or
    assumed on 9 more.

    - 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Euler (0x0C,0x31)
    """

    __slots__ = ("roll", "pitch", "yaw")
    __match_args__ = ("roll", "pitch", "yaw")

    SET = 0x0C
    DESCRIPTOR = 0xB1
    NAME = "3dm.sensor_to_vehicle_transform_euler_response"
    _SIZE = 12

    roll: float
    """Roll angle of the sensor relative to the vehicle. Unit: rad. Frame: vehicle. Positive: right
    side down.
    """
    pitch: float
    """Pitch angle of the sensor relative to the vehicle. Unit: rad. Frame: vehicle. Positive: nose
    up.
    """
    yaw: float
    """Yaw angle of the sensor relative to the vehicle. Unit: rad. Frame: vehicle. Positive:
    clockwise seen from above.
    """

    def __init__(self, roll: float, pitch: float, yaw: float) -> None:
        self.roll = roll
        self.pitch = pitch
        self.yaw = yaw

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _3f.unpack(raw, at)
        if (total := v[0] + v[1] + v[2]) != total:
            v = _3f.keep_nan_bits(v, raw, at)
        self.roll, self.pitch, self.yaw = v
        return at + 12

    def _write(self) -> bytes:
        return _3f.write("roll pitch yaw", self.roll, self.pitch, self.yaw)


class SensorToVehicleTransformQuaternionResponse(Response):
    """Sensor-to-vehicle frame transformation quaternion response (0x0C,0xB2).

    Also called `sensor_2_vehicle_transform_quaternion_response`. Response to
    `SensorToVehicleTransformQuaternion`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10
    more.

    - 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Quaternion (0x0C,0x32)
    """

    __slots__ = ("q",)
    __match_args__ = ("q",)

    SET = 0x0C
    DESCRIPTOR = 0xB2
    NAME = "3dm.sensor_to_vehicle_transform_quaternion_response"
    _SIZE = 16
    _VECTORS = {"q": (types.Quatf,)}

    q: types.Quatf
    """Rotates vectors of the vehicle frame into the sensor frame; unit quaternion, w first.
    Elements: w, x, y, z. Unit: 1.
    """

    def __init__(self, q: types.Quatf | codec.Numbers) -> None:
        self.q = codec.vector(q, types.Quatf)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _4f.unpack(raw, at)
        if (total := v[0] + v[1] + v[2] + v[3]) != total:
            v = _4f.keep_nan_bits(v, raw, at)
        self._q = v
        return at + 16

    def _write(self) -> bytes:
        return _4f.write("q*4", *codec.elements("q", self.q, 4))


class SensorToVehicleTransformDcmResponse(Response):
    """Sensor-to-vehicle frame transformation direction cosine matrix response (0x0C,0xB3).

    Also called `sensor_2_vehicle_transform_dcm_response`. Response to
    `SensorToVehicleTransformDcm`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10 more.

    - 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Direction Cosine Matrix (0x0C,0x33)
    """

    __slots__ = ("dcm",)
    __match_args__ = ("dcm",)

    SET = 0x0C
    DESCRIPTOR = 0xB3
    NAME = "3dm.sensor_to_vehicle_transform_dcm_response"
    _SIZE = 36
    _VECTORS = {"dcm": (types.Matrix3f,)}

    dcm: types.Matrix3f
    """Rotates vectors of the sensor frame into the vehicle frame; row-major. Elements: m11, m12,
    m13, m21, m22, m23, m31, m32, m33. Unit: 1.
    """

    def __init__(self, dcm: types.Matrix3f | codec.Rows) -> None:
        self.dcm = codec.vector(dcm, types.Matrix3f)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _9f.unpack(raw, at)
        if (total := sum(v)) != total:
            v = _9f.keep_nan_bits(v, raw, at)
        self._dcm = v
        return at + 36

    def _write(self) -> bytes:
        return _9f.write("dcm*9", *codec.elements("dcm", self.dcm, 9))


class GetEventSupportResponse(Response):
    """Get supported events response (0x0C,0xB4).

    Response to `GetEventSupport`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS;
    likely or assumed on 8 more.

    - 3dm-cv7-gnss-ins: Get Supported Events (0x0C,0x2A)
    """

    __slots__ = ("query", "max_instances", "entries")
    __match_args__ = ("query", "max_instances", "entries")

    SET = 0x0C
    DESCRIPTOR = 0xB4
    NAME = "3dm.get_event_support_response"

    query: EventSupportQuery
    """Query specified in the command."""
    max_instances: int
    """Number of instances, which are numbered from 1. Unit: 1."""
    # On the wire only: num_entries. Number of types. Counts the elements of `entries`.
    entries: tuple[EventSupportInfo, ...]
    """The types.

    - If `query` is `EventSupportQuery.TRIGGER_TYPES`: `type` has values of
      `types.EventTriggerType`.
    - If `query` is `EventSupportQuery.ACTION_TYPES`: `type` has values of `types.EventActionType`.
    """

    def __init__(
        self, query: EventSupportQuery, max_instances: int, entries: Sequence[EventSupportInfo]
    ) -> None:
        self.query = query
        self.max_instances = max_instances
        self.entries = codec.several(entries)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _3B.read(raw, at)
        self.query = codec.KNOWN[EventSupportQuery][v[0]]
        self.max_instances = v[1]
        n_num_entries = v[2]
        at += 3
        n = codec.counted(raw, at, n_num_entries, 2, 125)
        self.entries, at = codec.read_structures(EventSupportInfo, raw, at, n)
        return at

    def _write(self) -> bytes:
        out = _3B.write(
            "query max_instances num_entries",
            self.query,
            self.max_instances,
            codec.count("entries", self.entries, 125),
        )
        out += codec.write_structures(
            "entries", codec.at_most("entries", self.entries, 125), EventSupportInfo
        )
        return codec.finished(out)


class EventControlResponse(Response):
    """Event control response (0x0C,0xB5).

    Response to `EventControl`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10 more.

    - 3dm-cv7-gnss-ins: Event Control (0x0C,0x2B)
    """

    __slots__ = ("instance", "mode")
    __match_args__ = ("instance", "mode")

    SET = 0x0C
    DESCRIPTOR = 0xB5
    NAME = "3dm.event_control_response"
    _SIZE = 2

    instance: int
    """Trigger instance."""
    mode: types.EventTriggerMode
    """Mode of the trigger. Default: `types.EventTriggerMode.DISABLED`."""

    def __init__(self, instance: int, mode: types.EventTriggerMode) -> None:
        self.instance = instance
        self.mode = mode

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2B.unpack(raw, at)
        self.instance = v[0]
        self.mode = codec.KNOWN[types.EventTriggerMode][v[1]]
        return at + 2

    def _write(self) -> bytes:
        return _2B.write("instance mode", self.instance, self.mode)


class GetEventTriggerStatusResponse(Response):
    """Get event trigger status response (0x0C,0xB6).

    Response to `GetEventTriggerStatus`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10
    more.

    - 3dm-cv7-gnss-ins: Get Event Trigger Status (0x0C,0x2C)
    """

    __slots__ = ("triggers",)
    __match_args__ = ("triggers",)

    SET = 0x0C
    DESCRIPTOR = 0xB6
    NAME = "3dm.get_event_trigger_status_response"

    # On the wire only: count. Number of entries. Counts the elements of `triggers`.
    triggers: tuple[EventTriggerStatusEntry, ...]
    """One entry per trigger, in the requested order, or by instance if all were requested."""

    def __init__(self, triggers: Sequence[EventTriggerStatusEntry]) -> None:
        self.triggers = codec.several(triggers)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _B.read(raw, at)
        n_count = v[0]
        at += 1
        n = codec.counted(raw, at, n_count, 2, 126)
        self.triggers, at = codec.read_structures(EventTriggerStatusEntry, raw, at, n)
        return at

    def _write(self) -> bytes:
        out = _B.write("count", codec.count("triggers", self.triggers, 126))
        out += codec.write_structures(
            "triggers", codec.at_most("triggers", self.triggers, 126), EventTriggerStatusEntry
        )
        return codec.finished(out)


class GetEventActionStatusResponse(Response):
    """Get event action status response (0x0C,0xB7).

    Response to `GetEventActionStatus`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10 more.

    - 3dm-cv7-gnss-ins: Get Event Action Status (0x0C,0x2D)
    """

    __slots__ = ("actions",)
    __match_args__ = ("actions",)

    SET = 0x0C
    DESCRIPTOR = 0xB7
    NAME = "3dm.get_event_action_status_response"

    # On the wire only: count. Number of entries. Counts the elements of `actions`.
    actions: tuple[EventActionStatusEntry, ...]
    """One entry per action, in the requested order, or by instance if all were requested."""

    def __init__(self, actions: Sequence[EventActionStatusEntry]) -> None:
        self.actions = codec.several(actions)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _B.read(raw, at)
        n_count = v[0]
        at += 1
        n = codec.counted(raw, at, n_count, 2, 126)
        self.actions, at = codec.read_structures(EventActionStatusEntry, raw, at, n)
        return at

    def _write(self) -> bytes:
        out = _B.write("count", codec.count("actions", self.actions, 126))
        out += codec.write_structures(
            "actions", codec.at_most("actions", self.actions, 126), EventActionStatusEntry
        )
        return codec.finished(out)


class EventTriggerConfigResponse(Response):
    """Event trigger configuration response (0x0C,0xB8).

    Also called `event_trigger_response`. Response to `EventTriggerConfig`. Confirmed on
    3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 8 more.

    - 3dm-cv7-gnss-ins: Event Trigger Configuration (0x0C,0x2E)
    """

    __slots__ = ("instance", "type", "parameters")
    __match_args__ = ("instance", "type", "parameters")

    SET = 0x0C
    DESCRIPTOR = 0xB8
    NAME = "3dm.event_trigger_config_response"

    instance: int
    """Trigger instance."""
    type: types.EventTriggerType
    """Kind of trigger. Default: `types.EventTriggerType.NONE`."""
    parameters: (
        types.EventTriggerGpio | types.EventTriggerThreshold | types.EventTriggerCombination | None
    )
    """The condition. Selected by `type`.

    - If `type` is `types.EventTriggerType.NONE`: `None`.
    - If `type` is `types.EventTriggerType.GPIO`: `types.EventTriggerGpio`.
    - If `type` is `types.EventTriggerType.THRESHOLD`: `types.EventTriggerThreshold`.
    - If `type` is `types.EventTriggerType.COMBINATION`: `types.EventTriggerCombination`.
    """

    def __init__(
        self,
        instance: int,
        type: types.EventTriggerType,
        parameters: types.EventTriggerGpio
        | types.EventTriggerThreshold
        | types.EventTriggerCombination
        | None = None,
    ) -> None:
        self.instance = instance
        self.type = type
        self.parameters = parameters

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2B.read(raw, at)
        self.instance = v[0]
        self.type = codec.KNOWN[types.EventTriggerType][v[1]]
        at += 2
        self.parameters = None
        if self.type == 1:
            self.parameters, at = types.EventTriggerGpio._decoded(raw, at)
        if self.type == 2:
            self.parameters, at = types.EventTriggerThreshold._decoded(raw, at)
        if self.type == 3:
            self.parameters, at = types.EventTriggerCombination._decoded(raw, at)
        return at

    def _write(self) -> bytes:
        out = _2B.write("instance type", self.instance, self.type)
        if self.type == 1:
            codec.check_selected("parameters", self.parameters, self.type, types.EventTriggerGpio)
            out += codec.structure("parameters", self.parameters, types.EventTriggerGpio)
        elif self.type == 2:
            codec.check_selected(
                "parameters", self.parameters, self.type, types.EventTriggerThreshold
            )
            out += codec.structure("parameters", self.parameters, types.EventTriggerThreshold)
        elif self.type == 3:
            codec.check_selected(
                "parameters", self.parameters, self.type, types.EventTriggerCombination
            )
            out += codec.structure("parameters", self.parameters, types.EventTriggerCombination)
        else:
            codec.check_unselected("parameters", self.parameters, self.type)
        return codec.finished(out)


class EventActionConfigResponse(Response):
    """Event action configuration response (0x0C,0xB9).

    Also called `event_action_response`. Response to `EventActionConfig`. Confirmed on 3DM-CV7-AHRS,
    3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 8 more.

    - 3dm-cv7-gnss-ins: Event Action Configuration (0x0C,0x2F)
    - 3dm-cv7-gnss-ins: Event Cycle
    """

    __slots__ = ("instance", "trigger", "type", "parameters")
    __match_args__ = ("instance", "trigger", "type", "parameters")

    SET = 0x0C
    DESCRIPTOR = 0xB9
    NAME = "3dm.event_action_config_response"

    instance: int
    """Action instance."""
    trigger: int
    """Trigger instance that the action follows."""
    type: types.EventActionType
    """Kind of action. Default: `types.EventActionType.NONE`."""
    parameters: types.EventActionGpio | types.EventActionMessage | None
    """Effect of the action. Selected by `type`.

    - If `type` is `types.EventActionType.NONE`: `None`.
    - If `type` is `types.EventActionType.GPIO`: `types.EventActionGpio`.
    - If `type` is `types.EventActionType.MESSAGE`: `types.EventActionMessage`.
    """

    def __init__(
        self,
        instance: int,
        trigger: int,
        type: types.EventActionType,
        parameters: types.EventActionGpio | types.EventActionMessage | None = None,
    ) -> None:
        self.instance = instance
        self.trigger = trigger
        self.type = type
        self.parameters = parameters

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _3B.read(raw, at)
        self.instance = v[0]
        self.trigger = v[1]
        self.type = codec.KNOWN[types.EventActionType][v[2]]
        at += 3
        self.parameters = None
        if self.type == 1:
            self.parameters, at = types.EventActionGpio._decoded(raw, at)
        if self.type == 2:
            self.parameters, at = types.EventActionMessage._decoded(raw, at)
        return at

    def _write(self) -> bytes:
        out = _3B.write("instance trigger type", self.instance, self.trigger, self.type)
        if self.type == 1:
            codec.check_selected("parameters", self.parameters, self.type, types.EventActionGpio)
            out += codec.structure("parameters", self.parameters, types.EventActionGpio)
        elif self.type == 2:
            codec.check_selected("parameters", self.parameters, self.type, types.EventActionMessage)
            out += codec.structure("parameters", self.parameters, types.EventActionMessage)
        else:
            codec.check_unselected("parameters", self.parameters, self.type)
        return codec.finished(out)


class GpioConfigResponse(Response):
    """GPIO configuration response (0x0C,0xC1).

    Response to `GpioConfig`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or
    assumed on 8 more.

    - 3dm-cv7-gnss-ins: GPIO Configuration (0x0C,0x41)
    """

    __slots__ = ("pin", "feature", "behavior", "pin_mode")
    __match_args__ = ("pin", "feature", "behavior", "pin_mode")

    SET = 0x0C
    DESCRIPTOR = 0xC1
    NAME = "3dm.gpio_config_response"
    _SIZE = 4

    pin: int
    """GPIO pin, counted from 1."""
    feature: types.GpioFeature
    """Use of the pin. Default: `types.GpioFeature.UNUSED`."""
    behavior: int
    """Role of the pin within the feature; 0 if the feature has no roles.

    - If `feature` is `types.GpioFeature.UNUSED`: values of `types.GpioUnusedBehavior`.
    - If `feature` is `types.GpioFeature.GPIO`: values of `types.GpioBehavior`.
    - If `feature` is `types.GpioFeature.PPS`: values of `types.GpioPpsBehavior`.
    - If `feature` is `types.GpioFeature.ENCODER`: values of `types.GpioEncoderBehavior`.
    - If `feature` is `types.GpioFeature.TIMESTAMP`: values of `types.GpioTimestampBehavior`.
    - If `feature` is `types.GpioFeature.UART`: values of `types.GpioUartBehavior`.
    """
    pin_mode: types.GpioPinMode
    """Electrical options."""

    def __init__(
        self, pin: int, feature: types.GpioFeature, behavior: int, pin_mode: types.GpioPinMode
    ) -> None:
        self.pin = pin
        self.feature = feature
        self.behavior = behavior
        self.pin_mode = pin_mode

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _4B.unpack(raw, at)
        self.pin = v[0]
        self.feature = codec.KNOWN[types.GpioFeature][v[1]]
        self.behavior = v[2]
        self.pin_mode = codec.KNOWN[types.GpioPinMode][v[3]]
        return at + 4

    def _write(self) -> bytes:
        return _4B.write(
            "pin feature behavior pin_mode", self.pin, self.feature, self.behavior, self.pin_mode
        )


class GpioStateResponse(Response):
    """GPIO state response (0x0C,0xC2).

    Response to `GpioState`. Confirmed on 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed
    on 9 more.

    - 3dm-cv7-gnss-ins: GPIO State (0x0C,0x42)
    """

    __slots__ = ("pin", "state")
    __match_args__ = ("pin", "state")

    SET = 0x0C
    DESCRIPTOR = 0xC2
    NAME = "3dm.gpio_state_response"
    _SIZE = 2

    pin: int
    """GPIO pin, counted from 1. Range: at least 1."""
    state: bool
    """True means high."""

    def __init__(self, pin: int, state: bool) -> None:
        self.pin = pin
        self.state = state

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2B.unpack(raw, at)
        self.pin = v[0]
        self.state = codec.TRUTH[v[1]]
        return at + 2

    def _write(self) -> bytes:
        return _2B.write("pin state", self.pin, self.state)


class OdometerConfigResponse(Response):
    """Odometer configuration response (0x0C,0xC3).

    Also called `odometer_response`. Response to `OdometerConfig`. Confirmed on 3DM-CV7-GNSS/INS;
    likely or assumed on 1 more.

    - 3dm-cv7-gnss-ins: Odometer Configuration (0x0C,0x43)
    """

    __slots__ = ("mode", "scaling", "uncertainty")
    __match_args__ = ("mode", "scaling", "uncertainty")

    SET = 0x0C
    DESCRIPTOR = 0xC3
    NAME = "3dm.odometer_config_response"
    _SIZE = 9

    mode: OdometerMode
    """Operation of the input."""
    scaling: float
    """Pulses per distance travelled; negative if the encoder rotates backwards. Unit: pulse/m.
    Pulses on line A per turn of the wheel, divided by the circumference of the wheel.
    """
    uncertainty: float
    """Relative uncertainty of the scaling, 1 sigma. Unit: 1. Range: at least 0."""

    def __init__(self, mode: OdometerMode, scaling: float, uncertainty: float) -> None:
        self.mode = mode
        self.scaling = scaling
        self.uncertainty = uncertainty

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _B2f.unpack(raw, at)
        if (total := v[1] + v[2]) != total:
            v = _B2f.keep_nan_bits(v, raw, at)
        self.mode = codec.KNOWN[OdometerMode][v[0]]
        self.scaling = v[1]
        self.uncertainty = v[2]
        return at + 9

    def _write(self) -> bytes:
        return _B2f.write("mode scaling uncertainty", self.mode, self.scaling, self.uncertainty)


class SensorRangeResponse(Response):
    """Sensor range response (0x0C,0xD2).

    Response to `SensorRange`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10 more.

    - 3dm-cv7-gnss-ins: Sensor Range (0x0C,0x52)
    """

    __slots__ = ("sensor", "setting")
    __match_args__ = ("sensor", "setting")

    SET = 0x0C
    DESCRIPTOR = 0xD2
    NAME = "3dm.sensor_range_response"
    _SIZE = 2

    sensor: SensorRangeType
    """Sensor whose range is set or read."""
    setting: int
    """Number of the range."""

    def __init__(self, sensor: SensorRangeType, setting: int) -> None:
        self.sensor = sensor
        self.setting = setting

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2B.unpack(raw, at)
        self.sensor = codec.KNOWN[SensorRangeType][v[0]]
        self.setting = v[1]
        return at + 2

    def _write(self) -> bytes:
        return _2B.write("sensor setting", self.sensor, self.setting)


class GetCalibratedSensorRangesResponse(Response):
    """Get calibrated sensor ranges response (0x0C,0xD3).

    Also called `calibrated_sensor_ranges_response`. Response to `GetCalibratedSensorRanges`.
    Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10 more.

    - 3dm-cv7-gnss-ins: Get Calibrated Sensor Ranges (0x0C,0x53)
    """

    __slots__ = ("sensor", "ranges")
    __match_args__ = ("sensor", "ranges")

    SET = 0x0C
    DESCRIPTOR = 0xD3
    NAME = "3dm.get_calibrated_sensor_ranges_response"

    sensor: SensorRangeType
    """Sensor specified in the command."""
    # On the wire only: num_ranges. Number of ranges. Counts the elements of `ranges`.
    ranges: tuple[SensorRangeEntry, ...]
    """Ranges for which the sensor is calibrated.

    - If `sensor` is `SensorRangeType.ACCEL`: `range` has unit g.
    - If `sensor` is `SensorRangeType.GYRO`: `range` has unit deg/s.
    - If `sensor` is `SensorRangeType.MAG`: `range` has unit gauss.
    - If `sensor` is `SensorRangeType.PRESSURE`: `range` has unit mbar.
    """

    def __init__(self, sensor: SensorRangeType, ranges: Sequence[SensorRangeEntry]) -> None:
        self.sensor = sensor
        self.ranges = codec.several(ranges)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2B.read(raw, at)
        self.sensor = codec.KNOWN[SensorRangeType][v[0]]
        n_num_ranges = v[1]
        at += 2
        n = codec.counted(raw, at, n_num_ranges, 5, 50)
        self.ranges, at = codec.read_structures(SensorRangeEntry, raw, at, n)
        return at

    def _write(self) -> bytes:
        out = _2B.write("sensor num_ranges", self.sensor, codec.count("ranges", self.ranges, 50))
        out += codec.write_structures(
            "ranges", codec.at_most("ranges", self.ranges, 50), SensorRangeEntry
        )
        return codec.finished(out)


class LowPassFilterResponse(Response):
    """Low-pass anti-aliasing filter response (0x0C,0xD4).

    Also called `lowpass_filter_response`. Response to `LowPassFilter`. Confirmed on 3DM-CV7-AHRS,
    3DM-CV7-AR, 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed on 7 more.

    - 3dm-cv7-gnss-ins: Low-Pass Anti-Aliasing Filter (0x0C,0x54)
    """

    __slots__ = ("descriptor_set", "field_descriptor", "enable", "manual", "frequency")
    __match_args__ = ("descriptor_set", "field_descriptor", "enable", "manual", "frequency")

    SET = 0x0C
    DESCRIPTOR = 0xD4
    NAME = "3dm.low_pass_filter_response"
    _SIZE = 8

    descriptor_set: int
    """Descriptor set of the field."""
    field_descriptor: int
    """Descriptor of the field that is filtered. Refers to fields of `descriptor_set`."""
    enable: bool
    """True if the field is filtered."""
    manual: bool
    """True uses `frequency`; false uses half the rate of the field in the message format."""
    frequency: float
    """Cutoff in use. Unit: Hz. Range: at least 0."""

    def __init__(
        self,
        descriptor_set: int,
        field_descriptor: int,
        enable: bool,
        manual: bool,
        frequency: float,
    ) -> None:
        self.descriptor_set = descriptor_set
        self.field_descriptor = field_descriptor
        self.enable = enable
        self.manual = manual
        self.frequency = frequency

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _4Bf.unpack(raw, at)
        if v[4] != v[4]:
            v = _4Bf.keep_nan_bits(v, raw, at)
        self.descriptor_set = v[0]
        self.field_descriptor = v[1]
        self.enable = codec.TRUTH[v[2]]
        self.manual = codec.TRUTH[v[3]]
        self.frequency = v[4]
        return at + 8

    def _write(self) -> bytes:
        return _4Bf.write(
            "descriptor_set field_descriptor enable manual frequency",
            self.descriptor_set,
            self.field_descriptor,
            self.enable,
            self.manual,
            self.frequency,
        )


class PollImuData(Command[None]):
    """Poll IMU data (0x0C,0x01).

    Requests one sensor data packet (0x80) with the listed fields, in the listed order.

    Also called `poll_imu_message`. Not acknowledged if `suppress_ack` is true. Devices without it
    may have `PollData`. Confirmed on 3DM-CV5-10, 3DM-CV5-15, 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15,
    3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 15 more.

    An empty list polls the fields that `ImuMessageFormat` stores; if nothing is stored, the device
    rejects the command. Descriptors that the device does not know are ignored. The data is sent in
    a separate packet after the reply.

    - 3dm-gx5-15: 4.2.1 Poll IMU Data (0x0C, 0x01)
    """

    __slots__ = ("suppress_ack", "descriptors")
    __match_args__ = ("suppress_ack", "descriptors")

    SET = 0x0C
    DESCRIPTOR = 0x01
    NAME = "3dm.poll_imu_data"

    suppress_ack: bool
    """Send no acknowledge."""
    # On the wire only: num_descriptors. Number of fields. Counts the elements of `descriptors`.
    descriptors: tuple[PollEntry, ...]
    """Fields to send. Refers to fields of Sensor data."""

    def __init__(self, suppress_ack: bool, descriptors: Sequence[PollEntry]) -> None:
        self.suppress_ack = suppress_ack
        self.descriptors = codec.several(descriptors)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2B.read(raw, at)
        self.suppress_ack = codec.TRUTH[v[0]]
        n_num_descriptors = v[1]
        at += 2
        n = codec.counted(raw, at, n_num_descriptors, 3, 83)
        self.descriptors, at = codec.read_structures(PollEntry, raw, at, n)
        return at

    def _write(self) -> bytes:
        out = _2B.write(
            "suppress_ack num_descriptors",
            self.suppress_ack,
            codec.count("descriptors", self.descriptors, 83),
        )
        out += codec.write_structures(
            "descriptors", codec.at_most("descriptors", self.descriptors, 83), PollEntry
        )
        return codec.finished(out)

    @property
    def answered(self) -> bool:
        return not self.suppress_ack


class PollGnssData(Command[None]):
    """Poll GNSS data (0x0C,0x02).

    Requests one GNSS data packet with the listed fields, in the listed order.

    Also called `poll_gnss_message`. Not acknowledged if `suppress_ack` is true. Devices without it
    may have `PollData`. Confirmed on 3DM-GQ4-45, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST;
    likely or assumed on 5 more. Known only from the MicroStrain MIP SDK. Requires a receiver.

    An empty list polls the format stored by `GnssMessageFormat`; if none is stored, the device
    rejects the command. Descriptors that the device does not know are omitted. The data is sent in
    a separate packet after the reply.

    - mip-sdk-4: Poll Gnss Message (0x0C,0x02)
    """

    __slots__ = ("suppress_ack", "descriptors")
    __match_args__ = ("suppress_ack", "descriptors")

    SET = 0x0C
    DESCRIPTOR = 0x02
    NAME = "3dm.poll_gnss_data"

    suppress_ack: bool
    """Send no acknowledge."""
    # On the wire only: num_descriptors. Number of fields. Counts the elements of `descriptors`.
    # Range: 0 to 83.
    descriptors: tuple[PollEntry, ...]
    """Fields to send. Refers to fields of GNSS data. Uncertain: The SDK has a decimation in place
    of the reserved number and does not document how a poll uses it.
    """

    def __init__(self, suppress_ack: bool, descriptors: Sequence[PollEntry]) -> None:
        self.suppress_ack = suppress_ack
        self.descriptors = codec.several(descriptors)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2B.read(raw, at)
        self.suppress_ack = codec.TRUTH[v[0]]
        n_num_descriptors = v[1]
        at += 2
        n = codec.counted(raw, at, n_num_descriptors, 3, 83)
        self.descriptors, at = codec.read_structures(PollEntry, raw, at, n)
        return at

    def _write(self) -> bytes:
        out = _2B.write(
            "suppress_ack num_descriptors",
            self.suppress_ack,
            codec.count("descriptors", self.descriptors, 83),
        )
        out += codec.write_structures(
            "descriptors", codec.at_most("descriptors", self.descriptors, 83), PollEntry
        )
        return codec.finished(out)

    @property
    def answered(self) -> bool:
        return not self.suppress_ack


class PollFilterData(Command[None]):
    """Poll estimation filter data (0x0C,0x03).

    Requests one filter data packet (0x82) with the listed fields, in the listed order.

    Also called `poll_filter_message`. Not acknowledged if `suppress_ack` is true. Devices without
    it may have `PollData`. Confirmed on 3DM-CV5-15, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-45,
    3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 8 more.

    An empty list polls the fields that `FilterMessageFormat` stores; if none are, the device
    rejects the command. Descriptors that the device does not know are ignored. The data is sent in
    a separate packet after the reply.

    - 3dm-gx5-15: 4.2.2 Poll Estimation Filter Data (0x0C, 0x03)
    """

    __slots__ = ("suppress_ack", "descriptors")
    __match_args__ = ("suppress_ack", "descriptors")

    SET = 0x0C
    DESCRIPTOR = 0x03
    NAME = "3dm.poll_filter_data"

    suppress_ack: bool
    """Send no acknowledge."""
    # On the wire only: num_descriptors. Number of fields. Counts the elements of `descriptors`.
    descriptors: tuple[PollEntry, ...]
    """Fields to send. Refers to fields of Filter data."""

    def __init__(self, suppress_ack: bool, descriptors: Sequence[PollEntry]) -> None:
        self.suppress_ack = suppress_ack
        self.descriptors = codec.several(descriptors)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2B.read(raw, at)
        self.suppress_ack = codec.TRUTH[v[0]]
        n_num_descriptors = v[1]
        at += 2
        n = codec.counted(raw, at, n_num_descriptors, 3, 83)
        self.descriptors, at = codec.read_structures(PollEntry, raw, at, n)
        return at

    def _write(self) -> bytes:
        out = _2B.write(
            "suppress_ack num_descriptors",
            self.suppress_ack,
            codec.count("descriptors", self.descriptors, 83),
        )
        out += codec.write_structures(
            "descriptors", codec.at_most("descriptors", self.descriptors, 83), PollEntry
        )
        return codec.finished(out)

    @property
    def answered(self) -> bool:
        return not self.suppress_ack


class PollNmeaData(Command[None]):
    """Poll NMEA data (0x0C,0x04).

    Requests the listed NMEA sentences once.

    Also called `nmea_poll_data`. Not acknowledged if `suppress_ack` is true. Confirmed on
    3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed on 3 more.

    An empty list polls the stored NMEA format; if none is stored, the device rejects the command.
    The sentences follow the reply as ordinary NMEA text, on the port of the command, even if NMEA
    is disabled there. A sentence is sent only if its data is valid.

    - 3dm-cv7-gnss-ins: Poll NMEA Data (0x0C,0x04)
    """

    __slots__ = ("suppress_ack", "format_entries")
    __match_args__ = ("suppress_ack", "format_entries")

    SET = 0x0C
    DESCRIPTOR = 0x04
    NAME = "3dm.poll_nmea_data"

    suppress_ack: bool
    """Send no acknowledge."""
    # On the wire only: count. Number of sentences. Counts the elements of `format_entries`.
    format_entries: tuple[types.NmeaMessage, ...]
    """Sentences to send."""

    def __init__(self, suppress_ack: bool, format_entries: Sequence[types.NmeaMessage]) -> None:
        self.suppress_ack = suppress_ack
        self.format_entries = codec.several(format_entries)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2B.read(raw, at)
        self.suppress_ack = codec.TRUTH[v[0]]
        n_count = v[1]
        at += 2
        n = codec.counted(raw, at, n_count, 5, 50)
        self.format_entries, at = codec.read_structures(types.NmeaMessage, raw, at, n)
        return at

    def _write(self) -> bytes:
        out = _2B.write(
            "suppress_ack count",
            self.suppress_ack,
            codec.count("format_entries", self.format_entries, 50),
        )
        out += codec.write_structures(
            "format_entries",
            codec.at_most("format_entries", self.format_entries, 50),
            types.NmeaMessage,
        )
        return codec.finished(out)

    @property
    def answered(self) -> bool:
        return not self.suppress_ack


class GetImuBaseRate(Command[GetImuBaseRateResponse]):
    """Get IMU data base rate (0x0C,0x06).

    Gets the base rate, which is divided by the decimations of `ImuMessageFormat`.

    Also called `imu_get_base_rate`. Response: `GetImuBaseRateResponse`. Devices without it may have
    `GetBaseRate`. Confirmed on 3DM-CV5-10, 3DM-CV5-15, 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15,
    3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 15 more.

    - 3dm-gx5-15: 4.2.3 Get IMU Data Base Rate (0x0C, 0x06)
    """

    __slots__ = ()

    SET = 0x0C
    DESCRIPTOR = 0x06
    NAME = "3dm.get_imu_base_rate"
    RESPONSES = (GetImuBaseRateResponse,)


class GetGnssBaseRate(Command[GetGnssBaseRateResponse]):
    """Get GNSS data base rate (0x0C,0x07).

    Gets the base rate, which is divided by the decimations of `GnssMessageFormat`.

    Also called `gnss_get_base_rate`. Response: `GetGnssBaseRateResponse`. Devices without it may
    have `GetBaseRate`. Confirmed on 3DM-GQ4-45, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT and
    3DM-RQ1-45-ST; likely or assumed on 4 more. Known only from the MicroStrain MIP SDK. Requires a
    receiver.

    - mip-sdk-4: Gnss Get Base Rate (0x0C,0x07)
    """

    __slots__ = ()

    SET = 0x0C
    DESCRIPTOR = 0x07
    NAME = "3dm.get_gnss_base_rate"
    RESPONSES = (GetGnssBaseRateResponse,)


class ImuMessageFormat(Command[R]):
    """IMU message format (0x0C,0x08).

    Sets the fields of the sensor data packets (0x80), their order and their decimations.

    Functions: `write`, `read`, `save`, `load` and `default`. Response: `ImuMessageFormatResponse`.
    Devices without it may have `MessageFormat`. Confirmed on 3DM-CV5-10, 3DM-CV5-15, 3DM-CX5-10,
    3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or
    assumed on 14 more.

    The decimation is the base rate, as `GetImuBaseRate` reports it, divided by the desired rate.
    The list replaces the previous one. If any descriptor is unknown, the device rejects the command
    and changes nothing.

    - 3dm-gx5-15: 4.2.5 IMU Message Format (0x0C, 0x08)
    """

    __slots__ = ("function", "descriptors")
    __match_args__ = ("function", "descriptors")

    SET = 0x0C
    DESCRIPTOR = 0x08
    NAME = "3dm.imu_message_format"
    RESPONSES = (ImuMessageFormatResponse,)
    REQUIRED = {1: 2, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """Operation on the setting."""
    # On the wire only: num_descriptors. Number of fields. Counts the elements of `descriptors`.
    # Required for `write`.
    descriptors: tuple[types.DescriptorRate, ...] | None
    """Fields and decimations. Refers to fields of Sensor data. Required for `write`."""

    def __init__(
        self, function: FunctionSelector, descriptors: Sequence[types.DescriptorRate] | None = None
    ) -> None:
        self.function = function
        self.descriptors = codec.several(descriptors)

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        self.descriptors = None
        required = self.REQUIRED.get(self.function, 0)
        done, end = 0, at
        try:
            codec.check_more(raw, at, required < 2)
            v = _B.read(raw, at)
            n_num_descriptors = v[0]
            at += 1
            n = codec.counted(raw, at, n_num_descriptors, 3, 83)
            self.descriptors, at = codec.read_structures(types.DescriptorRate, raw, at, n)
            done, end = 2, at
        except codec.Truncated:
            if done < required:
                raise
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(self, self.REQUIRED.get(self.function, 0), (2, "descriptors"))
        if there >= 2:
            out += _B.write("num_descriptors", codec.count("descriptors", self.descriptors, 83))
            out += codec.write_structures(
                "descriptors",
                codec.at_most("descriptors", self.descriptors, 83),
                types.DescriptorRate,
            )
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[ImuMessageFormat[Any]], descriptors: Sequence[types.DescriptorRate]
    ) -> ImuMessageFormat[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, descriptors=descriptors)

    @classmethod
    def read(cls: ClassOf[ImuMessageFormat[Any]]) -> ImuMessageFormat[ImuMessageFormatResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[ImuMessageFormat[Any]]) -> ImuMessageFormat[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[ImuMessageFormat[Any]]) -> ImuMessageFormat[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[ImuMessageFormat[Any]]) -> ImuMessageFormat[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (ImuMessageFormatResponse,)
        return ()


class GnssMessageFormat(Command[R]):
    """GNSS message format (0x0C,0x09).

    Sets the fields of the GNSS data packets, their order and their decimations.

    Functions: `write`, `read`, `save`, `load` and `default`. Response: `GnssMessageFormatResponse`.
    Devices without it may have `MessageFormat`. Confirmed on 3DM-GQ4-45, 3DM-GX5-35, 3DM-GX5-45,
    3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 4 more. Requires a receiver.

    The decimation is the base rate, as `GetGnssBaseRate` reports it, divided by the desired rate.

    - mip-sdk-4: GNSS message format (0x0C,0x09)
    - 3dm-gx5-35: 4.2.6 GNSS Message Format (0x0C, 0x09)
    """

    __slots__ = ("function", "descriptors")
    __match_args__ = ("function", "descriptors")

    SET = 0x0C
    DESCRIPTOR = 0x09
    NAME = "3dm.gnss_message_format"
    RESPONSES = (GnssMessageFormatResponse,)
    REQUIRED = {1: 2, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """Operation on the setting."""
    # On the wire only: num_descriptors. Number of fields. Counts the elements of `descriptors`.
    # Range: 0 to 82. Required for `write`.
    descriptors: tuple[types.DescriptorRate, ...] | None
    """Fields and decimations. Refers to fields of GNSS data. Required for `write`."""

    def __init__(
        self, function: FunctionSelector, descriptors: Sequence[types.DescriptorRate] | None = None
    ) -> None:
        self.function = function
        self.descriptors = codec.several(descriptors)

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        self.descriptors = None
        required = self.REQUIRED.get(self.function, 0)
        done, end = 0, at
        try:
            codec.check_more(raw, at, required < 2)
            v = _B.read(raw, at)
            n_num_descriptors = v[0]
            at += 1
            n = codec.counted(raw, at, n_num_descriptors, 3, 83)
            self.descriptors, at = codec.read_structures(types.DescriptorRate, raw, at, n)
            done, end = 2, at
        except codec.Truncated:
            if done < required:
                raise
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(self, self.REQUIRED.get(self.function, 0), (2, "descriptors"))
        if there >= 2:
            out += _B.write("num_descriptors", codec.count("descriptors", self.descriptors, 83))
            out += codec.write_structures(
                "descriptors",
                codec.at_most("descriptors", self.descriptors, 83),
                types.DescriptorRate,
            )
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[GnssMessageFormat[Any]], descriptors: Sequence[types.DescriptorRate]
    ) -> GnssMessageFormat[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, descriptors=descriptors)

    @classmethod
    def read(cls: ClassOf[GnssMessageFormat[Any]]) -> GnssMessageFormat[GnssMessageFormatResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[GnssMessageFormat[Any]]) -> GnssMessageFormat[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[GnssMessageFormat[Any]]) -> GnssMessageFormat[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[GnssMessageFormat[Any]]) -> GnssMessageFormat[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (GnssMessageFormatResponse,)
        return ()


class FilterMessageFormat(Command[R]):
    """Estimation filter message format (0x0C,0x0A).

    Sets the fields of the filter data packets (0x82), their order and their decimations.

    Functions: `write`, `read`, `save`, `load` and `default`. Response:
    `FilterMessageFormatResponse`. Devices without it may have `MessageFormat`. Confirmed on
    3DM-CV5-15, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or
    assumed on 9 more.

    The decimation is the base rate, as `GetFilterBaseRate` reports it, divided by the desired rate.
    The list replaces the previous one. If any descriptor is unknown, the device rejects the command
    and changes nothing.

    - 3dm-gx5-15: 4.2.6 Estimation Filter Message Format (0x0C, 0x0A)
    """

    __slots__ = ("function", "descriptors")
    __match_args__ = ("function", "descriptors")

    SET = 0x0C
    DESCRIPTOR = 0x0A
    NAME = "3dm.filter_message_format"
    RESPONSES = (FilterMessageFormatResponse,)
    REQUIRED = {1: 2, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """Operation on the setting."""
    # On the wire only: num_descriptors. Number of fields. Counts the elements of `descriptors`.
    # Required for `write`.
    descriptors: tuple[types.DescriptorRate, ...] | None
    """Fields and decimations. Refers to fields of Filter data. Required for `write`."""

    def __init__(
        self, function: FunctionSelector, descriptors: Sequence[types.DescriptorRate] | None = None
    ) -> None:
        self.function = function
        self.descriptors = codec.several(descriptors)

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        self.descriptors = None
        required = self.REQUIRED.get(self.function, 0)
        done, end = 0, at
        try:
            codec.check_more(raw, at, required < 2)
            v = _B.read(raw, at)
            n_num_descriptors = v[0]
            at += 1
            n = codec.counted(raw, at, n_num_descriptors, 3, 83)
            self.descriptors, at = codec.read_structures(types.DescriptorRate, raw, at, n)
            done, end = 2, at
        except codec.Truncated:
            if done < required:
                raise
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(self, self.REQUIRED.get(self.function, 0), (2, "descriptors"))
        if there >= 2:
            out += _B.write("num_descriptors", codec.count("descriptors", self.descriptors, 83))
            out += codec.write_structures(
                "descriptors",
                codec.at_most("descriptors", self.descriptors, 83),
                types.DescriptorRate,
            )
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[FilterMessageFormat[Any]], descriptors: Sequence[types.DescriptorRate]
    ) -> FilterMessageFormat[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, descriptors=descriptors)

    @classmethod
    def read(
        cls: ClassOf[FilterMessageFormat[Any]],
    ) -> FilterMessageFormat[FilterMessageFormatResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[FilterMessageFormat[Any]]) -> FilterMessageFormat[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[FilterMessageFormat[Any]]) -> FilterMessageFormat[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[FilterMessageFormat[Any]]) -> FilterMessageFormat[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (FilterMessageFormatResponse,)
        return ()


class GetFilterBaseRate(Command[GetFilterBaseRateResponse]):
    """Get estimation filter data base rate (0x0C,0x0B).

    Gets the base rate, which is divided by the decimations of `FilterMessageFormat`.

    Also called `filter_get_base_rate`. Response: `GetFilterBaseRateResponse`. Devices without it
    may have `GetBaseRate`. Confirmed on 3DM-CV5-15, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-45,
    3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 9 more.

    - 3dm-gx5-15: 4.2.4 Get Estimation Filter Data Base Rate (0x0C, 0x0B)
    """

    __slots__ = ()

    SET = 0x0C
    DESCRIPTOR = 0x0B
    NAME = "3dm.get_filter_base_rate"
    RESPONSES = (GetFilterBaseRateResponse,)


class NmeaMessageFormat(Command[R]):
    """NMEA message format (0x0C,0x0C).

    Sets the NMEA sentences that the device streams.

    Functions: `write`, `read`, `save`, `load` and `default`. Response: `NmeaMessageFormatResponse`.
    Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 4 more.

    A sentence may be listed several times with different talkers or sources. A sentence is sent
    only while the device is not idle and the data of the source is valid. The 3DM-CV7-GNSS/INS
    rejects the format if a sentence would be sent more than 10 times per second, or, from a GNSS
    set, more than twice.

    - 3dm-cv7-gnss-ins: NMEA Message Format (0x0C,0x0C)
    """

    __slots__ = ("function", "format_entries")
    __match_args__ = ("function", "format_entries")

    SET = 0x0C
    DESCRIPTOR = 0x0C
    NAME = "3dm.nmea_message_format"
    RESPONSES = (NmeaMessageFormatResponse,)
    REQUIRED = {1: 2, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """Operation on the setting."""
    # On the wire only: count. Number of sentences. Counts the elements of `format_entries`.
    # Required for `write`.
    format_entries: tuple[types.NmeaMessage, ...] | None
    """Sentences to stream. Required for `write`."""

    def __init__(
        self, function: FunctionSelector, format_entries: Sequence[types.NmeaMessage] | None = None
    ) -> None:
        self.function = function
        self.format_entries = codec.several(format_entries)

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        self.format_entries = None
        required = self.REQUIRED.get(self.function, 0)
        done, end = 0, at
        try:
            codec.check_more(raw, at, required < 2)
            v = _B.read(raw, at)
            n_count = v[0]
            at += 1
            n = codec.counted(raw, at, n_count, 5, 50)
            self.format_entries, at = codec.read_structures(types.NmeaMessage, raw, at, n)
            done, end = 2, at
        except codec.Truncated:
            if done < required:
                raise
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self, self.REQUIRED.get(self.function, 0), (2, "format_entries")
        )
        if there >= 2:
            out += _B.write("count", codec.count("format_entries", self.format_entries, 50))
            out += codec.write_structures(
                "format_entries",
                codec.at_most("format_entries", self.format_entries, 50),
                types.NmeaMessage,
            )
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[NmeaMessageFormat[Any]], format_entries: Sequence[types.NmeaMessage]
    ) -> NmeaMessageFormat[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, format_entries=format_entries)

    @classmethod
    def read(cls: ClassOf[NmeaMessageFormat[Any]]) -> NmeaMessageFormat[NmeaMessageFormatResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[NmeaMessageFormat[Any]]) -> NmeaMessageFormat[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[NmeaMessageFormat[Any]]) -> NmeaMessageFormat[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[NmeaMessageFormat[Any]]) -> NmeaMessageFormat[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (NmeaMessageFormatResponse,)
        return ()


class PollData(Command[None]):
    """Poll data (0x0C,0x0D).

    Requests one data packet of the descriptor set with the listed fields, in the listed order.

    Not acknowledged if `suppress_ack` is true. Devices without it may have `PollImuData`,
    `PollGnssData` and `PollFilterData`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10
    more.

    An empty list polls the fields that `MessageFormat` stores; if nothing is stored, the device
    rejects the command. Descriptors that the device does not know are ignored. The data is sent in
    a separate packet after the reply, on the port of the command. List shared descriptors (0xD0 and
    up) before the others.

    - 3dm-cv7-gnss-ins: Poll Data (0x0C,0x0D)
    """

    __slots__ = ("descriptor_set", "suppress_ack", "descriptors")
    __match_args__ = ("descriptor_set", "suppress_ack", "descriptors")

    SET = 0x0C
    DESCRIPTOR = 0x0D
    NAME = "3dm.poll_data"

    descriptor_set: int
    """Data descriptor set. Range: 0x80 to 0xFE."""
    suppress_ack: bool
    """Send no acknowledge."""
    # On the wire only: num_descriptors. Number of fields. Counts the elements of `descriptors`.
    descriptors: tuple[int, ...]
    """Field descriptors. Refers to fields of `descriptor_set`."""

    def __init__(self, descriptor_set: int, suppress_ack: bool, descriptors: Sequence[int]) -> None:
        self.descriptor_set = descriptor_set
        self.suppress_ack = suppress_ack
        self.descriptors = codec.several(descriptors)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _3B.read(raw, at)
        self.descriptor_set = v[0]
        self.suppress_ack = codec.TRUTH[v[1]]
        n_num_descriptors = v[2]
        at += 3
        n = codec.counted(raw, at, n_num_descriptors, 1, 250)
        self.descriptors = codec.read_numbers("B", raw, at, n)
        at += n
        return at

    def _write(self) -> bytes:
        out = _3B.write(
            "descriptor_set suppress_ack num_descriptors",
            self.descriptor_set,
            self.suppress_ack,
            codec.count("descriptors", self.descriptors, 250),
        )
        out += codec.write_numbers(
            "descriptors", "B", codec.at_most("descriptors", self.descriptors, 250)
        )
        return codec.finished(out)

    @property
    def answered(self) -> bool:
        return not self.suppress_ack


class GetBaseRate(Command[GetBaseRateResponse]):
    """Get data base rate (0x0C,0x0E).

    Gets the base rate, which is divided by the decimations of a descriptor set.

    Response: `GetBaseRateResponse`. Devices without it may have `GetImuBaseRate`, `GetGnssBaseRate`
    and `GetFilterBaseRate`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS and
    3DM-GQ7-GNSS/INS; likely or assumed on 7 more.

    - 3dm-cv7-gnss-ins: Get Data Base Rate (0x0C,0x0E)
    """

    __slots__ = ("descriptor_set",)
    __match_args__ = ("descriptor_set",)

    SET = 0x0C
    DESCRIPTOR = 0x0E
    NAME = "3dm.get_base_rate"
    RESPONSES = (GetBaseRateResponse,)
    _SIZE = 1

    descriptor_set: int
    """Data descriptor set. Range: 0x80 to 0xFE."""

    def __init__(self, descriptor_set: int) -> None:
        self.descriptor_set = descriptor_set

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.descriptor_set = _B.unpack(raw, at)[0]
        return at + 1

    def _write(self) -> bytes:
        return _B.write("descriptor_set", self.descriptor_set)


class MessageFormat(Command[R]):
    """Message format (0x0C,0x0F).

    Sets the fields of the data packets of a descriptor set, their order and their decimations.

    Functions: `write`, `read`, `save`, `load` and `default`. Response: `MessageFormatResponse`.
    Devices without it may have `ImuMessageFormat`, `GnssMessageFormat` and `FilterMessageFormat`.
    Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10 more.

    The decimation is the base rate, as `GetBaseRate` reports it, divided by the desired rate. List
    shared descriptors (0xD0 and up) under the set whose packets will contain them, before the
    others.

    - 3dm-cv7-gnss-ins: Message Format (0x0C,0x0F)
    """

    __slots__ = ("function", "descriptor_set", "descriptors")
    __match_args__ = ("function", "descriptor_set", "descriptors")

    SET = 0x0C
    DESCRIPTOR = 0x0F
    NAME = "3dm.message_format"
    RESPONSES = (MessageFormatResponse,)
    REQUIRED = {1: 3, 2: 1, 3: 1, 4: 1, 5: 1}

    function: FunctionSelector
    """Operation on the setting."""
    descriptor_set: int | None
    """Data descriptor set; 0 means all of them (save, load, default)."""
    # On the wire only: num_descriptors. Number of fields. Counts the elements of `descriptors`.
    # Required for `write`.
    descriptors: tuple[types.DescriptorRate, ...] | None
    """Fields and decimations. Refers to fields of `descriptor_set`. Required for `write`."""

    def __init__(
        self,
        function: FunctionSelector,
        descriptor_set: int | None = None,
        descriptors: Sequence[types.DescriptorRate] | None = None,
    ) -> None:
        self.function = function
        self.descriptor_set = descriptor_set
        self.descriptors = codec.several(descriptors)

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        self.descriptor_set = self.descriptors = None
        required = self.REQUIRED.get(self.function, 0)
        done, end = 0, at
        try:
            codec.check_more(raw, at, required < 1)
            self.descriptor_set = _B.read(raw, at)[0]
            at += 1
            done, end = 1, at
            codec.check_more(raw, at, required < 3)
            v = _B.read(raw, at)
            n_num_descriptors = v[0]
            at += 1
            n = codec.counted(raw, at, n_num_descriptors, 3, 83)
            self.descriptors, at = codec.read_structures(types.DescriptorRate, raw, at, n)
            done, end = 3, at
        except codec.Truncated:
            if done < required:
                raise
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self, self.REQUIRED.get(self.function, 0), (1, "descriptor_set"), (3, "descriptors")
        )
        out += _B.write("descriptor_set", self.descriptor_set) if there >= 1 else b""
        if there >= 3:
            out += _B.write("num_descriptors", codec.count("descriptors", self.descriptors, 83))
            out += codec.write_structures(
                "descriptors",
                codec.at_most("descriptors", self.descriptors, 83),
                types.DescriptorRate,
            )
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[MessageFormat[Any]],
        descriptor_set: int,
        descriptors: Sequence[types.DescriptorRate],
    ) -> MessageFormat[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, descriptor_set=descriptor_set, descriptors=descriptors)

    @classmethod
    def read(
        cls: ClassOf[MessageFormat[Any]], descriptor_set: int
    ) -> MessageFormat[MessageFormatResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ, descriptor_set=descriptor_set)

    @classmethod
    def save(cls: ClassOf[MessageFormat[Any]], descriptor_set: int) -> MessageFormat[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE, descriptor_set=descriptor_set)

    @classmethod
    def load(cls: ClassOf[MessageFormat[Any]], descriptor_set: int) -> MessageFormat[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD, descriptor_set=descriptor_set)

    @classmethod
    def default(cls: ClassOf[MessageFormat[Any]], descriptor_set: int) -> MessageFormat[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT, descriptor_set=descriptor_set)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (MessageFormatResponse,)
        return ()


class FactoryStreaming(Command[None]):
    """Factory streaming (0x0C,0x10).

    Sets all message formats to those that technical support needs in a recording.

    Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10 more.

    - 3dm-cv7-gnss-ins: Factory Streaming (0x0C,0x10)
    """

    __slots__ = ("action", "reserved")
    __match_args__ = ("action", "reserved")

    SET = 0x0C
    DESCRIPTOR = 0x10
    NAME = "3dm.factory_streaming"
    _SIZE = 2

    action: FactoryStreamingAction
    """Treatment of the existing formats."""
    reserved: int
    """Reserved: send 0."""

    def __init__(self, action: FactoryStreamingAction, reserved: int = 0) -> None:
        self.action = action
        self.reserved = reserved

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2B.unpack(raw, at)
        self.action = codec.KNOWN[FactoryStreamingAction][v[0]]
        self.reserved = v[1]
        return at + 2

    def _write(self) -> bytes:
        return _2B.write("action reserved", self.action, self.reserved)


class DataStreamControl(Command[R]):
    """Data stream control (0x0C,0x11).

    Switches a data stream on or off.

    Also called `datastream_control`. Functions: `write`, `read`, `save`, `load` and `default`.
    Response: `DataStreamControlResponse`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS,
    3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or
    assumed on 25 more.

    Devices of the generations 3 to 5 identify the stream by a number (`LegacyDataStream`), other
    devices by its descriptor set. A newly enabled stream starts with current data, without any from
    before.

    - 3dm-gx5-15: 4.2.7 Enable/Disable Continuous Data Stream (0x0C, 0x11)
    - 3dm-cv7-gnss-ins: Data Stream Control (0x0C,0x11)
    """

    __slots__ = ("function", "descriptor_set", "enable")
    __match_args__ = ("function", "descriptor_set", "enable")

    SET = 0x0C
    DESCRIPTOR = 0x11
    NAME = "3dm.data_stream_control"
    RESPONSES = (DataStreamControlResponse,)
    REQUIRED = {1: 2, 2: 1, 3: 1, 4: 1, 5: 1}

    function: FunctionSelector
    """Operation on the setting."""
    descriptor_set: int | None
    """Data descriptor set; 0 means all streams (save, load, default).

    - On the 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-GX3-15,
      3DM-GX3-25, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX5-25 and 3DM-MV5-AR: values of `LegacyDataStream`;
      only `LegacyDataStream.ALL_STREAMS`, `LegacyDataStream.IMU` and `LegacyDataStream.FILTER`.
    - On the 3DM-CX5-45, 3DM-DH3, 3DM-GQ4-45, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-45, 3DM-GX4-IMU,
      3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and 3DM-RQ1-IMU: values of
      `LegacyDataStream`.
    - On the 3DM-GX5-15: values of `LegacyDataStream`; only `LegacyDataStream.IMU` and
      `LegacyDataStream.FILTER`.
    """
    enable: bool | None
    """True if the stream is sent. Default: true. Required for `write`. The stream starts with
    current data. What was measured while it was disabled is not sent.
    """

    def __init__(
        self,
        function: FunctionSelector,
        descriptor_set: int | None = None,
        enable: bool | None = None,
    ) -> None:
        self.function = function
        self.descriptor_set = descriptor_set
        self.enable = enable

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 1, 2))
        self.descriptor_set = _B.read(raw, at)[0] if there >= 1 else None
        self.enable = codec.TRUTH[_B.read(raw, at + 1)[0]] if there >= 2 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self, self.REQUIRED.get(self.function, 0), (1, "descriptor_set"), (2, "enable")
        )
        out += _B.write("descriptor_set", self.descriptor_set) if there >= 1 else b""
        out += _B.write("enable", self.enable) if there >= 2 else b""
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[DataStreamControl[Any]], descriptor_set: int, enable: bool
    ) -> DataStreamControl[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, descriptor_set=descriptor_set, enable=enable)

    @classmethod
    def read(
        cls: ClassOf[DataStreamControl[Any]], descriptor_set: int
    ) -> DataStreamControl[DataStreamControlResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ, descriptor_set=descriptor_set)

    @classmethod
    def save(cls: ClassOf[DataStreamControl[Any]], descriptor_set: int) -> DataStreamControl[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE, descriptor_set=descriptor_set)

    @classmethod
    def load(cls: ClassOf[DataStreamControl[Any]], descriptor_set: int) -> DataStreamControl[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD, descriptor_set=descriptor_set)

    @classmethod
    def default(
        cls: ClassOf[DataStreamControl[Any]], descriptor_set: int
    ) -> DataStreamControl[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT, descriptor_set=descriptor_set)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (DataStreamControlResponse,)
        return ()


class RawRtcm2_3Message(Command[None]):
    """Raw RTCM 2.3 message (0x0C,0x20).

    Sends RTCM 2.3 corrections to the GNSS receiver.

    Supported by 3DM-GQ4-45, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST. Requires a receiver.

    The receiver uses the RTCM messages 1, 2, 3 and 9. A message may be split at any byte and sent
    with several of these commands.

    - 3dm-gx5-45: 4.2.26 Raw RTCM 2.3 Message (0x0C, 0x20)
    - mip-sdk-2014: Raw RTCM 2.3 message (0x0C,0x20)
    - mscl: Raw RTCM 2.3 message (0x0C,0x20)
    """

    __slots__ = ("data",)
    __match_args__ = ("data",)

    SET = 0x0C
    DESCRIPTOR = 0x20
    NAME = "3dm.raw_rtcm_2_3_message"

    data: tuple[int, ...]
    """Bytes of the RTCM stream."""

    def __init__(self, data: Sequence[int]) -> None:
        self.data = codec.several(data)

    def _read(self: Any, raw: bytes, at: int) -> int:
        n = codec.remaining(raw, at, 1)
        self.data = codec.read_numbers("B", raw, at, n)
        at += n
        return at

    def _write(self) -> bytes:
        out = codec.write_numbers("data", "B", codec.at_most("data", self.data, 253))
        return codec.finished(out)


class ConstellationSettings(Command[R]):
    """Constellation settings (0x0C,0x21).

    Selects the constellations that the GNSS receiver tracks, and their shares of its tracking
    channels.

    Functions: `write`, `read`, `save`, `load` and `default`. Response:
    `ConstellationSettingsResponse`. Probably affects `gnss_data.FixInfo`, `gnss_data.SvInfo` and
    `gnss_data.SatelliteStatus`. Confirmed on 3DM-GQ4-45 and 3DM-GX5-35; likely or assumed on 2
    more. Requires a receiver. Uncertain: The factory default is doubtful: the SDK names only GPS
    and GLONASS as enabled, but has channels for SBAS and QZSS too.

    The device rejects entries that reserve more than 32 channels in total. The maximum of an entry
    must not be less than the number of channels it reserves. GLONASS and BeiDou cannot be used
    together. If the antenna or its filter is made for GPS only, leave GLONASS and BeiDou off. SBAS
    and QZSS improve the accuracy of GPS. SBAS does not make the device suitable for safety-of-life
    use. Factory default: GPS and GLONASS are enabled. Reserved and maximum channels: GPS 8 and 16,
    GLONASS 8 and 14, SBAS 1 and 3, QZSS 0 and 3.

    - mip-sdk-4: Constellation settings (0x0C,0x21)
    - 3dm-gx5-35: 4.2.8 GNSS Constellation Settings (0x0C, 0x21)
    """

    __slots__ = ("function", "max_channels", "settings")
    __match_args__ = ("function", "max_channels", "settings")

    SET = 0x0C
    DESCRIPTOR = 0x21
    NAME = "3dm.constellation_settings"
    RESPONSES = (ConstellationSettingsResponse,)
    REQUIRED = {1: 3, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """Operation on the setting."""
    max_channels: int | None
    """Maximum number of tracking channels in use; at most the number that the response reports as
    available. Unit: 1. Required for `write`.
    """
    # On the wire only: config_count. Number of entries. Counts the elements of `settings`. Range: 0
    # to 41. Required for `write`.
    settings: tuple[ConstellationSettingsEntry, ...] | None
    """One entry for each constellation. Required for `write`."""

    def __init__(
        self,
        function: FunctionSelector,
        max_channels: int | None = None,
        settings: Sequence[ConstellationSettingsEntry] | None = None,
    ) -> None:
        self.function = function
        self.max_channels = max_channels
        self.settings = codec.several(settings)

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        self.max_channels = self.settings = None
        required = self.REQUIRED.get(self.function, 0)
        done, end = 0, at
        try:
            codec.check_more(raw, at, required < 1)
            self.max_channels = _H.read(raw, at)[0]
            at += 2
            done, end = 1, at
            codec.check_more(raw, at, required < 3)
            v = _B.read(raw, at)
            n_config_count = v[0]
            at += 1
            n = codec.counted(raw, at, n_config_count, 6, 41)
            self.settings, at = codec.read_structures(ConstellationSettingsEntry, raw, at, n)
            done, end = 3, at
        except codec.Truncated:
            if done < required:
                raise
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self, self.REQUIRED.get(self.function, 0), (1, "max_channels"), (3, "settings")
        )
        out += _H.write("max_channels", self.max_channels) if there >= 1 else b""
        if there >= 3:
            out += _B.write("config_count", codec.count("settings", self.settings, 41))
            out += codec.write_structures(
                "settings", codec.at_most("settings", self.settings, 41), ConstellationSettingsEntry
            )
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[ConstellationSettings[Any]],
        max_channels: int,
        settings: Sequence[ConstellationSettingsEntry],
    ) -> ConstellationSettings[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, max_channels=max_channels, settings=settings)

    @classmethod
    def read(
        cls: ClassOf[ConstellationSettings[Any]],
    ) -> ConstellationSettings[ConstellationSettingsResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[ConstellationSettings[Any]]) -> ConstellationSettings[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[ConstellationSettings[Any]]) -> ConstellationSettings[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[ConstellationSettings[Any]]) -> ConstellationSettings[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (ConstellationSettingsResponse,)
        return ()


class GnssSbasSettings(Command[R]):
    """GNSS SBAS settings (0x0C,0x22).

    Sets how the GNSS receivers use satellite-based augmentation (SBAS).

    Functions: `write`, `read`, `save`, `load` and `default`. Response: `GnssSbasSettingsResponse`.
    Probably affects `gnss_data.SbasInfo` and `gnss_data.SbasCorrection`. Confirmed on
    3DM-CV7-GNSS/INS, 3DM-GQ4-45 and 3DM-GX5-35; likely or assumed on 3 more. Requires a receiver.

    - 3dm-cv7-gnss-ins: GNSS SBAS Settings (0x0C,0x22)
    """

    __slots__ = ("function", "enable_sbas", "sbas_options", "included_prns")
    __match_args__ = ("function", "enable_sbas", "sbas_options", "included_prns")

    SET = 0x0C
    DESCRIPTOR = 0x22
    NAME = "3dm.gnss_sbas_settings"
    RESPONSES = (GnssSbasSettingsResponse,)
    REQUIRED = {1: 4, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """Operation on the setting."""
    enable_sbas: int | None
    """1 enables SBAS, 0 disables it. Range: 0 to 1. Required for `write`.

    - On the 3DM-GX5-35: default 1.
    """
    sbas_options: SbasOptions | None
    """Purposes of SBAS. Required for `write`.

    - On the 3DM-GX5-35: default `SbasOptions.ENABLE_RANGING` and `SbasOptions.ENABLE_CORRECTIONS`.
    """
    # On the wire only: num_included_prns. Number of satellites listed; 0 searches for all. Counts
    # the elements of `included_prns`. Required for `write`.
    included_prns: tuple[int, ...] | None
    """PRN numbers of the SBAS satellites to search for. Required for `write`."""

    def __init__(
        self,
        function: FunctionSelector,
        enable_sbas: int | None = None,
        sbas_options: SbasOptions | None = None,
        included_prns: Sequence[int] | None = None,
    ) -> None:
        self.function = function
        self.enable_sbas = enable_sbas
        self.sbas_options = sbas_options
        self.included_prns = codec.several(included_prns)

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        self.enable_sbas = self.sbas_options = self.included_prns = None
        required = self.REQUIRED.get(self.function, 0)
        done, end = 0, at
        try:
            codec.check_more(raw, at, required < 1)
            self.enable_sbas = _B.read(raw, at)[0]
            at += 1
            done, end = 1, at
            codec.check_more(raw, at, required < 2)
            self.sbas_options = codec.KNOWN[SbasOptions][_H.read(raw, at)[0]]
            at += 2
            done, end = 2, at
            codec.check_more(raw, at, required < 4)
            v = _B.read(raw, at)
            n_num_included_prns = v[0]
            at += 1
            n = codec.counted(raw, at, n_num_included_prns, 2, 124)
            self.included_prns = codec.read_numbers("H", raw, at, n)
            at += n * 2
            done, end = 4, at
        except codec.Truncated:
            if done < required:
                raise
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self,
            self.REQUIRED.get(self.function, 0),
            (1, "enable_sbas"),
            (2, "sbas_options"),
            (4, "included_prns"),
        )
        out += _B.write("enable_sbas", self.enable_sbas) if there >= 1 else b""
        out += _H.write("sbas_options", self.sbas_options) if there >= 2 else b""
        if there >= 4:
            out += _B.write(
                "num_included_prns", codec.count("included_prns", self.included_prns, 124)
            )
            out += codec.write_numbers(
                "included_prns", "H", codec.at_most("included_prns", self.included_prns, 124)
            )
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[GnssSbasSettings[Any]],
        enable_sbas: int,
        sbas_options: SbasOptions,
        included_prns: Sequence[int],
    ) -> GnssSbasSettings[None]:
        """Apply the new setting."""
        return cls(
            FunctionSelector.WRITE,
            enable_sbas=enable_sbas,
            sbas_options=sbas_options,
            included_prns=included_prns,
        )

    @classmethod
    def read(cls: ClassOf[GnssSbasSettings[Any]]) -> GnssSbasSettings[GnssSbasSettingsResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[GnssSbasSettings[Any]]) -> GnssSbasSettings[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[GnssSbasSettings[Any]]) -> GnssSbasSettings[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[GnssSbasSettings[Any]]) -> GnssSbasSettings[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (GnssSbasSettingsResponse,)
        return ()


class GnssAssistedFix(Command[R]):
    """GNSS assisted fix (0x0C,0x23).

    Sets whether the GNSS receiver keeps the data of its last fix and starts from it at the next
    power-up.

    Functions: `write`, `read`, `save`, `load` and `default`. Response: `GnssAssistedFixResponse`.
    Confirmed on 3DM-GX5-35; likely or assumed on 2 more. Known only from the MicroStrain MIP SDK.
    Requires a receiver.

    The last fix is kept in the flash memory and the FRAM of the receiver. If you send the time with
    `GnssTimeAssistance` right after power-up, the first fix takes 1 s at best. A change from
    enabled to none erases the flash memory of the receiver, which is rated for 100 000 erasures. It
    slightly increases the power consumption.

    - mip-sdk-4: GNSS assisted fix (0x0C,0x23)
    """

    __slots__ = ("function", "option", "flags")
    __match_args__ = ("function", "option", "flags")

    SET = 0x0C
    DESCRIPTOR = 0x23
    NAME = "3dm.gnss_assisted_fix"
    RESPONSES = (GnssAssistedFixResponse,)
    REQUIRED = {1: 2, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """Operation on the setting."""
    option: AssistedFixOption | None
    """Storage of data for a faster first fix. Default: `AssistedFixOption.NONE`. Required for
    `write`.

    - On the 3DM-GX5-35: default `AssistedFixOption.NONE`.
    """
    flags: int | None
    """Reserved: send 255. Required for `write`.

    - On the 3DM-GX5-35: default 255.
    """

    def __init__(
        self,
        function: FunctionSelector,
        option: AssistedFixOption | None = None,
        flags: int | None = None,
    ) -> None:
        self.function = function
        self.option = option
        self.flags = flags

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 1, 2))
        self.option = codec.KNOWN[AssistedFixOption][_B.read(raw, at)[0]] if there >= 1 else None
        self.flags = _B.read(raw, at + 1)[0] if there >= 2 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self, self.REQUIRED.get(self.function, 0), (1, "option"), (2, "flags")
        )
        out += _B.write("option", self.option) if there >= 1 else b""
        out += _B.write("flags", self.flags) if there >= 2 else b""
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[GnssAssistedFix[Any]], option: AssistedFixOption
    ) -> GnssAssistedFix[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, option=option, flags=255)

    @classmethod
    def read(cls: ClassOf[GnssAssistedFix[Any]]) -> GnssAssistedFix[GnssAssistedFixResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[GnssAssistedFix[Any]]) -> GnssAssistedFix[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[GnssAssistedFix[Any]]) -> GnssAssistedFix[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[GnssAssistedFix[Any]]) -> GnssAssistedFix[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (GnssAssistedFixResponse,)
        return ()


class GnssTimeAssistance(Command[R]):
    """GNSS time assistance (0x0C,0x24).

    Sends the current GPS time to the GNSS receiver.

    Functions: `write` and `read`. Response: `GnssTimeAssistanceResponse`. Confirmed on 3DM-GX5-35;
    likely or assumed on 2 more. Known only from the MicroStrain MIP SDK. Requires a receiver.

    It is needed right after power-up if `GnssAssistedFix` was on at power-off.

    - mip-sdk-4: GNSS time assistance (0x0C,0x24)
    """

    __slots__ = ("function", "tow", "week_number", "accuracy")
    __match_args__ = ("function", "tow", "week_number", "accuracy")

    SET = 0x0C
    DESCRIPTOR = 0x24
    NAME = "3dm.gnss_time_assistance"
    RESPONSES = (GnssTimeAssistanceResponse,)
    REQUIRED = {1: 3, 2: 0}

    function: FunctionSelector
    """Operation on the setting."""
    tow: float | None
    """GPS time of week. Unit: s. Range: at least 0, less than 604800. Required for `write`."""
    week_number: int | None
    """GPS week number since 1980. Unit: week. Required for `write`."""
    accuracy: float | None
    """Estimated accuracy of the time that is sent. Unit: s. Range: at least 0. Required for
    `write`.
    """

    def __init__(
        self,
        function: FunctionSelector,
        tow: float | None = None,
        week_number: int | None = None,
        accuracy: float | None = None,
    ) -> None:
        self.function = function
        self.tow = tow
        self.week_number = week_number
        self.accuracy = accuracy

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(
            raw, at, self.REQUIRED.get(self.function, 0), (0, 8, 10, 14)
        )
        self.tow = _d.read(raw, at)[0] if there >= 1 else None
        self.week_number = _H.read(raw, at + 8)[0] if there >= 2 else None
        self.accuracy = _f.read(raw, at + 10)[0] if there >= 3 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self,
            self.REQUIRED.get(self.function, 0),
            (1, "tow"),
            (2, "week_number"),
            (3, "accuracy"),
        )
        out += _d.write("tow", self.tow) if there >= 1 else b""
        out += _H.write("week_number", self.week_number) if there >= 2 else b""
        out += _f.write("accuracy", self.accuracy) if there >= 3 else b""
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[GnssTimeAssistance[Any]], tow: float, week_number: int, accuracy: float
    ) -> GnssTimeAssistance[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, tow=tow, week_number=week_number, accuracy=accuracy)

    @classmethod
    def read(
        cls: ClassOf[GnssTimeAssistance[Any]],
    ) -> GnssTimeAssistance[GnssTimeAssistanceResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (GnssTimeAssistanceResponse,)
        return ()


class PpsSourceControl(Command[R]):
    """PPS source control (0x0C,0x28).

    Selects the source of the pulse per second (PPS).

    Also called `pps_source`. Functions: `write`, `read`, `save`, `load` and `default`. Response:
    `PpsSourceControlResponse`. Affects `system_data.TimeSyncStatus`. Probably affects
    `shared.GpsTimestamp`, `shared.ExternalTimestamp` and `sensor.GpsTimestamp`. Confirmed on
    3DM-CV7-GNSS/INS; likely or assumed on 10 more.

    The pins are configured separately, by `GpioConfig`. The filter needs a valid pulse; `disabled`
    and `generated` are rarely useful.

    - 3dm-cv7-gnss-ins: PPS Source Control (0x0C,0x28)
    """

    __slots__ = ("function", "source")
    __match_args__ = ("function", "source")

    SET = 0x0C
    DESCRIPTOR = 0x28
    NAME = "3dm.pps_source_control"
    RESPONSES = (PpsSourceControlResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """Operation on the setting."""
    source: PpsSource | None
    """Source of the pulse. Required for `write`.

    - On the 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-INS, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-CX7-INS,
      3DM-GV7-AHRS, 3DM-GV7-AR and 3DM-GV7-INS: only `PpsSource.DISABLED`, `PpsSource.GPIO` and
      `PpsSource.GENERATED`.
    - On the 3DM-CV7-GNSS/INS: default `PpsSource.RECEIVER_1`.
    - On the 3DM-GQ7-GNSS/INS: only `PpsSource.DISABLED`, `PpsSource.RECEIVER_1`,
      `PpsSource.RECEIVER_2`, `PpsSource.GPIO` and `PpsSource.GENERATED`.
    """

    def __init__(self, function: FunctionSelector, source: PpsSource | None = None) -> None:
        self.function = function
        self.source = source

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 1))
        self.source = codec.KNOWN[PpsSource][_B.read(raw, at)[0]] if there >= 1 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(self, self.REQUIRED.get(self.function, 0), (1, "source"))
        out += _B.write("source", self.source) if there >= 1 else b""
        return codec.finished(out)

    @classmethod
    def write(cls: ClassOf[PpsSourceControl[Any]], source: PpsSource) -> PpsSourceControl[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, source=source)

    @classmethod
    def read(cls: ClassOf[PpsSourceControl[Any]]) -> PpsSourceControl[PpsSourceControlResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[PpsSourceControl[Any]]) -> PpsSourceControl[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[PpsSourceControl[Any]]) -> PpsSourceControl[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[PpsSourceControl[Any]]) -> PpsSourceControl[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (PpsSourceControlResponse,)
        return ()


class GetEventSupport(Command[GetEventSupportResponse]):
    """Get supported events (0x0C,0x2A).

    Gets the types of event triggers or actions that the device supports, and the number of each.

    Response: `GetEventSupportResponse`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS;
    likely or assumed on 8 more.

    - 3dm-cv7-gnss-ins: Get Supported Events (0x0C,0x2A)
    """

    __slots__ = ("query",)
    __match_args__ = ("query",)

    SET = 0x0C
    DESCRIPTOR = 0x2A
    NAME = "3dm.get_event_support"
    RESPONSES = (GetEventSupportResponse,)
    _SIZE = 1

    query: EventSupportQuery
    """Triggers or actions."""

    def __init__(self, query: EventSupportQuery) -> None:
        self.query = query

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.query = codec.KNOWN[EventSupportQuery][_B.unpack(raw, at)[0]]
        return at + 1

    def _write(self) -> bytes:
        return _B.write("query", self.query)


class EventControl(Command[R]):
    """Event control (0x0C,0x2B).

    Enables, disables or tests an event trigger.

    Functions: `write`, `read`, `save`, `load` and `default`. Response: `EventControlResponse`.
    Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10 more.

    Triggers are disabled by default and after configuration. A trigger of type none cannot be
    enabled.

    - 3dm-cv7-gnss-ins: Event Control (0x0C,0x2B)
    """

    __slots__ = ("function", "instance", "mode")
    __match_args__ = ("function", "instance", "mode")

    SET = 0x0C
    DESCRIPTOR = 0x2B
    NAME = "3dm.event_control"
    RESPONSES = (EventControlResponse,)
    REQUIRED = {1: 2, 2: 1, 3: 1, 4: 1, 5: 1}

    function: FunctionSelector
    """Operation on the setting."""
    instance: int | None
    """Trigger instance; 0 means all configured triggers, except for read."""
    mode: types.EventTriggerMode | None
    """New mode. Default: `types.EventTriggerMode.DISABLED`. Required for `write`."""

    def __init__(
        self,
        function: FunctionSelector,
        instance: int | None = None,
        mode: types.EventTriggerMode | None = None,
    ) -> None:
        self.function = function
        self.instance = instance
        self.mode = mode

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 1, 2))
        self.instance = _B.read(raw, at)[0] if there >= 1 else None
        self.mode = (
            codec.KNOWN[types.EventTriggerMode][_B.read(raw, at + 1)[0]] if there >= 2 else None
        )
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self, self.REQUIRED.get(self.function, 0), (1, "instance"), (2, "mode")
        )
        out += _B.write("instance", self.instance) if there >= 1 else b""
        out += _B.write("mode", self.mode) if there >= 2 else b""
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[EventControl[Any]], instance: int, mode: types.EventTriggerMode
    ) -> EventControl[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, instance=instance, mode=mode)

    @classmethod
    def read(cls: ClassOf[EventControl[Any]], instance: int) -> EventControl[EventControlResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ, instance=instance)

    @classmethod
    def save(cls: ClassOf[EventControl[Any]], instance: int) -> EventControl[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE, instance=instance)

    @classmethod
    def load(cls: ClassOf[EventControl[Any]], instance: int) -> EventControl[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD, instance=instance)

    @classmethod
    def default(cls: ClassOf[EventControl[Any]], instance: int) -> EventControl[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT, instance=instance)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (EventControlResponse,)
        return ()


class GetEventTriggerStatus(Command[GetEventTriggerStatusResponse]):
    """Get event trigger status (0x0C,0x2C).

    Gets the type and the state of event triggers.

    Response: `GetEventTriggerStatusResponse`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on
    10 more.

    - 3dm-cv7-gnss-ins: Get Event Trigger Status (0x0C,0x2C)
    """

    __slots__ = ("requested_instances",)
    __match_args__ = ("requested_instances",)

    SET = 0x0C
    DESCRIPTOR = 0x2C
    NAME = "3dm.get_event_trigger_status"
    RESPONSES = (GetEventTriggerStatusResponse,)

    # On the wire only: requested_count. Number of requested triggers; 0 requests all instances.
    # Counts the elements of `requested_instances`.
    requested_instances: tuple[int, ...]
    """Numbers of the triggers to report; none for all."""

    def __init__(self, requested_instances: Sequence[int]) -> None:
        self.requested_instances = codec.several(requested_instances)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _B.read(raw, at)
        n_requested_count = v[0]
        at += 1
        n = codec.counted(raw, at, n_requested_count, 1, 252)
        self.requested_instances = codec.read_numbers("B", raw, at, n)
        at += n
        return at

    def _write(self) -> bytes:
        out = _B.write(
            "requested_count", codec.count("requested_instances", self.requested_instances, 252)
        )
        out += codec.write_numbers(
            "requested_instances",
            "B",
            codec.at_most("requested_instances", self.requested_instances, 252),
        )
        return codec.finished(out)


class GetEventActionStatus(Command[GetEventActionStatusResponse]):
    """Get event action status (0x0C,0x2D).

    Gets the type and the trigger of event actions.

    Response: `GetEventActionStatusResponse`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10
    more.

    - 3dm-cv7-gnss-ins: Get Event Action Status (0x0C,0x2D)
    """

    __slots__ = ("requested_instances",)
    __match_args__ = ("requested_instances",)

    SET = 0x0C
    DESCRIPTOR = 0x2D
    NAME = "3dm.get_event_action_status"
    RESPONSES = (GetEventActionStatusResponse,)

    # On the wire only: requested_count. Number of requested actions; 0 requests all instances.
    # Counts the elements of `requested_instances`.
    requested_instances: tuple[int, ...]
    """Numbers of the actions to report; none for all."""

    def __init__(self, requested_instances: Sequence[int]) -> None:
        self.requested_instances = codec.several(requested_instances)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _B.read(raw, at)
        n_requested_count = v[0]
        at += 1
        n = codec.counted(raw, at, n_requested_count, 1, 252)
        self.requested_instances = codec.read_numbers("B", raw, at, n)
        at += n
        return at

    def _write(self) -> bytes:
        out = _B.write(
            "requested_count", codec.count("requested_instances", self.requested_instances, 252)
        )
        out += codec.write_numbers(
            "requested_instances",
            "B",
            codec.at_most("requested_instances", self.requested_instances, 252),
        )
        return codec.finished(out)


class EventTriggerConfig(Command[R]):
    """Event trigger configuration (0x0C,0x2E).

    Configures the kind and the condition of an event trigger.

    Also called `event_trigger`. Functions: `write`, `read`, `save`, `load` and `default`. Response:
    `EventTriggerConfigResponse`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely
    or assumed on 8 more.

    The trigger is disabled afterwards; `EventControl` enables it. A GPIO trigger needs its pin
    configured by `GpioConfig`.

    - 3dm-cv7-gnss-ins: Event Trigger Configuration (0x0C,0x2E)
    """

    __slots__ = ("function", "instance", "type", "parameters")
    __match_args__ = ("function", "instance", "type", "parameters")

    SET = 0x0C
    DESCRIPTOR = 0x2E
    NAME = "3dm.event_trigger_config"
    RESPONSES = (EventTriggerConfigResponse,)
    REQUIRED = {1: 3, 2: 1, 3: 1, 4: 1, 5: 1}

    function: FunctionSelector
    """Operation on the setting."""
    instance: int | None
    """Trigger instance; 0 means all (save, load, default)."""
    type: types.EventTriggerType | None
    """Kind of trigger. Default: `types.EventTriggerType.NONE`. Required for `write`."""
    parameters: (
        types.EventTriggerGpio | types.EventTriggerThreshold | types.EventTriggerCombination | None
    )
    """The condition. Selected by `type`. Required for `write`.

    - If `type` is `types.EventTriggerType.NONE`: `None`.
    - If `type` is `types.EventTriggerType.GPIO`: `types.EventTriggerGpio`.
    - If `type` is `types.EventTriggerType.THRESHOLD`: `types.EventTriggerThreshold`.
    - If `type` is `types.EventTriggerType.COMBINATION`: `types.EventTriggerCombination`.
    """

    def __init__(
        self,
        function: FunctionSelector,
        instance: int | None = None,
        type: types.EventTriggerType | None = None,
        parameters: types.EventTriggerGpio
        | types.EventTriggerThreshold
        | types.EventTriggerCombination
        | None = None,
    ) -> None:
        self.function = function
        self.instance = instance
        self.type = type
        self.parameters = parameters

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        self.instance = self.type = self.parameters = None
        required = self.REQUIRED.get(self.function, 0)
        done, end = 0, at
        try:
            codec.check_more(raw, at, required < 1)
            self.instance = _B.read(raw, at)[0]
            at += 1
            done, end = 1, at
            codec.check_more(raw, at, required < 2)
            self.type = codec.KNOWN[types.EventTriggerType][_B.read(raw, at)[0]]
            at += 1
            done, end = 2, at
            codec.check_more(raw, at, required < 3)
            self.parameters = None
            if self.type == 1:
                self.parameters, at = types.EventTriggerGpio._decoded(raw, at)
            if self.type == 2:
                self.parameters, at = types.EventTriggerThreshold._decoded(raw, at)
            if self.type == 3:
                self.parameters, at = types.EventTriggerCombination._decoded(raw, at)
            done, end = 3, at
        except codec.Truncated:
            if done < required:
                raise
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self,
            self.REQUIRED.get(self.function, 0),
            (1, "instance"),
            (2, "type"),
            (3, "parameters?"),
        )
        out += _B.write("instance", self.instance) if there >= 1 else b""
        out += _B.write("type", self.type) if there >= 2 else b""
        if there >= 3:
            if self.type == 1:
                codec.check_selected(
                    "parameters", self.parameters, self.type, types.EventTriggerGpio
                )
                out += codec.structure("parameters", self.parameters, types.EventTriggerGpio)
            elif self.type == 2:
                codec.check_selected(
                    "parameters", self.parameters, self.type, types.EventTriggerThreshold
                )
                out += codec.structure("parameters", self.parameters, types.EventTriggerThreshold)
            elif self.type == 3:
                codec.check_selected(
                    "parameters", self.parameters, self.type, types.EventTriggerCombination
                )
                out += codec.structure("parameters", self.parameters, types.EventTriggerCombination)
            else:
                codec.check_unselected("parameters", self.parameters, self.type)
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[EventTriggerConfig[Any]],
        instance: int,
        type: types.EventTriggerType,
        parameters: types.EventTriggerGpio
        | types.EventTriggerThreshold
        | types.EventTriggerCombination
        | None,
    ) -> EventTriggerConfig[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, instance=instance, type=type, parameters=parameters)

    @classmethod
    def read(
        cls: ClassOf[EventTriggerConfig[Any]], instance: int
    ) -> EventTriggerConfig[EventTriggerConfigResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ, instance=instance)

    @classmethod
    def save(cls: ClassOf[EventTriggerConfig[Any]], instance: int) -> EventTriggerConfig[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE, instance=instance)

    @classmethod
    def load(cls: ClassOf[EventTriggerConfig[Any]], instance: int) -> EventTriggerConfig[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD, instance=instance)

    @classmethod
    def default(cls: ClassOf[EventTriggerConfig[Any]], instance: int) -> EventTriggerConfig[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT, instance=instance)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (EventTriggerConfigResponse,)
        return ()


class EventActionConfig(Command[R]):
    """Event action configuration (0x0C,0x2F).

    Configures the trigger and the effect of an event action.

    Also called `event_action`. Functions: `write`, `read`, `save`, `load` and `default`. Response:
    `EventActionConfigResponse`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely
    or assumed on 8 more.

    A packet holds one descriptor set; for several sets use several actions with the same trigger. A
    GPIO action needs its pin configured as an output with the gpio feature. In each event cycle,
    the device updates all triggers first and then runs each action at most once. The rate of the
    cycle is the base rate of the system data.

    - 3dm-cv7-gnss-ins: Event Action Configuration (0x0C,0x2F)
    - 3dm-cv7-gnss-ins: Event Cycle
    """

    __slots__ = ("function", "instance", "trigger", "type", "parameters")
    __match_args__ = ("function", "instance", "trigger", "type", "parameters")

    SET = 0x0C
    DESCRIPTOR = 0x2F
    NAME = "3dm.event_action_config"
    RESPONSES = (EventActionConfigResponse,)
    REQUIRED = {1: 4, 2: 1, 3: 1, 4: 1, 5: 1}

    function: FunctionSelector
    """Operation on the setting."""
    instance: int | None
    """Action instance; 0 means all (save, load, default)."""
    trigger: int | None
    """Trigger instance that the action follows. Required for `write`."""
    type: types.EventActionType | None
    """Kind of action. Default: `types.EventActionType.NONE`. Required for `write`."""
    parameters: types.EventActionGpio | types.EventActionMessage | None
    """Effect of the action. Selected by `type`. Required for `write`.

    - If `type` is `types.EventActionType.NONE`: `None`.
    - If `type` is `types.EventActionType.GPIO`: `types.EventActionGpio`.
    - If `type` is `types.EventActionType.MESSAGE`: `types.EventActionMessage`.
    """

    def __init__(
        self,
        function: FunctionSelector,
        instance: int | None = None,
        trigger: int | None = None,
        type: types.EventActionType | None = None,
        parameters: types.EventActionGpio | types.EventActionMessage | None = None,
    ) -> None:
        self.function = function
        self.instance = instance
        self.trigger = trigger
        self.type = type
        self.parameters = parameters

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        self.instance = self.trigger = self.type = self.parameters = None
        required = self.REQUIRED.get(self.function, 0)
        done, end = 0, at
        try:
            codec.check_more(raw, at, required < 1)
            self.instance = _B.read(raw, at)[0]
            at += 1
            done, end = 1, at
            codec.check_more(raw, at, required < 2)
            self.trigger = _B.read(raw, at)[0]
            at += 1
            done, end = 2, at
            codec.check_more(raw, at, required < 3)
            self.type = codec.KNOWN[types.EventActionType][_B.read(raw, at)[0]]
            at += 1
            done, end = 3, at
            codec.check_more(raw, at, required < 4)
            self.parameters = None
            if self.type == 1:
                self.parameters, at = types.EventActionGpio._decoded(raw, at)
            if self.type == 2:
                self.parameters, at = types.EventActionMessage._decoded(raw, at)
            done, end = 4, at
        except codec.Truncated:
            if done < required:
                raise
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self,
            self.REQUIRED.get(self.function, 0),
            (1, "instance"),
            (2, "trigger"),
            (3, "type"),
            (4, "parameters?"),
        )
        out += _B.write("instance", self.instance) if there >= 1 else b""
        out += _B.write("trigger", self.trigger) if there >= 2 else b""
        out += _B.write("type", self.type) if there >= 3 else b""
        if there >= 4:
            if self.type == 1:
                codec.check_selected(
                    "parameters", self.parameters, self.type, types.EventActionGpio
                )
                out += codec.structure("parameters", self.parameters, types.EventActionGpio)
            elif self.type == 2:
                codec.check_selected(
                    "parameters", self.parameters, self.type, types.EventActionMessage
                )
                out += codec.structure("parameters", self.parameters, types.EventActionMessage)
            else:
                codec.check_unselected("parameters", self.parameters, self.type)
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[EventActionConfig[Any]],
        instance: int,
        trigger: int,
        type: types.EventActionType,
        parameters: types.EventActionGpio | types.EventActionMessage | None,
    ) -> EventActionConfig[None]:
        """Apply the new setting."""
        return cls(
            FunctionSelector.WRITE,
            instance=instance,
            trigger=trigger,
            type=type,
            parameters=parameters,
        )

    @classmethod
    def read(
        cls: ClassOf[EventActionConfig[Any]], instance: int
    ) -> EventActionConfig[EventActionConfigResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ, instance=instance)

    @classmethod
    def save(cls: ClassOf[EventActionConfig[Any]], instance: int) -> EventActionConfig[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE, instance=instance)

    @classmethod
    def load(cls: ClassOf[EventActionConfig[Any]], instance: int) -> EventActionConfig[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD, instance=instance)

    @classmethod
    def default(cls: ClassOf[EventActionConfig[Any]], instance: int) -> EventActionConfig[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT, instance=instance)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (EventActionConfigResponse,)
        return ()


class DeviceSettings(Command[None]):
    """Device start up settings (0x0C,0x30).

    Saves, loads or resets all settings of the device at once.

    Functions: `save`, `load` and `default`. The device may take 2 s to reply. Confirmed on
    3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT and
    3DM-RQ1-45-ST; likely or assumed on 22 more.

    A save may disturb the data output for a short time. A save may take up to 1 s. Use a reply
    time-out of at least 2 s.

    - 3dm-gx5-15: 4.2.8 Device Startup Settings (0x0C, 0x30)
    - 3dm-cv7-gnss-ins: Device Start Up Settings (0x0C,0x30)
    """

    __slots__ = ("function",)
    __match_args__ = ("function",)

    SET = 0x0C
    DESCRIPTOR = 0x30
    NAME = "3dm.device_settings"
    REQUIRED = {3: 0, 4: 0, 5: 0}
    TIMEOUT = 2.0
    _SIZE = 1

    function: FunctionSelector
    """Operation on the setting."""

    def __init__(self, function: FunctionSelector) -> None:
        self.function = function

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.unpack(raw, at)[0]]
        return at + 1

    def _write(self) -> bytes:
        return _B.write("function", self.function)

    @classmethod
    def save(cls) -> DeviceSettings:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> DeviceSettings:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> DeviceSettings:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)


class SensorToVehicleTransformEuler(Command[R]):
    """Sensor-to-vehicle frame transformation Euler (0x0C,0x31).

    Sets the mounting of the sensor in the vehicle as Euler angles.

    Also called `sensor_2_vehicle_transform_euler`. Functions: `write`, `read`, `save`, `load` and
    `default`. Response: `SensorToVehicleTransformEulerResponse`. Affects `sensor.ScaledAccel`,
    `sensor.ScaledGyro`, `sensor.ScaledMag`, `sensor.DeltaTheta`, `sensor.DeltaVelocity`,
    `sensor.CompOrientationMatrix`, `sensor.CompQuaternion`, `sensor.CompEulerAngles`,
    `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm`, `filter_data.EulerAngles`,
    `filter_data.LinearAccel`, `filter_data.CompAngularRate` and `filter_data.GravityVector`.
    Probably affects `filter_data.CompAccel` and `sensor.CompOrientationUpdateMatrix`. Confirmed on
    3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed on 9 more.

    `SensorToVehicleTransformQuaternion` and `SensorToVehicleTransformDcm` set the same
    transformation; the value read back may be another form of it. Starting aligned with the vehicle
    frame, the sensor is rotated by yaw, pitch and roll about its own z, y and x axes, in this
    order. `v_vehicle = Rz(yaw) * Ry(pitch) * Rx(roll) * v_sensor` Every change resets the
    complementary filter, the estimation filter and all low-pass filters. On some older devices the
    setting is the inverse rotation.

    - 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Euler (0x0C,0x31)
    """

    __slots__ = ("function", "roll", "pitch", "yaw")
    __match_args__ = ("function", "roll", "pitch", "yaw")

    SET = 0x0C
    DESCRIPTOR = 0x31
    NAME = "3dm.sensor_to_vehicle_transform_euler"
    RESPONSES = (SensorToVehicleTransformEulerResponse,)
    REQUIRED = {1: 3, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """Operation on the setting."""
    roll: float | None
    """Roll angle of the sensor relative to the vehicle. Unit: rad. Frame: vehicle. Positive: right
    side down. Required for `write`.
    """
    pitch: float | None
    """Pitch angle of the sensor relative to the vehicle. Unit: rad. Frame: vehicle. Positive: nose
    up. Required for `write`.
    """
    yaw: float | None
    """Yaw angle of the sensor relative to the vehicle. Unit: rad. Frame: vehicle. Positive:
    clockwise seen from above. Required for `write`.
    """

    def __init__(
        self,
        function: FunctionSelector,
        roll: float | None = None,
        pitch: float | None = None,
        yaw: float | None = None,
    ) -> None:
        self.function = function
        self.roll = roll
        self.pitch = pitch
        self.yaw = yaw

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 4, 8, 12))
        self.roll = _f.read(raw, at)[0] if there >= 1 else None
        self.pitch = _f.read(raw, at + 4)[0] if there >= 2 else None
        self.yaw = _f.read(raw, at + 8)[0] if there >= 3 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self, self.REQUIRED.get(self.function, 0), (1, "roll"), (2, "pitch"), (3, "yaw")
        )
        out += _f.write("roll", self.roll) if there >= 1 else b""
        out += _f.write("pitch", self.pitch) if there >= 2 else b""
        out += _f.write("yaw", self.yaw) if there >= 3 else b""
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[SensorToVehicleTransformEuler[Any]], roll: float, pitch: float, yaw: float
    ) -> SensorToVehicleTransformEuler[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, roll=roll, pitch=pitch, yaw=yaw)

    @classmethod
    def read(
        cls: ClassOf[SensorToVehicleTransformEuler[Any]],
    ) -> SensorToVehicleTransformEuler[SensorToVehicleTransformEulerResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(
        cls: ClassOf[SensorToVehicleTransformEuler[Any]],
    ) -> SensorToVehicleTransformEuler[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(
        cls: ClassOf[SensorToVehicleTransformEuler[Any]],
    ) -> SensorToVehicleTransformEuler[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(
        cls: ClassOf[SensorToVehicleTransformEuler[Any]],
    ) -> SensorToVehicleTransformEuler[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (SensorToVehicleTransformEulerResponse,)
        return ()


class SensorToVehicleTransformQuaternion(Command[R]):
    """Sensor-to-vehicle frame transformation quaternion (0x0C,0x32).

    Sets the mounting of the sensor in the vehicle as a quaternion.

    Also called `sensor_2_vehicle_transform_quaternion`. Functions: `write`, `read`, `save`, `load`
    and `default`. Response: `SensorToVehicleTransformQuaternionResponse`. Affects
    `sensor.ScaledAccel`, `sensor.ScaledGyro`, `sensor.ScaledMag`, `sensor.DeltaTheta`,
    `sensor.DeltaVelocity`, `sensor.CompOrientationMatrix`, `sensor.CompQuaternion`,
    `sensor.CompEulerAngles`, `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm`,
    `filter_data.EulerAngles`, `filter_data.LinearAccel`, `filter_data.CompAngularRate` and
    `filter_data.GravityVector`. Probably affects `filter_data.CompAccel` and
    `sensor.CompOrientationUpdateMatrix`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10
    more.

    `SensorToVehicleTransformEuler` and `SensorToVehicleTransformDcm` set the same transformation;
    the value read back may be another form of it. `p_vehicle = q^-1 * p_sensor * q`, where the
    vectors are quaternions with the scalar part 0. This is the inverse of the quaternion that
    `filter.SensorToVehicleRotationQuaternion` accepts. Every change resets the complementary
    filter, the estimation filter and all low-pass filters.

    - 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Quaternion (0x0C,0x32)
    """

    __slots__ = ("function", "q")
    __match_args__ = ("function", "q")

    SET = 0x0C
    DESCRIPTOR = 0x32
    NAME = "3dm.sensor_to_vehicle_transform_quaternion"
    RESPONSES = (SensorToVehicleTransformQuaternionResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0}
    _VECTORS = {"q": (types.Quatf,)}

    function: FunctionSelector
    """Operation on the setting."""
    q: types.Quatf | None
    """Rotates vectors of the vehicle frame into the sensor frame; unit quaternion, w first.
    Elements: w, x, y, z. Unit: 1. Required for `write`.
    """

    def __init__(
        self, function: FunctionSelector, q: types.Quatf | codec.Numbers | None = None
    ) -> None:
        self.function = function
        self.q = codec.vector(q, types.Quatf)

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 16))
        self._q = _4f.read(raw, at) if there >= 1 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(self, self.REQUIRED.get(self.function, 0), (1, "q"))
        out += _4f.write("q*4", *codec.elements("q", self.q, 4)) if there >= 1 else b""
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[SensorToVehicleTransformQuaternion[Any]], q: types.Quatf | codec.Numbers
    ) -> SensorToVehicleTransformQuaternion[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, q=q)

    @classmethod
    def read(
        cls: ClassOf[SensorToVehicleTransformQuaternion[Any]],
    ) -> SensorToVehicleTransformQuaternion[SensorToVehicleTransformQuaternionResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(
        cls: ClassOf[SensorToVehicleTransformQuaternion[Any]],
    ) -> SensorToVehicleTransformQuaternion[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(
        cls: ClassOf[SensorToVehicleTransformQuaternion[Any]],
    ) -> SensorToVehicleTransformQuaternion[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(
        cls: ClassOf[SensorToVehicleTransformQuaternion[Any]],
    ) -> SensorToVehicleTransformQuaternion[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (SensorToVehicleTransformQuaternionResponse,)
        return ()


class SensorToVehicleTransformDcm(Command[R]):
    """Sensor-to-vehicle frame transformation direction cosine matrix (0x0C,0x33).

    Sets the mounting of the sensor in the vehicle as a direction cosine matrix.

    Also called `sensor_2_vehicle_transform_dcm`. Functions: `write`, `read`, `save`, `load` and
    `default`. Response: `SensorToVehicleTransformDcmResponse`. Affects `sensor.ScaledAccel`,
    `sensor.ScaledGyro`, `sensor.ScaledMag`, `sensor.DeltaTheta`, `sensor.DeltaVelocity`,
    `sensor.CompOrientationMatrix`, `sensor.CompQuaternion`, `sensor.CompEulerAngles`,
    `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm`, `filter_data.EulerAngles`,
    `filter_data.LinearAccel`, `filter_data.CompAngularRate` and `filter_data.GravityVector`.
    Probably affects `filter_data.CompAccel` and `sensor.CompOrientationUpdateMatrix`. Confirmed on
    3DM-CV7-GNSS/INS; likely or assumed on 10 more.

    `SensorToVehicleTransformEuler` and `SensorToVehicleTransformQuaternion` set the same
    transformation; the value read back may be another form of it. `v_vehicle = dcm * v_sensor`.
    This is the inverse of the matrix that `filter.SensorToVehicleRotationDcm` accepts. Every change
    resets the complementary filter, the estimation filter and all low-pass filters.

    - 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Direction Cosine Matrix (0x0C,0x33)
    """

    __slots__ = ("function", "dcm")
    __match_args__ = ("function", "dcm")

    SET = 0x0C
    DESCRIPTOR = 0x33
    NAME = "3dm.sensor_to_vehicle_transform_dcm"
    RESPONSES = (SensorToVehicleTransformDcmResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0}
    _VECTORS = {"dcm": (types.Matrix3f,)}

    function: FunctionSelector
    """Operation on the setting."""
    dcm: types.Matrix3f | None
    """Rotates vectors of the sensor frame into the vehicle frame; row-major. Elements: m11, m12,
    m13, m21, m22, m23, m31, m32, m33. Unit: 1. Required for `write`.
    """

    def __init__(
        self, function: FunctionSelector, dcm: types.Matrix3f | codec.Rows | None = None
    ) -> None:
        self.function = function
        self.dcm = codec.vector(dcm, types.Matrix3f)

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 36))
        self._dcm = _9f.read(raw, at) if there >= 1 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(self, self.REQUIRED.get(self.function, 0), (1, "dcm"))
        out += _9f.write("dcm*9", *codec.elements("dcm", self.dcm, 9)) if there >= 1 else b""
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[SensorToVehicleTransformDcm[Any]], dcm: types.Matrix3f | codec.Rows
    ) -> SensorToVehicleTransformDcm[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, dcm=dcm)

    @classmethod
    def read(
        cls: ClassOf[SensorToVehicleTransformDcm[Any]],
    ) -> SensorToVehicleTransformDcm[SensorToVehicleTransformDcmResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[SensorToVehicleTransformDcm[Any]]) -> SensorToVehicleTransformDcm[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[SensorToVehicleTransformDcm[Any]]) -> SensorToVehicleTransformDcm[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(
        cls: ClassOf[SensorToVehicleTransformDcm[Any]],
    ) -> SensorToVehicleTransformDcm[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (SensorToVehicleTransformDcmResponse,)
        return ()


class GpsDynamicsMode(Command[R]):
    """GPS dynamics mode (0x0C,0x34).

    Sets the dynamics that the GNSS receiver assumes of the vehicle.

    No device is known for certain to support it. Functions: `write`, `read`, `save`, `load` and
    `default`. Response: `GpsDynamicsModeResponse`. Probably affects `gnss_data.LlhPosition` and
    `gnss_data.NedVelocity`. Known only from the MIP SDK of 2014 and MicroStrain Communication
    Library. Requires a receiver. Uncertain: No source lists the devices that support it; the SDK of
    2014 uses it in its example for the 3DM-GX3-35 only.

    - mip-sdk-2014: GPS dynamics mode (0x0C,0x34)
    - mscl: GPS dynamics mode (0x0C,0x34)
    """

    __slots__ = ("function", "mode")
    __match_args__ = ("function", "mode")

    SET = 0x0C
    DESCRIPTOR = 0x34
    NAME = "3dm.gps_dynamics_mode"
    RESPONSES = (GpsDynamicsModeResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """Operation on the setting."""
    mode: ReceiverDynamics | None
    """Assumed dynamics. Required for `write`."""

    def __init__(self, function: FunctionSelector, mode: ReceiverDynamics | None = None) -> None:
        self.function = function
        self.mode = mode

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 1))
        self.mode = codec.KNOWN[ReceiverDynamics][_B.read(raw, at)[0]] if there >= 1 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(self, self.REQUIRED.get(self.function, 0), (1, "mode"))
        out += _B.write("mode", self.mode) if there >= 1 else b""
        return codec.finished(out)

    @classmethod
    def write(cls: ClassOf[GpsDynamicsMode[Any]], mode: ReceiverDynamics) -> GpsDynamicsMode[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, mode=mode)

    @classmethod
    def read(cls: ClassOf[GpsDynamicsMode[Any]]) -> GpsDynamicsMode[GpsDynamicsModeResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[GpsDynamicsMode[Any]]) -> GpsDynamicsMode[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[GpsDynamicsMode[Any]]) -> GpsDynamicsMode[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[GpsDynamicsMode[Any]]) -> GpsDynamicsMode[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (GpsDynamicsModeResponse,)
        return ()


class ImuSignalConditioning(Command[R]):
    """IMU signal conditioning (0x0C,0x35).

    Configures the filters and the orientation algorithm of 3-series devices.

    No device is known for certain to support it. Functions: `write`, `read`, `save`, `load` and
    `default`. Response: `ImuSignalConditioningResponse`. Affects `sensor.ScaledAccel`,
    `sensor.ScaledGyro`, `sensor.DeltaTheta`, `sensor.DeltaVelocity`,
    `sensor.CompOrientationMatrix`, `sensor.CompQuaternion` and `sensor.CompEulerAngles`. Probably
    affects `sensor.ScaledMag`. Known only from the MIP SDK of 2014 and MicroStrain Communication
    Library. Uncertain: The ranges, the defaults and some of the flags are those of the single-byte
    protocol of the 3DM-GX3, which has the same record. Uncertain: No source lists the devices that
    support it; the SDK of 2014 uses it in its example for the 3DM-GX3-35 only. Uncertain: MSCL
    reads the response without `reserved`, so some devices may not send it.

    The filters are moving averages; the first zero of their response is at 1000 Hz divided by the
    width.

    - mip-sdk-2014: IMU signal conditioning (0x0C,0x35)
    - mscl: IMU signal conditioning (0x0C,0x35)
    """

    __slots__ = (
        "function",
        "orientation_decimation",
        "data_conditioning_flags",
        "inertial_filter_width",
        "mag_filter_width",
        "up_compensation",
        "north_compensation",
        "mag_bandwidth",
        "reserved",
    )
    __match_args__ = (
        "function",
        "orientation_decimation",
        "data_conditioning_flags",
        "inertial_filter_width",
        "mag_filter_width",
        "up_compensation",
        "north_compensation",
        "mag_bandwidth",
        "reserved",
    )

    SET = 0x0C
    DESCRIPTOR = 0x35
    NAME = "3dm.imu_signal_conditioning"
    RESPONSES = (ImuSignalConditioningResponse,)
    REQUIRED = {1: 8, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """Operation on the setting."""
    orientation_decimation: int | None
    """Divisor of 1000 Hz that sets the rate at which the orientation is computed. Unit: 1. Range: 1
    to 1000. Required for `write`.
    """
    data_conditioning_flags: DataConditioningFlags | None
    """Processing steps. Default: 3. Required for `write`."""
    inertial_filter_width: int | None
    """Width of the accelerometer and gyroscope filter in samples. Unit: 1. Range: 1 to 32. Default:
    15. Required for `write`.
    """
    mag_filter_width: int | None
    """Width of the magnetometer filter in samples. Unit: 1. Range: 1 to 32. Default: 17. Required
    for `write`.
    """
    up_compensation: int | None
    """Time constant of the pitch and roll correction. Unit: s. Range: 1 to 1000. Default: 10.
    Required for `write`.
    """
    north_compensation: int | None
    """Time constant of the heading correction. Unit: s. Range: 1 to 1000. Default: 10. Required for
    `write`.
    """
    mag_bandwidth: MagBandwidth | None
    """Bandwidth of the magnetometer of 3-series devices. Required for `write`."""
    reserved: int | None
    """Reserved: send 0. Required for `write`."""

    def __init__(
        self,
        function: FunctionSelector,
        orientation_decimation: int | None = None,
        data_conditioning_flags: DataConditioningFlags | None = None,
        inertial_filter_width: int | None = None,
        mag_filter_width: int | None = None,
        up_compensation: int | None = None,
        north_compensation: int | None = None,
        mag_bandwidth: MagBandwidth | None = None,
        reserved: int | None = None,
    ) -> None:
        self.function = function
        self.orientation_decimation = orientation_decimation
        self.data_conditioning_flags = data_conditioning_flags
        self.inertial_filter_width = inertial_filter_width
        self.mag_filter_width = mag_filter_width
        self.up_compensation = up_compensation
        self.north_compensation = north_compensation
        self.mag_bandwidth = mag_bandwidth
        self.reserved = reserved

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(
            raw, at, self.REQUIRED.get(self.function, 0), (0, 2, 4, 5, 6, 8, 10, 11, 13)
        )
        self.orientation_decimation = _H.read(raw, at)[0] if there >= 1 else None
        self.data_conditioning_flags = (
            codec.KNOWN[DataConditioningFlags][_H.read(raw, at + 2)[0]] if there >= 2 else None
        )
        self.inertial_filter_width = _B.read(raw, at + 4)[0] if there >= 3 else None
        self.mag_filter_width = _B.read(raw, at + 5)[0] if there >= 4 else None
        self.up_compensation = _H.read(raw, at + 6)[0] if there >= 5 else None
        self.north_compensation = _H.read(raw, at + 8)[0] if there >= 6 else None
        self.mag_bandwidth = (
            codec.KNOWN[MagBandwidth][_B.read(raw, at + 10)[0]] if there >= 7 else None
        )
        self.reserved = _H.read(raw, at + 11)[0] if there >= 8 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self,
            self.REQUIRED.get(self.function, 0),
            (1, "orientation_decimation"),
            (2, "data_conditioning_flags"),
            (3, "inertial_filter_width"),
            (4, "mag_filter_width"),
            (5, "up_compensation"),
            (6, "north_compensation"),
            (7, "mag_bandwidth"),
            (8, "reserved"),
        )
        if there >= 1:
            out += _H.write("orientation_decimation", self.orientation_decimation)
        if there >= 2:
            out += _H.write("data_conditioning_flags", self.data_conditioning_flags)
        out += _B.write("inertial_filter_width", self.inertial_filter_width) if there >= 3 else b""
        out += _B.write("mag_filter_width", self.mag_filter_width) if there >= 4 else b""
        out += _H.write("up_compensation", self.up_compensation) if there >= 5 else b""
        out += _H.write("north_compensation", self.north_compensation) if there >= 6 else b""
        out += _B.write("mag_bandwidth", self.mag_bandwidth) if there >= 7 else b""
        out += _H.write("reserved", self.reserved) if there >= 8 else b""
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[ImuSignalConditioning[Any]],
        orientation_decimation: int,
        data_conditioning_flags: DataConditioningFlags,
        inertial_filter_width: int,
        mag_filter_width: int,
        up_compensation: int,
        north_compensation: int,
        mag_bandwidth: MagBandwidth,
    ) -> ImuSignalConditioning[None]:
        """Apply the new setting."""
        return cls(
            FunctionSelector.WRITE,
            orientation_decimation=orientation_decimation,
            data_conditioning_flags=data_conditioning_flags,
            inertial_filter_width=inertial_filter_width,
            mag_filter_width=mag_filter_width,
            up_compensation=up_compensation,
            north_compensation=north_compensation,
            mag_bandwidth=mag_bandwidth,
            reserved=0,
        )

    @classmethod
    def read(
        cls: ClassOf[ImuSignalConditioning[Any]],
    ) -> ImuSignalConditioning[ImuSignalConditioningResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[ImuSignalConditioning[Any]]) -> ImuSignalConditioning[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[ImuSignalConditioning[Any]]) -> ImuSignalConditioning[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[ImuSignalConditioning[Any]]) -> ImuSignalConditioning[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (ImuSignalConditioningResponse,)
        return ()


class ImuTimestamp(Command[R]):
    """IMU timestamp (0x0C,0x36).

    Sets or reads a time counter of the sensor data.

    No device is known for certain to support it. Functions: `write` and `read`. Response:
    `ImuTimestampResponse`. Known only from the MIP SDK of 2014. Uncertain: No source lists the
    devices that support it; the SDK of 2014 uses it in its example for the 3DM-GX3-35 only.
    Uncertain: A read is assumed to omit `time`, which the device would ignore.

    - mip-sdk-2014: IMU timestamp (0x0C,0x36)
    """

    __slots__ = ("function", "selector", "time")
    __match_args__ = ("function", "selector", "time")

    SET = 0x0C
    DESCRIPTOR = 0x36
    NAME = "3dm.imu_timestamp"
    RESPONSES = (ImuTimestampResponse,)
    REQUIRED = {1: 2, 2: 1}

    function: FunctionSelector
    """Operation on the setting."""
    selector: ImuTimestampSelector | None
    """Counter to set or read."""
    time: int | None
    """Value of the counter, in the unit that `selector` selects. Required for `write`."""

    def __init__(
        self,
        function: FunctionSelector,
        selector: ImuTimestampSelector | None = None,
        time: int | None = None,
    ) -> None:
        self.function = function
        self.selector = selector
        self.time = time

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 1, 5))
        self.selector = (
            codec.KNOWN[ImuTimestampSelector][_B.read(raw, at)[0]] if there >= 1 else None
        )
        self.time = _I.read(raw, at + 1)[0] if there >= 2 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self, self.REQUIRED.get(self.function, 0), (1, "selector"), (2, "time")
        )
        out += _B.write("selector", self.selector) if there >= 1 else b""
        out += _I.write("time", self.time) if there >= 2 else b""
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[ImuTimestamp[Any]], selector: ImuTimestampSelector, time: int
    ) -> ImuTimestamp[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, selector=selector, time=time)

    @classmethod
    def read(
        cls: ClassOf[ImuTimestamp[Any]], selector: ImuTimestampSelector
    ) -> ImuTimestamp[ImuTimestampResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ, selector=selector)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (ImuTimestampResponse,)
        return ()


class AccelBias(Command[R]):
    """Accelerometer bias configuration (0x0C,0x37).

    Sets the bias that is subtracted from the scaled acceleration.

    For advanced use. Functions: `write`, `read`, `save`, `load`, `default` and `apply`. Response:
    `AccelBiasResponse`. Affects `sensor.ScaledAccel`. Probably affects `sensor.DeltaVelocity` and
    `filter_data.AccelBias`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35,
    3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 24 more. On the 3DM-CV7-GNSS/INS: `write`,
    `read`, `save`, `load` and `default` only.

    - 3dm-gx5-15: 4.2.9 Accel Bias (0x0C, 0x37)
    - 3dm-cv7-gnss-ins: Accelerometer Bias Configuration (0x0C,0x37)
    """

    __slots__ = ("function", "bias")
    __match_args__ = ("function", "bias")

    SET = 0x0C
    DESCRIPTOR = 0x37
    NAME = "3dm.accel_bias"
    RESPONSES = (AccelBiasResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0, 6: 1}
    _VECTORS = {"bias": (types.Vector3f,)}

    function: FunctionSelector
    """Operation on the setting."""
    bias: types.Vector3f | None
    """Bias that the device subtracts from the measured acceleration. Elements: x, y, z. Unit: g.
    Frame: sensor. Required for `write` and `apply`.
    """

    def __init__(
        self, function: FunctionSelector, bias: types.Vector3f | codec.Numbers | None = None
    ) -> None:
        self.function = function
        self.bias = codec.vector(bias, types.Vector3f)

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 12))
        self._bias = _3f.read(raw, at) if there >= 1 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(self, self.REQUIRED.get(self.function, 0), (1, "bias"))
        out += _3f.write("bias*3", *codec.elements("bias", self.bias, 3)) if there >= 1 else b""
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[AccelBias[Any]], bias: types.Vector3f | codec.Numbers
    ) -> AccelBias[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, bias=bias)

    @classmethod
    def read(cls: ClassOf[AccelBias[Any]]) -> AccelBias[AccelBiasResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[AccelBias[Any]]) -> AccelBias[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[AccelBias[Any]]) -> AccelBias[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[AccelBias[Any]]) -> AccelBias[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @classmethod
    def apply(
        cls: ClassOf[AccelBias[Any]], bias: types.Vector3f | codec.Numbers
    ) -> AccelBias[None]:
        """Apply the new setting without sending an ACK (5-series devices)."""
        return cls(FunctionSelector.APPLY, bias=bias)

    @property
    def answered(self) -> bool:
        return self.function != FunctionSelector.APPLY

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (AccelBiasResponse,)
        return ()


class GyroBias(Command[R]):
    """Gyroscope bias configuration (0x0C,0x38).

    Sets the bias that is subtracted from the scaled angular rate.

    For advanced use. Functions: `write`, `read`, `save`, `load`, `default` and `apply`. Response:
    `GyroBiasResponse`. Affects `sensor.ScaledGyro`. Probably affects `sensor.DeltaTheta`,
    `filter_data.GyroBias` and `filter_data.Status`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR,
    3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on
    23 more. On the 3DM-CV7-AHRS: `write`, `read`, `save`, `load` and `default` only. On the
    3DM-CV7-AR: `write`, `read`, `save`, `load` and `default` only. On the 3DM-CV7-GNSS/INS:
    `write`, `read`, `save`, `load` and `default` only.

    - 3dm-gx5-15: 4.2.10 Gyro Bias (0x0C, 0x38)
    - 3dm-cv7-gnss-ins: Gyroscope Bias Configuration (0x0C,0x38)
    """

    __slots__ = ("function", "bias")
    __match_args__ = ("function", "bias")

    SET = 0x0C
    DESCRIPTOR = 0x38
    NAME = "3dm.gyro_bias"
    RESPONSES = (GyroBiasResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0, 6: 1}
    _VECTORS = {"bias": (types.Vector3f,)}

    function: FunctionSelector
    """Operation on the setting."""
    bias: types.Vector3f | None
    """Bias that the device subtracts from the measured angular rate. Elements: x, y, z. Unit:
    rad/s. Frame: sensor. Required for `write` and `apply`.
    """

    def __init__(
        self, function: FunctionSelector, bias: types.Vector3f | codec.Numbers | None = None
    ) -> None:
        self.function = function
        self.bias = codec.vector(bias, types.Vector3f)

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 12))
        self._bias = _3f.read(raw, at) if there >= 1 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(self, self.REQUIRED.get(self.function, 0), (1, "bias"))
        out += _3f.write("bias*3", *codec.elements("bias", self.bias, 3)) if there >= 1 else b""
        return codec.finished(out)

    @classmethod
    def write(cls: ClassOf[GyroBias[Any]], bias: types.Vector3f | codec.Numbers) -> GyroBias[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, bias=bias)

    @classmethod
    def read(cls: ClassOf[GyroBias[Any]]) -> GyroBias[GyroBiasResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[GyroBias[Any]]) -> GyroBias[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[GyroBias[Any]]) -> GyroBias[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[GyroBias[Any]]) -> GyroBias[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @classmethod
    def apply(cls: ClassOf[GyroBias[Any]], bias: types.Vector3f | codec.Numbers) -> GyroBias[None]:
        """Apply the new setting without sending an ACK (5-series devices)."""
        return cls(FunctionSelector.APPLY, bias=bias)

    @property
    def answered(self) -> bool:
        return self.function != FunctionSelector.APPLY

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (GyroBiasResponse,)
        return ()


class CaptureGyroBias(Command[GyroBiasResponse]):
    """Capture gyroscope bias (0x0C,0x39).

    Averages the angular rate of the device at rest and uses the result as the gyroscope bias.

    Response: `GyroBiasResponse`. Affects `sensor.ScaledGyro`. Probably affects `sensor.DeltaTheta`,
    `filter_data.GyroBias` and `filter_data.Status`. The device may take 31 s to reply. Confirmed on
    3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GQ7-GNSS/INS, 3DM-GX5-15,
    3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 21 more.

    The device must be at rest, with as little vibration as possible, for the whole time. The reply
    arrives after the averaging time. The bias is not saved; to save it, send `GyroBias` with save.
    The 3DM-GX5-15 also initializes its orientation from the samples.

    - 3dm-gx5-15: 4.2.11 Capture Gyro Bias (0x0C, 0x39)
    - 3dm-cv7-gnss-ins: Capture Gyroscope Bias (0x0C,0x39)
    """

    __slots__ = ("averaging_time_ms",)
    __match_args__ = ("averaging_time_ms",)

    SET = 0x0C
    DESCRIPTOR = 0x39
    NAME = "3dm.capture_gyro_bias"
    RESPONSES = (GyroBiasResponse,)
    TIMEOUT = 31.0
    _SIZE = 2

    averaging_time_ms: int
    """Time to average over. Unit: ms. Range: 1000 to 30000."""

    def __init__(self, averaging_time_ms: int) -> None:
        self.averaging_time_ms = averaging_time_ms

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.averaging_time_ms = _H.unpack(raw, at)[0]
        return at + 2

    def _write(self) -> bytes:
        return _H.write("averaging_time_ms", self.averaging_time_ms)


class MagHardIronOffset(Command[R]):
    """Magnetometer hard iron offset (0x0C,0x3A).

    Sets the offset that corrects the scaled magnetic field for hard iron.

    Functions: `write`, `read`, `save`, `load`, `default` and `apply`. Response:
    `MagHardIronOffsetResponse`. Affects `sensor.ScaledMag`. Confirmed on 3DM-CV7-AHRS,
    3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on
    14 more. On the 3DM-CV7-AHRS: `write`, `read`, `save`, `load` and `default` only. On the
    3DM-CV7-GNSS/INS: `write`, `read`, `save`, `load` and `default` only. Requires a magnetometer.
    Uncertain: The sources do not state the formula; it is inferred from the terms.

    The values come from a calibration of the device as it is installed. On some devices,
    `filter.MagCaptureAutoCalibration` captures them from the filter's automatic calibration. Before
    it sends `sensor.ScaledMag`, the device corrects the field: the matrix times (measured -
    offset), with the matrix of `MagSoftIronMatrix`.

    - 3dm-cv7-gnss-ins: Magnetometer Hard Iron Offset (0x0C,0x3A)
    - 3dm-gx5-45: (0x0C, 0x3A)
    """

    __slots__ = ("function", "offset")
    __match_args__ = ("function", "offset")

    SET = 0x0C
    DESCRIPTOR = 0x3A
    NAME = "3dm.mag_hard_iron_offset"
    RESPONSES = (MagHardIronOffsetResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0, 6: 1}
    _VECTORS = {"offset": (types.Vector3f,)}

    function: FunctionSelector
    """Operation on the setting."""
    offset: types.Vector3f | None
    """Offset that the device subtracts from the measured magnetic field. Elements: x, y, z. Unit:
    gauss. Frame: sensor. Required for `write` and `apply`.

    - On the 3DM-GX5-45: default 0, 0, 0.
    """

    def __init__(
        self, function: FunctionSelector, offset: types.Vector3f | codec.Numbers | None = None
    ) -> None:
        self.function = function
        self.offset = codec.vector(offset, types.Vector3f)

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 12))
        self._offset = _3f.read(raw, at) if there >= 1 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(self, self.REQUIRED.get(self.function, 0), (1, "offset"))
        if there >= 1:
            out += _3f.write("offset*3", *codec.elements("offset", self.offset, 3))
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[MagHardIronOffset[Any]], offset: types.Vector3f | codec.Numbers
    ) -> MagHardIronOffset[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, offset=offset)

    @classmethod
    def read(cls: ClassOf[MagHardIronOffset[Any]]) -> MagHardIronOffset[MagHardIronOffsetResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[MagHardIronOffset[Any]]) -> MagHardIronOffset[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[MagHardIronOffset[Any]]) -> MagHardIronOffset[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[MagHardIronOffset[Any]]) -> MagHardIronOffset[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @classmethod
    def apply(
        cls: ClassOf[MagHardIronOffset[Any]], offset: types.Vector3f | codec.Numbers
    ) -> MagHardIronOffset[None]:
        """Apply the new setting without sending an ACK (5-series devices)."""
        return cls(FunctionSelector.APPLY, offset=offset)

    @property
    def answered(self) -> bool:
        return self.function != FunctionSelector.APPLY

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (MagHardIronOffsetResponse,)
        return ()


class MagSoftIronMatrix(Command[R]):
    """Magnetometer soft iron matrix (0x0C,0x3B).

    Sets the matrix that corrects the scaled magnetic field for soft iron.

    Functions: `write`, `read`, `save`, `load`, `default` and `apply`. Response:
    `MagSoftIronMatrixResponse`. Affects `sensor.ScaledMag`. Confirmed on 3DM-CV7-AHRS,
    3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on
    14 more. On the 3DM-CV7-AHRS: `write`, `read`, `save`, `load` and `default` only. On the
    3DM-CV7-GNSS/INS: `write`, `read`, `save`, `load` and `default` only. Requires a magnetometer.
    Uncertain: The sources do not state the formula; it is inferred from the terms.

    The values come from a calibration of the device as it is installed. On some devices,
    `filter.MagCaptureAutoCalibration` captures them from the filter's automatic calibration. Before
    it sends `sensor.ScaledMag`, the device corrects the field: the matrix times (measured -
    offset), with the offset of `MagHardIronOffset`.

    - 3dm-cv7-gnss-ins: Magnetometer Soft Iron Matrix (0x0C,0x3B)
    - 3dm-gx5-35: (0x0C, 0x3B)
    """

    __slots__ = ("function", "matrix")
    __match_args__ = ("function", "matrix")

    SET = 0x0C
    DESCRIPTOR = 0x3B
    NAME = "3dm.mag_soft_iron_matrix"
    RESPONSES = (MagSoftIronMatrixResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0, 6: 1}
    _VECTORS = {"matrix": (types.Matrix3f,)}

    function: FunctionSelector
    """Operation on the setting."""
    matrix: types.Matrix3f | None
    """Soft iron matrix in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33.
    Unit: 1. Frame: sensor. Required for `write` and `apply`.
    """

    def __init__(
        self, function: FunctionSelector, matrix: types.Matrix3f | codec.Rows | None = None
    ) -> None:
        self.function = function
        self.matrix = codec.vector(matrix, types.Matrix3f)

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 36))
        self._matrix = _9f.read(raw, at) if there >= 1 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(self, self.REQUIRED.get(self.function, 0), (1, "matrix"))
        if there >= 1:
            out += _9f.write("matrix*9", *codec.elements("matrix", self.matrix, 9))
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[MagSoftIronMatrix[Any]], matrix: types.Matrix3f | codec.Rows
    ) -> MagSoftIronMatrix[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, matrix=matrix)

    @classmethod
    def read(cls: ClassOf[MagSoftIronMatrix[Any]]) -> MagSoftIronMatrix[MagSoftIronMatrixResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[MagSoftIronMatrix[Any]]) -> MagSoftIronMatrix[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[MagSoftIronMatrix[Any]]) -> MagSoftIronMatrix[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[MagSoftIronMatrix[Any]]) -> MagSoftIronMatrix[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @classmethod
    def apply(
        cls: ClassOf[MagSoftIronMatrix[Any]], matrix: types.Matrix3f | codec.Rows
    ) -> MagSoftIronMatrix[None]:
        """Apply the new setting without sending an ACK (5-series devices)."""
        return cls(FunctionSelector.APPLY, matrix=matrix)

    @property
    def answered(self) -> bool:
        return self.function != FunctionSelector.APPLY

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (MagSoftIronMatrixResponse,)
        return ()


class ConingScullingEnable(Command[R]):
    """Coning and sculling enable (0x0C,0x3E).

    Enables or disables coning and sculling compensation.

    Functions: `write`, `read`, `save`, `load` and `default`. Response:
    `ConingScullingEnableResponse`. Probably affects `sensor.DeltaTheta` and `sensor.DeltaVelocity`.
    Confirmed on 3DM-GQ4-45, 3DM-GX5-15, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 15
    more.

    - 3dm-gx5-15: 4.2.12 Coning and Sculling Enable (0x0C, 0x3E)
    """

    __slots__ = ("function", "enable")
    __match_args__ = ("function", "enable")

    SET = 0x0C
    DESCRIPTOR = 0x3E
    NAME = "3dm.coning_sculling_enable"
    RESPONSES = (ConingScullingEnableResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """Operation on the setting."""
    enable: bool | None
    """True if the compensation is on. Default: true. Required for `write`."""

    def __init__(self, function: FunctionSelector, enable: bool | None = None) -> None:
        self.function = function
        self.enable = enable

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 1))
        self.enable = codec.TRUTH[_B.read(raw, at)[0]] if there >= 1 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(self, self.REQUIRED.get(self.function, 0), (1, "enable"))
        out += _B.write("enable", self.enable) if there >= 1 else b""
        return codec.finished(out)

    @classmethod
    def write(cls: ClassOf[ConingScullingEnable[Any]], enable: bool) -> ConingScullingEnable[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, enable=enable)

    @classmethod
    def read(
        cls: ClassOf[ConingScullingEnable[Any]],
    ) -> ConingScullingEnable[ConingScullingEnableResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[ConingScullingEnable[Any]]) -> ConingScullingEnable[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[ConingScullingEnable[Any]]) -> ConingScullingEnable[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[ConingScullingEnable[Any]]) -> ConingScullingEnable[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (ConingScullingEnableResponse,)
        return ()


class UartBaudRate(Command[R]):
    """UART baud rate (0x0C,0x40).

    Sets the baud rate of the main port.

    Also called `uart_baudrate`. Functions: `write`, `read`, `save`, `load` and `default`. Response:
    `UartBaudRateResponse`. Devices without it may have `base.CommSpeed`. Confirmed on
    3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or
    assumed on 12 more.

    The 3DM-GX5-15 replies at the old rate and accepts commands at the new rate 250 ms later. The
    3DM-CV7 applies the rate when the port is empty, after at most 250 ms; until then, commands and
    data may be lost. Set the device to idle first, send the command in a separate packet, and wait
    250 ms afterwards.

    - 3dm-gx5-15: 4.2.13 UART Baud Rate (0x0C, 0x40)
    - 3dm-cv7-gnss-ins: UART Baudrate (0x0C,0x40)
    """

    __slots__ = ("function", "baud")
    __match_args__ = ("function", "baud")

    SET = 0x0C
    DESCRIPTOR = 0x40
    NAME = "3dm.uart_baud_rate"
    RESPONSES = (UartBaudRateResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """Operation on the setting."""
    baud: int | None
    """New baud rate; the port must support it. Unit: Bd. Required for `write`.

    - On the 3DM-GX5-15 and 3DM-GX5-45: default 115200.
    """

    def __init__(self, function: FunctionSelector, baud: int | None = None) -> None:
        self.function = function
        self.baud = baud

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 4))
        self.baud = _I.read(raw, at)[0] if there >= 1 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(self, self.REQUIRED.get(self.function, 0), (1, "baud"))
        out += _I.write("baud", self.baud) if there >= 1 else b""
        return codec.finished(out)

    @classmethod
    def write(cls: ClassOf[UartBaudRate[Any]], baud: int) -> UartBaudRate[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, baud=baud)

    @classmethod
    def read(cls: ClassOf[UartBaudRate[Any]]) -> UartBaudRate[UartBaudRateResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[UartBaudRate[Any]]) -> UartBaudRate[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[UartBaudRate[Any]]) -> UartBaudRate[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[UartBaudRate[Any]]) -> UartBaudRate[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (UartBaudRateResponse,)
        return ()


class GpioConfig(Command[R]):
    """GPIO configuration (0x0C,0x41).

    Sets the use of a GPIO pin.

    Functions: `write`, `read`, `save`, `load` and `default`. Response: `GpioConfigResponse`.
    Probably affects `system_data.GpioState` and `system_data.GpioAnalogValue`. Confirmed on
    3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 8 more.

    Not every pin has every feature. For an output with a feature other than gpio, configure the
    function that drives it before the pin; otherwise, the level of the pin is undefined in the
    meantime. For an input, configure the pin before the function that uses it. If only one pin can
    have a configuration, the last pin configured gets it, and the earlier pin is reset. With NMEA
    input at most one pin may be a UART input; set it to unused before another one takes over.

    - 3dm-cv7-gnss-ins: GPIO Configuration (0x0C,0x41)
    """

    __slots__ = ("function", "pin", "feature", "behavior", "pin_mode")
    __match_args__ = ("function", "pin", "feature", "behavior", "pin_mode")

    SET = 0x0C
    DESCRIPTOR = 0x41
    NAME = "3dm.gpio_config"
    RESPONSES = (GpioConfigResponse,)
    REQUIRED = {1: 4, 2: 1, 3: 1, 4: 1, 5: 1}

    function: FunctionSelector
    """Operation on the setting."""
    pin: int | None
    """GPIO pin, counted from 1; 0 means all pins (save, load, default)."""
    feature: types.GpioFeature | None
    """Use of the pin. Default: `types.GpioFeature.UNUSED`. Required for `write`."""
    behavior: int | None
    """Role of the pin within the feature; 0 if the feature has no roles. Required for `write`.

    - If `feature` is `types.GpioFeature.UNUSED`: values of `types.GpioUnusedBehavior`.
    - If `feature` is `types.GpioFeature.GPIO`: values of `types.GpioBehavior`.
    - If `feature` is `types.GpioFeature.PPS`: values of `types.GpioPpsBehavior`.
    - If `feature` is `types.GpioFeature.ENCODER`: values of `types.GpioEncoderBehavior`.
    - If `feature` is `types.GpioFeature.TIMESTAMP`: values of `types.GpioTimestampBehavior`.
    - If `feature` is `types.GpioFeature.UART`: values of `types.GpioUartBehavior`.
    """
    pin_mode: types.GpioPinMode | None
    """Electrical options. Required for `write`."""

    def __init__(
        self,
        function: FunctionSelector,
        pin: int | None = None,
        feature: types.GpioFeature | None = None,
        behavior: int | None = None,
        pin_mode: types.GpioPinMode | None = None,
    ) -> None:
        self.function = function
        self.pin = pin
        self.feature = feature
        self.behavior = behavior
        self.pin_mode = pin_mode

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(
            raw, at, self.REQUIRED.get(self.function, 0), (0, 1, 2, 3, 4)
        )
        self.pin = _B.read(raw, at)[0] if there >= 1 else None
        self.feature = (
            codec.KNOWN[types.GpioFeature][_B.read(raw, at + 1)[0]] if there >= 2 else None
        )
        self.behavior = _B.read(raw, at + 2)[0] if there >= 3 else None
        self.pin_mode = (
            codec.KNOWN[types.GpioPinMode][_B.read(raw, at + 3)[0]] if there >= 4 else None
        )
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self,
            self.REQUIRED.get(self.function, 0),
            (1, "pin"),
            (2, "feature"),
            (3, "behavior"),
            (4, "pin_mode"),
        )
        out += _B.write("pin", self.pin) if there >= 1 else b""
        out += _B.write("feature", self.feature) if there >= 2 else b""
        out += _B.write("behavior", self.behavior) if there >= 3 else b""
        out += _B.write("pin_mode", self.pin_mode) if there >= 4 else b""
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[GpioConfig[Any]],
        pin: int,
        feature: types.GpioFeature,
        behavior: int,
        pin_mode: types.GpioPinMode,
    ) -> GpioConfig[None]:
        """Apply the new setting."""
        return cls(
            FunctionSelector.WRITE, pin=pin, feature=feature, behavior=behavior, pin_mode=pin_mode
        )

    @classmethod
    def read(cls: ClassOf[GpioConfig[Any]], pin: int) -> GpioConfig[GpioConfigResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ, pin=pin)

    @classmethod
    def save(cls: ClassOf[GpioConfig[Any]], pin: int) -> GpioConfig[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE, pin=pin)

    @classmethod
    def load(cls: ClassOf[GpioConfig[Any]], pin: int) -> GpioConfig[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD, pin=pin)

    @classmethod
    def default(cls: ClassOf[GpioConfig[Any]], pin: int) -> GpioConfig[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT, pin=pin)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (GpioConfigResponse,)
        return ()


class GpioState(Command[R]):
    """GPIO state (0x0C,0x42).

    Sets or reads the state of a GPIO pin.

    Functions: `write` and `read`. Response: `GpioStateResponse`. Affects `system_data.GpioState`.
    Confirmed on 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed on 9 more.

    A read returns the level of the pin itself. A write has an effect only on a pin that is
    configured as an output. An event action of mode `active_high` or `active_low` on the pin
    overrides the written state. Reading is guaranteed to work only with the gpio feature.
    `GpioConfig` determines the state at power-up.

    - 3dm-cv7-gnss-ins: GPIO State (0x0C,0x42)
    """

    __slots__ = ("function", "pin", "state")
    __match_args__ = ("function", "pin", "state")

    SET = 0x0C
    DESCRIPTOR = 0x42
    NAME = "3dm.gpio_state"
    RESPONSES = (GpioStateResponse,)
    REQUIRED = {1: 2, 2: 1}

    function: FunctionSelector
    """Operation on the setting."""
    pin: int | None
    """GPIO pin, counted from 1. Range: at least 1."""
    state: bool | None
    """True means high. Required for `write`."""

    def __init__(
        self, function: FunctionSelector, pin: int | None = None, state: bool | None = None
    ) -> None:
        self.function = function
        self.pin = pin
        self.state = state

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 1, 2))
        self.pin = _B.read(raw, at)[0] if there >= 1 else None
        self.state = codec.TRUTH[_B.read(raw, at + 1)[0]] if there >= 2 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self, self.REQUIRED.get(self.function, 0), (1, "pin"), (2, "state")
        )
        out += _B.write("pin", self.pin) if there >= 1 else b""
        out += _B.write("state", self.state) if there >= 2 else b""
        return codec.finished(out)

    @classmethod
    def write(cls: ClassOf[GpioState[Any]], pin: int, state: bool) -> GpioState[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, pin=pin, state=state)

    @classmethod
    def read(cls: ClassOf[GpioState[Any]], pin: int) -> GpioState[GpioStateResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ, pin=pin)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (GpioStateResponse,)
        return ()


class OdometerConfig(Command[R]):
    """Odometer configuration (0x0C,0x43).

    Configures the input from a wheel encoder.

    Also called `odometer`. Functions: `write`, `read`, `save`, `load` and `default`. Response:
    `OdometerConfigResponse`. Affects `sensor.Odometer`. Confirmed on 3DM-CV7-GNSS/INS; likely or
    assumed on 1 more.

    - 3dm-cv7-gnss-ins: Odometer Configuration (0x0C,0x43)
    """

    __slots__ = ("function", "mode", "scaling", "uncertainty")
    __match_args__ = ("function", "mode", "scaling", "uncertainty")

    SET = 0x0C
    DESCRIPTOR = 0x43
    NAME = "3dm.odometer_config"
    RESPONSES = (OdometerConfigResponse,)
    REQUIRED = {1: 3, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """Operation on the setting."""
    mode: OdometerMode | None
    """Operation of the input. Required for `write`."""
    scaling: float | None
    """Pulses per distance travelled; negative if the encoder rotates backwards. Unit: pulse/m.
    Required for `write`. Pulses on line A per turn of the wheel, divided by the circumference of
    the wheel.
    """
    uncertainty: float | None
    """Relative uncertainty of the scaling, 1 sigma. Unit: 1. Range: at least 0. Required for
    `write`.
    """

    def __init__(
        self,
        function: FunctionSelector,
        mode: OdometerMode | None = None,
        scaling: float | None = None,
        uncertainty: float | None = None,
    ) -> None:
        self.function = function
        self.mode = mode
        self.scaling = scaling
        self.uncertainty = uncertainty

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 1, 5, 9))
        self.mode = codec.KNOWN[OdometerMode][_B.read(raw, at)[0]] if there >= 1 else None
        self.scaling = _f.read(raw, at + 1)[0] if there >= 2 else None
        self.uncertainty = _f.read(raw, at + 5)[0] if there >= 3 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self,
            self.REQUIRED.get(self.function, 0),
            (1, "mode"),
            (2, "scaling"),
            (3, "uncertainty"),
        )
        out += _B.write("mode", self.mode) if there >= 1 else b""
        out += _f.write("scaling", self.scaling) if there >= 2 else b""
        out += _f.write("uncertainty", self.uncertainty) if there >= 3 else b""
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[OdometerConfig[Any]], mode: OdometerMode, scaling: float, uncertainty: float
    ) -> OdometerConfig[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, mode=mode, scaling=scaling, uncertainty=uncertainty)

    @classmethod
    def read(cls: ClassOf[OdometerConfig[Any]]) -> OdometerConfig[OdometerConfigResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[OdometerConfig[Any]]) -> OdometerConfig[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[OdometerConfig[Any]]) -> OdometerConfig[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[OdometerConfig[Any]]) -> OdometerConfig[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (OdometerConfigResponse,)
        return ()


class ImuLowPassFilter(Command[R]):
    """Advanced low-pass filter settings (0x0C,0x50).

    Configures the low-pass filter of one sensor data quantity.

    For advanced use. Also called `imu_lowpass_filter`. Functions: `write`, `read`, `save`, `load`
    and `default`. Response: `ImuLowPassFilterResponse`. Affects `sensor.ScaledAccel`,
    `sensor.ScaledGyro`, `sensor.ScaledMag` and `sensor.ScaledPressure`. Devices without it may have
    `LowPassFilter`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ4-45,
    3DM-GQ7-GNSS/INS, 3DM-GX5-15, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 20 more.
    Deprecated on the 3DM-CV7-AHRS: use `LowPassFilter` instead. Deprecated on the 3DM-CV7-AR: use
    `LowPassFilter` instead. Deprecated on the 3DM-CV7-GNSS/INS: use `LowPassFilter` instead.
    Deprecated on the 3DM-GQ7-GNSS/INS: use `LowPassFilter` instead. Requires firmware up to 1.0.07
    on the 3DM-CV7-AHRS and 3DM-CV7-AR. Requires firmware up to 1.0.10 on the 3DM-GQ7-GNSS/INS.

    The filter has one pole. By default it is on and its cutoff is half the rate of the message
    format.

    - 3dm-gx5-15: 4.2.14 Advanced Low-Pass Filter Settings (0x0C, 0x50)
    - 3dm-cv7-gnss-ins: Advanced Low-Pass Filter Settings (0x0C,0x50)
    """

    __slots__ = ("function", "target_descriptor", "enable", "manual", "frequency", "reserved")
    __match_args__ = ("function", "target_descriptor", "enable", "manual", "frequency", "reserved")

    SET = 0x0C
    DESCRIPTOR = 0x50
    NAME = "3dm.imu_low_pass_filter"
    RESPONSES = (ImuLowPassFilterResponse,)
    REQUIRED = {1: 5, 2: 1, 3: 1, 4: 1, 5: 1}

    function: FunctionSelector
    """Operation on the setting."""
    target_descriptor: int | None
    """Field descriptor in the sensor data set: scaled acceleration 0x04, angular rate 0x05,
    magnetic field 0x06 or pressure 0x17. Refers to fields of Sensor data.

    - On the 3DM-CV7-GNSS/INS: Field descriptor in the sensor data set: scaled acceleration 0x04,
      angular rate 0x05, magnetic field 0x06 or pressure 0x17; 0 means all of them, except for read.
    """
    enable: bool | None
    """True if the quantity is filtered. Default: true. Required for `write`."""
    manual: bool | None
    """True uses `frequency`; false uses half the rate of the message format. Default: false.
    Required for `write`.
    """
    frequency: int | None
    """Cutoff (-3 dB). It has no meaning if `manual` is false. Unit: Hz. Required for `write`.

    - On the 3DM-GX5-15: range at most 250.
    """
    reserved: int | None
    """Reserved: send 0. Required for `write`."""

    def __init__(
        self,
        function: FunctionSelector,
        target_descriptor: int | None = None,
        enable: bool | None = None,
        manual: bool | None = None,
        frequency: int | None = None,
        reserved: int | None = None,
    ) -> None:
        self.function = function
        self.target_descriptor = target_descriptor
        self.enable = enable
        self.manual = manual
        self.frequency = frequency
        self.reserved = reserved

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(
            raw, at, self.REQUIRED.get(self.function, 0), (0, 1, 2, 3, 5, 6)
        )
        self.target_descriptor = _B.read(raw, at)[0] if there >= 1 else None
        self.enable = codec.TRUTH[_B.read(raw, at + 1)[0]] if there >= 2 else None
        self.manual = codec.TRUTH[_B.read(raw, at + 2)[0]] if there >= 3 else None
        self.frequency = _H.read(raw, at + 3)[0] if there >= 4 else None
        self.reserved = _B.read(raw, at + 5)[0] if there >= 5 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self,
            self.REQUIRED.get(self.function, 0),
            (1, "target_descriptor"),
            (2, "enable"),
            (3, "manual"),
            (4, "frequency"),
            (5, "reserved"),
        )
        out += _B.write("target_descriptor", self.target_descriptor) if there >= 1 else b""
        out += _B.write("enable", self.enable) if there >= 2 else b""
        out += _B.write("manual", self.manual) if there >= 3 else b""
        out += _H.write("frequency", self.frequency) if there >= 4 else b""
        out += _B.write("reserved", self.reserved) if there >= 5 else b""
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[ImuLowPassFilter[Any]],
        target_descriptor: int,
        enable: bool,
        manual: bool,
        frequency: int,
    ) -> ImuLowPassFilter[None]:
        """Apply the new setting."""
        return cls(
            FunctionSelector.WRITE,
            target_descriptor=target_descriptor,
            enable=enable,
            manual=manual,
            frequency=frequency,
            reserved=0,
        )

    @classmethod
    def read(
        cls: ClassOf[ImuLowPassFilter[Any]], target_descriptor: int
    ) -> ImuLowPassFilter[ImuLowPassFilterResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ, target_descriptor=target_descriptor)

    @classmethod
    def save(cls: ClassOf[ImuLowPassFilter[Any]], target_descriptor: int) -> ImuLowPassFilter[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE, target_descriptor=target_descriptor)

    @classmethod
    def load(cls: ClassOf[ImuLowPassFilter[Any]], target_descriptor: int) -> ImuLowPassFilter[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD, target_descriptor=target_descriptor)

    @classmethod
    def default(
        cls: ClassOf[ImuLowPassFilter[Any]], target_descriptor: int
    ) -> ImuLowPassFilter[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT, target_descriptor=target_descriptor)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (ImuLowPassFilterResponse,)
        return ()


class ComplementaryFilter(Command[R]):
    """Complementary filter configuration (0x0C,0x51).

    Configures the complementary filter, which computes the attitude independently of the estimation
    filter.

    Functions: `write`, `read`, `save`, `load` and `default`. Response:
    `ComplementaryFilterResponse`. Affects `sensor.CompOrientationMatrix`, `sensor.CompQuaternion`
    and `sensor.CompEulerAngles`. Probably affects `sensor.NorthVector` and `sensor.UpVector`.
    Confirmed on 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15 and 3DM-GX5-35; likely or assumed on 22
    more.

    Pitch and roll follow the accelerometers, on the assumption that the mean acceleration is zero.
    The heading follows the magnetometer, if the device has one. The device rejects time constants
    out of range. The attitude of the estimation filter is better; the 3DM-GX5-15 keeps this filter
    for compatibility.

    - 3dm-gx5-15: 4.2.15 Complementary Filter Settings (0x0C, 0x51)
    - 3dm-cv7-gnss-ins: Complementary Filter Configuration (0x0C,0x51)
    """

    __slots__ = (
        "function",
        "pitch_roll_enable",
        "heading_enable",
        "pitch_roll_time_constant",
        "heading_time_constant",
    )
    __match_args__ = (
        "function",
        "pitch_roll_enable",
        "heading_enable",
        "pitch_roll_time_constant",
        "heading_time_constant",
    )

    SET = 0x0C
    DESCRIPTOR = 0x51
    NAME = "3dm.complementary_filter"
    RESPONSES = (ComplementaryFilterResponse,)
    REQUIRED = {1: 4, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """Operation on the setting."""
    pitch_roll_enable: bool | None
    """True enables the pitch and roll correction, which 5-series manuals call up compensation.
    Required for `write`.

    - On the 3DM-GX5-15: default true.
    """
    heading_enable: bool | None
    """True enables the heading correction, which 5-series manuals call north compensation. Required
    for `write`.

    - On the 3DM-CV5-10, 3DM-CV5-15, 3DM-CX5-10 and 3DM-CX5-15: MSCL has no support for it.
    - On the 3DM-GX5-15: default true.
    """
    pitch_roll_time_constant: float | None
    """Time constant of the pitch and roll correction. Unit: s. Range: 1 to 1000. Default: 10.
    Required for `write`.
    """
    heading_time_constant: float | None
    """Time constant of the heading correction. Unit: s. Range: 1 to 1000. Default: 10. Required for
    `write`.
    """

    def __init__(
        self,
        function: FunctionSelector,
        pitch_roll_enable: bool | None = None,
        heading_enable: bool | None = None,
        pitch_roll_time_constant: float | None = None,
        heading_time_constant: float | None = None,
    ) -> None:
        self.function = function
        self.pitch_roll_enable = pitch_roll_enable
        self.heading_enable = heading_enable
        self.pitch_roll_time_constant = pitch_roll_time_constant
        self.heading_time_constant = heading_time_constant

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(
            raw, at, self.REQUIRED.get(self.function, 0), (0, 1, 2, 6, 10)
        )
        self.pitch_roll_enable = codec.TRUTH[_B.read(raw, at)[0]] if there >= 1 else None
        self.heading_enable = codec.TRUTH[_B.read(raw, at + 1)[0]] if there >= 2 else None
        self.pitch_roll_time_constant = _f.read(raw, at + 2)[0] if there >= 3 else None
        self.heading_time_constant = _f.read(raw, at + 6)[0] if there >= 4 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self,
            self.REQUIRED.get(self.function, 0),
            (1, "pitch_roll_enable"),
            (2, "heading_enable"),
            (3, "pitch_roll_time_constant"),
            (4, "heading_time_constant"),
        )
        out += _B.write("pitch_roll_enable", self.pitch_roll_enable) if there >= 1 else b""
        out += _B.write("heading_enable", self.heading_enable) if there >= 2 else b""
        if there >= 3:
            out += _f.write("pitch_roll_time_constant", self.pitch_roll_time_constant)
        out += _f.write("heading_time_constant", self.heading_time_constant) if there >= 4 else b""
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[ComplementaryFilter[Any]],
        pitch_roll_enable: bool,
        heading_enable: bool,
        pitch_roll_time_constant: float,
        heading_time_constant: float,
    ) -> ComplementaryFilter[None]:
        """Apply the new setting."""
        return cls(
            FunctionSelector.WRITE,
            pitch_roll_enable=pitch_roll_enable,
            heading_enable=heading_enable,
            pitch_roll_time_constant=pitch_roll_time_constant,
            heading_time_constant=heading_time_constant,
        )

    @classmethod
    def read(
        cls: ClassOf[ComplementaryFilter[Any]],
    ) -> ComplementaryFilter[ComplementaryFilterResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls: ClassOf[ComplementaryFilter[Any]]) -> ComplementaryFilter[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls: ClassOf[ComplementaryFilter[Any]]) -> ComplementaryFilter[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls: ClassOf[ComplementaryFilter[Any]]) -> ComplementaryFilter[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (ComplementaryFilterResponse,)
        return ()


class SensorRange(Command[R]):
    """Sensor range (0x0C,0x52).

    Sets the measuring range of a sensor.

    Functions: `write`, `read`, `save`, `load` and `default`. Response: `SensorRangeResponse`.
    Probably affects `sensor.ScaledAccel`, `sensor.ScaledGyro` and `sensor.OverrangeStatus`.
    Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10 more.

    `GetCalibratedSensorRanges` lists the settings. The device may reject other settings, or measure
    incorrectly with them.

    - 3dm-cv7-gnss-ins: Sensor Range (0x0C,0x52)
    """

    __slots__ = ("function", "sensor", "setting")
    __match_args__ = ("function", "sensor", "setting")

    SET = 0x0C
    DESCRIPTOR = 0x52
    NAME = "3dm.sensor_range"
    RESPONSES = (SensorRangeResponse,)
    REQUIRED = {1: 2, 2: 1, 3: 1, 4: 1, 5: 1}

    function: FunctionSelector
    """Operation on the setting."""
    sensor: SensorRangeType | None
    """Sensor whose range is set or read.

    - On the 3DM-CV7-AR, 3DM-CX7-AR and 3DM-GV7-AR: only `SensorRangeType.ALL`,
      `SensorRangeType.ACCEL`, `SensorRangeType.GYRO` and `SensorRangeType.PRESSURE`.
    """
    setting: int | None
    """Number of the range. Required for `write`."""

    def __init__(
        self,
        function: FunctionSelector,
        sensor: SensorRangeType | None = None,
        setting: int | None = None,
    ) -> None:
        self.function = function
        self.sensor = sensor
        self.setting = setting

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 1, 2))
        self.sensor = codec.KNOWN[SensorRangeType][_B.read(raw, at)[0]] if there >= 1 else None
        self.setting = _B.read(raw, at + 1)[0] if there >= 2 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self, self.REQUIRED.get(self.function, 0), (1, "sensor"), (2, "setting")
        )
        out += _B.write("sensor", self.sensor) if there >= 1 else b""
        out += _B.write("setting", self.setting) if there >= 2 else b""
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[SensorRange[Any]], sensor: SensorRangeType, setting: int
    ) -> SensorRange[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, sensor=sensor, setting=setting)

    @classmethod
    def read(
        cls: ClassOf[SensorRange[Any]], sensor: SensorRangeType
    ) -> SensorRange[SensorRangeResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ, sensor=sensor)

    @classmethod
    def save(cls: ClassOf[SensorRange[Any]], sensor: SensorRangeType) -> SensorRange[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE, sensor=sensor)

    @classmethod
    def load(cls: ClassOf[SensorRange[Any]], sensor: SensorRangeType) -> SensorRange[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD, sensor=sensor)

    @classmethod
    def default(cls: ClassOf[SensorRange[Any]], sensor: SensorRangeType) -> SensorRange[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT, sensor=sensor)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (SensorRangeResponse,)
        return ()


class GetCalibratedSensorRanges(Command[GetCalibratedSensorRangesResponse]):
    """Get calibrated sensor ranges (0x0C,0x53).

    Gets the ranges that a sensor supports.

    Also called `calibrated_sensor_ranges`. Response: `GetCalibratedSensorRangesResponse`. Confirmed
    on 3DM-CV7-GNSS/INS; likely or assumed on 10 more.

    - 3dm-cv7-gnss-ins: Get Calibrated Sensor Ranges (0x0C,0x53)
    """

    __slots__ = ("sensor",)
    __match_args__ = ("sensor",)

    SET = 0x0C
    DESCRIPTOR = 0x53
    NAME = "3dm.get_calibrated_sensor_ranges"
    RESPONSES = (GetCalibratedSensorRangesResponse,)
    _SIZE = 1

    sensor: SensorRangeType
    """Sensor to query; `all` is not allowed.

    - On the 3DM-CV7-AR, 3DM-CX7-AR and 3DM-GV7-AR: only `SensorRangeType.ALL`,
      `SensorRangeType.ACCEL`, `SensorRangeType.GYRO` and `SensorRangeType.PRESSURE`.
    """

    def __init__(self, sensor: SensorRangeType) -> None:
        self.sensor = sensor

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.sensor = codec.KNOWN[SensorRangeType][_B.unpack(raw, at)[0]]
        return at + 1

    def _write(self) -> bytes:
        return _B.write("sensor", self.sensor)


class LowPassFilter(Command[R]):
    """Low-pass anti-aliasing filter (0x0C,0x54).

    Configures the low-pass filter of a data field.

    Also called `lowpass_filter`. Functions: `write`, `read`, `save`, `load` and `default`.
    Response: `LowPassFilterResponse`. Affects `sensor.ScaledAccel`, `sensor.ScaledGyro`,
    `sensor.ScaledMag`, `sensor.ScaledPressure`, `filter_data.CompAccel`,
    `filter_data.CompAngularRate` and `filter_data.LinearAccel`. Devices without it may have
    `ImuLowPassFilter`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS and
    3DM-GQ7-GNSS/INS; likely or assumed on 7 more. Requires firmware later than 1.0.07 on the
    3DM-CV7-AHRS and 3DM-CV7-AR. Requires firmware later than 1.0.10 on the 3DM-GQ7-GNSS/INS.

    Except for read, a field descriptor of 0 means all fields of the set; if both are 0, all sets
    are meant.

    - 3dm-cv7-gnss-ins: Low-Pass Anti-Aliasing Filter (0x0C,0x54)
    """

    __slots__ = ("function", "descriptor_set", "field_descriptor", "enable", "manual", "frequency")
    __match_args__ = (
        "function",
        "descriptor_set",
        "field_descriptor",
        "enable",
        "manual",
        "frequency",
    )

    SET = 0x0C
    DESCRIPTOR = 0x54
    NAME = "3dm.low_pass_filter"
    RESPONSES = (LowPassFilterResponse,)
    REQUIRED = {1: 5, 2: 2, 3: 2, 4: 2, 5: 2}

    function: FunctionSelector
    """Operation on the setting."""
    descriptor_set: int | None
    """Descriptor set of the field."""
    field_descriptor: int | None
    """Field descriptor; 0 if the set is 0. Refers to fields of `descriptor_set`."""
    enable: bool | None
    """True if the field is filtered. Required for `write`."""
    manual: bool | None
    """True uses `frequency`; false uses half the rate of the field in the message format. Required
    for `write`.
    """
    frequency: float | None
    """Cutoff; a write ignores it if `manual` is false, a read returns the cutoff in use. Unit: Hz.
    Range: at least 0. Required for `write`.
    """

    def __init__(
        self,
        function: FunctionSelector,
        descriptor_set: int | None = None,
        field_descriptor: int | None = None,
        enable: bool | None = None,
        manual: bool | None = None,
        frequency: float | None = None,
    ) -> None:
        self.function = function
        self.descriptor_set = descriptor_set
        self.field_descriptor = field_descriptor
        self.enable = enable
        self.manual = manual
        self.frequency = frequency

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(
            raw, at, self.REQUIRED.get(self.function, 0), (0, 1, 2, 3, 4, 8)
        )
        self.descriptor_set = _B.read(raw, at)[0] if there >= 1 else None
        self.field_descriptor = _B.read(raw, at + 1)[0] if there >= 2 else None
        self.enable = codec.TRUTH[_B.read(raw, at + 2)[0]] if there >= 3 else None
        self.manual = codec.TRUTH[_B.read(raw, at + 3)[0]] if there >= 4 else None
        self.frequency = _f.read(raw, at + 4)[0] if there >= 5 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self,
            self.REQUIRED.get(self.function, 0),
            (1, "descriptor_set"),
            (2, "field_descriptor"),
            (3, "enable"),
            (4, "manual"),
            (5, "frequency"),
        )
        out += _B.write("descriptor_set", self.descriptor_set) if there >= 1 else b""
        out += _B.write("field_descriptor", self.field_descriptor) if there >= 2 else b""
        out += _B.write("enable", self.enable) if there >= 3 else b""
        out += _B.write("manual", self.manual) if there >= 4 else b""
        out += _f.write("frequency", self.frequency) if there >= 5 else b""
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[LowPassFilter[Any]],
        descriptor_set: int,
        field_descriptor: int,
        enable: bool,
        manual: bool,
        frequency: float,
    ) -> LowPassFilter[None]:
        """Apply the new setting."""
        return cls(
            FunctionSelector.WRITE,
            descriptor_set=descriptor_set,
            field_descriptor=field_descriptor,
            enable=enable,
            manual=manual,
            frequency=frequency,
        )

    @classmethod
    def read(
        cls: ClassOf[LowPassFilter[Any]], descriptor_set: int, field_descriptor: int
    ) -> LowPassFilter[LowPassFilterResponse]:
        """Return the current setting in a response."""
        return cls(
            FunctionSelector.READ, descriptor_set=descriptor_set, field_descriptor=field_descriptor
        )

    @classmethod
    def save(
        cls: ClassOf[LowPassFilter[Any]], descriptor_set: int, field_descriptor: int
    ) -> LowPassFilter[None]:
        """Save the current setting to non-volatile memory."""
        return cls(
            FunctionSelector.SAVE, descriptor_set=descriptor_set, field_descriptor=field_descriptor
        )

    @classmethod
    def load(
        cls: ClassOf[LowPassFilter[Any]], descriptor_set: int, field_descriptor: int
    ) -> LowPassFilter[None]:
        """Load the saved setting."""
        return cls(
            FunctionSelector.LOAD, descriptor_set=descriptor_set, field_descriptor=field_descriptor
        )

    @classmethod
    def default(
        cls: ClassOf[LowPassFilter[Any]], descriptor_set: int, field_descriptor: int
    ) -> LowPassFilter[None]:
        """Load the factory default setting."""
        return cls(
            FunctionSelector.DEFAULT,
            descriptor_set=descriptor_set,
            field_descriptor=field_descriptor,
        )

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (LowPassFilterResponse,)
        return ()


class DataStreamFormat(Command[R]):
    """Data stream format (0x0C,0x60).

    Selects MIP data or the raw data of a sensor for a stream.

    No device is known for certain to support it. Functions: `write`, `read`, `save`, `load` and
    `default`. Response: `DataStreamFormatResponse`. Known only from the MIP SDK of 2014 and
    MicroStrain Communication Library. Uncertain: A comment in the SDK of 2014 restricts it to the
    3DM-GX3-35; no other source lists devices. Uncertain: Functions other than write are assumed not
    to require `format`. The SDK of 2014 sends both parameters with every function, and a 0 in place
    of `format`.

    In the wrapped format, packets of the sensor arrive in fields of the data sets: `sensor.aspp`
    and `sensor.gxsb` for the IMU, `gnss_data.nmea` and `gnss_data.ubx` for the receiver.

    - mip-sdk-2014: Data stream format (0x0C,0x60)
    - mscl: Data stream format (0x0C,0x60)
    """

    __slots__ = ("function", "stream", "format")
    __match_args__ = ("function", "stream", "format")

    SET = 0x0C
    DESCRIPTOR = 0x60
    NAME = "3dm.data_stream_format"
    RESPONSES = (DataStreamFormatResponse,)
    REQUIRED = {1: 2, 2: 2, 3: 2, 4: 2, 5: 2}

    function: FunctionSelector
    """Operation on the setting."""
    stream: InternalSensor | None
    """Stream whose format is set or read."""
    format: StreamFormat | None
    """Format of a data stream."""

    def __init__(
        self,
        function: FunctionSelector,
        stream: InternalSensor | None = None,
        format: StreamFormat | None = None,
    ) -> None:
        self.function = function
        self.stream = stream
        self.format = format

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 1, 2))
        self.stream = codec.KNOWN[InternalSensor][_B.read(raw, at)[0]] if there >= 1 else None
        self.format = codec.KNOWN[StreamFormat][_B.read(raw, at + 1)[0]] if there >= 2 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self, self.REQUIRED.get(self.function, 0), (1, "stream"), (2, "format")
        )
        out += _B.write("stream", self.stream) if there >= 1 else b""
        out += _B.write("format", self.format) if there >= 2 else b""
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[DataStreamFormat[Any]], stream: InternalSensor, format: StreamFormat
    ) -> DataStreamFormat[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, stream=stream, format=format)

    @classmethod
    def read(
        cls: ClassOf[DataStreamFormat[Any]], stream: InternalSensor, format: StreamFormat
    ) -> DataStreamFormat[DataStreamFormatResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ, stream=stream, format=format)

    @classmethod
    def save(
        cls: ClassOf[DataStreamFormat[Any]], stream: InternalSensor, format: StreamFormat
    ) -> DataStreamFormat[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE, stream=stream, format=format)

    @classmethod
    def load(
        cls: ClassOf[DataStreamFormat[Any]], stream: InternalSensor, format: StreamFormat
    ) -> DataStreamFormat[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD, stream=stream, format=format)

    @classmethod
    def default(
        cls: ClassOf[DataStreamFormat[Any]], stream: InternalSensor, format: StreamFormat
    ) -> DataStreamFormat[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT, stream=stream, format=format)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (DataStreamFormatResponse,)
        return ()


class DevicePowerState(Command[R]):
    """Device power state (0x0C,0x61).

    Sets the power state of an internal sensor.

    No device is known for certain to support it. Functions: `write`, `read`, `save`, `load` and
    `default`. Response: `DevicePowerStateResponse`. The device may take 5 s to reply. Known only
    from the MIP SDK of 2014 and MicroStrain Communication Library. Uncertain: A comment in the SDK
    of 2014 names the 3DM-GX3-25 and the 3DM-GX3-35; no other source lists devices. Uncertain: The
    time-out of 5 s is assumed; the SDK of 2014 uses one that is longer than usual. Uncertain:
    Functions other than write are assumed not to require `state`. The SDK of 2014 sends `device`
    with every function, and a 0 in place of `state`.

    - mip-sdk-2014: Device power state (0x0C,0x61)
    - mscl: Device power state (0x0C,0x61)
    """

    __slots__ = ("function", "device", "state")
    __match_args__ = ("function", "device", "state")

    SET = 0x0C
    DESCRIPTOR = 0x61
    NAME = "3dm.device_power_state"
    RESPONSES = (DevicePowerStateResponse,)
    REQUIRED = {1: 2, 2: 1, 3: 1, 4: 1, 5: 1}
    TIMEOUT = 5.0

    function: FunctionSelector
    """Operation on the setting."""
    device: InternalSensor | None
    """The sensor.

    - On the 3DM-GX3-15 and 3DM-GX3-25: only `InternalSensor.IMU`.
    """
    state: SensorPowerState | None
    """Power state of an internal sensor. Required for `write`."""

    def __init__(
        self,
        function: FunctionSelector,
        device: InternalSensor | None = None,
        state: SensorPowerState | None = None,
    ) -> None:
        self.function = function
        self.device = device
        self.state = state

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.read(raw, at)[0]]
        at += 1
        there, end = codec.find_present(raw, at, self.REQUIRED.get(self.function, 0), (0, 1, 2))
        self.device = codec.KNOWN[InternalSensor][_B.read(raw, at)[0]] if there >= 1 else None
        self.state = codec.KNOWN[SensorPowerState][_B.read(raw, at + 1)[0]] if there >= 2 else None
        return end

    def _write(self) -> bytes:
        out = _B.write("function", self.function)
        there = codec.count_present(
            self, self.REQUIRED.get(self.function, 0), (1, "device"), (2, "state")
        )
        out += _B.write("device", self.device) if there >= 1 else b""
        out += _B.write("state", self.state) if there >= 2 else b""
        return codec.finished(out)

    @classmethod
    def write(
        cls: ClassOf[DevicePowerState[Any]], device: InternalSensor, state: SensorPowerState
    ) -> DevicePowerState[None]:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, device=device, state=state)

    @classmethod
    def read(
        cls: ClassOf[DevicePowerState[Any]], device: InternalSensor
    ) -> DevicePowerState[DevicePowerStateResponse]:
        """Return the current setting in a response."""
        return cls(FunctionSelector.READ, device=device)

    @classmethod
    def save(cls: ClassOf[DevicePowerState[Any]], device: InternalSensor) -> DevicePowerState[None]:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE, device=device)

    @classmethod
    def load(cls: ClassOf[DevicePowerState[Any]], device: InternalSensor) -> DevicePowerState[None]:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD, device=device)

    @classmethod
    def default(
        cls: ClassOf[DevicePowerState[Any]], device: InternalSensor
    ) -> DevicePowerState[None]:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT, device=device)

    @property
    def expected(self) -> ResponseClasses:
        if self.function == FunctionSelector.READ:
            return (DevicePowerStateResponse,)
        return ()


class GpsAdvancedSettings(Command[None]):
    """GPS advanced settings (0x0C,0x62).

    Saves, loads or resets the settings of the GNSS receiver that were made in direct mode.

    No device is known for certain to support it. For advanced use. Functions: `save`, `load` and
    `default`. Known only from the MIP SDK of 2014 and MicroStrain Communication Library. Requires a
    receiver. Uncertain: A comment in the SDK of 2014 names the 3DM-GX3-35; no other source lists
    devices.

    In direct mode, your program configures the u-blox receiver with its own protocol; see
    `system.CommMode`.

    - mip-sdk-2014: GPS advanced settings (0x0C,0x62)
    - mscl: GPS advanced settings (0x0C,0x62)
    """

    __slots__ = ("function",)
    __match_args__ = ("function",)

    SET = 0x0C
    DESCRIPTOR = 0x62
    NAME = "3dm.gps_advanced_settings"
    REQUIRED = {3: 0, 4: 0, 5: 0}
    _SIZE = 1

    function: FunctionSelector
    """Operation on the setting."""

    def __init__(self, function: FunctionSelector) -> None:
        self.function = function

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.function = codec.KNOWN[FunctionSelector][_B.unpack(raw, at)[0]]
        return at + 1

    def _write(self) -> bytes:
        return _B.write("function", self.function)

    @classmethod
    def save(cls) -> GpsAdvancedSettings:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> GpsAdvancedSettings:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> GpsAdvancedSettings:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)


class DeviceStatus(
    Command[
        DeviceStatusBasicRq1ImuResponse
        | DeviceStatusBasicResponse
        | DeviceStatusBasicWithoutStateResponse
        | DeviceStatusBasicGx3Response
        | DeviceStatusDiagnosticResponse
        | DeviceStatusDiagnosticGnssResponse
        | DeviceStatusDiagnosticGq4_45Response
        | DeviceStatusDiagnosticRq1_45Response
        | DeviceStatusDiagnosticGx4Response
        | DeviceStatusDiagnosticImuResponse
        | DeviceStatusDiagnosticGx4ImuResponse
        | DeviceStatusDiagnosticRq1ImuResponse
        | DeviceStatusDiagnosticGx3Response
    ]
):
    """Device status (0x0C,0x64).

    Gets the state of the device, in basic form or with counters.

    For advanced use. Response: `DeviceStatusBasicRq1ImuResponse`, `DeviceStatusBasicResponse`,
    `DeviceStatusBasicWithoutStateResponse`, `DeviceStatusDiagnosticResponse`,
    `DeviceStatusDiagnosticGnssResponse`, `DeviceStatusDiagnosticGq4_45Response`,
    `DeviceStatusDiagnosticRq1_45Response`, `DeviceStatusDiagnosticGx4Response`,
    `DeviceStatusDiagnosticImuResponse`, `DeviceStatusDiagnosticGx4ImuResponse`,
    `DeviceStatusDiagnosticRq1ImuResponse`, `DeviceStatusBasicGx3Response` or
    `DeviceStatusDiagnosticGx3Response`. Confirmed on 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35,
    3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 17 more.

    The device expects its own model number, which `base.GetDeviceInfo` returns. Device families
    reply in different layouts. The selector and the length distinguish them.

    - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
    - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
    - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
    - mscl: Device status (0x0C,0x64)
    """

    __slots__ = ("model_number", "status_selector")
    __match_args__ = ("model_number", "status_selector")

    SET = 0x0C
    DESCRIPTOR = 0x64
    NAME = "3dm.device_status"
    RESPONSES = (
        DeviceStatusBasicRq1ImuResponse,
        DeviceStatusBasicResponse,
        DeviceStatusBasicWithoutStateResponse,
        DeviceStatusDiagnosticResponse,
        DeviceStatusDiagnosticGnssResponse,
        DeviceStatusDiagnosticGq4_45Response,
        DeviceStatusDiagnosticRq1_45Response,
        DeviceStatusDiagnosticGx4Response,
        DeviceStatusDiagnosticImuResponse,
        DeviceStatusDiagnosticGx4ImuResponse,
        DeviceStatusDiagnosticRq1ImuResponse,
        DeviceStatusBasicGx3Response,
        DeviceStatusDiagnosticGx3Response,
    )
    _SIZE = 3

    model_number: int
    """Model number of the device that replies.

    - On the 3DM-GX5-15: always 6254.
    - On the 3DM-GX5-35: always 6252.
    - On the 3DM-GX5-45: always 6251.
    """
    status_selector: DeviceStatusSelector
    """Level of detail of the reply."""

    def __init__(self, model_number: int, status_selector: DeviceStatusSelector) -> None:
        self.model_number = model_number
        self.status_selector = status_selector

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _HB.unpack(raw, at)
        self.model_number = v[0]
        self.status_selector = codec.KNOWN[DeviceStatusSelector][v[1]]
        return at + 3

    def _write(self) -> bytes:
        return _HB.write("model_number status_selector", self.model_number, self.status_selector)

    @property
    def expected(self) -> ResponseClasses:
        if self.status_selector == 1:
            return (
                DeviceStatusBasicRq1ImuResponse,
                DeviceStatusBasicResponse,
                DeviceStatusBasicWithoutStateResponse,
                DeviceStatusBasicGx3Response,
            )
        if self.status_selector == 2:
            return (
                DeviceStatusDiagnosticResponse,
                DeviceStatusDiagnosticGnssResponse,
                DeviceStatusDiagnosticGq4_45Response,
                DeviceStatusDiagnosticRq1_45Response,
                DeviceStatusDiagnosticGx4Response,
                DeviceStatusDiagnosticImuResponse,
                DeviceStatusDiagnosticGx4ImuResponse,
                DeviceStatusDiagnosticRq1ImuResponse,
                DeviceStatusDiagnosticGx3Response,
            )
        return ()


ImuMessageFormatResponse.COMMANDS = (ImuMessageFormat,)
GnssMessageFormatResponse.COMMANDS = (GnssMessageFormat,)
FilterMessageFormatResponse.COMMANDS = (FilterMessageFormat,)
GetImuBaseRateResponse.COMMANDS = (GetImuBaseRate,)
GetGnssBaseRateResponse.COMMANDS = (GetGnssBaseRate,)
DataStreamControlResponse.COMMANDS = (DataStreamControl,)
ImuSignalConditioningResponse.COMMANDS = (ImuSignalConditioning,)
UartBaudRateResponse.COMMANDS = (UartBaudRate,)
DataStreamFormatResponse.COMMANDS = (DataStreamFormat,)
DevicePowerStateResponse.COMMANDS = (DevicePowerState,)
GetFilterBaseRateResponse.COMMANDS = (GetFilterBaseRate,)
ImuLowPassFilterResponse.COMMANDS = (ImuLowPassFilter,)
NmeaMessageFormatResponse.COMMANDS = (NmeaMessageFormat,)
GetBaseRateResponse.COMMANDS = (GetBaseRate,)
MessageFormatResponse.COMMANDS = (MessageFormat,)
DeviceStatusBasicRq1ImuResponse.COMMANDS = (DeviceStatus,)
DeviceStatusBasicResponse.COMMANDS = (DeviceStatus,)
DeviceStatusBasicWithoutStateResponse.COMMANDS = (DeviceStatus,)
DeviceStatusDiagnosticResponse.COMMANDS = (DeviceStatus,)
DeviceStatusDiagnosticGnssResponse.COMMANDS = (DeviceStatus,)
DeviceStatusDiagnosticGq4_45Response.COMMANDS = (DeviceStatus,)
DeviceStatusDiagnosticRq1_45Response.COMMANDS = (DeviceStatus,)
DeviceStatusDiagnosticGx4Response.COMMANDS = (DeviceStatus,)
DeviceStatusDiagnosticImuResponse.COMMANDS = (DeviceStatus,)
DeviceStatusDiagnosticGx4ImuResponse.COMMANDS = (DeviceStatus,)
DeviceStatusDiagnosticRq1ImuResponse.COMMANDS = (DeviceStatus,)
DeviceStatusBasicGx3Response.COMMANDS = (DeviceStatus,)
DeviceStatusDiagnosticGx3Response.COMMANDS = (DeviceStatus,)
GpsDynamicsModeResponse.COMMANDS = (GpsDynamicsMode,)
ImuTimestampResponse.COMMANDS = (ImuTimestamp,)
ComplementaryFilterResponse.COMMANDS = (ComplementaryFilter,)
AccelBiasResponse.COMMANDS = (AccelBias,)
GyroBiasResponse.COMMANDS = (GyroBias, CaptureGyroBias)
MagHardIronOffsetResponse.COMMANDS = (MagHardIronOffset,)
MagSoftIronMatrixResponse.COMMANDS = (MagSoftIronMatrix,)
ConingScullingEnableResponse.COMMANDS = (ConingScullingEnable,)
ConstellationSettingsResponse.COMMANDS = (ConstellationSettings,)
GnssSbasSettingsResponse.COMMANDS = (GnssSbasSettings,)
GnssAssistedFixResponse.COMMANDS = (GnssAssistedFix,)
GnssTimeAssistanceResponse.COMMANDS = (GnssTimeAssistance,)
PpsSourceControlResponse.COMMANDS = (PpsSourceControl,)
SensorToVehicleTransformEulerResponse.COMMANDS = (SensorToVehicleTransformEuler,)
SensorToVehicleTransformQuaternionResponse.COMMANDS = (SensorToVehicleTransformQuaternion,)
SensorToVehicleTransformDcmResponse.COMMANDS = (SensorToVehicleTransformDcm,)
GetEventSupportResponse.COMMANDS = (GetEventSupport,)
EventControlResponse.COMMANDS = (EventControl,)
GetEventTriggerStatusResponse.COMMANDS = (GetEventTriggerStatus,)
GetEventActionStatusResponse.COMMANDS = (GetEventActionStatus,)
EventTriggerConfigResponse.COMMANDS = (EventTriggerConfig,)
EventActionConfigResponse.COMMANDS = (EventActionConfig,)
GpioConfigResponse.COMMANDS = (GpioConfig,)
GpioStateResponse.COMMANDS = (GpioState,)
OdometerConfigResponse.COMMANDS = (OdometerConfig,)
SensorRangeResponse.COMMANDS = (SensorRange,)
GetCalibratedSensorRangesResponse.COMMANDS = (GetCalibratedSensorRanges,)
LowPassFilterResponse.COMMANDS = (LowPassFilter,)

#: Descriptor -> its types; several if constants or the size of the data distinguish layouts.
FIELDS: dict[int, tuple[type[Field], ...]] = {
    0x01: (PollImuData,),
    0x02: (PollGnssData,),
    0x03: (PollFilterData,),
    0x04: (PollNmeaData,),
    0x06: (GetImuBaseRate,),
    0x07: (GetGnssBaseRate,),
    0x08: (ImuMessageFormat,),
    0x09: (GnssMessageFormat,),
    0x0A: (FilterMessageFormat,),
    0x0B: (GetFilterBaseRate,),
    0x0C: (NmeaMessageFormat,),
    0x0D: (PollData,),
    0x0E: (GetBaseRate,),
    0x0F: (MessageFormat,),
    0x10: (FactoryStreaming,),
    0x11: (DataStreamControl,),
    0x20: (RawRtcm2_3Message,),
    0x21: (ConstellationSettings,),
    0x22: (GnssSbasSettings,),
    0x23: (GnssAssistedFix,),
    0x24: (GnssTimeAssistance,),
    0x28: (PpsSourceControl,),
    0x2A: (GetEventSupport,),
    0x2B: (EventControl,),
    0x2C: (GetEventTriggerStatus,),
    0x2D: (GetEventActionStatus,),
    0x2E: (EventTriggerConfig,),
    0x2F: (EventActionConfig,),
    0x30: (DeviceSettings,),
    0x31: (SensorToVehicleTransformEuler,),
    0x32: (SensorToVehicleTransformQuaternion,),
    0x33: (SensorToVehicleTransformDcm,),
    0x34: (GpsDynamicsMode,),
    0x35: (ImuSignalConditioning,),
    0x36: (ImuTimestamp,),
    0x37: (AccelBias,),
    0x38: (GyroBias,),
    0x39: (CaptureGyroBias,),
    0x3A: (MagHardIronOffset,),
    0x3B: (MagSoftIronMatrix,),
    0x3E: (ConingScullingEnable,),
    0x40: (UartBaudRate,),
    0x41: (GpioConfig,),
    0x42: (GpioState,),
    0x43: (OdometerConfig,),
    0x50: (ImuLowPassFilter,),
    0x51: (ComplementaryFilter,),
    0x52: (SensorRange,),
    0x53: (GetCalibratedSensorRanges,),
    0x54: (LowPassFilter,),
    0x60: (DataStreamFormat,),
    0x61: (DevicePowerState,),
    0x62: (GpsAdvancedSettings,),
    0x64: (DeviceStatus,),
    0x80: (ImuMessageFormatResponse,),
    0x81: (GnssMessageFormatResponse,),
    0x82: (FilterMessageFormatResponse,),
    0x83: (GetImuBaseRateResponse,),
    0x84: (GetGnssBaseRateResponse,),
    0x85: (DataStreamControlResponse,),
    0x86: (ImuSignalConditioningResponse,),
    0x87: (UartBaudRateResponse,),
    0x88: (DataStreamFormatResponse,),
    0x89: (DevicePowerStateResponse,),
    0x8A: (GetFilterBaseRateResponse,),
    0x8B: (ImuLowPassFilterResponse,),
    0x8C: (NmeaMessageFormatResponse,),
    0x8E: (GetBaseRateResponse,),
    0x8F: (MessageFormatResponse,),
    0x90: (
        DeviceStatusBasicRq1ImuResponse,
        DeviceStatusBasicResponse,
        DeviceStatusBasicWithoutStateResponse,
        DeviceStatusDiagnosticResponse,
        DeviceStatusDiagnosticGnssResponse,
        DeviceStatusDiagnosticGq4_45Response,
        DeviceStatusDiagnosticRq1_45Response,
        DeviceStatusDiagnosticGx4Response,
        DeviceStatusDiagnosticImuResponse,
        DeviceStatusDiagnosticGx4ImuResponse,
        DeviceStatusDiagnosticRq1ImuResponse,
        DeviceStatusBasicGx3Response,
        DeviceStatusDiagnosticGx3Response,
    ),
    0x92: (GpsDynamicsModeResponse,),
    0x93: (ImuTimestampResponse,),
    0x97: (ComplementaryFilterResponse,),
    0x9A: (AccelBiasResponse,),
    0x9B: (GyroBiasResponse,),
    0x9C: (MagHardIronOffsetResponse,),
    0x9D: (MagSoftIronMatrixResponse,),
    0x9E: (ConingScullingEnableResponse,),
    0xA0: (ConstellationSettingsResponse,),
    0xA1: (GnssSbasSettingsResponse,),
    0xA2: (GnssAssistedFixResponse,),
    0xA3: (GnssTimeAssistanceResponse,),
    0xA8: (PpsSourceControlResponse,),
    0xB1: (SensorToVehicleTransformEulerResponse,),
    0xB2: (SensorToVehicleTransformQuaternionResponse,),
    0xB3: (SensorToVehicleTransformDcmResponse,),
    0xB4: (GetEventSupportResponse,),
    0xB5: (EventControlResponse,),
    0xB6: (GetEventTriggerStatusResponse,),
    0xB7: (GetEventActionStatusResponse,),
    0xB8: (EventTriggerConfigResponse,),
    0xB9: (EventActionConfigResponse,),
    0xC1: (GpioConfigResponse,),
    0xC2: (GpioStateResponse,),
    0xC3: (OdometerConfigResponse,),
    0xD2: (SensorRangeResponse,),
    0xD3: (GetCalibratedSensorRangesResponse,),
    0xD4: (LowPassFilterResponse,),
}
