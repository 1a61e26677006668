/**
 * @file
 * The same as _decode and _encode in mip/aiding.h, but without tables, for speed. Only for fields
 * whose layout never varies.
 */
#ifndef MIP_AIDING_INLINE_H
#define MIP_AIDING_INLINE_H

#include "mip/aiding.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/aiding_inline.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

static inline mip_error mip_aiding_sensor_frame_map_response_decode_inline(
    struct mip_aiding_sensor_frame_map_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x13, 0x82, 2);
    if (mip_cleared(error, value, sizeof(*value), 2)) {
        return error;
    }
    value->sensor_id = mip_get_8(field->data);
    value->frame_id = mip_get_8(field->data + 1);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_aiding_sensor_frame_map_response_encode_inline(
    const struct mip_aiding_sensor_frame_map_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x13, 0x82, 2, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->sensor_id);
    mip_put_8(data + 1, value->frame_id);
    return MIP_OK;
}

static inline mip_error mip_aiding_echo_control_response_decode_inline(
    struct mip_aiding_echo_control_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x13, 0x9F, 1);
    if (mip_cleared(error, value, sizeof(*value), 1)) {
        return error;
    }
    value->mode = mip_get_8(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_aiding_echo_control_response_encode_inline(
    const struct mip_aiding_echo_control_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x13, 0x9F, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->mode);
    return MIP_OK;
}

static inline mip_error mip_aiding_ecef_position_decode_inline(
    struct mip_aiding_ecef_position *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x13, 0x21, 49);
    if (mip_cleared(error, value, sizeof(*value), 49)) {
        return error;
    }
    value->time.timebase = mip_get_8(field->data);
    value->time.reserved = mip_get_8(field->data + 1);
    value->time.nanoseconds = mip_get_64(field->data + 2);
    value->frame_id = mip_get_8(field->data + 10);
    for (size_t i = 0; i < 3; i++) {
        mip_get_double(&value->position[i], field->data + 11 + 8 * i);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->uncertainty[i], field->data + 35 + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 47);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_aiding_ecef_position_encode_inline(
    const struct mip_aiding_ecef_position *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x13, 0x21, 49, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->time.timebase);
    mip_put_8(data + 1, value->time.reserved);
    mip_put_64(data + 2, value->time.nanoseconds);
    mip_put_8(data + 10, value->frame_id);
    for (size_t i = 0; i < 3; i++) {
        mip_put_double(data + 11 + 8 * i, &value->position[i]);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 35 + 4 * i, &value->uncertainty[i]);
    }
    mip_put_16(data + 47, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_aiding_llh_position_decode_inline(struct mip_aiding_llh_position *value,
                                                              const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x13, 0x22, 49);
    if (mip_cleared(error, value, sizeof(*value), 49)) {
        return error;
    }
    value->time.timebase = mip_get_8(field->data);
    value->time.reserved = mip_get_8(field->data + 1);
    value->time.nanoseconds = mip_get_64(field->data + 2);
    value->frame_id = mip_get_8(field->data + 10);
    mip_get_double(&value->latitude, field->data + 11);
    mip_get_double(&value->longitude, field->data + 19);
    mip_get_double(&value->height, field->data + 27);
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->uncertainty[i], field->data + 35 + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 47);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_aiding_llh_position_encode_inline(
    const struct mip_aiding_llh_position *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x13, 0x22, 49, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->time.timebase);
    mip_put_8(data + 1, value->time.reserved);
    mip_put_64(data + 2, value->time.nanoseconds);
    mip_put_8(data + 10, value->frame_id);
    mip_put_double(data + 11, &value->latitude);
    mip_put_double(data + 19, &value->longitude);
    mip_put_double(data + 27, &value->height);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 35 + 4 * i, &value->uncertainty[i]);
    }
    mip_put_16(data + 47, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_aiding_height_above_ellipsoid_decode_inline(
    struct mip_aiding_height_above_ellipsoid *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x13, 0x23, 21);
    if (mip_cleared(error, value, sizeof(*value), 21)) {
        return error;
    }
    value->time.timebase = mip_get_8(field->data);
    value->time.reserved = mip_get_8(field->data + 1);
    value->time.nanoseconds = mip_get_64(field->data + 2);
    value->frame_id = mip_get_8(field->data + 10);
    mip_get_float(&value->height, field->data + 11);
    mip_get_float(&value->uncertainty, field->data + 15);
    value->valid_flags = mip_get_16(field->data + 19);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_aiding_height_above_ellipsoid_encode_inline(
    const struct mip_aiding_height_above_ellipsoid *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x13, 0x23, 21, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->time.timebase);
    mip_put_8(data + 1, value->time.reserved);
    mip_put_64(data + 2, value->time.nanoseconds);
    mip_put_8(data + 10, value->frame_id);
    mip_put_float(data + 11, &value->height);
    mip_put_float(data + 15, &value->uncertainty);
    mip_put_16(data + 19, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_aiding_pressure_old_decode_inline(struct mip_aiding_pressure_old *value,
                                                              const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x13, 0x25, 21);
    if (mip_cleared(error, value, sizeof(*value), 21)) {
        return error;
    }
    value->time.timebase = mip_get_8(field->data);
    value->time.reserved = mip_get_8(field->data + 1);
    value->time.nanoseconds = mip_get_64(field->data + 2);
    value->frame_id = mip_get_8(field->data + 10);
    mip_get_float(&value->pressure, field->data + 11);
    mip_get_float(&value->uncertainty, field->data + 15);
    value->valid_flags = mip_get_16(field->data + 19);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_aiding_pressure_old_encode_inline(
    const struct mip_aiding_pressure_old *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x13, 0x25, 21, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->time.timebase);
    mip_put_8(data + 1, value->time.reserved);
    mip_put_64(data + 2, value->time.nanoseconds);
    mip_put_8(data + 10, value->frame_id);
    mip_put_float(data + 11, &value->pressure);
    mip_put_float(data + 15, &value->uncertainty);
    mip_put_16(data + 19, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_aiding_ecef_velocity_decode_inline(
    struct mip_aiding_ecef_velocity *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x13, 0x28, 37);
    if (mip_cleared(error, value, sizeof(*value), 37)) {
        return error;
    }
    value->time.timebase = mip_get_8(field->data);
    value->time.reserved = mip_get_8(field->data + 1);
    value->time.nanoseconds = mip_get_64(field->data + 2);
    value->frame_id = mip_get_8(field->data + 10);
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->velocity[i], field->data + 11 + 4 * i);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->uncertainty[i], field->data + 23 + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 35);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_aiding_ecef_velocity_encode_inline(
    const struct mip_aiding_ecef_velocity *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x13, 0x28, 37, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->time.timebase);
    mip_put_8(data + 1, value->time.reserved);
    mip_put_64(data + 2, value->time.nanoseconds);
    mip_put_8(data + 10, value->frame_id);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 11 + 4 * i, &value->velocity[i]);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 23 + 4 * i, &value->uncertainty[i]);
    }
    mip_put_16(data + 35, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_aiding_ned_velocity_decode_inline(struct mip_aiding_ned_velocity *value,
                                                              const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x13, 0x29, 37);
    if (mip_cleared(error, value, sizeof(*value), 37)) {
        return error;
    }
    value->time.timebase = mip_get_8(field->data);
    value->time.reserved = mip_get_8(field->data + 1);
    value->time.nanoseconds = mip_get_64(field->data + 2);
    value->frame_id = mip_get_8(field->data + 10);
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->velocity[i], field->data + 11 + 4 * i);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->uncertainty[i], field->data + 23 + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 35);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_aiding_ned_velocity_encode_inline(
    const struct mip_aiding_ned_velocity *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x13, 0x29, 37, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->time.timebase);
    mip_put_8(data + 1, value->time.reserved);
    mip_put_64(data + 2, value->time.nanoseconds);
    mip_put_8(data + 10, value->frame_id);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 11 + 4 * i, &value->velocity[i]);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 23 + 4 * i, &value->uncertainty[i]);
    }
    mip_put_16(data + 35, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_aiding_body_frame_velocity_decode_inline(
    struct mip_aiding_body_frame_velocity *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x13, 0x2A, 37);
    if (mip_cleared(error, value, sizeof(*value), 37)) {
        return error;
    }
    value->time.timebase = mip_get_8(field->data);
    value->time.reserved = mip_get_8(field->data + 1);
    value->time.nanoseconds = mip_get_64(field->data + 2);
    value->frame_id = mip_get_8(field->data + 10);
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->velocity[i], field->data + 11 + 4 * i);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->uncertainty[i], field->data + 23 + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 35);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_aiding_body_frame_velocity_encode_inline(
    const struct mip_aiding_body_frame_velocity *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x13, 0x2A, 37, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->time.timebase);
    mip_put_8(data + 1, value->time.reserved);
    mip_put_64(data + 2, value->time.nanoseconds);
    mip_put_8(data + 10, value->frame_id);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 11 + 4 * i, &value->velocity[i]);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 23 + 4 * i, &value->uncertainty[i]);
    }
    mip_put_16(data + 35, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_aiding_true_heading_decode_inline(struct mip_aiding_true_heading *value,
                                                              const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x13, 0x31, 21);
    if (mip_cleared(error, value, sizeof(*value), 21)) {
        return error;
    }
    value->time.timebase = mip_get_8(field->data);
    value->time.reserved = mip_get_8(field->data + 1);
    value->time.nanoseconds = mip_get_64(field->data + 2);
    value->frame_id = mip_get_8(field->data + 10);
    mip_get_float(&value->heading, field->data + 11);
    mip_get_float(&value->uncertainty, field->data + 15);
    value->valid_flags = mip_get_16(field->data + 19);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_aiding_true_heading_encode_inline(
    const struct mip_aiding_true_heading *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x13, 0x31, 21, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->time.timebase);
    mip_put_8(data + 1, value->time.reserved);
    mip_put_64(data + 2, value->time.nanoseconds);
    mip_put_8(data + 10, value->frame_id);
    mip_put_float(data + 11, &value->heading);
    mip_put_float(data + 15, &value->uncertainty);
    mip_put_16(data + 19, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_aiding_magnetic_field_decode_inline(
    struct mip_aiding_magnetic_field *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x13, 0x32, 37);
    if (mip_cleared(error, value, sizeof(*value), 37)) {
        return error;
    }
    value->time.timebase = mip_get_8(field->data);
    value->time.reserved = mip_get_8(field->data + 1);
    value->time.nanoseconds = mip_get_64(field->data + 2);
    value->frame_id = mip_get_8(field->data + 10);
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->magnetic_field[i], field->data + 11 + 4 * i);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->uncertainty[i], field->data + 23 + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 35);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_aiding_magnetic_field_encode_inline(
    const struct mip_aiding_magnetic_field *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x13, 0x32, 37, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->time.timebase);
    mip_put_8(data + 1, value->time.reserved);
    mip_put_64(data + 2, value->time.nanoseconds);
    mip_put_8(data + 10, value->frame_id);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 11 + 4 * i, &value->magnetic_field[i]);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 23 + 4 * i, &value->uncertainty[i]);
    }
    mip_put_16(data + 35, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_aiding_pressure_decode_inline(struct mip_aiding_pressure *value,
                                                          const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x13, 0x33, 21);
    if (mip_cleared(error, value, sizeof(*value), 21)) {
        return error;
    }
    value->time.timebase = mip_get_8(field->data);
    value->time.reserved = mip_get_8(field->data + 1);
    value->time.nanoseconds = mip_get_64(field->data + 2);
    value->frame_id = mip_get_8(field->data + 10);
    mip_get_float(&value->pressure, field->data + 11);
    mip_get_float(&value->uncertainty, field->data + 15);
    value->valid_flags = mip_get_16(field->data + 19);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_aiding_pressure_encode_inline(
    const struct mip_aiding_pressure *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x13, 0x33, 21, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->time.timebase);
    mip_put_8(data + 1, value->time.reserved);
    mip_put_64(data + 2, value->time.nanoseconds);
    mip_put_8(data + 10, value->frame_id);
    mip_put_float(data + 11, &value->pressure);
    mip_put_float(data + 15, &value->uncertainty);
    mip_put_16(data + 19, value->valid_flags);
    return MIP_OK;
}

#ifdef __cplusplus
}
#endif

#endif
