/**
 * @file
 * The same as _decode and _encode in mip/measurements.h, but without tables, for speed. Only for
 * fields whose layout never varies.
 */
#ifndef MIP_MEASUREMENTS_INLINE_H
#define MIP_MEASUREMENTS_INLINE_H

#include "mip/measurements.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/measurements_inline.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Decodes measurements.accel. On an error the structure is zeroed. */
static inline mip_error mip_measurements_accel_decode_inline(struct mip_measurements_accel *value,
                                                             const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = (set >= 0x80 && set <= 0x81) || set == 0x92
                                ? mip_field_check(field, set, 0x01, 14)
                                : MIP_ERROR_SET;
    if (error != MIP_OK || sizeof(*value) != 14) { /* gaps are zeroed, too */
        memset(value, 0, sizeof(*value));
    }
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->scaled_accel[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

/** Adds measurements.accel to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_measurements_accel_encode_inline(
    const struct mip_measurements_accel *value, struct mip_builder *builder) {
    uint8_t *data;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = (set >= 0x80 && set <= 0x81) || set == 0x92
                                ? mip_builder_reserve(builder, set, 0x01, 14, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->scaled_accel[i]);
    }
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

/** Decodes measurements.numbers. On an error the structure is zeroed. */
static inline mip_error mip_measurements_numbers_decode_inline(
    struct mip_measurements_numbers *value, const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error =
        set == 0x80 || set == 0x92 ? mip_field_check(field, set, 0x02, 44) : MIP_ERROR_SET;
    if (error != MIP_OK || sizeof(*value) != 44) { /* gaps are zeroed, too */
        memset(value, 0, sizeof(*value));
    }
    if (error != MIP_OK) {
        return error;
    }
    value->u8 = mip_get_8(field->data);
    value->u16 = mip_get_16(field->data + 1);
    value->u32 = mip_get_32(field->data + 3);
    value->u64 = mip_get_64(field->data + 7);
    value->s8 = (int8_t)mip_get_8(field->data + 15);
    value->s16 = (int16_t)mip_get_16(field->data + 16);
    value->s32 = (int32_t)mip_get_32(field->data + 18);
    value->s64 = (int64_t)mip_get_64(field->data + 22);
    mip_get_float(&value->float_, field->data + 30);
    mip_get_double(&value->double_, field->data + 34);
    value->bool_ = mip_get_8(field->data + 42);
    value->char_ = (char)mip_get_8(field->data + 43);
    return MIP_OK;
}

/** Adds measurements.numbers to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_measurements_numbers_encode_inline(
    const struct mip_measurements_numbers *value, struct mip_builder *builder) {
    uint8_t *data;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x80 || set == 0x92
                                ? mip_builder_reserve(builder, set, 0x02, 44, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->u8);
    mip_put_16(data + 1, value->u16);
    mip_put_32(data + 3, value->u32);
    mip_put_64(data + 7, value->u64);
    mip_put_8(data + 15, (uint8_t)value->s8);
    mip_put_16(data + 16, (uint16_t)value->s16);
    mip_put_32(data + 18, (uint32_t)value->s32);
    mip_put_64(data + 22, (uint64_t)value->s64);
    mip_put_float(data + 30, &value->float_);
    mip_put_double(data + 34, &value->double_);
    mip_put_8(data + 42, value->bool_);
    mip_put_8(data + 43, (uint8_t)value->char_);
    return MIP_OK;
}

/** Decodes measurements.health. On an error the structure is zeroed. */
static inline mip_error mip_measurements_health_decode_inline(struct mip_measurements_health *value,
                                                              const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error =
        set == 0x80 || set == 0x92 ? mip_field_check(field, set, 0x04, 20) : MIP_ERROR_SET;
    if (error != MIP_OK || sizeof(*value) != 20) { /* gaps are zeroed, too */
        memset(value, 0, sizeof(*value));
    }
    if (error != MIP_OK) {
        return error;
    }
    memcpy(value->result.bytes, field->data, 16);
    value->code = mip_get_32(field->data + 16);
    return MIP_OK;
}

/** Adds measurements.health to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_measurements_health_encode_inline(
    const struct mip_measurements_health *value, struct mip_builder *builder) {
    uint8_t *data;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x80 || set == 0x92
                                ? mip_builder_reserve(builder, set, 0x04, 20, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    memcpy(data, value->result.bytes, 16);
    mip_put_32(data + 16, value->code);
    return MIP_OK;
}

/** Decodes measurements.arrays. On an error the structure is zeroed. */
static inline mip_error mip_measurements_arrays_decode_inline(struct mip_measurements_arrays *value,
                                                              const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error =
        set == 0x80 || set == 0x92 ? mip_field_check(field, set, 0x05, 53) : MIP_ERROR_SET;
    if (error != MIP_OK || sizeof(*value) != 53) { /* gaps are zeroed, too */
        memset(value, 0, sizeof(*value));
    }
    if (error != MIP_OK) {
        return error;
    }
    memcpy(value->modes, field->data, 3);
    for (size_t i = 0; i < 2; i++) {
        value->flags[i] = mip_get_16(field->data + 3 + 2 * i);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->vectors[0][i], field->data + 7 + 4 * i);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->vectors[1][i], field->data + 19 + 4 * i);
    }
    value->points[0].x = (int16_t)mip_get_16(field->data + 31);
    value->points[0].y = (int16_t)mip_get_16(field->data + 33);
    value->points[1].x = (int16_t)mip_get_16(field->data + 35);
    value->points[1].y = (int16_t)mip_get_16(field->data + 37);
    value->track.from.x = (int16_t)mip_get_16(field->data + 39);
    value->track.from.y = (int16_t)mip_get_16(field->data + 41);
    value->track.to.x = (int16_t)mip_get_16(field->data + 43);
    value->track.to.y = (int16_t)mip_get_16(field->data + 45);
    memcpy(value->track.weights, field->data + 47, 2);
    memcpy(value->offsets, field->data + 49, 4);
    return MIP_OK;
}

/** Adds measurements.arrays to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_measurements_arrays_encode_inline(
    const struct mip_measurements_arrays *value, struct mip_builder *builder) {
    uint8_t *data;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x80 || set == 0x92
                                ? mip_builder_reserve(builder, set, 0x05, 53, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    memcpy(data, value->modes, 3);
    for (size_t i = 0; i < 2; i++) {
        mip_put_16(data + 3 + 2 * i, value->flags[i]);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 7 + 4 * i, &value->vectors[0][i]);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 19 + 4 * i, &value->vectors[1][i]);
    }
    mip_put_16(data + 31, (uint16_t)value->points[0].x);
    mip_put_16(data + 33, (uint16_t)value->points[0].y);
    mip_put_16(data + 35, (uint16_t)value->points[1].x);
    mip_put_16(data + 37, (uint16_t)value->points[1].y);
    mip_put_16(data + 39, (uint16_t)value->track.from.x);
    mip_put_16(data + 41, (uint16_t)value->track.from.y);
    mip_put_16(data + 43, (uint16_t)value->track.to.x);
    mip_put_16(data + 45, (uint16_t)value->track.to.y);
    memcpy(data + 47, value->track.weights, 2);
    memcpy(data + 49, value->offsets, 4);
    return MIP_OK;
}

/** Decodes measurements.radio. On an error the structure is zeroed. */
static inline mip_error mip_measurements_radio_decode_inline(struct mip_measurements_radio *value,
                                                             const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error =
        set == 0x80 || set == 0x92 ? mip_field_check(field, set, 0x07, 29) : MIP_ERROR_SET;
    if (error != MIP_OK || sizeof(*value) != 29) { /* gaps are zeroed, too */
        memset(value, 0, sizeof(*value));
    }
    if (error != MIP_OK) {
        return error;
    }
    value->connected = mip_get_8(field->data);
    value->strength = (int32_t)mip_get_32(field->data + 1);
    mip_get_float(&value->noise, field->data + 5);
    mip_get_float(&value->gap, field->data + 9);
    for (size_t i = 0; i < 2; i++) {
        mip_get_double(&value->gaps[i], field->data + 13 + 8 * i);
    }
    return MIP_OK;
}

/** Adds measurements.radio to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_measurements_radio_encode_inline(
    const struct mip_measurements_radio *value, struct mip_builder *builder) {
    uint8_t *data;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x80 || set == 0x92
                                ? mip_builder_reserve(builder, set, 0x07, 29, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->connected);
    mip_put_32(data + 1, (uint32_t)value->strength);
    mip_put_float(data + 5, &value->noise);
    mip_put_float(data + 9, &value->gap);
    for (size_t i = 0; i < 2; i++) {
        mip_put_double(data + 13 + 8 * i, &value->gaps[i]);
    }
    return MIP_OK;
}

/** Decodes measurements.own. On an error the structure is zeroed. */
static inline mip_error mip_measurements_own_decode_inline(struct mip_measurements_own *value,
                                                           const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x81, 0x07, 1);
    if (error != MIP_OK || sizeof(*value) != 1) { /* gaps are zeroed, too */
        memset(value, 0, sizeof(*value));
    }
    if (error != MIP_OK) {
        return error;
    }
    value->mode = mip_get_8(field->data);
    return MIP_OK;
}

/** Adds measurements.own to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_measurements_own_encode_inline(
    const struct mip_measurements_own *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x81, 0x07, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->mode);
    return MIP_OK;
}

/** Decodes measurements.breeze. On an error the structure is zeroed. */
static inline mip_error mip_measurements_breeze_decode_inline(struct mip_measurements_breeze *value,
                                                              const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error =
        set == 0x80 || set == 0x92 ? mip_field_check(field, set, 0x0A, 24) : MIP_ERROR_SET;
    if (error != MIP_OK || sizeof(*value) != 24) { /* gaps are zeroed, too */
        memset(value, 0, sizeof(*value));
    }
    if (error != MIP_OK) {
        return error;
    }
    value->place.x = (int16_t)mip_get_16(field->data);
    value->place.y = (int16_t)mip_get_16(field->data + 2);
    mip_get_float(&value->height, field->data + 4);
    for (size_t i = 0; i < 4; i++) {
        mip_get_float(&value->turn[i], field->data + 8 + 4 * i);
    }
    return MIP_OK;
}

/** Adds measurements.breeze to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_measurements_breeze_encode_inline(
    const struct mip_measurements_breeze *value, struct mip_builder *builder) {
    uint8_t *data;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x80 || set == 0x92
                                ? mip_builder_reserve(builder, set, 0x0A, 24, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_16(data, (uint16_t)value->place.x);
    mip_put_16(data + 2, (uint16_t)value->place.y);
    mip_put_float(data + 4, &value->height);
    for (size_t i = 0; i < 4; i++) {
        mip_put_float(data + 8 + 4 * i, &value->turn[i]);
    }
    return MIP_OK;
}

#ifdef __cplusplus
}
#endif

#endif
