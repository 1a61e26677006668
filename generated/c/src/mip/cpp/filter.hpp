/**
 * @file
 * Filter commands, in C++17: see mip/filter.h.
 */
#ifndef MIP_FILTER_HPP
#define MIP_FILTER_HPP

#include "mip/filter_inline.h"
#include "mip/cpp/types.hpp"

namespace mip {

MIP_LAYOUT(mip_filter_reset, MIP_FILTER_RESET, MIP_FILTER_RESET, "filter.reset", decode)
MIP_LAYOUT(mip_filter_set_initial_attitude, MIP_FILTER_SET_INITIAL_ATTITUDE,
           MIP_FILTER_SET_INITIAL_ATTITUDE, "filter.set_initial_attitude", decode_inline)
MIP_LAYOUT(mip_filter_set_initial_heading, MIP_FILTER_SET_INITIAL_HEADING,
           MIP_FILTER_SET_INITIAL_HEADING, "filter.set_initial_heading", decode_inline)
MIP_LAYOUT(mip_filter_set_initial_attitude_from_imu, MIP_FILTER_SET_INITIAL_ATTITUDE_FROM_IMU,
           MIP_FILTER_SET_INITIAL_ATTITUDE_FROM_IMU, "filter.set_initial_attitude_from_imu",
           decode_inline)
MIP_LAYOUT(mip_filter_run, MIP_FILTER_RUN, MIP_FILTER_RUN, "filter.run", decode)
MIP_LAYOUT(mip_filter_vehicle_dynamics_mode, MIP_FILTER_VEHICLE_DYNAMICS_MODE,
           MIP_FILTER_VEHICLE_DYNAMICS_MODE, "filter.vehicle_dynamics_mode", decode)
MIP_LAYOUT(mip_filter_sensor_to_vehicle_rotation_euler, MIP_FILTER_SENSOR_TO_VEHICLE_ROTATION_EULER,
           MIP_FILTER_SENSOR_TO_VEHICLE_ROTATION_EULER, "filter.sensor_to_vehicle_rotation_euler",
           decode)
MIP_LAYOUT(mip_filter_sensor_to_vehicle_offset, MIP_FILTER_SENSOR_TO_VEHICLE_OFFSET,
           MIP_FILTER_SENSOR_TO_VEHICLE_OFFSET, "filter.sensor_to_vehicle_offset", decode)
MIP_LAYOUT(mip_filter_antenna_offset, MIP_FILTER_ANTENNA_OFFSET, MIP_FILTER_ANTENNA_OFFSET,
           "filter.antenna_offset", decode)
MIP_LAYOUT(mip_filter_estimation_control, MIP_FILTER_ESTIMATION_CONTROL,
           MIP_FILTER_ESTIMATION_CONTROL, "filter.estimation_control", decode)
MIP_LAYOUT(mip_filter_gnss_source, MIP_FILTER_GNSS_SOURCE, MIP_FILTER_GNSS_SOURCE,
           "filter.gnss_source", decode)
MIP_LAYOUT(mip_filter_external_gnss_update, MIP_FILTER_EXTERNAL_GNSS_UPDATE,
           MIP_FILTER_EXTERNAL_GNSS_UPDATE, "filter.external_gnss_update", decode_inline)
MIP_LAYOUT(mip_filter_external_heading_update, MIP_FILTER_EXTERNAL_HEADING_UPDATE,
           MIP_FILTER_EXTERNAL_HEADING_UPDATE, "filter.external_heading_update", decode_inline)
MIP_LAYOUT(mip_filter_heading_source, MIP_FILTER_HEADING_SOURCE, MIP_FILTER_HEADING_SOURCE,
           "filter.heading_source", decode)
MIP_LAYOUT(mip_filter_auto_initialization_control, MIP_FILTER_AUTO_INITIALIZATION_CONTROL,
           MIP_FILTER_AUTO_INITIALIZATION_CONTROL, "filter.auto_initialization_control", decode)
MIP_LAYOUT(mip_filter_accel_noise, MIP_FILTER_ACCEL_NOISE, MIP_FILTER_ACCEL_NOISE,
           "filter.accel_noise", decode)
MIP_LAYOUT(mip_filter_gyro_noise, MIP_FILTER_GYRO_NOISE, MIP_FILTER_GYRO_NOISE, "filter.gyro_noise",
           decode)
MIP_LAYOUT(mip_filter_accel_bias_model, MIP_FILTER_ACCEL_BIAS_MODEL, MIP_FILTER_ACCEL_BIAS_MODEL,
           "filter.accel_bias_model", decode)
MIP_LAYOUT(mip_filter_gyro_bias_model, MIP_FILTER_GYRO_BIAS_MODEL, MIP_FILTER_GYRO_BIAS_MODEL,
           "filter.gyro_bias_model", decode)
MIP_LAYOUT(mip_filter_auto_zupt, MIP_FILTER_AUTO_ZUPT, MIP_FILTER_AUTO_ZUPT, "filter.auto_zupt",
           decode)
MIP_LAYOUT(mip_filter_external_heading_update_with_time,
           MIP_FILTER_EXTERNAL_HEADING_UPDATE_WITH_TIME,
           MIP_FILTER_EXTERNAL_HEADING_UPDATE_WITH_TIME, "filter.external_heading_update_with_time",
           decode_inline)
MIP_LAYOUT(mip_filter_auto_angular_zupt, MIP_FILTER_AUTO_ANGULAR_ZUPT, MIP_FILTER_AUTO_ANGULAR_ZUPT,
           "filter.auto_angular_zupt", decode)
MIP_LAYOUT(mip_filter_tare_orientation, MIP_FILTER_TARE_ORIENTATION, MIP_FILTER_TARE_ORIENTATION,
           "filter.tare_orientation", decode)
MIP_LAYOUT(mip_filter_commanded_zupt, MIP_FILTER_COMMANDED_ZUPT, MIP_FILTER_COMMANDED_ZUPT,
           "filter.commanded_zupt", decode)
MIP_LAYOUT(mip_filter_commanded_angular_zupt, MIP_FILTER_COMMANDED_ANGULAR_ZUPT,
           MIP_FILTER_COMMANDED_ANGULAR_ZUPT, "filter.commanded_angular_zupt", decode)
MIP_LAYOUT(mip_filter_reference_position, MIP_FILTER_REFERENCE_POSITION,
           MIP_FILTER_REFERENCE_POSITION, "filter.reference_position", decode)
MIP_LAYOUT(mip_filter_mag_capture_auto_calibration, MIP_FILTER_MAG_CAPTURE_AUTO_CALIBRATION,
           MIP_FILTER_MAG_CAPTURE_AUTO_CALIBRATION, "filter.mag_capture_auto_calibration",
           decode_inline)
MIP_LAYOUT(mip_filter_gravity_noise, MIP_FILTER_GRAVITY_NOISE, MIP_FILTER_GRAVITY_NOISE,
           "filter.gravity_noise", decode)
MIP_LAYOUT(mip_filter_pressure_altitude_noise, MIP_FILTER_PRESSURE_ALTITUDE_NOISE,
           MIP_FILTER_PRESSURE_ALTITUDE_NOISE, "filter.pressure_altitude_noise", decode)
MIP_LAYOUT(mip_filter_hard_iron_offset_noise, MIP_FILTER_HARD_IRON_OFFSET_NOISE,
           MIP_FILTER_HARD_IRON_OFFSET_NOISE, "filter.hard_iron_offset_noise", decode)
MIP_LAYOUT(mip_filter_soft_iron_matrix_noise, MIP_FILTER_SOFT_IRON_MATRIX_NOISE,
           MIP_FILTER_SOFT_IRON_MATRIX_NOISE, "filter.soft_iron_matrix_noise", decode)
MIP_LAYOUT(mip_filter_enable_measurements, MIP_FILTER_ENABLE_MEASUREMENTS,
           MIP_FILTER_ENABLE_MEASUREMENTS, "filter.enable_measurements", decode)
MIP_LAYOUT(mip_filter_mag_noise, MIP_FILTER_MAG_NOISE, MIP_FILTER_MAG_NOISE, "filter.mag_noise",
           decode)
MIP_LAYOUT(mip_filter_magnetic_declination_source, MIP_FILTER_MAGNETIC_DECLINATION_SOURCE,
           MIP_FILTER_MAGNETIC_DECLINATION_SOURCE, "filter.magnetic_declination_source", decode)
MIP_LAYOUT(mip_filter_accel_magnitude_adaptive, MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE,
           MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE, "filter.accel_magnitude_error_adaptive_measurement",
           decode)
MIP_LAYOUT(mip_filter_mag_magnitude_adaptive, MIP_FILTER_MAG_MAGNITUDE_ADAPTIVE,
           MIP_FILTER_MAG_MAGNITUDE_ADAPTIVE, "filter.mag_magnitude_error_adaptive_measurement",
           decode)
MIP_LAYOUT(mip_filter_mag_dip_angle_adaptive, MIP_FILTER_MAG_DIP_ANGLE_ADAPTIVE,
           MIP_FILTER_MAG_DIP_ANGLE_ADAPTIVE, "filter.mag_dip_angle_error_adaptive_measurement",
           decode)
MIP_LAYOUT(mip_filter_altitude_aiding, MIP_FILTER_ALTITUDE_AIDING, MIP_FILTER_ALTITUDE_AIDING,
           "filter.altitude_aiding", decode)
MIP_LAYOUT(mip_filter_pitch_roll_aiding, MIP_FILTER_PITCH_ROLL_AIDING, MIP_FILTER_PITCH_ROLL_AIDING,
           "filter.pitch_roll_aiding", decode)
MIP_LAYOUT(mip_filter_magnetic_inclination_source, MIP_FILTER_MAGNETIC_INCLINATION_SOURCE,
           MIP_FILTER_MAGNETIC_INCLINATION_SOURCE, "filter.magnetic_inclination_source", decode)
MIP_LAYOUT(mip_filter_magnetic_magnitude_source, MIP_FILTER_MAGNETIC_MAGNITUDE_SOURCE,
           MIP_FILTER_MAGNETIC_MAGNITUDE_SOURCE, "filter.magnetic_magnitude_source", decode)
MIP_LAYOUT(mip_filter_sensor_to_vehicle_rotation_dcm, MIP_FILTER_SENSOR_TO_VEHICLE_ROTATION_DCM,
           MIP_FILTER_SENSOR_TO_VEHICLE_ROTATION_DCM, "filter.sensor_to_vehicle_rotation_dcm",
           decode)
MIP_LAYOUT(mip_filter_sensor_to_vehicle_quaternion, MIP_FILTER_SENSOR_TO_VEHICLE_QUATERNION,
           MIP_FILTER_SENSOR_TO_VEHICLE_QUATERNION, "filter.sensor_to_vehicle_rotation_quaternion",
           decode)
MIP_LAYOUT(mip_filter_aiding_measurement_enable, MIP_FILTER_AIDING_MEASUREMENT_ENABLE,
           MIP_FILTER_AIDING_MEASUREMENT_ENABLE, "filter.aiding_measurement_enable", decode)
MIP_LAYOUT(mip_filter_kinematic_constraint, MIP_FILTER_KINEMATIC_CONSTRAINT,
           MIP_FILTER_KINEMATIC_CONSTRAINT, "filter.kinematic_constraint", decode)
MIP_LAYOUT(mip_filter_initialization_config, MIP_FILTER_INITIALIZATION_CONFIG,
           MIP_FILTER_INITIALIZATION_CONFIG, "filter.initialization_config", decode)
MIP_LAYOUT(mip_filter_adaptive_filter_options, MIP_FILTER_ADAPTIVE_FILTER_OPTIONS,
           MIP_FILTER_ADAPTIVE_FILTER_OPTIONS, "filter.adaptive_filter_options", decode)
MIP_LAYOUT(mip_filter_multi_antenna_offset, MIP_FILTER_MULTI_ANTENNA_OFFSET,
           MIP_FILTER_MULTI_ANTENNA_OFFSET, "filter.multi_antenna_offset", decode)
MIP_LAYOUT(mip_filter_relative_position_config, MIP_FILTER_RELATIVE_POSITION_CONFIG,
           MIP_FILTER_RELATIVE_POSITION_CONFIG, "filter.relative_position_config", decode)
MIP_LAYOUT(mip_filter_reference_point_lever_arm, MIP_FILTER_REFERENCE_POINT_LEVER_ARM,
           MIP_FILTER_REFERENCE_POINT_LEVER_ARM, "filter.reference_point_lever_arm", decode)
MIP_LAYOUT(mip_filter_speed_measurement, MIP_FILTER_SPEED_MEASUREMENT, MIP_FILTER_SPEED_MEASUREMENT,
           "filter.speed_measurement", decode_inline)
MIP_LAYOUT(mip_filter_speed_lever_arm, MIP_FILTER_SPEED_LEVER_ARM, MIP_FILTER_SPEED_LEVER_ARM,
           "filter.speed_lever_arm", decode)
MIP_LAYOUT(mip_filter_vertical_gyro_constraint_control, MIP_FILTER_VERTICAL_GYRO_CONSTRAINT_CONTROL,
           MIP_FILTER_VERTICAL_GYRO_CONSTRAINT_CONTROL, "filter.vertical_gyro_constraint_control",
           decode)
MIP_LAYOUT(mip_filter_wheeled_vehicle_constraint_control,
           MIP_FILTER_WHEELED_VEHICLE_CONSTRAINT_CONTROL,
           MIP_FILTER_WHEELED_VEHICLE_CONSTRAINT_CONTROL,
           "filter.wheeled_vehicle_constraint_control", decode)
MIP_LAYOUT(mip_filter_gnss_antenna_calibration_control, MIP_FILTER_GNSS_ANTENNA_CALIBRATION_CONTROL,
           MIP_FILTER_GNSS_ANTENNA_CALIBRATION_CONTROL, "filter.gnss_antenna_calibration_control",
           decode)
MIP_LAYOUT(mip_filter_vehicle_dynamics_mode_response, MIP_FILTER_VEHICLE_DYNAMICS_MODE_RESPONSE,
           MIP_FILTER_VEHICLE_DYNAMICS_MODE_RESPONSE, "filter.vehicle_dynamics_mode_response",
           decode_inline)
MIP_LAYOUT(mip_filter_sensor_to_vehicle_rotation_euler_response,
           MIP_FILTER_SENSOR_TO_VEHICLE_ROTATION_EULER_RESPONSE,
           MIP_FILTER_SENSOR_TO_VEHICLE_ROTATION_EULER_RESPONSE,
           "filter.sensor_to_vehicle_rotation_euler_response", decode_inline)
MIP_LAYOUT(mip_filter_sensor_to_vehicle_offset_response,
           MIP_FILTER_SENSOR_TO_VEHICLE_OFFSET_RESPONSE,
           MIP_FILTER_SENSOR_TO_VEHICLE_OFFSET_RESPONSE, "filter.sensor_to_vehicle_offset_response",
           decode_inline)
MIP_LAYOUT(mip_filter_antenna_offset_response, MIP_FILTER_ANTENNA_OFFSET_RESPONSE,
           MIP_FILTER_ANTENNA_OFFSET_RESPONSE, "filter.antenna_offset_response", decode_inline)
MIP_LAYOUT(mip_filter_estimation_control_response, MIP_FILTER_ESTIMATION_CONTROL_RESPONSE,
           MIP_FILTER_ESTIMATION_CONTROL_RESPONSE, "filter.estimation_control_response",
           decode_inline)
MIP_LAYOUT(mip_filter_gnss_source_response, MIP_FILTER_GNSS_SOURCE_RESPONSE,
           MIP_FILTER_GNSS_SOURCE_RESPONSE, "filter.gnss_source_response", decode_inline)
MIP_LAYOUT(mip_filter_heading_source_response, MIP_FILTER_HEADING_SOURCE_RESPONSE,
           MIP_FILTER_HEADING_SOURCE_RESPONSE, "filter.heading_source_response", decode_inline)
MIP_LAYOUT(mip_filter_auto_initialization_control_response,
           MIP_FILTER_AUTO_INITIALIZATION_CONTROL_RESPONSE,
           MIP_FILTER_AUTO_INITIALIZATION_CONTROL_RESPONSE,
           "filter.auto_initialization_control_response", decode_inline)
MIP_LAYOUT(mip_filter_accel_noise_response, MIP_FILTER_ACCEL_NOISE_RESPONSE,
           MIP_FILTER_ACCEL_NOISE_RESPONSE, "filter.accel_noise_response", decode_inline)
MIP_LAYOUT(mip_filter_gyro_noise_response, MIP_FILTER_GYRO_NOISE_RESPONSE,
           MIP_FILTER_GYRO_NOISE_RESPONSE, "filter.gyro_noise_response", decode_inline)
MIP_LAYOUT(mip_filter_accel_bias_model_response, MIP_FILTER_ACCEL_BIAS_MODEL_RESPONSE,
           MIP_FILTER_ACCEL_BIAS_MODEL_RESPONSE, "filter.accel_bias_model_response", decode_inline)
MIP_LAYOUT(mip_filter_gyro_bias_model_response, MIP_FILTER_GYRO_BIAS_MODEL_RESPONSE,
           MIP_FILTER_GYRO_BIAS_MODEL_RESPONSE, "filter.gyro_bias_model_response", decode_inline)
MIP_LAYOUT(mip_filter_auto_zupt_response, MIP_FILTER_AUTO_ZUPT_RESPONSE,
           MIP_FILTER_AUTO_ZUPT_RESPONSE, "filter.auto_zupt_response", decode_inline)
MIP_LAYOUT(mip_filter_auto_angular_zupt_response, MIP_FILTER_AUTO_ANGULAR_ZUPT_RESPONSE,
           MIP_FILTER_AUTO_ANGULAR_ZUPT_RESPONSE, "filter.auto_angular_zupt_response",
           decode_inline)
MIP_LAYOUT(mip_filter_reference_position_response, MIP_FILTER_REFERENCE_POSITION_RESPONSE,
           MIP_FILTER_REFERENCE_POSITION_RESPONSE, "filter.reference_position_response",
           decode_inline)
MIP_LAYOUT(mip_filter_gravity_noise_response, MIP_FILTER_GRAVITY_NOISE_RESPONSE,
           MIP_FILTER_GRAVITY_NOISE_RESPONSE, "filter.gravity_noise_response", decode_inline)
MIP_LAYOUT(mip_filter_pressure_altitude_noise_response, MIP_FILTER_PRESSURE_ALTITUDE_NOISE_RESPONSE,
           MIP_FILTER_PRESSURE_ALTITUDE_NOISE_RESPONSE, "filter.pressure_altitude_noise_response",
           decode_inline)
MIP_LAYOUT(mip_filter_hard_iron_offset_noise_response, MIP_FILTER_HARD_IRON_OFFSET_NOISE_RESPONSE,
           MIP_FILTER_HARD_IRON_OFFSET_NOISE_RESPONSE, "filter.hard_iron_offset_noise_response",
           decode_inline)
MIP_LAYOUT(mip_filter_soft_iron_matrix_noise_response, MIP_FILTER_SOFT_IRON_MATRIX_NOISE_RESPONSE,
           MIP_FILTER_SOFT_IRON_MATRIX_NOISE_RESPONSE, "filter.soft_iron_matrix_noise_response",
           decode_inline)
MIP_LAYOUT(mip_filter_tare_orientation_response, MIP_FILTER_TARE_ORIENTATION_RESPONSE,
           MIP_FILTER_TARE_ORIENTATION_RESPONSE, "filter.tare_orientation_response", decode_inline)
MIP_LAYOUT(mip_filter_enable_measurements_response, MIP_FILTER_ENABLE_MEASUREMENTS_RESPONSE,
           MIP_FILTER_ENABLE_MEASUREMENTS_RESPONSE, "filter.enable_measurements_response",
           decode_inline)
MIP_LAYOUT(mip_filter_mag_noise_response, MIP_FILTER_MAG_NOISE_RESPONSE,
           MIP_FILTER_MAG_NOISE_RESPONSE, "filter.mag_noise_response", decode_inline)
MIP_LAYOUT(mip_filter_magnetic_declination_source_response,
           MIP_FILTER_MAGNETIC_DECLINATION_SOURCE_RESPONSE,
           MIP_FILTER_MAGNETIC_DECLINATION_SOURCE_RESPONSE,
           "filter.magnetic_declination_source_response", decode_inline)
MIP_LAYOUT(mip_filter_accel_magnitude_adaptive_response,
           MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_RESPONSE,
           MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_RESPONSE,
           "filter.accel_magnitude_error_adaptive_measurement_response", decode_inline)
MIP_LAYOUT(mip_filter_mag_magnitude_adaptive_response, MIP_FILTER_MAG_MAGNITUDE_ADAPTIVE_RESPONSE,
           MIP_FILTER_MAG_MAGNITUDE_ADAPTIVE_RESPONSE,
           "filter.mag_magnitude_error_adaptive_measurement_response", decode_inline)
MIP_LAYOUT(mip_filter_mag_dip_angle_adaptive_response, MIP_FILTER_MAG_DIP_ANGLE_ADAPTIVE_RESPONSE,
           MIP_FILTER_MAG_DIP_ANGLE_ADAPTIVE_RESPONSE,
           "filter.mag_dip_angle_error_adaptive_measurement_response", decode_inline)
MIP_LAYOUT(mip_filter_altitude_aiding_response, MIP_FILTER_ALTITUDE_AIDING_RESPONSE,
           MIP_FILTER_ALTITUDE_AIDING_RESPONSE, "filter.altitude_aiding_response", decode_inline)
MIP_LAYOUT(mip_filter_pitch_roll_aiding_response, MIP_FILTER_PITCH_ROLL_AIDING_RESPONSE,
           MIP_FILTER_PITCH_ROLL_AIDING_RESPONSE, "filter.pitch_roll_aiding_response",
           decode_inline)
MIP_LAYOUT(mip_filter_magnetic_inclination_source_response,
           MIP_FILTER_MAGNETIC_INCLINATION_SOURCE_RESPONSE,
           MIP_FILTER_MAGNETIC_INCLINATION_SOURCE_RESPONSE,
           "filter.magnetic_inclination_source_response", decode_inline)
MIP_LAYOUT(mip_filter_magnetic_magnitude_source_response,
           MIP_FILTER_MAGNETIC_MAGNITUDE_SOURCE_RESPONSE,
           MIP_FILTER_MAGNETIC_MAGNITUDE_SOURCE_RESPONSE,
           "filter.magnetic_magnitude_source_response", decode_inline)
MIP_LAYOUT(mip_filter_sensor_to_vehicle_rotation_dcm_response,
           MIP_FILTER_SENSOR_TO_VEHICLE_ROTATION_DCM_RESPONSE,
           MIP_FILTER_SENSOR_TO_VEHICLE_ROTATION_DCM_RESPONSE,
           "filter.sensor_to_vehicle_rotation_dcm_response", decode_inline)
MIP_LAYOUT(mip_filter_sensor_to_vehicle_quaternion_response,
           MIP_FILTER_SENSOR_TO_VEHICLE_QUATERNION_RESPONSE,
           MIP_FILTER_SENSOR_TO_VEHICLE_QUATERNION_RESPONSE,
           "filter.sensor_to_vehicle_rotation_quaternion_response", decode_inline)
MIP_LAYOUT(mip_filter_aiding_measurement_enable_response,
           MIP_FILTER_AIDING_MEASUREMENT_ENABLE_RESPONSE,
           MIP_FILTER_AIDING_MEASUREMENT_ENABLE_RESPONSE,
           "filter.aiding_measurement_enable_response", decode_inline)
MIP_LAYOUT(mip_filter_kinematic_constraint_response, MIP_FILTER_KINEMATIC_CONSTRAINT_RESPONSE,
           MIP_FILTER_KINEMATIC_CONSTRAINT_RESPONSE, "filter.kinematic_constraint_response",
           decode_inline)
MIP_LAYOUT(mip_filter_initialization_config_response, MIP_FILTER_INITIALIZATION_CONFIG_RESPONSE,
           MIP_FILTER_INITIALIZATION_CONFIG_RESPONSE, "filter.initialization_config_response",
           decode_inline)
MIP_LAYOUT(mip_filter_adaptive_filter_options_response, MIP_FILTER_ADAPTIVE_FILTER_OPTIONS_RESPONSE,
           MIP_FILTER_ADAPTIVE_FILTER_OPTIONS_RESPONSE, "filter.adaptive_filter_options_response",
           decode_inline)
MIP_LAYOUT(mip_filter_multi_antenna_offset_response, MIP_FILTER_MULTI_ANTENNA_OFFSET_RESPONSE,
           MIP_FILTER_MULTI_ANTENNA_OFFSET_RESPONSE, "filter.multi_antenna_offset_response",
           decode_inline)
MIP_LAYOUT(mip_filter_relative_position_config_response,
           MIP_FILTER_RELATIVE_POSITION_CONFIG_RESPONSE,
           MIP_FILTER_RELATIVE_POSITION_CONFIG_RESPONSE, "filter.relative_position_config_response",
           decode_inline)
MIP_LAYOUT(mip_filter_reference_point_lever_arm_response,
           MIP_FILTER_REFERENCE_POINT_LEVER_ARM_RESPONSE,
           MIP_FILTER_REFERENCE_POINT_LEVER_ARM_RESPONSE,
           "filter.reference_point_lever_arm_response", decode_inline)
MIP_LAYOUT(mip_filter_speed_lever_arm_response, MIP_FILTER_SPEED_LEVER_ARM_RESPONSE,
           MIP_FILTER_SPEED_LEVER_ARM_RESPONSE, "filter.speed_lever_arm_response", decode_inline)
MIP_LAYOUT(mip_filter_vertical_gyro_constraint_control_response,
           MIP_FILTER_VERTICAL_GYRO_CONSTRAINT_CONTROL_RESPONSE,
           MIP_FILTER_VERTICAL_GYRO_CONSTRAINT_CONTROL_RESPONSE,
           "filter.vertical_gyro_constraint_control_response", decode_inline)
MIP_LAYOUT(mip_filter_wheeled_vehicle_constraint_control_response,
           MIP_FILTER_WHEELED_VEHICLE_CONSTRAINT_CONTROL_RESPONSE,
           MIP_FILTER_WHEELED_VEHICLE_CONSTRAINT_CONTROL_RESPONSE,
           "filter.wheeled_vehicle_constraint_control_response", decode_inline)
MIP_LAYOUT(mip_filter_gnss_antenna_calibration_control_response,
           MIP_FILTER_GNSS_ANTENNA_CALIBRATION_CONTROL_RESPONSE,
           MIP_FILTER_GNSS_ANTENNA_CALIBRATION_CONTROL_RESPONSE,
           "filter.gnss_antenna_calibration_control_response", decode_inline)

/** Filter commands */
inline constexpr std::uint8_t filter_set = MIP_FILTER_SET;

namespace filter {

/** @addtogroup mip_filter
 * @{ */

using ::mip::operator|;
using ::mip::operator&;
using ::mip::operator^;
using ::mip::operator~;
using ::mip::operator|=;
using ::mip::operator&=;
using ::mip::operator^=;
#ifdef MIP_NAMES_H
using ::mip::operator<<;
#endif
using ::mip::get;
using ::mip::has;
using ::mip::to_string;

/** mip_filter_dynamics_mode: filter.dynamics_mode */
enum class dynamics_mode : uint8_t {
    portable = MIP_FILTER_DYNAMICS_MODE_PORTABLE,
    automotive = MIP_FILTER_DYNAMICS_MODE_AUTOMOTIVE,
    airborne = MIP_FILTER_DYNAMICS_MODE_AIRBORNE,
    airborne_high_g = MIP_FILTER_DYNAMICS_MODE_AIRBORNE_HIGH_G,
};
MIP_NAMES_OF(value_names, dynamics_mode, mip_names_filter_dynamics_mode)

/** mip_filter_estimated_states: filter.estimated_states */
enum class estimated_states : uint16_t {
    gyro_bias = MIP_FILTER_ESTIMATED_STATES_GYRO_BIAS,
    accel_bias = MIP_FILTER_ESTIMATED_STATES_ACCEL_BIAS,
    gyro_scale_factor = MIP_FILTER_ESTIMATED_STATES_GYRO_SCALE_FACTOR,
    accel_scale_factor = MIP_FILTER_ESTIMATED_STATES_ACCEL_SCALE_FACTOR,
    antenna_offset = MIP_FILTER_ESTIMATED_STATES_ANTENNA_OFFSET,
    auto_hard_iron = MIP_FILTER_ESTIMATED_STATES_AUTO_HARD_IRON,
    auto_soft_iron = MIP_FILTER_ESTIMATED_STATES_AUTO_SOFT_IRON,
};
MIP_NAMES_OF(flag_names, estimated_states, mip_names_filter_estimated_states)

/** mip_filter_gnss_aiding_source: filter.gnss_aiding_source */
enum class gnss_aiding_source : uint8_t {
    all_internal = MIP_FILTER_GNSS_AIDING_SOURCE_ALL_INTERNAL,
    external = MIP_FILTER_GNSS_AIDING_SOURCE_EXTERNAL,
    internal_1 = MIP_FILTER_GNSS_AIDING_SOURCE_INTERNAL_1,
    internal_2 = MIP_FILTER_GNSS_AIDING_SOURCE_INTERNAL_2,
};
MIP_NAMES_OF(value_names, gnss_aiding_source, mip_names_filter_gnss_aiding_source)

/** mip_filter_heading_type: filter.heading_type */
enum class heading_type : uint8_t {
    true_heading = MIP_FILTER_HEADING_TYPE_TRUE_HEADING,
    magnetic_heading = MIP_FILTER_HEADING_TYPE_MAGNETIC_HEADING,
};
MIP_NAMES_OF(value_names, heading_type, mip_names_filter_heading_type)

/** mip_filter_heading_update_source: filter.heading_update_source */
enum class heading_update_source : uint8_t {
    none = MIP_FILTER_HEADING_UPDATE_SOURCE_NONE,
    mag = MIP_FILTER_HEADING_UPDATE_SOURCE_MAG,
    gnss_velocity = MIP_FILTER_HEADING_UPDATE_SOURCE_GNSS_VELOCITY,
    external = MIP_FILTER_HEADING_UPDATE_SOURCE_EXTERNAL,
    gnss_velocity_and_mag = MIP_FILTER_HEADING_UPDATE_SOURCE_GNSS_VELOCITY_AND_MAG,
    gnss_velocity_and_external = MIP_FILTER_HEADING_UPDATE_SOURCE_GNSS_VELOCITY_AND_EXTERNAL,
    mag_and_external = MIP_FILTER_HEADING_UPDATE_SOURCE_MAG_AND_EXTERNAL,
    all = MIP_FILTER_HEADING_UPDATE_SOURCE_ALL,
};
MIP_NAMES_OF(value_names, heading_update_source, mip_names_filter_heading_update_source)

/** mip_filter_tare_axes: filter.tare_axes */
enum class tare_axes : uint8_t {
    roll = MIP_FILTER_TARE_AXES_ROLL,
    pitch = MIP_FILTER_TARE_AXES_PITCH,
    yaw = MIP_FILTER_TARE_AXES_YAW,
};
MIP_NAMES_OF(flag_names, tare_axes, mip_names_filter_tare_axes)

/** mip_filter_measurement_flags: filter.measurement_flags */
enum class measurement_flags : uint16_t {
    accel = MIP_FILTER_MEASUREMENT_FLAGS_ACCEL,
    mag = MIP_FILTER_MEASUREMENT_FLAGS_MAG,
};
MIP_NAMES_OF(flag_names, measurement_flags, mip_names_filter_measurement_flags)

/** mip_filter_mag_parameter_source: filter.mag_parameter_source */
enum class mag_parameter_source : uint8_t {
    none = MIP_FILTER_MAG_PARAMETER_SOURCE_NONE,
    wmm = MIP_FILTER_MAG_PARAMETER_SOURCE_WMM,
    manual = MIP_FILTER_MAG_PARAMETER_SOURCE_MANUAL,
};
MIP_NAMES_OF(value_names, mag_parameter_source, mip_names_filter_mag_parameter_source)

/** mip_filter_adaptive_measurement_selector: filter.adaptive_measurement_selector */
enum class adaptive_measurement_selector : uint8_t {
    disabled = MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_DISABLED,
    fixed = MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_FIXED,
    auto_ = MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_AUTO,
};
MIP_NAMES_OF(value_names, adaptive_measurement_selector,
             mip_names_filter_adaptive_measurement_selector)

/** mip_filter_altitude_aiding_source: filter.altitude_aiding_source */
enum class altitude_aiding_source : uint8_t {
    none = MIP_FILTER_ALTITUDE_AIDING_SOURCE_NONE,
    pressure = MIP_FILTER_ALTITUDE_AIDING_SOURCE_PRESSURE,
};
MIP_NAMES_OF(value_names, altitude_aiding_source, mip_names_filter_altitude_aiding_source)

/** mip_filter_pitch_roll_aiding_source: filter.pitch_roll_aiding_source */
enum class pitch_roll_aiding_source : uint8_t {
    none = MIP_FILTER_PITCH_ROLL_AIDING_SOURCE_NONE,
    gravity_vector = MIP_FILTER_PITCH_ROLL_AIDING_SOURCE_GRAVITY_VECTOR,
};
MIP_NAMES_OF(value_names, pitch_roll_aiding_source, mip_names_filter_pitch_roll_aiding_source)

/** mip_filter_aiding_source: filter.aiding_source */
enum class aiding_source : uint16_t {
    gnss_position_velocity = MIP_FILTER_AIDING_SOURCE_GNSS_POSITION_VELOCITY,
    gnss_heading = MIP_FILTER_AIDING_SOURCE_GNSS_HEADING,
    altimeter = MIP_FILTER_AIDING_SOURCE_ALTIMETER,
    speed = MIP_FILTER_AIDING_SOURCE_SPEED,
    mag = MIP_FILTER_AIDING_SOURCE_MAG,
    external_heading = MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING,
    external_altimeter = MIP_FILTER_AIDING_SOURCE_EXTERNAL_ALTIMETER,
    external_mag = MIP_FILTER_AIDING_SOURCE_EXTERNAL_MAG,
    body_frame_velocity = MIP_FILTER_AIDING_SOURCE_BODY_FRAME_VELOCITY,
    all = MIP_FILTER_AIDING_SOURCE_ALL,
};
MIP_NAMES_OF(value_names, aiding_source, mip_names_filter_aiding_source)

/** mip_filter_accel_constraint: filter.accel_constraint */
enum class accel_constraint : uint8_t {
    none = MIP_FILTER_ACCEL_CONSTRAINT_NONE,
    zero_accel = MIP_FILTER_ACCEL_CONSTRAINT_ZERO_ACCEL,
};
MIP_NAMES_OF(value_names, accel_constraint, mip_names_filter_accel_constraint)

/** mip_filter_velocity_constraint: filter.velocity_constraint */
enum class velocity_constraint : uint8_t {
    none = MIP_FILTER_VELOCITY_CONSTRAINT_NONE,
    zero_velocity = MIP_FILTER_VELOCITY_CONSTRAINT_ZERO_VELOCITY,
    wheeled_vehicle = MIP_FILTER_VELOCITY_CONSTRAINT_WHEELED_VEHICLE,
};
MIP_NAMES_OF(value_names, velocity_constraint, mip_names_filter_velocity_constraint)

/** mip_filter_angular_constraint: filter.angular_constraint */
enum class angular_constraint : uint8_t {
    none = MIP_FILTER_ANGULAR_CONSTRAINT_NONE,
    zero_angular_rate = MIP_FILTER_ANGULAR_CONSTRAINT_ZERO_ANGULAR_RATE,
};
MIP_NAMES_OF(value_names, angular_constraint, mip_names_filter_angular_constraint)

/** mip_filter_initial_condition_source: filter.initial_condition_source */
enum class initial_condition_source : uint8_t {
    auto_position_velocity_attitude =
        MIP_FILTER_INITIAL_CONDITION_SOURCE_AUTO_POSITION_VELOCITY_ATTITUDE,
    auto_position_velocity_pitch_roll =
        MIP_FILTER_INITIAL_CONDITION_SOURCE_AUTO_POSITION_VELOCITY_PITCH_ROLL,
    auto_position_velocity = MIP_FILTER_INITIAL_CONDITION_SOURCE_AUTO_POSITION_VELOCITY,
    manual = MIP_FILTER_INITIAL_CONDITION_SOURCE_MANUAL,
};
MIP_NAMES_OF(value_names, initial_condition_source, mip_names_filter_initial_condition_source)

/** mip_filter_heading_alignment: filter.heading_alignment */
enum class heading_alignment : uint8_t {
    dual_antenna = MIP_FILTER_HEADING_ALIGNMENT_DUAL_ANTENNA,
    kinematic = MIP_FILTER_HEADING_ALIGNMENT_KINEMATIC,
    mag = MIP_FILTER_HEADING_ALIGNMENT_MAG,
    external = MIP_FILTER_HEADING_ALIGNMENT_EXTERNAL,
};
MIP_NAMES_OF(flag_names, heading_alignment, mip_names_filter_heading_alignment)

/** mip_filter_reference_frame: filter.reference_frame */
enum class reference_frame : uint8_t {
    ecef = MIP_FILTER_REFERENCE_FRAME_ECEF,
    llh = MIP_FILTER_REFERENCE_FRAME_LLH,
};
MIP_NAMES_OF(value_names, reference_frame, mip_names_filter_reference_frame)

/** mip_filter_adaptive_level: filter.adaptive_level */
enum class adaptive_level : uint8_t {
    off = MIP_FILTER_ADAPTIVE_LEVEL_OFF,
    conservative = MIP_FILTER_ADAPTIVE_LEVEL_CONSERVATIVE,
    moderate = MIP_FILTER_ADAPTIVE_LEVEL_MODERATE,
    aggressive = MIP_FILTER_ADAPTIVE_LEVEL_AGGRESSIVE,
};
MIP_NAMES_OF(value_names, adaptive_level, mip_names_filter_adaptive_level)

/** mip_filter_relative_position_source: filter.relative_position_source */
enum class relative_position_source : uint8_t {
    auto_ = MIP_FILTER_RELATIVE_POSITION_SOURCE_AUTO,
    manual = MIP_FILTER_RELATIVE_POSITION_SOURCE_MANUAL,
};
MIP_NAMES_OF(value_names, relative_position_source, mip_names_filter_relative_position_source)

/** mip_filter_reference_point: filter.reference_point */
enum class reference_point : uint8_t {
    vehicle = MIP_FILTER_REFERENCE_POINT_VEHICLE,
};
MIP_NAMES_OF(value_names, reference_point, mip_names_filter_reference_point)

struct vehicle_dynamics_mode_response_ : ::mip_filter_vehicle_dynamics_mode_response {
    using c_type = ::mip_filter_vehicle_dynamics_mode_response;
    ::mip::filter::dynamics_mode mode() const {
        return static_cast<::mip::filter::dynamics_mode>(c_type::mode);
    }
};

/** Vehicle dynamics mode response. See struct mip_filter_vehicle_dynamics_mode_response. */
using vehicle_dynamics_mode_response = vehicle_dynamics_mode_response_;

/**
 * Sensor to vehicle frame transformation response. See struct
 * mip_filter_sensor_to_vehicle_rotation_euler_response.
 */
using sensor_to_vehicle_rotation_euler_response =
    ::mip_filter_sensor_to_vehicle_rotation_euler_response;

/** Sensor to vehicle offset response. See struct mip_filter_sensor_to_vehicle_offset_response. */
using sensor_to_vehicle_offset_response = ::mip_filter_sensor_to_vehicle_offset_response;

/** GNSS antenna offset response. See struct mip_filter_antenna_offset_response. */
using antenna_offset_response = ::mip_filter_antenna_offset_response;

struct estimation_control_response_ : ::mip_filter_estimation_control_response {
    using c_type = ::mip_filter_estimation_control_response;
    ::mip::filter::estimated_states flags() const {
        return static_cast<::mip::filter::estimated_states>(c_type::flags);
    }
};

/** Estimation control flags response. See struct mip_filter_estimation_control_response. */
using estimation_control_response = estimation_control_response_;

struct gnss_source_response_ : ::mip_filter_gnss_source_response {
    using c_type = ::mip_filter_gnss_source_response;
    ::mip::filter::gnss_aiding_source source() const {
        return static_cast<::mip::filter::gnss_aiding_source>(c_type::source);
    }
};

/** GNSS aiding source response. See struct mip_filter_gnss_source_response. */
using gnss_source_response = gnss_source_response_;

struct heading_source_response_ : ::mip_filter_heading_source_response {
    using c_type = ::mip_filter_heading_source_response;
    ::mip::filter::heading_update_source source() const {
        return static_cast<::mip::filter::heading_update_source>(c_type::source);
    }
};

/** Heading update control response. See struct mip_filter_heading_source_response. */
using heading_source_response = heading_source_response_;

/**
 * Automatic initialization response. See struct mip_filter_auto_initialization_control_response.
 */
using auto_initialization_control_response = ::mip_filter_auto_initialization_control_response;

/** Accelerometer noise response. See struct mip_filter_accel_noise_response. */
using accel_noise_response = ::mip_filter_accel_noise_response;

/** Gyroscope noise response. See struct mip_filter_gyro_noise_response. */
using gyro_noise_response = ::mip_filter_gyro_noise_response;

/** Accelerometer bias model response. See struct mip_filter_accel_bias_model_response. */
using accel_bias_model_response = ::mip_filter_accel_bias_model_response;

/** Gyroscope bias model response. See struct mip_filter_gyro_bias_model_response. */
using gyro_bias_model_response = ::mip_filter_gyro_bias_model_response;

/** Automatic zero velocity update response. See struct mip_filter_auto_zupt_response. */
using auto_zupt_response = ::mip_filter_auto_zupt_response;

/** Zero angular rate update response. See struct mip_filter_auto_angular_zupt_response. */
using auto_angular_zupt_response = ::mip_filter_auto_angular_zupt_response;

struct tare_orientation_response_ : ::mip_filter_tare_orientation_response {
    using c_type = ::mip_filter_tare_orientation_response;
    ::mip::filter::tare_axes axes() const {
        return static_cast<::mip::filter::tare_axes>(c_type::axes);
    }
};

/** Tare orientation response. See struct mip_filter_tare_orientation_response. */
using tare_orientation_response = tare_orientation_response_;

/** Set reference position response. See struct mip_filter_reference_position_response. */
using reference_position_response = ::mip_filter_reference_position_response;

/** Gravity noise response. See struct mip_filter_gravity_noise_response. */
using gravity_noise_response = ::mip_filter_gravity_noise_response;

/** Pressure altitude noise response. See struct mip_filter_pressure_altitude_noise_response. */
using pressure_altitude_noise_response = ::mip_filter_pressure_altitude_noise_response;

/** Hard iron offset noise response. See struct mip_filter_hard_iron_offset_noise_response. */
using hard_iron_offset_noise_response = ::mip_filter_hard_iron_offset_noise_response;

/** Soft iron matrix noise response. See struct mip_filter_soft_iron_matrix_noise_response. */
using soft_iron_matrix_noise_response = ::mip_filter_soft_iron_matrix_noise_response;

struct enable_measurements_response_ : ::mip_filter_enable_measurements_response {
    using c_type = ::mip_filter_enable_measurements_response;
    ::mip::filter::measurement_flags control() const {
        return static_cast<::mip::filter::measurement_flags>(c_type::control);
    }
};

/** Enable or disable measurements response. See struct mip_filter_enable_measurements_response. */
using enable_measurements_response = enable_measurements_response_;

/** Magnetometer noise response. See struct mip_filter_mag_noise_response. */
using mag_noise_response = ::mip_filter_mag_noise_response;

struct magnetic_declination_source_response_ : ::mip_filter_magnetic_declination_source_response {
    using c_type = ::mip_filter_magnetic_declination_source_response;
    ::mip::filter::mag_parameter_source source() const {
        return static_cast<::mip::filter::mag_parameter_source>(c_type::source);
    }
};

/**
 * Magnetic declination source response. See struct mip_filter_magnetic_declination_source_response.
 */
using magnetic_declination_source_response = magnetic_declination_source_response_;

struct accel_magnitude_error_adaptive_measurement_response_
    : ::mip_filter_accel_magnitude_adaptive_response {
    using c_type = ::mip_filter_accel_magnitude_adaptive_response;
    ::mip::filter::adaptive_measurement_selector adaptive_measurement() const {
        return static_cast<::mip::filter::adaptive_measurement_selector>(
            c_type::adaptive_measurement);
    }
};

/**
 * Gravity magnitude error adaptive measurement response. See struct
 * mip_filter_accel_magnitude_adaptive_response.
 */
using accel_magnitude_error_adaptive_measurement_response =
    accel_magnitude_error_adaptive_measurement_response_;

struct mag_magnitude_error_adaptive_measurement_response_
    : ::mip_filter_mag_magnitude_adaptive_response {
    using c_type = ::mip_filter_mag_magnitude_adaptive_response;
    ::mip::filter::adaptive_measurement_selector adaptive_measurement() const {
        return static_cast<::mip::filter::adaptive_measurement_selector>(
            c_type::adaptive_measurement);
    }
};

/**
 * Magnetometer magnitude error adaptive measurement response. See struct
 * mip_filter_mag_magnitude_adaptive_response.
 */
using mag_magnitude_error_adaptive_measurement_response =
    mag_magnitude_error_adaptive_measurement_response_;

/**
 * Magnetometer dip angle error adaptive measurement response. See struct
 * mip_filter_mag_dip_angle_adaptive_response.
 */
using mag_dip_angle_error_adaptive_measurement_response =
    ::mip_filter_mag_dip_angle_adaptive_response;

struct altitude_aiding_response_ : ::mip_filter_altitude_aiding_response {
    using c_type = ::mip_filter_altitude_aiding_response;
    ::mip::filter::altitude_aiding_source selector() const {
        return static_cast<::mip::filter::altitude_aiding_source>(c_type::selector);
    }
};

/** Altitude aiding response. See struct mip_filter_altitude_aiding_response. */
using altitude_aiding_response = altitude_aiding_response_;

struct pitch_roll_aiding_response_ : ::mip_filter_pitch_roll_aiding_response {
    using c_type = ::mip_filter_pitch_roll_aiding_response;
    ::mip::filter::pitch_roll_aiding_source aiding() const {
        return static_cast<::mip::filter::pitch_roll_aiding_source>(c_type::aiding);
    }
};

/** Pitch and roll aiding response. See struct mip_filter_pitch_roll_aiding_response. */
using pitch_roll_aiding_response = pitch_roll_aiding_response_;

struct magnetic_inclination_source_response_ : ::mip_filter_magnetic_inclination_source_response {
    using c_type = ::mip_filter_magnetic_inclination_source_response;
    ::mip::filter::mag_parameter_source source() const {
        return static_cast<::mip::filter::mag_parameter_source>(c_type::source);
    }
};

/**
 * Magnetic inclination source response. See struct mip_filter_magnetic_inclination_source_response.
 */
using magnetic_inclination_source_response = magnetic_inclination_source_response_;

struct magnetic_magnitude_source_response_ : ::mip_filter_magnetic_magnitude_source_response {
    using c_type = ::mip_filter_magnetic_magnitude_source_response;
    ::mip::filter::mag_parameter_source source() const {
        return static_cast<::mip::filter::mag_parameter_source>(c_type::source);
    }
};

/**
 * Magnetic field magnitude source response. See struct
 * mip_filter_magnetic_magnitude_source_response.
 */
using magnetic_magnitude_source_response = magnetic_magnitude_source_response_;

/**
 * Sensor to vehicle rotation, matrix response. See struct
 * mip_filter_sensor_to_vehicle_rotation_dcm_response.
 */
using sensor_to_vehicle_rotation_dcm_response =
    ::mip_filter_sensor_to_vehicle_rotation_dcm_response;

/**
 * Sensor to vehicle rotation, quaternion response. See struct
 * mip_filter_sensor_to_vehicle_quaternion_response.
 */
using sensor_to_vehicle_rotation_quaternion_response =
    ::mip_filter_sensor_to_vehicle_quaternion_response;

struct aiding_measurement_enable_response_ : ::mip_filter_aiding_measurement_enable_response {
    using c_type = ::mip_filter_aiding_measurement_enable_response;
    ::mip::filter::aiding_source aiding_source() const {
        return static_cast<::mip::filter::aiding_source>(c_type::aiding_source);
    }
};

/**
 * Aiding measurement control response. See struct mip_filter_aiding_measurement_enable_response.
 */
using aiding_measurement_enable_response = aiding_measurement_enable_response_;

struct kinematic_constraint_response_ : ::mip_filter_kinematic_constraint_response {
    using c_type = ::mip_filter_kinematic_constraint_response;
    ::mip::filter::accel_constraint accel_constraint() const {
        return static_cast<::mip::filter::accel_constraint>(c_type::accel_constraint);
    }
    ::mip::filter::velocity_constraint velocity_constraint() const {
        return static_cast<::mip::filter::velocity_constraint>(c_type::velocity_constraint);
    }
    ::mip::filter::angular_constraint angular_constraint() const {
        return static_cast<::mip::filter::angular_constraint>(c_type::angular_constraint);
    }
};

/** Kinematic constraint response. See struct mip_filter_kinematic_constraint_response. */
using kinematic_constraint_response = kinematic_constraint_response_;

struct initialization_config_response_ : ::mip_filter_initialization_config_response {
    using c_type = ::mip_filter_initialization_config_response;
    ::mip::filter::initial_condition_source initial_condition_source() const {
        return static_cast<::mip::filter::initial_condition_source>(
            c_type::initial_condition_source);
    }
    ::mip::filter::heading_alignment auto_heading_alignment_selector() const {
        return static_cast<::mip::filter::heading_alignment>(
            c_type::auto_heading_alignment_selector);
    }
    ::mip::filter::reference_frame reference_frame_selector() const {
        return static_cast<::mip::filter::reference_frame>(c_type::reference_frame_selector);
    }
};

/**
 * Navigation filter initialization response. See struct mip_filter_initialization_config_response.
 */
using initialization_config_response = initialization_config_response_;

struct adaptive_filter_options_response_ : ::mip_filter_adaptive_filter_options_response {
    using c_type = ::mip_filter_adaptive_filter_options_response;
    ::mip::filter::adaptive_level level() const {
        return static_cast<::mip::filter::adaptive_level>(c_type::level);
    }
};

/** Adaptive filter control response. See struct mip_filter_adaptive_filter_options_response. */
using adaptive_filter_options_response = adaptive_filter_options_response_;

/** GNSS multi-antenna offset response. See struct mip_filter_multi_antenna_offset_response. */
using multi_antenna_offset_response = ::mip_filter_multi_antenna_offset_response;

struct relative_position_config_response_ : ::mip_filter_relative_position_config_response {
    using c_type = ::mip_filter_relative_position_config_response;
    ::mip::filter::relative_position_source source() const {
        return static_cast<::mip::filter::relative_position_source>(c_type::source);
    }
    ::mip::filter::reference_frame reference_frame_selector() const {
        return static_cast<::mip::filter::reference_frame>(c_type::reference_frame_selector);
    }
};

/**
 * Relative position configuration response. See struct
 * mip_filter_relative_position_config_response.
 */
using relative_position_config_response = relative_position_config_response_;

struct reference_point_lever_arm_response_ : ::mip_filter_reference_point_lever_arm_response {
    using c_type = ::mip_filter_reference_point_lever_arm_response;
    ::mip::filter::reference_point reference_point() const {
        return static_cast<::mip::filter::reference_point>(c_type::reference_point);
    }
};

/** Reference point lever arm response. See struct mip_filter_reference_point_lever_arm_response. */
using reference_point_lever_arm_response = reference_point_lever_arm_response_;

/** Speed measurement lever arm response. See struct mip_filter_speed_lever_arm_response. */
using speed_lever_arm_response = ::mip_filter_speed_lever_arm_response;

/**
 * Vertical gyro constraint response. See struct
 * mip_filter_vertical_gyro_constraint_control_response.
 */
using vertical_gyro_constraint_control_response =
    ::mip_filter_vertical_gyro_constraint_control_response;

/**
 * Wheeled vehicle constraint response. See struct
 * mip_filter_wheeled_vehicle_constraint_control_response.
 */
using wheeled_vehicle_constraint_control_response =
    ::mip_filter_wheeled_vehicle_constraint_control_response;

/**
 * GNSS antenna offset calibration response. See struct
 * mip_filter_gnss_antenna_calibration_control_response.
 */
using gnss_antenna_calibration_control_response =
    ::mip_filter_gnss_antenna_calibration_control_response;

/** @} */

} // namespace filter

} // namespace mip

#endif
