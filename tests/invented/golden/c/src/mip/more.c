/* More measurements. */
#include "mip/more.h"

#include <string.h>

static void read_own(struct mip_reader *r, void *value) {
    struct mip_more_own *v = (struct mip_more_own *)value;
    mip_read_u8(r, &v->mode, 1);
}

static void write_own(struct mip_writer *w, const void *value) {
    const struct mip_more_own *v = (const struct mip_more_own *)value;
    mip_write_u8(w, &v->mode, 1);
}

const struct mip_codec mip_more_own_codec = {
    0x81, /* descriptor set */
    MIP_MORE_OWN_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_more_own),
    0, /* time-out */
    read_own,
    write_own,
    NULL,
    NULL,
    NULL,
};

mip_error mip_more_own_decode(struct mip_more_own *value, const struct mip_field *field) {
    return mip_decode_field(field, read_own, value, sizeof(*value), NULL);
}

mip_error mip_more_own_encode(const struct mip_more_own *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x81, MIP_MORE_OWN_DESCRIPTOR, write_own, value);
}
