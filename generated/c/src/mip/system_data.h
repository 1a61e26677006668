/**
 * @file
 *
 * System data (0xA0). State of the device as a whole.
 *
 * The devices that support a field are in mip/extra/profiles.h.
 */
#ifndef MIP_SYSTEM_DATA_H
#define MIP_SYSTEM_DATA_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/system_data.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_system_data System data (0xA0)
 * @{ */

/** Descriptor set of these fields. */
#define MIP_SYSTEM_DATA_SET 0xA0

/** Level of each GPIO pin, set for high. Bits of pins that do not exist read 0. */
typedef uint8_t mip_system_data_gpio_pin_states;
/** Bit 0. GPIO pin 1 is high. */
#define MIP_SYSTEM_DATA_GPIO_PIN_STATES_PIN_1 0x01U
/** Bit 1. GPIO pin 2 is high. */
#define MIP_SYSTEM_DATA_GPIO_PIN_STATES_PIN_2 0x02U
/** Bit 2. GPIO pin 3 is high. */
#define MIP_SYSTEM_DATA_GPIO_PIN_STATES_PIN_3 0x04U
/** Bit 3. GPIO pin 4 is high. */
#define MIP_SYSTEM_DATA_GPIO_PIN_STATES_PIN_4 0x08U

/**
 * Built-in test: data (0xA0,0x01).
 *
 * Flags of the tests that run all the time.
 *
 * Requires firmware later than 1.0.10 on the 3DM-GQ7-GNSS/INS.
 *
 * The field is long; stream it at a low rate or poll it.
 *
 * A fault that has passed before the next message is still reported, because its flag stays set
 * until it is sent.
 *
 * Each stream and each event action keeps its own copy of the flags.
 *
 * Some flags may be set without a fault, for instance a receiver without a position fix.
 *
 * Unnamed bits are reserved and must be ignored.
 *
 * - 3dm-cv7-gnss-ins: Built In Test (0xA0,0x01)
 */
struct mip_system_data_built_in_test {
    /**
     * Flags, defined by each device, least significant byte first: bit 8 is bit 0 of the second
     * byte. On the 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-INS, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-CX7-INS,
     * 3DM-GV7-AHRS, 3DM-GV7-AR and 3DM-GV7-INS: values of mip_cv7_inertial_bit. On the
     * 3DM-CV7-GNSS/INS: values of mip_cv7_continuous_built_in_test. On the 3DM-GQ7-GNSS/INS: values
     * of mip_gq7_continuous_built_in_test.
     */
    uint8_t result[16];
};

#define MIP_SYSTEM_DATA_BUILT_IN_TEST 0xA001
#define MIP_SYSTEM_DATA_BUILT_IN_TEST_DESCRIPTOR 0x01
MIP_FIELD(mip_system_data_built_in_test, 0x01);

/**
 * Time sync status: data (0xA0,0x02).
 *
 * Synchronization of the device time with the pulse per second.
 *
 * Requires firmware later than 1.0.10 on the 3DM-GQ7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Time Sync Status (0xA0,0x02)
 */
struct mip_system_data_time_sync_status {
    /** True while the lock is valid; false if the PPS is disabled or no pulse is found. */
    mip_bool time_sync;
    /** Time since the last pulse, at most 255. Unit: s. */
    uint8_t last_pps_received;
};

#define MIP_SYSTEM_DATA_TIME_SYNC_STATUS 0xA002
#define MIP_SYSTEM_DATA_TIME_SYNC_STATUS_DESCRIPTOR 0x02
MIP_FIELD(mip_system_data_time_sync_status, 0x02);

/**
 * GPIO state: data (0xA0,0x03).
 *
 * Levels of all user GPIO pins.
 *
 * Requires firmware later than 1.0.10 on the 3DM-GQ7-GNSS/INS.
 *
 * A pulse that is shorter than the period at which the field is sent is missed.
 *
 * The pins are sampled within one base period of this set.
 *
 * Levels are guaranteed to be valid only for pins that mip_3dm_gpio_config configures for the GPIO
 * feature.
 *
 * For fast signals and exact times use the timestamp feature and the event system.
 *
 * - 3dm-cv7-gnss-ins: GPIO State (0xA0,0x03)
 */
struct mip_system_data_gpio_state {
    /** One bit for each pin. */
    mip_system_data_gpio_pin_states states;
};

#define MIP_SYSTEM_DATA_GPIO_STATE 0xA003
#define MIP_SYSTEM_DATA_GPIO_STATE_DESCRIPTOR 0x03
MIP_FIELD(mip_system_data_gpio_state, 0x03);

/**
 * GPIO analog value: data (0xA0,0x04).
 *
 * Voltage at one GPIO pin.
 *
 * Known only from the MicroStrain MIP SDK.
 *
 * The pin must be configured as an analog input.
 *
 * - mip-sdk-4: GPIO analog value (0xA0,0x04)
 */
struct mip_system_data_gpio_analog_value {
    /** GPIO pin, counted from 1. Range: at least 1. */
    uint8_t gpio_id;
    /** Scaled voltage. Unit: V. */
    float value;
};

#define MIP_SYSTEM_DATA_GPIO_ANALOG_VALUE 0xA004
#define MIP_SYSTEM_DATA_GPIO_ANALOG_VALUE_DESCRIPTOR 0x04
MIP_FIELD(mip_system_data_gpio_analog_value, 0x04);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
