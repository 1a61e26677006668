/* Filter data. */
#include "mip/filter_data.h"
#include "mip/core/program.h"

static const uint8_t program_llh_position[] = {
    MIP_DOUBLES(3, MIP_AT(struct mip_filter_data_llh_position, latitude)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_llh_position, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_llh_position, 0x82, 0x01, MIP_DATA, 26, 0, MIP_SHAPE(3, 0, 1),
          program_llh_position, NULL);

static const uint8_t program_ned_velocity[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_ned_velocity, north)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_ned_velocity, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_ned_velocity, 0x82, 0x02, MIP_DATA, 14, 0, MIP_SHAPE(0, 3, 1),
          program_ned_velocity, NULL);

static const uint8_t program_attitude_quaternion[] = {
    MIP_32_BITS(4, MIP_AT(struct mip_filter_data_attitude_quaternion, q)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_attitude_quaternion, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_attitude_quaternion, 0x82, 0x03, MIP_DATA, 18, 0, MIP_SHAPE(0, 4, 1),
          program_attitude_quaternion, NULL);

static const uint8_t program_attitude_dcm[] = {
    MIP_32_BITS(9, MIP_AT(struct mip_filter_data_attitude_dcm, dcm)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_attitude_dcm, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_attitude_dcm, 0x82, 0x04, MIP_DATA, 38, 0, MIP_SHAPE(0, 9, 1),
          program_attitude_dcm, NULL);

static const uint8_t program_euler_angles[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_euler_angles, roll)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_euler_angles, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_euler_angles, 0x82, 0x05, MIP_DATA, 14, 0, MIP_SHAPE(0, 3, 1),
          program_euler_angles, NULL);

static const uint8_t program_gyro_bias[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_gyro_bias, bias)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_gyro_bias, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_gyro_bias, 0x82, 0x06, MIP_DATA, 14, 0, MIP_SHAPE(0, 3, 1),
          program_gyro_bias, NULL);

static const uint8_t program_accel_bias[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_accel_bias, bias)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_accel_bias, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_accel_bias, 0x82, 0x07, MIP_DATA, 14, 0, MIP_SHAPE(0, 3, 1),
          program_accel_bias, NULL);

static const uint8_t program_llh_position_uncertainty[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_llh_position_uncertainty, north)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_llh_position_uncertainty, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_llh_position_uncertainty, 0x82, 0x08, MIP_DATA, 14, 0, MIP_SHAPE(0, 3, 1),
          program_llh_position_uncertainty, NULL);

static const uint8_t program_ned_velocity_uncertainty[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_ned_velocity_uncertainty, north)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_ned_velocity_uncertainty, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_ned_velocity_uncertainty, 0x82, 0x09, MIP_DATA, 14, 0, MIP_SHAPE(0, 3, 1),
          program_ned_velocity_uncertainty, NULL);

static const uint8_t program_euler_angles_uncertainty[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_euler_angles_uncertainty, roll)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_euler_angles_uncertainty, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_euler_angles_uncertainty, 0x82, 0x0A, MIP_DATA, 14, 0, MIP_SHAPE(0, 3, 1),
          program_euler_angles_uncertainty, NULL);

static const uint8_t program_gyro_bias_uncertainty[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_gyro_bias_uncertainty, bias_uncertainty)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_gyro_bias_uncertainty, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_gyro_bias_uncertainty, 0x82, 0x0B, MIP_DATA, 14, 0, MIP_SHAPE(0, 3, 1),
          program_gyro_bias_uncertainty, NULL);

static const uint8_t program_accel_bias_uncertainty[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_accel_bias_uncertainty, bias_uncertainty)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_accel_bias_uncertainty, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_accel_bias_uncertainty, 0x82, 0x0C, MIP_DATA, 14, 0, MIP_SHAPE(0, 3, 1),
          program_accel_bias_uncertainty, NULL);

static const uint8_t program_linear_accel[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_linear_accel, accel)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_linear_accel, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_linear_accel, 0x82, 0x0D, MIP_DATA, 14, 0, MIP_SHAPE(0, 3, 1),
          program_linear_accel, NULL);

static const uint8_t program_comp_angular_rate[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_comp_angular_rate, gyro)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_comp_angular_rate, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_comp_angular_rate, 0x82, 0x0E, MIP_DATA, 14, 0, MIP_SHAPE(0, 3, 1),
          program_comp_angular_rate, NULL);

static const uint8_t program_wgs84_gravity_magnitude[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_filter_data_wgs84_gravity_magnitude, gravity_magnitude)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_wgs84_gravity_magnitude, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_wgs84_gravity_magnitude, 0x82, 0x0F, MIP_DATA, 6, 0, MIP_SHAPE(0, 1, 1),
          program_wgs84_gravity_magnitude, NULL);

static const uint8_t program_status[] = {
    MIP_16_BITS(3, MIP_AT(struct mip_filter_data_status, filter_state)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_status, 0x82, 0x10, MIP_DATA, 6, 0, MIP_SHAPE(0, 0, 3), program_status,
          NULL);

static const uint8_t program_timestamp[] = {
    MIP_DOUBLES(1, MIP_AT(struct mip_filter_data_timestamp, tow)),
    MIP_16_BITS(2, MIP_AT(struct mip_filter_data_timestamp, week_number)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_timestamp, 0x82, 0x11, MIP_DATA, 12, 0, MIP_SHAPE(1, 0, 2),
          program_timestamp, NULL);

static const uint8_t program_quaternion_attitude_uncertainty[] = {
    MIP_32_BITS(4, MIP_AT(struct mip_filter_data_quaternion_attitude_uncertainty, q)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_quaternion_attitude_uncertainty, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_quaternion_attitude_uncertainty, 0x82, 0x12, MIP_DATA, 18, 0,
          MIP_SHAPE(0, 4, 1), program_quaternion_attitude_uncertainty, NULL);

static const uint8_t program_gravity_vector[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_gravity_vector, gravity)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_gravity_vector, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_gravity_vector, 0x82, 0x13, MIP_DATA, 14, 0, MIP_SHAPE(0, 3, 1),
          program_gravity_vector, NULL);

static const uint8_t program_heading_update_state[] = {
    MIP_32_BITS(2, MIP_AT(struct mip_filter_data_heading_update_state, heading)),
    MIP_16_BITS(2, MIP_AT(struct mip_filter_data_heading_update_state, source)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_heading_update_state, 0x82, 0x14, MIP_DATA, 12, 0, MIP_SHAPE(0, 2, 2),
          program_heading_update_state, NULL);

static const uint8_t program_magnetic_model[] = {
    MIP_32_BITS(5, MIP_AT(struct mip_filter_data_magnetic_model, intensity_north)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_magnetic_model, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_magnetic_model, 0x82, 0x15, MIP_DATA, 22, 0, MIP_SHAPE(0, 5, 1),
          program_magnetic_model, NULL);

static const uint8_t program_gyro_scale_factor[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_gyro_scale_factor, scale_factor)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_gyro_scale_factor, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_gyro_scale_factor, 0x82, 0x16, MIP_DATA, 14, 0, MIP_SHAPE(0, 3, 1),
          program_gyro_scale_factor, NULL);

static const uint8_t program_accel_scale_factor[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_accel_scale_factor, scale_factor)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_accel_scale_factor, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_accel_scale_factor, 0x82, 0x17, MIP_DATA, 14, 0, MIP_SHAPE(0, 3, 1),
          program_accel_scale_factor, NULL);

static const uint8_t program_gyro_scale_factor_uncertainty[] = {
    MIP_32_BITS(
        3, MIP_AT(struct mip_filter_data_gyro_scale_factor_uncertainty, scale_factor_uncertainty)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_gyro_scale_factor_uncertainty, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_gyro_scale_factor_uncertainty, 0x82, 0x18, MIP_DATA, 14, 0,
          MIP_SHAPE(0, 3, 1), program_gyro_scale_factor_uncertainty, NULL);

static const uint8_t program_accel_scale_factor_uncertainty[] = {
    MIP_32_BITS(
        3, MIP_AT(struct mip_filter_data_accel_scale_factor_uncertainty, scale_factor_uncertainty)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_accel_scale_factor_uncertainty, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_accel_scale_factor_uncertainty, 0x82, 0x19, MIP_DATA, 14, 0,
          MIP_SHAPE(0, 3, 1), program_accel_scale_factor_uncertainty, NULL);

static const uint8_t program_mag_bias[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_mag_bias, bias)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_mag_bias, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_mag_bias, 0x82, 0x1A, MIP_DATA, 14, 0, MIP_SHAPE(0, 3, 1),
          program_mag_bias, NULL);

static const uint8_t program_mag_bias_uncertainty[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_mag_bias_uncertainty, bias_uncertainty)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_mag_bias_uncertainty, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_mag_bias_uncertainty, 0x82, 0x1B, MIP_DATA, 14, 0, MIP_SHAPE(0, 3, 1),
          program_mag_bias_uncertainty, NULL);

static const uint8_t program_comp_accel[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_comp_accel, accel)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_comp_accel, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_comp_accel, 0x82, 0x1C, MIP_DATA, 14, 0, MIP_SHAPE(0, 3, 1),
          program_comp_accel, NULL);

static const uint8_t program_standard_atmosphere[] = {
    MIP_32_BITS(5, MIP_AT(struct mip_filter_data_standard_atmosphere, geometric_altitude)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_standard_atmosphere, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_standard_atmosphere, 0x82, 0x20, MIP_DATA, 22, 0, MIP_SHAPE(0, 5, 1),
          program_standard_atmosphere, NULL);

static const uint8_t program_pressure_altitude[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_filter_data_pressure_altitude, pressure_altitude)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_pressure_altitude, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_pressure_altitude, 0x82, 0x21, MIP_DATA, 6, 0, MIP_SHAPE(0, 1, 1),
          program_pressure_altitude, NULL);

static const uint8_t program_density_altitude[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_filter_data_density_altitude, density_altitude)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_density_altitude, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_density_altitude, 0x82, 0x22, MIP_DATA, 6, 0, MIP_SHAPE(0, 1, 1),
          program_density_altitude, NULL);

static const uint8_t program_mag_offset[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_mag_offset, hard_iron)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_mag_offset, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_mag_offset, 0x82, 0x25, MIP_DATA, 14, 0, MIP_SHAPE(0, 3, 1),
          program_mag_offset, NULL);

static const uint8_t program_mag_matrix[] = {
    MIP_32_BITS(9, MIP_AT(struct mip_filter_data_mag_matrix, soft_iron)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_mag_matrix, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_mag_matrix, 0x82, 0x26, MIP_DATA, 38, 0, MIP_SHAPE(0, 9, 1),
          program_mag_matrix, NULL);

static const uint8_t program_mag_offset_uncertainty[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_mag_offset_uncertainty, hard_iron_uncertainty)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_mag_offset_uncertainty, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_mag_offset_uncertainty, 0x82, 0x28, MIP_DATA, 14, 0, MIP_SHAPE(0, 3, 1),
          program_mag_offset_uncertainty, NULL);

static const uint8_t program_mag_matrix_uncertainty[] = {
    MIP_32_BITS(9, MIP_AT(struct mip_filter_data_mag_matrix_uncertainty, soft_iron_uncertainty)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_mag_matrix_uncertainty, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_mag_matrix_uncertainty, 0x82, 0x29, MIP_DATA, 38, 0, MIP_SHAPE(0, 9, 1),
          program_mag_matrix_uncertainty, NULL);

static const uint8_t program_mag_covariance_matrix[] = {
    MIP_32_BITS(9, MIP_AT(struct mip_filter_data_mag_covariance_matrix, covariance)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_mag_covariance_matrix, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_mag_covariance_matrix, 0x82, 0x2A, MIP_DATA, 38, 0, MIP_SHAPE(0, 9, 1),
          program_mag_covariance_matrix, NULL);

static const uint8_t program_mag_residual_vector[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_mag_residual_vector, residual)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_mag_residual_vector, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_mag_residual_vector, 0x82, 0x2C, MIP_DATA, 14, 0, MIP_SHAPE(0, 3, 1),
          program_mag_residual_vector, NULL);

static const uint8_t program_antenna_offset_correction[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_antenna_offset_correction, offset)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_antenna_offset_correction, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_antenna_offset_correction, 0x82, 0x30, MIP_DATA, 14, 0,
          MIP_SHAPE(0, 3, 1), program_antenna_offset_correction, NULL);

static const uint8_t program_antenna_offset_correction_uncertainty[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_antenna_offset_correction_uncertainty,
                          offset_uncertainty)),
    MIP_16_BITS(1,
                MIP_AT(struct mip_filter_data_antenna_offset_correction_uncertainty, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_antenna_offset_correction_uncertainty, 0x82, 0x31, MIP_DATA, 14, 0,
          MIP_SHAPE(0, 3, 1), program_antenna_offset_correction_uncertainty, NULL);

static const uint8_t program_clock_correction[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_data_clock_correction, receiver_id)),
    MIP_32_BITS(2, MIP_AT(struct mip_filter_data_clock_correction, bias)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_clock_correction, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_clock_correction, 0x82, 0x32, MIP_DATA, 11, 0, 0,
          program_clock_correction, NULL);

static const uint8_t program_clock_correction_uncertainty[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_data_clock_correction_uncertainty, receiver_id)),
    MIP_32_BITS(2, MIP_AT(struct mip_filter_data_clock_correction_uncertainty, bias_uncertainty)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_clock_correction_uncertainty, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_clock_correction_uncertainty, 0x82, 0x33, MIP_DATA, 11, 0, 0,
          program_clock_correction_uncertainty, NULL);

static const uint8_t program_multi_antenna_offset_correction[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_data_multi_antenna_offset_correction, receiver_id)),
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_multi_antenna_offset_correction, offset)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_multi_antenna_offset_correction, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_multi_antenna_offset_correction, 0x82, 0x34, MIP_DATA, 15, 0, 0,
          program_multi_antenna_offset_correction, NULL);

static const uint8_t program_multi_antenna_offset_uncertainty[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_data_multi_antenna_offset_uncertainty, receiver_id)),
    MIP_32_BITS(
        3, MIP_AT(struct mip_filter_data_multi_antenna_offset_uncertainty, offset_uncertainty)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_multi_antenna_offset_uncertainty, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_multi_antenna_offset_uncertainty, 0x82, 0x35, MIP_DATA, 15, 0, 0,
          program_multi_antenna_offset_uncertainty, NULL);

static const uint8_t program_ecef_position_uncertainty[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_ecef_position_uncertainty, position_uncertainty)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_ecef_position_uncertainty, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_ecef_position_uncertainty, 0x82, 0x36, MIP_DATA, 14, 0,
          MIP_SHAPE(0, 3, 1), program_ecef_position_uncertainty, NULL);

static const uint8_t program_ecef_velocity_uncertainty[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_ecef_velocity_uncertainty, velocity_uncertainty)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_ecef_velocity_uncertainty, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_ecef_velocity_uncertainty, 0x82, 0x37, MIP_DATA, 14, 0,
          MIP_SHAPE(0, 3, 1), program_ecef_velocity_uncertainty, NULL);

static const uint8_t program_ecef_position[] = {
    MIP_DOUBLES(3, MIP_AT(struct mip_filter_data_ecef_position, position)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_ecef_position, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_ecef_position, 0x82, 0x40, MIP_DATA, 26, 0, MIP_SHAPE(3, 0, 1),
          program_ecef_position, NULL);

static const uint8_t program_ecef_velocity[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_ecef_velocity, velocity)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_ecef_velocity, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_ecef_velocity, 0x82, 0x41, MIP_DATA, 14, 0, MIP_SHAPE(0, 3, 1),
          program_ecef_velocity, NULL);

static const uint8_t program_ned_relative_position[] = {
    MIP_DOUBLES(3, MIP_AT(struct mip_filter_data_ned_relative_position, relative_position)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_ned_relative_position, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_ned_relative_position, 0x82, 0x42, MIP_DATA, 26, 0, MIP_SHAPE(3, 0, 1),
          program_ned_relative_position, NULL);

static const uint8_t program_gnss_position_aiding_status[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_data_gnss_position_aiding_status, receiver_id)),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_data_gnss_position_aiding_status, tow)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_gnss_position_aiding_status, status)),
    MIP_8_BITS(8, MIP_AT(struct mip_filter_data_gnss_position_aiding_status, reserved)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_gnss_position_aiding_status, 0x82, 0x43, MIP_DATA, 15, 0, 0,
          program_gnss_position_aiding_status, NULL);

static const uint8_t program_gnss_attitude_aiding_status[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_filter_data_gnss_attitude_aiding_status, tow)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_gnss_attitude_aiding_status, status)),
    MIP_8_BITS(8, MIP_AT(struct mip_filter_data_gnss_attitude_aiding_status, reserved)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_gnss_attitude_aiding_status, 0x82, 0x44, MIP_DATA, 14, 0, 0,
          program_gnss_attitude_aiding_status, NULL);

static const uint8_t program_heading_aiding_status[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_filter_data_heading_aiding_status, tow)),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_data_heading_aiding_status, type)),
    MIP_32_BITS(2, MIP_AT(struct mip_filter_data_heading_aiding_status, reserved)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_heading_aiding_status, 0x82, 0x45, MIP_DATA, 13, 0, 0,
          program_heading_aiding_status, NULL);

static const uint8_t program_aiding_measurement_summary[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_filter_data_aiding_measurement_summary, tow)),
    MIP_8_BITS(3, MIP_AT(struct mip_filter_data_aiding_measurement_summary, source)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_aiding_measurement_summary, 0x82, 0x46, MIP_DATA, 7, 0, 0,
          program_aiding_measurement_summary, NULL);

static const uint8_t program_odometer_scale_factor_error[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_filter_data_odometer_scale_factor_error, scale_factor_error)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_data_odometer_scale_factor_error, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_odometer_scale_factor_error, 0x82, 0x47, MIP_DATA, 6, 0,
          MIP_SHAPE(0, 1, 1), program_odometer_scale_factor_error, NULL);

static const uint8_t program_odometer_scale_factor_error_uncertainty[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_filter_data_odometer_scale_factor_error_uncertainty,
                          scale_factor_error_uncertainty)),
    MIP_16_BITS(
        1, MIP_AT(struct mip_filter_data_odometer_scale_factor_error_uncertainty, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_odometer_scale_factor_error_uncertainty, 0x82, 0x48, MIP_DATA, 6, 0,
          MIP_SHAPE(0, 1, 1), program_odometer_scale_factor_error_uncertainty, NULL);

static const uint8_t program_gnss_dual_antenna_status[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_data_gnss_dual_antenna_status, tow)),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_data_gnss_dual_antenna_status, fix_type)),
    MIP_16_BITS(2, MIP_AT(struct mip_filter_data_gnss_dual_antenna_status, status_flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_gnss_dual_antenna_status, 0x82, 0x49, MIP_DATA, 17, 0, 0,
          program_gnss_dual_antenna_status, NULL);

static const uint8_t program_aiding_frame_config_error[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_data_aiding_frame_config_error, frame_id)),
    MIP_32_BITS(7, MIP_AT(struct mip_filter_data_aiding_frame_config_error, translation)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_aiding_frame_config_error, 0x82, 0x50, MIP_DATA, 29, 0, 0,
          program_aiding_frame_config_error, NULL);

static const uint8_t program_aiding_frame_config_error_uncertainty[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_data_aiding_frame_config_error_uncertainty, frame_id)),
    MIP_32_BITS(6, MIP_AT(struct mip_filter_data_aiding_frame_config_error_uncertainty,
                          translation_uncertainty)),
    MIP_END,
};

MIP_CODEC(mip_filter_data_aiding_frame_config_error_uncertainty, 0x82, 0x51, MIP_DATA, 25, 0, 0,
          program_aiding_frame_config_error_uncertainty, NULL);
