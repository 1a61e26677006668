/* The names of values and bits. */
#include "mip/names.h"
#include "mip/protocol.h"
#include "mip/base.h"
#include "mip/3dm.h"
#include "mip/filter.h"
#include "mip/gnss.h"
#include "mip/rtk.h"
#include "mip/aiding.h"
#include "mip/system.h"
#include "mip/sensor.h"
#include "mip/gnss_data.h"
#include "mip/filter_data.h"
#include "mip/gnss_1.h"
#include "mip/gnss_2.h"
#include "mip/gnss_corrections.h"
#include "mip/gnss_external.h"
#include "mip/gnss_external_2.h"
#include "mip/system_data.h"
#include "mip/shared.h"

static const char *const labels_function_selector[] = {"write", "read",    "save",
                                                       "load",  "default", "apply"};
static const uint8_t numbers_function_selector[] = {1, 2, 3, 4, 5, 6};
const struct mip_names mip_names_function_selector = {
    "function_selector", labels_function_selector, numbers_function_selector, NULL, 6, 1,
};
const char *mip_function_selector_name(uint8_t value) {
    return mip_value_name(&mip_names_function_selector, value);
}

static const struct mip_named_bits bits_gx5_built_in_test[] = {
    {"watchdog_reset", 0, 1, NULL},  {"imu_comm_fault", 8, 1, NULL},
    {"mag_fault", 9, 1, NULL},       {"pressure_sensor_fault", 10, 1, NULL},
    {"solution_fault", 24, 1, NULL},
};
const struct mip_names mip_names_gx5_built_in_test = {
    "gx5_built_in_test", NULL, NULL, bits_gx5_built_in_test, 5, 4,
};

static const struct mip_named_bits bits_cv7_built_in_test[] = {
    {"general_hardware_fault", 0, 1, NULL},
    {"general_firmware_fault", 1, 1, NULL},
    {"timing_overload", 2, 1, NULL},
    {"buffer_overrun", 3, 1, NULL},
    {"accel_fault", 12, 1, NULL},
    {"gyro_fault", 13, 1, NULL},
    {"mag_fault", 14, 1, NULL},
    {"pressure_sensor_fault", 15, 1, NULL},
    {"calibration_error", 18, 1, NULL},
    {"general_imu_fault", 19, 1, NULL},
    {"filter_solution_fault", 22, 1, NULL},
    {"general_filter_fault", 23, 1, NULL},
};
const struct mip_names mip_names_cv7_built_in_test = {
    "cv7_built_in_test", NULL, NULL, bits_cv7_built_in_test, 12, 4,
};

static const struct mip_named_bits bits_cv7_continuous_bit[] = {
    {"system_clock_failure", 0, 1, NULL},
    {"power_fault", 1, 1, NULL},
    {"firmware_fault", 4, 1, NULL},
    {"timing_overload", 5, 1, NULL},
    {"buffer_overrun", 6, 1, NULL},
    {"imu_process_fault", 16, 1, NULL},
    {"imu_data_process_time_exceeded", 17, 1, NULL},
    {"imu_data_rate_error", 18, 1, NULL},
    {"imu_stall", 19, 1, NULL},
    {"filter_process_fault", 20, 4, NULL},
    {"filter_major_cycle_fault", 20, 1, NULL},
    {"filter_minor_cycle_fault", 21, 1, NULL},
    {"filter_data_rate_error", 22, 1, NULL},
    {"filter_process_stall", 23, 1, NULL},
    {"gnss_subsystem_fault", 24, 4, NULL},
    {"gnss_main_process_fault", 24, 1, NULL},
    {"gnss_receiver_1_stall", 25, 1, NULL},
    {"gnss_receiver_2_stall", 26, 1, NULL},
    {"imu_comm_fault", 33, 1, NULL},
    {"imu_timing_overrun", 34, 1, NULL},
    {"imu_calibration_error_accel", 36, 1, NULL},
    {"imu_calibration_error_gyro", 37, 1, NULL},
    {"imu_calibration_error_mag", 38, 1, NULL},
    {"accel_general_fault", 40, 1, NULL},
    {"accel_over_range", 41, 1, NULL},
    {"accel_self_test_fail", 42, 1, NULL},
    {"gyro_general_fault", 44, 1, NULL},
    {"gyro_over_range", 45, 1, NULL},
    {"gyro_self_test_fail", 46, 1, NULL},
    {"mag_general_fault", 48, 1, NULL},
    {"mag_over_range", 49, 1, NULL},
    {"mag_self_test_fail", 50, 1, NULL},
    {"pressure_sensor_general_fault", 52, 1, NULL},
    {"pressure_sensor_over_range", 53, 1, NULL},
    {"pressure_sensor_self_test_fail", 54, 1, NULL},
    {"factory_bits_invalid", 56, 1, NULL},
    {"filter_timing_overrun", 66, 1, NULL},
    {"filter_timing_underrun", 67, 1, NULL},
    {"receiver_1_fault", 105, 1, NULL},
    {"receiver_1_no_solution", 108, 1, NULL},
    {"receiver_2_fault", 110, 1, NULL},
    {"receiver_2_no_solution", 113, 1, NULL},
};
const struct mip_names mip_names_cv7_continuous_bit = {
    "cv7_continuous_built_in_test", NULL, NULL, bits_cv7_continuous_bit, 42, 16,
};

static const char *const labels_event_trigger_type[] = {"none", "gpio", "threshold", "combination"};
static const uint8_t numbers_event_trigger_type[] = {0, 1, 2, 3};
const struct mip_names mip_names_event_trigger_type = {
    "event_trigger_type", labels_event_trigger_type, numbers_event_trigger_type, NULL, 4, 1,
};
const char *mip_event_trigger_type_name(uint8_t value) {
    return mip_value_name(&mip_names_event_trigger_type, value);
}

static const char *const labels_event_action_type[] = {"none", "gpio", "message"};
static const uint8_t numbers_event_action_type[] = {0, 1, 2};
const struct mip_names mip_names_event_action_type = {
    "event_action_type", labels_event_action_type, numbers_event_action_type, NULL, 3, 1,
};
const char *mip_event_action_type_name(uint8_t value) {
    return mip_value_name(&mip_names_event_action_type, value);
}

static const char *const labels_event_trigger_mode[] = {"disabled", "enabled", "test",
                                                        "test_pulse"};
static const uint8_t numbers_event_trigger_mode[] = {0, 1, 2, 3};
const struct mip_names mip_names_event_trigger_mode = {
    "event_trigger_mode", labels_event_trigger_mode, numbers_event_trigger_mode, NULL, 4, 1,
};
const char *mip_event_trigger_mode_name(uint8_t value) {
    return mip_value_name(&mip_names_event_trigger_mode, value);
}

static const struct mip_named_bits bits_event_trigger_status[] = {
    {"active", 0, 1, NULL},
    {"enabled", 1, 1, NULL},
    {"test", 2, 1, NULL},
};
const struct mip_names mip_names_event_trigger_status = {
    "event_trigger_status", NULL, NULL, bits_event_trigger_status, 3, 1,
};

static const char *const labels_event_trigger_gpio_mode[] = {"disabled", "while_high", "while_low",
                                                             "edge"};
static const uint8_t numbers_event_trigger_gpio_mode[] = {0, 1, 2, 4};
const struct mip_names mip_names_event_trigger_gpio_mode = {
    "event_trigger_gpio_mode",
    labels_event_trigger_gpio_mode,
    numbers_event_trigger_gpio_mode,
    NULL,
    4,
    1,
};
const char *mip_event_trigger_gpio_mode_name(uint8_t value) {
    return mip_value_name(&mip_names_event_trigger_gpio_mode, value);
}

static const char *const labels_event_threshold_type[] = {"window", "interval"};
static const uint8_t numbers_event_threshold_type[] = {1, 2};
const struct mip_names mip_names_event_threshold_type = {
    "event_threshold_type", labels_event_threshold_type, numbers_event_threshold_type, NULL, 2, 1,
};
const char *mip_event_threshold_type_name(uint8_t value) {
    return mip_value_name(&mip_names_event_threshold_type, value);
}

static const char *const labels_event_action_gpio_mode[] = {
    "disabled", "active_high", "active_low", "oneshot_high", "oneshot_low", "toggle"};
static const uint8_t numbers_event_action_gpio_mode[] = {0, 1, 2, 5, 6, 7};
const struct mip_names mip_names_event_action_gpio_mode = {
    "event_action_gpio_mode",
    labels_event_action_gpio_mode,
    numbers_event_action_gpio_mode,
    NULL,
    6,
    1,
};
const char *mip_event_action_gpio_mode_name(uint8_t value) {
    return mip_value_name(&mip_names_event_action_gpio_mode, value);
}

static const char *const labels_gnss_constellation[] = {"unknown", "gps",    "glonass",
                                                        "galileo", "beidou", "sbas"};
static const uint8_t numbers_gnss_constellation[] = {0, 1, 2, 3, 4, 5};
const struct mip_names mip_names_gnss_constellation = {
    "gnss_constellation", labels_gnss_constellation, numbers_gnss_constellation, NULL, 6, 1,
};
const char *mip_gnss_constellation_name(uint8_t value) {
    return mip_value_name(&mip_names_gnss_constellation, value);
}

static const char *const labels_gnss_fix_type[] = {
    "fix_3d",      "fix_2d",        "fix_time_only", "fix_none",
    "fix_invalid", "fix_rtk_float", "fix_rtk_fixed", "fix_differential"};
static const uint8_t numbers_gnss_fix_type[] = {0, 1, 2, 3, 4, 5, 6, 7};
const struct mip_names mip_names_gnss_fix_type = {
    "gnss_fix_type", labels_gnss_fix_type, numbers_gnss_fix_type, NULL, 8, 1,
};
const char *mip_gnss_fix_type_name(uint8_t value) {
    return mip_value_name(&mip_names_gnss_fix_type, value);
}

static const char *const labels_gnss_signal[] = {
    "unknown",        "gps_l1ca",     "gps_l1p",       "gps_l1z",       "gps_l2ca",
    "gps_l2p",        "gps_l2z",      "gps_l2cl",      "gps_l2cm",      "gps_l2cml",
    "gps_l5i",        "gps_l5q",      "gps_l5iq",      "gps_l1cd",      "gps_l1cp",
    "gps_l1cdp",      "glonass_g1ca", "glonass_g1p",   "glonass_g2c",   "glonass_g2p",
    "galileo_e1c",    "galileo_e1a",  "galileo_e1b",   "galileo_e1bc",  "galileo_e1abc",
    "galileo_e6c",    "galileo_e6a",  "galileo_e6b",   "galileo_e6bc",  "galileo_e6abc",
    "galileo_e5bi",   "galileo_e5bq", "galileo_e5biq", "galileo_e5abi", "galileo_e5abq",
    "galileo_e5abiq", "galileo_e5ai", "galileo_e5aq",  "galileo_e5aiq", "sbas_l1ca",
    "sbas_l5i",       "sbas_l5q",     "sbas_l5iq",     "qzss_l1ca",     "qzss_lexs",
    "qzss_lexl",      "qzss_lexsl",   "qzss_l2cm",     "qzss_l2cl",     "qzss_l2cml",
    "qzss_l5i",       "qzss_l5q",     "qzss_l5iq",     "qzss_l1cd",     "qzss_l1cp",
    "qzss_l1cdp",     "beidou_b1i",   "beidou_b1q",    "beidou_b1iq",   "beidou_b3i",
    "beidou_b3q",     "beidou_b3iq",  "beidou_b2i",    "beidou_b2q",    "beidou_b2iq",
    "beidou_b2a"};
static const uint8_t numbers_gnss_signal[] = {
    0,   1,   2,   3,   4,   5,   6,   7,   8,   9,   10,  11,  12,  13,  14,  15,  32,
    33,  34,  35,  64,  65,  66,  67,  68,  69,  70,  71,  72,  73,  74,  75,  76,  77,
    78,  79,  80,  81,  82,  96,  97,  98,  99,  128, 129, 130, 131, 132, 133, 134, 135,
    136, 137, 138, 139, 140, 160, 161, 162, 163, 164, 165, 166, 167, 168, 169};
const struct mip_names mip_names_gnss_signal = {
    "gnss_signal", labels_gnss_signal, numbers_gnss_signal, NULL, 66, 1,
};
const char *mip_gnss_signal_name(uint8_t value) {
    return mip_value_name(&mip_names_gnss_signal, value);
}

static const char *const labels_gpio_feature[] = {"unused",  "gpio",      "pps",
                                                  "encoder", "timestamp", "uart"};
static const uint8_t numbers_gpio_feature[] = {0, 1, 2, 3, 4, 5};
const struct mip_names mip_names_gpio_feature = {
    "gpio_feature", labels_gpio_feature, numbers_gpio_feature, NULL, 6, 1,
};
const char *mip_gpio_feature_name(uint8_t value) {
    return mip_value_name(&mip_names_gpio_feature, value);
}

static const char *const labels_gpio_unused_behavior[] = {"unused"};
static const uint8_t numbers_gpio_unused_behavior[] = {0};
const struct mip_names mip_names_gpio_unused_behavior = {
    "gpio_unused_behavior", labels_gpio_unused_behavior, numbers_gpio_unused_behavior, NULL, 1, 1,
};
const char *mip_gpio_unused_behavior_name(uint8_t value) {
    return mip_value_name(&mip_names_gpio_unused_behavior, value);
}

static const char *const labels_gpio_behavior[] = {"input", "output_low", "output_high"};
static const uint8_t numbers_gpio_behavior[] = {1, 2, 3};
const struct mip_names mip_names_gpio_behavior = {
    "gpio_behavior", labels_gpio_behavior, numbers_gpio_behavior, NULL, 3, 1,
};
const char *mip_gpio_behavior_name(uint8_t value) {
    return mip_value_name(&mip_names_gpio_behavior, value);
}

static const char *const labels_gpio_pps_behavior[] = {"input", "output"};
static const uint8_t numbers_gpio_pps_behavior[] = {1, 2};
const struct mip_names mip_names_gpio_pps_behavior = {
    "gpio_pps_behavior", labels_gpio_pps_behavior, numbers_gpio_pps_behavior, NULL, 2, 1,
};
const char *mip_gpio_pps_behavior_name(uint8_t value) {
    return mip_value_name(&mip_names_gpio_pps_behavior, value);
}

static const char *const labels_gpio_encoder_behavior[] = {"a", "b"};
static const uint8_t numbers_gpio_encoder_behavior[] = {1, 2};
const struct mip_names mip_names_gpio_encoder_behavior = {
    "gpio_encoder_behavior",
    labels_gpio_encoder_behavior,
    numbers_gpio_encoder_behavior,
    NULL,
    2,
    1,
};
const char *mip_gpio_encoder_behavior_name(uint8_t value) {
    return mip_value_name(&mip_names_gpio_encoder_behavior, value);
}

static const char *const labels_gpio_timestamp_behavior[] = {"rising", "falling", "either"};
static const uint8_t numbers_gpio_timestamp_behavior[] = {1, 2, 3};
const struct mip_names mip_names_gpio_timestamp_behavior = {
    "gpio_timestamp_behavior",
    labels_gpio_timestamp_behavior,
    numbers_gpio_timestamp_behavior,
    NULL,
    3,
    1,
};
const char *mip_gpio_timestamp_behavior_name(uint8_t value) {
    return mip_value_name(&mip_names_gpio_timestamp_behavior, value);
}

static const char *const labels_gpio_uart_behavior[] = {"port_2_tx", "port_2_rx", "port_3_tx",
                                                        "port_3_rx"};
static const uint8_t numbers_gpio_uart_behavior[] = {33, 34, 49, 50};
const struct mip_names mip_names_gpio_uart_behavior = {
    "gpio_uart_behavior", labels_gpio_uart_behavior, numbers_gpio_uart_behavior, NULL, 4, 1,
};
const char *mip_gpio_uart_behavior_name(uint8_t value) {
    return mip_value_name(&mip_names_gpio_uart_behavior, value);
}

static const struct mip_named_bits bits_gpio_pin_mode[] = {
    {"open_drain", 0, 1, NULL},
    {"pulldown", 1, 1, NULL},
    {"pullup", 2, 1, NULL},
};
const struct mip_names mip_names_gpio_pin_mode = {
    "gpio_pin_mode", NULL, NULL, bits_gpio_pin_mode, 3, 1,
};

static const char *const labels_nmea_message_id[] = {"gga", "gll", "gsv", "rmc",  "vtg",
                                                     "hdt", "zda", "gst", "msra", "msrr"};
static const uint8_t numbers_nmea_message_id[] = {1, 2, 3, 4, 5, 6, 7, 8, 129, 130};
const struct mip_names mip_names_nmea_message_id = {
    "nmea_message_id", labels_nmea_message_id, numbers_nmea_message_id, NULL, 10, 1,
};
const char *mip_nmea_message_id_name(uint8_t value) {
    return mip_value_name(&mip_names_nmea_message_id, value);
}

static const char *const labels_nmea_talker_id[] = {"ignored", "gnss", "gps", "galileo", "glonass"};
static const uint8_t numbers_nmea_talker_id[] = {0, 1, 2, 3, 4};
const struct mip_names mip_names_nmea_talker_id = {
    "nmea_talker_id", labels_nmea_talker_id, numbers_nmea_talker_id, NULL, 5, 1,
};
const char *mip_nmea_talker_id_name(uint8_t value) {
    return mip_value_name(&mip_names_nmea_talker_id, value);
}

static const struct mip_named_bits bits_rtk_status_flags[] = {
    {"modem_state", 0, 4, NULL},
    {"connection_type", 4, 4, NULL},
    {"rssi", 8, 8, NULL},
    {"signal_quality", 16, 4, NULL},
    {"tower_change_indicator", 20, 4, NULL},
    {"nmea_timeout", 24, 1, NULL},
    {"server_timeout", 25, 1, NULL},
    {"corrections_timeout", 26, 1, NULL},
    {"device_out_of_range", 27, 1, NULL},
    {"corrections_unavailable", 28, 1, NULL},
    {"version", 30, 2, NULL},
};
const struct mip_names mip_names_rtk_status_flags = {
    "rtk_status_flags", NULL, NULL, bits_rtk_status_flags, 11, 4,
};

static const struct mip_named_bits bits_rtk_status_flags_legacy[] = {
    {"controller_state", 0, 3, NULL},
    {"platform_state", 3, 5, NULL},
    {"controller_status_code", 8, 3, NULL},
    {"platform_status_code", 11, 3, NULL},
    {"reset_code", 14, 2, NULL},
    {"signal_quality", 16, 4, NULL},
    {"rssi", 20, 6, NULL},
    {"rsrp", 26, 2, NULL},
    {"rsrq", 28, 2, NULL},
    {"sinr", 30, 2, NULL},
};
const struct mip_names mip_names_rtk_status_flags_legacy = {
    "rtk_status_flags_legacy", NULL, NULL, bits_rtk_status_flags_legacy, 10, 4,
};

static const char *const labels_ack_code[] = {"ok",
                                              "unknown_command",
                                              "bad_checksum",
                                              "invalid_parameter",
                                              "command_failed",
                                              "command_timeout",
                                              "unknown_descriptor_set"};
static const uint8_t numbers_ack_code[] = {0, 1, 2, 3, 4, 5, 6};
const struct mip_names mip_names_ack_code = {
    "ack_code", labels_ack_code, numbers_ack_code, NULL, 7, 1,
};
const char *mip_ack_code_name(uint8_t value) {
    return mip_value_name(&mip_names_ack_code, value);
}

static const struct mip_named_bits bits_sensor_gps_timestamp_flags[] = {
    {"pps_valid", 0, 1, NULL}, {"time_refresh", 1, 1, NULL},      {"time_initialized", 2, 1, NULL},
    {"tow_valid", 3, 1, NULL}, {"week_number_valid", 4, 1, NULL},
};
const struct mip_names mip_names_sensor_gps_timestamp_flags = {
    "sensor_gps_timestamp_flags", NULL, NULL, bits_sensor_gps_timestamp_flags, 5, 2,
};

static const struct mip_named_bits bits_gx5_sensor_gps_timestamp_flags[] = {
    {"pps_valid", 0, 1, NULL},
    {"time_refresh", 1, 1, NULL},
    {"time_initialized", 2, 1, NULL},
};
const struct mip_names mip_names_gx5_sensor_gps_timestamp_flags = {
    "gx5_sensor_gps_timestamp_flags", NULL, NULL, bits_gx5_sensor_gps_timestamp_flags, 3, 2,
};

static const char *const labels_base_gps_time_field[] = {"week_number", "tow"};
static const uint8_t numbers_base_gps_time_field[] = {1, 2};
const struct mip_names mip_names_base_gps_time_field = {
    "base.gps_time_field", labels_base_gps_time_field, numbers_base_gps_time_field, NULL, 2, 1,
};
const char *mip_base_gps_time_field_name(uint8_t value) {
    return mip_value_name(&mip_names_base_gps_time_field, value);
}

static const char *const labels_3dm_factory_streaming_action[] = {"overwrite", "merge", "add"};
static const uint8_t numbers_3dm_factory_streaming_action[] = {0, 1, 2};
const struct mip_names mip_names_3dm_factory_streaming_action = {
    "3dm.factory_streaming_action",
    labels_3dm_factory_streaming_action,
    numbers_3dm_factory_streaming_action,
    NULL,
    3,
    1,
};
const char *mip_3dm_factory_streaming_action_name(uint8_t value) {
    return mip_value_name(&mip_names_3dm_factory_streaming_action, value);
}

static const char *const labels_3dm_constellation_id[] = {"gps",    "sbas", "galileo",
                                                          "beidou", "qzss", "glonass"};
static const uint8_t numbers_3dm_constellation_id[] = {0, 1, 2, 3, 5, 6};
const struct mip_names mip_names_3dm_constellation_id = {
    "3dm.constellation_id", labels_3dm_constellation_id, numbers_3dm_constellation_id, NULL, 6, 1,
};
const char *mip_3dm_constellation_id_name(uint8_t value) {
    return mip_value_name(&mip_names_3dm_constellation_id, value);
}

static const struct mip_named_bits bits_3dm_constellation_options[] = {
    {"l1saif", 0, 1, NULL},
};
const struct mip_names mip_names_3dm_constellation_options = {
    "3dm.constellation_options", NULL, NULL, bits_3dm_constellation_options, 1, 2,
};

static const struct mip_named_bits bits_3dm_sbas_options[] = {
    {"enable_ranging", 0, 1, NULL},
    {"enable_corrections", 1, 1, NULL},
    {"apply_integrity", 2, 1, NULL},
};
const struct mip_names mip_names_3dm_sbas_options = {
    "3dm.sbas_options", NULL, NULL, bits_3dm_sbas_options, 3, 2,
};

static const char *const labels_3dm_assisted_fix_option[] = {"none", "enabled"};
static const uint8_t numbers_3dm_assisted_fix_option[] = {0, 1};
const struct mip_names mip_names_3dm_assisted_fix_option = {
    "3dm.assisted_fix_option",
    labels_3dm_assisted_fix_option,
    numbers_3dm_assisted_fix_option,
    NULL,
    2,
    1,
};
const char *mip_3dm_assisted_fix_option_name(uint8_t value) {
    return mip_value_name(&mip_names_3dm_assisted_fix_option, value);
}

static const char *const labels_3dm_pps_source[] = {"disabled", "receiver_1", "receiver_2", "gpio",
                                                    "generated"};
static const uint8_t numbers_3dm_pps_source[] = {0, 1, 2, 3, 4};
const struct mip_names mip_names_3dm_pps_source = {
    "3dm.pps_source", labels_3dm_pps_source, numbers_3dm_pps_source, NULL, 5, 1,
};
const char *mip_3dm_pps_source_name(uint8_t value) {
    return mip_value_name(&mip_names_3dm_pps_source, value);
}

static const char *const labels_3dm_event_support_query[] = {"trigger_types", "action_types"};
static const uint8_t numbers_3dm_event_support_query[] = {1, 2};
const struct mip_names mip_names_3dm_event_support_query = {
    "3dm.event_support_query",
    labels_3dm_event_support_query,
    numbers_3dm_event_support_query,
    NULL,
    2,
    1,
};
const char *mip_3dm_event_support_query_name(uint8_t value) {
    return mip_value_name(&mip_names_3dm_event_support_query, value);
}

static const char *const labels_3dm_odometer_mode[] = {"disabled", "quadrature"};
static const uint8_t numbers_3dm_odometer_mode[] = {0, 2};
const struct mip_names mip_names_3dm_odometer_mode = {
    "3dm.odometer_mode", labels_3dm_odometer_mode, numbers_3dm_odometer_mode, NULL, 2, 1,
};
const char *mip_3dm_odometer_mode_name(uint8_t value) {
    return mip_value_name(&mip_names_3dm_odometer_mode, value);
}

static const char *const labels_3dm_sensor_range_type[] = {"all", "accel", "gyro", "mag",
                                                           "pressure"};
static const uint8_t numbers_3dm_sensor_range_type[] = {0, 1, 2, 3, 4};
const struct mip_names mip_names_3dm_sensor_range_type = {
    "3dm.sensor_range_type",
    labels_3dm_sensor_range_type,
    numbers_3dm_sensor_range_type,
    NULL,
    5,
    1,
};
const char *mip_3dm_sensor_range_type_name(uint8_t value) {
    return mip_value_name(&mip_names_3dm_sensor_range_type, value);
}

static const char *const labels_3dm_device_status_selector[] = {"basic", "diagnostic"};
static const uint8_t numbers_3dm_device_status_selector[] = {1, 2};
const struct mip_names mip_names_3dm_device_status_selector = {
    "3dm.device_status_selector",
    labels_3dm_device_status_selector,
    numbers_3dm_device_status_selector,
    NULL,
    2,
    1,
};
const char *mip_3dm_device_status_selector_name(uint8_t value) {
    return mip_value_name(&mip_names_3dm_device_status_selector, value);
}

static const char *const labels_3dm_legacy_data_stream[] = {"all_streams", "imu", "gnss", "filter"};
static const uint8_t numbers_3dm_legacy_data_stream[] = {0, 1, 2, 3};
const struct mip_names mip_names_3dm_legacy_data_stream = {
    "3dm.legacy_data_stream",
    labels_3dm_legacy_data_stream,
    numbers_3dm_legacy_data_stream,
    NULL,
    4,
    1,
};
const char *mip_3dm_legacy_data_stream_name(uint8_t value) {
    return mip_value_name(&mip_names_3dm_legacy_data_stream, value);
}

static const char *const labels_filter_dynamics_mode[] = {"portable", "automotive", "airborne",
                                                          "airborne_high_g"};
static const uint8_t numbers_filter_dynamics_mode[] = {1, 2, 3, 4};
const struct mip_names mip_names_filter_dynamics_mode = {
    "filter.dynamics_mode", labels_filter_dynamics_mode, numbers_filter_dynamics_mode, NULL, 4, 1,
};
const char *mip_filter_dynamics_mode_name(uint8_t value) {
    return mip_value_name(&mip_names_filter_dynamics_mode, value);
}

static const struct mip_named_bits bits_filter_estimated_states[] = {
    {"gyro_bias", 0, 1, NULL},         {"accel_bias", 1, 1, NULL},
    {"gyro_scale_factor", 2, 1, NULL}, {"accel_scale_factor", 3, 1, NULL},
    {"antenna_offset", 4, 1, NULL},    {"auto_hard_iron", 5, 1, NULL},
    {"auto_soft_iron", 6, 1, NULL},
};
const struct mip_names mip_names_filter_estimated_states = {
    "filter.estimated_states", NULL, NULL, bits_filter_estimated_states, 7, 2,
};

static const char *const labels_filter_gnss_aiding_source[] = {"all_internal", "external",
                                                               "internal_1", "internal_2"};
static const uint8_t numbers_filter_gnss_aiding_source[] = {1, 2, 3, 4};
const struct mip_names mip_names_filter_gnss_aiding_source = {
    "filter.gnss_aiding_source",
    labels_filter_gnss_aiding_source,
    numbers_filter_gnss_aiding_source,
    NULL,
    4,
    1,
};
const char *mip_filter_gnss_aiding_source_name(uint8_t value) {
    return mip_value_name(&mip_names_filter_gnss_aiding_source, value);
}

static const char *const labels_filter_heading_type[] = {"true_heading", "magnetic_heading"};
static const uint8_t numbers_filter_heading_type[] = {1, 2};
const struct mip_names mip_names_filter_heading_type = {
    "filter.heading_type", labels_filter_heading_type, numbers_filter_heading_type, NULL, 2, 1,
};
const char *mip_filter_heading_type_name(uint8_t value) {
    return mip_value_name(&mip_names_filter_heading_type, value);
}

static const char *const labels_filter_heading_update_source[] = {"none",
                                                                  "mag",
                                                                  "gnss_velocity",
                                                                  "external",
                                                                  "gnss_velocity_and_mag",
                                                                  "gnss_velocity_and_external",
                                                                  "mag_and_external",
                                                                  "all"};
static const uint8_t numbers_filter_heading_update_source[] = {0, 1, 2, 3, 4, 5, 6, 7};
const struct mip_names mip_names_filter_heading_update_source = {
    "filter.heading_update_source",
    labels_filter_heading_update_source,
    numbers_filter_heading_update_source,
    NULL,
    8,
    1,
};
const char *mip_filter_heading_update_source_name(uint8_t value) {
    return mip_value_name(&mip_names_filter_heading_update_source, value);
}

static const struct mip_named_bits bits_filter_tare_axes[] = {
    {"roll", 0, 1, NULL},
    {"pitch", 1, 1, NULL},
    {"yaw", 2, 1, NULL},
};
const struct mip_names mip_names_filter_tare_axes = {
    "filter.tare_axes", NULL, NULL, bits_filter_tare_axes, 3, 1,
};

static const struct mip_named_bits bits_filter_measurement_flags[] = {
    {"accel", 0, 1, NULL},
    {"mag", 1, 1, NULL},
};
const struct mip_names mip_names_filter_measurement_flags = {
    "filter.measurement_flags", NULL, NULL, bits_filter_measurement_flags, 2, 2,
};

static const char *const labels_filter_mag_parameter_source[] = {"none", "wmm", "manual"};
static const uint8_t numbers_filter_mag_parameter_source[] = {1, 2, 3};
const struct mip_names mip_names_filter_mag_parameter_source = {
    "filter.mag_parameter_source",
    labels_filter_mag_parameter_source,
    numbers_filter_mag_parameter_source,
    NULL,
    3,
    1,
};
const char *mip_filter_mag_parameter_source_name(uint8_t value) {
    return mip_value_name(&mip_names_filter_mag_parameter_source, value);
}

static const char *const labels_filter_adaptive_measurement_selector[] = {"disabled", "fixed",
                                                                          "auto"};
static const uint8_t numbers_filter_adaptive_measurement_selector[] = {0, 1, 2};
const struct mip_names mip_names_filter_adaptive_measurement_selector = {
    "filter.adaptive_measurement_selector",
    labels_filter_adaptive_measurement_selector,
    numbers_filter_adaptive_measurement_selector,
    NULL,
    3,
    1,
};
const char *mip_filter_adaptive_measurement_selector_name(uint8_t value) {
    return mip_value_name(&mip_names_filter_adaptive_measurement_selector, value);
}

static const char *const labels_filter_altitude_aiding_source[] = {"none", "pressure"};
static const uint8_t numbers_filter_altitude_aiding_source[] = {0, 1};
const struct mip_names mip_names_filter_altitude_aiding_source = {
    "filter.altitude_aiding_source",
    labels_filter_altitude_aiding_source,
    numbers_filter_altitude_aiding_source,
    NULL,
    2,
    1,
};
const char *mip_filter_altitude_aiding_source_name(uint8_t value) {
    return mip_value_name(&mip_names_filter_altitude_aiding_source, value);
}

static const char *const labels_filter_pitch_roll_aiding_source[] = {"none", "gravity_vector"};
static const uint8_t numbers_filter_pitch_roll_aiding_source[] = {0, 1};
const struct mip_names mip_names_filter_pitch_roll_aiding_source = {
    "filter.pitch_roll_aiding_source",
    labels_filter_pitch_roll_aiding_source,
    numbers_filter_pitch_roll_aiding_source,
    NULL,
    2,
    1,
};
const char *mip_filter_pitch_roll_aiding_source_name(uint8_t value) {
    return mip_value_name(&mip_names_filter_pitch_roll_aiding_source, value);
}

static const char *const labels_filter_aiding_source[] = {"gnss_position_velocity",
                                                          "gnss_heading",
                                                          "altimeter",
                                                          "speed",
                                                          "mag",
                                                          "external_heading",
                                                          "external_altimeter",
                                                          "external_mag",
                                                          "body_frame_velocity",
                                                          "all"};
static const uint16_t numbers_filter_aiding_source[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 0xFFFF};
const struct mip_names mip_names_filter_aiding_source = {
    "filter.aiding_source", labels_filter_aiding_source, numbers_filter_aiding_source, NULL, 10, 2,
};
const char *mip_filter_aiding_source_name(uint16_t value) {
    return mip_value_name(&mip_names_filter_aiding_source, value);
}

static const char *const labels_filter_accel_constraint[] = {"none", "zero_accel"};
static const uint8_t numbers_filter_accel_constraint[] = {0, 1};
const struct mip_names mip_names_filter_accel_constraint = {
    "filter.accel_constraint",
    labels_filter_accel_constraint,
    numbers_filter_accel_constraint,
    NULL,
    2,
    1,
};
const char *mip_filter_accel_constraint_name(uint8_t value) {
    return mip_value_name(&mip_names_filter_accel_constraint, value);
}

static const char *const labels_filter_velocity_constraint[] = {"none", "zero_velocity",
                                                                "wheeled_vehicle"};
static const uint8_t numbers_filter_velocity_constraint[] = {0, 1, 2};
const struct mip_names mip_names_filter_velocity_constraint = {
    "filter.velocity_constraint",
    labels_filter_velocity_constraint,
    numbers_filter_velocity_constraint,
    NULL,
    3,
    1,
};
const char *mip_filter_velocity_constraint_name(uint8_t value) {
    return mip_value_name(&mip_names_filter_velocity_constraint, value);
}

static const char *const labels_filter_angular_constraint[] = {"none", "zero_angular_rate"};
static const uint8_t numbers_filter_angular_constraint[] = {0, 1};
const struct mip_names mip_names_filter_angular_constraint = {
    "filter.angular_constraint",
    labels_filter_angular_constraint,
    numbers_filter_angular_constraint,
    NULL,
    2,
    1,
};
const char *mip_filter_angular_constraint_name(uint8_t value) {
    return mip_value_name(&mip_names_filter_angular_constraint, value);
}

static const char *const labels_filter_initial_condition_source[] = {
    "auto_position_velocity_attitude", "auto_position_velocity_pitch_roll",
    "auto_position_velocity", "manual"};
static const uint8_t numbers_filter_initial_condition_source[] = {0, 1, 2, 3};
const struct mip_names mip_names_filter_initial_condition_source = {
    "filter.initial_condition_source",
    labels_filter_initial_condition_source,
    numbers_filter_initial_condition_source,
    NULL,
    4,
    1,
};
const char *mip_filter_initial_condition_source_name(uint8_t value) {
    return mip_value_name(&mip_names_filter_initial_condition_source, value);
}

static const struct mip_named_bits bits_filter_heading_alignment[] = {
    {"dual_antenna", 0, 1, NULL},
    {"kinematic", 1, 1, NULL},
    {"mag", 2, 1, NULL},
    {"external", 3, 1, NULL},
};
const struct mip_names mip_names_filter_heading_alignment = {
    "filter.heading_alignment", NULL, NULL, bits_filter_heading_alignment, 4, 1,
};

static const char *const labels_filter_reference_frame[] = {"ecef", "llh"};
static const uint8_t numbers_filter_reference_frame[] = {1, 2};
const struct mip_names mip_names_filter_reference_frame = {
    "filter.reference_frame",
    labels_filter_reference_frame,
    numbers_filter_reference_frame,
    NULL,
    2,
    1,
};
const char *mip_filter_reference_frame_name(uint8_t value) {
    return mip_value_name(&mip_names_filter_reference_frame, value);
}

static const char *const labels_filter_adaptive_level[] = {"off", "conservative", "moderate",
                                                           "aggressive"};
static const uint8_t numbers_filter_adaptive_level[] = {0, 1, 2, 3};
const struct mip_names mip_names_filter_adaptive_level = {
    "filter.adaptive_level",
    labels_filter_adaptive_level,
    numbers_filter_adaptive_level,
    NULL,
    4,
    1,
};
const char *mip_filter_adaptive_level_name(uint8_t value) {
    return mip_value_name(&mip_names_filter_adaptive_level, value);
}

static const char *const labels_filter_relative_position_source[] = {"auto", "manual"};
static const uint8_t numbers_filter_relative_position_source[] = {0, 1};
const struct mip_names mip_names_filter_relative_position_source = {
    "filter.relative_position_source",
    labels_filter_relative_position_source,
    numbers_filter_relative_position_source,
    NULL,
    2,
    1,
};
const char *mip_filter_relative_position_source_name(uint8_t value) {
    return mip_value_name(&mip_names_filter_relative_position_source, value);
}

static const char *const labels_filter_reference_point[] = {"vehicle"};
static const uint8_t numbers_filter_reference_point[] = {1};
const struct mip_names mip_names_filter_reference_point = {
    "filter.reference_point",
    labels_filter_reference_point,
    numbers_filter_reference_point,
    NULL,
    1,
    1,
};
const char *mip_filter_reference_point_name(uint8_t value) {
    return mip_value_name(&mip_names_filter_reference_point, value);
}

static const struct mip_named_bits bits_gnss_gps_signals[] = {
    {"l1ca", 0, 1, NULL},
    {"l2c", 1, 1, NULL},
    {"l5", 2, 1, NULL},
};
const struct mip_names mip_names_gnss_gps_signals = {
    "gnss.gps_signals", NULL, NULL, bits_gnss_gps_signals, 3, 1,
};

static const struct mip_named_bits bits_gnss_glonass_signals[] = {
    {"l1of", 0, 1, NULL},
    {"l2of", 1, 1, NULL},
};
const struct mip_names mip_names_gnss_glonass_signals = {
    "gnss.glonass_signals", NULL, NULL, bits_gnss_glonass_signals, 2, 1,
};

static const struct mip_named_bits bits_gnss_galileo_signals[] = {
    {"e1", 0, 1, NULL},
    {"e5b", 1, 1, NULL},
    {"e5a", 2, 1, NULL},
};
const struct mip_names mip_names_gnss_galileo_signals = {
    "gnss.galileo_signals", NULL, NULL, bits_gnss_galileo_signals, 3, 1,
};

static const struct mip_named_bits bits_gnss_beidou_signals[] = {
    {"b1", 0, 1, NULL},
    {"b2", 1, 1, NULL},
    {"b2a", 2, 1, NULL},
};
const struct mip_names mip_names_gnss_beidou_signals = {
    "gnss.beidou_signals", NULL, NULL, bits_gnss_beidou_signals, 3, 1,
};

static const char *const labels_gnss_spartn_connection[] = {"none", "network", "l_band"};
static const uint8_t numbers_gnss_spartn_connection[] = {0, 1, 2};
const struct mip_names mip_names_gnss_spartn_connection = {
    "gnss.spartn_connection",
    labels_gnss_spartn_connection,
    numbers_gnss_spartn_connection,
    NULL,
    3,
    1,
};
const char *mip_gnss_spartn_connection_name(uint8_t value) {
    return mip_value_name(&mip_names_gnss_spartn_connection, value);
}

static const char *const labels_rtk_connected_device[] = {"generic", "gq7"};
static const uint8_t numbers_rtk_connected_device[] = {0, 1};
const struct mip_names mip_names_rtk_connected_device = {
    "rtk.connected_device", labels_rtk_connected_device, numbers_rtk_connected_device, NULL, 2, 1,
};
const char *mip_rtk_connected_device_name(uint8_t value) {
    return mip_value_name(&mip_names_rtk_connected_device, value);
}

static const struct mip_named_bits bits_rtk_service_flags[] = {
    {"throttle", 0, 1, NULL},
    {"corrections_unavailable", 1, 1, NULL},
};
const struct mip_names mip_names_rtk_service_flags = {
    "rtk.service_flags", NULL, NULL, bits_rtk_service_flags, 2, 1,
};

static const char *const labels_rtk_storage_medium[] = {"external_flash", "sd"};
static const uint8_t numbers_rtk_storage_medium[] = {0, 1};
const struct mip_names mip_names_rtk_storage_medium = {
    "rtk.storage_medium", labels_rtk_storage_medium, numbers_rtk_storage_medium, NULL, 2, 1,
};
const char *mip_rtk_storage_medium_name(uint8_t value) {
    return mip_value_name(&mip_names_rtk_storage_medium, value);
}

static const char *const labels_rtk_led_action[] = {"none", "flash", "pulsate"};
static const uint8_t numbers_rtk_led_action[] = {0, 1, 2};
const struct mip_names mip_names_rtk_led_action = {
    "rtk.led_action", labels_rtk_led_action, numbers_rtk_led_action, NULL, 3, 1,
};
const char *mip_rtk_led_action_name(uint8_t value) {
    return mip_value_name(&mip_names_rtk_led_action, value);
}

static const char *const labels_aiding_frame_format[] = {"euler", "quaternion"};
static const uint8_t numbers_aiding_frame_format[] = {1, 2};
const struct mip_names mip_names_aiding_frame_format = {
    "aiding.aiding_frame_format",
    labels_aiding_frame_format,
    numbers_aiding_frame_format,
    NULL,
    2,
    1,
};
const char *mip_aiding_frame_format_name(uint8_t value) {
    return mip_value_name(&mip_names_aiding_frame_format, value);
}

static const char *const labels_aiding_echo_mode[] = {"suppress_ack", "standard", "response"};
static const uint8_t numbers_aiding_echo_mode[] = {0, 1, 2};
const struct mip_names mip_names_aiding_echo_mode = {
    "aiding.aiding_echo_mode", labels_aiding_echo_mode, numbers_aiding_echo_mode, NULL, 3, 1,
};
const char *mip_aiding_echo_mode_name(uint8_t value) {
    return mip_value_name(&mip_names_aiding_echo_mode, value);
}

static const char *const labels_aiding_timebase[] = {"internal_reference", "external_time",
                                                     "time_of_arrival"};
static const uint8_t numbers_aiding_timebase[] = {1, 2, 3};
const struct mip_names mip_names_aiding_timebase = {
    "aiding.timebase", labels_aiding_timebase, numbers_aiding_timebase, NULL, 3, 1,
};
const char *mip_aiding_timebase_name(uint8_t value) {
    return mip_value_name(&mip_names_aiding_timebase, value);
}

static const struct mip_named_bits bits_aiding_axis_flags[] = {
    {"x", 0, 1, NULL},
    {"y", 1, 1, NULL},
    {"z", 2, 1, NULL},
};
const struct mip_names mip_names_aiding_axis_flags = {
    "aiding.axis_flags", NULL, NULL, bits_aiding_axis_flags, 3, 2,
};

static const struct mip_named_bits bits_aiding_llh_axis_flags[] = {
    {"latitude", 0, 1, NULL},
    {"longitude", 1, 1, NULL},
    {"height", 2, 1, NULL},
};
const struct mip_names mip_names_aiding_llh_axis_flags = {
    "aiding.llh_axis_flags", NULL, NULL, bits_aiding_llh_axis_flags, 3, 2,
};

static const char *const labels_system_comm_interface[] = {"all",    "main",  "uart_1", "uart_2",
                                                           "uart_3", "usb_1", "usb_2"};
static const uint8_t numbers_system_comm_interface[] = {0, 1, 17, 18, 19, 33, 34};
const struct mip_names mip_names_system_comm_interface = {
    "system.comm_interface",
    labels_system_comm_interface,
    numbers_system_comm_interface,
    NULL,
    7,
    1,
};
const char *mip_system_comm_interface_name(uint8_t value) {
    return mip_value_name(&mip_names_system_comm_interface, value);
}

static const struct mip_named_bits bits_system_comm_protocols[] = {
    {"mip", 0, 1, NULL},
    {"nmea", 8, 1, NULL},
    {"rtcm", 9, 1, NULL},
    {"spartn", 24, 1, NULL},
};
const struct mip_names mip_names_system_comm_protocols = {
    "system.comm_protocols", NULL, NULL, bits_system_comm_protocols, 4, 4,
};

static const char *const labels_system_protocol_mode[] = {"standard", "sensor_direct",
                                                          "gnss_direct"};
static const uint8_t numbers_system_protocol_mode[] = {1, 2, 3};
const struct mip_names mip_names_system_protocol_mode = {
    "system.protocol_mode", labels_system_protocol_mode, numbers_system_protocol_mode, NULL, 3, 1,
};
const char *mip_system_protocol_mode_name(uint8_t value) {
    return mip_value_name(&mip_names_system_protocol_mode, value);
}

static const struct mip_named_bits bits_sensor_overrange_flags[] = {
    {"accel_x", 0, 1, NULL},   {"accel_y", 1, 1, NULL}, {"accel_z", 2, 1, NULL},
    {"gyro_x", 4, 1, NULL},    {"gyro_y", 5, 1, NULL},  {"gyro_z", 6, 1, NULL},
    {"mag_x", 8, 1, NULL},     {"mag_y", 9, 1, NULL},   {"mag_z", 10, 1, NULL},
    {"pressure", 12, 1, NULL},
};
const struct mip_names mip_names_sensor_overrange_flags = {
    "sensor.overrange_flags", NULL, NULL, bits_sensor_overrange_flags, 10, 2,
};

static const struct mip_named_bits bits_sensor_odometer_flags[] = {
    {"odometer", 0, 1, NULL},
};
const struct mip_names mip_names_sensor_odometer_flags = {
    "sensor.odometer_flags", NULL, NULL, bits_sensor_odometer_flags, 1, 2,
};

static const struct mip_named_bits bits_filter_data_valid_flags[] = {
    {"valid", 0, 1, NULL},
};
const struct mip_names mip_names_filter_data_valid_flags = {
    "filter_data.valid_flags", NULL, NULL, bits_filter_data_valid_flags, 1, 2,
};

static const struct mip_named_bits bits_filter_data_heading_source_flags[] = {
    {"mag", 0, 1, NULL},
    {"gnss_velocity", 1, 1, NULL},
    {"external", 2, 1, NULL},
};
const struct mip_names mip_names_filter_data_heading_source_flags = {
    "filter_data.heading_source_flags", NULL, NULL, bits_filter_data_heading_source_flags, 3, 2,
};

static const struct mip_named_bits bits_filter_data_gnss_aiding_status[] = {
    {"tight_coupling", 0, 1, NULL}, {"differential", 1, 1, NULL}, {"integer_fix", 2, 1, NULL},
    {"gps_l1", 3, 1, NULL},         {"gps_l2", 4, 1, NULL},       {"gps_l5", 5, 1, NULL},
    {"glonass_l1", 6, 1, NULL},     {"glonass_l2", 7, 1, NULL},   {"galileo_e1", 8, 1, NULL},
    {"galileo_e5", 9, 1, NULL},     {"galileo_e6", 10, 1, NULL},  {"beidou_b1", 11, 1, NULL},
    {"beidou_b2", 12, 1, NULL},     {"beidou_b3", 13, 1, NULL},   {"no_fix", 14, 1, NULL},
    {"config_error", 15, 1, NULL},
};
const struct mip_names mip_names_filter_data_gnss_aiding_status = {
    "filter_data.gnss_aiding_status", NULL, NULL, bits_filter_data_gnss_aiding_status, 16, 2,
};

static const char *const labels_filter_data_heading_aiding_type[] = {"dual_antenna",
                                                                     "external_message"};
static const uint8_t numbers_filter_data_heading_aiding_type[] = {1, 2};
const struct mip_names mip_names_filter_data_heading_aiding_type = {
    "filter_data.heading_aiding_type",
    labels_filter_data_heading_aiding_type,
    numbers_filter_data_heading_aiding_type,
    NULL,
    2,
    1,
};
const char *mip_filter_data_heading_aiding_type_name(uint8_t value) {
    return mip_value_name(&mip_names_filter_data_heading_aiding_type, value);
}

static const char *const labels_filter_data_aiding_type[] = {"gnss",
                                                             "dual_antenna",
                                                             "heading",
                                                             "pressure",
                                                             "mag",
                                                             "speed",
                                                             "aiding_ecef_position",
                                                             "aiding_llh_position",
                                                             "aiding_height_above_ellipsoid",
                                                             "aiding_ecef_velocity",
                                                             "aiding_ned_velocity",
                                                             "aiding_body_frame_velocity",
                                                             "aiding_true_heading",
                                                             "aiding_magnetic_field",
                                                             "aiding_pressure"};
static const uint8_t numbers_filter_data_aiding_type[] = {1,  2,  3,  4,  5,  6,  33, 34,
                                                          35, 40, 41, 42, 49, 50, 51};
const struct mip_names mip_names_filter_data_aiding_type = {
    "filter_data.aiding_measurement_type",
    labels_filter_data_aiding_type,
    numbers_filter_data_aiding_type,
    NULL,
    15,
    1,
};
const char *mip_filter_data_aiding_type_name(uint8_t value) {
    return mip_value_name(&mip_names_filter_data_aiding_type, value);
}

static const struct mip_named_bits bits_filter_data_aiding_indicator[] = {
    {"enabled", 0, 1, NULL},
    {"used", 1, 1, NULL},
    {"residual_high_warning", 2, 1, NULL},
    {"sample_time_warning", 3, 1, NULL},
    {"config_error", 4, 1, NULL},
    {"max_measurements_exceeded", 5, 1, NULL},
};
const struct mip_names mip_names_filter_data_aiding_indicator = {
    "filter_data.aiding_measurement_indicator", NULL, NULL, bits_filter_data_aiding_indicator, 6, 1,
};

static const char *const labels_filter_data_dual_antenna_fix_type[] = {"fix_none", "fix_da_float",
                                                                       "fix_da_fixed"};
static const uint8_t numbers_filter_data_dual_antenna_fix_type[] = {0, 1, 2};
const struct mip_names mip_names_filter_data_dual_antenna_fix_type = {
    "filter_data.dual_antenna_fix_type",
    labels_filter_data_dual_antenna_fix_type,
    numbers_filter_data_dual_antenna_fix_type,
    NULL,
    3,
    1,
};
const char *mip_filter_data_dual_antenna_fix_type_name(uint8_t value) {
    return mip_value_name(&mip_names_filter_data_dual_antenna_fix_type, value);
}

static const struct mip_named_bits bits_filter_data_dual_antenna_status_flags[] = {
    {"receiver_1_data_valid", 0, 1, NULL},
    {"receiver_2_data_valid", 1, 1, NULL},
    {"antenna_offsets_valid", 2, 1, NULL},
};
const struct mip_names mip_names_filter_data_dual_antenna_status_flags = {
    "filter_data.dual_antenna_status_flags",    NULL, NULL,
    bits_filter_data_dual_antenna_status_flags, 3,    2,
};

static const char *const labels_filter_data_gx5_filter_state[] = {
    "startup", "init", "run_solution_valid", "run_solution_error"};
static const uint16_t numbers_filter_data_gx5_filter_state[] = {0, 1, 2, 3};
const struct mip_names mip_names_filter_data_gx5_filter_state = {
    "filter_data.gx5_filter_state",
    labels_filter_data_gx5_filter_state,
    numbers_filter_data_gx5_filter_state,
    NULL,
    4,
    2,
};
const char *mip_filter_data_gx5_filter_state_name(uint16_t value) {
    return mip_value_name(&mip_names_filter_data_gx5_filter_state, value);
}

static const char *const labels_filter_data_cv7_filter_state[] = {"init", "vertical_gyro", "ahrs",
                                                                  "full_nav"};
static const uint16_t numbers_filter_data_cv7_filter_state[] = {1, 2, 3, 4};
const struct mip_names mip_names_filter_data_cv7_filter_state = {
    "filter_data.cv7_filter_state",
    labels_filter_data_cv7_filter_state,
    numbers_filter_data_cv7_filter_state,
    NULL,
    4,
    2,
};
const char *mip_filter_data_cv7_filter_state_name(uint16_t value) {
    return mip_value_name(&mip_names_filter_data_cv7_filter_state, value);
}

static const char *const labels_filter_data_gx5_dynamics_mode[] = {"portable", "automotive",
                                                                   "airborne"};
static const uint16_t numbers_filter_data_gx5_dynamics_mode[] = {1, 2, 3};
const struct mip_names mip_names_filter_data_gx5_dynamics_mode = {
    "filter_data.gx5_dynamics_mode",
    labels_filter_data_gx5_dynamics_mode,
    numbers_filter_data_gx5_dynamics_mode,
    NULL,
    3,
    2,
};
const char *mip_filter_data_gx5_dynamics_mode_name(uint16_t value) {
    return mip_value_name(&mip_names_filter_data_gx5_dynamics_mode, value);
}

static const char *const labels_filter_data_cv7_dynamics_mode[] = {"default"};
static const uint16_t numbers_filter_data_cv7_dynamics_mode[] = {1};
const struct mip_names mip_names_filter_data_cv7_dynamics_mode = {
    "filter_data.cv7_dynamics_mode",
    labels_filter_data_cv7_dynamics_mode,
    numbers_filter_data_cv7_dynamics_mode,
    NULL,
    1,
    2,
};
const char *mip_filter_data_cv7_dynamics_mode_name(uint16_t value) {
    return mip_value_name(&mip_names_filter_data_cv7_dynamics_mode, value);
}

static const struct mip_named_bits bits_filter_data_gx5_status_flags[] = {
    {"run_imu_unavailable", 0, 1, NULL},
    {"run_gps_unavailable", 1, 1, NULL},
    {"run_matrix_singularity", 3, 1, NULL},
    {"run_position_covariance_warning", 4, 1, NULL},
    {"run_velocity_covariance_warning", 5, 1, NULL},
    {"run_attitude_covariance_warning", 6, 1, NULL},
    {"run_nan_in_solution_warning", 7, 1, NULL},
    {"run_gyro_bias_est_high_warning", 8, 1, NULL},
    {"run_accel_bias_est_high_warning", 9, 1, NULL},
    {"run_gyro_scale_factor_est_high_warning", 10, 1, NULL},
    {"run_accel_scale_factor_est_high_warning", 11, 1, NULL},
    {"run_mag_bias_est_high_warning", 12, 1, NULL},
    {"run_antenna_offset_correction_est_high_warning", 13, 1, NULL},
    {"run_mag_hard_iron_est_high_warning", 14, 1, NULL},
    {"run_mag_soft_iron_est_high_warning", 15, 1, NULL},
    {"init_no_attitude", 12, 1, NULL},
    {"init_no_position_velocity", 13, 1, NULL},
};
const struct mip_names mip_names_filter_data_gx5_status_flags = {
    "filter_data.gx5_status_flags", NULL, NULL, bits_filter_data_gx5_status_flags, 17, 2,
};

static const char *const labels_filter_data_filter_condition[] = {"stable", "converging",
                                                                  "unstable"};
static const uint8_t numbers_filter_data_filter_condition[] = {1, 2, 3};
const struct mip_names mip_names_filter_data_filter_condition = {
    "filter_data.filter_condition",
    labels_filter_data_filter_condition,
    numbers_filter_data_filter_condition,
    NULL,
    3,
    1,
};
const char *mip_filter_data_filter_condition_name(uint8_t value) {
    return mip_value_name(&mip_names_filter_data_filter_condition, value);
}

static const struct mip_named_bits bits_filter_data_cv7_status_flags[] = {
    {"filter_condition", 0, 2, &mip_names_filter_data_filter_condition},
    {"roll_pitch_warning", 2, 1, NULL},
    {"heading_warning", 3, 1, NULL},
    {"position_warning", 4, 1, NULL},
    {"velocity_warning", 5, 1, NULL},
    {"imu_bias_warning", 6, 1, NULL},
    {"gnss_clock_warning", 7, 1, NULL},
    {"antenna_lever_arm_warning", 8, 1, NULL},
    {"mounting_transform_warning", 9, 1, NULL},
    {"time_sync_warning", 10, 1, NULL},
    {"solution_error", 12, 4, NULL},
};
const struct mip_names mip_names_filter_data_cv7_status_flags = {
    "filter_data.cv7_status_flags", NULL, NULL, bits_filter_data_cv7_status_flags, 11, 2,
};

static const struct mip_named_bits bits_gnss_1_llh_position_flags[] = {
    {"lat_lon", 0, 1, NULL},           {"ellipsoid_height", 1, 1, NULL},
    {"msl_height", 2, 1, NULL},        {"horizontal_accuracy", 3, 1, NULL},
    {"vertical_accuracy", 4, 1, NULL}, {"flags", 0, 5, NULL},
};
const struct mip_names mip_names_gnss_1_llh_position_flags = {
    "gnss_1.llh_position_flags", NULL, NULL, bits_gnss_1_llh_position_flags, 6, 2,
};

static const struct mip_named_bits bits_gnss_1_ecef_position_flags[] = {
    {"position", 0, 1, NULL},
    {"position_accuracy", 1, 1, NULL},
    {"flags", 0, 2, NULL},
};
const struct mip_names mip_names_gnss_1_ecef_position_flags = {
    "gnss_1.ecef_position_flags", NULL, NULL, bits_gnss_1_ecef_position_flags, 3, 2,
};

static const struct mip_named_bits bits_gnss_1_ned_velocity_flags[] = {
    {"velocity", 0, 1, NULL}, {"speed_3d", 1, 1, NULL},       {"ground_speed", 2, 1, NULL},
    {"heading", 3, 1, NULL},  {"speed_accuracy", 4, 1, NULL}, {"heading_accuracy", 5, 1, NULL},
    {"flags", 0, 6, NULL},
};
const struct mip_names mip_names_gnss_1_ned_velocity_flags = {
    "gnss_1.ned_velocity_flags", NULL, NULL, bits_gnss_1_ned_velocity_flags, 7, 2,
};

static const struct mip_named_bits bits_gnss_1_ecef_velocity_flags[] = {
    {"velocity", 0, 1, NULL},
    {"velocity_accuracy", 1, 1, NULL},
    {"flags", 0, 2, NULL},
};
const struct mip_names mip_names_gnss_1_ecef_velocity_flags = {
    "gnss_1.ecef_velocity_flags", NULL, NULL, bits_gnss_1_ecef_velocity_flags, 3, 2,
};

static const struct mip_named_bits bits_gnss_1_dop_flags[] = {
    {"gdop", 0, 1, NULL}, {"pdop", 1, 1, NULL}, {"hdop", 2, 1, NULL}, {"vdop", 3, 1, NULL},
    {"tdop", 4, 1, NULL}, {"ndop", 5, 1, NULL}, {"edop", 6, 1, NULL}, {"flags", 0, 7, NULL},
};
const struct mip_names mip_names_gnss_1_dop_flags = {
    "gnss_1.dop_flags", NULL, NULL, bits_gnss_1_dop_flags, 8, 2,
};

static const struct mip_named_bits bits_gnss_1_utc_time_flags[] = {
    {"gnss_date_time", 0, 1, NULL},
    {"leap_seconds_known", 1, 1, NULL},
    {"flags", 0, 2, NULL},
};
const struct mip_names mip_names_gnss_1_utc_time_flags = {
    "gnss_1.utc_time_flags", NULL, NULL, bits_gnss_1_utc_time_flags, 3, 2,
};

static const struct mip_named_bits bits_gnss_1_gps_time_flags[] = {
    {"tow", 0, 1, NULL},
    {"week_number", 1, 1, NULL},
    {"flags", 0, 2, NULL},
};
const struct mip_names mip_names_gnss_1_gps_time_flags = {
    "gnss_1.gps_time_flags", NULL, NULL, bits_gnss_1_gps_time_flags, 3, 2,
};

static const struct mip_named_bits bits_gnss_1_clock_info_flags[] = {
    {"bias", 0, 1, NULL},
    {"drift", 1, 1, NULL},
    {"accuracy_estimate", 2, 1, NULL},
    {"flags", 0, 3, NULL},
};
const struct mip_names mip_names_gnss_1_clock_info_flags = {
    "gnss_1.clock_info_flags", NULL, NULL, bits_gnss_1_clock_info_flags, 4, 2,
};

static const struct mip_named_bits bits_gnss_1_fix_flags[] = {
    {"sbas_used", 0, 1, NULL},
    {"dgnss_used", 1, 1, NULL},
};
const struct mip_names mip_names_gnss_1_fix_flags = {
    "gnss_1.fix_flags", NULL, NULL, bits_gnss_1_fix_flags, 2, 2,
};

static const struct mip_named_bits bits_gnss_1_fix_info_flags[] = {
    {"fix_type", 0, 1, NULL},
    {"num_sv", 1, 1, NULL},
    {"fix_flags", 2, 1, NULL},
    {"flags", 0, 3, NULL},
};
const struct mip_names mip_names_gnss_1_fix_info_flags = {
    "gnss_1.fix_info_flags", NULL, NULL, bits_gnss_1_fix_info_flags, 4, 2,
};

static const struct mip_named_bits bits_gnss_1_sv_flags[] = {
    {"used_for_navigation", 0, 1, NULL},
    {"healthy", 1, 1, NULL},
};
const struct mip_names mip_names_gnss_1_sv_flags = {
    "gnss_1.sv_flags", NULL, NULL, bits_gnss_1_sv_flags, 2, 2,
};

static const struct mip_named_bits bits_gnss_1_sv_info_flags[] = {
    {"channel", 0, 1, NULL}, {"satellite_id", 1, 1, NULL}, {"carrier_noise_ratio", 2, 1, NULL},
    {"azimuth", 3, 1, NULL}, {"elevation", 4, 1, NULL},    {"sv_flags", 5, 1, NULL},
    {"flags", 0, 6, NULL},
};
const struct mip_names mip_names_gnss_1_sv_info_flags = {
    "gnss_1.sv_info_flags", NULL, NULL, bits_gnss_1_sv_info_flags, 7, 2,
};

static const char *const labels_gnss_1_receiver_state[] = {"off", "on", "unknown"};
static const uint8_t numbers_gnss_1_receiver_state[] = {0, 1, 2};
const struct mip_names mip_names_gnss_1_receiver_state = {
    "gnss_1.receiver_state",
    labels_gnss_1_receiver_state,
    numbers_gnss_1_receiver_state,
    NULL,
    3,
    1,
};
const char *mip_gnss_1_receiver_state_name(uint8_t value) {
    return mip_value_name(&mip_names_gnss_1_receiver_state, value);
}

static const char *const labels_gnss_1_antenna_state[] = {"init", "short", "open", "good",
                                                          "unknown"};
static const uint8_t numbers_gnss_1_antenna_state[] = {1, 2, 3, 4, 5};
const struct mip_names mip_names_gnss_1_antenna_state = {
    "gnss_1.antenna_state", labels_gnss_1_antenna_state, numbers_gnss_1_antenna_state, NULL, 5, 1,
};
const char *mip_gnss_1_antenna_state_name(uint8_t value) {
    return mip_value_name(&mip_names_gnss_1_antenna_state, value);
}

static const char *const labels_gnss_1_antenna_power[] = {"off", "on", "unknown"};
static const uint8_t numbers_gnss_1_antenna_power[] = {0, 1, 2};
const struct mip_names mip_names_gnss_1_antenna_power = {
    "gnss_1.antenna_power", labels_gnss_1_antenna_power, numbers_gnss_1_antenna_power, NULL, 3, 1,
};
const char *mip_gnss_1_antenna_power_name(uint8_t value) {
    return mip_value_name(&mip_names_gnss_1_antenna_power, value);
}

static const struct mip_named_bits bits_gnss_1_hardware_status_flags[] = {
    {"sensor_state", 0, 1, NULL},
    {"antenna_state", 1, 1, NULL},
    {"antenna_power", 2, 1, NULL},
    {"flags", 0, 3, NULL},
};
const struct mip_names mip_names_gnss_1_hardware_status_flags = {
    "gnss_1.hardware_status_flags", NULL, NULL, bits_gnss_1_hardware_status_flags, 4, 2,
};

static const struct mip_named_bits bits_gnss_1_dgps_info_flags[] = {
    {"age", 0, 1, NULL},
    {"base_station_id", 1, 1, NULL},
    {"base_station_status", 2, 1, NULL},
    {"num_channels", 3, 1, NULL},
    {"flags", 0, 4, NULL},
};
const struct mip_names mip_names_gnss_1_dgps_info_flags = {
    "gnss_1.dgps_info_flags", NULL, NULL, bits_gnss_1_dgps_info_flags, 5, 2,
};

static const struct mip_named_bits bits_gnss_1_dgps_channel_flags[] = {
    {"satellite_id", 0, 1, NULL},          {"age", 1, 1, NULL},   {"range_correction", 2, 1, NULL},
    {"range_rate_correction", 3, 1, NULL}, {"flags", 0, 4, NULL},
};
const struct mip_names mip_names_gnss_1_dgps_channel_flags = {
    "gnss_1.dgps_channel_flags", NULL, NULL, bits_gnss_1_dgps_channel_flags, 5, 2,
};

static const struct mip_named_bits bits_gnss_1_clock_info_2_flags[] = {
    {"bias", 0, 1, NULL},           {"drift", 1, 1, NULL}, {"bias_accuracy", 2, 1, NULL},
    {"drift_accuracy", 3, 1, NULL}, {"flags", 0, 4, NULL},
};
const struct mip_names mip_names_gnss_1_clock_info_2_flags = {
    "gnss_1.clock_info_2_flags", NULL, NULL, bits_gnss_1_clock_info_2_flags, 5, 2,
};

static const struct mip_named_bits bits_gnss_1_gps_leap_seconds_flags[] = {
    {"leap_seconds", 1, 1, NULL},
};
const struct mip_names mip_names_gnss_1_gps_leap_seconds_flags = {
    "gnss_1.gps_leap_seconds_flags", NULL, NULL, bits_gnss_1_gps_leap_seconds_flags, 1, 2,
};

static const char *const labels_gnss_1_sbas_system[] = {"unknown", "waas", "egnos", "msas",
                                                        "gagan"};
static const uint8_t numbers_gnss_1_sbas_system[] = {0, 1, 2, 3, 4};
const struct mip_names mip_names_gnss_1_sbas_system = {
    "gnss_1.sbas_system", labels_gnss_1_sbas_system, numbers_gnss_1_sbas_system, NULL, 5, 1,
};
const char *mip_gnss_1_sbas_system_name(uint8_t value) {
    return mip_value_name(&mip_names_gnss_1_sbas_system, value);
}

static const struct mip_named_bits bits_gnss_1_sbas_status[] = {
    {"range_available", 0, 1, NULL},
    {"corrections_available", 1, 1, NULL},
    {"integrity_available", 2, 1, NULL},
    {"test_mode", 3, 1, NULL},
};
const struct mip_names mip_names_gnss_1_sbas_status = {
    "gnss_1.sbas_status", NULL, NULL, bits_gnss_1_sbas_status, 4, 1,
};

static const struct mip_named_bits bits_gnss_1_sbas_info_flags[] = {
    {"tow", 0, 1, NULL},     {"week_number", 1, 1, NULL}, {"sbas_system", 2, 1, NULL},
    {"sbas_id", 3, 1, NULL}, {"count", 4, 1, NULL},       {"sbas_status", 5, 1, NULL},
    {"flags", 0, 6, NULL},
};
const struct mip_names mip_names_gnss_1_sbas_info_flags = {
    "gnss_1.sbas_info_flags", NULL, NULL, bits_gnss_1_sbas_info_flags, 7, 2,
};

static const struct mip_named_bits bits_gnss_1_sbas_correction_flags[] = {
    {"udrei", 0, 1, NULL},
    {"pseudorange_correction", 1, 1, NULL},
    {"iono_correction", 2, 1, NULL},
    {"flags", 0, 3, NULL},
};
const struct mip_names mip_names_gnss_1_sbas_correction_flags = {
    "gnss_1.sbas_correction_flags", NULL, NULL, bits_gnss_1_sbas_correction_flags, 4, 2,
};

static const char *const labels_gnss_1_rf_band[] = {"unknown", "l1", "l2", "l5"};
static const uint8_t numbers_gnss_1_rf_band[] = {0, 1, 2, 5};
const struct mip_names mip_names_gnss_1_rf_band = {
    "gnss_1.rf_band", labels_gnss_1_rf_band, numbers_gnss_1_rf_band, NULL, 4, 1,
};
const char *mip_gnss_1_rf_band_name(uint8_t value) {
    return mip_value_name(&mip_names_gnss_1_rf_band, value);
}

static const char *const labels_gnss_1_jamming_state[] = {"unknown", "none", "partial",
                                                          "significant"};
static const uint8_t numbers_gnss_1_jamming_state[] = {0, 1, 2, 3};
const struct mip_names mip_names_gnss_1_jamming_state = {
    "gnss_1.jamming_state", labels_gnss_1_jamming_state, numbers_gnss_1_jamming_state, NULL, 4, 1,
};
const char *mip_gnss_1_jamming_state_name(uint8_t value) {
    return mip_value_name(&mip_names_gnss_1_jamming_state, value);
}

static const char *const labels_gnss_1_spoofing_state[] = {"unknown", "none", "partial",
                                                           "significant"};
static const uint8_t numbers_gnss_1_spoofing_state[] = {0, 1, 2, 3};
const struct mip_names mip_names_gnss_1_spoofing_state = {
    "gnss_1.spoofing_state",
    labels_gnss_1_spoofing_state,
    numbers_gnss_1_spoofing_state,
    NULL,
    4,
    1,
};
const char *mip_gnss_1_spoofing_state_name(uint8_t value) {
    return mip_value_name(&mip_names_gnss_1_spoofing_state, value);
}

static const struct mip_named_bits bits_gnss_1_rf_error_detection_flags[] = {
    {"rf_band", 0, 1, NULL},
    {"jamming_state", 1, 1, NULL},
    {"spoofing_state", 2, 1, NULL},
    {"flags", 0, 3, NULL},
};
const struct mip_names mip_names_gnss_1_rf_error_detection_flags = {
    "gnss_1.rf_error_detection_flags", NULL, NULL, bits_gnss_1_rf_error_detection_flags, 4, 2,
};

static const struct mip_named_bits bits_gnss_1_satellite_status_flags[] = {
    {"tow", 0, 1, NULL},          {"week_number", 1, 1, NULL}, {"gnss_id", 2, 1, NULL},
    {"satellite_id", 3, 1, NULL}, {"elevation", 4, 1, NULL},   {"azimuth", 5, 1, NULL},
    {"health", 6, 1, NULL},       {"flags", 0, 7, NULL},
};
const struct mip_names mip_names_gnss_1_satellite_status_flags = {
    "gnss_1.satellite_status_flags", NULL, NULL, bits_gnss_1_satellite_status_flags, 8, 2,
};

static const char *const labels_gnss_1_signal_quality[] = {
    "none", "searching", "acquired", "unusable", "time_locked", "fully_locked"};
static const uint8_t numbers_gnss_1_signal_quality[] = {0, 1, 2, 3, 4, 5};
const struct mip_names mip_names_gnss_1_signal_quality = {
    "gnss_1.signal_quality",
    labels_gnss_1_signal_quality,
    numbers_gnss_1_signal_quality,
    NULL,
    6,
    1,
};
const char *mip_gnss_1_signal_quality_name(uint8_t value) {
    return mip_value_name(&mip_names_gnss_1_signal_quality, value);
}

static const struct mip_named_bits bits_gnss_1_raw_flags[] = {
    {"tow", 0, 1, NULL},
    {"week_number", 1, 1, NULL},
    {"receiver_id", 2, 1, NULL},
    {"tracking_channel", 3, 1, NULL},
    {"gnss_id", 4, 1, NULL},
    {"satellite_id", 5, 1, NULL},
    {"signal_id", 6, 1, NULL},
    {"signal_strength", 7, 1, NULL},
    {"quality", 8, 1, NULL},
    {"pseudorange", 9, 1, NULL},
    {"carrier_phase", 10, 1, NULL},
    {"doppler", 11, 1, NULL},
    {"range_uncertainty", 12, 1, NULL},
    {"carrier_phase_uncertainty", 13, 1, NULL},
    {"doppler_uncertainty", 14, 1, NULL},
    {"lock_time", 15, 1, NULL},
    {"flags", 0, 16, NULL},
};
const struct mip_names mip_names_gnss_1_raw_flags = {
    "gnss_1.raw_flags", NULL, NULL, bits_gnss_1_raw_flags, 17, 2,
};

static const struct mip_named_bits bits_gnss_1_base_station_indicators[] = {
    {"gps", 0, 1, NULL},
    {"glonass", 1, 1, NULL},
    {"galileo", 2, 1, NULL},
    {"beidou", 3, 1, NULL},
    {"reference_station", 4, 1, NULL},
    {"single_receiver", 5, 1, NULL},
    {"quarter_cycle_bit1", 6, 1, NULL},
    {"quarter_cycle_bit2", 7, 1, NULL},
    {"quarter_cycle_bits", 6, 2, NULL},
};
const struct mip_names mip_names_gnss_1_base_station_indicators = {
    "gnss_1.base_station_indicators", NULL, NULL, bits_gnss_1_base_station_indicators, 9, 2,
};

static const struct mip_named_bits bits_gnss_1_base_station_info_flags[] = {
    {"tow", 0, 1, NULL},    {"week_number", 1, 1, NULL}, {"ecef_position", 2, 1, NULL},
    {"height", 3, 1, NULL}, {"station_id", 4, 1, NULL},  {"indicators", 5, 1, NULL},
    {"flags", 0, 6, NULL},
};
const struct mip_names mip_names_gnss_1_base_station_info_flags = {
    "gnss_1.base_station_info_flags", NULL, NULL, bits_gnss_1_base_station_info_flags, 7, 2,
};

static const struct mip_named_bits bits_gnss_1_rtk_epoch_status[] = {
    {"antenna_location_received", 0, 1, NULL},
    {"antenna_description_received", 1, 1, NULL},
    {"gps_received", 2, 1, NULL},
    {"glonass_received", 3, 1, NULL},
    {"galileo_received", 4, 1, NULL},
    {"beidou_received", 5, 1, NULL},
    {"using_gps_msm_messages", 6, 1, NULL},
    {"using_glonass_msm_messages", 7, 1, NULL},
    {"dongle_status_read_failed", 8, 1, NULL},
};
const struct mip_names mip_names_gnss_1_rtk_epoch_status = {
    "gnss_1.rtk_epoch_status", NULL, NULL, bits_gnss_1_rtk_epoch_status, 9, 2,
};

static const struct mip_named_bits bits_gnss_1_rtk_corrections_status_flags[] = {
    {"tow", 0, 1, NULL},
    {"week_number", 1, 1, NULL},
    {"epoch_status", 2, 1, NULL},
    {"dongle_status", 3, 1, NULL},
    {"gps_latency", 4, 1, NULL},
    {"glonass_latency", 5, 1, NULL},
    {"galileo_latency", 6, 1, NULL},
    {"beidou_latency", 7, 1, NULL},
    {"flags", 0, 8, NULL},
};
const struct mip_names mip_names_gnss_1_rtk_corrections_status_flags = {
    "gnss_1.rtk_corrections_status_flags",    NULL, NULL,
    bits_gnss_1_rtk_corrections_status_flags, 9,    2,
};

static const struct mip_named_bits bits_gnss_1_ephemeris_flags[] = {
    {"ephemeris", 0, 1, NULL},
    {"modern_data", 1, 1, NULL},
    {"isc_l5", 2, 1, NULL},
    {"flags", 0, 3, NULL},
};
const struct mip_names mip_names_gnss_1_ephemeris_flags = {
    "gnss_1.ephemeris_flags", NULL, NULL, bits_gnss_1_ephemeris_flags, 4, 2,
};

static const char *const labels_gnss_1_glonass_satellite_type[] = {"glonass", "glonass_m"};
static const uint8_t numbers_gnss_1_glonass_satellite_type[] = {0, 1};
const struct mip_names mip_names_gnss_1_glonass_satellite_type = {
    "gnss_1.glonass_satellite_type",
    labels_gnss_1_glonass_satellite_type,
    numbers_gnss_1_glonass_satellite_type,
    NULL,
    2,
    1,
};
const char *mip_gnss_1_glonass_satellite_type_name(uint8_t value) {
    return mip_value_name(&mip_names_gnss_1_glonass_satellite_type, value);
}

static const struct mip_named_bits bits_gnss_1_glonass_ephemeris_flags[] = {
    {"ephemeris", 0, 1, NULL},
    {"flags", 0, 1, NULL},
};
const struct mip_names mip_names_gnss_1_glonass_ephemeris_flags = {
    "gnss_1.glonass_ephemeris_flags", NULL, NULL, bits_gnss_1_glonass_ephemeris_flags, 2, 2,
};

static const struct mip_named_bits bits_gnss_1_gps_iono_correction_flags[] = {
    {"tow", 0, 1, NULL},  {"week_number", 1, 1, NULL}, {"alpha", 2, 1, NULL},
    {"beta", 3, 1, NULL}, {"flags", 0, 4, NULL},
};
const struct mip_names mip_names_gnss_1_gps_iono_correction_flags = {
    "gnss_1.gps_iono_correction_flags", NULL, NULL, bits_gnss_1_gps_iono_correction_flags, 5, 2,
};

static const struct mip_named_bits bits_gnss_1_galileo_iono_correction_flags[] = {
    {"tow", 0, 1, NULL},   {"week_number", 1, 1, NULL},
    {"alpha", 2, 1, NULL}, {"disturbance_flags", 3, 1, NULL},
    {"flags", 0, 4, NULL},
};
const struct mip_names mip_names_gnss_1_galileo_iono_correction_flags = {
    "gnss_1.galileo_iono_correction_flags",    NULL, NULL,
    bits_gnss_1_galileo_iono_correction_flags, 5,    2,
};

static const struct mip_named_bits bits_gnss_1_beidou_iono_correction_flags[] = {
    {"tow", 0, 1, NULL},  {"week_number", 1, 1, NULL},      {"alpha", 2, 1, NULL},
    {"beta", 3, 1, NULL}, {"alpha_correction", 4, 1, NULL}, {"flags", 0, 5, NULL},
};
const struct mip_names mip_names_gnss_1_beidou_iono_correction_flags = {
    "gnss_1.beidou_iono_correction_flags",    NULL, NULL,
    bits_gnss_1_beidou_iono_correction_flags, 6,    2,
};

static const struct mip_named_bits bits_system_data_gpio_pin_states[] = {
    {"pin_1", 0, 1, NULL},
    {"pin_2", 1, 1, NULL},
    {"pin_3", 2, 1, NULL},
    {"pin_4", 3, 1, NULL},
};
const struct mip_names mip_names_system_data_gpio_pin_states = {
    "system_data.gpio_pin_states", NULL, NULL, bits_system_data_gpio_pin_states, 4, 1,
};

static const struct mip_named_bits bits_shared_gps_timestamp_flags[] = {
    {"tow", 0, 1, NULL},
    {"week_number", 1, 1, NULL},
    {"time_valid", 0, 2, NULL},
};
const struct mip_names mip_names_shared_gps_timestamp_flags = {
    "shared.gps_timestamp_flags", NULL, NULL, bits_shared_gps_timestamp_flags, 3, 2,
};

static const struct mip_named_bits bits_shared_external_timestamp_flags[] = {
    {"nanoseconds", 0, 1, NULL},
};
const struct mip_names mip_names_shared_external_timestamp_flags = {
    "shared.external_timestamp_flags", NULL, NULL, bits_shared_external_timestamp_flags, 1, 2,
};

static const struct mip_named_bits bits_shared_external_time_delta_flags[] = {
    {"dt_nanos", 0, 1, NULL},
};
const struct mip_names mip_names_shared_external_time_delta_flags = {
    "shared.external_time_delta_flags", NULL, NULL, bits_shared_external_time_delta_flags, 1, 2,
};

const struct mip_names *const mip_all_names[] = {
    &mip_names_function_selector,
    &mip_names_gx5_built_in_test,
    &mip_names_cv7_built_in_test,
    &mip_names_cv7_continuous_bit,
    &mip_names_event_trigger_type,
    &mip_names_event_action_type,
    &mip_names_event_trigger_mode,
    &mip_names_event_trigger_status,
    &mip_names_event_trigger_gpio_mode,
    &mip_names_event_threshold_type,
    &mip_names_event_action_gpio_mode,
    &mip_names_gnss_constellation,
    &mip_names_gnss_fix_type,
    &mip_names_gnss_signal,
    &mip_names_gpio_feature,
    &mip_names_gpio_unused_behavior,
    &mip_names_gpio_behavior,
    &mip_names_gpio_pps_behavior,
    &mip_names_gpio_encoder_behavior,
    &mip_names_gpio_timestamp_behavior,
    &mip_names_gpio_uart_behavior,
    &mip_names_gpio_pin_mode,
    &mip_names_nmea_message_id,
    &mip_names_nmea_talker_id,
    &mip_names_rtk_status_flags,
    &mip_names_rtk_status_flags_legacy,
    &mip_names_ack_code,
    &mip_names_sensor_gps_timestamp_flags,
    &mip_names_gx5_sensor_gps_timestamp_flags,
    &mip_names_base_gps_time_field,
    &mip_names_3dm_factory_streaming_action,
    &mip_names_3dm_constellation_id,
    &mip_names_3dm_constellation_options,
    &mip_names_3dm_sbas_options,
    &mip_names_3dm_assisted_fix_option,
    &mip_names_3dm_pps_source,
    &mip_names_3dm_event_support_query,
    &mip_names_3dm_odometer_mode,
    &mip_names_3dm_sensor_range_type,
    &mip_names_3dm_device_status_selector,
    &mip_names_3dm_legacy_data_stream,
    &mip_names_filter_dynamics_mode,
    &mip_names_filter_estimated_states,
    &mip_names_filter_gnss_aiding_source,
    &mip_names_filter_heading_type,
    &mip_names_filter_heading_update_source,
    &mip_names_filter_tare_axes,
    &mip_names_filter_measurement_flags,
    &mip_names_filter_mag_parameter_source,
    &mip_names_filter_adaptive_measurement_selector,
    &mip_names_filter_altitude_aiding_source,
    &mip_names_filter_pitch_roll_aiding_source,
    &mip_names_filter_aiding_source,
    &mip_names_filter_accel_constraint,
    &mip_names_filter_velocity_constraint,
    &mip_names_filter_angular_constraint,
    &mip_names_filter_initial_condition_source,
    &mip_names_filter_heading_alignment,
    &mip_names_filter_reference_frame,
    &mip_names_filter_adaptive_level,
    &mip_names_filter_relative_position_source,
    &mip_names_filter_reference_point,
    &mip_names_gnss_gps_signals,
    &mip_names_gnss_glonass_signals,
    &mip_names_gnss_galileo_signals,
    &mip_names_gnss_beidou_signals,
    &mip_names_gnss_spartn_connection,
    &mip_names_rtk_connected_device,
    &mip_names_rtk_service_flags,
    &mip_names_rtk_storage_medium,
    &mip_names_rtk_led_action,
    &mip_names_aiding_frame_format,
    &mip_names_aiding_echo_mode,
    &mip_names_aiding_timebase,
    &mip_names_aiding_axis_flags,
    &mip_names_aiding_llh_axis_flags,
    &mip_names_system_comm_interface,
    &mip_names_system_comm_protocols,
    &mip_names_system_protocol_mode,
    &mip_names_sensor_overrange_flags,
    &mip_names_sensor_odometer_flags,
    &mip_names_filter_data_valid_flags,
    &mip_names_filter_data_heading_source_flags,
    &mip_names_filter_data_gnss_aiding_status,
    &mip_names_filter_data_heading_aiding_type,
    &mip_names_filter_data_aiding_type,
    &mip_names_filter_data_aiding_indicator,
    &mip_names_filter_data_dual_antenna_fix_type,
    &mip_names_filter_data_dual_antenna_status_flags,
    &mip_names_filter_data_gx5_filter_state,
    &mip_names_filter_data_cv7_filter_state,
    &mip_names_filter_data_gx5_dynamics_mode,
    &mip_names_filter_data_cv7_dynamics_mode,
    &mip_names_filter_data_gx5_status_flags,
    &mip_names_filter_data_filter_condition,
    &mip_names_filter_data_cv7_status_flags,
    &mip_names_gnss_1_llh_position_flags,
    &mip_names_gnss_1_ecef_position_flags,
    &mip_names_gnss_1_ned_velocity_flags,
    &mip_names_gnss_1_ecef_velocity_flags,
    &mip_names_gnss_1_dop_flags,
    &mip_names_gnss_1_utc_time_flags,
    &mip_names_gnss_1_gps_time_flags,
    &mip_names_gnss_1_clock_info_flags,
    &mip_names_gnss_1_fix_flags,
    &mip_names_gnss_1_fix_info_flags,
    &mip_names_gnss_1_sv_flags,
    &mip_names_gnss_1_sv_info_flags,
    &mip_names_gnss_1_receiver_state,
    &mip_names_gnss_1_antenna_state,
    &mip_names_gnss_1_antenna_power,
    &mip_names_gnss_1_hardware_status_flags,
    &mip_names_gnss_1_dgps_info_flags,
    &mip_names_gnss_1_dgps_channel_flags,
    &mip_names_gnss_1_clock_info_2_flags,
    &mip_names_gnss_1_gps_leap_seconds_flags,
    &mip_names_gnss_1_sbas_system,
    &mip_names_gnss_1_sbas_status,
    &mip_names_gnss_1_sbas_info_flags,
    &mip_names_gnss_1_sbas_correction_flags,
    &mip_names_gnss_1_rf_band,
    &mip_names_gnss_1_jamming_state,
    &mip_names_gnss_1_spoofing_state,
    &mip_names_gnss_1_rf_error_detection_flags,
    &mip_names_gnss_1_satellite_status_flags,
    &mip_names_gnss_1_signal_quality,
    &mip_names_gnss_1_raw_flags,
    &mip_names_gnss_1_base_station_indicators,
    &mip_names_gnss_1_base_station_info_flags,
    &mip_names_gnss_1_rtk_epoch_status,
    &mip_names_gnss_1_rtk_corrections_status_flags,
    &mip_names_gnss_1_ephemeris_flags,
    &mip_names_gnss_1_glonass_satellite_type,
    &mip_names_gnss_1_glonass_ephemeris_flags,
    &mip_names_gnss_1_gps_iono_correction_flags,
    &mip_names_gnss_1_galileo_iono_correction_flags,
    &mip_names_gnss_1_beidou_iono_correction_flags,
    &mip_names_system_data_gpio_pin_states,
    &mip_names_shared_gps_timestamp_flags,
    &mip_names_shared_external_timestamp_flags,
    &mip_names_shared_external_time_delta_flags,
};
const size_t mip_all_names_count = sizeof(mip_all_names) / sizeof(mip_all_names[0]);
