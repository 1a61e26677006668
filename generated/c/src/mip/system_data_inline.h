/**
 * @file
 * The same as _decode and _encode in mip/system_data.h, but without tables, for speed. Only for
 * fields whose layout never varies.
 */
#ifndef MIP_SYSTEM_DATA_INLINE_H
#define MIP_SYSTEM_DATA_INLINE_H

#include "mip/system_data.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/system_data_inline.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

static inline mip_error mip_system_data_built_in_test_decode_inline(
    struct mip_system_data_built_in_test *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0xA0, 0x01, 16);
    if (mip_cleared(error, value, sizeof(*value), 16)) {
        return error;
    }
    memcpy(value->result, field->data, 16);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_system_data_built_in_test_encode_inline(
    const struct mip_system_data_built_in_test *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0xA0, 0x01, 16, &data);
    if (error != MIP_OK) {
        return error;
    }
    memcpy(data, value->result, 16);
    return MIP_OK;
}

static inline mip_error mip_system_data_time_sync_status_decode_inline(
    struct mip_system_data_time_sync_status *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0xA0, 0x02, 2);
    if (mip_cleared(error, value, sizeof(*value), 2)) {
        return error;
    }
    value->time_sync = mip_get_8(field->data);
    value->last_pps_received = mip_get_8(field->data + 1);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_system_data_time_sync_status_encode_inline(
    const struct mip_system_data_time_sync_status *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0xA0, 0x02, 2, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->time_sync);
    mip_put_8(data + 1, value->last_pps_received);
    return MIP_OK;
}

static inline mip_error mip_system_data_gpio_state_decode_inline(
    struct mip_system_data_gpio_state *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0xA0, 0x03, 1);
    if (mip_cleared(error, value, sizeof(*value), 1)) {
        return error;
    }
    value->states = mip_get_8(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_system_data_gpio_state_encode_inline(
    const struct mip_system_data_gpio_state *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0xA0, 0x03, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->states);
    return MIP_OK;
}

static inline mip_error mip_system_data_gpio_analog_value_decode_inline(
    struct mip_system_data_gpio_analog_value *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0xA0, 0x04, 5);
    if (mip_cleared(error, value, sizeof(*value), 5)) {
        return error;
    }
    value->gpio_id = mip_get_8(field->data);
    mip_get_float(&value->value, field->data + 1);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_system_data_gpio_analog_value_encode_inline(
    const struct mip_system_data_gpio_analog_value *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0xA0, 0x04, 5, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->gpio_id);
    mip_put_float(data + 1, &value->value);
    return MIP_OK;
}

#ifdef __cplusplus
}
#endif

#endif
