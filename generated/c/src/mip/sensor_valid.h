/**
 * @file
 * Functions that tell whether values of the fields in mip/sensor.h are valid, by their flags.
 * `reading` is the result of mip_reading_of, in mip/timestamps.h: 0 if the device is not known.
 */
#ifndef MIP_SENSOR_VALID_H
#define MIP_SENSOR_VALID_H

#include "mip/sensor.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/sensor_valid.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Is `tow` valid? */
static inline bool mip_sensor_gps_timestamp_tow_valid(const struct mip_sensor_gps_timestamp *value,
                                                      uint8_t reading) {
    if (reading == 2U || (reading == 0U && (value->valid_flags & 0xFFF8U) == 0)) {
        return mip_has(value->valid_flags, 0x4U);
    }
    return mip_has(value->valid_flags, 0x8U);
}

/** Is `week_number` valid? */
static inline bool mip_sensor_gps_timestamp_week_number_valid(
    const struct mip_sensor_gps_timestamp *value, uint8_t reading) {
    if (reading == 2U || (reading == 0U && (value->valid_flags & 0xFFF8U) == 0)) {
        return mip_has(value->valid_flags, 0x4U);
    }
    return mip_has(value->valid_flags, 0x10U);
}

/** Are the values of sensor.odometer valid? */
static inline bool mip_sensor_odometer_valid(const struct mip_sensor_odometer *value) {
    return mip_has(value->valid_flags, 0x1U);
}

#ifdef __cplusplus
}
#endif

#endif
