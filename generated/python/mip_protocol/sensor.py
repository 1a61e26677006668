"""Sensor data (0x80).

Inertial, magnetic and pressure measurements, and the attitude of the complementary filter.

- 3dm-gx5-15: 5.1 IMU Data
- 3dm-cv7-gnss-ins: Sensor (0x80)
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import IntFlag

from . import codec, types
from .field import Data, Field


@codec.open_flag(16)
class OverrangeFlags(IntFlag):
    """Sensor axes that were near or outside their range."""

    ACCEL_X = 1 << 0
    """The accelerometer x axis is near or outside its range. Bit 0. Concerns `ScaledAccel`."""
    ACCEL_Y = 1 << 1
    """The accelerometer y axis is near or outside its range. Bit 1. Concerns `ScaledAccel`."""
    ACCEL_Z = 1 << 2
    """The accelerometer z axis is near or outside its range. Bit 2. Concerns `ScaledAccel`."""
    GYRO_X = 1 << 4
    """The gyroscope x axis is near or outside its range. Bit 4. Concerns `ScaledGyro`."""
    GYRO_Y = 1 << 5
    """The gyroscope y axis is near or outside its range. Bit 5. Concerns `ScaledGyro`."""
    GYRO_Z = 1 << 6
    """The gyroscope z axis is near or outside its range. Bit 6. Concerns `ScaledGyro`."""
    MAG_X = 1 << 8
    """The magnetometer x axis is near or outside its range. Bit 8. Concerns `ScaledMag`."""
    MAG_Y = 1 << 9
    """The magnetometer y axis is near or outside its range. Bit 9. Concerns `ScaledMag`."""
    MAG_Z = 1 << 10
    """The magnetometer z axis is near or outside its range. Bit 10. Concerns `ScaledMag`."""
    PRESSURE = 1 << 12
    """The pressure sensor is near or outside its range. Bit 12. Concerns `ScaledPressure`."""


@codec.open_flag(16)
class OdometerFlags(IntFlag):
    """Validity of the odometer values."""

    ODOMETER = 1 << 0
    """Set if an odometer is configured; its values are then valid. Bit 0."""


class RawAccel(Data):
    """Raw accel (0x80,0x01).

    Raw acceleration in counts of the sensor, temperature compensated.

    Not listed in any device profile. Known only from the MIP SDK of 2014 and MicroStrain MIP SDK.

    - mip-sdk-4: Raw accel (0x80,0x01)
    - mip-sdk-2014: Raw accel (0x80,0x01)
    """

    __slots__ = ("raw_accel",)
    __match_args__ = ("raw_accel",)

    SET = 0x80
    SETS = (0x80,)
    DESCRIPTOR = 0x01
    NAME = "sensor.raw_accel"
    ROLE = "data"
    _LAYOUT = (("raw_accel", "fff", types.Vector3f),)

    _VECTORS = {"raw_accel": (types.Vector3f,)}

    raw_accel: types.Vector3f
    """Acceleration in counts. Elements: x, y, z. Unit: 1. Frame: sensor."""

    def __init__(self, raw_accel: types.Vector3f | codec.Numbers) -> None:
        self.raw_accel = codec.vector(raw_accel, types.Vector3f)


class RawGyro(Data):
    """Raw gyro (0x80,0x02).

    Raw angular rate in counts of the sensor, temperature compensated.

    Not listed in any device profile. Known only from the MIP SDK of 2014 and MicroStrain MIP SDK.

    - mip-sdk-4: Raw gyro (0x80,0x02)
    - mip-sdk-2014: Raw gyro (0x80,0x02)
    """

    __slots__ = ("raw_gyro",)
    __match_args__ = ("raw_gyro",)

    SET = 0x80
    SETS = (0x80,)
    DESCRIPTOR = 0x02
    NAME = "sensor.raw_gyro"
    ROLE = "data"
    _LAYOUT = (("raw_gyro", "fff", types.Vector3f),)

    _VECTORS = {"raw_gyro": (types.Vector3f,)}

    raw_gyro: types.Vector3f
    """Angular rate in counts. Elements: x, y, z. Unit: 1. Frame: sensor."""

    def __init__(self, raw_gyro: types.Vector3f | codec.Numbers) -> None:
        self.raw_gyro = codec.vector(raw_gyro, types.Vector3f)


class RawMag(Data):
    """Raw mag (0x80,0x03).

    Raw magnetic field in counts of the sensor, temperature compensated.

    Not listed in any device profile. Known only from the MIP SDK of 2014 and MicroStrain MIP SDK.

    - mip-sdk-4: Raw mag (0x80,0x03)
    - mip-sdk-2014: Raw mag (0x80,0x03)
    """

    __slots__ = ("raw_mag",)
    __match_args__ = ("raw_mag",)

    SET = 0x80
    SETS = (0x80,)
    DESCRIPTOR = 0x03
    NAME = "sensor.raw_mag"
    ROLE = "data"
    _LAYOUT = (("raw_mag", "fff", types.Vector3f),)

    _VECTORS = {"raw_mag": (types.Vector3f,)}

    raw_mag: types.Vector3f
    """Magnetic field in counts. Elements: x, y, z. Unit: 1. Frame: vehicle. Uncertain: The frame.
    The SDK has the vehicle frame here, but the sensor frame for raw acceleration and raw angular
    rate.
    """

    def __init__(self, raw_mag: types.Vector3f | codec.Numbers) -> None:
        self.raw_mag = codec.vector(raw_mag, types.Vector3f)


class ScaledAccel(Data):
    """Scaled accel (0x80,0x04).

    Specific force, temperature compensated: about -1 g on z when level and at rest.

    Supported by 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-CX5-45, 3DM-GQ7-GNSS/INS,
    3DM-GX5-15, 3DM-GX5-35 and 3DM-GX5-45.

    At rest, it is the opposite of the gravity vector.

    - 3dm-gx5-15: 5.1.1 Scaled Accelerometer Vector (0x80, 0x04)
    - 3dm-cv7-gnss-ins: Scaled Accel (0x80,0x04)
    """

    __slots__ = ("scaled_accel",)
    __match_args__ = ("scaled_accel",)

    SET = 0x80
    SETS = (0x80,)
    DESCRIPTOR = 0x04
    NAME = "sensor.scaled_accel"
    ROLE = "data"
    _LAYOUT = (("scaled_accel", "fff", types.Vector3f),)

    _VECTORS = {"scaled_accel": (types.Vector3f,)}

    scaled_accel: types.Vector3f
    """Specific force: acceleration minus gravity. Elements: x, y, z. Unit: g. Frame: vehicle. At
    rest and level: x 0, y 0, z -1.
    """

    def __init__(self, scaled_accel: types.Vector3f | codec.Numbers) -> None:
        self.scaled_accel = codec.vector(scaled_accel, types.Vector3f)


class ScaledGyro(Data):
    """Scaled gyro (0x80,0x05).

    Measured angular rate, temperature compensated.

    Supported by 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-CX5-45, 3DM-GQ7-GNSS/INS,
    3DM-GX5-15, 3DM-GX5-35 and 3DM-GX5-45.

    - 3dm-gx5-15: 5.1.2 Scaled Gyro Vector (0x80, 0x05)
    - 3dm-cv7-gnss-ins: Scaled Gyro (0x80,0x05)
    """

    __slots__ = ("scaled_gyro",)
    __match_args__ = ("scaled_gyro",)

    SET = 0x80
    SETS = (0x80,)
    DESCRIPTOR = 0x05
    NAME = "sensor.scaled_gyro"
    ROLE = "data"
    _LAYOUT = (("scaled_gyro", "fff", types.Vector3f),)

    _VECTORS = {"scaled_gyro": (types.Vector3f,)}

    scaled_gyro: types.Vector3f
    """Angular rate about each axis. Elements: x, y, z. Unit: rad/s. Frame: vehicle. At rest and
    level: x 0, y 0, z 0. Positive: right side down, nose up, clockwise seen from above.
    """

    def __init__(self, scaled_gyro: types.Vector3f | codec.Numbers) -> None:
        self.scaled_gyro = codec.vector(scaled_gyro, types.Vector3f)


class ScaledMag(Data):
    """Scaled mag (0x80,0x06).

    Measured magnetic field, temperature compensated.

    Supported by 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-CX5-45, 3DM-GQ7-GNSS/INS,
    3DM-GX5-35 and 3DM-GX5-45.

    - 3dm-cv7-gnss-ins: Scaled Mag (0x80,0x06)
    """

    __slots__ = ("scaled_mag",)
    __match_args__ = ("scaled_mag",)

    SET = 0x80
    SETS = (0x80,)
    DESCRIPTOR = 0x06
    NAME = "sensor.scaled_mag"
    ROLE = "data"
    _LAYOUT = (("scaled_mag", "fff", types.Vector3f),)

    _VECTORS = {"scaled_mag": (types.Vector3f,)}

    scaled_mag: types.Vector3f
    """Magnetic field. Elements: x, y, z. Unit: gauss. Frame: vehicle."""

    def __init__(self, scaled_mag: types.Vector3f | codec.Numbers) -> None:
        self.scaled_mag = codec.vector(scaled_mag, types.Vector3f)


class DeltaTheta(Data):
    """Delta theta (0x80,0x07).

    Time integral of the angular rate over the period set by the message format.

    Supported by 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-35.

    - 3dm-gx5-15: 5.1.4 Delta Theta Vector (0x80, 0x07)
    - 3dm-cv7-gnss-ins: Delta Theta (0x80,0x07)
    """

    __slots__ = ("delta_theta",)
    __match_args__ = ("delta_theta",)

    SET = 0x80
    SETS = (0x80,)
    DESCRIPTOR = 0x07
    NAME = "sensor.delta_theta"
    ROLE = "data"
    _LAYOUT = (("delta_theta", "fff", types.Vector3f),)

    _VECTORS = {"delta_theta": (types.Vector3f,)}

    delta_theta: types.Vector3f
    """Integral of the angular rate. Elements: x, y, z. Unit: rad. Frame: vehicle. At rest and
    level: x 0, y 0, z 0. Positive: right side down, nose up, clockwise seen from above.
    """

    def __init__(self, delta_theta: types.Vector3f | codec.Numbers) -> None:
        self.delta_theta = codec.vector(delta_theta, types.Vector3f)


class DeltaVelocity(Data):
    """Delta velocity (0x80,0x08).

    Time integral of the acceleration over the period set by the message format.

    Supported by 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS and 3DM-GX5-15.

    Multiply by 9.80665 m/s^2 for a change of velocity in metres per second. It includes gravity.
    Divided by the period, z is -1 g on a device that is level and at rest.

    - 3dm-gx5-15: 5.1.5 Delta Velocity Vector (0x80, 0x08)
    - 3dm-cv7-gnss-ins: Delta Velocity (0x80,0x08)
    """

    __slots__ = ("delta_velocity",)
    __match_args__ = ("delta_velocity",)

    SET = 0x80
    SETS = (0x80,)
    DESCRIPTOR = 0x08
    NAME = "sensor.delta_velocity"
    ROLE = "data"
    _LAYOUT = (("delta_velocity", "fff", types.Vector3f),)

    _VECTORS = {"delta_velocity": (types.Vector3f,)}

    delta_velocity: types.Vector3f
    """Integral of the acceleration. Elements: x, y, z. Unit: g*s. Frame: vehicle. At rest and
    level: x 0, y 0.
    """

    def __init__(self, delta_velocity: types.Vector3f | codec.Numbers) -> None:
        self.delta_velocity = codec.vector(delta_velocity, types.Vector3f)


class CompOrientationMatrix(Data):
    """Complementary filter orientation matrix (0x80,0x09).

    Attitude from the complementary filter as a direction cosine matrix, relative to the NED frame.

    Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.

    `v_vehicle = m * v_ned`; the 3DM-GX5-15 uses the sensor frame in place of the vehicle frame.

    - 3dm-gx5-15: 5.1.6 CF Orientation Matrix (0x80, 0x09)
    - 3dm-cv7-gnss-ins: Complementary Filter Orientation Matrix (0x80,0x09)
    """

    __slots__ = ("m",)
    __match_args__ = ("m",)

    SET = 0x80
    SETS = (0x80,)
    DESCRIPTOR = 0x09
    NAME = "sensor.comp_orientation_matrix"
    ROLE = "data"
    _LAYOUT = (("m", "fffffffff", types.Matrix3f),)

    _VECTORS = {"m": (types.Matrix3f,)}

    m: types.Matrix3f
    """Rotation from the NED frame to the vehicle frame. Elements: m11, m12, m13, m21, m22, m23,
    m31, m32, m33. Unit: 1. Frame: ned. At rest and level: m13 0, m23 0, m31 0, m32 0, m33 1.

    - On the 3DM-GX5-15: Rotation from the NED frame to the sensor frame.
    """

    def __init__(self, m: types.Matrix3f | codec.Rows) -> None:
        self.m = codec.vector(m, types.Matrix3f)


class CompQuaternion(Data):
    """Complementary filter quaternion (0x80,0x0A).

    Attitude from the complementary filter as a quaternion, relative to the NED frame.

    Supported by 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS and 3DM-GX5-15.

    `v_vehicle = q^-1 * v_ned * q`; the 3DM-GX5-15 uses the sensor frame in place of the vehicle
    frame.

    - 3dm-gx5-15: 5.1.7 CF Quaternion (0x80, 0x0A)
    - 3dm-cv7-gnss-ins: Complementary Filter Quaternion (0x80,0x0A)
    """

    __slots__ = ("q",)
    __match_args__ = ("q",)

    SET = 0x80
    SETS = (0x80,)
    DESCRIPTOR = 0x0A
    NAME = "sensor.comp_quaternion"
    ROLE = "data"
    _LAYOUT = (("q", "ffff", types.Quatf),)

    _VECTORS = {"q": (types.Quatf,)}

    q: types.Quatf
    """Rotation between the NED frame and the vehicle frame. Elements: w, x, y, z. Unit: 1. Frame:
    ned. At rest and level: x 0, y 0.

    - On the 3DM-GX5-15: Rotation between the NED frame and the sensor frame.
    """

    def __init__(self, q: types.Quatf | codec.Numbers) -> None:
        self.q = codec.vector(q, types.Quatf)


class CompOrientationUpdateMatrix(Data):
    """Complementary filter orientation update matrix (0x80,0x0B).

    Change in the complementary filter's attitude, as a matrix.

    Deprecated: the SDK marks it as deprecated and names no replacement. Not listed in any device
    profile. Known only from the MIP SDK of 2014 and MicroStrain MIP SDK. Uncertain: The interval of
    the change and the frames. The SDK and the SDK of 2014 state only the name and the layout.

    - mip-sdk-4: Comp Orientation Update Matrix (0x80,0x0B)
    - mip-sdk-2014: Orientation Update Matrix (0x80,0x0B)
    """

    __slots__ = ("m",)
    __match_args__ = ("m",)

    SET = 0x80
    SETS = (0x80,)
    DESCRIPTOR = 0x0B
    NAME = "sensor.comp_orientation_update_matrix"
    ROLE = "data"
    _LAYOUT = (("m", "fffffffff", types.Matrix3f),)

    _VECTORS = {"m": (types.Matrix3f,)}

    m: types.Matrix3f
    """Matrix in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit: 1."""

    def __init__(self, m: types.Matrix3f | codec.Rows) -> None:
        self.m = codec.vector(m, types.Matrix3f)


class CompEulerAngles(Data):
    """Complementary filter Euler angles (0x80,0x0C).

    Attitude from the complementary filter as Euler angles, relative to the NED frame.

    Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15. Uncertain: The ranges of the angles. Uncertain:
    which no source states.

    The rotations are in the order yaw, pitch, roll (3-2-1).

    - 3dm-gx5-15: 5.1.8 CF Euler Angles (0x80, 0x0C)
    - 3dm-cv7-gnss-ins: Complementary Filter Euler Angles (0x80,0x0C)
    """

    __slots__ = ("roll", "pitch", "yaw")
    __match_args__ = ("roll", "pitch", "yaw")

    SET = 0x80
    SETS = (0x80,)
    DESCRIPTOR = 0x0C
    NAME = "sensor.comp_euler_angles"
    ROLE = "data"
    _LAYOUT = (("roll", "f", None), ("pitch", "f", None), ("yaw", "f", None))

    roll: float
    """Roll angle. Unit: rad. Frame: ned. Range: -3.141592653589793 to 3.141592653589793. At rest
    and level: 0. Positive: right side down.
    """
    pitch: float
    """Pitch angle. Unit: rad. Frame: ned. Range: -1.5707963267948966 to 1.5707963267948966. At rest
    and level: 0. Positive: nose up.
    """
    yaw: float
    """Yaw angle. Unit: rad. Frame: ned. Range: -3.141592653589793 to 3.141592653589793. Positive:
    clockwise seen from above.
    """

    def __init__(self, roll: float, pitch: float, yaw: float) -> None:
        self.roll = roll
        self.pitch = pitch
        self.yaw = yaw


class OrientationRawTemperature(Data):
    """Orientation raw temperatures (0x80,0x0D).

    Raw readings of four temperature sensors.

    Deprecated: the SDK marks it as deprecated and names no replacement. Also called
    `orientation_raw_temp`. Not listed in any device profile. Known only from the MIP SDK of 2014
    and MicroStrain MIP SDK.

    The first sensor belongs to the magnetometer, the second to gyroscope 3 and accelerometer 3, the
    third to gyroscope 2 and accelerometers 1 and 2, the fourth to gyroscope 1.

    - mip-sdk-4: Orientation Raw Temp (0x80,0x0D)
    - mip-sdk-2014: Raw Temperature (0x80,0x0D)
    """

    __slots__ = ("raw_temperature",)
    __match_args__ = ("raw_temperature",)

    SET = 0x80
    SETS = (0x80,)
    DESCRIPTOR = 0x0D
    NAME = "sensor.orientation_raw_temperature"
    ROLE = "data"
    _LAYOUT = (("raw_temperature", "HHHH", tuple),)

    raw_temperature: tuple[int, int, int, int]
    """Temperatures in counts. Unit: 1. Uncertain: The scale, and which axes the numbers 1 to 3 are.
    """

    def __init__(self, raw_temperature: Sequence[int]) -> None:
        self.raw_temperature = codec.several(raw_temperature)


class InternalTimestamp(Data):
    """Internal timestamp (0x80,0x0E).

    Free-running counter of the device.

    Deprecated: the SDK marks it as deprecated and names no replacement. Not listed in any device
    profile. Known only from the MIP SDK of 2014 and MicroStrain MIP SDK. Uncertain: Which devices
    send it. The SDK of 2014 is for devices of the 3-series and 4-series.

    - mip-sdk-4: Internal timestamp (0x80,0x0E)
    - mip-sdk-2014: Internal timestamp (0x80,0x0E)
    """

    __slots__ = ("counts",)
    __match_args__ = ("counts",)

    SET = 0x80
    SETS = (0x80,)
    DESCRIPTOR = 0x0E
    NAME = "sensor.internal_timestamp"
    ROLE = "data"
    _LAYOUT = (("counts", "I", None),)

    counts: int
    """Counter: 62 500 counts per second, 16 us each. Unit: 1."""

    def __init__(self, counts: int) -> None:
        self.counts = counts


class PpsTimestamp(Data):
    """PPS timestamp (0x80,0x0F).

    Time counted by the pulse per second.

    Deprecated: the SDK marks it as deprecated and names no replacement. Distinguished from
    `PpsTimestampWithFlags` by the size of its data. Not listed in any device profile. Known only
    from the MicroStrain MIP SDK. Uncertain: Whether any device sends it. `PpsTimestampWithFlags`
    has more sources. Uncertain: The epoch.

    The sources contradict each other. Only the SDK has this layout.

    - mip-sdk-4: PPS timestamp (0x80,0x0F)
    """

    __slots__ = ("seconds", "useconds")
    __match_args__ = ("seconds", "useconds")

    SET = 0x80
    SETS = (0x80,)
    DESCRIPTOR = 0x0F
    NAME = "sensor.pps_timestamp"
    ROLE = "data"
    _LAYOUT = (("seconds", "I", None), ("useconds", "I", None))

    seconds: int
    """Whole seconds. Unit: s. Uncertain: The unit; it follows from the name."""
    useconds: int
    """Fraction of the second. Unit: us. Uncertain: The unit; it follows from the name."""

    def __init__(self, seconds: int, useconds: int) -> None:
        self.seconds = seconds
        self.useconds = useconds

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return len(data) < 9


class PpsTimestampWithFlags(Data):
    """PPS timestamp with flags (0x80,0x0F).

    Time counted by the pulse per second, with its state and nanoseconds.

    Deprecated: the SDK marks the descriptor as deprecated and names no replacement. Distinguished
    from `PpsTimestamp` by the size of its data. Not listed in any device profile. Known only from
    the MIP SDK of 2014 and MicroStrain Communication Library. Uncertain: Which devices send it. The
    SDK of 2014 dates from the time of the 3DM-GX3 devices. Uncertain: The epoch.

    The sources disagree on the layout; this one is from MSCL and the SDK of 2014.

    - mscl: 1PPS Timestamp (0x80,0x0F)
    - mip-sdk-2014: 1PPS Timestamp (0x80,0x0F)
    """

    __slots__ = ("flags", "seconds", "nanoseconds")
    __match_args__ = ("flags", "seconds", "nanoseconds")

    SET = 0x80
    SETS = (0x80,)
    DESCRIPTOR = 0x0F
    NAME = "sensor.pps_timestamp_with_flags"
    ROLE = "data"
    _LAYOUT = (("flags", "B", None), ("seconds", "I", None), ("nanoseconds", "I", None))

    flags: int
    """State of the time. Uncertain: The meaning of the bits, which no source states."""
    seconds: int
    """Whole seconds. Unit: s."""
    nanoseconds: int
    """Fraction of the second. Unit: ns."""

    def __init__(self, flags: int, seconds: int, nanoseconds: int) -> None:
        self.flags = flags
        self.seconds = seconds
        self.nanoseconds = nanoseconds

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return 9 <= len(data)


class NorthVector(Data):
    """Complementary filter stabilized north vector (0x80,0x10).

    Estimate of the geomagnetic field by the complementary filter, free of short disturbances.

    Supported by 3DM-GX5-15.

    Without magnetic disturbance it equals the measured magnetic field, unless a sensor-to-vehicle
    transformation moves the latter out of the sensor frame. A lasting disturbance is not
    compensated.

    - 3dm-gx5-15: 5.1.9 CF Stabilized North Vector (0x80, 0x10)
    """

    __slots__ = ("stabilized_mag",)
    __match_args__ = ("stabilized_mag",)

    SET = 0x80
    SETS = (0x80,)
    DESCRIPTOR = 0x10
    NAME = "sensor.north_vector"
    ROLE = "data"
    _LAYOUT = (("stabilized_mag", "fff", types.Vector3f),)

    _VECTORS = {"stabilized_mag": (types.Vector3f,)}

    stabilized_mag: types.Vector3f
    """Geomagnetic field. Elements: x, y, z. Unit: gauss. Frame: sensor. Uncertain: The frame. The
    SDK has the vehicle frame, but the lists of what the sensor-to-vehicle transformation changes
    lack this vector.
    """

    def __init__(self, stabilized_mag: types.Vector3f | codec.Numbers) -> None:
        self.stabilized_mag = codec.vector(stabilized_mag, types.Vector3f)


class UpVector(Data):
    """Complementary filter stabilized up vector (0x80,0x11).

    Estimate of the vertical (up) by the complementary filter, free of linear acceleration.

    Supported by 3DM-GX5-15 and 3DM-GX5-35.

    At rest it equals the measured acceleration, unless a sensor-to-vehicle transformation moves the
    latter out of the sensor frame.

    - 3dm-gx5-15: 5.1.10 CF Stabilized Up Vector (0x80, 0x11)
    - mip-sdk-4: Complementary filter stabilized up vector (0x80,0x11)
    """

    __slots__ = ("stabilized_accel",)
    __match_args__ = ("stabilized_accel",)

    SET = 0x80
    SETS = (0x80,)
    DESCRIPTOR = 0x11
    NAME = "sensor.up_vector"
    ROLE = "data"
    _LAYOUT = (("stabilized_accel", "fff", types.Vector3f),)

    _VECTORS = {"stabilized_accel": (types.Vector3f,)}

    stabilized_accel: types.Vector3f
    """Opposite of the gravity vector, as the accelerometers measure it. Elements: x, y, z. Unit: g.
    Frame: sensor. At rest and level: x 0, y 0, z -1. Uncertain: The frame. The SDK has the vehicle
    frame, but the lists of what the sensor-to-vehicle transformation changes lack this vector.
    """

    def __init__(self, stabilized_accel: types.Vector3f | codec.Numbers) -> None:
        self.stabilized_accel = codec.vector(stabilized_accel, types.Vector3f)


class GpsTimestamp(Data):
    """GPS timestamp (0x80,0x12).

    GPS time of the sensor data.

    Supported by 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-35.

    Without a PPS the time runs on the internal clock and jumps when the PPS returns. The fraction
    of the time of week is the time since the last pulse. Without external synchronization it is the
    internal system time. Where the device has it, use `shared.GpsTimestamp` instead; this field may
    be deprecated.

    - 3dm-gx5-15: 5.1.11 GPS Correlation Timestamp (0x80, 0x12)
    - 3dm-cv7-gnss-ins: GPS Timestamp (0x80,0x12)
    """

    __slots__ = ("tow", "week_number", "valid_flags")
    __match_args__ = ("tow", "week_number", "valid_flags")

    SET = 0x80
    SETS = (0x80,)
    DESCRIPTOR = 0x12
    NAME = "sensor.gps_timestamp"
    ROLE = "data"
    _LAYOUT = (
        ("tow", "d", None),
        ("week_number", "H", None),
        ("valid_flags", "H", types.SensorGpsTimestampFlags),
    )

    tow: float
    """GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if
    `types.SensorGpsTimestampFlags.TOW_VALID` of `valid_flags` is set.

    - On the 3DM-GX5-15 and 3DM-GX5-35: valid if `types.Gx5SensorGpsTimestampFlags.TIME_INITIALIZED`
      of `valid_flags` is set.
    """
    week_number: int
    """GPS week number. Unit: week. Valid if `types.SensorGpsTimestampFlags.WEEK_NUMBER_VALID` of
    `valid_flags` is set.

    - On the 3DM-GX5-15 and 3DM-GX5-35: valid if `types.Gx5SensorGpsTimestampFlags.TIME_INITIALIZED`
      of `valid_flags` is set.
    """
    valid_flags: types.SensorGpsTimestampFlags
    """State of the time.

    - On the 3DM-GX5-15 and 3DM-GX5-35: values of `types.Gx5SensorGpsTimestampFlags`.
    """

    def __init__(
        self, tow: float, week_number: int, valid_flags: types.SensorGpsTimestampFlags
    ) -> None:
        self.tow = tow
        self.week_number = week_number
        self.valid_flags = valid_flags


class TemperatureStatistics(Data):
    """Temperature statistics (0x80,0x14).

    Temperatures since the last power-on or reset.

    Also called `temperature_abs`. Supported by 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS.

    The values come from the inertial sensors, alone or together with sensors on the board.

    - 3dm-cv7-gnss-ins: Temperature Statistics (0x80,0x14)
    """

    __slots__ = ("min_temperature", "max_temperature", "mean_temperature")
    __match_args__ = ("min_temperature", "max_temperature", "mean_temperature")

    SET = 0x80
    SETS = (0x80,)
    DESCRIPTOR = 0x14
    NAME = "sensor.temperature_statistics"
    ROLE = "data"
    _LAYOUT = (
        ("min_temperature", "f", None),
        ("max_temperature", "f", None),
        ("mean_temperature", "f", None),
    )

    min_temperature: float
    """Lowest temperature. Unit: degC."""
    max_temperature: float
    """Highest temperature. Unit: degC."""
    mean_temperature: float
    """Mean of the temperatures inside the device. Unit: degC."""

    def __init__(
        self, min_temperature: float, max_temperature: float, mean_temperature: float
    ) -> None:
        self.min_temperature = min_temperature
        self.max_temperature = max_temperature
        self.mean_temperature = mean_temperature


class RawPressure(Data):
    """Raw pressure (0x80,0x16).

    Raw ambient pressure in counts of the sensor, temperature compensated.

    Not listed in any device profile. Known only from the MicroStrain MIP SDK.

    - mip-sdk-4: Raw pressure (0x80,0x16)
    """

    __slots__ = ("raw_pressure",)
    __match_args__ = ("raw_pressure",)

    SET = 0x80
    SETS = (0x80,)
    DESCRIPTOR = 0x16
    NAME = "sensor.raw_pressure"
    ROLE = "data"
    _LAYOUT = (("raw_pressure", "f", None),)

    raw_pressure: float
    """Pressure in counts. Unit: 1."""

    def __init__(self, raw_pressure: float) -> None:
        self.raw_pressure = raw_pressure


class ScaledPressure(Data):
    """Scaled pressure (0x80,0x17).

    Measured ambient pressure, temperature compensated.

    Supported by 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS, 3DM-GX5-15 and
    3DM-GX5-35.

    - 3dm-gx5-15: 5.1.3 Scaled Ambient Pressure (0x80, 0x17)
    - 3dm-cv7-gnss-ins: Scaled Pressure (0x80,0x17)
    """

    __slots__ = ("scaled_pressure",)
    __match_args__ = ("scaled_pressure",)

    SET = 0x80
    SETS = (0x80,)
    DESCRIPTOR = 0x17
    NAME = "sensor.scaled_pressure"
    ROLE = "data"
    _LAYOUT = (("scaled_pressure", "f", None),)

    scaled_pressure: float
    """Ambient pressure. Unit: mbar. Range: at least 0."""

    def __init__(self, scaled_pressure: float) -> None:
        self.scaled_pressure = scaled_pressure


class OverrangeStatus(Data):
    """Overrange status (0x80,0x18).

    Sensor axes that are near or outside their range.

    Supported by 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Overrange Status (0x80,0x18)
    """

    __slots__ = ("status",)
    __match_args__ = ("status",)

    SET = 0x80
    SETS = (0x80,)
    DESCRIPTOR = 0x18
    NAME = "sensor.overrange_status"
    ROLE = "data"
    _LAYOUT = (("status", "H", OverrangeFlags),)

    status: OverrangeFlags
    """One bit for each axis."""

    def __init__(self, status: OverrangeFlags) -> None:
        self.status = status


class Odometer(Data):
    """Odometer data (0x80,0x40).

    Speed measured by the wheel encoder.

    Also called `odometer_data`. Supported by 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Odometer Data (0x80,0x40)
    """

    __slots__ = ("speed", "uncertainty", "valid_flags")
    __match_args__ = ("speed", "uncertainty", "valid_flags")

    SET = 0x80
    SETS = (0x80,)
    DESCRIPTOR = 0x40
    NAME = "sensor.odometer"
    ROLE = "data"
    _LAYOUT = (
        ("speed", "f", None),
        ("uncertainty", "f", None),
        ("valid_flags", "H", OdometerFlags),
    )

    speed: float
    """Average speed over the interval; negative values come from quadrature encoders only. Unit:
    m/s. Valid if `OdometerFlags.ODOMETER` of `valid_flags` is set.
    """
    uncertainty: float
    """Uncertainty of the speed. Unit: m/s. Range: at least 0. Valid if `OdometerFlags.ODOMETER` of
    `valid_flags` is set.
    """
    valid_flags: OdometerFlags
    """Validity of the measured values."""

    def __init__(self, speed: float, uncertainty: float, valid_flags: OdometerFlags) -> None:
        self.speed = speed
        self.uncertainty = uncertainty
        self.valid_flags = valid_flags


#: Descriptor -> its types; several if constants or the size of the data distinguish layouts.
FIELDS: dict[int, tuple[type[Field], ...]] = {
    0x01: (RawAccel,),
    0x02: (RawGyro,),
    0x03: (RawMag,),
    0x04: (ScaledAccel,),
    0x05: (ScaledGyro,),
    0x06: (ScaledMag,),
    0x07: (DeltaTheta,),
    0x08: (DeltaVelocity,),
    0x09: (CompOrientationMatrix,),
    0x0A: (CompQuaternion,),
    0x0B: (CompOrientationUpdateMatrix,),
    0x0C: (CompEulerAngles,),
    0x0D: (OrientationRawTemperature,),
    0x0E: (InternalTimestamp,),
    0x0F: (PpsTimestamp, PpsTimestampWithFlags),
    0x10: (NorthVector,),
    0x11: (UpVector,),
    0x12: (GpsTimestamp,),
    0x14: (TemperatureStatistics,),
    0x16: (RawPressure,),
    0x17: (ScaledPressure,),
    0x18: (OverrangeStatus,),
    0x40: (Odometer,),
}
