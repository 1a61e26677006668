/* Awkward names. */
#include "mip/3d.h"

#include <string.h>

static void read_default(struct mip_reader *r, void *value) {
    struct mip_3d_default *v = (struct mip_3d_default *)value;
    mip_read_u8(r, &v->class_, 1);
    mip_read_u8(r, &v->type, 1);
    mip_read_u8(r, &v->register_, 1);
    mip_read_u8(r, &v->self, 1);
    mip_read_u8(r, &v->present_, 1);
}

static void write_default(struct mip_writer *w, const void *value) {
    const struct mip_3d_default *v = (const struct mip_3d_default *)value;
    mip_write_u8(w, &v->class_, 1);
    mip_write_u8(w, &v->type, 1);
    mip_write_u8(w, &v->register_, 1);
    mip_write_u8(w, &v->self, 1);
    mip_write_u8(w, &v->present_, 1);
}

const struct mip_codec mip_3d_default_codec = {
    0x0C, /* descriptor set */
    MIP_3D_DEFAULT_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_3d_default),
    0, /* time-out */
    read_default,
    write_default,
    NULL,
    NULL,
    NULL,
};

mip_error mip_3d_default_decode(struct mip_3d_default *value, const struct mip_field *field) {
    return mip_decode_field(field, read_default, value, sizeof(*value), NULL);
}

mip_error mip_3d_default_encode(const struct mip_3d_default *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0C, MIP_3D_DEFAULT_DESCRIPTOR, write_default, value);
}

struct mip_3d_default mip_3d_default_make(uint8_t class_, uint8_t type, uint8_t register_,
                                          uint8_t self, uint8_t present_) {
    struct mip_3d_default v;
    memset(&v, 0, sizeof(v));
    v.class_ = class_;
    v.type = type;
    v.register_ = register_;
    v.self = self;
    v.present_ = present_;
    return v;
}
