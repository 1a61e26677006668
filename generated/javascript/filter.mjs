// Filter commands: the names and layouts of its fields. The declarations describe their meaning.

import * as codec from "./mip/codec.mjs";
import * as field from "./mip/field.mjs";
import { FunctionSelector } from "./protocol.mjs";
import * as types from "./types.mjs";

export const DynamicsMode = /* @__PURE__ */ codec.enumeration(codec.u8, {
    PORTABLE: 1,
    AUTOMOTIVE: 2,
    AIRBORNE: 3,
    AIRBORNE_HIGH_G: 4,
});

export const EstimatedStates = /* @__PURE__ */ codec.bitfield(codec.u16, {
    GYRO_BIAS: [0, 0],
    ACCEL_BIAS: [1, 1],
    GYRO_SCALE_FACTOR: [2, 2],
    ACCEL_SCALE_FACTOR: [3, 3],
    ANTENNA_OFFSET: [4, 4],
    AUTO_HARD_IRON: [5, 5],
    AUTO_SOFT_IRON: [6, 6],
});

export const GnssAidingSource = /* @__PURE__ */ codec.enumeration(codec.u8, {
    ALL_INTERNAL: 1,
    EXTERNAL: 2,
    INTERNAL_1: 3,
    INTERNAL_2: 4,
});

export const HeadingType = /* @__PURE__ */ codec.enumeration(codec.u8, {
    TRUE_HEADING: 1,
    MAGNETIC_HEADING: 2,
});

export const HeadingUpdateSource = /* @__PURE__ */ codec.enumeration(codec.u8, {
    NONE: 0,
    MAG: 1,
    GNSS_VELOCITY: 2,
    EXTERNAL: 3,
    GNSS_VELOCITY_AND_MAG: 4,
    GNSS_VELOCITY_AND_EXTERNAL: 5,
    MAG_AND_EXTERNAL: 6,
    ALL: 7,
});

export const TareAxes = /* @__PURE__ */ codec.bitfield(codec.u8, {
    ROLL: [0, 0],
    PITCH: [1, 1],
    YAW: [2, 2],
});

export const MeasurementFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    ACCEL: [0, 0],
    MAG: [1, 1],
});

export const MagParameterSource = /* @__PURE__ */ codec.enumeration(codec.u8, {
    NONE: 1,
    WMM: 2,
    MANUAL: 3,
});

export const AdaptiveMeasurementSelector = /* @__PURE__ */ codec.enumeration(codec.u8, {
    DISABLED: 0,
    FIXED: 1,
    AUTO: 2,
});

export const AltitudeAidingSource = /* @__PURE__ */ codec.enumeration(codec.u8, {
    NONE: 0,
    PRESSURE: 1,
});

export const PitchRollAidingSource = /* @__PURE__ */ codec.enumeration(codec.u8, {
    NONE: 0,
    GRAVITY_VECTOR: 1,
});

export const AidingSource = /* @__PURE__ */ codec.enumeration(codec.u16, {
    GNSS_POSITION_VELOCITY: 0,
    GNSS_HEADING: 1,
    ALTIMETER: 2,
    SPEED: 3,
    MAG: 4,
    EXTERNAL_HEADING: 5,
    EXTERNAL_ALTIMETER: 6,
    EXTERNAL_MAG: 7,
    BODY_FRAME_VELOCITY: 8,
    ALL: 65535,
});

export const AccelConstraint = /* @__PURE__ */ codec.enumeration(codec.u8, {
    NONE: 0,
    ZERO_ACCEL: 1,
});

export const VelocityConstraint = /* @__PURE__ */ codec.enumeration(codec.u8, {
    NONE: 0,
    ZERO_VELOCITY: 1,
    WHEELED_VEHICLE: 2,
});

export const AngularConstraint = /* @__PURE__ */ codec.enumeration(codec.u8, {
    NONE: 0,
    ZERO_ANGULAR_RATE: 1,
});

export const InitialConditionSource = /* @__PURE__ */ codec.enumeration(codec.u8, {
    AUTO_POSITION_VELOCITY_ATTITUDE: 0,
    AUTO_POSITION_VELOCITY_PITCH_ROLL: 1,
    AUTO_POSITION_VELOCITY: 2,
    MANUAL: 3,
});

export const HeadingAlignment = /* @__PURE__ */ codec.bitfield(codec.u8, {
    DUAL_ANTENNA: [0, 0],
    KINEMATIC: [1, 1],
    MAG: [2, 2],
    EXTERNAL: [3, 3],
});

export const ReferenceFrame = /* @__PURE__ */ codec.enumeration(codec.u8, {
    ECEF: 1,
    LLH: 2,
});

export const AdaptiveLevel = /* @__PURE__ */ codec.enumeration(codec.u8, {
    OFF: 0,
    CONSERVATIVE: 1,
    MODERATE: 2,
    AGGRESSIVE: 3,
});

export const RelativePositionSource = /* @__PURE__ */ codec.enumeration(codec.u8, {
    AUTO: 0,
    MANUAL: 1,
});

export const ReferencePoint = /* @__PURE__ */ codec.enumeration(codec.u8, {
    VEHICLE: 1,
});

export const VehicleDynamicsModeResponse = /* @__PURE__ */ field.response("filter.vehicle_dynamics_mode_response", 0x0d, 0x80, {
    mode: DynamicsMode,
});

export const SensorToVehicleRotationEulerResponse = /* @__PURE__ */ field.response("filter.sensor_to_vehicle_rotation_euler_response", 0x0d, 0x81, {
    roll: codec.float,
    pitch: codec.float,
    yaw: codec.float,
});

export const SensorToVehicleOffsetResponse = /* @__PURE__ */ field.response("filter.sensor_to_vehicle_offset_response", 0x0d, 0x82, {
    offset: types.Vector3f,
});

export const AntennaOffsetResponse = /* @__PURE__ */ field.response("filter.antenna_offset_response", 0x0d, 0x83, {
    offset: types.Vector3f,
});

export const EstimationControlResponse = /* @__PURE__ */ field.response("filter.estimation_control_response", 0x0d, 0x84, {
    flags: EstimatedStates,
});

export const GnssSourceResponse = /* @__PURE__ */ field.response("filter.gnss_source_response", 0x0d, 0x86, {
    source: GnssAidingSource,
});

export const HeadingSourceResponse = /* @__PURE__ */ field.response("filter.heading_source_response", 0x0d, 0x87, {
    source: HeadingUpdateSource,
});

export const AutoInitializationControlResponse = /* @__PURE__ */ field.response("filter.auto_initialization_control_response", 0x0d, 0x88, {
    enable: codec.u8,
});

export const AccelNoiseResponse = /* @__PURE__ */ field.response("filter.accel_noise_response", 0x0d, 0x89, {
    noise: types.Vector3f,
});

export const GyroNoiseResponse = /* @__PURE__ */ field.response("filter.gyro_noise_response", 0x0d, 0x8a, {
    noise: types.Vector3f,
});

export const AccelBiasModelResponse = /* @__PURE__ */ field.response("filter.accel_bias_model_response", 0x0d, 0x8b, {
    beta: types.Vector3f,
    noise: types.Vector3f,
});

export const GyroBiasModelResponse = /* @__PURE__ */ field.response("filter.gyro_bias_model_response", 0x0d, 0x8c, {
    beta: types.Vector3f,
    noise: types.Vector3f,
});

export const AutoZuptResponse = /* @__PURE__ */ field.response("filter.auto_zupt_response", 0x0d, 0x8d, {
    enable: codec.u8,
    threshold: codec.float,
});

export const AutoAngularZuptResponse = /* @__PURE__ */ field.response("filter.auto_angular_zupt_response", 0x0d, 0x8e, {
    enable: codec.u8,
    threshold: codec.float,
});

export const ReferencePositionResponse = /* @__PURE__ */ field.response("filter.reference_position_response", 0x0d, 0x90, {
    enable: codec.u8,
    latitude: codec.double,
    longitude: codec.double,
    altitude: codec.double,
});

export const GravityNoiseResponse = /* @__PURE__ */ field.response("filter.gravity_noise_response", 0x0d, 0x93, {
    noise: types.Vector3f,
});

export const PressureAltitudeNoiseResponse = /* @__PURE__ */ field.response("filter.pressure_altitude_noise_response", 0x0d, 0x94, {
    noise: codec.float,
});

export const HardIronOffsetNoiseResponse = /* @__PURE__ */ field.response("filter.hard_iron_offset_noise_response", 0x0d, 0x96, {
    noise: types.Vector3f,
});

export const SoftIronMatrixNoiseResponse = /* @__PURE__ */ field.response("filter.soft_iron_matrix_noise_response", 0x0d, 0x97, {
    noise: types.Matrix3f,
});

export const TareOrientationResponse = /* @__PURE__ */ field.response("filter.tare_orientation_response", 0x0d, 0xa1, {
    axes: TareAxes,
});

export const EnableMeasurementsResponse = /* @__PURE__ */ field.response("filter.enable_measurements_response", 0x0d, 0xb0, {
    control: MeasurementFlags,
});

export const MagNoiseResponse = /* @__PURE__ */ field.response("filter.mag_noise_response", 0x0d, 0xb1, {
    noise: types.Vector3f,
});

export const MagneticDeclinationSourceResponse = /* @__PURE__ */ field.response("filter.magnetic_declination_source_response", 0x0d, 0xb2, {
    source: MagParameterSource,
    declination: codec.float,
});

export const AccelMagnitudeErrorAdaptiveMeasurementResponse = /* @__PURE__ */ field.response("filter.accel_magnitude_error_adaptive_measurement_response", 0x0d, 0xb3, {
    adaptiveMeasurement: AdaptiveMeasurementSelector,
    frequency: codec.float,
    lowLimit: codec.float,
    highLimit: codec.float,
    lowLimitUncertainty: codec.float,
    highLimitUncertainty: codec.float,
    minimumUncertainty: codec.float,
});

export const MagMagnitudeErrorAdaptiveMeasurementResponse = /* @__PURE__ */ field.response("filter.mag_magnitude_error_adaptive_measurement_response", 0x0d, 0xb4, {
    adaptiveMeasurement: AdaptiveMeasurementSelector,
    frequency: codec.float,
    lowLimit: codec.float,
    highLimit: codec.float,
    lowLimitUncertainty: codec.float,
    highLimitUncertainty: codec.float,
    minimumUncertainty: codec.float,
});

export const MagDipAngleErrorAdaptiveMeasurementResponse = /* @__PURE__ */ field.response("filter.mag_dip_angle_error_adaptive_measurement_response", 0x0d, 0xb5, {
    enable: codec.bool,
    frequency: codec.float,
    highLimit: codec.float,
    highLimitUncertainty: codec.float,
    minimumUncertainty: codec.float,
});

export const AltitudeAidingResponse = /* @__PURE__ */ field.response("filter.altitude_aiding_response", 0x0d, 0xb7, {
    selector: AltitudeAidingSource,
});

export const PitchRollAidingResponse = /* @__PURE__ */ field.response("filter.pitch_roll_aiding_response", 0x0d, 0xbb, {
    aiding: PitchRollAidingSource,
});

export const MagneticInclinationSourceResponse = /* @__PURE__ */ field.response("filter.magnetic_inclination_source_response", 0x0d, 0xbc, {
    source: MagParameterSource,
    inclination: codec.float,
});

export const MagneticMagnitudeSourceResponse = /* @__PURE__ */ field.response("filter.magnetic_magnitude_source_response", 0x0d, 0xbd, {
    source: MagParameterSource,
    magnitude: codec.float,
});

export const SensorToVehicleRotationDcmResponse = /* @__PURE__ */ field.response("filter.sensor_to_vehicle_rotation_dcm_response", 0x0d, 0xbe, {
    dcm: types.Matrix3f,
});

export const SensorToVehicleRotationQuaternionResponse = /* @__PURE__ */ field.response("filter.sensor_to_vehicle_rotation_quaternion_response", 0x0d, 0xbf, {
    q: types.Quatf,
});

export const AidingMeasurementEnableResponse = /* @__PURE__ */ field.response("filter.aiding_measurement_enable_response", 0x0d, 0xd0, {
    aidingSource: AidingSource,
    enable: codec.bool,
});

export const KinematicConstraintResponse = /* @__PURE__ */ field.response("filter.kinematic_constraint_response", 0x0d, 0xd1, {
    accelConstraint: AccelConstraint,
    velocityConstraint: VelocityConstraint,
    angularConstraint: AngularConstraint,
});

export const InitializationConfigResponse = /* @__PURE__ */ field.response("filter.initialization_config_response", 0x0d, 0xd2, {
    waitForRunCommand: codec.u8,
    initialConditionSource: InitialConditionSource,
    autoHeadingAlignmentSelector: HeadingAlignment,
    initialHeading: codec.float,
    initialPitch: codec.float,
    initialRoll: codec.float,
    initialPosition: types.Vector3f,
    initialVelocity: types.Vector3f,
    referenceFrameSelector: ReferenceFrame,
});

export const AdaptiveFilterOptionsResponse = /* @__PURE__ */ field.response("filter.adaptive_filter_options_response", 0x0d, 0xd3, {
    level: AdaptiveLevel,
    timeLimit: codec.u16,
});

export const MultiAntennaOffsetResponse = /* @__PURE__ */ field.response("filter.multi_antenna_offset_response", 0x0d, 0xd4, {
    receiverId: codec.u8,
    antennaOffset: types.Vector3f,
});

export const RelativePositionConfigResponse = /* @__PURE__ */ field.response("filter.relative_position_config_response", 0x0d, 0xd5, {
    source: RelativePositionSource,
    referenceFrameSelector: ReferenceFrame,
    referenceCoordinates: types.Vector3d,
});

export const ReferencePointLeverArmResponse = /* @__PURE__ */ field.response("filter.reference_point_lever_arm_response", 0x0d, 0xd6, {
    referencePoint: ReferencePoint,
    leverArmOffset: types.Vector3f,
});

export const SpeedLeverArmResponse = /* @__PURE__ */ field.response("filter.speed_lever_arm_response", 0x0d, 0xe1, {
    source: /* @__PURE__ */ codec.reserved(codec.u8, 1),
    leverArmOffset: types.Vector3f,
});

export const VerticalGyroConstraintControlResponse = /* @__PURE__ */ field.response("filter.vertical_gyro_constraint_control_response", 0x0d, 0xe2, {
    enable: codec.u8,
});

export const WheeledVehicleConstraintControlResponse = /* @__PURE__ */ field.response("filter.wheeled_vehicle_constraint_control_response", 0x0d, 0xe3, {
    enable: codec.u8,
});

export const GnssAntennaCalibrationControlResponse = /* @__PURE__ */ field.response("filter.gnss_antenna_calibration_control_response", 0x0d, 0xe4, {
    enable: codec.u8,
    maxOffset: codec.float,
});

export const Reset = /* @__PURE__ */ field.command("filter.reset", 0x0d, 0x01, {});

export const SetInitialAttitude = /* @__PURE__ */ field.command("filter.set_initial_attitude", 0x0d, 0x02, {
    roll: codec.float,
    pitch: codec.float,
    heading: codec.float,
});

export const SetInitialHeading = /* @__PURE__ */ field.command("filter.set_initial_heading", 0x0d, 0x03, {
    heading: codec.float,
});

export const SetInitialAttitudeFromImu = /* @__PURE__ */ field.command("filter.set_initial_attitude_from_imu", 0x0d, 0x04, {
    declination: codec.float,
});

export const Run = /* @__PURE__ */ field.command("filter.run", 0x0d, 0x05, {});

export const VehicleDynamicsMode = /* @__PURE__ */ field.command("filter.vehicle_dynamics_mode", 0x0d, 0x10, {
    function: FunctionSelector,
    mode: DynamicsMode,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [VehicleDynamicsModeResponse]]],
});

export const SensorToVehicleRotationEuler = /* @__PURE__ */ field.command("filter.sensor_to_vehicle_rotation_euler", 0x0d, 0x11, {
    function: FunctionSelector,
    roll: codec.float,
    pitch: codec.float,
    yaw: codec.float,
}, {
    calls: [, 3, 0, 0, 0, 0],
    REPLIES: [[[2], [], [SensorToVehicleRotationEulerResponse]]],
});

export const SensorToVehicleOffset = /* @__PURE__ */ field.command("filter.sensor_to_vehicle_offset", 0x0d, 0x12, {
    function: FunctionSelector,
    offset: types.Vector3f,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [SensorToVehicleOffsetResponse]]],
});

export const AntennaOffset = /* @__PURE__ */ field.command("filter.antenna_offset", 0x0d, 0x13, {
    function: FunctionSelector,
    offset: types.Vector3f,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [AntennaOffsetResponse]]],
});

export const EstimationControl = /* @__PURE__ */ field.command("filter.estimation_control", 0x0d, 0x14, {
    function: FunctionSelector,
    flags: EstimatedStates,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [EstimationControlResponse]]],
});

export const GnssSource = /* @__PURE__ */ field.command("filter.gnss_source", 0x0d, 0x15, {
    function: FunctionSelector,
    source: GnssAidingSource,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [GnssSourceResponse]]],
});

export const ExternalGnssUpdate = /* @__PURE__ */ field.command("filter.external_gnss_update", 0x0d, 0x16, {
    tow: codec.double,
    weekNumber: codec.u16,
    latitude: codec.double,
    longitude: codec.double,
    height: codec.double,
    velocity: types.Ned3f,
    positionUncertainty: types.Ned3f,
    velocityUncertainty: types.Ned3f,
});

export const ExternalHeadingUpdate = /* @__PURE__ */ field.command("filter.external_heading_update", 0x0d, 0x17, {
    heading: codec.float,
    headingUncertainty: codec.float,
    type: HeadingType,
});

export const HeadingSource = /* @__PURE__ */ field.command("filter.heading_source", 0x0d, 0x18, {
    function: FunctionSelector,
    source: HeadingUpdateSource,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [HeadingSourceResponse]]],
});

export const AutoInitializationControl = /* @__PURE__ */ field.command("filter.auto_initialization_control", 0x0d, 0x19, {
    function: FunctionSelector,
    enable: codec.u8,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [AutoInitializationControlResponse]]],
});

export const AccelNoise = /* @__PURE__ */ field.command("filter.accel_noise", 0x0d, 0x1a, {
    function: FunctionSelector,
    noise: types.Vector3f,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [AccelNoiseResponse]]],
});

export const GyroNoise = /* @__PURE__ */ field.command("filter.gyro_noise", 0x0d, 0x1b, {
    function: FunctionSelector,
    noise: types.Vector3f,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [GyroNoiseResponse]]],
});

export const AccelBiasModel = /* @__PURE__ */ field.command("filter.accel_bias_model", 0x0d, 0x1c, {
    function: FunctionSelector,
    beta: types.Vector3f,
    noise: types.Vector3f,
}, {
    calls: [, 2, 0, 0, 0, 0],
    REPLIES: [[[2], [], [AccelBiasModelResponse]]],
});

export const GyroBiasModel = /* @__PURE__ */ field.command("filter.gyro_bias_model", 0x0d, 0x1d, {
    function: FunctionSelector,
    beta: types.Vector3f,
    noise: types.Vector3f,
}, {
    calls: [, 2, 0, 0, 0, 0],
    REPLIES: [[[2], [], [GyroBiasModelResponse]]],
});

export const AutoZupt = /* @__PURE__ */ field.command("filter.auto_zupt", 0x0d, 0x1e, {
    function: FunctionSelector,
    enable: codec.u8,
    threshold: codec.float,
}, {
    calls: [, 2, 0, 0, 0, 0],
    REPLIES: [[[2], [], [AutoZuptResponse]]],
});

export const ExternalHeadingUpdateWithTime = /* @__PURE__ */ field.command("filter.external_heading_update_with_time", 0x0d, 0x1f, {
    tow: codec.double,
    weekNumber: codec.u16,
    heading: codec.float,
    headingUncertainty: codec.float,
    type: HeadingType,
});

export const AutoAngularZupt = /* @__PURE__ */ field.command("filter.auto_angular_zupt", 0x0d, 0x20, {
    function: FunctionSelector,
    enable: codec.u8,
    threshold: codec.float,
}, {
    calls: [, 2, 0, 0, 0, 0],
    REPLIES: [[[2], [], [AutoAngularZuptResponse]]],
});

export const TareOrientation = /* @__PURE__ */ field.command("filter.tare_orientation", 0x0d, 0x21, {
    function: FunctionSelector,
    axes: TareAxes,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [TareOrientationResponse]]],
});

export const CommandedZupt = /* @__PURE__ */ field.command("filter.commanded_zupt", 0x0d, 0x22, {});

export const CommandedAngularZupt = /* @__PURE__ */ field.command("filter.commanded_angular_zupt", 0x0d, 0x23, {});

export const ReferencePosition = /* @__PURE__ */ field.command("filter.reference_position", 0x0d, 0x26, {
    function: FunctionSelector,
    enable: codec.u8,
    latitude: codec.double,
    longitude: codec.double,
    altitude: codec.double,
}, {
    calls: [, 4, 0, 0, 0, 0],
    REPLIES: [[[2], [], [ReferencePositionResponse]]],
});

export const MagCaptureAutoCalibration = /* @__PURE__ */ field.command("filter.mag_capture_auto_calibration", 0x0d, 0x27, {
    function: FunctionSelector,
}, {
    calls: [, 0,, 0],
});

export const GravityNoise = /* @__PURE__ */ field.command("filter.gravity_noise", 0x0d, 0x28, {
    function: FunctionSelector,
    noise: types.Vector3f,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [GravityNoiseResponse]]],
});

export const PressureAltitudeNoise = /* @__PURE__ */ field.command("filter.pressure_altitude_noise", 0x0d, 0x29, {
    function: FunctionSelector,
    noise: codec.float,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [PressureAltitudeNoiseResponse]]],
});

export const HardIronOffsetNoise = /* @__PURE__ */ field.command("filter.hard_iron_offset_noise", 0x0d, 0x2b, {
    function: FunctionSelector,
    noise: types.Vector3f,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [HardIronOffsetNoiseResponse]]],
});

export const SoftIronMatrixNoise = /* @__PURE__ */ field.command("filter.soft_iron_matrix_noise", 0x0d, 0x2c, {
    function: FunctionSelector,
    noise: types.Matrix3f,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [SoftIronMatrixNoiseResponse]]],
});

export const EnableMeasurements = /* @__PURE__ */ field.command("filter.enable_measurements", 0x0d, 0x41, {
    function: FunctionSelector,
    control: MeasurementFlags,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [EnableMeasurementsResponse]]],
});

export const MagNoise = /* @__PURE__ */ field.command("filter.mag_noise", 0x0d, 0x42, {
    function: FunctionSelector,
    noise: types.Vector3f,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [MagNoiseResponse]]],
});

export const MagneticDeclinationSource = /* @__PURE__ */ field.command("filter.magnetic_declination_source", 0x0d, 0x43, {
    function: FunctionSelector,
    source: MagParameterSource,
    declination: codec.float,
}, {
    calls: [, 2, 0, 0, 0, 0],
    REPLIES: [[[2], [], [MagneticDeclinationSourceResponse]]],
});

export const AccelMagnitudeErrorAdaptiveMeasurement = /* @__PURE__ */ field.command("filter.accel_magnitude_error_adaptive_measurement", 0x0d, 0x44, {
    function: FunctionSelector,
    adaptiveMeasurement: AdaptiveMeasurementSelector,
    frequency: codec.float,
    lowLimit: codec.float,
    highLimit: codec.float,
    lowLimitUncertainty: codec.float,
    highLimitUncertainty: codec.float,
    minimumUncertainty: codec.float,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [AccelMagnitudeErrorAdaptiveMeasurementResponse]]],
});

export const MagMagnitudeErrorAdaptiveMeasurement = /* @__PURE__ */ field.command("filter.mag_magnitude_error_adaptive_measurement", 0x0d, 0x45, {
    function: FunctionSelector,
    adaptiveMeasurement: AdaptiveMeasurementSelector,
    frequency: codec.float,
    lowLimit: codec.float,
    highLimit: codec.float,
    lowLimitUncertainty: codec.float,
    highLimitUncertainty: codec.float,
    minimumUncertainty: codec.float,
}, {
    calls: [, 7, 0, 0, 0, 0],
    REPLIES: [[[2], [], [MagMagnitudeErrorAdaptiveMeasurementResponse]]],
});

export const MagDipAngleErrorAdaptiveMeasurement = /* @__PURE__ */ field.command("filter.mag_dip_angle_error_adaptive_measurement", 0x0d, 0x46, {
    function: FunctionSelector,
    enable: codec.bool,
    frequency: codec.float,
    highLimit: codec.float,
    highLimitUncertainty: codec.float,
    minimumUncertainty: codec.float,
}, {
    calls: [, 5, 0, 0, 0, 0],
    REPLIES: [[[2], [], [MagDipAngleErrorAdaptiveMeasurementResponse]]],
});

export const AltitudeAiding = /* @__PURE__ */ field.command("filter.altitude_aiding", 0x0d, 0x47, {
    function: FunctionSelector,
    selector: AltitudeAidingSource,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [AltitudeAidingResponse]]],
});

export const PitchRollAiding = /* @__PURE__ */ field.command("filter.pitch_roll_aiding", 0x0d, 0x4b, {
    function: FunctionSelector,
    aiding: PitchRollAidingSource,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [PitchRollAidingResponse]]],
});

export const MagneticInclinationSource = /* @__PURE__ */ field.command("filter.magnetic_inclination_source", 0x0d, 0x4c, {
    function: FunctionSelector,
    source: MagParameterSource,
    inclination: codec.float,
}, {
    calls: [, 2, 0, 0, 0, 0],
    REPLIES: [[[2], [], [MagneticInclinationSourceResponse]]],
});

export const MagneticMagnitudeSource = /* @__PURE__ */ field.command("filter.magnetic_magnitude_source", 0x0d, 0x4d, {
    function: FunctionSelector,
    source: MagParameterSource,
    magnitude: codec.float,
}, {
    calls: [, 2, 0, 0, 0, 0],
    REPLIES: [[[2], [], [MagneticMagnitudeSourceResponse]]],
});

export const SensorToVehicleRotationDcm = /* @__PURE__ */ field.command("filter.sensor_to_vehicle_rotation_dcm", 0x0d, 0x4e, {
    function: FunctionSelector,
    dcm: types.Matrix3f,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [SensorToVehicleRotationDcmResponse]]],
});

export const SensorToVehicleRotationQuaternion = /* @__PURE__ */ field.command("filter.sensor_to_vehicle_rotation_quaternion", 0x0d, 0x4f, {
    function: FunctionSelector,
    q: types.Quatf,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [SensorToVehicleRotationQuaternionResponse]]],
});

export const AidingMeasurementEnable = /* @__PURE__ */ field.command("filter.aiding_measurement_enable", 0x0d, 0x50, {
    function: FunctionSelector,
    aidingSource: AidingSource,
    enable: codec.bool,
}, {
    calls: [, 2, 1, 1, 1, 1],
    REPLIES: [[[2], [], [AidingMeasurementEnableResponse]]],
});

export const KinematicConstraint = /* @__PURE__ */ field.command("filter.kinematic_constraint", 0x0d, 0x51, {
    function: FunctionSelector,
    accelConstraint: AccelConstraint,
    velocityConstraint: VelocityConstraint,
    angularConstraint: AngularConstraint,
}, {
    calls: [, 3, 0, 0, 0, 0],
    REPLIES: [[[2], [], [KinematicConstraintResponse]]],
});

export const InitializationConfig = /* @__PURE__ */ field.command("filter.initialization_config", 0x0d, 0x52, {
    function: FunctionSelector,
    waitForRunCommand: codec.u8,
    initialConditionSource: InitialConditionSource,
    autoHeadingAlignmentSelector: HeadingAlignment,
    initialHeading: codec.float,
    initialPitch: codec.float,
    initialRoll: codec.float,
    initialPosition: types.Vector3f,
    initialVelocity: types.Vector3f,
    referenceFrameSelector: ReferenceFrame,
}, {
    calls: [, 9, 0, 0, 0, 0],
    REPLIES: [[[2], [], [InitializationConfigResponse]]],
});

export const AdaptiveFilterOptions = /* @__PURE__ */ field.command("filter.adaptive_filter_options", 0x0d, 0x53, {
    function: FunctionSelector,
    level: AdaptiveLevel,
    timeLimit: codec.u16,
}, {
    calls: [, 2, 0, 0, 0, 0],
    REPLIES: [[[2], [], [AdaptiveFilterOptionsResponse]]],
});

export const MultiAntennaOffset = /* @__PURE__ */ field.command("filter.multi_antenna_offset", 0x0d, 0x54, {
    function: FunctionSelector,
    receiverId: codec.u8,
    antennaOffset: types.Vector3f,
}, {
    calls: [, 2, 1, 1, 1, 1],
    REPLIES: [[[2], [], [MultiAntennaOffsetResponse]]],
});

export const RelativePositionConfig = /* @__PURE__ */ field.command("filter.relative_position_config", 0x0d, 0x55, {
    function: FunctionSelector,
    source: RelativePositionSource,
    referenceFrameSelector: ReferenceFrame,
    referenceCoordinates: types.Vector3d,
}, {
    calls: [, 3, 0, 0, 0, 0],
    REPLIES: [[[2], [], [RelativePositionConfigResponse]]],
});

export const ReferencePointLeverArm = /* @__PURE__ */ field.command("filter.reference_point_lever_arm", 0x0d, 0x56, {
    function: FunctionSelector,
    referencePoint: ReferencePoint,
    leverArmOffset: types.Vector3f,
}, {
    calls: [, 2, 0, 0, 0, 0],
    REPLIES: [[[2], [], [ReferencePointLeverArmResponse]]],
});

export const SpeedMeasurement = /* @__PURE__ */ field.command("filter.speed_measurement", 0x0d, 0x60, {
    source: /* @__PURE__ */ codec.reserved(codec.u8, 1),
    tow: codec.float,
    speed: codec.float,
    speedUncertainty: codec.float,
});

export const SpeedLeverArm = /* @__PURE__ */ field.command("filter.speed_lever_arm", 0x0d, 0x61, {
    function: FunctionSelector,
    source: /* @__PURE__ */ codec.reserved(codec.u8, 1),
    leverArmOffset: types.Vector3f,
}, {
    calls: [, 2, 1, 1, 1, 1],
    REPLIES: [[[2], [], [SpeedLeverArmResponse]]],
});

export const VerticalGyroConstraintControl = /* @__PURE__ */ field.command("filter.vertical_gyro_constraint_control", 0x0d, 0x62, {
    function: FunctionSelector,
    enable: codec.u8,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [VerticalGyroConstraintControlResponse]]],
});

export const WheeledVehicleConstraintControl = /* @__PURE__ */ field.command("filter.wheeled_vehicle_constraint_control", 0x0d, 0x63, {
    function: FunctionSelector,
    enable: codec.u8,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [WheeledVehicleConstraintControlResponse]]],
});

export const GnssAntennaCalibrationControl = /* @__PURE__ */ field.command("filter.gnss_antenna_calibration_control", 0x0d, 0x64, {
    function: FunctionSelector,
    enable: codec.u8,
    maxOffset: codec.float,
}, {
    calls: [, 2, 0, 0, 0, 0],
    REPLIES: [[[2], [], [GnssAntennaCalibrationControlResponse]]],
});
