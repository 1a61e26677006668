/**
 * @file
 * The same as _decode and _encode in mip/sensor.h, but without tables, for speed. Only for fields
 * whose layout never varies.
 */
#ifndef MIP_SENSOR_INLINE_H
#define MIP_SENSOR_INLINE_H

#include "mip/sensor.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/sensor_inline.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

static inline mip_error mip_sensor_raw_accel_decode_inline(struct mip_sensor_raw_accel *value,
                                                           const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x80, 0x01, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->raw_accel[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_sensor_raw_accel_encode_inline(
    const struct mip_sensor_raw_accel *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x80, 0x01, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->raw_accel[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_sensor_raw_gyro_decode_inline(struct mip_sensor_raw_gyro *value,
                                                          const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x80, 0x02, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->raw_gyro[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_sensor_raw_gyro_encode_inline(
    const struct mip_sensor_raw_gyro *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x80, 0x02, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->raw_gyro[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_sensor_raw_mag_decode_inline(struct mip_sensor_raw_mag *value,
                                                         const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x80, 0x03, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->raw_mag[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_sensor_raw_mag_encode_inline(
    const struct mip_sensor_raw_mag *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x80, 0x03, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->raw_mag[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_sensor_scaled_accel_decode_inline(struct mip_sensor_scaled_accel *value,
                                                              const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x80, 0x04, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->scaled_accel[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_sensor_scaled_accel_encode_inline(
    const struct mip_sensor_scaled_accel *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x80, 0x04, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->scaled_accel[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_sensor_scaled_gyro_decode_inline(struct mip_sensor_scaled_gyro *value,
                                                             const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x80, 0x05, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->scaled_gyro[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_sensor_scaled_gyro_encode_inline(
    const struct mip_sensor_scaled_gyro *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x80, 0x05, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->scaled_gyro[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_sensor_scaled_mag_decode_inline(struct mip_sensor_scaled_mag *value,
                                                            const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x80, 0x06, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->scaled_mag[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_sensor_scaled_mag_encode_inline(
    const struct mip_sensor_scaled_mag *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x80, 0x06, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->scaled_mag[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_sensor_delta_theta_decode_inline(struct mip_sensor_delta_theta *value,
                                                             const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x80, 0x07, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->delta_theta[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_sensor_delta_theta_encode_inline(
    const struct mip_sensor_delta_theta *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x80, 0x07, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->delta_theta[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_sensor_delta_velocity_decode_inline(
    struct mip_sensor_delta_velocity *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x80, 0x08, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->delta_velocity[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_sensor_delta_velocity_encode_inline(
    const struct mip_sensor_delta_velocity *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x80, 0x08, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->delta_velocity[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_sensor_comp_orientation_matrix_decode_inline(
    struct mip_sensor_comp_orientation_matrix *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x80, 0x09, 36);
    if (mip_cleared(error, value, sizeof(*value), 36)) {
        return error;
    }
    for (size_t i = 0; i < 9; i++) {
        mip_get_float(&value->m[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_sensor_comp_orientation_matrix_encode_inline(
    const struct mip_sensor_comp_orientation_matrix *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x80, 0x09, 36, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 9; i++) {
        mip_put_float(data + 4 * i, &value->m[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_sensor_comp_quaternion_decode_inline(
    struct mip_sensor_comp_quaternion *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x80, 0x0A, 16);
    if (mip_cleared(error, value, sizeof(*value), 16)) {
        return error;
    }
    for (size_t i = 0; i < 4; i++) {
        mip_get_float(&value->q[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_sensor_comp_quaternion_encode_inline(
    const struct mip_sensor_comp_quaternion *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x80, 0x0A, 16, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 4; i++) {
        mip_put_float(data + 4 * i, &value->q[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_sensor_comp_orientation_update_matrix_decode_inline(
    struct mip_sensor_comp_orientation_update_matrix *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x80, 0x0B, 36);
    if (mip_cleared(error, value, sizeof(*value), 36)) {
        return error;
    }
    for (size_t i = 0; i < 9; i++) {
        mip_get_float(&value->m[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_sensor_comp_orientation_update_matrix_encode_inline(
    const struct mip_sensor_comp_orientation_update_matrix *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x80, 0x0B, 36, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 9; i++) {
        mip_put_float(data + 4 * i, &value->m[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_sensor_comp_euler_angles_decode_inline(
    struct mip_sensor_comp_euler_angles *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x80, 0x0C, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    mip_get_float(&value->roll, field->data);
    mip_get_float(&value->pitch, field->data + 4);
    mip_get_float(&value->yaw, field->data + 8);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_sensor_comp_euler_angles_encode_inline(
    const struct mip_sensor_comp_euler_angles *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x80, 0x0C, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->roll);
    mip_put_float(data + 4, &value->pitch);
    mip_put_float(data + 8, &value->yaw);
    return MIP_OK;
}

static inline mip_error mip_sensor_orientation_raw_temperature_decode_inline(
    struct mip_sensor_orientation_raw_temperature *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x80, 0x0D, 8);
    if (mip_cleared(error, value, sizeof(*value), 8)) {
        return error;
    }
    for (size_t i = 0; i < 4; i++) {
        value->raw_temperature[i] = mip_get_16(field->data + 2 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_sensor_orientation_raw_temperature_encode_inline(
    const struct mip_sensor_orientation_raw_temperature *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x80, 0x0D, 8, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 4; i++) {
        mip_put_16(data + 2 * i, value->raw_temperature[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_sensor_internal_timestamp_decode_inline(
    struct mip_sensor_internal_timestamp *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x80, 0x0E, 4);
    if (mip_cleared(error, value, sizeof(*value), 4)) {
        return error;
    }
    value->counts = mip_get_32(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_sensor_internal_timestamp_encode_inline(
    const struct mip_sensor_internal_timestamp *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x80, 0x0E, 4, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_32(data, value->counts);
    return MIP_OK;
}

static inline mip_error mip_sensor_pps_timestamp_decode_inline(
    struct mip_sensor_pps_timestamp *value, const struct mip_field *field) {
    mip_error error = mip_field_check(field, 0x80, 0x0F, 8);
    if ((error == MIP_OK || error == MIP_ERROR_TRUNCATED) &&
        !mip_codec_matches(&mip_sensor_pps_timestamp_codec, field)) {
        error = MIP_ERROR_LAYOUT;
    }
    if (mip_cleared(error, value, sizeof(*value), 8)) {
        return error;
    }
    value->seconds = mip_get_32(field->data);
    value->useconds = mip_get_32(field->data + 4);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_sensor_pps_timestamp_encode_inline(
    const struct mip_sensor_pps_timestamp *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x80, 0x0F, 8, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_32(data, value->seconds);
    mip_put_32(data + 4, value->useconds);
    return MIP_OK;
}

static inline mip_error mip_sensor_pps_timestamp_with_flags_decode_inline(
    struct mip_sensor_pps_timestamp_with_flags *value, const struct mip_field *field) {
    mip_error error = mip_field_check(field, 0x80, 0x0F, 9);
    if ((error == MIP_OK || error == MIP_ERROR_TRUNCATED) &&
        !mip_codec_matches(&mip_sensor_pps_timestamp_with_flags_codec, field)) {
        error = MIP_ERROR_LAYOUT;
    }
    if (mip_cleared(error, value, sizeof(*value), 9)) {
        return error;
    }
    value->flags = mip_get_8(field->data);
    value->seconds = mip_get_32(field->data + 1);
    value->nanoseconds = mip_get_32(field->data + 5);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_sensor_pps_timestamp_with_flags_encode_inline(
    const struct mip_sensor_pps_timestamp_with_flags *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x80, 0x0F, 9, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->flags);
    mip_put_32(data + 1, value->seconds);
    mip_put_32(data + 5, value->nanoseconds);
    return MIP_OK;
}

static inline mip_error mip_sensor_north_vector_decode_inline(struct mip_sensor_north_vector *value,
                                                              const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x80, 0x10, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->stabilized_mag[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_sensor_north_vector_encode_inline(
    const struct mip_sensor_north_vector *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x80, 0x10, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->stabilized_mag[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_sensor_up_vector_decode_inline(struct mip_sensor_up_vector *value,
                                                           const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x80, 0x11, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->stabilized_accel[i], field->data + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_sensor_up_vector_encode_inline(
    const struct mip_sensor_up_vector *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x80, 0x11, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->stabilized_accel[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_sensor_gps_timestamp_decode_inline(
    struct mip_sensor_gps_timestamp *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x80, 0x12, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    mip_get_double(&value->tow, field->data);
    value->week_number = mip_get_16(field->data + 8);
    value->valid_flags = mip_get_16(field->data + 10);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_sensor_gps_timestamp_encode_inline(
    const struct mip_sensor_gps_timestamp *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x80, 0x12, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_double(data, &value->tow);
    mip_put_16(data + 8, value->week_number);
    mip_put_16(data + 10, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_sensor_temperature_statistics_decode_inline(
    struct mip_sensor_temperature_statistics *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x80, 0x14, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    mip_get_float(&value->min_temperature, field->data);
    mip_get_float(&value->max_temperature, field->data + 4);
    mip_get_float(&value->mean_temperature, field->data + 8);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_sensor_temperature_statistics_encode_inline(
    const struct mip_sensor_temperature_statistics *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x80, 0x14, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->min_temperature);
    mip_put_float(data + 4, &value->max_temperature);
    mip_put_float(data + 8, &value->mean_temperature);
    return MIP_OK;
}

static inline mip_error mip_sensor_raw_pressure_decode_inline(struct mip_sensor_raw_pressure *value,
                                                              const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x80, 0x16, 4);
    if (mip_cleared(error, value, sizeof(*value), 4)) {
        return error;
    }
    mip_get_float(&value->raw_pressure, field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_sensor_raw_pressure_encode_inline(
    const struct mip_sensor_raw_pressure *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x80, 0x16, 4, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->raw_pressure);
    return MIP_OK;
}

static inline mip_error mip_sensor_scaled_pressure_decode_inline(
    struct mip_sensor_scaled_pressure *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x80, 0x17, 4);
    if (mip_cleared(error, value, sizeof(*value), 4)) {
        return error;
    }
    mip_get_float(&value->scaled_pressure, field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_sensor_scaled_pressure_encode_inline(
    const struct mip_sensor_scaled_pressure *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x80, 0x17, 4, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->scaled_pressure);
    return MIP_OK;
}

static inline mip_error mip_sensor_overrange_status_decode_inline(
    struct mip_sensor_overrange_status *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x80, 0x18, 2);
    if (mip_cleared(error, value, sizeof(*value), 2)) {
        return error;
    }
    value->status = mip_get_16(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_sensor_overrange_status_encode_inline(
    const struct mip_sensor_overrange_status *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x80, 0x18, 2, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_16(data, value->status);
    return MIP_OK;
}

static inline mip_error mip_sensor_odometer_decode_inline(struct mip_sensor_odometer *value,
                                                          const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x80, 0x40, 10);
    if (mip_cleared(error, value, sizeof(*value), 10)) {
        return error;
    }
    mip_get_float(&value->speed, field->data);
    mip_get_float(&value->uncertainty, field->data + 4);
    value->valid_flags = mip_get_16(field->data + 8);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_sensor_odometer_encode_inline(
    const struct mip_sensor_odometer *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x80, 0x40, 10, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->speed);
    mip_put_float(data + 4, &value->uncertainty);
    mip_put_16(data + 8, value->valid_flags);
    return MIP_OK;
}

#ifdef __cplusplus
}
#endif

#endif
