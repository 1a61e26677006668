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
 * Second acceleration: data (0x81,0x01).
 *
 * A vector whose elements are valid together.
 *
 * Has the layout of mip_measurements_accel. Maximum rate: 100 Hz. Supported by Model A and Model C.
 *
 * - guide: Second acceleration
 */
struct mip_more_accel {
    /**
     * Specific force. Elements: x, y, z. Unit: g. Frame: sensor. Each element has its own valid
     * flag. x: MIP_STATE_FLAGS_READY in valid_flags, y: MIP_STATE_FLAGS_HOT in valid_flags, z:
     * MIP_STATE_FLAGS_READY in valid_flags.
     */
    float scaled_accel[3];
    /** What is valid. */
    mip_state_flags valid_flags;
};

/** Descriptor set and descriptor, as mip_field_key gives them. */
#define MIP_MORE_ACCEL 0x8101
/** Its descriptor. */
#define MIP_MORE_ACCEL_DESCRIPTOR 0x01
/** Its name in the specification. */
#define MIP_MORE_ACCEL_NAME "more.accel"

/** Its wire format. */
extern MIP_API const struct mip_codec mip_more_accel_codec;

/** Decodes it. On an error the structure is zeroed. */
static inline mip_error mip_more_accel_decode(struct mip_more_accel *value,
                                              const struct mip_field *field) {
    return mip_decode(&mip_more_accel_codec, value, field, NULL);
}

/** Adds it to a packet. On an error the packet is unchanged. */
static inline mip_error mip_more_accel_encode(const struct mip_more_accel *value,
                                              struct mip_builder *builder) {
    return mip_encode(&mip_more_accel_codec, value, builder);
}

/** The same without the table, for speed: decodes it. */
static inline mip_error mip_more_accel_decode_inline(struct mip_more_accel *value,
                                                     const struct mip_field *field) {
    const mip_error error = mip_field_check(field, 0x81, 0x01, 14);
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
static inline mip_error mip_more_accel_encode_inline(const struct mip_more_accel *value,
                                                     struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x81, 0x01, 14, &data);
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
 * Strings: data (0x81,0x03).
 *
 * Fixed, counted, and to the end.
 *
 * Has the layout of mip_measurements_strings. Supported by Model A.
 *
 * - guide: Second strings
 */
struct mip_more_strings {
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

/** Descriptor set and descriptor, as mip_field_key gives them. */
#define MIP_MORE_STRINGS 0x8103
/** Its descriptor. */
#define MIP_MORE_STRINGS_DESCRIPTOR 0x03
/** Its name in the specification. */
#define MIP_MORE_STRINGS_NAME "more.strings"

/** Its wire format. */
extern MIP_API const struct mip_codec mip_more_strings_codec;

/** Decodes it. On an error the structure is zeroed. */
static inline mip_error mip_more_strings_decode(struct mip_more_strings *value,
                                                const struct mip_field *field) {
    return mip_decode(&mip_more_strings_codec, value, field, NULL);
}

/** Adds it to a packet. On an error the packet is unchanged. */
static inline mip_error mip_more_strings_encode(const struct mip_more_strings *value,
                                                struct mip_builder *builder) {
    return mip_encode(&mip_more_strings_codec, value, builder);
}

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
    /** Of the second sensor. A value of enum mip_mode. */
    uint8_t mode;
};

/** Descriptor set and descriptor, as mip_field_key gives them. */
#define MIP_MORE_OWN 0x8107
/** Its descriptor. */
#define MIP_MORE_OWN_DESCRIPTOR 0x07
/** Its name in the specification. */
#define MIP_MORE_OWN_NAME "more.own"

/** Its wire format. */
extern MIP_API const struct mip_codec mip_more_own_codec;

/** Decodes it. On an error the structure is zeroed. */
static inline mip_error mip_more_own_decode(struct mip_more_own *value,
                                            const struct mip_field *field) {
    return mip_decode(&mip_more_own_codec, value, field, NULL);
}

/** Adds it to a packet. On an error the packet is unchanged. */
static inline mip_error mip_more_own_encode(const struct mip_more_own *value,
                                            struct mip_builder *builder) {
    return mip_encode(&mip_more_own_codec, value, builder);
}

/** The same without the table, for speed: decodes it. */
static inline mip_error mip_more_own_decode_inline(struct mip_more_own *value,
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
static inline mip_error mip_more_own_encode_inline(const struct mip_more_own *value,
                                                   struct mip_builder *builder) {
    uint8_t *data;
    const mip_error error = mip_builder_reserve(builder, 0x81, 0x07, 1, &data);
    if (error != MIP_OK) {
        return error;
    }
    mip_put_8(data, value->mode);
    return MIP_OK;
}

#ifdef __cplusplus
}
#endif

#endif
