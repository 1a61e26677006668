/**
 * @file
 * The commands of Awkward names, each with the types of its parameters and of its response.
 */
#ifndef MIP_3D_COMMANDS_H
#define MIP_3D_COMMANDS_H

#include "mip/3d.h"
#include "mip/device.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/3d_commands.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_3d Awkward names (0x0C)
 * @{ */

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_3d_default_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_3d_default_exchange;

/** Adds the command to a packet and tracks its reply: see mip_client_send. Default. */
static inline mip_error mip_send_3d_default(struct mip_client *client, struct mip_request *request,
                                            struct mip_builder *packet,
                                            const struct mip_3d_default *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3d_default_command, command, NULL, NULL,
                           now);
}

/**
 * Default. See mip_device_call.
 *
 * - class_: A keyword.
 * - type: A keyword.
 * - register_: A keyword.
 * - self: A keyword.
 * - present_: Used by generated code elsewhere.
 */
static inline struct mip_result mip_call_3d_default(struct mip_device *device, uint8_t class_,
                                                    uint8_t type, uint8_t register_, uint8_t self,
                                                    uint8_t present_) {
    uint8_t data[5];
    mip_put_8(data, (uint8_t)class_);
    mip_put_8(data + 1, (uint8_t)type);
    mip_put_8(data + 2, (uint8_t)register_);
    mip_put_8(data + 3, (uint8_t)self);
    mip_put_8(data + 4, (uint8_t)present_);
    return mip_device_send(device, &mip_3d_default_exchange, data, 5);
}

/**
 * Default: calls the command with these values, including optional parameters. See mip_device_call.
 */
static inline struct mip_result mip_call_3d_default_with(struct mip_device *device,
                                                         const struct mip_3d_default *command) {
    return mip_device_call(device, &mip_3d_default_command, command, NULL, NULL);
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
