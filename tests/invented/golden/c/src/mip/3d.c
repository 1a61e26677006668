/* Awkward names. */
#include "mip/3d.h"
#include "mip/3d_commands.h"
#include "mip/program.h"

static const uint8_t program_default[] = {
    MIP_8_BITS(5, MIP_AT(struct mip_3d_default, class_)),
    MIP_END,
};

const struct mip_codec mip_3d_default_codec = {
    0x0C, 0x10, MIP_COMMAND, 5, sizeof(struct mip_3d_default), 0, 0, program_default, NULL};

const struct mip_exchange mip_3d_default_exchange = {0x0C, 0x10, 0, 0, NULL};

const struct mip_command mip_3d_default_command = {&mip_3d_default_codec, &mip_3d_default_exchange,
                                                   false};
