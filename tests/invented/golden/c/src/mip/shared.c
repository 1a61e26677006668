/* Shared. */
#include "mip/shared.h"
#include "mip/program.h"

static const uint8_t program_timestamp[] = {
    MIP_DOUBLES(1, MIP_AT(struct mip_shared_timestamp, tow)),
    MIP_16_BITS(1, MIP_AT(struct mip_shared_timestamp, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_shared_timestamp_codec = {0xFF,
                                                     0xD3,
                                                     MIP_DATA,
                                                     10,
                                                     sizeof(struct mip_shared_timestamp),
                                                     0,
                                                     MIP_SHAPE(1, 0, 1),
                                                     program_timestamp,
                                                     NULL};
