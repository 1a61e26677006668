/**
 * @file
 * The commands of RTK commands, each with the types of its parameters and of its response.
 */
#ifndef MIP_RTK_COMMANDS_H
#define MIP_RTK_COMMANDS_H

#include "mip/rtk.h"
#include "mip/device.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/rtk_commands.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_rtk RTK commands (0x0F)
 * @{ */

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_rtk_get_status_flags_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_rtk_get_status_flags_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Get status flags. If the
 * command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_rtk_get_status_flags(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    struct mip_rtk_get_status_flags_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_get_status_flags_command, NULL,
                           &mip_rtk_get_status_flags_response_codec, response, now);
}

/** Get status flags. See mip_device_call. */
static inline struct mip_result mip_call_rtk_get_status_flags(
    struct mip_device *device, struct mip_rtk_get_status_flags_response *response) {
    return mip_device_request(device, &mip_rtk_get_status_flags_exchange,
                              MIP_NO_DATA(mip_rtk_get_status_flags_exchange), 0,
                              &mip_rtk_get_status_flags_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_rtk_get_imei_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_rtk_get_imei_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Get IMEI. If the command
 * requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_rtk_get_imei(struct mip_client *client,
                                              struct mip_request *request,
                                              struct mip_builder *packet,
                                              struct mip_rtk_get_imei_response *response,
                                              uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_get_imei_command, NULL,
                           &mip_rtk_get_imei_response_codec, response, now);
}

/** Get IMEI. See mip_device_call. */
static inline struct mip_result mip_call_rtk_get_imei(struct mip_device *device,
                                                      struct mip_rtk_get_imei_response *response) {
    return mip_device_request(device, &mip_rtk_get_imei_exchange,
                              MIP_NO_DATA(mip_rtk_get_imei_exchange), 0,
                              &mip_rtk_get_imei_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_rtk_get_imsi_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_rtk_get_imsi_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Get IMSI. If the command
 * requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_rtk_get_imsi(struct mip_client *client,
                                              struct mip_request *request,
                                              struct mip_builder *packet,
                                              struct mip_rtk_get_imsi_response *response,
                                              uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_get_imsi_command, NULL,
                           &mip_rtk_get_imsi_response_codec, response, now);
}

/** Get IMSI. See mip_device_call. */
static inline struct mip_result mip_call_rtk_get_imsi(struct mip_device *device,
                                                      struct mip_rtk_get_imsi_response *response) {
    return mip_device_request(device, &mip_rtk_get_imsi_exchange,
                              MIP_NO_DATA(mip_rtk_get_imsi_exchange), 0,
                              &mip_rtk_get_imsi_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_rtk_get_iccid_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_rtk_get_iccid_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Get ICCID. If the command
 * requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_rtk_get_iccid(struct mip_client *client,
                                               struct mip_request *request,
                                               struct mip_builder *packet,
                                               struct mip_rtk_get_iccid_response *response,
                                               uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_get_iccid_command, NULL,
                           &mip_rtk_get_iccid_response_codec, response, now);
}

/** Get ICCID. See mip_device_call. */
static inline struct mip_result
mip_call_rtk_get_iccid(struct mip_device *device, struct mip_rtk_get_iccid_response *response) {
    return mip_device_request(device, &mip_rtk_get_iccid_exchange,
                              MIP_NO_DATA(mip_rtk_get_iccid_exchange), 0,
                              &mip_rtk_get_iccid_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_rtk_get_rssi_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_rtk_get_rssi_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Get RSSI. If the command
 * requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_rtk_get_rssi(struct mip_client *client,
                                              struct mip_request *request,
                                              struct mip_builder *packet,
                                              struct mip_rtk_get_rssi_response *response,
                                              uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_get_rssi_command, NULL,
                           &mip_rtk_get_rssi_response_codec, response, now);
}

/** Get RSSI. See mip_device_call. */
static inline struct mip_result mip_call_rtk_get_rssi(struct mip_device *device,
                                                      struct mip_rtk_get_rssi_response *response) {
    return mip_device_request(device, &mip_rtk_get_rssi_exchange,
                              MIP_NO_DATA(mip_rtk_get_rssi_exchange), 0,
                              &mip_rtk_get_rssi_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_rtk_connected_device_type_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_rtk_connected_device_type_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Connected device type. If
 * the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_rtk_connected_device_type(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_rtk_connected_device_type *command,
    struct mip_rtk_connected_device_type_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_connected_device_type_command, command,
                           &mip_rtk_connected_device_type_response_codec, response, now);
}

/**
 * Connected device type: write. Apply the new setting. See mip_device_call.
 *
 * - device_type: Type of device that the modem is connected to. A value of enum
 *   mip_rtk_connected_device. Required for write.
 */
static inline struct mip_result mip_call_rtk_connected_device_type_write(
    struct mip_device *device, enum mip_rtk_connected_device device_type) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)device_type);
    return mip_device_send(device, &mip_rtk_connected_device_type_exchange, data, 2);
}

/** Connected device type: read. Return the current setting in a response. See mip_device_call. */
static inline struct mip_result mip_call_rtk_connected_device_type_read(
    struct mip_device *device, struct mip_rtk_connected_device_type_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_rtk_connected_device_type_exchange, data, 1,
                              &mip_rtk_connected_device_type_response_codec, response);
}

/**
 * Connected device type: save. Save the current setting to non-volatile memory. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_rtk_connected_device_type_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_rtk_connected_device_type_exchange, data, 1);
}

/** Connected device type: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result mip_call_rtk_connected_device_type_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_rtk_connected_device_type_exchange, data, 1);
}

/** Connected device type: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result
mip_call_rtk_connected_device_type_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_rtk_connected_device_type_exchange, data, 1);
}

/**
 * Connected device type: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_rtk_connected_device_type_with(
    struct mip_device *device, const struct mip_rtk_connected_device_type *command,
    struct mip_rtk_connected_device_type_response *response) {
    return mip_device_call(device, &mip_rtk_connected_device_type_command, command,
                           &mip_rtk_connected_device_type_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_rtk_get_activation_code_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_rtk_get_activation_code_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Get activation code. If
 * the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_rtk_get_activation_code(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    struct mip_rtk_get_activation_code_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_get_activation_code_command, NULL,
                           &mip_rtk_get_activation_code_response_codec, response, now);
}

/** Get activation code. See mip_device_call. */
static inline struct mip_result mip_call_rtk_get_activation_code(
    struct mip_device *device, struct mip_rtk_get_activation_code_response *response) {
    return mip_device_request(device, &mip_rtk_get_activation_code_exchange,
                              MIP_NO_DATA(mip_rtk_get_activation_code_exchange), 0,
                              &mip_rtk_get_activation_code_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_rtk_get_modem_firmware_version_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_rtk_get_modem_firmware_version_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Get modem firmware
 * version. If the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_rtk_get_modem_firmware_version(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    struct mip_rtk_get_modem_firmware_version_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_get_modem_firmware_version_command,
                           NULL, &mip_rtk_get_modem_firmware_version_response_codec, response, now);
}

/** Get modem firmware version. See mip_device_call. */
static inline struct mip_result mip_call_rtk_get_modem_firmware_version(
    struct mip_device *device, struct mip_rtk_get_modem_firmware_version_response *response) {
    return mip_device_request(device, &mip_rtk_get_modem_firmware_version_exchange,
                              MIP_NO_DATA(mip_rtk_get_modem_firmware_version_exchange), 0,
                              &mip_rtk_get_modem_firmware_version_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_rtk_service_status_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_rtk_service_status_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Service status. If the
 * command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_rtk_service_status(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_rtk_service_status *command, struct mip_rtk_service_status_response *response,
    uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_service_status_command, command,
                           &mip_rtk_service_status_response_codec, response, now);
}

/**
 * Service status: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_rtk_service_status_with(
    struct mip_device *device, const struct mip_rtk_service_status *command,
    struct mip_rtk_service_status_response *response) {
    return mip_device_call(device, &mip_rtk_service_status_command, command,
                           &mip_rtk_service_status_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_rtk_erase_storage_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_rtk_erase_storage_exchange;

/** Adds the command to a packet and tracks its reply: see mip_client_send. Erase storage. */
static inline mip_error mip_send_rtk_erase_storage(struct mip_client *client,
                                                   struct mip_request *request,
                                                   struct mip_builder *packet,
                                                   const struct mip_rtk_erase_storage *command,
                                                   uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_erase_storage_command, command, NULL,
                           NULL, now);
}

/**
 * Erase storage. See mip_device_call.
 *
 * - media: The medium. A value of enum mip_rtk_storage_medium.
 */
static inline struct mip_result mip_call_rtk_erase_storage(struct mip_device *device,
                                                           enum mip_rtk_storage_medium media) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)media);
    return mip_device_send(device, &mip_rtk_erase_storage_exchange, data, 1);
}

/**
 * Erase storage: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_rtk_erase_storage_with(
    struct mip_device *device, const struct mip_rtk_erase_storage *command) {
    return mip_device_call(device, &mip_rtk_erase_storage_command, command, NULL, NULL);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_rtk_led_control_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_rtk_led_control_exchange;

/** Adds the command to a packet and tracks its reply: see mip_client_send. LED control. */
static inline mip_error mip_send_rtk_led_control(struct mip_client *client,
                                                 struct mip_request *request,
                                                 struct mip_builder *packet,
                                                 const struct mip_rtk_led_control *command,
                                                 uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_led_control_command, command, NULL,
                           NULL, now);
}

/**
 * LED control. See mip_device_call.
 *
 * - primary_color: First colour. Uncertain: The order of its parts; red, green, blue is likely.
 * - alternate_color: Second colour. Uncertain: The order of its parts; red, green, blue is likely.
 * - action: Pattern. A value of enum mip_rtk_led_action.
 * - period: Period of the pattern. Uncertain: The unit; ms is likely.
 */
static inline struct mip_result mip_call_rtk_led_control(struct mip_device *device,
                                                         const uint8_t primary_color[3],
                                                         const uint8_t alternate_color[3],
                                                         enum mip_rtk_led_action action,
                                                         uint32_t period) {
    uint8_t data[11];
    mip_put_8(data + 6, (uint8_t)action);
    mip_put_32(data + 7, (uint32_t)period);
    for (size_t i = 0; i < 3; i++) {
        mip_put_8(data + 3 + 1 * i, (uint8_t)alternate_color[i]);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_8(data + 0 + 1 * i, (uint8_t)primary_color[i]);
    }
    return mip_device_send(device, &mip_rtk_led_control_exchange, data, 11);
}

/**
 * LED control: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_rtk_led_control_with(
    struct mip_device *device, const struct mip_rtk_led_control *command) {
    return mip_device_call(device, &mip_rtk_led_control_command, command, NULL, NULL);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_rtk_modem_hard_reset_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_rtk_modem_hard_reset_exchange;

/** Adds the command to a packet and tracks its reply: see mip_client_send. Modem hard reset. */
static inline mip_error mip_send_rtk_modem_hard_reset(struct mip_client *client,
                                                      struct mip_request *request,
                                                      struct mip_builder *packet, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_modem_hard_reset_command, NULL, NULL,
                           NULL, now);
}

/** Modem hard reset. See mip_device_call. */
static inline struct mip_result mip_call_rtk_modem_hard_reset(struct mip_device *device) {
    return mip_device_send(device, &mip_rtk_modem_hard_reset_exchange,
                           MIP_NO_DATA(mip_rtk_modem_hard_reset_exchange), 0);
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
