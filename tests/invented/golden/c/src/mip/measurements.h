/**
 * @file
 *
 * Measurements. Data of every type; `tools` has what they are set up with.
 *
 * Devices that may support a field, but are not certain to, are listed only in mip/profiles.h.
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
     * device. On the Model C: no flag says whether it is valid.
     */
    float scaled_accel[3];
    /** What is valid. On the Model C: only MIP_STATE_FLAGS_READY and MIP_STATE_FLAGS_LEVEL. */
    mip_state_flags valid_flags;
};

/** Descriptor set, one of those above, and descriptor, as mip_field_key gives them. */
#define MIP_MEASUREMENTS_ACCEL(descriptor_set) MIP_KEY(descriptor_set, 0x01)
/** Its descriptor. */
#define MIP_MEASUREMENTS_ACCEL_DESCRIPTOR 0x01
/** Its name in the specification, in the first of its sets. */
#define MIP_MEASUREMENTS_ACCEL_NAME "measurements.accel"

/** Its wire format. */
extern MIP_API const struct mip_codec mip_measurements_accel_codec;

/** Decodes it. On an error the structure is zeroed. */
static inline mip_error mip_measurements_accel_decode(struct mip_measurements_accel *value,
                                                      const struct mip_field *field) {
    return mip_decode_only(&mip_measurements_accel_codec, 0x01, value, sizeof(*value), field);
}

/** Adds it to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_measurements_accel_encode(
    const struct mip_measurements_accel *value, struct mip_builder *builder) {
    return mip_encode(&mip_measurements_accel_codec, value, builder);
}

/** The same without the table, for speed: decodes it. */
static inline mip_error mip_measurements_accel_decode_inline(struct mip_measurements_accel *value,
                                                             const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error = (set >= 0x80 && set <= 0x81) || set == 0x92
                                ? mip_field_check(field, set, 0x01, 14)
                                : MIP_ERROR_SET;
    if (error != MIP_OK || sizeof(*value) != 14) { /* gaps are zeroed, too */
        memset(value, 0, sizeof(*value));
    }
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->scaled_accel[i], field->data + 4 * i);
    }
    value->valid_flags = mip_get_16(field->data + 12);
    return MIP_OK;
}

/** The same without the table, for speed: adds it to a packet. */
MIP_CHECKED static inline mip_error mip_measurements_accel_encode_inline(
    const struct mip_measurements_accel *value, struct mip_builder *builder) {
    uint8_t *data;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = (set >= 0x80 && set <= 0x81) || set == 0x92
                                ? mip_builder_reserve(builder, set, 0x01, 14, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 4 * i, &value->scaled_accel[i]);
    }
    mip_put_16(data + 12, value->valid_flags);
    return MIP_OK;
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

/** Descriptor set, one of those above, and descriptor, as mip_field_key gives them. */
#define MIP_MEASUREMENTS_NUMBERS(descriptor_set) MIP_KEY(descriptor_set, 0x02)
/** Its descriptor. */
#define MIP_MEASUREMENTS_NUMBERS_DESCRIPTOR 0x02
/** Its name in the specification, in the first of its sets. */
#define MIP_MEASUREMENTS_NUMBERS_NAME "measurements.numbers"

/** Its wire format. */
extern MIP_API const struct mip_codec mip_measurements_numbers_codec;

/** Decodes it. On an error the structure is zeroed. */
static inline mip_error mip_measurements_numbers_decode(struct mip_measurements_numbers *value,
                                                        const struct mip_field *field) {
    return mip_decode_only(&mip_measurements_numbers_codec, 0x02, value, sizeof(*value), field);
}

/** Adds it to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_measurements_numbers_encode(
    const struct mip_measurements_numbers *value, struct mip_builder *builder) {
    return mip_encode(&mip_measurements_numbers_codec, value, builder);
}

/** The same without the table, for speed: decodes it. */
static inline mip_error mip_measurements_numbers_decode_inline(
    struct mip_measurements_numbers *value, const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error =
        set == 0x80 || set == 0x92 ? mip_field_check(field, set, 0x02, 44) : MIP_ERROR_SET;
    if (error != MIP_OK || sizeof(*value) != 44) { /* gaps are zeroed, too */
        memset(value, 0, sizeof(*value));
    }
    if (error != MIP_OK) {
        return error;
    }
    value->u8 = mip_get_8(field->data);
    value->u16 = mip_get_16(field->data + 1);
    value->u32 = mip_get_32(field->data + 3);
    value->u64 = mip_get_64(field->data + 7);
    value->s8 = (int8_t)mip_get_8(field->data + 15);
    value->s16 = (int16_t)mip_get_16(field->data + 16);
    value->s32 = (int32_t)mip_get_32(field->data + 18);
    value->s64 = (int64_t)mip_get_64(field->data + 22);
    mip_get_float(&value->float_, field->data + 30);
    mip_get_double(&value->double_, field->data + 34);
    value->bool_ = mip_get_8(field->data + 42);
    value->char_ = (char)mip_get_8(field->data + 43);
    return MIP_OK;
}

/** The same without the table, for speed: adds it to a packet. */
MIP_CHECKED static inline mip_error mip_measurements_numbers_encode_inline(
    const struct mip_measurements_numbers *value, struct mip_builder *builder) {
    uint8_t *data;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x80 || set == 0x92
                                ? mip_builder_reserve(builder, set, 0x02, 44, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->u8);
    mip_put_16(data + 1, value->u16);
    mip_put_32(data + 3, value->u32);
    mip_put_64(data + 7, value->u64);
    mip_put_8(data + 15, (uint8_t)value->s8);
    mip_put_16(data + 16, (uint16_t)value->s16);
    mip_put_32(data + 18, (uint32_t)value->s32);
    mip_put_64(data + 22, (uint64_t)value->s64);
    mip_put_float(data + 30, &value->float_);
    mip_put_double(data + 34, &value->double_);
    mip_put_8(data + 42, value->bool_);
    mip_put_8(data + 43, (uint8_t)value->char_);
    return MIP_OK;
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
    /** Of the name. The number of elements of name. */
    uint8_t length;
    /** The name. */
    char name[237];
    /** The number of elements of rest. */
    uint8_t rest_count;
    /** All that follows. */
    char rest[237];
};

/** Descriptor set, one of those above, and descriptor, as mip_field_key gives them. */
#define MIP_MEASUREMENTS_STRINGS(descriptor_set) MIP_KEY(descriptor_set, 0x03)
/** Its descriptor. */
#define MIP_MEASUREMENTS_STRINGS_DESCRIPTOR 0x03
/** Its name in the specification, in the first of its sets. */
#define MIP_MEASUREMENTS_STRINGS_NAME "measurements.strings"

/** Its wire format. */
extern MIP_API const struct mip_codec mip_measurements_strings_codec;

/** Decodes it. On an error the structure is zeroed. */
static inline mip_error mip_measurements_strings_decode(struct mip_measurements_strings *value,
                                                        const struct mip_field *field) {
    return mip_decode_only(&mip_measurements_strings_codec, 0x03, value, sizeof(*value), field);
}

/** Adds it to a packet. On an error the packet is unchanged. */
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

/** Descriptor set, one of those above, and descriptor, as mip_field_key gives them. */
#define MIP_MEASUREMENTS_HEALTH(descriptor_set) MIP_KEY(descriptor_set, 0x04)
/** Its descriptor. */
#define MIP_MEASUREMENTS_HEALTH_DESCRIPTOR 0x04
/** Its name in the specification, in the first of its sets. */
#define MIP_MEASUREMENTS_HEALTH_NAME "measurements.health"

/** Its wire format. */
extern MIP_API const struct mip_codec mip_measurements_health_codec;

/** Decodes it. On an error the structure is zeroed. */
static inline mip_error mip_measurements_health_decode(struct mip_measurements_health *value,
                                                       const struct mip_field *field) {
    return mip_decode_only(&mip_measurements_health_codec, 0x04, value, sizeof(*value), field);
}

/** Adds it to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_measurements_health_encode(
    const struct mip_measurements_health *value, struct mip_builder *builder) {
    return mip_encode(&mip_measurements_health_codec, value, builder);
}

/** The same without the table, for speed: decodes it. */
static inline mip_error mip_measurements_health_decode_inline(struct mip_measurements_health *value,
                                                              const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error =
        set == 0x80 || set == 0x92 ? mip_field_check(field, set, 0x04, 20) : MIP_ERROR_SET;
    if (error != MIP_OK || sizeof(*value) != 20) { /* gaps are zeroed, too */
        memset(value, 0, sizeof(*value));
    }
    if (error != MIP_OK) {
        return error;
    }
    memcpy(value->result.bytes, field->data, 16);
    value->code = mip_get_32(field->data + 16);
    return MIP_OK;
}

/** The same without the table, for speed: adds it to a packet. */
MIP_CHECKED static inline mip_error mip_measurements_health_encode_inline(
    const struct mip_measurements_health *value, struct mip_builder *builder) {
    uint8_t *data;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x80 || set == 0x92
                                ? mip_builder_reserve(builder, set, 0x04, 20, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    memcpy(data, value->result.bytes, 16);
    mip_put_32(data + 16, value->code);
    return MIP_OK;
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

/** Descriptor set, one of those above, and descriptor, as mip_field_key gives them. */
#define MIP_MEASUREMENTS_ARRAYS(descriptor_set) MIP_KEY(descriptor_set, 0x05)
/** Its descriptor. */
#define MIP_MEASUREMENTS_ARRAYS_DESCRIPTOR 0x05
/** Its name in the specification, in the first of its sets. */
#define MIP_MEASUREMENTS_ARRAYS_NAME "measurements.arrays"

/** Its wire format. */
extern MIP_API const struct mip_codec mip_measurements_arrays_codec;

/** Decodes it. On an error the structure is zeroed. */
static inline mip_error mip_measurements_arrays_decode(struct mip_measurements_arrays *value,
                                                       const struct mip_field *field) {
    return mip_decode_only(&mip_measurements_arrays_codec, 0x05, value, sizeof(*value), field);
}

/** Adds it to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_measurements_arrays_encode(
    const struct mip_measurements_arrays *value, struct mip_builder *builder) {
    return mip_encode(&mip_measurements_arrays_codec, value, builder);
}

/** The same without the table, for speed: decodes it. */
static inline mip_error mip_measurements_arrays_decode_inline(struct mip_measurements_arrays *value,
                                                              const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error =
        set == 0x80 || set == 0x92 ? mip_field_check(field, set, 0x05, 53) : MIP_ERROR_SET;
    if (error != MIP_OK || sizeof(*value) != 53) { /* gaps are zeroed, too */
        memset(value, 0, sizeof(*value));
    }
    if (error != MIP_OK) {
        return error;
    }
    memcpy(value->modes, field->data, 3);
    for (size_t i = 0; i < 2; i++) {
        value->flags[i] = mip_get_16(field->data + 3 + 2 * i);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->vectors[0][i], field->data + 7 + 4 * i);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_get_float(&value->vectors[1][i], field->data + 19 + 4 * i);
    }
    value->points[0].x = (int16_t)mip_get_16(field->data + 31);
    value->points[0].y = (int16_t)mip_get_16(field->data + 33);
    value->points[1].x = (int16_t)mip_get_16(field->data + 35);
    value->points[1].y = (int16_t)mip_get_16(field->data + 37);
    value->track.from.x = (int16_t)mip_get_16(field->data + 39);
    value->track.from.y = (int16_t)mip_get_16(field->data + 41);
    value->track.to.x = (int16_t)mip_get_16(field->data + 43);
    value->track.to.y = (int16_t)mip_get_16(field->data + 45);
    memcpy(value->track.weights, field->data + 47, 2);
    memcpy(value->offsets, field->data + 49, 4);
    return MIP_OK;
}

/** The same without the table, for speed: adds it to a packet. */
MIP_CHECKED static inline mip_error mip_measurements_arrays_encode_inline(
    const struct mip_measurements_arrays *value, struct mip_builder *builder) {
    uint8_t *data;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x80 || set == 0x92
                                ? mip_builder_reserve(builder, set, 0x05, 53, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    memcpy(data, value->modes, 3);
    for (size_t i = 0; i < 2; i++) {
        mip_put_16(data + 3 + 2 * i, value->flags[i]);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 7 + 4 * i, &value->vectors[0][i]);
    }
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 19 + 4 * i, &value->vectors[1][i]);
    }
    mip_put_16(data + 31, (uint16_t)value->points[0].x);
    mip_put_16(data + 33, (uint16_t)value->points[0].y);
    mip_put_16(data + 35, (uint16_t)value->points[1].x);
    mip_put_16(data + 37, (uint16_t)value->points[1].y);
    mip_put_16(data + 39, (uint16_t)value->track.from.x);
    mip_put_16(data + 41, (uint16_t)value->track.from.y);
    mip_put_16(data + 43, (uint16_t)value->track.to.x);
    mip_put_16(data + 45, (uint16_t)value->track.to.y);
    memcpy(data + 47, value->track.weights, 2);
    memcpy(data + 49, value->offsets, 4);
    return MIP_OK;
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
     * Number of parameters that are present. When decoding: those received. To send: 0 for only the
     * required ones; a ..._WITH_... constant for all up to that one.
     */
    uint8_t present;
    /** Always there. */
    uint16_t first;
    /** From version 2 on. Optional. */
    uint16_t second;
    /** From version 3 on. Unit: deg. Optional. */
    float third;
};

/** Descriptor set, one of those above, and descriptor, as mip_field_key gives them. */
#define MIP_MEASUREMENTS_GROWING(descriptor_set) MIP_KEY(descriptor_set, 0x06)
/** Its descriptor. */
#define MIP_MEASUREMENTS_GROWING_DESCRIPTOR 0x06
/** Its name in the specification, in the first of its sets. */
#define MIP_MEASUREMENTS_GROWING_NAME "measurements.growing"
/** The value of `present` if second is the last parameter that is there. */
#define MIP_MEASUREMENTS_GROWING_WITH_SECOND 2
/** The value of `present` if third is the last parameter that is there. */
#define MIP_MEASUREMENTS_GROWING_WITH_THIRD 3

/** Its wire format. */
extern MIP_API const struct mip_codec mip_measurements_growing_codec;

/** Decodes it. On an error the structure is zeroed. */
static inline mip_error mip_measurements_growing_decode(struct mip_measurements_growing *value,
                                                        const struct mip_field *field) {
    return mip_decode_only(&mip_measurements_growing_codec, 0x06, value, sizeof(*value), field);
}

/** Adds it to a packet. On an error the packet is unchanged. */
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

/** Descriptor set, one of those above, and descriptor, as mip_field_key gives them. */
#define MIP_MEASUREMENTS_RADIO(descriptor_set) MIP_KEY(descriptor_set, 0x07)
/** Its descriptor. */
#define MIP_MEASUREMENTS_RADIO_DESCRIPTOR 0x07
/** Its name in the specification, in the first of its sets. */
#define MIP_MEASUREMENTS_RADIO_NAME "measurements.radio"

/** Its wire format. */
extern MIP_API const struct mip_codec mip_measurements_radio_codec;

/** Decodes it. On an error the structure is zeroed. */
static inline mip_error mip_measurements_radio_decode(struct mip_measurements_radio *value,
                                                      const struct mip_field *field) {
    return mip_decode_only(&mip_measurements_radio_codec, 0x07, value, sizeof(*value), field);
}

/** Adds it to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_measurements_radio_encode(
    const struct mip_measurements_radio *value, struct mip_builder *builder) {
    return mip_encode(&mip_measurements_radio_codec, value, builder);
}

/** The same without the table, for speed: decodes it. */
static inline mip_error mip_measurements_radio_decode_inline(struct mip_measurements_radio *value,
                                                             const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error =
        set == 0x80 || set == 0x92 ? mip_field_check(field, set, 0x07, 29) : MIP_ERROR_SET;
    if (error != MIP_OK || sizeof(*value) != 29) { /* gaps are zeroed, too */
        memset(value, 0, sizeof(*value));
    }
    if (error != MIP_OK) {
        return error;
    }
    value->connected = mip_get_8(field->data);
    value->strength = (int32_t)mip_get_32(field->data + 1);
    mip_get_float(&value->noise, field->data + 5);
    mip_get_float(&value->gap, field->data + 9);
    for (size_t i = 0; i < 2; i++) {
        mip_get_double(&value->gaps[i], field->data + 13 + 8 * i);
    }
    return MIP_OK;
}

/** The same without the table, for speed: adds it to a packet. */
MIP_CHECKED static inline mip_error mip_measurements_radio_encode_inline(
    const struct mip_measurements_radio *value, struct mip_builder *builder) {
    uint8_t *data;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x80 || set == 0x92
                                ? mip_builder_reserve(builder, set, 0x07, 29, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->connected);
    mip_put_32(data + 1, (uint32_t)value->strength);
    mip_put_float(data + 5, &value->noise);
    mip_put_float(data + 9, &value->gap);
    for (size_t i = 0; i < 2; i++) {
        mip_put_double(data + 13 + 8 * i, &value->gaps[i]);
    }
    return MIP_OK;
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

/** Descriptor set and descriptor, as mip_field_key gives them. */
#define MIP_MEASUREMENTS_OWN 0x8107
/** Its descriptor. */
#define MIP_MEASUREMENTS_OWN_DESCRIPTOR 0x07
/** Its name in the specification. */
#define MIP_MEASUREMENTS_OWN_NAME "more.own"

/** Its wire format. */
extern MIP_API const struct mip_codec mip_measurements_own_codec;

/** Decodes it. On an error the structure is zeroed. */
static inline mip_error mip_measurements_own_decode(struct mip_measurements_own *value,
                                                    const struct mip_field *field) {
    return mip_decode_only(&mip_measurements_own_codec, 0x07, value, sizeof(*value), field);
}

/** Adds it to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error
mip_measurements_own_encode(const struct mip_measurements_own *value, struct mip_builder *builder) {
    return mip_encode(&mip_measurements_own_codec, value, builder);
}

/** The same without the table, for speed: decodes it. */
static inline mip_error mip_measurements_own_decode_inline(struct mip_measurements_own *value,
                                                           const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x81, 0x07, 1);
    if (error != MIP_OK || sizeof(*value) != 1) { /* gaps are zeroed, too */
        memset(value, 0, sizeof(*value));
    }
    if (error != MIP_OK) {
        return error;
    }
    value->mode = mip_get_8(field->data);
    return MIP_OK;
}

/** The same without the table, for speed: adds it to a packet. */
MIP_CHECKED static inline mip_error mip_measurements_own_encode_inline(
    const struct mip_measurements_own *value, struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x81, 0x07, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->mode);
    return MIP_OK;
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
    /** Number of points. The number of elements of points. */
    uint8_t num_points;
    /** The points. */
    struct mip_point points[61];
    /** Behind an array that fills the field. Unit: s. */
    uint64_t stamp;
};

/** Descriptor set, one of those above, and descriptor, as mip_field_key gives them. */
#define MIP_MEASUREMENTS_CLOUD(descriptor_set) MIP_KEY(descriptor_set, 0x08)
/** Its descriptor. */
#define MIP_MEASUREMENTS_CLOUD_DESCRIPTOR 0x08
/** Its name in the specification, in the first of its sets. */
#define MIP_MEASUREMENTS_CLOUD_NAME "measurements.cloud"

/** Its wire format. */
extern MIP_API const struct mip_codec mip_measurements_cloud_codec;

/** Decodes it. On an error the structure is zeroed. */
static inline mip_error mip_measurements_cloud_decode(struct mip_measurements_cloud *value,
                                                      const struct mip_field *field) {
    return mip_decode_only(&mip_measurements_cloud_codec, 0x08, value, sizeof(*value), field);
}

/** Adds it to a packet. On an error the packet is unchanged. */
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

/** Descriptor set, one of those above, and descriptor, as mip_field_key gives them. */
#define MIP_MEASUREMENTS_GUST(descriptor_set) MIP_KEY(descriptor_set, 0x09)
/** Its descriptor. */
#define MIP_MEASUREMENTS_GUST_DESCRIPTOR 0x09
/** Its name in the specification, in the first of its sets. */
#define MIP_MEASUREMENTS_GUST_NAME "measurements.gust"

/** Its wire format. */
extern MIP_API const struct mip_codec mip_measurements_gust_codec;

/** Decodes it. On an error the structure is zeroed. */
static inline mip_error mip_measurements_gust_decode(struct mip_measurements_gust *value,
                                                     const struct mip_field *field) {
    return mip_decode_only(&mip_measurements_gust_codec, 0x09, value, sizeof(*value), field);
}

/** Adds it to a packet. On an error the packet is unchanged. */
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

/** Descriptor set, one of those above, and descriptor, as mip_field_key gives them. */
#define MIP_MEASUREMENTS_BREEZE(descriptor_set) MIP_KEY(descriptor_set, 0x0A)
/** Its descriptor. */
#define MIP_MEASUREMENTS_BREEZE_DESCRIPTOR 0x0A
/** Its name in the specification, in the first of its sets. */
#define MIP_MEASUREMENTS_BREEZE_NAME "measurements.breeze"

/** Its wire format. */
extern MIP_API const struct mip_codec mip_measurements_breeze_codec;

/** Decodes it. On an error the structure is zeroed. */
static inline mip_error mip_measurements_breeze_decode(struct mip_measurements_breeze *value,
                                                       const struct mip_field *field) {
    return mip_decode_only(&mip_measurements_breeze_codec, 0x0A, value, sizeof(*value), field);
}

/** Adds it to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_measurements_breeze_encode(
    const struct mip_measurements_breeze *value, struct mip_builder *builder) {
    return mip_encode(&mip_measurements_breeze_codec, value, builder);
}

/** The same without the table, for speed: decodes it. */
static inline mip_error mip_measurements_breeze_decode_inline(struct mip_measurements_breeze *value,
                                                              const struct mip_field *field) {
    const uint8_t set = field->descriptor_set;
    const mip_error error =
        set == 0x80 || set == 0x92 ? mip_field_check(field, set, 0x0A, 24) : MIP_ERROR_SET;
    if (error != MIP_OK || sizeof(*value) != 24) { /* gaps are zeroed, too */
        memset(value, 0, sizeof(*value));
    }
    if (error != MIP_OK) {
        return error;
    }
    value->place.x = (int16_t)mip_get_16(field->data);
    value->place.y = (int16_t)mip_get_16(field->data + 2);
    mip_get_float(&value->height, field->data + 4);
    for (size_t i = 0; i < 4; i++) {
        mip_get_float(&value->turn[i], field->data + 8 + 4 * i);
    }
    return MIP_OK;
}

/** The same without the table, for speed: adds it to a packet. */
MIP_CHECKED static inline mip_error mip_measurements_breeze_encode_inline(
    const struct mip_measurements_breeze *value, struct mip_builder *builder) {
    uint8_t *data;
    const uint8_t set = mip_builder_set(builder);
    const mip_error error = set == 0x80 || set == 0x92
                                ? mip_builder_reserve(builder, set, 0x0A, 24, &data)
                                : MIP_ERROR_SET;
    if (error != MIP_OK) {
        return error;
    }
    mip_put_16(data, (uint16_t)value->place.x);
    mip_put_16(data + 2, (uint16_t)value->place.y);
    mip_put_float(data + 4, &value->height);
    for (size_t i = 0; i < 4; i++) {
        mip_put_float(data + 8 + 4 * i, &value->turn[i]);
    }
    return MIP_OK;
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
