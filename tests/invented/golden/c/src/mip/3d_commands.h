/**
 * @file
 * The commands of Awkward names, each with the types of its parameters and of its response.
 */
#ifndef MIP_3D_COMMANDS_H
#define MIP_3D_COMMANDS_H

#include "mip/3d.h"
#include "mip/client.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/3d_commands.h and mip/constants.h are not of one version"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_3d_default_command;

/** Adds the command to a packet and waits for its answer: see mip_client_send. Default. */
static inline mip_error mip_send_3d_default(struct mip_client *client, struct mip_request *request,
                                            struct mip_builder *packet,
                                            const struct mip_3d_default *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3d_default_command, command, NULL, NULL,
                           now);
}

#ifdef __cplusplus
}
#endif

#endif
