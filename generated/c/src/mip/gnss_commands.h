/**
 * @file
 * The commands of GNSS commands, each with the types of its parameters and of its response.
 */
#ifndef MIP_GNSS_COMMANDS_H
#define MIP_GNSS_COMMANDS_H

#include "mip/gnss.h"
#include "mip/client.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/gnss_commands.h and mip/constants.h are not of one version"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_gnss_receiver_info_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Receiver info. The
 * response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_gnss_receiver_info(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    struct mip_gnss_receiver_info_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_gnss_receiver_info_command, NULL,
                           &mip_gnss_receiver_info_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_gnss_signal_config_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Signal configuration.
 * The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_gnss_signal_config(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_gnss_signal_config *command, struct mip_gnss_signal_config_response *response,
    uint32_t now) {
    return mip_client_send(client, request, packet, &mip_gnss_signal_config_command, command,
                           &mip_gnss_signal_config_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_gnss_rtk_dongle_config_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. RTK dongle
 * configuration. The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_gnss_rtk_dongle_config(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_gnss_rtk_dongle_config *command,
    struct mip_gnss_rtk_dongle_config_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_gnss_rtk_dongle_config_command, command,
                           &mip_gnss_rtk_dongle_config_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_gnss_spartn_config_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. SPARTN configuration.
 * The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_gnss_spartn_config(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_gnss_spartn_config *command, struct mip_gnss_spartn_config_response *response,
    uint32_t now) {
    return mip_client_send(client, request, packet, &mip_gnss_spartn_config_command, command,
                           &mip_gnss_spartn_config_response_codec, response, now);
}

#ifdef __cplusplus
}
#endif

#endif
