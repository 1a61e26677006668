/**
 * @file
 *
 * System (0x7F). Advanced commands of devices that are built from several intelligent parts.
 */
#ifndef MIP_SYSTEM_H
#define MIP_SYSTEM_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/system.h and mip/constants.h are not of one version"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Descriptor set of these fields. */
#define MIP_SYSTEM_SET 0x7F

/** Which part of the device the host talks to, and in which protocol. */
typedef uint8_t mip_system_protocol_mode;
/** The device itself, MIP. */
#define MIP_SYSTEM_PROTOCOL_MODE_STANDARD 1
/** The inertial sensor inside, MIP. */
#define MIP_SYSTEM_PROTOCOL_MODE_SENSOR_DIRECT 2
/** The GNSS receiver inside, NMEA and UBX; only on models that have one. */
#define MIP_SYSTEM_PROTOCOL_MODE_GNSS_DIRECT 3

/**
 * Communication mode: command (0x7F,0x10).
 *
 * Switches the port between the device and one of the sensors inside it.
 *
 * For advanced use. Functions: write, read, save, load and default. Answered by
 * mip_system_communication_mode_response. Supported by 3DM-GX5-15.
 *
 * The acknowledge is sent in the old mode, just before the switch.
 *
 * In a direct mode only this command and device status (0x0C,0x64) of the device itself are
 * answered.
 *
 * - 3dm-gx5-15: 4.4.1 Communication Mode (0x7F, 0x10)
 */
struct mip_system_communication_mode {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** Communication mode. Default: MIP_SYSTEM_PROTOCOL_MODE_STANDARD. Required for write. */
    mip_system_protocol_mode mode;
};

#define MIP_SYSTEM_COMMUNICATION_MODE_DESCRIPTOR 0x10
#define MIP_SYSTEM_COMMUNICATION_MODE_NAME "system.communication_mode"

extern const struct mip_codec mip_system_communication_mode_codec;
mip_error mip_system_communication_mode_decode(struct mip_system_communication_mode *value,
                                               const struct mip_field *field);
mip_error mip_system_communication_mode_encode(const struct mip_system_communication_mode *value,
                                               struct mip_builder *builder);
/** Apply the new setting. */
struct mip_system_communication_mode
mip_system_communication_mode_write(mip_system_protocol_mode mode);
/** Send the current setting back in a response. */
struct mip_system_communication_mode mip_system_communication_mode_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_system_communication_mode mip_system_communication_mode_save(void);
/** Load the saved setting. */
struct mip_system_communication_mode mip_system_communication_mode_load(void);
/** Load the factory default setting. */
struct mip_system_communication_mode mip_system_communication_mode_default(void);

/**
 * Communication mode response: response (0x7F,0x90).
 *
 * Answers mip_system_communication_mode. Supported by 3DM-GX5-15.
 *
 * - 3dm-gx5-15: 4.4.1 Communication Mode (0x7F, 0x10)
 */
struct mip_system_communication_mode_response {
    /** Communication mode. Default: MIP_SYSTEM_PROTOCOL_MODE_STANDARD. */
    mip_system_protocol_mode mode;
};

#define MIP_SYSTEM_COMMUNICATION_MODE_RESPONSE_DESCRIPTOR 0x90
#define MIP_SYSTEM_COMMUNICATION_MODE_RESPONSE_NAME "system.communication_mode_response"

extern const struct mip_codec mip_system_communication_mode_response_codec;
mip_error mip_system_communication_mode_response_decode(
    struct mip_system_communication_mode_response *value, const struct mip_field *field);
mip_error mip_system_communication_mode_response_encode(
    const struct mip_system_communication_mode_response *value, struct mip_builder *builder);

#ifdef __cplusplus
}
#endif

#endif
