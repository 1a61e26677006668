/**
 * @file
 * The commands of GNSS commands, each with the types of its parameters and of its response.
 */
#ifndef MIP_GNSS_COMMANDS_H
#define MIP_GNSS_COMMANDS_H

#include "mip/gnss.h"
#include "mip/device.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/gnss_commands.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_gnss GNSS commands (0x0E)
 * @{ */

MIP_COMMAND_REPLIES(mip_gnss_receiver_info);

/** Receiver info: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_gnss_receiver_info(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    struct mip_gnss_receiver_info_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_gnss_receiver_info_command, NULL,
                           &mip_gnss_receiver_info_response_codec, response, now);
}

/** Receiver info. */
static inline struct mip_result mip_call_gnss_receiver_info(
    struct mip_device *device, struct mip_gnss_receiver_info_response *response) {
    return mip_device_request(device, &mip_gnss_receiver_info_exchange,
                              MIP_NO_DATA(mip_gnss_receiver_info_exchange), 0,
                              &mip_gnss_receiver_info_response_codec, response);
}

MIP_COMMAND_REPLIES(mip_gnss_signal_config);
MIP_SEND(mip_send_gnss_signal_config, mip_gnss_signal_config, mip_gnss_signal_config_response);
MIP_CALL_FOR(mip_call_gnss_signal_config_read, mip_gnss_signal_config, MIP_FUNCTION_SELECTOR_READ,
             mip_gnss_signal_config_response);
MIP_CALL(mip_call_gnss_signal_config_save, mip_gnss_signal_config, MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_gnss_signal_config_load, mip_gnss_signal_config, MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_gnss_signal_config_default, mip_gnss_signal_config,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_gnss_signal_config_with, mip_gnss_signal_config,
              mip_gnss_signal_config_response);

/**
 * Signal configuration: write.
 *
 * - gps_enable: GPS signals. Required for write.
 * - glonass_enable: GLONASS signals. Required for write.
 * - galileo_enable: Galileo signals. Required for write.
 * - beidou_enable: BeiDou signals. Required for write.
 */
static inline struct mip_result mip_call_gnss_signal_config_write(
    struct mip_device *device, mip_gnss_gps_signals gps_enable,
    mip_gnss_glonass_signals glonass_enable, mip_gnss_galileo_signals galileo_enable,
    mip_gnss_beidou_signals beidou_enable) {
    struct mip_gnss_signal_config command;
    return mip_device_call(device, &mip_gnss_signal_config_command,
                           mip_gnss_signal_config_write(&command, gps_enable, glonass_enable,
                                                        galileo_enable, beidou_enable),
                           NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_gnss_receiver_reset);

/** Receiver reset: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_gnss_receiver_reset(struct mip_client *client,
                                                     struct mip_request *request,
                                                     struct mip_builder *packet,
                                                     const struct mip_gnss_receiver_reset *command,
                                                     uint32_t now) {
    return mip_client_send(client, request, packet, &mip_gnss_receiver_reset_command, command, NULL,
                           NULL, now);
}

/**
 * Receiver reset.
 *
 * - receiver_id: Receiver to reset. A value of enum mip_gnss_receiver_id.
 * - reset_type: Extent of the restart. A value of enum mip_gnss_receiver_reset_type.
 */
static inline struct mip_result
mip_call_gnss_receiver_reset(struct mip_device *device, enum mip_gnss_receiver_id receiver_id,
                             enum mip_gnss_receiver_reset_type reset_type) {
    const uint8_t data[] = {(uint8_t)receiver_id, (uint8_t)reset_type};
    return mip_device_send(device, &mip_gnss_receiver_reset_exchange, data, 2);
}

/** Receiver reset, with these values, including optional parameters. */
static inline struct mip_result mip_call_gnss_receiver_reset_with(
    struct mip_device *device, const struct mip_gnss_receiver_reset *command) {
    return mip_device_call(device, &mip_gnss_receiver_reset_command, command, NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_gnss_rtk_config);
MIP_SEND(mip_send_gnss_rtk_config, mip_gnss_rtk_config, mip_gnss_rtk_config_response);
MIP_CALL_FOR(mip_call_gnss_rtk_config_read, mip_gnss_rtk_config, MIP_FUNCTION_SELECTOR_READ,
             mip_gnss_rtk_config_response);
MIP_CALL(mip_call_gnss_rtk_config_save, mip_gnss_rtk_config, MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_gnss_rtk_config_load, mip_gnss_rtk_config, MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_gnss_rtk_config_default, mip_gnss_rtk_config, MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_gnss_rtk_config_with, mip_gnss_rtk_config, mip_gnss_rtk_config_response);

/**
 * RTK configuration: write.
 *
 * - ambiguity_fix_mode: Strategy for fixing ambiguities. A value of enum
 *   mip_gnss_ambiguity_fix_mode. Required for write.
 */
static inline struct mip_result mip_call_gnss_rtk_config_write(
    struct mip_device *device, enum mip_gnss_ambiguity_fix_mode ambiguity_fix_mode) {
    struct mip_gnss_rtk_config command;
    return mip_device_call(device, &mip_gnss_rtk_config_command,
                           mip_gnss_rtk_config_write(&command, ambiguity_fix_mode), NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_gnss_rtk_dongle_config);
MIP_SEND(mip_send_gnss_rtk_dongle_config, mip_gnss_rtk_dongle_config,
         mip_gnss_rtk_dongle_config_response);
MIP_CALL_FOR(mip_call_gnss_rtk_dongle_config_read, mip_gnss_rtk_dongle_config,
             MIP_FUNCTION_SELECTOR_READ, mip_gnss_rtk_dongle_config_response);
MIP_CALL(mip_call_gnss_rtk_dongle_config_save, mip_gnss_rtk_dongle_config,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_gnss_rtk_dongle_config_load, mip_gnss_rtk_dongle_config,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_gnss_rtk_dongle_config_default, mip_gnss_rtk_dongle_config,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_gnss_rtk_dongle_config_with, mip_gnss_rtk_dongle_config,
              mip_gnss_rtk_dongle_config_response);

/**
 * RTK dongle configuration: write.
 *
 * - enable: 1 enables the dongle, 0 disables it. Range: 0 to 1. Required for write.
 */
static inline struct mip_result mip_call_gnss_rtk_dongle_config_write(struct mip_device *device,
                                                                      uint8_t enable) {
    struct mip_gnss_rtk_dongle_config command;
    return mip_device_call(device, &mip_gnss_rtk_dongle_config_command,
                           mip_gnss_rtk_dongle_config_write(&command, enable), NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_gnss_spartn_config);
MIP_SEND(mip_send_gnss_spartn_config, mip_gnss_spartn_config, mip_gnss_spartn_config_response);
MIP_CALL_FOR(mip_call_gnss_spartn_config_read, mip_gnss_spartn_config, MIP_FUNCTION_SELECTOR_READ,
             mip_gnss_spartn_config_response);
MIP_CALL(mip_call_gnss_spartn_config_save, mip_gnss_spartn_config, MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_gnss_spartn_config_load, mip_gnss_spartn_config, MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_gnss_spartn_config_default, mip_gnss_spartn_config,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_gnss_spartn_config_with, mip_gnss_spartn_config,
              mip_gnss_spartn_config_response);

/**
 * SPARTN configuration: write.
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
static inline struct mip_result mip_call_gnss_spartn_config_write(
    struct mip_device *device, uint8_t enable, enum mip_gnss_spartn_connection type,
    uint32_t current_key_tow, uint16_t current_key_week, const uint8_t current_key[32],
    uint32_t next_key_tow, uint16_t next_key_week, const uint8_t next_key[32]) {
    uint8_t data[79];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)enable);
    mip_put_8(data + 2, (uint8_t)type);
    mip_put_32(data + 3, (uint32_t)current_key_tow);
    mip_put_16(data + 7, (uint16_t)current_key_week);
    mip_put_32(data + 41, (uint32_t)next_key_tow);
    mip_put_16(data + 45, (uint16_t)next_key_week);
    for (size_t i = 0; i < 32; i++) {
        mip_put_8(data + 9 + 1 * i, (uint8_t)current_key[i]);
    }
    for (size_t i = 0; i < 32; i++) {
        mip_put_8(data + 47 + 1 * i, (uint8_t)next_key[i]);
    }
    return mip_device_send(device, &mip_gnss_spartn_config_exchange, data, 79);
}

MIP_COMMAND_REPLIES(mip_gnss_receiver_safe_mode);

/** Receiver safe mode: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_gnss_receiver_safe_mode(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_gnss_receiver_safe_mode *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_gnss_receiver_safe_mode_command, command,
                           NULL, NULL, now);
}

/**
 * Receiver safe mode.
 *
 * - receiver_id: Number of the receiver, from 1. Range: at least 1.
 * - enable: 1 switches safe mode on, 0 off. Range: 0 to 1.
 */
static inline struct mip_result mip_call_gnss_receiver_safe_mode(struct mip_device *device,
                                                                 uint8_t receiver_id,
                                                                 uint8_t enable) {
    const uint8_t data[] = {(uint8_t)receiver_id, (uint8_t)enable};
    return mip_device_send(device, &mip_gnss_receiver_safe_mode_exchange, data, 2);
}

/** Receiver safe mode, with these values, including optional parameters. */
static inline struct mip_result mip_call_gnss_receiver_safe_mode_with(
    struct mip_device *device, const struct mip_gnss_receiver_safe_mode *command) {
    return mip_device_call(device, &mip_gnss_receiver_safe_mode_command, command, NULL, NULL);
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
