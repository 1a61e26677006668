/**
 * @file
 *
 * GNSS commands (0x0E). Commands that describe and set up the internal GNSS receivers.
 *
 * The devices that support a field are in mip/extra/profiles.h.
 */
#ifndef MIP_GNSS_H
#define MIP_GNSS_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 200
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
     * Restarts the positioning engine only. Uncertain: An earlier branch of the SDK calls 3 hot and
     * 4 warm, with the same descriptions of the two numbers. GNSS receivers usually keep their
     * satellite data in a hot start and lose it in a warm one.
     */
    MIP_GNSS_RECEIVER_RESET_TYPE_WARM = 3,
    /**
     * Restarts the positioning engine and clears its ephemerides and almanacs. Uncertain: An
     * earlier branch of the SDK swaps this name with that of 3.
     */
    MIP_GNSS_RECEIVER_RESET_TYPE_HOT = 4
};

/**
 * Strategy for fixing the RTK carrier phase ambiguities to whole numbers. Uncertain: The
 * descriptions of `conservative` and `moderate` are inferred from their names.
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

/** Channel that delivers SPARTN corrections. */
enum mip_gnss_spartn_connection MIP_ENUM_8 {
    /** No connection. */
    MIP_GNSS_SPARTN_CONNECTION_NONE = 0,
    /** Over a network. */
    MIP_GNSS_SPARTN_CONNECTION_NETWORK = 1,
    /** By satellite in the L band. */
    MIP_GNSS_SPARTN_CONNECTION_L_BAND = 2
};

/**
 * Receiver info: command (0x0E,0x01).
 *
 * Gets the GNSS receivers of the device.
 *
 * Response: mip_gnss_receiver_info_response.
 *
 * - 3dm-cv7-gnss-ins: Receiver Info (0x0E,0x01)
 */
struct mip_gnss_receiver_info {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_GNSS_RECEIVER_INFO 0x0E01
#define MIP_GNSS_RECEIVER_INFO_DESCRIPTOR 0x01
MIP_FIELD(mip_gnss_receiver_info, 0x01);

/**
 * Receiver info response: response (0x0E,0x81).
 *
 * Response to mip_gnss_receiver_info.
 *
 * - 3dm-cv7-gnss-ins: Receiver Info (0x0E,0x01)
 */
struct mip_gnss_receiver_info_response {
    /** Number of physical receivers. Counts the elements of receiver_info. */
    uint8_t num_receivers;
    /** One entry for each receiver. */
    struct mip_gnss_receiver_info_entry receiver_info[7];
};

#define MIP_GNSS_RECEIVER_INFO_RESPONSE 0x0E81
#define MIP_GNSS_RECEIVER_INFO_RESPONSE_DESCRIPTOR 0x81
MIP_FIELD(mip_gnss_receiver_info_response, 0x81);

/**
 * Signal configuration: command (0x0E,0x02).
 *
 * Selects the GNSS signals that the device uses.
 *
 * Also called `signal_configuration`. Functions: write, read, save, load and default. Response:
 * mip_gnss_signal_config_response. Probably affects mip_gnss_data_fix_info,
 * mip_gnss_data_satellite_status and mip_gnss_data_raw. Requires firmware later than 1.0.10 on the
 * 3DM-GQ7-GNSS/INS.
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
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
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

#define MIP_GNSS_SIGNAL_CONFIG 0x0E02
#define MIP_GNSS_SIGNAL_CONFIG_DESCRIPTOR 0x02
MIP_FIELD(mip_gnss_signal_config, 0x02);
MIP_FILL(mip_gnss_signal_config, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_gnss_signal_config, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_gnss_signal_config, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_gnss_signal_config, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
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

/**
 * Signal configuration response: response (0x0E,0x82).
 *
 * Also called `signal_configuration_response`. Response to mip_gnss_signal_config.
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

#define MIP_GNSS_SIGNAL_CONFIG_RESPONSE 0x0E82
#define MIP_GNSS_SIGNAL_CONFIG_RESPONSE_DESCRIPTOR 0x82
MIP_FIELD(mip_gnss_signal_config_response, 0x82);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_gnss_signal_config *
mip_gnss_signal_config_write_from(struct mip_gnss_signal_config *command,
                                  const struct mip_gnss_signal_config_response *response) {
    return mip_gnss_signal_config_write(command, response->gps_enable, response->glonass_enable,
                                        response->galileo_enable, response->beidou_enable);
}

/**
 * Receiver reset: command (0x0E,0x03).
 *
 * Resets a GNSS receiver of the device.
 *
 * Known only from the MicroStrain MIP SDK. Uncertain: The SDK names no device that supports it.
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

#define MIP_GNSS_RECEIVER_RESET 0x0E03
#define MIP_GNSS_RECEIVER_RESET_DESCRIPTOR 0x03
MIP_FIELD(mip_gnss_receiver_reset, 0x03);

/** Fills the structure, and returns it. */
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
 * mip_gnss_rtk_config_response. Probably affects mip_gnss_data_fix_info and
 * mip_gnss_data_llh_position. Known only from the MicroStrain MIP SDK. Uncertain: No source lists
 * the devices that support it. Users of the vendor's ROS driver report it as experimental on the
 * 3DM-GQ7, which accepts `conservative` only.
 *
 * The available modes differ by device.
 *
 * - mip-sdk-4: RTK configuration (0x0E,0x04)
 */
struct mip_gnss_rtk_config {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
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

#define MIP_GNSS_RTK_CONFIG 0x0E04
#define MIP_GNSS_RTK_CONFIG_DESCRIPTOR 0x04
MIP_FIELD(mip_gnss_rtk_config, 0x04);
MIP_FILL(mip_gnss_rtk_config, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_gnss_rtk_config, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_gnss_rtk_config, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_gnss_rtk_config, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_gnss_rtk_config *mip_gnss_rtk_config_write(
    struct mip_gnss_rtk_config *command, enum mip_gnss_ambiguity_fix_mode ambiguity_fix_mode) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->ambiguity_fix_mode = (uint8_t)ambiguity_fix_mode;
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

#define MIP_GNSS_RTK_CONFIG_RESPONSE 0x0E84
#define MIP_GNSS_RTK_CONFIG_RESPONSE_DESCRIPTOR 0x84
MIP_FIELD(mip_gnss_rtk_config_response, 0x84);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_gnss_rtk_config *mip_gnss_rtk_config_write_from(
    struct mip_gnss_rtk_config *command, const struct mip_gnss_rtk_config_response *response) {
    return mip_gnss_rtk_config_write(
        command, (enum mip_gnss_ambiguity_fix_mode)response->ambiguity_fix_mode);
}

/**
 * RTK dongle configuration: command (0x0E,0x10).
 *
 * Switches the communication with a connected RTK dongle on or off.
 *
 * No device is known for certain to support it. Also called `rtk_dongle_configuration`. Functions:
 * write, read, save, load and default. Response: mip_gnss_rtk_dongle_config_response. Probably
 * affects mip_gnss_data_rtk_corrections_status. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: RTK dongle configuration (0x0E,0x10)
 */
struct mip_gnss_rtk_dongle_config {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** 1 enables the dongle, 0 disables it. Range: 0 to 1. Required for write. */
    uint8_t enable;
    /**
     * Reserved: send 0. Required for write. Uncertain: No source states what to send; 0 is assumed.
     */
    uint8_t reserved[3];
};

#define MIP_GNSS_RTK_DONGLE_CONFIG 0x0E10
#define MIP_GNSS_RTK_DONGLE_CONFIG_DESCRIPTOR 0x10
MIP_FIELD(mip_gnss_rtk_dongle_config, 0x10);
MIP_FILL(mip_gnss_rtk_dongle_config, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_gnss_rtk_dongle_config, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_gnss_rtk_dongle_config, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_gnss_rtk_dongle_config, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_gnss_rtk_dongle_config *
mip_gnss_rtk_dongle_config_write(struct mip_gnss_rtk_dongle_config *command, uint8_t enable) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->enable = enable;
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
    /** Reserved. Uncertain: No source states what to send; 0 is assumed. */
    uint8_t reserved[3];
};

#define MIP_GNSS_RTK_DONGLE_CONFIG_RESPONSE 0x0E90
#define MIP_GNSS_RTK_DONGLE_CONFIG_RESPONSE_DESCRIPTOR 0x90
MIP_FIELD(mip_gnss_rtk_dongle_config_response, 0x90);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_gnss_rtk_dongle_config *
mip_gnss_rtk_dongle_config_write_from(struct mip_gnss_rtk_dongle_config *command,
                                      const struct mip_gnss_rtk_dongle_config_response *response) {
    return mip_gnss_rtk_dongle_config_write(command, response->enable);
}

/**
 * SPARTN configuration: command (0x0E,0x20).
 *
 * Sets the source and the keys of SPARTN corrections.
 *
 * Also called `spartn_configuration`. Functions: write, read, save, load and default. Response:
 * mip_gnss_spartn_config_response. Probably affects mip_gnss_data_rtk_corrections_status.
 * Uncertain: The device may not accept lower case: the section on UART uses the digits 0-9 and A-F,
 * the description of the command uses "bc" for 0xBC.
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
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
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

#define MIP_GNSS_SPARTN_CONFIG 0x0E20
#define MIP_GNSS_SPARTN_CONFIG_DESCRIPTOR 0x20
MIP_FIELD(mip_gnss_spartn_config, 0x20);
MIP_FILL(mip_gnss_spartn_config, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_gnss_spartn_config, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_gnss_spartn_config, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_gnss_spartn_config, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
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

/**
 * SPARTN configuration response: response (0x0E,0xA0).
 *
 * Also called `spartn_configuration_response`. Response to mip_gnss_spartn_config.
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

#define MIP_GNSS_SPARTN_CONFIG_RESPONSE 0x0EA0
#define MIP_GNSS_SPARTN_CONFIG_RESPONSE_DESCRIPTOR 0xA0
MIP_FIELD(mip_gnss_spartn_config_response, 0xA0);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_gnss_spartn_config *
mip_gnss_spartn_config_write_from(struct mip_gnss_spartn_config *command,
                                  const struct mip_gnss_spartn_config_response *response) {
    return mip_gnss_spartn_config_write(
        command, response->enable, (enum mip_gnss_spartn_connection)response->type,
        response->current_key_tow, response->current_key_week, response->current_key,
        response->next_key_tow, response->next_key_week, response->next_key);
}

/**
 * Receiver safe mode: command (0x0E,0x60).
 *
 * Switches the safe mode of one receiver on or off. In safe mode, it sends no valid data.
 *
 * Affects MIP_GNSS_DATA_SET, MIP_GNSS_1_SET, MIP_GNSS_2_SET, MIP_GNSS_CORRECTIONS_SET,
 * MIP_GNSS_EXTERNAL_SET and MIP_GNSS_EXTERNAL_2_SET. Known only from the MicroStrain MIP SDK,
 * versions 1 to 3. Uncertain: The layout is that of version 1.0.0 of the SDK; later versions do not
 * have it. Uncertain: No source lists the devices that support it.
 *
 * - mip-sdk-3: Receiver Safe Mode (0x0E,0x60), tag v1.0.0
 */
struct mip_gnss_receiver_safe_mode {
    /** Number of the receiver, from 1. Range: at least 1. */
    uint8_t receiver_id;
    /** 1 switches safe mode on, 0 off. Range: 0 to 1. */
    uint8_t enable;
};

#define MIP_GNSS_RECEIVER_SAFE_MODE 0x0E60
#define MIP_GNSS_RECEIVER_SAFE_MODE_DESCRIPTOR 0x60
MIP_FIELD(mip_gnss_receiver_safe_mode, 0x60);

/** Fills the structure, and returns it. */
static inline struct mip_gnss_receiver_safe_mode *mip_gnss_receiver_safe_mode_make(
    struct mip_gnss_receiver_safe_mode *command, uint8_t receiver_id, uint8_t enable) {
    memset(command, 0, sizeof(*command));
    command->receiver_id = receiver_id;
    command->enable = enable;
    return command;
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
