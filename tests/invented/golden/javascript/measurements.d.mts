/**
 * Measurements (0x80, 0x81, 0x92).
 *
 * Data of every type; `tools` has what they are set up with.
 *
 * - measurements (0x80): Data of every type; `tools` has what they are set up with.
 * - more (0x81): A second sensor with some fields of the first.
 * - copy (0x92): All the fields of another set. Uncertain: Which device sends it.
 */
import type { Bitfield, Command, Data, Enumeration, Flavor, Response, Values } from "./mip/index.mjs";
import type { FunctionSelector } from "./protocol.mjs";
import type * as types from "./types.mjs";

/**
 * Acceleration (0x01).
 *
 * A vector whose elements are valid together.
 *
 * Occurs in measurements (0x80), more (0x81) and copy (0x92). Maximum rate: 100 Hz. Supported by Model A, Model B and
 * Model C. On the Model C: firmware > 1.0.07.
 *
 * - guide: Acceleration
 * - leaflet: Acceleration
 * - guide: Second acceleration
 * - guide: Third acceleration
 */
export declare class Accel extends Data {
    constructor(values: Values<Accel>);
    /**
     * Specific force. Elements: x, y, z. Unit: g. Frame: sensor. At rest and level: x 0, z -1. Positive: along
     * `types.Point`. Each element has its own valid flag. x: `types.StateFlags.READY` of `validFlags`, y:
     * `types.StateFlags.HOT` of `validFlags`, z: `types.StateFlags.READY` of `validFlags`.
     *
     * - On the Model B: unit m, m, s; frame ned; valid flags x: `types.StateFlags.HOT` of `validFlags`, y:
     *   `types.StateFlags.READY` of `validFlags`, z: `types.StateFlags.HOT` of `validFlags`. Turned by the device.
     * - On the Model C: no flag marks it as valid.
     */
    scaledAccel: types.Vector3f;
    /**
     * What is valid.
     *
     * - On the Model C: only `types.StateFlags.READY` and `types.StateFlags.LEVEL`.
     */
    validFlags: types.StateFlags;
}

/**
 * Numbers (0x02).
 *
 * One of each.
 *
 * Occurs in measurements (0x80) and copy (0x92). Supported by Model A and Model C.
 *
 * - guide: Numbers
 */
export declare class Numbers extends Data {
    constructor(values: Values<Numbers>);
    /** Unsigned. */
    u8: number;
    /** Unsigned. */
    u16: number;
    /** Unsigned. */
    u32: number;
    /** Unsigned. */
    u64: bigint;
    /** Signed. */
    s8: number;
    /** Signed. */
    s16: number;
    /** Signed. */
    s32: number;
    /** Signed. */
    s64: bigint;
    /** Four bytes. Unit: 1. */
    float: number;
    /** Eight bytes. Unit: 1. */
    double: number;
    /** True or false. */
    bool: boolean;
    /** One character. */
    char: number;
}

/**
 * Strings (0x03).
 *
 * Fixed, counted, and to the end.
 *
 * Occurs in measurements (0x80), more (0x81) and copy (0x92). Supported by Model A and Model C.
 *
 * - guide: Strings
 * - guide: Second strings
 */
export declare class Strings extends Data {
    constructor(values: Values<Strings>);
    /** Padded with spaces. */
    model: string;
    /** On the wire only: length. Of the name. Counts the elements of `name`. */
    /** The name. */
    name: string;
    /** All that follows. */
    rest: string;
}

/**
 * Health (0x04).
 *
 * The wide bitfield.
 *
 * Deprecated: use `Numbers` instead. Occurs in measurements (0x80) and copy (0x92). Supported by Model A and Model C.
 *
 * - guide: Health
 */
export declare class Health extends Data {
    constructor(values: Values<Health>);
    /** The bits. */
    result: types.Health;
    /** An enumeration over four bytes. */
    code: types.WideCode;
}

/**
 * Arrays (0x05).
 *
 * Arrays of all that can stand in one.
 *
 * Occurs in measurements (0x80) and copy (0x92). Supported by Model A and Model C.
 *
 * - guide: Arrays
 */
export declare class Arrays extends Data {
    constructor(values: Values<Arrays, "offsets">);
    /** Enumerations. */
    modes: types.Mode[];
    /** Bitfields. */
    flags: types.StateFlags[];
    /** Vectors. Elements: x, y, z. Unit: m. */
    vectors: types.Vector3f[];
    /** Structures. Unit: m. */
    points: types.Point[];
    /** A nested structure. */
    track: types.Segment;
    /** Reserved. */
    offsets: [number, number, number, number];
}

/**
 * Growing (0x06).
 *
 * Newer devices send more of it.
 *
 * Occurs in measurements (0x80) and copy (0x92). Supported by Model A and Model C.
 *
 * - guide: Growing
 */
export declare class Growing extends Data {
    constructor(values: Values<Growing>);
    /** Always there. */
    first: number;
    /** From version 2 on. Optional. */
    second?: number;
    /** From version 3 on. Unit: deg. Optional. */
    third?: number;
}

/**
 * Radio (0x07).
 *
 * A bool vouches for values; one source has no layout that agrees with it.
 *
 * Occurs in measurements (0x80) and copy (0x92). Also called `modem` and `rf`. Supported by Model C. Known only from
 * the Kit of names. Uncertain: The leaflet gives the strength two bytes. Uncertain: Inferred: the strength is never
 * positive.
 *
 * - sheet: Radio
 */
export declare class Radio extends Data {
    constructor(values: Values<Radio, "gap" | "gaps">);
    /** Whether there is a connection. */
    connected: boolean;
    /** Of the signal. Range: less than 1. Valid if `connected` is true. Uncertain: Its unit. */
    strength: number;
    /**
     * Never nothing. Unit: m. Range: greater than 0, at most 10. Valid if `connected` is true.
     *
     * - On the Model C: valid if `connected` is true; deprecated.
     */
    noise: number;
    /** Reserved. Reserved. */
    gap: number;
    /** Reserved. */
    gaps: [number, number];
}

/**
 * Own (0x81,0x07).
 *
 * In one of the sets only, with a descriptor that has another layout in the others.
 *
 * Supported by Model A and Model C. On the Model C: firmware > 1.0.07.
 *
 * - guide: Own
 */
export declare class Own extends Data {
    constructor(values: Values<Own>);
    /** Of the second sensor. */
    mode: types.Mode;
}

/**
 * Cloud (0x08).
 *
 * The count can exceed what a field holds beside the value behind the array.
 *
 * Occurs in measurements (0x80) and copy (0x92). Supported by Model A and Model C.
 *
 * - guide: Cloud
 */
export declare class Cloud extends Data {
    constructor(values: Values<Cloud>);
    /** On the wire only: num_points. Number of points. Counts the elements of `points`. */
    /** The points. */
    points: types.Point[];
    /** Behind an array that fills the field. Unit: s. */
    stamp: bigint;
}

/**
 * Gust (0x09).
 *
 * One valid flag for all values but one; `Breeze` has the same place.
 *
 * Occurs in measurements (0x80) and copy (0x92). Not listed in any device profile.
 *
 * `speed * 3.6` is in km/h, and `valid_flags` tells whether `speed` counts; see `types.Mode` and `tools_.Shape`.
 *
 * - guide: Gust
 */
export declare class Gust extends Data {
    constructor(values: Values<Gust>);
    /** Which one. */
    station: number;
    /** Where it was measured. Valid if `types.StateFlags.READY` of `validFlags` is set. */
    place: types.Point;
    /** Above the plane. Unit: m. Valid if `types.StateFlags.READY` of `validFlags` is set. */
    height: number;
    /**
     * Of the wind. Elements: x, y, z. Unit: m. Range: magnitude at most 40. Valid if `types.StateFlags.READY` of
     * `validFlags` is set.
     */
    speed: types.Vector3f;
    /** On the wire only: gap. Always the same. Always 7. */
    /** What is valid. */
    validFlags: types.StateFlags;
}

/**
 * Breeze (0x0A).
 *
 * Its place is told as in `Gust`.
 *
 * Occurs in measurements (0x80) and copy (0x92). Supported by Model A and Model C.
 *
 * - guide: Breeze
 */
export declare class Breeze extends Data {
    constructor(values: Values<Breeze>);
    /** Where it was measured. */
    place: types.Point;
    /** Above the plane. Unit: m. */
    height: number;
    /** Of the vane. Elements: w, x, y, z. Unit: 1. Range: -1 to 1, magnitude 0.5 to 1.5. Default: 1, 0, 0, 0. */
    turn: types.Quatf;
}
