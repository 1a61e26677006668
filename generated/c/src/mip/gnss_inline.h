/**
 * @file
 * The same as _decode and _encode in mip/gnss.h, but without tables, for speed. Only for fields
 * whose layout never varies.
 */
#ifndef MIP_GNSS_INLINE_H
#define MIP_GNSS_INLINE_H

#include "mip/gnss.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/gnss_inline.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

static inline mip_error mip_gnss_signal_config_response_decode_inline(
    struct mip_gnss_signal_config_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0E, 0x82, 8);
    if (mip_cleared(error, value, sizeof(*value), 8)) {
        return error;
    }
    value->gps_enable = mip_get_8(field->data);
    value->glonass_enable = mip_get_8(field->data + 1);
    value->galileo_enable = mip_get_8(field->data + 2);
    value->beidou_enable = mip_get_8(field->data + 3);
    memcpy(value->reserved, field->data + 4, 4);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_signal_config_response_encode_inline(
    const struct mip_gnss_signal_config_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0E, 0x82, 8, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->gps_enable);
    mip_put_8(data + 1, value->glonass_enable);
    mip_put_8(data + 2, value->galileo_enable);
    mip_put_8(data + 3, value->beidou_enable);
    memcpy(data + 4, value->reserved, 4);
    return MIP_OK;
}

static inline mip_error mip_gnss_receiver_reset_decode_inline(struct mip_gnss_receiver_reset *value,
                                                              const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0E, 0x03, 2);
    if (mip_cleared(error, value, sizeof(*value), 2)) {
        return error;
    }
    value->receiver_id = mip_get_8(field->data);
    value->reset_type = mip_get_8(field->data + 1);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_receiver_reset_encode_inline(
    const struct mip_gnss_receiver_reset *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0E, 0x03, 2, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->receiver_id);
    mip_put_8(data + 1, value->reset_type);
    return MIP_OK;
}

static inline mip_error mip_gnss_rtk_config_response_decode_inline(
    struct mip_gnss_rtk_config_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0E, 0x84, 5);
    if (mip_cleared(error, value, sizeof(*value), 5)) {
        return error;
    }
    value->ambiguity_fix_mode = mip_get_8(field->data);
    memcpy(value->reserved, field->data + 1, 4);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_rtk_config_response_encode_inline(
    const struct mip_gnss_rtk_config_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0E, 0x84, 5, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->ambiguity_fix_mode);
    memcpy(data + 1, value->reserved, 4);
    return MIP_OK;
}

static inline mip_error mip_gnss_rtk_dongle_config_response_decode_inline(
    struct mip_gnss_rtk_dongle_config_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0E, 0x90, 4);
    if (mip_cleared(error, value, sizeof(*value), 4)) {
        return error;
    }
    value->enable = mip_get_8(field->data);
    memcpy(value->reserved, field->data + 1, 3);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_rtk_dongle_config_response_encode_inline(
    const struct mip_gnss_rtk_dongle_config_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0E, 0x90, 4, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->enable);
    memcpy(data + 1, value->reserved, 3);
    return MIP_OK;
}

static inline mip_error mip_gnss_spartn_config_response_decode_inline(
    struct mip_gnss_spartn_config_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0E, 0xA0, 78);
    if (mip_cleared(error, value, sizeof(*value), 78)) {
        return error;
    }
    value->enable = mip_get_8(field->data);
    value->type = mip_get_8(field->data + 1);
    value->current_key_tow = mip_get_32(field->data + 2);
    value->current_key_week = mip_get_16(field->data + 6);
    memcpy(value->current_key, field->data + 8, 32);
    value->next_key_tow = mip_get_32(field->data + 40);
    value->next_key_week = mip_get_16(field->data + 44);
    memcpy(value->next_key, field->data + 46, 32);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_spartn_config_response_encode_inline(
    const struct mip_gnss_spartn_config_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0E, 0xA0, 78, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->enable);
    mip_put_8(data + 1, value->type);
    mip_put_32(data + 2, value->current_key_tow);
    mip_put_16(data + 6, value->current_key_week);
    memcpy(data + 8, value->current_key, 32);
    mip_put_32(data + 40, value->next_key_tow);
    mip_put_16(data + 44, value->next_key_week);
    memcpy(data + 46, value->next_key, 32);
    return MIP_OK;
}

static inline mip_error mip_gnss_receiver_safe_mode_decode_inline(
    struct mip_gnss_receiver_safe_mode *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0E, 0x60, 2);
    if (mip_cleared(error, value, sizeof(*value), 2)) {
        return error;
    }
    value->receiver_id = mip_get_8(field->data);
    value->enable = mip_get_8(field->data + 1);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_receiver_safe_mode_encode_inline(
    const struct mip_gnss_receiver_safe_mode *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0E, 0x60, 2, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->receiver_id);
    mip_put_8(data + 1, value->enable);
    return MIP_OK;
}

#ifdef __cplusplus
}
#endif

#endif
