/**
 * @file
 * The same as _decode and _encode in mip/3dm.h, but without tables, for speed. Only for fields
 * whose layout never varies.
 */
#ifndef MIP_3DM_INLINE_H
#define MIP_3DM_INLINE_H

#include "mip/3dm.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/3dm_inline.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

static inline mip_error mip_3dm_get_imu_base_rate_response_decode_inline(
    struct mip_3dm_get_imu_base_rate_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x83, 2);
    if (mip_cleared(error, value, sizeof(*value), 2)) {
        return error;
    }
    value->rate = mip_get_16(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_get_imu_base_rate_response_encode_inline(
    const struct mip_3dm_get_imu_base_rate_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x83, 2, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_16(data, value->rate);
    return MIP_OK;
}

static inline mip_error mip_3dm_get_gnss_base_rate_response_decode_inline(
    struct mip_3dm_get_gnss_base_rate_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x84, 2);
    if (mip_cleared(error, value, sizeof(*value), 2)) {
        return error;
    }
    value->rate = mip_get_16(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_get_gnss_base_rate_response_encode_inline(
    const struct mip_3dm_get_gnss_base_rate_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x84, 2, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_16(data, value->rate);
    return MIP_OK;
}

static inline mip_error mip_3dm_get_filter_base_rate_response_decode_inline(
    struct mip_3dm_get_filter_base_rate_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x8A, 2);
    if (mip_cleared(error, value, sizeof(*value), 2)) {
        return error;
    }
    value->rate = mip_get_16(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_get_filter_base_rate_response_encode_inline(
    const struct mip_3dm_get_filter_base_rate_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x8A, 2, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_16(data, value->rate);
    return MIP_OK;
}

static inline mip_error mip_3dm_get_base_rate_decode_inline(struct mip_3dm_get_base_rate *value,
                                                            const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x0E, 1);
    if (mip_cleared(error, value, sizeof(*value), 1)) {
        return error;
    }
    value->descriptor_set = mip_get_8(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_get_base_rate_encode_inline(
    const struct mip_3dm_get_base_rate *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x0E, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->descriptor_set);
    return MIP_OK;
}

static inline mip_error mip_3dm_get_base_rate_response_decode_inline(
    struct mip_3dm_get_base_rate_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x8E, 3);
    if (mip_cleared(error, value, sizeof(*value), 3)) {
        return error;
    }
    value->descriptor_set = mip_get_8(field->data);
    value->rate = mip_get_16(field->data + 1);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_get_base_rate_response_encode_inline(
    const struct mip_3dm_get_base_rate_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x8E, 3, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->descriptor_set);
    mip_put_16(data + 1, value->rate);
    return MIP_OK;
}

static inline mip_error mip_3dm_factory_streaming_decode_inline(
    struct mip_3dm_factory_streaming *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x10, 2);
    if (mip_cleared(error, value, sizeof(*value), 2)) {
        return error;
    }
    value->action = mip_get_8(field->data);
    value->reserved = mip_get_8(field->data + 1);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_factory_streaming_encode_inline(
    const struct mip_3dm_factory_streaming *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x10, 2, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->action);
    mip_put_8(data + 1, value->reserved);
    return MIP_OK;
}

static inline mip_error mip_3dm_data_stream_control_response_decode_inline(
    struct mip_3dm_data_stream_control_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x85, 2);
    if (mip_cleared(error, value, sizeof(*value), 2)) {
        return error;
    }
    value->descriptor_set = mip_get_8(field->data);
    value->enabled = mip_get_8(field->data + 1);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_data_stream_control_response_encode_inline(
    const struct mip_3dm_data_stream_control_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x85, 2, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->descriptor_set);
    mip_put_8(data + 1, value->enabled);
    return MIP_OK;
}

static inline mip_error mip_3dm_gnss_assisted_fix_response_decode_inline(
    struct mip_3dm_gnss_assisted_fix_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0xA2, 2);
    if (mip_cleared(error, value, sizeof(*value), 2)) {
        return error;
    }
    value->option = mip_get_8(field->data);
    value->flags = mip_get_8(field->data + 1);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_gnss_assisted_fix_response_encode_inline(
    const struct mip_3dm_gnss_assisted_fix_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0xA2, 2, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->option);
    mip_put_8(data + 1, value->flags);
    return MIP_OK;
}

static inline mip_error mip_3dm_gnss_time_assistance_response_decode_inline(
    struct mip_3dm_gnss_time_assistance_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0xA3, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    mip_get_double(&value->tow, field->data);
    value->week_number = mip_get_16(field->data + 8);
    mip_get_float(&value->accuracy, field->data + 10);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_gnss_time_assistance_response_encode_inline(
    const struct mip_3dm_gnss_time_assistance_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0xA3, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_double(data, &value->tow);
    mip_put_16(data + 8, value->week_number);
    mip_put_float(data + 10, &value->accuracy);
    return MIP_OK;
}

static inline mip_error mip_3dm_pps_source_control_response_decode_inline(
    struct mip_3dm_pps_source_control_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0xA8, 1);
    if (mip_cleared(error, value, sizeof(*value), 1)) {
        return error;
    }
    value->source = mip_get_8(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_pps_source_control_response_encode_inline(
    const struct mip_3dm_pps_source_control_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0xA8, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->source);
    return MIP_OK;
}

static inline mip_error mip_3dm_get_event_support_decode_inline(
    struct mip_3dm_get_event_support *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x2A, 1);
    if (mip_cleared(error, value, sizeof(*value), 1)) {
        return error;
    }
    value->query = mip_get_8(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_get_event_support_encode_inline(
    const struct mip_3dm_get_event_support *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x2A, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->query);
    return MIP_OK;
}

static inline mip_error mip_3dm_event_control_response_decode_inline(
    struct mip_3dm_event_control_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0xB5, 2);
    if (mip_cleared(error, value, sizeof(*value), 2)) {
        return error;
    }
    value->instance = mip_get_8(field->data);
    value->mode = mip_get_8(field->data + 1);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_event_control_response_encode_inline(
    const struct mip_3dm_event_control_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0xB5, 2, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->instance);
    mip_put_8(data + 1, value->mode);
    return MIP_OK;
}

static inline mip_error mip_3dm_device_settings_decode_inline(struct mip_3dm_device_settings *value,
                                                              const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x30, 1);
    if (mip_cleared(error, value, sizeof(*value), 1)) {
        return error;
    }
    value->function = mip_get_8(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_device_settings_encode_inline(
    const struct mip_3dm_device_settings *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x30, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->function);
    return MIP_OK;
}

static inline mip_error mip_3dm_sensor_to_vehicle_transform_euler_response_decode_inline(
    struct mip_3dm_sensor_to_vehicle_transform_euler_response *value,
    const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0xB1, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    mip_get_float(&value->roll, field->data);
    mip_get_float(&value->pitch, field->data + 4);
    mip_get_float(&value->yaw, field->data + 8);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error
mip_3dm_sensor_to_vehicle_transform_euler_response_encode_inline(
    const struct mip_3dm_sensor_to_vehicle_transform_euler_response *value,
    struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0xB1, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->roll);
    mip_put_float(data + 4, &value->pitch);
    mip_put_float(data + 8, &value->yaw);
    return MIP_OK;
}

static inline mip_error mip_3dm_sensor_to_vehicle_transform_quaternion_response_decode_inline(
    struct mip_3dm_sensor_to_vehicle_transform_quaternion_response *value,
    const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0xB2, 16);
    if (mip_cleared(error, value, sizeof(*value), 16)) {
        return error;
    }
    for (size_t i = 0; i < 4; i++) {
        mip_get_float(&value->q[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error
mip_3dm_sensor_to_vehicle_transform_quaternion_response_encode_inline(
    const struct mip_3dm_sensor_to_vehicle_transform_quaternion_response *value,
    struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0xB2, 16, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 4; i++) {
        mip_put_float(data + 4 * i, &value->q[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_3dm_sensor_to_vehicle_transform_dcm_response_decode_inline(
    struct mip_3dm_sensor_to_vehicle_transform_dcm_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0xB3, 36);
    if (mip_cleared(error, value, sizeof(*value), 36)) {
        return error;
    }
    for (size_t i = 0; i < 9; i++) {
        mip_get_float(&value->dcm[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_sensor_to_vehicle_transform_dcm_response_encode_inline(
    const struct mip_3dm_sensor_to_vehicle_transform_dcm_response *value,
    struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0xB3, 36, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 9; i++) {
        mip_put_float(data + 4 * i, &value->dcm[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_3dm_gps_dynamics_mode_response_decode_inline(
    struct mip_3dm_gps_dynamics_mode_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x92, 1);
    if (mip_cleared(error, value, sizeof(*value), 1)) {
        return error;
    }
    value->mode = mip_get_8(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_gps_dynamics_mode_response_encode_inline(
    const struct mip_3dm_gps_dynamics_mode_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x92, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->mode);
    return MIP_OK;
}

static inline mip_error mip_3dm_imu_signal_conditioning_response_decode_inline(
    struct mip_3dm_imu_signal_conditioning_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x86, 13);
    if (mip_cleared(error, value, sizeof(*value), 13)) {
        return error;
    }
    value->orientation_decimation = mip_get_16(field->data);
    value->data_conditioning_flags = mip_get_16(field->data + 2);
    value->inertial_filter_width = mip_get_8(field->data + 4);
    value->mag_filter_width = mip_get_8(field->data + 5);
    value->up_compensation = mip_get_16(field->data + 6);
    value->north_compensation = mip_get_16(field->data + 8);
    value->mag_bandwidth = mip_get_8(field->data + 10);
    value->reserved = mip_get_16(field->data + 11);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_imu_signal_conditioning_response_encode_inline(
    const struct mip_3dm_imu_signal_conditioning_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x86, 13, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_16(data, value->orientation_decimation);
    mip_put_16(data + 2, value->data_conditioning_flags);
    mip_put_8(data + 4, value->inertial_filter_width);
    mip_put_8(data + 5, value->mag_filter_width);
    mip_put_16(data + 6, value->up_compensation);
    mip_put_16(data + 8, value->north_compensation);
    mip_put_8(data + 10, value->mag_bandwidth);
    mip_put_16(data + 11, value->reserved);
    return MIP_OK;
}

static inline mip_error mip_3dm_imu_timestamp_response_decode_inline(
    struct mip_3dm_imu_timestamp_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x93, 5);
    if (mip_cleared(error, value, sizeof(*value), 5)) {
        return error;
    }
    value->selector = mip_get_8(field->data);
    value->time = mip_get_32(field->data + 1);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_imu_timestamp_response_encode_inline(
    const struct mip_3dm_imu_timestamp_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x93, 5, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->selector);
    mip_put_32(data + 1, value->time);
    return MIP_OK;
}

static inline mip_error mip_3dm_accel_bias_response_decode_inline(
    struct mip_3dm_accel_bias_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x9A, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->bias[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_accel_bias_response_encode_inline(
    const struct mip_3dm_accel_bias_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x9A, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->bias[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_3dm_gyro_bias_response_decode_inline(
    struct mip_3dm_gyro_bias_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x9B, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->bias[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_gyro_bias_response_encode_inline(
    const struct mip_3dm_gyro_bias_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x9B, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->bias[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_3dm_capture_gyro_bias_decode_inline(
    struct mip_3dm_capture_gyro_bias *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x39, 2);
    if (mip_cleared(error, value, sizeof(*value), 2)) {
        return error;
    }
    value->averaging_time_ms = mip_get_16(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_capture_gyro_bias_encode_inline(
    const struct mip_3dm_capture_gyro_bias *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x39, 2, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_16(data, value->averaging_time_ms);
    return MIP_OK;
}

static inline mip_error mip_3dm_mag_hard_iron_offset_response_decode_inline(
    struct mip_3dm_mag_hard_iron_offset_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x9C, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->offset[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_mag_hard_iron_offset_response_encode_inline(
    const struct mip_3dm_mag_hard_iron_offset_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x9C, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->offset[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_3dm_mag_soft_iron_matrix_response_decode_inline(
    struct mip_3dm_mag_soft_iron_matrix_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x9D, 36);
    if (mip_cleared(error, value, sizeof(*value), 36)) {
        return error;
    }
    for (size_t i = 0; i < 9; i++) {
        mip_get_float(&value->matrix[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_mag_soft_iron_matrix_response_encode_inline(
    const struct mip_3dm_mag_soft_iron_matrix_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x9D, 36, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 9; i++) {
        mip_put_float(data + 4 * i, &value->matrix[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_3dm_coning_sculling_enable_response_decode_inline(
    struct mip_3dm_coning_sculling_enable_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x9E, 1);
    if (mip_cleared(error, value, sizeof(*value), 1)) {
        return error;
    }
    value->enable = mip_get_8(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_coning_sculling_enable_response_encode_inline(
    const struct mip_3dm_coning_sculling_enable_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x9E, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->enable);
    return MIP_OK;
}

static inline mip_error mip_3dm_uart_baud_rate_response_decode_inline(
    struct mip_3dm_uart_baud_rate_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x87, 4);
    if (mip_cleared(error, value, sizeof(*value), 4)) {
        return error;
    }
    value->baud = mip_get_32(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_uart_baud_rate_response_encode_inline(
    const struct mip_3dm_uart_baud_rate_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x87, 4, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_32(data, value->baud);
    return MIP_OK;
}

static inline mip_error mip_3dm_gpio_config_response_decode_inline(
    struct mip_3dm_gpio_config_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0xC1, 4);
    if (mip_cleared(error, value, sizeof(*value), 4)) {
        return error;
    }
    value->pin = mip_get_8(field->data);
    value->feature = mip_get_8(field->data + 1);
    value->behavior = mip_get_8(field->data + 2);
    value->pin_mode = mip_get_8(field->data + 3);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_gpio_config_response_encode_inline(
    const struct mip_3dm_gpio_config_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0xC1, 4, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->pin);
    mip_put_8(data + 1, value->feature);
    mip_put_8(data + 2, value->behavior);
    mip_put_8(data + 3, value->pin_mode);
    return MIP_OK;
}

static inline mip_error mip_3dm_gpio_state_response_decode_inline(
    struct mip_3dm_gpio_state_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0xC2, 2);
    if (mip_cleared(error, value, sizeof(*value), 2)) {
        return error;
    }
    value->pin = mip_get_8(field->data);
    value->state = mip_get_8(field->data + 1);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_gpio_state_response_encode_inline(
    const struct mip_3dm_gpio_state_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0xC2, 2, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->pin);
    mip_put_8(data + 1, value->state);
    return MIP_OK;
}

static inline mip_error mip_3dm_odometer_config_response_decode_inline(
    struct mip_3dm_odometer_config_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0xC3, 9);
    if (mip_cleared(error, value, sizeof(*value), 9)) {
        return error;
    }
    value->mode = mip_get_8(field->data);
    mip_get_float(&value->scaling, field->data + 1);
    mip_get_float(&value->uncertainty, field->data + 5);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_odometer_config_response_encode_inline(
    const struct mip_3dm_odometer_config_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0xC3, 9, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->mode);
    mip_put_float(data + 1, &value->scaling);
    mip_put_float(data + 5, &value->uncertainty);
    return MIP_OK;
}

static inline mip_error mip_3dm_imu_low_pass_filter_response_decode_inline(
    struct mip_3dm_imu_low_pass_filter_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x8B, 6);
    if (mip_cleared(error, value, sizeof(*value), 6)) {
        return error;
    }
    value->target_descriptor = mip_get_8(field->data);
    value->enable = mip_get_8(field->data + 1);
    value->manual = mip_get_8(field->data + 2);
    value->frequency = mip_get_16(field->data + 3);
    value->reserved = mip_get_8(field->data + 5);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_imu_low_pass_filter_response_encode_inline(
    const struct mip_3dm_imu_low_pass_filter_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x8B, 6, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->target_descriptor);
    mip_put_8(data + 1, value->enable);
    mip_put_8(data + 2, value->manual);
    mip_put_16(data + 3, value->frequency);
    mip_put_8(data + 5, value->reserved);
    return MIP_OK;
}

static inline mip_error mip_3dm_complementary_filter_response_decode_inline(
    struct mip_3dm_complementary_filter_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x97, 10);
    if (mip_cleared(error, value, sizeof(*value), 10)) {
        return error;
    }
    value->pitch_roll_enable = mip_get_8(field->data);
    value->heading_enable = mip_get_8(field->data + 1);
    mip_get_float(&value->pitch_roll_time_constant, field->data + 2);
    mip_get_float(&value->heading_time_constant, field->data + 6);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_complementary_filter_response_encode_inline(
    const struct mip_3dm_complementary_filter_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x97, 10, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->pitch_roll_enable);
    mip_put_8(data + 1, value->heading_enable);
    mip_put_float(data + 2, &value->pitch_roll_time_constant);
    mip_put_float(data + 6, &value->heading_time_constant);
    return MIP_OK;
}

static inline mip_error mip_3dm_sensor_range_response_decode_inline(
    struct mip_3dm_sensor_range_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0xD2, 2);
    if (mip_cleared(error, value, sizeof(*value), 2)) {
        return error;
    }
    value->sensor = mip_get_8(field->data);
    value->setting = mip_get_8(field->data + 1);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_sensor_range_response_encode_inline(
    const struct mip_3dm_sensor_range_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0xD2, 2, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->sensor);
    mip_put_8(data + 1, value->setting);
    return MIP_OK;
}

static inline mip_error mip_3dm_get_calibrated_sensor_ranges_decode_inline(
    struct mip_3dm_get_calibrated_sensor_ranges *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x53, 1);
    if (mip_cleared(error, value, sizeof(*value), 1)) {
        return error;
    }
    value->sensor = mip_get_8(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_get_calibrated_sensor_ranges_encode_inline(
    const struct mip_3dm_get_calibrated_sensor_ranges *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x53, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->sensor);
    return MIP_OK;
}

static inline mip_error mip_3dm_low_pass_filter_response_decode_inline(
    struct mip_3dm_low_pass_filter_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0xD4, 8);
    if (mip_cleared(error, value, sizeof(*value), 8)) {
        return error;
    }
    value->descriptor_set = mip_get_8(field->data);
    value->field_descriptor = mip_get_8(field->data + 1);
    value->enable = mip_get_8(field->data + 2);
    value->manual = mip_get_8(field->data + 3);
    mip_get_float(&value->frequency, field->data + 4);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_low_pass_filter_response_encode_inline(
    const struct mip_3dm_low_pass_filter_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0xD4, 8, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->descriptor_set);
    mip_put_8(data + 1, value->field_descriptor);
    mip_put_8(data + 2, value->enable);
    mip_put_8(data + 3, value->manual);
    mip_put_float(data + 4, &value->frequency);
    return MIP_OK;
}

static inline mip_error mip_3dm_data_stream_format_response_decode_inline(
    struct mip_3dm_data_stream_format_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x88, 2);
    if (mip_cleared(error, value, sizeof(*value), 2)) {
        return error;
    }
    value->stream = mip_get_8(field->data);
    value->format = mip_get_8(field->data + 1);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_data_stream_format_response_encode_inline(
    const struct mip_3dm_data_stream_format_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x88, 2, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->stream);
    mip_put_8(data + 1, value->format);
    return MIP_OK;
}

static inline mip_error mip_3dm_device_power_state_response_decode_inline(
    struct mip_3dm_device_power_state_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x89, 2);
    if (mip_cleared(error, value, sizeof(*value), 2)) {
        return error;
    }
    value->device = mip_get_8(field->data);
    value->state = mip_get_8(field->data + 1);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_device_power_state_response_encode_inline(
    const struct mip_3dm_device_power_state_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x89, 2, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->device);
    mip_put_8(data + 1, value->state);
    return MIP_OK;
}

static inline mip_error mip_3dm_gps_advanced_settings_decode_inline(
    struct mip_3dm_gps_advanced_settings *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x62, 1);
    if (mip_cleared(error, value, sizeof(*value), 1)) {
        return error;
    }
    value->function = mip_get_8(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_gps_advanced_settings_encode_inline(
    const struct mip_3dm_gps_advanced_settings *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x62, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->function);
    return MIP_OK;
}

static inline mip_error mip_3dm_device_status_decode_inline(struct mip_3dm_device_status *value,
                                                            const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x64, 3);
    if (mip_cleared(error, value, sizeof(*value), 3)) {
        return error;
    }
    value->model_number = mip_get_16(field->data);
    value->status_selector = mip_get_8(field->data + 2);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_3dm_device_status_encode_inline(
    const struct mip_3dm_device_status *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x64, 3, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_16(data, value->model_number);
    mip_put_8(data + 2, value->status_selector);
    return MIP_OK;
}

#ifdef __cplusplus
}
#endif

#endif
