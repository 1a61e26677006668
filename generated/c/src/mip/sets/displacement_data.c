/* Displacement data. */
#include "mip/displacement_data.h"
#include "mip/core/program.h"

static const uint8_t program_displacement_raw[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_displacement_data_displacement_raw, counts)),
    MIP_END,
};

MIP_CODEC(mip_displacement_data_displacement_raw, 0x90, 0x01, MIP_DATA, 4, 0, MIP_SHAPE(0, 1, 0),
          program_displacement_raw, NULL);

static const uint8_t program_displacement[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_displacement_data_displacement, displacement)),
    MIP_END,
};

MIP_CODEC(mip_displacement_data_displacement, 0x90, 0x02, MIP_DATA, 4, 0, MIP_SHAPE(0, 1, 0),
          program_displacement, NULL);

static const uint8_t program_timestamp[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_displacement_data_timestamp, flags)),
    MIP_64_BITS(1, MIP_AT(struct mip_displacement_data_timestamp, time)),
    MIP_END,
};

MIP_CODEC(mip_displacement_data_timestamp, 0x90, 0x04, MIP_DATA, 9, 0, 0, program_timestamp, NULL);
