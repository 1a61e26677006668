/* RTK commands. */
#include "mip/rtk.h"
#include "mip/rtk_commands.h"
#include "mip/core/program.h"

static const uint8_t program_get_status_flags[] = {
    MIP_END,
};

const struct mip_codec mip_rtk_get_status_flags_codec = {0x0F,
                                                         0x01,
                                                         MIP_COMMAND,
                                                         0,
                                                         sizeof(struct mip_rtk_get_status_flags),
                                                         0,
                                                         0,
                                                         program_get_status_flags,
                                                         NULL};

static const struct mip_response responses_get_status_flags[] = {
    {NULL, 0x81, 0, MIP_NOT_ZERO, false},
};

const struct mip_exchange mip_rtk_get_status_flags_exchange = {
    0x0F, 0x01, 0, sizeof(responses_get_status_flags) / sizeof(responses_get_status_flags[0]),
    responses_get_status_flags};

const struct mip_command mip_rtk_get_status_flags_command = {
    &mip_rtk_get_status_flags_codec, &mip_rtk_get_status_flags_exchange, false};

static const uint8_t program_get_status_flags_response[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_rtk_get_status_flags_response, flags)),
    MIP_END,
};

const struct mip_codec mip_rtk_get_status_flags_response_codec = {
    0x0F,
    0x81,
    MIP_RESPONSE,
    4,
    sizeof(struct mip_rtk_get_status_flags_response),
    0,
    MIP_SHAPE(0, 1, 0),
    program_get_status_flags_response,
    NULL};

static const uint8_t program_get_imei[] = {
    MIP_END,
};

const struct mip_codec mip_rtk_get_imei_codec = {
    0x0F, 0x02, MIP_COMMAND, 0, sizeof(struct mip_rtk_get_imei), 0, 0, program_get_imei, NULL};

static const struct mip_response responses_get_imei[] = {
    {NULL, 0x82, 0, MIP_NOT_ZERO, false},
};

const struct mip_exchange mip_rtk_get_imei_exchange = {
    0x0F, 0x02, 0, sizeof(responses_get_imei) / sizeof(responses_get_imei[0]), responses_get_imei};

const struct mip_command mip_rtk_get_imei_command = {&mip_rtk_get_imei_codec,
                                                     &mip_rtk_get_imei_exchange, false};

static const uint8_t program_get_imei_response[] = {
    MIP_8_BITS(0, MIP_MANY(32, MIP_AT(struct mip_rtk_get_imei_response, imei))),
    MIP_END,
};

const struct mip_codec mip_rtk_get_imei_response_codec = {0x0F,
                                                          0x82,
                                                          MIP_RESPONSE,
                                                          0,
                                                          sizeof(struct mip_rtk_get_imei_response),
                                                          0,
                                                          0,
                                                          program_get_imei_response,
                                                          &mip_program};

static const uint8_t program_get_imsi[] = {
    MIP_END,
};

const struct mip_codec mip_rtk_get_imsi_codec = {
    0x0F, 0x03, MIP_COMMAND, 0, sizeof(struct mip_rtk_get_imsi), 0, 0, program_get_imsi, NULL};

static const struct mip_response responses_get_imsi[] = {
    {NULL, 0x83, 0, MIP_NOT_ZERO, false},
};

const struct mip_exchange mip_rtk_get_imsi_exchange = {
    0x0F, 0x03, 0, sizeof(responses_get_imsi) / sizeof(responses_get_imsi[0]), responses_get_imsi};

const struct mip_command mip_rtk_get_imsi_command = {&mip_rtk_get_imsi_codec,
                                                     &mip_rtk_get_imsi_exchange, false};

static const uint8_t program_get_imsi_response[] = {
    MIP_8_BITS(0, MIP_MANY(32, MIP_AT(struct mip_rtk_get_imsi_response, imsi))),
    MIP_END,
};

const struct mip_codec mip_rtk_get_imsi_response_codec = {0x0F,
                                                          0x83,
                                                          MIP_RESPONSE,
                                                          0,
                                                          sizeof(struct mip_rtk_get_imsi_response),
                                                          0,
                                                          0,
                                                          program_get_imsi_response,
                                                          &mip_program};

static const uint8_t program_get_iccid[] = {
    MIP_END,
};

const struct mip_codec mip_rtk_get_iccid_codec = {
    0x0F, 0x04, MIP_COMMAND, 0, sizeof(struct mip_rtk_get_iccid), 0, 0, program_get_iccid, NULL};

static const struct mip_response responses_get_iccid[] = {
    {NULL, 0x84, 0, MIP_NOT_ZERO, false},
};

const struct mip_exchange mip_rtk_get_iccid_exchange = {
    0x0F, 0x04, 0, sizeof(responses_get_iccid) / sizeof(responses_get_iccid[0]),
    responses_get_iccid};

const struct mip_command mip_rtk_get_iccid_command = {&mip_rtk_get_iccid_codec,
                                                      &mip_rtk_get_iccid_exchange, false};

static const uint8_t program_get_iccid_response[] = {
    MIP_8_BITS(0, MIP_MANY(32, MIP_AT(struct mip_rtk_get_iccid_response, iccid))),
    MIP_END,
};

const struct mip_codec mip_rtk_get_iccid_response_codec = {
    0x0F,
    0x84,
    MIP_RESPONSE,
    0,
    sizeof(struct mip_rtk_get_iccid_response),
    0,
    0,
    program_get_iccid_response,
    &mip_program};

static const uint8_t program_get_rssi[] = {
    MIP_END,
};

const struct mip_codec mip_rtk_get_rssi_codec = {
    0x0F, 0x05, MIP_COMMAND, 0, sizeof(struct mip_rtk_get_rssi), 0, 0, program_get_rssi, NULL};

static const struct mip_response responses_get_rssi[] = {
    {NULL, 0x85, 0, MIP_NOT_ZERO, false},
};

const struct mip_exchange mip_rtk_get_rssi_exchange = {
    0x0F, 0x05, 0, sizeof(responses_get_rssi) / sizeof(responses_get_rssi[0]), responses_get_rssi};

const struct mip_command mip_rtk_get_rssi_command = {&mip_rtk_get_rssi_codec,
                                                     &mip_rtk_get_rssi_exchange, false};

static const uint8_t program_get_rssi_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_rtk_get_rssi_response, valid)),
    MIP_32_BITS(2, MIP_AT(struct mip_rtk_get_rssi_response, rssi)),
    MIP_END,
};

const struct mip_codec mip_rtk_get_rssi_response_codec = {0x0F,
                                                          0x85,
                                                          MIP_RESPONSE,
                                                          9,
                                                          sizeof(struct mip_rtk_get_rssi_response),
                                                          0,
                                                          0,
                                                          program_get_rssi_response,
                                                          NULL};

static const uint8_t program_connected_device_type[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_rtk_connected_device_type, device_type)),
    MIP_END,
};

const struct mip_codec mip_rtk_connected_device_type_codec = {
    0x0F,
    0x06,
    MIP_COMMAND,
    0,
    sizeof(struct mip_rtk_connected_device_type),
    0,
    0,
    program_connected_device_type,
    &mip_program};

static const struct mip_response responses_connected_device_type[] = {
    {NULL, 0x86, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

const struct mip_exchange mip_rtk_connected_device_type_exchange = {
    0x0F, 0x06, 0,
    sizeof(responses_connected_device_type) / sizeof(responses_connected_device_type[0]),
    responses_connected_device_type};

const struct mip_command mip_rtk_connected_device_type_command = {
    &mip_rtk_connected_device_type_codec, &mip_rtk_connected_device_type_exchange, true};

static const uint8_t program_connected_device_type_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_rtk_connected_device_type_response, device_type)),
    MIP_END,
};

const struct mip_codec mip_rtk_connected_device_type_response_codec = {
    0x0F,
    0x86,
    MIP_RESPONSE,
    1,
    sizeof(struct mip_rtk_connected_device_type_response),
    0,
    0,
    program_connected_device_type_response,
    NULL};

static const uint8_t program_get_activation_code[] = {
    MIP_END,
};

const struct mip_codec mip_rtk_get_activation_code_codec = {
    0x0F,
    0x07,
    MIP_COMMAND,
    0,
    sizeof(struct mip_rtk_get_activation_code),
    0,
    0,
    program_get_activation_code,
    NULL};

static const struct mip_response responses_get_activation_code[] = {
    {NULL, 0x87, 0, MIP_NOT_ZERO, false},
};

const struct mip_exchange mip_rtk_get_activation_code_exchange = {
    0x0F, 0x07, 0, sizeof(responses_get_activation_code) / sizeof(responses_get_activation_code[0]),
    responses_get_activation_code};

const struct mip_command mip_rtk_get_activation_code_command = {
    &mip_rtk_get_activation_code_codec, &mip_rtk_get_activation_code_exchange, false};

static const uint8_t program_get_activation_code_response[] = {
    MIP_8_BITS(0,
               MIP_MANY(32, MIP_AT(struct mip_rtk_get_activation_code_response, activation_code))),
    MIP_END,
};

const struct mip_codec mip_rtk_get_activation_code_response_codec = {
    0x0F,
    0x87,
    MIP_RESPONSE,
    0,
    sizeof(struct mip_rtk_get_activation_code_response),
    0,
    0,
    program_get_activation_code_response,
    &mip_program};

static const uint8_t program_get_modem_firmware_version[] = {
    MIP_END,
};

const struct mip_codec mip_rtk_get_modem_firmware_version_codec = {
    0x0F,
    0x08,
    MIP_COMMAND,
    0,
    sizeof(struct mip_rtk_get_modem_firmware_version),
    0,
    0,
    program_get_modem_firmware_version,
    NULL};

static const struct mip_response responses_get_modem_firmware_version[] = {
    {NULL, 0x88, 0, MIP_NOT_ZERO, false},
};

const struct mip_exchange mip_rtk_get_modem_firmware_version_exchange = {
    0x0F, 0x08, 0,
    sizeof(responses_get_modem_firmware_version) / sizeof(responses_get_modem_firmware_version[0]),
    responses_get_modem_firmware_version};

const struct mip_command mip_rtk_get_modem_firmware_version_command = {
    &mip_rtk_get_modem_firmware_version_codec, &mip_rtk_get_modem_firmware_version_exchange, false};

static const uint8_t program_get_modem_firmware_version_response[] = {
    MIP_8_BITS(0, MIP_MANY(32, MIP_AT(struct mip_rtk_get_modem_firmware_version_response,
                                      modem_firmware_version))),
    MIP_END,
};

const struct mip_codec mip_rtk_get_modem_firmware_version_response_codec = {
    0x0F,
    0x88,
    MIP_RESPONSE,
    0,
    sizeof(struct mip_rtk_get_modem_firmware_version_response),
    0,
    0,
    program_get_modem_firmware_version_response,
    &mip_program};

static const uint8_t program_service_status[] = {
    MIP_32_BITS(2, MIP_AT(struct mip_rtk_service_status, reserved1)),
    MIP_END,
};

const struct mip_codec mip_rtk_service_status_codec = {0x0F,
                                                       0x0A,
                                                       MIP_COMMAND,
                                                       8,
                                                       sizeof(struct mip_rtk_service_status),
                                                       0,
                                                       MIP_SHAPE(0, 2, 0),
                                                       program_service_status,
                                                       NULL};

static const struct mip_response responses_service_status[] = {
    {NULL, 0x8A, 0, MIP_NOT_ZERO, false},
};

const struct mip_exchange mip_rtk_service_status_exchange = {
    0x0F, 0x0A, 0, sizeof(responses_service_status) / sizeof(responses_service_status[0]),
    responses_service_status};

const struct mip_command mip_rtk_service_status_command = {&mip_rtk_service_status_codec,
                                                           &mip_rtk_service_status_exchange, false};

static const uint8_t program_service_status_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_rtk_service_status_response, flags)),
    MIP_32_BITS(2, MIP_AT(struct mip_rtk_service_status_response, received_bytes)),
    MIP_64_BITS(1, MIP_AT(struct mip_rtk_service_status_response, last_bytes_time)),
    MIP_END,
};

const struct mip_codec mip_rtk_service_status_response_codec = {
    0x0F,
    0x8A,
    MIP_RESPONSE,
    17,
    sizeof(struct mip_rtk_service_status_response),
    0,
    0,
    program_service_status_response,
    NULL};

static const uint8_t program_erase_storage[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_rtk_erase_storage, media)),
    MIP_END,
};

const struct mip_codec mip_rtk_erase_storage_codec = {
    0x0F, 0x20, MIP_COMMAND,           1,   sizeof(struct mip_rtk_erase_storage),
    0,    0,    program_erase_storage, NULL};

const struct mip_exchange mip_rtk_erase_storage_exchange = {0x0F, 0x20, 0, 0, NULL};

const struct mip_command mip_rtk_erase_storage_command = {&mip_rtk_erase_storage_codec,
                                                          &mip_rtk_erase_storage_exchange, false};

static const uint8_t program_led_control[] = {
    MIP_8_BITS(7, MIP_AT(struct mip_rtk_led_control, primary_color)),
    MIP_32_BITS(1, MIP_AT(struct mip_rtk_led_control, period)),
    MIP_END,
};

const struct mip_codec mip_rtk_led_control_codec = {
    0x0F, 0x21, MIP_COMMAND,         11,  sizeof(struct mip_rtk_led_control),
    0,    0,    program_led_control, NULL};

const struct mip_exchange mip_rtk_led_control_exchange = {0x0F, 0x21, 0, 0, NULL};

const struct mip_command mip_rtk_led_control_command = {&mip_rtk_led_control_codec,
                                                        &mip_rtk_led_control_exchange, false};

static const uint8_t program_modem_hard_reset[] = {
    MIP_END,
};

const struct mip_codec mip_rtk_modem_hard_reset_codec = {0x0F,
                                                         0x22,
                                                         MIP_COMMAND,
                                                         0,
                                                         sizeof(struct mip_rtk_modem_hard_reset),
                                                         0,
                                                         0,
                                                         program_modem_hard_reset,
                                                         NULL};

const struct mip_exchange mip_rtk_modem_hard_reset_exchange = {0x0F, 0x22, 0, 0, NULL};

const struct mip_command mip_rtk_modem_hard_reset_command = {
    &mip_rtk_modem_hard_reset_codec, &mip_rtk_modem_hard_reset_exchange, false};
