// Shared: the names and layouts of its fields. The declarations describe their meaning.

import * as codec from "./mip/codec.mjs";
import * as field from "./mip/field.mjs";
import { FunctionSelector } from "./protocol.mjs";
import * as types from "./types.mjs";

export const Timestamp = /* @__PURE__ */ field.data("shared.timestamp", /* @__PURE__ */ field.every(0x80, 0xfe), 0xd3, {
    tow: codec.double,
    valid_flags: types.StateFlags,
});
