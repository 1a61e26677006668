/**
 * @file
 * The commands of System, each with the types of its parameters and of its response.
 */
#ifndef MIP_SYSTEM_COMMANDS_H
#define MIP_SYSTEM_COMMANDS_H

#include "mip/system.h"
#include "mip/client.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/system_commands.h and mip/constants.h are not of one version"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_system_interface_control_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Interface control.
 * The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_system_interface_control(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_system_interface_control *command,
    struct mip_system_interface_control_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_system_interface_control_command, command,
                           &mip_system_interface_control_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_system_comm_mode_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Communication mode.
 * The response goes to `response`, which may be NULL, if the command asks for it.
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

#ifdef __cplusplus
}
#endif

#endif
