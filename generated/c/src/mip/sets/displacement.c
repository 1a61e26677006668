/* Displacement commands. */
#include "mip/displacement.h"
#include "mip/displacement_commands.h"
#include "mip/core/program.h"

static const uint8_t program_get_calibration[] = {
    MIP_END,
};

const struct mip_codec mip_displacement_get_calibration_codec = {
    0x11,
    0x01,
    MIP_COMMAND,
    0,
    sizeof(struct mip_displacement_get_calibration),
    0,
    0,
    program_get_calibration,
    NULL};

static const struct mip_response responses_get_calibration[] = {
    {NULL, 0x81, 0, MIP_NOT_ZERO, false},
};

const struct mip_exchange mip_displacement_get_calibration_exchange = {
    0x11, 0x01, 0, sizeof(responses_get_calibration) / sizeof(responses_get_calibration[0]),
    responses_get_calibration};

const struct mip_command mip_displacement_get_calibration_command = {
    &mip_displacement_get_calibration_codec, &mip_displacement_get_calibration_exchange, false};

static const uint8_t program_get_calibration_response[] = {
    MIP_32_BITS(2, MIP_AT(struct mip_displacement_get_calibration_response, slope)),
    MIP_END,
};

const struct mip_codec mip_displacement_get_calibration_response_codec = {
    0x11,
    0x81,
    MIP_RESPONSE,
    8,
    sizeof(struct mip_displacement_get_calibration_response),
    0,
    MIP_SHAPE(0, 2, 0),
    program_get_calibration_response,
    NULL};

static const uint8_t program_output_rate[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_displacement_output_rate, function)),
    MIP_END,
};

const struct mip_codec mip_displacement_output_rate_codec = {
    0x11, 0x02, MIP_COMMAND,         1,   sizeof(struct mip_displacement_output_rate),
    0,    0,    program_output_rate, NULL};

static const struct mip_response responses_output_rate[] = {
    {NULL, 0x82, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

const struct mip_exchange mip_displacement_output_rate_exchange = {
    0x11, 0x02, 0, sizeof(responses_output_rate) / sizeof(responses_output_rate[0]),
    responses_output_rate};

const struct mip_command mip_displacement_output_rate_command = {
    &mip_displacement_output_rate_codec, &mip_displacement_output_rate_exchange, true};

static const uint8_t program_output_rate_response[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_displacement_output_rate_response, rate)),
    MIP_END,
};

const struct mip_codec mip_displacement_output_rate_response_codec = {
    0x11,
    0x82,
    MIP_RESPONSE,
    4,
    sizeof(struct mip_displacement_output_rate_response),
    0,
    MIP_SHAPE(0, 1, 0),
    program_output_rate_response,
    NULL};

static const uint8_t program_device_time[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_64_BITS(1, MIP_AT(struct mip_displacement_device_time, time)),
    MIP_END,
};

const struct mip_codec mip_displacement_device_time_codec = {
    0x11, 0x04, MIP_COMMAND,         0,           sizeof(struct mip_displacement_device_time),
    0,    0,    program_device_time, &mip_program};

const struct mip_exchange mip_displacement_device_time_exchange = {0x11, 0x04, 0, 0, NULL};

const struct mip_command mip_displacement_device_time_command = {
    &mip_displacement_device_time_codec, &mip_displacement_device_time_exchange, true};
