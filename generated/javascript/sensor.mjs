// Sensor data: the names and layouts of its fields. The declarations describe their meaning.

import * as codec from "./mip/codec.mjs";
import * as field from "./mip/field.mjs";
import { FunctionSelector } from "./protocol.mjs";
import * as types from "./types.mjs";

export const OverrangeFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    ACCEL_X: [0, 0],
    ACCEL_Y: [1, 1],
    ACCEL_Z: [2, 2],
    GYRO_X: [4, 4],
    GYRO_Y: [5, 5],
    GYRO_Z: [6, 6],
    MAG_X: [8, 8],
    MAG_Y: [9, 9],
    MAG_Z: [10, 10],
    PRESSURE: [12, 12],
});

export const OdometerFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    ODOMETER: [0, 0],
});

export const RawAccel = /* @__PURE__ */ field.data("sensor.raw_accel", 0x80, 0x01, {
    raw_accel: types.Vector3f,
});

export const RawGyro = /* @__PURE__ */ field.data("sensor.raw_gyro", 0x80, 0x02, {
    raw_gyro: types.Vector3f,
});

export const RawMag = /* @__PURE__ */ field.data("sensor.raw_mag", 0x80, 0x03, {
    raw_mag: types.Vector3f,
});

export const ScaledAccel = /* @__PURE__ */ field.data("sensor.scaled_accel", 0x80, 0x04, {
    scaled_accel: types.Vector3f,
});

export const ScaledGyro = /* @__PURE__ */ field.data("sensor.scaled_gyro", 0x80, 0x05, {
    scaled_gyro: types.Vector3f,
});

export const ScaledMag = /* @__PURE__ */ field.data("sensor.scaled_mag", 0x80, 0x06, {
    scaled_mag: types.Vector3f,
});

export const DeltaTheta = /* @__PURE__ */ field.data("sensor.delta_theta", 0x80, 0x07, {
    delta_theta: types.Vector3f,
});

export const DeltaVelocity = /* @__PURE__ */ field.data("sensor.delta_velocity", 0x80, 0x08, {
    delta_velocity: types.Vector3f,
});

export const CompOrientationMatrix = /* @__PURE__ */ field.data("sensor.comp_orientation_matrix", 0x80, 0x09, {
    m: types.Matrix3f,
});

export const CompQuaternion = /* @__PURE__ */ field.data("sensor.comp_quaternion", 0x80, 0x0a, {
    q: types.Quatf,
});

export const CompOrientationUpdateMatrix = /* @__PURE__ */ field.data("sensor.comp_orientation_update_matrix", 0x80, 0x0b, {
    m: types.Matrix3f,
});

export const CompEulerAngles = /* @__PURE__ */ field.data("sensor.comp_euler_angles", 0x80, 0x0c, {
    roll: codec.float,
    pitch: codec.float,
    yaw: codec.float,
});

export const OrientationRawTemperature = /* @__PURE__ */ field.data("sensor.orientation_raw_temperature", 0x80, 0x0d, {
    raw_temperature: /* @__PURE__ */ codec.array(codec.u16, 4),
});

export const InternalTimestamp = /* @__PURE__ */ field.data("sensor.internal_timestamp", 0x80, 0x0e, {
    counts: codec.u32,
});

export const PpsTimestamp = /* @__PURE__ */ field.data("sensor.pps_timestamp", 0x80, 0x0f, {
    seconds: codec.u32,
    useconds: codec.u32,
}, {
    fits: [0, 8, []],
});

export const PpsTimestampWithFlags = /* @__PURE__ */ field.data("sensor.pps_timestamp_with_flags", 0x80, 0x0f, {
    flags: codec.u8,
    seconds: codec.u32,
    nanoseconds: codec.u32,
}, {
    fits: [9, 253, []],
});

export const NorthVector = /* @__PURE__ */ field.data("sensor.north_vector", 0x80, 0x10, {
    stabilized_mag: types.Vector3f,
});

export const UpVector = /* @__PURE__ */ field.data("sensor.up_vector", 0x80, 0x11, {
    stabilized_accel: types.Vector3f,
});

export const GpsTimestamp = /* @__PURE__ */ field.data("sensor.gps_timestamp", 0x80, 0x12, {
    tow: codec.double,
    week_number: codec.u16,
    valid_flags: types.SensorGpsTimestampFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { tow: 0x8, weekNumber: 0x10 } }, [
        [["3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-15", "3dm-gx5-25", "3dm-gx5-35", "3dm-gx5-45"], 0xfff8, "validFlags", { validFlags: { tow: 0x4, weekNumber: 0x4 } }],
    ]),
});

export const TemperatureStatistics = /* @__PURE__ */ field.data("sensor.temperature_statistics", 0x80, 0x14, {
    min_temperature: codec.float,
    max_temperature: codec.float,
    mean_temperature: codec.float,
});

export const RawPressure = /* @__PURE__ */ field.data("sensor.raw_pressure", 0x80, 0x16, {
    raw_pressure: codec.float,
});

export const ScaledPressure = /* @__PURE__ */ field.data("sensor.scaled_pressure", 0x80, 0x17, {
    scaled_pressure: codec.float,
});

export const OverrangeStatus = /* @__PURE__ */ field.data("sensor.overrange_status", 0x80, 0x18, {
    status: OverrangeFlags,
});

export const Odometer = /* @__PURE__ */ field.data("sensor.odometer", 0x80, 0x40, {
    speed: codec.float,
    uncertainty: codec.float,
    valid_flags: OdometerFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { speed: 0x1, uncertainty: 0x1 } }),
});
