/* The acknowledge field. */
#include "mip/protocol.h"
#include "mip/core/program.h"

static const uint8_t program_acknowledge[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_protocol_acknowledge, command)),
    MIP_END,
};

MIP_CODEC(mip_protocol_acknowledge, 0x00, 0xF1, MIP_RESPONSE, 2, 0, 0, program_acknowledge, NULL);

/* A switch, because every program that reports errors needs these names, and few need the tables of
 * others. */
const char *mip_ack_code_name(uint8_t value) {
    switch (value) {
    case MIP_ACK_CODE_OK:
        return "ok";
    case MIP_ACK_CODE_UNKNOWN_COMMAND:
        return "unknown_command";
    case MIP_ACK_CODE_BAD_CHECKSUM:
        return "bad_checksum";
    case MIP_ACK_CODE_INVALID_PARAMETER:
        return "invalid_parameter";
    case MIP_ACK_CODE_COMMAND_FAILED:
        return "command_failed";
    case MIP_ACK_CODE_COMMAND_TIMEOUT:
        return "command_timeout";
    case MIP_ACK_CODE_UNKNOWN_DESCRIPTOR_SET:
        return "unknown_descriptor_set";
    default:
        return NULL;
    }
}
