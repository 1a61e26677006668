/* The names of values and bits. */
#include "mip/extra/names.h"
#include "mip/protocol.h"
#include "mip/base.h"
#include "mip/3dm.h"
#include "mip/filter.h"
#include "mip/gnss.h"
#include "mip/rtk.h"
#include "mip/displacement.h"
#include "mip/aiding.h"
#include "mip/system.h"
#include "mip/sensor.h"
#include "mip/gnss_data.h"
#include "mip/filter_data.h"
#include "mip/displacement_data.h"
#include "mip/system_data.h"
#include "mip/shared.h"

static const char name_function_selector[] = "function_selector";
static const char labels_function_selector[] = "write\0read\0save\0load\0default\0apply";
static const uint8_t numbers_function_selector[] = {1, 2, 3, 4, 5, 6};
const struct mip_names mip_names_function_selector = {
    name_function_selector, labels_function_selector, numbers_function_selector, NULL, 6, 1};

static const char name_gx5_built_in_test[] = "gx5_built_in_test";
static const char labels_gx5_built_in_test[] =
    "watchdog_reset\0imu_comm_fault\0mag_fault\0pressure_sensor_fault\0solution_fault";
static const struct mip_named_bits bits_gx5_built_in_test[] = {
    {0, 1, 0, NULL}, {8, 1, 0, NULL}, {9, 1, 0, NULL}, {10, 1, 0, NULL}, {24, 1, 0, NULL},
};
const struct mip_names mip_names_gx5_built_in_test = {
    name_gx5_built_in_test, labels_gx5_built_in_test, NULL, bits_gx5_built_in_test, 5, 4};

static const char name_cv7_built_in_test[] = "cv7_built_in_test";
static const char labels_cv7_built_in_test[] =
    "general_hardware_fault\0general_firmware_fault\0timing_overload\0buffer_overrun\0accel_"
    "fault\0gyro_fault\0mag_fault\0pressure_sensor_fault\0calibration_error\0general_imu_"
    "fault\0filter_solution_fault\0general_filter_fault";
static const struct mip_named_bits bits_cv7_built_in_test[] = {
    {0, 1, 0, NULL},  {1, 1, 0, NULL},  {2, 1, 0, NULL},  {3, 1, 0, NULL},
    {12, 1, 0, NULL}, {13, 1, 0, NULL}, {14, 1, 0, NULL}, {15, 1, 0, NULL},
    {18, 1, 0, NULL}, {19, 1, 0, NULL}, {22, 1, 0, NULL}, {23, 1, 0, NULL},
};
const struct mip_names mip_names_cv7_built_in_test = {
    name_cv7_built_in_test, labels_cv7_built_in_test, NULL, bits_cv7_built_in_test, 12, 4};

static const char name_cv7_continuous_built_in_test[] = "cv7_continuous_built_in_test";
static const char labels_cv7_continuous_built_in_test[] =
    "system_clock_failure\0power_fault\0firmware_fault\0timing_overload\0buffer_overrun\0imu_"
    "process_fault\0imu_data_process_time_exceeded\0imu_data_rate_error\0imu_stall\0filter_process_"
    "fault\0filter_major_cycle_fault\0filter_minor_cycle_fault\0filter_data_rate_error\0filter_"
    "process_stall\0gnss_subsystem_fault\0gnss_main_process_fault\0gnss_receiver_1_stall\0gnss_"
    "receiver_2_stall\0imu_comm_fault\0imu_timing_overrun\0imu_calibration_error_accel\0imu_"
    "calibration_error_gyro\0imu_calibration_error_mag\0accel_general_fault\0accel_over_"
    "range\0accel_self_test_fail\0gyro_general_fault\0gyro_over_range\0gyro_self_test_fail\0mag_"
    "general_fault\0mag_over_range\0mag_self_test_fail\0pressure_sensor_general_fault\0pressure_"
    "sensor_over_range\0pressure_sensor_self_test_fail\0factory_bits_invalid\0filter_timing_"
    "overrun\0filter_timing_underrun\0receiver_1_fault\0receiver_1_no_solution\0receiver_2_"
    "fault\0receiver_2_no_solution";
static const struct mip_named_bits bits_cv7_continuous_built_in_test[] = {
    {0, 1, 0, NULL},   {1, 1, 0, NULL},   {4, 1, 0, NULL},  {5, 1, 0, NULL},   {6, 1, 0, NULL},
    {16, 1, 0, NULL},  {17, 1, 0, NULL},  {18, 1, 0, NULL}, {19, 1, 0, NULL},  {20, 4, 0, NULL},
    {20, 1, 0, NULL},  {21, 1, 0, NULL},  {22, 1, 0, NULL}, {23, 1, 0, NULL},  {24, 4, 0, NULL},
    {24, 1, 0, NULL},  {25, 1, 0, NULL},  {26, 1, 0, NULL}, {33, 1, 0, NULL},  {34, 1, 0, NULL},
    {36, 1, 0, NULL},  {37, 1, 0, NULL},  {38, 1, 0, NULL}, {40, 1, 0, NULL},  {41, 1, 0, NULL},
    {42, 1, 0, NULL},  {44, 1, 0, NULL},  {45, 1, 0, NULL}, {46, 1, 0, NULL},  {48, 1, 0, NULL},
    {49, 1, 0, NULL},  {50, 1, 0, NULL},  {52, 1, 0, NULL}, {53, 1, 0, NULL},  {54, 1, 0, NULL},
    {56, 1, 0, NULL},  {66, 1, 0, NULL},  {67, 1, 0, NULL}, {105, 1, 0, NULL}, {108, 1, 0, NULL},
    {110, 1, 0, NULL}, {113, 1, 0, NULL},
};
const struct mip_names mip_names_cv7_continuous_built_in_test = {
    name_cv7_continuous_built_in_test,
    labels_cv7_continuous_built_in_test,
    NULL,
    bits_cv7_continuous_built_in_test,
    42,
    16};

static const char name_cv7_inertial_bit[] = "cv7_inertial_continuous_built_in_test";
static const char labels_cv7_inertial_bit[] =
    "system_clock_failure\0power_fault\0firmware_fault\0timing_overload\0buffer_overrun\0imu_"
    "process_fault\0imu_data_rate_mismatch\0imu_overrun_dropped_data\0imu_stuck\0filter_process_"
    "fault\0filter_dropped_data\0filter_rate_mismatch\0filter_stuck\0imu_clock_fault\0imu_comm_"
    "fault\0imu_timing_overrun\0imu_calibration_error_accel\0imu_calibration_error_gyro\0imu_"
    "calibration_error_mag\0accel_general_fault\0accel_over_range\0accel_self_test_fail\0gyro_"
    "general_fault\0gyro_over_range\0gyro_self_test_fail\0mag_general_fault\0mag_over_range\0mag_"
    "self_test_fail\0pressure_sensor_general_fault\0pressure_sensor_over_range\0pressure_sensor_"
    "self_test_fail\0factory_bits_invalid\0filter_fault\0filter_timing_overrun\0filter_timing_"
    "underrun";
static const struct mip_named_bits bits_cv7_inertial_bit[] = {
    {0, 1, 0, NULL},  {1, 1, 0, NULL},  {4, 1, 0, NULL},  {5, 1, 0, NULL},  {6, 1, 0, NULL},
    {16, 1, 0, NULL}, {17, 1, 0, NULL}, {18, 1, 0, NULL}, {19, 1, 0, NULL}, {20, 1, 0, NULL},
    {21, 1, 0, NULL}, {22, 1, 0, NULL}, {23, 1, 0, NULL}, {32, 1, 0, NULL}, {33, 1, 0, NULL},
    {34, 1, 0, NULL}, {36, 1, 0, NULL}, {37, 1, 0, NULL}, {38, 1, 0, NULL}, {40, 1, 0, NULL},
    {41, 1, 0, NULL}, {42, 1, 0, NULL}, {44, 1, 0, NULL}, {45, 1, 0, NULL}, {46, 1, 0, NULL},
    {48, 1, 0, NULL}, {49, 1, 0, NULL}, {50, 1, 0, NULL}, {52, 1, 0, NULL}, {53, 1, 0, NULL},
    {54, 1, 0, NULL}, {56, 1, 0, NULL}, {64, 1, 0, NULL}, {66, 1, 0, NULL}, {67, 1, 0, NULL},
};
const struct mip_names mip_names_cv7_inertial_bit = {
    name_cv7_inertial_bit, labels_cv7_inertial_bit, NULL, bits_cv7_inertial_bit, 35, 16};

static const char name_gq7_continuous_built_in_test[] = "gq7_continuous_built_in_test";
static const char labels_gq7_continuous_built_in_test[] =
    "system_clock_failure\0power_fault\0firmware_fault\0timing_overload\0buffer_overrun\0imu_ipc_"
    "fault\0filter_ipc_fault\0gnss_ipc_fault\0imu_clock_fault\0imu_comm_fault\0imu_timing_"
    "overrun\0imu_calibration_error_accel\0imu_calibration_error_gyro\0imu_calibration_error_"
    "mag\0accel_general_fault\0accel_over_range\0accel_self_test_fail\0gyro_general_fault\0gyro_"
    "over_range\0gyro_self_test_fail\0mag_general_fault\0mag_over_range\0mag_self_test_"
    "fail\0pressure_sensor_general_fault\0pressure_sensor_over_range\0pressure_sensor_self_test_"
    "fail\0filter_clock_fault\0filter_hardware_fault\0filter_timing_overrun\0filter_timing_"
    "underrun\0filter_comm_error\0gnss_clock_fault\0gnss_hardware_fault\0gnss_comm_error\0gps_time_"
    "fault\0gnss_timing_overrun\0receiver_1_power_fault\0receiver_1_fault\0antenna_1_"
    "shorted\0antenna_1_open\0receiver_1_solution_fault\0receiver_2_power_fault\0receiver_2_"
    "fault\0antenna_2_shorted\0antenna_2_open\0receiver_2_solution_fault\0rtcm_comm_fault\0rtk_"
    "dongle_fault";
static const struct mip_named_bits bits_gq7_continuous_built_in_test[] = {
    {0, 1, 0, NULL},   {1, 1, 0, NULL},   {4, 1, 0, NULL},   {5, 1, 0, NULL},   {6, 1, 0, NULL},
    {16, 4, 0, NULL},  {20, 4, 0, NULL},  {24, 4, 0, NULL},  {32, 1, 0, NULL},  {33, 1, 0, NULL},
    {34, 1, 0, NULL},  {36, 1, 0, NULL},  {37, 1, 0, NULL},  {38, 1, 0, NULL},  {40, 1, 0, NULL},
    {41, 1, 0, NULL},  {42, 1, 0, NULL},  {44, 1, 0, NULL},  {45, 1, 0, NULL},  {46, 1, 0, NULL},
    {48, 1, 0, NULL},  {49, 1, 0, NULL},  {50, 1, 0, NULL},  {52, 1, 0, NULL},  {53, 1, 0, NULL},
    {54, 1, 0, NULL},  {64, 1, 0, NULL},  {65, 1, 0, NULL},  {66, 1, 0, NULL},  {67, 1, 0, NULL},
    {68, 4, 0, NULL},  {96, 1, 0, NULL},  {97, 1, 0, NULL},  {98, 3, 0, NULL},  {101, 1, 0, NULL},
    {102, 1, 0, NULL}, {104, 1, 0, NULL}, {105, 1, 0, NULL}, {106, 1, 0, NULL}, {107, 1, 0, NULL},
    {108, 1, 0, NULL}, {109, 1, 0, NULL}, {110, 1, 0, NULL}, {111, 1, 0, NULL}, {112, 1, 0, NULL},
    {113, 1, 0, NULL}, {114, 1, 0, NULL}, {115, 1, 0, NULL},
};
const struct mip_names mip_names_gq7_continuous_built_in_test = {
    name_gq7_continuous_built_in_test,
    labels_gq7_continuous_built_in_test,
    NULL,
    bits_gq7_continuous_built_in_test,
    48,
    16};

static const char name_event_trigger_type[] = "event_trigger_type";
static const char labels_event_trigger_type[] = "none\0gpio\0threshold\0combination";
static const uint8_t numbers_event_trigger_type[] = {0, 1, 2, 3};
const struct mip_names mip_names_event_trigger_type = {
    name_event_trigger_type, labels_event_trigger_type, numbers_event_trigger_type, NULL, 4, 1};

static const char name_event_action_type[] = "event_action_type";
static const char labels_event_action_type[] = "none\0gpio\0message";
static const uint8_t numbers_event_action_type[] = {0, 1, 2};
const struct mip_names mip_names_event_action_type = {
    name_event_action_type, labels_event_action_type, numbers_event_action_type, NULL, 3, 1};

static const char name_event_trigger_mode[] = "event_trigger_mode";
static const char labels_event_trigger_mode[] = "disabled\0enabled\0test\0test_pulse";
static const uint8_t numbers_event_trigger_mode[] = {0, 1, 2, 3};
const struct mip_names mip_names_event_trigger_mode = {
    name_event_trigger_mode, labels_event_trigger_mode, numbers_event_trigger_mode, NULL, 4, 1};

static const char name_event_trigger_status[] = "event_trigger_status";
static const char labels_event_trigger_status[] = "active\0enabled\0test";
static const struct mip_named_bits bits_event_trigger_status[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
    {2, 1, 0, NULL},
};
const struct mip_names mip_names_event_trigger_status = {
    name_event_trigger_status, labels_event_trigger_status, NULL, bits_event_trigger_status, 3, 1};

static const char name_event_trigger_gpio_mode[] = "event_trigger_gpio_mode";
static const char labels_event_trigger_gpio_mode[] = "disabled\0while_high\0while_low\0edge";
static const uint8_t numbers_event_trigger_gpio_mode[] = {0, 1, 2, 4};
const struct mip_names mip_names_event_trigger_gpio_mode = {name_event_trigger_gpio_mode,
                                                            labels_event_trigger_gpio_mode,
                                                            numbers_event_trigger_gpio_mode,
                                                            NULL,
                                                            4,
                                                            1};

static const char name_event_threshold_type[] = "event_threshold_type";
static const char labels_event_threshold_type[] = "window\0interval";
static const uint8_t numbers_event_threshold_type[] = {1, 2};
const struct mip_names mip_names_event_threshold_type = {name_event_threshold_type,
                                                         labels_event_threshold_type,
                                                         numbers_event_threshold_type,
                                                         NULL,
                                                         2,
                                                         1};

static const char name_event_action_gpio_mode[] = "event_action_gpio_mode";
static const char labels_event_action_gpio_mode[] =
    "disabled\0active_high\0active_low\0oneshot_high\0oneshot_low\0toggle";
static const uint8_t numbers_event_action_gpio_mode[] = {0, 1, 2, 5, 6, 7};
const struct mip_names mip_names_event_action_gpio_mode = {name_event_action_gpio_mode,
                                                           labels_event_action_gpio_mode,
                                                           numbers_event_action_gpio_mode,
                                                           NULL,
                                                           6,
                                                           1};

static const char name_gnss_constellation[] = "gnss_constellation";
static const char labels_gnss_constellation[] = "unknown\0gps\0glonass\0galileo\0beidou\0sbas";
static const uint8_t numbers_gnss_constellation[] = {0, 1, 2, 3, 4, 5};
const struct mip_names mip_names_gnss_constellation = {
    name_gnss_constellation, labels_gnss_constellation, numbers_gnss_constellation, NULL, 6, 1};

static const char name_gnss_fix_type[] = "gnss_fix_type";
static const char labels_gnss_fix_type[] =
    "fix_3d\0fix_2d\0fix_time_only\0fix_none\0fix_invalid\0fix_rtk_float\0fix_rtk_fixed\0fix_"
    "differential";
static const uint8_t numbers_gnss_fix_type[] = {0, 1, 2, 3, 4, 5, 6, 7};
const struct mip_names mip_names_gnss_fix_type = {
    name_gnss_fix_type, labels_gnss_fix_type, numbers_gnss_fix_type, NULL, 8, 1};

static const char name_gnss_signal[] = "gnss_signal";
static const char labels_gnss_signal[] =
    "unknown\0gps_l1ca\0gps_l1p\0gps_l1z\0gps_l2ca\0gps_l2p\0gps_l2z\0gps_l2cl\0gps_l2cm\0gps_"
    "l2cml\0gps_l5i\0gps_l5q\0gps_l5iq\0gps_l1cd\0gps_l1cp\0gps_l1cdp\0glonass_g1ca\0glonass_"
    "g1p\0glonass_g2c\0glonass_g2p\0galileo_e1c\0galileo_e1a\0galileo_e1b\0galileo_e1bc\0galileo_"
    "e1abc\0galileo_e6c\0galileo_e6a\0galileo_e6b\0galileo_e6bc\0galileo_e6abc\0galileo_"
    "e5bi\0galileo_e5bq\0galileo_e5biq\0galileo_e5abi\0galileo_e5abq\0galileo_e5abiq\0galileo_"
    "e5ai\0galileo_e5aq\0galileo_e5aiq\0sbas_l1ca\0sbas_l5i\0sbas_l5q\0sbas_l5iq\0qzss_l1ca\0qzss_"
    "lexs\0qzss_lexl\0qzss_lexsl\0qzss_l2cm\0qzss_l2cl\0qzss_l2cml\0qzss_l5i\0qzss_l5q\0qzss_"
    "l5iq\0qzss_l1cd\0qzss_l1cp\0qzss_l1cdp\0beidou_b1i\0beidou_b1q\0beidou_b1iq\0beidou_"
    "b3i\0beidou_b3q\0beidou_b3iq\0beidou_b2i\0beidou_b2q\0beidou_b2iq\0beidou_b2a";
static const uint8_t numbers_gnss_signal[] = {
    0,   1,   2,   3,   4,   5,   6,   7,   8,   9,   10,  11,  12,  13,  14,  15,  32,
    33,  34,  35,  64,  65,  66,  67,  68,  69,  70,  71,  72,  73,  74,  75,  76,  77,
    78,  79,  80,  81,  82,  96,  97,  98,  99,  128, 129, 130, 131, 132, 133, 134, 135,
    136, 137, 138, 139, 140, 160, 161, 162, 163, 164, 165, 166, 167, 168, 169};
const struct mip_names mip_names_gnss_signal = {
    name_gnss_signal, labels_gnss_signal, numbers_gnss_signal, NULL, 66, 1};

static const char name_gpio_feature[] = "gpio_feature";
static const char labels_gpio_feature[] = "unused\0gpio\0pps\0encoder\0timestamp\0uart";
static const uint8_t numbers_gpio_feature[] = {0, 1, 2, 3, 4, 5};
const struct mip_names mip_names_gpio_feature = {
    name_gpio_feature, labels_gpio_feature, numbers_gpio_feature, NULL, 6, 1};

static const char name_gpio_unused_behavior[] = "gpio_unused_behavior";
static const char labels_gpio_unused_behavior[] = "unused";
static const uint8_t numbers_gpio_unused_behavior[] = {0};
const struct mip_names mip_names_gpio_unused_behavior = {name_gpio_unused_behavior,
                                                         labels_gpio_unused_behavior,
                                                         numbers_gpio_unused_behavior,
                                                         NULL,
                                                         1,
                                                         1};

static const char name_gpio_behavior[] = "gpio_behavior";
static const char labels_gpio_behavior[] = "input\0output_low\0output_high";
static const uint8_t numbers_gpio_behavior[] = {1, 2, 3};
const struct mip_names mip_names_gpio_behavior = {
    name_gpio_behavior, labels_gpio_behavior, numbers_gpio_behavior, NULL, 3, 1};

static const char name_gpio_pps_behavior[] = "gpio_pps_behavior";
static const char labels_gpio_pps_behavior[] = "input\0output";
static const uint8_t numbers_gpio_pps_behavior[] = {1, 2};
const struct mip_names mip_names_gpio_pps_behavior = {
    name_gpio_pps_behavior, labels_gpio_pps_behavior, numbers_gpio_pps_behavior, NULL, 2, 1};

static const char name_gpio_encoder_behavior[] = "gpio_encoder_behavior";
static const char labels_gpio_encoder_behavior[] = "a\0b";
static const uint8_t numbers_gpio_encoder_behavior[] = {1, 2};
const struct mip_names mip_names_gpio_encoder_behavior = {name_gpio_encoder_behavior,
                                                          labels_gpio_encoder_behavior,
                                                          numbers_gpio_encoder_behavior,
                                                          NULL,
                                                          2,
                                                          1};

static const char name_gpio_timestamp_behavior[] = "gpio_timestamp_behavior";
static const char labels_gpio_timestamp_behavior[] = "rising\0falling\0either";
static const uint8_t numbers_gpio_timestamp_behavior[] = {1, 2, 3};
const struct mip_names mip_names_gpio_timestamp_behavior = {name_gpio_timestamp_behavior,
                                                            labels_gpio_timestamp_behavior,
                                                            numbers_gpio_timestamp_behavior,
                                                            NULL,
                                                            3,
                                                            1};

static const char name_gpio_uart_behavior[] = "gpio_uart_behavior";
static const char labels_gpio_uart_behavior[] = "port_2_tx\0port_2_rx\0port_3_tx\0port_3_rx";
static const uint8_t numbers_gpio_uart_behavior[] = {33, 34, 49, 50};
const struct mip_names mip_names_gpio_uart_behavior = {
    name_gpio_uart_behavior, labels_gpio_uart_behavior, numbers_gpio_uart_behavior, NULL, 4, 1};

static const char name_gpio_pin_mode[] = "gpio_pin_mode";
static const char labels_gpio_pin_mode[] = "open_drain\0pulldown\0pullup";
static const struct mip_named_bits bits_gpio_pin_mode[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
    {2, 1, 0, NULL},
};
const struct mip_names mip_names_gpio_pin_mode = {
    name_gpio_pin_mode, labels_gpio_pin_mode, NULL, bits_gpio_pin_mode, 3, 1};

static const char name_nmea_message_id[] = "nmea_message_id";
static const char labels_nmea_message_id[] = "gga\0gll\0gsv\0rmc\0vtg\0hdt\0zda\0gst\0msra\0msrr";
static const uint8_t numbers_nmea_message_id[] = {1, 2, 3, 4, 5, 6, 7, 8, 129, 130};
const struct mip_names mip_names_nmea_message_id = {
    name_nmea_message_id, labels_nmea_message_id, numbers_nmea_message_id, NULL, 10, 1};

static const char name_nmea_talker_id[] = "nmea_talker_id";
static const char labels_nmea_talker_id[] = "ignored\0gnss\0gps\0galileo\0glonass";
static const uint8_t numbers_nmea_talker_id[] = {0, 1, 2, 3, 4};
const struct mip_names mip_names_nmea_talker_id = {
    name_nmea_talker_id, labels_nmea_talker_id, numbers_nmea_talker_id, NULL, 5, 1};

static const char name_comm_interface[] = "comm_interface";
static const char labels_comm_interface[] = "all\0main\0uart_1\0uart_2\0uart_3\0usb_1\0usb_2";
static const uint8_t numbers_comm_interface[] = {0, 1, 17, 18, 19, 33, 34};
const struct mip_names mip_names_comm_interface = {
    name_comm_interface, labels_comm_interface, numbers_comm_interface, NULL, 7, 1};

static const char name_rtk_status_flags[] = "rtk_status_flags";
static const char labels_rtk_status_flags[] =
    "modem_state\0connection_type\0rssi\0signal_quality\0tower_change_indicator\0nmea_"
    "timeout\0server_timeout\0corrections_timeout\0device_out_of_range\0corrections_"
    "unavailable\0version";
static const struct mip_named_bits bits_rtk_status_flags[] = {
    {0, 4, 0, NULL},  {4, 4, 0, NULL},  {8, 8, 0, NULL},  {16, 4, 0, NULL},
    {20, 4, 0, NULL}, {24, 1, 0, NULL}, {25, 1, 0, NULL}, {26, 1, 0, NULL},
    {27, 1, 0, NULL}, {28, 1, 0, NULL}, {30, 2, 0, NULL},
};
const struct mip_names mip_names_rtk_status_flags = {
    name_rtk_status_flags, labels_rtk_status_flags, NULL, bits_rtk_status_flags, 11, 4};

static const char name_rtk_status_flags_legacy[] = "rtk_status_flags_legacy";
static const char labels_rtk_status_flags_legacy[] =
    "controller_state\0platform_state\0controller_status_code\0platform_status_code\0reset_"
    "code\0signal_quality\0rssi\0rsrp\0rsrq\0sinr";
static const struct mip_named_bits bits_rtk_status_flags_legacy[] = {
    {0, 3, 0, NULL},  {3, 5, 0, NULL},  {8, 3, 0, NULL},  {11, 3, 0, NULL}, {14, 2, 0, NULL},
    {16, 4, 0, NULL}, {20, 6, 0, NULL}, {26, 2, 0, NULL}, {28, 2, 0, NULL}, {30, 2, 0, NULL},
};
const struct mip_names mip_names_rtk_status_flags_legacy = {name_rtk_status_flags_legacy,
                                                            labels_rtk_status_flags_legacy,
                                                            NULL,
                                                            bits_rtk_status_flags_legacy,
                                                            10,
                                                            4};

static const char name_ack_code[] = "ack_code";
static const char labels_ack_code[] =
    "ok\0unknown_command\0bad_checksum\0invalid_parameter\0command_failed\0command_"
    "timeout\0unknown_descriptor_set";
static const uint8_t numbers_ack_code[] = {0, 1, 2, 3, 4, 5, 6};
const struct mip_names mip_names_ack_code = {
    name_ack_code, labels_ack_code, numbers_ack_code, NULL, 7, 1};

static const char name_sensor_gps_timestamp_flags[] = "sensor_gps_timestamp_flags";
static const char labels_sensor_gps_timestamp_flags[] =
    "pps_valid\0time_refresh\0time_initialized\0tow_valid\0week_number_valid";
static const struct mip_named_bits bits_sensor_gps_timestamp_flags[] = {
    {0, 1, 0, NULL}, {1, 1, 0, NULL}, {2, 1, 0, NULL}, {3, 1, 0, NULL}, {4, 1, 0, NULL},
};
const struct mip_names mip_names_sensor_gps_timestamp_flags = {name_sensor_gps_timestamp_flags,
                                                               labels_sensor_gps_timestamp_flags,
                                                               NULL,
                                                               bits_sensor_gps_timestamp_flags,
                                                               5,
                                                               2};

static const char name_gx5_sensor_gps_timestamp_flags[] = "gx5_sensor_gps_timestamp_flags";
static const char labels_gx5_sensor_gps_timestamp_flags[] =
    "pps_valid\0time_refresh\0time_initialized";
static const struct mip_named_bits bits_gx5_sensor_gps_timestamp_flags[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
    {2, 1, 0, NULL},
};
const struct mip_names mip_names_gx5_sensor_gps_timestamp_flags = {
    name_gx5_sensor_gps_timestamp_flags,
    labels_gx5_sensor_gps_timestamp_flags,
    NULL,
    bits_gx5_sensor_gps_timestamp_flags,
    3,
    2};

static const char name_base_gps_time_field[] = "base.gps_time_field";
static const char labels_base_gps_time_field[] = "week_number\0tow";
static const uint8_t numbers_base_gps_time_field[] = {1, 2};
const struct mip_names mip_names_base_gps_time_field = {
    name_base_gps_time_field, labels_base_gps_time_field, numbers_base_gps_time_field, NULL, 2, 1};

static const char name_3dm_factory_streaming_action[] = "3dm.factory_streaming_action";
static const char labels_3dm_factory_streaming_action[] = "overwrite\0merge\0add";
static const uint8_t numbers_3dm_factory_streaming_action[] = {0, 1, 2};
const struct mip_names mip_names_3dm_factory_streaming_action = {
    name_3dm_factory_streaming_action,
    labels_3dm_factory_streaming_action,
    numbers_3dm_factory_streaming_action,
    NULL,
    3,
    1};

static const char name_3dm_constellation_id[] = "3dm.constellation_id";
static const char labels_3dm_constellation_id[] = "gps\0sbas\0galileo\0beidou\0qzss\0glonass";
static const uint8_t numbers_3dm_constellation_id[] = {0, 1, 2, 3, 5, 6};
const struct mip_names mip_names_3dm_constellation_id = {name_3dm_constellation_id,
                                                         labels_3dm_constellation_id,
                                                         numbers_3dm_constellation_id,
                                                         NULL,
                                                         6,
                                                         1};

static const char name_3dm_constellation_options[] = "3dm.constellation_options";
static const char labels_3dm_constellation_options[] = "l1saif";
static const struct mip_named_bits bits_3dm_constellation_options[] = {
    {0, 1, 0, NULL},
};
const struct mip_names mip_names_3dm_constellation_options = {name_3dm_constellation_options,
                                                              labels_3dm_constellation_options,
                                                              NULL,
                                                              bits_3dm_constellation_options,
                                                              1,
                                                              2};

static const char name_3dm_sbas_options[] = "3dm.sbas_options";
static const char labels_3dm_sbas_options[] = "enable_ranging\0enable_corrections\0apply_integrity";
static const struct mip_named_bits bits_3dm_sbas_options[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
    {2, 1, 0, NULL},
};
const struct mip_names mip_names_3dm_sbas_options = {
    name_3dm_sbas_options, labels_3dm_sbas_options, NULL, bits_3dm_sbas_options, 3, 2};

static const char name_3dm_assisted_fix_option[] = "3dm.assisted_fix_option";
static const char labels_3dm_assisted_fix_option[] = "none\0enabled";
static const uint8_t numbers_3dm_assisted_fix_option[] = {0, 1};
const struct mip_names mip_names_3dm_assisted_fix_option = {name_3dm_assisted_fix_option,
                                                            labels_3dm_assisted_fix_option,
                                                            numbers_3dm_assisted_fix_option,
                                                            NULL,
                                                            2,
                                                            1};

static const char name_3dm_pps_source[] = "3dm.pps_source";
static const char labels_3dm_pps_source[] = "disabled\0receiver_1\0receiver_2\0gpio\0generated";
static const uint8_t numbers_3dm_pps_source[] = {0, 1, 2, 3, 4};
const struct mip_names mip_names_3dm_pps_source = {
    name_3dm_pps_source, labels_3dm_pps_source, numbers_3dm_pps_source, NULL, 5, 1};

static const char name_3dm_event_support_query[] = "3dm.event_support_query";
static const char labels_3dm_event_support_query[] = "trigger_types\0action_types";
static const uint8_t numbers_3dm_event_support_query[] = {1, 2};
const struct mip_names mip_names_3dm_event_support_query = {name_3dm_event_support_query,
                                                            labels_3dm_event_support_query,
                                                            numbers_3dm_event_support_query,
                                                            NULL,
                                                            2,
                                                            1};

static const char name_3dm_receiver_dynamics[] = "3dm.receiver_dynamics";
static const char labels_3dm_receiver_dynamics[] =
    "portable\0fixed\0stationary\0pedestrian\0automotive\0sea\0airborne_1g\0airborne_2g\0airborne_"
    "4g";
static const uint8_t numbers_3dm_receiver_dynamics[] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
const struct mip_names mip_names_3dm_receiver_dynamics = {name_3dm_receiver_dynamics,
                                                          labels_3dm_receiver_dynamics,
                                                          numbers_3dm_receiver_dynamics,
                                                          NULL,
                                                          9,
                                                          1};

static const char name_3dm_data_conditioning_flags[] = "3dm.data_conditioning_flags";
static const char labels_3dm_data_conditioning_flags[] =
    "orientation_calculation\0coning_sculling\0little_endian_floats\0nan_suppressed\0finite_size_"
    "correction\0disable_mag\0mag_low_power\0disable_north_compensation\0disable_up_"
    "compensation\0quaternion_calculation";
static const struct mip_named_bits bits_3dm_data_conditioning_flags[] = {
    {0, 1, 0, NULL}, {1, 1, 0, NULL}, {4, 1, 0, NULL},  {5, 1, 0, NULL},  {6, 1, 0, NULL},
    {8, 1, 0, NULL}, {9, 1, 0, NULL}, {10, 1, 0, NULL}, {11, 1, 0, NULL}, {12, 1, 0, NULL},
};
const struct mip_names mip_names_3dm_data_conditioning_flags = {name_3dm_data_conditioning_flags,
                                                                labels_3dm_data_conditioning_flags,
                                                                NULL,
                                                                bits_3dm_data_conditioning_flags,
                                                                10,
                                                                2};

static const char name_3dm_mag_bandwidth[] = "3dm.mag_bandwidth";
static const char labels_3dm_mag_bandwidth[] = "high\0low";
static const uint8_t numbers_3dm_mag_bandwidth[] = {0, 1};
const struct mip_names mip_names_3dm_mag_bandwidth = {
    name_3dm_mag_bandwidth, labels_3dm_mag_bandwidth, numbers_3dm_mag_bandwidth, NULL, 2, 1};

static const char name_3dm_imu_timestamp_selector[] = "3dm.imu_timestamp_selector";
static const char labels_3dm_imu_timestamp_selector[] =
    "beacon_seconds\0beacon_nanoseconds\0internal_ticks";
static const uint8_t numbers_3dm_imu_timestamp_selector[] = {1, 2, 3};
const struct mip_names mip_names_3dm_imu_timestamp_selector = {name_3dm_imu_timestamp_selector,
                                                               labels_3dm_imu_timestamp_selector,
                                                               numbers_3dm_imu_timestamp_selector,
                                                               NULL,
                                                               3,
                                                               1};

static const char name_3dm_odometer_mode[] = "3dm.odometer_mode";
static const char labels_3dm_odometer_mode[] = "disabled\0quadrature";
static const uint8_t numbers_3dm_odometer_mode[] = {0, 2};
const struct mip_names mip_names_3dm_odometer_mode = {
    name_3dm_odometer_mode, labels_3dm_odometer_mode, numbers_3dm_odometer_mode, NULL, 2, 1};

static const char name_3dm_sensor_range_type[] = "3dm.sensor_range_type";
static const char labels_3dm_sensor_range_type[] = "all\0accel\0gyro\0mag\0pressure";
static const uint8_t numbers_3dm_sensor_range_type[] = {0, 1, 2, 3, 4};
const struct mip_names mip_names_3dm_sensor_range_type = {name_3dm_sensor_range_type,
                                                          labels_3dm_sensor_range_type,
                                                          numbers_3dm_sensor_range_type,
                                                          NULL,
                                                          5,
                                                          1};

static const char name_3dm_internal_sensor[] = "3dm.internal_sensor";
static const char labels_3dm_internal_sensor[] = "imu\0gnss";
static const uint8_t numbers_3dm_internal_sensor[] = {1, 2};
const struct mip_names mip_names_3dm_internal_sensor = {
    name_3dm_internal_sensor, labels_3dm_internal_sensor, numbers_3dm_internal_sensor, NULL, 2, 1};

static const char name_3dm_stream_format[] = "3dm.stream_format";
static const char labels_3dm_stream_format[] = "standard\0wrapped_raw";
static const uint8_t numbers_3dm_stream_format[] = {1, 2};
const struct mip_names mip_names_3dm_stream_format = {
    name_3dm_stream_format, labels_3dm_stream_format, numbers_3dm_stream_format, NULL, 2, 1};

static const char name_3dm_sensor_power_state[] = "3dm.sensor_power_state";
static const char labels_3dm_sensor_power_state[] = "on\0low_power\0sleep\0off";
static const uint8_t numbers_3dm_sensor_power_state[] = {1, 2, 3, 4};
const struct mip_names mip_names_3dm_sensor_power_state = {name_3dm_sensor_power_state,
                                                           labels_3dm_sensor_power_state,
                                                           numbers_3dm_sensor_power_state,
                                                           NULL,
                                                           4,
                                                           1};

static const char name_3dm_device_status_selector[] = "3dm.device_status_selector";
static const char labels_3dm_device_status_selector[] = "basic\0diagnostic";
static const uint8_t numbers_3dm_device_status_selector[] = {1, 2};
const struct mip_names mip_names_3dm_device_status_selector = {name_3dm_device_status_selector,
                                                               labels_3dm_device_status_selector,
                                                               numbers_3dm_device_status_selector,
                                                               NULL,
                                                               2,
                                                               1};

static const char name_3dm_legacy_data_stream[] = "3dm.legacy_data_stream";
static const char labels_3dm_legacy_data_stream[] = "all_streams\0imu\0gnss\0filter";
static const uint8_t numbers_3dm_legacy_data_stream[] = {0, 1, 2, 3};
const struct mip_names mip_names_3dm_legacy_data_stream = {name_3dm_legacy_data_stream,
                                                           labels_3dm_legacy_data_stream,
                                                           numbers_3dm_legacy_data_stream,
                                                           NULL,
                                                           4,
                                                           1};

static const char name_3dm_gx4_system_state[] = "3dm.gx4_system_state";
static const char labels_3dm_gx4_system_state[] = "init\0sensor_startup\0running";
static const uint16_t numbers_3dm_gx4_system_state[] = {1, 2, 3};
const struct mip_names mip_names_3dm_gx4_system_state = {name_3dm_gx4_system_state,
                                                         labels_3dm_gx4_system_state,
                                                         numbers_3dm_gx4_system_state,
                                                         NULL,
                                                         3,
                                                         2};

static const char name_filter_dynamics_mode[] = "filter.dynamics_mode";
static const char labels_filter_dynamics_mode[] = "portable\0automotive\0airborne\0airborne_high_g";
static const uint8_t numbers_filter_dynamics_mode[] = {1, 2, 3, 4};
const struct mip_names mip_names_filter_dynamics_mode = {name_filter_dynamics_mode,
                                                         labels_filter_dynamics_mode,
                                                         numbers_filter_dynamics_mode,
                                                         NULL,
                                                         4,
                                                         1};

static const char name_filter_estimated_states[] = "filter.estimated_states";
static const char labels_filter_estimated_states[] =
    "gyro_bias\0accel_bias\0gyro_scale_factor\0accel_scale_factor\0antenna_offset\0auto_hard_"
    "iron\0auto_soft_iron";
static const struct mip_named_bits bits_filter_estimated_states[] = {
    {0, 1, 0, NULL}, {1, 1, 0, NULL}, {2, 1, 0, NULL}, {3, 1, 0, NULL},
    {4, 1, 0, NULL}, {5, 1, 0, NULL}, {6, 1, 0, NULL},
};
const struct mip_names mip_names_filter_estimated_states = {name_filter_estimated_states,
                                                            labels_filter_estimated_states,
                                                            NULL,
                                                            bits_filter_estimated_states,
                                                            7,
                                                            2};

static const char name_filter_gnss_aiding_source[] = "filter.gnss_aiding_source";
static const char labels_filter_gnss_aiding_source[] =
    "all_internal\0external\0internal_1\0internal_2";
static const uint8_t numbers_filter_gnss_aiding_source[] = {1, 2, 3, 4};
const struct mip_names mip_names_filter_gnss_aiding_source = {name_filter_gnss_aiding_source,
                                                              labels_filter_gnss_aiding_source,
                                                              numbers_filter_gnss_aiding_source,
                                                              NULL,
                                                              4,
                                                              1};

static const char name_filter_heading_type[] = "filter.heading_type";
static const char labels_filter_heading_type[] = "true_heading\0magnetic_heading";
static const uint8_t numbers_filter_heading_type[] = {1, 2};
const struct mip_names mip_names_filter_heading_type = {
    name_filter_heading_type, labels_filter_heading_type, numbers_filter_heading_type, NULL, 2, 1};

static const char name_filter_heading_update_source[] = "filter.heading_update_source";
static const char labels_filter_heading_update_source[] =
    "none\0mag\0gnss_velocity\0external\0gnss_velocity_and_mag\0gnss_velocity_and_external\0mag_"
    "and_external\0all";
static const uint8_t numbers_filter_heading_update_source[] = {0, 1, 2, 3, 4, 5, 6, 7};
const struct mip_names mip_names_filter_heading_update_source = {
    name_filter_heading_update_source,
    labels_filter_heading_update_source,
    numbers_filter_heading_update_source,
    NULL,
    8,
    1};

static const char name_filter_tare_axes[] = "filter.tare_axes";
static const char labels_filter_tare_axes[] = "roll\0pitch\0yaw";
static const struct mip_named_bits bits_filter_tare_axes[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
    {2, 1, 0, NULL},
};
const struct mip_names mip_names_filter_tare_axes = {
    name_filter_tare_axes, labels_filter_tare_axes, NULL, bits_filter_tare_axes, 3, 1};

static const char name_filter_measurement_flags[] = "filter.measurement_flags";
static const char labels_filter_measurement_flags[] = "accel\0mag";
static const struct mip_named_bits bits_filter_measurement_flags[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
};
const struct mip_names mip_names_filter_measurement_flags = {name_filter_measurement_flags,
                                                             labels_filter_measurement_flags,
                                                             NULL,
                                                             bits_filter_measurement_flags,
                                                             2,
                                                             2};

static const char name_filter_mag_parameter_source[] = "filter.mag_parameter_source";
static const char labels_filter_mag_parameter_source[] = "none\0wmm\0manual";
static const uint8_t numbers_filter_mag_parameter_source[] = {1, 2, 3};
const struct mip_names mip_names_filter_mag_parameter_source = {name_filter_mag_parameter_source,
                                                                labels_filter_mag_parameter_source,
                                                                numbers_filter_mag_parameter_source,
                                                                NULL,
                                                                3,
                                                                1};

static const char name_filter_adaptive_measurement_selector[] =
    "filter.adaptive_measurement_selector";
static const char labels_filter_adaptive_measurement_selector[] = "disabled\0fixed\0auto";
static const uint8_t numbers_filter_adaptive_measurement_selector[] = {0, 1, 2};
const struct mip_names mip_names_filter_adaptive_measurement_selector = {
    name_filter_adaptive_measurement_selector,
    labels_filter_adaptive_measurement_selector,
    numbers_filter_adaptive_measurement_selector,
    NULL,
    3,
    1};

static const char name_filter_altitude_aiding_source[] = "filter.altitude_aiding_source";
static const char labels_filter_altitude_aiding_source[] = "none\0pressure";
static const uint8_t numbers_filter_altitude_aiding_source[] = {0, 1};
const struct mip_names mip_names_filter_altitude_aiding_source = {
    name_filter_altitude_aiding_source,
    labels_filter_altitude_aiding_source,
    numbers_filter_altitude_aiding_source,
    NULL,
    2,
    1};

static const char name_filter_pitch_roll_aiding_source[] = "filter.pitch_roll_aiding_source";
static const char labels_filter_pitch_roll_aiding_source[] = "none\0gravity_vector";
static const uint8_t numbers_filter_pitch_roll_aiding_source[] = {0, 1};
const struct mip_names mip_names_filter_pitch_roll_aiding_source = {
    name_filter_pitch_roll_aiding_source,
    labels_filter_pitch_roll_aiding_source,
    numbers_filter_pitch_roll_aiding_source,
    NULL,
    2,
    1};

static const char name_filter_aiding_source[] = "filter.aiding_source";
static const char labels_filter_aiding_source[] =
    "gnss_position_velocity\0gnss_heading\0altimeter\0speed\0mag\0external_heading\0external_"
    "altimeter\0external_mag\0body_frame_velocity\0all";
static const uint16_t numbers_filter_aiding_source[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 0xFFFF};
const struct mip_names mip_names_filter_aiding_source = {name_filter_aiding_source,
                                                         labels_filter_aiding_source,
                                                         numbers_filter_aiding_source,
                                                         NULL,
                                                         10,
                                                         2};

static const char name_filter_accel_constraint[] = "filter.accel_constraint";
static const char labels_filter_accel_constraint[] = "none\0zero_accel";
static const uint8_t numbers_filter_accel_constraint[] = {0, 1};
const struct mip_names mip_names_filter_accel_constraint = {name_filter_accel_constraint,
                                                            labels_filter_accel_constraint,
                                                            numbers_filter_accel_constraint,
                                                            NULL,
                                                            2,
                                                            1};

static const char name_filter_velocity_constraint[] = "filter.velocity_constraint";
static const char labels_filter_velocity_constraint[] = "none\0zero_velocity\0wheeled_vehicle";
static const uint8_t numbers_filter_velocity_constraint[] = {0, 1, 2};
const struct mip_names mip_names_filter_velocity_constraint = {name_filter_velocity_constraint,
                                                               labels_filter_velocity_constraint,
                                                               numbers_filter_velocity_constraint,
                                                               NULL,
                                                               3,
                                                               1};

static const char name_filter_angular_constraint[] = "filter.angular_constraint";
static const char labels_filter_angular_constraint[] = "none\0zero_angular_rate";
static const uint8_t numbers_filter_angular_constraint[] = {0, 1};
const struct mip_names mip_names_filter_angular_constraint = {name_filter_angular_constraint,
                                                              labels_filter_angular_constraint,
                                                              numbers_filter_angular_constraint,
                                                              NULL,
                                                              2,
                                                              1};

static const char name_filter_initial_condition_source[] = "filter.initial_condition_source";
static const char labels_filter_initial_condition_source[] =
    "auto_position_velocity_attitude\0auto_position_velocity_pitch_roll\0auto_position_"
    "velocity\0manual";
static const uint8_t numbers_filter_initial_condition_source[] = {0, 1, 2, 3};
const struct mip_names mip_names_filter_initial_condition_source = {
    name_filter_initial_condition_source,
    labels_filter_initial_condition_source,
    numbers_filter_initial_condition_source,
    NULL,
    4,
    1};

static const char name_filter_heading_alignment[] = "filter.heading_alignment";
static const char labels_filter_heading_alignment[] = "dual_antenna\0kinematic\0mag\0external";
static const struct mip_named_bits bits_filter_heading_alignment[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
    {2, 1, 0, NULL},
    {3, 1, 0, NULL},
};
const struct mip_names mip_names_filter_heading_alignment = {name_filter_heading_alignment,
                                                             labels_filter_heading_alignment,
                                                             NULL,
                                                             bits_filter_heading_alignment,
                                                             4,
                                                             1};

static const char name_filter_reference_frame[] = "filter.reference_frame";
static const char labels_filter_reference_frame[] = "ecef\0llh";
static const uint8_t numbers_filter_reference_frame[] = {1, 2};
const struct mip_names mip_names_filter_reference_frame = {name_filter_reference_frame,
                                                           labels_filter_reference_frame,
                                                           numbers_filter_reference_frame,
                                                           NULL,
                                                           2,
                                                           1};

static const char name_filter_adaptive_level[] = "filter.adaptive_level";
static const char labels_filter_adaptive_level[] = "off\0conservative\0moderate\0aggressive";
static const uint8_t numbers_filter_adaptive_level[] = {0, 1, 2, 3};
const struct mip_names mip_names_filter_adaptive_level = {name_filter_adaptive_level,
                                                          labels_filter_adaptive_level,
                                                          numbers_filter_adaptive_level,
                                                          NULL,
                                                          4,
                                                          1};

static const char name_filter_relative_position_source[] = "filter.relative_position_source";
static const char labels_filter_relative_position_source[] = "auto\0manual";
static const uint8_t numbers_filter_relative_position_source[] = {0, 1};
const struct mip_names mip_names_filter_relative_position_source = {
    name_filter_relative_position_source,
    labels_filter_relative_position_source,
    numbers_filter_relative_position_source,
    NULL,
    2,
    1};

static const char name_filter_reference_point[] = "filter.reference_point";
static const char labels_filter_reference_point[] = "vehicle";
static const uint8_t numbers_filter_reference_point[] = {1};
const struct mip_names mip_names_filter_reference_point = {name_filter_reference_point,
                                                           labels_filter_reference_point,
                                                           numbers_filter_reference_point,
                                                           NULL,
                                                           1,
                                                           1};

static const char name_gnss_gps_signals[] = "gnss.gps_signals";
static const char labels_gnss_gps_signals[] = "l1ca\0l2c\0l5";
static const struct mip_named_bits bits_gnss_gps_signals[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
    {2, 1, 0, NULL},
};
const struct mip_names mip_names_gnss_gps_signals = {
    name_gnss_gps_signals, labels_gnss_gps_signals, NULL, bits_gnss_gps_signals, 3, 1};

static const char name_gnss_glonass_signals[] = "gnss.glonass_signals";
static const char labels_gnss_glonass_signals[] = "l1of\0l2of";
static const struct mip_named_bits bits_gnss_glonass_signals[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
};
const struct mip_names mip_names_gnss_glonass_signals = {
    name_gnss_glonass_signals, labels_gnss_glonass_signals, NULL, bits_gnss_glonass_signals, 2, 1};

static const char name_gnss_galileo_signals[] = "gnss.galileo_signals";
static const char labels_gnss_galileo_signals[] = "e1\0e5b\0e5a";
static const struct mip_named_bits bits_gnss_galileo_signals[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
    {2, 1, 0, NULL},
};
const struct mip_names mip_names_gnss_galileo_signals = {
    name_gnss_galileo_signals, labels_gnss_galileo_signals, NULL, bits_gnss_galileo_signals, 3, 1};

static const char name_gnss_beidou_signals[] = "gnss.beidou_signals";
static const char labels_gnss_beidou_signals[] = "b1\0b2\0b2a";
static const struct mip_named_bits bits_gnss_beidou_signals[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
    {2, 1, 0, NULL},
};
const struct mip_names mip_names_gnss_beidou_signals = {
    name_gnss_beidou_signals, labels_gnss_beidou_signals, NULL, bits_gnss_beidou_signals, 3, 1};

static const char name_gnss_receiver_id[] = "gnss.receiver_id";
static const char labels_gnss_receiver_id[] =
    "all\0internal_receiver_1\0internal_receiver_2\0user_receiver_1\0user_receiver_2";
static const uint8_t numbers_gnss_receiver_id[] = {0, 1, 2, 4, 5};
const struct mip_names mip_names_gnss_receiver_id = {
    name_gnss_receiver_id, labels_gnss_receiver_id, numbers_gnss_receiver_id, NULL, 5, 1};

static const char name_gnss_receiver_reset_type[] = "gnss.receiver_reset_type";
static const char labels_gnss_receiver_reset_type[] = "hardware\0cold\0warm\0hot";
static const uint8_t numbers_gnss_receiver_reset_type[] = {1, 2, 3, 4};
const struct mip_names mip_names_gnss_receiver_reset_type = {name_gnss_receiver_reset_type,
                                                             labels_gnss_receiver_reset_type,
                                                             numbers_gnss_receiver_reset_type,
                                                             NULL,
                                                             4,
                                                             1};

static const char name_gnss_ambiguity_fix_mode[] = "gnss.ambiguity_fix_mode";
static const char labels_gnss_ambiguity_fix_mode[] = "off\0conservative\0moderate\0aggressive";
static const uint8_t numbers_gnss_ambiguity_fix_mode[] = {1, 2, 3, 4};
const struct mip_names mip_names_gnss_ambiguity_fix_mode = {name_gnss_ambiguity_fix_mode,
                                                            labels_gnss_ambiguity_fix_mode,
                                                            numbers_gnss_ambiguity_fix_mode,
                                                            NULL,
                                                            4,
                                                            1};

static const char name_gnss_spartn_connection[] = "gnss.spartn_connection";
static const char labels_gnss_spartn_connection[] = "none\0network\0l_band";
static const uint8_t numbers_gnss_spartn_connection[] = {0, 1, 2};
const struct mip_names mip_names_gnss_spartn_connection = {name_gnss_spartn_connection,
                                                           labels_gnss_spartn_connection,
                                                           numbers_gnss_spartn_connection,
                                                           NULL,
                                                           3,
                                                           1};

static const char name_rtk_connected_device[] = "rtk.connected_device";
static const char labels_rtk_connected_device[] = "generic\0gq7";
static const uint8_t numbers_rtk_connected_device[] = {0, 1};
const struct mip_names mip_names_rtk_connected_device = {name_rtk_connected_device,
                                                         labels_rtk_connected_device,
                                                         numbers_rtk_connected_device,
                                                         NULL,
                                                         2,
                                                         1};

static const char name_rtk_service_flags[] = "rtk.service_flags";
static const char labels_rtk_service_flags[] = "throttle\0corrections_unavailable";
static const struct mip_named_bits bits_rtk_service_flags[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
};
const struct mip_names mip_names_rtk_service_flags = {
    name_rtk_service_flags, labels_rtk_service_flags, NULL, bits_rtk_service_flags, 2, 1};

static const char name_rtk_storage_medium[] = "rtk.storage_medium";
static const char labels_rtk_storage_medium[] = "external_flash\0sd";
static const uint8_t numbers_rtk_storage_medium[] = {0, 1};
const struct mip_names mip_names_rtk_storage_medium = {
    name_rtk_storage_medium, labels_rtk_storage_medium, numbers_rtk_storage_medium, NULL, 2, 1};

static const char name_rtk_led_action[] = "rtk.led_action";
static const char labels_rtk_led_action[] = "none\0flash\0pulsate";
static const uint8_t numbers_rtk_led_action[] = {0, 1, 2};
const struct mip_names mip_names_rtk_led_action = {
    name_rtk_led_action, labels_rtk_led_action, numbers_rtk_led_action, NULL, 3, 1};

static const char name_aiding_frame_format[] = "aiding.aiding_frame_format";
static const char labels_aiding_frame_format[] = "euler\0quaternion";
static const uint8_t numbers_aiding_frame_format[] = {1, 2};
const struct mip_names mip_names_aiding_frame_format = {
    name_aiding_frame_format, labels_aiding_frame_format, numbers_aiding_frame_format, NULL, 2, 1};

static const char name_aiding_echo_mode[] = "aiding.aiding_echo_mode";
static const char labels_aiding_echo_mode[] = "suppress_ack\0standard\0response";
static const uint8_t numbers_aiding_echo_mode[] = {0, 1, 2};
const struct mip_names mip_names_aiding_echo_mode = {
    name_aiding_echo_mode, labels_aiding_echo_mode, numbers_aiding_echo_mode, NULL, 3, 1};

static const char name_aiding_timebase[] = "aiding.timebase";
static const char labels_aiding_timebase[] = "internal_reference\0external_time\0time_of_arrival";
static const uint8_t numbers_aiding_timebase[] = {1, 2, 3};
const struct mip_names mip_names_aiding_timebase = {
    name_aiding_timebase, labels_aiding_timebase, numbers_aiding_timebase, NULL, 3, 1};

static const char name_aiding_axis_flags[] = "aiding.axis_flags";
static const char labels_aiding_axis_flags[] = "x\0y\0z";
static const struct mip_named_bits bits_aiding_axis_flags[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
    {2, 1, 0, NULL},
};
const struct mip_names mip_names_aiding_axis_flags = {
    name_aiding_axis_flags, labels_aiding_axis_flags, NULL, bits_aiding_axis_flags, 3, 2};

static const char name_aiding_llh_axis_flags[] = "aiding.llh_axis_flags";
static const char labels_aiding_llh_axis_flags[] = "latitude\0longitude\0height";
static const struct mip_named_bits bits_aiding_llh_axis_flags[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
    {2, 1, 0, NULL},
};
const struct mip_names mip_names_aiding_llh_axis_flags = {name_aiding_llh_axis_flags,
                                                          labels_aiding_llh_axis_flags,
                                                          NULL,
                                                          bits_aiding_llh_axis_flags,
                                                          3,
                                                          2};

static const char name_system_comm_protocols[] = "system.comm_protocols";
static const char labels_system_comm_protocols[] = "mip\0nmea\0rtcm\0spartn\0sbf";
static const struct mip_named_bits bits_system_comm_protocols[] = {
    {0, 1, 0, NULL}, {8, 1, 0, NULL}, {9, 1, 0, NULL}, {24, 1, 0, NULL}, {29, 1, 0, NULL},
};
const struct mip_names mip_names_system_comm_protocols = {name_system_comm_protocols,
                                                          labels_system_comm_protocols,
                                                          NULL,
                                                          bits_system_comm_protocols,
                                                          5,
                                                          4};

static const char name_system_protocol_mode[] = "system.protocol_mode";
static const char labels_system_protocol_mode[] = "standard\0sensor_direct\0gnss_direct";
static const uint8_t numbers_system_protocol_mode[] = {1, 2, 3};
const struct mip_names mip_names_system_protocol_mode = {name_system_protocol_mode,
                                                         labels_system_protocol_mode,
                                                         numbers_system_protocol_mode,
                                                         NULL,
                                                         3,
                                                         1};

static const char name_sensor_overrange_flags[] = "sensor.overrange_flags";
static const char labels_sensor_overrange_flags[] =
    "accel_x\0accel_y\0accel_z\0gyro_x\0gyro_y\0gyro_z\0mag_x\0mag_y\0mag_z\0pressure";
static const struct mip_named_bits bits_sensor_overrange_flags[] = {
    {0, 1, 0, NULL}, {1, 1, 0, NULL}, {2, 1, 0, NULL}, {4, 1, 0, NULL},  {5, 1, 0, NULL},
    {6, 1, 0, NULL}, {8, 1, 0, NULL}, {9, 1, 0, NULL}, {10, 1, 0, NULL}, {12, 1, 0, NULL},
};
const struct mip_names mip_names_sensor_overrange_flags = {name_sensor_overrange_flags,
                                                           labels_sensor_overrange_flags,
                                                           NULL,
                                                           bits_sensor_overrange_flags,
                                                           10,
                                                           2};

static const char name_sensor_odometer_flags[] = "sensor.odometer_flags";
static const char labels_sensor_odometer_flags[] = "odometer";
static const struct mip_named_bits bits_sensor_odometer_flags[] = {
    {0, 1, 0, NULL},
};
const struct mip_names mip_names_sensor_odometer_flags = {name_sensor_odometer_flags,
                                                          labels_sensor_odometer_flags,
                                                          NULL,
                                                          bits_sensor_odometer_flags,
                                                          1,
                                                          2};

static const char name_gnss_data_llh_position_flags[] = "gnss_data.llh_position_flags";
static const char labels_gnss_data_llh_position_flags[] =
    "lat_lon\0ellipsoid_height\0msl_height\0horizontal_accuracy\0vertical_accuracy\0flags";
static const struct mip_named_bits bits_gnss_data_llh_position_flags[] = {
    {0, 1, 0, NULL}, {1, 1, 0, NULL}, {2, 1, 0, NULL},
    {3, 1, 0, NULL}, {4, 1, 0, NULL}, {0, 5, 0, NULL},
};
const struct mip_names mip_names_gnss_data_llh_position_flags = {
    name_gnss_data_llh_position_flags,
    labels_gnss_data_llh_position_flags,
    NULL,
    bits_gnss_data_llh_position_flags,
    6,
    2};

static const char name_gnss_data_ecef_position_flags[] = "gnss_data.ecef_position_flags";
static const char labels_gnss_data_ecef_position_flags[] = "position\0position_accuracy\0flags";
static const struct mip_named_bits bits_gnss_data_ecef_position_flags[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
    {0, 2, 0, NULL},
};
const struct mip_names mip_names_gnss_data_ecef_position_flags = {
    name_gnss_data_ecef_position_flags,
    labels_gnss_data_ecef_position_flags,
    NULL,
    bits_gnss_data_ecef_position_flags,
    3,
    2};

static const char name_gnss_data_ned_velocity_flags[] = "gnss_data.ned_velocity_flags";
static const char labels_gnss_data_ned_velocity_flags[] =
    "velocity\0speed_3d\0ground_speed\0heading\0speed_accuracy\0heading_accuracy\0flags";
static const struct mip_named_bits bits_gnss_data_ned_velocity_flags[] = {
    {0, 1, 0, NULL}, {1, 1, 0, NULL}, {2, 1, 0, NULL}, {3, 1, 0, NULL},
    {4, 1, 0, NULL}, {5, 1, 0, NULL}, {0, 6, 0, NULL},
};
const struct mip_names mip_names_gnss_data_ned_velocity_flags = {
    name_gnss_data_ned_velocity_flags,
    labels_gnss_data_ned_velocity_flags,
    NULL,
    bits_gnss_data_ned_velocity_flags,
    7,
    2};

static const char name_gnss_data_ecef_velocity_flags[] = "gnss_data.ecef_velocity_flags";
static const char labels_gnss_data_ecef_velocity_flags[] = "velocity\0velocity_accuracy\0flags";
static const struct mip_named_bits bits_gnss_data_ecef_velocity_flags[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
    {0, 2, 0, NULL},
};
const struct mip_names mip_names_gnss_data_ecef_velocity_flags = {
    name_gnss_data_ecef_velocity_flags,
    labels_gnss_data_ecef_velocity_flags,
    NULL,
    bits_gnss_data_ecef_velocity_flags,
    3,
    2};

static const char name_gnss_data_dop_flags[] = "gnss_data.dop_flags";
static const char labels_gnss_data_dop_flags[] = "gdop\0pdop\0hdop\0vdop\0tdop\0ndop\0edop\0flags";
static const struct mip_named_bits bits_gnss_data_dop_flags[] = {
    {0, 1, 0, NULL}, {1, 1, 0, NULL}, {2, 1, 0, NULL}, {3, 1, 0, NULL},
    {4, 1, 0, NULL}, {5, 1, 0, NULL}, {6, 1, 0, NULL}, {0, 7, 0, NULL},
};
const struct mip_names mip_names_gnss_data_dop_flags = {
    name_gnss_data_dop_flags, labels_gnss_data_dop_flags, NULL, bits_gnss_data_dop_flags, 8, 2};

static const char name_gnss_data_utc_time_flags[] = "gnss_data.utc_time_flags";
static const char labels_gnss_data_utc_time_flags[] = "gnss_date_time\0leap_seconds_known\0flags";
static const struct mip_named_bits bits_gnss_data_utc_time_flags[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
    {0, 2, 0, NULL},
};
const struct mip_names mip_names_gnss_data_utc_time_flags = {name_gnss_data_utc_time_flags,
                                                             labels_gnss_data_utc_time_flags,
                                                             NULL,
                                                             bits_gnss_data_utc_time_flags,
                                                             3,
                                                             2};

static const char name_gnss_data_gps_time_flags[] = "gnss_data.gps_time_flags";
static const char labels_gnss_data_gps_time_flags[] = "tow\0week_number\0flags";
static const struct mip_named_bits bits_gnss_data_gps_time_flags[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
    {0, 2, 0, NULL},
};
const struct mip_names mip_names_gnss_data_gps_time_flags = {name_gnss_data_gps_time_flags,
                                                             labels_gnss_data_gps_time_flags,
                                                             NULL,
                                                             bits_gnss_data_gps_time_flags,
                                                             3,
                                                             2};

static const char name_gnss_data_clock_info_flags[] = "gnss_data.clock_info_flags";
static const char labels_gnss_data_clock_info_flags[] = "bias\0drift\0accuracy_estimate\0flags";
static const struct mip_named_bits bits_gnss_data_clock_info_flags[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
    {2, 1, 0, NULL},
    {0, 3, 0, NULL},
};
const struct mip_names mip_names_gnss_data_clock_info_flags = {name_gnss_data_clock_info_flags,
                                                               labels_gnss_data_clock_info_flags,
                                                               NULL,
                                                               bits_gnss_data_clock_info_flags,
                                                               4,
                                                               2};

static const char name_gnss_data_fix_flags[] = "gnss_data.fix_flags";
static const char labels_gnss_data_fix_flags[] = "sbas_used\0dgnss_used";
static const struct mip_named_bits bits_gnss_data_fix_flags[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
};
const struct mip_names mip_names_gnss_data_fix_flags = {
    name_gnss_data_fix_flags, labels_gnss_data_fix_flags, NULL, bits_gnss_data_fix_flags, 2, 2};

static const char name_gnss_data_fix_info_flags[] = "gnss_data.fix_info_flags";
static const char labels_gnss_data_fix_info_flags[] = "fix_type\0num_sv\0fix_flags\0flags";
static const struct mip_named_bits bits_gnss_data_fix_info_flags[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
    {2, 1, 0, NULL},
    {0, 3, 0, NULL},
};
const struct mip_names mip_names_gnss_data_fix_info_flags = {name_gnss_data_fix_info_flags,
                                                             labels_gnss_data_fix_info_flags,
                                                             NULL,
                                                             bits_gnss_data_fix_info_flags,
                                                             4,
                                                             2};

static const char name_gnss_data_sv_flags[] = "gnss_data.sv_flags";
static const char labels_gnss_data_sv_flags[] = "used_for_navigation\0healthy";
static const struct mip_named_bits bits_gnss_data_sv_flags[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
};
const struct mip_names mip_names_gnss_data_sv_flags = {
    name_gnss_data_sv_flags, labels_gnss_data_sv_flags, NULL, bits_gnss_data_sv_flags, 2, 2};

static const char name_gnss_data_sv_info_flags[] = "gnss_data.sv_info_flags";
static const char labels_gnss_data_sv_info_flags[] =
    "channel\0satellite_id\0carrier_noise_ratio\0azimuth\0elevation\0sv_flags\0flags";
static const struct mip_named_bits bits_gnss_data_sv_info_flags[] = {
    {0, 1, 0, NULL}, {1, 1, 0, NULL}, {2, 1, 0, NULL}, {3, 1, 0, NULL},
    {4, 1, 0, NULL}, {5, 1, 0, NULL}, {0, 6, 0, NULL},
};
const struct mip_names mip_names_gnss_data_sv_info_flags = {name_gnss_data_sv_info_flags,
                                                            labels_gnss_data_sv_info_flags,
                                                            NULL,
                                                            bits_gnss_data_sv_info_flags,
                                                            7,
                                                            2};

static const char name_gnss_data_receiver_state[] = "gnss_data.receiver_state";
static const char labels_gnss_data_receiver_state[] = "off\0on\0unknown";
static const uint8_t numbers_gnss_data_receiver_state[] = {0, 1, 2};
const struct mip_names mip_names_gnss_data_receiver_state = {name_gnss_data_receiver_state,
                                                             labels_gnss_data_receiver_state,
                                                             numbers_gnss_data_receiver_state,
                                                             NULL,
                                                             3,
                                                             1};

static const char name_gnss_data_antenna_state[] = "gnss_data.antenna_state";
static const char labels_gnss_data_antenna_state[] = "init\0short\0open\0good\0unknown";
static const uint8_t numbers_gnss_data_antenna_state[] = {1, 2, 3, 4, 5};
const struct mip_names mip_names_gnss_data_antenna_state = {name_gnss_data_antenna_state,
                                                            labels_gnss_data_antenna_state,
                                                            numbers_gnss_data_antenna_state,
                                                            NULL,
                                                            5,
                                                            1};

static const char name_gnss_data_antenna_power[] = "gnss_data.antenna_power";
static const char labels_gnss_data_antenna_power[] = "off\0on\0unknown";
static const uint8_t numbers_gnss_data_antenna_power[] = {0, 1, 2};
const struct mip_names mip_names_gnss_data_antenna_power = {name_gnss_data_antenna_power,
                                                            labels_gnss_data_antenna_power,
                                                            numbers_gnss_data_antenna_power,
                                                            NULL,
                                                            3,
                                                            1};

static const char name_gnss_data_hardware_status_flags[] = "gnss_data.hardware_status_flags";
static const char labels_gnss_data_hardware_status_flags[] =
    "sensor_state\0antenna_state\0antenna_power\0flags";
static const struct mip_named_bits bits_gnss_data_hardware_status_flags[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
    {2, 1, 0, NULL},
    {0, 3, 0, NULL},
};
const struct mip_names mip_names_gnss_data_hardware_status_flags = {
    name_gnss_data_hardware_status_flags,
    labels_gnss_data_hardware_status_flags,
    NULL,
    bits_gnss_data_hardware_status_flags,
    4,
    2};

static const char name_gnss_data_dgps_info_flags[] = "gnss_data.dgps_info_flags";
static const char labels_gnss_data_dgps_info_flags[] =
    "age\0base_station_id\0base_station_status\0num_channels\0flags";
static const struct mip_named_bits bits_gnss_data_dgps_info_flags[] = {
    {0, 1, 0, NULL}, {1, 1, 0, NULL}, {2, 1, 0, NULL}, {3, 1, 0, NULL}, {0, 4, 0, NULL},
};
const struct mip_names mip_names_gnss_data_dgps_info_flags = {name_gnss_data_dgps_info_flags,
                                                              labels_gnss_data_dgps_info_flags,
                                                              NULL,
                                                              bits_gnss_data_dgps_info_flags,
                                                              5,
                                                              2};

static const char name_gnss_data_dgps_channel_flags[] = "gnss_data.dgps_channel_flags";
static const char labels_gnss_data_dgps_channel_flags[] =
    "satellite_id\0age\0range_correction\0range_rate_correction\0flags";
static const struct mip_named_bits bits_gnss_data_dgps_channel_flags[] = {
    {0, 1, 0, NULL}, {1, 1, 0, NULL}, {2, 1, 0, NULL}, {3, 1, 0, NULL}, {0, 4, 0, NULL},
};
const struct mip_names mip_names_gnss_data_dgps_channel_flags = {
    name_gnss_data_dgps_channel_flags,
    labels_gnss_data_dgps_channel_flags,
    NULL,
    bits_gnss_data_dgps_channel_flags,
    5,
    2};

static const char name_gnss_data_clock_info_2_flags[] = "gnss_data.clock_info_2_flags";
static const char labels_gnss_data_clock_info_2_flags[] =
    "bias\0drift\0bias_accuracy\0drift_accuracy\0flags";
static const struct mip_named_bits bits_gnss_data_clock_info_2_flags[] = {
    {0, 1, 0, NULL}, {1, 1, 0, NULL}, {2, 1, 0, NULL}, {3, 1, 0, NULL}, {0, 4, 0, NULL},
};
const struct mip_names mip_names_gnss_data_clock_info_2_flags = {
    name_gnss_data_clock_info_2_flags,
    labels_gnss_data_clock_info_2_flags,
    NULL,
    bits_gnss_data_clock_info_2_flags,
    5,
    2};

static const char name_gnss_data_gps_leap_seconds_flags[] = "gnss_data.gps_leap_seconds_flags";
static const char labels_gnss_data_gps_leap_seconds_flags[] = "leap_seconds";
static const struct mip_named_bits bits_gnss_data_gps_leap_seconds_flags[] = {
    {1, 1, 0, NULL},
};
const struct mip_names mip_names_gnss_data_gps_leap_seconds_flags = {
    name_gnss_data_gps_leap_seconds_flags,
    labels_gnss_data_gps_leap_seconds_flags,
    NULL,
    bits_gnss_data_gps_leap_seconds_flags,
    1,
    2};

static const char name_gnss_data_sbas_system[] = "gnss_data.sbas_system";
static const char labels_gnss_data_sbas_system[] = "unknown\0waas\0egnos\0msas\0gagan";
static const uint8_t numbers_gnss_data_sbas_system[] = {0, 1, 2, 3, 4};
const struct mip_names mip_names_gnss_data_sbas_system = {name_gnss_data_sbas_system,
                                                          labels_gnss_data_sbas_system,
                                                          numbers_gnss_data_sbas_system,
                                                          NULL,
                                                          5,
                                                          1};

static const char name_gnss_data_sbas_status[] = "gnss_data.sbas_status";
static const char labels_gnss_data_sbas_status[] =
    "range_available\0corrections_available\0integrity_available\0test_mode";
static const struct mip_named_bits bits_gnss_data_sbas_status[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
    {2, 1, 0, NULL},
    {3, 1, 0, NULL},
};
const struct mip_names mip_names_gnss_data_sbas_status = {name_gnss_data_sbas_status,
                                                          labels_gnss_data_sbas_status,
                                                          NULL,
                                                          bits_gnss_data_sbas_status,
                                                          4,
                                                          1};

static const char name_gnss_data_sbas_info_flags[] = "gnss_data.sbas_info_flags";
static const char labels_gnss_data_sbas_info_flags[] =
    "tow\0week_number\0sbas_system\0sbas_id\0count\0sbas_status\0flags";
static const struct mip_named_bits bits_gnss_data_sbas_info_flags[] = {
    {0, 1, 0, NULL}, {1, 1, 0, NULL}, {2, 1, 0, NULL}, {3, 1, 0, NULL},
    {4, 1, 0, NULL}, {5, 1, 0, NULL}, {0, 6, 0, NULL},
};
const struct mip_names mip_names_gnss_data_sbas_info_flags = {name_gnss_data_sbas_info_flags,
                                                              labels_gnss_data_sbas_info_flags,
                                                              NULL,
                                                              bits_gnss_data_sbas_info_flags,
                                                              7,
                                                              2};

static const char name_gnss_data_sbas_correction_flags[] = "gnss_data.sbas_correction_flags";
static const char labels_gnss_data_sbas_correction_flags[] =
    "udrei\0pseudorange_correction\0iono_correction\0flags";
static const struct mip_named_bits bits_gnss_data_sbas_correction_flags[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
    {2, 1, 0, NULL},
    {0, 3, 0, NULL},
};
const struct mip_names mip_names_gnss_data_sbas_correction_flags = {
    name_gnss_data_sbas_correction_flags,
    labels_gnss_data_sbas_correction_flags,
    NULL,
    bits_gnss_data_sbas_correction_flags,
    4,
    2};

static const char name_gnss_data_rf_band[] = "gnss_data.rf_band";
static const char labels_gnss_data_rf_band[] = "unknown\0l1\0l2\0l5";
static const uint8_t numbers_gnss_data_rf_band[] = {0, 1, 2, 5};
const struct mip_names mip_names_gnss_data_rf_band = {
    name_gnss_data_rf_band, labels_gnss_data_rf_band, numbers_gnss_data_rf_band, NULL, 4, 1};

static const char name_gnss_data_jamming_state[] = "gnss_data.jamming_state";
static const char labels_gnss_data_jamming_state[] = "unknown\0none\0partial\0significant";
static const uint8_t numbers_gnss_data_jamming_state[] = {0, 1, 2, 3};
const struct mip_names mip_names_gnss_data_jamming_state = {name_gnss_data_jamming_state,
                                                            labels_gnss_data_jamming_state,
                                                            numbers_gnss_data_jamming_state,
                                                            NULL,
                                                            4,
                                                            1};

static const char name_gnss_data_spoofing_state[] = "gnss_data.spoofing_state";
static const char labels_gnss_data_spoofing_state[] = "unknown\0none\0partial\0significant";
static const uint8_t numbers_gnss_data_spoofing_state[] = {0, 1, 2, 3};
const struct mip_names mip_names_gnss_data_spoofing_state = {name_gnss_data_spoofing_state,
                                                             labels_gnss_data_spoofing_state,
                                                             numbers_gnss_data_spoofing_state,
                                                             NULL,
                                                             4,
                                                             1};

static const char name_gnss_data_rf_error_detection_flags[] = "gnss_data.rf_error_detection_flags";
static const char labels_gnss_data_rf_error_detection_flags[] =
    "rf_band\0jamming_state\0spoofing_state\0frequency\0flags";
static const struct mip_named_bits bits_gnss_data_rf_error_detection_flags[] = {
    {0, 1, 0, NULL}, {1, 1, 0, NULL}, {2, 1, 0, NULL}, {3, 1, 0, NULL}, {0, 4, 0, NULL},
};
const struct mip_names mip_names_gnss_data_rf_error_detection_flags = {
    name_gnss_data_rf_error_detection_flags,
    labels_gnss_data_rf_error_detection_flags,
    NULL,
    bits_gnss_data_rf_error_detection_flags,
    5,
    2};

static const char name_gnss_data_heading_fix_type[] = "gnss_data.heading_fix_type";
static const char labels_gnss_data_heading_fix_type[] = "unknown\0float\0fixed";
static const uint8_t numbers_gnss_data_heading_fix_type[] = {0, 1, 2};
const struct mip_names mip_names_gnss_data_heading_fix_type = {name_gnss_data_heading_fix_type,
                                                               labels_gnss_data_heading_fix_type,
                                                               numbers_gnss_data_heading_fix_type,
                                                               NULL,
                                                               3,
                                                               1};

static const char name_gnss_data_heading_flags[] = "gnss_data.heading_flags";
static const char labels_gnss_data_heading_flags[] = "heading\0uncertainty\0fix_type\0flags";
static const struct mip_named_bits bits_gnss_data_heading_flags[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
    {2, 1, 0, NULL},
    {0, 3, 0, NULL},
};
const struct mip_names mip_names_gnss_data_heading_flags = {name_gnss_data_heading_flags,
                                                            labels_gnss_data_heading_flags,
                                                            NULL,
                                                            bits_gnss_data_heading_flags,
                                                            4,
                                                            2};

static const char name_gnss_data_satellite_status_flags[] = "gnss_data.satellite_status_flags";
static const char labels_gnss_data_satellite_status_flags[] =
    "tow\0week_number\0gnss_id\0satellite_id\0elevation\0azimuth\0health\0flags";
static const struct mip_named_bits bits_gnss_data_satellite_status_flags[] = {
    {0, 1, 0, NULL}, {1, 1, 0, NULL}, {2, 1, 0, NULL}, {3, 1, 0, NULL},
    {4, 1, 0, NULL}, {5, 1, 0, NULL}, {6, 1, 0, NULL}, {0, 7, 0, NULL},
};
const struct mip_names mip_names_gnss_data_satellite_status_flags = {
    name_gnss_data_satellite_status_flags,
    labels_gnss_data_satellite_status_flags,
    NULL,
    bits_gnss_data_satellite_status_flags,
    8,
    2};

static const char name_gnss_data_signal_quality[] = "gnss_data.signal_quality";
static const char labels_gnss_data_signal_quality[] =
    "none\0searching\0acquired\0unusable\0time_locked\0fully_locked";
static const uint8_t numbers_gnss_data_signal_quality[] = {0, 1, 2, 3, 4, 5};
const struct mip_names mip_names_gnss_data_signal_quality = {name_gnss_data_signal_quality,
                                                             labels_gnss_data_signal_quality,
                                                             numbers_gnss_data_signal_quality,
                                                             NULL,
                                                             6,
                                                             1};

static const char name_gnss_data_raw_flags[] = "gnss_data.raw_flags";
static const char labels_gnss_data_raw_flags[] =
    "tow\0week_number\0receiver_id\0tracking_channel\0gnss_id\0satellite_id\0signal_id\0signal_"
    "strength\0quality\0pseudorange\0carrier_phase\0doppler\0range_uncertainty\0carrier_phase_"
    "uncertainty\0doppler_uncertainty\0lock_time\0flags";
static const struct mip_named_bits bits_gnss_data_raw_flags[] = {
    {0, 1, 0, NULL},  {1, 1, 0, NULL},  {2, 1, 0, NULL},  {3, 1, 0, NULL},  {4, 1, 0, NULL},
    {5, 1, 0, NULL},  {6, 1, 0, NULL},  {7, 1, 0, NULL},  {8, 1, 0, NULL},  {9, 1, 0, NULL},
    {10, 1, 0, NULL}, {11, 1, 0, NULL}, {12, 1, 0, NULL}, {13, 1, 0, NULL}, {14, 1, 0, NULL},
    {15, 1, 0, NULL}, {0, 16, 0, NULL},
};
const struct mip_names mip_names_gnss_data_raw_flags = {
    name_gnss_data_raw_flags, labels_gnss_data_raw_flags, NULL, bits_gnss_data_raw_flags, 17, 2};

static const char name_gnss_data_base_station_indicators[] = "gnss_data.base_station_indicators";
static const char labels_gnss_data_base_station_indicators[] =
    "gps\0glonass\0galileo\0beidou\0reference_station\0single_receiver\0quarter_cycle_"
    "bit1\0quarter_cycle_bit2\0quarter_cycle_bits";
static const struct mip_named_bits bits_gnss_data_base_station_indicators[] = {
    {0, 1, 0, NULL}, {1, 1, 0, NULL}, {2, 1, 0, NULL}, {3, 1, 0, NULL}, {4, 1, 0, NULL},
    {5, 1, 0, NULL}, {6, 1, 0, NULL}, {7, 1, 0, NULL}, {6, 2, 0, NULL},
};
const struct mip_names mip_names_gnss_data_base_station_indicators = {
    name_gnss_data_base_station_indicators,
    labels_gnss_data_base_station_indicators,
    NULL,
    bits_gnss_data_base_station_indicators,
    9,
    2};

static const char name_gnss_data_base_station_info_flags[] = "gnss_data.base_station_info_flags";
static const char labels_gnss_data_base_station_info_flags[] =
    "tow\0week_number\0ecef_position\0height\0station_id\0indicators\0flags";
static const struct mip_named_bits bits_gnss_data_base_station_info_flags[] = {
    {0, 1, 0, NULL}, {1, 1, 0, NULL}, {2, 1, 0, NULL}, {3, 1, 0, NULL},
    {4, 1, 0, NULL}, {5, 1, 0, NULL}, {0, 6, 0, NULL},
};
const struct mip_names mip_names_gnss_data_base_station_info_flags = {
    name_gnss_data_base_station_info_flags,
    labels_gnss_data_base_station_info_flags,
    NULL,
    bits_gnss_data_base_station_info_flags,
    7,
    2};

static const char name_gnss_data_rtk_epoch_status[] = "gnss_data.rtk_epoch_status";
static const char labels_gnss_data_rtk_epoch_status[] =
    "antenna_location_received\0antenna_description_received\0gps_received\0glonass_"
    "received\0galileo_received\0beidou_received\0using_gps_msm_messages\0using_glonass_msm_"
    "messages\0dongle_status_read_failed";
static const struct mip_named_bits bits_gnss_data_rtk_epoch_status[] = {
    {0, 1, 0, NULL}, {1, 1, 0, NULL}, {2, 1, 0, NULL}, {3, 1, 0, NULL}, {4, 1, 0, NULL},
    {5, 1, 0, NULL}, {6, 1, 0, NULL}, {7, 1, 0, NULL}, {8, 1, 0, NULL},
};
const struct mip_names mip_names_gnss_data_rtk_epoch_status = {name_gnss_data_rtk_epoch_status,
                                                               labels_gnss_data_rtk_epoch_status,
                                                               NULL,
                                                               bits_gnss_data_rtk_epoch_status,
                                                               9,
                                                               2};

static const char name_gnss_data_rtk_corrections_status_flags[] =
    "gnss_data.rtk_corrections_status_flags";
static const char labels_gnss_data_rtk_corrections_status_flags[] =
    "tow\0week_number\0epoch_status\0dongle_status\0gps_latency\0glonass_latency\0galileo_"
    "latency\0beidou_latency\0flags";
static const struct mip_named_bits bits_gnss_data_rtk_corrections_status_flags[] = {
    {0, 1, 0, NULL}, {1, 1, 0, NULL}, {2, 1, 0, NULL}, {3, 1, 0, NULL}, {4, 1, 0, NULL},
    {5, 1, 0, NULL}, {6, 1, 0, NULL}, {7, 1, 0, NULL}, {0, 8, 0, NULL},
};
const struct mip_names mip_names_gnss_data_rtk_corrections_status_flags = {
    name_gnss_data_rtk_corrections_status_flags,
    labels_gnss_data_rtk_corrections_status_flags,
    NULL,
    bits_gnss_data_rtk_corrections_status_flags,
    9,
    2};

static const char name_gnss_data_ephemeris_flags[] = "gnss_data.ephemeris_flags";
static const char labels_gnss_data_ephemeris_flags[] = "ephemeris\0modern_data\0isc_l5\0flags";
static const struct mip_named_bits bits_gnss_data_ephemeris_flags[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
    {2, 1, 0, NULL},
    {0, 3, 0, NULL},
};
const struct mip_names mip_names_gnss_data_ephemeris_flags = {name_gnss_data_ephemeris_flags,
                                                              labels_gnss_data_ephemeris_flags,
                                                              NULL,
                                                              bits_gnss_data_ephemeris_flags,
                                                              4,
                                                              2};

static const char name_gnss_data_glonass_satellite_type[] = "gnss_data.glonass_satellite_type";
static const char labels_gnss_data_glonass_satellite_type[] = "glonass\0glonass_m";
static const uint8_t numbers_gnss_data_glonass_satellite_type[] = {0, 1};
const struct mip_names mip_names_gnss_data_glonass_satellite_type = {
    name_gnss_data_glonass_satellite_type,
    labels_gnss_data_glonass_satellite_type,
    numbers_gnss_data_glonass_satellite_type,
    NULL,
    2,
    1};

static const char name_gnss_data_glonass_ephemeris_flags[] = "gnss_data.glonass_ephemeris_flags";
static const char labels_gnss_data_glonass_ephemeris_flags[] = "ephemeris\0flags";
static const struct mip_named_bits bits_gnss_data_glonass_ephemeris_flags[] = {
    {0, 1, 0, NULL},
    {0, 1, 0, NULL},
};
const struct mip_names mip_names_gnss_data_glonass_ephemeris_flags = {
    name_gnss_data_glonass_ephemeris_flags,
    labels_gnss_data_glonass_ephemeris_flags,
    NULL,
    bits_gnss_data_glonass_ephemeris_flags,
    2,
    2};

static const char name_gnss_data_gps_iono_correction_flags[] =
    "gnss_data.gps_iono_correction_flags";
static const char labels_gnss_data_gps_iono_correction_flags[] =
    "tow\0week_number\0alpha\0beta\0flags";
static const struct mip_named_bits bits_gnss_data_gps_iono_correction_flags[] = {
    {0, 1, 0, NULL}, {1, 1, 0, NULL}, {2, 1, 0, NULL}, {3, 1, 0, NULL}, {0, 4, 0, NULL},
};
const struct mip_names mip_names_gnss_data_gps_iono_correction_flags = {
    name_gnss_data_gps_iono_correction_flags,
    labels_gnss_data_gps_iono_correction_flags,
    NULL,
    bits_gnss_data_gps_iono_correction_flags,
    5,
    2};

static const char name_gnss_data_galileo_iono_correction_flags[] =
    "gnss_data.galileo_iono_correction_flags";
static const char labels_gnss_data_galileo_iono_correction_flags[] =
    "tow\0week_number\0alpha\0disturbance_flags\0flags";
static const struct mip_named_bits bits_gnss_data_galileo_iono_correction_flags[] = {
    {0, 1, 0, NULL}, {1, 1, 0, NULL}, {2, 1, 0, NULL}, {3, 1, 0, NULL}, {0, 4, 0, NULL},
};
const struct mip_names mip_names_gnss_data_galileo_iono_correction_flags = {
    name_gnss_data_galileo_iono_correction_flags,
    labels_gnss_data_galileo_iono_correction_flags,
    NULL,
    bits_gnss_data_galileo_iono_correction_flags,
    5,
    2};

static const char name_gnss_data_beidou_iono_correction_flags[] =
    "gnss_data.beidou_iono_correction_flags";
static const char labels_gnss_data_beidou_iono_correction_flags[] =
    "tow\0week_number\0alpha\0beta\0alpha_correction\0flags";
static const struct mip_named_bits bits_gnss_data_beidou_iono_correction_flags[] = {
    {0, 1, 0, NULL}, {1, 1, 0, NULL}, {2, 1, 0, NULL},
    {3, 1, 0, NULL}, {4, 1, 0, NULL}, {0, 5, 0, NULL},
};
const struct mip_names mip_names_gnss_data_beidou_iono_correction_flags = {
    name_gnss_data_beidou_iono_correction_flags,
    labels_gnss_data_beidou_iono_correction_flags,
    NULL,
    bits_gnss_data_beidou_iono_correction_flags,
    6,
    2};

static const char name_filter_data_valid_flags[] = "filter_data.valid_flags";
static const char labels_filter_data_valid_flags[] = "valid";
static const struct mip_named_bits bits_filter_data_valid_flags[] = {
    {0, 1, 0, NULL},
};
const struct mip_names mip_names_filter_data_valid_flags = {name_filter_data_valid_flags,
                                                            labels_filter_data_valid_flags,
                                                            NULL,
                                                            bits_filter_data_valid_flags,
                                                            1,
                                                            2};

static const char name_filter_data_heading_source_flags[] = "filter_data.heading_source_flags";
static const char labels_filter_data_heading_source_flags[] = "mag\0gnss_velocity\0external";
static const struct mip_named_bits bits_filter_data_heading_source_flags[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
    {2, 1, 0, NULL},
};
const struct mip_names mip_names_filter_data_heading_source_flags = {
    name_filter_data_heading_source_flags,
    labels_filter_data_heading_source_flags,
    NULL,
    bits_filter_data_heading_source_flags,
    3,
    2};

static const char name_filter_data_gnss_aiding_status[] = "filter_data.gnss_aiding_status";
static const char labels_filter_data_gnss_aiding_status[] =
    "tight_coupling\0differential\0integer_fix\0gps_l1\0gps_l2\0gps_l5\0glonass_l1\0glonass_"
    "l2\0galileo_e1\0galileo_e5\0galileo_e6\0beidou_b1\0beidou_b2\0beidou_b3\0no_fix\0config_error";
static const struct mip_named_bits bits_filter_data_gnss_aiding_status[] = {
    {0, 1, 0, NULL},  {1, 1, 0, NULL},  {2, 1, 0, NULL},  {3, 1, 0, NULL},
    {4, 1, 0, NULL},  {5, 1, 0, NULL},  {6, 1, 0, NULL},  {7, 1, 0, NULL},
    {8, 1, 0, NULL},  {9, 1, 0, NULL},  {10, 1, 0, NULL}, {11, 1, 0, NULL},
    {12, 1, 0, NULL}, {13, 1, 0, NULL}, {14, 1, 0, NULL}, {15, 1, 0, NULL},
};
const struct mip_names mip_names_filter_data_gnss_aiding_status = {
    name_filter_data_gnss_aiding_status,
    labels_filter_data_gnss_aiding_status,
    NULL,
    bits_filter_data_gnss_aiding_status,
    16,
    2};

static const char name_filter_data_heading_aiding_type[] = "filter_data.heading_aiding_type";
static const char labels_filter_data_heading_aiding_type[] = "dual_antenna\0external_message";
static const uint8_t numbers_filter_data_heading_aiding_type[] = {1, 2};
const struct mip_names mip_names_filter_data_heading_aiding_type = {
    name_filter_data_heading_aiding_type,
    labels_filter_data_heading_aiding_type,
    numbers_filter_data_heading_aiding_type,
    NULL,
    2,
    1};

static const char name_filter_data_aiding_measurement_type[] =
    "filter_data.aiding_measurement_type";
static const char labels_filter_data_aiding_measurement_type[] =
    "gnss\0dual_antenna\0heading\0pressure\0mag\0speed\0aiding_ecef_position\0aiding_llh_"
    "position\0aiding_height_above_ellipsoid\0aiding_ecef_velocity\0aiding_ned_velocity\0aiding_"
    "body_frame_velocity\0aiding_true_heading\0aiding_magnetic_field\0aiding_pressure";
static const uint8_t numbers_filter_data_aiding_measurement_type[] = {
    1, 2, 3, 4, 5, 6, 33, 34, 35, 40, 41, 42, 49, 50, 51};
const struct mip_names mip_names_filter_data_aiding_measurement_type = {
    name_filter_data_aiding_measurement_type,
    labels_filter_data_aiding_measurement_type,
    numbers_filter_data_aiding_measurement_type,
    NULL,
    15,
    1};

static const char name_filter_data_aiding_measurement_indicator[] =
    "filter_data.aiding_measurement_indicator";
static const char labels_filter_data_aiding_measurement_indicator[] =
    "enabled\0used\0residual_high_warning\0sample_time_warning\0config_error\0max_measurements_"
    "exceeded";
static const struct mip_named_bits bits_filter_data_aiding_measurement_indicator[] = {
    {0, 1, 0, NULL}, {1, 1, 0, NULL}, {2, 1, 0, NULL},
    {3, 1, 0, NULL}, {4, 1, 0, NULL}, {5, 1, 0, NULL},
};
const struct mip_names mip_names_filter_data_aiding_measurement_indicator = {
    name_filter_data_aiding_measurement_indicator,
    labels_filter_data_aiding_measurement_indicator,
    NULL,
    bits_filter_data_aiding_measurement_indicator,
    6,
    1};

static const char name_filter_data_dual_antenna_fix_type[] = "filter_data.dual_antenna_fix_type";
static const char labels_filter_data_dual_antenna_fix_type[] =
    "fix_none\0fix_da_float\0fix_da_fixed";
static const uint8_t numbers_filter_data_dual_antenna_fix_type[] = {0, 1, 2};
const struct mip_names mip_names_filter_data_dual_antenna_fix_type = {
    name_filter_data_dual_antenna_fix_type,
    labels_filter_data_dual_antenna_fix_type,
    numbers_filter_data_dual_antenna_fix_type,
    NULL,
    3,
    1};

static const char name_filter_data_dual_antenna_status_flags[] =
    "filter_data.dual_antenna_status_flags";
static const char labels_filter_data_dual_antenna_status_flags[] =
    "receiver_1_data_valid\0receiver_2_data_valid\0antenna_offsets_valid";
static const struct mip_named_bits bits_filter_data_dual_antenna_status_flags[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
    {2, 1, 0, NULL},
};
const struct mip_names mip_names_filter_data_dual_antenna_status_flags = {
    name_filter_data_dual_antenna_status_flags,
    labels_filter_data_dual_antenna_status_flags,
    NULL,
    bits_filter_data_dual_antenna_status_flags,
    3,
    2};

static const char name_filter_data_gx5_filter_state[] = "filter_data.gx5_filter_state";
static const char labels_filter_data_gx5_filter_state[] =
    "startup\0init\0run_solution_valid\0run_solution_error";
static const uint16_t numbers_filter_data_gx5_filter_state[] = {0, 1, 2, 3};
const struct mip_names mip_names_filter_data_gx5_filter_state = {
    name_filter_data_gx5_filter_state,
    labels_filter_data_gx5_filter_state,
    numbers_filter_data_gx5_filter_state,
    NULL,
    4,
    2};

static const char name_filter_data_cv7_filter_state[] = "filter_data.cv7_filter_state";
static const char labels_filter_data_cv7_filter_state[] = "init\0vertical_gyro\0ahrs\0full_nav";
static const uint16_t numbers_filter_data_cv7_filter_state[] = {1, 2, 3, 4};
const struct mip_names mip_names_filter_data_cv7_filter_state = {
    name_filter_data_cv7_filter_state,
    labels_filter_data_cv7_filter_state,
    numbers_filter_data_cv7_filter_state,
    NULL,
    4,
    2};

static const char name_filter_data_gx5_dynamics_mode[] = "filter_data.gx5_dynamics_mode";
static const char labels_filter_data_gx5_dynamics_mode[] =
    "portable\0automotive\0airborne\0airborne_high_g";
static const uint16_t numbers_filter_data_gx5_dynamics_mode[] = {1, 2, 3, 4};
const struct mip_names mip_names_filter_data_gx5_dynamics_mode = {
    name_filter_data_gx5_dynamics_mode,
    labels_filter_data_gx5_dynamics_mode,
    numbers_filter_data_gx5_dynamics_mode,
    NULL,
    4,
    2};

static const char name_filter_data_cv7_dynamics_mode[] = "filter_data.cv7_dynamics_mode";
static const char labels_filter_data_cv7_dynamics_mode[] = "default";
static const uint16_t numbers_filter_data_cv7_dynamics_mode[] = {1};
const struct mip_names mip_names_filter_data_cv7_dynamics_mode = {
    name_filter_data_cv7_dynamics_mode,
    labels_filter_data_cv7_dynamics_mode,
    numbers_filter_data_cv7_dynamics_mode,
    NULL,
    1,
    2};

static const char name_filter_data_gx5_status_flags[] = "filter_data.gx5_status_flags";
static const char labels_filter_data_gx5_status_flags[] =
    "run_imu_unavailable\0run_gps_unavailable\0run_matrix_singularity\0run_position_covariance_"
    "warning\0run_velocity_covariance_warning\0run_attitude_covariance_warning\0run_nan_in_"
    "solution_warning\0run_gyro_bias_est_high_warning\0run_accel_bias_est_high_warning\0run_gyro_"
    "scale_factor_est_high_warning\0run_accel_scale_factor_est_high_warning\0run_mag_bias_est_high_"
    "warning\0run_antenna_offset_correction_est_high_warning\0run_mag_hard_iron_est_high_"
    "warning\0run_mag_soft_iron_est_high_warning\0init_no_attitude\0init_no_position_velocity";
static const struct mip_named_bits bits_filter_data_gx5_status_flags[] = {
    {0, 1, 12, NULL},  {1, 1, 12, NULL},  {3, 1, 12, NULL},  {4, 1, 12, NULL},  {5, 1, 12, NULL},
    {6, 1, 12, NULL},  {7, 1, 12, NULL},  {8, 1, 12, NULL},  {9, 1, 12, NULL},  {10, 1, 12, NULL},
    {11, 1, 12, NULL}, {12, 1, 12, NULL}, {13, 1, 12, NULL}, {14, 1, 12, NULL}, {15, 1, 12, NULL},
    {12, 1, 2, NULL},  {13, 1, 2, NULL},
};
const struct mip_names mip_names_filter_data_gx5_status_flags = {
    name_filter_data_gx5_status_flags,
    labels_filter_data_gx5_status_flags,
    NULL,
    bits_filter_data_gx5_status_flags,
    17,
    2};

static const char name_filter_data_filter_condition[] = "filter_data.filter_condition";
static const char labels_filter_data_filter_condition[] = "stable\0converging\0unstable";
static const uint8_t numbers_filter_data_filter_condition[] = {1, 2, 3};
const struct mip_names mip_names_filter_data_filter_condition = {
    name_filter_data_filter_condition,
    labels_filter_data_filter_condition,
    numbers_filter_data_filter_condition,
    NULL,
    3,
    1};

static const char name_filter_data_cv7_status_flags[] = "filter_data.cv7_status_flags";
static const char labels_filter_data_cv7_status_flags[] =
    "filter_condition\0roll_pitch_warning\0heading_warning\0position_warning\0velocity_"
    "warning\0imu_bias_warning\0gnss_clock_warning\0antenna_lever_arm_warning\0mounting_transform_"
    "warning\0time_sync_warning\0solution_error";
static const struct mip_named_bits bits_filter_data_cv7_status_flags[] = {
    {0, 2, 0, &mip_names_filter_data_filter_condition},
    {2, 1, 0, NULL},
    {3, 1, 0, NULL},
    {4, 1, 0, NULL},
    {5, 1, 0, NULL},
    {6, 1, 0, NULL},
    {7, 1, 0, NULL},
    {8, 1, 0, NULL},
    {9, 1, 0, NULL},
    {10, 1, 0, NULL},
    {12, 4, 0, NULL},
};
const struct mip_names mip_names_filter_data_cv7_status_flags = {
    name_filter_data_cv7_status_flags,
    labels_filter_data_cv7_status_flags,
    NULL,
    bits_filter_data_cv7_status_flags,
    11,
    2};

static const char name_displacement_data_timestamp_flags[] = "displacement_data.timestamp_flags";
static const char labels_displacement_data_timestamp_flags[] = "time";
static const struct mip_named_bits bits_displacement_data_timestamp_flags[] = {
    {0, 1, 0, NULL},
};
const struct mip_names mip_names_displacement_data_timestamp_flags = {
    name_displacement_data_timestamp_flags,
    labels_displacement_data_timestamp_flags,
    NULL,
    bits_displacement_data_timestamp_flags,
    1,
    1};

static const char name_system_data_gpio_pin_states[] = "system_data.gpio_pin_states";
static const char labels_system_data_gpio_pin_states[] = "pin_1\0pin_2\0pin_3\0pin_4";
static const struct mip_named_bits bits_system_data_gpio_pin_states[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
    {2, 1, 0, NULL},
    {3, 1, 0, NULL},
};
const struct mip_names mip_names_system_data_gpio_pin_states = {name_system_data_gpio_pin_states,
                                                                labels_system_data_gpio_pin_states,
                                                                NULL,
                                                                bits_system_data_gpio_pin_states,
                                                                4,
                                                                1};

static const char name_shared_gps_timestamp_flags[] = "shared.gps_timestamp_flags";
static const char labels_shared_gps_timestamp_flags[] = "tow\0week_number\0time_valid";
static const struct mip_named_bits bits_shared_gps_timestamp_flags[] = {
    {0, 1, 0, NULL},
    {1, 1, 0, NULL},
    {0, 2, 0, NULL},
};
const struct mip_names mip_names_shared_gps_timestamp_flags = {name_shared_gps_timestamp_flags,
                                                               labels_shared_gps_timestamp_flags,
                                                               NULL,
                                                               bits_shared_gps_timestamp_flags,
                                                               3,
                                                               2};

static const char name_shared_external_timestamp_flags[] = "shared.external_timestamp_flags";
static const char labels_shared_external_timestamp_flags[] = "nanoseconds";
static const struct mip_named_bits bits_shared_external_timestamp_flags[] = {
    {0, 1, 0, NULL},
};
const struct mip_names mip_names_shared_external_timestamp_flags = {
    name_shared_external_timestamp_flags,
    labels_shared_external_timestamp_flags,
    NULL,
    bits_shared_external_timestamp_flags,
    1,
    2};

static const char name_shared_external_time_delta_flags[] = "shared.external_time_delta_flags";
static const char labels_shared_external_time_delta_flags[] = "dt_nanos";
static const struct mip_named_bits bits_shared_external_time_delta_flags[] = {
    {0, 1, 0, NULL},
};
const struct mip_names mip_names_shared_external_time_delta_flags = {
    name_shared_external_time_delta_flags,
    labels_shared_external_time_delta_flags,
    NULL,
    bits_shared_external_time_delta_flags,
    1,
    2};
