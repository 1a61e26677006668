// Common to all command sets: function selectors and the acknowledge field.

import type { Enumeration, Flavor, Response, Values } from "./mip/index.mjs";
import type * as types from "./types.mjs";

export { AckCode } from "./types.mjs";

/** Set and descriptor of the command that `Client` uses as a barrier; zeros if the specification names none. */
export declare const BARRIER: readonly [set: number, descriptor: number];

export type FunctionSelector = Flavor<number, "function_selector">;
/** The operation that a settings command requests. */
export declare const FunctionSelector: Enumeration<FunctionSelector> & {
    /** Apply the new setting. */
    readonly WRITE: FunctionSelector & 1;
    /** Return the current setting in a response. */
    readonly READ: FunctionSelector & 2;
    /** Save the current setting to non-volatile memory. */
    readonly SAVE: FunctionSelector & 3;
    /** Load the saved setting. */
    readonly LOAD: FunctionSelector & 4;
    /** Load the factory default setting. */
    readonly DEFAULT: FunctionSelector & 5;
    /** Apply the new setting without sending an ACK (5-series devices). */
    readonly APPLY: FunctionSelector & 6;
};

/**
 * Acknowledge (0x00,0xF1).
 *
 * Replies to one command field. A response, if there is one, follows it in the same packet.
 *
 * - 3dm-gx5-15: 2.2.2 Example “Ping” Reply Packet
 * - 3dm-cv7-gnss-ins: Ack/Nack Field Specification
 */
export declare class Acknowledge extends Response {
    constructor(values: Values<Acknowledge>);
    /** Descriptor of the acknowledged command. */
    command: number;
    /** 0 (ACK) if the device carried out the command, otherwise the reason why it did not (NACK). */
    code: types.AckCode;
}
