/**
 * @file
 * The same as _decode and _encode in mip/shared.h, but without tables, for speed. Only for fields
 * whose layout never varies.
 */
#ifndef MIP_SHARED_INLINE_H
#define MIP_SHARED_INLINE_H

#include "mip/shared.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/shared_inline.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Decodes shared.timestamp. On an error the structure is zeroed. */
static inline mip_error mip_shared_timestamp_decode_inline(struct mip_shared_timestamp *value,
                                                           const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0xFF, 0xD3, 10);
    if (error != MIP_OK || sizeof(*value) != 10) { /* gaps are zeroed, too */
        memset(value, 0, sizeof(*value));
    }
    if (error != MIP_OK) {
        return error;
    }
    mip_get_double(&value->tow, field->data);
    value->valid_flags = mip_get_16(field->data + 8);
    return MIP_OK;
}

/** Adds shared.timestamp to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_shared_timestamp_encode_inline(
    const struct mip_shared_timestamp *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0xFF, 0xD3, 10, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_double(data, &value->tow);
    mip_put_16(data + 8, value->valid_flags);
    return MIP_OK;
}

#ifdef __cplusplus
}
#endif

#endif
