/* Measurements. */
#include "mip/measurements.h"

#include <string.h>

static void read_accel(struct mip_reader *r, void *value) {
    struct mip_measurements_accel *v = (struct mip_measurements_accel *)value;
    mip_read_float(r, v->scaled_accel, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_accel(struct mip_writer *w, const void *value) {
    const struct mip_measurements_accel *v = (const struct mip_measurements_accel *)value;
    mip_write_float(w, v->scaled_accel, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_measurements_accel_codec = {
    0x80, /* descriptor set */
    MIP_MEASUREMENTS_ACCEL_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_measurements_accel),
    0, /* time-out */
    read_accel,
    write_accel,
    NULL,
    NULL,
    NULL,
};

mip_error mip_measurements_accel_decode(struct mip_measurements_accel *value,
                                        const struct mip_field *field) {
    return mip_decode_field(field, read_accel, value, sizeof(*value), NULL);
}

mip_error mip_measurements_accel_encode(const struct mip_measurements_accel *value,
                                        struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_MEASUREMENTS_ACCEL_DESCRIPTOR, write_accel, value);
}

static void read_numbers(struct mip_reader *r, void *value) {
    struct mip_measurements_numbers *v = (struct mip_measurements_numbers *)value;
    mip_read_u8(r, &v->u8, 1);
    mip_read_u16(r, &v->u16, 1);
    mip_read_u32(r, &v->u32, 1);
    mip_read_u64(r, &v->u64, 1);
    mip_read_s8(r, &v->s8, 1);
    mip_read_s16(r, &v->s16, 1);
    mip_read_s32(r, &v->s32, 1);
    mip_read_s64(r, &v->s64, 1);
    mip_read_float(r, &v->float_, 1);
    mip_read_double(r, &v->double_, 1);
    mip_read_bool(r, &v->bool_, 1);
    mip_read_char(r, &v->char_, 1);
}

static void write_numbers(struct mip_writer *w, const void *value) {
    const struct mip_measurements_numbers *v = (const struct mip_measurements_numbers *)value;
    mip_write_u8(w, &v->u8, 1);
    mip_write_u16(w, &v->u16, 1);
    mip_write_u32(w, &v->u32, 1);
    mip_write_u64(w, &v->u64, 1);
    mip_write_s8(w, &v->s8, 1);
    mip_write_s16(w, &v->s16, 1);
    mip_write_s32(w, &v->s32, 1);
    mip_write_s64(w, &v->s64, 1);
    mip_write_float(w, &v->float_, 1);
    mip_write_double(w, &v->double_, 1);
    mip_write_bool(w, &v->bool_, 1);
    mip_write_char(w, &v->char_, 1);
}

const struct mip_codec mip_measurements_numbers_codec = {
    0x80, /* descriptor set */
    MIP_MEASUREMENTS_NUMBERS_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_measurements_numbers),
    0, /* time-out */
    read_numbers,
    write_numbers,
    NULL,
    NULL,
    NULL,
};

mip_error mip_measurements_numbers_decode(struct mip_measurements_numbers *value,
                                          const struct mip_field *field) {
    return mip_decode_field(field, read_numbers, value, sizeof(*value), NULL);
}

mip_error mip_measurements_numbers_encode(const struct mip_measurements_numbers *value,
                                          struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_MEASUREMENTS_NUMBERS_DESCRIPTOR, write_numbers,
                            value);
}

static void read_strings(struct mip_reader *r, void *value) {
    struct mip_measurements_strings *v = (struct mip_measurements_strings *)value;
    mip_read_char(r, v->model, 16);
    mip_read_u8(r, &v->length, 1);
    mip_read_char(r, v->name, mip_read_count(r, v->length, 236, 1));
    v->rest_count = (uint8_t)mip_read_rest(r, 236, 1);
    mip_read_char(r, v->rest, v->rest_count);
}

static void write_strings(struct mip_writer *w, const void *value) {
    const struct mip_measurements_strings *v = (const struct mip_measurements_strings *)value;
    mip_write_char(w, v->model, 16);
    mip_write_u8(w, &v->length, 1);
    mip_write_char(w, v->name, mip_write_count(w, v->length, 236));
    mip_write_char(w, v->rest, mip_write_count(w, v->rest_count, 236));
}

const struct mip_codec mip_measurements_strings_codec = {
    0x80, /* descriptor set */
    MIP_MEASUREMENTS_STRINGS_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_measurements_strings),
    0, /* time-out */
    read_strings,
    write_strings,
    NULL,
    NULL,
    NULL,
};

mip_error mip_measurements_strings_decode(struct mip_measurements_strings *value,
                                          const struct mip_field *field) {
    return mip_decode_field(field, read_strings, value, sizeof(*value), NULL);
}

mip_error mip_measurements_strings_encode(const struct mip_measurements_strings *value,
                                          struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_MEASUREMENTS_STRINGS_DESCRIPTOR, write_strings,
                            value);
}

static void read_health(struct mip_reader *r, void *value) {
    struct mip_measurements_health *v = (struct mip_measurements_health *)value;
    mip_read_u8(r, v->result.bytes, 16);
    mip_read_u32(r, &v->code, 1);
}

static void write_health(struct mip_writer *w, const void *value) {
    const struct mip_measurements_health *v = (const struct mip_measurements_health *)value;
    mip_write_u8(w, v->result.bytes, 16);
    mip_write_u32(w, &v->code, 1);
}

const struct mip_codec mip_measurements_health_codec = {
    0x80, /* descriptor set */
    MIP_MEASUREMENTS_HEALTH_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_measurements_health),
    0, /* time-out */
    read_health,
    write_health,
    NULL,
    NULL,
    NULL,
};

mip_error mip_measurements_health_decode(struct mip_measurements_health *value,
                                         const struct mip_field *field) {
    return mip_decode_field(field, read_health, value, sizeof(*value), NULL);
}

mip_error mip_measurements_health_encode(const struct mip_measurements_health *value,
                                         struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_MEASUREMENTS_HEALTH_DESCRIPTOR, write_health, value);
}

static void read_arrays(struct mip_reader *r, void *value) {
    struct mip_measurements_arrays *v = (struct mip_measurements_arrays *)value;
    mip_read_u8(r, v->modes, 3);
    mip_read_u16(r, v->flags, 2);
    for (size_t i = 0, n = 2; i < n; i++) {
        mip_read_float(r, v->vectors[i], 3);
    }
    for (size_t i = 0, n = 2; i < n; i++) {
        mip_point_read(r, &v->points[i]);
    }
    mip_segment_read(r, &v->track);
    mip_read_s8(r, v->offsets, 4);
}

static void write_arrays(struct mip_writer *w, const void *value) {
    const struct mip_measurements_arrays *v = (const struct mip_measurements_arrays *)value;
    mip_write_u8(w, v->modes, 3);
    mip_write_u16(w, v->flags, 2);
    for (size_t i = 0, n = 2; i < n; i++) {
        mip_write_float(w, v->vectors[i], 3);
    }
    for (size_t i = 0, n = 2; i < n; i++) {
        mip_point_write(w, &v->points[i]);
    }
    mip_segment_write(w, &v->track);
    mip_write_s8(w, v->offsets, 4);
}

const struct mip_codec mip_measurements_arrays_codec = {
    0x80, /* descriptor set */
    MIP_MEASUREMENTS_ARRAYS_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_measurements_arrays),
    0, /* time-out */
    read_arrays,
    write_arrays,
    NULL,
    NULL,
    NULL,
};

mip_error mip_measurements_arrays_decode(struct mip_measurements_arrays *value,
                                         const struct mip_field *field) {
    return mip_decode_field(field, read_arrays, value, sizeof(*value), NULL);
}

mip_error mip_measurements_arrays_encode(const struct mip_measurements_arrays *value,
                                         struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_MEASUREMENTS_ARRAYS_DESCRIPTOR, write_arrays, value);
}

static void read_growing(struct mip_reader *r, void *value) {
    struct mip_measurements_growing *v = (struct mip_measurements_growing *)value;
    mip_read_u16(r, &v->first, 1);
    mip_read_group(r, 2, 2);
    mip_read_u16(r, &v->second, 1);
    mip_read_group(r, 3, 3);
    mip_read_float(r, &v->third, 1);
    v->present = mip_read_present(r);
}

static void write_growing(struct mip_writer *w, const void *value) {
    const struct mip_measurements_growing *v = (const struct mip_measurements_growing *)value;
    w->present = v->present;
    mip_write_u16(w, &v->first, 1);
    mip_write_group(w, 2, 2);
    mip_write_u16(w, &v->second, 1);
    mip_write_group(w, 3, 3);
    mip_write_float(w, &v->third, 1);
}

const struct mip_codec mip_measurements_growing_codec = {
    0x80, /* descriptor set */
    MIP_MEASUREMENTS_GROWING_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_measurements_growing),
    0, /* time-out */
    read_growing,
    write_growing,
    NULL,
    NULL,
    NULL,
};

mip_error mip_measurements_growing_decode(struct mip_measurements_growing *value,
                                          const struct mip_field *field) {
    return mip_decode_field(field, read_growing, value, sizeof(*value), NULL);
}

mip_error mip_measurements_growing_encode(const struct mip_measurements_growing *value,
                                          struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_MEASUREMENTS_GROWING_DESCRIPTOR, write_growing,
                            value);
}

static void read_radio(struct mip_reader *r, void *value) {
    struct mip_measurements_radio *v = (struct mip_measurements_radio *)value;
    mip_read_bool(r, &v->connected, 1);
    mip_read_s32(r, &v->strength, 1);
    mip_read_float(r, &v->noise, 1);
    mip_read_float(r, &v->gap, 1);
    mip_read_double(r, v->gaps, 2);
}

static void write_radio(struct mip_writer *w, const void *value) {
    const struct mip_measurements_radio *v = (const struct mip_measurements_radio *)value;
    mip_write_bool(w, &v->connected, 1);
    mip_write_s32(w, &v->strength, 1);
    mip_write_float(w, &v->noise, 1);
    mip_write_float(w, &v->gap, 1);
    mip_write_double(w, v->gaps, 2);
}

const struct mip_codec mip_measurements_radio_codec = {
    0x80, /* descriptor set */
    MIP_MEASUREMENTS_RADIO_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_measurements_radio),
    0, /* time-out */
    read_radio,
    write_radio,
    NULL,
    NULL,
    NULL,
};

mip_error mip_measurements_radio_decode(struct mip_measurements_radio *value,
                                        const struct mip_field *field) {
    return mip_decode_field(field, read_radio, value, sizeof(*value), NULL);
}

mip_error mip_measurements_radio_encode(const struct mip_measurements_radio *value,
                                        struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_MEASUREMENTS_RADIO_DESCRIPTOR, write_radio, value);
}

static void read_cloud(struct mip_reader *r, void *value) {
    struct mip_measurements_cloud *v = (struct mip_measurements_cloud *)value;
    mip_read_u8(r, &v->num_points, 1);
    for (size_t i = 0, n = mip_read_count(r, v->num_points, 61, 4); i < n; i++) {
        mip_point_read(r, &v->points[i]);
    }
    mip_read_u64(r, &v->stamp, 1);
}

static void write_cloud(struct mip_writer *w, const void *value) {
    const struct mip_measurements_cloud *v = (const struct mip_measurements_cloud *)value;
    mip_write_u8(w, &v->num_points, 1);
    for (size_t i = 0, n = mip_write_count(w, v->num_points, 61); i < n; i++) {
        mip_point_write(w, &v->points[i]);
    }
    mip_write_u64(w, &v->stamp, 1);
}

const struct mip_codec mip_measurements_cloud_codec = {
    0x80, /* descriptor set */
    MIP_MEASUREMENTS_CLOUD_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_measurements_cloud),
    0, /* time-out */
    read_cloud,
    write_cloud,
    NULL,
    NULL,
    NULL,
};

mip_error mip_measurements_cloud_decode(struct mip_measurements_cloud *value,
                                        const struct mip_field *field) {
    return mip_decode_field(field, read_cloud, value, sizeof(*value), NULL);
}

mip_error mip_measurements_cloud_encode(const struct mip_measurements_cloud *value,
                                        struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_MEASUREMENTS_CLOUD_DESCRIPTOR, write_cloud, value);
}

static void read_gust(struct mip_reader *r, void *value) {
    struct mip_measurements_gust *v = (struct mip_measurements_gust *)value;
    mip_read_u8(r, &v->station, 1);
    mip_point_read(r, &v->place);
    mip_read_float(r, &v->height, 1);
    mip_read_float(r, v->speed, 3);
    mip_read_constant(r, 7, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_gust(struct mip_writer *w, const void *value) {
    const struct mip_measurements_gust *v = (const struct mip_measurements_gust *)value;
    mip_write_u8(w, &v->station, 1);
    mip_point_write(w, &v->place);
    mip_write_float(w, &v->height, 1);
    mip_write_float(w, v->speed, 3);
    mip_write_constant(w, 7, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_measurements_gust_codec = {
    0x80, /* descriptor set */
    MIP_MEASUREMENTS_GUST_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_measurements_gust),
    0, /* time-out */
    read_gust,
    write_gust,
    NULL,
    NULL,
    NULL,
};

mip_error mip_measurements_gust_decode(struct mip_measurements_gust *value,
                                       const struct mip_field *field) {
    return mip_decode_field(field, read_gust, value, sizeof(*value), NULL);
}

mip_error mip_measurements_gust_encode(const struct mip_measurements_gust *value,
                                       struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_MEASUREMENTS_GUST_DESCRIPTOR, write_gust, value);
}

static void read_breeze(struct mip_reader *r, void *value) {
    struct mip_measurements_breeze *v = (struct mip_measurements_breeze *)value;
    mip_point_read(r, &v->place);
    mip_read_float(r, &v->height, 1);
    mip_read_float(r, v->turn, 4);
}

static void write_breeze(struct mip_writer *w, const void *value) {
    const struct mip_measurements_breeze *v = (const struct mip_measurements_breeze *)value;
    mip_point_write(w, &v->place);
    mip_write_float(w, &v->height, 1);
    mip_write_float(w, v->turn, 4);
}

const struct mip_codec mip_measurements_breeze_codec = {
    0x80, /* descriptor set */
    MIP_MEASUREMENTS_BREEZE_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_measurements_breeze),
    0, /* time-out */
    read_breeze,
    write_breeze,
    NULL,
    NULL,
    NULL,
};

mip_error mip_measurements_breeze_decode(struct mip_measurements_breeze *value,
                                         const struct mip_field *field) {
    return mip_decode_field(field, read_breeze, value, sizeof(*value), NULL);
}

mip_error mip_measurements_breeze_encode(const struct mip_measurements_breeze *value,
                                         struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_MEASUREMENTS_BREEZE_DESCRIPTOR, write_breeze, value);
}
