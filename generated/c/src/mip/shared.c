/* Shared data. */
#include "mip/shared.h"

#include <string.h>

static void read_event_source(struct mip_reader *r, void *value) {
    struct mip_shared_event_source *v = (struct mip_shared_event_source *)value;
    mip_read_u8(r, &v->trigger_id, 1);
}

static void write_event_source(struct mip_writer *w, const void *value) {
    const struct mip_shared_event_source *v = (const struct mip_shared_event_source *)value;
    mip_write_u8(w, &v->trigger_id, 1);
}

const struct mip_codec mip_shared_event_source_codec = {
    0xFF, /* descriptor set */
    MIP_SHARED_EVENT_SOURCE_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_shared_event_source),
    0, /* time-out */
    read_event_source,
    write_event_source,
    NULL,
    NULL,
    NULL,
};

mip_error mip_shared_event_source_decode(struct mip_shared_event_source *value,
                                         const struct mip_field *field) {
    return mip_decode_field(field, read_event_source, value, sizeof(*value), NULL);
}

mip_error mip_shared_event_source_encode(const struct mip_shared_event_source *value,
                                         struct mip_builder *builder) {
    return mip_encode_field(builder, 0xFF, MIP_SHARED_EVENT_SOURCE_DESCRIPTOR, write_event_source,
                            value);
}

static void read_ticks(struct mip_reader *r, void *value) {
    struct mip_shared_ticks *v = (struct mip_shared_ticks *)value;
    mip_read_u32(r, &v->ticks, 1);
}

static void write_ticks(struct mip_writer *w, const void *value) {
    const struct mip_shared_ticks *v = (const struct mip_shared_ticks *)value;
    mip_write_u32(w, &v->ticks, 1);
}

const struct mip_codec mip_shared_ticks_codec = {
    0xFF, /* descriptor set */
    MIP_SHARED_TICKS_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_shared_ticks),
    0, /* time-out */
    read_ticks,
    write_ticks,
    NULL,
    NULL,
    NULL,
};

mip_error mip_shared_ticks_decode(struct mip_shared_ticks *value, const struct mip_field *field) {
    return mip_decode_field(field, read_ticks, value, sizeof(*value), NULL);
}

mip_error mip_shared_ticks_encode(const struct mip_shared_ticks *value,
                                  struct mip_builder *builder) {
    return mip_encode_field(builder, 0xFF, MIP_SHARED_TICKS_DESCRIPTOR, write_ticks, value);
}

static void read_delta_ticks(struct mip_reader *r, void *value) {
    struct mip_shared_delta_ticks *v = (struct mip_shared_delta_ticks *)value;
    mip_read_u32(r, &v->ticks, 1);
}

static void write_delta_ticks(struct mip_writer *w, const void *value) {
    const struct mip_shared_delta_ticks *v = (const struct mip_shared_delta_ticks *)value;
    mip_write_u32(w, &v->ticks, 1);
}

const struct mip_codec mip_shared_delta_ticks_codec = {
    0xFF, /* descriptor set */
    MIP_SHARED_DELTA_TICKS_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_shared_delta_ticks),
    0, /* time-out */
    read_delta_ticks,
    write_delta_ticks,
    NULL,
    NULL,
    NULL,
};

mip_error mip_shared_delta_ticks_decode(struct mip_shared_delta_ticks *value,
                                        const struct mip_field *field) {
    return mip_decode_field(field, read_delta_ticks, value, sizeof(*value), NULL);
}

mip_error mip_shared_delta_ticks_encode(const struct mip_shared_delta_ticks *value,
                                        struct mip_builder *builder) {
    return mip_encode_field(builder, 0xFF, MIP_SHARED_DELTA_TICKS_DESCRIPTOR, write_delta_ticks,
                            value);
}

static void read_gps_timestamp(struct mip_reader *r, void *value) {
    struct mip_shared_gps_timestamp *v = (struct mip_shared_gps_timestamp *)value;
    mip_read_double(r, &v->tow, 1);
    mip_read_u16(r, &v->week_number, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_gps_timestamp(struct mip_writer *w, const void *value) {
    const struct mip_shared_gps_timestamp *v = (const struct mip_shared_gps_timestamp *)value;
    mip_write_double(w, &v->tow, 1);
    mip_write_u16(w, &v->week_number, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_shared_gps_timestamp_codec = {
    0xFF, /* descriptor set */
    MIP_SHARED_GPS_TIMESTAMP_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_shared_gps_timestamp),
    0, /* time-out */
    read_gps_timestamp,
    write_gps_timestamp,
    NULL,
    NULL,
    NULL,
};

mip_error mip_shared_gps_timestamp_decode(struct mip_shared_gps_timestamp *value,
                                          const struct mip_field *field) {
    return mip_decode_field(field, read_gps_timestamp, value, sizeof(*value), NULL);
}

mip_error mip_shared_gps_timestamp_encode(const struct mip_shared_gps_timestamp *value,
                                          struct mip_builder *builder) {
    return mip_encode_field(builder, 0xFF, MIP_SHARED_GPS_TIMESTAMP_DESCRIPTOR, write_gps_timestamp,
                            value);
}

static void read_delta_time(struct mip_reader *r, void *value) {
    struct mip_shared_delta_time *v = (struct mip_shared_delta_time *)value;
    mip_read_double(r, &v->seconds, 1);
}

static void write_delta_time(struct mip_writer *w, const void *value) {
    const struct mip_shared_delta_time *v = (const struct mip_shared_delta_time *)value;
    mip_write_double(w, &v->seconds, 1);
}

const struct mip_codec mip_shared_delta_time_codec = {
    0xFF, /* descriptor set */
    MIP_SHARED_DELTA_TIME_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_shared_delta_time),
    0, /* time-out */
    read_delta_time,
    write_delta_time,
    NULL,
    NULL,
    NULL,
};

mip_error mip_shared_delta_time_decode(struct mip_shared_delta_time *value,
                                       const struct mip_field *field) {
    return mip_decode_field(field, read_delta_time, value, sizeof(*value), NULL);
}

mip_error mip_shared_delta_time_encode(const struct mip_shared_delta_time *value,
                                       struct mip_builder *builder) {
    return mip_encode_field(builder, 0xFF, MIP_SHARED_DELTA_TIME_DESCRIPTOR, write_delta_time,
                            value);
}

static void read_reference_timestamp(struct mip_reader *r, void *value) {
    struct mip_shared_reference_timestamp *v = (struct mip_shared_reference_timestamp *)value;
    mip_read_u64(r, &v->nanoseconds, 1);
}

static void write_reference_timestamp(struct mip_writer *w, const void *value) {
    const struct mip_shared_reference_timestamp *v =
        (const struct mip_shared_reference_timestamp *)value;
    mip_write_u64(w, &v->nanoseconds, 1);
}

const struct mip_codec mip_shared_reference_timestamp_codec = {
    0xFF, /* descriptor set */
    MIP_SHARED_REFERENCE_TIMESTAMP_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_shared_reference_timestamp),
    0, /* time-out */
    read_reference_timestamp,
    write_reference_timestamp,
    NULL,
    NULL,
    NULL,
};

mip_error mip_shared_reference_timestamp_decode(struct mip_shared_reference_timestamp *value,
                                                const struct mip_field *field) {
    return mip_decode_field(field, read_reference_timestamp, value, sizeof(*value), NULL);
}

mip_error mip_shared_reference_timestamp_encode(const struct mip_shared_reference_timestamp *value,
                                                struct mip_builder *builder) {
    return mip_encode_field(builder, 0xFF, MIP_SHARED_REFERENCE_TIMESTAMP_DESCRIPTOR,
                            write_reference_timestamp, value);
}

static void read_reference_time_delta(struct mip_reader *r, void *value) {
    struct mip_shared_reference_time_delta *v = (struct mip_shared_reference_time_delta *)value;
    mip_read_u64(r, &v->dt_nanos, 1);
}

static void write_reference_time_delta(struct mip_writer *w, const void *value) {
    const struct mip_shared_reference_time_delta *v =
        (const struct mip_shared_reference_time_delta *)value;
    mip_write_u64(w, &v->dt_nanos, 1);
}

const struct mip_codec mip_shared_reference_time_delta_codec = {
    0xFF, /* descriptor set */
    MIP_SHARED_REFERENCE_TIME_DELTA_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_shared_reference_time_delta),
    0, /* time-out */
    read_reference_time_delta,
    write_reference_time_delta,
    NULL,
    NULL,
    NULL,
};

mip_error mip_shared_reference_time_delta_decode(struct mip_shared_reference_time_delta *value,
                                                 const struct mip_field *field) {
    return mip_decode_field(field, read_reference_time_delta, value, sizeof(*value), NULL);
}

mip_error mip_shared_reference_time_delta_encode(
    const struct mip_shared_reference_time_delta *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0xFF, MIP_SHARED_REFERENCE_TIME_DELTA_DESCRIPTOR,
                            write_reference_time_delta, value);
}

static void read_external_timestamp(struct mip_reader *r, void *value) {
    struct mip_shared_external_timestamp *v = (struct mip_shared_external_timestamp *)value;
    mip_read_u64(r, &v->nanoseconds, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_external_timestamp(struct mip_writer *w, const void *value) {
    const struct mip_shared_external_timestamp *v =
        (const struct mip_shared_external_timestamp *)value;
    mip_write_u64(w, &v->nanoseconds, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_shared_external_timestamp_codec = {
    0xFF, /* descriptor set */
    MIP_SHARED_EXTERNAL_TIMESTAMP_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_shared_external_timestamp),
    0, /* time-out */
    read_external_timestamp,
    write_external_timestamp,
    NULL,
    NULL,
    NULL,
};

mip_error mip_shared_external_timestamp_decode(struct mip_shared_external_timestamp *value,
                                               const struct mip_field *field) {
    return mip_decode_field(field, read_external_timestamp, value, sizeof(*value), NULL);
}

mip_error mip_shared_external_timestamp_encode(const struct mip_shared_external_timestamp *value,
                                               struct mip_builder *builder) {
    return mip_encode_field(builder, 0xFF, MIP_SHARED_EXTERNAL_TIMESTAMP_DESCRIPTOR,
                            write_external_timestamp, value);
}

static void read_external_time_delta(struct mip_reader *r, void *value) {
    struct mip_shared_external_time_delta *v = (struct mip_shared_external_time_delta *)value;
    mip_read_u64(r, &v->dt_nanos, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_external_time_delta(struct mip_writer *w, const void *value) {
    const struct mip_shared_external_time_delta *v =
        (const struct mip_shared_external_time_delta *)value;
    mip_write_u64(w, &v->dt_nanos, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_shared_external_time_delta_codec = {
    0xFF, /* descriptor set */
    MIP_SHARED_EXTERNAL_TIME_DELTA_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_shared_external_time_delta),
    0, /* time-out */
    read_external_time_delta,
    write_external_time_delta,
    NULL,
    NULL,
    NULL,
};

mip_error mip_shared_external_time_delta_decode(struct mip_shared_external_time_delta *value,
                                                const struct mip_field *field) {
    return mip_decode_field(field, read_external_time_delta, value, sizeof(*value), NULL);
}

mip_error mip_shared_external_time_delta_encode(const struct mip_shared_external_time_delta *value,
                                                struct mip_builder *builder) {
    return mip_encode_field(builder, 0xFF, MIP_SHARED_EXTERNAL_TIME_DELTA_DESCRIPTOR,
                            write_external_time_delta, value);
}
