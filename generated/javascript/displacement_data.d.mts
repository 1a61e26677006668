/**
 * Displacement data (0x90).
 *
 * Measurements of the DEMOD-DC, a digital demodulator for displacement sensors.
 *
 * - mscl: Displacement Data (0x90)
 */
import type { Bitfield, Command, Data, Enumeration, Flavor, Response, Values } from "./mip/index.mjs";
import type { FunctionSelector } from "./protocol.mjs";
import type * as types from "./types.mjs";

export type TimestampFlags = Flavor<number, "displacement_data.timestamp_flags">;
/**
 * Validity of the displacement timestamp. Uncertain: The number is possibly no bitfield, because MSCL considers the
 * time valid if it is 1.
 */
export declare const TimestampFlags: Bitfield<TimestampFlags> & {
    /** The clock has been set; `time` is valid. Bit 0. */
    readonly TIME: TimestampFlags;
};

/**
 * Raw displacement (0x90,0x01).
 *
 * Displacement in ADC counts.
 *
 * No device is known for certain to support it. Known only from the MicroStrain Communication Library.
 *
 * - mscl: Raw displacement (0x90,0x01)
 */
export declare class DisplacementRaw extends Data {
    constructor(values: Values<DisplacementRaw>);
    /** Output of the analog-to-digital converter. Unit: 1. */
    counts: number;
}

/**
 * Displacement (0x90,0x02).
 *
 * Displacement of the sensor, computed with its calibration.
 *
 * No device is known for certain to support it. Known only from the MicroStrain Communication Library.
 *
 * - mscl: Displacement (0x90,0x02)
 */
export declare class Displacement extends Data {
    constructor(values: Values<Displacement>);
    /** Position of the sensor along its axis. Unit: mm. */
    displacement: number;
}

/**
 * Displacement device timestamp (0x90,0x04).
 *
 * Time of the measurement by the clock of the device.
 *
 * No device is known for certain to support it. Also called `displacement_timestamp`. Known only from the MicroStrain
 * Communication Library.
 *
 * - mscl: Displacement device timestamp (0x90,0x04)
 */
export declare class Timestamp extends Data {
    constructor(values: Values<Timestamp>);
    /** Validity of the displacement timestamp. */
    flags: TimestampFlags;
    /**
     * UTC since 1970-01-01, without leap seconds, if the clock was set to it. Unit: ns. Valid if `TimestampFlags.TIME`
     * of `flags` is set.
     */
    time: bigint;
}
