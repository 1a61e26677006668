/* Measurements. */
#include "mip/measurements.h"
#include "mip/core/program.h"

static const uint8_t program_accel[] = {
    MIP_MORE_SETS(0x81, 0x92),
    MIP_32_BITS(3, MIP_AT(struct mip_measurements_accel, scaled_accel)),
    MIP_16_BITS(1, MIP_AT(struct mip_measurements_accel, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_measurements_accel, 0x80, 0x01, MIP_DATA, 14, 2, MIP_SHAPE(0, 3, 1),
          program_accel + 2, NULL);

static const uint8_t program_numbers[] = {
    MIP_MORE_SETS(0x92),
    MIP_8_BITS(1, MIP_AT(struct mip_measurements_numbers, u8)),
    MIP_16_BITS(1, MIP_AT(struct mip_measurements_numbers, u16)),
    MIP_32_BITS(1, MIP_AT(struct mip_measurements_numbers, u32)),
    MIP_64_BITS(1, MIP_AT(struct mip_measurements_numbers, u64)),
    MIP_8_BITS(1, MIP_AT(struct mip_measurements_numbers, s8)),
    MIP_16_BITS(1, MIP_AT(struct mip_measurements_numbers, s16)),
    MIP_32_BITS(1, MIP_AT(struct mip_measurements_numbers, s32)),
    MIP_64_BITS(1, MIP_AT(struct mip_measurements_numbers, s64)),
    MIP_32_BITS(1, MIP_AT(struct mip_measurements_numbers, float_)),
    MIP_DOUBLES(1, MIP_AT(struct mip_measurements_numbers, double_)),
    MIP_8_BITS(2, MIP_AT(struct mip_measurements_numbers, bool_)),
    MIP_END,
};

MIP_CODEC(mip_measurements_numbers, 0x80, 0x02, MIP_DATA, 44, 1, 0, program_numbers + 1, NULL);

static const uint8_t program_strings[] = {
    MIP_MORE_SETS(0x81, 0x92),
    MIP_FAR,
    MIP_8_BITS(16, MIP_FAR_AT(struct mip_measurements_strings, model)),
    MIP_8_BITS(1, MIP_FAR_AT(struct mip_measurements_strings, length)),
    MIP_COUNTED(MIP_SIZE(struct mip_measurements_strings, length), 236, 1,
                MIP_FAR_AT(struct mip_measurements_strings, length)),
    MIP_8_BITS(1, MIP_FAR_AT(struct mip_measurements_strings, name)),
    MIP_REST(236, 1, MIP_FAR_AT(struct mip_measurements_strings, rest_count)),
    MIP_8_BITS(1, MIP_FAR_AT(struct mip_measurements_strings, rest)),
    MIP_END,
};

MIP_CODEC(mip_measurements_strings, 0x80, 0x03, MIP_DATA, 0, 2, 0, program_strings + 2,
          &mip_program);

static const uint8_t program_health[] = {
    MIP_MORE_SETS(0x92),
    MIP_8_BITS(16, MIP_AT(struct mip_measurements_health, result)),
    MIP_32_BITS(1, MIP_AT(struct mip_measurements_health, code)),
    MIP_END,
};

MIP_CODEC(mip_measurements_health, 0x80, 0x04, MIP_DATA, 20, 1, 0, program_health + 1, NULL);

static const uint8_t program_arrays[] = {
    MIP_MORE_SETS(0x92),
    MIP_FAR,
    MIP_8_BITS(3, MIP_FAR_AT(struct mip_measurements_arrays, modes)),
    MIP_16_BITS(2, MIP_FAR_AT(struct mip_measurements_arrays, flags)),
    MIP_32_BITS(6, MIP_FAR_AT(struct mip_measurements_arrays, vectors)),
    MIP_EACH(2, struct mip_point, 4, MIP_FAR_AT(struct mip_measurements_arrays, points)),
    MIP_16_BITS(2, MIP_FAR_AT(struct mip_point, x)),
    MIP_END,
    MIP_16_BITS(2, MIP_FAR_AT(struct mip_measurements_arrays, track.from.x)),
    MIP_16_BITS(2, MIP_FAR_AT(struct mip_measurements_arrays, track.to.x)),
    MIP_8_BITS(2, MIP_FAR_AT(struct mip_measurements_arrays, track.weights)),
    MIP_8_BITS(4, MIP_FAR_AT(struct mip_measurements_arrays, offsets)),
    MIP_END,
};

MIP_CODEC(mip_measurements_arrays, 0x80, 0x05, MIP_DATA, 0, 1, 0, program_arrays + 1, &mip_program);

static const uint8_t program_growing[] = {
    MIP_MORE_SETS(0x92),
    MIP_OPTIONAL(1),
    MIP_16_BITS(1, MIP_AT(struct mip_measurements_growing, first)),
    MIP_GROUP(1),
    MIP_16_BITS(1, MIP_AT(struct mip_measurements_growing, second)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_measurements_growing, third)),
    MIP_END,
};

MIP_CODEC(mip_measurements_growing, 0x80, 0x06, MIP_DATA, 0, 1, 0, program_growing + 1,
          &mip_program);

static const uint8_t program_radio[] = {
    MIP_MORE_SETS(0x92),
    MIP_8_BITS(1, MIP_AT(struct mip_measurements_radio, connected)),
    MIP_32_BITS(3, MIP_AT(struct mip_measurements_radio, strength)),
    MIP_DOUBLES(2, MIP_AT(struct mip_measurements_radio, gaps)),
    MIP_END,
};

MIP_CODEC(mip_measurements_radio, 0x80, 0x07, MIP_DATA, 29, 1, 0, program_radio + 1, NULL);

static const uint8_t program_own[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_measurements_own, mode)),
    MIP_END,
};

MIP_CODEC(mip_measurements_own, 0x81, 0x07, MIP_DATA, 1, 0, 0, program_own, NULL);

static const uint8_t program_cloud[] = {
    MIP_MORE_SETS(0x92),
    MIP_FAR,
    MIP_8_BITS(1, MIP_FAR_AT(struct mip_measurements_cloud, num_points)),
    MIP_COUNTED(MIP_SIZE(struct mip_measurements_cloud, num_points), 61, 4,
                MIP_FAR_AT(struct mip_measurements_cloud, num_points)),
    MIP_EACH(1, struct mip_point, 4, MIP_FAR_AT(struct mip_measurements_cloud, points)),
    MIP_16_BITS(2, MIP_FAR_AT(struct mip_point, x)),
    MIP_END,
    MIP_64_BITS(1, MIP_FAR_AT(struct mip_measurements_cloud, stamp)),
    MIP_END,
};

MIP_CODEC(mip_measurements_cloud, 0x80, 0x08, MIP_DATA, 0, 1, 0, program_cloud + 1, &mip_program);

static const uint8_t program_gust[] = {
    MIP_MORE_SETS(0x92),
    MIP_8_BITS(1, MIP_AT(struct mip_measurements_gust, station)),
    MIP_16_BITS(2, MIP_AT(struct mip_measurements_gust, place.x)),
    MIP_32_BITS(4, MIP_AT(struct mip_measurements_gust, height)),
    MIP_CONSTANT(1, 0x07),
    MIP_16_BITS(1, MIP_AT(struct mip_measurements_gust, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_measurements_gust, 0x80, 0x09, MIP_DATA, 0, 1, 0, program_gust + 1, &mip_program);

static const uint8_t program_breeze[] = {
    MIP_MORE_SETS(0x92),
    MIP_16_BITS(2, MIP_AT(struct mip_measurements_breeze, place.x)),
    MIP_32_BITS(5, MIP_AT(struct mip_measurements_breeze, height)),
    MIP_END,
};

MIP_CODEC(mip_measurements_breeze, 0x80, 0x0A, MIP_DATA, 24, 1, 0, program_breeze + 1, NULL);
