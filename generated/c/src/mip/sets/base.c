/* Base. */
#include "mip/base.h"
#include "mip/base_commands.h"
#include "mip/core/program.h"

static const uint8_t program_ping[] = {
    MIP_END,
};

const struct mip_codec mip_base_ping_codec = {
    0x01, 0x01, MIP_COMMAND, 0, sizeof(struct mip_base_ping), 0, 0, program_ping, NULL};

const struct mip_exchange mip_base_ping_exchange = {0x01, 0x01, 0, 0, NULL};

const struct mip_command mip_base_ping_command = {&mip_base_ping_codec, &mip_base_ping_exchange,
                                                  false};

static const uint8_t program_set_idle[] = {
    MIP_END,
};

const struct mip_codec mip_base_set_idle_codec = {
    0x01, 0x02, MIP_COMMAND, 0, sizeof(struct mip_base_set_idle), 0, 0, program_set_idle, NULL};

const struct mip_exchange mip_base_set_idle_exchange = {0x01, 0x02, 0, 0, NULL};

const struct mip_command mip_base_set_idle_command = {&mip_base_set_idle_codec,
                                                      &mip_base_set_idle_exchange, false};

static const uint8_t program_get_device_info[] = {
    MIP_END,
};

const struct mip_codec mip_base_get_device_info_codec = {0x01,
                                                         0x03,
                                                         MIP_COMMAND,
                                                         0,
                                                         sizeof(struct mip_base_get_device_info),
                                                         0,
                                                         0,
                                                         program_get_device_info,
                                                         NULL};

static const struct mip_response responses_get_device_info[] = {
    {NULL, 0x81, 0, MIP_NOT_ZERO, false},
};

const struct mip_exchange mip_base_get_device_info_exchange = {
    0x01, 0x03, 0, sizeof(responses_get_device_info) / sizeof(responses_get_device_info[0]),
    responses_get_device_info};

const struct mip_command mip_base_get_device_info_command = {
    &mip_base_get_device_info_codec, &mip_base_get_device_info_exchange, false};

static const uint8_t program_get_device_info_response[] = {
    MIP_16_BITS(1, MIP_AT(struct mip_base_get_device_info_response, device_info.firmware_version)),
    MIP_8_BITS(16, MIP_AT(struct mip_base_get_device_info_response, device_info.model_name)),
    MIP_8_BITS(16, MIP_AT(struct mip_base_get_device_info_response, device_info.model_number)),
    MIP_8_BITS(16, MIP_AT(struct mip_base_get_device_info_response, device_info.serial_number)),
    MIP_8_BITS(16, MIP_AT(struct mip_base_get_device_info_response, device_info.lot_number)),
    MIP_8_BITS(16, MIP_AT(struct mip_base_get_device_info_response, device_info.device_options)),
    MIP_END,
};

const struct mip_codec mip_base_get_device_info_response_codec = {
    0x01,
    0x81,
    MIP_RESPONSE,
    82,
    sizeof(struct mip_base_get_device_info_response),
    0,
    0,
    program_get_device_info_response,
    NULL};

static const uint8_t program_get_device_descriptors[] = {
    MIP_END,
};

const struct mip_codec mip_base_get_device_descriptors_codec = {
    0x01,
    0x04,
    MIP_COMMAND,
    0,
    sizeof(struct mip_base_get_device_descriptors),
    0,
    0,
    program_get_device_descriptors,
    NULL};

static const struct mip_response responses_get_device_descriptors[] = {
    {NULL, 0x82, 0, MIP_NOT_ZERO, false},
};

const struct mip_exchange mip_base_get_device_descriptors_exchange = {
    0x01, 0x04, 0,
    sizeof(responses_get_device_descriptors) / sizeof(responses_get_device_descriptors[0]),
    responses_get_device_descriptors};

const struct mip_command mip_base_get_device_descriptors_command = {
    &mip_base_get_device_descriptors_codec, &mip_base_get_device_descriptors_exchange, false};

static const uint8_t program_get_device_descriptors_response[] = {
    MIP_REST(126, 2, MIP_AT(struct mip_base_get_device_descriptors_response, descriptors_count)),
    MIP_16_BITS(1, MIP_AT(struct mip_base_get_device_descriptors_response, descriptors)),
    MIP_END,
};

const struct mip_codec mip_base_get_device_descriptors_response_codec = {
    0x01,
    0x82,
    MIP_RESPONSE,
    0,
    sizeof(struct mip_base_get_device_descriptors_response),
    0,
    0,
    program_get_device_descriptors_response,
    &mip_program};

static const uint8_t program_built_in_test[] = {
    MIP_END,
};

const struct mip_codec mip_base_built_in_test_codec = {
    0x01, 0x05, MIP_COMMAND,           0,   sizeof(struct mip_base_built_in_test),
    0,    0,    program_built_in_test, NULL};

static const struct mip_response responses_built_in_test[] = {
    {NULL, 0x83, 0, MIP_NOT_ZERO, false},
};

const struct mip_exchange mip_base_built_in_test_exchange = {
    0x01, 0x05, 40, sizeof(responses_built_in_test) / sizeof(responses_built_in_test[0]),
    responses_built_in_test};

const struct mip_command mip_base_built_in_test_command = {&mip_base_built_in_test_codec,
                                                           &mip_base_built_in_test_exchange, false};

static const uint8_t program_built_in_test_response[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_base_built_in_test_response, result)),
    MIP_END,
};

const struct mip_codec mip_base_built_in_test_response_codec = {
    0x01,
    0x83,
    MIP_RESPONSE,
    4,
    sizeof(struct mip_base_built_in_test_response),
    0,
    MIP_SHAPE(0, 1, 0),
    program_built_in_test_response,
    NULL};

static const uint8_t program_resume[] = {
    MIP_END,
};

const struct mip_codec mip_base_resume_codec = {
    0x01, 0x06, MIP_COMMAND, 0, sizeof(struct mip_base_resume), 0, 0, program_resume, NULL};

const struct mip_exchange mip_base_resume_exchange = {0x01, 0x06, 0, 0, NULL};

const struct mip_command mip_base_resume_command = {&mip_base_resume_codec,
                                                    &mip_base_resume_exchange, false};

static const uint8_t program_get_extended_descriptors[] = {
    MIP_END,
};

const struct mip_codec mip_base_get_extended_descriptors_codec = {
    0x01,
    0x07,
    MIP_COMMAND,
    0,
    sizeof(struct mip_base_get_extended_descriptors),
    0,
    0,
    program_get_extended_descriptors,
    NULL};

static const struct mip_response responses_get_extended_descriptors[] = {
    {NULL, 0x86, 0, MIP_NOT_ZERO, false},
};

const struct mip_exchange mip_base_get_extended_descriptors_exchange = {
    0x01, 0x07, 0,
    sizeof(responses_get_extended_descriptors) / sizeof(responses_get_extended_descriptors[0]),
    responses_get_extended_descriptors};

const struct mip_command mip_base_get_extended_descriptors_command = {
    &mip_base_get_extended_descriptors_codec, &mip_base_get_extended_descriptors_exchange, false};

static const uint8_t program_get_extended_descriptors_response[] = {
    MIP_REST(126, 2, MIP_AT(struct mip_base_get_extended_descriptors_response, descriptors_count)),
    MIP_16_BITS(1, MIP_AT(struct mip_base_get_extended_descriptors_response, descriptors)),
    MIP_END,
};

const struct mip_codec mip_base_get_extended_descriptors_response_codec = {
    0x01,
    0x86,
    MIP_RESPONSE,
    0,
    sizeof(struct mip_base_get_extended_descriptors_response),
    0,
    0,
    program_get_extended_descriptors_response,
    &mip_program};

static const uint8_t program_continuous_built_in_test[] = {
    MIP_END,
};

const struct mip_codec mip_base_continuous_built_in_test_codec = {
    0x01,
    0x08,
    MIP_COMMAND,
    0,
    sizeof(struct mip_base_continuous_built_in_test),
    0,
    0,
    program_continuous_built_in_test,
    NULL};

static const struct mip_response responses_continuous_built_in_test[] = {
    {NULL, 0x88, 0, MIP_NOT_ZERO, false},
};

const struct mip_exchange mip_base_continuous_built_in_test_exchange = {
    0x01, 0x08, 0,
    sizeof(responses_continuous_built_in_test) / sizeof(responses_continuous_built_in_test[0]),
    responses_continuous_built_in_test};

const struct mip_command mip_base_continuous_built_in_test_command = {
    &mip_base_continuous_built_in_test_codec, &mip_base_continuous_built_in_test_exchange, false};

static const uint8_t program_continuous_built_in_test_response[] = {
    MIP_8_BITS(16, MIP_AT(struct mip_base_continuous_built_in_test_response, result)),
    MIP_END,
};

const struct mip_codec mip_base_continuous_built_in_test_response_codec = {
    0x01,
    0x88,
    MIP_RESPONSE,
    16,
    sizeof(struct mip_base_continuous_built_in_test_response),
    0,
    0,
    program_continuous_built_in_test_response,
    NULL};

static const uint8_t program_comm_speed[] = {
    MIP_REQUIRED(5, 2, 1, 1, 1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_base_comm_speed, port)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_base_comm_speed, baud)),
    MIP_END,
};

const struct mip_codec mip_base_comm_speed_codec = {
    0x01, 0x09, MIP_COMMAND,        0,           sizeof(struct mip_base_comm_speed),
    0,    0,    program_comm_speed, &mip_program};

static const struct mip_response responses_comm_speed[] = {
    {NULL, 0x89, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

const struct mip_exchange mip_base_comm_speed_exchange = {
    0x01, 0x09, 0, sizeof(responses_comm_speed) / sizeof(responses_comm_speed[0]),
    responses_comm_speed};

const struct mip_command mip_base_comm_speed_command = {&mip_base_comm_speed_codec,
                                                        &mip_base_comm_speed_exchange, true};

static const uint8_t program_comm_speed_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_base_comm_speed_response, port)),
    MIP_32_BITS(1, MIP_AT(struct mip_base_comm_speed_response, baud)),
    MIP_END,
};

const struct mip_codec mip_base_comm_speed_response_codec = {
    0x01,
    0x89,
    MIP_RESPONSE,
    5,
    sizeof(struct mip_base_comm_speed_response),
    0,
    0,
    program_comm_speed_response,
    NULL};

static const uint8_t program_gps_time_update[] = {
    MIP_REQUIRED(6, 2, 1, 0, 0, 0, 2),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_base_gps_time_update, field_id)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_base_gps_time_update, value)),
    MIP_END,
};

const struct mip_codec mip_base_gps_time_update_codec = {0x01,
                                                         0x72,
                                                         MIP_COMMAND,
                                                         0,
                                                         sizeof(struct mip_base_gps_time_update),
                                                         0,
                                                         0,
                                                         program_gps_time_update,
                                                         &mip_program};

static const struct mip_response responses_gps_time_update[] = {
    {NULL, 0x00, 2, MIP_FUNCTION_SELECTOR_APPLY, false},
    {NULL, 0x84, 2, MIP_FUNCTION_SELECTOR_READ, true},
    {NULL, 0x84, 3, 1, false},
    {NULL, 0x85, 2, MIP_FUNCTION_SELECTOR_READ, true},
    {NULL, 0x85, 3, 2, false},
};

const struct mip_exchange mip_base_gps_time_update_exchange = {
    0x01, 0x72, 0, sizeof(responses_gps_time_update) / sizeof(responses_gps_time_update[0]),
    responses_gps_time_update};

const struct mip_command mip_base_gps_time_update_command = {
    &mip_base_gps_time_update_codec, &mip_base_gps_time_update_exchange, true};

static const uint8_t program_gps_time_update_week_number_response[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_base_gps_time_update_week_number_response, week_number)),
    MIP_END,
};

const struct mip_codec mip_base_gps_time_update_week_number_response_codec = {
    0x01,
    0x84,
    MIP_RESPONSE,
    4,
    sizeof(struct mip_base_gps_time_update_week_number_response),
    0,
    MIP_SHAPE(0, 1, 0),
    program_gps_time_update_week_number_response,
    NULL};

static const uint8_t program_gps_time_update_tow_response[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_base_gps_time_update_tow_response, tow)),
    MIP_END,
};

const struct mip_codec mip_base_gps_time_update_tow_response_codec = {
    0x01,
    0x85,
    MIP_RESPONSE,
    4,
    sizeof(struct mip_base_gps_time_update_tow_response),
    0,
    MIP_SHAPE(0, 1, 0),
    program_gps_time_update_tow_response,
    NULL};

static const uint8_t program_soft_reset[] = {
    MIP_END,
};

const struct mip_codec mip_base_soft_reset_codec = {
    0x01, 0x7E, MIP_COMMAND, 0, sizeof(struct mip_base_soft_reset), 0, 0, program_soft_reset, NULL};

const struct mip_exchange mip_base_soft_reset_exchange = {0x01, 0x7E, 0, 0, NULL};

const struct mip_command mip_base_soft_reset_command = {&mip_base_soft_reset_codec,
                                                        &mip_base_soft_reset_exchange, false};
