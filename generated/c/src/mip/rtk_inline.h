/**
 * @file
 * The same as _decode and _encode in mip/rtk.h, but without tables, for speed. Only for fields
 * whose layout never varies.
 */
#ifndef MIP_RTK_INLINE_H
#define MIP_RTK_INLINE_H

#include "mip/rtk.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/rtk_inline.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

static inline mip_error mip_rtk_get_status_flags_response_decode_inline(
    struct mip_rtk_get_status_flags_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0F, 0x81, 4);
    if (mip_cleared(error, value, sizeof(*value), 4)) {
        return error;
    }
    value->flags = mip_get_32(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_rtk_get_status_flags_response_encode_inline(
    const struct mip_rtk_get_status_flags_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0F, 0x81, 4, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_32(data, value->flags);
    return MIP_OK;
}

static inline mip_error mip_rtk_get_imei_response_decode_inline(
    struct mip_rtk_get_imei_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0F, 0x82, 32);
    if (mip_cleared(error, value, sizeof(*value), 32)) {
        return error;
    }
    memcpy(value->imei, field->data, 32);
    value->imei[32] = '\0';
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_rtk_get_imei_response_encode_inline(
    const struct mip_rtk_get_imei_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0F, 0x82, 32, &data);
    if (error != MIP_OK) {
        return error;
    }
    memcpy(data, value->imei, 32);
    return MIP_OK;
}

static inline mip_error mip_rtk_get_imsi_response_decode_inline(
    struct mip_rtk_get_imsi_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0F, 0x83, 32);
    if (mip_cleared(error, value, sizeof(*value), 32)) {
        return error;
    }
    memcpy(value->imsi, field->data, 32);
    value->imsi[32] = '\0';
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_rtk_get_imsi_response_encode_inline(
    const struct mip_rtk_get_imsi_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0F, 0x83, 32, &data);
    if (error != MIP_OK) {
        return error;
    }
    memcpy(data, value->imsi, 32);
    return MIP_OK;
}

static inline mip_error mip_rtk_get_iccid_response_decode_inline(
    struct mip_rtk_get_iccid_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0F, 0x84, 32);
    if (mip_cleared(error, value, sizeof(*value), 32)) {
        return error;
    }
    memcpy(value->iccid, field->data, 32);
    value->iccid[32] = '\0';
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_rtk_get_iccid_response_encode_inline(
    const struct mip_rtk_get_iccid_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0F, 0x84, 32, &data);
    if (error != MIP_OK) {
        return error;
    }
    memcpy(data, value->iccid, 32);
    return MIP_OK;
}

static inline mip_error mip_rtk_get_rssi_response_decode_inline(
    struct mip_rtk_get_rssi_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0F, 0x85, 9);
    if (mip_cleared(error, value, sizeof(*value), 9)) {
        return error;
    }
    value->valid = mip_get_8(field->data);
    value->rssi = (int32_t)mip_get_32(field->data + 1);
    value->signal_quality = (int32_t)mip_get_32(field->data + 5);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_rtk_get_rssi_response_encode_inline(
    const struct mip_rtk_get_rssi_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0F, 0x85, 9, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->valid);
    mip_put_32(data + 1, (uint32_t)value->rssi);
    mip_put_32(data + 5, (uint32_t)value->signal_quality);
    return MIP_OK;
}

static inline mip_error mip_rtk_connected_device_type_response_decode_inline(
    struct mip_rtk_connected_device_type_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0F, 0x86, 1);
    if (mip_cleared(error, value, sizeof(*value), 1)) {
        return error;
    }
    value->device_type = mip_get_8(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_rtk_connected_device_type_response_encode_inline(
    const struct mip_rtk_connected_device_type_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0F, 0x86, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->device_type);
    return MIP_OK;
}

static inline mip_error mip_rtk_get_activation_code_response_decode_inline(
    struct mip_rtk_get_activation_code_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0F, 0x87, 32);
    if (mip_cleared(error, value, sizeof(*value), 32)) {
        return error;
    }
    memcpy(value->activation_code, field->data, 32);
    value->activation_code[32] = '\0';
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_rtk_get_activation_code_response_encode_inline(
    const struct mip_rtk_get_activation_code_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0F, 0x87, 32, &data);
    if (error != MIP_OK) {
        return error;
    }
    memcpy(data, value->activation_code, 32);
    return MIP_OK;
}

static inline mip_error mip_rtk_get_modem_firmware_version_response_decode_inline(
    struct mip_rtk_get_modem_firmware_version_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0F, 0x88, 32);
    if (mip_cleared(error, value, sizeof(*value), 32)) {
        return error;
    }
    memcpy(value->modem_firmware_version, field->data, 32);
    value->modem_firmware_version[32] = '\0';
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_rtk_get_modem_firmware_version_response_encode_inline(
    const struct mip_rtk_get_modem_firmware_version_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0F, 0x88, 32, &data);
    if (error != MIP_OK) {
        return error;
    }
    memcpy(data, value->modem_firmware_version, 32);
    return MIP_OK;
}

static inline mip_error mip_rtk_service_status_decode_inline(struct mip_rtk_service_status *value,
                                                             const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0F, 0x0A, 8);
    if (mip_cleared(error, value, sizeof(*value), 8)) {
        return error;
    }
    value->reserved1 = mip_get_32(field->data);
    value->reserved2 = mip_get_32(field->data + 4);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_rtk_service_status_encode_inline(
    const struct mip_rtk_service_status *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0F, 0x0A, 8, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_32(data, value->reserved1);
    mip_put_32(data + 4, value->reserved2);
    return MIP_OK;
}

static inline mip_error mip_rtk_service_status_response_decode_inline(
    struct mip_rtk_service_status_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0F, 0x8A, 17);
    if (mip_cleared(error, value, sizeof(*value), 17)) {
        return error;
    }
    value->flags = mip_get_8(field->data);
    value->received_bytes = mip_get_32(field->data + 1);
    value->last_bytes = mip_get_32(field->data + 5);
    value->last_bytes_time = mip_get_64(field->data + 9);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_rtk_service_status_response_encode_inline(
    const struct mip_rtk_service_status_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0F, 0x8A, 17, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->flags);
    mip_put_32(data + 1, value->received_bytes);
    mip_put_32(data + 5, value->last_bytes);
    mip_put_64(data + 9, value->last_bytes_time);
    return MIP_OK;
}

static inline mip_error mip_rtk_erase_storage_decode_inline(struct mip_rtk_erase_storage *value,
                                                            const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0F, 0x20, 1);
    if (mip_cleared(error, value, sizeof(*value), 1)) {
        return error;
    }
    value->media = mip_get_8(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_rtk_erase_storage_encode_inline(
    const struct mip_rtk_erase_storage *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0F, 0x20, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->media);
    return MIP_OK;
}

static inline mip_error mip_rtk_led_control_decode_inline(struct mip_rtk_led_control *value,
                                                          const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0F, 0x21, 11);
    if (mip_cleared(error, value, sizeof(*value), 11)) {
        return error;
    }
    memcpy(value->primary_color, field->data, 3);
    memcpy(value->alternate_color, field->data + 3, 3);
    value->action = mip_get_8(field->data + 6);
    value->period = mip_get_32(field->data + 7);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_rtk_led_control_encode_inline(
    const struct mip_rtk_led_control *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0F, 0x21, 11, &data);
    if (error != MIP_OK) {
        return error;
    }
    memcpy(data, value->primary_color, 3);
    memcpy(data + 3, value->alternate_color, 3);
    mip_put_8(data + 6, value->action);
    mip_put_32(data + 7, value->period);
    return MIP_OK;
}

#ifdef __cplusplus
}
#endif

#endif
