/**
 * Awkward names (0x0C).
 *
 * Names that are keywords or begin with a digit.
 */
import type { Bitfield, Command, Data, Enumeration, Flavor, Response, Values } from "./mip/index.mjs";
import type { FunctionSelector } from "./protocol.mjs";
import type * as types from "./types.mjs";

/**
 * Default (0x0C,0x10).
 *
 * Its parameters are keywords here and there.
 *
 * Not acknowledged if `mode` of `tools_.Settings` is `types.Mode.FAST`. Supported by Model A.
 *
 * - guide: Default
 */
export declare class Default extends Command<undefined> {
    constructor(values: Values<Default>);
    /** A keyword. */
    class: number;
    /** A keyword. */
    type: number;
    /** A keyword. */
    register: number;
    /** A keyword. */
    self: number;
    /** Used by generated code elsewhere. */
    present: number;
}
