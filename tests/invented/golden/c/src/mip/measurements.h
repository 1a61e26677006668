/**
 * @file
 *
 * Measurements (0x80). Data of every type; `tools` has what they are set up with.
 */
#ifndef MIP_MEASUREMENTS_H
#define MIP_MEASUREMENTS_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/measurements.h and mip/constants.h are not of one version"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Descriptor set of these fields. */
#define MIP_MEASUREMENTS_SET 0x80

/**
 * Acceleration: data (0x80,0x01).
 *
 * A vector whose elements are valid together.
 *
 * Sent at 100 Hz at most. Supported by Model A, Model B and Model C.
 *
 * - guide: Acceleration
 * - leaflet: Acceleration
 */
struct mip_measurements_accel {
    /**
     * Specific force. Elements: x, y, z. Unit: g. Frame: sensor. Each element is valid by its bit:
     * x by MIP_STATE_FLAGS_READY in valid_flags, y by MIP_STATE_FLAGS_HOT in valid_flags, z by
     * MIP_STATE_FLAGS_READY in valid_flags. On the Model B: unit m, m, s; frame ned; valid by
     * element: x by MIP_STATE_FLAGS_HOT in valid_flags, y by MIP_STATE_FLAGS_READY in valid_flags,
     * z by MIP_STATE_FLAGS_HOT in valid_flags. Turned by the device. On the Model C: nothing says
     * whether it is valid.
     */
    float scaled_accel[3];
    /** What is valid. On the Model C: only MIP_STATE_FLAGS_READY and MIP_STATE_FLAGS_LEVEL. */
    mip_state_flags valid_flags;
};

#define MIP_MEASUREMENTS_ACCEL_DESCRIPTOR 0x01
#define MIP_MEASUREMENTS_ACCEL_NAME "measurements.accel"

extern const struct mip_codec mip_measurements_accel_codec;
mip_error mip_measurements_accel_decode(struct mip_measurements_accel *value,
                                        const struct mip_field *field);
mip_error mip_measurements_accel_encode(const struct mip_measurements_accel *value,
                                        struct mip_builder *builder);

/**
 * Numbers: data (0x80,0x02).
 *
 * One of each.
 *
 * Supported by Model A and Model C. May be supported by Old 1 and Old 2.
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

#define MIP_MEASUREMENTS_NUMBERS_DESCRIPTOR 0x02
#define MIP_MEASUREMENTS_NUMBERS_NAME "measurements.numbers"

extern const struct mip_codec mip_measurements_numbers_codec;
mip_error mip_measurements_numbers_decode(struct mip_measurements_numbers *value,
                                          const struct mip_field *field);
mip_error mip_measurements_numbers_encode(const struct mip_measurements_numbers *value,
                                          struct mip_builder *builder);

/**
 * Strings: data (0x80,0x03).
 *
 * Fixed, counted, and to the end.
 *
 * Supported by Model A and Model C.
 *
 * - guide: Strings
 */
struct mip_measurements_strings {
    /** Padded with spaces. */
    char model[17];
    /** Of the name. The number of elements of name. */
    uint8_t length;
    /** The name. */
    char name[237];
    /** The number of elements of rest. */
    uint8_t rest_count;
    /** All that follows. */
    char rest[237];
};

#define MIP_MEASUREMENTS_STRINGS_DESCRIPTOR 0x03
#define MIP_MEASUREMENTS_STRINGS_NAME "measurements.strings"

extern const struct mip_codec mip_measurements_strings_codec;
mip_error mip_measurements_strings_decode(struct mip_measurements_strings *value,
                                          const struct mip_field *field);
mip_error mip_measurements_strings_encode(const struct mip_measurements_strings *value,
                                          struct mip_builder *builder);

/**
 * Health: data (0x80,0x04).
 *
 * The wide bitfield.
 *
 * Deprecated: use mip_measurements_numbers instead. Supported by Model A and Model C.
 *
 * - guide: Health
 */
struct mip_measurements_health {
    /** The bits. */
    struct mip_health result;
    /** An enumeration over four bytes. */
    mip_wide_code code;
};

#define MIP_MEASUREMENTS_HEALTH_DESCRIPTOR 0x04
#define MIP_MEASUREMENTS_HEALTH_NAME "measurements.health"

extern const struct mip_codec mip_measurements_health_codec;
mip_error mip_measurements_health_decode(struct mip_measurements_health *value,
                                         const struct mip_field *field);
mip_error mip_measurements_health_encode(const struct mip_measurements_health *value,
                                         struct mip_builder *builder);

/**
 * Arrays: data (0x80,0x05).
 *
 * Arrays of all that can stand in one.
 *
 * Supported by Model A and Model C.
 *
 * - guide: Arrays
 */
struct mip_measurements_arrays {
    /** Enumerations. */
    mip_mode modes[3];
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

#define MIP_MEASUREMENTS_ARRAYS_DESCRIPTOR 0x05
#define MIP_MEASUREMENTS_ARRAYS_NAME "measurements.arrays"

extern const struct mip_codec mip_measurements_arrays_codec;
mip_error mip_measurements_arrays_decode(struct mip_measurements_arrays *value,
                                         const struct mip_field *field);
mip_error mip_measurements_arrays_encode(const struct mip_measurements_arrays *value,
                                         struct mip_builder *builder);

/**
 * Growing: data (0x80,0x06).
 *
 * Newer devices send more of it.
 *
 * Supported by Model A and Model C.
 *
 * - guide: Growing
 */
struct mip_measurements_growing {
    /** Parameters that are present; 0: only the required ones. */
    uint8_t present;
    /** Always there. */
    uint16_t first;
    /** From version 2 on. Optional. */
    uint16_t second;
    /** From version 3 on. Unit: deg. Optional. */
    float third;
};

#define MIP_MEASUREMENTS_GROWING_DESCRIPTOR 0x06
#define MIP_MEASUREMENTS_GROWING_NAME "measurements.growing"
/** The value of `present` if second is the last parameter that is there. */
#define MIP_MEASUREMENTS_GROWING_WITH_SECOND 2
/** The value of `present` if third is the last parameter that is there. */
#define MIP_MEASUREMENTS_GROWING_WITH_THIRD 3

extern const struct mip_codec mip_measurements_growing_codec;
mip_error mip_measurements_growing_decode(struct mip_measurements_growing *value,
                                          const struct mip_field *field);
mip_error mip_measurements_growing_encode(const struct mip_measurements_growing *value,
                                          struct mip_builder *builder);

/**
 * Radio: data (0x80,0x07).
 *
 * A bool vouches for values; one source has no layout that agrees with it.
 *
 * Also called `modem` and `rf`. Supported by Model C. Known from the Kit of names only. Uncertain:
 * The leaflet gives the strength two bytes. Uncertain: Inferred: the strength is never positive.
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

#define MIP_MEASUREMENTS_RADIO_DESCRIPTOR 0x07
#define MIP_MEASUREMENTS_RADIO_NAME "measurements.radio"

extern const struct mip_codec mip_measurements_radio_codec;
mip_error mip_measurements_radio_decode(struct mip_measurements_radio *value,
                                        const struct mip_field *field);
mip_error mip_measurements_radio_encode(const struct mip_measurements_radio *value,
                                        struct mip_builder *builder);

/**
 * Cloud: data (0x80,0x08).
 *
 * The count can exceed what a field holds beside the value behind the array.
 *
 * Supported by Model A and Model C.
 *
 * - guide: Cloud
 */
struct mip_measurements_cloud {
    /** Number of points. The number of elements of points. */
    uint8_t num_points;
    /** The points. */
    struct mip_point points[61];
    /** Behind an array that fills the field. */
    uint64_t stamp;
};

#define MIP_MEASUREMENTS_CLOUD_DESCRIPTOR 0x08
#define MIP_MEASUREMENTS_CLOUD_NAME "measurements.cloud"

extern const struct mip_codec mip_measurements_cloud_codec;
mip_error mip_measurements_cloud_decode(struct mip_measurements_cloud *value,
                                        const struct mip_field *field);
mip_error mip_measurements_cloud_encode(const struct mip_measurements_cloud *value,
                                        struct mip_builder *builder);

/**
 * Gust: data (0x80,0x09).
 *
 * One valid flag for all values but one; mip_measurements_breeze has the same place.
 *
 * No device profile lists it.
 *
 * `speed * 3.6` is in km/h, and `valid_flags` tells whether `speed` counts; see mip_mode and
 * mip_tools_shape.
 *
 * On the wire only, without a member:
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

#define MIP_MEASUREMENTS_GUST_DESCRIPTOR 0x09
#define MIP_MEASUREMENTS_GUST_NAME "measurements.gust"

extern const struct mip_codec mip_measurements_gust_codec;
mip_error mip_measurements_gust_decode(struct mip_measurements_gust *value,
                                       const struct mip_field *field);
mip_error mip_measurements_gust_encode(const struct mip_measurements_gust *value,
                                       struct mip_builder *builder);

/**
 * Breeze: data (0x80,0x0A).
 *
 * Its place is told as in mip_measurements_gust.
 *
 * Supported by Model A and Model C.
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

#define MIP_MEASUREMENTS_BREEZE_DESCRIPTOR 0x0A
#define MIP_MEASUREMENTS_BREEZE_NAME "measurements.breeze"

extern const struct mip_codec mip_measurements_breeze_codec;
mip_error mip_measurements_breeze_decode(struct mip_measurements_breeze *value,
                                         const struct mip_field *field);
mip_error mip_measurements_breeze_encode(const struct mip_measurements_breeze *value,
                                         struct mip_builder *builder);

#ifdef __cplusplus
}
#endif

#endif
