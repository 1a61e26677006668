/* GNSS corrections data. */
#include "mip/gnss_corrections.h"

#include <string.h>

static void read_base_station_info(struct mip_reader *r, void *value) {
    struct mip_gnss_corrections_base_station_info *v =
        (struct mip_gnss_corrections_base_station_info *)value;
    mip_read_double(r, &v->time_of_week, 1);
    mip_read_u16(r, &v->week_number, 1);
    mip_read_double(r, v->ecef_pos, 3);
    mip_read_float(r, &v->height, 1);
    mip_read_u16(r, &v->station_id, 1);
    mip_read_u16(r, &v->indicators, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_base_station_info(struct mip_writer *w, const void *value) {
    const struct mip_gnss_corrections_base_station_info *v =
        (const struct mip_gnss_corrections_base_station_info *)value;
    mip_write_double(w, &v->time_of_week, 1);
    mip_write_u16(w, &v->week_number, 1);
    mip_write_double(w, v->ecef_pos, 3);
    mip_write_float(w, &v->height, 1);
    mip_write_u16(w, &v->station_id, 1);
    mip_write_u16(w, &v->indicators, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_gnss_corrections_base_station_info_codec = {
    0x93,
    MIP_GNSS_CORRECTIONS_BASE_STATION_INFO_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_corrections_base_station_info),
    0,
    read_base_station_info,
    write_base_station_info,
    NULL,
    NULL,
};

mip_error mip_gnss_corrections_base_station_info_decode(
    struct mip_gnss_corrections_base_station_info *value, const struct mip_field *field) {
    return mip_decode_field(field, read_base_station_info, value, sizeof(*value), NULL);
}

mip_error mip_gnss_corrections_base_station_info_encode(
    const struct mip_gnss_corrections_base_station_info *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x93, MIP_GNSS_CORRECTIONS_BASE_STATION_INFO_DESCRIPTOR,
                            write_base_station_info, value);
}

static void read_rtk_corrections_status(struct mip_reader *r, void *value) {
    struct mip_gnss_corrections_rtk_corrections_status *v =
        (struct mip_gnss_corrections_rtk_corrections_status *)value;
    mip_read_double(r, &v->time_of_week, 1);
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
    const struct mip_gnss_corrections_rtk_corrections_status *v =
        (const struct mip_gnss_corrections_rtk_corrections_status *)value;
    mip_write_double(w, &v->time_of_week, 1);
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

const struct mip_codec mip_gnss_corrections_rtk_corrections_status_codec = {
    0x93,
    MIP_GNSS_CORRECTIONS_RTK_CORRECTIONS_STATUS_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_gnss_corrections_rtk_corrections_status),
    0,
    read_rtk_corrections_status,
    write_rtk_corrections_status,
    NULL,
    NULL,
};

mip_error mip_gnss_corrections_rtk_corrections_status_decode(
    struct mip_gnss_corrections_rtk_corrections_status *value, const struct mip_field *field) {
    return mip_decode_field(field, read_rtk_corrections_status, value, sizeof(*value), NULL);
}

mip_error mip_gnss_corrections_rtk_corrections_status_encode(
    const struct mip_gnss_corrections_rtk_corrections_status *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x93, MIP_GNSS_CORRECTIONS_RTK_CORRECTIONS_STATUS_DESCRIPTOR,
                            write_rtk_corrections_status, value);
}
