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

/**
 * A port of a device.
 *
 * - mip-sdk-4: Interface Control (0x7F,0x02)
 */
typedef uint8_t mip_system_comm_interface;
/** All ports. */
#define MIP_SYSTEM_COMM_INTERFACE_ALL 0
/** The main port: USB while it is connected, else the main UART. */
#define MIP_SYSTEM_COMM_INTERFACE_MAIN 1
/** The first port that is a UART or can be one. */
#define MIP_SYSTEM_COMM_INTERFACE_UART_1 17
/** The second UART. */
#define MIP_SYSTEM_COMM_INTERFACE_UART_2 18
/** The third UART. */
#define MIP_SYSTEM_COMM_INTERFACE_UART_3 19
/** First virtual serial port of USB. */
#define MIP_SYSTEM_COMM_INTERFACE_USB_1 33
/** Second virtual serial port of USB; on GNSS/INS models, made for NMEA and RTCM. */
#define MIP_SYSTEM_COMM_INTERFACE_USB_2 34

/**
 * Protocols of a port.
 *
 * - mip-sdk-4: Interface Control (0x7F,0x02)
 */
typedef uint32_t mip_system_comm_protocols;
/** Bit 0. MIP. */
#define MIP_SYSTEM_COMM_PROTOCOLS_MIP UINT32_C(0x00000001)
/** Bit 8. NMEA-0183. */
#define MIP_SYSTEM_COMM_PROTOCOLS_NMEA UINT32_C(0x00000100)
/** Bit 9. RTCM corrections. */
#define MIP_SYSTEM_COMM_PROTOCOLS_RTCM UINT32_C(0x00000200)
/** Bit 24. SPARTN corrections. */
#define MIP_SYSTEM_COMM_PROTOCOLS_SPARTN UINT32_C(0x01000000)

/** Which part of the device the host talks to, and in which protocol. */
typedef uint8_t mip_system_protocol_mode;
/** The device itself, MIP. */
#define MIP_SYSTEM_PROTOCOL_MODE_STANDARD 1
/** The inertial sensor inside, MIP. */
#define MIP_SYSTEM_PROTOCOL_MODE_SENSOR_DIRECT 2
/** The GNSS receiver inside, NMEA and UBX; only on models that have one. */
#define MIP_SYSTEM_PROTOCOL_MODE_GNSS_DIRECT 3

/**
 * Interface control: command (0x7F,0x02).
 *
 * Protocols that a port takes in and gives out.
 *
 * Functions: write, read, save, load and default. Answered by
 * mip_system_interface_control_response. May be supported by 3DM-CV7-GNSS/INS.
 *
 * Accepted on the main port only. The main port always keeps MIP in both directions.
 *
 * The acknowledge comes on that port after the change; what arrives meanwhile may be lost.
 *
 * The device refuses protocols that it or the port does not have, and more parsers than it has;
 * then nothing is changed.
 *
 * Answers in an incoming protocol leave by the same port, even if the protocol is not an outgoing
 * one.
 *
 * How many parsers and streams there are depends on the device.
 *
 * - mip-sdk-4: Interface Control (0x7F,0x02)
 * - 3dm-cv7-gnss-ins: Ports
 */
struct mip_system_interface_control {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** The port. Uncertain: Whether write and read take `all`. */
    mip_system_comm_interface port;
    /** Protocols that it takes in. Required for write. */
    mip_system_comm_protocols protocols_incoming;
    /** Protocols that it gives out. Required for write. */
    mip_system_comm_protocols protocols_outgoing;
};

#define MIP_SYSTEM_INTERFACE_CONTROL_DESCRIPTOR 0x02
#define MIP_SYSTEM_INTERFACE_CONTROL_NAME "system.interface_control"

extern const struct mip_codec mip_system_interface_control_codec;
mip_error mip_system_interface_control_decode(struct mip_system_interface_control *value,
                                              const struct mip_field *field);
mip_error mip_system_interface_control_encode(const struct mip_system_interface_control *value,
                                              struct mip_builder *builder);
/** Apply the new setting. */
struct mip_system_interface_control mip_system_interface_control_write(
    mip_system_comm_interface port, mip_system_comm_protocols protocols_incoming,
    mip_system_comm_protocols protocols_outgoing);
/** Send the current setting back in a response. */
struct mip_system_interface_control
mip_system_interface_control_read(mip_system_comm_interface port);
/** Save the current setting to non-volatile memory. */
struct mip_system_interface_control
mip_system_interface_control_save(mip_system_comm_interface port);
/** Load the saved setting. */
struct mip_system_interface_control
mip_system_interface_control_load(mip_system_comm_interface port);
/** Load the factory default setting. */
struct mip_system_interface_control
mip_system_interface_control_default(mip_system_comm_interface port);

/**
 * Interface control response: response (0x7F,0x82).
 *
 * Answers mip_system_interface_control. May be supported by 3DM-CV7-GNSS/INS.
 *
 * - mip-sdk-4: Interface Control (0x7F,0x02)
 * - 3dm-cv7-gnss-ins: Ports
 */
struct mip_system_interface_control_response {
    /** The port. Uncertain: Whether write and read take `all`. */
    mip_system_comm_interface port;
    /** Protocols that it takes in. */
    mip_system_comm_protocols protocols_incoming;
    /** Protocols that it gives out. */
    mip_system_comm_protocols protocols_outgoing;
};

#define MIP_SYSTEM_INTERFACE_CONTROL_RESPONSE_DESCRIPTOR 0x82
#define MIP_SYSTEM_INTERFACE_CONTROL_RESPONSE_NAME "system.interface_control_response"

extern const struct mip_codec mip_system_interface_control_response_codec;
mip_error mip_system_interface_control_response_decode(
    struct mip_system_interface_control_response *value, const struct mip_field *field);
mip_error mip_system_interface_control_response_encode(
    const struct mip_system_interface_control_response *value, struct mip_builder *builder);

/**
 * Communication mode: command (0x7F,0x10).
 *
 * Switches the port between the device and one of the sensors inside it.
 *
 * For advanced use. Functions: write, read, save, load and default. Answered by
 * mip_system_comm_mode_response. Supported by 3DM-GX5-15, 3DM-GX5-35 and 3DM-GX5-45.
 *
 * The acknowledge is sent in the old mode, just before the switch.
 *
 * In a direct mode only this command and mip_3dm_device_status of the device itself are answered.
 *
 * - 3dm-gx5-15: 4.4.1 Communication Mode (0x7F, 0x10)
 */
struct mip_system_comm_mode {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /**
     * Communication mode. Default: MIP_SYSTEM_PROTOCOL_MODE_STANDARD. Required for write. On the
     * 3DM-GX5-35: default MIP_SYSTEM_PROTOCOL_MODE_STANDARD.
     */
    mip_system_protocol_mode mode;
};

#define MIP_SYSTEM_COMM_MODE_DESCRIPTOR 0x10
#define MIP_SYSTEM_COMM_MODE_NAME "system.comm_mode"

extern const struct mip_codec mip_system_comm_mode_codec;
mip_error mip_system_comm_mode_decode(struct mip_system_comm_mode *value,
                                      const struct mip_field *field);
mip_error mip_system_comm_mode_encode(const struct mip_system_comm_mode *value,
                                      struct mip_builder *builder);
/** Apply the new setting. */
struct mip_system_comm_mode mip_system_comm_mode_write(mip_system_protocol_mode mode);
/** Send the current setting back in a response. */
struct mip_system_comm_mode mip_system_comm_mode_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_system_comm_mode mip_system_comm_mode_save(void);
/** Load the saved setting. */
struct mip_system_comm_mode mip_system_comm_mode_load(void);
/** Load the factory default setting. */
struct mip_system_comm_mode mip_system_comm_mode_default(void);

/**
 * Communication mode response: response (0x7F,0x90).
 *
 * Answers mip_system_comm_mode. Supported by 3DM-GX5-15, 3DM-GX5-35 and 3DM-GX5-45.
 *
 * - 3dm-gx5-15: 4.4.1 Communication Mode (0x7F, 0x10)
 */
struct mip_system_comm_mode_response {
    /** Communication mode. Default: MIP_SYSTEM_PROTOCOL_MODE_STANDARD. */
    mip_system_protocol_mode mode;
};

#define MIP_SYSTEM_COMM_MODE_RESPONSE_DESCRIPTOR 0x90
#define MIP_SYSTEM_COMM_MODE_RESPONSE_NAME "system.comm_mode_response"

extern const struct mip_codec mip_system_comm_mode_response_codec;
mip_error mip_system_comm_mode_response_decode(struct mip_system_comm_mode_response *value,
                                               const struct mip_field *field);
mip_error mip_system_comm_mode_response_encode(const struct mip_system_comm_mode_response *value,
                                               struct mip_builder *builder);

#ifdef __cplusplus
}
#endif

#endif
