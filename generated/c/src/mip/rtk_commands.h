/**
 * @file
 * The commands of RTK commands, each with the types of its parameters and of its response.
 */
#ifndef MIP_RTK_COMMANDS_H
#define MIP_RTK_COMMANDS_H

#include "mip/rtk.h"
#include "mip/client.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/rtk_commands.h and mip/constants.h are not of one version"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_rtk_get_status_flags_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Get status flags. The
 * response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_rtk_get_status_flags(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    struct mip_rtk_get_status_flags_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_get_status_flags_command, NULL,
                           &mip_rtk_get_status_flags_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_rtk_get_imei_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Get IMEI. The
 * response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_rtk_get_imei(struct mip_client *client,
                                              struct mip_request *request,
                                              struct mip_builder *packet,
                                              struct mip_rtk_get_imei_response *response,
                                              uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_get_imei_command, NULL,
                           &mip_rtk_get_imei_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_rtk_get_imsi_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Get IMSI. The
 * response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_rtk_get_imsi(struct mip_client *client,
                                              struct mip_request *request,
                                              struct mip_builder *packet,
                                              struct mip_rtk_get_imsi_response *response,
                                              uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_get_imsi_command, NULL,
                           &mip_rtk_get_imsi_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_rtk_get_iccid_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Get ICCID. The
 * response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_rtk_get_iccid(struct mip_client *client,
                                               struct mip_request *request,
                                               struct mip_builder *packet,
                                               struct mip_rtk_get_iccid_response *response,
                                               uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_get_iccid_command, NULL,
                           &mip_rtk_get_iccid_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_rtk_get_rssi_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Get RSSI. The
 * response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_rtk_get_rssi(struct mip_client *client,
                                              struct mip_request *request,
                                              struct mip_builder *packet,
                                              struct mip_rtk_get_rssi_response *response,
                                              uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_get_rssi_command, NULL,
                           &mip_rtk_get_rssi_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_rtk_connected_device_type_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Connected device
 * type. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_rtk_connected_device_type(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_rtk_connected_device_type *command,
    struct mip_rtk_connected_device_type_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_connected_device_type_command, command,
                           &mip_rtk_connected_device_type_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_rtk_get_activation_code_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Get activation code.
 * The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_rtk_get_activation_code(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    struct mip_rtk_get_activation_code_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_get_activation_code_command, NULL,
                           &mip_rtk_get_activation_code_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_rtk_get_modem_firmware_version_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Get modem firmware
 * version. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_rtk_get_modem_firmware_version(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    struct mip_rtk_get_modem_firmware_version_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_get_modem_firmware_version_command,
                           NULL, &mip_rtk_get_modem_firmware_version_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_rtk_service_status_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Service status. The
 * response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_rtk_service_status(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_rtk_service_status *command, struct mip_rtk_service_status_response *response,
    uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_service_status_command, command,
                           &mip_rtk_service_status_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_rtk_erase_storage_command;

/** Adds the command to a packet and waits for its answer: see mip_client_send. Erase storage. */
static inline mip_error mip_send_rtk_erase_storage(struct mip_client *client,
                                                   struct mip_request *request,
                                                   struct mip_builder *packet,
                                                   const struct mip_rtk_erase_storage *command,
                                                   uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_erase_storage_command, command, NULL,
                           NULL, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_rtk_led_control_command;

/** Adds the command to a packet and waits for its answer: see mip_client_send. LED control. */
static inline mip_error mip_send_rtk_led_control(struct mip_client *client,
                                                 struct mip_request *request,
                                                 struct mip_builder *packet,
                                                 const struct mip_rtk_led_control *command,
                                                 uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_led_control_command, command, NULL,
                           NULL, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_rtk_modem_hard_reset_command;

/** Adds the command to a packet and waits for its answer: see mip_client_send. Modem hard reset. */
static inline mip_error mip_send_rtk_modem_hard_reset(struct mip_client *client,
                                                      struct mip_request *request,
                                                      struct mip_builder *packet, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_rtk_modem_hard_reset_command, NULL, NULL,
                           NULL, now);
}

#ifdef __cplusplus
}
#endif

#endif
