/**
 * @file
 * The commands of Filter commands, each with the types of its parameters and of its response.
 */
#ifndef MIP_FILTER_COMMANDS_H
#define MIP_FILTER_COMMANDS_H

#include "mip/filter.h"
#include "mip/device.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/filter_commands.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_filter Filter commands (0x0D)
 * @{ */

MIP_COMMAND_REPLIES(mip_filter_reset);

/** Reset navigation filter: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_filter_reset(struct mip_client *client,
                                              struct mip_request *request,
                                              struct mip_builder *packet, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_reset_command, NULL, NULL, NULL,
                           now);
}

/** Reset navigation filter. */
static inline struct mip_result mip_call_filter_reset(struct mip_device *device) {
    return mip_device_send(device, &mip_filter_reset_exchange,
                           MIP_NO_DATA(mip_filter_reset_exchange), 0);
}

MIP_COMMAND_REPLIES(mip_filter_set_initial_attitude);

/** Set initial attitude: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_filter_set_initial_attitude(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_set_initial_attitude *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_set_initial_attitude_command,
                           command, NULL, NULL, now);
}

/**
 * Set initial attitude.
 *
 * - roll: Roll angle. Unit: rad. Frame: ned. Range: -pi to pi. Positive: right side down.
 * - pitch: Pitch angle. Unit: rad. Frame: ned. Range: -1.5707963267948966 to 1.5707963267948966.
 *   Positive: nose up.
 * - heading: Heading (yaw) angle. Unit: rad. Frame: ned. Range: -pi to pi. Positive: clockwise seen
 *   from above.
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

/** Set initial attitude, with these values, including optional parameters. */
static inline struct mip_result mip_call_filter_set_initial_attitude_with(
    struct mip_device *device, const struct mip_filter_set_initial_attitude *command) {
    return mip_device_call(device, &mip_filter_set_initial_attitude_command, command, NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_filter_set_initial_heading);

/** Set initial heading: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_filter_set_initial_heading(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_set_initial_heading *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_set_initial_heading_command,
                           command, NULL, NULL, now);
}

/**
 * Set initial heading.
 *
 * - heading: Initial heading. Unit: rad. Frame: ned. Range: -pi to pi. Positive: clockwise seen
 *   from above.
 */
static inline struct mip_result mip_call_filter_set_initial_heading(struct mip_device *device,
                                                                    float heading) {
    uint8_t data[4];
    mip_put_float(data, &heading);
    return mip_device_send(device, &mip_filter_set_initial_heading_exchange, data, 4);
}

/** Set initial heading, with these values, including optional parameters. */
static inline struct mip_result mip_call_filter_set_initial_heading_with(
    struct mip_device *device, const struct mip_filter_set_initial_heading *command) {
    return mip_device_call(device, &mip_filter_set_initial_heading_command, command, NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_filter_set_initial_attitude_from_imu);

/** Set initial attitude from IMU: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_filter_set_initial_attitude_from_imu(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_set_initial_attitude_from_imu *command, uint32_t now) {
    return mip_client_send(client, request, packet,
                           &mip_filter_set_initial_attitude_from_imu_command, command, NULL, NULL,
                           now);
}

/**
 * Set initial attitude from IMU.
 *
 * - declination: Angle from true north to magnetic north. Unit: rad. Frame: ned. Range: -pi to pi.
 *   Positive: magnetic north is east of true north. Uncertain: The sign is the usual one; no source
 *   states it.
 */
static inline struct mip_result
mip_call_filter_set_initial_attitude_from_imu(struct mip_device *device, float declination) {
    uint8_t data[4];
    mip_put_float(data, &declination);
    return mip_device_send(device, &mip_filter_set_initial_attitude_from_imu_exchange, data, 4);
}

/** Set initial attitude from IMU, with these values, including optional parameters. */
static inline struct mip_result mip_call_filter_set_initial_attitude_from_imu_with(
    struct mip_device *device, const struct mip_filter_set_initial_attitude_from_imu *command) {
    return mip_device_call(device, &mip_filter_set_initial_attitude_from_imu_command, command, NULL,
                           NULL);
}

MIP_COMMAND_REPLIES(mip_filter_run);

/** Run navigation filter: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_filter_run(struct mip_client *client, struct mip_request *request,
                                            struct mip_builder *packet, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_run_command, NULL, NULL, NULL, now);
}

/** Run navigation filter. */
static inline struct mip_result mip_call_filter_run(struct mip_device *device) {
    return mip_device_send(device, &mip_filter_run_exchange, MIP_NO_DATA(mip_filter_run_exchange),
                           0);
}

MIP_COMMAND_REPLIES(mip_filter_vehicle_dynamics_mode);
MIP_SEND(mip_send_filter_vehicle_dynamics_mode, mip_filter_vehicle_dynamics_mode,
         mip_filter_vehicle_dynamics_mode_response);
MIP_CALL_FOR(mip_call_filter_vehicle_dynamics_mode_read, mip_filter_vehicle_dynamics_mode,
             MIP_FUNCTION_SELECTOR_READ, mip_filter_vehicle_dynamics_mode_response);
MIP_CALL(mip_call_filter_vehicle_dynamics_mode_save, mip_filter_vehicle_dynamics_mode,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_vehicle_dynamics_mode_load, mip_filter_vehicle_dynamics_mode,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_vehicle_dynamics_mode_default, mip_filter_vehicle_dynamics_mode,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_vehicle_dynamics_mode_with, mip_filter_vehicle_dynamics_mode,
              mip_filter_vehicle_dynamics_mode_response);

/**
 * Vehicle dynamics mode: write.
 *
 * - mode: Kind of vehicle. A value of enum mip_filter_dynamics_mode. Required for write. On the
 *   3DM-GX3-45: only MIP_FILTER_DYNAMICS_MODE_PORTABLE, MIP_FILTER_DYNAMICS_MODE_AUTOMOTIVE and
 *   MIP_FILTER_DYNAMICS_MODE_AIRBORNE.
 */
static inline struct mip_result mip_call_filter_vehicle_dynamics_mode_write(
    struct mip_device *device, enum mip_filter_dynamics_mode mode) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_WRITE, (uint8_t)mode};
    return mip_device_send(device, &mip_filter_vehicle_dynamics_mode_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_filter_sensor_to_vehicle_rotation_euler);
MIP_SEND(mip_send_filter_sensor_to_vehicle_rotation_euler,
         mip_filter_sensor_to_vehicle_rotation_euler,
         mip_filter_sensor_to_vehicle_rotation_euler_response);
MIP_CALL_FOR(mip_call_filter_sensor_to_vehicle_rotation_euler_read,
             mip_filter_sensor_to_vehicle_rotation_euler, MIP_FUNCTION_SELECTOR_READ,
             mip_filter_sensor_to_vehicle_rotation_euler_response);
MIP_CALL(mip_call_filter_sensor_to_vehicle_rotation_euler_save,
         mip_filter_sensor_to_vehicle_rotation_euler, MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_sensor_to_vehicle_rotation_euler_load,
         mip_filter_sensor_to_vehicle_rotation_euler, MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_sensor_to_vehicle_rotation_euler_default,
         mip_filter_sensor_to_vehicle_rotation_euler, MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_sensor_to_vehicle_rotation_euler_with,
              mip_filter_sensor_to_vehicle_rotation_euler,
              mip_filter_sensor_to_vehicle_rotation_euler_response);

/**
 * Sensor to vehicle frame transformation: write.
 *
 * - roll: Roll angle of the vehicle relative to the sensor. Unit: rad. Frame: sensor. Positive:
 *   right side down. Required for write.
 * - pitch: Pitch angle of the vehicle relative to the sensor. Unit: rad. Frame: sensor. Positive:
 *   nose up. Required for write.
 * - yaw: Yaw angle of the vehicle relative to the sensor. Unit: rad. Frame: sensor. Positive:
 *   clockwise seen from above. Required for write.
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

MIP_COMMAND_REPLIES(mip_filter_sensor_to_vehicle_offset);
MIP_SEND(mip_send_filter_sensor_to_vehicle_offset, mip_filter_sensor_to_vehicle_offset,
         mip_filter_sensor_to_vehicle_offset_response);
MIP_CALL_FOR(mip_call_filter_sensor_to_vehicle_offset_read, mip_filter_sensor_to_vehicle_offset,
             MIP_FUNCTION_SELECTOR_READ, mip_filter_sensor_to_vehicle_offset_response);
MIP_CALL(mip_call_filter_sensor_to_vehicle_offset_save, mip_filter_sensor_to_vehicle_offset,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_sensor_to_vehicle_offset_load, mip_filter_sensor_to_vehicle_offset,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_sensor_to_vehicle_offset_default, mip_filter_sensor_to_vehicle_offset,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_sensor_to_vehicle_offset_with, mip_filter_sensor_to_vehicle_offset,
              mip_filter_sensor_to_vehicle_offset_response);

/**
 * Sensor to vehicle offset: write.
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

MIP_COMMAND_REPLIES(mip_filter_antenna_offset);
MIP_SEND(mip_send_filter_antenna_offset, mip_filter_antenna_offset,
         mip_filter_antenna_offset_response);
MIP_CALL_FOR(mip_call_filter_antenna_offset_read, mip_filter_antenna_offset,
             MIP_FUNCTION_SELECTOR_READ, mip_filter_antenna_offset_response);
MIP_CALL(mip_call_filter_antenna_offset_save, mip_filter_antenna_offset,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_antenna_offset_load, mip_filter_antenna_offset,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_antenna_offset_default, mip_filter_antenna_offset,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_antenna_offset_with, mip_filter_antenna_offset,
              mip_filter_antenna_offset_response);

/**
 * GNSS antenna offset: write.
 *
 * - offset: Vector from the sensor origin to the phase centre of the antenna. Elements: x, y, z.
 *   Unit: m. Frame: vehicle. Range: magnitude at most 10. Required for write. On the 3DM-CX5-45:
 *   frame sensor (inferred: the manual of the 3DM-GX5-45 states it). On the 3DM-GX5-45: frame
 *   sensor.
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

MIP_COMMAND_REPLIES(mip_filter_estimation_control);
MIP_SEND(mip_send_filter_estimation_control, mip_filter_estimation_control,
         mip_filter_estimation_control_response);
MIP_CALL_FOR(mip_call_filter_estimation_control_read, mip_filter_estimation_control,
             MIP_FUNCTION_SELECTOR_READ, mip_filter_estimation_control_response);
MIP_CALL(mip_call_filter_estimation_control_save, mip_filter_estimation_control,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_estimation_control_load, mip_filter_estimation_control,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_estimation_control_default, mip_filter_estimation_control,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_estimation_control_with, mip_filter_estimation_control,
              mip_filter_estimation_control_response);

/**
 * Estimation control flags: write.
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

MIP_COMMAND_REPLIES(mip_filter_gnss_source);
MIP_SEND(mip_send_filter_gnss_source, mip_filter_gnss_source, mip_filter_gnss_source_response);
MIP_CALL_FOR(mip_call_filter_gnss_source_read, mip_filter_gnss_source, MIP_FUNCTION_SELECTOR_READ,
             mip_filter_gnss_source_response);
MIP_CALL(mip_call_filter_gnss_source_save, mip_filter_gnss_source, MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_gnss_source_load, mip_filter_gnss_source, MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_gnss_source_default, mip_filter_gnss_source,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_gnss_source_with, mip_filter_gnss_source,
              mip_filter_gnss_source_response);

/**
 * GNSS aiding source: write.
 *
 * - source: Source of the GNSS data. A value of enum mip_filter_gnss_aiding_source. Required for
 *   write. On the 3DM-CV7-INS, 3DM-CX7-INS and 3DM-GV7-INS: only
 *   MIP_FILTER_GNSS_AIDING_SOURCE_EXTERNAL. On the 3DM-CX5-45, 3DM-GQ4-45, 3DM-GX3-45, 3DM-GX4-45,
 *   3DM-RQ1-45-LT and 3DM-RQ1-45-ST: only MIP_FILTER_GNSS_AIDING_SOURCE_ALL_INTERNAL,
 *   MIP_FILTER_GNSS_AIDING_SOURCE_EXTERNAL and MIP_FILTER_GNSS_AIDING_SOURCE_INTERNAL_1. On the
 *   3DM-GX5-45: only MIP_FILTER_GNSS_AIDING_SOURCE_ALL_INTERNAL and
 *   MIP_FILTER_GNSS_AIDING_SOURCE_EXTERNAL.
 */
static inline struct mip_result mip_call_filter_gnss_source_write(
    struct mip_device *device, enum mip_filter_gnss_aiding_source source) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_WRITE, (uint8_t)source};
    return mip_device_send(device, &mip_filter_gnss_source_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_filter_external_gnss_update);

/** External GNSS update: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_filter_external_gnss_update(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_external_gnss_update *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_external_gnss_update_command,
                           command, NULL, NULL, now);
}

/**
 * External GNSS update.
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
        mip_put_float(data + 34 + 4 * i, &velocity[i]);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 46 + 4 * i, &position_uncertainty[i]);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 58 + 4 * i, &velocity_uncertainty[i]);
    }
    return mip_device_send(device, &mip_filter_external_gnss_update_exchange, data, 70);
}

/** External GNSS update, with these values, including optional parameters. */
static inline struct mip_result mip_call_filter_external_gnss_update_with(
    struct mip_device *device, const struct mip_filter_external_gnss_update *command) {
    return mip_device_call(device, &mip_filter_external_gnss_update_command, command, NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_filter_external_heading_update);

/** External heading update: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_filter_external_heading_update(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_external_heading_update *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_external_heading_update_command,
                           command, NULL, NULL, now);
}

/**
 * External heading update.
 *
 * - heading: Heading relative to the north selected by `type`. Unit: rad. Frame: ned. Range: -pi to
 *   pi. Positive: clockwise seen from above.
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

/** External heading update, with these values, including optional parameters. */
static inline struct mip_result mip_call_filter_external_heading_update_with(
    struct mip_device *device, const struct mip_filter_external_heading_update *command) {
    return mip_device_call(device, &mip_filter_external_heading_update_command, command, NULL,
                           NULL);
}

MIP_COMMAND_REPLIES(mip_filter_heading_source);
MIP_SEND(mip_send_filter_heading_source, mip_filter_heading_source,
         mip_filter_heading_source_response);
MIP_CALL_FOR(mip_call_filter_heading_source_read, mip_filter_heading_source,
             MIP_FUNCTION_SELECTOR_READ, mip_filter_heading_source_response);
MIP_CALL(mip_call_filter_heading_source_save, mip_filter_heading_source,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_heading_source_load, mip_filter_heading_source,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_heading_source_default, mip_filter_heading_source,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_heading_source_with, mip_filter_heading_source,
              mip_filter_heading_source_response);

/**
 * Heading update control: write.
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
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_WRITE, (uint8_t)source};
    return mip_device_send(device, &mip_filter_heading_source_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_filter_auto_initialization_control);
MIP_SEND(mip_send_filter_auto_initialization_control, mip_filter_auto_initialization_control,
         mip_filter_auto_initialization_control_response);
MIP_CALL_FOR(mip_call_filter_auto_initialization_control_read,
             mip_filter_auto_initialization_control, MIP_FUNCTION_SELECTOR_READ,
             mip_filter_auto_initialization_control_response);
MIP_CALL(mip_call_filter_auto_initialization_control_save, mip_filter_auto_initialization_control,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_auto_initialization_control_load, mip_filter_auto_initialization_control,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_auto_initialization_control_default,
         mip_filter_auto_initialization_control, MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_auto_initialization_control_with,
              mip_filter_auto_initialization_control,
              mip_filter_auto_initialization_control_response);

/**
 * Automatic initialization: write.
 *
 * - enable: 0 disables, 1 enables. Range: 0 to 1. Required for write.
 */
static inline struct mip_result
mip_call_filter_auto_initialization_control_write(struct mip_device *device, uint8_t enable) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_WRITE, (uint8_t)enable};
    return mip_device_send(device, &mip_filter_auto_initialization_control_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_filter_accel_noise);
MIP_SEND(mip_send_filter_accel_noise, mip_filter_accel_noise, mip_filter_accel_noise_response);
MIP_CALL_FOR(mip_call_filter_accel_noise_read, mip_filter_accel_noise, MIP_FUNCTION_SELECTOR_READ,
             mip_filter_accel_noise_response);
MIP_CALL(mip_call_filter_accel_noise_save, mip_filter_accel_noise, MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_accel_noise_load, mip_filter_accel_noise, MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_accel_noise_default, mip_filter_accel_noise,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_accel_noise_with, mip_filter_accel_noise,
              mip_filter_accel_noise_response);

/**
 * Accelerometer noise: write.
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

MIP_COMMAND_REPLIES(mip_filter_gyro_noise);
MIP_SEND(mip_send_filter_gyro_noise, mip_filter_gyro_noise, mip_filter_gyro_noise_response);
MIP_CALL_FOR(mip_call_filter_gyro_noise_read, mip_filter_gyro_noise, MIP_FUNCTION_SELECTOR_READ,
             mip_filter_gyro_noise_response);
MIP_CALL(mip_call_filter_gyro_noise_save, mip_filter_gyro_noise, MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_gyro_noise_load, mip_filter_gyro_noise, MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_gyro_noise_default, mip_filter_gyro_noise, MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_gyro_noise_with, mip_filter_gyro_noise,
              mip_filter_gyro_noise_response);

/**
 * Gyroscope noise: write.
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

MIP_COMMAND_REPLIES(mip_filter_accel_bias_model);
MIP_SEND(mip_send_filter_accel_bias_model, mip_filter_accel_bias_model,
         mip_filter_accel_bias_model_response);
MIP_CALL_FOR(mip_call_filter_accel_bias_model_read, mip_filter_accel_bias_model,
             MIP_FUNCTION_SELECTOR_READ, mip_filter_accel_bias_model_response);
MIP_CALL(mip_call_filter_accel_bias_model_save, mip_filter_accel_bias_model,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_accel_bias_model_load, mip_filter_accel_bias_model,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_accel_bias_model_default, mip_filter_accel_bias_model,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_accel_bias_model_with, mip_filter_accel_bias_model,
              mip_filter_accel_bias_model_response);

/**
 * Accelerometer bias model: write.
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

MIP_COMMAND_REPLIES(mip_filter_gyro_bias_model);
MIP_SEND(mip_send_filter_gyro_bias_model, mip_filter_gyro_bias_model,
         mip_filter_gyro_bias_model_response);
MIP_CALL_FOR(mip_call_filter_gyro_bias_model_read, mip_filter_gyro_bias_model,
             MIP_FUNCTION_SELECTOR_READ, mip_filter_gyro_bias_model_response);
MIP_CALL(mip_call_filter_gyro_bias_model_save, mip_filter_gyro_bias_model,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_gyro_bias_model_load, mip_filter_gyro_bias_model,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_gyro_bias_model_default, mip_filter_gyro_bias_model,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_gyro_bias_model_with, mip_filter_gyro_bias_model,
              mip_filter_gyro_bias_model_response);

/**
 * Gyroscope bias model: write.
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

MIP_COMMAND_REPLIES(mip_filter_auto_zupt);
MIP_SEND(mip_send_filter_auto_zupt, mip_filter_auto_zupt, mip_filter_auto_zupt_response);
MIP_CALL_FOR(mip_call_filter_auto_zupt_read, mip_filter_auto_zupt, MIP_FUNCTION_SELECTOR_READ,
             mip_filter_auto_zupt_response);
MIP_CALL(mip_call_filter_auto_zupt_save, mip_filter_auto_zupt, MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_auto_zupt_load, mip_filter_auto_zupt, MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_auto_zupt_default, mip_filter_auto_zupt, MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_auto_zupt_with, mip_filter_auto_zupt, mip_filter_auto_zupt_response);

/**
 * Automatic zero velocity update: write.
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

MIP_COMMAND_REPLIES(mip_filter_external_heading_update_with_time);

/** External heading update with time: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_filter_external_heading_update_with_time(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_external_heading_update_with_time *command, uint32_t now) {
    return mip_client_send(client, request, packet,
                           &mip_filter_external_heading_update_with_time_command, command, NULL,
                           NULL, now);
}

/**
 * External heading update with time.
 *
 * - tow: GPS time of week of the measurement. Unit: s. Range: at least 0, less than 604800.
 * - week_number: GPS week, counted without rollover. Unit: week.
 * - heading: Heading relative to the north selected by `type`. Unit: rad. Frame: ned. Range: -pi to
 *   pi. Positive: clockwise seen from above.
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

/** External heading update with time, with these values, including optional parameters. */
static inline struct mip_result mip_call_filter_external_heading_update_with_time_with(
    struct mip_device *device, const struct mip_filter_external_heading_update_with_time *command) {
    return mip_device_call(device, &mip_filter_external_heading_update_with_time_command, command,
                           NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_filter_auto_angular_zupt);
MIP_SEND(mip_send_filter_auto_angular_zupt, mip_filter_auto_angular_zupt,
         mip_filter_auto_angular_zupt_response);
MIP_CALL_FOR(mip_call_filter_auto_angular_zupt_read, mip_filter_auto_angular_zupt,
             MIP_FUNCTION_SELECTOR_READ, mip_filter_auto_angular_zupt_response);
MIP_CALL(mip_call_filter_auto_angular_zupt_save, mip_filter_auto_angular_zupt,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_auto_angular_zupt_load, mip_filter_auto_angular_zupt,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_auto_angular_zupt_default, mip_filter_auto_angular_zupt,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_auto_angular_zupt_with, mip_filter_auto_angular_zupt,
              mip_filter_auto_angular_zupt_response);

/**
 * Zero angular rate update: write.
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

MIP_COMMAND_REPLIES(mip_filter_tare_orientation);
MIP_SEND(mip_send_filter_tare_orientation, mip_filter_tare_orientation,
         mip_filter_tare_orientation_response);
MIP_CALL_FOR(mip_call_filter_tare_orientation_read, mip_filter_tare_orientation,
             MIP_FUNCTION_SELECTOR_READ, mip_filter_tare_orientation_response);
MIP_CALL(mip_call_filter_tare_orientation_save, mip_filter_tare_orientation,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_tare_orientation_load, mip_filter_tare_orientation,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_tare_orientation_default, mip_filter_tare_orientation,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_tare_orientation_with, mip_filter_tare_orientation,
              mip_filter_tare_orientation_response);

/**
 * Tare orientation: write.
 *
 * - axes: Axes to tare; 0 resets all axes. Required for write.
 */
static inline struct mip_result mip_call_filter_tare_orientation_write(struct mip_device *device,
                                                                       mip_filter_tare_axes axes) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_WRITE, (uint8_t)axes};
    return mip_device_send(device, &mip_filter_tare_orientation_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_filter_commanded_zupt);

/** Commanded zero velocity update: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_filter_commanded_zupt(struct mip_client *client,
                                                       struct mip_request *request,
                                                       struct mip_builder *packet, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_commanded_zupt_command, NULL, NULL,
                           NULL, now);
}

/** Commanded zero velocity update. */
static inline struct mip_result mip_call_filter_commanded_zupt(struct mip_device *device) {
    return mip_device_send(device, &mip_filter_commanded_zupt_exchange,
                           MIP_NO_DATA(mip_filter_commanded_zupt_exchange), 0);
}

MIP_COMMAND_REPLIES(mip_filter_commanded_angular_zupt);

/** Commanded zero angular rate update: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_filter_commanded_angular_zupt(struct mip_client *client,
                                                               struct mip_request *request,
                                                               struct mip_builder *packet,
                                                               uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_commanded_angular_zupt_command,
                           NULL, NULL, NULL, now);
}

/** Commanded zero angular rate update. */
static inline struct mip_result mip_call_filter_commanded_angular_zupt(struct mip_device *device) {
    return mip_device_send(device, &mip_filter_commanded_angular_zupt_exchange,
                           MIP_NO_DATA(mip_filter_commanded_angular_zupt_exchange), 0);
}

MIP_COMMAND_REPLIES(mip_filter_reference_position);
MIP_SEND(mip_send_filter_reference_position, mip_filter_reference_position,
         mip_filter_reference_position_response);
MIP_CALL_FOR(mip_call_filter_reference_position_read, mip_filter_reference_position,
             MIP_FUNCTION_SELECTOR_READ, mip_filter_reference_position_response);
MIP_CALL(mip_call_filter_reference_position_save, mip_filter_reference_position,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_reference_position_load, mip_filter_reference_position,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_reference_position_default, mip_filter_reference_position,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_reference_position_with, mip_filter_reference_position,
              mip_filter_reference_position_response);

/**
 * Set reference position: write.
 *
 * - enable: 0 disables, 1 enables. Range: 0 to 1. Required for write.
 * - latitude: Geodetic latitude. Unit: deg. Frame: llh. Range: -90 to 90. Positive: north. Required
 *   for write.
 * - longitude: Geodetic longitude. Unit: deg. Frame: llh. Range: -180 to 180. Positive: east.
 *   Required for write.
 * - altitude: Altitude of the reference position. Unit: m. Required for write. Uncertain: The
 *   reference, ellipsoid or sea level, is inferred. The manual does not state it; its glossary
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

MIP_COMMAND_REPLIES(mip_filter_mag_capture_auto_calibration);
MIP_CALL(mip_call_filter_mag_capture_auto_calibration_write,
         mip_filter_mag_capture_auto_calibration, MIP_FUNCTION_SELECTOR_WRITE);
MIP_CALL(mip_call_filter_mag_capture_auto_calibration_save, mip_filter_mag_capture_auto_calibration,
         MIP_FUNCTION_SELECTOR_SAVE);

/**
 * Capture automatic magnetometer calibration: adds the command to a packet. See mip_client_send.
 */
static inline mip_error mip_send_filter_mag_capture_auto_calibration(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_mag_capture_auto_calibration *command, uint32_t now) {
    return mip_client_send(client, request, packet,
                           &mip_filter_mag_capture_auto_calibration_command, command, NULL, NULL,
                           now);
}

/** Capture automatic magnetometer calibration, with these values, including optional parameters. */
static inline struct mip_result mip_call_filter_mag_capture_auto_calibration_with(
    struct mip_device *device, const struct mip_filter_mag_capture_auto_calibration *command) {
    return mip_device_call(device, &mip_filter_mag_capture_auto_calibration_command, command, NULL,
                           NULL);
}

MIP_COMMAND_REPLIES(mip_filter_gravity_noise);
MIP_SEND(mip_send_filter_gravity_noise, mip_filter_gravity_noise,
         mip_filter_gravity_noise_response);
MIP_CALL_FOR(mip_call_filter_gravity_noise_read, mip_filter_gravity_noise,
             MIP_FUNCTION_SELECTOR_READ, mip_filter_gravity_noise_response);
MIP_CALL(mip_call_filter_gravity_noise_save, mip_filter_gravity_noise, MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_gravity_noise_load, mip_filter_gravity_noise, MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_gravity_noise_default, mip_filter_gravity_noise,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_gravity_noise_with, mip_filter_gravity_noise,
              mip_filter_gravity_noise_response);

/**
 * Gravity noise: write.
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

MIP_COMMAND_REPLIES(mip_filter_pressure_altitude_noise);
MIP_SEND(mip_send_filter_pressure_altitude_noise, mip_filter_pressure_altitude_noise,
         mip_filter_pressure_altitude_noise_response);
MIP_CALL_FOR(mip_call_filter_pressure_altitude_noise_read, mip_filter_pressure_altitude_noise,
             MIP_FUNCTION_SELECTOR_READ, mip_filter_pressure_altitude_noise_response);
MIP_CALL(mip_call_filter_pressure_altitude_noise_save, mip_filter_pressure_altitude_noise,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_pressure_altitude_noise_load, mip_filter_pressure_altitude_noise,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_pressure_altitude_noise_default, mip_filter_pressure_altitude_noise,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_pressure_altitude_noise_with, mip_filter_pressure_altitude_noise,
              mip_filter_pressure_altitude_noise_response);

/**
 * Pressure altitude noise: write.
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

MIP_COMMAND_REPLIES(mip_filter_hard_iron_offset_noise);
MIP_SEND(mip_send_filter_hard_iron_offset_noise, mip_filter_hard_iron_offset_noise,
         mip_filter_hard_iron_offset_noise_response);
MIP_CALL_FOR(mip_call_filter_hard_iron_offset_noise_read, mip_filter_hard_iron_offset_noise,
             MIP_FUNCTION_SELECTOR_READ, mip_filter_hard_iron_offset_noise_response);
MIP_CALL(mip_call_filter_hard_iron_offset_noise_save, mip_filter_hard_iron_offset_noise,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_hard_iron_offset_noise_load, mip_filter_hard_iron_offset_noise,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_hard_iron_offset_noise_default, mip_filter_hard_iron_offset_noise,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_hard_iron_offset_noise_with, mip_filter_hard_iron_offset_noise,
              mip_filter_hard_iron_offset_noise_response);

/**
 * Hard iron offset noise: write.
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

MIP_COMMAND_REPLIES(mip_filter_soft_iron_matrix_noise);
MIP_SEND(mip_send_filter_soft_iron_matrix_noise, mip_filter_soft_iron_matrix_noise,
         mip_filter_soft_iron_matrix_noise_response);
MIP_CALL_FOR(mip_call_filter_soft_iron_matrix_noise_read, mip_filter_soft_iron_matrix_noise,
             MIP_FUNCTION_SELECTOR_READ, mip_filter_soft_iron_matrix_noise_response);
MIP_CALL(mip_call_filter_soft_iron_matrix_noise_save, mip_filter_soft_iron_matrix_noise,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_soft_iron_matrix_noise_load, mip_filter_soft_iron_matrix_noise,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_soft_iron_matrix_noise_default, mip_filter_soft_iron_matrix_noise,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_soft_iron_matrix_noise_with, mip_filter_soft_iron_matrix_noise,
              mip_filter_soft_iron_matrix_noise_response);

/**
 * Soft iron matrix noise: write.
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

MIP_COMMAND_REPLIES(mip_filter_enable_measurements);
MIP_SEND(mip_send_filter_enable_measurements, mip_filter_enable_measurements,
         mip_filter_enable_measurements_response);
MIP_CALL_FOR(mip_call_filter_enable_measurements_read, mip_filter_enable_measurements,
             MIP_FUNCTION_SELECTOR_READ, mip_filter_enable_measurements_response);
MIP_CALL(mip_call_filter_enable_measurements_save, mip_filter_enable_measurements,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_enable_measurements_load, mip_filter_enable_measurements,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_enable_measurements_default, mip_filter_enable_measurements,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_enable_measurements_with, mip_filter_enable_measurements,
              mip_filter_enable_measurements_response);

/**
 * Enable or disable measurements: write.
 *
 * - control: Measurements to use. Required for write. On the 3DM-CV5-15, 3DM-CX5-15 and 3DM-GX5-15:
 *   only MIP_FILTER_MEASUREMENT_FLAGS_ACCEL.
 */
static inline struct mip_result mip_call_filter_enable_measurements_write(
    struct mip_device *device, mip_filter_measurement_flags control) {
    uint8_t data[3];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_16(data + 1, (uint16_t)control);
    return mip_device_send(device, &mip_filter_enable_measurements_exchange, data, 3);
}

MIP_COMMAND_REPLIES(mip_filter_mag_noise);
MIP_SEND(mip_send_filter_mag_noise, mip_filter_mag_noise, mip_filter_mag_noise_response);
MIP_CALL_FOR(mip_call_filter_mag_noise_read, mip_filter_mag_noise, MIP_FUNCTION_SELECTOR_READ,
             mip_filter_mag_noise_response);
MIP_CALL(mip_call_filter_mag_noise_save, mip_filter_mag_noise, MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_mag_noise_load, mip_filter_mag_noise, MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_mag_noise_default, mip_filter_mag_noise, MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_mag_noise_with, mip_filter_mag_noise, mip_filter_mag_noise_response);

/**
 * Magnetometer noise: write.
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

MIP_COMMAND_REPLIES(mip_filter_magnetic_declination_source);
MIP_SEND(mip_send_filter_magnetic_declination_source, mip_filter_magnetic_declination_source,
         mip_filter_magnetic_declination_source_response);
MIP_CALL_FOR(mip_call_filter_magnetic_declination_source_read,
             mip_filter_magnetic_declination_source, MIP_FUNCTION_SELECTOR_READ,
             mip_filter_magnetic_declination_source_response);
MIP_CALL(mip_call_filter_magnetic_declination_source_save, mip_filter_magnetic_declination_source,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_magnetic_declination_source_load, mip_filter_magnetic_declination_source,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_magnetic_declination_source_default,
         mip_filter_magnetic_declination_source, MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_magnetic_declination_source_with,
              mip_filter_magnetic_declination_source,
              mip_filter_magnetic_declination_source_response);

/**
 * Magnetic declination source: write.
 *
 * - source: Source of the declination. A value of enum mip_filter_mag_parameter_source. Required
 *   for write. On the 3DM-CX7-AHRS and 3DM-GV7-AHRS: only MIP_FILTER_MAG_PARAMETER_SOURCE_NONE and
 *   MIP_FILTER_MAG_PARAMETER_SOURCE_MANUAL. On the 3DM-GQ7-GNSS/INS: only
 *   MIP_FILTER_MAG_PARAMETER_SOURCE_WMM and MIP_FILTER_MAG_PARAMETER_SOURCE_MANUAL.
 * - declination: Angle from true north to magnetic north; used only if `source` is manual. Unit:
 *   rad. Frame: ned. Range: -pi to pi. Positive: magnetic north is east of true north. Required for
 *   write. Uncertain: The sign is the usual one; no source states it. Uncertain: The manuals, that
 *   of the 3DM-GQ7 included, require it only if `source` is manual, but state one length, with the
 *   value. Always send it.
 */
static inline struct mip_result mip_call_filter_magnetic_declination_source_write(
    struct mip_device *device, enum mip_filter_mag_parameter_source source, float declination) {
    uint8_t data[6];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)source);
    mip_put_float(data + 2, &declination);
    return mip_device_send(device, &mip_filter_magnetic_declination_source_exchange, data, 6);
}

MIP_COMMAND_REPLIES(mip_filter_accel_magnitude_adaptive);
MIP_SEND(mip_send_filter_accel_magnitude_adaptive, mip_filter_accel_magnitude_adaptive,
         mip_filter_accel_magnitude_adaptive_response);
MIP_CALL_FOR(mip_call_filter_accel_magnitude_adaptive_read, mip_filter_accel_magnitude_adaptive,
             MIP_FUNCTION_SELECTOR_READ, mip_filter_accel_magnitude_adaptive_response);
MIP_CALL(mip_call_filter_accel_magnitude_adaptive_save, mip_filter_accel_magnitude_adaptive,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_accel_magnitude_adaptive_load, mip_filter_accel_magnitude_adaptive,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_accel_magnitude_adaptive_default, mip_filter_accel_magnitude_adaptive,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_accel_magnitude_adaptive_with, mip_filter_accel_magnitude_adaptive,
              mip_filter_accel_magnitude_adaptive_response);

/**
 * Gravity magnitude error adaptive measurement: write.
 *
 * - adaptive_measurement: Kind of adaptation. A value of enum
 *   mip_filter_adaptive_measurement_selector. Required for write. On the 3DM-GQ4-45, 3DM-GX3-45,
 *   3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: only
 *   MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_DISABLED and
 *   MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_FIXED.
 */
static inline struct mip_result mip_call_filter_accel_magnitude_adaptive_write(
    struct mip_device *device, enum mip_filter_adaptive_measurement_selector adaptive_measurement) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_WRITE, (uint8_t)adaptive_measurement};
    return mip_device_send(device, &mip_filter_accel_magnitude_adaptive_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_filter_mag_magnitude_adaptive);
MIP_SEND(mip_send_filter_mag_magnitude_adaptive, mip_filter_mag_magnitude_adaptive,
         mip_filter_mag_magnitude_adaptive_response);
MIP_CALL_FOR(mip_call_filter_mag_magnitude_adaptive_read, mip_filter_mag_magnitude_adaptive,
             MIP_FUNCTION_SELECTOR_READ, mip_filter_mag_magnitude_adaptive_response);
MIP_CALL(mip_call_filter_mag_magnitude_adaptive_save, mip_filter_mag_magnitude_adaptive,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_mag_magnitude_adaptive_load, mip_filter_mag_magnitude_adaptive,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_mag_magnitude_adaptive_default, mip_filter_mag_magnitude_adaptive,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_mag_magnitude_adaptive_with, mip_filter_mag_magnitude_adaptive,
              mip_filter_mag_magnitude_adaptive_response);

/**
 * Magnetometer magnitude error adaptive measurement: write.
 *
 * - adaptive_measurement: Kind of adaptation. A value of enum
 *   mip_filter_adaptive_measurement_selector. Required for write. On the 3DM-GQ4-45, 3DM-GX3-45,
 *   3DM-GX4-25, 3DM-GX4-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: only
 *   MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_DISABLED and
 *   MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_FIXED.
 * - frequency: Cutoff frequency of the low-pass filter. Unit: Hz. Range: at least 0. Required for
 *   write.
 * - low_limit: Lower limit of the magnetic field magnitude error. Unit: gauss. Required for write.
 *   Uncertain: The unit gauss is inferred: the SDK states m/s^2, the manual of the 3DM-GX5-45 m/s^2
 *   in the command and gauss in the response.
 * - high_limit: Upper limit of the magnetic field magnitude error. Unit: gauss. Required for write.
 *   Uncertain: The unit gauss is inferred: the SDK states m/s^2, the manual of the 3DM-GX5-45 m/s^2
 *   in the command and gauss in the response.
 * - low_limit_uncertainty: Standard deviation at the lower limit. Unit: gauss. Range: at least 0.
 *   Required for write. Uncertain: The unit gauss is inferred: the SDK states m/s^2, the manual of
 *   the 3DM-GX5-45 m/s^2 in the command and gauss in the response.
 * - high_limit_uncertainty: Standard deviation at the upper limit. Unit: gauss. Range: at least 0.
 *   Required for write. Uncertain: The unit gauss is inferred: the SDK states m/s^2, the manual of
 *   the 3DM-GX5-45 m/s^2 in the command and gauss in the response.
 * - minimum_uncertainty: Smallest standard deviation. Unit: gauss. Range: at least 0. Required for
 *   write. Uncertain: The unit gauss is inferred: the SDK states m/s^2, the manual of the
 *   3DM-GX5-45 m/s^2 in the command and gauss in the response.
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

MIP_COMMAND_REPLIES(mip_filter_mag_dip_angle_adaptive);
MIP_SEND(mip_send_filter_mag_dip_angle_adaptive, mip_filter_mag_dip_angle_adaptive,
         mip_filter_mag_dip_angle_adaptive_response);
MIP_CALL_FOR(mip_call_filter_mag_dip_angle_adaptive_read, mip_filter_mag_dip_angle_adaptive,
             MIP_FUNCTION_SELECTOR_READ, mip_filter_mag_dip_angle_adaptive_response);
MIP_CALL(mip_call_filter_mag_dip_angle_adaptive_save, mip_filter_mag_dip_angle_adaptive,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_mag_dip_angle_adaptive_load, mip_filter_mag_dip_angle_adaptive,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_mag_dip_angle_adaptive_default, mip_filter_mag_dip_angle_adaptive,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_mag_dip_angle_adaptive_with, mip_filter_mag_dip_angle_adaptive,
              mip_filter_mag_dip_angle_adaptive_response);

/**
 * Magnetometer dip angle error adaptive measurement: write.
 *
 * - enable: True if the adaptation is on. Required for write.
 * - frequency: Cutoff frequency of the low-pass filter. Unit: Hz. Range: at least 0. Required for
 *   write.
 * - high_limit: Upper limit of the dip angle error. Unit: rad. Range: at least 0. Required for
 *   write. Uncertain: The unit rad is inferred from the quantity; the SDK states m/s^2.
 * - high_limit_uncertainty: Standard deviation at the upper limit. Unit: rad. Range: at least 0.
 *   Required for write. Uncertain: The unit rad is inferred from the quantity; the SDK states
 *   m/s^2.
 * - minimum_uncertainty: Smallest standard deviation. Unit: rad. Range: at least 0. Required for
 *   write. Uncertain: The unit rad is inferred from the quantity; the SDK states m/s^2.
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

MIP_COMMAND_REPLIES(mip_filter_altitude_aiding);
MIP_SEND(mip_send_filter_altitude_aiding, mip_filter_altitude_aiding,
         mip_filter_altitude_aiding_response);
MIP_CALL_FOR(mip_call_filter_altitude_aiding_read, mip_filter_altitude_aiding,
             MIP_FUNCTION_SELECTOR_READ, mip_filter_altitude_aiding_response);
MIP_CALL(mip_call_filter_altitude_aiding_save, mip_filter_altitude_aiding,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_altitude_aiding_load, mip_filter_altitude_aiding,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_altitude_aiding_default, mip_filter_altitude_aiding,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_altitude_aiding_with, mip_filter_altitude_aiding,
              mip_filter_altitude_aiding_response);

/**
 * Altitude aiding: write.
 *
 * - selector: Source of the aiding. A value of enum mip_filter_altitude_aiding_source. Required for
 *   write.
 */
static inline struct mip_result mip_call_filter_altitude_aiding_write(
    struct mip_device *device, enum mip_filter_altitude_aiding_source selector) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_WRITE, (uint8_t)selector};
    return mip_device_send(device, &mip_filter_altitude_aiding_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_filter_pitch_roll_aiding);
MIP_SEND(mip_send_filter_pitch_roll_aiding, mip_filter_pitch_roll_aiding,
         mip_filter_pitch_roll_aiding_response);
MIP_CALL_FOR(mip_call_filter_pitch_roll_aiding_read, mip_filter_pitch_roll_aiding,
             MIP_FUNCTION_SELECTOR_READ, mip_filter_pitch_roll_aiding_response);
MIP_CALL(mip_call_filter_pitch_roll_aiding_save, mip_filter_pitch_roll_aiding,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_pitch_roll_aiding_load, mip_filter_pitch_roll_aiding,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_pitch_roll_aiding_default, mip_filter_pitch_roll_aiding,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_pitch_roll_aiding_with, mip_filter_pitch_roll_aiding,
              mip_filter_pitch_roll_aiding_response);

/**
 * Pitch and roll aiding: write.
 *
 * - aiding: Source of the aiding. A value of enum mip_filter_pitch_roll_aiding_source. Required for
 *   write.
 */
static inline struct mip_result mip_call_filter_pitch_roll_aiding_write(
    struct mip_device *device, enum mip_filter_pitch_roll_aiding_source aiding) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_WRITE, (uint8_t)aiding};
    return mip_device_send(device, &mip_filter_pitch_roll_aiding_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_filter_magnetic_inclination_source);
MIP_SEND(mip_send_filter_magnetic_inclination_source, mip_filter_magnetic_inclination_source,
         mip_filter_magnetic_inclination_source_response);
MIP_CALL_FOR(mip_call_filter_magnetic_inclination_source_read,
             mip_filter_magnetic_inclination_source, MIP_FUNCTION_SELECTOR_READ,
             mip_filter_magnetic_inclination_source_response);
MIP_CALL(mip_call_filter_magnetic_inclination_source_save, mip_filter_magnetic_inclination_source,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_magnetic_inclination_source_load, mip_filter_magnetic_inclination_source,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_magnetic_inclination_source_default,
         mip_filter_magnetic_inclination_source, MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_magnetic_inclination_source_with,
              mip_filter_magnetic_inclination_source,
              mip_filter_magnetic_inclination_source_response);

/**
 * Magnetic inclination source: write.
 *
 * - source: Source of the inclination. A value of enum mip_filter_mag_parameter_source. Required
 *   for write.
 * - inclination: Angle of the field below the horizontal plane; used only if `source` is manual.
 *   Unit: rad. Frame: ned. Range: -1.5707963267948966 to 1.5707963267948966. Positive: the field
 *   points down. Required for write. Uncertain: The sign is the usual one; no source states it.
 *   Uncertain: It can possibly be omitted if `source` is not manual, as with
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

MIP_COMMAND_REPLIES(mip_filter_magnetic_magnitude_source);
MIP_SEND(mip_send_filter_magnetic_magnitude_source, mip_filter_magnetic_magnitude_source,
         mip_filter_magnetic_magnitude_source_response);
MIP_CALL_FOR(mip_call_filter_magnetic_magnitude_source_read, mip_filter_magnetic_magnitude_source,
             MIP_FUNCTION_SELECTOR_READ, mip_filter_magnetic_magnitude_source_response);
MIP_CALL(mip_call_filter_magnetic_magnitude_source_save, mip_filter_magnetic_magnitude_source,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_magnetic_magnitude_source_load, mip_filter_magnetic_magnitude_source,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_magnetic_magnitude_source_default, mip_filter_magnetic_magnitude_source,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_magnetic_magnitude_source_with, mip_filter_magnetic_magnitude_source,
              mip_filter_magnetic_magnitude_source_response);

/**
 * Magnetic field magnitude source: write.
 *
 * - source: Source of the magnitude. A value of enum mip_filter_mag_parameter_source. Required for
 *   write.
 * - magnitude: Magnitude; used only if `source` is manual. Unit: gauss. Range: at least 0. Required
 *   for write. Uncertain: It can possibly be omitted if `source` is not manual, as with
 *   mip_filter_magnetic_declination_source. The SDK always sends it.
 */
static inline struct mip_result mip_call_filter_magnetic_magnitude_source_write(
    struct mip_device *device, enum mip_filter_mag_parameter_source source, float magnitude) {
    uint8_t data[6];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)source);
    mip_put_float(data + 2, &magnitude);
    return mip_device_send(device, &mip_filter_magnetic_magnitude_source_exchange, data, 6);
}

MIP_COMMAND_REPLIES(mip_filter_sensor_to_vehicle_rotation_dcm);
MIP_SEND(mip_send_filter_sensor_to_vehicle_rotation_dcm, mip_filter_sensor_to_vehicle_rotation_dcm,
         mip_filter_sensor_to_vehicle_rotation_dcm_response);
MIP_CALL_FOR(mip_call_filter_sensor_to_vehicle_rotation_dcm_read,
             mip_filter_sensor_to_vehicle_rotation_dcm, MIP_FUNCTION_SELECTOR_READ,
             mip_filter_sensor_to_vehicle_rotation_dcm_response);
MIP_CALL(mip_call_filter_sensor_to_vehicle_rotation_dcm_save,
         mip_filter_sensor_to_vehicle_rotation_dcm, MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_sensor_to_vehicle_rotation_dcm_load,
         mip_filter_sensor_to_vehicle_rotation_dcm, MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_sensor_to_vehicle_rotation_dcm_default,
         mip_filter_sensor_to_vehicle_rotation_dcm, MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_sensor_to_vehicle_rotation_dcm_with,
              mip_filter_sensor_to_vehicle_rotation_dcm,
              mip_filter_sensor_to_vehicle_rotation_dcm_response);

/**
 * Sensor to vehicle rotation, matrix: write.
 *
 * - dcm: Rotates vectors of the vehicle frame into the sensor frame; row-major. Elements: m11, m12,
 *   m13, m21, m22, m23, m31, m32, m33. Unit: 1. Required for write.
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

MIP_COMMAND_REPLIES(mip_filter_sensor_to_vehicle_quaternion);
MIP_SEND(mip_send_filter_sensor_to_vehicle_quaternion, mip_filter_sensor_to_vehicle_quaternion,
         mip_filter_sensor_to_vehicle_quaternion_response);
MIP_CALL_FOR(mip_call_filter_sensor_to_vehicle_quaternion_read,
             mip_filter_sensor_to_vehicle_quaternion, MIP_FUNCTION_SELECTOR_READ,
             mip_filter_sensor_to_vehicle_quaternion_response);
MIP_CALL(mip_call_filter_sensor_to_vehicle_quaternion_save, mip_filter_sensor_to_vehicle_quaternion,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_sensor_to_vehicle_quaternion_load, mip_filter_sensor_to_vehicle_quaternion,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_sensor_to_vehicle_quaternion_default,
         mip_filter_sensor_to_vehicle_quaternion, MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_sensor_to_vehicle_quaternion_with,
              mip_filter_sensor_to_vehicle_quaternion,
              mip_filter_sensor_to_vehicle_quaternion_response);

/**
 * Sensor to vehicle rotation, quaternion: write.
 *
 * - q: Rotates vectors of the sensor frame into the vehicle frame; unit quaternion, w first.
 *   Elements: w, x, y, z. Unit: 1. Range: magnitude 0.999 to 1.001. Required for write.
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

MIP_COMMAND_REPLIES(mip_filter_aiding_measurement_enable);
MIP_SEND(mip_send_filter_aiding_measurement_enable, mip_filter_aiding_measurement_enable,
         mip_filter_aiding_measurement_enable_response);
MIP_CALL_WITH(mip_call_filter_aiding_measurement_enable_with, mip_filter_aiding_measurement_enable,
              mip_filter_aiding_measurement_enable_response);

/**
 * Aiding measurement control: write.
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
 * Aiding measurement control: read.
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
 * Aiding measurement control: save.
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
 * Aiding measurement control: load.
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
 * Aiding measurement control: default.
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

MIP_COMMAND_REPLIES(mip_filter_kinematic_constraint);
MIP_SEND(mip_send_filter_kinematic_constraint, mip_filter_kinematic_constraint,
         mip_filter_kinematic_constraint_response);
MIP_CALL_FOR(mip_call_filter_kinematic_constraint_read, mip_filter_kinematic_constraint,
             MIP_FUNCTION_SELECTOR_READ, mip_filter_kinematic_constraint_response);
MIP_CALL(mip_call_filter_kinematic_constraint_save, mip_filter_kinematic_constraint,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_kinematic_constraint_load, mip_filter_kinematic_constraint,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_kinematic_constraint_default, mip_filter_kinematic_constraint,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_kinematic_constraint_with, mip_filter_kinematic_constraint,
              mip_filter_kinematic_constraint_response);

/**
 * Kinematic constraint: write.
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
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_WRITE, (uint8_t)accel_constraint,
                            (uint8_t)velocity_constraint, (uint8_t)angular_constraint};
    return mip_device_send(device, &mip_filter_kinematic_constraint_exchange, data, 4);
}

MIP_COMMAND_REPLIES(mip_filter_initialization_config);
MIP_SEND(mip_send_filter_initialization_config, mip_filter_initialization_config,
         mip_filter_initialization_config_response);
MIP_CALL_FOR(mip_call_filter_initialization_config_read, mip_filter_initialization_config,
             MIP_FUNCTION_SELECTOR_READ, mip_filter_initialization_config_response);
MIP_CALL(mip_call_filter_initialization_config_save, mip_filter_initialization_config,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_initialization_config_load, mip_filter_initialization_config,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_initialization_config_default, mip_filter_initialization_config,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_initialization_config_with, mip_filter_initialization_config,
              mip_filter_initialization_config_response);

/**
 * Navigation filter initialization: write.
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
 * - initial_heading: Initial heading relative to true north. Unit: deg. Frame: ned. Positive:
 *   clockwise seen from above. Required for write.
 * - initial_pitch: Initial pitch angle. Unit: deg. Frame: ned. Positive: nose up. Required for
 *   write.
 * - initial_roll: Initial roll angle. Unit: deg. Frame: ned. Positive: right side down. Required
 *   for write.
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

MIP_COMMAND_REPLIES(mip_filter_adaptive_filter_options);
MIP_SEND(mip_send_filter_adaptive_filter_options, mip_filter_adaptive_filter_options,
         mip_filter_adaptive_filter_options_response);
MIP_CALL_FOR(mip_call_filter_adaptive_filter_options_read, mip_filter_adaptive_filter_options,
             MIP_FUNCTION_SELECTOR_READ, mip_filter_adaptive_filter_options_response);
MIP_CALL(mip_call_filter_adaptive_filter_options_save, mip_filter_adaptive_filter_options,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_adaptive_filter_options_load, mip_filter_adaptive_filter_options,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_adaptive_filter_options_default, mip_filter_adaptive_filter_options,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_adaptive_filter_options_with, mip_filter_adaptive_filter_options,
              mip_filter_adaptive_filter_options_response);

/**
 * Adaptive filter control: write.
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

MIP_COMMAND_REPLIES(mip_filter_multi_antenna_offset);
MIP_SEND(mip_send_filter_multi_antenna_offset, mip_filter_multi_antenna_offset,
         mip_filter_multi_antenna_offset_response);
MIP_CALL_WITH(mip_call_filter_multi_antenna_offset_with, mip_filter_multi_antenna_offset,
              mip_filter_multi_antenna_offset_response);

/**
 * GNSS multi-antenna offset: write.
 *
 * - receiver_id: Number of the receiver, from 1. Range: at least 1.
 * - antenna_offset: Lever arm from the sensor to the antenna. Elements: x, y, z. Unit: m. Frame:
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
 * GNSS multi-antenna offset: read.
 *
 * - receiver_id: Number of the receiver, from 1. Range: at least 1.
 */
static inline struct mip_result mip_call_filter_multi_antenna_offset_read(
    struct mip_device *device, uint8_t receiver_id,
    struct mip_filter_multi_antenna_offset_response *response) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_READ, (uint8_t)receiver_id};
    return mip_device_request(device, &mip_filter_multi_antenna_offset_exchange, data, 2,
                              &mip_filter_multi_antenna_offset_response_codec, response);
}

/**
 * GNSS multi-antenna offset: save.
 *
 * - receiver_id: Number of the receiver, from 1. Range: at least 1.
 */
static inline struct mip_result mip_call_filter_multi_antenna_offset_save(struct mip_device *device,
                                                                          uint8_t receiver_id) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_SAVE, (uint8_t)receiver_id};
    return mip_device_send(device, &mip_filter_multi_antenna_offset_exchange, data, 2);
}

/**
 * GNSS multi-antenna offset: load.
 *
 * - receiver_id: Number of the receiver, from 1. Range: at least 1.
 */
static inline struct mip_result mip_call_filter_multi_antenna_offset_load(struct mip_device *device,
                                                                          uint8_t receiver_id) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_LOAD, (uint8_t)receiver_id};
    return mip_device_send(device, &mip_filter_multi_antenna_offset_exchange, data, 2);
}

/**
 * GNSS multi-antenna offset: default.
 *
 * - receiver_id: Number of the receiver, from 1. Range: at least 1.
 */
static inline struct mip_result
mip_call_filter_multi_antenna_offset_default(struct mip_device *device, uint8_t receiver_id) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT, (uint8_t)receiver_id};
    return mip_device_send(device, &mip_filter_multi_antenna_offset_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_filter_relative_position_config);
MIP_SEND(mip_send_filter_relative_position_config, mip_filter_relative_position_config,
         mip_filter_relative_position_config_response);
MIP_CALL_FOR(mip_call_filter_relative_position_config_read, mip_filter_relative_position_config,
             MIP_FUNCTION_SELECTOR_READ, mip_filter_relative_position_config_response);
MIP_CALL(mip_call_filter_relative_position_config_save, mip_filter_relative_position_config,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_relative_position_config_load, mip_filter_relative_position_config,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_relative_position_config_default, mip_filter_relative_position_config,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_relative_position_config_with, mip_filter_relative_position_config,
              mip_filter_relative_position_config_response);

/**
 * Relative position configuration: write.
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

MIP_COMMAND_REPLIES(mip_filter_reference_point_lever_arm);
MIP_SEND(mip_send_filter_reference_point_lever_arm, mip_filter_reference_point_lever_arm,
         mip_filter_reference_point_lever_arm_response);
MIP_CALL_FOR(mip_call_filter_reference_point_lever_arm_read, mip_filter_reference_point_lever_arm,
             MIP_FUNCTION_SELECTOR_READ, mip_filter_reference_point_lever_arm_response);
MIP_CALL(mip_call_filter_reference_point_lever_arm_save, mip_filter_reference_point_lever_arm,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_reference_point_lever_arm_load, mip_filter_reference_point_lever_arm,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_reference_point_lever_arm_default, mip_filter_reference_point_lever_arm,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_reference_point_lever_arm_with, mip_filter_reference_point_lever_arm,
              mip_filter_reference_point_lever_arm_response);

/**
 * Reference point lever arm: write.
 *
 * - reference_point: Point to move; it must be 1. A value of enum mip_filter_reference_point.
 *   Required for write.
 * - lever_arm_offset: Lever arm from the sensor to the point. Elements: x, y, z. Unit: m. Frame:
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

MIP_COMMAND_REPLIES(mip_filter_speed_measurement);

/** Speed measurement: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_filter_speed_measurement(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_filter_speed_measurement *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_filter_speed_measurement_command, command,
                           NULL, NULL, now);
}

/**
 * Speed measurement.
 *
 * - tow: GPS time of week of the measurement. Unit: s. Range: 0 to 604800. Uncertain: The unit is
 *   inferred; the SDK states none.
 * - speed: Speed along the x axis of the vehicle. Unit: m/s. Frame: vehicle. Positive: forward.
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

/** Speed measurement, with these values, including optional parameters. */
static inline struct mip_result mip_call_filter_speed_measurement_with(
    struct mip_device *device, const struct mip_filter_speed_measurement *command) {
    return mip_device_call(device, &mip_filter_speed_measurement_command, command, NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_filter_speed_lever_arm);
MIP_SEND(mip_send_filter_speed_lever_arm, mip_filter_speed_lever_arm,
         mip_filter_speed_lever_arm_response);
MIP_CALL_WITH(mip_call_filter_speed_lever_arm_with, mip_filter_speed_lever_arm,
              mip_filter_speed_lever_arm_response);

/**
 * Speed measurement lever arm: write.
 *
 * - lever_arm_offset: Lever arm from the sensor to the point of measurement. Elements: x, y, z.
 *   Unit: m. Frame: vehicle. Required for write.
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

/** Speed measurement lever arm: read. */
static inline struct mip_result mip_call_filter_speed_lever_arm_read(
    struct mip_device *device, struct mip_filter_speed_lever_arm_response *response) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_READ, (uint8_t)1};
    return mip_device_request(device, &mip_filter_speed_lever_arm_exchange, data, 2,
                              &mip_filter_speed_lever_arm_response_codec, response);
}

/** Speed measurement lever arm: save. */
static inline struct mip_result mip_call_filter_speed_lever_arm_save(struct mip_device *device) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_SAVE, (uint8_t)1};
    return mip_device_send(device, &mip_filter_speed_lever_arm_exchange, data, 2);
}

/** Speed measurement lever arm: load. */
static inline struct mip_result mip_call_filter_speed_lever_arm_load(struct mip_device *device) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_LOAD, (uint8_t)1};
    return mip_device_send(device, &mip_filter_speed_lever_arm_exchange, data, 2);
}

/** Speed measurement lever arm: default. */
static inline struct mip_result mip_call_filter_speed_lever_arm_default(struct mip_device *device) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT, (uint8_t)1};
    return mip_device_send(device, &mip_filter_speed_lever_arm_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_filter_vertical_gyro_constraint_control);
MIP_SEND(mip_send_filter_vertical_gyro_constraint_control,
         mip_filter_vertical_gyro_constraint_control,
         mip_filter_vertical_gyro_constraint_control_response);
MIP_CALL_FOR(mip_call_filter_vertical_gyro_constraint_control_read,
             mip_filter_vertical_gyro_constraint_control, MIP_FUNCTION_SELECTOR_READ,
             mip_filter_vertical_gyro_constraint_control_response);
MIP_CALL(mip_call_filter_vertical_gyro_constraint_control_save,
         mip_filter_vertical_gyro_constraint_control, MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_vertical_gyro_constraint_control_load,
         mip_filter_vertical_gyro_constraint_control, MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_vertical_gyro_constraint_control_default,
         mip_filter_vertical_gyro_constraint_control, MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_vertical_gyro_constraint_control_with,
              mip_filter_vertical_gyro_constraint_control,
              mip_filter_vertical_gyro_constraint_control_response);

/**
 * Vertical gyro constraint: write.
 *
 * - enable: 0 disables, 1 enables. Range: 0 to 1. Required for write.
 */
static inline struct mip_result
mip_call_filter_vertical_gyro_constraint_control_write(struct mip_device *device, uint8_t enable) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_WRITE, (uint8_t)enable};
    return mip_device_send(device, &mip_filter_vertical_gyro_constraint_control_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_filter_wheeled_vehicle_constraint_control);
MIP_SEND(mip_send_filter_wheeled_vehicle_constraint_control,
         mip_filter_wheeled_vehicle_constraint_control,
         mip_filter_wheeled_vehicle_constraint_control_response);
MIP_CALL_FOR(mip_call_filter_wheeled_vehicle_constraint_control_read,
             mip_filter_wheeled_vehicle_constraint_control, MIP_FUNCTION_SELECTOR_READ,
             mip_filter_wheeled_vehicle_constraint_control_response);
MIP_CALL(mip_call_filter_wheeled_vehicle_constraint_control_save,
         mip_filter_wheeled_vehicle_constraint_control, MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_wheeled_vehicle_constraint_control_load,
         mip_filter_wheeled_vehicle_constraint_control, MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_wheeled_vehicle_constraint_control_default,
         mip_filter_wheeled_vehicle_constraint_control, MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_wheeled_vehicle_constraint_control_with,
              mip_filter_wheeled_vehicle_constraint_control,
              mip_filter_wheeled_vehicle_constraint_control_response);

/**
 * Wheeled vehicle constraint: write.
 *
 * - enable: 0 disables, 1 enables. Range: 0 to 1. Required for write.
 */
static inline struct mip_result mip_call_filter_wheeled_vehicle_constraint_control_write(
    struct mip_device *device, uint8_t enable) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_WRITE, (uint8_t)enable};
    return mip_device_send(device, &mip_filter_wheeled_vehicle_constraint_control_exchange, data,
                           2);
}

MIP_COMMAND_REPLIES(mip_filter_gnss_antenna_calibration_control);
MIP_SEND(mip_send_filter_gnss_antenna_calibration_control,
         mip_filter_gnss_antenna_calibration_control,
         mip_filter_gnss_antenna_calibration_control_response);
MIP_CALL_FOR(mip_call_filter_gnss_antenna_calibration_control_read,
             mip_filter_gnss_antenna_calibration_control, MIP_FUNCTION_SELECTOR_READ,
             mip_filter_gnss_antenna_calibration_control_response);
MIP_CALL(mip_call_filter_gnss_antenna_calibration_control_save,
         mip_filter_gnss_antenna_calibration_control, MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_filter_gnss_antenna_calibration_control_load,
         mip_filter_gnss_antenna_calibration_control, MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_filter_gnss_antenna_calibration_control_default,
         mip_filter_gnss_antenna_calibration_control, MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_filter_gnss_antenna_calibration_control_with,
              mip_filter_gnss_antenna_calibration_control,
              mip_filter_gnss_antenna_calibration_control_response);

/**
 * GNSS antenna offset calibration: write.
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

/** @} */

#ifdef __cplusplus
}
#endif

#endif
