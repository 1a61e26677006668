/**
 * @file
 * The same as _decode and _encode in mip/filter_data.h, but without tables, for speed. Only for
 * fields whose layout never varies.
 */
#ifndef MIP_FILTER_DATA_INLINE_H
#define MIP_FILTER_DATA_INLINE_H

#include "mip/filter_data.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/filter_data_inline.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

static inline mip_error mip_filter_data_llh_position_decode_inline(
    struct mip_filter_data_llh_position *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x01, 26);
    if (mip_cleared(error, value, sizeof(*value), 26)) {
        return error;
    }
    mip_get_double(&value->latitude, field->data);
    mip_get_double(&value->longitude, field->data + 8);
    mip_get_double(&value->ellipsoid_height, field->data + 16);
    value->valid_flags = mip_get_16(field->data + 24);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_llh_position_encode_inline(
    const struct mip_filter_data_llh_position *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x01, 26, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_double(data, &value->latitude);
    mip_put_double(data + 8, &value->longitude);
    mip_put_double(data + 16, &value->ellipsoid_height);
    mip_put_16(data + 24, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_ned_velocity_decode_inline(
    struct mip_filter_data_ned_velocity *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x02, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    mip_get_float(&value->north, field->data);
    mip_get_float(&value->east, field->data + 4);
    mip_get_float(&value->down, field->data + 8);
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_ned_velocity_encode_inline(
    const struct mip_filter_data_ned_velocity *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x02, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->north);
    mip_put_float(data + 4, &value->east);
    mip_put_float(data + 8, &value->down);
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_attitude_quaternion_decode_inline(
    struct mip_filter_data_attitude_quaternion *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x03, 18);
    if (mip_cleared(error, value, sizeof(*value), 18)) {
        return error;
    }
    for (size_t i = 0; i < 4; i++) {
        mip_get_float(&value->q[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 16);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_attitude_quaternion_encode_inline(
    const struct mip_filter_data_attitude_quaternion *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x03, 18, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 4; i++) {
        mip_put_float(data + 4 * i, &value->q[i]);
    }
    mip_put_16(data + 16, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_attitude_dcm_decode_inline(
    struct mip_filter_data_attitude_dcm *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x04, 38);
    if (mip_cleared(error, value, sizeof(*value), 38)) {
        return error;
    }
    for (size_t i = 0; i < 9; i++) {
        mip_get_float(&value->dcm[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 36);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_attitude_dcm_encode_inline(
    const struct mip_filter_data_attitude_dcm *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x04, 38, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 9; i++) {
        mip_put_float(data + 4 * i, &value->dcm[i]);
    }
    mip_put_16(data + 36, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_euler_angles_decode_inline(
    struct mip_filter_data_euler_angles *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x05, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    mip_get_float(&value->roll, field->data);
    mip_get_float(&value->pitch, field->data + 4);
    mip_get_float(&value->yaw, field->data + 8);
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_euler_angles_encode_inline(
    const struct mip_filter_data_euler_angles *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x05, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->roll);
    mip_put_float(data + 4, &value->pitch);
    mip_put_float(data + 8, &value->yaw);
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_gyro_bias_decode_inline(
    struct mip_filter_data_gyro_bias *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x06, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->bias[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_gyro_bias_encode_inline(
    const struct mip_filter_data_gyro_bias *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x06, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->bias[i]);
    }
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_accel_bias_decode_inline(
    struct mip_filter_data_accel_bias *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x07, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->bias[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_accel_bias_encode_inline(
    const struct mip_filter_data_accel_bias *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x07, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->bias[i]);
    }
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_llh_position_uncertainty_decode_inline(
    struct mip_filter_data_llh_position_uncertainty *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x08, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    mip_get_float(&value->north, field->data);
    mip_get_float(&value->east, field->data + 4);
    mip_get_float(&value->down, field->data + 8);
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_llh_position_uncertainty_encode_inline(
    const struct mip_filter_data_llh_position_uncertainty *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x08, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->north);
    mip_put_float(data + 4, &value->east);
    mip_put_float(data + 8, &value->down);
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_ned_velocity_uncertainty_decode_inline(
    struct mip_filter_data_ned_velocity_uncertainty *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x09, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    mip_get_float(&value->north, field->data);
    mip_get_float(&value->east, field->data + 4);
    mip_get_float(&value->down, field->data + 8);
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_ned_velocity_uncertainty_encode_inline(
    const struct mip_filter_data_ned_velocity_uncertainty *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x09, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->north);
    mip_put_float(data + 4, &value->east);
    mip_put_float(data + 8, &value->down);
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_euler_angles_uncertainty_decode_inline(
    struct mip_filter_data_euler_angles_uncertainty *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x0A, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    mip_get_float(&value->roll, field->data);
    mip_get_float(&value->pitch, field->data + 4);
    mip_get_float(&value->yaw, field->data + 8);
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_euler_angles_uncertainty_encode_inline(
    const struct mip_filter_data_euler_angles_uncertainty *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x0A, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->roll);
    mip_put_float(data + 4, &value->pitch);
    mip_put_float(data + 8, &value->yaw);
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_gyro_bias_uncertainty_decode_inline(
    struct mip_filter_data_gyro_bias_uncertainty *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x0B, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->bias_uncertainty[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_gyro_bias_uncertainty_encode_inline(
    const struct mip_filter_data_gyro_bias_uncertainty *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x0B, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->bias_uncertainty[i]);
    }
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_accel_bias_uncertainty_decode_inline(
    struct mip_filter_data_accel_bias_uncertainty *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x0C, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->bias_uncertainty[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_accel_bias_uncertainty_encode_inline(
    const struct mip_filter_data_accel_bias_uncertainty *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x0C, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->bias_uncertainty[i]);
    }
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_linear_accel_decode_inline(
    struct mip_filter_data_linear_accel *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x0D, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->accel[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_linear_accel_encode_inline(
    const struct mip_filter_data_linear_accel *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x0D, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->accel[i]);
    }
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_comp_angular_rate_decode_inline(
    struct mip_filter_data_comp_angular_rate *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x0E, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->gyro[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_comp_angular_rate_encode_inline(
    const struct mip_filter_data_comp_angular_rate *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x0E, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->gyro[i]);
    }
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_wgs84_gravity_magnitude_decode_inline(
    struct mip_filter_data_wgs84_gravity_magnitude *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x0F, 6);
    if (mip_cleared(error, value, sizeof(*value), 6)) {
        return error;
    }
    mip_get_float(&value->gravity_magnitude, field->data);
    value->valid_flags = mip_get_16(field->data + 4);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_wgs84_gravity_magnitude_encode_inline(
    const struct mip_filter_data_wgs84_gravity_magnitude *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x0F, 6, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->gravity_magnitude);
    mip_put_16(data + 4, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_status_decode_inline(struct mip_filter_data_status *value,
                                                             const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x10, 6);
    if (mip_cleared(error, value, sizeof(*value), 6)) {
        return error;
    }
    value->filter_state = mip_get_16(field->data);
    value->dynamics_mode = mip_get_16(field->data + 2);
    value->status_flags = mip_get_16(field->data + 4);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_status_encode_inline(
    const struct mip_filter_data_status *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x10, 6, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_16(data, value->filter_state);
    mip_put_16(data + 2, value->dynamics_mode);
    mip_put_16(data + 4, value->status_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_timestamp_decode_inline(
    struct mip_filter_data_timestamp *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x11, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    mip_get_double(&value->tow, field->data);
    value->week_number = mip_get_16(field->data + 8);
    value->valid_flags = mip_get_16(field->data + 10);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_timestamp_encode_inline(
    const struct mip_filter_data_timestamp *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x11, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_double(data, &value->tow);
    mip_put_16(data + 8, value->week_number);
    mip_put_16(data + 10, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_quaternion_attitude_uncertainty_decode_inline(
    struct mip_filter_data_quaternion_attitude_uncertainty *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x12, 18);
    if (mip_cleared(error, value, sizeof(*value), 18)) {
        return error;
    }
    for (size_t i = 0; i < 4; i++) {
        mip_get_float(&value->q[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 16);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_quaternion_attitude_uncertainty_encode_inline(
    const struct mip_filter_data_quaternion_attitude_uncertainty *value,
    struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x12, 18, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 4; i++) {
        mip_put_float(data + 4 * i, &value->q[i]);
    }
    mip_put_16(data + 16, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_gravity_vector_decode_inline(
    struct mip_filter_data_gravity_vector *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x13, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->gravity[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_gravity_vector_encode_inline(
    const struct mip_filter_data_gravity_vector *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x13, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->gravity[i]);
    }
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_heading_update_state_decode_inline(
    struct mip_filter_data_heading_update_state *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x14, 12);
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    mip_get_float(&value->heading, field->data);
    mip_get_float(&value->heading_uncertainty, field->data + 4);
    value->source = mip_get_16(field->data + 8);
    value->valid_flags = mip_get_16(field->data + 10);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_heading_update_state_encode_inline(
    const struct mip_filter_data_heading_update_state *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x14, 12, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->heading);
    mip_put_float(data + 4, &value->heading_uncertainty);
    mip_put_16(data + 8, value->source);
    mip_put_16(data + 10, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_magnetic_model_decode_inline(
    struct mip_filter_data_magnetic_model *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x15, 22);
    if (mip_cleared(error, value, sizeof(*value), 22)) {
        return error;
    }
    mip_get_float(&value->intensity_north, field->data);
    mip_get_float(&value->intensity_east, field->data + 4);
    mip_get_float(&value->intensity_down, field->data + 8);
    mip_get_float(&value->inclination, field->data + 12);
    mip_get_float(&value->declination, field->data + 16);
    value->valid_flags = mip_get_16(field->data + 20);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_magnetic_model_encode_inline(
    const struct mip_filter_data_magnetic_model *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x15, 22, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->intensity_north);
    mip_put_float(data + 4, &value->intensity_east);
    mip_put_float(data + 8, &value->intensity_down);
    mip_put_float(data + 12, &value->inclination);
    mip_put_float(data + 16, &value->declination);
    mip_put_16(data + 20, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_gyro_scale_factor_decode_inline(
    struct mip_filter_data_gyro_scale_factor *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x16, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->scale_factor[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_gyro_scale_factor_encode_inline(
    const struct mip_filter_data_gyro_scale_factor *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x16, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->scale_factor[i]);
    }
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_accel_scale_factor_decode_inline(
    struct mip_filter_data_accel_scale_factor *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x17, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->scale_factor[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_accel_scale_factor_encode_inline(
    const struct mip_filter_data_accel_scale_factor *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x17, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->scale_factor[i]);
    }
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_gyro_scale_factor_uncertainty_decode_inline(
    struct mip_filter_data_gyro_scale_factor_uncertainty *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x18, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->scale_factor_uncertainty[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_gyro_scale_factor_uncertainty_encode_inline(
    const struct mip_filter_data_gyro_scale_factor_uncertainty *value,
    struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x18, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->scale_factor_uncertainty[i]);
    }
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_accel_scale_factor_uncertainty_decode_inline(
    struct mip_filter_data_accel_scale_factor_uncertainty *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x19, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->scale_factor_uncertainty[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_accel_scale_factor_uncertainty_encode_inline(
    const struct mip_filter_data_accel_scale_factor_uncertainty *value,
    struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x19, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->scale_factor_uncertainty[i]);
    }
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_mag_bias_decode_inline(
    struct mip_filter_data_mag_bias *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x1A, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->bias[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_mag_bias_encode_inline(
    const struct mip_filter_data_mag_bias *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x1A, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->bias[i]);
    }
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_mag_bias_uncertainty_decode_inline(
    struct mip_filter_data_mag_bias_uncertainty *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x1B, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->bias_uncertainty[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_mag_bias_uncertainty_encode_inline(
    const struct mip_filter_data_mag_bias_uncertainty *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x1B, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->bias_uncertainty[i]);
    }
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_comp_accel_decode_inline(
    struct mip_filter_data_comp_accel *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x1C, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->accel[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_comp_accel_encode_inline(
    const struct mip_filter_data_comp_accel *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x1C, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->accel[i]);
    }
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_standard_atmosphere_decode_inline(
    struct mip_filter_data_standard_atmosphere *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x20, 22);
    if (mip_cleared(error, value, sizeof(*value), 22)) {
        return error;
    }
    mip_get_float(&value->geometric_altitude, field->data);
    mip_get_float(&value->geopotential_altitude, field->data + 4);
    mip_get_float(&value->standard_temperature, field->data + 8);
    mip_get_float(&value->standard_pressure, field->data + 12);
    mip_get_float(&value->standard_density, field->data + 16);
    value->valid_flags = mip_get_16(field->data + 20);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_standard_atmosphere_encode_inline(
    const struct mip_filter_data_standard_atmosphere *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x20, 22, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->geometric_altitude);
    mip_put_float(data + 4, &value->geopotential_altitude);
    mip_put_float(data + 8, &value->standard_temperature);
    mip_put_float(data + 12, &value->standard_pressure);
    mip_put_float(data + 16, &value->standard_density);
    mip_put_16(data + 20, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_pressure_altitude_decode_inline(
    struct mip_filter_data_pressure_altitude *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x21, 6);
    if (mip_cleared(error, value, sizeof(*value), 6)) {
        return error;
    }
    mip_get_float(&value->pressure_altitude, field->data);
    value->valid_flags = mip_get_16(field->data + 4);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_pressure_altitude_encode_inline(
    const struct mip_filter_data_pressure_altitude *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x21, 6, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->pressure_altitude);
    mip_put_16(data + 4, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_density_altitude_decode_inline(
    struct mip_filter_data_density_altitude *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x22, 6);
    if (mip_cleared(error, value, sizeof(*value), 6)) {
        return error;
    }
    mip_get_float(&value->density_altitude, field->data);
    value->valid_flags = mip_get_16(field->data + 4);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_density_altitude_encode_inline(
    const struct mip_filter_data_density_altitude *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x22, 6, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->density_altitude);
    mip_put_16(data + 4, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_mag_offset_decode_inline(
    struct mip_filter_data_mag_offset *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x25, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->hard_iron[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_mag_offset_encode_inline(
    const struct mip_filter_data_mag_offset *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x25, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->hard_iron[i]);
    }
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_mag_matrix_decode_inline(
    struct mip_filter_data_mag_matrix *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x26, 38);
    if (mip_cleared(error, value, sizeof(*value), 38)) {
        return error;
    }
    for (size_t i = 0; i < 9; i++) {
        mip_get_float(&value->soft_iron[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 36);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_mag_matrix_encode_inline(
    const struct mip_filter_data_mag_matrix *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x26, 38, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 9; i++) {
        mip_put_float(data + 4 * i, &value->soft_iron[i]);
    }
    mip_put_16(data + 36, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_mag_offset_uncertainty_decode_inline(
    struct mip_filter_data_mag_offset_uncertainty *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x28, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->hard_iron_uncertainty[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_mag_offset_uncertainty_encode_inline(
    const struct mip_filter_data_mag_offset_uncertainty *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x28, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->hard_iron_uncertainty[i]);
    }
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_mag_matrix_uncertainty_decode_inline(
    struct mip_filter_data_mag_matrix_uncertainty *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x29, 38);
    if (mip_cleared(error, value, sizeof(*value), 38)) {
        return error;
    }
    for (size_t i = 0; i < 9; i++) {
        mip_get_float(&value->soft_iron_uncertainty[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 36);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_mag_matrix_uncertainty_encode_inline(
    const struct mip_filter_data_mag_matrix_uncertainty *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x29, 38, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 9; i++) {
        mip_put_float(data + 4 * i, &value->soft_iron_uncertainty[i]);
    }
    mip_put_16(data + 36, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_mag_covariance_matrix_decode_inline(
    struct mip_filter_data_mag_covariance_matrix *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x2A, 38);
    if (mip_cleared(error, value, sizeof(*value), 38)) {
        return error;
    }
    for (size_t i = 0; i < 9; i++) {
        mip_get_float(&value->covariance[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 36);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_mag_covariance_matrix_encode_inline(
    const struct mip_filter_data_mag_covariance_matrix *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x2A, 38, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 9; i++) {
        mip_put_float(data + 4 * i, &value->covariance[i]);
    }
    mip_put_16(data + 36, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_mag_residual_vector_decode_inline(
    struct mip_filter_data_mag_residual_vector *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x2C, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->residual[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_mag_residual_vector_encode_inline(
    const struct mip_filter_data_mag_residual_vector *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x2C, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->residual[i]);
    }
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_antenna_offset_correction_decode_inline(
    struct mip_filter_data_antenna_offset_correction *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x30, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->offset[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_antenna_offset_correction_encode_inline(
    const struct mip_filter_data_antenna_offset_correction *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x30, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->offset[i]);
    }
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_antenna_offset_correction_uncertainty_decode_inline(
    struct mip_filter_data_antenna_offset_correction_uncertainty *value,
    const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x31, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->offset_uncertainty[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error
mip_filter_data_antenna_offset_correction_uncertainty_encode_inline(
    const struct mip_filter_data_antenna_offset_correction_uncertainty *value,
    struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x31, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->offset_uncertainty[i]);
    }
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_clock_correction_decode_inline(
    struct mip_filter_data_clock_correction *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x32, 11);
    if (mip_cleared(error, value, sizeof(*value), 11)) {
        return error;
    }
    value->receiver_id = mip_get_8(field->data);
    mip_get_float(&value->bias, field->data + 1);
    mip_get_float(&value->bias_drift, field->data + 5);
    value->valid_flags = mip_get_16(field->data + 9);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_clock_correction_encode_inline(
    const struct mip_filter_data_clock_correction *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x32, 11, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->receiver_id);
    mip_put_float(data + 1, &value->bias);
    mip_put_float(data + 5, &value->bias_drift);
    mip_put_16(data + 9, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_clock_correction_uncertainty_decode_inline(
    struct mip_filter_data_clock_correction_uncertainty *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x33, 11);
    if (mip_cleared(error, value, sizeof(*value), 11)) {
        return error;
    }
    value->receiver_id = mip_get_8(field->data);
    mip_get_float(&value->bias_uncertainty, field->data + 1);
    mip_get_float(&value->bias_drift_uncertainty, field->data + 5);
    value->valid_flags = mip_get_16(field->data + 9);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_clock_correction_uncertainty_encode_inline(
    const struct mip_filter_data_clock_correction_uncertainty *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x33, 11, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->receiver_id);
    mip_put_float(data + 1, &value->bias_uncertainty);
    mip_put_float(data + 5, &value->bias_drift_uncertainty);
    mip_put_16(data + 9, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_multi_antenna_offset_correction_decode_inline(
    struct mip_filter_data_multi_antenna_offset_correction *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x34, 15);
    if (mip_cleared(error, value, sizeof(*value), 15)) {
        return error;
    }
    value->receiver_id = mip_get_8(field->data);
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->offset[i], field->data + 1 + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 13);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_multi_antenna_offset_correction_encode_inline(
    const struct mip_filter_data_multi_antenna_offset_correction *value,
    struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x34, 15, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->receiver_id);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 1 + 4 * i, &value->offset[i]);
    }
    mip_put_16(data + 13, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_multi_antenna_offset_uncertainty_decode_inline(
    struct mip_filter_data_multi_antenna_offset_uncertainty *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x35, 15);
    if (mip_cleared(error, value, sizeof(*value), 15)) {
        return error;
    }
    value->receiver_id = mip_get_8(field->data);
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->offset_uncertainty[i], field->data + 1 + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 13);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_multi_antenna_offset_uncertainty_encode_inline(
    const struct mip_filter_data_multi_antenna_offset_uncertainty *value,
    struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x35, 15, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->receiver_id);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 1 + 4 * i, &value->offset_uncertainty[i]);
    }
    mip_put_16(data + 13, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_ecef_position_uncertainty_decode_inline(
    struct mip_filter_data_ecef_position_uncertainty *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x36, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->position_uncertainty[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_ecef_position_uncertainty_encode_inline(
    const struct mip_filter_data_ecef_position_uncertainty *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x36, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->position_uncertainty[i]);
    }
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_ecef_velocity_uncertainty_decode_inline(
    struct mip_filter_data_ecef_velocity_uncertainty *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x37, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->velocity_uncertainty[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_ecef_velocity_uncertainty_encode_inline(
    const struct mip_filter_data_ecef_velocity_uncertainty *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x37, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->velocity_uncertainty[i]);
    }
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_ecef_position_decode_inline(
    struct mip_filter_data_ecef_position *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x40, 26);
    if (mip_cleared(error, value, sizeof(*value), 26)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_double(&value->position[i], field->data + 8 * i);
    }
    value->valid_flags = mip_get_16(field->data + 24);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_ecef_position_encode_inline(
    const struct mip_filter_data_ecef_position *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x40, 26, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_double(data + 8 * i, &value->position[i]);
    }
    mip_put_16(data + 24, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_ecef_velocity_decode_inline(
    struct mip_filter_data_ecef_velocity *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x41, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->velocity[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_ecef_velocity_encode_inline(
    const struct mip_filter_data_ecef_velocity *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x41, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->velocity[i]);
    }
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_ned_relative_position_decode_inline(
    struct mip_filter_data_ned_relative_position *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x42, 26);
    if (mip_cleared(error, value, sizeof(*value), 26)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_double(&value->relative_position[i], field->data + 8 * i);
    }
    value->valid_flags = mip_get_16(field->data + 24);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_ned_relative_position_encode_inline(
    const struct mip_filter_data_ned_relative_position *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x42, 26, &data);
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_double(data + 8 * i, &value->relative_position[i]);
    }
    mip_put_16(data + 24, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_gnss_position_aiding_status_decode_inline(
    struct mip_filter_data_gnss_position_aiding_status *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x43, 15);
    if (mip_cleared(error, value, sizeof(*value), 15)) {
        return error;
    }
    value->receiver_id = mip_get_8(field->data);
    mip_get_float(&value->tow, field->data + 1);
    value->status = mip_get_16(field->data + 5);
    memcpy(value->reserved, field->data + 7, 8);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_gnss_position_aiding_status_encode_inline(
    const struct mip_filter_data_gnss_position_aiding_status *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x43, 15, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->receiver_id);
    mip_put_float(data + 1, &value->tow);
    mip_put_16(data + 5, value->status);
    memcpy(data + 7, value->reserved, 8);
    return MIP_OK;
}

static inline mip_error mip_filter_data_gnss_attitude_aiding_status_decode_inline(
    struct mip_filter_data_gnss_attitude_aiding_status *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x44, 14);
    if (mip_cleared(error, value, sizeof(*value), 14)) {
        return error;
    }
    mip_get_float(&value->tow, field->data);
    value->status = mip_get_16(field->data + 4);
    memcpy(value->reserved, field->data + 6, 8);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_gnss_attitude_aiding_status_encode_inline(
    const struct mip_filter_data_gnss_attitude_aiding_status *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x44, 14, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->tow);
    mip_put_16(data + 4, value->status);
    memcpy(data + 6, value->reserved, 8);
    return MIP_OK;
}

static inline mip_error mip_filter_data_heading_aiding_status_decode_inline(
    struct mip_filter_data_heading_aiding_status *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x45, 13);
    if (mip_cleared(error, value, sizeof(*value), 13)) {
        return error;
    }
    mip_get_float(&value->tow, field->data);
    value->type = mip_get_8(field->data + 4);
    for (size_t i = 0; i < 2; i++) {
        mip_get_float(&value->reserved[i], field->data + 5 + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_heading_aiding_status_encode_inline(
    const struct mip_filter_data_heading_aiding_status *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x45, 13, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->tow);
    mip_put_8(data + 4, value->type);
    for (size_t i = 0; i < 2; i++) {
        mip_put_float(data + 5 + 4 * i, &value->reserved[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_filter_data_aiding_measurement_summary_decode_inline(
    struct mip_filter_data_aiding_measurement_summary *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x46, 7);
    if (mip_cleared(error, value, sizeof(*value), 7)) {
        return error;
    }
    mip_get_float(&value->tow, field->data);
    value->source = mip_get_8(field->data + 4);
    value->type = mip_get_8(field->data + 5);
    value->indicator = mip_get_8(field->data + 6);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_aiding_measurement_summary_encode_inline(
    const struct mip_filter_data_aiding_measurement_summary *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x46, 7, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->tow);
    mip_put_8(data + 4, value->source);
    mip_put_8(data + 5, value->type);
    mip_put_8(data + 6, value->indicator);
    return MIP_OK;
}

static inline mip_error mip_filter_data_odometer_scale_factor_error_decode_inline(
    struct mip_filter_data_odometer_scale_factor_error *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x47, 6);
    if (mip_cleared(error, value, sizeof(*value), 6)) {
        return error;
    }
    mip_get_float(&value->scale_factor_error, field->data);
    value->valid_flags = mip_get_16(field->data + 4);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_odometer_scale_factor_error_encode_inline(
    const struct mip_filter_data_odometer_scale_factor_error *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x47, 6, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->scale_factor_error);
    mip_put_16(data + 4, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_odometer_scale_factor_error_uncertainty_decode_inline(
    struct mip_filter_data_odometer_scale_factor_error_uncertainty *value,
    const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x48, 6);
    if (mip_cleared(error, value, sizeof(*value), 6)) {
        return error;
    }
    mip_get_float(&value->scale_factor_error_uncertainty, field->data);
    value->valid_flags = mip_get_16(field->data + 4);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error
mip_filter_data_odometer_scale_factor_error_uncertainty_encode_inline(
    const struct mip_filter_data_odometer_scale_factor_error_uncertainty *value,
    struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x48, 6, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->scale_factor_error_uncertainty);
    mip_put_16(data + 4, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_gnss_dual_antenna_status_decode_inline(
    struct mip_filter_data_gnss_dual_antenna_status *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x49, 17);
    if (mip_cleared(error, value, sizeof(*value), 17)) {
        return error;
    }
    mip_get_float(&value->tow, field->data);
    mip_get_float(&value->heading, field->data + 4);
    mip_get_float(&value->heading_uncertainty, field->data + 8);
    value->fix_type = mip_get_8(field->data + 12);
    value->status_flags = mip_get_16(field->data + 13);
    value->valid_flags = mip_get_16(field->data + 15);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_gnss_dual_antenna_status_encode_inline(
    const struct mip_filter_data_gnss_dual_antenna_status *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x49, 17, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->tow);
    mip_put_float(data + 4, &value->heading);
    mip_put_float(data + 8, &value->heading_uncertainty);
    mip_put_8(data + 12, value->fix_type);
    mip_put_16(data + 13, value->status_flags);
    mip_put_16(data + 15, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_filter_data_aiding_frame_config_error_decode_inline(
    struct mip_filter_data_aiding_frame_config_error *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x50, 29);
    if (mip_cleared(error, value, sizeof(*value), 29)) {
        return error;
    }
    value->frame_id = mip_get_8(field->data);
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->translation[i], field->data + 1 + 4 * i);
    }
    for (size_t i = 0; i < 4; i++) {
        mip_get_float(&value->attitude[i], field->data + 13 + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_filter_data_aiding_frame_config_error_encode_inline(
    const struct mip_filter_data_aiding_frame_config_error *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x50, 29, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->frame_id);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 1 + 4 * i, &value->translation[i]);
    }
    for (size_t i = 0; i < 4; i++) {
        mip_put_float(data + 13 + 4 * i, &value->attitude[i]);
    }
    return MIP_OK;
}

static inline mip_error mip_filter_data_aiding_frame_config_error_uncertainty_decode_inline(
    struct mip_filter_data_aiding_frame_config_error_uncertainty *value,
    const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x82, 0x51, 25);
    if (mip_cleared(error, value, sizeof(*value), 25)) {
        return error;
    }
    value->frame_id = mip_get_8(field->data);
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->translation_uncertainty[i], field->data + 1 + 4 * i);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->attitude_uncertainty[i], field->data + 13 + 4 * i);
    }
    return MIP_OK;
}

MIP_CHECKED static inline mip_error
mip_filter_data_aiding_frame_config_error_uncertainty_encode_inline(
    const struct mip_filter_data_aiding_frame_config_error_uncertainty *value,
    struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x82, 0x51, 25, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->frame_id);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 1 + 4 * i, &value->translation_uncertainty[i]);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 13 + 4 * i, &value->attitude_uncertainty[i]);
    }
    return MIP_OK;
}

#ifdef __cplusplus
}
#endif

#endif
