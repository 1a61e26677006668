/* Filter commands. */
#include "mip/filter.h"
#include "mip/filter_commands.h"
#include "mip/core/program.h"

static const uint8_t program_reset[] = {
    MIP_END,
};

MIP_CODEC(mip_filter_reset, 0x0D, 0x01, MIP_COMMAND, 0, 0, 0, program_reset, NULL);

MIP_EXCHANGE(mip_filter_reset, 0x0D, 0x01, 0, 0, NULL, false);

static const uint8_t program_set_initial_attitude[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_set_initial_attitude, roll)),
    MIP_END,
};

MIP_CODEC(mip_filter_set_initial_attitude, 0x0D, 0x02, MIP_COMMAND, 12, 0, MIP_SHAPE(0, 3, 0),
          program_set_initial_attitude, NULL);

MIP_EXCHANGE(mip_filter_set_initial_attitude, 0x0D, 0x02, 0, 0, NULL, false);

static const uint8_t program_set_initial_heading[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_filter_set_initial_heading, heading)),
    MIP_END,
};

MIP_CODEC(mip_filter_set_initial_heading, 0x0D, 0x03, MIP_COMMAND, 4, 0, MIP_SHAPE(0, 1, 0),
          program_set_initial_heading, NULL);

MIP_EXCHANGE(mip_filter_set_initial_heading, 0x0D, 0x03, 0, 0, NULL, false);

static const uint8_t program_set_initial_attitude_from_imu[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_filter_set_initial_attitude_from_imu, declination)),
    MIP_END,
};

MIP_CODEC(mip_filter_set_initial_attitude_from_imu, 0x0D, 0x04, MIP_COMMAND, 4, 0,
          MIP_SHAPE(0, 1, 0), program_set_initial_attitude_from_imu, NULL);

MIP_EXCHANGE(mip_filter_set_initial_attitude_from_imu, 0x0D, 0x04, 0, 0, NULL, false);

static const uint8_t program_run[] = {
    MIP_END,
};

MIP_CODEC(mip_filter_run, 0x0D, 0x05, MIP_COMMAND, 0, 0, 0, program_run, NULL);

MIP_EXCHANGE(mip_filter_run, 0x0D, 0x05, 0, 0, NULL, false);

static const uint8_t program_vehicle_dynamics_mode[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_vehicle_dynamics_mode, mode)),
    MIP_END,
};

MIP_CODEC(mip_filter_vehicle_dynamics_mode, 0x0D, 0x10, MIP_COMMAND, 0, 0, 0,
          program_vehicle_dynamics_mode, &mip_program);

static const struct mip_response responses_vehicle_dynamics_mode[] = {
    {NULL, 0x80, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_vehicle_dynamics_mode, 0x0D, 0x10, 0, 1, responses_vehicle_dynamics_mode,
             true);

static const uint8_t program_vehicle_dynamics_mode_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_vehicle_dynamics_mode_response, mode)),
    MIP_END,
};

MIP_CODEC(mip_filter_vehicle_dynamics_mode_response, 0x0D, 0x80, MIP_RESPONSE, 1, 0, 0,
          program_vehicle_dynamics_mode_response, NULL);

static const uint8_t program_sensor_to_vehicle_rotation_euler[] = {
    MIP_REQUIRED(1, 3),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_sensor_to_vehicle_rotation_euler, roll)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_sensor_to_vehicle_rotation_euler, pitch)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_sensor_to_vehicle_rotation_euler, yaw)),
    MIP_END,
};

MIP_CODEC(mip_filter_sensor_to_vehicle_rotation_euler, 0x0D, 0x11, MIP_COMMAND, 0, 0, 0,
          program_sensor_to_vehicle_rotation_euler, &mip_program);

static const struct mip_response responses_sensor_to_vehicle_rotation_euler[] = {
    {NULL, 0x81, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_sensor_to_vehicle_rotation_euler, 0x0D, 0x11, 0, 1,
             responses_sensor_to_vehicle_rotation_euler, true);

static const uint8_t program_sensor_to_vehicle_rotation_euler_response[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_sensor_to_vehicle_rotation_euler_response, roll)),
    MIP_END,
};

MIP_CODEC(mip_filter_sensor_to_vehicle_rotation_euler_response, 0x0D, 0x81, MIP_RESPONSE, 12, 0,
          MIP_SHAPE(0, 3, 0), program_sensor_to_vehicle_rotation_euler_response, NULL);

static const uint8_t program_sensor_to_vehicle_offset[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_32_BITS(3, MIP_AT(struct mip_filter_sensor_to_vehicle_offset, offset)),
    MIP_END,
};

MIP_CODEC(mip_filter_sensor_to_vehicle_offset, 0x0D, 0x12, MIP_COMMAND, 0, 0, 0,
          program_sensor_to_vehicle_offset, &mip_program);

static const struct mip_response responses_sensor_to_vehicle_offset[] = {
    {NULL, 0x82, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_sensor_to_vehicle_offset, 0x0D, 0x12, 0, 1,
             responses_sensor_to_vehicle_offset, true);

static const uint8_t program_sensor_to_vehicle_offset_response[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_sensor_to_vehicle_offset_response, offset)),
    MIP_END,
};

MIP_CODEC(mip_filter_sensor_to_vehicle_offset_response, 0x0D, 0x82, MIP_RESPONSE, 12, 0,
          MIP_SHAPE(0, 3, 0), program_sensor_to_vehicle_offset_response, NULL);

static const uint8_t program_antenna_offset[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_32_BITS(3, MIP_AT(struct mip_filter_antenna_offset, offset)),
    MIP_END,
};

MIP_CODEC(mip_filter_antenna_offset, 0x0D, 0x13, MIP_COMMAND, 0, 0, 0, program_antenna_offset,
          &mip_program);

static const struct mip_response responses_antenna_offset[] = {
    {NULL, 0x83, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_antenna_offset, 0x0D, 0x13, 0, 1, responses_antenna_offset, true);

static const uint8_t program_antenna_offset_response[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_antenna_offset_response, offset)),
    MIP_END,
};

MIP_CODEC(mip_filter_antenna_offset_response, 0x0D, 0x83, MIP_RESPONSE, 12, 0, MIP_SHAPE(0, 3, 0),
          program_antenna_offset_response, NULL);

static const uint8_t program_estimation_control[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_estimation_control, flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_estimation_control, 0x0D, 0x14, MIP_COMMAND, 0, 0, 0,
          program_estimation_control, &mip_program);

static const struct mip_response responses_estimation_control[] = {
    {NULL, 0x84, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_estimation_control, 0x0D, 0x14, 0, 1, responses_estimation_control, true);

static const uint8_t program_estimation_control_response[] = {
    MIP_16_BITS(1, MIP_AT(struct mip_filter_estimation_control_response, flags)),
    MIP_END,
};

MIP_CODEC(mip_filter_estimation_control_response, 0x0D, 0x84, MIP_RESPONSE, 2, 0,
          MIP_SHAPE(0, 0, 1), program_estimation_control_response, NULL);

static const uint8_t program_gnss_source[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_gnss_source, source)),
    MIP_END,
};

MIP_CODEC(mip_filter_gnss_source, 0x0D, 0x15, MIP_COMMAND, 0, 0, 0, program_gnss_source,
          &mip_program);

static const struct mip_response responses_gnss_source[] = {
    {NULL, 0x86, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_gnss_source, 0x0D, 0x15, 0, 1, responses_gnss_source, true);

static const uint8_t program_gnss_source_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_gnss_source_response, source)),
    MIP_END,
};

MIP_CODEC(mip_filter_gnss_source_response, 0x0D, 0x86, MIP_RESPONSE, 1, 0, 0,
          program_gnss_source_response, NULL);

static const uint8_t program_external_gnss_update[] = {
    MIP_DOUBLES(1, MIP_AT(struct mip_filter_external_gnss_update, tow)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_external_gnss_update, week_number)),
    MIP_DOUBLES(3, MIP_AT(struct mip_filter_external_gnss_update, latitude)),
    MIP_32_BITS(9, MIP_AT(struct mip_filter_external_gnss_update, velocity)),
    MIP_END,
};

MIP_CODEC(mip_filter_external_gnss_update, 0x0D, 0x16, MIP_COMMAND, 70, 0, 0,
          program_external_gnss_update, NULL);

MIP_EXCHANGE(mip_filter_external_gnss_update, 0x0D, 0x16, 0, 0, NULL, false);

static const uint8_t program_external_heading_update[] = {
    MIP_32_BITS(2, MIP_AT(struct mip_filter_external_heading_update, heading)),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_external_heading_update, type)),
    MIP_END,
};

MIP_CODEC(mip_filter_external_heading_update, 0x0D, 0x17, MIP_COMMAND, 9, 0, 0,
          program_external_heading_update, NULL);

MIP_EXCHANGE(mip_filter_external_heading_update, 0x0D, 0x17, 0, 0, NULL, false);

static const uint8_t program_heading_source[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_heading_source, source)),
    MIP_END,
};

MIP_CODEC(mip_filter_heading_source, 0x0D, 0x18, MIP_COMMAND, 0, 0, 0, program_heading_source,
          &mip_program);

static const struct mip_response responses_heading_source[] = {
    {NULL, 0x87, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_heading_source, 0x0D, 0x18, 0, 1, responses_heading_source, true);

static const uint8_t program_heading_source_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_heading_source_response, source)),
    MIP_END,
};

MIP_CODEC(mip_filter_heading_source_response, 0x0D, 0x87, MIP_RESPONSE, 1, 0, 0,
          program_heading_source_response, NULL);

static const uint8_t program_auto_initialization_control[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_auto_initialization_control, enable)),
    MIP_END,
};

MIP_CODEC(mip_filter_auto_initialization_control, 0x0D, 0x19, MIP_COMMAND, 0, 0, 0,
          program_auto_initialization_control, &mip_program);

static const struct mip_response responses_auto_initialization_control[] = {
    {NULL, 0x88, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_auto_initialization_control, 0x0D, 0x19, 0, 1,
             responses_auto_initialization_control, true);

static const uint8_t program_auto_initialization_control_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_auto_initialization_control_response, enable)),
    MIP_END,
};

MIP_CODEC(mip_filter_auto_initialization_control_response, 0x0D, 0x88, MIP_RESPONSE, 1, 0, 0,
          program_auto_initialization_control_response, NULL);

static const uint8_t program_accel_noise[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_32_BITS(3, MIP_AT(struct mip_filter_accel_noise, noise)),
    MIP_END,
};

MIP_CODEC(mip_filter_accel_noise, 0x0D, 0x1A, MIP_COMMAND, 0, 0, 0, program_accel_noise,
          &mip_program);

static const struct mip_response responses_accel_noise[] = {
    {NULL, 0x89, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_accel_noise, 0x0D, 0x1A, 0, 1, responses_accel_noise, true);

static const uint8_t program_accel_noise_response[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_accel_noise_response, noise)),
    MIP_END,
};

MIP_CODEC(mip_filter_accel_noise_response, 0x0D, 0x89, MIP_RESPONSE, 12, 0, MIP_SHAPE(0, 3, 0),
          program_accel_noise_response, NULL);

static const uint8_t program_gyro_noise[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_32_BITS(3, MIP_AT(struct mip_filter_gyro_noise, noise)),
    MIP_END,
};

MIP_CODEC(mip_filter_gyro_noise, 0x0D, 0x1B, MIP_COMMAND, 0, 0, 0, program_gyro_noise,
          &mip_program);

static const struct mip_response responses_gyro_noise[] = {
    {NULL, 0x8A, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_gyro_noise, 0x0D, 0x1B, 0, 1, responses_gyro_noise, true);

static const uint8_t program_gyro_noise_response[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_gyro_noise_response, noise)),
    MIP_END,
};

MIP_CODEC(mip_filter_gyro_noise_response, 0x0D, 0x8A, MIP_RESPONSE, 12, 0, MIP_SHAPE(0, 3, 0),
          program_gyro_noise_response, NULL);

static const uint8_t program_accel_bias_model[] = {
    MIP_REQUIRED(1, 2),
    MIP_GROUP(1),
    MIP_32_BITS(3, MIP_AT(struct mip_filter_accel_bias_model, beta)),
    MIP_GROUP(1),
    MIP_32_BITS(3, MIP_AT(struct mip_filter_accel_bias_model, noise)),
    MIP_END,
};

MIP_CODEC(mip_filter_accel_bias_model, 0x0D, 0x1C, MIP_COMMAND, 0, 0, 0, program_accel_bias_model,
          &mip_program);

static const struct mip_response responses_accel_bias_model[] = {
    {NULL, 0x8B, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_accel_bias_model, 0x0D, 0x1C, 0, 1, responses_accel_bias_model, true);

static const uint8_t program_accel_bias_model_response[] = {
    MIP_32_BITS(6, MIP_AT(struct mip_filter_accel_bias_model_response, beta)),
    MIP_END,
};

MIP_CODEC(mip_filter_accel_bias_model_response, 0x0D, 0x8B, MIP_RESPONSE, 24, 0, MIP_SHAPE(0, 6, 0),
          program_accel_bias_model_response, NULL);

static const uint8_t program_gyro_bias_model[] = {
    MIP_REQUIRED(1, 2),
    MIP_GROUP(1),
    MIP_32_BITS(3, MIP_AT(struct mip_filter_gyro_bias_model, beta)),
    MIP_GROUP(1),
    MIP_32_BITS(3, MIP_AT(struct mip_filter_gyro_bias_model, noise)),
    MIP_END,
};

MIP_CODEC(mip_filter_gyro_bias_model, 0x0D, 0x1D, MIP_COMMAND, 0, 0, 0, program_gyro_bias_model,
          &mip_program);

static const struct mip_response responses_gyro_bias_model[] = {
    {NULL, 0x8C, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_gyro_bias_model, 0x0D, 0x1D, 0, 1, responses_gyro_bias_model, true);

static const uint8_t program_gyro_bias_model_response[] = {
    MIP_32_BITS(6, MIP_AT(struct mip_filter_gyro_bias_model_response, beta)),
    MIP_END,
};

MIP_CODEC(mip_filter_gyro_bias_model_response, 0x0D, 0x8C, MIP_RESPONSE, 24, 0, MIP_SHAPE(0, 6, 0),
          program_gyro_bias_model_response, NULL);

static const uint8_t program_auto_zupt[] = {
    MIP_REQUIRED(1, 2),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_auto_zupt, enable)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_auto_zupt, threshold)),
    MIP_END,
};

MIP_CODEC(mip_filter_auto_zupt, 0x0D, 0x1E, MIP_COMMAND, 0, 0, 0, program_auto_zupt, &mip_program);

static const struct mip_response responses_auto_zupt[] = {
    {NULL, 0x8D, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_auto_zupt, 0x0D, 0x1E, 0, 1, responses_auto_zupt, true);

static const uint8_t program_auto_zupt_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_auto_zupt_response, enable)),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_auto_zupt_response, threshold)),
    MIP_END,
};

MIP_CODEC(mip_filter_auto_zupt_response, 0x0D, 0x8D, MIP_RESPONSE, 5, 0, 0,
          program_auto_zupt_response, NULL);

static const uint8_t program_external_heading_update_with_time[] = {
    MIP_DOUBLES(1, MIP_AT(struct mip_filter_external_heading_update_with_time, tow)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_external_heading_update_with_time, week_number)),
    MIP_32_BITS(2, MIP_AT(struct mip_filter_external_heading_update_with_time, heading)),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_external_heading_update_with_time, type)),
    MIP_END,
};

MIP_CODEC(mip_filter_external_heading_update_with_time, 0x0D, 0x1F, MIP_COMMAND, 19, 0, 0,
          program_external_heading_update_with_time, NULL);

MIP_EXCHANGE(mip_filter_external_heading_update_with_time, 0x0D, 0x1F, 0, 0, NULL, false);

static const uint8_t program_auto_angular_zupt[] = {
    MIP_REQUIRED(1, 2),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_auto_angular_zupt, enable)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_auto_angular_zupt, threshold)),
    MIP_END,
};

MIP_CODEC(mip_filter_auto_angular_zupt, 0x0D, 0x20, MIP_COMMAND, 0, 0, 0, program_auto_angular_zupt,
          &mip_program);

static const struct mip_response responses_auto_angular_zupt[] = {
    {NULL, 0x8E, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_auto_angular_zupt, 0x0D, 0x20, 0, 1, responses_auto_angular_zupt, true);

static const uint8_t program_auto_angular_zupt_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_auto_angular_zupt_response, enable)),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_auto_angular_zupt_response, threshold)),
    MIP_END,
};

MIP_CODEC(mip_filter_auto_angular_zupt_response, 0x0D, 0x8E, MIP_RESPONSE, 5, 0, 0,
          program_auto_angular_zupt_response, NULL);

static const uint8_t program_tare_orientation[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_tare_orientation, axes)),
    MIP_END,
};

MIP_CODEC(mip_filter_tare_orientation, 0x0D, 0x21, MIP_COMMAND, 0, 0, 0, program_tare_orientation,
          &mip_program);

static const struct mip_response responses_tare_orientation[] = {
    {NULL, 0xA1, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_tare_orientation, 0x0D, 0x21, 0, 1, responses_tare_orientation, true);

static const uint8_t program_tare_orientation_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_tare_orientation_response, axes)),
    MIP_END,
};

MIP_CODEC(mip_filter_tare_orientation_response, 0x0D, 0xA1, MIP_RESPONSE, 1, 0, 0,
          program_tare_orientation_response, NULL);

static const uint8_t program_commanded_zupt[] = {
    MIP_END,
};

MIP_CODEC(mip_filter_commanded_zupt, 0x0D, 0x22, MIP_COMMAND, 0, 0, 0, program_commanded_zupt,
          NULL);

MIP_EXCHANGE(mip_filter_commanded_zupt, 0x0D, 0x22, 0, 0, NULL, false);

static const uint8_t program_commanded_angular_zupt[] = {
    MIP_END,
};

MIP_CODEC(mip_filter_commanded_angular_zupt, 0x0D, 0x23, MIP_COMMAND, 0, 0, 0,
          program_commanded_angular_zupt, NULL);

MIP_EXCHANGE(mip_filter_commanded_angular_zupt, 0x0D, 0x23, 0, 0, NULL, false);

static const uint8_t program_reference_position[] = {
    MIP_REQUIRED(1, 4),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_reference_position, enable)),
    MIP_GROUP(1),
    MIP_DOUBLES(1, MIP_AT(struct mip_filter_reference_position, latitude)),
    MIP_GROUP(1),
    MIP_DOUBLES(1, MIP_AT(struct mip_filter_reference_position, longitude)),
    MIP_GROUP(1),
    MIP_DOUBLES(1, MIP_AT(struct mip_filter_reference_position, altitude)),
    MIP_END,
};

MIP_CODEC(mip_filter_reference_position, 0x0D, 0x26, MIP_COMMAND, 0, 0, 0,
          program_reference_position, &mip_program);

static const struct mip_response responses_reference_position[] = {
    {NULL, 0x90, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_reference_position, 0x0D, 0x26, 0, 1, responses_reference_position, true);

static const uint8_t program_reference_position_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_reference_position_response, enable)),
    MIP_DOUBLES(3, MIP_AT(struct mip_filter_reference_position_response, latitude)),
    MIP_END,
};

MIP_CODEC(mip_filter_reference_position_response, 0x0D, 0x90, MIP_RESPONSE, 25, 0, 0,
          program_reference_position_response, NULL);

static const uint8_t program_mag_capture_auto_calibration[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_mag_capture_auto_calibration, function)),
    MIP_END,
};

MIP_CODEC(mip_filter_mag_capture_auto_calibration, 0x0D, 0x27, MIP_COMMAND, 1, 0, 0,
          program_mag_capture_auto_calibration, NULL);

MIP_EXCHANGE(mip_filter_mag_capture_auto_calibration, 0x0D, 0x27, 0, 0, NULL, true);

static const uint8_t program_gravity_noise[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_32_BITS(3, MIP_AT(struct mip_filter_gravity_noise, noise)),
    MIP_END,
};

MIP_CODEC(mip_filter_gravity_noise, 0x0D, 0x28, MIP_COMMAND, 0, 0, 0, program_gravity_noise,
          &mip_program);

static const struct mip_response responses_gravity_noise[] = {
    {NULL, 0x93, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_gravity_noise, 0x0D, 0x28, 0, 1, responses_gravity_noise, true);

static const uint8_t program_gravity_noise_response[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_gravity_noise_response, noise)),
    MIP_END,
};

MIP_CODEC(mip_filter_gravity_noise_response, 0x0D, 0x93, MIP_RESPONSE, 12, 0, MIP_SHAPE(0, 3, 0),
          program_gravity_noise_response, NULL);

static const uint8_t program_pressure_altitude_noise[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_pressure_altitude_noise, noise)),
    MIP_END,
};

MIP_CODEC(mip_filter_pressure_altitude_noise, 0x0D, 0x29, MIP_COMMAND, 0, 0, 0,
          program_pressure_altitude_noise, &mip_program);

static const struct mip_response responses_pressure_altitude_noise[] = {
    {NULL, 0x94, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_pressure_altitude_noise, 0x0D, 0x29, 0, 1,
             responses_pressure_altitude_noise, true);

static const uint8_t program_pressure_altitude_noise_response[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_filter_pressure_altitude_noise_response, noise)),
    MIP_END,
};

MIP_CODEC(mip_filter_pressure_altitude_noise_response, 0x0D, 0x94, MIP_RESPONSE, 4, 0,
          MIP_SHAPE(0, 1, 0), program_pressure_altitude_noise_response, NULL);

static const uint8_t program_hard_iron_offset_noise[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_32_BITS(3, MIP_AT(struct mip_filter_hard_iron_offset_noise, noise)),
    MIP_END,
};

MIP_CODEC(mip_filter_hard_iron_offset_noise, 0x0D, 0x2B, MIP_COMMAND, 0, 0, 0,
          program_hard_iron_offset_noise, &mip_program);

static const struct mip_response responses_hard_iron_offset_noise[] = {
    {NULL, 0x96, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_hard_iron_offset_noise, 0x0D, 0x2B, 0, 1, responses_hard_iron_offset_noise,
             true);

static const uint8_t program_hard_iron_offset_noise_response[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_hard_iron_offset_noise_response, noise)),
    MIP_END,
};

MIP_CODEC(mip_filter_hard_iron_offset_noise_response, 0x0D, 0x96, MIP_RESPONSE, 12, 0,
          MIP_SHAPE(0, 3, 0), program_hard_iron_offset_noise_response, NULL);

static const uint8_t program_soft_iron_matrix_noise[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_32_BITS(9, MIP_AT(struct mip_filter_soft_iron_matrix_noise, noise)),
    MIP_END,
};

MIP_CODEC(mip_filter_soft_iron_matrix_noise, 0x0D, 0x2C, MIP_COMMAND, 0, 0, 0,
          program_soft_iron_matrix_noise, &mip_program);

static const struct mip_response responses_soft_iron_matrix_noise[] = {
    {NULL, 0x97, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_soft_iron_matrix_noise, 0x0D, 0x2C, 0, 1, responses_soft_iron_matrix_noise,
             true);

static const uint8_t program_soft_iron_matrix_noise_response[] = {
    MIP_32_BITS(9, MIP_AT(struct mip_filter_soft_iron_matrix_noise_response, noise)),
    MIP_END,
};

MIP_CODEC(mip_filter_soft_iron_matrix_noise_response, 0x0D, 0x97, MIP_RESPONSE, 36, 0,
          MIP_SHAPE(0, 9, 0), program_soft_iron_matrix_noise_response, NULL);

static const uint8_t program_enable_measurements[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_enable_measurements, control)),
    MIP_END,
};

MIP_CODEC(mip_filter_enable_measurements, 0x0D, 0x41, MIP_COMMAND, 0, 0, 0,
          program_enable_measurements, &mip_program);

static const struct mip_response responses_enable_measurements[] = {
    {NULL, 0xB0, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_enable_measurements, 0x0D, 0x41, 0, 1, responses_enable_measurements, true);

static const uint8_t program_enable_measurements_response[] = {
    MIP_16_BITS(1, MIP_AT(struct mip_filter_enable_measurements_response, control)),
    MIP_END,
};

MIP_CODEC(mip_filter_enable_measurements_response, 0x0D, 0xB0, MIP_RESPONSE, 2, 0,
          MIP_SHAPE(0, 0, 1), program_enable_measurements_response, NULL);

static const uint8_t program_mag_noise[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_32_BITS(3, MIP_AT(struct mip_filter_mag_noise, noise)),
    MIP_END,
};

MIP_CODEC(mip_filter_mag_noise, 0x0D, 0x42, MIP_COMMAND, 0, 0, 0, program_mag_noise, &mip_program);

static const struct mip_response responses_mag_noise[] = {
    {NULL, 0xB1, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_mag_noise, 0x0D, 0x42, 0, 1, responses_mag_noise, true);

static const uint8_t program_mag_noise_response[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_filter_mag_noise_response, noise)),
    MIP_END,
};

MIP_CODEC(mip_filter_mag_noise_response, 0x0D, 0xB1, MIP_RESPONSE, 12, 0, MIP_SHAPE(0, 3, 0),
          program_mag_noise_response, NULL);

static const uint8_t program_magnetic_declination_source[] = {
    MIP_REQUIRED(1, 2),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_magnetic_declination_source, source)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_magnetic_declination_source, declination)),
    MIP_END,
};

MIP_CODEC(mip_filter_magnetic_declination_source, 0x0D, 0x43, MIP_COMMAND, 0, 0, 0,
          program_magnetic_declination_source, &mip_program);

static const struct mip_response responses_magnetic_declination_source[] = {
    {NULL, 0xB2, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_magnetic_declination_source, 0x0D, 0x43, 0, 1,
             responses_magnetic_declination_source, true);

static const uint8_t program_magnetic_declination_source_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_magnetic_declination_source_response, source)),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_magnetic_declination_source_response, declination)),
    MIP_END,
};

MIP_CODEC(mip_filter_magnetic_declination_source_response, 0x0D, 0xB2, MIP_RESPONSE, 5, 0, 0,
          program_magnetic_declination_source_response, NULL);

static const uint8_t program_accel_magnitude_adaptive[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_accel_magnitude_adaptive, adaptive_measurement)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_accel_magnitude_adaptive, frequency)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_accel_magnitude_adaptive, low_limit)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_accel_magnitude_adaptive, high_limit)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_accel_magnitude_adaptive, low_limit_uncertainty)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_accel_magnitude_adaptive, high_limit_uncertainty)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_accel_magnitude_adaptive, minimum_uncertainty)),
    MIP_END,
};

MIP_CODEC(mip_filter_accel_magnitude_adaptive, 0x0D, 0x44, MIP_COMMAND, 0, 0, 0,
          program_accel_magnitude_adaptive, &mip_program);

static const struct mip_response responses_accel_magnitude_adaptive[] = {
    {NULL, 0xB3, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_accel_magnitude_adaptive, 0x0D, 0x44, 0, 1,
             responses_accel_magnitude_adaptive, true);

static const uint8_t program_accel_magnitude_adaptive_response[] = {
    MIP_8_BITS(1,
               MIP_AT(struct mip_filter_accel_magnitude_adaptive_response, adaptive_measurement)),
    MIP_32_BITS(6, MIP_AT(struct mip_filter_accel_magnitude_adaptive_response, frequency)),
    MIP_END,
};

MIP_CODEC(mip_filter_accel_magnitude_adaptive_response, 0x0D, 0xB3, MIP_RESPONSE, 25, 0, 0,
          program_accel_magnitude_adaptive_response, NULL);

static const uint8_t program_mag_magnitude_adaptive[] = {
    MIP_REQUIRED(1, 7),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_mag_magnitude_adaptive, adaptive_measurement)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_mag_magnitude_adaptive, frequency)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_mag_magnitude_adaptive, low_limit)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_mag_magnitude_adaptive, high_limit)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_mag_magnitude_adaptive, low_limit_uncertainty)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_mag_magnitude_adaptive, high_limit_uncertainty)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_mag_magnitude_adaptive, minimum_uncertainty)),
    MIP_END,
};

MIP_CODEC(mip_filter_mag_magnitude_adaptive, 0x0D, 0x45, MIP_COMMAND, 0, 0, 0,
          program_mag_magnitude_adaptive, &mip_program);

static const struct mip_response responses_mag_magnitude_adaptive[] = {
    {NULL, 0xB4, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_mag_magnitude_adaptive, 0x0D, 0x45, 0, 1, responses_mag_magnitude_adaptive,
             true);

static const uint8_t program_mag_magnitude_adaptive_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_mag_magnitude_adaptive_response, adaptive_measurement)),
    MIP_32_BITS(6, MIP_AT(struct mip_filter_mag_magnitude_adaptive_response, frequency)),
    MIP_END,
};

MIP_CODEC(mip_filter_mag_magnitude_adaptive_response, 0x0D, 0xB4, MIP_RESPONSE, 25, 0, 0,
          program_mag_magnitude_adaptive_response, NULL);

static const uint8_t program_mag_dip_angle_adaptive[] = {
    MIP_REQUIRED(1, 5),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_mag_dip_angle_adaptive, enable)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_mag_dip_angle_adaptive, frequency)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_mag_dip_angle_adaptive, high_limit)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_mag_dip_angle_adaptive, high_limit_uncertainty)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_mag_dip_angle_adaptive, minimum_uncertainty)),
    MIP_END,
};

MIP_CODEC(mip_filter_mag_dip_angle_adaptive, 0x0D, 0x46, MIP_COMMAND, 0, 0, 0,
          program_mag_dip_angle_adaptive, &mip_program);

static const struct mip_response responses_mag_dip_angle_adaptive[] = {
    {NULL, 0xB5, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_mag_dip_angle_adaptive, 0x0D, 0x46, 0, 1, responses_mag_dip_angle_adaptive,
             true);

static const uint8_t program_mag_dip_angle_adaptive_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_mag_dip_angle_adaptive_response, enable)),
    MIP_32_BITS(4, MIP_AT(struct mip_filter_mag_dip_angle_adaptive_response, frequency)),
    MIP_END,
};

MIP_CODEC(mip_filter_mag_dip_angle_adaptive_response, 0x0D, 0xB5, MIP_RESPONSE, 17, 0, 0,
          program_mag_dip_angle_adaptive_response, NULL);

static const uint8_t program_altitude_aiding[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_altitude_aiding, selector)),
    MIP_END,
};

MIP_CODEC(mip_filter_altitude_aiding, 0x0D, 0x47, MIP_COMMAND, 0, 0, 0, program_altitude_aiding,
          &mip_program);

static const struct mip_response responses_altitude_aiding[] = {
    {NULL, 0xB7, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_altitude_aiding, 0x0D, 0x47, 0, 1, responses_altitude_aiding, true);

static const uint8_t program_altitude_aiding_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_altitude_aiding_response, selector)),
    MIP_END,
};

MIP_CODEC(mip_filter_altitude_aiding_response, 0x0D, 0xB7, MIP_RESPONSE, 1, 0, 0,
          program_altitude_aiding_response, NULL);

static const uint8_t program_pitch_roll_aiding[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_pitch_roll_aiding, aiding)),
    MIP_END,
};

MIP_CODEC(mip_filter_pitch_roll_aiding, 0x0D, 0x4B, MIP_COMMAND, 0, 0, 0, program_pitch_roll_aiding,
          &mip_program);

static const struct mip_response responses_pitch_roll_aiding[] = {
    {NULL, 0xBB, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_pitch_roll_aiding, 0x0D, 0x4B, 0, 1, responses_pitch_roll_aiding, true);

static const uint8_t program_pitch_roll_aiding_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_pitch_roll_aiding_response, aiding)),
    MIP_END,
};

MIP_CODEC(mip_filter_pitch_roll_aiding_response, 0x0D, 0xBB, MIP_RESPONSE, 1, 0, 0,
          program_pitch_roll_aiding_response, NULL);

static const uint8_t program_magnetic_inclination_source[] = {
    MIP_REQUIRED(1, 2),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_magnetic_inclination_source, source)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_magnetic_inclination_source, inclination)),
    MIP_END,
};

MIP_CODEC(mip_filter_magnetic_inclination_source, 0x0D, 0x4C, MIP_COMMAND, 0, 0, 0,
          program_magnetic_inclination_source, &mip_program);

static const struct mip_response responses_magnetic_inclination_source[] = {
    {NULL, 0xBC, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_magnetic_inclination_source, 0x0D, 0x4C, 0, 1,
             responses_magnetic_inclination_source, true);

static const uint8_t program_magnetic_inclination_source_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_magnetic_inclination_source_response, source)),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_magnetic_inclination_source_response, inclination)),
    MIP_END,
};

MIP_CODEC(mip_filter_magnetic_inclination_source_response, 0x0D, 0xBC, MIP_RESPONSE, 5, 0, 0,
          program_magnetic_inclination_source_response, NULL);

static const uint8_t program_magnetic_magnitude_source[] = {
    MIP_REQUIRED(1, 2),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_magnetic_magnitude_source, source)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_magnetic_magnitude_source, magnitude)),
    MIP_END,
};

MIP_CODEC(mip_filter_magnetic_magnitude_source, 0x0D, 0x4D, MIP_COMMAND, 0, 0, 0,
          program_magnetic_magnitude_source, &mip_program);

static const struct mip_response responses_magnetic_magnitude_source[] = {
    {NULL, 0xBD, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_magnetic_magnitude_source, 0x0D, 0x4D, 0, 1,
             responses_magnetic_magnitude_source, true);

static const uint8_t program_magnetic_magnitude_source_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_magnetic_magnitude_source_response, source)),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_magnetic_magnitude_source_response, magnitude)),
    MIP_END,
};

MIP_CODEC(mip_filter_magnetic_magnitude_source_response, 0x0D, 0xBD, MIP_RESPONSE, 5, 0, 0,
          program_magnetic_magnitude_source_response, NULL);

static const uint8_t program_sensor_to_vehicle_rotation_dcm[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_32_BITS(9, MIP_AT(struct mip_filter_sensor_to_vehicle_rotation_dcm, dcm)),
    MIP_END,
};

MIP_CODEC(mip_filter_sensor_to_vehicle_rotation_dcm, 0x0D, 0x4E, MIP_COMMAND, 0, 0, 0,
          program_sensor_to_vehicle_rotation_dcm, &mip_program);

static const struct mip_response responses_sensor_to_vehicle_rotation_dcm[] = {
    {NULL, 0xBE, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_sensor_to_vehicle_rotation_dcm, 0x0D, 0x4E, 0, 1,
             responses_sensor_to_vehicle_rotation_dcm, true);

static const uint8_t program_sensor_to_vehicle_rotation_dcm_response[] = {
    MIP_32_BITS(9, MIP_AT(struct mip_filter_sensor_to_vehicle_rotation_dcm_response, dcm)),
    MIP_END,
};

MIP_CODEC(mip_filter_sensor_to_vehicle_rotation_dcm_response, 0x0D, 0xBE, MIP_RESPONSE, 36, 0,
          MIP_SHAPE(0, 9, 0), program_sensor_to_vehicle_rotation_dcm_response, NULL);

static const uint8_t program_sensor_to_vehicle_quaternion[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_32_BITS(4, MIP_AT(struct mip_filter_sensor_to_vehicle_quaternion, q)),
    MIP_END,
};

MIP_CODEC(mip_filter_sensor_to_vehicle_quaternion, 0x0D, 0x4F, MIP_COMMAND, 0, 0, 0,
          program_sensor_to_vehicle_quaternion, &mip_program);

static const struct mip_response responses_sensor_to_vehicle_quaternion[] = {
    {NULL, 0xBF, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_sensor_to_vehicle_quaternion, 0x0D, 0x4F, 0, 1,
             responses_sensor_to_vehicle_quaternion, true);

static const uint8_t program_sensor_to_vehicle_quaternion_response[] = {
    MIP_32_BITS(4, MIP_AT(struct mip_filter_sensor_to_vehicle_quaternion_response, q)),
    MIP_END,
};

MIP_CODEC(mip_filter_sensor_to_vehicle_quaternion_response, 0x0D, 0xBF, MIP_RESPONSE, 16, 0,
          MIP_SHAPE(0, 4, 0), program_sensor_to_vehicle_quaternion_response, NULL);

static const uint8_t program_aiding_measurement_enable[] = {
    MIP_REQUIRED(5, 2, 1, 1, 1, 1),
    MIP_GROUP(1),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_aiding_measurement_enable, aiding_source)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_aiding_measurement_enable, enable)),
    MIP_END,
};

MIP_CODEC(mip_filter_aiding_measurement_enable, 0x0D, 0x50, MIP_COMMAND, 0, 0, 0,
          program_aiding_measurement_enable, &mip_program);

static const struct mip_response responses_aiding_measurement_enable[] = {
    {NULL, 0xD0, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_aiding_measurement_enable, 0x0D, 0x50, 0, 1,
             responses_aiding_measurement_enable, true);

static const uint8_t program_aiding_measurement_enable_response[] = {
    MIP_16_BITS(1, MIP_AT(struct mip_filter_aiding_measurement_enable_response, aiding_source)),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_aiding_measurement_enable_response, enable)),
    MIP_END,
};

MIP_CODEC(mip_filter_aiding_measurement_enable_response, 0x0D, 0xD0, MIP_RESPONSE, 3, 0, 0,
          program_aiding_measurement_enable_response, NULL);

static const uint8_t program_kinematic_constraint[] = {
    MIP_REQUIRED(1, 3),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_kinematic_constraint, accel_constraint)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_kinematic_constraint, velocity_constraint)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_kinematic_constraint, angular_constraint)),
    MIP_END,
};

MIP_CODEC(mip_filter_kinematic_constraint, 0x0D, 0x51, MIP_COMMAND, 0, 0, 0,
          program_kinematic_constraint, &mip_program);

static const struct mip_response responses_kinematic_constraint[] = {
    {NULL, 0xD1, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_kinematic_constraint, 0x0D, 0x51, 0, 1, responses_kinematic_constraint,
             true);

static const uint8_t program_kinematic_constraint_response[] = {
    MIP_8_BITS(3, MIP_AT(struct mip_filter_kinematic_constraint_response, accel_constraint)),
    MIP_END,
};

MIP_CODEC(mip_filter_kinematic_constraint_response, 0x0D, 0xD1, MIP_RESPONSE, 3, 0, 0,
          program_kinematic_constraint_response, NULL);

static const uint8_t program_initialization_config[] = {
    MIP_REQUIRED(1, 9),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_initialization_config, wait_for_run_command)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_initialization_config, initial_condition_source)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_initialization_config, auto_heading_alignment_selector)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_initialization_config, initial_heading)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_initialization_config, initial_pitch)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_initialization_config, initial_roll)),
    MIP_GROUP(1),
    MIP_32_BITS(3, MIP_AT(struct mip_filter_initialization_config, initial_position)),
    MIP_GROUP(1),
    MIP_32_BITS(3, MIP_AT(struct mip_filter_initialization_config, initial_velocity)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_initialization_config, reference_frame_selector)),
    MIP_END,
};

MIP_CODEC(mip_filter_initialization_config, 0x0D, 0x52, MIP_COMMAND, 0, 0, 0,
          program_initialization_config, &mip_program);

static const struct mip_response responses_initialization_config[] = {
    {NULL, 0xD2, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_initialization_config, 0x0D, 0x52, 0, 1, responses_initialization_config,
             true);

static const uint8_t program_initialization_config_response[] = {
    MIP_8_BITS(3, MIP_AT(struct mip_filter_initialization_config_response, wait_for_run_command)),
    MIP_32_BITS(9, MIP_AT(struct mip_filter_initialization_config_response, initial_heading)),
    MIP_8_BITS(1,
               MIP_AT(struct mip_filter_initialization_config_response, reference_frame_selector)),
    MIP_END,
};

MIP_CODEC(mip_filter_initialization_config_response, 0x0D, 0xD2, MIP_RESPONSE, 40, 0, 0,
          program_initialization_config_response, NULL);

static const uint8_t program_adaptive_filter_options[] = {
    MIP_REQUIRED(1, 2),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_adaptive_filter_options, level)),
    MIP_GROUP(1),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_adaptive_filter_options, time_limit)),
    MIP_END,
};

MIP_CODEC(mip_filter_adaptive_filter_options, 0x0D, 0x53, MIP_COMMAND, 0, 0, 0,
          program_adaptive_filter_options, &mip_program);

static const struct mip_response responses_adaptive_filter_options[] = {
    {NULL, 0xD3, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_adaptive_filter_options, 0x0D, 0x53, 0, 1,
             responses_adaptive_filter_options, true);

static const uint8_t program_adaptive_filter_options_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_adaptive_filter_options_response, level)),
    MIP_16_BITS(1, MIP_AT(struct mip_filter_adaptive_filter_options_response, time_limit)),
    MIP_END,
};

MIP_CODEC(mip_filter_adaptive_filter_options_response, 0x0D, 0xD3, MIP_RESPONSE, 3, 0, 0,
          program_adaptive_filter_options_response, NULL);

static const uint8_t program_multi_antenna_offset[] = {
    MIP_REQUIRED(5, 2, 1, 1, 1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_multi_antenna_offset, receiver_id)),
    MIP_GROUP(1),
    MIP_32_BITS(3, MIP_AT(struct mip_filter_multi_antenna_offset, antenna_offset)),
    MIP_END,
};

MIP_CODEC(mip_filter_multi_antenna_offset, 0x0D, 0x54, MIP_COMMAND, 0, 0, 0,
          program_multi_antenna_offset, &mip_program);

static const struct mip_response responses_multi_antenna_offset[] = {
    {NULL, 0xD4, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_multi_antenna_offset, 0x0D, 0x54, 0, 1, responses_multi_antenna_offset,
             true);

static const uint8_t program_multi_antenna_offset_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_multi_antenna_offset_response, receiver_id)),
    MIP_32_BITS(3, MIP_AT(struct mip_filter_multi_antenna_offset_response, antenna_offset)),
    MIP_END,
};

MIP_CODEC(mip_filter_multi_antenna_offset_response, 0x0D, 0xD4, MIP_RESPONSE, 13, 0, 0,
          program_multi_antenna_offset_response, NULL);

static const uint8_t program_relative_position_config[] = {
    MIP_REQUIRED(1, 3),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_relative_position_config, source)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_relative_position_config, reference_frame_selector)),
    MIP_GROUP(1),
    MIP_DOUBLES(3, MIP_AT(struct mip_filter_relative_position_config, reference_coordinates)),
    MIP_END,
};

MIP_CODEC(mip_filter_relative_position_config, 0x0D, 0x55, MIP_COMMAND, 0, 0, 0,
          program_relative_position_config, &mip_program);

static const struct mip_response responses_relative_position_config[] = {
    {NULL, 0xD5, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_relative_position_config, 0x0D, 0x55, 0, 1,
             responses_relative_position_config, true);

static const uint8_t program_relative_position_config_response[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_filter_relative_position_config_response, source)),
    MIP_DOUBLES(3,
                MIP_AT(struct mip_filter_relative_position_config_response, reference_coordinates)),
    MIP_END,
};

MIP_CODEC(mip_filter_relative_position_config_response, 0x0D, 0xD5, MIP_RESPONSE, 26, 0, 0,
          program_relative_position_config_response, NULL);

static const uint8_t program_reference_point_lever_arm[] = {
    MIP_REQUIRED(1, 2),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_reference_point_lever_arm, reference_point)),
    MIP_GROUP(1),
    MIP_32_BITS(3, MIP_AT(struct mip_filter_reference_point_lever_arm, lever_arm_offset)),
    MIP_END,
};

MIP_CODEC(mip_filter_reference_point_lever_arm, 0x0D, 0x56, MIP_COMMAND, 0, 0, 0,
          program_reference_point_lever_arm, &mip_program);

static const struct mip_response responses_reference_point_lever_arm[] = {
    {NULL, 0xD6, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_reference_point_lever_arm, 0x0D, 0x56, 0, 1,
             responses_reference_point_lever_arm, true);

static const uint8_t program_reference_point_lever_arm_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_reference_point_lever_arm_response, reference_point)),
    MIP_32_BITS(3, MIP_AT(struct mip_filter_reference_point_lever_arm_response, lever_arm_offset)),
    MIP_END,
};

MIP_CODEC(mip_filter_reference_point_lever_arm_response, 0x0D, 0xD6, MIP_RESPONSE, 13, 0, 0,
          program_reference_point_lever_arm_response, NULL);

static const uint8_t program_speed_measurement[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_speed_measurement, source)),
    MIP_32_BITS(3, MIP_AT(struct mip_filter_speed_measurement, tow)),
    MIP_END,
};

MIP_CODEC(mip_filter_speed_measurement, 0x0D, 0x60, MIP_COMMAND, 13, 0, 0,
          program_speed_measurement, NULL);

MIP_EXCHANGE(mip_filter_speed_measurement, 0x0D, 0x60, 0, 0, NULL, false);

static const uint8_t program_speed_lever_arm[] = {
    MIP_REQUIRED(5, 2, 1, 1, 1, 1),
    MIP_GROUP(1),
    MIP_RESERVED,
    MIP_8_BITS(1, MIP_AT(struct mip_filter_speed_lever_arm, source)),
    MIP_GROUP(1),
    MIP_32_BITS(3, MIP_AT(struct mip_filter_speed_lever_arm, lever_arm_offset)),
    MIP_END,
};

MIP_CODEC(mip_filter_speed_lever_arm, 0x0D, 0x61, MIP_COMMAND, 0, 0, 0, program_speed_lever_arm,
          &mip_program);

static const struct mip_response responses_speed_lever_arm[] = {
    {NULL, 0xE1, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_speed_lever_arm, 0x0D, 0x61, 0, 1, responses_speed_lever_arm, true);

static const uint8_t program_speed_lever_arm_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_speed_lever_arm_response, source)),
    MIP_32_BITS(3, MIP_AT(struct mip_filter_speed_lever_arm_response, lever_arm_offset)),
    MIP_END,
};

MIP_CODEC(mip_filter_speed_lever_arm_response, 0x0D, 0xE1, MIP_RESPONSE, 13, 0, 0,
          program_speed_lever_arm_response, NULL);

static const uint8_t program_vertical_gyro_constraint_control[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_vertical_gyro_constraint_control, enable)),
    MIP_END,
};

MIP_CODEC(mip_filter_vertical_gyro_constraint_control, 0x0D, 0x62, MIP_COMMAND, 0, 0, 0,
          program_vertical_gyro_constraint_control, &mip_program);

static const struct mip_response responses_vertical_gyro_constraint_control[] = {
    {NULL, 0xE2, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_vertical_gyro_constraint_control, 0x0D, 0x62, 0, 1,
             responses_vertical_gyro_constraint_control, true);

static const uint8_t program_vertical_gyro_constraint_control_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_vertical_gyro_constraint_control_response, enable)),
    MIP_END,
};

MIP_CODEC(mip_filter_vertical_gyro_constraint_control_response, 0x0D, 0xE2, MIP_RESPONSE, 1, 0, 0,
          program_vertical_gyro_constraint_control_response, NULL);

static const uint8_t program_wheeled_vehicle_constraint_control[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_wheeled_vehicle_constraint_control, enable)),
    MIP_END,
};

MIP_CODEC(mip_filter_wheeled_vehicle_constraint_control, 0x0D, 0x63, MIP_COMMAND, 0, 0, 0,
          program_wheeled_vehicle_constraint_control, &mip_program);

static const struct mip_response responses_wheeled_vehicle_constraint_control[] = {
    {NULL, 0xE3, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_wheeled_vehicle_constraint_control, 0x0D, 0x63, 0, 1,
             responses_wheeled_vehicle_constraint_control, true);

static const uint8_t program_wheeled_vehicle_constraint_control_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_wheeled_vehicle_constraint_control_response, enable)),
    MIP_END,
};

MIP_CODEC(mip_filter_wheeled_vehicle_constraint_control_response, 0x0D, 0xE3, MIP_RESPONSE, 1, 0, 0,
          program_wheeled_vehicle_constraint_control_response, NULL);

static const uint8_t program_gnss_antenna_calibration_control[] = {
    MIP_REQUIRED(1, 2),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_filter_gnss_antenna_calibration_control, enable)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_gnss_antenna_calibration_control, max_offset)),
    MIP_END,
};

MIP_CODEC(mip_filter_gnss_antenna_calibration_control, 0x0D, 0x64, MIP_COMMAND, 0, 0, 0,
          program_gnss_antenna_calibration_control, &mip_program);

static const struct mip_response responses_gnss_antenna_calibration_control[] = {
    {NULL, 0xE4, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_filter_gnss_antenna_calibration_control, 0x0D, 0x64, 0, 1,
             responses_gnss_antenna_calibration_control, true);

static const uint8_t program_gnss_antenna_calibration_control_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_filter_gnss_antenna_calibration_control_response, enable)),
    MIP_32_BITS(1, MIP_AT(struct mip_filter_gnss_antenna_calibration_control_response, max_offset)),
    MIP_END,
};

MIP_CODEC(mip_filter_gnss_antenna_calibration_control_response, 0x0D, 0xE4, MIP_RESPONSE, 5, 0, 0,
          program_gnss_antenna_calibration_control_response, NULL);
