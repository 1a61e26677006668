/**
 * Sensor data (0x80).
 *
 * Inertial, magnetic and pressure measurements, and the attitude of the complementary filter.
 *
 * - 3dm-gx5-15: 5.1 IMU Data
 * - 3dm-cv7-gnss-ins: Sensor (0x80)
 */
import type { Bitfield, Command, Data, Enumeration, Flavor, Response, Values } from "./mip/index.mjs";
import type { FunctionSelector } from "./protocol.mjs";
import type * as types from "./types.mjs";

export type OverrangeFlags = Flavor<number, "sensor.overrange_flags">;
/** Sensor axes that were near or outside their range. */
export declare const OverrangeFlags: Bitfield<OverrangeFlags> & {
    /** The accelerometer x axis is near or outside its range. Bit 0. Affects `ScaledAccel`. */
    readonly ACCEL_X: OverrangeFlags;
    /** The accelerometer y axis is near or outside its range. Bit 1. Affects `ScaledAccel`. */
    readonly ACCEL_Y: OverrangeFlags;
    /** The accelerometer z axis is near or outside its range. Bit 2. Affects `ScaledAccel`. */
    readonly ACCEL_Z: OverrangeFlags;
    /** The gyroscope x axis is near or outside its range. Bit 4. Affects `ScaledGyro`. */
    readonly GYRO_X: OverrangeFlags;
    /** The gyroscope y axis is near or outside its range. Bit 5. Affects `ScaledGyro`. */
    readonly GYRO_Y: OverrangeFlags;
    /** The gyroscope z axis is near or outside its range. Bit 6. Affects `ScaledGyro`. */
    readonly GYRO_Z: OverrangeFlags;
    /** The magnetometer x axis is near or outside its range. Bit 8. Affects `ScaledMag`. Requires a magnetometer. */
    readonly MAG_X: OverrangeFlags;
    /** The magnetometer y axis is near or outside its range. Bit 9. Affects `ScaledMag`. Requires a magnetometer. */
    readonly MAG_Y: OverrangeFlags;
    /** The magnetometer z axis is near or outside its range. Bit 10. Affects `ScaledMag`. Requires a magnetometer. */
    readonly MAG_Z: OverrangeFlags;
    /**
     * The pressure sensor is near or outside its range. Bit 12. Affects `ScaledPressure`. Requires a pressure sensor.
     */
    readonly PRESSURE: OverrangeFlags;
};

export type OdometerFlags = Flavor<number, "sensor.odometer_flags">;
/** Validity of the odometer values. */
export declare const OdometerFlags: Bitfield<OdometerFlags> & {
    /** Set if an odometer is configured; its values are then valid. Bit 0. */
    readonly ODOMETER: OdometerFlags;
};

/**
 * Raw accel (0x80,0x01).
 *
 * Raw acceleration in sensor counts, temperature compensated.
 *
 * Not listed in any device profile. Known only from the MIP SDK of 2014 and MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Raw accel (0x80,0x01)
 * - mip-sdk-2014: Raw accel (0x80,0x01)
 */
export declare class RawAccel extends Data {
    constructor(values: Values<RawAccel>);
    /** Acceleration in counts. Elements: x, y, z. Unit: 1. Frame: sensor. */
    rawAccel: types.Vector3f;
}

/**
 * Raw gyro (0x80,0x02).
 *
 * Raw angular rate in sensor counts, temperature compensated.
 *
 * Not listed in any device profile. Known only from the MIP SDK of 2014 and MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Raw gyro (0x80,0x02)
 * - mip-sdk-2014: Raw gyro (0x80,0x02)
 */
export declare class RawGyro extends Data {
    constructor(values: Values<RawGyro>);
    /** Angular rate in counts. Elements: x, y, z. Unit: 1. Frame: sensor. */
    rawGyro: types.Vector3f;
}

/**
 * Raw mag (0x80,0x03).
 *
 * Raw magnetic field in sensor counts, temperature compensated.
 *
 * Not listed in any device profile. Known only from the MIP SDK of 2014 and MicroStrain MIP SDK. Requires a
 * magnetometer.
 *
 * - mip-sdk-4: Raw mag (0x80,0x03)
 * - mip-sdk-2014: Raw mag (0x80,0x03)
 */
export declare class RawMag extends Data {
    constructor(values: Values<RawMag>);
    /**
     * Magnetic field in counts. Elements: x, y, z. Unit: 1. Frame: vehicle. Uncertain: The frame is doubtful: the SDK
     * has the vehicle frame here, but the sensor frame for raw acceleration and raw angular rate.
     */
    rawMag: types.Vector3f;
}

/**
 * Scaled accel (0x80,0x04).
 *
 * Specific force, temperature compensated: about -1 g on z when level and at rest.
 *
 * Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-CX5-45, 3DM-GQ7-GNSS/INS, 3DM-GX5-15, 3DM-GX5-35 and
 * 3DM-GX5-45; likely or assumed on 24 more.
 *
 * At rest, it is the opposite of the gravity vector.
 *
 * - 3dm-gx5-15: 5.1.1 Scaled Accelerometer Vector (0x80, 0x04)
 * - 3dm-cv7-gnss-ins: Scaled Accel (0x80,0x04)
 */
export declare class ScaledAccel extends Data {
    constructor(values: Values<ScaledAccel>);
    /**
     * Specific force: acceleration minus gravity. Elements: x, y, z. Unit: g. Frame: vehicle. At rest and level: x 0, y
     * 0, z -1.
     */
    scaledAccel: types.Vector3f;
}

/**
 * Scaled gyro (0x80,0x05).
 *
 * Measured angular rate, temperature compensated.
 *
 * Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-CX5-45, 3DM-GQ7-GNSS/INS, 3DM-GX5-15, 3DM-GX5-35 and
 * 3DM-GX5-45; likely or assumed on 24 more.
 *
 * - 3dm-gx5-15: 5.1.2 Scaled Gyro Vector (0x80, 0x05)
 * - 3dm-cv7-gnss-ins: Scaled Gyro (0x80,0x05)
 */
export declare class ScaledGyro extends Data {
    constructor(values: Values<ScaledGyro>);
    /**
     * Angular rate about each axis. Elements: x, y, z. Unit: rad/s. Frame: vehicle. At rest and level: x 0, y 0, z 0.
     * Positive: right side down, nose up, clockwise seen from above.
     */
    scaledGyro: types.Vector3f;
}

/**
 * Scaled mag (0x80,0x06).
 *
 * Measured magnetic field, temperature compensated.
 *
 * Confirmed on 3DM-CV7-AHRS, 3DM-CV7-GNSS/INS, 3DM-CX5-45, 3DM-GQ7-GNSS/INS, 3DM-GX5-35 and 3DM-GX5-45; likely or
 * assumed on 16 more. Requires a magnetometer.
 *
 * - 3dm-cv7-gnss-ins: Scaled Mag (0x80,0x06)
 */
export declare class ScaledMag extends Data {
    constructor(values: Values<ScaledMag>);
    /** Magnetic field. Elements: x, y, z. Unit: gauss. Frame: vehicle. */
    scaledMag: types.Vector3f;
}

/**
 * Delta theta (0x80,0x07).
 *
 * Time integral of the angular rate over the period set by the message format.
 *
 * Confirmed on 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-35; likely or assumed on 21 more.
 *
 * - 3dm-gx5-15: 5.1.4 Delta Theta Vector (0x80, 0x07)
 * - 3dm-cv7-gnss-ins: Delta Theta (0x80,0x07)
 */
export declare class DeltaTheta extends Data {
    constructor(values: Values<DeltaTheta>);
    /**
     * Integral of the angular rate. Elements: x, y, z. Unit: rad. Frame: vehicle. At rest and level: x 0, y 0, z 0.
     * Positive: right side down, nose up, clockwise seen from above.
     */
    deltaTheta: types.Vector3f;
}

/**
 * Delta velocity (0x80,0x08).
 *
 * Time integral of the specific force over the period set by the message format.
 *
 * Confirmed on 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS and 3DM-GX5-15; likely or assumed on 22 more.
 *
 * Multiply by 9.80665 m/s^2 for a change of velocity in metres per second. Divided by the period, z is -1 g on a device
 * that is level and at rest.
 *
 * - 3dm-gx5-15: 5.1.5 Delta Velocity Vector (0x80, 0x08)
 * - 3dm-cv7-gnss-ins: Delta Velocity (0x80,0x08)
 */
export declare class DeltaVelocity extends Data {
    constructor(values: Values<DeltaVelocity>);
    /**
     * Integral of the specific force: acceleration minus gravity. Elements: x, y, z. Unit: g*s. Frame: vehicle. At rest
     * and level: x 0, y 0.
     */
    deltaVelocity: types.Vector3f;
}

/**
 * Complementary filter orientation matrix (0x80,0x09).
 *
 * Attitude from the complementary filter as a direction cosine matrix, relative to the NED frame.
 *
 * Confirmed on 3DM-CV7-GNSS/INS and 3DM-GX5-15; likely or assumed on 21 more.
 *
 * `v_vehicle = m * v_ned`; the 3DM-GX5-15 uses the sensor frame in place of the vehicle frame.
 *
 * - 3dm-gx5-15: 5.1.6 CF Orientation Matrix (0x80, 0x09)
 * - 3dm-cv7-gnss-ins: Complementary Filter Orientation Matrix (0x80,0x09)
 */
export declare class CompOrientationMatrix extends Data {
    constructor(values: Values<CompOrientationMatrix>);
    /**
     * Rotates vectors of the NED frame into the vehicle frame; row-major. Elements: m11, m12, m13, m21, m22, m23, m31,
     * m32, m33. Unit: 1. Frame: ned. At rest and level: m13 0, m23 0, m31 0, m32 0, m33 1.
     *
     * - On the 3DM-GX5-15: Rotates vectors of the NED frame into the sensor frame; row-major.
     */
    m: types.Matrix3f;
}

/**
 * Complementary filter quaternion (0x80,0x0A).
 *
 * Attitude from the complementary filter as a quaternion, relative to the NED frame.
 *
 * Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS and 3DM-GX5-15; likely or assumed on 18
 * more.
 *
 * The 3DM-GX5-15 uses the sensor frame in place of the vehicle frame. `v_ned = q * v_vehicle * q^-1`
 *
 * - 3dm-gx5-15: 5.1.7 CF Quaternion (0x80, 0x0A)
 * - 3dm-cv7-gnss-ins: Complementary Filter Quaternion (0x80,0x0A)
 */
export declare class CompQuaternion extends Data {
    constructor(values: Values<CompQuaternion>);
    /**
     * Rotates vectors of the vehicle frame into the NED frame; Hamilton quaternion, w first. Elements: w, x, y, z.
     * Unit: 1. Frame: ned. At rest and level: x 0, y 0.
     *
     * - On the 3DM-GX5-15: Rotates vectors of the sensor frame into the NED frame; Hamilton quaternion, w first.
     */
    q: types.Quatf;
}

/**
 * Complementary filter orientation update matrix (0x80,0x0B).
 *
 * Change in the complementary filter's attitude, as a matrix.
 *
 * Deprecated: the SDK marks it as deprecated and names no replacement. Not listed in any device profile. Known only
 * from the MIP SDK of 2014 and MicroStrain MIP SDK. Uncertain: No source states the interval of the change and the
 * frames; the SDKs state only the name and the layout.
 *
 * - mip-sdk-4: Comp Orientation Update Matrix (0x80,0x0B)
 * - mip-sdk-2014: Orientation Update Matrix (0x80,0x0B)
 */
export declare class CompOrientationUpdateMatrix extends Data {
    constructor(values: Values<CompOrientationUpdateMatrix>);
    /** Matrix in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit: 1. */
    m: types.Matrix3f;
}

/**
 * Complementary filter Euler angles (0x80,0x0C).
 *
 * Attitude from the complementary filter as Euler angles, relative to the NED frame.
 *
 * Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS and 3DM-GX5-15; likely or assumed on 19 more. Uncertain: The
 * ranges of the angles are inferred; no source states them.
 *
 * - 3dm-gx5-15: 5.1.8 CF Euler Angles (0x80, 0x0C)
 * - 3dm-cv7-gnss-ins: Complementary Filter Euler Angles (0x80,0x0C)
 */
export declare class CompEulerAngles extends Data {
    constructor(values: Values<CompEulerAngles>);
    /**
     * Roll angle, applied after yaw and pitch (order 3-2-1). Unit: rad. Frame: ned. Range: -pi to pi. At rest and
     * level: 0. Positive: right side down.
     */
    roll: number;
    /**
     * Pitch angle. Unit: rad. Frame: ned. Range: -1.5707963267948966 to 1.5707963267948966. At rest and level: 0.
     * Positive: nose up.
     */
    pitch: number;
    /** Yaw angle. Unit: rad. Frame: ned. Range: -pi to pi. Positive: clockwise seen from above. */
    yaw: number;
}

/**
 * Orientation raw temperatures (0x80,0x0D).
 *
 * Raw readings of four temperature sensors.
 *
 * Deprecated: the SDK marks it as deprecated and names no replacement. Also called `orientation_raw_temp`. Not listed
 * in any device profile. Known only from the MIP SDK of 2014 and MicroStrain MIP SDK.
 *
 * The first sensor belongs to the magnetometer, the second to gyroscope 3 and accelerometer 3, the third to gyroscope 2
 * and accelerometers 1 and 2, the fourth to gyroscope 1.
 *
 * - mip-sdk-4: Orientation Raw Temp (0x80,0x0D)
 * - mip-sdk-2014: Raw Temperature (0x80,0x0D)
 */
export declare class OrientationRawTemperature extends Data {
    constructor(values: Values<OrientationRawTemperature>);
    /** Temperatures in counts. Unit: 1. Uncertain: No source states the scale, or the axes of the numbers 1 to 3. */
    rawTemperature: [number, number, number, number];
}

/**
 * Internal timestamp (0x80,0x0E).
 *
 * Free-running counter of the device.
 *
 * Deprecated: the SDK marks it as deprecated and names no replacement. Not listed in any device profile. Known only
 * from the MIP SDK of 2014 and MicroStrain MIP SDK. Uncertain: No source lists the devices that send it; the SDK of
 * 2014 is for devices of the 3-series and 4-series.
 *
 * - mip-sdk-4: Internal timestamp (0x80,0x0E)
 * - mip-sdk-2014: Internal timestamp (0x80,0x0E)
 */
export declare class InternalTimestamp extends Data {
    constructor(values: Values<InternalTimestamp>);
    /** Counter: 62 500 counts per second, 16 us each. Unit: 1. */
    counts: number;
}

/**
 * PPS timestamp (0x80,0x0F).
 *
 * Time counted by the pulse per second.
 *
 * Deprecated: the SDK marks it as deprecated and names no replacement. The size of its data distinguishes it from
 * `PpsTimestampWithFlags`. Not listed in any device profile. Known only from the MicroStrain MIP SDK. Uncertain:
 * Possibly no device sends it; `PpsTimestampWithFlags` has more sources. Uncertain: No source states the epoch.
 *
 * The sources contradict each other. Only the SDK has this layout.
 *
 * - mip-sdk-4: PPS timestamp (0x80,0x0F)
 */
export declare class PpsTimestamp extends Data {
    constructor(values: Values<PpsTimestamp>);
    /** Whole seconds. Unit: s. Uncertain: The unit is inferred from the name. */
    seconds: number;
    /** Fraction of the second. Unit: us. Uncertain: The unit is inferred from the name. */
    useconds: number;
}

/**
 * PPS timestamp with flags (0x80,0x0F).
 *
 * Time counted by the pulse per second, with its state and nanoseconds.
 *
 * Deprecated: the SDK marks the descriptor as deprecated and names no replacement. The size of its data distinguishes
 * it from `PpsTimestamp`. Not listed in any device profile. Known only from the MIP SDK of 2014 and MicroStrain
 * Communication Library. Uncertain: No source lists the devices that send it; the SDK of 2014 dates from the time of
 * the 3DM-GX3. Uncertain: No source states the epoch.
 *
 * The sources disagree on the layout; this one is from MSCL and the SDK of 2014.
 *
 * - mscl: 1PPS Timestamp (0x80,0x0F)
 * - mip-sdk-2014: 1PPS Timestamp (0x80,0x0F)
 */
export declare class PpsTimestampWithFlags extends Data {
    constructor(values: Values<PpsTimestampWithFlags>);
    /** State of the time. Uncertain: No source states the meaning of the bits. */
    flags: number;
    /** Whole seconds. Unit: s. */
    seconds: number;
    /** Fraction of the second. Unit: ns. */
    nanoseconds: number;
}

/**
 * Complementary filter stabilized north vector (0x80,0x10).
 *
 * Estimate of the geomagnetic field by the complementary filter, free of short disturbances.
 *
 * Confirmed on 3DM-GX5-15; likely or assumed on 11 more.
 *
 * Without magnetic disturbance it equals the measured magnetic field, unless a sensor-to-vehicle transformation moves
 * the latter out of the sensor frame. A lasting disturbance is not compensated.
 *
 * - 3dm-gx5-15: 5.1.9 CF Stabilized North Vector (0x80, 0x10)
 */
export declare class NorthVector extends Data {
    constructor(values: Values<NorthVector>);
    /**
     * Geomagnetic field. Elements: x, y, z. Unit: gauss. Frame: sensor. Uncertain: The frame is doubtful: the SDK has
     * the vehicle frame, but the lists of what the sensor-to-vehicle transformation changes lack this vector.
     */
    stabilizedMag: types.Vector3f;
}

/**
 * Complementary filter stabilized up vector (0x80,0x11).
 *
 * Estimate of the vertical (up) by the complementary filter, free of linear acceleration.
 *
 * Confirmed on 3DM-GX5-15 and 3DM-GX5-35; likely or assumed on 10 more.
 *
 * At rest it equals the measured acceleration, unless a sensor-to-vehicle transformation moves the latter out of the
 * sensor frame.
 *
 * - 3dm-gx5-15: 5.1.10 CF Stabilized Up Vector (0x80, 0x11)
 * - mip-sdk-4: Complementary filter stabilized up vector (0x80,0x11)
 */
export declare class UpVector extends Data {
    constructor(values: Values<UpVector>);
    /**
     * Opposite of the gravity vector, as the accelerometers measure it. Elements: x, y, z. Unit: g. Frame: sensor. At
     * rest and level: x 0, y 0, z -1. Uncertain: The frame is doubtful: the SDK has the vehicle frame, but the lists of
     * what the sensor-to-vehicle transformation changes lack this vector.
     */
    stabilizedAccel: types.Vector3f;
}

/**
 * GPS timestamp (0x80,0x12).
 *
 * GPS time of the sensor data.
 *
 * Confirmed on 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-35; likely or assumed on 12 more.
 *
 * Without a PPS the time runs on the internal clock and jumps when the PPS returns. The fraction of the time of week is
 * the time since the last pulse. Without external synchronization it is the internal system time. Where the device has
 * it, use `shared.GpsTimestamp` instead; this field may be deprecated.
 *
 * - 3dm-gx5-15: 5.1.11 GPS Correlation Timestamp (0x80, 0x12)
 * - 3dm-cv7-gnss-ins: GPS Timestamp (0x80,0x12)
 */
export declare class GpsTimestamp extends Data {
    constructor(values: Values<GpsTimestamp>);
    /**
     * GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if
     * `types.SensorGpsTimestampFlags.TOW_VALID` of `validFlags` is set.
     *
     * - On the 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-CX5-45, 3DM-DH3, 3DM-GQ4-45,
     *   3DM-GX3-15, 3DM-GX3-25, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-GX4-IMU, 3DM-GX5-25,
     *   3DM-GX5-45, 3DM-MV5-AR, 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and 3DM-RQ1-IMU: valid if
     *   `types.Gx5SensorGpsTimestampFlags.TIME_INITIALIZED` of `validFlags` is set (inferred: the 3DM-GX5-15 has it).
     * - On the 3DM-GX5-15 and 3DM-GX5-35: valid if `types.Gx5SensorGpsTimestampFlags.TIME_INITIALIZED` of `validFlags`
     *   is set.
     */
    tow: number;
    /**
     * GPS week number. Unit: week. Valid if `types.SensorGpsTimestampFlags.WEEK_NUMBER_VALID` of `validFlags` is set.
     *
     * - On the 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-CX5-45, 3DM-DH3, 3DM-GQ4-45,
     *   3DM-GX3-15, 3DM-GX3-25, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-GX4-IMU, 3DM-GX5-25,
     *   3DM-GX5-45, 3DM-MV5-AR, 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and 3DM-RQ1-IMU: valid if
     *   `types.Gx5SensorGpsTimestampFlags.TIME_INITIALIZED` of `validFlags` is set (inferred: the 3DM-GX5-15 has it).
     * - On the 3DM-GX5-15 and 3DM-GX5-35: valid if `types.Gx5SensorGpsTimestampFlags.TIME_INITIALIZED` of `validFlags`
     *   is set.
     */
    weekNumber: number;
    /**
     * State of the time.
     *
     * - On the 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-CX5-45, 3DM-DH3, 3DM-GQ4-45,
     *   3DM-GX3-15, 3DM-GX3-25, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-GX4-IMU, 3DM-GX5-25,
     *   3DM-GX5-45, 3DM-MV5-AR, 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and 3DM-RQ1-IMU: values of
     *   `types.Gx5SensorGpsTimestampFlags` (inferred: the 3DM-GX5-15 has it).
     * - On the 3DM-GX5-15 and 3DM-GX5-35: values of `types.Gx5SensorGpsTimestampFlags`.
     */
    validFlags: types.SensorGpsTimestampFlags;
}

/**
 * Temperature statistics (0x80,0x14).
 *
 * Temperatures since the last power-on or reset.
 *
 * Also called `temperature_abs`. Confirmed on 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed on 9 more.
 *
 * The values come from the inertial sensors, alone or together with sensors on the board.
 *
 * - 3dm-cv7-gnss-ins: Temperature Statistics (0x80,0x14)
 */
export declare class TemperatureStatistics extends Data {
    constructor(values: Values<TemperatureStatistics>);
    /** Lowest temperature. Unit: degC. */
    minTemperature: number;
    /** Highest temperature. Unit: degC. */
    maxTemperature: number;
    /** Mean of the temperatures inside the device. Unit: degC. */
    meanTemperature: number;
}

/**
 * Raw pressure (0x80,0x16).
 *
 * Raw ambient pressure in sensor counts, temperature compensated.
 *
 * Not listed in any device profile. Known only from the MicroStrain MIP SDK. Requires a pressure sensor.
 *
 * - mip-sdk-4: Raw pressure (0x80,0x16)
 */
export declare class RawPressure extends Data {
    constructor(values: Values<RawPressure>);
    /** Pressure in counts. Unit: 1. */
    rawPressure: number;
}

/**
 * Scaled pressure (0x80,0x17).
 *
 * Measured ambient pressure, temperature compensated.
 *
 * Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-35; likely or
 * assumed on 17 more. Requires a pressure sensor.
 *
 * - 3dm-gx5-15: 5.1.3 Scaled Ambient Pressure (0x80, 0x17)
 * - 3dm-cv7-gnss-ins: Scaled Pressure (0x80,0x17)
 */
export declare class ScaledPressure extends Data {
    constructor(values: Values<ScaledPressure>);
    /** Ambient pressure. Unit: mbar. Range: at least 0. */
    scaledPressure: number;
}

/**
 * Overrange status (0x80,0x18).
 *
 * Sensor axes that are near or outside their range.
 *
 * Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed on 7 more.
 *
 * - 3dm-cv7-gnss-ins: Overrange Status (0x80,0x18)
 */
export declare class OverrangeStatus extends Data {
    constructor(values: Values<OverrangeStatus>);
    /**
     * One bit for each axis.
     *
     * - On the 3DM-CV7-AR, 3DM-CX7-AR and 3DM-GV7-AR: only `OverrangeFlags.ACCEL_X`, `OverrangeFlags.ACCEL_Y`,
     *   `OverrangeFlags.ACCEL_Z`, `OverrangeFlags.GYRO_X`, `OverrangeFlags.GYRO_Y`, `OverrangeFlags.GYRO_Z` and
     *   `OverrangeFlags.PRESSURE`.
     */
    status: OverrangeFlags;
}

/**
 * Odometer data (0x80,0x40).
 *
 * Speed measured by the wheel encoder.
 *
 * Also called `odometer_data`. Supported by 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Odometer Data (0x80,0x40)
 */
export declare class Odometer extends Data {
    constructor(values: Values<Odometer>);
    /**
     * Average speed over the interval; negative values come from quadrature encoders only. Unit: m/s. Frame: vehicle.
     * Positive: forward. Valid if `OdometerFlags.ODOMETER` of `validFlags` is set.
     */
    speed: number;
    /**
     * Uncertainty of the speed. Unit: m/s. Range: at least 0. Valid if `OdometerFlags.ODOMETER` of `validFlags` is set.
     */
    uncertainty: number;
    /** Validity of the measured values. */
    validFlags: OdometerFlags;
}
