/**
 * @file
 * The commands of Displacement commands, each with the types of its parameters and of its response.
 */
#ifndef MIP_DISPLACEMENT_COMMANDS_H
#define MIP_DISPLACEMENT_COMMANDS_H

#include "mip/displacement.h"
#include "mip/device.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/displacement_commands.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_displacement Displacement commands (0x11)
 * @{ */

MIP_COMMAND_REPLIES(mip_displacement_get_calibration);

/** Get analog to displacement calibration: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_displacement_get_calibration(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    struct mip_displacement_get_calibration_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_displacement_get_calibration_command, NULL,
                           &mip_displacement_get_calibration_response_codec, response, now);
}

/** Get analog to displacement calibration. */
static inline struct mip_result mip_call_displacement_get_calibration(
    struct mip_device *device, struct mip_displacement_get_calibration_response *response) {
    return mip_device_request(device, &mip_displacement_get_calibration_exchange,
                              MIP_NO_DATA(mip_displacement_get_calibration_exchange), 0,
                              &mip_displacement_get_calibration_response_codec, response);
}

MIP_COMMAND_REPLIES(mip_displacement_output_rate);
MIP_SEND(mip_send_displacement_output_rate, mip_displacement_output_rate,
         mip_displacement_output_rate_response);
MIP_CALL_FOR(mip_call_displacement_output_rate_read, mip_displacement_output_rate,
             MIP_FUNCTION_SELECTOR_READ, mip_displacement_output_rate_response);
MIP_CALL_WITH(mip_call_displacement_output_rate_with, mip_displacement_output_rate,
              mip_displacement_output_rate_response);

MIP_COMMAND_REPLIES(mip_displacement_device_time);

/** Displacement device time: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_displacement_device_time(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_displacement_device_time *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_displacement_device_time_command, command,
                           NULL, NULL, now);
}

/**
 * Displacement device time: write.
 *
 * - time: UTC since 1970-01-01, without leap seconds. Unit: ns.
 */
static inline struct mip_result mip_call_displacement_device_time_write(struct mip_device *device,
                                                                        uint64_t time) {
    uint8_t data[9];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_64(data + 1, (uint64_t)time);
    return mip_device_send(device, &mip_displacement_device_time_exchange, data, 9);
}

/** Displacement device time, with these values, including optional parameters. */
static inline struct mip_result mip_call_displacement_device_time_with(
    struct mip_device *device, const struct mip_displacement_device_time *command) {
    return mip_device_call(device, &mip_displacement_device_time_command, command, NULL, NULL);
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
