"""Filter commands (0x0D).

Commands that set up, start and aid the navigation filter.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import IntFlag

from . import codec, types
from .errors import Truncated
from .field import Command, Field, Response
from .protocol import FunctionSelector


@codec.open_flag(16)
class EstimatedStates(IntFlag):
    """States that the filter estimates."""

    GYRO_BIAS = 1 << 0
    """Estimate the gyroscope bias (recommended)."""


class GnssAidingSource(codec.OpenEnum):
    """Where the filter takes GNSS data from."""

    ALL_INT = 1
    """All internal receivers."""
    EXT = 2
    """GNSS measurements that the user sends."""
    INT_1 = 3
    """Internal receiver 1 only."""
    INT_2 = 4
    """Internal receiver 2 only."""


class HeadingType(codec.OpenEnum):
    """The north that a heading refers to."""

    TRUE_HEADING = 1
    """True north."""
    MAGNETIC_HEADING = 2
    """Magnetic north."""


class HeadingUpdateSource(codec.OpenEnum):
    """Where the filter takes heading updates from."""

    NONE = 0
    """No heading updates."""
    EXTERNAL = 3
    """The heading messages that the user sends."""


@codec.open_flag(8)
class TareAxes(IntFlag):
    """Axes to tare; 0 resets all axes."""

    ROLL = 1 << 0
    """Tare roll."""
    PITCH = 1 << 1
    """Tare pitch."""
    YAW = 1 << 2
    """Tare yaw."""


@codec.open_flag(16)
class MeasurementFlags(IntFlag):
    """Measurements that the filter uses."""

    ACCELEROMETER = 1 << 0
    """Accelerometer measurements."""
    MAGNETOMETER = 1 << 1
    """Magnetometer measurements, on models that have a magnetometer."""


class DeclinationSource(codec.OpenEnum):
    """Where the declination of the magnetic field comes from."""

    NONE = 1
    """No source."""
    WMM = 2
    """The World Magnetic Model, at the estimated position."""
    MANUAL = 3
    """The angle that the command gives."""


class AdaptiveMeasurementSelector(codec.OpenEnum):
    """How measurements of the gravity direction are weighted."""

    DISABLED = 0
    """No adaptation."""
    FIXED = 1
    """Adapted by the limits that the command gives."""
    AUTO = 2
    """Adapted by the filter itself; the limits are ignored. 3DM-GX5 and later."""


class PitchRollAidingSource(codec.OpenEnum):
    """What aids pitch and roll."""

    NONE = 0
    """No aiding."""
    GRAVITY_VECTOR = 1
    """The measured gravity vector."""


class AidingSource(codec.OpenEnum):
    """A source of aiding measurements."""

    GNSS_POS_VEL = 0
    """GNSS position and velocity."""
    GNSS_HEADING = 1
    """GNSS heading of two antennas."""
    ALTIMETER = 2
    """Built-in pressure altimeter."""
    SPEED = 3
    """Speed sensor or odometer."""
    MAGNETOMETER = 4
    """Built-in magnetometer."""
    EXTERNAL_HEADING = 5
    """Heading that the user sends."""
    EXTERNAL_ALTIMETER = 6
    """Pressure altitude that the user sends."""
    EXTERNAL_MAGNETOMETER = 7
    """Magnetic field that the user sends."""
    BODY_FRAME_VEL = 8
    """Velocity in the vehicle that the user sends."""
    ALL = 0xFFFF
    """All sources, for save, load and default."""


class InitialConditionSource(codec.OpenEnum):
    """Which initial conditions the device finds itself and which the user gives."""

    AUTO_POS_VEL_ATT = 0
    """Position, velocity and attitude are found."""
    AUTO_POS_VEL_PITCH_ROLL = 1
    """Position, velocity, pitch and roll are found; the heading is given."""
    AUTO_POS_VEL = 2
    """Position and velocity are found; the attitude is given."""
    MANUAL = 3
    """Position, velocity and attitude are given."""


@codec.open_flag(8)
class HeadingAlignment(IntFlag):
    """Ways in which the device may find its initial heading."""

    DUAL_ANTENNA = 1 << 0
    """From the baseline between two GNSS antennas."""
    KINEMATIC = 1 << 1
    """From the GNSS velocity; assumes motion along the positive x axis of the vehicle."""
    MAGNETOMETER = 1 << 2
    """From the built-in magnetometer."""
    EXTERNAL = 1 << 3
    """From the heading that the user sends."""


class ReferenceFrame(codec.OpenEnum):
    """Frame in which a position is given."""

    ECEF = 1
    """Earth-centred, Earth-fixed coordinates (WGS84)."""
    LLH = 2
    """Latitude, longitude and height above the ellipsoid (WGS84)."""


class AdaptiveLevel(codec.OpenEnum):
    """How strongly the filter adapts to measurements that do not fit."""

    OFF = 0
    """No adaptation."""
    CONSERVATIVE = 1
    """Little adaptation."""
    MODERATE = 2
    """Moderate adaptation."""
    AGGRESSIVE = 3
    """Strong adaptation."""


class RelativePositionSource(codec.OpenEnum):
    """Where the reference of relative positions comes from."""

    AUTO = 0
    """The base station of the RTK corrections."""
    MANUAL = 1
    """The coordinates that the command gives."""


class ReferencePoint(codec.OpenEnum):
    """A point of reference."""

    VEH = 1
    """The origin of the vehicle."""


_SENSOR_TO_VEHICLE_FRAME_TRANSFORMATION_RESPONSE_0 = codec.Block("fff", "roll", "pitch", "yaw")


@dataclass(slots=True)
class SensorToVehicleFrameTransformationResponse(Response):
    """Sensor to vehicle frame transformation response (0x0D,0x81).

    Answers Sensor to vehicle frame transformation (0x0D,0x11).
    Supported by 3DM-GX5-15.

    - 3dm-gx5-15: 4.3.4 Sensor to Vehicle Frame Transformation (0x0D, 0x11)
    """

    SET = 0x0D
    DESCRIPTOR = 0x81
    NAME = "filter.sensor_to_vehicle_frame_transformation_response"
    ROLE = "response"

    roll: float
    """Roll angle. [rad]"""
    pitch: float
    """Pitch angle. [rad]"""
    yaw: float
    """Yaw angle. [rad]"""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[SensorToVehicleFrameTransformationResponse, int]:
        v = _SENSOR_TO_VEHICLE_FRAME_TRANSFORMATION_RESPONSE_0.read(raw, at)
        at += 12
        roll = v[0]
        pitch = v[1]
        yaw = v[2]
        return cls(roll, pitch, yaw), at

    def _write(self) -> bytes:
        out = _SENSOR_TO_VEHICLE_FRAME_TRANSFORMATION_RESPONSE_0.write(
            self.roll, self.pitch, self.yaw
        )
        return codec.finished(out)


_GNSS_ANTENNA_OFFSET_CONTROL_RESPONSE_0 = codec.Block("fff", "offset", "offset", "offset")


@dataclass(slots=True)
class GnssAntennaOffsetControlResponse(Response):
    """GNSS antenna offset response (0x0D,0x83).

    Answers GNSS antenna offset (0x0D,0x13).
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: GNSS Antenna Offset Control (0x0D,0x13)
    """

    SET = 0x0D
    DESCRIPTOR = 0x83
    NAME = "filter.gnss_antenna_offset_control_response"
    ROLE = "response"

    offset: types.Vector3f
    """From the sensor origin to the centre of the antenna. [m] Frame: vehicle. Range: -10 to 10."""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GnssAntennaOffsetControlResponse, int]:
        v = _GNSS_ANTENNA_OFFSET_CONTROL_RESPONSE_0.read(raw, at)
        at += 12
        offset = v[0:3]
        return cls(offset), at

    def _write(self) -> bytes:
        out = _GNSS_ANTENNA_OFFSET_CONTROL_RESPONSE_0.write(
            *codec.exactly("offset", self.offset, 3)
        )
        return codec.finished(out)


_ESTIMATION_CONTROL_FLAGS_RESPONSE_0 = codec.Block("H", "flags")


@dataclass(slots=True)
class EstimationControlFlagsResponse(Response):
    """Estimation control flags response (0x0D,0x84).

    Answers Estimation control flags (0x0D,0x14).
    Supported by 3DM-GX5-15.

    - 3dm-gx5-15: 4.3.5 Estimation Control Flags (0x0D, 0x14)
    """

    SET = 0x0D
    DESCRIPTOR = 0x84
    NAME = "filter.estimation_control_flags_response"
    ROLE = "response"

    flags: EstimatedStates
    """States to estimate."""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[EstimationControlFlagsResponse, int]:
        v = _ESTIMATION_CONTROL_FLAGS_RESPONSE_0.read(raw, at)
        at += 2
        flags = EstimatedStates(v[0])
        return cls(flags), at

    def _write(self) -> bytes:
        out = _ESTIMATION_CONTROL_FLAGS_RESPONSE_0.write(self.flags)
        return codec.finished(out)


_GNSS_AIDING_SOURCE_CONTROL_RESPONSE_0 = codec.Block("B", "source")


@dataclass(slots=True)
class GnssAidingSourceControlResponse(Response):
    """GNSS aiding source response (0x0D,0x86).

    Answers GNSS aiding source (0x0D,0x15).
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: GNSS Aiding Source Control (0x0D,0x15)
    """

    SET = 0x0D
    DESCRIPTOR = 0x86
    NAME = "filter.gnss_aiding_source_control_response"
    ROLE = "response"

    source: GnssAidingSource
    """Source of the GNSS data."""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GnssAidingSourceControlResponse, int]:
        v = _GNSS_AIDING_SOURCE_CONTROL_RESPONSE_0.read(raw, at)
        at += 1
        source = GnssAidingSource(v[0])
        return cls(source), at

    def _write(self) -> bytes:
        out = _GNSS_AIDING_SOURCE_CONTROL_RESPONSE_0.write(self.source)
        return codec.finished(out)


_HEADING_UPDATE_CONTROL_RESPONSE_0 = codec.Block("B", "enable")


@dataclass(slots=True)
class HeadingUpdateControlResponse(Response):
    """Heading update control response (0x0D,0x87).

    Answers Heading update control (0x0D,0x18).
    Supported by 3DM-GX5-15.

    - 3dm-gx5-15: 4.3.6 Heading Update Control (0x0D, 0x18)
    """

    SET = 0x0D
    DESCRIPTOR = 0x87
    NAME = "filter.heading_update_control_response"
    ROLE = "response"

    enable: HeadingUpdateSource
    """Source of the heading."""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[HeadingUpdateControlResponse, int]:
        v = _HEADING_UPDATE_CONTROL_RESPONSE_0.read(raw, at)
        at += 1
        enable = HeadingUpdateSource(v[0])
        return cls(enable), at

    def _write(self) -> bytes:
        out = _HEADING_UPDATE_CONTROL_RESPONSE_0.write(self.enable)
        return codec.finished(out)


_AUTO_INITIALIZATION_CONTROL_RESPONSE_0 = codec.Block("B", "enable")


@dataclass(slots=True)
class AutoInitializationControlResponse(Response):
    """Automatic initialization response (0x0D,0x88).

    Answers Automatic initialization (0x0D,0x19).
    Supported by 3DM-GX5-15.

    - 3dm-gx5-15: 4.3.10 Auto-Initialization Control (0x0D, 0x19)
    """

    SET = 0x0D
    DESCRIPTOR = 0x88
    NAME = "filter.auto_initialization_control_response"
    ROLE = "response"

    enable: int
    """0 disables, 1 enables. Range: 0 to 1."""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[AutoInitializationControlResponse, int]:
        v = _AUTO_INITIALIZATION_CONTROL_RESPONSE_0.read(raw, at)
        at += 1
        enable = v[0]
        return cls(enable), at

    def _write(self) -> bytes:
        out = _AUTO_INITIALIZATION_CONTROL_RESPONSE_0.write(self.enable)
        return codec.finished(out)


_ACCELEROMETER_NOISE_STANDARD_DEVIATION_RESPONSE_0 = codec.Block("fff", "noise", "noise", "noise")


@dataclass(slots=True)
class AccelerometerNoiseStandardDeviationResponse(Response):
    """Accelerometer noise response (0x0D,0x89).

    Answers Accelerometer noise (0x0D,0x1A).
    Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.

    - 3dm-cv7-gnss-ins: Accelerometer Noise Standard Deviation (0x0D,0x1A)
    - 3dm-gx5-15: 4.3.12 Accelerometer Noise Standard Deviation (0x0D, 0x1A)
    """

    SET = 0x0D
    DESCRIPTOR = 0x89
    NAME = "filter.accelerometer_noise_standard_deviation_response"
    ROLE = "response"

    noise: types.Vector3f
    """Standard deviation per axis. [m/s^2]"""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[AccelerometerNoiseStandardDeviationResponse, int]:
        v = _ACCELEROMETER_NOISE_STANDARD_DEVIATION_RESPONSE_0.read(raw, at)
        at += 12
        noise = v[0:3]
        return cls(noise), at

    def _write(self) -> bytes:
        out = _ACCELEROMETER_NOISE_STANDARD_DEVIATION_RESPONSE_0.write(
            *codec.exactly("noise", self.noise, 3)
        )
        return codec.finished(out)


_GYROSCOPE_NOISE_STANDARD_DEVIATION_RESPONSE_0 = codec.Block("fff", "noise", "noise", "noise")


@dataclass(slots=True)
class GyroscopeNoiseStandardDeviationResponse(Response):
    """Gyroscope noise response (0x0D,0x8A).

    Answers Gyroscope noise (0x0D,0x1B).
    Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.

    - 3dm-cv7-gnss-ins: Gyroscope Noise Standard Deviation (0x0D,0x1B)
    - 3dm-gx5-15: 4.3.13 Gyroscope Noise Standard Deviation (0x0D, 0x1B)
    """

    SET = 0x0D
    DESCRIPTOR = 0x8A
    NAME = "filter.gyroscope_noise_standard_deviation_response"
    ROLE = "response"

    noise: types.Vector3f
    """Standard deviation per axis. [rad/s]"""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GyroscopeNoiseStandardDeviationResponse, int]:
        v = _GYROSCOPE_NOISE_STANDARD_DEVIATION_RESPONSE_0.read(raw, at)
        at += 12
        noise = v[0:3]
        return cls(noise), at

    def _write(self) -> bytes:
        out = _GYROSCOPE_NOISE_STANDARD_DEVIATION_RESPONSE_0.write(
            *codec.exactly("noise", self.noise, 3)
        )
        return codec.finished(out)


_ACCELEROMETER_BIAS_MODEL_PARAMETERS_RESPONSE_0 = codec.Block(
    "ffffff", "beta", "beta", "beta", "noise", "noise", "noise"
)


@dataclass(slots=True)
class AccelerometerBiasModelParametersResponse(Response):
    """Accelerometer bias model response (0x0D,0x8B).

    Answers Accelerometer bias model (0x0D,0x1C).
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Accelerometer Bias Model Parameters (0x0D,0x1C)
    """

    SET = 0x0D
    DESCRIPTOR = 0x8B
    NAME = "filter.accelerometer_bias_model_parameters_response"
    ROLE = "response"

    beta: types.Vector3f
    """Reciprocal of the correlation time per axis. [1/s]"""
    noise: types.Vector3f
    """Standard deviation of the noise per axis. [m/s^2]"""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[AccelerometerBiasModelParametersResponse, int]:
        v = _ACCELEROMETER_BIAS_MODEL_PARAMETERS_RESPONSE_0.read(raw, at)
        at += 24
        beta = v[0:3]
        noise = v[3:6]
        return cls(beta, noise), at

    def _write(self) -> bytes:
        out = _ACCELEROMETER_BIAS_MODEL_PARAMETERS_RESPONSE_0.write(
            *codec.exactly("beta", self.beta, 3), *codec.exactly("noise", self.noise, 3)
        )
        return codec.finished(out)


_GYROSCOPE_BIAS_MODEL_PARAMETERS_RESPONSE_0 = codec.Block(
    "ffffff", "beta", "beta", "beta", "noise", "noise", "noise"
)


@dataclass(slots=True)
class GyroscopeBiasModelParametersResponse(Response):
    """Gyroscope bias model response (0x0D,0x8C).

    Answers Gyroscope bias model (0x0D,0x1D).
    Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.

    - 3dm-cv7-gnss-ins: Gyroscope Bias Model Parameters (0x0D,0x1D)
    - 3dm-gx5-15: 4.3.14 Gyroscope Bias Model Parameters (0x0D, 0x1D)
    """

    SET = 0x0D
    DESCRIPTOR = 0x8C
    NAME = "filter.gyroscope_bias_model_parameters_response"
    ROLE = "response"

    beta: types.Vector3f
    """Reciprocal of the correlation time per axis. [1/s]"""
    noise: types.Vector3f
    """Standard deviation of the noise per axis. [rad/s]"""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GyroscopeBiasModelParametersResponse, int]:
        v = _GYROSCOPE_BIAS_MODEL_PARAMETERS_RESPONSE_0.read(raw, at)
        at += 24
        beta = v[0:3]
        noise = v[3:6]
        return cls(beta, noise), at

    def _write(self) -> bytes:
        out = _GYROSCOPE_BIAS_MODEL_PARAMETERS_RESPONSE_0.write(
            *codec.exactly("beta", self.beta, 3), *codec.exactly("noise", self.noise, 3)
        )
        return codec.finished(out)


_ZERO_ANGULAR_RATE_UPDATE_CONTROL_RESPONSE_0 = codec.Block("Bf", "enable", "threshold")


@dataclass(slots=True)
class ZeroAngularRateUpdateControlResponse(Response):
    """Zero angular rate update response (0x0D,0x8E).

    Answers Zero angular rate update (0x0D,0x20).
    Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.

    - 3dm-cv7-gnss-ins: Zero Angular Rate Update Control (0x0D,0x20)
    - 3dm-gx5-15: 4.3.15 Zero Angular Rate Update Control (0x0D, 0x20)
    """

    SET = 0x0D
    DESCRIPTOR = 0x8E
    NAME = "filter.zero_angular_rate_update_control_response"
    ROLE = "response"

    enable: int
    """0 disables, 1 enables. Range: 0 to 1."""
    threshold: float
    """Largest angular rate that is taken as zero. [rad/s] Range: 0 to …."""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[ZeroAngularRateUpdateControlResponse, int]:
        v = _ZERO_ANGULAR_RATE_UPDATE_CONTROL_RESPONSE_0.read(raw, at)
        at += 5
        enable = v[0]
        threshold = v[1]
        return cls(enable, threshold), at

    def _write(self) -> bytes:
        out = _ZERO_ANGULAR_RATE_UPDATE_CONTROL_RESPONSE_0.write(self.enable, self.threshold)
        return codec.finished(out)


_SET_REFERENCE_POSITION_RESPONSE_0 = codec.Block(
    "Bddd", "enable", "latitude", "longitude", "altitude"
)


@dataclass(slots=True)
class SetReferencePositionResponse(Response):
    """Set reference position response (0x0D,0x90).

    Answers Set reference position (0x0D,0x26).
    Supported by 3DM-GX5-15.

    - 3dm-gx5-15: 4.3.20 Set Reference Position (0x0D, 0x26)
    """

    SET = 0x0D
    DESCRIPTOR = 0x90
    NAME = "filter.set_reference_position_response"
    ROLE = "response"

    enable: int
    """0 disables, 1 enables. Range: 0 to 1."""
    latitude: float
    """Latitude. [deg] Frame: llh."""
    longitude: float
    """Longitude. [deg] Frame: llh."""
    altitude: float
    """Altitude. [m] Frame: llh."""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[SetReferencePositionResponse, int]:
        v = _SET_REFERENCE_POSITION_RESPONSE_0.read(raw, at)
        at += 25
        enable = v[0]
        latitude = v[1]
        longitude = v[2]
        altitude = v[3]
        return cls(enable, latitude, longitude, altitude), at

    def _write(self) -> bytes:
        out = _SET_REFERENCE_POSITION_RESPONSE_0.write(
            self.enable, self.latitude, self.longitude, self.altitude
        )
        return codec.finished(out)


_GRAVITY_NOISE_STANDARD_DEVIATION_RESPONSE_0 = codec.Block("fff", "noise", "noise", "noise")


@dataclass(slots=True)
class GravityNoiseStandardDeviationResponse(Response):
    """Gravity noise response (0x0D,0x93).

    Answers Gravity noise (0x0D,0x28).
    Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.

    - 3dm-cv7-gnss-ins: Gravity Noise Standard Deviation (0x0D,0x28)
    - 3dm-gx5-15: 4.3.11 Gravity Noise Standard Deviation (0x0D, 0x28)
    """

    SET = 0x0D
    DESCRIPTOR = 0x93
    NAME = "filter.gravity_noise_standard_deviation_response"
    ROLE = "response"

    noise: types.Vector3f
    """Standard deviation per axis. [g]"""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GravityNoiseStandardDeviationResponse, int]:
        v = _GRAVITY_NOISE_STANDARD_DEVIATION_RESPONSE_0.read(raw, at)
        at += 12
        noise = v[0:3]
        return cls(noise), at

    def _write(self) -> bytes:
        out = _GRAVITY_NOISE_STANDARD_DEVIATION_RESPONSE_0.write(
            *codec.exactly("noise", self.noise, 3)
        )
        return codec.finished(out)


_ENABLE_DISABLE_MEASUREMENTS_RESPONSE_0 = codec.Block("H", "control")


@dataclass(slots=True)
class EnableDisableMeasurementsResponse(Response):
    """Enable or disable measurements response (0x0D,0xB0).

    Answers Enable or disable measurements (0x0D,0x41).
    Supported by 3DM-GX5-15.

    - 3dm-gx5-15: 4.3.18 Enable/Disable Measurements (0x0D, 0x41)
    """

    SET = 0x0D
    DESCRIPTOR = 0xB0
    NAME = "filter.enable_disable_measurements_response"
    ROLE = "response"

    control: MeasurementFlags
    """Measurements to use."""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[EnableDisableMeasurementsResponse, int]:
        v = _ENABLE_DISABLE_MEASUREMENTS_RESPONSE_0.read(raw, at)
        at += 2
        control = MeasurementFlags(v[0])
        return cls(control), at

    def _write(self) -> bytes:
        out = _ENABLE_DISABLE_MEASUREMENTS_RESPONSE_0.write(self.control)
        return codec.finished(out)


_MAGNETIC_FIELD_DECLINATION_SOURCE_CONTROL_RESPONSE_0 = codec.Block("Bf", "source", "declination")


@dataclass(slots=True)
class MagneticFieldDeclinationSourceControlResponse(Response):
    """Magnetic declination source response (0x0D,0xB2).

    Answers Magnetic declination source (0x0D,0x43).
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Magnetic Field Declination Source Control (0x0D,0x43)
    """

    SET = 0x0D
    DESCRIPTOR = 0xB2
    NAME = "filter.magnetic_field_declination_source_control_response"
    ROLE = "response"

    source: DeclinationSource
    """Source of the declination."""
    declination: float
    """Declination; used only if `source` is manual. [rad]"""

    @classmethod
    def _read(
        cls, raw: bytes, at: int
    ) -> tuple[MagneticFieldDeclinationSourceControlResponse, int]:
        v = _MAGNETIC_FIELD_DECLINATION_SOURCE_CONTROL_RESPONSE_0.read(raw, at)
        at += 5
        source = DeclinationSource(v[0])
        declination = v[1]
        return cls(source, declination), at

    def _write(self) -> bytes:
        out = _MAGNETIC_FIELD_DECLINATION_SOURCE_CONTROL_RESPONSE_0.write(
            self.source, self.declination
        )
        return codec.finished(out)


_GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_RESPONSE_0 = codec.Block(
    "Bffffff",
    "adaptive_measurement",
    "frequency",
    "low_limit",
    "high_limit",
    "low_limit_uncertainty",
    "high_limit_uncertainty",
    "minimum_uncertainty",
)


@dataclass(slots=True)
class GravityMagnitudeErrorAdaptiveMeasurementResponse(Response):
    """Gravity magnitude error adaptive measurement response (0x0D,0xB3).

    Answers Gravity magnitude error adaptive measurement (0x0D,0x44).
    Supported by 3DM-GX5-15.

    - 3dm-gx5-15: 4.3.19 Gravity Magnitude Error Adaptive Measurement (0x0D, 0x44)
    """

    SET = 0x0D
    DESCRIPTOR = 0xB3
    NAME = "filter.gravity_magnitude_error_adaptive_measurement_response"
    ROLE = "response"

    adaptive_measurement: AdaptiveMeasurementSelector
    """Kind of adaptation."""
    frequency: float
    """Cut-off frequency of the low-pass filter. [Hz]"""
    low_limit: float
    """Lower limit of the error. [m/s^2]"""
    high_limit: float
    """Upper limit of the error. [m/s^2]"""
    low_limit_uncertainty: float
    """Standard deviation at the lower limit. [m/s^2]"""
    high_limit_uncertainty: float
    """Standard deviation at the upper limit. [m/s^2]"""
    minimum_uncertainty: float
    """Smallest standard deviation. [m/s^2]"""

    @classmethod
    def _read(
        cls, raw: bytes, at: int
    ) -> tuple[GravityMagnitudeErrorAdaptiveMeasurementResponse, int]:
        v = _GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_RESPONSE_0.read(raw, at)
        at += 25
        adaptive_measurement = AdaptiveMeasurementSelector(v[0])
        frequency = v[1]
        low_limit = v[2]
        high_limit = v[3]
        low_limit_uncertainty = v[4]
        high_limit_uncertainty = v[5]
        minimum_uncertainty = v[6]
        return cls(
            adaptive_measurement,
            frequency,
            low_limit,
            high_limit,
            low_limit_uncertainty,
            high_limit_uncertainty,
            minimum_uncertainty,
        ), at

    def _write(self) -> bytes:
        out = _GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_RESPONSE_0.write(
            self.adaptive_measurement,
            self.frequency,
            self.low_limit,
            self.high_limit,
            self.low_limit_uncertainty,
            self.high_limit_uncertainty,
            self.minimum_uncertainty,
        )
        return codec.finished(out)


_PITCH_ROLL_AIDING_CONTROL_RESPONSE_0 = codec.Block("B", "aiding")


@dataclass(slots=True)
class PitchRollAidingControlResponse(Response):
    """Pitch and roll aiding response (0x0D,0xBB).

    Answers Pitch and roll aiding (0x0D,0x4B).
    Supported by 3DM-GX5-15.

    - 3dm-gx5-15: 4.3.9 Pitch/Roll Aiding Control (0x0D, 0x4B)
    """

    SET = 0x0D
    DESCRIPTOR = 0xBB
    NAME = "filter.pitch_roll_aiding_control_response"
    ROLE = "response"

    aiding: PitchRollAidingSource
    """Source of the aiding."""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[PitchRollAidingControlResponse, int]:
        v = _PITCH_ROLL_AIDING_CONTROL_RESPONSE_0.read(raw, at)
        at += 1
        aiding = PitchRollAidingSource(v[0])
        return cls(aiding), at

    def _write(self) -> bytes:
        out = _PITCH_ROLL_AIDING_CONTROL_RESPONSE_0.write(self.aiding)
        return codec.finished(out)


_AIDING_MEASUREMENT_CONTROL_RESPONSE_0 = codec.Block("HB", "aiding_source", "enable")


@dataclass(slots=True)
class AidingMeasurementControlResponse(Response):
    """Aiding measurement control response (0x0D,0xD0).

    Answers Aiding measurement control (0x0D,0x50).
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Aiding Measurement Control (0x0D,0x50)
    """

    SET = 0x0D
    DESCRIPTOR = 0xD0
    NAME = "filter.aiding_measurement_control_response"
    ROLE = "response"

    aiding_source: AidingSource
    """The source; `all` is for save, load and default."""
    enable: bool
    """Whether the filter uses the source."""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[AidingMeasurementControlResponse, int]:
        v = _AIDING_MEASUREMENT_CONTROL_RESPONSE_0.read(raw, at)
        at += 3
        aiding_source = AidingSource(v[0])
        enable = codec.truth(v[1])
        return cls(aiding_source, enable), at

    def _write(self) -> bytes:
        out = _AIDING_MEASUREMENT_CONTROL_RESPONSE_0.write(self.aiding_source, self.enable)
        return codec.finished(out)


_NAVIGATION_FILTER_INITIALIZATION_RESPONSE_0 = codec.Block(
    "BBBfffffffffB",
    "wait_for_run_command",
    "initial_cond_src",
    "auto_heading_alignment_selector",
    "initial_heading",
    "initial_pitch",
    "initial_roll",
    "initial_position",
    "initial_position",
    "initial_position",
    "initial_velocity",
    "initial_velocity",
    "initial_velocity",
    "reference_frame_selector",
)


@dataclass(slots=True)
class NavigationFilterInitializationResponse(Response):
    """Navigation filter initialization response (0x0D,0xD2).

    Answers Navigation filter initialization (0x0D,0x52).
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Navigation Filter Initialization (0x0D,0x52)
    """

    SET = 0x0D
    DESCRIPTOR = 0xD2
    NAME = "filter.navigation_filter_initialization_response"
    ROLE = "response"

    wait_for_run_command: int
    """1: the filter starts only after `run_navigation_filter`; 0: as soon as it can. Range: 0 to
    1.
    """
    initial_cond_src: InitialConditionSource
    """Which initial conditions are found and which are given."""
    auto_heading_alignment_selector: HeadingAlignment
    """Ways in which the initial heading may be found."""
    initial_heading: float
    """Given heading. [deg]"""
    initial_pitch: float
    """Given pitch. [deg]"""
    initial_roll: float
    """Given roll. [deg]"""
    initial_position: types.Vector3f
    """Given position. If reference_frame_selector is ecef: unit m, frame ecef. If
    reference_frame_selector is llh: unit deg, deg, m, frame llh.
    """
    initial_velocity: types.Vector3f
    """Given velocity. [m/s] If reference_frame_selector is ecef: frame ecef. If
    reference_frame_selector is llh: frame ned.
    """
    reference_frame_selector: ReferenceFrame
    """Frame of the given position and velocity."""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[NavigationFilterInitializationResponse, int]:
        v = _NAVIGATION_FILTER_INITIALIZATION_RESPONSE_0.read(raw, at)
        at += 40
        wait_for_run_command = v[0]
        initial_cond_src = InitialConditionSource(v[1])
        auto_heading_alignment_selector = HeadingAlignment(v[2])
        initial_heading = v[3]
        initial_pitch = v[4]
        initial_roll = v[5]
        initial_position = v[6:9]
        initial_velocity = v[9:12]
        reference_frame_selector = ReferenceFrame(v[12])
        return cls(
            wait_for_run_command,
            initial_cond_src,
            auto_heading_alignment_selector,
            initial_heading,
            initial_pitch,
            initial_roll,
            initial_position,
            initial_velocity,
            reference_frame_selector,
        ), at

    def _write(self) -> bytes:
        out = _NAVIGATION_FILTER_INITIALIZATION_RESPONSE_0.write(
            self.wait_for_run_command,
            self.initial_cond_src,
            self.auto_heading_alignment_selector,
            self.initial_heading,
            self.initial_pitch,
            self.initial_roll,
            *codec.exactly("initial_position", self.initial_position, 3),
            *codec.exactly("initial_velocity", self.initial_velocity, 3),
            self.reference_frame_selector,
        )
        return codec.finished(out)


_ADAPTIVE_FILTER_CONTROL_RESPONSE_0 = codec.Block("BH", "level", "time_limit")


@dataclass(slots=True)
class AdaptiveFilterControlResponse(Response):
    """Adaptive filter control response (0x0D,0xD3).

    Answers Adaptive filter control (0x0D,0x53).
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Adaptive Filter Control (0x0D,0x53)
    """

    SET = 0x0D
    DESCRIPTOR = 0xD3
    NAME = "filter.adaptive_filter_control_response"
    ROLE = "response"

    level: AdaptiveLevel
    """Strength of the adaptation. Factory default: 2."""
    time_limit: int
    """Longest time for which measurements are rejected before the filter recovers. [ms]"""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[AdaptiveFilterControlResponse, int]:
        v = _ADAPTIVE_FILTER_CONTROL_RESPONSE_0.read(raw, at)
        at += 3
        level = AdaptiveLevel(v[0])
        time_limit = v[1]
        return cls(level, time_limit), at

    def _write(self) -> bytes:
        out = _ADAPTIVE_FILTER_CONTROL_RESPONSE_0.write(self.level, self.time_limit)
        return codec.finished(out)


_GNSS_MULTI_ANTENNA_OFFSET_CONTROL_RESPONSE_0 = codec.Block(
    "Bfff", "receiver_id", "antenna_offset", "antenna_offset", "antenna_offset"
)


@dataclass(slots=True)
class GnssMultiAntennaOffsetControlResponse(Response):
    """GNSS multi-antenna offset response (0x0D,0xD4).

    Answers GNSS multi-antenna offset (0x0D,0x54).
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: GNSS Multi-Antenna Offset Control (0x0D,0x54)
    """

    SET = 0x0D
    DESCRIPTOR = 0xD4
    NAME = "filter.gnss_multi_antenna_offset_control_response"
    ROLE = "response"

    receiver_id: int
    """Number of the receiver, from 1. Range: 1 to …."""
    antenna_offset: types.Vector3f
    """From the sensor to the antenna. [m] Frame: vehicle. Range: -10 to 10."""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GnssMultiAntennaOffsetControlResponse, int]:
        v = _GNSS_MULTI_ANTENNA_OFFSET_CONTROL_RESPONSE_0.read(raw, at)
        at += 13
        receiver_id = v[0]
        antenna_offset = v[1:4]
        return cls(receiver_id, antenna_offset), at

    def _write(self) -> bytes:
        out = _GNSS_MULTI_ANTENNA_OFFSET_CONTROL_RESPONSE_0.write(
            self.receiver_id, *codec.exactly("antenna_offset", self.antenna_offset, 3)
        )
        return codec.finished(out)


_RELATIVE_POSITION_CONFIGURATION_RESPONSE_0 = codec.Block(
    "BBddd",
    "source",
    "reference_frame_selector",
    "reference_coordinates",
    "reference_coordinates",
    "reference_coordinates",
)


@dataclass(slots=True)
class RelativePositionConfigurationResponse(Response):
    """Relative position configuration response (0x0D,0xD5).

    Answers Relative position configuration (0x0D,0x55).
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Relative Position Configuration (0x0D,0x55)
    """

    SET = 0x0D
    DESCRIPTOR = 0xD5
    NAME = "filter.relative_position_configuration_response"
    ROLE = "response"

    source: RelativePositionSource
    """Source of the reference point."""
    reference_frame_selector: ReferenceFrame
    """Frame of the coordinates."""
    reference_coordinates: types.Vector3d
    """Reference point. If reference_frame_selector is ecef: unit m, frame ecef. If
    reference_frame_selector is llh: unit deg, deg, m, frame llh.
    """

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[RelativePositionConfigurationResponse, int]:
        v = _RELATIVE_POSITION_CONFIGURATION_RESPONSE_0.read(raw, at)
        at += 26
        source = RelativePositionSource(v[0])
        reference_frame_selector = ReferenceFrame(v[1])
        reference_coordinates = v[2:5]
        return cls(source, reference_frame_selector, reference_coordinates), at

    def _write(self) -> bytes:
        out = _RELATIVE_POSITION_CONFIGURATION_RESPONSE_0.write(
            self.source,
            self.reference_frame_selector,
            *codec.exactly("reference_coordinates", self.reference_coordinates, 3),
        )
        return codec.finished(out)


_REFERENCE_POINT_LEVER_ARM_RESPONSE_0 = codec.Block(
    "Bfff", "ref_point_sel", "lever_arm_offset", "lever_arm_offset", "lever_arm_offset"
)


@dataclass(slots=True)
class ReferencePointLeverArmResponse(Response):
    """Reference point lever arm response (0x0D,0xD6).

    Answers Reference point lever arm (0x0D,0x56).
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Reference point lever arm (0x0D,0x56)
    """

    SET = 0x0D
    DESCRIPTOR = 0xD6
    NAME = "filter.reference_point_lever_arm_response"
    ROLE = "response"

    ref_point_sel: ReferencePoint
    """Point to move; it must be 1."""
    lever_arm_offset: types.Vector3f
    """From the sensor to the point. [m] Frame: vehicle. Range: -10 to 10."""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[ReferencePointLeverArmResponse, int]:
        v = _REFERENCE_POINT_LEVER_ARM_RESPONSE_0.read(raw, at)
        at += 13
        ref_point_sel = ReferencePoint(v[0])
        lever_arm_offset = v[1:4]
        return cls(ref_point_sel, lever_arm_offset), at

    def _write(self) -> bytes:
        out = _REFERENCE_POINT_LEVER_ARM_RESPONSE_0.write(
            self.ref_point_sel, *codec.exactly("lever_arm_offset", self.lever_arm_offset, 3)
        )
        return codec.finished(out)


_MEASUREMENT_SPEED_LEVER_ARM_RESPONSE_0 = codec.Block(
    "Bfff", "source", "lever_arm_offset", "lever_arm_offset", "lever_arm_offset"
)


@dataclass(slots=True)
class MeasurementSpeedLeverArmResponse(Response):
    """Speed measurement lever arm response (0x0D,0xE1).

    Answers Speed measurement lever arm (0x0D,0x61).
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Measurement speed lever arm (0x0D,0x61)
    """

    SET = 0x0D
    DESCRIPTOR = 0xE1
    NAME = "filter.measurement_speed_lever_arm_response"
    ROLE = "response"

    source: int = field(default=1, kw_only=True)
    """Send 1."""
    lever_arm_offset: types.Vector3f
    """From the sensor to the point of measurement. [m] Frame: vehicle."""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[MeasurementSpeedLeverArmResponse, int]:
        v = _MEASUREMENT_SPEED_LEVER_ARM_RESPONSE_0.read(raw, at)
        at += 13
        source = v[0]
        lever_arm_offset = v[1:4]
        return cls(lever_arm_offset, source=source), at

    def _write(self) -> bytes:
        out = _MEASUREMENT_SPEED_LEVER_ARM_RESPONSE_0.write(
            self.source, *codec.exactly("lever_arm_offset", self.lever_arm_offset, 3)
        )
        return codec.finished(out)


_WHEELED_VEHICLE_CONSTRAINT_CONTROL_RESPONSE_0 = codec.Block("B", "enable")


@dataclass(slots=True)
class WheeledVehicleConstraintControlResponse(Response):
    """Wheeled vehicle constraint response (0x0D,0xE3).

    Answers Wheeled vehicle constraint (0x0D,0x63).
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Wheeled Vehicle Constraint Control (0x0D,0x63)
    """

    SET = 0x0D
    DESCRIPTOR = 0xE3
    NAME = "filter.wheeled_vehicle_constraint_control_response"
    ROLE = "response"

    enable: int
    """0 disables, 1 enables. Range: 0 to 1."""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[WheeledVehicleConstraintControlResponse, int]:
        v = _WHEELED_VEHICLE_CONSTRAINT_CONTROL_RESPONSE_0.read(raw, at)
        at += 1
        enable = v[0]
        return cls(enable), at

    def _write(self) -> bytes:
        out = _WHEELED_VEHICLE_CONSTRAINT_CONTROL_RESPONSE_0.write(self.enable)
        return codec.finished(out)


_GNSS_ANTENNA_OFFSET_CALIBRATION_CONTROL_RESPONSE_0 = codec.Block("Bf", "enable", "max_offset")


@dataclass(slots=True)
class GnssAntennaOffsetCalibrationControlResponse(Response):
    """GNSS antenna offset calibration response (0x0D,0xE4).

    Answers GNSS antenna offset calibration (0x0D,0x64).
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: GNSS Antenna Offset Calibration Control (0x0D,0x64)
    - 3dm-cv7-gnss-ins: Antenna Lever Arm Calibration
    """

    SET = 0x0D
    DESCRIPTOR = 0xE4
    NAME = "filter.gnss_antenna_offset_calibration_control_response"
    ROLE = "response"

    enable: int
    """0 disables, 1 enables. Range: 0 to 1."""
    max_offset: float
    """Largest absolute error that is tracked; the limits are those of the 3DM-CV7. [m] Frame:
    vehicle. Range: 0 to 0.5. Factory default: 0.1.
    """

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GnssAntennaOffsetCalibrationControlResponse, int]:
        v = _GNSS_ANTENNA_OFFSET_CALIBRATION_CONTROL_RESPONSE_0.read(raw, at)
        at += 5
        enable = v[0]
        max_offset = v[1]
        return cls(enable, max_offset), at

    def _write(self) -> bytes:
        out = _GNSS_ANTENNA_OFFSET_CALIBRATION_CONTROL_RESPONSE_0.write(
            self.enable, self.max_offset
        )
        return codec.finished(out)


@dataclass(slots=True)
class ResetNavigationFilter(Command):
    """Reset navigation filter (0x0D,0x01).

    Puts the filter back into its initialization state.
    If automatic initialization is off, the attitude or heading must be set before the filter runs
    again.
    3DM-CV7: send it after a large jump of the system time, for example when the PPS is first found.
    Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.

    - 3dm-cv7-gnss-ins: Reset Navigation Filter (0x0D,0x01)
    - 3dm-gx5-15: 4.3.1 Reset Filter (0x0D, 0x01)
    """

    SET = 0x0D
    DESCRIPTOR = 0x01
    NAME = "filter.reset_navigation_filter"
    ROLE = "command"

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[ResetNavigationFilter, int]:
        return cls(), at

    def _write(self) -> bytes:
        return b""


_SET_INITIAL_ATTITUDE_0 = codec.Block("fff", "roll", "pitch", "heading")


@dataclass(slots=True)
class SetInitialAttitude(Command):
    """Set initial attitude (0x0D,0x02).

    Gives the filter its initial attitude, the orientation of the sensor frame in the NED frame.
    Accepted only in the initialization state.
    Supported by 3DM-GX5-15.

    - 3dm-gx5-15: 4.3.2 Set Initial Attitude (0x0D, 0x02)
    """

    SET = 0x0D
    DESCRIPTOR = 0x02
    NAME = "filter.set_initial_attitude"
    ROLE = "command"

    roll: float
    """Roll angle. [rad] Frame: ned. Range: -3.141592653589793 to 3.141592653589793."""
    pitch: float
    """Pitch angle. [rad] Frame: ned. Range: -1.5707963267948966 to 1.5707963267948966."""
    heading: float
    """Heading (yaw) angle. [rad] Frame: ned. Range: -3.141592653589793 to 3.141592653589793."""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[SetInitialAttitude, int]:
        v = _SET_INITIAL_ATTITUDE_0.read(raw, at)
        at += 12
        roll = v[0]
        pitch = v[1]
        heading = v[2]
        return cls(roll, pitch, heading), at

    def _write(self) -> bytes:
        out = _SET_INITIAL_ATTITUDE_0.write(self.roll, self.pitch, self.heading)
        return codec.finished(out)


_SET_INITIAL_HEADING_CONTROL_0 = codec.Block("f", "heading")


@dataclass(slots=True)
class SetInitialHeadingControl(Command):
    """Set initial heading (0x0D,0x03).

    Gives the filter its initial heading; pitch and roll come from the accelerometers.
    3DM-GX5: accepted only in the initialization state.
    3DM-CV7: resets the estimated heading; if magnetometer aiding is on, the given heading is
    ignored.
    Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.

    - 3dm-cv7-gnss-ins: Set Initial Heading Control (0x0D,0x03)
    - 3dm-gx5-15: 4.3.3 Set Initial Heading (0x0D, 0x03)
    """

    SET = 0x0D
    DESCRIPTOR = 0x03
    NAME = "filter.set_initial_heading_control"
    ROLE = "command"

    heading: float
    """Initial heading. [rad] Frame: ned. Range: -3.141592653589793 to 3.141592653589793."""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[SetInitialHeadingControl, int]:
        v = _SET_INITIAL_HEADING_CONTROL_0.read(raw, at)
        at += 4
        heading = v[0]
        return cls(heading), at

    def _write(self) -> bytes:
        out = _SET_INITIAL_HEADING_CONTROL_0.write(self.heading)
        return codec.finished(out)


@dataclass(slots=True)
class RunNavigationFilter(Command):
    """Run navigation filter (0x0D,0x05).

    Starts a filter that was set up to wait for this command.
    The filter waits in its initialization state if `wait_for_run_command` of
    `navigation_filter_initialization` is set.
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Run Navigation Filter (0x0D,0x05)
    """

    SET = 0x0D
    DESCRIPTOR = 0x05
    NAME = "filter.run_navigation_filter"
    ROLE = "command"

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[RunNavigationFilter, int]:
        return cls(), at

    def _write(self) -> bytes:
        return b""


_SENSOR_TO_VEHICLE_FRAME_TRANSFORMATION_0 = codec.Block("B", "function")
_SENSOR_TO_VEHICLE_FRAME_TRANSFORMATION_1 = codec.Block("f", "roll")
_SENSOR_TO_VEHICLE_FRAME_TRANSFORMATION_2 = codec.Block("f", "pitch")
_SENSOR_TO_VEHICLE_FRAME_TRANSFORMATION_3 = codec.Block("f", "yaw")
_SENSOR_TO_VEHICLE_FRAME_TRANSFORMATION_GROUPS = (
    (1, ("roll",), False),
    (2, ("pitch",), False),
    (3, ("yaw",), False),
)


@dataclass(slots=True)
class SensorToVehicleFrameTransformation(Command):
    """Sensor to vehicle frame transformation (0x0D,0x11).

    Euler angles of the rotation from the sensor frame to the vehicle frame (5-series).
    It turns the scaled acceleration, angular rate and magnetic field, delta theta and delta
    velocity, and the orientation, compensated and linear acceleration, angular rate and gravity
    vector of the filter.
    The 3DM-CV7 takes the inverse instead: `3dm.sensor_to_vehicle_frame_transformation_euler`.
    Supported by 3DM-GX5-15.

    - 3dm-gx5-15: 4.3.4 Sensor to Vehicle Frame Transformation (0x0D, 0x11)
    """

    SET = 0x0D
    DESCRIPTOR = 0x11
    NAME = "filter.sensor_to_vehicle_frame_transformation"
    ROLE = "command"
    RESPONSES = (SensorToVehicleFrameTransformationResponse,)
    REQUIRED = {1: 3, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """What to do with the setting."""
    roll: float | None = None
    """Roll angle. [rad]"""
    pitch: float | None = None
    """Pitch angle. [rad]"""
    yaw: float | None = None
    """Yaw angle. [rad]"""

    @classmethod
    def write(cls, roll: float, pitch: float, yaw: float) -> SensorToVehicleFrameTransformation:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, roll=roll, pitch=pitch, yaw=yaw)

    @classmethod
    def read(cls) -> SensorToVehicleFrameTransformation:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls) -> SensorToVehicleFrameTransformation:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> SensorToVehicleFrameTransformation:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> SensorToVehicleFrameTransformation:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return SensorToVehicleFrameTransformationResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[SensorToVehicleFrameTransformation, int]:
        roll: float | None = None
        pitch: float | None = None
        yaw: float | None = None
        v = _SENSOR_TO_VEHICLE_FRAME_TRANSFORMATION_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _SENSOR_TO_VEHICLE_FRAME_TRANSFORMATION_1.read(raw, at)
            at += 4
            roll = v[0]
            done, end = 1, at
            if at == len(raw) and required < 2:
                raise Truncated(1, 0)
            v = _SENSOR_TO_VEHICLE_FRAME_TRANSFORMATION_2.read(raw, at)
            at += 4
            pitch = v[0]
            done, end = 2, at
            if at == len(raw) and required < 3:
                raise Truncated(1, 0)
            v = _SENSOR_TO_VEHICLE_FRAME_TRANSFORMATION_3.read(raw, at)
            at += 4
            yaw = v[0]
            done, end = 3, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, roll, pitch, yaw), at

    def _write(self) -> bytes:
        out = _SENSOR_TO_VEHICLE_FRAME_TRANSFORMATION_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _SENSOR_TO_VEHICLE_FRAME_TRANSFORMATION_GROUPS)
        if there >= 1:
            out += _SENSOR_TO_VEHICLE_FRAME_TRANSFORMATION_1.write(self.roll)
        if there >= 2:
            out += _SENSOR_TO_VEHICLE_FRAME_TRANSFORMATION_2.write(self.pitch)
        if there >= 3:
            out += _SENSOR_TO_VEHICLE_FRAME_TRANSFORMATION_3.write(self.yaw)
        return codec.finished(out)


_GNSS_ANTENNA_OFFSET_CONTROL_0 = codec.Block("B", "function")
_GNSS_ANTENNA_OFFSET_CONTROL_1 = codec.Block("fff", "offset", "offset", "offset")
_GNSS_ANTENNA_OFFSET_CONTROL_GROUPS = ((1, ("offset",), False),)


@dataclass(slots=True)
class GnssAntennaOffsetControl(Command):
    """GNSS antenna offset (0x0D,0x13).

    Position of the GNSS antenna relative to the origin of the sensor.
    The magnitude of the vector is limited to 10.
    7-series devices expect the vehicle frame, 5-series devices the sensor frame.
    On the 3DM-CV7 it is for GNSS data that come as NMEA; data that come by the aiding commands use
    `aiding.frame_configuration`.
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: GNSS Antenna Offset Control (0x0D,0x13)
    """

    SET = 0x0D
    DESCRIPTOR = 0x13
    NAME = "filter.gnss_antenna_offset_control"
    ROLE = "command"
    RESPONSES = (GnssAntennaOffsetControlResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """What to do with the setting."""
    offset: types.Vector3f | None = None
    """From the sensor origin to the centre of the antenna. [m] Frame: vehicle. Range: -10 to 10."""

    @classmethod
    def write(cls, offset: types.Vector3f) -> GnssAntennaOffsetControl:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, offset=offset)

    @classmethod
    def read(cls) -> GnssAntennaOffsetControl:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls) -> GnssAntennaOffsetControl:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> GnssAntennaOffsetControl:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> GnssAntennaOffsetControl:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return GnssAntennaOffsetControlResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GnssAntennaOffsetControl, int]:
        offset: types.Vector3f | None = None
        v = _GNSS_ANTENNA_OFFSET_CONTROL_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _GNSS_ANTENNA_OFFSET_CONTROL_1.read(raw, at)
            at += 12
            offset = v[0:3]
            done, end = 1, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, offset), at

    def _write(self) -> bytes:
        out = _GNSS_ANTENNA_OFFSET_CONTROL_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _GNSS_ANTENNA_OFFSET_CONTROL_GROUPS)
        if there >= 1:
            out += _GNSS_ANTENNA_OFFSET_CONTROL_1.write(*codec.exactly("offset", self.offset, 3))
        return codec.finished(out)


_ESTIMATION_CONTROL_FLAGS_0 = codec.Block("B", "function")
_ESTIMATION_CONTROL_FLAGS_1 = codec.Block("H", "flags")
_ESTIMATION_CONTROL_FLAGS_GROUPS = ((1, ("flags",), False),)


@dataclass(slots=True)
class EstimationControlFlags(Command):
    """Estimation control flags (0x0D,0x14).

    Which states the filter estimates.
    Supported by 3DM-GX5-15.

    - 3dm-gx5-15: 4.3.5 Estimation Control Flags (0x0D, 0x14)
    """

    SET = 0x0D
    DESCRIPTOR = 0x14
    NAME = "filter.estimation_control_flags"
    ROLE = "command"
    RESPONSES = (EstimationControlFlagsResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """What to do with the setting."""
    flags: EstimatedStates | None = None
    """States to estimate."""

    @classmethod
    def write(cls, flags: EstimatedStates) -> EstimationControlFlags:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, flags=flags)

    @classmethod
    def read(cls) -> EstimationControlFlags:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls) -> EstimationControlFlags:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> EstimationControlFlags:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> EstimationControlFlags:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return EstimationControlFlagsResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[EstimationControlFlags, int]:
        flags: EstimatedStates | None = None
        v = _ESTIMATION_CONTROL_FLAGS_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _ESTIMATION_CONTROL_FLAGS_1.read(raw, at)
            at += 2
            flags = EstimatedStates(v[0])
            done, end = 1, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, flags), at

    def _write(self) -> bytes:
        out = _ESTIMATION_CONTROL_FLAGS_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _ESTIMATION_CONTROL_FLAGS_GROUPS)
        if there >= 1:
            out += _ESTIMATION_CONTROL_FLAGS_1.write(self.flags)
        return codec.finished(out)


_GNSS_AIDING_SOURCE_CONTROL_0 = codec.Block("B", "function")
_GNSS_AIDING_SOURCE_CONTROL_1 = codec.Block("B", "source")
_GNSS_AIDING_SOURCE_CONTROL_GROUPS = ((1, ("source",), False),)


@dataclass(slots=True)
class GnssAidingSourceControl(Command):
    """GNSS aiding source (0x0D,0x15).

    Which GNSS receiver aids the filter.
    A change while the filter runs may put it back into initialization until the new source gives
    data.
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: GNSS Aiding Source Control (0x0D,0x15)
    """

    SET = 0x0D
    DESCRIPTOR = 0x15
    NAME = "filter.gnss_aiding_source_control"
    ROLE = "command"
    RESPONSES = (GnssAidingSourceControlResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """What to do with the setting."""
    source: GnssAidingSource | None = None
    """Source of the GNSS data."""

    @classmethod
    def write(cls, source: GnssAidingSource) -> GnssAidingSourceControl:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, source=source)

    @classmethod
    def read(cls) -> GnssAidingSourceControl:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls) -> GnssAidingSourceControl:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> GnssAidingSourceControl:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> GnssAidingSourceControl:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return GnssAidingSourceControlResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GnssAidingSourceControl, int]:
        source: GnssAidingSource | None = None
        v = _GNSS_AIDING_SOURCE_CONTROL_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _GNSS_AIDING_SOURCE_CONTROL_1.read(raw, at)
            at += 1
            source = GnssAidingSource(v[0])
            done, end = 1, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, source), at

    def _write(self) -> bytes:
        out = _GNSS_AIDING_SOURCE_CONTROL_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _GNSS_AIDING_SOURCE_CONTROL_GROUPS)
        if there >= 1:
            out += _GNSS_AIDING_SOURCE_CONTROL_1.write(self.source)
        return codec.finished(out)


_EXTERNAL_HEADING_UPDATE_0 = codec.Block("ffB", "heading", "heading_uncertainty", "type")


@dataclass(slots=True)
class ExternalHeadingUpdate(Command):
    """External heading update (0x0D,0x17).

    Gives the filter one measurement of the heading of the sensor frame in the NED frame.
    Refused unless external heading updates are enabled, by `heading_update_control` on the 3DM-GX5
    and by `aiding_measurement_control` on the 3DM-CV7.
    The 3DM-GX5-15 takes at most 20 updates per second.
    If the declination source is not valid, -25 models refuse true headings and -45 models magnetic
    ones.
    Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.

    - 3dm-cv7-gnss-ins: External Heading Update (0x0D,0x17)
    - 3dm-gx5-15: 4.3.7 External Heading Update (0x0D, 0x17)
    """

    SET = 0x0D
    DESCRIPTOR = 0x17
    NAME = "filter.external_heading_update"
    ROLE = "command"

    heading: float
    """Heading relative to the north that `type` names. [rad] Frame: ned. Range:
    -3.141592653589793 to 3.141592653589793.
    """
    heading_uncertainty: float
    """Standard deviation; it must be greater than 0, other values are refused. [rad]"""
    type: HeadingType
    """North that the heading refers to."""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[ExternalHeadingUpdate, int]:
        v = _EXTERNAL_HEADING_UPDATE_0.read(raw, at)
        at += 9
        heading = v[0]
        heading_uncertainty = v[1]
        type = HeadingType(v[2])
        return cls(heading, heading_uncertainty, type), at

    def _write(self) -> bytes:
        out = _EXTERNAL_HEADING_UPDATE_0.write(self.heading, self.heading_uncertainty, self.type)
        return codec.finished(out)


_HEADING_UPDATE_CONTROL_0 = codec.Block("B", "function")
_HEADING_UPDATE_CONTROL_1 = codec.Block("B", "enable")
_HEADING_UPDATE_CONTROL_GROUPS = ((1, ("enable",), False),)


@dataclass(slots=True)
class HeadingUpdateControl(Command):
    """Heading update control (0x0D,0x18).

    Source of the heading that aids the filter.
    Supported by 3DM-GX5-15.

    - 3dm-gx5-15: 4.3.6 Heading Update Control (0x0D, 0x18)
    """

    SET = 0x0D
    DESCRIPTOR = 0x18
    NAME = "filter.heading_update_control"
    ROLE = "command"
    RESPONSES = (HeadingUpdateControlResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """What to do with the setting."""
    enable: HeadingUpdateSource | None = None
    """Source of the heading."""

    @classmethod
    def write(cls, enable: HeadingUpdateSource) -> HeadingUpdateControl:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, enable=enable)

    @classmethod
    def read(cls) -> HeadingUpdateControl:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls) -> HeadingUpdateControl:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> HeadingUpdateControl:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> HeadingUpdateControl:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return HeadingUpdateControlResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[HeadingUpdateControl, int]:
        enable: HeadingUpdateSource | None = None
        v = _HEADING_UPDATE_CONTROL_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _HEADING_UPDATE_CONTROL_1.read(raw, at)
            at += 1
            enable = HeadingUpdateSource(v[0])
            done, end = 1, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, enable), at

    def _write(self) -> bytes:
        out = _HEADING_UPDATE_CONTROL_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _HEADING_UPDATE_CONTROL_GROUPS)
        if there >= 1:
            out += _HEADING_UPDATE_CONTROL_1.write(self.enable)
        return codec.finished(out)


_AUTO_INITIALIZATION_CONTROL_0 = codec.Block("B", "function")
_AUTO_INITIALIZATION_CONTROL_1 = codec.Block("B", "enable")
_AUTO_INITIALIZATION_CONTROL_GROUPS = ((1, ("enable",), False),)


@dataclass(slots=True)
class AutoInitializationControl(Command):
    """Automatic initialization (0x0D,0x19).

    Whether the filter initializes by itself when the device starts.
    It needs a valid heading source.
    Supported by 3DM-GX5-15.

    - 3dm-gx5-15: 4.3.10 Auto-Initialization Control (0x0D, 0x19)
    """

    SET = 0x0D
    DESCRIPTOR = 0x19
    NAME = "filter.auto_initialization_control"
    ROLE = "command"
    RESPONSES = (AutoInitializationControlResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """What to do with the setting."""
    enable: int | None = None
    """0 disables, 1 enables. Range: 0 to 1."""

    @classmethod
    def write(cls, enable: int) -> AutoInitializationControl:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, enable=enable)

    @classmethod
    def read(cls) -> AutoInitializationControl:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls) -> AutoInitializationControl:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> AutoInitializationControl:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> AutoInitializationControl:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return AutoInitializationControlResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[AutoInitializationControl, int]:
        enable: int | None = None
        v = _AUTO_INITIALIZATION_CONTROL_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _AUTO_INITIALIZATION_CONTROL_1.read(raw, at)
            at += 1
            enable = v[0]
            done, end = 1, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, enable), at

    def _write(self) -> bytes:
        out = _AUTO_INITIALIZATION_CONTROL_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _AUTO_INITIALIZATION_CONTROL_GROUPS)
        if there >= 1:
            out += _AUTO_INITIALIZATION_CONTROL_1.write(self.enable)
        return codec.finished(out)


_ACCELEROMETER_NOISE_STANDARD_DEVIATION_0 = codec.Block("B", "function")
_ACCELEROMETER_NOISE_STANDARD_DEVIATION_1 = codec.Block("fff", "noise", "noise", "noise")
_ACCELEROMETER_NOISE_STANDARD_DEVIATION_GROUPS = ((1, ("noise",), False),)


@dataclass(slots=True)
class AccelerometerNoiseStandardDeviation(Command):
    """Accelerometer noise (0x0D,0x1A).

    Standard deviation of the accelerometer noise that the filter assumes (process noise).
    Every value must be greater than 0. The factory values suit most laboratory conditions.
    Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.

    - 3dm-cv7-gnss-ins: Accelerometer Noise Standard Deviation (0x0D,0x1A)
    - 3dm-gx5-15: 4.3.12 Accelerometer Noise Standard Deviation (0x0D, 0x1A)
    """

    SET = 0x0D
    DESCRIPTOR = 0x1A
    NAME = "filter.accelerometer_noise_standard_deviation"
    ROLE = "command"
    RESPONSES = (AccelerometerNoiseStandardDeviationResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """What to do with the setting."""
    noise: types.Vector3f | None = None
    """Standard deviation per axis. [m/s^2]"""

    @classmethod
    def write(cls, noise: types.Vector3f) -> AccelerometerNoiseStandardDeviation:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, noise=noise)

    @classmethod
    def read(cls) -> AccelerometerNoiseStandardDeviation:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls) -> AccelerometerNoiseStandardDeviation:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> AccelerometerNoiseStandardDeviation:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> AccelerometerNoiseStandardDeviation:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return AccelerometerNoiseStandardDeviationResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[AccelerometerNoiseStandardDeviation, int]:
        noise: types.Vector3f | None = None
        v = _ACCELEROMETER_NOISE_STANDARD_DEVIATION_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _ACCELEROMETER_NOISE_STANDARD_DEVIATION_1.read(raw, at)
            at += 12
            noise = v[0:3]
            done, end = 1, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, noise), at

    def _write(self) -> bytes:
        out = _ACCELEROMETER_NOISE_STANDARD_DEVIATION_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _ACCELEROMETER_NOISE_STANDARD_DEVIATION_GROUPS)
        if there >= 1:
            out += _ACCELEROMETER_NOISE_STANDARD_DEVIATION_1.write(
                *codec.exactly("noise", self.noise, 3)
            )
        return codec.finished(out)


_GYROSCOPE_NOISE_STANDARD_DEVIATION_0 = codec.Block("B", "function")
_GYROSCOPE_NOISE_STANDARD_DEVIATION_1 = codec.Block("fff", "noise", "noise", "noise")
_GYROSCOPE_NOISE_STANDARD_DEVIATION_GROUPS = ((1, ("noise",), False),)


@dataclass(slots=True)
class GyroscopeNoiseStandardDeviation(Command):
    """Gyroscope noise (0x0D,0x1B).

    Standard deviation of the gyroscope noise that the filter assumes (process noise).
    Every value must be greater than 0. The factory values suit most laboratory conditions.
    Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.

    - 3dm-cv7-gnss-ins: Gyroscope Noise Standard Deviation (0x0D,0x1B)
    - 3dm-gx5-15: 4.3.13 Gyroscope Noise Standard Deviation (0x0D, 0x1B)
    """

    SET = 0x0D
    DESCRIPTOR = 0x1B
    NAME = "filter.gyroscope_noise_standard_deviation"
    ROLE = "command"
    RESPONSES = (GyroscopeNoiseStandardDeviationResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """What to do with the setting."""
    noise: types.Vector3f | None = None
    """Standard deviation per axis. [rad/s]"""

    @classmethod
    def write(cls, noise: types.Vector3f) -> GyroscopeNoiseStandardDeviation:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, noise=noise)

    @classmethod
    def read(cls) -> GyroscopeNoiseStandardDeviation:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls) -> GyroscopeNoiseStandardDeviation:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> GyroscopeNoiseStandardDeviation:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> GyroscopeNoiseStandardDeviation:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return GyroscopeNoiseStandardDeviationResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GyroscopeNoiseStandardDeviation, int]:
        noise: types.Vector3f | None = None
        v = _GYROSCOPE_NOISE_STANDARD_DEVIATION_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _GYROSCOPE_NOISE_STANDARD_DEVIATION_1.read(raw, at)
            at += 12
            noise = v[0:3]
            done, end = 1, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, noise), at

    def _write(self) -> bytes:
        out = _GYROSCOPE_NOISE_STANDARD_DEVIATION_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _GYROSCOPE_NOISE_STANDARD_DEVIATION_GROUPS)
        if there >= 1:
            out += _GYROSCOPE_NOISE_STANDARD_DEVIATION_1.write(
                *codec.exactly("noise", self.noise, 3)
            )
        return codec.finished(out)


_ACCELEROMETER_BIAS_MODEL_PARAMETERS_0 = codec.Block("B", "function")
_ACCELEROMETER_BIAS_MODEL_PARAMETERS_1 = codec.Block("fff", "beta", "beta", "beta")
_ACCELEROMETER_BIAS_MODEL_PARAMETERS_2 = codec.Block("fff", "noise", "noise", "noise")
_ACCELEROMETER_BIAS_MODEL_PARAMETERS_GROUPS = ((1, ("beta",), False), (2, ("noise",), False))


@dataclass(slots=True)
class AccelerometerBiasModelParameters(Command):
    """Accelerometer bias model (0x0D,0x1C).

    Parameters of the model by which the accelerometer bias drifts.
    Every noise value must be greater than 0.
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Accelerometer Bias Model Parameters (0x0D,0x1C)
    """

    SET = 0x0D
    DESCRIPTOR = 0x1C
    NAME = "filter.accelerometer_bias_model_parameters"
    ROLE = "command"
    RESPONSES = (AccelerometerBiasModelParametersResponse,)
    REQUIRED = {1: 2, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """What to do with the setting."""
    beta: types.Vector3f | None = None
    """Reciprocal of the correlation time per axis. [1/s]"""
    noise: types.Vector3f | None = None
    """Standard deviation of the noise per axis. [m/s^2]"""

    @classmethod
    def write(cls, beta: types.Vector3f, noise: types.Vector3f) -> AccelerometerBiasModelParameters:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, beta=beta, noise=noise)

    @classmethod
    def read(cls) -> AccelerometerBiasModelParameters:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls) -> AccelerometerBiasModelParameters:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> AccelerometerBiasModelParameters:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> AccelerometerBiasModelParameters:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return AccelerometerBiasModelParametersResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[AccelerometerBiasModelParameters, int]:
        beta: types.Vector3f | None = None
        noise: types.Vector3f | None = None
        v = _ACCELEROMETER_BIAS_MODEL_PARAMETERS_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _ACCELEROMETER_BIAS_MODEL_PARAMETERS_1.read(raw, at)
            at += 12
            beta = v[0:3]
            done, end = 1, at
            if at == len(raw) and required < 2:
                raise Truncated(1, 0)
            v = _ACCELEROMETER_BIAS_MODEL_PARAMETERS_2.read(raw, at)
            at += 12
            noise = v[0:3]
            done, end = 2, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, beta, noise), at

    def _write(self) -> bytes:
        out = _ACCELEROMETER_BIAS_MODEL_PARAMETERS_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _ACCELEROMETER_BIAS_MODEL_PARAMETERS_GROUPS)
        if there >= 1:
            out += _ACCELEROMETER_BIAS_MODEL_PARAMETERS_1.write(
                *codec.exactly("beta", self.beta, 3)
            )
        if there >= 2:
            out += _ACCELEROMETER_BIAS_MODEL_PARAMETERS_2.write(
                *codec.exactly("noise", self.noise, 3)
            )
        return codec.finished(out)


_GYROSCOPE_BIAS_MODEL_PARAMETERS_0 = codec.Block("B", "function")
_GYROSCOPE_BIAS_MODEL_PARAMETERS_1 = codec.Block("fff", "beta", "beta", "beta")
_GYROSCOPE_BIAS_MODEL_PARAMETERS_2 = codec.Block("fff", "noise", "noise", "noise")
_GYROSCOPE_BIAS_MODEL_PARAMETERS_GROUPS = ((1, ("beta",), False), (2, ("noise",), False))


@dataclass(slots=True)
class GyroscopeBiasModelParameters(Command):
    """Gyroscope bias model (0x0D,0x1D).

    Parameters of the model by which the gyroscope bias drifts.
    Every noise value must be greater than 0.
    Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.

    - 3dm-cv7-gnss-ins: Gyroscope Bias Model Parameters (0x0D,0x1D)
    - 3dm-gx5-15: 4.3.14 Gyroscope Bias Model Parameters (0x0D, 0x1D)
    """

    SET = 0x0D
    DESCRIPTOR = 0x1D
    NAME = "filter.gyroscope_bias_model_parameters"
    ROLE = "command"
    RESPONSES = (GyroscopeBiasModelParametersResponse,)
    REQUIRED = {1: 2, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """What to do with the setting."""
    beta: types.Vector3f | None = None
    """Reciprocal of the correlation time per axis. [1/s]"""
    noise: types.Vector3f | None = None
    """Standard deviation of the noise per axis. [rad/s]"""

    @classmethod
    def write(cls, beta: types.Vector3f, noise: types.Vector3f) -> GyroscopeBiasModelParameters:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, beta=beta, noise=noise)

    @classmethod
    def read(cls) -> GyroscopeBiasModelParameters:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls) -> GyroscopeBiasModelParameters:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> GyroscopeBiasModelParameters:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> GyroscopeBiasModelParameters:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return GyroscopeBiasModelParametersResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GyroscopeBiasModelParameters, int]:
        beta: types.Vector3f | None = None
        noise: types.Vector3f | None = None
        v = _GYROSCOPE_BIAS_MODEL_PARAMETERS_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _GYROSCOPE_BIAS_MODEL_PARAMETERS_1.read(raw, at)
            at += 12
            beta = v[0:3]
            done, end = 1, at
            if at == len(raw) and required < 2:
                raise Truncated(1, 0)
            v = _GYROSCOPE_BIAS_MODEL_PARAMETERS_2.read(raw, at)
            at += 12
            noise = v[0:3]
            done, end = 2, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, beta, noise), at

    def _write(self) -> bytes:
        out = _GYROSCOPE_BIAS_MODEL_PARAMETERS_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _GYROSCOPE_BIAS_MODEL_PARAMETERS_GROUPS)
        if there >= 1:
            out += _GYROSCOPE_BIAS_MODEL_PARAMETERS_1.write(*codec.exactly("beta", self.beta, 3))
        if there >= 2:
            out += _GYROSCOPE_BIAS_MODEL_PARAMETERS_2.write(*codec.exactly("noise", self.noise, 3))
        return codec.finished(out)


_EXTERNAL_HEADING_UPDATE_WITH_TIME_0 = codec.Block(
    "dHffB", "gps_time", "gps_week", "heading", "heading_uncertainty", "type"
)


@dataclass(slots=True)
class ExternalHeadingUpdateWithTime(Command):
    """External heading update with time (0x0D,0x1F).

    Gives the filter one measurement of the heading of the sensor frame with its GPS time.
    Better than `external_heading_update` where the heading changes quickly; the time must be
    accurate.
    Refused unless external heading updates are enabled, by `heading_update_control` on the 3DM-GX5
    and by `aiding_measurement_control` on the 3DM-CV7.
    The 3DM-GX5-15 takes at most 20 updates per second.
    If the declination source is not valid, -25 models refuse true headings and -45 models magnetic
    ones.
    Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.

    - 3dm-cv7-gnss-ins: External Heading Update With Time (0x0D,0x1F)
    - 3dm-gx5-15: 4.3.8 External Heading Update with Timestamp (0x0D, 0x1F)
    """

    SET = 0x0D
    DESCRIPTOR = 0x1F
    NAME = "filter.external_heading_update_with_time"
    ROLE = "command"

    gps_time: float
    """GPS time of week of the measurement. [s]"""
    gps_week: int
    """GPS week, counted without rollover. [week]"""
    heading: float
    """Heading relative to the north that `type` names. [rad] Frame: ned. Range:
    -3.141592653589793 to 3.141592653589793.
    """
    heading_uncertainty: float
    """Standard deviation; it must be greater than 0, other values are refused. [rad]"""
    type: HeadingType
    """North that the heading refers to."""

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[ExternalHeadingUpdateWithTime, int]:
        v = _EXTERNAL_HEADING_UPDATE_WITH_TIME_0.read(raw, at)
        at += 19
        gps_time = v[0]
        gps_week = v[1]
        heading = v[2]
        heading_uncertainty = v[3]
        type = HeadingType(v[4])
        return cls(gps_time, gps_week, heading, heading_uncertainty, type), at

    def _write(self) -> bytes:
        out = _EXTERNAL_HEADING_UPDATE_WITH_TIME_0.write(
            self.gps_time, self.gps_week, self.heading, self.heading_uncertainty, self.type
        )
        return codec.finished(out)


_ZERO_ANGULAR_RATE_UPDATE_CONTROL_0 = codec.Block("B", "function")
_ZERO_ANGULAR_RATE_UPDATE_CONTROL_1 = codec.Block("B", "enable")
_ZERO_ANGULAR_RATE_UPDATE_CONTROL_2 = codec.Block("f", "threshold")
_ZERO_ANGULAR_RATE_UPDATE_CONTROL_GROUPS = ((1, ("enable",), False), (2, ("threshold",), False))


@dataclass(slots=True)
class ZeroAngularRateUpdateControl(Command):
    """Zero angular rate update (0x0D,0x20).

    Lets the filter take the device as not rotating while its angular rate is small.
    The update applies while the magnitude of the angular rate vector is at or below the threshold.
    Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.

    - 3dm-cv7-gnss-ins: Zero Angular Rate Update Control (0x0D,0x20)
    - 3dm-gx5-15: 4.3.15 Zero Angular Rate Update Control (0x0D, 0x20)
    """

    SET = 0x0D
    DESCRIPTOR = 0x20
    NAME = "filter.zero_angular_rate_update_control"
    ROLE = "command"
    RESPONSES = (ZeroAngularRateUpdateControlResponse,)
    REQUIRED = {1: 2, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """What to do with the setting."""
    enable: int | None = None
    """0 disables, 1 enables. Range: 0 to 1."""
    threshold: float | None = None
    """Largest angular rate that is taken as zero. [rad/s] Range: 0 to …."""

    @classmethod
    def write(cls, enable: int, threshold: float) -> ZeroAngularRateUpdateControl:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, enable=enable, threshold=threshold)

    @classmethod
    def read(cls) -> ZeroAngularRateUpdateControl:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls) -> ZeroAngularRateUpdateControl:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> ZeroAngularRateUpdateControl:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> ZeroAngularRateUpdateControl:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return ZeroAngularRateUpdateControlResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[ZeroAngularRateUpdateControl, int]:
        enable: int | None = None
        threshold: float | None = None
        v = _ZERO_ANGULAR_RATE_UPDATE_CONTROL_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _ZERO_ANGULAR_RATE_UPDATE_CONTROL_1.read(raw, at)
            at += 1
            enable = v[0]
            done, end = 1, at
            if at == len(raw) and required < 2:
                raise Truncated(1, 0)
            v = _ZERO_ANGULAR_RATE_UPDATE_CONTROL_2.read(raw, at)
            at += 4
            threshold = v[0]
            done, end = 2, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, enable, threshold), at

    def _write(self) -> bytes:
        out = _ZERO_ANGULAR_RATE_UPDATE_CONTROL_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _ZERO_ANGULAR_RATE_UPDATE_CONTROL_GROUPS)
        if there >= 1:
            out += _ZERO_ANGULAR_RATE_UPDATE_CONTROL_1.write(self.enable)
        if there >= 2:
            out += _ZERO_ANGULAR_RATE_UPDATE_CONTROL_2.write(self.threshold)
        return codec.finished(out)


_TARE_ORIENTATION_0 = codec.Block("B", "function")
_TARE_ORIENTATION_1 = codec.Block("B", "axes")
_TARE_ORIENTATION_GROUPS = ((1, ("axes",), False),)


@dataclass(slots=True)
class TareOrientation(Command):
    """Tare orientation (0x0D,0x21).

    Makes the present orientation in the NED frame the sensor-to-vehicle transformation.
    Refused while the filter has no valid attitude.
    Supported by 3DM-GX5-15.

    - 3dm-gx5-15: 4.3.16 Tare Orientation (0x0D, 0x21)
    """

    SET = 0x0D
    DESCRIPTOR = 0x21
    NAME = "filter.tare_orientation"
    ROLE = "command"
    REQUIRED = {1: 1, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """What to do with the setting."""
    axes: TareAxes | None = None
    """Axes to tare; 0 resets all axes."""

    @classmethod
    def write(cls, axes: TareAxes) -> TareOrientation:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, axes=axes)

    @classmethod
    def save(cls) -> TareOrientation:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> TareOrientation:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> TareOrientation:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[TareOrientation, int]:
        axes: TareAxes | None = None
        v = _TARE_ORIENTATION_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _TARE_ORIENTATION_1.read(raw, at)
            at += 1
            axes = TareAxes(v[0])
            done, end = 1, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, axes), at

    def _write(self) -> bytes:
        out = _TARE_ORIENTATION_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _TARE_ORIENTATION_GROUPS)
        if there >= 1:
            out += _TARE_ORIENTATION_1.write(self.axes)
        return codec.finished(out)


@dataclass(slots=True)
class CommandedZeroAngularRateUpdate(Command):
    """Commanded zero angular rate update (0x0D,0x23).

    Tells the filter once that the device is not rotating.
    At most 10 per second.
    Supported by 3DM-GX5-15.

    - 3dm-gx5-15: 4.3.17 Commanded Zero-Angular Rate Update (0x0D, 0x23)
    """

    SET = 0x0D
    DESCRIPTOR = 0x23
    NAME = "filter.commanded_zero_angular_rate_update"
    ROLE = "command"

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[CommandedZeroAngularRateUpdate, int]:
        return cls(), at

    def _write(self) -> bytes:
        return b""


_SET_REFERENCE_POSITION_0 = codec.Block("B", "function")
_SET_REFERENCE_POSITION_1 = codec.Block("B", "enable")
_SET_REFERENCE_POSITION_2 = codec.Block("d", "latitude")
_SET_REFERENCE_POSITION_3 = codec.Block("d", "longitude")
_SET_REFERENCE_POSITION_4 = codec.Block("d", "altitude")
_SET_REFERENCE_POSITION_GROUPS = (
    (1, ("enable",), False),
    (2, ("latitude",), False),
    (3, ("longitude",), False),
    (4, ("altitude",), False),
)


@dataclass(slots=True)
class SetReferencePosition(Command):
    """Set reference position (0x0D,0x26).

    Position for which the device computes gravity (WGS84) and the magnetic field (WMM2015).
    Supported by 3DM-GX5-15.

    - 3dm-gx5-15: 4.3.20 Set Reference Position (0x0D, 0x26)
    """

    SET = 0x0D
    DESCRIPTOR = 0x26
    NAME = "filter.set_reference_position"
    ROLE = "command"
    RESPONSES = (SetReferencePositionResponse,)
    REQUIRED = {1: 4, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """What to do with the setting."""
    enable: int | None = None
    """0 disables, 1 enables. Range: 0 to 1."""
    latitude: float | None = None
    """Latitude. [deg] Frame: llh."""
    longitude: float | None = None
    """Longitude. [deg] Frame: llh."""
    altitude: float | None = None
    """Altitude. [m] Frame: llh."""

    @classmethod
    def write(
        cls, enable: int, latitude: float, longitude: float, altitude: float
    ) -> SetReferencePosition:
        """Apply the new setting."""
        return cls(
            FunctionSelector.WRITE,
            enable=enable,
            latitude=latitude,
            longitude=longitude,
            altitude=altitude,
        )

    @classmethod
    def read(cls) -> SetReferencePosition:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls) -> SetReferencePosition:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> SetReferencePosition:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> SetReferencePosition:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return SetReferencePositionResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[SetReferencePosition, int]:
        enable: int | None = None
        latitude: float | None = None
        longitude: float | None = None
        altitude: float | None = None
        v = _SET_REFERENCE_POSITION_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _SET_REFERENCE_POSITION_1.read(raw, at)
            at += 1
            enable = v[0]
            done, end = 1, at
            if at == len(raw) and required < 2:
                raise Truncated(1, 0)
            v = _SET_REFERENCE_POSITION_2.read(raw, at)
            at += 8
            latitude = v[0]
            done, end = 2, at
            if at == len(raw) and required < 3:
                raise Truncated(1, 0)
            v = _SET_REFERENCE_POSITION_3.read(raw, at)
            at += 8
            longitude = v[0]
            done, end = 3, at
            if at == len(raw) and required < 4:
                raise Truncated(1, 0)
            v = _SET_REFERENCE_POSITION_4.read(raw, at)
            at += 8
            altitude = v[0]
            done, end = 4, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, enable, latitude, longitude, altitude), at

    def _write(self) -> bytes:
        out = _SET_REFERENCE_POSITION_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _SET_REFERENCE_POSITION_GROUPS)
        if there >= 1:
            out += _SET_REFERENCE_POSITION_1.write(self.enable)
        if there >= 2:
            out += _SET_REFERENCE_POSITION_2.write(self.latitude)
        if there >= 3:
            out += _SET_REFERENCE_POSITION_3.write(self.longitude)
        if there >= 4:
            out += _SET_REFERENCE_POSITION_4.write(self.altitude)
        return codec.finished(out)


_GRAVITY_NOISE_STANDARD_DEVIATION_0 = codec.Block("B", "function")
_GRAVITY_NOISE_STANDARD_DEVIATION_1 = codec.Block("fff", "noise", "noise", "noise")
_GRAVITY_NOISE_STANDARD_DEVIATION_GROUPS = ((1, ("noise",), False),)


@dataclass(slots=True)
class GravityNoiseStandardDeviation(Command):
    """Gravity noise (0x0D,0x28).

    Standard deviation of the gravity noise that the filter assumes (process noise).
    Every value must be greater than 0. The factory values suit most laboratory conditions.
    Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.

    - 3dm-cv7-gnss-ins: Gravity Noise Standard Deviation (0x0D,0x28)
    - 3dm-gx5-15: 4.3.11 Gravity Noise Standard Deviation (0x0D, 0x28)
    """

    SET = 0x0D
    DESCRIPTOR = 0x28
    NAME = "filter.gravity_noise_standard_deviation"
    ROLE = "command"
    RESPONSES = (GravityNoiseStandardDeviationResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """What to do with the setting."""
    noise: types.Vector3f | None = None
    """Standard deviation per axis. [g]"""

    @classmethod
    def write(cls, noise: types.Vector3f) -> GravityNoiseStandardDeviation:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, noise=noise)

    @classmethod
    def read(cls) -> GravityNoiseStandardDeviation:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls) -> GravityNoiseStandardDeviation:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> GravityNoiseStandardDeviation:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> GravityNoiseStandardDeviation:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return GravityNoiseStandardDeviationResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GravityNoiseStandardDeviation, int]:
        noise: types.Vector3f | None = None
        v = _GRAVITY_NOISE_STANDARD_DEVIATION_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _GRAVITY_NOISE_STANDARD_DEVIATION_1.read(raw, at)
            at += 12
            noise = v[0:3]
            done, end = 1, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, noise), at

    def _write(self) -> bytes:
        out = _GRAVITY_NOISE_STANDARD_DEVIATION_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _GRAVITY_NOISE_STANDARD_DEVIATION_GROUPS)
        if there >= 1:
            out += _GRAVITY_NOISE_STANDARD_DEVIATION_1.write(*codec.exactly("noise", self.noise, 3))
        return codec.finished(out)


_ENABLE_DISABLE_MEASUREMENTS_0 = codec.Block("B", "function")
_ENABLE_DISABLE_MEASUREMENTS_1 = codec.Block("H", "control")
_ENABLE_DISABLE_MEASUREMENTS_GROUPS = ((1, ("control",), False),)


@dataclass(slots=True)
class EnableDisableMeasurements(Command):
    """Enable or disable measurements (0x0D,0x41).

    Which inertial measurements the filter uses.
    Supported by 3DM-GX5-15.

    - 3dm-gx5-15: 4.3.18 Enable/Disable Measurements (0x0D, 0x41)
    """

    SET = 0x0D
    DESCRIPTOR = 0x41
    NAME = "filter.enable_disable_measurements"
    ROLE = "command"
    RESPONSES = (EnableDisableMeasurementsResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """What to do with the setting."""
    control: MeasurementFlags | None = None
    """Measurements to use."""

    @classmethod
    def write(cls, control: MeasurementFlags) -> EnableDisableMeasurements:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, control=control)

    @classmethod
    def read(cls) -> EnableDisableMeasurements:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls) -> EnableDisableMeasurements:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> EnableDisableMeasurements:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> EnableDisableMeasurements:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return EnableDisableMeasurementsResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[EnableDisableMeasurements, int]:
        control: MeasurementFlags | None = None
        v = _ENABLE_DISABLE_MEASUREMENTS_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _ENABLE_DISABLE_MEASUREMENTS_1.read(raw, at)
            at += 2
            control = MeasurementFlags(v[0])
            done, end = 1, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, control), at

    def _write(self) -> bytes:
        out = _ENABLE_DISABLE_MEASUREMENTS_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _ENABLE_DISABLE_MEASUREMENTS_GROUPS)
        if there >= 1:
            out += _ENABLE_DISABLE_MEASUREMENTS_1.write(self.control)
        return codec.finished(out)


_MAGNETIC_FIELD_DECLINATION_SOURCE_CONTROL_0 = codec.Block("B", "function")
_MAGNETIC_FIELD_DECLINATION_SOURCE_CONTROL_1 = codec.Block("B", "source")
_MAGNETIC_FIELD_DECLINATION_SOURCE_CONTROL_2 = codec.Block("f", "declination")
_MAGNETIC_FIELD_DECLINATION_SOURCE_CONTROL_GROUPS = (
    (1, ("source",), False),
    (2, ("declination",), False),
)


@dataclass(slots=True)
class MagneticFieldDeclinationSourceControl(Command):
    """Magnetic declination source (0x0D,0x43).

    Source of the local declination of the magnetic field.
    Without a good declination source, keep automatic magnetometer calibration off.
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Magnetic Field Declination Source Control (0x0D,0x43)
    """

    SET = 0x0D
    DESCRIPTOR = 0x43
    NAME = "filter.magnetic_field_declination_source_control"
    ROLE = "command"
    RESPONSES = (MagneticFieldDeclinationSourceControlResponse,)
    REQUIRED = {1: 2, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """What to do with the setting."""
    source: DeclinationSource | None = None
    """Source of the declination."""
    declination: float | None = None
    """Declination; used only if `source` is manual. [rad]"""

    @classmethod
    def write(
        cls, source: DeclinationSource, declination: float
    ) -> MagneticFieldDeclinationSourceControl:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, source=source, declination=declination)

    @classmethod
    def read(cls) -> MagneticFieldDeclinationSourceControl:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls) -> MagneticFieldDeclinationSourceControl:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> MagneticFieldDeclinationSourceControl:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> MagneticFieldDeclinationSourceControl:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return MagneticFieldDeclinationSourceControlResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[MagneticFieldDeclinationSourceControl, int]:
        source: DeclinationSource | None = None
        declination: float | None = None
        v = _MAGNETIC_FIELD_DECLINATION_SOURCE_CONTROL_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _MAGNETIC_FIELD_DECLINATION_SOURCE_CONTROL_1.read(raw, at)
            at += 1
            source = DeclinationSource(v[0])
            done, end = 1, at
            if at == len(raw) and required < 2:
                raise Truncated(1, 0)
            v = _MAGNETIC_FIELD_DECLINATION_SOURCE_CONTROL_2.read(raw, at)
            at += 4
            declination = v[0]
            done, end = 2, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, source, declination), at

    def _write(self) -> bytes:
        out = _MAGNETIC_FIELD_DECLINATION_SOURCE_CONTROL_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _MAGNETIC_FIELD_DECLINATION_SOURCE_CONTROL_GROUPS)
        if there >= 1:
            out += _MAGNETIC_FIELD_DECLINATION_SOURCE_CONTROL_1.write(self.source)
        if there >= 2:
            out += _MAGNETIC_FIELD_DECLINATION_SOURCE_CONTROL_2.write(self.declination)
        return codec.finished(out)


_GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_0 = codec.Block("B", "function")
_GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_1 = codec.Block("B", "adaptive_measurement")
_GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_2 = codec.Block("f", "frequency")
_GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_3 = codec.Block("f", "low_limit")
_GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_4 = codec.Block("f", "high_limit")
_GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_5 = codec.Block("f", "low_limit_uncertainty")
_GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_6 = codec.Block("f", "high_limit_uncertainty")
_GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_7 = codec.Block("f", "minimum_uncertainty")
_GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_GROUPS = (
    (1, ("adaptive_measurement",), False),
    (2, ("frequency",), False),
    (3, ("low_limit",), False),
    (4, ("high_limit",), False),
    (5, ("low_limit_uncertainty",), False),
    (6, ("high_limit_uncertainty",), False),
    (7, ("minimum_uncertainty",), False),
)


@dataclass(slots=True)
class GravityMagnitudeErrorAdaptiveMeasurement(Command):
    """Gravity magnitude error adaptive measurement (0x0D,0x44).

    How far the filter trusts gravity measurements whose magnitude is not that of gravity.
    Also called accelerometer magnitude error adaptive measurement.
    All parameters after the selector keep their values if they are left out.
    Filter and limits take effect only with `fixed`.
    Raise the limits where vibration is strong, lower them where it is weak. High limits cost pitch
    and roll accuracy under linear acceleration, low limits cost heading accuracy.
    Supported by 3DM-GX5-15.

    - 3dm-gx5-15: 4.3.19 Gravity Magnitude Error Adaptive Measurement (0x0D, 0x44)
    """

    SET = 0x0D
    DESCRIPTOR = 0x44
    NAME = "filter.gravity_magnitude_error_adaptive_measurement"
    ROLE = "command"
    RESPONSES = (GravityMagnitudeErrorAdaptiveMeasurementResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """What to do with the setting."""
    adaptive_measurement: AdaptiveMeasurementSelector | None = None
    """Kind of adaptation."""
    frequency: float | None = None
    """Cut-off frequency of the low-pass filter. [Hz]"""
    low_limit: float | None = None
    """Lower limit of the error. [m/s^2]"""
    high_limit: float | None = None
    """Upper limit of the error. [m/s^2]"""
    low_limit_uncertainty: float | None = None
    """Standard deviation at the lower limit. [m/s^2]"""
    high_limit_uncertainty: float | None = None
    """Standard deviation at the upper limit. [m/s^2]"""
    minimum_uncertainty: float | None = None
    """Smallest standard deviation. [m/s^2]"""

    @classmethod
    def write(
        cls,
        adaptive_measurement: AdaptiveMeasurementSelector,
        frequency: float | None = None,
        low_limit: float | None = None,
        high_limit: float | None = None,
        low_limit_uncertainty: float | None = None,
        high_limit_uncertainty: float | None = None,
        minimum_uncertainty: float | None = None,
    ) -> GravityMagnitudeErrorAdaptiveMeasurement:
        """Apply the new setting."""
        return cls(
            FunctionSelector.WRITE,
            adaptive_measurement=adaptive_measurement,
            frequency=frequency,
            low_limit=low_limit,
            high_limit=high_limit,
            low_limit_uncertainty=low_limit_uncertainty,
            high_limit_uncertainty=high_limit_uncertainty,
            minimum_uncertainty=minimum_uncertainty,
        )

    @classmethod
    def read(cls) -> GravityMagnitudeErrorAdaptiveMeasurement:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls) -> GravityMagnitudeErrorAdaptiveMeasurement:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> GravityMagnitudeErrorAdaptiveMeasurement:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> GravityMagnitudeErrorAdaptiveMeasurement:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return GravityMagnitudeErrorAdaptiveMeasurementResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GravityMagnitudeErrorAdaptiveMeasurement, int]:
        adaptive_measurement: AdaptiveMeasurementSelector | None = None
        frequency: float | None = None
        low_limit: float | None = None
        high_limit: float | None = None
        low_limit_uncertainty: float | None = None
        high_limit_uncertainty: float | None = None
        minimum_uncertainty: float | None = None
        v = _GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_1.read(raw, at)
            at += 1
            adaptive_measurement = AdaptiveMeasurementSelector(v[0])
            done, end = 1, at
            if at == len(raw) and required < 2:
                raise Truncated(1, 0)
            v = _GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_2.read(raw, at)
            at += 4
            frequency = v[0]
            done, end = 2, at
            if at == len(raw) and required < 3:
                raise Truncated(1, 0)
            v = _GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_3.read(raw, at)
            at += 4
            low_limit = v[0]
            done, end = 3, at
            if at == len(raw) and required < 4:
                raise Truncated(1, 0)
            v = _GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_4.read(raw, at)
            at += 4
            high_limit = v[0]
            done, end = 4, at
            if at == len(raw) and required < 5:
                raise Truncated(1, 0)
            v = _GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_5.read(raw, at)
            at += 4
            low_limit_uncertainty = v[0]
            done, end = 5, at
            if at == len(raw) and required < 6:
                raise Truncated(1, 0)
            v = _GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_6.read(raw, at)
            at += 4
            high_limit_uncertainty = v[0]
            done, end = 6, at
            if at == len(raw) and required < 7:
                raise Truncated(1, 0)
            v = _GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_7.read(raw, at)
            at += 4
            minimum_uncertainty = v[0]
            done, end = 7, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(
            function,
            adaptive_measurement,
            frequency,
            low_limit,
            high_limit,
            low_limit_uncertainty,
            high_limit_uncertainty,
            minimum_uncertainty,
        ), at

    def _write(self) -> bytes:
        out = _GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_GROUPS)
        if there >= 1:
            out += _GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_1.write(self.adaptive_measurement)
        if there >= 2:
            out += _GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_2.write(self.frequency)
        if there >= 3:
            out += _GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_3.write(self.low_limit)
        if there >= 4:
            out += _GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_4.write(self.high_limit)
        if there >= 5:
            out += _GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_5.write(self.low_limit_uncertainty)
        if there >= 6:
            out += _GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_6.write(
                self.high_limit_uncertainty
            )
        if there >= 7:
            out += _GRAVITY_MAGNITUDE_ERROR_ADAPTIVE_MEASUREMENT_7.write(self.minimum_uncertainty)
        return codec.finished(out)


_PITCH_ROLL_AIDING_CONTROL_0 = codec.Block("B", "function")
_PITCH_ROLL_AIDING_CONTROL_1 = codec.Block("B", "aiding")
_PITCH_ROLL_AIDING_CONTROL_GROUPS = ((1, ("aiding",), False),)


@dataclass(slots=True)
class PitchRollAidingControl(Command):
    """Pitch and roll aiding (0x0D,0x4B).

    What aids pitch and roll while the motion is gentle.
    Supported by 3DM-GX5-15.

    - 3dm-gx5-15: 4.3.9 Pitch/Roll Aiding Control (0x0D, 0x4B)
    """

    SET = 0x0D
    DESCRIPTOR = 0x4B
    NAME = "filter.pitch_roll_aiding_control"
    ROLE = "command"
    RESPONSES = (PitchRollAidingControlResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """What to do with the setting."""
    aiding: PitchRollAidingSource | None = None
    """Source of the aiding."""

    @classmethod
    def write(cls, aiding: PitchRollAidingSource) -> PitchRollAidingControl:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, aiding=aiding)

    @classmethod
    def read(cls) -> PitchRollAidingControl:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls) -> PitchRollAidingControl:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> PitchRollAidingControl:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> PitchRollAidingControl:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return PitchRollAidingControlResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[PitchRollAidingControl, int]:
        aiding: PitchRollAidingSource | None = None
        v = _PITCH_ROLL_AIDING_CONTROL_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _PITCH_ROLL_AIDING_CONTROL_1.read(raw, at)
            at += 1
            aiding = PitchRollAidingSource(v[0])
            done, end = 1, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, aiding), at

    def _write(self) -> bytes:
        out = _PITCH_ROLL_AIDING_CONTROL_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _PITCH_ROLL_AIDING_CONTROL_GROUPS)
        if there >= 1:
            out += _PITCH_ROLL_AIDING_CONTROL_1.write(self.aiding)
        return codec.finished(out)


_AIDING_MEASUREMENT_CONTROL_0 = codec.Block("B", "function")
_AIDING_MEASUREMENT_CONTROL_1 = codec.Block("H", "aiding_source")
_AIDING_MEASUREMENT_CONTROL_2 = codec.Block("B", "enable")
_AIDING_MEASUREMENT_CONTROL_GROUPS = ((1, ("aiding_source",), False), (2, ("enable",), False))


@dataclass(slots=True)
class AidingMeasurementControl(Command):
    """Aiding measurement control (0x0D,0x50).

    Enables or disables one source of aiding measurements.
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Aiding Measurement Control (0x0D,0x50)
    """

    SET = 0x0D
    DESCRIPTOR = 0x50
    NAME = "filter.aiding_measurement_control"
    ROLE = "command"
    RESPONSES = (AidingMeasurementControlResponse,)
    REQUIRED = {1: 2, 2: 1, 3: 1, 4: 1, 5: 1}

    function: FunctionSelector
    """What to do with the setting."""
    aiding_source: AidingSource | None = None
    """The source; `all` is for save, load and default."""
    enable: bool | None = None
    """Whether the filter uses the source."""

    @classmethod
    def write(cls, aiding_source: AidingSource, enable: bool) -> AidingMeasurementControl:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, aiding_source=aiding_source, enable=enable)

    @classmethod
    def read(cls, aiding_source: AidingSource) -> AidingMeasurementControl:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ, aiding_source=aiding_source)

    @classmethod
    def save(cls, aiding_source: AidingSource) -> AidingMeasurementControl:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE, aiding_source=aiding_source)

    @classmethod
    def load(cls, aiding_source: AidingSource) -> AidingMeasurementControl:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD, aiding_source=aiding_source)

    @classmethod
    def default(cls, aiding_source: AidingSource) -> AidingMeasurementControl:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT, aiding_source=aiding_source)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return AidingMeasurementControlResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[AidingMeasurementControl, int]:
        aiding_source: AidingSource | None = None
        enable: bool | None = None
        v = _AIDING_MEASUREMENT_CONTROL_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _AIDING_MEASUREMENT_CONTROL_1.read(raw, at)
            at += 2
            aiding_source = AidingSource(v[0])
            done, end = 1, at
            if at == len(raw) and required < 2:
                raise Truncated(1, 0)
            v = _AIDING_MEASUREMENT_CONTROL_2.read(raw, at)
            at += 1
            enable = codec.truth(v[0])
            done, end = 2, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, aiding_source, enable), at

    def _write(self) -> bytes:
        out = _AIDING_MEASUREMENT_CONTROL_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _AIDING_MEASUREMENT_CONTROL_GROUPS)
        if there >= 1:
            out += _AIDING_MEASUREMENT_CONTROL_1.write(self.aiding_source)
        if there >= 2:
            out += _AIDING_MEASUREMENT_CONTROL_2.write(self.enable)
        return codec.finished(out)


_NAVIGATION_FILTER_INITIALIZATION_0 = codec.Block("B", "function")
_NAVIGATION_FILTER_INITIALIZATION_1 = codec.Block("B", "wait_for_run_command")
_NAVIGATION_FILTER_INITIALIZATION_2 = codec.Block("B", "initial_cond_src")
_NAVIGATION_FILTER_INITIALIZATION_3 = codec.Block("B", "auto_heading_alignment_selector")
_NAVIGATION_FILTER_INITIALIZATION_4 = codec.Block("f", "initial_heading")
_NAVIGATION_FILTER_INITIALIZATION_5 = codec.Block("f", "initial_pitch")
_NAVIGATION_FILTER_INITIALIZATION_6 = codec.Block("f", "initial_roll")
_NAVIGATION_FILTER_INITIALIZATION_7 = codec.Block(
    "fff", "initial_position", "initial_position", "initial_position"
)
_NAVIGATION_FILTER_INITIALIZATION_8 = codec.Block(
    "fff", "initial_velocity", "initial_velocity", "initial_velocity"
)
_NAVIGATION_FILTER_INITIALIZATION_9 = codec.Block("B", "reference_frame_selector")
_NAVIGATION_FILTER_INITIALIZATION_GROUPS = (
    (1, ("wait_for_run_command",), False),
    (2, ("initial_cond_src",), False),
    (3, ("auto_heading_alignment_selector",), False),
    (4, ("initial_heading",), False),
    (5, ("initial_pitch",), False),
    (6, ("initial_roll",), False),
    (7, ("initial_position",), False),
    (8, ("initial_velocity",), False),
    (9, ("reference_frame_selector",), False),
)


@dataclass(slots=True)
class NavigationFilterInitialization(Command):
    """Navigation filter initialization (0x0D,0x52).

    Sources and values of the initial attitude, position and velocity of the filter.
    Single precision resolves the latitude and longitude of the initial position to about a metre
    only.
    Kinematic alignment sets the heading once the speed reaches 2 m/s.
    External alignment needs a heading at least every 5 seconds.
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Navigation Filter Initialization (0x0D,0x52)
    """

    SET = 0x0D
    DESCRIPTOR = 0x52
    NAME = "filter.navigation_filter_initialization"
    ROLE = "command"
    RESPONSES = (NavigationFilterInitializationResponse,)
    REQUIRED = {1: 9, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """What to do with the setting."""
    wait_for_run_command: int | None = None
    """1: the filter starts only after `run_navigation_filter`; 0: as soon as it can. Range: 0 to
    1.
    """
    initial_cond_src: InitialConditionSource | None = None
    """Which initial conditions are found and which are given."""
    auto_heading_alignment_selector: HeadingAlignment | None = None
    """Ways in which the initial heading may be found."""
    initial_heading: float | None = None
    """Given heading. [deg]"""
    initial_pitch: float | None = None
    """Given pitch. [deg]"""
    initial_roll: float | None = None
    """Given roll. [deg]"""
    initial_position: types.Vector3f | None = None
    """Given position. If reference_frame_selector is ecef: unit m, frame ecef. If
    reference_frame_selector is llh: unit deg, deg, m, frame llh.
    """
    initial_velocity: types.Vector3f | None = None
    """Given velocity. [m/s] If reference_frame_selector is ecef: frame ecef. If
    reference_frame_selector is llh: frame ned.
    """
    reference_frame_selector: ReferenceFrame | None = None
    """Frame of the given position and velocity."""

    @classmethod
    def write(
        cls,
        wait_for_run_command: int,
        initial_cond_src: InitialConditionSource,
        auto_heading_alignment_selector: HeadingAlignment,
        initial_heading: float,
        initial_pitch: float,
        initial_roll: float,
        initial_position: types.Vector3f,
        initial_velocity: types.Vector3f,
        reference_frame_selector: ReferenceFrame,
    ) -> NavigationFilterInitialization:
        """Apply the new setting."""
        return cls(
            FunctionSelector.WRITE,
            wait_for_run_command=wait_for_run_command,
            initial_cond_src=initial_cond_src,
            auto_heading_alignment_selector=auto_heading_alignment_selector,
            initial_heading=initial_heading,
            initial_pitch=initial_pitch,
            initial_roll=initial_roll,
            initial_position=initial_position,
            initial_velocity=initial_velocity,
            reference_frame_selector=reference_frame_selector,
        )

    @classmethod
    def read(cls) -> NavigationFilterInitialization:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls) -> NavigationFilterInitialization:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> NavigationFilterInitialization:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> NavigationFilterInitialization:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return NavigationFilterInitializationResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[NavigationFilterInitialization, int]:
        wait_for_run_command: int | None = None
        initial_cond_src: InitialConditionSource | None = None
        auto_heading_alignment_selector: HeadingAlignment | None = None
        initial_heading: float | None = None
        initial_pitch: float | None = None
        initial_roll: float | None = None
        initial_position: types.Vector3f | None = None
        initial_velocity: types.Vector3f | None = None
        reference_frame_selector: ReferenceFrame | None = None
        v = _NAVIGATION_FILTER_INITIALIZATION_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _NAVIGATION_FILTER_INITIALIZATION_1.read(raw, at)
            at += 1
            wait_for_run_command = v[0]
            done, end = 1, at
            if at == len(raw) and required < 2:
                raise Truncated(1, 0)
            v = _NAVIGATION_FILTER_INITIALIZATION_2.read(raw, at)
            at += 1
            initial_cond_src = InitialConditionSource(v[0])
            done, end = 2, at
            if at == len(raw) and required < 3:
                raise Truncated(1, 0)
            v = _NAVIGATION_FILTER_INITIALIZATION_3.read(raw, at)
            at += 1
            auto_heading_alignment_selector = HeadingAlignment(v[0])
            done, end = 3, at
            if at == len(raw) and required < 4:
                raise Truncated(1, 0)
            v = _NAVIGATION_FILTER_INITIALIZATION_4.read(raw, at)
            at += 4
            initial_heading = v[0]
            done, end = 4, at
            if at == len(raw) and required < 5:
                raise Truncated(1, 0)
            v = _NAVIGATION_FILTER_INITIALIZATION_5.read(raw, at)
            at += 4
            initial_pitch = v[0]
            done, end = 5, at
            if at == len(raw) and required < 6:
                raise Truncated(1, 0)
            v = _NAVIGATION_FILTER_INITIALIZATION_6.read(raw, at)
            at += 4
            initial_roll = v[0]
            done, end = 6, at
            if at == len(raw) and required < 7:
                raise Truncated(1, 0)
            v = _NAVIGATION_FILTER_INITIALIZATION_7.read(raw, at)
            at += 12
            initial_position = v[0:3]
            done, end = 7, at
            if at == len(raw) and required < 8:
                raise Truncated(1, 0)
            v = _NAVIGATION_FILTER_INITIALIZATION_8.read(raw, at)
            at += 12
            initial_velocity = v[0:3]
            done, end = 8, at
            if at == len(raw) and required < 9:
                raise Truncated(1, 0)
            v = _NAVIGATION_FILTER_INITIALIZATION_9.read(raw, at)
            at += 1
            reference_frame_selector = ReferenceFrame(v[0])
            done, end = 9, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(
            function,
            wait_for_run_command,
            initial_cond_src,
            auto_heading_alignment_selector,
            initial_heading,
            initial_pitch,
            initial_roll,
            initial_position,
            initial_velocity,
            reference_frame_selector,
        ), at

    def _write(self) -> bytes:
        out = _NAVIGATION_FILTER_INITIALIZATION_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _NAVIGATION_FILTER_INITIALIZATION_GROUPS)
        if there >= 1:
            out += _NAVIGATION_FILTER_INITIALIZATION_1.write(self.wait_for_run_command)
        if there >= 2:
            out += _NAVIGATION_FILTER_INITIALIZATION_2.write(self.initial_cond_src)
        if there >= 3:
            out += _NAVIGATION_FILTER_INITIALIZATION_3.write(self.auto_heading_alignment_selector)
        if there >= 4:
            out += _NAVIGATION_FILTER_INITIALIZATION_4.write(self.initial_heading)
        if there >= 5:
            out += _NAVIGATION_FILTER_INITIALIZATION_5.write(self.initial_pitch)
        if there >= 6:
            out += _NAVIGATION_FILTER_INITIALIZATION_6.write(self.initial_roll)
        if there >= 7:
            out += _NAVIGATION_FILTER_INITIALIZATION_7.write(
                *codec.exactly("initial_position", self.initial_position, 3)
            )
        if there >= 8:
            out += _NAVIGATION_FILTER_INITIALIZATION_8.write(
                *codec.exactly("initial_velocity", self.initial_velocity, 3)
            )
        if there >= 9:
            out += _NAVIGATION_FILTER_INITIALIZATION_9.write(self.reference_frame_selector)
        return codec.finished(out)


_ADAPTIVE_FILTER_CONTROL_0 = codec.Block("B", "function")
_ADAPTIVE_FILTER_CONTROL_1 = codec.Block("B", "level")
_ADAPTIVE_FILTER_CONTROL_2 = codec.Block("H", "time_limit")
_ADAPTIVE_FILTER_CONTROL_GROUPS = ((1, ("level",), False), (2, ("time_limit",), False))


@dataclass(slots=True)
class AdaptiveFilterControl(Command):
    """Adaptive filter control (0x0D,0x53).

    How the filter adapts to measurements that do not fit its model.
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Adaptive Filter Control (0x0D,0x53)
    """

    SET = 0x0D
    DESCRIPTOR = 0x53
    NAME = "filter.adaptive_filter_control"
    ROLE = "command"
    RESPONSES = (AdaptiveFilterControlResponse,)
    REQUIRED = {1: 2, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """What to do with the setting."""
    level: AdaptiveLevel | None = None
    """Strength of the adaptation. Factory default: 2."""
    time_limit: int | None = None
    """Longest time for which measurements are rejected before the filter recovers. [ms]"""

    @classmethod
    def write(cls, level: AdaptiveLevel, time_limit: int) -> AdaptiveFilterControl:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, level=level, time_limit=time_limit)

    @classmethod
    def read(cls) -> AdaptiveFilterControl:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls) -> AdaptiveFilterControl:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> AdaptiveFilterControl:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> AdaptiveFilterControl:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return AdaptiveFilterControlResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[AdaptiveFilterControl, int]:
        level: AdaptiveLevel | None = None
        time_limit: int | None = None
        v = _ADAPTIVE_FILTER_CONTROL_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _ADAPTIVE_FILTER_CONTROL_1.read(raw, at)
            at += 1
            level = AdaptiveLevel(v[0])
            done, end = 1, at
            if at == len(raw) and required < 2:
                raise Truncated(1, 0)
            v = _ADAPTIVE_FILTER_CONTROL_2.read(raw, at)
            at += 2
            time_limit = v[0]
            done, end = 2, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, level, time_limit), at

    def _write(self) -> bytes:
        out = _ADAPTIVE_FILTER_CONTROL_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _ADAPTIVE_FILTER_CONTROL_GROUPS)
        if there >= 1:
            out += _ADAPTIVE_FILTER_CONTROL_1.write(self.level)
        if there >= 2:
            out += _ADAPTIVE_FILTER_CONTROL_2.write(self.time_limit)
        return codec.finished(out)


_GNSS_MULTI_ANTENNA_OFFSET_CONTROL_0 = codec.Block("B", "function")
_GNSS_MULTI_ANTENNA_OFFSET_CONTROL_1 = codec.Block("B", "receiver_id")
_GNSS_MULTI_ANTENNA_OFFSET_CONTROL_2 = codec.Block(
    "fff", "antenna_offset", "antenna_offset", "antenna_offset"
)
_GNSS_MULTI_ANTENNA_OFFSET_CONTROL_GROUPS = (
    (1, ("receiver_id",), False),
    (2, ("antenna_offset",), False),
)


@dataclass(slots=True)
class GnssMultiAntennaOffsetControl(Command):
    """GNSS multi-antenna offset (0x0D,0x54).

    Position of the antenna of one receiver on devices with several antennas.
    The magnitude of the vector is limited to 10.
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: GNSS Multi-Antenna Offset Control (0x0D,0x54)
    """

    SET = 0x0D
    DESCRIPTOR = 0x54
    NAME = "filter.gnss_multi_antenna_offset_control"
    ROLE = "command"
    RESPONSES = (GnssMultiAntennaOffsetControlResponse,)
    REQUIRED = {1: 2, 2: 1, 3: 1, 4: 1, 5: 1}

    function: FunctionSelector
    """What to do with the setting."""
    receiver_id: int | None = None
    """Number of the receiver, from 1. Range: 1 to …."""
    antenna_offset: types.Vector3f | None = None
    """From the sensor to the antenna. [m] Frame: vehicle. Range: -10 to 10."""

    @classmethod
    def write(
        cls, receiver_id: int, antenna_offset: types.Vector3f
    ) -> GnssMultiAntennaOffsetControl:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, receiver_id=receiver_id, antenna_offset=antenna_offset)

    @classmethod
    def read(cls, receiver_id: int) -> GnssMultiAntennaOffsetControl:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ, receiver_id=receiver_id)

    @classmethod
    def save(cls, receiver_id: int) -> GnssMultiAntennaOffsetControl:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE, receiver_id=receiver_id)

    @classmethod
    def load(cls, receiver_id: int) -> GnssMultiAntennaOffsetControl:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD, receiver_id=receiver_id)

    @classmethod
    def default(cls, receiver_id: int) -> GnssMultiAntennaOffsetControl:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT, receiver_id=receiver_id)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return GnssMultiAntennaOffsetControlResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GnssMultiAntennaOffsetControl, int]:
        receiver_id: int | None = None
        antenna_offset: types.Vector3f | None = None
        v = _GNSS_MULTI_ANTENNA_OFFSET_CONTROL_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _GNSS_MULTI_ANTENNA_OFFSET_CONTROL_1.read(raw, at)
            at += 1
            receiver_id = v[0]
            done, end = 1, at
            if at == len(raw) and required < 2:
                raise Truncated(1, 0)
            v = _GNSS_MULTI_ANTENNA_OFFSET_CONTROL_2.read(raw, at)
            at += 12
            antenna_offset = v[0:3]
            done, end = 2, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, receiver_id, antenna_offset), at

    def _write(self) -> bytes:
        out = _GNSS_MULTI_ANTENNA_OFFSET_CONTROL_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _GNSS_MULTI_ANTENNA_OFFSET_CONTROL_GROUPS)
        if there >= 1:
            out += _GNSS_MULTI_ANTENNA_OFFSET_CONTROL_1.write(self.receiver_id)
        if there >= 2:
            out += _GNSS_MULTI_ANTENNA_OFFSET_CONTROL_2.write(
                *codec.exactly("antenna_offset", self.antenna_offset, 3)
            )
        return codec.finished(out)


_RELATIVE_POSITION_CONFIGURATION_0 = codec.Block("B", "function")
_RELATIVE_POSITION_CONFIGURATION_1 = codec.Block("B", "source")
_RELATIVE_POSITION_CONFIGURATION_2 = codec.Block("B", "reference_frame_selector")
_RELATIVE_POSITION_CONFIGURATION_3 = codec.Block(
    "ddd", "reference_coordinates", "reference_coordinates", "reference_coordinates"
)
_RELATIVE_POSITION_CONFIGURATION_GROUPS = (
    (1, ("source",), False),
    (2, ("reference_frame_selector",), False),
    (3, ("reference_coordinates",), False),
)


@dataclass(slots=True)
class RelativePositionConfiguration(Command):
    """Relative position configuration (0x0D,0x55).

    Reference point of the relative position that the filter reports.
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Relative Position Configuration (0x0D,0x55)
    """

    SET = 0x0D
    DESCRIPTOR = 0x55
    NAME = "filter.relative_position_configuration"
    ROLE = "command"
    RESPONSES = (RelativePositionConfigurationResponse,)
    REQUIRED = {1: 3, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """What to do with the setting."""
    source: RelativePositionSource | None = None
    """Source of the reference point."""
    reference_frame_selector: ReferenceFrame | None = None
    """Frame of the coordinates."""
    reference_coordinates: types.Vector3d | None = None
    """Reference point. If reference_frame_selector is ecef: unit m, frame ecef. If
    reference_frame_selector is llh: unit deg, deg, m, frame llh.
    """

    @classmethod
    def write(
        cls,
        source: RelativePositionSource,
        reference_frame_selector: ReferenceFrame,
        reference_coordinates: types.Vector3d,
    ) -> RelativePositionConfiguration:
        """Apply the new setting."""
        return cls(
            FunctionSelector.WRITE,
            source=source,
            reference_frame_selector=reference_frame_selector,
            reference_coordinates=reference_coordinates,
        )

    @classmethod
    def read(cls) -> RelativePositionConfiguration:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls) -> RelativePositionConfiguration:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> RelativePositionConfiguration:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> RelativePositionConfiguration:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return RelativePositionConfigurationResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[RelativePositionConfiguration, int]:
        source: RelativePositionSource | None = None
        reference_frame_selector: ReferenceFrame | None = None
        reference_coordinates: types.Vector3d | None = None
        v = _RELATIVE_POSITION_CONFIGURATION_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _RELATIVE_POSITION_CONFIGURATION_1.read(raw, at)
            at += 1
            source = RelativePositionSource(v[0])
            done, end = 1, at
            if at == len(raw) and required < 2:
                raise Truncated(1, 0)
            v = _RELATIVE_POSITION_CONFIGURATION_2.read(raw, at)
            at += 1
            reference_frame_selector = ReferenceFrame(v[0])
            done, end = 2, at
            if at == len(raw) and required < 3:
                raise Truncated(1, 0)
            v = _RELATIVE_POSITION_CONFIGURATION_3.read(raw, at)
            at += 24
            reference_coordinates = v[0:3]
            done, end = 3, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, source, reference_frame_selector, reference_coordinates), at

    def _write(self) -> bytes:
        out = _RELATIVE_POSITION_CONFIGURATION_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _RELATIVE_POSITION_CONFIGURATION_GROUPS)
        if there >= 1:
            out += _RELATIVE_POSITION_CONFIGURATION_1.write(self.source)
        if there >= 2:
            out += _RELATIVE_POSITION_CONFIGURATION_2.write(self.reference_frame_selector)
        if there >= 3:
            out += _RELATIVE_POSITION_CONFIGURATION_3.write(
                *codec.exactly("reference_coordinates", self.reference_coordinates, 3)
            )
        return codec.finished(out)


_REFERENCE_POINT_LEVER_ARM_0 = codec.Block("B", "function")
_REFERENCE_POINT_LEVER_ARM_1 = codec.Block("B", "ref_point_sel")
_REFERENCE_POINT_LEVER_ARM_2 = codec.Block(
    "fff", "lever_arm_offset", "lever_arm_offset", "lever_arm_offset"
)
_REFERENCE_POINT_LEVER_ARM_GROUPS = (
    (1, ("ref_point_sel",), False),
    (2, ("lever_arm_offset",), False),
)


@dataclass(slots=True)
class ReferencePointLeverArm(Command):
    """Reference point lever arm (0x0D,0x56).

    Moves the point to which the position and the velocity of the filter refer.
    It shifts `llh_position`, `velocity_ned`, `ecef_position`, `ecef_velocity` and
    `ned_relative_position` of set `filter_data`, depending on the attitude and, for velocities, on
    the angular rate.
    The magnitude of the vector is limited to 10.
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Reference point lever arm (0x0D,0x56)
    """

    SET = 0x0D
    DESCRIPTOR = 0x56
    NAME = "filter.reference_point_lever_arm"
    ROLE = "command"
    RESPONSES = (ReferencePointLeverArmResponse,)
    REQUIRED = {1: 2, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """What to do with the setting."""
    ref_point_sel: ReferencePoint | None = None
    """Point to move; it must be 1."""
    lever_arm_offset: types.Vector3f | None = None
    """From the sensor to the point. [m] Frame: vehicle. Range: -10 to 10."""

    @classmethod
    def write(
        cls, ref_point_sel: ReferencePoint, lever_arm_offset: types.Vector3f
    ) -> ReferencePointLeverArm:
        """Apply the new setting."""
        return cls(
            FunctionSelector.WRITE, ref_point_sel=ref_point_sel, lever_arm_offset=lever_arm_offset
        )

    @classmethod
    def read(cls) -> ReferencePointLeverArm:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls) -> ReferencePointLeverArm:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> ReferencePointLeverArm:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> ReferencePointLeverArm:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return ReferencePointLeverArmResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[ReferencePointLeverArm, int]:
        ref_point_sel: ReferencePoint | None = None
        lever_arm_offset: types.Vector3f | None = None
        v = _REFERENCE_POINT_LEVER_ARM_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _REFERENCE_POINT_LEVER_ARM_1.read(raw, at)
            at += 1
            ref_point_sel = ReferencePoint(v[0])
            done, end = 1, at
            if at == len(raw) and required < 2:
                raise Truncated(1, 0)
            v = _REFERENCE_POINT_LEVER_ARM_2.read(raw, at)
            at += 12
            lever_arm_offset = v[0:3]
            done, end = 2, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, ref_point_sel, lever_arm_offset), at

    def _write(self) -> bytes:
        out = _REFERENCE_POINT_LEVER_ARM_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _REFERENCE_POINT_LEVER_ARM_GROUPS)
        if there >= 1:
            out += _REFERENCE_POINT_LEVER_ARM_1.write(self.ref_point_sel)
        if there >= 2:
            out += _REFERENCE_POINT_LEVER_ARM_2.write(
                *codec.exactly("lever_arm_offset", self.lever_arm_offset, 3)
            )
        return codec.finished(out)


_MEASUREMENT_SPEED_LEVER_ARM_0 = codec.Block("B", "function")
_MEASUREMENT_SPEED_LEVER_ARM_1 = codec.Block("B", "source")
_MEASUREMENT_SPEED_LEVER_ARM_2 = codec.Block(
    "fff", "lever_arm_offset", "lever_arm_offset", "lever_arm_offset"
)
_MEASUREMENT_SPEED_LEVER_ARM_GROUPS = ((1, ("source",), False), (2, ("lever_arm_offset",), False))


@dataclass(slots=True)
class MeasurementSpeedLeverArm(Command):
    """Speed measurement lever arm (0x0D,0x61).

    Position of the point whose speed is measured, such as the wheel that an odometer is on.
    It corrects for the speed that such a point has only because the vehicle turns.
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Measurement speed lever arm (0x0D,0x61)
    """

    SET = 0x0D
    DESCRIPTOR = 0x61
    NAME = "filter.measurement_speed_lever_arm"
    ROLE = "command"
    RESPONSES = (MeasurementSpeedLeverArmResponse,)
    REQUIRED = {1: 2, 2: 1, 3: 1, 4: 1, 5: 1}

    function: FunctionSelector
    """What to do with the setting."""
    source: int | None = None
    """Send 1."""
    lever_arm_offset: types.Vector3f | None = None
    """From the sensor to the point of measurement. [m] Frame: vehicle."""

    @classmethod
    def write(cls, lever_arm_offset: types.Vector3f) -> MeasurementSpeedLeverArm:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, source=1, lever_arm_offset=lever_arm_offset)

    @classmethod
    def read(cls) -> MeasurementSpeedLeverArm:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ, source=1)

    @classmethod
    def save(cls) -> MeasurementSpeedLeverArm:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE, source=1)

    @classmethod
    def load(cls) -> MeasurementSpeedLeverArm:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD, source=1)

    @classmethod
    def default(cls) -> MeasurementSpeedLeverArm:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT, source=1)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return MeasurementSpeedLeverArmResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[MeasurementSpeedLeverArm, int]:
        source: int | None = None
        lever_arm_offset: types.Vector3f | None = None
        v = _MEASUREMENT_SPEED_LEVER_ARM_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _MEASUREMENT_SPEED_LEVER_ARM_1.read(raw, at)
            at += 1
            source = v[0]
            done, end = 1, at
            if at == len(raw) and required < 2:
                raise Truncated(1, 0)
            v = _MEASUREMENT_SPEED_LEVER_ARM_2.read(raw, at)
            at += 12
            lever_arm_offset = v[0:3]
            done, end = 2, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, source, lever_arm_offset), at

    def _write(self) -> bytes:
        out = _MEASUREMENT_SPEED_LEVER_ARM_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _MEASUREMENT_SPEED_LEVER_ARM_GROUPS)
        if there >= 1:
            out += _MEASUREMENT_SPEED_LEVER_ARM_1.write(self.source)
        if there >= 2:
            out += _MEASUREMENT_SPEED_LEVER_ARM_2.write(
                *codec.exactly("lever_arm_offset", self.lever_arm_offset, 3)
            )
        return codec.finished(out)


_WHEELED_VEHICLE_CONSTRAINT_CONTROL_0 = codec.Block("B", "function")
_WHEELED_VEHICLE_CONSTRAINT_CONTROL_1 = codec.Block("B", "enable")
_WHEELED_VEHICLE_CONSTRAINT_CONTROL_GROUPS = ((1, ("enable",), False),)


@dataclass(slots=True)
class WheeledVehicleConstraintControl(Command):
    """Wheeled vehicle constraint (0x0D,0x63).

    Lets the filter assume that the vehicle moves only along its x axis.
    It improves the heading of cars and the like, above all when GNSS comes and goes. It is wrong
    for vehicles that move sideways, such as aircraft.
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Wheeled Vehicle Constraint Control (0x0D,0x63)
    """

    SET = 0x0D
    DESCRIPTOR = 0x63
    NAME = "filter.wheeled_vehicle_constraint_control"
    ROLE = "command"
    RESPONSES = (WheeledVehicleConstraintControlResponse,)
    REQUIRED = {1: 1, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """What to do with the setting."""
    enable: int | None = None
    """0 disables, 1 enables. Range: 0 to 1."""

    @classmethod
    def write(cls, enable: int) -> WheeledVehicleConstraintControl:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, enable=enable)

    @classmethod
    def read(cls) -> WheeledVehicleConstraintControl:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls) -> WheeledVehicleConstraintControl:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> WheeledVehicleConstraintControl:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> WheeledVehicleConstraintControl:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return WheeledVehicleConstraintControlResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[WheeledVehicleConstraintControl, int]:
        enable: int | None = None
        v = _WHEELED_VEHICLE_CONSTRAINT_CONTROL_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _WHEELED_VEHICLE_CONSTRAINT_CONTROL_1.read(raw, at)
            at += 1
            enable = v[0]
            done, end = 1, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, enable), at

    def _write(self) -> bytes:
        out = _WHEELED_VEHICLE_CONSTRAINT_CONTROL_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _WHEELED_VEHICLE_CONSTRAINT_CONTROL_GROUPS)
        if there >= 1:
            out += _WHEELED_VEHICLE_CONSTRAINT_CONTROL_1.write(self.enable)
        return codec.finished(out)


_GNSS_ANTENNA_OFFSET_CALIBRATION_CONTROL_0 = codec.Block("B", "function")
_GNSS_ANTENNA_OFFSET_CALIBRATION_CONTROL_1 = codec.Block("B", "enable")
_GNSS_ANTENNA_OFFSET_CALIBRATION_CONTROL_2 = codec.Block("f", "max_offset")
_GNSS_ANTENNA_OFFSET_CALIBRATION_CONTROL_GROUPS = (
    (1, ("enable",), False),
    (2, ("max_offset",), False),
)


@dataclass(slots=True)
class GnssAntennaOffsetCalibrationControl(Command):
    """GNSS antenna offset calibration (0x0D,0x64).

    Lets the filter track the error of the antenna offset.
    Supported by 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: GNSS Antenna Offset Calibration Control (0x0D,0x64)
    - 3dm-cv7-gnss-ins: Antenna Lever Arm Calibration
    """

    SET = 0x0D
    DESCRIPTOR = 0x64
    NAME = "filter.gnss_antenna_offset_calibration_control"
    ROLE = "command"
    RESPONSES = (GnssAntennaOffsetCalibrationControlResponse,)
    REQUIRED = {1: 2, 2: 0, 3: 0, 4: 0, 5: 0}

    function: FunctionSelector
    """What to do with the setting."""
    enable: int | None = None
    """0 disables, 1 enables. Range: 0 to 1."""
    max_offset: float | None = None
    """Largest absolute error that is tracked; the limits are those of the 3DM-CV7. [m] Frame:
    vehicle. Range: 0 to 0.5. Factory default: 0.1.
    """

    @classmethod
    def write(cls, enable: int, max_offset: float) -> GnssAntennaOffsetCalibrationControl:
        """Apply the new setting."""
        return cls(FunctionSelector.WRITE, enable=enable, max_offset=max_offset)

    @classmethod
    def read(cls) -> GnssAntennaOffsetCalibrationControl:
        """Send the current setting back in a response."""
        return cls(FunctionSelector.READ)

    @classmethod
    def save(cls) -> GnssAntennaOffsetCalibrationControl:
        """Save the current setting to non-volatile memory."""
        return cls(FunctionSelector.SAVE)

    @classmethod
    def load(cls) -> GnssAntennaOffsetCalibrationControl:
        """Load the saved setting."""
        return cls(FunctionSelector.LOAD)

    @classmethod
    def default(cls) -> GnssAntennaOffsetCalibrationControl:
        """Load the factory default setting."""
        return cls(FunctionSelector.DEFAULT)

    @property
    def expected(self) -> type[Response] | None:
        if self.function == 2:
            return GnssAntennaOffsetCalibrationControlResponse
        return None

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[GnssAntennaOffsetCalibrationControl, int]:
        enable: int | None = None
        max_offset: float | None = None
        v = _GNSS_ANTENNA_OFFSET_CALIBRATION_CONTROL_0.read(raw, at)
        at += 1
        function = FunctionSelector(v[0])
        required = cls.REQUIRED.get(function, 0)
        done, end = 0, at
        try:
            if at == len(raw) and required < 1:
                raise Truncated(1, 0)
            v = _GNSS_ANTENNA_OFFSET_CALIBRATION_CONTROL_1.read(raw, at)
            at += 1
            enable = v[0]
            done, end = 1, at
            if at == len(raw) and required < 2:
                raise Truncated(1, 0)
            v = _GNSS_ANTENNA_OFFSET_CALIBRATION_CONTROL_2.read(raw, at)
            at += 4
            max_offset = v[0]
            done, end = 2, at
        except Truncated:
            if done < required:
                raise
        at = end
        return cls(function, enable, max_offset), at

    def _write(self) -> bytes:
        out = _GNSS_ANTENNA_OFFSET_CALIBRATION_CONTROL_0.write(self.function)
        required = self.REQUIRED.get(self.function, 0)
        there = codec.present(self, required, _GNSS_ANTENNA_OFFSET_CALIBRATION_CONTROL_GROUPS)
        if there >= 1:
            out += _GNSS_ANTENNA_OFFSET_CALIBRATION_CONTROL_1.write(self.enable)
        if there >= 2:
            out += _GNSS_ANTENNA_OFFSET_CALIBRATION_CONTROL_2.write(self.max_offset)
        return codec.finished(out)


SensorToVehicleFrameTransformationResponse.COMMANDS = (SensorToVehicleFrameTransformation,)
GnssAntennaOffsetControlResponse.COMMANDS = (GnssAntennaOffsetControl,)
EstimationControlFlagsResponse.COMMANDS = (EstimationControlFlags,)
GnssAidingSourceControlResponse.COMMANDS = (GnssAidingSourceControl,)
HeadingUpdateControlResponse.COMMANDS = (HeadingUpdateControl,)
AutoInitializationControlResponse.COMMANDS = (AutoInitializationControl,)
AccelerometerNoiseStandardDeviationResponse.COMMANDS = (AccelerometerNoiseStandardDeviation,)
GyroscopeNoiseStandardDeviationResponse.COMMANDS = (GyroscopeNoiseStandardDeviation,)
AccelerometerBiasModelParametersResponse.COMMANDS = (AccelerometerBiasModelParameters,)
GyroscopeBiasModelParametersResponse.COMMANDS = (GyroscopeBiasModelParameters,)
ZeroAngularRateUpdateControlResponse.COMMANDS = (ZeroAngularRateUpdateControl,)
SetReferencePositionResponse.COMMANDS = (SetReferencePosition,)
GravityNoiseStandardDeviationResponse.COMMANDS = (GravityNoiseStandardDeviation,)
EnableDisableMeasurementsResponse.COMMANDS = (EnableDisableMeasurements,)
MagneticFieldDeclinationSourceControlResponse.COMMANDS = (MagneticFieldDeclinationSourceControl,)
GravityMagnitudeErrorAdaptiveMeasurementResponse.COMMANDS = (
    GravityMagnitudeErrorAdaptiveMeasurement,
)
PitchRollAidingControlResponse.COMMANDS = (PitchRollAidingControl,)
AidingMeasurementControlResponse.COMMANDS = (AidingMeasurementControl,)
NavigationFilterInitializationResponse.COMMANDS = (NavigationFilterInitialization,)
AdaptiveFilterControlResponse.COMMANDS = (AdaptiveFilterControl,)
GnssMultiAntennaOffsetControlResponse.COMMANDS = (GnssMultiAntennaOffsetControl,)
RelativePositionConfigurationResponse.COMMANDS = (RelativePositionConfiguration,)
ReferencePointLeverArmResponse.COMMANDS = (ReferencePointLeverArm,)
MeasurementSpeedLeverArmResponse.COMMANDS = (MeasurementSpeedLeverArm,)
WheeledVehicleConstraintControlResponse.COMMANDS = (WheeledVehicleConstraintControl,)
GnssAntennaOffsetCalibrationControlResponse.COMMANDS = (GnssAntennaOffsetCalibrationControl,)


#: The types of each descriptor; several where constants in the data tell layouts apart.
FIELDS: dict[int, tuple[type[Field], ...]] = {
    0x01: (ResetNavigationFilter,),
    0x02: (SetInitialAttitude,),
    0x03: (SetInitialHeadingControl,),
    0x05: (RunNavigationFilter,),
    0x11: (SensorToVehicleFrameTransformation,),
    0x13: (GnssAntennaOffsetControl,),
    0x14: (EstimationControlFlags,),
    0x15: (GnssAidingSourceControl,),
    0x17: (ExternalHeadingUpdate,),
    0x18: (HeadingUpdateControl,),
    0x19: (AutoInitializationControl,),
    0x1A: (AccelerometerNoiseStandardDeviation,),
    0x1B: (GyroscopeNoiseStandardDeviation,),
    0x1C: (AccelerometerBiasModelParameters,),
    0x1D: (GyroscopeBiasModelParameters,),
    0x1F: (ExternalHeadingUpdateWithTime,),
    0x20: (ZeroAngularRateUpdateControl,),
    0x21: (TareOrientation,),
    0x23: (CommandedZeroAngularRateUpdate,),
    0x26: (SetReferencePosition,),
    0x28: (GravityNoiseStandardDeviation,),
    0x41: (EnableDisableMeasurements,),
    0x43: (MagneticFieldDeclinationSourceControl,),
    0x44: (GravityMagnitudeErrorAdaptiveMeasurement,),
    0x4B: (PitchRollAidingControl,),
    0x50: (AidingMeasurementControl,),
    0x52: (NavigationFilterInitialization,),
    0x53: (AdaptiveFilterControl,),
    0x54: (GnssMultiAntennaOffsetControl,),
    0x55: (RelativePositionConfiguration,),
    0x56: (ReferencePointLeverArm,),
    0x61: (MeasurementSpeedLeverArm,),
    0x63: (WheeledVehicleConstraintControl,),
    0x64: (GnssAntennaOffsetCalibrationControl,),
    0x81: (SensorToVehicleFrameTransformationResponse,),
    0x83: (GnssAntennaOffsetControlResponse,),
    0x84: (EstimationControlFlagsResponse,),
    0x86: (GnssAidingSourceControlResponse,),
    0x87: (HeadingUpdateControlResponse,),
    0x88: (AutoInitializationControlResponse,),
    0x89: (AccelerometerNoiseStandardDeviationResponse,),
    0x8A: (GyroscopeNoiseStandardDeviationResponse,),
    0x8B: (AccelerometerBiasModelParametersResponse,),
    0x8C: (GyroscopeBiasModelParametersResponse,),
    0x8E: (ZeroAngularRateUpdateControlResponse,),
    0x90: (SetReferencePositionResponse,),
    0x93: (GravityNoiseStandardDeviationResponse,),
    0xB0: (EnableDisableMeasurementsResponse,),
    0xB2: (MagneticFieldDeclinationSourceControlResponse,),
    0xB3: (GravityMagnitudeErrorAdaptiveMeasurementResponse,),
    0xBB: (PitchRollAidingControlResponse,),
    0xD0: (AidingMeasurementControlResponse,),
    0xD2: (NavigationFilterInitializationResponse,),
    0xD3: (AdaptiveFilterControlResponse,),
    0xD4: (GnssMultiAntennaOffsetControlResponse,),
    0xD5: (RelativePositionConfigurationResponse,),
    0xD6: (ReferencePointLeverArmResponse,),
    0xE1: (MeasurementSpeedLeverArmResponse,),
    0xE3: (WheeledVehicleConstraintControlResponse,),
    0xE4: (GnssAntennaOffsetCalibrationControlResponse,),
}
