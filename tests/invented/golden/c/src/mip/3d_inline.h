/**
 * @file
 * The same as _decode and _encode in mip/3d.h, but without tables, for speed. Only for fields whose
 * layout never varies.
 */
#ifndef MIP_3D_INLINE_H
#define MIP_3D_INLINE_H

#include "mip/3d.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/3d_inline.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Decodes 3d.default. On an error the structure is zeroed. */
static inline mip_error mip_3d_default_decode_inline(struct mip_3d_default *value,
                                                     const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x0C, 0x10, 5);
    if (error != MIP_OK || sizeof(*value) != 5) { /* gaps are zeroed, too */
        memset(value, 0, sizeof(*value));
    }
    if (error != MIP_OK) {
        return error;
    }
    value->class_ = mip_get_8(field->data);
    value->type = mip_get_8(field->data + 1);
    value->register_ = mip_get_8(field->data + 2);
    value->self = mip_get_8(field->data + 3);
    value->present_ = mip_get_8(field->data + 4);
    return MIP_OK;
}

/** Adds 3d.default to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3d_default_encode_inline(const struct mip_3d_default *value,
                                                                 struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x0C, 0x10, 5, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->class_);
    mip_put_8(data + 1, value->type);
    mip_put_8(data + 2, value->register_);
    mip_put_8(data + 3, value->self);
    mip_put_8(data + 4, value->present_);
    return MIP_OK;
}

#ifdef __cplusplus
}
#endif

#endif
