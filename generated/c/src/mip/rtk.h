/**
 * @file
 *
 * RTK commands (0x0F). Commands of a corrections modem (RTK dongle), such as the 3DM-RTK.
 * Uncertain: The SDK describes hardly any of this set; most descriptions are inferred from the
 * names. Uncertain: No source states how strings are padded or terminated.
 *
 * The devices that support a field are in mip/extra/profiles.h.
 */
#ifndef MIP_RTK_H
#define MIP_RTK_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 200
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

/**
 * Get status flags: command (0x0F,0x01).
 *
 * Gets the state of the modem and of the corrections.
 *
 * No device is known for certain to support it. Response: mip_rtk_get_status_flags_response. Known
 * only from the MicroStrain MIP SDK.
 *
 * The status word in the response has two forms: mip_rtk_status_flags if its `version` is not 0,
 * and mip_rtk_status_flags_legacy if it is.
 *
 * - mip-sdk-4: Get status flags (0x0F,0x01)
 */
struct mip_rtk_get_status_flags {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_RTK_GET_STATUS_FLAGS 0x0F01
#define MIP_RTK_GET_STATUS_FLAGS_DESCRIPTOR 0x01
MIP_FIELD(mip_rtk_get_status_flags, 0x01);

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

#define MIP_RTK_GET_STATUS_FLAGS_RESPONSE 0x0F81
#define MIP_RTK_GET_STATUS_FLAGS_RESPONSE_DESCRIPTOR 0x81
MIP_FIELD(mip_rtk_get_status_flags_response, 0x81);

/**
 * Get IMEI: command (0x0F,0x02).
 *
 * Gets the identity of the modem.
 *
 * Response: mip_rtk_get_imei_response. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get IMEI (0x0F,0x02)
 */
struct mip_rtk_get_imei {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_RTK_GET_IMEI 0x0F02
#define MIP_RTK_GET_IMEI_DESCRIPTOR 0x02
MIP_FIELD(mip_rtk_get_imei, 0x02);

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

#define MIP_RTK_GET_IMEI_RESPONSE 0x0F82
#define MIP_RTK_GET_IMEI_RESPONSE_DESCRIPTOR 0x82
MIP_FIELD(mip_rtk_get_imei_response, 0x82);

/**
 * Get IMSI: command (0x0F,0x03).
 *
 * Gets the identity of the subscriber.
 *
 * Response: mip_rtk_get_imsi_response. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get IMSI (0x0F,0x03)
 */
struct mip_rtk_get_imsi {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_RTK_GET_IMSI 0x0F03
#define MIP_RTK_GET_IMSI_DESCRIPTOR 0x03
MIP_FIELD(mip_rtk_get_imsi, 0x03);

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

#define MIP_RTK_GET_IMSI_RESPONSE 0x0F83
#define MIP_RTK_GET_IMSI_RESPONSE_DESCRIPTOR 0x83
MIP_FIELD(mip_rtk_get_imsi_response, 0x83);

/**
 * Get ICCID: command (0x0F,0x04).
 *
 * Gets the number of the SIM card.
 *
 * Response: mip_rtk_get_iccid_response. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get ICCID (0x0F,0x04)
 */
struct mip_rtk_get_iccid {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_RTK_GET_ICCID 0x0F04
#define MIP_RTK_GET_ICCID_DESCRIPTOR 0x04
MIP_FIELD(mip_rtk_get_iccid, 0x04);

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

#define MIP_RTK_GET_ICCID_RESPONSE 0x0F84
#define MIP_RTK_GET_ICCID_RESPONSE_DESCRIPTOR 0x84
MIP_FIELD(mip_rtk_get_iccid_response, 0x84);

/**
 * Get RSSI: command (0x0F,0x05).
 *
 * Gets the strength of the cellular signal.
 *
 * Response: mip_rtk_get_rssi_response. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get RSSI (0x0F,0x05)
 */
struct mip_rtk_get_rssi {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_RTK_GET_RSSI 0x0F05
#define MIP_RTK_GET_RSSI_DESCRIPTOR 0x05
MIP_FIELD(mip_rtk_get_rssi, 0x05);

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
    /**
     * Received signal strength. Valid if valid is true. Uncertain: No source states the unit; dBm
     * is likely.
     */
    int32_t rssi;
    /**
     * Quality of the modem's radio signal. Valid if valid is true. Uncertain: No source states the
     * unit.
     */
    int32_t signal_quality;
};

#define MIP_RTK_GET_RSSI_RESPONSE 0x0F85
#define MIP_RTK_GET_RSSI_RESPONSE_DESCRIPTOR 0x85
MIP_FIELD(mip_rtk_get_rssi_response, 0x85);

/**
 * Connected device type: command (0x0F,0x06).
 *
 * Sets the type of device that the modem is connected to.
 *
 * Functions: write, read, save, load and default. Response: mip_rtk_connected_device_type_response.
 * Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Connected device type (0x0F,0x06)
 */
struct mip_rtk_connected_device_type {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Type of device that the modem is connected to. A value of enum mip_rtk_connected_device.
     * Required for write.
     */
    uint8_t device_type;
};

#define MIP_RTK_CONNECTED_DEVICE_TYPE 0x0F06
#define MIP_RTK_CONNECTED_DEVICE_TYPE_DESCRIPTOR 0x06
MIP_FIELD(mip_rtk_connected_device_type, 0x06);
MIP_FILL(mip_rtk_connected_device_type, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_rtk_connected_device_type, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_rtk_connected_device_type, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_rtk_connected_device_type, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_rtk_connected_device_type *mip_rtk_connected_device_type_write(
    struct mip_rtk_connected_device_type *command, enum mip_rtk_connected_device device_type) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->device_type = (uint8_t)device_type;
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

#define MIP_RTK_CONNECTED_DEVICE_TYPE_RESPONSE 0x0F86
#define MIP_RTK_CONNECTED_DEVICE_TYPE_RESPONSE_DESCRIPTOR 0x86
MIP_FIELD(mip_rtk_connected_device_type_response, 0x86);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_rtk_connected_device_type *mip_rtk_connected_device_type_write_from(
    struct mip_rtk_connected_device_type *command,
    const struct mip_rtk_connected_device_type_response *response) {
    return mip_rtk_connected_device_type_write(
        command, (enum mip_rtk_connected_device)response->device_type);
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

#define MIP_RTK_GET_ACTIVATION_CODE 0x0F07
#define MIP_RTK_GET_ACTIVATION_CODE_DESCRIPTOR 0x07
MIP_FIELD(mip_rtk_get_activation_code, 0x07);

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

#define MIP_RTK_GET_ACTIVATION_CODE_RESPONSE 0x0F87
#define MIP_RTK_GET_ACTIVATION_CODE_RESPONSE_DESCRIPTOR 0x87
MIP_FIELD(mip_rtk_get_activation_code_response, 0x87);

/**
 * Get modem firmware version: command (0x0F,0x08).
 *
 * Gets the firmware version of the cellular modem.
 *
 * Response: mip_rtk_get_modem_firmware_version_response. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get modem firmware version (0x0F,0x08)
 */
struct mip_rtk_get_modem_firmware_version {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_RTK_GET_MODEM_FIRMWARE_VERSION 0x0F08
#define MIP_RTK_GET_MODEM_FIRMWARE_VERSION_DESCRIPTOR 0x08
MIP_FIELD(mip_rtk_get_modem_firmware_version, 0x08);

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

#define MIP_RTK_GET_MODEM_FIRMWARE_VERSION_RESPONSE 0x0F88
#define MIP_RTK_GET_MODEM_FIRMWARE_VERSION_RESPONSE_DESCRIPTOR 0x88
MIP_FIELD(mip_rtk_get_modem_firmware_version_response, 0x88);

/**
 * Service status: command (0x0F,0x0A).
 *
 * Queries a correction server about the connection, which also keeps it open.
 *
 * Response: mip_rtk_service_status_response. Sent by the device; the host replies. Known only from
 * the MicroStrain MIP SDK.
 *
 * The modem acts as the host and the server as the device.
 *
 * - mip-sdk-4: Service status (0x0F,0x0A)
 */
struct mip_rtk_service_status {
    /** Reserved: send 0. Uncertain: No source states what the modem sends; 0 is assumed. */
    uint32_t reserved1;
    /** Reserved: send 0. Uncertain: No source states what the modem sends; 0 is assumed. */
    uint32_t reserved2;
};

#define MIP_RTK_SERVICE_STATUS 0x0F0A
#define MIP_RTK_SERVICE_STATUS_DESCRIPTOR 0x0A
MIP_FIELD(mip_rtk_service_status, 0x0A);

/**
 * Service status response: response (0x0F,0x8A).
 *
 * Connection status according to the server.
 *
 * Response to mip_rtk_service_status. Known only from the MicroStrain MIP SDK. Uncertain: No source
 * states what the counters count.
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
    /** Time of the last transfer. Uncertain: No source states the unit and the epoch. */
    uint64_t last_bytes_time;
};

#define MIP_RTK_SERVICE_STATUS_RESPONSE 0x0F8A
#define MIP_RTK_SERVICE_STATUS_RESPONSE_DESCRIPTOR 0x8A
MIP_FIELD(mip_rtk_service_status_response, 0x8A);

/**
 * Erase storage: command (0x0F,0x20).
 *
 * Returns a storage medium to its raw state. Everything on it is erased.
 *
 * For advanced use. Also called `prod_erase_storage`. Known only from the MicroStrain MIP SDK.
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

#define MIP_RTK_ERASE_STORAGE 0x0F20
#define MIP_RTK_ERASE_STORAGE_DESCRIPTOR 0x20
MIP_FIELD(mip_rtk_erase_storage, 0x20);

/** Fills the structure, and returns it. */
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
 * For advanced use. Known only from the MicroStrain MIP SDK.
 *
 * Accepted in calibration mode and production test mode only.
 *
 * - mip-sdk-4: LED control (0x0F,0x21)
 */
struct mip_rtk_led_control {
    /**
     * First colour. Uncertain: No source states the order of its parts; red, green, blue is likely.
     */
    uint8_t primary_color[3];
    /**
     * Second colour. Uncertain: No source states the order of its parts; red, green, blue is
     * likely.
     */
    uint8_t alternate_color[3];
    /** Pattern. A value of enum mip_rtk_led_action. */
    uint8_t action;
    /** Period of the pattern. Uncertain: No source states the unit; ms is likely. */
    uint32_t period;
};

#define MIP_RTK_LED_CONTROL 0x0F21
#define MIP_RTK_LED_CONTROL_DESCRIPTOR 0x21
MIP_FIELD(mip_rtk_led_control, 0x21);

/** Fills the structure, and returns it. */
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
 * For advanced use. Known only from the MicroStrain MIP SDK.
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

#define MIP_RTK_MODEM_HARD_RESET 0x0F22
#define MIP_RTK_MODEM_HARD_RESET_DESCRIPTOR 0x22
MIP_FIELD(mip_rtk_modem_hard_reset, 0x22);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
