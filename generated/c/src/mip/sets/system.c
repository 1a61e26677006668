/* System. */
#include "mip/system.h"
#include "mip/system_commands.h"
#include "mip/core/program.h"

static const uint8_t program_interface_control[] = {
    MIP_REQUIRED(5, 3, 1, 1, 1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_system_interface_control, port)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_system_interface_control, protocols_incoming)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_system_interface_control, protocols_outgoing)),
    MIP_END,
};

MIP_CODEC(mip_system_interface_control, 0x7F, 0x02, MIP_COMMAND, 0, 0, 0, program_interface_control,
          &mip_program);

static const struct mip_response responses_interface_control[] = {
    {NULL, 0x82, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_system_interface_control, 0x7F, 0x02, 0, 1, responses_interface_control, true);

static const uint8_t program_interface_control_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_system_interface_control_response, port)),
    MIP_32_BITS(2, MIP_AT(struct mip_system_interface_control_response, protocols_incoming)),
    MIP_END,
};

MIP_CODEC(mip_system_interface_control_response, 0x7F, 0x82, MIP_RESPONSE, 9, 0, 0,
          program_interface_control_response, NULL);

static const uint8_t program_comm_mode[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_system_comm_mode, mode)),
    MIP_END,
};

MIP_CODEC(mip_system_comm_mode, 0x7F, 0x10, MIP_COMMAND, 0, 0, 0, program_comm_mode, &mip_program);

static const struct mip_response responses_comm_mode[] = {
    {NULL, 0x90, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_system_comm_mode, 0x7F, 0x10, 0, 1, responses_comm_mode, true);

static const uint8_t program_comm_mode_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_system_comm_mode_response, mode)),
    MIP_END,
};

MIP_CODEC(mip_system_comm_mode_response, 0x7F, 0x90, MIP_RESPONSE, 1, 0, 0,
          program_comm_mode_response, NULL);
