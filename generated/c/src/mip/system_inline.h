/**
 * @file
 * The same as _decode and _encode in mip/system.h, but without tables, for speed. Only for fields
 * whose layout never varies.
 */
#ifndef MIP_SYSTEM_INLINE_H
#define MIP_SYSTEM_INLINE_H

#include "mip/system.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/system_inline.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

static inline mip_error mip_system_interface_control_response_decode_inline(
    struct mip_system_interface_control_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x7F, 0x82, 9);
    if (mip_cleared(error, value, sizeof(*value), 9)) {
        return error;
    }
    value->port = mip_get_8(field->data);
    value->protocols_incoming = mip_get_32(field->data + 1);
    value->protocols_outgoing = mip_get_32(field->data + 5);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_system_interface_control_response_encode_inline(
    const struct mip_system_interface_control_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x7F, 0x82, 9, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->port);
    mip_put_32(data + 1, value->protocols_incoming);
    mip_put_32(data + 5, value->protocols_outgoing);
    return MIP_OK;
}

static inline mip_error mip_system_comm_mode_response_decode_inline(
    struct mip_system_comm_mode_response *value, const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x7F, 0x90, 1);
    if (mip_cleared(error, value, sizeof(*value), 1)) {
        return error;
    }
    value->mode = mip_get_8(field->data);
    return MIP_OK;
}

MIP_CHECKED static inline mip_error mip_system_comm_mode_response_encode_inline(
    const struct mip_system_comm_mode_response *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x7F, 0x90, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->mode);
    return MIP_OK;
}

#ifdef __cplusplus
}
#endif

#endif
