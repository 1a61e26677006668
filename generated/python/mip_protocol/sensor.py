"""Sensor data (0x80).

Inertial, magnetic and pressure measurements, and the attitude of the complementary filter.

- 3dm-gx5-15: 5.1 IMU Data
- 3dm-cv7-gnss-ins: Sensor (0x80)
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import IntFlag
from typing import Any

from . import codec, types
from .field import Data, Field

# Numbers that are read and written together, by their letters for `struct`.
_2I = codec.Block("2I")

_2fH = codec.Block("2fH")

_3f = codec.Block("3f")

_4H = codec.Block("4H")

_4f = codec.Block("4f")

_9f = codec.Block("9f")

_B2I = codec.Block("B2I")

_H = codec.Block("H")

_I = codec.Block("I")

_d2H = codec.Block("d2H")

_f = codec.Block("f")


@codec.open_flag(16)
class OverrangeFlags(IntFlag):
    """Sensor axes that were near or outside their range."""

    ACCEL_X = 1 << 0
    """The accelerometer x axis is near or outside its range. Bit 0. Affects `ScaledAccel`."""
    ACCEL_Y = 1 << 1
    """The accelerometer y axis is near or outside its range. Bit 1. Affects `ScaledAccel`."""
    ACCEL_Z = 1 << 2
    """The accelerometer z axis is near or outside its range. Bit 2. Affects `ScaledAccel`."""
    GYRO_X = 1 << 4
    """The gyroscope x axis is near or outside its range. Bit 4. Affects `ScaledGyro`."""
    GYRO_Y = 1 << 5
    """The gyroscope y axis is near or outside its range. Bit 5. Affects `ScaledGyro`."""
    GYRO_Z = 1 << 6
    """The gyroscope z axis is near or outside its range. Bit 6. Affects `ScaledGyro`."""
    MAG_X = 1 << 8
    """The magnetometer x axis is near or outside its range. Bit 8. Affects `ScaledMag`. Requires a
    magnetometer.
    """
    MAG_Y = 1 << 9
    """The magnetometer y axis is near or outside its range. Bit 9. Affects `ScaledMag`. Requires a
    magnetometer.
    """
    MAG_Z = 1 << 10
    """The magnetometer z axis is near or outside its range. Bit 10. Affects `ScaledMag`. Requires a
    magnetometer.
    """
    PRESSURE = 1 << 12
    """The pressure sensor is near or outside its range. Bit 12. Affects `ScaledPressure`. Requires
    a pressure sensor.
    """


@codec.open_flag(16)
class OdometerFlags(IntFlag):
    """Validity of the odometer values."""

    ODOMETER = 1 << 0
    """Set if an odometer is configured; its values are then valid. Bit 0."""


class RawAccel(Data):
    """Raw accel (0x80,0x01).

    Raw acceleration in sensor counts, temperature compensated.

    Not listed in any device profile. Known only from the MIP SDK of 2014 and MicroStrain MIP SDK.

    - mip-sdk-4: Raw accel (0x80,0x01)
    - mip-sdk-2014: Raw accel (0x80,0x01)
    """

    __slots__ = ("raw_accel",)
    __match_args__ = ("raw_accel",)

    SET = 0x80
    DESCRIPTOR = 0x01
    NAME = "sensor.raw_accel"
    _SIZE = 12
    _VECTORS = {"raw_accel": (types.Vector3f,)}

    raw_accel: types.Vector3f
    """Acceleration in counts. Elements: x, y, z. Unit: 1. Frame: sensor."""

    def __init__(self, raw_accel: types.Vector3f | codec.Numbers) -> None:
        self.raw_accel = codec.vector(raw_accel, types.Vector3f)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _3f.unpack(raw, at)
        if (total := v[0] + v[1] + v[2]) != total:
            v = _3f.keep_nan_bits(v, raw, at)
        self._raw_accel = v
        return at + 12

    def _write(self) -> bytes:
        return _3f.write("raw_accel*3", *codec.elements("raw_accel", self.raw_accel, 3))


class RawGyro(Data):
    """Raw gyro (0x80,0x02).

    Raw angular rate in sensor counts, temperature compensated.

    Not listed in any device profile. Known only from the MIP SDK of 2014 and MicroStrain MIP SDK.

    - mip-sdk-4: Raw gyro (0x80,0x02)
    - mip-sdk-2014: Raw gyro (0x80,0x02)
    """

    __slots__ = ("raw_gyro",)
    __match_args__ = ("raw_gyro",)

    SET = 0x80
    DESCRIPTOR = 0x02
    NAME = "sensor.raw_gyro"
    _SIZE = 12
    _VECTORS = {"raw_gyro": (types.Vector3f,)}

    raw_gyro: types.Vector3f
    """Angular rate in counts. Elements: x, y, z. Unit: 1. Frame: sensor."""

    def __init__(self, raw_gyro: types.Vector3f | codec.Numbers) -> None:
        self.raw_gyro = codec.vector(raw_gyro, types.Vector3f)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _3f.unpack(raw, at)
        if (total := v[0] + v[1] + v[2]) != total:
            v = _3f.keep_nan_bits(v, raw, at)
        self._raw_gyro = v
        return at + 12

    def _write(self) -> bytes:
        return _3f.write("raw_gyro*3", *codec.elements("raw_gyro", self.raw_gyro, 3))


class RawMag(Data):
    """Raw mag (0x80,0x03).

    Raw magnetic field in sensor counts, temperature compensated.

    Not listed in any device profile. Known only from the MIP SDK of 2014 and MicroStrain MIP SDK.
    Requires a magnetometer.

    - mip-sdk-4: Raw mag (0x80,0x03)
    - mip-sdk-2014: Raw mag (0x80,0x03)
    """

    __slots__ = ("raw_mag",)
    __match_args__ = ("raw_mag",)

    SET = 0x80
    DESCRIPTOR = 0x03
    NAME = "sensor.raw_mag"
    _SIZE = 12
    _VECTORS = {"raw_mag": (types.Vector3f,)}

    raw_mag: types.Vector3f
    """Magnetic field in counts. Elements: x, y, z. Unit: 1. Frame: vehicle. Uncertain: The frame is
    doubtful: the SDK has the vehicle frame here, but the sensor frame for raw acceleration and raw
    angular rate.
    """

    def __init__(self, raw_mag: types.Vector3f | codec.Numbers) -> None:
        self.raw_mag = codec.vector(raw_mag, types.Vector3f)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _3f.unpack(raw, at)
        if (total := v[0] + v[1] + v[2]) != total:
            v = _3f.keep_nan_bits(v, raw, at)
        self._raw_mag = v
        return at + 12

    def _write(self) -> bytes:
        return _3f.write("raw_mag*3", *codec.elements("raw_mag", self.raw_mag, 3))


class ScaledAccel(Data):
    """Scaled accel (0x80,0x04).

    Specific force, temperature compensated: about -1 g on z when level and at rest.

    Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-CX5-45, 3DM-GQ7-GNSS/INS,
    3DM-GX5-15, 3DM-GX5-35 and 3DM-GX5-45; likely or assumed on 24 more.

    At rest, it is the opposite of the gravity vector.

    - 3dm-gx5-15: 5.1.1 Scaled Accelerometer Vector (0x80, 0x04)
    - 3dm-cv7-gnss-ins: Scaled Accel (0x80,0x04)
    """

    __slots__ = ("scaled_accel",)
    __match_args__ = ("scaled_accel",)

    SET = 0x80
    DESCRIPTOR = 0x04
    NAME = "sensor.scaled_accel"
    _SIZE = 12
    _VECTORS = {"scaled_accel": (types.Vector3f,)}

    scaled_accel: types.Vector3f
    """Specific force: acceleration minus gravity. Elements: x, y, z. Unit: g. Frame: vehicle. At
    rest and level: x 0, y 0, z -1.
    """

    def __init__(self, scaled_accel: types.Vector3f | codec.Numbers) -> None:
        self.scaled_accel = codec.vector(scaled_accel, types.Vector3f)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _3f.unpack(raw, at)
        if (total := v[0] + v[1] + v[2]) != total:
            v = _3f.keep_nan_bits(v, raw, at)
        self._scaled_accel = v
        return at + 12

    def _write(self) -> bytes:
        return _3f.write("scaled_accel*3", *codec.elements("scaled_accel", self.scaled_accel, 3))


class ScaledGyro(Data):
    """Scaled gyro (0x80,0x05).

    Measured angular rate, temperature compensated.

    Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-CX5-45, 3DM-GQ7-GNSS/INS,
    3DM-GX5-15, 3DM-GX5-35 and 3DM-GX5-45; likely or assumed on 24 more.

    - 3dm-gx5-15: 5.1.2 Scaled Gyro Vector (0x80, 0x05)
    - 3dm-cv7-gnss-ins: Scaled Gyro (0x80,0x05)
    """

    __slots__ = ("scaled_gyro",)
    __match_args__ = ("scaled_gyro",)

    SET = 0x80
    DESCRIPTOR = 0x05
    NAME = "sensor.scaled_gyro"
    _SIZE = 12
    _VECTORS = {"scaled_gyro": (types.Vector3f,)}

    scaled_gyro: types.Vector3f
    """Angular rate about each axis. Elements: x, y, z. Unit: rad/s. Frame: vehicle. At rest and
    level: x 0, y 0, z 0. Positive: right side down, nose up, clockwise seen from above.
    """

    def __init__(self, scaled_gyro: types.Vector3f | codec.Numbers) -> None:
        self.scaled_gyro = codec.vector(scaled_gyro, types.Vector3f)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _3f.unpack(raw, at)
        if (total := v[0] + v[1] + v[2]) != total:
            v = _3f.keep_nan_bits(v, raw, at)
        self._scaled_gyro = v
        return at + 12

    def _write(self) -> bytes:
        return _3f.write("scaled_gyro*3", *codec.elements("scaled_gyro", self.scaled_gyro, 3))


class ScaledMag(Data):
    """Scaled mag (0x80,0x06).

    Measured magnetic field, temperature compensated.

    Confirmed on 3DM-CV7-AHRS, 3DM-CV7-GNSS/INS, 3DM-CX5-45, 3DM-GQ7-GNSS/INS, 3DM-GX5-35 and
    3DM-GX5-45; likely or assumed on 16 more. Requires a magnetometer.

    - 3dm-cv7-gnss-ins: Scaled Mag (0x80,0x06)
    """

    __slots__ = ("scaled_mag",)
    __match_args__ = ("scaled_mag",)

    SET = 0x80
    DESCRIPTOR = 0x06
    NAME = "sensor.scaled_mag"
    _SIZE = 12
    _VECTORS = {"scaled_mag": (types.Vector3f,)}

    scaled_mag: types.Vector3f
    """Magnetic field. Elements: x, y, z. Unit: gauss. Frame: vehicle."""

    def __init__(self, scaled_mag: types.Vector3f | codec.Numbers) -> None:
        self.scaled_mag = codec.vector(scaled_mag, types.Vector3f)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _3f.unpack(raw, at)
        if (total := v[0] + v[1] + v[2]) != total:
            v = _3f.keep_nan_bits(v, raw, at)
        self._scaled_mag = v
        return at + 12

    def _write(self) -> bytes:
        return _3f.write("scaled_mag*3", *codec.elements("scaled_mag", self.scaled_mag, 3))


class DeltaTheta(Data):
    """Delta theta (0x80,0x07).

    Time integral of the angular rate over the period set by the message format.

    Confirmed on 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-35; likely or assumed on
    21 more.

    - 3dm-gx5-15: 5.1.4 Delta Theta Vector (0x80, 0x07)
    - 3dm-cv7-gnss-ins: Delta Theta (0x80,0x07)
    """

    __slots__ = ("delta_theta",)
    __match_args__ = ("delta_theta",)

    SET = 0x80
    DESCRIPTOR = 0x07
    NAME = "sensor.delta_theta"
    _SIZE = 12
    _VECTORS = {"delta_theta": (types.Vector3f,)}

    delta_theta: types.Vector3f
    """Integral of the angular rate. Elements: x, y, z. Unit: rad. Frame: vehicle. At rest and
    level: x 0, y 0, z 0. Positive: right side down, nose up, clockwise seen from above.
    """

    def __init__(self, delta_theta: types.Vector3f | codec.Numbers) -> None:
        self.delta_theta = codec.vector(delta_theta, types.Vector3f)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _3f.unpack(raw, at)
        if (total := v[0] + v[1] + v[2]) != total:
            v = _3f.keep_nan_bits(v, raw, at)
        self._delta_theta = v
        return at + 12

    def _write(self) -> bytes:
        return _3f.write("delta_theta*3", *codec.elements("delta_theta", self.delta_theta, 3))


class DeltaVelocity(Data):
    """Delta velocity (0x80,0x08).

    Time integral of the specific force over the period set by the message format.

    Confirmed on 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS and 3DM-GX5-15; likely or assumed on 22 more.

    Multiply by 9.80665 m/s^2 for a change of velocity in metres per second. Divided by the period,
    z is -1 g on a device that is level and at rest.

    - 3dm-gx5-15: 5.1.5 Delta Velocity Vector (0x80, 0x08)
    - 3dm-cv7-gnss-ins: Delta Velocity (0x80,0x08)
    """

    __slots__ = ("delta_velocity",)
    __match_args__ = ("delta_velocity",)

    SET = 0x80
    DESCRIPTOR = 0x08
    NAME = "sensor.delta_velocity"
    _SIZE = 12
    _VECTORS = {"delta_velocity": (types.Vector3f,)}

    delta_velocity: types.Vector3f
    """Integral of the specific force: acceleration minus gravity. Elements: x, y, z. Unit: g*s.
    Frame: vehicle. At rest and level: x 0, y 0.
    """

    def __init__(self, delta_velocity: types.Vector3f | codec.Numbers) -> None:
        self.delta_velocity = codec.vector(delta_velocity, types.Vector3f)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _3f.unpack(raw, at)
        if (total := v[0] + v[1] + v[2]) != total:
            v = _3f.keep_nan_bits(v, raw, at)
        self._delta_velocity = v
        return at + 12

    def _write(self) -> bytes:
        return _3f.write(
            "delta_velocity*3", *codec.elements("delta_velocity", self.delta_velocity, 3)
        )


class CompOrientationMatrix(Data):
    """Complementary filter orientation matrix (0x80,0x09).

    Attitude from the complementary filter as a direction cosine matrix, relative to the NED frame.

    Confirmed on 3DM-CV7-GNSS/INS and 3DM-GX5-15; likely or assumed on 21 more.

    `v_vehicle = m * v_ned`; the 3DM-GX5-15 uses the sensor frame in place of the vehicle frame.

    - 3dm-gx5-15: 5.1.6 CF Orientation Matrix (0x80, 0x09)
    - 3dm-cv7-gnss-ins: Complementary Filter Orientation Matrix (0x80,0x09)
    """

    __slots__ = ("m",)
    __match_args__ = ("m",)

    SET = 0x80
    DESCRIPTOR = 0x09
    NAME = "sensor.comp_orientation_matrix"
    _SIZE = 36
    _VECTORS = {"m": (types.Matrix3f,)}

    m: types.Matrix3f
    """Rotates vectors of the NED frame into the vehicle frame; row-major. Elements: m11, m12, m13,
    m21, m22, m23, m31, m32, m33. Unit: 1. Frame: ned. At rest and level: m13 0, m23 0, m31 0, m32
    0, m33 1.

    - On the 3DM-GX5-15: Rotates vectors of the NED frame into the sensor frame; row-major.
    """

    def __init__(self, m: types.Matrix3f | codec.Rows) -> None:
        self.m = codec.vector(m, types.Matrix3f)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _9f.unpack(raw, at)
        if (total := sum(v)) != total:
            v = _9f.keep_nan_bits(v, raw, at)
        self._m = v
        return at + 36

    def _write(self) -> bytes:
        return _9f.write("m*9", *codec.elements("m", self.m, 9))


class CompQuaternion(Data):
    """Complementary filter quaternion (0x80,0x0A).

    Attitude from the complementary filter as a quaternion, relative to the NED frame.

    Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS and 3DM-GX5-15; likely
    or assumed on 18 more.

    The 3DM-GX5-15 uses the sensor frame in place of the vehicle frame. `v_ned = q * v_vehicle *
    q^-1`

    - 3dm-gx5-15: 5.1.7 CF Quaternion (0x80, 0x0A)
    - 3dm-cv7-gnss-ins: Complementary Filter Quaternion (0x80,0x0A)
    """

    __slots__ = ("q",)
    __match_args__ = ("q",)

    SET = 0x80
    DESCRIPTOR = 0x0A
    NAME = "sensor.comp_quaternion"
    _SIZE = 16
    _VECTORS = {"q": (types.Quatf,)}

    q: types.Quatf
    """Rotates vectors of the vehicle frame into the NED frame; Hamilton quaternion, w first.
    Elements: w, x, y, z. Unit: 1. Frame: ned. At rest and level: x 0, y 0.

    - On the 3DM-GX5-15: Rotates vectors of the sensor frame into the NED frame; Hamilton
      quaternion, w first.
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


class CompOrientationUpdateMatrix(Data):
    """Complementary filter orientation update matrix (0x80,0x0B).

    Change in the complementary filter's attitude, as a matrix.

    Deprecated: the SDK marks it as deprecated and names no replacement. Not listed in any device
    profile. Known only from the MIP SDK of 2014 and MicroStrain MIP SDK. Uncertain: No source
    states the interval of the change and the frames; the SDKs state only the name and the layout.

    - mip-sdk-4: Comp Orientation Update Matrix (0x80,0x0B)
    - mip-sdk-2014: Orientation Update Matrix (0x80,0x0B)
    """

    __slots__ = ("m",)
    __match_args__ = ("m",)

    SET = 0x80
    DESCRIPTOR = 0x0B
    NAME = "sensor.comp_orientation_update_matrix"
    _SIZE = 36
    _VECTORS = {"m": (types.Matrix3f,)}

    m: types.Matrix3f
    """Matrix in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit: 1."""

    def __init__(self, m: types.Matrix3f | codec.Rows) -> None:
        self.m = codec.vector(m, types.Matrix3f)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _9f.unpack(raw, at)
        if (total := sum(v)) != total:
            v = _9f.keep_nan_bits(v, raw, at)
        self._m = v
        return at + 36

    def _write(self) -> bytes:
        return _9f.write("m*9", *codec.elements("m", self.m, 9))


class CompEulerAngles(Data):
    """Complementary filter Euler angles (0x80,0x0C).

    Attitude from the complementary filter as Euler angles, relative to the NED frame.

    Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS and 3DM-GX5-15; likely or assumed on 19
    more. Uncertain: The ranges of the angles are inferred; no source states them.

    - 3dm-gx5-15: 5.1.8 CF Euler Angles (0x80, 0x0C)
    - 3dm-cv7-gnss-ins: Complementary Filter Euler Angles (0x80,0x0C)
    """

    __slots__ = ("roll", "pitch", "yaw")
    __match_args__ = ("roll", "pitch", "yaw")

    SET = 0x80
    DESCRIPTOR = 0x0C
    NAME = "sensor.comp_euler_angles"
    _SIZE = 12

    roll: float
    """Roll angle, applied after yaw and pitch (order 3-2-1). Unit: rad. Frame: ned. Range: -pi to
    pi. At rest and level: 0. Positive: right side down.
    """
    pitch: float
    """Pitch angle. Unit: rad. Frame: ned. Range: -1.5707963267948966 to 1.5707963267948966. At rest
    and level: 0. Positive: nose up.
    """
    yaw: float
    """Yaw angle. Unit: rad. Frame: ned. Range: -pi to pi. Positive: clockwise seen from above."""

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
    DESCRIPTOR = 0x0D
    NAME = "sensor.orientation_raw_temperature"
    _SIZE = 8

    raw_temperature: tuple[int, int, int, int]
    """Temperatures in counts. Unit: 1. Uncertain: No source states the scale, or the axes of the
    numbers 1 to 3.
    """

    def __init__(self, raw_temperature: Sequence[int]) -> None:
        self.raw_temperature = codec.several(raw_temperature)

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.raw_temperature = _4H.unpack(raw, at)
        return at + 8

    def _write(self) -> bytes:
        return _4H.write(
            "raw_temperature*4", *codec.exactly("raw_temperature", self.raw_temperature, 4)
        )


class InternalTimestamp(Data):
    """Internal timestamp (0x80,0x0E).

    Free-running counter of the device.

    Deprecated: the SDK marks it as deprecated and names no replacement. Not listed in any device
    profile. Known only from the MIP SDK of 2014 and MicroStrain MIP SDK. Uncertain: No source lists
    the devices that send it; the SDK of 2014 is for devices of the 3-series and 4-series.

    - mip-sdk-4: Internal timestamp (0x80,0x0E)
    - mip-sdk-2014: Internal timestamp (0x80,0x0E)
    """

    __slots__ = ("counts",)
    __match_args__ = ("counts",)

    SET = 0x80
    DESCRIPTOR = 0x0E
    NAME = "sensor.internal_timestamp"
    _SIZE = 4

    counts: int
    """Counter: 62 500 counts per second, 16 us each. Unit: 1."""

    def __init__(self, counts: int) -> None:
        self.counts = counts

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.counts = _I.unpack(raw, at)[0]
        return at + 4

    def _write(self) -> bytes:
        return _I.write("counts", self.counts)


class PpsTimestamp(Data):
    """PPS timestamp (0x80,0x0F).

    Time counted by the pulse per second.

    Deprecated: the SDK marks it as deprecated and names no replacement. The size of its data
    distinguishes it from `PpsTimestampWithFlags`. Not listed in any device profile. Known only from
    the MicroStrain MIP SDK. Uncertain: Possibly no device sends it; `PpsTimestampWithFlags` has
    more sources. Uncertain: No source states the epoch.

    The sources contradict each other. Only the SDK has this layout.

    - mip-sdk-4: PPS timestamp (0x80,0x0F)
    """

    __slots__ = ("seconds", "useconds")
    __match_args__ = ("seconds", "useconds")

    SET = 0x80
    DESCRIPTOR = 0x0F
    NAME = "sensor.pps_timestamp"
    _SIZE = 8

    seconds: int
    """Whole seconds. Unit: s. Uncertain: The unit is inferred from the name."""
    useconds: int
    """Fraction of the second. Unit: us. Uncertain: The unit is inferred from the name."""

    def __init__(self, seconds: int, useconds: int) -> None:
        self.seconds = seconds
        self.useconds = useconds

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.seconds, self.useconds = _2I.unpack(raw, at)
        return at + 8

    def _write(self) -> bytes:
        return _2I.write("seconds useconds", self.seconds, self.useconds)

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return len(data) < 9


class PpsTimestampWithFlags(Data):
    """PPS timestamp with flags (0x80,0x0F).

    Time counted by the pulse per second, with its state and nanoseconds.

    Deprecated: the SDK marks the descriptor as deprecated and names no replacement. The size of its
    data distinguishes it from `PpsTimestamp`. Not listed in any device profile. Known only from the
    MIP SDK of 2014 and MicroStrain Communication Library. Uncertain: No source lists the devices
    that send it; the SDK of 2014 dates from the time of the 3DM-GX3. Uncertain: No source states
    the epoch.

    The sources disagree on the layout; this one is from MSCL and the SDK of 2014.

    - mscl: 1PPS Timestamp (0x80,0x0F)
    - mip-sdk-2014: 1PPS Timestamp (0x80,0x0F)
    """

    __slots__ = ("flags", "seconds", "nanoseconds")
    __match_args__ = ("flags", "seconds", "nanoseconds")

    SET = 0x80
    DESCRIPTOR = 0x0F
    NAME = "sensor.pps_timestamp_with_flags"
    _SIZE = 9

    flags: int
    """State of the time. Uncertain: No source states the meaning of the bits."""
    seconds: int
    """Whole seconds. Unit: s."""
    nanoseconds: int
    """Fraction of the second. Unit: ns."""

    def __init__(self, flags: int, seconds: int, nanoseconds: int) -> None:
        self.flags = flags
        self.seconds = seconds
        self.nanoseconds = nanoseconds

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.flags, self.seconds, self.nanoseconds = _B2I.unpack(raw, at)
        return at + 9

    def _write(self) -> bytes:
        return _B2I.write("flags seconds nanoseconds", self.flags, self.seconds, self.nanoseconds)

    @classmethod
    def matches(cls, data: bytes) -> bool:
        return 9 <= len(data)


class NorthVector(Data):
    """Complementary filter stabilized north vector (0x80,0x10).

    Estimate of the geomagnetic field by the complementary filter, free of short disturbances.

    Confirmed on 3DM-GX5-15; likely or assumed on 11 more.

    Without magnetic disturbance it equals the measured magnetic field, unless a sensor-to-vehicle
    transformation moves the latter out of the sensor frame. A lasting disturbance is not
    compensated.

    - 3dm-gx5-15: 5.1.9 CF Stabilized North Vector (0x80, 0x10)
    """

    __slots__ = ("stabilized_mag",)
    __match_args__ = ("stabilized_mag",)

    SET = 0x80
    DESCRIPTOR = 0x10
    NAME = "sensor.north_vector"
    _SIZE = 12
    _VECTORS = {"stabilized_mag": (types.Vector3f,)}

    stabilized_mag: types.Vector3f
    """Geomagnetic field. Elements: x, y, z. Unit: gauss. Frame: sensor. Uncertain: The frame is
    doubtful: the SDK has the vehicle frame, but the lists of what the sensor-to-vehicle
    transformation changes lack this vector.
    """

    def __init__(self, stabilized_mag: types.Vector3f | codec.Numbers) -> None:
        self.stabilized_mag = codec.vector(stabilized_mag, types.Vector3f)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _3f.unpack(raw, at)
        if (total := v[0] + v[1] + v[2]) != total:
            v = _3f.keep_nan_bits(v, raw, at)
        self._stabilized_mag = v
        return at + 12

    def _write(self) -> bytes:
        return _3f.write(
            "stabilized_mag*3", *codec.elements("stabilized_mag", self.stabilized_mag, 3)
        )


class UpVector(Data):
    """Complementary filter stabilized up vector (0x80,0x11).

    Estimate of the vertical (up) by the complementary filter, free of linear acceleration.

    Confirmed on 3DM-GX5-15 and 3DM-GX5-35; likely or assumed on 10 more.

    At rest it equals the measured acceleration, unless a sensor-to-vehicle transformation moves the
    latter out of the sensor frame.

    - 3dm-gx5-15: 5.1.10 CF Stabilized Up Vector (0x80, 0x11)
    - mip-sdk-4: Complementary filter stabilized up vector (0x80,0x11)
    """

    __slots__ = ("stabilized_accel",)
    __match_args__ = ("stabilized_accel",)

    SET = 0x80
    DESCRIPTOR = 0x11
    NAME = "sensor.up_vector"
    _SIZE = 12
    _VECTORS = {"stabilized_accel": (types.Vector3f,)}

    stabilized_accel: types.Vector3f
    """Opposite of the gravity vector, as the accelerometers measure it. Elements: x, y, z. Unit: g.
    Frame: sensor. At rest and level: x 0, y 0, z -1. Uncertain: The frame is doubtful: the SDK has
    the vehicle frame, but the lists of what the sensor-to-vehicle transformation changes lack this
    vector.
    """

    def __init__(self, stabilized_accel: types.Vector3f | codec.Numbers) -> None:
        self.stabilized_accel = codec.vector(stabilized_accel, types.Vector3f)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _3f.unpack(raw, at)
        if (total := v[0] + v[1] + v[2]) != total:
            v = _3f.keep_nan_bits(v, raw, at)
        self._stabilized_accel = v
        return at + 12

    def _write(self) -> bytes:
        return _3f.write(
            "stabilized_accel*3", *codec.elements("stabilized_accel", self.stabilized_accel, 3)
        )


class GpsTimestamp(Data):
    """GPS timestamp (0x80,0x12).

    GPS time of the sensor data.

    Confirmed on 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-35; likely or assumed on
    12 more.

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
    DESCRIPTOR = 0x12
    NAME = "sensor.gps_timestamp"
    _SIZE = 12

    tow: float
    """GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if
    `types.SensorGpsTimestampFlags.TOW_VALID` of `valid_flags` is set.

    - On the 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-CX5-45,
      3DM-DH3, 3DM-GQ4-45, 3DM-GX3-15, 3DM-GX3-25, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25,
      3DM-GX4-45, 3DM-GX4-IMU, 3DM-GX5-25, 3DM-GX5-45, 3DM-MV5-AR, 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and
      3DM-RQ1-IMU: valid if `types.Gx5SensorGpsTimestampFlags.TIME_INITIALIZED` of `valid_flags` is
      set (inferred: the 3DM-GX5-15 has it).
    - On the 3DM-GX5-15 and 3DM-GX5-35: valid if `types.Gx5SensorGpsTimestampFlags.TIME_INITIALIZED`
      of `valid_flags` is set.
    """
    week_number: int
    """GPS week number. Unit: week. Valid if `types.SensorGpsTimestampFlags.WEEK_NUMBER_VALID` of
    `valid_flags` is set.

    - On the 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-CX5-45,
      3DM-DH3, 3DM-GQ4-45, 3DM-GX3-15, 3DM-GX3-25, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25,
      3DM-GX4-45, 3DM-GX4-IMU, 3DM-GX5-25, 3DM-GX5-45, 3DM-MV5-AR, 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and
      3DM-RQ1-IMU: valid if `types.Gx5SensorGpsTimestampFlags.TIME_INITIALIZED` of `valid_flags` is
      set (inferred: the 3DM-GX5-15 has it).
    - On the 3DM-GX5-15 and 3DM-GX5-35: valid if `types.Gx5SensorGpsTimestampFlags.TIME_INITIALIZED`
      of `valid_flags` is set.
    """
    valid_flags: types.SensorGpsTimestampFlags
    """State of the time.

    - On the 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-CX5-45,
      3DM-DH3, 3DM-GQ4-45, 3DM-GX3-15, 3DM-GX3-25, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25,
      3DM-GX4-45, 3DM-GX4-IMU, 3DM-GX5-25, 3DM-GX5-45, 3DM-MV5-AR, 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and
      3DM-RQ1-IMU: values of `types.Gx5SensorGpsTimestampFlags` (inferred: the 3DM-GX5-15 has it).
    - On the 3DM-GX5-15 and 3DM-GX5-35: values of `types.Gx5SensorGpsTimestampFlags`.
    """

    def __init__(
        self, tow: float, week_number: int, valid_flags: types.SensorGpsTimestampFlags
    ) -> None:
        self.tow = tow
        self.week_number = week_number
        self.valid_flags = valid_flags

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _d2H.unpack(raw, at)
        self.tow = v[0]
        self.week_number = v[1]
        self.valid_flags = codec.KNOWN[types.SensorGpsTimestampFlags][v[2]]
        return at + 12

    def _write(self) -> bytes:
        return _d2H.write(
            "tow week_number valid_flags", self.tow, self.week_number, self.valid_flags
        )


class TemperatureStatistics(Data):
    """Temperature statistics (0x80,0x14).

    Temperatures since the last power-on or reset.

    Also called `temperature_abs`. Confirmed on 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or
    assumed on 9 more.

    The values come from the inertial sensors, alone or together with sensors on the board.

    - 3dm-cv7-gnss-ins: Temperature Statistics (0x80,0x14)
    """

    __slots__ = ("min_temperature", "max_temperature", "mean_temperature")
    __match_args__ = ("min_temperature", "max_temperature", "mean_temperature")

    SET = 0x80
    DESCRIPTOR = 0x14
    NAME = "sensor.temperature_statistics"
    _SIZE = 12

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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _3f.unpack(raw, at)
        if (total := v[0] + v[1] + v[2]) != total:
            v = _3f.keep_nan_bits(v, raw, at)
        self.min_temperature, self.max_temperature, self.mean_temperature = v
        return at + 12

    def _write(self) -> bytes:
        return _3f.write(
            "min_temperature max_temperature mean_temperature",
            self.min_temperature,
            self.max_temperature,
            self.mean_temperature,
        )


class RawPressure(Data):
    """Raw pressure (0x80,0x16).

    Raw ambient pressure in sensor counts, temperature compensated.

    Not listed in any device profile. Known only from the MicroStrain MIP SDK. Requires a pressure
    sensor.

    - mip-sdk-4: Raw pressure (0x80,0x16)
    """

    __slots__ = ("raw_pressure",)
    __match_args__ = ("raw_pressure",)

    SET = 0x80
    DESCRIPTOR = 0x16
    NAME = "sensor.raw_pressure"
    _SIZE = 4

    raw_pressure: float
    """Pressure in counts. Unit: 1."""

    def __init__(self, raw_pressure: float) -> None:
        self.raw_pressure = raw_pressure

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _f.unpack(raw, at)
        if v[0] != v[0]:
            v = _f.keep_nan_bits(v, raw, at)
        self.raw_pressure = v[0]
        return at + 4

    def _write(self) -> bytes:
        return _f.write("raw_pressure", self.raw_pressure)


class ScaledPressure(Data):
    """Scaled pressure (0x80,0x17).

    Measured ambient pressure, temperature compensated.

    Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS, 3DM-GX5-15 and
    3DM-GX5-35; likely or assumed on 17 more. Requires a pressure sensor.

    - 3dm-gx5-15: 5.1.3 Scaled Ambient Pressure (0x80, 0x17)
    - 3dm-cv7-gnss-ins: Scaled Pressure (0x80,0x17)
    """

    __slots__ = ("scaled_pressure",)
    __match_args__ = ("scaled_pressure",)

    SET = 0x80
    DESCRIPTOR = 0x17
    NAME = "sensor.scaled_pressure"
    _SIZE = 4

    scaled_pressure: float
    """Ambient pressure. Unit: mbar. Range: at least 0."""

    def __init__(self, scaled_pressure: float) -> None:
        self.scaled_pressure = scaled_pressure

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _f.unpack(raw, at)
        if v[0] != v[0]:
            v = _f.keep_nan_bits(v, raw, at)
        self.scaled_pressure = v[0]
        return at + 4

    def _write(self) -> bytes:
        return _f.write("scaled_pressure", self.scaled_pressure)


class OverrangeStatus(Data):
    """Overrange status (0x80,0x18).

    Sensor axes that are near or outside their range.

    Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed
    on 7 more.

    - 3dm-cv7-gnss-ins: Overrange Status (0x80,0x18)
    """

    __slots__ = ("status",)
    __match_args__ = ("status",)

    SET = 0x80
    DESCRIPTOR = 0x18
    NAME = "sensor.overrange_status"
    _SIZE = 2

    status: OverrangeFlags
    """One bit for each axis.

    - On the 3DM-CV7-AR, 3DM-CX7-AR and 3DM-GV7-AR: only `OverrangeFlags.ACCEL_X`,
      `OverrangeFlags.ACCEL_Y`, `OverrangeFlags.ACCEL_Z`, `OverrangeFlags.GYRO_X`,
      `OverrangeFlags.GYRO_Y`, `OverrangeFlags.GYRO_Z` and `OverrangeFlags.PRESSURE`.
    """

    def __init__(self, status: OverrangeFlags) -> None:
        self.status = status

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.status = codec.KNOWN[OverrangeFlags][_H.unpack(raw, at)[0]]
        return at + 2

    def _write(self) -> bytes:
        return _H.write("status", self.status)


class Odometer(Data):
    """Odometer data (0x80,0x40).

    Speed measured by the wheel encoder.

    Also called `odometer_data`. Supported by 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Odometer Data (0x80,0x40)
    """

    __slots__ = ("speed", "uncertainty", "valid_flags")
    __match_args__ = ("speed", "uncertainty", "valid_flags")

    SET = 0x80
    DESCRIPTOR = 0x40
    NAME = "sensor.odometer"
    _SIZE = 10

    speed: float
    """Average speed over the interval; negative values come from quadrature encoders only. Unit:
    m/s. Frame: vehicle. Positive: forward. Valid if `OdometerFlags.ODOMETER` of `valid_flags` is
    set.
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

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2fH.unpack(raw, at)
        if (total := v[0] + v[1]) != total:
            v = _2fH.keep_nan_bits(v, raw, at)
        self.speed = v[0]
        self.uncertainty = v[1]
        self.valid_flags = codec.KNOWN[OdometerFlags][v[2]]
        return at + 10

    def _write(self) -> bytes:
        return _2fH.write(
            "speed uncertainty valid_flags", self.speed, self.uncertainty, self.valid_flags
        )


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
