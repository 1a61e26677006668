/**
 * @file
 *
 * RTK commands (0x0F). Commands of a corrections modem (RTK dongle), such as the 3DM-RTK.
 * Uncertain: The SDK describes hardly any of this set; most descriptions are inferred from the
 * names. Uncertain: How the strings are padded or terminated.
 *
 * Devices that only probably support a field are listed in mip/profiles.h, not here.
 */
#ifndef MIP_RTK_H
#define MIP_RTK_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/rtk.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_rtk RTK commands (0x0F)
 * @{ */

/** Descriptor set of these fields. */
#define MIP_RTK_SET 0x0F

/**
 * Type of device connected to a corrections modem.
 *
 * - mip-sdk-4: Connected Device Type (0x0F,0x06)
 */
enum mip_rtk_connected_device MIP_ENUM_8 {
    /** Any device. */
    MIP_RTK_CONNECTED_DEVICE_GENERIC = 0,
    /** 3DM-GQ7. */
    MIP_RTK_CONNECTED_DEVICE_GQ7 = 1
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_rtk_connected_device_name(uint8_t value);

/**
 * State of the correction service.
 *
 * - mip-sdk-4: Service Status (0x0F,0x0A)
 */
typedef uint8_t mip_rtk_service_flags;
/** Bit 0. The server limits the rate. */
#define MIP_RTK_SERVICE_FLAGS_THROTTLE 0x01U
/** Bit 1. There are no corrections. */
#define MIP_RTK_SERVICE_FLAGS_CORRECTIONS_UNAVAILABLE 0x02U

/**
 * A storage medium of a corrections modem.
 *
 * - mip-sdk-4: Prod Erase Storage (0x0F,0x20)
 */
enum mip_rtk_storage_medium MIP_ENUM_8 {
    /** External flash memory. */
    MIP_RTK_STORAGE_MEDIUM_EXTERNAL_FLASH = 0,
    /** SD card. */
    MIP_RTK_STORAGE_MEDIUM_SD = 1
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_rtk_storage_medium_name(uint8_t value);

/**
 * Pattern of an LED.
 *
 * - mip-sdk-4: Led Control (0x0F,0x21)
 */
enum mip_rtk_led_action MIP_ENUM_8 {
    /** No pattern. */
    MIP_RTK_LED_ACTION_NONE = 0,
    /** Flashing. */
    MIP_RTK_LED_ACTION_FLASH = 1,
    /** Pulsating. */
    MIP_RTK_LED_ACTION_PULSATE = 2
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_rtk_led_action_name(uint8_t value);

/**
 * Get status flags: command (0x0F,0x01).
 *
 * Gets the state of the modem and of the corrections.
 *
 * No device is known for certain to support it. Response: mip_rtk_get_status_flags_response. Known
 * only from the MicroStrain MIP SDK.
 *
 * The status word in the response has two forms, mip_rtk_status_flags and
 * mip_rtk_status_flags_legacy.
 *
 * - mip-sdk-4: Get status flags (0x0F,0x01)
 */
struct mip_rtk_get_status_flags {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_RTK_GET_STATUS_FLAGS 0x0F01
/** Its descriptor. */
#define MIP_RTK_GET_STATUS_FLAGS_DESCRIPTOR 0x01
/** Its name in the specification. */
#define MIP_RTK_GET_STATUS_FLAGS_NAME "rtk.get_status_flags"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_rtk_get_status_flags_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_rtk_get_status_flags_decode(struct mip_rtk_get_status_flags *value,
                                                        const struct mip_field *field) {
    return mip_decode_only(&mip_rtk_get_status_flags_codec, 0x01, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_rtk_get_status_flags_encode(
    const struct mip_rtk_get_status_flags *value, struct mip_builder *builder) {
    return mip_encode(&mip_rtk_get_status_flags_codec, value, builder);
}

/**
 * Get status flags response: response (0x0F,0x81).
 *
 * No device is known for certain to support it. Response to mip_rtk_get_status_flags. Known only
 * from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get status flags (0x0F,0x01)
 */
struct mip_rtk_get_status_flags_response {
    /** State of the modem and of the corrections. */
    mip_rtk_status_flags flags;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_RTK_GET_STATUS_FLAGS_RESPONSE 0x0F81
/** Its descriptor. */
#define MIP_RTK_GET_STATUS_FLAGS_RESPONSE_DESCRIPTOR 0x81
/** Its name in the specification. */
#define MIP_RTK_GET_STATUS_FLAGS_RESPONSE_NAME "rtk.get_status_flags_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_rtk_get_status_flags_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_rtk_get_status_flags_response_decode(
    struct mip_rtk_get_status_flags_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_rtk_get_status_flags_response_codec, 0x81, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_rtk_get_status_flags_response_encode(
    const struct mip_rtk_get_status_flags_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_rtk_get_status_flags_response_codec, value, builder);
}

/**
 * Get IMEI: command (0x0F,0x02).
 *
 * Gets the identity of the modem.
 *
 * Response: mip_rtk_get_imei_response. Not listed in any device profile. Known only from the
 * MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get IMEI (0x0F,0x02)
 */
struct mip_rtk_get_imei {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_RTK_GET_IMEI 0x0F02
/** Its descriptor. */
#define MIP_RTK_GET_IMEI_DESCRIPTOR 0x02
/** Its name in the specification. */
#define MIP_RTK_GET_IMEI_NAME "rtk.get_imei"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_rtk_get_imei_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_rtk_get_imei_decode(struct mip_rtk_get_imei *value,
                                                const struct mip_field *field) {
    return mip_decode_only(&mip_rtk_get_imei_codec, 0x02, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_rtk_get_imei_encode(const struct mip_rtk_get_imei *value,
                                                            struct mip_builder *builder) {
    return mip_encode(&mip_rtk_get_imei_codec, value, builder);
}

/**
 * Get IMEI response: response (0x0F,0x82).
 *
 * Response to mip_rtk_get_imei. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get IMEI (0x0F,0x02)
 */
struct mip_rtk_get_imei_response {
    /** International mobile equipment identity. */
    char imei[33];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_RTK_GET_IMEI_RESPONSE 0x0F82
/** Its descriptor. */
#define MIP_RTK_GET_IMEI_RESPONSE_DESCRIPTOR 0x82
/** Its name in the specification. */
#define MIP_RTK_GET_IMEI_RESPONSE_NAME "rtk.get_imei_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_rtk_get_imei_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_rtk_get_imei_response_decode(struct mip_rtk_get_imei_response *value,
                                                         const struct mip_field *field) {
    return mip_decode_only(&mip_rtk_get_imei_response_codec, 0x82, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_rtk_get_imei_response_encode(
    const struct mip_rtk_get_imei_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_rtk_get_imei_response_codec, value, builder);
}

/**
 * Get IMSI: command (0x0F,0x03).
 *
 * Gets the identity of the subscriber.
 *
 * Response: mip_rtk_get_imsi_response. Not listed in any device profile. Known only from the
 * MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get IMSI (0x0F,0x03)
 */
struct mip_rtk_get_imsi {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_RTK_GET_IMSI 0x0F03
/** Its descriptor. */
#define MIP_RTK_GET_IMSI_DESCRIPTOR 0x03
/** Its name in the specification. */
#define MIP_RTK_GET_IMSI_NAME "rtk.get_imsi"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_rtk_get_imsi_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_rtk_get_imsi_decode(struct mip_rtk_get_imsi *value,
                                                const struct mip_field *field) {
    return mip_decode_only(&mip_rtk_get_imsi_codec, 0x03, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_rtk_get_imsi_encode(const struct mip_rtk_get_imsi *value,
                                                            struct mip_builder *builder) {
    return mip_encode(&mip_rtk_get_imsi_codec, value, builder);
}

/**
 * Get IMSI response: response (0x0F,0x83).
 *
 * Response to mip_rtk_get_imsi. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get IMSI (0x0F,0x03)
 */
struct mip_rtk_get_imsi_response {
    /** International mobile subscriber identity. */
    char imsi[33];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_RTK_GET_IMSI_RESPONSE 0x0F83
/** Its descriptor. */
#define MIP_RTK_GET_IMSI_RESPONSE_DESCRIPTOR 0x83
/** Its name in the specification. */
#define MIP_RTK_GET_IMSI_RESPONSE_NAME "rtk.get_imsi_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_rtk_get_imsi_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_rtk_get_imsi_response_decode(struct mip_rtk_get_imsi_response *value,
                                                         const struct mip_field *field) {
    return mip_decode_only(&mip_rtk_get_imsi_response_codec, 0x83, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_rtk_get_imsi_response_encode(
    const struct mip_rtk_get_imsi_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_rtk_get_imsi_response_codec, value, builder);
}

/**
 * Get ICCID: command (0x0F,0x04).
 *
 * Gets the number of the SIM card.
 *
 * Response: mip_rtk_get_iccid_response. Not listed in any device profile. Known only from the
 * MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get ICCID (0x0F,0x04)
 */
struct mip_rtk_get_iccid {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_RTK_GET_ICCID 0x0F04
/** Its descriptor. */
#define MIP_RTK_GET_ICCID_DESCRIPTOR 0x04
/** Its name in the specification. */
#define MIP_RTK_GET_ICCID_NAME "rtk.get_iccid"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_rtk_get_iccid_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_rtk_get_iccid_decode(struct mip_rtk_get_iccid *value,
                                                 const struct mip_field *field) {
    return mip_decode_only(&mip_rtk_get_iccid_codec, 0x04, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_rtk_get_iccid_encode(const struct mip_rtk_get_iccid *value,
                                                             struct mip_builder *builder) {
    return mip_encode(&mip_rtk_get_iccid_codec, value, builder);
}

/**
 * Get ICCID response: response (0x0F,0x84).
 *
 * Response to mip_rtk_get_iccid. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get ICCID (0x0F,0x04)
 */
struct mip_rtk_get_iccid_response {
    /** Number of the SIM card. */
    char iccid[33];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_RTK_GET_ICCID_RESPONSE 0x0F84
/** Its descriptor. */
#define MIP_RTK_GET_ICCID_RESPONSE_DESCRIPTOR 0x84
/** Its name in the specification. */
#define MIP_RTK_GET_ICCID_RESPONSE_NAME "rtk.get_iccid_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_rtk_get_iccid_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_rtk_get_iccid_response_decode(struct mip_rtk_get_iccid_response *value,
                                                          const struct mip_field *field) {
    return mip_decode_only(&mip_rtk_get_iccid_response_codec, 0x84, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_rtk_get_iccid_response_encode(
    const struct mip_rtk_get_iccid_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_rtk_get_iccid_response_codec, value, builder);
}

/**
 * Get RSSI: command (0x0F,0x05).
 *
 * Gets the strength of the cellular signal.
 *
 * Response: mip_rtk_get_rssi_response. Not listed in any device profile. Known only from the
 * MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get RSSI (0x0F,0x05)
 */
struct mip_rtk_get_rssi {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_RTK_GET_RSSI 0x0F05
/** Its descriptor. */
#define MIP_RTK_GET_RSSI_DESCRIPTOR 0x05
/** Its name in the specification. */
#define MIP_RTK_GET_RSSI_NAME "rtk.get_rssi"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_rtk_get_rssi_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_rtk_get_rssi_decode(struct mip_rtk_get_rssi *value,
                                                const struct mip_field *field) {
    return mip_decode_only(&mip_rtk_get_rssi_codec, 0x05, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_rtk_get_rssi_encode(const struct mip_rtk_get_rssi *value,
                                                            struct mip_builder *builder) {
    return mip_encode(&mip_rtk_get_rssi_codec, value, builder);
}

/**
 * Get RSSI response: response (0x0F,0x85).
 *
 * Response to mip_rtk_get_rssi. Known only from the MicroStrain MIP SDK. Uncertain: That `valid`
 * applies to the other values is inferred.
 *
 * - mip-sdk-4: Get RSSI (0x0F,0x05)
 */
struct mip_rtk_get_rssi_response {
    /** True if the modem is connected. */
    mip_bool valid;
    /** Received signal strength. Valid if valid is true. Uncertain: The unit; dBm is likely. */
    int32_t rssi;
    /** Quality of the modem's radio signal. Valid if valid is true. Uncertain: The unit. */
    int32_t signal_quality;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_RTK_GET_RSSI_RESPONSE 0x0F85
/** Its descriptor. */
#define MIP_RTK_GET_RSSI_RESPONSE_DESCRIPTOR 0x85
/** Its name in the specification. */
#define MIP_RTK_GET_RSSI_RESPONSE_NAME "rtk.get_rssi_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_rtk_get_rssi_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_rtk_get_rssi_response_decode(struct mip_rtk_get_rssi_response *value,
                                                         const struct mip_field *field) {
    return mip_decode_only(&mip_rtk_get_rssi_response_codec, 0x85, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_rtk_get_rssi_response_encode(
    const struct mip_rtk_get_rssi_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_rtk_get_rssi_response_codec, value, builder);
}

/**
 * Connected device type: command (0x0F,0x06).
 *
 * Sets the type of device that the modem is connected to.
 *
 * Functions: write, read, save, load and default. Response: mip_rtk_connected_device_type_response.
 * Not listed in any device profile. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Connected device type (0x0F,0x06)
 */
struct mip_rtk_connected_device_type {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Type of device that the modem is connected to. A value of enum mip_rtk_connected_device.
     * Required for write.
     */
    uint8_t device_type;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_RTK_CONNECTED_DEVICE_TYPE 0x0F06
/** Its descriptor. */
#define MIP_RTK_CONNECTED_DEVICE_TYPE_DESCRIPTOR 0x06
/** Its name in the specification. */
#define MIP_RTK_CONNECTED_DEVICE_TYPE_NAME "rtk.connected_device_type"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_rtk_connected_device_type_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_rtk_connected_device_type_decode(
    struct mip_rtk_connected_device_type *value, const struct mip_field *field) {
    return mip_decode_only(&mip_rtk_connected_device_type_codec, 0x06, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_rtk_connected_device_type_encode(
    const struct mip_rtk_connected_device_type *value, struct mip_builder *builder) {
    return mip_encode(&mip_rtk_connected_device_type_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - device_type: Type of device that the modem is connected to. A value of enum
 *   mip_rtk_connected_device. Required for write.
 */
static inline struct mip_rtk_connected_device_type *mip_rtk_connected_device_type_write(
    struct mip_rtk_connected_device_type *command, enum mip_rtk_connected_device device_type) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->device_type = (uint8_t)device_type;
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_rtk_connected_device_type *
mip_rtk_connected_device_type_read(struct mip_rtk_connected_device_type *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_rtk_connected_device_type *
mip_rtk_connected_device_type_save(struct mip_rtk_connected_device_type *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_rtk_connected_device_type *
mip_rtk_connected_device_type_load(struct mip_rtk_connected_device_type *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_rtk_connected_device_type *
mip_rtk_connected_device_type_default(struct mip_rtk_connected_device_type *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * Connected device type response: response (0x0F,0x86).
 *
 * Response to mip_rtk_connected_device_type. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Connected device type (0x0F,0x06)
 */
struct mip_rtk_connected_device_type_response {
    /** Type of device that the modem is connected to. A value of enum mip_rtk_connected_device. */
    uint8_t device_type;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_RTK_CONNECTED_DEVICE_TYPE_RESPONSE 0x0F86
/** Its descriptor. */
#define MIP_RTK_CONNECTED_DEVICE_TYPE_RESPONSE_DESCRIPTOR 0x86
/** Its name in the specification. */
#define MIP_RTK_CONNECTED_DEVICE_TYPE_RESPONSE_NAME "rtk.connected_device_type_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_rtk_connected_device_type_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_rtk_connected_device_type_response_decode(
    struct mip_rtk_connected_device_type_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_rtk_connected_device_type_response_codec, 0x86, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_rtk_connected_device_type_response_encode(
    const struct mip_rtk_connected_device_type_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_rtk_connected_device_type_response_codec, value, builder);
}

/**
 * Get activation code: command (0x0F,0x07).
 *
 * Reads the code that activates the modem for its service.
 *
 * No device is known for certain to support it. Also called `get_act_code`. Response:
 * mip_rtk_get_activation_code_response. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get Act Code (0x0F,0x07)
 */
struct mip_rtk_get_activation_code {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_RTK_GET_ACTIVATION_CODE 0x0F07
/** Its descriptor. */
#define MIP_RTK_GET_ACTIVATION_CODE_DESCRIPTOR 0x07
/** Its name in the specification. */
#define MIP_RTK_GET_ACTIVATION_CODE_NAME "rtk.get_activation_code"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_rtk_get_activation_code_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_rtk_get_activation_code_decode(
    struct mip_rtk_get_activation_code *value, const struct mip_field *field) {
    return mip_decode_only(&mip_rtk_get_activation_code_codec, 0x07, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_rtk_get_activation_code_encode(
    const struct mip_rtk_get_activation_code *value, struct mip_builder *builder) {
    return mip_encode(&mip_rtk_get_activation_code_codec, value, builder);
}

/**
 * Get activation code response: response (0x0F,0x87).
 *
 * No device is known for certain to support it. Also called `get_act_code_response`. Response to
 * mip_rtk_get_activation_code. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get Act Code (0x0F,0x07)
 */
struct mip_rtk_get_activation_code_response {
    /** Code that activates the modem for its service. */
    char activation_code[33];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_RTK_GET_ACTIVATION_CODE_RESPONSE 0x0F87
/** Its descriptor. */
#define MIP_RTK_GET_ACTIVATION_CODE_RESPONSE_DESCRIPTOR 0x87
/** Its name in the specification. */
#define MIP_RTK_GET_ACTIVATION_CODE_RESPONSE_NAME "rtk.get_activation_code_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_rtk_get_activation_code_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_rtk_get_activation_code_response_decode(
    struct mip_rtk_get_activation_code_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_rtk_get_activation_code_response_codec, 0x87, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_rtk_get_activation_code_response_encode(
    const struct mip_rtk_get_activation_code_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_rtk_get_activation_code_response_codec, value, builder);
}

/**
 * Get modem firmware version: command (0x0F,0x08).
 *
 * Gets the firmware version of the cellular modem.
 *
 * Response: mip_rtk_get_modem_firmware_version_response. Not listed in any device profile. Known
 * only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get modem firmware version (0x0F,0x08)
 */
struct mip_rtk_get_modem_firmware_version {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_RTK_GET_MODEM_FIRMWARE_VERSION 0x0F08
/** Its descriptor. */
#define MIP_RTK_GET_MODEM_FIRMWARE_VERSION_DESCRIPTOR 0x08
/** Its name in the specification. */
#define MIP_RTK_GET_MODEM_FIRMWARE_VERSION_NAME "rtk.get_modem_firmware_version"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_rtk_get_modem_firmware_version_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_rtk_get_modem_firmware_version_decode(
    struct mip_rtk_get_modem_firmware_version *value, const struct mip_field *field) {
    return mip_decode_only(&mip_rtk_get_modem_firmware_version_codec, 0x08, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_rtk_get_modem_firmware_version_encode(
    const struct mip_rtk_get_modem_firmware_version *value, struct mip_builder *builder) {
    return mip_encode(&mip_rtk_get_modem_firmware_version_codec, value, builder);
}

/**
 * Get modem firmware version response: response (0x0F,0x88).
 *
 * Response to mip_rtk_get_modem_firmware_version. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get modem firmware version (0x0F,0x08)
 */
struct mip_rtk_get_modem_firmware_version_response {
    /** Firmware version of the modem, not of the dongle. */
    char modem_firmware_version[33];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_RTK_GET_MODEM_FIRMWARE_VERSION_RESPONSE 0x0F88
/** Its descriptor. */
#define MIP_RTK_GET_MODEM_FIRMWARE_VERSION_RESPONSE_DESCRIPTOR 0x88
/** Its name in the specification. */
#define MIP_RTK_GET_MODEM_FIRMWARE_VERSION_RESPONSE_NAME "rtk.get_modem_firmware_version_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_rtk_get_modem_firmware_version_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_rtk_get_modem_firmware_version_response_decode(
    struct mip_rtk_get_modem_firmware_version_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_rtk_get_modem_firmware_version_response_codec, 0x88, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_rtk_get_modem_firmware_version_response_encode(
    const struct mip_rtk_get_modem_firmware_version_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_rtk_get_modem_firmware_version_response_codec, value, builder);
}

/**
 * Service status: command (0x0F,0x0A).
 *
 * Queries a correction server about the connection, which also keeps it open.
 *
 * Response: mip_rtk_service_status_response. Sent by the device; the host replies. Not listed in
 * any device profile. Known only from the MicroStrain MIP SDK.
 *
 * The modem acts as the host and the server as the device.
 *
 * - mip-sdk-4: Service status (0x0F,0x0A)
 */
struct mip_rtk_service_status {
    /** Reserved: send 0. Uncertain: What the modem sends; 0 is assumed. */
    uint32_t reserved1;
    /** Reserved: send 0. Uncertain: What the modem sends; 0 is assumed. */
    uint32_t reserved2;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_RTK_SERVICE_STATUS 0x0F0A
/** Its descriptor. */
#define MIP_RTK_SERVICE_STATUS_DESCRIPTOR 0x0A
/** Its name in the specification. */
#define MIP_RTK_SERVICE_STATUS_NAME "rtk.service_status"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_rtk_service_status_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_rtk_service_status_decode(struct mip_rtk_service_status *value,
                                                      const struct mip_field *field) {
    return mip_decode_only(&mip_rtk_service_status_codec, 0x0A, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_rtk_service_status_encode(
    const struct mip_rtk_service_status *value, struct mip_builder *builder) {
    return mip_encode(&mip_rtk_service_status_codec, value, builder);
}

/**
 * Service status response: response (0x0F,0x8A).
 *
 * Connection status according to the server.
 *
 * Response to mip_rtk_service_status. Known only from the MicroStrain MIP SDK. Uncertain: What the
 * counters count.
 *
 * - mip-sdk-4: Service status (0x0F,0x0A)
 */
struct mip_rtk_service_status_response {
    /** State of the service. */
    mip_rtk_service_flags flags;
    /** Number of correction bytes that the service has sent. Unit: byte. */
    uint32_t received_bytes;
    /** Number of bytes in the last transfer. Unit: byte. */
    uint32_t last_bytes;
    /** Time of the last transfer. Uncertain: The unit and the epoch. */
    uint64_t last_bytes_time;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_RTK_SERVICE_STATUS_RESPONSE 0x0F8A
/** Its descriptor. */
#define MIP_RTK_SERVICE_STATUS_RESPONSE_DESCRIPTOR 0x8A
/** Its name in the specification. */
#define MIP_RTK_SERVICE_STATUS_RESPONSE_NAME "rtk.service_status_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_rtk_service_status_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_rtk_service_status_response_decode(
    struct mip_rtk_service_status_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_rtk_service_status_response_codec, 0x8A, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_rtk_service_status_response_encode(
    const struct mip_rtk_service_status_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_rtk_service_status_response_codec, value, builder);
}

/**
 * Erase storage: command (0x0F,0x20).
 *
 * Returns a storage medium to its raw state. Everything on it is erased.
 *
 * For advanced use. Also called `prod_erase_storage`. Not listed in any device profile. Known only
 * from the MicroStrain MIP SDK.
 *
 * All stored data is lost. The command is for production.
 *
 * Accepted in calibration mode only.
 *
 * - mip-sdk-4: Prod Erase Storage (0x0F,0x20)
 */
struct mip_rtk_erase_storage {
    /** The medium. A value of enum mip_rtk_storage_medium. */
    uint8_t media;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_RTK_ERASE_STORAGE 0x0F20
/** Its descriptor. */
#define MIP_RTK_ERASE_STORAGE_DESCRIPTOR 0x20
/** Its name in the specification. */
#define MIP_RTK_ERASE_STORAGE_NAME "rtk.erase_storage"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_rtk_erase_storage_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_rtk_erase_storage_decode(struct mip_rtk_erase_storage *value,
                                                     const struct mip_field *field) {
    return mip_decode_only(&mip_rtk_erase_storage_codec, 0x20, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_rtk_erase_storage_encode(
    const struct mip_rtk_erase_storage *value, struct mip_builder *builder) {
    return mip_encode(&mip_rtk_erase_storage_codec, value, builder);
}

/**
 * Erase storage. Fills the structure and returns its address.
 *
 * - media: The medium. A value of enum mip_rtk_storage_medium.
 */
static inline struct mip_rtk_erase_storage *mip_rtk_erase_storage_make(
    struct mip_rtk_erase_storage *command, enum mip_rtk_storage_medium media) {
    memset(command, 0, sizeof(*command));
    command->media = (uint8_t)media;
    return command;
}

/**
 * LED control: command (0x0F,0x21).
 *
 * Sets the colours and the pattern of the LED.
 *
 * For advanced use. Not listed in any device profile. Known only from the MicroStrain MIP SDK.
 *
 * Accepted in calibration mode and production test mode only.
 *
 * - mip-sdk-4: LED control (0x0F,0x21)
 */
struct mip_rtk_led_control {
    /** First colour. Uncertain: The order of its parts; red, green, blue is likely. */
    uint8_t primary_color[3];
    /** Second colour. Uncertain: The order of its parts; red, green, blue is likely. */
    uint8_t alternate_color[3];
    /** Pattern. A value of enum mip_rtk_led_action. */
    uint8_t action;
    /** Period of the pattern. Uncertain: The unit; ms is likely. */
    uint32_t period;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_RTK_LED_CONTROL 0x0F21
/** Its descriptor. */
#define MIP_RTK_LED_CONTROL_DESCRIPTOR 0x21
/** Its name in the specification. */
#define MIP_RTK_LED_CONTROL_NAME "rtk.led_control"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_rtk_led_control_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_rtk_led_control_decode(struct mip_rtk_led_control *value,
                                                   const struct mip_field *field) {
    return mip_decode_only(&mip_rtk_led_control_codec, 0x21, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error
mip_rtk_led_control_encode(const struct mip_rtk_led_control *value, struct mip_builder *builder) {
    return mip_encode(&mip_rtk_led_control_codec, value, builder);
}

/**
 * LED control. Fills the structure and returns its address.
 *
 * - primary_color: First colour. Uncertain: The order of its parts; red, green, blue is likely.
 * - alternate_color: Second colour. Uncertain: The order of its parts; red, green, blue is likely.
 * - action: Pattern. A value of enum mip_rtk_led_action.
 * - period: Period of the pattern. Uncertain: The unit; ms is likely.
 */
static inline struct mip_rtk_led_control *mip_rtk_led_control_make(
    struct mip_rtk_led_control *command, const uint8_t primary_color[3],
    const uint8_t alternate_color[3], enum mip_rtk_led_action action, uint32_t period) {
    memset(command, 0, sizeof(*command));
    memcpy(command->primary_color, primary_color, sizeof(command->primary_color));
    memcpy(command->alternate_color, alternate_color, sizeof(command->alternate_color));
    command->action = (uint8_t)action;
    command->period = period;
    return command;
}

/**
 * Modem hard reset: command (0x0F,0x22).
 *
 * Clears the flash memory of the modem.
 *
 * For advanced use. Not listed in any device profile. Known only from the MicroStrain MIP SDK.
 *
 * It wears out the flash memory; use it rarely.
 *
 * Accepted in calibration mode only.
 *
 * - mip-sdk-4: Modem hard reset (0x0F,0x22)
 */
struct mip_rtk_modem_hard_reset {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_RTK_MODEM_HARD_RESET 0x0F22
/** Its descriptor. */
#define MIP_RTK_MODEM_HARD_RESET_DESCRIPTOR 0x22
/** Its name in the specification. */
#define MIP_RTK_MODEM_HARD_RESET_NAME "rtk.modem_hard_reset"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_rtk_modem_hard_reset_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_rtk_modem_hard_reset_decode(struct mip_rtk_modem_hard_reset *value,
                                                        const struct mip_field *field) {
    return mip_decode_only(&mip_rtk_modem_hard_reset_codec, 0x22, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_rtk_modem_hard_reset_encode(
    const struct mip_rtk_modem_hard_reset *value, struct mip_builder *builder) {
    return mip_encode(&mip_rtk_modem_hard_reset_codec, value, builder);
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
