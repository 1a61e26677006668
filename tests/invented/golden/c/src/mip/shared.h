/**
 * @file
 *
 * Shared (0xFF). Valid in every data set.
 */
#ifndef MIP_SHARED_H
#define MIP_SHARED_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/shared.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_shared Shared (0xFF)
 * @{ */

/** Descriptor set of these fields. */
#define MIP_SHARED_SET 0xFF

/**
 * Timestamp: data (0xFF,0xD3).
 *
 * When the packet was sent.
 *
 * Supported by Model A and Model C.
 *
 * - guide: Timestamp
 */
struct mip_shared_timestamp {
    /** Time of week. Unit: s. Valid if MIP_STATE_FLAGS_READY in valid_flags is set. */
    double tow;
    /** What is valid. */
    mip_state_flags valid_flags;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_SHARED_TIMESTAMP 0xFFD3
/** Its descriptor. */
#define MIP_SHARED_TIMESTAMP_DESCRIPTOR 0xD3
/** Its name in the specification. */
#define MIP_SHARED_TIMESTAMP_NAME "shared.timestamp"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_shared_timestamp_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_shared_timestamp_decode(struct mip_shared_timestamp *value,
                                                    const struct mip_field *field) {
    return mip_decode_only(&mip_shared_timestamp_codec, 0xD3, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error
mip_shared_timestamp_encode(const struct mip_shared_timestamp *value, struct mip_builder *builder) {
    return mip_encode(&mip_shared_timestamp_codec, value, builder);
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
