// Displacement commands: the names and layouts of its fields. The declarations describe their meaning.

import * as codec from "./mip/codec.mjs";
import * as field from "./mip/field.mjs";
import { FunctionSelector } from "./protocol.mjs";
import * as types from "./types.mjs";

export const GetCalibrationResponse = /* @__PURE__ */ field.response("displacement.get_calibration_response", 0x11, 0x81, {
    slope: codec.float,
    offset: codec.float,
});

export const OutputRateResponse = /* @__PURE__ */ field.response("displacement.output_rate_response", 0x11, 0x82, {
    rate: codec.u32,
});

export const GetCalibration = /* @__PURE__ */ field.command("displacement.get_calibration", 0x11, 0x01, {}, {
    REPLIES: [[null, [], [GetCalibrationResponse]]],
});

export const OutputRate = /* @__PURE__ */ field.command("displacement.output_rate", 0x11, 0x02, {
    function: FunctionSelector,
}, {
    calls: [,, 0],
    REPLIES: [[[2], [], [OutputRateResponse]]],
});

export const DeviceTime = /* @__PURE__ */ field.command("displacement.device_time", 0x11, 0x04, {
    function: FunctionSelector,
    time: codec.u64,
}, {
    calls: [, 1],
});
