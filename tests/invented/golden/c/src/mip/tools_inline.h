/**
 * @file
 * The same as _decode and _encode in mip/tools.h, but without tables, for speed. Only for fields
 * whose layout never varies.
 */
#ifndef MIP_TOOLS_INLINE_H
#define MIP_TOOLS_INLINE_H

#include "mip/tools.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/tools_inline.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Decodes tools.settings_response. On an error the structure is zeroed. */
static inline mip_error mip_tools_settings_response_decode_inline(
    struct mip_tools_settings_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x01, 0x82, 9);
    if (error != MIP_OK || sizeof(*value) != 9) { /* gaps are zeroed, too */
        memset(value, 0, sizeof(*value));
    }
    if (error != MIP_OK) {
        return error;
    }
    value->port = mip_get_8(field->data);
    value->mode = mip_get_8(field->data + 1);
    value->baud = mip_get_32(field->data + 2);
    value->limit = mip_get_16(field->data + 6);
    value->reserved = mip_get_8(field->data + 8);
    return MIP_OK;
}

/** Adds tools.settings_response to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_settings_response_encode_inline(
    const struct mip_tools_settings_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x01, 0x82, 9, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->port);
    mip_put_8(data + 1, value->mode);
    mip_put_32(data + 2, value->baud);
    mip_put_16(data + 6, value->limit);
    mip_put_8(data + 8, value->reserved);
    return MIP_OK;
}

/** Decodes tools.set_time_fast_response. On an error the structure is zeroed. */
static inline mip_error mip_tools_set_time_fast_response_decode_inline(
    struct mip_tools_set_time_fast_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x01, 0x83, 4);
    if (error != MIP_OK || sizeof(*value) != 4) { /* gaps are zeroed, too */
        memset(value, 0, sizeof(*value));
    }
    if (error != MIP_OK) {
        return error;
    }
    value->value = mip_get_32(field->data);
    return MIP_OK;
}

/** Adds tools.set_time_fast_response to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_set_time_fast_response_encode_inline(
    const struct mip_tools_set_time_fast_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x01, 0x83, 4, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_32(data, value->value);
    return MIP_OK;
}

/** Decodes tools.set_time_slow_response. On an error the structure is zeroed. */
static inline mip_error mip_tools_set_time_slow_response_decode_inline(
    struct mip_tools_set_time_slow_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x01, 0x84, 4);
    if (error != MIP_OK || sizeof(*value) != 4) { /* gaps are zeroed, too */
        memset(value, 0, sizeof(*value));
    }
    if (error != MIP_OK) {
        return error;
    }
    value->value = mip_get_32(field->data);
    return MIP_OK;
}

/** Adds tools.set_time_slow_response to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_set_time_slow_response_encode_inline(
    const struct mip_tools_set_time_slow_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x01, 0x84, 4, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_32(data, value->value);
    return MIP_OK;
}

/** Decodes tools.bias_vector. On an error the structure is zeroed. */
static inline mip_error mip_tools_bias_vector_decode_inline(struct mip_tools_bias_vector *value,
                                                            const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x01, 0x9B, 12);
    if (error != MIP_OK || sizeof(*value) != 12) { /* gaps are zeroed, too */
        memset(value, 0, sizeof(*value));
    }
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->bias[i], field->data + 4 * i);
    }
    return MIP_OK;
}

/** Adds tools.bias_vector to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_bias_vector_encode_inline(
    const struct mip_tools_bias_vector *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x01, 0x9B, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->bias[i]);
    }
    return MIP_OK;
}

/** Decodes tools.capture_bias. On an error the structure is zeroed. */
static inline mip_error mip_tools_capture_bias_decode_inline(struct mip_tools_capture_bias *value,
                                                             const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x01, 0x06, 2);
    if (error != MIP_OK || sizeof(*value) != 2) { /* gaps are zeroed, too */
        memset(value, 0, sizeof(*value));
    }
    if (error != MIP_OK) {
        return error;
    }
    value->time = mip_get_16(field->data);
    return MIP_OK;
}

/** Adds tools.capture_bias to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_capture_bias_encode_inline(
    const struct mip_tools_capture_bias *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x01, 0x06, 2, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_16(data, value->time);
    return MIP_OK;
}

/** Decodes tools.pin_response. On an error the structure is zeroed. */
static inline mip_error mip_tools_pin_response_decode_inline(struct mip_tools_pin_response *value,
                                                             const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x01, 0x8B, 2);
    if (error != MIP_OK || sizeof(*value) != 2) { /* gaps are zeroed, too */
        memset(value, 0, sizeof(*value));
    }
    if (error != MIP_OK) {
        return error;
    }
    value->drive = mip_get_8(field->data);
    value->use = mip_get_8(field->data + 1);
    return MIP_OK;
}

/** Adds tools.pin_response to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_pin_response_encode_inline(
    const struct mip_tools_pin_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x01, 0x8B, 2, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->drive);
    mip_put_8(data + 1, value->use);
    return MIP_OK;
}

/** Decodes tools.hello_response. On an error the structure is zeroed. */
static inline mip_error mip_tools_hello_response_decode_inline(
    struct mip_tools_hello_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x01, 0x8C, 4);
    if (error != MIP_OK || sizeof(*value) != 4) { /* gaps are zeroed, too */
        memset(value, 0, sizeof(*value));
    }
    if (error != MIP_OK) {
        return error;
    }
    value->seen = mip_get_32(field->data);
    return MIP_OK;
}

/** Adds tools.hello_response to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_hello_response_encode_inline(
    const struct mip_tools_hello_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x01, 0x8C, 4, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_32(data, value->seen);
    return MIP_OK;
}

/** Decodes tools.readings. On an error the structure is zeroed. */
static inline mip_error mip_tools_readings_decode_inline(struct mip_tools_readings *value,
                                                         const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x01, 0x0D, 1);
    if (error != MIP_OK || sizeof(*value) != 1) { /* gaps are zeroed, too */
        memset(value, 0, sizeof(*value));
    }
    if (error != MIP_OK) {
        return error;
    }
    value->drive = mip_get_8(field->data);
    return MIP_OK;
}

/** Adds tools.readings to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_readings_encode_inline(
    const struct mip_tools_readings *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x01, 0x0D, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->drive);
    return MIP_OK;
}

#ifdef __cplusplus
}
#endif

#endif
