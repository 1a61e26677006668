/**
 * @file
 * The same as _decode and _encode in mip/protocol.h, but without tables, for speed. Only for fields
 * whose layout never varies.
 */
#ifndef MIP_PROTOCOL_INLINE_H
#define MIP_PROTOCOL_INLINE_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/protocol_inline.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

static inline mip_error mip_protocol_acknowledge_decode_inline(
    struct mip_protocol_acknowledge *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x00, 0xF1, 2);
    if (mip_cleared(error, value, sizeof(*value), 2)) {
        return error;
    }
    value->command = mip_get_8(field->data);
    value->code = mip_get_8(field->data + 1);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_protocol_acknowledge_encode_inline(
    const struct mip_protocol_acknowledge *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x00, 0xF1, 2, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->command);
    mip_put_8(data + 1, value->code);
    return MIP_OK;
}

#ifdef __cplusplus
}
#endif

#endif
