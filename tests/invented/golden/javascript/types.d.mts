// Types that several sets use.

import type { Bitfield, Enumeration, Flavor } from "./mip/index.mjs";

/** Three floats. Elements: x, y, z. */
export type Vector3f = [x: number, y: number, z: number];

/** A quaternion, scalar part first. Elements: w, x, y, z. */
export type Quatf = [w: number, x: number, y: number, z: number];

export type AckCode = Flavor<number, "ack_code">;
/** The result of a command. */
export declare const AckCode: Enumeration<AckCode> & {
    /** Done. */
    readonly OK: AckCode & 0;
    /** No such command. */
    readonly UNKNOWN_COMMAND: AckCode & 1;
    /** A parameter is out of range. */
    readonly INVALID_PARAMETER: AckCode & 3;
};

export type Mode = Flavor<number, "mode">;
/** What the device does. Uncertain: Whether there are more. */
export declare const Mode: Enumeration<Mode> & {
    /** A keyword in three languages. */
    readonly DEFAULT: Mode & 0;
    /** Quick. Uncertain: How quick. */
    readonly FAST: Mode & 1;
    /** Careful. Deprecated. */
    readonly SLOW: Mode & 2;
};

export type WideCode = Flavor<number, "wide_code">;
/** An enumeration over four bytes. */
export declare const WideCode: Enumeration<WideCode> & {
    readonly LOW: WideCode & 1;
    readonly HIGH: WideCode & 4294901760;
};

export type StateFlags = Flavor<number, "state_flags">;
/** Bits of all kinds. */
export declare const StateFlags: Bitfield<StateFlags> & {
    /** Ready to measure. Bit 0. */
    readonly READY: StateFlags;
    /** Too hot. Bit 1. Uncertain: The limit; 85 degrees is likely. */
    readonly HOT: StateFlags;
    /** A number from 0 to 7. Bits 4 to 6. */
    readonly LEVEL: StateFlags;
    /** An enumeration inside the bitfield. Bits 8 to 9. A value of `Mode`. */
    readonly MODE: StateFlags;
    /** Ready or hot. Bits 0 to 1. Overlaps other bits. */
    readonly ANY: StateFlags;
};

export type Health = Flavor<bigint, "health">;
/** One hundred and twenty-eight bits, least significant byte first. */
export declare const Health: Bitfield<Health> & {
    /** The clock has failed. Bit 0. */
    readonly CLOCK: Health;
    /** Too hot. Bit 1. Uncertain: The limit; 85 degrees is likely. */
    readonly HOT: Health;
    /** A number from 0 to 7. Bits 4 to 6. */
    readonly LEVEL: Health;
    /** The supply is out of range. Bit 9. */
    readonly POWER: Health;
    /** A number across two bytes. Bits 30 to 33. */
    readonly COUNT: Health;
    /** The very last bit. Bit 127. */
    readonly LAST: Health;
};

/** A place in a plane. */
export interface Point {
    /** Eastward. Unit: m. */
    x: number;
    /** Northward. Unit: m. */
    y: number;
}

/** Two places, nested. */
export interface Segment {
    /** Begins here. */
    from: Point;
    /** Ends here. */
    to: Point;
    /** Of its ends. */
    weights: [number, number];
}
