/**
 * @file
 * The commands of Tools, each with the types of its parameters and of its response.
 */
#ifndef MIP_TOOLS_COMMANDS_H
#define MIP_TOOLS_COMMANDS_H

#include "mip/tools.h"
#include "mip/device.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/tools_commands.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_tools Tools (0x01)
 * @{ */

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_tools_ping_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_tools_ping_exchange;

/** Adds the command to a packet and tracks its reply: see mip_client_send. Ping. */
static inline mip_error mip_send_tools_ping(struct mip_client *client, struct mip_request *request,
                                            struct mip_builder *packet, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_ping_command, NULL, NULL, NULL, now);
}

/** Ping. See mip_device_call. */
static inline struct mip_result mip_call_tools_ping(struct mip_device *device) {
    return mip_device_send(device, &mip_tools_ping_exchange, MIP_NO_DATA(mip_tools_ping_exchange),
                           0);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_tools_settings_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_tools_settings_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Settings. If the command
 * requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_tools_settings(struct mip_client *client,
                                                struct mip_request *request,
                                                struct mip_builder *packet,
                                                const struct mip_tools_settings *command,
                                                struct mip_tools_settings_response *response,
                                                uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_settings_command, command,
                           &mip_tools_settings_response_codec, response, now);
}

/**
 * Settings: write. Apply the new setting. See mip_device_call.
 *
 * - port: Number of the port, 0 for all. Range: 0 to 8.
 * - mode: What to do. A value of enum mip_mode. Default: MIP_MODE_FAST. Required for write, read
 *   and apply. On the Model C: only MIP_MODE_DEFAULT and MIP_MODE_FAST; not deprecated.
 * - baud: Speed. Unit: Bd. Default: 115200. Required for write and apply.
 */
static inline struct mip_result mip_call_tools_settings_write(struct mip_device *device,
                                                              uint8_t port, enum mip_mode mode,
                                                              uint32_t baud) {
    uint8_t data[7];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)port);
    mip_put_8(data + 2, (uint8_t)mode);
    mip_put_32(data + 3, (uint32_t)baud);
    return mip_device_send(device, &mip_tools_settings_exchange, data, 7);
}

/**
 * Settings: read. Send the current setting back in a response. See mip_device_call.
 *
 * - port: Number of the port, 0 for all. Range: 0 to 8.
 * - mode: What to do. A value of enum mip_mode. Default: MIP_MODE_FAST. Required for write, read
 *   and apply. On the Model C: only MIP_MODE_DEFAULT and MIP_MODE_FAST; not deprecated.
 */
static inline struct mip_result
mip_call_tools_settings_read(struct mip_device *device, uint8_t port, enum mip_mode mode,
                             struct mip_tools_settings_response *response) {
    uint8_t data[3];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    mip_put_8(data + 1, (uint8_t)port);
    mip_put_8(data + 2, (uint8_t)mode);
    return mip_device_request(device, &mip_tools_settings_exchange, data, 3,
                              &mip_tools_settings_response_codec, response);
}

/**
 * Settings: save. Save the current setting to non-volatile memory. See mip_device_call.
 *
 * - port: Number of the port, 0 for all. Range: 0 to 8.
 */
static inline struct mip_result mip_call_tools_settings_save(struct mip_device *device,
                                                             uint8_t port) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    mip_put_8(data + 1, (uint8_t)port);
    return mip_device_send(device, &mip_tools_settings_exchange, data, 2);
}

/**
 * Settings: load. Load the saved setting. See mip_device_call.
 *
 * - port: Number of the port, 0 for all. Range: 0 to 8.
 */
static inline struct mip_result mip_call_tools_settings_load(struct mip_device *device,
                                                             uint8_t port) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    mip_put_8(data + 1, (uint8_t)port);
    return mip_device_send(device, &mip_tools_settings_exchange, data, 2);
}

/**
 * Settings: default. Load the factory default setting. See mip_device_call.
 *
 * - port: Number of the port, 0 for all. Range: 0 to 8.
 */
static inline struct mip_result mip_call_tools_settings_default(struct mip_device *device,
                                                                uint8_t port) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    mip_put_8(data + 1, (uint8_t)port);
    return mip_device_send(device, &mip_tools_settings_exchange, data, 2);
}

/**
 * Settings: apply. Apply the new setting and send no acknowledge (5-series devices). See
 * mip_device_call.
 *
 * - port: Number of the port, 0 for all. Range: 0 to 8.
 * - mode: What to do. A value of enum mip_mode. Default: MIP_MODE_FAST. Required for write, read
 *   and apply. On the Model C: only MIP_MODE_DEFAULT and MIP_MODE_FAST; not deprecated.
 * - baud: Speed. Unit: Bd. Default: 115200. Required for write and apply.
 */
static inline struct mip_result mip_call_tools_settings_apply(struct mip_device *device,
                                                              uint8_t port, enum mip_mode mode,
                                                              uint32_t baud) {
    struct mip_tools_settings command;
    return mip_device_call(device, &mip_tools_settings_command,
                           mip_tools_settings_apply(&command, port, mode, baud), NULL, NULL);
}

/**
 * Settings: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_tools_settings_with(struct mip_device *device, const struct mip_tools_settings *command,
                             struct mip_tools_settings_response *response) {
    return mip_device_call(device, &mip_tools_settings_command, command,
                           &mip_tools_settings_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_tools_set_time_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_tools_set_time_exchange;

/** Adds the command to a packet and tracks its reply: see mip_client_send. Set time. */
static inline mip_error mip_send_tools_set_time(struct mip_client *client,
                                                struct mip_request *request,
                                                struct mip_builder *packet,
                                                const struct mip_tools_set_time *command,
                                                uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_set_time_command, command, NULL,
                           NULL, now);
}

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Set time. Expects this
 * response.
 */
static inline mip_error mip_send_for_tools_set_time_fast_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_tools_set_time *command, struct mip_tools_set_time_fast_response *response,
    uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_set_time_command, command,
                           &mip_tools_set_time_fast_response_codec, response, now);
}

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Set time. Expects this
 * response.
 */
static inline mip_error mip_send_for_tools_set_time_slow_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_tools_set_time *command, struct mip_tools_set_time_slow_response *response,
    uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_set_time_command, command,
                           &mip_tools_set_time_slow_response_codec, response, now);
}

/**
 * Set time: write. Apply the new setting. See mip_device_call.
 *
 * - part: Which half of the time. A value of enum mip_mode.
 * - value: The new value. Unit: s. Required for write and apply.
 */
static inline struct mip_result mip_call_tools_set_time_write(struct mip_device *device,
                                                              enum mip_mode part, uint32_t value) {
    uint8_t data[6];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)part);
    mip_put_32(data + 2, (uint32_t)value);
    return mip_device_send(device, &mip_tools_set_time_exchange, data, 6);
}

/**
 * Set time: read. Send the current setting back in a response. See mip_device_call.
 *
 * - part: Which half of the time. A value of enum mip_mode.
 */
static inline struct mip_result mip_call_tools_set_time_read(struct mip_device *device,
                                                             enum mip_mode part) {
    struct mip_tools_set_time command;
    return mip_device_call(device, &mip_tools_set_time_command,
                           mip_tools_set_time_read(&command, part), NULL, NULL);
}

/**
 * Set time: read. Send the current setting back in a response. The reply is decoded as this
 * response. See mip_device_call.
 */
static inline struct mip_result mip_call_for_tools_set_time_fast_response_read(
    struct mip_device *device, struct mip_tools_set_time_fast_response *response) {
    struct mip_tools_set_time command;
    return mip_device_call(device, &mip_tools_set_time_command,
                           mip_tools_set_time_read(&command, MIP_MODE_FAST),
                           &mip_tools_set_time_fast_response_codec, response);
}

/**
 * Set time: read. Send the current setting back in a response. The reply is decoded as this
 * response. See mip_device_call.
 */
static inline struct mip_result mip_call_for_tools_set_time_slow_response_read(
    struct mip_device *device, struct mip_tools_set_time_slow_response *response) {
    struct mip_tools_set_time command;
    return mip_device_call(device, &mip_tools_set_time_command,
                           mip_tools_set_time_read(&command, MIP_MODE_SLOW),
                           &mip_tools_set_time_slow_response_codec, response);
}

/**
 * Set time: apply. Apply the new setting and send no acknowledge (5-series devices). See
 * mip_device_call.
 *
 * - part: Which half of the time. A value of enum mip_mode.
 * - value: The new value. Unit: s. Required for write and apply.
 */
static inline struct mip_result mip_call_tools_set_time_apply(struct mip_device *device,
                                                              enum mip_mode part, uint32_t value) {
    struct mip_tools_set_time command;
    return mip_device_call(device, &mip_tools_set_time_command,
                           mip_tools_set_time_apply(&command, part, value), NULL, NULL);
}

/**
 * Set time: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_tools_set_time_with(struct mip_device *device, const struct mip_tools_set_time *command) {
    return mip_device_call(device, &mip_tools_set_time_command, command, NULL, NULL);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_tools_status_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_tools_status_exchange;

/** Adds the command to a packet and tracks its reply: see mip_client_send. Status. */
static inline mip_error mip_send_tools_status(struct mip_client *client,
                                              struct mip_request *request,
                                              struct mip_builder *packet,
                                              const struct mip_tools_status *command,
                                              uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_status_command, command, NULL, NULL,
                           now);
}

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Status. Expects this
 * response.
 */
static inline mip_error mip_send_for_tools_status_paged(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_tools_status *command, struct mip_tools_status_paged *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_status_command, command,
                           &mip_tools_status_paged_codec, response, now);
}

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Status. Expects this
 * response.
 */
static inline mip_error mip_send_for_tools_status_short(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_tools_status *command, struct mip_tools_status_short *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_status_command, command,
                           &mip_tools_status_short_codec, response, now);
}

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Status. Expects this
 * response.
 */
static inline mip_error mip_send_for_tools_status_long(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_tools_status *command, struct mip_tools_status_long *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_status_command, command,
                           &mip_tools_status_long_codec, response, now);
}

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Status. Expects this
 * response.
 */
static inline mip_error mip_send_for_tools_status_old(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_tools_status *command, struct mip_tools_status_old *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_status_command, command,
                           &mip_tools_status_old_codec, response, now);
}

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Status. Expects this
 * response.
 */
static inline mip_error mip_send_for_tools_full(struct mip_client *client,
                                                struct mip_request *request,
                                                struct mip_builder *packet,
                                                const struct mip_tools_status *command,
                                                struct mip_tools_full *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_status_command, command,
                           &mip_tools_full_codec, response, now);
}

/**
 * Status. See mip_device_call.
 *
 * - selector: Which layout. Range: 1 to 2. On the Model C: always 2. Inferred: It has one layout.
 */
static inline struct mip_result mip_call_tools_status(struct mip_device *device, uint8_t selector) {
    struct mip_tools_status command;
    return mip_device_call(device, &mip_tools_status_command,
                           mip_tools_status_make(&command, selector), NULL, NULL);
}

/** Status. The reply is decoded as this response. See mip_device_call. */
static inline struct mip_result mip_call_for_tools_status_paged(
    struct mip_device *device, struct mip_tools_status_paged *response) {
    struct mip_tools_status command;
    return mip_device_call(device, &mip_tools_status_command, mip_tools_status_make(&command, 1),
                           &mip_tools_status_paged_codec, response);
}

/** Status. The reply is decoded as this response. See mip_device_call. */
static inline struct mip_result mip_call_for_tools_status_short(
    struct mip_device *device, struct mip_tools_status_short *response) {
    struct mip_tools_status command;
    return mip_device_call(device, &mip_tools_status_command, mip_tools_status_make(&command, 1),
                           &mip_tools_status_short_codec, response);
}

/** Status. The reply is decoded as this response. See mip_device_call. */
static inline struct mip_result
mip_call_for_tools_status_long(struct mip_device *device, struct mip_tools_status_long *response) {
    struct mip_tools_status command;
    return mip_device_call(device, &mip_tools_status_command, mip_tools_status_make(&command, 2),
                           &mip_tools_status_long_codec, response);
}

/** Status. The reply is decoded as this response. See mip_device_call. */
static inline struct mip_result
mip_call_for_tools_status_old(struct mip_device *device, struct mip_tools_status_old *response) {
    struct mip_tools_status command;
    return mip_device_call(device, &mip_tools_status_command, mip_tools_status_make(&command, 2),
                           &mip_tools_status_old_codec, response);
}

/** Status. The reply is decoded as this response. See mip_device_call. */
static inline struct mip_result mip_call_for_tools_full(struct mip_device *device,
                                                        struct mip_tools_full *response) {
    struct mip_tools_status command;
    return mip_device_call(device, &mip_tools_status_command, mip_tools_status_make(&command, 2),
                           &mip_tools_full_codec, response);
}

/**
 * Status: calls the command with these values, including optional parameters. See mip_device_call.
 */
static inline struct mip_result mip_call_tools_status_with(struct mip_device *device,
                                                           const struct mip_tools_status *command) {
    return mip_device_call(device, &mip_tools_status_command, command, NULL, NULL);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_tools_bias_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_tools_bias_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Bias. If the command
 * requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_tools_bias(struct mip_client *client, struct mip_request *request,
                                            struct mip_builder *packet,
                                            const struct mip_tools_bias *command,
                                            struct mip_tools_bias_vector *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_bias_command, command,
                           &mip_tools_bias_vector_codec, response, now);
}

/**
 * Bias: write. Apply the new setting. See mip_device_call.
 *
 * - bias: Taken off the measurement. Elements: x, y, z. Unit: g. Frame: sensor. Required for write.
 */
static inline struct mip_result mip_call_tools_bias_write(struct mip_device *device,
                                                          const float bias[3]) {
    uint8_t data[13];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 1 + 4 * i, &bias[i]);
    }
    return mip_device_send(device, &mip_tools_bias_exchange, data, 13);
}

/** Bias: read. Send the current setting back in a response. See mip_device_call. */
static inline struct mip_result mip_call_tools_bias_read(struct mip_device *device,
                                                         struct mip_tools_bias_vector *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_tools_bias_exchange, data, 1,
                              &mip_tools_bias_vector_codec, response);
}

/** Bias: save. Save the current setting to non-volatile memory. See mip_device_call. */
static inline struct mip_result mip_call_tools_bias_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_tools_bias_exchange, data, 1);
}

/** Bias: load. Load the saved setting. See mip_device_call. */
static inline struct mip_result mip_call_tools_bias_load(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_LOAD);
    return mip_device_send(device, &mip_tools_bias_exchange, data, 1);
}

/** Bias: default. Load the factory default setting. See mip_device_call. */
static inline struct mip_result mip_call_tools_bias_default(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT);
    return mip_device_send(device, &mip_tools_bias_exchange, data, 1);
}

/**
 * Bias: calls the command with these values, including optional parameters. See mip_device_call.
 */
static inline struct mip_result mip_call_tools_bias_with(struct mip_device *device,
                                                         const struct mip_tools_bias *command,
                                                         struct mip_tools_bias_vector *response) {
    return mip_device_call(device, &mip_tools_bias_command, command, &mip_tools_bias_vector_codec,
                           response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_tools_capture_bias_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_tools_capture_bias_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Capture bias. If the
 * command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_tools_capture_bias(struct mip_client *client,
                                                    struct mip_request *request,
                                                    struct mip_builder *packet,
                                                    const struct mip_tools_capture_bias *command,
                                                    struct mip_tools_bias_vector *response,
                                                    uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_capture_bias_command, command,
                           &mip_tools_bias_vector_codec, response, now);
}

/**
 * Capture bias. See mip_device_call.
 *
 * - time: How long. Unit: s. Range: 1 to 30.
 */
static inline struct mip_result mip_call_tools_capture_bias(
    struct mip_device *device, uint16_t time, struct mip_tools_bias_vector *response) {
    uint8_t data[2];
    mip_put_16(data, (uint16_t)time);
    return mip_device_request(device, &mip_tools_capture_bias_exchange, data, 2,
                              &mip_tools_bias_vector_codec, response);
}

/**
 * Capture bias: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_tools_capture_bias_with(
    struct mip_device *device, const struct mip_tools_capture_bias *command,
    struct mip_tools_bias_vector *response) {
    return mip_device_call(device, &mip_tools_capture_bias_command, command,
                           &mip_tools_bias_vector_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_tools_formats_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_tools_formats_exchange;

/** Adds the command to a packet and tracks its reply: see mip_client_send. Formats. */
static inline mip_error mip_send_tools_formats(struct mip_client *client,
                                               struct mip_request *request,
                                               struct mip_builder *packet,
                                               const struct mip_tools_formats *command,
                                               uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_formats_command, command, NULL, NULL,
                           now);
}

/**
 * Formats. See mip_device_call.
 *
 * - suppress_ack: Send no acknowledge.
 * - num_segments: Number of segments. Counts the elements of segments.
 * - checkpoint: Between a counter and its array. Deprecated.
 * - segments: The segments.
 */
static inline struct mip_result mip_call_tools_formats(struct mip_device *device,
                                                       mip_bool suppress_ack, uint8_t num_segments,
                                                       uint8_t checkpoint,
                                                       const struct mip_segment segments[]) {
    struct mip_tools_formats command;
    return mip_device_call(
        device, &mip_tools_formats_command,
        mip_tools_formats_make(&command, suppress_ack, num_segments, checkpoint, segments), NULL,
        NULL);
}

/**
 * Formats: calls the command with these values, including optional parameters. See mip_device_call.
 */
static inline struct mip_result
mip_call_tools_formats_with(struct mip_device *device, const struct mip_tools_formats *command) {
    return mip_device_call(device, &mip_tools_formats_command, command, NULL, NULL);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_tools_choice_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_tools_choice_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Choice. If the command
 * requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_tools_choice(struct mip_client *client,
                                              struct mip_request *request,
                                              struct mip_builder *packet,
                                              const struct mip_tools_choice *command,
                                              struct mip_tools_choice_response *response,
                                              uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_choice_command, command,
                           &mip_tools_choice_response_codec, response, now);
}

/**
 * Choice: write. Apply the new setting. See mip_device_call.
 *
 * - instance: Which one.
 * - shape: Which member follows. A value of enum mip_tools_shape. Required for write.
 * - parameters: The member. Selected by shape. Required for write. Empty if shape is
 *   MIP_TOOLS_SHAPE_NONE.
 */
static inline struct mip_result
mip_call_tools_choice_write(struct mip_device *device, uint8_t instance, enum mip_tools_shape shape,
                            const union mip_tools_choice_parameters *parameters) {
    struct mip_tools_choice command;
    return mip_device_call(device, &mip_tools_choice_command,
                           mip_tools_choice_write(&command, instance, shape, parameters), NULL,
                           NULL);
}

/**
 * Choice: read. Send the current setting back in a response. See mip_device_call.
 *
 * - instance: Which one.
 */
static inline struct mip_result mip_call_tools_choice_read(
    struct mip_device *device, uint8_t instance, struct mip_tools_choice_response *response) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    mip_put_8(data + 1, (uint8_t)instance);
    return mip_device_request(device, &mip_tools_choice_exchange, data, 2,
                              &mip_tools_choice_response_codec, response);
}

/**
 * Choice: calls the command with these values, including optional parameters. See mip_device_call.
 */
static inline struct mip_result
mip_call_tools_choice_with(struct mip_device *device, const struct mip_tools_choice *command,
                           struct mip_tools_choice_response *response) {
    return mip_device_call(device, &mip_tools_choice_command, command,
                           &mip_tools_choice_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_tools_list_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_tools_list_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. List. If the command
 * requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_tools_list(struct mip_client *client, struct mip_request *request,
                                            struct mip_builder *packet,
                                            const struct mip_tools_list *command,
                                            struct mip_tools_list_response *response,
                                            uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_list_command, command,
                           &mip_tools_list_response_codec, response, now);
}

/**
 * List: write. Apply the new setting. See mip_device_call.
 *
 * - count: Number of items. Counts the elements of items. Required for write.
 * - items: The items. Required for write.
 */
MIP_INLINE struct mip_result mip_call_tools_list_write(struct mip_device *device, uint8_t count,
                                                       const uint16_t items[]) {
    uint8_t data[MIP_MAX_FIELD_DATA];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)count);
    (void)mip_counted(count, items, sizeof(items[0]));
    for (size_t i = 0; i < count && i < 125; i++) {
        mip_put_16(data + 2 + 2 * i, (uint16_t)items[i]);
    }
    return mip_device_send(device, &mip_tools_list_exchange, data,
                           count <= 125 ? 2 + 2 * (size_t)count : MIP_MAX_FIELD_DATA + 1);
}

/** List: read. Send the current setting back in a response. See mip_device_call. */
static inline struct mip_result mip_call_tools_list_read(struct mip_device *device,
                                                         struct mip_tools_list_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_tools_list_exchange, data, 1,
                              &mip_tools_list_response_codec, response);
}

/** List: save. Save the current setting to non-volatile memory. See mip_device_call. */
static inline struct mip_result mip_call_tools_list_save(struct mip_device *device) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_SAVE);
    return mip_device_send(device, &mip_tools_list_exchange, data, 1);
}

/**
 * List: calls the command with these values, including optional parameters. See mip_device_call.
 */
static inline struct mip_result mip_call_tools_list_with(struct mip_device *device,
                                                         const struct mip_tools_list *command,
                                                         struct mip_tools_list_response *response) {
    return mip_device_call(device, &mip_tools_list_command, command, &mip_tools_list_response_codec,
                           response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_tools_stock_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_tools_stock_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Inventory. If the command
 * requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_tools_stock(struct mip_client *client, struct mip_request *request,
                                             struct mip_builder *packet,
                                             struct mip_tools_stock_response *response,
                                             uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_stock_command, NULL,
                           &mip_tools_stock_response_codec, response, now);
}

/** Inventory. See mip_device_call. */
static inline struct mip_result mip_call_tools_stock(struct mip_device *device,
                                                     struct mip_tools_stock_response *response) {
    return mip_device_request(device, &mip_tools_stock_exchange,
                              MIP_NO_DATA(mip_tools_stock_exchange), 0,
                              &mip_tools_stock_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_tools_pin_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_tools_pin_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Pin. If the command
 * requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_tools_pin(struct mip_client *client, struct mip_request *request,
                                           struct mip_builder *packet,
                                           const struct mip_tools_pin *command,
                                           struct mip_tools_pin_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_pin_command, command,
                           &mip_tools_pin_response_codec, response, now);
}

/**
 * Pin: write. Apply the new setting. See mip_device_call.
 *
 * - drive: What drives it. A value of enum mip_tools_drive.
 * - use: How it is used. Required for write. If drive is MIP_TOOLS_DRIVE_PULSE: values of enum
 *   mip_tools_pulse. If drive is MIP_TOOLS_DRIVE_SERIAL: values of enum mip_tools_serial_use.
 */
static inline struct mip_result mip_call_tools_pin_write(struct mip_device *device,
                                                         enum mip_tools_drive drive, uint8_t use) {
    uint8_t data[3];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)drive);
    mip_put_8(data + 2, (uint8_t)use);
    return mip_device_send(device, &mip_tools_pin_exchange, data, 3);
}

/**
 * Pin: read. Send the current setting back in a response. See mip_device_call.
 *
 * - drive: What drives it. A value of enum mip_tools_drive.
 */
static inline struct mip_result mip_call_tools_pin_read(struct mip_device *device,
                                                        enum mip_tools_drive drive,
                                                        struct mip_tools_pin_response *response) {
    uint8_t data[2];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    mip_put_8(data + 1, (uint8_t)drive);
    return mip_device_request(device, &mip_tools_pin_exchange, data, 2,
                              &mip_tools_pin_response_codec, response);
}

/** Pin: calls the command with these values, including optional parameters. See mip_device_call. */
static inline struct mip_result mip_call_tools_pin_with(struct mip_device *device,
                                                        const struct mip_tools_pin *command,
                                                        struct mip_tools_pin_response *response) {
    return mip_device_call(device, &mip_tools_pin_command, command, &mip_tools_pin_response_codec,
                           response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_tools_hello_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_tools_hello_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Hello. If the command
 * requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_tools_hello(struct mip_client *client, struct mip_request *request,
                                             struct mip_builder *packet,
                                             const struct mip_tools_hello *command,
                                             struct mip_tools_hello_response *response,
                                             uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_hello_command, command,
                           &mip_tools_hello_response_codec, response, now);
}

/**
 * Hello: calls the command with these values, including optional parameters. See mip_device_call.
 */
static inline struct mip_result
mip_call_tools_hello_with(struct mip_device *device, const struct mip_tools_hello *command,
                          struct mip_tools_hello_response *response) {
    return mip_device_call(device, &mip_tools_hello_command, command,
                           &mip_tools_hello_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_tools_readings_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_tools_readings_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Readings. If the command
 * requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_tools_readings(struct mip_client *client,
                                                struct mip_request *request,
                                                struct mip_builder *packet,
                                                const struct mip_tools_readings *command,
                                                struct mip_tools_readings_response *response,
                                                uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_readings_command, command,
                           &mip_tools_readings_response_codec, response, now);
}

/**
 * Readings. See mip_device_call.
 *
 * - drive: What is asked for. A value of enum mip_tools_drive.
 */
static inline struct mip_result
mip_call_tools_readings(struct mip_device *device, enum mip_tools_drive drive,
                        struct mip_tools_readings_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)drive);
    return mip_device_request(device, &mip_tools_readings_exchange, data, 1,
                              &mip_tools_readings_response_codec, response);
}

/**
 * Readings: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result
mip_call_tools_readings_with(struct mip_device *device, const struct mip_tools_readings *command,
                             struct mip_tools_readings_response *response) {
    return mip_device_call(device, &mip_tools_readings_command, command,
                           &mip_tools_readings_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_tools_poll_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_tools_poll_exchange;

/** Adds the command to a packet and tracks its reply: see mip_client_send. Poll. */
static inline mip_error mip_send_tools_poll(struct mip_client *client, struct mip_request *request,
                                            struct mip_builder *packet,
                                            const struct mip_tools_poll *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_poll_command, command, NULL, NULL,
                           now);
}

/**
 * Poll. See mip_device_call.
 *
 * - descriptor_set: Data descriptor set. Range: 0x80 to 0xFE.
 * - first: Field descriptor. Refers to fields of MIP_MEASUREMENTS_SET. Default: 0x01.
 * - count: Number of fields. Counts the elements of descriptors.
 * - descriptors: Field descriptors. Refers to fields of descriptor_set.
 */
MIP_INLINE struct mip_result mip_call_tools_poll(struct mip_device *device, uint8_t descriptor_set,
                                                 uint8_t first, uint8_t count,
                                                 const uint8_t descriptors[]) {
    uint8_t data[MIP_MAX_FIELD_DATA];
    mip_put_8(data, (uint8_t)descriptor_set);
    mip_put_8(data + 1, (uint8_t)first);
    mip_put_8(data + 2, (uint8_t)count);
    (void)mip_counted(count, descriptors, sizeof(descriptors[0]));
    for (size_t i = 0; i < count && i < 250; i++) {
        mip_put_8(data + 3 + 1 * i, (uint8_t)descriptors[i]);
    }
    return mip_device_send(device, &mip_tools_poll_exchange, data,
                           count <= 250 ? 3 + 1 * (size_t)count : MIP_MAX_FIELD_DATA + 1);
}

/**
 * Poll: calls the command with these values, including optional parameters. See mip_device_call.
 */
static inline struct mip_result mip_call_tools_poll_with(struct mip_device *device,
                                                         const struct mip_tools_poll *command) {
    return mip_device_call(device, &mip_tools_poll_command, command, NULL, NULL);
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
