/* Displacement commands. */
#include "mip/displacement.h"
#include "mip/displacement_commands.h"
#include "mip/core/program.h"

static const uint8_t program_get_calibration[] = {
    MIP_END,
};

MIP_CODEC(mip_displacement_get_calibration, 0x11, 0x01, MIP_COMMAND, 0, 0, 0,
          program_get_calibration, NULL);

static const struct mip_response responses_get_calibration[] = {
    {NULL, 0x81, 0, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_displacement_get_calibration, 0x11, 0x01, 0, 1, responses_get_calibration, false);

static const uint8_t program_get_calibration_response[] = {
    MIP_32_BITS(2, MIP_AT(struct mip_displacement_get_calibration_response, slope)),
    MIP_END,
};

MIP_CODEC(mip_displacement_get_calibration_response, 0x11, 0x81, MIP_RESPONSE, 8, 0,
          MIP_SHAPE(0, 2, 0), program_get_calibration_response, NULL);

static const uint8_t program_output_rate[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_displacement_output_rate, function)),
    MIP_END,
};

MIP_CODEC(mip_displacement_output_rate, 0x11, 0x02, MIP_COMMAND, 1, 0, 0, program_output_rate,
          NULL);

static const struct mip_response responses_output_rate[] = {
    {NULL, 0x82, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_displacement_output_rate, 0x11, 0x02, 0, 1, responses_output_rate, true);

static const uint8_t program_output_rate_response[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_displacement_output_rate_response, rate)),
    MIP_END,
};

MIP_CODEC(mip_displacement_output_rate_response, 0x11, 0x82, MIP_RESPONSE, 4, 0, MIP_SHAPE(0, 1, 0),
          program_output_rate_response, NULL);

static const uint8_t program_device_time[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_64_BITS(1, MIP_AT(struct mip_displacement_device_time, time)),
    MIP_END,
};

MIP_CODEC(mip_displacement_device_time, 0x11, 0x04, MIP_COMMAND, 0, 0, 0, program_device_time,
          &mip_program);

MIP_EXCHANGE(mip_displacement_device_time, 0x11, 0x04, 0, 0, NULL, true);
