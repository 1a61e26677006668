/**
 * Base (0x01).
 *
 * Commands common to all devices: identity, supported descriptors, idle and resume, self test, reset.
 *
 * - 3dm-gx5-15: 4.1 Base Commands
 * - 3dm-cv7-gnss-ins: Base (0x01)
 */
import type { Bitfield, Command, Data, Enumeration, Flavor, Response, Values } from "./mip/index.mjs";
import type { FunctionSelector } from "./protocol.mjs";
import type * as types from "./types.mjs";

/**
 * Identity of a device. The strings are padded with spaces.
 *
 * - 3dm-gx5-15: 4.1.3 Get Device Information (0x01, 0x03)
 * - 3dm-cv7-gnss-ins: Get device information (0x01,0x03)
 */
export interface BaseDeviceInfo {
    /** Firmware version as one decimal number: 1202 means 1.2.02. */
    firmwareVersion: number;
    /** Product name, such as 3DM-GQ7. */
    modelName: string;
    /** Part number of the model. */
    modelNumber: string;
    /** Serial number, which begins with the model number. */
    serialNumber: string;
    /** Lot number; reserved and blank on some devices. */
    lotNumber: string;
    /** Options of the unit, such as its sensor ranges. */
    deviceOptions: string;
}

export type GpsTimeField = Flavor<number, "base.gps_time_field">;
/** The part of the GPS time that a value contains. */
export declare const GpsTimeField: Enumeration<GpsTimeField> & {
    readonly WEEK_NUMBER: GpsTimeField & 1;
    /** Time of week in whole seconds. */
    readonly TOW: GpsTimeField & 2;
};

/**
 * Get device information response (0x01,0x81).
 *
 * Response to `GetDeviceInfo`. Supported by all devices; confirmed on 3DM-CV5-10, 3DM-CV5-15, 3DM-CV7-GNSS/INS,
 * 3DM-CX5-10, 3DM-GQ4-45, 3DM-GQ7-GNSS/INS, 3DM-GX5-15, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * - 3dm-gx5-15: 4.1.3 Get Device Information (0x01, 0x03)
 * - 3dm-cv7-gnss-ins: Get device information (0x01,0x03)
 */
export declare class GetDeviceInfoResponse extends Response {
    constructor(values: Values<GetDeviceInfoResponse>);
    /** Identity of the device. */
    deviceInfo: BaseDeviceInfo;
}

/**
 * Get device descriptors response (0x01,0x82).
 *
 * Response to `GetDeviceDescriptors`. Supported by all devices; confirmed on 3DM-CV5-10, 3DM-CV5-15, 3DM-CV7-AHRS,
 * 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-CX5-10, 3DM-GQ4-45, 3DM-GQ7-GNSS/INS, 3DM-GX5-15, 3DM-GX5-35, 3DM-RQ1-45-LT and
 * 3DM-RQ1-45-ST.
 *
 * - 3dm-gx5-15: 4.1.4 Get Device Descriptor Sets (0x01, 0x04)
 * - 3dm-cv7-gnss-ins: Get device descriptors (0x01,0x04)
 */
export declare class GetDeviceDescriptorsResponse extends Response {
    constructor(values: Values<GetDeviceDescriptorsResponse>);
    /** Supported descriptors: the descriptor set in the high byte, the field descriptor in the low byte. */
    descriptors: number[];
}

/**
 * Built-in test response (0x01,0x83).
 *
 * Response to `BuiltInTest`. Confirmed on 3DM-CV5-10, 3DM-CV5-15, 3DM-CV7-GNSS/INS, 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15,
 * 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 27 more.
 *
 * - 3dm-gx5-15: 4.1.5 Device Built-In Test (0x01, 0x05)
 * - 3dm-cv7-gnss-ins: Built in test (0x01,0x05)
 * - 3dm-cv7-gnss-ins: Commanded Built-in Test
 */
export declare class BuiltInTestResponse extends Response {
    constructor(values: Values<BuiltInTestResponse>);
    /**
     * Failure flags, defined by each device. Zero means that every test passed.
     *
     * - On the 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25 and 3DM-GX5-25: values of
     *   `types.Gx5BuiltInTest` (inferred: the 3DM-GX5-15 has it).
     * - On the 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-INS, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-CX7-INS, 3DM-GQ7-GNSS/INS,
     *   3DM-GV7-AHRS, 3DM-GV7-AR, 3DM-GV7-INS and 3DM-RTK: values of `types.Cv7BuiltInTest` (inferred: the
     *   3DM-CV7-GNSS/INS has it).
     * - On the 3DM-CV7-GNSS/INS: values of `types.Cv7BuiltInTest`.
     * - On the 3DM-CX5-45, 3DM-GQ4-45, 3DM-GX3-15, 3DM-GX3-25, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25,
     *   3DM-GX4-45, 3DM-GX4-IMU, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and 3DM-RQ1-IMU: the values are
     *   unknown.
     * - On the 3DM-GX5-15: values of `types.Gx5BuiltInTest`.
     */
    result: number;
}

/**
 * GPS time update, week number (0x01,0x84).
 *
 * The current week number.
 *
 * Response to `GpsTimeUpdate`. Sent if `fieldId` is `GpsTimeField.WEEK_NUMBER`. Confirmed on 3DM-CV5-10, 3DM-CV5-15,
 * 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15 and 3DM-GX5-35; likely or assumed on 16 more.
 *
 * - 3dm-gx5-15: 4.1.8 GPS Time Update (0x01, 0x72)
 * - 3dm-cv7-gnss-ins: GPS Time Update Command (0x01,0x72)
 * - 3dm-cv7-gnss-ins: Timestamps
 */
export declare class GpsTimeUpdateWeekNumberResponse extends Response {
    constructor(values: Values<GpsTimeUpdateWeekNumberResponse>);
    /** GPS week number. Unit: week. */
    weekNumber: number;
}

/**
 * GPS time update, time of week (0x01,0x85).
 *
 * The current time of week.
 *
 * Response to `GpsTimeUpdate`. Sent if `fieldId` is `GpsTimeField.TOW`. Confirmed on 3DM-CV5-10, 3DM-CV5-15,
 * 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15 and 3DM-GX5-35; likely or assumed on 16 more.
 *
 * - 3dm-gx5-15: 4.1.8 GPS Time Update (0x01, 0x72)
 * - 3dm-cv7-gnss-ins: GPS Time Update Command (0x01,0x72)
 * - 3dm-cv7-gnss-ins: Timestamps
 */
export declare class GpsTimeUpdateTowResponse extends Response {
    constructor(values: Values<GpsTimeUpdateTowResponse>);
    /** GPS time of week in whole seconds. Unit: s. */
    tow: number;
}

/**
 * Get device descriptors (extended) response (0x01,0x86).
 *
 * Response to `GetExtendedDescriptors`. Confirmed on 3DM-CV5-15, 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS,
 * 3DM-GQ7-GNSS/INS, 3DM-GX5-15, 3DM-GX5-35 and 3DM-GX5-45; likely or assumed on 12 more.
 *
 * - 3dm-gx5-15: 4.1.7 Get Extended Device Descriptor Sets (0x01, 0x07)
 * - 3dm-cv7-gnss-ins: Get device descriptors (extended) (0x01,0x07)
 */
export declare class GetExtendedDescriptorsResponse extends Response {
    constructor(values: Values<GetExtendedDescriptorsResponse>);
    /** Supported descriptors: the descriptor set in the high byte, the field descriptor in the low byte. */
    descriptors: number[];
}

/**
 * Continuous built-in test response (0x01,0x88).
 *
 * Also called `continuous_bit_response`. Response to `ContinuousBuiltInTest`. Confirmed on 3DM-CV7-AR and
 * 3DM-CV7-GNSS/INS; likely or assumed on 9 more.
 *
 * - 3dm-cv7-gnss-ins: Continuous built-in test (0x01,0x08)
 */
export declare class ContinuousBuiltInTestResponse extends Response {
    constructor(values: Values<ContinuousBuiltInTestResponse>);
    /**
     * Flags, defined by each device, least significant byte first: bit 8 is bit 0 of the second byte.
     *
     * - On the 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-INS, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-CX7-INS, 3DM-GV7-AHRS, 3DM-GV7-AR
     *   and 3DM-GV7-INS: values of `types.Cv7InertialContinuousBuiltInTest`.
     * - On the 3DM-CV7-GNSS/INS: values of `types.Cv7ContinuousBuiltInTest`.
     * - On the 3DM-GQ7-GNSS/INS: values of `types.Gq7ContinuousBuiltInTest` (inferred: the sources are about
     *   `system_data.BuiltInTest`, whose flags are the same on the 3DM-CV7-GNSS/INS).
     */
    result: number[];
}

/**
 * Comm port speed response (0x01,0x89).
 *
 * Response to `CommSpeed`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or
 * assumed on 8 more.
 *
 * - 3dm-cv7-gnss-ins: Comm Port Speed (0x01,0x09)
 */
export declare class CommSpeedResponse extends Response {
    constructor(values: Values<CommSpeedResponse>);
    /**
     * Port id of the device.
     *
     * - On the 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-GV7-AHRS and 3DM-GV7-AR: values of
     *   `types.CommInterface`; only `types.CommInterface.MAIN`, `types.CommInterface.UART_1` and
     *   `types.CommInterface.USB_1`.
     * - On the 3DM-CV7-GNSS/INS: values of `types.CommInterface`.
     * - On the 3DM-CV7-INS and 3DM-CX7-INS: values of `types.CommInterface`; only `types.CommInterface.MAIN`,
     *   `types.CommInterface.UART_1`, `types.CommInterface.UART_2`, `types.CommInterface.UART_3` and
     *   `types.CommInterface.USB_1`.
     * - On the 3DM-GQ7-GNSS/INS: 1 is the main port, 2 the auxiliary one.
     * - On the 3DM-GV7-INS: values of `types.CommInterface`; only `types.CommInterface.MAIN`,
     *   `types.CommInterface.UART_1`, `types.CommInterface.UART_2` and `types.CommInterface.USB_1`.
     * - On the 3DM-RTK: the values are unknown.
     */
    port: number;
    /** Baud rate of the port. Unit: Bd. */
    baud: number;
}

/**
 * Ping (0x01,0x01).
 *
 * Checks whether a device is present and replies to commands.
 *
 * Supported by all devices; confirmed on 3DM-CV5-10, 3DM-CV5-15, 3DM-CV7-GNSS/INS, 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15,
 * 3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * A device that is not in a normal operating mode may reject the command.
 *
 * - 3dm-gx5-15: 4.1.1 Ping (0x01, 0x01)
 * - 3dm-cv7-gnss-ins: Ping (0x01,0x01)
 */
export declare class Ping extends Command<undefined> {
    constructor();
}

/**
 * Set to idle (0x01,0x02).
 *
 * Stops all data streams, and wakes a sleeping device, so that it can be configured.
 *
 * Supported by all devices; confirmed on 3DM-CV5-10, 3DM-CV5-15, 3DM-CV7-GNSS/INS, 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15,
 * 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * `Resume` restores the previous mode. While idle, the device does not send NMEA sentences either.
 *
 * - 3dm-gx5-15: 4.1.2 Set To Idle (0x01, 0x02)
 * - 3dm-cv7-gnss-ins: Set to idle (0x01,0x02)
 */
export declare class SetIdle extends Command<undefined> {
    constructor();
}

/**
 * Get device information (0x01,0x03).
 *
 * Gets the firmware version and the identity strings of the device.
 *
 * Response: `GetDeviceInfoResponse`. Supported by all devices; confirmed on 3DM-CV5-10, 3DM-CV5-15, 3DM-CV7-GNSS/INS,
 * 3DM-CX5-10, 3DM-GQ4-45, 3DM-GQ7-GNSS/INS, 3DM-GX5-15, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * - 3dm-gx5-15: 4.1.3 Get Device Information (0x01, 0x03)
 * - 3dm-cv7-gnss-ins: Get device information (0x01,0x03)
 */
export declare class GetDeviceInfo extends Command<GetDeviceInfoResponse> {
    constructor();
}

/**
 * Get device descriptors (0x01,0x04).
 *
 * Gets the command and data descriptors that the device supports.
 *
 * Response: `GetDeviceDescriptorsResponse`. Supported by all devices; confirmed on 3DM-CV5-10, 3DM-CV5-15,
 * 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-CX5-10, 3DM-GQ4-45, 3DM-GQ7-GNSS/INS, 3DM-GX5-15, 3DM-GX5-35,
 * 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * If the list contains the descriptor of `GetExtendedDescriptors`, that command returns further descriptors.
 *
 * - 3dm-gx5-15: 4.1.4 Get Device Descriptor Sets (0x01, 0x04)
 * - 3dm-cv7-gnss-ins: Get device descriptors (0x01,0x04)
 */
export declare class GetDeviceDescriptors extends Command<GetDeviceDescriptorsResponse> {
    constructor();
}

/**
 * Built-in test (0x01,0x05).
 *
 * Runs the self test of the device and gets its result.
 *
 * Response: `BuiltInTestResponse`. The device may take 10 s to reply. Confirmed on 3DM-CV5-10, 3DM-CV5-15,
 * 3DM-CV7-GNSS/INS, 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 27 more.
 * Uncertain: The maximum duration of 10 s is assumed; the manual of the 3DM-CV7 states several seconds.
 *
 * The test interrupts normal operation for up to several seconds; no data is available meanwhile. The device must be at
 * rest; acceleration, rotation or vibration cause false failures. The continuous built-in test, if the device has it,
 * describes a failure in more detail.
 *
 * - 3dm-gx5-15: 4.1.5 Device Built-In Test (0x01, 0x05)
 * - 3dm-cv7-gnss-ins: Built in test (0x01,0x05)
 * - 3dm-cv7-gnss-ins: Commanded Built-in Test
 */
export declare class BuiltInTest extends Command<BuiltInTestResponse> {
    constructor();
}

/**
 * Resume (0x01,0x06).
 *
 * Ends idle mode and returns the device to the mode that it was in before.
 *
 * Supported by all devices; confirmed on 3DM-CV5-10, 3DM-CV5-15, 3DM-CV7-GNSS/INS, 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15,
 * 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * If the device was not idle, it enters its default mode (3DM-GX5-15).
 *
 * - 3dm-gx5-15: 4.1.6 Resume (0x01, 0x06)
 * - 3dm-cv7-gnss-ins: Resume (0x01,0x06)
 */
export declare class Resume extends Command<undefined> {
    constructor();
}

/**
 * Get device descriptors (extended) (0x01,0x07).
 *
 * Gets the supported descriptors that did not fit into the reply of `GetDeviceDescriptors`.
 *
 * Response: `GetExtendedDescriptorsResponse`. Confirmed on 3DM-CV5-15, 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS,
 * 3DM-GQ7-GNSS/INS, 3DM-GX5-15, 3DM-GX5-35 and 3DM-GX5-45; likely or assumed on 12 more.
 *
 * Some devices lack this command; `GetDeviceDescriptors` lists it if the device has it.
 *
 * - 3dm-gx5-15: 4.1.7 Get Extended Device Descriptor Sets (0x01, 0x07)
 * - 3dm-cv7-gnss-ins: Get device descriptors (extended) (0x01,0x07)
 */
export declare class GetExtendedDescriptors extends Command<GetExtendedDescriptorsResponse> {
    constructor();
}

/**
 * Continuous built-in test (0x01,0x08).
 *
 * Gets the flags of the tests that run all the time. It does not interrupt operation.
 *
 * Also called `continuous_bit`. Response: `ContinuousBuiltInTestResponse`. Confirmed on 3DM-CV7-AR and
 * 3DM-CV7-GNSS/INS; likely or assumed on 9 more.
 *
 * It is less thorough than `BuiltInTest`. Each flag stays set until this command reports it; the streamed field has its
 * own copy of the flags. The self-test flags change only when `BuiltInTest` runs.
 *
 * - 3dm-cv7-gnss-ins: Continuous built-in test (0x01,0x08)
 */
export declare class ContinuousBuiltInTest extends Command<ContinuousBuiltInTestResponse> {
    constructor();
}

/**
 * Comm port speed (0x01,0x09).
 *
 * Sets the baud rate of one communication port.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `CommSpeedResponse`. Devices without it may have
 * `3dm.UartBaudRate`. Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed
 * on 8 more.
 *
 * The change takes effect once pending data is sent and received, after at most 250 ms. Send it alone in a packet while
 * the device is idle, and wait 250 ms before you continue. Commands and data during the change may be lost, or sent at
 * either rate.
 *
 * - 3dm-cv7-gnss-ins: Comm Port Speed (0x01,0x09)
 */
export declare class CommSpeed<R extends Response | undefined = undefined | CommSpeedResponse> extends Command<R> {
    constructor(values: Values<CommSpeed>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Port id of the device; 0 means all ports, and is for save, load and default only.
     *
     * - On the 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-GV7-AHRS and 3DM-GV7-AR: values of
     *   `types.CommInterface`; only `types.CommInterface.MAIN`, `types.CommInterface.UART_1` and
     *   `types.CommInterface.USB_1`.
     * - On the 3DM-CV7-GNSS/INS: values of `types.CommInterface`.
     * - On the 3DM-CV7-INS and 3DM-CX7-INS: values of `types.CommInterface`; only `types.CommInterface.MAIN`,
     *   `types.CommInterface.UART_1`, `types.CommInterface.UART_2`, `types.CommInterface.UART_3` and
     *   `types.CommInterface.USB_1`.
     * - On the 3DM-GQ7-GNSS/INS: 1 is the main port, 2 the auxiliary one.
     * - On the 3DM-GV7-INS: values of `types.CommInterface`; only `types.CommInterface.MAIN`,
     *   `types.CommInterface.UART_1`, `types.CommInterface.UART_2` and `types.CommInterface.USB_1`.
     * - On the 3DM-RTK: the values are unknown.
     */
    port?: number;
    /** New baud rate; the port must support it. Unit: Bd. Required for `write`. */
    baud?: number;
    /** Apply the new setting. */
    static write(values: { port: number; baud: number }): CommSpeed<undefined>;
    /** Return the current setting in a response. */
    static read(values: { port: number }): CommSpeed<CommSpeedResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(values: { port: number }): CommSpeed<undefined>;
    /** Load the saved setting. */
    static load(values: { port: number }): CommSpeed<undefined>;
    /** Load the factory default setting. */
    static default(values: { port: number }): CommSpeed<undefined>;
}

/**
 * GPS time update (0x01,0x72).
 *
 * Sets the week number or the time of week of the external (GPS) time.
 *
 * Functions: `write`, `read` and `apply`. Response: `GpsTimeUpdateWeekNumberResponse` or `GpsTimeUpdateTowResponse`.
 * Affects `filter_data.Timestamp`, `sensor.GpsTimestamp`, `shared.GpsTimestamp` and `shared.ExternalTimestamp`.
 * Confirmed on 3DM-CV5-10, 3DM-CV5-15, 3DM-CV7-GNSS/INS, 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15 and 3DM-GX5-35; likely or
 * assumed on 16 more. On the 3DM-CV7-GNSS/INS: `write` only.
 *
 * Send it once for the time of week and once for the week number after the PPS is locked. On the 3DM-CV7-GNSS/INS, the
 * time may have a different epoch from GPS time, for example the Unix epoch; `shared.ExternalTimestamp` then has the
 * same epoch. The PPS supplies the fraction of the second; send the whole second that began at its last edge. Send it
 * within 250 ms after the rising edge of the PPS. Once per second is recommended for the 3DM-GX5-15; the
 * 3DM-CV7-GNSS/INS needs it at least once. Send it again after a PPS glitch. It is usually not needed if an internal
 * GNSS receiver is the PPS source.
 *
 * - 3dm-gx5-15: 4.1.8 GPS Time Update (0x01, 0x72)
 * - 3dm-cv7-gnss-ins: GPS Time Update Command (0x01,0x72)
 * - 3dm-cv7-gnss-ins: Timestamps
 */
export declare class GpsTimeUpdate<R extends Response | undefined = undefined | GpsTimeUpdateWeekNumberResponse | GpsTimeUpdateTowResponse> extends Command<R> {
    constructor(values: Values<GpsTimeUpdate>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Meaning of the value. */
    fieldId?: GpsTimeField;
    /**
     * Week or seconds, as selected by `field_id`. Required for `write` and `apply`.
     *
     * - If `fieldId` is `GpsTimeField.WEEK_NUMBER`: unit week. GPS week number since 6 January 1980.
     * - If `fieldId` is `GpsTimeField.TOW`: unit s. Whole seconds of the GPS week.
     */
    value?: number;
    /** Apply the new setting. */
    static write(values: { fieldId: GpsTimeField; value: number }): GpsTimeUpdate<undefined>;
    /** Return the current setting in a response. */
    static read(values: { fieldId: GpsTimeField }): GpsTimeUpdate<GpsTimeUpdateWeekNumberResponse | GpsTimeUpdateTowResponse>;
    /** Apply the new setting without sending an ACK (5-series devices). */
    static apply(values: { fieldId: GpsTimeField; value: number }): GpsTimeUpdate<undefined>;
}

/**
 * Reset device (0x01,0x7E).
 *
 * Acknowledges the command, then resets the device immediately.
 *
 * Confirmed on 3DM-CV5-10, 3DM-CV5-15, 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15,
 * 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST; likely or assumed on 18 more.
 *
 * - 3dm-gx5-15: 4.1.9 Device Reset (0x01, 0x7E)
 * - 3dm-cv7-gnss-ins: Reset device (0x01,0x7E)
 */
export declare class SoftReset extends Command<undefined> {
    constructor();
}
