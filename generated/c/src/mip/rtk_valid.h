/**
 * @file
 * Functions that tell whether values of the fields in mip/rtk.h are valid, by their flags.
 * `reading` is the result of mip_reading_of, in mip/timestamps.h: 0 if the device is not known.
 */
#ifndef MIP_RTK_VALID_H
#define MIP_RTK_VALID_H

#include "mip/rtk.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/rtk_valid.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Are the values of rtk.get_rssi_response valid? */
static inline bool mip_rtk_get_rssi_response_valid(const struct mip_rtk_get_rssi_response *value) {
    return value->valid != 0;
}

#ifdef __cplusplus
}
#endif

#endif
