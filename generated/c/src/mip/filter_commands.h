/**
 * @file
 * The commands of Filter commands, each with the types of its parameters and of its response.
 */
#ifndef MIP_FILTER_COMMANDS_H
#define MIP_FILTER_COMMANDS_H

#include "mip/filter.h"
#include "mip/client.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/filter_commands.h and mip/constants.h are not of one version"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_reset_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Reset navigation
 * filter.
 */
static inline mip_error mip_send_filter_reset(struct mip_client *client,
                                              struct mip_request *request,
                                              struct mip_builder *packet, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_reset_command, NULL, NULL, NULL,
                           now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_set_initial_attitude_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Set initial attitude.
 */
static inline mip_error mip_send_filter_set_initial_attitude(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_set_initial_attitude *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_set_initial_attitude_command,
                           command, NULL, NULL, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_set_initial_heading_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Set initial heading.
 */
static inline mip_error mip_send_filter_set_initial_heading(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_set_initial_heading *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_set_initial_heading_command,
                           command, NULL, NULL, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_run_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Run navigation
 * filter.
 */
static inline mip_error mip_send_filter_run(struct mip_client *client, struct mip_request *request,
                                            struct mip_builder *packet, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_run_command, NULL, NULL, NULL, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_vehicle_dynamics_mode_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Vehicle dynamics
 * mode. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_vehicle_dynamics_mode(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_vehicle_dynamics_mode *command,
    struct mip_filter_vehicle_dynamics_mode_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_vehicle_dynamics_mode_command,
                           command, &mip_filter_vehicle_dynamics_mode_response_codec, response,
                           now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_sensor_to_vehicle_euler_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Sensor to vehicle
 * frame transformation. The response goes to `response`, which may be NULL, if the command asks for
 * it.
 */
static inline mip_error mip_send_filter_sensor_to_vehicle_euler(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_sensor_to_vehicle_euler *command,
    struct mip_filter_sensor_to_vehicle_euler_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_sensor_to_vehicle_euler_command,
                           command, &mip_filter_sensor_to_vehicle_euler_response_codec, response,
                           now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_sensor_to_vehicle_offset_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Sensor to vehicle
 * offset. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_sensor_to_vehicle_offset(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_sensor_to_vehicle_offset *command,
    struct mip_filter_sensor_to_vehicle_offset_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_sensor_to_vehicle_offset_command,
                           command, &mip_filter_sensor_to_vehicle_offset_response_codec, response,
                           now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_antenna_offset_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. GNSS antenna offset.
 * The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_antenna_offset(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_antenna_offset *command,
    struct mip_filter_antenna_offset_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_antenna_offset_command, command,
                           &mip_filter_antenna_offset_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_estimation_control_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Estimation control
 * flags. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_estimation_control(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_estimation_control *command,
    struct mip_filter_estimation_control_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_estimation_control_command, command,
                           &mip_filter_estimation_control_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_gnss_source_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. GNSS aiding source.
 * The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_gnss_source(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_gnss_source *command, struct mip_filter_gnss_source_response *response,
    uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_gnss_source_command, command,
                           &mip_filter_gnss_source_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_external_gnss_update_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. External GNSS update.
 */
static inline mip_error mip_send_filter_external_gnss_update(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_external_gnss_update *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_external_gnss_update_command,
                           command, NULL, NULL, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_external_heading_update_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. External heading
 * update.
 */
static inline mip_error mip_send_filter_external_heading_update(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_external_heading_update *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_external_heading_update_command,
                           command, NULL, NULL, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_heading_source_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Heading update
 * control. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_heading_source(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_heading_source *command,
    struct mip_filter_heading_source_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_heading_source_command, command,
                           &mip_filter_heading_source_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_auto_initialization_control_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Automatic
 * initialization. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_auto_initialization_control(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_auto_initialization_control *command,
    struct mip_filter_auto_initialization_control_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_auto_initialization_control_command,
                           command, &mip_filter_auto_initialization_control_response_codec,
                           response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_accel_noise_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Accelerometer noise.
 * The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_accel_noise(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_accel_noise *command, struct mip_filter_accel_noise_response *response,
    uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_accel_noise_command, command,
                           &mip_filter_accel_noise_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_gyro_noise_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Gyroscope noise. The
 * response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_gyro_noise(struct mip_client *client,
                                                   struct mip_request *request,
                                                   struct mip_builder *packet,
                                                   const struct mip_filter_gyro_noise *command,
                                                   struct mip_filter_gyro_noise_response *response,
                                                   uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_gyro_noise_command, command,
                           &mip_filter_gyro_noise_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_accel_bias_model_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Accelerometer bias
 * model. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_accel_bias_model(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_accel_bias_model *command,
    struct mip_filter_accel_bias_model_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_accel_bias_model_command, command,
                           &mip_filter_accel_bias_model_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_gyro_bias_model_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Gyroscope bias model.
 * The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_gyro_bias_model(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_gyro_bias_model *command,
    struct mip_filter_gyro_bias_model_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_gyro_bias_model_command, command,
                           &mip_filter_gyro_bias_model_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_auto_zupt_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Automatic zero
 * velocity update. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_auto_zupt(struct mip_client *client,
                                                  struct mip_request *request,
                                                  struct mip_builder *packet,
                                                  const struct mip_filter_auto_zupt *command,
                                                  struct mip_filter_auto_zupt_response *response,
                                                  uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_auto_zupt_command, command,
                           &mip_filter_auto_zupt_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_external_heading_update_with_time_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. External heading
 * update with time.
 */
static inline mip_error mip_send_filter_external_heading_update_with_time(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_external_heading_update_with_time *command, uint32_t now) {
    return mip_client_send(client, request, packet,
                           &mip_filter_external_heading_update_with_time_command, command, NULL,
                           NULL, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_auto_angular_zupt_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Zero angular rate
 * update. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_auto_angular_zupt(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_auto_angular_zupt *command,
    struct mip_filter_auto_angular_zupt_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_auto_angular_zupt_command, command,
                           &mip_filter_auto_angular_zupt_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_tare_orientation_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Tare orientation. The
 * response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_tare_orientation(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_tare_orientation *command,
    struct mip_filter_tare_orientation_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_tare_orientation_command, command,
                           &mip_filter_tare_orientation_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_commanded_zupt_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Commanded zero
 * velocity update.
 */
static inline mip_error mip_send_filter_commanded_zupt(struct mip_client *client,
                                                       struct mip_request *request,
                                                       struct mip_builder *packet, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_commanded_zupt_command, NULL, NULL,
                           NULL, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_commanded_angular_zupt_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Commanded zero
 * angular rate update.
 */
static inline mip_error mip_send_filter_commanded_angular_zupt(struct mip_client *client,
                                                               struct mip_request *request,
                                                               struct mip_builder *packet,
                                                               uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_commanded_angular_zupt_command,
                           NULL, NULL, NULL, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_reference_position_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Set reference
 * position. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_reference_position(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_reference_position *command,
    struct mip_filter_reference_position_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_reference_position_command, command,
                           &mip_filter_reference_position_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_mag_capture_auto_calibration_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Capture automatic
 * magnetometer calibration.
 */
static inline mip_error mip_send_filter_mag_capture_auto_calibration(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_mag_capture_auto_calibration *command, uint32_t now) {
    return mip_client_send(client, request, packet,
                           &mip_filter_mag_capture_auto_calibration_command, command, NULL, NULL,
                           now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_gravity_noise_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Gravity noise. The
 * response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_gravity_noise(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_gravity_noise *command,
    struct mip_filter_gravity_noise_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_gravity_noise_command, command,
                           &mip_filter_gravity_noise_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_pressure_altitude_noise_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Pressure altitude
 * noise. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_pressure_altitude_noise(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_pressure_altitude_noise *command,
    struct mip_filter_pressure_altitude_noise_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_pressure_altitude_noise_command,
                           command, &mip_filter_pressure_altitude_noise_response_codec, response,
                           now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_hard_iron_offset_noise_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Hard iron offset
 * noise. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_hard_iron_offset_noise(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_hard_iron_offset_noise *command,
    struct mip_filter_hard_iron_offset_noise_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_hard_iron_offset_noise_command,
                           command, &mip_filter_hard_iron_offset_noise_response_codec, response,
                           now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_soft_iron_matrix_noise_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Soft iron matrix
 * noise. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_soft_iron_matrix_noise(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_soft_iron_matrix_noise *command,
    struct mip_filter_soft_iron_matrix_noise_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_soft_iron_matrix_noise_command,
                           command, &mip_filter_soft_iron_matrix_noise_response_codec, response,
                           now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_enable_measurements_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Enable or disable
 * measurements. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_enable_measurements(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_enable_measurements *command,
    struct mip_filter_enable_measurements_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_enable_measurements_command,
                           command, &mip_filter_enable_measurements_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_mag_noise_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Magnetometer noise.
 * The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_mag_noise(struct mip_client *client,
                                                  struct mip_request *request,
                                                  struct mip_builder *packet,
                                                  const struct mip_filter_mag_noise *command,
                                                  struct mip_filter_mag_noise_response *response,
                                                  uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_mag_noise_command, command,
                           &mip_filter_mag_noise_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_magnetic_declination_source_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Magnetic declination
 * source. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_magnetic_declination_source(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_magnetic_declination_source *command,
    struct mip_filter_magnetic_declination_source_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_magnetic_declination_source_command,
                           command, &mip_filter_magnetic_declination_source_response_codec,
                           response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_accel_magnitude_adaptive_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Gravity magnitude
 * error adaptive measurement. The response goes to `response`, which may be NULL, if the command
 * asks for it.
 */
static inline mip_error mip_send_filter_accel_magnitude_adaptive(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_accel_magnitude_adaptive *command,
    struct mip_filter_accel_magnitude_adaptive_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_accel_magnitude_adaptive_command,
                           command, &mip_filter_accel_magnitude_adaptive_response_codec, response,
                           now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_mag_magnitude_adaptive_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Magnetometer
 * magnitude error adaptive measurement. The response goes to `response`, which may be NULL, if the
 * command asks for it.
 */
static inline mip_error mip_send_filter_mag_magnitude_adaptive(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_mag_magnitude_adaptive *command,
    struct mip_filter_mag_magnitude_adaptive_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_mag_magnitude_adaptive_command,
                           command, &mip_filter_mag_magnitude_adaptive_response_codec, response,
                           now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_mag_dip_angle_adaptive_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Magnetometer dip
 * angle error adaptive measurement. The response goes to `response`, which may be NULL, if the
 * command asks for it.
 */
static inline mip_error mip_send_filter_mag_dip_angle_adaptive(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_mag_dip_angle_adaptive *command,
    struct mip_filter_mag_dip_angle_adaptive_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_mag_dip_angle_adaptive_command,
                           command, &mip_filter_mag_dip_angle_adaptive_response_codec, response,
                           now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_altitude_aiding_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Altitude aiding. The
 * response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_altitude_aiding(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_altitude_aiding *command,
    struct mip_filter_altitude_aiding_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_altitude_aiding_command, command,
                           &mip_filter_altitude_aiding_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_pitch_roll_aiding_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Pitch and roll
 * aiding. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_pitch_roll_aiding(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_pitch_roll_aiding *command,
    struct mip_filter_pitch_roll_aiding_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_pitch_roll_aiding_command, command,
                           &mip_filter_pitch_roll_aiding_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_magnetic_inclination_source_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Magnetic inclination
 * source. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_magnetic_inclination_source(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_magnetic_inclination_source *command,
    struct mip_filter_magnetic_inclination_source_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_magnetic_inclination_source_command,
                           command, &mip_filter_magnetic_inclination_source_response_codec,
                           response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_magnetic_magnitude_source_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Magnetic field
 * magnitude source. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_magnetic_magnitude_source(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_magnetic_magnitude_source *command,
    struct mip_filter_magnetic_magnitude_source_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_magnetic_magnitude_source_command,
                           command, &mip_filter_magnetic_magnitude_source_response_codec, response,
                           now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_sensor_to_vehicle_dcm_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Sensor to vehicle
 * rotation, matrix. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_sensor_to_vehicle_dcm(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_sensor_to_vehicle_dcm *command,
    struct mip_filter_sensor_to_vehicle_dcm_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_sensor_to_vehicle_dcm_command,
                           command, &mip_filter_sensor_to_vehicle_dcm_response_codec, response,
                           now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_sensor_to_vehicle_quaternion_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Sensor to vehicle
 * rotation, quaternion. The response goes to `response`, which may be NULL, if the command asks for
 * it.
 */
static inline mip_error mip_send_filter_sensor_to_vehicle_quaternion(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_sensor_to_vehicle_quaternion *command,
    struct mip_filter_sensor_to_vehicle_quaternion_response *response, uint32_t now) {
    return mip_client_send(client, request, packet,
                           &mip_filter_sensor_to_vehicle_quaternion_command, command,
                           &mip_filter_sensor_to_vehicle_quaternion_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_aiding_measurement_enable_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Aiding measurement
 * control. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_aiding_measurement_enable(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_aiding_measurement_enable *command,
    struct mip_filter_aiding_measurement_enable_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_aiding_measurement_enable_command,
                           command, &mip_filter_aiding_measurement_enable_response_codec, response,
                           now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_kinematic_constraint_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Kinematic constraint.
 * The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_kinematic_constraint(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_kinematic_constraint *command,
    struct mip_filter_kinematic_constraint_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_kinematic_constraint_command,
                           command, &mip_filter_kinematic_constraint_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_initialization_config_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Navigation filter
 * initialization. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_initialization_config(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_initialization_config *command,
    struct mip_filter_initialization_config_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_initialization_config_command,
                           command, &mip_filter_initialization_config_response_codec, response,
                           now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_adaptive_filter_options_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Adaptive filter
 * control. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_adaptive_filter_options(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_adaptive_filter_options *command,
    struct mip_filter_adaptive_filter_options_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_adaptive_filter_options_command,
                           command, &mip_filter_adaptive_filter_options_response_codec, response,
                           now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_multi_antenna_offset_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. GNSS multi-antenna
 * offset. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_multi_antenna_offset(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_multi_antenna_offset *command,
    struct mip_filter_multi_antenna_offset_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_multi_antenna_offset_command,
                           command, &mip_filter_multi_antenna_offset_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_relative_position_config_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Relative position
 * configuration. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_relative_position_config(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_relative_position_config *command,
    struct mip_filter_relative_position_config_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_relative_position_config_command,
                           command, &mip_filter_relative_position_config_response_codec, response,
                           now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_reference_point_lever_arm_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Reference point lever
 * arm. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_reference_point_lever_arm(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_reference_point_lever_arm *command,
    struct mip_filter_reference_point_lever_arm_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_reference_point_lever_arm_command,
                           command, &mip_filter_reference_point_lever_arm_response_codec, response,
                           now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_speed_measurement_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Speed measurement.
 */
static inline mip_error mip_send_filter_speed_measurement(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_speed_measurement *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_speed_measurement_command, command,
                           NULL, NULL, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_speed_lever_arm_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Speed measurement
 * lever arm. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_speed_lever_arm(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_speed_lever_arm *command,
    struct mip_filter_speed_lever_arm_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_speed_lever_arm_command, command,
                           &mip_filter_speed_lever_arm_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_vertical_gyro_constraint_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Vertical gyro
 * constraint. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_vertical_gyro_constraint(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_vertical_gyro_constraint *command,
    struct mip_filter_vertical_gyro_constraint_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_vertical_gyro_constraint_command,
                           command, &mip_filter_vertical_gyro_constraint_response_codec, response,
                           now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_wheeled_vehicle_constraint_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Wheeled vehicle
 * constraint. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_wheeled_vehicle_constraint(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_wheeled_vehicle_constraint *command,
    struct mip_filter_wheeled_vehicle_constraint_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_wheeled_vehicle_constraint_command,
                           command, &mip_filter_wheeled_vehicle_constraint_response_codec, response,
                           now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_filter_gnss_antenna_calibration_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. GNSS antenna offset
 * calibration. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_filter_gnss_antenna_calibration(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_gnss_antenna_calibration *command,
    struct mip_filter_gnss_antenna_calibration_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_gnss_antenna_calibration_command,
                           command, &mip_filter_gnss_antenna_calibration_response_codec, response,
                           now);
}

#ifdef __cplusplus
}
#endif

#endif
