/**
 * Filter data (0x82).
 *
 * Estimates of the navigation filter and its status.
 *
 * - 3dm-gx5-15: 5.2 Estimation Filter Data
 * - 3dm-cv7-gnss-ins: Filter (0x82)
 */
import type { Bitfield, Command, Data, Enumeration, Flavor, Response, Values } from "./mip/index.mjs";
import type { FunctionSelector } from "./protocol.mjs";
import type * as types from "./types.mjs";

export type ValidFlags = Flavor<number, "filter_data.valid_flags">;
/** Validity of the values of a field. */
export declare const ValidFlags: Bitfield<ValidFlags> & {
    /** All values of the field are valid. Bit 0. */
    readonly VALID: ValidFlags;
};

export type HeadingSourceFlags = Flavor<number, "filter_data.heading_source_flags">;
/**
 * Sources of heading updates; 0 if heading updates are disabled.
 *
 * - 3dm-gx5-15: 5.2.16 Heading Update Source State (0x82, 0x14)
 * - 3dm-gx5-45: 5.3.27 Heading Update Source State (0x82, 0x14)
 */
export declare const HeadingSourceFlags: Bitfield<HeadingSourceFlags> & {
    /** The magnetometer. Bit 0. Requires a magnetometer. */
    readonly MAG: HeadingSourceFlags;
    /** The velocity that the GNSS receiver measures. Bit 1. Requires a receiver. */
    readonly GNSS_VELOCITY: HeadingSourceFlags;
    /** Heading messages that your program sends. Bit 2. */
    readonly EXTERNAL: HeadingSourceFlags;
};

export type GnssAidingStatus = Flavor<number, "filter_data.gnss_aiding_status">;
/** Use of one GNSS receiver by the filter. */
export declare const GnssAidingStatus: Bitfield<GnssAidingStatus> & {
    /** The receiver's raw ranges are used. Bit 0. */
    readonly TIGHT_COUPLING: GnssAidingStatus;
    /** RTK corrections are used. Bit 1. */
    readonly DIFFERENTIAL: GnssAidingStatus;
    /** The receiver has an RTK integer fix, the most accurate kind. Bit 2. */
    readonly INTEGER_FIX: GnssAidingStatus;
    /** GPS L1 is used. Bit 3. */
    readonly GPS_L1: GnssAidingStatus;
    /** GPS L2 is used. Bit 4. */
    readonly GPS_L2: GnssAidingStatus;
    /** GPS L5 is used; not on every model. Bit 5. */
    readonly GPS_L5: GnssAidingStatus;
    /** GLONASS L1 is used. Bit 6. */
    readonly GLONASS_L1: GnssAidingStatus;
    /** GLONASS L2 is used. Bit 7. */
    readonly GLONASS_L2: GnssAidingStatus;
    /** Galileo E1 is used. Bit 8. */
    readonly GALILEO_E1: GnssAidingStatus;
    /** Galileo E5 is used. Bit 9. */
    readonly GALILEO_E5: GnssAidingStatus;
    /** Galileo E6 is used. Bit 10. */
    readonly GALILEO_E6: GnssAidingStatus;
    /** BeiDou B1 is used; not on every model. Bit 11. */
    readonly BEIDOU_B1: GnssAidingStatus;
    /** BeiDou B2 is used; not on every model. Bit 12. */
    readonly BEIDOU_B2: GnssAidingStatus;
    /** BeiDou B3 is used; not on every model. Bit 13. */
    readonly BEIDOU_B3: GnssAidingStatus;
    /** The receiver has no position fix. Bit 14. */
    readonly NO_FIX: GnssAidingStatus;
    /** The antenna offset of the receiver is probably wrong. Bit 15. */
    readonly CONFIG_ERROR: GnssAidingStatus;
};

export type HeadingAidingType = Flavor<number, "filter_data.heading_aiding_type">;
/**
 * Source of a heading measurement.
 *
 * - mip-sdk-4: Head Aid Status (0x82,0x45)
 */
export declare const HeadingAidingType: Enumeration<HeadingAidingType> & {
    /** Two GNSS antennas. */
    readonly DUAL_ANTENNA: HeadingAidingType & 1;
    /** A heading message from your program. */
    readonly EXTERNAL_MESSAGE: HeadingAidingType & 2;
};

export type AidingMeasurementType = Flavor<number, "filter_data.aiding_measurement_type">;
/**
 * Kind of aiding measurement. Values from 0x20 are the descriptors of the commands of set `aiding` that send the
 * measurement.
 */
export declare const AidingMeasurementType: Enumeration<AidingMeasurementType> & {
    /** GNSS position and velocity. */
    readonly GNSS: AidingMeasurementType & 1;
    /** GNSS heading from two antennas. */
    readonly DUAL_ANTENNA: AidingMeasurementType & 2;
    readonly HEADING: AidingMeasurementType & 3;
    /** Pressure altitude. */
    readonly PRESSURE: AidingMeasurementType & 4;
    readonly MAG: AidingMeasurementType & 5;
    /** Speed or odometer. */
    readonly SPEED: AidingMeasurementType & 6;
    /** ECEF position, sent by command. */
    readonly AIDING_ECEF_POSITION: AidingMeasurementType & 33;
    /** Latitude, longitude and height, sent by command. */
    readonly AIDING_LLH_POSITION: AidingMeasurementType & 34;
    /** Height above the ellipsoid, sent by command. */
    readonly AIDING_HEIGHT_ABOVE_ELLIPSOID: AidingMeasurementType & 35;
    /** ECEF velocity, sent by command. */
    readonly AIDING_ECEF_VELOCITY: AidingMeasurementType & 40;
    /** NED velocity, sent by command. */
    readonly AIDING_NED_VELOCITY: AidingMeasurementType & 41;
    /** Body frame velocity, sent by command. */
    readonly AIDING_BODY_FRAME_VELOCITY: AidingMeasurementType & 42;
    /** True heading, sent by command. */
    readonly AIDING_TRUE_HEADING: AidingMeasurementType & 49;
    /** Magnetic field, sent by command. */
    readonly AIDING_MAGNETIC_FIELD: AidingMeasurementType & 50;
    /** Pressure, sent by command. */
    readonly AIDING_PRESSURE: AidingMeasurementType & 51;
};

export type AidingMeasurementIndicator = Flavor<number, "filter_data.aiding_measurement_indicator">;
/** Use of an aiding measurement by the filter. */
export declare const AidingMeasurementIndicator: Bitfield<AidingMeasurementIndicator> & {
    /** The measurement is enabled. Bit 0. */
    readonly ENABLED: AidingMeasurementIndicator;
    /** The filter used the measurement. Bit 1. */
    readonly USED: AidingMeasurementIndicator;
    /** The measurement disagrees with the estimate. Bit 2. */
    readonly RESIDUAL_HIGH_WARNING: AidingMeasurementIndicator;
    /** The time of the measurement is doubtful. Bit 3. */
    readonly SAMPLE_TIME_WARNING: AidingMeasurementIndicator;
    /** The measurement is configured incorrectly. Bit 4. */
    readonly CONFIG_ERROR: AidingMeasurementIndicator;
    /** There are more measurements than the filter can process. Bit 5. */
    readonly MAX_MEASUREMENTS_EXCEEDED: AidingMeasurementIndicator;
};

export type DualAntennaFixType = Flavor<number, "filter_data.dual_antenna_fix_type">;
/** Kind of dual-antenna heading solution. */
export declare const DualAntennaFixType: Enumeration<DualAntennaFixType> & {
    /** No solution. */
    readonly FIX_NONE: DualAntennaFixType & 0;
    /** Solution with float ambiguities. */
    readonly FIX_DA_FLOAT: DualAntennaFixType & 1;
    /** Solution with fixed ambiguities. */
    readonly FIX_DA_FIXED: DualAntennaFixType & 2;
};

export type DualAntennaStatusFlags = Flavor<number, "filter_data.dual_antenna_status_flags">;
/** Inputs available to the dual-antenna heading solution. */
export declare const DualAntennaStatusFlags: Bitfield<DualAntennaStatusFlags> & {
    /** Data of receiver 1 is valid. Bit 0. */
    readonly RECEIVER_1_DATA_VALID: DualAntennaStatusFlags;
    /** Data of receiver 2 is valid. Bit 1. */
    readonly RECEIVER_2_DATA_VALID: DualAntennaStatusFlags;
    /** The antenna offsets are valid. Bit 2. */
    readonly ANTENNA_OFFSETS_VALID: DualAntennaStatusFlags;
};

export type Gx5FilterState = Flavor<number, "filter_data.gx5_filter_state">;
/**
 * State of the filter of a 5-series device.
 *
 * - 3dm-gx5-15: 5.2.1 Filter Status (0x82, 0x10)
 * - 3dm-cv7-gnss-ins: Status (0x82,0x10)
 */
export declare const Gx5FilterState: Enumeration<Gx5FilterState> & {
    /** The device is starting. */
    readonly STARTUP: Gx5FilterState & 0;
    /** Initialization; the status flags show what is missing. */
    readonly INIT: Gx5FilterState & 1;
    /** Running with a valid solution. */
    readonly RUN_SOLUTION_VALID: Gx5FilterState & 2;
    /** Running with an error; the status flags show which. */
    readonly RUN_SOLUTION_ERROR: Gx5FilterState & 3;
};

export type Cv7FilterState = Flavor<number, "filter_data.cv7_filter_state">;
/**
 * Mode of the filter of a 3DM-CV7.
 *
 * - 3dm-cv7-gnss-ins: Filter States
 * - 3dm-cv7-gnss-ins: Status (0x82,0x10)
 */
export declare const Cv7FilterState: Enumeration<Cv7FilterState> & {
    /** Initialization; initial conditions are missing or the filter waits for a command. */
    readonly INIT: Cv7FilterState & 1;
    /** Vertical gyro: pitch and roll, and heading relative to the initial one. */
    readonly VERTICAL_GYRO: Cv7FilterState & 2;
    /** Pitch, roll and absolute heading. */
    readonly AHRS: Cv7FilterState & 3;
    /** Full navigation: position, velocity and attitude. */
    readonly FULL_NAV: Cv7FilterState & 4;
};

export type Gx5DynamicsMode = Flavor<number, "filter_data.gx5_dynamics_mode">;
/** Motion for which the filter of a 5-series device is configured. */
export declare const Gx5DynamicsMode: Enumeration<Gx5DynamicsMode> & {
    /** Carried by hand. */
    readonly PORTABLE: Gx5DynamicsMode & 1;
    /** Ground vehicle. */
    readonly AUTOMOTIVE: Gx5DynamicsMode & 2;
    /** Aircraft. */
    readonly AIRBORNE: Gx5DynamicsMode & 3;
    /**
     * Aircraft with high acceleration. Uncertain: The manual of the 3DM-GX5-15 lists 1 to 3;
     * `filter.VehicleDynamicsMode` sets 4, too.
     */
    readonly AIRBORNE_HIGH_G: Gx5DynamicsMode & 4;
};

export type Cv7DynamicsMode = Flavor<number, "filter_data.cv7_dynamics_mode">;
/** Dynamics mode of a 7-series device; there is only one. */
export declare const Cv7DynamicsMode: Enumeration<Cv7DynamicsMode> & {
    /** The only mode. */
    readonly DEFAULT: Cv7DynamicsMode & 1;
};

export type Gx5StatusFlags = Flavor<number, "filter_data.gx5_status_flags">;
/**
 * Problems of the filter of a 5-series device; their meaning depends on the state of the filter.
 *
 * - 3dm-gx5-15: 5.2.1 Filter Status (0x82, 0x10)
 * - 3dm-cv7-gnss-ins: Status (0x82,0x10)
 */
export declare const Gx5StatusFlags: Bitfield<Gx5StatusFlags> & {
    /**
     * No inertial data. Bit 0. Only while `filter_state` is `Gx5FilterState.RUN_SOLUTION_VALID` or
     * `Gx5FilterState.RUN_SOLUTION_ERROR`. Affects `sensor.ScaledAccel` and `sensor.ScaledGyro`.
     */
    readonly RUN_IMU_UNAVAILABLE: Gx5StatusFlags;
    /**
     * No GNSS data; only on models with GNSS. Bit 1. Only while `filter_state` is `Gx5FilterState.RUN_SOLUTION_VALID`
     * or `Gx5FilterState.RUN_SOLUTION_ERROR`. Affects `LlhPosition` and `NedVelocity`.
     */
    readonly RUN_GPS_UNAVAILABLE: Gx5StatusFlags;
    /**
     * A matrix in the computation is singular. Bit 3. Only while `filter_state` is `Gx5FilterState.RUN_SOLUTION_VALID`
     * or `Gx5FilterState.RUN_SOLUTION_ERROR`. Affects `filter.Reset`.
     */
    readonly RUN_MATRIX_SINGULARITY: Gx5StatusFlags;
    /**
     * A position covariance is above its normal limit. Bit 4. Only while `filter_state` is
     * `Gx5FilterState.RUN_SOLUTION_VALID` or `Gx5FilterState.RUN_SOLUTION_ERROR`. Affects `LlhPosition` and
     * `LlhPositionUncertainty`.
     */
    readonly RUN_POSITION_COVARIANCE_WARNING: Gx5StatusFlags;
    /**
     * A velocity covariance is above its normal limit. Bit 5. Only while `filter_state` is
     * `Gx5FilterState.RUN_SOLUTION_VALID` or `Gx5FilterState.RUN_SOLUTION_ERROR`. Affects `NedVelocity` and
     * `NedVelocityUncertainty`.
     */
    readonly RUN_VELOCITY_COVARIANCE_WARNING: Gx5StatusFlags;
    /**
     * An attitude covariance is above its normal limit. Bit 6. Only while `filter_state` is
     * `Gx5FilterState.RUN_SOLUTION_VALID` or `Gx5FilterState.RUN_SOLUTION_ERROR`. Affects `EulerAngles` and
     * `EulerAnglesUncertainty`.
     */
    readonly RUN_ATTITUDE_COVARIANCE_WARNING: Gx5StatusFlags;
    /**
     * The solution contains NaN values. Bit 7. Only while `filter_state` is `Gx5FilterState.RUN_SOLUTION_VALID` or
     * `Gx5FilterState.RUN_SOLUTION_ERROR`. Affects `filter.Reset`.
     */
    readonly RUN_NAN_IN_SOLUTION_WARNING: Gx5StatusFlags;
    /**
     * The estimated gyroscope bias is high. Bit 8. Only while `filter_state` is `Gx5FilterState.RUN_SOLUTION_VALID` or
     * `Gx5FilterState.RUN_SOLUTION_ERROR`. Affects `GyroBias`.
     */
    readonly RUN_GYRO_BIAS_EST_HIGH_WARNING: Gx5StatusFlags;
    /**
     * The estimated accelerometer bias is high. Bit 9. Only while `filter_state` is `Gx5FilterState.RUN_SOLUTION_VALID`
     * or `Gx5FilterState.RUN_SOLUTION_ERROR`. Affects `AccelBias`.
     */
    readonly RUN_ACCEL_BIAS_EST_HIGH_WARNING: Gx5StatusFlags;
    /**
     * The estimated gyroscope scale factor is high. Bit 10. Only while `filter_state` is
     * `Gx5FilterState.RUN_SOLUTION_VALID` or `Gx5FilterState.RUN_SOLUTION_ERROR`. Affects `GyroScaleFactor`.
     */
    readonly RUN_GYRO_SCALE_FACTOR_EST_HIGH_WARNING: Gx5StatusFlags;
    /**
     * The estimated accelerometer scale factor is high. Bit 11. Only while `filter_state` is
     * `Gx5FilterState.RUN_SOLUTION_VALID` or `Gx5FilterState.RUN_SOLUTION_ERROR`. Affects `AccelScaleFactor`.
     */
    readonly RUN_ACCEL_SCALE_FACTOR_EST_HIGH_WARNING: Gx5StatusFlags;
    /**
     * The estimated magnetometer bias is high. Bit 12. Only while `filter_state` is `Gx5FilterState.RUN_SOLUTION_VALID`
     * or `Gx5FilterState.RUN_SOLUTION_ERROR`. Affects `MagBias`.
     */
    readonly RUN_MAG_BIAS_EST_HIGH_WARNING: Gx5StatusFlags;
    /**
     * The estimated correction of the antenna offset is high; on models with GNSS. Bit 13. Only while `filter_state` is
     * `Gx5FilterState.RUN_SOLUTION_VALID` or `Gx5FilterState.RUN_SOLUTION_ERROR`. Affects `AntennaOffsetCorrection` and
     * `filter.AntennaOffset`.
     */
    readonly RUN_ANTENNA_OFFSET_CORRECTION_EST_HIGH_WARNING: Gx5StatusFlags;
    /**
     * The estimated hard-iron offset is high. Bit 14. Only while `filter_state` is `Gx5FilterState.RUN_SOLUTION_VALID`
     * or `Gx5FilterState.RUN_SOLUTION_ERROR`. Affects `MagOffset`.
     */
    readonly RUN_MAG_HARD_IRON_EST_HIGH_WARNING: Gx5StatusFlags;
    /**
     * The estimated soft-iron correction is high. Bit 15. Only while `filter_state` is
     * `Gx5FilterState.RUN_SOLUTION_VALID` or `Gx5FilterState.RUN_SOLUTION_ERROR`. Affects `MagMatrix`.
     */
    readonly RUN_MAG_SOFT_IRON_EST_HIGH_WARNING: Gx5StatusFlags;
    /**
     * The attitude is not initialized. Bit 12. Overlaps other bits. Only while `filter_state` is `Gx5FilterState.INIT`.
     * Affects `AttitudeQuaternion`, `AttitudeDcm` and `EulerAngles`.
     */
    readonly INIT_NO_ATTITUDE: Gx5StatusFlags;
    /**
     * Position and velocity are not initialized. Bit 13. Overlaps other bits. Only while `filter_state` is
     * `Gx5FilterState.INIT`. Affects `LlhPosition` and `NedVelocity`.
     */
    readonly INIT_NO_POSITION_VELOCITY: Gx5StatusFlags;
};

export type FilterCondition = Flavor<number, "filter_data.filter_condition">;
/**
 * Convergence of the filter's estimates.
 *
 * - 3dm-cv7-gnss-ins: Filter condition (bits 0-1)
 * - 3dm-cv7-gnss-ins: How do I interpret the Status (0x82,0x10) message?
 */
export declare const FilterCondition: Enumeration<FilterCondition> & {
    /** Estimates have settled and agree with the aiding measurements. */
    readonly STABLE: FilterCondition & 1;
    /** Estimates have not settled yet. */
    readonly CONVERGING: FilterCondition & 2;
    /** Estimates are unstable or recovering. */
    readonly UNSTABLE: FilterCondition & 3;
};

export type Cv7StatusFlags = Flavor<number, "filter_data.cv7_status_flags">;
/**
 * Condition and warnings of the filter of a 3DM-CV7.
 *
 * - 3dm-cv7-gnss-ins: Filter Status Flags
 * - 3dm-cv7-gnss-ins: How do I interpret the Status (0x82,0x10) message?
 * - 3dm-cv7-gnss-ins: Status (0x82,0x10)
 */
export declare const Cv7StatusFlags: Bitfield<Cv7StatusFlags> & {
    /** Convergence of the estimates. Bits 0 to 1. A value of `FilterCondition`. */
    readonly FILTER_CONDITION: Cv7StatusFlags;
    /**
     * Roll and pitch are doubtful; check the mounting transformation. Bit 2. Affects `AttitudeQuaternion`,
     * `AttitudeDcm` and `EulerAngles`.
     */
    readonly ROLL_PITCH_WARNING: Cv7StatusFlags;
    /**
     * The heading is doubtful; check the heading source. Bit 3. Affects `AttitudeQuaternion`, `AttitudeDcm` and
     * `EulerAngles`.
     */
    readonly HEADING_WARNING: Cv7StatusFlags;
    /**
     * The position is doubtful; check the GNSS reception and antennas. Bit 4. Affects `LlhPosition`, `EcefPosition` and
     * `NedRelativePosition`.
     */
    readonly POSITION_WARNING: Cv7StatusFlags;
    /**
     * The velocity is doubtful; check the GNSS reception and antennas. Bit 5. Affects `NedVelocity` and `EcefVelocity`.
     */
    readonly VELOCITY_WARNING: Cv7StatusFlags;
    /**
     * The sensor biases are doubtful; capture the gyroscope bias. Bit 6. Affects `AccelBias`, `GyroBias` and
     * `3dm.CaptureGyroBias`.
     */
    readonly IMU_BIAS_WARNING: Cv7StatusFlags;
    /** The GNSS clock is doubtful; navigation continues. Bit 7. Affects `Timestamp` and `ClockCorrection`. */
    readonly GNSS_CLOCK_WARNING: Cv7StatusFlags;
    /**
     * The antenna offsets are probably wrong. Bit 8. Affects `MultiAntennaOffsetCorrection` and
     * `filter.MultiAntennaOffset`.
     */
    readonly ANTENNA_LEVER_ARM_WARNING: Cv7StatusFlags;
    /**
     * The mounting transformation is probably wrong. Bit 9. Affects `3dm.SensorToVehicleTransformEuler` and
     * `3dm.SensorToVehicleTransformDcm`.
     */
    readonly MOUNTING_TRANSFORM_WARNING: Cv7StatusFlags;
    /**
     * No pulse per second is detected, or the time of an external heading is too old. Bit 10. Affects
     * `3dm.PpsSourceControl`.
     */
    readonly TIME_SYNC_WARNING: Cv7StatusFlags;
    /** Not 0 if the solution contains NaN values; reset the filter. Bits 12 to 15. Affects `filter.Reset`. */
    readonly SOLUTION_ERROR: Cv7StatusFlags;
};

/**
 * LLH position (0x82,0x01).
 *
 * Estimated position as latitude, longitude and height.
 *
 * Also called `position_llh`. Confirmed on 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed on 10 more.
 *
 * - 3dm-cv7-gnss-ins: LLH Position (0x82,0x01)
 */
export declare class LlhPosition extends Data {
    constructor(values: Values<LlhPosition>);
    /**
     * Geodetic latitude. Unit: deg. Frame: llh. Range: -90 to 90. Positive: north. Valid if `ValidFlags.VALID` of
     * `validFlags` is set.
     */
    latitude: number;
    /**
     * Geodetic longitude. Unit: deg. Frame: llh. Range: -180 to 180. Positive: east. Valid if `ValidFlags.VALID` of
     * `validFlags` is set.
     */
    longitude: number;
    /** Height above the ellipsoid. Unit: m. Frame: llh. Valid if `ValidFlags.VALID` of `validFlags` is set. */
    ellipsoidHeight: number;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * NED velocity (0x82,0x02).
 *
 * Estimated velocity in the NED frame.
 *
 * Also called `velocity_ned`. Confirmed on 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed on 10 more.
 *
 * - 3dm-cv7-gnss-ins: Velocity NED (0x82,0x02)
 */
export declare class NedVelocity extends Data {
    constructor(values: Values<NedVelocity>);
    /**
     * Velocity north. Unit: m/s. Frame: ned. At rest and level: 0. Valid if `ValidFlags.VALID` of `validFlags` is set.
     */
    north: number;
    /**
     * Velocity east. Unit: m/s. Frame: ned. At rest and level: 0. Valid if `ValidFlags.VALID` of `validFlags` is set.
     */
    east: number;
    /**
     * Velocity down. Unit: m/s. Frame: ned. At rest and level: 0. Valid if `ValidFlags.VALID` of `validFlags` is set.
     */
    down: number;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Attitude quaternion (0x82,0x03).
 *
 * Estimated orientation of the vehicle frame in the NED frame as a quaternion.
 *
 * Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS and 3DM-GX5-15; likely or assumed on 17
 * more.
 *
 * `v_ned = q * v_vehicle * q^-1` The 3DM-GX5-15 manual documents the inverse rotation, which is taken for a misprint.
 *
 * - 3dm-cv7-gnss-ins: Attitude Quaternion (0x82,0x03)
 * - 3dm-gx5-15: 5.2.3 Orientation, Quaternion (0x82, 0x03)
 */
export declare class AttitudeQuaternion extends Data {
    constructor(values: Values<AttitudeQuaternion>);
    /**
     * Rotates vectors of the vehicle frame into the NED frame; Hamilton quaternion, w first. Elements: w, x, y, z.
     * Unit: 1. Frame: ned. At rest and level: x 0, y 0. Valid if `ValidFlags.VALID` of `validFlags` is set.
     */
    q: types.Quatf;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Attitude direction cosine matrix (0x82,0x04).
 *
 * Estimated orientation of the vehicle frame in the NED frame as a rotation matrix.
 *
 * Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-45; likely or assumed on 17 more.
 *
 * `v_vehicle = dcm * v_ned`
 *
 * - 3dm-cv7-gnss-ins: Attitude DCM (0x82,0x04)
 * - 3dm-gx5-15: 5.2.7 Orientation, Matrix (0x82, 0x04)
 */
export declare class AttitudeDcm extends Data {
    constructor(values: Values<AttitudeDcm>);
    /**
     * Rotates vectors of the NED frame into the vehicle frame; row-major. Elements: m11, m12, m13, m21, m22, m23, m31,
     * m32, m33. Unit: 1. Frame: ned. At rest and level: m13 0, m23 0, m31 0, m32 0, m33 1. Valid if `ValidFlags.VALID`
     * of `validFlags` is set.
     */
    dcm: types.Matrix3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Euler angles (0x82,0x05).
 *
 * Estimated orientation of the vehicle frame in the NED frame as Euler angles.
 *
 * Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-45; likely or
 * assumed on 20 more. Uncertain: The ranges of the angles are inferred; no source states them.
 *
 * - 3dm-cv7-gnss-ins: Euler Angles (0x82,0x05)
 * - 3dm-gx5-15: 5.2.5 Orientation, Euler Angles (0x82, 0x05)
 */
export declare class EulerAngles extends Data {
    constructor(values: Values<EulerAngles>);
    /**
     * Rotation about the x axis of the vehicle, after yaw and pitch (order 3-2-1). Unit: rad. Frame: ned. Range: -pi to
     * pi. At rest and level: 0. Positive: right side down. Valid if `ValidFlags.VALID` of `validFlags` is set.
     */
    roll: number;
    /**
     * Rotation about the y axis. Unit: rad. Frame: ned. Range: -1.5707963267948966 to 1.5707963267948966. At rest and
     * level: 0. Positive: nose up. Valid if `ValidFlags.VALID` of `validFlags` is set.
     */
    pitch: number;
    /**
     * Rotation about the z axis: the heading. Unit: rad. Frame: ned. Range: -pi to pi. Positive: clockwise seen from
     * above. Valid if `ValidFlags.VALID` of `validFlags` is set.
     */
    yaw: number;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Gyroscope bias (0x82,0x06).
 *
 * Estimated bias of the gyroscope.
 *
 * Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS and 3DM-GX5-15; likely or assumed on 18 more.
 *
 * - 3dm-cv7-gnss-ins: Gyro Bias (0x82,0x06)
 * - 3dm-gx5-15: 5.2.9 Gyro Bias (0x82, 0x06)
 */
export declare class GyroBias extends Data {
    constructor(values: Values<GyroBias>);
    /**
     * Bias that the filter subtracts. Elements: x, y, z. Unit: rad/s. Frame: sensor. Valid if `ValidFlags.VALID` of
     * `validFlags` is set.
     */
    bias: types.Vector3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Accelerometer bias (0x82,0x07).
 *
 * Estimated bias of the accelerometer.
 *
 * Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 6 more.
 *
 * - 3dm-cv7-gnss-ins: Accel Bias (0x82,0x07)
 */
export declare class AccelBias extends Data {
    constructor(values: Values<AccelBias>);
    /**
     * Bias that the filter subtracts. Elements: x, y, z. Unit: m/s^2. Frame: sensor. Valid if `ValidFlags.VALID` of
     * `validFlags` is set.
     */
    bias: types.Vector3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Position uncertainty (0x82,0x08).
 *
 * Standard deviation of the estimated position, in the NED frame.
 *
 * Also called `position_llh_uncertainty`. Confirmed on 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed on 5
 * more.
 *
 * - 3dm-cv7-gnss-ins: LLH Position Uncertainty (0x82,0x08)
 */
export declare class LlhPositionUncertainty extends Data {
    constructor(values: Values<LlhPositionUncertainty>);
    /**
     * North standard deviation. Unit: m. Frame: ned. Range: at least 0. Valid if `ValidFlags.VALID` of `validFlags` is
     * set.
     */
    north: number;
    /**
     * East standard deviation. Unit: m. Frame: ned. Range: at least 0. Valid if `ValidFlags.VALID` of `validFlags` is
     * set.
     */
    east: number;
    /**
     * Down standard deviation. Unit: m. Frame: ned. Range: at least 0. Valid if `ValidFlags.VALID` of `validFlags` is
     * set.
     */
    down: number;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * NED velocity uncertainty (0x82,0x09).
 *
 * Standard deviation of the estimated velocity in the NED frame.
 *
 * Also called `velocity_ned_uncertainty`. Confirmed on 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed on 5
 * more.
 *
 * - 3dm-cv7-gnss-ins: NED Velocity Uncertainty (0x82,0x09)
 */
export declare class NedVelocityUncertainty extends Data {
    constructor(values: Values<NedVelocityUncertainty>);
    /**
     * North standard deviation. Unit: m/s. Frame: ned. Range: at least 0. Valid if `ValidFlags.VALID` of `validFlags`
     * is set.
     */
    north: number;
    /**
     * East standard deviation. Unit: m/s. Frame: ned. Range: at least 0. Valid if `ValidFlags.VALID` of `validFlags` is
     * set.
     */
    east: number;
    /**
     * Down standard deviation. Unit: m/s. Frame: ned. Range: at least 0. Valid if `ValidFlags.VALID` of `validFlags` is
     * set.
     */
    down: number;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Euler angles uncertainty (0x82,0x0A).
 *
 * Standard deviation of the estimated Euler angles.
 *
 * Confirmed on 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS and 3DM-GX5-15; likely or assumed on 19 more.
 *
 * 3DM-GX5: derived from the quaternion, less accurate at steep pitch, and not valid beyond 70 degrees of pitch up or
 * down.
 *
 * - 3dm-cv7-gnss-ins: Euler Angles Uncertainty (0x82,0x0A)
 * - 3dm-gx5-15: 5.2.6 Attitude Uncertainty, Euler Angles (0x82, 0x0A)
 */
export declare class EulerAnglesUncertainty extends Data {
    constructor(values: Values<EulerAnglesUncertainty>);
    /** Standard deviation of roll. Unit: rad. Range: at least 0. Valid if `ValidFlags.VALID` of `validFlags` is set. */
    roll: number;
    /**
     * Standard deviation of pitch. Unit: rad. Range: at least 0. Valid if `ValidFlags.VALID` of `validFlags` is set.
     */
    pitch: number;
    /** Standard deviation of yaw. Unit: rad. Range: at least 0. Valid if `ValidFlags.VALID` of `validFlags` is set. */
    yaw: number;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Gyroscope bias uncertainty (0x82,0x0B).
 *
 * Standard deviation of the estimated gyroscope bias.
 *
 * Confirmed on 3DM-CV7-GNSS/INS and 3DM-GX5-15; likely or assumed on 20 more.
 *
 * - 3dm-cv7-gnss-ins: Gyro Bias Uncertainty (0x82,0x0B)
 * - 3dm-gx5-15: 5.2.10 Gyro Bias Uncertainty (0x82, 0x0B)
 */
export declare class GyroBiasUncertainty extends Data {
    constructor(values: Values<GyroBiasUncertainty>);
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: rad/s. Frame: sensor. Range: at least 0. Valid if
     * `ValidFlags.VALID` of `validFlags` is set.
     */
    biasUncertainty: types.Vector3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Accelerometer bias uncertainty (0x82,0x0C).
 *
 * Standard deviation of the estimated accelerometer bias.
 *
 * Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 6 more.
 *
 * - 3dm-cv7-gnss-ins: Accel Bias Uncertainty (0x82,0x0C)
 */
export declare class AccelBiasUncertainty extends Data {
    constructor(values: Values<AccelBiasUncertainty>);
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: m/s^2. Frame: sensor. Range: at least 0. Valid if
     * `ValidFlags.VALID` of `validFlags` is set.
     */
    biasUncertainty: types.Vector3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Linear acceleration (0x82,0x0D).
 *
 * Rate of change of the velocity, with the effect of gravity removed.
 *
 * Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS and 3DM-GX5-15; likely or assumed on 17
 * more.
 *
 * - 3dm-cv7-gnss-ins: Linear Accel (0x82,0x0D)
 * - 3dm-gx5-15: 5.2.12 Linear Acceleration (0x82, 0x0D)
 */
export declare class LinearAccel extends Data {
    constructor(values: Values<LinearAccel>);
    /**
     * Linear acceleration; zero while the velocity is constant. Elements: x, y, z. Unit: m/s^2. Frame: vehicle. At rest
     * and level: x 0, y 0, z 0. Valid if `ValidFlags.VALID` of `validFlags` is set.
     */
    accel: types.Vector3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Compensated angular rate (0x82,0x0E).
 *
 * Angular rate with the estimated bias removed.
 *
 * Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-45; likely or
 * assumed on 16 more.
 *
 * - 3dm-cv7-gnss-ins: Comp Angular Rate (0x82,0x0E)
 * - 3dm-gx5-15: 5.2.8 Compensated Angular Rate (0x82, 0x0E)
 */
export declare class CompAngularRate extends Data {
    constructor(values: Values<CompAngularRate>);
    /**
     * Angular rate. Elements: x, y, z. Unit: rad/s. Frame: vehicle. At rest and level: x 0, y 0, z 0. Positive: right
     * side down, nose up, clockwise seen from above. Valid if `ValidFlags.VALID` of `validFlags` is set.
     */
    gyro: types.Vector3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * WGS84 local gravity magnitude (0x82,0x0F).
 *
 * Magnitude of gravity at the position of the device according to the WGS84 model.
 *
 * Also called `wgs84_gravity_mag`. Confirmed on 3DM-GX5-15; likely or assumed on 10 more.
 *
 * The model is valid up to an altitude of 20 km.
 *
 * - 3dm-gx5-15: 5.2.15 WGS84 Local Gravity Magnitude (0x82, 0x0F)
 */
export declare class Wgs84GravityMagnitude extends Data {
    constructor(values: Values<Wgs84GravityMagnitude>);
    /**
     * Gravity at this position according to the model. Unit: m/s^2. Range: at least 0. At rest and level: 9.8. Valid if
     * `ValidFlags.VALID` of `validFlags` is set.
     */
    gravityMagnitude: number;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Filter status (0x82,0x10).
 *
 * State, dynamics mode, condition and warnings of the filter.
 *
 * Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS and 3DM-GX5-15; likely or assumed on 17
 * more.
 *
 * 7-series: state 1 is initialization, 2 vertical gyro, 3 AHRS, 4 full navigation. On the 3DM-CV7, normal operation is
 * state 4, mode 1, flags 1 (stable). 5-series and older: state 0 is start-up, 1 initialization, 2 a valid solution, 3 a
 * solution with an error. Bits 12 and 13 of the flags have other meanings in state 1 than in states 2 and 3.
 *
 * - 3dm-cv7-gnss-ins: Status (0x82,0x10)
 * - 3dm-gx5-15: 5.2.1 Filter Status (0x82, 0x10)
 */
export declare class Status extends Data {
    constructor(values: Values<Status>);
    /**
     * Progress of the filter from start-up to its full solution.
     *
     * - On the 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-CX5-45, 3DM-DH3, 3DM-GQ4-45,
     *   3DM-GX3-15, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-GX4-IMU, 3DM-GX5-25, 3DM-GX5-45,
     *   3DM-MV5-AR, 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and 3DM-RQ1-IMU: values of `Gx5FilterState` (inferred: the 3DM-GX5-15
     *   has them, and the SDK lists the same states for all generations up to the fifth).
     * - On the 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-INS, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-CX7-INS, 3DM-GQ7-GNSS/INS,
     *   3DM-GV7-AHRS, 3DM-GV7-AR and 3DM-GV7-INS: values of `Cv7FilterState` (inferred: the 3DM-CV7-GNSS/INS has them,
     *   and the SDK lists the same states for its generation).
     * - On the 3DM-CV7-GNSS/INS: values of `Cv7FilterState`.
     * - On the 3DM-GX5-15: values of `Gx5FilterState`.
     */
    filterState: number;
    /**
     * Motion for which the filter is configured.
     *
     * - On the 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-CX5-45, 3DM-DH3, 3DM-GQ4-45,
     *   3DM-GX3-15, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-GX4-IMU, 3DM-GX5-25, 3DM-GX5-45,
     *   3DM-MV5-AR, 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and 3DM-RQ1-IMU: values of `Gx5DynamicsMode` (inferred: the 3DM-GX5-15
     *   has them, and the SDK lists the same states for all generations up to the fifth).
     * - On the 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-INS, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-CX7-INS, 3DM-GQ7-GNSS/INS,
     *   3DM-GV7-AHRS, 3DM-GV7-AR and 3DM-GV7-INS: values of `Cv7DynamicsMode` (inferred: the 3DM-CV7-GNSS/INS has them,
     *   and the SDK lists the same states for its generation).
     * - On the 3DM-CV7-GNSS/INS: values of `Cv7DynamicsMode`.
     * - On the 3DM-GX5-15: values of `Gx5DynamicsMode`.
     */
    dynamicsMode: number;
    /**
     * Condition and warnings.
     *
     * - On the 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-CX5-45, 3DM-DH3, 3DM-GQ4-45,
     *   3DM-GX3-15, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-GX4-IMU, 3DM-GX5-25, 3DM-GX5-45,
     *   3DM-MV5-AR, 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and 3DM-RQ1-IMU: values of `Gx5StatusFlags` (inferred: the 3DM-GX5-15
     *   has them, and the SDK lists the same states for all generations up to the fifth).
     * - On the 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-INS, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-CX7-INS, 3DM-GQ7-GNSS/INS,
     *   3DM-GV7-AHRS, 3DM-GV7-AR and 3DM-GV7-INS: values of `Cv7StatusFlags` (inferred: the 3DM-CV7-GNSS/INS has them,
     *   and the SDK lists the same states for its generation).
     * - On the 3DM-CV7-GNSS/INS: values of `Cv7StatusFlags`.
     * - On the 3DM-GX5-15: values of `Gx5StatusFlags`.
     */
    statusFlags: number;
}

/**
 * Filter timestamp (0x82,0x11).
 *
 * GPS time of the filter data.
 *
 * Confirmed on 3DM-CV7-GNSS/INS and 3DM-GX5-15; likely or assumed on 10 more.
 *
 * Without PPS the internal clock drives the time, and the time jumps when the PPS returns. Without synchronization to a
 * receiver or an external clock it is the internal system time. 3DM-CV7: this field may be withdrawn; prefer
 * `shared.GpsTimestamp`.
 *
 * - 3dm-cv7-gnss-ins: Timestamp (0x82,0x11)
 * - 3dm-gx5-15: 5.2.2 GPS Timestamp (0x82, 0x11)
 */
export declare class Timestamp extends Data {
    constructor(values: Values<Timestamp>);
    /**
     * GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if `ValidFlags.VALID` of `validFlags` is
     * set.
     */
    tow: number;
    /** GPS week, counted from 1980. Unit: week. Valid if `ValidFlags.VALID` of `validFlags` is set. */
    weekNumber: number;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Quaternion uncertainty (0x82,0x12).
 *
 * Standard deviation of the elements of the estimated attitude quaternion.
 *
 * Confirmed on 3DM-CV7-GNSS/INS and 3DM-GX5-15; likely or assumed on 20 more.
 *
 * - 3dm-cv7-gnss-ins: Quaternion Attitude Uncertainty (0x82,0x12)
 * - 3dm-gx5-15: 5.2.4 Attitude Uncertainty, Quaternion Elements (0x82, 0x12)
 */
export declare class QuaternionAttitudeUncertainty extends Data {
    constructor(values: Values<QuaternionAttitudeUncertainty>);
    /**
     * Standard deviation per element. Elements: w, x, y, z. Unit: 1. Range: at least 0. Valid if `ValidFlags.VALID` of
     * `validFlags` is set.
     */
    q: types.Quatf;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Gravity vector (0x82,0x13).
 *
 * Estimated gravity.
 *
 * Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS and 3DM-GX5-15; likely or assumed on 18 more.
 *
 * - 3dm-cv7-gnss-ins: Gravity Vector (0x82,0x13)
 * - 3dm-gx5-15: 5.2.14 Gravity Vector (0x82, 0x13)
 */
export declare class GravityVector extends Data {
    constructor(values: Values<GravityVector>);
    /**
     * Gravity vector, which points down. Elements: x, y, z. Unit: m/s^2. Frame: vehicle. At rest and level: x 0, y 0, z
     * 9.8. Valid if `ValidFlags.VALID` of `validFlags` is set. Uncertain: No source states the sign.
     */
    gravity: types.Vector3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Heading update source state (0x82,0x14).
 *
 * The last heading that updated the filter, and its source.
 *
 * Confirmed on 3DM-GX5-15 and 3DM-GX5-45; likely or assumed on 8 more.
 *
 * The valid bit means that the source provided data within the last 2 seconds.
 *
 * - 3dm-gx5-15: 5.2.16 Heading Update Source State (0x82, 0x14)
 */
export declare class HeadingUpdateState extends Data {
    constructor(values: Values<HeadingUpdateState>);
    /**
     * Heading of the sensor frame relative to true north. Unit: rad. Frame: ned. Positive: clockwise seen from above.
     * Valid if `ValidFlags.VALID` of `validFlags` is set.
     */
    heading: number;
    /**
     * Standard deviation of the heading. Unit: rad. Range: at least 0. Valid if `ValidFlags.VALID` of `validFlags` is
     * set.
     */
    headingUncertainty: number;
    /**
     * Sources of the heading.
     *
     * - On the 3DM-CV5-15, 3DM-CX5-15 and 3DM-GX5-15: only `HeadingSourceFlags.EXTERNAL`.
     * - On the 3DM-CV5-25, 3DM-CX5-25, 3DM-GX4-25 and 3DM-GX5-25: only `HeadingSourceFlags.MAG` and
     *   `HeadingSourceFlags.EXTERNAL`.
     */
    source: HeadingSourceFlags;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Magnetic model (0x82,0x15).
 *
 * Magnetic field at the position of the device according to the World Magnetic Model.
 *
 * Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 11 more.
 *
 * It is valid only with a valid GNSS position.
 *
 * - 3dm-cv7-gnss-ins: Magnetic Model (0x82,0x15)
 */
export declare class MagneticModel extends Data {
    constructor(values: Values<MagneticModel>);
    /** North component of the field. Unit: gauss. Frame: ned. Valid if `ValidFlags.VALID` of `validFlags` is set. */
    intensityNorth: number;
    /** East component of the field. Unit: gauss. Frame: ned. Valid if `ValidFlags.VALID` of `validFlags` is set. */
    intensityEast: number;
    /** Down component of the field. Unit: gauss. Frame: ned. Valid if `ValidFlags.VALID` of `validFlags` is set. */
    intensityDown: number;
    /**
     * Angle of the field below the horizontal plane. Unit: rad. Frame: ned. Range: -1.5707963267948966 to
     * 1.5707963267948966. Positive: the field points down. Valid if `ValidFlags.VALID` of `validFlags` is set.
     */
    inclination: number;
    /**
     * Angle from true north to magnetic north. Unit: rad. Frame: ned. Range: -pi to pi. Positive: magnetic north is
     * east of true north. Valid if `ValidFlags.VALID` of `validFlags` is set.
     */
    declination: number;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Gyroscope scale factor (0x82,0x16).
 *
 * Estimated scale factor of the gyroscope.
 *
 * Not listed in any device profile. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Gyro Scale Factor (0x82,0x16)
 */
export declare class GyroScaleFactor extends Data {
    constructor(values: Values<GyroScaleFactor>);
    /**
     * Scale factor per axis. Elements: x, y, z. Unit: 1. Frame: sensor. Valid if `ValidFlags.VALID` of `validFlags` is
     * set.
     */
    scaleFactor: types.Vector3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Accelerometer scale factor (0x82,0x17).
 *
 * Estimated scale factor of the accelerometer.
 *
 * Not listed in any device profile. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Accel Scale Factor (0x82,0x17)
 */
export declare class AccelScaleFactor extends Data {
    constructor(values: Values<AccelScaleFactor>);
    /**
     * Scale factor per axis. Elements: x, y, z. Unit: 1. Frame: sensor. Valid if `ValidFlags.VALID` of `validFlags` is
     * set.
     */
    scaleFactor: types.Vector3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Gyroscope scale factor uncertainty (0x82,0x18).
 *
 * Standard deviation of the estimated scale factor of the gyroscope.
 *
 * Not listed in any device profile. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Gyro Scale Factor Uncertainty (0x82,0x18)
 */
export declare class GyroScaleFactorUncertainty extends Data {
    constructor(values: Values<GyroScaleFactorUncertainty>);
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: 1. Frame: sensor. Range: at least 0. Valid if
     * `ValidFlags.VALID` of `validFlags` is set.
     */
    scaleFactorUncertainty: types.Vector3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Accelerometer scale factor uncertainty (0x82,0x19).
 *
 * Standard deviation of the estimated scale factor of the accelerometer.
 *
 * Not listed in any device profile. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Accel Scale Factor Uncertainty (0x82,0x19)
 */
export declare class AccelScaleFactorUncertainty extends Data {
    constructor(values: Values<AccelScaleFactorUncertainty>);
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: 1. Frame: sensor. Range: at least 0. Valid if
     * `ValidFlags.VALID` of `validFlags` is set.
     */
    scaleFactorUncertainty: types.Vector3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Magnetometer bias (0x82,0x1A).
 *
 * Estimated bias of the magnetometer.
 *
 * Not listed in any device profile. Known only from the MicroStrain MIP SDK. Requires a magnetometer.
 *
 * - mip-sdk-4: Mag Bias (0x82,0x1A)
 */
export declare class MagBias extends Data {
    constructor(values: Values<MagBias>);
    /**
     * Estimated bias of the magnetometer. Elements: x, y, z. Unit: gauss. Frame: sensor. Valid if `ValidFlags.VALID` of
     * `validFlags` is set.
     */
    bias: types.Vector3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Magnetometer bias uncertainty (0x82,0x1B).
 *
 * Standard deviation of the estimated bias of the magnetometer.
 *
 * Not listed in any device profile. Known only from the MicroStrain MIP SDK. Requires a magnetometer.
 *
 * - mip-sdk-4: Mag Bias Uncertainty (0x82,0x1B)
 */
export declare class MagBiasUncertainty extends Data {
    constructor(values: Values<MagBiasUncertainty>);
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: gauss. Frame: sensor. Range: at least 0. Valid if
     * `ValidFlags.VALID` of `validFlags` is set.
     */
    biasUncertainty: types.Vector3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Compensated acceleration (0x82,0x1C).
 *
 * Specific force with the estimated bias removed.
 *
 * Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS and 3DM-GX5-15; likely or assumed on 14
 * more.
 *
 * - 3dm-cv7-gnss-ins: Compensated Acceleration (0x82,0x1C)
 * - 3dm-gx5-15: 5.2.11 Compensated Acceleration (0x82, 0x1C)
 */
export declare class CompAccel extends Data {
    constructor(values: Values<CompAccel>);
    /**
     * Specific force: acceleration minus gravity. Elements: x, y, z. Unit: m/s^2. Frame: vehicle. At rest and level: x
     * 0, y 0, z -9.8. Valid if `ValidFlags.VALID` of `validFlags` is set.
     */
    accel: types.Vector3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Standard atmosphere (0x82,0x20).
 *
 * US Standard Atmosphere of 1976 at the device's altitude.
 *
 * No device is known for certain to support it. Known only from the MicroStrain MIP SDK.
 *
 * It is valid only with a valid GNSS position.
 *
 * - mip-sdk-4: Standard atmosphere (0x82,0x20)
 */
export declare class StandardAtmosphere extends Data {
    constructor(values: Values<StandardAtmosphere>);
    /** Altitude used in the model. Unit: m. Valid if `ValidFlags.VALID` of `validFlags` is set. */
    geometricAltitude: number;
    /**
     * Geometric altitude corrected for the decrease of gravity with height. Unit: m. Valid if `ValidFlags.VALID` of
     * `validFlags` is set.
     */
    geopotentialAltitude: number;
    /**
     * Temperature at this altitude according to the model. Unit: degC. Valid if `ValidFlags.VALID` of `validFlags` is
     * set.
     */
    standardTemperature: number;
    /**
     * Pressure at this altitude according to the model. Unit: mbar. Range: at least 0. Valid if `ValidFlags.VALID` of
     * `validFlags` is set.
     */
    standardPressure: number;
    /**
     * Air density at this altitude according to the model. Unit: kg/m^3. Range: at least 0. Valid if `ValidFlags.VALID`
     * of `validFlags` is set.
     */
    standardDensity: number;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Pressure altitude (0x82,0x21).
 *
 * Altitude from the measured pressure, by the US Standard Atmosphere of 1976.
 *
 * Confirmed on 3DM-CV7-GNSS/INS and 3DM-GX5-15; likely or assumed on 17 more. Requires a pressure sensor.
 *
 * It needs a valid pressure. The model ends at a pressure of 0.0037 mbar, an altitude of 84852 m.
 *
 * - 3dm-cv7-gnss-ins: Pressure Altitude (0x82,0x21)
 * - 3dm-gx5-15: 5.2.13 Pressure Altitude (0x82, 0x21)
 */
export declare class PressureAltitude extends Data {
    constructor(values: Values<PressureAltitude>);
    /**
     * Altitude at which the standard atmosphere has the measured pressure. Unit: m. Range: at most 84852. Valid if
     * `ValidFlags.VALID` of `validFlags` is set.
     */
    pressureAltitude: number;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Density altitude (0x82,0x22).
 *
 * Density of the surrounding air, expressed as the altitude with the same density in the standard atmosphere.
 *
 * Not listed in any device profile. Known only from the MicroStrain MIP SDK. Uncertain: The SDK lists only the name;
 * the description is the usual meaning of the term.
 *
 * - mip-sdk-4: Density altitude (0x82,0x22)
 */
export declare class DensityAltitude extends Data {
    constructor(values: Values<DensityAltitude>);
    /**
     * Altitude at which the standard atmosphere has the present air density. Unit: m. Valid if `ValidFlags.VALID` of
     * `validFlags` is set.
     */
    densityAltitude: number;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Magnetometer offset (0x82,0x25).
 *
 * Estimated hard iron offset of the magnetometer.
 *
 * No device is known for certain to support it. Also called `magnetometer_offset`. Known only from the MicroStrain MIP
 * SDK. Requires a magnetometer.
 *
 * The filter adds it to the stored offset of `3dm.MagHardIronOffset`.
 *
 * - mip-sdk-4: Magnetometer offset (0x82,0x25)
 */
export declare class MagOffset extends Data {
    constructor(values: Values<MagOffset>);
    /**
     * Estimated constant field of magnetized parts near the magnetometer. Elements: x, y, z. Unit: gauss. Frame:
     * sensor. Valid if `ValidFlags.VALID` of `validFlags` is set.
     */
    hardIron: types.Vector3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Magnetometer matrix (0x82,0x26).
 *
 * Estimated soft iron matrix of the magnetometer.
 *
 * No device is known for certain to support it. Also called `magnetometer_matrix`. Known only from the MicroStrain MIP
 * SDK. Requires a magnetometer.
 *
 * The filter multiplies the stored matrix of `3dm.MagSoftIronMatrix` by this matrix on the right.
 *
 * - mip-sdk-4: Magnetometer matrix (0x82,0x26)
 */
export declare class MagMatrix extends Data {
    constructor(values: Values<MagMatrix>);
    /**
     * Soft iron matrix in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit: 1. Frame:
     * sensor. Valid if `ValidFlags.VALID` of `validFlags` is set.
     */
    softIron: types.Matrix3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Magnetometer offset uncertainty (0x82,0x28).
 *
 * Standard deviation of the estimated hard iron offset.
 *
 * No device is known for certain to support it. Also called `magnetometer_offset_uncertainty`. Known only from the
 * MicroStrain MIP SDK. Requires a magnetometer.
 *
 * - mip-sdk-4: Magnetometer offset uncertainty (0x82,0x28)
 */
export declare class MagOffsetUncertainty extends Data {
    constructor(values: Values<MagOffsetUncertainty>);
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: gauss. Frame: sensor. Range: at least 0. Valid if
     * `ValidFlags.VALID` of `validFlags` is set.
     */
    hardIronUncertainty: types.Vector3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Magnetometer matrix uncertainty (0x82,0x29).
 *
 * Standard deviation of the estimated soft iron matrix.
 *
 * No device is known for certain to support it. Also called `magnetometer_matrix_uncertainty`. Known only from the
 * MicroStrain MIP SDK. Requires a magnetometer.
 *
 * - mip-sdk-4: Magnetometer matrix uncertainty (0x82,0x29)
 */
export declare class MagMatrixUncertainty extends Data {
    constructor(values: Values<MagMatrixUncertainty>);
    /**
     * Standard deviation per element. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit: 1. Frame: sensor.
     * Range: at least 0. Valid if `ValidFlags.VALID` of `validFlags` is set.
     */
    softIronUncertainty: types.Matrix3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Magnetometer covariance matrix (0x82,0x2A).
 *
 * Covariance of the magnetometer measurement.
 *
 * Also called `magnetometer_covariance_matrix`. Not listed in any device profile. Known only from the MicroStrain MIP
 * SDK. Requires a magnetometer.
 *
 * - mip-sdk-4: Magnetometer covariance matrix (0x82,0x2A)
 */
export declare class MagCovarianceMatrix extends Data {
    constructor(values: Values<MagCovarianceMatrix>);
    /**
     * Covariance matrix in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Valid if
     * `ValidFlags.VALID` of `validFlags` is set. Uncertain: No source states the unit, which is likely gauss^2, or the
     * frame.
     */
    covariance: types.Matrix3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Magnetometer residual vector (0x82,0x2C).
 *
 * Residual of the magnetometer measurement.
 *
 * Also called `magnetometer_residual_vector`. Not listed in any device profile. Known only from the MicroStrain MIP
 * SDK. Requires a magnetometer.
 *
 * - mip-sdk-4: Magnetometer residual vector (0x82,0x2C)
 */
export declare class MagResidualVector extends Data {
    constructor(values: Values<MagResidualVector>);
    /**
     * Difference between the measured and the expected magnetic field. Elements: x, y, z. Unit: gauss. Frame: vehicle.
     * Valid if `ValidFlags.VALID` of `validFlags` is set.
     */
    residual: types.Vector3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Antenna offset correction (0x82,0x30).
 *
 * Estimated error of the GNSS antenna offset.
 *
 * Not listed in any device profile. Known only from the MicroStrain MIP SDK.
 *
 * The filter adds it to the stored offset of `filter.AntennaOffset`.
 *
 * - mip-sdk-4: Antenna offset correction (0x82,0x30)
 */
export declare class AntennaOffsetCorrection extends Data {
    constructor(values: Values<AntennaOffsetCorrection>);
    /**
     * Estimated correction of the configured antenna offset. Elements: x, y, z. Unit: m. Frame: vehicle. Valid if
     * `ValidFlags.VALID` of `validFlags` is set.
     */
    offset: types.Vector3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Antenna offset correction uncertainty (0x82,0x31).
 *
 * Standard deviation of the estimated error of the GNSS antenna offset.
 *
 * Not listed in any device profile. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Antenna offset correction uncertainty (0x82,0x31)
 */
export declare class AntennaOffsetCorrectionUncertainty extends Data {
    constructor(values: Values<AntennaOffsetCorrectionUncertainty>);
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: m. Frame: vehicle. Range: at least 0. Valid if
     * `ValidFlags.VALID` of `validFlags` is set.
     */
    offsetUncertainty: types.Vector3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Clock correction (0x82,0x32).
 *
 * Estimated clock error of one GNSS receiver.
 *
 * Not listed in any device profile. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Clock correction (0x82,0x32)
 */
export declare class ClockCorrection extends Data {
    constructor(values: Values<ClockCorrection>);
    /** Receiver, counted from 1. Range: at least 1. */
    receiverId: number;
    /** Bias of the clock. Unit: s. Valid if `ValidFlags.VALID` of `validFlags` is set. */
    bias: number;
    /** Drift of the clock. Unit: s/s. Valid if `ValidFlags.VALID` of `validFlags` is set. */
    biasDrift: number;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Clock correction uncertainty (0x82,0x33).
 *
 * Standard deviation of the estimated clock error of one GNSS receiver.
 *
 * Not listed in any device profile. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Clock correction uncertainty (0x82,0x33)
 */
export declare class ClockCorrectionUncertainty extends Data {
    constructor(values: Values<ClockCorrectionUncertainty>);
    /** Receiver, counted from 1. Range: at least 1. */
    receiverId: number;
    /**
     * Standard deviation of the bias. Unit: s. Range: at least 0. Valid if `ValidFlags.VALID` of `validFlags` is set.
     */
    biasUncertainty: number;
    /**
     * Standard deviation of the drift. Unit: s/s. Range: at least 0. Valid if `ValidFlags.VALID` of `validFlags` is
     * set.
     */
    biasDriftUncertainty: number;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Multi-antenna offset correction (0x82,0x34).
 *
 * Estimated error of one GNSS antenna's offset.
 *
 * Supported by 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS. Requires a receiver.
 *
 * The filter adds it to the stored offset.
 *
 * - 3dm-cv7-gnss-ins: Multi Antenna Offset Correction (0x82,0x34)
 */
export declare class MultiAntennaOffsetCorrection extends Data {
    constructor(values: Values<MultiAntennaOffsetCorrection>);
    /** Receiver that the antenna belongs to. */
    receiverId: number;
    /**
     * Estimated correction of the configured antenna offset. Elements: x, y, z. Unit: m. Frame: vehicle. Valid if
     * `ValidFlags.VALID` of `validFlags` is set.
     */
    offset: types.Vector3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Multi-antenna offset correction uncertainty (0x82,0x35).
 *
 * Standard deviation of the estimated error of one GNSS antenna's offset.
 *
 * Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 1 more. Requires a receiver.
 *
 * - 3dm-cv7-gnss-ins: Multi Antenna Offset Correction Uncertainty (0x82,0x35)
 */
export declare class MultiAntennaOffsetCorrectionUncertainty extends Data {
    constructor(values: Values<MultiAntennaOffsetCorrectionUncertainty>);
    /** Receiver that the antenna belongs to. */
    receiverId: number;
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: m. Frame: vehicle. Range: at least 0. Valid if
     * `ValidFlags.VALID` of `validFlags` is set.
     */
    offsetUncertainty: types.Vector3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * ECEF position uncertainty (0x82,0x36).
 *
 * Standard deviation of the estimated position in Earth-fixed coordinates.
 *
 * Also called `ecef_pos_uncertainty`. Confirmed on 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed on 3 more.
 *
 * - 3dm-cv7-gnss-ins: ECEF Position Uncertainty (0x82,0x36)
 */
export declare class EcefPositionUncertainty extends Data {
    constructor(values: Values<EcefPositionUncertainty>);
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: m. Frame: ecef. Range: at least 0. Valid if
     * `ValidFlags.VALID` of `validFlags` is set.
     */
    positionUncertainty: types.Vector3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * ECEF velocity uncertainty (0x82,0x37).
 *
 * Standard deviation of the estimated velocity in Earth-fixed coordinates.
 *
 * Also called `ecef_vel_uncertainty`. Confirmed on 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed on 3 more.
 *
 * - 3dm-cv7-gnss-ins: ECEF Velocity Uncertainty (0x82,0x37)
 */
export declare class EcefVelocityUncertainty extends Data {
    constructor(values: Values<EcefVelocityUncertainty>);
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: m/s. Frame: ecef. Range: at least 0. Valid if
     * `ValidFlags.VALID` of `validFlags` is set.
     */
    velocityUncertainty: types.Vector3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * ECEF position (0x82,0x40).
 *
 * Estimated position in Earth-fixed coordinates.
 *
 * Also called `ecef_pos`. Confirmed on 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed on 3 more.
 *
 * - 3dm-cv7-gnss-ins: ECEF Position (0x82,0x40)
 */
export declare class EcefPosition extends Data {
    constructor(values: Values<EcefPosition>);
    /**
     * Position of the reference point. Elements: x, y, z. Unit: m. Frame: ecef. Valid if `ValidFlags.VALID` of
     * `validFlags` is set.
     */
    position: types.Vector3d;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * ECEF velocity (0x82,0x41).
 *
 * Estimated velocity in Earth-fixed coordinates.
 *
 * Also called `ecef_vel`. Confirmed on 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed on 3 more.
 *
 * - 3dm-cv7-gnss-ins: ECEF Velocity (0x82,0x41)
 */
export declare class EcefVelocity extends Data {
    constructor(values: Values<EcefVelocity>);
    /**
     * Velocity of the reference point. Elements: x, y, z. Unit: m/s. Frame: ecef. At rest and level: x 0, y 0, z 0.
     * Valid if `ValidFlags.VALID` of `validFlags` is set.
     */
    velocity: types.Vector3f;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * NED relative position (0x82,0x42).
 *
 * Estimated position relative to the point that `filter.RelativePositionConfig` sets.
 *
 * Also called `rel_pos_ned`. Confirmed on 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed on 3 more.
 *
 * - 3dm-cv7-gnss-ins: NED Relative Position (0x82,0x42)
 */
export declare class NedRelativePosition extends Data {
    constructor(values: Values<NedRelativePosition>);
    /**
     * From the reference point to the device. Elements: north, east, down. Unit: m. Frame: ned. Valid if
     * `ValidFlags.VALID` of `validFlags` is set.
     */
    relativePosition: types.Ned3d;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * GNSS position aiding status (0x82,0x43).
 *
 * Use of the position measurements of one GNSS receiver by the filter.
 *
 * Also called `gnss_pos_aid_status`. Confirmed on 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed on 3 more.
 *
 * Single precision resolves the time of week to 0.0625 s at the end of the week.
 *
 * - 3dm-cv7-gnss-ins: GNSS Position Aiding Status (0x82,0x43)
 */
export declare class GnssPositionAidingStatus extends Data {
    constructor(values: Values<GnssPositionAidingStatus, "reserved">);
    /** Number of the receiver. */
    receiverId: number;
    /** GPS time of week of the last measurement. Unit: s. Range: 0 to 604800. */
    tow: number;
    /** State of the measurements in the filter. */
    status: GnssAidingStatus;
    /** Reserved. */
    reserved: number[];
}

/**
 * GNSS attitude aiding status (0x82,0x44).
 *
 * State of the attitude aiding by two GNSS antennas.
 *
 * Also called `gnss_att_aid_status`. Not listed in any device profile. Known only from the MicroStrain MIP SDK.
 *
 * Single precision resolves the time of week to 0.0625 s at the end of the week.
 *
 * - mip-sdk-4: Gnss Att Aid Status (0x82,0x44)
 */
export declare class GnssAttitudeAidingStatus extends Data {
    constructor(values: Values<GnssAttitudeAidingStatus, "reserved">);
    /**
     * GPS time of week of the last valid measurement. Unit: s. Range: 0 to 604800. Uncertain: It is not known whether
     * this is the time of the measurement or that of its processing.
     */
    tow: number;
    /** State of the measurements in the filter. */
    status: GnssAidingStatus;
    /** Reserved. Reserved. */
    reserved: number[];
}

/**
 * Heading aiding status (0x82,0x45).
 *
 * The heading measurement that the filter used last.
 *
 * Also called `head_aid_status`. Not listed in any device profile. Known only from the MicroStrain MIP SDK.
 *
 * Single precision resolves the time of week to 0.0625 s at the end of the week.
 *
 * - mip-sdk-4: Head Aid Status (0x82,0x45)
 */
export declare class HeadingAidingStatus extends Data {
    constructor(values: Values<HeadingAidingStatus, "reserved">);
    /**
     * GPS time of week of the last valid measurement. Unit: s. Range: 0 to 604800. Uncertain: It is not known whether
     * this is the time of the measurement or that of its processing.
     */
    tow: number;
    /** Source of the heading. */
    type: HeadingAidingType;
    /** Reserved. Reserved. */
    reserved: [number, number];
}

/**
 * Aiding measurement summary (0x82,0x46).
 *
 * Use of one kind of aiding measurement in the last measurement interval.
 *
 * Confirmed on 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed on 3 more.
 *
 * Single precision resolves the time of week to 0.0625 s at the end of the week.
 *
 * - 3dm-cv7-gnss-ins: Aiding Measurement Summary (0x82,0x46)
 */
export declare class AidingMeasurementSummary extends Data {
    constructor(values: Values<AidingMeasurementSummary>);
    /** GPS time of week at the end of the interval. Unit: s. Range: 0 to 604800. */
    tow: number;
    /** Number of the source of the measurement. */
    source: number;
    /** Kind of measurement. */
    type: AidingMeasurementType;
    /** Use of the measurement by the filter. */
    indicator: AidingMeasurementIndicator;
}

/**
 * Odometer scale factor error (0x82,0x47).
 *
 * Estimated relative error of the odometer scale factor.
 *
 * Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 1 more.
 *
 * Estimated scale factor = configured scale factor * (1 + error).
 *
 * - 3dm-cv7-gnss-ins: Odometer Scale Factor Error (0x82,0x47)
 */
export declare class OdometerScaleFactorError extends Data {
    constructor(values: Values<OdometerScaleFactorError>);
    /** Relative error. Unit: 1. Valid if `ValidFlags.VALID` of `validFlags` is set. */
    scaleFactorError: number;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Odometer scale factor error uncertainty (0x82,0x48).
 *
 * Uncertainty of the estimated error of the odometer scale factor.
 *
 * Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 1 more.
 *
 * - 3dm-cv7-gnss-ins: Odometer Scale Factor Error Uncertainty (0x82,0x48)
 */
export declare class OdometerScaleFactorErrorUncertainty extends Data {
    constructor(values: Values<OdometerScaleFactorErrorUncertainty>);
    /**
     * Uncertainty of the relative error. Unit: 1. Range: at least 0. Valid if `ValidFlags.VALID` of `validFlags` is
     * set.
     */
    scaleFactorErrorUncertainty: number;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * GNSS dual antenna status (0x82,0x49).
 *
 * Heading from two GNSS antennas.
 *
 * Supported by 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS. Requires 2 antennas.
 *
 * It is a measurement that aids the filter. The heading of `EulerAngles` is the estimate of the filter from all
 * measurements. Single precision resolves the time of week to 0.0625 s at the end of the week.
 *
 * - 3dm-cv7-gnss-ins: GNSS Dual Antenna Status (0x82,0x49)
 */
export declare class GnssDualAntennaStatus extends Data {
    constructor(values: Values<GnssDualAntennaStatus>);
    /**
     * GPS time of week of the last measurement. Unit: s. Range: 0 to 604800. Valid if `ValidFlags.VALID` of
     * `validFlags` is set.
     */
    tow: number;
    /**
     * Heading derived from the baseline of the antennas. Unit: rad. Frame: ned. Positive: clockwise seen from above.
     * Valid if `ValidFlags.VALID` of `validFlags` is set.
     */
    heading: number;
    /**
     * Standard deviation of the heading. Unit: rad. Range: at least 0. Valid if `ValidFlags.VALID` of `validFlags` is
     * set.
     */
    headingUncertainty: number;
    /** Kind of solution. */
    fixType: DualAntennaFixType;
    /** Inputs available to the solution. */
    statusFlags: DualAntennaStatusFlags;
    /** Validity of the values of a field. */
    validFlags: ValidFlags;
}

/**
 * Aiding frame configuration error (0x82,0x50).
 *
 * Estimated error of a frame that `aiding.FrameConfig` defines. The filter corrects for it.
 *
 * Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS and 3DM-CV7-INS; likely or assumed on 2 more.
 *
 * - 3dm-cv7-gnss-ins: Aiding Frame Configuration Error (0x82,0x50)
 */
export declare class AidingFrameConfigError extends Data {
    constructor(values: Values<AidingFrameConfigError>);
    /** Number of the frame. */
    frameId: number;
    /** Estimated error of the translation. Elements: x, y, z. Unit: m. */
    translation: types.Vector3f;
    /** Estimated error of the rotation. Elements: w, x, y, z. Unit: 1. */
    attitude: types.Quatf;
}

/**
 * Aiding frame configuration error uncertainty (0x82,0x51).
 *
 * Uncertainty of the error in `AidingFrameConfigError`.
 *
 * Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 3 more.
 *
 * - 3dm-cv7-gnss-ins: Aiding Frame Configuration Error Uncertainty (0x82,0x51)
 */
export declare class AidingFrameConfigErrorUncertainty extends Data {
    constructor(values: Values<AidingFrameConfigErrorUncertainty>);
    /** Number of the frame. */
    frameId: number;
    /** Standard deviation of the error of the translation. Elements: x, y, z. Unit: m. Range: at least 0. */
    translationUncertainty: types.Vector3f;
    /** Uncertainty of the rotation about each axis. Elements: x, y, z. Unit: rad. Range: at least 0. */
    attitudeUncertainty: types.Vector3f;
}
