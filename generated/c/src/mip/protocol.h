/**
 * @file
 * What is the same in every command set: function selectors and the acknowledge field.
 */
#ifndef MIP_PROTOCOL_H
#define MIP_PROTOCOL_H

#include "mip/types.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/protocol.h and mip/constants.h are not of one version"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** What a settings command is asked to do. */
typedef uint8_t mip_function_selector;
/** Apply the new setting. */
#define MIP_FUNCTION_SELECTOR_WRITE 1
/** Send the current setting back in a response. */
#define MIP_FUNCTION_SELECTOR_READ 2
/** Save the current setting to non-volatile memory. */
#define MIP_FUNCTION_SELECTOR_SAVE 3
/** Load the saved setting. */
#define MIP_FUNCTION_SELECTOR_LOAD 4
/** Load the factory default setting. */
#define MIP_FUNCTION_SELECTOR_DEFAULT 5
/** Apply the new setting and send no acknowledge (5-series devices). */
#define MIP_FUNCTION_SELECTOR_APPLY 6

/**
 * Acknowledge: response 0xF1.
 *
 * Answers one command field. A response, if there is one, follows it in the same packet.
 *
 * - 3dm-gx5-15: 2.2.2 Example “Ping” Reply Packet
 * - 3dm-cv7-gnss-ins: Ack/Nack Field Specification
 */
struct mip_protocol_acknowledge {
    /** Descriptor of the command that is answered. */
    uint8_t command;
    /** Zero acknowledges, any other value refuses. */
    mip_ack_code code;
};

#define MIP_PROTOCOL_ACKNOWLEDGE_DESCRIPTOR 0xF1
#define MIP_PROTOCOL_ACKNOWLEDGE_NAME "protocol.acknowledge"

extern const struct mip_codec mip_protocol_acknowledge_codec;
mip_error mip_protocol_acknowledge_decode(struct mip_protocol_acknowledge *value,
                                          const struct mip_field *field);
mip_error mip_protocol_acknowledge_encode(const struct mip_protocol_acknowledge *value,
                                          struct mip_builder *builder);

#ifdef __cplusplus
}
#endif

#endif
