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

export const RawAccel = /* @__PURE__ */ field.data("sensor.raw_accel", 0x80, 0x01, (values, reader) => {
    values.rawAccel = types.Vector3f(reader, 0);
});

export const RawGyro = /* @__PURE__ */ field.data("sensor.raw_gyro", 0x80, 0x02, (values, reader) => {
    values.rawGyro = types.Vector3f(reader, 0);
});

export const RawMag = /* @__PURE__ */ field.data("sensor.raw_mag", 0x80, 0x03, (values, reader) => {
    values.rawMag = types.Vector3f(reader, 0);
});

export const ScaledAccel = /* @__PURE__ */ field.data("sensor.scaled_accel", 0x80, 0x04, (values, reader) => {
    values.scaledAccel = types.Vector3f(reader, 0);
});

export const ScaledGyro = /* @__PURE__ */ field.data("sensor.scaled_gyro", 0x80, 0x05, (values, reader) => {
    values.scaledGyro = types.Vector3f(reader, 0);
});

export const ScaledMag = /* @__PURE__ */ field.data("sensor.scaled_mag", 0x80, 0x06, (values, reader) => {
    values.scaledMag = types.Vector3f(reader, 0);
});

export const DeltaTheta = /* @__PURE__ */ field.data("sensor.delta_theta", 0x80, 0x07, (values, reader) => {
    values.deltaTheta = types.Vector3f(reader, 0);
});

export const DeltaVelocity = /* @__PURE__ */ field.data("sensor.delta_velocity", 0x80, 0x08, (values, reader) => {
    values.deltaVelocity = types.Vector3f(reader, 0);
});

export const CompOrientationMatrix = /* @__PURE__ */ field.data("sensor.comp_orientation_matrix", 0x80, 0x09, (values, reader) => {
    values.m = types.Matrix3f(reader, 0);
});

export const CompQuaternion = /* @__PURE__ */ field.data("sensor.comp_quaternion", 0x80, 0x0a, (values, reader) => {
    values.q = types.Quatf(reader, 0);
});

export const CompOrientationUpdateMatrix = /* @__PURE__ */ field.data("sensor.comp_orientation_update_matrix", 0x80, 0x0b, (values, reader) => {
    values.m = types.Matrix3f(reader, 0);
});

export const CompEulerAngles = /* @__PURE__ */ field.data("sensor.comp_euler_angles", 0x80, 0x0c, (values, reader) => {
    values.roll = codec.float(reader, 0);
    values.pitch = codec.float(reader, 4);
    values.yaw = codec.float(reader, 8);
});

export const OrientationRawTemperature = /* @__PURE__ */ field.data("sensor.orientation_raw_temperature", 0x80, 0x0d, {
    rawTemperature: /* @__PURE__ */ codec.array(codec.u16, 4),
});

export const InternalTimestamp = /* @__PURE__ */ field.data("sensor.internal_timestamp", 0x80, 0x0e, (values, reader) => {
    values.counts = codec.u32(reader, 0);
});

export const PpsTimestamp = /* @__PURE__ */ field.data("sensor.pps_timestamp", 0x80, 0x0f, (values, reader) => {
    values.seconds = codec.u32(reader, 0);
    values.useconds = codec.u32(reader, 4);
}, {
    fits: [0, 8, []],
});

export const PpsTimestampWithFlags = /* @__PURE__ */ field.data("sensor.pps_timestamp_with_flags", 0x80, 0x0f, (values, reader) => {
    values.flags = codec.u8(reader, 0);
    values.seconds = codec.u32(reader, 1);
    values.nanoseconds = codec.u32(reader, 5);
}, {
    fits: [9, 253, []],
});

export const NorthVector = /* @__PURE__ */ field.data("sensor.north_vector", 0x80, 0x10, (values, reader) => {
    values.stabilizedMag = types.Vector3f(reader, 0);
});

export const UpVector = /* @__PURE__ */ field.data("sensor.up_vector", 0x80, 0x11, (values, reader) => {
    values.stabilizedAccel = types.Vector3f(reader, 0);
});

export const GpsTimestamp = /* @__PURE__ */ field.data("sensor.gps_timestamp", 0x80, 0x12, (values, reader) => {
    values.tow = codec.double(reader, 0);
    values.weekNumber = codec.u16(reader, 8);
    values.validFlags = codec.u16(reader, 10);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { tow: 0x8, weekNumber: 0x10 } }, [
        [["3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-dh3", "3dm-gq4-45", "3dm-gx3-15", "3dm-gx3-25", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-15", "3dm-gx5-25", "3dm-gx5-35", "3dm-gx5-45", "3dm-mv5-ar", "3dm-rq1-45-lt", "3dm-rq1-45-st", "3dm-rq1-imu"], 0xfff8, "validFlags", { validFlags: { tow: 0x4, weekNumber: 0x4 } }],
    ]),
});

export const TemperatureStatistics = /* @__PURE__ */ field.data("sensor.temperature_statistics", 0x80, 0x14, (values, reader) => {
    values.minTemperature = codec.float(reader, 0);
    values.maxTemperature = codec.float(reader, 4);
    values.meanTemperature = codec.float(reader, 8);
});

export const RawPressure = /* @__PURE__ */ field.data("sensor.raw_pressure", 0x80, 0x16, (values, reader) => {
    values.rawPressure = codec.float(reader, 0);
});

export const ScaledPressure = /* @__PURE__ */ field.data("sensor.scaled_pressure", 0x80, 0x17, (values, reader) => {
    values.scaledPressure = codec.float(reader, 0);
});

export const OverrangeStatus = /* @__PURE__ */ field.data("sensor.overrange_status", 0x80, 0x18, (values, reader) => {
    values.status = codec.u16(reader, 0);
});

export const Odometer = /* @__PURE__ */ field.data("sensor.odometer", 0x80, 0x40, (values, reader) => {
    values.speed = codec.float(reader, 0);
    values.uncertainty = codec.float(reader, 4);
    values.validFlags = codec.u16(reader, 8);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { speed: 0x1, uncertainty: 0x1 } }),
});
