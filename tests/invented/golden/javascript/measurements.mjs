// Measurements: the names and layouts of its fields. The declarations describe their meaning.

import * as codec from "./mip/codec.mjs";
import * as field from "./mip/field.mjs";
import { FunctionSelector } from "./protocol.mjs";
import * as types from "./types.mjs";

export const Accel = /* @__PURE__ */ field.data("measurements.accel", [0x80, 0x81, 0x92], 0x01, (values, reader) => {
    values.scaledAccel = types.Vector3f(reader, 0);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { scaledAccel: [0x1, 0x2, 0x1] } }, [
        [["model-a"], 0xfffa, "validFlags", { validFlags: { scaledAccel: [0x4, 0x1, 0x4] } }],
        [["model-b"], 0x0, "validFlags", { validFlags: { scaledAccel: [0x2, 0x1, 0x2] } }],
        [["model-c"], 0x0, "validFlags", { validFlags: { scaledAccel: [] } }],
    ]),
});

export const Numbers = /* @__PURE__ */ field.data("measurements.numbers", [0x80, 0x92], 0x02, (values, reader) => {
    values.u8 = codec.u8(reader, 0);
    values.u16 = codec.u16(reader, 1);
    values.u32 = codec.u32(reader, 3);
    values.u64 = codec.u64(reader, 7);
    values.s8 = codec.s8(reader, 15);
    values.s16 = codec.s16(reader, 16);
    values.s32 = codec.s32(reader, 18);
    values.s64 = codec.s64(reader, 22);
    values.float = codec.float(reader, 30);
    values.double = codec.double(reader, 34);
    values.bool = codec.bool(reader, 42);
    values.char = codec.char(reader, 43);
});

export const Strings = /* @__PURE__ */ field.data("measurements.strings", [0x80, 0x81, 0x92], 0x03, {
    model: /* @__PURE__ */ codec.text(16),
    length: /* @__PURE__ */ codec.counter(codec.u8, "name"),
    name: /* @__PURE__ */ codec.countedText("length", 236),
    rest: /* @__PURE__ */ codec.restText(236),
});

export const Health = /* @__PURE__ */ field.data("measurements.health", [0x80, 0x92], 0x04, {
    result: types.Health,
    code: types.WideCode,
});

export const Arrays = /* @__PURE__ */ field.data("measurements.arrays", [0x80, 0x92], 0x05, {
    modes: /* @__PURE__ */ codec.array(types.Mode, 3),
    flags: /* @__PURE__ */ codec.array(types.StateFlags, 2),
    vectors: /* @__PURE__ */ codec.array(types.Vector3f, 2),
    points: /* @__PURE__ */ codec.array(types.Point, 2),
    track: types.Segment,
    offsets: /* @__PURE__ */ codec.reserved(/* @__PURE__ */ codec.array(/* @__PURE__ */ codec.reserved(codec.s8, 0), 4), Array(4).fill(0)),
});

export const Growing = /* @__PURE__ */ field.data("measurements.growing", [0x80, 0x92], 0x06, {
    first: codec.u16,
    second: codec.u16,
    third: codec.float,
}, {
    optional: 1,
});

export const Radio = /* @__PURE__ */ field.data("measurements.radio", [0x80, 0x92], 0x07, {
    connected: codec.bool,
    strength: codec.s32,
    noise: codec.float,
    gap: /* @__PURE__ */ codec.reserved(codec.float, 0.0),
    gaps: /* @__PURE__ */ codec.reserved(/* @__PURE__ */ codec.array(/* @__PURE__ */ codec.reserved(codec.double, 0.0), 2), Array(2).fill(0.0)),
}, {
    VALID: /* @__PURE__ */ field.validity({ connected: { strength: 0x0, noise: 0x0 } }),
});

export const Own = /* @__PURE__ */ field.data("measurements.own", 0x81, 0x07, (values, reader) => {
    values.mode = codec.u8(reader, 0);
});

export const Cloud = /* @__PURE__ */ field.data("measurements.cloud", [0x80, 0x92], 0x08, {
    numPoints: /* @__PURE__ */ codec.counter(codec.u8, "points"),
    points: /* @__PURE__ */ codec.counted("numPoints", types.Point, 61),
    stamp: codec.u64,
});

export const Gust = /* @__PURE__ */ field.data("measurements.gust", [0x80, 0x92], 0x09, {
    station: codec.u8,
    place: types.Point,
    height: codec.float,
    speed: types.Vector3f,
    gap: /* @__PURE__ */ codec.constant(codec.u8, 7),
    validFlags: types.StateFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { place: 0x1, height: 0x1, speed: 0x1 } }),
});

export const Breeze = /* @__PURE__ */ field.data("measurements.breeze", [0x80, 0x92], 0x0a, {
    place: types.Point,
    height: codec.float,
    turn: types.Quatf,
});
