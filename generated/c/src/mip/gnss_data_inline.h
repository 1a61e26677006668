/**
 * @file
 * The same as _decode and _encode in mip/gnss_data.h, but without tables, for speed. Only for
 * fields whose layout never varies.
 */
#ifndef MIP_GNSS_DATA_INLINE_H
#define MIP_GNSS_DATA_INLINE_H

#include "mip/gnss_data.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/gnss_data_inline.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

static inline mip_error mip_gnss_data_llh_position_decode_inline(
    struct mip_gnss_data_llh_position *value, const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x03, 42)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 42)) {
        return error;
    }
    mip_get_double(&value->latitude, field->data);
    mip_get_double(&value->longitude, field->data + 8);
    mip_get_double(&value->ellipsoid_height, field->data + 16);
    mip_get_double(&value->msl_height, field->data + 24);
    mip_get_float(&value->horizontal_accuracy, field->data + 32);
    mip_get_float(&value->vertical_accuracy, field->data + 36);
    value->valid_flags = mip_get_16(field->data + 40);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_llh_position_encode_inline(
    const struct mip_gnss_data_llh_position *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x03, 42, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_double(data, &value->latitude);
    mip_put_double(data + 8, &value->longitude);
    mip_put_double(data + 16, &value->ellipsoid_height);
    mip_put_double(data + 24, &value->msl_height);
    mip_put_float(data + 32, &value->horizontal_accuracy);
    mip_put_float(data + 36, &value->vertical_accuracy);
    mip_put_16(data + 40, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_ecef_position_decode_inline(
    struct mip_gnss_data_ecef_position *value, const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x04, 30)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 30)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_double(&value->position[i], field->data + 8 * i);
    }
    mip_get_float(&value->position_accuracy, field->data + 24);
    value->valid_flags = mip_get_16(field->data + 28);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_ecef_position_encode_inline(
    const struct mip_gnss_data_ecef_position *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x04, 30, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_double(data + 8 * i, &value->position[i]);
    }
    mip_put_float(data + 24, &value->position_accuracy);
    mip_put_16(data + 28, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_ned_velocity_decode_inline(
    struct mip_gnss_data_ned_velocity *value, const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x05, 34)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 34)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->velocity[i], field->data + 4 * i);
    }
    mip_get_float(&value->speed, field->data + 12);
    mip_get_float(&value->ground_speed, field->data + 16);
    mip_get_float(&value->heading, field->data + 20);
    mip_get_float(&value->speed_accuracy, field->data + 24);
    mip_get_float(&value->heading_accuracy, field->data + 28);
    value->valid_flags = mip_get_16(field->data + 32);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_ned_velocity_encode_inline(
    const struct mip_gnss_data_ned_velocity *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x05, 34, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->velocity[i]);
    }
    mip_put_float(data + 12, &value->speed);
    mip_put_float(data + 16, &value->ground_speed);
    mip_put_float(data + 20, &value->heading);
    mip_put_float(data + 24, &value->speed_accuracy);
    mip_put_float(data + 28, &value->heading_accuracy);
    mip_put_16(data + 32, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_ecef_velocity_decode_inline(
    struct mip_gnss_data_ecef_velocity *value, const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x06, 18)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 18)) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->velocity[i], field->data + 4 * i);
    }
    mip_get_float(&value->velocity_accuracy, field->data + 12);
    value->valid_flags = mip_get_16(field->data + 16);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_ecef_velocity_encode_inline(
    const struct mip_gnss_data_ecef_velocity *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x06, 18, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->velocity[i]);
    }
    mip_put_float(data + 12, &value->velocity_accuracy);
    mip_put_16(data + 16, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_dop_decode_inline(struct mip_gnss_data_dop *value,
                                                        const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x07, 30)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 30)) {
        return error;
    }
    mip_get_float(&value->gdop, field->data);
    mip_get_float(&value->pdop, field->data + 4);
    mip_get_float(&value->hdop, field->data + 8);
    mip_get_float(&value->vdop, field->data + 12);
    mip_get_float(&value->tdop, field->data + 16);
    mip_get_float(&value->ndop, field->data + 20);
    mip_get_float(&value->edop, field->data + 24);
    value->valid_flags = mip_get_16(field->data + 28);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_dop_encode_inline(
    const struct mip_gnss_data_dop *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x07, 30, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->gdop);
    mip_put_float(data + 4, &value->pdop);
    mip_put_float(data + 8, &value->hdop);
    mip_put_float(data + 12, &value->vdop);
    mip_put_float(data + 16, &value->tdop);
    mip_put_float(data + 20, &value->ndop);
    mip_put_float(data + 24, &value->edop);
    mip_put_16(data + 28, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_utc_time_decode_inline(struct mip_gnss_data_utc_time *value,
                                                             const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x08, 13)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 13)) {
        return error;
    }
    value->year = mip_get_16(field->data);
    value->month = mip_get_8(field->data + 2);
    value->day = mip_get_8(field->data + 3);
    value->hour = mip_get_8(field->data + 4);
    value->min = mip_get_8(field->data + 5);
    value->sec = mip_get_8(field->data + 6);
    value->msec = mip_get_32(field->data + 7);
    value->valid_flags = mip_get_16(field->data + 11);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_utc_time_encode_inline(
    const struct mip_gnss_data_utc_time *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x08, 13, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_16(data, value->year);
    mip_put_8(data + 2, value->month);
    mip_put_8(data + 3, value->day);
    mip_put_8(data + 4, value->hour);
    mip_put_8(data + 5, value->min);
    mip_put_8(data + 6, value->sec);
    mip_put_32(data + 7, value->msec);
    mip_put_16(data + 11, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_gps_time_decode_inline(struct mip_gnss_data_gps_time *value,
                                                             const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x09, 12)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    mip_get_double(&value->tow, field->data);
    value->week_number = mip_get_16(field->data + 8);
    value->valid_flags = mip_get_16(field->data + 10);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_gps_time_encode_inline(
    const struct mip_gnss_data_gps_time *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x09, 12, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_double(data, &value->tow);
    mip_put_16(data + 8, value->week_number);
    mip_put_16(data + 10, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_clock_info_decode_inline(
    struct mip_gnss_data_clock_info *value, const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x0A, 26)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 26)) {
        return error;
    }
    mip_get_double(&value->bias, field->data);
    mip_get_double(&value->drift, field->data + 8);
    mip_get_double(&value->accuracy_estimate, field->data + 16);
    value->valid_flags = mip_get_16(field->data + 24);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_clock_info_encode_inline(
    const struct mip_gnss_data_clock_info *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x0A, 26, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_double(data, &value->bias);
    mip_put_double(data + 8, &value->drift);
    mip_put_double(data + 16, &value->accuracy_estimate);
    mip_put_16(data + 24, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_fix_info_decode_inline(struct mip_gnss_data_fix_info *value,
                                                             const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x0B, 6)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 6)) {
        return error;
    }
    value->fix_type = mip_get_8(field->data);
    value->num_sv = mip_get_8(field->data + 1);
    value->fix_flags = mip_get_16(field->data + 2);
    value->valid_flags = mip_get_16(field->data + 4);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_fix_info_encode_inline(
    const struct mip_gnss_data_fix_info *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x0B, 6, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->fix_type);
    mip_put_8(data + 1, value->num_sv);
    mip_put_16(data + 2, value->fix_flags);
    mip_put_16(data + 4, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_sv_info_decode_inline(struct mip_gnss_data_sv_info *value,
                                                            const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x0C, 12)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    value->channel = mip_get_8(field->data);
    value->satellite_id = mip_get_8(field->data + 1);
    value->carrier_noise_ratio = mip_get_16(field->data + 2);
    value->azimuth = (int16_t)mip_get_16(field->data + 4);
    value->elevation = (int16_t)mip_get_16(field->data + 6);
    value->sv_flags = mip_get_16(field->data + 8);
    value->valid_flags = mip_get_16(field->data + 10);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_sv_info_encode_inline(
    const struct mip_gnss_data_sv_info *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x0C, 12, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->channel);
    mip_put_8(data + 1, value->satellite_id);
    mip_put_16(data + 2, value->carrier_noise_ratio);
    mip_put_16(data + 4, (uint16_t)value->azimuth);
    mip_put_16(data + 6, (uint16_t)value->elevation);
    mip_put_16(data + 8, value->sv_flags);
    mip_put_16(data + 10, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_hardware_status_decode_inline(
    struct mip_gnss_data_hardware_status *value, const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x0D, 5)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 5)) {
        return error;
    }
    value->receiver_state = mip_get_8(field->data);
    value->antenna_state = mip_get_8(field->data + 1);
    value->antenna_power = mip_get_8(field->data + 2);
    value->valid_flags = mip_get_16(field->data + 3);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_hardware_status_encode_inline(
    const struct mip_gnss_data_hardware_status *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x0D, 5, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->receiver_state);
    mip_put_8(data + 1, value->antenna_state);
    mip_put_8(data + 2, value->antenna_power);
    mip_put_16(data + 3, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_dgps_info_decode_inline(struct mip_gnss_data_dgps_info *value,
                                                              const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                          ? mip_field_check(field, set, 0x0E, 12)
                          : MIP_ERROR_SET;
    if ((error == MIP_OK || error == MIP_ERROR_TRUNCATED) &&
        !mip_codec_matches(&mip_gnss_data_dgps_info_codec, field)) {
        error = MIP_ERROR_LAYOUT;
    }
    if (mip_cleared(error, value, sizeof(*value), 12)) {
        return error;
    }
    mip_get_float(&value->age, field->data);
    value->base_station_id = (int16_t)mip_get_16(field->data + 4);
    value->base_station_status = (int16_t)mip_get_16(field->data + 6);
    value->num_channels = mip_get_16(field->data + 8);
    value->valid_flags = mip_get_16(field->data + 10);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_dgps_info_encode_inline(
    const struct mip_gnss_data_dgps_info *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x0E, 12, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->age);
    mip_put_16(data + 4, (uint16_t)value->base_station_id);
    mip_put_16(data + 6, (uint16_t)value->base_station_status);
    mip_put_16(data + 8, value->num_channels);
    mip_put_16(data + 10, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_dgps_info_satellite_decode_inline(
    struct mip_gnss_data_dgps_info_satellite *value, const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                          ? mip_field_check(field, set, 0x0E, 15)
                          : MIP_ERROR_SET;
    if ((error == MIP_OK || error == MIP_ERROR_TRUNCATED) &&
        !mip_codec_matches(&mip_gnss_data_dgps_info_satellite_codec, field)) {
        error = MIP_ERROR_LAYOUT;
    }
    if (mip_cleared(error, value, sizeof(*value), 15)) {
        return error;
    }
    value->satellite_id = mip_get_8(field->data);
    mip_get_float(&value->age, field->data + 1);
    mip_get_float(&value->range_correction, field->data + 5);
    mip_get_float(&value->range_rate_correction, field->data + 9);
    value->valid_flags = mip_get_16(field->data + 13);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_dgps_info_satellite_encode_inline(
    const struct mip_gnss_data_dgps_info_satellite *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x0E, 15, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->satellite_id);
    mip_put_float(data + 1, &value->age);
    mip_put_float(data + 5, &value->range_correction);
    mip_put_float(data + 9, &value->range_rate_correction);
    mip_put_16(data + 13, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_dgps_channel_decode_inline(
    struct mip_gnss_data_dgps_channel *value, const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x0F, 15)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 15)) {
        return error;
    }
    value->satellite_id = mip_get_8(field->data);
    mip_get_float(&value->age, field->data + 1);
    mip_get_float(&value->range_correction, field->data + 5);
    mip_get_float(&value->range_rate_correction, field->data + 9);
    value->valid_flags = mip_get_16(field->data + 13);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_dgps_channel_encode_inline(
    const struct mip_gnss_data_dgps_channel *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x0F, 15, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->satellite_id);
    mip_put_float(data + 1, &value->age);
    mip_put_float(data + 5, &value->range_correction);
    mip_put_float(data + 9, &value->range_rate_correction);
    mip_put_16(data + 13, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_clock_info_2_decode_inline(
    struct mip_gnss_data_clock_info_2 *value, const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x10, 34)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 34)) {
        return error;
    }
    mip_get_double(&value->bias, field->data);
    mip_get_double(&value->drift, field->data + 8);
    mip_get_double(&value->bias_accuracy_estimate, field->data + 16);
    mip_get_double(&value->drift_accuracy_estimate, field->data + 24);
    value->valid_flags = mip_get_16(field->data + 32);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_clock_info_2_encode_inline(
    const struct mip_gnss_data_clock_info_2 *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x10, 34, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_double(data, &value->bias);
    mip_put_double(data + 8, &value->drift);
    mip_put_double(data + 16, &value->bias_accuracy_estimate);
    mip_put_double(data + 24, &value->drift_accuracy_estimate);
    mip_put_16(data + 32, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_gps_leap_seconds_decode_inline(
    struct mip_gnss_data_gps_leap_seconds *value, const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x11, 3)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 3)) {
        return error;
    }
    value->leap_seconds = mip_get_8(field->data);
    value->valid_flags = mip_get_16(field->data + 1);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_gps_leap_seconds_encode_inline(
    const struct mip_gnss_data_gps_leap_seconds *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x11, 3, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->leap_seconds);
    mip_put_16(data + 1, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_sbas_info_decode_inline(struct mip_gnss_data_sbas_info *value,
                                                              const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x12, 16)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 16)) {
        return error;
    }
    mip_get_double(&value->tow, field->data);
    value->week_number = mip_get_16(field->data + 8);
    value->sbas_system = mip_get_8(field->data + 10);
    value->sbas_id = mip_get_8(field->data + 11);
    value->count = mip_get_8(field->data + 12);
    value->sbas_status = mip_get_8(field->data + 13);
    value->valid_flags = mip_get_16(field->data + 14);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_sbas_info_encode_inline(
    const struct mip_gnss_data_sbas_info *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x12, 16, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_double(data, &value->tow);
    mip_put_16(data + 8, value->week_number);
    mip_put_8(data + 10, value->sbas_system);
    mip_put_8(data + 11, value->sbas_id);
    mip_put_8(data + 12, value->count);
    mip_put_8(data + 13, value->sbas_status);
    mip_put_16(data + 14, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_sbas_correction_decode_inline(
    struct mip_gnss_data_sbas_correction *value, const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x13, 25)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 25)) {
        return error;
    }
    value->index = mip_get_8(field->data);
    value->count = mip_get_8(field->data + 1);
    mip_get_double(&value->tow, field->data + 2);
    value->week_number = mip_get_16(field->data + 10);
    value->gnss_id = mip_get_8(field->data + 12);
    value->satellite_id = mip_get_8(field->data + 13);
    value->udrei = mip_get_8(field->data + 14);
    mip_get_float(&value->pseudorange_correction, field->data + 15);
    mip_get_float(&value->iono_correction, field->data + 19);
    value->valid_flags = mip_get_16(field->data + 23);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_sbas_correction_encode_inline(
    const struct mip_gnss_data_sbas_correction *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x13, 25, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->index);
    mip_put_8(data + 1, value->count);
    mip_put_double(data + 2, &value->tow);
    mip_put_16(data + 10, value->week_number);
    mip_put_8(data + 12, value->gnss_id);
    mip_put_8(data + 13, value->satellite_id);
    mip_put_8(data + 14, value->udrei);
    mip_put_float(data + 15, &value->pseudorange_correction);
    mip_put_float(data + 19, &value->iono_correction);
    mip_put_16(data + 23, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_rf_error_detection_decode_inline(
    struct mip_gnss_data_rf_error_detection *value, const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x14, 9)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 9)) {
        return error;
    }
    value->rf_band = mip_get_8(field->data);
    value->jamming_state = mip_get_8(field->data + 1);
    value->spoofing_state = mip_get_8(field->data + 2);
    value->frequency = mip_get_16(field->data + 3);
    memcpy(value->reserved, field->data + 5, 2);
    value->valid_flags = mip_get_16(field->data + 7);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_rf_error_detection_encode_inline(
    const struct mip_gnss_data_rf_error_detection *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x14, 9, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->rf_band);
    mip_put_8(data + 1, value->jamming_state);
    mip_put_8(data + 2, value->spoofing_state);
    mip_put_16(data + 3, value->frequency);
    memcpy(data + 5, value->reserved, 2);
    mip_put_16(data + 7, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_heading_decode_inline(struct mip_gnss_data_heading *value,
                                                            const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x15, 11)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 11)) {
        return error;
    }
    mip_get_float(&value->heading, field->data);
    mip_get_float(&value->uncertainty, field->data + 4);
    value->fix_type = mip_get_8(field->data + 8);
    value->valid_flags = mip_get_16(field->data + 9);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_heading_encode_inline(
    const struct mip_gnss_data_heading *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x15, 11, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_float(data, &value->heading);
    mip_put_float(data + 4, &value->uncertainty);
    mip_put_8(data + 8, value->fix_type);
    mip_put_16(data + 9, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_satellite_status_decode_inline(
    struct mip_gnss_data_satellite_status *value, const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x20, 25)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 25)) {
        return error;
    }
    value->index = mip_get_8(field->data);
    value->count = mip_get_8(field->data + 1);
    mip_get_double(&value->tow, field->data + 2);
    value->week_number = mip_get_16(field->data + 10);
    value->gnss_id = mip_get_8(field->data + 12);
    value->satellite_id = mip_get_8(field->data + 13);
    mip_get_float(&value->elevation, field->data + 14);
    mip_get_float(&value->azimuth, field->data + 18);
    value->health = mip_get_8(field->data + 22);
    value->valid_flags = mip_get_16(field->data + 23);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_satellite_status_encode_inline(
    const struct mip_gnss_data_satellite_status *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x20, 25, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->index);
    mip_put_8(data + 1, value->count);
    mip_put_double(data + 2, &value->tow);
    mip_put_16(data + 10, value->week_number);
    mip_put_8(data + 12, value->gnss_id);
    mip_put_8(data + 13, value->satellite_id);
    mip_put_float(data + 14, &value->elevation);
    mip_put_float(data + 18, &value->azimuth);
    mip_put_8(data + 22, value->health);
    mip_put_16(data + 23, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_raw_decode_inline(struct mip_gnss_data_raw *value,
                                                        const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x22, 61)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 61)) {
        return error;
    }
    value->index = mip_get_8(field->data);
    value->count = mip_get_8(field->data + 1);
    mip_get_double(&value->tow, field->data + 2);
    value->week_number = mip_get_16(field->data + 10);
    value->receiver_id = mip_get_16(field->data + 12);
    value->tracking_channel = mip_get_8(field->data + 14);
    value->gnss_id = mip_get_8(field->data + 15);
    value->satellite_id = mip_get_8(field->data + 16);
    value->signal_id = mip_get_8(field->data + 17);
    mip_get_float(&value->signal_strength, field->data + 18);
    value->quality = mip_get_8(field->data + 22);
    mip_get_double(&value->pseudorange, field->data + 23);
    mip_get_double(&value->carrier_phase, field->data + 31);
    mip_get_float(&value->doppler, field->data + 39);
    mip_get_float(&value->range_uncertainty, field->data + 43);
    mip_get_float(&value->phase_uncertainty, field->data + 47);
    mip_get_float(&value->doppler_uncertainty, field->data + 51);
    mip_get_float(&value->lock_time, field->data + 55);
    value->valid_flags = mip_get_16(field->data + 59);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_raw_encode_inline(
    const struct mip_gnss_data_raw *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x22, 61, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->index);
    mip_put_8(data + 1, value->count);
    mip_put_double(data + 2, &value->tow);
    mip_put_16(data + 10, value->week_number);
    mip_put_16(data + 12, value->receiver_id);
    mip_put_8(data + 14, value->tracking_channel);
    mip_put_8(data + 15, value->gnss_id);
    mip_put_8(data + 16, value->satellite_id);
    mip_put_8(data + 17, value->signal_id);
    mip_put_float(data + 18, &value->signal_strength);
    mip_put_8(data + 22, value->quality);
    mip_put_double(data + 23, &value->pseudorange);
    mip_put_double(data + 31, &value->carrier_phase);
    mip_put_float(data + 39, &value->doppler);
    mip_put_float(data + 43, &value->range_uncertainty);
    mip_put_float(data + 47, &value->phase_uncertainty);
    mip_put_float(data + 51, &value->doppler_uncertainty);
    mip_put_float(data + 55, &value->lock_time);
    mip_put_16(data + 59, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_base_station_info_decode_inline(
    struct mip_gnss_data_base_station_info *value, const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x30, 44)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 44)) {
        return error;
    }
    mip_get_double(&value->tow, field->data);
    value->week_number = mip_get_16(field->data + 8);
    for (size_t i = 0; i < 3; i++) {
        mip_get_double(&value->ecef_position[i], field->data + 10 + 8 * i);
    }
    mip_get_float(&value->height, field->data + 34);
    value->station_id = mip_get_16(field->data + 38);
    value->indicators = mip_get_16(field->data + 40);
    value->valid_flags = mip_get_16(field->data + 42);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_base_station_info_encode_inline(
    const struct mip_gnss_data_base_station_info *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x30, 44, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_double(data, &value->tow);
    mip_put_16(data + 8, value->week_number);
    for (size_t i = 0; i < 3; i++) {
        mip_put_double(data + 10 + 8 * i, &value->ecef_position[i]);
    }
    mip_put_float(data + 34, &value->height);
    mip_put_16(data + 38, value->station_id);
    mip_put_16(data + 40, value->indicators);
    mip_put_16(data + 42, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_rtk_corrections_status_decode_inline(
    struct mip_gnss_data_rtk_corrections_status *value, const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x31, 50)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 50)) {
        return error;
    }
    mip_get_double(&value->tow, field->data);
    value->week_number = mip_get_16(field->data + 8);
    value->epoch_status = mip_get_16(field->data + 10);
    value->dongle_status = mip_get_32(field->data + 12);
    mip_get_float(&value->gps_correction_latency, field->data + 16);
    mip_get_float(&value->glonass_correction_latency, field->data + 20);
    mip_get_float(&value->galileo_correction_latency, field->data + 24);
    mip_get_float(&value->beidou_correction_latency, field->data + 28);
    for (size_t i = 0; i < 4; i++) {
        value->reserved[i] = mip_get_32(field->data + 32 + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 48);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_rtk_corrections_status_encode_inline(
    const struct mip_gnss_data_rtk_corrections_status *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x31, 50, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_double(data, &value->tow);
    mip_put_16(data + 8, value->week_number);
    mip_put_16(data + 10, value->epoch_status);
    mip_put_32(data + 12, value->dongle_status);
    mip_put_float(data + 16, &value->gps_correction_latency);
    mip_put_float(data + 20, &value->glonass_correction_latency);
    mip_put_float(data + 24, &value->galileo_correction_latency);
    mip_put_float(data + 28, &value->beidou_correction_latency);
    for (size_t i = 0; i < 4; i++) {
        mip_put_32(data + 32 + 4 * i, value->reserved[i]);
    }
    mip_put_16(data + 48, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_gps_ephemeris_decode_inline(
    struct mip_gnss_data_gps_ephemeris *value, const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x61, 218)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 218)) {
        return error;
    }
    value->index = mip_get_8(field->data);
    value->count = mip_get_8(field->data + 1);
    mip_get_double(&value->tow, field->data + 2);
    value->week_number = mip_get_16(field->data + 10);
    value->satellite_id = mip_get_8(field->data + 12);
    value->health = mip_get_8(field->data + 13);
    value->iodc = mip_get_8(field->data + 14);
    value->iode = mip_get_8(field->data + 15);
    mip_get_double(&value->t_oc, field->data + 16);
    mip_get_double(&value->af0, field->data + 24);
    mip_get_double(&value->af1, field->data + 32);
    mip_get_double(&value->af2, field->data + 40);
    mip_get_double(&value->t_gd, field->data + 48);
    mip_get_double(&value->isc_l1ca, field->data + 56);
    mip_get_double(&value->isc_l2c, field->data + 64);
    mip_get_double(&value->t_oe, field->data + 72);
    mip_get_double(&value->a, field->data + 80);
    mip_get_double(&value->a_dot, field->data + 88);
    mip_get_double(&value->mean_anomaly, field->data + 96);
    mip_get_double(&value->delta_mean_motion, field->data + 104);
    mip_get_double(&value->delta_mean_motion_dot, field->data + 112);
    mip_get_double(&value->eccentricity, field->data + 120);
    mip_get_double(&value->argument_of_perigee, field->data + 128);
    mip_get_double(&value->omega, field->data + 136);
    mip_get_double(&value->omega_dot, field->data + 144);
    mip_get_double(&value->inclination, field->data + 152);
    mip_get_double(&value->inclination_dot, field->data + 160);
    mip_get_double(&value->c_ic, field->data + 168);
    mip_get_double(&value->c_is, field->data + 176);
    mip_get_double(&value->c_uc, field->data + 184);
    mip_get_double(&value->c_us, field->data + 192);
    mip_get_double(&value->c_rc, field->data + 200);
    mip_get_double(&value->c_rs, field->data + 208);
    value->valid_flags = mip_get_16(field->data + 216);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_gps_ephemeris_encode_inline(
    const struct mip_gnss_data_gps_ephemeris *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x61, 218, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->index);
    mip_put_8(data + 1, value->count);
    mip_put_double(data + 2, &value->tow);
    mip_put_16(data + 10, value->week_number);
    mip_put_8(data + 12, value->satellite_id);
    mip_put_8(data + 13, value->health);
    mip_put_8(data + 14, value->iodc);
    mip_put_8(data + 15, value->iode);
    mip_put_double(data + 16, &value->t_oc);
    mip_put_double(data + 24, &value->af0);
    mip_put_double(data + 32, &value->af1);
    mip_put_double(data + 40, &value->af2);
    mip_put_double(data + 48, &value->t_gd);
    mip_put_double(data + 56, &value->isc_l1ca);
    mip_put_double(data + 64, &value->isc_l2c);
    mip_put_double(data + 72, &value->t_oe);
    mip_put_double(data + 80, &value->a);
    mip_put_double(data + 88, &value->a_dot);
    mip_put_double(data + 96, &value->mean_anomaly);
    mip_put_double(data + 104, &value->delta_mean_motion);
    mip_put_double(data + 112, &value->delta_mean_motion_dot);
    mip_put_double(data + 120, &value->eccentricity);
    mip_put_double(data + 128, &value->argument_of_perigee);
    mip_put_double(data + 136, &value->omega);
    mip_put_double(data + 144, &value->omega_dot);
    mip_put_double(data + 152, &value->inclination);
    mip_put_double(data + 160, &value->inclination_dot);
    mip_put_double(data + 168, &value->c_ic);
    mip_put_double(data + 176, &value->c_is);
    mip_put_double(data + 184, &value->c_uc);
    mip_put_double(data + 192, &value->c_us);
    mip_put_double(data + 200, &value->c_rc);
    mip_put_double(data + 208, &value->c_rs);
    mip_put_16(data + 216, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_glonass_ephemeris_decode_inline(
    struct mip_gnss_data_glonass_ephemeris *value, const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x62, 102)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 102)) {
        return error;
    }
    value->index = mip_get_8(field->data);
    value->count = mip_get_8(field->data + 1);
    mip_get_double(&value->tow, field->data + 2);
    value->week_number = mip_get_16(field->data + 10);
    value->satellite_id = mip_get_8(field->data + 12);
    value->frequency_number = (int8_t)mip_get_8(field->data + 13);
    value->tk = mip_get_32(field->data + 14);
    value->tb = mip_get_32(field->data + 18);
    value->satellite_type = mip_get_8(field->data + 22);
    mip_get_double(&value->gamma, field->data + 23);
    mip_get_double(&value->tau_n, field->data + 31);
    for (size_t i = 0; i < 3; i++) {
        mip_get_double(&value->position[i], field->data + 39 + 8 * i);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->velocity[i], field->data + 63 + 4 * i);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->accel[i], field->data + 75 + 4 * i);
    }
    value->health = mip_get_8(field->data + 87);
    value->p = mip_get_8(field->data + 88);
    value->nt = mip_get_8(field->data + 89);
    mip_get_float(&value->delta_tau_n, field->data + 90);
    value->ft = mip_get_8(field->data + 94);
    value->en = mip_get_8(field->data + 95);
    value->p1 = mip_get_8(field->data + 96);
    value->p2 = mip_get_8(field->data + 97);
    value->p3 = mip_get_8(field->data + 98);
    value->p4 = mip_get_8(field->data + 99);
    value->valid_flags = mip_get_16(field->data + 100);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_glonass_ephemeris_encode_inline(
    const struct mip_gnss_data_glonass_ephemeris *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x62, 102, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->index);
    mip_put_8(data + 1, value->count);
    mip_put_double(data + 2, &value->tow);
    mip_put_16(data + 10, value->week_number);
    mip_put_8(data + 12, value->satellite_id);
    mip_put_8(data + 13, (uint8_t)value->frequency_number);
    mip_put_32(data + 14, value->tk);
    mip_put_32(data + 18, value->tb);
    mip_put_8(data + 22, value->satellite_type);
    mip_put_double(data + 23, &value->gamma);
    mip_put_double(data + 31, &value->tau_n);
    for (size_t i = 0; i < 3; i++) {
        mip_put_double(data + 39 + 8 * i, &value->position[i]);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 63 + 4 * i, &value->velocity[i]);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 75 + 4 * i, &value->accel[i]);
    }
    mip_put_8(data + 87, value->health);
    mip_put_8(data + 88, value->p);
    mip_put_8(data + 89, value->nt);
    mip_put_float(data + 90, &value->delta_tau_n);
    mip_put_8(data + 94, value->ft);
    mip_put_8(data + 95, value->en);
    mip_put_8(data + 96, value->p1);
    mip_put_8(data + 97, value->p2);
    mip_put_8(data + 98, value->p3);
    mip_put_8(data + 99, value->p4);
    mip_put_16(data + 100, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_galileo_ephemeris_decode_inline(
    struct mip_gnss_data_galileo_ephemeris *value, const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x63, 218)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 218)) {
        return error;
    }
    value->index = mip_get_8(field->data);
    value->count = mip_get_8(field->data + 1);
    mip_get_double(&value->tow, field->data + 2);
    value->week_number = mip_get_16(field->data + 10);
    value->satellite_id = mip_get_8(field->data + 12);
    value->health = mip_get_8(field->data + 13);
    value->iodc = mip_get_8(field->data + 14);
    value->iode = mip_get_8(field->data + 15);
    mip_get_double(&value->t_oc, field->data + 16);
    mip_get_double(&value->af0, field->data + 24);
    mip_get_double(&value->af1, field->data + 32);
    mip_get_double(&value->af2, field->data + 40);
    mip_get_double(&value->t_gd, field->data + 48);
    mip_get_double(&value->isc_l1ca, field->data + 56);
    mip_get_double(&value->isc_l2c, field->data + 64);
    mip_get_double(&value->t_oe, field->data + 72);
    mip_get_double(&value->a, field->data + 80);
    mip_get_double(&value->a_dot, field->data + 88);
    mip_get_double(&value->mean_anomaly, field->data + 96);
    mip_get_double(&value->delta_mean_motion, field->data + 104);
    mip_get_double(&value->delta_mean_motion_dot, field->data + 112);
    mip_get_double(&value->eccentricity, field->data + 120);
    mip_get_double(&value->argument_of_perigee, field->data + 128);
    mip_get_double(&value->omega, field->data + 136);
    mip_get_double(&value->omega_dot, field->data + 144);
    mip_get_double(&value->inclination, field->data + 152);
    mip_get_double(&value->inclination_dot, field->data + 160);
    mip_get_double(&value->c_ic, field->data + 168);
    mip_get_double(&value->c_is, field->data + 176);
    mip_get_double(&value->c_uc, field->data + 184);
    mip_get_double(&value->c_us, field->data + 192);
    mip_get_double(&value->c_rc, field->data + 200);
    mip_get_double(&value->c_rs, field->data + 208);
    value->valid_flags = mip_get_16(field->data + 216);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_galileo_ephemeris_encode_inline(
    const struct mip_gnss_data_galileo_ephemeris *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x63, 218, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->index);
    mip_put_8(data + 1, value->count);
    mip_put_double(data + 2, &value->tow);
    mip_put_16(data + 10, value->week_number);
    mip_put_8(data + 12, value->satellite_id);
    mip_put_8(data + 13, value->health);
    mip_put_8(data + 14, value->iodc);
    mip_put_8(data + 15, value->iode);
    mip_put_double(data + 16, &value->t_oc);
    mip_put_double(data + 24, &value->af0);
    mip_put_double(data + 32, &value->af1);
    mip_put_double(data + 40, &value->af2);
    mip_put_double(data + 48, &value->t_gd);
    mip_put_double(data + 56, &value->isc_l1ca);
    mip_put_double(data + 64, &value->isc_l2c);
    mip_put_double(data + 72, &value->t_oe);
    mip_put_double(data + 80, &value->a);
    mip_put_double(data + 88, &value->a_dot);
    mip_put_double(data + 96, &value->mean_anomaly);
    mip_put_double(data + 104, &value->delta_mean_motion);
    mip_put_double(data + 112, &value->delta_mean_motion_dot);
    mip_put_double(data + 120, &value->eccentricity);
    mip_put_double(data + 128, &value->argument_of_perigee);
    mip_put_double(data + 136, &value->omega);
    mip_put_double(data + 144, &value->omega_dot);
    mip_put_double(data + 152, &value->inclination);
    mip_put_double(data + 160, &value->inclination_dot);
    mip_put_double(data + 168, &value->c_ic);
    mip_put_double(data + 176, &value->c_is);
    mip_put_double(data + 184, &value->c_uc);
    mip_put_double(data + 192, &value->c_us);
    mip_put_double(data + 200, &value->c_rc);
    mip_put_double(data + 208, &value->c_rs);
    mip_put_16(data + 216, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_beidou_ephemeris_decode_inline(
    struct mip_gnss_data_beidou_ephemeris *value, const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x64, 218)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 218)) {
        return error;
    }
    value->index = mip_get_8(field->data);
    value->count = mip_get_8(field->data + 1);
    mip_get_double(&value->tow, field->data + 2);
    value->week_number = mip_get_16(field->data + 10);
    value->satellite_id = mip_get_8(field->data + 12);
    value->health = mip_get_8(field->data + 13);
    value->iodc = mip_get_8(field->data + 14);
    value->iode = mip_get_8(field->data + 15);
    mip_get_double(&value->t_oc, field->data + 16);
    mip_get_double(&value->af0, field->data + 24);
    mip_get_double(&value->af1, field->data + 32);
    mip_get_double(&value->af2, field->data + 40);
    mip_get_double(&value->t_gd, field->data + 48);
    mip_get_double(&value->isc_l1ca, field->data + 56);
    mip_get_double(&value->isc_l2c, field->data + 64);
    mip_get_double(&value->t_oe, field->data + 72);
    mip_get_double(&value->a, field->data + 80);
    mip_get_double(&value->a_dot, field->data + 88);
    mip_get_double(&value->mean_anomaly, field->data + 96);
    mip_get_double(&value->delta_mean_motion, field->data + 104);
    mip_get_double(&value->delta_mean_motion_dot, field->data + 112);
    mip_get_double(&value->eccentricity, field->data + 120);
    mip_get_double(&value->argument_of_perigee, field->data + 128);
    mip_get_double(&value->omega, field->data + 136);
    mip_get_double(&value->omega_dot, field->data + 144);
    mip_get_double(&value->inclination, field->data + 152);
    mip_get_double(&value->inclination_dot, field->data + 160);
    mip_get_double(&value->c_ic, field->data + 168);
    mip_get_double(&value->c_is, field->data + 176);
    mip_get_double(&value->c_uc, field->data + 184);
    mip_get_double(&value->c_us, field->data + 192);
    mip_get_double(&value->c_rc, field->data + 200);
    mip_get_double(&value->c_rs, field->data + 208);
    value->valid_flags = mip_get_16(field->data + 216);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_beidou_ephemeris_encode_inline(
    const struct mip_gnss_data_beidou_ephemeris *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x64, 218, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->index);
    mip_put_8(data + 1, value->count);
    mip_put_double(data + 2, &value->tow);
    mip_put_16(data + 10, value->week_number);
    mip_put_8(data + 12, value->satellite_id);
    mip_put_8(data + 13, value->health);
    mip_put_8(data + 14, value->iodc);
    mip_put_8(data + 15, value->iode);
    mip_put_double(data + 16, &value->t_oc);
    mip_put_double(data + 24, &value->af0);
    mip_put_double(data + 32, &value->af1);
    mip_put_double(data + 40, &value->af2);
    mip_put_double(data + 48, &value->t_gd);
    mip_put_double(data + 56, &value->isc_l1ca);
    mip_put_double(data + 64, &value->isc_l2c);
    mip_put_double(data + 72, &value->t_oe);
    mip_put_double(data + 80, &value->a);
    mip_put_double(data + 88, &value->a_dot);
    mip_put_double(data + 96, &value->mean_anomaly);
    mip_put_double(data + 104, &value->delta_mean_motion);
    mip_put_double(data + 112, &value->delta_mean_motion_dot);
    mip_put_double(data + 120, &value->eccentricity);
    mip_put_double(data + 128, &value->argument_of_perigee);
    mip_put_double(data + 136, &value->omega);
    mip_put_double(data + 144, &value->omega_dot);
    mip_put_double(data + 152, &value->inclination);
    mip_put_double(data + 160, &value->inclination_dot);
    mip_put_double(data + 168, &value->c_ic);
    mip_put_double(data + 176, &value->c_is);
    mip_put_double(data + 184, &value->c_uc);
    mip_put_double(data + 192, &value->c_us);
    mip_put_double(data + 200, &value->c_rc);
    mip_put_double(data + 208, &value->c_rs);
    mip_put_16(data + 216, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_gps_iono_correction_decode_inline(
    struct mip_gnss_data_gps_iono_correction *value, const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x71, 76)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 76)) {
        return error;
    }
    mip_get_double(&value->tow, field->data);
    value->week_number = mip_get_16(field->data + 8);
    for (size_t i = 0; i < 4; i++) {
        mip_get_double(&value->alpha[i], field->data + 10 + 8 * i);
    }
    for (size_t i = 0; i < 4; i++) {
        mip_get_double(&value->beta[i], field->data + 42 + 8 * i);
    }
    value->valid_flags = mip_get_16(field->data + 74);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_gps_iono_correction_encode_inline(
    const struct mip_gnss_data_gps_iono_correction *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x71, 76, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_double(data, &value->tow);
    mip_put_16(data + 8, value->week_number);
    for (size_t i = 0; i < 4; i++) {
        mip_put_double(data + 10 + 8 * i, &value->alpha[i]);
    }
    for (size_t i = 0; i < 4; i++) {
        mip_put_double(data + 42 + 8 * i, &value->beta[i]);
    }
    mip_put_16(data + 74, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_galileo_iono_correction_decode_inline(
    struct mip_gnss_data_galileo_iono_correction *value, const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x73, 37)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 37)) {
        return error;
    }
    mip_get_double(&value->tow, field->data);
    value->week_number = mip_get_16(field->data + 8);
    for (size_t i = 0; i < 3; i++) {
        mip_get_double(&value->alpha[i], field->data + 10 + 8 * i);
    }
    value->disturbance_flags = mip_get_8(field->data + 34);
    value->valid_flags = mip_get_16(field->data + 35);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_galileo_iono_correction_encode_inline(
    const struct mip_gnss_data_galileo_iono_correction *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x73, 37, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_double(data, &value->tow);
    mip_put_16(data + 8, value->week_number);
    for (size_t i = 0; i < 3; i++) {
        mip_put_double(data + 10 + 8 * i, &value->alpha[i]);
    }
    mip_put_8(data + 34, value->disturbance_flags);
    mip_put_16(data + 35, value->valid_flags);
    return MIP_OK;
}

static inline mip_error mip_gnss_data_beidou_iono_correction_decode_inline(
    struct mip_gnss_data_beidou_iono_correction *value, const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_field_check(field, set, 0x74, 148)
                                : MIP_ERROR_SET;
    if (mip_cleared(error, value, sizeof(*value), 148)) {
        return error;
    }
    mip_get_double(&value->tow, field->data);
    value->week_number = mip_get_16(field->data + 8);
    for (size_t i = 0; i < 4; i++) {
        mip_get_double(&value->alpha[i], field->data + 10 + 8 * i);
    }
    for (size_t i = 0; i < 4; i++) {
        mip_get_double(&value->beta[i], field->data + 42 + 8 * i);
    }
    for (size_t i = 0; i < 9; i++) {
        mip_get_double(&value->alpha_correction[i], field->data + 74 + 8 * i);
    }
    value->valid_flags = mip_get_16(field->data + 146);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_gnss_data_beidou_iono_correction_encode_inline(
    const struct mip_gnss_data_beidou_iono_correction *value, struct mip_builder *builder) {
    uint8_t *data = NULL;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x81 || (set >= 0x91 && set <= 0x95)
                                ? mip_builder_reserve(builder, set, 0x74, 148, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_double(data, &value->tow);
    mip_put_16(data + 8, value->week_number);
    for (size_t i = 0; i < 4; i++) {
        mip_put_double(data + 10 + 8 * i, &value->alpha[i]);
    }
    for (size_t i = 0; i < 4; i++) {
        mip_put_double(data + 42 + 8 * i, &value->beta[i]);
    }
    for (size_t i = 0; i < 9; i++) {
        mip_put_double(data + 74 + 8 * i, &value->alpha_correction[i]);
    }
    mip_put_16(data + 146, value->valid_flags);
    return MIP_OK;
}

#ifdef __cplusplus
}
#endif

#endif
