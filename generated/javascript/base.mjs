// Base: the names and layouts of its fields. The declarations describe their meaning.

import * as codec from "./mip/codec.mjs";
import * as field from "./mip/field.mjs";
import { FunctionSelector } from "./protocol.mjs";
import * as types from "./types.mjs";

export const BaseDeviceInfo = /* @__PURE__ */ codec.struct({
    firmwareVersion: codec.u16,
    modelName: /* @__PURE__ */ codec.text(16),
    modelNumber: /* @__PURE__ */ codec.text(16),
    serialNumber: /* @__PURE__ */ codec.text(16),
    lotNumber: /* @__PURE__ */ codec.text(16),
    deviceOptions: /* @__PURE__ */ codec.text(16),
});

export const GpsTimeField = /* @__PURE__ */ codec.enumeration(codec.u8, {
    WEEK_NUMBER: 1,
    TOW: 2,
});

export const GetDeviceInfoResponse = /* @__PURE__ */ field.response("base.get_device_info_response", 0x01, 0x81, {
    deviceInfo: BaseDeviceInfo,
});

export const GetDeviceDescriptorsResponse = /* @__PURE__ */ field.response("base.get_device_descriptors_response", 0x01, 0x82, {
    descriptors: /* @__PURE__ */ codec.rest(codec.u16, 126),
});

export const BuiltInTestResponse = /* @__PURE__ */ field.response("base.built_in_test_response", 0x01, 0x83, {
    result: codec.u32,
});

export const GpsTimeUpdateWeekNumberResponse = /* @__PURE__ */ field.response("base.gps_time_update_week_number_response", 0x01, 0x84, {
    weekNumber: codec.u32,
});

export const GpsTimeUpdateTowResponse = /* @__PURE__ */ field.response("base.gps_time_update_tow_response", 0x01, 0x85, {
    tow: codec.u32,
});

export const GetExtendedDescriptorsResponse = /* @__PURE__ */ field.response("base.get_extended_descriptors_response", 0x01, 0x86, {
    descriptors: /* @__PURE__ */ codec.rest(codec.u16, 126),
});

export const ContinuousBuiltInTestResponse = /* @__PURE__ */ field.response("base.continuous_built_in_test_response", 0x01, 0x88, {
    result: /* @__PURE__ */ codec.array(codec.u8, 16),
});

export const CommSpeedResponse = /* @__PURE__ */ field.response("base.comm_speed_response", 0x01, 0x89, {
    port: codec.u8,
    baud: codec.u32,
});

export const Ping = /* @__PURE__ */ field.command("base.ping", 0x01, 0x01, {});

export const SetIdle = /* @__PURE__ */ field.command("base.set_idle", 0x01, 0x02, {});

export const GetDeviceInfo = /* @__PURE__ */ field.command("base.get_device_info", 0x01, 0x03, {}, {
    REPLIES: [[null, [], [GetDeviceInfoResponse]]],
});

export const GetDeviceDescriptors = /* @__PURE__ */ field.command("base.get_device_descriptors", 0x01, 0x04, {}, {
    REPLIES: [[null, [], [GetDeviceDescriptorsResponse]]],
});

export const BuiltInTest = /* @__PURE__ */ field.command("base.built_in_test", 0x01, 0x05, {}, {
    REPLIES: [[null, [], [BuiltInTestResponse]]],
    TIMEOUT: 10,
});

export const Resume = /* @__PURE__ */ field.command("base.resume", 0x01, 0x06, {});

export const GetExtendedDescriptors = /* @__PURE__ */ field.command("base.get_extended_descriptors", 0x01, 0x07, {}, {
    REPLIES: [[null, [], [GetExtendedDescriptorsResponse]]],
});

export const ContinuousBuiltInTest = /* @__PURE__ */ field.command("base.continuous_built_in_test", 0x01, 0x08, {}, {
    REPLIES: [[null, [], [ContinuousBuiltInTestResponse]]],
});

export const CommSpeed = /* @__PURE__ */ field.command("base.comm_speed", 0x01, 0x09, {
    function: FunctionSelector,
    port: codec.u8,
    baud: codec.u32,
}, {
    calls: [, 2, 1, 1, 1, 1],
    REPLIES: [[[2], [], [CommSpeedResponse]]],
});

export const GpsTimeUpdate = /* @__PURE__ */ field.command("base.gps_time_update", 0x01, 0x72, {
    function: FunctionSelector,
    fieldId: GpsTimeField,
    value: codec.u32,
}, {
    calls: [, 2, 1,,,, 2],
    REPLIES: [[[2], [["fieldId", 1, false]], [GpsTimeUpdateWeekNumberResponse]], [[2], [["fieldId", 2, false]], [GpsTimeUpdateTowResponse]]],
    SILENT: [[6], []],
});

export const SoftReset = /* @__PURE__ */ field.command("base.soft_reset", 0x01, 0x7e, {});
