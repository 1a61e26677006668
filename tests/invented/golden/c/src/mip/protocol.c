/* The acknowledge field. */
#include "mip/protocol.h"

static void read_acknowledge(struct mip_reader *r, void *value) {
    struct mip_protocol_acknowledge *v = (struct mip_protocol_acknowledge *)value;
    mip_read_u8(r, &v->command, 1);
    mip_read_u8(r, &v->code, 1);
}

static void write_acknowledge(struct mip_writer *w, const void *value) {
    const struct mip_protocol_acknowledge *v = (const struct mip_protocol_acknowledge *)value;
    mip_write_u8(w, &v->command, 1);
    mip_write_u8(w, &v->code, 1);
}

const struct mip_codec mip_protocol_acknowledge_codec = {
    0x00, /* descriptor set */
    MIP_PROTOCOL_ACKNOWLEDGE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_protocol_acknowledge),
    0, /* time-out */
    read_acknowledge,
    write_acknowledge,
    NULL,
    NULL,
    NULL,
};

mip_error mip_protocol_acknowledge_decode(struct mip_protocol_acknowledge *value,
                                          const struct mip_field *field) {
    return mip_decode_field(field, read_acknowledge, value, sizeof(*value), NULL);
}

mip_error mip_protocol_acknowledge_encode(const struct mip_protocol_acknowledge *value,
                                          struct mip_builder *builder) {
    return mip_encode_field(builder, 0x00, MIP_PROTOCOL_ACKNOWLEDGE_DESCRIPTOR, write_acknowledge,
                            value);
}
