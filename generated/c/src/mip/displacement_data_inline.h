/**
 * @file
 * The same as _decode and _encode in mip/displacement_data.h, but without tables, for speed. Only
 * for fields whose layout never varies.
 */
#ifndef MIP_DISPLACEMENT_DATA_INLINE_H
#define MIP_DISPLACEMENT_DATA_INLINE_H

#include "mip/displacement_data.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/displacement_data_inline.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

static inline mip_error mip_displacement_data_displacement_raw_decode_inline(
    struct mip_displacement_data_displacement_raw *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x90, 0x01, 4);
    if (mip_cleared(error, value, sizeof(*value), 4)) {
        return error;
    }
    value->counts = mip_get_32(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_displacement_data_displacement_raw_encode_inline(
    const struct mip_displacement_data_displacement_raw *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x90, 0x01, 4, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_32(data, value->counts);
    return MIP_OK;
}

static inline mip_error mip_displacement_data_displacement_decode_inline(
    struct mip_displacement_data_displacement *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x90, 0x02, 4);
    if (mip_cleared(error, value, sizeof(*value), 4)) {
        return error;
    }
    mip_get_float(&value->displacement, field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_displacement_data_displacement_encode_inline(
    const struct mip_displacement_data_displacement *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x90, 0x02, 4, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->displacement);
    return MIP_OK;
}

static inline mip_error mip_displacement_data_timestamp_decode_inline(
    struct mip_displacement_data_timestamp *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x90, 0x04, 9);
    if (mip_cleared(error, value, sizeof(*value), 9)) {
        return error;
    }
    value->flags = mip_get_8(field->data);
    value->time = mip_get_64(field->data + 1);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_displacement_data_timestamp_encode_inline(
    const struct mip_displacement_data_timestamp *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x90, 0x04, 9, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->flags);
    mip_put_64(data + 1, value->time);
    return MIP_OK;
}

#ifdef __cplusplus
}
#endif

#endif
