/**
 * @file
 * Functions that tell whether values of the fields in mip/shared.h are valid, by their flags.
 * `reading` is the result of mip_reading_of, in mip/timestamps.h: 0 if the device is not known.
 */
#ifndef MIP_SHARED_VALID_H
#define MIP_SHARED_VALID_H

#include "mip/shared.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/shared_valid.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Is `tow` valid? */
static inline bool
mip_shared_gps_timestamp_tow_valid(const struct mip_shared_gps_timestamp *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Is `week_number` valid? */
static inline bool
mip_shared_gps_timestamp_week_number_valid(const struct mip_shared_gps_timestamp *value) {
    return mip_has(value->valid_flags, 0x2U);
}

/** Are the values of shared.external_timestamp valid? */
static inline bool
mip_shared_external_timestamp_valid(const struct mip_shared_external_timestamp *value) {
    return mip_has(value->valid_flags, 0x1U);
}

/** Are the values of shared.external_time_delta valid? */
static inline bool
mip_shared_external_time_delta_valid(const struct mip_shared_external_time_delta *value) {
    return mip_has(value->valid_flags, 0x1U);
}

#ifdef __cplusplus
}
#endif

#endif
