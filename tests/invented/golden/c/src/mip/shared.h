/**
 * @file
 *
 * Shared (0xFF). Valid in every data set.
 */
#ifndef MIP_SHARED_H
#define MIP_SHARED_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/shared.h and mip/constants.h are not of one version"
#endif

#ifdef __cplusplus
extern "C" {
#endif

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

#define MIP_SHARED_TIMESTAMP_DESCRIPTOR 0xD3
#define MIP_SHARED_TIMESTAMP_NAME "shared.timestamp"

extern const struct mip_codec mip_shared_timestamp_codec;
mip_error mip_shared_timestamp_decode(struct mip_shared_timestamp *value,
                                      const struct mip_field *field);
mip_error mip_shared_timestamp_encode(const struct mip_shared_timestamp *value,
                                      struct mip_builder *builder);

#ifdef __cplusplus
}
#endif

#endif
