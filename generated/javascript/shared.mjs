// Shared data: the names and layouts of its fields. The declarations describe their meaning.

import * as codec from "./mip/codec.mjs";
import * as field from "./mip/field.mjs";
import { FunctionSelector } from "./protocol.mjs";
import * as types from "./types.mjs";

export const GpsTimestampFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    TOW: [0, 0],
    WEEK_NUMBER: [1, 1],
    TIME_VALID: [0, 1],
});

export const ExternalTimestampFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    NANOSECONDS: [0, 0],
});

export const ExternalTimeDeltaFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    DT_NANOS: [0, 0],
});

export const EventSource = /* @__PURE__ */ field.data("shared.event_source", /* @__PURE__ */ field.every(0x80, 0xfe), 0xd0, (values, reader) => {
    values.triggerId = codec.u8(reader, 0);
});

export const Ticks = /* @__PURE__ */ field.data("shared.ticks", /* @__PURE__ */ field.every(0x80, 0xfe), 0xd1, (values, reader) => {
    values.ticks = codec.u32(reader, 0);
});

export const DeltaTicks = /* @__PURE__ */ field.data("shared.delta_ticks", /* @__PURE__ */ field.every(0x80, 0xfe), 0xd2, (values, reader) => {
    values.ticks = codec.u32(reader, 0);
});

export const GpsTimestamp = /* @__PURE__ */ field.data("shared.gps_timestamp", /* @__PURE__ */ field.every(0x80, 0xfe), 0xd3, (values, reader) => {
    values.tow = codec.double(reader, 0);
    values.weekNumber = codec.u16(reader, 8);
    values.validFlags = codec.u16(reader, 10);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { tow: 0x1, weekNumber: 0x2 } }),
});

export const DeltaTime = /* @__PURE__ */ field.data("shared.delta_time", /* @__PURE__ */ field.every(0x80, 0xfe), 0xd4, (values, reader) => {
    values.seconds = codec.double(reader, 0);
});

export const ReferenceTimestamp = /* @__PURE__ */ field.data("shared.reference_timestamp", /* @__PURE__ */ field.every(0x80, 0xfe), 0xd5, (values, reader) => {
    values.nanoseconds = codec.u64(reader, 0);
});

export const ReferenceTimeDelta = /* @__PURE__ */ field.data("shared.reference_time_delta", /* @__PURE__ */ field.every(0x80, 0xfe), 0xd6, (values, reader) => {
    values.dtNanos = codec.u64(reader, 0);
});

export const ExternalTimestamp = /* @__PURE__ */ field.data("shared.external_timestamp", /* @__PURE__ */ field.every(0x80, 0xfe), 0xd7, (values, reader) => {
    values.nanoseconds = codec.u64(reader, 0);
    values.validFlags = codec.u16(reader, 8);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { nanoseconds: 0x1 } }),
});

export const ExternalTimeDelta = /* @__PURE__ */ field.data("shared.external_time_delta", /* @__PURE__ */ field.every(0x80, 0xfe), 0xd8, (values, reader) => {
    values.dtNanos = codec.u64(reader, 0);
    values.validFlags = codec.u16(reader, 8);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { dtNanos: 0x1 } }),
});
