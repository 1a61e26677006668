// Aiding commands: the names and layouts of its fields. The declarations describe their meaning.

import * as codec from "./mip/codec.mjs";
import * as field from "./mip/field.mjs";
import { FunctionSelector } from "./protocol.mjs";
import * as types from "./types.mjs";

export const AidingFrameFormat = /* @__PURE__ */ codec.enumeration(codec.u8, {
    EULER: 1,
    QUATERNION: 2,
});

export const AidingEchoMode = /* @__PURE__ */ codec.enumeration(codec.u8, {
    SUPPRESS_ACK: 0,
    STANDARD: 1,
    RESPONSE: 2,
});

export const Timebase = /* @__PURE__ */ codec.enumeration(codec.u8, {
    INTERNAL_REFERENCE: 1,
    EXTERNAL_TIME: 2,
    TIME_OF_ARRIVAL: 3,
});

export const MeasurementTime = /* @__PURE__ */ codec.struct({
    timebase: Timebase,
    reserved: /* @__PURE__ */ codec.reserved(codec.u8, 1),
    nanoseconds: codec.u64,
});

export const AxisFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    X: [0, 0],
    Y: [1, 1],
    Z: [2, 2],
});

export const LlhAxisFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    LATITUDE: [0, 0],
    LONGITUDE: [1, 1],
    HEIGHT: [2, 2],
});

export const FrameConfigResponse = /* @__PURE__ */ field.response("aiding.frame_config_response", 0x13, 0x81, {
    frameId: codec.u8,
    format: AidingFrameFormat,
    trackingEnabled: codec.bool,
    translation: types.Vector3f,
    rotation: /* @__PURE__ */ codec.union("format", [[1, "euler", types.Vector3f], [2, "quaternion", types.Quatf]]),
});

export const SensorFrameMapResponse = /* @__PURE__ */ field.response("aiding.sensor_frame_map_response", 0x13, 0x82, {
    sensorId: codec.u8,
    frameId: codec.u8,
});

export const EchoControlResponse = /* @__PURE__ */ field.response("aiding.echo_control_response", 0x13, 0x9f, {
    mode: AidingEchoMode,
});

export const FrameConfig = /* @__PURE__ */ field.command("aiding.frame_config", 0x13, 0x01, {
    function: FunctionSelector,
    frameId: codec.u8,
    format: AidingFrameFormat,
    trackingEnabled: codec.bool,
    translation: types.Vector3f,
    rotation: /* @__PURE__ */ codec.union("format", [[1, "euler", types.Vector3f], [2, "quaternion", types.Quatf]]),
}, {
    calls: [, 5, 2, 1, 1, 1],
    REPLIES: [[[2], [], [FrameConfigResponse]]],
});

export const SensorFrameMap = /* @__PURE__ */ field.command("aiding.sensor_frame_map", 0x13, 0x02, {
    function: FunctionSelector,
    sensorId: codec.u8,
    frameId: codec.u8,
}, {
    calls: [, 2, 0, 0, 0, 0],
    REPLIES: [[[2], [], [SensorFrameMapResponse]]],
});

export const EchoControl = /* @__PURE__ */ field.command("aiding.echo_control", 0x13, 0x1f, {
    function: FunctionSelector,
    mode: AidingEchoMode,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [EchoControlResponse]]],
});

export const EcefPosition = /* @__PURE__ */ field.command("aiding.ecef_position", 0x13, 0x21, {
    time: MeasurementTime,
    frameId: codec.u8,
    position: types.Vector3d,
    uncertainty: types.Vector3f,
    validFlags: AxisFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { position: [0x1, 0x2, 0x4], uncertainty: [0x1, 0x2, 0x4] } }),
    SILENCED_BY: [[() => EchoControl, "mode", 0]],
});

export const LlhPosition = /* @__PURE__ */ field.command("aiding.llh_position", 0x13, 0x22, {
    time: MeasurementTime,
    frameId: codec.u8,
    latitude: codec.double,
    longitude: codec.double,
    height: codec.double,
    uncertainty: types.Ned3f,
    validFlags: LlhAxisFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { latitude: 0x1, longitude: 0x2, height: 0x4, uncertainty: [0x1, 0x2, 0x4] } }),
    SILENCED_BY: [[() => EchoControl, "mode", 0]],
});

export const HeightAboveEllipsoid = /* @__PURE__ */ field.command("aiding.height_above_ellipsoid", 0x13, 0x23, {
    time: MeasurementTime,
    frameId: codec.u8,
    height: codec.float,
    uncertainty: codec.float,
    validFlags: codec.u16,
}, {
    SILENCED_BY: [[() => EchoControl, "mode", 0]],
});

export const PressureOld = /* @__PURE__ */ field.command("aiding.pressure_old", 0x13, 0x25, {
    time: MeasurementTime,
    frameId: codec.u8,
    pressure: codec.float,
    uncertainty: codec.float,
    validFlags: codec.u16,
}, {
    SILENCED_BY: [[() => EchoControl, "mode", 0]],
});

export const EcefVelocity = /* @__PURE__ */ field.command("aiding.ecef_velocity", 0x13, 0x28, {
    time: MeasurementTime,
    frameId: codec.u8,
    velocity: types.Vector3f,
    uncertainty: types.Vector3f,
    validFlags: AxisFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { velocity: [0x1, 0x2, 0x4], uncertainty: [0x1, 0x2, 0x4] } }),
    SILENCED_BY: [[() => EchoControl, "mode", 0]],
});

export const NedVelocity = /* @__PURE__ */ field.command("aiding.ned_velocity", 0x13, 0x29, {
    time: MeasurementTime,
    frameId: codec.u8,
    velocity: types.Ned3f,
    uncertainty: types.Ned3f,
    validFlags: AxisFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { velocity: [0x1, 0x2, 0x4], uncertainty: [0x1, 0x2, 0x4] } }),
    SILENCED_BY: [[() => EchoControl, "mode", 0]],
});

export const BodyFrameVelocity = /* @__PURE__ */ field.command("aiding.body_frame_velocity", 0x13, 0x2a, {
    time: MeasurementTime,
    frameId: codec.u8,
    velocity: types.Vector3f,
    uncertainty: types.Vector3f,
    validFlags: AxisFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { velocity: [0x1, 0x2, 0x4], uncertainty: [0x1, 0x2, 0x4] } }),
    SILENCED_BY: [[() => EchoControl, "mode", 0]],
});

export const TrueHeading = /* @__PURE__ */ field.command("aiding.true_heading", 0x13, 0x31, {
    time: MeasurementTime,
    frameId: codec.u8,
    heading: codec.float,
    uncertainty: codec.float,
    validFlags: codec.u16,
}, {
    SILENCED_BY: [[() => EchoControl, "mode", 0]],
});

export const MagneticField = /* @__PURE__ */ field.command("aiding.magnetic_field", 0x13, 0x32, {
    time: MeasurementTime,
    frameId: codec.u8,
    magneticField: types.Vector3f,
    uncertainty: types.Vector3f,
    validFlags: AxisFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { magneticField: [0x1, 0x2, 0x4], uncertainty: [0x1, 0x2, 0x4] } }),
    SILENCED_BY: [[() => EchoControl, "mode", 0]],
});

export const Pressure = /* @__PURE__ */ field.command("aiding.pressure", 0x13, 0x33, {
    time: MeasurementTime,
    frameId: codec.u8,
    pressure: codec.float,
    uncertainty: codec.float,
    validFlags: codec.u16,
}, {
    SILENCED_BY: [[() => EchoControl, "mode", 0]],
});
