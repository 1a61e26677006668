// Filter data: the names and layouts of its fields. The declarations describe their meaning.

import * as codec from "./mip/codec.mjs";
import * as field from "./mip/field.mjs";
import { FunctionSelector } from "./protocol.mjs";
import * as types from "./types.mjs";

export const ValidFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    VALID: [0, 0],
});

export const HeadingSourceFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    MAG: [0, 0],
    GNSS_VELOCITY: [1, 1],
    EXTERNAL: [2, 2],
});

export const GnssAidingStatus = /* @__PURE__ */ codec.bitfield(codec.u16, {
    TIGHT_COUPLING: [0, 0],
    DIFFERENTIAL: [1, 1],
    INTEGER_FIX: [2, 2],
    GPS_L1: [3, 3],
    GPS_L2: [4, 4],
    GPS_L5: [5, 5],
    GLONASS_L1: [6, 6],
    GLONASS_L2: [7, 7],
    GALILEO_E1: [8, 8],
    GALILEO_E5: [9, 9],
    GALILEO_E6: [10, 10],
    BEIDOU_B1: [11, 11],
    BEIDOU_B2: [12, 12],
    BEIDOU_B3: [13, 13],
    NO_FIX: [14, 14],
    CONFIG_ERROR: [15, 15],
});

export const HeadingAidingType = /* @__PURE__ */ codec.enumeration(codec.u8, {
    DUAL_ANTENNA: 1,
    EXTERNAL_MESSAGE: 2,
});

export const AidingMeasurementType = /* @__PURE__ */ codec.enumeration(codec.u8, {
    GNSS: 1,
    DUAL_ANTENNA: 2,
    HEADING: 3,
    PRESSURE: 4,
    MAG: 5,
    SPEED: 6,
    AIDING_ECEF_POSITION: 33,
    AIDING_LLH_POSITION: 34,
    AIDING_HEIGHT_ABOVE_ELLIPSOID: 35,
    AIDING_ECEF_VELOCITY: 40,
    AIDING_NED_VELOCITY: 41,
    AIDING_BODY_FRAME_VELOCITY: 42,
    AIDING_TRUE_HEADING: 49,
    AIDING_MAGNETIC_FIELD: 50,
    AIDING_PRESSURE: 51,
});

export const AidingMeasurementIndicator = /* @__PURE__ */ codec.bitfield(codec.u8, {
    ENABLED: [0, 0],
    USED: [1, 1],
    RESIDUAL_HIGH_WARNING: [2, 2],
    SAMPLE_TIME_WARNING: [3, 3],
    CONFIG_ERROR: [4, 4],
    MAX_MEASUREMENTS_EXCEEDED: [5, 5],
});

export const DualAntennaFixType = /* @__PURE__ */ codec.enumeration(codec.u8, {
    FIX_NONE: 0,
    FIX_DA_FLOAT: 1,
    FIX_DA_FIXED: 2,
});

export const DualAntennaStatusFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    RECEIVER_1_DATA_VALID: [0, 0],
    RECEIVER_2_DATA_VALID: [1, 1],
    ANTENNA_OFFSETS_VALID: [2, 2],
});

export const Gx5FilterState = /* @__PURE__ */ codec.enumeration(codec.u16, {
    STARTUP: 0,
    INIT: 1,
    RUN_SOLUTION_VALID: 2,
    RUN_SOLUTION_ERROR: 3,
});

export const Cv7FilterState = /* @__PURE__ */ codec.enumeration(codec.u16, {
    INIT: 1,
    VERTICAL_GYRO: 2,
    AHRS: 3,
    FULL_NAV: 4,
});

export const Gx5DynamicsMode = /* @__PURE__ */ codec.enumeration(codec.u16, {
    PORTABLE: 1,
    AUTOMOTIVE: 2,
    AIRBORNE: 3,
    AIRBORNE_HIGH_G: 4,
});

export const Cv7DynamicsMode = /* @__PURE__ */ codec.enumeration(codec.u16, {
    DEFAULT: 1,
});

export const Gx5StatusFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    RUN_IMU_UNAVAILABLE: [0, 0],
    RUN_GPS_UNAVAILABLE: [1, 1],
    RUN_MATRIX_SINGULARITY: [3, 3],
    RUN_POSITION_COVARIANCE_WARNING: [4, 4],
    RUN_VELOCITY_COVARIANCE_WARNING: [5, 5],
    RUN_ATTITUDE_COVARIANCE_WARNING: [6, 6],
    RUN_NAN_IN_SOLUTION_WARNING: [7, 7],
    RUN_GYRO_BIAS_EST_HIGH_WARNING: [8, 8],
    RUN_ACCEL_BIAS_EST_HIGH_WARNING: [9, 9],
    RUN_GYRO_SCALE_FACTOR_EST_HIGH_WARNING: [10, 10],
    RUN_ACCEL_SCALE_FACTOR_EST_HIGH_WARNING: [11, 11],
    RUN_MAG_BIAS_EST_HIGH_WARNING: [12, 12],
    RUN_ANTENNA_OFFSET_CORRECTION_EST_HIGH_WARNING: [13, 13],
    RUN_MAG_HARD_IRON_EST_HIGH_WARNING: [14, 14],
    RUN_MAG_SOFT_IRON_EST_HIGH_WARNING: [15, 15],
    INIT_NO_ATTITUDE: [12, 12],
    INIT_NO_POSITION_VELOCITY: [13, 13],
});

export const FilterCondition = /* @__PURE__ */ codec.enumeration(codec.u8, {
    STABLE: 1,
    CONVERGING: 2,
    UNSTABLE: 3,
});

export const Cv7StatusFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    FILTER_CONDITION: [0, 1],
    ROLL_PITCH_WARNING: [2, 2],
    HEADING_WARNING: [3, 3],
    POSITION_WARNING: [4, 4],
    VELOCITY_WARNING: [5, 5],
    IMU_BIAS_WARNING: [6, 6],
    GNSS_CLOCK_WARNING: [7, 7],
    ANTENNA_LEVER_ARM_WARNING: [8, 8],
    MOUNTING_TRANSFORM_WARNING: [9, 9],
    TIME_SYNC_WARNING: [10, 10],
    SOLUTION_ERROR: [12, 15],
});

export const LlhPosition = /* @__PURE__ */ field.data("filter_data.llh_position", 0x82, 0x01, (values, reader) => {
    values.latitude = codec.double(reader, 0);
    values.longitude = codec.double(reader, 8);
    values.ellipsoidHeight = codec.double(reader, 16);
    values.validFlags = codec.u16(reader, 24);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { latitude: 0x1, longitude: 0x1, ellipsoidHeight: 0x1 } }),
});

export const NedVelocity = /* @__PURE__ */ field.data("filter_data.ned_velocity", 0x82, 0x02, (values, reader) => {
    values.north = codec.float(reader, 0);
    values.east = codec.float(reader, 4);
    values.down = codec.float(reader, 8);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { north: 0x1, east: 0x1, down: 0x1 } }),
});

export const AttitudeQuaternion = /* @__PURE__ */ field.data("filter_data.attitude_quaternion", 0x82, 0x03, (values, reader) => {
    values.q = types.Quatf(reader, 0);
    values.validFlags = codec.u16(reader, 16);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { q: 0x1 } }),
});

export const AttitudeDcm = /* @__PURE__ */ field.data("filter_data.attitude_dcm", 0x82, 0x04, (values, reader) => {
    values.dcm = types.Matrix3f(reader, 0);
    values.validFlags = codec.u16(reader, 36);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { dcm: 0x1 } }),
});

export const EulerAngles = /* @__PURE__ */ field.data("filter_data.euler_angles", 0x82, 0x05, (values, reader) => {
    values.roll = codec.float(reader, 0);
    values.pitch = codec.float(reader, 4);
    values.yaw = codec.float(reader, 8);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { roll: 0x1, pitch: 0x1, yaw: 0x1 } }),
});

export const GyroBias = /* @__PURE__ */ field.data("filter_data.gyro_bias", 0x82, 0x06, (values, reader) => {
    values.bias = types.Vector3f(reader, 0);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { bias: 0x1 } }),
});

export const AccelBias = /* @__PURE__ */ field.data("filter_data.accel_bias", 0x82, 0x07, (values, reader) => {
    values.bias = types.Vector3f(reader, 0);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { bias: 0x1 } }),
});

export const LlhPositionUncertainty = /* @__PURE__ */ field.data("filter_data.llh_position_uncertainty", 0x82, 0x08, (values, reader) => {
    values.north = codec.float(reader, 0);
    values.east = codec.float(reader, 4);
    values.down = codec.float(reader, 8);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { north: 0x1, east: 0x1, down: 0x1 } }),
});

export const NedVelocityUncertainty = /* @__PURE__ */ field.data("filter_data.ned_velocity_uncertainty", 0x82, 0x09, (values, reader) => {
    values.north = codec.float(reader, 0);
    values.east = codec.float(reader, 4);
    values.down = codec.float(reader, 8);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { north: 0x1, east: 0x1, down: 0x1 } }),
});

export const EulerAnglesUncertainty = /* @__PURE__ */ field.data("filter_data.euler_angles_uncertainty", 0x82, 0x0a, (values, reader) => {
    values.roll = codec.float(reader, 0);
    values.pitch = codec.float(reader, 4);
    values.yaw = codec.float(reader, 8);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { roll: 0x1, pitch: 0x1, yaw: 0x1 } }),
});

export const GyroBiasUncertainty = /* @__PURE__ */ field.data("filter_data.gyro_bias_uncertainty", 0x82, 0x0b, (values, reader) => {
    values.biasUncertainty = types.Vector3f(reader, 0);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { biasUncertainty: 0x1 } }),
});

export const AccelBiasUncertainty = /* @__PURE__ */ field.data("filter_data.accel_bias_uncertainty", 0x82, 0x0c, (values, reader) => {
    values.biasUncertainty = types.Vector3f(reader, 0);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { biasUncertainty: 0x1 } }),
});

export const LinearAccel = /* @__PURE__ */ field.data("filter_data.linear_accel", 0x82, 0x0d, (values, reader) => {
    values.accel = types.Vector3f(reader, 0);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { accel: 0x1 } }),
});

export const CompAngularRate = /* @__PURE__ */ field.data("filter_data.comp_angular_rate", 0x82, 0x0e, (values, reader) => {
    values.gyro = types.Vector3f(reader, 0);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { gyro: 0x1 } }),
});

export const Wgs84GravityMagnitude = /* @__PURE__ */ field.data("filter_data.wgs84_gravity_magnitude", 0x82, 0x0f, (values, reader) => {
    values.gravityMagnitude = codec.float(reader, 0);
    values.validFlags = codec.u16(reader, 4);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { gravityMagnitude: 0x1 } }),
});

export const Status = /* @__PURE__ */ field.data("filter_data.status", 0x82, 0x10, (values, reader) => {
    values.filterState = codec.u16(reader, 0);
    values.dynamicsMode = codec.u16(reader, 2);
    values.statusFlags = codec.u16(reader, 4);
});

export const Timestamp = /* @__PURE__ */ field.data("filter_data.timestamp", 0x82, 0x11, (values, reader) => {
    values.tow = codec.double(reader, 0);
    values.weekNumber = codec.u16(reader, 8);
    values.validFlags = codec.u16(reader, 10);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { tow: 0x1, weekNumber: 0x1 } }),
});

export const QuaternionAttitudeUncertainty = /* @__PURE__ */ field.data("filter_data.quaternion_attitude_uncertainty", 0x82, 0x12, (values, reader) => {
    values.q = types.Quatf(reader, 0);
    values.validFlags = codec.u16(reader, 16);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { q: 0x1 } }),
});

export const GravityVector = /* @__PURE__ */ field.data("filter_data.gravity_vector", 0x82, 0x13, (values, reader) => {
    values.gravity = types.Vector3f(reader, 0);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { gravity: 0x1 } }),
});

export const HeadingUpdateState = /* @__PURE__ */ field.data("filter_data.heading_update_state", 0x82, 0x14, (values, reader) => {
    values.heading = codec.float(reader, 0);
    values.headingUncertainty = codec.float(reader, 4);
    values.source = codec.u16(reader, 8);
    values.validFlags = codec.u16(reader, 10);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { heading: 0x1, headingUncertainty: 0x1 } }),
});

export const MagneticModel = /* @__PURE__ */ field.data("filter_data.magnetic_model", 0x82, 0x15, (values, reader) => {
    values.intensityNorth = codec.float(reader, 0);
    values.intensityEast = codec.float(reader, 4);
    values.intensityDown = codec.float(reader, 8);
    values.inclination = codec.float(reader, 12);
    values.declination = codec.float(reader, 16);
    values.validFlags = codec.u16(reader, 20);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { intensityNorth: 0x1, intensityEast: 0x1, intensityDown: 0x1, inclination: 0x1, declination: 0x1 } }),
});

export const GyroScaleFactor = /* @__PURE__ */ field.data("filter_data.gyro_scale_factor", 0x82, 0x16, (values, reader) => {
    values.scaleFactor = types.Vector3f(reader, 0);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { scaleFactor: 0x1 } }),
});

export const AccelScaleFactor = /* @__PURE__ */ field.data("filter_data.accel_scale_factor", 0x82, 0x17, (values, reader) => {
    values.scaleFactor = types.Vector3f(reader, 0);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { scaleFactor: 0x1 } }),
});

export const GyroScaleFactorUncertainty = /* @__PURE__ */ field.data("filter_data.gyro_scale_factor_uncertainty", 0x82, 0x18, (values, reader) => {
    values.scaleFactorUncertainty = types.Vector3f(reader, 0);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { scaleFactorUncertainty: 0x1 } }),
});

export const AccelScaleFactorUncertainty = /* @__PURE__ */ field.data("filter_data.accel_scale_factor_uncertainty", 0x82, 0x19, (values, reader) => {
    values.scaleFactorUncertainty = types.Vector3f(reader, 0);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { scaleFactorUncertainty: 0x1 } }),
});

export const MagBias = /* @__PURE__ */ field.data("filter_data.mag_bias", 0x82, 0x1a, (values, reader) => {
    values.bias = types.Vector3f(reader, 0);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { bias: 0x1 } }),
});

export const MagBiasUncertainty = /* @__PURE__ */ field.data("filter_data.mag_bias_uncertainty", 0x82, 0x1b, (values, reader) => {
    values.biasUncertainty = types.Vector3f(reader, 0);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { biasUncertainty: 0x1 } }),
});

export const CompAccel = /* @__PURE__ */ field.data("filter_data.comp_accel", 0x82, 0x1c, (values, reader) => {
    values.accel = types.Vector3f(reader, 0);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { accel: 0x1 } }),
});

export const StandardAtmosphere = /* @__PURE__ */ field.data("filter_data.standard_atmosphere", 0x82, 0x20, (values, reader) => {
    values.geometricAltitude = codec.float(reader, 0);
    values.geopotentialAltitude = codec.float(reader, 4);
    values.standardTemperature = codec.float(reader, 8);
    values.standardPressure = codec.float(reader, 12);
    values.standardDensity = codec.float(reader, 16);
    values.validFlags = codec.u16(reader, 20);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { geometricAltitude: 0x1, geopotentialAltitude: 0x1, standardTemperature: 0x1, standardPressure: 0x1, standardDensity: 0x1 } }),
});

export const PressureAltitude = /* @__PURE__ */ field.data("filter_data.pressure_altitude", 0x82, 0x21, (values, reader) => {
    values.pressureAltitude = codec.float(reader, 0);
    values.validFlags = codec.u16(reader, 4);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { pressureAltitude: 0x1 } }),
});

export const DensityAltitude = /* @__PURE__ */ field.data("filter_data.density_altitude", 0x82, 0x22, (values, reader) => {
    values.densityAltitude = codec.float(reader, 0);
    values.validFlags = codec.u16(reader, 4);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { densityAltitude: 0x1 } }),
});

export const MagOffset = /* @__PURE__ */ field.data("filter_data.mag_offset", 0x82, 0x25, (values, reader) => {
    values.hardIron = types.Vector3f(reader, 0);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { hardIron: 0x1 } }),
});

export const MagMatrix = /* @__PURE__ */ field.data("filter_data.mag_matrix", 0x82, 0x26, (values, reader) => {
    values.softIron = types.Matrix3f(reader, 0);
    values.validFlags = codec.u16(reader, 36);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { softIron: 0x1 } }),
});

export const MagOffsetUncertainty = /* @__PURE__ */ field.data("filter_data.mag_offset_uncertainty", 0x82, 0x28, (values, reader) => {
    values.hardIronUncertainty = types.Vector3f(reader, 0);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { hardIronUncertainty: 0x1 } }),
});

export const MagMatrixUncertainty = /* @__PURE__ */ field.data("filter_data.mag_matrix_uncertainty", 0x82, 0x29, (values, reader) => {
    values.softIronUncertainty = types.Matrix3f(reader, 0);
    values.validFlags = codec.u16(reader, 36);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { softIronUncertainty: 0x1 } }),
});

export const MagCovarianceMatrix = /* @__PURE__ */ field.data("filter_data.mag_covariance_matrix", 0x82, 0x2a, (values, reader) => {
    values.covariance = types.Matrix3f(reader, 0);
    values.validFlags = codec.u16(reader, 36);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { covariance: 0x1 } }),
});

export const MagResidualVector = /* @__PURE__ */ field.data("filter_data.mag_residual_vector", 0x82, 0x2c, (values, reader) => {
    values.residual = types.Vector3f(reader, 0);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { residual: 0x1 } }),
});

export const AntennaOffsetCorrection = /* @__PURE__ */ field.data("filter_data.antenna_offset_correction", 0x82, 0x30, (values, reader) => {
    values.offset = types.Vector3f(reader, 0);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { offset: 0x1 } }),
});

export const AntennaOffsetCorrectionUncertainty = /* @__PURE__ */ field.data("filter_data.antenna_offset_correction_uncertainty", 0x82, 0x31, (values, reader) => {
    values.offsetUncertainty = types.Vector3f(reader, 0);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { offsetUncertainty: 0x1 } }),
});

export const ClockCorrection = /* @__PURE__ */ field.data("filter_data.clock_correction", 0x82, 0x32, (values, reader) => {
    values.receiverId = codec.u8(reader, 0);
    values.bias = codec.float(reader, 1);
    values.biasDrift = codec.float(reader, 5);
    values.validFlags = codec.u16(reader, 9);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { bias: 0x1, biasDrift: 0x1 } }),
});

export const ClockCorrectionUncertainty = /* @__PURE__ */ field.data("filter_data.clock_correction_uncertainty", 0x82, 0x33, (values, reader) => {
    values.receiverId = codec.u8(reader, 0);
    values.biasUncertainty = codec.float(reader, 1);
    values.biasDriftUncertainty = codec.float(reader, 5);
    values.validFlags = codec.u16(reader, 9);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { biasUncertainty: 0x1, biasDriftUncertainty: 0x1 } }),
});

export const MultiAntennaOffsetCorrection = /* @__PURE__ */ field.data("filter_data.multi_antenna_offset_correction", 0x82, 0x34, (values, reader) => {
    values.receiverId = codec.u8(reader, 0);
    values.offset = types.Vector3f(reader, 1);
    values.validFlags = codec.u16(reader, 13);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { offset: 0x1 } }),
});

export const MultiAntennaOffsetCorrectionUncertainty = /* @__PURE__ */ field.data("filter_data.multi_antenna_offset_correction_uncertainty", 0x82, 0x35, (values, reader) => {
    values.receiverId = codec.u8(reader, 0);
    values.offsetUncertainty = types.Vector3f(reader, 1);
    values.validFlags = codec.u16(reader, 13);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { offsetUncertainty: 0x1 } }),
});

export const EcefPositionUncertainty = /* @__PURE__ */ field.data("filter_data.ecef_position_uncertainty", 0x82, 0x36, (values, reader) => {
    values.positionUncertainty = types.Vector3f(reader, 0);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { positionUncertainty: 0x1 } }),
});

export const EcefVelocityUncertainty = /* @__PURE__ */ field.data("filter_data.ecef_velocity_uncertainty", 0x82, 0x37, (values, reader) => {
    values.velocityUncertainty = types.Vector3f(reader, 0);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { velocityUncertainty: 0x1 } }),
});

export const EcefPosition = /* @__PURE__ */ field.data("filter_data.ecef_position", 0x82, 0x40, (values, reader) => {
    values.position = types.Vector3d(reader, 0);
    values.validFlags = codec.u16(reader, 24);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { position: 0x1 } }),
});

export const EcefVelocity = /* @__PURE__ */ field.data("filter_data.ecef_velocity", 0x82, 0x41, (values, reader) => {
    values.velocity = types.Vector3f(reader, 0);
    values.validFlags = codec.u16(reader, 12);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { velocity: 0x1 } }),
});

export const NedRelativePosition = /* @__PURE__ */ field.data("filter_data.ned_relative_position", 0x82, 0x42, (values, reader) => {
    values.relativePosition = types.Ned3d(reader, 0);
    values.validFlags = codec.u16(reader, 24);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { relativePosition: 0x1 } }),
});

export const GnssPositionAidingStatus = /* @__PURE__ */ field.data("filter_data.gnss_position_aiding_status", 0x82, 0x43, {
    receiverId: codec.u8,
    tow: codec.float,
    status: GnssAidingStatus,
    reserved: /* @__PURE__ */ codec.reserved(/* @__PURE__ */ codec.array(/* @__PURE__ */ codec.reserved(codec.u8, 0), 8), Array(8).fill(0)),
});

export const GnssAttitudeAidingStatus = /* @__PURE__ */ field.data("filter_data.gnss_attitude_aiding_status", 0x82, 0x44, {
    tow: codec.float,
    status: GnssAidingStatus,
    reserved: /* @__PURE__ */ codec.reserved(/* @__PURE__ */ codec.array(/* @__PURE__ */ codec.reserved(codec.u8, 0), 8), Array(8).fill(0)),
});

export const HeadingAidingStatus = /* @__PURE__ */ field.data("filter_data.heading_aiding_status", 0x82, 0x45, {
    tow: codec.float,
    type: HeadingAidingType,
    reserved: /* @__PURE__ */ codec.reserved(/* @__PURE__ */ codec.array(/* @__PURE__ */ codec.reserved(codec.float, 0.0), 2), Array(2).fill(0.0)),
});

export const AidingMeasurementSummary = /* @__PURE__ */ field.data("filter_data.aiding_measurement_summary", 0x82, 0x46, (values, reader) => {
    values.tow = codec.float(reader, 0);
    values.source = codec.u8(reader, 4);
    values.type = codec.u8(reader, 5);
    values.indicator = codec.u8(reader, 6);
});

export const OdometerScaleFactorError = /* @__PURE__ */ field.data("filter_data.odometer_scale_factor_error", 0x82, 0x47, (values, reader) => {
    values.scaleFactorError = codec.float(reader, 0);
    values.validFlags = codec.u16(reader, 4);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { scaleFactorError: 0x1 } }),
});

export const OdometerScaleFactorErrorUncertainty = /* @__PURE__ */ field.data("filter_data.odometer_scale_factor_error_uncertainty", 0x82, 0x48, (values, reader) => {
    values.scaleFactorErrorUncertainty = codec.float(reader, 0);
    values.validFlags = codec.u16(reader, 4);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { scaleFactorErrorUncertainty: 0x1 } }),
});

export const GnssDualAntennaStatus = /* @__PURE__ */ field.data("filter_data.gnss_dual_antenna_status", 0x82, 0x49, (values, reader) => {
    values.tow = codec.float(reader, 0);
    values.heading = codec.float(reader, 4);
    values.headingUncertainty = codec.float(reader, 8);
    values.fixType = codec.u8(reader, 12);
    values.statusFlags = codec.u16(reader, 13);
    values.validFlags = codec.u16(reader, 15);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { tow: 0x1, heading: 0x1, headingUncertainty: 0x1 } }),
});

export const AidingFrameConfigError = /* @__PURE__ */ field.data("filter_data.aiding_frame_config_error", 0x82, 0x50, (values, reader) => {
    values.frameId = codec.u8(reader, 0);
    values.translation = types.Vector3f(reader, 1);
    values.attitude = types.Quatf(reader, 13);
});

export const AidingFrameConfigErrorUncertainty = /* @__PURE__ */ field.data("filter_data.aiding_frame_config_error_uncertainty", 0x82, 0x51, (values, reader) => {
    values.frameId = codec.u8(reader, 0);
    values.translationUncertainty = types.Vector3f(reader, 1);
    values.attitudeUncertainty = types.Vector3f(reader, 13);
});
