/**
 * @file
 * The commands of Filter commands, each with the types of its parameters and of its response.
 */
#ifndef MIP_FILTER_COMMANDS_H
#define MIP_FILTER_COMMANDS_H

#include "mip/filter.h"
#include "mip/device.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/filter_commands.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_filter Filter commands (0x0D)
 * @{ */

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_reset_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_reset_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Reset navigation filter.
 */
static inline mip_error mip_send_filter_reset(struct mip_client *client,
                                              struct mip_request *request,
                                              struct mip_builder *packet, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_reset_command, NULL, NULL, NULL,
                           now);
}

/** Reset navigation filter. See mip_device_call. */
static inline struct mip_result mip_call_filter_reset(struct mip_device *device) {
    return mip_device_send(device, &mip_filter_reset_exchange,
                           MIP_NO_DATA(mip_filter_reset_exchange), 0);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_set_initial_attitude_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_set_initial_attitude_exchange;

/** Adds the command to a packet and tracks its reply: see mip_client_send. Set initial attitude. */
static inline mip_error mip_send_filter_set_initial_attitude(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_set_initial_attitude *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_set_initial_attitude_command,
                           command, NULL, NULL, now);
}

/**
 * Set initial attitude. See mip_device_call.
 *
 * - roll: Roll angle. Unit: rad. Frame: ned. Range: -3.141592653589793 to 3.141592653589793.
 *   Positive: right side down.
 * - pitch: Pitch angle. Unit: rad. Frame: ned. Range: -1.5707963267948966 to 1.5707963267948966.
 *   Positive: nose up.
 * - heading: Heading (yaw) angle. Unit: rad. Frame: ned. Range: -3.141592653589793 to
 *   3.141592653589793. Positive: clockwise seen from above.
 */
static inline struct mip_result mip_call_filter_set_initial_attitude(struct mip_device *device,
                                                                     float roll, float pitch,
                                                                     float heading) {
    uint8_t data[12];
    mip_put_float(data, &roll);
    mip_put_float(data + 4, &pitch);
    mip_put_float(data + 8, &heading);
    return mip_device_send(device, &mip_filter_set_initial_attitude_exchange, data, 12);
}

/**
 * Set initial attitude: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_set_initial_attitude_with(
    struct mip_device *device, const struct mip_filter_set_initial_attitude *command) {
    return mip_device_call(device, &mip_filter_set_initial_attitude_command, command, NULL, NULL);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_set_initial_heading_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_set_initial_heading_exchange;

/** Adds the command to a packet and tracks its reply: see mip_client_send. Set initial heading. */
static inline mip_error mip_send_filter_set_initial_heading(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_set_initial_heading *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_set_initial_heading_command,
                           command, NULL, NULL, now);
}

/**
 * Set initial heading. See mip_device_call.
 *
 * - heading: Initial heading. Unit: rad. Frame: ned. Range: -3.141592653589793 to
 *   3.141592653589793. Positive: clockwise seen from above.
 */
static inline struct mip_result mip_call_filter_set_initial_heading(struct mip_device *device,
                                                                    float heading) {
    uint8_t data[4];
    mip_put_float(data, &heading);
    return mip_device_send(device, &mip_filter_set_initial_heading_exchange, data, 4);
}

/**
 * Set initial heading: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_set_initial_heading_with(
    struct mip_device *device, const struct mip_filter_set_initial_heading *command) {
    return mip_device_call(device, &mip_filter_set_initial_heading_command, command, NULL, NULL);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_set_initial_attitude_from_imu_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_set_initial_attitude_from_imu_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Set initial attitude from
 * IMU.
 */
static inline mip_error mip_send_filter_set_initial_attitude_from_imu(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_set_initial_attitude_from_imu *command, uint32_t now) {
    return mip_client_send(client, request, packet,
                           &mip_filter_set_initial_attitude_from_imu_command, command, NULL, NULL,
                           now);
}

/**
 * Set initial attitude from IMU. See mip_device_call.
 *
 * - declination: Local declination of the magnetic field. Unit: rad. Range: -3.141592653589793 to
 *   3.141592653589793.
 */
static inline struct mip_result
mip_call_filter_set_initial_attitude_from_imu(struct mip_device *device, float declination) {
    uint8_t data[4];
    mip_put_float(data, &declination);
    return mip_device_send(device, &mip_filter_set_initial_attitude_from_imu_exchange, data, 4);
}

/**
 * Set initial attitude from IMU: calls the command with these values, including optional
 * parameters. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_set_initial_attitude_from_imu_with(
    struct mip_device *device, const struct mip_filter_set_initial_attitude_from_imu *command) {
    return mip_device_call(device, &mip_filter_set_initial_attitude_from_imu_command, command, NULL,
                           NULL);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_run_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_run_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Run navigation filter.
 */
static inline mip_error mip_send_filter_run(struct mip_client *client, struct mip_request *request,
                                            struct mip_builder *packet, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_run_command, NULL, NULL, NULL, now);
}

/** Run navigation filter. See mip_device_call. */
static inline struct mip_result mip_call_filter_run(struct mip_device *device) {
    return mip_device_send(device, &mip_filter_run_exchange, MIP_NO_DATA(mip_filter_run_exchange),
                           0);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_vehicle_dynamics_mode_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_vehicle_dynamics_mode_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Vehicle dynamics mode. If
 * the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_vehicle_dynamics_mode(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_vehicle_dynamics_mode *command,
    struct mip_filter_vehicle_dynamics_mode_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_vehicle_dynamics_mode_command,
                           command, &mip_filter_vehicle_dynamics_mode_response_codec, response,
                           now);
}

/**
 * Vehicle dynamics mode: write. Apply the new setting. See mip_device_call.
 *
 * - mode: Kind of vehicle. A value of enum mip_filter_dynamics_mode. Required for write. On the
 *   3DM-GX3-45: only MIP_FILTER_DYNAMICS_MODE_PORTABLE, MIP_FILTER_DYNAMICS_MODE_AUTOMOTIVE and
 *   MIP_FILTER_DYNAMICS_MODE_AIRBORNE.
 */
static inline struct mip_result mip_call_filter_vehicle_dynamics_mode_write(
    struct mip_device *device, enum mip_filter_dynamics_mode mode) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)mode);
    return mip_device_send(device, &mip_filter_vehicle_dynamics_mode_exchange, data, 2);
}

/** Vehicle dynamics mode: read. Return the current setting in a response. See mip_device_call. */
static inline struct mip_result mip_call_filter_vehicle_dynamics_mode_read(
    struct mip_device *device, struct mip_filter_vehicle_dynamics_mode_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_vehicle_dynamics_mode_exchange, data, 1,
                              &mip_filter_vehicle_dynamics_mode_response_codec, response);
}

/**
 * Vehicle dynamics mode: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_filter_vehicle_dynamics_mode_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_vehicle_dynamics_mode_exchange, data, 1);
}

/** Vehicle dynamics mode: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_vehicle_dynamics_mode_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_vehicle_dynamics_mode_exchange, data, 1);
}

/** Vehicle dynamics mode: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_vehicle_dynamics_mode_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_vehicle_dynamics_mode_exchange, data, 1);
}

/**
 * Vehicle dynamics mode: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_vehicle_dynamics_mode_with(
    struct mip_device *device, const struct mip_filter_vehicle_dynamics_mode *command,
    struct mip_filter_vehicle_dynamics_mode_response *response) {
    return mip_device_call(device, &mip_filter_vehicle_dynamics_mode_command, command,
                           &mip_filter_vehicle_dynamics_mode_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_sensor_to_vehicle_rotation_euler_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_sensor_to_vehicle_rotation_euler_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Sensor to vehicle frame
 * transformation. If the command requests the response, it is stored in `response`, which may be
 * NULL.
 */
static inline mip_error mip_send_filter_sensor_to_vehicle_rotation_euler(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_sensor_to_vehicle_rotation_euler *command,
    struct mip_filter_sensor_to_vehicle_rotation_euler_response *response, uint32_t now) {
    return mip_client_send(
        client, request, packet, &mip_filter_sensor_to_vehicle_rotation_euler_command, command,
        &mip_filter_sensor_to_vehicle_rotation_euler_response_codec, response, now);
}

/**
 * Sensor to vehicle frame transformation: write. Apply the new setting. See mip_device_call.
 *
 * - roll: Roll angle. Unit: rad. Required for write.
 * - pitch: Pitch angle. Unit: rad. Required for write.
 * - yaw: Yaw angle. Unit: rad. Required for write.
 */
static inline struct mip_result mip_call_filter_sensor_to_vehicle_rotation_euler_write(
    struct mip_device *device, float roll, float pitch, float yaw) {
    uint8_t data[13];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_float(data + 1, &roll);
    mip_put_float(data + 5, &pitch);
    mip_put_float(data + 9, &yaw);
    return mip_device_send(device, &mip_filter_sensor_to_vehicle_rotation_euler_exchange, data, 13);
}

/**
 * Sensor to vehicle frame transformation: read. Return the current setting in a response. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_sensor_to_vehicle_rotation_euler_read(
    struct mip_device *device,
    struct mip_filter_sensor_to_vehicle_rotation_euler_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_sensor_to_vehicle_rotation_euler_exchange, data,
                              1, &mip_filter_sensor_to_vehicle_rotation_euler_response_codec,
                              response);
}

/**
 * Sensor to vehicle frame transformation: save. Save the current setting to non-volatile memory.
 * See mip_device_call.
 */
static inline struct mip_result
mip_call_filter_sensor_to_vehicle_rotation_euler_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_sensor_to_vehicle_rotation_euler_exchange, data, 1);
}

/** Sensor to vehicle frame transformation: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_sensor_to_vehicle_rotation_euler_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_sensor_to_vehicle_rotation_euler_exchange, data, 1);
}

/**
 * Sensor to vehicle frame transformation: default. Load the factory default setting. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_filter_sensor_to_vehicle_rotation_euler_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_sensor_to_vehicle_rotation_euler_exchange, data, 1);
}

/**
 * Sensor to vehicle frame transformation: calls the command with these values, including optional
 * parameters. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_sensor_to_vehicle_rotation_euler_with(
    struct mip_device *device, const struct mip_filter_sensor_to_vehicle_rotation_euler *command,
    struct mip_filter_sensor_to_vehicle_rotation_euler_response *response) {
    return mip_device_call(device, &mip_filter_sensor_to_vehicle_rotation_euler_command, command,
                           &mip_filter_sensor_to_vehicle_rotation_euler_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_sensor_to_vehicle_offset_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_sensor_to_vehicle_offset_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Sensor to vehicle offset.
 * If the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_sensor_to_vehicle_offset(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_sensor_to_vehicle_offset *command,
    struct mip_filter_sensor_to_vehicle_offset_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_sensor_to_vehicle_offset_command,
                           command, &mip_filter_sensor_to_vehicle_offset_response_codec, response,
                           now);
}

/**
 * Sensor to vehicle offset: write. Apply the new setting. See mip_device_call.
 *
 * - offset: Vector from the sensor to the origin of the vehicle frame. Elements: x, y, z. Unit: m.
 *   Frame: sensor. Range: magnitude at most 10. Required for write.
 */
static inline struct mip_result
mip_call_filter_sensor_to_vehicle_offset_write(struct mip_device *device, const float offset[3]) {
    uint8_t data[13];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 1 + 4 * i, &offset[i]);
    }
    return mip_device_send(device, &mip_filter_sensor_to_vehicle_offset_exchange, data, 13);
}

/**
 * Sensor to vehicle offset: read. Return the current setting in a response. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_sensor_to_vehicle_offset_read(
    struct mip_device *device, struct mip_filter_sensor_to_vehicle_offset_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_sensor_to_vehicle_offset_exchange, data, 1,
                              &mip_filter_sensor_to_vehicle_offset_response_codec, response);
}

/**
 * Sensor to vehicle offset: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_filter_sensor_to_vehicle_offset_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_sensor_to_vehicle_offset_exchange, data, 1);
}

/** Sensor to vehicle offset: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_sensor_to_vehicle_offset_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_sensor_to_vehicle_offset_exchange, data, 1);
}

/** Sensor to vehicle offset: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_sensor_to_vehicle_offset_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_sensor_to_vehicle_offset_exchange, data, 1);
}

/**
 * Sensor to vehicle offset: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_sensor_to_vehicle_offset_with(
    struct mip_device *device, const struct mip_filter_sensor_to_vehicle_offset *command,
    struct mip_filter_sensor_to_vehicle_offset_response *response) {
    return mip_device_call(device, &mip_filter_sensor_to_vehicle_offset_command, command,
                           &mip_filter_sensor_to_vehicle_offset_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_antenna_offset_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_antenna_offset_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. GNSS antenna offset. If
 * the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_antenna_offset(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_antenna_offset *command,
    struct mip_filter_antenna_offset_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_antenna_offset_command, command,
                           &mip_filter_antenna_offset_response_codec, response, now);
}

/**
 * GNSS antenna offset: write. Apply the new setting. See mip_device_call.
 *
 * - offset: Vector from the sensor origin to the phase centre of the antenna. Elements: x, y, z.
 *   Unit: m. Frame: vehicle. Range: magnitude at most 10. Required for write. On the 3DM-GX5-45:
 *   frame sensor.
 */
static inline struct mip_result mip_call_filter_antenna_offset_write(struct mip_device *device,
                                                                     const float offset[3]) {
    uint8_t data[13];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 1 + 4 * i, &offset[i]);
    }
    return mip_device_send(device, &mip_filter_antenna_offset_exchange, data, 13);
}

/** GNSS antenna offset: read. Return the current setting in a response. See mip_device_call. */
static inline struct mip_result mip_call_filter_antenna_offset_read(
    struct mip_device *device, struct mip_filter_antenna_offset_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_antenna_offset_exchange, data, 1,
                              &mip_filter_antenna_offset_response_codec, response);
}

/**
 * GNSS antenna offset: save. Save the current setting to non-volatile memory. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_antenna_offset_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_antenna_offset_exchange, data, 1);
}

/** GNSS antenna offset: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_antenna_offset_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_antenna_offset_exchange, data, 1);
}

/** GNSS antenna offset: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_antenna_offset_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_antenna_offset_exchange, data, 1);
}

/**
 * GNSS antenna offset: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_antenna_offset_with(
    struct mip_device *device, const struct mip_filter_antenna_offset *command,
    struct mip_filter_antenna_offset_response *response) {
    return mip_device_call(device, &mip_filter_antenna_offset_command, command,
                           &mip_filter_antenna_offset_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_estimation_control_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_estimation_control_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Estimation control flags.
 * If the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_estimation_control(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_estimation_control *command,
    struct mip_filter_estimation_control_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_estimation_control_command, command,
                           &mip_filter_estimation_control_response_codec, response, now);
}

/**
 * Estimation control flags: write. Apply the new setting. See mip_device_call.
 *
 * - flags: States to estimate. Required for write. On the 3DM-CV5-15, 3DM-CX5-15, 3DM-GX3-45,
 *   3DM-GX4-15, 3DM-GX4-25 and 3DM-GX5-15: only MIP_FILTER_ESTIMATED_STATES_GYRO_BIAS. On the
 *   3DM-CV5-25, 3DM-CX5-25 and 3DM-GX5-25: only MIP_FILTER_ESTIMATED_STATES_GYRO_BIAS,
 *   MIP_FILTER_ESTIMATED_STATES_AUTO_HARD_IRON and MIP_FILTER_ESTIMATED_STATES_AUTO_SOFT_IRON. On
 *   the 3DM-GQ4-45, 3DM-GX4-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: only
 *   MIP_FILTER_ESTIMATED_STATES_GYRO_BIAS, MIP_FILTER_ESTIMATED_STATES_ACCEL_BIAS,
 *   MIP_FILTER_ESTIMATED_STATES_GYRO_SCALE_FACTOR, MIP_FILTER_ESTIMATED_STATES_ACCEL_SCALE_FACTOR
 *   and MIP_FILTER_ESTIMATED_STATES_ANTENNA_OFFSET.
 */
static inline struct mip_result mip_call_filter_estimation_control_write(
    struct mip_device *device, mip_filter_estimated_states flags) {
    uint8_t data[3];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_16(data + 1, (uint16_t)flags);
    return mip_device_send(device, &mip_filter_estimation_control_exchange, data, 3);
}

/**
 * Estimation control flags: read. Return the current setting in a response. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_estimation_control_read(
    struct mip_device *device, struct mip_filter_estimation_control_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_estimation_control_exchange, data, 1,
                              &mip_filter_estimation_control_response_codec, response);
}

/**
 * Estimation control flags: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_estimation_control_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_estimation_control_exchange, data, 1);
}

/** Estimation control flags: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_estimation_control_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_estimation_control_exchange, data, 1);
}

/** Estimation control flags: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_estimation_control_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_estimation_control_exchange, data, 1);
}

/**
 * Estimation control flags: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_estimation_control_with(
    struct mip_device *device, const struct mip_filter_estimation_control *command,
    struct mip_filter_estimation_control_response *response) {
    return mip_device_call(device, &mip_filter_estimation_control_command, command,
                           &mip_filter_estimation_control_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_gnss_source_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_gnss_source_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. GNSS aiding source. If
 * the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_gnss_source(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_gnss_source *command, struct mip_filter_gnss_source_response *response,
    uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_gnss_source_command, command,
                           &mip_filter_gnss_source_response_codec, response, now);
}

/**
 * GNSS aiding source: write. Apply the new setting. See mip_device_call.
 *
 * - source: Source of the GNSS data. A value of enum mip_filter_gnss_aiding_source. Required for
 *   write. On the 3DM-GX5-45: only MIP_FILTER_GNSS_AIDING_SOURCE_ALL_INTERNAL and
 *   MIP_FILTER_GNSS_AIDING_SOURCE_EXTERNAL.
 */
static inline struct mip_result mip_call_filter_gnss_source_write(
    struct mip_device *device, enum mip_filter_gnss_aiding_source source) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)source);
    return mip_device_send(device, &mip_filter_gnss_source_exchange, data, 2);
}

/** GNSS aiding source: read. Return the current setting in a response. See mip_device_call. */
static inline struct mip_result mip_call_filter_gnss_source_read(
    struct mip_device *device, struct mip_filter_gnss_source_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_gnss_source_exchange, data, 1,
                              &mip_filter_gnss_source_response_codec, response);
}

/**
 * GNSS aiding source: save. Save the current setting to non-volatile memory. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_gnss_source_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_gnss_source_exchange, data, 1);
}

/** GNSS aiding source: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_gnss_source_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_gnss_source_exchange, data, 1);
}

/** GNSS aiding source: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_gnss_source_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_gnss_source_exchange, data, 1);
}

/**
 * GNSS aiding source: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_gnss_source_with(
    struct mip_device *device, const struct mip_filter_gnss_source *command,
    struct mip_filter_gnss_source_response *response) {
    return mip_device_call(device, &mip_filter_gnss_source_command, command,
                           &mip_filter_gnss_source_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_external_gnss_update_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_external_gnss_update_exchange;

/** Adds the command to a packet and tracks its reply: see mip_client_send. External GNSS update. */
static inline mip_error mip_send_filter_external_gnss_update(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_external_gnss_update *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_external_gnss_update_command,
                           command, NULL, NULL, now);
}

/**
 * External GNSS update. See mip_device_call.
 *
 * - tow: GPS time of week. Unit: s. Range: at least 0, less than 604800.
 * - week_number: GPS week, counted without rollover. Unit: week.
 * - latitude: Geodetic latitude. Unit: deg. Frame: llh. Range: -90 to 90. Positive: north.
 * - longitude: Geodetic longitude. Unit: deg. Frame: llh. Range: -180 to 180. Positive: east.
 * - height: Height above the ellipsoid. Unit: m. Frame: llh.
 * - velocity: Velocity of the antenna. Elements: north, east, down. Unit: m/s. Frame: ned.
 * - position_uncertainty: Standard deviation of the position. Elements: north, east, down. Unit: m.
 *   Frame: ned. Range: at least 0.
 * - velocity_uncertainty: Standard deviation of the velocity. Elements: north, east, down. Unit:
 *   m/s. Frame: ned. Range: at least 0.
 */
static inline struct mip_result mip_call_filter_external_gnss_update(
    struct mip_device *device, double tow, uint16_t week_number, double latitude, double longitude,
    double height, const float velocity[3], const float position_uncertainty[3],
    const float velocity_uncertainty[3]) {
    uint8_t data[70];
    mip_put_double(data, &tow);
    mip_put_16(data + 8, (uint16_t)week_number);
    mip_put_double(data + 10, &latitude);
    mip_put_double(data + 18, &longitude);
    mip_put_double(data + 26, &height);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 46 + 4 * i, &position_uncertainty[i]);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 34 + 4 * i, &velocity[i]);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 58 + 4 * i, &velocity_uncertainty[i]);
    }
    return mip_device_send(device, &mip_filter_external_gnss_update_exchange, data, 70);
}

/**
 * External GNSS update: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_external_gnss_update_with(
    struct mip_device *device, const struct mip_filter_external_gnss_update *command) {
    return mip_device_call(device, &mip_filter_external_gnss_update_command, command, NULL, NULL);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_external_heading_update_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_external_heading_update_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. External heading update.
 */
static inline mip_error mip_send_filter_external_heading_update(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_external_heading_update *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_external_heading_update_command,
                           command, NULL, NULL, now);
}

/**
 * External heading update. See mip_device_call.
 *
 * - heading: Heading relative to the north selected by `type`. Unit: rad. Frame: ned. Range:
 *   -3.141592653589793 to 3.141592653589793. Positive: clockwise seen from above.
 * - heading_uncertainty: Standard deviation; the device rejects values out of range. Unit: rad.
 *   Range: greater than 0.
 * - type: North that the heading refers to. A value of enum mip_filter_heading_type.
 */
static inline struct mip_result mip_call_filter_external_heading_update(
    struct mip_device *device, float heading, float heading_uncertainty,
    enum mip_filter_heading_type type) {
    uint8_t data[9];
    mip_put_float(data, &heading);
    mip_put_float(data + 4, &heading_uncertainty);
    mip_put_8(data + 8, (uint8_t)type);
    return mip_device_send(device, &mip_filter_external_heading_update_exchange, data, 9);
}

/**
 * External heading update: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_external_heading_update_with(
    struct mip_device *device, const struct mip_filter_external_heading_update *command) {
    return mip_device_call(device, &mip_filter_external_heading_update_command, command, NULL,
                           NULL);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_heading_source_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_heading_source_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Heading update control.
 * If the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_heading_source(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_heading_source *command,
    struct mip_filter_heading_source_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_heading_source_command, command,
                           &mip_filter_heading_source_response_codec, response, now);
}

/**
 * Heading update control: write. Apply the new setting. See mip_device_call.
 *
 * - source: Source of the heading. A value of enum mip_filter_heading_update_source. Required for
 *   write. On the 3DM-CV5-15, 3DM-CX5-15 and 3DM-GX5-15: only MIP_FILTER_HEADING_UPDATE_SOURCE_NONE
 *   and MIP_FILTER_HEADING_UPDATE_SOURCE_EXTERNAL. On the 3DM-CV5-25, 3DM-CX5-25, 3DM-GX4-25 and
 *   3DM-GX5-25: only MIP_FILTER_HEADING_UPDATE_SOURCE_NONE, MIP_FILTER_HEADING_UPDATE_SOURCE_MAG
 *   and MIP_FILTER_HEADING_UPDATE_SOURCE_EXTERNAL. On the 3DM-GQ4-45, 3DM-GX3-45 and 3DM-GX4-45:
 *   only MIP_FILTER_HEADING_UPDATE_SOURCE_NONE, MIP_FILTER_HEADING_UPDATE_SOURCE_MAG,
 *   MIP_FILTER_HEADING_UPDATE_SOURCE_GNSS_VELOCITY and MIP_FILTER_HEADING_UPDATE_SOURCE_EXTERNAL.
 *   On the 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: only MIP_FILTER_HEADING_UPDATE_SOURCE_NONE,
 *   MIP_FILTER_HEADING_UPDATE_SOURCE_GNSS_VELOCITY and MIP_FILTER_HEADING_UPDATE_SOURCE_EXTERNAL.
 */
static inline struct mip_result mip_call_filter_heading_source_write(
    struct mip_device *device, enum mip_filter_heading_update_source source) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)source);
    return mip_device_send(device, &mip_filter_heading_source_exchange, data, 2);
}

/** Heading update control: read. Return the current setting in a response. See mip_device_call. */
static inline struct mip_result mip_call_filter_heading_source_read(
    struct mip_device *device, struct mip_filter_heading_source_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_heading_source_exchange, data, 1,
                              &mip_filter_heading_source_response_codec, response);
}

/**
 * Heading update control: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_heading_source_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_heading_source_exchange, data, 1);
}

/** Heading update control: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_heading_source_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_heading_source_exchange, data, 1);
}

/** Heading update control: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_heading_source_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_heading_source_exchange, data, 1);
}

/**
 * Heading update control: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_heading_source_with(
    struct mip_device *device, const struct mip_filter_heading_source *command,
    struct mip_filter_heading_source_response *response) {
    return mip_device_call(device, &mip_filter_heading_source_command, command,
                           &mip_filter_heading_source_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_auto_initialization_control_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_auto_initialization_control_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Automatic initialization.
 * If the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_auto_initialization_control(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_auto_initialization_control *command,
    struct mip_filter_auto_initialization_control_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_auto_initialization_control_command,
                           command, &mip_filter_auto_initialization_control_response_codec,
                           response, now);
}

/**
 * Automatic initialization: write. Apply the new setting. See mip_device_call.
 *
 * - enable: 0 disables, 1 enables. Range: 0 to 1. Required for write.
 */
static inline struct mip_result
mip_call_filter_auto_initialization_control_write(struct mip_device *device, uint8_t enable) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)enable);
    return mip_device_send(device, &mip_filter_auto_initialization_control_exchange, data, 2);
}

/**
 * Automatic initialization: read. Return the current setting in a response. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_auto_initialization_control_read(
    struct mip_device *device, struct mip_filter_auto_initialization_control_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_auto_initialization_control_exchange, data, 1,
                              &mip_filter_auto_initialization_control_response_codec, response);
}

/**
 * Automatic initialization: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_filter_auto_initialization_control_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_auto_initialization_control_exchange, data, 1);
}

/** Automatic initialization: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_auto_initialization_control_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_auto_initialization_control_exchange, data, 1);
}

/** Automatic initialization: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_auto_initialization_control_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_auto_initialization_control_exchange, data, 1);
}

/**
 * Automatic initialization: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_auto_initialization_control_with(
    struct mip_device *device, const struct mip_filter_auto_initialization_control *command,
    struct mip_filter_auto_initialization_control_response *response) {
    return mip_device_call(device, &mip_filter_auto_initialization_control_command, command,
                           &mip_filter_auto_initialization_control_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_accel_noise_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_accel_noise_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Accelerometer noise. If
 * the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_accel_noise(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_accel_noise *command, struct mip_filter_accel_noise_response *response,
    uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_accel_noise_command, command,
                           &mip_filter_accel_noise_response_codec, response, now);
}

/**
 * Accelerometer noise: write. Apply the new setting. See mip_device_call.
 *
 * - noise: Standard deviation per axis. Elements: x, y, z. Unit: m/s^2. Range: greater than 0.
 *   Required for write.
 */
static inline struct mip_result mip_call_filter_accel_noise_write(struct mip_device *device,
                                                                  const float noise[3]) {
    uint8_t data[13];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 1 + 4 * i, &noise[i]);
    }
    return mip_device_send(device, &mip_filter_accel_noise_exchange, data, 13);
}

/** Accelerometer noise: read. Return the current setting in a response. See mip_device_call. */
static inline struct mip_result mip_call_filter_accel_noise_read(
    struct mip_device *device, struct mip_filter_accel_noise_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_accel_noise_exchange, data, 1,
                              &mip_filter_accel_noise_response_codec, response);
}

/**
 * Accelerometer noise: save. Save the current setting to non-volatile memory. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_accel_noise_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_accel_noise_exchange, data, 1);
}

/** Accelerometer noise: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_accel_noise_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_accel_noise_exchange, data, 1);
}

/** Accelerometer noise: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_accel_noise_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_accel_noise_exchange, data, 1);
}

/**
 * Accelerometer noise: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_accel_noise_with(
    struct mip_device *device, const struct mip_filter_accel_noise *command,
    struct mip_filter_accel_noise_response *response) {
    return mip_device_call(device, &mip_filter_accel_noise_command, command,
                           &mip_filter_accel_noise_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_gyro_noise_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_gyro_noise_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Gyroscope noise. If the
 * command requests the response, it is stored in `response`, which may be NULL.
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

/**
 * Gyroscope noise: write. Apply the new setting. See mip_device_call.
 *
 * - noise: Standard deviation per axis. Elements: x, y, z. Unit: rad/s. Range: greater than 0.
 *   Required for write.
 */
static inline struct mip_result mip_call_filter_gyro_noise_write(struct mip_device *device,
                                                                 const float noise[3]) {
    uint8_t data[13];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 1 + 4 * i, &noise[i]);
    }
    return mip_device_send(device, &mip_filter_gyro_noise_exchange, data, 13);
}

/** Gyroscope noise: read. Return the current setting in a response. See mip_device_call. */
static inline struct mip_result mip_call_filter_gyro_noise_read(
    struct mip_device *device, struct mip_filter_gyro_noise_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_gyro_noise_exchange, data, 1,
                              &mip_filter_gyro_noise_response_codec, response);
}

/** Gyroscope noise: save. Save the current setting to non-volatile memory. See mip_device_call. */
static inline struct mip_result mip_call_filter_gyro_noise_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_gyro_noise_exchange, data, 1);
}

/** Gyroscope noise: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_gyro_noise_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_gyro_noise_exchange, data, 1);
}

/** Gyroscope noise: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_gyro_noise_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_gyro_noise_exchange, data, 1);
}

/**
 * Gyroscope noise: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_gyro_noise_with(
    struct mip_device *device, const struct mip_filter_gyro_noise *command,
    struct mip_filter_gyro_noise_response *response) {
    return mip_device_call(device, &mip_filter_gyro_noise_command, command,
                           &mip_filter_gyro_noise_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_accel_bias_model_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_accel_bias_model_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Accelerometer bias model.
 * If the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_accel_bias_model(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_accel_bias_model *command,
    struct mip_filter_accel_bias_model_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_accel_bias_model_command, command,
                           &mip_filter_accel_bias_model_response_codec, response, now);
}

/**
 * Accelerometer bias model: write. Apply the new setting. See mip_device_call.
 *
 * - beta: Reciprocal of the correlation time per axis. Elements: x, y, z. Unit: 1/s. Required for
 *   write.
 * - noise: Standard deviation of the noise per axis. Elements: x, y, z. Unit: m/s^2. Range: greater
 *   than 0. Required for write.
 */
static inline struct mip_result mip_call_filter_accel_bias_model_write(struct mip_device *device,
                                                                       const float beta[3],
                                                                       const float noise[3]) {
    uint8_t data[25];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 1 + 4 * i, &beta[i]);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 13 + 4 * i, &noise[i]);
    }
    return mip_device_send(device, &mip_filter_accel_bias_model_exchange, data, 25);
}

/**
 * Accelerometer bias model: read. Return the current setting in a response. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_accel_bias_model_read(
    struct mip_device *device, struct mip_filter_accel_bias_model_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_accel_bias_model_exchange, data, 1,
                              &mip_filter_accel_bias_model_response_codec, response);
}

/**
 * Accelerometer bias model: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_accel_bias_model_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_accel_bias_model_exchange, data, 1);
}

/** Accelerometer bias model: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_accel_bias_model_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_accel_bias_model_exchange, data, 1);
}

/** Accelerometer bias model: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_accel_bias_model_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_accel_bias_model_exchange, data, 1);
}

/**
 * Accelerometer bias model: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_accel_bias_model_with(
    struct mip_device *device, const struct mip_filter_accel_bias_model *command,
    struct mip_filter_accel_bias_model_response *response) {
    return mip_device_call(device, &mip_filter_accel_bias_model_command, command,
                           &mip_filter_accel_bias_model_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_gyro_bias_model_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_gyro_bias_model_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Gyroscope bias model. If
 * the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_gyro_bias_model(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_gyro_bias_model *command,
    struct mip_filter_gyro_bias_model_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_gyro_bias_model_command, command,
                           &mip_filter_gyro_bias_model_response_codec, response, now);
}

/**
 * Gyroscope bias model: write. Apply the new setting. See mip_device_call.
 *
 * - beta: Reciprocal of the correlation time per axis. Elements: x, y, z. Unit: 1/s. Required for
 *   write.
 * - noise: Standard deviation of the noise per axis. Elements: x, y, z. Unit: rad/s. Range: greater
 *   than 0. Required for write.
 */
static inline struct mip_result mip_call_filter_gyro_bias_model_write(struct mip_device *device,
                                                                      const float beta[3],
                                                                      const float noise[3]) {
    uint8_t data[25];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 1 + 4 * i, &beta[i]);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 13 + 4 * i, &noise[i]);
    }
    return mip_device_send(device, &mip_filter_gyro_bias_model_exchange, data, 25);
}

/** Gyroscope bias model: read. Return the current setting in a response. See mip_device_call. */
static inline struct mip_result mip_call_filter_gyro_bias_model_read(
    struct mip_device *device, struct mip_filter_gyro_bias_model_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_gyro_bias_model_exchange, data, 1,
                              &mip_filter_gyro_bias_model_response_codec, response);
}

/**
 * Gyroscope bias model: save. Save the current setting to non-volatile memory. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_gyro_bias_model_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_gyro_bias_model_exchange, data, 1);
}

/** Gyroscope bias model: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_gyro_bias_model_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_gyro_bias_model_exchange, data, 1);
}

/** Gyroscope bias model: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_gyro_bias_model_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_gyro_bias_model_exchange, data, 1);
}

/**
 * Gyroscope bias model: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_gyro_bias_model_with(
    struct mip_device *device, const struct mip_filter_gyro_bias_model *command,
    struct mip_filter_gyro_bias_model_response *response) {
    return mip_device_call(device, &mip_filter_gyro_bias_model_command, command,
                           &mip_filter_gyro_bias_model_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_auto_zupt_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_auto_zupt_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Automatic zero velocity
 * update. If the command requests the response, it is stored in `response`, which may be NULL.
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

/**
 * Automatic zero velocity update: write. Apply the new setting. See mip_device_call.
 *
 * - enable: 0 disables, 1 enables. Range: 0 to 1. Required for write.
 * - threshold: Highest speed that is treated as zero. Unit: m/s. Range: at least 0. Required for
 *   write.
 */
static inline struct mip_result mip_call_filter_auto_zupt_write(struct mip_device *device,
                                                                uint8_t enable, float threshold) {
    uint8_t data[6];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)enable);
    mip_put_float(data + 2, &threshold);
    return mip_device_send(device, &mip_filter_auto_zupt_exchange, data, 6);
}

/**
 * Automatic zero velocity update: read. Return the current setting in a response. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_auto_zupt_read(
    struct mip_device *device, struct mip_filter_auto_zupt_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_auto_zupt_exchange, data, 1,
                              &mip_filter_auto_zupt_response_codec, response);
}

/**
 * Automatic zero velocity update: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_auto_zupt_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_auto_zupt_exchange, data, 1);
}

/** Automatic zero velocity update: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_auto_zupt_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_auto_zupt_exchange, data, 1);
}

/**
 * Automatic zero velocity update: default. Load the factory default setting. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_auto_zupt_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_auto_zupt_exchange, data, 1);
}

/**
 * Automatic zero velocity update: calls the command with these values, including optional
 * parameters. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_auto_zupt_with(
    struct mip_device *device, const struct mip_filter_auto_zupt *command,
    struct mip_filter_auto_zupt_response *response) {
    return mip_device_call(device, &mip_filter_auto_zupt_command, command,
                           &mip_filter_auto_zupt_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_external_heading_update_with_time_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_external_heading_update_with_time_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. External heading update
 * with time.
 */
static inline mip_error mip_send_filter_external_heading_update_with_time(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_external_heading_update_with_time *command, uint32_t now) {
    return mip_client_send(client, request, packet,
                           &mip_filter_external_heading_update_with_time_command, command, NULL,
                           NULL, now);
}

/**
 * External heading update with time. See mip_device_call.
 *
 * - tow: GPS time of week of the measurement. Unit: s. Range: at least 0, less than 604800.
 * - week_number: GPS week, counted without rollover. Unit: week.
 * - heading: Heading relative to the north selected by `type`. Unit: rad. Frame: ned. Range:
 *   -3.141592653589793 to 3.141592653589793. Positive: clockwise seen from above.
 * - heading_uncertainty: Standard deviation; the device rejects values out of range. Unit: rad.
 *   Range: greater than 0.
 * - type: North that the heading refers to. A value of enum mip_filter_heading_type.
 */
static inline struct mip_result mip_call_filter_external_heading_update_with_time(
    struct mip_device *device, double tow, uint16_t week_number, float heading,
    float heading_uncertainty, enum mip_filter_heading_type type) {
    uint8_t data[19];
    mip_put_double(data, &tow);
    mip_put_16(data + 8, (uint16_t)week_number);
    mip_put_float(data + 10, &heading);
    mip_put_float(data + 14, &heading_uncertainty);
    mip_put_8(data + 18, (uint8_t)type);
    return mip_device_send(device, &mip_filter_external_heading_update_with_time_exchange, data,
                           19);
}

/**
 * External heading update with time: calls the command with these values, including optional
 * parameters. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_external_heading_update_with_time_with(
    struct mip_device *device, const struct mip_filter_external_heading_update_with_time *command) {
    return mip_device_call(device, &mip_filter_external_heading_update_with_time_command, command,
                           NULL, NULL);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_auto_angular_zupt_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_auto_angular_zupt_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Zero angular rate update.
 * If the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_auto_angular_zupt(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_auto_angular_zupt *command,
    struct mip_filter_auto_angular_zupt_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_auto_angular_zupt_command, command,
                           &mip_filter_auto_angular_zupt_response_codec, response, now);
}

/**
 * Zero angular rate update: write. Apply the new setting. See mip_device_call.
 *
 * - enable: 0 disables, 1 enables. Range: 0 to 1. Required for write.
 * - threshold: Highest angular rate that is treated as zero. Unit: rad/s. Range: at least 0.
 *   Required for write.
 */
static inline struct mip_result mip_call_filter_auto_angular_zupt_write(struct mip_device *device,
                                                                        uint8_t enable,
                                                                        float threshold) {
    uint8_t data[6];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)enable);
    mip_put_float(data + 2, &threshold);
    return mip_device_send(device, &mip_filter_auto_angular_zupt_exchange, data, 6);
}

/**
 * Zero angular rate update: read. Return the current setting in a response. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_auto_angular_zupt_read(
    struct mip_device *device, struct mip_filter_auto_angular_zupt_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_auto_angular_zupt_exchange, data, 1,
                              &mip_filter_auto_angular_zupt_response_codec, response);
}

/**
 * Zero angular rate update: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_auto_angular_zupt_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_auto_angular_zupt_exchange, data, 1);
}

/** Zero angular rate update: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_auto_angular_zupt_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_auto_angular_zupt_exchange, data, 1);
}

/** Zero angular rate update: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_auto_angular_zupt_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_auto_angular_zupt_exchange, data, 1);
}

/**
 * Zero angular rate update: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_auto_angular_zupt_with(
    struct mip_device *device, const struct mip_filter_auto_angular_zupt *command,
    struct mip_filter_auto_angular_zupt_response *response) {
    return mip_device_call(device, &mip_filter_auto_angular_zupt_command, command,
                           &mip_filter_auto_angular_zupt_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_tare_orientation_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_tare_orientation_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Tare orientation. If the
 * command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_tare_orientation(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_tare_orientation *command,
    struct mip_filter_tare_orientation_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_tare_orientation_command, command,
                           &mip_filter_tare_orientation_response_codec, response, now);
}

/**
 * Tare orientation: write. Apply the new setting. See mip_device_call.
 *
 * - axes: Axes to tare; 0 resets all axes. Required for write.
 */
static inline struct mip_result mip_call_filter_tare_orientation_write(struct mip_device *device,
                                                                       mip_filter_tare_axes axes) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)axes);
    return mip_device_send(device, &mip_filter_tare_orientation_exchange, data, 2);
}

/** Tare orientation: read. Return the current setting in a response. See mip_device_call. */
static inline struct mip_result mip_call_filter_tare_orientation_read(
    struct mip_device *device, struct mip_filter_tare_orientation_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_tare_orientation_exchange, data, 1,
                              &mip_filter_tare_orientation_response_codec, response);
}

/** Tare orientation: save. Save the current setting to non-volatile memory. See mip_device_call. */
static inline struct mip_result mip_call_filter_tare_orientation_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_tare_orientation_exchange, data, 1);
}

/** Tare orientation: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_tare_orientation_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_tare_orientation_exchange, data, 1);
}

/** Tare orientation: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_tare_orientation_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_tare_orientation_exchange, data, 1);
}

/**
 * Tare orientation: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_tare_orientation_with(
    struct mip_device *device, const struct mip_filter_tare_orientation *command,
    struct mip_filter_tare_orientation_response *response) {
    return mip_device_call(device, &mip_filter_tare_orientation_command, command,
                           &mip_filter_tare_orientation_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_commanded_zupt_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_commanded_zupt_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Commanded zero velocity
 * update.
 */
static inline mip_error mip_send_filter_commanded_zupt(struct mip_client *client,
                                                       struct mip_request *request,
                                                       struct mip_builder *packet, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_commanded_zupt_command, NULL, NULL,
                           NULL, now);
}

/** Commanded zero velocity update. See mip_device_call. */
static inline struct mip_result mip_call_filter_commanded_zupt(struct mip_device *device) {
    return mip_device_send(device, &mip_filter_commanded_zupt_exchange,
                           MIP_NO_DATA(mip_filter_commanded_zupt_exchange), 0);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_commanded_angular_zupt_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_commanded_angular_zupt_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Commanded zero angular
 * rate update.
 */
static inline mip_error mip_send_filter_commanded_angular_zupt(struct mip_client *client,
                                                               struct mip_request *request,
                                                               struct mip_builder *packet,
                                                               uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_commanded_angular_zupt_command,
                           NULL, NULL, NULL, now);
}

/** Commanded zero angular rate update. See mip_device_call. */
static inline struct mip_result mip_call_filter_commanded_angular_zupt(struct mip_device *device) {
    return mip_device_send(device, &mip_filter_commanded_angular_zupt_exchange,
                           MIP_NO_DATA(mip_filter_commanded_angular_zupt_exchange), 0);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_reference_position_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_reference_position_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Set reference position.
 * If the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_reference_position(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_reference_position *command,
    struct mip_filter_reference_position_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_reference_position_command, command,
                           &mip_filter_reference_position_response_codec, response, now);
}

/**
 * Set reference position: write. Apply the new setting. See mip_device_call.
 *
 * - enable: 0 disables, 1 enables. Range: 0 to 1. Required for write.
 * - latitude: Geodetic latitude. Unit: deg. Frame: llh. Range: -90 to 90. Positive: north. Required
 *   for write.
 * - longitude: Geodetic longitude. Unit: deg. Frame: llh. Range: -180 to 180. Positive: east.
 *   Required for write.
 * - altitude: Altitude of the reference position. Unit: m. Required for write. Uncertain: Whether
 *   it counts from the ellipsoid or from sea level. The manual does not state it; its glossary
 *   counts altitudes from sea level.
 */
static inline struct mip_result mip_call_filter_reference_position_write(
    struct mip_device *device, uint8_t enable, double latitude, double longitude, double altitude) {
    uint8_t data[26];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)enable);
    mip_put_double(data + 2, &latitude);
    mip_put_double(data + 10, &longitude);
    mip_put_double(data + 18, &altitude);
    return mip_device_send(device, &mip_filter_reference_position_exchange, data, 26);
}

/** Set reference position: read. Return the current setting in a response. See mip_device_call. */
static inline struct mip_result mip_call_filter_reference_position_read(
    struct mip_device *device, struct mip_filter_reference_position_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_reference_position_exchange, data, 1,
                              &mip_filter_reference_position_response_codec, response);
}

/**
 * Set reference position: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_reference_position_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_reference_position_exchange, data, 1);
}

/** Set reference position: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_reference_position_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_reference_position_exchange, data, 1);
}

/** Set reference position: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_reference_position_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_reference_position_exchange, data, 1);
}

/**
 * Set reference position: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_reference_position_with(
    struct mip_device *device, const struct mip_filter_reference_position *command,
    struct mip_filter_reference_position_response *response) {
    return mip_device_call(device, &mip_filter_reference_position_command, command,
                           &mip_filter_reference_position_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_mag_capture_auto_calibration_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_mag_capture_auto_calibration_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Capture automatic
 * magnetometer calibration.
 */
static inline mip_error mip_send_filter_mag_capture_auto_calibration(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_mag_capture_auto_calibration *command, uint32_t now) {
    return mip_client_send(client, request, packet,
                           &mip_filter_mag_capture_auto_calibration_command, command, NULL, NULL,
                           now);
}

/**
 * Capture automatic magnetometer calibration: write. Apply the new setting. See mip_device_call.
 */
static inline struct mip_result
mip_call_filter_mag_capture_auto_calibration_write(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    return mip_device_send(device, &mip_filter_mag_capture_auto_calibration_exchange, data, 1);
}

/**
 * Capture automatic magnetometer calibration: save. Save the current setting to non-volatile
 * memory. See mip_device_call.
 */
static inline struct mip_result
mip_call_filter_mag_capture_auto_calibration_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_mag_capture_auto_calibration_exchange, data, 1);
}

/**
 * Capture automatic magnetometer calibration: calls the command with these values, including
 * optional parameters. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_mag_capture_auto_calibration_with(
    struct mip_device *device, const struct mip_filter_mag_capture_auto_calibration *command) {
    return mip_device_call(device, &mip_filter_mag_capture_auto_calibration_command, command, NULL,
                           NULL);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_gravity_noise_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_gravity_noise_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Gravity noise. If the
 * command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_gravity_noise(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_gravity_noise *command,
    struct mip_filter_gravity_noise_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_gravity_noise_command, command,
                           &mip_filter_gravity_noise_response_codec, response, now);
}

/**
 * Gravity noise: write. Apply the new setting. See mip_device_call.
 *
 * - noise: Standard deviation per axis. Elements: x, y, z. Unit: g. Range: greater than 0. Required
 *   for write.
 */
static inline struct mip_result mip_call_filter_gravity_noise_write(struct mip_device *device,
                                                                    const float noise[3]) {
    uint8_t data[13];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 1 + 4 * i, &noise[i]);
    }
    return mip_device_send(device, &mip_filter_gravity_noise_exchange, data, 13);
}

/** Gravity noise: read. Return the current setting in a response. See mip_device_call. */
static inline struct mip_result mip_call_filter_gravity_noise_read(
    struct mip_device *device, struct mip_filter_gravity_noise_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_gravity_noise_exchange, data, 1,
                              &mip_filter_gravity_noise_response_codec, response);
}

/** Gravity noise: save. Save the current setting to non-volatile memory. See mip_device_call. */
static inline struct mip_result mip_call_filter_gravity_noise_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_gravity_noise_exchange, data, 1);
}

/** Gravity noise: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_gravity_noise_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_gravity_noise_exchange, data, 1);
}

/** Gravity noise: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_gravity_noise_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_gravity_noise_exchange, data, 1);
}

/**
 * Gravity noise: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_gravity_noise_with(
    struct mip_device *device, const struct mip_filter_gravity_noise *command,
    struct mip_filter_gravity_noise_response *response) {
    return mip_device_call(device, &mip_filter_gravity_noise_command, command,
                           &mip_filter_gravity_noise_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_pressure_altitude_noise_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_pressure_altitude_noise_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Pressure altitude noise.
 * If the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_pressure_altitude_noise(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_pressure_altitude_noise *command,
    struct mip_filter_pressure_altitude_noise_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_pressure_altitude_noise_command,
                           command, &mip_filter_pressure_altitude_noise_response_codec, response,
                           now);
}

/**
 * Pressure altitude noise: write. Apply the new setting. See mip_device_call.
 *
 * - noise: Standard deviation of the pressure altitude noise. Unit: m. Range: greater than 0.
 *   Required for write.
 */
static inline struct mip_result
mip_call_filter_pressure_altitude_noise_write(struct mip_device *device, float noise) {
    uint8_t data[5];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_float(data + 1, &noise);
    return mip_device_send(device, &mip_filter_pressure_altitude_noise_exchange, data, 5);
}

/** Pressure altitude noise: read. Return the current setting in a response. See mip_device_call. */
static inline struct mip_result mip_call_filter_pressure_altitude_noise_read(
    struct mip_device *device, struct mip_filter_pressure_altitude_noise_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_pressure_altitude_noise_exchange, data, 1,
                              &mip_filter_pressure_altitude_noise_response_codec, response);
}

/**
 * Pressure altitude noise: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_filter_pressure_altitude_noise_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_pressure_altitude_noise_exchange, data, 1);
}

/** Pressure altitude noise: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_pressure_altitude_noise_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_pressure_altitude_noise_exchange, data, 1);
}

/** Pressure altitude noise: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_pressure_altitude_noise_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_pressure_altitude_noise_exchange, data, 1);
}

/**
 * Pressure altitude noise: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_pressure_altitude_noise_with(
    struct mip_device *device, const struct mip_filter_pressure_altitude_noise *command,
    struct mip_filter_pressure_altitude_noise_response *response) {
    return mip_device_call(device, &mip_filter_pressure_altitude_noise_command, command,
                           &mip_filter_pressure_altitude_noise_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_hard_iron_offset_noise_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_hard_iron_offset_noise_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Hard iron offset noise.
 * If the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_hard_iron_offset_noise(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_hard_iron_offset_noise *command,
    struct mip_filter_hard_iron_offset_noise_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_hard_iron_offset_noise_command,
                           command, &mip_filter_hard_iron_offset_noise_response_codec, response,
                           now);
}

/**
 * Hard iron offset noise: write. Apply the new setting. See mip_device_call.
 *
 * - noise: Standard deviation per axis. Elements: x, y, z. Unit: gauss. Range: greater than 0.
 *   Required for write.
 */
static inline struct mip_result
mip_call_filter_hard_iron_offset_noise_write(struct mip_device *device, const float noise[3]) {
    uint8_t data[13];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 1 + 4 * i, &noise[i]);
    }
    return mip_device_send(device, &mip_filter_hard_iron_offset_noise_exchange, data, 13);
}

/** Hard iron offset noise: read. Return the current setting in a response. See mip_device_call. */
static inline struct mip_result mip_call_filter_hard_iron_offset_noise_read(
    struct mip_device *device, struct mip_filter_hard_iron_offset_noise_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_hard_iron_offset_noise_exchange, data, 1,
                              &mip_filter_hard_iron_offset_noise_response_codec, response);
}

/**
 * Hard iron offset noise: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_filter_hard_iron_offset_noise_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_hard_iron_offset_noise_exchange, data, 1);
}

/** Hard iron offset noise: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_hard_iron_offset_noise_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_hard_iron_offset_noise_exchange, data, 1);
}

/** Hard iron offset noise: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_hard_iron_offset_noise_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_hard_iron_offset_noise_exchange, data, 1);
}

/**
 * Hard iron offset noise: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_hard_iron_offset_noise_with(
    struct mip_device *device, const struct mip_filter_hard_iron_offset_noise *command,
    struct mip_filter_hard_iron_offset_noise_response *response) {
    return mip_device_call(device, &mip_filter_hard_iron_offset_noise_command, command,
                           &mip_filter_hard_iron_offset_noise_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_soft_iron_matrix_noise_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_soft_iron_matrix_noise_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Soft iron matrix noise.
 * If the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_soft_iron_matrix_noise(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_soft_iron_matrix_noise *command,
    struct mip_filter_soft_iron_matrix_noise_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_soft_iron_matrix_noise_command,
                           command, &mip_filter_soft_iron_matrix_noise_response_codec, response,
                           now);
}

/**
 * Soft iron matrix noise: write. Apply the new setting. See mip_device_call.
 *
 * - noise: Standard deviation per element. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33.
 *   Unit: 1. Range: greater than 0. Required for write.
 */
static inline struct mip_result
mip_call_filter_soft_iron_matrix_noise_write(struct mip_device *device, const float noise[9]) {
    uint8_t data[37];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    for (size_t i = 0; i < 9; i++) {
        mip_put_float(data + 1 + 4 * i, &noise[i]);
    }
    return mip_device_send(device, &mip_filter_soft_iron_matrix_noise_exchange, data, 37);
}

/** Soft iron matrix noise: read. Return the current setting in a response. See mip_device_call. */
static inline struct mip_result mip_call_filter_soft_iron_matrix_noise_read(
    struct mip_device *device, struct mip_filter_soft_iron_matrix_noise_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_soft_iron_matrix_noise_exchange, data, 1,
                              &mip_filter_soft_iron_matrix_noise_response_codec, response);
}

/**
 * Soft iron matrix noise: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_filter_soft_iron_matrix_noise_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_soft_iron_matrix_noise_exchange, data, 1);
}

/** Soft iron matrix noise: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_soft_iron_matrix_noise_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_soft_iron_matrix_noise_exchange, data, 1);
}

/** Soft iron matrix noise: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_soft_iron_matrix_noise_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_soft_iron_matrix_noise_exchange, data, 1);
}

/**
 * Soft iron matrix noise: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_soft_iron_matrix_noise_with(
    struct mip_device *device, const struct mip_filter_soft_iron_matrix_noise *command,
    struct mip_filter_soft_iron_matrix_noise_response *response) {
    return mip_device_call(device, &mip_filter_soft_iron_matrix_noise_command, command,
                           &mip_filter_soft_iron_matrix_noise_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_enable_measurements_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_enable_measurements_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Enable or disable
 * measurements. If the command requests the response, it is stored in `response`, which may be
 * NULL.
 */
static inline mip_error mip_send_filter_enable_measurements(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_enable_measurements *command,
    struct mip_filter_enable_measurements_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_enable_measurements_command,
                           command, &mip_filter_enable_measurements_response_codec, response, now);
}

/**
 * Enable or disable measurements: write. Apply the new setting. See mip_device_call.
 *
 * - control: Measurements to use. Required for write. On the 3DM-GX5-15: only
 *   MIP_FILTER_MEASUREMENT_FLAGS_ACCEL.
 */
static inline struct mip_result mip_call_filter_enable_measurements_write(
    struct mip_device *device, mip_filter_measurement_flags control) {
    uint8_t data[3];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_16(data + 1, (uint16_t)control);
    return mip_device_send(device, &mip_filter_enable_measurements_exchange, data, 3);
}

/**
 * Enable or disable measurements: read. Return the current setting in a response. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_enable_measurements_read(
    struct mip_device *device, struct mip_filter_enable_measurements_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_enable_measurements_exchange, data, 1,
                              &mip_filter_enable_measurements_response_codec, response);
}

/**
 * Enable or disable measurements: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_filter_enable_measurements_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_enable_measurements_exchange, data, 1);
}

/** Enable or disable measurements: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_enable_measurements_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_enable_measurements_exchange, data, 1);
}

/**
 * Enable or disable measurements: default. Load the factory default setting. See mip_device_call.
 */
static inline struct mip_result
mip_call_filter_enable_measurements_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_enable_measurements_exchange, data, 1);
}

/**
 * Enable or disable measurements: calls the command with these values, including optional
 * parameters. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_enable_measurements_with(
    struct mip_device *device, const struct mip_filter_enable_measurements *command,
    struct mip_filter_enable_measurements_response *response) {
    return mip_device_call(device, &mip_filter_enable_measurements_command, command,
                           &mip_filter_enable_measurements_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_mag_noise_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_mag_noise_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Magnetometer noise. If
 * the command requests the response, it is stored in `response`, which may be NULL.
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

/**
 * Magnetometer noise: write. Apply the new setting. See mip_device_call.
 *
 * - noise: Standard deviation per axis. Elements: x, y, z. Unit: gauss. Range: greater than 0.
 *   Required for write.
 */
static inline struct mip_result mip_call_filter_mag_noise_write(struct mip_device *device,
                                                                const float noise[3]) {
    uint8_t data[13];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 1 + 4 * i, &noise[i]);
    }
    return mip_device_send(device, &mip_filter_mag_noise_exchange, data, 13);
}

/** Magnetometer noise: read. Return the current setting in a response. See mip_device_call. */
static inline struct mip_result mip_call_filter_mag_noise_read(
    struct mip_device *device, struct mip_filter_mag_noise_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_mag_noise_exchange, data, 1,
                              &mip_filter_mag_noise_response_codec, response);
}

/**
 * Magnetometer noise: save. Save the current setting to non-volatile memory. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_mag_noise_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_mag_noise_exchange, data, 1);
}

/** Magnetometer noise: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_mag_noise_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_mag_noise_exchange, data, 1);
}

/** Magnetometer noise: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_mag_noise_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_mag_noise_exchange, data, 1);
}

/**
 * Magnetometer noise: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_mag_noise_with(
    struct mip_device *device, const struct mip_filter_mag_noise *command,
    struct mip_filter_mag_noise_response *response) {
    return mip_device_call(device, &mip_filter_mag_noise_command, command,
                           &mip_filter_mag_noise_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_magnetic_declination_source_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_magnetic_declination_source_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Magnetic declination
 * source. If the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_magnetic_declination_source(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_magnetic_declination_source *command,
    struct mip_filter_magnetic_declination_source_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_magnetic_declination_source_command,
                           command, &mip_filter_magnetic_declination_source_response_codec,
                           response, now);
}

/**
 * Magnetic declination source: write. Apply the new setting. See mip_device_call.
 *
 * - source: Source of the declination. A value of enum mip_filter_mag_parameter_source. Required
 *   for write. On the 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-GV7-AHRS and 3DM-GV7-AR: only
 *   MIP_FILTER_MAG_PARAMETER_SOURCE_NONE and MIP_FILTER_MAG_PARAMETER_SOURCE_MANUAL. On the
 *   3DM-GQ7-GNSS/INS: only MIP_FILTER_MAG_PARAMETER_SOURCE_WMM and
 *   MIP_FILTER_MAG_PARAMETER_SOURCE_MANUAL.
 * - declination: Declination; used only if `source` is manual. Unit: rad. Range: -3.141592653589793
 *   to 3.141592653589793. Required for write. Uncertain: Whether it may be omitted if `source` is
 *   not manual. The manuals, that of the 3DM-GQ7 included, require it only if it is, but state one
 *   length, with the value. Sending it always fits both.
 */
static inline struct mip_result mip_call_filter_magnetic_declination_source_write(
    struct mip_device *device, enum mip_filter_mag_parameter_source source, float declination) {
    uint8_t data[6];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)source);
    mip_put_float(data + 2, &declination);
    return mip_device_send(device, &mip_filter_magnetic_declination_source_exchange, data, 6);
}

/**
 * Magnetic declination source: read. Return the current setting in a response. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_magnetic_declination_source_read(
    struct mip_device *device, struct mip_filter_magnetic_declination_source_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_magnetic_declination_source_exchange, data, 1,
                              &mip_filter_magnetic_declination_source_response_codec, response);
}

/**
 * Magnetic declination source: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_filter_magnetic_declination_source_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_magnetic_declination_source_exchange, data, 1);
}

/** Magnetic declination source: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_magnetic_declination_source_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_magnetic_declination_source_exchange, data, 1);
}

/** Magnetic declination source: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_magnetic_declination_source_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_magnetic_declination_source_exchange, data, 1);
}

/**
 * Magnetic declination source: calls the command with these values, including optional parameters.
 * See mip_device_call.
 */
static inline struct mip_result mip_call_filter_magnetic_declination_source_with(
    struct mip_device *device, const struct mip_filter_magnetic_declination_source *command,
    struct mip_filter_magnetic_declination_source_response *response) {
    return mip_device_call(device, &mip_filter_magnetic_declination_source_command, command,
                           &mip_filter_magnetic_declination_source_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_accel_magnitude_adaptive_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_accel_magnitude_adaptive_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Gravity magnitude error
 * adaptive measurement. If the command requests the response, it is stored in `response`, which may
 * be NULL.
 */
static inline mip_error mip_send_filter_accel_magnitude_adaptive(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_accel_magnitude_adaptive *command,
    struct mip_filter_accel_magnitude_adaptive_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_accel_magnitude_adaptive_command,
                           command, &mip_filter_accel_magnitude_adaptive_response_codec, response,
                           now);
}

/**
 * Gravity magnitude error adaptive measurement: write. Apply the new setting. See mip_device_call.
 *
 * - adaptive_measurement: Kind of adaptation. A value of enum
 *   mip_filter_adaptive_measurement_selector. Required for write. On the 3DM-GQ4-45, 3DM-GX3-45,
 *   3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: only
 *   MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_DISABLED and
 *   MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_FIXED.
 */
static inline struct mip_result mip_call_filter_accel_magnitude_adaptive_write(
    struct mip_device *device, enum mip_filter_adaptive_measurement_selector adaptive_measurement) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)adaptive_measurement);
    return mip_device_send(device, &mip_filter_accel_magnitude_adaptive_exchange, data, 2);
}

/**
 * Gravity magnitude error adaptive measurement: read. Return the current setting in a response. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_accel_magnitude_adaptive_read(
    struct mip_device *device, struct mip_filter_accel_magnitude_adaptive_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_accel_magnitude_adaptive_exchange, data, 1,
                              &mip_filter_accel_magnitude_adaptive_response_codec, response);
}

/**
 * Gravity magnitude error adaptive measurement: save. Save the current setting to non-volatile
 * memory. See mip_device_call.
 */
static inline struct mip_result
mip_call_filter_accel_magnitude_adaptive_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_accel_magnitude_adaptive_exchange, data, 1);
}

/**
 * Gravity magnitude error adaptive measurement: load. Load the saved setting. See mip_device_call.
 */
static inline struct mip_result
mip_call_filter_accel_magnitude_adaptive_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_accel_magnitude_adaptive_exchange, data, 1);
}

/**
 * Gravity magnitude error adaptive measurement: default. Load the factory default setting. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_filter_accel_magnitude_adaptive_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_accel_magnitude_adaptive_exchange, data, 1);
}

/**
 * Gravity magnitude error adaptive measurement: calls the command with these values, including
 * optional parameters. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_accel_magnitude_adaptive_with(
    struct mip_device *device, const struct mip_filter_accel_magnitude_adaptive *command,
    struct mip_filter_accel_magnitude_adaptive_response *response) {
    return mip_device_call(device, &mip_filter_accel_magnitude_adaptive_command, command,
                           &mip_filter_accel_magnitude_adaptive_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_mag_magnitude_adaptive_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_mag_magnitude_adaptive_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Magnetometer magnitude
 * error adaptive measurement. If the command requests the response, it is stored in `response`,
 * which may be NULL.
 */
static inline mip_error mip_send_filter_mag_magnitude_adaptive(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_mag_magnitude_adaptive *command,
    struct mip_filter_mag_magnitude_adaptive_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_mag_magnitude_adaptive_command,
                           command, &mip_filter_mag_magnitude_adaptive_response_codec, response,
                           now);
}

/**
 * Magnetometer magnitude error adaptive measurement: write. Apply the new setting. See
 * mip_device_call.
 *
 * - adaptive_measurement: Kind of adaptation. A value of enum
 *   mip_filter_adaptive_measurement_selector. Required for write. On the 3DM-GQ4-45, 3DM-GX3-45,
 *   3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: only
 *   MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_DISABLED and
 *   MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_FIXED.
 * - frequency: Cutoff frequency of the low-pass filter. Unit: Hz. Range: at least 0. Required for
 *   write.
 * - low_limit: Lower limit of the magnetic field magnitude error. Unit: gauss. Required for write.
 *   Uncertain: The unit. The SDK states m/s^2; a manual of the 3DM-GX5-45 states m/s^2 in the
 *   command and gauss in the response.
 * - high_limit: Upper limit of the magnetic field magnitude error. Unit: gauss. Required for write.
 *   Uncertain: The unit. The SDK states m/s^2; a manual of the 3DM-GX5-45 states m/s^2 in the
 *   command and gauss in the response.
 * - low_limit_uncertainty: Standard deviation at the lower limit. Unit: gauss. Range: at least 0.
 *   Required for write. Uncertain: The unit. The SDK states m/s^2; a manual of the 3DM-GX5-45
 *   states m/s^2 in the command and gauss in the response.
 * - high_limit_uncertainty: Standard deviation at the upper limit. Unit: gauss. Range: at least 0.
 *   Required for write. Uncertain: The unit. The SDK states m/s^2; a manual of the 3DM-GX5-45
 *   states m/s^2 in the command and gauss in the response.
 * - minimum_uncertainty: Smallest standard deviation. Unit: gauss. Range: at least 0. Required for
 *   write. Uncertain: The unit. The SDK states m/s^2; a manual of the 3DM-GX5-45 states m/s^2 in
 *   the command and gauss in the response.
 */
static inline struct mip_result mip_call_filter_mag_magnitude_adaptive_write(
    struct mip_device *device, enum mip_filter_adaptive_measurement_selector adaptive_measurement,
    float frequency, float low_limit, float high_limit, float low_limit_uncertainty,
    float high_limit_uncertainty, float minimum_uncertainty) {
    uint8_t data[26];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)adaptive_measurement);
    mip_put_float(data + 2, &frequency);
    mip_put_float(data + 6, &low_limit);
    mip_put_float(data + 10, &high_limit);
    mip_put_float(data + 14, &low_limit_uncertainty);
    mip_put_float(data + 18, &high_limit_uncertainty);
    mip_put_float(data + 22, &minimum_uncertainty);
    return mip_device_send(device, &mip_filter_mag_magnitude_adaptive_exchange, data, 26);
}

/**
 * Magnetometer magnitude error adaptive measurement: read. Return the current setting in a
 * response. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_mag_magnitude_adaptive_read(
    struct mip_device *device, struct mip_filter_mag_magnitude_adaptive_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_mag_magnitude_adaptive_exchange, data, 1,
                              &mip_filter_mag_magnitude_adaptive_response_codec, response);
}

/**
 * Magnetometer magnitude error adaptive measurement: save. Save the current setting to non-volatile
 * memory. See mip_device_call.
 */
static inline struct mip_result
mip_call_filter_mag_magnitude_adaptive_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_mag_magnitude_adaptive_exchange, data, 1);
}

/**
 * Magnetometer magnitude error adaptive measurement: load. Load the saved setting. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_filter_mag_magnitude_adaptive_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_mag_magnitude_adaptive_exchange, data, 1);
}

/**
 * Magnetometer magnitude error adaptive measurement: default. Load the factory default setting. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_filter_mag_magnitude_adaptive_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_mag_magnitude_adaptive_exchange, data, 1);
}

/**
 * Magnetometer magnitude error adaptive measurement: calls the command with these values, including
 * optional parameters. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_mag_magnitude_adaptive_with(
    struct mip_device *device, const struct mip_filter_mag_magnitude_adaptive *command,
    struct mip_filter_mag_magnitude_adaptive_response *response) {
    return mip_device_call(device, &mip_filter_mag_magnitude_adaptive_command, command,
                           &mip_filter_mag_magnitude_adaptive_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_mag_dip_angle_adaptive_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_mag_dip_angle_adaptive_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Magnetometer dip angle
 * error adaptive measurement. If the command requests the response, it is stored in `response`,
 * which may be NULL.
 */
static inline mip_error mip_send_filter_mag_dip_angle_adaptive(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_mag_dip_angle_adaptive *command,
    struct mip_filter_mag_dip_angle_adaptive_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_mag_dip_angle_adaptive_command,
                           command, &mip_filter_mag_dip_angle_adaptive_response_codec, response,
                           now);
}

/**
 * Magnetometer dip angle error adaptive measurement: write. Apply the new setting. See
 * mip_device_call.
 *
 * - enable: True if the adaptation is on. Required for write.
 * - frequency: Cutoff frequency of the low-pass filter. Unit: Hz. Range: at least 0. Required for
 *   write.
 * - high_limit: Upper limit of the dip angle error. Unit: rad. Required for write. Uncertain: The
 *   unit. The SDK states m/s^2; rad is inferred from the quantity.
 * - high_limit_uncertainty: Standard deviation at the upper limit. Unit: rad. Range: at least 0.
 *   Required for write. Uncertain: The unit. The SDK states m/s^2; rad is inferred from the
 *   quantity.
 * - minimum_uncertainty: Smallest standard deviation. Unit: rad. Range: at least 0. Required for
 *   write. Uncertain: The unit. The SDK states m/s^2; rad is inferred from the quantity.
 */
static inline struct mip_result mip_call_filter_mag_dip_angle_adaptive_write(
    struct mip_device *device, mip_bool enable, float frequency, float high_limit,
    float high_limit_uncertainty, float minimum_uncertainty) {
    uint8_t data[18];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)mip_truth(enable));
    mip_put_float(data + 2, &frequency);
    mip_put_float(data + 6, &high_limit);
    mip_put_float(data + 10, &high_limit_uncertainty);
    mip_put_float(data + 14, &minimum_uncertainty);
    return mip_device_send(device, &mip_filter_mag_dip_angle_adaptive_exchange, data, 18);
}

/**
 * Magnetometer dip angle error adaptive measurement: read. Return the current setting in a
 * response. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_mag_dip_angle_adaptive_read(
    struct mip_device *device, struct mip_filter_mag_dip_angle_adaptive_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_mag_dip_angle_adaptive_exchange, data, 1,
                              &mip_filter_mag_dip_angle_adaptive_response_codec, response);
}

/**
 * Magnetometer dip angle error adaptive measurement: save. Save the current setting to non-volatile
 * memory. See mip_device_call.
 */
static inline struct mip_result
mip_call_filter_mag_dip_angle_adaptive_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_mag_dip_angle_adaptive_exchange, data, 1);
}

/**
 * Magnetometer dip angle error adaptive measurement: load. Load the saved setting. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_filter_mag_dip_angle_adaptive_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_mag_dip_angle_adaptive_exchange, data, 1);
}

/**
 * Magnetometer dip angle error adaptive measurement: default. Load the factory default setting. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_filter_mag_dip_angle_adaptive_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_mag_dip_angle_adaptive_exchange, data, 1);
}

/**
 * Magnetometer dip angle error adaptive measurement: calls the command with these values, including
 * optional parameters. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_mag_dip_angle_adaptive_with(
    struct mip_device *device, const struct mip_filter_mag_dip_angle_adaptive *command,
    struct mip_filter_mag_dip_angle_adaptive_response *response) {
    return mip_device_call(device, &mip_filter_mag_dip_angle_adaptive_command, command,
                           &mip_filter_mag_dip_angle_adaptive_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_altitude_aiding_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_altitude_aiding_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Altitude aiding. If the
 * command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_altitude_aiding(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_altitude_aiding *command,
    struct mip_filter_altitude_aiding_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_altitude_aiding_command, command,
                           &mip_filter_altitude_aiding_response_codec, response, now);
}

/**
 * Altitude aiding: write. Apply the new setting. See mip_device_call.
 *
 * - selector: Source of the aiding. A value of enum mip_filter_altitude_aiding_source. Required for
 *   write.
 */
static inline struct mip_result mip_call_filter_altitude_aiding_write(
    struct mip_device *device, enum mip_filter_altitude_aiding_source selector) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)selector);
    return mip_device_send(device, &mip_filter_altitude_aiding_exchange, data, 2);
}

/** Altitude aiding: read. Return the current setting in a response. See mip_device_call. */
static inline struct mip_result mip_call_filter_altitude_aiding_read(
    struct mip_device *device, struct mip_filter_altitude_aiding_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_altitude_aiding_exchange, data, 1,
                              &mip_filter_altitude_aiding_response_codec, response);
}

/** Altitude aiding: save. Save the current setting to non-volatile memory. See mip_device_call. */
static inline struct mip_result mip_call_filter_altitude_aiding_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_altitude_aiding_exchange, data, 1);
}

/** Altitude aiding: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_altitude_aiding_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_altitude_aiding_exchange, data, 1);
}

/** Altitude aiding: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_altitude_aiding_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_altitude_aiding_exchange, data, 1);
}

/**
 * Altitude aiding: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_altitude_aiding_with(
    struct mip_device *device, const struct mip_filter_altitude_aiding *command,
    struct mip_filter_altitude_aiding_response *response) {
    return mip_device_call(device, &mip_filter_altitude_aiding_command, command,
                           &mip_filter_altitude_aiding_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_pitch_roll_aiding_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_pitch_roll_aiding_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Pitch and roll aiding. If
 * the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_pitch_roll_aiding(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_pitch_roll_aiding *command,
    struct mip_filter_pitch_roll_aiding_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_pitch_roll_aiding_command, command,
                           &mip_filter_pitch_roll_aiding_response_codec, response, now);
}

/**
 * Pitch and roll aiding: write. Apply the new setting. See mip_device_call.
 *
 * - aiding: Source of the aiding. A value of enum mip_filter_pitch_roll_aiding_source. Required for
 *   write.
 */
static inline struct mip_result mip_call_filter_pitch_roll_aiding_write(
    struct mip_device *device, enum mip_filter_pitch_roll_aiding_source aiding) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)aiding);
    return mip_device_send(device, &mip_filter_pitch_roll_aiding_exchange, data, 2);
}

/** Pitch and roll aiding: read. Return the current setting in a response. See mip_device_call. */
static inline struct mip_result mip_call_filter_pitch_roll_aiding_read(
    struct mip_device *device, struct mip_filter_pitch_roll_aiding_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_pitch_roll_aiding_exchange, data, 1,
                              &mip_filter_pitch_roll_aiding_response_codec, response);
}

/**
 * Pitch and roll aiding: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_pitch_roll_aiding_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_pitch_roll_aiding_exchange, data, 1);
}

/** Pitch and roll aiding: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_pitch_roll_aiding_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_pitch_roll_aiding_exchange, data, 1);
}

/** Pitch and roll aiding: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_pitch_roll_aiding_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_pitch_roll_aiding_exchange, data, 1);
}

/**
 * Pitch and roll aiding: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_pitch_roll_aiding_with(
    struct mip_device *device, const struct mip_filter_pitch_roll_aiding *command,
    struct mip_filter_pitch_roll_aiding_response *response) {
    return mip_device_call(device, &mip_filter_pitch_roll_aiding_command, command,
                           &mip_filter_pitch_roll_aiding_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_magnetic_inclination_source_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_magnetic_inclination_source_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Magnetic inclination
 * source. If the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_magnetic_inclination_source(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_magnetic_inclination_source *command,
    struct mip_filter_magnetic_inclination_source_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_magnetic_inclination_source_command,
                           command, &mip_filter_magnetic_inclination_source_response_codec,
                           response, now);
}

/**
 * Magnetic inclination source: write. Apply the new setting. See mip_device_call.
 *
 * - source: Source of the inclination. A value of enum mip_filter_mag_parameter_source. Required
 *   for write.
 * - inclination: Inclination; used only if `source` is manual. Unit: rad. Range:
 *   -1.5707963267948966 to 1.5707963267948966. Required for write. Uncertain: Whether it may be
 *   left out if `source` is not manual, as the manuals state for
 *   mip_filter_magnetic_declination_source. The SDK always sends it.
 */
static inline struct mip_result mip_call_filter_magnetic_inclination_source_write(
    struct mip_device *device, enum mip_filter_mag_parameter_source source, float inclination) {
    uint8_t data[6];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)source);
    mip_put_float(data + 2, &inclination);
    return mip_device_send(device, &mip_filter_magnetic_inclination_source_exchange, data, 6);
}

/**
 * Magnetic inclination source: read. Return the current setting in a response. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_magnetic_inclination_source_read(
    struct mip_device *device, struct mip_filter_magnetic_inclination_source_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_magnetic_inclination_source_exchange, data, 1,
                              &mip_filter_magnetic_inclination_source_response_codec, response);
}

/**
 * Magnetic inclination source: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_filter_magnetic_inclination_source_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_magnetic_inclination_source_exchange, data, 1);
}

/** Magnetic inclination source: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_magnetic_inclination_source_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_magnetic_inclination_source_exchange, data, 1);
}

/** Magnetic inclination source: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_magnetic_inclination_source_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_magnetic_inclination_source_exchange, data, 1);
}

/**
 * Magnetic inclination source: calls the command with these values, including optional parameters.
 * See mip_device_call.
 */
static inline struct mip_result mip_call_filter_magnetic_inclination_source_with(
    struct mip_device *device, const struct mip_filter_magnetic_inclination_source *command,
    struct mip_filter_magnetic_inclination_source_response *response) {
    return mip_device_call(device, &mip_filter_magnetic_inclination_source_command, command,
                           &mip_filter_magnetic_inclination_source_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_magnetic_magnitude_source_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_magnetic_magnitude_source_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Magnetic field magnitude
 * source. If the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_magnetic_magnitude_source(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_magnetic_magnitude_source *command,
    struct mip_filter_magnetic_magnitude_source_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_magnetic_magnitude_source_command,
                           command, &mip_filter_magnetic_magnitude_source_response_codec, response,
                           now);
}

/**
 * Magnetic field magnitude source: write. Apply the new setting. See mip_device_call.
 *
 * - source: Source of the magnitude. A value of enum mip_filter_mag_parameter_source. Required for
 *   write.
 * - magnitude: Magnitude; used only if `source` is manual. Unit: gauss. Range: at least 0. Required
 *   for write. Uncertain: Whether it may be left out if `source` is not manual, as the manuals
 *   state for mip_filter_magnetic_declination_source. The SDK always sends it.
 */
static inline struct mip_result mip_call_filter_magnetic_magnitude_source_write(
    struct mip_device *device, enum mip_filter_mag_parameter_source source, float magnitude) {
    uint8_t data[6];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)source);
    mip_put_float(data + 2, &magnitude);
    return mip_device_send(device, &mip_filter_magnetic_magnitude_source_exchange, data, 6);
}

/**
 * Magnetic field magnitude source: read. Return the current setting in a response. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_magnetic_magnitude_source_read(
    struct mip_device *device, struct mip_filter_magnetic_magnitude_source_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_magnetic_magnitude_source_exchange, data, 1,
                              &mip_filter_magnetic_magnitude_source_response_codec, response);
}

/**
 * Magnetic field magnitude source: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_filter_magnetic_magnitude_source_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_magnetic_magnitude_source_exchange, data, 1);
}

/** Magnetic field magnitude source: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_magnetic_magnitude_source_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_magnetic_magnitude_source_exchange, data, 1);
}

/**
 * Magnetic field magnitude source: default. Load the factory default setting. See mip_device_call.
 */
static inline struct mip_result
mip_call_filter_magnetic_magnitude_source_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_magnetic_magnitude_source_exchange, data, 1);
}

/**
 * Magnetic field magnitude source: calls the command with these values, including optional
 * parameters. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_magnetic_magnitude_source_with(
    struct mip_device *device, const struct mip_filter_magnetic_magnitude_source *command,
    struct mip_filter_magnetic_magnitude_source_response *response) {
    return mip_device_call(device, &mip_filter_magnetic_magnitude_source_command, command,
                           &mip_filter_magnetic_magnitude_source_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_sensor_to_vehicle_rotation_dcm_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_sensor_to_vehicle_rotation_dcm_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Sensor to vehicle
 * rotation, matrix. If the command requests the response, it is stored in `response`, which may be
 * NULL.
 */
static inline mip_error mip_send_filter_sensor_to_vehicle_rotation_dcm(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_sensor_to_vehicle_rotation_dcm *command,
    struct mip_filter_sensor_to_vehicle_rotation_dcm_response *response, uint32_t now) {
    return mip_client_send(
        client, request, packet, &mip_filter_sensor_to_vehicle_rotation_dcm_command, command,
        &mip_filter_sensor_to_vehicle_rotation_dcm_response_codec, response, now);
}

/**
 * Sensor to vehicle rotation, matrix: write. Apply the new setting. See mip_device_call.
 *
 * - dcm: Rotation matrix in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33.
 *   Unit: 1. Required for write.
 */
static inline struct mip_result mip_call_filter_sensor_to_vehicle_rotation_dcm_write(
    struct mip_device *device, const float dcm[9]) {
    uint8_t data[37];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    for (size_t i = 0; i < 9; i++) {
        mip_put_float(data + 1 + 4 * i, &dcm[i]);
    }
    return mip_device_send(device, &mip_filter_sensor_to_vehicle_rotation_dcm_exchange, data, 37);
}

/**
 * Sensor to vehicle rotation, matrix: read. Return the current setting in a response. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_sensor_to_vehicle_rotation_dcm_read(
    struct mip_device *device,
    struct mip_filter_sensor_to_vehicle_rotation_dcm_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_sensor_to_vehicle_rotation_dcm_exchange, data, 1,
                              &mip_filter_sensor_to_vehicle_rotation_dcm_response_codec, response);
}

/**
 * Sensor to vehicle rotation, matrix: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_filter_sensor_to_vehicle_rotation_dcm_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_sensor_to_vehicle_rotation_dcm_exchange, data, 1);
}

/** Sensor to vehicle rotation, matrix: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_sensor_to_vehicle_rotation_dcm_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_sensor_to_vehicle_rotation_dcm_exchange, data, 1);
}

/**
 * Sensor to vehicle rotation, matrix: default. Load the factory default setting. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_filter_sensor_to_vehicle_rotation_dcm_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_sensor_to_vehicle_rotation_dcm_exchange, data, 1);
}

/**
 * Sensor to vehicle rotation, matrix: calls the command with these values, including optional
 * parameters. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_sensor_to_vehicle_rotation_dcm_with(
    struct mip_device *device, const struct mip_filter_sensor_to_vehicle_rotation_dcm *command,
    struct mip_filter_sensor_to_vehicle_rotation_dcm_response *response) {
    return mip_device_call(device, &mip_filter_sensor_to_vehicle_rotation_dcm_command, command,
                           &mip_filter_sensor_to_vehicle_rotation_dcm_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_sensor_to_vehicle_quaternion_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_sensor_to_vehicle_quaternion_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Sensor to vehicle
 * rotation, quaternion. If the command requests the response, it is stored in `response`, which may
 * be NULL.
 */
static inline mip_error mip_send_filter_sensor_to_vehicle_quaternion(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_sensor_to_vehicle_quaternion *command,
    struct mip_filter_sensor_to_vehicle_quaternion_response *response, uint32_t now) {
    return mip_client_send(client, request, packet,
                           &mip_filter_sensor_to_vehicle_quaternion_command, command,
                           &mip_filter_sensor_to_vehicle_quaternion_response_codec, response, now);
}

/**
 * Sensor to vehicle rotation, quaternion: write. Apply the new setting. See mip_device_call.
 *
 * - q: Unit quaternion, scalar part first. Elements: w, x, y, z. Unit: 1. Range: magnitude 0.999 to
 *   1.001. Required for write.
 */
static inline struct mip_result
mip_call_filter_sensor_to_vehicle_quaternion_write(struct mip_device *device, const float q[4]) {
    uint8_t data[17];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    for (size_t i = 0; i < 4; i++) {
        mip_put_float(data + 1 + 4 * i, &q[i]);
    }
    return mip_device_send(device, &mip_filter_sensor_to_vehicle_quaternion_exchange, data, 17);
}

/**
 * Sensor to vehicle rotation, quaternion: read. Return the current setting in a response. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_sensor_to_vehicle_quaternion_read(
    struct mip_device *device, struct mip_filter_sensor_to_vehicle_quaternion_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_sensor_to_vehicle_quaternion_exchange, data, 1,
                              &mip_filter_sensor_to_vehicle_quaternion_response_codec, response);
}

/**
 * Sensor to vehicle rotation, quaternion: save. Save the current setting to non-volatile memory.
 * See mip_device_call.
 */
static inline struct mip_result
mip_call_filter_sensor_to_vehicle_quaternion_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_sensor_to_vehicle_quaternion_exchange, data, 1);
}

/** Sensor to vehicle rotation, quaternion: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_sensor_to_vehicle_quaternion_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_sensor_to_vehicle_quaternion_exchange, data, 1);
}

/**
 * Sensor to vehicle rotation, quaternion: default. Load the factory default setting. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_filter_sensor_to_vehicle_quaternion_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_sensor_to_vehicle_quaternion_exchange, data, 1);
}

/**
 * Sensor to vehicle rotation, quaternion: calls the command with these values, including optional
 * parameters. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_sensor_to_vehicle_quaternion_with(
    struct mip_device *device, const struct mip_filter_sensor_to_vehicle_quaternion *command,
    struct mip_filter_sensor_to_vehicle_quaternion_response *response) {
    return mip_device_call(device, &mip_filter_sensor_to_vehicle_quaternion_command, command,
                           &mip_filter_sensor_to_vehicle_quaternion_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_aiding_measurement_enable_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_aiding_measurement_enable_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Aiding measurement
 * control. If the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_aiding_measurement_enable(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_aiding_measurement_enable *command,
    struct mip_filter_aiding_measurement_enable_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_aiding_measurement_enable_command,
                           command, &mip_filter_aiding_measurement_enable_response_codec, response,
                           now);
}

/**
 * Aiding measurement control: write. Apply the new setting. See mip_device_call.
 *
 * - aiding_source: The source; `all` is for save, load and default. A value of
 *   mip_filter_aiding_source. On the 3DM-CV7-AHRS, 3DM-CX7-AHRS and 3DM-GV7-AHRS: only
 *   MIP_FILTER_AIDING_SOURCE_MAG, MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING and
 *   MIP_FILTER_AIDING_SOURCE_ALL. On the 3DM-CV7-AR, 3DM-CX7-AR and 3DM-GV7-AR: only
 *   MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING and MIP_FILTER_AIDING_SOURCE_ALL. On the 3DM-CV7-INS,
 *   3DM-CX7-INS and 3DM-GV7-INS: only MIP_FILTER_AIDING_SOURCE_GNSS_POSITION_VELOCITY,
 *   MIP_FILTER_AIDING_SOURCE_ALTIMETER, MIP_FILTER_AIDING_SOURCE_MAG,
 *   MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING, MIP_FILTER_AIDING_SOURCE_EXTERNAL_ALTIMETER,
 *   MIP_FILTER_AIDING_SOURCE_EXTERNAL_MAG, MIP_FILTER_AIDING_SOURCE_BODY_FRAME_VELOCITY and
 *   MIP_FILTER_AIDING_SOURCE_ALL. On the 3DM-GQ7-GNSS/INS: only
 *   MIP_FILTER_AIDING_SOURCE_GNSS_POSITION_VELOCITY, MIP_FILTER_AIDING_SOURCE_GNSS_HEADING,
 *   MIP_FILTER_AIDING_SOURCE_ALTIMETER, MIP_FILTER_AIDING_SOURCE_SPEED,
 *   MIP_FILTER_AIDING_SOURCE_MAG, MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING and
 *   MIP_FILTER_AIDING_SOURCE_ALL.
 * - enable: True if the filter uses the source. Required for write.
 */
static inline struct mip_result mip_call_filter_aiding_measurement_enable_write(
    struct mip_device *device, uint16_t aiding_source, mip_bool enable) {
    uint8_t data[4];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_16(data + 1, (uint16_t)aiding_source);
    mip_put_8(data + 3, (uint8_t)mip_truth(enable));
    return mip_device_send(device, &mip_filter_aiding_measurement_enable_exchange, data, 4);
}

/**
 * Aiding measurement control: read. Return the current setting in a response. See mip_device_call.
 *
 * - aiding_source: The source; `all` is for save, load and default. A value of
 *   mip_filter_aiding_source. On the 3DM-CV7-AHRS, 3DM-CX7-AHRS and 3DM-GV7-AHRS: only
 *   MIP_FILTER_AIDING_SOURCE_MAG, MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING and
 *   MIP_FILTER_AIDING_SOURCE_ALL. On the 3DM-CV7-AR, 3DM-CX7-AR and 3DM-GV7-AR: only
 *   MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING and MIP_FILTER_AIDING_SOURCE_ALL. On the 3DM-CV7-INS,
 *   3DM-CX7-INS and 3DM-GV7-INS: only MIP_FILTER_AIDING_SOURCE_GNSS_POSITION_VELOCITY,
 *   MIP_FILTER_AIDING_SOURCE_ALTIMETER, MIP_FILTER_AIDING_SOURCE_MAG,
 *   MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING, MIP_FILTER_AIDING_SOURCE_EXTERNAL_ALTIMETER,
 *   MIP_FILTER_AIDING_SOURCE_EXTERNAL_MAG, MIP_FILTER_AIDING_SOURCE_BODY_FRAME_VELOCITY and
 *   MIP_FILTER_AIDING_SOURCE_ALL. On the 3DM-GQ7-GNSS/INS: only
 *   MIP_FILTER_AIDING_SOURCE_GNSS_POSITION_VELOCITY, MIP_FILTER_AIDING_SOURCE_GNSS_HEADING,
 *   MIP_FILTER_AIDING_SOURCE_ALTIMETER, MIP_FILTER_AIDING_SOURCE_SPEED,
 *   MIP_FILTER_AIDING_SOURCE_MAG, MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING and
 *   MIP_FILTER_AIDING_SOURCE_ALL.
 */
static inline struct mip_result mip_call_filter_aiding_measurement_enable_read(
    struct mip_device *device, uint16_t aiding_source,
    struct mip_filter_aiding_measurement_enable_response *response) {
    uint8_t data[3];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    mip_put_16(data + 1, (uint16_t)aiding_source);
    return mip_device_request(device, &mip_filter_aiding_measurement_enable_exchange, data, 3,
                              &mip_filter_aiding_measurement_enable_response_codec, response);
}

/**
 * Aiding measurement control: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 *
 * - aiding_source: The source; `all` is for save, load and default. A value of
 *   mip_filter_aiding_source. On the 3DM-CV7-AHRS, 3DM-CX7-AHRS and 3DM-GV7-AHRS: only
 *   MIP_FILTER_AIDING_SOURCE_MAG, MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING and
 *   MIP_FILTER_AIDING_SOURCE_ALL. On the 3DM-CV7-AR, 3DM-CX7-AR and 3DM-GV7-AR: only
 *   MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING and MIP_FILTER_AIDING_SOURCE_ALL. On the 3DM-CV7-INS,
 *   3DM-CX7-INS and 3DM-GV7-INS: only MIP_FILTER_AIDING_SOURCE_GNSS_POSITION_VELOCITY,
 *   MIP_FILTER_AIDING_SOURCE_ALTIMETER, MIP_FILTER_AIDING_SOURCE_MAG,
 *   MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING, MIP_FILTER_AIDING_SOURCE_EXTERNAL_ALTIMETER,
 *   MIP_FILTER_AIDING_SOURCE_EXTERNAL_MAG, MIP_FILTER_AIDING_SOURCE_BODY_FRAME_VELOCITY and
 *   MIP_FILTER_AIDING_SOURCE_ALL. On the 3DM-GQ7-GNSS/INS: only
 *   MIP_FILTER_AIDING_SOURCE_GNSS_POSITION_VELOCITY, MIP_FILTER_AIDING_SOURCE_GNSS_HEADING,
 *   MIP_FILTER_AIDING_SOURCE_ALTIMETER, MIP_FILTER_AIDING_SOURCE_SPEED,
 *   MIP_FILTER_AIDING_SOURCE_MAG, MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING and
 *   MIP_FILTER_AIDING_SOURCE_ALL.
 */
static inline struct mip_result
mip_call_filter_aiding_measurement_enable_save(struct mip_device *device, uint16_t aiding_source) {
    uint8_t data[3];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    mip_put_16(data + 1, (uint16_t)aiding_source);
    return mip_device_send(device, &mip_filter_aiding_measurement_enable_exchange, data, 3);
}

/**
 * Aiding measurement control: load. Load the saved setting. See mip_device_call.
 *
 * - aiding_source: The source; `all` is for save, load and default. A value of
 *   mip_filter_aiding_source. On the 3DM-CV7-AHRS, 3DM-CX7-AHRS and 3DM-GV7-AHRS: only
 *   MIP_FILTER_AIDING_SOURCE_MAG, MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING and
 *   MIP_FILTER_AIDING_SOURCE_ALL. On the 3DM-CV7-AR, 3DM-CX7-AR and 3DM-GV7-AR: only
 *   MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING and MIP_FILTER_AIDING_SOURCE_ALL. On the 3DM-CV7-INS,
 *   3DM-CX7-INS and 3DM-GV7-INS: only MIP_FILTER_AIDING_SOURCE_GNSS_POSITION_VELOCITY,
 *   MIP_FILTER_AIDING_SOURCE_ALTIMETER, MIP_FILTER_AIDING_SOURCE_MAG,
 *   MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING, MIP_FILTER_AIDING_SOURCE_EXTERNAL_ALTIMETER,
 *   MIP_FILTER_AIDING_SOURCE_EXTERNAL_MAG, MIP_FILTER_AIDING_SOURCE_BODY_FRAME_VELOCITY and
 *   MIP_FILTER_AIDING_SOURCE_ALL. On the 3DM-GQ7-GNSS/INS: only
 *   MIP_FILTER_AIDING_SOURCE_GNSS_POSITION_VELOCITY, MIP_FILTER_AIDING_SOURCE_GNSS_HEADING,
 *   MIP_FILTER_AIDING_SOURCE_ALTIMETER, MIP_FILTER_AIDING_SOURCE_SPEED,
 *   MIP_FILTER_AIDING_SOURCE_MAG, MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING and
 *   MIP_FILTER_AIDING_SOURCE_ALL.
 */
static inline struct mip_result
mip_call_filter_aiding_measurement_enable_load(struct mip_device *device, uint16_t aiding_source) {
    uint8_t data[3];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    mip_put_16(data + 1, (uint16_t)aiding_source);
    return mip_device_send(device, &mip_filter_aiding_measurement_enable_exchange, data, 3);
}

/**
 * Aiding measurement control: default. Load the factory default setting. See mip_device_call.
 *
 * - aiding_source: The source; `all` is for save, load and default. A value of
 *   mip_filter_aiding_source. On the 3DM-CV7-AHRS, 3DM-CX7-AHRS and 3DM-GV7-AHRS: only
 *   MIP_FILTER_AIDING_SOURCE_MAG, MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING and
 *   MIP_FILTER_AIDING_SOURCE_ALL. On the 3DM-CV7-AR, 3DM-CX7-AR and 3DM-GV7-AR: only
 *   MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING and MIP_FILTER_AIDING_SOURCE_ALL. On the 3DM-CV7-INS,
 *   3DM-CX7-INS and 3DM-GV7-INS: only MIP_FILTER_AIDING_SOURCE_GNSS_POSITION_VELOCITY,
 *   MIP_FILTER_AIDING_SOURCE_ALTIMETER, MIP_FILTER_AIDING_SOURCE_MAG,
 *   MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING, MIP_FILTER_AIDING_SOURCE_EXTERNAL_ALTIMETER,
 *   MIP_FILTER_AIDING_SOURCE_EXTERNAL_MAG, MIP_FILTER_AIDING_SOURCE_BODY_FRAME_VELOCITY and
 *   MIP_FILTER_AIDING_SOURCE_ALL. On the 3DM-GQ7-GNSS/INS: only
 *   MIP_FILTER_AIDING_SOURCE_GNSS_POSITION_VELOCITY, MIP_FILTER_AIDING_SOURCE_GNSS_HEADING,
 *   MIP_FILTER_AIDING_SOURCE_ALTIMETER, MIP_FILTER_AIDING_SOURCE_SPEED,
 *   MIP_FILTER_AIDING_SOURCE_MAG, MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING and
 *   MIP_FILTER_AIDING_SOURCE_ALL.
 */
static inline struct mip_result mip_call_filter_aiding_measurement_enable_default(
    struct mip_device *device, uint16_t aiding_source) {
    uint8_t data[3];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    mip_put_16(data + 1, (uint16_t)aiding_source);
    return mip_device_send(device, &mip_filter_aiding_measurement_enable_exchange, data, 3);
}

/**
 * Aiding measurement control: calls the command with these values, including optional parameters.
 * See mip_device_call.
 */
static inline struct mip_result mip_call_filter_aiding_measurement_enable_with(
    struct mip_device *device, const struct mip_filter_aiding_measurement_enable *command,
    struct mip_filter_aiding_measurement_enable_response *response) {
    return mip_device_call(device, &mip_filter_aiding_measurement_enable_command, command,
                           &mip_filter_aiding_measurement_enable_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_kinematic_constraint_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_kinematic_constraint_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Kinematic constraint. If
 * the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_kinematic_constraint(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_kinematic_constraint *command,
    struct mip_filter_kinematic_constraint_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_kinematic_constraint_command,
                           command, &mip_filter_kinematic_constraint_response_codec, response, now);
}

/**
 * Kinematic constraint: write. Apply the new setting. See mip_device_call.
 *
 * - accel_constraint: Assumption about the acceleration. A value of enum
 *   mip_filter_accel_constraint. Default: MIP_FILTER_ACCEL_CONSTRAINT_NONE. Required for write.
 * - velocity_constraint: Assumption about the velocity. A value of enum
 *   mip_filter_velocity_constraint. Default: MIP_FILTER_VELOCITY_CONSTRAINT_NONE. Required for
 *   write.
 * - angular_constraint: Assumption about the angular rate. A value of enum
 *   mip_filter_angular_constraint. Default: MIP_FILTER_ANGULAR_CONSTRAINT_NONE. Required for write.
 */
static inline struct mip_result mip_call_filter_kinematic_constraint_write(
    struct mip_device *device, enum mip_filter_accel_constraint accel_constraint,
    enum mip_filter_velocity_constraint velocity_constraint,
    enum mip_filter_angular_constraint angular_constraint) {
    uint8_t data[4];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)accel_constraint);
    mip_put_8(data + 2, (uint8_t)velocity_constraint);
    mip_put_8(data + 3, (uint8_t)angular_constraint);
    return mip_device_send(device, &mip_filter_kinematic_constraint_exchange, data, 4);
}

/** Kinematic constraint: read. Return the current setting in a response. See mip_device_call. */
static inline struct mip_result mip_call_filter_kinematic_constraint_read(
    struct mip_device *device, struct mip_filter_kinematic_constraint_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_kinematic_constraint_exchange, data, 1,
                              &mip_filter_kinematic_constraint_response_codec, response);
}

/**
 * Kinematic constraint: save. Save the current setting to non-volatile memory. See mip_device_call.
 */
static inline struct mip_result
mip_call_filter_kinematic_constraint_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_kinematic_constraint_exchange, data, 1);
}

/** Kinematic constraint: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_kinematic_constraint_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_kinematic_constraint_exchange, data, 1);
}

/** Kinematic constraint: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_kinematic_constraint_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_kinematic_constraint_exchange, data, 1);
}

/**
 * Kinematic constraint: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_kinematic_constraint_with(
    struct mip_device *device, const struct mip_filter_kinematic_constraint *command,
    struct mip_filter_kinematic_constraint_response *response) {
    return mip_device_call(device, &mip_filter_kinematic_constraint_command, command,
                           &mip_filter_kinematic_constraint_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_initialization_config_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_initialization_config_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Navigation filter
 * initialization. If the command requests the response, it is stored in `response`, which may be
 * NULL.
 */
static inline mip_error mip_send_filter_initialization_config(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_initialization_config *command,
    struct mip_filter_initialization_config_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_initialization_config_command,
                           command, &mip_filter_initialization_config_response_codec, response,
                           now);
}

/**
 * Navigation filter initialization: write. Apply the new setting. See mip_device_call.
 *
 * - wait_for_run_command: 1: the filter starts only after mip_filter_run; 0: it starts as soon as
 *   it can. Range: 0 to 1. Required for write.
 * - initial_condition_source: Initial conditions that your program provides instead of the device.
 *   A value of enum mip_filter_initial_condition_source. Required for write.
 * - auto_heading_alignment_selector: Methods that may be used to determine the initial heading.
 *   Required for write. On the 3DM-CV7-INS, 3DM-CX7-INS and 3DM-GV7-INS: only
 *   MIP_FILTER_HEADING_ALIGNMENT_KINEMATIC, MIP_FILTER_HEADING_ALIGNMENT_MAG and
 *   MIP_FILTER_HEADING_ALIGNMENT_EXTERNAL. On the 3DM-GQ7-GNSS/INS: only
 *   MIP_FILTER_HEADING_ALIGNMENT_DUAL_ANTENNA, MIP_FILTER_HEADING_ALIGNMENT_KINEMATIC and
 *   MIP_FILTER_HEADING_ALIGNMENT_MAG.
 * - initial_heading: Initial heading that your program provides. Unit: deg. Required for write.
 * - initial_pitch: Initial pitch that your program provides. Unit: deg. Required for write.
 * - initial_roll: Initial roll that your program provides. Unit: deg. Required for write.
 * - initial_position: Initial position that your program provides. Elements: x, y, z. Required for
 *   write. If reference_frame_selector is MIP_FILTER_REFERENCE_FRAME_ECEF: unit m; frame ecef. If
 *   reference_frame_selector is MIP_FILTER_REFERENCE_FRAME_LLH: elements latitude, longitude,
 *   height; unit deg, deg, m; frame llh.
 * - initial_velocity: Initial velocity that your program provides. Elements: x, y, z. Unit: m/s.
 *   Required for write. If reference_frame_selector is MIP_FILTER_REFERENCE_FRAME_ECEF: frame ecef.
 *   If reference_frame_selector is MIP_FILTER_REFERENCE_FRAME_LLH: elements north, east, down;
 *   frame ned.
 * - reference_frame_selector: Frame of the initial position and velocity. A value of enum
 *   mip_filter_reference_frame. Required for write.
 */
static inline struct mip_result mip_call_filter_initialization_config_write(
    struct mip_device *device, uint8_t wait_for_run_command,
    enum mip_filter_initial_condition_source initial_condition_source,
    mip_filter_heading_alignment auto_heading_alignment_selector, float initial_heading,
    float initial_pitch, float initial_roll, const float initial_position[3],
    const float initial_velocity[3], enum mip_filter_reference_frame reference_frame_selector) {
    uint8_t data[41];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)wait_for_run_command);
    mip_put_8(data + 2, (uint8_t)initial_condition_source);
    mip_put_8(data + 3, (uint8_t)auto_heading_alignment_selector);
    mip_put_float(data + 4, &initial_heading);
    mip_put_float(data + 8, &initial_pitch);
    mip_put_float(data + 12, &initial_roll);
    mip_put_8(data + 40, (uint8_t)reference_frame_selector);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 16 + 4 * i, &initial_position[i]);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 28 + 4 * i, &initial_velocity[i]);
    }
    return mip_device_send(device, &mip_filter_initialization_config_exchange, data, 41);
}

/**
 * Navigation filter initialization: read. Return the current setting in a response. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_initialization_config_read(
    struct mip_device *device, struct mip_filter_initialization_config_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_initialization_config_exchange, data, 1,
                              &mip_filter_initialization_config_response_codec, response);
}

/**
 * Navigation filter initialization: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_filter_initialization_config_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_initialization_config_exchange, data, 1);
}

/** Navigation filter initialization: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_initialization_config_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_initialization_config_exchange, data, 1);
}

/**
 * Navigation filter initialization: default. Load the factory default setting. See mip_device_call.
 */
static inline struct mip_result
mip_call_filter_initialization_config_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_initialization_config_exchange, data, 1);
}

/**
 * Navigation filter initialization: calls the command with these values, including optional
 * parameters. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_initialization_config_with(
    struct mip_device *device, const struct mip_filter_initialization_config *command,
    struct mip_filter_initialization_config_response *response) {
    return mip_device_call(device, &mip_filter_initialization_config_command, command,
                           &mip_filter_initialization_config_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_adaptive_filter_options_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_adaptive_filter_options_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Adaptive filter control.
 * If the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_adaptive_filter_options(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_adaptive_filter_options *command,
    struct mip_filter_adaptive_filter_options_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_adaptive_filter_options_command,
                           command, &mip_filter_adaptive_filter_options_response_codec, response,
                           now);
}

/**
 * Adaptive filter control: write. Apply the new setting. See mip_device_call.
 *
 * - level: Strength of the adaptation. A value of enum mip_filter_adaptive_level. Default: 2.
 *   Required for write. On the 3DM-GX5-45: only MIP_FILTER_ADAPTIVE_LEVEL_OFF and
 *   MIP_FILTER_ADAPTIVE_LEVEL_MODERATE.
 * - time_limit: Longest time for which measurements are rejected before the filter recovers. Unit:
 *   ms. Required for write.
 */
static inline struct mip_result mip_call_filter_adaptive_filter_options_write(
    struct mip_device *device, enum mip_filter_adaptive_level level, uint16_t time_limit) {
    uint8_t data[4];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)level);
    mip_put_16(data + 2, (uint16_t)time_limit);
    return mip_device_send(device, &mip_filter_adaptive_filter_options_exchange, data, 4);
}

/** Adaptive filter control: read. Return the current setting in a response. See mip_device_call. */
static inline struct mip_result mip_call_filter_adaptive_filter_options_read(
    struct mip_device *device, struct mip_filter_adaptive_filter_options_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_adaptive_filter_options_exchange, data, 1,
                              &mip_filter_adaptive_filter_options_response_codec, response);
}

/**
 * Adaptive filter control: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_filter_adaptive_filter_options_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_adaptive_filter_options_exchange, data, 1);
}

/** Adaptive filter control: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_adaptive_filter_options_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_adaptive_filter_options_exchange, data, 1);
}

/** Adaptive filter control: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_adaptive_filter_options_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_adaptive_filter_options_exchange, data, 1);
}

/**
 * Adaptive filter control: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_adaptive_filter_options_with(
    struct mip_device *device, const struct mip_filter_adaptive_filter_options *command,
    struct mip_filter_adaptive_filter_options_response *response) {
    return mip_device_call(device, &mip_filter_adaptive_filter_options_command, command,
                           &mip_filter_adaptive_filter_options_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_multi_antenna_offset_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_multi_antenna_offset_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. GNSS multi-antenna
 * offset. If the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_multi_antenna_offset(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_multi_antenna_offset *command,
    struct mip_filter_multi_antenna_offset_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_multi_antenna_offset_command,
                           command, &mip_filter_multi_antenna_offset_response_codec, response, now);
}

/**
 * GNSS multi-antenna offset: write. Apply the new setting. See mip_device_call.
 *
 * - receiver_id: Number of the receiver, from 1. Range: at least 1.
 * - antenna_offset: Vector from the sensor to the antenna. Elements: x, y, z. Unit: m. Frame:
 *   vehicle. Range: magnitude at most 10. Required for write.
 */
static inline struct mip_result mip_call_filter_multi_antenna_offset_write(
    struct mip_device *device, uint8_t receiver_id, const float antenna_offset[3]) {
    uint8_t data[14];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)receiver_id);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 2 + 4 * i, &antenna_offset[i]);
    }
    return mip_device_send(device, &mip_filter_multi_antenna_offset_exchange, data, 14);
}

/**
 * GNSS multi-antenna offset: read. Return the current setting in a response. See mip_device_call.
 *
 * - receiver_id: Number of the receiver, from 1. Range: at least 1.
 */
static inline struct mip_result mip_call_filter_multi_antenna_offset_read(
    struct mip_device *device, uint8_t receiver_id,
    struct mip_filter_multi_antenna_offset_response *response) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    mip_put_8(data + 1, (uint8_t)receiver_id);
    return mip_device_request(device, &mip_filter_multi_antenna_offset_exchange, data, 2,
                              &mip_filter_multi_antenna_offset_response_codec, response);
}

/**
 * GNSS multi-antenna offset: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 *
 * - receiver_id: Number of the receiver, from 1. Range: at least 1.
 */
static inline struct mip_result mip_call_filter_multi_antenna_offset_save(struct mip_device *device,
                                                                          uint8_t receiver_id) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    mip_put_8(data + 1, (uint8_t)receiver_id);
    return mip_device_send(device, &mip_filter_multi_antenna_offset_exchange, data, 2);
}

/**
 * GNSS multi-antenna offset: load. Load the saved setting. See mip_device_call.
 *
 * - receiver_id: Number of the receiver, from 1. Range: at least 1.
 */
static inline struct mip_result mip_call_filter_multi_antenna_offset_load(struct mip_device *device,
                                                                          uint8_t receiver_id) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    mip_put_8(data + 1, (uint8_t)receiver_id);
    return mip_device_send(device, &mip_filter_multi_antenna_offset_exchange, data, 2);
}

/**
 * GNSS multi-antenna offset: default. Load the factory default setting. See mip_device_call.
 *
 * - receiver_id: Number of the receiver, from 1. Range: at least 1.
 */
static inline struct mip_result
mip_call_filter_multi_antenna_offset_default(struct mip_device *device, uint8_t receiver_id) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    mip_put_8(data + 1, (uint8_t)receiver_id);
    return mip_device_send(device, &mip_filter_multi_antenna_offset_exchange, data, 2);
}

/**
 * GNSS multi-antenna offset: calls the command with these values, including optional parameters.
 * See mip_device_call.
 */
static inline struct mip_result mip_call_filter_multi_antenna_offset_with(
    struct mip_device *device, const struct mip_filter_multi_antenna_offset *command,
    struct mip_filter_multi_antenna_offset_response *response) {
    return mip_device_call(device, &mip_filter_multi_antenna_offset_command, command,
                           &mip_filter_multi_antenna_offset_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_relative_position_config_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_relative_position_config_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Relative position
 * configuration. If the command requests the response, it is stored in `response`, which may be
 * NULL.
 */
static inline mip_error mip_send_filter_relative_position_config(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_relative_position_config *command,
    struct mip_filter_relative_position_config_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_relative_position_config_command,
                           command, &mip_filter_relative_position_config_response_codec, response,
                           now);
}

/**
 * Relative position configuration: write. Apply the new setting. See mip_device_call.
 *
 * - source: Source of the reference point. A value of enum mip_filter_relative_position_source.
 *   Required for write.
 * - reference_frame_selector: Frame of the coordinates. A value of enum mip_filter_reference_frame.
 *   Required for write.
 * - reference_coordinates: Reference point. Elements: x, y, z. Required for write. If
 *   reference_frame_selector is MIP_FILTER_REFERENCE_FRAME_ECEF: unit m; frame ecef. If
 *   reference_frame_selector is MIP_FILTER_REFERENCE_FRAME_LLH: elements latitude, longitude,
 *   height; unit deg, deg, m; frame llh.
 */
static inline struct mip_result mip_call_filter_relative_position_config_write(
    struct mip_device *device, enum mip_filter_relative_position_source source,
    enum mip_filter_reference_frame reference_frame_selector,
    const double reference_coordinates[3]) {
    uint8_t data[27];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)source);
    mip_put_8(data + 2, (uint8_t)reference_frame_selector);
    for (size_t i = 0; i < 3; i++) {
        mip_put_double(data + 3 + 8 * i, &reference_coordinates[i]);
    }
    return mip_device_send(device, &mip_filter_relative_position_config_exchange, data, 27);
}

/**
 * Relative position configuration: read. Return the current setting in a response. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_relative_position_config_read(
    struct mip_device *device, struct mip_filter_relative_position_config_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_relative_position_config_exchange, data, 1,
                              &mip_filter_relative_position_config_response_codec, response);
}

/**
 * Relative position configuration: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_filter_relative_position_config_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_relative_position_config_exchange, data, 1);
}

/** Relative position configuration: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_relative_position_config_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_relative_position_config_exchange, data, 1);
}

/**
 * Relative position configuration: default. Load the factory default setting. See mip_device_call.
 */
static inline struct mip_result
mip_call_filter_relative_position_config_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_relative_position_config_exchange, data, 1);
}

/**
 * Relative position configuration: calls the command with these values, including optional
 * parameters. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_relative_position_config_with(
    struct mip_device *device, const struct mip_filter_relative_position_config *command,
    struct mip_filter_relative_position_config_response *response) {
    return mip_device_call(device, &mip_filter_relative_position_config_command, command,
                           &mip_filter_relative_position_config_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_reference_point_lever_arm_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_reference_point_lever_arm_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Reference point lever
 * arm. If the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_reference_point_lever_arm(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_reference_point_lever_arm *command,
    struct mip_filter_reference_point_lever_arm_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_reference_point_lever_arm_command,
                           command, &mip_filter_reference_point_lever_arm_response_codec, response,
                           now);
}

/**
 * Reference point lever arm: write. Apply the new setting. See mip_device_call.
 *
 * - reference_point: Point to move; it must be 1. A value of enum mip_filter_reference_point.
 *   Required for write.
 * - lever_arm_offset: Vector from the sensor to the point. Elements: x, y, z. Unit: m. Frame:
 *   vehicle. Range: magnitude at most 10. Required for write.
 */
static inline struct mip_result mip_call_filter_reference_point_lever_arm_write(
    struct mip_device *device, enum mip_filter_reference_point reference_point,
    const float lever_arm_offset[3]) {
    uint8_t data[14];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)reference_point);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 2 + 4 * i, &lever_arm_offset[i]);
    }
    return mip_device_send(device, &mip_filter_reference_point_lever_arm_exchange, data, 14);
}

/**
 * Reference point lever arm: read. Return the current setting in a response. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_reference_point_lever_arm_read(
    struct mip_device *device, struct mip_filter_reference_point_lever_arm_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_reference_point_lever_arm_exchange, data, 1,
                              &mip_filter_reference_point_lever_arm_response_codec, response);
}

/**
 * Reference point lever arm: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_filter_reference_point_lever_arm_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_reference_point_lever_arm_exchange, data, 1);
}

/** Reference point lever arm: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_reference_point_lever_arm_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_reference_point_lever_arm_exchange, data, 1);
}

/** Reference point lever arm: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_reference_point_lever_arm_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_reference_point_lever_arm_exchange, data, 1);
}

/**
 * Reference point lever arm: calls the command with these values, including optional parameters.
 * See mip_device_call.
 */
static inline struct mip_result mip_call_filter_reference_point_lever_arm_with(
    struct mip_device *device, const struct mip_filter_reference_point_lever_arm *command,
    struct mip_filter_reference_point_lever_arm_response *response) {
    return mip_device_call(device, &mip_filter_reference_point_lever_arm_command, command,
                           &mip_filter_reference_point_lever_arm_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_speed_measurement_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_speed_measurement_exchange;

/** Adds the command to a packet and tracks its reply: see mip_client_send. Speed measurement. */
static inline mip_error mip_send_filter_speed_measurement(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_speed_measurement *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_speed_measurement_command, command,
                           NULL, NULL, now);
}

/**
 * Speed measurement. See mip_device_call.
 *
 * - tow: GPS time of week of the measurement. Unit: s. Range: 0 to 604800. Uncertain: The unit; the
 *   SDK states none.
 * - speed: Speed, negative in reverse. Unit: m/s. Frame: vehicle.
 * - speed_uncertainty: Standard deviation of the speed. Unit: m/s. Range: at least 0.
 */
static inline struct mip_result mip_call_filter_speed_measurement(struct mip_device *device,
                                                                  float tow, float speed,
                                                                  float speed_uncertainty) {
    uint8_t data[13];
    mip_put_8(data, (uint8_t)1);
    mip_put_float(data + 1, &tow);
    mip_put_float(data + 5, &speed);
    mip_put_float(data + 9, &speed_uncertainty);
    return mip_device_send(device, &mip_filter_speed_measurement_exchange, data, 13);
}

/**
 * Speed measurement: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_speed_measurement_with(
    struct mip_device *device, const struct mip_filter_speed_measurement *command) {
    return mip_device_call(device, &mip_filter_speed_measurement_command, command, NULL, NULL);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_speed_lever_arm_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_speed_lever_arm_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Speed measurement lever
 * arm. If the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_speed_lever_arm(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_speed_lever_arm *command,
    struct mip_filter_speed_lever_arm_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_speed_lever_arm_command, command,
                           &mip_filter_speed_lever_arm_response_codec, response, now);
}

/**
 * Speed measurement lever arm: write. Apply the new setting. See mip_device_call.
 *
 * - lever_arm_offset: Vector from the sensor to the point of measurement. Elements: x, y, z. Unit:
 *   m. Frame: vehicle. Required for write.
 */
static inline struct mip_result
mip_call_filter_speed_lever_arm_write(struct mip_device *device, const float lever_arm_offset[3]) {
    uint8_t data[14];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)1);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 2 + 4 * i, &lever_arm_offset[i]);
    }
    return mip_device_send(device, &mip_filter_speed_lever_arm_exchange, data, 14);
}

/**
 * Speed measurement lever arm: read. Return the current setting in a response. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_speed_lever_arm_read(
    struct mip_device *device, struct mip_filter_speed_lever_arm_response *response) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    mip_put_8(data + 1, (uint8_t)1);
    return mip_device_request(device, &mip_filter_speed_lever_arm_exchange, data, 2,
                              &mip_filter_speed_lever_arm_response_codec, response);
}

/**
 * Speed measurement lever arm: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_speed_lever_arm_save(struct mip_device *device) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    mip_put_8(data + 1, (uint8_t)1);
    return mip_device_send(device, &mip_filter_speed_lever_arm_exchange, data, 2);
}

/** Speed measurement lever arm: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_speed_lever_arm_load(struct mip_device *device) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    mip_put_8(data + 1, (uint8_t)1);
    return mip_device_send(device, &mip_filter_speed_lever_arm_exchange, data, 2);
}

/** Speed measurement lever arm: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result mip_call_filter_speed_lever_arm_default(struct mip_device *device) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    mip_put_8(data + 1, (uint8_t)1);
    return mip_device_send(device, &mip_filter_speed_lever_arm_exchange, data, 2);
}

/**
 * Speed measurement lever arm: calls the command with these values, including optional parameters.
 * See mip_device_call.
 */
static inline struct mip_result mip_call_filter_speed_lever_arm_with(
    struct mip_device *device, const struct mip_filter_speed_lever_arm *command,
    struct mip_filter_speed_lever_arm_response *response) {
    return mip_device_call(device, &mip_filter_speed_lever_arm_command, command,
                           &mip_filter_speed_lever_arm_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_vertical_gyro_constraint_control_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_vertical_gyro_constraint_control_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Vertical gyro constraint.
 * If the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_vertical_gyro_constraint_control(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_vertical_gyro_constraint_control *command,
    struct mip_filter_vertical_gyro_constraint_control_response *response, uint32_t now) {
    return mip_client_send(
        client, request, packet, &mip_filter_vertical_gyro_constraint_control_command, command,
        &mip_filter_vertical_gyro_constraint_control_response_codec, response, now);
}

/**
 * Vertical gyro constraint: write. Apply the new setting. See mip_device_call.
 *
 * - enable: 0 disables, 1 enables. Range: 0 to 1. Required for write.
 */
static inline struct mip_result
mip_call_filter_vertical_gyro_constraint_control_write(struct mip_device *device, uint8_t enable) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)enable);
    return mip_device_send(device, &mip_filter_vertical_gyro_constraint_control_exchange, data, 2);
}

/**
 * Vertical gyro constraint: read. Return the current setting in a response. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_vertical_gyro_constraint_control_read(
    struct mip_device *device,
    struct mip_filter_vertical_gyro_constraint_control_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_vertical_gyro_constraint_control_exchange, data,
                              1, &mip_filter_vertical_gyro_constraint_control_response_codec,
                              response);
}

/**
 * Vertical gyro constraint: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_filter_vertical_gyro_constraint_control_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_vertical_gyro_constraint_control_exchange, data, 1);
}

/** Vertical gyro constraint: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_vertical_gyro_constraint_control_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_vertical_gyro_constraint_control_exchange, data, 1);
}

/** Vertical gyro constraint: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_vertical_gyro_constraint_control_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_vertical_gyro_constraint_control_exchange, data, 1);
}

/**
 * Vertical gyro constraint: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_vertical_gyro_constraint_control_with(
    struct mip_device *device, const struct mip_filter_vertical_gyro_constraint_control *command,
    struct mip_filter_vertical_gyro_constraint_control_response *response) {
    return mip_device_call(device, &mip_filter_vertical_gyro_constraint_control_command, command,
                           &mip_filter_vertical_gyro_constraint_control_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_wheeled_vehicle_constraint_control_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_wheeled_vehicle_constraint_control_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Wheeled vehicle
 * constraint. If the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_wheeled_vehicle_constraint_control(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_wheeled_vehicle_constraint_control *command,
    struct mip_filter_wheeled_vehicle_constraint_control_response *response, uint32_t now) {
    return mip_client_send(
        client, request, packet, &mip_filter_wheeled_vehicle_constraint_control_command, command,
        &mip_filter_wheeled_vehicle_constraint_control_response_codec, response, now);
}

/**
 * Wheeled vehicle constraint: write. Apply the new setting. See mip_device_call.
 *
 * - enable: 0 disables, 1 enables. Range: 0 to 1. Required for write.
 */
static inline struct mip_result mip_call_filter_wheeled_vehicle_constraint_control_write(
    struct mip_device *device, uint8_t enable) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)enable);
    return mip_device_send(device, &mip_filter_wheeled_vehicle_constraint_control_exchange, data,
                           2);
}

/**
 * Wheeled vehicle constraint: read. Return the current setting in a response. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_wheeled_vehicle_constraint_control_read(
    struct mip_device *device,
    struct mip_filter_wheeled_vehicle_constraint_control_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_wheeled_vehicle_constraint_control_exchange, data,
                              1, &mip_filter_wheeled_vehicle_constraint_control_response_codec,
                              response);
}

/**
 * Wheeled vehicle constraint: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_filter_wheeled_vehicle_constraint_control_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_wheeled_vehicle_constraint_control_exchange, data,
                           1);
}

/** Wheeled vehicle constraint: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_wheeled_vehicle_constraint_control_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_wheeled_vehicle_constraint_control_exchange, data,
                           1);
}

/** Wheeled vehicle constraint: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_wheeled_vehicle_constraint_control_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_wheeled_vehicle_constraint_control_exchange, data,
                           1);
}

/**
 * Wheeled vehicle constraint: calls the command with these values, including optional parameters.
 * See mip_device_call.
 */
static inline struct mip_result mip_call_filter_wheeled_vehicle_constraint_control_with(
    struct mip_device *device, const struct mip_filter_wheeled_vehicle_constraint_control *command,
    struct mip_filter_wheeled_vehicle_constraint_control_response *response) {
    return mip_device_call(device, &mip_filter_wheeled_vehicle_constraint_control_command, command,
                           &mip_filter_wheeled_vehicle_constraint_control_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_filter_gnss_antenna_calibration_control_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_filter_gnss_antenna_calibration_control_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. GNSS antenna offset
 * calibration. If the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_filter_gnss_antenna_calibration_control(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_gnss_antenna_calibration_control *command,
    struct mip_filter_gnss_antenna_calibration_control_response *response, uint32_t now) {
    return mip_client_send(
        client, request, packet, &mip_filter_gnss_antenna_calibration_control_command, command,
        &mip_filter_gnss_antenna_calibration_control_response_codec, response, now);
}

/**
 * GNSS antenna offset calibration: write. Apply the new setting. See mip_device_call.
 *
 * - enable: 0 disables, 1 enables. Range: 0 to 1. Required for write.
 * - max_offset: Largest absolute error that is tracked. Unit: m. Frame: vehicle. Range: at least 0.
 *   Required for write. On the 3DM-CV7-GNSS/INS: range 0 to 0.5; default 0.1.
 */
static inline struct mip_result mip_call_filter_gnss_antenna_calibration_control_write(
    struct mip_device *device, uint8_t enable, float max_offset) {
    uint8_t data[6];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)enable);
    mip_put_float(data + 2, &max_offset);
    return mip_device_send(device, &mip_filter_gnss_antenna_calibration_control_exchange, data, 6);
}

/**
 * GNSS antenna offset calibration: read. Return the current setting in a response. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_filter_gnss_antenna_calibration_control_read(
    struct mip_device *device,
    struct mip_filter_gnss_antenna_calibration_control_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_filter_gnss_antenna_calibration_control_exchange, data,
                              1, &mip_filter_gnss_antenna_calibration_control_response_codec,
                              response);
}

/**
 * GNSS antenna offset calibration: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_filter_gnss_antenna_calibration_control_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_filter_gnss_antenna_calibration_control_exchange, data, 1);
}

/** GNSS antenna offset calibration: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result
mip_call_filter_gnss_antenna_calibration_control_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_filter_gnss_antenna_calibration_control_exchange, data, 1);
}

/**
 * GNSS antenna offset calibration: default. Load the factory default setting. See mip_device_call.
 */
static inline struct mip_result
mip_call_filter_gnss_antenna_calibration_control_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_filter_gnss_antenna_calibration_control_exchange, data, 1);
}

/**
 * GNSS antenna offset calibration: calls the command with these values, including optional
 * parameters. See mip_device_call.
 */
static inline struct mip_result mip_call_filter_gnss_antenna_calibration_control_with(
    struct mip_device *device, const struct mip_filter_gnss_antenna_calibration_control *command,
    struct mip_filter_gnss_antenna_calibration_control_response *response) {
    return mip_device_call(device, &mip_filter_gnss_antenna_calibration_control_command, command,
                           &mip_filter_gnss_antenna_calibration_control_response_codec, response);
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
