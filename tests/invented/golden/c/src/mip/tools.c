/* Tools. */
#include "mip/tools.h"

#include <string.h>

void mip_tools_bars_read(struct mip_reader *r, struct mip_tools_bars *v) {
    mip_read_double(r, &v->width, 1);
    mip_read_float(r, &v->angle, 1);
}

void mip_tools_bars_write(struct mip_writer *w, const struct mip_tools_bars *v) {
    mip_write_double(w, &v->width, 1);
    mip_write_float(w, &v->angle, 1);
}

void mip_tools_circle_read(struct mip_reader *r, struct mip_tools_circle *v) {
    mip_point_read(r, &v->center);
    mip_read_u8(r, &v->fill, 1);
    switch (v->fill) {
    case MIP_TOOLS_FILL_SOLID:
        mip_read_u32(r, &v->filling.solid, 1);
        break;
    case MIP_TOOLS_FILL_STRIPED:
        mip_tools_bars_read(r, &v->filling.striped);
        break;
    default:
        break;
    }
}

void mip_tools_circle_write(struct mip_writer *w, const struct mip_tools_circle *v) {
    mip_point_write(w, &v->center);
    mip_write_u8(w, &v->fill, 1);
    switch (v->fill) {
    case MIP_TOOLS_FILL_SOLID:
        mip_write_u32(w, &v->filling.solid, 1);
        break;
    case MIP_TOOLS_FILL_STRIPED:
        mip_tools_bars_write(w, &v->filling.striped);
        break;
    default:
        break;
    }
}

void mip_tools_path_read(struct mip_reader *r, struct mip_tools_path *v) {
    mip_read_bool(r, &v->closed, 1);
    mip_read_u8(r, &v->num_points, 1);
    for (size_t i = 0, n = mip_read_count(r, v->num_points, 62, 4); i < n; i++) {
        mip_point_read(r, &v->points[i]);
    }
}

void mip_tools_path_write(struct mip_writer *w, const struct mip_tools_path *v) {
    mip_write_bool(w, &v->closed, 1);
    mip_write_u8(w, &v->num_points, 1);
    for (size_t i = 0, n = mip_write_count(w, v->num_points, 62); i < n; i++) {
        mip_point_write(w, &v->points[i]);
    }
}

void mip_tools_reading_read(struct mip_reader *r, struct mip_tools_reading *v) {
    mip_read_u8(r, &v->kind, 1);
    mip_read_float(r, &v->value, 1);
}

void mip_tools_reading_write(struct mip_writer *w, const struct mip_tools_reading *v) {
    mip_write_u8(w, &v->kind, 1);
    mip_write_float(w, &v->value, 1);
}

const struct mip_codec mip_tools_ping_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_PING_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_tools_ping),
    0, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    NULL,
    NULL,
};

mip_error mip_tools_ping_decode(struct mip_tools_ping *value, const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_tools_ping_encode(const struct mip_tools_ping *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_PING_DESCRIPTOR, mip_write_nothing, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_settings[] = {0, 3, 2, 1, 1, 1, 3};

static void read_settings(struct mip_reader *r, void *value) {
    struct mip_tools_settings *v = (struct mip_tools_settings *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_settings, sizeof(required_settings));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->port, 1);
    mip_read_group(r, 2, 2);
    mip_read_u8(r, &v->mode, 1);
    mip_read_group(r, 3, 3);
    mip_read_u32(r, &v->baud, 1);
    mip_read_group(r, 4, 4);
    mip_read_u16(r, &v->limit, 1);
    mip_read_group(r, 5, 5);
    mip_read_u8(r, &v->reserved, 1);
    v->present = mip_read_present(r);
}

static void write_settings(struct mip_writer *w, const void *value) {
    const struct mip_tools_settings *v = (const struct mip_tools_settings *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_settings, sizeof(required_settings), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->port, 1);
    mip_write_group(w, 2, 2);
    mip_write_u8(w, &v->mode, 1);
    mip_write_group(w, 3, 3);
    mip_write_u32(w, &v->baud, 1);
    mip_write_group(w, 4, 4);
    mip_write_u16(w, &v->limit, 1);
    mip_write_group(w, 5, 5);
    mip_write_u8(w, &v->reserved, 1);
}

static bool silent_settings(const void *value) {
    const struct mip_tools_settings *v = (const struct mip_tools_settings *)value;
    return v->function == MIP_FUNCTION_SELECTOR_APPLY;
}

static bool asked_settings_1(const void *value) {
    const struct mip_tools_settings *v = (const struct mip_tools_settings *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_settings[] = {
    {&mip_tools_settings_response_codec, asked_settings_1},
    {NULL, NULL},
};

const struct mip_codec mip_tools_settings_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_SETTINGS_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_tools_settings),
    0, /* time-out */
    read_settings,
    write_settings,
    silent_settings,
    responses_settings,
    NULL,
};

mip_error mip_tools_settings_decode(struct mip_tools_settings *value,
                                    const struct mip_field *field) {
    return mip_decode_field(field, read_settings, value, sizeof(*value), NULL);
}

mip_error mip_tools_settings_encode(const struct mip_tools_settings *value,
                                    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_SETTINGS_DESCRIPTOR, write_settings, value);
}

struct mip_tools_settings mip_tools_settings_write(uint8_t port, mip_mode mode, uint32_t baud) {
    struct mip_tools_settings v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.port = port;
    v.mode = mode;
    v.baud = baud;
    v.reserved = 1;
    return v;
}

struct mip_tools_settings mip_tools_settings_read(uint8_t port, mip_mode mode) {
    struct mip_tools_settings v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    v.port = port;
    v.mode = mode;
    v.reserved = 1;
    return v;
}

struct mip_tools_settings mip_tools_settings_save(uint8_t port) {
    struct mip_tools_settings v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    v.port = port;
    v.reserved = 1;
    return v;
}

struct mip_tools_settings mip_tools_settings_load(uint8_t port) {
    struct mip_tools_settings v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    v.port = port;
    v.reserved = 1;
    return v;
}

struct mip_tools_settings mip_tools_settings_default(uint8_t port) {
    struct mip_tools_settings v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    v.port = port;
    v.reserved = 1;
    return v;
}

struct mip_tools_settings mip_tools_settings_apply(uint8_t port, mip_mode mode, uint32_t baud) {
    struct mip_tools_settings v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_APPLY;
    v.port = port;
    v.mode = mode;
    v.baud = baud;
    v.reserved = 1;
    return v;
}

static void read_settings_response(struct mip_reader *r, void *value) {
    struct mip_tools_settings_response *v = (struct mip_tools_settings_response *)value;
    mip_read_u8(r, &v->port, 1);
    mip_read_u8(r, &v->mode, 1);
    mip_read_u32(r, &v->baud, 1);
    mip_read_u16(r, &v->limit, 1);
    mip_read_u8(r, &v->reserved, 1);
}

static void write_settings_response(struct mip_writer *w, const void *value) {
    const struct mip_tools_settings_response *v = (const struct mip_tools_settings_response *)value;
    mip_write_u8(w, &v->port, 1);
    mip_write_u8(w, &v->mode, 1);
    mip_write_u32(w, &v->baud, 1);
    mip_write_u16(w, &v->limit, 1);
    mip_write_u8(w, &v->reserved, 1);
}

const struct mip_codec mip_tools_settings_response_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_SETTINGS_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_tools_settings_response),
    0, /* time-out */
    read_settings_response,
    write_settings_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_tools_settings_response_decode(struct mip_tools_settings_response *value,
                                             const struct mip_field *field) {
    return mip_decode_field(field, read_settings_response, value, sizeof(*value), NULL);
}

mip_error mip_tools_settings_response_encode(const struct mip_tools_settings_response *value,
                                             struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_SETTINGS_RESPONSE_DESCRIPTOR,
                            write_settings_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_set_time[] = {0, 2, 1, 0, 0, 0, 2};

static void read_set_time(struct mip_reader *r, void *value) {
    struct mip_tools_set_time *v = (struct mip_tools_set_time *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_set_time, sizeof(required_set_time));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->part, 1);
    mip_read_group(r, 2, 2);
    mip_read_u32(r, &v->value, 1);
    v->present = mip_read_present(r);
}

static void write_set_time(struct mip_writer *w, const void *value) {
    const struct mip_tools_set_time *v = (const struct mip_tools_set_time *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_set_time, sizeof(required_set_time), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->part, 1);
    mip_write_group(w, 2, 2);
    mip_write_u32(w, &v->value, 1);
}

static bool silent_set_time(const void *value) {
    const struct mip_tools_set_time *v = (const struct mip_tools_set_time *)value;
    return v->function == MIP_FUNCTION_SELECTOR_APPLY;
}

static bool asked_set_time_1(const void *value) {
    const struct mip_tools_set_time *v = (const struct mip_tools_set_time *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ && v->part == 1;
}

static bool asked_set_time_2(const void *value) {
    const struct mip_tools_set_time *v = (const struct mip_tools_set_time *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ && v->part == 2;
}

static const struct mip_response responses_set_time[] = {
    {&mip_tools_set_time_fast_response_codec, asked_set_time_1},
    {&mip_tools_set_time_slow_response_codec, asked_set_time_2},
    {NULL, NULL},
};

const struct mip_codec mip_tools_set_time_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_SET_TIME_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_tools_set_time),
    0, /* time-out */
    read_set_time,
    write_set_time,
    silent_set_time,
    responses_set_time,
    NULL,
};

mip_error mip_tools_set_time_decode(struct mip_tools_set_time *value,
                                    const struct mip_field *field) {
    return mip_decode_field(field, read_set_time, value, sizeof(*value), NULL);
}

mip_error mip_tools_set_time_encode(const struct mip_tools_set_time *value,
                                    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_SET_TIME_DESCRIPTOR, write_set_time, value);
}

struct mip_tools_set_time mip_tools_set_time_write(mip_mode part, uint32_t value) {
    struct mip_tools_set_time v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.part = part;
    v.value = value;
    return v;
}

struct mip_tools_set_time mip_tools_set_time_read(mip_mode part) {
    struct mip_tools_set_time v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    v.part = part;
    return v;
}

struct mip_tools_set_time mip_tools_set_time_apply(mip_mode part, uint32_t value) {
    struct mip_tools_set_time v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_APPLY;
    v.part = part;
    v.value = value;
    return v;
}

static void read_set_time_fast_response(struct mip_reader *r, void *value) {
    struct mip_tools_set_time_fast_response *v = (struct mip_tools_set_time_fast_response *)value;
    mip_read_u32(r, &v->value, 1);
}

static void write_set_time_fast_response(struct mip_writer *w, const void *value) {
    const struct mip_tools_set_time_fast_response *v =
        (const struct mip_tools_set_time_fast_response *)value;
    mip_write_u32(w, &v->value, 1);
}

const struct mip_codec mip_tools_set_time_fast_response_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_SET_TIME_FAST_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_tools_set_time_fast_response),
    0, /* time-out */
    read_set_time_fast_response,
    write_set_time_fast_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_tools_set_time_fast_response_decode(struct mip_tools_set_time_fast_response *value,
                                                  const struct mip_field *field) {
    return mip_decode_field(field, read_set_time_fast_response, value, sizeof(*value), NULL);
}

mip_error mip_tools_set_time_fast_response_encode(
    const struct mip_tools_set_time_fast_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_SET_TIME_FAST_RESPONSE_DESCRIPTOR,
                            write_set_time_fast_response, value);
}

static void read_set_time_slow_response(struct mip_reader *r, void *value) {
    struct mip_tools_set_time_slow_response *v = (struct mip_tools_set_time_slow_response *)value;
    mip_read_u32(r, &v->value, 1);
}

static void write_set_time_slow_response(struct mip_writer *w, const void *value) {
    const struct mip_tools_set_time_slow_response *v =
        (const struct mip_tools_set_time_slow_response *)value;
    mip_write_u32(w, &v->value, 1);
}

const struct mip_codec mip_tools_set_time_slow_response_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_SET_TIME_SLOW_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_tools_set_time_slow_response),
    0, /* time-out */
    read_set_time_slow_response,
    write_set_time_slow_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_tools_set_time_slow_response_decode(struct mip_tools_set_time_slow_response *value,
                                                  const struct mip_field *field) {
    return mip_decode_field(field, read_set_time_slow_response, value, sizeof(*value), NULL);
}

mip_error mip_tools_set_time_slow_response_encode(
    const struct mip_tools_set_time_slow_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_SET_TIME_SLOW_RESPONSE_DESCRIPTOR,
                            write_set_time_slow_response, value);
}

static void read_status(struct mip_reader *r, void *value) {
    struct mip_tools_status *v = (struct mip_tools_status *)value;
    mip_read_constant(r, 4711, 2);
    mip_read_u8(r, &v->selector, 1);
}

static void write_status(struct mip_writer *w, const void *value) {
    const struct mip_tools_status *v = (const struct mip_tools_status *)value;
    mip_write_constant(w, 4711, 2);
    mip_write_u8(w, &v->selector, 1);
}

static bool asked_status_1(const void *value) {
    const struct mip_tools_status *v = (const struct mip_tools_status *)value;

    return v->selector == 1;
}

static bool asked_status_2(const void *value) {
    const struct mip_tools_status *v = (const struct mip_tools_status *)value;

    return v->selector == 2;
}

static const struct mip_response responses_status[] = {
    {&mip_tools_status_short_codec, asked_status_1},
    {&mip_tools_status_long_codec, asked_status_2},
    {&mip_tools_status_old_codec, asked_status_2},
    {&mip_tools_full_codec, asked_status_2},
    {NULL, NULL},
};

const struct mip_codec mip_tools_status_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_STATUS_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_tools_status),
    2500, /* time-out */
    read_status,
    write_status,
    NULL,
    responses_status,
    NULL,
};

mip_error mip_tools_status_decode(struct mip_tools_status *value, const struct mip_field *field) {
    return mip_decode_field(field, read_status, value, sizeof(*value), NULL);
}

mip_error mip_tools_status_encode(const struct mip_tools_status *value,
                                  struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_STATUS_DESCRIPTOR, write_status, value);
}

struct mip_tools_status mip_tools_status_make(uint8_t selector) {
    struct mip_tools_status v;
    memset(&v, 0, sizeof(v));
    v.selector = selector;
    return v;
}

static void read_status_short(struct mip_reader *r, void *value) {
    struct mip_tools_status_short *v = (struct mip_tools_status_short *)value;
    mip_read_constant(r, 4711, 2);
    mip_read_constant(r, 1, 1);
    mip_read_u32(r, &v->flags, 1);
}

static void write_status_short(struct mip_writer *w, const void *value) {
    const struct mip_tools_status_short *v = (const struct mip_tools_status_short *)value;
    mip_write_constant(w, 4711, 2);
    mip_write_constant(w, 1, 1);
    mip_write_u32(w, &v->flags, 1);
}

static const struct mip_constant constants_status_short[] = {
    {0, 2, 4711},
    {2, 1, 1},
};
static const struct mip_layout layout_status_short = {
    0,
    253, /* bytes of data */
    2,
    constants_status_short,
};

const struct mip_codec mip_tools_status_short_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_STATUS_SHORT_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_tools_status_short),
    0, /* time-out */
    read_status_short,
    write_status_short,
    NULL,
    NULL,
    &layout_status_short,
};

mip_error mip_tools_status_short_decode(struct mip_tools_status_short *value,
                                        const struct mip_field *field) {
    return mip_decode_field(field, read_status_short, value, sizeof(*value), NULL);
}

mip_error mip_tools_status_short_encode(const struct mip_tools_status_short *value,
                                        struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_STATUS_SHORT_DESCRIPTOR, write_status_short,
                            value);
}

static void read_status_long(struct mip_reader *r, void *value) {
    struct mip_tools_status_long *v = (struct mip_tools_status_long *)value;
    mip_read_constant(r, 4711, 2);
    mip_read_constant(r, 2, 1);
    mip_read_u32(r, &v->flags, 1);
    mip_read_u64(r, &v->uptime, 1);
}

static void write_status_long(struct mip_writer *w, const void *value) {
    const struct mip_tools_status_long *v = (const struct mip_tools_status_long *)value;
    mip_write_constant(w, 4711, 2);
    mip_write_constant(w, 2, 1);
    mip_write_u32(w, &v->flags, 1);
    mip_write_u64(w, &v->uptime, 1);
}

static const struct mip_constant constants_status_long[] = {
    {0, 2, 4711},
    {2, 1, 2},
};
static const struct mip_layout layout_status_long = {
    15,
    15, /* bytes of data */
    2,
    constants_status_long,
};

const struct mip_codec mip_tools_status_long_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_STATUS_LONG_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_tools_status_long),
    0, /* time-out */
    read_status_long,
    write_status_long,
    NULL,
    NULL,
    &layout_status_long,
};

mip_error mip_tools_status_long_decode(struct mip_tools_status_long *value,
                                       const struct mip_field *field) {
    return mip_decode_field(field, read_status_long, value, sizeof(*value), NULL);
}

mip_error mip_tools_status_long_encode(const struct mip_tools_status_long *value,
                                       struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_STATUS_LONG_DESCRIPTOR, write_status_long,
                            value);
}

static void read_status_old(struct mip_reader *r, void *value) {
    struct mip_tools_status_old *v = (struct mip_tools_status_old *)value;
    mip_read_constant(r, 4711, 2);
    mip_read_constant(r, 2, 1);
    mip_read_u32(r, &v->uptime, 1);
}

static void write_status_old(struct mip_writer *w, const void *value) {
    const struct mip_tools_status_old *v = (const struct mip_tools_status_old *)value;
    mip_write_constant(w, 4711, 2);
    mip_write_constant(w, 2, 1);
    mip_write_u32(w, &v->uptime, 1);
}

static const struct mip_constant constants_status_old[] = {
    {0, 2, 4711},
    {2, 1, 2},
};
static const struct mip_layout layout_status_old = {
    0,
    14, /* bytes of data */
    2,
    constants_status_old,
};

const struct mip_codec mip_tools_status_old_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_STATUS_OLD_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_tools_status_old),
    0, /* time-out */
    read_status_old,
    write_status_old,
    NULL,
    NULL,
    &layout_status_old,
};

mip_error mip_tools_status_old_decode(struct mip_tools_status_old *value,
                                      const struct mip_field *field) {
    return mip_decode_field(field, read_status_old, value, sizeof(*value), NULL);
}

mip_error mip_tools_status_old_encode(const struct mip_tools_status_old *value,
                                      struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_STATUS_OLD_DESCRIPTOR, write_status_old,
                            value);
}

static void read_status_full(struct mip_reader *r, void *value) {
    struct mip_tools_full *v = (struct mip_tools_full *)value;
    mip_read_constant(r, 4711, 2);
    mip_read_constant(r, 2, 1);
    mip_point_read(r, &v->place);
    mip_read_u64(r, &v->uptime, 1);
    mip_read_u8(r, &v->mode, 1);
}

static void write_status_full(struct mip_writer *w, const void *value) {
    const struct mip_tools_full *v = (const struct mip_tools_full *)value;
    mip_write_constant(w, 4711, 2);
    mip_write_constant(w, 2, 1);
    mip_point_write(w, &v->place);
    mip_write_u64(w, &v->uptime, 1);
    mip_write_u8(w, &v->mode, 1);
}

static const struct mip_constant constants_status_full[] = {
    {0, 2, 4711},
    {2, 1, 2},
};
static const struct mip_layout layout_status_full = {
    16,
    253, /* bytes of data */
    2,
    constants_status_full,
};

const struct mip_codec mip_tools_full_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_FULL_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_tools_full),
    0, /* time-out */
    read_status_full,
    write_status_full,
    NULL,
    NULL,
    &layout_status_full,
};

mip_error mip_tools_full_decode(struct mip_tools_full *value, const struct mip_field *field) {
    return mip_decode_field(field, read_status_full, value, sizeof(*value), NULL);
}

mip_error mip_tools_full_encode(const struct mip_tools_full *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_FULL_DESCRIPTOR, write_status_full, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_bias[] = {0, 1, 0, 0, 0, 0};

static void read_bias(struct mip_reader *r, void *value) {
    struct mip_tools_bias *v = (struct mip_tools_bias *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_bias, sizeof(required_bias));
    mip_read_group(r, 1, 1);
    mip_read_float(r, v->bias, 3);
    v->present = mip_read_present(r);
}

static void write_bias(struct mip_writer *w, const void *value) {
    const struct mip_tools_bias *v = (const struct mip_tools_bias *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_bias, sizeof(required_bias), v->present);
    mip_write_group(w, 1, 1);
    mip_write_float(w, v->bias, 3);
}

static bool asked_bias_1(const void *value) {
    const struct mip_tools_bias *v = (const struct mip_tools_bias *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_bias[] = {
    {&mip_tools_bias_vector_codec, asked_bias_1},
    {NULL, NULL},
};

const struct mip_codec mip_tools_bias_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_BIAS_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_tools_bias),
    0, /* time-out */
    read_bias,
    write_bias,
    NULL,
    responses_bias,
    NULL,
};

mip_error mip_tools_bias_decode(struct mip_tools_bias *value, const struct mip_field *field) {
    return mip_decode_field(field, read_bias, value, sizeof(*value), NULL);
}

mip_error mip_tools_bias_encode(const struct mip_tools_bias *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_BIAS_DESCRIPTOR, write_bias, value);
}

struct mip_tools_bias mip_tools_bias_write(const float bias[3]) {
    struct mip_tools_bias v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(v.bias, bias, sizeof(v.bias));
    return v;
}

struct mip_tools_bias mip_tools_bias_read(void) {
    struct mip_tools_bias v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_tools_bias mip_tools_bias_save(void) {
    struct mip_tools_bias v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_tools_bias mip_tools_bias_load(void) {
    struct mip_tools_bias v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_tools_bias mip_tools_bias_default(void) {
    struct mip_tools_bias v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_bias_vector(struct mip_reader *r, void *value) {
    struct mip_tools_bias_vector *v = (struct mip_tools_bias_vector *)value;
    mip_read_float(r, v->bias, 3);
}

static void write_bias_vector(struct mip_writer *w, const void *value) {
    const struct mip_tools_bias_vector *v = (const struct mip_tools_bias_vector *)value;
    mip_write_float(w, v->bias, 3);
}

const struct mip_codec mip_tools_bias_vector_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_BIAS_VECTOR_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_tools_bias_vector),
    0, /* time-out */
    read_bias_vector,
    write_bias_vector,
    NULL,
    NULL,
    NULL,
};

mip_error mip_tools_bias_vector_decode(struct mip_tools_bias_vector *value,
                                       const struct mip_field *field) {
    return mip_decode_field(field, read_bias_vector, value, sizeof(*value), NULL);
}

mip_error mip_tools_bias_vector_encode(const struct mip_tools_bias_vector *value,
                                       struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_BIAS_VECTOR_DESCRIPTOR, write_bias_vector,
                            value);
}

static void read_capture_bias(struct mip_reader *r, void *value) {
    struct mip_tools_capture_bias *v = (struct mip_tools_capture_bias *)value;
    mip_read_u16(r, &v->time, 1);
}

static void write_capture_bias(struct mip_writer *w, const void *value) {
    const struct mip_tools_capture_bias *v = (const struct mip_tools_capture_bias *)value;
    mip_write_u16(w, &v->time, 1);
}

static const struct mip_response responses_capture_bias[] = {
    {&mip_tools_bias_vector_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_tools_capture_bias_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_CAPTURE_BIAS_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_tools_capture_bias),
    0, /* time-out */
    read_capture_bias,
    write_capture_bias,
    NULL,
    responses_capture_bias,
    NULL,
};

mip_error mip_tools_capture_bias_decode(struct mip_tools_capture_bias *value,
                                        const struct mip_field *field) {
    return mip_decode_field(field, read_capture_bias, value, sizeof(*value), NULL);
}

mip_error mip_tools_capture_bias_encode(const struct mip_tools_capture_bias *value,
                                        struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_CAPTURE_BIAS_DESCRIPTOR, write_capture_bias,
                            value);
}

struct mip_tools_capture_bias mip_tools_capture_bias_make(uint16_t time) {
    struct mip_tools_capture_bias v;
    memset(&v, 0, sizeof(v));
    v.time = time;
    return v;
}

static void read_formats(struct mip_reader *r, void *value) {
    struct mip_tools_formats *v = (struct mip_tools_formats *)value;
    mip_read_bool(r, &v->suppress_ack, 1);
    mip_read_u8(r, &v->num_segments, 1);
    mip_read_u8(r, &v->checkpoint, 1);
    for (size_t i = 0, n = mip_read_count(r, v->num_segments, 25, 10); i < n; i++) {
        mip_segment_read(r, &v->segments[i]);
    }
}

static void write_formats(struct mip_writer *w, const void *value) {
    const struct mip_tools_formats *v = (const struct mip_tools_formats *)value;
    mip_write_bool(w, &v->suppress_ack, 1);
    mip_write_u8(w, &v->num_segments, 1);
    mip_write_u8(w, &v->checkpoint, 1);
    for (size_t i = 0, n = mip_write_count(w, v->num_segments, 25); i < n; i++) {
        mip_segment_write(w, &v->segments[i]);
    }
}

static bool silent_formats(const void *value) {
    const struct mip_tools_formats *v = (const struct mip_tools_formats *)value;
    return v->suppress_ack == 1;
}

const struct mip_codec mip_tools_formats_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_FORMATS_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_tools_formats),
    0, /* time-out */
    read_formats,
    write_formats,
    silent_formats,
    NULL,
    NULL,
};

mip_error mip_tools_formats_decode(struct mip_tools_formats *value, const struct mip_field *field) {
    return mip_decode_field(field, read_formats, value, sizeof(*value), NULL);
}

mip_error mip_tools_formats_encode(const struct mip_tools_formats *value,
                                   struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_FORMATS_DESCRIPTOR, write_formats, value);
}

struct mip_tools_formats mip_tools_formats_make(mip_bool suppress_ack, uint8_t num_segments,
                                                uint8_t checkpoint,
                                                const struct mip_segment segments[]) {
    struct mip_tools_formats v;
    memset(&v, 0, sizeof(v));
    v.suppress_ack = suppress_ack;
    v.num_segments = num_segments;
    v.checkpoint = checkpoint;
    mip_copy(v.segments, sizeof(v.segments), segments, num_segments * sizeof(segments[0]));
    return v;
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_choice[] = {0, 3, 1};

static void read_choice(struct mip_reader *r, void *value) {
    struct mip_tools_choice *v = (struct mip_tools_choice *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_choice, sizeof(required_choice));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->instance, 1);
    mip_read_group(r, 2, 2);
    mip_read_u8(r, &v->shape, 1);
    mip_read_group(r, 3, 3);
    switch (v->shape) {
    case MIP_TOOLS_SHAPE_CIRCLE:
        mip_tools_circle_read(r, &v->parameters.circle);
        break;
    case MIP_TOOLS_SHAPE_PATH:
        mip_tools_path_read(r, &v->parameters.path);
        break;
    case MIP_TOOLS_SHAPE_TURN:
        mip_read_float(r, v->parameters.rotation, 4);
        break;
    case MIP_TOOLS_SHAPE_LABEL:
        mip_read_char(r, v->parameters.label, 8);
        break;
    default:
        break;
    }
    v->present = mip_read_present(r);
}

static void write_choice(struct mip_writer *w, const void *value) {
    const struct mip_tools_choice *v = (const struct mip_tools_choice *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_choice, sizeof(required_choice), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->instance, 1);
    mip_write_group(w, 2, 2);
    mip_write_u8(w, &v->shape, 1);
    mip_write_group(w, 3, 3);
    switch (v->shape) {
    case MIP_TOOLS_SHAPE_CIRCLE:
        mip_tools_circle_write(w, &v->parameters.circle);
        break;
    case MIP_TOOLS_SHAPE_PATH:
        mip_tools_path_write(w, &v->parameters.path);
        break;
    case MIP_TOOLS_SHAPE_TURN:
        mip_write_float(w, v->parameters.rotation, 4);
        break;
    case MIP_TOOLS_SHAPE_LABEL:
        mip_write_char(w, v->parameters.label, 8);
        break;
    default:
        break;
    }
}

static bool asked_choice_1(const void *value) {
    const struct mip_tools_choice *v = (const struct mip_tools_choice *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_choice[] = {
    {&mip_tools_choice_response_codec, asked_choice_1},
    {NULL, NULL},
};

const struct mip_codec mip_tools_choice_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_CHOICE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_tools_choice),
    0, /* time-out */
    read_choice,
    write_choice,
    NULL,
    responses_choice,
    NULL,
};

mip_error mip_tools_choice_decode(struct mip_tools_choice *value, const struct mip_field *field) {
    return mip_decode_field(field, read_choice, value, sizeof(*value), NULL);
}

mip_error mip_tools_choice_encode(const struct mip_tools_choice *value,
                                  struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_CHOICE_DESCRIPTOR, write_choice, value);
}

struct mip_tools_choice mip_tools_choice_write(
    uint8_t instance, mip_tools_shape shape, const union mip_tools_choice_parameters *parameters) {
    struct mip_tools_choice v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.instance = instance;
    v.shape = shape;
    if (parameters != NULL) {
        v.parameters = *parameters;
    }
    return v;
}

struct mip_tools_choice mip_tools_choice_read(uint8_t instance) {
    struct mip_tools_choice v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    v.instance = instance;
    return v;
}

static void read_choice_response(struct mip_reader *r, void *value) {
    struct mip_tools_choice_response *v = (struct mip_tools_choice_response *)value;
    mip_read_u8(r, &v->instance, 1);
    mip_read_u8(r, &v->shape, 1);
    switch (v->shape) {
    case MIP_TOOLS_SHAPE_CIRCLE:
        mip_tools_circle_read(r, &v->parameters.circle);
        break;
    case MIP_TOOLS_SHAPE_PATH:
        mip_tools_path_read(r, &v->parameters.path);
        break;
    case MIP_TOOLS_SHAPE_TURN:
        mip_read_float(r, v->parameters.rotation, 4);
        break;
    case MIP_TOOLS_SHAPE_LABEL:
        mip_read_char(r, v->parameters.label, 8);
        break;
    default:
        break;
    }
}

static void write_choice_response(struct mip_writer *w, const void *value) {
    const struct mip_tools_choice_response *v = (const struct mip_tools_choice_response *)value;
    mip_write_u8(w, &v->instance, 1);
    mip_write_u8(w, &v->shape, 1);
    switch (v->shape) {
    case MIP_TOOLS_SHAPE_CIRCLE:
        mip_tools_circle_write(w, &v->parameters.circle);
        break;
    case MIP_TOOLS_SHAPE_PATH:
        mip_tools_path_write(w, &v->parameters.path);
        break;
    case MIP_TOOLS_SHAPE_TURN:
        mip_write_float(w, v->parameters.rotation, 4);
        break;
    case MIP_TOOLS_SHAPE_LABEL:
        mip_write_char(w, v->parameters.label, 8);
        break;
    default:
        break;
    }
}

const struct mip_codec mip_tools_choice_response_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_CHOICE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_tools_choice_response),
    0, /* time-out */
    read_choice_response,
    write_choice_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_tools_choice_response_decode(struct mip_tools_choice_response *value,
                                           const struct mip_field *field) {
    return mip_decode_field(field, read_choice_response, value, sizeof(*value), NULL);
}

mip_error mip_tools_choice_response_encode(const struct mip_tools_choice_response *value,
                                           struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_CHOICE_RESPONSE_DESCRIPTOR,
                            write_choice_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_list[] = {0, 2, 0, 0};

static void read_list(struct mip_reader *r, void *value) {
    struct mip_tools_list *v = (struct mip_tools_list *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_list, sizeof(required_list));
    mip_read_group(r, 1, 2);
    mip_read_u8(r, &v->count, 1);
    mip_read_u16(r, v->items, mip_read_count(r, v->count, 125, 2));
    v->present = mip_read_present(r);
}

static void write_list(struct mip_writer *w, const void *value) {
    const struct mip_tools_list *v = (const struct mip_tools_list *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_list, sizeof(required_list), v->present);
    mip_write_group(w, 1, 2);
    mip_write_u8(w, &v->count, 1);
    mip_write_u16(w, v->items, mip_write_count(w, v->count, 125));
}

static bool asked_list_1(const void *value) {
    const struct mip_tools_list *v = (const struct mip_tools_list *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_list[] = {
    {&mip_tools_list_response_codec, asked_list_1},
    {NULL, NULL},
};

const struct mip_codec mip_tools_list_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_LIST_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_tools_list),
    0, /* time-out */
    read_list,
    write_list,
    NULL,
    responses_list,
    NULL,
};

mip_error mip_tools_list_decode(struct mip_tools_list *value, const struct mip_field *field) {
    return mip_decode_field(field, read_list, value, sizeof(*value), NULL);
}

mip_error mip_tools_list_encode(const struct mip_tools_list *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_LIST_DESCRIPTOR, write_list, value);
}

struct mip_tools_list mip_tools_list_write(uint8_t count, const uint16_t items[]) {
    struct mip_tools_list v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.count = count;
    mip_copy(v.items, sizeof(v.items), items, count * sizeof(items[0]));
    return v;
}

struct mip_tools_list mip_tools_list_read(void) {
    struct mip_tools_list v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_tools_list mip_tools_list_save(void) {
    struct mip_tools_list v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

static void read_list_response(struct mip_reader *r, void *value) {
    struct mip_tools_list_response *v = (struct mip_tools_list_response *)value;
    mip_read_u8(r, &v->count, 1);
    mip_read_u16(r, v->items, mip_read_count(r, v->count, 126, 2));
}

static void write_list_response(struct mip_writer *w, const void *value) {
    const struct mip_tools_list_response *v = (const struct mip_tools_list_response *)value;
    mip_write_u8(w, &v->count, 1);
    mip_write_u16(w, v->items, mip_write_count(w, v->count, 126));
}

const struct mip_codec mip_tools_list_response_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_LIST_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_tools_list_response),
    0, /* time-out */
    read_list_response,
    write_list_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_tools_list_response_decode(struct mip_tools_list_response *value,
                                         const struct mip_field *field) {
    return mip_decode_field(field, read_list_response, value, sizeof(*value), NULL);
}

mip_error mip_tools_list_response_encode(const struct mip_tools_list_response *value,
                                         struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_LIST_RESPONSE_DESCRIPTOR, write_list_response,
                            value);
}

static const struct mip_response responses_inventory[] = {
    {&mip_tools_stock_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_tools_stock_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_STOCK_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_tools_stock),
    0, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    responses_inventory,
    NULL,
};

mip_error mip_tools_stock_decode(struct mip_tools_stock *value, const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_tools_stock_encode(const struct mip_tools_stock *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_STOCK_DESCRIPTOR, mip_write_nothing, value);
}

static void read_inventory_response(struct mip_reader *r, void *value) {
    struct mip_tools_stock_response *v = (struct mip_tools_stock_response *)value;
    v->descriptors_count = (uint8_t)mip_read_rest(r, 126, 2);
    mip_read_u16(r, v->descriptors, v->descriptors_count);
}

static void write_inventory_response(struct mip_writer *w, const void *value) {
    const struct mip_tools_stock_response *v = (const struct mip_tools_stock_response *)value;
    mip_write_u16(w, v->descriptors, mip_write_count(w, v->descriptors_count, 126));
}

const struct mip_codec mip_tools_stock_response_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_STOCK_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_tools_stock_response),
    0, /* time-out */
    read_inventory_response,
    write_inventory_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_tools_stock_response_decode(struct mip_tools_stock_response *value,
                                          const struct mip_field *field) {
    return mip_decode_field(field, read_inventory_response, value, sizeof(*value), NULL);
}

mip_error mip_tools_stock_response_encode(const struct mip_tools_stock_response *value,
                                          struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_STOCK_RESPONSE_DESCRIPTOR,
                            write_inventory_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_pin[] = {0, 2, 1};

static void read_pin(struct mip_reader *r, void *value) {
    struct mip_tools_pin *v = (struct mip_tools_pin *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_pin, sizeof(required_pin));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->drive, 1);
    mip_read_group(r, 2, 2);
    mip_read_u8(r, &v->use, 1);
    v->present = mip_read_present(r);
}

static void write_pin(struct mip_writer *w, const void *value) {
    const struct mip_tools_pin *v = (const struct mip_tools_pin *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_pin, sizeof(required_pin), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->drive, 1);
    mip_write_group(w, 2, 2);
    mip_write_u8(w, &v->use, 1);
}

static bool asked_pin_1(const void *value) {
    const struct mip_tools_pin *v = (const struct mip_tools_pin *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_pin[] = {
    {&mip_tools_pin_response_codec, asked_pin_1},
    {NULL, NULL},
};

const struct mip_codec mip_tools_pin_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_PIN_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_tools_pin),
    0, /* time-out */
    read_pin,
    write_pin,
    NULL,
    responses_pin,
    NULL,
};

mip_error mip_tools_pin_decode(struct mip_tools_pin *value, const struct mip_field *field) {
    return mip_decode_field(field, read_pin, value, sizeof(*value), NULL);
}

mip_error mip_tools_pin_encode(const struct mip_tools_pin *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_PIN_DESCRIPTOR, write_pin, value);
}

struct mip_tools_pin mip_tools_pin_write(mip_tools_drive drive, uint8_t use) {
    struct mip_tools_pin v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.drive = drive;
    v.use = use;
    return v;
}

struct mip_tools_pin mip_tools_pin_read(mip_tools_drive drive) {
    struct mip_tools_pin v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    v.drive = drive;
    return v;
}

static void read_pin_response(struct mip_reader *r, void *value) {
    struct mip_tools_pin_response *v = (struct mip_tools_pin_response *)value;
    mip_read_u8(r, &v->drive, 1);
    mip_read_u8(r, &v->use, 1);
}

static void write_pin_response(struct mip_writer *w, const void *value) {
    const struct mip_tools_pin_response *v = (const struct mip_tools_pin_response *)value;
    mip_write_u8(w, &v->drive, 1);
    mip_write_u8(w, &v->use, 1);
}

const struct mip_codec mip_tools_pin_response_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_PIN_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_tools_pin_response),
    0, /* time-out */
    read_pin_response,
    write_pin_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_tools_pin_response_decode(struct mip_tools_pin_response *value,
                                        const struct mip_field *field) {
    return mip_decode_field(field, read_pin_response, value, sizeof(*value), NULL);
}

mip_error mip_tools_pin_response_encode(const struct mip_tools_pin_response *value,
                                        struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_PIN_RESPONSE_DESCRIPTOR, write_pin_response,
                            value);
}

static void read_hello(struct mip_reader *r, void *value) {
    struct mip_tools_hello *v = (struct mip_tools_hello *)value;
    mip_read_float(r, &v->reserved, 1);
    mip_read_group(r, 2, 2);
    mip_read_double(r, v->later, 2);
    v->present = mip_read_present(r);
}

static void write_hello(struct mip_writer *w, const void *value) {
    const struct mip_tools_hello *v = (const struct mip_tools_hello *)value;
    w->present = v->present;
    mip_write_float(w, &v->reserved, 1);
    mip_write_group(w, 2, 2);
    mip_write_double(w, v->later, 2);
}

static const struct mip_response responses_hello[] = {
    {&mip_tools_hello_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_tools_hello_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_HELLO_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_tools_hello),
    0, /* time-out */
    read_hello,
    write_hello,
    NULL,
    responses_hello,
    NULL,
};

mip_error mip_tools_hello_decode(struct mip_tools_hello *value, const struct mip_field *field) {
    return mip_decode_field(field, read_hello, value, sizeof(*value), NULL);
}

mip_error mip_tools_hello_encode(const struct mip_tools_hello *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_HELLO_DESCRIPTOR, write_hello, value);
}

static void read_hello_response(struct mip_reader *r, void *value) {
    struct mip_tools_hello_response *v = (struct mip_tools_hello_response *)value;
    mip_read_u32(r, &v->seen, 1);
}

static void write_hello_response(struct mip_writer *w, const void *value) {
    const struct mip_tools_hello_response *v = (const struct mip_tools_hello_response *)value;
    mip_write_u32(w, &v->seen, 1);
}

const struct mip_codec mip_tools_hello_response_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_HELLO_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_tools_hello_response),
    0, /* time-out */
    read_hello_response,
    write_hello_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_tools_hello_response_decode(struct mip_tools_hello_response *value,
                                          const struct mip_field *field) {
    return mip_decode_field(field, read_hello_response, value, sizeof(*value), NULL);
}

mip_error mip_tools_hello_response_encode(const struct mip_tools_hello_response *value,
                                          struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_HELLO_RESPONSE_DESCRIPTOR,
                            write_hello_response, value);
}

static void read_readings(struct mip_reader *r, void *value) {
    struct mip_tools_readings *v = (struct mip_tools_readings *)value;
    mip_read_u8(r, &v->drive, 1);
}

static void write_readings(struct mip_writer *w, const void *value) {
    const struct mip_tools_readings *v = (const struct mip_tools_readings *)value;
    mip_write_u8(w, &v->drive, 1);
}

static const struct mip_response responses_readings[] = {
    {&mip_tools_readings_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_tools_readings_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_READINGS_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_tools_readings),
    0, /* time-out */
    read_readings,
    write_readings,
    NULL,
    responses_readings,
    NULL,
};

mip_error mip_tools_readings_decode(struct mip_tools_readings *value,
                                    const struct mip_field *field) {
    return mip_decode_field(field, read_readings, value, sizeof(*value), NULL);
}

mip_error mip_tools_readings_encode(const struct mip_tools_readings *value,
                                    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_READINGS_DESCRIPTOR, write_readings, value);
}

struct mip_tools_readings mip_tools_readings_make(mip_tools_drive drive) {
    struct mip_tools_readings v;
    memset(&v, 0, sizeof(v));
    v.drive = drive;
    return v;
}

static void read_readings_response(struct mip_reader *r, void *value) {
    struct mip_tools_readings_response *v = (struct mip_tools_readings_response *)value;
    mip_read_u8(r, &v->drive, 1);
    mip_read_u8(r, &v->count, 1);
    for (size_t i = 0, n = mip_read_count(r, v->count, 49, 5); i < n; i++) {
        mip_tools_reading_read(r, &v->readings[i]);
    }
    mip_tools_reading_read(r, &v->last);
}

static void write_readings_response(struct mip_writer *w, const void *value) {
    const struct mip_tools_readings_response *v = (const struct mip_tools_readings_response *)value;
    mip_write_u8(w, &v->drive, 1);
    mip_write_u8(w, &v->count, 1);
    for (size_t i = 0, n = mip_write_count(w, v->count, 49); i < n; i++) {
        mip_tools_reading_write(w, &v->readings[i]);
    }
    mip_tools_reading_write(w, &v->last);
}

const struct mip_codec mip_tools_readings_response_codec = {
    0x01, /* descriptor set */
    MIP_TOOLS_READINGS_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_tools_readings_response),
    0, /* time-out */
    read_readings_response,
    write_readings_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_tools_readings_response_decode(struct mip_tools_readings_response *value,
                                             const struct mip_field *field) {
    return mip_decode_field(field, read_readings_response, value, sizeof(*value), NULL);
}

mip_error mip_tools_readings_response_encode(const struct mip_tools_readings_response *value,
                                             struct mip_builder *builder) {
    return mip_encode_field(builder, 0x01, MIP_TOOLS_READINGS_RESPONSE_DESCRIPTOR,
                            write_readings_response, value);
}
