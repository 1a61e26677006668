/**
 * @file
 * The commands of Displacement commands, each with the types of its parameters and of its response.
 */
#ifndef MIP_DISPLACEMENT_COMMANDS_H
#define MIP_DISPLACEMENT_COMMANDS_H

#include "mip/displacement.h"
#include "mip/device.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/displacement_commands.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_displacement Displacement commands (0x11)
 * @{ */

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_displacement_get_calibration_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_displacement_get_calibration_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Get Analog to
 * Displacement Calibration. If the command requests the response, it is stored in `response`, which
 * may be NULL.
 */
static inline mip_error mip_send_displacement_get_calibration(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    struct mip_displacement_get_calibration_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_displacement_get_calibration_command, NULL,
                           &mip_displacement_get_calibration_response_codec, response, now);
}

/** Get Analog to Displacement Calibration. See mip_device_call. */
static inline struct mip_result mip_call_displacement_get_calibration(
    struct mip_device *device, struct mip_displacement_get_calibration_response *response) {
    return mip_device_request(device, &mip_displacement_get_calibration_exchange,
                              MIP_NO_DATA(mip_displacement_get_calibration_exchange), 0,
                              &mip_displacement_get_calibration_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_displacement_output_rate_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_displacement_output_rate_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Displacement Output Data
 * Rate. If the command requests the response, it is stored in `response`, which may be NULL.
 */
static inline mip_error mip_send_displacement_output_rate(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_displacement_output_rate *command,
    struct mip_displacement_output_rate_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_displacement_output_rate_command, command,
                           &mip_displacement_output_rate_response_codec, response, now);
}

/**
 * Displacement Output Data Rate: read. Return the current setting in a response. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_displacement_output_rate_read(
    struct mip_device *device, struct mip_displacement_output_rate_response *response) {
    uint8_t data[1];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_READ);
    return mip_device_request(device, &mip_displacement_output_rate_exchange, data, 1,
                              &mip_displacement_output_rate_response_codec, response);
}

/**
 * Displacement Output Data Rate: calls the command with these values, including optional
 * parameters. See mip_device_call.
 */
static inline struct mip_result mip_call_displacement_output_rate_with(
    struct mip_device *device, const struct mip_displacement_output_rate *command,
    struct mip_displacement_output_rate_response *response) {
    return mip_device_call(device, &mip_displacement_output_rate_command, command,
                           &mip_displacement_output_rate_response_codec, response);
}

/** The description of the command for the client. */
extern MIP_API const struct mip_command mip_displacement_device_time_command;

/** The description of its replies. */
extern MIP_API const struct mip_exchange mip_displacement_device_time_exchange;

/**
 * Adds the command to a packet and tracks its reply: see mip_client_send. Displacement Device Time.
 */
static inline mip_error mip_send_displacement_device_time(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_displacement_device_time *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_displacement_device_time_command, command,
                           NULL, NULL, now);
}

/**
 * Displacement Device Time: write. Apply the new setting. See mip_device_call.
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

/**
 * Displacement Device Time: calls the command with these values, including optional parameters. See
 * mip_device_call.
 */
static inline struct mip_result mip_call_displacement_device_time_with(
    struct mip_device *device, const struct mip_displacement_device_time *command) {
    return mip_device_call(device, &mip_displacement_device_time_command, command, NULL, NULL);
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
