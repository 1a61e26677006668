/**
 * Aiding commands (0x13).
 *
 * Measurements of external sensors for the navigation filter, and the frames of the sensors.
 *
 * - 3dm-cv7-gnss-ins: Aiding (0x13)
 * - 3dm-cv7-gnss-ins: Filter Aiding Measurements
 */
import type { Bitfield, Command, Data, Enumeration, Flavor, Response, Values } from "./mip/index.mjs";
import type { FunctionSelector } from "./protocol.mjs";
import type * as types from "./types.mjs";

export type AidingFrameFormat = Flavor<number, "aiding.aiding_frame_format">;
/**
 * Format of the rotation of an aiding frame.
 *
 * - 3dm-cv7-gnss-ins: Frame Configuration (0x13,0x01)
 */
export declare const AidingFrameFormat: Enumeration<AidingFrameFormat> & {
    /** Euler angles: roll, pitch, yaw. */
    readonly EULER: AidingFrameFormat & 1;
    /** Quaternion: w, x, y, z. */
    readonly QUATERNION: AidingFrameFormat & 2;
};

export type AidingEchoMode = Flavor<number, "aiding.aiding_echo_mode">;
/**
 * Replies of the device to aiding measurements.
 *
 * - 3dm-cv7-gnss-ins: Echo Control (0x13,0x1F)
 */
export declare const AidingEchoMode: Enumeration<AidingEchoMode> & {
    /** No acknowledge. */
    readonly SUPPRESS_ACK: AidingEchoMode & 0;
    /** ACK, as for any command. */
    readonly STANDARD: AidingEchoMode & 1;
    /** The data is returned in a response. */
    readonly RESPONSE: AidingEchoMode & 2;
};

export type Timebase = Flavor<number, "aiding.timebase">;
/** Clock that the time of a measurement refers to. */
export declare const Timebase: Enumeration<Timebase> & {
    /** Internal reference clock of the device. */
    readonly INTERNAL_REFERENCE: Timebase & 1;
    /** External clock, to which the PPS synchronizes the device. */
    readonly EXTERNAL_TIME: Timebase & 2;
    /** Latency relative to the arrival of the command. */
    readonly TIME_OF_ARRIVAL: Timebase & 3;
};

/** Time at which a measurement was taken. */
export interface MeasurementTime {
    /** Clock that the time refers to. */
    timebase: Timebase;
    /** Reserved: send 1. */
    reserved?: number;
    /** Time by that clock. Unit: ns. */
    nanoseconds: bigint;
}

export type AxisFlags = Flavor<number, "aiding.axis_flags">;
/** Valid axes of a measurement; the others are ignored. */
export declare const AxisFlags: Bitfield<AxisFlags> & {
    /** First axis. Bit 0. */
    readonly X: AxisFlags;
    /** Second axis. Bit 1. */
    readonly Y: AxisFlags;
    /** Third axis. Bit 2. */
    readonly Z: AxisFlags;
};

export type LlhAxisFlags = Flavor<number, "aiding.llh_axis_flags">;
/** Valid coordinates of a position; the others are ignored. */
export declare const LlhAxisFlags: Bitfield<LlhAxisFlags> & {
    /** Latitude and its uncertainty are valid. Bit 0. */
    readonly LATITUDE: LlhAxisFlags;
    /** Longitude and its uncertainty are valid. Bit 1. */
    readonly LONGITUDE: LlhAxisFlags;
    /** Height and its uncertainty are valid. Bit 2. */
    readonly HEIGHT: LlhAxisFlags;
};

/**
 * Frame configuration response (0x13,0x81).
 *
 * Response to `FrameConfig`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS and 3DM-CV7-INS; likely or assumed
 * on 7 more.
 *
 * - 3dm-cv7-gnss-ins: Frame Configuration (0x13,0x01)
 * - 3dm-cv7-gnss-ins: Aiding Frames
 */
export declare class FrameConfigResponse extends Response {
    constructor(values: Values<FrameConfigResponse>);
    /** Number of the frame. Range: 1 to 4. */
    frameId: number;
    /** Format of the rotation. */
    format: AidingFrameFormat;
    /** True if the filter estimates the errors of the frame. */
    trackingEnabled: boolean;
    /** Position of the frame's origin in the vehicle frame. Elements: x, y, z. Unit: m. Frame: vehicle. */
    translation: types.Vector3f;
    /**
     * Rotates vectors of this frame into the vehicle frame. Selected by `format`.
     *
     * - If `format` is `AidingFrameFormat.EULER`: `euler: types.Vector3f`. Roll, pitch and yaw of the frame relative to
     *   the vehicle; positive are right side down, nose up, and clockwise seen from above. Elements: x, y, z. Unit:
     *   rad. Frame: vehicle. Range: -pi to pi.
     * - If `format` is `AidingFrameFormat.QUATERNION`: `quaternion: types.Quatf`. Quaternion, scalar part first.
     *   Elements: w, x, y, z. Unit: 1.
     */
    rotation: { euler?: types.Vector3f; quaternion?: types.Quatf };
}

/**
 * Sensor frame map response (0x13,0x82).
 *
 * Also called `sensor_frame_mapping_response`. Response to `SensorFrameMap`. Known only from the MicroStrain MIP SDK,
 * versions 1 to 3.
 *
 * - mip-sdk-3: Sensor Frame Mapping (0x13,0x02), branch CmdCallback
 */
export declare class SensorFrameMapResponse extends Response {
    constructor(values: Values<SensorFrameMapResponse>);
    /** Number of the sensor. Range: at least 1. */
    sensorId: number;
    /** Frame of the sensor, defined by `FrameConfig`. Range: 1 to 4. Default: 1. */
    frameId: number;
}

/**
 * Echo control response (0x13,0x9F).
 *
 * Response to `EchoControl`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 8 more.
 *
 * - 3dm-cv7-gnss-ins: Echo Control (0x13,0x1F)
 * - 3dm-cv7-gnss-ins: Aiding Command Echo Control
 */
export declare class EchoControlResponse extends Response {
    constructor(values: Values<EchoControlResponse>);
    /** Reply mode. */
    mode: AidingEchoMode;
}

/**
 * Frame configuration (0x13,0x01).
 *
 * Sets the position and the orientation of an external sensor on the vehicle.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `FrameConfigResponse`. Affects
 * `filter_data.AidingFrameConfigError`. Probably affects `filter_data.AidingFrameConfigErrorUncertainty`. Confirmed on
 * 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS and 3DM-CV7-INS; likely or assumed on 7 more.
 *
 * Aiding measurements refer to the frame by its number. `p_vehicle = R * p_frame + t`, with the rotation R and the
 * translation t. For GNSS positions and velocities the rotation does not matter. Send the identity: Euler angles 0, 0,
 * 0 or the quaternion 1, 0, 0, 0. In a read, `format` selects the format of the rotation in the reply.
 *
 * - 3dm-cv7-gnss-ins: Frame Configuration (0x13,0x01)
 * - 3dm-cv7-gnss-ins: Aiding Frames
 */
export declare class FrameConfig<R extends Response | undefined = undefined | FrameConfigResponse> extends Command<R> {
    constructor(values: Values<FrameConfig>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Number of the frame. Range: 1 to 4. */
    frameId?: number;
    /** Format of the rotation. Required for `write` and `read`. */
    format?: AidingFrameFormat;
    /** True if the filter estimates the errors of the frame. Required for `write`. */
    trackingEnabled?: boolean;
    /**
     * Position of the frame's origin in the vehicle frame. Elements: x, y, z. Unit: m. Frame: vehicle. Required for
     * `write`.
     */
    translation?: types.Vector3f;
    /**
     * Rotates vectors of this frame into the vehicle frame. Selected by `format`. Required for `write`.
     *
     * - If `format` is `AidingFrameFormat.EULER`: `euler: types.Vector3f`. Roll, pitch and yaw of the frame relative to
     *   the vehicle; positive are right side down, nose up, and clockwise seen from above. Elements: x, y, z. Unit:
     *   rad. Frame: vehicle. Range: -pi to pi.
     * - If `format` is `AidingFrameFormat.QUATERNION`: `quaternion: types.Quatf`. Quaternion, scalar part first.
     *   Elements: w, x, y, z. Unit: 1.
     */
    rotation?: { euler?: types.Vector3f; quaternion?: types.Quatf };
    /** Apply the new setting. */
    static write(values: { frameId: number; format: AidingFrameFormat; trackingEnabled: boolean; translation: types.Vector3f; rotation: { euler?: types.Vector3f; quaternion?: types.Quatf } }): FrameConfig<undefined>;
    /** Return the current setting in a response. */
    static read(values: { frameId: number; format: AidingFrameFormat }): FrameConfig<FrameConfigResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(values: { frameId: number }): FrameConfig<undefined>;
    /** Load the saved setting. */
    static load(values: { frameId: number }): FrameConfig<undefined>;
    /** Load the factory default setting. */
    static default(values: { frameId: number }): FrameConfig<undefined>;
}

/**
 * Sensor frame map (0x13,0x02).
 *
 * Sets the frame in which an aiding sensor measures.
 *
 * Also called `sensor_frame_mapping`. Functions: `write`, `read`, `save`, `load` and `default`. Response:
 * `SensorFrameMapResponse`. Not listed in any device profile. Known only from the MicroStrain MIP SDK, versions 1 to 3.
 * Uncertain: The layout is that of a branch of the SDK of 2024; later versions do not have it. Uncertain: No source
 * lists the devices that support it.
 *
 * - mip-sdk-3: Sensor Frame Mapping (0x13,0x02), branch CmdCallback
 */
export declare class SensorFrameMap<R extends Response | undefined = undefined | SensorFrameMapResponse> extends Command<R> {
    constructor(values: Values<SensorFrameMap>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Number of the sensor. Range: at least 1. Required for `write`. */
    sensorId?: number;
    /** Frame of the sensor, defined by `FrameConfig`. Range: 1 to 4. Default: 1. Required for `write`. */
    frameId?: number;
    /** Apply the new setting. */
    static write(values: { sensorId: number; frameId: number }): SensorFrameMap<undefined>;
    /** Return the current setting in a response. */
    static read(): SensorFrameMap<SensorFrameMapResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): SensorFrameMap<undefined>;
    /** Load the saved setting. */
    static load(): SensorFrameMap<undefined>;
    /** Load the factory default setting. */
    static default(): SensorFrameMap<undefined>;
}

/**
 * Echo control (0x13,0x1F).
 *
 * Sets how the device replies to aiding measurements.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `EchoControlResponse`. Confirmed on 3DM-CV7-AHRS,
 * 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 8 more.
 *
 * The manual does not contain the layout of the responses that carry the data back.
 *
 * - 3dm-cv7-gnss-ins: Echo Control (0x13,0x1F)
 * - 3dm-cv7-gnss-ins: Aiding Command Echo Control
 */
export declare class EchoControl<R extends Response | undefined = undefined | EchoControlResponse> extends Command<R> {
    constructor(values: Values<EchoControl>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Reply mode. Required for `write`. */
    mode?: AidingEchoMode;
    /** Apply the new setting. */
    static write(values: { mode: AidingEchoMode }): EchoControl<undefined>;
    /** Return the current setting in a response. */
    static read(): EchoControl<EchoControlResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): EchoControl<undefined>;
    /** Load the saved setting. */
    static load(): EchoControl<undefined>;
    /** Load the factory default setting. */
    static default(): EchoControl<undefined>;
}

/**
 * ECEF position (0x13,0x21).
 *
 * Sends a measured position in Earth-fixed coordinates.
 *
 * Also called `pos_ecef`. Not acknowledged if `mode` of `EchoControl` is `AidingEchoMode.SUPPRESS_ACK`. Confirmed on
 * 3DM-CV7-GNSS/INS; likely or assumed on 3 more.
 *
 * Use only one form of position: ECEF or LLH. In mode `response` of `EchoControl`, the device sends the data back in a
 * response of unknown layout.
 *
 * - 3dm-cv7-gnss-ins: ECEF Position (0x13,0x21)
 * - 3dm-cv7-gnss-ins: Filter Aiding Measurements > ECEF Position
 */
export declare class EcefPosition extends Command<undefined> {
    constructor(values: Values<EcefPosition>);
    /** Time of the measurement. */
    time: MeasurementTime;
    /** Sensor frame, defined by `FrameConfig`. Range: 1 to 4. */
    frameId: number;
    /**
     * Position of the origin of the frame. Elements: x, y, z. Unit: m. Frame: ecef. Each element has its own valid
     * flag. x: `AxisFlags.X` of `validFlags`, y: `AxisFlags.Y` of `validFlags`, z: `AxisFlags.Z` of `validFlags`.
     */
    position: types.Vector3d;
    /**
     * Uncertainty of the position. Elements: x, y, z. Unit: m. Frame: ecef. Range: greater than 0. Each element has its
     * own valid flag. x: `AxisFlags.X` of `validFlags`, y: `AxisFlags.Y` of `validFlags`, z: `AxisFlags.Z` of
     * `validFlags`.
     */
    uncertainty: types.Vector3f;
    /** Valid axes. */
    validFlags: AxisFlags;
}

/**
 * LLH position (0x13,0x22).
 *
 * Sends a measured position as latitude, longitude and height.
 *
 * Also called `pos_llh`. Not acknowledged if `mode` of `EchoControl` is `AidingEchoMode.SUPPRESS_ACK`. Confirmed on
 * 3DM-CV7-GNSS/INS; likely or assumed on 3 more.
 *
 * Use only one form of position: ECEF or LLH. To send a height only, clear the valid flags of latitude and longitude.
 * An uncertainty of 0 is no substitute. In mode `response` of `EchoControl`, the device sends the data back in a
 * response of unknown layout.
 *
 * - 3dm-cv7-gnss-ins: LLH Position (0x13,0x22)
 * - 3dm-cv7-gnss-ins: Filter Aiding Measurements > LLH Position
 */
export declare class LlhPosition extends Command<undefined> {
    constructor(values: Values<LlhPosition>);
    /** Time of the measurement. */
    time: MeasurementTime;
    /** Sensor frame, defined by `FrameConfig`. Range: 1 to 4. */
    frameId: number;
    /**
     * Geodetic latitude. Unit: deg. Frame: llh. Range: -90 to 90. Positive: north. Valid if `LlhAxisFlags.LATITUDE` of
     * `validFlags` is set.
     */
    latitude: number;
    /**
     * Geodetic longitude. Unit: deg. Frame: llh. Range: -180 to 180. Positive: east. Valid if `LlhAxisFlags.LONGITUDE`
     * of `validFlags` is set.
     */
    longitude: number;
    /** Height above the ellipsoid. Unit: m. Frame: llh. Valid if `LlhAxisFlags.HEIGHT` of `validFlags` is set. */
    height: number;
    /**
     * Uncertainty of the position. Elements: north, east, down. Unit: m. Frame: ned. Range: greater than 0. Each
     * element has its own valid flag. north: `LlhAxisFlags.LATITUDE` of `validFlags`, east: `LlhAxisFlags.LONGITUDE` of
     * `validFlags`, down: `LlhAxisFlags.HEIGHT` of `validFlags`.
     */
    uncertainty: types.Ned3f;
    /** Valid coordinates. */
    validFlags: LlhAxisFlags;
}

/**
 * Height above ellipsoid (0x13,0x23).
 *
 * Sends a measured height above the ellipsoid.
 *
 * Not acknowledged if `mode` of `EchoControl` is `AidingEchoMode.SUPPRESS_ACK`. Confirmed on 3DM-CV7-GNSS/INS; likely
 * or assumed on 3 more.
 *
 * In mode `response` of `EchoControl`, the device sends the data back in a response of unknown layout.
 *
 * - 3dm-cv7-gnss-ins: Height Above Ellipsoid (0x13,0x23)
 */
export declare class HeightAboveEllipsoid extends Command<undefined> {
    constructor(values: Values<HeightAboveEllipsoid>);
    /** Time of the measurement. */
    time: MeasurementTime;
    /** Sensor frame, defined by `FrameConfig`. Range: 1 to 4. */
    frameId: number;
    /** Height above the ellipsoid. Unit: m. Frame: llh. */
    height: number;
    /** Uncertainty of the height. Unit: m. Range: at least 0. */
    uncertainty: number;
    /** Nonzero if the measurement is valid. */
    validFlags: number;
}

/**
 * Pressure (old) (0x13,0x25).
 *
 * Sends a static air pressure measured by an external sensor (superseded by `Pressure`).
 *
 * Not acknowledged if `mode` of `EchoControl` is `AidingEchoMode.SUPPRESS_ACK`. Not listed in any device profile. Known
 * only from the MicroStrain MIP SDK, versions 1 to 3. Uncertain: The layout is that of a branch of the SDK of 2024;
 * later versions do not have it. Uncertain: No source lists the devices that support it.
 *
 * - mip-sdk-3: Pressure (0x13,0x25), branch feature/UsbSerial
 */
export declare class PressureOld extends Command<undefined> {
    constructor(values: Values<PressureOld>);
    /** Time of the measurement. */
    time: MeasurementTime;
    /** Sensor frame, defined by `FrameConfig`. Range: 1 to 4. */
    frameId: number;
    /** Air pressure. Unit: mbar. */
    pressure: number;
    /** Standard deviation of the pressure. Unit: mbar. Range: greater than 0. */
    uncertainty: number;
    /** Nonzero if the measurement is valid. */
    validFlags: number;
}

/**
 * ECEF velocity (0x13,0x28).
 *
 * Sends a measured velocity in Earth-fixed coordinates.
 *
 * Also called `vel_ecef`. Not acknowledged if `mode` of `EchoControl` is `AidingEchoMode.SUPPRESS_ACK`. Confirmed on
 * 3DM-CV7-GNSS/INS; likely or assumed on 3 more.
 *
 * Use only one form of velocity: ECEF or NED. For a sensor that is fixed to the vehicle, use `BodyFrameVelocity`. In
 * mode `response` of `EchoControl`, the device sends the data back in a response of unknown layout.
 *
 * - 3dm-cv7-gnss-ins: ECEF Velocity (0x13,0x28)
 * - 3dm-cv7-gnss-ins: Filter Aiding Measurements > ECEF Velocity
 */
export declare class EcefVelocity extends Command<undefined> {
    constructor(values: Values<EcefVelocity>);
    /** Time of the measurement. */
    time: MeasurementTime;
    /** Sensor frame, defined by `FrameConfig`. Range: 1 to 4. */
    frameId: number;
    /**
     * Velocity of the origin of the frame. Elements: x, y, z. Unit: m/s. Frame: ecef. Each element has its own valid
     * flag. x: `AxisFlags.X` of `validFlags`, y: `AxisFlags.Y` of `validFlags`, z: `AxisFlags.Z` of `validFlags`.
     */
    velocity: types.Vector3f;
    /**
     * Uncertainty of the velocity. Elements: x, y, z. Unit: m/s. Frame: ecef. Range: greater than 0. Each element has
     * its own valid flag. x: `AxisFlags.X` of `validFlags`, y: `AxisFlags.Y` of `validFlags`, z: `AxisFlags.Z` of
     * `validFlags`.
     */
    uncertainty: types.Vector3f;
    /** Valid axes. */
    validFlags: AxisFlags;
}

/**
 * NED velocity (0x13,0x29).
 *
 * Sends a measured velocity in the local level frame.
 *
 * Also called `vel_ned`. Not acknowledged if `mode` of `EchoControl` is `AidingEchoMode.SUPPRESS_ACK`. Confirmed on
 * 3DM-CV7-GNSS/INS; likely or assumed on 3 more.
 *
 * Use only one form of velocity: ECEF or NED. For a sensor that is fixed to the vehicle, use `BodyFrameVelocity`. In
 * mode `response` of `EchoControl`, the device sends the data back in a response of unknown layout.
 *
 * - 3dm-cv7-gnss-ins: NED Velocity (0x13,0x29)
 * - 3dm-cv7-gnss-ins: Filter Aiding Measurements > NED Velocity
 */
export declare class NedVelocity extends Command<undefined> {
    constructor(values: Values<NedVelocity>);
    /** Time of the measurement. */
    time: MeasurementTime;
    /** Sensor frame, defined by `FrameConfig`. Range: 1 to 4. */
    frameId: number;
    /**
     * Velocity of the origin of the frame. Elements: north, east, down. Unit: m/s. Frame: ned. Each element has its own
     * valid flag. north: `AxisFlags.X` of `validFlags`, east: `AxisFlags.Y` of `validFlags`, down: `AxisFlags.Z` of
     * `validFlags`.
     */
    velocity: types.Ned3f;
    /**
     * Uncertainty of the velocity. Elements: north, east, down. Unit: m/s. Frame: ned. Range: greater than 0. Each
     * element has its own valid flag. north: `AxisFlags.X` of `validFlags`, east: `AxisFlags.Y` of `validFlags`, down:
     * `AxisFlags.Z` of `validFlags`.
     */
    uncertainty: types.Ned3f;
    /** Valid axes. */
    validFlags: AxisFlags;
}

/**
 * Body frame velocity (0x13,0x2A).
 *
 * Sends a measured velocity of the vehicle in the frame of the sensor.
 *
 * Also called `vel_body_frame`. Not acknowledged if `mode` of `EchoControl` is `AidingEchoMode.SUPPRESS_ACK`. Confirmed
 * on 3DM-CV7-GNSS/INS; likely or assumed on 3 more.
 *
 * The device supports up to four sensors of this kind. For a wheeled vehicle constraint, send a velocity of 0 with only
 * y valid, at least once per second. With z also valid and 0, motion is constrained to a plane (2D mode). For a zero
 * velocity update, send a velocity of 0 while the GNSS speed is below a threshold that you choose. In mode `response`
 * of `EchoControl`, the device sends the data back in a response of unknown layout.
 *
 * - 3dm-cv7-gnss-ins: Body Frame Velocity (0x13,0x2A)
 * - 3dm-cv7-gnss-ins: Filter Aiding Measurements > Body Frame Velocity
 * - 3dm-cv7-gnss-ins: Filter Kinematic Constraints
 */
export declare class BodyFrameVelocity extends Command<undefined> {
    constructor(values: Values<BodyFrameVelocity>);
    /** Time of the measurement. */
    time: MeasurementTime;
    /** Sensor frame, defined by `FrameConfig`. Range: 1 to 4. */
    frameId: number;
    /**
     * Velocity of the origin of the frame. Elements: x, y, z. Unit: m/s. Frame: aiding. Each element has its own valid
     * flag. x: `AxisFlags.X` of `validFlags`, y: `AxisFlags.Y` of `validFlags`, z: `AxisFlags.Z` of `validFlags`.
     */
    velocity: types.Vector3f;
    /**
     * Standard deviation of the velocity. Elements: x, y, z. Unit: m/s. Frame: aiding. Range: greater than 0. Each
     * element has its own valid flag. x: `AxisFlags.X` of `validFlags`, y: `AxisFlags.Y` of `validFlags`, z:
     * `AxisFlags.Z` of `validFlags`.
     */
    uncertainty: types.Vector3f;
    /** Valid axes. */
    validFlags: AxisFlags;
}

/**
 * True heading (0x13,0x31).
 *
 * Sends a measured heading relative to true north.
 *
 * Also called `heading_true`. Not acknowledged if `mode` of `EchoControl` is `AidingEchoMode.SUPPRESS_ACK`. Confirmed
 * on 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 8 more.
 *
 * In mode `response` of `EchoControl`, the device sends the data back in a response of unknown layout.
 *
 * - 3dm-cv7-gnss-ins: True Heading (0x13,0x31)
 * - 3dm-cv7-gnss-ins: Filter Aiding Measurements > True Heading
 */
export declare class TrueHeading extends Command<undefined> {
    constructor(values: Values<TrueHeading>);
    /** Time of the measurement. */
    time: MeasurementTime;
    /** Sensor frame, defined by `FrameConfig`. Range: 1 to 4. */
    frameId: number;
    /** Heading relative to true north. Unit: rad. Frame: ned. Range: -pi to pi. Positive: clockwise seen from above. */
    heading: number;
    /** Uncertainty of the heading. Unit: rad. Range: greater than 0. */
    uncertainty: number;
    /** Nonzero if the measurement is valid. */
    validFlags: number;
}

/**
 * Magnetic field (0x13,0x32).
 *
 * Sends a magnetic field measured by an external magnetometer.
 *
 * Not acknowledged if `mode` of `EchoControl` is `AidingEchoMode.SUPPRESS_ACK`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR
 * and 3DM-CV7-GNSS/INS; likely or assumed on 7 more.
 *
 * The magnetometer must be calibrated. In mode `response` of `EchoControl`, the device sends the data back in a
 * response of unknown layout.
 *
 * - 3dm-cv7-gnss-ins: Magnetic Field (0x13,0x32)
 * - 3dm-cv7-gnss-ins: Filter Aiding Measurements > External Magnetometer
 */
export declare class MagneticField extends Command<undefined> {
    constructor(values: Values<MagneticField>);
    /** Time of the measurement. */
    time: MeasurementTime;
    /** Sensor frame, defined by `FrameConfig`. Range: 1 to 4. */
    frameId: number;
    /**
     * Calibrated magnetic field. Elements: x, y, z. Unit: gauss. Frame: aiding. Each element has its own valid flag. x:
     * `AxisFlags.X` of `validFlags`, y: `AxisFlags.Y` of `validFlags`, z: `AxisFlags.Z` of `validFlags`.
     */
    magneticField: types.Vector3f;
    /**
     * Standard deviation of the magnetic field. Elements: x, y, z. Unit: gauss. Frame: aiding. Range: greater than 0.
     * Each element has its own valid flag. x: `AxisFlags.X` of `validFlags`, y: `AxisFlags.Y` of `validFlags`, z:
     * `AxisFlags.Z` of `validFlags`.
     */
    uncertainty: types.Vector3f;
    /** Valid axes. */
    validFlags: AxisFlags;
}

/**
 * Pressure (0x13,0x33).
 *
 * Sends a static air pressure measured by an external sensor.
 *
 * Not acknowledged if `mode` of `EchoControl` is `AidingEchoMode.SUPPRESS_ACK`. Confirmed on 3DM-CV7-GNSS/INS; likely
 * or assumed on 3 more.
 *
 * In mode `response` of `EchoControl`, the device sends the data back in a response of unknown layout.
 *
 * - 3dm-cv7-gnss-ins: Pressure (0x13,0x33)
 * - 3dm-cv7-gnss-ins: Filter Aiding Measurements > External Pressure
 */
export declare class Pressure extends Command<undefined> {
    constructor(values: Values<Pressure>);
    /** Time of the measurement. */
    time: MeasurementTime;
    /** Sensor frame, defined by `FrameConfig`. Range: 1 to 4. */
    frameId: number;
    /** Air pressure. Unit: mbar. */
    pressure: number;
    /** Standard deviation of the pressure. Unit: mbar. Range: greater than 0. */
    uncertainty: number;
    /** Nonzero if the measurement is valid. */
    validFlags: number;
}
