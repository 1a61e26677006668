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

export const LlhPosition = /* @__PURE__ */ field.data("filter_data.llh_position", 0x82, 0x01, {
    latitude: codec.double,
    longitude: codec.double,
    ellipsoid_height: codec.double,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { latitude: 0x1, longitude: 0x1, ellipsoidHeight: 0x1 } }),
});

export const NedVelocity = /* @__PURE__ */ field.data("filter_data.ned_velocity", 0x82, 0x02, {
    north: codec.float,
    east: codec.float,
    down: codec.float,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { north: 0x1, east: 0x1, down: 0x1 } }),
});

export const AttitudeQuaternion = /* @__PURE__ */ field.data("filter_data.attitude_quaternion", 0x82, 0x03, {
    q: types.Quatf,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { q: 0x1 } }),
});

export const AttitudeDcm = /* @__PURE__ */ field.data("filter_data.attitude_dcm", 0x82, 0x04, {
    dcm: types.Matrix3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { dcm: 0x1 } }),
});

export const EulerAngles = /* @__PURE__ */ field.data("filter_data.euler_angles", 0x82, 0x05, {
    roll: codec.float,
    pitch: codec.float,
    yaw: codec.float,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { roll: 0x1, pitch: 0x1, yaw: 0x1 } }),
});

export const GyroBias = /* @__PURE__ */ field.data("filter_data.gyro_bias", 0x82, 0x06, {
    bias: types.Vector3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { bias: 0x1 } }),
});

export const AccelBias = /* @__PURE__ */ field.data("filter_data.accel_bias", 0x82, 0x07, {
    bias: types.Vector3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { bias: 0x1 } }),
});

export const LlhPositionUncertainty = /* @__PURE__ */ field.data("filter_data.llh_position_uncertainty", 0x82, 0x08, {
    north: codec.float,
    east: codec.float,
    down: codec.float,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { north: 0x1, east: 0x1, down: 0x1 } }),
});

export const NedVelocityUncertainty = /* @__PURE__ */ field.data("filter_data.ned_velocity_uncertainty", 0x82, 0x09, {
    north: codec.float,
    east: codec.float,
    down: codec.float,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { north: 0x1, east: 0x1, down: 0x1 } }),
});

export const EulerAnglesUncertainty = /* @__PURE__ */ field.data("filter_data.euler_angles_uncertainty", 0x82, 0x0a, {
    roll: codec.float,
    pitch: codec.float,
    yaw: codec.float,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { roll: 0x1, pitch: 0x1, yaw: 0x1 } }),
});

export const GyroBiasUncertainty = /* @__PURE__ */ field.data("filter_data.gyro_bias_uncertainty", 0x82, 0x0b, {
    bias_uncertainty: types.Vector3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { biasUncertainty: 0x1 } }),
});

export const AccelBiasUncertainty = /* @__PURE__ */ field.data("filter_data.accel_bias_uncertainty", 0x82, 0x0c, {
    bias_uncertainty: types.Vector3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { biasUncertainty: 0x1 } }),
});

export const LinearAccel = /* @__PURE__ */ field.data("filter_data.linear_accel", 0x82, 0x0d, {
    accel: types.Vector3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { accel: 0x1 } }),
});

export const CompAngularRate = /* @__PURE__ */ field.data("filter_data.comp_angular_rate", 0x82, 0x0e, {
    gyro: types.Vector3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { gyro: 0x1 } }),
});

export const Wgs84GravityMagnitude = /* @__PURE__ */ field.data("filter_data.wgs84_gravity_magnitude", 0x82, 0x0f, {
    gravity_magnitude: codec.float,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { gravityMagnitude: 0x1 } }),
});

export const Status = /* @__PURE__ */ field.data("filter_data.status", 0x82, 0x10, {
    filter_state: codec.u16,
    dynamics_mode: codec.u16,
    status_flags: codec.u16,
});

export const Timestamp = /* @__PURE__ */ field.data("filter_data.timestamp", 0x82, 0x11, {
    tow: codec.double,
    week_number: codec.u16,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { tow: 0x1, weekNumber: 0x1 } }),
});

export const QuaternionAttitudeUncertainty = /* @__PURE__ */ field.data("filter_data.quaternion_attitude_uncertainty", 0x82, 0x12, {
    q: types.Quatf,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { q: 0x1 } }),
});

export const GravityVector = /* @__PURE__ */ field.data("filter_data.gravity_vector", 0x82, 0x13, {
    gravity: types.Vector3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { gravity: 0x1 } }),
});

export const HeadingUpdateState = /* @__PURE__ */ field.data("filter_data.heading_update_state", 0x82, 0x14, {
    heading: codec.float,
    heading_uncertainty: codec.float,
    source: HeadingSourceFlags,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { heading: 0x1, headingUncertainty: 0x1 } }),
});

export const MagneticModel = /* @__PURE__ */ field.data("filter_data.magnetic_model", 0x82, 0x15, {
    intensity_north: codec.float,
    intensity_east: codec.float,
    intensity_down: codec.float,
    inclination: codec.float,
    declination: codec.float,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { intensityNorth: 0x1, intensityEast: 0x1, intensityDown: 0x1, inclination: 0x1, declination: 0x1 } }),
});

export const GyroScaleFactor = /* @__PURE__ */ field.data("filter_data.gyro_scale_factor", 0x82, 0x16, {
    scale_factor: types.Vector3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { scaleFactor: 0x1 } }),
});

export const AccelScaleFactor = /* @__PURE__ */ field.data("filter_data.accel_scale_factor", 0x82, 0x17, {
    scale_factor: types.Vector3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { scaleFactor: 0x1 } }),
});

export const GyroScaleFactorUncertainty = /* @__PURE__ */ field.data("filter_data.gyro_scale_factor_uncertainty", 0x82, 0x18, {
    scale_factor_uncertainty: types.Vector3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { scaleFactorUncertainty: 0x1 } }),
});

export const AccelScaleFactorUncertainty = /* @__PURE__ */ field.data("filter_data.accel_scale_factor_uncertainty", 0x82, 0x19, {
    scale_factor_uncertainty: types.Vector3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { scaleFactorUncertainty: 0x1 } }),
});

export const MagBias = /* @__PURE__ */ field.data("filter_data.mag_bias", 0x82, 0x1a, {
    bias: types.Vector3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { bias: 0x1 } }),
});

export const MagBiasUncertainty = /* @__PURE__ */ field.data("filter_data.mag_bias_uncertainty", 0x82, 0x1b, {
    bias_uncertainty: types.Vector3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { biasUncertainty: 0x1 } }),
});

export const CompAccel = /* @__PURE__ */ field.data("filter_data.comp_accel", 0x82, 0x1c, {
    accel: types.Vector3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { accel: 0x1 } }),
});

export const StandardAtmosphere = /* @__PURE__ */ field.data("filter_data.standard_atmosphere", 0x82, 0x20, {
    geometric_altitude: codec.float,
    geopotential_altitude: codec.float,
    standard_temperature: codec.float,
    standard_pressure: codec.float,
    standard_density: codec.float,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { geometricAltitude: 0x1, geopotentialAltitude: 0x1, standardTemperature: 0x1, standardPressure: 0x1, standardDensity: 0x1 } }),
});

export const PressureAltitude = /* @__PURE__ */ field.data("filter_data.pressure_altitude", 0x82, 0x21, {
    pressure_altitude: codec.float,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { pressureAltitude: 0x1 } }),
});

export const DensityAltitude = /* @__PURE__ */ field.data("filter_data.density_altitude", 0x82, 0x22, {
    density_altitude: codec.float,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { densityAltitude: 0x1 } }),
});

export const MagOffset = /* @__PURE__ */ field.data("filter_data.mag_offset", 0x82, 0x25, {
    hard_iron: types.Vector3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { hardIron: 0x1 } }),
});

export const MagMatrix = /* @__PURE__ */ field.data("filter_data.mag_matrix", 0x82, 0x26, {
    soft_iron: types.Matrix3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { softIron: 0x1 } }),
});

export const MagOffsetUncertainty = /* @__PURE__ */ field.data("filter_data.mag_offset_uncertainty", 0x82, 0x28, {
    hard_iron_uncertainty: types.Vector3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { hardIronUncertainty: 0x1 } }),
});

export const MagMatrixUncertainty = /* @__PURE__ */ field.data("filter_data.mag_matrix_uncertainty", 0x82, 0x29, {
    soft_iron_uncertainty: types.Matrix3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { softIronUncertainty: 0x1 } }),
});

export const MagCovarianceMatrix = /* @__PURE__ */ field.data("filter_data.mag_covariance_matrix", 0x82, 0x2a, {
    covariance: types.Matrix3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { covariance: 0x1 } }),
});

export const MagResidualVector = /* @__PURE__ */ field.data("filter_data.mag_residual_vector", 0x82, 0x2c, {
    residual: types.Vector3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { residual: 0x1 } }),
});

export const AntennaOffsetCorrection = /* @__PURE__ */ field.data("filter_data.antenna_offset_correction", 0x82, 0x30, {
    offset: types.Vector3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { offset: 0x1 } }),
});

export const AntennaOffsetCorrectionUncertainty = /* @__PURE__ */ field.data("filter_data.antenna_offset_correction_uncertainty", 0x82, 0x31, {
    offset_uncertainty: types.Vector3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { offsetUncertainty: 0x1 } }),
});

export const ClockCorrection = /* @__PURE__ */ field.data("filter_data.clock_correction", 0x82, 0x32, {
    receiver_id: codec.u8,
    bias: codec.float,
    bias_drift: codec.float,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { bias: 0x1, biasDrift: 0x1 } }),
});

export const ClockCorrectionUncertainty = /* @__PURE__ */ field.data("filter_data.clock_correction_uncertainty", 0x82, 0x33, {
    receiver_id: codec.u8,
    bias_uncertainty: codec.float,
    bias_drift_uncertainty: codec.float,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { biasUncertainty: 0x1, biasDriftUncertainty: 0x1 } }),
});

export const MultiAntennaOffsetCorrection = /* @__PURE__ */ field.data("filter_data.multi_antenna_offset_correction", 0x82, 0x34, {
    receiver_id: codec.u8,
    offset: types.Vector3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { offset: 0x1 } }),
});

export const MultiAntennaOffsetCorrectionUncertainty = /* @__PURE__ */ field.data("filter_data.multi_antenna_offset_correction_uncertainty", 0x82, 0x35, {
    receiver_id: codec.u8,
    offset_uncertainty: types.Vector3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { offsetUncertainty: 0x1 } }),
});

export const EcefPositionUncertainty = /* @__PURE__ */ field.data("filter_data.ecef_position_uncertainty", 0x82, 0x36, {
    position_uncertainty: types.Vector3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { positionUncertainty: 0x1 } }),
});

export const EcefVelocityUncertainty = /* @__PURE__ */ field.data("filter_data.ecef_velocity_uncertainty", 0x82, 0x37, {
    velocity_uncertainty: types.Vector3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { velocityUncertainty: 0x1 } }),
});

export const EcefPosition = /* @__PURE__ */ field.data("filter_data.ecef_position", 0x82, 0x40, {
    position: types.Vector3d,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { position: 0x1 } }),
});

export const EcefVelocity = /* @__PURE__ */ field.data("filter_data.ecef_velocity", 0x82, 0x41, {
    velocity: types.Vector3f,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { velocity: 0x1 } }),
});

export const NedRelativePosition = /* @__PURE__ */ field.data("filter_data.ned_relative_position", 0x82, 0x42, {
    relative_position: types.Ned3d,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { relativePosition: 0x1 } }),
});

export const GnssPositionAidingStatus = /* @__PURE__ */ field.data("filter_data.gnss_position_aiding_status", 0x82, 0x43, {
    receiver_id: codec.u8,
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

export const AidingMeasurementSummary = /* @__PURE__ */ field.data("filter_data.aiding_measurement_summary", 0x82, 0x46, {
    tow: codec.float,
    source: codec.u8,
    type: AidingMeasurementType,
    indicator: AidingMeasurementIndicator,
});

export const OdometerScaleFactorError = /* @__PURE__ */ field.data("filter_data.odometer_scale_factor_error", 0x82, 0x47, {
    scale_factor_error: codec.float,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { scaleFactorError: 0x1 } }),
});

export const OdometerScaleFactorErrorUncertainty = /* @__PURE__ */ field.data("filter_data.odometer_scale_factor_error_uncertainty", 0x82, 0x48, {
    scale_factor_error_uncertainty: codec.float,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { scaleFactorErrorUncertainty: 0x1 } }),
});

export const GnssDualAntennaStatus = /* @__PURE__ */ field.data("filter_data.gnss_dual_antenna_status", 0x82, 0x49, {
    tow: codec.float,
    heading: codec.float,
    heading_uncertainty: codec.float,
    fix_type: DualAntennaFixType,
    status_flags: DualAntennaStatusFlags,
    valid_flags: ValidFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { tow: 0x1, heading: 0x1, headingUncertainty: 0x1 } }),
});

export const AidingFrameConfigError = /* @__PURE__ */ field.data("filter_data.aiding_frame_config_error", 0x82, 0x50, {
    frame_id: codec.u8,
    translation: types.Vector3f,
    attitude: types.Quatf,
});

export const AidingFrameConfigErrorUncertainty = /* @__PURE__ */ field.data("filter_data.aiding_frame_config_error_uncertainty", 0x82, 0x51, {
    frame_id: codec.u8,
    translation_uncertainty: types.Vector3f,
    attitude_uncertainty: types.Vector3f,
});
