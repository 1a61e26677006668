/* Shared data. */
#include "mip/shared.h"
#include "mip/core/program.h"

static const uint8_t program_event_source[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_shared_event_source, trigger_id)),
    MIP_END,
};

MIP_CODEC(mip_shared_event_source, 0xFF, 0xD0, MIP_DATA, 1, 0, 0, program_event_source, NULL);

static const uint8_t program_ticks[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_shared_ticks, ticks)),
    MIP_END,
};

MIP_CODEC(mip_shared_ticks, 0xFF, 0xD1, MIP_DATA, 4, 0, MIP_SHAPE(0, 1, 0), program_ticks, NULL);

static const uint8_t program_delta_ticks[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_shared_delta_ticks, ticks)),
    MIP_END,
};

MIP_CODEC(mip_shared_delta_ticks, 0xFF, 0xD2, MIP_DATA, 4, 0, MIP_SHAPE(0, 1, 0),
          program_delta_ticks, NULL);

static const uint8_t program_gps_timestamp[] = {
    MIP_DOUBLES(1, MIP_AT(struct mip_shared_gps_timestamp, tow)),
    MIP_16_BITS(2, MIP_AT(struct mip_shared_gps_timestamp, week_number)),
    MIP_END,
};

MIP_CODEC(mip_shared_gps_timestamp, 0xFF, 0xD3, MIP_DATA, 12, 0, MIP_SHAPE(1, 0, 2),
          program_gps_timestamp, NULL);

static const uint8_t program_delta_time[] = {
    MIP_DOUBLES(1, MIP_AT(struct mip_shared_delta_time, seconds)),
    MIP_END,
};

MIP_CODEC(mip_shared_delta_time, 0xFF, 0xD4, MIP_DATA, 8, 0, MIP_SHAPE(1, 0, 0), program_delta_time,
          NULL);

static const uint8_t program_reference_timestamp[] = {
    MIP_64_BITS(1, MIP_AT(struct mip_shared_reference_timestamp, nanoseconds)),
    MIP_END,
};

MIP_CODEC(mip_shared_reference_timestamp, 0xFF, 0xD5, MIP_DATA, 8, 0, MIP_SHAPE(1, 0, 0),
          program_reference_timestamp, NULL);

static const uint8_t program_reference_time_delta[] = {
    MIP_64_BITS(1, MIP_AT(struct mip_shared_reference_time_delta, dt_nanos)),
    MIP_END,
};

MIP_CODEC(mip_shared_reference_time_delta, 0xFF, 0xD6, MIP_DATA, 8, 0, MIP_SHAPE(1, 0, 0),
          program_reference_time_delta, NULL);

static const uint8_t program_external_timestamp[] = {
    MIP_64_BITS(1, MIP_AT(struct mip_shared_external_timestamp, nanoseconds)),
    MIP_16_BITS(1, MIP_AT(struct mip_shared_external_timestamp, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_shared_external_timestamp, 0xFF, 0xD7, MIP_DATA, 10, 0, MIP_SHAPE(1, 0, 1),
          program_external_timestamp, NULL);

static const uint8_t program_external_time_delta[] = {
    MIP_64_BITS(1, MIP_AT(struct mip_shared_external_time_delta, dt_nanos)),
    MIP_16_BITS(1, MIP_AT(struct mip_shared_external_time_delta, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_shared_external_time_delta, 0xFF, 0xD8, MIP_DATA, 10, 0, MIP_SHAPE(1, 0, 1),
          program_external_time_delta, NULL);
