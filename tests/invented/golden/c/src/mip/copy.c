/* Copied measurements. */
#include "mip/copy.h"
#include "mip/program.h"

static const uint8_t program_acc[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_copy_acc, scaled_accel)),
    MIP_16_BITS(1, MIP_AT(struct mip_copy_acc, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_copy_acc_codec = {
    0x92, 0x01, MIP_DATA, 14, sizeof(struct mip_copy_acc), program_acc};

static const uint8_t program_numbers[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_copy_numbers, u8)),
    MIP_16_BITS(1, MIP_AT(struct mip_copy_numbers, u16)),
    MIP_32_BITS(1, MIP_AT(struct mip_copy_numbers, u32)),
    MIP_64_BITS(1, MIP_AT(struct mip_copy_numbers, u64)),
    MIP_8_BITS(1, MIP_AT(struct mip_copy_numbers, s8)),
    MIP_16_BITS(1, MIP_AT(struct mip_copy_numbers, s16)),
    MIP_32_BITS(1, MIP_AT(struct mip_copy_numbers, s32)),
    MIP_64_BITS(1, MIP_AT(struct mip_copy_numbers, s64)),
    MIP_32_BITS(1, MIP_AT(struct mip_copy_numbers, float_)),
    MIP_DOUBLES(1, MIP_AT(struct mip_copy_numbers, double_)),
    MIP_8_BITS(2, MIP_AT(struct mip_copy_numbers, bool_)),
    MIP_END,
};

const struct mip_codec mip_copy_numbers_codec = {
    0x92, 0x02, MIP_DATA, 44, sizeof(struct mip_copy_numbers), program_numbers};

static const uint8_t program_strings[] = {
    MIP_FAR,
    MIP_8_BITS(16, MIP_FAR_AT(struct mip_copy_strings, model)),
    MIP_8_BITS(1, MIP_FAR_AT(struct mip_copy_strings, length)),
    MIP_COUNTED(MIP_SIZE(struct mip_copy_strings, length), 236, 1,
                MIP_FAR_AT(struct mip_copy_strings, length)),
    MIP_8_BITS(1, MIP_FAR_AT(struct mip_copy_strings, name)),
    MIP_REST(236, 1, MIP_FAR_AT(struct mip_copy_strings, rest_count)),
    MIP_8_BITS(1, MIP_FAR_AT(struct mip_copy_strings, rest)),
    MIP_END,
};

const struct mip_codec mip_copy_strings_codec = {
    0x92, 0x03, MIP_DATA, 0, sizeof(struct mip_copy_strings), program_strings};

static const uint8_t program_health[] = {
    MIP_8_BITS(16, MIP_AT(struct mip_copy_health, result)),
    MIP_32_BITS(1, MIP_AT(struct mip_copy_health, code)),
    MIP_END,
};

const struct mip_codec mip_copy_health_codec = {
    0x92, 0x04, MIP_DATA, 20, sizeof(struct mip_copy_health), program_health};

static const uint8_t program_arrays[] = {
    MIP_FAR,
    MIP_8_BITS(3, MIP_FAR_AT(struct mip_copy_arrays, modes)),
    MIP_16_BITS(2, MIP_FAR_AT(struct mip_copy_arrays, flags)),
    MIP_32_BITS(6, MIP_FAR_AT(struct mip_copy_arrays, vectors)),
    MIP_EACH(2, struct mip_point, 4, MIP_FAR_AT(struct mip_copy_arrays, points)),
    MIP_16_BITS(2, MIP_FAR_AT(struct mip_point, x)),
    MIP_END,
    MIP_16_BITS(2, MIP_FAR_AT(struct mip_copy_arrays, track.from.x)),
    MIP_16_BITS(2, MIP_FAR_AT(struct mip_copy_arrays, track.to.x)),
    MIP_8_BITS(2, MIP_FAR_AT(struct mip_copy_arrays, track.weights)),
    MIP_8_BITS(4, MIP_FAR_AT(struct mip_copy_arrays, offsets)),
    MIP_END,
};

const struct mip_codec mip_copy_arrays_codec = {
    0x92, 0x05, MIP_DATA, 0, sizeof(struct mip_copy_arrays), program_arrays};

static const uint8_t program_growing[] = {
    MIP_OPTIONAL(1), MIP_16_BITS(1, MIP_AT(struct mip_copy_growing, first)),
    MIP_GROUP(1),    MIP_16_BITS(1, MIP_AT(struct mip_copy_growing, second)),
    MIP_GROUP(1),    MIP_32_BITS(1, MIP_AT(struct mip_copy_growing, third)),
    MIP_END,
};

const struct mip_codec mip_copy_growing_codec = {
    0x92, 0x06, MIP_DATA, 0, sizeof(struct mip_copy_growing), program_growing};

static const uint8_t program_radio[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_copy_radio, connected)),
    MIP_32_BITS(3, MIP_AT(struct mip_copy_radio, strength)),
    MIP_DOUBLES(2, MIP_AT(struct mip_copy_radio, gaps)),
    MIP_END,
};

const struct mip_codec mip_copy_radio_codec = {
    0x92, 0x07, MIP_DATA, 29, sizeof(struct mip_copy_radio), program_radio};

static const uint8_t program_cloud[] = {
    MIP_FAR,
    MIP_8_BITS(1, MIP_FAR_AT(struct mip_copy_cloud, num_points)),
    MIP_COUNTED(MIP_SIZE(struct mip_copy_cloud, num_points), 61, 4,
                MIP_FAR_AT(struct mip_copy_cloud, num_points)),
    MIP_EACH(1, struct mip_point, 4, MIP_FAR_AT(struct mip_copy_cloud, points)),
    MIP_16_BITS(2, MIP_FAR_AT(struct mip_point, x)),
    MIP_END,
    MIP_64_BITS(1, MIP_FAR_AT(struct mip_copy_cloud, stamp)),
    MIP_END,
};

const struct mip_codec mip_copy_cloud_codec = {
    0x92, 0x08, MIP_DATA, 0, sizeof(struct mip_copy_cloud), program_cloud};

static const uint8_t program_gust[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_copy_gust, station)),
    MIP_16_BITS(2, MIP_AT(struct mip_copy_gust, place.x)),
    MIP_32_BITS(4, MIP_AT(struct mip_copy_gust, height)),
    MIP_CONSTANT(1, 0x07),
    MIP_16_BITS(1, MIP_AT(struct mip_copy_gust, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_copy_gust_codec = {
    0x92, 0x09, MIP_DATA, 0, sizeof(struct mip_copy_gust), program_gust};

static const uint8_t program_breeze[] = {
    MIP_16_BITS(2, MIP_AT(struct mip_copy_breeze, place.x)),
    MIP_32_BITS(5, MIP_AT(struct mip_copy_breeze, height)),
    MIP_END,
};

const struct mip_codec mip_copy_breeze_codec = {
    0x92, 0x0A, MIP_DATA, 24, sizeof(struct mip_copy_breeze), program_breeze};
