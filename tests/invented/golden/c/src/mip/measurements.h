/**
 * @file
 *
 * Measurements. Data of every type; `tools` has what they are set up with.
 *
 * Devices that only probably support a field are listed in mip/profiles.h, not here.
 */
#ifndef MIP_MEASUREMENTS_H
#define MIP_MEASUREMENTS_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/measurements.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_measurements Measurements (0x80, 0x81, 0x92)
 * @{ */

/** Descriptor set: Measurements. Data of every type; `tools` has what they are set up with. */
#define MIP_MEASUREMENTS_SET 0x80
/** Descriptor set: More measurements. A second sensor with some fields of the first. */
#define MIP_MORE_SET 0x81
/**
 * Descriptor set: Copied measurements. All the fields of another set. Uncertain: Which device sends
 * it.
 */
#define MIP_COPY_SET 0x92

/**
 * Acceleration: data 0x01.
 *
 * A vector whose elements are valid together.
 *
 * Occurs in MIP_MEASUREMENTS_SET, MIP_MORE_SET and MIP_COPY_SET. Maximum rate: 100 Hz. Supported by
 * Model A, Model B and Model C. On the Model C: firmware > 1.0.07.
 *
 * - guide: Acceleration
 * - leaflet: Acceleration
 * - guide: Second acceleration
 * - guide: Third acceleration
 */
struct mip_measurements_accel {
    /**
     * Specific force. Elements: x, y, z. Unit: g. Frame: sensor. At rest and level: x 0, z -1.
     * Positive: along mip_point. Each element has its own valid flag. x: MIP_STATE_FLAGS_READY in
     * valid_flags, y: MIP_STATE_FLAGS_HOT in valid_flags, z: MIP_STATE_FLAGS_READY in valid_flags.
     * On the Model B: unit m, m, s; frame ned; valid flags x: MIP_STATE_FLAGS_HOT in valid_flags,
     * y: MIP_STATE_FLAGS_READY in valid_flags, z: MIP_STATE_FLAGS_HOT in valid_flags. Turned by the
     * device. On the Model C: no flag marks it as valid.
     */
    float scaled_accel[3];
    /** What is valid. On the Model C: only MIP_STATE_FLAGS_READY and MIP_STATE_FLAGS_LEVEL. */
    mip_state_flags valid_flags;
};

/** Descriptor set, one of those above, and descriptor, as mip_field_key returns them. */
#define MIP_MEASUREMENTS_ACCEL(descriptor_set) MIP_KEY(descriptor_set, 0x01)
/** Its descriptor. */
#define MIP_MEASUREMENTS_ACCEL_DESCRIPTOR 0x01
/** Its name in the specification, in the first of its sets. */
#define MIP_MEASUREMENTS_ACCEL_NAME "measurements.accel"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_measurements_accel_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_measurements_accel_decode(struct mip_measurements_accel *value,
                                                      const struct mip_field *field) {
    return mip_decode_only(&mip_measurements_accel_codec, 0x01, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_measurements_accel_encode(
    const struct mip_measurements_accel *value, struct mip_builder *builder) {
    return mip_encode(&mip_measurements_accel_codec, value, builder);
}

/**
 * Numbers: data 0x02.
 *
 * One of each.
 *
 * Occurs in MIP_MEASUREMENTS_SET and MIP_COPY_SET. Supported by Model A and Model C.
 *
 * - guide: Numbers
 */
struct mip_measurements_numbers {
    /** Unsigned. */
    uint8_t u8;
    /** Unsigned. */
    uint16_t u16;
    /** Unsigned. */
    uint32_t u32;
    /** Unsigned. */
    uint64_t u64;
    /** Signed. */
    int8_t s8;
    /** Signed. */
    int16_t s16;
    /** Signed. */
    int32_t s32;
    /** Signed. */
    int64_t s64;
    /** Four bytes. Unit: 1. */
    float float_;
    /** Eight bytes. Unit: 1. */
    double double_;
    /** True or false. */
    mip_bool bool_;
    /** One character. */
    char char_;
};

/** Descriptor set, one of those above, and descriptor, as mip_field_key returns them. */
#define MIP_MEASUREMENTS_NUMBERS(descriptor_set) MIP_KEY(descriptor_set, 0x02)
/** Its descriptor. */
#define MIP_MEASUREMENTS_NUMBERS_DESCRIPTOR 0x02
/** Its name in the specification, in the first of its sets. */
#define MIP_MEASUREMENTS_NUMBERS_NAME "measurements.numbers"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_measurements_numbers_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_measurements_numbers_decode(struct mip_measurements_numbers *value,
                                                        const struct mip_field *field) {
    return mip_decode_only(&mip_measurements_numbers_codec, 0x02, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_measurements_numbers_encode(
    const struct mip_measurements_numbers *value, struct mip_builder *builder) {
    return mip_encode(&mip_measurements_numbers_codec, value, builder);
}

/**
 * Strings: data 0x03.
 *
 * Fixed, counted, and to the end.
 *
 * Occurs in MIP_MEASUREMENTS_SET, MIP_MORE_SET and MIP_COPY_SET. Supported by Model A and Model C.
 *
 * - guide: Strings
 * - guide: Second strings
 */
struct mip_measurements_strings {
    /** Padded with spaces. */
    char model[17];
    /** Of the name. Counts the elements of name. */
    uint8_t length;
    /** The name. */
    char name[237];
    /** The number of elements of rest. */
    uint8_t rest_count;
    /** All that follows. */
    char rest[237];
};

/** Descriptor set, one of those above, and descriptor, as mip_field_key returns them. */
#define MIP_MEASUREMENTS_STRINGS(descriptor_set) MIP_KEY(descriptor_set, 0x03)
/** Its descriptor. */
#define MIP_MEASUREMENTS_STRINGS_DESCRIPTOR 0x03
/** Its name in the specification, in the first of its sets. */
#define MIP_MEASUREMENTS_STRINGS_NAME "measurements.strings"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_measurements_strings_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_measurements_strings_decode(struct mip_measurements_strings *value,
                                                        const struct mip_field *field) {
    return mip_decode_only(&mip_measurements_strings_codec, 0x03, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_measurements_strings_encode(
    const struct mip_measurements_strings *value, struct mip_builder *builder) {
    return mip_encode(&mip_measurements_strings_codec, value, builder);
}

/**
 * Health: data 0x04.
 *
 * The wide bitfield.
 *
 * Deprecated: use mip_measurements_numbers instead. Occurs in MIP_MEASUREMENTS_SET and
 * MIP_COPY_SET. Supported by Model A and Model C.
 *
 * - guide: Health
 */
struct mip_measurements_health {
    /** The bits. */
    struct mip_health result;
    /** An enumeration over four bytes. A value of mip_wide_code. */
    uint32_t code;
};

/** Descriptor set, one of those above, and descriptor, as mip_field_key returns them. */
#define MIP_MEASUREMENTS_HEALTH(descriptor_set) MIP_KEY(descriptor_set, 0x04)
/** Its descriptor. */
#define MIP_MEASUREMENTS_HEALTH_DESCRIPTOR 0x04
/** Its name in the specification, in the first of its sets. */
#define MIP_MEASUREMENTS_HEALTH_NAME "measurements.health"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_measurements_health_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_measurements_health_decode(struct mip_measurements_health *value,
                                                       const struct mip_field *field) {
    return mip_decode_only(&mip_measurements_health_codec, 0x04, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_measurements_health_encode(
    const struct mip_measurements_health *value, struct mip_builder *builder) {
    return mip_encode(&mip_measurements_health_codec, value, builder);
}

/**
 * Arrays: data 0x05.
 *
 * Arrays of all that can stand in one.
 *
 * Occurs in MIP_MEASUREMENTS_SET and MIP_COPY_SET. Supported by Model A and Model C.
 *
 * - guide: Arrays
 */
struct mip_measurements_arrays {
    /** Enumerations. Values of enum mip_mode. */
    uint8_t modes[3];
    /** Bitfields. */
    mip_state_flags flags[2];
    /** Vectors. Elements: x, y, z. Unit: m. */
    float vectors[2][3];
    /** Structures. Unit: m. */
    struct mip_point points[2];
    /** A nested structure. */
    struct mip_segment track;
    /** Reserved. */
    int8_t offsets[4];
};

/** Descriptor set, one of those above, and descriptor, as mip_field_key returns them. */
#define MIP_MEASUREMENTS_ARRAYS(descriptor_set) MIP_KEY(descriptor_set, 0x05)
/** Its descriptor. */
#define MIP_MEASUREMENTS_ARRAYS_DESCRIPTOR 0x05
/** Its name in the specification, in the first of its sets. */
#define MIP_MEASUREMENTS_ARRAYS_NAME "measurements.arrays"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_measurements_arrays_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_measurements_arrays_decode(struct mip_measurements_arrays *value,
                                                       const struct mip_field *field) {
    return mip_decode_only(&mip_measurements_arrays_codec, 0x05, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_measurements_arrays_encode(
    const struct mip_measurements_arrays *value, struct mip_builder *builder) {
    return mip_encode(&mip_measurements_arrays_codec, value, builder);
}

/**
 * Growing: data 0x06.
 *
 * Newer devices send more of it.
 *
 * Occurs in MIP_MEASUREMENTS_SET and MIP_COPY_SET. Supported by Model A and Model C.
 *
 * - guide: Growing
 */
struct mip_measurements_growing {
    /**
     * Number of present parameters. Decoding sets it. 0 sends only the required ones; a
     * ..._WITH_... constant sends all up to that one.
     */
    uint8_t present;
    /** Always there. */
    uint16_t first;
    /** From version 2 on. Optional. */
    uint16_t second;
    /** From version 3 on. Unit: deg. Optional. */
    float third;
};

/** Descriptor set, one of those above, and descriptor, as mip_field_key returns them. */
#define MIP_MEASUREMENTS_GROWING(descriptor_set) MIP_KEY(descriptor_set, 0x06)
/** Its descriptor. */
#define MIP_MEASUREMENTS_GROWING_DESCRIPTOR 0x06
/** Its name in the specification, in the first of its sets. */
#define MIP_MEASUREMENTS_GROWING_NAME "measurements.growing"
/** The value of `present` if second is the last parameter that is present. */
#define MIP_MEASUREMENTS_GROWING_WITH_SECOND 2
/** The value of `present` if third is the last parameter that is present. */
#define MIP_MEASUREMENTS_GROWING_WITH_THIRD 3

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_measurements_growing_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_measurements_growing_decode(struct mip_measurements_growing *value,
                                                        const struct mip_field *field) {
    return mip_decode_only(&mip_measurements_growing_codec, 0x06, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_measurements_growing_encode(
    const struct mip_measurements_growing *value, struct mip_builder *builder) {
    return mip_encode(&mip_measurements_growing_codec, value, builder);
}

/**
 * Radio: data 0x07.
 *
 * A bool vouches for values; one source has no layout that agrees with it.
 *
 * Occurs in MIP_MEASUREMENTS_SET and MIP_COPY_SET. Also called `modem` and `rf`. Supported by Model
 * C. Known only from the Kit of names. Uncertain: The leaflet gives the strength two bytes.
 * Uncertain: Inferred: the strength is never positive.
 *
 * - sheet: Radio
 */
struct mip_measurements_radio {
    /** Whether there is a connection. */
    mip_bool connected;
    /** Of the signal. Range: less than 1. Valid if connected is true. Uncertain: Its unit. */
    int32_t strength;
    /**
     * Never nothing. Unit: m. Range: greater than 0, at most 10. Valid if connected is true. On the
     * Model C: valid if connected is true; deprecated.
     */
    float noise;
    /** Reserved. Reserved. */
    float gap;
    /** Reserved. */
    double gaps[2];
};

/** Descriptor set, one of those above, and descriptor, as mip_field_key returns them. */
#define MIP_MEASUREMENTS_RADIO(descriptor_set) MIP_KEY(descriptor_set, 0x07)
/** Its descriptor. */
#define MIP_MEASUREMENTS_RADIO_DESCRIPTOR 0x07
/** Its name in the specification, in the first of its sets. */
#define MIP_MEASUREMENTS_RADIO_NAME "measurements.radio"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_measurements_radio_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_measurements_radio_decode(struct mip_measurements_radio *value,
                                                      const struct mip_field *field) {
    return mip_decode_only(&mip_measurements_radio_codec, 0x07, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_measurements_radio_encode(
    const struct mip_measurements_radio *value, struct mip_builder *builder) {
    return mip_encode(&mip_measurements_radio_codec, value, builder);
}

/**
 * Own: data (0x81,0x07).
 *
 * In one of the sets only, with a descriptor that has another layout in the others.
 *
 * Supported by Model A and Model C. On the Model C: firmware > 1.0.07.
 *
 * - guide: Own
 */
struct mip_measurements_own {
    /** Of the second sensor. A value of enum mip_mode. */
    uint8_t mode;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_MEASUREMENTS_OWN 0x8107
/** Its descriptor. */
#define MIP_MEASUREMENTS_OWN_DESCRIPTOR 0x07
/** Its name in the specification. */
#define MIP_MEASUREMENTS_OWN_NAME "more.own"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_measurements_own_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_measurements_own_decode(struct mip_measurements_own *value,
                                                    const struct mip_field *field) {
    return mip_decode_only(&mip_measurements_own_codec, 0x07, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error
mip_measurements_own_encode(const struct mip_measurements_own *value, struct mip_builder *builder) {
    return mip_encode(&mip_measurements_own_codec, value, builder);
}

/**
 * Cloud: data 0x08.
 *
 * The count can exceed what a field holds beside the value behind the array.
 *
 * Occurs in MIP_MEASUREMENTS_SET and MIP_COPY_SET. Supported by Model A and Model C.
 *
 * - guide: Cloud
 */
struct mip_measurements_cloud {
    /** Number of points. Counts the elements of points. */
    uint8_t num_points;
    /** The points. */
    struct mip_point points[61];
    /** Behind an array that fills the field. Unit: s. */
    uint64_t stamp;
};

/** Descriptor set, one of those above, and descriptor, as mip_field_key returns them. */
#define MIP_MEASUREMENTS_CLOUD(descriptor_set) MIP_KEY(descriptor_set, 0x08)
/** Its descriptor. */
#define MIP_MEASUREMENTS_CLOUD_DESCRIPTOR 0x08
/** Its name in the specification, in the first of its sets. */
#define MIP_MEASUREMENTS_CLOUD_NAME "measurements.cloud"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_measurements_cloud_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_measurements_cloud_decode(struct mip_measurements_cloud *value,
                                                      const struct mip_field *field) {
    return mip_decode_only(&mip_measurements_cloud_codec, 0x08, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_measurements_cloud_encode(
    const struct mip_measurements_cloud *value, struct mip_builder *builder) {
    return mip_encode(&mip_measurements_cloud_codec, value, builder);
}

/**
 * Gust: data 0x09.
 *
 * One valid flag for all values but one; mip_measurements_breeze has the same place.
 *
 * Occurs in MIP_MEASUREMENTS_SET and MIP_COPY_SET. Not listed in any device profile.
 *
 * `speed * 3.6` is in km/h, and `valid_flags` tells whether `speed` counts; see enum mip_mode and
 * enum mip_tools_shape.
 *
 * Parameters without a member, on the wire only:
 * - gap: Always the same. Always 7.
 *
 * - guide: Gust
 */
struct mip_measurements_gust {
    /** Which one. */
    uint8_t station;
    /** Where it was measured. Valid if MIP_STATE_FLAGS_READY in valid_flags is set. */
    struct mip_point place;
    /** Above the plane. Unit: m. Valid if MIP_STATE_FLAGS_READY in valid_flags is set. */
    float height;
    /**
     * Of the wind. Elements: x, y, z. Unit: m. Range: magnitude at most 40. Valid if
     * MIP_STATE_FLAGS_READY in valid_flags is set.
     */
    float speed[3];
    /** What is valid. */
    mip_state_flags valid_flags;
};

/** Descriptor set, one of those above, and descriptor, as mip_field_key returns them. */
#define MIP_MEASUREMENTS_GUST(descriptor_set) MIP_KEY(descriptor_set, 0x09)
/** Its descriptor. */
#define MIP_MEASUREMENTS_GUST_DESCRIPTOR 0x09
/** Its name in the specification, in the first of its sets. */
#define MIP_MEASUREMENTS_GUST_NAME "measurements.gust"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_measurements_gust_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_measurements_gust_decode(struct mip_measurements_gust *value,
                                                     const struct mip_field *field) {
    return mip_decode_only(&mip_measurements_gust_codec, 0x09, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_measurements_gust_encode(
    const struct mip_measurements_gust *value, struct mip_builder *builder) {
    return mip_encode(&mip_measurements_gust_codec, value, builder);
}

/**
 * Breeze: data 0x0A.
 *
 * Its place is told as in mip_measurements_gust.
 *
 * Occurs in MIP_MEASUREMENTS_SET and MIP_COPY_SET. Supported by Model A and Model C.
 *
 * - guide: Breeze
 */
struct mip_measurements_breeze {
    /** Where it was measured. */
    struct mip_point place;
    /** Above the plane. Unit: m. */
    float height;
    /**
     * Of the vane. Elements: w, x, y, z. Unit: 1. Range: -1 to 1, magnitude 0.5 to 1.5. Default: 1,
     * 0, 0, 0.
     */
    float turn[4];
};

/** Descriptor set, one of those above, and descriptor, as mip_field_key returns them. */
#define MIP_MEASUREMENTS_BREEZE(descriptor_set) MIP_KEY(descriptor_set, 0x0A)
/** Its descriptor. */
#define MIP_MEASUREMENTS_BREEZE_DESCRIPTOR 0x0A
/** Its name in the specification, in the first of its sets. */
#define MIP_MEASUREMENTS_BREEZE_NAME "measurements.breeze"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_measurements_breeze_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_measurements_breeze_decode(struct mip_measurements_breeze *value,
                                                       const struct mip_field *field) {
    return mip_decode_only(&mip_measurements_breeze_codec, 0x0A, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_measurements_breeze_encode(
    const struct mip_measurements_breeze *value, struct mip_builder *builder) {
    return mip_encode(&mip_measurements_breeze_codec, value, builder);
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
