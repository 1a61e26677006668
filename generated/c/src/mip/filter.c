/* Filter commands. */
#include "mip/filter.h"

#include <string.h>

const struct mip_codec mip_filter_reset_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_RESET_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_reset),
    0, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_reset_decode(struct mip_filter_reset *value, const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_filter_reset_encode(const struct mip_filter_reset *value,
                                  struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_RESET_DESCRIPTOR, mip_write_nothing, value);
}

static void read_set_initial_attitude(struct mip_reader *r, void *value) {
    struct mip_filter_set_initial_attitude *v = (struct mip_filter_set_initial_attitude *)value;
    mip_read_float(r, &v->roll, 1);
    mip_read_float(r, &v->pitch, 1);
    mip_read_float(r, &v->heading, 1);
}

static void write_set_initial_attitude(struct mip_writer *w, const void *value) {
    const struct mip_filter_set_initial_attitude *v =
        (const struct mip_filter_set_initial_attitude *)value;
    mip_write_float(w, &v->roll, 1);
    mip_write_float(w, &v->pitch, 1);
    mip_write_float(w, &v->heading, 1);
}

const struct mip_codec mip_filter_set_initial_attitude_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_SET_INITIAL_ATTITUDE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_set_initial_attitude),
    0, /* time-out */
    read_set_initial_attitude,
    write_set_initial_attitude,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_set_initial_attitude_decode(struct mip_filter_set_initial_attitude *value,
                                                 const struct mip_field *field) {
    return mip_decode_field(field, read_set_initial_attitude, value, sizeof(*value), NULL);
}

mip_error mip_filter_set_initial_attitude_encode(
    const struct mip_filter_set_initial_attitude *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_SET_INITIAL_ATTITUDE_DESCRIPTOR,
                            write_set_initial_attitude, value);
}

struct mip_filter_set_initial_attitude mip_filter_set_initial_attitude_make(float roll, float pitch,
                                                                            float heading) {
    struct mip_filter_set_initial_attitude v;
    memset(&v, 0, sizeof(v));
    v.roll = roll;
    v.pitch = pitch;
    v.heading = heading;
    return v;
}

static void read_set_initial_heading(struct mip_reader *r, void *value) {
    struct mip_filter_set_initial_heading *v = (struct mip_filter_set_initial_heading *)value;
    mip_read_float(r, &v->heading, 1);
}

static void write_set_initial_heading(struct mip_writer *w, const void *value) {
    const struct mip_filter_set_initial_heading *v =
        (const struct mip_filter_set_initial_heading *)value;
    mip_write_float(w, &v->heading, 1);
}

const struct mip_codec mip_filter_set_initial_heading_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_SET_INITIAL_HEADING_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_set_initial_heading),
    0, /* time-out */
    read_set_initial_heading,
    write_set_initial_heading,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_set_initial_heading_decode(struct mip_filter_set_initial_heading *value,
                                                const struct mip_field *field) {
    return mip_decode_field(field, read_set_initial_heading, value, sizeof(*value), NULL);
}

mip_error mip_filter_set_initial_heading_encode(const struct mip_filter_set_initial_heading *value,
                                                struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_SET_INITIAL_HEADING_DESCRIPTOR,
                            write_set_initial_heading, value);
}

struct mip_filter_set_initial_heading mip_filter_set_initial_heading_make(float heading) {
    struct mip_filter_set_initial_heading v;
    memset(&v, 0, sizeof(v));
    v.heading = heading;
    return v;
}

const struct mip_codec mip_filter_run_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_RUN_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_run),
    0, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_run_decode(struct mip_filter_run *value, const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_filter_run_encode(const struct mip_filter_run *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_RUN_DESCRIPTOR, mip_write_nothing, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_vehicle_dynamics_mode[] = {0, 1, 0, 0, 0, 0};

static void read_vehicle_dynamics_mode(struct mip_reader *r, void *value) {
    struct mip_filter_vehicle_dynamics_mode *v = (struct mip_filter_vehicle_dynamics_mode *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_vehicle_dynamics_mode,
                      sizeof(required_vehicle_dynamics_mode));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->mode, 1);
    v->present = mip_read_present(r);
}

static void write_vehicle_dynamics_mode(struct mip_writer *w, const void *value) {
    const struct mip_filter_vehicle_dynamics_mode *v =
        (const struct mip_filter_vehicle_dynamics_mode *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_vehicle_dynamics_mode,
                       sizeof(required_vehicle_dynamics_mode), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->mode, 1);
}

static bool asked_vehicle_dynamics_mode_1(const void *value) {
    const struct mip_filter_vehicle_dynamics_mode *v =
        (const struct mip_filter_vehicle_dynamics_mode *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_vehicle_dynamics_mode[] = {
    {&mip_filter_vehicle_dynamics_mode_response_codec, asked_vehicle_dynamics_mode_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_vehicle_dynamics_mode_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_VEHICLE_DYNAMICS_MODE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_vehicle_dynamics_mode),
    0, /* time-out */
    read_vehicle_dynamics_mode,
    write_vehicle_dynamics_mode,
    NULL,
    responses_vehicle_dynamics_mode,
    NULL,
};

mip_error mip_filter_vehicle_dynamics_mode_decode(struct mip_filter_vehicle_dynamics_mode *value,
                                                  const struct mip_field *field) {
    return mip_decode_field(field, read_vehicle_dynamics_mode, value, sizeof(*value), NULL);
}

mip_error mip_filter_vehicle_dynamics_mode_encode(
    const struct mip_filter_vehicle_dynamics_mode *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_VEHICLE_DYNAMICS_MODE_DESCRIPTOR,
                            write_vehicle_dynamics_mode, value);
}

struct mip_filter_vehicle_dynamics_mode
mip_filter_vehicle_dynamics_mode_write(mip_filter_dynamics_mode mode) {
    struct mip_filter_vehicle_dynamics_mode v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.mode = mode;
    return v;
}

struct mip_filter_vehicle_dynamics_mode mip_filter_vehicle_dynamics_mode_read(void) {
    struct mip_filter_vehicle_dynamics_mode v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_vehicle_dynamics_mode mip_filter_vehicle_dynamics_mode_save(void) {
    struct mip_filter_vehicle_dynamics_mode v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_vehicle_dynamics_mode mip_filter_vehicle_dynamics_mode_load(void) {
    struct mip_filter_vehicle_dynamics_mode v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_vehicle_dynamics_mode mip_filter_vehicle_dynamics_mode_default(void) {
    struct mip_filter_vehicle_dynamics_mode v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_vehicle_dynamics_mode_response(struct mip_reader *r, void *value) {
    struct mip_filter_vehicle_dynamics_mode_response *v =
        (struct mip_filter_vehicle_dynamics_mode_response *)value;
    mip_read_u8(r, &v->mode, 1);
}

static void write_vehicle_dynamics_mode_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_vehicle_dynamics_mode_response *v =
        (const struct mip_filter_vehicle_dynamics_mode_response *)value;
    mip_write_u8(w, &v->mode, 1);
}

const struct mip_codec mip_filter_vehicle_dynamics_mode_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_VEHICLE_DYNAMICS_MODE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_vehicle_dynamics_mode_response),
    0, /* time-out */
    read_vehicle_dynamics_mode_response,
    write_vehicle_dynamics_mode_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_vehicle_dynamics_mode_response_decode(
    struct mip_filter_vehicle_dynamics_mode_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_vehicle_dynamics_mode_response, value, sizeof(*value),
                            NULL);
}

mip_error mip_filter_vehicle_dynamics_mode_response_encode(
    const struct mip_filter_vehicle_dynamics_mode_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_VEHICLE_DYNAMICS_MODE_RESPONSE_DESCRIPTOR,
                            write_vehicle_dynamics_mode_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_sensor_to_vehicle_rotation_euler[] = {0, 3, 0, 0, 0, 0};

static void read_sensor_to_vehicle_rotation_euler(struct mip_reader *r, void *value) {
    struct mip_filter_sensor_to_vehicle_euler *v =
        (struct mip_filter_sensor_to_vehicle_euler *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_sensor_to_vehicle_rotation_euler,
                      sizeof(required_sensor_to_vehicle_rotation_euler));
    mip_read_group(r, 1, 1);
    mip_read_float(r, &v->roll, 1);
    mip_read_group(r, 2, 2);
    mip_read_float(r, &v->pitch, 1);
    mip_read_group(r, 3, 3);
    mip_read_float(r, &v->yaw, 1);
    v->present = mip_read_present(r);
}

static void write_sensor_to_vehicle_rotation_euler(struct mip_writer *w, const void *value) {
    const struct mip_filter_sensor_to_vehicle_euler *v =
        (const struct mip_filter_sensor_to_vehicle_euler *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_sensor_to_vehicle_rotation_euler,
                       sizeof(required_sensor_to_vehicle_rotation_euler), v->present);
    mip_write_group(w, 1, 1);
    mip_write_float(w, &v->roll, 1);
    mip_write_group(w, 2, 2);
    mip_write_float(w, &v->pitch, 1);
    mip_write_group(w, 3, 3);
    mip_write_float(w, &v->yaw, 1);
}

static bool asked_sensor_to_vehicle_rotation_euler_1(const void *value) {
    const struct mip_filter_sensor_to_vehicle_euler *v =
        (const struct mip_filter_sensor_to_vehicle_euler *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_sensor_to_vehicle_rotation_euler[] = {
    {&mip_filter_sensor_to_vehicle_euler_response_codec, asked_sensor_to_vehicle_rotation_euler_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_sensor_to_vehicle_euler_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_SENSOR_TO_VEHICLE_EULER_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_sensor_to_vehicle_euler),
    0, /* time-out */
    read_sensor_to_vehicle_rotation_euler,
    write_sensor_to_vehicle_rotation_euler,
    NULL,
    responses_sensor_to_vehicle_rotation_euler,
    NULL,
};

mip_error mip_filter_sensor_to_vehicle_euler_decode(
    struct mip_filter_sensor_to_vehicle_euler *value, const struct mip_field *field) {
    return mip_decode_field(field, read_sensor_to_vehicle_rotation_euler, value, sizeof(*value),
                            NULL);
}

mip_error mip_filter_sensor_to_vehicle_euler_encode(
    const struct mip_filter_sensor_to_vehicle_euler *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_SENSOR_TO_VEHICLE_EULER_DESCRIPTOR,
                            write_sensor_to_vehicle_rotation_euler, value);
}

struct mip_filter_sensor_to_vehicle_euler mip_filter_sensor_to_vehicle_euler_write(float roll,
                                                                                   float pitch,
                                                                                   float yaw) {
    struct mip_filter_sensor_to_vehicle_euler v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.roll = roll;
    v.pitch = pitch;
    v.yaw = yaw;
    return v;
}

struct mip_filter_sensor_to_vehicle_euler mip_filter_sensor_to_vehicle_euler_read(void) {
    struct mip_filter_sensor_to_vehicle_euler v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_sensor_to_vehicle_euler mip_filter_sensor_to_vehicle_euler_save(void) {
    struct mip_filter_sensor_to_vehicle_euler v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_sensor_to_vehicle_euler mip_filter_sensor_to_vehicle_euler_load(void) {
    struct mip_filter_sensor_to_vehicle_euler v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_sensor_to_vehicle_euler mip_filter_sensor_to_vehicle_euler_default(void) {
    struct mip_filter_sensor_to_vehicle_euler v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_sensor_to_vehicle_rotation_euler_response(struct mip_reader *r, void *value) {
    struct mip_filter_sensor_to_vehicle_euler_response *v =
        (struct mip_filter_sensor_to_vehicle_euler_response *)value;
    mip_read_float(r, &v->roll, 1);
    mip_read_float(r, &v->pitch, 1);
    mip_read_float(r, &v->yaw, 1);
}

static void write_sensor_to_vehicle_rotation_euler_response(struct mip_writer *w,
                                                            const void *value) {
    const struct mip_filter_sensor_to_vehicle_euler_response *v =
        (const struct mip_filter_sensor_to_vehicle_euler_response *)value;
    mip_write_float(w, &v->roll, 1);
    mip_write_float(w, &v->pitch, 1);
    mip_write_float(w, &v->yaw, 1);
}

const struct mip_codec mip_filter_sensor_to_vehicle_euler_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_SENSOR_TO_VEHICLE_EULER_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_sensor_to_vehicle_euler_response),
    0, /* time-out */
    read_sensor_to_vehicle_rotation_euler_response,
    write_sensor_to_vehicle_rotation_euler_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_sensor_to_vehicle_euler_response_decode(
    struct mip_filter_sensor_to_vehicle_euler_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_sensor_to_vehicle_rotation_euler_response, value,
                            sizeof(*value), NULL);
}

mip_error mip_filter_sensor_to_vehicle_euler_response_encode(
    const struct mip_filter_sensor_to_vehicle_euler_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_SENSOR_TO_VEHICLE_EULER_RESPONSE_DESCRIPTOR,
                            write_sensor_to_vehicle_rotation_euler_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_sensor_to_vehicle_offset[] = {0, 1, 0, 0, 0, 0};

static void read_sensor_to_vehicle_offset(struct mip_reader *r, void *value) {
    struct mip_filter_sensor_to_vehicle_offset *v =
        (struct mip_filter_sensor_to_vehicle_offset *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_sensor_to_vehicle_offset,
                      sizeof(required_sensor_to_vehicle_offset));
    mip_read_group(r, 1, 1);
    mip_read_float(r, v->offset, 3);
    v->present = mip_read_present(r);
}

static void write_sensor_to_vehicle_offset(struct mip_writer *w, const void *value) {
    const struct mip_filter_sensor_to_vehicle_offset *v =
        (const struct mip_filter_sensor_to_vehicle_offset *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_sensor_to_vehicle_offset,
                       sizeof(required_sensor_to_vehicle_offset), v->present);
    mip_write_group(w, 1, 1);
    mip_write_float(w, v->offset, 3);
}

static bool asked_sensor_to_vehicle_offset_1(const void *value) {
    const struct mip_filter_sensor_to_vehicle_offset *v =
        (const struct mip_filter_sensor_to_vehicle_offset *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_sensor_to_vehicle_offset[] = {
    {&mip_filter_sensor_to_vehicle_offset_response_codec, asked_sensor_to_vehicle_offset_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_sensor_to_vehicle_offset_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_SENSOR_TO_VEHICLE_OFFSET_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_sensor_to_vehicle_offset),
    0, /* time-out */
    read_sensor_to_vehicle_offset,
    write_sensor_to_vehicle_offset,
    NULL,
    responses_sensor_to_vehicle_offset,
    NULL,
};

mip_error mip_filter_sensor_to_vehicle_offset_decode(
    struct mip_filter_sensor_to_vehicle_offset *value, const struct mip_field *field) {
    return mip_decode_field(field, read_sensor_to_vehicle_offset, value, sizeof(*value), NULL);
}

mip_error mip_filter_sensor_to_vehicle_offset_encode(
    const struct mip_filter_sensor_to_vehicle_offset *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_SENSOR_TO_VEHICLE_OFFSET_DESCRIPTOR,
                            write_sensor_to_vehicle_offset, value);
}

struct mip_filter_sensor_to_vehicle_offset
mip_filter_sensor_to_vehicle_offset_write(const float offset[3]) {
    struct mip_filter_sensor_to_vehicle_offset v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(v.offset, offset, sizeof(v.offset));
    return v;
}

struct mip_filter_sensor_to_vehicle_offset mip_filter_sensor_to_vehicle_offset_read(void) {
    struct mip_filter_sensor_to_vehicle_offset v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_sensor_to_vehicle_offset mip_filter_sensor_to_vehicle_offset_save(void) {
    struct mip_filter_sensor_to_vehicle_offset v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_sensor_to_vehicle_offset mip_filter_sensor_to_vehicle_offset_load(void) {
    struct mip_filter_sensor_to_vehicle_offset v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_sensor_to_vehicle_offset mip_filter_sensor_to_vehicle_offset_default(void) {
    struct mip_filter_sensor_to_vehicle_offset v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_sensor_to_vehicle_offset_response(struct mip_reader *r, void *value) {
    struct mip_filter_sensor_to_vehicle_offset_response *v =
        (struct mip_filter_sensor_to_vehicle_offset_response *)value;
    mip_read_float(r, v->offset, 3);
}

static void write_sensor_to_vehicle_offset_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_sensor_to_vehicle_offset_response *v =
        (const struct mip_filter_sensor_to_vehicle_offset_response *)value;
    mip_write_float(w, v->offset, 3);
}

const struct mip_codec mip_filter_sensor_to_vehicle_offset_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_SENSOR_TO_VEHICLE_OFFSET_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_sensor_to_vehicle_offset_response),
    0, /* time-out */
    read_sensor_to_vehicle_offset_response,
    write_sensor_to_vehicle_offset_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_sensor_to_vehicle_offset_response_decode(
    struct mip_filter_sensor_to_vehicle_offset_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_sensor_to_vehicle_offset_response, value, sizeof(*value),
                            NULL);
}

mip_error mip_filter_sensor_to_vehicle_offset_response_encode(
    const struct mip_filter_sensor_to_vehicle_offset_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_SENSOR_TO_VEHICLE_OFFSET_RESPONSE_DESCRIPTOR,
                            write_sensor_to_vehicle_offset_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_antenna_offset[] = {0, 1, 0, 0, 0, 0};

static void read_antenna_offset(struct mip_reader *r, void *value) {
    struct mip_filter_antenna_offset *v = (struct mip_filter_antenna_offset *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_antenna_offset, sizeof(required_antenna_offset));
    mip_read_group(r, 1, 1);
    mip_read_float(r, v->offset, 3);
    v->present = mip_read_present(r);
}

static void write_antenna_offset(struct mip_writer *w, const void *value) {
    const struct mip_filter_antenna_offset *v = (const struct mip_filter_antenna_offset *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_antenna_offset, sizeof(required_antenna_offset),
                       v->present);
    mip_write_group(w, 1, 1);
    mip_write_float(w, v->offset, 3);
}

static bool asked_antenna_offset_1(const void *value) {
    const struct mip_filter_antenna_offset *v = (const struct mip_filter_antenna_offset *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_antenna_offset[] = {
    {&mip_filter_antenna_offset_response_codec, asked_antenna_offset_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_antenna_offset_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_ANTENNA_OFFSET_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_antenna_offset),
    0, /* time-out */
    read_antenna_offset,
    write_antenna_offset,
    NULL,
    responses_antenna_offset,
    NULL,
};

mip_error mip_filter_antenna_offset_decode(struct mip_filter_antenna_offset *value,
                                           const struct mip_field *field) {
    return mip_decode_field(field, read_antenna_offset, value, sizeof(*value), NULL);
}

mip_error mip_filter_antenna_offset_encode(const struct mip_filter_antenna_offset *value,
                                           struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_ANTENNA_OFFSET_DESCRIPTOR,
                            write_antenna_offset, value);
}

struct mip_filter_antenna_offset mip_filter_antenna_offset_write(const float offset[3]) {
    struct mip_filter_antenna_offset v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(v.offset, offset, sizeof(v.offset));
    return v;
}

struct mip_filter_antenna_offset mip_filter_antenna_offset_read(void) {
    struct mip_filter_antenna_offset v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_antenna_offset mip_filter_antenna_offset_save(void) {
    struct mip_filter_antenna_offset v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_antenna_offset mip_filter_antenna_offset_load(void) {
    struct mip_filter_antenna_offset v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_antenna_offset mip_filter_antenna_offset_default(void) {
    struct mip_filter_antenna_offset v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_antenna_offset_response(struct mip_reader *r, void *value) {
    struct mip_filter_antenna_offset_response *v =
        (struct mip_filter_antenna_offset_response *)value;
    mip_read_float(r, v->offset, 3);
}

static void write_antenna_offset_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_antenna_offset_response *v =
        (const struct mip_filter_antenna_offset_response *)value;
    mip_write_float(w, v->offset, 3);
}

const struct mip_codec mip_filter_antenna_offset_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_ANTENNA_OFFSET_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_antenna_offset_response),
    0, /* time-out */
    read_antenna_offset_response,
    write_antenna_offset_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_antenna_offset_response_decode(
    struct mip_filter_antenna_offset_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_antenna_offset_response, value, sizeof(*value), NULL);
}

mip_error mip_filter_antenna_offset_response_encode(
    const struct mip_filter_antenna_offset_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_ANTENNA_OFFSET_RESPONSE_DESCRIPTOR,
                            write_antenna_offset_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_estimation_control[] = {0, 1, 0, 0, 0, 0};

static void read_estimation_control(struct mip_reader *r, void *value) {
    struct mip_filter_estimation_control *v = (struct mip_filter_estimation_control *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_estimation_control,
                      sizeof(required_estimation_control));
    mip_read_group(r, 1, 1);
    mip_read_u16(r, &v->flags, 1);
    v->present = mip_read_present(r);
}

static void write_estimation_control(struct mip_writer *w, const void *value) {
    const struct mip_filter_estimation_control *v =
        (const struct mip_filter_estimation_control *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_estimation_control,
                       sizeof(required_estimation_control), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u16(w, &v->flags, 1);
}

static bool asked_estimation_control_1(const void *value) {
    const struct mip_filter_estimation_control *v =
        (const struct mip_filter_estimation_control *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_estimation_control[] = {
    {&mip_filter_estimation_control_response_codec, asked_estimation_control_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_estimation_control_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_ESTIMATION_CONTROL_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_estimation_control),
    0, /* time-out */
    read_estimation_control,
    write_estimation_control,
    NULL,
    responses_estimation_control,
    NULL,
};

mip_error mip_filter_estimation_control_decode(struct mip_filter_estimation_control *value,
                                               const struct mip_field *field) {
    return mip_decode_field(field, read_estimation_control, value, sizeof(*value), NULL);
}

mip_error mip_filter_estimation_control_encode(const struct mip_filter_estimation_control *value,
                                               struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_ESTIMATION_CONTROL_DESCRIPTOR,
                            write_estimation_control, value);
}

struct mip_filter_estimation_control
mip_filter_estimation_control_write(mip_filter_estimated_states flags) {
    struct mip_filter_estimation_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.flags = flags;
    return v;
}

struct mip_filter_estimation_control mip_filter_estimation_control_read(void) {
    struct mip_filter_estimation_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_estimation_control mip_filter_estimation_control_save(void) {
    struct mip_filter_estimation_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_estimation_control mip_filter_estimation_control_load(void) {
    struct mip_filter_estimation_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_estimation_control mip_filter_estimation_control_default(void) {
    struct mip_filter_estimation_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_estimation_control_response(struct mip_reader *r, void *value) {
    struct mip_filter_estimation_control_response *v =
        (struct mip_filter_estimation_control_response *)value;
    mip_read_u16(r, &v->flags, 1);
}

static void write_estimation_control_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_estimation_control_response *v =
        (const struct mip_filter_estimation_control_response *)value;
    mip_write_u16(w, &v->flags, 1);
}

const struct mip_codec mip_filter_estimation_control_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_ESTIMATION_CONTROL_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_estimation_control_response),
    0, /* time-out */
    read_estimation_control_response,
    write_estimation_control_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_estimation_control_response_decode(
    struct mip_filter_estimation_control_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_estimation_control_response, value, sizeof(*value), NULL);
}

mip_error mip_filter_estimation_control_response_encode(
    const struct mip_filter_estimation_control_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_ESTIMATION_CONTROL_RESPONSE_DESCRIPTOR,
                            write_estimation_control_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_gnss_source[] = {0, 1, 0, 0, 0, 0};

static void read_gnss_source(struct mip_reader *r, void *value) {
    struct mip_filter_gnss_source *v = (struct mip_filter_gnss_source *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_gnss_source, sizeof(required_gnss_source));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->source, 1);
    v->present = mip_read_present(r);
}

static void write_gnss_source(struct mip_writer *w, const void *value) {
    const struct mip_filter_gnss_source *v = (const struct mip_filter_gnss_source *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_gnss_source, sizeof(required_gnss_source),
                       v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->source, 1);
}

static bool asked_gnss_source_1(const void *value) {
    const struct mip_filter_gnss_source *v = (const struct mip_filter_gnss_source *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_gnss_source[] = {
    {&mip_filter_gnss_source_response_codec, asked_gnss_source_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_gnss_source_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_GNSS_SOURCE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_gnss_source),
    0, /* time-out */
    read_gnss_source,
    write_gnss_source,
    NULL,
    responses_gnss_source,
    NULL,
};

mip_error mip_filter_gnss_source_decode(struct mip_filter_gnss_source *value,
                                        const struct mip_field *field) {
    return mip_decode_field(field, read_gnss_source, value, sizeof(*value), NULL);
}

mip_error mip_filter_gnss_source_encode(const struct mip_filter_gnss_source *value,
                                        struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_GNSS_SOURCE_DESCRIPTOR, write_gnss_source,
                            value);
}

struct mip_filter_gnss_source mip_filter_gnss_source_write(mip_filter_gnss_aiding_source source) {
    struct mip_filter_gnss_source v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.source = source;
    return v;
}

struct mip_filter_gnss_source mip_filter_gnss_source_read(void) {
    struct mip_filter_gnss_source v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_gnss_source mip_filter_gnss_source_save(void) {
    struct mip_filter_gnss_source v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_gnss_source mip_filter_gnss_source_load(void) {
    struct mip_filter_gnss_source v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_gnss_source mip_filter_gnss_source_default(void) {
    struct mip_filter_gnss_source v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_gnss_source_response(struct mip_reader *r, void *value) {
    struct mip_filter_gnss_source_response *v = (struct mip_filter_gnss_source_response *)value;
    mip_read_u8(r, &v->source, 1);
}

static void write_gnss_source_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_gnss_source_response *v =
        (const struct mip_filter_gnss_source_response *)value;
    mip_write_u8(w, &v->source, 1);
}

const struct mip_codec mip_filter_gnss_source_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_GNSS_SOURCE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_gnss_source_response),
    0, /* time-out */
    read_gnss_source_response,
    write_gnss_source_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_gnss_source_response_decode(struct mip_filter_gnss_source_response *value,
                                                 const struct mip_field *field) {
    return mip_decode_field(field, read_gnss_source_response, value, sizeof(*value), NULL);
}

mip_error mip_filter_gnss_source_response_encode(
    const struct mip_filter_gnss_source_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_GNSS_SOURCE_RESPONSE_DESCRIPTOR,
                            write_gnss_source_response, value);
}

static void read_external_gnss_update(struct mip_reader *r, void *value) {
    struct mip_filter_external_gnss_update *v = (struct mip_filter_external_gnss_update *)value;
    mip_read_double(r, &v->tow, 1);
    mip_read_u16(r, &v->week_number, 1);
    mip_read_double(r, &v->latitude, 1);
    mip_read_double(r, &v->longitude, 1);
    mip_read_double(r, &v->height, 1);
    mip_read_float(r, v->velocity, 3);
    mip_read_float(r, v->position_uncertainty, 3);
    mip_read_float(r, v->velocity_uncertainty, 3);
}

static void write_external_gnss_update(struct mip_writer *w, const void *value) {
    const struct mip_filter_external_gnss_update *v =
        (const struct mip_filter_external_gnss_update *)value;
    mip_write_double(w, &v->tow, 1);
    mip_write_u16(w, &v->week_number, 1);
    mip_write_double(w, &v->latitude, 1);
    mip_write_double(w, &v->longitude, 1);
    mip_write_double(w, &v->height, 1);
    mip_write_float(w, v->velocity, 3);
    mip_write_float(w, v->position_uncertainty, 3);
    mip_write_float(w, v->velocity_uncertainty, 3);
}

const struct mip_codec mip_filter_external_gnss_update_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_EXTERNAL_GNSS_UPDATE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_external_gnss_update),
    0, /* time-out */
    read_external_gnss_update,
    write_external_gnss_update,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_external_gnss_update_decode(struct mip_filter_external_gnss_update *value,
                                                 const struct mip_field *field) {
    return mip_decode_field(field, read_external_gnss_update, value, sizeof(*value), NULL);
}

mip_error mip_filter_external_gnss_update_encode(
    const struct mip_filter_external_gnss_update *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_EXTERNAL_GNSS_UPDATE_DESCRIPTOR,
                            write_external_gnss_update, value);
}

struct mip_filter_external_gnss_update mip_filter_external_gnss_update_make(
    double tow, uint16_t week_number, double latitude, double longitude, double height,
    const float velocity[3], const float position_uncertainty[3],
    const float velocity_uncertainty[3]) {
    struct mip_filter_external_gnss_update v;
    memset(&v, 0, sizeof(v));
    v.tow = tow;
    v.week_number = week_number;
    v.latitude = latitude;
    v.longitude = longitude;
    v.height = height;
    memcpy(v.velocity, velocity, sizeof(v.velocity));
    memcpy(v.position_uncertainty, position_uncertainty, sizeof(v.position_uncertainty));
    memcpy(v.velocity_uncertainty, velocity_uncertainty, sizeof(v.velocity_uncertainty));
    return v;
}

static void read_external_heading_update(struct mip_reader *r, void *value) {
    struct mip_filter_external_heading_update *v =
        (struct mip_filter_external_heading_update *)value;
    mip_read_float(r, &v->heading, 1);
    mip_read_float(r, &v->heading_uncertainty, 1);
    mip_read_u8(r, &v->type, 1);
}

static void write_external_heading_update(struct mip_writer *w, const void *value) {
    const struct mip_filter_external_heading_update *v =
        (const struct mip_filter_external_heading_update *)value;
    mip_write_float(w, &v->heading, 1);
    mip_write_float(w, &v->heading_uncertainty, 1);
    mip_write_u8(w, &v->type, 1);
}

const struct mip_codec mip_filter_external_heading_update_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_EXTERNAL_HEADING_UPDATE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_external_heading_update),
    0, /* time-out */
    read_external_heading_update,
    write_external_heading_update,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_external_heading_update_decode(
    struct mip_filter_external_heading_update *value, const struct mip_field *field) {
    return mip_decode_field(field, read_external_heading_update, value, sizeof(*value), NULL);
}

mip_error mip_filter_external_heading_update_encode(
    const struct mip_filter_external_heading_update *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_EXTERNAL_HEADING_UPDATE_DESCRIPTOR,
                            write_external_heading_update, value);
}

struct mip_filter_external_heading_update mip_filter_external_heading_update_make(
    float heading, float heading_uncertainty, mip_filter_heading_type type) {
    struct mip_filter_external_heading_update v;
    memset(&v, 0, sizeof(v));
    v.heading = heading;
    v.heading_uncertainty = heading_uncertainty;
    v.type = type;
    return v;
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_heading_source[] = {0, 1, 0, 0, 0, 0};

static void read_heading_source(struct mip_reader *r, void *value) {
    struct mip_filter_heading_source *v = (struct mip_filter_heading_source *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_heading_source, sizeof(required_heading_source));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->source, 1);
    v->present = mip_read_present(r);
}

static void write_heading_source(struct mip_writer *w, const void *value) {
    const struct mip_filter_heading_source *v = (const struct mip_filter_heading_source *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_heading_source, sizeof(required_heading_source),
                       v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->source, 1);
}

static bool asked_heading_source_1(const void *value) {
    const struct mip_filter_heading_source *v = (const struct mip_filter_heading_source *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_heading_source[] = {
    {&mip_filter_heading_source_response_codec, asked_heading_source_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_heading_source_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_HEADING_SOURCE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_heading_source),
    0, /* time-out */
    read_heading_source,
    write_heading_source,
    NULL,
    responses_heading_source,
    NULL,
};

mip_error mip_filter_heading_source_decode(struct mip_filter_heading_source *value,
                                           const struct mip_field *field) {
    return mip_decode_field(field, read_heading_source, value, sizeof(*value), NULL);
}

mip_error mip_filter_heading_source_encode(const struct mip_filter_heading_source *value,
                                           struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_HEADING_SOURCE_DESCRIPTOR,
                            write_heading_source, value);
}

struct mip_filter_heading_source
mip_filter_heading_source_write(mip_filter_heading_update_source source) {
    struct mip_filter_heading_source v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.source = source;
    return v;
}

struct mip_filter_heading_source mip_filter_heading_source_read(void) {
    struct mip_filter_heading_source v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_heading_source mip_filter_heading_source_save(void) {
    struct mip_filter_heading_source v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_heading_source mip_filter_heading_source_load(void) {
    struct mip_filter_heading_source v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_heading_source mip_filter_heading_source_default(void) {
    struct mip_filter_heading_source v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_heading_source_response(struct mip_reader *r, void *value) {
    struct mip_filter_heading_source_response *v =
        (struct mip_filter_heading_source_response *)value;
    mip_read_u8(r, &v->source, 1);
}

static void write_heading_source_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_heading_source_response *v =
        (const struct mip_filter_heading_source_response *)value;
    mip_write_u8(w, &v->source, 1);
}

const struct mip_codec mip_filter_heading_source_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_HEADING_SOURCE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_heading_source_response),
    0, /* time-out */
    read_heading_source_response,
    write_heading_source_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_heading_source_response_decode(
    struct mip_filter_heading_source_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_heading_source_response, value, sizeof(*value), NULL);
}

mip_error mip_filter_heading_source_response_encode(
    const struct mip_filter_heading_source_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_HEADING_SOURCE_RESPONSE_DESCRIPTOR,
                            write_heading_source_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_auto_initialization_control[] = {0, 1, 0, 0, 0, 0};

static void read_auto_initialization_control(struct mip_reader *r, void *value) {
    struct mip_filter_auto_initialization_control *v =
        (struct mip_filter_auto_initialization_control *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_auto_initialization_control,
                      sizeof(required_auto_initialization_control));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->enable, 1);
    v->present = mip_read_present(r);
}

static void write_auto_initialization_control(struct mip_writer *w, const void *value) {
    const struct mip_filter_auto_initialization_control *v =
        (const struct mip_filter_auto_initialization_control *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_auto_initialization_control,
                       sizeof(required_auto_initialization_control), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->enable, 1);
}

static bool asked_auto_initialization_control_1(const void *value) {
    const struct mip_filter_auto_initialization_control *v =
        (const struct mip_filter_auto_initialization_control *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_auto_initialization_control[] = {
    {&mip_filter_auto_initialization_control_response_codec, asked_auto_initialization_control_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_auto_initialization_control_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_AUTO_INITIALIZATION_CONTROL_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_auto_initialization_control),
    0, /* time-out */
    read_auto_initialization_control,
    write_auto_initialization_control,
    NULL,
    responses_auto_initialization_control,
    NULL,
};

mip_error mip_filter_auto_initialization_control_decode(
    struct mip_filter_auto_initialization_control *value, const struct mip_field *field) {
    return mip_decode_field(field, read_auto_initialization_control, value, sizeof(*value), NULL);
}

mip_error mip_filter_auto_initialization_control_encode(
    const struct mip_filter_auto_initialization_control *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_AUTO_INITIALIZATION_CONTROL_DESCRIPTOR,
                            write_auto_initialization_control, value);
}

struct mip_filter_auto_initialization_control
mip_filter_auto_initialization_control_write(uint8_t enable) {
    struct mip_filter_auto_initialization_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.enable = enable;
    return v;
}

struct mip_filter_auto_initialization_control mip_filter_auto_initialization_control_read(void) {
    struct mip_filter_auto_initialization_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_auto_initialization_control mip_filter_auto_initialization_control_save(void) {
    struct mip_filter_auto_initialization_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_auto_initialization_control mip_filter_auto_initialization_control_load(void) {
    struct mip_filter_auto_initialization_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_auto_initialization_control mip_filter_auto_initialization_control_default(void) {
    struct mip_filter_auto_initialization_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_auto_initialization_control_response(struct mip_reader *r, void *value) {
    struct mip_filter_auto_initialization_control_response *v =
        (struct mip_filter_auto_initialization_control_response *)value;
    mip_read_u8(r, &v->enable, 1);
}

static void write_auto_initialization_control_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_auto_initialization_control_response *v =
        (const struct mip_filter_auto_initialization_control_response *)value;
    mip_write_u8(w, &v->enable, 1);
}

const struct mip_codec mip_filter_auto_initialization_control_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_AUTO_INITIALIZATION_CONTROL_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_auto_initialization_control_response),
    0, /* time-out */
    read_auto_initialization_control_response,
    write_auto_initialization_control_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_auto_initialization_control_response_decode(
    struct mip_filter_auto_initialization_control_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_auto_initialization_control_response, value, sizeof(*value),
                            NULL);
}

mip_error mip_filter_auto_initialization_control_response_encode(
    const struct mip_filter_auto_initialization_control_response *value,
    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D,
                            MIP_FILTER_AUTO_INITIALIZATION_CONTROL_RESPONSE_DESCRIPTOR,
                            write_auto_initialization_control_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_accel_noise[] = {0, 1, 0, 0, 0, 0};

static void read_accel_noise(struct mip_reader *r, void *value) {
    struct mip_filter_accel_noise *v = (struct mip_filter_accel_noise *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_accel_noise, sizeof(required_accel_noise));
    mip_read_group(r, 1, 1);
    mip_read_float(r, v->noise, 3);
    v->present = mip_read_present(r);
}

static void write_accel_noise(struct mip_writer *w, const void *value) {
    const struct mip_filter_accel_noise *v = (const struct mip_filter_accel_noise *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_accel_noise, sizeof(required_accel_noise),
                       v->present);
    mip_write_group(w, 1, 1);
    mip_write_float(w, v->noise, 3);
}

static bool asked_accel_noise_1(const void *value) {
    const struct mip_filter_accel_noise *v = (const struct mip_filter_accel_noise *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_accel_noise[] = {
    {&mip_filter_accel_noise_response_codec, asked_accel_noise_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_accel_noise_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_ACCEL_NOISE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_accel_noise),
    0, /* time-out */
    read_accel_noise,
    write_accel_noise,
    NULL,
    responses_accel_noise,
    NULL,
};

mip_error mip_filter_accel_noise_decode(struct mip_filter_accel_noise *value,
                                        const struct mip_field *field) {
    return mip_decode_field(field, read_accel_noise, value, sizeof(*value), NULL);
}

mip_error mip_filter_accel_noise_encode(const struct mip_filter_accel_noise *value,
                                        struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_ACCEL_NOISE_DESCRIPTOR, write_accel_noise,
                            value);
}

struct mip_filter_accel_noise mip_filter_accel_noise_write(const float noise[3]) {
    struct mip_filter_accel_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(v.noise, noise, sizeof(v.noise));
    return v;
}

struct mip_filter_accel_noise mip_filter_accel_noise_read(void) {
    struct mip_filter_accel_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_accel_noise mip_filter_accel_noise_save(void) {
    struct mip_filter_accel_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_accel_noise mip_filter_accel_noise_load(void) {
    struct mip_filter_accel_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_accel_noise mip_filter_accel_noise_default(void) {
    struct mip_filter_accel_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_accel_noise_response(struct mip_reader *r, void *value) {
    struct mip_filter_accel_noise_response *v = (struct mip_filter_accel_noise_response *)value;
    mip_read_float(r, v->noise, 3);
}

static void write_accel_noise_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_accel_noise_response *v =
        (const struct mip_filter_accel_noise_response *)value;
    mip_write_float(w, v->noise, 3);
}

const struct mip_codec mip_filter_accel_noise_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_ACCEL_NOISE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_accel_noise_response),
    0, /* time-out */
    read_accel_noise_response,
    write_accel_noise_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_accel_noise_response_decode(struct mip_filter_accel_noise_response *value,
                                                 const struct mip_field *field) {
    return mip_decode_field(field, read_accel_noise_response, value, sizeof(*value), NULL);
}

mip_error mip_filter_accel_noise_response_encode(
    const struct mip_filter_accel_noise_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_ACCEL_NOISE_RESPONSE_DESCRIPTOR,
                            write_accel_noise_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_gyro_noise[] = {0, 1, 0, 0, 0, 0};

static void read_gyro_noise(struct mip_reader *r, void *value) {
    struct mip_filter_gyro_noise *v = (struct mip_filter_gyro_noise *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_gyro_noise, sizeof(required_gyro_noise));
    mip_read_group(r, 1, 1);
    mip_read_float(r, v->noise, 3);
    v->present = mip_read_present(r);
}

static void write_gyro_noise(struct mip_writer *w, const void *value) {
    const struct mip_filter_gyro_noise *v = (const struct mip_filter_gyro_noise *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_gyro_noise, sizeof(required_gyro_noise),
                       v->present);
    mip_write_group(w, 1, 1);
    mip_write_float(w, v->noise, 3);
}

static bool asked_gyro_noise_1(const void *value) {
    const struct mip_filter_gyro_noise *v = (const struct mip_filter_gyro_noise *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_gyro_noise[] = {
    {&mip_filter_gyro_noise_response_codec, asked_gyro_noise_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_gyro_noise_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_GYRO_NOISE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_gyro_noise),
    0, /* time-out */
    read_gyro_noise,
    write_gyro_noise,
    NULL,
    responses_gyro_noise,
    NULL,
};

mip_error mip_filter_gyro_noise_decode(struct mip_filter_gyro_noise *value,
                                       const struct mip_field *field) {
    return mip_decode_field(field, read_gyro_noise, value, sizeof(*value), NULL);
}

mip_error mip_filter_gyro_noise_encode(const struct mip_filter_gyro_noise *value,
                                       struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_GYRO_NOISE_DESCRIPTOR, write_gyro_noise,
                            value);
}

struct mip_filter_gyro_noise mip_filter_gyro_noise_write(const float noise[3]) {
    struct mip_filter_gyro_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(v.noise, noise, sizeof(v.noise));
    return v;
}

struct mip_filter_gyro_noise mip_filter_gyro_noise_read(void) {
    struct mip_filter_gyro_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_gyro_noise mip_filter_gyro_noise_save(void) {
    struct mip_filter_gyro_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_gyro_noise mip_filter_gyro_noise_load(void) {
    struct mip_filter_gyro_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_gyro_noise mip_filter_gyro_noise_default(void) {
    struct mip_filter_gyro_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_gyro_noise_response(struct mip_reader *r, void *value) {
    struct mip_filter_gyro_noise_response *v = (struct mip_filter_gyro_noise_response *)value;
    mip_read_float(r, v->noise, 3);
}

static void write_gyro_noise_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_gyro_noise_response *v =
        (const struct mip_filter_gyro_noise_response *)value;
    mip_write_float(w, v->noise, 3);
}

const struct mip_codec mip_filter_gyro_noise_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_GYRO_NOISE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_gyro_noise_response),
    0, /* time-out */
    read_gyro_noise_response,
    write_gyro_noise_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_gyro_noise_response_decode(struct mip_filter_gyro_noise_response *value,
                                                const struct mip_field *field) {
    return mip_decode_field(field, read_gyro_noise_response, value, sizeof(*value), NULL);
}

mip_error mip_filter_gyro_noise_response_encode(const struct mip_filter_gyro_noise_response *value,
                                                struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_GYRO_NOISE_RESPONSE_DESCRIPTOR,
                            write_gyro_noise_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_accel_bias_model[] = {0, 2, 0, 0, 0, 0};

static void read_accel_bias_model(struct mip_reader *r, void *value) {
    struct mip_filter_accel_bias_model *v = (struct mip_filter_accel_bias_model *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_accel_bias_model, sizeof(required_accel_bias_model));
    mip_read_group(r, 1, 1);
    mip_read_float(r, v->beta, 3);
    mip_read_group(r, 2, 2);
    mip_read_float(r, v->noise, 3);
    v->present = mip_read_present(r);
}

static void write_accel_bias_model(struct mip_writer *w, const void *value) {
    const struct mip_filter_accel_bias_model *v = (const struct mip_filter_accel_bias_model *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_accel_bias_model, sizeof(required_accel_bias_model),
                       v->present);
    mip_write_group(w, 1, 1);
    mip_write_float(w, v->beta, 3);
    mip_write_group(w, 2, 2);
    mip_write_float(w, v->noise, 3);
}

static bool asked_accel_bias_model_1(const void *value) {
    const struct mip_filter_accel_bias_model *v = (const struct mip_filter_accel_bias_model *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_accel_bias_model[] = {
    {&mip_filter_accel_bias_model_response_codec, asked_accel_bias_model_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_accel_bias_model_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_ACCEL_BIAS_MODEL_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_accel_bias_model),
    0, /* time-out */
    read_accel_bias_model,
    write_accel_bias_model,
    NULL,
    responses_accel_bias_model,
    NULL,
};

mip_error mip_filter_accel_bias_model_decode(struct mip_filter_accel_bias_model *value,
                                             const struct mip_field *field) {
    return mip_decode_field(field, read_accel_bias_model, value, sizeof(*value), NULL);
}

mip_error mip_filter_accel_bias_model_encode(const struct mip_filter_accel_bias_model *value,
                                             struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_ACCEL_BIAS_MODEL_DESCRIPTOR,
                            write_accel_bias_model, value);
}

struct mip_filter_accel_bias_model mip_filter_accel_bias_model_write(const float beta[3],
                                                                     const float noise[3]) {
    struct mip_filter_accel_bias_model v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(v.beta, beta, sizeof(v.beta));
    memcpy(v.noise, noise, sizeof(v.noise));
    return v;
}

struct mip_filter_accel_bias_model mip_filter_accel_bias_model_read(void) {
    struct mip_filter_accel_bias_model v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_accel_bias_model mip_filter_accel_bias_model_save(void) {
    struct mip_filter_accel_bias_model v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_accel_bias_model mip_filter_accel_bias_model_load(void) {
    struct mip_filter_accel_bias_model v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_accel_bias_model mip_filter_accel_bias_model_default(void) {
    struct mip_filter_accel_bias_model v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_accel_bias_model_response(struct mip_reader *r, void *value) {
    struct mip_filter_accel_bias_model_response *v =
        (struct mip_filter_accel_bias_model_response *)value;
    mip_read_float(r, v->beta, 3);
    mip_read_float(r, v->noise, 3);
}

static void write_accel_bias_model_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_accel_bias_model_response *v =
        (const struct mip_filter_accel_bias_model_response *)value;
    mip_write_float(w, v->beta, 3);
    mip_write_float(w, v->noise, 3);
}

const struct mip_codec mip_filter_accel_bias_model_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_ACCEL_BIAS_MODEL_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_accel_bias_model_response),
    0, /* time-out */
    read_accel_bias_model_response,
    write_accel_bias_model_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_accel_bias_model_response_decode(
    struct mip_filter_accel_bias_model_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_accel_bias_model_response, value, sizeof(*value), NULL);
}

mip_error mip_filter_accel_bias_model_response_encode(
    const struct mip_filter_accel_bias_model_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_ACCEL_BIAS_MODEL_RESPONSE_DESCRIPTOR,
                            write_accel_bias_model_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_gyro_bias_model[] = {0, 2, 0, 0, 0, 0};

static void read_gyro_bias_model(struct mip_reader *r, void *value) {
    struct mip_filter_gyro_bias_model *v = (struct mip_filter_gyro_bias_model *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_gyro_bias_model, sizeof(required_gyro_bias_model));
    mip_read_group(r, 1, 1);
    mip_read_float(r, v->beta, 3);
    mip_read_group(r, 2, 2);
    mip_read_float(r, v->noise, 3);
    v->present = mip_read_present(r);
}

static void write_gyro_bias_model(struct mip_writer *w, const void *value) {
    const struct mip_filter_gyro_bias_model *v = (const struct mip_filter_gyro_bias_model *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_gyro_bias_model, sizeof(required_gyro_bias_model),
                       v->present);
    mip_write_group(w, 1, 1);
    mip_write_float(w, v->beta, 3);
    mip_write_group(w, 2, 2);
    mip_write_float(w, v->noise, 3);
}

static bool asked_gyro_bias_model_1(const void *value) {
    const struct mip_filter_gyro_bias_model *v = (const struct mip_filter_gyro_bias_model *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_gyro_bias_model[] = {
    {&mip_filter_gyro_bias_model_response_codec, asked_gyro_bias_model_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_gyro_bias_model_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_GYRO_BIAS_MODEL_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_gyro_bias_model),
    0, /* time-out */
    read_gyro_bias_model,
    write_gyro_bias_model,
    NULL,
    responses_gyro_bias_model,
    NULL,
};

mip_error mip_filter_gyro_bias_model_decode(struct mip_filter_gyro_bias_model *value,
                                            const struct mip_field *field) {
    return mip_decode_field(field, read_gyro_bias_model, value, sizeof(*value), NULL);
}

mip_error mip_filter_gyro_bias_model_encode(const struct mip_filter_gyro_bias_model *value,
                                            struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_GYRO_BIAS_MODEL_DESCRIPTOR,
                            write_gyro_bias_model, value);
}

struct mip_filter_gyro_bias_model mip_filter_gyro_bias_model_write(const float beta[3],
                                                                   const float noise[3]) {
    struct mip_filter_gyro_bias_model v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(v.beta, beta, sizeof(v.beta));
    memcpy(v.noise, noise, sizeof(v.noise));
    return v;
}

struct mip_filter_gyro_bias_model mip_filter_gyro_bias_model_read(void) {
    struct mip_filter_gyro_bias_model v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_gyro_bias_model mip_filter_gyro_bias_model_save(void) {
    struct mip_filter_gyro_bias_model v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_gyro_bias_model mip_filter_gyro_bias_model_load(void) {
    struct mip_filter_gyro_bias_model v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_gyro_bias_model mip_filter_gyro_bias_model_default(void) {
    struct mip_filter_gyro_bias_model v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_gyro_bias_model_response(struct mip_reader *r, void *value) {
    struct mip_filter_gyro_bias_model_response *v =
        (struct mip_filter_gyro_bias_model_response *)value;
    mip_read_float(r, v->beta, 3);
    mip_read_float(r, v->noise, 3);
}

static void write_gyro_bias_model_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_gyro_bias_model_response *v =
        (const struct mip_filter_gyro_bias_model_response *)value;
    mip_write_float(w, v->beta, 3);
    mip_write_float(w, v->noise, 3);
}

const struct mip_codec mip_filter_gyro_bias_model_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_GYRO_BIAS_MODEL_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_gyro_bias_model_response),
    0, /* time-out */
    read_gyro_bias_model_response,
    write_gyro_bias_model_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_gyro_bias_model_response_decode(
    struct mip_filter_gyro_bias_model_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_gyro_bias_model_response, value, sizeof(*value), NULL);
}

mip_error mip_filter_gyro_bias_model_response_encode(
    const struct mip_filter_gyro_bias_model_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_GYRO_BIAS_MODEL_RESPONSE_DESCRIPTOR,
                            write_gyro_bias_model_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_auto_zupt[] = {0, 2, 0, 0, 0, 0};

static void read_auto_zupt(struct mip_reader *r, void *value) {
    struct mip_filter_auto_zupt *v = (struct mip_filter_auto_zupt *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_auto_zupt, sizeof(required_auto_zupt));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->enable, 1);
    mip_read_group(r, 2, 2);
    mip_read_float(r, &v->threshold, 1);
    v->present = mip_read_present(r);
}

static void write_auto_zupt(struct mip_writer *w, const void *value) {
    const struct mip_filter_auto_zupt *v = (const struct mip_filter_auto_zupt *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_auto_zupt, sizeof(required_auto_zupt), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->enable, 1);
    mip_write_group(w, 2, 2);
    mip_write_float(w, &v->threshold, 1);
}

static bool asked_auto_zupt_1(const void *value) {
    const struct mip_filter_auto_zupt *v = (const struct mip_filter_auto_zupt *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_auto_zupt[] = {
    {&mip_filter_auto_zupt_response_codec, asked_auto_zupt_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_auto_zupt_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_AUTO_ZUPT_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_auto_zupt),
    0, /* time-out */
    read_auto_zupt,
    write_auto_zupt,
    NULL,
    responses_auto_zupt,
    NULL,
};

mip_error mip_filter_auto_zupt_decode(struct mip_filter_auto_zupt *value,
                                      const struct mip_field *field) {
    return mip_decode_field(field, read_auto_zupt, value, sizeof(*value), NULL);
}

mip_error mip_filter_auto_zupt_encode(const struct mip_filter_auto_zupt *value,
                                      struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_AUTO_ZUPT_DESCRIPTOR, write_auto_zupt, value);
}

struct mip_filter_auto_zupt mip_filter_auto_zupt_write(uint8_t enable, float threshold) {
    struct mip_filter_auto_zupt v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.enable = enable;
    v.threshold = threshold;
    return v;
}

struct mip_filter_auto_zupt mip_filter_auto_zupt_read(void) {
    struct mip_filter_auto_zupt v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_auto_zupt mip_filter_auto_zupt_save(void) {
    struct mip_filter_auto_zupt v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_auto_zupt mip_filter_auto_zupt_load(void) {
    struct mip_filter_auto_zupt v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_auto_zupt mip_filter_auto_zupt_default(void) {
    struct mip_filter_auto_zupt v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_auto_zupt_response(struct mip_reader *r, void *value) {
    struct mip_filter_auto_zupt_response *v = (struct mip_filter_auto_zupt_response *)value;
    mip_read_u8(r, &v->enable, 1);
    mip_read_float(r, &v->threshold, 1);
}

static void write_auto_zupt_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_auto_zupt_response *v =
        (const struct mip_filter_auto_zupt_response *)value;
    mip_write_u8(w, &v->enable, 1);
    mip_write_float(w, &v->threshold, 1);
}

const struct mip_codec mip_filter_auto_zupt_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_AUTO_ZUPT_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_auto_zupt_response),
    0, /* time-out */
    read_auto_zupt_response,
    write_auto_zupt_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_auto_zupt_response_decode(struct mip_filter_auto_zupt_response *value,
                                               const struct mip_field *field) {
    return mip_decode_field(field, read_auto_zupt_response, value, sizeof(*value), NULL);
}

mip_error mip_filter_auto_zupt_response_encode(const struct mip_filter_auto_zupt_response *value,
                                               struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_AUTO_ZUPT_RESPONSE_DESCRIPTOR,
                            write_auto_zupt_response, value);
}

static void read_external_heading_update_with_time(struct mip_reader *r, void *value) {
    struct mip_filter_external_heading_update_with_time *v =
        (struct mip_filter_external_heading_update_with_time *)value;
    mip_read_double(r, &v->tow, 1);
    mip_read_u16(r, &v->week_number, 1);
    mip_read_float(r, &v->heading, 1);
    mip_read_float(r, &v->heading_uncertainty, 1);
    mip_read_u8(r, &v->type, 1);
}

static void write_external_heading_update_with_time(struct mip_writer *w, const void *value) {
    const struct mip_filter_external_heading_update_with_time *v =
        (const struct mip_filter_external_heading_update_with_time *)value;
    mip_write_double(w, &v->tow, 1);
    mip_write_u16(w, &v->week_number, 1);
    mip_write_float(w, &v->heading, 1);
    mip_write_float(w, &v->heading_uncertainty, 1);
    mip_write_u8(w, &v->type, 1);
}

const struct mip_codec mip_filter_external_heading_update_with_time_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_EXTERNAL_HEADING_UPDATE_WITH_TIME_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_external_heading_update_with_time),
    0, /* time-out */
    read_external_heading_update_with_time,
    write_external_heading_update_with_time,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_external_heading_update_with_time_decode(
    struct mip_filter_external_heading_update_with_time *value, const struct mip_field *field) {
    return mip_decode_field(field, read_external_heading_update_with_time, value, sizeof(*value),
                            NULL);
}

mip_error mip_filter_external_heading_update_with_time_encode(
    const struct mip_filter_external_heading_update_with_time *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_EXTERNAL_HEADING_UPDATE_WITH_TIME_DESCRIPTOR,
                            write_external_heading_update_with_time, value);
}

struct mip_filter_external_heading_update_with_time
mip_filter_external_heading_update_with_time_make(double tow, uint16_t week_number, float heading,
                                                  float heading_uncertainty,
                                                  mip_filter_heading_type type) {
    struct mip_filter_external_heading_update_with_time v;
    memset(&v, 0, sizeof(v));
    v.tow = tow;
    v.week_number = week_number;
    v.heading = heading;
    v.heading_uncertainty = heading_uncertainty;
    v.type = type;
    return v;
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_auto_angular_zupt[] = {0, 2, 0, 0, 0, 0};

static void read_auto_angular_zupt(struct mip_reader *r, void *value) {
    struct mip_filter_auto_angular_zupt *v = (struct mip_filter_auto_angular_zupt *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_auto_angular_zupt,
                      sizeof(required_auto_angular_zupt));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->enable, 1);
    mip_read_group(r, 2, 2);
    mip_read_float(r, &v->threshold, 1);
    v->present = mip_read_present(r);
}

static void write_auto_angular_zupt(struct mip_writer *w, const void *value) {
    const struct mip_filter_auto_angular_zupt *v =
        (const struct mip_filter_auto_angular_zupt *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_auto_angular_zupt,
                       sizeof(required_auto_angular_zupt), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->enable, 1);
    mip_write_group(w, 2, 2);
    mip_write_float(w, &v->threshold, 1);
}

static bool asked_auto_angular_zupt_1(const void *value) {
    const struct mip_filter_auto_angular_zupt *v =
        (const struct mip_filter_auto_angular_zupt *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_auto_angular_zupt[] = {
    {&mip_filter_auto_angular_zupt_response_codec, asked_auto_angular_zupt_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_auto_angular_zupt_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_AUTO_ANGULAR_ZUPT_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_auto_angular_zupt),
    0, /* time-out */
    read_auto_angular_zupt,
    write_auto_angular_zupt,
    NULL,
    responses_auto_angular_zupt,
    NULL,
};

mip_error mip_filter_auto_angular_zupt_decode(struct mip_filter_auto_angular_zupt *value,
                                              const struct mip_field *field) {
    return mip_decode_field(field, read_auto_angular_zupt, value, sizeof(*value), NULL);
}

mip_error mip_filter_auto_angular_zupt_encode(const struct mip_filter_auto_angular_zupt *value,
                                              struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_AUTO_ANGULAR_ZUPT_DESCRIPTOR,
                            write_auto_angular_zupt, value);
}

struct mip_filter_auto_angular_zupt mip_filter_auto_angular_zupt_write(uint8_t enable,
                                                                       float threshold) {
    struct mip_filter_auto_angular_zupt v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.enable = enable;
    v.threshold = threshold;
    return v;
}

struct mip_filter_auto_angular_zupt mip_filter_auto_angular_zupt_read(void) {
    struct mip_filter_auto_angular_zupt v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_auto_angular_zupt mip_filter_auto_angular_zupt_save(void) {
    struct mip_filter_auto_angular_zupt v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_auto_angular_zupt mip_filter_auto_angular_zupt_load(void) {
    struct mip_filter_auto_angular_zupt v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_auto_angular_zupt mip_filter_auto_angular_zupt_default(void) {
    struct mip_filter_auto_angular_zupt v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_auto_angular_zupt_response(struct mip_reader *r, void *value) {
    struct mip_filter_auto_angular_zupt_response *v =
        (struct mip_filter_auto_angular_zupt_response *)value;
    mip_read_u8(r, &v->enable, 1);
    mip_read_float(r, &v->threshold, 1);
}

static void write_auto_angular_zupt_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_auto_angular_zupt_response *v =
        (const struct mip_filter_auto_angular_zupt_response *)value;
    mip_write_u8(w, &v->enable, 1);
    mip_write_float(w, &v->threshold, 1);
}

const struct mip_codec mip_filter_auto_angular_zupt_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_AUTO_ANGULAR_ZUPT_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_auto_angular_zupt_response),
    0, /* time-out */
    read_auto_angular_zupt_response,
    write_auto_angular_zupt_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_auto_angular_zupt_response_decode(
    struct mip_filter_auto_angular_zupt_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_auto_angular_zupt_response, value, sizeof(*value), NULL);
}

mip_error mip_filter_auto_angular_zupt_response_encode(
    const struct mip_filter_auto_angular_zupt_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_AUTO_ANGULAR_ZUPT_RESPONSE_DESCRIPTOR,
                            write_auto_angular_zupt_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_tare_orientation[] = {0, 1, 0, 0, 0, 0};

static void read_tare_orientation(struct mip_reader *r, void *value) {
    struct mip_filter_tare_orientation *v = (struct mip_filter_tare_orientation *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_tare_orientation, sizeof(required_tare_orientation));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->axes, 1);
    v->present = mip_read_present(r);
}

static void write_tare_orientation(struct mip_writer *w, const void *value) {
    const struct mip_filter_tare_orientation *v = (const struct mip_filter_tare_orientation *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_tare_orientation, sizeof(required_tare_orientation),
                       v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->axes, 1);
}

static bool asked_tare_orientation_1(const void *value) {
    const struct mip_filter_tare_orientation *v = (const struct mip_filter_tare_orientation *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_tare_orientation[] = {
    {&mip_filter_tare_orientation_response_codec, asked_tare_orientation_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_tare_orientation_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_TARE_ORIENTATION_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_tare_orientation),
    0, /* time-out */
    read_tare_orientation,
    write_tare_orientation,
    NULL,
    responses_tare_orientation,
    NULL,
};

mip_error mip_filter_tare_orientation_decode(struct mip_filter_tare_orientation *value,
                                             const struct mip_field *field) {
    return mip_decode_field(field, read_tare_orientation, value, sizeof(*value), NULL);
}

mip_error mip_filter_tare_orientation_encode(const struct mip_filter_tare_orientation *value,
                                             struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_TARE_ORIENTATION_DESCRIPTOR,
                            write_tare_orientation, value);
}

struct mip_filter_tare_orientation mip_filter_tare_orientation_write(mip_filter_tare_axes axes) {
    struct mip_filter_tare_orientation v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.axes = axes;
    return v;
}

struct mip_filter_tare_orientation mip_filter_tare_orientation_read(void) {
    struct mip_filter_tare_orientation v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_tare_orientation mip_filter_tare_orientation_save(void) {
    struct mip_filter_tare_orientation v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_tare_orientation mip_filter_tare_orientation_load(void) {
    struct mip_filter_tare_orientation v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_tare_orientation mip_filter_tare_orientation_default(void) {
    struct mip_filter_tare_orientation v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_tare_orientation_response(struct mip_reader *r, void *value) {
    struct mip_filter_tare_orientation_response *v =
        (struct mip_filter_tare_orientation_response *)value;
    mip_read_u8(r, &v->axes, 1);
}

static void write_tare_orientation_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_tare_orientation_response *v =
        (const struct mip_filter_tare_orientation_response *)value;
    mip_write_u8(w, &v->axes, 1);
}

const struct mip_codec mip_filter_tare_orientation_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_TARE_ORIENTATION_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_tare_orientation_response),
    0, /* time-out */
    read_tare_orientation_response,
    write_tare_orientation_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_tare_orientation_response_decode(
    struct mip_filter_tare_orientation_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_tare_orientation_response, value, sizeof(*value), NULL);
}

mip_error mip_filter_tare_orientation_response_encode(
    const struct mip_filter_tare_orientation_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_TARE_ORIENTATION_RESPONSE_DESCRIPTOR,
                            write_tare_orientation_response, value);
}

const struct mip_codec mip_filter_commanded_zupt_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_COMMANDED_ZUPT_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_commanded_zupt),
    0, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_commanded_zupt_decode(struct mip_filter_commanded_zupt *value,
                                           const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_filter_commanded_zupt_encode(const struct mip_filter_commanded_zupt *value,
                                           struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_COMMANDED_ZUPT_DESCRIPTOR, mip_write_nothing,
                            value);
}

const struct mip_codec mip_filter_commanded_angular_zupt_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_COMMANDED_ANGULAR_ZUPT_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_commanded_angular_zupt),
    0, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_commanded_angular_zupt_decode(struct mip_filter_commanded_angular_zupt *value,
                                                   const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_filter_commanded_angular_zupt_encode(
    const struct mip_filter_commanded_angular_zupt *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_COMMANDED_ANGULAR_ZUPT_DESCRIPTOR,
                            mip_write_nothing, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_reference_position[] = {0, 4, 0, 0, 0, 0};

static void read_reference_position(struct mip_reader *r, void *value) {
    struct mip_filter_reference_position *v = (struct mip_filter_reference_position *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_reference_position,
                      sizeof(required_reference_position));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->enable, 1);
    mip_read_group(r, 2, 2);
    mip_read_double(r, &v->latitude, 1);
    mip_read_group(r, 3, 3);
    mip_read_double(r, &v->longitude, 1);
    mip_read_group(r, 4, 4);
    mip_read_double(r, &v->altitude, 1);
    v->present = mip_read_present(r);
}

static void write_reference_position(struct mip_writer *w, const void *value) {
    const struct mip_filter_reference_position *v =
        (const struct mip_filter_reference_position *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_reference_position,
                       sizeof(required_reference_position), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->enable, 1);
    mip_write_group(w, 2, 2);
    mip_write_double(w, &v->latitude, 1);
    mip_write_group(w, 3, 3);
    mip_write_double(w, &v->longitude, 1);
    mip_write_group(w, 4, 4);
    mip_write_double(w, &v->altitude, 1);
}

static bool asked_reference_position_1(const void *value) {
    const struct mip_filter_reference_position *v =
        (const struct mip_filter_reference_position *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_reference_position[] = {
    {&mip_filter_reference_position_response_codec, asked_reference_position_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_reference_position_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_REFERENCE_POSITION_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_reference_position),
    0, /* time-out */
    read_reference_position,
    write_reference_position,
    NULL,
    responses_reference_position,
    NULL,
};

mip_error mip_filter_reference_position_decode(struct mip_filter_reference_position *value,
                                               const struct mip_field *field) {
    return mip_decode_field(field, read_reference_position, value, sizeof(*value), NULL);
}

mip_error mip_filter_reference_position_encode(const struct mip_filter_reference_position *value,
                                               struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_REFERENCE_POSITION_DESCRIPTOR,
                            write_reference_position, value);
}

struct mip_filter_reference_position mip_filter_reference_position_write(uint8_t enable,
                                                                         double latitude,
                                                                         double longitude,
                                                                         double altitude) {
    struct mip_filter_reference_position v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.enable = enable;
    v.latitude = latitude;
    v.longitude = longitude;
    v.altitude = altitude;
    return v;
}

struct mip_filter_reference_position mip_filter_reference_position_read(void) {
    struct mip_filter_reference_position v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_reference_position mip_filter_reference_position_save(void) {
    struct mip_filter_reference_position v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_reference_position mip_filter_reference_position_load(void) {
    struct mip_filter_reference_position v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_reference_position mip_filter_reference_position_default(void) {
    struct mip_filter_reference_position v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_reference_position_response(struct mip_reader *r, void *value) {
    struct mip_filter_reference_position_response *v =
        (struct mip_filter_reference_position_response *)value;
    mip_read_u8(r, &v->enable, 1);
    mip_read_double(r, &v->latitude, 1);
    mip_read_double(r, &v->longitude, 1);
    mip_read_double(r, &v->altitude, 1);
}

static void write_reference_position_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_reference_position_response *v =
        (const struct mip_filter_reference_position_response *)value;
    mip_write_u8(w, &v->enable, 1);
    mip_write_double(w, &v->latitude, 1);
    mip_write_double(w, &v->longitude, 1);
    mip_write_double(w, &v->altitude, 1);
}

const struct mip_codec mip_filter_reference_position_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_REFERENCE_POSITION_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_reference_position_response),
    0, /* time-out */
    read_reference_position_response,
    write_reference_position_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_reference_position_response_decode(
    struct mip_filter_reference_position_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_reference_position_response, value, sizeof(*value), NULL);
}

mip_error mip_filter_reference_position_response_encode(
    const struct mip_filter_reference_position_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_REFERENCE_POSITION_RESPONSE_DESCRIPTOR,
                            write_reference_position_response, value);
}

static void read_mag_capture_auto_calibration(struct mip_reader *r, void *value) {
    struct mip_filter_mag_capture_auto_calibration *v =
        (struct mip_filter_mag_capture_auto_calibration *)value;
    mip_read_u8(r, &v->function, 1);
}

static void write_mag_capture_auto_calibration(struct mip_writer *w, const void *value) {
    const struct mip_filter_mag_capture_auto_calibration *v =
        (const struct mip_filter_mag_capture_auto_calibration *)value;
    mip_write_u8(w, &v->function, 1);
}

const struct mip_codec mip_filter_mag_capture_auto_calibration_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_MAG_CAPTURE_AUTO_CALIBRATION_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_mag_capture_auto_calibration),
    0, /* time-out */
    read_mag_capture_auto_calibration,
    write_mag_capture_auto_calibration,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_mag_capture_auto_calibration_decode(
    struct mip_filter_mag_capture_auto_calibration *value, const struct mip_field *field) {
    return mip_decode_field(field, read_mag_capture_auto_calibration, value, sizeof(*value), NULL);
}

mip_error mip_filter_mag_capture_auto_calibration_encode(
    const struct mip_filter_mag_capture_auto_calibration *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_MAG_CAPTURE_AUTO_CALIBRATION_DESCRIPTOR,
                            write_mag_capture_auto_calibration, value);
}

struct mip_filter_mag_capture_auto_calibration mip_filter_mag_capture_auto_calibration_write(void) {
    struct mip_filter_mag_capture_auto_calibration v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    return v;
}

struct mip_filter_mag_capture_auto_calibration mip_filter_mag_capture_auto_calibration_save(void) {
    struct mip_filter_mag_capture_auto_calibration v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_gravity_noise[] = {0, 1, 0, 0, 0, 0};

static void read_gravity_noise(struct mip_reader *r, void *value) {
    struct mip_filter_gravity_noise *v = (struct mip_filter_gravity_noise *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_gravity_noise, sizeof(required_gravity_noise));
    mip_read_group(r, 1, 1);
    mip_read_float(r, v->noise, 3);
    v->present = mip_read_present(r);
}

static void write_gravity_noise(struct mip_writer *w, const void *value) {
    const struct mip_filter_gravity_noise *v = (const struct mip_filter_gravity_noise *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_gravity_noise, sizeof(required_gravity_noise),
                       v->present);
    mip_write_group(w, 1, 1);
    mip_write_float(w, v->noise, 3);
}

static bool asked_gravity_noise_1(const void *value) {
    const struct mip_filter_gravity_noise *v = (const struct mip_filter_gravity_noise *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_gravity_noise[] = {
    {&mip_filter_gravity_noise_response_codec, asked_gravity_noise_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_gravity_noise_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_GRAVITY_NOISE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_gravity_noise),
    0, /* time-out */
    read_gravity_noise,
    write_gravity_noise,
    NULL,
    responses_gravity_noise,
    NULL,
};

mip_error mip_filter_gravity_noise_decode(struct mip_filter_gravity_noise *value,
                                          const struct mip_field *field) {
    return mip_decode_field(field, read_gravity_noise, value, sizeof(*value), NULL);
}

mip_error mip_filter_gravity_noise_encode(const struct mip_filter_gravity_noise *value,
                                          struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_GRAVITY_NOISE_DESCRIPTOR, write_gravity_noise,
                            value);
}

struct mip_filter_gravity_noise mip_filter_gravity_noise_write(const float noise[3]) {
    struct mip_filter_gravity_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(v.noise, noise, sizeof(v.noise));
    return v;
}

struct mip_filter_gravity_noise mip_filter_gravity_noise_read(void) {
    struct mip_filter_gravity_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_gravity_noise mip_filter_gravity_noise_save(void) {
    struct mip_filter_gravity_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_gravity_noise mip_filter_gravity_noise_load(void) {
    struct mip_filter_gravity_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_gravity_noise mip_filter_gravity_noise_default(void) {
    struct mip_filter_gravity_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_gravity_noise_response(struct mip_reader *r, void *value) {
    struct mip_filter_gravity_noise_response *v = (struct mip_filter_gravity_noise_response *)value;
    mip_read_float(r, v->noise, 3);
}

static void write_gravity_noise_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_gravity_noise_response *v =
        (const struct mip_filter_gravity_noise_response *)value;
    mip_write_float(w, v->noise, 3);
}

const struct mip_codec mip_filter_gravity_noise_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_GRAVITY_NOISE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_gravity_noise_response),
    0, /* time-out */
    read_gravity_noise_response,
    write_gravity_noise_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_gravity_noise_response_decode(struct mip_filter_gravity_noise_response *value,
                                                   const struct mip_field *field) {
    return mip_decode_field(field, read_gravity_noise_response, value, sizeof(*value), NULL);
}

mip_error mip_filter_gravity_noise_response_encode(
    const struct mip_filter_gravity_noise_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_GRAVITY_NOISE_RESPONSE_DESCRIPTOR,
                            write_gravity_noise_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_pressure_altitude_noise[] = {0, 1, 0, 0, 0, 0};

static void read_pressure_altitude_noise(struct mip_reader *r, void *value) {
    struct mip_filter_pressure_altitude_noise *v =
        (struct mip_filter_pressure_altitude_noise *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_pressure_altitude_noise,
                      sizeof(required_pressure_altitude_noise));
    mip_read_group(r, 1, 1);
    mip_read_float(r, &v->noise, 1);
    v->present = mip_read_present(r);
}

static void write_pressure_altitude_noise(struct mip_writer *w, const void *value) {
    const struct mip_filter_pressure_altitude_noise *v =
        (const struct mip_filter_pressure_altitude_noise *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_pressure_altitude_noise,
                       sizeof(required_pressure_altitude_noise), v->present);
    mip_write_group(w, 1, 1);
    mip_write_float(w, &v->noise, 1);
}

static bool asked_pressure_altitude_noise_1(const void *value) {
    const struct mip_filter_pressure_altitude_noise *v =
        (const struct mip_filter_pressure_altitude_noise *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_pressure_altitude_noise[] = {
    {&mip_filter_pressure_altitude_noise_response_codec, asked_pressure_altitude_noise_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_pressure_altitude_noise_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_PRESSURE_ALTITUDE_NOISE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_pressure_altitude_noise),
    0, /* time-out */
    read_pressure_altitude_noise,
    write_pressure_altitude_noise,
    NULL,
    responses_pressure_altitude_noise,
    NULL,
};

mip_error mip_filter_pressure_altitude_noise_decode(
    struct mip_filter_pressure_altitude_noise *value, const struct mip_field *field) {
    return mip_decode_field(field, read_pressure_altitude_noise, value, sizeof(*value), NULL);
}

mip_error mip_filter_pressure_altitude_noise_encode(
    const struct mip_filter_pressure_altitude_noise *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_PRESSURE_ALTITUDE_NOISE_DESCRIPTOR,
                            write_pressure_altitude_noise, value);
}

struct mip_filter_pressure_altitude_noise mip_filter_pressure_altitude_noise_write(float noise) {
    struct mip_filter_pressure_altitude_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.noise = noise;
    return v;
}

struct mip_filter_pressure_altitude_noise mip_filter_pressure_altitude_noise_read(void) {
    struct mip_filter_pressure_altitude_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_pressure_altitude_noise mip_filter_pressure_altitude_noise_save(void) {
    struct mip_filter_pressure_altitude_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_pressure_altitude_noise mip_filter_pressure_altitude_noise_load(void) {
    struct mip_filter_pressure_altitude_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_pressure_altitude_noise mip_filter_pressure_altitude_noise_default(void) {
    struct mip_filter_pressure_altitude_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_pressure_altitude_noise_response(struct mip_reader *r, void *value) {
    struct mip_filter_pressure_altitude_noise_response *v =
        (struct mip_filter_pressure_altitude_noise_response *)value;
    mip_read_float(r, &v->noise, 1);
}

static void write_pressure_altitude_noise_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_pressure_altitude_noise_response *v =
        (const struct mip_filter_pressure_altitude_noise_response *)value;
    mip_write_float(w, &v->noise, 1);
}

const struct mip_codec mip_filter_pressure_altitude_noise_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_PRESSURE_ALTITUDE_NOISE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_pressure_altitude_noise_response),
    0, /* time-out */
    read_pressure_altitude_noise_response,
    write_pressure_altitude_noise_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_pressure_altitude_noise_response_decode(
    struct mip_filter_pressure_altitude_noise_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_pressure_altitude_noise_response, value, sizeof(*value),
                            NULL);
}

mip_error mip_filter_pressure_altitude_noise_response_encode(
    const struct mip_filter_pressure_altitude_noise_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_PRESSURE_ALTITUDE_NOISE_RESPONSE_DESCRIPTOR,
                            write_pressure_altitude_noise_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_hard_iron_offset_noise[] = {0, 1, 0, 0, 0, 0};

static void read_hard_iron_offset_noise(struct mip_reader *r, void *value) {
    struct mip_filter_hard_iron_offset_noise *v = (struct mip_filter_hard_iron_offset_noise *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_hard_iron_offset_noise,
                      sizeof(required_hard_iron_offset_noise));
    mip_read_group(r, 1, 1);
    mip_read_float(r, v->noise, 3);
    v->present = mip_read_present(r);
}

static void write_hard_iron_offset_noise(struct mip_writer *w, const void *value) {
    const struct mip_filter_hard_iron_offset_noise *v =
        (const struct mip_filter_hard_iron_offset_noise *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_hard_iron_offset_noise,
                       sizeof(required_hard_iron_offset_noise), v->present);
    mip_write_group(w, 1, 1);
    mip_write_float(w, v->noise, 3);
}

static bool asked_hard_iron_offset_noise_1(const void *value) {
    const struct mip_filter_hard_iron_offset_noise *v =
        (const struct mip_filter_hard_iron_offset_noise *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_hard_iron_offset_noise[] = {
    {&mip_filter_hard_iron_offset_noise_response_codec, asked_hard_iron_offset_noise_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_hard_iron_offset_noise_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_HARD_IRON_OFFSET_NOISE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_hard_iron_offset_noise),
    0, /* time-out */
    read_hard_iron_offset_noise,
    write_hard_iron_offset_noise,
    NULL,
    responses_hard_iron_offset_noise,
    NULL,
};

mip_error mip_filter_hard_iron_offset_noise_decode(struct mip_filter_hard_iron_offset_noise *value,
                                                   const struct mip_field *field) {
    return mip_decode_field(field, read_hard_iron_offset_noise, value, sizeof(*value), NULL);
}

mip_error mip_filter_hard_iron_offset_noise_encode(
    const struct mip_filter_hard_iron_offset_noise *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_HARD_IRON_OFFSET_NOISE_DESCRIPTOR,
                            write_hard_iron_offset_noise, value);
}

struct mip_filter_hard_iron_offset_noise
mip_filter_hard_iron_offset_noise_write(const float noise[3]) {
    struct mip_filter_hard_iron_offset_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(v.noise, noise, sizeof(v.noise));
    return v;
}

struct mip_filter_hard_iron_offset_noise mip_filter_hard_iron_offset_noise_read(void) {
    struct mip_filter_hard_iron_offset_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_hard_iron_offset_noise mip_filter_hard_iron_offset_noise_save(void) {
    struct mip_filter_hard_iron_offset_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_hard_iron_offset_noise mip_filter_hard_iron_offset_noise_load(void) {
    struct mip_filter_hard_iron_offset_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_hard_iron_offset_noise mip_filter_hard_iron_offset_noise_default(void) {
    struct mip_filter_hard_iron_offset_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_hard_iron_offset_noise_response(struct mip_reader *r, void *value) {
    struct mip_filter_hard_iron_offset_noise_response *v =
        (struct mip_filter_hard_iron_offset_noise_response *)value;
    mip_read_float(r, v->noise, 3);
}

static void write_hard_iron_offset_noise_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_hard_iron_offset_noise_response *v =
        (const struct mip_filter_hard_iron_offset_noise_response *)value;
    mip_write_float(w, v->noise, 3);
}

const struct mip_codec mip_filter_hard_iron_offset_noise_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_HARD_IRON_OFFSET_NOISE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_hard_iron_offset_noise_response),
    0, /* time-out */
    read_hard_iron_offset_noise_response,
    write_hard_iron_offset_noise_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_hard_iron_offset_noise_response_decode(
    struct mip_filter_hard_iron_offset_noise_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_hard_iron_offset_noise_response, value, sizeof(*value),
                            NULL);
}

mip_error mip_filter_hard_iron_offset_noise_response_encode(
    const struct mip_filter_hard_iron_offset_noise_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_HARD_IRON_OFFSET_NOISE_RESPONSE_DESCRIPTOR,
                            write_hard_iron_offset_noise_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_soft_iron_matrix_noise[] = {0, 1, 0, 0, 0, 0};

static void read_soft_iron_matrix_noise(struct mip_reader *r, void *value) {
    struct mip_filter_soft_iron_matrix_noise *v = (struct mip_filter_soft_iron_matrix_noise *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_soft_iron_matrix_noise,
                      sizeof(required_soft_iron_matrix_noise));
    mip_read_group(r, 1, 1);
    mip_read_float(r, v->noise, 9);
    v->present = mip_read_present(r);
}

static void write_soft_iron_matrix_noise(struct mip_writer *w, const void *value) {
    const struct mip_filter_soft_iron_matrix_noise *v =
        (const struct mip_filter_soft_iron_matrix_noise *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_soft_iron_matrix_noise,
                       sizeof(required_soft_iron_matrix_noise), v->present);
    mip_write_group(w, 1, 1);
    mip_write_float(w, v->noise, 9);
}

static bool asked_soft_iron_matrix_noise_1(const void *value) {
    const struct mip_filter_soft_iron_matrix_noise *v =
        (const struct mip_filter_soft_iron_matrix_noise *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_soft_iron_matrix_noise[] = {
    {&mip_filter_soft_iron_matrix_noise_response_codec, asked_soft_iron_matrix_noise_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_soft_iron_matrix_noise_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_SOFT_IRON_MATRIX_NOISE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_soft_iron_matrix_noise),
    0, /* time-out */
    read_soft_iron_matrix_noise,
    write_soft_iron_matrix_noise,
    NULL,
    responses_soft_iron_matrix_noise,
    NULL,
};

mip_error mip_filter_soft_iron_matrix_noise_decode(struct mip_filter_soft_iron_matrix_noise *value,
                                                   const struct mip_field *field) {
    return mip_decode_field(field, read_soft_iron_matrix_noise, value, sizeof(*value), NULL);
}

mip_error mip_filter_soft_iron_matrix_noise_encode(
    const struct mip_filter_soft_iron_matrix_noise *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_SOFT_IRON_MATRIX_NOISE_DESCRIPTOR,
                            write_soft_iron_matrix_noise, value);
}

struct mip_filter_soft_iron_matrix_noise
mip_filter_soft_iron_matrix_noise_write(const float noise[9]) {
    struct mip_filter_soft_iron_matrix_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(v.noise, noise, sizeof(v.noise));
    return v;
}

struct mip_filter_soft_iron_matrix_noise mip_filter_soft_iron_matrix_noise_read(void) {
    struct mip_filter_soft_iron_matrix_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_soft_iron_matrix_noise mip_filter_soft_iron_matrix_noise_save(void) {
    struct mip_filter_soft_iron_matrix_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_soft_iron_matrix_noise mip_filter_soft_iron_matrix_noise_load(void) {
    struct mip_filter_soft_iron_matrix_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_soft_iron_matrix_noise mip_filter_soft_iron_matrix_noise_default(void) {
    struct mip_filter_soft_iron_matrix_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_soft_iron_matrix_noise_response(struct mip_reader *r, void *value) {
    struct mip_filter_soft_iron_matrix_noise_response *v =
        (struct mip_filter_soft_iron_matrix_noise_response *)value;
    mip_read_float(r, v->noise, 9);
}

static void write_soft_iron_matrix_noise_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_soft_iron_matrix_noise_response *v =
        (const struct mip_filter_soft_iron_matrix_noise_response *)value;
    mip_write_float(w, v->noise, 9);
}

const struct mip_codec mip_filter_soft_iron_matrix_noise_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_SOFT_IRON_MATRIX_NOISE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_soft_iron_matrix_noise_response),
    0, /* time-out */
    read_soft_iron_matrix_noise_response,
    write_soft_iron_matrix_noise_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_soft_iron_matrix_noise_response_decode(
    struct mip_filter_soft_iron_matrix_noise_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_soft_iron_matrix_noise_response, value, sizeof(*value),
                            NULL);
}

mip_error mip_filter_soft_iron_matrix_noise_response_encode(
    const struct mip_filter_soft_iron_matrix_noise_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_SOFT_IRON_MATRIX_NOISE_RESPONSE_DESCRIPTOR,
                            write_soft_iron_matrix_noise_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_enable_measurements[] = {0, 1, 0, 0, 0, 0};

static void read_enable_measurements(struct mip_reader *r, void *value) {
    struct mip_filter_enable_measurements *v = (struct mip_filter_enable_measurements *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_enable_measurements,
                      sizeof(required_enable_measurements));
    mip_read_group(r, 1, 1);
    mip_read_u16(r, &v->control, 1);
    v->present = mip_read_present(r);
}

static void write_enable_measurements(struct mip_writer *w, const void *value) {
    const struct mip_filter_enable_measurements *v =
        (const struct mip_filter_enable_measurements *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_enable_measurements,
                       sizeof(required_enable_measurements), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u16(w, &v->control, 1);
}

static bool asked_enable_measurements_1(const void *value) {
    const struct mip_filter_enable_measurements *v =
        (const struct mip_filter_enable_measurements *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_enable_measurements[] = {
    {&mip_filter_enable_measurements_response_codec, asked_enable_measurements_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_enable_measurements_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_ENABLE_MEASUREMENTS_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_enable_measurements),
    0, /* time-out */
    read_enable_measurements,
    write_enable_measurements,
    NULL,
    responses_enable_measurements,
    NULL,
};

mip_error mip_filter_enable_measurements_decode(struct mip_filter_enable_measurements *value,
                                                const struct mip_field *field) {
    return mip_decode_field(field, read_enable_measurements, value, sizeof(*value), NULL);
}

mip_error mip_filter_enable_measurements_encode(const struct mip_filter_enable_measurements *value,
                                                struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_ENABLE_MEASUREMENTS_DESCRIPTOR,
                            write_enable_measurements, value);
}

struct mip_filter_enable_measurements
mip_filter_enable_measurements_write(mip_filter_measurement_flags control) {
    struct mip_filter_enable_measurements v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.control = control;
    return v;
}

struct mip_filter_enable_measurements mip_filter_enable_measurements_read(void) {
    struct mip_filter_enable_measurements v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_enable_measurements mip_filter_enable_measurements_save(void) {
    struct mip_filter_enable_measurements v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_enable_measurements mip_filter_enable_measurements_load(void) {
    struct mip_filter_enable_measurements v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_enable_measurements mip_filter_enable_measurements_default(void) {
    struct mip_filter_enable_measurements v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_enable_measurements_response(struct mip_reader *r, void *value) {
    struct mip_filter_enable_measurements_response *v =
        (struct mip_filter_enable_measurements_response *)value;
    mip_read_u16(r, &v->control, 1);
}

static void write_enable_measurements_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_enable_measurements_response *v =
        (const struct mip_filter_enable_measurements_response *)value;
    mip_write_u16(w, &v->control, 1);
}

const struct mip_codec mip_filter_enable_measurements_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_ENABLE_MEASUREMENTS_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_enable_measurements_response),
    0, /* time-out */
    read_enable_measurements_response,
    write_enable_measurements_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_enable_measurements_response_decode(
    struct mip_filter_enable_measurements_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_enable_measurements_response, value, sizeof(*value), NULL);
}

mip_error mip_filter_enable_measurements_response_encode(
    const struct mip_filter_enable_measurements_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_ENABLE_MEASUREMENTS_RESPONSE_DESCRIPTOR,
                            write_enable_measurements_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_mag_noise[] = {0, 1, 0, 0, 0, 0};

static void read_mag_noise(struct mip_reader *r, void *value) {
    struct mip_filter_mag_noise *v = (struct mip_filter_mag_noise *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_mag_noise, sizeof(required_mag_noise));
    mip_read_group(r, 1, 1);
    mip_read_float(r, v->noise, 3);
    v->present = mip_read_present(r);
}

static void write_mag_noise(struct mip_writer *w, const void *value) {
    const struct mip_filter_mag_noise *v = (const struct mip_filter_mag_noise *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_mag_noise, sizeof(required_mag_noise), v->present);
    mip_write_group(w, 1, 1);
    mip_write_float(w, v->noise, 3);
}

static bool asked_mag_noise_1(const void *value) {
    const struct mip_filter_mag_noise *v = (const struct mip_filter_mag_noise *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_mag_noise[] = {
    {&mip_filter_mag_noise_response_codec, asked_mag_noise_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_mag_noise_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_MAG_NOISE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_mag_noise),
    0, /* time-out */
    read_mag_noise,
    write_mag_noise,
    NULL,
    responses_mag_noise,
    NULL,
};

mip_error mip_filter_mag_noise_decode(struct mip_filter_mag_noise *value,
                                      const struct mip_field *field) {
    return mip_decode_field(field, read_mag_noise, value, sizeof(*value), NULL);
}

mip_error mip_filter_mag_noise_encode(const struct mip_filter_mag_noise *value,
                                      struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_MAG_NOISE_DESCRIPTOR, write_mag_noise, value);
}

struct mip_filter_mag_noise mip_filter_mag_noise_write(const float noise[3]) {
    struct mip_filter_mag_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(v.noise, noise, sizeof(v.noise));
    return v;
}

struct mip_filter_mag_noise mip_filter_mag_noise_read(void) {
    struct mip_filter_mag_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_mag_noise mip_filter_mag_noise_save(void) {
    struct mip_filter_mag_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_mag_noise mip_filter_mag_noise_load(void) {
    struct mip_filter_mag_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_mag_noise mip_filter_mag_noise_default(void) {
    struct mip_filter_mag_noise v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_mag_noise_response(struct mip_reader *r, void *value) {
    struct mip_filter_mag_noise_response *v = (struct mip_filter_mag_noise_response *)value;
    mip_read_float(r, v->noise, 3);
}

static void write_mag_noise_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_mag_noise_response *v =
        (const struct mip_filter_mag_noise_response *)value;
    mip_write_float(w, v->noise, 3);
}

const struct mip_codec mip_filter_mag_noise_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_MAG_NOISE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_mag_noise_response),
    0, /* time-out */
    read_mag_noise_response,
    write_mag_noise_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_mag_noise_response_decode(struct mip_filter_mag_noise_response *value,
                                               const struct mip_field *field) {
    return mip_decode_field(field, read_mag_noise_response, value, sizeof(*value), NULL);
}

mip_error mip_filter_mag_noise_response_encode(const struct mip_filter_mag_noise_response *value,
                                               struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_MAG_NOISE_RESPONSE_DESCRIPTOR,
                            write_mag_noise_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_magnetic_declination_source[] = {0, 2, 0, 0, 0, 0};

static void read_magnetic_declination_source(struct mip_reader *r, void *value) {
    struct mip_filter_magnetic_declination_source *v =
        (struct mip_filter_magnetic_declination_source *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_magnetic_declination_source,
                      sizeof(required_magnetic_declination_source));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->source, 1);
    mip_read_group(r, 2, 2);
    mip_read_float(r, &v->declination, 1);
    v->present = mip_read_present(r);
}

static void write_magnetic_declination_source(struct mip_writer *w, const void *value) {
    const struct mip_filter_magnetic_declination_source *v =
        (const struct mip_filter_magnetic_declination_source *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_magnetic_declination_source,
                       sizeof(required_magnetic_declination_source), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->source, 1);
    mip_write_group(w, 2, 2);
    mip_write_float(w, &v->declination, 1);
}

static bool asked_magnetic_declination_source_1(const void *value) {
    const struct mip_filter_magnetic_declination_source *v =
        (const struct mip_filter_magnetic_declination_source *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_magnetic_declination_source[] = {
    {&mip_filter_magnetic_declination_source_response_codec, asked_magnetic_declination_source_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_magnetic_declination_source_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_MAGNETIC_DECLINATION_SOURCE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_magnetic_declination_source),
    0, /* time-out */
    read_magnetic_declination_source,
    write_magnetic_declination_source,
    NULL,
    responses_magnetic_declination_source,
    NULL,
};

mip_error mip_filter_magnetic_declination_source_decode(
    struct mip_filter_magnetic_declination_source *value, const struct mip_field *field) {
    return mip_decode_field(field, read_magnetic_declination_source, value, sizeof(*value), NULL);
}

mip_error mip_filter_magnetic_declination_source_encode(
    const struct mip_filter_magnetic_declination_source *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_MAGNETIC_DECLINATION_SOURCE_DESCRIPTOR,
                            write_magnetic_declination_source, value);
}

struct mip_filter_magnetic_declination_source mip_filter_magnetic_declination_source_write(
    mip_filter_mag_parameter_source source, float declination) {
    struct mip_filter_magnetic_declination_source v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.source = source;
    v.declination = declination;
    return v;
}

struct mip_filter_magnetic_declination_source mip_filter_magnetic_declination_source_read(void) {
    struct mip_filter_magnetic_declination_source v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_magnetic_declination_source mip_filter_magnetic_declination_source_save(void) {
    struct mip_filter_magnetic_declination_source v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_magnetic_declination_source mip_filter_magnetic_declination_source_load(void) {
    struct mip_filter_magnetic_declination_source v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_magnetic_declination_source mip_filter_magnetic_declination_source_default(void) {
    struct mip_filter_magnetic_declination_source v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_magnetic_declination_source_response(struct mip_reader *r, void *value) {
    struct mip_filter_magnetic_declination_source_response *v =
        (struct mip_filter_magnetic_declination_source_response *)value;
    mip_read_u8(r, &v->source, 1);
    mip_read_float(r, &v->declination, 1);
}

static void write_magnetic_declination_source_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_magnetic_declination_source_response *v =
        (const struct mip_filter_magnetic_declination_source_response *)value;
    mip_write_u8(w, &v->source, 1);
    mip_write_float(w, &v->declination, 1);
}

const struct mip_codec mip_filter_magnetic_declination_source_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_MAGNETIC_DECLINATION_SOURCE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_magnetic_declination_source_response),
    0, /* time-out */
    read_magnetic_declination_source_response,
    write_magnetic_declination_source_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_magnetic_declination_source_response_decode(
    struct mip_filter_magnetic_declination_source_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_magnetic_declination_source_response, value, sizeof(*value),
                            NULL);
}

mip_error mip_filter_magnetic_declination_source_response_encode(
    const struct mip_filter_magnetic_declination_source_response *value,
    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D,
                            MIP_FILTER_MAGNETIC_DECLINATION_SOURCE_RESPONSE_DESCRIPTOR,
                            write_magnetic_declination_source_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_accel_magnitude_error_adaptive_measurement[] = {0, 1, 0, 0, 0, 0};

static void read_accel_magnitude_error_adaptive_measurement(struct mip_reader *r, void *value) {
    struct mip_filter_accel_magnitude_adaptive *v =
        (struct mip_filter_accel_magnitude_adaptive *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_accel_magnitude_error_adaptive_measurement,
                      sizeof(required_accel_magnitude_error_adaptive_measurement));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->adaptive_measurement, 1);
    mip_read_group(r, 2, 2);
    mip_read_float(r, &v->frequency, 1);
    mip_read_group(r, 3, 3);
    mip_read_float(r, &v->low_limit, 1);
    mip_read_group(r, 4, 4);
    mip_read_float(r, &v->high_limit, 1);
    mip_read_group(r, 5, 5);
    mip_read_float(r, &v->low_limit_uncertainty, 1);
    mip_read_group(r, 6, 6);
    mip_read_float(r, &v->high_limit_uncertainty, 1);
    mip_read_group(r, 7, 7);
    mip_read_float(r, &v->minimum_uncertainty, 1);
    v->present = mip_read_present(r);
}

static void write_accel_magnitude_error_adaptive_measurement(struct mip_writer *w,
                                                             const void *value) {
    const struct mip_filter_accel_magnitude_adaptive *v =
        (const struct mip_filter_accel_magnitude_adaptive *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_accel_magnitude_error_adaptive_measurement,
                       sizeof(required_accel_magnitude_error_adaptive_measurement), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->adaptive_measurement, 1);
    mip_write_group(w, 2, 2);
    mip_write_float(w, &v->frequency, 1);
    mip_write_group(w, 3, 3);
    mip_write_float(w, &v->low_limit, 1);
    mip_write_group(w, 4, 4);
    mip_write_float(w, &v->high_limit, 1);
    mip_write_group(w, 5, 5);
    mip_write_float(w, &v->low_limit_uncertainty, 1);
    mip_write_group(w, 6, 6);
    mip_write_float(w, &v->high_limit_uncertainty, 1);
    mip_write_group(w, 7, 7);
    mip_write_float(w, &v->minimum_uncertainty, 1);
}

static bool asked_accel_magnitude_error_adaptive_measurement_1(const void *value) {
    const struct mip_filter_accel_magnitude_adaptive *v =
        (const struct mip_filter_accel_magnitude_adaptive *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_accel_magnitude_error_adaptive_measurement[] = {
    {&mip_filter_accel_magnitude_adaptive_response_codec,
     asked_accel_magnitude_error_adaptive_measurement_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_accel_magnitude_adaptive_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_accel_magnitude_adaptive),
    0, /* time-out */
    read_accel_magnitude_error_adaptive_measurement,
    write_accel_magnitude_error_adaptive_measurement,
    NULL,
    responses_accel_magnitude_error_adaptive_measurement,
    NULL,
};

mip_error mip_filter_accel_magnitude_adaptive_decode(
    struct mip_filter_accel_magnitude_adaptive *value, const struct mip_field *field) {
    return mip_decode_field(field, read_accel_magnitude_error_adaptive_measurement, value,
                            sizeof(*value), NULL);
}

mip_error mip_filter_accel_magnitude_adaptive_encode(
    const struct mip_filter_accel_magnitude_adaptive *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_DESCRIPTOR,
                            write_accel_magnitude_error_adaptive_measurement, value);
}

struct mip_filter_accel_magnitude_adaptive mip_filter_accel_magnitude_adaptive_write(
    mip_filter_adaptive_measurement_selector adaptive_measurement) {
    struct mip_filter_accel_magnitude_adaptive v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.adaptive_measurement = adaptive_measurement;
    return v;
}

struct mip_filter_accel_magnitude_adaptive mip_filter_accel_magnitude_adaptive_read(void) {
    struct mip_filter_accel_magnitude_adaptive v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_accel_magnitude_adaptive mip_filter_accel_magnitude_adaptive_save(void) {
    struct mip_filter_accel_magnitude_adaptive v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_accel_magnitude_adaptive mip_filter_accel_magnitude_adaptive_load(void) {
    struct mip_filter_accel_magnitude_adaptive v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_accel_magnitude_adaptive mip_filter_accel_magnitude_adaptive_default(void) {
    struct mip_filter_accel_magnitude_adaptive v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_accel_magnitude_error_adaptive_measurement_response(struct mip_reader *r,
                                                                     void *value) {
    struct mip_filter_accel_magnitude_adaptive_response *v =
        (struct mip_filter_accel_magnitude_adaptive_response *)value;
    mip_read_u8(r, &v->adaptive_measurement, 1);
    mip_read_float(r, &v->frequency, 1);
    mip_read_float(r, &v->low_limit, 1);
    mip_read_float(r, &v->high_limit, 1);
    mip_read_float(r, &v->low_limit_uncertainty, 1);
    mip_read_float(r, &v->high_limit_uncertainty, 1);
    mip_read_float(r, &v->minimum_uncertainty, 1);
}

static void write_accel_magnitude_error_adaptive_measurement_response(struct mip_writer *w,
                                                                      const void *value) {
    const struct mip_filter_accel_magnitude_adaptive_response *v =
        (const struct mip_filter_accel_magnitude_adaptive_response *)value;
    mip_write_u8(w, &v->adaptive_measurement, 1);
    mip_write_float(w, &v->frequency, 1);
    mip_write_float(w, &v->low_limit, 1);
    mip_write_float(w, &v->high_limit, 1);
    mip_write_float(w, &v->low_limit_uncertainty, 1);
    mip_write_float(w, &v->high_limit_uncertainty, 1);
    mip_write_float(w, &v->minimum_uncertainty, 1);
}

const struct mip_codec mip_filter_accel_magnitude_adaptive_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_accel_magnitude_adaptive_response),
    0, /* time-out */
    read_accel_magnitude_error_adaptive_measurement_response,
    write_accel_magnitude_error_adaptive_measurement_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_accel_magnitude_adaptive_response_decode(
    struct mip_filter_accel_magnitude_adaptive_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_accel_magnitude_error_adaptive_measurement_response, value,
                            sizeof(*value), NULL);
}

mip_error mip_filter_accel_magnitude_adaptive_response_encode(
    const struct mip_filter_accel_magnitude_adaptive_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_RESPONSE_DESCRIPTOR,
                            write_accel_magnitude_error_adaptive_measurement_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_mag_magnitude_error_adaptive_measurement[] = {0, 7, 0, 0, 0, 0};

static void read_mag_magnitude_error_adaptive_measurement(struct mip_reader *r, void *value) {
    struct mip_filter_mag_magnitude_adaptive *v = (struct mip_filter_mag_magnitude_adaptive *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_mag_magnitude_error_adaptive_measurement,
                      sizeof(required_mag_magnitude_error_adaptive_measurement));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->adaptive_measurement, 1);
    mip_read_group(r, 2, 2);
    mip_read_float(r, &v->frequency, 1);
    mip_read_group(r, 3, 3);
    mip_read_float(r, &v->low_limit, 1);
    mip_read_group(r, 4, 4);
    mip_read_float(r, &v->high_limit, 1);
    mip_read_group(r, 5, 5);
    mip_read_float(r, &v->low_limit_uncertainty, 1);
    mip_read_group(r, 6, 6);
    mip_read_float(r, &v->high_limit_uncertainty, 1);
    mip_read_group(r, 7, 7);
    mip_read_float(r, &v->minimum_uncertainty, 1);
    v->present = mip_read_present(r);
}

static void write_mag_magnitude_error_adaptive_measurement(struct mip_writer *w,
                                                           const void *value) {
    const struct mip_filter_mag_magnitude_adaptive *v =
        (const struct mip_filter_mag_magnitude_adaptive *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_mag_magnitude_error_adaptive_measurement,
                       sizeof(required_mag_magnitude_error_adaptive_measurement), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->adaptive_measurement, 1);
    mip_write_group(w, 2, 2);
    mip_write_float(w, &v->frequency, 1);
    mip_write_group(w, 3, 3);
    mip_write_float(w, &v->low_limit, 1);
    mip_write_group(w, 4, 4);
    mip_write_float(w, &v->high_limit, 1);
    mip_write_group(w, 5, 5);
    mip_write_float(w, &v->low_limit_uncertainty, 1);
    mip_write_group(w, 6, 6);
    mip_write_float(w, &v->high_limit_uncertainty, 1);
    mip_write_group(w, 7, 7);
    mip_write_float(w, &v->minimum_uncertainty, 1);
}

static bool asked_mag_magnitude_error_adaptive_measurement_1(const void *value) {
    const struct mip_filter_mag_magnitude_adaptive *v =
        (const struct mip_filter_mag_magnitude_adaptive *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_mag_magnitude_error_adaptive_measurement[] = {
    {&mip_filter_mag_magnitude_adaptive_response_codec,
     asked_mag_magnitude_error_adaptive_measurement_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_mag_magnitude_adaptive_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_MAG_MAGNITUDE_ADAPTIVE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_mag_magnitude_adaptive),
    0, /* time-out */
    read_mag_magnitude_error_adaptive_measurement,
    write_mag_magnitude_error_adaptive_measurement,
    NULL,
    responses_mag_magnitude_error_adaptive_measurement,
    NULL,
};

mip_error mip_filter_mag_magnitude_adaptive_decode(struct mip_filter_mag_magnitude_adaptive *value,
                                                   const struct mip_field *field) {
    return mip_decode_field(field, read_mag_magnitude_error_adaptive_measurement, value,
                            sizeof(*value), NULL);
}

mip_error mip_filter_mag_magnitude_adaptive_encode(
    const struct mip_filter_mag_magnitude_adaptive *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_MAG_MAGNITUDE_ADAPTIVE_DESCRIPTOR,
                            write_mag_magnitude_error_adaptive_measurement, value);
}

struct mip_filter_mag_magnitude_adaptive mip_filter_mag_magnitude_adaptive_write(
    mip_filter_adaptive_measurement_selector adaptive_measurement, float frequency, float low_limit,
    float high_limit, float low_limit_uncertainty, float high_limit_uncertainty,
    float minimum_uncertainty) {
    struct mip_filter_mag_magnitude_adaptive v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.adaptive_measurement = adaptive_measurement;
    v.frequency = frequency;
    v.low_limit = low_limit;
    v.high_limit = high_limit;
    v.low_limit_uncertainty = low_limit_uncertainty;
    v.high_limit_uncertainty = high_limit_uncertainty;
    v.minimum_uncertainty = minimum_uncertainty;
    return v;
}

struct mip_filter_mag_magnitude_adaptive mip_filter_mag_magnitude_adaptive_read(void) {
    struct mip_filter_mag_magnitude_adaptive v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_mag_magnitude_adaptive mip_filter_mag_magnitude_adaptive_save(void) {
    struct mip_filter_mag_magnitude_adaptive v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_mag_magnitude_adaptive mip_filter_mag_magnitude_adaptive_load(void) {
    struct mip_filter_mag_magnitude_adaptive v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_mag_magnitude_adaptive mip_filter_mag_magnitude_adaptive_default(void) {
    struct mip_filter_mag_magnitude_adaptive v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_mag_magnitude_error_adaptive_measurement_response(struct mip_reader *r,
                                                                   void *value) {
    struct mip_filter_mag_magnitude_adaptive_response *v =
        (struct mip_filter_mag_magnitude_adaptive_response *)value;
    mip_read_u8(r, &v->adaptive_measurement, 1);
    mip_read_float(r, &v->frequency, 1);
    mip_read_float(r, &v->low_limit, 1);
    mip_read_float(r, &v->high_limit, 1);
    mip_read_float(r, &v->low_limit_uncertainty, 1);
    mip_read_float(r, &v->high_limit_uncertainty, 1);
    mip_read_float(r, &v->minimum_uncertainty, 1);
}

static void write_mag_magnitude_error_adaptive_measurement_response(struct mip_writer *w,
                                                                    const void *value) {
    const struct mip_filter_mag_magnitude_adaptive_response *v =
        (const struct mip_filter_mag_magnitude_adaptive_response *)value;
    mip_write_u8(w, &v->adaptive_measurement, 1);
    mip_write_float(w, &v->frequency, 1);
    mip_write_float(w, &v->low_limit, 1);
    mip_write_float(w, &v->high_limit, 1);
    mip_write_float(w, &v->low_limit_uncertainty, 1);
    mip_write_float(w, &v->high_limit_uncertainty, 1);
    mip_write_float(w, &v->minimum_uncertainty, 1);
}

const struct mip_codec mip_filter_mag_magnitude_adaptive_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_MAG_MAGNITUDE_ADAPTIVE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_mag_magnitude_adaptive_response),
    0, /* time-out */
    read_mag_magnitude_error_adaptive_measurement_response,
    write_mag_magnitude_error_adaptive_measurement_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_mag_magnitude_adaptive_response_decode(
    struct mip_filter_mag_magnitude_adaptive_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_mag_magnitude_error_adaptive_measurement_response, value,
                            sizeof(*value), NULL);
}

mip_error mip_filter_mag_magnitude_adaptive_response_encode(
    const struct mip_filter_mag_magnitude_adaptive_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_MAG_MAGNITUDE_ADAPTIVE_RESPONSE_DESCRIPTOR,
                            write_mag_magnitude_error_adaptive_measurement_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_mag_dip_angle_error_adaptive_measurement[] = {0, 5, 0, 0, 0, 0};

static void read_mag_dip_angle_error_adaptive_measurement(struct mip_reader *r, void *value) {
    struct mip_filter_mag_dip_angle_adaptive *v = (struct mip_filter_mag_dip_angle_adaptive *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_mag_dip_angle_error_adaptive_measurement,
                      sizeof(required_mag_dip_angle_error_adaptive_measurement));
    mip_read_group(r, 1, 1);
    mip_read_bool(r, &v->enable, 1);
    mip_read_group(r, 2, 2);
    mip_read_float(r, &v->frequency, 1);
    mip_read_group(r, 3, 3);
    mip_read_float(r, &v->high_limit, 1);
    mip_read_group(r, 4, 4);
    mip_read_float(r, &v->high_limit_uncertainty, 1);
    mip_read_group(r, 5, 5);
    mip_read_float(r, &v->minimum_uncertainty, 1);
    v->present = mip_read_present(r);
}

static void write_mag_dip_angle_error_adaptive_measurement(struct mip_writer *w,
                                                           const void *value) {
    const struct mip_filter_mag_dip_angle_adaptive *v =
        (const struct mip_filter_mag_dip_angle_adaptive *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_mag_dip_angle_error_adaptive_measurement,
                       sizeof(required_mag_dip_angle_error_adaptive_measurement), v->present);
    mip_write_group(w, 1, 1);
    mip_write_bool(w, &v->enable, 1);
    mip_write_group(w, 2, 2);
    mip_write_float(w, &v->frequency, 1);
    mip_write_group(w, 3, 3);
    mip_write_float(w, &v->high_limit, 1);
    mip_write_group(w, 4, 4);
    mip_write_float(w, &v->high_limit_uncertainty, 1);
    mip_write_group(w, 5, 5);
    mip_write_float(w, &v->minimum_uncertainty, 1);
}

static bool asked_mag_dip_angle_error_adaptive_measurement_1(const void *value) {
    const struct mip_filter_mag_dip_angle_adaptive *v =
        (const struct mip_filter_mag_dip_angle_adaptive *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_mag_dip_angle_error_adaptive_measurement[] = {
    {&mip_filter_mag_dip_angle_adaptive_response_codec,
     asked_mag_dip_angle_error_adaptive_measurement_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_mag_dip_angle_adaptive_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_MAG_DIP_ANGLE_ADAPTIVE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_mag_dip_angle_adaptive),
    0, /* time-out */
    read_mag_dip_angle_error_adaptive_measurement,
    write_mag_dip_angle_error_adaptive_measurement,
    NULL,
    responses_mag_dip_angle_error_adaptive_measurement,
    NULL,
};

mip_error mip_filter_mag_dip_angle_adaptive_decode(struct mip_filter_mag_dip_angle_adaptive *value,
                                                   const struct mip_field *field) {
    return mip_decode_field(field, read_mag_dip_angle_error_adaptive_measurement, value,
                            sizeof(*value), NULL);
}

mip_error mip_filter_mag_dip_angle_adaptive_encode(
    const struct mip_filter_mag_dip_angle_adaptive *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_MAG_DIP_ANGLE_ADAPTIVE_DESCRIPTOR,
                            write_mag_dip_angle_error_adaptive_measurement, value);
}

struct mip_filter_mag_dip_angle_adaptive
mip_filter_mag_dip_angle_adaptive_write(mip_bool enable, float frequency, float high_limit,
                                        float high_limit_uncertainty, float minimum_uncertainty) {
    struct mip_filter_mag_dip_angle_adaptive v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.enable = enable;
    v.frequency = frequency;
    v.high_limit = high_limit;
    v.high_limit_uncertainty = high_limit_uncertainty;
    v.minimum_uncertainty = minimum_uncertainty;
    return v;
}

struct mip_filter_mag_dip_angle_adaptive mip_filter_mag_dip_angle_adaptive_read(void) {
    struct mip_filter_mag_dip_angle_adaptive v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_mag_dip_angle_adaptive mip_filter_mag_dip_angle_adaptive_save(void) {
    struct mip_filter_mag_dip_angle_adaptive v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_mag_dip_angle_adaptive mip_filter_mag_dip_angle_adaptive_load(void) {
    struct mip_filter_mag_dip_angle_adaptive v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_mag_dip_angle_adaptive mip_filter_mag_dip_angle_adaptive_default(void) {
    struct mip_filter_mag_dip_angle_adaptive v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_mag_dip_angle_error_adaptive_measurement_response(struct mip_reader *r,
                                                                   void *value) {
    struct mip_filter_mag_dip_angle_adaptive_response *v =
        (struct mip_filter_mag_dip_angle_adaptive_response *)value;
    mip_read_bool(r, &v->enable, 1);
    mip_read_float(r, &v->frequency, 1);
    mip_read_float(r, &v->high_limit, 1);
    mip_read_float(r, &v->high_limit_uncertainty, 1);
    mip_read_float(r, &v->minimum_uncertainty, 1);
}

static void write_mag_dip_angle_error_adaptive_measurement_response(struct mip_writer *w,
                                                                    const void *value) {
    const struct mip_filter_mag_dip_angle_adaptive_response *v =
        (const struct mip_filter_mag_dip_angle_adaptive_response *)value;
    mip_write_bool(w, &v->enable, 1);
    mip_write_float(w, &v->frequency, 1);
    mip_write_float(w, &v->high_limit, 1);
    mip_write_float(w, &v->high_limit_uncertainty, 1);
    mip_write_float(w, &v->minimum_uncertainty, 1);
}

const struct mip_codec mip_filter_mag_dip_angle_adaptive_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_MAG_DIP_ANGLE_ADAPTIVE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_mag_dip_angle_adaptive_response),
    0, /* time-out */
    read_mag_dip_angle_error_adaptive_measurement_response,
    write_mag_dip_angle_error_adaptive_measurement_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_mag_dip_angle_adaptive_response_decode(
    struct mip_filter_mag_dip_angle_adaptive_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_mag_dip_angle_error_adaptive_measurement_response, value,
                            sizeof(*value), NULL);
}

mip_error mip_filter_mag_dip_angle_adaptive_response_encode(
    const struct mip_filter_mag_dip_angle_adaptive_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_MAG_DIP_ANGLE_ADAPTIVE_RESPONSE_DESCRIPTOR,
                            write_mag_dip_angle_error_adaptive_measurement_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_altitude_aiding[] = {0, 1, 0, 0, 0, 0};

static void read_altitude_aiding(struct mip_reader *r, void *value) {
    struct mip_filter_altitude_aiding *v = (struct mip_filter_altitude_aiding *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_altitude_aiding, sizeof(required_altitude_aiding));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->selector, 1);
    v->present = mip_read_present(r);
}

static void write_altitude_aiding(struct mip_writer *w, const void *value) {
    const struct mip_filter_altitude_aiding *v = (const struct mip_filter_altitude_aiding *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_altitude_aiding, sizeof(required_altitude_aiding),
                       v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->selector, 1);
}

static bool asked_altitude_aiding_1(const void *value) {
    const struct mip_filter_altitude_aiding *v = (const struct mip_filter_altitude_aiding *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_altitude_aiding[] = {
    {&mip_filter_altitude_aiding_response_codec, asked_altitude_aiding_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_altitude_aiding_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_ALTITUDE_AIDING_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_altitude_aiding),
    0, /* time-out */
    read_altitude_aiding,
    write_altitude_aiding,
    NULL,
    responses_altitude_aiding,
    NULL,
};

mip_error mip_filter_altitude_aiding_decode(struct mip_filter_altitude_aiding *value,
                                            const struct mip_field *field) {
    return mip_decode_field(field, read_altitude_aiding, value, sizeof(*value), NULL);
}

mip_error mip_filter_altitude_aiding_encode(const struct mip_filter_altitude_aiding *value,
                                            struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_ALTITUDE_AIDING_DESCRIPTOR,
                            write_altitude_aiding, value);
}

struct mip_filter_altitude_aiding
mip_filter_altitude_aiding_write(mip_filter_altitude_aiding_source selector) {
    struct mip_filter_altitude_aiding v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.selector = selector;
    return v;
}

struct mip_filter_altitude_aiding mip_filter_altitude_aiding_read(void) {
    struct mip_filter_altitude_aiding v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_altitude_aiding mip_filter_altitude_aiding_save(void) {
    struct mip_filter_altitude_aiding v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_altitude_aiding mip_filter_altitude_aiding_load(void) {
    struct mip_filter_altitude_aiding v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_altitude_aiding mip_filter_altitude_aiding_default(void) {
    struct mip_filter_altitude_aiding v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_altitude_aiding_response(struct mip_reader *r, void *value) {
    struct mip_filter_altitude_aiding_response *v =
        (struct mip_filter_altitude_aiding_response *)value;
    mip_read_u8(r, &v->selector, 1);
}

static void write_altitude_aiding_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_altitude_aiding_response *v =
        (const struct mip_filter_altitude_aiding_response *)value;
    mip_write_u8(w, &v->selector, 1);
}

const struct mip_codec mip_filter_altitude_aiding_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_ALTITUDE_AIDING_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_altitude_aiding_response),
    0, /* time-out */
    read_altitude_aiding_response,
    write_altitude_aiding_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_altitude_aiding_response_decode(
    struct mip_filter_altitude_aiding_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_altitude_aiding_response, value, sizeof(*value), NULL);
}

mip_error mip_filter_altitude_aiding_response_encode(
    const struct mip_filter_altitude_aiding_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_ALTITUDE_AIDING_RESPONSE_DESCRIPTOR,
                            write_altitude_aiding_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_pitch_roll_aiding[] = {0, 1, 0, 0, 0, 0};

static void read_pitch_roll_aiding(struct mip_reader *r, void *value) {
    struct mip_filter_pitch_roll_aiding *v = (struct mip_filter_pitch_roll_aiding *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_pitch_roll_aiding,
                      sizeof(required_pitch_roll_aiding));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->aiding, 1);
    v->present = mip_read_present(r);
}

static void write_pitch_roll_aiding(struct mip_writer *w, const void *value) {
    const struct mip_filter_pitch_roll_aiding *v =
        (const struct mip_filter_pitch_roll_aiding *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_pitch_roll_aiding,
                       sizeof(required_pitch_roll_aiding), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->aiding, 1);
}

static bool asked_pitch_roll_aiding_1(const void *value) {
    const struct mip_filter_pitch_roll_aiding *v =
        (const struct mip_filter_pitch_roll_aiding *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_pitch_roll_aiding[] = {
    {&mip_filter_pitch_roll_aiding_response_codec, asked_pitch_roll_aiding_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_pitch_roll_aiding_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_PITCH_ROLL_AIDING_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_pitch_roll_aiding),
    0, /* time-out */
    read_pitch_roll_aiding,
    write_pitch_roll_aiding,
    NULL,
    responses_pitch_roll_aiding,
    NULL,
};

mip_error mip_filter_pitch_roll_aiding_decode(struct mip_filter_pitch_roll_aiding *value,
                                              const struct mip_field *field) {
    return mip_decode_field(field, read_pitch_roll_aiding, value, sizeof(*value), NULL);
}

mip_error mip_filter_pitch_roll_aiding_encode(const struct mip_filter_pitch_roll_aiding *value,
                                              struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_PITCH_ROLL_AIDING_DESCRIPTOR,
                            write_pitch_roll_aiding, value);
}

struct mip_filter_pitch_roll_aiding
mip_filter_pitch_roll_aiding_write(mip_filter_pitch_roll_aiding_source aiding) {
    struct mip_filter_pitch_roll_aiding v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.aiding = aiding;
    return v;
}

struct mip_filter_pitch_roll_aiding mip_filter_pitch_roll_aiding_read(void) {
    struct mip_filter_pitch_roll_aiding v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_pitch_roll_aiding mip_filter_pitch_roll_aiding_save(void) {
    struct mip_filter_pitch_roll_aiding v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_pitch_roll_aiding mip_filter_pitch_roll_aiding_load(void) {
    struct mip_filter_pitch_roll_aiding v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_pitch_roll_aiding mip_filter_pitch_roll_aiding_default(void) {
    struct mip_filter_pitch_roll_aiding v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_pitch_roll_aiding_response(struct mip_reader *r, void *value) {
    struct mip_filter_pitch_roll_aiding_response *v =
        (struct mip_filter_pitch_roll_aiding_response *)value;
    mip_read_u8(r, &v->aiding, 1);
}

static void write_pitch_roll_aiding_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_pitch_roll_aiding_response *v =
        (const struct mip_filter_pitch_roll_aiding_response *)value;
    mip_write_u8(w, &v->aiding, 1);
}

const struct mip_codec mip_filter_pitch_roll_aiding_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_PITCH_ROLL_AIDING_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_pitch_roll_aiding_response),
    0, /* time-out */
    read_pitch_roll_aiding_response,
    write_pitch_roll_aiding_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_pitch_roll_aiding_response_decode(
    struct mip_filter_pitch_roll_aiding_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_pitch_roll_aiding_response, value, sizeof(*value), NULL);
}

mip_error mip_filter_pitch_roll_aiding_response_encode(
    const struct mip_filter_pitch_roll_aiding_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_PITCH_ROLL_AIDING_RESPONSE_DESCRIPTOR,
                            write_pitch_roll_aiding_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_magnetic_inclination_source[] = {0, 2, 0, 0, 0, 0};

static void read_magnetic_inclination_source(struct mip_reader *r, void *value) {
    struct mip_filter_magnetic_inclination_source *v =
        (struct mip_filter_magnetic_inclination_source *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_magnetic_inclination_source,
                      sizeof(required_magnetic_inclination_source));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->source, 1);
    mip_read_group(r, 2, 2);
    mip_read_float(r, &v->inclination, 1);
    v->present = mip_read_present(r);
}

static void write_magnetic_inclination_source(struct mip_writer *w, const void *value) {
    const struct mip_filter_magnetic_inclination_source *v =
        (const struct mip_filter_magnetic_inclination_source *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_magnetic_inclination_source,
                       sizeof(required_magnetic_inclination_source), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->source, 1);
    mip_write_group(w, 2, 2);
    mip_write_float(w, &v->inclination, 1);
}

static bool asked_magnetic_inclination_source_1(const void *value) {
    const struct mip_filter_magnetic_inclination_source *v =
        (const struct mip_filter_magnetic_inclination_source *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_magnetic_inclination_source[] = {
    {&mip_filter_magnetic_inclination_source_response_codec, asked_magnetic_inclination_source_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_magnetic_inclination_source_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_MAGNETIC_INCLINATION_SOURCE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_magnetic_inclination_source),
    0, /* time-out */
    read_magnetic_inclination_source,
    write_magnetic_inclination_source,
    NULL,
    responses_magnetic_inclination_source,
    NULL,
};

mip_error mip_filter_magnetic_inclination_source_decode(
    struct mip_filter_magnetic_inclination_source *value, const struct mip_field *field) {
    return mip_decode_field(field, read_magnetic_inclination_source, value, sizeof(*value), NULL);
}

mip_error mip_filter_magnetic_inclination_source_encode(
    const struct mip_filter_magnetic_inclination_source *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_MAGNETIC_INCLINATION_SOURCE_DESCRIPTOR,
                            write_magnetic_inclination_source, value);
}

struct mip_filter_magnetic_inclination_source mip_filter_magnetic_inclination_source_write(
    mip_filter_mag_parameter_source source, float inclination) {
    struct mip_filter_magnetic_inclination_source v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.source = source;
    v.inclination = inclination;
    return v;
}

struct mip_filter_magnetic_inclination_source mip_filter_magnetic_inclination_source_read(void) {
    struct mip_filter_magnetic_inclination_source v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_magnetic_inclination_source mip_filter_magnetic_inclination_source_save(void) {
    struct mip_filter_magnetic_inclination_source v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_magnetic_inclination_source mip_filter_magnetic_inclination_source_load(void) {
    struct mip_filter_magnetic_inclination_source v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_magnetic_inclination_source mip_filter_magnetic_inclination_source_default(void) {
    struct mip_filter_magnetic_inclination_source v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_magnetic_inclination_source_response(struct mip_reader *r, void *value) {
    struct mip_filter_magnetic_inclination_source_response *v =
        (struct mip_filter_magnetic_inclination_source_response *)value;
    mip_read_u8(r, &v->source, 1);
    mip_read_float(r, &v->inclination, 1);
}

static void write_magnetic_inclination_source_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_magnetic_inclination_source_response *v =
        (const struct mip_filter_magnetic_inclination_source_response *)value;
    mip_write_u8(w, &v->source, 1);
    mip_write_float(w, &v->inclination, 1);
}

const struct mip_codec mip_filter_magnetic_inclination_source_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_MAGNETIC_INCLINATION_SOURCE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_magnetic_inclination_source_response),
    0, /* time-out */
    read_magnetic_inclination_source_response,
    write_magnetic_inclination_source_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_magnetic_inclination_source_response_decode(
    struct mip_filter_magnetic_inclination_source_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_magnetic_inclination_source_response, value, sizeof(*value),
                            NULL);
}

mip_error mip_filter_magnetic_inclination_source_response_encode(
    const struct mip_filter_magnetic_inclination_source_response *value,
    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D,
                            MIP_FILTER_MAGNETIC_INCLINATION_SOURCE_RESPONSE_DESCRIPTOR,
                            write_magnetic_inclination_source_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_magnetic_magnitude_source[] = {0, 2, 0, 0, 0, 0};

static void read_magnetic_magnitude_source(struct mip_reader *r, void *value) {
    struct mip_filter_magnetic_magnitude_source *v =
        (struct mip_filter_magnetic_magnitude_source *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_magnetic_magnitude_source,
                      sizeof(required_magnetic_magnitude_source));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->source, 1);
    mip_read_group(r, 2, 2);
    mip_read_float(r, &v->magnitude, 1);
    v->present = mip_read_present(r);
}

static void write_magnetic_magnitude_source(struct mip_writer *w, const void *value) {
    const struct mip_filter_magnetic_magnitude_source *v =
        (const struct mip_filter_magnetic_magnitude_source *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_magnetic_magnitude_source,
                       sizeof(required_magnetic_magnitude_source), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->source, 1);
    mip_write_group(w, 2, 2);
    mip_write_float(w, &v->magnitude, 1);
}

static bool asked_magnetic_magnitude_source_1(const void *value) {
    const struct mip_filter_magnetic_magnitude_source *v =
        (const struct mip_filter_magnetic_magnitude_source *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_magnetic_magnitude_source[] = {
    {&mip_filter_magnetic_magnitude_source_response_codec, asked_magnetic_magnitude_source_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_magnetic_magnitude_source_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_MAGNETIC_MAGNITUDE_SOURCE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_magnetic_magnitude_source),
    0, /* time-out */
    read_magnetic_magnitude_source,
    write_magnetic_magnitude_source,
    NULL,
    responses_magnetic_magnitude_source,
    NULL,
};

mip_error mip_filter_magnetic_magnitude_source_decode(
    struct mip_filter_magnetic_magnitude_source *value, const struct mip_field *field) {
    return mip_decode_field(field, read_magnetic_magnitude_source, value, sizeof(*value), NULL);
}

mip_error mip_filter_magnetic_magnitude_source_encode(
    const struct mip_filter_magnetic_magnitude_source *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_MAGNETIC_MAGNITUDE_SOURCE_DESCRIPTOR,
                            write_magnetic_magnitude_source, value);
}

struct mip_filter_magnetic_magnitude_source mip_filter_magnetic_magnitude_source_write(
    mip_filter_mag_parameter_source source, float magnitude) {
    struct mip_filter_magnetic_magnitude_source v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.source = source;
    v.magnitude = magnitude;
    return v;
}

struct mip_filter_magnetic_magnitude_source mip_filter_magnetic_magnitude_source_read(void) {
    struct mip_filter_magnetic_magnitude_source v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_magnetic_magnitude_source mip_filter_magnetic_magnitude_source_save(void) {
    struct mip_filter_magnetic_magnitude_source v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_magnetic_magnitude_source mip_filter_magnetic_magnitude_source_load(void) {
    struct mip_filter_magnetic_magnitude_source v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_magnetic_magnitude_source mip_filter_magnetic_magnitude_source_default(void) {
    struct mip_filter_magnetic_magnitude_source v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_magnetic_magnitude_source_response(struct mip_reader *r, void *value) {
    struct mip_filter_magnetic_magnitude_source_response *v =
        (struct mip_filter_magnetic_magnitude_source_response *)value;
    mip_read_u8(r, &v->source, 1);
    mip_read_float(r, &v->magnitude, 1);
}

static void write_magnetic_magnitude_source_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_magnetic_magnitude_source_response *v =
        (const struct mip_filter_magnetic_magnitude_source_response *)value;
    mip_write_u8(w, &v->source, 1);
    mip_write_float(w, &v->magnitude, 1);
}

const struct mip_codec mip_filter_magnetic_magnitude_source_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_MAGNETIC_MAGNITUDE_SOURCE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_magnetic_magnitude_source_response),
    0, /* time-out */
    read_magnetic_magnitude_source_response,
    write_magnetic_magnitude_source_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_magnetic_magnitude_source_response_decode(
    struct mip_filter_magnetic_magnitude_source_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_magnetic_magnitude_source_response, value, sizeof(*value),
                            NULL);
}

mip_error mip_filter_magnetic_magnitude_source_response_encode(
    const struct mip_filter_magnetic_magnitude_source_response *value,
    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_MAGNETIC_MAGNITUDE_SOURCE_RESPONSE_DESCRIPTOR,
                            write_magnetic_magnitude_source_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_sensor_to_vehicle_rotation_dcm[] = {0, 1, 0, 0, 0, 0};

static void read_sensor_to_vehicle_rotation_dcm(struct mip_reader *r, void *value) {
    struct mip_filter_sensor_to_vehicle_dcm *v = (struct mip_filter_sensor_to_vehicle_dcm *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_sensor_to_vehicle_rotation_dcm,
                      sizeof(required_sensor_to_vehicle_rotation_dcm));
    mip_read_group(r, 1, 1);
    mip_read_float(r, v->dcm, 9);
    v->present = mip_read_present(r);
}

static void write_sensor_to_vehicle_rotation_dcm(struct mip_writer *w, const void *value) {
    const struct mip_filter_sensor_to_vehicle_dcm *v =
        (const struct mip_filter_sensor_to_vehicle_dcm *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_sensor_to_vehicle_rotation_dcm,
                       sizeof(required_sensor_to_vehicle_rotation_dcm), v->present);
    mip_write_group(w, 1, 1);
    mip_write_float(w, v->dcm, 9);
}

static bool asked_sensor_to_vehicle_rotation_dcm_1(const void *value) {
    const struct mip_filter_sensor_to_vehicle_dcm *v =
        (const struct mip_filter_sensor_to_vehicle_dcm *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_sensor_to_vehicle_rotation_dcm[] = {
    {&mip_filter_sensor_to_vehicle_dcm_response_codec, asked_sensor_to_vehicle_rotation_dcm_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_sensor_to_vehicle_dcm_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_SENSOR_TO_VEHICLE_DCM_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_sensor_to_vehicle_dcm),
    0, /* time-out */
    read_sensor_to_vehicle_rotation_dcm,
    write_sensor_to_vehicle_rotation_dcm,
    NULL,
    responses_sensor_to_vehicle_rotation_dcm,
    NULL,
};

mip_error mip_filter_sensor_to_vehicle_dcm_decode(struct mip_filter_sensor_to_vehicle_dcm *value,
                                                  const struct mip_field *field) {
    return mip_decode_field(field, read_sensor_to_vehicle_rotation_dcm, value, sizeof(*value),
                            NULL);
}

mip_error mip_filter_sensor_to_vehicle_dcm_encode(
    const struct mip_filter_sensor_to_vehicle_dcm *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_SENSOR_TO_VEHICLE_DCM_DESCRIPTOR,
                            write_sensor_to_vehicle_rotation_dcm, value);
}

struct mip_filter_sensor_to_vehicle_dcm mip_filter_sensor_to_vehicle_dcm_write(const float dcm[9]) {
    struct mip_filter_sensor_to_vehicle_dcm v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(v.dcm, dcm, sizeof(v.dcm));
    return v;
}

struct mip_filter_sensor_to_vehicle_dcm mip_filter_sensor_to_vehicle_dcm_read(void) {
    struct mip_filter_sensor_to_vehicle_dcm v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_sensor_to_vehicle_dcm mip_filter_sensor_to_vehicle_dcm_save(void) {
    struct mip_filter_sensor_to_vehicle_dcm v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_sensor_to_vehicle_dcm mip_filter_sensor_to_vehicle_dcm_load(void) {
    struct mip_filter_sensor_to_vehicle_dcm v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_sensor_to_vehicle_dcm mip_filter_sensor_to_vehicle_dcm_default(void) {
    struct mip_filter_sensor_to_vehicle_dcm v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_sensor_to_vehicle_rotation_dcm_response(struct mip_reader *r, void *value) {
    struct mip_filter_sensor_to_vehicle_dcm_response *v =
        (struct mip_filter_sensor_to_vehicle_dcm_response *)value;
    mip_read_float(r, v->dcm, 9);
}

static void write_sensor_to_vehicle_rotation_dcm_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_sensor_to_vehicle_dcm_response *v =
        (const struct mip_filter_sensor_to_vehicle_dcm_response *)value;
    mip_write_float(w, v->dcm, 9);
}

const struct mip_codec mip_filter_sensor_to_vehicle_dcm_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_SENSOR_TO_VEHICLE_DCM_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_sensor_to_vehicle_dcm_response),
    0, /* time-out */
    read_sensor_to_vehicle_rotation_dcm_response,
    write_sensor_to_vehicle_rotation_dcm_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_sensor_to_vehicle_dcm_response_decode(
    struct mip_filter_sensor_to_vehicle_dcm_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_sensor_to_vehicle_rotation_dcm_response, value,
                            sizeof(*value), NULL);
}

mip_error mip_filter_sensor_to_vehicle_dcm_response_encode(
    const struct mip_filter_sensor_to_vehicle_dcm_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_SENSOR_TO_VEHICLE_DCM_RESPONSE_DESCRIPTOR,
                            write_sensor_to_vehicle_rotation_dcm_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_sensor_to_vehicle_rotation_quaternion[] = {0, 1, 0, 0, 0, 0};

static void read_sensor_to_vehicle_rotation_quaternion(struct mip_reader *r, void *value) {
    struct mip_filter_sensor_to_vehicle_quaternion *v =
        (struct mip_filter_sensor_to_vehicle_quaternion *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_sensor_to_vehicle_rotation_quaternion,
                      sizeof(required_sensor_to_vehicle_rotation_quaternion));
    mip_read_group(r, 1, 1);
    mip_read_float(r, v->q, 4);
    v->present = mip_read_present(r);
}

static void write_sensor_to_vehicle_rotation_quaternion(struct mip_writer *w, const void *value) {
    const struct mip_filter_sensor_to_vehicle_quaternion *v =
        (const struct mip_filter_sensor_to_vehicle_quaternion *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_sensor_to_vehicle_rotation_quaternion,
                       sizeof(required_sensor_to_vehicle_rotation_quaternion), v->present);
    mip_write_group(w, 1, 1);
    mip_write_float(w, v->q, 4);
}

static bool asked_sensor_to_vehicle_rotation_quaternion_1(const void *value) {
    const struct mip_filter_sensor_to_vehicle_quaternion *v =
        (const struct mip_filter_sensor_to_vehicle_quaternion *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_sensor_to_vehicle_rotation_quaternion[] = {
    {&mip_filter_sensor_to_vehicle_quaternion_response_codec,
     asked_sensor_to_vehicle_rotation_quaternion_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_sensor_to_vehicle_quaternion_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_SENSOR_TO_VEHICLE_QUATERNION_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_sensor_to_vehicle_quaternion),
    0, /* time-out */
    read_sensor_to_vehicle_rotation_quaternion,
    write_sensor_to_vehicle_rotation_quaternion,
    NULL,
    responses_sensor_to_vehicle_rotation_quaternion,
    NULL,
};

mip_error mip_filter_sensor_to_vehicle_quaternion_decode(
    struct mip_filter_sensor_to_vehicle_quaternion *value, const struct mip_field *field) {
    return mip_decode_field(field, read_sensor_to_vehicle_rotation_quaternion, value,
                            sizeof(*value), NULL);
}

mip_error mip_filter_sensor_to_vehicle_quaternion_encode(
    const struct mip_filter_sensor_to_vehicle_quaternion *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_SENSOR_TO_VEHICLE_QUATERNION_DESCRIPTOR,
                            write_sensor_to_vehicle_rotation_quaternion, value);
}

struct mip_filter_sensor_to_vehicle_quaternion
mip_filter_sensor_to_vehicle_quaternion_write(const float q[4]) {
    struct mip_filter_sensor_to_vehicle_quaternion v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(v.q, q, sizeof(v.q));
    return v;
}

struct mip_filter_sensor_to_vehicle_quaternion mip_filter_sensor_to_vehicle_quaternion_read(void) {
    struct mip_filter_sensor_to_vehicle_quaternion v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_sensor_to_vehicle_quaternion mip_filter_sensor_to_vehicle_quaternion_save(void) {
    struct mip_filter_sensor_to_vehicle_quaternion v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_sensor_to_vehicle_quaternion mip_filter_sensor_to_vehicle_quaternion_load(void) {
    struct mip_filter_sensor_to_vehicle_quaternion v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_sensor_to_vehicle_quaternion
mip_filter_sensor_to_vehicle_quaternion_default(void) {
    struct mip_filter_sensor_to_vehicle_quaternion v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_sensor_to_vehicle_rotation_quaternion_response(struct mip_reader *r, void *value) {
    struct mip_filter_sensor_to_vehicle_quaternion_response *v =
        (struct mip_filter_sensor_to_vehicle_quaternion_response *)value;
    mip_read_float(r, v->q, 4);
}

static void write_sensor_to_vehicle_rotation_quaternion_response(struct mip_writer *w,
                                                                 const void *value) {
    const struct mip_filter_sensor_to_vehicle_quaternion_response *v =
        (const struct mip_filter_sensor_to_vehicle_quaternion_response *)value;
    mip_write_float(w, v->q, 4);
}

const struct mip_codec mip_filter_sensor_to_vehicle_quaternion_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_SENSOR_TO_VEHICLE_QUATERNION_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_sensor_to_vehicle_quaternion_response),
    0, /* time-out */
    read_sensor_to_vehicle_rotation_quaternion_response,
    write_sensor_to_vehicle_rotation_quaternion_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_sensor_to_vehicle_quaternion_response_decode(
    struct mip_filter_sensor_to_vehicle_quaternion_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_sensor_to_vehicle_rotation_quaternion_response, value,
                            sizeof(*value), NULL);
}

mip_error mip_filter_sensor_to_vehicle_quaternion_response_encode(
    const struct mip_filter_sensor_to_vehicle_quaternion_response *value,
    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D,
                            MIP_FILTER_SENSOR_TO_VEHICLE_QUATERNION_RESPONSE_DESCRIPTOR,
                            write_sensor_to_vehicle_rotation_quaternion_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_aiding_measurement_enable[] = {0, 2, 1, 1, 1, 1};

static void read_aiding_measurement_enable(struct mip_reader *r, void *value) {
    struct mip_filter_aiding_measurement_enable *v =
        (struct mip_filter_aiding_measurement_enable *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_aiding_measurement_enable,
                      sizeof(required_aiding_measurement_enable));
    mip_read_group(r, 1, 1);
    mip_read_u16(r, &v->aiding_source, 1);
    mip_read_group(r, 2, 2);
    mip_read_bool(r, &v->enable, 1);
    v->present = mip_read_present(r);
}

static void write_aiding_measurement_enable(struct mip_writer *w, const void *value) {
    const struct mip_filter_aiding_measurement_enable *v =
        (const struct mip_filter_aiding_measurement_enable *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_aiding_measurement_enable,
                       sizeof(required_aiding_measurement_enable), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u16(w, &v->aiding_source, 1);
    mip_write_group(w, 2, 2);
    mip_write_bool(w, &v->enable, 1);
}

static bool asked_aiding_measurement_enable_1(const void *value) {
    const struct mip_filter_aiding_measurement_enable *v =
        (const struct mip_filter_aiding_measurement_enable *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_aiding_measurement_enable[] = {
    {&mip_filter_aiding_measurement_enable_response_codec, asked_aiding_measurement_enable_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_aiding_measurement_enable_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_AIDING_MEASUREMENT_ENABLE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_aiding_measurement_enable),
    0, /* time-out */
    read_aiding_measurement_enable,
    write_aiding_measurement_enable,
    NULL,
    responses_aiding_measurement_enable,
    NULL,
};

mip_error mip_filter_aiding_measurement_enable_decode(
    struct mip_filter_aiding_measurement_enable *value, const struct mip_field *field) {
    return mip_decode_field(field, read_aiding_measurement_enable, value, sizeof(*value), NULL);
}

mip_error mip_filter_aiding_measurement_enable_encode(
    const struct mip_filter_aiding_measurement_enable *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_AIDING_MEASUREMENT_ENABLE_DESCRIPTOR,
                            write_aiding_measurement_enable, value);
}

struct mip_filter_aiding_measurement_enable mip_filter_aiding_measurement_enable_write(
    mip_filter_aiding_source aiding_source, mip_bool enable) {
    struct mip_filter_aiding_measurement_enable v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.aiding_source = aiding_source;
    v.enable = enable;
    return v;
}

struct mip_filter_aiding_measurement_enable
mip_filter_aiding_measurement_enable_read(mip_filter_aiding_source aiding_source) {
    struct mip_filter_aiding_measurement_enable v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    v.aiding_source = aiding_source;
    return v;
}

struct mip_filter_aiding_measurement_enable
mip_filter_aiding_measurement_enable_save(mip_filter_aiding_source aiding_source) {
    struct mip_filter_aiding_measurement_enable v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    v.aiding_source = aiding_source;
    return v;
}

struct mip_filter_aiding_measurement_enable
mip_filter_aiding_measurement_enable_load(mip_filter_aiding_source aiding_source) {
    struct mip_filter_aiding_measurement_enable v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    v.aiding_source = aiding_source;
    return v;
}

struct mip_filter_aiding_measurement_enable
mip_filter_aiding_measurement_enable_default(mip_filter_aiding_source aiding_source) {
    struct mip_filter_aiding_measurement_enable v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    v.aiding_source = aiding_source;
    return v;
}

static void read_aiding_measurement_enable_response(struct mip_reader *r, void *value) {
    struct mip_filter_aiding_measurement_enable_response *v =
        (struct mip_filter_aiding_measurement_enable_response *)value;
    mip_read_u16(r, &v->aiding_source, 1);
    mip_read_bool(r, &v->enable, 1);
}

static void write_aiding_measurement_enable_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_aiding_measurement_enable_response *v =
        (const struct mip_filter_aiding_measurement_enable_response *)value;
    mip_write_u16(w, &v->aiding_source, 1);
    mip_write_bool(w, &v->enable, 1);
}

const struct mip_codec mip_filter_aiding_measurement_enable_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_AIDING_MEASUREMENT_ENABLE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_aiding_measurement_enable_response),
    0, /* time-out */
    read_aiding_measurement_enable_response,
    write_aiding_measurement_enable_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_aiding_measurement_enable_response_decode(
    struct mip_filter_aiding_measurement_enable_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_aiding_measurement_enable_response, value, sizeof(*value),
                            NULL);
}

mip_error mip_filter_aiding_measurement_enable_response_encode(
    const struct mip_filter_aiding_measurement_enable_response *value,
    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_AIDING_MEASUREMENT_ENABLE_RESPONSE_DESCRIPTOR,
                            write_aiding_measurement_enable_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_kinematic_constraint[] = {0, 3, 0, 0, 0, 0};

static void read_kinematic_constraint(struct mip_reader *r, void *value) {
    struct mip_filter_kinematic_constraint *v = (struct mip_filter_kinematic_constraint *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_kinematic_constraint,
                      sizeof(required_kinematic_constraint));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->accel_constraint, 1);
    mip_read_group(r, 2, 2);
    mip_read_u8(r, &v->velocity_constraint, 1);
    mip_read_group(r, 3, 3);
    mip_read_u8(r, &v->angular_constraint, 1);
    v->present = mip_read_present(r);
}

static void write_kinematic_constraint(struct mip_writer *w, const void *value) {
    const struct mip_filter_kinematic_constraint *v =
        (const struct mip_filter_kinematic_constraint *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_kinematic_constraint,
                       sizeof(required_kinematic_constraint), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->accel_constraint, 1);
    mip_write_group(w, 2, 2);
    mip_write_u8(w, &v->velocity_constraint, 1);
    mip_write_group(w, 3, 3);
    mip_write_u8(w, &v->angular_constraint, 1);
}

static bool asked_kinematic_constraint_1(const void *value) {
    const struct mip_filter_kinematic_constraint *v =
        (const struct mip_filter_kinematic_constraint *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_kinematic_constraint[] = {
    {&mip_filter_kinematic_constraint_response_codec, asked_kinematic_constraint_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_kinematic_constraint_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_KINEMATIC_CONSTRAINT_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_kinematic_constraint),
    0, /* time-out */
    read_kinematic_constraint,
    write_kinematic_constraint,
    NULL,
    responses_kinematic_constraint,
    NULL,
};

mip_error mip_filter_kinematic_constraint_decode(struct mip_filter_kinematic_constraint *value,
                                                 const struct mip_field *field) {
    return mip_decode_field(field, read_kinematic_constraint, value, sizeof(*value), NULL);
}

mip_error mip_filter_kinematic_constraint_encode(
    const struct mip_filter_kinematic_constraint *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_KINEMATIC_CONSTRAINT_DESCRIPTOR,
                            write_kinematic_constraint, value);
}

struct mip_filter_kinematic_constraint
mip_filter_kinematic_constraint_write(mip_filter_accel_constraint accel_constraint,
                                      mip_filter_velocity_constraint velocity_constraint,
                                      mip_filter_angular_constraint angular_constraint) {
    struct mip_filter_kinematic_constraint v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.accel_constraint = accel_constraint;
    v.velocity_constraint = velocity_constraint;
    v.angular_constraint = angular_constraint;
    return v;
}

struct mip_filter_kinematic_constraint mip_filter_kinematic_constraint_read(void) {
    struct mip_filter_kinematic_constraint v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_kinematic_constraint mip_filter_kinematic_constraint_save(void) {
    struct mip_filter_kinematic_constraint v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_kinematic_constraint mip_filter_kinematic_constraint_load(void) {
    struct mip_filter_kinematic_constraint v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_kinematic_constraint mip_filter_kinematic_constraint_default(void) {
    struct mip_filter_kinematic_constraint v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_kinematic_constraint_response(struct mip_reader *r, void *value) {
    struct mip_filter_kinematic_constraint_response *v =
        (struct mip_filter_kinematic_constraint_response *)value;
    mip_read_u8(r, &v->accel_constraint, 1);
    mip_read_u8(r, &v->velocity_constraint, 1);
    mip_read_u8(r, &v->angular_constraint, 1);
}

static void write_kinematic_constraint_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_kinematic_constraint_response *v =
        (const struct mip_filter_kinematic_constraint_response *)value;
    mip_write_u8(w, &v->accel_constraint, 1);
    mip_write_u8(w, &v->velocity_constraint, 1);
    mip_write_u8(w, &v->angular_constraint, 1);
}

const struct mip_codec mip_filter_kinematic_constraint_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_KINEMATIC_CONSTRAINT_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_kinematic_constraint_response),
    0, /* time-out */
    read_kinematic_constraint_response,
    write_kinematic_constraint_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_kinematic_constraint_response_decode(
    struct mip_filter_kinematic_constraint_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_kinematic_constraint_response, value, sizeof(*value), NULL);
}

mip_error mip_filter_kinematic_constraint_response_encode(
    const struct mip_filter_kinematic_constraint_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_KINEMATIC_CONSTRAINT_RESPONSE_DESCRIPTOR,
                            write_kinematic_constraint_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_initialization_config[] = {0, 9, 0, 0, 0, 0};

static void read_initialization_config(struct mip_reader *r, void *value) {
    struct mip_filter_initialization_config *v = (struct mip_filter_initialization_config *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_initialization_config,
                      sizeof(required_initialization_config));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->wait_for_run_command, 1);
    mip_read_group(r, 2, 2);
    mip_read_u8(r, &v->initial_condition_source, 1);
    mip_read_group(r, 3, 3);
    mip_read_u8(r, &v->auto_heading_alignment_selector, 1);
    mip_read_group(r, 4, 4);
    mip_read_float(r, &v->initial_heading, 1);
    mip_read_group(r, 5, 5);
    mip_read_float(r, &v->initial_pitch, 1);
    mip_read_group(r, 6, 6);
    mip_read_float(r, &v->initial_roll, 1);
    mip_read_group(r, 7, 7);
    mip_read_float(r, v->initial_position, 3);
    mip_read_group(r, 8, 8);
    mip_read_float(r, v->initial_velocity, 3);
    mip_read_group(r, 9, 9);
    mip_read_u8(r, &v->reference_frame_selector, 1);
    v->present = mip_read_present(r);
}

static void write_initialization_config(struct mip_writer *w, const void *value) {
    const struct mip_filter_initialization_config *v =
        (const struct mip_filter_initialization_config *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_initialization_config,
                       sizeof(required_initialization_config), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->wait_for_run_command, 1);
    mip_write_group(w, 2, 2);
    mip_write_u8(w, &v->initial_condition_source, 1);
    mip_write_group(w, 3, 3);
    mip_write_u8(w, &v->auto_heading_alignment_selector, 1);
    mip_write_group(w, 4, 4);
    mip_write_float(w, &v->initial_heading, 1);
    mip_write_group(w, 5, 5);
    mip_write_float(w, &v->initial_pitch, 1);
    mip_write_group(w, 6, 6);
    mip_write_float(w, &v->initial_roll, 1);
    mip_write_group(w, 7, 7);
    mip_write_float(w, v->initial_position, 3);
    mip_write_group(w, 8, 8);
    mip_write_float(w, v->initial_velocity, 3);
    mip_write_group(w, 9, 9);
    mip_write_u8(w, &v->reference_frame_selector, 1);
}

static bool asked_initialization_config_1(const void *value) {
    const struct mip_filter_initialization_config *v =
        (const struct mip_filter_initialization_config *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_initialization_config[] = {
    {&mip_filter_initialization_config_response_codec, asked_initialization_config_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_initialization_config_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_INITIALIZATION_CONFIG_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_initialization_config),
    0, /* time-out */
    read_initialization_config,
    write_initialization_config,
    NULL,
    responses_initialization_config,
    NULL,
};

mip_error mip_filter_initialization_config_decode(struct mip_filter_initialization_config *value,
                                                  const struct mip_field *field) {
    return mip_decode_field(field, read_initialization_config, value, sizeof(*value), NULL);
}

mip_error mip_filter_initialization_config_encode(
    const struct mip_filter_initialization_config *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_INITIALIZATION_CONFIG_DESCRIPTOR,
                            write_initialization_config, value);
}

struct mip_filter_initialization_config mip_filter_initialization_config_write(
    uint8_t wait_for_run_command, mip_filter_initial_condition_source initial_condition_source,
    mip_filter_heading_alignment auto_heading_alignment_selector, float initial_heading,
    float initial_pitch, float initial_roll, const float initial_position[3],
    const float initial_velocity[3], mip_filter_reference_frame reference_frame_selector) {
    struct mip_filter_initialization_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.wait_for_run_command = wait_for_run_command;
    v.initial_condition_source = initial_condition_source;
    v.auto_heading_alignment_selector = auto_heading_alignment_selector;
    v.initial_heading = initial_heading;
    v.initial_pitch = initial_pitch;
    v.initial_roll = initial_roll;
    memcpy(v.initial_position, initial_position, sizeof(v.initial_position));
    memcpy(v.initial_velocity, initial_velocity, sizeof(v.initial_velocity));
    v.reference_frame_selector = reference_frame_selector;
    return v;
}

struct mip_filter_initialization_config mip_filter_initialization_config_read(void) {
    struct mip_filter_initialization_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_initialization_config mip_filter_initialization_config_save(void) {
    struct mip_filter_initialization_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_initialization_config mip_filter_initialization_config_load(void) {
    struct mip_filter_initialization_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_initialization_config mip_filter_initialization_config_default(void) {
    struct mip_filter_initialization_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_initialization_config_response(struct mip_reader *r, void *value) {
    struct mip_filter_initialization_config_response *v =
        (struct mip_filter_initialization_config_response *)value;
    mip_read_u8(r, &v->wait_for_run_command, 1);
    mip_read_u8(r, &v->initial_condition_source, 1);
    mip_read_u8(r, &v->auto_heading_alignment_selector, 1);
    mip_read_float(r, &v->initial_heading, 1);
    mip_read_float(r, &v->initial_pitch, 1);
    mip_read_float(r, &v->initial_roll, 1);
    mip_read_float(r, v->initial_position, 3);
    mip_read_float(r, v->initial_velocity, 3);
    mip_read_u8(r, &v->reference_frame_selector, 1);
}

static void write_initialization_config_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_initialization_config_response *v =
        (const struct mip_filter_initialization_config_response *)value;
    mip_write_u8(w, &v->wait_for_run_command, 1);
    mip_write_u8(w, &v->initial_condition_source, 1);
    mip_write_u8(w, &v->auto_heading_alignment_selector, 1);
    mip_write_float(w, &v->initial_heading, 1);
    mip_write_float(w, &v->initial_pitch, 1);
    mip_write_float(w, &v->initial_roll, 1);
    mip_write_float(w, v->initial_position, 3);
    mip_write_float(w, v->initial_velocity, 3);
    mip_write_u8(w, &v->reference_frame_selector, 1);
}

const struct mip_codec mip_filter_initialization_config_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_INITIALIZATION_CONFIG_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_initialization_config_response),
    0, /* time-out */
    read_initialization_config_response,
    write_initialization_config_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_initialization_config_response_decode(
    struct mip_filter_initialization_config_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_initialization_config_response, value, sizeof(*value),
                            NULL);
}

mip_error mip_filter_initialization_config_response_encode(
    const struct mip_filter_initialization_config_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_INITIALIZATION_CONFIG_RESPONSE_DESCRIPTOR,
                            write_initialization_config_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_adaptive_filter_options[] = {0, 2, 0, 0, 0, 0};

static void read_adaptive_filter_options(struct mip_reader *r, void *value) {
    struct mip_filter_adaptive_filter_options *v =
        (struct mip_filter_adaptive_filter_options *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_adaptive_filter_options,
                      sizeof(required_adaptive_filter_options));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->level, 1);
    mip_read_group(r, 2, 2);
    mip_read_u16(r, &v->time_limit, 1);
    v->present = mip_read_present(r);
}

static void write_adaptive_filter_options(struct mip_writer *w, const void *value) {
    const struct mip_filter_adaptive_filter_options *v =
        (const struct mip_filter_adaptive_filter_options *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_adaptive_filter_options,
                       sizeof(required_adaptive_filter_options), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->level, 1);
    mip_write_group(w, 2, 2);
    mip_write_u16(w, &v->time_limit, 1);
}

static bool asked_adaptive_filter_options_1(const void *value) {
    const struct mip_filter_adaptive_filter_options *v =
        (const struct mip_filter_adaptive_filter_options *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_adaptive_filter_options[] = {
    {&mip_filter_adaptive_filter_options_response_codec, asked_adaptive_filter_options_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_adaptive_filter_options_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_ADAPTIVE_FILTER_OPTIONS_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_adaptive_filter_options),
    0, /* time-out */
    read_adaptive_filter_options,
    write_adaptive_filter_options,
    NULL,
    responses_adaptive_filter_options,
    NULL,
};

mip_error mip_filter_adaptive_filter_options_decode(
    struct mip_filter_adaptive_filter_options *value, const struct mip_field *field) {
    return mip_decode_field(field, read_adaptive_filter_options, value, sizeof(*value), NULL);
}

mip_error mip_filter_adaptive_filter_options_encode(
    const struct mip_filter_adaptive_filter_options *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_ADAPTIVE_FILTER_OPTIONS_DESCRIPTOR,
                            write_adaptive_filter_options, value);
}

struct mip_filter_adaptive_filter_options
mip_filter_adaptive_filter_options_write(mip_filter_adaptive_level level, uint16_t time_limit) {
    struct mip_filter_adaptive_filter_options v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.level = level;
    v.time_limit = time_limit;
    return v;
}

struct mip_filter_adaptive_filter_options mip_filter_adaptive_filter_options_read(void) {
    struct mip_filter_adaptive_filter_options v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_adaptive_filter_options mip_filter_adaptive_filter_options_save(void) {
    struct mip_filter_adaptive_filter_options v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_adaptive_filter_options mip_filter_adaptive_filter_options_load(void) {
    struct mip_filter_adaptive_filter_options v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_adaptive_filter_options mip_filter_adaptive_filter_options_default(void) {
    struct mip_filter_adaptive_filter_options v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_adaptive_filter_options_response(struct mip_reader *r, void *value) {
    struct mip_filter_adaptive_filter_options_response *v =
        (struct mip_filter_adaptive_filter_options_response *)value;
    mip_read_u8(r, &v->level, 1);
    mip_read_u16(r, &v->time_limit, 1);
}

static void write_adaptive_filter_options_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_adaptive_filter_options_response *v =
        (const struct mip_filter_adaptive_filter_options_response *)value;
    mip_write_u8(w, &v->level, 1);
    mip_write_u16(w, &v->time_limit, 1);
}

const struct mip_codec mip_filter_adaptive_filter_options_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_ADAPTIVE_FILTER_OPTIONS_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_adaptive_filter_options_response),
    0, /* time-out */
    read_adaptive_filter_options_response,
    write_adaptive_filter_options_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_adaptive_filter_options_response_decode(
    struct mip_filter_adaptive_filter_options_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_adaptive_filter_options_response, value, sizeof(*value),
                            NULL);
}

mip_error mip_filter_adaptive_filter_options_response_encode(
    const struct mip_filter_adaptive_filter_options_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_ADAPTIVE_FILTER_OPTIONS_RESPONSE_DESCRIPTOR,
                            write_adaptive_filter_options_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_multi_antenna_offset[] = {0, 2, 1, 1, 1, 1};

static void read_multi_antenna_offset(struct mip_reader *r, void *value) {
    struct mip_filter_multi_antenna_offset *v = (struct mip_filter_multi_antenna_offset *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_multi_antenna_offset,
                      sizeof(required_multi_antenna_offset));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->receiver_id, 1);
    mip_read_group(r, 2, 2);
    mip_read_float(r, v->antenna_offset, 3);
    v->present = mip_read_present(r);
}

static void write_multi_antenna_offset(struct mip_writer *w, const void *value) {
    const struct mip_filter_multi_antenna_offset *v =
        (const struct mip_filter_multi_antenna_offset *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_multi_antenna_offset,
                       sizeof(required_multi_antenna_offset), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->receiver_id, 1);
    mip_write_group(w, 2, 2);
    mip_write_float(w, v->antenna_offset, 3);
}

static bool asked_multi_antenna_offset_1(const void *value) {
    const struct mip_filter_multi_antenna_offset *v =
        (const struct mip_filter_multi_antenna_offset *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_multi_antenna_offset[] = {
    {&mip_filter_multi_antenna_offset_response_codec, asked_multi_antenna_offset_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_multi_antenna_offset_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_MULTI_ANTENNA_OFFSET_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_multi_antenna_offset),
    0, /* time-out */
    read_multi_antenna_offset,
    write_multi_antenna_offset,
    NULL,
    responses_multi_antenna_offset,
    NULL,
};

mip_error mip_filter_multi_antenna_offset_decode(struct mip_filter_multi_antenna_offset *value,
                                                 const struct mip_field *field) {
    return mip_decode_field(field, read_multi_antenna_offset, value, sizeof(*value), NULL);
}

mip_error mip_filter_multi_antenna_offset_encode(
    const struct mip_filter_multi_antenna_offset *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_MULTI_ANTENNA_OFFSET_DESCRIPTOR,
                            write_multi_antenna_offset, value);
}

struct mip_filter_multi_antenna_offset
mip_filter_multi_antenna_offset_write(uint8_t receiver_id, const float antenna_offset[3]) {
    struct mip_filter_multi_antenna_offset v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.receiver_id = receiver_id;
    memcpy(v.antenna_offset, antenna_offset, sizeof(v.antenna_offset));
    return v;
}

struct mip_filter_multi_antenna_offset mip_filter_multi_antenna_offset_read(uint8_t receiver_id) {
    struct mip_filter_multi_antenna_offset v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    v.receiver_id = receiver_id;
    return v;
}

struct mip_filter_multi_antenna_offset mip_filter_multi_antenna_offset_save(uint8_t receiver_id) {
    struct mip_filter_multi_antenna_offset v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    v.receiver_id = receiver_id;
    return v;
}

struct mip_filter_multi_antenna_offset mip_filter_multi_antenna_offset_load(uint8_t receiver_id) {
    struct mip_filter_multi_antenna_offset v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    v.receiver_id = receiver_id;
    return v;
}

struct mip_filter_multi_antenna_offset
mip_filter_multi_antenna_offset_default(uint8_t receiver_id) {
    struct mip_filter_multi_antenna_offset v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    v.receiver_id = receiver_id;
    return v;
}

static void read_multi_antenna_offset_response(struct mip_reader *r, void *value) {
    struct mip_filter_multi_antenna_offset_response *v =
        (struct mip_filter_multi_antenna_offset_response *)value;
    mip_read_u8(r, &v->receiver_id, 1);
    mip_read_float(r, v->antenna_offset, 3);
}

static void write_multi_antenna_offset_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_multi_antenna_offset_response *v =
        (const struct mip_filter_multi_antenna_offset_response *)value;
    mip_write_u8(w, &v->receiver_id, 1);
    mip_write_float(w, v->antenna_offset, 3);
}

const struct mip_codec mip_filter_multi_antenna_offset_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_MULTI_ANTENNA_OFFSET_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_multi_antenna_offset_response),
    0, /* time-out */
    read_multi_antenna_offset_response,
    write_multi_antenna_offset_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_multi_antenna_offset_response_decode(
    struct mip_filter_multi_antenna_offset_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_multi_antenna_offset_response, value, sizeof(*value), NULL);
}

mip_error mip_filter_multi_antenna_offset_response_encode(
    const struct mip_filter_multi_antenna_offset_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_MULTI_ANTENNA_OFFSET_RESPONSE_DESCRIPTOR,
                            write_multi_antenna_offset_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_relative_position_config[] = {0, 3, 0, 0, 0, 0};

static void read_relative_position_config(struct mip_reader *r, void *value) {
    struct mip_filter_relative_position_config *v =
        (struct mip_filter_relative_position_config *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_relative_position_config,
                      sizeof(required_relative_position_config));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->source, 1);
    mip_read_group(r, 2, 2);
    mip_read_u8(r, &v->reference_frame_selector, 1);
    mip_read_group(r, 3, 3);
    mip_read_double(r, v->reference_coordinates, 3);
    v->present = mip_read_present(r);
}

static void write_relative_position_config(struct mip_writer *w, const void *value) {
    const struct mip_filter_relative_position_config *v =
        (const struct mip_filter_relative_position_config *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_relative_position_config,
                       sizeof(required_relative_position_config), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->source, 1);
    mip_write_group(w, 2, 2);
    mip_write_u8(w, &v->reference_frame_selector, 1);
    mip_write_group(w, 3, 3);
    mip_write_double(w, v->reference_coordinates, 3);
}

static bool asked_relative_position_config_1(const void *value) {
    const struct mip_filter_relative_position_config *v =
        (const struct mip_filter_relative_position_config *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_relative_position_config[] = {
    {&mip_filter_relative_position_config_response_codec, asked_relative_position_config_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_relative_position_config_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_RELATIVE_POSITION_CONFIG_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_relative_position_config),
    0, /* time-out */
    read_relative_position_config,
    write_relative_position_config,
    NULL,
    responses_relative_position_config,
    NULL,
};

mip_error mip_filter_relative_position_config_decode(
    struct mip_filter_relative_position_config *value, const struct mip_field *field) {
    return mip_decode_field(field, read_relative_position_config, value, sizeof(*value), NULL);
}

mip_error mip_filter_relative_position_config_encode(
    const struct mip_filter_relative_position_config *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_RELATIVE_POSITION_CONFIG_DESCRIPTOR,
                            write_relative_position_config, value);
}

struct mip_filter_relative_position_config mip_filter_relative_position_config_write(
    mip_filter_relative_position_source source, mip_filter_reference_frame reference_frame_selector,
    const double reference_coordinates[3]) {
    struct mip_filter_relative_position_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.source = source;
    v.reference_frame_selector = reference_frame_selector;
    memcpy(v.reference_coordinates, reference_coordinates, sizeof(v.reference_coordinates));
    return v;
}

struct mip_filter_relative_position_config mip_filter_relative_position_config_read(void) {
    struct mip_filter_relative_position_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_relative_position_config mip_filter_relative_position_config_save(void) {
    struct mip_filter_relative_position_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_relative_position_config mip_filter_relative_position_config_load(void) {
    struct mip_filter_relative_position_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_relative_position_config mip_filter_relative_position_config_default(void) {
    struct mip_filter_relative_position_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_relative_position_config_response(struct mip_reader *r, void *value) {
    struct mip_filter_relative_position_config_response *v =
        (struct mip_filter_relative_position_config_response *)value;
    mip_read_u8(r, &v->source, 1);
    mip_read_u8(r, &v->reference_frame_selector, 1);
    mip_read_double(r, v->reference_coordinates, 3);
}

static void write_relative_position_config_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_relative_position_config_response *v =
        (const struct mip_filter_relative_position_config_response *)value;
    mip_write_u8(w, &v->source, 1);
    mip_write_u8(w, &v->reference_frame_selector, 1);
    mip_write_double(w, v->reference_coordinates, 3);
}

const struct mip_codec mip_filter_relative_position_config_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_RELATIVE_POSITION_CONFIG_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_relative_position_config_response),
    0, /* time-out */
    read_relative_position_config_response,
    write_relative_position_config_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_relative_position_config_response_decode(
    struct mip_filter_relative_position_config_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_relative_position_config_response, value, sizeof(*value),
                            NULL);
}

mip_error mip_filter_relative_position_config_response_encode(
    const struct mip_filter_relative_position_config_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_RELATIVE_POSITION_CONFIG_RESPONSE_DESCRIPTOR,
                            write_relative_position_config_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_reference_point_lever_arm[] = {0, 2, 0, 0, 0, 0};

static void read_reference_point_lever_arm(struct mip_reader *r, void *value) {
    struct mip_filter_reference_point_lever_arm *v =
        (struct mip_filter_reference_point_lever_arm *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_reference_point_lever_arm,
                      sizeof(required_reference_point_lever_arm));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->reference_point, 1);
    mip_read_group(r, 2, 2);
    mip_read_float(r, v->lever_arm_offset, 3);
    v->present = mip_read_present(r);
}

static void write_reference_point_lever_arm(struct mip_writer *w, const void *value) {
    const struct mip_filter_reference_point_lever_arm *v =
        (const struct mip_filter_reference_point_lever_arm *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_reference_point_lever_arm,
                       sizeof(required_reference_point_lever_arm), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->reference_point, 1);
    mip_write_group(w, 2, 2);
    mip_write_float(w, v->lever_arm_offset, 3);
}

static bool asked_reference_point_lever_arm_1(const void *value) {
    const struct mip_filter_reference_point_lever_arm *v =
        (const struct mip_filter_reference_point_lever_arm *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_reference_point_lever_arm[] = {
    {&mip_filter_reference_point_lever_arm_response_codec, asked_reference_point_lever_arm_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_reference_point_lever_arm_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_REFERENCE_POINT_LEVER_ARM_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_reference_point_lever_arm),
    0, /* time-out */
    read_reference_point_lever_arm,
    write_reference_point_lever_arm,
    NULL,
    responses_reference_point_lever_arm,
    NULL,
};

mip_error mip_filter_reference_point_lever_arm_decode(
    struct mip_filter_reference_point_lever_arm *value, const struct mip_field *field) {
    return mip_decode_field(field, read_reference_point_lever_arm, value, sizeof(*value), NULL);
}

mip_error mip_filter_reference_point_lever_arm_encode(
    const struct mip_filter_reference_point_lever_arm *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_REFERENCE_POINT_LEVER_ARM_DESCRIPTOR,
                            write_reference_point_lever_arm, value);
}

struct mip_filter_reference_point_lever_arm mip_filter_reference_point_lever_arm_write(
    mip_filter_reference_point reference_point, const float lever_arm_offset[3]) {
    struct mip_filter_reference_point_lever_arm v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.reference_point = reference_point;
    memcpy(v.lever_arm_offset, lever_arm_offset, sizeof(v.lever_arm_offset));
    return v;
}

struct mip_filter_reference_point_lever_arm mip_filter_reference_point_lever_arm_read(void) {
    struct mip_filter_reference_point_lever_arm v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_reference_point_lever_arm mip_filter_reference_point_lever_arm_save(void) {
    struct mip_filter_reference_point_lever_arm v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_reference_point_lever_arm mip_filter_reference_point_lever_arm_load(void) {
    struct mip_filter_reference_point_lever_arm v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_reference_point_lever_arm mip_filter_reference_point_lever_arm_default(void) {
    struct mip_filter_reference_point_lever_arm v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_reference_point_lever_arm_response(struct mip_reader *r, void *value) {
    struct mip_filter_reference_point_lever_arm_response *v =
        (struct mip_filter_reference_point_lever_arm_response *)value;
    mip_read_u8(r, &v->reference_point, 1);
    mip_read_float(r, v->lever_arm_offset, 3);
}

static void write_reference_point_lever_arm_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_reference_point_lever_arm_response *v =
        (const struct mip_filter_reference_point_lever_arm_response *)value;
    mip_write_u8(w, &v->reference_point, 1);
    mip_write_float(w, v->lever_arm_offset, 3);
}

const struct mip_codec mip_filter_reference_point_lever_arm_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_REFERENCE_POINT_LEVER_ARM_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_reference_point_lever_arm_response),
    0, /* time-out */
    read_reference_point_lever_arm_response,
    write_reference_point_lever_arm_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_reference_point_lever_arm_response_decode(
    struct mip_filter_reference_point_lever_arm_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_reference_point_lever_arm_response, value, sizeof(*value),
                            NULL);
}

mip_error mip_filter_reference_point_lever_arm_response_encode(
    const struct mip_filter_reference_point_lever_arm_response *value,
    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_REFERENCE_POINT_LEVER_ARM_RESPONSE_DESCRIPTOR,
                            write_reference_point_lever_arm_response, value);
}

static void read_speed_measurement(struct mip_reader *r, void *value) {
    struct mip_filter_speed_measurement *v = (struct mip_filter_speed_measurement *)value;
    mip_read_u8(r, &v->source, 1);
    mip_read_float(r, &v->tow, 1);
    mip_read_float(r, &v->speed, 1);
    mip_read_float(r, &v->speed_uncertainty, 1);
}

static void write_speed_measurement(struct mip_writer *w, const void *value) {
    const struct mip_filter_speed_measurement *v =
        (const struct mip_filter_speed_measurement *)value;
    mip_write_u8(w, &v->source, 1);
    mip_write_float(w, &v->tow, 1);
    mip_write_float(w, &v->speed, 1);
    mip_write_float(w, &v->speed_uncertainty, 1);
}

const struct mip_codec mip_filter_speed_measurement_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_SPEED_MEASUREMENT_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_speed_measurement),
    0, /* time-out */
    read_speed_measurement,
    write_speed_measurement,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_speed_measurement_decode(struct mip_filter_speed_measurement *value,
                                              const struct mip_field *field) {
    return mip_decode_field(field, read_speed_measurement, value, sizeof(*value), NULL);
}

mip_error mip_filter_speed_measurement_encode(const struct mip_filter_speed_measurement *value,
                                              struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_SPEED_MEASUREMENT_DESCRIPTOR,
                            write_speed_measurement, value);
}

struct mip_filter_speed_measurement mip_filter_speed_measurement_make(float tow, float speed,
                                                                      float speed_uncertainty) {
    struct mip_filter_speed_measurement v;
    memset(&v, 0, sizeof(v));
    v.source = 1;
    v.tow = tow;
    v.speed = speed;
    v.speed_uncertainty = speed_uncertainty;
    return v;
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_speed_lever_arm[] = {0, 2, 1, 1, 1, 1};

static void read_speed_lever_arm(struct mip_reader *r, void *value) {
    struct mip_filter_speed_lever_arm *v = (struct mip_filter_speed_lever_arm *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_speed_lever_arm, sizeof(required_speed_lever_arm));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->source, 1);
    mip_read_group(r, 2, 2);
    mip_read_float(r, v->lever_arm_offset, 3);
    v->present = mip_read_present(r);
}

static void write_speed_lever_arm(struct mip_writer *w, const void *value) {
    const struct mip_filter_speed_lever_arm *v = (const struct mip_filter_speed_lever_arm *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_speed_lever_arm, sizeof(required_speed_lever_arm),
                       v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->source, 1);
    mip_write_group(w, 2, 2);
    mip_write_float(w, v->lever_arm_offset, 3);
}

static bool asked_speed_lever_arm_1(const void *value) {
    const struct mip_filter_speed_lever_arm *v = (const struct mip_filter_speed_lever_arm *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_speed_lever_arm[] = {
    {&mip_filter_speed_lever_arm_response_codec, asked_speed_lever_arm_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_speed_lever_arm_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_SPEED_LEVER_ARM_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_speed_lever_arm),
    0, /* time-out */
    read_speed_lever_arm,
    write_speed_lever_arm,
    NULL,
    responses_speed_lever_arm,
    NULL,
};

mip_error mip_filter_speed_lever_arm_decode(struct mip_filter_speed_lever_arm *value,
                                            const struct mip_field *field) {
    return mip_decode_field(field, read_speed_lever_arm, value, sizeof(*value), NULL);
}

mip_error mip_filter_speed_lever_arm_encode(const struct mip_filter_speed_lever_arm *value,
                                            struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_SPEED_LEVER_ARM_DESCRIPTOR,
                            write_speed_lever_arm, value);
}

struct mip_filter_speed_lever_arm
mip_filter_speed_lever_arm_write(const float lever_arm_offset[3]) {
    struct mip_filter_speed_lever_arm v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.source = 1;
    memcpy(v.lever_arm_offset, lever_arm_offset, sizeof(v.lever_arm_offset));
    return v;
}

struct mip_filter_speed_lever_arm mip_filter_speed_lever_arm_read(void) {
    struct mip_filter_speed_lever_arm v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    v.source = 1;
    return v;
}

struct mip_filter_speed_lever_arm mip_filter_speed_lever_arm_save(void) {
    struct mip_filter_speed_lever_arm v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    v.source = 1;
    return v;
}

struct mip_filter_speed_lever_arm mip_filter_speed_lever_arm_load(void) {
    struct mip_filter_speed_lever_arm v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    v.source = 1;
    return v;
}

struct mip_filter_speed_lever_arm mip_filter_speed_lever_arm_default(void) {
    struct mip_filter_speed_lever_arm v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    v.source = 1;
    return v;
}

static void read_speed_lever_arm_response(struct mip_reader *r, void *value) {
    struct mip_filter_speed_lever_arm_response *v =
        (struct mip_filter_speed_lever_arm_response *)value;
    mip_read_u8(r, &v->source, 1);
    mip_read_float(r, v->lever_arm_offset, 3);
}

static void write_speed_lever_arm_response(struct mip_writer *w, const void *value) {
    const struct mip_filter_speed_lever_arm_response *v =
        (const struct mip_filter_speed_lever_arm_response *)value;
    mip_write_u8(w, &v->source, 1);
    mip_write_float(w, v->lever_arm_offset, 3);
}

const struct mip_codec mip_filter_speed_lever_arm_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_SPEED_LEVER_ARM_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_speed_lever_arm_response),
    0, /* time-out */
    read_speed_lever_arm_response,
    write_speed_lever_arm_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_speed_lever_arm_response_decode(
    struct mip_filter_speed_lever_arm_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_speed_lever_arm_response, value, sizeof(*value), NULL);
}

mip_error mip_filter_speed_lever_arm_response_encode(
    const struct mip_filter_speed_lever_arm_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_SPEED_LEVER_ARM_RESPONSE_DESCRIPTOR,
                            write_speed_lever_arm_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_vertical_gyro_constraint_control[] = {0, 1, 0, 0, 0, 0};

static void read_vertical_gyro_constraint_control(struct mip_reader *r, void *value) {
    struct mip_filter_vertical_gyro_constraint *v =
        (struct mip_filter_vertical_gyro_constraint *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_vertical_gyro_constraint_control,
                      sizeof(required_vertical_gyro_constraint_control));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->enable, 1);
    v->present = mip_read_present(r);
}

static void write_vertical_gyro_constraint_control(struct mip_writer *w, const void *value) {
    const struct mip_filter_vertical_gyro_constraint *v =
        (const struct mip_filter_vertical_gyro_constraint *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_vertical_gyro_constraint_control,
                       sizeof(required_vertical_gyro_constraint_control), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->enable, 1);
}

static bool asked_vertical_gyro_constraint_control_1(const void *value) {
    const struct mip_filter_vertical_gyro_constraint *v =
        (const struct mip_filter_vertical_gyro_constraint *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_vertical_gyro_constraint_control[] = {
    {&mip_filter_vertical_gyro_constraint_response_codec, asked_vertical_gyro_constraint_control_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_vertical_gyro_constraint_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_VERTICAL_GYRO_CONSTRAINT_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_vertical_gyro_constraint),
    0, /* time-out */
    read_vertical_gyro_constraint_control,
    write_vertical_gyro_constraint_control,
    NULL,
    responses_vertical_gyro_constraint_control,
    NULL,
};

mip_error mip_filter_vertical_gyro_constraint_decode(
    struct mip_filter_vertical_gyro_constraint *value, const struct mip_field *field) {
    return mip_decode_field(field, read_vertical_gyro_constraint_control, value, sizeof(*value),
                            NULL);
}

mip_error mip_filter_vertical_gyro_constraint_encode(
    const struct mip_filter_vertical_gyro_constraint *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_VERTICAL_GYRO_CONSTRAINT_DESCRIPTOR,
                            write_vertical_gyro_constraint_control, value);
}

struct mip_filter_vertical_gyro_constraint
mip_filter_vertical_gyro_constraint_write(uint8_t enable) {
    struct mip_filter_vertical_gyro_constraint v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.enable = enable;
    return v;
}

struct mip_filter_vertical_gyro_constraint mip_filter_vertical_gyro_constraint_read(void) {
    struct mip_filter_vertical_gyro_constraint v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_vertical_gyro_constraint mip_filter_vertical_gyro_constraint_save(void) {
    struct mip_filter_vertical_gyro_constraint v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_vertical_gyro_constraint mip_filter_vertical_gyro_constraint_load(void) {
    struct mip_filter_vertical_gyro_constraint v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_vertical_gyro_constraint mip_filter_vertical_gyro_constraint_default(void) {
    struct mip_filter_vertical_gyro_constraint v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_vertical_gyro_constraint_control_response(struct mip_reader *r, void *value) {
    struct mip_filter_vertical_gyro_constraint_response *v =
        (struct mip_filter_vertical_gyro_constraint_response *)value;
    mip_read_u8(r, &v->enable, 1);
}

static void write_vertical_gyro_constraint_control_response(struct mip_writer *w,
                                                            const void *value) {
    const struct mip_filter_vertical_gyro_constraint_response *v =
        (const struct mip_filter_vertical_gyro_constraint_response *)value;
    mip_write_u8(w, &v->enable, 1);
}

const struct mip_codec mip_filter_vertical_gyro_constraint_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_VERTICAL_GYRO_CONSTRAINT_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_vertical_gyro_constraint_response),
    0, /* time-out */
    read_vertical_gyro_constraint_control_response,
    write_vertical_gyro_constraint_control_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_vertical_gyro_constraint_response_decode(
    struct mip_filter_vertical_gyro_constraint_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_vertical_gyro_constraint_control_response, value,
                            sizeof(*value), NULL);
}

mip_error mip_filter_vertical_gyro_constraint_response_encode(
    const struct mip_filter_vertical_gyro_constraint_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_VERTICAL_GYRO_CONSTRAINT_RESPONSE_DESCRIPTOR,
                            write_vertical_gyro_constraint_control_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_wheeled_vehicle_constraint_control[] = {0, 1, 0, 0, 0, 0};

static void read_wheeled_vehicle_constraint_control(struct mip_reader *r, void *value) {
    struct mip_filter_wheeled_vehicle_constraint *v =
        (struct mip_filter_wheeled_vehicle_constraint *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_wheeled_vehicle_constraint_control,
                      sizeof(required_wheeled_vehicle_constraint_control));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->enable, 1);
    v->present = mip_read_present(r);
}

static void write_wheeled_vehicle_constraint_control(struct mip_writer *w, const void *value) {
    const struct mip_filter_wheeled_vehicle_constraint *v =
        (const struct mip_filter_wheeled_vehicle_constraint *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_wheeled_vehicle_constraint_control,
                       sizeof(required_wheeled_vehicle_constraint_control), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->enable, 1);
}

static bool asked_wheeled_vehicle_constraint_control_1(const void *value) {
    const struct mip_filter_wheeled_vehicle_constraint *v =
        (const struct mip_filter_wheeled_vehicle_constraint *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_wheeled_vehicle_constraint_control[] = {
    {&mip_filter_wheeled_vehicle_constraint_response_codec,
     asked_wheeled_vehicle_constraint_control_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_wheeled_vehicle_constraint_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_WHEELED_VEHICLE_CONSTRAINT_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_wheeled_vehicle_constraint),
    0, /* time-out */
    read_wheeled_vehicle_constraint_control,
    write_wheeled_vehicle_constraint_control,
    NULL,
    responses_wheeled_vehicle_constraint_control,
    NULL,
};

mip_error mip_filter_wheeled_vehicle_constraint_decode(
    struct mip_filter_wheeled_vehicle_constraint *value, const struct mip_field *field) {
    return mip_decode_field(field, read_wheeled_vehicle_constraint_control, value, sizeof(*value),
                            NULL);
}

mip_error mip_filter_wheeled_vehicle_constraint_encode(
    const struct mip_filter_wheeled_vehicle_constraint *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_WHEELED_VEHICLE_CONSTRAINT_DESCRIPTOR,
                            write_wheeled_vehicle_constraint_control, value);
}

struct mip_filter_wheeled_vehicle_constraint
mip_filter_wheeled_vehicle_constraint_write(uint8_t enable) {
    struct mip_filter_wheeled_vehicle_constraint v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.enable = enable;
    return v;
}

struct mip_filter_wheeled_vehicle_constraint mip_filter_wheeled_vehicle_constraint_read(void) {
    struct mip_filter_wheeled_vehicle_constraint v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_wheeled_vehicle_constraint mip_filter_wheeled_vehicle_constraint_save(void) {
    struct mip_filter_wheeled_vehicle_constraint v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_wheeled_vehicle_constraint mip_filter_wheeled_vehicle_constraint_load(void) {
    struct mip_filter_wheeled_vehicle_constraint v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_wheeled_vehicle_constraint mip_filter_wheeled_vehicle_constraint_default(void) {
    struct mip_filter_wheeled_vehicle_constraint v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_wheeled_vehicle_constraint_control_response(struct mip_reader *r, void *value) {
    struct mip_filter_wheeled_vehicle_constraint_response *v =
        (struct mip_filter_wheeled_vehicle_constraint_response *)value;
    mip_read_u8(r, &v->enable, 1);
}

static void write_wheeled_vehicle_constraint_control_response(struct mip_writer *w,
                                                              const void *value) {
    const struct mip_filter_wheeled_vehicle_constraint_response *v =
        (const struct mip_filter_wheeled_vehicle_constraint_response *)value;
    mip_write_u8(w, &v->enable, 1);
}

const struct mip_codec mip_filter_wheeled_vehicle_constraint_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_WHEELED_VEHICLE_CONSTRAINT_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_wheeled_vehicle_constraint_response),
    0, /* time-out */
    read_wheeled_vehicle_constraint_control_response,
    write_wheeled_vehicle_constraint_control_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_wheeled_vehicle_constraint_response_decode(
    struct mip_filter_wheeled_vehicle_constraint_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_wheeled_vehicle_constraint_control_response, value,
                            sizeof(*value), NULL);
}

mip_error mip_filter_wheeled_vehicle_constraint_response_encode(
    const struct mip_filter_wheeled_vehicle_constraint_response *value,
    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D,
                            MIP_FILTER_WHEELED_VEHICLE_CONSTRAINT_RESPONSE_DESCRIPTOR,
                            write_wheeled_vehicle_constraint_control_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_gnss_antenna_calibration_control[] = {0, 2, 0, 0, 0, 0};

static void read_gnss_antenna_calibration_control(struct mip_reader *r, void *value) {
    struct mip_filter_gnss_antenna_calibration *v =
        (struct mip_filter_gnss_antenna_calibration *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_gnss_antenna_calibration_control,
                      sizeof(required_gnss_antenna_calibration_control));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->enable, 1);
    mip_read_group(r, 2, 2);
    mip_read_float(r, &v->max_offset, 1);
    v->present = mip_read_present(r);
}

static void write_gnss_antenna_calibration_control(struct mip_writer *w, const void *value) {
    const struct mip_filter_gnss_antenna_calibration *v =
        (const struct mip_filter_gnss_antenna_calibration *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_gnss_antenna_calibration_control,
                       sizeof(required_gnss_antenna_calibration_control), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->enable, 1);
    mip_write_group(w, 2, 2);
    mip_write_float(w, &v->max_offset, 1);
}

static bool asked_gnss_antenna_calibration_control_1(const void *value) {
    const struct mip_filter_gnss_antenna_calibration *v =
        (const struct mip_filter_gnss_antenna_calibration *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_gnss_antenna_calibration_control[] = {
    {&mip_filter_gnss_antenna_calibration_response_codec, asked_gnss_antenna_calibration_control_1},
    {NULL, NULL},
};

const struct mip_codec mip_filter_gnss_antenna_calibration_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_GNSS_ANTENNA_CALIBRATION_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_filter_gnss_antenna_calibration),
    0, /* time-out */
    read_gnss_antenna_calibration_control,
    write_gnss_antenna_calibration_control,
    NULL,
    responses_gnss_antenna_calibration_control,
    NULL,
};

mip_error mip_filter_gnss_antenna_calibration_decode(
    struct mip_filter_gnss_antenna_calibration *value, const struct mip_field *field) {
    return mip_decode_field(field, read_gnss_antenna_calibration_control, value, sizeof(*value),
                            NULL);
}

mip_error mip_filter_gnss_antenna_calibration_encode(
    const struct mip_filter_gnss_antenna_calibration *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_GNSS_ANTENNA_CALIBRATION_DESCRIPTOR,
                            write_gnss_antenna_calibration_control, value);
}

struct mip_filter_gnss_antenna_calibration
mip_filter_gnss_antenna_calibration_write(uint8_t enable, float max_offset) {
    struct mip_filter_gnss_antenna_calibration v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.enable = enable;
    v.max_offset = max_offset;
    return v;
}

struct mip_filter_gnss_antenna_calibration mip_filter_gnss_antenna_calibration_read(void) {
    struct mip_filter_gnss_antenna_calibration v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_filter_gnss_antenna_calibration mip_filter_gnss_antenna_calibration_save(void) {
    struct mip_filter_gnss_antenna_calibration v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_filter_gnss_antenna_calibration mip_filter_gnss_antenna_calibration_load(void) {
    struct mip_filter_gnss_antenna_calibration v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_filter_gnss_antenna_calibration mip_filter_gnss_antenna_calibration_default(void) {
    struct mip_filter_gnss_antenna_calibration v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_gnss_antenna_calibration_control_response(struct mip_reader *r, void *value) {
    struct mip_filter_gnss_antenna_calibration_response *v =
        (struct mip_filter_gnss_antenna_calibration_response *)value;
    mip_read_u8(r, &v->enable, 1);
    mip_read_float(r, &v->max_offset, 1);
}

static void write_gnss_antenna_calibration_control_response(struct mip_writer *w,
                                                            const void *value) {
    const struct mip_filter_gnss_antenna_calibration_response *v =
        (const struct mip_filter_gnss_antenna_calibration_response *)value;
    mip_write_u8(w, &v->enable, 1);
    mip_write_float(w, &v->max_offset, 1);
}

const struct mip_codec mip_filter_gnss_antenna_calibration_response_codec = {
    0x0D, /* descriptor set */
    MIP_FILTER_GNSS_ANTENNA_CALIBRATION_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_filter_gnss_antenna_calibration_response),
    0, /* time-out */
    read_gnss_antenna_calibration_control_response,
    write_gnss_antenna_calibration_control_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_gnss_antenna_calibration_response_decode(
    struct mip_filter_gnss_antenna_calibration_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_gnss_antenna_calibration_control_response, value,
                            sizeof(*value), NULL);
}

mip_error mip_filter_gnss_antenna_calibration_response_encode(
    const struct mip_filter_gnss_antenna_calibration_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0D, MIP_FILTER_GNSS_ANTENNA_CALIBRATION_RESPONSE_DESCRIPTOR,
                            write_gnss_antenna_calibration_control_response, value);
}
