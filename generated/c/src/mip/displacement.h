/**
 * @file
 *
 * Displacement commands (0x11). Commands of the DEMOD-DC, a demodulator for displacement sensors.
 * Inertial sensors do not support them.
 *
 * The devices that support a field are in mip/extra/profiles.h.
 */
#ifndef MIP_DISPLACEMENT_H
#define MIP_DISPLACEMENT_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/displacement.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_displacement Displacement commands (0x11)
 * @{ */

/** Descriptor set of these fields. */
#define MIP_DISPLACEMENT_SET 0x11

/**
 * Get analog to displacement calibration: command (0x11,0x01).
 *
 * Reads the slope and offset with which the device converts ADC counts to displacement.
 *
 * No device is known for certain to support it. Also called `get_analog_displacement_calibration`.
 * Response: mip_displacement_get_calibration_response. Known only from the MicroStrain
 * Communication Library.
 *
 * - mscl: Get analog to displacement calibration (0x11,0x01)
 */
struct mip_displacement_get_calibration {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_DISPLACEMENT_GET_CALIBRATION 0x1101
#define MIP_DISPLACEMENT_GET_CALIBRATION_DESCRIPTOR 0x01
MIP_FIELD(mip_displacement_get_calibration, 0x01);

/**
 * Get analog to displacement calibration response: response (0x11,0x81).
 *
 * No device is known for certain to support it. Also called
 * `get_analog_displacement_calibration_response`. Response to mip_displacement_get_calibration.
 * Known only from the MicroStrain Communication Library.
 *
 * - mscl: Get analog to displacement calibration (0x11,0x01)
 */
struct mip_displacement_get_calibration_response {
    /** Displacement per ADC count. Uncertain: No source states the unit; mm per count is likely. */
    float slope;
    /** Displacement at zero counts. Uncertain: No source states the unit; mm is likely. */
    float offset;
};

#define MIP_DISPLACEMENT_GET_CALIBRATION_RESPONSE 0x1181
#define MIP_DISPLACEMENT_GET_CALIBRATION_RESPONSE_DESCRIPTOR 0x81
MIP_FIELD(mip_displacement_get_calibration_response, 0x81);

/**
 * Displacement output data rate: command (0x11,0x02).
 *
 * Reads the rate at which displacement is measured.
 *
 * No device is known for certain to support it. Also called `displacement_output_rate`. Functions:
 * read. Response: mip_displacement_output_rate_response. Known only from the MicroStrain
 * Communication Library. Uncertain: MSCL only reads the rate; a write may not be supported.
 *
 * - mscl: Displacement output data rate (0x11,0x02)
 */
struct mip_displacement_output_rate {
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
};

#define MIP_DISPLACEMENT_OUTPUT_RATE 0x1102
#define MIP_DISPLACEMENT_OUTPUT_RATE_DESCRIPTOR 0x02
MIP_FIELD(mip_displacement_output_rate, 0x02);
MIP_FILL(mip_displacement_output_rate, read, MIP_FUNCTION_SELECTOR_READ);

/**
 * Displacement output data rate response: response (0x11,0x82).
 *
 * No device is known for certain to support it. Also called `displacement_output_rate_response`.
 * Response to mip_displacement_output_rate. Known only from the MicroStrain Communication Library.
 *
 * - mscl: Displacement output data rate (0x11,0x02)
 */
struct mip_displacement_output_rate_response {
    /** Rate of displacement data. Unit: Hz. */
    uint32_t rate;
};

#define MIP_DISPLACEMENT_OUTPUT_RATE_RESPONSE 0x1182
#define MIP_DISPLACEMENT_OUTPUT_RATE_RESPONSE_DESCRIPTOR 0x82
MIP_FIELD(mip_displacement_output_rate_response, 0x82);

/**
 * Displacement device time: command (0x11,0x04).
 *
 * Sets the clock of the device, from which mip_displacement_data_timestamp is taken.
 *
 * No device is known for certain to support it. Also called `displacement_device_time`. Functions:
 * write. Affects mip_displacement_data_timestamp. Known only from the MicroStrain Communication
 * Library. Uncertain: MSCL only writes the time; a read may not be supported.
 *
 * - mscl: Displacement device time (0x11,0x04)
 */
struct mip_displacement_device_time {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** UTC since 1970-01-01, without leap seconds. Unit: ns. */
    uint64_t time;
};

#define MIP_DISPLACEMENT_DEVICE_TIME 0x1104
#define MIP_DISPLACEMENT_DEVICE_TIME_DESCRIPTOR 0x04
MIP_FIELD(mip_displacement_device_time, 0x04);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_displacement_device_time *
mip_displacement_device_time_write(struct mip_displacement_device_time *command, uint64_t time) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->time = time;
    return command;
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
