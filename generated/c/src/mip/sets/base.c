/* Base. */
#include "mip/base.h"
#include "mip/base_commands.h"
#include "mip/core/program.h"

static const uint8_t program_ping[] = {
    MIP_END,
};

MIP_CODEC(mip_base_ping, 0x01, 0x01, MIP_COMMAND, 0, 0, 0, program_ping, NULL);

MIP_EXCHANGE(mip_base_ping, 0x01, 0x01, 0, 0, NULL, false);

static const uint8_t program_set_idle[] = {
    MIP_END,
};

MIP_CODEC(mip_base_set_idle, 0x01, 0x02, MIP_COMMAND, 0, 0, 0, program_set_idle, NULL);

MIP_EXCHANGE(mip_base_set_idle, 0x01, 0x02, 0, 0, NULL, false);

static const uint8_t program_get_device_info[] = {
    MIP_END,
};

MIP_CODEC(mip_base_get_device_info, 0x01, 0x03, MIP_COMMAND, 0, 0, 0, program_get_device_info,
          NULL);

static const struct mip_response responses_get_device_info[] = {
    {NULL, 0x81, 0, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_base_get_device_info, 0x01, 0x03, 0, 1, responses_get_device_info, false);

static const uint8_t program_get_device_info_response[] = {
    MIP_16_BITS(1, MIP_AT(struct mip_base_get_device_info_response, device_info.firmware_version)),
    MIP_8_BITS(16, MIP_AT(struct mip_base_get_device_info_response, device_info.model_name)),
    MIP_8_BITS(16, MIP_AT(struct mip_base_get_device_info_response, device_info.model_number)),
    MIP_8_BITS(16, MIP_AT(struct mip_base_get_device_info_response, device_info.serial_number)),
    MIP_8_BITS(16, MIP_AT(struct mip_base_get_device_info_response, device_info.lot_number)),
    MIP_8_BITS(16, MIP_AT(struct mip_base_get_device_info_response, device_info.device_options)),
    MIP_END,
};

MIP_CODEC(mip_base_get_device_info_response, 0x01, 0x81, MIP_RESPONSE, 82, 0, 0,
          program_get_device_info_response, NULL);

static const uint8_t program_get_device_descriptors[] = {
    MIP_END,
};

MIP_CODEC(mip_base_get_device_descriptors, 0x01, 0x04, MIP_COMMAND, 0, 0, 0,
          program_get_device_descriptors, NULL);

static const struct mip_response responses_get_device_descriptors[] = {
    {NULL, 0x82, 0, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_base_get_device_descriptors, 0x01, 0x04, 0, 1, responses_get_device_descriptors,
             false);

static const uint8_t program_get_device_descriptors_response[] = {
    MIP_REST(126, 2, MIP_AT(struct mip_base_get_device_descriptors_response, descriptors_count)),
    MIP_16_BITS(1, MIP_AT(struct mip_base_get_device_descriptors_response, descriptors)),
    MIP_END,
};

MIP_CODEC(mip_base_get_device_descriptors_response, 0x01, 0x82, MIP_RESPONSE, 0, 0, 0,
          program_get_device_descriptors_response, &mip_program);

static const uint8_t program_built_in_test[] = {
    MIP_END,
};

MIP_CODEC(mip_base_built_in_test, 0x01, 0x05, MIP_COMMAND, 0, 0, 0, program_built_in_test, NULL);

static const struct mip_response responses_built_in_test[] = {
    {NULL, 0x83, 0, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_base_built_in_test, 0x01, 0x05, 40, 1, responses_built_in_test, false);

static const uint8_t program_built_in_test_response[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_base_built_in_test_response, result)),
    MIP_END,
};

MIP_CODEC(mip_base_built_in_test_response, 0x01, 0x83, MIP_RESPONSE, 4, 0, MIP_SHAPE(0, 1, 0),
          program_built_in_test_response, NULL);

static const uint8_t program_resume[] = {
    MIP_END,
};

MIP_CODEC(mip_base_resume, 0x01, 0x06, MIP_COMMAND, 0, 0, 0, program_resume, NULL);

MIP_EXCHANGE(mip_base_resume, 0x01, 0x06, 0, 0, NULL, false);

static const uint8_t program_get_extended_descriptors[] = {
    MIP_END,
};

MIP_CODEC(mip_base_get_extended_descriptors, 0x01, 0x07, MIP_COMMAND, 0, 0, 0,
          program_get_extended_descriptors, NULL);

static const struct mip_response responses_get_extended_descriptors[] = {
    {NULL, 0x86, 0, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_base_get_extended_descriptors, 0x01, 0x07, 0, 1,
             responses_get_extended_descriptors, false);

static const uint8_t program_get_extended_descriptors_response[] = {
    MIP_REST(126, 2, MIP_AT(struct mip_base_get_extended_descriptors_response, descriptors_count)),
    MIP_16_BITS(1, MIP_AT(struct mip_base_get_extended_descriptors_response, descriptors)),
    MIP_END,
};

MIP_CODEC(mip_base_get_extended_descriptors_response, 0x01, 0x86, MIP_RESPONSE, 0, 0, 0,
          program_get_extended_descriptors_response, &mip_program);

static const uint8_t program_continuous_built_in_test[] = {
    MIP_END,
};

MIP_CODEC(mip_base_continuous_built_in_test, 0x01, 0x08, MIP_COMMAND, 0, 0, 0,
          program_continuous_built_in_test, NULL);

static const struct mip_response responses_continuous_built_in_test[] = {
    {NULL, 0x88, 0, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_base_continuous_built_in_test, 0x01, 0x08, 0, 1,
             responses_continuous_built_in_test, false);

static const uint8_t program_continuous_built_in_test_response[] = {
    MIP_8_BITS(16, MIP_AT(struct mip_base_continuous_built_in_test_response, result)),
    MIP_END,
};

MIP_CODEC(mip_base_continuous_built_in_test_response, 0x01, 0x88, MIP_RESPONSE, 16, 0, 0,
          program_continuous_built_in_test_response, NULL);

static const uint8_t program_comm_speed[] = {
    MIP_REQUIRED(5, 2, 1, 1, 1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_base_comm_speed, port)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_base_comm_speed, baud)),
    MIP_END,
};

MIP_CODEC(mip_base_comm_speed, 0x01, 0x09, MIP_COMMAND, 0, 0, 0, program_comm_speed, &mip_program);

static const struct mip_response responses_comm_speed[] = {
    {NULL, 0x89, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_base_comm_speed, 0x01, 0x09, 0, 1, responses_comm_speed, true);

static const uint8_t program_comm_speed_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_base_comm_speed_response, port)),
    MIP_32_BITS(1, MIP_AT(struct mip_base_comm_speed_response, baud)),
    MIP_END,
};

MIP_CODEC(mip_base_comm_speed_response, 0x01, 0x89, MIP_RESPONSE, 5, 0, 0,
          program_comm_speed_response, NULL);

static const uint8_t program_gps_time_update[] = {
    MIP_REQUIRED(6, 2, 1, 0, 0, 0, 2),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_base_gps_time_update, field_id)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_base_gps_time_update, value)),
    MIP_END,
};

MIP_CODEC(mip_base_gps_time_update, 0x01, 0x72, MIP_COMMAND, 0, 0, 0, program_gps_time_update,
          &mip_program);

static const struct mip_response responses_gps_time_update[] = {
    {NULL, 0x00, 2, MIP_FUNCTION_SELECTOR_APPLY, false},
    {NULL, 0x84, 2, MIP_FUNCTION_SELECTOR_READ, true},
    {NULL, 0x84, 3, 1, false},
    {NULL, 0x85, 2, MIP_FUNCTION_SELECTOR_READ, true},
    {NULL, 0x85, 3, 2, false},
};

MIP_EXCHANGE(mip_base_gps_time_update, 0x01, 0x72, 0, 5, responses_gps_time_update, true);

static const uint8_t program_gps_time_update_week_number_response[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_base_gps_time_update_week_number_response, week_number)),
    MIP_END,
};

MIP_CODEC(mip_base_gps_time_update_week_number_response, 0x01, 0x84, MIP_RESPONSE, 4, 0,
          MIP_SHAPE(0, 1, 0), program_gps_time_update_week_number_response, NULL);

static const uint8_t program_gps_time_update_tow_response[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_base_gps_time_update_tow_response, tow)),
    MIP_END,
};

MIP_CODEC(mip_base_gps_time_update_tow_response, 0x01, 0x85, MIP_RESPONSE, 4, 0, MIP_SHAPE(0, 1, 0),
          program_gps_time_update_tow_response, NULL);

static const uint8_t program_soft_reset[] = {
    MIP_END,
};

MIP_CODEC(mip_base_soft_reset, 0x01, 0x7E, MIP_COMMAND, 0, 0, 0, program_soft_reset, NULL);

MIP_EXCHANGE(mip_base_soft_reset, 0x01, 0x7E, 0, 0, NULL, false);
