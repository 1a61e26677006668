/**
 * @file
 * The commands of 3DM, each with the types of its parameters and of its response.
 */
#ifndef MIP_3DM_COMMANDS_H
#define MIP_3DM_COMMANDS_H

#include "mip/3dm.h"
#include "mip/client.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/3dm_commands.h and mip/constants.h are not of one version"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_poll_imu_data_command;

/** Adds the command to a packet and waits for its answer: see mip_client_send. Poll IMU Data. */
static inline mip_error mip_send_3dm_poll_imu_data(struct mip_client *client,
                                                   struct mip_request *request,
                                                   struct mip_builder *packet,
                                                   const struct mip_3dm_poll_imu_data *command,
                                                   uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_poll_imu_data_command, command, NULL,
                           NULL, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_poll_gnss_data_command;

/** Adds the command to a packet and waits for its answer: see mip_client_send. Poll GNSS Data. */
static inline mip_error mip_send_3dm_poll_gnss_data(struct mip_client *client,
                                                    struct mip_request *request,
                                                    struct mip_builder *packet,
                                                    const struct mip_3dm_poll_gnss_data *command,
                                                    uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_poll_gnss_data_command, command, NULL,
                           NULL, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_poll_filter_data_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Poll Estimation
 * Filter Data.
 */
static inline mip_error mip_send_3dm_poll_filter_data(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_poll_filter_data *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_poll_filter_data_command, command,
                           NULL, NULL, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_poll_nmea_data_command;

/** Adds the command to a packet and waits for its answer: see mip_client_send. Poll NMEA Data. */
static inline mip_error mip_send_3dm_poll_nmea_data(struct mip_client *client,
                                                    struct mip_request *request,
                                                    struct mip_builder *packet,
                                                    const struct mip_3dm_poll_nmea_data *command,
                                                    uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_poll_nmea_data_command, command, NULL,
                           NULL, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_get_imu_base_rate_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Get IMU Data Base
 * Rate. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_get_imu_base_rate(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    struct mip_3dm_get_imu_base_rate_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_get_imu_base_rate_command, NULL,
                           &mip_3dm_get_imu_base_rate_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_get_gnss_base_rate_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Get GNSS Data Base
 * Rate. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_get_gnss_base_rate(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    struct mip_3dm_get_gnss_base_rate_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_get_gnss_base_rate_command, NULL,
                           &mip_3dm_get_gnss_base_rate_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_imu_message_format_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. IMU Message Format.
 * The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_imu_message_format(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_imu_message_format *command,
    struct mip_3dm_imu_message_format_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_imu_message_format_command, command,
                           &mip_3dm_imu_message_format_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_gnss_message_format_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. GNSS Message Format.
 * The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_gnss_message_format(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_gnss_message_format *command,
    struct mip_3dm_gnss_message_format_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_gnss_message_format_command, command,
                           &mip_3dm_gnss_message_format_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_filter_message_format_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Estimation Filter
 * Message Format. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_filter_message_format(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_filter_message_format *command,
    struct mip_3dm_filter_message_format_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_filter_message_format_command, command,
                           &mip_3dm_filter_message_format_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_get_filter_base_rate_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Get Estimation Filter
 * Data Base Rate. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_get_filter_base_rate(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    struct mip_3dm_get_filter_base_rate_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_get_filter_base_rate_command, NULL,
                           &mip_3dm_get_filter_base_rate_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_nmea_message_format_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. NMEA Message Format.
 * The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_nmea_message_format(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_nmea_message_format *command,
    struct mip_3dm_nmea_message_format_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_nmea_message_format_command, command,
                           &mip_3dm_nmea_message_format_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_poll_data_command;

/** Adds the command to a packet and waits for its answer: see mip_client_send. Poll Data. */
static inline mip_error mip_send_3dm_poll_data(struct mip_client *client,
                                               struct mip_request *request,
                                               struct mip_builder *packet,
                                               const struct mip_3dm_poll_data *command,
                                               uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_poll_data_command, command, NULL, NULL,
                           now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_get_base_rate_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Get Data Base Rate.
 * The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_get_base_rate(struct mip_client *client,
                                                   struct mip_request *request,
                                                   struct mip_builder *packet,
                                                   const struct mip_3dm_get_base_rate *command,
                                                   struct mip_3dm_get_base_rate_response *response,
                                                   uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_get_base_rate_command, command,
                           &mip_3dm_get_base_rate_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_message_format_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Message Format. The
 * response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_message_format(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_message_format *command, struct mip_3dm_message_format_response *response,
    uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_message_format_command, command,
                           &mip_3dm_message_format_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_factory_streaming_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Factory Streaming.
 */
static inline mip_error mip_send_3dm_factory_streaming(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_factory_streaming *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_factory_streaming_command, command,
                           NULL, NULL, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_data_stream_control_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Data Stream Control.
 * The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_data_stream_control(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_data_stream_control *command,
    struct mip_3dm_data_stream_control_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_data_stream_control_command, command,
                           &mip_3dm_data_stream_control_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_constellation_settings_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Constellation
 * Settings. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_constellation_settings(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_constellation_settings *command,
    struct mip_3dm_constellation_settings_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_constellation_settings_command,
                           command, &mip_3dm_constellation_settings_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_gnss_sbas_settings_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. GNSS SBAS Settings.
 * The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_gnss_sbas_settings(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_gnss_sbas_settings *command,
    struct mip_3dm_gnss_sbas_settings_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_gnss_sbas_settings_command, command,
                           &mip_3dm_gnss_sbas_settings_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_gnss_assisted_fix_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. GNSS Assisted Fix.
 * The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_gnss_assisted_fix(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_gnss_assisted_fix *command,
    struct mip_3dm_gnss_assisted_fix_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_gnss_assisted_fix_command, command,
                           &mip_3dm_gnss_assisted_fix_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_gnss_time_assistance_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. GNSS Time Assistance.
 * The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_gnss_time_assistance(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_gnss_time_assistance *command,
    struct mip_3dm_gnss_time_assistance_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_gnss_time_assistance_command, command,
                           &mip_3dm_gnss_time_assistance_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_pps_source_control_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. PPS Source Control.
 * The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_pps_source_control(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_pps_source_control *command,
    struct mip_3dm_pps_source_control_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_pps_source_control_command, command,
                           &mip_3dm_pps_source_control_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_get_event_support_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Get Supported Events.
 * The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_get_event_support(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_get_event_support *command,
    struct mip_3dm_get_event_support_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_get_event_support_command, command,
                           &mip_3dm_get_event_support_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_event_control_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Event Control. The
 * response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_event_control(struct mip_client *client,
                                                   struct mip_request *request,
                                                   struct mip_builder *packet,
                                                   const struct mip_3dm_event_control *command,
                                                   struct mip_3dm_event_control_response *response,
                                                   uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_event_control_command, command,
                           &mip_3dm_event_control_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_get_event_trigger_status_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Get Event Trigger
 * Status. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_get_event_trigger_status(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_get_event_trigger_status *command,
    struct mip_3dm_get_event_trigger_status_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_get_event_trigger_status_command,
                           command, &mip_3dm_get_event_trigger_status_response_codec, response,
                           now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_get_event_action_status_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Get Event Action
 * Status. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_get_event_action_status(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_get_event_action_status *command,
    struct mip_3dm_get_event_action_status_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_get_event_action_status_command,
                           command, &mip_3dm_get_event_action_status_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_event_trigger_config_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Event Trigger
 * Configuration. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_event_trigger_config(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_event_trigger_config *command,
    struct mip_3dm_event_trigger_config_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_event_trigger_config_command, command,
                           &mip_3dm_event_trigger_config_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_event_action_config_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Event Action
 * Configuration. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_event_action_config(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_event_action_config *command,
    struct mip_3dm_event_action_config_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_event_action_config_command, command,
                           &mip_3dm_event_action_config_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_device_settings_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Device Start Up
 * Settings.
 */
static inline mip_error mip_send_3dm_device_settings(struct mip_client *client,
                                                     struct mip_request *request,
                                                     struct mip_builder *packet,
                                                     const struct mip_3dm_device_settings *command,
                                                     uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_device_settings_command, command, NULL,
                           NULL, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_sensor_to_vehicle_euler_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Sensor-to-Vehicle
 * Frame Transformation Euler. The response goes to `response`, which may be NULL, if the command
 * asks for it.
 */
static inline mip_error mip_send_3dm_sensor_to_vehicle_euler(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_sensor_to_vehicle_euler *command,
    struct mip_3dm_sensor_to_vehicle_euler_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_sensor_to_vehicle_euler_command,
                           command, &mip_3dm_sensor_to_vehicle_euler_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_sensor_to_vehicle_quaternion_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Sensor-to-Vehicle
 * Frame Transformation Quaternion. The response goes to `response`, which may be NULL, if the
 * command asks for it.
 */
static inline mip_error mip_send_3dm_sensor_to_vehicle_quaternion(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_sensor_to_vehicle_quaternion *command,
    struct mip_3dm_sensor_to_vehicle_quaternion_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_sensor_to_vehicle_quaternion_command,
                           command, &mip_3dm_sensor_to_vehicle_quaternion_response_codec, response,
                           now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_sensor_to_vehicle_dcm_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Sensor-to-Vehicle
 * Frame Transformation Direction Cosine Matrix. The response goes to `response`, which may be NULL,
 * if the command asks for it.
 */
static inline mip_error mip_send_3dm_sensor_to_vehicle_dcm(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_sensor_to_vehicle_dcm *command,
    struct mip_3dm_sensor_to_vehicle_dcm_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_sensor_to_vehicle_dcm_command, command,
                           &mip_3dm_sensor_to_vehicle_dcm_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_accel_bias_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Accelerometer Bias
 * Configuration. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_accel_bias(struct mip_client *client,
                                                struct mip_request *request,
                                                struct mip_builder *packet,
                                                const struct mip_3dm_accel_bias *command,
                                                struct mip_3dm_accel_bias_response *response,
                                                uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_accel_bias_command, command,
                           &mip_3dm_accel_bias_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_gyro_bias_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Gyroscope Bias
 * Configuration. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_gyro_bias(struct mip_client *client,
                                               struct mip_request *request,
                                               struct mip_builder *packet,
                                               const struct mip_3dm_gyro_bias *command,
                                               struct mip_3dm_gyro_bias_response *response,
                                               uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_gyro_bias_command, command,
                           &mip_3dm_gyro_bias_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_capture_gyro_bias_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Capture Gyroscope
 * Bias. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_capture_gyro_bias(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_capture_gyro_bias *command, struct mip_3dm_gyro_bias_response *response,
    uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_capture_gyro_bias_command, command,
                           &mip_3dm_gyro_bias_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_mag_hard_iron_offset_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Magnetometer Hard
 * Iron Offset. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_mag_hard_iron_offset(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_mag_hard_iron_offset *command,
    struct mip_3dm_mag_hard_iron_offset_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_mag_hard_iron_offset_command, command,
                           &mip_3dm_mag_hard_iron_offset_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_mag_soft_iron_matrix_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Magnetometer Soft
 * Iron Matrix. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_mag_soft_iron_matrix(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_mag_soft_iron_matrix *command,
    struct mip_3dm_mag_soft_iron_matrix_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_mag_soft_iron_matrix_command, command,
                           &mip_3dm_mag_soft_iron_matrix_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_coning_sculling_enable_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Coning and Sculling
 * Enable. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_coning_sculling_enable(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_coning_sculling_enable *command,
    struct mip_3dm_coning_sculling_enable_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_coning_sculling_enable_command,
                           command, &mip_3dm_coning_sculling_enable_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_uart_baud_rate_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. UART Baud Rate. The
 * response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_uart_baud_rate(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_uart_baud_rate *command, struct mip_3dm_uart_baud_rate_response *response,
    uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_uart_baud_rate_command, command,
                           &mip_3dm_uart_baud_rate_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_gpio_config_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. GPIO Configuration.
 * The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_gpio_config(struct mip_client *client,
                                                 struct mip_request *request,
                                                 struct mip_builder *packet,
                                                 const struct mip_3dm_gpio_config *command,
                                                 struct mip_3dm_gpio_config_response *response,
                                                 uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_gpio_config_command, command,
                           &mip_3dm_gpio_config_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_gpio_state_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. GPIO State. The
 * response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_gpio_state(struct mip_client *client,
                                                struct mip_request *request,
                                                struct mip_builder *packet,
                                                const struct mip_3dm_gpio_state *command,
                                                struct mip_3dm_gpio_state_response *response,
                                                uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_gpio_state_command, command,
                           &mip_3dm_gpio_state_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_odometer_config_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Odometer
 * Configuration. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_odometer_config(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_odometer_config *command,
    struct mip_3dm_odometer_config_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_odometer_config_command, command,
                           &mip_3dm_odometer_config_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_imu_low_pass_filter_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Advanced Low-Pass
 * Filter Settings. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_imu_low_pass_filter(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_imu_low_pass_filter *command,
    struct mip_3dm_imu_low_pass_filter_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_imu_low_pass_filter_command, command,
                           &mip_3dm_imu_low_pass_filter_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_complementary_filter_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Complementary Filter
 * Configuration. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_complementary_filter(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_complementary_filter *command,
    struct mip_3dm_complementary_filter_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_complementary_filter_command, command,
                           &mip_3dm_complementary_filter_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_sensor_range_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Sensor Range. The
 * response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_sensor_range(struct mip_client *client,
                                                  struct mip_request *request,
                                                  struct mip_builder *packet,
                                                  const struct mip_3dm_sensor_range *command,
                                                  struct mip_3dm_sensor_range_response *response,
                                                  uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_sensor_range_command, command,
                           &mip_3dm_sensor_range_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_get_calibrated_sensor_ranges_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Get Calibrated Sensor
 * Ranges. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_3dm_get_calibrated_sensor_ranges(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_get_calibrated_sensor_ranges *command,
    struct mip_3dm_get_calibrated_sensor_ranges_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_get_calibrated_sensor_ranges_command,
                           command, &mip_3dm_get_calibrated_sensor_ranges_response_codec, response,
                           now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_low_pass_filter_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Low-Pass
 * Anti-Aliasing Filter. The response goes to `response`, which may be NULL, if the command asks for
 * it.
 */
static inline mip_error mip_send_3dm_low_pass_filter(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_low_pass_filter *command,
    struct mip_3dm_low_pass_filter_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_low_pass_filter_command, command,
                           &mip_3dm_low_pass_filter_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3dm_device_status_command;

/** Adds the command to a packet and waits for its answer: see mip_client_send. Device Status. */
static inline mip_error mip_send_3dm_device_status(struct mip_client *client,
                                                   struct mip_request *request,
                                                   struct mip_builder *packet,
                                                   const struct mip_3dm_device_status *command,
                                                   uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_device_status_command, command, NULL,
                           NULL, now);
}
/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Device Status. It is
 * answered by this response.
 */
static inline mip_error mip_send_for_3dm_device_status_basic_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_device_status *command,
    struct mip_3dm_device_status_basic_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_device_status_command, command,
                           &mip_3dm_device_status_basic_response_codec, response, now);
}
/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Device Status. It is
 * answered by this response.
 */
static inline mip_error mip_send_for_3dm_device_status_basic_stateless_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_device_status *command,
    struct mip_3dm_device_status_basic_stateless_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_device_status_command, command,
                           &mip_3dm_device_status_basic_stateless_response_codec, response, now);
}
/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Device Status. It is
 * answered by this response.
 */
static inline mip_error mip_send_for_3dm_device_status_diagnostic_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_device_status *command,
    struct mip_3dm_device_status_diagnostic_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_device_status_command, command,
                           &mip_3dm_device_status_diagnostic_response_codec, response, now);
}
/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Device Status. It is
 * answered by this response.
 */
static inline mip_error mip_send_for_3dm_device_status_diagnostic_gnss_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_device_status *command,
    struct mip_3dm_device_status_diagnostic_gnss_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_device_status_command, command,
                           &mip_3dm_device_status_diagnostic_gnss_response_codec, response, now);
}
/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Device Status. It is
 * answered by this response.
 */
static inline mip_error mip_send_for_3dm_device_status_diagnostic_gq4_45_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_device_status *command,
    struct mip_3dm_device_status_diagnostic_gq4_45_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_device_status_command, command,
                           &mip_3dm_device_status_diagnostic_gq4_45_response_codec, response, now);
}
/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Device Status. It is
 * answered by this response.
 */
static inline mip_error mip_send_for_3dm_device_status_diagnostic_rq1_45_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_device_status *command,
    struct mip_3dm_device_status_diagnostic_rq1_45_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_device_status_command, command,
                           &mip_3dm_device_status_diagnostic_rq1_45_response_codec, response, now);
}
/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Device Status. It is
 * answered by this response.
 */
static inline mip_error mip_send_for_3dm_device_status_diagnostic_gx4_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_device_status *command,
    struct mip_3dm_device_status_diagnostic_gx4_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_device_status_command, command,
                           &mip_3dm_device_status_diagnostic_gx4_response_codec, response, now);
}
/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Device Status. It is
 * answered by this response.
 */
static inline mip_error mip_send_for_3dm_device_status_diagnostic_imu_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_device_status *command,
    struct mip_3dm_device_status_diagnostic_imu_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_device_status_command, command,
                           &mip_3dm_device_status_diagnostic_imu_response_codec, response, now);
}

#ifdef __cplusplus
}
#endif

#endif
