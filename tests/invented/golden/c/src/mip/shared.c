/* Shared. */
#include "mip/shared.h"

#include <string.h>

static void read_timestamp(struct mip_reader *r, void *value) {
    struct mip_shared_timestamp *v = (struct mip_shared_timestamp *)value;
    mip_read_double(r, &v->tow, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_timestamp(struct mip_writer *w, const void *value) {
    const struct mip_shared_timestamp *v = (const struct mip_shared_timestamp *)value;
    mip_write_double(w, &v->tow, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_shared_timestamp_codec = {
    0xFF, /* descriptor set */
    MIP_SHARED_TIMESTAMP_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_shared_timestamp),
    0, /* time-out */
    read_timestamp,
    write_timestamp,
    NULL,
    NULL,
    NULL,
};

mip_error mip_shared_timestamp_decode(struct mip_shared_timestamp *value,
                                      const struct mip_field *field) {
    return mip_decode_field(field, read_timestamp, value, sizeof(*value), NULL);
}

mip_error mip_shared_timestamp_encode(const struct mip_shared_timestamp *value,
                                      struct mip_builder *builder) {
    return mip_encode_field(builder, 0xFF, MIP_SHARED_TIMESTAMP_DESCRIPTOR, write_timestamp, value);
}
