/**
 * @file
 * The commands of Tools, each with the types of its parameters and of its response.
 */
#ifndef MIP_TOOLS_COMMANDS_H
#define MIP_TOOLS_COMMANDS_H

#include "mip/tools.h"
#include "mip/client.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/tools_commands.h and mip/constants.h are not of one version"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_tools_ping_command;

/** Adds the command to a packet and waits for its answer: see mip_client_send. Ping. */
static inline mip_error mip_send_tools_ping(struct mip_client *client, struct mip_request *request,
                                            struct mip_builder *packet, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_ping_command, NULL, NULL, NULL, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_tools_settings_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Settings. The
 * response goes to `response`, which may be NULL, if the command asks for it.
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
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_tools_set_time_command;

/** Adds the command to a packet and waits for its answer: see mip_client_send. Set time. */
static inline mip_error mip_send_tools_set_time(struct mip_client *client,
                                                struct mip_request *request,
                                                struct mip_builder *packet,
                                                const struct mip_tools_set_time *command,
                                                uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_set_time_command, command, NULL,
                           NULL, now);
}
/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Set time. It is
 * answered by this response.
 */
static inline mip_error mip_send_for_tools_set_time_fast_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_tools_set_time *command, struct mip_tools_set_time_fast_response *response,
    uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_set_time_command, command,
                           &mip_tools_set_time_fast_response_codec, response, now);
}
/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Set time. It is
 * answered by this response.
 */
static inline mip_error mip_send_for_tools_set_time_slow_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_tools_set_time *command, struct mip_tools_set_time_slow_response *response,
    uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_set_time_command, command,
                           &mip_tools_set_time_slow_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_tools_status_command;

/** Adds the command to a packet and waits for its answer: see mip_client_send. Status. */
static inline mip_error mip_send_tools_status(struct mip_client *client,
                                              struct mip_request *request,
                                              struct mip_builder *packet,
                                              const struct mip_tools_status *command,
                                              uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_status_command, command, NULL, NULL,
                           now);
}
/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Status. It is
 * answered by this response.
 */
static inline mip_error mip_send_for_tools_status_short(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_tools_status *command, struct mip_tools_status_short *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_status_command, command,
                           &mip_tools_status_short_codec, response, now);
}
/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Status. It is
 * answered by this response.
 */
static inline mip_error mip_send_for_tools_status_long(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_tools_status *command, struct mip_tools_status_long *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_status_command, command,
                           &mip_tools_status_long_codec, response, now);
}
/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Status. It is
 * answered by this response.
 */
static inline mip_error mip_send_for_tools_status_old(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_tools_status *command, struct mip_tools_status_old *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_status_command, command,
                           &mip_tools_status_old_codec, response, now);
}
/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Status. It is
 * answered by this response.
 */
static inline mip_error mip_send_for_tools_full(struct mip_client *client,
                                                struct mip_request *request,
                                                struct mip_builder *packet,
                                                const struct mip_tools_status *command,
                                                struct mip_tools_full *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_status_command, command,
                           &mip_tools_full_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_tools_bias_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Bias. The response
 * goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_tools_bias(struct mip_client *client, struct mip_request *request,
                                            struct mip_builder *packet,
                                            const struct mip_tools_bias *command,
                                            struct mip_tools_bias_vector *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_bias_command, command,
                           &mip_tools_bias_vector_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_tools_capture_bias_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Capture bias. The
 * response goes to `response`, which may be NULL, if the command asks for it.
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
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_tools_formats_command;

/** Adds the command to a packet and waits for its answer: see mip_client_send. Formats. */
static inline mip_error mip_send_tools_formats(struct mip_client *client,
                                               struct mip_request *request,
                                               struct mip_builder *packet,
                                               const struct mip_tools_formats *command,
                                               uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_formats_command, command, NULL, NULL,
                           now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_tools_choice_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Choice. The response
 * goes to `response`, which may be NULL, if the command asks for it.
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
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_tools_list_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. List. The response
 * goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_tools_list(struct mip_client *client, struct mip_request *request,
                                            struct mip_builder *packet,
                                            const struct mip_tools_list *command,
                                            struct mip_tools_list_response *response,
                                            uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_list_command, command,
                           &mip_tools_list_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_tools_stock_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Inventory. The
 * response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_tools_stock(struct mip_client *client, struct mip_request *request,
                                             struct mip_builder *packet,
                                             struct mip_tools_stock_response *response,
                                             uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_stock_command, NULL,
                           &mip_tools_stock_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_tools_pin_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Pin. The response
 * goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_tools_pin(struct mip_client *client, struct mip_request *request,
                                           struct mip_builder *packet,
                                           const struct mip_tools_pin *command,
                                           struct mip_tools_pin_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_pin_command, command,
                           &mip_tools_pin_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_tools_hello_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Hello. The response
 * goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_tools_hello(struct mip_client *client, struct mip_request *request,
                                             struct mip_builder *packet,
                                             const struct mip_tools_hello *command,
                                             struct mip_tools_hello_response *response,
                                             uint32_t now) {
    return mip_client_send(client, request, packet, &mip_tools_hello_command, command,
                           &mip_tools_hello_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_tools_readings_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Readings. The
 * response goes to `response`, which may be NULL, if the command asks for it.
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

#ifdef __cplusplus
}
#endif

#endif
