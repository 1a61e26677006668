/**
 * @file
 *
 * More measurements (0x81). A second sensor with the fields of the first.
 */
#ifndef MIP_MORE_H
#define MIP_MORE_H

#include "mip/protocol.h"
#include "mip/measurements.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/more.h and mip/constants.h are not of one version"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Descriptor set of these fields. */
#define MIP_MORE_SET 0x81

/**
 * Own: data (0x81,0x07).
 *
 * Beside those that it repeats.
 *
 * Supported by Model A and Model C.
 *
 * - guide: Own
 */
struct mip_more_own {
    /** Of the second sensor. */
    mip_mode mode;
};

#define MIP_MORE_OWN_DESCRIPTOR 0x07
#define MIP_MORE_OWN_NAME "more.own"

extern const struct mip_codec mip_more_own_codec;
mip_error mip_more_own_decode(struct mip_more_own *value, const struct mip_field *field);
mip_error mip_more_own_encode(const struct mip_more_own *value, struct mip_builder *builder);

/**
 * Second acceleration: data (0x81,0x01).
 *
 * A vector whose elements are valid together.
 *
 * Has the layout of mip_measurements_accel. Sent at 100 Hz at most. Supported by Model A and Model
 * C.
 *
 * - guide: Second acceleration
 */
#define mip_more_accel mip_measurements_accel
#define mip_more_accel_codec mip_measurements_accel_codec
#define mip_more_accel_decode mip_measurements_accel_decode
#define mip_more_accel_encode mip_measurements_accel_encode
#define MIP_MORE_ACCEL_DESCRIPTOR 0x01
#define MIP_MORE_ACCEL_NAME "more.accel"

/**
 * Strings: data (0x81,0x03).
 *
 * Fixed, counted, and to the end.
 *
 * Has the layout of mip_measurements_strings. Supported by Model A.
 *
 * - guide: Second strings
 */
#define mip_more_strings mip_measurements_strings
#define mip_more_strings_codec mip_measurements_strings_codec
#define mip_more_strings_decode mip_measurements_strings_decode
#define mip_more_strings_encode mip_measurements_strings_encode
#define MIP_MORE_STRINGS_DESCRIPTOR 0x03
#define MIP_MORE_STRINGS_NAME "more.strings"

#ifdef __cplusplus
}
#endif

#endif
