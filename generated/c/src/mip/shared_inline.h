/**
 * @file
 * The same as _decode and _encode in mip/shared.h, but without tables, for speed. Only for fields
 * whose layout never varies.
 */
#ifndef MIP_SHARED_INLINE_H
#define MIP_SHARED_INLINE_H

#include "mip/shared.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/shared_inline.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

static inline mip_error mip_shared_event_source_decode_inline(struct mip_shared_event_source *value,
                                                              const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0xFF, 0xD0, 1);
    if (mip_cleared(error, value, sizeof(*value), 1)) {
        return error;
    }
    value->trigger_id = mip_get_8(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_shared_event_source_encode_inline(
    const struct mip_shared_event_source *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0xFF, 0xD0, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->trigger_id);
    return MIP_OK;
}

static inline mip_error mip_shared_ticks_decode_inline(struct mip_shared_ticks *value,
                                                       const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0xFF, 0xD1, 4);
    if (mip_cleared(error, value, sizeof(*value), 4)) {
        return error;
    }
    value->ticks = mip_get_32(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error
mip_shared_ticks_encode_inline(const struct mip_shared_ticks *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0xFF, 0xD1, 4, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_32(data, value->ticks);
    return MIP_OK;
}

static inline mip_error mip_shared_delta_ticks_decode_inline(struct mip_shared_delta_ticks *value,
                                                             const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0xFF, 0xD2, 4);
    if (mip_cleared(error, value, sizeof(*value), 4)) {
        return error;
    }
    value->ticks = mip_get_32(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_shared_delta_ticks_encode_inline(
    const struct mip_shared_delta_ticks *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0xFF, 0xD2, 4, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_32(data, value->ticks);
    return MIP_OK;
}

static inline mip_error mip_shared_gps_timestamp_decode_inline(
    struct mip_shared_gps_timestamp *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0xFF, 0xD3, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    mip_get_double(&value->tow, field->data);
    value->week_number = mip_get_16(field->data + 8);
    value->valid_flags = mip_get_16(field->data + 10);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_shared_gps_timestamp_encode_inline(
    const struct mip_shared_gps_timestamp *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0xFF, 0xD3, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_double(data, &value->tow);
    mip_put_16(data + 8, value->week_number);
    mip_put_16(data + 10, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_shared_delta_time_decode_inline(struct mip_shared_delta_time *value,
                                                            const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0xFF, 0xD4, 8);
    if (mip_cleared(error, value, sizeof(*value), 8)) {
        return error;
    }
    mip_get_double(&value->seconds, field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_shared_delta_time_encode_inline(
    const struct mip_shared_delta_time *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0xFF, 0xD4, 8, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_double(data, &value->seconds);
    return MIP_OK;
}

static inline mip_error mip_shared_reference_timestamp_decode_inline(
    struct mip_shared_reference_timestamp *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0xFF, 0xD5, 8);
    if (mip_cleared(error, value, sizeof(*value), 8)) {
        return error;
    }
    value->nanoseconds = mip_get_64(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_shared_reference_timestamp_encode_inline(
    const struct mip_shared_reference_timestamp *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0xFF, 0xD5, 8, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_64(data, value->nanoseconds);
    return MIP_OK;
}

static inline mip_error mip_shared_reference_time_delta_decode_inline(
    struct mip_shared_reference_time_delta *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0xFF, 0xD6, 8);
    if (mip_cleared(error, value, sizeof(*value), 8)) {
        return error;
    }
    value->dt_nanos = mip_get_64(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_shared_reference_time_delta_encode_inline(
    const struct mip_shared_reference_time_delta *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0xFF, 0xD6, 8, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_64(data, value->dt_nanos);
    return MIP_OK;
}

static inline mip_error mip_shared_external_timestamp_decode_inline(
    struct mip_shared_external_timestamp *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0xFF, 0xD7, 10);
    if (mip_cleared(error, value, sizeof(*value), 10)) {
        return error;
    }
    value->nanoseconds = mip_get_64(field->data);
    value->valid_flags = mip_get_16(field->data + 8);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_shared_external_timestamp_encode_inline(
    const struct mip_shared_external_timestamp *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0xFF, 0xD7, 10, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_64(data, value->nanoseconds);
    mip_put_16(data + 8, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_shared_external_time_delta_decode_inline(
    struct mip_shared_external_time_delta *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0xFF, 0xD8, 10);
    if (mip_cleared(error, value, sizeof(*value), 10)) {
        return error;
    }
    value->dt_nanos = mip_get_64(field->data);
    value->valid_flags = mip_get_16(field->data + 8);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_shared_external_time_delta_encode_inline(
    const struct mip_shared_external_time_delta *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0xFF, 0xD8, 10, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_64(data, value->dt_nanos);
    mip_put_16(data + 8, value->valid_flags);
    return MIP_OK;
}

#ifdef __cplusplus
}
#endif

#endif
