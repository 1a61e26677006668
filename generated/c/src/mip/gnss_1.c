/* GNSS receiver 1 data. */
#include "mip/gnss_1.h"

#include <string.h>

static void read_llh_position(struct mip_reader *r, void *value) {
    struct mip_gnss_1_llh_position *v = (struct mip_gnss_1_llh_position *)value;
    mip_read_double(r, &v->latitude, 1);
    mip_read_double(r, &v->longitude, 1);
    mip_read_double(r, &v->ellipsoid_height, 1);
    mip_read_double(r, &v->msl_height, 1);
    mip_read_float(r, &v->horizontal_accuracy, 1);
    mip_read_float(r, &v->vertical_accuracy, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_llh_position(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_llh_position *v = (const struct mip_gnss_1_llh_position *)value;
    mip_write_double(w, &v->latitude, 1);
    mip_write_double(w, &v->longitude, 1);
    mip_write_double(w, &v->ellipsoid_height, 1);
    mip_write_double(w, &v->msl_height, 1);
    mip_write_float(w, &v->horizontal_accuracy, 1);
    mip_write_float(w, &v->vertical_accuracy, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_llh_position_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_LLH_POSITION_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_llh_position),
    0, /* time-out */
    read_llh_position,
    write_llh_position,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_llh_position_decode(struct mip_gnss_1_llh_position *value,
                                         const struct mip_field *field) {
    return mip_decode_field(field, read_llh_position, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_llh_position_encode(const struct mip_gnss_1_llh_position *value,
                                         struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_LLH_POSITION_DESCRIPTOR, write_llh_position,
                            value);
}

static void read_ecef_position(struct mip_reader *r, void *value) {
    struct mip_gnss_1_ecef_position *v = (struct mip_gnss_1_ecef_position *)value;
    mip_read_double(r, v->position, 3);
    mip_read_float(r, &v->position_accuracy, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_ecef_position(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_ecef_position *v = (const struct mip_gnss_1_ecef_position *)value;
    mip_write_double(w, v->position, 3);
    mip_write_float(w, &v->position_accuracy, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_ecef_position_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_ECEF_POSITION_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_ecef_position),
    0, /* time-out */
    read_ecef_position,
    write_ecef_position,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_ecef_position_decode(struct mip_gnss_1_ecef_position *value,
                                          const struct mip_field *field) {
    return mip_decode_field(field, read_ecef_position, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_ecef_position_encode(const struct mip_gnss_1_ecef_position *value,
                                          struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_ECEF_POSITION_DESCRIPTOR, write_ecef_position,
                            value);
}

static void read_ned_velocity(struct mip_reader *r, void *value) {
    struct mip_gnss_1_ned_velocity *v = (struct mip_gnss_1_ned_velocity *)value;
    mip_read_float(r, v->velocity, 3);
    mip_read_float(r, &v->speed, 1);
    mip_read_float(r, &v->ground_speed, 1);
    mip_read_float(r, &v->heading, 1);
    mip_read_float(r, &v->speed_accuracy, 1);
    mip_read_float(r, &v->heading_accuracy, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_ned_velocity(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_ned_velocity *v = (const struct mip_gnss_1_ned_velocity *)value;
    mip_write_float(w, v->velocity, 3);
    mip_write_float(w, &v->speed, 1);
    mip_write_float(w, &v->ground_speed, 1);
    mip_write_float(w, &v->heading, 1);
    mip_write_float(w, &v->speed_accuracy, 1);
    mip_write_float(w, &v->heading_accuracy, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_ned_velocity_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_NED_VELOCITY_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_ned_velocity),
    0, /* time-out */
    read_ned_velocity,
    write_ned_velocity,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_ned_velocity_decode(struct mip_gnss_1_ned_velocity *value,
                                         const struct mip_field *field) {
    return mip_decode_field(field, read_ned_velocity, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_ned_velocity_encode(const struct mip_gnss_1_ned_velocity *value,
                                         struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_NED_VELOCITY_DESCRIPTOR, write_ned_velocity,
                            value);
}

static void read_ecef_velocity(struct mip_reader *r, void *value) {
    struct mip_gnss_1_ecef_velocity *v = (struct mip_gnss_1_ecef_velocity *)value;
    mip_read_float(r, v->velocity, 3);
    mip_read_float(r, &v->velocity_accuracy, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_ecef_velocity(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_ecef_velocity *v = (const struct mip_gnss_1_ecef_velocity *)value;
    mip_write_float(w, v->velocity, 3);
    mip_write_float(w, &v->velocity_accuracy, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_ecef_velocity_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_ECEF_VELOCITY_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_ecef_velocity),
    0, /* time-out */
    read_ecef_velocity,
    write_ecef_velocity,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_ecef_velocity_decode(struct mip_gnss_1_ecef_velocity *value,
                                          const struct mip_field *field) {
    return mip_decode_field(field, read_ecef_velocity, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_ecef_velocity_encode(const struct mip_gnss_1_ecef_velocity *value,
                                          struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_ECEF_VELOCITY_DESCRIPTOR, write_ecef_velocity,
                            value);
}

static void read_dop(struct mip_reader *r, void *value) {
    struct mip_gnss_1_dop *v = (struct mip_gnss_1_dop *)value;
    mip_read_float(r, &v->gdop, 1);
    mip_read_float(r, &v->pdop, 1);
    mip_read_float(r, &v->hdop, 1);
    mip_read_float(r, &v->vdop, 1);
    mip_read_float(r, &v->tdop, 1);
    mip_read_float(r, &v->ndop, 1);
    mip_read_float(r, &v->edop, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_dop(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_dop *v = (const struct mip_gnss_1_dop *)value;
    mip_write_float(w, &v->gdop, 1);
    mip_write_float(w, &v->pdop, 1);
    mip_write_float(w, &v->hdop, 1);
    mip_write_float(w, &v->vdop, 1);
    mip_write_float(w, &v->tdop, 1);
    mip_write_float(w, &v->ndop, 1);
    mip_write_float(w, &v->edop, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_dop_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_DOP_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_dop),
    0, /* time-out */
    read_dop,
    write_dop,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_dop_decode(struct mip_gnss_1_dop *value, const struct mip_field *field) {
    return mip_decode_field(field, read_dop, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_dop_encode(const struct mip_gnss_1_dop *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_DOP_DESCRIPTOR, write_dop, value);
}

static void read_utc_time(struct mip_reader *r, void *value) {
    struct mip_gnss_1_utc_time *v = (struct mip_gnss_1_utc_time *)value;
    mip_read_u16(r, &v->year, 1);
    mip_read_u8(r, &v->month, 1);
    mip_read_u8(r, &v->day, 1);
    mip_read_u8(r, &v->hour, 1);
    mip_read_u8(r, &v->min, 1);
    mip_read_u8(r, &v->sec, 1);
    mip_read_u32(r, &v->msec, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_utc_time(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_utc_time *v = (const struct mip_gnss_1_utc_time *)value;
    mip_write_u16(w, &v->year, 1);
    mip_write_u8(w, &v->month, 1);
    mip_write_u8(w, &v->day, 1);
    mip_write_u8(w, &v->hour, 1);
    mip_write_u8(w, &v->min, 1);
    mip_write_u8(w, &v->sec, 1);
    mip_write_u32(w, &v->msec, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_utc_time_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_UTC_TIME_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_utc_time),
    0, /* time-out */
    read_utc_time,
    write_utc_time,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_utc_time_decode(struct mip_gnss_1_utc_time *value,
                                     const struct mip_field *field) {
    return mip_decode_field(field, read_utc_time, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_utc_time_encode(const struct mip_gnss_1_utc_time *value,
                                     struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_UTC_TIME_DESCRIPTOR, write_utc_time, value);
}

static void read_gps_time(struct mip_reader *r, void *value) {
    struct mip_gnss_1_gps_time *v = (struct mip_gnss_1_gps_time *)value;
    mip_read_double(r, &v->tow, 1);
    mip_read_u16(r, &v->week_number, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_gps_time(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_gps_time *v = (const struct mip_gnss_1_gps_time *)value;
    mip_write_double(w, &v->tow, 1);
    mip_write_u16(w, &v->week_number, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_gps_time_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_GPS_TIME_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_gps_time),
    0, /* time-out */
    read_gps_time,
    write_gps_time,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_gps_time_decode(struct mip_gnss_1_gps_time *value,
                                     const struct mip_field *field) {
    return mip_decode_field(field, read_gps_time, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_gps_time_encode(const struct mip_gnss_1_gps_time *value,
                                     struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_GPS_TIME_DESCRIPTOR, write_gps_time, value);
}

static void read_clock_info(struct mip_reader *r, void *value) {
    struct mip_gnss_1_clock_info *v = (struct mip_gnss_1_clock_info *)value;
    mip_read_double(r, &v->bias, 1);
    mip_read_double(r, &v->drift, 1);
    mip_read_double(r, &v->accuracy_estimate, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_clock_info(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_clock_info *v = (const struct mip_gnss_1_clock_info *)value;
    mip_write_double(w, &v->bias, 1);
    mip_write_double(w, &v->drift, 1);
    mip_write_double(w, &v->accuracy_estimate, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_clock_info_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_CLOCK_INFO_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_clock_info),
    0, /* time-out */
    read_clock_info,
    write_clock_info,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_clock_info_decode(struct mip_gnss_1_clock_info *value,
                                       const struct mip_field *field) {
    return mip_decode_field(field, read_clock_info, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_clock_info_encode(const struct mip_gnss_1_clock_info *value,
                                       struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_CLOCK_INFO_DESCRIPTOR, write_clock_info,
                            value);
}

static void read_fix_info(struct mip_reader *r, void *value) {
    struct mip_gnss_1_fix_info *v = (struct mip_gnss_1_fix_info *)value;
    mip_read_u8(r, &v->fix_type, 1);
    mip_read_u8(r, &v->num_sv, 1);
    mip_read_u16(r, &v->fix_flags, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_fix_info(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_fix_info *v = (const struct mip_gnss_1_fix_info *)value;
    mip_write_u8(w, &v->fix_type, 1);
    mip_write_u8(w, &v->num_sv, 1);
    mip_write_u16(w, &v->fix_flags, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_fix_info_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_FIX_INFO_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_fix_info),
    0, /* time-out */
    read_fix_info,
    write_fix_info,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_fix_info_decode(struct mip_gnss_1_fix_info *value,
                                     const struct mip_field *field) {
    return mip_decode_field(field, read_fix_info, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_fix_info_encode(const struct mip_gnss_1_fix_info *value,
                                     struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_FIX_INFO_DESCRIPTOR, write_fix_info, value);
}

static void read_sv_info(struct mip_reader *r, void *value) {
    struct mip_gnss_1_sv_info *v = (struct mip_gnss_1_sv_info *)value;
    mip_read_u8(r, &v->channel, 1);
    mip_read_u8(r, &v->satellite_id, 1);
    mip_read_u16(r, &v->carrier_noise_ratio, 1);
    mip_read_s16(r, &v->azimuth, 1);
    mip_read_s16(r, &v->elevation, 1);
    mip_read_u16(r, &v->sv_flags, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_sv_info(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_sv_info *v = (const struct mip_gnss_1_sv_info *)value;
    mip_write_u8(w, &v->channel, 1);
    mip_write_u8(w, &v->satellite_id, 1);
    mip_write_u16(w, &v->carrier_noise_ratio, 1);
    mip_write_s16(w, &v->azimuth, 1);
    mip_write_s16(w, &v->elevation, 1);
    mip_write_u16(w, &v->sv_flags, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_sv_info_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_SV_INFO_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_sv_info),
    0, /* time-out */
    read_sv_info,
    write_sv_info,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_sv_info_decode(struct mip_gnss_1_sv_info *value,
                                    const struct mip_field *field) {
    return mip_decode_field(field, read_sv_info, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_sv_info_encode(const struct mip_gnss_1_sv_info *value,
                                    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_SV_INFO_DESCRIPTOR, write_sv_info, value);
}

static void read_hardware_status(struct mip_reader *r, void *value) {
    struct mip_gnss_1_hardware_status *v = (struct mip_gnss_1_hardware_status *)value;
    mip_read_u8(r, &v->receiver_state, 1);
    mip_read_u8(r, &v->antenna_state, 1);
    mip_read_u8(r, &v->antenna_power, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_hardware_status(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_hardware_status *v = (const struct mip_gnss_1_hardware_status *)value;
    mip_write_u8(w, &v->receiver_state, 1);
    mip_write_u8(w, &v->antenna_state, 1);
    mip_write_u8(w, &v->antenna_power, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_hardware_status_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_HARDWARE_STATUS_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_hardware_status),
    0, /* time-out */
    read_hardware_status,
    write_hardware_status,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_hardware_status_decode(struct mip_gnss_1_hardware_status *value,
                                            const struct mip_field *field) {
    return mip_decode_field(field, read_hardware_status, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_hardware_status_encode(const struct mip_gnss_1_hardware_status *value,
                                            struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_HARDWARE_STATUS_DESCRIPTOR,
                            write_hardware_status, value);
}

static void read_dgps_info(struct mip_reader *r, void *value) {
    struct mip_gnss_1_dgps_info *v = (struct mip_gnss_1_dgps_info *)value;
    mip_read_float(r, &v->age, 1);
    mip_read_s16(r, &v->base_station_id, 1);
    mip_read_s16(r, &v->base_station_status, 1);
    mip_read_u16(r, &v->num_channels, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_dgps_info(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_dgps_info *v = (const struct mip_gnss_1_dgps_info *)value;
    mip_write_float(w, &v->age, 1);
    mip_write_s16(w, &v->base_station_id, 1);
    mip_write_s16(w, &v->base_station_status, 1);
    mip_write_u16(w, &v->num_channels, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_dgps_info_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_DGPS_INFO_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_dgps_info),
    0, /* time-out */
    read_dgps_info,
    write_dgps_info,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_dgps_info_decode(struct mip_gnss_1_dgps_info *value,
                                      const struct mip_field *field) {
    return mip_decode_field(field, read_dgps_info, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_dgps_info_encode(const struct mip_gnss_1_dgps_info *value,
                                      struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_DGPS_INFO_DESCRIPTOR, write_dgps_info, value);
}

static void read_dgps_channel(struct mip_reader *r, void *value) {
    struct mip_gnss_1_dgps_channel *v = (struct mip_gnss_1_dgps_channel *)value;
    mip_read_u8(r, &v->satellite_id, 1);
    mip_read_float(r, &v->age, 1);
    mip_read_float(r, &v->range_correction, 1);
    mip_read_float(r, &v->range_rate_correction, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_dgps_channel(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_dgps_channel *v = (const struct mip_gnss_1_dgps_channel *)value;
    mip_write_u8(w, &v->satellite_id, 1);
    mip_write_float(w, &v->age, 1);
    mip_write_float(w, &v->range_correction, 1);
    mip_write_float(w, &v->range_rate_correction, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_dgps_channel_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_DGPS_CHANNEL_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_dgps_channel),
    0, /* time-out */
    read_dgps_channel,
    write_dgps_channel,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_dgps_channel_decode(struct mip_gnss_1_dgps_channel *value,
                                         const struct mip_field *field) {
    return mip_decode_field(field, read_dgps_channel, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_dgps_channel_encode(const struct mip_gnss_1_dgps_channel *value,
                                         struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_DGPS_CHANNEL_DESCRIPTOR, write_dgps_channel,
                            value);
}

static void read_clock_info_2(struct mip_reader *r, void *value) {
    struct mip_gnss_1_clock_info_2 *v = (struct mip_gnss_1_clock_info_2 *)value;
    mip_read_double(r, &v->bias, 1);
    mip_read_double(r, &v->drift, 1);
    mip_read_double(r, &v->bias_accuracy_estimate, 1);
    mip_read_double(r, &v->drift_accuracy_estimate, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_clock_info_2(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_clock_info_2 *v = (const struct mip_gnss_1_clock_info_2 *)value;
    mip_write_double(w, &v->bias, 1);
    mip_write_double(w, &v->drift, 1);
    mip_write_double(w, &v->bias_accuracy_estimate, 1);
    mip_write_double(w, &v->drift_accuracy_estimate, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_clock_info_2_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_CLOCK_INFO_2_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_clock_info_2),
    0, /* time-out */
    read_clock_info_2,
    write_clock_info_2,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_clock_info_2_decode(struct mip_gnss_1_clock_info_2 *value,
                                         const struct mip_field *field) {
    return mip_decode_field(field, read_clock_info_2, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_clock_info_2_encode(const struct mip_gnss_1_clock_info_2 *value,
                                         struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_CLOCK_INFO_2_DESCRIPTOR, write_clock_info_2,
                            value);
}

static void read_gps_leap_seconds(struct mip_reader *r, void *value) {
    struct mip_gnss_1_gps_leap_seconds *v = (struct mip_gnss_1_gps_leap_seconds *)value;
    mip_read_u8(r, &v->leap_seconds, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_gps_leap_seconds(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_gps_leap_seconds *v = (const struct mip_gnss_1_gps_leap_seconds *)value;
    mip_write_u8(w, &v->leap_seconds, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_gps_leap_seconds_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_GPS_LEAP_SECONDS_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_gps_leap_seconds),
    0, /* time-out */
    read_gps_leap_seconds,
    write_gps_leap_seconds,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_gps_leap_seconds_decode(struct mip_gnss_1_gps_leap_seconds *value,
                                             const struct mip_field *field) {
    return mip_decode_field(field, read_gps_leap_seconds, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_gps_leap_seconds_encode(const struct mip_gnss_1_gps_leap_seconds *value,
                                             struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_GPS_LEAP_SECONDS_DESCRIPTOR,
                            write_gps_leap_seconds, value);
}

static void read_sbas_info(struct mip_reader *r, void *value) {
    struct mip_gnss_1_sbas_info *v = (struct mip_gnss_1_sbas_info *)value;
    mip_read_double(r, &v->tow, 1);
    mip_read_u16(r, &v->week_number, 1);
    mip_read_u8(r, &v->sbas_system, 1);
    mip_read_u8(r, &v->sbas_id, 1);
    mip_read_u8(r, &v->count, 1);
    mip_read_u8(r, &v->sbas_status, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_sbas_info(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_sbas_info *v = (const struct mip_gnss_1_sbas_info *)value;
    mip_write_double(w, &v->tow, 1);
    mip_write_u16(w, &v->week_number, 1);
    mip_write_u8(w, &v->sbas_system, 1);
    mip_write_u8(w, &v->sbas_id, 1);
    mip_write_u8(w, &v->count, 1);
    mip_write_u8(w, &v->sbas_status, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_sbas_info_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_SBAS_INFO_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_sbas_info),
    0, /* time-out */
    read_sbas_info,
    write_sbas_info,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_sbas_info_decode(struct mip_gnss_1_sbas_info *value,
                                      const struct mip_field *field) {
    return mip_decode_field(field, read_sbas_info, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_sbas_info_encode(const struct mip_gnss_1_sbas_info *value,
                                      struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_SBAS_INFO_DESCRIPTOR, write_sbas_info, value);
}

static void read_sbas_correction(struct mip_reader *r, void *value) {
    struct mip_gnss_1_sbas_correction *v = (struct mip_gnss_1_sbas_correction *)value;
    mip_read_u8(r, &v->index, 1);
    mip_read_u8(r, &v->count, 1);
    mip_read_double(r, &v->tow, 1);
    mip_read_u16(r, &v->week_number, 1);
    mip_read_u8(r, &v->gnss_id, 1);
    mip_read_u8(r, &v->satellite_id, 1);
    mip_read_u8(r, &v->udrei, 1);
    mip_read_float(r, &v->pseudorange_correction, 1);
    mip_read_float(r, &v->iono_correction, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_sbas_correction(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_sbas_correction *v = (const struct mip_gnss_1_sbas_correction *)value;
    mip_write_u8(w, &v->index, 1);
    mip_write_u8(w, &v->count, 1);
    mip_write_double(w, &v->tow, 1);
    mip_write_u16(w, &v->week_number, 1);
    mip_write_u8(w, &v->gnss_id, 1);
    mip_write_u8(w, &v->satellite_id, 1);
    mip_write_u8(w, &v->udrei, 1);
    mip_write_float(w, &v->pseudorange_correction, 1);
    mip_write_float(w, &v->iono_correction, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_sbas_correction_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_SBAS_CORRECTION_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_sbas_correction),
    0, /* time-out */
    read_sbas_correction,
    write_sbas_correction,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_sbas_correction_decode(struct mip_gnss_1_sbas_correction *value,
                                            const struct mip_field *field) {
    return mip_decode_field(field, read_sbas_correction, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_sbas_correction_encode(const struct mip_gnss_1_sbas_correction *value,
                                            struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_SBAS_CORRECTION_DESCRIPTOR,
                            write_sbas_correction, value);
}

static void read_rf_error_detection(struct mip_reader *r, void *value) {
    struct mip_gnss_1_rf_error_detection *v = (struct mip_gnss_1_rf_error_detection *)value;
    mip_read_u8(r, &v->rf_band, 1);
    mip_read_u8(r, &v->jamming_state, 1);
    mip_read_u8(r, &v->spoofing_state, 1);
    mip_read_u8(r, v->reserved, 4);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_rf_error_detection(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_rf_error_detection *v =
        (const struct mip_gnss_1_rf_error_detection *)value;
    mip_write_u8(w, &v->rf_band, 1);
    mip_write_u8(w, &v->jamming_state, 1);
    mip_write_u8(w, &v->spoofing_state, 1);
    mip_write_u8(w, v->reserved, 4);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_rf_error_detection_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_RF_ERROR_DETECTION_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_rf_error_detection),
    0, /* time-out */
    read_rf_error_detection,
    write_rf_error_detection,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_rf_error_detection_decode(struct mip_gnss_1_rf_error_detection *value,
                                               const struct mip_field *field) {
    return mip_decode_field(field, read_rf_error_detection, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_rf_error_detection_encode(const struct mip_gnss_1_rf_error_detection *value,
                                               struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_RF_ERROR_DETECTION_DESCRIPTOR,
                            write_rf_error_detection, value);
}

static void read_satellite_status(struct mip_reader *r, void *value) {
    struct mip_gnss_1_satellite_status *v = (struct mip_gnss_1_satellite_status *)value;
    mip_read_u8(r, &v->index, 1);
    mip_read_u8(r, &v->count, 1);
    mip_read_double(r, &v->tow, 1);
    mip_read_u16(r, &v->week_number, 1);
    mip_read_u8(r, &v->gnss_id, 1);
    mip_read_u8(r, &v->satellite_id, 1);
    mip_read_float(r, &v->elevation, 1);
    mip_read_float(r, &v->azimuth, 1);
    mip_read_bool(r, &v->health, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_satellite_status(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_satellite_status *v = (const struct mip_gnss_1_satellite_status *)value;
    mip_write_u8(w, &v->index, 1);
    mip_write_u8(w, &v->count, 1);
    mip_write_double(w, &v->tow, 1);
    mip_write_u16(w, &v->week_number, 1);
    mip_write_u8(w, &v->gnss_id, 1);
    mip_write_u8(w, &v->satellite_id, 1);
    mip_write_float(w, &v->elevation, 1);
    mip_write_float(w, &v->azimuth, 1);
    mip_write_bool(w, &v->health, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_satellite_status_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_SATELLITE_STATUS_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_satellite_status),
    0, /* time-out */
    read_satellite_status,
    write_satellite_status,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_satellite_status_decode(struct mip_gnss_1_satellite_status *value,
                                             const struct mip_field *field) {
    return mip_decode_field(field, read_satellite_status, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_satellite_status_encode(const struct mip_gnss_1_satellite_status *value,
                                             struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_SATELLITE_STATUS_DESCRIPTOR,
                            write_satellite_status, value);
}

static void read_raw(struct mip_reader *r, void *value) {
    struct mip_gnss_1_raw *v = (struct mip_gnss_1_raw *)value;
    mip_read_u8(r, &v->index, 1);
    mip_read_u8(r, &v->count, 1);
    mip_read_double(r, &v->tow, 1);
    mip_read_u16(r, &v->week_number, 1);
    mip_read_u16(r, &v->receiver_id, 1);
    mip_read_u8(r, &v->tracking_channel, 1);
    mip_read_u8(r, &v->gnss_id, 1);
    mip_read_u8(r, &v->satellite_id, 1);
    mip_read_u8(r, &v->signal_id, 1);
    mip_read_float(r, &v->signal_strength, 1);
    mip_read_u8(r, &v->quality, 1);
    mip_read_double(r, &v->pseudorange, 1);
    mip_read_double(r, &v->carrier_phase, 1);
    mip_read_float(r, &v->doppler, 1);
    mip_read_float(r, &v->range_uncertainty, 1);
    mip_read_float(r, &v->phase_uncertainty, 1);
    mip_read_float(r, &v->doppler_uncertainty, 1);
    mip_read_float(r, &v->lock_time, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_raw(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_raw *v = (const struct mip_gnss_1_raw *)value;
    mip_write_u8(w, &v->index, 1);
    mip_write_u8(w, &v->count, 1);
    mip_write_double(w, &v->tow, 1);
    mip_write_u16(w, &v->week_number, 1);
    mip_write_u16(w, &v->receiver_id, 1);
    mip_write_u8(w, &v->tracking_channel, 1);
    mip_write_u8(w, &v->gnss_id, 1);
    mip_write_u8(w, &v->satellite_id, 1);
    mip_write_u8(w, &v->signal_id, 1);
    mip_write_float(w, &v->signal_strength, 1);
    mip_write_u8(w, &v->quality, 1);
    mip_write_double(w, &v->pseudorange, 1);
    mip_write_double(w, &v->carrier_phase, 1);
    mip_write_float(w, &v->doppler, 1);
    mip_write_float(w, &v->range_uncertainty, 1);
    mip_write_float(w, &v->phase_uncertainty, 1);
    mip_write_float(w, &v->doppler_uncertainty, 1);
    mip_write_float(w, &v->lock_time, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_raw_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_RAW_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_raw),
    0, /* time-out */
    read_raw,
    write_raw,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_raw_decode(struct mip_gnss_1_raw *value, const struct mip_field *field) {
    return mip_decode_field(field, read_raw, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_raw_encode(const struct mip_gnss_1_raw *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_RAW_DESCRIPTOR, write_raw, value);
}

static void read_base_station_info(struct mip_reader *r, void *value) {
    struct mip_gnss_1_base_station_info *v = (struct mip_gnss_1_base_station_info *)value;
    mip_read_double(r, &v->tow, 1);
    mip_read_u16(r, &v->week_number, 1);
    mip_read_double(r, v->ecef_position, 3);
    mip_read_float(r, &v->height, 1);
    mip_read_u16(r, &v->station_id, 1);
    mip_read_u16(r, &v->indicators, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_base_station_info(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_base_station_info *v =
        (const struct mip_gnss_1_base_station_info *)value;
    mip_write_double(w, &v->tow, 1);
    mip_write_u16(w, &v->week_number, 1);
    mip_write_double(w, v->ecef_position, 3);
    mip_write_float(w, &v->height, 1);
    mip_write_u16(w, &v->station_id, 1);
    mip_write_u16(w, &v->indicators, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_base_station_info_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_BASE_STATION_INFO_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_base_station_info),
    0, /* time-out */
    read_base_station_info,
    write_base_station_info,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_base_station_info_decode(struct mip_gnss_1_base_station_info *value,
                                              const struct mip_field *field) {
    return mip_decode_field(field, read_base_station_info, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_base_station_info_encode(const struct mip_gnss_1_base_station_info *value,
                                              struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_BASE_STATION_INFO_DESCRIPTOR,
                            write_base_station_info, value);
}

static void read_rtk_corrections_status(struct mip_reader *r, void *value) {
    struct mip_gnss_1_rtk_corrections_status *v = (struct mip_gnss_1_rtk_corrections_status *)value;
    mip_read_double(r, &v->tow, 1);
    mip_read_u16(r, &v->week_number, 1);
    mip_read_u16(r, &v->epoch_status, 1);
    mip_read_u32(r, &v->dongle_status, 1);
    mip_read_float(r, &v->gps_correction_latency, 1);
    mip_read_float(r, &v->glonass_correction_latency, 1);
    mip_read_float(r, &v->galileo_correction_latency, 1);
    mip_read_float(r, &v->beidou_correction_latency, 1);
    mip_read_u32(r, v->reserved, 4);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_rtk_corrections_status(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_rtk_corrections_status *v =
        (const struct mip_gnss_1_rtk_corrections_status *)value;
    mip_write_double(w, &v->tow, 1);
    mip_write_u16(w, &v->week_number, 1);
    mip_write_u16(w, &v->epoch_status, 1);
    mip_write_u32(w, &v->dongle_status, 1);
    mip_write_float(w, &v->gps_correction_latency, 1);
    mip_write_float(w, &v->glonass_correction_latency, 1);
    mip_write_float(w, &v->galileo_correction_latency, 1);
    mip_write_float(w, &v->beidou_correction_latency, 1);
    mip_write_u32(w, v->reserved, 4);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_rtk_corrections_status_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_RTK_CORRECTIONS_STATUS_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_rtk_corrections_status),
    0, /* time-out */
    read_rtk_corrections_status,
    write_rtk_corrections_status,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_rtk_corrections_status_decode(struct mip_gnss_1_rtk_corrections_status *value,
                                                   const struct mip_field *field) {
    return mip_decode_field(field, read_rtk_corrections_status, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_rtk_corrections_status_encode(
    const struct mip_gnss_1_rtk_corrections_status *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_RTK_CORRECTIONS_STATUS_DESCRIPTOR,
                            write_rtk_corrections_status, value);
}

static void read_gps_ephemeris(struct mip_reader *r, void *value) {
    struct mip_gnss_1_gps_ephemeris *v = (struct mip_gnss_1_gps_ephemeris *)value;
    mip_read_u8(r, &v->index, 1);
    mip_read_u8(r, &v->count, 1);
    mip_read_double(r, &v->tow, 1);
    mip_read_u16(r, &v->week_number, 1);
    mip_read_u8(r, &v->satellite_id, 1);
    mip_read_u8(r, &v->health, 1);
    mip_read_u8(r, &v->iodc, 1);
    mip_read_u8(r, &v->iode, 1);
    mip_read_double(r, &v->t_oc, 1);
    mip_read_double(r, &v->af0, 1);
    mip_read_double(r, &v->af1, 1);
    mip_read_double(r, &v->af2, 1);
    mip_read_double(r, &v->t_gd, 1);
    mip_read_double(r, &v->isc_l1ca, 1);
    mip_read_double(r, &v->isc_l2c, 1);
    mip_read_double(r, &v->t_oe, 1);
    mip_read_double(r, &v->a, 1);
    mip_read_double(r, &v->a_dot, 1);
    mip_read_double(r, &v->mean_anomaly, 1);
    mip_read_double(r, &v->delta_mean_motion, 1);
    mip_read_double(r, &v->delta_mean_motion_dot, 1);
    mip_read_double(r, &v->eccentricity, 1);
    mip_read_double(r, &v->argument_of_perigee, 1);
    mip_read_double(r, &v->omega, 1);
    mip_read_double(r, &v->omega_dot, 1);
    mip_read_double(r, &v->inclination, 1);
    mip_read_double(r, &v->inclination_dot, 1);
    mip_read_double(r, &v->c_ic, 1);
    mip_read_double(r, &v->c_is, 1);
    mip_read_double(r, &v->c_uc, 1);
    mip_read_double(r, &v->c_us, 1);
    mip_read_double(r, &v->c_rc, 1);
    mip_read_double(r, &v->c_rs, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_gps_ephemeris(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_gps_ephemeris *v = (const struct mip_gnss_1_gps_ephemeris *)value;
    mip_write_u8(w, &v->index, 1);
    mip_write_u8(w, &v->count, 1);
    mip_write_double(w, &v->tow, 1);
    mip_write_u16(w, &v->week_number, 1);
    mip_write_u8(w, &v->satellite_id, 1);
    mip_write_u8(w, &v->health, 1);
    mip_write_u8(w, &v->iodc, 1);
    mip_write_u8(w, &v->iode, 1);
    mip_write_double(w, &v->t_oc, 1);
    mip_write_double(w, &v->af0, 1);
    mip_write_double(w, &v->af1, 1);
    mip_write_double(w, &v->af2, 1);
    mip_write_double(w, &v->t_gd, 1);
    mip_write_double(w, &v->isc_l1ca, 1);
    mip_write_double(w, &v->isc_l2c, 1);
    mip_write_double(w, &v->t_oe, 1);
    mip_write_double(w, &v->a, 1);
    mip_write_double(w, &v->a_dot, 1);
    mip_write_double(w, &v->mean_anomaly, 1);
    mip_write_double(w, &v->delta_mean_motion, 1);
    mip_write_double(w, &v->delta_mean_motion_dot, 1);
    mip_write_double(w, &v->eccentricity, 1);
    mip_write_double(w, &v->argument_of_perigee, 1);
    mip_write_double(w, &v->omega, 1);
    mip_write_double(w, &v->omega_dot, 1);
    mip_write_double(w, &v->inclination, 1);
    mip_write_double(w, &v->inclination_dot, 1);
    mip_write_double(w, &v->c_ic, 1);
    mip_write_double(w, &v->c_is, 1);
    mip_write_double(w, &v->c_uc, 1);
    mip_write_double(w, &v->c_us, 1);
    mip_write_double(w, &v->c_rc, 1);
    mip_write_double(w, &v->c_rs, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_gps_ephemeris_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_GPS_EPHEMERIS_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_gps_ephemeris),
    0, /* time-out */
    read_gps_ephemeris,
    write_gps_ephemeris,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_gps_ephemeris_decode(struct mip_gnss_1_gps_ephemeris *value,
                                          const struct mip_field *field) {
    return mip_decode_field(field, read_gps_ephemeris, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_gps_ephemeris_encode(const struct mip_gnss_1_gps_ephemeris *value,
                                          struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_GPS_EPHEMERIS_DESCRIPTOR, write_gps_ephemeris,
                            value);
}

static void read_glonass_ephemeris(struct mip_reader *r, void *value) {
    struct mip_gnss_1_glonass_ephemeris *v = (struct mip_gnss_1_glonass_ephemeris *)value;
    mip_read_u8(r, &v->index, 1);
    mip_read_u8(r, &v->count, 1);
    mip_read_double(r, &v->tow, 1);
    mip_read_u16(r, &v->week_number, 1);
    mip_read_u8(r, &v->satellite_id, 1);
    mip_read_s8(r, &v->frequency_number, 1);
    mip_read_u32(r, &v->tk, 1);
    mip_read_u32(r, &v->tb, 1);
    mip_read_u8(r, &v->satellite_type, 1);
    mip_read_double(r, &v->gamma, 1);
    mip_read_double(r, &v->tau_n, 1);
    mip_read_double(r, v->position, 3);
    mip_read_float(r, v->velocity, 3);
    mip_read_float(r, v->accel, 3);
    mip_read_u8(r, &v->health, 1);
    mip_read_u8(r, &v->p, 1);
    mip_read_u8(r, &v->nt, 1);
    mip_read_float(r, &v->delta_tau_n, 1);
    mip_read_u8(r, &v->ft, 1);
    mip_read_u8(r, &v->en, 1);
    mip_read_u8(r, &v->p1, 1);
    mip_read_u8(r, &v->p2, 1);
    mip_read_u8(r, &v->p3, 1);
    mip_read_u8(r, &v->p4, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_glonass_ephemeris(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_glonass_ephemeris *v =
        (const struct mip_gnss_1_glonass_ephemeris *)value;
    mip_write_u8(w, &v->index, 1);
    mip_write_u8(w, &v->count, 1);
    mip_write_double(w, &v->tow, 1);
    mip_write_u16(w, &v->week_number, 1);
    mip_write_u8(w, &v->satellite_id, 1);
    mip_write_s8(w, &v->frequency_number, 1);
    mip_write_u32(w, &v->tk, 1);
    mip_write_u32(w, &v->tb, 1);
    mip_write_u8(w, &v->satellite_type, 1);
    mip_write_double(w, &v->gamma, 1);
    mip_write_double(w, &v->tau_n, 1);
    mip_write_double(w, v->position, 3);
    mip_write_float(w, v->velocity, 3);
    mip_write_float(w, v->accel, 3);
    mip_write_u8(w, &v->health, 1);
    mip_write_u8(w, &v->p, 1);
    mip_write_u8(w, &v->nt, 1);
    mip_write_float(w, &v->delta_tau_n, 1);
    mip_write_u8(w, &v->ft, 1);
    mip_write_u8(w, &v->en, 1);
    mip_write_u8(w, &v->p1, 1);
    mip_write_u8(w, &v->p2, 1);
    mip_write_u8(w, &v->p3, 1);
    mip_write_u8(w, &v->p4, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_glonass_ephemeris_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_GLONASS_EPHEMERIS_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_glonass_ephemeris),
    0, /* time-out */
    read_glonass_ephemeris,
    write_glonass_ephemeris,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_glonass_ephemeris_decode(struct mip_gnss_1_glonass_ephemeris *value,
                                              const struct mip_field *field) {
    return mip_decode_field(field, read_glonass_ephemeris, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_glonass_ephemeris_encode(const struct mip_gnss_1_glonass_ephemeris *value,
                                              struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_GLONASS_EPHEMERIS_DESCRIPTOR,
                            write_glonass_ephemeris, value);
}

static void read_galileo_ephemeris(struct mip_reader *r, void *value) {
    struct mip_gnss_1_galileo_ephemeris *v = (struct mip_gnss_1_galileo_ephemeris *)value;
    mip_read_u8(r, &v->index, 1);
    mip_read_u8(r, &v->count, 1);
    mip_read_double(r, &v->tow, 1);
    mip_read_u16(r, &v->week_number, 1);
    mip_read_u8(r, &v->satellite_id, 1);
    mip_read_u8(r, &v->health, 1);
    mip_read_u8(r, &v->iodc, 1);
    mip_read_u8(r, &v->iode, 1);
    mip_read_double(r, &v->t_oc, 1);
    mip_read_double(r, &v->af0, 1);
    mip_read_double(r, &v->af1, 1);
    mip_read_double(r, &v->af2, 1);
    mip_read_double(r, &v->t_gd, 1);
    mip_read_double(r, &v->isc_l1ca, 1);
    mip_read_double(r, &v->isc_l2c, 1);
    mip_read_double(r, &v->t_oe, 1);
    mip_read_double(r, &v->a, 1);
    mip_read_double(r, &v->a_dot, 1);
    mip_read_double(r, &v->mean_anomaly, 1);
    mip_read_double(r, &v->delta_mean_motion, 1);
    mip_read_double(r, &v->delta_mean_motion_dot, 1);
    mip_read_double(r, &v->eccentricity, 1);
    mip_read_double(r, &v->argument_of_perigee, 1);
    mip_read_double(r, &v->omega, 1);
    mip_read_double(r, &v->omega_dot, 1);
    mip_read_double(r, &v->inclination, 1);
    mip_read_double(r, &v->inclination_dot, 1);
    mip_read_double(r, &v->c_ic, 1);
    mip_read_double(r, &v->c_is, 1);
    mip_read_double(r, &v->c_uc, 1);
    mip_read_double(r, &v->c_us, 1);
    mip_read_double(r, &v->c_rc, 1);
    mip_read_double(r, &v->c_rs, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_galileo_ephemeris(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_galileo_ephemeris *v =
        (const struct mip_gnss_1_galileo_ephemeris *)value;
    mip_write_u8(w, &v->index, 1);
    mip_write_u8(w, &v->count, 1);
    mip_write_double(w, &v->tow, 1);
    mip_write_u16(w, &v->week_number, 1);
    mip_write_u8(w, &v->satellite_id, 1);
    mip_write_u8(w, &v->health, 1);
    mip_write_u8(w, &v->iodc, 1);
    mip_write_u8(w, &v->iode, 1);
    mip_write_double(w, &v->t_oc, 1);
    mip_write_double(w, &v->af0, 1);
    mip_write_double(w, &v->af1, 1);
    mip_write_double(w, &v->af2, 1);
    mip_write_double(w, &v->t_gd, 1);
    mip_write_double(w, &v->isc_l1ca, 1);
    mip_write_double(w, &v->isc_l2c, 1);
    mip_write_double(w, &v->t_oe, 1);
    mip_write_double(w, &v->a, 1);
    mip_write_double(w, &v->a_dot, 1);
    mip_write_double(w, &v->mean_anomaly, 1);
    mip_write_double(w, &v->delta_mean_motion, 1);
    mip_write_double(w, &v->delta_mean_motion_dot, 1);
    mip_write_double(w, &v->eccentricity, 1);
    mip_write_double(w, &v->argument_of_perigee, 1);
    mip_write_double(w, &v->omega, 1);
    mip_write_double(w, &v->omega_dot, 1);
    mip_write_double(w, &v->inclination, 1);
    mip_write_double(w, &v->inclination_dot, 1);
    mip_write_double(w, &v->c_ic, 1);
    mip_write_double(w, &v->c_is, 1);
    mip_write_double(w, &v->c_uc, 1);
    mip_write_double(w, &v->c_us, 1);
    mip_write_double(w, &v->c_rc, 1);
    mip_write_double(w, &v->c_rs, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_galileo_ephemeris_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_GALILEO_EPHEMERIS_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_galileo_ephemeris),
    0, /* time-out */
    read_galileo_ephemeris,
    write_galileo_ephemeris,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_galileo_ephemeris_decode(struct mip_gnss_1_galileo_ephemeris *value,
                                              const struct mip_field *field) {
    return mip_decode_field(field, read_galileo_ephemeris, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_galileo_ephemeris_encode(const struct mip_gnss_1_galileo_ephemeris *value,
                                              struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_GALILEO_EPHEMERIS_DESCRIPTOR,
                            write_galileo_ephemeris, value);
}

static void read_beidou_ephemeris(struct mip_reader *r, void *value) {
    struct mip_gnss_1_beidou_ephemeris *v = (struct mip_gnss_1_beidou_ephemeris *)value;
    mip_read_u8(r, &v->index, 1);
    mip_read_u8(r, &v->count, 1);
    mip_read_double(r, &v->tow, 1);
    mip_read_u16(r, &v->week_number, 1);
    mip_read_u8(r, &v->satellite_id, 1);
    mip_read_u8(r, &v->health, 1);
    mip_read_u8(r, &v->iodc, 1);
    mip_read_u8(r, &v->iode, 1);
    mip_read_double(r, &v->t_oc, 1);
    mip_read_double(r, &v->af0, 1);
    mip_read_double(r, &v->af1, 1);
    mip_read_double(r, &v->af2, 1);
    mip_read_double(r, &v->t_gd, 1);
    mip_read_double(r, &v->isc_l1ca, 1);
    mip_read_double(r, &v->isc_l2c, 1);
    mip_read_double(r, &v->t_oe, 1);
    mip_read_double(r, &v->a, 1);
    mip_read_double(r, &v->a_dot, 1);
    mip_read_double(r, &v->mean_anomaly, 1);
    mip_read_double(r, &v->delta_mean_motion, 1);
    mip_read_double(r, &v->delta_mean_motion_dot, 1);
    mip_read_double(r, &v->eccentricity, 1);
    mip_read_double(r, &v->argument_of_perigee, 1);
    mip_read_double(r, &v->omega, 1);
    mip_read_double(r, &v->omega_dot, 1);
    mip_read_double(r, &v->inclination, 1);
    mip_read_double(r, &v->inclination_dot, 1);
    mip_read_double(r, &v->c_ic, 1);
    mip_read_double(r, &v->c_is, 1);
    mip_read_double(r, &v->c_uc, 1);
    mip_read_double(r, &v->c_us, 1);
    mip_read_double(r, &v->c_rc, 1);
    mip_read_double(r, &v->c_rs, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_beidou_ephemeris(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_beidou_ephemeris *v = (const struct mip_gnss_1_beidou_ephemeris *)value;
    mip_write_u8(w, &v->index, 1);
    mip_write_u8(w, &v->count, 1);
    mip_write_double(w, &v->tow, 1);
    mip_write_u16(w, &v->week_number, 1);
    mip_write_u8(w, &v->satellite_id, 1);
    mip_write_u8(w, &v->health, 1);
    mip_write_u8(w, &v->iodc, 1);
    mip_write_u8(w, &v->iode, 1);
    mip_write_double(w, &v->t_oc, 1);
    mip_write_double(w, &v->af0, 1);
    mip_write_double(w, &v->af1, 1);
    mip_write_double(w, &v->af2, 1);
    mip_write_double(w, &v->t_gd, 1);
    mip_write_double(w, &v->isc_l1ca, 1);
    mip_write_double(w, &v->isc_l2c, 1);
    mip_write_double(w, &v->t_oe, 1);
    mip_write_double(w, &v->a, 1);
    mip_write_double(w, &v->a_dot, 1);
    mip_write_double(w, &v->mean_anomaly, 1);
    mip_write_double(w, &v->delta_mean_motion, 1);
    mip_write_double(w, &v->delta_mean_motion_dot, 1);
    mip_write_double(w, &v->eccentricity, 1);
    mip_write_double(w, &v->argument_of_perigee, 1);
    mip_write_double(w, &v->omega, 1);
    mip_write_double(w, &v->omega_dot, 1);
    mip_write_double(w, &v->inclination, 1);
    mip_write_double(w, &v->inclination_dot, 1);
    mip_write_double(w, &v->c_ic, 1);
    mip_write_double(w, &v->c_is, 1);
    mip_write_double(w, &v->c_uc, 1);
    mip_write_double(w, &v->c_us, 1);
    mip_write_double(w, &v->c_rc, 1);
    mip_write_double(w, &v->c_rs, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_beidou_ephemeris_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_BEIDOU_EPHEMERIS_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_beidou_ephemeris),
    0, /* time-out */
    read_beidou_ephemeris,
    write_beidou_ephemeris,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_beidou_ephemeris_decode(struct mip_gnss_1_beidou_ephemeris *value,
                                             const struct mip_field *field) {
    return mip_decode_field(field, read_beidou_ephemeris, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_beidou_ephemeris_encode(const struct mip_gnss_1_beidou_ephemeris *value,
                                             struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_BEIDOU_EPHEMERIS_DESCRIPTOR,
                            write_beidou_ephemeris, value);
}

static void read_gps_iono_correction(struct mip_reader *r, void *value) {
    struct mip_gnss_1_gps_iono_correction *v = (struct mip_gnss_1_gps_iono_correction *)value;
    mip_read_double(r, &v->tow, 1);
    mip_read_u16(r, &v->week_number, 1);
    mip_read_double(r, v->alpha, 4);
    mip_read_double(r, v->beta, 4);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_gps_iono_correction(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_gps_iono_correction *v =
        (const struct mip_gnss_1_gps_iono_correction *)value;
    mip_write_double(w, &v->tow, 1);
    mip_write_u16(w, &v->week_number, 1);
    mip_write_double(w, v->alpha, 4);
    mip_write_double(w, v->beta, 4);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_gps_iono_correction_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_GPS_IONO_CORRECTION_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_gps_iono_correction),
    0, /* time-out */
    read_gps_iono_correction,
    write_gps_iono_correction,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_gps_iono_correction_decode(struct mip_gnss_1_gps_iono_correction *value,
                                                const struct mip_field *field) {
    return mip_decode_field(field, read_gps_iono_correction, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_gps_iono_correction_encode(const struct mip_gnss_1_gps_iono_correction *value,
                                                struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_GPS_IONO_CORRECTION_DESCRIPTOR,
                            write_gps_iono_correction, value);
}

static void read_galileo_iono_correction(struct mip_reader *r, void *value) {
    struct mip_gnss_1_galileo_iono_correction *v =
        (struct mip_gnss_1_galileo_iono_correction *)value;
    mip_read_double(r, &v->tow, 1);
    mip_read_u16(r, &v->week_number, 1);
    mip_read_double(r, v->alpha, 3);
    mip_read_u8(r, &v->disturbance_flags, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_galileo_iono_correction(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_galileo_iono_correction *v =
        (const struct mip_gnss_1_galileo_iono_correction *)value;
    mip_write_double(w, &v->tow, 1);
    mip_write_u16(w, &v->week_number, 1);
    mip_write_double(w, v->alpha, 3);
    mip_write_u8(w, &v->disturbance_flags, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_galileo_iono_correction_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_GALILEO_IONO_CORRECTION_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_galileo_iono_correction),
    0, /* time-out */
    read_galileo_iono_correction,
    write_galileo_iono_correction,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_galileo_iono_correction_decode(
    struct mip_gnss_1_galileo_iono_correction *value, const struct mip_field *field) {
    return mip_decode_field(field, read_galileo_iono_correction, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_galileo_iono_correction_encode(
    const struct mip_gnss_1_galileo_iono_correction *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_GALILEO_IONO_CORRECTION_DESCRIPTOR,
                            write_galileo_iono_correction, value);
}

static void read_beidou_iono_correction(struct mip_reader *r, void *value) {
    struct mip_gnss_1_beidou_iono_correction *v = (struct mip_gnss_1_beidou_iono_correction *)value;
    mip_read_double(r, &v->tow, 1);
    mip_read_u16(r, &v->week_number, 1);
    mip_read_double(r, v->alpha, 4);
    mip_read_double(r, v->beta, 4);
    mip_read_double(r, v->alpha_correction, 9);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_beidou_iono_correction(struct mip_writer *w, const void *value) {
    const struct mip_gnss_1_beidou_iono_correction *v =
        (const struct mip_gnss_1_beidou_iono_correction *)value;
    mip_write_double(w, &v->tow, 1);
    mip_write_u16(w, &v->week_number, 1);
    mip_write_double(w, v->alpha, 4);
    mip_write_double(w, v->beta, 4);
    mip_write_double(w, v->alpha_correction, 9);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_1_beidou_iono_correction_codec = {
    0x91, /* descriptor set */
    MIP_GNSS_1_BEIDOU_IONO_CORRECTION_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_1_beidou_iono_correction),
    0, /* time-out */
    read_beidou_iono_correction,
    write_beidou_iono_correction,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_1_beidou_iono_correction_decode(struct mip_gnss_1_beidou_iono_correction *value,
                                                   const struct mip_field *field) {
    return mip_decode_field(field, read_beidou_iono_correction, value, sizeof(*value), NULL);
}

mip_error mip_gnss_1_beidou_iono_correction_encode(
    const struct mip_gnss_1_beidou_iono_correction *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x91, MIP_GNSS_1_BEIDOU_IONO_CORRECTION_DESCRIPTOR,
                            write_beidou_iono_correction, value);
}
