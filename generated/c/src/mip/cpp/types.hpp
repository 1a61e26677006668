/**
 * @file
 * The types that descriptor sets share, in C++17: see mip/types.h and mip/protocol.h.
 */
#ifndef MIP_TYPES_HPP
#define MIP_TYPES_HPP

#include "mip/cpp/core.hpp"
#include "mip/protocol_inline.h"

namespace mip {

MIP_LAYOUT(mip_protocol_acknowledge, MIP_PROTOCOL_ACKNOWLEDGE, MIP_PROTOCOL_ACKNOWLEDGE,
           "protocol.acknowledge", decode_inline)

/** mip_function_selector: function_selector */
enum class function_selector : uint8_t {
    write = MIP_FUNCTION_SELECTOR_WRITE,
    read = MIP_FUNCTION_SELECTOR_READ,
    save = MIP_FUNCTION_SELECTOR_SAVE,
    load = MIP_FUNCTION_SELECTOR_LOAD,
    default_ = MIP_FUNCTION_SELECTOR_DEFAULT,
    apply = MIP_FUNCTION_SELECTOR_APPLY,
};
MIP_NAMES_OF(value_names, function_selector, mip_names_function_selector)

/** mip_gx5_built_in_test: gx5_built_in_test */
enum class gx5_built_in_test : uint32_t {
    watchdog_reset = MIP_GX5_BUILT_IN_TEST_WATCHDOG_RESET,
    imu_comm_fault = MIP_GX5_BUILT_IN_TEST_IMU_COMM_FAULT,
    mag_fault = MIP_GX5_BUILT_IN_TEST_MAG_FAULT,
    pressure_sensor_fault = MIP_GX5_BUILT_IN_TEST_PRESSURE_SENSOR_FAULT,
    solution_fault = MIP_GX5_BUILT_IN_TEST_SOLUTION_FAULT,
};
MIP_NAMES_OF(flag_names, gx5_built_in_test, mip_names_gx5_built_in_test)

/** mip_cv7_built_in_test: cv7_built_in_test */
enum class cv7_built_in_test : uint32_t {
    general_hardware_fault = MIP_CV7_BUILT_IN_TEST_GENERAL_HARDWARE_FAULT,
    general_firmware_fault = MIP_CV7_BUILT_IN_TEST_GENERAL_FIRMWARE_FAULT,
    timing_overload = MIP_CV7_BUILT_IN_TEST_TIMING_OVERLOAD,
    buffer_overrun = MIP_CV7_BUILT_IN_TEST_BUFFER_OVERRUN,
    accel_fault = MIP_CV7_BUILT_IN_TEST_ACCEL_FAULT,
    gyro_fault = MIP_CV7_BUILT_IN_TEST_GYRO_FAULT,
    mag_fault = MIP_CV7_BUILT_IN_TEST_MAG_FAULT,
    pressure_sensor_fault = MIP_CV7_BUILT_IN_TEST_PRESSURE_SENSOR_FAULT,
    calibration_error = MIP_CV7_BUILT_IN_TEST_CALIBRATION_ERROR,
    general_imu_fault = MIP_CV7_BUILT_IN_TEST_GENERAL_IMU_FAULT,
    filter_solution_fault = MIP_CV7_BUILT_IN_TEST_FILTER_SOLUTION_FAULT,
    general_filter_fault = MIP_CV7_BUILT_IN_TEST_GENERAL_FILTER_FAULT,
};
MIP_NAMES_OF(flag_names, cv7_built_in_test, mip_names_cv7_built_in_test)

/** mip_cv7_continuous_built_in_test: cv7_continuous_built_in_test */
using cv7_continuous_built_in_test = ::mip_cv7_continuous_built_in_test;

/** The bits of cv7_continuous_built_in_test, for mip::get and mip::has. */
enum class cv7_continuous_built_in_test_bits : std::uint16_t {
    system_clock_failure = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_SYSTEM_CLOCK_FAILURE,
    power_fault = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_POWER_FAULT,
    firmware_fault = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_FIRMWARE_FAULT,
    timing_overload = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_TIMING_OVERLOAD,
    buffer_overrun = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_BUFFER_OVERRUN,
    imu_process_fault = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_IMU_PROCESS_FAULT,
    imu_data_process_time_exceeded =
        MIP_CV7_CONTINUOUS_BUILT_IN_TEST_IMU_DATA_PROCESS_TIME_EXCEEDED,
    imu_data_rate_error = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_IMU_DATA_RATE_ERROR,
    imu_stall = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_IMU_STALL,
    filter_process_fault = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_FILTER_PROCESS_FAULT,
    filter_major_cycle_fault = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_FILTER_MAJOR_CYCLE_FAULT,
    filter_minor_cycle_fault = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_FILTER_MINOR_CYCLE_FAULT,
    filter_data_rate_error = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_FILTER_DATA_RATE_ERROR,
    filter_process_stall = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_FILTER_PROCESS_STALL,
    gnss_subsystem_fault = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_GNSS_SUBSYSTEM_FAULT,
    gnss_main_process_fault = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_GNSS_MAIN_PROCESS_FAULT,
    gnss_receiver_1_stall = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_GNSS_RECEIVER_1_STALL,
    gnss_receiver_2_stall = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_GNSS_RECEIVER_2_STALL,
    imu_comm_fault = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_IMU_COMM_FAULT,
    imu_timing_overrun = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_IMU_TIMING_OVERRUN,
    imu_calibration_error_accel = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_IMU_CALIBRATION_ERROR_ACCEL,
    imu_calibration_error_gyro = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_IMU_CALIBRATION_ERROR_GYRO,
    imu_calibration_error_mag = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_IMU_CALIBRATION_ERROR_MAG,
    accel_general_fault = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_ACCEL_GENERAL_FAULT,
    accel_over_range = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_ACCEL_OVER_RANGE,
    accel_self_test_fail = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_ACCEL_SELF_TEST_FAIL,
    gyro_general_fault = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_GYRO_GENERAL_FAULT,
    gyro_over_range = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_GYRO_OVER_RANGE,
    gyro_self_test_fail = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_GYRO_SELF_TEST_FAIL,
    mag_general_fault = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_MAG_GENERAL_FAULT,
    mag_over_range = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_MAG_OVER_RANGE,
    mag_self_test_fail = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_MAG_SELF_TEST_FAIL,
    pressure_sensor_general_fault = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_PRESSURE_SENSOR_GENERAL_FAULT,
    pressure_sensor_over_range = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_PRESSURE_SENSOR_OVER_RANGE,
    pressure_sensor_self_test_fail =
        MIP_CV7_CONTINUOUS_BUILT_IN_TEST_PRESSURE_SENSOR_SELF_TEST_FAIL,
    factory_bits_invalid = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_FACTORY_BITS_INVALID,
    filter_timing_overrun = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_FILTER_TIMING_OVERRUN,
    filter_timing_underrun = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_FILTER_TIMING_UNDERRUN,
    receiver_1_fault = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_RECEIVER_1_FAULT,
    receiver_1_no_solution = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_RECEIVER_1_NO_SOLUTION,
    receiver_2_fault = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_RECEIVER_2_FAULT,
    receiver_2_no_solution = MIP_CV7_CONTINUOUS_BUILT_IN_TEST_RECEIVER_2_NO_SOLUTION,
};
MIP_NAMES_OF(bit_names, cv7_continuous_built_in_test_bits, mip_names_cv7_continuous_built_in_test)

/** mip_cv7_inertial_bit: cv7_inertial_continuous_built_in_test */
using cv7_inertial_continuous_built_in_test = ::mip_cv7_inertial_bit;

/** The bits of cv7_inertial_continuous_built_in_test, for mip::get and mip::has. */
enum class cv7_inertial_continuous_built_in_test_bits : std::uint16_t {
    system_clock_failure = MIP_CV7_INERTIAL_BIT_SYSTEM_CLOCK_FAILURE,
    power_fault = MIP_CV7_INERTIAL_BIT_POWER_FAULT,
    firmware_fault = MIP_CV7_INERTIAL_BIT_FIRMWARE_FAULT,
    timing_overload = MIP_CV7_INERTIAL_BIT_TIMING_OVERLOAD,
    buffer_overrun = MIP_CV7_INERTIAL_BIT_BUFFER_OVERRUN,
    imu_process_fault = MIP_CV7_INERTIAL_BIT_IMU_PROCESS_FAULT,
    imu_data_rate_mismatch = MIP_CV7_INERTIAL_BIT_IMU_DATA_RATE_MISMATCH,
    imu_overrun_dropped_data = MIP_CV7_INERTIAL_BIT_IMU_OVERRUN_DROPPED_DATA,
    imu_stuck = MIP_CV7_INERTIAL_BIT_IMU_STUCK,
    filter_process_fault = MIP_CV7_INERTIAL_BIT_FILTER_PROCESS_FAULT,
    filter_dropped_data = MIP_CV7_INERTIAL_BIT_FILTER_DROPPED_DATA,
    filter_rate_mismatch = MIP_CV7_INERTIAL_BIT_FILTER_RATE_MISMATCH,
    filter_stuck = MIP_CV7_INERTIAL_BIT_FILTER_STUCK,
    imu_clock_fault = MIP_CV7_INERTIAL_BIT_IMU_CLOCK_FAULT,
    imu_comm_fault = MIP_CV7_INERTIAL_BIT_IMU_COMM_FAULT,
    imu_timing_overrun = MIP_CV7_INERTIAL_BIT_IMU_TIMING_OVERRUN,
    imu_calibration_error_accel = MIP_CV7_INERTIAL_BIT_IMU_CALIBRATION_ERROR_ACCEL,
    imu_calibration_error_gyro = MIP_CV7_INERTIAL_BIT_IMU_CALIBRATION_ERROR_GYRO,
    imu_calibration_error_mag = MIP_CV7_INERTIAL_BIT_IMU_CALIBRATION_ERROR_MAG,
    accel_general_fault = MIP_CV7_INERTIAL_BIT_ACCEL_GENERAL_FAULT,
    accel_over_range = MIP_CV7_INERTIAL_BIT_ACCEL_OVER_RANGE,
    accel_self_test_fail = MIP_CV7_INERTIAL_BIT_ACCEL_SELF_TEST_FAIL,
    gyro_general_fault = MIP_CV7_INERTIAL_BIT_GYRO_GENERAL_FAULT,
    gyro_over_range = MIP_CV7_INERTIAL_BIT_GYRO_OVER_RANGE,
    gyro_self_test_fail = MIP_CV7_INERTIAL_BIT_GYRO_SELF_TEST_FAIL,
    mag_general_fault = MIP_CV7_INERTIAL_BIT_MAG_GENERAL_FAULT,
    mag_over_range = MIP_CV7_INERTIAL_BIT_MAG_OVER_RANGE,
    mag_self_test_fail = MIP_CV7_INERTIAL_BIT_MAG_SELF_TEST_FAIL,
    pressure_sensor_general_fault = MIP_CV7_INERTIAL_BIT_PRESSURE_SENSOR_GENERAL_FAULT,
    pressure_sensor_over_range = MIP_CV7_INERTIAL_BIT_PRESSURE_SENSOR_OVER_RANGE,
    pressure_sensor_self_test_fail = MIP_CV7_INERTIAL_BIT_PRESSURE_SENSOR_SELF_TEST_FAIL,
    factory_bits_invalid = MIP_CV7_INERTIAL_BIT_FACTORY_BITS_INVALID,
    filter_fault = MIP_CV7_INERTIAL_BIT_FILTER_FAULT,
    filter_timing_overrun = MIP_CV7_INERTIAL_BIT_FILTER_TIMING_OVERRUN,
    filter_timing_underrun = MIP_CV7_INERTIAL_BIT_FILTER_TIMING_UNDERRUN,
};
MIP_NAMES_OF(bit_names, cv7_inertial_continuous_built_in_test_bits, mip_names_cv7_inertial_bit)

/** mip_gq7_continuous_built_in_test: gq7_continuous_built_in_test */
using gq7_continuous_built_in_test = ::mip_gq7_continuous_built_in_test;

/** The bits of gq7_continuous_built_in_test, for mip::get and mip::has. */
enum class gq7_continuous_built_in_test_bits : std::uint16_t {
    system_clock_failure = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_SYSTEM_CLOCK_FAILURE,
    power_fault = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_POWER_FAULT,
    firmware_fault = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_FIRMWARE_FAULT,
    timing_overload = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_TIMING_OVERLOAD,
    buffer_overrun = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_BUFFER_OVERRUN,
    imu_ipc_fault = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_IMU_IPC_FAULT,
    filter_ipc_fault = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_FILTER_IPC_FAULT,
    gnss_ipc_fault = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_GNSS_IPC_FAULT,
    imu_clock_fault = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_IMU_CLOCK_FAULT,
    imu_comm_fault = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_IMU_COMM_FAULT,
    imu_timing_overrun = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_IMU_TIMING_OVERRUN,
    imu_calibration_error_accel = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_IMU_CALIBRATION_ERROR_ACCEL,
    imu_calibration_error_gyro = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_IMU_CALIBRATION_ERROR_GYRO,
    imu_calibration_error_mag = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_IMU_CALIBRATION_ERROR_MAG,
    accel_general_fault = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_ACCEL_GENERAL_FAULT,
    accel_over_range = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_ACCEL_OVER_RANGE,
    accel_self_test_fail = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_ACCEL_SELF_TEST_FAIL,
    gyro_general_fault = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_GYRO_GENERAL_FAULT,
    gyro_over_range = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_GYRO_OVER_RANGE,
    gyro_self_test_fail = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_GYRO_SELF_TEST_FAIL,
    mag_general_fault = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_MAG_GENERAL_FAULT,
    mag_over_range = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_MAG_OVER_RANGE,
    mag_self_test_fail = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_MAG_SELF_TEST_FAIL,
    pressure_sensor_general_fault = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_PRESSURE_SENSOR_GENERAL_FAULT,
    pressure_sensor_over_range = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_PRESSURE_SENSOR_OVER_RANGE,
    pressure_sensor_self_test_fail =
        MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_PRESSURE_SENSOR_SELF_TEST_FAIL,
    filter_clock_fault = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_FILTER_CLOCK_FAULT,
    filter_hardware_fault = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_FILTER_HARDWARE_FAULT,
    filter_timing_overrun = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_FILTER_TIMING_OVERRUN,
    filter_timing_underrun = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_FILTER_TIMING_UNDERRUN,
    filter_comm_error = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_FILTER_COMM_ERROR,
    gnss_clock_fault = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_GNSS_CLOCK_FAULT,
    gnss_hardware_fault = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_GNSS_HARDWARE_FAULT,
    gnss_comm_error = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_GNSS_COMM_ERROR,
    gps_time_fault = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_GPS_TIME_FAULT,
    gnss_timing_overrun = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_GNSS_TIMING_OVERRUN,
    receiver_1_power_fault = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_RECEIVER_1_POWER_FAULT,
    receiver_1_fault = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_RECEIVER_1_FAULT,
    antenna_1_shorted = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_ANTENNA_1_SHORTED,
    antenna_1_open = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_ANTENNA_1_OPEN,
    receiver_1_solution_fault = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_RECEIVER_1_SOLUTION_FAULT,
    receiver_2_power_fault = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_RECEIVER_2_POWER_FAULT,
    receiver_2_fault = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_RECEIVER_2_FAULT,
    antenna_2_shorted = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_ANTENNA_2_SHORTED,
    antenna_2_open = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_ANTENNA_2_OPEN,
    receiver_2_solution_fault = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_RECEIVER_2_SOLUTION_FAULT,
    rtcm_comm_fault = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_RTCM_COMM_FAULT,
    rtk_dongle_fault = MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_RTK_DONGLE_FAULT,
};
MIP_NAMES_OF(bit_names, gq7_continuous_built_in_test_bits, mip_names_gq7_continuous_built_in_test)

/** mip_event_trigger_type: event_trigger_type */
enum class event_trigger_type : uint8_t {
    none = MIP_EVENT_TRIGGER_TYPE_NONE,
    gpio = MIP_EVENT_TRIGGER_TYPE_GPIO,
    threshold = MIP_EVENT_TRIGGER_TYPE_THRESHOLD,
    combination = MIP_EVENT_TRIGGER_TYPE_COMBINATION,
};
MIP_NAMES_OF(value_names, event_trigger_type, mip_names_event_trigger_type)

/** mip_event_action_type: event_action_type */
enum class event_action_type : uint8_t {
    none = MIP_EVENT_ACTION_TYPE_NONE,
    gpio = MIP_EVENT_ACTION_TYPE_GPIO,
    message = MIP_EVENT_ACTION_TYPE_MESSAGE,
};
MIP_NAMES_OF(value_names, event_action_type, mip_names_event_action_type)

/** mip_event_trigger_mode: event_trigger_mode */
enum class event_trigger_mode : uint8_t {
    disabled = MIP_EVENT_TRIGGER_MODE_DISABLED,
    enabled = MIP_EVENT_TRIGGER_MODE_ENABLED,
    test = MIP_EVENT_TRIGGER_MODE_TEST,
    test_pulse = MIP_EVENT_TRIGGER_MODE_TEST_PULSE,
};
MIP_NAMES_OF(value_names, event_trigger_mode, mip_names_event_trigger_mode)

/** mip_event_trigger_status: event_trigger_status */
enum class event_trigger_status : uint8_t {
    active = MIP_EVENT_TRIGGER_STATUS_ACTIVE,
    enabled = MIP_EVENT_TRIGGER_STATUS_ENABLED,
    test = MIP_EVENT_TRIGGER_STATUS_TEST,
};
MIP_NAMES_OF(flag_names, event_trigger_status, mip_names_event_trigger_status)

/** mip_event_trigger_gpio_mode: event_trigger_gpio_mode */
enum class event_trigger_gpio_mode : uint8_t {
    disabled = MIP_EVENT_TRIGGER_GPIO_MODE_DISABLED,
    while_high = MIP_EVENT_TRIGGER_GPIO_MODE_WHILE_HIGH,
    while_low = MIP_EVENT_TRIGGER_GPIO_MODE_WHILE_LOW,
    edge = MIP_EVENT_TRIGGER_GPIO_MODE_EDGE,
};
MIP_NAMES_OF(value_names, event_trigger_gpio_mode, mip_names_event_trigger_gpio_mode)

/** mip_event_threshold_type: event_threshold_type */
enum class event_threshold_type : uint8_t {
    window = MIP_EVENT_THRESHOLD_TYPE_WINDOW,
    interval = MIP_EVENT_THRESHOLD_TYPE_INTERVAL,
};
MIP_NAMES_OF(value_names, event_threshold_type, mip_names_event_threshold_type)

/** mip_event_action_gpio_mode: event_action_gpio_mode */
enum class event_action_gpio_mode : uint8_t {
    disabled = MIP_EVENT_ACTION_GPIO_MODE_DISABLED,
    active_high = MIP_EVENT_ACTION_GPIO_MODE_ACTIVE_HIGH,
    active_low = MIP_EVENT_ACTION_GPIO_MODE_ACTIVE_LOW,
    oneshot_high = MIP_EVENT_ACTION_GPIO_MODE_ONESHOT_HIGH,
    oneshot_low = MIP_EVENT_ACTION_GPIO_MODE_ONESHOT_LOW,
    toggle = MIP_EVENT_ACTION_GPIO_MODE_TOGGLE,
};
MIP_NAMES_OF(value_names, event_action_gpio_mode, mip_names_event_action_gpio_mode)

/** mip_event_trigger_gpio */
using event_trigger_gpio = ::mip_event_trigger_gpio;

/** mip_event_threshold_window */
using event_threshold_window = ::mip_event_threshold_window;

/** mip_event_threshold_interval */
using event_threshold_interval = ::mip_event_threshold_interval;

/** mip_event_trigger_threshold */
using event_trigger_threshold = ::mip_event_trigger_threshold;

/** mip_event_trigger_combination */
using event_trigger_combination = ::mip_event_trigger_combination;

/** mip_event_action_gpio */
using event_action_gpio = ::mip_event_action_gpio;

/** mip_event_action_message */
using event_action_message = ::mip_event_action_message;

/** mip_gnss_constellation: gnss_constellation */
enum class gnss_constellation : uint8_t {
    unknown = MIP_GNSS_CONSTELLATION_UNKNOWN,
    gps = MIP_GNSS_CONSTELLATION_GPS,
    glonass = MIP_GNSS_CONSTELLATION_GLONASS,
    galileo = MIP_GNSS_CONSTELLATION_GALILEO,
    beidou = MIP_GNSS_CONSTELLATION_BEIDOU,
    sbas = MIP_GNSS_CONSTELLATION_SBAS,
};
MIP_NAMES_OF(value_names, gnss_constellation, mip_names_gnss_constellation)

/** mip_gnss_fix_type: gnss_fix_type */
enum class gnss_fix_type : uint8_t {
    fix_3d = MIP_GNSS_FIX_TYPE_FIX_3D,
    fix_2d = MIP_GNSS_FIX_TYPE_FIX_2D,
    fix_time_only = MIP_GNSS_FIX_TYPE_FIX_TIME_ONLY,
    fix_none = MIP_GNSS_FIX_TYPE_FIX_NONE,
    fix_invalid = MIP_GNSS_FIX_TYPE_FIX_INVALID,
    fix_rtk_float = MIP_GNSS_FIX_TYPE_FIX_RTK_FLOAT,
    fix_rtk_fixed = MIP_GNSS_FIX_TYPE_FIX_RTK_FIXED,
    fix_differential = MIP_GNSS_FIX_TYPE_FIX_DIFFERENTIAL,
};
MIP_NAMES_OF(value_names, gnss_fix_type, mip_names_gnss_fix_type)

/** mip_gnss_signal: gnss_signal */
enum class gnss_signal : uint8_t {
    unknown = MIP_GNSS_SIGNAL_UNKNOWN,
    gps_l1ca = MIP_GNSS_SIGNAL_GPS_L1CA,
    gps_l1p = MIP_GNSS_SIGNAL_GPS_L1P,
    gps_l1z = MIP_GNSS_SIGNAL_GPS_L1Z,
    gps_l2ca = MIP_GNSS_SIGNAL_GPS_L2CA,
    gps_l2p = MIP_GNSS_SIGNAL_GPS_L2P,
    gps_l2z = MIP_GNSS_SIGNAL_GPS_L2Z,
    gps_l2cl = MIP_GNSS_SIGNAL_GPS_L2CL,
    gps_l2cm = MIP_GNSS_SIGNAL_GPS_L2CM,
    gps_l2cml = MIP_GNSS_SIGNAL_GPS_L2CML,
    gps_l5i = MIP_GNSS_SIGNAL_GPS_L5I,
    gps_l5q = MIP_GNSS_SIGNAL_GPS_L5Q,
    gps_l5iq = MIP_GNSS_SIGNAL_GPS_L5IQ,
    gps_l1cd = MIP_GNSS_SIGNAL_GPS_L1CD,
    gps_l1cp = MIP_GNSS_SIGNAL_GPS_L1CP,
    gps_l1cdp = MIP_GNSS_SIGNAL_GPS_L1CDP,
    glonass_g1ca = MIP_GNSS_SIGNAL_GLONASS_G1CA,
    glonass_g1p = MIP_GNSS_SIGNAL_GLONASS_G1P,
    glonass_g2c = MIP_GNSS_SIGNAL_GLONASS_G2C,
    glonass_g2p = MIP_GNSS_SIGNAL_GLONASS_G2P,
    galileo_e1c = MIP_GNSS_SIGNAL_GALILEO_E1C,
    galileo_e1a = MIP_GNSS_SIGNAL_GALILEO_E1A,
    galileo_e1b = MIP_GNSS_SIGNAL_GALILEO_E1B,
    galileo_e1bc = MIP_GNSS_SIGNAL_GALILEO_E1BC,
    galileo_e1abc = MIP_GNSS_SIGNAL_GALILEO_E1ABC,
    galileo_e6c = MIP_GNSS_SIGNAL_GALILEO_E6C,
    galileo_e6a = MIP_GNSS_SIGNAL_GALILEO_E6A,
    galileo_e6b = MIP_GNSS_SIGNAL_GALILEO_E6B,
    galileo_e6bc = MIP_GNSS_SIGNAL_GALILEO_E6BC,
    galileo_e6abc = MIP_GNSS_SIGNAL_GALILEO_E6ABC,
    galileo_e5bi = MIP_GNSS_SIGNAL_GALILEO_E5BI,
    galileo_e5bq = MIP_GNSS_SIGNAL_GALILEO_E5BQ,
    galileo_e5biq = MIP_GNSS_SIGNAL_GALILEO_E5BIQ,
    galileo_e5abi = MIP_GNSS_SIGNAL_GALILEO_E5ABI,
    galileo_e5abq = MIP_GNSS_SIGNAL_GALILEO_E5ABQ,
    galileo_e5abiq = MIP_GNSS_SIGNAL_GALILEO_E5ABIQ,
    galileo_e5ai = MIP_GNSS_SIGNAL_GALILEO_E5AI,
    galileo_e5aq = MIP_GNSS_SIGNAL_GALILEO_E5AQ,
    galileo_e5aiq = MIP_GNSS_SIGNAL_GALILEO_E5AIQ,
    sbas_l1ca = MIP_GNSS_SIGNAL_SBAS_L1CA,
    sbas_l5i = MIP_GNSS_SIGNAL_SBAS_L5I,
    sbas_l5q = MIP_GNSS_SIGNAL_SBAS_L5Q,
    sbas_l5iq = MIP_GNSS_SIGNAL_SBAS_L5IQ,
    qzss_l1ca = MIP_GNSS_SIGNAL_QZSS_L1CA,
    qzss_lexs = MIP_GNSS_SIGNAL_QZSS_LEXS,
    qzss_lexl = MIP_GNSS_SIGNAL_QZSS_LEXL,
    qzss_lexsl = MIP_GNSS_SIGNAL_QZSS_LEXSL,
    qzss_l2cm = MIP_GNSS_SIGNAL_QZSS_L2CM,
    qzss_l2cl = MIP_GNSS_SIGNAL_QZSS_L2CL,
    qzss_l2cml = MIP_GNSS_SIGNAL_QZSS_L2CML,
    qzss_l5i = MIP_GNSS_SIGNAL_QZSS_L5I,
    qzss_l5q = MIP_GNSS_SIGNAL_QZSS_L5Q,
    qzss_l5iq = MIP_GNSS_SIGNAL_QZSS_L5IQ,
    qzss_l1cd = MIP_GNSS_SIGNAL_QZSS_L1CD,
    qzss_l1cp = MIP_GNSS_SIGNAL_QZSS_L1CP,
    qzss_l1cdp = MIP_GNSS_SIGNAL_QZSS_L1CDP,
    beidou_b1i = MIP_GNSS_SIGNAL_BEIDOU_B1I,
    beidou_b1q = MIP_GNSS_SIGNAL_BEIDOU_B1Q,
    beidou_b1iq = MIP_GNSS_SIGNAL_BEIDOU_B1IQ,
    beidou_b3i = MIP_GNSS_SIGNAL_BEIDOU_B3I,
    beidou_b3q = MIP_GNSS_SIGNAL_BEIDOU_B3Q,
    beidou_b3iq = MIP_GNSS_SIGNAL_BEIDOU_B3IQ,
    beidou_b2i = MIP_GNSS_SIGNAL_BEIDOU_B2I,
    beidou_b2q = MIP_GNSS_SIGNAL_BEIDOU_B2Q,
    beidou_b2iq = MIP_GNSS_SIGNAL_BEIDOU_B2IQ,
    beidou_b2a = MIP_GNSS_SIGNAL_BEIDOU_B2A,
};
MIP_NAMES_OF(value_names, gnss_signal, mip_names_gnss_signal)

/** mip_gpio_feature: gpio_feature */
enum class gpio_feature : uint8_t {
    unused = MIP_GPIO_FEATURE_UNUSED,
    gpio = MIP_GPIO_FEATURE_GPIO,
    pps = MIP_GPIO_FEATURE_PPS,
    encoder = MIP_GPIO_FEATURE_ENCODER,
    timestamp = MIP_GPIO_FEATURE_TIMESTAMP,
    uart = MIP_GPIO_FEATURE_UART,
};
MIP_NAMES_OF(value_names, gpio_feature, mip_names_gpio_feature)

/** mip_gpio_unused_behavior: gpio_unused_behavior */
enum class gpio_unused_behavior : uint8_t {
    unused = MIP_GPIO_UNUSED_BEHAVIOR_UNUSED,
};
MIP_NAMES_OF(value_names, gpio_unused_behavior, mip_names_gpio_unused_behavior)

/** mip_gpio_behavior: gpio_behavior */
enum class gpio_behavior : uint8_t {
    input = MIP_GPIO_BEHAVIOR_INPUT,
    output_low = MIP_GPIO_BEHAVIOR_OUTPUT_LOW,
    output_high = MIP_GPIO_BEHAVIOR_OUTPUT_HIGH,
};
MIP_NAMES_OF(value_names, gpio_behavior, mip_names_gpio_behavior)

/** mip_gpio_pps_behavior: gpio_pps_behavior */
enum class gpio_pps_behavior : uint8_t {
    input = MIP_GPIO_PPS_BEHAVIOR_INPUT,
    output = MIP_GPIO_PPS_BEHAVIOR_OUTPUT,
};
MIP_NAMES_OF(value_names, gpio_pps_behavior, mip_names_gpio_pps_behavior)

/** mip_gpio_encoder_behavior: gpio_encoder_behavior */
enum class gpio_encoder_behavior : uint8_t {
    a = MIP_GPIO_ENCODER_BEHAVIOR_A,
    b = MIP_GPIO_ENCODER_BEHAVIOR_B,
};
MIP_NAMES_OF(value_names, gpio_encoder_behavior, mip_names_gpio_encoder_behavior)

/** mip_gpio_timestamp_behavior: gpio_timestamp_behavior */
enum class gpio_timestamp_behavior : uint8_t {
    rising = MIP_GPIO_TIMESTAMP_BEHAVIOR_RISING,
    falling = MIP_GPIO_TIMESTAMP_BEHAVIOR_FALLING,
    either = MIP_GPIO_TIMESTAMP_BEHAVIOR_EITHER,
};
MIP_NAMES_OF(value_names, gpio_timestamp_behavior, mip_names_gpio_timestamp_behavior)

/** mip_gpio_uart_behavior: gpio_uart_behavior */
enum class gpio_uart_behavior : uint8_t {
    port_2_tx = MIP_GPIO_UART_BEHAVIOR_PORT_2_TX,
    port_2_rx = MIP_GPIO_UART_BEHAVIOR_PORT_2_RX,
    port_3_tx = MIP_GPIO_UART_BEHAVIOR_PORT_3_TX,
    port_3_rx = MIP_GPIO_UART_BEHAVIOR_PORT_3_RX,
};
MIP_NAMES_OF(value_names, gpio_uart_behavior, mip_names_gpio_uart_behavior)

/** mip_gpio_pin_mode: gpio_pin_mode */
enum class gpio_pin_mode : uint8_t {
    open_drain = MIP_GPIO_PIN_MODE_OPEN_DRAIN,
    pulldown = MIP_GPIO_PIN_MODE_PULLDOWN,
    pullup = MIP_GPIO_PIN_MODE_PULLUP,
};
MIP_NAMES_OF(flag_names, gpio_pin_mode, mip_names_gpio_pin_mode)

/** mip_nmea_message_id: nmea_message_id */
enum class nmea_message_id : uint8_t {
    gga = MIP_NMEA_MESSAGE_ID_GGA,
    gll = MIP_NMEA_MESSAGE_ID_GLL,
    gsv = MIP_NMEA_MESSAGE_ID_GSV,
    rmc = MIP_NMEA_MESSAGE_ID_RMC,
    vtg = MIP_NMEA_MESSAGE_ID_VTG,
    hdt = MIP_NMEA_MESSAGE_ID_HDT,
    zda = MIP_NMEA_MESSAGE_ID_ZDA,
    gst = MIP_NMEA_MESSAGE_ID_GST,
    msra = MIP_NMEA_MESSAGE_ID_MSRA,
    msrr = MIP_NMEA_MESSAGE_ID_MSRR,
};
MIP_NAMES_OF(value_names, nmea_message_id, mip_names_nmea_message_id)

/** mip_nmea_talker_id: nmea_talker_id */
enum class nmea_talker_id : uint8_t {
    ignored = MIP_NMEA_TALKER_ID_IGNORED,
    gnss = MIP_NMEA_TALKER_ID_GNSS,
    gps = MIP_NMEA_TALKER_ID_GPS,
    galileo = MIP_NMEA_TALKER_ID_GALILEO,
    glonass = MIP_NMEA_TALKER_ID_GLONASS,
};
MIP_NAMES_OF(value_names, nmea_talker_id, mip_names_nmea_talker_id)

/** mip_nmea_message */
using nmea_message = ::mip_nmea_message;

/** mip_comm_interface: comm_interface */
enum class comm_interface : uint8_t {
    all = MIP_COMM_INTERFACE_ALL,
    main = MIP_COMM_INTERFACE_MAIN,
    uart_1 = MIP_COMM_INTERFACE_UART_1,
    uart_2 = MIP_COMM_INTERFACE_UART_2,
    uart_3 = MIP_COMM_INTERFACE_UART_3,
    usb_1 = MIP_COMM_INTERFACE_USB_1,
    usb_2 = MIP_COMM_INTERFACE_USB_2,
};
MIP_NAMES_OF(value_names, comm_interface, mip_names_comm_interface)

/** mip_rtk_status_flags: rtk_status_flags */
enum class rtk_status_flags : uint32_t {
    modem_state = MIP_RTK_STATUS_FLAGS_MODEM_STATE,
    connection_type = MIP_RTK_STATUS_FLAGS_CONNECTION_TYPE,
    rssi = MIP_RTK_STATUS_FLAGS_RSSI,
    signal_quality = MIP_RTK_STATUS_FLAGS_SIGNAL_QUALITY,
    tower_change_indicator = MIP_RTK_STATUS_FLAGS_TOWER_CHANGE_INDICATOR,
    nmea_timeout = MIP_RTK_STATUS_FLAGS_NMEA_TIMEOUT,
    server_timeout = MIP_RTK_STATUS_FLAGS_SERVER_TIMEOUT,
    corrections_timeout = MIP_RTK_STATUS_FLAGS_CORRECTIONS_TIMEOUT,
    device_out_of_range = MIP_RTK_STATUS_FLAGS_DEVICE_OUT_OF_RANGE,
    corrections_unavailable = MIP_RTK_STATUS_FLAGS_CORRECTIONS_UNAVAILABLE,
    version = MIP_RTK_STATUS_FLAGS_VERSION,
};
MIP_NAMES_OF(flag_names, rtk_status_flags, mip_names_rtk_status_flags)

/** mip_rtk_status_flags_legacy: rtk_status_flags_legacy */
enum class rtk_status_flags_legacy : uint32_t {
    controller_state = MIP_RTK_STATUS_FLAGS_LEGACY_CONTROLLER_STATE,
    platform_state = MIP_RTK_STATUS_FLAGS_LEGACY_PLATFORM_STATE,
    controller_status_code = MIP_RTK_STATUS_FLAGS_LEGACY_CONTROLLER_STATUS_CODE,
    platform_status_code = MIP_RTK_STATUS_FLAGS_LEGACY_PLATFORM_STATUS_CODE,
    reset_code = MIP_RTK_STATUS_FLAGS_LEGACY_RESET_CODE,
    signal_quality = MIP_RTK_STATUS_FLAGS_LEGACY_SIGNAL_QUALITY,
    rssi = MIP_RTK_STATUS_FLAGS_LEGACY_RSSI,
    rsrp = MIP_RTK_STATUS_FLAGS_LEGACY_RSRP,
    rsrq = MIP_RTK_STATUS_FLAGS_LEGACY_RSRQ,
    sinr = MIP_RTK_STATUS_FLAGS_LEGACY_SINR,
};
MIP_NAMES_OF(flag_names, rtk_status_flags_legacy, mip_names_rtk_status_flags_legacy)

/** mip_ack_code: ack_code */
enum class ack_code : uint8_t {
    ok = MIP_ACK_CODE_OK,
    unknown_command = MIP_ACK_CODE_UNKNOWN_COMMAND,
    bad_checksum = MIP_ACK_CODE_BAD_CHECKSUM,
    invalid_parameter = MIP_ACK_CODE_INVALID_PARAMETER,
    command_failed = MIP_ACK_CODE_COMMAND_FAILED,
    command_timeout = MIP_ACK_CODE_COMMAND_TIMEOUT,
    unknown_descriptor_set = MIP_ACK_CODE_UNKNOWN_DESCRIPTOR_SET,
};
MIP_NAMES_OF(value_names, ack_code, mip_names_ack_code)

/** mip_descriptor_rate */
using descriptor_rate = ::mip_descriptor_rate;

/** mip_sensor_gps_timestamp_flags: sensor_gps_timestamp_flags */
enum class sensor_gps_timestamp_flags : uint16_t {
    pps_valid = MIP_SENSOR_GPS_TIMESTAMP_FLAGS_PPS_VALID,
    time_refresh = MIP_SENSOR_GPS_TIMESTAMP_FLAGS_TIME_REFRESH,
    time_initialized = MIP_SENSOR_GPS_TIMESTAMP_FLAGS_TIME_INITIALIZED,
    tow_valid = MIP_SENSOR_GPS_TIMESTAMP_FLAGS_TOW_VALID,
    week_number_valid = MIP_SENSOR_GPS_TIMESTAMP_FLAGS_WEEK_NUMBER_VALID,
};
MIP_NAMES_OF(flag_names, sensor_gps_timestamp_flags, mip_names_sensor_gps_timestamp_flags)

/** mip_gx5_sensor_gps_timestamp_flags: gx5_sensor_gps_timestamp_flags */
enum class gx5_sensor_gps_timestamp_flags : uint16_t {
    pps_valid = MIP_GX5_SENSOR_GPS_TIMESTAMP_FLAGS_PPS_VALID,
    time_refresh = MIP_GX5_SENSOR_GPS_TIMESTAMP_FLAGS_TIME_REFRESH,
    time_initialized = MIP_GX5_SENSOR_GPS_TIMESTAMP_FLAGS_TIME_INITIALIZED,
};
MIP_NAMES_OF(flag_names, gx5_sensor_gps_timestamp_flags, mip_names_gx5_sensor_gps_timestamp_flags)

struct acknowledge_ : ::mip_protocol_acknowledge {
    using c_type = ::mip_protocol_acknowledge;
    ::mip::ack_code code() const {
        return static_cast<::mip::ack_code>(c_type::code);
    }
};

/** Acknowledge. See struct mip_protocol_acknowledge. */
using acknowledge = acknowledge_;

} // namespace mip

#endif
