/* 3DM. */
#include "mip/3dm.h"
#include "mip/3dm_commands.h"
#include "mip/core/program.h"

static const uint8_t program_poll_imu_data[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_poll_imu_data, suppress_ack)),
    MIP_COUNTED(MIP_SIZE(struct mip_3dm_poll_imu_data, num_descriptors), 83, 3,
                MIP_AT(struct mip_3dm_poll_imu_data, num_descriptors)),
    MIP_EACH(1, struct mip_3dm_poll_entry, 5, MIP_AT(struct mip_3dm_poll_imu_data, descriptors)),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_poll_entry, descriptor)),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_poll_entry, reserved)),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_3dm_poll_imu_data, 0x0C, 0x01, MIP_COMMAND, 0, 0, 0, program_poll_imu_data,
          &mip_program);

static const struct mip_response responses_poll_imu_data[] = {
    {NULL, 0x00, 2, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_3dm_poll_imu_data, 0x0C, 0x01, 0, 1, responses_poll_imu_data, false);

static const uint8_t program_poll_gnss_data[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_poll_gnss_data, suppress_ack)),
    MIP_COUNTED(MIP_SIZE(struct mip_3dm_poll_gnss_data, num_descriptors), 83, 3,
                MIP_AT(struct mip_3dm_poll_gnss_data, num_descriptors)),
    MIP_EACH(1, struct mip_3dm_poll_entry, 5, MIP_AT(struct mip_3dm_poll_gnss_data, descriptors)),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_poll_entry, descriptor)),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_poll_entry, reserved)),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_3dm_poll_gnss_data, 0x0C, 0x02, MIP_COMMAND, 0, 0, 0, program_poll_gnss_data,
          &mip_program);

static const struct mip_response responses_poll_gnss_data[] = {
    {NULL, 0x00, 2, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_3dm_poll_gnss_data, 0x0C, 0x02, 0, 1, responses_poll_gnss_data, false);

static const uint8_t program_poll_filter_data[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_poll_filter_data, suppress_ack)),
    MIP_COUNTED(MIP_SIZE(struct mip_3dm_poll_filter_data, num_descriptors), 83, 3,
                MIP_AT(struct mip_3dm_poll_filter_data, num_descriptors)),
    MIP_EACH(1, struct mip_3dm_poll_entry, 5, MIP_AT(struct mip_3dm_poll_filter_data, descriptors)),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_poll_entry, descriptor)),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_poll_entry, reserved)),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_3dm_poll_filter_data, 0x0C, 0x03, MIP_COMMAND, 0, 0, 0, program_poll_filter_data,
          &mip_program);

static const struct mip_response responses_poll_filter_data[] = {
    {NULL, 0x00, 2, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_3dm_poll_filter_data, 0x0C, 0x03, 0, 1, responses_poll_filter_data, false);

static const uint8_t program_poll_nmea_data[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_poll_nmea_data, suppress_ack)),
    MIP_COUNTED(MIP_SIZE(struct mip_3dm_poll_nmea_data, count), 50, 5,
                MIP_AT(struct mip_3dm_poll_nmea_data, count)),
    MIP_EACH(1, struct mip_nmea_message, 5, MIP_AT(struct mip_3dm_poll_nmea_data, format_entries)),
    MIP_8_BITS(3, MIP_AT(struct mip_nmea_message, message_id)),
    MIP_16_BITS(1, MIP_AT(struct mip_nmea_message, decimation)),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_3dm_poll_nmea_data, 0x0C, 0x04, MIP_COMMAND, 0, 0, 0, program_poll_nmea_data,
          &mip_program);

static const struct mip_response responses_poll_nmea_data[] = {
    {NULL, 0x00, 2, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_3dm_poll_nmea_data, 0x0C, 0x04, 0, 1, responses_poll_nmea_data, false);

static const uint8_t program_get_imu_base_rate[] = {
    MIP_END,
};

MIP_CODEC(mip_3dm_get_imu_base_rate, 0x0C, 0x06, MIP_COMMAND, 0, 0, 0, program_get_imu_base_rate,
          NULL);

static const struct mip_response responses_get_imu_base_rate[] = {
    {NULL, 0x83, 0, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_3dm_get_imu_base_rate, 0x0C, 0x06, 0, 1, responses_get_imu_base_rate, false);

static const uint8_t program_get_imu_base_rate_response[] = {
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_get_imu_base_rate_response, rate)),
    MIP_END,
};

MIP_CODEC(mip_3dm_get_imu_base_rate_response, 0x0C, 0x83, MIP_RESPONSE, 2, 0, MIP_SHAPE(0, 0, 1),
          program_get_imu_base_rate_response, NULL);

static const uint8_t program_get_gnss_base_rate[] = {
    MIP_END,
};

MIP_CODEC(mip_3dm_get_gnss_base_rate, 0x0C, 0x07, MIP_COMMAND, 0, 0, 0, program_get_gnss_base_rate,
          NULL);

static const struct mip_response responses_get_gnss_base_rate[] = {
    {NULL, 0x84, 0, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_3dm_get_gnss_base_rate, 0x0C, 0x07, 0, 1, responses_get_gnss_base_rate, false);

static const uint8_t program_get_gnss_base_rate_response[] = {
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_get_gnss_base_rate_response, rate)),
    MIP_END,
};

MIP_CODEC(mip_3dm_get_gnss_base_rate_response, 0x0C, 0x84, MIP_RESPONSE, 2, 0, MIP_SHAPE(0, 0, 1),
          program_get_gnss_base_rate_response, NULL);

static const uint8_t program_imu_message_format[] = {
    MIP_REQUIRED(1, 2),
    MIP_GROUP(2),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_imu_message_format, num_descriptors)),
    MIP_COUNTED(MIP_SIZE(struct mip_3dm_imu_message_format, num_descriptors), 83, 3,
                MIP_AT(struct mip_3dm_imu_message_format, num_descriptors)),
    MIP_EACH(1, struct mip_descriptor_rate, 5,
             MIP_AT(struct mip_3dm_imu_message_format, descriptors)),
    MIP_8_BITS(1, MIP_AT(struct mip_descriptor_rate, descriptor)),
    MIP_16_BITS(1, MIP_AT(struct mip_descriptor_rate, decimation)),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_3dm_imu_message_format, 0x0C, 0x08, MIP_COMMAND, 0, 0, 0, program_imu_message_format,
          &mip_program);

static const struct mip_response responses_imu_message_format[] = {
    {NULL, 0x80, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_imu_message_format, 0x0C, 0x08, 0, 1, responses_imu_message_format, true);

static const uint8_t program_imu_message_format_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_imu_message_format_response, num_descriptors)),
    MIP_COUNTED(MIP_SIZE(struct mip_3dm_imu_message_format_response, num_descriptors), 84, 3,
                MIP_AT(struct mip_3dm_imu_message_format_response, num_descriptors)),
    MIP_EACH(1, struct mip_descriptor_rate, 5,
             MIP_AT(struct mip_3dm_imu_message_format_response, descriptors)),
    MIP_8_BITS(1, MIP_AT(struct mip_descriptor_rate, descriptor)),
    MIP_16_BITS(1, MIP_AT(struct mip_descriptor_rate, decimation)),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_3dm_imu_message_format_response, 0x0C, 0x80, MIP_RESPONSE, 0, 0, 0,
          program_imu_message_format_response, &mip_program);

static const uint8_t program_gnss_message_format[] = {
    MIP_REQUIRED(1, 2),
    MIP_GROUP(2),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_gnss_message_format, num_descriptors)),
    MIP_COUNTED(MIP_SIZE(struct mip_3dm_gnss_message_format, num_descriptors), 83, 3,
                MIP_AT(struct mip_3dm_gnss_message_format, num_descriptors)),
    MIP_EACH(1, struct mip_descriptor_rate, 5,
             MIP_AT(struct mip_3dm_gnss_message_format, descriptors)),
    MIP_8_BITS(1, MIP_AT(struct mip_descriptor_rate, descriptor)),
    MIP_16_BITS(1, MIP_AT(struct mip_descriptor_rate, decimation)),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_3dm_gnss_message_format, 0x0C, 0x09, MIP_COMMAND, 0, 0, 0,
          program_gnss_message_format, &mip_program);

static const struct mip_response responses_gnss_message_format[] = {
    {NULL, 0x81, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_gnss_message_format, 0x0C, 0x09, 0, 1, responses_gnss_message_format, true);

static const uint8_t program_gnss_message_format_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_gnss_message_format_response, num_descriptors)),
    MIP_COUNTED(MIP_SIZE(struct mip_3dm_gnss_message_format_response, num_descriptors), 84, 3,
                MIP_AT(struct mip_3dm_gnss_message_format_response, num_descriptors)),
    MIP_EACH(1, struct mip_descriptor_rate, 5,
             MIP_AT(struct mip_3dm_gnss_message_format_response, descriptors)),
    MIP_8_BITS(1, MIP_AT(struct mip_descriptor_rate, descriptor)),
    MIP_16_BITS(1, MIP_AT(struct mip_descriptor_rate, decimation)),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_3dm_gnss_message_format_response, 0x0C, 0x81, MIP_RESPONSE, 0, 0, 0,
          program_gnss_message_format_response, &mip_program);

static const uint8_t program_filter_message_format[] = {
    MIP_REQUIRED(1, 2),
    MIP_GROUP(2),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_filter_message_format, num_descriptors)),
    MIP_COUNTED(MIP_SIZE(struct mip_3dm_filter_message_format, num_descriptors), 83, 3,
                MIP_AT(struct mip_3dm_filter_message_format, num_descriptors)),
    MIP_EACH(1, struct mip_descriptor_rate, 5,
             MIP_AT(struct mip_3dm_filter_message_format, descriptors)),
    MIP_8_BITS(1, MIP_AT(struct mip_descriptor_rate, descriptor)),
    MIP_16_BITS(1, MIP_AT(struct mip_descriptor_rate, decimation)),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_3dm_filter_message_format, 0x0C, 0x0A, MIP_COMMAND, 0, 0, 0,
          program_filter_message_format, &mip_program);

static const struct mip_response responses_filter_message_format[] = {
    {NULL, 0x82, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_filter_message_format, 0x0C, 0x0A, 0, 1, responses_filter_message_format,
             true);

static const uint8_t program_filter_message_format_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_filter_message_format_response, num_descriptors)),
    MIP_COUNTED(MIP_SIZE(struct mip_3dm_filter_message_format_response, num_descriptors), 84, 3,
                MIP_AT(struct mip_3dm_filter_message_format_response, num_descriptors)),
    MIP_EACH(1, struct mip_descriptor_rate, 5,
             MIP_AT(struct mip_3dm_filter_message_format_response, descriptors)),
    MIP_8_BITS(1, MIP_AT(struct mip_descriptor_rate, descriptor)),
    MIP_16_BITS(1, MIP_AT(struct mip_descriptor_rate, decimation)),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_3dm_filter_message_format_response, 0x0C, 0x82, MIP_RESPONSE, 0, 0, 0,
          program_filter_message_format_response, &mip_program);

static const uint8_t program_get_filter_base_rate[] = {
    MIP_END,
};

MIP_CODEC(mip_3dm_get_filter_base_rate, 0x0C, 0x0B, MIP_COMMAND, 0, 0, 0,
          program_get_filter_base_rate, NULL);

static const struct mip_response responses_get_filter_base_rate[] = {
    {NULL, 0x8A, 0, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_3dm_get_filter_base_rate, 0x0C, 0x0B, 0, 1, responses_get_filter_base_rate, false);

static const uint8_t program_get_filter_base_rate_response[] = {
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_get_filter_base_rate_response, rate)),
    MIP_END,
};

MIP_CODEC(mip_3dm_get_filter_base_rate_response, 0x0C, 0x8A, MIP_RESPONSE, 2, 0, MIP_SHAPE(0, 0, 1),
          program_get_filter_base_rate_response, NULL);

static const uint8_t program_nmea_message_format[] = {
    MIP_REQUIRED(1, 2),
    MIP_GROUP(2),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_nmea_message_format, count)),
    MIP_COUNTED(MIP_SIZE(struct mip_3dm_nmea_message_format, count), 50, 5,
                MIP_AT(struct mip_3dm_nmea_message_format, count)),
    MIP_EACH(1, struct mip_nmea_message, 5,
             MIP_AT(struct mip_3dm_nmea_message_format, format_entries)),
    MIP_8_BITS(3, MIP_AT(struct mip_nmea_message, message_id)),
    MIP_16_BITS(1, MIP_AT(struct mip_nmea_message, decimation)),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_3dm_nmea_message_format, 0x0C, 0x0C, MIP_COMMAND, 0, 0, 0,
          program_nmea_message_format, &mip_program);

static const struct mip_response responses_nmea_message_format[] = {
    {NULL, 0x8C, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_nmea_message_format, 0x0C, 0x0C, 0, 1, responses_nmea_message_format, true);

static const uint8_t program_nmea_message_format_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_nmea_message_format_response, count)),
    MIP_COUNTED(MIP_SIZE(struct mip_3dm_nmea_message_format_response, count), 50, 5,
                MIP_AT(struct mip_3dm_nmea_message_format_response, count)),
    MIP_EACH(1, struct mip_nmea_message, 5,
             MIP_AT(struct mip_3dm_nmea_message_format_response, format_entries)),
    MIP_8_BITS(3, MIP_AT(struct mip_nmea_message, message_id)),
    MIP_16_BITS(1, MIP_AT(struct mip_nmea_message, decimation)),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_3dm_nmea_message_format_response, 0x0C, 0x8C, MIP_RESPONSE, 0, 0, 0,
          program_nmea_message_format_response, &mip_program);

static const uint8_t program_poll_data[] = {
    MIP_8_BITS(3, MIP_AT(struct mip_3dm_poll_data, descriptor_set)),
    MIP_COUNTED(MIP_SIZE(struct mip_3dm_poll_data, num_descriptors), 250, 1,
                MIP_AT(struct mip_3dm_poll_data, num_descriptors)),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_poll_data, descriptors)),
    MIP_END,
};

MIP_CODEC(mip_3dm_poll_data, 0x0C, 0x0D, MIP_COMMAND, 0, 0, 0, program_poll_data, &mip_program);

static const struct mip_response responses_poll_data[] = {
    {NULL, 0x00, 3, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_3dm_poll_data, 0x0C, 0x0D, 0, 1, responses_poll_data, false);

static const uint8_t program_get_base_rate[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_get_base_rate, descriptor_set)),
    MIP_END,
};

MIP_CODEC(mip_3dm_get_base_rate, 0x0C, 0x0E, MIP_COMMAND, 1, 0, 0, program_get_base_rate, NULL);

static const struct mip_response responses_get_base_rate[] = {
    {NULL, 0x8E, 0, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_3dm_get_base_rate, 0x0C, 0x0E, 0, 1, responses_get_base_rate, false);

static const uint8_t program_get_base_rate_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_get_base_rate_response, descriptor_set)),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_get_base_rate_response, rate)),
    MIP_END,
};

MIP_CODEC(mip_3dm_get_base_rate_response, 0x0C, 0x8E, MIP_RESPONSE, 3, 0, 0,
          program_get_base_rate_response, NULL);

static const uint8_t program_message_format[] = {
    MIP_REQUIRED(5, 3, 1, 1, 1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_message_format, descriptor_set)),
    MIP_GROUP(2),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_message_format, num_descriptors)),
    MIP_COUNTED(MIP_SIZE(struct mip_3dm_message_format, num_descriptors), 83, 3,
                MIP_AT(struct mip_3dm_message_format, num_descriptors)),
    MIP_EACH(1, struct mip_descriptor_rate, 5, MIP_AT(struct mip_3dm_message_format, descriptors)),
    MIP_8_BITS(1, MIP_AT(struct mip_descriptor_rate, descriptor)),
    MIP_16_BITS(1, MIP_AT(struct mip_descriptor_rate, decimation)),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_3dm_message_format, 0x0C, 0x0F, MIP_COMMAND, 0, 0, 0, program_message_format,
          &mip_program);

static const struct mip_response responses_message_format[] = {
    {NULL, 0x8F, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_message_format, 0x0C, 0x0F, 0, 1, responses_message_format, true);

static const uint8_t program_message_format_response[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_message_format_response, descriptor_set)),
    MIP_COUNTED(MIP_SIZE(struct mip_3dm_message_format_response, num_descriptors), 83, 3,
                MIP_AT(struct mip_3dm_message_format_response, num_descriptors)),
    MIP_EACH(1, struct mip_descriptor_rate, 5,
             MIP_AT(struct mip_3dm_message_format_response, descriptors)),
    MIP_8_BITS(1, MIP_AT(struct mip_descriptor_rate, descriptor)),
    MIP_16_BITS(1, MIP_AT(struct mip_descriptor_rate, decimation)),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_3dm_message_format_response, 0x0C, 0x8F, MIP_RESPONSE, 0, 0, 0,
          program_message_format_response, &mip_program);

static const uint8_t program_factory_streaming[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_factory_streaming, action)),
    MIP_END,
};

MIP_CODEC(mip_3dm_factory_streaming, 0x0C, 0x10, MIP_COMMAND, 2, 0, 0, program_factory_streaming,
          NULL);

MIP_EXCHANGE(mip_3dm_factory_streaming, 0x0C, 0x10, 0, 0, NULL, false);

static const uint8_t program_data_stream_control[] = {
    MIP_REQUIRED(5, 2, 1, 1, 1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_data_stream_control, descriptor_set)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_data_stream_control, enable)),
    MIP_END,
};

MIP_CODEC(mip_3dm_data_stream_control, 0x0C, 0x11, MIP_COMMAND, 0, 0, 0,
          program_data_stream_control, &mip_program);

static const struct mip_response responses_data_stream_control[] = {
    {NULL, 0x85, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_data_stream_control, 0x0C, 0x11, 0, 1, responses_data_stream_control, true);

static const uint8_t program_data_stream_control_response[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_data_stream_control_response, descriptor_set)),
    MIP_END,
};

MIP_CODEC(mip_3dm_data_stream_control_response, 0x0C, 0x85, MIP_RESPONSE, 2, 0, 0,
          program_data_stream_control_response, NULL);

static const uint8_t program_raw_rtcm_2_3_message[] = {
    MIP_REST(253, 1, MIP_AT(struct mip_3dm_raw_rtcm_2_3_message, data_count)),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_raw_rtcm_2_3_message, data)),
    MIP_END,
};

MIP_CODEC(mip_3dm_raw_rtcm_2_3_message, 0x0C, 0x20, MIP_COMMAND, 0, 0, 0,
          program_raw_rtcm_2_3_message, &mip_program);

MIP_EXCHANGE(mip_3dm_raw_rtcm_2_3_message, 0x0C, 0x20, 0, 0, NULL, false);

static const uint8_t program_constellation_settings[] = {
    MIP_REQUIRED(1, 3),
    MIP_GROUP(1),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_constellation_settings, max_channels)),
    MIP_GROUP(2),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_constellation_settings, config_count)),
    MIP_COUNTED(MIP_SIZE(struct mip_3dm_constellation_settings, config_count), 41, 6,
                MIP_AT(struct mip_3dm_constellation_settings, config_count)),
    MIP_EACH(1, struct mip_3dm_constellation_settings_entry, 5,
             MIP_AT(struct mip_3dm_constellation_settings, settings)),
    MIP_8_BITS(4, MIP_AT(struct mip_3dm_constellation_settings_entry, constellation_id)),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_constellation_settings_entry, option_flags)),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_3dm_constellation_settings, 0x0C, 0x21, MIP_COMMAND, 0, 0, 0,
          program_constellation_settings, &mip_program);

static const struct mip_response responses_constellation_settings[] = {
    {NULL, 0xA0, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_constellation_settings, 0x0C, 0x21, 0, 1, responses_constellation_settings,
             true);

static const uint8_t program_constellation_settings_response[] = {
    MIP_16_BITS(2, MIP_AT(struct mip_3dm_constellation_settings_response, max_channels_available)),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_constellation_settings_response, config_count)),
    MIP_COUNTED(MIP_SIZE(struct mip_3dm_constellation_settings_response, config_count), 41, 6,
                MIP_AT(struct mip_3dm_constellation_settings_response, config_count)),
    MIP_EACH(1, struct mip_3dm_constellation_settings_entry, 5,
             MIP_AT(struct mip_3dm_constellation_settings_response, settings)),
    MIP_8_BITS(4, MIP_AT(struct mip_3dm_constellation_settings_entry, constellation_id)),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_constellation_settings_entry, option_flags)),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_3dm_constellation_settings_response, 0x0C, 0xA0, MIP_RESPONSE, 0, 0, 0,
          program_constellation_settings_response, &mip_program);

static const uint8_t program_gnss_sbas_settings[] = {
    MIP_REQUIRED(1, 4),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_gnss_sbas_settings, enable_sbas)),
    MIP_GROUP(1),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_gnss_sbas_settings, sbas_options)),
    MIP_GROUP(2),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_gnss_sbas_settings, num_included_prns)),
    MIP_COUNTED(MIP_SIZE(struct mip_3dm_gnss_sbas_settings, num_included_prns), 124, 2,
                MIP_AT(struct mip_3dm_gnss_sbas_settings, num_included_prns)),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_gnss_sbas_settings, included_prns)),
    MIP_END,
};

MIP_CODEC(mip_3dm_gnss_sbas_settings, 0x0C, 0x22, MIP_COMMAND, 0, 0, 0, program_gnss_sbas_settings,
          &mip_program);

static const struct mip_response responses_gnss_sbas_settings[] = {
    {NULL, 0xA1, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_gnss_sbas_settings, 0x0C, 0x22, 0, 1, responses_gnss_sbas_settings, true);

static const uint8_t program_gnss_sbas_settings_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_gnss_sbas_settings_response, enable_sbas)),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_gnss_sbas_settings_response, sbas_options)),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_gnss_sbas_settings_response, num_included_prns)),
    MIP_COUNTED(MIP_SIZE(struct mip_3dm_gnss_sbas_settings_response, num_included_prns), 124, 2,
                MIP_AT(struct mip_3dm_gnss_sbas_settings_response, num_included_prns)),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_gnss_sbas_settings_response, included_prns)),
    MIP_END,
};

MIP_CODEC(mip_3dm_gnss_sbas_settings_response, 0x0C, 0xA1, MIP_RESPONSE, 0, 0, 0,
          program_gnss_sbas_settings_response, &mip_program);

static const uint8_t program_gnss_assisted_fix[] = {
    MIP_REQUIRED(1, 2),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_gnss_assisted_fix, option)),
    MIP_GROUP(1),
    MIP_RESERVED,
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_gnss_assisted_fix, flags)),
    MIP_END,
};

MIP_CODEC(mip_3dm_gnss_assisted_fix, 0x0C, 0x23, MIP_COMMAND, 0, 0, 0, program_gnss_assisted_fix,
          &mip_program);

static const struct mip_response responses_gnss_assisted_fix[] = {
    {NULL, 0xA2, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_gnss_assisted_fix, 0x0C, 0x23, 0, 1, responses_gnss_assisted_fix, true);

static const uint8_t program_gnss_assisted_fix_response[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_gnss_assisted_fix_response, option)),
    MIP_END,
};

MIP_CODEC(mip_3dm_gnss_assisted_fix_response, 0x0C, 0xA2, MIP_RESPONSE, 2, 0, 0,
          program_gnss_assisted_fix_response, NULL);

static const uint8_t program_gnss_time_assistance[] = {
    MIP_REQUIRED(1, 3),
    MIP_GROUP(1),
    MIP_DOUBLES(1, MIP_AT(struct mip_3dm_gnss_time_assistance, tow)),
    MIP_GROUP(1),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_gnss_time_assistance, week_number)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_3dm_gnss_time_assistance, accuracy)),
    MIP_END,
};

MIP_CODEC(mip_3dm_gnss_time_assistance, 0x0C, 0x24, MIP_COMMAND, 0, 0, 0,
          program_gnss_time_assistance, &mip_program);

static const struct mip_response responses_gnss_time_assistance[] = {
    {NULL, 0xA3, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_gnss_time_assistance, 0x0C, 0x24, 0, 1, responses_gnss_time_assistance, true);

static const uint8_t program_gnss_time_assistance_response[] = {
    MIP_DOUBLES(1, MIP_AT(struct mip_3dm_gnss_time_assistance_response, tow)),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_gnss_time_assistance_response, week_number)),
    MIP_32_BITS(1, MIP_AT(struct mip_3dm_gnss_time_assistance_response, accuracy)),
    MIP_END,
};

MIP_CODEC(mip_3dm_gnss_time_assistance_response, 0x0C, 0xA3, MIP_RESPONSE, 14, 0, 0,
          program_gnss_time_assistance_response, NULL);

static const uint8_t program_pps_source_control[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_pps_source_control, source)),
    MIP_END,
};

MIP_CODEC(mip_3dm_pps_source_control, 0x0C, 0x28, MIP_COMMAND, 0, 0, 0, program_pps_source_control,
          &mip_program);

static const struct mip_response responses_pps_source_control[] = {
    {NULL, 0xA8, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_pps_source_control, 0x0C, 0x28, 0, 1, responses_pps_source_control, true);

static const uint8_t program_pps_source_control_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_pps_source_control_response, source)),
    MIP_END,
};

MIP_CODEC(mip_3dm_pps_source_control_response, 0x0C, 0xA8, MIP_RESPONSE, 1, 0, 0,
          program_pps_source_control_response, NULL);

static const uint8_t program_get_event_support[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_get_event_support, query)),
    MIP_END,
};

MIP_CODEC(mip_3dm_get_event_support, 0x0C, 0x2A, MIP_COMMAND, 1, 0, 0, program_get_event_support,
          NULL);

static const struct mip_response responses_get_event_support[] = {
    {NULL, 0xB4, 0, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_3dm_get_event_support, 0x0C, 0x2A, 0, 1, responses_get_event_support, false);

static const uint8_t program_get_event_support_response[] = {
    MIP_8_BITS(3, MIP_AT(struct mip_3dm_get_event_support_response, query)),
    MIP_COUNTED(MIP_SIZE(struct mip_3dm_get_event_support_response, num_entries), 125, 2,
                MIP_AT(struct mip_3dm_get_event_support_response, num_entries)),
    MIP_EACH(1, struct mip_3dm_event_support_info, 3,
             MIP_AT(struct mip_3dm_get_event_support_response, entries)),
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_event_support_info, type)),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_3dm_get_event_support_response, 0x0C, 0xB4, MIP_RESPONSE, 0, 0, 0,
          program_get_event_support_response, &mip_program);

static const uint8_t program_event_control[] = {
    MIP_REQUIRED(5, 2, 1, 1, 1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_event_control, instance)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_event_control, mode)),
    MIP_END,
};

MIP_CODEC(mip_3dm_event_control, 0x0C, 0x2B, MIP_COMMAND, 0, 0, 0, program_event_control,
          &mip_program);

static const struct mip_response responses_event_control[] = {
    {NULL, 0xB5, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_event_control, 0x0C, 0x2B, 0, 1, responses_event_control, true);

static const uint8_t program_event_control_response[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_event_control_response, instance)),
    MIP_END,
};

MIP_CODEC(mip_3dm_event_control_response, 0x0C, 0xB5, MIP_RESPONSE, 2, 0, 0,
          program_event_control_response, NULL);

static const uint8_t program_get_event_trigger_status[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_get_event_trigger_status, requested_count)),
    MIP_COUNTED(MIP_SIZE(struct mip_3dm_get_event_trigger_status, requested_count), 252, 1,
                MIP_AT(struct mip_3dm_get_event_trigger_status, requested_count)),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_get_event_trigger_status, requested_instances)),
    MIP_END,
};

MIP_CODEC(mip_3dm_get_event_trigger_status, 0x0C, 0x2C, MIP_COMMAND, 0, 0, 0,
          program_get_event_trigger_status, &mip_program);

static const struct mip_response responses_get_event_trigger_status[] = {
    {NULL, 0xB6, 0, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_3dm_get_event_trigger_status, 0x0C, 0x2C, 0, 1, responses_get_event_trigger_status,
             false);

static const uint8_t program_get_event_trigger_status_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_get_event_trigger_status_response, count)),
    MIP_COUNTED(MIP_SIZE(struct mip_3dm_get_event_trigger_status_response, count), 126, 2,
                MIP_AT(struct mip_3dm_get_event_trigger_status_response, count)),
    MIP_EACH(1, struct mip_3dm_event_trigger_status_entry, 3,
             MIP_AT(struct mip_3dm_get_event_trigger_status_response, triggers)),
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_event_trigger_status_entry, type)),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_3dm_get_event_trigger_status_response, 0x0C, 0xB6, MIP_RESPONSE, 0, 0, 0,
          program_get_event_trigger_status_response, &mip_program);

static const uint8_t program_get_event_action_status[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_get_event_action_status, requested_count)),
    MIP_COUNTED(MIP_SIZE(struct mip_3dm_get_event_action_status, requested_count), 252, 1,
                MIP_AT(struct mip_3dm_get_event_action_status, requested_count)),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_get_event_action_status, requested_instances)),
    MIP_END,
};

MIP_CODEC(mip_3dm_get_event_action_status, 0x0C, 0x2D, MIP_COMMAND, 0, 0, 0,
          program_get_event_action_status, &mip_program);

static const struct mip_response responses_get_event_action_status[] = {
    {NULL, 0xB7, 0, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_3dm_get_event_action_status, 0x0C, 0x2D, 0, 1, responses_get_event_action_status,
             false);

static const uint8_t program_get_event_action_status_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_get_event_action_status_response, count)),
    MIP_COUNTED(MIP_SIZE(struct mip_3dm_get_event_action_status_response, count), 126, 2,
                MIP_AT(struct mip_3dm_get_event_action_status_response, count)),
    MIP_EACH(1, struct mip_3dm_event_action_status_entry, 3,
             MIP_AT(struct mip_3dm_get_event_action_status_response, actions)),
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_event_action_status_entry, action_type)),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_3dm_get_event_action_status_response, 0x0C, 0xB7, MIP_RESPONSE, 0, 0, 0,
          program_get_event_action_status_response, &mip_program);

static const uint8_t program_event_trigger_config[] = {
    MIP_REQUIRED(5, 3, 1, 1, 1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_event_trigger_config, instance)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_event_trigger_config, type)),
    MIP_GROUP(1),
    MIP_SWITCH(1, 3, MIP_AT(struct mip_3dm_event_trigger_config, type)),
    MIP_CASE(3, 0x01),
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_event_trigger_config, parameters.gpio.pin)),
    MIP_END,
    MIP_CASE(17, 0x02),
    MIP_8_BITS(4, MIP_AT(struct mip_3dm_event_trigger_config, parameters.threshold.descriptor_set)),
    MIP_SWITCH(1, 2, MIP_AT(struct mip_3dm_event_trigger_config, parameters.threshold.type)),
    MIP_CASE(3, 0x01),
    MIP_DOUBLES(2, MIP_AT(struct mip_3dm_event_trigger_config,
                          parameters.threshold.thresholds.window.low_threshold)),
    MIP_END,
    MIP_CASE(3, 0x02),
    MIP_DOUBLES(2, MIP_AT(struct mip_3dm_event_trigger_config,
                          parameters.threshold.thresholds.interval.interval_threshold)),
    MIP_END,
    MIP_END,
    MIP_CASE(5, 0x03),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_event_trigger_config, parameters.combination.logic_table)),
    MIP_8_BITS(4,
               MIP_AT(struct mip_3dm_event_trigger_config, parameters.combination.input_triggers)),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_3dm_event_trigger_config, 0x0C, 0x2E, MIP_COMMAND, 0, 0, 0,
          program_event_trigger_config, &mip_program);

static const struct mip_response responses_event_trigger_config[] = {
    {NULL, 0xB8, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_event_trigger_config, 0x0C, 0x2E, 0, 1, responses_event_trigger_config, true);

static const uint8_t program_event_trigger_config_response[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_event_trigger_config_response, instance)),
    MIP_SWITCH(1, 3, MIP_AT(struct mip_3dm_event_trigger_config_response, type)),
    MIP_CASE(3, 0x01),
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_event_trigger_config_response, parameters.gpio.pin)),
    MIP_END,
    MIP_CASE(17, 0x02),
    MIP_8_BITS(4, MIP_AT(struct mip_3dm_event_trigger_config_response,
                         parameters.threshold.descriptor_set)),
    MIP_SWITCH(1, 2,
               MIP_AT(struct mip_3dm_event_trigger_config_response, parameters.threshold.type)),
    MIP_CASE(3, 0x01),
    MIP_DOUBLES(2, MIP_AT(struct mip_3dm_event_trigger_config_response,
                          parameters.threshold.thresholds.window.low_threshold)),
    MIP_END,
    MIP_CASE(3, 0x02),
    MIP_DOUBLES(2, MIP_AT(struct mip_3dm_event_trigger_config_response,
                          parameters.threshold.thresholds.interval.interval_threshold)),
    MIP_END,
    MIP_END,
    MIP_CASE(5, 0x03),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_event_trigger_config_response,
                          parameters.combination.logic_table)),
    MIP_8_BITS(4, MIP_AT(struct mip_3dm_event_trigger_config_response,
                         parameters.combination.input_triggers)),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_3dm_event_trigger_config_response, 0x0C, 0xB8, MIP_RESPONSE, 0, 0, 0,
          program_event_trigger_config_response, &mip_program);

static const uint8_t program_event_action_config[] = {
    MIP_REQUIRED(5, 4, 1, 1, 1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_event_action_config, instance)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_event_action_config, trigger)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_event_action_config, type)),
    MIP_GROUP(1),
    MIP_SWITCH(1, 2, MIP_AT(struct mip_3dm_event_action_config, type)),
    MIP_CASE(3, 0x01),
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_event_action_config, parameters.gpio.pin)),
    MIP_END,
    MIP_CASE(14, 0x02),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_event_action_config, parameters.message.descriptor_set)),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_event_action_config, parameters.message.decimation)),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_event_action_config, parameters.message.num_fields)),
    MIP_COUNTED(MIP_SIZE(struct mip_3dm_event_action_config, parameters.message.num_fields),
                MIP_ROOM(12, 249), 1,
                MIP_AT(struct mip_3dm_event_action_config, parameters.message.num_fields)),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_event_action_config, parameters.message.descriptors)),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_3dm_event_action_config, 0x0C, 0x2F, MIP_COMMAND, 0, 0, 0,
          program_event_action_config, &mip_program);

static const struct mip_response responses_event_action_config[] = {
    {NULL, 0xB9, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_event_action_config, 0x0C, 0x2F, 0, 1, responses_event_action_config, true);

static const uint8_t program_event_action_config_response[] = {
    MIP_8_BITS(3, MIP_AT(struct mip_3dm_event_action_config_response, instance)),
    MIP_SWITCH(1, 2, MIP_AT(struct mip_3dm_event_action_config_response, type)),
    MIP_CASE(3, 0x01),
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_event_action_config_response, parameters.gpio.pin)),
    MIP_END,
    MIP_CASE(14, 0x02),
    MIP_8_BITS(
        1, MIP_AT(struct mip_3dm_event_action_config_response, parameters.message.descriptor_set)),
    MIP_16_BITS(1,
                MIP_AT(struct mip_3dm_event_action_config_response, parameters.message.decimation)),
    MIP_8_BITS(1,
               MIP_AT(struct mip_3dm_event_action_config_response, parameters.message.num_fields)),
    MIP_COUNTED(
        MIP_SIZE(struct mip_3dm_event_action_config_response, parameters.message.num_fields),
        MIP_ROOM(12, 249), 1,
        MIP_AT(struct mip_3dm_event_action_config_response, parameters.message.num_fields)),
    MIP_8_BITS(1,
               MIP_AT(struct mip_3dm_event_action_config_response, parameters.message.descriptors)),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_3dm_event_action_config_response, 0x0C, 0xB9, MIP_RESPONSE, 0, 0, 0,
          program_event_action_config_response, &mip_program);

static const uint8_t program_device_settings[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_device_settings, function)),
    MIP_END,
};

MIP_CODEC(mip_3dm_device_settings, 0x0C, 0x30, MIP_COMMAND, 1, 0, 0, program_device_settings, NULL);

MIP_EXCHANGE(mip_3dm_device_settings, 0x0C, 0x30, 8, 0, NULL, true);

static const uint8_t program_sensor_to_vehicle_transform_euler[] = {
    MIP_REQUIRED(1, 3),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_3dm_sensor_to_vehicle_transform_euler, roll)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_3dm_sensor_to_vehicle_transform_euler, pitch)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_3dm_sensor_to_vehicle_transform_euler, yaw)),
    MIP_END,
};

MIP_CODEC(mip_3dm_sensor_to_vehicle_transform_euler, 0x0C, 0x31, MIP_COMMAND, 0, 0, 0,
          program_sensor_to_vehicle_transform_euler, &mip_program);

static const struct mip_response responses_sensor_to_vehicle_transform_euler[] = {
    {NULL, 0xB1, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_sensor_to_vehicle_transform_euler, 0x0C, 0x31, 0, 1,
             responses_sensor_to_vehicle_transform_euler, true);

static const uint8_t program_sensor_to_vehicle_transform_euler_response[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_3dm_sensor_to_vehicle_transform_euler_response, roll)),
    MIP_END,
};

MIP_CODEC(mip_3dm_sensor_to_vehicle_transform_euler_response, 0x0C, 0xB1, MIP_RESPONSE, 12, 0,
          MIP_SHAPE(0, 3, 0), program_sensor_to_vehicle_transform_euler_response, NULL);

static const uint8_t program_sensor_to_vehicle_transform_quaternion[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_32_BITS(4, MIP_AT(struct mip_3dm_sensor_to_vehicle_transform_quaternion, q)),
    MIP_END,
};

MIP_CODEC(mip_3dm_sensor_to_vehicle_transform_quaternion, 0x0C, 0x32, MIP_COMMAND, 0, 0, 0,
          program_sensor_to_vehicle_transform_quaternion, &mip_program);

static const struct mip_response responses_sensor_to_vehicle_transform_quaternion[] = {
    {NULL, 0xB2, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_sensor_to_vehicle_transform_quaternion, 0x0C, 0x32, 0, 1,
             responses_sensor_to_vehicle_transform_quaternion, true);

static const uint8_t program_sensor_to_vehicle_transform_quaternion_response[] = {
    MIP_32_BITS(4, MIP_AT(struct mip_3dm_sensor_to_vehicle_transform_quaternion_response, q)),
    MIP_END,
};

MIP_CODEC(mip_3dm_sensor_to_vehicle_transform_quaternion_response, 0x0C, 0xB2, MIP_RESPONSE, 16, 0,
          MIP_SHAPE(0, 4, 0), program_sensor_to_vehicle_transform_quaternion_response, NULL);

static const uint8_t program_sensor_to_vehicle_transform_dcm[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_32_BITS(9, MIP_AT(struct mip_3dm_sensor_to_vehicle_transform_dcm, dcm)),
    MIP_END,
};

MIP_CODEC(mip_3dm_sensor_to_vehicle_transform_dcm, 0x0C, 0x33, MIP_COMMAND, 0, 0, 0,
          program_sensor_to_vehicle_transform_dcm, &mip_program);

static const struct mip_response responses_sensor_to_vehicle_transform_dcm[] = {
    {NULL, 0xB3, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_sensor_to_vehicle_transform_dcm, 0x0C, 0x33, 0, 1,
             responses_sensor_to_vehicle_transform_dcm, true);

static const uint8_t program_sensor_to_vehicle_transform_dcm_response[] = {
    MIP_32_BITS(9, MIP_AT(struct mip_3dm_sensor_to_vehicle_transform_dcm_response, dcm)),
    MIP_END,
};

MIP_CODEC(mip_3dm_sensor_to_vehicle_transform_dcm_response, 0x0C, 0xB3, MIP_RESPONSE, 36, 0,
          MIP_SHAPE(0, 9, 0), program_sensor_to_vehicle_transform_dcm_response, NULL);

static const uint8_t program_gps_dynamics_mode[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_gps_dynamics_mode, mode)),
    MIP_END,
};

MIP_CODEC(mip_3dm_gps_dynamics_mode, 0x0C, 0x34, MIP_COMMAND, 0, 0, 0, program_gps_dynamics_mode,
          &mip_program);

static const struct mip_response responses_gps_dynamics_mode[] = {
    {NULL, 0x92, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_gps_dynamics_mode, 0x0C, 0x34, 0, 1, responses_gps_dynamics_mode, true);

static const uint8_t program_gps_dynamics_mode_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_gps_dynamics_mode_response, mode)),
    MIP_END,
};

MIP_CODEC(mip_3dm_gps_dynamics_mode_response, 0x0C, 0x92, MIP_RESPONSE, 1, 0, 0,
          program_gps_dynamics_mode_response, NULL);

static const uint8_t program_imu_signal_conditioning[] = {
    MIP_REQUIRED(1, 8),
    MIP_GROUP(1),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_imu_signal_conditioning, orientation_decimation)),
    MIP_GROUP(1),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_imu_signal_conditioning, data_conditioning_flags)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_imu_signal_conditioning, inertial_filter_width)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_imu_signal_conditioning, mag_filter_width)),
    MIP_GROUP(1),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_imu_signal_conditioning, up_compensation)),
    MIP_GROUP(1),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_imu_signal_conditioning, north_compensation)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_imu_signal_conditioning, mag_bandwidth)),
    MIP_GROUP(1),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_imu_signal_conditioning, reserved)),
    MIP_END,
};

MIP_CODEC(mip_3dm_imu_signal_conditioning, 0x0C, 0x35, MIP_COMMAND, 0, 0, 0,
          program_imu_signal_conditioning, &mip_program);

static const struct mip_response responses_imu_signal_conditioning[] = {
    {NULL, 0x86, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_imu_signal_conditioning, 0x0C, 0x35, 0, 1, responses_imu_signal_conditioning,
             true);

static const uint8_t program_imu_signal_conditioning_response[] = {
    MIP_16_BITS(2, MIP_AT(struct mip_3dm_imu_signal_conditioning_response, orientation_decimation)),
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_imu_signal_conditioning_response, inertial_filter_width)),
    MIP_16_BITS(2, MIP_AT(struct mip_3dm_imu_signal_conditioning_response, up_compensation)),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_imu_signal_conditioning_response, mag_bandwidth)),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_imu_signal_conditioning_response, reserved)),
    MIP_END,
};

MIP_CODEC(mip_3dm_imu_signal_conditioning_response, 0x0C, 0x86, MIP_RESPONSE, 13, 0, 0,
          program_imu_signal_conditioning_response, NULL);

static const uint8_t program_imu_timestamp[] = {
    MIP_REQUIRED(2, 2, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_imu_timestamp, selector)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_3dm_imu_timestamp, time)),
    MIP_END,
};

MIP_CODEC(mip_3dm_imu_timestamp, 0x0C, 0x36, MIP_COMMAND, 0, 0, 0, program_imu_timestamp,
          &mip_program);

static const struct mip_response responses_imu_timestamp[] = {
    {NULL, 0x93, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_imu_timestamp, 0x0C, 0x36, 0, 1, responses_imu_timestamp, true);

static const uint8_t program_imu_timestamp_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_imu_timestamp_response, selector)),
    MIP_32_BITS(1, MIP_AT(struct mip_3dm_imu_timestamp_response, time)),
    MIP_END,
};

MIP_CODEC(mip_3dm_imu_timestamp_response, 0x0C, 0x93, MIP_RESPONSE, 5, 0, 0,
          program_imu_timestamp_response, NULL);

static const uint8_t program_accel_bias[] = {
    MIP_REQUIRED(6, 1, 0, 0, 0, 0, 1),
    MIP_GROUP(1),
    MIP_32_BITS(3, MIP_AT(struct mip_3dm_accel_bias, bias)),
    MIP_END,
};

MIP_CODEC(mip_3dm_accel_bias, 0x0C, 0x37, MIP_COMMAND, 0, 0, 0, program_accel_bias, &mip_program);

static const struct mip_response responses_accel_bias[] = {
    {NULL, 0x00, 2, MIP_FUNCTION_SELECTOR_APPLY, false},
    {NULL, 0x9A, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_accel_bias, 0x0C, 0x37, 0, 2, responses_accel_bias, true);

static const uint8_t program_accel_bias_response[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_3dm_accel_bias_response, bias)),
    MIP_END,
};

MIP_CODEC(mip_3dm_accel_bias_response, 0x0C, 0x9A, MIP_RESPONSE, 12, 0, MIP_SHAPE(0, 3, 0),
          program_accel_bias_response, NULL);

static const uint8_t program_gyro_bias[] = {
    MIP_REQUIRED(6, 1, 0, 0, 0, 0, 1),
    MIP_GROUP(1),
    MIP_32_BITS(3, MIP_AT(struct mip_3dm_gyro_bias, bias)),
    MIP_END,
};

MIP_CODEC(mip_3dm_gyro_bias, 0x0C, 0x38, MIP_COMMAND, 0, 0, 0, program_gyro_bias, &mip_program);

static const struct mip_response responses_gyro_bias[] = {
    {NULL, 0x00, 2, MIP_FUNCTION_SELECTOR_APPLY, false},
    {NULL, 0x9B, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_gyro_bias, 0x0C, 0x38, 0, 2, responses_gyro_bias, true);

static const uint8_t program_gyro_bias_response[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_3dm_gyro_bias_response, bias)),
    MIP_END,
};

MIP_CODEC(mip_3dm_gyro_bias_response, 0x0C, 0x9B, MIP_RESPONSE, 12, 0, MIP_SHAPE(0, 3, 0),
          program_gyro_bias_response, NULL);

static const uint8_t program_capture_gyro_bias[] = {
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_capture_gyro_bias, averaging_time_ms)),
    MIP_END,
};

MIP_CODEC(mip_3dm_capture_gyro_bias, 0x0C, 0x39, MIP_COMMAND, 2, 0, MIP_SHAPE(0, 0, 1),
          program_capture_gyro_bias, NULL);

static const struct mip_response responses_capture_gyro_bias[] = {
    {NULL, 0x9B, 0, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_3dm_capture_gyro_bias, 0x0C, 0x39, 124, 1, responses_capture_gyro_bias, false);

static const uint8_t program_mag_hard_iron_offset[] = {
    MIP_REQUIRED(6, 1, 0, 0, 0, 0, 1),
    MIP_GROUP(1),
    MIP_32_BITS(3, MIP_AT(struct mip_3dm_mag_hard_iron_offset, offset)),
    MIP_END,
};

MIP_CODEC(mip_3dm_mag_hard_iron_offset, 0x0C, 0x3A, MIP_COMMAND, 0, 0, 0,
          program_mag_hard_iron_offset, &mip_program);

static const struct mip_response responses_mag_hard_iron_offset[] = {
    {NULL, 0x00, 2, MIP_FUNCTION_SELECTOR_APPLY, false},
    {NULL, 0x9C, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_mag_hard_iron_offset, 0x0C, 0x3A, 0, 2, responses_mag_hard_iron_offset, true);

static const uint8_t program_mag_hard_iron_offset_response[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_3dm_mag_hard_iron_offset_response, offset)),
    MIP_END,
};

MIP_CODEC(mip_3dm_mag_hard_iron_offset_response, 0x0C, 0x9C, MIP_RESPONSE, 12, 0,
          MIP_SHAPE(0, 3, 0), program_mag_hard_iron_offset_response, NULL);

static const uint8_t program_mag_soft_iron_matrix[] = {
    MIP_REQUIRED(6, 1, 0, 0, 0, 0, 1),
    MIP_GROUP(1),
    MIP_32_BITS(9, MIP_AT(struct mip_3dm_mag_soft_iron_matrix, matrix)),
    MIP_END,
};

MIP_CODEC(mip_3dm_mag_soft_iron_matrix, 0x0C, 0x3B, MIP_COMMAND, 0, 0, 0,
          program_mag_soft_iron_matrix, &mip_program);

static const struct mip_response responses_mag_soft_iron_matrix[] = {
    {NULL, 0x00, 2, MIP_FUNCTION_SELECTOR_APPLY, false},
    {NULL, 0x9D, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_mag_soft_iron_matrix, 0x0C, 0x3B, 0, 2, responses_mag_soft_iron_matrix, true);

static const uint8_t program_mag_soft_iron_matrix_response[] = {
    MIP_32_BITS(9, MIP_AT(struct mip_3dm_mag_soft_iron_matrix_response, matrix)),
    MIP_END,
};

MIP_CODEC(mip_3dm_mag_soft_iron_matrix_response, 0x0C, 0x9D, MIP_RESPONSE, 36, 0,
          MIP_SHAPE(0, 9, 0), program_mag_soft_iron_matrix_response, NULL);

static const uint8_t program_coning_sculling_enable[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_coning_sculling_enable, enable)),
    MIP_END,
};

MIP_CODEC(mip_3dm_coning_sculling_enable, 0x0C, 0x3E, MIP_COMMAND, 0, 0, 0,
          program_coning_sculling_enable, &mip_program);

static const struct mip_response responses_coning_sculling_enable[] = {
    {NULL, 0x9E, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_coning_sculling_enable, 0x0C, 0x3E, 0, 1, responses_coning_sculling_enable,
             true);

static const uint8_t program_coning_sculling_enable_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_coning_sculling_enable_response, enable)),
    MIP_END,
};

MIP_CODEC(mip_3dm_coning_sculling_enable_response, 0x0C, 0x9E, MIP_RESPONSE, 1, 0, 0,
          program_coning_sculling_enable_response, NULL);

static const uint8_t program_uart_baud_rate[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_3dm_uart_baud_rate, baud)),
    MIP_END,
};

MIP_CODEC(mip_3dm_uart_baud_rate, 0x0C, 0x40, MIP_COMMAND, 0, 0, 0, program_uart_baud_rate,
          &mip_program);

static const struct mip_response responses_uart_baud_rate[] = {
    {NULL, 0x87, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_uart_baud_rate, 0x0C, 0x40, 0, 1, responses_uart_baud_rate, true);

static const uint8_t program_uart_baud_rate_response[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_3dm_uart_baud_rate_response, baud)),
    MIP_END,
};

MIP_CODEC(mip_3dm_uart_baud_rate_response, 0x0C, 0x87, MIP_RESPONSE, 4, 0, MIP_SHAPE(0, 1, 0),
          program_uart_baud_rate_response, NULL);

static const uint8_t program_gpio_config[] = {
    MIP_REQUIRED(5, 4, 1, 1, 1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_gpio_config, pin)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_gpio_config, feature)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_gpio_config, behavior)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_gpio_config, pin_mode)),
    MIP_END,
};

MIP_CODEC(mip_3dm_gpio_config, 0x0C, 0x41, MIP_COMMAND, 0, 0, 0, program_gpio_config, &mip_program);

static const struct mip_response responses_gpio_config[] = {
    {NULL, 0xC1, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_gpio_config, 0x0C, 0x41, 0, 1, responses_gpio_config, true);

static const uint8_t program_gpio_config_response[] = {
    MIP_8_BITS(4, MIP_AT(struct mip_3dm_gpio_config_response, pin)),
    MIP_END,
};

MIP_CODEC(mip_3dm_gpio_config_response, 0x0C, 0xC1, MIP_RESPONSE, 4, 0, 0,
          program_gpio_config_response, NULL);

static const uint8_t program_gpio_state[] = {
    MIP_REQUIRED(2, 2, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_gpio_state, pin)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_gpio_state, state)),
    MIP_END,
};

MIP_CODEC(mip_3dm_gpio_state, 0x0C, 0x42, MIP_COMMAND, 0, 0, 0, program_gpio_state, &mip_program);

static const struct mip_response responses_gpio_state[] = {
    {NULL, 0xC2, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_gpio_state, 0x0C, 0x42, 0, 1, responses_gpio_state, true);

static const uint8_t program_gpio_state_response[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_gpio_state_response, pin)),
    MIP_END,
};

MIP_CODEC(mip_3dm_gpio_state_response, 0x0C, 0xC2, MIP_RESPONSE, 2, 0, 0,
          program_gpio_state_response, NULL);

static const uint8_t program_odometer_config[] = {
    MIP_REQUIRED(1, 3),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_odometer_config, mode)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_3dm_odometer_config, scaling)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_3dm_odometer_config, uncertainty)),
    MIP_END,
};

MIP_CODEC(mip_3dm_odometer_config, 0x0C, 0x43, MIP_COMMAND, 0, 0, 0, program_odometer_config,
          &mip_program);

static const struct mip_response responses_odometer_config[] = {
    {NULL, 0xC3, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_odometer_config, 0x0C, 0x43, 0, 1, responses_odometer_config, true);

static const uint8_t program_odometer_config_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_odometer_config_response, mode)),
    MIP_32_BITS(2, MIP_AT(struct mip_3dm_odometer_config_response, scaling)),
    MIP_END,
};

MIP_CODEC(mip_3dm_odometer_config_response, 0x0C, 0xC3, MIP_RESPONSE, 9, 0, 0,
          program_odometer_config_response, NULL);

static const uint8_t program_imu_low_pass_filter[] = {
    MIP_REQUIRED(5, 5, 1, 1, 1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_imu_low_pass_filter, target_descriptor)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_imu_low_pass_filter, enable)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_imu_low_pass_filter, manual)),
    MIP_GROUP(1),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_imu_low_pass_filter, frequency)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_imu_low_pass_filter, reserved)),
    MIP_END,
};

MIP_CODEC(mip_3dm_imu_low_pass_filter, 0x0C, 0x50, MIP_COMMAND, 0, 0, 0,
          program_imu_low_pass_filter, &mip_program);

static const struct mip_response responses_imu_low_pass_filter[] = {
    {NULL, 0x8B, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_imu_low_pass_filter, 0x0C, 0x50, 0, 1, responses_imu_low_pass_filter, true);

static const uint8_t program_imu_low_pass_filter_response[] = {
    MIP_8_BITS(3, MIP_AT(struct mip_3dm_imu_low_pass_filter_response, target_descriptor)),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_imu_low_pass_filter_response, frequency)),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_imu_low_pass_filter_response, reserved)),
    MIP_END,
};

MIP_CODEC(mip_3dm_imu_low_pass_filter_response, 0x0C, 0x8B, MIP_RESPONSE, 6, 0, 0,
          program_imu_low_pass_filter_response, NULL);

static const uint8_t program_complementary_filter[] = {
    MIP_REQUIRED(1, 4),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_complementary_filter, pitch_roll_enable)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_complementary_filter, heading_enable)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_3dm_complementary_filter, pitch_roll_time_constant)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_3dm_complementary_filter, heading_time_constant)),
    MIP_END,
};

MIP_CODEC(mip_3dm_complementary_filter, 0x0C, 0x51, MIP_COMMAND, 0, 0, 0,
          program_complementary_filter, &mip_program);

static const struct mip_response responses_complementary_filter[] = {
    {NULL, 0x97, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_complementary_filter, 0x0C, 0x51, 0, 1, responses_complementary_filter, true);

static const uint8_t program_complementary_filter_response[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_complementary_filter_response, pitch_roll_enable)),
    MIP_32_BITS(2, MIP_AT(struct mip_3dm_complementary_filter_response, pitch_roll_time_constant)),
    MIP_END,
};

MIP_CODEC(mip_3dm_complementary_filter_response, 0x0C, 0x97, MIP_RESPONSE, 10, 0, 0,
          program_complementary_filter_response, NULL);

static const uint8_t program_sensor_range[] = {
    MIP_REQUIRED(5, 2, 1, 1, 1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_sensor_range, sensor)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_sensor_range, setting)),
    MIP_END,
};

MIP_CODEC(mip_3dm_sensor_range, 0x0C, 0x52, MIP_COMMAND, 0, 0, 0, program_sensor_range,
          &mip_program);

static const struct mip_response responses_sensor_range[] = {
    {NULL, 0xD2, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_sensor_range, 0x0C, 0x52, 0, 1, responses_sensor_range, true);

static const uint8_t program_sensor_range_response[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_sensor_range_response, sensor)),
    MIP_END,
};

MIP_CODEC(mip_3dm_sensor_range_response, 0x0C, 0xD2, MIP_RESPONSE, 2, 0, 0,
          program_sensor_range_response, NULL);

static const uint8_t program_get_calibrated_sensor_ranges[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_get_calibrated_sensor_ranges, sensor)),
    MIP_END,
};

MIP_CODEC(mip_3dm_get_calibrated_sensor_ranges, 0x0C, 0x53, MIP_COMMAND, 1, 0, 0,
          program_get_calibrated_sensor_ranges, NULL);

static const struct mip_response responses_get_calibrated_sensor_ranges[] = {
    {NULL, 0xD3, 0, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_3dm_get_calibrated_sensor_ranges, 0x0C, 0x53, 0, 1,
             responses_get_calibrated_sensor_ranges, false);

static const uint8_t program_get_calibrated_sensor_ranges_response[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_get_calibrated_sensor_ranges_response, sensor)),
    MIP_COUNTED(MIP_SIZE(struct mip_3dm_get_calibrated_sensor_ranges_response, num_ranges), 50, 5,
                MIP_AT(struct mip_3dm_get_calibrated_sensor_ranges_response, num_ranges)),
    MIP_EACH(1, struct mip_3dm_sensor_range_entry, 5,
             MIP_AT(struct mip_3dm_get_calibrated_sensor_ranges_response, ranges)),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_sensor_range_entry, setting)),
    MIP_32_BITS(1, MIP_AT(struct mip_3dm_sensor_range_entry, range)),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_3dm_get_calibrated_sensor_ranges_response, 0x0C, 0xD3, MIP_RESPONSE, 0, 0, 0,
          program_get_calibrated_sensor_ranges_response, &mip_program);

static const uint8_t program_low_pass_filter[] = {
    MIP_REQUIRED(5, 5, 2, 2, 2, 2),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_low_pass_filter, descriptor_set)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_low_pass_filter, field_descriptor)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_low_pass_filter, enable)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_low_pass_filter, manual)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_3dm_low_pass_filter, frequency)),
    MIP_END,
};

MIP_CODEC(mip_3dm_low_pass_filter, 0x0C, 0x54, MIP_COMMAND, 0, 0, 0, program_low_pass_filter,
          &mip_program);

static const struct mip_response responses_low_pass_filter[] = {
    {NULL, 0xD4, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_low_pass_filter, 0x0C, 0x54, 0, 1, responses_low_pass_filter, true);

static const uint8_t program_low_pass_filter_response[] = {
    MIP_8_BITS(4, MIP_AT(struct mip_3dm_low_pass_filter_response, descriptor_set)),
    MIP_32_BITS(1, MIP_AT(struct mip_3dm_low_pass_filter_response, frequency)),
    MIP_END,
};

MIP_CODEC(mip_3dm_low_pass_filter_response, 0x0C, 0xD4, MIP_RESPONSE, 8, 0, 0,
          program_low_pass_filter_response, NULL);

static const uint8_t program_data_stream_format[] = {
    MIP_REQUIRED(5, 2, 2, 2, 2, 2),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_data_stream_format, stream)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_data_stream_format, format)),
    MIP_END,
};

MIP_CODEC(mip_3dm_data_stream_format, 0x0C, 0x60, MIP_COMMAND, 0, 0, 0, program_data_stream_format,
          &mip_program);

static const struct mip_response responses_data_stream_format[] = {
    {NULL, 0x88, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_data_stream_format, 0x0C, 0x60, 0, 1, responses_data_stream_format, true);

static const uint8_t program_data_stream_format_response[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_data_stream_format_response, stream)),
    MIP_END,
};

MIP_CODEC(mip_3dm_data_stream_format_response, 0x0C, 0x88, MIP_RESPONSE, 2, 0, 0,
          program_data_stream_format_response, NULL);

static const uint8_t program_device_power_state[] = {
    MIP_REQUIRED(5, 2, 1, 1, 1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_device_power_state, device)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_device_power_state, state)),
    MIP_END,
};

MIP_CODEC(mip_3dm_device_power_state, 0x0C, 0x61, MIP_COMMAND, 0, 0, 0, program_device_power_state,
          &mip_program);

static const struct mip_response responses_device_power_state[] = {
    {NULL, 0x89, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_3dm_device_power_state, 0x0C, 0x61, 20, 1, responses_device_power_state, true);

static const uint8_t program_device_power_state_response[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_device_power_state_response, device)),
    MIP_END,
};

MIP_CODEC(mip_3dm_device_power_state_response, 0x0C, 0x89, MIP_RESPONSE, 2, 0, 0,
          program_device_power_state_response, NULL);

static const uint8_t program_gps_advanced_settings[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_gps_advanced_settings, function)),
    MIP_END,
};

MIP_CODEC(mip_3dm_gps_advanced_settings, 0x0C, 0x62, MIP_COMMAND, 1, 0, 0,
          program_gps_advanced_settings, NULL);

MIP_EXCHANGE(mip_3dm_gps_advanced_settings, 0x0C, 0x62, 0, 0, NULL, true);

static const uint8_t program_device_status[] = {
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_device_status, model_number)),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_device_status, status_selector)),
    MIP_END,
};

MIP_CODEC(mip_3dm_device_status, 0x0C, 0x64, MIP_COMMAND, 3, 0, 0, program_device_status, NULL);

static const struct mip_response responses_device_status[] = {
    {&mip_3dm_device_status_basic_rq1_imu_response_codec, 0x90, 4, 1, true},
    {&mip_3dm_device_status_basic_response_codec, 0x90, 4, 1, true},
    {&mip_3dm_device_status_basic_without_state_response_codec, 0x90, 4, 1, true},
    {&mip_3dm_device_status_basic_gx3_response_codec, 0x90, 4, 1, false},
    {&mip_3dm_device_status_diagnostic_response_codec, 0x90, 4, 2, true},
    {&mip_3dm_device_status_diagnostic_gnss_response_codec, 0x90, 4, 2, true},
    {&mip_3dm_device_status_diagnostic_gq4_45_response_codec, 0x90, 4, 2, true},
    {&mip_3dm_device_status_diagnostic_rq1_45_response_codec, 0x90, 4, 2, true},
    {&mip_3dm_device_status_diagnostic_gx4_response_codec, 0x90, 4, 2, true},
    {&mip_3dm_device_status_diagnostic_imu_response_codec, 0x90, 4, 2, true},
    {&mip_3dm_device_status_diagnostic_gx4_imu_response_codec, 0x90, 4, 2, true},
    {&mip_3dm_device_status_diagnostic_rq1_imu_response_codec, 0x90, 4, 2, true},
    {&mip_3dm_device_status_diagnostic_gx3_response_codec, 0x90, 4, 2, false},
};

MIP_EXCHANGE(mip_3dm_device_status, 0x0C, 0x64, 0, 13, responses_device_status, false);

static const uint8_t program_device_status_basic_rq1_imu_response[] = {
    MIP_LAYOUT(15, 253, 3, 0, 0x18, 1, 0x5E, 2, 0x01),
    MIP_CONSTANT(2, 0x18, 0x5E),
    MIP_CONSTANT(1, 0x01),
    MIP_32_BITS(1, MIP_AT(struct mip_3dm_device_status_basic_rq1_imu_response, status_flags)),
    MIP_64_BITS(1, MIP_AT(struct mip_3dm_device_status_basic_rq1_imu_response, system_timer)),
    MIP_END,
};

MIP_CODEC(mip_3dm_device_status_basic_rq1_imu_response, 0x0C, 0x90, MIP_RESPONSE, 0, 0, 0,
          program_device_status_basic_rq1_imu_response, &mip_layout);

static const uint8_t program_device_status_basic_response[] = {
    MIP_LAYOUT(13, 14, 1, 2, 0x01),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_device_status_basic_response, model_number)),
    MIP_CONSTANT(1, 0x01),
    MIP_32_BITS(1, MIP_AT(struct mip_3dm_device_status_basic_response, status_flags)),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_device_status_basic_response, system_state)),
    MIP_32_BITS(1, MIP_AT(struct mip_3dm_device_status_basic_response, system_timer)),
    MIP_END,
};

MIP_CODEC(mip_3dm_device_status_basic_response, 0x0C, 0x90, MIP_RESPONSE, 0, 0, 0,
          program_device_status_basic_response, &mip_layout);

static const uint8_t program_device_status_basic_without_state_response[] = {
    MIP_LAYOUT(0, 12, 1, 2, 0x01),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_device_status_basic_without_state_response, model_number)),
    MIP_CONSTANT(1, 0x01),
    MIP_32_BITS(2, MIP_AT(struct mip_3dm_device_status_basic_without_state_response, status_flags)),
    MIP_END,
};

MIP_CODEC(mip_3dm_device_status_basic_without_state_response, 0x0C, 0x90, MIP_RESPONSE, 0, 0, 0,
          program_device_status_basic_without_state_response, &mip_layout);

static const uint8_t program_device_status_diagnostic_response[] = {
    MIP_LAYOUT(0, 59, 1, 2, 0x02),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_device_status_diagnostic_response, model_number)),
    MIP_CONSTANT(1, 0x02),
    MIP_32_BITS(1, MIP_AT(struct mip_3dm_device_status_diagnostic_response, status_flags)),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_device_status_diagnostic_response, system_state)),
    MIP_32_BITS(1, MIP_AT(struct mip_3dm_device_status_diagnostic_response, system_timer)),
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_device_status_diagnostic_response, imu_stream_enabled)),
    MIP_32_BITS(9, MIP_AT(struct mip_3dm_device_status_diagnostic_response, imu_dropped_packets)),
    MIP_END,
};

MIP_CODEC(mip_3dm_device_status_diagnostic_response, 0x0C, 0x90, MIP_RESPONSE, 0, 0, 0,
          program_device_status_diagnostic_response, &mip_layout);

static const uint8_t program_device_status_diagnostic_gnss_response[] = {
    MIP_LAYOUT(77, 79, 1, 2, 0x02),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_device_status_diagnostic_gnss_response, model_number)),
    MIP_CONSTANT(1, 0x02),
    MIP_32_BITS(1, MIP_AT(struct mip_3dm_device_status_diagnostic_gnss_response, status_flags)),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_device_status_diagnostic_gnss_response, system_state)),
    MIP_32_BITS(1, MIP_AT(struct mip_3dm_device_status_diagnostic_gnss_response, system_timer)),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_device_status_diagnostic_gnss_response, gnss_power_state)),
    MIP_32_BITS(2, MIP_AT(struct mip_3dm_device_status_diagnostic_gnss_response, pps_count)),
    MIP_8_BITS(3,
               MIP_AT(struct mip_3dm_device_status_diagnostic_gnss_response, imu_stream_enabled)),
    MIP_32_BITS(13,
                MIP_AT(struct mip_3dm_device_status_diagnostic_gnss_response, imu_dropped_packets)),
    MIP_END,
};

MIP_CODEC(mip_3dm_device_status_diagnostic_gnss_response, 0x0C, 0x90, MIP_RESPONSE, 0, 0, 0,
          program_device_status_diagnostic_gnss_response, &mip_layout);

static const uint8_t program_device_status_diagnostic_gq4_45_response[] = {
    MIP_LAYOUT(80, 85, 1, 2, 0x02),
    MIP_FAR,
    MIP_16_BITS(1,
                MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_gq4_45_response, model_number)),
    MIP_CONSTANT(1, 0x02),
    MIP_32_BITS(1,
                MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_gq4_45_response, status_flags)),
    MIP_16_BITS(1,
                MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_gq4_45_response, system_state)),
    MIP_32_BITS(1,
                MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_gq4_45_response, system_timer)),
    MIP_8_BITS(
        1, MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_gq4_45_response, gnss_power_state)),
    MIP_32_BITS(2, MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_gq4_45_response, pps_count)),
    MIP_8_BITS(
        3, MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_gq4_45_response, imu_stream_enabled)),
    MIP_32_BITS(13, MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_gq4_45_response,
                               imu_dropped_packets)),
    MIP_8_BITS(
        3, MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_gq4_45_response, mag_init_failed)),
    MIP_END,
};

MIP_CODEC(mip_3dm_device_status_diagnostic_gq4_45_response, 0x0C, 0x90, MIP_RESPONSE, 0, 0, 0,
          program_device_status_diagnostic_gq4_45_response, &mip_layout);

static const uint8_t program_device_status_diagnostic_rq1_45_response[] = {
    MIP_LAYOUT(86, 104, 1, 2, 0x02),
    MIP_FAR,
    MIP_16_BITS(1,
                MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_rq1_45_response, model_number)),
    MIP_CONSTANT(1, 0x02),
    MIP_32_BITS(1,
                MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_rq1_45_response, status_flags)),
    MIP_16_BITS(1,
                MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_rq1_45_response, system_state)),
    MIP_32_BITS(1,
                MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_rq1_45_response, system_timer)),
    MIP_8_BITS(
        2, MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_rq1_45_response, gnss_power_state)),
    MIP_32_BITS(4,
                MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_rq1_45_response, temperature)),
    MIP_8_BITS(
        3, MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_rq1_45_response, imu_stream_enabled)),
    MIP_32_BITS(13, MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_rq1_45_response,
                               imu_dropped_packets)),
    MIP_END,
};

MIP_CODEC(mip_3dm_device_status_diagnostic_rq1_45_response, 0x0C, 0x90, MIP_RESPONSE, 0, 0, 0,
          program_device_status_diagnostic_rq1_45_response, &mip_layout);

static const uint8_t program_device_status_diagnostic_gx4_response[] = {
    MIP_LAYOUT(73, 76, 1, 2, 0x02),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_device_status_diagnostic_gx4_response, model_number)),
    MIP_CONSTANT(1, 0x02),
    MIP_32_BITS(4, MIP_AT(struct mip_3dm_device_status_diagnostic_gx4_response, status_flags)),
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_device_status_diagnostic_gx4_response, imu_stream_enabled)),
    MIP_32_BITS(13,
                MIP_AT(struct mip_3dm_device_status_diagnostic_gx4_response, imu_dropped_packets)),
    MIP_END,
};

MIP_CODEC(mip_3dm_device_status_diagnostic_gx4_response, 0x0C, 0x90, MIP_RESPONSE, 0, 0, 0,
          program_device_status_diagnostic_gx4_response, &mip_layout);

static const uint8_t program_device_status_diagnostic_imu_response[] = {
    MIP_LAYOUT(60, 60, 1, 2, 0x02),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_device_status_diagnostic_imu_response, model_number)),
    MIP_CONSTANT(1, 0x02),
    MIP_32_BITS(2, MIP_AT(struct mip_3dm_device_status_diagnostic_imu_response, status_flags)),
    MIP_8_BITS(3, MIP_AT(struct mip_3dm_device_status_diagnostic_imu_response, has_mag)),
    MIP_16_BITS(2, MIP_AT(struct mip_3dm_device_status_diagnostic_imu_response, gyro_range)),
    MIP_32_BITS(3, MIP_AT(struct mip_3dm_device_status_diagnostic_imu_response, reserved)),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_device_status_diagnostic_imu_response, temperature_error)),
    MIP_32_BITS(2, MIP_AT(struct mip_3dm_device_status_diagnostic_imu_response, pps_count)),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_device_status_diagnostic_imu_response, imu_stream_enabled)),
    MIP_32_BITS(5,
                MIP_AT(struct mip_3dm_device_status_diagnostic_imu_response, imu_dropped_packets)),
    MIP_END,
};

MIP_CODEC(mip_3dm_device_status_diagnostic_imu_response, 0x0C, 0x90, MIP_RESPONSE, 0, 0, 0,
          program_device_status_diagnostic_imu_response, &mip_layout);

static const uint8_t program_device_status_diagnostic_gx4_imu_response[] = {
    MIP_LAYOUT(62, 72, 1, 2, 0x02),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_device_status_diagnostic_gx4_imu_response, model_number)),
    MIP_CONSTANT(1, 0x02),
    MIP_32_BITS(2, MIP_AT(struct mip_3dm_device_status_diagnostic_gx4_imu_response, status_flags)),
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_device_status_diagnostic_gx4_imu_response, has_mag)),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_device_status_diagnostic_gx4_imu_response, gyro_range)),
    MIP_8_BITS(1, MIP_AT(struct mip_3dm_device_status_diagnostic_gx4_imu_response, accel_range)),
    MIP_32_BITS(4, MIP_AT(struct mip_3dm_device_status_diagnostic_gx4_imu_response, mag_range)),
    MIP_8_BITS(1,
               MIP_AT(struct mip_3dm_device_status_diagnostic_gx4_imu_response, temperature_error)),
    MIP_32_BITS(2, MIP_AT(struct mip_3dm_device_status_diagnostic_gx4_imu_response, pps_count)),
    MIP_8_BITS(
        1, MIP_AT(struct mip_3dm_device_status_diagnostic_gx4_imu_response, imu_stream_enabled)),
    MIP_32_BITS(
        5, MIP_AT(struct mip_3dm_device_status_diagnostic_gx4_imu_response, imu_dropped_packets)),
    MIP_END,
};

MIP_CODEC(mip_3dm_device_status_diagnostic_gx4_imu_response, 0x0C, 0x90, MIP_RESPONSE, 0, 0, 0,
          program_device_status_diagnostic_gx4_imu_response, &mip_layout);

static const uint8_t program_device_status_diagnostic_rq1_imu_response[] = {
    MIP_LAYOUT(61, 61, 1, 2, 0x02),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_device_status_diagnostic_rq1_imu_response, model_number)),
    MIP_CONSTANT(1, 0x02),
    MIP_32_BITS(1, MIP_AT(struct mip_3dm_device_status_diagnostic_rq1_imu_response, status_flags)),
    MIP_64_BITS(1, MIP_AT(struct mip_3dm_device_status_diagnostic_rq1_imu_response, system_timer)),
    MIP_32_BITS(2, MIP_AT(struct mip_3dm_device_status_diagnostic_rq1_imu_response, temperature)),
    MIP_8_BITS(3, MIP_AT(struct mip_3dm_device_status_diagnostic_rq1_imu_response,
                         bad_temperature_sensor_detected)),
    MIP_32_BITS(2, MIP_AT(struct mip_3dm_device_status_diagnostic_rq1_imu_response, pps_count)),
    MIP_8_BITS(
        1, MIP_AT(struct mip_3dm_device_status_diagnostic_rq1_imu_response, imu_stream_enabled)),
    MIP_32_BITS(
        1, MIP_AT(struct mip_3dm_device_status_diagnostic_rq1_imu_response, imu_dropped_packets)),
    MIP_16_BITS(1,
                MIP_AT(struct mip_3dm_device_status_diagnostic_rq1_imu_response, comm_port_state)),
    MIP_32_BITS(
        5, MIP_AT(struct mip_3dm_device_status_diagnostic_rq1_imu_response, comm_port_baud_rate)),
    MIP_END,
};

MIP_CODEC(mip_3dm_device_status_diagnostic_rq1_imu_response, 0x0C, 0x90, MIP_RESPONSE, 0, 0, 0,
          program_device_status_diagnostic_rq1_imu_response, &mip_layout);

static const uint8_t program_device_status_basic_gx3_response[] = {
    MIP_LAYOUT(15, 253, 1, 2, 0x01),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_device_status_basic_gx3_response, model_number)),
    MIP_CONSTANT(1, 0x01),
    MIP_8_BITS(2, MIP_AT(struct mip_3dm_device_status_basic_gx3_response, comm_mode)),
    MIP_32_BITS(1, MIP_AT(struct mip_3dm_device_status_basic_gx3_response, settings_flags)),
    MIP_16_BITS(1, MIP_AT(struct mip_3dm_device_status_basic_gx3_response, comm_state)),
    MIP_32_BITS(1, MIP_AT(struct mip_3dm_device_status_basic_gx3_response, comm_baud_rate)),
    MIP_END,
};

MIP_CODEC(mip_3dm_device_status_basic_gx3_response, 0x0C, 0x90, MIP_RESPONSE, 0, 0, 0,
          program_device_status_basic_gx3_response, &mip_layout);

static const uint8_t program_device_status_diagnostic_gx3_response[] = {
    MIP_LAYOUT(105, 253, 1, 2, 0x02),
    MIP_FAR,
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_gx3_response, model_number)),
    MIP_CONSTANT(1, 0x02),
    MIP_8_BITS(2, MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_gx3_response, comm_mode)),
    MIP_32_BITS(1,
                MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_gx3_response, settings_flags)),
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_gx3_response, comm_state)),
    MIP_32_BITS(5,
                MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_gx3_response, comm_baud_rate)),
    MIP_16_BITS(1, MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_gx3_response, usb_state)),
    MIP_32_BITS(
        4, MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_gx3_response, usb_bytes_written)),
    MIP_16_BITS(
        2, MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_gx3_response, gnss_driver_state)),
    MIP_32_BITS(
        6, MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_gx3_response, gnss_bytes_written)),
    MIP_16_BITS(2,
                MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_gx3_response, imu_driver_state)),
    MIP_32_BITS(
        6, MIP_FAR_AT(struct mip_3dm_device_status_diagnostic_gx3_response, imu_bytes_written)),
    MIP_END,
};

MIP_CODEC(mip_3dm_device_status_diagnostic_gx3_response, 0x0C, 0x90, MIP_RESPONSE, 0, 0, 0,
          program_device_status_diagnostic_gx3_response, &mip_layout);
