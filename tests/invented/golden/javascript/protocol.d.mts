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
    /** Send the current setting back in a response. */
    readonly READ: FunctionSelector & 2;
    /** Save the current setting to non-volatile memory. */
    readonly SAVE: FunctionSelector & 3;
    /** Load the saved setting. */
    readonly LOAD: FunctionSelector & 4;
    /** Load the factory default setting. */
    readonly DEFAULT: FunctionSelector & 5;
    /** Apply the new setting and send no acknowledge (5-series devices). */
    readonly APPLY: FunctionSelector & 6;
};

/**
 * Acknowledge (0x00,0xF1).
 *
 * Answers one command field. A response, if there is one, follows it in the same packet.
 *
 * - guide: Acknowledge
 */
export declare class Acknowledge extends Response {
    constructor(values: Values<Acknowledge>);
    /** Descriptor of the command that is answered. */
    command: number;
    /**
     * Zero acknowledges, any other value refuses.
     *
     * - On the Model B: values of `types.Mode`.
     */
    code: types.AckCode;
}
