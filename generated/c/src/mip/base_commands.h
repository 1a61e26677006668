/**
 * @file
 * The commands of Base, each with the types of its parameters and of its response.
 */
#ifndef MIP_BASE_COMMANDS_H
#define MIP_BASE_COMMANDS_H

#include "mip/base.h"
#include "mip/device.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/base_commands.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_base Base (0x01)
 * @{ */

MIP_COMMAND_REPLIES(mip_base_ping);

/** Ping: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_base_ping(struct mip_client *client, struct mip_request *request,
                                           struct mip_builder *packet, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_base_ping_command, NULL, NULL, NULL, now);
}

/** Ping. */
static inline struct mip_result mip_call_base_ping(struct mip_device *device) {
    return mip_device_send(device, &mip_base_ping_exchange, MIP_NO_DATA(mip_base_ping_exchange), 0);
}

MIP_COMMAND_REPLIES(mip_base_set_idle);

/** Set to idle: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_base_set_idle(struct mip_client *client,
                                               struct mip_request *request,
                                               struct mip_builder *packet, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_base_set_idle_command, NULL, NULL, NULL,
                           now);
}

/** Set to idle. */
static inline struct mip_result mip_call_base_set_idle(struct mip_device *device) {
    return mip_device_send(device, &mip_base_set_idle_exchange,
                           MIP_NO_DATA(mip_base_set_idle_exchange), 0);
}

MIP_COMMAND_REPLIES(mip_base_get_device_info);

/** Get device information: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_base_get_device_info(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    struct mip_base_get_device_info_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_base_get_device_info_command, NULL,
                           &mip_base_get_device_info_response_codec, response, now);
}

/** Get device information. */
static inline struct mip_result mip_call_base_get_device_info(
    struct mip_device *device, struct mip_base_get_device_info_response *response) {
    return mip_device_request(device, &mip_base_get_device_info_exchange,
                              MIP_NO_DATA(mip_base_get_device_info_exchange), 0,
                              &mip_base_get_device_info_response_codec, response);
}

MIP_COMMAND_REPLIES(mip_base_get_device_descriptors);

/** Get device descriptors: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_base_get_device_descriptors(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    struct mip_base_get_device_descriptors_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_base_get_device_descriptors_command, NULL,
                           &mip_base_get_device_descriptors_response_codec, response, now);
}

/** Get device descriptors. */
static inline struct mip_result mip_call_base_get_device_descriptors(
    struct mip_device *device, struct mip_base_get_device_descriptors_response *response) {
    return mip_device_request(device, &mip_base_get_device_descriptors_exchange,
                              MIP_NO_DATA(mip_base_get_device_descriptors_exchange), 0,
                              &mip_base_get_device_descriptors_response_codec, response);
}

MIP_COMMAND_REPLIES(mip_base_built_in_test);

/** Built-in test: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_base_built_in_test(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    struct mip_base_built_in_test_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_base_built_in_test_command, NULL,
                           &mip_base_built_in_test_response_codec, response, now);
}

/** Built-in test. */
static inline struct mip_result mip_call_base_built_in_test(
    struct mip_device *device, struct mip_base_built_in_test_response *response) {
    return mip_device_request(device, &mip_base_built_in_test_exchange,
                              MIP_NO_DATA(mip_base_built_in_test_exchange), 0,
                              &mip_base_built_in_test_response_codec, response);
}

MIP_COMMAND_REPLIES(mip_base_resume);

/** Resume: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_base_resume(struct mip_client *client, struct mip_request *request,
                                             struct mip_builder *packet, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_base_resume_command, NULL, NULL, NULL,
                           now);
}

/** Resume. */
static inline struct mip_result mip_call_base_resume(struct mip_device *device) {
    return mip_device_send(device, &mip_base_resume_exchange, MIP_NO_DATA(mip_base_resume_exchange),
                           0);
}

MIP_COMMAND_REPLIES(mip_base_get_extended_descriptors);

/** Get device descriptors (extended): adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_base_get_extended_descriptors(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    struct mip_base_get_extended_descriptors_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_base_get_extended_descriptors_command,
                           NULL, &mip_base_get_extended_descriptors_response_codec, response, now);
}

/** Get device descriptors (extended). */
static inline struct mip_result mip_call_base_get_extended_descriptors(
    struct mip_device *device, struct mip_base_get_extended_descriptors_response *response) {
    return mip_device_request(device, &mip_base_get_extended_descriptors_exchange,
                              MIP_NO_DATA(mip_base_get_extended_descriptors_exchange), 0,
                              &mip_base_get_extended_descriptors_response_codec, response);
}

MIP_COMMAND_REPLIES(mip_base_continuous_built_in_test);

/** Continuous built-in test: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_base_continuous_built_in_test(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    struct mip_base_continuous_built_in_test_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_base_continuous_built_in_test_command,
                           NULL, &mip_base_continuous_built_in_test_response_codec, response, now);
}

/** Continuous built-in test. */
static inline struct mip_result mip_call_base_continuous_built_in_test(
    struct mip_device *device, struct mip_base_continuous_built_in_test_response *response) {
    return mip_device_request(device, &mip_base_continuous_built_in_test_exchange,
                              MIP_NO_DATA(mip_base_continuous_built_in_test_exchange), 0,
                              &mip_base_continuous_built_in_test_response_codec, response);
}

MIP_COMMAND_REPLIES(mip_base_comm_speed);
MIP_SEND(mip_send_base_comm_speed, mip_base_comm_speed, mip_base_comm_speed_response);
MIP_CALL_WITH(mip_call_base_comm_speed_with, mip_base_comm_speed, mip_base_comm_speed_response);

/**
 * Comm port speed: write.
 *
 * - port: Port id of the device; 0 means all ports, and is for save, load and default only. On the
 *   3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-GV7-AHRS and 3DM-GV7-AR: values of enum
 *   mip_comm_interface; only MIP_COMM_INTERFACE_MAIN, MIP_COMM_INTERFACE_UART_1 and
 *   MIP_COMM_INTERFACE_USB_1. On the 3DM-CV7-GNSS/INS: values of enum mip_comm_interface. On the
 *   3DM-CV7-INS and 3DM-CX7-INS: values of enum mip_comm_interface; only MIP_COMM_INTERFACE_MAIN,
 *   MIP_COMM_INTERFACE_UART_1, MIP_COMM_INTERFACE_UART_2, MIP_COMM_INTERFACE_UART_3 and
 *   MIP_COMM_INTERFACE_USB_1. On the 3DM-GQ7-GNSS/INS: 1 is the main port, 2 the auxiliary one. On
 *   the 3DM-GV7-INS: values of enum mip_comm_interface; only MIP_COMM_INTERFACE_MAIN,
 *   MIP_COMM_INTERFACE_UART_1, MIP_COMM_INTERFACE_UART_2 and MIP_COMM_INTERFACE_USB_1. On the
 *   3DM-RTK: the values are unknown.
 * - baud: New baud rate; the port must support it. Unit: Bd. Required for write.
 */
static inline struct mip_result mip_call_base_comm_speed_write(struct mip_device *device,
                                                               uint8_t port, uint32_t baud) {
    uint8_t data[6];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)port);
    mip_put_32(data + 2, (uint32_t)baud);
    return mip_device_send(device, &mip_base_comm_speed_exchange, data, 6);
}

/**
 * Comm port speed: read.
 *
 * - port: Port id of the device; 0 means all ports, and is for save, load and default only. On the
 *   3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-GV7-AHRS and 3DM-GV7-AR: values of enum
 *   mip_comm_interface; only MIP_COMM_INTERFACE_MAIN, MIP_COMM_INTERFACE_UART_1 and
 *   MIP_COMM_INTERFACE_USB_1. On the 3DM-CV7-GNSS/INS: values of enum mip_comm_interface. On the
 *   3DM-CV7-INS and 3DM-CX7-INS: values of enum mip_comm_interface; only MIP_COMM_INTERFACE_MAIN,
 *   MIP_COMM_INTERFACE_UART_1, MIP_COMM_INTERFACE_UART_2, MIP_COMM_INTERFACE_UART_3 and
 *   MIP_COMM_INTERFACE_USB_1. On the 3DM-GQ7-GNSS/INS: 1 is the main port, 2 the auxiliary one. On
 *   the 3DM-GV7-INS: values of enum mip_comm_interface; only MIP_COMM_INTERFACE_MAIN,
 *   MIP_COMM_INTERFACE_UART_1, MIP_COMM_INTERFACE_UART_2 and MIP_COMM_INTERFACE_USB_1. On the
 *   3DM-RTK: the values are unknown.
 */
static inline struct mip_result mip_call_base_comm_speed_read(
    struct mip_device *device, uint8_t port, struct mip_base_comm_speed_response *response) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_READ, (uint8_t)port};
    return mip_device_request(device, &mip_base_comm_speed_exchange, data, 2,
                              &mip_base_comm_speed_response_codec, response);
}

/**
 * Comm port speed: save.
 *
 * - port: Port id of the device; 0 means all ports, and is for save, load and default only. On the
 *   3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-GV7-AHRS and 3DM-GV7-AR: values of enum
 *   mip_comm_interface; only MIP_COMM_INTERFACE_MAIN, MIP_COMM_INTERFACE_UART_1 and
 *   MIP_COMM_INTERFACE_USB_1. On the 3DM-CV7-GNSS/INS: values of enum mip_comm_interface. On the
 *   3DM-CV7-INS and 3DM-CX7-INS: values of enum mip_comm_interface; only MIP_COMM_INTERFACE_MAIN,
 *   MIP_COMM_INTERFACE_UART_1, MIP_COMM_INTERFACE_UART_2, MIP_COMM_INTERFACE_UART_3 and
 *   MIP_COMM_INTERFACE_USB_1. On the 3DM-GQ7-GNSS/INS: 1 is the main port, 2 the auxiliary one. On
 *   the 3DM-GV7-INS: values of enum mip_comm_interface; only MIP_COMM_INTERFACE_MAIN,
 *   MIP_COMM_INTERFACE_UART_1, MIP_COMM_INTERFACE_UART_2 and MIP_COMM_INTERFACE_USB_1. On the
 *   3DM-RTK: the values are unknown.
 */
static inline struct mip_result mip_call_base_comm_speed_save(struct mip_device *device,
                                                              uint8_t port) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_SAVE, (uint8_t)port};
    return mip_device_send(device, &mip_base_comm_speed_exchange, data, 2);
}

/**
 * Comm port speed: load.
 *
 * - port: Port id of the device; 0 means all ports, and is for save, load and default only. On the
 *   3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-GV7-AHRS and 3DM-GV7-AR: values of enum
 *   mip_comm_interface; only MIP_COMM_INTERFACE_MAIN, MIP_COMM_INTERFACE_UART_1 and
 *   MIP_COMM_INTERFACE_USB_1. On the 3DM-CV7-GNSS/INS: values of enum mip_comm_interface. On the
 *   3DM-CV7-INS and 3DM-CX7-INS: values of enum mip_comm_interface; only MIP_COMM_INTERFACE_MAIN,
 *   MIP_COMM_INTERFACE_UART_1, MIP_COMM_INTERFACE_UART_2, MIP_COMM_INTERFACE_UART_3 and
 *   MIP_COMM_INTERFACE_USB_1. On the 3DM-GQ7-GNSS/INS: 1 is the main port, 2 the auxiliary one. On
 *   the 3DM-GV7-INS: values of enum mip_comm_interface; only MIP_COMM_INTERFACE_MAIN,
 *   MIP_COMM_INTERFACE_UART_1, MIP_COMM_INTERFACE_UART_2 and MIP_COMM_INTERFACE_USB_1. On the
 *   3DM-RTK: the values are unknown.
 */
static inline struct mip_result mip_call_base_comm_speed_load(struct mip_device *device,
                                                              uint8_t port) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_LOAD, (uint8_t)port};
    return mip_device_send(device, &mip_base_comm_speed_exchange, data, 2);
}

/**
 * Comm port speed: default.
 *
 * - port: Port id of the device; 0 means all ports, and is for save, load and default only. On the
 *   3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-GV7-AHRS and 3DM-GV7-AR: values of enum
 *   mip_comm_interface; only MIP_COMM_INTERFACE_MAIN, MIP_COMM_INTERFACE_UART_1 and
 *   MIP_COMM_INTERFACE_USB_1. On the 3DM-CV7-GNSS/INS: values of enum mip_comm_interface. On the
 *   3DM-CV7-INS and 3DM-CX7-INS: values of enum mip_comm_interface; only MIP_COMM_INTERFACE_MAIN,
 *   MIP_COMM_INTERFACE_UART_1, MIP_COMM_INTERFACE_UART_2, MIP_COMM_INTERFACE_UART_3 and
 *   MIP_COMM_INTERFACE_USB_1. On the 3DM-GQ7-GNSS/INS: 1 is the main port, 2 the auxiliary one. On
 *   the 3DM-GV7-INS: values of enum mip_comm_interface; only MIP_COMM_INTERFACE_MAIN,
 *   MIP_COMM_INTERFACE_UART_1, MIP_COMM_INTERFACE_UART_2 and MIP_COMM_INTERFACE_USB_1. On the
 *   3DM-RTK: the values are unknown.
 */
static inline struct mip_result mip_call_base_comm_speed_default(struct mip_device *device,
                                                                 uint8_t port) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT, (uint8_t)port};
    return mip_device_send(device, &mip_base_comm_speed_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_base_gps_time_update);

/** GPS time update: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_base_gps_time_update(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_base_gps_time_update *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_base_gps_time_update_command, command,
                           NULL, NULL, now);
}

/** GPS time update: adds the command to a packet. Expects this response. See mip_client_send. */
static inline mip_error mip_send_for_base_gps_time_update_week_number_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_base_gps_time_update *command,
    struct mip_base_gps_time_update_week_number_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_base_gps_time_update_command, command,
                           &mip_base_gps_time_update_week_number_response_codec, response, now);
}

/** GPS time update: adds the command to a packet. Expects this response. See mip_client_send. */
static inline mip_error mip_send_for_base_gps_time_update_tow_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_base_gps_time_update *command,
    struct mip_base_gps_time_update_tow_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_base_gps_time_update_command, command,
                           &mip_base_gps_time_update_tow_response_codec, response, now);
}

/**
 * GPS time update: write.
 *
 * - field_id: Meaning of the value. A value of enum mip_base_gps_time_field.
 * - value: Week or seconds, as selected by `field_id`. Required for write and apply. If field_id is
 *   MIP_BASE_GPS_TIME_FIELD_WEEK_NUMBER: unit week. GPS week number since 6 January 1980. If
 *   field_id is MIP_BASE_GPS_TIME_FIELD_TOW: unit s. Whole seconds of the GPS week.
 */
static inline struct mip_result mip_call_base_gps_time_update_write(
    struct mip_device *device, enum mip_base_gps_time_field field_id, uint32_t value) {
    uint8_t data[6];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)field_id);
    mip_put_32(data + 2, (uint32_t)value);
    return mip_device_send(device, &mip_base_gps_time_update_exchange, data, 6);
}

/**
 * GPS time update: read.
 *
 * - field_id: Meaning of the value. A value of enum mip_base_gps_time_field.
 */
static inline struct mip_result mip_call_base_gps_time_update_read(
    struct mip_device *device, enum mip_base_gps_time_field field_id) {
    struct mip_base_gps_time_update command;
    return mip_device_call(device, &mip_base_gps_time_update_command,
                           mip_base_gps_time_update_read(&command, field_id), NULL, NULL);
}

/** GPS time update: read. The reply is decoded as this response. */
static inline struct mip_result mip_call_for_base_gps_time_update_week_number_response_read(
    struct mip_device *device, struct mip_base_gps_time_update_week_number_response *response) {
    struct mip_base_gps_time_update command;
    return mip_device_call(
        device, &mip_base_gps_time_update_command,
        mip_base_gps_time_update_read(&command, MIP_BASE_GPS_TIME_FIELD_WEEK_NUMBER),
        &mip_base_gps_time_update_week_number_response_codec, response);
}

/** GPS time update: read. The reply is decoded as this response. */
static inline struct mip_result mip_call_for_base_gps_time_update_tow_response_read(
    struct mip_device *device, struct mip_base_gps_time_update_tow_response *response) {
    struct mip_base_gps_time_update command;
    return mip_device_call(device, &mip_base_gps_time_update_command,
                           mip_base_gps_time_update_read(&command, MIP_BASE_GPS_TIME_FIELD_TOW),
                           &mip_base_gps_time_update_tow_response_codec, response);
}

/**
 * GPS time update: apply.
 *
 * - field_id: Meaning of the value. A value of enum mip_base_gps_time_field.
 * - value: Week or seconds, as selected by `field_id`. Required for write and apply. If field_id is
 *   MIP_BASE_GPS_TIME_FIELD_WEEK_NUMBER: unit week. GPS week number since 6 January 1980. If
 *   field_id is MIP_BASE_GPS_TIME_FIELD_TOW: unit s. Whole seconds of the GPS week.
 */
static inline struct mip_result mip_call_base_gps_time_update_apply(
    struct mip_device *device, enum mip_base_gps_time_field field_id, uint32_t value) {
    struct mip_base_gps_time_update command;
    return mip_device_call(device, &mip_base_gps_time_update_command,
                           mip_base_gps_time_update_apply(&command, field_id, value), NULL, NULL);
}

/** GPS time update, with these values, including optional parameters. */
static inline struct mip_result mip_call_base_gps_time_update_with(
    struct mip_device *device, const struct mip_base_gps_time_update *command) {
    return mip_device_call(device, &mip_base_gps_time_update_command, command, NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_base_soft_reset);

/** Reset device: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_base_soft_reset(struct mip_client *client,
                                                 struct mip_request *request,
                                                 struct mip_builder *packet, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_base_soft_reset_command, NULL, NULL, NULL,
                           now);
}

/** Reset device. */
static inline struct mip_result mip_call_base_soft_reset(struct mip_device *device) {
    return mip_device_send(device, &mip_base_soft_reset_exchange,
                           MIP_NO_DATA(mip_base_soft_reset_exchange), 0);
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
