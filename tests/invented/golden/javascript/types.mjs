// Types that several sets use.

import * as codec from "./mip/codec.mjs";

export const Vector3f = /* @__PURE__ */ codec.array(codec.float, 3);

export const Quatf = /* @__PURE__ */ codec.array(codec.float, 4);

export const AckCode = /* @__PURE__ */ codec.enumeration(codec.u8, {
    OK: 0,
    UNKNOWN_COMMAND: 1,
    INVALID_PARAMETER: 3,
});

export const Mode = /* @__PURE__ */ codec.enumeration(codec.u8, {
    DEFAULT: 0,
    FAST: 1,
    SLOW: 2,
});

export const WideCode = /* @__PURE__ */ codec.enumeration(codec.u32, {
    LOW: 1,
    HIGH: 4294901760,
});

export const StateFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    READY: [0, 0],
    HOT: [1, 1],
    LEVEL: [4, 6],
    MODE: [8, 9],
    ANY: [0, 1],
});

export const Health = /* @__PURE__ */ codec.bitfield(/* @__PURE__ */ codec.octets(16), {
    CLOCK: [0, 0],
    HOT: [1, 1],
    LEVEL: [4, 6],
    POWER: [9, 9],
    COUNT: [30, 33],
    LAST: [127, 127],
});

export const Point = /* @__PURE__ */ codec.struct({
    x: codec.s16,
    y: codec.s16,
});

export const Segment = /* @__PURE__ */ codec.struct({
    from: Point,
    to: Point,
    weights: /* @__PURE__ */ codec.array(codec.u8, 2),
});
