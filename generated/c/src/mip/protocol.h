/**
 * @file
 * Common to all command sets: function selectors and the acknowledge field.
 */
#ifndef MIP_PROTOCOL_H
#define MIP_PROTOCOL_H

#include "mip/types.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/protocol.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** The operation that a settings command requests. */
enum mip_function_selector MIP_ENUM_8 {
    /** Apply the new setting. */
    MIP_FUNCTION_SELECTOR_WRITE = 1,
    /** Return the current setting in a response. */
    MIP_FUNCTION_SELECTOR_READ = 2,
    /** Save the current setting to non-volatile memory. */
    MIP_FUNCTION_SELECTOR_SAVE = 3,
    /** Load the saved setting. */
    MIP_FUNCTION_SELECTOR_LOAD = 4,
    /** Load the factory default setting. */
    MIP_FUNCTION_SELECTOR_DEFAULT = 5,
    /** Apply the new setting without sending an ACK (5-series devices). */
    MIP_FUNCTION_SELECTOR_APPLY = 6
};

/** Returns the name of an acknowledge code, or NULL. */
MIP_API const char *mip_ack_code_name(uint8_t value);

#ifndef MIP_BARRIER_SET
/** The descriptor set of the barrier command; 0 if the specification names none.
 * If you define it as 0 for the whole library, late replies cannot be recognized. */
#define MIP_BARRIER_SET 0x01
#endif
/** Its descriptor. */
#define MIP_BARRIER_DESCRIPTOR 0x01

/**
 * Acknowledge: response 0xF1.
 *
 * Replies to one command field. A response, if there is one, follows it in the same packet.
 *
 * - 3dm-gx5-15: 2.2.2 Example “Ping” Reply Packet
 * - 3dm-cv7-gnss-ins: Ack/Nack Field Specification
 */
struct mip_protocol_acknowledge {
    /** Descriptor of the acknowledged command. */
    uint8_t command;
    /**
     * 0 (ACK) if the device carried out the command, otherwise the reason why it did not (NACK). A
     * value of enum mip_ack_code.
     */
    uint8_t code;
};

#define MIP_PROTOCOL_ACKNOWLEDGE 0x00F1
#define MIP_PROTOCOL_ACKNOWLEDGE_DESCRIPTOR 0xF1
MIP_FIELD(mip_protocol_acknowledge, 0xF1);

#ifdef __cplusplus
}
#endif

#endif
