/**
 * @file
 *
 * Displacement commands (0x11). Commands of the DEMOD-DC, a demodulator for displacement sensors.
 * Inertial sensors do not support them.
 *
 * Devices that only probably support a field are listed in mip/profiles.h, not here.
 */
#ifndef MIP_DISPLACEMENT_H
#define MIP_DISPLACEMENT_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/displacement.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_displacement Displacement commands (0x11)
 * @{ */

/** Descriptor set of these fields. */
#define MIP_DISPLACEMENT_SET 0x11

/**
 * Get Analog to Displacement Calibration: command (0x11,0x01).
 *
 * Reads the slope and offset with which the device converts ADC counts to displacement.
 *
 * No device is known for certain to support it. Also called `get_analog_displacement_calibration`.
 * Response: mip_displacement_get_calibration_response. Known only from the MicroStrain
 * Communication Library.
 *
 * - mscl: Get Analog to Displacement Calibration (0x11,0x01)
 */
struct mip_displacement_get_calibration {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_DISPLACEMENT_GET_CALIBRATION 0x1101
/** Its descriptor. */
#define MIP_DISPLACEMENT_GET_CALIBRATION_DESCRIPTOR 0x01
/** Its name in the specification. */
#define MIP_DISPLACEMENT_GET_CALIBRATION_NAME "displacement.get_calibration"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_displacement_get_calibration_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_displacement_get_calibration_decode(
    struct mip_displacement_get_calibration *value, const struct mip_field *field) {
    return mip_decode_only(&mip_displacement_get_calibration_codec, 0x01, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_displacement_get_calibration_encode(
    const struct mip_displacement_get_calibration *value, struct mip_builder *builder) {
    return mip_encode(&mip_displacement_get_calibration_codec, value, builder);
}

/**
 * Get Analog to Displacement Calibration response: response (0x11,0x81).
 *
 * No device is known for certain to support it. Also called
 * `get_analog_displacement_calibration_response`. Response to mip_displacement_get_calibration.
 * Known only from the MicroStrain Communication Library.
 *
 * - mscl: Get Analog to Displacement Calibration (0x11,0x01)
 */
struct mip_displacement_get_calibration_response {
    /** Displacement per ADC count. Uncertain: The unit; mm per count is likely. */
    float slope;
    /** Displacement at zero counts. Uncertain: The unit; mm is likely. */
    float offset;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_DISPLACEMENT_GET_CALIBRATION_RESPONSE 0x1181
/** Its descriptor. */
#define MIP_DISPLACEMENT_GET_CALIBRATION_RESPONSE_DESCRIPTOR 0x81
/** Its name in the specification. */
#define MIP_DISPLACEMENT_GET_CALIBRATION_RESPONSE_NAME "displacement.get_calibration_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_displacement_get_calibration_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_displacement_get_calibration_response_decode(
    struct mip_displacement_get_calibration_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_displacement_get_calibration_response_codec, 0x81, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_displacement_get_calibration_response_encode(
    const struct mip_displacement_get_calibration_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_displacement_get_calibration_response_codec, value, builder);
}

/**
 * Displacement Output Data Rate: command (0x11,0x02).
 *
 * Reads the rate at which displacement is measured.
 *
 * No device is known for certain to support it. Also called `displacement_output_rate`. Functions:
 * read. Response: mip_displacement_output_rate_response. Known only from the MicroStrain
 * Communication Library. Uncertain: Whether the rate can be written. MSCL only reads it.
 *
 * - mscl: Displacement Output Data Rate (0x11,0x02)
 */
struct mip_displacement_output_rate {
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_DISPLACEMENT_OUTPUT_RATE 0x1102
/** Its descriptor. */
#define MIP_DISPLACEMENT_OUTPUT_RATE_DESCRIPTOR 0x02
/** Its name in the specification. */
#define MIP_DISPLACEMENT_OUTPUT_RATE_NAME "displacement.output_rate"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_displacement_output_rate_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_displacement_output_rate_decode(
    struct mip_displacement_output_rate *value, const struct mip_field *field) {
    return mip_decode_only(&mip_displacement_output_rate_codec, 0x02, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_displacement_output_rate_encode(
    const struct mip_displacement_output_rate *value, struct mip_builder *builder) {
    return mip_encode(&mip_displacement_output_rate_codec, value, builder);
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_displacement_output_rate *
mip_displacement_output_rate_read(struct mip_displacement_output_rate *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/**
 * Displacement Output Data Rate response: response (0x11,0x82).
 *
 * No device is known for certain to support it. Also called `displacement_output_rate_response`.
 * Response to mip_displacement_output_rate. Known only from the MicroStrain Communication Library.
 *
 * - mscl: Displacement Output Data Rate (0x11,0x02)
 */
struct mip_displacement_output_rate_response {
    /** Rate of displacement data. Unit: Hz. */
    uint32_t rate;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_DISPLACEMENT_OUTPUT_RATE_RESPONSE 0x1182
/** Its descriptor. */
#define MIP_DISPLACEMENT_OUTPUT_RATE_RESPONSE_DESCRIPTOR 0x82
/** Its name in the specification. */
#define MIP_DISPLACEMENT_OUTPUT_RATE_RESPONSE_NAME "displacement.output_rate_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_displacement_output_rate_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_displacement_output_rate_response_decode(
    struct mip_displacement_output_rate_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_displacement_output_rate_response_codec, 0x82, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_displacement_output_rate_response_encode(
    const struct mip_displacement_output_rate_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_displacement_output_rate_response_codec, value, builder);
}

/**
 * Displacement Device Time: command (0x11,0x04).
 *
 * Sets the clock of the device, from which mip_displacement_data_timestamp is taken.
 *
 * No device is known for certain to support it. Also called `displacement_device_time`. Functions:
 * write. Changes mip_displacement_data_timestamp. Known only from the MicroStrain Communication
 * Library. Uncertain: Whether the time can be read. MSCL only writes it.
 *
 * - mscl: Displacement Device Time (0x11,0x04)
 */
struct mip_displacement_device_time {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** UTC since 1970-01-01, without leap seconds. Unit: ns. */
    uint64_t time;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_DISPLACEMENT_DEVICE_TIME 0x1104
/** Its descriptor. */
#define MIP_DISPLACEMENT_DEVICE_TIME_DESCRIPTOR 0x04
/** Its name in the specification. */
#define MIP_DISPLACEMENT_DEVICE_TIME_NAME "displacement.device_time"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_displacement_device_time_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_displacement_device_time_decode(
    struct mip_displacement_device_time *value, const struct mip_field *field) {
    return mip_decode_only(&mip_displacement_device_time_codec, 0x04, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_displacement_device_time_encode(
    const struct mip_displacement_device_time *value, struct mip_builder *builder) {
    return mip_encode(&mip_displacement_device_time_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - time: UTC since 1970-01-01, without leap seconds. Unit: ns.
 */
static inline struct mip_displacement_device_time *
mip_displacement_device_time_write(struct mip_displacement_device_time *command, uint64_t time) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->time = time;
    return command;
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
