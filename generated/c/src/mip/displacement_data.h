/**
 * @file
 *
 * Displacement data (0x90). Measurements of the DEMOD-DC, a digital demodulator for displacement
 * sensors.
 */
#ifndef MIP_DISPLACEMENT_DATA_H
#define MIP_DISPLACEMENT_DATA_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/displacement_data.h and mip/constants.h are not of one version"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_displacement_data Displacement data (0x90)
 * @{ */

/** Descriptor set of these fields. */
#define MIP_DISPLACEMENT_DATA_SET 0x90

/**
 * Raw displacement: data (0x90,0x01).
 *
 * Displacement in counts of the converter.
 *
 * Not listed in any device profile. Known only from the MicroStrain Communication Library.
 *
 * - mscl: Raw displacement (0x90,0x01)
 */
struct mip_displacement_data_displacement_raw {
    /** Displacement in counts. Unit: 1. */
    uint32_t counts;
};

/** Descriptor set and descriptor, as mip_field_key gives them. */
#define MIP_DISPLACEMENT_DATA_DISPLACEMENT_RAW 0x9001
/** Its descriptor. */
#define MIP_DISPLACEMENT_DATA_DISPLACEMENT_RAW_DESCRIPTOR 0x01
/** Its name in the specification. */
#define MIP_DISPLACEMENT_DATA_DISPLACEMENT_RAW_NAME "displacement_data.displacement_raw"

/** Its wire format. */
extern MIP_API const struct mip_codec mip_displacement_data_displacement_raw_codec;

/** Decodes it. On an error the structure is zeroed. */
static inline mip_error mip_displacement_data_displacement_raw_decode(
    struct mip_displacement_data_displacement_raw *value, const struct mip_field *field) {
    return mip_decode_only(&mip_displacement_data_displacement_raw_codec, 0x01, value,
                           sizeof(*value), field);
}

/** Adds it to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_displacement_data_displacement_raw_encode(
    const struct mip_displacement_data_displacement_raw *value, struct mip_builder *builder) {
    return mip_encode(&mip_displacement_data_displacement_raw_codec, value, builder);
}
/**
 * Displacement: data (0x90,0x02).
 *
 * Calibrated displacement of the sensor.
 *
 * Not listed in any device profile. Known only from the MicroStrain Communication Library.
 *
 * - mscl: Displacement (0x90,0x02)
 */
struct mip_displacement_data_displacement {
    /** Displacement. Unit: mm. */
    float displacement;
};

/** Descriptor set and descriptor, as mip_field_key gives them. */
#define MIP_DISPLACEMENT_DATA_DISPLACEMENT 0x9002
/** Its descriptor. */
#define MIP_DISPLACEMENT_DATA_DISPLACEMENT_DESCRIPTOR 0x02
/** Its name in the specification. */
#define MIP_DISPLACEMENT_DATA_DISPLACEMENT_NAME "displacement_data.displacement"

/** Its wire format. */
extern MIP_API const struct mip_codec mip_displacement_data_displacement_codec;

/** Decodes it. On an error the structure is zeroed. */
static inline mip_error mip_displacement_data_displacement_decode(
    struct mip_displacement_data_displacement *value, const struct mip_field *field) {
    return mip_decode_only(&mip_displacement_data_displacement_codec, 0x02, value, sizeof(*value),
                           field);
}

/** Adds it to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_displacement_data_displacement_encode(
    const struct mip_displacement_data_displacement *value, struct mip_builder *builder) {
    return mip_encode(&mip_displacement_data_displacement_codec, value, builder);
}
/** @} */

#ifdef __cplusplus
}
#endif

#endif
