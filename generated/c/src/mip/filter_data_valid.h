/**
 * @file
 * Functions that tell whether values of the fields in mip/filter_data.h are valid, by their flags.
 * `reading` is the result of mip_reading_of, in mip/timestamps.h: 0 if the device is not known.
 */
#ifndef MIP_FILTER_DATA_VALID_H
#define MIP_FILTER_DATA_VALID_H

#include "mip/filter_data.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/filter_data_valid.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Are the values of filter_data.llh_position valid? */
static inline bool
mip_filter_data_llh_position_valid(const struct mip_filter_data_llh_position *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.ned_velocity valid? */
static inline bool
mip_filter_data_ned_velocity_valid(const struct mip_filter_data_ned_velocity *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.attitude_quaternion valid? */
static inline bool
mip_filter_data_attitude_quaternion_valid(const struct mip_filter_data_attitude_quaternion *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.attitude_dcm valid? */
static inline bool
mip_filter_data_attitude_dcm_valid(const struct mip_filter_data_attitude_dcm *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.euler_angles valid? */
static inline bool
mip_filter_data_euler_angles_valid(const struct mip_filter_data_euler_angles *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.gyro_bias valid? */
static inline bool mip_filter_data_gyro_bias_valid(const struct mip_filter_data_gyro_bias *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.accel_bias valid? */
static inline bool
mip_filter_data_accel_bias_valid(const struct mip_filter_data_accel_bias *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.llh_position_uncertainty valid? */
static inline bool mip_filter_data_llh_position_uncertainty_valid(
    const struct mip_filter_data_llh_position_uncertainty *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.ned_velocity_uncertainty valid? */
static inline bool mip_filter_data_ned_velocity_uncertainty_valid(
    const struct mip_filter_data_ned_velocity_uncertainty *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.euler_angles_uncertainty valid? */
static inline bool mip_filter_data_euler_angles_uncertainty_valid(
    const struct mip_filter_data_euler_angles_uncertainty *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.gyro_bias_uncertainty valid? */
static inline bool mip_filter_data_gyro_bias_uncertainty_valid(
    const struct mip_filter_data_gyro_bias_uncertainty *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.accel_bias_uncertainty valid? */
static inline bool mip_filter_data_accel_bias_uncertainty_valid(
    const struct mip_filter_data_accel_bias_uncertainty *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.linear_accel valid? */
static inline bool
mip_filter_data_linear_accel_valid(const struct mip_filter_data_linear_accel *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.comp_angular_rate valid? */
static inline bool
mip_filter_data_comp_angular_rate_valid(const struct mip_filter_data_comp_angular_rate *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.wgs84_gravity_magnitude valid? */
static inline bool mip_filter_data_wgs84_gravity_magnitude_valid(
    const struct mip_filter_data_wgs84_gravity_magnitude *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.timestamp valid? */
static inline bool mip_filter_data_timestamp_valid(const struct mip_filter_data_timestamp *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.quaternion_attitude_uncertainty valid? */
static inline bool mip_filter_data_quaternion_attitude_uncertainty_valid(
    const struct mip_filter_data_quaternion_attitude_uncertainty *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.gravity_vector valid? */
static inline bool
mip_filter_data_gravity_vector_valid(const struct mip_filter_data_gravity_vector *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.heading_update_state valid? */
static inline bool mip_filter_data_heading_update_state_valid(
    const struct mip_filter_data_heading_update_state *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.magnetic_model valid? */
static inline bool
mip_filter_data_magnetic_model_valid(const struct mip_filter_data_magnetic_model *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.gyro_scale_factor valid? */
static inline bool
mip_filter_data_gyro_scale_factor_valid(const struct mip_filter_data_gyro_scale_factor *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.accel_scale_factor valid? */
static inline bool
mip_filter_data_accel_scale_factor_valid(const struct mip_filter_data_accel_scale_factor *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.gyro_scale_factor_uncertainty valid? */
static inline bool mip_filter_data_gyro_scale_factor_uncertainty_valid(
    const struct mip_filter_data_gyro_scale_factor_uncertainty *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.accel_scale_factor_uncertainty valid? */
static inline bool mip_filter_data_accel_scale_factor_uncertainty_valid(
    const struct mip_filter_data_accel_scale_factor_uncertainty *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.mag_bias valid? */
static inline bool mip_filter_data_mag_bias_valid(const struct mip_filter_data_mag_bias *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.mag_bias_uncertainty valid? */
static inline bool mip_filter_data_mag_bias_uncertainty_valid(
    const struct mip_filter_data_mag_bias_uncertainty *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.comp_accel valid? */
static inline bool
mip_filter_data_comp_accel_valid(const struct mip_filter_data_comp_accel *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.standard_atmosphere valid? */
static inline bool
mip_filter_data_standard_atmosphere_valid(const struct mip_filter_data_standard_atmosphere *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.pressure_altitude valid? */
static inline bool
mip_filter_data_pressure_altitude_valid(const struct mip_filter_data_pressure_altitude *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.density_altitude valid? */
static inline bool
mip_filter_data_density_altitude_valid(const struct mip_filter_data_density_altitude *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.mag_offset valid? */
static inline bool
mip_filter_data_mag_offset_valid(const struct mip_filter_data_mag_offset *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.mag_matrix valid? */
static inline bool
mip_filter_data_mag_matrix_valid(const struct mip_filter_data_mag_matrix *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.mag_offset_uncertainty valid? */
static inline bool mip_filter_data_mag_offset_uncertainty_valid(
    const struct mip_filter_data_mag_offset_uncertainty *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.mag_matrix_uncertainty valid? */
static inline bool mip_filter_data_mag_matrix_uncertainty_valid(
    const struct mip_filter_data_mag_matrix_uncertainty *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.mag_covariance_matrix valid? */
static inline bool mip_filter_data_mag_covariance_matrix_valid(
    const struct mip_filter_data_mag_covariance_matrix *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.mag_residual_vector valid? */
static inline bool
mip_filter_data_mag_residual_vector_valid(const struct mip_filter_data_mag_residual_vector *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.antenna_offset_correction valid? */
static inline bool mip_filter_data_antenna_offset_correction_valid(
    const struct mip_filter_data_antenna_offset_correction *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.antenna_offset_correction_uncertainty valid? */
static inline bool mip_filter_data_antenna_offset_correction_uncertainty_valid(
    const struct mip_filter_data_antenna_offset_correction_uncertainty *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.clock_correction valid? */
static inline bool
mip_filter_data_clock_correction_valid(const struct mip_filter_data_clock_correction *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.clock_correction_uncertainty valid? */
static inline bool mip_filter_data_clock_correction_uncertainty_valid(
    const struct mip_filter_data_clock_correction_uncertainty *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.multi_antenna_offset_correction valid? */
static inline bool mip_filter_data_multi_antenna_offset_correction_valid(
    const struct mip_filter_data_multi_antenna_offset_correction *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.multi_antenna_offset_correction_uncertainty valid? */
static inline bool mip_filter_data_multi_antenna_offset_uncertainty_valid(
    const struct mip_filter_data_multi_antenna_offset_uncertainty *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.ecef_position_uncertainty valid? */
static inline bool mip_filter_data_ecef_position_uncertainty_valid(
    const struct mip_filter_data_ecef_position_uncertainty *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.ecef_velocity_uncertainty valid? */
static inline bool mip_filter_data_ecef_velocity_uncertainty_valid(
    const struct mip_filter_data_ecef_velocity_uncertainty *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.ecef_position valid? */
static inline bool
mip_filter_data_ecef_position_valid(const struct mip_filter_data_ecef_position *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.ecef_velocity valid? */
static inline bool
mip_filter_data_ecef_velocity_valid(const struct mip_filter_data_ecef_velocity *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.ned_relative_position valid? */
static inline bool mip_filter_data_ned_relative_position_valid(
    const struct mip_filter_data_ned_relative_position *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.odometer_scale_factor_error valid? */
static inline bool mip_filter_data_odometer_scale_factor_error_valid(
    const struct mip_filter_data_odometer_scale_factor_error *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.odometer_scale_factor_error_uncertainty valid? */
static inline bool mip_filter_data_odometer_scale_factor_error_uncertainty_valid(
    const struct mip_filter_data_odometer_scale_factor_error_uncertainty *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of filter_data.gnss_dual_antenna_status valid? */
static inline bool mip_filter_data_gnss_dual_antenna_status_valid(
    const struct mip_filter_data_gnss_dual_antenna_status *value) {
    return mip_has(value->valid_flags, 0x1U);
}

#ifdef __cplusplus
}
#endif

#endif
