/**
 * @file
 * The commands of Aiding commands, each with the types of its parameters and of its response.
 */
#ifndef MIP_AIDING_COMMANDS_H
#define MIP_AIDING_COMMANDS_H

#include "mip/aiding.h"
#include "mip/device.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/aiding_commands.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_aiding Aiding commands (0x13)
 * @{ */

MIP_COMMAND_REPLIES(mip_aiding_frame_config);
MIP_SEND(mip_send_aiding_frame_config, mip_aiding_frame_config, mip_aiding_frame_config_response);
MIP_CALL_WITH(mip_call_aiding_frame_config_with, mip_aiding_frame_config,
              mip_aiding_frame_config_response);

/**
 * Frame configuration: write.
 *
 * - frame_id: Number of the frame. Range: 1 to 4.
 * - format: Format of the rotation. A value of enum mip_aiding_frame_format. Required for write and
 *   read.
 * - tracking_enabled: True if the filter estimates the errors of the frame. Required for write.
 * - translation: Position of the frame's origin in the vehicle frame. Elements: x, y, z. Unit: m.
 *   Frame: vehicle. Required for write.
 * - rotation: Rotates vectors of this frame into the vehicle frame. Selected by format. Required
 *   for write.
 */
static inline struct mip_result mip_call_aiding_frame_config_write(
    struct mip_device *device, uint8_t frame_id, enum mip_aiding_frame_format format,
    mip_bool tracking_enabled, const float translation[3],
    const union mip_aiding_frame_config_rotation *rotation) {
    struct mip_aiding_frame_config command;
    return mip_device_call(device, &mip_aiding_frame_config_command,
                           mip_aiding_frame_config_write(&command, frame_id, format,
                                                         tracking_enabled, translation, rotation),
                           NULL, NULL);
}

/**
 * Frame configuration: read.
 *
 * - frame_id: Number of the frame. Range: 1 to 4.
 * - format: Format of the rotation. A value of enum mip_aiding_frame_format. Required for write and
 *   read.
 */
static inline struct mip_result mip_call_aiding_frame_config_read(
    struct mip_device *device, uint8_t frame_id, enum mip_aiding_frame_format format,
    struct mip_aiding_frame_config_response *response) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_READ, (uint8_t)frame_id,
                            (uint8_t)format};
    return mip_device_request(device, &mip_aiding_frame_config_exchange, data, 3,
                              &mip_aiding_frame_config_response_codec, response);
}

/**
 * Frame configuration: save.
 *
 * - frame_id: Number of the frame. Range: 1 to 4.
 */
static inline struct mip_result mip_call_aiding_frame_config_save(struct mip_device *device,
                                                                  uint8_t frame_id) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_SAVE, (uint8_t)frame_id};
    return mip_device_send(device, &mip_aiding_frame_config_exchange, data, 2);
}

/**
 * Frame configuration: load.
 *
 * - frame_id: Number of the frame. Range: 1 to 4.
 */
static inline struct mip_result mip_call_aiding_frame_config_load(struct mip_device *device,
                                                                  uint8_t frame_id) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_LOAD, (uint8_t)frame_id};
    return mip_device_send(device, &mip_aiding_frame_config_exchange, data, 2);
}

/**
 * Frame configuration: default.
 *
 * - frame_id: Number of the frame. Range: 1 to 4.
 */
static inline struct mip_result mip_call_aiding_frame_config_default(struct mip_device *device,
                                                                     uint8_t frame_id) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT, (uint8_t)frame_id};
    return mip_device_send(device, &mip_aiding_frame_config_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_aiding_sensor_frame_map);
MIP_SEND(mip_send_aiding_sensor_frame_map, mip_aiding_sensor_frame_map,
         mip_aiding_sensor_frame_map_response);
MIP_CALL_FOR(mip_call_aiding_sensor_frame_map_read, mip_aiding_sensor_frame_map,
             MIP_FUNCTION_SELECTOR_READ, mip_aiding_sensor_frame_map_response);
MIP_CALL(mip_call_aiding_sensor_frame_map_save, mip_aiding_sensor_frame_map,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_aiding_sensor_frame_map_load, mip_aiding_sensor_frame_map,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_aiding_sensor_frame_map_default, mip_aiding_sensor_frame_map,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_aiding_sensor_frame_map_with, mip_aiding_sensor_frame_map,
              mip_aiding_sensor_frame_map_response);

/**
 * Sensor frame map: write.
 *
 * - sensor_id: Number of the sensor. Range: at least 1. Required for write.
 * - frame_id: Frame of the sensor, defined by mip_aiding_frame_config. Range: 1 to 4. Default: 1.
 *   Required for write.
 */
static inline struct mip_result mip_call_aiding_sensor_frame_map_write(struct mip_device *device,
                                                                       uint8_t sensor_id,
                                                                       uint8_t frame_id) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_WRITE, (uint8_t)sensor_id,
                            (uint8_t)frame_id};
    return mip_device_send(device, &mip_aiding_sensor_frame_map_exchange, data, 3);
}

MIP_COMMAND_REPLIES(mip_aiding_echo_control);
MIP_SEND(mip_send_aiding_echo_control, mip_aiding_echo_control, mip_aiding_echo_control_response);
MIP_CALL_FOR(mip_call_aiding_echo_control_read, mip_aiding_echo_control, MIP_FUNCTION_SELECTOR_READ,
             mip_aiding_echo_control_response);
MIP_CALL(mip_call_aiding_echo_control_save, mip_aiding_echo_control, MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_aiding_echo_control_load, mip_aiding_echo_control, MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_aiding_echo_control_default, mip_aiding_echo_control,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_aiding_echo_control_with, mip_aiding_echo_control,
              mip_aiding_echo_control_response);

/**
 * Echo control: write.
 *
 * - mode: Reply mode. A value of enum mip_aiding_echo_mode. Required for write.
 */
static inline struct mip_result mip_call_aiding_echo_control_write(struct mip_device *device,
                                                                   enum mip_aiding_echo_mode mode) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_WRITE, (uint8_t)mode};
    return mip_device_send(device, &mip_aiding_echo_control_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_aiding_ecef_position);

/** ECEF position: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_aiding_ecef_position(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_aiding_ecef_position *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_aiding_ecef_position_command, command,
                           NULL, NULL, now);
}

/**
 * ECEF position.
 *
 * - time: Time of the measurement.
 * - frame_id: Sensor frame, defined by mip_aiding_frame_config. Range: 1 to 4.
 * - position: Position of the origin of the frame. Elements: x, y, z. Unit: m. Frame: ecef. Each
 *   element has its own valid flag. x: MIP_AIDING_AXIS_FLAGS_X in valid_flags, y:
 *   MIP_AIDING_AXIS_FLAGS_Y in valid_flags, z: MIP_AIDING_AXIS_FLAGS_Z in valid_flags.
 * - uncertainty: Uncertainty of the position. Elements: x, y, z. Unit: m. Frame: ecef. Range:
 *   greater than 0. Each element has its own valid flag. x: MIP_AIDING_AXIS_FLAGS_X in valid_flags,
 *   y: MIP_AIDING_AXIS_FLAGS_Y in valid_flags, z: MIP_AIDING_AXIS_FLAGS_Z in valid_flags.
 * - valid_flags: Valid axes.
 */
static inline struct mip_result mip_call_aiding_ecef_position(
    struct mip_device *device, const struct mip_aiding_measurement_time *time, uint8_t frame_id,
    const double position[3], const float uncertainty[3], mip_aiding_axis_flags valid_flags) {
    struct mip_aiding_ecef_position command;
    return mip_device_call(
        device, &mip_aiding_ecef_position_command,
        mip_aiding_ecef_position_make(&command, time, frame_id, position, uncertainty, valid_flags),
        NULL, NULL);
}

/** ECEF position, with these values, including optional parameters. */
static inline struct mip_result mip_call_aiding_ecef_position_with(
    struct mip_device *device, const struct mip_aiding_ecef_position *command) {
    return mip_device_call(device, &mip_aiding_ecef_position_command, command, NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_aiding_llh_position);

/** LLH position: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_aiding_llh_position(struct mip_client *client,
                                                     struct mip_request *request,
                                                     struct mip_builder *packet,
                                                     const struct mip_aiding_llh_position *command,
                                                     uint32_t now) {
    return mip_client_send(client, request, packet, &mip_aiding_llh_position_command, command, NULL,
                           NULL, now);
}

/**
 * LLH position.
 *
 * - time: Time of the measurement.
 * - frame_id: Sensor frame, defined by mip_aiding_frame_config. Range: 1 to 4.
 * - latitude: Geodetic latitude. Unit: deg. Frame: llh. Range: -90 to 90. Positive: north. Valid if
 *   MIP_AIDING_LLH_AXIS_FLAGS_LATITUDE in valid_flags is set.
 * - longitude: Geodetic longitude. Unit: deg. Frame: llh. Range: -180 to 180. Positive: east. Valid
 *   if MIP_AIDING_LLH_AXIS_FLAGS_LONGITUDE in valid_flags is set.
 * - height: Height above the ellipsoid. Unit: m. Frame: llh. Valid if
 *   MIP_AIDING_LLH_AXIS_FLAGS_HEIGHT in valid_flags is set.
 * - uncertainty: Uncertainty of the position. Elements: north, east, down. Unit: m. Frame: ned.
 *   Range: greater than 0. Each element has its own valid flag. north:
 *   MIP_AIDING_LLH_AXIS_FLAGS_LATITUDE in valid_flags, east: MIP_AIDING_LLH_AXIS_FLAGS_LONGITUDE in
 *   valid_flags, down: MIP_AIDING_LLH_AXIS_FLAGS_HEIGHT in valid_flags.
 * - valid_flags: Valid coordinates.
 */
static inline struct mip_result mip_call_aiding_llh_position(
    struct mip_device *device, const struct mip_aiding_measurement_time *time, uint8_t frame_id,
    double latitude, double longitude, double height, const float uncertainty[3],
    mip_aiding_llh_axis_flags valid_flags) {
    struct mip_aiding_llh_position command;
    return mip_device_call(device, &mip_aiding_llh_position_command,
                           mip_aiding_llh_position_make(&command, time, frame_id, latitude,
                                                        longitude, height, uncertainty,
                                                        valid_flags),
                           NULL, NULL);
}

/** LLH position, with these values, including optional parameters. */
static inline struct mip_result mip_call_aiding_llh_position_with(
    struct mip_device *device, const struct mip_aiding_llh_position *command) {
    return mip_device_call(device, &mip_aiding_llh_position_command, command, NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_aiding_height_above_ellipsoid);

/** Height above ellipsoid: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_aiding_height_above_ellipsoid(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_aiding_height_above_ellipsoid *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_aiding_height_above_ellipsoid_command,
                           command, NULL, NULL, now);
}

/**
 * Height above ellipsoid.
 *
 * - time: Time of the measurement.
 * - frame_id: Sensor frame, defined by mip_aiding_frame_config. Range: 1 to 4.
 * - height: Height above the ellipsoid. Unit: m. Frame: llh.
 * - uncertainty: Uncertainty of the height. Unit: m. Range: at least 0.
 * - valid_flags: Nonzero if the measurement is valid.
 */
static inline struct mip_result mip_call_aiding_height_above_ellipsoid(
    struct mip_device *device, const struct mip_aiding_measurement_time *time, uint8_t frame_id,
    float height, float uncertainty, uint16_t valid_flags) {
    struct mip_aiding_height_above_ellipsoid command;
    return mip_device_call(device, &mip_aiding_height_above_ellipsoid_command,
                           mip_aiding_height_above_ellipsoid_make(&command, time, frame_id, height,
                                                                  uncertainty, valid_flags),
                           NULL, NULL);
}

/** Height above ellipsoid, with these values, including optional parameters. */
static inline struct mip_result mip_call_aiding_height_above_ellipsoid_with(
    struct mip_device *device, const struct mip_aiding_height_above_ellipsoid *command) {
    return mip_device_call(device, &mip_aiding_height_above_ellipsoid_command, command, NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_aiding_pressure_old);

/** Pressure (old): adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_aiding_pressure_old(struct mip_client *client,
                                                     struct mip_request *request,
                                                     struct mip_builder *packet,
                                                     const struct mip_aiding_pressure_old *command,
                                                     uint32_t now) {
    return mip_client_send(client, request, packet, &mip_aiding_pressure_old_command, command, NULL,
                           NULL, now);
}

/**
 * Pressure (old).
 *
 * - time: Time of the measurement.
 * - frame_id: Sensor frame, defined by mip_aiding_frame_config. Range: 1 to 4.
 * - pressure: Air pressure. Unit: mbar.
 * - uncertainty: Standard deviation of the pressure. Unit: mbar. Range: greater than 0.
 * - valid_flags: Nonzero if the measurement is valid.
 */
static inline struct mip_result mip_call_aiding_pressure_old(
    struct mip_device *device, const struct mip_aiding_measurement_time *time, uint8_t frame_id,
    float pressure, float uncertainty, uint16_t valid_flags) {
    struct mip_aiding_pressure_old command;
    return mip_device_call(
        device, &mip_aiding_pressure_old_command,
        mip_aiding_pressure_old_make(&command, time, frame_id, pressure, uncertainty, valid_flags),
        NULL, NULL);
}

/** Pressure (old), with these values, including optional parameters. */
static inline struct mip_result mip_call_aiding_pressure_old_with(
    struct mip_device *device, const struct mip_aiding_pressure_old *command) {
    return mip_device_call(device, &mip_aiding_pressure_old_command, command, NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_aiding_ecef_velocity);

/** ECEF velocity: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_aiding_ecef_velocity(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_aiding_ecef_velocity *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_aiding_ecef_velocity_command, command,
                           NULL, NULL, now);
}

/**
 * ECEF velocity.
 *
 * - time: Time of the measurement.
 * - frame_id: Sensor frame, defined by mip_aiding_frame_config. Range: 1 to 4.
 * - velocity: Velocity of the origin of the frame. Elements: x, y, z. Unit: m/s. Frame: ecef. Each
 *   element has its own valid flag. x: MIP_AIDING_AXIS_FLAGS_X in valid_flags, y:
 *   MIP_AIDING_AXIS_FLAGS_Y in valid_flags, z: MIP_AIDING_AXIS_FLAGS_Z in valid_flags.
 * - uncertainty: Uncertainty of the velocity. Elements: x, y, z. Unit: m/s. Frame: ecef. Range:
 *   greater than 0. Each element has its own valid flag. x: MIP_AIDING_AXIS_FLAGS_X in valid_flags,
 *   y: MIP_AIDING_AXIS_FLAGS_Y in valid_flags, z: MIP_AIDING_AXIS_FLAGS_Z in valid_flags.
 * - valid_flags: Valid axes.
 */
static inline struct mip_result mip_call_aiding_ecef_velocity(
    struct mip_device *device, const struct mip_aiding_measurement_time *time, uint8_t frame_id,
    const float velocity[3], const float uncertainty[3], mip_aiding_axis_flags valid_flags) {
    struct mip_aiding_ecef_velocity command;
    return mip_device_call(
        device, &mip_aiding_ecef_velocity_command,
        mip_aiding_ecef_velocity_make(&command, time, frame_id, velocity, uncertainty, valid_flags),
        NULL, NULL);
}

/** ECEF velocity, with these values, including optional parameters. */
static inline struct mip_result mip_call_aiding_ecef_velocity_with(
    struct mip_device *device, const struct mip_aiding_ecef_velocity *command) {
    return mip_device_call(device, &mip_aiding_ecef_velocity_command, command, NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_aiding_ned_velocity);

/** NED velocity: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_aiding_ned_velocity(struct mip_client *client,
                                                     struct mip_request *request,
                                                     struct mip_builder *packet,
                                                     const struct mip_aiding_ned_velocity *command,
                                                     uint32_t now) {
    return mip_client_send(client, request, packet, &mip_aiding_ned_velocity_command, command, NULL,
                           NULL, now);
}

/**
 * NED velocity.
 *
 * - time: Time of the measurement.
 * - frame_id: Sensor frame, defined by mip_aiding_frame_config. Range: 1 to 4.
 * - velocity: Velocity of the origin of the frame. Elements: north, east, down. Unit: m/s. Frame:
 *   ned. Each element has its own valid flag. north: MIP_AIDING_AXIS_FLAGS_X in valid_flags, east:
 *   MIP_AIDING_AXIS_FLAGS_Y in valid_flags, down: MIP_AIDING_AXIS_FLAGS_Z in valid_flags.
 * - uncertainty: Uncertainty of the velocity. Elements: north, east, down. Unit: m/s. Frame: ned.
 *   Range: greater than 0. Each element has its own valid flag. north: MIP_AIDING_AXIS_FLAGS_X in
 *   valid_flags, east: MIP_AIDING_AXIS_FLAGS_Y in valid_flags, down: MIP_AIDING_AXIS_FLAGS_Z in
 *   valid_flags.
 * - valid_flags: Valid axes.
 */
static inline struct mip_result mip_call_aiding_ned_velocity(
    struct mip_device *device, const struct mip_aiding_measurement_time *time, uint8_t frame_id,
    const float velocity[3], const float uncertainty[3], mip_aiding_axis_flags valid_flags) {
    struct mip_aiding_ned_velocity command;
    return mip_device_call(
        device, &mip_aiding_ned_velocity_command,
        mip_aiding_ned_velocity_make(&command, time, frame_id, velocity, uncertainty, valid_flags),
        NULL, NULL);
}

/** NED velocity, with these values, including optional parameters. */
static inline struct mip_result mip_call_aiding_ned_velocity_with(
    struct mip_device *device, const struct mip_aiding_ned_velocity *command) {
    return mip_device_call(device, &mip_aiding_ned_velocity_command, command, NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_aiding_body_frame_velocity);

/** Body frame velocity: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_aiding_body_frame_velocity(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_aiding_body_frame_velocity *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_aiding_body_frame_velocity_command,
                           command, NULL, NULL, now);
}

/**
 * Body frame velocity.
 *
 * - time: Time of the measurement.
 * - frame_id: Sensor frame, defined by mip_aiding_frame_config. Range: 1 to 4.
 * - velocity: Velocity of the origin of the frame. Elements: x, y, z. Unit: m/s. Frame: aiding.
 *   Each element has its own valid flag. x: MIP_AIDING_AXIS_FLAGS_X in valid_flags, y:
 *   MIP_AIDING_AXIS_FLAGS_Y in valid_flags, z: MIP_AIDING_AXIS_FLAGS_Z in valid_flags.
 * - uncertainty: Standard deviation of the velocity. Elements: x, y, z. Unit: m/s. Frame: aiding.
 *   Range: greater than 0. Each element has its own valid flag. x: MIP_AIDING_AXIS_FLAGS_X in
 *   valid_flags, y: MIP_AIDING_AXIS_FLAGS_Y in valid_flags, z: MIP_AIDING_AXIS_FLAGS_Z in
 *   valid_flags.
 * - valid_flags: Valid axes.
 */
static inline struct mip_result mip_call_aiding_body_frame_velocity(
    struct mip_device *device, const struct mip_aiding_measurement_time *time, uint8_t frame_id,
    const float velocity[3], const float uncertainty[3], mip_aiding_axis_flags valid_flags) {
    struct mip_aiding_body_frame_velocity command;
    return mip_device_call(device, &mip_aiding_body_frame_velocity_command,
                           mip_aiding_body_frame_velocity_make(&command, time, frame_id, velocity,
                                                               uncertainty, valid_flags),
                           NULL, NULL);
}

/** Body frame velocity, with these values, including optional parameters. */
static inline struct mip_result mip_call_aiding_body_frame_velocity_with(
    struct mip_device *device, const struct mip_aiding_body_frame_velocity *command) {
    return mip_device_call(device, &mip_aiding_body_frame_velocity_command, command, NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_aiding_true_heading);

/** True heading: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_aiding_true_heading(struct mip_client *client,
                                                     struct mip_request *request,
                                                     struct mip_builder *packet,
                                                     const struct mip_aiding_true_heading *command,
                                                     uint32_t now) {
    return mip_client_send(client, request, packet, &mip_aiding_true_heading_command, command, NULL,
                           NULL, now);
}

/**
 * True heading.
 *
 * - time: Time of the measurement.
 * - frame_id: Sensor frame, defined by mip_aiding_frame_config. Range: 1 to 4.
 * - heading: Heading relative to true north. Unit: rad. Frame: ned. Range: -pi to pi. Positive:
 *   clockwise seen from above.
 * - uncertainty: Uncertainty of the heading. Unit: rad. Range: greater than 0.
 * - valid_flags: Nonzero if the measurement is valid.
 */
static inline struct mip_result mip_call_aiding_true_heading(
    struct mip_device *device, const struct mip_aiding_measurement_time *time, uint8_t frame_id,
    float heading, float uncertainty, uint16_t valid_flags) {
    struct mip_aiding_true_heading command;
    return mip_device_call(
        device, &mip_aiding_true_heading_command,
        mip_aiding_true_heading_make(&command, time, frame_id, heading, uncertainty, valid_flags),
        NULL, NULL);
}

/** True heading, with these values, including optional parameters. */
static inline struct mip_result mip_call_aiding_true_heading_with(
    struct mip_device *device, const struct mip_aiding_true_heading *command) {
    return mip_device_call(device, &mip_aiding_true_heading_command, command, NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_aiding_magnetic_field);

/** Magnetic field: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_aiding_magnetic_field(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_aiding_magnetic_field *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_aiding_magnetic_field_command, command,
                           NULL, NULL, now);
}

/**
 * Magnetic field.
 *
 * - time: Time of the measurement.
 * - frame_id: Sensor frame, defined by mip_aiding_frame_config. Range: 1 to 4.
 * - magnetic_field: Calibrated magnetic field. Elements: x, y, z. Unit: gauss. Frame: aiding. Each
 *   element has its own valid flag. x: MIP_AIDING_AXIS_FLAGS_X in valid_flags, y:
 *   MIP_AIDING_AXIS_FLAGS_Y in valid_flags, z: MIP_AIDING_AXIS_FLAGS_Z in valid_flags.
 * - uncertainty: Standard deviation of the magnetic field. Elements: x, y, z. Unit: gauss. Frame:
 *   aiding. Range: greater than 0. Each element has its own valid flag. x: MIP_AIDING_AXIS_FLAGS_X
 *   in valid_flags, y: MIP_AIDING_AXIS_FLAGS_Y in valid_flags, z: MIP_AIDING_AXIS_FLAGS_Z in
 *   valid_flags.
 * - valid_flags: Valid axes.
 */
static inline struct mip_result mip_call_aiding_magnetic_field(
    struct mip_device *device, const struct mip_aiding_measurement_time *time, uint8_t frame_id,
    const float magnetic_field[3], const float uncertainty[3], mip_aiding_axis_flags valid_flags) {
    struct mip_aiding_magnetic_field command;
    return mip_device_call(device, &mip_aiding_magnetic_field_command,
                           mip_aiding_magnetic_field_make(&command, time, frame_id, magnetic_field,
                                                          uncertainty, valid_flags),
                           NULL, NULL);
}

/** Magnetic field, with these values, including optional parameters. */
static inline struct mip_result mip_call_aiding_magnetic_field_with(
    struct mip_device *device, const struct mip_aiding_magnetic_field *command) {
    return mip_device_call(device, &mip_aiding_magnetic_field_command, command, NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_aiding_pressure);

/** Pressure: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_aiding_pressure(struct mip_client *client,
                                                 struct mip_request *request,
                                                 struct mip_builder *packet,
                                                 const struct mip_aiding_pressure *command,
                                                 uint32_t now) {
    return mip_client_send(client, request, packet, &mip_aiding_pressure_command, command, NULL,
                           NULL, now);
}

/**
 * Pressure.
 *
 * - time: Time of the measurement.
 * - frame_id: Sensor frame, defined by mip_aiding_frame_config. Range: 1 to 4.
 * - pressure: Air pressure. Unit: mbar.
 * - uncertainty: Standard deviation of the pressure. Unit: mbar. Range: greater than 0.
 * - valid_flags: Nonzero if the measurement is valid.
 */
static inline struct mip_result mip_call_aiding_pressure(
    struct mip_device *device, const struct mip_aiding_measurement_time *time, uint8_t frame_id,
    float pressure, float uncertainty, uint16_t valid_flags) {
    struct mip_aiding_pressure command;
    return mip_device_call(
        device, &mip_aiding_pressure_command,
        mip_aiding_pressure_make(&command, time, frame_id, pressure, uncertainty, valid_flags),
        NULL, NULL);
}

/** Pressure, with these values, including optional parameters. */
static inline struct mip_result mip_call_aiding_pressure_with(
    struct mip_device *device, const struct mip_aiding_pressure *command) {
    return mip_device_call(device, &mip_aiding_pressure_command, command, NULL, NULL);
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
