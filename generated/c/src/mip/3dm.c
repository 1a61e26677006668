/* 3DM. */
#include "mip/3dm.h"

#include <string.h>

void mip_3dm_poll_entry_read(struct mip_reader *r, struct mip_3dm_poll_entry *v) {
    mip_read_u8(r, &v->descriptor, 1);
    mip_read_u16(r, &v->reserved, 1);
}

void mip_3dm_poll_entry_write(struct mip_writer *w, const struct mip_3dm_poll_entry *v) {
    mip_write_u8(w, &v->descriptor, 1);
    mip_write_u16(w, &v->reserved, 1);
}

void mip_3dm_constellation_settings_entry_read(struct mip_reader *r,
                                               struct mip_3dm_constellation_settings_entry *v) {
    mip_read_u8(r, &v->constellation_id, 1);
    mip_read_u8(r, &v->enable, 1);
    mip_read_u8(r, &v->reserved_channels, 1);
    mip_read_u8(r, &v->max_channels, 1);
    mip_read_u16(r, &v->option_flags, 1);
}

void mip_3dm_constellation_settings_entry_write(
    struct mip_writer *w, const struct mip_3dm_constellation_settings_entry *v) {
    mip_write_u8(w, &v->constellation_id, 1);
    mip_write_u8(w, &v->enable, 1);
    mip_write_u8(w, &v->reserved_channels, 1);
    mip_write_u8(w, &v->max_channels, 1);
    mip_write_u16(w, &v->option_flags, 1);
}

void mip_3dm_event_support_info_read(struct mip_reader *r, struct mip_3dm_event_support_info *v) {
    mip_read_u8(r, &v->type, 1);
    mip_read_u8(r, &v->count, 1);
}

void mip_3dm_event_support_info_write(struct mip_writer *w,
                                      const struct mip_3dm_event_support_info *v) {
    mip_write_u8(w, &v->type, 1);
    mip_write_u8(w, &v->count, 1);
}

void mip_3dm_event_trigger_status_entry_read(struct mip_reader *r,
                                             struct mip_3dm_event_trigger_status_entry *v) {
    mip_read_u8(r, &v->type, 1);
    mip_read_u8(r, &v->status, 1);
}

void mip_3dm_event_trigger_status_entry_write(struct mip_writer *w,
                                              const struct mip_3dm_event_trigger_status_entry *v) {
    mip_write_u8(w, &v->type, 1);
    mip_write_u8(w, &v->status, 1);
}

void mip_3dm_event_action_status_entry_read(struct mip_reader *r,
                                            struct mip_3dm_event_action_status_entry *v) {
    mip_read_u8(r, &v->action_type, 1);
    mip_read_u8(r, &v->trigger_id, 1);
}

void mip_3dm_event_action_status_entry_write(struct mip_writer *w,
                                             const struct mip_3dm_event_action_status_entry *v) {
    mip_write_u8(w, &v->action_type, 1);
    mip_write_u8(w, &v->trigger_id, 1);
}

void mip_3dm_sensor_range_entry_read(struct mip_reader *r, struct mip_3dm_sensor_range_entry *v) {
    mip_read_u8(r, &v->setting, 1);
    mip_read_float(r, &v->range, 1);
}

void mip_3dm_sensor_range_entry_write(struct mip_writer *w,
                                      const struct mip_3dm_sensor_range_entry *v) {
    mip_write_u8(w, &v->setting, 1);
    mip_write_float(w, &v->range, 1);
}

static void read_poll_imu_data(struct mip_reader *r, void *value) {
    struct mip_3dm_poll_imu_data *v = (struct mip_3dm_poll_imu_data *)value;
    mip_read_bool(r, &v->suppress_ack, 1);
    mip_read_u8(r, &v->num_descriptors, 1);
    for (size_t i = 0, n = mip_read_count(r, v->num_descriptors, 83, 3); i < n; i++) {
        mip_3dm_poll_entry_read(r, &v->descriptors[i]);
    }
}

static void write_poll_imu_data(struct mip_writer *w, const void *value) {
    const struct mip_3dm_poll_imu_data *v = (const struct mip_3dm_poll_imu_data *)value;
    mip_write_bool(w, &v->suppress_ack, 1);
    mip_write_u8(w, &v->num_descriptors, 1);
    for (size_t i = 0, n = mip_write_count(w, v->num_descriptors, 83); i < n; i++) {
        mip_3dm_poll_entry_write(w, &v->descriptors[i]);
    }
}

static bool silent_poll_imu_data(const void *value) {
    const struct mip_3dm_poll_imu_data *v = (const struct mip_3dm_poll_imu_data *)value;
    return v->suppress_ack == 1;
}

const struct mip_codec mip_3dm_poll_imu_data_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_POLL_IMU_DATA_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_poll_imu_data),
    0, /* time-out */
    read_poll_imu_data,
    write_poll_imu_data,
    silent_poll_imu_data,
    NULL,
    NULL,
};

mip_error mip_3dm_poll_imu_data_decode(struct mip_3dm_poll_imu_data *value,
                                       const struct mip_field *field) {
    return mip_decode_field(field, read_poll_imu_data, value, sizeof(*value), NULL);
}

mip_error mip_3dm_poll_imu_data_encode(const struct mip_3dm_poll_imu_data *value,
                                       struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_POLL_IMU_DATA_DESCRIPTOR, write_poll_imu_data,
                            value);
}

struct mip_3dm_poll_imu_data mip_3dm_poll_imu_data_make(
    mip_bool suppress_ack, uint8_t num_descriptors, const struct mip_3dm_poll_entry descriptors[]) {
    struct mip_3dm_poll_imu_data v;
    memset(&v, 0, sizeof(v));
    v.suppress_ack = suppress_ack;
    v.num_descriptors = num_descriptors;
    mip_copy(v.descriptors, sizeof(v.descriptors), descriptors,
             num_descriptors * sizeof(descriptors[0]));
    return v;
}

static void read_poll_gnss_data(struct mip_reader *r, void *value) {
    struct mip_3dm_poll_gnss_data *v = (struct mip_3dm_poll_gnss_data *)value;
    mip_read_bool(r, &v->suppress_ack, 1);
    mip_read_u8(r, &v->num_descriptors, 1);
    for (size_t i = 0, n = mip_read_count(r, v->num_descriptors, 83, 3); i < n; i++) {
        mip_3dm_poll_entry_read(r, &v->descriptors[i]);
    }
}

static void write_poll_gnss_data(struct mip_writer *w, const void *value) {
    const struct mip_3dm_poll_gnss_data *v = (const struct mip_3dm_poll_gnss_data *)value;
    mip_write_bool(w, &v->suppress_ack, 1);
    mip_write_u8(w, &v->num_descriptors, 1);
    for (size_t i = 0, n = mip_write_count(w, v->num_descriptors, 83); i < n; i++) {
        mip_3dm_poll_entry_write(w, &v->descriptors[i]);
    }
}

static bool silent_poll_gnss_data(const void *value) {
    const struct mip_3dm_poll_gnss_data *v = (const struct mip_3dm_poll_gnss_data *)value;
    return v->suppress_ack == 1;
}

const struct mip_codec mip_3dm_poll_gnss_data_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_POLL_GNSS_DATA_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_poll_gnss_data),
    0, /* time-out */
    read_poll_gnss_data,
    write_poll_gnss_data,
    silent_poll_gnss_data,
    NULL,
    NULL,
};

mip_error mip_3dm_poll_gnss_data_decode(struct mip_3dm_poll_gnss_data *value,
                                        const struct mip_field *field) {
    return mip_decode_field(field, read_poll_gnss_data, value, sizeof(*value), NULL);
}

mip_error mip_3dm_poll_gnss_data_encode(const struct mip_3dm_poll_gnss_data *value,
                                        struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_POLL_GNSS_DATA_DESCRIPTOR, write_poll_gnss_data,
                            value);
}

struct mip_3dm_poll_gnss_data mip_3dm_poll_gnss_data_make(
    mip_bool suppress_ack, uint8_t num_descriptors, const struct mip_3dm_poll_entry descriptors[]) {
    struct mip_3dm_poll_gnss_data v;
    memset(&v, 0, sizeof(v));
    v.suppress_ack = suppress_ack;
    v.num_descriptors = num_descriptors;
    mip_copy(v.descriptors, sizeof(v.descriptors), descriptors,
             num_descriptors * sizeof(descriptors[0]));
    return v;
}

static void read_poll_filter_data(struct mip_reader *r, void *value) {
    struct mip_3dm_poll_filter_data *v = (struct mip_3dm_poll_filter_data *)value;
    mip_read_bool(r, &v->suppress_ack, 1);
    mip_read_u8(r, &v->num_descriptors, 1);
    for (size_t i = 0, n = mip_read_count(r, v->num_descriptors, 83, 3); i < n; i++) {
        mip_3dm_poll_entry_read(r, &v->descriptors[i]);
    }
}

static void write_poll_filter_data(struct mip_writer *w, const void *value) {
    const struct mip_3dm_poll_filter_data *v = (const struct mip_3dm_poll_filter_data *)value;
    mip_write_bool(w, &v->suppress_ack, 1);
    mip_write_u8(w, &v->num_descriptors, 1);
    for (size_t i = 0, n = mip_write_count(w, v->num_descriptors, 83); i < n; i++) {
        mip_3dm_poll_entry_write(w, &v->descriptors[i]);
    }
}

static bool silent_poll_filter_data(const void *value) {
    const struct mip_3dm_poll_filter_data *v = (const struct mip_3dm_poll_filter_data *)value;
    return v->suppress_ack == 1;
}

const struct mip_codec mip_3dm_poll_filter_data_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_POLL_FILTER_DATA_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_poll_filter_data),
    0, /* time-out */
    read_poll_filter_data,
    write_poll_filter_data,
    silent_poll_filter_data,
    NULL,
    NULL,
};

mip_error mip_3dm_poll_filter_data_decode(struct mip_3dm_poll_filter_data *value,
                                          const struct mip_field *field) {
    return mip_decode_field(field, read_poll_filter_data, value, sizeof(*value), NULL);
}

mip_error mip_3dm_poll_filter_data_encode(const struct mip_3dm_poll_filter_data *value,
                                          struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_POLL_FILTER_DATA_DESCRIPTOR,
                            write_poll_filter_data, value);
}

struct mip_3dm_poll_filter_data mip_3dm_poll_filter_data_make(
    mip_bool suppress_ack, uint8_t num_descriptors, const struct mip_3dm_poll_entry descriptors[]) {
    struct mip_3dm_poll_filter_data v;
    memset(&v, 0, sizeof(v));
    v.suppress_ack = suppress_ack;
    v.num_descriptors = num_descriptors;
    mip_copy(v.descriptors, sizeof(v.descriptors), descriptors,
             num_descriptors * sizeof(descriptors[0]));
    return v;
}

static void read_poll_nmea_data(struct mip_reader *r, void *value) {
    struct mip_3dm_poll_nmea_data *v = (struct mip_3dm_poll_nmea_data *)value;
    mip_read_bool(r, &v->suppress_ack, 1);
    mip_read_u8(r, &v->count, 1);
    for (size_t i = 0, n = mip_read_count(r, v->count, 50, 5); i < n; i++) {
        mip_nmea_message_read(r, &v->format_entries[i]);
    }
}

static void write_poll_nmea_data(struct mip_writer *w, const void *value) {
    const struct mip_3dm_poll_nmea_data *v = (const struct mip_3dm_poll_nmea_data *)value;
    mip_write_bool(w, &v->suppress_ack, 1);
    mip_write_u8(w, &v->count, 1);
    for (size_t i = 0, n = mip_write_count(w, v->count, 50); i < n; i++) {
        mip_nmea_message_write(w, &v->format_entries[i]);
    }
}

static bool silent_poll_nmea_data(const void *value) {
    const struct mip_3dm_poll_nmea_data *v = (const struct mip_3dm_poll_nmea_data *)value;
    return v->suppress_ack == 1;
}

const struct mip_codec mip_3dm_poll_nmea_data_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_POLL_NMEA_DATA_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_poll_nmea_data),
    0, /* time-out */
    read_poll_nmea_data,
    write_poll_nmea_data,
    silent_poll_nmea_data,
    NULL,
    NULL,
};

mip_error mip_3dm_poll_nmea_data_decode(struct mip_3dm_poll_nmea_data *value,
                                        const struct mip_field *field) {
    return mip_decode_field(field, read_poll_nmea_data, value, sizeof(*value), NULL);
}

mip_error mip_3dm_poll_nmea_data_encode(const struct mip_3dm_poll_nmea_data *value,
                                        struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_POLL_NMEA_DATA_DESCRIPTOR, write_poll_nmea_data,
                            value);
}

struct mip_3dm_poll_nmea_data mip_3dm_poll_nmea_data_make(
    mip_bool suppress_ack, uint8_t count, const struct mip_nmea_message format_entries[]) {
    struct mip_3dm_poll_nmea_data v;
    memset(&v, 0, sizeof(v));
    v.suppress_ack = suppress_ack;
    v.count = count;
    mip_copy(v.format_entries, sizeof(v.format_entries), format_entries,
             count * sizeof(format_entries[0]));
    return v;
}

static const struct mip_response responses_get_imu_base_rate[] = {
    {&mip_3dm_get_imu_base_rate_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_get_imu_base_rate_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GET_IMU_BASE_RATE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_get_imu_base_rate),
    0, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    responses_get_imu_base_rate,
    NULL,
};

mip_error mip_3dm_get_imu_base_rate_decode(struct mip_3dm_get_imu_base_rate *value,
                                           const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_3dm_get_imu_base_rate_encode(const struct mip_3dm_get_imu_base_rate *value,
                                           struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GET_IMU_BASE_RATE_DESCRIPTOR, mip_write_nothing,
                            value);
}

static void read_get_imu_base_rate_response(struct mip_reader *r, void *value) {
    struct mip_3dm_get_imu_base_rate_response *v =
        (struct mip_3dm_get_imu_base_rate_response *)value;
    mip_read_u16(r, &v->rate, 1);
}

static void write_get_imu_base_rate_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_get_imu_base_rate_response *v =
        (const struct mip_3dm_get_imu_base_rate_response *)value;
    mip_write_u16(w, &v->rate, 1);
}

const struct mip_codec mip_3dm_get_imu_base_rate_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GET_IMU_BASE_RATE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_get_imu_base_rate_response),
    0, /* time-out */
    read_get_imu_base_rate_response,
    write_get_imu_base_rate_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_get_imu_base_rate_response_decode(
    struct mip_3dm_get_imu_base_rate_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_get_imu_base_rate_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_get_imu_base_rate_response_encode(
    const struct mip_3dm_get_imu_base_rate_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GET_IMU_BASE_RATE_RESPONSE_DESCRIPTOR,
                            write_get_imu_base_rate_response, value);
}

static const struct mip_response responses_get_gnss_base_rate[] = {
    {&mip_3dm_get_gnss_base_rate_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_get_gnss_base_rate_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GET_GNSS_BASE_RATE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_get_gnss_base_rate),
    0, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    responses_get_gnss_base_rate,
    NULL,
};

mip_error mip_3dm_get_gnss_base_rate_decode(struct mip_3dm_get_gnss_base_rate *value,
                                            const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_3dm_get_gnss_base_rate_encode(const struct mip_3dm_get_gnss_base_rate *value,
                                            struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GET_GNSS_BASE_RATE_DESCRIPTOR, mip_write_nothing,
                            value);
}

static void read_get_gnss_base_rate_response(struct mip_reader *r, void *value) {
    struct mip_3dm_get_gnss_base_rate_response *v =
        (struct mip_3dm_get_gnss_base_rate_response *)value;
    mip_read_u16(r, &v->rate, 1);
}

static void write_get_gnss_base_rate_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_get_gnss_base_rate_response *v =
        (const struct mip_3dm_get_gnss_base_rate_response *)value;
    mip_write_u16(w, &v->rate, 1);
}

const struct mip_codec mip_3dm_get_gnss_base_rate_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GET_GNSS_BASE_RATE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_get_gnss_base_rate_response),
    0, /* time-out */
    read_get_gnss_base_rate_response,
    write_get_gnss_base_rate_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_get_gnss_base_rate_response_decode(
    struct mip_3dm_get_gnss_base_rate_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_get_gnss_base_rate_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_get_gnss_base_rate_response_encode(
    const struct mip_3dm_get_gnss_base_rate_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GET_GNSS_BASE_RATE_RESPONSE_DESCRIPTOR,
                            write_get_gnss_base_rate_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_imu_message_format[] = {0, 2, 0, 0, 0, 0};

static void read_imu_message_format(struct mip_reader *r, void *value) {
    struct mip_3dm_imu_message_format *v = (struct mip_3dm_imu_message_format *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_imu_message_format,
                      sizeof(required_imu_message_format));
    mip_read_group(r, 1, 2);
    mip_read_u8(r, &v->num_descriptors, 1);
    for (size_t i = 0, n = mip_read_count(r, v->num_descriptors, 83, 3); i < n; i++) {
        mip_descriptor_rate_read(r, &v->descriptors[i]);
    }
    v->present = mip_read_present(r);
}

static void write_imu_message_format(struct mip_writer *w, const void *value) {
    const struct mip_3dm_imu_message_format *v = (const struct mip_3dm_imu_message_format *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_imu_message_format,
                       sizeof(required_imu_message_format), v->present);
    mip_write_group(w, 1, 2);
    mip_write_u8(w, &v->num_descriptors, 1);
    for (size_t i = 0, n = mip_write_count(w, v->num_descriptors, 83); i < n; i++) {
        mip_descriptor_rate_write(w, &v->descriptors[i]);
    }
}

static bool asked_imu_message_format_1(const void *value) {
    const struct mip_3dm_imu_message_format *v = (const struct mip_3dm_imu_message_format *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_imu_message_format[] = {
    {&mip_3dm_imu_message_format_response_codec, asked_imu_message_format_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_imu_message_format_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_IMU_MESSAGE_FORMAT_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_imu_message_format),
    0, /* time-out */
    read_imu_message_format,
    write_imu_message_format,
    NULL,
    responses_imu_message_format,
    NULL,
};

mip_error mip_3dm_imu_message_format_decode(struct mip_3dm_imu_message_format *value,
                                            const struct mip_field *field) {
    return mip_decode_field(field, read_imu_message_format, value, sizeof(*value), NULL);
}

mip_error mip_3dm_imu_message_format_encode(const struct mip_3dm_imu_message_format *value,
                                            struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_IMU_MESSAGE_FORMAT_DESCRIPTOR,
                            write_imu_message_format, value);
}

struct mip_3dm_imu_message_format mip_3dm_imu_message_format_write(
    uint8_t num_descriptors, const struct mip_descriptor_rate descriptors[]) {
    struct mip_3dm_imu_message_format v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.num_descriptors = num_descriptors;
    mip_copy(v.descriptors, sizeof(v.descriptors), descriptors,
             num_descriptors * sizeof(descriptors[0]));
    return v;
}

struct mip_3dm_imu_message_format mip_3dm_imu_message_format_read(void) {
    struct mip_3dm_imu_message_format v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_3dm_imu_message_format mip_3dm_imu_message_format_save(void) {
    struct mip_3dm_imu_message_format v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_3dm_imu_message_format mip_3dm_imu_message_format_load(void) {
    struct mip_3dm_imu_message_format v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_3dm_imu_message_format mip_3dm_imu_message_format_default(void) {
    struct mip_3dm_imu_message_format v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_imu_message_format_response(struct mip_reader *r, void *value) {
    struct mip_3dm_imu_message_format_response *v =
        (struct mip_3dm_imu_message_format_response *)value;
    mip_read_u8(r, &v->num_descriptors, 1);
    for (size_t i = 0, n = mip_read_count(r, v->num_descriptors, 84, 3); i < n; i++) {
        mip_descriptor_rate_read(r, &v->descriptors[i]);
    }
}

static void write_imu_message_format_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_imu_message_format_response *v =
        (const struct mip_3dm_imu_message_format_response *)value;
    mip_write_u8(w, &v->num_descriptors, 1);
    for (size_t i = 0, n = mip_write_count(w, v->num_descriptors, 84); i < n; i++) {
        mip_descriptor_rate_write(w, &v->descriptors[i]);
    }
}

const struct mip_codec mip_3dm_imu_message_format_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_IMU_MESSAGE_FORMAT_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_imu_message_format_response),
    0, /* time-out */
    read_imu_message_format_response,
    write_imu_message_format_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_imu_message_format_response_decode(
    struct mip_3dm_imu_message_format_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_imu_message_format_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_imu_message_format_response_encode(
    const struct mip_3dm_imu_message_format_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_IMU_MESSAGE_FORMAT_RESPONSE_DESCRIPTOR,
                            write_imu_message_format_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_gnss_message_format[] = {0, 2, 0, 0, 0, 0};

static void read_gnss_message_format(struct mip_reader *r, void *value) {
    struct mip_3dm_gnss_message_format *v = (struct mip_3dm_gnss_message_format *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_gnss_message_format,
                      sizeof(required_gnss_message_format));
    mip_read_group(r, 1, 2);
    mip_read_u8(r, &v->num_descriptors, 1);
    for (size_t i = 0, n = mip_read_count(r, v->num_descriptors, 83, 3); i < n; i++) {
        mip_descriptor_rate_read(r, &v->descriptors[i]);
    }
    v->present = mip_read_present(r);
}

static void write_gnss_message_format(struct mip_writer *w, const void *value) {
    const struct mip_3dm_gnss_message_format *v = (const struct mip_3dm_gnss_message_format *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_gnss_message_format,
                       sizeof(required_gnss_message_format), v->present);
    mip_write_group(w, 1, 2);
    mip_write_u8(w, &v->num_descriptors, 1);
    for (size_t i = 0, n = mip_write_count(w, v->num_descriptors, 83); i < n; i++) {
        mip_descriptor_rate_write(w, &v->descriptors[i]);
    }
}

static bool asked_gnss_message_format_1(const void *value) {
    const struct mip_3dm_gnss_message_format *v = (const struct mip_3dm_gnss_message_format *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_gnss_message_format[] = {
    {&mip_3dm_gnss_message_format_response_codec, asked_gnss_message_format_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_gnss_message_format_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GNSS_MESSAGE_FORMAT_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_gnss_message_format),
    0, /* time-out */
    read_gnss_message_format,
    write_gnss_message_format,
    NULL,
    responses_gnss_message_format,
    NULL,
};

mip_error mip_3dm_gnss_message_format_decode(struct mip_3dm_gnss_message_format *value,
                                             const struct mip_field *field) {
    return mip_decode_field(field, read_gnss_message_format, value, sizeof(*value), NULL);
}

mip_error mip_3dm_gnss_message_format_encode(const struct mip_3dm_gnss_message_format *value,
                                             struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GNSS_MESSAGE_FORMAT_DESCRIPTOR,
                            write_gnss_message_format, value);
}

struct mip_3dm_gnss_message_format mip_3dm_gnss_message_format_write(
    uint8_t num_descriptors, const struct mip_descriptor_rate descriptors[]) {
    struct mip_3dm_gnss_message_format v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.num_descriptors = num_descriptors;
    mip_copy(v.descriptors, sizeof(v.descriptors), descriptors,
             num_descriptors * sizeof(descriptors[0]));
    return v;
}

struct mip_3dm_gnss_message_format mip_3dm_gnss_message_format_read(void) {
    struct mip_3dm_gnss_message_format v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_3dm_gnss_message_format mip_3dm_gnss_message_format_save(void) {
    struct mip_3dm_gnss_message_format v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_3dm_gnss_message_format mip_3dm_gnss_message_format_load(void) {
    struct mip_3dm_gnss_message_format v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_3dm_gnss_message_format mip_3dm_gnss_message_format_default(void) {
    struct mip_3dm_gnss_message_format v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_gnss_message_format_response(struct mip_reader *r, void *value) {
    struct mip_3dm_gnss_message_format_response *v =
        (struct mip_3dm_gnss_message_format_response *)value;
    mip_read_u8(r, &v->num_descriptors, 1);
    for (size_t i = 0, n = mip_read_count(r, v->num_descriptors, 84, 3); i < n; i++) {
        mip_descriptor_rate_read(r, &v->descriptors[i]);
    }
}

static void write_gnss_message_format_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_gnss_message_format_response *v =
        (const struct mip_3dm_gnss_message_format_response *)value;
    mip_write_u8(w, &v->num_descriptors, 1);
    for (size_t i = 0, n = mip_write_count(w, v->num_descriptors, 84); i < n; i++) {
        mip_descriptor_rate_write(w, &v->descriptors[i]);
    }
}

const struct mip_codec mip_3dm_gnss_message_format_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GNSS_MESSAGE_FORMAT_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_gnss_message_format_response),
    0, /* time-out */
    read_gnss_message_format_response,
    write_gnss_message_format_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_gnss_message_format_response_decode(
    struct mip_3dm_gnss_message_format_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_gnss_message_format_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_gnss_message_format_response_encode(
    const struct mip_3dm_gnss_message_format_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GNSS_MESSAGE_FORMAT_RESPONSE_DESCRIPTOR,
                            write_gnss_message_format_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_filter_message_format[] = {0, 2, 0, 0, 0, 0};

static void read_filter_message_format(struct mip_reader *r, void *value) {
    struct mip_3dm_filter_message_format *v = (struct mip_3dm_filter_message_format *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_filter_message_format,
                      sizeof(required_filter_message_format));
    mip_read_group(r, 1, 2);
    mip_read_u8(r, &v->num_descriptors, 1);
    for (size_t i = 0, n = mip_read_count(r, v->num_descriptors, 83, 3); i < n; i++) {
        mip_descriptor_rate_read(r, &v->descriptors[i]);
    }
    v->present = mip_read_present(r);
}

static void write_filter_message_format(struct mip_writer *w, const void *value) {
    const struct mip_3dm_filter_message_format *v =
        (const struct mip_3dm_filter_message_format *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_filter_message_format,
                       sizeof(required_filter_message_format), v->present);
    mip_write_group(w, 1, 2);
    mip_write_u8(w, &v->num_descriptors, 1);
    for (size_t i = 0, n = mip_write_count(w, v->num_descriptors, 83); i < n; i++) {
        mip_descriptor_rate_write(w, &v->descriptors[i]);
    }
}

static bool asked_filter_message_format_1(const void *value) {
    const struct mip_3dm_filter_message_format *v =
        (const struct mip_3dm_filter_message_format *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_filter_message_format[] = {
    {&mip_3dm_filter_message_format_response_codec, asked_filter_message_format_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_filter_message_format_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_FILTER_MESSAGE_FORMAT_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_filter_message_format),
    0, /* time-out */
    read_filter_message_format,
    write_filter_message_format,
    NULL,
    responses_filter_message_format,
    NULL,
};

mip_error mip_3dm_filter_message_format_decode(struct mip_3dm_filter_message_format *value,
                                               const struct mip_field *field) {
    return mip_decode_field(field, read_filter_message_format, value, sizeof(*value), NULL);
}

mip_error mip_3dm_filter_message_format_encode(const struct mip_3dm_filter_message_format *value,
                                               struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_FILTER_MESSAGE_FORMAT_DESCRIPTOR,
                            write_filter_message_format, value);
}

struct mip_3dm_filter_message_format mip_3dm_filter_message_format_write(
    uint8_t num_descriptors, const struct mip_descriptor_rate descriptors[]) {
    struct mip_3dm_filter_message_format v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.num_descriptors = num_descriptors;
    mip_copy(v.descriptors, sizeof(v.descriptors), descriptors,
             num_descriptors * sizeof(descriptors[0]));
    return v;
}

struct mip_3dm_filter_message_format mip_3dm_filter_message_format_read(void) {
    struct mip_3dm_filter_message_format v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_3dm_filter_message_format mip_3dm_filter_message_format_save(void) {
    struct mip_3dm_filter_message_format v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_3dm_filter_message_format mip_3dm_filter_message_format_load(void) {
    struct mip_3dm_filter_message_format v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_3dm_filter_message_format mip_3dm_filter_message_format_default(void) {
    struct mip_3dm_filter_message_format v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_filter_message_format_response(struct mip_reader *r, void *value) {
    struct mip_3dm_filter_message_format_response *v =
        (struct mip_3dm_filter_message_format_response *)value;
    mip_read_u8(r, &v->num_descriptors, 1);
    for (size_t i = 0, n = mip_read_count(r, v->num_descriptors, 84, 3); i < n; i++) {
        mip_descriptor_rate_read(r, &v->descriptors[i]);
    }
}

static void write_filter_message_format_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_filter_message_format_response *v =
        (const struct mip_3dm_filter_message_format_response *)value;
    mip_write_u8(w, &v->num_descriptors, 1);
    for (size_t i = 0, n = mip_write_count(w, v->num_descriptors, 84); i < n; i++) {
        mip_descriptor_rate_write(w, &v->descriptors[i]);
    }
}

const struct mip_codec mip_3dm_filter_message_format_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_FILTER_MESSAGE_FORMAT_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_filter_message_format_response),
    0, /* time-out */
    read_filter_message_format_response,
    write_filter_message_format_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_filter_message_format_response_decode(
    struct mip_3dm_filter_message_format_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_filter_message_format_response, value, sizeof(*value),
                            NULL);
}

mip_error mip_3dm_filter_message_format_response_encode(
    const struct mip_3dm_filter_message_format_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_FILTER_MESSAGE_FORMAT_RESPONSE_DESCRIPTOR,
                            write_filter_message_format_response, value);
}

static const struct mip_response responses_get_filter_base_rate[] = {
    {&mip_3dm_get_filter_base_rate_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_get_filter_base_rate_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GET_FILTER_BASE_RATE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_get_filter_base_rate),
    0, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    responses_get_filter_base_rate,
    NULL,
};

mip_error mip_3dm_get_filter_base_rate_decode(struct mip_3dm_get_filter_base_rate *value,
                                              const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_3dm_get_filter_base_rate_encode(const struct mip_3dm_get_filter_base_rate *value,
                                              struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GET_FILTER_BASE_RATE_DESCRIPTOR,
                            mip_write_nothing, value);
}

static void read_get_filter_base_rate_response(struct mip_reader *r, void *value) {
    struct mip_3dm_get_filter_base_rate_response *v =
        (struct mip_3dm_get_filter_base_rate_response *)value;
    mip_read_u16(r, &v->rate, 1);
}

static void write_get_filter_base_rate_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_get_filter_base_rate_response *v =
        (const struct mip_3dm_get_filter_base_rate_response *)value;
    mip_write_u16(w, &v->rate, 1);
}

const struct mip_codec mip_3dm_get_filter_base_rate_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GET_FILTER_BASE_RATE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_get_filter_base_rate_response),
    0, /* time-out */
    read_get_filter_base_rate_response,
    write_get_filter_base_rate_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_get_filter_base_rate_response_decode(
    struct mip_3dm_get_filter_base_rate_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_get_filter_base_rate_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_get_filter_base_rate_response_encode(
    const struct mip_3dm_get_filter_base_rate_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GET_FILTER_BASE_RATE_RESPONSE_DESCRIPTOR,
                            write_get_filter_base_rate_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_nmea_message_format[] = {0, 2, 0, 0, 0, 0};

static void read_nmea_message_format(struct mip_reader *r, void *value) {
    struct mip_3dm_nmea_message_format *v = (struct mip_3dm_nmea_message_format *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_nmea_message_format,
                      sizeof(required_nmea_message_format));
    mip_read_group(r, 1, 2);
    mip_read_u8(r, &v->count, 1);
    for (size_t i = 0, n = mip_read_count(r, v->count, 50, 5); i < n; i++) {
        mip_nmea_message_read(r, &v->format_entries[i]);
    }
    v->present = mip_read_present(r);
}

static void write_nmea_message_format(struct mip_writer *w, const void *value) {
    const struct mip_3dm_nmea_message_format *v = (const struct mip_3dm_nmea_message_format *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_nmea_message_format,
                       sizeof(required_nmea_message_format), v->present);
    mip_write_group(w, 1, 2);
    mip_write_u8(w, &v->count, 1);
    for (size_t i = 0, n = mip_write_count(w, v->count, 50); i < n; i++) {
        mip_nmea_message_write(w, &v->format_entries[i]);
    }
}

static bool asked_nmea_message_format_1(const void *value) {
    const struct mip_3dm_nmea_message_format *v = (const struct mip_3dm_nmea_message_format *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_nmea_message_format[] = {
    {&mip_3dm_nmea_message_format_response_codec, asked_nmea_message_format_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_nmea_message_format_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_NMEA_MESSAGE_FORMAT_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_nmea_message_format),
    0, /* time-out */
    read_nmea_message_format,
    write_nmea_message_format,
    NULL,
    responses_nmea_message_format,
    NULL,
};

mip_error mip_3dm_nmea_message_format_decode(struct mip_3dm_nmea_message_format *value,
                                             const struct mip_field *field) {
    return mip_decode_field(field, read_nmea_message_format, value, sizeof(*value), NULL);
}

mip_error mip_3dm_nmea_message_format_encode(const struct mip_3dm_nmea_message_format *value,
                                             struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_NMEA_MESSAGE_FORMAT_DESCRIPTOR,
                            write_nmea_message_format, value);
}

struct mip_3dm_nmea_message_format
mip_3dm_nmea_message_format_write(uint8_t count, const struct mip_nmea_message format_entries[]) {
    struct mip_3dm_nmea_message_format v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.count = count;
    mip_copy(v.format_entries, sizeof(v.format_entries), format_entries,
             count * sizeof(format_entries[0]));
    return v;
}

struct mip_3dm_nmea_message_format mip_3dm_nmea_message_format_read(void) {
    struct mip_3dm_nmea_message_format v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_3dm_nmea_message_format mip_3dm_nmea_message_format_save(void) {
    struct mip_3dm_nmea_message_format v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_3dm_nmea_message_format mip_3dm_nmea_message_format_load(void) {
    struct mip_3dm_nmea_message_format v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_3dm_nmea_message_format mip_3dm_nmea_message_format_default(void) {
    struct mip_3dm_nmea_message_format v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_nmea_message_format_response(struct mip_reader *r, void *value) {
    struct mip_3dm_nmea_message_format_response *v =
        (struct mip_3dm_nmea_message_format_response *)value;
    mip_read_u8(r, &v->count, 1);
    for (size_t i = 0, n = mip_read_count(r, v->count, 50, 5); i < n; i++) {
        mip_nmea_message_read(r, &v->format_entries[i]);
    }
}

static void write_nmea_message_format_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_nmea_message_format_response *v =
        (const struct mip_3dm_nmea_message_format_response *)value;
    mip_write_u8(w, &v->count, 1);
    for (size_t i = 0, n = mip_write_count(w, v->count, 50); i < n; i++) {
        mip_nmea_message_write(w, &v->format_entries[i]);
    }
}

const struct mip_codec mip_3dm_nmea_message_format_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_NMEA_MESSAGE_FORMAT_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_nmea_message_format_response),
    0, /* time-out */
    read_nmea_message_format_response,
    write_nmea_message_format_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_nmea_message_format_response_decode(
    struct mip_3dm_nmea_message_format_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_nmea_message_format_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_nmea_message_format_response_encode(
    const struct mip_3dm_nmea_message_format_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_NMEA_MESSAGE_FORMAT_RESPONSE_DESCRIPTOR,
                            write_nmea_message_format_response, value);
}

static void read_poll_data(struct mip_reader *r, void *value) {
    struct mip_3dm_poll_data *v = (struct mip_3dm_poll_data *)value;
    mip_read_u8(r, &v->descriptor_set, 1);
    mip_read_bool(r, &v->suppress_ack, 1);
    mip_read_u8(r, &v->num_descriptors, 1);
    mip_read_u8(r, v->descriptors, mip_read_count(r, v->num_descriptors, 250, 1));
}

static void write_poll_data(struct mip_writer *w, const void *value) {
    const struct mip_3dm_poll_data *v = (const struct mip_3dm_poll_data *)value;
    mip_write_u8(w, &v->descriptor_set, 1);
    mip_write_bool(w, &v->suppress_ack, 1);
    mip_write_u8(w, &v->num_descriptors, 1);
    mip_write_u8(w, v->descriptors, mip_write_count(w, v->num_descriptors, 250));
}

static bool silent_poll_data(const void *value) {
    const struct mip_3dm_poll_data *v = (const struct mip_3dm_poll_data *)value;
    return v->suppress_ack == 1;
}

const struct mip_codec mip_3dm_poll_data_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_POLL_DATA_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_poll_data),
    0, /* time-out */
    read_poll_data,
    write_poll_data,
    silent_poll_data,
    NULL,
    NULL,
};

mip_error mip_3dm_poll_data_decode(struct mip_3dm_poll_data *value, const struct mip_field *field) {
    return mip_decode_field(field, read_poll_data, value, sizeof(*value), NULL);
}

mip_error mip_3dm_poll_data_encode(const struct mip_3dm_poll_data *value,
                                   struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_POLL_DATA_DESCRIPTOR, write_poll_data, value);
}

struct mip_3dm_poll_data mip_3dm_poll_data_make(uint8_t descriptor_set, mip_bool suppress_ack,
                                                uint8_t num_descriptors,
                                                const uint8_t descriptors[]) {
    struct mip_3dm_poll_data v;
    memset(&v, 0, sizeof(v));
    v.descriptor_set = descriptor_set;
    v.suppress_ack = suppress_ack;
    v.num_descriptors = num_descriptors;
    mip_copy(v.descriptors, sizeof(v.descriptors), descriptors,
             num_descriptors * sizeof(descriptors[0]));
    return v;
}

static void read_get_base_rate(struct mip_reader *r, void *value) {
    struct mip_3dm_get_base_rate *v = (struct mip_3dm_get_base_rate *)value;
    mip_read_u8(r, &v->descriptor_set, 1);
}

static void write_get_base_rate(struct mip_writer *w, const void *value) {
    const struct mip_3dm_get_base_rate *v = (const struct mip_3dm_get_base_rate *)value;
    mip_write_u8(w, &v->descriptor_set, 1);
}

static const struct mip_response responses_get_base_rate[] = {
    {&mip_3dm_get_base_rate_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_get_base_rate_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GET_BASE_RATE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_get_base_rate),
    0, /* time-out */
    read_get_base_rate,
    write_get_base_rate,
    NULL,
    responses_get_base_rate,
    NULL,
};

mip_error mip_3dm_get_base_rate_decode(struct mip_3dm_get_base_rate *value,
                                       const struct mip_field *field) {
    return mip_decode_field(field, read_get_base_rate, value, sizeof(*value), NULL);
}

mip_error mip_3dm_get_base_rate_encode(const struct mip_3dm_get_base_rate *value,
                                       struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GET_BASE_RATE_DESCRIPTOR, write_get_base_rate,
                            value);
}

struct mip_3dm_get_base_rate mip_3dm_get_base_rate_make(uint8_t descriptor_set) {
    struct mip_3dm_get_base_rate v;
    memset(&v, 0, sizeof(v));
    v.descriptor_set = descriptor_set;
    return v;
}

static void read_get_base_rate_response(struct mip_reader *r, void *value) {
    struct mip_3dm_get_base_rate_response *v = (struct mip_3dm_get_base_rate_response *)value;
    mip_read_u8(r, &v->descriptor_set, 1);
    mip_read_u16(r, &v->rate, 1);
}

static void write_get_base_rate_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_get_base_rate_response *v =
        (const struct mip_3dm_get_base_rate_response *)value;
    mip_write_u8(w, &v->descriptor_set, 1);
    mip_write_u16(w, &v->rate, 1);
}

const struct mip_codec mip_3dm_get_base_rate_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GET_BASE_RATE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_get_base_rate_response),
    0, /* time-out */
    read_get_base_rate_response,
    write_get_base_rate_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_get_base_rate_response_decode(struct mip_3dm_get_base_rate_response *value,
                                                const struct mip_field *field) {
    return mip_decode_field(field, read_get_base_rate_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_get_base_rate_response_encode(const struct mip_3dm_get_base_rate_response *value,
                                                struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GET_BASE_RATE_RESPONSE_DESCRIPTOR,
                            write_get_base_rate_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_message_format[] = {0, 3, 1, 1, 1, 1};

static void read_message_format(struct mip_reader *r, void *value) {
    struct mip_3dm_message_format *v = (struct mip_3dm_message_format *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_message_format, sizeof(required_message_format));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->descriptor_set, 1);
    mip_read_group(r, 2, 3);
    mip_read_u8(r, &v->num_descriptors, 1);
    for (size_t i = 0, n = mip_read_count(r, v->num_descriptors, 83, 3); i < n; i++) {
        mip_descriptor_rate_read(r, &v->descriptors[i]);
    }
    v->present = mip_read_present(r);
}

static void write_message_format(struct mip_writer *w, const void *value) {
    const struct mip_3dm_message_format *v = (const struct mip_3dm_message_format *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_message_format, sizeof(required_message_format),
                       v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->descriptor_set, 1);
    mip_write_group(w, 2, 3);
    mip_write_u8(w, &v->num_descriptors, 1);
    for (size_t i = 0, n = mip_write_count(w, v->num_descriptors, 83); i < n; i++) {
        mip_descriptor_rate_write(w, &v->descriptors[i]);
    }
}

static bool asked_message_format_1(const void *value) {
    const struct mip_3dm_message_format *v = (const struct mip_3dm_message_format *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_message_format[] = {
    {&mip_3dm_message_format_response_codec, asked_message_format_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_message_format_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_MESSAGE_FORMAT_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_message_format),
    0, /* time-out */
    read_message_format,
    write_message_format,
    NULL,
    responses_message_format,
    NULL,
};

mip_error mip_3dm_message_format_decode(struct mip_3dm_message_format *value,
                                        const struct mip_field *field) {
    return mip_decode_field(field, read_message_format, value, sizeof(*value), NULL);
}

mip_error mip_3dm_message_format_encode(const struct mip_3dm_message_format *value,
                                        struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_MESSAGE_FORMAT_DESCRIPTOR, write_message_format,
                            value);
}

struct mip_3dm_message_format
mip_3dm_message_format_write(uint8_t descriptor_set, uint8_t num_descriptors,
                             const struct mip_descriptor_rate descriptors[]) {
    struct mip_3dm_message_format v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.descriptor_set = descriptor_set;
    v.num_descriptors = num_descriptors;
    mip_copy(v.descriptors, sizeof(v.descriptors), descriptors,
             num_descriptors * sizeof(descriptors[0]));
    return v;
}

struct mip_3dm_message_format mip_3dm_message_format_read(uint8_t descriptor_set) {
    struct mip_3dm_message_format v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    v.descriptor_set = descriptor_set;
    return v;
}

struct mip_3dm_message_format mip_3dm_message_format_save(uint8_t descriptor_set) {
    struct mip_3dm_message_format v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    v.descriptor_set = descriptor_set;
    return v;
}

struct mip_3dm_message_format mip_3dm_message_format_load(uint8_t descriptor_set) {
    struct mip_3dm_message_format v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    v.descriptor_set = descriptor_set;
    return v;
}

struct mip_3dm_message_format mip_3dm_message_format_default(uint8_t descriptor_set) {
    struct mip_3dm_message_format v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    v.descriptor_set = descriptor_set;
    return v;
}

static void read_message_format_response(struct mip_reader *r, void *value) {
    struct mip_3dm_message_format_response *v = (struct mip_3dm_message_format_response *)value;
    mip_read_u8(r, &v->descriptor_set, 1);
    mip_read_u8(r, &v->num_descriptors, 1);
    for (size_t i = 0, n = mip_read_count(r, v->num_descriptors, 83, 3); i < n; i++) {
        mip_descriptor_rate_read(r, &v->descriptors[i]);
    }
}

static void write_message_format_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_message_format_response *v =
        (const struct mip_3dm_message_format_response *)value;
    mip_write_u8(w, &v->descriptor_set, 1);
    mip_write_u8(w, &v->num_descriptors, 1);
    for (size_t i = 0, n = mip_write_count(w, v->num_descriptors, 83); i < n; i++) {
        mip_descriptor_rate_write(w, &v->descriptors[i]);
    }
}

const struct mip_codec mip_3dm_message_format_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_MESSAGE_FORMAT_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_message_format_response),
    0, /* time-out */
    read_message_format_response,
    write_message_format_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_message_format_response_decode(struct mip_3dm_message_format_response *value,
                                                 const struct mip_field *field) {
    return mip_decode_field(field, read_message_format_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_message_format_response_encode(
    const struct mip_3dm_message_format_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_MESSAGE_FORMAT_RESPONSE_DESCRIPTOR,
                            write_message_format_response, value);
}

static void read_factory_streaming(struct mip_reader *r, void *value) {
    struct mip_3dm_factory_streaming *v = (struct mip_3dm_factory_streaming *)value;
    mip_read_u8(r, &v->action, 1);
    mip_read_u8(r, &v->reserved, 1);
}

static void write_factory_streaming(struct mip_writer *w, const void *value) {
    const struct mip_3dm_factory_streaming *v = (const struct mip_3dm_factory_streaming *)value;
    mip_write_u8(w, &v->action, 1);
    mip_write_u8(w, &v->reserved, 1);
}

const struct mip_codec mip_3dm_factory_streaming_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_FACTORY_STREAMING_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_factory_streaming),
    0, /* time-out */
    read_factory_streaming,
    write_factory_streaming,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_factory_streaming_decode(struct mip_3dm_factory_streaming *value,
                                           const struct mip_field *field) {
    return mip_decode_field(field, read_factory_streaming, value, sizeof(*value), NULL);
}

mip_error mip_3dm_factory_streaming_encode(const struct mip_3dm_factory_streaming *value,
                                           struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_FACTORY_STREAMING_DESCRIPTOR,
                            write_factory_streaming, value);
}

struct mip_3dm_factory_streaming
mip_3dm_factory_streaming_make(mip_3dm_factory_streaming_action action) {
    struct mip_3dm_factory_streaming v;
    memset(&v, 0, sizeof(v));
    v.action = action;
    return v;
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_data_stream_control[] = {0, 2, 1, 1, 1, 1};

static void read_data_stream_control(struct mip_reader *r, void *value) {
    struct mip_3dm_data_stream_control *v = (struct mip_3dm_data_stream_control *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_data_stream_control,
                      sizeof(required_data_stream_control));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->descriptor_set, 1);
    mip_read_group(r, 2, 2);
    mip_read_bool(r, &v->enable, 1);
    v->present = mip_read_present(r);
}

static void write_data_stream_control(struct mip_writer *w, const void *value) {
    const struct mip_3dm_data_stream_control *v = (const struct mip_3dm_data_stream_control *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_data_stream_control,
                       sizeof(required_data_stream_control), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->descriptor_set, 1);
    mip_write_group(w, 2, 2);
    mip_write_bool(w, &v->enable, 1);
}

static bool asked_data_stream_control_1(const void *value) {
    const struct mip_3dm_data_stream_control *v = (const struct mip_3dm_data_stream_control *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_data_stream_control[] = {
    {&mip_3dm_data_stream_control_response_codec, asked_data_stream_control_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_data_stream_control_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_DATA_STREAM_CONTROL_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_data_stream_control),
    0, /* time-out */
    read_data_stream_control,
    write_data_stream_control,
    NULL,
    responses_data_stream_control,
    NULL,
};

mip_error mip_3dm_data_stream_control_decode(struct mip_3dm_data_stream_control *value,
                                             const struct mip_field *field) {
    return mip_decode_field(field, read_data_stream_control, value, sizeof(*value), NULL);
}

mip_error mip_3dm_data_stream_control_encode(const struct mip_3dm_data_stream_control *value,
                                             struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_DATA_STREAM_CONTROL_DESCRIPTOR,
                            write_data_stream_control, value);
}

struct mip_3dm_data_stream_control mip_3dm_data_stream_control_write(uint8_t descriptor_set,
                                                                     mip_bool enable) {
    struct mip_3dm_data_stream_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.descriptor_set = descriptor_set;
    v.enable = enable;
    return v;
}

struct mip_3dm_data_stream_control mip_3dm_data_stream_control_read(uint8_t descriptor_set) {
    struct mip_3dm_data_stream_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    v.descriptor_set = descriptor_set;
    return v;
}

struct mip_3dm_data_stream_control mip_3dm_data_stream_control_save(uint8_t descriptor_set) {
    struct mip_3dm_data_stream_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    v.descriptor_set = descriptor_set;
    return v;
}

struct mip_3dm_data_stream_control mip_3dm_data_stream_control_load(uint8_t descriptor_set) {
    struct mip_3dm_data_stream_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    v.descriptor_set = descriptor_set;
    return v;
}

struct mip_3dm_data_stream_control mip_3dm_data_stream_control_default(uint8_t descriptor_set) {
    struct mip_3dm_data_stream_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    v.descriptor_set = descriptor_set;
    return v;
}

static void read_data_stream_control_response(struct mip_reader *r, void *value) {
    struct mip_3dm_data_stream_control_response *v =
        (struct mip_3dm_data_stream_control_response *)value;
    mip_read_u8(r, &v->descriptor_set, 1);
    mip_read_bool(r, &v->enabled, 1);
}

static void write_data_stream_control_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_data_stream_control_response *v =
        (const struct mip_3dm_data_stream_control_response *)value;
    mip_write_u8(w, &v->descriptor_set, 1);
    mip_write_bool(w, &v->enabled, 1);
}

const struct mip_codec mip_3dm_data_stream_control_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_DATA_STREAM_CONTROL_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_data_stream_control_response),
    0, /* time-out */
    read_data_stream_control_response,
    write_data_stream_control_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_data_stream_control_response_decode(
    struct mip_3dm_data_stream_control_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_data_stream_control_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_data_stream_control_response_encode(
    const struct mip_3dm_data_stream_control_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_DATA_STREAM_CONTROL_RESPONSE_DESCRIPTOR,
                            write_data_stream_control_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_constellation_settings[] = {0, 3, 0, 0, 0, 0};

static void read_constellation_settings(struct mip_reader *r, void *value) {
    struct mip_3dm_constellation_settings *v = (struct mip_3dm_constellation_settings *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_constellation_settings,
                      sizeof(required_constellation_settings));
    mip_read_group(r, 1, 1);
    mip_read_u16(r, &v->max_channels, 1);
    mip_read_group(r, 2, 3);
    mip_read_u8(r, &v->config_count, 1);
    for (size_t i = 0, n = mip_read_count(r, v->config_count, 41, 6); i < n; i++) {
        mip_3dm_constellation_settings_entry_read(r, &v->settings[i]);
    }
    v->present = mip_read_present(r);
}

static void write_constellation_settings(struct mip_writer *w, const void *value) {
    const struct mip_3dm_constellation_settings *v =
        (const struct mip_3dm_constellation_settings *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_constellation_settings,
                       sizeof(required_constellation_settings), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u16(w, &v->max_channels, 1);
    mip_write_group(w, 2, 3);
    mip_write_u8(w, &v->config_count, 1);
    for (size_t i = 0, n = mip_write_count(w, v->config_count, 41); i < n; i++) {
        mip_3dm_constellation_settings_entry_write(w, &v->settings[i]);
    }
}

static bool asked_constellation_settings_1(const void *value) {
    const struct mip_3dm_constellation_settings *v =
        (const struct mip_3dm_constellation_settings *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_constellation_settings[] = {
    {&mip_3dm_constellation_settings_response_codec, asked_constellation_settings_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_constellation_settings_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_CONSTELLATION_SETTINGS_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_constellation_settings),
    0, /* time-out */
    read_constellation_settings,
    write_constellation_settings,
    NULL,
    responses_constellation_settings,
    NULL,
};

mip_error mip_3dm_constellation_settings_decode(struct mip_3dm_constellation_settings *value,
                                                const struct mip_field *field) {
    return mip_decode_field(field, read_constellation_settings, value, sizeof(*value), NULL);
}

mip_error mip_3dm_constellation_settings_encode(const struct mip_3dm_constellation_settings *value,
                                                struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_CONSTELLATION_SETTINGS_DESCRIPTOR,
                            write_constellation_settings, value);
}

struct mip_3dm_constellation_settings
mip_3dm_constellation_settings_write(uint16_t max_channels, uint8_t config_count,
                                     const struct mip_3dm_constellation_settings_entry settings[]) {
    struct mip_3dm_constellation_settings v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.max_channels = max_channels;
    v.config_count = config_count;
    mip_copy(v.settings, sizeof(v.settings), settings, config_count * sizeof(settings[0]));
    return v;
}

struct mip_3dm_constellation_settings mip_3dm_constellation_settings_read(void) {
    struct mip_3dm_constellation_settings v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_3dm_constellation_settings mip_3dm_constellation_settings_save(void) {
    struct mip_3dm_constellation_settings v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_3dm_constellation_settings mip_3dm_constellation_settings_load(void) {
    struct mip_3dm_constellation_settings v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_3dm_constellation_settings mip_3dm_constellation_settings_default(void) {
    struct mip_3dm_constellation_settings v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_constellation_settings_response(struct mip_reader *r, void *value) {
    struct mip_3dm_constellation_settings_response *v =
        (struct mip_3dm_constellation_settings_response *)value;
    mip_read_u16(r, &v->max_channels_available, 1);
    mip_read_u16(r, &v->max_channels_use, 1);
    mip_read_u8(r, &v->config_count, 1);
    for (size_t i = 0, n = mip_read_count(r, v->config_count, 41, 6); i < n; i++) {
        mip_3dm_constellation_settings_entry_read(r, &v->settings[i]);
    }
}

static void write_constellation_settings_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_constellation_settings_response *v =
        (const struct mip_3dm_constellation_settings_response *)value;
    mip_write_u16(w, &v->max_channels_available, 1);
    mip_write_u16(w, &v->max_channels_use, 1);
    mip_write_u8(w, &v->config_count, 1);
    for (size_t i = 0, n = mip_write_count(w, v->config_count, 41); i < n; i++) {
        mip_3dm_constellation_settings_entry_write(w, &v->settings[i]);
    }
}

const struct mip_codec mip_3dm_constellation_settings_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_CONSTELLATION_SETTINGS_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_constellation_settings_response),
    0, /* time-out */
    read_constellation_settings_response,
    write_constellation_settings_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_constellation_settings_response_decode(
    struct mip_3dm_constellation_settings_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_constellation_settings_response, value, sizeof(*value),
                            NULL);
}

mip_error mip_3dm_constellation_settings_response_encode(
    const struct mip_3dm_constellation_settings_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_CONSTELLATION_SETTINGS_RESPONSE_DESCRIPTOR,
                            write_constellation_settings_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_gnss_sbas_settings[] = {0, 4, 0, 0, 0, 0};

static void read_gnss_sbas_settings(struct mip_reader *r, void *value) {
    struct mip_3dm_gnss_sbas_settings *v = (struct mip_3dm_gnss_sbas_settings *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_gnss_sbas_settings,
                      sizeof(required_gnss_sbas_settings));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->enable_sbas, 1);
    mip_read_group(r, 2, 2);
    mip_read_u16(r, &v->sbas_options, 1);
    mip_read_group(r, 3, 4);
    mip_read_u8(r, &v->num_included_prns, 1);
    mip_read_u16(r, v->included_prns, mip_read_count(r, v->num_included_prns, 124, 2));
    v->present = mip_read_present(r);
}

static void write_gnss_sbas_settings(struct mip_writer *w, const void *value) {
    const struct mip_3dm_gnss_sbas_settings *v = (const struct mip_3dm_gnss_sbas_settings *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_gnss_sbas_settings,
                       sizeof(required_gnss_sbas_settings), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->enable_sbas, 1);
    mip_write_group(w, 2, 2);
    mip_write_u16(w, &v->sbas_options, 1);
    mip_write_group(w, 3, 4);
    mip_write_u8(w, &v->num_included_prns, 1);
    mip_write_u16(w, v->included_prns, mip_write_count(w, v->num_included_prns, 124));
}

static bool asked_gnss_sbas_settings_1(const void *value) {
    const struct mip_3dm_gnss_sbas_settings *v = (const struct mip_3dm_gnss_sbas_settings *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_gnss_sbas_settings[] = {
    {&mip_3dm_gnss_sbas_settings_response_codec, asked_gnss_sbas_settings_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_gnss_sbas_settings_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GNSS_SBAS_SETTINGS_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_gnss_sbas_settings),
    0, /* time-out */
    read_gnss_sbas_settings,
    write_gnss_sbas_settings,
    NULL,
    responses_gnss_sbas_settings,
    NULL,
};

mip_error mip_3dm_gnss_sbas_settings_decode(struct mip_3dm_gnss_sbas_settings *value,
                                            const struct mip_field *field) {
    return mip_decode_field(field, read_gnss_sbas_settings, value, sizeof(*value), NULL);
}

mip_error mip_3dm_gnss_sbas_settings_encode(const struct mip_3dm_gnss_sbas_settings *value,
                                            struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GNSS_SBAS_SETTINGS_DESCRIPTOR,
                            write_gnss_sbas_settings, value);
}

struct mip_3dm_gnss_sbas_settings
mip_3dm_gnss_sbas_settings_write(uint8_t enable_sbas, mip_3dm_sbas_options sbas_options,
                                 uint8_t num_included_prns, const uint16_t included_prns[]) {
    struct mip_3dm_gnss_sbas_settings v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.enable_sbas = enable_sbas;
    v.sbas_options = sbas_options;
    v.num_included_prns = num_included_prns;
    mip_copy(v.included_prns, sizeof(v.included_prns), included_prns,
             num_included_prns * sizeof(included_prns[0]));
    return v;
}

struct mip_3dm_gnss_sbas_settings mip_3dm_gnss_sbas_settings_read(void) {
    struct mip_3dm_gnss_sbas_settings v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_3dm_gnss_sbas_settings mip_3dm_gnss_sbas_settings_save(void) {
    struct mip_3dm_gnss_sbas_settings v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_3dm_gnss_sbas_settings mip_3dm_gnss_sbas_settings_load(void) {
    struct mip_3dm_gnss_sbas_settings v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_3dm_gnss_sbas_settings mip_3dm_gnss_sbas_settings_default(void) {
    struct mip_3dm_gnss_sbas_settings v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_gnss_sbas_settings_response(struct mip_reader *r, void *value) {
    struct mip_3dm_gnss_sbas_settings_response *v =
        (struct mip_3dm_gnss_sbas_settings_response *)value;
    mip_read_u8(r, &v->enable_sbas, 1);
    mip_read_u16(r, &v->sbas_options, 1);
    mip_read_u8(r, &v->num_included_prns, 1);
    mip_read_u16(r, v->included_prns, mip_read_count(r, v->num_included_prns, 124, 2));
}

static void write_gnss_sbas_settings_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_gnss_sbas_settings_response *v =
        (const struct mip_3dm_gnss_sbas_settings_response *)value;
    mip_write_u8(w, &v->enable_sbas, 1);
    mip_write_u16(w, &v->sbas_options, 1);
    mip_write_u8(w, &v->num_included_prns, 1);
    mip_write_u16(w, v->included_prns, mip_write_count(w, v->num_included_prns, 124));
}

const struct mip_codec mip_3dm_gnss_sbas_settings_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GNSS_SBAS_SETTINGS_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_gnss_sbas_settings_response),
    0, /* time-out */
    read_gnss_sbas_settings_response,
    write_gnss_sbas_settings_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_gnss_sbas_settings_response_decode(
    struct mip_3dm_gnss_sbas_settings_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_gnss_sbas_settings_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_gnss_sbas_settings_response_encode(
    const struct mip_3dm_gnss_sbas_settings_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GNSS_SBAS_SETTINGS_RESPONSE_DESCRIPTOR,
                            write_gnss_sbas_settings_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_gnss_assisted_fix[] = {0, 2, 0, 0, 0, 0};

static void read_gnss_assisted_fix(struct mip_reader *r, void *value) {
    struct mip_3dm_gnss_assisted_fix *v = (struct mip_3dm_gnss_assisted_fix *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_gnss_assisted_fix,
                      sizeof(required_gnss_assisted_fix));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->option, 1);
    mip_read_group(r, 2, 2);
    mip_read_u8(r, &v->flags, 1);
    v->present = mip_read_present(r);
}

static void write_gnss_assisted_fix(struct mip_writer *w, const void *value) {
    const struct mip_3dm_gnss_assisted_fix *v = (const struct mip_3dm_gnss_assisted_fix *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_gnss_assisted_fix,
                       sizeof(required_gnss_assisted_fix), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->option, 1);
    mip_write_group(w, 2, 2);
    mip_write_u8(w, &v->flags, 1);
}

static bool asked_gnss_assisted_fix_1(const void *value) {
    const struct mip_3dm_gnss_assisted_fix *v = (const struct mip_3dm_gnss_assisted_fix *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_gnss_assisted_fix[] = {
    {&mip_3dm_gnss_assisted_fix_response_codec, asked_gnss_assisted_fix_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_gnss_assisted_fix_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GNSS_ASSISTED_FIX_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_gnss_assisted_fix),
    0, /* time-out */
    read_gnss_assisted_fix,
    write_gnss_assisted_fix,
    NULL,
    responses_gnss_assisted_fix,
    NULL,
};

mip_error mip_3dm_gnss_assisted_fix_decode(struct mip_3dm_gnss_assisted_fix *value,
                                           const struct mip_field *field) {
    return mip_decode_field(field, read_gnss_assisted_fix, value, sizeof(*value), NULL);
}

mip_error mip_3dm_gnss_assisted_fix_encode(const struct mip_3dm_gnss_assisted_fix *value,
                                           struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GNSS_ASSISTED_FIX_DESCRIPTOR,
                            write_gnss_assisted_fix, value);
}

struct mip_3dm_gnss_assisted_fix
mip_3dm_gnss_assisted_fix_write(mip_3dm_assisted_fix_option option) {
    struct mip_3dm_gnss_assisted_fix v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.option = option;
    v.flags = 255;
    return v;
}

struct mip_3dm_gnss_assisted_fix mip_3dm_gnss_assisted_fix_read(void) {
    struct mip_3dm_gnss_assisted_fix v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    v.flags = 255;
    return v;
}

struct mip_3dm_gnss_assisted_fix mip_3dm_gnss_assisted_fix_save(void) {
    struct mip_3dm_gnss_assisted_fix v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    v.flags = 255;
    return v;
}

struct mip_3dm_gnss_assisted_fix mip_3dm_gnss_assisted_fix_load(void) {
    struct mip_3dm_gnss_assisted_fix v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    v.flags = 255;
    return v;
}

struct mip_3dm_gnss_assisted_fix mip_3dm_gnss_assisted_fix_default(void) {
    struct mip_3dm_gnss_assisted_fix v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    v.flags = 255;
    return v;
}

static void read_gnss_assisted_fix_response(struct mip_reader *r, void *value) {
    struct mip_3dm_gnss_assisted_fix_response *v =
        (struct mip_3dm_gnss_assisted_fix_response *)value;
    mip_read_u8(r, &v->option, 1);
    mip_read_u8(r, &v->flags, 1);
}

static void write_gnss_assisted_fix_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_gnss_assisted_fix_response *v =
        (const struct mip_3dm_gnss_assisted_fix_response *)value;
    mip_write_u8(w, &v->option, 1);
    mip_write_u8(w, &v->flags, 1);
}

const struct mip_codec mip_3dm_gnss_assisted_fix_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GNSS_ASSISTED_FIX_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_gnss_assisted_fix_response),
    0, /* time-out */
    read_gnss_assisted_fix_response,
    write_gnss_assisted_fix_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_gnss_assisted_fix_response_decode(
    struct mip_3dm_gnss_assisted_fix_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_gnss_assisted_fix_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_gnss_assisted_fix_response_encode(
    const struct mip_3dm_gnss_assisted_fix_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GNSS_ASSISTED_FIX_RESPONSE_DESCRIPTOR,
                            write_gnss_assisted_fix_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_gnss_time_assistance[] = {0, 3, 0};

static void read_gnss_time_assistance(struct mip_reader *r, void *value) {
    struct mip_3dm_gnss_time_assistance *v = (struct mip_3dm_gnss_time_assistance *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_gnss_time_assistance,
                      sizeof(required_gnss_time_assistance));
    mip_read_group(r, 1, 1);
    mip_read_double(r, &v->tow, 1);
    mip_read_group(r, 2, 2);
    mip_read_u16(r, &v->week_number, 1);
    mip_read_group(r, 3, 3);
    mip_read_float(r, &v->accuracy, 1);
    v->present = mip_read_present(r);
}

static void write_gnss_time_assistance(struct mip_writer *w, const void *value) {
    const struct mip_3dm_gnss_time_assistance *v =
        (const struct mip_3dm_gnss_time_assistance *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_gnss_time_assistance,
                       sizeof(required_gnss_time_assistance), v->present);
    mip_write_group(w, 1, 1);
    mip_write_double(w, &v->tow, 1);
    mip_write_group(w, 2, 2);
    mip_write_u16(w, &v->week_number, 1);
    mip_write_group(w, 3, 3);
    mip_write_float(w, &v->accuracy, 1);
}

static bool asked_gnss_time_assistance_1(const void *value) {
    const struct mip_3dm_gnss_time_assistance *v =
        (const struct mip_3dm_gnss_time_assistance *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_gnss_time_assistance[] = {
    {&mip_3dm_gnss_time_assistance_response_codec, asked_gnss_time_assistance_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_gnss_time_assistance_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GNSS_TIME_ASSISTANCE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_gnss_time_assistance),
    0, /* time-out */
    read_gnss_time_assistance,
    write_gnss_time_assistance,
    NULL,
    responses_gnss_time_assistance,
    NULL,
};

mip_error mip_3dm_gnss_time_assistance_decode(struct mip_3dm_gnss_time_assistance *value,
                                              const struct mip_field *field) {
    return mip_decode_field(field, read_gnss_time_assistance, value, sizeof(*value), NULL);
}

mip_error mip_3dm_gnss_time_assistance_encode(const struct mip_3dm_gnss_time_assistance *value,
                                              struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GNSS_TIME_ASSISTANCE_DESCRIPTOR,
                            write_gnss_time_assistance, value);
}

struct mip_3dm_gnss_time_assistance mip_3dm_gnss_time_assistance_write(double tow,
                                                                       uint16_t week_number,
                                                                       float accuracy) {
    struct mip_3dm_gnss_time_assistance v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.tow = tow;
    v.week_number = week_number;
    v.accuracy = accuracy;
    return v;
}

struct mip_3dm_gnss_time_assistance mip_3dm_gnss_time_assistance_read(void) {
    struct mip_3dm_gnss_time_assistance v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

static void read_gnss_time_assistance_response(struct mip_reader *r, void *value) {
    struct mip_3dm_gnss_time_assistance_response *v =
        (struct mip_3dm_gnss_time_assistance_response *)value;
    mip_read_double(r, &v->tow, 1);
    mip_read_u16(r, &v->week_number, 1);
    mip_read_float(r, &v->accuracy, 1);
}

static void write_gnss_time_assistance_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_gnss_time_assistance_response *v =
        (const struct mip_3dm_gnss_time_assistance_response *)value;
    mip_write_double(w, &v->tow, 1);
    mip_write_u16(w, &v->week_number, 1);
    mip_write_float(w, &v->accuracy, 1);
}

const struct mip_codec mip_3dm_gnss_time_assistance_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GNSS_TIME_ASSISTANCE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_gnss_time_assistance_response),
    0, /* time-out */
    read_gnss_time_assistance_response,
    write_gnss_time_assistance_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_gnss_time_assistance_response_decode(
    struct mip_3dm_gnss_time_assistance_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_gnss_time_assistance_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_gnss_time_assistance_response_encode(
    const struct mip_3dm_gnss_time_assistance_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GNSS_TIME_ASSISTANCE_RESPONSE_DESCRIPTOR,
                            write_gnss_time_assistance_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_pps_source_control[] = {0, 1, 0, 0, 0, 0};

static void read_pps_source_control(struct mip_reader *r, void *value) {
    struct mip_3dm_pps_source_control *v = (struct mip_3dm_pps_source_control *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_pps_source_control,
                      sizeof(required_pps_source_control));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->source, 1);
    v->present = mip_read_present(r);
}

static void write_pps_source_control(struct mip_writer *w, const void *value) {
    const struct mip_3dm_pps_source_control *v = (const struct mip_3dm_pps_source_control *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_pps_source_control,
                       sizeof(required_pps_source_control), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->source, 1);
}

static bool asked_pps_source_control_1(const void *value) {
    const struct mip_3dm_pps_source_control *v = (const struct mip_3dm_pps_source_control *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_pps_source_control[] = {
    {&mip_3dm_pps_source_control_response_codec, asked_pps_source_control_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_pps_source_control_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_PPS_SOURCE_CONTROL_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_pps_source_control),
    0, /* time-out */
    read_pps_source_control,
    write_pps_source_control,
    NULL,
    responses_pps_source_control,
    NULL,
};

mip_error mip_3dm_pps_source_control_decode(struct mip_3dm_pps_source_control *value,
                                            const struct mip_field *field) {
    return mip_decode_field(field, read_pps_source_control, value, sizeof(*value), NULL);
}

mip_error mip_3dm_pps_source_control_encode(const struct mip_3dm_pps_source_control *value,
                                            struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_PPS_SOURCE_CONTROL_DESCRIPTOR,
                            write_pps_source_control, value);
}

struct mip_3dm_pps_source_control mip_3dm_pps_source_control_write(mip_3dm_pps_source source) {
    struct mip_3dm_pps_source_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.source = source;
    return v;
}

struct mip_3dm_pps_source_control mip_3dm_pps_source_control_read(void) {
    struct mip_3dm_pps_source_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_3dm_pps_source_control mip_3dm_pps_source_control_save(void) {
    struct mip_3dm_pps_source_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_3dm_pps_source_control mip_3dm_pps_source_control_load(void) {
    struct mip_3dm_pps_source_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_3dm_pps_source_control mip_3dm_pps_source_control_default(void) {
    struct mip_3dm_pps_source_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_pps_source_control_response(struct mip_reader *r, void *value) {
    struct mip_3dm_pps_source_control_response *v =
        (struct mip_3dm_pps_source_control_response *)value;
    mip_read_u8(r, &v->source, 1);
}

static void write_pps_source_control_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_pps_source_control_response *v =
        (const struct mip_3dm_pps_source_control_response *)value;
    mip_write_u8(w, &v->source, 1);
}

const struct mip_codec mip_3dm_pps_source_control_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_PPS_SOURCE_CONTROL_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_pps_source_control_response),
    0, /* time-out */
    read_pps_source_control_response,
    write_pps_source_control_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_pps_source_control_response_decode(
    struct mip_3dm_pps_source_control_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_pps_source_control_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_pps_source_control_response_encode(
    const struct mip_3dm_pps_source_control_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_PPS_SOURCE_CONTROL_RESPONSE_DESCRIPTOR,
                            write_pps_source_control_response, value);
}

static void read_get_event_support(struct mip_reader *r, void *value) {
    struct mip_3dm_get_event_support *v = (struct mip_3dm_get_event_support *)value;
    mip_read_u8(r, &v->query, 1);
}

static void write_get_event_support(struct mip_writer *w, const void *value) {
    const struct mip_3dm_get_event_support *v = (const struct mip_3dm_get_event_support *)value;
    mip_write_u8(w, &v->query, 1);
}

static const struct mip_response responses_get_event_support[] = {
    {&mip_3dm_get_event_support_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_get_event_support_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GET_EVENT_SUPPORT_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_get_event_support),
    0, /* time-out */
    read_get_event_support,
    write_get_event_support,
    NULL,
    responses_get_event_support,
    NULL,
};

mip_error mip_3dm_get_event_support_decode(struct mip_3dm_get_event_support *value,
                                           const struct mip_field *field) {
    return mip_decode_field(field, read_get_event_support, value, sizeof(*value), NULL);
}

mip_error mip_3dm_get_event_support_encode(const struct mip_3dm_get_event_support *value,
                                           struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GET_EVENT_SUPPORT_DESCRIPTOR,
                            write_get_event_support, value);
}

struct mip_3dm_get_event_support mip_3dm_get_event_support_make(mip_3dm_event_support_query query) {
    struct mip_3dm_get_event_support v;
    memset(&v, 0, sizeof(v));
    v.query = query;
    return v;
}

static void read_get_event_support_response(struct mip_reader *r, void *value) {
    struct mip_3dm_get_event_support_response *v =
        (struct mip_3dm_get_event_support_response *)value;
    mip_read_u8(r, &v->query, 1);
    mip_read_u8(r, &v->max_instances, 1);
    mip_read_u8(r, &v->num_entries, 1);
    for (size_t i = 0, n = mip_read_count(r, v->num_entries, 125, 2); i < n; i++) {
        mip_3dm_event_support_info_read(r, &v->entries[i]);
    }
}

static void write_get_event_support_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_get_event_support_response *v =
        (const struct mip_3dm_get_event_support_response *)value;
    mip_write_u8(w, &v->query, 1);
    mip_write_u8(w, &v->max_instances, 1);
    mip_write_u8(w, &v->num_entries, 1);
    for (size_t i = 0, n = mip_write_count(w, v->num_entries, 125); i < n; i++) {
        mip_3dm_event_support_info_write(w, &v->entries[i]);
    }
}

const struct mip_codec mip_3dm_get_event_support_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GET_EVENT_SUPPORT_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_get_event_support_response),
    0, /* time-out */
    read_get_event_support_response,
    write_get_event_support_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_get_event_support_response_decode(
    struct mip_3dm_get_event_support_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_get_event_support_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_get_event_support_response_encode(
    const struct mip_3dm_get_event_support_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GET_EVENT_SUPPORT_RESPONSE_DESCRIPTOR,
                            write_get_event_support_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_event_control[] = {0, 2, 1, 1, 1, 1};

static void read_event_control(struct mip_reader *r, void *value) {
    struct mip_3dm_event_control *v = (struct mip_3dm_event_control *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_event_control, sizeof(required_event_control));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->instance, 1);
    mip_read_group(r, 2, 2);
    mip_read_u8(r, &v->mode, 1);
    v->present = mip_read_present(r);
}

static void write_event_control(struct mip_writer *w, const void *value) {
    const struct mip_3dm_event_control *v = (const struct mip_3dm_event_control *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_event_control, sizeof(required_event_control),
                       v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->instance, 1);
    mip_write_group(w, 2, 2);
    mip_write_u8(w, &v->mode, 1);
}

static bool asked_event_control_1(const void *value) {
    const struct mip_3dm_event_control *v = (const struct mip_3dm_event_control *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_event_control[] = {
    {&mip_3dm_event_control_response_codec, asked_event_control_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_event_control_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_EVENT_CONTROL_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_event_control),
    0, /* time-out */
    read_event_control,
    write_event_control,
    NULL,
    responses_event_control,
    NULL,
};

mip_error mip_3dm_event_control_decode(struct mip_3dm_event_control *value,
                                       const struct mip_field *field) {
    return mip_decode_field(field, read_event_control, value, sizeof(*value), NULL);
}

mip_error mip_3dm_event_control_encode(const struct mip_3dm_event_control *value,
                                       struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_EVENT_CONTROL_DESCRIPTOR, write_event_control,
                            value);
}

struct mip_3dm_event_control mip_3dm_event_control_write(uint8_t instance,
                                                         mip_event_trigger_mode mode) {
    struct mip_3dm_event_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.instance = instance;
    v.mode = mode;
    return v;
}

struct mip_3dm_event_control mip_3dm_event_control_read(uint8_t instance) {
    struct mip_3dm_event_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    v.instance = instance;
    return v;
}

struct mip_3dm_event_control mip_3dm_event_control_save(uint8_t instance) {
    struct mip_3dm_event_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    v.instance = instance;
    return v;
}

struct mip_3dm_event_control mip_3dm_event_control_load(uint8_t instance) {
    struct mip_3dm_event_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    v.instance = instance;
    return v;
}

struct mip_3dm_event_control mip_3dm_event_control_default(uint8_t instance) {
    struct mip_3dm_event_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    v.instance = instance;
    return v;
}

static void read_event_control_response(struct mip_reader *r, void *value) {
    struct mip_3dm_event_control_response *v = (struct mip_3dm_event_control_response *)value;
    mip_read_u8(r, &v->instance, 1);
    mip_read_u8(r, &v->mode, 1);
}

static void write_event_control_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_event_control_response *v =
        (const struct mip_3dm_event_control_response *)value;
    mip_write_u8(w, &v->instance, 1);
    mip_write_u8(w, &v->mode, 1);
}

const struct mip_codec mip_3dm_event_control_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_EVENT_CONTROL_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_event_control_response),
    0, /* time-out */
    read_event_control_response,
    write_event_control_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_event_control_response_decode(struct mip_3dm_event_control_response *value,
                                                const struct mip_field *field) {
    return mip_decode_field(field, read_event_control_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_event_control_response_encode(const struct mip_3dm_event_control_response *value,
                                                struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_EVENT_CONTROL_RESPONSE_DESCRIPTOR,
                            write_event_control_response, value);
}

static void read_get_event_trigger_status(struct mip_reader *r, void *value) {
    struct mip_3dm_get_event_trigger_status *v = (struct mip_3dm_get_event_trigger_status *)value;
    mip_read_u8(r, &v->requested_count, 1);
    mip_read_u8(r, v->requested_instances, mip_read_count(r, v->requested_count, 252, 1));
}

static void write_get_event_trigger_status(struct mip_writer *w, const void *value) {
    const struct mip_3dm_get_event_trigger_status *v =
        (const struct mip_3dm_get_event_trigger_status *)value;
    mip_write_u8(w, &v->requested_count, 1);
    mip_write_u8(w, v->requested_instances, mip_write_count(w, v->requested_count, 252));
}

static const struct mip_response responses_get_event_trigger_status[] = {
    {&mip_3dm_get_event_trigger_status_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_get_event_trigger_status_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GET_EVENT_TRIGGER_STATUS_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_get_event_trigger_status),
    0, /* time-out */
    read_get_event_trigger_status,
    write_get_event_trigger_status,
    NULL,
    responses_get_event_trigger_status,
    NULL,
};

mip_error mip_3dm_get_event_trigger_status_decode(struct mip_3dm_get_event_trigger_status *value,
                                                  const struct mip_field *field) {
    return mip_decode_field(field, read_get_event_trigger_status, value, sizeof(*value), NULL);
}

mip_error mip_3dm_get_event_trigger_status_encode(
    const struct mip_3dm_get_event_trigger_status *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GET_EVENT_TRIGGER_STATUS_DESCRIPTOR,
                            write_get_event_trigger_status, value);
}

struct mip_3dm_get_event_trigger_status mip_3dm_get_event_trigger_status_make(
    uint8_t requested_count, const uint8_t requested_instances[]) {
    struct mip_3dm_get_event_trigger_status v;
    memset(&v, 0, sizeof(v));
    v.requested_count = requested_count;
    mip_copy(v.requested_instances, sizeof(v.requested_instances), requested_instances,
             requested_count * sizeof(requested_instances[0]));
    return v;
}

static void read_get_event_trigger_status_response(struct mip_reader *r, void *value) {
    struct mip_3dm_get_event_trigger_status_response *v =
        (struct mip_3dm_get_event_trigger_status_response *)value;
    mip_read_u8(r, &v->count, 1);
    for (size_t i = 0, n = mip_read_count(r, v->count, 126, 2); i < n; i++) {
        mip_3dm_event_trigger_status_entry_read(r, &v->triggers[i]);
    }
}

static void write_get_event_trigger_status_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_get_event_trigger_status_response *v =
        (const struct mip_3dm_get_event_trigger_status_response *)value;
    mip_write_u8(w, &v->count, 1);
    for (size_t i = 0, n = mip_write_count(w, v->count, 126); i < n; i++) {
        mip_3dm_event_trigger_status_entry_write(w, &v->triggers[i]);
    }
}

const struct mip_codec mip_3dm_get_event_trigger_status_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GET_EVENT_TRIGGER_STATUS_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_get_event_trigger_status_response),
    0, /* time-out */
    read_get_event_trigger_status_response,
    write_get_event_trigger_status_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_get_event_trigger_status_response_decode(
    struct mip_3dm_get_event_trigger_status_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_get_event_trigger_status_response, value, sizeof(*value),
                            NULL);
}

mip_error mip_3dm_get_event_trigger_status_response_encode(
    const struct mip_3dm_get_event_trigger_status_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GET_EVENT_TRIGGER_STATUS_RESPONSE_DESCRIPTOR,
                            write_get_event_trigger_status_response, value);
}

static void read_get_event_action_status(struct mip_reader *r, void *value) {
    struct mip_3dm_get_event_action_status *v = (struct mip_3dm_get_event_action_status *)value;
    mip_read_u8(r, &v->requested_count, 1);
    mip_read_u8(r, v->requested_instances, mip_read_count(r, v->requested_count, 252, 1));
}

static void write_get_event_action_status(struct mip_writer *w, const void *value) {
    const struct mip_3dm_get_event_action_status *v =
        (const struct mip_3dm_get_event_action_status *)value;
    mip_write_u8(w, &v->requested_count, 1);
    mip_write_u8(w, v->requested_instances, mip_write_count(w, v->requested_count, 252));
}

static const struct mip_response responses_get_event_action_status[] = {
    {&mip_3dm_get_event_action_status_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_get_event_action_status_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GET_EVENT_ACTION_STATUS_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_get_event_action_status),
    0, /* time-out */
    read_get_event_action_status,
    write_get_event_action_status,
    NULL,
    responses_get_event_action_status,
    NULL,
};

mip_error mip_3dm_get_event_action_status_decode(struct mip_3dm_get_event_action_status *value,
                                                 const struct mip_field *field) {
    return mip_decode_field(field, read_get_event_action_status, value, sizeof(*value), NULL);
}

mip_error mip_3dm_get_event_action_status_encode(
    const struct mip_3dm_get_event_action_status *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GET_EVENT_ACTION_STATUS_DESCRIPTOR,
                            write_get_event_action_status, value);
}

struct mip_3dm_get_event_action_status
mip_3dm_get_event_action_status_make(uint8_t requested_count, const uint8_t requested_instances[]) {
    struct mip_3dm_get_event_action_status v;
    memset(&v, 0, sizeof(v));
    v.requested_count = requested_count;
    mip_copy(v.requested_instances, sizeof(v.requested_instances), requested_instances,
             requested_count * sizeof(requested_instances[0]));
    return v;
}

static void read_get_event_action_status_response(struct mip_reader *r, void *value) {
    struct mip_3dm_get_event_action_status_response *v =
        (struct mip_3dm_get_event_action_status_response *)value;
    mip_read_u8(r, &v->count, 1);
    for (size_t i = 0, n = mip_read_count(r, v->count, 126, 2); i < n; i++) {
        mip_3dm_event_action_status_entry_read(r, &v->actions[i]);
    }
}

static void write_get_event_action_status_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_get_event_action_status_response *v =
        (const struct mip_3dm_get_event_action_status_response *)value;
    mip_write_u8(w, &v->count, 1);
    for (size_t i = 0, n = mip_write_count(w, v->count, 126); i < n; i++) {
        mip_3dm_event_action_status_entry_write(w, &v->actions[i]);
    }
}

const struct mip_codec mip_3dm_get_event_action_status_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GET_EVENT_ACTION_STATUS_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_get_event_action_status_response),
    0, /* time-out */
    read_get_event_action_status_response,
    write_get_event_action_status_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_get_event_action_status_response_decode(
    struct mip_3dm_get_event_action_status_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_get_event_action_status_response, value, sizeof(*value),
                            NULL);
}

mip_error mip_3dm_get_event_action_status_response_encode(
    const struct mip_3dm_get_event_action_status_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GET_EVENT_ACTION_STATUS_RESPONSE_DESCRIPTOR,
                            write_get_event_action_status_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_event_trigger_config[] = {0, 3, 1, 1, 1, 1};

static void read_event_trigger_config(struct mip_reader *r, void *value) {
    struct mip_3dm_event_trigger_config *v = (struct mip_3dm_event_trigger_config *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_event_trigger_config,
                      sizeof(required_event_trigger_config));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->instance, 1);
    mip_read_group(r, 2, 2);
    mip_read_u8(r, &v->type, 1);
    mip_read_group(r, 3, 3);
    switch (v->type) {
    case MIP_EVENT_TRIGGER_TYPE_GPIO:
        mip_event_trigger_gpio_read(r, &v->parameters.gpio);
        break;
    case MIP_EVENT_TRIGGER_TYPE_THRESHOLD:
        mip_event_trigger_threshold_read(r, &v->parameters.threshold);
        break;
    case MIP_EVENT_TRIGGER_TYPE_COMBINATION:
        mip_event_trigger_combination_read(r, &v->parameters.combination);
        break;
    default:
        break;
    }
    v->present = mip_read_present(r);
}

static void write_event_trigger_config(struct mip_writer *w, const void *value) {
    const struct mip_3dm_event_trigger_config *v =
        (const struct mip_3dm_event_trigger_config *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_event_trigger_config,
                       sizeof(required_event_trigger_config), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->instance, 1);
    mip_write_group(w, 2, 2);
    mip_write_u8(w, &v->type, 1);
    mip_write_group(w, 3, 3);
    switch (v->type) {
    case MIP_EVENT_TRIGGER_TYPE_GPIO:
        mip_event_trigger_gpio_write(w, &v->parameters.gpio);
        break;
    case MIP_EVENT_TRIGGER_TYPE_THRESHOLD:
        mip_event_trigger_threshold_write(w, &v->parameters.threshold);
        break;
    case MIP_EVENT_TRIGGER_TYPE_COMBINATION:
        mip_event_trigger_combination_write(w, &v->parameters.combination);
        break;
    default:
        break;
    }
}

static bool asked_event_trigger_config_1(const void *value) {
    const struct mip_3dm_event_trigger_config *v =
        (const struct mip_3dm_event_trigger_config *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_event_trigger_config[] = {
    {&mip_3dm_event_trigger_config_response_codec, asked_event_trigger_config_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_event_trigger_config_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_EVENT_TRIGGER_CONFIG_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_event_trigger_config),
    0, /* time-out */
    read_event_trigger_config,
    write_event_trigger_config,
    NULL,
    responses_event_trigger_config,
    NULL,
};

mip_error mip_3dm_event_trigger_config_decode(struct mip_3dm_event_trigger_config *value,
                                              const struct mip_field *field) {
    return mip_decode_field(field, read_event_trigger_config, value, sizeof(*value), NULL);
}

mip_error mip_3dm_event_trigger_config_encode(const struct mip_3dm_event_trigger_config *value,
                                              struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_EVENT_TRIGGER_CONFIG_DESCRIPTOR,
                            write_event_trigger_config, value);
}

struct mip_3dm_event_trigger_config mip_3dm_event_trigger_config_write(
    uint8_t instance, mip_event_trigger_type type,
    const union mip_3dm_event_trigger_config_parameters *parameters) {
    struct mip_3dm_event_trigger_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.instance = instance;
    v.type = type;
    if (parameters != NULL) {
        v.parameters = *parameters;
    }
    return v;
}

struct mip_3dm_event_trigger_config mip_3dm_event_trigger_config_read(uint8_t instance) {
    struct mip_3dm_event_trigger_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    v.instance = instance;
    return v;
}

struct mip_3dm_event_trigger_config mip_3dm_event_trigger_config_save(uint8_t instance) {
    struct mip_3dm_event_trigger_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    v.instance = instance;
    return v;
}

struct mip_3dm_event_trigger_config mip_3dm_event_trigger_config_load(uint8_t instance) {
    struct mip_3dm_event_trigger_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    v.instance = instance;
    return v;
}

struct mip_3dm_event_trigger_config mip_3dm_event_trigger_config_default(uint8_t instance) {
    struct mip_3dm_event_trigger_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    v.instance = instance;
    return v;
}

static void read_event_trigger_config_response(struct mip_reader *r, void *value) {
    struct mip_3dm_event_trigger_config_response *v =
        (struct mip_3dm_event_trigger_config_response *)value;
    mip_read_u8(r, &v->instance, 1);
    mip_read_u8(r, &v->type, 1);
    switch (v->type) {
    case MIP_EVENT_TRIGGER_TYPE_GPIO:
        mip_event_trigger_gpio_read(r, &v->parameters.gpio);
        break;
    case MIP_EVENT_TRIGGER_TYPE_THRESHOLD:
        mip_event_trigger_threshold_read(r, &v->parameters.threshold);
        break;
    case MIP_EVENT_TRIGGER_TYPE_COMBINATION:
        mip_event_trigger_combination_read(r, &v->parameters.combination);
        break;
    default:
        break;
    }
}

static void write_event_trigger_config_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_event_trigger_config_response *v =
        (const struct mip_3dm_event_trigger_config_response *)value;
    mip_write_u8(w, &v->instance, 1);
    mip_write_u8(w, &v->type, 1);
    switch (v->type) {
    case MIP_EVENT_TRIGGER_TYPE_GPIO:
        mip_event_trigger_gpio_write(w, &v->parameters.gpio);
        break;
    case MIP_EVENT_TRIGGER_TYPE_THRESHOLD:
        mip_event_trigger_threshold_write(w, &v->parameters.threshold);
        break;
    case MIP_EVENT_TRIGGER_TYPE_COMBINATION:
        mip_event_trigger_combination_write(w, &v->parameters.combination);
        break;
    default:
        break;
    }
}

const struct mip_codec mip_3dm_event_trigger_config_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_EVENT_TRIGGER_CONFIG_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_event_trigger_config_response),
    0, /* time-out */
    read_event_trigger_config_response,
    write_event_trigger_config_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_event_trigger_config_response_decode(
    struct mip_3dm_event_trigger_config_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_event_trigger_config_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_event_trigger_config_response_encode(
    const struct mip_3dm_event_trigger_config_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_EVENT_TRIGGER_CONFIG_RESPONSE_DESCRIPTOR,
                            write_event_trigger_config_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_event_action_config[] = {0, 4, 1, 1, 1, 1};

static void read_event_action_config(struct mip_reader *r, void *value) {
    struct mip_3dm_event_action_config *v = (struct mip_3dm_event_action_config *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_event_action_config,
                      sizeof(required_event_action_config));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->instance, 1);
    mip_read_group(r, 2, 2);
    mip_read_u8(r, &v->trigger, 1);
    mip_read_group(r, 3, 3);
    mip_read_u8(r, &v->type, 1);
    mip_read_group(r, 4, 4);
    switch (v->type) {
    case MIP_EVENT_ACTION_TYPE_GPIO:
        mip_event_action_gpio_read(r, &v->parameters.gpio);
        break;
    case MIP_EVENT_ACTION_TYPE_MESSAGE:
        mip_event_action_message_read(r, &v->parameters.message);
        break;
    default:
        break;
    }
    v->present = mip_read_present(r);
}

static void write_event_action_config(struct mip_writer *w, const void *value) {
    const struct mip_3dm_event_action_config *v = (const struct mip_3dm_event_action_config *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_event_action_config,
                       sizeof(required_event_action_config), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->instance, 1);
    mip_write_group(w, 2, 2);
    mip_write_u8(w, &v->trigger, 1);
    mip_write_group(w, 3, 3);
    mip_write_u8(w, &v->type, 1);
    mip_write_group(w, 4, 4);
    switch (v->type) {
    case MIP_EVENT_ACTION_TYPE_GPIO:
        mip_event_action_gpio_write(w, &v->parameters.gpio);
        break;
    case MIP_EVENT_ACTION_TYPE_MESSAGE:
        mip_event_action_message_write(w, &v->parameters.message);
        break;
    default:
        break;
    }
}

static bool asked_event_action_config_1(const void *value) {
    const struct mip_3dm_event_action_config *v = (const struct mip_3dm_event_action_config *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_event_action_config[] = {
    {&mip_3dm_event_action_config_response_codec, asked_event_action_config_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_event_action_config_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_EVENT_ACTION_CONFIG_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_event_action_config),
    0, /* time-out */
    read_event_action_config,
    write_event_action_config,
    NULL,
    responses_event_action_config,
    NULL,
};

mip_error mip_3dm_event_action_config_decode(struct mip_3dm_event_action_config *value,
                                             const struct mip_field *field) {
    return mip_decode_field(field, read_event_action_config, value, sizeof(*value), NULL);
}

mip_error mip_3dm_event_action_config_encode(const struct mip_3dm_event_action_config *value,
                                             struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_EVENT_ACTION_CONFIG_DESCRIPTOR,
                            write_event_action_config, value);
}

struct mip_3dm_event_action_config
mip_3dm_event_action_config_write(uint8_t instance, uint8_t trigger, mip_event_action_type type,
                                  const union mip_3dm_event_action_config_parameters *parameters) {
    struct mip_3dm_event_action_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.instance = instance;
    v.trigger = trigger;
    v.type = type;
    if (parameters != NULL) {
        v.parameters = *parameters;
    }
    return v;
}

struct mip_3dm_event_action_config mip_3dm_event_action_config_read(uint8_t instance) {
    struct mip_3dm_event_action_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    v.instance = instance;
    return v;
}

struct mip_3dm_event_action_config mip_3dm_event_action_config_save(uint8_t instance) {
    struct mip_3dm_event_action_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    v.instance = instance;
    return v;
}

struct mip_3dm_event_action_config mip_3dm_event_action_config_load(uint8_t instance) {
    struct mip_3dm_event_action_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    v.instance = instance;
    return v;
}

struct mip_3dm_event_action_config mip_3dm_event_action_config_default(uint8_t instance) {
    struct mip_3dm_event_action_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    v.instance = instance;
    return v;
}

static void read_event_action_config_response(struct mip_reader *r, void *value) {
    struct mip_3dm_event_action_config_response *v =
        (struct mip_3dm_event_action_config_response *)value;
    mip_read_u8(r, &v->instance, 1);
    mip_read_u8(r, &v->trigger, 1);
    mip_read_u8(r, &v->type, 1);
    switch (v->type) {
    case MIP_EVENT_ACTION_TYPE_GPIO:
        mip_event_action_gpio_read(r, &v->parameters.gpio);
        break;
    case MIP_EVENT_ACTION_TYPE_MESSAGE:
        mip_event_action_message_read(r, &v->parameters.message);
        break;
    default:
        break;
    }
}

static void write_event_action_config_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_event_action_config_response *v =
        (const struct mip_3dm_event_action_config_response *)value;
    mip_write_u8(w, &v->instance, 1);
    mip_write_u8(w, &v->trigger, 1);
    mip_write_u8(w, &v->type, 1);
    switch (v->type) {
    case MIP_EVENT_ACTION_TYPE_GPIO:
        mip_event_action_gpio_write(w, &v->parameters.gpio);
        break;
    case MIP_EVENT_ACTION_TYPE_MESSAGE:
        mip_event_action_message_write(w, &v->parameters.message);
        break;
    default:
        break;
    }
}

const struct mip_codec mip_3dm_event_action_config_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_EVENT_ACTION_CONFIG_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_event_action_config_response),
    0, /* time-out */
    read_event_action_config_response,
    write_event_action_config_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_event_action_config_response_decode(
    struct mip_3dm_event_action_config_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_event_action_config_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_event_action_config_response_encode(
    const struct mip_3dm_event_action_config_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_EVENT_ACTION_CONFIG_RESPONSE_DESCRIPTOR,
                            write_event_action_config_response, value);
}

static void read_device_settings(struct mip_reader *r, void *value) {
    struct mip_3dm_device_settings *v = (struct mip_3dm_device_settings *)value;
    mip_read_u8(r, &v->function, 1);
}

static void write_device_settings(struct mip_writer *w, const void *value) {
    const struct mip_3dm_device_settings *v = (const struct mip_3dm_device_settings *)value;
    mip_write_u8(w, &v->function, 1);
}

const struct mip_codec mip_3dm_device_settings_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_DEVICE_SETTINGS_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_device_settings),
    1000, /* time-out */
    read_device_settings,
    write_device_settings,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_device_settings_decode(struct mip_3dm_device_settings *value,
                                         const struct mip_field *field) {
    return mip_decode_field(field, read_device_settings, value, sizeof(*value), NULL);
}

mip_error mip_3dm_device_settings_encode(const struct mip_3dm_device_settings *value,
                                         struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_DEVICE_SETTINGS_DESCRIPTOR,
                            write_device_settings, value);
}

struct mip_3dm_device_settings mip_3dm_device_settings_save(void) {
    struct mip_3dm_device_settings v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_3dm_device_settings mip_3dm_device_settings_load(void) {
    struct mip_3dm_device_settings v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_3dm_device_settings mip_3dm_device_settings_default(void) {
    struct mip_3dm_device_settings v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_sensor_to_vehicle_transform_euler[] = {0, 3, 0, 0, 0, 0};

static void read_sensor_to_vehicle_transform_euler(struct mip_reader *r, void *value) {
    struct mip_3dm_sensor_to_vehicle_euler *v = (struct mip_3dm_sensor_to_vehicle_euler *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_sensor_to_vehicle_transform_euler,
                      sizeof(required_sensor_to_vehicle_transform_euler));
    mip_read_group(r, 1, 1);
    mip_read_float(r, &v->roll, 1);
    mip_read_group(r, 2, 2);
    mip_read_float(r, &v->pitch, 1);
    mip_read_group(r, 3, 3);
    mip_read_float(r, &v->yaw, 1);
    v->present = mip_read_present(r);
}

static void write_sensor_to_vehicle_transform_euler(struct mip_writer *w, const void *value) {
    const struct mip_3dm_sensor_to_vehicle_euler *v =
        (const struct mip_3dm_sensor_to_vehicle_euler *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_sensor_to_vehicle_transform_euler,
                       sizeof(required_sensor_to_vehicle_transform_euler), v->present);
    mip_write_group(w, 1, 1);
    mip_write_float(w, &v->roll, 1);
    mip_write_group(w, 2, 2);
    mip_write_float(w, &v->pitch, 1);
    mip_write_group(w, 3, 3);
    mip_write_float(w, &v->yaw, 1);
}

static bool asked_sensor_to_vehicle_transform_euler_1(const void *value) {
    const struct mip_3dm_sensor_to_vehicle_euler *v =
        (const struct mip_3dm_sensor_to_vehicle_euler *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_sensor_to_vehicle_transform_euler[] = {
    {&mip_3dm_sensor_to_vehicle_euler_response_codec, asked_sensor_to_vehicle_transform_euler_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_sensor_to_vehicle_euler_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_SENSOR_TO_VEHICLE_EULER_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_sensor_to_vehicle_euler),
    0, /* time-out */
    read_sensor_to_vehicle_transform_euler,
    write_sensor_to_vehicle_transform_euler,
    NULL,
    responses_sensor_to_vehicle_transform_euler,
    NULL,
};

mip_error mip_3dm_sensor_to_vehicle_euler_decode(struct mip_3dm_sensor_to_vehicle_euler *value,
                                                 const struct mip_field *field) {
    return mip_decode_field(field, read_sensor_to_vehicle_transform_euler, value, sizeof(*value),
                            NULL);
}

mip_error mip_3dm_sensor_to_vehicle_euler_encode(
    const struct mip_3dm_sensor_to_vehicle_euler *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_SENSOR_TO_VEHICLE_EULER_DESCRIPTOR,
                            write_sensor_to_vehicle_transform_euler, value);
}

struct mip_3dm_sensor_to_vehicle_euler mip_3dm_sensor_to_vehicle_euler_write(float roll,
                                                                             float pitch,
                                                                             float yaw) {
    struct mip_3dm_sensor_to_vehicle_euler v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.roll = roll;
    v.pitch = pitch;
    v.yaw = yaw;
    return v;
}

struct mip_3dm_sensor_to_vehicle_euler mip_3dm_sensor_to_vehicle_euler_read(void) {
    struct mip_3dm_sensor_to_vehicle_euler v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_3dm_sensor_to_vehicle_euler mip_3dm_sensor_to_vehicle_euler_save(void) {
    struct mip_3dm_sensor_to_vehicle_euler v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_3dm_sensor_to_vehicle_euler mip_3dm_sensor_to_vehicle_euler_load(void) {
    struct mip_3dm_sensor_to_vehicle_euler v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_3dm_sensor_to_vehicle_euler mip_3dm_sensor_to_vehicle_euler_default(void) {
    struct mip_3dm_sensor_to_vehicle_euler v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_sensor_to_vehicle_transform_euler_response(struct mip_reader *r, void *value) {
    struct mip_3dm_sensor_to_vehicle_euler_response *v =
        (struct mip_3dm_sensor_to_vehicle_euler_response *)value;
    mip_read_float(r, &v->roll, 1);
    mip_read_float(r, &v->pitch, 1);
    mip_read_float(r, &v->yaw, 1);
}

static void write_sensor_to_vehicle_transform_euler_response(struct mip_writer *w,
                                                             const void *value) {
    const struct mip_3dm_sensor_to_vehicle_euler_response *v =
        (const struct mip_3dm_sensor_to_vehicle_euler_response *)value;
    mip_write_float(w, &v->roll, 1);
    mip_write_float(w, &v->pitch, 1);
    mip_write_float(w, &v->yaw, 1);
}

const struct mip_codec mip_3dm_sensor_to_vehicle_euler_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_SENSOR_TO_VEHICLE_EULER_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_sensor_to_vehicle_euler_response),
    0, /* time-out */
    read_sensor_to_vehicle_transform_euler_response,
    write_sensor_to_vehicle_transform_euler_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_sensor_to_vehicle_euler_response_decode(
    struct mip_3dm_sensor_to_vehicle_euler_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_sensor_to_vehicle_transform_euler_response, value,
                            sizeof(*value), NULL);
}

mip_error mip_3dm_sensor_to_vehicle_euler_response_encode(
    const struct mip_3dm_sensor_to_vehicle_euler_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_SENSOR_TO_VEHICLE_EULER_RESPONSE_DESCRIPTOR,
                            write_sensor_to_vehicle_transform_euler_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_sensor_to_vehicle_transform_quaternion[] = {0, 1, 0, 0, 0, 0};

static void read_sensor_to_vehicle_transform_quaternion(struct mip_reader *r, void *value) {
    struct mip_3dm_sensor_to_vehicle_quaternion *v =
        (struct mip_3dm_sensor_to_vehicle_quaternion *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_sensor_to_vehicle_transform_quaternion,
                      sizeof(required_sensor_to_vehicle_transform_quaternion));
    mip_read_group(r, 1, 1);
    mip_read_float(r, v->q, 4);
    v->present = mip_read_present(r);
}

static void write_sensor_to_vehicle_transform_quaternion(struct mip_writer *w, const void *value) {
    const struct mip_3dm_sensor_to_vehicle_quaternion *v =
        (const struct mip_3dm_sensor_to_vehicle_quaternion *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_sensor_to_vehicle_transform_quaternion,
                       sizeof(required_sensor_to_vehicle_transform_quaternion), v->present);
    mip_write_group(w, 1, 1);
    mip_write_float(w, v->q, 4);
}

static bool asked_sensor_to_vehicle_transform_quaternion_1(const void *value) {
    const struct mip_3dm_sensor_to_vehicle_quaternion *v =
        (const struct mip_3dm_sensor_to_vehicle_quaternion *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_sensor_to_vehicle_transform_quaternion[] = {
    {&mip_3dm_sensor_to_vehicle_quaternion_response_codec,
     asked_sensor_to_vehicle_transform_quaternion_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_sensor_to_vehicle_quaternion_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_SENSOR_TO_VEHICLE_QUATERNION_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_sensor_to_vehicle_quaternion),
    0, /* time-out */
    read_sensor_to_vehicle_transform_quaternion,
    write_sensor_to_vehicle_transform_quaternion,
    NULL,
    responses_sensor_to_vehicle_transform_quaternion,
    NULL,
};

mip_error mip_3dm_sensor_to_vehicle_quaternion_decode(
    struct mip_3dm_sensor_to_vehicle_quaternion *value, const struct mip_field *field) {
    return mip_decode_field(field, read_sensor_to_vehicle_transform_quaternion, value,
                            sizeof(*value), NULL);
}

mip_error mip_3dm_sensor_to_vehicle_quaternion_encode(
    const struct mip_3dm_sensor_to_vehicle_quaternion *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_SENSOR_TO_VEHICLE_QUATERNION_DESCRIPTOR,
                            write_sensor_to_vehicle_transform_quaternion, value);
}

struct mip_3dm_sensor_to_vehicle_quaternion
mip_3dm_sensor_to_vehicle_quaternion_write(const float q[4]) {
    struct mip_3dm_sensor_to_vehicle_quaternion v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(v.q, q, sizeof(v.q));
    return v;
}

struct mip_3dm_sensor_to_vehicle_quaternion mip_3dm_sensor_to_vehicle_quaternion_read(void) {
    struct mip_3dm_sensor_to_vehicle_quaternion v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_3dm_sensor_to_vehicle_quaternion mip_3dm_sensor_to_vehicle_quaternion_save(void) {
    struct mip_3dm_sensor_to_vehicle_quaternion v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_3dm_sensor_to_vehicle_quaternion mip_3dm_sensor_to_vehicle_quaternion_load(void) {
    struct mip_3dm_sensor_to_vehicle_quaternion v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_3dm_sensor_to_vehicle_quaternion mip_3dm_sensor_to_vehicle_quaternion_default(void) {
    struct mip_3dm_sensor_to_vehicle_quaternion v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_sensor_to_vehicle_transform_quaternion_response(struct mip_reader *r,
                                                                 void *value) {
    struct mip_3dm_sensor_to_vehicle_quaternion_response *v =
        (struct mip_3dm_sensor_to_vehicle_quaternion_response *)value;
    mip_read_float(r, v->q, 4);
}

static void write_sensor_to_vehicle_transform_quaternion_response(struct mip_writer *w,
                                                                  const void *value) {
    const struct mip_3dm_sensor_to_vehicle_quaternion_response *v =
        (const struct mip_3dm_sensor_to_vehicle_quaternion_response *)value;
    mip_write_float(w, v->q, 4);
}

const struct mip_codec mip_3dm_sensor_to_vehicle_quaternion_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_SENSOR_TO_VEHICLE_QUATERNION_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_sensor_to_vehicle_quaternion_response),
    0, /* time-out */
    read_sensor_to_vehicle_transform_quaternion_response,
    write_sensor_to_vehicle_transform_quaternion_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_sensor_to_vehicle_quaternion_response_decode(
    struct mip_3dm_sensor_to_vehicle_quaternion_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_sensor_to_vehicle_transform_quaternion_response, value,
                            sizeof(*value), NULL);
}

mip_error mip_3dm_sensor_to_vehicle_quaternion_response_encode(
    const struct mip_3dm_sensor_to_vehicle_quaternion_response *value,
    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_SENSOR_TO_VEHICLE_QUATERNION_RESPONSE_DESCRIPTOR,
                            write_sensor_to_vehicle_transform_quaternion_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_sensor_to_vehicle_transform_dcm[] = {0, 1, 0, 0, 0, 0};

static void read_sensor_to_vehicle_transform_dcm(struct mip_reader *r, void *value) {
    struct mip_3dm_sensor_to_vehicle_dcm *v = (struct mip_3dm_sensor_to_vehicle_dcm *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_sensor_to_vehicle_transform_dcm,
                      sizeof(required_sensor_to_vehicle_transform_dcm));
    mip_read_group(r, 1, 1);
    mip_read_float(r, v->dcm, 9);
    v->present = mip_read_present(r);
}

static void write_sensor_to_vehicle_transform_dcm(struct mip_writer *w, const void *value) {
    const struct mip_3dm_sensor_to_vehicle_dcm *v =
        (const struct mip_3dm_sensor_to_vehicle_dcm *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_sensor_to_vehicle_transform_dcm,
                       sizeof(required_sensor_to_vehicle_transform_dcm), v->present);
    mip_write_group(w, 1, 1);
    mip_write_float(w, v->dcm, 9);
}

static bool asked_sensor_to_vehicle_transform_dcm_1(const void *value) {
    const struct mip_3dm_sensor_to_vehicle_dcm *v =
        (const struct mip_3dm_sensor_to_vehicle_dcm *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_sensor_to_vehicle_transform_dcm[] = {
    {&mip_3dm_sensor_to_vehicle_dcm_response_codec, asked_sensor_to_vehicle_transform_dcm_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_sensor_to_vehicle_dcm_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_SENSOR_TO_VEHICLE_DCM_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_sensor_to_vehicle_dcm),
    0, /* time-out */
    read_sensor_to_vehicle_transform_dcm,
    write_sensor_to_vehicle_transform_dcm,
    NULL,
    responses_sensor_to_vehicle_transform_dcm,
    NULL,
};

mip_error mip_3dm_sensor_to_vehicle_dcm_decode(struct mip_3dm_sensor_to_vehicle_dcm *value,
                                               const struct mip_field *field) {
    return mip_decode_field(field, read_sensor_to_vehicle_transform_dcm, value, sizeof(*value),
                            NULL);
}

mip_error mip_3dm_sensor_to_vehicle_dcm_encode(const struct mip_3dm_sensor_to_vehicle_dcm *value,
                                               struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_SENSOR_TO_VEHICLE_DCM_DESCRIPTOR,
                            write_sensor_to_vehicle_transform_dcm, value);
}

struct mip_3dm_sensor_to_vehicle_dcm mip_3dm_sensor_to_vehicle_dcm_write(const float dcm[9]) {
    struct mip_3dm_sensor_to_vehicle_dcm v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(v.dcm, dcm, sizeof(v.dcm));
    return v;
}

struct mip_3dm_sensor_to_vehicle_dcm mip_3dm_sensor_to_vehicle_dcm_read(void) {
    struct mip_3dm_sensor_to_vehicle_dcm v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_3dm_sensor_to_vehicle_dcm mip_3dm_sensor_to_vehicle_dcm_save(void) {
    struct mip_3dm_sensor_to_vehicle_dcm v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_3dm_sensor_to_vehicle_dcm mip_3dm_sensor_to_vehicle_dcm_load(void) {
    struct mip_3dm_sensor_to_vehicle_dcm v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_3dm_sensor_to_vehicle_dcm mip_3dm_sensor_to_vehicle_dcm_default(void) {
    struct mip_3dm_sensor_to_vehicle_dcm v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_sensor_to_vehicle_transform_dcm_response(struct mip_reader *r, void *value) {
    struct mip_3dm_sensor_to_vehicle_dcm_response *v =
        (struct mip_3dm_sensor_to_vehicle_dcm_response *)value;
    mip_read_float(r, v->dcm, 9);
}

static void write_sensor_to_vehicle_transform_dcm_response(struct mip_writer *w,
                                                           const void *value) {
    const struct mip_3dm_sensor_to_vehicle_dcm_response *v =
        (const struct mip_3dm_sensor_to_vehicle_dcm_response *)value;
    mip_write_float(w, v->dcm, 9);
}

const struct mip_codec mip_3dm_sensor_to_vehicle_dcm_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_SENSOR_TO_VEHICLE_DCM_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_sensor_to_vehicle_dcm_response),
    0, /* time-out */
    read_sensor_to_vehicle_transform_dcm_response,
    write_sensor_to_vehicle_transform_dcm_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_sensor_to_vehicle_dcm_response_decode(
    struct mip_3dm_sensor_to_vehicle_dcm_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_sensor_to_vehicle_transform_dcm_response, value,
                            sizeof(*value), NULL);
}

mip_error mip_3dm_sensor_to_vehicle_dcm_response_encode(
    const struct mip_3dm_sensor_to_vehicle_dcm_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_SENSOR_TO_VEHICLE_DCM_RESPONSE_DESCRIPTOR,
                            write_sensor_to_vehicle_transform_dcm_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_accel_bias[] = {0, 1, 0, 0, 0, 0, 1};

static void read_accel_bias(struct mip_reader *r, void *value) {
    struct mip_3dm_accel_bias *v = (struct mip_3dm_accel_bias *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_accel_bias, sizeof(required_accel_bias));
    mip_read_group(r, 1, 1);
    mip_read_float(r, v->bias, 3);
    v->present = mip_read_present(r);
}

static void write_accel_bias(struct mip_writer *w, const void *value) {
    const struct mip_3dm_accel_bias *v = (const struct mip_3dm_accel_bias *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_accel_bias, sizeof(required_accel_bias),
                       v->present);
    mip_write_group(w, 1, 1);
    mip_write_float(w, v->bias, 3);
}

static bool silent_accel_bias(const void *value) {
    const struct mip_3dm_accel_bias *v = (const struct mip_3dm_accel_bias *)value;
    return v->function == MIP_FUNCTION_SELECTOR_APPLY;
}

static bool asked_accel_bias_1(const void *value) {
    const struct mip_3dm_accel_bias *v = (const struct mip_3dm_accel_bias *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_accel_bias[] = {
    {&mip_3dm_accel_bias_response_codec, asked_accel_bias_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_accel_bias_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_ACCEL_BIAS_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_accel_bias),
    0, /* time-out */
    read_accel_bias,
    write_accel_bias,
    silent_accel_bias,
    responses_accel_bias,
    NULL,
};

mip_error mip_3dm_accel_bias_decode(struct mip_3dm_accel_bias *value,
                                    const struct mip_field *field) {
    return mip_decode_field(field, read_accel_bias, value, sizeof(*value), NULL);
}

mip_error mip_3dm_accel_bias_encode(const struct mip_3dm_accel_bias *value,
                                    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_ACCEL_BIAS_DESCRIPTOR, write_accel_bias, value);
}

struct mip_3dm_accel_bias mip_3dm_accel_bias_write(const float bias[3]) {
    struct mip_3dm_accel_bias v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(v.bias, bias, sizeof(v.bias));
    return v;
}

struct mip_3dm_accel_bias mip_3dm_accel_bias_read(void) {
    struct mip_3dm_accel_bias v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_3dm_accel_bias mip_3dm_accel_bias_save(void) {
    struct mip_3dm_accel_bias v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_3dm_accel_bias mip_3dm_accel_bias_load(void) {
    struct mip_3dm_accel_bias v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_3dm_accel_bias mip_3dm_accel_bias_default(void) {
    struct mip_3dm_accel_bias v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

struct mip_3dm_accel_bias mip_3dm_accel_bias_apply(const float bias[3]) {
    struct mip_3dm_accel_bias v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_APPLY;
    memcpy(v.bias, bias, sizeof(v.bias));
    return v;
}

static void read_accel_bias_response(struct mip_reader *r, void *value) {
    struct mip_3dm_accel_bias_response *v = (struct mip_3dm_accel_bias_response *)value;
    mip_read_float(r, v->bias, 3);
}

static void write_accel_bias_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_accel_bias_response *v = (const struct mip_3dm_accel_bias_response *)value;
    mip_write_float(w, v->bias, 3);
}

const struct mip_codec mip_3dm_accel_bias_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_ACCEL_BIAS_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_accel_bias_response),
    0, /* time-out */
    read_accel_bias_response,
    write_accel_bias_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_accel_bias_response_decode(struct mip_3dm_accel_bias_response *value,
                                             const struct mip_field *field) {
    return mip_decode_field(field, read_accel_bias_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_accel_bias_response_encode(const struct mip_3dm_accel_bias_response *value,
                                             struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_ACCEL_BIAS_RESPONSE_DESCRIPTOR,
                            write_accel_bias_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_gyro_bias[] = {0, 1, 0, 0, 0, 0, 1};

static void read_gyro_bias(struct mip_reader *r, void *value) {
    struct mip_3dm_gyro_bias *v = (struct mip_3dm_gyro_bias *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_gyro_bias, sizeof(required_gyro_bias));
    mip_read_group(r, 1, 1);
    mip_read_float(r, v->bias, 3);
    v->present = mip_read_present(r);
}

static void write_gyro_bias(struct mip_writer *w, const void *value) {
    const struct mip_3dm_gyro_bias *v = (const struct mip_3dm_gyro_bias *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_gyro_bias, sizeof(required_gyro_bias), v->present);
    mip_write_group(w, 1, 1);
    mip_write_float(w, v->bias, 3);
}

static bool silent_gyro_bias(const void *value) {
    const struct mip_3dm_gyro_bias *v = (const struct mip_3dm_gyro_bias *)value;
    return v->function == MIP_FUNCTION_SELECTOR_APPLY;
}

static bool asked_gyro_bias_1(const void *value) {
    const struct mip_3dm_gyro_bias *v = (const struct mip_3dm_gyro_bias *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_gyro_bias[] = {
    {&mip_3dm_gyro_bias_response_codec, asked_gyro_bias_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_gyro_bias_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GYRO_BIAS_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_gyro_bias),
    0, /* time-out */
    read_gyro_bias,
    write_gyro_bias,
    silent_gyro_bias,
    responses_gyro_bias,
    NULL,
};

mip_error mip_3dm_gyro_bias_decode(struct mip_3dm_gyro_bias *value, const struct mip_field *field) {
    return mip_decode_field(field, read_gyro_bias, value, sizeof(*value), NULL);
}

mip_error mip_3dm_gyro_bias_encode(const struct mip_3dm_gyro_bias *value,
                                   struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GYRO_BIAS_DESCRIPTOR, write_gyro_bias, value);
}

struct mip_3dm_gyro_bias mip_3dm_gyro_bias_write(const float bias[3]) {
    struct mip_3dm_gyro_bias v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(v.bias, bias, sizeof(v.bias));
    return v;
}

struct mip_3dm_gyro_bias mip_3dm_gyro_bias_read(void) {
    struct mip_3dm_gyro_bias v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_3dm_gyro_bias mip_3dm_gyro_bias_save(void) {
    struct mip_3dm_gyro_bias v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_3dm_gyro_bias mip_3dm_gyro_bias_load(void) {
    struct mip_3dm_gyro_bias v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_3dm_gyro_bias mip_3dm_gyro_bias_default(void) {
    struct mip_3dm_gyro_bias v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

struct mip_3dm_gyro_bias mip_3dm_gyro_bias_apply(const float bias[3]) {
    struct mip_3dm_gyro_bias v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_APPLY;
    memcpy(v.bias, bias, sizeof(v.bias));
    return v;
}

static void read_gyro_bias_response(struct mip_reader *r, void *value) {
    struct mip_3dm_gyro_bias_response *v = (struct mip_3dm_gyro_bias_response *)value;
    mip_read_float(r, v->bias, 3);
}

static void write_gyro_bias_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_gyro_bias_response *v = (const struct mip_3dm_gyro_bias_response *)value;
    mip_write_float(w, v->bias, 3);
}

const struct mip_codec mip_3dm_gyro_bias_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GYRO_BIAS_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_gyro_bias_response),
    0, /* time-out */
    read_gyro_bias_response,
    write_gyro_bias_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_gyro_bias_response_decode(struct mip_3dm_gyro_bias_response *value,
                                            const struct mip_field *field) {
    return mip_decode_field(field, read_gyro_bias_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_gyro_bias_response_encode(const struct mip_3dm_gyro_bias_response *value,
                                            struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GYRO_BIAS_RESPONSE_DESCRIPTOR,
                            write_gyro_bias_response, value);
}

static void read_capture_gyro_bias(struct mip_reader *r, void *value) {
    struct mip_3dm_capture_gyro_bias *v = (struct mip_3dm_capture_gyro_bias *)value;
    mip_read_u16(r, &v->averaging_time_ms, 1);
}

static void write_capture_gyro_bias(struct mip_writer *w, const void *value) {
    const struct mip_3dm_capture_gyro_bias *v = (const struct mip_3dm_capture_gyro_bias *)value;
    mip_write_u16(w, &v->averaging_time_ms, 1);
}

static const struct mip_response responses_capture_gyro_bias[] = {
    {&mip_3dm_gyro_bias_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_capture_gyro_bias_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_CAPTURE_GYRO_BIAS_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_capture_gyro_bias),
    31000, /* time-out */
    read_capture_gyro_bias,
    write_capture_gyro_bias,
    NULL,
    responses_capture_gyro_bias,
    NULL,
};

mip_error mip_3dm_capture_gyro_bias_decode(struct mip_3dm_capture_gyro_bias *value,
                                           const struct mip_field *field) {
    return mip_decode_field(field, read_capture_gyro_bias, value, sizeof(*value), NULL);
}

mip_error mip_3dm_capture_gyro_bias_encode(const struct mip_3dm_capture_gyro_bias *value,
                                           struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_CAPTURE_GYRO_BIAS_DESCRIPTOR,
                            write_capture_gyro_bias, value);
}

struct mip_3dm_capture_gyro_bias mip_3dm_capture_gyro_bias_make(uint16_t averaging_time_ms) {
    struct mip_3dm_capture_gyro_bias v;
    memset(&v, 0, sizeof(v));
    v.averaging_time_ms = averaging_time_ms;
    return v;
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_mag_hard_iron_offset[] = {0, 1, 0, 0, 0, 0, 1};

static void read_mag_hard_iron_offset(struct mip_reader *r, void *value) {
    struct mip_3dm_mag_hard_iron_offset *v = (struct mip_3dm_mag_hard_iron_offset *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_mag_hard_iron_offset,
                      sizeof(required_mag_hard_iron_offset));
    mip_read_group(r, 1, 1);
    mip_read_float(r, v->offset, 3);
    v->present = mip_read_present(r);
}

static void write_mag_hard_iron_offset(struct mip_writer *w, const void *value) {
    const struct mip_3dm_mag_hard_iron_offset *v =
        (const struct mip_3dm_mag_hard_iron_offset *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_mag_hard_iron_offset,
                       sizeof(required_mag_hard_iron_offset), v->present);
    mip_write_group(w, 1, 1);
    mip_write_float(w, v->offset, 3);
}

static bool silent_mag_hard_iron_offset(const void *value) {
    const struct mip_3dm_mag_hard_iron_offset *v =
        (const struct mip_3dm_mag_hard_iron_offset *)value;
    return v->function == MIP_FUNCTION_SELECTOR_APPLY;
}

static bool asked_mag_hard_iron_offset_1(const void *value) {
    const struct mip_3dm_mag_hard_iron_offset *v =
        (const struct mip_3dm_mag_hard_iron_offset *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_mag_hard_iron_offset[] = {
    {&mip_3dm_mag_hard_iron_offset_response_codec, asked_mag_hard_iron_offset_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_mag_hard_iron_offset_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_MAG_HARD_IRON_OFFSET_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_mag_hard_iron_offset),
    0, /* time-out */
    read_mag_hard_iron_offset,
    write_mag_hard_iron_offset,
    silent_mag_hard_iron_offset,
    responses_mag_hard_iron_offset,
    NULL,
};

mip_error mip_3dm_mag_hard_iron_offset_decode(struct mip_3dm_mag_hard_iron_offset *value,
                                              const struct mip_field *field) {
    return mip_decode_field(field, read_mag_hard_iron_offset, value, sizeof(*value), NULL);
}

mip_error mip_3dm_mag_hard_iron_offset_encode(const struct mip_3dm_mag_hard_iron_offset *value,
                                              struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_MAG_HARD_IRON_OFFSET_DESCRIPTOR,
                            write_mag_hard_iron_offset, value);
}

struct mip_3dm_mag_hard_iron_offset mip_3dm_mag_hard_iron_offset_write(const float offset[3]) {
    struct mip_3dm_mag_hard_iron_offset v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(v.offset, offset, sizeof(v.offset));
    return v;
}

struct mip_3dm_mag_hard_iron_offset mip_3dm_mag_hard_iron_offset_read(void) {
    struct mip_3dm_mag_hard_iron_offset v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_3dm_mag_hard_iron_offset mip_3dm_mag_hard_iron_offset_save(void) {
    struct mip_3dm_mag_hard_iron_offset v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_3dm_mag_hard_iron_offset mip_3dm_mag_hard_iron_offset_load(void) {
    struct mip_3dm_mag_hard_iron_offset v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_3dm_mag_hard_iron_offset mip_3dm_mag_hard_iron_offset_default(void) {
    struct mip_3dm_mag_hard_iron_offset v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

struct mip_3dm_mag_hard_iron_offset mip_3dm_mag_hard_iron_offset_apply(const float offset[3]) {
    struct mip_3dm_mag_hard_iron_offset v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_APPLY;
    memcpy(v.offset, offset, sizeof(v.offset));
    return v;
}

static void read_mag_hard_iron_offset_response(struct mip_reader *r, void *value) {
    struct mip_3dm_mag_hard_iron_offset_response *v =
        (struct mip_3dm_mag_hard_iron_offset_response *)value;
    mip_read_float(r, v->offset, 3);
}

static void write_mag_hard_iron_offset_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_mag_hard_iron_offset_response *v =
        (const struct mip_3dm_mag_hard_iron_offset_response *)value;
    mip_write_float(w, v->offset, 3);
}

const struct mip_codec mip_3dm_mag_hard_iron_offset_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_MAG_HARD_IRON_OFFSET_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_mag_hard_iron_offset_response),
    0, /* time-out */
    read_mag_hard_iron_offset_response,
    write_mag_hard_iron_offset_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_mag_hard_iron_offset_response_decode(
    struct mip_3dm_mag_hard_iron_offset_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_mag_hard_iron_offset_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_mag_hard_iron_offset_response_encode(
    const struct mip_3dm_mag_hard_iron_offset_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_MAG_HARD_IRON_OFFSET_RESPONSE_DESCRIPTOR,
                            write_mag_hard_iron_offset_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_mag_soft_iron_matrix[] = {0, 1, 0, 0, 0, 0, 1};

static void read_mag_soft_iron_matrix(struct mip_reader *r, void *value) {
    struct mip_3dm_mag_soft_iron_matrix *v = (struct mip_3dm_mag_soft_iron_matrix *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_mag_soft_iron_matrix,
                      sizeof(required_mag_soft_iron_matrix));
    mip_read_group(r, 1, 1);
    mip_read_float(r, v->matrix, 9);
    v->present = mip_read_present(r);
}

static void write_mag_soft_iron_matrix(struct mip_writer *w, const void *value) {
    const struct mip_3dm_mag_soft_iron_matrix *v =
        (const struct mip_3dm_mag_soft_iron_matrix *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_mag_soft_iron_matrix,
                       sizeof(required_mag_soft_iron_matrix), v->present);
    mip_write_group(w, 1, 1);
    mip_write_float(w, v->matrix, 9);
}

static bool silent_mag_soft_iron_matrix(const void *value) {
    const struct mip_3dm_mag_soft_iron_matrix *v =
        (const struct mip_3dm_mag_soft_iron_matrix *)value;
    return v->function == MIP_FUNCTION_SELECTOR_APPLY;
}

static bool asked_mag_soft_iron_matrix_1(const void *value) {
    const struct mip_3dm_mag_soft_iron_matrix *v =
        (const struct mip_3dm_mag_soft_iron_matrix *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_mag_soft_iron_matrix[] = {
    {&mip_3dm_mag_soft_iron_matrix_response_codec, asked_mag_soft_iron_matrix_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_mag_soft_iron_matrix_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_MAG_SOFT_IRON_MATRIX_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_mag_soft_iron_matrix),
    0, /* time-out */
    read_mag_soft_iron_matrix,
    write_mag_soft_iron_matrix,
    silent_mag_soft_iron_matrix,
    responses_mag_soft_iron_matrix,
    NULL,
};

mip_error mip_3dm_mag_soft_iron_matrix_decode(struct mip_3dm_mag_soft_iron_matrix *value,
                                              const struct mip_field *field) {
    return mip_decode_field(field, read_mag_soft_iron_matrix, value, sizeof(*value), NULL);
}

mip_error mip_3dm_mag_soft_iron_matrix_encode(const struct mip_3dm_mag_soft_iron_matrix *value,
                                              struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_MAG_SOFT_IRON_MATRIX_DESCRIPTOR,
                            write_mag_soft_iron_matrix, value);
}

struct mip_3dm_mag_soft_iron_matrix mip_3dm_mag_soft_iron_matrix_write(const float matrix[9]) {
    struct mip_3dm_mag_soft_iron_matrix v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(v.matrix, matrix, sizeof(v.matrix));
    return v;
}

struct mip_3dm_mag_soft_iron_matrix mip_3dm_mag_soft_iron_matrix_read(void) {
    struct mip_3dm_mag_soft_iron_matrix v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_3dm_mag_soft_iron_matrix mip_3dm_mag_soft_iron_matrix_save(void) {
    struct mip_3dm_mag_soft_iron_matrix v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_3dm_mag_soft_iron_matrix mip_3dm_mag_soft_iron_matrix_load(void) {
    struct mip_3dm_mag_soft_iron_matrix v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_3dm_mag_soft_iron_matrix mip_3dm_mag_soft_iron_matrix_default(void) {
    struct mip_3dm_mag_soft_iron_matrix v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

struct mip_3dm_mag_soft_iron_matrix mip_3dm_mag_soft_iron_matrix_apply(const float matrix[9]) {
    struct mip_3dm_mag_soft_iron_matrix v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_APPLY;
    memcpy(v.matrix, matrix, sizeof(v.matrix));
    return v;
}

static void read_mag_soft_iron_matrix_response(struct mip_reader *r, void *value) {
    struct mip_3dm_mag_soft_iron_matrix_response *v =
        (struct mip_3dm_mag_soft_iron_matrix_response *)value;
    mip_read_float(r, v->matrix, 9);
}

static void write_mag_soft_iron_matrix_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_mag_soft_iron_matrix_response *v =
        (const struct mip_3dm_mag_soft_iron_matrix_response *)value;
    mip_write_float(w, v->matrix, 9);
}

const struct mip_codec mip_3dm_mag_soft_iron_matrix_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_MAG_SOFT_IRON_MATRIX_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_mag_soft_iron_matrix_response),
    0, /* time-out */
    read_mag_soft_iron_matrix_response,
    write_mag_soft_iron_matrix_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_mag_soft_iron_matrix_response_decode(
    struct mip_3dm_mag_soft_iron_matrix_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_mag_soft_iron_matrix_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_mag_soft_iron_matrix_response_encode(
    const struct mip_3dm_mag_soft_iron_matrix_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_MAG_SOFT_IRON_MATRIX_RESPONSE_DESCRIPTOR,
                            write_mag_soft_iron_matrix_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_coning_sculling_enable[] = {0, 1, 0, 0, 0, 0};

static void read_coning_sculling_enable(struct mip_reader *r, void *value) {
    struct mip_3dm_coning_sculling_enable *v = (struct mip_3dm_coning_sculling_enable *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_coning_sculling_enable,
                      sizeof(required_coning_sculling_enable));
    mip_read_group(r, 1, 1);
    mip_read_bool(r, &v->enable, 1);
    v->present = mip_read_present(r);
}

static void write_coning_sculling_enable(struct mip_writer *w, const void *value) {
    const struct mip_3dm_coning_sculling_enable *v =
        (const struct mip_3dm_coning_sculling_enable *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_coning_sculling_enable,
                       sizeof(required_coning_sculling_enable), v->present);
    mip_write_group(w, 1, 1);
    mip_write_bool(w, &v->enable, 1);
}

static bool asked_coning_sculling_enable_1(const void *value) {
    const struct mip_3dm_coning_sculling_enable *v =
        (const struct mip_3dm_coning_sculling_enable *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_coning_sculling_enable[] = {
    {&mip_3dm_coning_sculling_enable_response_codec, asked_coning_sculling_enable_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_coning_sculling_enable_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_CONING_SCULLING_ENABLE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_coning_sculling_enable),
    0, /* time-out */
    read_coning_sculling_enable,
    write_coning_sculling_enable,
    NULL,
    responses_coning_sculling_enable,
    NULL,
};

mip_error mip_3dm_coning_sculling_enable_decode(struct mip_3dm_coning_sculling_enable *value,
                                                const struct mip_field *field) {
    return mip_decode_field(field, read_coning_sculling_enable, value, sizeof(*value), NULL);
}

mip_error mip_3dm_coning_sculling_enable_encode(const struct mip_3dm_coning_sculling_enable *value,
                                                struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_CONING_SCULLING_ENABLE_DESCRIPTOR,
                            write_coning_sculling_enable, value);
}

struct mip_3dm_coning_sculling_enable mip_3dm_coning_sculling_enable_write(mip_bool enable) {
    struct mip_3dm_coning_sculling_enable v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.enable = enable;
    return v;
}

struct mip_3dm_coning_sculling_enable mip_3dm_coning_sculling_enable_read(void) {
    struct mip_3dm_coning_sculling_enable v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_3dm_coning_sculling_enable mip_3dm_coning_sculling_enable_save(void) {
    struct mip_3dm_coning_sculling_enable v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_3dm_coning_sculling_enable mip_3dm_coning_sculling_enable_load(void) {
    struct mip_3dm_coning_sculling_enable v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_3dm_coning_sculling_enable mip_3dm_coning_sculling_enable_default(void) {
    struct mip_3dm_coning_sculling_enable v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_coning_sculling_enable_response(struct mip_reader *r, void *value) {
    struct mip_3dm_coning_sculling_enable_response *v =
        (struct mip_3dm_coning_sculling_enable_response *)value;
    mip_read_bool(r, &v->enable, 1);
}

static void write_coning_sculling_enable_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_coning_sculling_enable_response *v =
        (const struct mip_3dm_coning_sculling_enable_response *)value;
    mip_write_bool(w, &v->enable, 1);
}

const struct mip_codec mip_3dm_coning_sculling_enable_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_CONING_SCULLING_ENABLE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_coning_sculling_enable_response),
    0, /* time-out */
    read_coning_sculling_enable_response,
    write_coning_sculling_enable_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_coning_sculling_enable_response_decode(
    struct mip_3dm_coning_sculling_enable_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_coning_sculling_enable_response, value, sizeof(*value),
                            NULL);
}

mip_error mip_3dm_coning_sculling_enable_response_encode(
    const struct mip_3dm_coning_sculling_enable_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_CONING_SCULLING_ENABLE_RESPONSE_DESCRIPTOR,
                            write_coning_sculling_enable_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_uart_baud_rate[] = {0, 1, 0, 0, 0, 0};

static void read_uart_baud_rate(struct mip_reader *r, void *value) {
    struct mip_3dm_uart_baud_rate *v = (struct mip_3dm_uart_baud_rate *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_uart_baud_rate, sizeof(required_uart_baud_rate));
    mip_read_group(r, 1, 1);
    mip_read_u32(r, &v->baud, 1);
    v->present = mip_read_present(r);
}

static void write_uart_baud_rate(struct mip_writer *w, const void *value) {
    const struct mip_3dm_uart_baud_rate *v = (const struct mip_3dm_uart_baud_rate *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_uart_baud_rate, sizeof(required_uart_baud_rate),
                       v->present);
    mip_write_group(w, 1, 1);
    mip_write_u32(w, &v->baud, 1);
}

static bool asked_uart_baud_rate_1(const void *value) {
    const struct mip_3dm_uart_baud_rate *v = (const struct mip_3dm_uart_baud_rate *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_uart_baud_rate[] = {
    {&mip_3dm_uart_baud_rate_response_codec, asked_uart_baud_rate_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_uart_baud_rate_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_UART_BAUD_RATE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_uart_baud_rate),
    0, /* time-out */
    read_uart_baud_rate,
    write_uart_baud_rate,
    NULL,
    responses_uart_baud_rate,
    NULL,
};

mip_error mip_3dm_uart_baud_rate_decode(struct mip_3dm_uart_baud_rate *value,
                                        const struct mip_field *field) {
    return mip_decode_field(field, read_uart_baud_rate, value, sizeof(*value), NULL);
}

mip_error mip_3dm_uart_baud_rate_encode(const struct mip_3dm_uart_baud_rate *value,
                                        struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_UART_BAUD_RATE_DESCRIPTOR, write_uart_baud_rate,
                            value);
}

struct mip_3dm_uart_baud_rate mip_3dm_uart_baud_rate_write(uint32_t baud) {
    struct mip_3dm_uart_baud_rate v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.baud = baud;
    return v;
}

struct mip_3dm_uart_baud_rate mip_3dm_uart_baud_rate_read(void) {
    struct mip_3dm_uart_baud_rate v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_3dm_uart_baud_rate mip_3dm_uart_baud_rate_save(void) {
    struct mip_3dm_uart_baud_rate v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_3dm_uart_baud_rate mip_3dm_uart_baud_rate_load(void) {
    struct mip_3dm_uart_baud_rate v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_3dm_uart_baud_rate mip_3dm_uart_baud_rate_default(void) {
    struct mip_3dm_uart_baud_rate v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_uart_baud_rate_response(struct mip_reader *r, void *value) {
    struct mip_3dm_uart_baud_rate_response *v = (struct mip_3dm_uart_baud_rate_response *)value;
    mip_read_u32(r, &v->baud, 1);
}

static void write_uart_baud_rate_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_uart_baud_rate_response *v =
        (const struct mip_3dm_uart_baud_rate_response *)value;
    mip_write_u32(w, &v->baud, 1);
}

const struct mip_codec mip_3dm_uart_baud_rate_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_UART_BAUD_RATE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_uart_baud_rate_response),
    0, /* time-out */
    read_uart_baud_rate_response,
    write_uart_baud_rate_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_uart_baud_rate_response_decode(struct mip_3dm_uart_baud_rate_response *value,
                                                 const struct mip_field *field) {
    return mip_decode_field(field, read_uart_baud_rate_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_uart_baud_rate_response_encode(
    const struct mip_3dm_uart_baud_rate_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_UART_BAUD_RATE_RESPONSE_DESCRIPTOR,
                            write_uart_baud_rate_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_gpio_config[] = {0, 4, 1, 1, 1, 1};

static void read_gpio_config(struct mip_reader *r, void *value) {
    struct mip_3dm_gpio_config *v = (struct mip_3dm_gpio_config *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_gpio_config, sizeof(required_gpio_config));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->pin, 1);
    mip_read_group(r, 2, 2);
    mip_read_u8(r, &v->feature, 1);
    mip_read_group(r, 3, 3);
    mip_read_u8(r, &v->behavior, 1);
    mip_read_group(r, 4, 4);
    mip_read_u8(r, &v->pin_mode, 1);
    v->present = mip_read_present(r);
}

static void write_gpio_config(struct mip_writer *w, const void *value) {
    const struct mip_3dm_gpio_config *v = (const struct mip_3dm_gpio_config *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_gpio_config, sizeof(required_gpio_config),
                       v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->pin, 1);
    mip_write_group(w, 2, 2);
    mip_write_u8(w, &v->feature, 1);
    mip_write_group(w, 3, 3);
    mip_write_u8(w, &v->behavior, 1);
    mip_write_group(w, 4, 4);
    mip_write_u8(w, &v->pin_mode, 1);
}

static bool asked_gpio_config_1(const void *value) {
    const struct mip_3dm_gpio_config *v = (const struct mip_3dm_gpio_config *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_gpio_config[] = {
    {&mip_3dm_gpio_config_response_codec, asked_gpio_config_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_gpio_config_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GPIO_CONFIG_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_gpio_config),
    0, /* time-out */
    read_gpio_config,
    write_gpio_config,
    NULL,
    responses_gpio_config,
    NULL,
};

mip_error mip_3dm_gpio_config_decode(struct mip_3dm_gpio_config *value,
                                     const struct mip_field *field) {
    return mip_decode_field(field, read_gpio_config, value, sizeof(*value), NULL);
}

mip_error mip_3dm_gpio_config_encode(const struct mip_3dm_gpio_config *value,
                                     struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GPIO_CONFIG_DESCRIPTOR, write_gpio_config,
                            value);
}

struct mip_3dm_gpio_config mip_3dm_gpio_config_write(uint8_t pin, mip_gpio_feature feature,
                                                     uint8_t behavior, mip_gpio_pin_mode pin_mode) {
    struct mip_3dm_gpio_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.pin = pin;
    v.feature = feature;
    v.behavior = behavior;
    v.pin_mode = pin_mode;
    return v;
}

struct mip_3dm_gpio_config mip_3dm_gpio_config_read(uint8_t pin) {
    struct mip_3dm_gpio_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    v.pin = pin;
    return v;
}

struct mip_3dm_gpio_config mip_3dm_gpio_config_save(uint8_t pin) {
    struct mip_3dm_gpio_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    v.pin = pin;
    return v;
}

struct mip_3dm_gpio_config mip_3dm_gpio_config_load(uint8_t pin) {
    struct mip_3dm_gpio_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    v.pin = pin;
    return v;
}

struct mip_3dm_gpio_config mip_3dm_gpio_config_default(uint8_t pin) {
    struct mip_3dm_gpio_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    v.pin = pin;
    return v;
}

static void read_gpio_config_response(struct mip_reader *r, void *value) {
    struct mip_3dm_gpio_config_response *v = (struct mip_3dm_gpio_config_response *)value;
    mip_read_u8(r, &v->pin, 1);
    mip_read_u8(r, &v->feature, 1);
    mip_read_u8(r, &v->behavior, 1);
    mip_read_u8(r, &v->pin_mode, 1);
}

static void write_gpio_config_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_gpio_config_response *v =
        (const struct mip_3dm_gpio_config_response *)value;
    mip_write_u8(w, &v->pin, 1);
    mip_write_u8(w, &v->feature, 1);
    mip_write_u8(w, &v->behavior, 1);
    mip_write_u8(w, &v->pin_mode, 1);
}

const struct mip_codec mip_3dm_gpio_config_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GPIO_CONFIG_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_gpio_config_response),
    0, /* time-out */
    read_gpio_config_response,
    write_gpio_config_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_gpio_config_response_decode(struct mip_3dm_gpio_config_response *value,
                                              const struct mip_field *field) {
    return mip_decode_field(field, read_gpio_config_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_gpio_config_response_encode(const struct mip_3dm_gpio_config_response *value,
                                              struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GPIO_CONFIG_RESPONSE_DESCRIPTOR,
                            write_gpio_config_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_gpio_state[] = {0, 2, 1};

static void read_gpio_state(struct mip_reader *r, void *value) {
    struct mip_3dm_gpio_state *v = (struct mip_3dm_gpio_state *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_gpio_state, sizeof(required_gpio_state));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->pin, 1);
    mip_read_group(r, 2, 2);
    mip_read_bool(r, &v->state, 1);
    v->present = mip_read_present(r);
}

static void write_gpio_state(struct mip_writer *w, const void *value) {
    const struct mip_3dm_gpio_state *v = (const struct mip_3dm_gpio_state *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_gpio_state, sizeof(required_gpio_state),
                       v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->pin, 1);
    mip_write_group(w, 2, 2);
    mip_write_bool(w, &v->state, 1);
}

static bool asked_gpio_state_1(const void *value) {
    const struct mip_3dm_gpio_state *v = (const struct mip_3dm_gpio_state *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_gpio_state[] = {
    {&mip_3dm_gpio_state_response_codec, asked_gpio_state_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_gpio_state_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GPIO_STATE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_gpio_state),
    0, /* time-out */
    read_gpio_state,
    write_gpio_state,
    NULL,
    responses_gpio_state,
    NULL,
};

mip_error mip_3dm_gpio_state_decode(struct mip_3dm_gpio_state *value,
                                    const struct mip_field *field) {
    return mip_decode_field(field, read_gpio_state, value, sizeof(*value), NULL);
}

mip_error mip_3dm_gpio_state_encode(const struct mip_3dm_gpio_state *value,
                                    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GPIO_STATE_DESCRIPTOR, write_gpio_state, value);
}

struct mip_3dm_gpio_state mip_3dm_gpio_state_write(uint8_t pin, mip_bool state) {
    struct mip_3dm_gpio_state v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.pin = pin;
    v.state = state;
    return v;
}

struct mip_3dm_gpio_state mip_3dm_gpio_state_read(uint8_t pin) {
    struct mip_3dm_gpio_state v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    v.pin = pin;
    return v;
}

static void read_gpio_state_response(struct mip_reader *r, void *value) {
    struct mip_3dm_gpio_state_response *v = (struct mip_3dm_gpio_state_response *)value;
    mip_read_u8(r, &v->pin, 1);
    mip_read_bool(r, &v->state, 1);
}

static void write_gpio_state_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_gpio_state_response *v = (const struct mip_3dm_gpio_state_response *)value;
    mip_write_u8(w, &v->pin, 1);
    mip_write_bool(w, &v->state, 1);
}

const struct mip_codec mip_3dm_gpio_state_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GPIO_STATE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_gpio_state_response),
    0, /* time-out */
    read_gpio_state_response,
    write_gpio_state_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_gpio_state_response_decode(struct mip_3dm_gpio_state_response *value,
                                             const struct mip_field *field) {
    return mip_decode_field(field, read_gpio_state_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_gpio_state_response_encode(const struct mip_3dm_gpio_state_response *value,
                                             struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GPIO_STATE_RESPONSE_DESCRIPTOR,
                            write_gpio_state_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_odometer_config[] = {0, 3, 0, 0, 0, 0};

static void read_odometer_config(struct mip_reader *r, void *value) {
    struct mip_3dm_odometer_config *v = (struct mip_3dm_odometer_config *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_odometer_config, sizeof(required_odometer_config));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->mode, 1);
    mip_read_group(r, 2, 2);
    mip_read_float(r, &v->scaling, 1);
    mip_read_group(r, 3, 3);
    mip_read_float(r, &v->uncertainty, 1);
    v->present = mip_read_present(r);
}

static void write_odometer_config(struct mip_writer *w, const void *value) {
    const struct mip_3dm_odometer_config *v = (const struct mip_3dm_odometer_config *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_odometer_config, sizeof(required_odometer_config),
                       v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->mode, 1);
    mip_write_group(w, 2, 2);
    mip_write_float(w, &v->scaling, 1);
    mip_write_group(w, 3, 3);
    mip_write_float(w, &v->uncertainty, 1);
}

static bool asked_odometer_config_1(const void *value) {
    const struct mip_3dm_odometer_config *v = (const struct mip_3dm_odometer_config *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_odometer_config[] = {
    {&mip_3dm_odometer_config_response_codec, asked_odometer_config_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_odometer_config_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_ODOMETER_CONFIG_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_odometer_config),
    0, /* time-out */
    read_odometer_config,
    write_odometer_config,
    NULL,
    responses_odometer_config,
    NULL,
};

mip_error mip_3dm_odometer_config_decode(struct mip_3dm_odometer_config *value,
                                         const struct mip_field *field) {
    return mip_decode_field(field, read_odometer_config, value, sizeof(*value), NULL);
}

mip_error mip_3dm_odometer_config_encode(const struct mip_3dm_odometer_config *value,
                                         struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_ODOMETER_CONFIG_DESCRIPTOR,
                            write_odometer_config, value);
}

struct mip_3dm_odometer_config mip_3dm_odometer_config_write(mip_3dm_odometer_mode mode,
                                                             float scaling, float uncertainty) {
    struct mip_3dm_odometer_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.mode = mode;
    v.scaling = scaling;
    v.uncertainty = uncertainty;
    return v;
}

struct mip_3dm_odometer_config mip_3dm_odometer_config_read(void) {
    struct mip_3dm_odometer_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_3dm_odometer_config mip_3dm_odometer_config_save(void) {
    struct mip_3dm_odometer_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_3dm_odometer_config mip_3dm_odometer_config_load(void) {
    struct mip_3dm_odometer_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_3dm_odometer_config mip_3dm_odometer_config_default(void) {
    struct mip_3dm_odometer_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_odometer_config_response(struct mip_reader *r, void *value) {
    struct mip_3dm_odometer_config_response *v = (struct mip_3dm_odometer_config_response *)value;
    mip_read_u8(r, &v->mode, 1);
    mip_read_float(r, &v->scaling, 1);
    mip_read_float(r, &v->uncertainty, 1);
}

static void write_odometer_config_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_odometer_config_response *v =
        (const struct mip_3dm_odometer_config_response *)value;
    mip_write_u8(w, &v->mode, 1);
    mip_write_float(w, &v->scaling, 1);
    mip_write_float(w, &v->uncertainty, 1);
}

const struct mip_codec mip_3dm_odometer_config_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_ODOMETER_CONFIG_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_odometer_config_response),
    0, /* time-out */
    read_odometer_config_response,
    write_odometer_config_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_odometer_config_response_decode(struct mip_3dm_odometer_config_response *value,
                                                  const struct mip_field *field) {
    return mip_decode_field(field, read_odometer_config_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_odometer_config_response_encode(
    const struct mip_3dm_odometer_config_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_ODOMETER_CONFIG_RESPONSE_DESCRIPTOR,
                            write_odometer_config_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_imu_low_pass_filter[] = {0, 5, 1, 1, 1, 1};

static void read_imu_low_pass_filter(struct mip_reader *r, void *value) {
    struct mip_3dm_imu_low_pass_filter *v = (struct mip_3dm_imu_low_pass_filter *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_imu_low_pass_filter,
                      sizeof(required_imu_low_pass_filter));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->target_descriptor, 1);
    mip_read_group(r, 2, 2);
    mip_read_bool(r, &v->enable, 1);
    mip_read_group(r, 3, 3);
    mip_read_bool(r, &v->manual, 1);
    mip_read_group(r, 4, 4);
    mip_read_u16(r, &v->frequency, 1);
    mip_read_group(r, 5, 5);
    mip_read_u8(r, &v->reserved, 1);
    v->present = mip_read_present(r);
}

static void write_imu_low_pass_filter(struct mip_writer *w, const void *value) {
    const struct mip_3dm_imu_low_pass_filter *v = (const struct mip_3dm_imu_low_pass_filter *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_imu_low_pass_filter,
                       sizeof(required_imu_low_pass_filter), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->target_descriptor, 1);
    mip_write_group(w, 2, 2);
    mip_write_bool(w, &v->enable, 1);
    mip_write_group(w, 3, 3);
    mip_write_bool(w, &v->manual, 1);
    mip_write_group(w, 4, 4);
    mip_write_u16(w, &v->frequency, 1);
    mip_write_group(w, 5, 5);
    mip_write_u8(w, &v->reserved, 1);
}

static bool asked_imu_low_pass_filter_1(const void *value) {
    const struct mip_3dm_imu_low_pass_filter *v = (const struct mip_3dm_imu_low_pass_filter *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_imu_low_pass_filter[] = {
    {&mip_3dm_imu_low_pass_filter_response_codec, asked_imu_low_pass_filter_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_imu_low_pass_filter_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_IMU_LOW_PASS_FILTER_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_imu_low_pass_filter),
    0, /* time-out */
    read_imu_low_pass_filter,
    write_imu_low_pass_filter,
    NULL,
    responses_imu_low_pass_filter,
    NULL,
};

mip_error mip_3dm_imu_low_pass_filter_decode(struct mip_3dm_imu_low_pass_filter *value,
                                             const struct mip_field *field) {
    return mip_decode_field(field, read_imu_low_pass_filter, value, sizeof(*value), NULL);
}

mip_error mip_3dm_imu_low_pass_filter_encode(const struct mip_3dm_imu_low_pass_filter *value,
                                             struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_IMU_LOW_PASS_FILTER_DESCRIPTOR,
                            write_imu_low_pass_filter, value);
}

struct mip_3dm_imu_low_pass_filter mip_3dm_imu_low_pass_filter_write(uint8_t target_descriptor,
                                                                     mip_bool enable,
                                                                     mip_bool manual,
                                                                     uint16_t frequency) {
    struct mip_3dm_imu_low_pass_filter v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.target_descriptor = target_descriptor;
    v.enable = enable;
    v.manual = manual;
    v.frequency = frequency;
    return v;
}

struct mip_3dm_imu_low_pass_filter mip_3dm_imu_low_pass_filter_read(uint8_t target_descriptor) {
    struct mip_3dm_imu_low_pass_filter v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    v.target_descriptor = target_descriptor;
    return v;
}

struct mip_3dm_imu_low_pass_filter mip_3dm_imu_low_pass_filter_save(uint8_t target_descriptor) {
    struct mip_3dm_imu_low_pass_filter v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    v.target_descriptor = target_descriptor;
    return v;
}

struct mip_3dm_imu_low_pass_filter mip_3dm_imu_low_pass_filter_load(uint8_t target_descriptor) {
    struct mip_3dm_imu_low_pass_filter v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    v.target_descriptor = target_descriptor;
    return v;
}

struct mip_3dm_imu_low_pass_filter mip_3dm_imu_low_pass_filter_default(uint8_t target_descriptor) {
    struct mip_3dm_imu_low_pass_filter v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    v.target_descriptor = target_descriptor;
    return v;
}

static void read_imu_low_pass_filter_response(struct mip_reader *r, void *value) {
    struct mip_3dm_imu_low_pass_filter_response *v =
        (struct mip_3dm_imu_low_pass_filter_response *)value;
    mip_read_u8(r, &v->target_descriptor, 1);
    mip_read_bool(r, &v->enable, 1);
    mip_read_bool(r, &v->manual, 1);
    mip_read_u16(r, &v->frequency, 1);
    mip_read_u8(r, &v->reserved, 1);
}

static void write_imu_low_pass_filter_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_imu_low_pass_filter_response *v =
        (const struct mip_3dm_imu_low_pass_filter_response *)value;
    mip_write_u8(w, &v->target_descriptor, 1);
    mip_write_bool(w, &v->enable, 1);
    mip_write_bool(w, &v->manual, 1);
    mip_write_u16(w, &v->frequency, 1);
    mip_write_u8(w, &v->reserved, 1);
}

const struct mip_codec mip_3dm_imu_low_pass_filter_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_IMU_LOW_PASS_FILTER_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_imu_low_pass_filter_response),
    0, /* time-out */
    read_imu_low_pass_filter_response,
    write_imu_low_pass_filter_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_imu_low_pass_filter_response_decode(
    struct mip_3dm_imu_low_pass_filter_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_imu_low_pass_filter_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_imu_low_pass_filter_response_encode(
    const struct mip_3dm_imu_low_pass_filter_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_IMU_LOW_PASS_FILTER_RESPONSE_DESCRIPTOR,
                            write_imu_low_pass_filter_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_complementary_filter[] = {0, 4, 0, 0, 0, 0};

static void read_complementary_filter(struct mip_reader *r, void *value) {
    struct mip_3dm_complementary_filter *v = (struct mip_3dm_complementary_filter *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_complementary_filter,
                      sizeof(required_complementary_filter));
    mip_read_group(r, 1, 1);
    mip_read_bool(r, &v->pitch_roll_enable, 1);
    mip_read_group(r, 2, 2);
    mip_read_bool(r, &v->heading_enable, 1);
    mip_read_group(r, 3, 3);
    mip_read_float(r, &v->pitch_roll_time_constant, 1);
    mip_read_group(r, 4, 4);
    mip_read_float(r, &v->heading_time_constant, 1);
    v->present = mip_read_present(r);
}

static void write_complementary_filter(struct mip_writer *w, const void *value) {
    const struct mip_3dm_complementary_filter *v =
        (const struct mip_3dm_complementary_filter *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_complementary_filter,
                       sizeof(required_complementary_filter), v->present);
    mip_write_group(w, 1, 1);
    mip_write_bool(w, &v->pitch_roll_enable, 1);
    mip_write_group(w, 2, 2);
    mip_write_bool(w, &v->heading_enable, 1);
    mip_write_group(w, 3, 3);
    mip_write_float(w, &v->pitch_roll_time_constant, 1);
    mip_write_group(w, 4, 4);
    mip_write_float(w, &v->heading_time_constant, 1);
}

static bool asked_complementary_filter_1(const void *value) {
    const struct mip_3dm_complementary_filter *v =
        (const struct mip_3dm_complementary_filter *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_complementary_filter[] = {
    {&mip_3dm_complementary_filter_response_codec, asked_complementary_filter_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_complementary_filter_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_COMPLEMENTARY_FILTER_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_complementary_filter),
    0, /* time-out */
    read_complementary_filter,
    write_complementary_filter,
    NULL,
    responses_complementary_filter,
    NULL,
};

mip_error mip_3dm_complementary_filter_decode(struct mip_3dm_complementary_filter *value,
                                              const struct mip_field *field) {
    return mip_decode_field(field, read_complementary_filter, value, sizeof(*value), NULL);
}

mip_error mip_3dm_complementary_filter_encode(const struct mip_3dm_complementary_filter *value,
                                              struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_COMPLEMENTARY_FILTER_DESCRIPTOR,
                            write_complementary_filter, value);
}

struct mip_3dm_complementary_filter
mip_3dm_complementary_filter_write(mip_bool pitch_roll_enable, mip_bool heading_enable,
                                   float pitch_roll_time_constant, float heading_time_constant) {
    struct mip_3dm_complementary_filter v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.pitch_roll_enable = pitch_roll_enable;
    v.heading_enable = heading_enable;
    v.pitch_roll_time_constant = pitch_roll_time_constant;
    v.heading_time_constant = heading_time_constant;
    return v;
}

struct mip_3dm_complementary_filter mip_3dm_complementary_filter_read(void) {
    struct mip_3dm_complementary_filter v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_3dm_complementary_filter mip_3dm_complementary_filter_save(void) {
    struct mip_3dm_complementary_filter v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_3dm_complementary_filter mip_3dm_complementary_filter_load(void) {
    struct mip_3dm_complementary_filter v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_3dm_complementary_filter mip_3dm_complementary_filter_default(void) {
    struct mip_3dm_complementary_filter v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_complementary_filter_response(struct mip_reader *r, void *value) {
    struct mip_3dm_complementary_filter_response *v =
        (struct mip_3dm_complementary_filter_response *)value;
    mip_read_bool(r, &v->pitch_roll_enable, 1);
    mip_read_bool(r, &v->heading_enable, 1);
    mip_read_float(r, &v->pitch_roll_time_constant, 1);
    mip_read_float(r, &v->heading_time_constant, 1);
}

static void write_complementary_filter_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_complementary_filter_response *v =
        (const struct mip_3dm_complementary_filter_response *)value;
    mip_write_bool(w, &v->pitch_roll_enable, 1);
    mip_write_bool(w, &v->heading_enable, 1);
    mip_write_float(w, &v->pitch_roll_time_constant, 1);
    mip_write_float(w, &v->heading_time_constant, 1);
}

const struct mip_codec mip_3dm_complementary_filter_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_COMPLEMENTARY_FILTER_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_complementary_filter_response),
    0, /* time-out */
    read_complementary_filter_response,
    write_complementary_filter_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_complementary_filter_response_decode(
    struct mip_3dm_complementary_filter_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_complementary_filter_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_complementary_filter_response_encode(
    const struct mip_3dm_complementary_filter_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_COMPLEMENTARY_FILTER_RESPONSE_DESCRIPTOR,
                            write_complementary_filter_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_sensor_range[] = {0, 2, 1, 1, 1, 1};

static void read_sensor_range(struct mip_reader *r, void *value) {
    struct mip_3dm_sensor_range *v = (struct mip_3dm_sensor_range *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_sensor_range, sizeof(required_sensor_range));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->sensor, 1);
    mip_read_group(r, 2, 2);
    mip_read_u8(r, &v->setting, 1);
    v->present = mip_read_present(r);
}

static void write_sensor_range(struct mip_writer *w, const void *value) {
    const struct mip_3dm_sensor_range *v = (const struct mip_3dm_sensor_range *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_sensor_range, sizeof(required_sensor_range),
                       v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->sensor, 1);
    mip_write_group(w, 2, 2);
    mip_write_u8(w, &v->setting, 1);
}

static bool asked_sensor_range_1(const void *value) {
    const struct mip_3dm_sensor_range *v = (const struct mip_3dm_sensor_range *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_sensor_range[] = {
    {&mip_3dm_sensor_range_response_codec, asked_sensor_range_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_sensor_range_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_SENSOR_RANGE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_sensor_range),
    0, /* time-out */
    read_sensor_range,
    write_sensor_range,
    NULL,
    responses_sensor_range,
    NULL,
};

mip_error mip_3dm_sensor_range_decode(struct mip_3dm_sensor_range *value,
                                      const struct mip_field *field) {
    return mip_decode_field(field, read_sensor_range, value, sizeof(*value), NULL);
}

mip_error mip_3dm_sensor_range_encode(const struct mip_3dm_sensor_range *value,
                                      struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_SENSOR_RANGE_DESCRIPTOR, write_sensor_range,
                            value);
}

struct mip_3dm_sensor_range mip_3dm_sensor_range_write(mip_3dm_sensor_range_type sensor,
                                                       uint8_t setting) {
    struct mip_3dm_sensor_range v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.sensor = sensor;
    v.setting = setting;
    return v;
}

struct mip_3dm_sensor_range mip_3dm_sensor_range_read(mip_3dm_sensor_range_type sensor) {
    struct mip_3dm_sensor_range v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    v.sensor = sensor;
    return v;
}

struct mip_3dm_sensor_range mip_3dm_sensor_range_save(mip_3dm_sensor_range_type sensor) {
    struct mip_3dm_sensor_range v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    v.sensor = sensor;
    return v;
}

struct mip_3dm_sensor_range mip_3dm_sensor_range_load(mip_3dm_sensor_range_type sensor) {
    struct mip_3dm_sensor_range v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    v.sensor = sensor;
    return v;
}

struct mip_3dm_sensor_range mip_3dm_sensor_range_default(mip_3dm_sensor_range_type sensor) {
    struct mip_3dm_sensor_range v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    v.sensor = sensor;
    return v;
}

static void read_sensor_range_response(struct mip_reader *r, void *value) {
    struct mip_3dm_sensor_range_response *v = (struct mip_3dm_sensor_range_response *)value;
    mip_read_u8(r, &v->sensor, 1);
    mip_read_u8(r, &v->setting, 1);
}

static void write_sensor_range_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_sensor_range_response *v =
        (const struct mip_3dm_sensor_range_response *)value;
    mip_write_u8(w, &v->sensor, 1);
    mip_write_u8(w, &v->setting, 1);
}

const struct mip_codec mip_3dm_sensor_range_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_SENSOR_RANGE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_sensor_range_response),
    0, /* time-out */
    read_sensor_range_response,
    write_sensor_range_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_sensor_range_response_decode(struct mip_3dm_sensor_range_response *value,
                                               const struct mip_field *field) {
    return mip_decode_field(field, read_sensor_range_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_sensor_range_response_encode(const struct mip_3dm_sensor_range_response *value,
                                               struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_SENSOR_RANGE_RESPONSE_DESCRIPTOR,
                            write_sensor_range_response, value);
}

static void read_get_calibrated_sensor_ranges(struct mip_reader *r, void *value) {
    struct mip_3dm_get_calibrated_sensor_ranges *v =
        (struct mip_3dm_get_calibrated_sensor_ranges *)value;
    mip_read_u8(r, &v->sensor, 1);
}

static void write_get_calibrated_sensor_ranges(struct mip_writer *w, const void *value) {
    const struct mip_3dm_get_calibrated_sensor_ranges *v =
        (const struct mip_3dm_get_calibrated_sensor_ranges *)value;
    mip_write_u8(w, &v->sensor, 1);
}

static const struct mip_response responses_get_calibrated_sensor_ranges[] = {
    {&mip_3dm_get_calibrated_sensor_ranges_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_get_calibrated_sensor_ranges_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GET_CALIBRATED_SENSOR_RANGES_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_get_calibrated_sensor_ranges),
    0, /* time-out */
    read_get_calibrated_sensor_ranges,
    write_get_calibrated_sensor_ranges,
    NULL,
    responses_get_calibrated_sensor_ranges,
    NULL,
};

mip_error mip_3dm_get_calibrated_sensor_ranges_decode(
    struct mip_3dm_get_calibrated_sensor_ranges *value, const struct mip_field *field) {
    return mip_decode_field(field, read_get_calibrated_sensor_ranges, value, sizeof(*value), NULL);
}

mip_error mip_3dm_get_calibrated_sensor_ranges_encode(
    const struct mip_3dm_get_calibrated_sensor_ranges *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GET_CALIBRATED_SENSOR_RANGES_DESCRIPTOR,
                            write_get_calibrated_sensor_ranges, value);
}

struct mip_3dm_get_calibrated_sensor_ranges
mip_3dm_get_calibrated_sensor_ranges_make(mip_3dm_sensor_range_type sensor) {
    struct mip_3dm_get_calibrated_sensor_ranges v;
    memset(&v, 0, sizeof(v));
    v.sensor = sensor;
    return v;
}

static void read_get_calibrated_sensor_ranges_response(struct mip_reader *r, void *value) {
    struct mip_3dm_get_calibrated_sensor_ranges_response *v =
        (struct mip_3dm_get_calibrated_sensor_ranges_response *)value;
    mip_read_u8(r, &v->sensor, 1);
    mip_read_u8(r, &v->num_ranges, 1);
    for (size_t i = 0, n = mip_read_count(r, v->num_ranges, 50, 5); i < n; i++) {
        mip_3dm_sensor_range_entry_read(r, &v->ranges[i]);
    }
}

static void write_get_calibrated_sensor_ranges_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_get_calibrated_sensor_ranges_response *v =
        (const struct mip_3dm_get_calibrated_sensor_ranges_response *)value;
    mip_write_u8(w, &v->sensor, 1);
    mip_write_u8(w, &v->num_ranges, 1);
    for (size_t i = 0, n = mip_write_count(w, v->num_ranges, 50); i < n; i++) {
        mip_3dm_sensor_range_entry_write(w, &v->ranges[i]);
    }
}

const struct mip_codec mip_3dm_get_calibrated_sensor_ranges_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_GET_CALIBRATED_SENSOR_RANGES_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_get_calibrated_sensor_ranges_response),
    0, /* time-out */
    read_get_calibrated_sensor_ranges_response,
    write_get_calibrated_sensor_ranges_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_get_calibrated_sensor_ranges_response_decode(
    struct mip_3dm_get_calibrated_sensor_ranges_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_get_calibrated_sensor_ranges_response, value,
                            sizeof(*value), NULL);
}

mip_error mip_3dm_get_calibrated_sensor_ranges_response_encode(
    const struct mip_3dm_get_calibrated_sensor_ranges_response *value,
    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_GET_CALIBRATED_SENSOR_RANGES_RESPONSE_DESCRIPTOR,
                            write_get_calibrated_sensor_ranges_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_low_pass_filter[] = {0, 5, 2, 2, 2, 2};

static void read_low_pass_filter(struct mip_reader *r, void *value) {
    struct mip_3dm_low_pass_filter *v = (struct mip_3dm_low_pass_filter *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_low_pass_filter, sizeof(required_low_pass_filter));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->descriptor_set, 1);
    mip_read_group(r, 2, 2);
    mip_read_u8(r, &v->field_descriptor, 1);
    mip_read_group(r, 3, 3);
    mip_read_bool(r, &v->enable, 1);
    mip_read_group(r, 4, 4);
    mip_read_bool(r, &v->manual, 1);
    mip_read_group(r, 5, 5);
    mip_read_float(r, &v->frequency, 1);
    v->present = mip_read_present(r);
}

static void write_low_pass_filter(struct mip_writer *w, const void *value) {
    const struct mip_3dm_low_pass_filter *v = (const struct mip_3dm_low_pass_filter *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_low_pass_filter, sizeof(required_low_pass_filter),
                       v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->descriptor_set, 1);
    mip_write_group(w, 2, 2);
    mip_write_u8(w, &v->field_descriptor, 1);
    mip_write_group(w, 3, 3);
    mip_write_bool(w, &v->enable, 1);
    mip_write_group(w, 4, 4);
    mip_write_bool(w, &v->manual, 1);
    mip_write_group(w, 5, 5);
    mip_write_float(w, &v->frequency, 1);
}

static bool asked_low_pass_filter_1(const void *value) {
    const struct mip_3dm_low_pass_filter *v = (const struct mip_3dm_low_pass_filter *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_low_pass_filter[] = {
    {&mip_3dm_low_pass_filter_response_codec, asked_low_pass_filter_1},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_low_pass_filter_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_LOW_PASS_FILTER_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_low_pass_filter),
    0, /* time-out */
    read_low_pass_filter,
    write_low_pass_filter,
    NULL,
    responses_low_pass_filter,
    NULL,
};

mip_error mip_3dm_low_pass_filter_decode(struct mip_3dm_low_pass_filter *value,
                                         const struct mip_field *field) {
    return mip_decode_field(field, read_low_pass_filter, value, sizeof(*value), NULL);
}

mip_error mip_3dm_low_pass_filter_encode(const struct mip_3dm_low_pass_filter *value,
                                         struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_LOW_PASS_FILTER_DESCRIPTOR,
                            write_low_pass_filter, value);
}

struct mip_3dm_low_pass_filter mip_3dm_low_pass_filter_write(uint8_t descriptor_set,
                                                             uint8_t field_descriptor,
                                                             mip_bool enable, mip_bool manual,
                                                             float frequency) {
    struct mip_3dm_low_pass_filter v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.descriptor_set = descriptor_set;
    v.field_descriptor = field_descriptor;
    v.enable = enable;
    v.manual = manual;
    v.frequency = frequency;
    return v;
}

struct mip_3dm_low_pass_filter mip_3dm_low_pass_filter_read(uint8_t descriptor_set,
                                                            uint8_t field_descriptor) {
    struct mip_3dm_low_pass_filter v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    v.descriptor_set = descriptor_set;
    v.field_descriptor = field_descriptor;
    return v;
}

struct mip_3dm_low_pass_filter mip_3dm_low_pass_filter_save(uint8_t descriptor_set,
                                                            uint8_t field_descriptor) {
    struct mip_3dm_low_pass_filter v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    v.descriptor_set = descriptor_set;
    v.field_descriptor = field_descriptor;
    return v;
}

struct mip_3dm_low_pass_filter mip_3dm_low_pass_filter_load(uint8_t descriptor_set,
                                                            uint8_t field_descriptor) {
    struct mip_3dm_low_pass_filter v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    v.descriptor_set = descriptor_set;
    v.field_descriptor = field_descriptor;
    return v;
}

struct mip_3dm_low_pass_filter mip_3dm_low_pass_filter_default(uint8_t descriptor_set,
                                                               uint8_t field_descriptor) {
    struct mip_3dm_low_pass_filter v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    v.descriptor_set = descriptor_set;
    v.field_descriptor = field_descriptor;
    return v;
}

static void read_low_pass_filter_response(struct mip_reader *r, void *value) {
    struct mip_3dm_low_pass_filter_response *v = (struct mip_3dm_low_pass_filter_response *)value;
    mip_read_u8(r, &v->descriptor_set, 1);
    mip_read_u8(r, &v->field_descriptor, 1);
    mip_read_bool(r, &v->enable, 1);
    mip_read_bool(r, &v->manual, 1);
    mip_read_float(r, &v->frequency, 1);
}

static void write_low_pass_filter_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_low_pass_filter_response *v =
        (const struct mip_3dm_low_pass_filter_response *)value;
    mip_write_u8(w, &v->descriptor_set, 1);
    mip_write_u8(w, &v->field_descriptor, 1);
    mip_write_bool(w, &v->enable, 1);
    mip_write_bool(w, &v->manual, 1);
    mip_write_float(w, &v->frequency, 1);
}

const struct mip_codec mip_3dm_low_pass_filter_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_LOW_PASS_FILTER_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_low_pass_filter_response),
    0, /* time-out */
    read_low_pass_filter_response,
    write_low_pass_filter_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3dm_low_pass_filter_response_decode(struct mip_3dm_low_pass_filter_response *value,
                                                  const struct mip_field *field) {
    return mip_decode_field(field, read_low_pass_filter_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_low_pass_filter_response_encode(
    const struct mip_3dm_low_pass_filter_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_LOW_PASS_FILTER_RESPONSE_DESCRIPTOR,
                            write_low_pass_filter_response, value);
}

static void read_device_status(struct mip_reader *r, void *value) {
    struct mip_3dm_device_status *v = (struct mip_3dm_device_status *)value;
    mip_read_u16(r, &v->model_number, 1);
    mip_read_u8(r, &v->status_selector, 1);
}

static void write_device_status(struct mip_writer *w, const void *value) {
    const struct mip_3dm_device_status *v = (const struct mip_3dm_device_status *)value;
    mip_write_u16(w, &v->model_number, 1);
    mip_write_u8(w, &v->status_selector, 1);
}

static bool asked_device_status_1(const void *value) {
    const struct mip_3dm_device_status *v = (const struct mip_3dm_device_status *)value;

    return v->status_selector == 1;
}

static bool asked_device_status_2(const void *value) {
    const struct mip_3dm_device_status *v = (const struct mip_3dm_device_status *)value;

    return v->status_selector == 2;
}

static const struct mip_response responses_device_status[] = {
    {&mip_3dm_device_status_basic_response_codec, asked_device_status_1},
    {&mip_3dm_device_status_basic_stateless_response_codec, asked_device_status_1},
    {&mip_3dm_device_status_diagnostic_response_codec, asked_device_status_2},
    {&mip_3dm_device_status_diagnostic_gnss_response_codec, asked_device_status_2},
    {&mip_3dm_device_status_diagnostic_gq4_45_response_codec, asked_device_status_2},
    {&mip_3dm_device_status_diagnostic_rq1_45_response_codec, asked_device_status_2},
    {&mip_3dm_device_status_diagnostic_gx4_response_codec, asked_device_status_2},
    {&mip_3dm_device_status_diagnostic_imu_response_codec, asked_device_status_2},
    {NULL, NULL},
};

const struct mip_codec mip_3dm_device_status_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_DEVICE_STATUS_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3dm_device_status),
    0, /* time-out */
    read_device_status,
    write_device_status,
    NULL,
    responses_device_status,
    NULL,
};

mip_error mip_3dm_device_status_decode(struct mip_3dm_device_status *value,
                                       const struct mip_field *field) {
    return mip_decode_field(field, read_device_status, value, sizeof(*value), NULL);
}

mip_error mip_3dm_device_status_encode(const struct mip_3dm_device_status *value,
                                       struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_DEVICE_STATUS_DESCRIPTOR, write_device_status,
                            value);
}

struct mip_3dm_device_status
mip_3dm_device_status_make(uint16_t model_number, mip_3dm_device_status_selector status_selector) {
    struct mip_3dm_device_status v;
    memset(&v, 0, sizeof(v));
    v.model_number = model_number;
    v.status_selector = status_selector;
    return v;
}

static void read_device_status_basic_response(struct mip_reader *r, void *value) {
    struct mip_3dm_device_status_basic_response *v =
        (struct mip_3dm_device_status_basic_response *)value;
    mip_read_u16(r, &v->model_number, 1);
    mip_read_constant(r, 1, 1);
    mip_read_u32(r, &v->status_flags, 1);
    mip_read_u16(r, &v->system_state, 1);
    mip_read_u32(r, &v->system_timer, 1);
}

static void write_device_status_basic_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_device_status_basic_response *v =
        (const struct mip_3dm_device_status_basic_response *)value;
    mip_write_u16(w, &v->model_number, 1);
    mip_write_constant(w, 1, 1);
    mip_write_u32(w, &v->status_flags, 1);
    mip_write_u16(w, &v->system_state, 1);
    mip_write_u32(w, &v->system_timer, 1);
}

static const struct mip_constant constants_device_status_basic_response[] = {
    {2, 1, 1},
};
static const struct mip_layout layout_device_status_basic_response = {
    13,
    253, /* bytes of data */
    1,
    constants_device_status_basic_response,
};

const struct mip_codec mip_3dm_device_status_basic_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_DEVICE_STATUS_BASIC_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_device_status_basic_response),
    0, /* time-out */
    read_device_status_basic_response,
    write_device_status_basic_response,
    NULL,
    NULL,
    &layout_device_status_basic_response,
};

mip_error mip_3dm_device_status_basic_response_decode(
    struct mip_3dm_device_status_basic_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_device_status_basic_response, value, sizeof(*value), NULL);
}

mip_error mip_3dm_device_status_basic_response_encode(
    const struct mip_3dm_device_status_basic_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_DEVICE_STATUS_BASIC_RESPONSE_DESCRIPTOR,
                            write_device_status_basic_response, value);
}

static void read_device_status_basic_without_state_response(struct mip_reader *r, void *value) {
    struct mip_3dm_device_status_basic_stateless_response *v =
        (struct mip_3dm_device_status_basic_stateless_response *)value;
    mip_read_u16(r, &v->model_number, 1);
    mip_read_constant(r, 1, 1);
    mip_read_u32(r, &v->status_flags, 1);
    mip_read_u32(r, &v->system_timer, 1);
}

static void write_device_status_basic_without_state_response(struct mip_writer *w,
                                                             const void *value) {
    const struct mip_3dm_device_status_basic_stateless_response *v =
        (const struct mip_3dm_device_status_basic_stateless_response *)value;
    mip_write_u16(w, &v->model_number, 1);
    mip_write_constant(w, 1, 1);
    mip_write_u32(w, &v->status_flags, 1);
    mip_write_u32(w, &v->system_timer, 1);
}

static const struct mip_constant constants_device_status_basic_without_state_response[] = {
    {2, 1, 1},
};
static const struct mip_layout layout_device_status_basic_without_state_response = {
    0,
    12, /* bytes of data */
    1,
    constants_device_status_basic_without_state_response,
};

const struct mip_codec mip_3dm_device_status_basic_stateless_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_DEVICE_STATUS_BASIC_STATELESS_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_device_status_basic_stateless_response),
    0, /* time-out */
    read_device_status_basic_without_state_response,
    write_device_status_basic_without_state_response,
    NULL,
    NULL,
    &layout_device_status_basic_without_state_response,
};

mip_error mip_3dm_device_status_basic_stateless_response_decode(
    struct mip_3dm_device_status_basic_stateless_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_device_status_basic_without_state_response, value,
                            sizeof(*value), NULL);
}

mip_error mip_3dm_device_status_basic_stateless_response_encode(
    const struct mip_3dm_device_status_basic_stateless_response *value,
    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C,
                            MIP_3DM_DEVICE_STATUS_BASIC_STATELESS_RESPONSE_DESCRIPTOR,
                            write_device_status_basic_without_state_response, value);
}

static void read_device_status_diagnostic_response(struct mip_reader *r, void *value) {
    struct mip_3dm_device_status_diagnostic_response *v =
        (struct mip_3dm_device_status_diagnostic_response *)value;
    mip_read_u16(r, &v->model_number, 1);
    mip_read_constant(r, 2, 1);
    mip_read_u32(r, &v->status_flags, 1);
    mip_read_u16(r, &v->system_state, 1);
    mip_read_u32(r, &v->system_timer, 1);
    mip_read_bool(r, &v->imu_stream_enabled, 1);
    mip_read_bool(r, &v->filter_stream_enabled, 1);
    mip_read_u32(r, &v->imu_dropped_packets, 1);
    mip_read_u32(r, &v->filter_dropped_packets, 1);
    mip_read_u32(r, &v->comm_port_bytes_written, 1);
    mip_read_u32(r, &v->comm_port_bytes_read, 1);
    mip_read_u32(r, &v->comm_port_write_overruns, 1);
    mip_read_u32(r, &v->comm_port_read_overruns, 1);
    mip_read_u32(r, &v->imu_parser_errors, 1);
    mip_read_u32(r, &v->imu_message_count, 1);
    mip_read_u32(r, &v->imu_last_message_time, 1);
}

static void write_device_status_diagnostic_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_device_status_diagnostic_response *v =
        (const struct mip_3dm_device_status_diagnostic_response *)value;
    mip_write_u16(w, &v->model_number, 1);
    mip_write_constant(w, 2, 1);
    mip_write_u32(w, &v->status_flags, 1);
    mip_write_u16(w, &v->system_state, 1);
    mip_write_u32(w, &v->system_timer, 1);
    mip_write_bool(w, &v->imu_stream_enabled, 1);
    mip_write_bool(w, &v->filter_stream_enabled, 1);
    mip_write_u32(w, &v->imu_dropped_packets, 1);
    mip_write_u32(w, &v->filter_dropped_packets, 1);
    mip_write_u32(w, &v->comm_port_bytes_written, 1);
    mip_write_u32(w, &v->comm_port_bytes_read, 1);
    mip_write_u32(w, &v->comm_port_write_overruns, 1);
    mip_write_u32(w, &v->comm_port_read_overruns, 1);
    mip_write_u32(w, &v->imu_parser_errors, 1);
    mip_write_u32(w, &v->imu_message_count, 1);
    mip_write_u32(w, &v->imu_last_message_time, 1);
}

static const struct mip_constant constants_device_status_diagnostic_response[] = {
    {2, 1, 2},
};
static const struct mip_layout layout_device_status_diagnostic_response = {
    0,
    59, /* bytes of data */
    1,
    constants_device_status_diagnostic_response,
};

const struct mip_codec mip_3dm_device_status_diagnostic_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_device_status_diagnostic_response),
    0, /* time-out */
    read_device_status_diagnostic_response,
    write_device_status_diagnostic_response,
    NULL,
    NULL,
    &layout_device_status_diagnostic_response,
};

mip_error mip_3dm_device_status_diagnostic_response_decode(
    struct mip_3dm_device_status_diagnostic_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_device_status_diagnostic_response, value, sizeof(*value),
                            NULL);
}

mip_error mip_3dm_device_status_diagnostic_response_encode(
    const struct mip_3dm_device_status_diagnostic_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_RESPONSE_DESCRIPTOR,
                            write_device_status_diagnostic_response, value);
}

static void read_device_status_diagnostic_gnss_response(struct mip_reader *r, void *value) {
    struct mip_3dm_device_status_diagnostic_gnss_response *v =
        (struct mip_3dm_device_status_diagnostic_gnss_response *)value;
    mip_read_u16(r, &v->model_number, 1);
    mip_read_constant(r, 2, 1);
    mip_read_u32(r, &v->status_flags, 1);
    mip_read_u16(r, &v->system_state, 1);
    mip_read_u32(r, &v->system_timer, 1);
    mip_read_u8(r, &v->gnss_power_state, 1);
    mip_read_u32(r, &v->pps_count, 1);
    mip_read_u32(r, &v->pps_last_time, 1);
    mip_read_bool(r, &v->imu_stream_enabled, 1);
    mip_read_bool(r, &v->gnss_stream_enabled, 1);
    mip_read_bool(r, &v->filter_stream_enabled, 1);
    mip_read_u32(r, &v->imu_dropped_packets, 1);
    mip_read_u32(r, &v->gnss_dropped_packets, 1);
    mip_read_u32(r, &v->filter_dropped_packets, 1);
    mip_read_u32(r, &v->comm_port_bytes_written, 1);
    mip_read_u32(r, &v->comm_port_bytes_read, 1);
    mip_read_u32(r, &v->comm_port_write_overruns, 1);
    mip_read_u32(r, &v->comm_port_read_overruns, 1);
    mip_read_u32(r, &v->imu_parser_errors, 1);
    mip_read_u32(r, &v->imu_message_count, 1);
    mip_read_u32(r, &v->imu_last_message_time, 1);
    mip_read_u32(r, &v->gnss_parser_errors, 1);
    mip_read_u32(r, &v->gnss_message_count, 1);
    mip_read_u32(r, &v->gnss_last_message_time, 1);
}

static void write_device_status_diagnostic_gnss_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_device_status_diagnostic_gnss_response *v =
        (const struct mip_3dm_device_status_diagnostic_gnss_response *)value;
    mip_write_u16(w, &v->model_number, 1);
    mip_write_constant(w, 2, 1);
    mip_write_u32(w, &v->status_flags, 1);
    mip_write_u16(w, &v->system_state, 1);
    mip_write_u32(w, &v->system_timer, 1);
    mip_write_u8(w, &v->gnss_power_state, 1);
    mip_write_u32(w, &v->pps_count, 1);
    mip_write_u32(w, &v->pps_last_time, 1);
    mip_write_bool(w, &v->imu_stream_enabled, 1);
    mip_write_bool(w, &v->gnss_stream_enabled, 1);
    mip_write_bool(w, &v->filter_stream_enabled, 1);
    mip_write_u32(w, &v->imu_dropped_packets, 1);
    mip_write_u32(w, &v->gnss_dropped_packets, 1);
    mip_write_u32(w, &v->filter_dropped_packets, 1);
    mip_write_u32(w, &v->comm_port_bytes_written, 1);
    mip_write_u32(w, &v->comm_port_bytes_read, 1);
    mip_write_u32(w, &v->comm_port_write_overruns, 1);
    mip_write_u32(w, &v->comm_port_read_overruns, 1);
    mip_write_u32(w, &v->imu_parser_errors, 1);
    mip_write_u32(w, &v->imu_message_count, 1);
    mip_write_u32(w, &v->imu_last_message_time, 1);
    mip_write_u32(w, &v->gnss_parser_errors, 1);
    mip_write_u32(w, &v->gnss_message_count, 1);
    mip_write_u32(w, &v->gnss_last_message_time, 1);
}

static const struct mip_constant constants_device_status_diagnostic_gnss_response[] = {
    {2, 1, 2},
};
static const struct mip_layout layout_device_status_diagnostic_gnss_response = {
    77,
    79, /* bytes of data */
    1,
    constants_device_status_diagnostic_gnss_response,
};

const struct mip_codec mip_3dm_device_status_diagnostic_gnss_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GNSS_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_device_status_diagnostic_gnss_response),
    0, /* time-out */
    read_device_status_diagnostic_gnss_response,
    write_device_status_diagnostic_gnss_response,
    NULL,
    NULL,
    &layout_device_status_diagnostic_gnss_response,
};

mip_error mip_3dm_device_status_diagnostic_gnss_response_decode(
    struct mip_3dm_device_status_diagnostic_gnss_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_device_status_diagnostic_gnss_response, value,
                            sizeof(*value), NULL);
}

mip_error mip_3dm_device_status_diagnostic_gnss_response_encode(
    const struct mip_3dm_device_status_diagnostic_gnss_response *value,
    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C,
                            MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GNSS_RESPONSE_DESCRIPTOR,
                            write_device_status_diagnostic_gnss_response, value);
}

static void read_device_status_diagnostic_gq4_45_response(struct mip_reader *r, void *value) {
    struct mip_3dm_device_status_diagnostic_gq4_45_response *v =
        (struct mip_3dm_device_status_diagnostic_gq4_45_response *)value;
    mip_read_u16(r, &v->model_number, 1);
    mip_read_constant(r, 2, 1);
    mip_read_u32(r, &v->status_flags, 1);
    mip_read_u16(r, &v->system_state, 1);
    mip_read_u32(r, &v->system_timer, 1);
    mip_read_u8(r, &v->gnss_power_state, 1);
    mip_read_u32(r, &v->pps_count, 1);
    mip_read_u32(r, &v->pps_last_time, 1);
    mip_read_bool(r, &v->imu_stream_enabled, 1);
    mip_read_bool(r, &v->gnss_stream_enabled, 1);
    mip_read_bool(r, &v->filter_stream_enabled, 1);
    mip_read_u32(r, &v->imu_dropped_packets, 1);
    mip_read_u32(r, &v->gnss_dropped_packets, 1);
    mip_read_u32(r, &v->filter_dropped_packets, 1);
    mip_read_u32(r, &v->comm_port_bytes_written, 1);
    mip_read_u32(r, &v->comm_port_bytes_read, 1);
    mip_read_u32(r, &v->comm_port_write_overruns, 1);
    mip_read_u32(r, &v->comm_port_read_overruns, 1);
    mip_read_u32(r, &v->imu_parser_errors, 1);
    mip_read_u32(r, &v->imu_message_count, 1);
    mip_read_u32(r, &v->imu_last_message_time, 1);
    mip_read_u32(r, &v->gnss_parser_errors, 1);
    mip_read_u32(r, &v->gnss_message_count, 1);
    mip_read_u32(r, &v->gnss_last_message_time, 1);
    mip_read_bool(r, &v->mag_init_failed, 1);
    mip_read_bool(r, &v->pressure_init_failed, 1);
    mip_read_bool(r, &v->receiver_init_failed, 1);
}

static void write_device_status_diagnostic_gq4_45_response(struct mip_writer *w,
                                                           const void *value) {
    const struct mip_3dm_device_status_diagnostic_gq4_45_response *v =
        (const struct mip_3dm_device_status_diagnostic_gq4_45_response *)value;
    mip_write_u16(w, &v->model_number, 1);
    mip_write_constant(w, 2, 1);
    mip_write_u32(w, &v->status_flags, 1);
    mip_write_u16(w, &v->system_state, 1);
    mip_write_u32(w, &v->system_timer, 1);
    mip_write_u8(w, &v->gnss_power_state, 1);
    mip_write_u32(w, &v->pps_count, 1);
    mip_write_u32(w, &v->pps_last_time, 1);
    mip_write_bool(w, &v->imu_stream_enabled, 1);
    mip_write_bool(w, &v->gnss_stream_enabled, 1);
    mip_write_bool(w, &v->filter_stream_enabled, 1);
    mip_write_u32(w, &v->imu_dropped_packets, 1);
    mip_write_u32(w, &v->gnss_dropped_packets, 1);
    mip_write_u32(w, &v->filter_dropped_packets, 1);
    mip_write_u32(w, &v->comm_port_bytes_written, 1);
    mip_write_u32(w, &v->comm_port_bytes_read, 1);
    mip_write_u32(w, &v->comm_port_write_overruns, 1);
    mip_write_u32(w, &v->comm_port_read_overruns, 1);
    mip_write_u32(w, &v->imu_parser_errors, 1);
    mip_write_u32(w, &v->imu_message_count, 1);
    mip_write_u32(w, &v->imu_last_message_time, 1);
    mip_write_u32(w, &v->gnss_parser_errors, 1);
    mip_write_u32(w, &v->gnss_message_count, 1);
    mip_write_u32(w, &v->gnss_last_message_time, 1);
    mip_write_bool(w, &v->mag_init_failed, 1);
    mip_write_bool(w, &v->pressure_init_failed, 1);
    mip_write_bool(w, &v->receiver_init_failed, 1);
}

static const struct mip_constant constants_device_status_diagnostic_gq4_45_response[] = {
    {2, 1, 2},
};
static const struct mip_layout layout_device_status_diagnostic_gq4_45_response = {
    80,
    85, /* bytes of data */
    1,
    constants_device_status_diagnostic_gq4_45_response,
};

const struct mip_codec mip_3dm_device_status_diagnostic_gq4_45_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GQ4_45_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_device_status_diagnostic_gq4_45_response),
    0, /* time-out */
    read_device_status_diagnostic_gq4_45_response,
    write_device_status_diagnostic_gq4_45_response,
    NULL,
    NULL,
    &layout_device_status_diagnostic_gq4_45_response,
};

mip_error mip_3dm_device_status_diagnostic_gq4_45_response_decode(
    struct mip_3dm_device_status_diagnostic_gq4_45_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_device_status_diagnostic_gq4_45_response, value,
                            sizeof(*value), NULL);
}

mip_error mip_3dm_device_status_diagnostic_gq4_45_response_encode(
    const struct mip_3dm_device_status_diagnostic_gq4_45_response *value,
    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C,
                            MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GQ4_45_RESPONSE_DESCRIPTOR,
                            write_device_status_diagnostic_gq4_45_response, value);
}

static void read_device_status_diagnostic_rq1_45_response(struct mip_reader *r, void *value) {
    struct mip_3dm_device_status_diagnostic_rq1_45_response *v =
        (struct mip_3dm_device_status_diagnostic_rq1_45_response *)value;
    mip_read_u16(r, &v->model_number, 1);
    mip_read_constant(r, 2, 1);
    mip_read_u32(r, &v->status_flags, 1);
    mip_read_u16(r, &v->system_state, 1);
    mip_read_u32(r, &v->system_timer, 1);
    mip_read_u8(r, &v->gnss_power_state, 1);
    mip_read_u8(r, &v->cold_start_on_power_on, 1);
    mip_read_float(r, &v->temperature, 1);
    mip_read_u32(r, &v->temperature_last_time, 1);
    mip_read_u32(r, &v->pps_count, 1);
    mip_read_u32(r, &v->pps_last_time, 1);
    mip_read_bool(r, &v->imu_stream_enabled, 1);
    mip_read_bool(r, &v->gnss_stream_enabled, 1);
    mip_read_bool(r, &v->filter_stream_enabled, 1);
    mip_read_u32(r, &v->imu_dropped_packets, 1);
    mip_read_u32(r, &v->gnss_dropped_packets, 1);
    mip_read_u32(r, &v->filter_dropped_packets, 1);
    mip_read_u32(r, &v->comm_port_bytes_written, 1);
    mip_read_u32(r, &v->comm_port_bytes_read, 1);
    mip_read_u32(r, &v->comm_port_write_overruns, 1);
    mip_read_u32(r, &v->comm_port_read_overruns, 1);
    mip_read_u32(r, &v->imu_parser_errors, 1);
    mip_read_u32(r, &v->imu_message_count, 1);
    mip_read_u32(r, &v->imu_last_message_time, 1);
    mip_read_u32(r, &v->gnss_parser_errors, 1);
    mip_read_u32(r, &v->gnss_message_count, 1);
    mip_read_u32(r, &v->gnss_last_message_time, 1);
}

static void write_device_status_diagnostic_rq1_45_response(struct mip_writer *w,
                                                           const void *value) {
    const struct mip_3dm_device_status_diagnostic_rq1_45_response *v =
        (const struct mip_3dm_device_status_diagnostic_rq1_45_response *)value;
    mip_write_u16(w, &v->model_number, 1);
    mip_write_constant(w, 2, 1);
    mip_write_u32(w, &v->status_flags, 1);
    mip_write_u16(w, &v->system_state, 1);
    mip_write_u32(w, &v->system_timer, 1);
    mip_write_u8(w, &v->gnss_power_state, 1);
    mip_write_u8(w, &v->cold_start_on_power_on, 1);
    mip_write_float(w, &v->temperature, 1);
    mip_write_u32(w, &v->temperature_last_time, 1);
    mip_write_u32(w, &v->pps_count, 1);
    mip_write_u32(w, &v->pps_last_time, 1);
    mip_write_bool(w, &v->imu_stream_enabled, 1);
    mip_write_bool(w, &v->gnss_stream_enabled, 1);
    mip_write_bool(w, &v->filter_stream_enabled, 1);
    mip_write_u32(w, &v->imu_dropped_packets, 1);
    mip_write_u32(w, &v->gnss_dropped_packets, 1);
    mip_write_u32(w, &v->filter_dropped_packets, 1);
    mip_write_u32(w, &v->comm_port_bytes_written, 1);
    mip_write_u32(w, &v->comm_port_bytes_read, 1);
    mip_write_u32(w, &v->comm_port_write_overruns, 1);
    mip_write_u32(w, &v->comm_port_read_overruns, 1);
    mip_write_u32(w, &v->imu_parser_errors, 1);
    mip_write_u32(w, &v->imu_message_count, 1);
    mip_write_u32(w, &v->imu_last_message_time, 1);
    mip_write_u32(w, &v->gnss_parser_errors, 1);
    mip_write_u32(w, &v->gnss_message_count, 1);
    mip_write_u32(w, &v->gnss_last_message_time, 1);
}

static const struct mip_constant constants_device_status_diagnostic_rq1_45_response[] = {
    {2, 1, 2},
};
static const struct mip_layout layout_device_status_diagnostic_rq1_45_response = {
    86,
    253, /* bytes of data */
    1,
    constants_device_status_diagnostic_rq1_45_response,
};

const struct mip_codec mip_3dm_device_status_diagnostic_rq1_45_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_RQ1_45_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_device_status_diagnostic_rq1_45_response),
    0, /* time-out */
    read_device_status_diagnostic_rq1_45_response,
    write_device_status_diagnostic_rq1_45_response,
    NULL,
    NULL,
    &layout_device_status_diagnostic_rq1_45_response,
};

mip_error mip_3dm_device_status_diagnostic_rq1_45_response_decode(
    struct mip_3dm_device_status_diagnostic_rq1_45_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_device_status_diagnostic_rq1_45_response, value,
                            sizeof(*value), NULL);
}

mip_error mip_3dm_device_status_diagnostic_rq1_45_response_encode(
    const struct mip_3dm_device_status_diagnostic_rq1_45_response *value,
    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C,
                            MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_RQ1_45_RESPONSE_DESCRIPTOR,
                            write_device_status_diagnostic_rq1_45_response, value);
}

static void read_device_status_diagnostic_gx4_response(struct mip_reader *r, void *value) {
    struct mip_3dm_device_status_diagnostic_gx4_response *v =
        (struct mip_3dm_device_status_diagnostic_gx4_response *)value;
    mip_read_u16(r, &v->model_number, 1);
    mip_read_constant(r, 2, 1);
    mip_read_u32(r, &v->status_flags, 1);
    mip_read_u32(r, &v->system_timer, 1);
    mip_read_u32(r, &v->pps_count, 1);
    mip_read_u32(r, &v->pps_last_time, 1);
    mip_read_bool(r, &v->imu_stream_enabled, 1);
    mip_read_bool(r, &v->filter_stream_enabled, 1);
    mip_read_u32(r, &v->imu_dropped_packets, 1);
    mip_read_u32(r, &v->filter_dropped_packets, 1);
    mip_read_u32(r, &v->comm_port_bytes_written, 1);
    mip_read_u32(r, &v->comm_port_bytes_read, 1);
    mip_read_u32(r, &v->comm_port_write_overruns, 1);
    mip_read_u32(r, &v->comm_port_read_overruns, 1);
    mip_read_u32(r, &v->usb_bytes_written, 1);
    mip_read_u32(r, &v->usb_bytes_read, 1);
    mip_read_u32(r, &v->usb_write_overruns, 1);
    mip_read_u32(r, &v->usb_read_overruns, 1);
    mip_read_u32(r, &v->imu_parser_errors, 1);
    mip_read_u32(r, &v->imu_message_count, 1);
    mip_read_u32(r, &v->imu_last_message_time, 1);
}

static void write_device_status_diagnostic_gx4_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_device_status_diagnostic_gx4_response *v =
        (const struct mip_3dm_device_status_diagnostic_gx4_response *)value;
    mip_write_u16(w, &v->model_number, 1);
    mip_write_constant(w, 2, 1);
    mip_write_u32(w, &v->status_flags, 1);
    mip_write_u32(w, &v->system_timer, 1);
    mip_write_u32(w, &v->pps_count, 1);
    mip_write_u32(w, &v->pps_last_time, 1);
    mip_write_bool(w, &v->imu_stream_enabled, 1);
    mip_write_bool(w, &v->filter_stream_enabled, 1);
    mip_write_u32(w, &v->imu_dropped_packets, 1);
    mip_write_u32(w, &v->filter_dropped_packets, 1);
    mip_write_u32(w, &v->comm_port_bytes_written, 1);
    mip_write_u32(w, &v->comm_port_bytes_read, 1);
    mip_write_u32(w, &v->comm_port_write_overruns, 1);
    mip_write_u32(w, &v->comm_port_read_overruns, 1);
    mip_write_u32(w, &v->usb_bytes_written, 1);
    mip_write_u32(w, &v->usb_bytes_read, 1);
    mip_write_u32(w, &v->usb_write_overruns, 1);
    mip_write_u32(w, &v->usb_read_overruns, 1);
    mip_write_u32(w, &v->imu_parser_errors, 1);
    mip_write_u32(w, &v->imu_message_count, 1);
    mip_write_u32(w, &v->imu_last_message_time, 1);
}

static const struct mip_constant constants_device_status_diagnostic_gx4_response[] = {
    {2, 1, 2},
};
static const struct mip_layout layout_device_status_diagnostic_gx4_response = {
    73,
    76, /* bytes of data */
    1,
    constants_device_status_diagnostic_gx4_response,
};

const struct mip_codec mip_3dm_device_status_diagnostic_gx4_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GX4_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_device_status_diagnostic_gx4_response),
    0, /* time-out */
    read_device_status_diagnostic_gx4_response,
    write_device_status_diagnostic_gx4_response,
    NULL,
    NULL,
    &layout_device_status_diagnostic_gx4_response,
};

mip_error mip_3dm_device_status_diagnostic_gx4_response_decode(
    struct mip_3dm_device_status_diagnostic_gx4_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_device_status_diagnostic_gx4_response, value,
                            sizeof(*value), NULL);
}

mip_error mip_3dm_device_status_diagnostic_gx4_response_encode(
    const struct mip_3dm_device_status_diagnostic_gx4_response *value,
    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GX4_RESPONSE_DESCRIPTOR,
                            write_device_status_diagnostic_gx4_response, value);
}

static void read_device_status_diagnostic_imu_response(struct mip_reader *r, void *value) {
    struct mip_3dm_device_status_diagnostic_imu_response *v =
        (struct mip_3dm_device_status_diagnostic_imu_response *)value;
    mip_read_u16(r, &v->model_number, 1);
    mip_read_constant(r, 2, 1);
    mip_read_u32(r, &v->status_flags, 1);
    mip_read_u32(r, &v->system_timer, 1);
    mip_read_bool(r, &v->has_mag, 1);
    mip_read_bool(r, &v->has_pressure, 1);
    mip_read_u8(r, &v->power_state, 1);
    mip_read_u16(r, &v->gyro_range, 1);
    mip_read_u16(r, &v->accel_range, 1);
    mip_read_u32(r, &v->reserved, 1);
    mip_read_float(r, &v->temperature, 1);
    mip_read_u32(r, &v->temperature_last_time, 1);
    mip_read_u8(r, &v->temperature_error, 1);
    mip_read_u32(r, &v->pps_count, 1);
    mip_read_u32(r, &v->pps_last_time, 1);
    mip_read_bool(r, &v->imu_stream_enabled, 1);
    mip_read_u32(r, &v->imu_dropped_packets, 1);
    mip_read_u32(r, &v->comm_port_bytes_written, 1);
    mip_read_u32(r, &v->comm_port_bytes_read, 1);
    mip_read_u32(r, &v->comm_port_write_overruns, 1);
    mip_read_u32(r, &v->comm_port_read_overruns, 1);
}

static void write_device_status_diagnostic_imu_response(struct mip_writer *w, const void *value) {
    const struct mip_3dm_device_status_diagnostic_imu_response *v =
        (const struct mip_3dm_device_status_diagnostic_imu_response *)value;
    mip_write_u16(w, &v->model_number, 1);
    mip_write_constant(w, 2, 1);
    mip_write_u32(w, &v->status_flags, 1);
    mip_write_u32(w, &v->system_timer, 1);
    mip_write_bool(w, &v->has_mag, 1);
    mip_write_bool(w, &v->has_pressure, 1);
    mip_write_u8(w, &v->power_state, 1);
    mip_write_u16(w, &v->gyro_range, 1);
    mip_write_u16(w, &v->accel_range, 1);
    mip_write_u32(w, &v->reserved, 1);
    mip_write_float(w, &v->temperature, 1);
    mip_write_u32(w, &v->temperature_last_time, 1);
    mip_write_u8(w, &v->temperature_error, 1);
    mip_write_u32(w, &v->pps_count, 1);
    mip_write_u32(w, &v->pps_last_time, 1);
    mip_write_bool(w, &v->imu_stream_enabled, 1);
    mip_write_u32(w, &v->imu_dropped_packets, 1);
    mip_write_u32(w, &v->comm_port_bytes_written, 1);
    mip_write_u32(w, &v->comm_port_bytes_read, 1);
    mip_write_u32(w, &v->comm_port_write_overruns, 1);
    mip_write_u32(w, &v->comm_port_read_overruns, 1);
}

static const struct mip_constant constants_device_status_diagnostic_imu_response[] = {
    {2, 1, 2},
};
static const struct mip_layout layout_device_status_diagnostic_imu_response = {
    60,
    72, /* bytes of data */
    1,
    constants_device_status_diagnostic_imu_response,
};

const struct mip_codec mip_3dm_device_status_diagnostic_imu_response_codec = {
    0x0C, /* descriptor set */
    MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_IMU_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_3dm_device_status_diagnostic_imu_response),
    0, /* time-out */
    read_device_status_diagnostic_imu_response,
    write_device_status_diagnostic_imu_response,
    NULL,
    NULL,
    &layout_device_status_diagnostic_imu_response,
};

mip_error mip_3dm_device_status_diagnostic_imu_response_decode(
    struct mip_3dm_device_status_diagnostic_imu_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_device_status_diagnostic_imu_response, value,
                            sizeof(*value), NULL);
}

mip_error mip_3dm_device_status_diagnostic_imu_response_encode(
    const struct mip_3dm_device_status_diagnostic_imu_response *value,
    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_IMU_RESPONSE_DESCRIPTOR,
                            write_device_status_diagnostic_imu_response, value);
}
