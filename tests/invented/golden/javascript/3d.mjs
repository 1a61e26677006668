// Awkward names: the names and layouts of its fields. The declarations describe their meaning.

import * as codec from "./mip/codec.mjs";
import * as field from "./mip/field.mjs";
import { FunctionSelector } from "./protocol.mjs";
import * as tools_ from "./tools_.mjs";
import * as types from "./types.mjs";

export const Default = /* @__PURE__ */ field.command("3d.default", 0x0c, 0x10, {
    class: codec.u8,
    type: codec.u8,
    register: codec.u8,
    self: codec.u8,
    present: codec.u8,
}, {
    SILENCED_BY: [[() => tools_.Settings, "mode", 1]],
});
