// Displacement data: the names and layouts of its fields. The declarations describe their meaning.

import * as codec from "./mip/codec.mjs";
import * as field from "./mip/field.mjs";
import { FunctionSelector } from "./protocol.mjs";
import * as types from "./types.mjs";

export const TimestampFlags = /* @__PURE__ */ codec.bitfield(codec.u8, {
    TIME: [0, 0],
});

export const DisplacementRaw = /* @__PURE__ */ field.data("displacement_data.displacement_raw", 0x90, 0x01, (values, reader) => {
    values.counts = codec.u32(reader, 0);
});

export const Displacement = /* @__PURE__ */ field.data("displacement_data.displacement", 0x90, 0x02, (values, reader) => {
    values.displacement = codec.float(reader, 0);
});

export const Timestamp = /* @__PURE__ */ field.data("displacement_data.timestamp", 0x90, 0x04, (values, reader) => {
    values.flags = codec.u8(reader, 0);
    values.time = codec.u64(reader, 1);
}, {
    VALID: /* @__PURE__ */ field.validity({ flags: { time: 0x1 } }),
});
