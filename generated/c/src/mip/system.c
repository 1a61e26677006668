/* System. */
#include "mip/system.h"

#include <string.h>

/** Parameters that each function requires, by its value. */
static const uint8_t required_interface_control[] = {0, 3, 1, 1, 1, 1};

static void read_interface_control(struct mip_reader *r, void *value) {
    struct mip_system_interface_control *v = (struct mip_system_interface_control *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_interface_control,
                      sizeof(required_interface_control));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->port, 1);
    mip_read_group(r, 2, 2);
    mip_read_u32(r, &v->protocols_incoming, 1);
    mip_read_group(r, 3, 3);
    mip_read_u32(r, &v->protocols_outgoing, 1);
    v->present = mip_read_present(r);
}

static void write_interface_control(struct mip_writer *w, const void *value) {
    const struct mip_system_interface_control *v =
        (const struct mip_system_interface_control *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_interface_control,
                       sizeof(required_interface_control), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->port, 1);
    mip_write_group(w, 2, 2);
    mip_write_u32(w, &v->protocols_incoming, 1);
    mip_write_group(w, 3, 3);
    mip_write_u32(w, &v->protocols_outgoing, 1);
}

static bool asked_interface_control_1(const void *value) {
    const struct mip_system_interface_control *v =
        (const struct mip_system_interface_control *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_interface_control[] = {
    {&mip_system_interface_control_response_codec, asked_interface_control_1},
    {NULL, NULL},
};

const struct mip_codec mip_system_interface_control_codec = {
    0x7F, /* descriptor set */
    MIP_SYSTEM_INTERFACE_CONTROL_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_system_interface_control),
    0, /* time-out */
    read_interface_control,
    write_interface_control,
    NULL,
    responses_interface_control,
    NULL,
};

mip_error mip_system_interface_control_decode(struct mip_system_interface_control *value,
                                              const struct mip_field *field) {
    return mip_decode_field(field, read_interface_control, value, sizeof(*value), NULL);
}

mip_error mip_system_interface_control_encode(const struct mip_system_interface_control *value,
                                              struct mip_builder *builder) {
    return mip_encode_field(builder, 0x7F, MIP_SYSTEM_INTERFACE_CONTROL_DESCRIPTOR,
                            write_interface_control, value);
}

struct mip_system_interface_control mip_system_interface_control_write(
    mip_system_comm_interface port, mip_system_comm_protocols protocols_incoming,
    mip_system_comm_protocols protocols_outgoing) {
    struct mip_system_interface_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.port = port;
    v.protocols_incoming = protocols_incoming;
    v.protocols_outgoing = protocols_outgoing;
    return v;
}

struct mip_system_interface_control
mip_system_interface_control_read(mip_system_comm_interface port) {
    struct mip_system_interface_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    v.port = port;
    return v;
}

struct mip_system_interface_control
mip_system_interface_control_save(mip_system_comm_interface port) {
    struct mip_system_interface_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    v.port = port;
    return v;
}

struct mip_system_interface_control
mip_system_interface_control_load(mip_system_comm_interface port) {
    struct mip_system_interface_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    v.port = port;
    return v;
}

struct mip_system_interface_control
mip_system_interface_control_default(mip_system_comm_interface port) {
    struct mip_system_interface_control v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    v.port = port;
    return v;
}

static void read_interface_control_response(struct mip_reader *r, void *value) {
    struct mip_system_interface_control_response *v =
        (struct mip_system_interface_control_response *)value;
    mip_read_u8(r, &v->port, 1);
    mip_read_u32(r, &v->protocols_incoming, 1);
    mip_read_u32(r, &v->protocols_outgoing, 1);
}

static void write_interface_control_response(struct mip_writer *w, const void *value) {
    const struct mip_system_interface_control_response *v =
        (const struct mip_system_interface_control_response *)value;
    mip_write_u8(w, &v->port, 1);
    mip_write_u32(w, &v->protocols_incoming, 1);
    mip_write_u32(w, &v->protocols_outgoing, 1);
}

const struct mip_codec mip_system_interface_control_response_codec = {
    0x7F, /* descriptor set */
    MIP_SYSTEM_INTERFACE_CONTROL_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_system_interface_control_response),
    0, /* time-out */
    read_interface_control_response,
    write_interface_control_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_system_interface_control_response_decode(
    struct mip_system_interface_control_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_interface_control_response, value, sizeof(*value), NULL);
}

mip_error mip_system_interface_control_response_encode(
    const struct mip_system_interface_control_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x7F, MIP_SYSTEM_INTERFACE_CONTROL_RESPONSE_DESCRIPTOR,
                            write_interface_control_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_comm_mode[] = {0, 1, 0, 0, 0, 0};

static void read_comm_mode(struct mip_reader *r, void *value) {
    struct mip_system_comm_mode *v = (struct mip_system_comm_mode *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_comm_mode, sizeof(required_comm_mode));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->mode, 1);
    v->present = mip_read_present(r);
}

static void write_comm_mode(struct mip_writer *w, const void *value) {
    const struct mip_system_comm_mode *v = (const struct mip_system_comm_mode *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_comm_mode, sizeof(required_comm_mode), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->mode, 1);
}

static bool asked_comm_mode_1(const void *value) {
    const struct mip_system_comm_mode *v = (const struct mip_system_comm_mode *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_comm_mode[] = {
    {&mip_system_comm_mode_response_codec, asked_comm_mode_1},
    {NULL, NULL},
};

const struct mip_codec mip_system_comm_mode_codec = {
    0x7F, /* descriptor set */
    MIP_SYSTEM_COMM_MODE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_system_comm_mode),
    0, /* time-out */
    read_comm_mode,
    write_comm_mode,
    NULL,
    responses_comm_mode,
    NULL,
};

mip_error mip_system_comm_mode_decode(struct mip_system_comm_mode *value,
                                      const struct mip_field *field) {
    return mip_decode_field(field, read_comm_mode, value, sizeof(*value), NULL);
}

mip_error mip_system_comm_mode_encode(const struct mip_system_comm_mode *value,
                                      struct mip_builder *builder) {
    return mip_encode_field(builder, 0x7F, MIP_SYSTEM_COMM_MODE_DESCRIPTOR, write_comm_mode, value);
}

struct mip_system_comm_mode mip_system_comm_mode_write(mip_system_protocol_mode mode) {
    struct mip_system_comm_mode v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.mode = mode;
    return v;
}

struct mip_system_comm_mode mip_system_comm_mode_read(void) {
    struct mip_system_comm_mode v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_system_comm_mode mip_system_comm_mode_save(void) {
    struct mip_system_comm_mode v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_system_comm_mode mip_system_comm_mode_load(void) {
    struct mip_system_comm_mode v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_system_comm_mode mip_system_comm_mode_default(void) {
    struct mip_system_comm_mode v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_comm_mode_response(struct mip_reader *r, void *value) {
    struct mip_system_comm_mode_response *v = (struct mip_system_comm_mode_response *)value;
    mip_read_u8(r, &v->mode, 1);
}

static void write_comm_mode_response(struct mip_writer *w, const void *value) {
    const struct mip_system_comm_mode_response *v =
        (const struct mip_system_comm_mode_response *)value;
    mip_write_u8(w, &v->mode, 1);
}

const struct mip_codec mip_system_comm_mode_response_codec = {
    0x7F, /* descriptor set */
    MIP_SYSTEM_COMM_MODE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_system_comm_mode_response),
    0, /* time-out */
    read_comm_mode_response,
    write_comm_mode_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_system_comm_mode_response_decode(struct mip_system_comm_mode_response *value,
                                               const struct mip_field *field) {
    return mip_decode_field(field, read_comm_mode_response, value, sizeof(*value), NULL);
}

mip_error mip_system_comm_mode_response_encode(const struct mip_system_comm_mode_response *value,
                                               struct mip_builder *builder) {
    return mip_encode_field(builder, 0x7F, MIP_SYSTEM_COMM_MODE_RESPONSE_DESCRIPTOR,
                            write_comm_mode_response, value);
}
