/**
 * @file
 * The commands of RTK commands, each with the types of its parameters and of its response.
 */
#ifndef MIP_RTK_COMMANDS_H
#define MIP_RTK_COMMANDS_H

#include "mip/rtk.h"
#include "mip/device.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/rtk_commands.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_rtk RTK commands (0x0F)
 * @{ */

MIP_COMMAND_REPLIES(mip_rtk_get_status_flags);

/** Get status flags: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_rtk_get_status_flags(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    struct mip_rtk_get_status_flags_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_get_status_flags_command, NULL,
                           &mip_rtk_get_status_flags_response_codec, response, now);
}

/** Get status flags. */
static inline struct mip_result mip_call_rtk_get_status_flags(
    struct mip_device *device, struct mip_rtk_get_status_flags_response *response) {
    return mip_device_request(device, &mip_rtk_get_status_flags_exchange,
                              MIP_NO_DATA(mip_rtk_get_status_flags_exchange), 0,
                              &mip_rtk_get_status_flags_response_codec, response);
}

MIP_COMMAND_REPLIES(mip_rtk_get_imei);

/** Get IMEI: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_rtk_get_imei(struct mip_client *client,
                                              struct mip_request *request,
                                              struct mip_builder *packet,
                                              struct mip_rtk_get_imei_response *response,
                                              uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_get_imei_command, NULL,
                           &mip_rtk_get_imei_response_codec, response, now);
}

/** Get IMEI. */
static inline struct mip_result mip_call_rtk_get_imei(struct mip_device *device,
                                                      struct mip_rtk_get_imei_response *response) {
    return mip_device_request(device, &mip_rtk_get_imei_exchange,
                              MIP_NO_DATA(mip_rtk_get_imei_exchange), 0,
                              &mip_rtk_get_imei_response_codec, response);
}

MIP_COMMAND_REPLIES(mip_rtk_get_imsi);

/** Get IMSI: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_rtk_get_imsi(struct mip_client *client,
                                              struct mip_request *request,
                                              struct mip_builder *packet,
                                              struct mip_rtk_get_imsi_response *response,
                                              uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_get_imsi_command, NULL,
                           &mip_rtk_get_imsi_response_codec, response, now);
}

/** Get IMSI. */
static inline struct mip_result mip_call_rtk_get_imsi(struct mip_device *device,
                                                      struct mip_rtk_get_imsi_response *response) {
    return mip_device_request(device, &mip_rtk_get_imsi_exchange,
                              MIP_NO_DATA(mip_rtk_get_imsi_exchange), 0,
                              &mip_rtk_get_imsi_response_codec, response);
}

MIP_COMMAND_REPLIES(mip_rtk_get_iccid);

/** Get ICCID: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_rtk_get_iccid(struct mip_client *client,
                                               struct mip_request *request,
                                               struct mip_builder *packet,
                                               struct mip_rtk_get_iccid_response *response,
                                               uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_get_iccid_command, NULL,
                           &mip_rtk_get_iccid_response_codec, response, now);
}

/** Get ICCID. */
static inline struct mip_result
mip_call_rtk_get_iccid(struct mip_device *device, struct mip_rtk_get_iccid_response *response) {
    return mip_device_request(device, &mip_rtk_get_iccid_exchange,
                              MIP_NO_DATA(mip_rtk_get_iccid_exchange), 0,
                              &mip_rtk_get_iccid_response_codec, response);
}

MIP_COMMAND_REPLIES(mip_rtk_get_rssi);

/** Get RSSI: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_rtk_get_rssi(struct mip_client *client,
                                              struct mip_request *request,
                                              struct mip_builder *packet,
                                              struct mip_rtk_get_rssi_response *response,
                                              uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_get_rssi_command, NULL,
                           &mip_rtk_get_rssi_response_codec, response, now);
}

/** Get RSSI. */
static inline struct mip_result mip_call_rtk_get_rssi(struct mip_device *device,
                                                      struct mip_rtk_get_rssi_response *response) {
    return mip_device_request(device, &mip_rtk_get_rssi_exchange,
                              MIP_NO_DATA(mip_rtk_get_rssi_exchange), 0,
                              &mip_rtk_get_rssi_response_codec, response);
}

MIP_COMMAND_REPLIES(mip_rtk_connected_device_type);
MIP_SEND(mip_send_rtk_connected_device_type, mip_rtk_connected_device_type,
         mip_rtk_connected_device_type_response);
MIP_CALL_FOR(mip_call_rtk_connected_device_type_read, mip_rtk_connected_device_type,
             MIP_FUNCTION_SELECTOR_READ, mip_rtk_connected_device_type_response);
MIP_CALL(mip_call_rtk_connected_device_type_save, mip_rtk_connected_device_type,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_rtk_connected_device_type_load, mip_rtk_connected_device_type,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_rtk_connected_device_type_default, mip_rtk_connected_device_type,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_rtk_connected_device_type_with, mip_rtk_connected_device_type,
              mip_rtk_connected_device_type_response);

/**
 * Connected device type: write.
 *
 * - device_type: Type of device that the modem is connected to. A value of enum
 *   mip_rtk_connected_device. Required for write.
 */
static inline struct mip_result mip_call_rtk_connected_device_type_write(
    struct mip_device *device, enum mip_rtk_connected_device device_type) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_WRITE, (uint8_t)device_type};
    return mip_device_send(device, &mip_rtk_connected_device_type_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_rtk_get_activation_code);

/** Get activation code: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_rtk_get_activation_code(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    struct mip_rtk_get_activation_code_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_get_activation_code_command, NULL,
                           &mip_rtk_get_activation_code_response_codec, response, now);
}

/** Get activation code. */
static inline struct mip_result mip_call_rtk_get_activation_code(
    struct mip_device *device, struct mip_rtk_get_activation_code_response *response) {
    return mip_device_request(device, &mip_rtk_get_activation_code_exchange,
                              MIP_NO_DATA(mip_rtk_get_activation_code_exchange), 0,
                              &mip_rtk_get_activation_code_response_codec, response);
}

MIP_COMMAND_REPLIES(mip_rtk_get_modem_firmware_version);

/** Get modem firmware version: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_rtk_get_modem_firmware_version(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    struct mip_rtk_get_modem_firmware_version_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_get_modem_firmware_version_command,
                           NULL, &mip_rtk_get_modem_firmware_version_response_codec, response, now);
}

/** Get modem firmware version. */
static inline struct mip_result mip_call_rtk_get_modem_firmware_version(
    struct mip_device *device, struct mip_rtk_get_modem_firmware_version_response *response) {
    return mip_device_request(device, &mip_rtk_get_modem_firmware_version_exchange,
                              MIP_NO_DATA(mip_rtk_get_modem_firmware_version_exchange), 0,
                              &mip_rtk_get_modem_firmware_version_response_codec, response);
}

MIP_COMMAND_REPLIES(mip_rtk_service_status);
MIP_SEND(mip_send_rtk_service_status, mip_rtk_service_status, mip_rtk_service_status_response);
MIP_CALL_WITH(mip_call_rtk_service_status_with, mip_rtk_service_status,
              mip_rtk_service_status_response);

MIP_COMMAND_REPLIES(mip_rtk_erase_storage);

/** Erase storage: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_rtk_erase_storage(struct mip_client *client,
                                                   struct mip_request *request,
                                                   struct mip_builder *packet,
                                                   const struct mip_rtk_erase_storage *command,
                                                   uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_erase_storage_command, command, NULL,
                           NULL, now);
}

/**
 * Erase storage.
 *
 * - media: The medium. A value of enum mip_rtk_storage_medium.
 */
static inline struct mip_result mip_call_rtk_erase_storage(struct mip_device *device,
                                                           enum mip_rtk_storage_medium media) {
    const uint8_t data[] = {(uint8_t)media};
    return mip_device_send(device, &mip_rtk_erase_storage_exchange, data, 1);
}

/** Erase storage, with these values, including optional parameters. */
static inline struct mip_result mip_call_rtk_erase_storage_with(
    struct mip_device *device, const struct mip_rtk_erase_storage *command) {
    return mip_device_call(device, &mip_rtk_erase_storage_command, command, NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_rtk_led_control);

/** LED control: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_rtk_led_control(struct mip_client *client,
                                                 struct mip_request *request,
                                                 struct mip_builder *packet,
                                                 const struct mip_rtk_led_control *command,
                                                 uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_led_control_command, command, NULL,
                           NULL, now);
}

/**
 * LED control.
 *
 * - primary_color: First colour. Uncertain: No source states the order of its parts; red, green,
 *   blue is likely.
 * - alternate_color: Second colour. Uncertain: No source states the order of its parts; red, green,
 *   blue is likely.
 * - action: Pattern. A value of enum mip_rtk_led_action.
 * - period: Period of the pattern. Uncertain: No source states the unit; ms is likely.
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
        mip_put_8(data + 1 * i, (uint8_t)primary_color[i]);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_8(data + 3 + 1 * i, (uint8_t)alternate_color[i]);
    }
    return mip_device_send(device, &mip_rtk_led_control_exchange, data, 11);
}

/** LED control, with these values, including optional parameters. */
static inline struct mip_result mip_call_rtk_led_control_with(
    struct mip_device *device, const struct mip_rtk_led_control *command) {
    return mip_device_call(device, &mip_rtk_led_control_command, command, NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_rtk_modem_hard_reset);

/** Modem hard reset: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_rtk_modem_hard_reset(struct mip_client *client,
                                                      struct mip_request *request,
                                                      struct mip_builder *packet, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_modem_hard_reset_command, NULL, NULL,
                           NULL, now);
}

/** Modem hard reset. */
static inline struct mip_result mip_call_rtk_modem_hard_reset(struct mip_device *device) {
    return mip_device_send(device, &mip_rtk_modem_hard_reset_exchange,
                           MIP_NO_DATA(mip_rtk_modem_hard_reset_exchange), 0);
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
