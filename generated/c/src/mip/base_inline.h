/**
 * @file
 * The same as _decode and _encode in mip/base.h, but without tables, for speed. Only for fields
 * whose layout never varies.
 */
#ifndef MIP_BASE_INLINE_H
#define MIP_BASE_INLINE_H

#include "mip/base.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/base_inline.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

static inline mip_error mip_base_get_device_info_response_decode_inline(
    struct mip_base_get_device_info_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x01, 0x81, 82);
    if (mip_cleared(error, value, sizeof(*value), 82)) {
        return error;
    }
    value->device_info.firmware_version = mip_get_16(field->data);
    memcpy(value->device_info.model_name, field->data + 2, 16);
    value->device_info.model_name[16] = '\0';
    memcpy(value->device_info.model_number, field->data + 18, 16);
    value->device_info.model_number[16] = '\0';
    memcpy(value->device_info.serial_number, field->data + 34, 16);
    value->device_info.serial_number[16] = '\0';
    memcpy(value->device_info.lot_number, field->data + 50, 16);
    value->device_info.lot_number[16] = '\0';
    memcpy(value->device_info.device_options, field->data + 66, 16);
    value->device_info.device_options[16] = '\0';
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_base_get_device_info_response_encode_inline(
    const struct mip_base_get_device_info_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x01, 0x81, 82, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_16(data, value->device_info.firmware_version);
    memcpy(data + 2, value->device_info.model_name, 16);
    memcpy(data + 18, value->device_info.model_number, 16);
    memcpy(data + 34, value->device_info.serial_number, 16);
    memcpy(data + 50, value->device_info.lot_number, 16);
    memcpy(data + 66, value->device_info.device_options, 16);
    return MIP_OK;
}

static inline mip_error mip_base_built_in_test_response_decode_inline(
    struct mip_base_built_in_test_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x01, 0x83, 4);
    if (mip_cleared(error, value, sizeof(*value), 4)) {
        return error;
    }
    value->result = mip_get_32(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_base_built_in_test_response_encode_inline(
    const struct mip_base_built_in_test_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x01, 0x83, 4, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_32(data, value->result);
    return MIP_OK;
}

static inline mip_error mip_base_continuous_built_in_test_response_decode_inline(
    struct mip_base_continuous_built_in_test_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x01, 0x88, 16);
    if (mip_cleared(error, value, sizeof(*value), 16)) {
        return error;
    }
    memcpy(value->result, field->data, 16);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_base_continuous_built_in_test_response_encode_inline(
    const struct mip_base_continuous_built_in_test_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x01, 0x88, 16, &data);
    if (error != MIP_OK) {
        return error;
    }
    memcpy(data, value->result, 16);
    return MIP_OK;
}

static inline mip_error mip_base_comm_speed_response_decode_inline(
    struct mip_base_comm_speed_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x01, 0x89, 5);
    if (mip_cleared(error, value, sizeof(*value), 5)) {
        return error;
    }
    value->port = mip_get_8(field->data);
    value->baud = mip_get_32(field->data + 1);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_base_comm_speed_response_encode_inline(
    const struct mip_base_comm_speed_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x01, 0x89, 5, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->port);
    mip_put_32(data + 1, value->baud);
    return MIP_OK;
}

static inline mip_error mip_base_gps_time_update_week_number_response_decode_inline(
    struct mip_base_gps_time_update_week_number_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x01, 0x84, 4);
    if (mip_cleared(error, value, sizeof(*value), 4)) {
        return error;
    }
    value->week_number = mip_get_32(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_base_gps_time_update_week_number_response_encode_inline(
    const struct mip_base_gps_time_update_week_number_response *value,
    struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x01, 0x84, 4, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_32(data, value->week_number);
    return MIP_OK;
}

static inline mip_error mip_base_gps_time_update_tow_response_decode_inline(
    struct mip_base_gps_time_update_tow_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x01, 0x85, 4);
    if (mip_cleared(error, value, sizeof(*value), 4)) {
        return error;
    }
    value->tow = mip_get_32(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_base_gps_time_update_tow_response_encode_inline(
    const struct mip_base_gps_time_update_tow_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x01, 0x85, 4, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_32(data, value->tow);
    return MIP_OK;
}

#ifdef __cplusplus
}
#endif

#endif
