/**
 * @file
 * Functions that tell whether values of the fields in mip/displacement_data.h are valid, by their
 * flags. `reading` is the result of mip_reading_of, in mip/timestamps.h: 0 if the device is not
 * known.
 */
#ifndef MIP_DISPLACEMENT_DATA_VALID_H
#define MIP_DISPLACEMENT_DATA_VALID_H

#include "mip/displacement_data.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/displacement_data_valid.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Are the values of displacement_data.timestamp valid? */
static inline bool
mip_displacement_data_timestamp_valid(const struct mip_displacement_data_timestamp *value) {
    return mip_has(value->flags, 0x1U);
}

#ifdef __cplusplus
}
#endif

#endif
