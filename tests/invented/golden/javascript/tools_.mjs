// Tools: the names and layouts of its fields. The declarations describe their meaning.

import * as codec from "./mip/codec.mjs";
import * as field from "./mip/field.mjs";
import { FunctionSelector } from "./protocol.mjs";
import * as types from "./types.mjs";

export const Shape = /* @__PURE__ */ codec.enumeration(codec.u8, {
    NONE: 0,
    CIRCLE: 1,
    PATH: 2,
    TURN: 3,
    LABEL: 4,
});

export const Fill = /* @__PURE__ */ codec.enumeration(codec.u8, {
    EMPTY: 0,
    SOLID: 1,
    STRIPED: 2,
});

export const Stripes = /* @__PURE__ */ codec.struct({
    width: codec.double,
    angle: codec.float,
});

export const Circle = /* @__PURE__ */ codec.struct({
    center: types.Point,
    fill: Fill,
    filling: /* @__PURE__ */ codec.union("fill", [[1, "solid", codec.u32], [2, "striped", Stripes]]),
});

export const Path = /* @__PURE__ */ codec.struct({
    closed: codec.bool,
    num_points: /* @__PURE__ */ codec.counter(codec.u8, "points"),
    points: /* @__PURE__ */ codec.counted("num_points", types.Point, 62),
});

export const Drive = /* @__PURE__ */ codec.enumeration(codec.u8, {
    OFF: 0,
    PULSE: 1,
    SERIAL: 2,
});

export const PulseUse = /* @__PURE__ */ codec.enumeration(codec.u8, {
    INPUT: 1,
    OUTPUT: 2,
});

export const SerialUse = /* @__PURE__ */ codec.enumeration(codec.u8, {
    RECEIVE: 1,
    TRANSMIT: 33,
});

export const Reading = /* @__PURE__ */ codec.struct({
    kind: codec.u8,
    value: codec.float,
});

export const ModelAFaults = /* @__PURE__ */ codec.bitfield(codec.u32, {
    CLOCK: [0, 0],
    SENSOR: [8, 8],
    SOLUTION: [24, 24],
});

export const ModelBFaults = /* @__PURE__ */ codec.bitfield(codec.u32, {
    GENERAL: [0, 0],
    OVERLOAD: [1, 1],
    ACCEL: [12, 12],
});

export const SettingsResponse = /* @__PURE__ */ field.response("tools.settings_response", 0x01, 0x82, {
    port: codec.u8,
    mode: types.Mode,
    baud: codec.u32,
    limit: codec.u16,
    reserved: /* @__PURE__ */ codec.reserved(codec.u8, 1),
});

export const SetTimeFastResponse = /* @__PURE__ */ field.response("tools.set_time_fast_response", 0x01, 0x83, {
    value: codec.u32,
});

export const SetTimeSlowResponse = /* @__PURE__ */ field.response("tools.set_time_slow_response", 0x01, 0x84, {
    value: codec.u32,
});

export const ChoiceResponse = /* @__PURE__ */ field.response("tools.choice_response", 0x01, 0x88, {
    instance: codec.u8,
    shape: Shape,
    parameters: /* @__PURE__ */ codec.union("shape", [[1, "circle", Circle], [2, "path", Path], [3, "rotation", types.Quatf], [4, "label", /* @__PURE__ */ codec.text(8)]]),
});

export const ListResponse = /* @__PURE__ */ field.response("tools.list_response", 0x01, 0x89, {
    count: /* @__PURE__ */ codec.counter(codec.u8, "items"),
    items: /* @__PURE__ */ codec.counted("count", codec.u16, 126),
});

export const InventoryResponse = /* @__PURE__ */ field.response("tools.inventory_response", 0x01, 0x8a, {
    descriptors: /* @__PURE__ */ codec.rest(codec.u16, 126),
});

export const PinResponse = /* @__PURE__ */ field.response("tools.pin_response", 0x01, 0x8b, {
    drive: Drive,
    use: codec.u8,
});

export const HelloResponse = /* @__PURE__ */ field.response("tools.hello_response", 0x01, 0x8c, {
    seen: codec.u32,
});

export const ReadingsResponse = /* @__PURE__ */ field.response("tools.readings_response", 0x01, 0x8d, {
    drive: Drive,
    count: /* @__PURE__ */ codec.counter(codec.u8, "readings"),
    readings: /* @__PURE__ */ codec.counted("count", Reading, 49),
    last: Reading,
});

export const StatusPaged = /* @__PURE__ */ field.response("tools.status_paged", 0x01, 0x90, {
    model: /* @__PURE__ */ codec.constant(codec.u16, 4711),
    selector: /* @__PURE__ */ codec.constant(codec.u8, 1),
    page: /* @__PURE__ */ codec.constant(codec.u8, 7),
    uptime: codec.u16,
    level: codec.u8,
}, {
    fits: [0, 253, [[0, [18, 103]], [2, [1]], [3, [7]]]],
});

export const StatusShort = /* @__PURE__ */ field.response("tools.status_short", 0x01, 0x90, {
    model: /* @__PURE__ */ codec.constant(codec.u16, 4711),
    selector: /* @__PURE__ */ codec.constant(codec.u8, 1),
    flags: codec.u32,
}, {
    fits: [0, 253, [[0, [18, 103]], [2, [1]]]],
});

export const StatusLong = /* @__PURE__ */ field.response("tools.status_long", 0x01, 0x90, {
    model: /* @__PURE__ */ codec.constant(codec.u16, 4711),
    selector: /* @__PURE__ */ codec.constant(codec.u8, 2),
    flags: codec.u32,
    uptime: codec.u64,
}, {
    fits: [15, 15, [[0, [18, 103]], [2, [2]]]],
});

export const StatusOld = /* @__PURE__ */ field.response("tools.status_old", 0x01, 0x90, {
    model: /* @__PURE__ */ codec.constant(codec.u16, 4711),
    selector: /* @__PURE__ */ codec.constant(codec.u8, 2),
    uptime: codec.u32,
}, {
    fits: [0, 14, [[0, [18, 103]], [2, [2]]]],
});

export const StatusFull = /* @__PURE__ */ field.response("tools.status_full", 0x01, 0x90, {
    model: /* @__PURE__ */ codec.constant(codec.u16, 4711),
    selector: /* @__PURE__ */ codec.constant(codec.u8, 2),
    place: types.Point,
    uptime: codec.u64,
    mode: types.Mode,
}, {
    fits: [16, 253, [[0, [18, 103]], [2, [2]]]],
});

export const BiasVector = /* @__PURE__ */ field.response("tools.bias_vector", 0x01, 0x9b, {
    bias: types.Vector3f,
});

export const Ping = /* @__PURE__ */ field.command("tools.ping", 0x01, 0x01, {});

export const Settings = /* @__PURE__ */ field.command("tools.settings", 0x01, 0x02, {
    function: FunctionSelector,
    port: codec.u8,
    mode: types.Mode,
    baud: codec.u32,
    limit: codec.u16,
    reserved: /* @__PURE__ */ codec.reserved(codec.u8, 1),
}, {
    calls: { 1: 3, 2: 2, 3: 1, 4: 1, 5: 1, 6: 3 },
    REPLIES: [[[2], [], [SettingsResponse]]],
    SILENT: [[6], []],
});

export const SetTime = /* @__PURE__ */ field.command("tools.set_time", 0x01, 0x03, {
    function: FunctionSelector,
    part: types.Mode,
    value: codec.u32,
}, {
    calls: { 1: 2, 2: 1, 6: 2 },
    REPLIES: [[[2], [["part", 1, false]], [SetTimeFastResponse]], [[2], [["part", 2, false]], [SetTimeSlowResponse]]],
    SILENT: [[6], []],
});

export const Status = /* @__PURE__ */ field.command("tools.status", 0x01, 0x04, {
    model: /* @__PURE__ */ codec.constant(codec.u16, 4711),
    selector: codec.u8,
}, {
    REPLIES: [[null, [["selector", 1, false]], [StatusPaged, StatusShort]], [null, [["selector", 2, false]], [StatusLong, StatusOld, StatusFull]]],
    TIMEOUT: 2.5,
});

export const Bias = /* @__PURE__ */ field.command("tools.bias", 0x01, 0x05, {
    function: FunctionSelector,
    bias: types.Vector3f,
}, {
    calls: { 1: 1, 2: 0, 3: 0, 4: 0, 5: 0 },
    REPLIES: [[[2], [], [BiasVector]]],
});

export const CaptureBias = /* @__PURE__ */ field.command("tools.capture_bias", 0x01, 0x06, {
    time: codec.u16,
}, {
    REPLIES: [[null, [], [BiasVector]]],
});

export const Formats = /* @__PURE__ */ field.command("tools.formats", 0x01, 0x07, {
    suppress_ack: codec.bool,
    num_segments: /* @__PURE__ */ codec.counter(codec.u8, "segments"),
    checkpoint: codec.u8,
    segments: /* @__PURE__ */ codec.counted("num_segments", types.Segment, 25),
}, {
    SILENT: [[], [["suppress_ack", 1, true]]],
});

export const Choice = /* @__PURE__ */ field.command("tools.choice", 0x01, 0x08, {
    function: FunctionSelector,
    instance: codec.u8,
    shape: Shape,
    parameters: /* @__PURE__ */ codec.union("shape", [[1, "circle", Circle], [2, "path", Path], [3, "rotation", types.Quatf], [4, "label", /* @__PURE__ */ codec.text(8)]]),
}, {
    calls: { 1: 3, 2: 1 },
    REPLIES: [[[2], [], [ChoiceResponse]]],
});

export const List = /* @__PURE__ */ field.command("tools.list", 0x01, 0x09, {
    function: FunctionSelector,
    count: /* @__PURE__ */ codec.counter(codec.u8, "items"),
    items: /* @__PURE__ */ codec.counted("count", codec.u16, 125),
}, {
    calls: { 1: 2, 2: 0, 3: 0 },
    REPLIES: [[[2], [], [ListResponse]]],
});

export const Inventory = /* @__PURE__ */ field.command("tools.inventory", 0x01, 0x0a, {}, {
    REPLIES: [[null, [], [InventoryResponse]]],
});

export const Pin = /* @__PURE__ */ field.command("tools.pin", 0x01, 0x0b, {
    function: FunctionSelector,
    drive: Drive,
    use: codec.u8,
}, {
    calls: { 1: 2, 2: 1 },
    REPLIES: [[[2], [], [PinResponse]]],
});

export const Hello = /* @__PURE__ */ field.command("tools.hello", 0x01, 0x0c, {
    reserved: /* @__PURE__ */ codec.reserved(codec.float, 1.0),
    later: /* @__PURE__ */ codec.reserved(/* @__PURE__ */ codec.array(/* @__PURE__ */ codec.reserved(codec.double, 0.0), 2), Array(2).fill(0.0)),
}, {
    optional: 1,
    REPLIES: [[null, [], [HelloResponse]]],
});

export const Readings = /* @__PURE__ */ field.command("tools.readings", 0x01, 0x0d, {
    drive: Drive,
}, {
    REPLIES: [[null, [], [ReadingsResponse]]],
});

export const Poll = /* @__PURE__ */ field.command("tools.poll", 0x01, 0x0e, {
    descriptor_set: codec.u8,
    first: codec.u8,
    count: /* @__PURE__ */ codec.counter(codec.u8, "descriptors"),
    descriptors: /* @__PURE__ */ codec.counted("count", codec.u8, 250),
});
