/**
 * @file
 *
 * Displacement data (0x90). Measurements of the DEMOD-DC, a digital demodulator for displacement
 * sensors.
 *
 * Devices that only probably support a field are listed in mip/profiles.h, not here.
 */
#ifndef MIP_DISPLACEMENT_DATA_H
#define MIP_DISPLACEMENT_DATA_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/displacement_data.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_displacement_data Displacement data (0x90)
 * @{ */

/** Descriptor set of these fields. */
#define MIP_DISPLACEMENT_DATA_SET 0x90

/**
 * Validity of the displacement timestamp. Uncertain: That it is a bitfield. MSCL considers the time
 * valid if the number is 1.
 */
typedef uint8_t mip_displacement_data_timestamp_flags;
/** Bit 0. The clock has been set; `time` is valid. */
#define MIP_DISPLACEMENT_DATA_TIMESTAMP_FLAGS_TIME 0x01U

/**
 * Raw displacement: data (0x90,0x01).
 *
 * Displacement in ADC counts.
 *
 * No device is known for certain to support it. Known only from the MicroStrain Communication
 * Library.
 *
 * - mscl: Raw displacement (0x90,0x01)
 */
struct mip_displacement_data_displacement_raw {
    /** Output of the analog-to-digital converter. Unit: 1. */
    uint32_t counts;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_DISPLACEMENT_DATA_DISPLACEMENT_RAW 0x9001
/** Its descriptor. */
#define MIP_DISPLACEMENT_DATA_DISPLACEMENT_RAW_DESCRIPTOR 0x01
/** Its name in the specification. */
#define MIP_DISPLACEMENT_DATA_DISPLACEMENT_RAW_NAME "displacement_data.displacement_raw"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_displacement_data_displacement_raw_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_displacement_data_displacement_raw_decode(
    struct mip_displacement_data_displacement_raw *value, const struct mip_field *field) {
    return mip_decode_only(&mip_displacement_data_displacement_raw_codec, 0x01, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_displacement_data_displacement_raw_encode(
    const struct mip_displacement_data_displacement_raw *value, struct mip_builder *builder) {
    return mip_encode(&mip_displacement_data_displacement_raw_codec, value, builder);
}

/**
 * Displacement: data (0x90,0x02).
 *
 * Displacement of the sensor, computed with its calibration.
 *
 * No device is known for certain to support it. Known only from the MicroStrain Communication
 * Library.
 *
 * - mscl: Displacement (0x90,0x02)
 */
struct mip_displacement_data_displacement {
    /** Position of the sensor along its axis. Unit: mm. */
    float displacement;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_DISPLACEMENT_DATA_DISPLACEMENT 0x9002
/** Its descriptor. */
#define MIP_DISPLACEMENT_DATA_DISPLACEMENT_DESCRIPTOR 0x02
/** Its name in the specification. */
#define MIP_DISPLACEMENT_DATA_DISPLACEMENT_NAME "displacement_data.displacement"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_displacement_data_displacement_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_displacement_data_displacement_decode(
    struct mip_displacement_data_displacement *value, const struct mip_field *field) {
    return mip_decode_only(&mip_displacement_data_displacement_codec, 0x02, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_displacement_data_displacement_encode(
    const struct mip_displacement_data_displacement *value, struct mip_builder *builder) {
    return mip_encode(&mip_displacement_data_displacement_codec, value, builder);
}

/**
 * Displacement Device Timestamp: data (0x90,0x04).
 *
 * Time of the measurement by the clock of the device.
 *
 * No device is known for certain to support it. Also called `displacement_timestamp`. Known only
 * from the MicroStrain Communication Library.
 *
 * - mscl: Displacement Device Timestamp (0x90,0x04)
 */
struct mip_displacement_data_timestamp {
    /** Validity of the displacement timestamp. */
    mip_displacement_data_timestamp_flags flags;
    /**
     * UTC since 1970-01-01, without leap seconds, if the clock was set to it. Unit: ns. Valid if
     * MIP_DISPLACEMENT_DATA_TIMESTAMP_FLAGS_TIME in flags is set.
     */
    uint64_t time;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_DISPLACEMENT_DATA_TIMESTAMP 0x9004
/** Its descriptor. */
#define MIP_DISPLACEMENT_DATA_TIMESTAMP_DESCRIPTOR 0x04
/** Its name in the specification. */
#define MIP_DISPLACEMENT_DATA_TIMESTAMP_NAME "displacement_data.timestamp"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_displacement_data_timestamp_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_displacement_data_timestamp_decode(
    struct mip_displacement_data_timestamp *value, const struct mip_field *field) {
    return mip_decode_only(&mip_displacement_data_timestamp_codec, 0x04, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_displacement_data_timestamp_encode(
    const struct mip_displacement_data_timestamp *value, struct mip_builder *builder) {
    return mip_encode(&mip_displacement_data_timestamp_codec, value, builder);
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
