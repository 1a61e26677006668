/**
 * @file
 * The same as _decode and _encode in mip/filter.h, but without tables, for speed. Only for fields
 * whose layout never varies.
 */
#ifndef MIP_FILTER_INLINE_H
#define MIP_FILTER_INLINE_H

#include "mip/filter.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/filter_inline.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

static inline mip_error mip_filter_set_initial_attitude_decode_inline(
    struct mip_filter_set_initial_attitude *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x02, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    mip_get_float(&value->roll, field->data);
    mip_get_float(&value->pitch, field->data + 4);
    mip_get_float(&value->heading, field->data + 8);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_set_initial_attitude_encode_inline(
    const struct mip_filter_set_initial_attitude *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x02, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->roll);
    mip_put_float(data + 4, &value->pitch);
    mip_put_float(data + 8, &value->heading);
    return MIP_OK;
}

static inline mip_error mip_filter_set_initial_heading_decode_inline(
    struct mip_filter_set_initial_heading *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x03, 4);
    if (mip_cleared(error, value, sizeof(*value), 4)) {
        return error;
    }
    mip_get_float(&value->heading, field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_set_initial_heading_encode_inline(
    const struct mip_filter_set_initial_heading *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x03, 4, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->heading);
    return MIP_OK;
}

static inline mip_error mip_filter_set_initial_attitude_from_imu_decode_inline(
    struct mip_filter_set_initial_attitude_from_imu *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x04, 4);
    if (mip_cleared(error, value, sizeof(*value), 4)) {
        return error;
    }
    mip_get_float(&value->declination, field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_set_initial_attitude_from_imu_encode_inline(
    const struct mip_filter_set_initial_attitude_from_imu *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x04, 4, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->declination);
    return MIP_OK;
}

static inline mip_error mip_filter_vehicle_dynamics_mode_response_decode_inline(
    struct mip_filter_vehicle_dynamics_mode_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x80, 1);
    if (mip_cleared(error, value, sizeof(*value), 1)) {
        return error;
    }
    value->mode = mip_get_8(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_vehicle_dynamics_mode_response_encode_inline(
    const struct mip_filter_vehicle_dynamics_mode_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x80, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->mode);
    return MIP_OK;
}

static inline mip_error mip_filter_sensor_to_vehicle_rotation_euler_response_decode_inline(
    struct mip_filter_sensor_to_vehicle_rotation_euler_response *value,
    const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x81, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    mip_get_float(&value->roll, field->data);
    mip_get_float(&value->pitch, field->data + 4);
    mip_get_float(&value->yaw, field->data + 8);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error
mip_filter_sensor_to_vehicle_rotation_euler_response_encode_inline(
    const struct mip_filter_sensor_to_vehicle_rotation_euler_response *value,
    struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x81, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->roll);
    mip_put_float(data + 4, &value->pitch);
    mip_put_float(data + 8, &value->yaw);
    return MIP_OK;
}

static inline mip_error mip_filter_sensor_to_vehicle_offset_response_decode_inline(
    struct mip_filter_sensor_to_vehicle_offset_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x82, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->offset[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_sensor_to_vehicle_offset_response_encode_inline(
    const struct mip_filter_sensor_to_vehicle_offset_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x82, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->offset[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_filter_antenna_offset_response_decode_inline(
    struct mip_filter_antenna_offset_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x83, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->offset[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_antenna_offset_response_encode_inline(
    const struct mip_filter_antenna_offset_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x83, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->offset[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_filter_estimation_control_response_decode_inline(
    struct mip_filter_estimation_control_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x84, 2);
    if (mip_cleared(error, value, sizeof(*value), 2)) {
        return error;
    }
    value->flags = mip_get_16(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_estimation_control_response_encode_inline(
    const struct mip_filter_estimation_control_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x84, 2, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_16(data, value->flags);
    return MIP_OK;
}

static inline mip_error mip_filter_gnss_source_response_decode_inline(
    struct mip_filter_gnss_source_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x86, 1);
    if (mip_cleared(error, value, sizeof(*value), 1)) {
        return error;
    }
    value->source = mip_get_8(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_gnss_source_response_encode_inline(
    const struct mip_filter_gnss_source_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x86, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->source);
    return MIP_OK;
}

static inline mip_error mip_filter_external_gnss_update_decode_inline(
    struct mip_filter_external_gnss_update *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x16, 70);
    if (mip_cleared(error, value, sizeof(*value), 70)) {
        return error;
    }
    mip_get_double(&value->tow, field->data);
    value->week_number = mip_get_16(field->data + 8);
    mip_get_double(&value->latitude, field->data + 10);
    mip_get_double(&value->longitude, field->data + 18);
    mip_get_double(&value->height, field->data + 26);
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->velocity[i], field->data + 34 + 4 * i);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->position_uncertainty[i], field->data + 46 + 4 * i);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->velocity_uncertainty[i], field->data + 58 + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_external_gnss_update_encode_inline(
    const struct mip_filter_external_gnss_update *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x16, 70, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_double(data, &value->tow);
    mip_put_16(data + 8, value->week_number);
    mip_put_double(data + 10, &value->latitude);
    mip_put_double(data + 18, &value->longitude);
    mip_put_double(data + 26, &value->height);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 34 + 4 * i, &value->velocity[i]);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 46 + 4 * i, &value->position_uncertainty[i]);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 58 + 4 * i, &value->velocity_uncertainty[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_filter_external_heading_update_decode_inline(
    struct mip_filter_external_heading_update *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x17, 9);
    if (mip_cleared(error, value, sizeof(*value), 9)) {
        return error;
    }
    mip_get_float(&value->heading, field->data);
    mip_get_float(&value->heading_uncertainty, field->data + 4);
    value->type = mip_get_8(field->data + 8);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_external_heading_update_encode_inline(
    const struct mip_filter_external_heading_update *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x17, 9, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->heading);
    mip_put_float(data + 4, &value->heading_uncertainty);
    mip_put_8(data + 8, value->type);
    return MIP_OK;
}

static inline mip_error mip_filter_heading_source_response_decode_inline(
    struct mip_filter_heading_source_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x87, 1);
    if (mip_cleared(error, value, sizeof(*value), 1)) {
        return error;
    }
    value->source = mip_get_8(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_heading_source_response_encode_inline(
    const struct mip_filter_heading_source_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x87, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->source);
    return MIP_OK;
}

static inline mip_error mip_filter_auto_initialization_control_response_decode_inline(
    struct mip_filter_auto_initialization_control_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x88, 1);
    if (mip_cleared(error, value, sizeof(*value), 1)) {
        return error;
    }
    value->enable = mip_get_8(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_auto_initialization_control_response_encode_inline(
    const struct mip_filter_auto_initialization_control_response *value,
    struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x88, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->enable);
    return MIP_OK;
}

static inline mip_error mip_filter_accel_noise_response_decode_inline(
    struct mip_filter_accel_noise_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x89, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->noise[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_accel_noise_response_encode_inline(
    const struct mip_filter_accel_noise_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x89, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->noise[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_filter_gyro_noise_response_decode_inline(
    struct mip_filter_gyro_noise_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x8A, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->noise[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_gyro_noise_response_encode_inline(
    const struct mip_filter_gyro_noise_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x8A, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->noise[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_filter_accel_bias_model_response_decode_inline(
    struct mip_filter_accel_bias_model_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x8B, 24);
    if (mip_cleared(error, value, sizeof(*value), 24)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->beta[i], field->data + 4 * i);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->noise[i], field->data + 12 + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_accel_bias_model_response_encode_inline(
    const struct mip_filter_accel_bias_model_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x8B, 24, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->beta[i]);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 12 + 4 * i, &value->noise[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_filter_gyro_bias_model_response_decode_inline(
    struct mip_filter_gyro_bias_model_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x8C, 24);
    if (mip_cleared(error, value, sizeof(*value), 24)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->beta[i], field->data + 4 * i);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->noise[i], field->data + 12 + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_gyro_bias_model_response_encode_inline(
    const struct mip_filter_gyro_bias_model_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x8C, 24, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->beta[i]);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 12 + 4 * i, &value->noise[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_filter_auto_zupt_response_decode_inline(
    struct mip_filter_auto_zupt_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x8D, 5);
    if (mip_cleared(error, value, sizeof(*value), 5)) {
        return error;
    }
    value->enable = mip_get_8(field->data);
    mip_get_float(&value->threshold, field->data + 1);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_auto_zupt_response_encode_inline(
    const struct mip_filter_auto_zupt_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x8D, 5, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->enable);
    mip_put_float(data + 1, &value->threshold);
    return MIP_OK;
}

static inline mip_error mip_filter_external_heading_update_with_time_decode_inline(
    struct mip_filter_external_heading_update_with_time *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x1F, 19);
    if (mip_cleared(error, value, sizeof(*value), 19)) {
        return error;
    }
    mip_get_double(&value->tow, field->data);
    value->week_number = mip_get_16(field->data + 8);
    mip_get_float(&value->heading, field->data + 10);
    mip_get_float(&value->heading_uncertainty, field->data + 14);
    value->type = mip_get_8(field->data + 18);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_external_heading_update_with_time_encode_inline(
    const struct mip_filter_external_heading_update_with_time *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x1F, 19, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_double(data, &value->tow);
    mip_put_16(data + 8, value->week_number);
    mip_put_float(data + 10, &value->heading);
    mip_put_float(data + 14, &value->heading_uncertainty);
    mip_put_8(data + 18, value->type);
    return MIP_OK;
}

static inline mip_error mip_filter_auto_angular_zupt_response_decode_inline(
    struct mip_filter_auto_angular_zupt_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x8E, 5);
    if (mip_cleared(error, value, sizeof(*value), 5)) {
        return error;
    }
    value->enable = mip_get_8(field->data);
    mip_get_float(&value->threshold, field->data + 1);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_auto_angular_zupt_response_encode_inline(
    const struct mip_filter_auto_angular_zupt_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x8E, 5, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->enable);
    mip_put_float(data + 1, &value->threshold);
    return MIP_OK;
}

static inline mip_error mip_filter_tare_orientation_response_decode_inline(
    struct mip_filter_tare_orientation_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0xA1, 1);
    if (mip_cleared(error, value, sizeof(*value), 1)) {
        return error;
    }
    value->axes = mip_get_8(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_tare_orientation_response_encode_inline(
    const struct mip_filter_tare_orientation_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0xA1, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->axes);
    return MIP_OK;
}

static inline mip_error mip_filter_reference_position_response_decode_inline(
    struct mip_filter_reference_position_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x90, 25);
    if (mip_cleared(error, value, sizeof(*value), 25)) {
        return error;
    }
    value->enable = mip_get_8(field->data);
    mip_get_double(&value->latitude, field->data + 1);
    mip_get_double(&value->longitude, field->data + 9);
    mip_get_double(&value->altitude, field->data + 17);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_reference_position_response_encode_inline(
    const struct mip_filter_reference_position_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x90, 25, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->enable);
    mip_put_double(data + 1, &value->latitude);
    mip_put_double(data + 9, &value->longitude);
    mip_put_double(data + 17, &value->altitude);
    return MIP_OK;
}

static inline mip_error mip_filter_mag_capture_auto_calibration_decode_inline(
    struct mip_filter_mag_capture_auto_calibration *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x27, 1);
    if (mip_cleared(error, value, sizeof(*value), 1)) {
        return error;
    }
    value->function = mip_get_8(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_mag_capture_auto_calibration_encode_inline(
    const struct mip_filter_mag_capture_auto_calibration *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x27, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->function);
    return MIP_OK;
}

static inline mip_error mip_filter_gravity_noise_response_decode_inline(
    struct mip_filter_gravity_noise_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x93, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->noise[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_gravity_noise_response_encode_inline(
    const struct mip_filter_gravity_noise_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x93, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->noise[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_filter_pressure_altitude_noise_response_decode_inline(
    struct mip_filter_pressure_altitude_noise_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x94, 4);
    if (mip_cleared(error, value, sizeof(*value), 4)) {
        return error;
    }
    mip_get_float(&value->noise, field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_pressure_altitude_noise_response_encode_inline(
    const struct mip_filter_pressure_altitude_noise_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x94, 4, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->noise);
    return MIP_OK;
}

static inline mip_error mip_filter_hard_iron_offset_noise_response_decode_inline(
    struct mip_filter_hard_iron_offset_noise_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x96, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->noise[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_hard_iron_offset_noise_response_encode_inline(
    const struct mip_filter_hard_iron_offset_noise_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x96, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->noise[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_filter_soft_iron_matrix_noise_response_decode_inline(
    struct mip_filter_soft_iron_matrix_noise_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x97, 36);
    if (mip_cleared(error, value, sizeof(*value), 36)) {
        return error;
    }
    for (size_t i = 0; i < 9; i++) {
        mip_get_float(&value->noise[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_soft_iron_matrix_noise_response_encode_inline(
    const struct mip_filter_soft_iron_matrix_noise_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x97, 36, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 9; i++) {
        mip_put_float(data + 4 * i, &value->noise[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_filter_enable_measurements_response_decode_inline(
    struct mip_filter_enable_measurements_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0xB0, 2);
    if (mip_cleared(error, value, sizeof(*value), 2)) {
        return error;
    }
    value->control = mip_get_16(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_enable_measurements_response_encode_inline(
    const struct mip_filter_enable_measurements_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0xB0, 2, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_16(data, value->control);
    return MIP_OK;
}

static inline mip_error mip_filter_mag_noise_response_decode_inline(
    struct mip_filter_mag_noise_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0xB1, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->noise[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_mag_noise_response_encode_inline(
    const struct mip_filter_mag_noise_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0xB1, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->noise[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_filter_magnetic_declination_source_response_decode_inline(
    struct mip_filter_magnetic_declination_source_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0xB2, 5);
    if (mip_cleared(error, value, sizeof(*value), 5)) {
        return error;
    }
    value->source = mip_get_8(field->data);
    mip_get_float(&value->declination, field->data + 1);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_magnetic_declination_source_response_encode_inline(
    const struct mip_filter_magnetic_declination_source_response *value,
    struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0xB2, 5, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->source);
    mip_put_float(data + 1, &value->declination);
    return MIP_OK;
}

static inline mip_error mip_filter_accel_magnitude_adaptive_response_decode_inline(
    struct mip_filter_accel_magnitude_adaptive_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0xB3, 25);
    if (mip_cleared(error, value, sizeof(*value), 25)) {
        return error;
    }
    value->adaptive_measurement = mip_get_8(field->data);
    mip_get_float(&value->frequency, field->data + 1);
    mip_get_float(&value->low_limit, field->data + 5);
    mip_get_float(&value->high_limit, field->data + 9);
    mip_get_float(&value->low_limit_uncertainty, field->data + 13);
    mip_get_float(&value->high_limit_uncertainty, field->data + 17);
    mip_get_float(&value->minimum_uncertainty, field->data + 21);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_accel_magnitude_adaptive_response_encode_inline(
    const struct mip_filter_accel_magnitude_adaptive_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0xB3, 25, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->adaptive_measurement);
    mip_put_float(data + 1, &value->frequency);
    mip_put_float(data + 5, &value->low_limit);
    mip_put_float(data + 9, &value->high_limit);
    mip_put_float(data + 13, &value->low_limit_uncertainty);
    mip_put_float(data + 17, &value->high_limit_uncertainty);
    mip_put_float(data + 21, &value->minimum_uncertainty);
    return MIP_OK;
}

static inline mip_error mip_filter_mag_magnitude_adaptive_response_decode_inline(
    struct mip_filter_mag_magnitude_adaptive_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0xB4, 25);
    if (mip_cleared(error, value, sizeof(*value), 25)) {
        return error;
    }
    value->adaptive_measurement = mip_get_8(field->data);
    mip_get_float(&value->frequency, field->data + 1);
    mip_get_float(&value->low_limit, field->data + 5);
    mip_get_float(&value->high_limit, field->data + 9);
    mip_get_float(&value->low_limit_uncertainty, field->data + 13);
    mip_get_float(&value->high_limit_uncertainty, field->data + 17);
    mip_get_float(&value->minimum_uncertainty, field->data + 21);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_mag_magnitude_adaptive_response_encode_inline(
    const struct mip_filter_mag_magnitude_adaptive_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0xB4, 25, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->adaptive_measurement);
    mip_put_float(data + 1, &value->frequency);
    mip_put_float(data + 5, &value->low_limit);
    mip_put_float(data + 9, &value->high_limit);
    mip_put_float(data + 13, &value->low_limit_uncertainty);
    mip_put_float(data + 17, &value->high_limit_uncertainty);
    mip_put_float(data + 21, &value->minimum_uncertainty);
    return MIP_OK;
}

static inline mip_error mip_filter_mag_dip_angle_adaptive_response_decode_inline(
    struct mip_filter_mag_dip_angle_adaptive_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0xB5, 17);
    if (mip_cleared(error, value, sizeof(*value), 17)) {
        return error;
    }
    value->enable = mip_get_8(field->data);
    mip_get_float(&value->frequency, field->data + 1);
    mip_get_float(&value->high_limit, field->data + 5);
    mip_get_float(&value->high_limit_uncertainty, field->data + 9);
    mip_get_float(&value->minimum_uncertainty, field->data + 13);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_mag_dip_angle_adaptive_response_encode_inline(
    const struct mip_filter_mag_dip_angle_adaptive_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0xB5, 17, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->enable);
    mip_put_float(data + 1, &value->frequency);
    mip_put_float(data + 5, &value->high_limit);
    mip_put_float(data + 9, &value->high_limit_uncertainty);
    mip_put_float(data + 13, &value->minimum_uncertainty);
    return MIP_OK;
}

static inline mip_error mip_filter_altitude_aiding_response_decode_inline(
    struct mip_filter_altitude_aiding_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0xB7, 1);
    if (mip_cleared(error, value, sizeof(*value), 1)) {
        return error;
    }
    value->selector = mip_get_8(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_altitude_aiding_response_encode_inline(
    const struct mip_filter_altitude_aiding_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0xB7, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->selector);
    return MIP_OK;
}

static inline mip_error mip_filter_pitch_roll_aiding_response_decode_inline(
    struct mip_filter_pitch_roll_aiding_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0xBB, 1);
    if (mip_cleared(error, value, sizeof(*value), 1)) {
        return error;
    }
    value->aiding = mip_get_8(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_pitch_roll_aiding_response_encode_inline(
    const struct mip_filter_pitch_roll_aiding_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0xBB, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->aiding);
    return MIP_OK;
}

static inline mip_error mip_filter_magnetic_inclination_source_response_decode_inline(
    struct mip_filter_magnetic_inclination_source_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0xBC, 5);
    if (mip_cleared(error, value, sizeof(*value), 5)) {
        return error;
    }
    value->source = mip_get_8(field->data);
    mip_get_float(&value->inclination, field->data + 1);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_magnetic_inclination_source_response_encode_inline(
    const struct mip_filter_magnetic_inclination_source_response *value,
    struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0xBC, 5, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->source);
    mip_put_float(data + 1, &value->inclination);
    return MIP_OK;
}

static inline mip_error mip_filter_magnetic_magnitude_source_response_decode_inline(
    struct mip_filter_magnetic_magnitude_source_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0xBD, 5);
    if (mip_cleared(error, value, sizeof(*value), 5)) {
        return error;
    }
    value->source = mip_get_8(field->data);
    mip_get_float(&value->magnitude, field->data + 1);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_magnetic_magnitude_source_response_encode_inline(
    const struct mip_filter_magnetic_magnitude_source_response *value,
    struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0xBD, 5, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->source);
    mip_put_float(data + 1, &value->magnitude);
    return MIP_OK;
}

static inline mip_error mip_filter_sensor_to_vehicle_rotation_dcm_response_decode_inline(
    struct mip_filter_sensor_to_vehicle_rotation_dcm_response *value,
    const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0xBE, 36);
    if (mip_cleared(error, value, sizeof(*value), 36)) {
        return error;
    }
    for (size_t i = 0; i < 9; i++) {
        mip_get_float(&value->dcm[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error
mip_filter_sensor_to_vehicle_rotation_dcm_response_encode_inline(
    const struct mip_filter_sensor_to_vehicle_rotation_dcm_response *value,
    struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0xBE, 36, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 9; i++) {
        mip_put_float(data + 4 * i, &value->dcm[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_filter_sensor_to_vehicle_quaternion_response_decode_inline(
    struct mip_filter_sensor_to_vehicle_quaternion_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0xBF, 16);
    if (mip_cleared(error, value, sizeof(*value), 16)) {
        return error;
    }
    for (size_t i = 0; i < 4; i++) {
        mip_get_float(&value->q[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_sensor_to_vehicle_quaternion_response_encode_inline(
    const struct mip_filter_sensor_to_vehicle_quaternion_response *value,
    struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0xBF, 16, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 4; i++) {
        mip_put_float(data + 4 * i, &value->q[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_filter_aiding_measurement_enable_response_decode_inline(
    struct mip_filter_aiding_measurement_enable_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0xD0, 3);
    if (mip_cleared(error, value, sizeof(*value), 3)) {
        return error;
    }
    value->aiding_source = mip_get_16(field->data);
    value->enable = mip_get_8(field->data + 2);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_aiding_measurement_enable_response_encode_inline(
    const struct mip_filter_aiding_measurement_enable_response *value,
    struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0xD0, 3, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_16(data, value->aiding_source);
    mip_put_8(data + 2, value->enable);
    return MIP_OK;
}

static inline mip_error mip_filter_kinematic_constraint_response_decode_inline(
    struct mip_filter_kinematic_constraint_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0xD1, 3);
    if (mip_cleared(error, value, sizeof(*value), 3)) {
        return error;
    }
    value->accel_constraint = mip_get_8(field->data);
    value->velocity_constraint = mip_get_8(field->data + 1);
    value->angular_constraint = mip_get_8(field->data + 2);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_kinematic_constraint_response_encode_inline(
    const struct mip_filter_kinematic_constraint_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0xD1, 3, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->accel_constraint);
    mip_put_8(data + 1, value->velocity_constraint);
    mip_put_8(data + 2, value->angular_constraint);
    return MIP_OK;
}

static inline mip_error mip_filter_initialization_config_response_decode_inline(
    struct mip_filter_initialization_config_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0xD2, 40);
    if (mip_cleared(error, value, sizeof(*value), 40)) {
        return error;
    }
    value->wait_for_run_command = mip_get_8(field->data);
    value->initial_condition_source = mip_get_8(field->data + 1);
    value->auto_heading_alignment_selector = mip_get_8(field->data + 2);
    mip_get_float(&value->initial_heading, field->data + 3);
    mip_get_float(&value->initial_pitch, field->data + 7);
    mip_get_float(&value->initial_roll, field->data + 11);
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->initial_position[i], field->data + 15 + 4 * i);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->initial_velocity[i], field->data + 27 + 4 * i);
    }
    value->reference_frame_selector = mip_get_8(field->data + 39);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_initialization_config_response_encode_inline(
    const struct mip_filter_initialization_config_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0xD2, 40, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->wait_for_run_command);
    mip_put_8(data + 1, value->initial_condition_source);
    mip_put_8(data + 2, value->auto_heading_alignment_selector);
    mip_put_float(data + 3, &value->initial_heading);
    mip_put_float(data + 7, &value->initial_pitch);
    mip_put_float(data + 11, &value->initial_roll);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 15 + 4 * i, &value->initial_position[i]);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 27 + 4 * i, &value->initial_velocity[i]);
    }
    mip_put_8(data + 39, value->reference_frame_selector);
    return MIP_OK;
}

static inline mip_error mip_filter_adaptive_filter_options_response_decode_inline(
    struct mip_filter_adaptive_filter_options_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0xD3, 3);
    if (mip_cleared(error, value, sizeof(*value), 3)) {
        return error;
    }
    value->level = mip_get_8(field->data);
    value->time_limit = mip_get_16(field->data + 1);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_adaptive_filter_options_response_encode_inline(
    const struct mip_filter_adaptive_filter_options_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0xD3, 3, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->level);
    mip_put_16(data + 1, value->time_limit);
    return MIP_OK;
}

static inline mip_error mip_filter_multi_antenna_offset_response_decode_inline(
    struct mip_filter_multi_antenna_offset_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0xD4, 13);
    if (mip_cleared(error, value, sizeof(*value), 13)) {
        return error;
    }
    value->receiver_id = mip_get_8(field->data);
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->antenna_offset[i], field->data + 1 + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_multi_antenna_offset_response_encode_inline(
    const struct mip_filter_multi_antenna_offset_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0xD4, 13, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->receiver_id);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 1 + 4 * i, &value->antenna_offset[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_filter_relative_position_config_response_decode_inline(
    struct mip_filter_relative_position_config_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0xD5, 26);
    if (mip_cleared(error, value, sizeof(*value), 26)) {
        return error;
    }
    value->source = mip_get_8(field->data);
    value->reference_frame_selector = mip_get_8(field->data + 1);
    for (size_t i = 0; i < 3; i++) {
        mip_get_double(&value->reference_coordinates[i], field->data + 2 + 8 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_relative_position_config_response_encode_inline(
    const struct mip_filter_relative_position_config_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0xD5, 26, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->source);
    mip_put_8(data + 1, value->reference_frame_selector);
    for (size_t i = 0; i < 3; i++) {
        mip_put_double(data + 2 + 8 * i, &value->reference_coordinates[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_filter_reference_point_lever_arm_response_decode_inline(
    struct mip_filter_reference_point_lever_arm_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0xD6, 13);
    if (mip_cleared(error, value, sizeof(*value), 13)) {
        return error;
    }
    value->reference_point = mip_get_8(field->data);
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->lever_arm_offset[i], field->data + 1 + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_reference_point_lever_arm_response_encode_inline(
    const struct mip_filter_reference_point_lever_arm_response *value,
    struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0xD6, 13, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->reference_point);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 1 + 4 * i, &value->lever_arm_offset[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_filter_speed_measurement_decode_inline(
    struct mip_filter_speed_measurement *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0x60, 13);
    if (mip_cleared(error, value, sizeof(*value), 13)) {
        return error;
    }
    value->source = mip_get_8(field->data);
    mip_get_float(&value->tow, field->data + 1);
    mip_get_float(&value->speed, field->data + 5);
    mip_get_float(&value->speed_uncertainty, field->data + 9);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_speed_measurement_encode_inline(
    const struct mip_filter_speed_measurement *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0x60, 13, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->source);
    mip_put_float(data + 1, &value->tow);
    mip_put_float(data + 5, &value->speed);
    mip_put_float(data + 9, &value->speed_uncertainty);
    return MIP_OK;
}

static inline mip_error mip_filter_speed_lever_arm_response_decode_inline(
    struct mip_filter_speed_lever_arm_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0xE1, 13);
    if (mip_cleared(error, value, sizeof(*value), 13)) {
        return error;
    }
    value->source = mip_get_8(field->data);
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->lever_arm_offset[i], field->data + 1 + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_speed_lever_arm_response_encode_inline(
    const struct mip_filter_speed_lever_arm_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0xE1, 13, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->source);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 1 + 4 * i, &value->lever_arm_offset[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_filter_vertical_gyro_constraint_control_response_decode_inline(
    struct mip_filter_vertical_gyro_constraint_control_response *value,
    const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0xE2, 1);
    if (mip_cleared(error, value, sizeof(*value), 1)) {
        return error;
    }
    value->enable = mip_get_8(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error
mip_filter_vertical_gyro_constraint_control_response_encode_inline(
    const struct mip_filter_vertical_gyro_constraint_control_response *value,
    struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0xE2, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->enable);
    return MIP_OK;
}

static inline mip_error mip_filter_wheeled_vehicle_constraint_control_response_decode_inline(
    struct mip_filter_wheeled_vehicle_constraint_control_response *value,
    const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0xE3, 1);
    if (mip_cleared(error, value, sizeof(*value), 1)) {
        return error;
    }
    value->enable = mip_get_8(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error
mip_filter_wheeled_vehicle_constraint_control_response_encode_inline(
    const struct mip_filter_wheeled_vehicle_constraint_control_response *value,
    struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0xE3, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->enable);
    return MIP_OK;
}

static inline mip_error mip_filter_gnss_antenna_calibration_control_response_decode_inline(
    struct mip_filter_gnss_antenna_calibration_control_response *value,
    const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0D, 0xE4, 5);
    if (mip_cleared(error, value, sizeof(*value), 5)) {
        return error;
    }
    value->enable = mip_get_8(field->data);
    mip_get_float(&value->max_offset, field->data + 1);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error
mip_filter_gnss_antenna_calibration_control_response_encode_inline(
    const struct mip_filter_gnss_antenna_calibration_control_response *value,
    struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0D, 0xE4, 5, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->enable);
    mip_put_float(data + 1, &value->max_offset);
    return MIP_OK;
}

#ifdef __cplusplus
}
#endif

#endif
