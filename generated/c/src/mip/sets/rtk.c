/* RTK commands. */
#include "mip/rtk.h"
#include "mip/rtk_commands.h"
#include "mip/core/program.h"

static const uint8_t program_get_status_flags[] = {
    MIP_END,
};

MIP_CODEC(mip_rtk_get_status_flags, 0x0F, 0x01, MIP_COMMAND, 0, 0, 0, program_get_status_flags,
          NULL);

static const struct mip_response responses_get_status_flags[] = {
    {NULL, 0x81, 0, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_rtk_get_status_flags, 0x0F, 0x01, 0, 1, responses_get_status_flags, false);

static const uint8_t program_get_status_flags_response[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_rtk_get_status_flags_response, flags)),
    MIP_END,
};

MIP_CODEC(mip_rtk_get_status_flags_response, 0x0F, 0x81, MIP_RESPONSE, 4, 0, MIP_SHAPE(0, 1, 0),
          program_get_status_flags_response, NULL);

static const uint8_t program_get_imei[] = {
    MIP_END,
};

MIP_CODEC(mip_rtk_get_imei, 0x0F, 0x02, MIP_COMMAND, 0, 0, 0, program_get_imei, NULL);

static const struct mip_response responses_get_imei[] = {
    {NULL, 0x82, 0, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_rtk_get_imei, 0x0F, 0x02, 0, 1, responses_get_imei, false);

static const uint8_t program_get_imei_response[] = {
    MIP_8_BITS(0, MIP_MANY(32, MIP_AT(struct mip_rtk_get_imei_response, imei))),
    MIP_END,
};

MIP_CODEC(mip_rtk_get_imei_response, 0x0F, 0x82, MIP_RESPONSE, 0, 0, 0, program_get_imei_response,
          &mip_program);

static const uint8_t program_get_imsi[] = {
    MIP_END,
};

MIP_CODEC(mip_rtk_get_imsi, 0x0F, 0x03, MIP_COMMAND, 0, 0, 0, program_get_imsi, NULL);

static const struct mip_response responses_get_imsi[] = {
    {NULL, 0x83, 0, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_rtk_get_imsi, 0x0F, 0x03, 0, 1, responses_get_imsi, false);

static const uint8_t program_get_imsi_response[] = {
    MIP_8_BITS(0, MIP_MANY(32, MIP_AT(struct mip_rtk_get_imsi_response, imsi))),
    MIP_END,
};

MIP_CODEC(mip_rtk_get_imsi_response, 0x0F, 0x83, MIP_RESPONSE, 0, 0, 0, program_get_imsi_response,
          &mip_program);

static const uint8_t program_get_iccid[] = {
    MIP_END,
};

MIP_CODEC(mip_rtk_get_iccid, 0x0F, 0x04, MIP_COMMAND, 0, 0, 0, program_get_iccid, NULL);

static const struct mip_response responses_get_iccid[] = {
    {NULL, 0x84, 0, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_rtk_get_iccid, 0x0F, 0x04, 0, 1, responses_get_iccid, false);

static const uint8_t program_get_iccid_response[] = {
    MIP_8_BITS(0, MIP_MANY(32, MIP_AT(struct mip_rtk_get_iccid_response, iccid))),
    MIP_END,
};

MIP_CODEC(mip_rtk_get_iccid_response, 0x0F, 0x84, MIP_RESPONSE, 0, 0, 0, program_get_iccid_response,
          &mip_program);

static const uint8_t program_get_rssi[] = {
    MIP_END,
};

MIP_CODEC(mip_rtk_get_rssi, 0x0F, 0x05, MIP_COMMAND, 0, 0, 0, program_get_rssi, NULL);

static const struct mip_response responses_get_rssi[] = {
    {NULL, 0x85, 0, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_rtk_get_rssi, 0x0F, 0x05, 0, 1, responses_get_rssi, false);

static const uint8_t program_get_rssi_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_rtk_get_rssi_response, valid)),
    MIP_32_BITS(2, MIP_AT(struct mip_rtk_get_rssi_response, rssi)),
    MIP_END,
};

MIP_CODEC(mip_rtk_get_rssi_response, 0x0F, 0x85, MIP_RESPONSE, 9, 0, 0, program_get_rssi_response,
          NULL);

static const uint8_t program_connected_device_type[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_rtk_connected_device_type, device_type)),
    MIP_END,
};

MIP_CODEC(mip_rtk_connected_device_type, 0x0F, 0x06, MIP_COMMAND, 0, 0, 0,
          program_connected_device_type, &mip_program);

static const struct mip_response responses_connected_device_type[] = {
    {NULL, 0x86, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_rtk_connected_device_type, 0x0F, 0x06, 0, 1, responses_connected_device_type,
             true);

static const uint8_t program_connected_device_type_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_rtk_connected_device_type_response, device_type)),
    MIP_END,
};

MIP_CODEC(mip_rtk_connected_device_type_response, 0x0F, 0x86, MIP_RESPONSE, 1, 0, 0,
          program_connected_device_type_response, NULL);

static const uint8_t program_get_activation_code[] = {
    MIP_END,
};

MIP_CODEC(mip_rtk_get_activation_code, 0x0F, 0x07, MIP_COMMAND, 0, 0, 0,
          program_get_activation_code, NULL);

static const struct mip_response responses_get_activation_code[] = {
    {NULL, 0x87, 0, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_rtk_get_activation_code, 0x0F, 0x07, 0, 1, responses_get_activation_code, false);

static const uint8_t program_get_activation_code_response[] = {
    MIP_8_BITS(0,
               MIP_MANY(32, MIP_AT(struct mip_rtk_get_activation_code_response, activation_code))),
    MIP_END,
};

MIP_CODEC(mip_rtk_get_activation_code_response, 0x0F, 0x87, MIP_RESPONSE, 0, 0, 0,
          program_get_activation_code_response, &mip_program);

static const uint8_t program_get_modem_firmware_version[] = {
    MIP_END,
};

MIP_CODEC(mip_rtk_get_modem_firmware_version, 0x0F, 0x08, MIP_COMMAND, 0, 0, 0,
          program_get_modem_firmware_version, NULL);

static const struct mip_response responses_get_modem_firmware_version[] = {
    {NULL, 0x88, 0, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_rtk_get_modem_firmware_version, 0x0F, 0x08, 0, 1,
             responses_get_modem_firmware_version, false);

static const uint8_t program_get_modem_firmware_version_response[] = {
    MIP_8_BITS(0, MIP_MANY(32, MIP_AT(struct mip_rtk_get_modem_firmware_version_response,
                                      modem_firmware_version))),
    MIP_END,
};

MIP_CODEC(mip_rtk_get_modem_firmware_version_response, 0x0F, 0x88, MIP_RESPONSE, 0, 0, 0,
          program_get_modem_firmware_version_response, &mip_program);

static const uint8_t program_service_status[] = {
    MIP_32_BITS(2, MIP_AT(struct mip_rtk_service_status, reserved1)),
    MIP_END,
};

MIP_CODEC(mip_rtk_service_status, 0x0F, 0x0A, MIP_COMMAND, 8, 0, MIP_SHAPE(0, 2, 0),
          program_service_status, NULL);

static const struct mip_response responses_service_status[] = {
    {NULL, 0x8A, 0, MIP_NOT_ZERO, false},
};

MIP_EXCHANGE(mip_rtk_service_status, 0x0F, 0x0A, 0, 1, responses_service_status, false);

static const uint8_t program_service_status_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_rtk_service_status_response, flags)),
    MIP_32_BITS(2, MIP_AT(struct mip_rtk_service_status_response, received_bytes)),
    MIP_64_BITS(1, MIP_AT(struct mip_rtk_service_status_response, last_bytes_time)),
    MIP_END,
};

MIP_CODEC(mip_rtk_service_status_response, 0x0F, 0x8A, MIP_RESPONSE, 17, 0, 0,
          program_service_status_response, NULL);

static const uint8_t program_erase_storage[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_rtk_erase_storage, media)),
    MIP_END,
};

MIP_CODEC(mip_rtk_erase_storage, 0x0F, 0x20, MIP_COMMAND, 1, 0, 0, program_erase_storage, NULL);

MIP_EXCHANGE(mip_rtk_erase_storage, 0x0F, 0x20, 0, 0, NULL, false);

static const uint8_t program_led_control[] = {
    MIP_8_BITS(7, MIP_AT(struct mip_rtk_led_control, primary_color)),
    MIP_32_BITS(1, MIP_AT(struct mip_rtk_led_control, period)),
    MIP_END,
};

MIP_CODEC(mip_rtk_led_control, 0x0F, 0x21, MIP_COMMAND, 11, 0, 0, program_led_control, NULL);

MIP_EXCHANGE(mip_rtk_led_control, 0x0F, 0x21, 0, 0, NULL, false);

static const uint8_t program_modem_hard_reset[] = {
    MIP_END,
};

MIP_CODEC(mip_rtk_modem_hard_reset, 0x0F, 0x22, MIP_COMMAND, 0, 0, 0, program_modem_hard_reset,
          NULL);

MIP_EXCHANGE(mip_rtk_modem_hard_reset, 0x0F, 0x22, 0, 0, NULL, false);
