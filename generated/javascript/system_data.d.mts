/**
 * System data (0xA0).
 *
 * State of the device as a whole.
 *
 * - 3dm-cv7-gnss-ins: System (0xA0)
 */
import type { Bitfield, Command, Data, Enumeration, Flavor, Response, Values } from "./mip/index.mjs";
import type { FunctionSelector } from "./protocol.mjs";
import type * as types from "./types.mjs";

export type GpioPinStates = Flavor<number, "system_data.gpio_pin_states">;
/** Level of each GPIO pin, set for high. Bits of pins that do not exist read 0. */
export declare const GpioPinStates: Bitfield<GpioPinStates> & {
    /** GPIO pin 1 is high. Bit 0. */
    readonly PIN_1: GpioPinStates;
    /** GPIO pin 2 is high. Bit 1. */
    readonly PIN_2: GpioPinStates;
    /** GPIO pin 3 is high. Bit 2. */
    readonly PIN_3: GpioPinStates;
    /** GPIO pin 4 is high. Bit 3. */
    readonly PIN_4: GpioPinStates;
};

/**
 * Built-in test (0xA0,0x01).
 *
 * Flags of the tests that run all the time.
 *
 * Confirmed on 3DM-CV7-AR, 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed on 8 more. Requires firmware later
 * than 1.0.10 on the 3DM-GQ7-GNSS/INS.
 *
 * The field is long; stream it at a low rate or poll it. A fault that has passed before the next message is still
 * reported, because its flag stays set until it is sent. Each stream and each event action keeps its own copy of the
 * flags. Some flags may be set without a fault, for instance a receiver without a position fix. Unnamed bits are
 * reserved and must be ignored.
 *
 * - 3dm-cv7-gnss-ins: Built In Test (0xA0,0x01)
 */
export declare class BuiltInTest extends Data {
    constructor(values: Values<BuiltInTest>);
    /**
     * Flags, defined by each device, least significant byte first: bit 8 is bit 0 of the second byte.
     *
     * - On the 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-INS, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-CX7-INS, 3DM-GV7-AHRS, 3DM-GV7-AR
     *   and 3DM-GV7-INS: values of `types.Cv7InertialContinuousBuiltInTest`.
     * - On the 3DM-CV7-GNSS/INS: values of `types.Cv7ContinuousBuiltInTest`.
     * - On the 3DM-GQ7-GNSS/INS: values of `types.Gq7ContinuousBuiltInTest`.
     */
    result: number[];
}

/**
 * Time sync status (0xA0,0x02).
 *
 * Synchronization of the device time with the pulse per second.
 *
 * Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 8 more. Requires firmware later than
 * 1.0.10 on the 3DM-GQ7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Time Sync Status (0xA0,0x02)
 */
export declare class TimeSyncStatus extends Data {
    constructor(values: Values<TimeSyncStatus>);
    /** True while the lock is valid; false if the PPS is disabled or no pulse is found. */
    timeSync: boolean;
    /** Time since the last pulse, at most 255. Unit: s. */
    lastPpsReceived: number;
}

/**
 * GPIO state (0xA0,0x03).
 *
 * Levels of all user GPIO pins.
 *
 * Confirmed on 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 9 more. Requires firmware later than 1.0.10 on the
 * 3DM-GQ7-GNSS/INS.
 *
 * A pulse that is shorter than the period at which the field is sent is missed. The pins are sampled within one base
 * period of this set. Levels are guaranteed to be valid only for pins that `3dm.GpioConfig` configures for the GPIO
 * feature. For fast signals and exact times use the timestamp feature and the event system.
 *
 * - 3dm-cv7-gnss-ins: GPIO State (0xA0,0x03)
 */
export declare class GpioState extends Data {
    constructor(values: Values<GpioState>);
    /** One bit for each pin. */
    states: GpioPinStates;
}

/**
 * GPIO analog value (0xA0,0x04).
 *
 * Voltage at one GPIO pin.
 *
 * Not listed in any device profile. Known only from the MicroStrain MIP SDK.
 *
 * The pin must be configured as an analog input.
 *
 * - mip-sdk-4: GPIO analog value (0xA0,0x04)
 */
export declare class GpioAnalogValue extends Data {
    constructor(values: Values<GpioAnalogValue>);
    /** GPIO pin, counted from 1. Range: at least 1. */
    gpioId: number;
    /** Scaled voltage. Unit: V. */
    value: number;
}
