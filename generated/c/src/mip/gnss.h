/**
 * @file
 *
 * GNSS commands (0x0E). Commands that describe and set up the internal GNSS receivers.
 *
 * Devices that only probably support a field are listed in mip/profiles.h, not here.
 */
#ifndef MIP_GNSS_H
#define MIP_GNSS_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/gnss.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_gnss GNSS commands (0x0E)
 * @{ */

/** Descriptor set of these fields. */
#define MIP_GNSS_SET 0x0E

/**
 * Description of a GNSS receiver.
 *
 * - 3dm-cv7-gnss-ins: Info
 * - mip-sdk-4: Receiver Info (0x0E,0x01)
 */
struct mip_gnss_receiver_info_entry {
    /**
     * Receiver, numbered as in `receiver_id`: 1 and 2 are internal, 4 and 5 external. Range: at
     * least 1.
     */
    uint8_t receiver_id;
    /** Descriptor set of this receiver's data. Range: 0x80 to 0xFE. */
    uint8_t mip_data_descriptor_set;
    /** Module name or model and firmware version, separated by a comma. */
    char description[33];
};

/** GPS signals that are enabled. */
typedef uint8_t mip_gnss_gps_signals;
/** Bit 0. L1 C/A. */
#define MIP_GNSS_GPS_SIGNALS_L1CA 0x01U
/** Bit 1. */
#define MIP_GNSS_GPS_SIGNALS_L2C 0x02U
/** Bit 2. */
#define MIP_GNSS_GPS_SIGNALS_L5 0x04U

/** GLONASS signals that are enabled. */
typedef uint8_t mip_gnss_glonass_signals;
/** Bit 0. */
#define MIP_GNSS_GLONASS_SIGNALS_L1OF 0x01U
/** Bit 1. */
#define MIP_GNSS_GLONASS_SIGNALS_L2OF 0x02U

/** Galileo signals that are enabled. */
typedef uint8_t mip_gnss_galileo_signals;
/** Bit 0. */
#define MIP_GNSS_GALILEO_SIGNALS_E1 0x01U
/** Bit 1. */
#define MIP_GNSS_GALILEO_SIGNALS_E5B 0x02U
/** Bit 2. */
#define MIP_GNSS_GALILEO_SIGNALS_E5A 0x04U

/** BeiDou signals that are enabled. */
typedef uint8_t mip_gnss_beidou_signals;
/** Bit 0. */
#define MIP_GNSS_BEIDOU_SIGNALS_B1 0x01U
/** Bit 1. */
#define MIP_GNSS_BEIDOU_SIGNALS_B2 0x02U
/** Bit 2. */
#define MIP_GNSS_BEIDOU_SIGNALS_B2A 0x04U

/**
 * A GNSS receiver.
 *
 * - mip-sdk-4: Receiver Reset (0x0E,0x03)
 */
enum mip_gnss_receiver_id MIP_ENUM_8 {
    /** Every receiver; only for commands that accept it. */
    MIP_GNSS_RECEIVER_ID_ALL = 0,
    /** The first receiver inside the device. */
    MIP_GNSS_RECEIVER_ID_INTERNAL_RECEIVER_1 = 1,
    /** The second receiver inside the device. */
    MIP_GNSS_RECEIVER_ID_INTERNAL_RECEIVER_2 = 2,
    /** The first external receiver. */
    MIP_GNSS_RECEIVER_ID_USER_RECEIVER_1 = 4,
    /** The second external receiver. */
    MIP_GNSS_RECEIVER_ID_USER_RECEIVER_2 = 5
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_gnss_receiver_id_name(uint8_t value);

/**
 * Extent of a receiver restart.
 *
 * - mip-sdk-4: Receiver Reset (0x0E,0x03)
 */
enum mip_gnss_receiver_reset_type MIP_ENUM_8 {
    /** Resets the hardware of the receiver. */
    MIP_GNSS_RECEIVER_RESET_TYPE_HARDWARE = 1,
    /** Restarts all software of the receiver. */
    MIP_GNSS_RECEIVER_RESET_TYPE_COLD = 2,
    /**
     * Restarts the positioning engine only. Uncertain: The name. An earlier branch of the SDK calls
     * 3 hot and 4 warm, with the same descriptions of the two numbers; GNSS receivers usually keep
     * their satellite data in a hot start and lose it in a warm one.
     */
    MIP_GNSS_RECEIVER_RESET_TYPE_WARM = 3,
    /**
     * Restarts the positioning engine and clears its ephemerides and almanacs. Uncertain: The name,
     * which an earlier branch of the SDK swaps with that of 3.
     */
    MIP_GNSS_RECEIVER_RESET_TYPE_HOT = 4
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_gnss_receiver_reset_type_name(uint8_t value);

/**
 * Strategy for fixing the RTK carrier phase ambiguities to whole numbers. Uncertain: The
 * descriptions of `conservative` and `moderate`, which are inferred from the names.
 *
 * - mip-sdk-4: Rtk Configuration (0x0E,0x04)
 */
enum mip_gnss_ambiguity_fix_mode MIP_ENUM_8 {
    /** Never fixes them. The solution remains a float solution. */
    MIP_GNSS_AMBIGUITY_FIX_MODE_OFF = 1,
    /** Fixes them late, so that few fixes are wrong. */
    MIP_GNSS_AMBIGUITY_FIX_MODE_CONSERVATIVE = 2,
    /** Between conservative and aggressive. */
    MIP_GNSS_AMBIGUITY_FIX_MODE_MODERATE = 3,
    /** Fixes them as soon as possible. */
    MIP_GNSS_AMBIGUITY_FIX_MODE_AGGRESSIVE = 4
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_gnss_ambiguity_fix_mode_name(uint8_t value);

/** Channel that delivers SPARTN corrections. */
enum mip_gnss_spartn_connection MIP_ENUM_8 {
    /** No connection. */
    MIP_GNSS_SPARTN_CONNECTION_NONE = 0,
    /** Over a network. */
    MIP_GNSS_SPARTN_CONNECTION_NETWORK = 1,
    /** By satellite in the L band. */
    MIP_GNSS_SPARTN_CONNECTION_L_BAND = 2
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_gnss_spartn_connection_name(uint8_t value);

/**
 * Receiver info: command (0x0E,0x01).
 *
 * Gets the GNSS receivers of the device.
 *
 * Response: mip_gnss_receiver_info_response. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Receiver Info (0x0E,0x01)
 */
struct mip_gnss_receiver_info {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_GNSS_RECEIVER_INFO 0x0E01
/** Its descriptor. */
#define MIP_GNSS_RECEIVER_INFO_DESCRIPTOR 0x01
/** Its name in the specification. */
#define MIP_GNSS_RECEIVER_INFO_NAME "gnss.receiver_info"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_gnss_receiver_info_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_gnss_receiver_info_decode(struct mip_gnss_receiver_info *value,
                                                      const struct mip_field *field) {
    return mip_decode_only(&mip_gnss_receiver_info_codec, 0x01, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_gnss_receiver_info_encode(
    const struct mip_gnss_receiver_info *value, struct mip_builder *builder) {
    return mip_encode(&mip_gnss_receiver_info_codec, value, builder);
}

/**
 * Receiver info response: response (0x0E,0x81).
 *
 * Response to mip_gnss_receiver_info. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Receiver Info (0x0E,0x01)
 */
struct mip_gnss_receiver_info_response {
    /** Number of physical receivers. Counts the elements of receiver_info. */
    uint8_t num_receivers;
    /** One entry for each receiver. */
    struct mip_gnss_receiver_info_entry receiver_info[7];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_GNSS_RECEIVER_INFO_RESPONSE 0x0E81
/** Its descriptor. */
#define MIP_GNSS_RECEIVER_INFO_RESPONSE_DESCRIPTOR 0x81
/** Its name in the specification. */
#define MIP_GNSS_RECEIVER_INFO_RESPONSE_NAME "gnss.receiver_info_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_gnss_receiver_info_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_gnss_receiver_info_response_decode(
    struct mip_gnss_receiver_info_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_gnss_receiver_info_response_codec, 0x81, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_gnss_receiver_info_response_encode(
    const struct mip_gnss_receiver_info_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_gnss_receiver_info_response_codec, value, builder);
}

/**
 * Signal configuration: command (0x0E,0x02).
 *
 * Selects the GNSS signals that the device uses.
 *
 * Also called `signal_configuration`. Functions: write, read, save, load and default. Response:
 * mip_gnss_signal_config_response. Probably changes mip_gnss_data_fix_info,
 * mip_gnss_data_satellite_status and mip_gnss_data_raw. Supported by 3DM-CV7-GNSS/INS. On the
 * 3DM-GQ7-GNSS/INS: firmware > 1.0.10.
 *
 * A device accepts only certain combinations.
 *
 * The 3DM-CV7-GNSS/INS needs GPS or Galileo, and rejects GPS L1 with BeiDou L1 alone. For GPS and
 * BeiDou it accepts none, L1, or L1 and L5; for Galileo none, or L1 and L5; for GLONASS none or L1.
 *
 * - 3dm-cv7-gnss-ins: Signal Configuration (0x0E,0x02)
 * - 3dm-cv7-gnss-ins: GNSS
 */
struct mip_gnss_signal_config {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** GPS signals. Required for write. */
    mip_gnss_gps_signals gps_enable;
    /** GLONASS signals. Required for write. */
    mip_gnss_glonass_signals glonass_enable;
    /** Galileo signals. Required for write. */
    mip_gnss_galileo_signals galileo_enable;
    /** BeiDou signals. Required for write. */
    mip_gnss_beidou_signals beidou_enable;
    /** Reserved: send 0. Required for write. */
    uint8_t reserved[4];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_GNSS_SIGNAL_CONFIG 0x0E02
/** Its descriptor. */
#define MIP_GNSS_SIGNAL_CONFIG_DESCRIPTOR 0x02
/** Its name in the specification. */
#define MIP_GNSS_SIGNAL_CONFIG_NAME "gnss.signal_config"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_gnss_signal_config_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_gnss_signal_config_decode(struct mip_gnss_signal_config *value,
                                                      const struct mip_field *field) {
    return mip_decode_only(&mip_gnss_signal_config_codec, 0x02, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_gnss_signal_config_encode(
    const struct mip_gnss_signal_config *value, struct mip_builder *builder) {
    return mip_encode(&mip_gnss_signal_config_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - gps_enable: GPS signals. Required for write.
 * - glonass_enable: GLONASS signals. Required for write.
 * - galileo_enable: Galileo signals. Required for write.
 * - beidou_enable: BeiDou signals. Required for write.
 */
static inline struct mip_gnss_signal_config *mip_gnss_signal_config_write(
    struct mip_gnss_signal_config *command, mip_gnss_gps_signals gps_enable,
    mip_gnss_glonass_signals glonass_enable, mip_gnss_galileo_signals galileo_enable,
    mip_gnss_beidou_signals beidou_enable) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->gps_enable = gps_enable;
    command->glonass_enable = glonass_enable;
    command->galileo_enable = galileo_enable;
    command->beidou_enable = beidou_enable;
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_gnss_signal_config *
mip_gnss_signal_config_read(struct mip_gnss_signal_config *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_gnss_signal_config *
mip_gnss_signal_config_save(struct mip_gnss_signal_config *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_gnss_signal_config *
mip_gnss_signal_config_load(struct mip_gnss_signal_config *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_gnss_signal_config *
mip_gnss_signal_config_default(struct mip_gnss_signal_config *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * Signal configuration response: response (0x0E,0x82).
 *
 * Also called `signal_configuration_response`. Response to mip_gnss_signal_config. Supported by
 * 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Signal Configuration (0x0E,0x02)
 * - 3dm-cv7-gnss-ins: GNSS
 */
struct mip_gnss_signal_config_response {
    /** GPS signals. */
    mip_gnss_gps_signals gps_enable;
    /** GLONASS signals. */
    mip_gnss_glonass_signals glonass_enable;
    /** Galileo signals. */
    mip_gnss_galileo_signals galileo_enable;
    /** BeiDou signals. */
    mip_gnss_beidou_signals beidou_enable;
    /** Reserved. */
    uint8_t reserved[4];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_GNSS_SIGNAL_CONFIG_RESPONSE 0x0E82
/** Its descriptor. */
#define MIP_GNSS_SIGNAL_CONFIG_RESPONSE_DESCRIPTOR 0x82
/** Its name in the specification. */
#define MIP_GNSS_SIGNAL_CONFIG_RESPONSE_NAME "gnss.signal_config_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_gnss_signal_config_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_gnss_signal_config_response_decode(
    struct mip_gnss_signal_config_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_gnss_signal_config_response_codec, 0x82, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_gnss_signal_config_response_encode(
    const struct mip_gnss_signal_config_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_gnss_signal_config_response_codec, value, builder);
}

/**
 * Receiver reset: command (0x0E,0x03).
 *
 * Resets a GNSS receiver of the device.
 *
 * Not listed in any device profile. Known only from the MicroStrain MIP SDK. Uncertain: Which
 * devices support it. The SDK does not name any.
 *
 * Only internal receivers can be reset.
 *
 * Some devices do not support all reset types.
 *
 * - mip-sdk-4: Receiver reset (0x0E,0x03)
 */
struct mip_gnss_receiver_reset {
    /** Receiver to reset. A value of enum mip_gnss_receiver_id. */
    uint8_t receiver_id;
    /** Extent of the restart. A value of enum mip_gnss_receiver_reset_type. */
    uint8_t reset_type;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_GNSS_RECEIVER_RESET 0x0E03
/** Its descriptor. */
#define MIP_GNSS_RECEIVER_RESET_DESCRIPTOR 0x03
/** Its name in the specification. */
#define MIP_GNSS_RECEIVER_RESET_NAME "gnss.receiver_reset"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_gnss_receiver_reset_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_gnss_receiver_reset_decode(struct mip_gnss_receiver_reset *value,
                                                       const struct mip_field *field) {
    return mip_decode_only(&mip_gnss_receiver_reset_codec, 0x03, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_gnss_receiver_reset_encode(
    const struct mip_gnss_receiver_reset *value, struct mip_builder *builder) {
    return mip_encode(&mip_gnss_receiver_reset_codec, value, builder);
}

/**
 * Receiver reset. Fills the structure and returns its address.
 *
 * - receiver_id: Receiver to reset. A value of enum mip_gnss_receiver_id.
 * - reset_type: Extent of the restart. A value of enum mip_gnss_receiver_reset_type.
 */
static inline struct mip_gnss_receiver_reset *mip_gnss_receiver_reset_make(
    struct mip_gnss_receiver_reset *command, enum mip_gnss_receiver_id receiver_id,
    enum mip_gnss_receiver_reset_type reset_type) {
    memset(command, 0, sizeof(*command));
    command->receiver_id = (uint8_t)receiver_id;
    command->reset_type = (uint8_t)reset_type;
    return command;
}

/**
 * RTK configuration: command (0x0E,0x04).
 *
 * Sets how readily the device fixes the ambiguities of an RTK solution.
 *
 * Also called `rtk_configuration`. Functions: write, read, save, load and default. Response:
 * mip_gnss_rtk_config_response. Probably changes mip_gnss_data_fix_info and
 * mip_gnss_data_llh_position. Not listed in any device profile. Known only from the MicroStrain MIP
 * SDK. Uncertain: Which devices support it. Users of the vendor's ROS driver report it as
 * experimental on the 3DM-GQ7, which accepts `conservative` only.
 *
 * The available modes differ by device.
 *
 * - mip-sdk-4: RTK configuration (0x0E,0x04)
 */
struct mip_gnss_rtk_config {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Strategy for fixing ambiguities. A value of enum mip_gnss_ambiguity_fix_mode. Required for
     * write.
     */
    uint8_t ambiguity_fix_mode;
    /** Reserved: send 0. Required for write. */
    uint8_t reserved[4];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_GNSS_RTK_CONFIG 0x0E04
/** Its descriptor. */
#define MIP_GNSS_RTK_CONFIG_DESCRIPTOR 0x04
/** Its name in the specification. */
#define MIP_GNSS_RTK_CONFIG_NAME "gnss.rtk_config"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_gnss_rtk_config_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_gnss_rtk_config_decode(struct mip_gnss_rtk_config *value,
                                                   const struct mip_field *field) {
    return mip_decode_only(&mip_gnss_rtk_config_codec, 0x04, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error
mip_gnss_rtk_config_encode(const struct mip_gnss_rtk_config *value, struct mip_builder *builder) {
    return mip_encode(&mip_gnss_rtk_config_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - ambiguity_fix_mode: Strategy for fixing ambiguities. A value of enum
 *   mip_gnss_ambiguity_fix_mode. Required for write.
 */
static inline struct mip_gnss_rtk_config *mip_gnss_rtk_config_write(
    struct mip_gnss_rtk_config *command, enum mip_gnss_ambiguity_fix_mode ambiguity_fix_mode) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->ambiguity_fix_mode = (uint8_t)ambiguity_fix_mode;
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_gnss_rtk_config *
mip_gnss_rtk_config_read(struct mip_gnss_rtk_config *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_gnss_rtk_config *
mip_gnss_rtk_config_save(struct mip_gnss_rtk_config *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_gnss_rtk_config *
mip_gnss_rtk_config_load(struct mip_gnss_rtk_config *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_gnss_rtk_config *
mip_gnss_rtk_config_default(struct mip_gnss_rtk_config *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * RTK configuration response: response (0x0E,0x84).
 *
 * Also called `rtk_configuration_response`. Response to mip_gnss_rtk_config. Known only from the
 * MicroStrain MIP SDK.
 *
 * - mip-sdk-4: RTK configuration (0x0E,0x04)
 */
struct mip_gnss_rtk_config_response {
    /** Strategy for fixing ambiguities. A value of enum mip_gnss_ambiguity_fix_mode. */
    uint8_t ambiguity_fix_mode;
    /** Reserved. */
    uint8_t reserved[4];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_GNSS_RTK_CONFIG_RESPONSE 0x0E84
/** Its descriptor. */
#define MIP_GNSS_RTK_CONFIG_RESPONSE_DESCRIPTOR 0x84
/** Its name in the specification. */
#define MIP_GNSS_RTK_CONFIG_RESPONSE_NAME "gnss.rtk_config_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_gnss_rtk_config_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_gnss_rtk_config_response_decode(
    struct mip_gnss_rtk_config_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_gnss_rtk_config_response_codec, 0x84, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_gnss_rtk_config_response_encode(
    const struct mip_gnss_rtk_config_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_gnss_rtk_config_response_codec, value, builder);
}

/**
 * RTK dongle configuration: command (0x0E,0x10).
 *
 * Switches the communication with a connected RTK dongle on or off.
 *
 * No device is known for certain to support it. Also called `rtk_dongle_configuration`. Functions:
 * write, read, save, load and default. Response: mip_gnss_rtk_dongle_config_response. Probably
 * changes mip_gnss_data_rtk_corrections_status. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: RTK dongle configuration (0x0E,0x10)
 */
struct mip_gnss_rtk_dongle_config {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** 1 enables the dongle, 0 disables it. Range: 0 to 1. Required for write. */
    uint8_t enable;
    /** Reserved: send 0. Required for write. Uncertain: What to send; 0 is assumed. */
    uint8_t reserved[3];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_GNSS_RTK_DONGLE_CONFIG 0x0E10
/** Its descriptor. */
#define MIP_GNSS_RTK_DONGLE_CONFIG_DESCRIPTOR 0x10
/** Its name in the specification. */
#define MIP_GNSS_RTK_DONGLE_CONFIG_NAME "gnss.rtk_dongle_config"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_gnss_rtk_dongle_config_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_gnss_rtk_dongle_config_decode(struct mip_gnss_rtk_dongle_config *value,
                                                          const struct mip_field *field) {
    return mip_decode_only(&mip_gnss_rtk_dongle_config_codec, 0x10, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_gnss_rtk_dongle_config_encode(
    const struct mip_gnss_rtk_dongle_config *value, struct mip_builder *builder) {
    return mip_encode(&mip_gnss_rtk_dongle_config_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - enable: 1 enables the dongle, 0 disables it. Range: 0 to 1. Required for write.
 */
static inline struct mip_gnss_rtk_dongle_config *
mip_gnss_rtk_dongle_config_write(struct mip_gnss_rtk_dongle_config *command, uint8_t enable) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->enable = enable;
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_gnss_rtk_dongle_config *
mip_gnss_rtk_dongle_config_read(struct mip_gnss_rtk_dongle_config *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_gnss_rtk_dongle_config *
mip_gnss_rtk_dongle_config_save(struct mip_gnss_rtk_dongle_config *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_gnss_rtk_dongle_config *
mip_gnss_rtk_dongle_config_load(struct mip_gnss_rtk_dongle_config *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_gnss_rtk_dongle_config *
mip_gnss_rtk_dongle_config_default(struct mip_gnss_rtk_dongle_config *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * RTK dongle configuration response: response (0x0E,0x90).
 *
 * No device is known for certain to support it. Also called `rtk_dongle_configuration_response`.
 * Response to mip_gnss_rtk_dongle_config. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: RTK dongle configuration (0x0E,0x10)
 */
struct mip_gnss_rtk_dongle_config_response {
    /** 1 enables the dongle, 0 disables it. Range: 0 to 1. */
    uint8_t enable;
    /** Reserved. Uncertain: What to send; 0 is assumed. */
    uint8_t reserved[3];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_GNSS_RTK_DONGLE_CONFIG_RESPONSE 0x0E90
/** Its descriptor. */
#define MIP_GNSS_RTK_DONGLE_CONFIG_RESPONSE_DESCRIPTOR 0x90
/** Its name in the specification. */
#define MIP_GNSS_RTK_DONGLE_CONFIG_RESPONSE_NAME "gnss.rtk_dongle_config_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_gnss_rtk_dongle_config_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_gnss_rtk_dongle_config_response_decode(
    struct mip_gnss_rtk_dongle_config_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_gnss_rtk_dongle_config_response_codec, 0x90, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_gnss_rtk_dongle_config_response_encode(
    const struct mip_gnss_rtk_dongle_config_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_gnss_rtk_dongle_config_response_codec, value, builder);
}

/**
 * SPARTN configuration: command (0x0E,0x20).
 *
 * Sets the source and the keys of SPARTN corrections.
 *
 * Also called `spartn_configuration`. Functions: write, read, save, load and default. Response:
 * mip_gnss_spartn_config_response. Probably changes mip_gnss_data_rtk_corrections_status. Supported
 * by 3DM-CV7-GNSS/INS. Uncertain: Whether the device accepts upper and lower case. The section on
 * UART uses the digits 0-9 and A-F, the description of the command uses "bc" for 0xBC.
 *
 * A change of `enable` or `type` takes effect only after a power cycle; keys can be changed at any
 * time.
 *
 * While SPARTN corrections are enabled, RTCM corrections are blocked.
 *
 * A key has 16 bytes, none of them 0. Send it as 32 hexadecimal digits in ASCII, two for each byte.
 *
 * - 3dm-cv7-gnss-ins: Spartn Configuration (0x0E,0x20)
 * - 3dm-cv7-gnss-ins: SPARTN Corrections
 * - 3dm-cv7-gnss-ins: SPARTN Corrections via UART
 */
struct mip_gnss_spartn_config {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** 1 enables SPARTN corrections, 0 disables them. Range: 0 to 1. Required for write. */
    uint8_t enable;
    /**
     * Channel of the corrections. A value of enum mip_gnss_spartn_connection. Required for write.
     */
    uint8_t type;
    /** GPS time of week until which the current key is valid. Unit: s. Required for write. */
    uint32_t current_key_tow;
    /** GPS week number until which the current key is valid. Unit: week. Required for write. */
    uint16_t current_key_week;
    /** Current key in ASCII digits. Required for write. */
    uint8_t current_key[32];
    /** GPS time of week until which the next key is valid. Unit: s. Required for write. */
    uint32_t next_key_tow;
    /** GPS week number until which the next key is valid. Unit: week. Required for write. */
    uint16_t next_key_week;
    /** Next key in ASCII digits. Required for write. */
    uint8_t next_key[32];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_GNSS_SPARTN_CONFIG 0x0E20
/** Its descriptor. */
#define MIP_GNSS_SPARTN_CONFIG_DESCRIPTOR 0x20
/** Its name in the specification. */
#define MIP_GNSS_SPARTN_CONFIG_NAME "gnss.spartn_config"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_gnss_spartn_config_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_gnss_spartn_config_decode(struct mip_gnss_spartn_config *value,
                                                      const struct mip_field *field) {
    return mip_decode_only(&mip_gnss_spartn_config_codec, 0x20, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_gnss_spartn_config_encode(
    const struct mip_gnss_spartn_config *value, struct mip_builder *builder) {
    return mip_encode(&mip_gnss_spartn_config_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - enable: 1 enables SPARTN corrections, 0 disables them. Range: 0 to 1. Required for write.
 * - type: Channel of the corrections. A value of enum mip_gnss_spartn_connection. Required for
 *   write.
 * - current_key_tow: GPS time of week until which the current key is valid. Unit: s. Required for
 *   write.
 * - current_key_week: GPS week number until which the current key is valid. Unit: week. Required
 *   for write.
 * - current_key: Current key in ASCII digits. Required for write.
 * - next_key_tow: GPS time of week until which the next key is valid. Unit: s. Required for write.
 * - next_key_week: GPS week number until which the next key is valid. Unit: week. Required for
 *   write.
 * - next_key: Next key in ASCII digits. Required for write.
 */
static inline struct mip_gnss_spartn_config *mip_gnss_spartn_config_write(
    struct mip_gnss_spartn_config *command, uint8_t enable, enum mip_gnss_spartn_connection type,
    uint32_t current_key_tow, uint16_t current_key_week, const uint8_t current_key[32],
    uint32_t next_key_tow, uint16_t next_key_week, const uint8_t next_key[32]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->enable = enable;
    command->type = (uint8_t)type;
    command->current_key_tow = current_key_tow;
    command->current_key_week = current_key_week;
    memcpy(command->current_key, current_key, sizeof(command->current_key));
    command->next_key_tow = next_key_tow;
    command->next_key_week = next_key_week;
    memcpy(command->next_key, next_key, sizeof(command->next_key));
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_gnss_spartn_config *
mip_gnss_spartn_config_read(struct mip_gnss_spartn_config *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_gnss_spartn_config *
mip_gnss_spartn_config_save(struct mip_gnss_spartn_config *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_gnss_spartn_config *
mip_gnss_spartn_config_load(struct mip_gnss_spartn_config *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_gnss_spartn_config *
mip_gnss_spartn_config_default(struct mip_gnss_spartn_config *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * SPARTN configuration response: response (0x0E,0xA0).
 *
 * Also called `spartn_configuration_response`. Response to mip_gnss_spartn_config. Supported by
 * 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Spartn Configuration (0x0E,0x20)
 * - 3dm-cv7-gnss-ins: SPARTN Corrections
 * - 3dm-cv7-gnss-ins: SPARTN Corrections via UART
 */
struct mip_gnss_spartn_config_response {
    /** 1 enables SPARTN corrections, 0 disables them. Range: 0 to 1. */
    uint8_t enable;
    /** Channel of the corrections. A value of enum mip_gnss_spartn_connection. */
    uint8_t type;
    /** GPS time of week until which the current key is valid. Unit: s. */
    uint32_t current_key_tow;
    /** GPS week number until which the current key is valid. Unit: week. */
    uint16_t current_key_week;
    /** Current key in ASCII digits. */
    uint8_t current_key[32];
    /** GPS time of week until which the next key is valid. Unit: s. */
    uint32_t next_key_tow;
    /** GPS week number until which the next key is valid. Unit: week. */
    uint16_t next_key_week;
    /** Next key in ASCII digits. */
    uint8_t next_key[32];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_GNSS_SPARTN_CONFIG_RESPONSE 0x0EA0
/** Its descriptor. */
#define MIP_GNSS_SPARTN_CONFIG_RESPONSE_DESCRIPTOR 0xA0
/** Its name in the specification. */
#define MIP_GNSS_SPARTN_CONFIG_RESPONSE_NAME "gnss.spartn_config_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_gnss_spartn_config_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_gnss_spartn_config_response_decode(
    struct mip_gnss_spartn_config_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_gnss_spartn_config_response_codec, 0xA0, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_gnss_spartn_config_response_encode(
    const struct mip_gnss_spartn_config_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_gnss_spartn_config_response_codec, value, builder);
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
