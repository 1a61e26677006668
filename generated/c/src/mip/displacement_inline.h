/**
 * @file
 * The same as _decode and _encode in mip/displacement.h, but without tables, for speed. Only for
 * fields whose layout never varies.
 */
#ifndef MIP_DISPLACEMENT_INLINE_H
#define MIP_DISPLACEMENT_INLINE_H

#include "mip/displacement.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/displacement_inline.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

static inline mip_error mip_displacement_get_calibration_response_decode_inline(
    struct mip_displacement_get_calibration_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x11, 0x81, 8);
    if (mip_cleared(error, value, sizeof(*value), 8)) {
        return error;
    }
    mip_get_float(&value->slope, field->data);
    mip_get_float(&value->offset, field->data + 4);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_displacement_get_calibration_response_encode_inline(
    const struct mip_displacement_get_calibration_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x11, 0x81, 8, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->slope);
    mip_put_float(data + 4, &value->offset);
    return MIP_OK;
}

static inline mip_error mip_displacement_output_rate_decode_inline(
    struct mip_displacement_output_rate *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x11, 0x02, 1);
    if (mip_cleared(error, value, sizeof(*value), 1)) {
        return error;
    }
    value->function = mip_get_8(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_displacement_output_rate_encode_inline(
    const struct mip_displacement_output_rate *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x11, 0x02, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->function);
    return MIP_OK;
}

static inline mip_error mip_displacement_output_rate_response_decode_inline(
    struct mip_displacement_output_rate_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x11, 0x82, 4);
    if (mip_cleared(error, value, sizeof(*value), 4)) {
        return error;
    }
    value->rate = mip_get_32(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_displacement_output_rate_response_encode_inline(
    const struct mip_displacement_output_rate_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x11, 0x82, 4, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_32(data, value->rate);
    return MIP_OK;
}

#ifdef __cplusplus
}
#endif

#endif
