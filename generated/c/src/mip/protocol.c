/* The acknowledge field. */
#include "mip/protocol.h"
#include "mip/program.h"

static const uint8_t program_acknowledge[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_protocol_acknowledge, command)),
    MIP_END,
};

const struct mip_codec mip_protocol_acknowledge_codec = {
    0x00, 0xF1, MIP_RESPONSE,        2,   sizeof(struct mip_protocol_acknowledge),
    0,    0,    program_acknowledge, NULL};
