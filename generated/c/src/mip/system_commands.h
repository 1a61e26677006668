/**
 * @file
 * The commands of System, each with the types of its parameters and of its response.
 */
#ifndef MIP_SYSTEM_COMMANDS_H
#define MIP_SYSTEM_COMMANDS_H

#include "mip/system.h"
#include "mip/device.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/system_commands.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_system System (0x7F)
 * @{ */

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_system_interface_control_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_system_interface_control_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Interface control. If the
 * command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_system_interface_control(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_system_interface_control *command,
    struct mip_system_interface_control_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_system_interface_control_command, command,
                           &mip_system_interface_control_response_codec, response, now);
}

/**
 * Interface control: write. Apply the new setting. See mip_device_call.
 *
 * - port: Port whose protocols are set or read. A value of enum mip_comm_interface. Uncertain:
 *   Whether write and read accept `all`.
 * - protocols_incoming: Protocols that the port receives. Required for write.
 * - protocols_outgoing: Protocols that the port sends. Required for write.
 */
static inline struct mip_result mip_call_system_interface_control_write(
    struct mip_device *device, enum mip_comm_interface port,
    mip_system_comm_protocols protocols_incoming, mip_system_comm_protocols protocols_outgoing) {
    uint8_t data[10];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)port);
    mip_put_32(data + 2, (uint32_t)protocols_incoming);
    mip_put_32(data + 6, (uint32_t)protocols_outgoing);
    return mip_device_send(device, &mip_system_interface_control_exchange, data, 10);
}

/**
 * Interface control: read. Return the current setting in a response. See mip_device_call.
 *
 * - port: Port whose protocols are set or read. A value of enum mip_comm_interface. Uncertain:
 *   Whether write and read accept `all`.
 */
static inline struct mip_result
mip_call_system_interface_control_read(struct mip_device *device, enum mip_comm_interface port,
                                       struct mip_system_interface_control_response *response) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    mip_put_8(data + 1, (uint8_t)port);
    return mip_device_request(device, &mip_system_interface_control_exchange, data, 2,
                              &mip_system_interface_control_response_codec, response);
}

/**
 * Interface control: save. Save the current setting to non-volatile memory. See mip_device_call.
 *
 * - port: Port whose protocols are set or read. A value of enum mip_comm_interface. Uncertain:
 *   Whether write and read accept `all`.
 */
static inline struct mip_result
mip_call_system_interface_control_save(struct mip_device *device, enum mip_comm_interface port) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    mip_put_8(data + 1, (uint8_t)port);
    return mip_device_send(device, &mip_system_interface_control_exchange, data, 2);
}

/**
 * Interface control: load. Load the saved setting. See mip_device_call.
 *
 * - port: Port whose protocols are set or read. A value of enum mip_comm_interface. Uncertain:
 *   Whether write and read accept `all`.
 */
static inline struct mip_result
mip_call_system_interface_control_load(struct mip_device *device, enum mip_comm_interface port) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    mip_put_8(data + 1, (uint8_t)port);
    return mip_device_send(device, &mip_system_interface_control_exchange, data, 2);
}

/**
 * Interface control: default. Load the factory default setting. See mip_device_call.
 *
 * - port: Port whose protocols are set or read. A value of enum mip_comm_interface. Uncertain:
 *   Whether write and read accept `all`.
 */
static inline struct mip_result
mip_call_system_interface_control_default(struct mip_device *device, enum mip_comm_interface port) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    mip_put_8(data + 1, (uint8_t)port);
    return mip_device_send(device, &mip_system_interface_control_exchange, data, 2);
}

/**
 * Interface control: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_system_interface_control_with(
    struct mip_device *device, const struct mip_system_interface_control *command,
    struct mip_system_interface_control_response *response) {
    return mip_device_call(device, &mip_system_interface_control_command, command,
                           &mip_system_interface_control_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_system_comm_mode_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_system_comm_mode_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Communication mode. If
 * the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_system_comm_mode(struct mip_client *client,
                                                  struct mip_request *request,
                                                  struct mip_builder *packet,
                                                  const struct mip_system_comm_mode *command,
                                                  struct mip_system_comm_mode_response *response,
                                                  uint32_t now) {
    return mip_client_send(client, request, packet, &mip_system_comm_mode_command, command,
                           &mip_system_comm_mode_response_codec, response, now);
}

/**
 * Communication mode: write. Apply the new setting. See mip_device_call.
 *
 * - mode: Communication mode. A value of enum mip_system_protocol_mode. Default:
 *   MIP_SYSTEM_PROTOCOL_MODE_STANDARD. Required for write. On the 3DM-GX5-35: default
 *   MIP_SYSTEM_PROTOCOL_MODE_STANDARD.
 */
static inline struct mip_result
mip_call_system_comm_mode_write(struct mip_device *device, enum mip_system_protocol_mode mode) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)mode);
    return mip_device_send(device, &mip_system_comm_mode_exchange, data, 2);
}

/** Communication mode: read. Return the current setting in a response. See mip_device_call. */
static inline struct mip_result mip_call_system_comm_mode_read(
    struct mip_device *device, struct mip_system_comm_mode_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_system_comm_mode_exchange, data, 1,
                              &mip_system_comm_mode_response_codec, response);
}

/**
 * Communication mode: save. Save the current setting to non-volatile memory. See mip_device_call.
 */
static inline struct mip_result mip_call_system_comm_mode_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_system_comm_mode_exchange, data, 1);
}

/** Communication mode: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result mip_call_system_comm_mode_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_system_comm_mode_exchange, data, 1);
}

/** Communication mode: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result mip_call_system_comm_mode_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_system_comm_mode_exchange, data, 1);
}

/**
 * Communication mode: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_system_comm_mode_with(
    struct mip_device *device, const struct mip_system_comm_mode *command,
    struct mip_system_comm_mode_response *response) {
    return mip_device_call(device, &mip_system_comm_mode_command, command,
                           &mip_system_comm_mode_response_codec, response);
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
