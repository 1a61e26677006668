/**
 * Filter commands (0x0D).
 *
 * Commands that set up, start and aid the navigation filter.
 *
 * - 3dm-gx5-15: 4.3 Estimation Filter Commands
 * - 3dm-cv7-gnss-ins: Filter (0x0D)
 */
import type { Bitfield, Command, Data, Enumeration, Flavor, Response, Values } from "./mip/index.mjs";
import type { FunctionSelector } from "./protocol.mjs";
import type * as types from "./types.mjs";

export type DynamicsMode = Flavor<number, "filter.dynamics_mode">;
/**
 * Motion that the filter expects, depending on the kind of vehicle. Uncertain: The SDK lists only the names of the
 * modes, from which the descriptions are inferred. Uncertain: `filter_data.Status` reports a mode too, but is known to
 * have the values 1 to 3 only.
 *
 * - mip-sdk-4: Vehicle Dynamics Mode (0x0D,0x10)
 */
export declare const DynamicsMode: Enumeration<DynamicsMode> & {
    /** Carried by hand. */
    readonly PORTABLE: DynamicsMode & 1;
    /** Ground vehicle. */
    readonly AUTOMOTIVE: DynamicsMode & 2;
    /** Aircraft. */
    readonly AIRBORNE: DynamicsMode & 3;
    /** Aircraft under high acceleration. */
    readonly AIRBORNE_HIGH_G: DynamicsMode & 4;
};

export type EstimatedStates = Flavor<number, "filter.estimated_states">;
/**
 * States that the filter estimates.
 *
 * - 3dm-gx5-15: 4.3.5 Estimation Control Flags (0x0D, 0x14)
 * - mip-sdk-4: Estimation Control (0x0D,0x14)
 */
export declare const EstimatedStates: Bitfield<EstimatedStates> & {
    /** Estimate the gyroscope bias (recommended). Bit 0. */
    readonly GYRO_BIAS: EstimatedStates;
    /** Estimate the accelerometer bias. Bit 1. */
    readonly ACCEL_BIAS: EstimatedStates;
    /** Estimate the scale factor of the gyroscope. Bit 2. */
    readonly GYRO_SCALE_FACTOR: EstimatedStates;
    /** Estimate the scale factor of the accelerometer. Bit 3. */
    readonly ACCEL_SCALE_FACTOR: EstimatedStates;
    /** Estimate the offset of the GNSS antenna. Bit 4. */
    readonly ANTENNA_OFFSET: EstimatedStates;
    /** Estimate the hard iron offset of the magnetometer. Bit 5. Requires a magnetometer. */
    readonly AUTO_HARD_IRON: EstimatedStates;
    /** Estimate the soft iron matrix of the magnetometer. Bit 6. Requires a magnetometer. */
    readonly AUTO_SOFT_IRON: EstimatedStates;
};

export type GnssAidingSource = Flavor<number, "filter.gnss_aiding_source">;
/** Source of the GNSS data that aids the filter. */
export declare const GnssAidingSource: Enumeration<GnssAidingSource> & {
    /** All internal receivers. Requires a receiver. */
    readonly ALL_INTERNAL: GnssAidingSource & 1;
    /** GNSS measurements that your program sends. */
    readonly EXTERNAL: GnssAidingSource & 2;
    /** Internal receiver 1 only. Requires a receiver. */
    readonly INTERNAL_1: GnssAidingSource & 3;
    /** Internal receiver 2 only. Requires 2 receivers. */
    readonly INTERNAL_2: GnssAidingSource & 4;
};

export type HeadingType = Flavor<number, "filter.heading_type">;
/** The north that a heading refers to. */
export declare const HeadingType: Enumeration<HeadingType> & {
    /** True north. */
    readonly TRUE_HEADING: HeadingType & 1;
    /** Magnetic north. */
    readonly MAGNETIC_HEADING: HeadingType & 2;
};

export type HeadingUpdateSource = Flavor<number, "filter.heading_update_source">;
/**
 * Source of the heading updates that aid the filter.
 *
 * - 3dm-gx5-15: 4.3.6 Heading Update Control (0x0D, 0x18)
 * - 3dm-gx5-45: (0x0D, 0x18)
 * - mip-sdk-4: Heading Source (0x0D,0x18)
 */
export declare const HeadingUpdateSource: Enumeration<HeadingUpdateSource> & {
    /** No heading updates. */
    readonly NONE: HeadingUpdateSource & 0;
    /** The device's own magnetometer. Requires a magnetometer. */
    readonly MAG: HeadingUpdateSource & 1;
    /** The velocity that the GNSS receiver measures. Requires a receiver. */
    readonly GNSS_VELOCITY: HeadingUpdateSource & 2;
    /** The heading messages that your program sends. */
    readonly EXTERNAL: HeadingUpdateSource & 3;
    /** The course over ground and the magnetometer. Requires a receiver and a magnetometer. */
    readonly GNSS_VELOCITY_AND_MAG: HeadingUpdateSource & 4;
    /** GNSS velocity and your program's heading messages. Requires a receiver. */
    readonly GNSS_VELOCITY_AND_EXTERNAL: HeadingUpdateSource & 5;
    /** Magnetometer and your program's heading messages. Requires a magnetometer. */
    readonly MAG_AND_EXTERNAL: HeadingUpdateSource & 6;
    /** GNSS, magnetometer and external heading. Requires a receiver and a magnetometer. */
    readonly ALL: HeadingUpdateSource & 7;
};

export type TareAxes = Flavor<number, "filter.tare_axes">;
/** Axes to tare; 0 resets all axes. */
export declare const TareAxes: Bitfield<TareAxes> & {
    /** The present roll becomes zero. Bit 0. */
    readonly ROLL: TareAxes;
    /** The present pitch becomes zero. Bit 1. */
    readonly PITCH: TareAxes;
    /** The present yaw becomes zero. Bit 2. */
    readonly YAW: TareAxes;
};

export type MeasurementFlags = Flavor<number, "filter.measurement_flags">;
/** Measurements that the filter uses. */
export declare const MeasurementFlags: Bitfield<MeasurementFlags> & {
    /** Accelerometer measurements. Bit 0. */
    readonly ACCEL: MeasurementFlags;
    /** Magnetometer measurements. Bit 1. Requires a magnetometer. */
    readonly MAG: MeasurementFlags;
};

export type MagParameterSource = Flavor<number, "filter.mag_parameter_source">;
/** Source of the declination, the inclination or the magnitude of the magnetic field. */
export declare const MagParameterSource: Enumeration<MagParameterSource> & {
    /** No source. Uncertain: No source states what the device does without a declination. */
    readonly NONE: MagParameterSource & 1;
    /** The World Magnetic Model, at the estimated position. */
    readonly WMM: MagParameterSource & 2;
    /** The value specified by the command. */
    readonly MANUAL: MagParameterSource & 3;
};

export type AdaptiveMeasurementSelector = Flavor<number, "filter.adaptive_measurement_selector">;
/** Weighting of measurements whose magnitude is not as expected. */
export declare const AdaptiveMeasurementSelector: Enumeration<AdaptiveMeasurementSelector> & {
    /** No adaptation. */
    readonly DISABLED: AdaptiveMeasurementSelector & 0;
    /** The limits in the command determine the weights. */
    readonly FIXED: AdaptiveMeasurementSelector & 1;
    /** The filter determines the weights; the limits are ignored. 3DM-GX5 and later. */
    readonly AUTO: AdaptiveMeasurementSelector & 2;
};

export type AltitudeAidingSource = Flavor<number, "filter.altitude_aiding_source">;
/**
 * Source that aids the altitude.
 *
 * - mip-sdk-4: Altitude Aiding (0x0D,0x47)
 */
export declare const AltitudeAidingSource: Enumeration<AltitudeAidingSource> & {
    /** No aiding. */
    readonly NONE: AltitudeAidingSource & 0;
    /** The pressure sensor. Requires a pressure sensor. */
    readonly PRESSURE: AltitudeAidingSource & 1;
};

export type PitchRollAidingSource = Flavor<number, "filter.pitch_roll_aiding_source">;
/** Source that aids pitch and roll. */
export declare const PitchRollAidingSource: Enumeration<PitchRollAidingSource> & {
    /** No aiding. */
    readonly NONE: PitchRollAidingSource & 0;
    /** The measured gravity vector. */
    readonly GRAVITY_VECTOR: PitchRollAidingSource & 1;
};

export type AidingSource = Flavor<number, "filter.aiding_source">;
/** A source of aiding measurements. */
export declare const AidingSource: Enumeration<AidingSource> & {
    /** Position and velocity of the GNSS receivers. */
    readonly GNSS_POSITION_VELOCITY: AidingSource & 0;
    /** GNSS heading from two antennas. Requires 2 antennas. */
    readonly GNSS_HEADING: AidingSource & 1;
    /** Built-in pressure altimeter. Requires a pressure sensor. */
    readonly ALTIMETER: AidingSource & 2;
    /** Speed sensor or odometer. */
    readonly SPEED: AidingSource & 3;
    /** Built-in magnetometer. Requires a magnetometer. */
    readonly MAG: AidingSource & 4;
    /** Heading that your program sends. */
    readonly EXTERNAL_HEADING: AidingSource & 5;
    /** Pressure altitude that your program sends. */
    readonly EXTERNAL_ALTIMETER: AidingSource & 6;
    /** Magnetic field that your program sends. */
    readonly EXTERNAL_MAG: AidingSource & 7;
    /** Velocity in the body (vehicle) frame that your program sends. */
    readonly BODY_FRAME_VELOCITY: AidingSource & 8;
    /** All sources, for save, load and default. */
    readonly ALL: AidingSource & 65535;
};

export type AccelConstraint = Flavor<number, "filter.accel_constraint">;
/**
 * Assumption of the filter about the acceleration.
 *
 * - mip-sdk-4: Kinematic Constraint (0x0D,0x51)
 */
export declare const AccelConstraint: Enumeration<AccelConstraint> & {
    /** No assumption. */
    readonly NONE: AccelConstraint & 0;
    /** The filter assumes no acceleration. */
    readonly ZERO_ACCEL: AccelConstraint & 1;
};

export type VelocityConstraint = Flavor<number, "filter.velocity_constraint">;
/**
 * Assumption of the filter about the velocity.
 *
 * - mip-sdk-4: Kinematic Constraint (0x0D,0x51)
 */
export declare const VelocityConstraint: Enumeration<VelocityConstraint> & {
    /** No assumption. */
    readonly NONE: VelocityConstraint & 0;
    /** The filter assumes that the device does not move. */
    readonly ZERO_VELOCITY: VelocityConstraint & 1;
    /** The filter assumes the motion of a wheeled vehicle. */
    readonly WHEELED_VEHICLE: VelocityConstraint & 2;
};

export type AngularConstraint = Flavor<number, "filter.angular_constraint">;
/**
 * Assumption of the filter about the angular rate.
 *
 * - mip-sdk-4: Kinematic Constraint (0x0D,0x51)
 */
export declare const AngularConstraint: Enumeration<AngularConstraint> & {
    /** No assumption. */
    readonly NONE: AngularConstraint & 0;
    /** The filter assumes no rotation. */
    readonly ZERO_ANGULAR_RATE: AngularConstraint & 1;
};

export type InitialConditionSource = Flavor<number, "filter.initial_condition_source">;
/** Initial conditions that your program provides instead of the device. */
export declare const InitialConditionSource: Enumeration<InitialConditionSource> & {
    /** Position, velocity and attitude are automatic. */
    readonly AUTO_POSITION_VELOCITY_ATTITUDE: InitialConditionSource & 0;
    /** Position, velocity, pitch and roll are automatic; your program provides the heading. */
    readonly AUTO_POSITION_VELOCITY_PITCH_ROLL: InitialConditionSource & 1;
    /** Position and velocity are automatic; your program provides the attitude. */
    readonly AUTO_POSITION_VELOCITY: InitialConditionSource & 2;
    /** Your program provides position, velocity and attitude. */
    readonly MANUAL: InitialConditionSource & 3;
};

export type HeadingAlignment = Flavor<number, "filter.heading_alignment">;
/** Methods that the device may use to determine its initial heading. */
export declare const HeadingAlignment: Bitfield<HeadingAlignment> & {
    /** From the baseline between two GNSS antennas. Bit 0. Requires 2 antennas. */
    readonly DUAL_ANTENNA: HeadingAlignment;
    /** From the GNSS velocity; assumes motion along the positive x axis of the vehicle. Bit 1. */
    readonly KINEMATIC: HeadingAlignment;
    /** From the built-in magnetometer. Bit 2. Requires a magnetometer. */
    readonly MAG: HeadingAlignment;
    /** From the heading that your program sends. Bit 3. */
    readonly EXTERNAL: HeadingAlignment;
};

export type ReferenceFrame = Flavor<number, "filter.reference_frame">;
/** Frame of a position. */
export declare const ReferenceFrame: Enumeration<ReferenceFrame> & {
    /** Earth-centred, Earth-fixed coordinates (WGS84). */
    readonly ECEF: ReferenceFrame & 1;
    /** Latitude, longitude and height above the ellipsoid (WGS84). */
    readonly LLH: ReferenceFrame & 2;
};

export type AdaptiveLevel = Flavor<number, "filter.adaptive_level">;
/** Strength of the adaptation to inconsistent measurements. */
export declare const AdaptiveLevel: Enumeration<AdaptiveLevel> & {
    /** No adaptation. */
    readonly OFF: AdaptiveLevel & 0;
    /** Little adaptation. */
    readonly CONSERVATIVE: AdaptiveLevel & 1;
    /** Moderate adaptation. */
    readonly MODERATE: AdaptiveLevel & 2;
    /** Strong adaptation. */
    readonly AGGRESSIVE: AdaptiveLevel & 3;
};

export type RelativePositionSource = Flavor<number, "filter.relative_position_source">;
/** Source of the reference point for relative positions. */
export declare const RelativePositionSource: Enumeration<RelativePositionSource> & {
    /** The base station of the RTK corrections. */
    readonly AUTO: RelativePositionSource & 0;
    /** The coordinates specified by the command. */
    readonly MANUAL: RelativePositionSource & 1;
};

export type ReferencePoint = Flavor<number, "filter.reference_point">;
/** Point that a lever arm moves. */
export declare const ReferencePoint: Enumeration<ReferencePoint> & {
    /** The origin of the vehicle. */
    readonly VEHICLE: ReferencePoint & 1;
};

/**
 * Vehicle dynamics mode response (0x0D,0x80).
 *
 * Response to `VehicleDynamicsMode`. Confirmed on 3DM-GX5-45; likely or assumed on 6 more. Known only from the
 * MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Vehicle dynamics mode (0x0D,0x10)
 */
export declare class VehicleDynamicsModeResponse extends Response {
    constructor(values: Values<VehicleDynamicsModeResponse>);
    /** Kind of vehicle. */
    mode: DynamicsMode;
}

/**
 * Sensor to vehicle frame transformation response (0x0D,0x81).
 *
 * Response to `SensorToVehicleRotationEuler`. Confirmed on 3DM-GX5-15 and 3DM-GX5-45; likely or assumed on 12 more.
 *
 * - 3dm-gx5-15: 4.3.4 Sensor to Vehicle Frame Transformation (0x0D, 0x11)
 */
export declare class SensorToVehicleRotationEulerResponse extends Response {
    constructor(values: Values<SensorToVehicleRotationEulerResponse>);
    /** Roll angle of the vehicle relative to the sensor. Unit: rad. Frame: sensor. Positive: right side down. */
    roll: number;
    /** Pitch angle of the vehicle relative to the sensor. Unit: rad. Frame: sensor. Positive: nose up. */
    pitch: number;
    /**
     * Yaw angle of the vehicle relative to the sensor. Unit: rad. Frame: sensor. Positive: clockwise seen from above.
     */
    yaw: number;
}

/**
 * Sensor to vehicle offset response (0x0D,0x82).
 *
 * Response to `SensorToVehicleOffset`. Confirmed on 3DM-GX5-45; likely or assumed on 6 more. Known only from the
 * MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Sensor to vehicle offset (0x0D,0x12)
 */
export declare class SensorToVehicleOffsetResponse extends Response {
    constructor(values: Values<SensorToVehicleOffsetResponse>);
    /**
     * Vector from the sensor to the origin of the vehicle frame. Elements: x, y, z. Unit: m. Frame: sensor. Range:
     * magnitude at most 10.
     */
    offset: types.Vector3f;
}

/**
 * GNSS antenna offset response (0x0D,0x83).
 *
 * Response to `AntennaOffset`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-CV7-INS and 3DM-GX5-45; likely or assumed on 8 more.
 *
 * - 3dm-cv7-gnss-ins: GNSS Antenna Offset Control (0x0D,0x13)
 */
export declare class AntennaOffsetResponse extends Response {
    constructor(values: Values<AntennaOffsetResponse>);
    /**
     * Vector from the sensor origin to the phase centre of the antenna. Elements: x, y, z. Unit: m. Frame: vehicle.
     * Range: magnitude at most 10.
     *
     * - On the 3DM-CX5-45: frame sensor (inferred: the manual of the 3DM-GX5-45 states it).
     * - On the 3DM-GX5-45: frame sensor.
     */
    offset: types.Vector3f;
}

/**
 * Estimation control flags response (0x0D,0x84).
 *
 * Response to `EstimationControl`. Confirmed on 3DM-GX5-15 and 3DM-GX5-45; likely or assumed on 13 more.
 *
 * - 3dm-gx5-15: 4.3.5 Estimation Control Flags (0x0D, 0x14)
 */
export declare class EstimationControlResponse extends Response {
    constructor(values: Values<EstimationControlResponse>);
    /** States to estimate. */
    flags: EstimatedStates;
}

/**
 * GNSS aiding source response (0x0D,0x86).
 *
 * Response to `GnssSource`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS and 3DM-GX5-45; likely or assumed on 9
 * more.
 *
 * - 3dm-cv7-gnss-ins: GNSS Aiding Source Control (0x0D,0x15)
 */
export declare class GnssSourceResponse extends Response {
    constructor(values: Values<GnssSourceResponse>);
    /** Source of the GNSS data. */
    source: GnssAidingSource;
}

/**
 * Heading update control response (0x0D,0x87).
 *
 * Response to `HeadingSource`. Confirmed on 3DM-GX5-15 and 3DM-GX5-45; likely or assumed on 12 more.
 *
 * - 3dm-gx5-15: 4.3.6 Heading Update Control (0x0D, 0x18)
 */
export declare class HeadingSourceResponse extends Response {
    constructor(values: Values<HeadingSourceResponse>);
    /** Source of the heading. */
    source: HeadingUpdateSource;
}

/**
 * Automatic initialization response (0x0D,0x88).
 *
 * Also called `auto_init_control_response`. Response to `AutoInitializationControl`. Confirmed on 3DM-GX5-15 and
 * 3DM-GX5-45; likely or assumed on 13 more.
 *
 * - 3dm-gx5-15: 4.3.10 Auto-Initialization Control (0x0D, 0x19)
 */
export declare class AutoInitializationControlResponse extends Response {
    constructor(values: Values<AutoInitializationControlResponse>);
    /** 0 disables, 1 enables. Range: 0 to 1. */
    enable: number;
}

/**
 * Accelerometer noise response (0x0D,0x89).
 *
 * Response to `AccelNoise`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-45; likely or assumed on 23 more.
 *
 * - 3dm-cv7-gnss-ins: Accelerometer Noise Standard Deviation (0x0D,0x1A)
 * - 3dm-gx5-15: 4.3.12 Accelerometer Noise Standard Deviation (0x0D, 0x1A)
 */
export declare class AccelNoiseResponse extends Response {
    constructor(values: Values<AccelNoiseResponse>);
    /** Standard deviation per axis. Elements: x, y, z. Unit: m/s^2. Range: greater than 0. */
    noise: types.Vector3f;
}

/**
 * Gyroscope noise response (0x0D,0x8A).
 *
 * Response to `GyroNoise`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-45; likely or assumed on 23 more.
 *
 * - 3dm-cv7-gnss-ins: Gyroscope Noise Standard Deviation (0x0D,0x1B)
 * - 3dm-gx5-15: 4.3.13 Gyroscope Noise Standard Deviation (0x0D, 0x1B)
 */
export declare class GyroNoiseResponse extends Response {
    constructor(values: Values<GyroNoiseResponse>);
    /** Standard deviation per axis. Elements: x, y, z. Unit: rad/s. Range: greater than 0. */
    noise: types.Vector3f;
}

/**
 * Accelerometer bias model response (0x0D,0x8B).
 *
 * Response to `AccelBiasModel`. Confirmed on 3DM-CV7-GNSS/INS and 3DM-GX5-45; likely or assumed on 9 more.
 *
 * - 3dm-cv7-gnss-ins: Accelerometer Bias Model Parameters (0x0D,0x1C)
 */
export declare class AccelBiasModelResponse extends Response {
    constructor(values: Values<AccelBiasModelResponse>);
    /** Reciprocal of the correlation time per axis. Elements: x, y, z. Unit: 1/s. */
    beta: types.Vector3f;
    /** Standard deviation of the noise per axis. Elements: x, y, z. Unit: m/s^2. Range: greater than 0. */
    noise: types.Vector3f;
}

/**
 * Gyroscope bias model response (0x0D,0x8C).
 *
 * Response to `GyroBiasModel`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-45; likely or assumed on 23 more.
 *
 * - 3dm-cv7-gnss-ins: Gyroscope Bias Model Parameters (0x0D,0x1D)
 * - 3dm-gx5-15: 4.3.14 Gyroscope Bias Model Parameters (0x0D, 0x1D)
 */
export declare class GyroBiasModelResponse extends Response {
    constructor(values: Values<GyroBiasModelResponse>);
    /** Reciprocal of the correlation time per axis. Elements: x, y, z. Unit: 1/s. */
    beta: types.Vector3f;
    /** Standard deviation of the noise per axis. Elements: x, y, z. Unit: rad/s. Range: greater than 0. */
    noise: types.Vector3f;
}

/**
 * Automatic zero velocity update response (0x0D,0x8D).
 *
 * Response to `AutoZupt`. Confirmed on 3DM-GQ7-GNSS/INS and 3DM-GX5-45; likely or assumed on 6 more. Known only from
 * the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Auto Zupt (0x0D,0x1E)
 */
export declare class AutoZuptResponse extends Response {
    constructor(values: Values<AutoZuptResponse>);
    /** 0 disables, 1 enables. Range: 0 to 1. */
    enable: number;
    /** Highest speed that is treated as zero. Unit: m/s. Range: at least 0. */
    threshold: number;
}

/**
 * Zero angular rate update response (0x0D,0x8E).
 *
 * Response to `AutoAngularZupt`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-CV7-INS, 3DM-CX5-25, 3DM-GQ7-GNSS/INS, 3DM-GX5-15
 * and 3DM-GX5-45; likely or assumed on 19 more.
 *
 * - 3dm-cv7-gnss-ins: Zero Angular Rate Update Control (0x0D,0x20)
 * - 3dm-gx5-15: 4.3.15 Zero Angular Rate Update Control (0x0D, 0x20)
 */
export declare class AutoAngularZuptResponse extends Response {
    constructor(values: Values<AutoAngularZuptResponse>);
    /** 0 disables, 1 enables. Range: 0 to 1. */
    enable: number;
    /** Highest angular rate that is treated as zero. Unit: rad/s. Range: at least 0. */
    threshold: number;
}

/**
 * Set reference position response (0x0D,0x90).
 *
 * Response to `ReferencePosition`. Confirmed on 3DM-GX5-15; likely or assumed on 8 more.
 *
 * - 3dm-gx5-15: 4.3.20 Set Reference Position (0x0D, 0x26)
 */
export declare class ReferencePositionResponse extends Response {
    constructor(values: Values<ReferencePositionResponse>);
    /** 0 disables, 1 enables. Range: 0 to 1. */
    enable: number;
    /** Geodetic latitude. Unit: deg. Frame: llh. Range: -90 to 90. Positive: north. */
    latitude: number;
    /** Geodetic longitude. Unit: deg. Frame: llh. Range: -180 to 180. Positive: east. */
    longitude: number;
    /**
     * Altitude of the reference position. Unit: m. Uncertain: The reference, ellipsoid or sea level, is inferred. The
     * manual does not state it; its glossary counts altitudes from sea level.
     */
    altitude: number;
}

/**
 * Gravity noise response (0x0D,0x93).
 *
 * Response to `GravityNoise`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-45; likely or assumed on 16 more.
 *
 * - 3dm-cv7-gnss-ins: Gravity Noise Standard Deviation (0x0D,0x28)
 * - 3dm-gx5-15: 4.3.11 Gravity Noise Standard Deviation (0x0D, 0x28)
 */
export declare class GravityNoiseResponse extends Response {
    constructor(values: Values<GravityNoiseResponse>);
    /** Standard deviation per axis. Elements: x, y, z. Unit: g. Range: greater than 0. */
    noise: types.Vector3f;
}

/**
 * Pressure altitude noise response (0x0D,0x94).
 *
 * Response to `PressureAltitudeNoise`. Confirmed on 3DM-GX5-45; likely or assumed on 4 more. Known only from the
 * MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Pressure altitude noise (0x0D,0x29)
 */
export declare class PressureAltitudeNoiseResponse extends Response {
    constructor(values: Values<PressureAltitudeNoiseResponse>);
    /** Standard deviation of the pressure altitude noise. Unit: m. Range: greater than 0. */
    noise: number;
}

/**
 * Hard iron offset noise response (0x0D,0x96).
 *
 * Response to `HardIronOffsetNoise`. Confirmed on 3DM-GX5-45; likely or assumed on 4 more. Known only from the
 * MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Hard iron offset noise (0x0D,0x2B)
 */
export declare class HardIronOffsetNoiseResponse extends Response {
    constructor(values: Values<HardIronOffsetNoiseResponse>);
    /** Standard deviation per axis. Elements: x, y, z. Unit: gauss. Range: greater than 0. */
    noise: types.Vector3f;
}

/**
 * Soft iron matrix noise response (0x0D,0x97).
 *
 * Response to `SoftIronMatrixNoise`. Confirmed on 3DM-GX5-45; likely or assumed on 4 more. Known only from the
 * MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Soft iron matrix noise (0x0D,0x2C)
 */
export declare class SoftIronMatrixNoiseResponse extends Response {
    constructor(values: Values<SoftIronMatrixNoiseResponse>);
    /**
     * Standard deviation per element. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit: 1. Range: greater
     * than 0.
     */
    noise: types.Matrix3f;
}

/**
 * Tare orientation response (0x0D,0xA1).
 *
 * Response to `TareOrientation`. Confirmed on 3DM-CX5-25; likely or assumed on 11 more. Uncertain: The SDK reads the
 * setting back; the manuals of the 3DM-GX5-15 and 3DM-GX5-45 have neither the read function nor the response.
 *
 * - 3dm-gx5-15: 4.3.16 Tare Orientation (0x0D, 0x21)
 * - mip-sdk-4: Tare orientation (0x0D,0x21)
 */
export declare class TareOrientationResponse extends Response {
    constructor(values: Values<TareOrientationResponse>);
    /** Axes that are tared. */
    axes: TareAxes;
}

/**
 * Enable or disable measurements response (0x0D,0xB0).
 *
 * Response to `EnableMeasurements`. Confirmed on 3DM-GX5-15; likely or assumed on 6 more.
 *
 * - 3dm-gx5-15: 4.3.18 Enable/Disable Measurements (0x0D, 0x41)
 */
export declare class EnableMeasurementsResponse extends Response {
    constructor(values: Values<EnableMeasurementsResponse>);
    /** Measurements to use. */
    control: MeasurementFlags;
}

/**
 * Magnetometer noise response (0x0D,0xB1).
 *
 * Response to `MagNoise`. Confirmed on 3DM-GX5-45; likely or assumed on 9 more. Known only from the MicroStrain MIP
 * SDK.
 *
 * - mip-sdk-4: Mag Noise (0x0D,0x42)
 */
export declare class MagNoiseResponse extends Response {
    constructor(values: Values<MagNoiseResponse>);
    /** Standard deviation per axis. Elements: x, y, z. Unit: gauss. Range: greater than 0. */
    noise: types.Vector3f;
}

/**
 * Magnetic declination source response (0x0D,0xB2).
 *
 * Response to `MagneticDeclinationSource`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS and
 * 3DM-GX5-45; likely or assumed on 14 more.
 *
 * - 3dm-cv7-gnss-ins: Magnetic Field Declination Source Control (0x0D,0x43)
 * - 3dm-gq7: Magnetic Field Declination Source Control (0x0D,0x43)
 */
export declare class MagneticDeclinationSourceResponse extends Response {
    constructor(values: Values<MagneticDeclinationSourceResponse>);
    /** Source of the declination. */
    source: MagParameterSource;
    /**
     * Angle from true north to magnetic north; used only if `source` is manual. Unit: rad. Frame: ned. Range: -pi to
     * pi. Positive: magnetic north is east of true north. Uncertain: The sign is the usual one; no source states it.
     * Uncertain: The manuals, that of the 3DM-GQ7 included, require it only if `source` is manual, but state one
     * length, with the value. Always send it.
     */
    declination: number;
}

/**
 * Gravity magnitude error adaptive measurement response (0x0D,0xB3).
 *
 * Response to `AccelMagnitudeErrorAdaptiveMeasurement`. Confirmed on 3DM-GX5-15 and 3DM-GX5-45; likely or assumed on 13
 * more.
 *
 * - 3dm-gx5-15: 4.3.19 Gravity Magnitude Error Adaptive Measurement (0x0D, 0x44)
 */
export declare class AccelMagnitudeErrorAdaptiveMeasurementResponse extends Response {
    constructor(values: Values<AccelMagnitudeErrorAdaptiveMeasurementResponse>);
    /** Kind of adaptation. */
    adaptiveMeasurement: AdaptiveMeasurementSelector;
    /** Cutoff frequency of the low-pass filter. Unit: Hz. Range: at least 0. */
    frequency: number;
    /** Lower limit of the gravity magnitude error. Unit: m/s^2. */
    lowLimit: number;
    /** Upper limit of the gravity magnitude error. Unit: m/s^2. */
    highLimit: number;
    /** Standard deviation at the lower limit. Unit: m/s^2. Range: at least 0. */
    lowLimitUncertainty: number;
    /** Standard deviation at the upper limit. Unit: m/s^2. Range: at least 0. */
    highLimitUncertainty: number;
    /** Smallest standard deviation. Unit: m/s^2. Range: at least 0. */
    minimumUncertainty: number;
}

/**
 * Magnetometer magnitude error adaptive measurement response (0x0D,0xB4).
 *
 * Response to `MagMagnitudeErrorAdaptiveMeasurement`. Confirmed on 3DM-GX5-45; likely or assumed on 10 more. Known only
 * from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Mag Magnitude Error Adaptive Measurement (0x0D,0x45)
 */
export declare class MagMagnitudeErrorAdaptiveMeasurementResponse extends Response {
    constructor(values: Values<MagMagnitudeErrorAdaptiveMeasurementResponse>);
    /** Kind of adaptation. */
    adaptiveMeasurement: AdaptiveMeasurementSelector;
    /** Cutoff frequency of the low-pass filter. Unit: Hz. Range: at least 0. */
    frequency: number;
    /**
     * Lower limit of the magnetic field magnitude error. Unit: gauss. Uncertain: The unit gauss is inferred: the SDK
     * states m/s^2, the manual of the 3DM-GX5-45 m/s^2 in the command and gauss in the response.
     */
    lowLimit: number;
    /**
     * Upper limit of the magnetic field magnitude error. Unit: gauss. Uncertain: The unit gauss is inferred: the SDK
     * states m/s^2, the manual of the 3DM-GX5-45 m/s^2 in the command and gauss in the response.
     */
    highLimit: number;
    /**
     * Standard deviation at the lower limit. Unit: gauss. Range: at least 0. Uncertain: The unit gauss is inferred: the
     * SDK states m/s^2, the manual of the 3DM-GX5-45 m/s^2 in the command and gauss in the response.
     */
    lowLimitUncertainty: number;
    /**
     * Standard deviation at the upper limit. Unit: gauss. Range: at least 0. Uncertain: The unit gauss is inferred: the
     * SDK states m/s^2, the manual of the 3DM-GX5-45 m/s^2 in the command and gauss in the response.
     */
    highLimitUncertainty: number;
    /**
     * Smallest standard deviation. Unit: gauss. Range: at least 0. Uncertain: The unit gauss is inferred: the SDK
     * states m/s^2, the manual of the 3DM-GX5-45 m/s^2 in the command and gauss in the response.
     */
    minimumUncertainty: number;
}

/**
 * Magnetometer dip angle error adaptive measurement response (0x0D,0xB5).
 *
 * Response to `MagDipAngleErrorAdaptiveMeasurement`. Confirmed on 3DM-GX5-45; likely or assumed on 9 more. Known only
 * from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Mag Dip Angle Error Adaptive Measurement (0x0D,0x46)
 */
export declare class MagDipAngleErrorAdaptiveMeasurementResponse extends Response {
    constructor(values: Values<MagDipAngleErrorAdaptiveMeasurementResponse>);
    /** True if the adaptation is on. */
    enable: boolean;
    /** Cutoff frequency of the low-pass filter. Unit: Hz. Range: at least 0. */
    frequency: number;
    /**
     * Upper limit of the dip angle error. Unit: rad. Range: at least 0. Uncertain: The unit rad is inferred from the
     * quantity; the SDK states m/s^2.
     */
    highLimit: number;
    /**
     * Standard deviation at the upper limit. Unit: rad. Range: at least 0. Uncertain: The unit rad is inferred from the
     * quantity; the SDK states m/s^2.
     */
    highLimitUncertainty: number;
    /**
     * Smallest standard deviation. Unit: rad. Range: at least 0. Uncertain: The unit rad is inferred from the quantity;
     * the SDK states m/s^2.
     */
    minimumUncertainty: number;
}

/**
 * Altitude aiding response (0x0D,0xB7).
 *
 * Response to `AltitudeAiding`. Confirmed on 3DM-GX5-45; likely or assumed on 4 more. Known only from the MicroStrain
 * MIP SDK.
 *
 * - mip-sdk-4: Altitude aiding (0x0D,0x47)
 */
export declare class AltitudeAidingResponse extends Response {
    constructor(values: Values<AltitudeAidingResponse>);
    /** Source of the aiding. */
    selector: AltitudeAidingSource;
}

/**
 * Pitch and roll aiding response (0x0D,0xBB).
 *
 * Response to `PitchRollAiding`. Confirmed on 3DM-GX5-15 and 3DM-GX5-45; likely or assumed on 6 more.
 *
 * - 3dm-gx5-15: 4.3.9 Pitch/Roll Aiding Control (0x0D, 0x4B)
 */
export declare class PitchRollAidingResponse extends Response {
    constructor(values: Values<PitchRollAidingResponse>);
    /** Source of the aiding. */
    aiding: PitchRollAidingSource;
}

/**
 * Magnetic inclination source response (0x0D,0xBC).
 *
 * Also called `inclination_source_response`. Response to `MagneticInclinationSource`. Known only from the MicroStrain
 * MIP SDK.
 *
 * - mip-sdk-4: Inclination Source (0x0D,0x4C)
 */
export declare class MagneticInclinationSourceResponse extends Response {
    constructor(values: Values<MagneticInclinationSourceResponse>);
    /** Source of the inclination. */
    source: MagParameterSource;
    /**
     * Angle of the field below the horizontal plane; used only if `source` is manual. Unit: rad. Frame: ned. Range:
     * -1.5707963267948966 to 1.5707963267948966. Positive: the field points down. Uncertain: The sign is the usual one;
     * no source states it. Uncertain: It can possibly be omitted if `source` is not manual, as with
     * `MagneticDeclinationSource`. The SDK always sends it.
     */
    inclination: number;
}

/**
 * Magnetic field magnitude source response (0x0D,0xBD).
 *
 * Also called `mag_field_magnitude_source_response`. Response to `MagneticMagnitudeSource`. Known only from the
 * MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Mag Field Magnitude Source (0x0D,0x4D)
 */
export declare class MagneticMagnitudeSourceResponse extends Response {
    constructor(values: Values<MagneticMagnitudeSourceResponse>);
    /** Source of the magnitude. */
    source: MagParameterSource;
    /**
     * Magnitude; used only if `source` is manual. Unit: gauss. Range: at least 0. Uncertain: It can possibly be omitted
     * if `source` is not manual, as with `MagneticDeclinationSource`. The SDK always sends it.
     */
    magnitude: number;
}

/**
 * Sensor to vehicle rotation, matrix response (0x0D,0xBE).
 *
 * Response to `SensorToVehicleRotationDcm`. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Sensor To Vehicle Rotation Dcm (0x0D,0x4E)
 */
export declare class SensorToVehicleRotationDcmResponse extends Response {
    constructor(values: Values<SensorToVehicleRotationDcmResponse>);
    /**
     * Rotates vectors of the vehicle frame into the sensor frame; row-major. Elements: m11, m12, m13, m21, m22, m23,
     * m31, m32, m33. Unit: 1.
     */
    dcm: types.Matrix3f;
}

/**
 * Sensor to vehicle rotation, quaternion response (0x0D,0xBF).
 *
 * Response to `SensorToVehicleRotationQuaternion`. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Sensor To Vehicle Rotation Quaternion (0x0D,0x4F)
 */
export declare class SensorToVehicleRotationQuaternionResponse extends Response {
    constructor(values: Values<SensorToVehicleRotationQuaternionResponse>);
    /**
     * Rotates vectors of the sensor frame into the vehicle frame; unit quaternion, w first. Elements: w, x, y, z. Unit:
     * 1. Range: magnitude 0.999 to 1.001.
     */
    q: types.Quatf;
}

/**
 * Aiding measurement control response (0x0D,0xD0).
 *
 * Response to `AidingMeasurementEnable`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed
 * on 8 more.
 *
 * - 3dm-cv7-gnss-ins: Aiding Measurement Control (0x0D,0x50)
 */
export declare class AidingMeasurementEnableResponse extends Response {
    constructor(values: Values<AidingMeasurementEnableResponse>);
    /** Aiding source that the setting is for. */
    aidingSource: AidingSource;
    /** True if the filter uses the source. */
    enable: boolean;
}

/**
 * Kinematic constraint response (0x0D,0xD1).
 *
 * Response to `KinematicConstraint`. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Kinematic constraint (0x0D,0x51)
 */
export declare class KinematicConstraintResponse extends Response {
    constructor(values: Values<KinematicConstraintResponse>);
    /** Assumption about the acceleration. Default: `AccelConstraint.NONE`. */
    accelConstraint: AccelConstraint;
    /** Assumption about the velocity. Default: `VelocityConstraint.NONE`. */
    velocityConstraint: VelocityConstraint;
    /** Assumption about the angular rate. Default: `AngularConstraint.NONE`. */
    angularConstraint: AngularConstraint;
}

/**
 * Navigation filter initialization response (0x0D,0xD2).
 *
 * Also called `initialization_configuration_response`. Response to `InitializationConfig`. Confirmed on
 * 3DM-CV7-GNSS/INS, 3DM-CV7-INS and 3DM-GQ7-GNSS/INS; likely or assumed on 2 more.
 *
 * - 3dm-cv7-gnss-ins: Navigation Filter Initialization (0x0D,0x52)
 */
export declare class InitializationConfigResponse extends Response {
    constructor(values: Values<InitializationConfigResponse>);
    /** 1: the filter starts only after `Run`; 0: it starts as soon as it can. Range: 0 to 1. */
    waitForRunCommand: number;
    /** Initial conditions that your program provides instead of the device. */
    initialConditionSource: InitialConditionSource;
    /** Methods that may be used to determine the initial heading. */
    autoHeadingAlignmentSelector: HeadingAlignment;
    /** Initial heading relative to true north. Unit: deg. Frame: ned. Positive: clockwise seen from above. */
    initialHeading: number;
    /** Initial pitch angle. Unit: deg. Frame: ned. Positive: nose up. */
    initialPitch: number;
    /** Initial roll angle. Unit: deg. Frame: ned. Positive: right side down. */
    initialRoll: number;
    /**
     * Initial position that your program provides. Elements: x, y, z.
     *
     * - If `referenceFrameSelector` is `ReferenceFrame.ECEF`: unit m; frame ecef.
     * - If `referenceFrameSelector` is `ReferenceFrame.LLH`: elements latitude, longitude, height; unit deg, deg, m;
     *   frame llh.
     */
    initialPosition: types.Vector3f;
    /**
     * Initial velocity that your program provides. Elements: x, y, z. Unit: m/s.
     *
     * - If `referenceFrameSelector` is `ReferenceFrame.ECEF`: frame ecef.
     * - If `referenceFrameSelector` is `ReferenceFrame.LLH`: elements north, east, down; frame ned.
     */
    initialVelocity: types.Vector3f;
    /** Frame of the initial position and velocity. */
    referenceFrameSelector: ReferenceFrame;
}

/**
 * Adaptive filter control response (0x0D,0xD3).
 *
 * Response to `AdaptiveFilterOptions`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 12 more.
 *
 * - 3dm-cv7-gnss-ins: Adaptive Filter Control (0x0D,0x53)
 */
export declare class AdaptiveFilterOptionsResponse extends Response {
    constructor(values: Values<AdaptiveFilterOptionsResponse>);
    /** Strength of the adaptation. Default: 2. */
    level: AdaptiveLevel;
    /** Longest time for which measurements are rejected before the filter recovers. Unit: ms. */
    timeLimit: number;
}

/**
 * GNSS multi-antenna offset response (0x0D,0xD4).
 *
 * Response to `MultiAntennaOffset`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 1 more.
 *
 * - 3dm-cv7-gnss-ins: GNSS Multi-Antenna Offset Control (0x0D,0x54)
 */
export declare class MultiAntennaOffsetResponse extends Response {
    constructor(values: Values<MultiAntennaOffsetResponse>);
    /** Number of the receiver, from 1. Range: at least 1. */
    receiverId: number;
    /**
     * Lever arm from the sensor to the antenna. Elements: x, y, z. Unit: m. Frame: vehicle. Range: magnitude at most
     * 10.
     */
    antennaOffset: types.Vector3f;
}

/**
 * Relative position configuration response (0x0D,0xD5).
 *
 * Also called `rel_pos_configuration_response`. Response to `RelativePositionConfig`. Confirmed on 3DM-CV7-GNSS/INS;
 * likely or assumed on 4 more.
 *
 * - 3dm-cv7-gnss-ins: Relative Position Configuration (0x0D,0x55)
 */
export declare class RelativePositionConfigResponse extends Response {
    constructor(values: Values<RelativePositionConfigResponse>);
    /** Source of the reference point. */
    source: RelativePositionSource;
    /** Frame of the coordinates. */
    referenceFrameSelector: ReferenceFrame;
    /**
     * Reference point. Elements: x, y, z.
     *
     * - If `referenceFrameSelector` is `ReferenceFrame.ECEF`: unit m; frame ecef.
     * - If `referenceFrameSelector` is `ReferenceFrame.LLH`: elements latitude, longitude, height; unit deg, deg, m;
     *   frame llh.
     */
    referenceCoordinates: types.Vector3d;
}

/**
 * Reference point lever arm response (0x0D,0xD6).
 *
 * Also called `ref_point_lever_arm_response`. Response to `ReferencePointLeverArm`. Confirmed on 3DM-CV7-GNSS/INS;
 * likely or assumed on 4 more.
 *
 * - 3dm-cv7-gnss-ins: Reference point lever arm (0x0D,0x56)
 */
export declare class ReferencePointLeverArmResponse extends Response {
    constructor(values: Values<ReferencePointLeverArmResponse>);
    /** Point to which the lever arm leads. */
    referencePoint: ReferencePoint;
    /**
     * Lever arm from the sensor to the point. Elements: x, y, z. Unit: m. Frame: vehicle. Range: magnitude at most 10.
     */
    leverArmOffset: types.Vector3f;
}

/**
 * Speed measurement lever arm response (0x0D,0xE1).
 *
 * Response to `SpeedLeverArm`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 1 more.
 *
 * - 3dm-cv7-gnss-ins: Measurement speed lever arm (0x0D,0x61)
 */
export declare class SpeedLeverArmResponse extends Response {
    constructor(values: Values<SpeedLeverArmResponse, "source">);
    /** Reserved. */
    source: number;
    /** Lever arm from the sensor to the point of measurement. Elements: x, y, z. Unit: m. Frame: vehicle. */
    leverArmOffset: types.Vector3f;
}

/**
 * Vertical gyro constraint response (0x0D,0xE2).
 *
 * Response to `VerticalGyroConstraintControl`. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Vertical Gyro Constraint Control (0x0D,0x62)
 */
export declare class VerticalGyroConstraintControlResponse extends Response {
    constructor(values: Values<VerticalGyroConstraintControlResponse>);
    /** 0 disables, 1 enables. Range: 0 to 1. */
    enable: number;
}

/**
 * Wheeled vehicle constraint response (0x0D,0xE3).
 *
 * Response to `WheeledVehicleConstraintControl`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 1 more.
 *
 * - 3dm-cv7-gnss-ins: Wheeled Vehicle Constraint Control (0x0D,0x63)
 */
export declare class WheeledVehicleConstraintControlResponse extends Response {
    constructor(values: Values<WheeledVehicleConstraintControlResponse>);
    /** 0 disables, 1 enables. Range: 0 to 1. */
    enable: number;
}

/**
 * GNSS antenna offset calibration response (0x0D,0xE4).
 *
 * Also called `gnss_antenna_cal_control_response`. Response to `GnssAntennaCalibrationControl`. Supported by
 * 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: GNSS Antenna Offset Calibration Control (0x0D,0x64)
 * - 3dm-cv7-gnss-ins: Antenna Lever Arm Calibration
 */
export declare class GnssAntennaCalibrationControlResponse extends Response {
    constructor(values: Values<GnssAntennaCalibrationControlResponse>);
    /** 0 disables, 1 enables. Range: 0 to 1. */
    enable: number;
    /** Largest absolute error that is tracked. Unit: m. Frame: vehicle. Range: at least 0. */
    maxOffset: number;
}

/**
 * Reset navigation filter (0x0D,0x01).
 *
 * Returns the filter to its initialization state.
 *
 * Affects filter_data (0x82). Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GX5-15, 3DM-RQ1-45-LT and
 * 3DM-RQ1-45-ST; likely or assumed on 20 more.
 *
 * If automatic initialization is off, the attitude or heading must be set before the filter runs again. 3DM-CV7: send
 * it after a large jump of the system time, for example when the PPS is first detected.
 *
 * - 3dm-cv7-gnss-ins: Reset Navigation Filter (0x0D,0x01)
 * - 3dm-gx5-15: 4.3.1 Reset Filter (0x0D, 0x01)
 */
export declare class Reset extends Command<undefined> {
    constructor();
}

/**
 * Set initial attitude (0x0D,0x02).
 *
 * Sets the initial attitude of the filter: the orientation of the sensor frame in the NED frame.
 *
 * Affects `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm` and `filter_data.EulerAngles`. Confirmed on
 * 3DM-GX5-15, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 12 more.
 *
 * Accepted only in the initialization state.
 *
 * - 3dm-gx5-15: 4.3.2 Set Initial Attitude (0x0D, 0x02)
 */
export declare class SetInitialAttitude extends Command<undefined> {
    constructor(values: Values<SetInitialAttitude>);
    /** Roll angle. Unit: rad. Frame: ned. Range: -pi to pi. Positive: right side down. */
    roll: number;
    /** Pitch angle. Unit: rad. Frame: ned. Range: -1.5707963267948966 to 1.5707963267948966. Positive: nose up. */
    pitch: number;
    /** Heading (yaw) angle. Unit: rad. Frame: ned. Range: -pi to pi. Positive: clockwise seen from above. */
    heading: number;
}

/**
 * Set initial heading (0x0D,0x03).
 *
 * Sets the initial heading of the filter. Pitch and roll come from the accelerometers.
 *
 * Affects `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm` and `filter_data.EulerAngles`. Confirmed on
 * 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GX5-15, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or
 * assumed on 19 more.
 *
 * 3DM-GX5: accepted only in the initialization state. 3DM-CV7: resets the estimated heading; if magnetometer aiding is
 * on, the value of this command is ignored.
 *
 * - 3dm-cv7-gnss-ins: Set Initial Heading Control (0x0D,0x03)
 * - 3dm-gx5-15: 4.3.3 Set Initial Heading (0x0D, 0x03)
 */
export declare class SetInitialHeading extends Command<undefined> {
    constructor(values: Values<SetInitialHeading>);
    /** Initial heading. Unit: rad. Frame: ned. Range: -pi to pi. Positive: clockwise seen from above. */
    heading: number;
}

/**
 * Set initial attitude from IMU (0x0D,0x04).
 *
 * Initializes the filter's attitude from the complementary filter.
 *
 * No device is known for certain to support it. Also called `set_initial_heading_from_mag`. Affects
 * `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm` and `filter_data.EulerAngles`. Known only from the MIP
 * SDK of 2014, MicroStrain Communication Library and MicroStrain MIP SDK. Uncertain: The SDK calls it set initial
 * heading from mag, without a layout; the SDK of 2014 has this layout in its example for the 3DM-GX3-45. Uncertain: No
 * source lists the devices that support it.
 *
 * - mip-sdk-4: Set Initial Heading From Mag (0x0D,0x04)
 * - mip-sdk-2014: Set Initial Attitude From AHRS (0x0D,0x04)
 * - mscl: Set Initial Attitude From AHRS (0x0D,0x04)
 */
export declare class SetInitialAttitudeFromImu extends Command<undefined> {
    constructor(values: Values<SetInitialAttitudeFromImu>);
    /**
     * Angle from true north to magnetic north. Unit: rad. Frame: ned. Range: -pi to pi. Positive: magnetic north is
     * east of true north. Uncertain: The sign is the usual one; no source states it.
     */
    declination: number;
}

/**
 * Run navigation filter (0x0D,0x05).
 *
 * Starts a filter that is configured to wait for this command.
 *
 * Affects `filter_data.Status`. Confirmed on 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed on 3 more.
 *
 * The filter waits in its initialization state if `wait_for_run_command` of `InitializationConfig` is set.
 *
 * - 3dm-cv7-gnss-ins: Run Navigation Filter (0x0D,0x05)
 */
export declare class Run extends Command<undefined> {
    constructor();
}

/**
 * Vehicle dynamics mode (0x0D,0x10).
 *
 * Adapts the filter to the expected motion.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `VehicleDynamicsModeResponse`. Probably affects
 * filter_data (0x82). Confirmed on 3DM-GX5-45; likely or assumed on 6 more. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Vehicle dynamics mode (0x0D,0x10)
 */
export declare class VehicleDynamicsMode<R extends Response | undefined = undefined | VehicleDynamicsModeResponse> extends Command<R> {
    constructor(values: Values<VehicleDynamicsMode>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Kind of vehicle. Required for `write`.
     *
     * - On the 3DM-GX3-45: only `DynamicsMode.PORTABLE`, `DynamicsMode.AUTOMOTIVE` and `DynamicsMode.AIRBORNE`.
     */
    mode?: DynamicsMode;
    /** Apply the new setting. */
    static write(values: { mode: DynamicsMode }): VehicleDynamicsMode<undefined>;
    /** Return the current setting in a response. */
    static read(): VehicleDynamicsMode<VehicleDynamicsModeResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): VehicleDynamicsMode<undefined>;
    /** Load the saved setting. */
    static load(): VehicleDynamicsMode<undefined>;
    /** Load the factory default setting. */
    static default(): VehicleDynamicsMode<undefined>;
}

/**
 * Sensor to vehicle frame transformation (0x0D,0x11).
 *
 * Sets the rotation from the sensor frame to the vehicle frame as Euler angles (5-series).
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `SensorToVehicleRotationEulerResponse`. Affects
 * `sensor.ScaledAccel`, `sensor.ScaledGyro`, `sensor.ScaledMag`, `sensor.DeltaTheta`, `sensor.DeltaVelocity`,
 * `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm`, `filter_data.EulerAngles`, `filter_data.LinearAccel`,
 * `filter_data.CompAngularRate`, `filter_data.GravityVector` and `filter_data.CompAccel`. Confirmed on 3DM-GX5-15 and
 * 3DM-GX5-45; likely or assumed on 12 more. Uncertain: The text of the manual lacks the formula; it is the inverse of
 * that of `3dm.SensorToVehicleTransformEuler`, which the 3DM-CV7 manual states.
 *
 * The 3DM-CV7 uses the inverse instead: `3dm.SensorToVehicleTransformEuler`. `v_sensor = Rz(yaw) * Ry(pitch) * Rx(roll)
 * * v_vehicle`
 *
 * - 3dm-gx5-15: 4.3.4 Sensor to Vehicle Frame Transformation (0x0D, 0x11)
 */
export declare class SensorToVehicleRotationEuler<R extends Response | undefined = undefined | SensorToVehicleRotationEulerResponse> extends Command<R> {
    constructor(values: Values<SensorToVehicleRotationEuler>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Roll angle of the vehicle relative to the sensor. Unit: rad. Frame: sensor. Positive: right side down. Required
     * for `write`.
     */
    roll?: number;
    /**
     * Pitch angle of the vehicle relative to the sensor. Unit: rad. Frame: sensor. Positive: nose up. Required for
     * `write`.
     */
    pitch?: number;
    /**
     * Yaw angle of the vehicle relative to the sensor. Unit: rad. Frame: sensor. Positive: clockwise seen from above.
     * Required for `write`.
     */
    yaw?: number;
    /** Apply the new setting. */
    static write(values: { roll: number; pitch: number; yaw: number }): SensorToVehicleRotationEuler<undefined>;
    /** Return the current setting in a response. */
    static read(): SensorToVehicleRotationEuler<SensorToVehicleRotationEulerResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): SensorToVehicleRotationEuler<undefined>;
    /** Load the saved setting. */
    static load(): SensorToVehicleRotationEuler<undefined>;
    /** Load the factory default setting. */
    static default(): SensorToVehicleRotationEuler<undefined>;
}

/**
 * Sensor to vehicle offset (0x0D,0x12).
 *
 * Sets the origin of the vehicle frame relative to the sensor.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `SensorToVehicleOffsetResponse`. Affects
 * `filter_data.LlhPosition`. Confirmed on 3DM-GX5-45; likely or assumed on 6 more. Known only from the MicroStrain MIP
 * SDK. Uncertain: The direction, from the sensor to the origin of the vehicle frame, is inferred from the name.
 *
 * The shift is constant. It does not follow the attitude, as a lever arm would.
 *
 * - mip-sdk-4: Sensor to vehicle offset (0x0D,0x12)
 */
export declare class SensorToVehicleOffset<R extends Response | undefined = undefined | SensorToVehicleOffsetResponse> extends Command<R> {
    constructor(values: Values<SensorToVehicleOffset>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Vector from the sensor to the origin of the vehicle frame. Elements: x, y, z. Unit: m. Frame: sensor. Range:
     * magnitude at most 10. Required for `write`.
     */
    offset?: types.Vector3f;
    /** Apply the new setting. */
    static write(values: { offset: types.Vector3f }): SensorToVehicleOffset<undefined>;
    /** Return the current setting in a response. */
    static read(): SensorToVehicleOffset<SensorToVehicleOffsetResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): SensorToVehicleOffset<undefined>;
    /** Load the saved setting. */
    static load(): SensorToVehicleOffset<undefined>;
    /** Load the factory default setting. */
    static default(): SensorToVehicleOffset<undefined>;
}

/**
 * GNSS antenna offset (0x0D,0x13).
 *
 * Sets the position of the GNSS antenna relative to the origin of the sensor.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `AntennaOffsetResponse`. Probably affects
 * `filter_data.LlhPosition`, `filter_data.EcefPosition`, `filter_data.NedVelocity`, `filter_data.EcefVelocity` and
 * `filter_data.AntennaOffsetCorrection`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-CV7-INS and 3DM-GX5-45; likely or assumed
 * on 8 more.
 *
 * 5-series devices expect the sensor frame. On the 3DM-CV7 it applies to GNSS data received as NMEA; data from the
 * aiding commands uses `aiding.FrameConfig`.
 *
 * - 3dm-cv7-gnss-ins: GNSS Antenna Offset Control (0x0D,0x13)
 */
export declare class AntennaOffset<R extends Response | undefined = undefined | AntennaOffsetResponse> extends Command<R> {
    constructor(values: Values<AntennaOffset>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Vector from the sensor origin to the phase centre of the antenna. Elements: x, y, z. Unit: m. Frame: vehicle.
     * Range: magnitude at most 10. Required for `write`.
     *
     * - On the 3DM-CX5-45: frame sensor (inferred: the manual of the 3DM-GX5-45 states it).
     * - On the 3DM-GX5-45: frame sensor.
     */
    offset?: types.Vector3f;
    /** Apply the new setting. */
    static write(values: { offset: types.Vector3f }): AntennaOffset<undefined>;
    /** Return the current setting in a response. */
    static read(): AntennaOffset<AntennaOffsetResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): AntennaOffset<undefined>;
    /** Load the saved setting. */
    static load(): AntennaOffset<undefined>;
    /** Load the factory default setting. */
    static default(): AntennaOffset<undefined>;
}

/**
 * Estimation control flags (0x0D,0x14).
 *
 * Selects the states that the filter estimates.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `EstimationControlResponse`. Affects
 * `filter_data.GyroBias`, `filter_data.AccelBias`, `filter_data.GyroScaleFactor`, `filter_data.AccelScaleFactor`,
 * `filter_data.AntennaOffsetCorrection`, `filter_data.MagOffset` and `filter_data.MagMatrix`. Probably affects
 * `filter_data.GyroBiasUncertainty`, `filter_data.AccelBiasUncertainty`, `filter_data.GyroScaleFactorUncertainty`,
 * `filter_data.AccelScaleFactorUncertainty`, `filter_data.AntennaOffsetCorrectionUncertainty`,
 * `filter_data.MagOffsetUncertainty` and `filter_data.MagMatrixUncertainty`. Confirmed on 3DM-GX5-15 and 3DM-GX5-45;
 * likely or assumed on 13 more.
 *
 * - 3dm-gx5-15: 4.3.5 Estimation Control Flags (0x0D, 0x14)
 */
export declare class EstimationControl<R extends Response | undefined = undefined | EstimationControlResponse> extends Command<R> {
    constructor(values: Values<EstimationControl>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * States to estimate. Required for `write`.
     *
     * - On the 3DM-CV5-15, 3DM-CX5-15, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25 and 3DM-GX5-15: only
     *   `EstimatedStates.GYRO_BIAS`.
     * - On the 3DM-CV5-25, 3DM-CX5-25 and 3DM-GX5-25: only `EstimatedStates.GYRO_BIAS`,
     *   `EstimatedStates.AUTO_HARD_IRON` and `EstimatedStates.AUTO_SOFT_IRON`.
     * - On the 3DM-GQ4-45, 3DM-GX4-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: only `EstimatedStates.GYRO_BIAS`,
     *   `EstimatedStates.ACCEL_BIAS`, `EstimatedStates.GYRO_SCALE_FACTOR`, `EstimatedStates.ACCEL_SCALE_FACTOR` and
     *   `EstimatedStates.ANTENNA_OFFSET`.
     */
    flags?: EstimatedStates;
    /** Apply the new setting. */
    static write(values: { flags: EstimatedStates }): EstimationControl<undefined>;
    /** Return the current setting in a response. */
    static read(): EstimationControl<EstimationControlResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): EstimationControl<undefined>;
    /** Load the saved setting. */
    static load(): EstimationControl<undefined>;
    /** Load the factory default setting. */
    static default(): EstimationControl<undefined>;
}

/**
 * GNSS aiding source (0x0D,0x15).
 *
 * Selects the GNSS receiver that aids the filter.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `GnssSourceResponse`. Probably affects
 * `filter_data.LlhPosition`, `filter_data.EcefPosition`, `filter_data.NedVelocity`, `filter_data.EcefVelocity` and
 * `filter_data.GnssPositionAidingStatus`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS and 3DM-GX5-45; likely or
 * assumed on 9 more.
 *
 * A change while the filter is running may return it to initialization until the new source provides data.
 *
 * - 3dm-cv7-gnss-ins: GNSS Aiding Source Control (0x0D,0x15)
 */
export declare class GnssSource<R extends Response | undefined = undefined | GnssSourceResponse> extends Command<R> {
    constructor(values: Values<GnssSource>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Source of the GNSS data. Required for `write`.
     *
     * - On the 3DM-CV7-INS, 3DM-CX7-INS and 3DM-GV7-INS: only `GnssAidingSource.EXTERNAL`.
     * - On the 3DM-CX5-45, 3DM-GQ4-45, 3DM-GX3-45, 3DM-GX4-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: only
     *   `GnssAidingSource.ALL_INTERNAL`, `GnssAidingSource.EXTERNAL` and `GnssAidingSource.INTERNAL_1`.
     * - On the 3DM-GX5-45: only `GnssAidingSource.ALL_INTERNAL` and `GnssAidingSource.EXTERNAL`.
     */
    source?: GnssAidingSource;
    /** Apply the new setting. */
    static write(values: { source: GnssAidingSource }): GnssSource<undefined>;
    /** Return the current setting in a response. */
    static read(): GnssSource<GnssSourceResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): GnssSource<undefined>;
    /** Load the saved setting. */
    static load(): GnssSource<undefined>;
    /** Load the factory default setting. */
    static default(): GnssSource<undefined>;
}

/**
 * External GNSS update (0x0D,0x16).
 *
 * Sends one position and velocity measurement from your own GNSS receiver to the filter.
 *
 * Confirmed on 3DM-GX5-45; likely or assumed on 5 more. Known only from the MicroStrain MIP SDK.
 *
 * The device rejects this command unless `GnssSource` selects the external source. The maximum rate depends on the
 * device.
 *
 * - mip-sdk-4: External GNSS update (0x0D,0x16)
 */
export declare class ExternalGnssUpdate extends Command<undefined> {
    constructor(values: Values<ExternalGnssUpdate>);
    /** GPS time of week. Unit: s. Range: at least 0, less than 604800. */
    tow: number;
    /** GPS week, counted without rollover. Unit: week. */
    weekNumber: number;
    /** Geodetic latitude. Unit: deg. Frame: llh. Range: -90 to 90. Positive: north. */
    latitude: number;
    /** Geodetic longitude. Unit: deg. Frame: llh. Range: -180 to 180. Positive: east. */
    longitude: number;
    /** Height above the ellipsoid. Unit: m. Frame: llh. */
    height: number;
    /** Velocity of the antenna. Elements: north, east, down. Unit: m/s. Frame: ned. */
    velocity: types.Ned3f;
    /** Standard deviation of the position. Elements: north, east, down. Unit: m. Frame: ned. Range: at least 0. */
    positionUncertainty: types.Ned3f;
    /** Standard deviation of the velocity. Elements: north, east, down. Unit: m/s. Frame: ned. Range: at least 0. */
    velocityUncertainty: types.Ned3f;
}

/**
 * External heading update (0x0D,0x17).
 *
 * Sends one measurement of the heading of the sensor frame in the NED frame to the filter.
 *
 * Confirmed on 3DM-CV7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-45; likely or assumed on 15 more.
 *
 * The device rejects this command unless external heading updates are enabled, by `HeadingSource` on the 3DM-GX5 and by
 * `AidingMeasurementEnable` on the 3DM-CV7. The 3DM-GX5-15 accepts at most 20 updates per second. If the declination
 * source is not valid, -25 models reject true headings and -45 models magnetic ones.
 *
 * - 3dm-cv7-gnss-ins: External Heading Update (0x0D,0x17)
 * - 3dm-gx5-15: 4.3.7 External Heading Update (0x0D, 0x17)
 */
export declare class ExternalHeadingUpdate extends Command<undefined> {
    constructor(values: Values<ExternalHeadingUpdate>);
    /**
     * Heading relative to the north selected by `type`. Unit: rad. Frame: ned. Range: -pi to pi. Positive: clockwise
     * seen from above.
     */
    heading: number;
    /** Standard deviation; the device rejects values out of range. Unit: rad. Range: greater than 0. */
    headingUncertainty: number;
    /** North that the heading refers to. */
    type: HeadingType;
}

/**
 * Heading update control (0x0D,0x18).
 *
 * Selects the source of the heading that aids the filter.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `HeadingSourceResponse`. Affects
 * `filter_data.HeadingUpdateState`. Probably affects `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm` and
 * `filter_data.EulerAngles`. Confirmed on 3DM-GX5-15 and 3DM-GX5-45; likely or assumed on 12 more.
 *
 * - 3dm-gx5-15: 4.3.6 Heading Update Control (0x0D, 0x18)
 */
export declare class HeadingSource<R extends Response | undefined = undefined | HeadingSourceResponse> extends Command<R> {
    constructor(values: Values<HeadingSource>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Source of the heading. Required for `write`.
     *
     * - On the 3DM-CV5-15, 3DM-CX5-15 and 3DM-GX5-15: only `HeadingUpdateSource.NONE` and
     *   `HeadingUpdateSource.EXTERNAL`.
     * - On the 3DM-CV5-25, 3DM-CX5-25, 3DM-GX4-25 and 3DM-GX5-25: only `HeadingUpdateSource.NONE`,
     *   `HeadingUpdateSource.MAG` and `HeadingUpdateSource.EXTERNAL`.
     * - On the 3DM-GQ4-45, 3DM-GX3-45 and 3DM-GX4-45: only `HeadingUpdateSource.NONE`, `HeadingUpdateSource.MAG`,
     *   `HeadingUpdateSource.GNSS_VELOCITY` and `HeadingUpdateSource.EXTERNAL`.
     * - On the 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: only `HeadingUpdateSource.NONE`, `HeadingUpdateSource.GNSS_VELOCITY`
     *   and `HeadingUpdateSource.EXTERNAL`.
     */
    source?: HeadingUpdateSource;
    /** Apply the new setting. */
    static write(values: { source: HeadingUpdateSource }): HeadingSource<undefined>;
    /** Return the current setting in a response. */
    static read(): HeadingSource<HeadingSourceResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): HeadingSource<undefined>;
    /** Load the saved setting. */
    static load(): HeadingSource<undefined>;
    /** Load the factory default setting. */
    static default(): HeadingSource<undefined>;
}

/**
 * Automatic initialization (0x0D,0x19).
 *
 * Sets whether the filter initializes automatically at power-up.
 *
 * Also called `auto_init_control`. Functions: `write`, `read`, `save`, `load` and `default`. Response:
 * `AutoInitializationControlResponse`. Confirmed on 3DM-GX5-15 and 3DM-GX5-45; likely or assumed on 13 more.
 *
 * Automatic initialization needs a valid heading source.
 *
 * - 3dm-gx5-15: 4.3.10 Auto-Initialization Control (0x0D, 0x19)
 */
export declare class AutoInitializationControl<R extends Response | undefined = undefined | AutoInitializationControlResponse> extends Command<R> {
    constructor(values: Values<AutoInitializationControl>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** 0 disables, 1 enables. Range: 0 to 1. Required for `write`. */
    enable?: number;
    /** Apply the new setting. */
    static write(values: { enable: number }): AutoInitializationControl<undefined>;
    /** Return the current setting in a response. */
    static read(): AutoInitializationControl<AutoInitializationControlResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): AutoInitializationControl<undefined>;
    /** Load the saved setting. */
    static load(): AutoInitializationControl<undefined>;
    /** Load the factory default setting. */
    static default(): AutoInitializationControl<undefined>;
}

/**
 * Accelerometer noise (0x0D,0x1A).
 *
 * Sets the standard deviation of the accelerometer noise that the filter assumes (process noise).
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `AccelNoiseResponse`. Probably affects
 * `filter_data.LlhPositionUncertainty`, `filter_data.EcefPositionUncertainty`, `filter_data.NedVelocityUncertainty`,
 * `filter_data.EcefVelocityUncertainty` and `filter_data.AccelBiasUncertainty`. Confirmed on 3DM-CV7-GNSS/INS,
 * 3DM-GX5-15 and 3DM-GX5-45; likely or assumed on 23 more.
 *
 * The factory values suit most laboratory conditions.
 *
 * - 3dm-cv7-gnss-ins: Accelerometer Noise Standard Deviation (0x0D,0x1A)
 * - 3dm-gx5-15: 4.3.12 Accelerometer Noise Standard Deviation (0x0D, 0x1A)
 */
export declare class AccelNoise<R extends Response | undefined = undefined | AccelNoiseResponse> extends Command<R> {
    constructor(values: Values<AccelNoise>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Standard deviation per axis. Elements: x, y, z. Unit: m/s^2. Range: greater than 0. Required for `write`. */
    noise?: types.Vector3f;
    /** Apply the new setting. */
    static write(values: { noise: types.Vector3f }): AccelNoise<undefined>;
    /** Return the current setting in a response. */
    static read(): AccelNoise<AccelNoiseResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): AccelNoise<undefined>;
    /** Load the saved setting. */
    static load(): AccelNoise<undefined>;
    /** Load the factory default setting. */
    static default(): AccelNoise<undefined>;
}

/**
 * Gyroscope noise (0x0D,0x1B).
 *
 * Sets the standard deviation of the gyroscope noise that the filter assumes (process noise).
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `GyroNoiseResponse`. Probably affects
 * `filter_data.EulerAnglesUncertainty`, `filter_data.QuaternionAttitudeUncertainty` and
 * `filter_data.GyroBiasUncertainty`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-45; likely or assumed on 23
 * more.
 *
 * The factory values suit most laboratory conditions.
 *
 * - 3dm-cv7-gnss-ins: Gyroscope Noise Standard Deviation (0x0D,0x1B)
 * - 3dm-gx5-15: 4.3.13 Gyroscope Noise Standard Deviation (0x0D, 0x1B)
 */
export declare class GyroNoise<R extends Response | undefined = undefined | GyroNoiseResponse> extends Command<R> {
    constructor(values: Values<GyroNoise>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Standard deviation per axis. Elements: x, y, z. Unit: rad/s. Range: greater than 0. Required for `write`. */
    noise?: types.Vector3f;
    /** Apply the new setting. */
    static write(values: { noise: types.Vector3f }): GyroNoise<undefined>;
    /** Return the current setting in a response. */
    static read(): GyroNoise<GyroNoiseResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): GyroNoise<undefined>;
    /** Load the saved setting. */
    static load(): GyroNoise<undefined>;
    /** Load the factory default setting. */
    static default(): GyroNoise<undefined>;
}

/**
 * Accelerometer bias model (0x0D,0x1C).
 *
 * Sets the parameters of the accelerometer bias drift model.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `AccelBiasModelResponse`. Probably affects
 * `filter_data.AccelBias` and `filter_data.AccelBiasUncertainty`. Confirmed on 3DM-CV7-GNSS/INS and 3DM-GX5-45; likely
 * or assumed on 9 more.
 *
 * - 3dm-cv7-gnss-ins: Accelerometer Bias Model Parameters (0x0D,0x1C)
 */
export declare class AccelBiasModel<R extends Response | undefined = undefined | AccelBiasModelResponse> extends Command<R> {
    constructor(values: Values<AccelBiasModel>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Reciprocal of the correlation time per axis. Elements: x, y, z. Unit: 1/s. Required for `write`. */
    beta?: types.Vector3f;
    /**
     * Standard deviation of the noise per axis. Elements: x, y, z. Unit: m/s^2. Range: greater than 0. Required for
     * `write`.
     */
    noise?: types.Vector3f;
    /** Apply the new setting. */
    static write(values: { beta: types.Vector3f; noise: types.Vector3f }): AccelBiasModel<undefined>;
    /** Return the current setting in a response. */
    static read(): AccelBiasModel<AccelBiasModelResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): AccelBiasModel<undefined>;
    /** Load the saved setting. */
    static load(): AccelBiasModel<undefined>;
    /** Load the factory default setting. */
    static default(): AccelBiasModel<undefined>;
}

/**
 * Gyroscope bias model (0x0D,0x1D).
 *
 * Sets the parameters of the gyroscope bias drift model.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `GyroBiasModelResponse`. Probably affects
 * `filter_data.GyroBias` and `filter_data.GyroBiasUncertainty`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-GX5-15 and
 * 3DM-GX5-45; likely or assumed on 23 more.
 *
 * - 3dm-cv7-gnss-ins: Gyroscope Bias Model Parameters (0x0D,0x1D)
 * - 3dm-gx5-15: 4.3.14 Gyroscope Bias Model Parameters (0x0D, 0x1D)
 */
export declare class GyroBiasModel<R extends Response | undefined = undefined | GyroBiasModelResponse> extends Command<R> {
    constructor(values: Values<GyroBiasModel>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Reciprocal of the correlation time per axis. Elements: x, y, z. Unit: 1/s. Required for `write`. */
    beta?: types.Vector3f;
    /**
     * Standard deviation of the noise per axis. Elements: x, y, z. Unit: rad/s. Range: greater than 0. Required for
     * `write`.
     */
    noise?: types.Vector3f;
    /** Apply the new setting. */
    static write(values: { beta: types.Vector3f; noise: types.Vector3f }): GyroBiasModel<undefined>;
    /** Return the current setting in a response. */
    static read(): GyroBiasModel<GyroBiasModelResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): GyroBiasModel<undefined>;
    /** Load the saved setting. */
    static load(): GyroBiasModel<undefined>;
    /** Load the factory default setting. */
    static default(): GyroBiasModel<undefined>;
}

/**
 * Automatic zero velocity update (0x0D,0x1E).
 *
 * Sets whether the filter assumes that the device is at rest while its GNSS speed is low.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `AutoZuptResponse`. Probably affects
 * `filter_data.NedVelocity`, `filter_data.EcefVelocity`, `filter_data.NedVelocityUncertainty` and
 * `filter_data.EcefVelocityUncertainty`. Confirmed on 3DM-GQ7-GNSS/INS and 3DM-GX5-45; likely or assumed on 6 more.
 * Known only from the MicroStrain MIP SDK.
 *
 * The update applies while the magnitude of the GNSS velocity vector is at or below the threshold.
 *
 * - mip-sdk-4: Auto Zupt (0x0D,0x1E)
 */
export declare class AutoZupt<R extends Response | undefined = undefined | AutoZuptResponse> extends Command<R> {
    constructor(values: Values<AutoZupt>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** 0 disables, 1 enables. Range: 0 to 1. Required for `write`. */
    enable?: number;
    /** Highest speed that is treated as zero. Unit: m/s. Range: at least 0. Required for `write`. */
    threshold?: number;
    /** Apply the new setting. */
    static write(values: { enable: number; threshold: number }): AutoZupt<undefined>;
    /** Return the current setting in a response. */
    static read(): AutoZupt<AutoZuptResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): AutoZupt<undefined>;
    /** Load the saved setting. */
    static load(): AutoZupt<undefined>;
    /** Load the factory default setting. */
    static default(): AutoZupt<undefined>;
}

/**
 * External heading update with time (0x0D,0x1F).
 *
 * Sends one measurement of the heading of the sensor frame with its GPS time to the filter.
 *
 * Confirmed on 3DM-CV7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-45; likely or assumed on 15 more.
 *
 * It is better than `ExternalHeadingUpdate` if the heading changes quickly; the time must be accurate. The device
 * rejects this command unless external heading updates are enabled, by `HeadingSource` on the 3DM-GX5 and by
 * `AidingMeasurementEnable` on the 3DM-CV7. The 3DM-GX5-15 accepts at most 20 updates per second. If the declination
 * source is not valid, -25 models reject true headings and -45 models magnetic ones.
 *
 * - 3dm-cv7-gnss-ins: External Heading Update With Time (0x0D,0x1F)
 * - 3dm-gx5-15: 4.3.8 External Heading Update with Timestamp (0x0D, 0x1F)
 */
export declare class ExternalHeadingUpdateWithTime extends Command<undefined> {
    constructor(values: Values<ExternalHeadingUpdateWithTime>);
    /** GPS time of week of the measurement. Unit: s. Range: at least 0, less than 604800. */
    tow: number;
    /** GPS week, counted without rollover. Unit: week. */
    weekNumber: number;
    /**
     * Heading relative to the north selected by `type`. Unit: rad. Frame: ned. Range: -pi to pi. Positive: clockwise
     * seen from above.
     */
    heading: number;
    /** Standard deviation; the device rejects values out of range. Unit: rad. Range: greater than 0. */
    headingUncertainty: number;
    /** North that the heading refers to. */
    type: HeadingType;
}

/**
 * Zero angular rate update (0x0D,0x20).
 *
 * Sets whether the filter assumes that the device is not rotating while its angular rate is low.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `AutoAngularZuptResponse`. Probably affects
 * `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm`, `filter_data.EulerAngles`, `filter_data.GyroBias` and
 * `filter_data.GyroBiasUncertainty`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-CV7-INS, 3DM-CX5-25, 3DM-GQ7-GNSS/INS,
 * 3DM-GX5-15 and 3DM-GX5-45; likely or assumed on 19 more.
 *
 * The update applies while the magnitude of the angular rate vector is at or below the threshold.
 *
 * - 3dm-cv7-gnss-ins: Zero Angular Rate Update Control (0x0D,0x20)
 * - 3dm-gx5-15: 4.3.15 Zero Angular Rate Update Control (0x0D, 0x20)
 */
export declare class AutoAngularZupt<R extends Response | undefined = undefined | AutoAngularZuptResponse> extends Command<R> {
    constructor(values: Values<AutoAngularZupt>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** 0 disables, 1 enables. Range: 0 to 1. Required for `write`. */
    enable?: number;
    /** Highest angular rate that is treated as zero. Unit: rad/s. Range: at least 0. Required for `write`. */
    threshold?: number;
    /** Apply the new setting. */
    static write(values: { enable: number; threshold: number }): AutoAngularZupt<undefined>;
    /** Return the current setting in a response. */
    static read(): AutoAngularZupt<AutoAngularZuptResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): AutoAngularZupt<undefined>;
    /** Load the saved setting. */
    static load(): AutoAngularZupt<undefined>;
    /** Load the factory default setting. */
    static default(): AutoAngularZupt<undefined>;
}

/**
 * Tare orientation (0x0D,0x21).
 *
 * Makes the present orientation in the NED frame the sensor-to-vehicle transformation.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `TareOrientationResponse`. Affects
 * `sensor.ScaledAccel`, `sensor.ScaledGyro`, `sensor.ScaledMag`, `sensor.DeltaTheta`, `sensor.DeltaVelocity`,
 * `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm`, `filter_data.EulerAngles`, `filter_data.LinearAccel`,
 * `filter_data.CompAngularRate`, `filter_data.GravityVector` and `filter_data.CompAccel`. Confirmed on 3DM-CX5-25,
 * 3DM-GX5-15 and 3DM-GX5-45; likely or assumed on 11 more. On the 3DM-GX5-15: `write`, `save`, `load` and `default`
 * only. On the 3DM-GX5-45: `write`, `save`, `load` and `default` only.
 *
 * The device rejects this command while the filter has no valid attitude.
 *
 * - 3dm-gx5-15: 4.3.16 Tare Orientation (0x0D, 0x21)
 * - mip-sdk-4: Tare orientation (0x0D,0x21)
 */
export declare class TareOrientation<R extends Response | undefined = undefined | TareOrientationResponse> extends Command<R> {
    constructor(values: Values<TareOrientation>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Axes to tare; 0 resets all axes. Required for `write`. */
    axes?: TareAxes;
    /** Apply the new setting. */
    static write(values: { axes: TareAxes }): TareOrientation<undefined>;
    /** Return the current setting in a response. */
    static read(): TareOrientation<TareOrientationResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): TareOrientation<undefined>;
    /** Load the saved setting. */
    static load(): TareOrientation<undefined>;
    /** Load the factory default setting. */
    static default(): TareOrientation<undefined>;
}

/**
 * Commanded zero velocity update (0x0D,0x22).
 *
 * Informs the filter once that the device is at rest.
 *
 * Probably affects `filter_data.NedVelocity`, `filter_data.EcefVelocity`, `filter_data.NedVelocityUncertainty` and
 * `filter_data.EcefVelocityUncertainty`. Confirmed on 3DM-GX5-45; likely or assumed on 5 more. Known only from the
 * MicroStrain MIP SDK.
 *
 * The maximum rate depends on the device.
 *
 * - mip-sdk-4: Commanded Zupt (0x0D,0x22)
 */
export declare class CommandedZupt extends Command<undefined> {
    constructor();
}

/**
 * Commanded zero angular rate update (0x0D,0x23).
 *
 * Informs the filter once that the device is not rotating.
 *
 * Probably affects `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm`, `filter_data.EulerAngles`,
 * `filter_data.GyroBias` and `filter_data.GyroBiasUncertainty`. Confirmed on 3DM-GX5-15 and 3DM-GX5-45; likely or
 * assumed on 12 more.
 *
 * At most 10 per second.
 *
 * - 3dm-gx5-15: 4.3.17 Commanded Zero-Angular Rate Update (0x0D, 0x23)
 */
export declare class CommandedAngularZupt extends Command<undefined> {
    constructor();
}

/**
 * Set reference position (0x0D,0x26).
 *
 * Sets the position for which the device computes gravity (WGS84) and the magnetic field (WMM2015).
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `ReferencePositionResponse`. Affects
 * `filter_data.Wgs84GravityMagnitude` and `filter_data.MagneticModel`. Confirmed on 3DM-GX5-15; likely or assumed on 8
 * more.
 *
 * - 3dm-gx5-15: 4.3.20 Set Reference Position (0x0D, 0x26)
 */
export declare class ReferencePosition<R extends Response | undefined = undefined | ReferencePositionResponse> extends Command<R> {
    constructor(values: Values<ReferencePosition>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** 0 disables, 1 enables. Range: 0 to 1. Required for `write`. */
    enable?: number;
    /** Geodetic latitude. Unit: deg. Frame: llh. Range: -90 to 90. Positive: north. Required for `write`. */
    latitude?: number;
    /** Geodetic longitude. Unit: deg. Frame: llh. Range: -180 to 180. Positive: east. Required for `write`. */
    longitude?: number;
    /**
     * Altitude of the reference position. Unit: m. Required for `write`. Uncertain: The reference, ellipsoid or sea
     * level, is inferred. The manual does not state it; its glossary counts altitudes from sea level.
     */
    altitude?: number;
    /** Apply the new setting. */
    static write(values: { enable: number; latitude: number; longitude: number; altitude: number }): ReferencePosition<undefined>;
    /** Return the current setting in a response. */
    static read(): ReferencePosition<ReferencePositionResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): ReferencePosition<undefined>;
    /** Load the saved setting. */
    static load(): ReferencePosition<undefined>;
    /** Load the factory default setting. */
    static default(): ReferencePosition<undefined>;
}

/**
 * Capture automatic magnetometer calibration (0x0D,0x27).
 *
 * Moves the result of the automatic magnetometer calibration into the fixed calibration.
 *
 * Also called `mag_capture_auto_cal`. Functions: `write` and `save`. Affects `sensor.ScaledMag`,
 * `filter_data.MagOffset` and `filter_data.MagMatrix`. Confirmed on 3DM-GX5-45; likely or assumed on 4 more. Known only
 * from the MicroStrain MIP SDK. Requires a magnetometer.
 *
 * A write combines the automatic calibration with `3dm.MagHardIronOffset` and `3dm.MagSoftIronMatrix`, then resets the
 * automatic calibration. A save has the same effect as saving both of these settings.
 *
 * - mip-sdk-4: Mag Capture Auto Cal (0x0D,0x27)
 */
export declare class MagCaptureAutoCalibration extends Command<undefined> {
    constructor(values: Values<MagCaptureAutoCalibration>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Apply the new setting. */
    static write(): MagCaptureAutoCalibration;
    /** Save the current setting to non-volatile memory. */
    static save(): MagCaptureAutoCalibration;
}

/**
 * Gravity noise (0x0D,0x28).
 *
 * Sets the standard deviation of the gravity noise that the filter assumes (process noise).
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `GravityNoiseResponse`. Probably affects
 * `filter_data.EulerAnglesUncertainty` and `filter_data.QuaternionAttitudeUncertainty`. Confirmed on 3DM-CV7-GNSS/INS,
 * 3DM-GX5-15 and 3DM-GX5-45; likely or assumed on 16 more.
 *
 * The factory values suit most laboratory conditions.
 *
 * - 3dm-cv7-gnss-ins: Gravity Noise Standard Deviation (0x0D,0x28)
 * - 3dm-gx5-15: 4.3.11 Gravity Noise Standard Deviation (0x0D, 0x28)
 */
export declare class GravityNoise<R extends Response | undefined = undefined | GravityNoiseResponse> extends Command<R> {
    constructor(values: Values<GravityNoise>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Standard deviation per axis. Elements: x, y, z. Unit: g. Range: greater than 0. Required for `write`. */
    noise?: types.Vector3f;
    /** Apply the new setting. */
    static write(values: { noise: types.Vector3f }): GravityNoise<undefined>;
    /** Return the current setting in a response. */
    static read(): GravityNoise<GravityNoiseResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): GravityNoise<undefined>;
    /** Load the saved setting. */
    static load(): GravityNoise<undefined>;
    /** Load the factory default setting. */
    static default(): GravityNoise<undefined>;
}

/**
 * Pressure altitude noise (0x0D,0x29).
 *
 * Sets the standard deviation of the pressure altitude noise that the filter assumes.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `PressureAltitudeNoiseResponse`. Probably affects
 * `filter_data.LlhPosition` and `filter_data.LlhPositionUncertainty`. Confirmed on 3DM-GX5-45; likely or assumed on 4
 * more. Known only from the MicroStrain MIP SDK. Requires a pressure sensor.
 *
 * With a small value, the altitude follows the pressure faster, but weather and draughts appear as changes of height.
 *
 * - mip-sdk-4: Pressure altitude noise (0x0D,0x29)
 */
export declare class PressureAltitudeNoise<R extends Response | undefined = undefined | PressureAltitudeNoiseResponse> extends Command<R> {
    constructor(values: Values<PressureAltitudeNoise>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Standard deviation of the pressure altitude noise. Unit: m. Range: greater than 0. Required for `write`. */
    noise?: number;
    /** Apply the new setting. */
    static write(values: { noise: number }): PressureAltitudeNoise<undefined>;
    /** Return the current setting in a response. */
    static read(): PressureAltitudeNoise<PressureAltitudeNoiseResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): PressureAltitudeNoise<undefined>;
    /** Load the saved setting. */
    static load(): PressureAltitudeNoise<undefined>;
    /** Load the factory default setting. */
    static default(): PressureAltitudeNoise<undefined>;
}

/**
 * Hard iron offset noise (0x0D,0x2B).
 *
 * Sets the standard deviation of the noise of the estimated hard iron offset (process noise).
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `HardIronOffsetNoiseResponse`. Probably affects
 * `filter_data.MagOffset` and `filter_data.MagOffsetUncertainty`. Confirmed on 3DM-GX5-45; likely or assumed on 4 more.
 * Known only from the MicroStrain MIP SDK. Requires a magnetometer.
 *
 * - mip-sdk-4: Hard iron offset noise (0x0D,0x2B)
 */
export declare class HardIronOffsetNoise<R extends Response | undefined = undefined | HardIronOffsetNoiseResponse> extends Command<R> {
    constructor(values: Values<HardIronOffsetNoise>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Standard deviation per axis. Elements: x, y, z. Unit: gauss. Range: greater than 0. Required for `write`. */
    noise?: types.Vector3f;
    /** Apply the new setting. */
    static write(values: { noise: types.Vector3f }): HardIronOffsetNoise<undefined>;
    /** Return the current setting in a response. */
    static read(): HardIronOffsetNoise<HardIronOffsetNoiseResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): HardIronOffsetNoise<undefined>;
    /** Load the saved setting. */
    static load(): HardIronOffsetNoise<undefined>;
    /** Load the factory default setting. */
    static default(): HardIronOffsetNoise<undefined>;
}

/**
 * Soft iron matrix noise (0x0D,0x2C).
 *
 * Sets the standard deviation of the noise of the estimated soft iron matrix (process noise).
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `SoftIronMatrixNoiseResponse`. Probably affects
 * `filter_data.MagMatrix` and `filter_data.MagMatrixUncertainty`. Confirmed on 3DM-GX5-45; likely or assumed on 4 more.
 * Known only from the MicroStrain MIP SDK. Requires a magnetometer.
 *
 * - mip-sdk-4: Soft iron matrix noise (0x0D,0x2C)
 */
export declare class SoftIronMatrixNoise<R extends Response | undefined = undefined | SoftIronMatrixNoiseResponse> extends Command<R> {
    constructor(values: Values<SoftIronMatrixNoise>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Standard deviation per element. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit: 1. Range: greater
     * than 0. Required for `write`.
     */
    noise?: types.Matrix3f;
    /** Apply the new setting. */
    static write(values: { noise: types.Matrix3f }): SoftIronMatrixNoise<undefined>;
    /** Return the current setting in a response. */
    static read(): SoftIronMatrixNoise<SoftIronMatrixNoiseResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): SoftIronMatrixNoise<undefined>;
    /** Load the saved setting. */
    static load(): SoftIronMatrixNoise<undefined>;
    /** Load the factory default setting. */
    static default(): SoftIronMatrixNoise<undefined>;
}

/**
 * Enable or disable measurements (0x0D,0x41).
 *
 * Selects the inertial measurements that the filter uses.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `EnableMeasurementsResponse`. Probably affects
 * `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm`, `filter_data.EulerAngles`,
 * `filter_data.EulerAnglesUncertainty` and `filter_data.QuaternionAttitudeUncertainty`. Confirmed on 3DM-GX5-15; likely
 * or assumed on 6 more.
 *
 * - 3dm-gx5-15: 4.3.18 Enable/Disable Measurements (0x0D, 0x41)
 */
export declare class EnableMeasurements<R extends Response | undefined = undefined | EnableMeasurementsResponse> extends Command<R> {
    constructor(values: Values<EnableMeasurements>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Measurements to use. Required for `write`.
     *
     * - On the 3DM-CV5-15, 3DM-CX5-15 and 3DM-GX5-15: only `MeasurementFlags.ACCEL`.
     */
    control?: MeasurementFlags;
    /** Apply the new setting. */
    static write(values: { control: MeasurementFlags }): EnableMeasurements<undefined>;
    /** Return the current setting in a response. */
    static read(): EnableMeasurements<EnableMeasurementsResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): EnableMeasurements<undefined>;
    /** Load the saved setting. */
    static load(): EnableMeasurements<undefined>;
    /** Load the factory default setting. */
    static default(): EnableMeasurements<undefined>;
}

/**
 * Magnetometer noise (0x0D,0x42).
 *
 * Sets the standard deviation of the magnetometer noise that the filter assumes.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `MagNoiseResponse`. Probably affects
 * `filter_data.EulerAnglesUncertainty` and `filter_data.QuaternionAttitudeUncertainty`. Confirmed on 3DM-GX5-45; likely
 * or assumed on 9 more. Known only from the MicroStrain MIP SDK. Requires a magnetometer. Uncertain: The SDK calls it
 * process noise, although the noise is that of a measurement.
 *
 * - mip-sdk-4: Mag Noise (0x0D,0x42)
 */
export declare class MagNoise<R extends Response | undefined = undefined | MagNoiseResponse> extends Command<R> {
    constructor(values: Values<MagNoise>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Standard deviation per axis. Elements: x, y, z. Unit: gauss. Range: greater than 0. Required for `write`. */
    noise?: types.Vector3f;
    /** Apply the new setting. */
    static write(values: { noise: types.Vector3f }): MagNoise<undefined>;
    /** Return the current setting in a response. */
    static read(): MagNoise<MagNoiseResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): MagNoise<undefined>;
    /** Load the saved setting. */
    static load(): MagNoise<undefined>;
    /** Load the factory default setting. */
    static default(): MagNoise<undefined>;
}

/**
 * Magnetic declination source (0x0D,0x43).
 *
 * Selects the source of the local declination of the magnetic field.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `MagneticDeclinationSourceResponse`. Probably
 * affects `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm` and `filter_data.EulerAngles`. Confirmed on
 * 3DM-CV7-AHRS, 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS and 3DM-GX5-45; likely or assumed on 14 more. Requires a
 * magnetometer.
 *
 * Without a good declination source, keep automatic magnetometer calibration off.
 *
 * - 3dm-cv7-gnss-ins: Magnetic Field Declination Source Control (0x0D,0x43)
 * - 3dm-gq7: Magnetic Field Declination Source Control (0x0D,0x43)
 */
export declare class MagneticDeclinationSource<R extends Response | undefined = undefined | MagneticDeclinationSourceResponse> extends Command<R> {
    constructor(values: Values<MagneticDeclinationSource>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Source of the declination. Required for `write`.
     *
     * - On the 3DM-CX7-AHRS and 3DM-GV7-AHRS: only `MagParameterSource.NONE` and `MagParameterSource.MANUAL`.
     * - On the 3DM-GQ7-GNSS/INS: only `MagParameterSource.WMM` and `MagParameterSource.MANUAL`.
     */
    source?: MagParameterSource;
    /**
     * Angle from true north to magnetic north; used only if `source` is manual. Unit: rad. Frame: ned. Range: -pi to
     * pi. Positive: magnetic north is east of true north. Required for `write`. Uncertain: The sign is the usual one;
     * no source states it. Uncertain: The manuals, that of the 3DM-GQ7 included, require it only if `source` is manual,
     * but state one length, with the value. Always send it.
     */
    declination?: number;
    /** Apply the new setting. */
    static write(values: { source: MagParameterSource; declination: number }): MagneticDeclinationSource<undefined>;
    /** Return the current setting in a response. */
    static read(): MagneticDeclinationSource<MagneticDeclinationSourceResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): MagneticDeclinationSource<undefined>;
    /** Load the saved setting. */
    static load(): MagneticDeclinationSource<undefined>;
    /** Load the factory default setting. */
    static default(): MagneticDeclinationSource<undefined>;
}

/**
 * Gravity magnitude error adaptive measurement (0x0D,0x44).
 *
 * Sets how far the filter trusts gravity measurements whose magnitude is not as expected.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `AccelMagnitudeErrorAdaptiveMeasurementResponse`.
 * Probably affects `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm`, `filter_data.EulerAngles`,
 * `filter_data.EulerAnglesUncertainty` and `filter_data.QuaternionAttitudeUncertainty`. Confirmed on 3DM-GX5-15 and
 * 3DM-GX5-45; likely or assumed on 13 more.
 *
 * Also called accelerometer magnitude error adaptive measurement. All parameters after the selector keep their values
 * if they are omitted. The low-pass filter and the limits take effect only with `fixed`. Raise the limits where
 * vibration is strong, lower them where it is weak. High limits reduce the accuracy of pitch and roll under linear
 * acceleration, low limits reduce the accuracy of the heading.
 *
 * - 3dm-gx5-15: 4.3.19 Gravity Magnitude Error Adaptive Measurement (0x0D, 0x44)
 */
export declare class AccelMagnitudeErrorAdaptiveMeasurement<R extends Response | undefined = undefined | AccelMagnitudeErrorAdaptiveMeasurementResponse> extends Command<R> {
    constructor(values: Values<AccelMagnitudeErrorAdaptiveMeasurement>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Kind of adaptation. Required for `write`.
     *
     * - On the 3DM-GQ4-45, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: only
     *   `AdaptiveMeasurementSelector.DISABLED` and `AdaptiveMeasurementSelector.FIXED`.
     */
    adaptiveMeasurement?: AdaptiveMeasurementSelector;
    /** Cutoff frequency of the low-pass filter. Unit: Hz. Range: at least 0. Optional. */
    frequency?: number;
    /** Lower limit of the gravity magnitude error. Unit: m/s^2. Optional. */
    lowLimit?: number;
    /** Upper limit of the gravity magnitude error. Unit: m/s^2. Optional. */
    highLimit?: number;
    /** Standard deviation at the lower limit. Unit: m/s^2. Range: at least 0. Optional. */
    lowLimitUncertainty?: number;
    /** Standard deviation at the upper limit. Unit: m/s^2. Range: at least 0. Optional. */
    highLimitUncertainty?: number;
    /** Smallest standard deviation. Unit: m/s^2. Range: at least 0. Optional. */
    minimumUncertainty?: number;
    /** Apply the new setting. */
    static write(values: { adaptiveMeasurement: AdaptiveMeasurementSelector; frequency?: number; lowLimit?: number; highLimit?: number; lowLimitUncertainty?: number; highLimitUncertainty?: number; minimumUncertainty?: number }): AccelMagnitudeErrorAdaptiveMeasurement<undefined>;
    /** Return the current setting in a response. */
    static read(): AccelMagnitudeErrorAdaptiveMeasurement<AccelMagnitudeErrorAdaptiveMeasurementResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): AccelMagnitudeErrorAdaptiveMeasurement<undefined>;
    /** Load the saved setting. */
    static load(): AccelMagnitudeErrorAdaptiveMeasurement<undefined>;
    /** Load the factory default setting. */
    static default(): AccelMagnitudeErrorAdaptiveMeasurement<undefined>;
}

/**
 * Magnetometer magnitude error adaptive measurement (0x0D,0x45).
 *
 * Sets how far the filter trusts a magnetic field whose magnitude is not as expected.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `MagMagnitudeErrorAdaptiveMeasurementResponse`.
 * Probably affects `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm`, `filter_data.EulerAngles`,
 * `filter_data.EulerAnglesUncertainty` and `filter_data.QuaternionAttitudeUncertainty`. Confirmed on 3DM-GX5-45; likely
 * or assumed on 10 more. Known only from the MicroStrain MIP SDK. Requires a magnetometer. Uncertain: The parameters
 * after the selector can possibly be omitted on write, like those of `AccelMagnitudeErrorAdaptiveMeasurement`.
 *
 * The limits and the low-pass filter take effect only with `fixed`; with `auto` the device determines the limits. High
 * limits suit high dynamics but do not reject disturbances of the field; low limits can degrade the heading.
 *
 * - mip-sdk-4: Mag Magnitude Error Adaptive Measurement (0x0D,0x45)
 */
export declare class MagMagnitudeErrorAdaptiveMeasurement<R extends Response | undefined = undefined | MagMagnitudeErrorAdaptiveMeasurementResponse> extends Command<R> {
    constructor(values: Values<MagMagnitudeErrorAdaptiveMeasurement>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Kind of adaptation. Required for `write`.
     *
     * - On the 3DM-GQ4-45, 3DM-GX3-45, 3DM-GX4-25, 3DM-GX4-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: only
     *   `AdaptiveMeasurementSelector.DISABLED` and `AdaptiveMeasurementSelector.FIXED`.
     */
    adaptiveMeasurement?: AdaptiveMeasurementSelector;
    /** Cutoff frequency of the low-pass filter. Unit: Hz. Range: at least 0. Required for `write`. */
    frequency?: number;
    /**
     * Lower limit of the magnetic field magnitude error. Unit: gauss. Required for `write`. Uncertain: The unit gauss
     * is inferred: the SDK states m/s^2, the manual of the 3DM-GX5-45 m/s^2 in the command and gauss in the response.
     */
    lowLimit?: number;
    /**
     * Upper limit of the magnetic field magnitude error. Unit: gauss. Required for `write`. Uncertain: The unit gauss
     * is inferred: the SDK states m/s^2, the manual of the 3DM-GX5-45 m/s^2 in the command and gauss in the response.
     */
    highLimit?: number;
    /**
     * Standard deviation at the lower limit. Unit: gauss. Range: at least 0. Required for `write`. Uncertain: The unit
     * gauss is inferred: the SDK states m/s^2, the manual of the 3DM-GX5-45 m/s^2 in the command and gauss in the
     * response.
     */
    lowLimitUncertainty?: number;
    /**
     * Standard deviation at the upper limit. Unit: gauss. Range: at least 0. Required for `write`. Uncertain: The unit
     * gauss is inferred: the SDK states m/s^2, the manual of the 3DM-GX5-45 m/s^2 in the command and gauss in the
     * response.
     */
    highLimitUncertainty?: number;
    /**
     * Smallest standard deviation. Unit: gauss. Range: at least 0. Required for `write`. Uncertain: The unit gauss is
     * inferred: the SDK states m/s^2, the manual of the 3DM-GX5-45 m/s^2 in the command and gauss in the response.
     */
    minimumUncertainty?: number;
    /** Apply the new setting. */
    static write(values: { adaptiveMeasurement: AdaptiveMeasurementSelector; frequency: number; lowLimit: number; highLimit: number; lowLimitUncertainty: number; highLimitUncertainty: number; minimumUncertainty: number }): MagMagnitudeErrorAdaptiveMeasurement<undefined>;
    /** Return the current setting in a response. */
    static read(): MagMagnitudeErrorAdaptiveMeasurement<MagMagnitudeErrorAdaptiveMeasurementResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): MagMagnitudeErrorAdaptiveMeasurement<undefined>;
    /** Load the saved setting. */
    static load(): MagMagnitudeErrorAdaptiveMeasurement<undefined>;
    /** Load the factory default setting. */
    static default(): MagMagnitudeErrorAdaptiveMeasurement<undefined>;
}

/**
 * Magnetometer dip angle error adaptive measurement (0x0D,0x46).
 *
 * Sets how far the filter trusts a magnetic field whose dip angle is not as expected.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `MagDipAngleErrorAdaptiveMeasurementResponse`.
 * Probably affects `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm`, `filter_data.EulerAngles`,
 * `filter_data.EulerAnglesUncertainty` and `filter_data.QuaternionAttitudeUncertainty`. Confirmed on 3DM-GX5-45; likely
 * or assumed on 9 more. Known only from the MicroStrain MIP SDK. Requires a magnetometer.
 *
 * It has no effect while `AccelMagnitudeErrorAdaptiveMeasurement` or `MagMagnitudeErrorAdaptiveMeasurement` is set to
 * `auto`. High limits suit high dynamics but do not reject disturbances of the field; low limits can degrade the
 * heading.
 *
 * - mip-sdk-4: Mag Dip Angle Error Adaptive Measurement (0x0D,0x46)
 */
export declare class MagDipAngleErrorAdaptiveMeasurement<R extends Response | undefined = undefined | MagDipAngleErrorAdaptiveMeasurementResponse> extends Command<R> {
    constructor(values: Values<MagDipAngleErrorAdaptiveMeasurement>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** True if the adaptation is on. Required for `write`. */
    enable?: boolean;
    /** Cutoff frequency of the low-pass filter. Unit: Hz. Range: at least 0. Required for `write`. */
    frequency?: number;
    /**
     * Upper limit of the dip angle error. Unit: rad. Range: at least 0. Required for `write`. Uncertain: The unit rad
     * is inferred from the quantity; the SDK states m/s^2.
     */
    highLimit?: number;
    /**
     * Standard deviation at the upper limit. Unit: rad. Range: at least 0. Required for `write`. Uncertain: The unit
     * rad is inferred from the quantity; the SDK states m/s^2.
     */
    highLimitUncertainty?: number;
    /**
     * Smallest standard deviation. Unit: rad. Range: at least 0. Required for `write`. Uncertain: The unit rad is
     * inferred from the quantity; the SDK states m/s^2.
     */
    minimumUncertainty?: number;
    /** Apply the new setting. */
    static write(values: { enable: boolean; frequency: number; highLimit: number; highLimitUncertainty: number; minimumUncertainty: number }): MagDipAngleErrorAdaptiveMeasurement<undefined>;
    /** Return the current setting in a response. */
    static read(): MagDipAngleErrorAdaptiveMeasurement<MagDipAngleErrorAdaptiveMeasurementResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): MagDipAngleErrorAdaptiveMeasurement<undefined>;
    /** Load the saved setting. */
    static load(): MagDipAngleErrorAdaptiveMeasurement<undefined>;
    /** Load the factory default setting. */
    static default(): MagDipAngleErrorAdaptiveMeasurement<undefined>;
}

/**
 * Altitude aiding (0x0D,0x47).
 *
 * Selects the source that aids the altitude in addition to GNSS.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `AltitudeAidingResponse`. Probably affects
 * `filter_data.LlhPosition` and `filter_data.LlhPositionUncertainty`. Confirmed on 3DM-GX5-45; likely or assumed on 4
 * more. Known only from the MicroStrain MIP SDK. Requires a pressure sensor.
 *
 * GNSS remains the main source of altitude; the aid improves it and bridges outages. Weather and location shift the
 * pressure altitude, sometimes by more than 40 m.
 *
 * - mip-sdk-4: Altitude aiding (0x0D,0x47)
 */
export declare class AltitudeAiding<R extends Response | undefined = undefined | AltitudeAidingResponse> extends Command<R> {
    constructor(values: Values<AltitudeAiding>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Source of the aiding. Required for `write`. */
    selector?: AltitudeAidingSource;
    /** Apply the new setting. */
    static write(values: { selector: AltitudeAidingSource }): AltitudeAiding<undefined>;
    /** Return the current setting in a response. */
    static read(): AltitudeAiding<AltitudeAidingResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): AltitudeAiding<undefined>;
    /** Load the saved setting. */
    static load(): AltitudeAiding<undefined>;
    /** Load the factory default setting. */
    static default(): AltitudeAiding<undefined>;
}

/**
 * Pitch and roll aiding (0x0D,0x4B).
 *
 * Selects the source that aids pitch and roll while the motion is gentle.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `PitchRollAidingResponse`. Probably affects
 * `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm`, `filter_data.EulerAngles`,
 * `filter_data.EulerAnglesUncertainty` and `filter_data.QuaternionAttitudeUncertainty`. Confirmed on 3DM-GX5-15 and
 * 3DM-GX5-45; likely or assumed on 6 more.
 *
 * - 3dm-gx5-15: 4.3.9 Pitch/Roll Aiding Control (0x0D, 0x4B)
 */
export declare class PitchRollAiding<R extends Response | undefined = undefined | PitchRollAidingResponse> extends Command<R> {
    constructor(values: Values<PitchRollAiding>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Source of the aiding. Required for `write`. */
    aiding?: PitchRollAidingSource;
    /** Apply the new setting. */
    static write(values: { aiding: PitchRollAidingSource }): PitchRollAiding<undefined>;
    /** Return the current setting in a response. */
    static read(): PitchRollAiding<PitchRollAidingResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): PitchRollAiding<undefined>;
    /** Load the saved setting. */
    static load(): PitchRollAiding<undefined>;
    /** Load the factory default setting. */
    static default(): PitchRollAiding<undefined>;
}

/**
 * Magnetic inclination source (0x0D,0x4C).
 *
 * Selects the source of the local inclination (dip angle) of the magnetic field.
 *
 * Also called `inclination_source`. Functions: `write`, `read`, `save`, `load` and `default`. Response:
 * `MagneticInclinationSourceResponse`. Probably affects `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm` and
 * `filter_data.EulerAngles`. Not listed in any device profile. Known only from the MicroStrain MIP SDK. Requires a
 * magnetometer.
 *
 * Without a good inclination source, keep automatic magnetometer calibration off.
 *
 * - mip-sdk-4: Inclination Source (0x0D,0x4C)
 */
export declare class MagneticInclinationSource<R extends Response | undefined = undefined | MagneticInclinationSourceResponse> extends Command<R> {
    constructor(values: Values<MagneticInclinationSource>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Source of the inclination. Required for `write`. */
    source?: MagParameterSource;
    /**
     * Angle of the field below the horizontal plane; used only if `source` is manual. Unit: rad. Frame: ned. Range:
     * -1.5707963267948966 to 1.5707963267948966. Positive: the field points down. Required for `write`. Uncertain: The
     * sign is the usual one; no source states it. Uncertain: It can possibly be omitted if `source` is not manual, as
     * with `MagneticDeclinationSource`. The SDK always sends it.
     */
    inclination?: number;
    /** Apply the new setting. */
    static write(values: { source: MagParameterSource; inclination: number }): MagneticInclinationSource<undefined>;
    /** Return the current setting in a response. */
    static read(): MagneticInclinationSource<MagneticInclinationSourceResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): MagneticInclinationSource<undefined>;
    /** Load the saved setting. */
    static load(): MagneticInclinationSource<undefined>;
    /** Load the factory default setting. */
    static default(): MagneticInclinationSource<undefined>;
}

/**
 * Magnetic field magnitude source (0x0D,0x4D).
 *
 * Selects the source of the local magnitude of the magnetic field.
 *
 * Also called `mag_field_magnitude_source`. Functions: `write`, `read`, `save`, `load` and `default`. Response:
 * `MagneticMagnitudeSourceResponse`. Probably affects `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm` and
 * `filter_data.EulerAngles`. Not listed in any device profile. Known only from the MicroStrain MIP SDK. Requires a
 * magnetometer.
 *
 * Without a good magnitude source, keep automatic magnetometer calibration off. `MagMagnitudeErrorAdaptiveMeasurement`
 * relies on it too.
 *
 * - mip-sdk-4: Mag Field Magnitude Source (0x0D,0x4D)
 */
export declare class MagneticMagnitudeSource<R extends Response | undefined = undefined | MagneticMagnitudeSourceResponse> extends Command<R> {
    constructor(values: Values<MagneticMagnitudeSource>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Source of the magnitude. Required for `write`. */
    source?: MagParameterSource;
    /**
     * Magnitude; used only if `source` is manual. Unit: gauss. Range: at least 0. Required for `write`. Uncertain: It
     * can possibly be omitted if `source` is not manual, as with `MagneticDeclinationSource`. The SDK always sends it.
     */
    magnitude?: number;
    /** Apply the new setting. */
    static write(values: { source: MagParameterSource; magnitude: number }): MagneticMagnitudeSource<undefined>;
    /** Return the current setting in a response. */
    static read(): MagneticMagnitudeSource<MagneticMagnitudeSourceResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): MagneticMagnitudeSource<undefined>;
    /** Load the saved setting. */
    static load(): MagneticMagnitudeSource<undefined>;
    /** Load the factory default setting. */
    static default(): MagneticMagnitudeSource<undefined>;
}

/**
 * Sensor to vehicle rotation, matrix (0x0D,0x4E).
 *
 * Sets the rotation from the sensor frame to the vehicle frame as a direction cosine matrix.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `SensorToVehicleRotationDcmResponse`. Affects
 * `sensor.ScaledAccel`, `sensor.ScaledGyro`, `sensor.ScaledMag`, `sensor.DeltaTheta`, `sensor.DeltaVelocity`,
 * `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm`, `filter_data.EulerAngles`, `filter_data.LinearAccel`,
 * `filter_data.CompAngularRate` and `filter_data.GravityVector`. Probably affects `filter_data.CompAccel`. Not listed
 * in any device profile. Known only from the MicroStrain MIP SDK.
 *
 * It is the inverse of the matrix that `3dm.SensorToVehicleTransformDcm` accepts. The device rejects a matrix that is
 * not orthonormal to within 0.001. The device keeps a quaternion, so the elements read back may differ slightly from
 * those written.
 *
 * - mip-sdk-4: Sensor To Vehicle Rotation Dcm (0x0D,0x4E)
 */
export declare class SensorToVehicleRotationDcm<R extends Response | undefined = undefined | SensorToVehicleRotationDcmResponse> extends Command<R> {
    constructor(values: Values<SensorToVehicleRotationDcm>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Rotates vectors of the vehicle frame into the sensor frame; row-major. Elements: m11, m12, m13, m21, m22, m23,
     * m31, m32, m33. Unit: 1. Required for `write`.
     */
    dcm?: types.Matrix3f;
    /** Apply the new setting. */
    static write(values: { dcm: types.Matrix3f }): SensorToVehicleRotationDcm<undefined>;
    /** Return the current setting in a response. */
    static read(): SensorToVehicleRotationDcm<SensorToVehicleRotationDcmResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): SensorToVehicleRotationDcm<undefined>;
    /** Load the saved setting. */
    static load(): SensorToVehicleRotationDcm<undefined>;
    /** Load the factory default setting. */
    static default(): SensorToVehicleRotationDcm<undefined>;
}

/**
 * Sensor to vehicle rotation, quaternion (0x0D,0x4F).
 *
 * Sets the rotation from the sensor frame to the vehicle frame as a quaternion.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `SensorToVehicleRotationQuaternionResponse`.
 * Affects `sensor.ScaledAccel`, `sensor.ScaledGyro`, `sensor.ScaledMag`, `sensor.DeltaTheta`, `sensor.DeltaVelocity`,
 * `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm`, `filter_data.EulerAngles`, `filter_data.LinearAccel`,
 * `filter_data.CompAngularRate` and `filter_data.GravityVector`. Probably affects `filter_data.CompAccel`. Not listed
 * in any device profile. Known only from the MicroStrain MIP SDK.
 *
 * It is the inverse of the quaternion that `3dm.SensorToVehicleTransformQuaternion` accepts. The device normalizes it,
 * so the elements read back may differ slightly from those written.
 *
 * - mip-sdk-4: Sensor To Vehicle Rotation Quaternion (0x0D,0x4F)
 */
export declare class SensorToVehicleRotationQuaternion<R extends Response | undefined = undefined | SensorToVehicleRotationQuaternionResponse> extends Command<R> {
    constructor(values: Values<SensorToVehicleRotationQuaternion>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Rotates vectors of the sensor frame into the vehicle frame; unit quaternion, w first. Elements: w, x, y, z. Unit:
     * 1. Range: magnitude 0.999 to 1.001. Required for `write`.
     */
    q?: types.Quatf;
    /** Apply the new setting. */
    static write(values: { q: types.Quatf }): SensorToVehicleRotationQuaternion<undefined>;
    /** Return the current setting in a response. */
    static read(): SensorToVehicleRotationQuaternion<SensorToVehicleRotationQuaternionResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): SensorToVehicleRotationQuaternion<undefined>;
    /** Load the saved setting. */
    static load(): SensorToVehicleRotationQuaternion<undefined>;
    /** Load the factory default setting. */
    static default(): SensorToVehicleRotationQuaternion<undefined>;
}

/**
 * Aiding measurement control (0x0D,0x50).
 *
 * Enables or disables one source of aiding measurements.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `AidingMeasurementEnableResponse`. Affects
 * `filter_data.AidingMeasurementSummary`. Probably affects filter_data (0x82). Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR
 * and 3DM-CV7-GNSS/INS; likely or assumed on 8 more.
 *
 * - 3dm-cv7-gnss-ins: Aiding Measurement Control (0x0D,0x50)
 */
export declare class AidingMeasurementEnable<R extends Response | undefined = undefined | AidingMeasurementEnableResponse> extends Command<R> {
    constructor(values: Values<AidingMeasurementEnable>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * The source; `all` is for save, load and default.
     *
     * - On the 3DM-CV7-AHRS, 3DM-CX7-AHRS and 3DM-GV7-AHRS: only `AidingSource.MAG`, `AidingSource.EXTERNAL_HEADING`
     *   and `AidingSource.ALL`.
     * - On the 3DM-CV7-AR, 3DM-CX7-AR and 3DM-GV7-AR: only `AidingSource.EXTERNAL_HEADING` and `AidingSource.ALL`.
     * - On the 3DM-CV7-INS, 3DM-CX7-INS and 3DM-GV7-INS: only `AidingSource.GNSS_POSITION_VELOCITY`,
     *   `AidingSource.ALTIMETER`, `AidingSource.MAG`, `AidingSource.EXTERNAL_HEADING`,
     *   `AidingSource.EXTERNAL_ALTIMETER`, `AidingSource.EXTERNAL_MAG`, `AidingSource.BODY_FRAME_VELOCITY` and
     *   `AidingSource.ALL`.
     * - On the 3DM-GQ7-GNSS/INS: only `AidingSource.GNSS_POSITION_VELOCITY`, `AidingSource.GNSS_HEADING`,
     *   `AidingSource.ALTIMETER`, `AidingSource.SPEED`, `AidingSource.MAG`, `AidingSource.EXTERNAL_HEADING` and
     *   `AidingSource.ALL`.
     */
    aidingSource?: AidingSource;
    /** True if the filter uses the source. Required for `write`. */
    enable?: boolean;
    /** Apply the new setting. */
    static write(values: { aidingSource: AidingSource; enable: boolean }): AidingMeasurementEnable<undefined>;
    /** Return the current setting in a response. */
    static read(values: { aidingSource: AidingSource }): AidingMeasurementEnable<AidingMeasurementEnableResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(values: { aidingSource: AidingSource }): AidingMeasurementEnable<undefined>;
    /** Load the saved setting. */
    static load(values: { aidingSource: AidingSource }): AidingMeasurementEnable<undefined>;
    /** Load the factory default setting. */
    static default(values: { aidingSource: AidingSource }): AidingMeasurementEnable<undefined>;
}

/**
 * Kinematic constraint (0x0D,0x51).
 *
 * Sets the assumptions about the motion that the filter uses in place of measurements.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `KinematicConstraintResponse`. Probably affects
 * `filter_data.NedVelocity`, `filter_data.EcefVelocity`, `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm`
 * and `filter_data.EulerAngles`. Not listed in any device profile. Known only from the MicroStrain MIP SDK. Uncertain:
 * There may be further values, because the SDK uses plain numbers and lists values in comments only.
 *
 * - mip-sdk-4: Kinematic constraint (0x0D,0x51)
 */
export declare class KinematicConstraint<R extends Response | undefined = undefined | KinematicConstraintResponse> extends Command<R> {
    constructor(values: Values<KinematicConstraint>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Assumption about the acceleration. Default: `AccelConstraint.NONE`. Required for `write`. */
    accelConstraint?: AccelConstraint;
    /** Assumption about the velocity. Default: `VelocityConstraint.NONE`. Required for `write`. */
    velocityConstraint?: VelocityConstraint;
    /** Assumption about the angular rate. Default: `AngularConstraint.NONE`. Required for `write`. */
    angularConstraint?: AngularConstraint;
    /** Apply the new setting. */
    static write(values: { accelConstraint: AccelConstraint; velocityConstraint: VelocityConstraint; angularConstraint: AngularConstraint }): KinematicConstraint<undefined>;
    /** Return the current setting in a response. */
    static read(): KinematicConstraint<KinematicConstraintResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): KinematicConstraint<undefined>;
    /** Load the saved setting. */
    static load(): KinematicConstraint<undefined>;
    /** Load the factory default setting. */
    static default(): KinematicConstraint<undefined>;
}

/**
 * Navigation filter initialization (0x0D,0x52).
 *
 * Sets the sources and values of the initial attitude, position and velocity of the filter.
 *
 * Also called `initialization_configuration`. Functions: `write`, `read`, `save`, `load` and `default`. Response:
 * `InitializationConfigResponse`. Probably affects `filter_data.Status`, `filter_data.LlhPosition`,
 * `filter_data.EcefPosition`, `filter_data.NedVelocity`, `filter_data.EcefVelocity`, `filter_data.AttitudeQuaternion`,
 * `filter_data.AttitudeDcm` and `filter_data.EulerAngles`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-CV7-INS and
 * 3DM-GQ7-GNSS/INS; likely or assumed on 2 more.
 *
 * The initial angles are in degrees, unlike those of `SetInitialAttitude`, which are in radians. Single precision
 * resolves the latitude and longitude of the initial position to about a metre only. Kinematic alignment sets the
 * heading once the speed reaches 2 m/s. External alignment needs a heading at least every 5 seconds. A change takes
 * effect at the next start of the filter: after `Reset` or a power cycle.
 *
 * - 3dm-cv7-gnss-ins: Navigation Filter Initialization (0x0D,0x52)
 */
export declare class InitializationConfig<R extends Response | undefined = undefined | InitializationConfigResponse> extends Command<R> {
    constructor(values: Values<InitializationConfig>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** 1: the filter starts only after `Run`; 0: it starts as soon as it can. Range: 0 to 1. Required for `write`. */
    waitForRunCommand?: number;
    /** Initial conditions that your program provides instead of the device. Required for `write`. */
    initialConditionSource?: InitialConditionSource;
    /**
     * Methods that may be used to determine the initial heading. Required for `write`.
     *
     * - On the 3DM-CV7-INS, 3DM-CX7-INS and 3DM-GV7-INS: only `HeadingAlignment.KINEMATIC`, `HeadingAlignment.MAG` and
     *   `HeadingAlignment.EXTERNAL`.
     * - On the 3DM-GQ7-GNSS/INS: only `HeadingAlignment.DUAL_ANTENNA`, `HeadingAlignment.KINEMATIC` and
     *   `HeadingAlignment.MAG`.
     */
    autoHeadingAlignmentSelector?: HeadingAlignment;
    /**
     * Initial heading relative to true north. Unit: deg. Frame: ned. Positive: clockwise seen from above. Required for
     * `write`.
     */
    initialHeading?: number;
    /** Initial pitch angle. Unit: deg. Frame: ned. Positive: nose up. Required for `write`. */
    initialPitch?: number;
    /** Initial roll angle. Unit: deg. Frame: ned. Positive: right side down. Required for `write`. */
    initialRoll?: number;
    /**
     * Initial position that your program provides. Elements: x, y, z. Required for `write`.
     *
     * - If `referenceFrameSelector` is `ReferenceFrame.ECEF`: unit m; frame ecef.
     * - If `referenceFrameSelector` is `ReferenceFrame.LLH`: elements latitude, longitude, height; unit deg, deg, m;
     *   frame llh.
     */
    initialPosition?: types.Vector3f;
    /**
     * Initial velocity that your program provides. Elements: x, y, z. Unit: m/s. Required for `write`.
     *
     * - If `referenceFrameSelector` is `ReferenceFrame.ECEF`: frame ecef.
     * - If `referenceFrameSelector` is `ReferenceFrame.LLH`: elements north, east, down; frame ned.
     */
    initialVelocity?: types.Vector3f;
    /** Frame of the initial position and velocity. Required for `write`. */
    referenceFrameSelector?: ReferenceFrame;
    /** Apply the new setting. */
    static write(values: { waitForRunCommand: number; initialConditionSource: InitialConditionSource; autoHeadingAlignmentSelector: HeadingAlignment; initialHeading: number; initialPitch: number; initialRoll: number; initialPosition: types.Vector3f; initialVelocity: types.Vector3f; referenceFrameSelector: ReferenceFrame }): InitializationConfig<undefined>;
    /** Return the current setting in a response. */
    static read(): InitializationConfig<InitializationConfigResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): InitializationConfig<undefined>;
    /** Load the saved setting. */
    static load(): InitializationConfig<undefined>;
    /** Load the factory default setting. */
    static default(): InitializationConfig<undefined>;
}

/**
 * Adaptive filter control (0x0D,0x53).
 *
 * Sets how the filter adapts to measurements that do not fit its model.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `AdaptiveFilterOptionsResponse`. Probably affects
 * filter_data (0x82). Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 12 more.
 *
 * - 3dm-cv7-gnss-ins: Adaptive Filter Control (0x0D,0x53)
 */
export declare class AdaptiveFilterOptions<R extends Response | undefined = undefined | AdaptiveFilterOptionsResponse> extends Command<R> {
    constructor(values: Values<AdaptiveFilterOptions>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Strength of the adaptation. Default: 2. Required for `write`.
     *
     * - On the 3DM-GX5-45: only `AdaptiveLevel.OFF` and `AdaptiveLevel.MODERATE`.
     */
    level?: AdaptiveLevel;
    /** Longest time for which measurements are rejected before the filter recovers. Unit: ms. Required for `write`. */
    timeLimit?: number;
    /** Apply the new setting. */
    static write(values: { level: AdaptiveLevel; timeLimit: number }): AdaptiveFilterOptions<undefined>;
    /** Return the current setting in a response. */
    static read(): AdaptiveFilterOptions<AdaptiveFilterOptionsResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): AdaptiveFilterOptions<undefined>;
    /** Load the saved setting. */
    static load(): AdaptiveFilterOptions<undefined>;
    /** Load the factory default setting. */
    static default(): AdaptiveFilterOptions<undefined>;
}

/**
 * GNSS multi-antenna offset (0x0D,0x54).
 *
 * Sets the position of the antenna of one receiver on devices with several antennas.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `MultiAntennaOffsetResponse`. Probably affects
 * `filter_data.LlhPosition`, `filter_data.EcefPosition`, `filter_data.NedVelocity`, `filter_data.EcefVelocity`,
 * `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm`, `filter_data.EulerAngles`,
 * `filter_data.MultiAntennaOffsetCorrection` and `filter_data.GnssDualAntennaStatus`. Confirmed on 3DM-CV7-GNSS/INS;
 * likely or assumed on 1 more. Requires a receiver.
 *
 * - 3dm-cv7-gnss-ins: GNSS Multi-Antenna Offset Control (0x0D,0x54)
 */
export declare class MultiAntennaOffset<R extends Response | undefined = undefined | MultiAntennaOffsetResponse> extends Command<R> {
    constructor(values: Values<MultiAntennaOffset>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Number of the receiver, from 1. Range: at least 1. */
    receiverId?: number;
    /**
     * Lever arm from the sensor to the antenna. Elements: x, y, z. Unit: m. Frame: vehicle. Range: magnitude at most
     * 10. Required for `write`.
     */
    antennaOffset?: types.Vector3f;
    /** Apply the new setting. */
    static write(values: { receiverId: number; antennaOffset: types.Vector3f }): MultiAntennaOffset<undefined>;
    /** Return the current setting in a response. */
    static read(values: { receiverId: number }): MultiAntennaOffset<MultiAntennaOffsetResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(values: { receiverId: number }): MultiAntennaOffset<undefined>;
    /** Load the saved setting. */
    static load(values: { receiverId: number }): MultiAntennaOffset<undefined>;
    /** Load the factory default setting. */
    static default(values: { receiverId: number }): MultiAntennaOffset<undefined>;
}

/**
 * Relative position configuration (0x0D,0x55).
 *
 * Sets the reference point of the relative position that the filter reports.
 *
 * Also called `rel_pos_configuration`. Functions: `write`, `read`, `save`, `load` and `default`. Response:
 * `RelativePositionConfigResponse`. Affects `filter_data.NedRelativePosition`. Confirmed on 3DM-CV7-GNSS/INS; likely or
 * assumed on 4 more.
 *
 * - 3dm-cv7-gnss-ins: Relative Position Configuration (0x0D,0x55)
 */
export declare class RelativePositionConfig<R extends Response | undefined = undefined | RelativePositionConfigResponse> extends Command<R> {
    constructor(values: Values<RelativePositionConfig>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Source of the reference point. Required for `write`. */
    source?: RelativePositionSource;
    /** Frame of the coordinates. Required for `write`. */
    referenceFrameSelector?: ReferenceFrame;
    /**
     * Reference point. Elements: x, y, z. Required for `write`.
     *
     * - If `referenceFrameSelector` is `ReferenceFrame.ECEF`: unit m; frame ecef.
     * - If `referenceFrameSelector` is `ReferenceFrame.LLH`: elements latitude, longitude, height; unit deg, deg, m;
     *   frame llh.
     */
    referenceCoordinates?: types.Vector3d;
    /** Apply the new setting. */
    static write(values: { source: RelativePositionSource; referenceFrameSelector: ReferenceFrame; referenceCoordinates: types.Vector3d }): RelativePositionConfig<undefined>;
    /** Return the current setting in a response. */
    static read(): RelativePositionConfig<RelativePositionConfigResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): RelativePositionConfig<undefined>;
    /** Load the saved setting. */
    static load(): RelativePositionConfig<undefined>;
    /** Load the factory default setting. */
    static default(): RelativePositionConfig<undefined>;
}

/**
 * Reference point lever arm (0x0D,0x56).
 *
 * Moves the point to which the position and the velocity of the filter refer.
 *
 * Also called `ref_point_lever_arm`. Functions: `write`, `read`, `save`, `load` and `default`. Response:
 * `ReferencePointLeverArmResponse`. Affects `filter_data.LlhPosition`, `filter_data.EcefPosition`,
 * `filter_data.NedVelocity`, `filter_data.EcefVelocity` and `filter_data.NedRelativePosition`. Confirmed on
 * 3DM-CV7-GNSS/INS; likely or assumed on 4 more.
 *
 * The shift in position depends on the attitude; the shift in velocity also depends on the angular rate.
 *
 * - 3dm-cv7-gnss-ins: Reference point lever arm (0x0D,0x56)
 */
export declare class ReferencePointLeverArm<R extends Response | undefined = undefined | ReferencePointLeverArmResponse> extends Command<R> {
    constructor(values: Values<ReferencePointLeverArm>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Point to move; it must be 1. Required for `write`. */
    referencePoint?: ReferencePoint;
    /**
     * Lever arm from the sensor to the point. Elements: x, y, z. Unit: m. Frame: vehicle. Range: magnitude at most 10.
     * Required for `write`.
     */
    leverArmOffset?: types.Vector3f;
    /** Apply the new setting. */
    static write(values: { referencePoint: ReferencePoint; leverArmOffset: types.Vector3f }): ReferencePointLeverArm<undefined>;
    /** Return the current setting in a response. */
    static read(): ReferencePointLeverArm<ReferencePointLeverArmResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): ReferencePointLeverArm<undefined>;
    /** Load the saved setting. */
    static load(): ReferencePointLeverArm<undefined>;
    /** Load the factory default setting. */
    static default(): ReferencePointLeverArm<undefined>;
}

/**
 * Speed measurement (0x0D,0x60).
 *
 * Sends one measurement of the forward speed of the vehicle (along its x axis) to the filter.
 *
 * Not listed in any device profile. Known only from the MicroStrain MIP SDK. Uncertain: The SDK names a response,
 * `filter.speed_measurement_response`, but has no layout of it.
 *
 * Do not use it together with the device's odometer. Single precision resolves the time of week to 0.0625 s at the end
 * of the week.
 *
 * - mip-sdk-4: Speed measurement (0x0D,0x60)
 */
export declare class SpeedMeasurement extends Command<undefined> {
    constructor(values: Values<SpeedMeasurement, "source">);
    /** Send 1. Reserved: send 1. */
    source: number;
    /**
     * GPS time of week of the measurement. Unit: s. Range: 0 to 604800. Uncertain: The unit is inferred; the SDK states
     * none.
     */
    tow: number;
    /** Speed along the x axis of the vehicle. Unit: m/s. Frame: vehicle. Positive: forward. */
    speed: number;
    /** Standard deviation of the speed. Unit: m/s. Range: at least 0. */
    speedUncertainty: number;
}

/**
 * Speed measurement lever arm (0x0D,0x61).
 *
 * Sets the position of the point whose speed is measured, such as the wheel that drives the odometer.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `SpeedLeverArmResponse`. Probably affects
 * `filter_data.NedVelocity`, `filter_data.EcefVelocity` and `filter_data.OdometerScaleFactorError`. Confirmed on
 * 3DM-CV7-GNSS/INS; likely or assumed on 1 more.
 *
 * It corrects for the part of the speed at that point that is due to the rotation of the vehicle.
 *
 * - 3dm-cv7-gnss-ins: Measurement speed lever arm (0x0D,0x61)
 */
export declare class SpeedLeverArm<R extends Response | undefined = undefined | SpeedLeverArmResponse> extends Command<R> {
    constructor(values: Values<SpeedLeverArm, "source">);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Reserved: send 1. */
    source?: number;
    /**
     * Lever arm from the sensor to the point of measurement. Elements: x, y, z. Unit: m. Frame: vehicle. Required for
     * `write`.
     */
    leverArmOffset?: types.Vector3f;
    /** Apply the new setting. */
    static write(values: { leverArmOffset: types.Vector3f }): SpeedLeverArm<undefined>;
    /** Return the current setting in a response. */
    static read(): SpeedLeverArm<SpeedLeverArmResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): SpeedLeverArm<undefined>;
    /** Load the saved setting. */
    static load(): SpeedLeverArm<undefined>;
    /** Load the factory default setting. */
    static default(): SpeedLeverArm<undefined>;
}

/**
 * Vertical gyro constraint (0x0D,0x62).
 *
 * Sets whether the filter maintains pitch and roll with the accelerometers while there is no GNSS.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `VerticalGyroConstraintControlResponse`. Probably
 * affects `filter_data.AttitudeQuaternion`, `filter_data.AttitudeDcm` and `filter_data.EulerAngles`. Not listed in any
 * device profile. Known only from the MicroStrain MIP SDK.
 *
 * It assumes that the linear acceleration is zero.
 *
 * - mip-sdk-4: Vertical Gyro Constraint Control (0x0D,0x62)
 */
export declare class VerticalGyroConstraintControl<R extends Response | undefined = undefined | VerticalGyroConstraintControlResponse> extends Command<R> {
    constructor(values: Values<VerticalGyroConstraintControl>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** 0 disables, 1 enables. Range: 0 to 1. Required for `write`. */
    enable?: number;
    /** Apply the new setting. */
    static write(values: { enable: number }): VerticalGyroConstraintControl<undefined>;
    /** Return the current setting in a response. */
    static read(): VerticalGyroConstraintControl<VerticalGyroConstraintControlResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): VerticalGyroConstraintControl<undefined>;
    /** Load the saved setting. */
    static load(): VerticalGyroConstraintControl<undefined>;
    /** Load the factory default setting. */
    static default(): VerticalGyroConstraintControl<undefined>;
}

/**
 * Wheeled vehicle constraint (0x0D,0x63).
 *
 * Sets whether the filter assumes that the vehicle moves only along its x axis.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `WheeledVehicleConstraintControlResponse`.
 * Probably affects `filter_data.NedVelocity`, `filter_data.EcefVelocity`, `filter_data.AttitudeQuaternion`,
 * `filter_data.AttitudeDcm` and `filter_data.EulerAngles`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 1 more.
 *
 * It improves the heading of cars and similar vehicles, especially with intermittent GNSS. Do not use it for vehicles
 * that move sideways, such as aircraft.
 *
 * - 3dm-cv7-gnss-ins: Wheeled Vehicle Constraint Control (0x0D,0x63)
 */
export declare class WheeledVehicleConstraintControl<R extends Response | undefined = undefined | WheeledVehicleConstraintControlResponse> extends Command<R> {
    constructor(values: Values<WheeledVehicleConstraintControl>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** 0 disables, 1 enables. Range: 0 to 1. Required for `write`. */
    enable?: number;
    /** Apply the new setting. */
    static write(values: { enable: number }): WheeledVehicleConstraintControl<undefined>;
    /** Return the current setting in a response. */
    static read(): WheeledVehicleConstraintControl<WheeledVehicleConstraintControlResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): WheeledVehicleConstraintControl<undefined>;
    /** Load the saved setting. */
    static load(): WheeledVehicleConstraintControl<undefined>;
    /** Load the factory default setting. */
    static default(): WheeledVehicleConstraintControl<undefined>;
}

/**
 * GNSS antenna offset calibration (0x0D,0x64).
 *
 * Enables antenna offset calibration.
 *
 * Also called `gnss_antenna_cal_control`. Functions: `write`, `read`, `save`, `load` and `default`. Response:
 * `GnssAntennaCalibrationControlResponse`. Affects `filter_data.MultiAntennaOffsetCorrection`. Probably affects
 * `filter_data.MultiAntennaOffsetCorrectionUncertainty`. Supported by 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS. Requires a
 * receiver.
 *
 * - 3dm-cv7-gnss-ins: GNSS Antenna Offset Calibration Control (0x0D,0x64)
 * - 3dm-cv7-gnss-ins: Antenna Lever Arm Calibration
 */
export declare class GnssAntennaCalibrationControl<R extends Response | undefined = undefined | GnssAntennaCalibrationControlResponse> extends Command<R> {
    constructor(values: Values<GnssAntennaCalibrationControl>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** 0 disables, 1 enables. Range: 0 to 1. Required for `write`. */
    enable?: number;
    /**
     * Largest absolute error that is tracked. Unit: m. Frame: vehicle. Range: at least 0. Required for `write`.
     *
     * - On the 3DM-CV7-GNSS/INS: range 0 to 0.5; default 0.1.
     */
    maxOffset?: number;
    /** Apply the new setting. */
    static write(values: { enable: number; maxOffset: number }): GnssAntennaCalibrationControl<undefined>;
    /** Return the current setting in a response. */
    static read(): GnssAntennaCalibrationControl<GnssAntennaCalibrationControlResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): GnssAntennaCalibrationControl<undefined>;
    /** Load the saved setting. */
    static load(): GnssAntennaCalibrationControl<undefined>;
    /** Load the factory default setting. */
    static default(): GnssAntennaCalibrationControl<undefined>;
}
