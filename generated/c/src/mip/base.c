/* Base. */
#include "mip/base.h"

#include <string.h>

void mip_base_device_info_read(struct mip_reader *r, struct mip_base_device_info *v) {
    mip_read_u16(r, &v->firmware_version, 1);
    mip_read_char(r, v->model_name, 16);
    mip_read_char(r, v->model_number, 16);
    mip_read_char(r, v->serial_number, 16);
    mip_read_char(r, v->lot_number, 16);
    mip_read_char(r, v->device_options, 16);
}

void mip_base_device_info_write(struct mip_writer *w, const struct mip_base_device_info *v) {
    mip_write_u16(w, &v->firmware_version, 1);
    mip_write_char(w, v->model_name, 16);
    mip_write_char(w, v->model_number, 16);
    mip_write_char(w, v->serial_number, 16);
    mip_write_char(w, v->lot_number, 16);
    mip_write_char(w, v->device_options, 16);
}

const struct mip_codec mip_base_ping_codec = {
    0x01, /* descriptor set */
    MIP_BASE_PING_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_base_ping),
    0, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    NULL,
    NULL,
};

mip_error mip_base_ping_decode(struct mip_base_ping *value, const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_base_ping_encode(const struct mip_base_ping *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_BASE_PING_DESCRIPTOR, mip_write_nothing, value);
}

const struct mip_codec mip_base_set_idle_codec = {
    0x01, /* descriptor set */
    MIP_BASE_SET_IDLE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_base_set_idle),
    0, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    NULL,
    NULL,
};

mip_error mip_base_set_idle_decode(struct mip_base_set_idle *value, const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_base_set_idle_encode(const struct mip_base_set_idle *value,
                                   struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_BASE_SET_IDLE_DESCRIPTOR, mip_write_nothing, value);
}

static const struct mip_response responses_get_device_info[] = {
    {&mip_base_get_device_info_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_base_get_device_info_codec = {
    0x01, /* descriptor set */
    MIP_BASE_GET_DEVICE_INFO_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_base_get_device_info),
    0, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    responses_get_device_info,
    NULL,
};

mip_error mip_base_get_device_info_decode(struct mip_base_get_device_info *value,
                                          const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_base_get_device_info_encode(const struct mip_base_get_device_info *value,
                                          struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_BASE_GET_DEVICE_INFO_DESCRIPTOR, mip_write_nothing,
                            value);
}

static void read_get_device_info_response(struct mip_reader *r, void *value) {
    struct mip_base_get_device_info_response *v = (struct mip_base_get_device_info_response *)value;
    mip_base_device_info_read(r, &v->device_info);
}

static void write_get_device_info_response(struct mip_writer *w, const void *value) {
    const struct mip_base_get_device_info_response *v =
        (const struct mip_base_get_device_info_response *)value;
    mip_base_device_info_write(w, &v->device_info);
}

const struct mip_codec mip_base_get_device_info_response_codec = {
    0x01, /* descriptor set */
    MIP_BASE_GET_DEVICE_INFO_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_base_get_device_info_response),
    0, /* time-out */
    read_get_device_info_response,
    write_get_device_info_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_base_get_device_info_response_decode(struct mip_base_get_device_info_response *value,
                                                   const struct mip_field *field) {
    return mip_decode_field(field, read_get_device_info_response, value, sizeof(*value), NULL);
}

mip_error mip_base_get_device_info_response_encode(
    const struct mip_base_get_device_info_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_BASE_GET_DEVICE_INFO_RESPONSE_DESCRIPTOR,
                            write_get_device_info_response, value);
}

static const struct mip_response responses_get_device_descriptors[] = {
    {&mip_base_get_device_descriptors_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_base_get_device_descriptors_codec = {
    0x01, /* descriptor set */
    MIP_BASE_GET_DEVICE_DESCRIPTORS_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_base_get_device_descriptors),
    0, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    responses_get_device_descriptors,
    NULL,
};

mip_error mip_base_get_device_descriptors_decode(struct mip_base_get_device_descriptors *value,
                                                 const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_base_get_device_descriptors_encode(
    const struct mip_base_get_device_descriptors *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_BASE_GET_DEVICE_DESCRIPTORS_DESCRIPTOR,
                            mip_write_nothing, value);
}

static void read_get_device_descriptors_response(struct mip_reader *r, void *value) {
    struct mip_base_get_device_descriptors_response *v =
        (struct mip_base_get_device_descriptors_response *)value;
    v->descriptors_count = (uint8_t)mip_read_rest(r, 126, 2);
    mip_read_u16(r, v->descriptors, v->descriptors_count);
}

static void write_get_device_descriptors_response(struct mip_writer *w, const void *value) {
    const struct mip_base_get_device_descriptors_response *v =
        (const struct mip_base_get_device_descriptors_response *)value;
    mip_write_u16(w, v->descriptors, mip_write_count(w, v->descriptors_count, 126));
}

const struct mip_codec mip_base_get_device_descriptors_response_codec = {
    0x01, /* descriptor set */
    MIP_BASE_GET_DEVICE_DESCRIPTORS_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_base_get_device_descriptors_response),
    0, /* time-out */
    read_get_device_descriptors_response,
    write_get_device_descriptors_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_base_get_device_descriptors_response_decode(
    struct mip_base_get_device_descriptors_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_get_device_descriptors_response, value, sizeof(*value),
                            NULL);
}

mip_error mip_base_get_device_descriptors_response_encode(
    const struct mip_base_get_device_descriptors_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_BASE_GET_DEVICE_DESCRIPTORS_RESPONSE_DESCRIPTOR,
                            write_get_device_descriptors_response, value);
}

static const struct mip_response responses_built_in_test[] = {
    {&mip_base_built_in_test_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_base_built_in_test_codec = {
    0x01, /* descriptor set */
    MIP_BASE_BUILT_IN_TEST_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_base_built_in_test),
    10000, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    responses_built_in_test,
    NULL,
};

mip_error mip_base_built_in_test_decode(struct mip_base_built_in_test *value,
                                        const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_base_built_in_test_encode(const struct mip_base_built_in_test *value,
                                        struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_BASE_BUILT_IN_TEST_DESCRIPTOR, mip_write_nothing,
                            value);
}

static void read_built_in_test_response(struct mip_reader *r, void *value) {
    struct mip_base_built_in_test_response *v = (struct mip_base_built_in_test_response *)value;
    mip_read_u32(r, &v->result, 1);
}

static void write_built_in_test_response(struct mip_writer *w, const void *value) {
    const struct mip_base_built_in_test_response *v =
        (const struct mip_base_built_in_test_response *)value;
    mip_write_u32(w, &v->result, 1);
}

const struct mip_codec mip_base_built_in_test_response_codec = {
    0x01, /* descriptor set */
    MIP_BASE_BUILT_IN_TEST_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_base_built_in_test_response),
    0, /* time-out */
    read_built_in_test_response,
    write_built_in_test_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_base_built_in_test_response_decode(struct mip_base_built_in_test_response *value,
                                                 const struct mip_field *field) {
    return mip_decode_field(field, read_built_in_test_response, value, sizeof(*value), NULL);
}

mip_error mip_base_built_in_test_response_encode(
    const struct mip_base_built_in_test_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_BASE_BUILT_IN_TEST_RESPONSE_DESCRIPTOR,
                            write_built_in_test_response, value);
}

const struct mip_codec mip_base_resume_codec = {
    0x01, /* descriptor set */
    MIP_BASE_RESUME_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_base_resume),
    0, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    NULL,
    NULL,
};

mip_error mip_base_resume_decode(struct mip_base_resume *value, const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_base_resume_encode(const struct mip_base_resume *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_BASE_RESUME_DESCRIPTOR, mip_write_nothing, value);
}

static const struct mip_response responses_get_extended_descriptors[] = {
    {&mip_base_get_extended_descriptors_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_base_get_extended_descriptors_codec = {
    0x01, /* descriptor set */
    MIP_BASE_GET_EXTENDED_DESCRIPTORS_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_base_get_extended_descriptors),
    0, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    responses_get_extended_descriptors,
    NULL,
};

mip_error mip_base_get_extended_descriptors_decode(struct mip_base_get_extended_descriptors *value,
                                                   const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_base_get_extended_descriptors_encode(
    const struct mip_base_get_extended_descriptors *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_BASE_GET_EXTENDED_DESCRIPTORS_DESCRIPTOR,
                            mip_write_nothing, value);
}

static void read_get_extended_descriptors_response(struct mip_reader *r, void *value) {
    struct mip_base_get_extended_descriptors_response *v =
        (struct mip_base_get_extended_descriptors_response *)value;
    v->descriptors_count = (uint8_t)mip_read_rest(r, 126, 2);
    mip_read_u16(r, v->descriptors, v->descriptors_count);
}

static void write_get_extended_descriptors_response(struct mip_writer *w, const void *value) {
    const struct mip_base_get_extended_descriptors_response *v =
        (const struct mip_base_get_extended_descriptors_response *)value;
    mip_write_u16(w, v->descriptors, mip_write_count(w, v->descriptors_count, 126));
}

const struct mip_codec mip_base_get_extended_descriptors_response_codec = {
    0x01, /* descriptor set */
    MIP_BASE_GET_EXTENDED_DESCRIPTORS_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_base_get_extended_descriptors_response),
    0, /* time-out */
    read_get_extended_descriptors_response,
    write_get_extended_descriptors_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_base_get_extended_descriptors_response_decode(
    struct mip_base_get_extended_descriptors_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_get_extended_descriptors_response, value, sizeof(*value),
                            NULL);
}

mip_error mip_base_get_extended_descriptors_response_encode(
    const struct mip_base_get_extended_descriptors_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_BASE_GET_EXTENDED_DESCRIPTORS_RESPONSE_DESCRIPTOR,
                            write_get_extended_descriptors_response, value);
}

static const struct mip_response responses_continuous_built_in_test[] = {
    {&mip_base_continuous_built_in_test_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_base_continuous_built_in_test_codec = {
    0x01, /* descriptor set */
    MIP_BASE_CONTINUOUS_BUILT_IN_TEST_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_base_continuous_built_in_test),
    0, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    responses_continuous_built_in_test,
    NULL,
};

mip_error mip_base_continuous_built_in_test_decode(struct mip_base_continuous_built_in_test *value,
                                                   const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_base_continuous_built_in_test_encode(
    const struct mip_base_continuous_built_in_test *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_BASE_CONTINUOUS_BUILT_IN_TEST_DESCRIPTOR,
                            mip_write_nothing, value);
}

static void read_continuous_built_in_test_response(struct mip_reader *r, void *value) {
    struct mip_base_continuous_built_in_test_response *v =
        (struct mip_base_continuous_built_in_test_response *)value;
    mip_read_u8(r, v->result, 16);
}

static void write_continuous_built_in_test_response(struct mip_writer *w, const void *value) {
    const struct mip_base_continuous_built_in_test_response *v =
        (const struct mip_base_continuous_built_in_test_response *)value;
    mip_write_u8(w, v->result, 16);
}

const struct mip_codec mip_base_continuous_built_in_test_response_codec = {
    0x01, /* descriptor set */
    MIP_BASE_CONTINUOUS_BUILT_IN_TEST_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_base_continuous_built_in_test_response),
    0, /* time-out */
    read_continuous_built_in_test_response,
    write_continuous_built_in_test_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_base_continuous_built_in_test_response_decode(
    struct mip_base_continuous_built_in_test_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_continuous_built_in_test_response, value, sizeof(*value),
                            NULL);
}

mip_error mip_base_continuous_built_in_test_response_encode(
    const struct mip_base_continuous_built_in_test_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_BASE_CONTINUOUS_BUILT_IN_TEST_RESPONSE_DESCRIPTOR,
                            write_continuous_built_in_test_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_comm_speed[] = {0, 2, 1, 1, 1, 1};

static void read_comm_speed(struct mip_reader *r, void *value) {
    struct mip_base_comm_speed *v = (struct mip_base_comm_speed *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_comm_speed, sizeof(required_comm_speed));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->port, 1);
    mip_read_group(r, 2, 2);
    mip_read_u32(r, &v->baud, 1);
    v->present = mip_read_present(r);
}

static void write_comm_speed(struct mip_writer *w, const void *value) {
    const struct mip_base_comm_speed *v = (const struct mip_base_comm_speed *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_comm_speed, sizeof(required_comm_speed),
                       v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->port, 1);
    mip_write_group(w, 2, 2);
    mip_write_u32(w, &v->baud, 1);
}

static bool asked_comm_speed_1(const void *value) {
    const struct mip_base_comm_speed *v = (const struct mip_base_comm_speed *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_comm_speed[] = {
    {&mip_base_comm_speed_response_codec, asked_comm_speed_1},
    {NULL, NULL},
};

const struct mip_codec mip_base_comm_speed_codec = {
    0x01, /* descriptor set */
    MIP_BASE_COMM_SPEED_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_base_comm_speed),
    0, /* time-out */
    read_comm_speed,
    write_comm_speed,
    NULL,
    responses_comm_speed,
    NULL,
};

mip_error mip_base_comm_speed_decode(struct mip_base_comm_speed *value,
                                     const struct mip_field *field) {
    return mip_decode_field(field, read_comm_speed, value, sizeof(*value), NULL);
}

mip_error mip_base_comm_speed_encode(const struct mip_base_comm_speed *value,
                                     struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_BASE_COMM_SPEED_DESCRIPTOR, write_comm_speed, value);
}

struct mip_base_comm_speed mip_base_comm_speed_write(uint8_t port, uint32_t baud) {
    struct mip_base_comm_speed v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.port = port;
    v.baud = baud;
    return v;
}

struct mip_base_comm_speed mip_base_comm_speed_read(uint8_t port) {
    struct mip_base_comm_speed v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    v.port = port;
    return v;
}

struct mip_base_comm_speed mip_base_comm_speed_save(uint8_t port) {
    struct mip_base_comm_speed v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    v.port = port;
    return v;
}

struct mip_base_comm_speed mip_base_comm_speed_load(uint8_t port) {
    struct mip_base_comm_speed v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    v.port = port;
    return v;
}

struct mip_base_comm_speed mip_base_comm_speed_default(uint8_t port) {
    struct mip_base_comm_speed v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    v.port = port;
    return v;
}

static void read_comm_speed_response(struct mip_reader *r, void *value) {
    struct mip_base_comm_speed_response *v = (struct mip_base_comm_speed_response *)value;
    mip_read_u8(r, &v->port, 1);
    mip_read_u32(r, &v->baud, 1);
}

static void write_comm_speed_response(struct mip_writer *w, const void *value) {
    const struct mip_base_comm_speed_response *v =
        (const struct mip_base_comm_speed_response *)value;
    mip_write_u8(w, &v->port, 1);
    mip_write_u32(w, &v->baud, 1);
}

const struct mip_codec mip_base_comm_speed_response_codec = {
    0x01, /* descriptor set */
    MIP_BASE_COMM_SPEED_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_base_comm_speed_response),
    0, /* time-out */
    read_comm_speed_response,
    write_comm_speed_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_base_comm_speed_response_decode(struct mip_base_comm_speed_response *value,
                                              const struct mip_field *field) {
    return mip_decode_field(field, read_comm_speed_response, value, sizeof(*value), NULL);
}

mip_error mip_base_comm_speed_response_encode(const struct mip_base_comm_speed_response *value,
                                              struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_BASE_COMM_SPEED_RESPONSE_DESCRIPTOR,
                            write_comm_speed_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_gps_time_update[] = {0, 2, 1, 0, 0, 0, 2};

static void read_gps_time_update(struct mip_reader *r, void *value) {
    struct mip_base_gps_time_update *v = (struct mip_base_gps_time_update *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_gps_time_update, sizeof(required_gps_time_update));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->field_id, 1);
    mip_read_group(r, 2, 2);
    mip_read_u32(r, &v->value, 1);
    v->present = mip_read_present(r);
}

static void write_gps_time_update(struct mip_writer *w, const void *value) {
    const struct mip_base_gps_time_update *v = (const struct mip_base_gps_time_update *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_gps_time_update, sizeof(required_gps_time_update),
                       v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->field_id, 1);
    mip_write_group(w, 2, 2);
    mip_write_u32(w, &v->value, 1);
}

static bool silent_gps_time_update(const void *value) {
    const struct mip_base_gps_time_update *v = (const struct mip_base_gps_time_update *)value;
    return v->function == MIP_FUNCTION_SELECTOR_APPLY;
}

static bool asked_gps_time_update_1(const void *value) {
    const struct mip_base_gps_time_update *v = (const struct mip_base_gps_time_update *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ && v->field_id == 1;
}

static bool asked_gps_time_update_2(const void *value) {
    const struct mip_base_gps_time_update *v = (const struct mip_base_gps_time_update *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ && v->field_id == 2;
}

static const struct mip_response responses_gps_time_update[] = {
    {&mip_base_gps_time_update_week_number_response_codec, asked_gps_time_update_1},
    {&mip_base_gps_time_update_tow_response_codec, asked_gps_time_update_2},
    {NULL, NULL},
};

const struct mip_codec mip_base_gps_time_update_codec = {
    0x01, /* descriptor set */
    MIP_BASE_GPS_TIME_UPDATE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_base_gps_time_update),
    0, /* time-out */
    read_gps_time_update,
    write_gps_time_update,
    silent_gps_time_update,
    responses_gps_time_update,
    NULL,
};

mip_error mip_base_gps_time_update_decode(struct mip_base_gps_time_update *value,
                                          const struct mip_field *field) {
    return mip_decode_field(field, read_gps_time_update, value, sizeof(*value), NULL);
}

mip_error mip_base_gps_time_update_encode(const struct mip_base_gps_time_update *value,
                                          struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_BASE_GPS_TIME_UPDATE_DESCRIPTOR,
                            write_gps_time_update, value);
}

struct mip_base_gps_time_update mip_base_gps_time_update_write(mip_base_gps_time_field field_id,
                                                               uint32_t value) {
    struct mip_base_gps_time_update v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.field_id = field_id;
    v.value = value;
    return v;
}

struct mip_base_gps_time_update mip_base_gps_time_update_read(mip_base_gps_time_field field_id) {
    struct mip_base_gps_time_update v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    v.field_id = field_id;
    return v;
}

struct mip_base_gps_time_update mip_base_gps_time_update_apply(mip_base_gps_time_field field_id,
                                                               uint32_t value) {
    struct mip_base_gps_time_update v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_APPLY;
    v.field_id = field_id;
    v.value = value;
    return v;
}

static void read_gps_time_update_week_number_response(struct mip_reader *r, void *value) {
    struct mip_base_gps_time_update_week_number_response *v =
        (struct mip_base_gps_time_update_week_number_response *)value;
    mip_read_u32(r, &v->week_number, 1);
}

static void write_gps_time_update_week_number_response(struct mip_writer *w, const void *value) {
    const struct mip_base_gps_time_update_week_number_response *v =
        (const struct mip_base_gps_time_update_week_number_response *)value;
    mip_write_u32(w, &v->week_number, 1);
}

const struct mip_codec mip_base_gps_time_update_week_number_response_codec = {
    0x01, /* descriptor set */
    MIP_BASE_GPS_TIME_UPDATE_WEEK_NUMBER_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_base_gps_time_update_week_number_response),
    0, /* time-out */
    read_gps_time_update_week_number_response,
    write_gps_time_update_week_number_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_base_gps_time_update_week_number_response_decode(
    struct mip_base_gps_time_update_week_number_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_gps_time_update_week_number_response, value, sizeof(*value),
                            NULL);
}

mip_error mip_base_gps_time_update_week_number_response_encode(
    const struct mip_base_gps_time_update_week_number_response *value,
    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_BASE_GPS_TIME_UPDATE_WEEK_NUMBER_RESPONSE_DESCRIPTOR,
                            write_gps_time_update_week_number_response, value);
}

static void read_gps_time_update_tow_response(struct mip_reader *r, void *value) {
    struct mip_base_gps_time_update_tow_response *v =
        (struct mip_base_gps_time_update_tow_response *)value;
    mip_read_u32(r, &v->tow, 1);
}

static void write_gps_time_update_tow_response(struct mip_writer *w, const void *value) {
    const struct mip_base_gps_time_update_tow_response *v =
        (const struct mip_base_gps_time_update_tow_response *)value;
    mip_write_u32(w, &v->tow, 1);
}

const struct mip_codec mip_base_gps_time_update_tow_response_codec = {
    0x01, /* descriptor set */
    MIP_BASE_GPS_TIME_UPDATE_TOW_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_base_gps_time_update_tow_response),
    0, /* time-out */
    read_gps_time_update_tow_response,
    write_gps_time_update_tow_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_base_gps_time_update_tow_response_decode(
    struct mip_base_gps_time_update_tow_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_gps_time_update_tow_response, value, sizeof(*value), NULL);
}

mip_error mip_base_gps_time_update_tow_response_encode(
    const struct mip_base_gps_time_update_tow_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_BASE_GPS_TIME_UPDATE_TOW_RESPONSE_DESCRIPTOR,
                            write_gps_time_update_tow_response, value);
}

const struct mip_codec mip_base_soft_reset_codec = {
    0x01, /* descriptor set */
    MIP_BASE_SOFT_RESET_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_base_soft_reset),
    0, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    NULL,
    NULL,
};

mip_error mip_base_soft_reset_decode(struct mip_base_soft_reset *value,
                                     const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_base_soft_reset_encode(const struct mip_base_soft_reset *value,
                                     struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_BASE_SOFT_RESET_DESCRIPTOR, mip_write_nothing,
                            value);
}
