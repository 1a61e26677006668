/**
 * @file
 *
 * Base (0x01). Commands common to all devices: identity, supported descriptors, idle and resume,
 * self test, reset.
 *
 * The devices that support a field are in mip/extra/profiles.h.
 */
#ifndef MIP_BASE_H
#define MIP_BASE_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/base.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_base Base (0x01)
 * @{ */

/** Descriptor set of these fields. */
#define MIP_BASE_SET 0x01

/**
 * Identity of a device. The strings are padded with spaces.
 *
 * - 3dm-gx5-15: 4.1.3 Get Device Information (0x01, 0x03)
 * - 3dm-cv7-gnss-ins: Get device information (0x01,0x03)
 */
struct mip_base_device_info {
    /** Firmware version as one decimal number: 1202 means 1.2.02. */
    uint16_t firmware_version;
    /** Product name, such as 3DM-GQ7. */
    char model_name[17];
    /** Part number of the model. */
    char model_number[17];
    /** Serial number, which begins with the model number. */
    char serial_number[17];
    /** Lot number; reserved and blank on some devices. */
    char lot_number[17];
    /** Options of the unit, such as its sensor ranges. */
    char device_options[17];
};

/** The part of the GPS time that a value contains. */
enum mip_base_gps_time_field MIP_ENUM_8 {
    /** The value `week_number`. */
    MIP_BASE_GPS_TIME_FIELD_WEEK_NUMBER = 1,
    /** Time of week in whole seconds. */
    MIP_BASE_GPS_TIME_FIELD_TOW = 2
};

/**
 * Ping: command (0x01,0x01).
 *
 * Checks whether a device is present and replies to commands.
 *
 * A device that is not in a normal operating mode may reject the command.
 *
 * - 3dm-gx5-15: 4.1.1 Ping (0x01, 0x01)
 * - 3dm-cv7-gnss-ins: Ping (0x01,0x01)
 */
struct mip_base_ping {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_BASE_PING 0x0101
#define MIP_BASE_PING_DESCRIPTOR 0x01
MIP_FIELD(mip_base_ping, 0x01);

/**
 * Set to idle: command (0x01,0x02).
 *
 * Stops all data streams, and wakes a sleeping device, so that it can be configured.
 *
 * mip_base_resume restores the previous mode.
 *
 * While idle, the device does not send NMEA sentences either.
 *
 * - 3dm-gx5-15: 4.1.2 Set To Idle (0x01, 0x02)
 * - 3dm-cv7-gnss-ins: Set to idle (0x01,0x02)
 */
struct mip_base_set_idle {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_BASE_SET_IDLE 0x0102
#define MIP_BASE_SET_IDLE_DESCRIPTOR 0x02
MIP_FIELD(mip_base_set_idle, 0x02);

/**
 * Get device information: command (0x01,0x03).
 *
 * Gets the firmware version and the identity strings of the device.
 *
 * Response: mip_base_get_device_info_response.
 *
 * - 3dm-gx5-15: 4.1.3 Get Device Information (0x01, 0x03)
 * - 3dm-cv7-gnss-ins: Get device information (0x01,0x03)
 */
struct mip_base_get_device_info {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_BASE_GET_DEVICE_INFO 0x0103
#define MIP_BASE_GET_DEVICE_INFO_DESCRIPTOR 0x03
MIP_FIELD(mip_base_get_device_info, 0x03);

/**
 * Get device information response: response (0x01,0x81).
 *
 * Response to mip_base_get_device_info.
 *
 * - 3dm-gx5-15: 4.1.3 Get Device Information (0x01, 0x03)
 * - 3dm-cv7-gnss-ins: Get device information (0x01,0x03)
 */
struct mip_base_get_device_info_response {
    /** Identity of the device. */
    struct mip_base_device_info device_info;
};

#define MIP_BASE_GET_DEVICE_INFO_RESPONSE 0x0181
#define MIP_BASE_GET_DEVICE_INFO_RESPONSE_DESCRIPTOR 0x81
MIP_FIELD(mip_base_get_device_info_response, 0x81);

/**
 * Get device descriptors: command (0x01,0x04).
 *
 * Gets the command and data descriptors that the device supports.
 *
 * Response: mip_base_get_device_descriptors_response.
 *
 * If the list contains the descriptor of mip_base_get_extended_descriptors, that command returns
 * further descriptors.
 *
 * - 3dm-gx5-15: 4.1.4 Get Device Descriptor Sets (0x01, 0x04)
 * - 3dm-cv7-gnss-ins: Get device descriptors (0x01,0x04)
 */
struct mip_base_get_device_descriptors {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_BASE_GET_DEVICE_DESCRIPTORS 0x0104
#define MIP_BASE_GET_DEVICE_DESCRIPTORS_DESCRIPTOR 0x04
MIP_FIELD(mip_base_get_device_descriptors, 0x04);

/**
 * Get device descriptors response: response (0x01,0x82).
 *
 * Response to mip_base_get_device_descriptors.
 *
 * - 3dm-gx5-15: 4.1.4 Get Device Descriptor Sets (0x01, 0x04)
 * - 3dm-cv7-gnss-ins: Get device descriptors (0x01,0x04)
 */
struct mip_base_get_device_descriptors_response {
    /** The number of elements of descriptors. */
    uint8_t descriptors_count;
    /**
     * Supported descriptors: the descriptor set in the high byte, the field descriptor in the low
     * byte.
     */
    uint16_t descriptors[126];
};

#define MIP_BASE_GET_DEVICE_DESCRIPTORS_RESPONSE 0x0182
#define MIP_BASE_GET_DEVICE_DESCRIPTORS_RESPONSE_DESCRIPTOR 0x82
MIP_FIELD(mip_base_get_device_descriptors_response, 0x82);

/**
 * Built-in test: command (0x01,0x05).
 *
 * Runs the self test of the device and gets its result.
 *
 * Response: mip_base_built_in_test_response. The device may take 10 s to reply. Uncertain: The
 * maximum duration of 10 s is assumed; the manual of the 3DM-CV7 states several seconds.
 *
 * The test interrupts normal operation for up to several seconds; no data is available meanwhile.
 *
 * The device must be at rest; acceleration, rotation or vibration cause false failures.
 *
 * The continuous built-in test, if the device has it, describes a failure in more detail.
 *
 * - 3dm-gx5-15: 4.1.5 Device Built-In Test (0x01, 0x05)
 * - 3dm-cv7-gnss-ins: Built in test (0x01,0x05)
 * - 3dm-cv7-gnss-ins: Commanded Built-in Test
 */
struct mip_base_built_in_test {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_BASE_BUILT_IN_TEST 0x0105
#define MIP_BASE_BUILT_IN_TEST_DESCRIPTOR 0x05
MIP_FIELD(mip_base_built_in_test, 0x05);

/**
 * Built-in test response: response (0x01,0x83).
 *
 * Response to mip_base_built_in_test.
 *
 * - 3dm-gx5-15: 4.1.5 Device Built-In Test (0x01, 0x05)
 * - 3dm-cv7-gnss-ins: Built in test (0x01,0x05)
 * - 3dm-cv7-gnss-ins: Commanded Built-in Test
 */
struct mip_base_built_in_test_response {
    /**
     * Failure flags, defined by each device. Zero means that every test passed. On the 3DM-CV5-10,
     * 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25 and 3DM-GX5-25: values of
     * mip_gx5_built_in_test (inferred: the 3DM-GX5-15 has it). On the 3DM-CV7-AHRS, 3DM-CV7-AR,
     * 3DM-CV7-INS, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-CX7-INS, 3DM-GQ7-GNSS/INS, 3DM-GV7-AHRS,
     * 3DM-GV7-AR, 3DM-GV7-INS and 3DM-RTK: values of mip_cv7_built_in_test (inferred: the
     * 3DM-CV7-GNSS/INS has it). On the 3DM-CV7-GNSS/INS: values of mip_cv7_built_in_test. On the
     * 3DM-CX5-45, 3DM-GQ4-45, 3DM-GX3-15, 3DM-GX3-25, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15,
     * 3DM-GX4-25, 3DM-GX4-45, 3DM-GX4-IMU, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and
     * 3DM-RQ1-IMU: the values are unknown. On the 3DM-GX5-15: values of mip_gx5_built_in_test.
     */
    uint32_t result;
};

#define MIP_BASE_BUILT_IN_TEST_RESPONSE 0x0183
#define MIP_BASE_BUILT_IN_TEST_RESPONSE_DESCRIPTOR 0x83
MIP_FIELD(mip_base_built_in_test_response, 0x83);

/**
 * Resume: command (0x01,0x06).
 *
 * Ends idle mode and returns the device to the mode that it was in before.
 *
 * If the device was not idle, it enters its default mode (3DM-GX5-15).
 *
 * - 3dm-gx5-15: 4.1.6 Resume (0x01, 0x06)
 * - 3dm-cv7-gnss-ins: Resume (0x01,0x06)
 */
struct mip_base_resume {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_BASE_RESUME 0x0106
#define MIP_BASE_RESUME_DESCRIPTOR 0x06
MIP_FIELD(mip_base_resume, 0x06);

/**
 * Get device descriptors (extended): command (0x01,0x07).
 *
 * Gets the supported descriptors that did not fit into the reply of
 * mip_base_get_device_descriptors.
 *
 * Response: mip_base_get_extended_descriptors_response.
 *
 * Some devices lack this command; mip_base_get_device_descriptors lists it if the device has it.
 *
 * - 3dm-gx5-15: 4.1.7 Get Extended Device Descriptor Sets (0x01, 0x07)
 * - 3dm-cv7-gnss-ins: Get device descriptors (extended) (0x01,0x07)
 */
struct mip_base_get_extended_descriptors {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_BASE_GET_EXTENDED_DESCRIPTORS 0x0107
#define MIP_BASE_GET_EXTENDED_DESCRIPTORS_DESCRIPTOR 0x07
MIP_FIELD(mip_base_get_extended_descriptors, 0x07);

/**
 * Get device descriptors (extended) response: response (0x01,0x86).
 *
 * Response to mip_base_get_extended_descriptors.
 *
 * - 3dm-gx5-15: 4.1.7 Get Extended Device Descriptor Sets (0x01, 0x07)
 * - 3dm-cv7-gnss-ins: Get device descriptors (extended) (0x01,0x07)
 */
struct mip_base_get_extended_descriptors_response {
    /** The number of elements of descriptors. */
    uint8_t descriptors_count;
    /**
     * Supported descriptors: the descriptor set in the high byte, the field descriptor in the low
     * byte.
     */
    uint16_t descriptors[126];
};

#define MIP_BASE_GET_EXTENDED_DESCRIPTORS_RESPONSE 0x0186
#define MIP_BASE_GET_EXTENDED_DESCRIPTORS_RESPONSE_DESCRIPTOR 0x86
MIP_FIELD(mip_base_get_extended_descriptors_response, 0x86);

/**
 * Continuous built-in test: command (0x01,0x08).
 *
 * Gets the flags of the tests that run all the time. It does not interrupt operation.
 *
 * Also called `continuous_bit`. Response: mip_base_continuous_built_in_test_response.
 *
 * It is less thorough than mip_base_built_in_test.
 *
 * Each flag stays set until this command reports it; the streamed field has its own copy of the
 * flags.
 *
 * The self-test flags change only when mip_base_built_in_test runs.
 *
 * - 3dm-cv7-gnss-ins: Continuous built-in test (0x01,0x08)
 */
struct mip_base_continuous_built_in_test {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_BASE_CONTINUOUS_BUILT_IN_TEST 0x0108
#define MIP_BASE_CONTINUOUS_BUILT_IN_TEST_DESCRIPTOR 0x08
MIP_FIELD(mip_base_continuous_built_in_test, 0x08);

/**
 * Continuous built-in test response: response (0x01,0x88).
 *
 * Also called `continuous_bit_response`. Response to mip_base_continuous_built_in_test.
 *
 * - 3dm-cv7-gnss-ins: Continuous built-in test (0x01,0x08)
 */
struct mip_base_continuous_built_in_test_response {
    /**
     * Flags, defined by each device, least significant byte first: bit 8 is bit 0 of the second
     * byte. On the 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-INS, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-CX7-INS,
     * 3DM-GV7-AHRS, 3DM-GV7-AR and 3DM-GV7-INS: values of mip_cv7_inertial_bit. On the
     * 3DM-CV7-GNSS/INS: values of mip_cv7_continuous_built_in_test. On the 3DM-GQ7-GNSS/INS: values
     * of mip_gq7_continuous_built_in_test (inferred: the sources are about
     * mip_system_data_built_in_test, whose flags are the same on the 3DM-CV7-GNSS/INS).
     */
    uint8_t result[16];
};

#define MIP_BASE_CONTINUOUS_BUILT_IN_TEST_RESPONSE 0x0188
#define MIP_BASE_CONTINUOUS_BUILT_IN_TEST_RESPONSE_DESCRIPTOR 0x88
MIP_FIELD(mip_base_continuous_built_in_test_response, 0x88);

/**
 * Comm port speed: command (0x01,0x09).
 *
 * Sets the baud rate of one communication port.
 *
 * Functions: write, read, save, load and default. Response: mip_base_comm_speed_response. Devices
 * without it may have mip_3dm_uart_baud_rate.
 *
 * The change takes effect once pending data is sent and received, after at most 250 ms.
 *
 * Send it alone in a packet while the device is idle, and wait 250 ms before you continue.
 *
 * Commands and data during the change may be lost, or sent at either rate.
 *
 * - 3dm-cv7-gnss-ins: Comm Port Speed (0x01,0x09)
 */
struct mip_base_comm_speed {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Port id of the device; 0 means all ports, and is for save, load and default only. On the
     * 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-GV7-AHRS and 3DM-GV7-AR: values of
     * enum mip_comm_interface; only MIP_COMM_INTERFACE_MAIN, MIP_COMM_INTERFACE_UART_1 and
     * MIP_COMM_INTERFACE_USB_1. On the 3DM-CV7-GNSS/INS: values of enum mip_comm_interface. On the
     * 3DM-CV7-INS and 3DM-CX7-INS: values of enum mip_comm_interface; only MIP_COMM_INTERFACE_MAIN,
     * MIP_COMM_INTERFACE_UART_1, MIP_COMM_INTERFACE_UART_2, MIP_COMM_INTERFACE_UART_3 and
     * MIP_COMM_INTERFACE_USB_1. On the 3DM-GQ7-GNSS/INS: 1 is the main port, 2 the auxiliary one.
     * On the 3DM-GV7-INS: values of enum mip_comm_interface; only MIP_COMM_INTERFACE_MAIN,
     * MIP_COMM_INTERFACE_UART_1, MIP_COMM_INTERFACE_UART_2 and MIP_COMM_INTERFACE_USB_1. On the
     * 3DM-RTK: the values are unknown.
     */
    uint8_t port;
    /** New baud rate; the port must support it. Unit: Bd. Required for write. */
    uint32_t baud;
};

#define MIP_BASE_COMM_SPEED 0x0109
#define MIP_BASE_COMM_SPEED_DESCRIPTOR 0x09
MIP_FIELD(mip_base_comm_speed, 0x09);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_base_comm_speed *
mip_base_comm_speed_write(struct mip_base_comm_speed *command, uint8_t port, uint32_t baud) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->port = port;
    command->baud = baud;
    return command;
}

/** Fills the structure for `read`, and returns it. */
static inline struct mip_base_comm_speed *
mip_base_comm_speed_read(struct mip_base_comm_speed *command, uint8_t port) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->port = port;
    return command;
}

/** Fills the structure for `save`, and returns it. */
static inline struct mip_base_comm_speed *
mip_base_comm_speed_save(struct mip_base_comm_speed *command, uint8_t port) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->port = port;
    return command;
}

/** Fills the structure for `load`, and returns it. */
static inline struct mip_base_comm_speed *
mip_base_comm_speed_load(struct mip_base_comm_speed *command, uint8_t port) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->port = port;
    return command;
}

/** Fills the structure for `default`, and returns it. */
static inline struct mip_base_comm_speed *
mip_base_comm_speed_default(struct mip_base_comm_speed *command, uint8_t port) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->port = port;
    return command;
}

/**
 * Comm port speed response: response (0x01,0x89).
 *
 * Response to mip_base_comm_speed.
 *
 * - 3dm-cv7-gnss-ins: Comm Port Speed (0x01,0x09)
 */
struct mip_base_comm_speed_response {
    /**
     * Port id of the device. On the 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CX7-AHRS, 3DM-CX7-AR,
     * 3DM-GV7-AHRS and 3DM-GV7-AR: values of enum mip_comm_interface; only MIP_COMM_INTERFACE_MAIN,
     * MIP_COMM_INTERFACE_UART_1 and MIP_COMM_INTERFACE_USB_1. On the 3DM-CV7-GNSS/INS: values of
     * enum mip_comm_interface. On the 3DM-CV7-INS and 3DM-CX7-INS: values of enum
     * mip_comm_interface; only MIP_COMM_INTERFACE_MAIN, MIP_COMM_INTERFACE_UART_1,
     * MIP_COMM_INTERFACE_UART_2, MIP_COMM_INTERFACE_UART_3 and MIP_COMM_INTERFACE_USB_1. On the
     * 3DM-GQ7-GNSS/INS: 1 is the main port, 2 the auxiliary one. On the 3DM-GV7-INS: values of enum
     * mip_comm_interface; only MIP_COMM_INTERFACE_MAIN, MIP_COMM_INTERFACE_UART_1,
     * MIP_COMM_INTERFACE_UART_2 and MIP_COMM_INTERFACE_USB_1. On the 3DM-RTK: the values are
     * unknown.
     */
    uint8_t port;
    /** Baud rate of the port. Unit: Bd. */
    uint32_t baud;
};

#define MIP_BASE_COMM_SPEED_RESPONSE 0x0189
#define MIP_BASE_COMM_SPEED_RESPONSE_DESCRIPTOR 0x89
MIP_FIELD(mip_base_comm_speed_response, 0x89);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_base_comm_speed *mip_base_comm_speed_write_from(
    struct mip_base_comm_speed *command, const struct mip_base_comm_speed_response *response) {
    return mip_base_comm_speed_write(command, response->port, response->baud);
}

/**
 * GPS time update: command (0x01,0x72).
 *
 * Sets the week number or the time of week of the external (GPS) time.
 *
 * Functions: write, read and apply. Response: mip_base_gps_time_update_week_number_response or
 * mip_base_gps_time_update_tow_response. Affects mip_filter_data_timestamp,
 * mip_sensor_gps_timestamp, mip_shared_gps_timestamp and mip_shared_external_timestamp. On the
 * 3DM-CV7-GNSS/INS: write only.
 *
 * Send it once for the time of week and once for the week number after the PPS is locked.
 *
 * On the 3DM-CV7-GNSS/INS, the time may have a different epoch from GPS time, for example the Unix
 * epoch; mip_shared_external_timestamp then has the same epoch.
 *
 * The PPS supplies the fraction of the second; send the whole second that began at its last edge.
 *
 * Send it within 250 ms after the rising edge of the PPS.
 *
 * Once per second is recommended for the 3DM-GX5-15; the 3DM-CV7-GNSS/INS needs it at least once.
 *
 * Send it again after a PPS glitch. It is usually not needed if an internal GNSS receiver is the
 * PPS source.
 *
 * - 3dm-gx5-15: 4.1.8 GPS Time Update (0x01, 0x72)
 * - 3dm-cv7-gnss-ins: GPS Time Update Command (0x01,0x72)
 * - 3dm-cv7-gnss-ins: Timestamps
 */
struct mip_base_gps_time_update {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Meaning of the value. A value of enum mip_base_gps_time_field. */
    uint8_t field_id;
    /**
     * Week or seconds, as selected by `field_id`. Required for write and apply. If field_id is
     * MIP_BASE_GPS_TIME_FIELD_WEEK_NUMBER: unit week. GPS week number since 6 January 1980. If
     * field_id is MIP_BASE_GPS_TIME_FIELD_TOW: unit s. Whole seconds of the GPS week.
     */
    uint32_t value;
};

#define MIP_BASE_GPS_TIME_UPDATE 0x0172
#define MIP_BASE_GPS_TIME_UPDATE_DESCRIPTOR 0x72
MIP_FIELD(mip_base_gps_time_update, 0x72);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_base_gps_time_update *
mip_base_gps_time_update_write(struct mip_base_gps_time_update *command,
                               enum mip_base_gps_time_field field_id, uint32_t value) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->field_id = (uint8_t)field_id;
    command->value = value;
    return command;
}

/** Fills the structure for `read`, and returns it. */
static inline struct mip_base_gps_time_update *mip_base_gps_time_update_read(
    struct mip_base_gps_time_update *command, enum mip_base_gps_time_field field_id) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->field_id = (uint8_t)field_id;
    return command;
}

/** Fills the structure for `apply`, and returns it. */
static inline struct mip_base_gps_time_update *
mip_base_gps_time_update_apply(struct mip_base_gps_time_update *command,
                               enum mip_base_gps_time_field field_id, uint32_t value) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_APPLY;
    command->field_id = (uint8_t)field_id;
    command->value = value;
    return command;
}

/**
 * GPS time update, week number: response (0x01,0x84).
 *
 * The current week number.
 *
 * Response to mip_base_gps_time_update. Sent if field_id is MIP_BASE_GPS_TIME_FIELD_WEEK_NUMBER.
 *
 * - 3dm-gx5-15: 4.1.8 GPS Time Update (0x01, 0x72)
 * - 3dm-cv7-gnss-ins: GPS Time Update Command (0x01,0x72)
 * - 3dm-cv7-gnss-ins: Timestamps
 */
struct mip_base_gps_time_update_week_number_response {
    /** GPS week number. Unit: week. */
    uint32_t week_number;
};

#define MIP_BASE_GPS_TIME_UPDATE_WEEK_NUMBER_RESPONSE 0x0184
#define MIP_BASE_GPS_TIME_UPDATE_WEEK_NUMBER_RESPONSE_DESCRIPTOR 0x84
MIP_FIELD(mip_base_gps_time_update_week_number_response, 0x84);

/**
 * GPS time update, time of week: response (0x01,0x85).
 *
 * The current time of week.
 *
 * Response to mip_base_gps_time_update. Sent if field_id is MIP_BASE_GPS_TIME_FIELD_TOW.
 *
 * - 3dm-gx5-15: 4.1.8 GPS Time Update (0x01, 0x72)
 * - 3dm-cv7-gnss-ins: GPS Time Update Command (0x01,0x72)
 * - 3dm-cv7-gnss-ins: Timestamps
 */
struct mip_base_gps_time_update_tow_response {
    /** GPS time of week in whole seconds. Unit: s. */
    uint32_t tow;
};

#define MIP_BASE_GPS_TIME_UPDATE_TOW_RESPONSE 0x0185
#define MIP_BASE_GPS_TIME_UPDATE_TOW_RESPONSE_DESCRIPTOR 0x85
MIP_FIELD(mip_base_gps_time_update_tow_response, 0x85);

/**
 * Reset device: command (0x01,0x7E).
 *
 * Acknowledges the command, then resets the device immediately.
 *
 * - 3dm-gx5-15: 4.1.9 Device Reset (0x01, 0x7E)
 * - 3dm-cv7-gnss-ins: Reset device (0x01,0x7E)
 */
struct mip_base_soft_reset {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_BASE_SOFT_RESET 0x017E
#define MIP_BASE_SOFT_RESET_DESCRIPTOR 0x7E
MIP_FIELD(mip_base_soft_reset, 0x7E);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
