/**
 * Displacement commands (0x11).
 *
 * Commands of the DEMOD-DC, a demodulator for displacement sensors. Inertial sensors do not support them.
 *
 * - mscl: Displacement Commands (0x11)
 */
import type { Bitfield, Command, Data, Enumeration, Flavor, Response, Values } from "./mip/index.mjs";
import type { FunctionSelector } from "./protocol.mjs";
import type * as types from "./types.mjs";

/**
 * Get analog to displacement calibration response (0x11,0x81).
 *
 * No device is known for certain to support it. Also called `get_analog_displacement_calibration_response`. Response to
 * `GetCalibration`. Known only from the MicroStrain Communication Library.
 *
 * - mscl: Get analog to displacement calibration (0x11,0x01)
 */
export declare class GetCalibrationResponse extends Response {
    constructor(values: Values<GetCalibrationResponse>);
    /** Displacement per ADC count. Uncertain: No source states the unit; mm per count is likely. */
    slope: number;
    /** Displacement at zero counts. Uncertain: No source states the unit; mm is likely. */
    offset: number;
}

/**
 * Displacement output data rate response (0x11,0x82).
 *
 * No device is known for certain to support it. Also called `displacement_output_rate_response`. Response to
 * `OutputRate`. Known only from the MicroStrain Communication Library.
 *
 * - mscl: Displacement output data rate (0x11,0x02)
 */
export declare class OutputRateResponse extends Response {
    constructor(values: Values<OutputRateResponse>);
    /** Rate of displacement data. Unit: Hz. */
    rate: number;
}

/**
 * Get analog to displacement calibration (0x11,0x01).
 *
 * Reads the slope and offset with which the device converts ADC counts to displacement.
 *
 * No device is known for certain to support it. Also called `get_analog_displacement_calibration`. Response:
 * `GetCalibrationResponse`. Known only from the MicroStrain Communication Library.
 *
 * - mscl: Get analog to displacement calibration (0x11,0x01)
 */
export declare class GetCalibration extends Command<GetCalibrationResponse> {
    constructor();
}

/**
 * Displacement output data rate (0x11,0x02).
 *
 * Reads the rate at which displacement is measured.
 *
 * No device is known for certain to support it. Also called `displacement_output_rate`. Functions: `read`. Response:
 * `OutputRateResponse`. Known only from the MicroStrain Communication Library. Uncertain: MSCL only reads the rate; a
 * write may not be supported.
 *
 * - mscl: Displacement output data rate (0x11,0x02)
 */
export declare class OutputRate extends Command<OutputRateResponse> {
    constructor(values: Values<OutputRate>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Return the current setting in a response. */
    static read(): OutputRate;
}

/**
 * Displacement device time (0x11,0x04).
 *
 * Sets the clock of the device, from which `displacement_data.Timestamp` is taken.
 *
 * No device is known for certain to support it. Also called `displacement_device_time`. Functions: `write`. Affects
 * `displacement_data.Timestamp`. Known only from the MicroStrain Communication Library. Uncertain: MSCL only writes the
 * time; a read may not be supported.
 *
 * - mscl: Displacement device time (0x11,0x04)
 */
export declare class DeviceTime extends Command<undefined> {
    constructor(values: Values<DeviceTime>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** UTC since 1970-01-01, without leap seconds. Unit: ns. */
    time?: bigint;
    /** Apply the new setting. */
    static write(values: { time: bigint }): DeviceTime;
}
