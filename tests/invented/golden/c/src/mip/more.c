/* More measurements. */
#include "mip/more.h"
#include "mip/program.h"

static const uint8_t program_accel[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_more_accel, scaled_accel)),
    MIP_16_BITS(1, MIP_AT(struct mip_more_accel, valid_flags)),
    MIP_END,
};

const struct mip_codec mip_more_accel_codec = {
    0x81, 0x01, MIP_DATA, 14, sizeof(struct mip_more_accel), program_accel};

static const uint8_t program_strings[] = {
    MIP_FAR,
    MIP_8_BITS(16, MIP_FAR_AT(struct mip_more_strings, model)),
    MIP_8_BITS(1, MIP_FAR_AT(struct mip_more_strings, length)),
    MIP_COUNTED(MIP_SIZE(struct mip_more_strings, length), 236, 1,
                MIP_FAR_AT(struct mip_more_strings, length)),
    MIP_8_BITS(1, MIP_FAR_AT(struct mip_more_strings, name)),
    MIP_REST(236, 1, MIP_FAR_AT(struct mip_more_strings, rest_count)),
    MIP_8_BITS(1, MIP_FAR_AT(struct mip_more_strings, rest)),
    MIP_END,
};

const struct mip_codec mip_more_strings_codec = {
    0x81, 0x03, MIP_DATA, 0, sizeof(struct mip_more_strings), program_strings};

static const uint8_t program_own[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_more_own, mode)),
    MIP_END,
};

const struct mip_codec mip_more_own_codec = {
    0x81, 0x07, MIP_DATA, 1, sizeof(struct mip_more_own), program_own};
