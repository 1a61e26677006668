/**
 * @file
 * The commands of 3DM, each with the types of its parameters and of its response.
 */
#ifndef MIP_3DM_COMMANDS_H
#define MIP_3DM_COMMANDS_H

#include "mip/3dm.h"
#include "mip/device.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/3dm_commands.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_3dm 3DM (0x0C)
 * @{ */

MIP_COMMAND_REPLIES(mip_3dm_poll_imu_data);

/** Poll IMU data: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_3dm_poll_imu_data(struct mip_client *client,
                                                   struct mip_request *request,
                                                   struct mip_builder *packet,
                                                   const struct mip_3dm_poll_imu_data *command,
                                                   uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_poll_imu_data_command, command, NULL,
                           NULL, now);
}

/**
 * Poll IMU data.
 *
 * - suppress_ack: Send no acknowledge.
 * - num_descriptors: Number of fields. Counts the elements of descriptors.
 * - descriptors: Fields to send. Refers to fields of MIP_SENSOR_SET.
 */
static inline struct mip_result
mip_call_3dm_poll_imu_data(struct mip_device *device, mip_bool suppress_ack,
                           uint8_t num_descriptors, const struct mip_3dm_poll_entry descriptors[]) {
    struct mip_3dm_poll_imu_data command;
    return mip_device_call(
        device, &mip_3dm_poll_imu_data_command,
        mip_3dm_poll_imu_data_make(&command, suppress_ack, num_descriptors, descriptors), NULL,
        NULL);
}

/** Poll IMU data, with these values, including optional parameters. */
static inline struct mip_result mip_call_3dm_poll_imu_data_with(
    struct mip_device *device, const struct mip_3dm_poll_imu_data *command) {
    return mip_device_call(device, &mip_3dm_poll_imu_data_command, command, NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_3dm_poll_gnss_data);

/** Poll GNSS data: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_3dm_poll_gnss_data(struct mip_client *client,
                                                    struct mip_request *request,
                                                    struct mip_builder *packet,
                                                    const struct mip_3dm_poll_gnss_data *command,
                                                    uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_poll_gnss_data_command, command, NULL,
                           NULL, now);
}

/**
 * Poll GNSS data.
 *
 * - suppress_ack: Send no acknowledge.
 * - num_descriptors: Number of fields. Counts the elements of descriptors. Range: 0 to 83.
 * - descriptors: Fields to send. Refers to fields of MIP_GNSS_DATA_SET. Uncertain: The SDK has a
 *   decimation in place of the reserved number and does not document how a poll uses it.
 */
static inline struct mip_result mip_call_3dm_poll_gnss_data(
    struct mip_device *device, mip_bool suppress_ack, uint8_t num_descriptors,
    const struct mip_3dm_poll_entry descriptors[]) {
    struct mip_3dm_poll_gnss_data command;
    return mip_device_call(
        device, &mip_3dm_poll_gnss_data_command,
        mip_3dm_poll_gnss_data_make(&command, suppress_ack, num_descriptors, descriptors), NULL,
        NULL);
}

/** Poll GNSS data, with these values, including optional parameters. */
static inline struct mip_result mip_call_3dm_poll_gnss_data_with(
    struct mip_device *device, const struct mip_3dm_poll_gnss_data *command) {
    return mip_device_call(device, &mip_3dm_poll_gnss_data_command, command, NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_3dm_poll_filter_data);

/** Poll estimation filter data: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_3dm_poll_filter_data(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_poll_filter_data *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_poll_filter_data_command, command,
                           NULL, NULL, now);
}

/**
 * Poll estimation filter data.
 *
 * - suppress_ack: Send no acknowledge.
 * - num_descriptors: Number of fields. Counts the elements of descriptors.
 * - descriptors: Fields to send. Refers to fields of MIP_FILTER_DATA_SET.
 */
static inline struct mip_result mip_call_3dm_poll_filter_data(
    struct mip_device *device, mip_bool suppress_ack, uint8_t num_descriptors,
    const struct mip_3dm_poll_entry descriptors[]) {
    struct mip_3dm_poll_filter_data command;
    return mip_device_call(
        device, &mip_3dm_poll_filter_data_command,
        mip_3dm_poll_filter_data_make(&command, suppress_ack, num_descriptors, descriptors), NULL,
        NULL);
}

/** Poll estimation filter data, with these values, including optional parameters. */
static inline struct mip_result mip_call_3dm_poll_filter_data_with(
    struct mip_device *device, const struct mip_3dm_poll_filter_data *command) {
    return mip_device_call(device, &mip_3dm_poll_filter_data_command, command, NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_3dm_poll_nmea_data);

/** Poll NMEA data: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_3dm_poll_nmea_data(struct mip_client *client,
                                                    struct mip_request *request,
                                                    struct mip_builder *packet,
                                                    const struct mip_3dm_poll_nmea_data *command,
                                                    uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_poll_nmea_data_command, command, NULL,
                           NULL, now);
}

/**
 * Poll NMEA data.
 *
 * - suppress_ack: Send no acknowledge.
 * - count: Number of sentences. Counts the elements of format_entries.
 * - format_entries: Sentences to send.
 */
static inline struct mip_result
mip_call_3dm_poll_nmea_data(struct mip_device *device, mip_bool suppress_ack, uint8_t count,
                            const struct mip_nmea_message format_entries[]) {
    struct mip_3dm_poll_nmea_data command;
    return mip_device_call(
        device, &mip_3dm_poll_nmea_data_command,
        mip_3dm_poll_nmea_data_make(&command, suppress_ack, count, format_entries), NULL, NULL);
}

/** Poll NMEA data, with these values, including optional parameters. */
static inline struct mip_result mip_call_3dm_poll_nmea_data_with(
    struct mip_device *device, const struct mip_3dm_poll_nmea_data *command) {
    return mip_device_call(device, &mip_3dm_poll_nmea_data_command, command, NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_3dm_get_imu_base_rate);

/** Get IMU data base rate: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_3dm_get_imu_base_rate(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    struct mip_3dm_get_imu_base_rate_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_get_imu_base_rate_command, NULL,
                           &mip_3dm_get_imu_base_rate_response_codec, response, now);
}

/** Get IMU data base rate. */
static inline struct mip_result mip_call_3dm_get_imu_base_rate(
    struct mip_device *device, struct mip_3dm_get_imu_base_rate_response *response) {
    return mip_device_request(device, &mip_3dm_get_imu_base_rate_exchange,
                              MIP_NO_DATA(mip_3dm_get_imu_base_rate_exchange), 0,
                              &mip_3dm_get_imu_base_rate_response_codec, response);
}

MIP_COMMAND_REPLIES(mip_3dm_get_gnss_base_rate);

/** Get GNSS data base rate: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_3dm_get_gnss_base_rate(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    struct mip_3dm_get_gnss_base_rate_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_get_gnss_base_rate_command, NULL,
                           &mip_3dm_get_gnss_base_rate_response_codec, response, now);
}

/** Get GNSS data base rate. */
static inline struct mip_result mip_call_3dm_get_gnss_base_rate(
    struct mip_device *device, struct mip_3dm_get_gnss_base_rate_response *response) {
    return mip_device_request(device, &mip_3dm_get_gnss_base_rate_exchange,
                              MIP_NO_DATA(mip_3dm_get_gnss_base_rate_exchange), 0,
                              &mip_3dm_get_gnss_base_rate_response_codec, response);
}

MIP_COMMAND_REPLIES(mip_3dm_imu_message_format);
MIP_SEND(mip_send_3dm_imu_message_format, mip_3dm_imu_message_format,
         mip_3dm_imu_message_format_response);
MIP_CALL_FOR(mip_call_3dm_imu_message_format_read, mip_3dm_imu_message_format,
             MIP_FUNCTION_SELECTOR_READ, mip_3dm_imu_message_format_response);
MIP_CALL(mip_call_3dm_imu_message_format_save, mip_3dm_imu_message_format,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_3dm_imu_message_format_load, mip_3dm_imu_message_format,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_3dm_imu_message_format_default, mip_3dm_imu_message_format,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_3dm_imu_message_format_with, mip_3dm_imu_message_format,
              mip_3dm_imu_message_format_response);

/**
 * IMU message format: write.
 *
 * - num_descriptors: Number of fields. Counts the elements of descriptors. Required for write.
 * - descriptors: Fields and decimations. Refers to fields of MIP_SENSOR_SET. Required for write.
 */
MIP_INLINE struct mip_result
mip_call_3dm_imu_message_format_write(struct mip_device *device, uint8_t num_descriptors,
                                      const struct mip_descriptor_rate descriptors[]) {
    uint8_t data[MIP_MAX_FIELD_DATA];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)num_descriptors);
    (void)mip_counted(num_descriptors, descriptors, sizeof(descriptors[0]));
    for (size_t i = 0; i < num_descriptors && i < 83; i++) {
        mip_put_8(data + 2 + 3 * i, (uint8_t)descriptors[i].descriptor);
        mip_put_16(data + 3 + 3 * i, (uint16_t)descriptors[i].decimation);
    }
    return mip_device_send(device, &mip_3dm_imu_message_format_exchange, data,
                           num_descriptors <= 83 ? 2 + 3 * (size_t)num_descriptors
                                                 : MIP_MAX_FIELD_DATA + 1);
}

MIP_COMMAND_REPLIES(mip_3dm_gnss_message_format);
MIP_SEND(mip_send_3dm_gnss_message_format, mip_3dm_gnss_message_format,
         mip_3dm_gnss_message_format_response);
MIP_CALL_FOR(mip_call_3dm_gnss_message_format_read, mip_3dm_gnss_message_format,
             MIP_FUNCTION_SELECTOR_READ, mip_3dm_gnss_message_format_response);
MIP_CALL(mip_call_3dm_gnss_message_format_save, mip_3dm_gnss_message_format,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_3dm_gnss_message_format_load, mip_3dm_gnss_message_format,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_3dm_gnss_message_format_default, mip_3dm_gnss_message_format,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_3dm_gnss_message_format_with, mip_3dm_gnss_message_format,
              mip_3dm_gnss_message_format_response);

/**
 * GNSS message format: write.
 *
 * - num_descriptors: Number of fields. Counts the elements of descriptors. Range: 0 to 82. Required
 *   for write.
 * - descriptors: Fields and decimations. Refers to fields of MIP_GNSS_DATA_SET. Required for write.
 */
MIP_INLINE struct mip_result
mip_call_3dm_gnss_message_format_write(struct mip_device *device, uint8_t num_descriptors,
                                       const struct mip_descriptor_rate descriptors[]) {
    uint8_t data[MIP_MAX_FIELD_DATA];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)num_descriptors);
    (void)mip_counted(num_descriptors, descriptors, sizeof(descriptors[0]));
    for (size_t i = 0; i < num_descriptors && i < 83; i++) {
        mip_put_8(data + 2 + 3 * i, (uint8_t)descriptors[i].descriptor);
        mip_put_16(data + 3 + 3 * i, (uint16_t)descriptors[i].decimation);
    }
    return mip_device_send(device, &mip_3dm_gnss_message_format_exchange, data,
                           num_descriptors <= 83 ? 2 + 3 * (size_t)num_descriptors
                                                 : MIP_MAX_FIELD_DATA + 1);
}

MIP_COMMAND_REPLIES(mip_3dm_filter_message_format);
MIP_SEND(mip_send_3dm_filter_message_format, mip_3dm_filter_message_format,
         mip_3dm_filter_message_format_response);
MIP_CALL_FOR(mip_call_3dm_filter_message_format_read, mip_3dm_filter_message_format,
             MIP_FUNCTION_SELECTOR_READ, mip_3dm_filter_message_format_response);
MIP_CALL(mip_call_3dm_filter_message_format_save, mip_3dm_filter_message_format,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_3dm_filter_message_format_load, mip_3dm_filter_message_format,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_3dm_filter_message_format_default, mip_3dm_filter_message_format,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_3dm_filter_message_format_with, mip_3dm_filter_message_format,
              mip_3dm_filter_message_format_response);

/**
 * Estimation filter message format: write.
 *
 * - num_descriptors: Number of fields. Counts the elements of descriptors. Required for write.
 * - descriptors: Fields and decimations. Refers to fields of MIP_FILTER_DATA_SET. Required for
 *   write.
 */
MIP_INLINE struct mip_result
mip_call_3dm_filter_message_format_write(struct mip_device *device, uint8_t num_descriptors,
                                         const struct mip_descriptor_rate descriptors[]) {
    uint8_t data[MIP_MAX_FIELD_DATA];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)num_descriptors);
    (void)mip_counted(num_descriptors, descriptors, sizeof(descriptors[0]));
    for (size_t i = 0; i < num_descriptors && i < 83; i++) {
        mip_put_8(data + 2 + 3 * i, (uint8_t)descriptors[i].descriptor);
        mip_put_16(data + 3 + 3 * i, (uint16_t)descriptors[i].decimation);
    }
    return mip_device_send(device, &mip_3dm_filter_message_format_exchange, data,
                           num_descriptors <= 83 ? 2 + 3 * (size_t)num_descriptors
                                                 : MIP_MAX_FIELD_DATA + 1);
}

MIP_COMMAND_REPLIES(mip_3dm_get_filter_base_rate);

/** Get estimation filter data base rate: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_3dm_get_filter_base_rate(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    struct mip_3dm_get_filter_base_rate_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_get_filter_base_rate_command, NULL,
                           &mip_3dm_get_filter_base_rate_response_codec, response, now);
}

/** Get estimation filter data base rate. */
static inline struct mip_result mip_call_3dm_get_filter_base_rate(
    struct mip_device *device, struct mip_3dm_get_filter_base_rate_response *response) {
    return mip_device_request(device, &mip_3dm_get_filter_base_rate_exchange,
                              MIP_NO_DATA(mip_3dm_get_filter_base_rate_exchange), 0,
                              &mip_3dm_get_filter_base_rate_response_codec, response);
}

MIP_COMMAND_REPLIES(mip_3dm_nmea_message_format);
MIP_SEND(mip_send_3dm_nmea_message_format, mip_3dm_nmea_message_format,
         mip_3dm_nmea_message_format_response);
MIP_CALL_FOR(mip_call_3dm_nmea_message_format_read, mip_3dm_nmea_message_format,
             MIP_FUNCTION_SELECTOR_READ, mip_3dm_nmea_message_format_response);
MIP_CALL(mip_call_3dm_nmea_message_format_save, mip_3dm_nmea_message_format,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_3dm_nmea_message_format_load, mip_3dm_nmea_message_format,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_3dm_nmea_message_format_default, mip_3dm_nmea_message_format,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_3dm_nmea_message_format_with, mip_3dm_nmea_message_format,
              mip_3dm_nmea_message_format_response);

/**
 * NMEA message format: write.
 *
 * - count: Number of sentences. Counts the elements of format_entries. Required for write.
 * - format_entries: Sentences to stream. Required for write.
 */
MIP_INLINE struct mip_result mip_call_3dm_nmea_message_format_write(
    struct mip_device *device, uint8_t count, const struct mip_nmea_message format_entries[]) {
    uint8_t data[MIP_MAX_FIELD_DATA];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)count);
    (void)mip_counted(count, format_entries, sizeof(format_entries[0]));
    for (size_t i = 0; i < count && i < 50; i++) {
        mip_put_8(data + 2 + 5 * i, (uint8_t)format_entries[i].message_id);
        mip_put_8(data + 3 + 5 * i, (uint8_t)format_entries[i].talker_id);
        mip_put_8(data + 4 + 5 * i, (uint8_t)format_entries[i].source_descriptor_set);
        mip_put_16(data + 5 + 5 * i, (uint16_t)format_entries[i].decimation);
    }
    return mip_device_send(device, &mip_3dm_nmea_message_format_exchange, data,
                           count <= 50 ? 2 + 5 * (size_t)count : MIP_MAX_FIELD_DATA + 1);
}

MIP_COMMAND_REPLIES(mip_3dm_poll_data);

/** Poll data: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_3dm_poll_data(struct mip_client *client,
                                               struct mip_request *request,
                                               struct mip_builder *packet,
                                               const struct mip_3dm_poll_data *command,
                                               uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_poll_data_command, command, NULL, NULL,
                           now);
}

/**
 * Poll data.
 *
 * - descriptor_set: Data descriptor set. Range: 0x80 to 0xFE.
 * - suppress_ack: Send no acknowledge.
 * - num_descriptors: Number of fields. Counts the elements of descriptors.
 * - descriptors: Field descriptors. Refers to fields of descriptor_set.
 */
static inline struct mip_result mip_call_3dm_poll_data(struct mip_device *device,
                                                       uint8_t descriptor_set,
                                                       mip_bool suppress_ack,
                                                       uint8_t num_descriptors,
                                                       const uint8_t descriptors[]) {
    struct mip_3dm_poll_data command;
    return mip_device_call(device, &mip_3dm_poll_data_command,
                           mip_3dm_poll_data_make(&command, descriptor_set, suppress_ack,
                                                  num_descriptors, descriptors),
                           NULL, NULL);
}

/** Poll data, with these values, including optional parameters. */
static inline struct mip_result
mip_call_3dm_poll_data_with(struct mip_device *device, const struct mip_3dm_poll_data *command) {
    return mip_device_call(device, &mip_3dm_poll_data_command, command, NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_3dm_get_base_rate);
MIP_SEND(mip_send_3dm_get_base_rate, mip_3dm_get_base_rate, mip_3dm_get_base_rate_response);
MIP_CALL_WITH(mip_call_3dm_get_base_rate_with, mip_3dm_get_base_rate,
              mip_3dm_get_base_rate_response);

/**
 * Get data base rate.
 *
 * - descriptor_set: Data descriptor set. Range: 0x80 to 0xFE.
 */
static inline struct mip_result
mip_call_3dm_get_base_rate(struct mip_device *device, uint8_t descriptor_set,
                           struct mip_3dm_get_base_rate_response *response) {
    const uint8_t data[] = {(uint8_t)descriptor_set};
    return mip_device_request(device, &mip_3dm_get_base_rate_exchange, data, 1,
                              &mip_3dm_get_base_rate_response_codec, response);
}

MIP_COMMAND_REPLIES(mip_3dm_message_format);
MIP_SEND(mip_send_3dm_message_format, mip_3dm_message_format, mip_3dm_message_format_response);
MIP_CALL_WITH(mip_call_3dm_message_format_with, mip_3dm_message_format,
              mip_3dm_message_format_response);

/**
 * Message format: write.
 *
 * - descriptor_set: Data descriptor set; 0 means all of them (save, load, default).
 * - num_descriptors: Number of fields. Counts the elements of descriptors. Required for write.
 * - descriptors: Fields and decimations. Refers to fields of descriptor_set. Required for write.
 */
MIP_INLINE struct mip_result mip_call_3dm_message_format_write(
    struct mip_device *device, uint8_t descriptor_set, uint8_t num_descriptors,
    const struct mip_descriptor_rate descriptors[]) {
    uint8_t data[MIP_MAX_FIELD_DATA];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)descriptor_set);
    mip_put_8(data + 2, (uint8_t)num_descriptors);
    (void)mip_counted(num_descriptors, descriptors, sizeof(descriptors[0]));
    for (size_t i = 0; i < num_descriptors && i < 83; i++) {
        mip_put_8(data + 3 + 3 * i, (uint8_t)descriptors[i].descriptor);
        mip_put_16(data + 4 + 3 * i, (uint16_t)descriptors[i].decimation);
    }
    return mip_device_send(device, &mip_3dm_message_format_exchange, data,
                           num_descriptors <= 83 ? 3 + 3 * (size_t)num_descriptors
                                                 : MIP_MAX_FIELD_DATA + 1);
}

/**
 * Message format: read.
 *
 * - descriptor_set: Data descriptor set; 0 means all of them (save, load, default).
 */
static inline struct mip_result
mip_call_3dm_message_format_read(struct mip_device *device, uint8_t descriptor_set,
                                 struct mip_3dm_message_format_response *response) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_READ, (uint8_t)descriptor_set};
    return mip_device_request(device, &mip_3dm_message_format_exchange, data, 2,
                              &mip_3dm_message_format_response_codec, response);
}

/**
 * Message format: save.
 *
 * - descriptor_set: Data descriptor set; 0 means all of them (save, load, default).
 */
static inline struct mip_result mip_call_3dm_message_format_save(struct mip_device *device,
                                                                 uint8_t descriptor_set) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_SAVE, (uint8_t)descriptor_set};
    return mip_device_send(device, &mip_3dm_message_format_exchange, data, 2);
}

/**
 * Message format: load.
 *
 * - descriptor_set: Data descriptor set; 0 means all of them (save, load, default).
 */
static inline struct mip_result mip_call_3dm_message_format_load(struct mip_device *device,
                                                                 uint8_t descriptor_set) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_LOAD, (uint8_t)descriptor_set};
    return mip_device_send(device, &mip_3dm_message_format_exchange, data, 2);
}

/**
 * Message format: default.
 *
 * - descriptor_set: Data descriptor set; 0 means all of them (save, load, default).
 */
static inline struct mip_result mip_call_3dm_message_format_default(struct mip_device *device,
                                                                    uint8_t descriptor_set) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT, (uint8_t)descriptor_set};
    return mip_device_send(device, &mip_3dm_message_format_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_3dm_factory_streaming);

/** Factory streaming: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_3dm_factory_streaming(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_factory_streaming *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_factory_streaming_command, command,
                           NULL, NULL, now);
}

/**
 * Factory streaming.
 *
 * - action: Treatment of the existing formats. A value of enum mip_3dm_factory_streaming_action.
 */
static inline struct mip_result mip_call_3dm_factory_streaming(
    struct mip_device *device, enum mip_3dm_factory_streaming_action action) {
    const uint8_t data[] = {(uint8_t)action, (uint8_t)0};
    return mip_device_send(device, &mip_3dm_factory_streaming_exchange, data, 2);
}

/** Factory streaming, with these values, including optional parameters. */
static inline struct mip_result mip_call_3dm_factory_streaming_with(
    struct mip_device *device, const struct mip_3dm_factory_streaming *command) {
    return mip_device_call(device, &mip_3dm_factory_streaming_command, command, NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_3dm_data_stream_control);
MIP_SEND(mip_send_3dm_data_stream_control, mip_3dm_data_stream_control,
         mip_3dm_data_stream_control_response);
MIP_CALL_WITH(mip_call_3dm_data_stream_control_with, mip_3dm_data_stream_control,
              mip_3dm_data_stream_control_response);

/**
 * Data stream control: write.
 *
 * - descriptor_set: Data descriptor set; 0 means all streams (save, load, default). On the
 *   3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-GX3-15, 3DM-GX3-25,
 *   3DM-GX4-15, 3DM-GX4-25, 3DM-GX5-25 and 3DM-MV5-AR: values of enum mip_3dm_legacy_data_stream;
 *   only MIP_3DM_LEGACY_DATA_STREAM_ALL_STREAMS, MIP_3DM_LEGACY_DATA_STREAM_IMU and
 *   MIP_3DM_LEGACY_DATA_STREAM_FILTER. On the 3DM-CX5-45, 3DM-DH3, 3DM-GQ4-45, 3DM-GX3-35,
 *   3DM-GX3-45, 3DM-GX4-45, 3DM-GX4-IMU, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and
 *   3DM-RQ1-IMU: values of enum mip_3dm_legacy_data_stream. On the 3DM-GX5-15: values of enum
 *   mip_3dm_legacy_data_stream; only MIP_3DM_LEGACY_DATA_STREAM_IMU and
 *   MIP_3DM_LEGACY_DATA_STREAM_FILTER.
 * - enable: True if the stream is sent. Default: true. Required for write. The stream starts with
 *   current data. What was measured while it was disabled is not sent.
 */
static inline struct mip_result mip_call_3dm_data_stream_control_write(struct mip_device *device,
                                                                       uint8_t descriptor_set,
                                                                       mip_bool enable) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_WRITE, (uint8_t)descriptor_set,
                            (uint8_t)mip_truth(enable)};
    return mip_device_send(device, &mip_3dm_data_stream_control_exchange, data, 3);
}

/**
 * Data stream control: read.
 *
 * - descriptor_set: Data descriptor set; 0 means all streams (save, load, default). On the
 *   3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-GX3-15, 3DM-GX3-25,
 *   3DM-GX4-15, 3DM-GX4-25, 3DM-GX5-25 and 3DM-MV5-AR: values of enum mip_3dm_legacy_data_stream;
 *   only MIP_3DM_LEGACY_DATA_STREAM_ALL_STREAMS, MIP_3DM_LEGACY_DATA_STREAM_IMU and
 *   MIP_3DM_LEGACY_DATA_STREAM_FILTER. On the 3DM-CX5-45, 3DM-DH3, 3DM-GQ4-45, 3DM-GX3-35,
 *   3DM-GX3-45, 3DM-GX4-45, 3DM-GX4-IMU, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and
 *   3DM-RQ1-IMU: values of enum mip_3dm_legacy_data_stream. On the 3DM-GX5-15: values of enum
 *   mip_3dm_legacy_data_stream; only MIP_3DM_LEGACY_DATA_STREAM_IMU and
 *   MIP_3DM_LEGACY_DATA_STREAM_FILTER.
 */
static inline struct mip_result
mip_call_3dm_data_stream_control_read(struct mip_device *device, uint8_t descriptor_set,
                                      struct mip_3dm_data_stream_control_response *response) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_READ, (uint8_t)descriptor_set};
    return mip_device_request(device, &mip_3dm_data_stream_control_exchange, data, 2,
                              &mip_3dm_data_stream_control_response_codec, response);
}

/**
 * Data stream control: save.
 *
 * - descriptor_set: Data descriptor set; 0 means all streams (save, load, default). On the
 *   3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-GX3-15, 3DM-GX3-25,
 *   3DM-GX4-15, 3DM-GX4-25, 3DM-GX5-25 and 3DM-MV5-AR: values of enum mip_3dm_legacy_data_stream;
 *   only MIP_3DM_LEGACY_DATA_STREAM_ALL_STREAMS, MIP_3DM_LEGACY_DATA_STREAM_IMU and
 *   MIP_3DM_LEGACY_DATA_STREAM_FILTER. On the 3DM-CX5-45, 3DM-DH3, 3DM-GQ4-45, 3DM-GX3-35,
 *   3DM-GX3-45, 3DM-GX4-45, 3DM-GX4-IMU, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and
 *   3DM-RQ1-IMU: values of enum mip_3dm_legacy_data_stream. On the 3DM-GX5-15: values of enum
 *   mip_3dm_legacy_data_stream; only MIP_3DM_LEGACY_DATA_STREAM_IMU and
 *   MIP_3DM_LEGACY_DATA_STREAM_FILTER.
 */
static inline struct mip_result mip_call_3dm_data_stream_control_save(struct mip_device *device,
                                                                      uint8_t descriptor_set) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_SAVE, (uint8_t)descriptor_set};
    return mip_device_send(device, &mip_3dm_data_stream_control_exchange, data, 2);
}

/**
 * Data stream control: load.
 *
 * - descriptor_set: Data descriptor set; 0 means all streams (save, load, default). On the
 *   3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-GX3-15, 3DM-GX3-25,
 *   3DM-GX4-15, 3DM-GX4-25, 3DM-GX5-25 and 3DM-MV5-AR: values of enum mip_3dm_legacy_data_stream;
 *   only MIP_3DM_LEGACY_DATA_STREAM_ALL_STREAMS, MIP_3DM_LEGACY_DATA_STREAM_IMU and
 *   MIP_3DM_LEGACY_DATA_STREAM_FILTER. On the 3DM-CX5-45, 3DM-DH3, 3DM-GQ4-45, 3DM-GX3-35,
 *   3DM-GX3-45, 3DM-GX4-45, 3DM-GX4-IMU, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and
 *   3DM-RQ1-IMU: values of enum mip_3dm_legacy_data_stream. On the 3DM-GX5-15: values of enum
 *   mip_3dm_legacy_data_stream; only MIP_3DM_LEGACY_DATA_STREAM_IMU and
 *   MIP_3DM_LEGACY_DATA_STREAM_FILTER.
 */
static inline struct mip_result mip_call_3dm_data_stream_control_load(struct mip_device *device,
                                                                      uint8_t descriptor_set) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_LOAD, (uint8_t)descriptor_set};
    return mip_device_send(device, &mip_3dm_data_stream_control_exchange, data, 2);
}

/**
 * Data stream control: default.
 *
 * - descriptor_set: Data descriptor set; 0 means all streams (save, load, default). On the
 *   3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-GX3-15, 3DM-GX3-25,
 *   3DM-GX4-15, 3DM-GX4-25, 3DM-GX5-25 and 3DM-MV5-AR: values of enum mip_3dm_legacy_data_stream;
 *   only MIP_3DM_LEGACY_DATA_STREAM_ALL_STREAMS, MIP_3DM_LEGACY_DATA_STREAM_IMU and
 *   MIP_3DM_LEGACY_DATA_STREAM_FILTER. On the 3DM-CX5-45, 3DM-DH3, 3DM-GQ4-45, 3DM-GX3-35,
 *   3DM-GX3-45, 3DM-GX4-45, 3DM-GX4-IMU, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and
 *   3DM-RQ1-IMU: values of enum mip_3dm_legacy_data_stream. On the 3DM-GX5-15: values of enum
 *   mip_3dm_legacy_data_stream; only MIP_3DM_LEGACY_DATA_STREAM_IMU and
 *   MIP_3DM_LEGACY_DATA_STREAM_FILTER.
 */
static inline struct mip_result mip_call_3dm_data_stream_control_default(struct mip_device *device,
                                                                         uint8_t descriptor_set) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT, (uint8_t)descriptor_set};
    return mip_device_send(device, &mip_3dm_data_stream_control_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_3dm_raw_rtcm_2_3_message);

/** Raw RTCM 2.3 message: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_3dm_raw_rtcm_2_3_message(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_raw_rtcm_2_3_message *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_raw_rtcm_2_3_message_command, command,
                           NULL, NULL, now);
}

/**
 * Raw RTCM 2.3 message.
 *
 * - data_: Bytes of the RTCM stream.
 */
static inline struct mip_result mip_call_3dm_raw_rtcm_2_3_message(struct mip_device *device,
                                                                  uint8_t data_count,
                                                                  const uint8_t data_[]) {
    struct mip_3dm_raw_rtcm_2_3_message command;
    return mip_device_call(device, &mip_3dm_raw_rtcm_2_3_message_command,
                           mip_3dm_raw_rtcm_2_3_message_make(&command, data_count, data_), NULL,
                           NULL);
}

/** Raw RTCM 2.3 message, with these values, including optional parameters. */
static inline struct mip_result mip_call_3dm_raw_rtcm_2_3_message_with(
    struct mip_device *device, const struct mip_3dm_raw_rtcm_2_3_message *command) {
    return mip_device_call(device, &mip_3dm_raw_rtcm_2_3_message_command, command, NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_3dm_constellation_settings);
MIP_SEND(mip_send_3dm_constellation_settings, mip_3dm_constellation_settings,
         mip_3dm_constellation_settings_response);
MIP_CALL_FOR(mip_call_3dm_constellation_settings_read, mip_3dm_constellation_settings,
             MIP_FUNCTION_SELECTOR_READ, mip_3dm_constellation_settings_response);
MIP_CALL(mip_call_3dm_constellation_settings_save, mip_3dm_constellation_settings,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_3dm_constellation_settings_load, mip_3dm_constellation_settings,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_3dm_constellation_settings_default, mip_3dm_constellation_settings,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_3dm_constellation_settings_with, mip_3dm_constellation_settings,
              mip_3dm_constellation_settings_response);

/**
 * Constellation settings: write.
 *
 * - max_channels: Maximum number of tracking channels in use; at most the number that the response
 *   reports as available. Unit: 1. Required for write.
 * - config_count: Number of entries. Counts the elements of settings. Range: 0 to 41. Required for
 *   write.
 * - settings: One entry for each constellation. Required for write.
 */
MIP_INLINE struct mip_result mip_call_3dm_constellation_settings_write(
    struct mip_device *device, uint16_t max_channels, uint8_t config_count,
    const struct mip_3dm_constellation_settings_entry settings[]) {
    uint8_t data[MIP_MAX_FIELD_DATA];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_16(data + 1, (uint16_t)max_channels);
    mip_put_8(data + 3, (uint8_t)config_count);
    (void)mip_counted(config_count, settings, sizeof(settings[0]));
    for (size_t i = 0; i < config_count && i < 41; i++) {
        mip_put_8(data + 4 + 6 * i, (uint8_t)settings[i].constellation_id);
        mip_put_8(data + 5 + 6 * i, (uint8_t)settings[i].enable);
        mip_put_8(data + 6 + 6 * i, (uint8_t)settings[i].reserved_channels);
        mip_put_8(data + 7 + 6 * i, (uint8_t)settings[i].max_channels);
        mip_put_16(data + 8 + 6 * i, (uint16_t)settings[i].option_flags);
    }
    return mip_device_send(device, &mip_3dm_constellation_settings_exchange, data,
                           config_count <= 41 ? 4 + 6 * (size_t)config_count
                                              : MIP_MAX_FIELD_DATA + 1);
}

MIP_COMMAND_REPLIES(mip_3dm_gnss_sbas_settings);
MIP_SEND(mip_send_3dm_gnss_sbas_settings, mip_3dm_gnss_sbas_settings,
         mip_3dm_gnss_sbas_settings_response);
MIP_CALL_FOR(mip_call_3dm_gnss_sbas_settings_read, mip_3dm_gnss_sbas_settings,
             MIP_FUNCTION_SELECTOR_READ, mip_3dm_gnss_sbas_settings_response);
MIP_CALL(mip_call_3dm_gnss_sbas_settings_save, mip_3dm_gnss_sbas_settings,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_3dm_gnss_sbas_settings_load, mip_3dm_gnss_sbas_settings,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_3dm_gnss_sbas_settings_default, mip_3dm_gnss_sbas_settings,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_3dm_gnss_sbas_settings_with, mip_3dm_gnss_sbas_settings,
              mip_3dm_gnss_sbas_settings_response);

/**
 * GNSS SBAS settings: write.
 *
 * - enable_sbas: 1 enables SBAS, 0 disables it. Range: 0 to 1. Required for write. On the
 *   3DM-GX5-35: default 1.
 * - sbas_options: Purposes of SBAS. Required for write. On the 3DM-GX5-35: default
 *   MIP_3DM_SBAS_OPTIONS_ENABLE_RANGING and MIP_3DM_SBAS_OPTIONS_ENABLE_CORRECTIONS.
 * - num_included_prns: Number of satellites listed; 0 searches for all. Counts the elements of
 *   included_prns. Required for write.
 * - included_prns: PRN numbers of the SBAS satellites to search for. Required for write.
 */
MIP_INLINE struct mip_result mip_call_3dm_gnss_sbas_settings_write(
    struct mip_device *device, uint8_t enable_sbas, mip_3dm_sbas_options sbas_options,
    uint8_t num_included_prns, const uint16_t included_prns[]) {
    uint8_t data[MIP_MAX_FIELD_DATA];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)enable_sbas);
    mip_put_16(data + 2, (uint16_t)sbas_options);
    mip_put_8(data + 4, (uint8_t)num_included_prns);
    (void)mip_counted(num_included_prns, included_prns, sizeof(included_prns[0]));
    for (size_t i = 0; i < num_included_prns && i < 124; i++) {
        mip_put_16(data + 5 + 2 * i, (uint16_t)included_prns[i]);
    }
    return mip_device_send(device, &mip_3dm_gnss_sbas_settings_exchange, data,
                           num_included_prns <= 124 ? 5 + 2 * (size_t)num_included_prns
                                                    : MIP_MAX_FIELD_DATA + 1);
}

MIP_COMMAND_REPLIES(mip_3dm_gnss_assisted_fix);
MIP_SEND(mip_send_3dm_gnss_assisted_fix, mip_3dm_gnss_assisted_fix,
         mip_3dm_gnss_assisted_fix_response);
MIP_CALL_FOR(mip_call_3dm_gnss_assisted_fix_read, mip_3dm_gnss_assisted_fix,
             MIP_FUNCTION_SELECTOR_READ, mip_3dm_gnss_assisted_fix_response);
MIP_CALL(mip_call_3dm_gnss_assisted_fix_save, mip_3dm_gnss_assisted_fix,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_3dm_gnss_assisted_fix_load, mip_3dm_gnss_assisted_fix,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_3dm_gnss_assisted_fix_default, mip_3dm_gnss_assisted_fix,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_3dm_gnss_assisted_fix_with, mip_3dm_gnss_assisted_fix,
              mip_3dm_gnss_assisted_fix_response);

/**
 * GNSS assisted fix: write.
 *
 * - option: Storage of data for a faster first fix. A value of enum mip_3dm_assisted_fix_option.
 *   Default: MIP_3DM_ASSISTED_FIX_OPTION_NONE. Required for write. On the 3DM-GX5-35: default
 *   MIP_3DM_ASSISTED_FIX_OPTION_NONE.
 */
static inline struct mip_result mip_call_3dm_gnss_assisted_fix_write(
    struct mip_device *device, enum mip_3dm_assisted_fix_option option) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_WRITE, (uint8_t)option, (uint8_t)255};
    return mip_device_send(device, &mip_3dm_gnss_assisted_fix_exchange, data, 3);
}

MIP_COMMAND_REPLIES(mip_3dm_gnss_time_assistance);
MIP_SEND(mip_send_3dm_gnss_time_assistance, mip_3dm_gnss_time_assistance,
         mip_3dm_gnss_time_assistance_response);
MIP_CALL_FOR(mip_call_3dm_gnss_time_assistance_read, mip_3dm_gnss_time_assistance,
             MIP_FUNCTION_SELECTOR_READ, mip_3dm_gnss_time_assistance_response);
MIP_CALL_WITH(mip_call_3dm_gnss_time_assistance_with, mip_3dm_gnss_time_assistance,
              mip_3dm_gnss_time_assistance_response);

/**
 * GNSS time assistance: write.
 *
 * - tow: GPS time of week. Unit: s. Range: at least 0, less than 604800. Required for write.
 * - week_number: GPS week number since 1980. Unit: week. Required for write.
 * - accuracy: Estimated accuracy of the time that is sent. Unit: s. Range: at least 0. Required for
 *   write.
 */
static inline struct mip_result mip_call_3dm_gnss_time_assistance_write(struct mip_device *device,
                                                                        double tow,
                                                                        uint16_t week_number,
                                                                        float accuracy) {
    uint8_t data[15];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_double(data + 1, &tow);
    mip_put_16(data + 9, (uint16_t)week_number);
    mip_put_float(data + 11, &accuracy);
    return mip_device_send(device, &mip_3dm_gnss_time_assistance_exchange, data, 15);
}

MIP_COMMAND_REPLIES(mip_3dm_pps_source_control);
MIP_SEND(mip_send_3dm_pps_source_control, mip_3dm_pps_source_control,
         mip_3dm_pps_source_control_response);
MIP_CALL_FOR(mip_call_3dm_pps_source_control_read, mip_3dm_pps_source_control,
             MIP_FUNCTION_SELECTOR_READ, mip_3dm_pps_source_control_response);
MIP_CALL(mip_call_3dm_pps_source_control_save, mip_3dm_pps_source_control,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_3dm_pps_source_control_load, mip_3dm_pps_source_control,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_3dm_pps_source_control_default, mip_3dm_pps_source_control,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_3dm_pps_source_control_with, mip_3dm_pps_source_control,
              mip_3dm_pps_source_control_response);

/**
 * PPS source control: write.
 *
 * - source: Source of the pulse. A value of enum mip_3dm_pps_source. Required for write. On the
 *   3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-INS, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-CX7-INS, 3DM-GV7-AHRS,
 *   3DM-GV7-AR and 3DM-GV7-INS: only MIP_3DM_PPS_SOURCE_DISABLED, MIP_3DM_PPS_SOURCE_GPIO and
 *   MIP_3DM_PPS_SOURCE_GENERATED. On the 3DM-CV7-GNSS/INS: default MIP_3DM_PPS_SOURCE_RECEIVER_1.
 *   On the 3DM-GQ7-GNSS/INS: only MIP_3DM_PPS_SOURCE_DISABLED, MIP_3DM_PPS_SOURCE_RECEIVER_1,
 *   MIP_3DM_PPS_SOURCE_RECEIVER_2, MIP_3DM_PPS_SOURCE_GPIO and MIP_3DM_PPS_SOURCE_GENERATED.
 */
static inline struct mip_result
mip_call_3dm_pps_source_control_write(struct mip_device *device, enum mip_3dm_pps_source source) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_WRITE, (uint8_t)source};
    return mip_device_send(device, &mip_3dm_pps_source_control_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_3dm_get_event_support);
MIP_SEND(mip_send_3dm_get_event_support, mip_3dm_get_event_support,
         mip_3dm_get_event_support_response);
MIP_CALL_WITH(mip_call_3dm_get_event_support_with, mip_3dm_get_event_support,
              mip_3dm_get_event_support_response);

/**
 * Get supported events.
 *
 * - query: Triggers or actions. A value of enum mip_3dm_event_support_query.
 */
static inline struct mip_result
mip_call_3dm_get_event_support(struct mip_device *device, enum mip_3dm_event_support_query query,
                               struct mip_3dm_get_event_support_response *response) {
    const uint8_t data[] = {(uint8_t)query};
    return mip_device_request(device, &mip_3dm_get_event_support_exchange, data, 1,
                              &mip_3dm_get_event_support_response_codec, response);
}

MIP_COMMAND_REPLIES(mip_3dm_event_control);
MIP_SEND(mip_send_3dm_event_control, mip_3dm_event_control, mip_3dm_event_control_response);
MIP_CALL_WITH(mip_call_3dm_event_control_with, mip_3dm_event_control,
              mip_3dm_event_control_response);

/**
 * Event control: write.
 *
 * - instance: Trigger instance; 0 means all configured triggers, except for read.
 * - mode: New mode. A value of enum mip_event_trigger_mode. Default:
 *   MIP_EVENT_TRIGGER_MODE_DISABLED. Required for write.
 */
static inline struct mip_result mip_call_3dm_event_control_write(struct mip_device *device,
                                                                 uint8_t instance,
                                                                 enum mip_event_trigger_mode mode) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_WRITE, (uint8_t)instance, (uint8_t)mode};
    return mip_device_send(device, &mip_3dm_event_control_exchange, data, 3);
}

/**
 * Event control: read.
 *
 * - instance: Trigger instance; 0 means all configured triggers, except for read.
 */
static inline struct mip_result mip_call_3dm_event_control_read(
    struct mip_device *device, uint8_t instance, struct mip_3dm_event_control_response *response) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_READ, (uint8_t)instance};
    return mip_device_request(device, &mip_3dm_event_control_exchange, data, 2,
                              &mip_3dm_event_control_response_codec, response);
}

/**
 * Event control: save.
 *
 * - instance: Trigger instance; 0 means all configured triggers, except for read.
 */
static inline struct mip_result mip_call_3dm_event_control_save(struct mip_device *device,
                                                                uint8_t instance) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_SAVE, (uint8_t)instance};
    return mip_device_send(device, &mip_3dm_event_control_exchange, data, 2);
}

/**
 * Event control: load.
 *
 * - instance: Trigger instance; 0 means all configured triggers, except for read.
 */
static inline struct mip_result mip_call_3dm_event_control_load(struct mip_device *device,
                                                                uint8_t instance) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_LOAD, (uint8_t)instance};
    return mip_device_send(device, &mip_3dm_event_control_exchange, data, 2);
}

/**
 * Event control: default.
 *
 * - instance: Trigger instance; 0 means all configured triggers, except for read.
 */
static inline struct mip_result mip_call_3dm_event_control_default(struct mip_device *device,
                                                                   uint8_t instance) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT, (uint8_t)instance};
    return mip_device_send(device, &mip_3dm_event_control_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_3dm_get_event_trigger_status);
MIP_SEND(mip_send_3dm_get_event_trigger_status, mip_3dm_get_event_trigger_status,
         mip_3dm_get_event_trigger_status_response);
MIP_CALL_WITH(mip_call_3dm_get_event_trigger_status_with, mip_3dm_get_event_trigger_status,
              mip_3dm_get_event_trigger_status_response);

/**
 * Get event trigger status.
 *
 * - requested_count: Number of requested triggers; 0 requests all instances. Counts the elements of
 *   requested_instances.
 * - requested_instances: Numbers of the triggers to report; none for all.
 */
MIP_INLINE struct mip_result mip_call_3dm_get_event_trigger_status(
    struct mip_device *device, uint8_t requested_count, const uint8_t requested_instances[],
    struct mip_3dm_get_event_trigger_status_response *response) {
    uint8_t data[MIP_MAX_FIELD_DATA];
    mip_put_8(data, (uint8_t)requested_count);
    (void)mip_counted(requested_count, requested_instances, sizeof(requested_instances[0]));
    for (size_t i = 0; i < requested_count && i < 252; i++) {
        mip_put_8(data + 1 + 1 * i, (uint8_t)requested_instances[i]);
    }
    return mip_device_request(device, &mip_3dm_get_event_trigger_status_exchange, data,
                              requested_count <= 252 ? 1 + 1 * (size_t)requested_count
                                                     : MIP_MAX_FIELD_DATA + 1,
                              &mip_3dm_get_event_trigger_status_response_codec, response);
}

MIP_COMMAND_REPLIES(mip_3dm_get_event_action_status);
MIP_SEND(mip_send_3dm_get_event_action_status, mip_3dm_get_event_action_status,
         mip_3dm_get_event_action_status_response);
MIP_CALL_WITH(mip_call_3dm_get_event_action_status_with, mip_3dm_get_event_action_status,
              mip_3dm_get_event_action_status_response);

/**
 * Get event action status.
 *
 * - requested_count: Number of requested actions; 0 requests all instances. Counts the elements of
 *   requested_instances.
 * - requested_instances: Numbers of the actions to report; none for all.
 */
MIP_INLINE struct mip_result mip_call_3dm_get_event_action_status(
    struct mip_device *device, uint8_t requested_count, const uint8_t requested_instances[],
    struct mip_3dm_get_event_action_status_response *response) {
    uint8_t data[MIP_MAX_FIELD_DATA];
    mip_put_8(data, (uint8_t)requested_count);
    (void)mip_counted(requested_count, requested_instances, sizeof(requested_instances[0]));
    for (size_t i = 0; i < requested_count && i < 252; i++) {
        mip_put_8(data + 1 + 1 * i, (uint8_t)requested_instances[i]);
    }
    return mip_device_request(device, &mip_3dm_get_event_action_status_exchange, data,
                              requested_count <= 252 ? 1 + 1 * (size_t)requested_count
                                                     : MIP_MAX_FIELD_DATA + 1,
                              &mip_3dm_get_event_action_status_response_codec, response);
}

MIP_COMMAND_REPLIES(mip_3dm_event_trigger_config);
MIP_SEND(mip_send_3dm_event_trigger_config, mip_3dm_event_trigger_config,
         mip_3dm_event_trigger_config_response);
MIP_CALL_WITH(mip_call_3dm_event_trigger_config_with, mip_3dm_event_trigger_config,
              mip_3dm_event_trigger_config_response);

/**
 * Event trigger configuration: write.
 *
 * - instance: Trigger instance; 0 means all (save, load, default).
 * - type: Kind of trigger. A value of enum mip_event_trigger_type. Default:
 *   MIP_EVENT_TRIGGER_TYPE_NONE. Required for write.
 * - parameters: The condition. Selected by type. Required for write. Empty if type is
 *   MIP_EVENT_TRIGGER_TYPE_NONE.
 */
static inline struct mip_result mip_call_3dm_event_trigger_config_write(
    struct mip_device *device, uint8_t instance, enum mip_event_trigger_type type,
    const union mip_3dm_event_trigger_config_parameters *parameters) {
    struct mip_3dm_event_trigger_config command;
    return mip_device_call(device, &mip_3dm_event_trigger_config_command,
                           mip_3dm_event_trigger_config_write(&command, instance, type, parameters),
                           NULL, NULL);
}

/**
 * Event trigger configuration: read.
 *
 * - instance: Trigger instance; 0 means all (save, load, default).
 */
static inline struct mip_result
mip_call_3dm_event_trigger_config_read(struct mip_device *device, uint8_t instance,
                                       struct mip_3dm_event_trigger_config_response *response) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_READ, (uint8_t)instance};
    return mip_device_request(device, &mip_3dm_event_trigger_config_exchange, data, 2,
                              &mip_3dm_event_trigger_config_response_codec, response);
}

/**
 * Event trigger configuration: save.
 *
 * - instance: Trigger instance; 0 means all (save, load, default).
 */
static inline struct mip_result mip_call_3dm_event_trigger_config_save(struct mip_device *device,
                                                                       uint8_t instance) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_SAVE, (uint8_t)instance};
    return mip_device_send(device, &mip_3dm_event_trigger_config_exchange, data, 2);
}

/**
 * Event trigger configuration: load.
 *
 * - instance: Trigger instance; 0 means all (save, load, default).
 */
static inline struct mip_result mip_call_3dm_event_trigger_config_load(struct mip_device *device,
                                                                       uint8_t instance) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_LOAD, (uint8_t)instance};
    return mip_device_send(device, &mip_3dm_event_trigger_config_exchange, data, 2);
}

/**
 * Event trigger configuration: default.
 *
 * - instance: Trigger instance; 0 means all (save, load, default).
 */
static inline struct mip_result mip_call_3dm_event_trigger_config_default(struct mip_device *device,
                                                                          uint8_t instance) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT, (uint8_t)instance};
    return mip_device_send(device, &mip_3dm_event_trigger_config_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_3dm_event_action_config);
MIP_SEND(mip_send_3dm_event_action_config, mip_3dm_event_action_config,
         mip_3dm_event_action_config_response);
MIP_CALL_WITH(mip_call_3dm_event_action_config_with, mip_3dm_event_action_config,
              mip_3dm_event_action_config_response);

/**
 * Event action configuration: write.
 *
 * - instance: Action instance; 0 means all (save, load, default).
 * - trigger: Trigger instance that the action follows. Required for write.
 * - type: Kind of action. A value of enum mip_event_action_type. Default:
 *   MIP_EVENT_ACTION_TYPE_NONE. Required for write.
 * - parameters: Effect of the action. Selected by type. Required for write. Empty if type is
 *   MIP_EVENT_ACTION_TYPE_NONE.
 */
static inline struct mip_result mip_call_3dm_event_action_config_write(
    struct mip_device *device, uint8_t instance, uint8_t trigger, enum mip_event_action_type type,
    const union mip_3dm_event_action_config_parameters *parameters) {
    struct mip_3dm_event_action_config command;
    return mip_device_call(
        device, &mip_3dm_event_action_config_command,
        mip_3dm_event_action_config_write(&command, instance, trigger, type, parameters), NULL,
        NULL);
}

/**
 * Event action configuration: read.
 *
 * - instance: Action instance; 0 means all (save, load, default).
 */
static inline struct mip_result
mip_call_3dm_event_action_config_read(struct mip_device *device, uint8_t instance,
                                      struct mip_3dm_event_action_config_response *response) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_READ, (uint8_t)instance};
    return mip_device_request(device, &mip_3dm_event_action_config_exchange, data, 2,
                              &mip_3dm_event_action_config_response_codec, response);
}

/**
 * Event action configuration: save.
 *
 * - instance: Action instance; 0 means all (save, load, default).
 */
static inline struct mip_result mip_call_3dm_event_action_config_save(struct mip_device *device,
                                                                      uint8_t instance) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_SAVE, (uint8_t)instance};
    return mip_device_send(device, &mip_3dm_event_action_config_exchange, data, 2);
}

/**
 * Event action configuration: load.
 *
 * - instance: Action instance; 0 means all (save, load, default).
 */
static inline struct mip_result mip_call_3dm_event_action_config_load(struct mip_device *device,
                                                                      uint8_t instance) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_LOAD, (uint8_t)instance};
    return mip_device_send(device, &mip_3dm_event_action_config_exchange, data, 2);
}

/**
 * Event action configuration: default.
 *
 * - instance: Action instance; 0 means all (save, load, default).
 */
static inline struct mip_result mip_call_3dm_event_action_config_default(struct mip_device *device,
                                                                         uint8_t instance) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT, (uint8_t)instance};
    return mip_device_send(device, &mip_3dm_event_action_config_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_3dm_device_settings);
MIP_CALL(mip_call_3dm_device_settings_save, mip_3dm_device_settings, MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_3dm_device_settings_load, mip_3dm_device_settings, MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_3dm_device_settings_default, mip_3dm_device_settings,
         MIP_FUNCTION_SELECTOR_DEFAULT);

/** Device start up settings: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_3dm_device_settings(struct mip_client *client,
                                                     struct mip_request *request,
                                                     struct mip_builder *packet,
                                                     const struct mip_3dm_device_settings *command,
                                                     uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_device_settings_command, command, NULL,
                           NULL, now);
}

/** Device start up settings, with these values, including optional parameters. */
static inline struct mip_result mip_call_3dm_device_settings_with(
    struct mip_device *device, const struct mip_3dm_device_settings *command) {
    return mip_device_call(device, &mip_3dm_device_settings_command, command, NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_3dm_sensor_to_vehicle_transform_euler);
MIP_SEND(mip_send_3dm_sensor_to_vehicle_transform_euler, mip_3dm_sensor_to_vehicle_transform_euler,
         mip_3dm_sensor_to_vehicle_transform_euler_response);
MIP_CALL_FOR(mip_call_3dm_sensor_to_vehicle_transform_euler_read,
             mip_3dm_sensor_to_vehicle_transform_euler, MIP_FUNCTION_SELECTOR_READ,
             mip_3dm_sensor_to_vehicle_transform_euler_response);
MIP_CALL(mip_call_3dm_sensor_to_vehicle_transform_euler_save,
         mip_3dm_sensor_to_vehicle_transform_euler, MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_3dm_sensor_to_vehicle_transform_euler_load,
         mip_3dm_sensor_to_vehicle_transform_euler, MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_3dm_sensor_to_vehicle_transform_euler_default,
         mip_3dm_sensor_to_vehicle_transform_euler, MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_3dm_sensor_to_vehicle_transform_euler_with,
              mip_3dm_sensor_to_vehicle_transform_euler,
              mip_3dm_sensor_to_vehicle_transform_euler_response);

/**
 * Sensor-to-vehicle frame transformation Euler: write.
 *
 * - roll: Roll angle of the sensor relative to the vehicle. Unit: rad. Frame: vehicle. Positive:
 *   right side down. Required for write.
 * - pitch: Pitch angle of the sensor relative to the vehicle. Unit: rad. Frame: vehicle. Positive:
 *   nose up. Required for write.
 * - yaw: Yaw angle of the sensor relative to the vehicle. Unit: rad. Frame: vehicle. Positive:
 *   clockwise seen from above. Required for write.
 */
static inline struct mip_result mip_call_3dm_sensor_to_vehicle_transform_euler_write(
    struct mip_device *device, float roll, float pitch, float yaw) {
    uint8_t data[13];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_float(data + 1, &roll);
    mip_put_float(data + 5, &pitch);
    mip_put_float(data + 9, &yaw);
    return mip_device_send(device, &mip_3dm_sensor_to_vehicle_transform_euler_exchange, data, 13);
}

MIP_COMMAND_REPLIES(mip_3dm_sensor_to_vehicle_transform_quaternion);
MIP_SEND(mip_send_3dm_sensor_to_vehicle_transform_quaternion,
         mip_3dm_sensor_to_vehicle_transform_quaternion,
         mip_3dm_sensor_to_vehicle_transform_quaternion_response);
MIP_CALL_FOR(mip_call_3dm_sensor_to_vehicle_transform_quaternion_read,
             mip_3dm_sensor_to_vehicle_transform_quaternion, MIP_FUNCTION_SELECTOR_READ,
             mip_3dm_sensor_to_vehicle_transform_quaternion_response);
MIP_CALL(mip_call_3dm_sensor_to_vehicle_transform_quaternion_save,
         mip_3dm_sensor_to_vehicle_transform_quaternion, MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_3dm_sensor_to_vehicle_transform_quaternion_load,
         mip_3dm_sensor_to_vehicle_transform_quaternion, MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_3dm_sensor_to_vehicle_transform_quaternion_default,
         mip_3dm_sensor_to_vehicle_transform_quaternion, MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_3dm_sensor_to_vehicle_transform_quaternion_with,
              mip_3dm_sensor_to_vehicle_transform_quaternion,
              mip_3dm_sensor_to_vehicle_transform_quaternion_response);

/**
 * Sensor-to-vehicle frame transformation quaternion: write.
 *
 * - q: Rotates vectors of the vehicle frame into the sensor frame; unit quaternion, w first.
 *   Elements: w, x, y, z. Unit: 1. Required for write.
 */
static inline struct mip_result mip_call_3dm_sensor_to_vehicle_transform_quaternion_write(
    struct mip_device *device, const float q[4]) {
    uint8_t data[17];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    for (size_t i = 0; i < 4; i++) {
        mip_put_float(data + 1 + 4 * i, &q[i]);
    }
    return mip_device_send(device, &mip_3dm_sensor_to_vehicle_transform_quaternion_exchange, data,
                           17);
}

MIP_COMMAND_REPLIES(mip_3dm_sensor_to_vehicle_transform_dcm);
MIP_SEND(mip_send_3dm_sensor_to_vehicle_transform_dcm, mip_3dm_sensor_to_vehicle_transform_dcm,
         mip_3dm_sensor_to_vehicle_transform_dcm_response);
MIP_CALL_FOR(mip_call_3dm_sensor_to_vehicle_transform_dcm_read,
             mip_3dm_sensor_to_vehicle_transform_dcm, MIP_FUNCTION_SELECTOR_READ,
             mip_3dm_sensor_to_vehicle_transform_dcm_response);
MIP_CALL(mip_call_3dm_sensor_to_vehicle_transform_dcm_save, mip_3dm_sensor_to_vehicle_transform_dcm,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_3dm_sensor_to_vehicle_transform_dcm_load, mip_3dm_sensor_to_vehicle_transform_dcm,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_3dm_sensor_to_vehicle_transform_dcm_default,
         mip_3dm_sensor_to_vehicle_transform_dcm, MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_3dm_sensor_to_vehicle_transform_dcm_with,
              mip_3dm_sensor_to_vehicle_transform_dcm,
              mip_3dm_sensor_to_vehicle_transform_dcm_response);

/**
 * Sensor-to-vehicle frame transformation direction cosine matrix: write.
 *
 * - dcm: Rotates vectors of the sensor frame into the vehicle frame; row-major. Elements: m11, m12,
 *   m13, m21, m22, m23, m31, m32, m33. Unit: 1. Required for write.
 */
static inline struct mip_result
mip_call_3dm_sensor_to_vehicle_transform_dcm_write(struct mip_device *device, const float dcm[9]) {
    uint8_t data[37];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    for (size_t i = 0; i < 9; i++) {
        mip_put_float(data + 1 + 4 * i, &dcm[i]);
    }
    return mip_device_send(device, &mip_3dm_sensor_to_vehicle_transform_dcm_exchange, data, 37);
}

MIP_COMMAND_REPLIES(mip_3dm_gps_dynamics_mode);
MIP_SEND(mip_send_3dm_gps_dynamics_mode, mip_3dm_gps_dynamics_mode,
         mip_3dm_gps_dynamics_mode_response);
MIP_CALL_FOR(mip_call_3dm_gps_dynamics_mode_read, mip_3dm_gps_dynamics_mode,
             MIP_FUNCTION_SELECTOR_READ, mip_3dm_gps_dynamics_mode_response);
MIP_CALL(mip_call_3dm_gps_dynamics_mode_save, mip_3dm_gps_dynamics_mode,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_3dm_gps_dynamics_mode_load, mip_3dm_gps_dynamics_mode,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_3dm_gps_dynamics_mode_default, mip_3dm_gps_dynamics_mode,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_3dm_gps_dynamics_mode_with, mip_3dm_gps_dynamics_mode,
              mip_3dm_gps_dynamics_mode_response);

/**
 * GPS dynamics mode: write.
 *
 * - mode: Assumed dynamics. A value of enum mip_3dm_receiver_dynamics. Required for write.
 */
static inline struct mip_result mip_call_3dm_gps_dynamics_mode_write(
    struct mip_device *device, enum mip_3dm_receiver_dynamics mode) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_WRITE, (uint8_t)mode};
    return mip_device_send(device, &mip_3dm_gps_dynamics_mode_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_3dm_imu_signal_conditioning);
MIP_SEND(mip_send_3dm_imu_signal_conditioning, mip_3dm_imu_signal_conditioning,
         mip_3dm_imu_signal_conditioning_response);
MIP_CALL_FOR(mip_call_3dm_imu_signal_conditioning_read, mip_3dm_imu_signal_conditioning,
             MIP_FUNCTION_SELECTOR_READ, mip_3dm_imu_signal_conditioning_response);
MIP_CALL(mip_call_3dm_imu_signal_conditioning_save, mip_3dm_imu_signal_conditioning,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_3dm_imu_signal_conditioning_load, mip_3dm_imu_signal_conditioning,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_3dm_imu_signal_conditioning_default, mip_3dm_imu_signal_conditioning,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_3dm_imu_signal_conditioning_with, mip_3dm_imu_signal_conditioning,
              mip_3dm_imu_signal_conditioning_response);

/**
 * IMU signal conditioning: write.
 *
 * - orientation_decimation: Divisor of 1000 Hz that sets the rate at which the orientation is
 *   computed. Unit: 1. Range: 1 to 1000. Required for write.
 * - data_conditioning_flags: Processing steps. Default: 3. Required for write.
 * - inertial_filter_width: Width of the accelerometer and gyroscope filter in samples. Unit: 1.
 *   Range: 1 to 32. Default: 15. Required for write.
 * - mag_filter_width: Width of the magnetometer filter in samples. Unit: 1. Range: 1 to 32.
 *   Default: 17. Required for write.
 * - up_compensation: Time constant of the pitch and roll correction. Unit: s. Range: 1 to 1000.
 *   Default: 10. Required for write.
 * - north_compensation: Time constant of the heading correction. Unit: s. Range: 1 to 1000.
 *   Default: 10. Required for write.
 * - mag_bandwidth: Bandwidth of the magnetometer of 3-series devices. A value of enum
 *   mip_3dm_mag_bandwidth. Required for write.
 */
static inline struct mip_result mip_call_3dm_imu_signal_conditioning_write(
    struct mip_device *device, uint16_t orientation_decimation,
    mip_3dm_data_conditioning_flags data_conditioning_flags, uint8_t inertial_filter_width,
    uint8_t mag_filter_width, uint16_t up_compensation, uint16_t north_compensation,
    enum mip_3dm_mag_bandwidth mag_bandwidth) {
    uint8_t data[14];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_16(data + 1, (uint16_t)orientation_decimation);
    mip_put_16(data + 3, (uint16_t)data_conditioning_flags);
    mip_put_8(data + 5, (uint8_t)inertial_filter_width);
    mip_put_8(data + 6, (uint8_t)mag_filter_width);
    mip_put_16(data + 7, (uint16_t)up_compensation);
    mip_put_16(data + 9, (uint16_t)north_compensation);
    mip_put_8(data + 11, (uint8_t)mag_bandwidth);
    mip_put_16(data + 12, (uint16_t)0);
    return mip_device_send(device, &mip_3dm_imu_signal_conditioning_exchange, data, 14);
}

MIP_COMMAND_REPLIES(mip_3dm_imu_timestamp);
MIP_SEND(mip_send_3dm_imu_timestamp, mip_3dm_imu_timestamp, mip_3dm_imu_timestamp_response);
MIP_CALL_WITH(mip_call_3dm_imu_timestamp_with, mip_3dm_imu_timestamp,
              mip_3dm_imu_timestamp_response);

/**
 * IMU timestamp: write.
 *
 * - selector: Counter to set or read. A value of enum mip_3dm_imu_timestamp_selector.
 * - time: Value of the counter, in the unit that `selector` selects. Required for write.
 */
static inline struct mip_result mip_call_3dm_imu_timestamp_write(
    struct mip_device *device, enum mip_3dm_imu_timestamp_selector selector, uint32_t time) {
    uint8_t data[6];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)selector);
    mip_put_32(data + 2, (uint32_t)time);
    return mip_device_send(device, &mip_3dm_imu_timestamp_exchange, data, 6);
}

/**
 * IMU timestamp: read.
 *
 * - selector: Counter to set or read. A value of enum mip_3dm_imu_timestamp_selector.
 */
static inline struct mip_result mip_call_3dm_imu_timestamp_read(
    struct mip_device *device, enum mip_3dm_imu_timestamp_selector selector,
    struct mip_3dm_imu_timestamp_response *response) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_READ, (uint8_t)selector};
    return mip_device_request(device, &mip_3dm_imu_timestamp_exchange, data, 2,
                              &mip_3dm_imu_timestamp_response_codec, response);
}

MIP_COMMAND_REPLIES(mip_3dm_accel_bias);
MIP_SEND(mip_send_3dm_accel_bias, mip_3dm_accel_bias, mip_3dm_accel_bias_response);
MIP_CALL_FOR(mip_call_3dm_accel_bias_read, mip_3dm_accel_bias, MIP_FUNCTION_SELECTOR_READ,
             mip_3dm_accel_bias_response);
MIP_CALL(mip_call_3dm_accel_bias_save, mip_3dm_accel_bias, MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_3dm_accel_bias_load, mip_3dm_accel_bias, MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_3dm_accel_bias_default, mip_3dm_accel_bias, MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_3dm_accel_bias_with, mip_3dm_accel_bias, mip_3dm_accel_bias_response);

/**
 * Accelerometer bias configuration: write.
 *
 * - bias: Bias that the device subtracts from the measured acceleration. Elements: x, y, z. Unit:
 *   g. Frame: sensor. Required for write and apply.
 */
static inline struct mip_result mip_call_3dm_accel_bias_write(struct mip_device *device,
                                                              const float bias[3]) {
    uint8_t data[13];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 1 + 4 * i, &bias[i]);
    }
    return mip_device_send(device, &mip_3dm_accel_bias_exchange, data, 13);
}

/**
 * Accelerometer bias configuration: apply.
 *
 * - bias: Bias that the device subtracts from the measured acceleration. Elements: x, y, z. Unit:
 *   g. Frame: sensor. Required for write and apply.
 */
static inline struct mip_result mip_call_3dm_accel_bias_apply(struct mip_device *device,
                                                              const float bias[3]) {
    struct mip_3dm_accel_bias command;
    return mip_device_call(device, &mip_3dm_accel_bias_command,
                           mip_3dm_accel_bias_apply(&command, bias), NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_3dm_gyro_bias);
MIP_SEND(mip_send_3dm_gyro_bias, mip_3dm_gyro_bias, mip_3dm_gyro_bias_response);
MIP_CALL_FOR(mip_call_3dm_gyro_bias_read, mip_3dm_gyro_bias, MIP_FUNCTION_SELECTOR_READ,
             mip_3dm_gyro_bias_response);
MIP_CALL(mip_call_3dm_gyro_bias_save, mip_3dm_gyro_bias, MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_3dm_gyro_bias_load, mip_3dm_gyro_bias, MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_3dm_gyro_bias_default, mip_3dm_gyro_bias, MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_3dm_gyro_bias_with, mip_3dm_gyro_bias, mip_3dm_gyro_bias_response);

/**
 * Gyroscope bias configuration: write.
 *
 * - bias: Bias that the device subtracts from the measured angular rate. Elements: x, y, z. Unit:
 *   rad/s. Frame: sensor. Required for write and apply.
 */
static inline struct mip_result mip_call_3dm_gyro_bias_write(struct mip_device *device,
                                                             const float bias[3]) {
    uint8_t data[13];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 1 + 4 * i, &bias[i]);
    }
    return mip_device_send(device, &mip_3dm_gyro_bias_exchange, data, 13);
}

/**
 * Gyroscope bias configuration: apply.
 *
 * - bias: Bias that the device subtracts from the measured angular rate. Elements: x, y, z. Unit:
 *   rad/s. Frame: sensor. Required for write and apply.
 */
static inline struct mip_result mip_call_3dm_gyro_bias_apply(struct mip_device *device,
                                                             const float bias[3]) {
    struct mip_3dm_gyro_bias command;
    return mip_device_call(device, &mip_3dm_gyro_bias_command,
                           mip_3dm_gyro_bias_apply(&command, bias), NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_3dm_capture_gyro_bias);
MIP_SEND(mip_send_3dm_capture_gyro_bias, mip_3dm_capture_gyro_bias, mip_3dm_gyro_bias_response);
MIP_CALL_WITH(mip_call_3dm_capture_gyro_bias_with, mip_3dm_capture_gyro_bias,
              mip_3dm_gyro_bias_response);

/**
 * Capture gyroscope bias.
 *
 * - averaging_time_ms: Time to average over. Unit: ms. Range: 1000 to 30000.
 */
static inline struct mip_result
mip_call_3dm_capture_gyro_bias(struct mip_device *device, uint16_t averaging_time_ms,
                               struct mip_3dm_gyro_bias_response *response) {
    uint8_t data[2];
    mip_put_16(data, (uint16_t)averaging_time_ms);
    return mip_device_request(device, &mip_3dm_capture_gyro_bias_exchange, data, 2,
                              &mip_3dm_gyro_bias_response_codec, response);
}

MIP_COMMAND_REPLIES(mip_3dm_mag_hard_iron_offset);
MIP_SEND(mip_send_3dm_mag_hard_iron_offset, mip_3dm_mag_hard_iron_offset,
         mip_3dm_mag_hard_iron_offset_response);
MIP_CALL_FOR(mip_call_3dm_mag_hard_iron_offset_read, mip_3dm_mag_hard_iron_offset,
             MIP_FUNCTION_SELECTOR_READ, mip_3dm_mag_hard_iron_offset_response);
MIP_CALL(mip_call_3dm_mag_hard_iron_offset_save, mip_3dm_mag_hard_iron_offset,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_3dm_mag_hard_iron_offset_load, mip_3dm_mag_hard_iron_offset,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_3dm_mag_hard_iron_offset_default, mip_3dm_mag_hard_iron_offset,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_3dm_mag_hard_iron_offset_with, mip_3dm_mag_hard_iron_offset,
              mip_3dm_mag_hard_iron_offset_response);

/**
 * Magnetometer hard iron offset: write.
 *
 * - offset: Offset that the device subtracts from the measured magnetic field. Elements: x, y, z.
 *   Unit: gauss. Frame: sensor. Required for write and apply. On the 3DM-GX5-45: default 0, 0, 0.
 */
static inline struct mip_result mip_call_3dm_mag_hard_iron_offset_write(struct mip_device *device,
                                                                        const float offset[3]) {
    uint8_t data[13];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    for (size_t i = 0; i < 3; i++) {
        mip_put_float(data + 1 + 4 * i, &offset[i]);
    }
    return mip_device_send(device, &mip_3dm_mag_hard_iron_offset_exchange, data, 13);
}

/**
 * Magnetometer hard iron offset: apply.
 *
 * - offset: Offset that the device subtracts from the measured magnetic field. Elements: x, y, z.
 *   Unit: gauss. Frame: sensor. Required for write and apply. On the 3DM-GX5-45: default 0, 0, 0.
 */
static inline struct mip_result mip_call_3dm_mag_hard_iron_offset_apply(struct mip_device *device,
                                                                        const float offset[3]) {
    struct mip_3dm_mag_hard_iron_offset command;
    return mip_device_call(device, &mip_3dm_mag_hard_iron_offset_command,
                           mip_3dm_mag_hard_iron_offset_apply(&command, offset), NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_3dm_mag_soft_iron_matrix);
MIP_SEND(mip_send_3dm_mag_soft_iron_matrix, mip_3dm_mag_soft_iron_matrix,
         mip_3dm_mag_soft_iron_matrix_response);
MIP_CALL_FOR(mip_call_3dm_mag_soft_iron_matrix_read, mip_3dm_mag_soft_iron_matrix,
             MIP_FUNCTION_SELECTOR_READ, mip_3dm_mag_soft_iron_matrix_response);
MIP_CALL(mip_call_3dm_mag_soft_iron_matrix_save, mip_3dm_mag_soft_iron_matrix,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_3dm_mag_soft_iron_matrix_load, mip_3dm_mag_soft_iron_matrix,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_3dm_mag_soft_iron_matrix_default, mip_3dm_mag_soft_iron_matrix,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_3dm_mag_soft_iron_matrix_with, mip_3dm_mag_soft_iron_matrix,
              mip_3dm_mag_soft_iron_matrix_response);

/**
 * Magnetometer soft iron matrix: write.
 *
 * - matrix: Soft iron matrix in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32,
 *   m33. Unit: 1. Frame: sensor. Required for write and apply.
 */
static inline struct mip_result mip_call_3dm_mag_soft_iron_matrix_write(struct mip_device *device,
                                                                        const float matrix[9]) {
    uint8_t data[37];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    for (size_t i = 0; i < 9; i++) {
        mip_put_float(data + 1 + 4 * i, &matrix[i]);
    }
    return mip_device_send(device, &mip_3dm_mag_soft_iron_matrix_exchange, data, 37);
}

/**
 * Magnetometer soft iron matrix: apply.
 *
 * - matrix: Soft iron matrix in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32,
 *   m33. Unit: 1. Frame: sensor. Required for write and apply.
 */
static inline struct mip_result mip_call_3dm_mag_soft_iron_matrix_apply(struct mip_device *device,
                                                                        const float matrix[9]) {
    struct mip_3dm_mag_soft_iron_matrix command;
    return mip_device_call(device, &mip_3dm_mag_soft_iron_matrix_command,
                           mip_3dm_mag_soft_iron_matrix_apply(&command, matrix), NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_3dm_coning_sculling_enable);
MIP_SEND(mip_send_3dm_coning_sculling_enable, mip_3dm_coning_sculling_enable,
         mip_3dm_coning_sculling_enable_response);
MIP_CALL_FOR(mip_call_3dm_coning_sculling_enable_read, mip_3dm_coning_sculling_enable,
             MIP_FUNCTION_SELECTOR_READ, mip_3dm_coning_sculling_enable_response);
MIP_CALL(mip_call_3dm_coning_sculling_enable_save, mip_3dm_coning_sculling_enable,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_3dm_coning_sculling_enable_load, mip_3dm_coning_sculling_enable,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_3dm_coning_sculling_enable_default, mip_3dm_coning_sculling_enable,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_3dm_coning_sculling_enable_with, mip_3dm_coning_sculling_enable,
              mip_3dm_coning_sculling_enable_response);

/**
 * Coning and sculling enable: write.
 *
 * - enable: True if the compensation is on. Default: true. Required for write.
 */
static inline struct mip_result mip_call_3dm_coning_sculling_enable_write(struct mip_device *device,
                                                                          mip_bool enable) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_WRITE, (uint8_t)mip_truth(enable)};
    return mip_device_send(device, &mip_3dm_coning_sculling_enable_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_3dm_uart_baud_rate);
MIP_SEND(mip_send_3dm_uart_baud_rate, mip_3dm_uart_baud_rate, mip_3dm_uart_baud_rate_response);
MIP_CALL_FOR(mip_call_3dm_uart_baud_rate_read, mip_3dm_uart_baud_rate, MIP_FUNCTION_SELECTOR_READ,
             mip_3dm_uart_baud_rate_response);
MIP_CALL(mip_call_3dm_uart_baud_rate_save, mip_3dm_uart_baud_rate, MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_3dm_uart_baud_rate_load, mip_3dm_uart_baud_rate, MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_3dm_uart_baud_rate_default, mip_3dm_uart_baud_rate,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_3dm_uart_baud_rate_with, mip_3dm_uart_baud_rate,
              mip_3dm_uart_baud_rate_response);

/**
 * UART baud rate: write.
 *
 * - baud: New baud rate; the port must support it. Unit: Bd. Required for write. On the 3DM-GX5-15
 *   and 3DM-GX5-45: default 115200.
 */
static inline struct mip_result mip_call_3dm_uart_baud_rate_write(struct mip_device *device,
                                                                  uint32_t baud) {
    uint8_t data[5];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_32(data + 1, (uint32_t)baud);
    return mip_device_send(device, &mip_3dm_uart_baud_rate_exchange, data, 5);
}

MIP_COMMAND_REPLIES(mip_3dm_gpio_config);
MIP_SEND(mip_send_3dm_gpio_config, mip_3dm_gpio_config, mip_3dm_gpio_config_response);
MIP_CALL_WITH(mip_call_3dm_gpio_config_with, mip_3dm_gpio_config, mip_3dm_gpio_config_response);

/**
 * GPIO configuration: write.
 *
 * - pin: GPIO pin, counted from 1; 0 means all pins (save, load, default).
 * - feature: Use of the pin. A value of enum mip_gpio_feature. Default: MIP_GPIO_FEATURE_UNUSED.
 *   Required for write.
 * - behavior: Role of the pin within the feature; 0 if the feature has no roles. Required for
 *   write. If feature is MIP_GPIO_FEATURE_UNUSED: values of enum mip_gpio_unused_behavior. If
 *   feature is MIP_GPIO_FEATURE_GPIO: values of enum mip_gpio_behavior. If feature is
 *   MIP_GPIO_FEATURE_PPS: values of enum mip_gpio_pps_behavior. If feature is
 *   MIP_GPIO_FEATURE_ENCODER: values of enum mip_gpio_encoder_behavior. If feature is
 *   MIP_GPIO_FEATURE_TIMESTAMP: values of enum mip_gpio_timestamp_behavior. If feature is
 *   MIP_GPIO_FEATURE_UART: values of enum mip_gpio_uart_behavior.
 * - pin_mode: Electrical options. Required for write.
 */
static inline struct mip_result mip_call_3dm_gpio_config_write(struct mip_device *device,
                                                               uint8_t pin,
                                                               enum mip_gpio_feature feature,
                                                               uint8_t behavior,
                                                               mip_gpio_pin_mode pin_mode) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_WRITE, (uint8_t)pin, (uint8_t)feature,
                            (uint8_t)behavior, (uint8_t)pin_mode};
    return mip_device_send(device, &mip_3dm_gpio_config_exchange, data, 5);
}

/**
 * GPIO configuration: read.
 *
 * - pin: GPIO pin, counted from 1; 0 means all pins (save, load, default).
 */
static inline struct mip_result mip_call_3dm_gpio_config_read(
    struct mip_device *device, uint8_t pin, struct mip_3dm_gpio_config_response *response) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_READ, (uint8_t)pin};
    return mip_device_request(device, &mip_3dm_gpio_config_exchange, data, 2,
                              &mip_3dm_gpio_config_response_codec, response);
}

/**
 * GPIO configuration: save.
 *
 * - pin: GPIO pin, counted from 1; 0 means all pins (save, load, default).
 */
static inline struct mip_result mip_call_3dm_gpio_config_save(struct mip_device *device,
                                                              uint8_t pin) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_SAVE, (uint8_t)pin};
    return mip_device_send(device, &mip_3dm_gpio_config_exchange, data, 2);
}

/**
 * GPIO configuration: load.
 *
 * - pin: GPIO pin, counted from 1; 0 means all pins (save, load, default).
 */
static inline struct mip_result mip_call_3dm_gpio_config_load(struct mip_device *device,
                                                              uint8_t pin) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_LOAD, (uint8_t)pin};
    return mip_device_send(device, &mip_3dm_gpio_config_exchange, data, 2);
}

/**
 * GPIO configuration: default.
 *
 * - pin: GPIO pin, counted from 1; 0 means all pins (save, load, default).
 */
static inline struct mip_result mip_call_3dm_gpio_config_default(struct mip_device *device,
                                                                 uint8_t pin) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT, (uint8_t)pin};
    return mip_device_send(device, &mip_3dm_gpio_config_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_3dm_gpio_state);
MIP_SEND(mip_send_3dm_gpio_state, mip_3dm_gpio_state, mip_3dm_gpio_state_response);
MIP_CALL_WITH(mip_call_3dm_gpio_state_with, mip_3dm_gpio_state, mip_3dm_gpio_state_response);

/**
 * GPIO state: write.
 *
 * - pin: GPIO pin, counted from 1. Range: at least 1.
 * - state: True means high. Required for write.
 */
static inline struct mip_result mip_call_3dm_gpio_state_write(struct mip_device *device,
                                                              uint8_t pin, mip_bool state) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_WRITE, (uint8_t)pin,
                            (uint8_t)mip_truth(state)};
    return mip_device_send(device, &mip_3dm_gpio_state_exchange, data, 3);
}

/**
 * GPIO state: read.
 *
 * - pin: GPIO pin, counted from 1. Range: at least 1.
 */
static inline struct mip_result mip_call_3dm_gpio_state_read(
    struct mip_device *device, uint8_t pin, struct mip_3dm_gpio_state_response *response) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_READ, (uint8_t)pin};
    return mip_device_request(device, &mip_3dm_gpio_state_exchange, data, 2,
                              &mip_3dm_gpio_state_response_codec, response);
}

MIP_COMMAND_REPLIES(mip_3dm_odometer_config);
MIP_SEND(mip_send_3dm_odometer_config, mip_3dm_odometer_config, mip_3dm_odometer_config_response);
MIP_CALL_FOR(mip_call_3dm_odometer_config_read, mip_3dm_odometer_config, MIP_FUNCTION_SELECTOR_READ,
             mip_3dm_odometer_config_response);
MIP_CALL(mip_call_3dm_odometer_config_save, mip_3dm_odometer_config, MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_3dm_odometer_config_load, mip_3dm_odometer_config, MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_3dm_odometer_config_default, mip_3dm_odometer_config,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_3dm_odometer_config_with, mip_3dm_odometer_config,
              mip_3dm_odometer_config_response);

/**
 * Odometer configuration: write.
 *
 * - mode: Operation of the input. A value of enum mip_3dm_odometer_mode. Required for write.
 * - scaling: Pulses per distance travelled; negative if the encoder rotates backwards. Unit:
 *   pulse/m. Required for write. Pulses on line A per turn of the wheel, divided by the
 *   circumference of the wheel.
 * - uncertainty: Relative uncertainty of the scaling, 1 sigma. Unit: 1. Range: at least 0. Required
 *   for write.
 */
static inline struct mip_result mip_call_3dm_odometer_config_write(struct mip_device *device,
                                                                   enum mip_3dm_odometer_mode mode,
                                                                   float scaling,
                                                                   float uncertainty) {
    uint8_t data[10];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)mode);
    mip_put_float(data + 2, &scaling);
    mip_put_float(data + 6, &uncertainty);
    return mip_device_send(device, &mip_3dm_odometer_config_exchange, data, 10);
}

MIP_COMMAND_REPLIES(mip_3dm_imu_low_pass_filter);
MIP_SEND(mip_send_3dm_imu_low_pass_filter, mip_3dm_imu_low_pass_filter,
         mip_3dm_imu_low_pass_filter_response);
MIP_CALL_WITH(mip_call_3dm_imu_low_pass_filter_with, mip_3dm_imu_low_pass_filter,
              mip_3dm_imu_low_pass_filter_response);

/**
 * Advanced low-pass filter settings: write.
 *
 * - target_descriptor: Field descriptor in the sensor data set: scaled acceleration 0x04, angular
 *   rate 0x05, magnetic field 0x06 or pressure 0x17. Refers to fields of MIP_SENSOR_SET. On the
 *   3DM-CV7-GNSS/INS: Field descriptor in the sensor data set: scaled acceleration 0x04, angular
 *   rate 0x05, magnetic field 0x06 or pressure 0x17; 0 means all of them, except for read.
 * - enable: True if the quantity is filtered. Default: true. Required for write.
 * - manual: True uses `frequency`; false uses half the rate of the message format. Default: false.
 *   Required for write.
 * - frequency: Cutoff (-3 dB). It has no meaning if `manual` is false. Unit: Hz. Required for
 *   write. On the 3DM-GX5-15: range at most 250.
 */
static inline struct mip_result mip_call_3dm_imu_low_pass_filter_write(struct mip_device *device,
                                                                       uint8_t target_descriptor,
                                                                       mip_bool enable,
                                                                       mip_bool manual,
                                                                       uint16_t frequency) {
    uint8_t data[7];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)target_descriptor);
    mip_put_8(data + 2, (uint8_t)mip_truth(enable));
    mip_put_8(data + 3, (uint8_t)mip_truth(manual));
    mip_put_16(data + 4, (uint16_t)frequency);
    mip_put_8(data + 6, (uint8_t)0);
    return mip_device_send(device, &mip_3dm_imu_low_pass_filter_exchange, data, 7);
}

/**
 * Advanced low-pass filter settings: read.
 *
 * - target_descriptor: Field descriptor in the sensor data set: scaled acceleration 0x04, angular
 *   rate 0x05, magnetic field 0x06 or pressure 0x17. Refers to fields of MIP_SENSOR_SET. On the
 *   3DM-CV7-GNSS/INS: Field descriptor in the sensor data set: scaled acceleration 0x04, angular
 *   rate 0x05, magnetic field 0x06 or pressure 0x17; 0 means all of them, except for read.
 */
static inline struct mip_result
mip_call_3dm_imu_low_pass_filter_read(struct mip_device *device, uint8_t target_descriptor,
                                      struct mip_3dm_imu_low_pass_filter_response *response) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_READ, (uint8_t)target_descriptor};
    return mip_device_request(device, &mip_3dm_imu_low_pass_filter_exchange, data, 2,
                              &mip_3dm_imu_low_pass_filter_response_codec, response);
}

/**
 * Advanced low-pass filter settings: save.
 *
 * - target_descriptor: Field descriptor in the sensor data set: scaled acceleration 0x04, angular
 *   rate 0x05, magnetic field 0x06 or pressure 0x17. Refers to fields of MIP_SENSOR_SET. On the
 *   3DM-CV7-GNSS/INS: Field descriptor in the sensor data set: scaled acceleration 0x04, angular
 *   rate 0x05, magnetic field 0x06 or pressure 0x17; 0 means all of them, except for read.
 */
static inline struct mip_result mip_call_3dm_imu_low_pass_filter_save(struct mip_device *device,
                                                                      uint8_t target_descriptor) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_SAVE, (uint8_t)target_descriptor};
    return mip_device_send(device, &mip_3dm_imu_low_pass_filter_exchange, data, 2);
}

/**
 * Advanced low-pass filter settings: load.
 *
 * - target_descriptor: Field descriptor in the sensor data set: scaled acceleration 0x04, angular
 *   rate 0x05, magnetic field 0x06 or pressure 0x17. Refers to fields of MIP_SENSOR_SET. On the
 *   3DM-CV7-GNSS/INS: Field descriptor in the sensor data set: scaled acceleration 0x04, angular
 *   rate 0x05, magnetic field 0x06 or pressure 0x17; 0 means all of them, except for read.
 */
static inline struct mip_result mip_call_3dm_imu_low_pass_filter_load(struct mip_device *device,
                                                                      uint8_t target_descriptor) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_LOAD, (uint8_t)target_descriptor};
    return mip_device_send(device, &mip_3dm_imu_low_pass_filter_exchange, data, 2);
}

/**
 * Advanced low-pass filter settings: default.
 *
 * - target_descriptor: Field descriptor in the sensor data set: scaled acceleration 0x04, angular
 *   rate 0x05, magnetic field 0x06 or pressure 0x17. Refers to fields of MIP_SENSOR_SET. On the
 *   3DM-CV7-GNSS/INS: Field descriptor in the sensor data set: scaled acceleration 0x04, angular
 *   rate 0x05, magnetic field 0x06 or pressure 0x17; 0 means all of them, except for read.
 */
static inline struct mip_result
mip_call_3dm_imu_low_pass_filter_default(struct mip_device *device, uint8_t target_descriptor) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT, (uint8_t)target_descriptor};
    return mip_device_send(device, &mip_3dm_imu_low_pass_filter_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_3dm_complementary_filter);
MIP_SEND(mip_send_3dm_complementary_filter, mip_3dm_complementary_filter,
         mip_3dm_complementary_filter_response);
MIP_CALL_FOR(mip_call_3dm_complementary_filter_read, mip_3dm_complementary_filter,
             MIP_FUNCTION_SELECTOR_READ, mip_3dm_complementary_filter_response);
MIP_CALL(mip_call_3dm_complementary_filter_save, mip_3dm_complementary_filter,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_3dm_complementary_filter_load, mip_3dm_complementary_filter,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_3dm_complementary_filter_default, mip_3dm_complementary_filter,
         MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_3dm_complementary_filter_with, mip_3dm_complementary_filter,
              mip_3dm_complementary_filter_response);

/**
 * Complementary filter configuration: write.
 *
 * - pitch_roll_enable: True enables the pitch and roll correction, which 5-series manuals call up
 *   compensation. Required for write. On the 3DM-GX5-15: default true.
 * - heading_enable: True enables the heading correction, which 5-series manuals call north
 *   compensation. Required for write. On the 3DM-CV5-10, 3DM-CV5-15, 3DM-CX5-10 and 3DM-CX5-15:
 *   MSCL has no support for it. On the 3DM-GX5-15: default true.
 * - pitch_roll_time_constant: Time constant of the pitch and roll correction. Unit: s. Range: 1 to
 *   1000. Default: 10. Required for write.
 * - heading_time_constant: Time constant of the heading correction. Unit: s. Range: 1 to 1000.
 *   Default: 10. Required for write.
 */
static inline struct mip_result mip_call_3dm_complementary_filter_write(
    struct mip_device *device, mip_bool pitch_roll_enable, mip_bool heading_enable,
    float pitch_roll_time_constant, float heading_time_constant) {
    uint8_t data[11];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)mip_truth(pitch_roll_enable));
    mip_put_8(data + 2, (uint8_t)mip_truth(heading_enable));
    mip_put_float(data + 3, &pitch_roll_time_constant);
    mip_put_float(data + 7, &heading_time_constant);
    return mip_device_send(device, &mip_3dm_complementary_filter_exchange, data, 11);
}

MIP_COMMAND_REPLIES(mip_3dm_sensor_range);
MIP_SEND(mip_send_3dm_sensor_range, mip_3dm_sensor_range, mip_3dm_sensor_range_response);
MIP_CALL_WITH(mip_call_3dm_sensor_range_with, mip_3dm_sensor_range, mip_3dm_sensor_range_response);

/**
 * Sensor range: write.
 *
 * - sensor: Sensor whose range is set or read. A value of enum mip_3dm_sensor_range_type. On the
 *   3DM-CV7-AR, 3DM-CX7-AR and 3DM-GV7-AR: only MIP_3DM_SENSOR_RANGE_TYPE_ALL,
 *   MIP_3DM_SENSOR_RANGE_TYPE_ACCEL, MIP_3DM_SENSOR_RANGE_TYPE_GYRO and
 *   MIP_3DM_SENSOR_RANGE_TYPE_PRESSURE.
 * - setting: Number of the range. Required for write.
 */
static inline struct mip_result mip_call_3dm_sensor_range_write(
    struct mip_device *device, enum mip_3dm_sensor_range_type sensor, uint8_t setting) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_WRITE, (uint8_t)sensor,
                            (uint8_t)setting};
    return mip_device_send(device, &mip_3dm_sensor_range_exchange, data, 3);
}

/**
 * Sensor range: read.
 *
 * - sensor: Sensor whose range is set or read. A value of enum mip_3dm_sensor_range_type. On the
 *   3DM-CV7-AR, 3DM-CX7-AR and 3DM-GV7-AR: only MIP_3DM_SENSOR_RANGE_TYPE_ALL,
 *   MIP_3DM_SENSOR_RANGE_TYPE_ACCEL, MIP_3DM_SENSOR_RANGE_TYPE_GYRO and
 *   MIP_3DM_SENSOR_RANGE_TYPE_PRESSURE.
 */
static inline struct mip_result
mip_call_3dm_sensor_range_read(struct mip_device *device, enum mip_3dm_sensor_range_type sensor,
                               struct mip_3dm_sensor_range_response *response) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_READ, (uint8_t)sensor};
    return mip_device_request(device, &mip_3dm_sensor_range_exchange, data, 2,
                              &mip_3dm_sensor_range_response_codec, response);
}

/**
 * Sensor range: save.
 *
 * - sensor: Sensor whose range is set or read. A value of enum mip_3dm_sensor_range_type. On the
 *   3DM-CV7-AR, 3DM-CX7-AR and 3DM-GV7-AR: only MIP_3DM_SENSOR_RANGE_TYPE_ALL,
 *   MIP_3DM_SENSOR_RANGE_TYPE_ACCEL, MIP_3DM_SENSOR_RANGE_TYPE_GYRO and
 *   MIP_3DM_SENSOR_RANGE_TYPE_PRESSURE.
 */
static inline struct mip_result
mip_call_3dm_sensor_range_save(struct mip_device *device, enum mip_3dm_sensor_range_type sensor) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_SAVE, (uint8_t)sensor};
    return mip_device_send(device, &mip_3dm_sensor_range_exchange, data, 2);
}

/**
 * Sensor range: load.
 *
 * - sensor: Sensor whose range is set or read. A value of enum mip_3dm_sensor_range_type. On the
 *   3DM-CV7-AR, 3DM-CX7-AR and 3DM-GV7-AR: only MIP_3DM_SENSOR_RANGE_TYPE_ALL,
 *   MIP_3DM_SENSOR_RANGE_TYPE_ACCEL, MIP_3DM_SENSOR_RANGE_TYPE_GYRO and
 *   MIP_3DM_SENSOR_RANGE_TYPE_PRESSURE.
 */
static inline struct mip_result
mip_call_3dm_sensor_range_load(struct mip_device *device, enum mip_3dm_sensor_range_type sensor) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_LOAD, (uint8_t)sensor};
    return mip_device_send(device, &mip_3dm_sensor_range_exchange, data, 2);
}

/**
 * Sensor range: default.
 *
 * - sensor: Sensor whose range is set or read. A value of enum mip_3dm_sensor_range_type. On the
 *   3DM-CV7-AR, 3DM-CX7-AR and 3DM-GV7-AR: only MIP_3DM_SENSOR_RANGE_TYPE_ALL,
 *   MIP_3DM_SENSOR_RANGE_TYPE_ACCEL, MIP_3DM_SENSOR_RANGE_TYPE_GYRO and
 *   MIP_3DM_SENSOR_RANGE_TYPE_PRESSURE.
 */
static inline struct mip_result mip_call_3dm_sensor_range_default(
    struct mip_device *device, enum mip_3dm_sensor_range_type sensor) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT, (uint8_t)sensor};
    return mip_device_send(device, &mip_3dm_sensor_range_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_3dm_get_calibrated_sensor_ranges);
MIP_SEND(mip_send_3dm_get_calibrated_sensor_ranges, mip_3dm_get_calibrated_sensor_ranges,
         mip_3dm_get_calibrated_sensor_ranges_response);
MIP_CALL_WITH(mip_call_3dm_get_calibrated_sensor_ranges_with, mip_3dm_get_calibrated_sensor_ranges,
              mip_3dm_get_calibrated_sensor_ranges_response);

/**
 * Get calibrated sensor ranges.
 *
 * - sensor: Sensor to query; `all` is not allowed. A value of enum mip_3dm_sensor_range_type. On
 *   the 3DM-CV7-AR, 3DM-CX7-AR and 3DM-GV7-AR: only MIP_3DM_SENSOR_RANGE_TYPE_ALL,
 *   MIP_3DM_SENSOR_RANGE_TYPE_ACCEL, MIP_3DM_SENSOR_RANGE_TYPE_GYRO and
 *   MIP_3DM_SENSOR_RANGE_TYPE_PRESSURE.
 */
static inline struct mip_result mip_call_3dm_get_calibrated_sensor_ranges(
    struct mip_device *device, enum mip_3dm_sensor_range_type sensor,
    struct mip_3dm_get_calibrated_sensor_ranges_response *response) {
    const uint8_t data[] = {(uint8_t)sensor};
    return mip_device_request(device, &mip_3dm_get_calibrated_sensor_ranges_exchange, data, 1,
                              &mip_3dm_get_calibrated_sensor_ranges_response_codec, response);
}

MIP_COMMAND_REPLIES(mip_3dm_low_pass_filter);
MIP_SEND(mip_send_3dm_low_pass_filter, mip_3dm_low_pass_filter, mip_3dm_low_pass_filter_response);
MIP_CALL_WITH(mip_call_3dm_low_pass_filter_with, mip_3dm_low_pass_filter,
              mip_3dm_low_pass_filter_response);

/**
 * Low-pass anti-aliasing filter: write.
 *
 * - descriptor_set: Descriptor set of the field.
 * - field_descriptor: Field descriptor; 0 if the set is 0. Refers to fields of descriptor_set.
 * - enable: True if the field is filtered. Required for write.
 * - manual: True uses `frequency`; false uses half the rate of the field in the message format.
 *   Required for write.
 * - frequency: Cutoff; a write ignores it if `manual` is false, a read returns the cutoff in use.
 *   Unit: Hz. Range: at least 0. Required for write.
 */
static inline struct mip_result mip_call_3dm_low_pass_filter_write(struct mip_device *device,
                                                                   uint8_t descriptor_set,
                                                                   uint8_t field_descriptor,
                                                                   mip_bool enable, mip_bool manual,
                                                                   float frequency) {
    uint8_t data[9];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)descriptor_set);
    mip_put_8(data + 2, (uint8_t)field_descriptor);
    mip_put_8(data + 3, (uint8_t)mip_truth(enable));
    mip_put_8(data + 4, (uint8_t)mip_truth(manual));
    mip_put_float(data + 5, &frequency);
    return mip_device_send(device, &mip_3dm_low_pass_filter_exchange, data, 9);
}

/**
 * Low-pass anti-aliasing filter: read.
 *
 * - descriptor_set: Descriptor set of the field.
 * - field_descriptor: Field descriptor; 0 if the set is 0. Refers to fields of descriptor_set.
 */
static inline struct mip_result mip_call_3dm_low_pass_filter_read(
    struct mip_device *device, uint8_t descriptor_set, uint8_t field_descriptor,
    struct mip_3dm_low_pass_filter_response *response) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_READ, (uint8_t)descriptor_set,
                            (uint8_t)field_descriptor};
    return mip_device_request(device, &mip_3dm_low_pass_filter_exchange, data, 3,
                              &mip_3dm_low_pass_filter_response_codec, response);
}

/**
 * Low-pass anti-aliasing filter: save.
 *
 * - descriptor_set: Descriptor set of the field.
 * - field_descriptor: Field descriptor; 0 if the set is 0. Refers to fields of descriptor_set.
 */
static inline struct mip_result mip_call_3dm_low_pass_filter_save(struct mip_device *device,
                                                                  uint8_t descriptor_set,
                                                                  uint8_t field_descriptor) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_SAVE, (uint8_t)descriptor_set,
                            (uint8_t)field_descriptor};
    return mip_device_send(device, &mip_3dm_low_pass_filter_exchange, data, 3);
}

/**
 * Low-pass anti-aliasing filter: load.
 *
 * - descriptor_set: Descriptor set of the field.
 * - field_descriptor: Field descriptor; 0 if the set is 0. Refers to fields of descriptor_set.
 */
static inline struct mip_result mip_call_3dm_low_pass_filter_load(struct mip_device *device,
                                                                  uint8_t descriptor_set,
                                                                  uint8_t field_descriptor) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_LOAD, (uint8_t)descriptor_set,
                            (uint8_t)field_descriptor};
    return mip_device_send(device, &mip_3dm_low_pass_filter_exchange, data, 3);
}

/**
 * Low-pass anti-aliasing filter: default.
 *
 * - descriptor_set: Descriptor set of the field.
 * - field_descriptor: Field descriptor; 0 if the set is 0. Refers to fields of descriptor_set.
 */
static inline struct mip_result mip_call_3dm_low_pass_filter_default(struct mip_device *device,
                                                                     uint8_t descriptor_set,
                                                                     uint8_t field_descriptor) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT, (uint8_t)descriptor_set,
                            (uint8_t)field_descriptor};
    return mip_device_send(device, &mip_3dm_low_pass_filter_exchange, data, 3);
}

MIP_COMMAND_REPLIES(mip_3dm_data_stream_format);
MIP_SEND(mip_send_3dm_data_stream_format, mip_3dm_data_stream_format,
         mip_3dm_data_stream_format_response);
MIP_CALL_WITH(mip_call_3dm_data_stream_format_with, mip_3dm_data_stream_format,
              mip_3dm_data_stream_format_response);

/**
 * Data stream format: write.
 *
 * - stream: Stream whose format is set or read. A value of enum mip_3dm_internal_sensor.
 * - format: Format of a data stream. A value of enum mip_3dm_stream_format.
 */
static inline struct mip_result mip_call_3dm_data_stream_format_write(
    struct mip_device *device, enum mip_3dm_internal_sensor stream,
    enum mip_3dm_stream_format format) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_WRITE, (uint8_t)stream, (uint8_t)format};
    return mip_device_send(device, &mip_3dm_data_stream_format_exchange, data, 3);
}

/**
 * Data stream format: read.
 *
 * - stream: Stream whose format is set or read. A value of enum mip_3dm_internal_sensor.
 * - format: Format of a data stream. A value of enum mip_3dm_stream_format.
 */
static inline struct mip_result mip_call_3dm_data_stream_format_read(
    struct mip_device *device, enum mip_3dm_internal_sensor stream,
    enum mip_3dm_stream_format format, struct mip_3dm_data_stream_format_response *response) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_READ, (uint8_t)stream, (uint8_t)format};
    return mip_device_request(device, &mip_3dm_data_stream_format_exchange, data, 3,
                              &mip_3dm_data_stream_format_response_codec, response);
}

/**
 * Data stream format: save.
 *
 * - stream: Stream whose format is set or read. A value of enum mip_3dm_internal_sensor.
 * - format: Format of a data stream. A value of enum mip_3dm_stream_format.
 */
static inline struct mip_result
mip_call_3dm_data_stream_format_save(struct mip_device *device, enum mip_3dm_internal_sensor stream,
                                     enum mip_3dm_stream_format format) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_SAVE, (uint8_t)stream, (uint8_t)format};
    return mip_device_send(device, &mip_3dm_data_stream_format_exchange, data, 3);
}

/**
 * Data stream format: load.
 *
 * - stream: Stream whose format is set or read. A value of enum mip_3dm_internal_sensor.
 * - format: Format of a data stream. A value of enum mip_3dm_stream_format.
 */
static inline struct mip_result
mip_call_3dm_data_stream_format_load(struct mip_device *device, enum mip_3dm_internal_sensor stream,
                                     enum mip_3dm_stream_format format) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_LOAD, (uint8_t)stream, (uint8_t)format};
    return mip_device_send(device, &mip_3dm_data_stream_format_exchange, data, 3);
}

/**
 * Data stream format: default.
 *
 * - stream: Stream whose format is set or read. A value of enum mip_3dm_internal_sensor.
 * - format: Format of a data stream. A value of enum mip_3dm_stream_format.
 */
static inline struct mip_result mip_call_3dm_data_stream_format_default(
    struct mip_device *device, enum mip_3dm_internal_sensor stream,
    enum mip_3dm_stream_format format) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT, (uint8_t)stream,
                            (uint8_t)format};
    return mip_device_send(device, &mip_3dm_data_stream_format_exchange, data, 3);
}

MIP_COMMAND_REPLIES(mip_3dm_device_power_state);
MIP_SEND(mip_send_3dm_device_power_state, mip_3dm_device_power_state,
         mip_3dm_device_power_state_response);
MIP_CALL_WITH(mip_call_3dm_device_power_state_with, mip_3dm_device_power_state,
              mip_3dm_device_power_state_response);

/**
 * Device power state: write.
 *
 * - device_: The sensor. A value of enum mip_3dm_internal_sensor. On the 3DM-GX3-15 and 3DM-GX3-25:
 *   only MIP_3DM_INTERNAL_SENSOR_IMU.
 * - state: Power state of an internal sensor. A value of enum mip_3dm_sensor_power_state. Required
 *   for write.
 */
static inline struct mip_result mip_call_3dm_device_power_state_write(
    struct mip_device *device, enum mip_3dm_internal_sensor device_,
    enum mip_3dm_sensor_power_state state) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_WRITE, (uint8_t)device_, (uint8_t)state};
    return mip_device_send(device, &mip_3dm_device_power_state_exchange, data, 3);
}

/**
 * Device power state: read.
 *
 * - device_: The sensor. A value of enum mip_3dm_internal_sensor. On the 3DM-GX3-15 and 3DM-GX3-25:
 *   only MIP_3DM_INTERNAL_SENSOR_IMU.
 */
static inline struct mip_result mip_call_3dm_device_power_state_read(
    struct mip_device *device, enum mip_3dm_internal_sensor device_,
    struct mip_3dm_device_power_state_response *response) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_READ, (uint8_t)device_};
    return mip_device_request(device, &mip_3dm_device_power_state_exchange, data, 2,
                              &mip_3dm_device_power_state_response_codec, response);
}

/**
 * Device power state: save.
 *
 * - device_: The sensor. A value of enum mip_3dm_internal_sensor. On the 3DM-GX3-15 and 3DM-GX3-25:
 *   only MIP_3DM_INTERNAL_SENSOR_IMU.
 */
static inline struct mip_result mip_call_3dm_device_power_state_save(
    struct mip_device *device, enum mip_3dm_internal_sensor device_) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_SAVE, (uint8_t)device_};
    return mip_device_send(device, &mip_3dm_device_power_state_exchange, data, 2);
}

/**
 * Device power state: load.
 *
 * - device_: The sensor. A value of enum mip_3dm_internal_sensor. On the 3DM-GX3-15 and 3DM-GX3-25:
 *   only MIP_3DM_INTERNAL_SENSOR_IMU.
 */
static inline struct mip_result mip_call_3dm_device_power_state_load(
    struct mip_device *device, enum mip_3dm_internal_sensor device_) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_LOAD, (uint8_t)device_};
    return mip_device_send(device, &mip_3dm_device_power_state_exchange, data, 2);
}

/**
 * Device power state: default.
 *
 * - device_: The sensor. A value of enum mip_3dm_internal_sensor. On the 3DM-GX3-15 and 3DM-GX3-25:
 *   only MIP_3DM_INTERNAL_SENSOR_IMU.
 */
static inline struct mip_result mip_call_3dm_device_power_state_default(
    struct mip_device *device, enum mip_3dm_internal_sensor device_) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT, (uint8_t)device_};
    return mip_device_send(device, &mip_3dm_device_power_state_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_3dm_gps_advanced_settings);
MIP_CALL(mip_call_3dm_gps_advanced_settings_save, mip_3dm_gps_advanced_settings,
         MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_3dm_gps_advanced_settings_load, mip_3dm_gps_advanced_settings,
         MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_3dm_gps_advanced_settings_default, mip_3dm_gps_advanced_settings,
         MIP_FUNCTION_SELECTOR_DEFAULT);

/** GPS advanced settings: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_3dm_gps_advanced_settings(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_gps_advanced_settings *command, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_gps_advanced_settings_command, command,
                           NULL, NULL, now);
}

/** GPS advanced settings, with these values, including optional parameters. */
static inline struct mip_result mip_call_3dm_gps_advanced_settings_with(
    struct mip_device *device, const struct mip_3dm_gps_advanced_settings *command) {
    return mip_device_call(device, &mip_3dm_gps_advanced_settings_command, command, NULL, NULL);
}

MIP_COMMAND_REPLIES(mip_3dm_device_status);

/** Device status: adds the command to a packet. See mip_client_send. */
static inline mip_error mip_send_3dm_device_status(struct mip_client *client,
                                                   struct mip_request *request,
                                                   struct mip_builder *packet,
                                                   const struct mip_3dm_device_status *command,
                                                   uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_device_status_command, command, NULL,
                           NULL, now);
}

/** Device status: adds the command to a packet. Expects this response. See mip_client_send. */
static inline mip_error mip_send_for_3dm_device_status_basic_rq1_imu_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_device_status *command,
    struct mip_3dm_device_status_basic_rq1_imu_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_device_status_command, command,
                           &mip_3dm_device_status_basic_rq1_imu_response_codec, response, now);
}

/** Device status: adds the command to a packet. Expects this response. See mip_client_send. */
static inline mip_error mip_send_for_3dm_device_status_basic_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_device_status *command,
    struct mip_3dm_device_status_basic_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_device_status_command, command,
                           &mip_3dm_device_status_basic_response_codec, response, now);
}

/** Device status: adds the command to a packet. Expects this response. See mip_client_send. */
static inline mip_error mip_send_for_3dm_device_status_basic_without_state_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_device_status *command,
    struct mip_3dm_device_status_basic_without_state_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_device_status_command, command,
                           &mip_3dm_device_status_basic_without_state_response_codec, response,
                           now);
}

/** Device status: adds the command to a packet. Expects this response. See mip_client_send. */
static inline mip_error mip_send_for_3dm_device_status_diagnostic_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_device_status *command,
    struct mip_3dm_device_status_diagnostic_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_device_status_command, command,
                           &mip_3dm_device_status_diagnostic_response_codec, response, now);
}

/** Device status: adds the command to a packet. Expects this response. See mip_client_send. */
static inline mip_error mip_send_for_3dm_device_status_diagnostic_gnss_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_device_status *command,
    struct mip_3dm_device_status_diagnostic_gnss_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_device_status_command, command,
                           &mip_3dm_device_status_diagnostic_gnss_response_codec, response, now);
}

/** Device status: adds the command to a packet. Expects this response. See mip_client_send. */
static inline mip_error mip_send_for_3dm_device_status_diagnostic_gq4_45_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_device_status *command,
    struct mip_3dm_device_status_diagnostic_gq4_45_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_device_status_command, command,
                           &mip_3dm_device_status_diagnostic_gq4_45_response_codec, response, now);
}

/** Device status: adds the command to a packet. Expects this response. See mip_client_send. */
static inline mip_error mip_send_for_3dm_device_status_diagnostic_rq1_45_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_device_status *command,
    struct mip_3dm_device_status_diagnostic_rq1_45_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_device_status_command, command,
                           &mip_3dm_device_status_diagnostic_rq1_45_response_codec, response, now);
}

/** Device status: adds the command to a packet. Expects this response. See mip_client_send. */
static inline mip_error mip_send_for_3dm_device_status_diagnostic_gx4_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_device_status *command,
    struct mip_3dm_device_status_diagnostic_gx4_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_device_status_command, command,
                           &mip_3dm_device_status_diagnostic_gx4_response_codec, response, now);
}

/** Device status: adds the command to a packet. Expects this response. See mip_client_send. */
static inline mip_error mip_send_for_3dm_device_status_diagnostic_imu_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_device_status *command,
    struct mip_3dm_device_status_diagnostic_imu_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_device_status_command, command,
                           &mip_3dm_device_status_diagnostic_imu_response_codec, response, now);
}

/** Device status: adds the command to a packet. Expects this response. See mip_client_send. */
static inline mip_error mip_send_for_3dm_device_status_diagnostic_gx4_imu_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_device_status *command,
    struct mip_3dm_device_status_diagnostic_gx4_imu_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_device_status_command, command,
                           &mip_3dm_device_status_diagnostic_gx4_imu_response_codec, response, now);
}

/** Device status: adds the command to a packet. Expects this response. See mip_client_send. */
static inline mip_error mip_send_for_3dm_device_status_diagnostic_rq1_imu_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_device_status *command,
    struct mip_3dm_device_status_diagnostic_rq1_imu_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_device_status_command, command,
                           &mip_3dm_device_status_diagnostic_rq1_imu_response_codec, response, now);
}

/** Device status: adds the command to a packet. Expects this response. See mip_client_send. */
static inline mip_error mip_send_for_3dm_device_status_basic_gx3_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_device_status *command,
    struct mip_3dm_device_status_basic_gx3_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_device_status_command, command,
                           &mip_3dm_device_status_basic_gx3_response_codec, response, now);
}

/** Device status: adds the command to a packet. Expects this response. See mip_client_send. */
static inline mip_error mip_send_for_3dm_device_status_diagnostic_gx3_response(
    struct mip_client *client, struct mip_request *request, struct mip_builder *packet,
    const struct mip_3dm_device_status *command,
    struct mip_3dm_device_status_diagnostic_gx3_response *response, uint32_t now) {
    return mip_client_send(client, request, packet, &mip_3dm_device_status_command, command,
                           &mip_3dm_device_status_diagnostic_gx3_response_codec, response, now);
}

/**
 * Device status.
 *
 * - model_number: Model number of the device that replies. On the 3DM-GX5-15: always 6254. On the
 *   3DM-GX5-35: always 6252. On the 3DM-GX5-45: always 6251.
 * - status_selector: Level of detail of the reply. A value of enum mip_3dm_device_status_selector.
 */
static inline struct mip_result
mip_call_3dm_device_status(struct mip_device *device, uint16_t model_number,
                           enum mip_3dm_device_status_selector status_selector) {
    struct mip_3dm_device_status command;
    return mip_device_call(device, &mip_3dm_device_status_command,
                           mip_3dm_device_status_make(&command, model_number, status_selector),
                           NULL, NULL);
}

/**
 * Device status. The reply is decoded as this response.
 *
 * - model_number: Model number of the device that replies. On the 3DM-GX5-15: always 6254. On the
 *   3DM-GX5-35: always 6252. On the 3DM-GX5-45: always 6251.
 */
static inline struct mip_result mip_call_for_3dm_device_status_basic_rq1_imu_response(
    struct mip_device *device, uint16_t model_number,
    struct mip_3dm_device_status_basic_rq1_imu_response *response) {
    struct mip_3dm_device_status command;
    return mip_device_call(
        device, &mip_3dm_device_status_command,
        mip_3dm_device_status_make(&command, model_number, MIP_3DM_DEVICE_STATUS_SELECTOR_BASIC),
        &mip_3dm_device_status_basic_rq1_imu_response_codec, response);
}

/**
 * Device status. The reply is decoded as this response.
 *
 * - model_number: Model number of the device that replies. On the 3DM-GX5-15: always 6254. On the
 *   3DM-GX5-35: always 6252. On the 3DM-GX5-45: always 6251.
 */
static inline struct mip_result mip_call_for_3dm_device_status_basic_response(
    struct mip_device *device, uint16_t model_number,
    struct mip_3dm_device_status_basic_response *response) {
    struct mip_3dm_device_status command;
    return mip_device_call(
        device, &mip_3dm_device_status_command,
        mip_3dm_device_status_make(&command, model_number, MIP_3DM_DEVICE_STATUS_SELECTOR_BASIC),
        &mip_3dm_device_status_basic_response_codec, response);
}

/**
 * Device status. The reply is decoded as this response.
 *
 * - model_number: Model number of the device that replies. On the 3DM-GX5-15: always 6254. On the
 *   3DM-GX5-35: always 6252. On the 3DM-GX5-45: always 6251.
 */
static inline struct mip_result mip_call_for_3dm_device_status_basic_without_state_response(
    struct mip_device *device, uint16_t model_number,
    struct mip_3dm_device_status_basic_without_state_response *response) {
    struct mip_3dm_device_status command;
    return mip_device_call(
        device, &mip_3dm_device_status_command,
        mip_3dm_device_status_make(&command, model_number, MIP_3DM_DEVICE_STATUS_SELECTOR_BASIC),
        &mip_3dm_device_status_basic_without_state_response_codec, response);
}

/**
 * Device status. The reply is decoded as this response.
 *
 * - model_number: Model number of the device that replies. On the 3DM-GX5-15: always 6254. On the
 *   3DM-GX5-35: always 6252. On the 3DM-GX5-45: always 6251.
 */
static inline struct mip_result mip_call_for_3dm_device_status_basic_gx3_response(
    struct mip_device *device, uint16_t model_number,
    struct mip_3dm_device_status_basic_gx3_response *response) {
    struct mip_3dm_device_status command;
    return mip_device_call(
        device, &mip_3dm_device_status_command,
        mip_3dm_device_status_make(&command, model_number, MIP_3DM_DEVICE_STATUS_SELECTOR_BASIC),
        &mip_3dm_device_status_basic_gx3_response_codec, response);
}

/**
 * Device status. The reply is decoded as this response.
 *
 * - model_number: Model number of the device that replies. On the 3DM-GX5-15: always 6254. On the
 *   3DM-GX5-35: always 6252. On the 3DM-GX5-45: always 6251.
 */
static inline struct mip_result mip_call_for_3dm_device_status_diagnostic_response(
    struct mip_device *device, uint16_t model_number,
    struct mip_3dm_device_status_diagnostic_response *response) {
    struct mip_3dm_device_status command;
    return mip_device_call(device, &mip_3dm_device_status_command,
                           mip_3dm_device_status_make(&command, model_number,
                                                      MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC),
                           &mip_3dm_device_status_diagnostic_response_codec, response);
}

/**
 * Device status. The reply is decoded as this response.
 *
 * - model_number: Model number of the device that replies. On the 3DM-GX5-15: always 6254. On the
 *   3DM-GX5-35: always 6252. On the 3DM-GX5-45: always 6251.
 */
static inline struct mip_result mip_call_for_3dm_device_status_diagnostic_gnss_response(
    struct mip_device *device, uint16_t model_number,
    struct mip_3dm_device_status_diagnostic_gnss_response *response) {
    struct mip_3dm_device_status command;
    return mip_device_call(device, &mip_3dm_device_status_command,
                           mip_3dm_device_status_make(&command, model_number,
                                                      MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC),
                           &mip_3dm_device_status_diagnostic_gnss_response_codec, response);
}

/**
 * Device status. The reply is decoded as this response.
 *
 * - model_number: Model number of the device that replies. On the 3DM-GX5-15: always 6254. On the
 *   3DM-GX5-35: always 6252. On the 3DM-GX5-45: always 6251.
 */
static inline struct mip_result mip_call_for_3dm_device_status_diagnostic_gq4_45_response(
    struct mip_device *device, uint16_t model_number,
    struct mip_3dm_device_status_diagnostic_gq4_45_response *response) {
    struct mip_3dm_device_status command;
    return mip_device_call(device, &mip_3dm_device_status_command,
                           mip_3dm_device_status_make(&command, model_number,
                                                      MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC),
                           &mip_3dm_device_status_diagnostic_gq4_45_response_codec, response);
}

/**
 * Device status. The reply is decoded as this response.
 *
 * - model_number: Model number of the device that replies. On the 3DM-GX5-15: always 6254. On the
 *   3DM-GX5-35: always 6252. On the 3DM-GX5-45: always 6251.
 */
static inline struct mip_result mip_call_for_3dm_device_status_diagnostic_rq1_45_response(
    struct mip_device *device, uint16_t model_number,
    struct mip_3dm_device_status_diagnostic_rq1_45_response *response) {
    struct mip_3dm_device_status command;
    return mip_device_call(device, &mip_3dm_device_status_command,
                           mip_3dm_device_status_make(&command, model_number,
                                                      MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC),
                           &mip_3dm_device_status_diagnostic_rq1_45_response_codec, response);
}

/**
 * Device status. The reply is decoded as this response.
 *
 * - model_number: Model number of the device that replies. On the 3DM-GX5-15: always 6254. On the
 *   3DM-GX5-35: always 6252. On the 3DM-GX5-45: always 6251.
 */
static inline struct mip_result mip_call_for_3dm_device_status_diagnostic_gx4_response(
    struct mip_device *device, uint16_t model_number,
    struct mip_3dm_device_status_diagnostic_gx4_response *response) {
    struct mip_3dm_device_status command;
    return mip_device_call(device, &mip_3dm_device_status_command,
                           mip_3dm_device_status_make(&command, model_number,
                                                      MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC),
                           &mip_3dm_device_status_diagnostic_gx4_response_codec, response);
}

/**
 * Device status. The reply is decoded as this response.
 *
 * - model_number: Model number of the device that replies. On the 3DM-GX5-15: always 6254. On the
 *   3DM-GX5-35: always 6252. On the 3DM-GX5-45: always 6251.
 */
static inline struct mip_result mip_call_for_3dm_device_status_diagnostic_imu_response(
    struct mip_device *device, uint16_t model_number,
    struct mip_3dm_device_status_diagnostic_imu_response *response) {
    struct mip_3dm_device_status command;
    return mip_device_call(device, &mip_3dm_device_status_command,
                           mip_3dm_device_status_make(&command, model_number,
                                                      MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC),
                           &mip_3dm_device_status_diagnostic_imu_response_codec, response);
}

/**
 * Device status. The reply is decoded as this response.
 *
 * - model_number: Model number of the device that replies. On the 3DM-GX5-15: always 6254. On the
 *   3DM-GX5-35: always 6252. On the 3DM-GX5-45: always 6251.
 */
static inline struct mip_result mip_call_for_3dm_device_status_diagnostic_gx4_imu_response(
    struct mip_device *device, uint16_t model_number,
    struct mip_3dm_device_status_diagnostic_gx4_imu_response *response) {
    struct mip_3dm_device_status command;
    return mip_device_call(device, &mip_3dm_device_status_command,
                           mip_3dm_device_status_make(&command, model_number,
                                                      MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC),
                           &mip_3dm_device_status_diagnostic_gx4_imu_response_codec, response);
}

/**
 * Device status. The reply is decoded as this response.
 *
 * - model_number: Model number of the device that replies. On the 3DM-GX5-15: always 6254. On the
 *   3DM-GX5-35: always 6252. On the 3DM-GX5-45: always 6251.
 */
static inline struct mip_result mip_call_for_3dm_device_status_diagnostic_rq1_imu_response(
    struct mip_device *device, uint16_t model_number,
    struct mip_3dm_device_status_diagnostic_rq1_imu_response *response) {
    struct mip_3dm_device_status command;
    return mip_device_call(device, &mip_3dm_device_status_command,
                           mip_3dm_device_status_make(&command, model_number,
                                                      MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC),
                           &mip_3dm_device_status_diagnostic_rq1_imu_response_codec, response);
}

/**
 * Device status. The reply is decoded as this response.
 *
 * - model_number: Model number of the device that replies. On the 3DM-GX5-15: always 6254. On the
 *   3DM-GX5-35: always 6252. On the 3DM-GX5-45: always 6251.
 */
static inline struct mip_result mip_call_for_3dm_device_status_diagnostic_gx3_response(
    struct mip_device *device, uint16_t model_number,
    struct mip_3dm_device_status_diagnostic_gx3_response *response) {
    struct mip_3dm_device_status command;
    return mip_device_call(device, &mip_3dm_device_status_command,
                           mip_3dm_device_status_make(&command, model_number,
                                                      MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC),
                           &mip_3dm_device_status_diagnostic_gx3_response_codec, response);
}

/** Device status, with these values, including optional parameters. */
static inline struct mip_result mip_call_3dm_device_status_with(
    struct mip_device *device, const struct mip_3dm_device_status *command) {
    return mip_device_call(device, &mip_3dm_device_status_command, command, NULL, NULL);
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
