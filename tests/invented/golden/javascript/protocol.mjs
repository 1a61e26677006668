// Common to all command sets: function selectors and the acknowledge field.

import * as codec from "./mip/codec.mjs";
import * as field from "./mip/field.mjs";
import * as types from "./types.mjs";

export { AckCode } from "./types.mjs";

/** Set and descriptor of the command that `Client` uses as a barrier; zeros if the specification names none. */
export const BARRIER = [0x01, 0x01];

export const FunctionSelector = /* @__PURE__ */ codec.enumeration(codec.u8, {
    WRITE: 1,
    READ: 2,
    SAVE: 3,
    LOAD: 4,
    DEFAULT: 5,
    APPLY: 6,
});

export const Acknowledge = /* @__PURE__ */ field.response("protocol.acknowledge", /* @__PURE__ */ field.every(0x01, 0x7f), 0xf1, {
    command: codec.u8,
    code: types.AckCode,
});
