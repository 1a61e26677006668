/**
 * Shared (0xFF).
 *
 * Valid in every data set.
 */
import type { Bitfield, Command, Data, Enumeration, Flavor, Response, Values } from "./mip/index.mjs";
import type { FunctionSelector } from "./protocol.mjs";
import type * as types from "./types.mjs";

/**
 * Timestamp (0xFF,0xD3).
 *
 * When the packet was sent.
 *
 * Supported by Model A and Model C.
 *
 * - guide: Timestamp
 */
export declare class Timestamp extends Data {
    constructor(values: Values<Timestamp>);
    /** Time of week. Unit: s. Valid if `types.StateFlags.READY` of `validFlags` is set. */
    tow: number;
    /** What is valid. */
    validFlags: types.StateFlags;
}
