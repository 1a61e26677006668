/* Aiding commands. */
#include "mip/aiding.h"

#include <string.h>

void mip_aiding_measurement_time_read(struct mip_reader *r, struct mip_aiding_measurement_time *v) {
    mip_read_u8(r, &v->timebase, 1);
    mip_read_u8(r, &v->reserved, 1);
    mip_read_u64(r, &v->nanoseconds, 1);
}

void mip_aiding_measurement_time_write(struct mip_writer *w,
                                       const struct mip_aiding_measurement_time *v) {
    mip_write_u8(w, &v->timebase, 1);
    mip_write_u8(w, &v->reserved, 1);
    mip_write_u64(w, &v->nanoseconds, 1);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_frame_config[] = {0, 5, 2, 1, 1, 1};

static void read_frame_config(struct mip_reader *r, void *value) {
    struct mip_aiding_frame_config *v = (struct mip_aiding_frame_config *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_frame_config, sizeof(required_frame_config));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->frame_id, 1);
    mip_read_group(r, 2, 2);
    mip_read_u8(r, &v->format, 1);
    mip_read_group(r, 3, 3);
    mip_read_bool(r, &v->tracking_enabled, 1);
    mip_read_group(r, 4, 4);
    mip_read_float(r, v->translation, 3);
    mip_read_group(r, 5, 5);
    switch (v->format) {
    case MIP_AIDING_FRAME_FORMAT_EULER:
        mip_read_float(r, v->rotation.euler, 3);
        break;
    case MIP_AIDING_FRAME_FORMAT_QUATERNION:
        mip_read_float(r, v->rotation.quaternion, 4);
        break;
    default:
        break;
    }
    v->present = mip_read_present(r);
}

static void write_frame_config(struct mip_writer *w, const void *value) {
    const struct mip_aiding_frame_config *v = (const struct mip_aiding_frame_config *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_frame_config, sizeof(required_frame_config),
                       v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->frame_id, 1);
    mip_write_group(w, 2, 2);
    mip_write_u8(w, &v->format, 1);
    mip_write_group(w, 3, 3);
    mip_write_bool(w, &v->tracking_enabled, 1);
    mip_write_group(w, 4, 4);
    mip_write_float(w, v->translation, 3);
    mip_write_group(w, 5, 5);
    switch (v->format) {
    case MIP_AIDING_FRAME_FORMAT_EULER:
        mip_write_float(w, v->rotation.euler, 3);
        break;
    case MIP_AIDING_FRAME_FORMAT_QUATERNION:
        mip_write_float(w, v->rotation.quaternion, 4);
        break;
    default:
        break;
    }
}

static bool asked_frame_config_1(const void *value) {
    const struct mip_aiding_frame_config *v = (const struct mip_aiding_frame_config *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_frame_config[] = {
    {&mip_aiding_frame_config_response_codec, asked_frame_config_1},
    {NULL, NULL},
};

const struct mip_codec mip_aiding_frame_config_codec = {
    0x13, /* descriptor set */
    MIP_AIDING_FRAME_CONFIG_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_aiding_frame_config),
    0, /* time-out */
    read_frame_config,
    write_frame_config,
    NULL,
    responses_frame_config,
    NULL,
};

mip_error mip_aiding_frame_config_decode(struct mip_aiding_frame_config *value,
                                         const struct mip_field *field) {
    return mip_decode_field(field, read_frame_config, value, sizeof(*value), NULL);
}

mip_error mip_aiding_frame_config_encode(const struct mip_aiding_frame_config *value,
                                         struct mip_builder *builder) {
    return mip_encode_field(builder, 0x13, MIP_AIDING_FRAME_CONFIG_DESCRIPTOR, write_frame_config,
                            value);
}

struct mip_aiding_frame_config mip_aiding_frame_config_write(
    uint8_t frame_id, mip_aiding_frame_format format, mip_bool tracking_enabled,
    const float translation[3], const union mip_aiding_frame_config_rotation *rotation) {
    struct mip_aiding_frame_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.frame_id = frame_id;
    v.format = format;
    v.tracking_enabled = tracking_enabled;
    memcpy(v.translation, translation, sizeof(v.translation));
    if (rotation != NULL) {
        v.rotation = *rotation;
    }
    return v;
}

struct mip_aiding_frame_config mip_aiding_frame_config_read(uint8_t frame_id,
                                                            mip_aiding_frame_format format) {
    struct mip_aiding_frame_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    v.frame_id = frame_id;
    v.format = format;
    return v;
}

struct mip_aiding_frame_config mip_aiding_frame_config_save(uint8_t frame_id) {
    struct mip_aiding_frame_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    v.frame_id = frame_id;
    return v;
}

struct mip_aiding_frame_config mip_aiding_frame_config_load(uint8_t frame_id) {
    struct mip_aiding_frame_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    v.frame_id = frame_id;
    return v;
}

struct mip_aiding_frame_config mip_aiding_frame_config_default(uint8_t frame_id) {
    struct mip_aiding_frame_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    v.frame_id = frame_id;
    return v;
}

static void read_frame_config_response(struct mip_reader *r, void *value) {
    struct mip_aiding_frame_config_response *v = (struct mip_aiding_frame_config_response *)value;
    mip_read_u8(r, &v->frame_id, 1);
    mip_read_u8(r, &v->format, 1);
    mip_read_bool(r, &v->tracking_enabled, 1);
    mip_read_float(r, v->translation, 3);
    switch (v->format) {
    case MIP_AIDING_FRAME_FORMAT_EULER:
        mip_read_float(r, v->rotation.euler, 3);
        break;
    case MIP_AIDING_FRAME_FORMAT_QUATERNION:
        mip_read_float(r, v->rotation.quaternion, 4);
        break;
    default:
        break;
    }
}

static void write_frame_config_response(struct mip_writer *w, const void *value) {
    const struct mip_aiding_frame_config_response *v =
        (const struct mip_aiding_frame_config_response *)value;
    mip_write_u8(w, &v->frame_id, 1);
    mip_write_u8(w, &v->format, 1);
    mip_write_bool(w, &v->tracking_enabled, 1);
    mip_write_float(w, v->translation, 3);
    switch (v->format) {
    case MIP_AIDING_FRAME_FORMAT_EULER:
        mip_write_float(w, v->rotation.euler, 3);
        break;
    case MIP_AIDING_FRAME_FORMAT_QUATERNION:
        mip_write_float(w, v->rotation.quaternion, 4);
        break;
    default:
        break;
    }
}

const struct mip_codec mip_aiding_frame_config_response_codec = {
    0x13, /* descriptor set */
    MIP_AIDING_FRAME_CONFIG_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_aiding_frame_config_response),
    0, /* time-out */
    read_frame_config_response,
    write_frame_config_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_aiding_frame_config_response_decode(struct mip_aiding_frame_config_response *value,
                                                  const struct mip_field *field) {
    return mip_decode_field(field, read_frame_config_response, value, sizeof(*value), NULL);
}

mip_error mip_aiding_frame_config_response_encode(
    const struct mip_aiding_frame_config_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x13, MIP_AIDING_FRAME_CONFIG_RESPONSE_DESCRIPTOR,
                            write_frame_config_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_echo_control[] = {0, 1, 0, 0, 0, 0};

static void read_echo_control(struct mip_reader *r, void *value) {
    struct mip_aiding_echo_control *v = (struct mip_aiding_echo_control *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_echo_control, sizeof(required_echo_control));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->mode, 1);
    v->present = mip_read_present(r);
}

static void write_echo_control(struct mip_writer *w, const void *value) {
    const struct mip_aiding_echo_control *v = (const struct mip_aiding_echo_control *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_echo_control, sizeof(required_echo_control),
                       v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->mode, 1);
}

static bool asked_echo_control_1(const void *value) {
    const struct mip_aiding_echo_control *v = (const struct mip_aiding_echo_control *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_echo_control[] = {
    {&mip_aiding_echo_control_response_codec, asked_echo_control_1},
    {NULL, NULL},
};

const struct mip_codec mip_aiding_echo_control_codec = {
    0x13, /* descriptor set */
    MIP_AIDING_ECHO_CONTROL_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_aiding_echo_control),
    0, /* time-out */
    read_echo_control,
    write_echo_control,
    NULL,
    responses_echo_control,
    NULL,
};

mip_error mip_aiding_echo_control_decode(struct mip_aiding_echo_control *value,
                                         const struct mip_field *field) {
    return mip_decode_field(field, read_echo_control, value, sizeof(*value), NULL);
}

mip_error mip_aiding_echo_control_encode(const struct mip_aiding_echo_control *value,
                                         struct mip_builder *builder) {
    return mip_encode_field(builder, 0x13, MIP_AIDING_ECHO_CONTROL_DESCRIPTOR, write_echo_control,
                            value);
}

struct mip_aiding_echo_control mip_aiding_echo_control_write(mip_aiding_echo_mode mode) {
    struct mip_aiding_echo_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.mode = mode;
    return v;
}

struct mip_aiding_echo_control mip_aiding_echo_control_read(void) {
    struct mip_aiding_echo_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_aiding_echo_control mip_aiding_echo_control_save(void) {
    struct mip_aiding_echo_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_aiding_echo_control mip_aiding_echo_control_load(void) {
    struct mip_aiding_echo_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_aiding_echo_control mip_aiding_echo_control_default(void) {
    struct mip_aiding_echo_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_echo_control_response(struct mip_reader *r, void *value) {
    struct mip_aiding_echo_control_response *v = (struct mip_aiding_echo_control_response *)value;
    mip_read_u8(r, &v->mode, 1);
}

static void write_echo_control_response(struct mip_writer *w, const void *value) {
    const struct mip_aiding_echo_control_response *v =
        (const struct mip_aiding_echo_control_response *)value;
    mip_write_u8(w, &v->mode, 1);
}

const struct mip_codec mip_aiding_echo_control_response_codec = {
    0x13, /* descriptor set */
    MIP_AIDING_ECHO_CONTROL_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_aiding_echo_control_response),
    0, /* time-out */
    read_echo_control_response,
    write_echo_control_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_aiding_echo_control_response_decode(struct mip_aiding_echo_control_response *value,
                                                  const struct mip_field *field) {
    return mip_decode_field(field, read_echo_control_response, value, sizeof(*value), NULL);
}

mip_error mip_aiding_echo_control_response_encode(
    const struct mip_aiding_echo_control_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x13, MIP_AIDING_ECHO_CONTROL_RESPONSE_DESCRIPTOR,
                            write_echo_control_response, value);
}

static void read_ecef_position(struct mip_reader *r, void *value) {
    struct mip_aiding_ecef_position *v = (struct mip_aiding_ecef_position *)value;
    mip_aiding_measurement_time_read(r, &v->time);
    mip_read_u8(r, &v->frame_id, 1);
    mip_read_double(r, v->position, 3);
    mip_read_float(r, v->uncertainty, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_ecef_position(struct mip_writer *w, const void *value) {
    const struct mip_aiding_ecef_position *v = (const struct mip_aiding_ecef_position *)value;
    mip_aiding_measurement_time_write(w, &v->time);
    mip_write_u8(w, &v->frame_id, 1);
    mip_write_double(w, v->position, 3);
    mip_write_float(w, v->uncertainty, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_aiding_ecef_position_codec = {
    0x13, /* descriptor set */
    MIP_AIDING_ECEF_POSITION_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_aiding_ecef_position),
    0, /* time-out */
    read_ecef_position,
    write_ecef_position,
    NULL,
    NULL,
    NULL,
};

mip_error mip_aiding_ecef_position_decode(struct mip_aiding_ecef_position *value,
                                          const struct mip_field *field) {
    return mip_decode_field(field, read_ecef_position, value, sizeof(*value), NULL);
}

mip_error mip_aiding_ecef_position_encode(const struct mip_aiding_ecef_position *value,
                                          struct mip_builder *builder) {
    return mip_encode_field(builder, 0x13, MIP_AIDING_ECEF_POSITION_DESCRIPTOR, write_ecef_position,
                            value);
}

struct mip_aiding_ecef_position mip_aiding_ecef_position_make(
    const struct mip_aiding_measurement_time *time, uint8_t frame_id, const double position[3],
    const float uncertainty[3], mip_aiding_axis_flags valid_flags) {
    struct mip_aiding_ecef_position v;
    memset(&v, 0, sizeof(v));
    v.time = *time;
    v.frame_id = frame_id;
    memcpy(v.position, position, sizeof(v.position));
    memcpy(v.uncertainty, uncertainty, sizeof(v.uncertainty));
    v.valid_flags = valid_flags;
    return v;
}

static void read_llh_position(struct mip_reader *r, void *value) {
    struct mip_aiding_llh_position *v = (struct mip_aiding_llh_position *)value;
    mip_aiding_measurement_time_read(r, &v->time);
    mip_read_u8(r, &v->frame_id, 1);
    mip_read_double(r, &v->latitude, 1);
    mip_read_double(r, &v->longitude, 1);
    mip_read_double(r, &v->height, 1);
    mip_read_float(r, v->uncertainty, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_llh_position(struct mip_writer *w, const void *value) {
    const struct mip_aiding_llh_position *v = (const struct mip_aiding_llh_position *)value;
    mip_aiding_measurement_time_write(w, &v->time);
    mip_write_u8(w, &v->frame_id, 1);
    mip_write_double(w, &v->latitude, 1);
    mip_write_double(w, &v->longitude, 1);
    mip_write_double(w, &v->height, 1);
    mip_write_float(w, v->uncertainty, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_aiding_llh_position_codec = {
    0x13, /* descriptor set */
    MIP_AIDING_LLH_POSITION_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_aiding_llh_position),
    0, /* time-out */
    read_llh_position,
    write_llh_position,
    NULL,
    NULL,
    NULL,
};

mip_error mip_aiding_llh_position_decode(struct mip_aiding_llh_position *value,
                                         const struct mip_field *field) {
    return mip_decode_field(field, read_llh_position, value, sizeof(*value), NULL);
}

mip_error mip_aiding_llh_position_encode(const struct mip_aiding_llh_position *value,
                                         struct mip_builder *builder) {
    return mip_encode_field(builder, 0x13, MIP_AIDING_LLH_POSITION_DESCRIPTOR, write_llh_position,
                            value);
}

struct mip_aiding_llh_position
mip_aiding_llh_position_make(const struct mip_aiding_measurement_time *time, uint8_t frame_id,
                             double latitude, double longitude, double height,
                             const float uncertainty[3], mip_aiding_llh_axis_flags valid_flags) {
    struct mip_aiding_llh_position v;
    memset(&v, 0, sizeof(v));
    v.time = *time;
    v.frame_id = frame_id;
    v.latitude = latitude;
    v.longitude = longitude;
    v.height = height;
    memcpy(v.uncertainty, uncertainty, sizeof(v.uncertainty));
    v.valid_flags = valid_flags;
    return v;
}

static void read_height_above_ellipsoid(struct mip_reader *r, void *value) {
    struct mip_aiding_height_above_ellipsoid *v = (struct mip_aiding_height_above_ellipsoid *)value;
    mip_aiding_measurement_time_read(r, &v->time);
    mip_read_u8(r, &v->frame_id, 1);
    mip_read_float(r, &v->height, 1);
    mip_read_float(r, &v->uncertainty, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_height_above_ellipsoid(struct mip_writer *w, const void *value) {
    const struct mip_aiding_height_above_ellipsoid *v =
        (const struct mip_aiding_height_above_ellipsoid *)value;
    mip_aiding_measurement_time_write(w, &v->time);
    mip_write_u8(w, &v->frame_id, 1);
    mip_write_float(w, &v->height, 1);
    mip_write_float(w, &v->uncertainty, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_aiding_height_above_ellipsoid_codec = {
    0x13, /* descriptor set */
    MIP_AIDING_HEIGHT_ABOVE_ELLIPSOID_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_aiding_height_above_ellipsoid),
    0, /* time-out */
    read_height_above_ellipsoid,
    write_height_above_ellipsoid,
    NULL,
    NULL,
    NULL,
};

mip_error mip_aiding_height_above_ellipsoid_decode(struct mip_aiding_height_above_ellipsoid *value,
                                                   const struct mip_field *field) {
    return mip_decode_field(field, read_height_above_ellipsoid, value, sizeof(*value), NULL);
}

mip_error mip_aiding_height_above_ellipsoid_encode(
    const struct mip_aiding_height_above_ellipsoid *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x13, MIP_AIDING_HEIGHT_ABOVE_ELLIPSOID_DESCRIPTOR,
                            write_height_above_ellipsoid, value);
}

struct mip_aiding_height_above_ellipsoid mip_aiding_height_above_ellipsoid_make(
    const struct mip_aiding_measurement_time *time, uint8_t frame_id, float height,
    float uncertainty, uint16_t valid_flags) {
    struct mip_aiding_height_above_ellipsoid v;
    memset(&v, 0, sizeof(v));
    v.time = *time;
    v.frame_id = frame_id;
    v.height = height;
    v.uncertainty = uncertainty;
    v.valid_flags = valid_flags;
    return v;
}

static void read_ecef_velocity(struct mip_reader *r, void *value) {
    struct mip_aiding_ecef_velocity *v = (struct mip_aiding_ecef_velocity *)value;
    mip_aiding_measurement_time_read(r, &v->time);
    mip_read_u8(r, &v->frame_id, 1);
    mip_read_float(r, v->velocity, 3);
    mip_read_float(r, v->uncertainty, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_ecef_velocity(struct mip_writer *w, const void *value) {
    const struct mip_aiding_ecef_velocity *v = (const struct mip_aiding_ecef_velocity *)value;
    mip_aiding_measurement_time_write(w, &v->time);
    mip_write_u8(w, &v->frame_id, 1);
    mip_write_float(w, v->velocity, 3);
    mip_write_float(w, v->uncertainty, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_aiding_ecef_velocity_codec = {
    0x13, /* descriptor set */
    MIP_AIDING_ECEF_VELOCITY_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_aiding_ecef_velocity),
    0, /* time-out */
    read_ecef_velocity,
    write_ecef_velocity,
    NULL,
    NULL,
    NULL,
};

mip_error mip_aiding_ecef_velocity_decode(struct mip_aiding_ecef_velocity *value,
                                          const struct mip_field *field) {
    return mip_decode_field(field, read_ecef_velocity, value, sizeof(*value), NULL);
}

mip_error mip_aiding_ecef_velocity_encode(const struct mip_aiding_ecef_velocity *value,
                                          struct mip_builder *builder) {
    return mip_encode_field(builder, 0x13, MIP_AIDING_ECEF_VELOCITY_DESCRIPTOR, write_ecef_velocity,
                            value);
}

struct mip_aiding_ecef_velocity mip_aiding_ecef_velocity_make(
    const struct mip_aiding_measurement_time *time, uint8_t frame_id, const float velocity[3],
    const float uncertainty[3], mip_aiding_axis_flags valid_flags) {
    struct mip_aiding_ecef_velocity v;
    memset(&v, 0, sizeof(v));
    v.time = *time;
    v.frame_id = frame_id;
    memcpy(v.velocity, velocity, sizeof(v.velocity));
    memcpy(v.uncertainty, uncertainty, sizeof(v.uncertainty));
    v.valid_flags = valid_flags;
    return v;
}

static void read_ned_velocity(struct mip_reader *r, void *value) {
    struct mip_aiding_ned_velocity *v = (struct mip_aiding_ned_velocity *)value;
    mip_aiding_measurement_time_read(r, &v->time);
    mip_read_u8(r, &v->frame_id, 1);
    mip_read_float(r, v->velocity, 3);
    mip_read_float(r, v->uncertainty, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_ned_velocity(struct mip_writer *w, const void *value) {
    const struct mip_aiding_ned_velocity *v = (const struct mip_aiding_ned_velocity *)value;
    mip_aiding_measurement_time_write(w, &v->time);
    mip_write_u8(w, &v->frame_id, 1);
    mip_write_float(w, v->velocity, 3);
    mip_write_float(w, v->uncertainty, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_aiding_ned_velocity_codec = {
    0x13, /* descriptor set */
    MIP_AIDING_NED_VELOCITY_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_aiding_ned_velocity),
    0, /* time-out */
    read_ned_velocity,
    write_ned_velocity,
    NULL,
    NULL,
    NULL,
};

mip_error mip_aiding_ned_velocity_decode(struct mip_aiding_ned_velocity *value,
                                         const struct mip_field *field) {
    return mip_decode_field(field, read_ned_velocity, value, sizeof(*value), NULL);
}

mip_error mip_aiding_ned_velocity_encode(const struct mip_aiding_ned_velocity *value,
                                         struct mip_builder *builder) {
    return mip_encode_field(builder, 0x13, MIP_AIDING_NED_VELOCITY_DESCRIPTOR, write_ned_velocity,
                            value);
}

struct mip_aiding_ned_velocity mip_aiding_ned_velocity_make(
    const struct mip_aiding_measurement_time *time, uint8_t frame_id, const float velocity[3],
    const float uncertainty[3], mip_aiding_axis_flags valid_flags) {
    struct mip_aiding_ned_velocity v;
    memset(&v, 0, sizeof(v));
    v.time = *time;
    v.frame_id = frame_id;
    memcpy(v.velocity, velocity, sizeof(v.velocity));
    memcpy(v.uncertainty, uncertainty, sizeof(v.uncertainty));
    v.valid_flags = valid_flags;
    return v;
}

static void read_body_frame_velocity(struct mip_reader *r, void *value) {
    struct mip_aiding_body_frame_velocity *v = (struct mip_aiding_body_frame_velocity *)value;
    mip_aiding_measurement_time_read(r, &v->time);
    mip_read_u8(r, &v->frame_id, 1);
    mip_read_float(r, v->velocity, 3);
    mip_read_float(r, v->uncertainty, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_body_frame_velocity(struct mip_writer *w, const void *value) {
    const struct mip_aiding_body_frame_velocity *v =
        (const struct mip_aiding_body_frame_velocity *)value;
    mip_aiding_measurement_time_write(w, &v->time);
    mip_write_u8(w, &v->frame_id, 1);
    mip_write_float(w, v->velocity, 3);
    mip_write_float(w, v->uncertainty, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_aiding_body_frame_velocity_codec = {
    0x13, /* descriptor set */
    MIP_AIDING_BODY_FRAME_VELOCITY_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_aiding_body_frame_velocity),
    0, /* time-out */
    read_body_frame_velocity,
    write_body_frame_velocity,
    NULL,
    NULL,
    NULL,
};

mip_error mip_aiding_body_frame_velocity_decode(struct mip_aiding_body_frame_velocity *value,
                                                const struct mip_field *field) {
    return mip_decode_field(field, read_body_frame_velocity, value, sizeof(*value), NULL);
}

mip_error mip_aiding_body_frame_velocity_encode(const struct mip_aiding_body_frame_velocity *value,
                                                struct mip_builder *builder) {
    return mip_encode_field(builder, 0x13, MIP_AIDING_BODY_FRAME_VELOCITY_DESCRIPTOR,
                            write_body_frame_velocity, value);
}

struct mip_aiding_body_frame_velocity mip_aiding_body_frame_velocity_make(
    const struct mip_aiding_measurement_time *time, uint8_t frame_id, const float velocity[3],
    const float uncertainty[3], mip_aiding_axis_flags valid_flags) {
    struct mip_aiding_body_frame_velocity v;
    memset(&v, 0, sizeof(v));
    v.time = *time;
    v.frame_id = frame_id;
    memcpy(v.velocity, velocity, sizeof(v.velocity));
    memcpy(v.uncertainty, uncertainty, sizeof(v.uncertainty));
    v.valid_flags = valid_flags;
    return v;
}

static void read_true_heading(struct mip_reader *r, void *value) {
    struct mip_aiding_true_heading *v = (struct mip_aiding_true_heading *)value;
    mip_aiding_measurement_time_read(r, &v->time);
    mip_read_u8(r, &v->frame_id, 1);
    mip_read_float(r, &v->heading, 1);
    mip_read_float(r, &v->uncertainty, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_true_heading(struct mip_writer *w, const void *value) {
    const struct mip_aiding_true_heading *v = (const struct mip_aiding_true_heading *)value;
    mip_aiding_measurement_time_write(w, &v->time);
    mip_write_u8(w, &v->frame_id, 1);
    mip_write_float(w, &v->heading, 1);
    mip_write_float(w, &v->uncertainty, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_aiding_true_heading_codec = {
    0x13, /* descriptor set */
    MIP_AIDING_TRUE_HEADING_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_aiding_true_heading),
    0, /* time-out */
    read_true_heading,
    write_true_heading,
    NULL,
    NULL,
    NULL,
};

mip_error mip_aiding_true_heading_decode(struct mip_aiding_true_heading *value,
                                         const struct mip_field *field) {
    return mip_decode_field(field, read_true_heading, value, sizeof(*value), NULL);
}

mip_error mip_aiding_true_heading_encode(const struct mip_aiding_true_heading *value,
                                         struct mip_builder *builder) {
    return mip_encode_field(builder, 0x13, MIP_AIDING_TRUE_HEADING_DESCRIPTOR, write_true_heading,
                            value);
}

struct mip_aiding_true_heading
mip_aiding_true_heading_make(const struct mip_aiding_measurement_time *time, uint8_t frame_id,
                             float heading, float uncertainty, uint16_t valid_flags) {
    struct mip_aiding_true_heading v;
    memset(&v, 0, sizeof(v));
    v.time = *time;
    v.frame_id = frame_id;
    v.heading = heading;
    v.uncertainty = uncertainty;
    v.valid_flags = valid_flags;
    return v;
}

static void read_magnetic_field(struct mip_reader *r, void *value) {
    struct mip_aiding_magnetic_field *v = (struct mip_aiding_magnetic_field *)value;
    mip_aiding_measurement_time_read(r, &v->time);
    mip_read_u8(r, &v->frame_id, 1);
    mip_read_float(r, v->magnetic_field, 3);
    mip_read_float(r, v->uncertainty, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_magnetic_field(struct mip_writer *w, const void *value) {
    const struct mip_aiding_magnetic_field *v = (const struct mip_aiding_magnetic_field *)value;
    mip_aiding_measurement_time_write(w, &v->time);
    mip_write_u8(w, &v->frame_id, 1);
    mip_write_float(w, v->magnetic_field, 3);
    mip_write_float(w, v->uncertainty, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_aiding_magnetic_field_codec = {
    0x13, /* descriptor set */
    MIP_AIDING_MAGNETIC_FIELD_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_aiding_magnetic_field),
    0, /* time-out */
    read_magnetic_field,
    write_magnetic_field,
    NULL,
    NULL,
    NULL,
};

mip_error mip_aiding_magnetic_field_decode(struct mip_aiding_magnetic_field *value,
                                           const struct mip_field *field) {
    return mip_decode_field(field, read_magnetic_field, value, sizeof(*value), NULL);
}

mip_error mip_aiding_magnetic_field_encode(const struct mip_aiding_magnetic_field *value,
                                           struct mip_builder *builder) {
    return mip_encode_field(builder, 0x13, MIP_AIDING_MAGNETIC_FIELD_DESCRIPTOR,
                            write_magnetic_field, value);
}

struct mip_aiding_magnetic_field mip_aiding_magnetic_field_make(
    const struct mip_aiding_measurement_time *time, uint8_t frame_id, const float magnetic_field[3],
    const float uncertainty[3], mip_aiding_axis_flags valid_flags) {
    struct mip_aiding_magnetic_field v;
    memset(&v, 0, sizeof(v));
    v.time = *time;
    v.frame_id = frame_id;
    memcpy(v.magnetic_field, magnetic_field, sizeof(v.magnetic_field));
    memcpy(v.uncertainty, uncertainty, sizeof(v.uncertainty));
    v.valid_flags = valid_flags;
    return v;
}

static void read_pressure(struct mip_reader *r, void *value) {
    struct mip_aiding_pressure *v = (struct mip_aiding_pressure *)value;
    mip_aiding_measurement_time_read(r, &v->time);
    mip_read_u8(r, &v->frame_id, 1);
    mip_read_float(r, &v->pressure, 1);
    mip_read_float(r, &v->uncertainty, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_pressure(struct mip_writer *w, const void *value) {
    const struct mip_aiding_pressure *v = (const struct mip_aiding_pressure *)value;
    mip_aiding_measurement_time_write(w, &v->time);
    mip_write_u8(w, &v->frame_id, 1);
    mip_write_float(w, &v->pressure, 1);
    mip_write_float(w, &v->uncertainty, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_aiding_pressure_codec = {
    0x13, /* descriptor set */
    MIP_AIDING_PRESSURE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_aiding_pressure),
    0, /* time-out */
    read_pressure,
    write_pressure,
    NULL,
    NULL,
    NULL,
};

mip_error mip_aiding_pressure_decode(struct mip_aiding_pressure *value,
                                     const struct mip_field *field) {
    return mip_decode_field(field, read_pressure, value, sizeof(*value), NULL);
}

mip_error mip_aiding_pressure_encode(const struct mip_aiding_pressure *value,
                                     struct mip_builder *builder) {
    return mip_encode_field(builder, 0x13, MIP_AIDING_PRESSURE_DESCRIPTOR, write_pressure, value);
}

struct mip_aiding_pressure mip_aiding_pressure_make(const struct mip_aiding_measurement_time *time,
                                                    uint8_t frame_id, float pressure,
                                                    float uncertainty, uint16_t valid_flags) {
    struct mip_aiding_pressure v;
    memset(&v, 0, sizeof(v));
    v.time = *time;
    v.frame_id = frame_id;
    v.pressure = pressure;
    v.uncertainty = uncertainty;
    v.valid_flags = valid_flags;
    return v;
}
