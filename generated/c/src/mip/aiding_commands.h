/**
 * @file
 * The commands of Aiding commands, each with the types of its parameters and of its response.
 */
#ifndef MIP_AIDING_COMMANDS_H
#define MIP_AIDING_COMMANDS_H

#include "mip/aiding.h"
#include "mip/client.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/aiding_commands.h and mip/constants.h are not of one version"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_aiding_frame_config_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Frame configuration.
 * The response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_aiding_frame_config(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_aiding_frame_config *command,
    struct mip_aiding_frame_config_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_aiding_frame_config_command, command,
                           &mip_aiding_frame_config_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_aiding_echo_control_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Echo control. The
 * response goes to `response`, which may be NULL, if the command asks for it.
 */
static inline mip_error mip_send_aiding_echo_control(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_aiding_echo_control *command,
    struct mip_aiding_echo_control_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_aiding_echo_control_command, command,
                           &mip_aiding_echo_control_response_codec, response, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_aiding_ecef_position_command;

/** Adds the command to a packet and waits for its answer: see mip_client_send. ECEF position. */
static inline mip_error mip_send_aiding_ecef_position(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_aiding_ecef_position *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_aiding_ecef_position_command, command,
                           NULL, NULL, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_aiding_llh_position_command;

/** Adds the command to a packet and waits for its answer: see mip_client_send. LLH position. */
static inline mip_error mip_send_aiding_llh_position(struct mip_client *client,
                                                     struct mip_request *request,
                                                     struct mip_builder *packet,
                                                     const struct mip_aiding_llh_position *command,
                                                     uint32_t now) {
    return mip_client_send(client, request, packet, &mip_aiding_llh_position_command, command, NULL,
                           NULL, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_aiding_height_above_ellipsoid_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Height above
 * ellipsoid.
 */
static inline mip_error mip_send_aiding_height_above_ellipsoid(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_aiding_height_above_ellipsoid *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_aiding_height_above_ellipsoid_command,
                           command, NULL, NULL, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_aiding_ecef_velocity_command;

/** Adds the command to a packet and waits for its answer: see mip_client_send. ECEF velocity. */
static inline mip_error mip_send_aiding_ecef_velocity(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_aiding_ecef_velocity *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_aiding_ecef_velocity_command, command,
                           NULL, NULL, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_aiding_ned_velocity_command;

/** Adds the command to a packet and waits for its answer: see mip_client_send. NED velocity. */
static inline mip_error mip_send_aiding_ned_velocity(struct mip_client *client,
                                                     struct mip_request *request,
                                                     struct mip_builder *packet,
                                                     const struct mip_aiding_ned_velocity *command,
                                                     uint32_t now) {
    return mip_client_send(client, request, packet, &mip_aiding_ned_velocity_command, command, NULL,
                           NULL, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_aiding_body_frame_velocity_command;

/**
 * Adds the command to a packet and waits for its answer: see mip_client_send. Body frame velocity.
 */
static inline mip_error mip_send_aiding_body_frame_velocity(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_aiding_body_frame_velocity *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_aiding_body_frame_velocity_command,
                           command, NULL, NULL, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_aiding_true_heading_command;

/** Adds the command to a packet and waits for its answer: see mip_client_send. True heading. */
static inline mip_error mip_send_aiding_true_heading(struct mip_client *client,
                                                     struct mip_request *request,
                                                     struct mip_builder *packet,
                                                     const struct mip_aiding_true_heading *command,
                                                     uint32_t now) {
    return mip_client_send(client, request, packet, &mip_aiding_true_heading_command, command, NULL,
                           NULL, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_aiding_magnetic_field_command;

/** Adds the command to a packet and waits for its answer: see mip_client_send. Magnetic field. */
static inline mip_error mip_send_aiding_magnetic_field(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_aiding_magnetic_field *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_aiding_magnetic_field_command, command,
                           NULL, NULL, now);
}
/** What the client knows of the command. */
extern MIP_API const struct mip_command mip_aiding_pressure_command;

/** Adds the command to a packet and waits for its answer: see mip_client_send. Pressure. */
static inline mip_error mip_send_aiding_pressure(struct mip_client *client,
                                                 struct mip_request *request,
                                                 struct mip_builder *packet,
                                                 const struct mip_aiding_pressure *command,
                                                 uint32_t now) {
    return mip_client_send(client, request, packet, &mip_aiding_pressure_command, command, NULL,
                           NULL, now);
}

#ifdef __cplusplus
}
#endif

#endif
