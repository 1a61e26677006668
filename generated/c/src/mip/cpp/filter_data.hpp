/**
 * @file
 * Filter data, in C++17: see mip/filter_data.h.
 */
#ifndef MIP_FILTER_DATA_HPP
#define MIP_FILTER_DATA_HPP

#include "mip/filter_data_inline.h"
#include "mip/cpp/types.hpp"

namespace mip {

MIP_LAYOUT(mip_filter_data_llh_position, MIP_FILTER_DATA_LLH_POSITION, MIP_FILTER_DATA_LLH_POSITION,
           "filter_data.llh_position", decode_inline)
MIP_LAYOUT(mip_filter_data_ned_velocity, MIP_FILTER_DATA_NED_VELOCITY, MIP_FILTER_DATA_NED_VELOCITY,
           "filter_data.ned_velocity", decode_inline)
MIP_LAYOUT(mip_filter_data_attitude_quaternion, MIP_FILTER_DATA_ATTITUDE_QUATERNION,
           MIP_FILTER_DATA_ATTITUDE_QUATERNION, "filter_data.attitude_quaternion", decode_inline)
MIP_LAYOUT(mip_filter_data_attitude_dcm, MIP_FILTER_DATA_ATTITUDE_DCM, MIP_FILTER_DATA_ATTITUDE_DCM,
           "filter_data.attitude_dcm", decode_inline)
MIP_LAYOUT(mip_filter_data_euler_angles, MIP_FILTER_DATA_EULER_ANGLES, MIP_FILTER_DATA_EULER_ANGLES,
           "filter_data.euler_angles", decode_inline)
MIP_LAYOUT(mip_filter_data_gyro_bias, MIP_FILTER_DATA_GYRO_BIAS, MIP_FILTER_DATA_GYRO_BIAS,
           "filter_data.gyro_bias", decode_inline)
MIP_LAYOUT(mip_filter_data_accel_bias, MIP_FILTER_DATA_ACCEL_BIAS, MIP_FILTER_DATA_ACCEL_BIAS,
           "filter_data.accel_bias", decode_inline)
MIP_LAYOUT(mip_filter_data_llh_position_uncertainty, MIP_FILTER_DATA_LLH_POSITION_UNCERTAINTY,
           MIP_FILTER_DATA_LLH_POSITION_UNCERTAINTY, "filter_data.llh_position_uncertainty",
           decode_inline)
MIP_LAYOUT(mip_filter_data_ned_velocity_uncertainty, MIP_FILTER_DATA_NED_VELOCITY_UNCERTAINTY,
           MIP_FILTER_DATA_NED_VELOCITY_UNCERTAINTY, "filter_data.ned_velocity_uncertainty",
           decode_inline)
MIP_LAYOUT(mip_filter_data_euler_angles_uncertainty, MIP_FILTER_DATA_EULER_ANGLES_UNCERTAINTY,
           MIP_FILTER_DATA_EULER_ANGLES_UNCERTAINTY, "filter_data.euler_angles_uncertainty",
           decode_inline)
MIP_LAYOUT(mip_filter_data_gyro_bias_uncertainty, MIP_FILTER_DATA_GYRO_BIAS_UNCERTAINTY,
           MIP_FILTER_DATA_GYRO_BIAS_UNCERTAINTY, "filter_data.gyro_bias_uncertainty",
           decode_inline)
MIP_LAYOUT(mip_filter_data_accel_bias_uncertainty, MIP_FILTER_DATA_ACCEL_BIAS_UNCERTAINTY,
           MIP_FILTER_DATA_ACCEL_BIAS_UNCERTAINTY, "filter_data.accel_bias_uncertainty",
           decode_inline)
MIP_LAYOUT(mip_filter_data_linear_accel, MIP_FILTER_DATA_LINEAR_ACCEL, MIP_FILTER_DATA_LINEAR_ACCEL,
           "filter_data.linear_accel", decode_inline)
MIP_LAYOUT(mip_filter_data_comp_angular_rate, MIP_FILTER_DATA_COMP_ANGULAR_RATE,
           MIP_FILTER_DATA_COMP_ANGULAR_RATE, "filter_data.comp_angular_rate", decode_inline)
MIP_LAYOUT(mip_filter_data_wgs84_gravity_magnitude, MIP_FILTER_DATA_WGS84_GRAVITY_MAGNITUDE,
           MIP_FILTER_DATA_WGS84_GRAVITY_MAGNITUDE, "filter_data.wgs84_gravity_magnitude",
           decode_inline)
MIP_LAYOUT(mip_filter_data_status, MIP_FILTER_DATA_STATUS, MIP_FILTER_DATA_STATUS,
           "filter_data.status", decode_inline)
MIP_LAYOUT(mip_filter_data_timestamp, MIP_FILTER_DATA_TIMESTAMP, MIP_FILTER_DATA_TIMESTAMP,
           "filter_data.timestamp", decode_inline)
MIP_LAYOUT(mip_filter_data_quaternion_attitude_uncertainty,
           MIP_FILTER_DATA_QUATERNION_ATTITUDE_UNCERTAINTY,
           MIP_FILTER_DATA_QUATERNION_ATTITUDE_UNCERTAINTY,
           "filter_data.quaternion_attitude_uncertainty", decode_inline)
MIP_LAYOUT(mip_filter_data_gravity_vector, MIP_FILTER_DATA_GRAVITY_VECTOR,
           MIP_FILTER_DATA_GRAVITY_VECTOR, "filter_data.gravity_vector", decode_inline)
MIP_LAYOUT(mip_filter_data_heading_update_state, MIP_FILTER_DATA_HEADING_UPDATE_STATE,
           MIP_FILTER_DATA_HEADING_UPDATE_STATE, "filter_data.heading_update_state", decode_inline)
MIP_LAYOUT(mip_filter_data_magnetic_model, MIP_FILTER_DATA_MAGNETIC_MODEL,
           MIP_FILTER_DATA_MAGNETIC_MODEL, "filter_data.magnetic_model", decode_inline)
MIP_LAYOUT(mip_filter_data_gyro_scale_factor, MIP_FILTER_DATA_GYRO_SCALE_FACTOR,
           MIP_FILTER_DATA_GYRO_SCALE_FACTOR, "filter_data.gyro_scale_factor", decode_inline)
MIP_LAYOUT(mip_filter_data_accel_scale_factor, MIP_FILTER_DATA_ACCEL_SCALE_FACTOR,
           MIP_FILTER_DATA_ACCEL_SCALE_FACTOR, "filter_data.accel_scale_factor", decode_inline)
MIP_LAYOUT(mip_filter_data_gyro_scale_factor_uncertainty,
           MIP_FILTER_DATA_GYRO_SCALE_FACTOR_UNCERTAINTY,
           MIP_FILTER_DATA_GYRO_SCALE_FACTOR_UNCERTAINTY,
           "filter_data.gyro_scale_factor_uncertainty", decode_inline)
MIP_LAYOUT(mip_filter_data_accel_scale_factor_uncertainty,
           MIP_FILTER_DATA_ACCEL_SCALE_FACTOR_UNCERTAINTY,
           MIP_FILTER_DATA_ACCEL_SCALE_FACTOR_UNCERTAINTY,
           "filter_data.accel_scale_factor_uncertainty", decode_inline)
MIP_LAYOUT(mip_filter_data_mag_bias, MIP_FILTER_DATA_MAG_BIAS, MIP_FILTER_DATA_MAG_BIAS,
           "filter_data.mag_bias", decode_inline)
MIP_LAYOUT(mip_filter_data_mag_bias_uncertainty, MIP_FILTER_DATA_MAG_BIAS_UNCERTAINTY,
           MIP_FILTER_DATA_MAG_BIAS_UNCERTAINTY, "filter_data.mag_bias_uncertainty", decode_inline)
MIP_LAYOUT(mip_filter_data_comp_accel, MIP_FILTER_DATA_COMP_ACCEL, MIP_FILTER_DATA_COMP_ACCEL,
           "filter_data.comp_accel", decode_inline)
MIP_LAYOUT(mip_filter_data_standard_atmosphere, MIP_FILTER_DATA_STANDARD_ATMOSPHERE,
           MIP_FILTER_DATA_STANDARD_ATMOSPHERE, "filter_data.standard_atmosphere", decode_inline)
MIP_LAYOUT(mip_filter_data_pressure_altitude, MIP_FILTER_DATA_PRESSURE_ALTITUDE,
           MIP_FILTER_DATA_PRESSURE_ALTITUDE, "filter_data.pressure_altitude", decode_inline)
MIP_LAYOUT(mip_filter_data_density_altitude, MIP_FILTER_DATA_DENSITY_ALTITUDE,
           MIP_FILTER_DATA_DENSITY_ALTITUDE, "filter_data.density_altitude", decode_inline)
MIP_LAYOUT(mip_filter_data_mag_offset, MIP_FILTER_DATA_MAG_OFFSET, MIP_FILTER_DATA_MAG_OFFSET,
           "filter_data.mag_offset", decode_inline)
MIP_LAYOUT(mip_filter_data_mag_matrix, MIP_FILTER_DATA_MAG_MATRIX, MIP_FILTER_DATA_MAG_MATRIX,
           "filter_data.mag_matrix", decode_inline)
MIP_LAYOUT(mip_filter_data_mag_offset_uncertainty, MIP_FILTER_DATA_MAG_OFFSET_UNCERTAINTY,
           MIP_FILTER_DATA_MAG_OFFSET_UNCERTAINTY, "filter_data.mag_offset_uncertainty",
           decode_inline)
MIP_LAYOUT(mip_filter_data_mag_matrix_uncertainty, MIP_FILTER_DATA_MAG_MATRIX_UNCERTAINTY,
           MIP_FILTER_DATA_MAG_MATRIX_UNCERTAINTY, "filter_data.mag_matrix_uncertainty",
           decode_inline)
MIP_LAYOUT(mip_filter_data_mag_covariance_matrix, MIP_FILTER_DATA_MAG_COVARIANCE_MATRIX,
           MIP_FILTER_DATA_MAG_COVARIANCE_MATRIX, "filter_data.mag_covariance_matrix",
           decode_inline)
MIP_LAYOUT(mip_filter_data_mag_residual_vector, MIP_FILTER_DATA_MAG_RESIDUAL_VECTOR,
           MIP_FILTER_DATA_MAG_RESIDUAL_VECTOR, "filter_data.mag_residual_vector", decode_inline)
MIP_LAYOUT(mip_filter_data_antenna_offset_correction, MIP_FILTER_DATA_ANTENNA_OFFSET_CORRECTION,
           MIP_FILTER_DATA_ANTENNA_OFFSET_CORRECTION, "filter_data.antenna_offset_correction",
           decode_inline)
MIP_LAYOUT(mip_filter_data_antenna_offset_correction_uncertainty,
           MIP_FILTER_DATA_ANTENNA_OFFSET_CORRECTION_UNCERTAINTY,
           MIP_FILTER_DATA_ANTENNA_OFFSET_CORRECTION_UNCERTAINTY,
           "filter_data.antenna_offset_correction_uncertainty", decode_inline)
MIP_LAYOUT(mip_filter_data_clock_correction, MIP_FILTER_DATA_CLOCK_CORRECTION,
           MIP_FILTER_DATA_CLOCK_CORRECTION, "filter_data.clock_correction", decode_inline)
MIP_LAYOUT(mip_filter_data_clock_correction_uncertainty,
           MIP_FILTER_DATA_CLOCK_CORRECTION_UNCERTAINTY,
           MIP_FILTER_DATA_CLOCK_CORRECTION_UNCERTAINTY, "filter_data.clock_correction_uncertainty",
           decode_inline)
MIP_LAYOUT(mip_filter_data_multi_antenna_offset_correction,
           MIP_FILTER_DATA_MULTI_ANTENNA_OFFSET_CORRECTION,
           MIP_FILTER_DATA_MULTI_ANTENNA_OFFSET_CORRECTION,
           "filter_data.multi_antenna_offset_correction", decode_inline)
MIP_LAYOUT(mip_filter_data_multi_antenna_offset_uncertainty,
           MIP_FILTER_DATA_MULTI_ANTENNA_OFFSET_UNCERTAINTY,
           MIP_FILTER_DATA_MULTI_ANTENNA_OFFSET_UNCERTAINTY,
           "filter_data.multi_antenna_offset_correction_uncertainty", decode_inline)
MIP_LAYOUT(mip_filter_data_ecef_position_uncertainty, MIP_FILTER_DATA_ECEF_POSITION_UNCERTAINTY,
           MIP_FILTER_DATA_ECEF_POSITION_UNCERTAINTY, "filter_data.ecef_position_uncertainty",
           decode_inline)
MIP_LAYOUT(mip_filter_data_ecef_velocity_uncertainty, MIP_FILTER_DATA_ECEF_VELOCITY_UNCERTAINTY,
           MIP_FILTER_DATA_ECEF_VELOCITY_UNCERTAINTY, "filter_data.ecef_velocity_uncertainty",
           decode_inline)
MIP_LAYOUT(mip_filter_data_ecef_position, MIP_FILTER_DATA_ECEF_POSITION,
           MIP_FILTER_DATA_ECEF_POSITION, "filter_data.ecef_position", decode_inline)
MIP_LAYOUT(mip_filter_data_ecef_velocity, MIP_FILTER_DATA_ECEF_VELOCITY,
           MIP_FILTER_DATA_ECEF_VELOCITY, "filter_data.ecef_velocity", decode_inline)
MIP_LAYOUT(mip_filter_data_ned_relative_position, MIP_FILTER_DATA_NED_RELATIVE_POSITION,
           MIP_FILTER_DATA_NED_RELATIVE_POSITION, "filter_data.ned_relative_position",
           decode_inline)
MIP_LAYOUT(mip_filter_data_gnss_position_aiding_status, MIP_FILTER_DATA_GNSS_POSITION_AIDING_STATUS,
           MIP_FILTER_DATA_GNSS_POSITION_AIDING_STATUS, "filter_data.gnss_position_aiding_status",
           decode_inline)
MIP_LAYOUT(mip_filter_data_gnss_attitude_aiding_status, MIP_FILTER_DATA_GNSS_ATTITUDE_AIDING_STATUS,
           MIP_FILTER_DATA_GNSS_ATTITUDE_AIDING_STATUS, "filter_data.gnss_attitude_aiding_status",
           decode_inline)
MIP_LAYOUT(mip_filter_data_heading_aiding_status, MIP_FILTER_DATA_HEADING_AIDING_STATUS,
           MIP_FILTER_DATA_HEADING_AIDING_STATUS, "filter_data.heading_aiding_status",
           decode_inline)
MIP_LAYOUT(mip_filter_data_aiding_measurement_summary, MIP_FILTER_DATA_AIDING_MEASUREMENT_SUMMARY,
           MIP_FILTER_DATA_AIDING_MEASUREMENT_SUMMARY, "filter_data.aiding_measurement_summary",
           decode_inline)
MIP_LAYOUT(mip_filter_data_odometer_scale_factor_error, MIP_FILTER_DATA_ODOMETER_SCALE_FACTOR_ERROR,
           MIP_FILTER_DATA_ODOMETER_SCALE_FACTOR_ERROR, "filter_data.odometer_scale_factor_error",
           decode_inline)
MIP_LAYOUT(mip_filter_data_odometer_scale_factor_error_uncertainty,
           MIP_FILTER_DATA_ODOMETER_SCALE_FACTOR_ERROR_UNCERTAINTY,
           MIP_FILTER_DATA_ODOMETER_SCALE_FACTOR_ERROR_UNCERTAINTY,
           "filter_data.odometer_scale_factor_error_uncertainty", decode_inline)
MIP_LAYOUT(mip_filter_data_gnss_dual_antenna_status, MIP_FILTER_DATA_GNSS_DUAL_ANTENNA_STATUS,
           MIP_FILTER_DATA_GNSS_DUAL_ANTENNA_STATUS, "filter_data.gnss_dual_antenna_status",
           decode_inline)
MIP_LAYOUT(mip_filter_data_aiding_frame_config_error, MIP_FILTER_DATA_AIDING_FRAME_CONFIG_ERROR,
           MIP_FILTER_DATA_AIDING_FRAME_CONFIG_ERROR, "filter_data.aiding_frame_config_error",
           decode_inline)
MIP_LAYOUT(mip_filter_data_aiding_frame_config_error_uncertainty,
           MIP_FILTER_DATA_AIDING_FRAME_CONFIG_ERROR_UNCERTAINTY,
           MIP_FILTER_DATA_AIDING_FRAME_CONFIG_ERROR_UNCERTAINTY,
           "filter_data.aiding_frame_config_error_uncertainty", decode_inline)

/** Filter data */
inline constexpr std::uint8_t filter_data_set = MIP_FILTER_DATA_SET;

namespace filter_data {

/** @addtogroup mip_filter_data
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

/** mip_filter_data_valid_flags: filter_data.valid_flags */
enum class valid_flags : uint16_t {
    valid = MIP_FILTER_DATA_VALID_FLAGS_VALID,
};
MIP_NAMES_OF(flag_names, valid_flags, mip_names_filter_data_valid_flags)

/** mip_filter_data_heading_source_flags: filter_data.heading_source_flags */
enum class heading_source_flags : uint16_t {
    mag = MIP_FILTER_DATA_HEADING_SOURCE_FLAGS_MAG,
    gnss_velocity = MIP_FILTER_DATA_HEADING_SOURCE_FLAGS_GNSS_VELOCITY,
    external = MIP_FILTER_DATA_HEADING_SOURCE_FLAGS_EXTERNAL,
};
MIP_NAMES_OF(flag_names, heading_source_flags, mip_names_filter_data_heading_source_flags)

/** mip_filter_data_gnss_aiding_status: filter_data.gnss_aiding_status */
enum class gnss_aiding_status : uint16_t {
    tight_coupling = MIP_FILTER_DATA_GNSS_AIDING_STATUS_TIGHT_COUPLING,
    differential = MIP_FILTER_DATA_GNSS_AIDING_STATUS_DIFFERENTIAL,
    integer_fix = MIP_FILTER_DATA_GNSS_AIDING_STATUS_INTEGER_FIX,
    gps_l1 = MIP_FILTER_DATA_GNSS_AIDING_STATUS_GPS_L1,
    gps_l2 = MIP_FILTER_DATA_GNSS_AIDING_STATUS_GPS_L2,
    gps_l5 = MIP_FILTER_DATA_GNSS_AIDING_STATUS_GPS_L5,
    glonass_l1 = MIP_FILTER_DATA_GNSS_AIDING_STATUS_GLONASS_L1,
    glonass_l2 = MIP_FILTER_DATA_GNSS_AIDING_STATUS_GLONASS_L2,
    galileo_e1 = MIP_FILTER_DATA_GNSS_AIDING_STATUS_GALILEO_E1,
    galileo_e5 = MIP_FILTER_DATA_GNSS_AIDING_STATUS_GALILEO_E5,
    galileo_e6 = MIP_FILTER_DATA_GNSS_AIDING_STATUS_GALILEO_E6,
    beidou_b1 = MIP_FILTER_DATA_GNSS_AIDING_STATUS_BEIDOU_B1,
    beidou_b2 = MIP_FILTER_DATA_GNSS_AIDING_STATUS_BEIDOU_B2,
    beidou_b3 = MIP_FILTER_DATA_GNSS_AIDING_STATUS_BEIDOU_B3,
    no_fix = MIP_FILTER_DATA_GNSS_AIDING_STATUS_NO_FIX,
    config_error = MIP_FILTER_DATA_GNSS_AIDING_STATUS_CONFIG_ERROR,
};
MIP_NAMES_OF(flag_names, gnss_aiding_status, mip_names_filter_data_gnss_aiding_status)

/** mip_filter_data_heading_aiding_type: filter_data.heading_aiding_type */
enum class heading_aiding_type : uint8_t {
    dual_antenna = MIP_FILTER_DATA_HEADING_AIDING_TYPE_DUAL_ANTENNA,
    external_message = MIP_FILTER_DATA_HEADING_AIDING_TYPE_EXTERNAL_MESSAGE,
};
MIP_NAMES_OF(value_names, heading_aiding_type, mip_names_filter_data_heading_aiding_type)

/** mip_filter_data_aiding_measurement_type: filter_data.aiding_measurement_type */
enum class aiding_measurement_type : uint8_t {
    gnss = MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_GNSS,
    dual_antenna = MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_DUAL_ANTENNA,
    heading = MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_HEADING,
    pressure = MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_PRESSURE,
    mag = MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_MAG,
    speed = MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_SPEED,
    aiding_ecef_position = MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_AIDING_ECEF_POSITION,
    aiding_llh_position = MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_AIDING_LLH_POSITION,
    aiding_height_above_ellipsoid =
        MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_AIDING_HEIGHT_ABOVE_ELLIPSOID,
    aiding_ecef_velocity = MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_AIDING_ECEF_VELOCITY,
    aiding_ned_velocity = MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_AIDING_NED_VELOCITY,
    aiding_body_frame_velocity = MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_AIDING_BODY_FRAME_VELOCITY,
    aiding_true_heading = MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_AIDING_TRUE_HEADING,
    aiding_magnetic_field = MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_AIDING_MAGNETIC_FIELD,
    aiding_pressure = MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_AIDING_PRESSURE,
};
MIP_NAMES_OF(value_names, aiding_measurement_type, mip_names_filter_data_aiding_measurement_type)

/** mip_filter_data_aiding_measurement_indicator: filter_data.aiding_measurement_indicator */
enum class aiding_measurement_indicator : uint8_t {
    enabled = MIP_FILTER_DATA_AIDING_MEASUREMENT_INDICATOR_ENABLED,
    used = MIP_FILTER_DATA_AIDING_MEASUREMENT_INDICATOR_USED,
    residual_high_warning = MIP_FILTER_DATA_AIDING_MEASUREMENT_INDICATOR_RESIDUAL_HIGH_WARNING,
    sample_time_warning = MIP_FILTER_DATA_AIDING_MEASUREMENT_INDICATOR_SAMPLE_TIME_WARNING,
    config_error = MIP_FILTER_DATA_AIDING_MEASUREMENT_INDICATOR_CONFIG_ERROR,
    max_measurements_exceeded =
        MIP_FILTER_DATA_AIDING_MEASUREMENT_INDICATOR_MAX_MEASUREMENTS_EXCEEDED,
};
MIP_NAMES_OF(flag_names, aiding_measurement_indicator,
             mip_names_filter_data_aiding_measurement_indicator)

/** mip_filter_data_dual_antenna_fix_type: filter_data.dual_antenna_fix_type */
enum class dual_antenna_fix_type : uint8_t {
    fix_none = MIP_FILTER_DATA_DUAL_ANTENNA_FIX_TYPE_FIX_NONE,
    fix_da_float = MIP_FILTER_DATA_DUAL_ANTENNA_FIX_TYPE_FIX_DA_FLOAT,
    fix_da_fixed = MIP_FILTER_DATA_DUAL_ANTENNA_FIX_TYPE_FIX_DA_FIXED,
};
MIP_NAMES_OF(value_names, dual_antenna_fix_type, mip_names_filter_data_dual_antenna_fix_type)

/** mip_filter_data_dual_antenna_status_flags: filter_data.dual_antenna_status_flags */
enum class dual_antenna_status_flags : uint16_t {
    receiver_1_data_valid = MIP_FILTER_DATA_DUAL_ANTENNA_STATUS_FLAGS_RECEIVER_1_DATA_VALID,
    receiver_2_data_valid = MIP_FILTER_DATA_DUAL_ANTENNA_STATUS_FLAGS_RECEIVER_2_DATA_VALID,
    antenna_offsets_valid = MIP_FILTER_DATA_DUAL_ANTENNA_STATUS_FLAGS_ANTENNA_OFFSETS_VALID,
};
MIP_NAMES_OF(flag_names, dual_antenna_status_flags, mip_names_filter_data_dual_antenna_status_flags)

/** mip_filter_data_gx5_filter_state: filter_data.gx5_filter_state */
enum class gx5_filter_state : uint16_t {
    startup = MIP_FILTER_DATA_GX5_FILTER_STATE_STARTUP,
    init = MIP_FILTER_DATA_GX5_FILTER_STATE_INIT,
    run_solution_valid = MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_VALID,
    run_solution_error = MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_ERROR,
};
MIP_NAMES_OF(value_names, gx5_filter_state, mip_names_filter_data_gx5_filter_state)

/** mip_filter_data_cv7_filter_state: filter_data.cv7_filter_state */
enum class cv7_filter_state : uint16_t {
    init = MIP_FILTER_DATA_CV7_FILTER_STATE_INIT,
    vertical_gyro = MIP_FILTER_DATA_CV7_FILTER_STATE_VERTICAL_GYRO,
    ahrs = MIP_FILTER_DATA_CV7_FILTER_STATE_AHRS,
    full_nav = MIP_FILTER_DATA_CV7_FILTER_STATE_FULL_NAV,
};
MIP_NAMES_OF(value_names, cv7_filter_state, mip_names_filter_data_cv7_filter_state)

/** mip_filter_data_gx5_dynamics_mode: filter_data.gx5_dynamics_mode */
enum class gx5_dynamics_mode : uint16_t {
    portable = MIP_FILTER_DATA_GX5_DYNAMICS_MODE_PORTABLE,
    automotive = MIP_FILTER_DATA_GX5_DYNAMICS_MODE_AUTOMOTIVE,
    airborne = MIP_FILTER_DATA_GX5_DYNAMICS_MODE_AIRBORNE,
    airborne_high_g = MIP_FILTER_DATA_GX5_DYNAMICS_MODE_AIRBORNE_HIGH_G,
};
MIP_NAMES_OF(value_names, gx5_dynamics_mode, mip_names_filter_data_gx5_dynamics_mode)

/** mip_filter_data_cv7_dynamics_mode: filter_data.cv7_dynamics_mode */
enum class cv7_dynamics_mode : uint16_t {
    default_ = MIP_FILTER_DATA_CV7_DYNAMICS_MODE_DEFAULT,
};
MIP_NAMES_OF(value_names, cv7_dynamics_mode, mip_names_filter_data_cv7_dynamics_mode)

/** mip_filter_data_gx5_status_flags: filter_data.gx5_status_flags */
enum class gx5_status_flags : uint16_t {
    run_imu_unavailable = MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_IMU_UNAVAILABLE,
    run_gps_unavailable = MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_GPS_UNAVAILABLE,
    run_matrix_singularity = MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_MATRIX_SINGULARITY,
    run_position_covariance_warning =
        MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_POSITION_COVARIANCE_WARNING,
    run_velocity_covariance_warning =
        MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_VELOCITY_COVARIANCE_WARNING,
    run_attitude_covariance_warning =
        MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_ATTITUDE_COVARIANCE_WARNING,
    run_nan_in_solution_warning = MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_NAN_IN_SOLUTION_WARNING,
    run_gyro_bias_est_high_warning =
        MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_GYRO_BIAS_EST_HIGH_WARNING,
    run_accel_bias_est_high_warning =
        MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_ACCEL_BIAS_EST_HIGH_WARNING,
    run_gyro_scale_factor_est_high_warning =
        MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_GYRO_SCALE_FACTOR_EST_HIGH_WARNING,
    run_accel_scale_factor_est_high_warning =
        MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_ACCEL_SCALE_FACTOR_EST_HIGH_WARNING,
    run_mag_bias_est_high_warning = MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_MAG_BIAS_EST_HIGH_WARNING,
    run_antenna_offset_correction_est_high_warning =
        MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_ANTENNA_OFFSET_CORRECTION_EST_HIGH_WARNING,
    run_mag_hard_iron_est_high_warning =
        MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_MAG_HARD_IRON_EST_HIGH_WARNING,
    run_mag_soft_iron_est_high_warning =
        MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_MAG_SOFT_IRON_EST_HIGH_WARNING,
    init_no_attitude = MIP_FILTER_DATA_GX5_STATUS_FLAGS_INIT_NO_ATTITUDE,
    init_no_position_velocity = MIP_FILTER_DATA_GX5_STATUS_FLAGS_INIT_NO_POSITION_VELOCITY,
};
MIP_NAMES_OF(flag_names, gx5_status_flags, mip_names_filter_data_gx5_status_flags)

/** mip_filter_data_filter_condition: filter_data.filter_condition */
enum class filter_condition : uint8_t {
    stable = MIP_FILTER_DATA_FILTER_CONDITION_STABLE,
    converging = MIP_FILTER_DATA_FILTER_CONDITION_CONVERGING,
    unstable = MIP_FILTER_DATA_FILTER_CONDITION_UNSTABLE,
};
MIP_NAMES_OF(value_names, filter_condition, mip_names_filter_data_filter_condition)

/** mip_filter_data_cv7_status_flags: filter_data.cv7_status_flags */
enum class cv7_status_flags : uint16_t {
    filter_condition = MIP_FILTER_DATA_CV7_STATUS_FLAGS_FILTER_CONDITION,
    roll_pitch_warning = MIP_FILTER_DATA_CV7_STATUS_FLAGS_ROLL_PITCH_WARNING,
    heading_warning = MIP_FILTER_DATA_CV7_STATUS_FLAGS_HEADING_WARNING,
    position_warning = MIP_FILTER_DATA_CV7_STATUS_FLAGS_POSITION_WARNING,
    velocity_warning = MIP_FILTER_DATA_CV7_STATUS_FLAGS_VELOCITY_WARNING,
    imu_bias_warning = MIP_FILTER_DATA_CV7_STATUS_FLAGS_IMU_BIAS_WARNING,
    gnss_clock_warning = MIP_FILTER_DATA_CV7_STATUS_FLAGS_GNSS_CLOCK_WARNING,
    antenna_lever_arm_warning = MIP_FILTER_DATA_CV7_STATUS_FLAGS_ANTENNA_LEVER_ARM_WARNING,
    mounting_transform_warning = MIP_FILTER_DATA_CV7_STATUS_FLAGS_MOUNTING_TRANSFORM_WARNING,
    time_sync_warning = MIP_FILTER_DATA_CV7_STATUS_FLAGS_TIME_SYNC_WARNING,
    solution_error = MIP_FILTER_DATA_CV7_STATUS_FLAGS_SOLUTION_ERROR,
};
MIP_NAMES_OF(flag_names, cv7_status_flags, mip_names_filter_data_cv7_status_flags)

struct llh_position_ : ::mip_filter_data_llh_position {
    using c_type = ::mip_filter_data_llh_position;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** LLH position. See struct mip_filter_data_llh_position. */
using llh_position = llh_position_;

struct ned_velocity_ : ::mip_filter_data_ned_velocity {
    using c_type = ::mip_filter_data_ned_velocity;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** NED velocity. See struct mip_filter_data_ned_velocity. */
using ned_velocity = ned_velocity_;

struct attitude_quaternion_ : ::mip_filter_data_attitude_quaternion {
    using c_type = ::mip_filter_data_attitude_quaternion;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Attitude quaternion. See struct mip_filter_data_attitude_quaternion. */
using attitude_quaternion = attitude_quaternion_;

struct attitude_dcm_ : ::mip_filter_data_attitude_dcm {
    using c_type = ::mip_filter_data_attitude_dcm;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Attitude direction cosine matrix. See struct mip_filter_data_attitude_dcm. */
using attitude_dcm = attitude_dcm_;

struct euler_angles_ : ::mip_filter_data_euler_angles {
    using c_type = ::mip_filter_data_euler_angles;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Euler angles. See struct mip_filter_data_euler_angles. */
using euler_angles = euler_angles_;

struct gyro_bias_ : ::mip_filter_data_gyro_bias {
    using c_type = ::mip_filter_data_gyro_bias;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Gyroscope bias. See struct mip_filter_data_gyro_bias. */
using gyro_bias = gyro_bias_;

struct accel_bias_ : ::mip_filter_data_accel_bias {
    using c_type = ::mip_filter_data_accel_bias;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Accelerometer bias. See struct mip_filter_data_accel_bias. */
using accel_bias = accel_bias_;

struct llh_position_uncertainty_ : ::mip_filter_data_llh_position_uncertainty {
    using c_type = ::mip_filter_data_llh_position_uncertainty;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Position uncertainty. See struct mip_filter_data_llh_position_uncertainty. */
using llh_position_uncertainty = llh_position_uncertainty_;

struct ned_velocity_uncertainty_ : ::mip_filter_data_ned_velocity_uncertainty {
    using c_type = ::mip_filter_data_ned_velocity_uncertainty;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** NED velocity uncertainty. See struct mip_filter_data_ned_velocity_uncertainty. */
using ned_velocity_uncertainty = ned_velocity_uncertainty_;

struct euler_angles_uncertainty_ : ::mip_filter_data_euler_angles_uncertainty {
    using c_type = ::mip_filter_data_euler_angles_uncertainty;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Euler angles uncertainty. See struct mip_filter_data_euler_angles_uncertainty. */
using euler_angles_uncertainty = euler_angles_uncertainty_;

struct gyro_bias_uncertainty_ : ::mip_filter_data_gyro_bias_uncertainty {
    using c_type = ::mip_filter_data_gyro_bias_uncertainty;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Gyroscope bias uncertainty. See struct mip_filter_data_gyro_bias_uncertainty. */
using gyro_bias_uncertainty = gyro_bias_uncertainty_;

struct accel_bias_uncertainty_ : ::mip_filter_data_accel_bias_uncertainty {
    using c_type = ::mip_filter_data_accel_bias_uncertainty;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Accelerometer bias uncertainty. See struct mip_filter_data_accel_bias_uncertainty. */
using accel_bias_uncertainty = accel_bias_uncertainty_;

struct linear_accel_ : ::mip_filter_data_linear_accel {
    using c_type = ::mip_filter_data_linear_accel;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Linear acceleration. See struct mip_filter_data_linear_accel. */
using linear_accel = linear_accel_;

struct comp_angular_rate_ : ::mip_filter_data_comp_angular_rate {
    using c_type = ::mip_filter_data_comp_angular_rate;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Compensated angular rate. See struct mip_filter_data_comp_angular_rate. */
using comp_angular_rate = comp_angular_rate_;

struct wgs84_gravity_magnitude_ : ::mip_filter_data_wgs84_gravity_magnitude {
    using c_type = ::mip_filter_data_wgs84_gravity_magnitude;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** WGS84 local gravity magnitude. See struct mip_filter_data_wgs84_gravity_magnitude. */
using wgs84_gravity_magnitude = wgs84_gravity_magnitude_;

/** Filter status. See struct mip_filter_data_status. */
using status = ::mip_filter_data_status;

struct timestamp_ : ::mip_filter_data_timestamp {
    using c_type = ::mip_filter_data_timestamp;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Filter timestamp. See struct mip_filter_data_timestamp. */
using timestamp = timestamp_;

struct quaternion_attitude_uncertainty_ : ::mip_filter_data_quaternion_attitude_uncertainty {
    using c_type = ::mip_filter_data_quaternion_attitude_uncertainty;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Quaternion uncertainty. See struct mip_filter_data_quaternion_attitude_uncertainty. */
using quaternion_attitude_uncertainty = quaternion_attitude_uncertainty_;

struct gravity_vector_ : ::mip_filter_data_gravity_vector {
    using c_type = ::mip_filter_data_gravity_vector;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Gravity vector. See struct mip_filter_data_gravity_vector. */
using gravity_vector = gravity_vector_;

struct heading_update_state_ : ::mip_filter_data_heading_update_state {
    using c_type = ::mip_filter_data_heading_update_state;
    ::mip::filter_data::heading_source_flags source() const {
        return static_cast<::mip::filter_data::heading_source_flags>(c_type::source);
    }
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Heading update source state. See struct mip_filter_data_heading_update_state. */
using heading_update_state = heading_update_state_;

struct magnetic_model_ : ::mip_filter_data_magnetic_model {
    using c_type = ::mip_filter_data_magnetic_model;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Magnetic model. See struct mip_filter_data_magnetic_model. */
using magnetic_model = magnetic_model_;

struct gyro_scale_factor_ : ::mip_filter_data_gyro_scale_factor {
    using c_type = ::mip_filter_data_gyro_scale_factor;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Gyroscope scale factor. See struct mip_filter_data_gyro_scale_factor. */
using gyro_scale_factor = gyro_scale_factor_;

struct accel_scale_factor_ : ::mip_filter_data_accel_scale_factor {
    using c_type = ::mip_filter_data_accel_scale_factor;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Accelerometer scale factor. See struct mip_filter_data_accel_scale_factor. */
using accel_scale_factor = accel_scale_factor_;

struct gyro_scale_factor_uncertainty_ : ::mip_filter_data_gyro_scale_factor_uncertainty {
    using c_type = ::mip_filter_data_gyro_scale_factor_uncertainty;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Gyroscope scale factor uncertainty. See struct mip_filter_data_gyro_scale_factor_uncertainty. */
using gyro_scale_factor_uncertainty = gyro_scale_factor_uncertainty_;

struct accel_scale_factor_uncertainty_ : ::mip_filter_data_accel_scale_factor_uncertainty {
    using c_type = ::mip_filter_data_accel_scale_factor_uncertainty;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/**
 * Accelerometer scale factor uncertainty. See struct
 * mip_filter_data_accel_scale_factor_uncertainty.
 */
using accel_scale_factor_uncertainty = accel_scale_factor_uncertainty_;

struct mag_bias_ : ::mip_filter_data_mag_bias {
    using c_type = ::mip_filter_data_mag_bias;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Magnetometer bias. See struct mip_filter_data_mag_bias. */
using mag_bias = mag_bias_;

struct mag_bias_uncertainty_ : ::mip_filter_data_mag_bias_uncertainty {
    using c_type = ::mip_filter_data_mag_bias_uncertainty;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Magnetometer bias uncertainty. See struct mip_filter_data_mag_bias_uncertainty. */
using mag_bias_uncertainty = mag_bias_uncertainty_;

struct comp_accel_ : ::mip_filter_data_comp_accel {
    using c_type = ::mip_filter_data_comp_accel;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Compensated acceleration. See struct mip_filter_data_comp_accel. */
using comp_accel = comp_accel_;

struct standard_atmosphere_ : ::mip_filter_data_standard_atmosphere {
    using c_type = ::mip_filter_data_standard_atmosphere;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Standard atmosphere. See struct mip_filter_data_standard_atmosphere. */
using standard_atmosphere = standard_atmosphere_;

struct pressure_altitude_ : ::mip_filter_data_pressure_altitude {
    using c_type = ::mip_filter_data_pressure_altitude;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Pressure altitude. See struct mip_filter_data_pressure_altitude. */
using pressure_altitude = pressure_altitude_;

struct density_altitude_ : ::mip_filter_data_density_altitude {
    using c_type = ::mip_filter_data_density_altitude;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Density altitude. See struct mip_filter_data_density_altitude. */
using density_altitude = density_altitude_;

struct mag_offset_ : ::mip_filter_data_mag_offset {
    using c_type = ::mip_filter_data_mag_offset;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Magnetometer offset. See struct mip_filter_data_mag_offset. */
using mag_offset = mag_offset_;

struct mag_matrix_ : ::mip_filter_data_mag_matrix {
    using c_type = ::mip_filter_data_mag_matrix;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Magnetometer matrix. See struct mip_filter_data_mag_matrix. */
using mag_matrix = mag_matrix_;

struct mag_offset_uncertainty_ : ::mip_filter_data_mag_offset_uncertainty {
    using c_type = ::mip_filter_data_mag_offset_uncertainty;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Magnetometer offset uncertainty. See struct mip_filter_data_mag_offset_uncertainty. */
using mag_offset_uncertainty = mag_offset_uncertainty_;

struct mag_matrix_uncertainty_ : ::mip_filter_data_mag_matrix_uncertainty {
    using c_type = ::mip_filter_data_mag_matrix_uncertainty;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Magnetometer matrix uncertainty. See struct mip_filter_data_mag_matrix_uncertainty. */
using mag_matrix_uncertainty = mag_matrix_uncertainty_;

struct mag_covariance_matrix_ : ::mip_filter_data_mag_covariance_matrix {
    using c_type = ::mip_filter_data_mag_covariance_matrix;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Magnetometer covariance matrix. See struct mip_filter_data_mag_covariance_matrix. */
using mag_covariance_matrix = mag_covariance_matrix_;

struct mag_residual_vector_ : ::mip_filter_data_mag_residual_vector {
    using c_type = ::mip_filter_data_mag_residual_vector;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Magnetometer residual vector. See struct mip_filter_data_mag_residual_vector. */
using mag_residual_vector = mag_residual_vector_;

struct antenna_offset_correction_ : ::mip_filter_data_antenna_offset_correction {
    using c_type = ::mip_filter_data_antenna_offset_correction;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Antenna offset correction. See struct mip_filter_data_antenna_offset_correction. */
using antenna_offset_correction = antenna_offset_correction_;

struct antenna_offset_correction_uncertainty_
    : ::mip_filter_data_antenna_offset_correction_uncertainty {
    using c_type = ::mip_filter_data_antenna_offset_correction_uncertainty;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/**
 * Antenna offset correction uncertainty. See struct
 * mip_filter_data_antenna_offset_correction_uncertainty.
 */
using antenna_offset_correction_uncertainty = antenna_offset_correction_uncertainty_;

struct clock_correction_ : ::mip_filter_data_clock_correction {
    using c_type = ::mip_filter_data_clock_correction;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Clock correction. See struct mip_filter_data_clock_correction. */
using clock_correction = clock_correction_;

struct clock_correction_uncertainty_ : ::mip_filter_data_clock_correction_uncertainty {
    using c_type = ::mip_filter_data_clock_correction_uncertainty;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Clock correction uncertainty. See struct mip_filter_data_clock_correction_uncertainty. */
using clock_correction_uncertainty = clock_correction_uncertainty_;

struct multi_antenna_offset_correction_ : ::mip_filter_data_multi_antenna_offset_correction {
    using c_type = ::mip_filter_data_multi_antenna_offset_correction;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Multi-antenna offset correction. See struct mip_filter_data_multi_antenna_offset_correction. */
using multi_antenna_offset_correction = multi_antenna_offset_correction_;

struct multi_antenna_offset_correction_uncertainty_
    : ::mip_filter_data_multi_antenna_offset_uncertainty {
    using c_type = ::mip_filter_data_multi_antenna_offset_uncertainty;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/**
 * Multi-antenna offset correction uncertainty. See struct
 * mip_filter_data_multi_antenna_offset_uncertainty.
 */
using multi_antenna_offset_correction_uncertainty = multi_antenna_offset_correction_uncertainty_;

struct ecef_position_uncertainty_ : ::mip_filter_data_ecef_position_uncertainty {
    using c_type = ::mip_filter_data_ecef_position_uncertainty;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** ECEF position uncertainty. See struct mip_filter_data_ecef_position_uncertainty. */
using ecef_position_uncertainty = ecef_position_uncertainty_;

struct ecef_velocity_uncertainty_ : ::mip_filter_data_ecef_velocity_uncertainty {
    using c_type = ::mip_filter_data_ecef_velocity_uncertainty;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** ECEF velocity uncertainty. See struct mip_filter_data_ecef_velocity_uncertainty. */
using ecef_velocity_uncertainty = ecef_velocity_uncertainty_;

struct ecef_position_ : ::mip_filter_data_ecef_position {
    using c_type = ::mip_filter_data_ecef_position;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** ECEF position. See struct mip_filter_data_ecef_position. */
using ecef_position = ecef_position_;

struct ecef_velocity_ : ::mip_filter_data_ecef_velocity {
    using c_type = ::mip_filter_data_ecef_velocity;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** ECEF velocity. See struct mip_filter_data_ecef_velocity. */
using ecef_velocity = ecef_velocity_;

struct ned_relative_position_ : ::mip_filter_data_ned_relative_position {
    using c_type = ::mip_filter_data_ned_relative_position;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** NED relative position. See struct mip_filter_data_ned_relative_position. */
using ned_relative_position = ned_relative_position_;

struct gnss_position_aiding_status_ : ::mip_filter_data_gnss_position_aiding_status {
    using c_type = ::mip_filter_data_gnss_position_aiding_status;
    ::mip::filter_data::gnss_aiding_status status() const {
        return static_cast<::mip::filter_data::gnss_aiding_status>(c_type::status);
    }
};

/** GNSS position aiding status. See struct mip_filter_data_gnss_position_aiding_status. */
using gnss_position_aiding_status = gnss_position_aiding_status_;

struct gnss_attitude_aiding_status_ : ::mip_filter_data_gnss_attitude_aiding_status {
    using c_type = ::mip_filter_data_gnss_attitude_aiding_status;
    ::mip::filter_data::gnss_aiding_status status() const {
        return static_cast<::mip::filter_data::gnss_aiding_status>(c_type::status);
    }
};

/** GNSS attitude aiding status. See struct mip_filter_data_gnss_attitude_aiding_status. */
using gnss_attitude_aiding_status = gnss_attitude_aiding_status_;

struct heading_aiding_status_ : ::mip_filter_data_heading_aiding_status {
    using c_type = ::mip_filter_data_heading_aiding_status;
    ::mip::filter_data::heading_aiding_type type() const {
        return static_cast<::mip::filter_data::heading_aiding_type>(c_type::type);
    }
};

/** Heading aiding status. See struct mip_filter_data_heading_aiding_status. */
using heading_aiding_status = heading_aiding_status_;

struct aiding_measurement_summary_ : ::mip_filter_data_aiding_measurement_summary {
    using c_type = ::mip_filter_data_aiding_measurement_summary;
    ::mip::filter_data::aiding_measurement_type type() const {
        return static_cast<::mip::filter_data::aiding_measurement_type>(c_type::type);
    }
    ::mip::filter_data::aiding_measurement_indicator indicator() const {
        return static_cast<::mip::filter_data::aiding_measurement_indicator>(c_type::indicator);
    }
};

/** Aiding measurement summary. See struct mip_filter_data_aiding_measurement_summary. */
using aiding_measurement_summary = aiding_measurement_summary_;

struct odometer_scale_factor_error_ : ::mip_filter_data_odometer_scale_factor_error {
    using c_type = ::mip_filter_data_odometer_scale_factor_error;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** Odometer scale factor error. See struct mip_filter_data_odometer_scale_factor_error. */
using odometer_scale_factor_error = odometer_scale_factor_error_;

struct odometer_scale_factor_error_uncertainty_
    : ::mip_filter_data_odometer_scale_factor_error_uncertainty {
    using c_type = ::mip_filter_data_odometer_scale_factor_error_uncertainty;
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/**
 * Odometer scale factor error uncertainty. See struct
 * mip_filter_data_odometer_scale_factor_error_uncertainty.
 */
using odometer_scale_factor_error_uncertainty = odometer_scale_factor_error_uncertainty_;

struct gnss_dual_antenna_status_ : ::mip_filter_data_gnss_dual_antenna_status {
    using c_type = ::mip_filter_data_gnss_dual_antenna_status;
    ::mip::filter_data::dual_antenna_fix_type fix_type() const {
        return static_cast<::mip::filter_data::dual_antenna_fix_type>(c_type::fix_type);
    }
    ::mip::filter_data::dual_antenna_status_flags status_flags() const {
        return static_cast<::mip::filter_data::dual_antenna_status_flags>(c_type::status_flags);
    }
    ::mip::filter_data::valid_flags valid_flags() const {
        return static_cast<::mip::filter_data::valid_flags>(c_type::valid_flags);
    }
};

/** GNSS dual antenna status. See struct mip_filter_data_gnss_dual_antenna_status. */
using gnss_dual_antenna_status = gnss_dual_antenna_status_;

/** Aiding frame configuration error. See struct mip_filter_data_aiding_frame_config_error. */
using aiding_frame_config_error = ::mip_filter_data_aiding_frame_config_error;

/**
 * Aiding frame configuration error uncertainty. See struct
 * mip_filter_data_aiding_frame_config_error_uncertainty.
 */
using aiding_frame_config_error_uncertainty =
    ::mip_filter_data_aiding_frame_config_error_uncertainty;

/** @} */

} // namespace filter_data

} // namespace mip

#endif
