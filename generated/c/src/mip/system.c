/* System. */
#include "mip/system.h"
#include "mip/system_commands.h"
#include "mip/program.h"

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

const struct mip_codec mip_system_interface_control_codec = {
    0x7F,
    0x02,
    MIP_COMMAND,
    0,
    sizeof(struct mip_system_interface_control),
    0,
    false,
    program_interface_control,
    &mip_program};

static bool asked_interface_control_1(const void *value) {
    const struct mip_system_interface_control *v =
        (const struct mip_system_interface_control *)value;
    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_interface_control[] = {
    {&mip_system_interface_control_response_codec, asked_interface_control_1},
    {NULL, NULL},
};

const struct mip_command mip_system_interface_control_command = {
    &mip_system_interface_control_codec, NULL, responses_interface_control, 0};

static const uint8_t program_interface_control_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_system_interface_control_response, port)),
    MIP_32_BITS(2, MIP_AT(struct mip_system_interface_control_response, protocols_incoming)),
    MIP_END,
};

const struct mip_codec mip_system_interface_control_response_codec = {
    0x7F,
    0x82,
    MIP_RESPONSE,
    9,
    sizeof(struct mip_system_interface_control_response),
    0,
    false,
    program_interface_control_response,
    NULL};

static const uint8_t program_comm_mode[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_system_comm_mode, mode)),
    MIP_END,
};

const struct mip_codec mip_system_comm_mode_codec = {
    0x7F, 0x10,  MIP_COMMAND,       0,           sizeof(struct mip_system_comm_mode),
    0,    false, program_comm_mode, &mip_program};

static bool asked_comm_mode_1(const void *value) {
    const struct mip_system_comm_mode *v = (const struct mip_system_comm_mode *)value;
    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_comm_mode[] = {
    {&mip_system_comm_mode_response_codec, asked_comm_mode_1},
    {NULL, NULL},
};

const struct mip_command mip_system_comm_mode_command = {&mip_system_comm_mode_codec, NULL,
                                                         responses_comm_mode, 0};

static const uint8_t program_comm_mode_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_system_comm_mode_response, mode)),
    MIP_END,
};

const struct mip_codec mip_system_comm_mode_response_codec = {
    0x7F,
    0x90,
    MIP_RESPONSE,
    1,
    sizeof(struct mip_system_comm_mode_response),
    0,
    sizeof(struct mip_system_comm_mode_response) >= 8,
    program_comm_mode_response,
    NULL};
