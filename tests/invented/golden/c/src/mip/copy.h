/**
 * @file
 *
 * Copied measurements (0x92). All the fields of another set. Uncertain: Which device sends it.
 */
#ifndef MIP_COPY_H
#define MIP_COPY_H

#include "mip/protocol.h"
#include "mip/measurements.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/copy.h and mip/constants.h are not of one version"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Descriptor set of these fields. */
#define MIP_COPY_SET 0x92

/**
 * Third acceleration: data (0x92,0x01).
 *
 * A vector whose elements are valid together.
 *
 * In full: copy.accel.
 *
 * Has the layout of mip_measurements_accel. Sent at 100 Hz at most. May be supported by Model C.
 *
 * - guide: Third acceleration
 */
#define mip_copy_acc mip_measurements_accel
#define mip_copy_acc_codec mip_measurements_accel_codec
#define mip_copy_acc_decode mip_measurements_accel_decode
#define mip_copy_acc_encode mip_measurements_accel_encode
#define MIP_COPY_ACC_DESCRIPTOR 0x01
#define MIP_COPY_ACC_NAME "copy.accel"

/**
 * Numbers: data (0x92,0x02).
 *
 * One of each.
 *
 * Has the layout of mip_measurements_numbers. No device profile lists it. Known from the Kit of
 * names only.
 *
 * - sheet: Copied measurements
 */
#define mip_copy_numbers mip_measurements_numbers
#define mip_copy_numbers_codec mip_measurements_numbers_codec
#define mip_copy_numbers_decode mip_measurements_numbers_decode
#define mip_copy_numbers_encode mip_measurements_numbers_encode
#define MIP_COPY_NUMBERS_DESCRIPTOR 0x02
#define MIP_COPY_NUMBERS_NAME "copy.numbers"

/**
 * Strings: data (0x92,0x03).
 *
 * Fixed, counted, and to the end.
 *
 * Has the layout of mip_measurements_strings. No device profile lists it. Known from the Kit of
 * names only.
 *
 * - sheet: Copied measurements
 */
#define mip_copy_strings mip_measurements_strings
#define mip_copy_strings_codec mip_measurements_strings_codec
#define mip_copy_strings_decode mip_measurements_strings_decode
#define mip_copy_strings_encode mip_measurements_strings_encode
#define MIP_COPY_STRINGS_DESCRIPTOR 0x03
#define MIP_COPY_STRINGS_NAME "copy.strings"

/**
 * Health: data (0x92,0x04).
 *
 * The wide bitfield.
 *
 * Deprecated: use mip_measurements_numbers instead. Has the layout of mip_measurements_health. No
 * device profile lists it. Known from the Kit of names only.
 *
 * - sheet: Copied measurements
 */
#define mip_copy_health mip_measurements_health
#define mip_copy_health_codec mip_measurements_health_codec
#define mip_copy_health_decode mip_measurements_health_decode
#define mip_copy_health_encode mip_measurements_health_encode
#define MIP_COPY_HEALTH_DESCRIPTOR 0x04
#define MIP_COPY_HEALTH_NAME "copy.health"

/**
 * Arrays: data (0x92,0x05).
 *
 * Arrays of all that can stand in one.
 *
 * Has the layout of mip_measurements_arrays. No device profile lists it. Known from the Kit of
 * names only.
 *
 * - sheet: Copied measurements
 */
#define mip_copy_arrays mip_measurements_arrays
#define mip_copy_arrays_codec mip_measurements_arrays_codec
#define mip_copy_arrays_decode mip_measurements_arrays_decode
#define mip_copy_arrays_encode mip_measurements_arrays_encode
#define MIP_COPY_ARRAYS_DESCRIPTOR 0x05
#define MIP_COPY_ARRAYS_NAME "copy.arrays"

/**
 * Growing: data (0x92,0x06).
 *
 * Newer devices send more of it.
 *
 * Has the layout of mip_measurements_growing. No device profile lists it. Known from the Kit of
 * names only.
 *
 * - sheet: Copied measurements
 */
#define mip_copy_growing mip_measurements_growing
#define mip_copy_growing_codec mip_measurements_growing_codec
#define mip_copy_growing_decode mip_measurements_growing_decode
#define mip_copy_growing_encode mip_measurements_growing_encode
#define MIP_COPY_GROWING_DESCRIPTOR 0x06
#define MIP_COPY_GROWING_NAME "copy.growing"
/** The value of `present` if second is the last parameter that is there. */
#define MIP_COPY_GROWING_WITH_SECOND 2
/** The value of `present` if third is the last parameter that is there. */
#define MIP_COPY_GROWING_WITH_THIRD 3

/**
 * Radio: data (0x92,0x07).
 *
 * A bool vouches for values; one source has no layout that agrees with it.
 *
 * Has the layout of mip_measurements_radio. Also called `modem` and `rf`. No device profile lists
 * it. Known from the Kit of names only. Uncertain: The leaflet gives the strength two bytes.
 * Uncertain: Inferred: the strength is never positive.
 *
 * - sheet: Copied measurements
 */
#define mip_copy_radio mip_measurements_radio
#define mip_copy_radio_codec mip_measurements_radio_codec
#define mip_copy_radio_decode mip_measurements_radio_decode
#define mip_copy_radio_encode mip_measurements_radio_encode
#define MIP_COPY_RADIO_DESCRIPTOR 0x07
#define MIP_COPY_RADIO_NAME "copy.radio"

/**
 * Cloud: data (0x92,0x08).
 *
 * The count can exceed what a field holds beside the value behind the array.
 *
 * Has the layout of mip_measurements_cloud. No device profile lists it. Known from the Kit of names
 * only.
 *
 * - sheet: Copied measurements
 */
#define mip_copy_cloud mip_measurements_cloud
#define mip_copy_cloud_codec mip_measurements_cloud_codec
#define mip_copy_cloud_decode mip_measurements_cloud_decode
#define mip_copy_cloud_encode mip_measurements_cloud_encode
#define MIP_COPY_CLOUD_DESCRIPTOR 0x08
#define MIP_COPY_CLOUD_NAME "copy.cloud"

/**
 * Gust: data (0x92,0x09).
 *
 * One valid flag for all values but one; mip_measurements_breeze has the same place.
 *
 * Has the layout of mip_measurements_gust. No device profile lists it. Known from the Kit of names
 * only.
 *
 * `speed * 3.6` is in km/h, and `valid_flags` tells whether `speed` counts; see mip_mode and
 * mip_tools_shape.
 *
 * - sheet: Copied measurements
 */
#define mip_copy_gust mip_measurements_gust
#define mip_copy_gust_codec mip_measurements_gust_codec
#define mip_copy_gust_decode mip_measurements_gust_decode
#define mip_copy_gust_encode mip_measurements_gust_encode
#define MIP_COPY_GUST_DESCRIPTOR 0x09
#define MIP_COPY_GUST_NAME "copy.gust"

/**
 * Breeze: data (0x92,0x0A).
 *
 * Its place is told as in mip_measurements_gust.
 *
 * Has the layout of mip_measurements_breeze. No device profile lists it. Known from the Kit of
 * names only.
 *
 * - sheet: Copied measurements
 */
#define mip_copy_breeze mip_measurements_breeze
#define mip_copy_breeze_codec mip_measurements_breeze_codec
#define mip_copy_breeze_decode mip_measurements_breeze_decode
#define mip_copy_breeze_encode mip_measurements_breeze_encode
#define MIP_COPY_BREEZE_DESCRIPTOR 0x0A
#define MIP_COPY_BREEZE_NAME "copy.breeze"

#ifdef __cplusplus
}
#endif

#endif
