/**
 * @file
 *
 * System (0x7F). Advanced commands of devices that consist of several intelligent parts.
 *
 * The devices that support a field are in mip/extra/profiles.h.
 */
#ifndef MIP_SYSTEM_H
#define MIP_SYSTEM_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/system.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_system System (0x7F)
 * @{ */

/** Descriptor set of these fields. */
#define MIP_SYSTEM_SET 0x7F

/**
 * Protocols of a port.
 *
 * - mip-sdk-4: Interface Control (0x7F,0x02)
 */
typedef uint32_t mip_system_comm_protocols;
/** Bit 0. */
#define MIP_SYSTEM_COMM_PROTOCOLS_MIP UINT32_C(0x00000001)
/** Bit 8. NMEA-0183. */
#define MIP_SYSTEM_COMM_PROTOCOLS_NMEA UINT32_C(0x00000100)
/** Bit 9. RTCM corrections. */
#define MIP_SYSTEM_COMM_PROTOCOLS_RTCM UINT32_C(0x00000200)
/** Bit 24. SPARTN corrections. */
#define MIP_SYSTEM_COMM_PROTOCOLS_SPARTN UINT32_C(0x01000000)
/** Bit 29. SBF, the binary format of Septentrio receivers. */
#define MIP_SYSTEM_COMM_PROTOCOLS_SBF UINT32_C(0x20000000)

/** Part of the device that the host communicates with, and its protocol. */
enum mip_system_protocol_mode MIP_ENUM_8 {
    /** The device itself; the protocol is MIP. */
    MIP_SYSTEM_PROTOCOL_MODE_STANDARD = 1,
    /** The internal inertial sensor; the protocol is MIP. */
    MIP_SYSTEM_PROTOCOL_MODE_SENSOR_DIRECT = 2,
    /** The internal GNSS receiver; the protocols are NMEA and UBX. Requires a receiver. */
    MIP_SYSTEM_PROTOCOL_MODE_GNSS_DIRECT = 3
};

/**
 * Interface control: command (0x7F,0x02).
 *
 * Sets the protocols that a port receives and sends.
 *
 * Functions: write, read, save, load and default. Response: mip_system_interface_control_response.
 *
 * Accepted on the main port only. The main port always keeps MIP in both directions.
 *
 * The change takes effect before the ACK, which is sent on the main port. Bytes that arrive during
 * the change may be lost.
 *
 * The device rejects protocols that it or the port does not support, and settings that need more
 * parsers than it has. A rejected command changes nothing.
 *
 * Replies to an incoming protocol are sent on the same port, even if the protocol is not an
 * outgoing one.
 *
 * Devices differ in how many protocols they receive and send at a time.
 *
 * - mip-sdk-4: Interface control (0x7F,0x02)
 * - 3dm-cv7-gnss-ins: Ports
 */
struct mip_system_interface_control {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Port whose protocols are set or read. A value of enum mip_comm_interface. Uncertain: No
     * source states whether write and read accept `all`.
     */
    uint8_t port;
    /** Protocols that the port receives. Required for write. */
    mip_system_comm_protocols protocols_incoming;
    /** Protocols that the port sends. Required for write. */
    mip_system_comm_protocols protocols_outgoing;
};

#define MIP_SYSTEM_INTERFACE_CONTROL 0x7F02
#define MIP_SYSTEM_INTERFACE_CONTROL_DESCRIPTOR 0x02
MIP_FIELD(mip_system_interface_control, 0x02);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_system_interface_control *mip_system_interface_control_write(
    struct mip_system_interface_control *command, enum mip_comm_interface port,
    mip_system_comm_protocols protocols_incoming, mip_system_comm_protocols protocols_outgoing) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->port = (uint8_t)port;
    command->protocols_incoming = protocols_incoming;
    command->protocols_outgoing = protocols_outgoing;
    return command;
}

/** Fills the structure for `read`, and returns it. */
static inline struct mip_system_interface_control *mip_system_interface_control_read(
    struct mip_system_interface_control *command, enum mip_comm_interface port) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->port = (uint8_t)port;
    return command;
}

/** Fills the structure for `save`, and returns it. */
static inline struct mip_system_interface_control *mip_system_interface_control_save(
    struct mip_system_interface_control *command, enum mip_comm_interface port) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->port = (uint8_t)port;
    return command;
}

/** Fills the structure for `load`, and returns it. */
static inline struct mip_system_interface_control *mip_system_interface_control_load(
    struct mip_system_interface_control *command, enum mip_comm_interface port) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->port = (uint8_t)port;
    return command;
}

/** Fills the structure for `default`, and returns it. */
static inline struct mip_system_interface_control *mip_system_interface_control_default(
    struct mip_system_interface_control *command, enum mip_comm_interface port) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->port = (uint8_t)port;
    return command;
}

/**
 * Interface control response: response (0x7F,0x82).
 *
 * Response to mip_system_interface_control.
 *
 * - mip-sdk-4: Interface control (0x7F,0x02)
 * - 3dm-cv7-gnss-ins: Ports
 */
struct mip_system_interface_control_response {
    /**
     * Port whose protocols are set or read. A value of enum mip_comm_interface. Uncertain: No
     * source states whether write and read accept `all`.
     */
    uint8_t port;
    /** Protocols that the port receives. */
    mip_system_comm_protocols protocols_incoming;
    /** Protocols that the port sends. */
    mip_system_comm_protocols protocols_outgoing;
};

#define MIP_SYSTEM_INTERFACE_CONTROL_RESPONSE 0x7F82
#define MIP_SYSTEM_INTERFACE_CONTROL_RESPONSE_DESCRIPTOR 0x82
MIP_FIELD(mip_system_interface_control_response, 0x82);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_system_interface_control *mip_system_interface_control_write_from(
    struct mip_system_interface_control *command,
    const struct mip_system_interface_control_response *response) {
    return mip_system_interface_control_write(command, (enum mip_comm_interface)response->port,
                                              response->protocols_incoming,
                                              response->protocols_outgoing);
}

/**
 * Communication mode: command (0x7F,0x10).
 *
 * Switches the port between the device and one of its internal sensors.
 *
 * For advanced use. Functions: write, read, save, load and default. Response:
 * mip_system_comm_mode_response.
 *
 * The ACK is sent in the old mode, just before the switch.
 *
 * In a direct mode, the device itself replies only to this command and mip_3dm_device_status.
 *
 * - 3dm-gx5-15: 4.4.1 Communication Mode (0x7F, 0x10)
 */
struct mip_system_comm_mode {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Communication mode. A value of enum mip_system_protocol_mode. Default:
     * MIP_SYSTEM_PROTOCOL_MODE_STANDARD. Required for write. On the 3DM-CV5-15, 3DM-CV5-25,
     * 3DM-CX5-15, 3DM-CX5-25, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX5-15 and 3DM-GX5-25: only
     * MIP_SYSTEM_PROTOCOL_MODE_STANDARD and MIP_SYSTEM_PROTOCOL_MODE_SENSOR_DIRECT. On the
     * 3DM-GX5-35: default MIP_SYSTEM_PROTOCOL_MODE_STANDARD.
     */
    uint8_t mode;
};

#define MIP_SYSTEM_COMM_MODE 0x7F10
#define MIP_SYSTEM_COMM_MODE_DESCRIPTOR 0x10
MIP_FIELD(mip_system_comm_mode, 0x10);
MIP_FILL(mip_system_comm_mode, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_system_comm_mode, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_system_comm_mode, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_system_comm_mode, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_system_comm_mode *mip_system_comm_mode_write(
    struct mip_system_comm_mode *command, enum mip_system_protocol_mode mode) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->mode = (uint8_t)mode;
    return command;
}

/**
 * Communication mode response: response (0x7F,0x90).
 *
 * Response to mip_system_comm_mode.
 *
 * - 3dm-gx5-15: 4.4.1 Communication Mode (0x7F, 0x10)
 */
struct mip_system_comm_mode_response {
    /**
     * Communication mode. A value of enum mip_system_protocol_mode. Default:
     * MIP_SYSTEM_PROTOCOL_MODE_STANDARD.
     */
    uint8_t mode;
};

#define MIP_SYSTEM_COMM_MODE_RESPONSE 0x7F90
#define MIP_SYSTEM_COMM_MODE_RESPONSE_DESCRIPTOR 0x90
MIP_FIELD(mip_system_comm_mode_response, 0x90);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_system_comm_mode *mip_system_comm_mode_write_from(
    struct mip_system_comm_mode *command, const struct mip_system_comm_mode_response *response) {
    return mip_system_comm_mode_write(command, (enum mip_system_protocol_mode)response->mode);
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
