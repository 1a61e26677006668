/**
 * @file
 * 3DM, in C++17: see mip/3dm.h.
 */
#ifndef MIP_3DM_HPP
#define MIP_3DM_HPP

#include "mip/3dm_inline.h"
#include "mip/cpp/types.hpp"

namespace mip {

MIP_LAYOUT(mip_3dm_poll_imu_data, MIP_3DM_POLL_IMU_DATA, MIP_3DM_POLL_IMU_DATA, "3dm.poll_imu_data",
           decode)
MIP_LAYOUT(mip_3dm_poll_gnss_data, MIP_3DM_POLL_GNSS_DATA, MIP_3DM_POLL_GNSS_DATA,
           "3dm.poll_gnss_data", decode)
MIP_LAYOUT(mip_3dm_poll_filter_data, MIP_3DM_POLL_FILTER_DATA, MIP_3DM_POLL_FILTER_DATA,
           "3dm.poll_filter_data", decode)
MIP_LAYOUT(mip_3dm_poll_nmea_data, MIP_3DM_POLL_NMEA_DATA, MIP_3DM_POLL_NMEA_DATA,
           "3dm.poll_nmea_data", decode)
MIP_LAYOUT(mip_3dm_get_imu_base_rate, MIP_3DM_GET_IMU_BASE_RATE, MIP_3DM_GET_IMU_BASE_RATE,
           "3dm.get_imu_base_rate", decode)
MIP_LAYOUT(mip_3dm_get_gnss_base_rate, MIP_3DM_GET_GNSS_BASE_RATE, MIP_3DM_GET_GNSS_BASE_RATE,
           "3dm.get_gnss_base_rate", decode)
MIP_LAYOUT(mip_3dm_imu_message_format, MIP_3DM_IMU_MESSAGE_FORMAT, MIP_3DM_IMU_MESSAGE_FORMAT,
           "3dm.imu_message_format", decode)
MIP_LAYOUT(mip_3dm_gnss_message_format, MIP_3DM_GNSS_MESSAGE_FORMAT, MIP_3DM_GNSS_MESSAGE_FORMAT,
           "3dm.gnss_message_format", decode)
MIP_LAYOUT(mip_3dm_filter_message_format, MIP_3DM_FILTER_MESSAGE_FORMAT,
           MIP_3DM_FILTER_MESSAGE_FORMAT, "3dm.filter_message_format", decode)
MIP_LAYOUT(mip_3dm_get_filter_base_rate, MIP_3DM_GET_FILTER_BASE_RATE, MIP_3DM_GET_FILTER_BASE_RATE,
           "3dm.get_filter_base_rate", decode)
MIP_LAYOUT(mip_3dm_nmea_message_format, MIP_3DM_NMEA_MESSAGE_FORMAT, MIP_3DM_NMEA_MESSAGE_FORMAT,
           "3dm.nmea_message_format", decode)
MIP_LAYOUT(mip_3dm_poll_data, MIP_3DM_POLL_DATA, MIP_3DM_POLL_DATA, "3dm.poll_data", decode)
MIP_LAYOUT(mip_3dm_get_base_rate, MIP_3DM_GET_BASE_RATE, MIP_3DM_GET_BASE_RATE, "3dm.get_base_rate",
           decode_inline)
MIP_LAYOUT(mip_3dm_message_format, MIP_3DM_MESSAGE_FORMAT, MIP_3DM_MESSAGE_FORMAT,
           "3dm.message_format", decode)
MIP_LAYOUT(mip_3dm_factory_streaming, MIP_3DM_FACTORY_STREAMING, MIP_3DM_FACTORY_STREAMING,
           "3dm.factory_streaming", decode_inline)
MIP_LAYOUT(mip_3dm_data_stream_control, MIP_3DM_DATA_STREAM_CONTROL, MIP_3DM_DATA_STREAM_CONTROL,
           "3dm.data_stream_control", decode)
MIP_LAYOUT(mip_3dm_raw_rtcm_2_3_message, MIP_3DM_RAW_RTCM_2_3_MESSAGE, MIP_3DM_RAW_RTCM_2_3_MESSAGE,
           "3dm.raw_rtcm_2_3_message", decode)
MIP_LAYOUT(mip_3dm_constellation_settings, MIP_3DM_CONSTELLATION_SETTINGS,
           MIP_3DM_CONSTELLATION_SETTINGS, "3dm.constellation_settings", decode)
MIP_LAYOUT(mip_3dm_gnss_sbas_settings, MIP_3DM_GNSS_SBAS_SETTINGS, MIP_3DM_GNSS_SBAS_SETTINGS,
           "3dm.gnss_sbas_settings", decode)
MIP_LAYOUT(mip_3dm_gnss_assisted_fix, MIP_3DM_GNSS_ASSISTED_FIX, MIP_3DM_GNSS_ASSISTED_FIX,
           "3dm.gnss_assisted_fix", decode)
MIP_LAYOUT(mip_3dm_gnss_time_assistance, MIP_3DM_GNSS_TIME_ASSISTANCE, MIP_3DM_GNSS_TIME_ASSISTANCE,
           "3dm.gnss_time_assistance", decode)
MIP_LAYOUT(mip_3dm_pps_source_control, MIP_3DM_PPS_SOURCE_CONTROL, MIP_3DM_PPS_SOURCE_CONTROL,
           "3dm.pps_source_control", decode)
MIP_LAYOUT(mip_3dm_get_event_support, MIP_3DM_GET_EVENT_SUPPORT, MIP_3DM_GET_EVENT_SUPPORT,
           "3dm.get_event_support", decode_inline)
MIP_LAYOUT(mip_3dm_event_control, MIP_3DM_EVENT_CONTROL, MIP_3DM_EVENT_CONTROL, "3dm.event_control",
           decode)
MIP_LAYOUT(mip_3dm_get_event_trigger_status, MIP_3DM_GET_EVENT_TRIGGER_STATUS,
           MIP_3DM_GET_EVENT_TRIGGER_STATUS, "3dm.get_event_trigger_status", decode)
MIP_LAYOUT(mip_3dm_get_event_action_status, MIP_3DM_GET_EVENT_ACTION_STATUS,
           MIP_3DM_GET_EVENT_ACTION_STATUS, "3dm.get_event_action_status", decode)
MIP_LAYOUT(mip_3dm_event_trigger_config, MIP_3DM_EVENT_TRIGGER_CONFIG, MIP_3DM_EVENT_TRIGGER_CONFIG,
           "3dm.event_trigger_config", decode)
MIP_LAYOUT(mip_3dm_event_action_config, MIP_3DM_EVENT_ACTION_CONFIG, MIP_3DM_EVENT_ACTION_CONFIG,
           "3dm.event_action_config", decode)
MIP_LAYOUT(mip_3dm_device_settings, MIP_3DM_DEVICE_SETTINGS, MIP_3DM_DEVICE_SETTINGS,
           "3dm.device_settings", decode_inline)
MIP_LAYOUT(mip_3dm_sensor_to_vehicle_transform_euler, MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_EULER,
           MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_EULER, "3dm.sensor_to_vehicle_transform_euler",
           decode)
MIP_LAYOUT(mip_3dm_sensor_to_vehicle_transform_quaternion,
           MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_QUATERNION,
           MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_QUATERNION,
           "3dm.sensor_to_vehicle_transform_quaternion", decode)
MIP_LAYOUT(mip_3dm_sensor_to_vehicle_transform_dcm, MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_DCM,
           MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_DCM, "3dm.sensor_to_vehicle_transform_dcm", decode)
MIP_LAYOUT(mip_3dm_gps_dynamics_mode, MIP_3DM_GPS_DYNAMICS_MODE, MIP_3DM_GPS_DYNAMICS_MODE,
           "3dm.gps_dynamics_mode", decode)
MIP_LAYOUT(mip_3dm_imu_signal_conditioning, MIP_3DM_IMU_SIGNAL_CONDITIONING,
           MIP_3DM_IMU_SIGNAL_CONDITIONING, "3dm.imu_signal_conditioning", decode)
MIP_LAYOUT(mip_3dm_imu_timestamp, MIP_3DM_IMU_TIMESTAMP, MIP_3DM_IMU_TIMESTAMP, "3dm.imu_timestamp",
           decode)
MIP_LAYOUT(mip_3dm_accel_bias, MIP_3DM_ACCEL_BIAS, MIP_3DM_ACCEL_BIAS, "3dm.accel_bias", decode)
MIP_LAYOUT(mip_3dm_gyro_bias, MIP_3DM_GYRO_BIAS, MIP_3DM_GYRO_BIAS, "3dm.gyro_bias", decode)
MIP_LAYOUT(mip_3dm_capture_gyro_bias, MIP_3DM_CAPTURE_GYRO_BIAS, MIP_3DM_CAPTURE_GYRO_BIAS,
           "3dm.capture_gyro_bias", decode_inline)
MIP_LAYOUT(mip_3dm_mag_hard_iron_offset, MIP_3DM_MAG_HARD_IRON_OFFSET, MIP_3DM_MAG_HARD_IRON_OFFSET,
           "3dm.mag_hard_iron_offset", decode)
MIP_LAYOUT(mip_3dm_mag_soft_iron_matrix, MIP_3DM_MAG_SOFT_IRON_MATRIX, MIP_3DM_MAG_SOFT_IRON_MATRIX,
           "3dm.mag_soft_iron_matrix", decode)
MIP_LAYOUT(mip_3dm_coning_sculling_enable, MIP_3DM_CONING_SCULLING_ENABLE,
           MIP_3DM_CONING_SCULLING_ENABLE, "3dm.coning_sculling_enable", decode)
MIP_LAYOUT(mip_3dm_uart_baud_rate, MIP_3DM_UART_BAUD_RATE, MIP_3DM_UART_BAUD_RATE,
           "3dm.uart_baud_rate", decode)
MIP_LAYOUT(mip_3dm_gpio_config, MIP_3DM_GPIO_CONFIG, MIP_3DM_GPIO_CONFIG, "3dm.gpio_config", decode)
MIP_LAYOUT(mip_3dm_gpio_state, MIP_3DM_GPIO_STATE, MIP_3DM_GPIO_STATE, "3dm.gpio_state", decode)
MIP_LAYOUT(mip_3dm_odometer_config, MIP_3DM_ODOMETER_CONFIG, MIP_3DM_ODOMETER_CONFIG,
           "3dm.odometer_config", decode)
MIP_LAYOUT(mip_3dm_imu_low_pass_filter, MIP_3DM_IMU_LOW_PASS_FILTER, MIP_3DM_IMU_LOW_PASS_FILTER,
           "3dm.imu_low_pass_filter", decode)
MIP_LAYOUT(mip_3dm_complementary_filter, MIP_3DM_COMPLEMENTARY_FILTER, MIP_3DM_COMPLEMENTARY_FILTER,
           "3dm.complementary_filter", decode)
MIP_LAYOUT(mip_3dm_sensor_range, MIP_3DM_SENSOR_RANGE, MIP_3DM_SENSOR_RANGE, "3dm.sensor_range",
           decode)
MIP_LAYOUT(mip_3dm_get_calibrated_sensor_ranges, MIP_3DM_GET_CALIBRATED_SENSOR_RANGES,
           MIP_3DM_GET_CALIBRATED_SENSOR_RANGES, "3dm.get_calibrated_sensor_ranges", decode_inline)
MIP_LAYOUT(mip_3dm_low_pass_filter, MIP_3DM_LOW_PASS_FILTER, MIP_3DM_LOW_PASS_FILTER,
           "3dm.low_pass_filter", decode)
MIP_LAYOUT(mip_3dm_data_stream_format, MIP_3DM_DATA_STREAM_FORMAT, MIP_3DM_DATA_STREAM_FORMAT,
           "3dm.data_stream_format", decode)
MIP_LAYOUT(mip_3dm_device_power_state, MIP_3DM_DEVICE_POWER_STATE, MIP_3DM_DEVICE_POWER_STATE,
           "3dm.device_power_state", decode)
MIP_LAYOUT(mip_3dm_gps_advanced_settings, MIP_3DM_GPS_ADVANCED_SETTINGS,
           MIP_3DM_GPS_ADVANCED_SETTINGS, "3dm.gps_advanced_settings", decode_inline)
MIP_LAYOUT(mip_3dm_device_status, MIP_3DM_DEVICE_STATUS, MIP_3DM_DEVICE_STATUS, "3dm.device_status",
           decode_inline)
MIP_LAYOUT(mip_3dm_imu_message_format_response, MIP_3DM_IMU_MESSAGE_FORMAT_RESPONSE,
           MIP_3DM_IMU_MESSAGE_FORMAT_RESPONSE, "3dm.imu_message_format_response", decode)
MIP_LAYOUT(mip_3dm_gnss_message_format_response, MIP_3DM_GNSS_MESSAGE_FORMAT_RESPONSE,
           MIP_3DM_GNSS_MESSAGE_FORMAT_RESPONSE, "3dm.gnss_message_format_response", decode)
MIP_LAYOUT(mip_3dm_filter_message_format_response, MIP_3DM_FILTER_MESSAGE_FORMAT_RESPONSE,
           MIP_3DM_FILTER_MESSAGE_FORMAT_RESPONSE, "3dm.filter_message_format_response", decode)
MIP_LAYOUT(mip_3dm_get_imu_base_rate_response, MIP_3DM_GET_IMU_BASE_RATE_RESPONSE,
           MIP_3DM_GET_IMU_BASE_RATE_RESPONSE, "3dm.get_imu_base_rate_response", decode_inline)
MIP_LAYOUT(mip_3dm_get_gnss_base_rate_response, MIP_3DM_GET_GNSS_BASE_RATE_RESPONSE,
           MIP_3DM_GET_GNSS_BASE_RATE_RESPONSE, "3dm.get_gnss_base_rate_response", decode_inline)
MIP_LAYOUT(mip_3dm_data_stream_control_response, MIP_3DM_DATA_STREAM_CONTROL_RESPONSE,
           MIP_3DM_DATA_STREAM_CONTROL_RESPONSE, "3dm.data_stream_control_response", decode_inline)
MIP_LAYOUT(mip_3dm_imu_signal_conditioning_response, MIP_3DM_IMU_SIGNAL_CONDITIONING_RESPONSE,
           MIP_3DM_IMU_SIGNAL_CONDITIONING_RESPONSE, "3dm.imu_signal_conditioning_response",
           decode_inline)
MIP_LAYOUT(mip_3dm_uart_baud_rate_response, MIP_3DM_UART_BAUD_RATE_RESPONSE,
           MIP_3DM_UART_BAUD_RATE_RESPONSE, "3dm.uart_baud_rate_response", decode_inline)
MIP_LAYOUT(mip_3dm_data_stream_format_response, MIP_3DM_DATA_STREAM_FORMAT_RESPONSE,
           MIP_3DM_DATA_STREAM_FORMAT_RESPONSE, "3dm.data_stream_format_response", decode_inline)
MIP_LAYOUT(mip_3dm_device_power_state_response, MIP_3DM_DEVICE_POWER_STATE_RESPONSE,
           MIP_3DM_DEVICE_POWER_STATE_RESPONSE, "3dm.device_power_state_response", decode_inline)
MIP_LAYOUT(mip_3dm_get_filter_base_rate_response, MIP_3DM_GET_FILTER_BASE_RATE_RESPONSE,
           MIP_3DM_GET_FILTER_BASE_RATE_RESPONSE, "3dm.get_filter_base_rate_response",
           decode_inline)
MIP_LAYOUT(mip_3dm_imu_low_pass_filter_response, MIP_3DM_IMU_LOW_PASS_FILTER_RESPONSE,
           MIP_3DM_IMU_LOW_PASS_FILTER_RESPONSE, "3dm.imu_low_pass_filter_response", decode_inline)
MIP_LAYOUT(mip_3dm_nmea_message_format_response, MIP_3DM_NMEA_MESSAGE_FORMAT_RESPONSE,
           MIP_3DM_NMEA_MESSAGE_FORMAT_RESPONSE, "3dm.nmea_message_format_response", decode)
MIP_LAYOUT(mip_3dm_get_base_rate_response, MIP_3DM_GET_BASE_RATE_RESPONSE,
           MIP_3DM_GET_BASE_RATE_RESPONSE, "3dm.get_base_rate_response", decode_inline)
MIP_LAYOUT(mip_3dm_message_format_response, MIP_3DM_MESSAGE_FORMAT_RESPONSE,
           MIP_3DM_MESSAGE_FORMAT_RESPONSE, "3dm.message_format_response", decode)
MIP_LAYOUT(mip_3dm_device_status_basic_rq1_imu_response,
           MIP_3DM_DEVICE_STATUS_BASIC_RQ1_IMU_RESPONSE,
           MIP_3DM_DEVICE_STATUS_BASIC_RQ1_IMU_RESPONSE, "3dm.device_status_basic_rq1_imu_response",
           decode)
MIP_LAYOUT(mip_3dm_device_status_basic_response, MIP_3DM_DEVICE_STATUS_BASIC_RESPONSE,
           MIP_3DM_DEVICE_STATUS_BASIC_RESPONSE, "3dm.device_status_basic_response", decode)
MIP_LAYOUT(mip_3dm_device_status_basic_without_state_response,
           MIP_3DM_DEVICE_STATUS_BASIC_WITHOUT_STATE_RESPONSE,
           MIP_3DM_DEVICE_STATUS_BASIC_WITHOUT_STATE_RESPONSE,
           "3dm.device_status_basic_without_state_response", decode)
MIP_LAYOUT(mip_3dm_device_status_diagnostic_response, MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_RESPONSE,
           MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_RESPONSE, "3dm.device_status_diagnostic_response",
           decode)
MIP_LAYOUT(mip_3dm_device_status_diagnostic_gnss_response,
           MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GNSS_RESPONSE,
           MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GNSS_RESPONSE,
           "3dm.device_status_diagnostic_gnss_response", decode)
MIP_LAYOUT(mip_3dm_device_status_diagnostic_gq4_45_response,
           MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GQ4_45_RESPONSE,
           MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GQ4_45_RESPONSE,
           "3dm.device_status_diagnostic_gq4_45_response", decode)
MIP_LAYOUT(mip_3dm_device_status_diagnostic_rq1_45_response,
           MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_RQ1_45_RESPONSE,
           MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_RQ1_45_RESPONSE,
           "3dm.device_status_diagnostic_rq1_45_response", decode)
MIP_LAYOUT(mip_3dm_device_status_diagnostic_gx4_response,
           MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GX4_RESPONSE,
           MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GX4_RESPONSE,
           "3dm.device_status_diagnostic_gx4_response", decode)
MIP_LAYOUT(mip_3dm_device_status_diagnostic_imu_response,
           MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_IMU_RESPONSE,
           MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_IMU_RESPONSE,
           "3dm.device_status_diagnostic_imu_response", decode)
MIP_LAYOUT(mip_3dm_device_status_diagnostic_gx4_imu_response,
           MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GX4_IMU_RESPONSE,
           MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GX4_IMU_RESPONSE,
           "3dm.device_status_diagnostic_gx4_imu_response", decode)
MIP_LAYOUT(mip_3dm_device_status_diagnostic_rq1_imu_response,
           MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_RQ1_IMU_RESPONSE,
           MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_RQ1_IMU_RESPONSE,
           "3dm.device_status_diagnostic_rq1_imu_response", decode)
MIP_LAYOUT(mip_3dm_device_status_basic_gx3_response, MIP_3DM_DEVICE_STATUS_BASIC_GX3_RESPONSE,
           MIP_3DM_DEVICE_STATUS_BASIC_GX3_RESPONSE, "3dm.device_status_basic_gx3_response", decode)
MIP_LAYOUT(mip_3dm_device_status_diagnostic_gx3_response,
           MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GX3_RESPONSE,
           MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GX3_RESPONSE,
           "3dm.device_status_diagnostic_gx3_response", decode)
MIP_LAYOUT(mip_3dm_gps_dynamics_mode_response, MIP_3DM_GPS_DYNAMICS_MODE_RESPONSE,
           MIP_3DM_GPS_DYNAMICS_MODE_RESPONSE, "3dm.gps_dynamics_mode_response", decode_inline)
MIP_LAYOUT(mip_3dm_imu_timestamp_response, MIP_3DM_IMU_TIMESTAMP_RESPONSE,
           MIP_3DM_IMU_TIMESTAMP_RESPONSE, "3dm.imu_timestamp_response", decode_inline)
MIP_LAYOUT(mip_3dm_complementary_filter_response, MIP_3DM_COMPLEMENTARY_FILTER_RESPONSE,
           MIP_3DM_COMPLEMENTARY_FILTER_RESPONSE, "3dm.complementary_filter_response",
           decode_inline)
MIP_LAYOUT(mip_3dm_accel_bias_response, MIP_3DM_ACCEL_BIAS_RESPONSE, MIP_3DM_ACCEL_BIAS_RESPONSE,
           "3dm.accel_bias_response", decode_inline)
MIP_LAYOUT(mip_3dm_gyro_bias_response, MIP_3DM_GYRO_BIAS_RESPONSE, MIP_3DM_GYRO_BIAS_RESPONSE,
           "3dm.gyro_bias_response", decode_inline)
MIP_LAYOUT(mip_3dm_mag_hard_iron_offset_response, MIP_3DM_MAG_HARD_IRON_OFFSET_RESPONSE,
           MIP_3DM_MAG_HARD_IRON_OFFSET_RESPONSE, "3dm.mag_hard_iron_offset_response",
           decode_inline)
MIP_LAYOUT(mip_3dm_mag_soft_iron_matrix_response, MIP_3DM_MAG_SOFT_IRON_MATRIX_RESPONSE,
           MIP_3DM_MAG_SOFT_IRON_MATRIX_RESPONSE, "3dm.mag_soft_iron_matrix_response",
           decode_inline)
MIP_LAYOUT(mip_3dm_coning_sculling_enable_response, MIP_3DM_CONING_SCULLING_ENABLE_RESPONSE,
           MIP_3DM_CONING_SCULLING_ENABLE_RESPONSE, "3dm.coning_sculling_enable_response",
           decode_inline)
MIP_LAYOUT(mip_3dm_constellation_settings_response, MIP_3DM_CONSTELLATION_SETTINGS_RESPONSE,
           MIP_3DM_CONSTELLATION_SETTINGS_RESPONSE, "3dm.constellation_settings_response", decode)
MIP_LAYOUT(mip_3dm_gnss_sbas_settings_response, MIP_3DM_GNSS_SBAS_SETTINGS_RESPONSE,
           MIP_3DM_GNSS_SBAS_SETTINGS_RESPONSE, "3dm.gnss_sbas_settings_response", decode)
MIP_LAYOUT(mip_3dm_gnss_assisted_fix_response, MIP_3DM_GNSS_ASSISTED_FIX_RESPONSE,
           MIP_3DM_GNSS_ASSISTED_FIX_RESPONSE, "3dm.gnss_assisted_fix_response", decode_inline)
MIP_LAYOUT(mip_3dm_gnss_time_assistance_response, MIP_3DM_GNSS_TIME_ASSISTANCE_RESPONSE,
           MIP_3DM_GNSS_TIME_ASSISTANCE_RESPONSE, "3dm.gnss_time_assistance_response",
           decode_inline)
MIP_LAYOUT(mip_3dm_pps_source_control_response, MIP_3DM_PPS_SOURCE_CONTROL_RESPONSE,
           MIP_3DM_PPS_SOURCE_CONTROL_RESPONSE, "3dm.pps_source_control_response", decode_inline)
MIP_LAYOUT(mip_3dm_sensor_to_vehicle_transform_euler_response,
           MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_EULER_RESPONSE,
           MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_EULER_RESPONSE,
           "3dm.sensor_to_vehicle_transform_euler_response", decode_inline)
MIP_LAYOUT(mip_3dm_sensor_to_vehicle_transform_quaternion_response,
           MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_QUATERNION_RESPONSE,
           MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_QUATERNION_RESPONSE,
           "3dm.sensor_to_vehicle_transform_quaternion_response", decode_inline)
MIP_LAYOUT(mip_3dm_sensor_to_vehicle_transform_dcm_response,
           MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_DCM_RESPONSE,
           MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_DCM_RESPONSE,
           "3dm.sensor_to_vehicle_transform_dcm_response", decode_inline)
MIP_LAYOUT(mip_3dm_get_event_support_response, MIP_3DM_GET_EVENT_SUPPORT_RESPONSE,
           MIP_3DM_GET_EVENT_SUPPORT_RESPONSE, "3dm.get_event_support_response", decode)
MIP_LAYOUT(mip_3dm_event_control_response, MIP_3DM_EVENT_CONTROL_RESPONSE,
           MIP_3DM_EVENT_CONTROL_RESPONSE, "3dm.event_control_response", decode_inline)
MIP_LAYOUT(mip_3dm_get_event_trigger_status_response, MIP_3DM_GET_EVENT_TRIGGER_STATUS_RESPONSE,
           MIP_3DM_GET_EVENT_TRIGGER_STATUS_RESPONSE, "3dm.get_event_trigger_status_response",
           decode)
MIP_LAYOUT(mip_3dm_get_event_action_status_response, MIP_3DM_GET_EVENT_ACTION_STATUS_RESPONSE,
           MIP_3DM_GET_EVENT_ACTION_STATUS_RESPONSE, "3dm.get_event_action_status_response", decode)
MIP_LAYOUT(mip_3dm_event_trigger_config_response, MIP_3DM_EVENT_TRIGGER_CONFIG_RESPONSE,
           MIP_3DM_EVENT_TRIGGER_CONFIG_RESPONSE, "3dm.event_trigger_config_response", decode)
MIP_LAYOUT(mip_3dm_event_action_config_response, MIP_3DM_EVENT_ACTION_CONFIG_RESPONSE,
           MIP_3DM_EVENT_ACTION_CONFIG_RESPONSE, "3dm.event_action_config_response", decode)
MIP_LAYOUT(mip_3dm_gpio_config_response, MIP_3DM_GPIO_CONFIG_RESPONSE, MIP_3DM_GPIO_CONFIG_RESPONSE,
           "3dm.gpio_config_response", decode_inline)
MIP_LAYOUT(mip_3dm_gpio_state_response, MIP_3DM_GPIO_STATE_RESPONSE, MIP_3DM_GPIO_STATE_RESPONSE,
           "3dm.gpio_state_response", decode_inline)
MIP_LAYOUT(mip_3dm_odometer_config_response, MIP_3DM_ODOMETER_CONFIG_RESPONSE,
           MIP_3DM_ODOMETER_CONFIG_RESPONSE, "3dm.odometer_config_response", decode_inline)
MIP_LAYOUT(mip_3dm_sensor_range_response, MIP_3DM_SENSOR_RANGE_RESPONSE,
           MIP_3DM_SENSOR_RANGE_RESPONSE, "3dm.sensor_range_response", decode_inline)
MIP_LAYOUT(mip_3dm_get_calibrated_sensor_ranges_response,
           MIP_3DM_GET_CALIBRATED_SENSOR_RANGES_RESPONSE,
           MIP_3DM_GET_CALIBRATED_SENSOR_RANGES_RESPONSE,
           "3dm.get_calibrated_sensor_ranges_response", decode)
MIP_LAYOUT(mip_3dm_low_pass_filter_response, MIP_3DM_LOW_PASS_FILTER_RESPONSE,
           MIP_3DM_LOW_PASS_FILTER_RESPONSE, "3dm.low_pass_filter_response", decode_inline)

/** 3DM */
inline constexpr std::uint8_t mip_3dm_set = MIP_3DM_SET;

namespace mip_3dm {

/** @addtogroup mip_3dm
 * @{ */

using ::mip::operator|;
using ::mip::operator&;
using ::mip::operator^;
using ::mip::operator~;
using ::mip::operator|=;
using ::mip::operator&=;
using ::mip::operator^=;
#ifdef MIP_NAMES_H
using ::mip::operator<<;
#endif
using ::mip::get;
using ::mip::has;
using ::mip::to_string;

/** mip_3dm_poll_entry */
using poll_entry = ::mip_3dm_poll_entry;

/** mip_3dm_factory_streaming_action: 3dm.factory_streaming_action */
enum class factory_streaming_action : uint8_t {
    overwrite = MIP_3DM_FACTORY_STREAMING_ACTION_OVERWRITE,
    merge = MIP_3DM_FACTORY_STREAMING_ACTION_MERGE,
    add = MIP_3DM_FACTORY_STREAMING_ACTION_ADD,
};
MIP_NAMES_OF(value_names, factory_streaming_action, mip_names_3dm_factory_streaming_action)

/** mip_3dm_constellation_id: 3dm.constellation_id */
enum class constellation_id : uint8_t {
    gps = MIP_3DM_CONSTELLATION_ID_GPS,
    sbas = MIP_3DM_CONSTELLATION_ID_SBAS,
    galileo = MIP_3DM_CONSTELLATION_ID_GALILEO,
    beidou = MIP_3DM_CONSTELLATION_ID_BEIDOU,
    qzss = MIP_3DM_CONSTELLATION_ID_QZSS,
    glonass = MIP_3DM_CONSTELLATION_ID_GLONASS,
};
MIP_NAMES_OF(value_names, constellation_id, mip_names_3dm_constellation_id)

/** mip_3dm_constellation_options: 3dm.constellation_options */
enum class constellation_options : uint16_t {
    l1saif = MIP_3DM_CONSTELLATION_OPTIONS_L1SAIF,
};
MIP_NAMES_OF(flag_names, constellation_options, mip_names_3dm_constellation_options)

/** mip_3dm_constellation_settings_entry */
using constellation_settings_entry = ::mip_3dm_constellation_settings_entry;

/** mip_3dm_sbas_options: 3dm.sbas_options */
enum class sbas_options : uint16_t {
    enable_ranging = MIP_3DM_SBAS_OPTIONS_ENABLE_RANGING,
    enable_corrections = MIP_3DM_SBAS_OPTIONS_ENABLE_CORRECTIONS,
    apply_integrity = MIP_3DM_SBAS_OPTIONS_APPLY_INTEGRITY,
};
MIP_NAMES_OF(flag_names, sbas_options, mip_names_3dm_sbas_options)

/** mip_3dm_assisted_fix_option: 3dm.assisted_fix_option */
enum class assisted_fix_option : uint8_t {
    none = MIP_3DM_ASSISTED_FIX_OPTION_NONE,
    enabled = MIP_3DM_ASSISTED_FIX_OPTION_ENABLED,
};
MIP_NAMES_OF(value_names, assisted_fix_option, mip_names_3dm_assisted_fix_option)

/** mip_3dm_pps_source: 3dm.pps_source */
enum class pps_source : uint8_t {
    disabled = MIP_3DM_PPS_SOURCE_DISABLED,
    receiver_1 = MIP_3DM_PPS_SOURCE_RECEIVER_1,
    receiver_2 = MIP_3DM_PPS_SOURCE_RECEIVER_2,
    gpio = MIP_3DM_PPS_SOURCE_GPIO,
    generated = MIP_3DM_PPS_SOURCE_GENERATED,
};
MIP_NAMES_OF(value_names, pps_source, mip_names_3dm_pps_source)

/** mip_3dm_event_support_query: 3dm.event_support_query */
enum class event_support_query : uint8_t {
    trigger_types = MIP_3DM_EVENT_SUPPORT_QUERY_TRIGGER_TYPES,
    action_types = MIP_3DM_EVENT_SUPPORT_QUERY_ACTION_TYPES,
};
MIP_NAMES_OF(value_names, event_support_query, mip_names_3dm_event_support_query)

/** mip_3dm_event_support_info */
using event_support_info = ::mip_3dm_event_support_info;

/** mip_3dm_event_trigger_status_entry */
using event_trigger_status_entry = ::mip_3dm_event_trigger_status_entry;

/** mip_3dm_event_action_status_entry */
using event_action_status_entry = ::mip_3dm_event_action_status_entry;

/** mip_3dm_receiver_dynamics: 3dm.receiver_dynamics */
enum class receiver_dynamics : uint8_t {
    portable = MIP_3DM_RECEIVER_DYNAMICS_PORTABLE,
    fixed = MIP_3DM_RECEIVER_DYNAMICS_FIXED,
    stationary = MIP_3DM_RECEIVER_DYNAMICS_STATIONARY,
    pedestrian = MIP_3DM_RECEIVER_DYNAMICS_PEDESTRIAN,
    automotive = MIP_3DM_RECEIVER_DYNAMICS_AUTOMOTIVE,
    sea = MIP_3DM_RECEIVER_DYNAMICS_SEA,
    airborne_1g = MIP_3DM_RECEIVER_DYNAMICS_AIRBORNE_1G,
    airborne_2g = MIP_3DM_RECEIVER_DYNAMICS_AIRBORNE_2G,
    airborne_4g = MIP_3DM_RECEIVER_DYNAMICS_AIRBORNE_4G,
};
MIP_NAMES_OF(value_names, receiver_dynamics, mip_names_3dm_receiver_dynamics)

/** mip_3dm_data_conditioning_flags: 3dm.data_conditioning_flags */
enum class data_conditioning_flags : uint16_t {
    orientation_calculation = MIP_3DM_DATA_CONDITIONING_FLAGS_ORIENTATION_CALCULATION,
    coning_sculling = MIP_3DM_DATA_CONDITIONING_FLAGS_CONING_SCULLING,
    little_endian_floats = MIP_3DM_DATA_CONDITIONING_FLAGS_LITTLE_ENDIAN_FLOATS,
    nan_suppressed = MIP_3DM_DATA_CONDITIONING_FLAGS_NAN_SUPPRESSED,
    finite_size_correction = MIP_3DM_DATA_CONDITIONING_FLAGS_FINITE_SIZE_CORRECTION,
    disable_mag = MIP_3DM_DATA_CONDITIONING_FLAGS_DISABLE_MAG,
    mag_low_power = MIP_3DM_DATA_CONDITIONING_FLAGS_MAG_LOW_POWER,
    disable_north_compensation = MIP_3DM_DATA_CONDITIONING_FLAGS_DISABLE_NORTH_COMPENSATION,
    disable_up_compensation = MIP_3DM_DATA_CONDITIONING_FLAGS_DISABLE_UP_COMPENSATION,
    quaternion_calculation = MIP_3DM_DATA_CONDITIONING_FLAGS_QUATERNION_CALCULATION,
};
MIP_NAMES_OF(flag_names, data_conditioning_flags, mip_names_3dm_data_conditioning_flags)

/** mip_3dm_mag_bandwidth: 3dm.mag_bandwidth */
enum class mag_bandwidth : uint8_t {
    high = MIP_3DM_MAG_BANDWIDTH_HIGH,
    low = MIP_3DM_MAG_BANDWIDTH_LOW,
};
MIP_NAMES_OF(value_names, mag_bandwidth, mip_names_3dm_mag_bandwidth)

/** mip_3dm_imu_timestamp_selector: 3dm.imu_timestamp_selector */
enum class imu_timestamp_selector : uint8_t {
    beacon_seconds = MIP_3DM_IMU_TIMESTAMP_SELECTOR_BEACON_SECONDS,
    beacon_nanoseconds = MIP_3DM_IMU_TIMESTAMP_SELECTOR_BEACON_NANOSECONDS,
    internal_ticks = MIP_3DM_IMU_TIMESTAMP_SELECTOR_INTERNAL_TICKS,
};
MIP_NAMES_OF(value_names, imu_timestamp_selector, mip_names_3dm_imu_timestamp_selector)

/** mip_3dm_odometer_mode: 3dm.odometer_mode */
enum class odometer_mode : uint8_t {
    disabled = MIP_3DM_ODOMETER_MODE_DISABLED,
    quadrature = MIP_3DM_ODOMETER_MODE_QUADRATURE,
};
MIP_NAMES_OF(value_names, odometer_mode, mip_names_3dm_odometer_mode)

/** mip_3dm_sensor_range_type: 3dm.sensor_range_type */
enum class sensor_range_type : uint8_t {
    all = MIP_3DM_SENSOR_RANGE_TYPE_ALL,
    accel = MIP_3DM_SENSOR_RANGE_TYPE_ACCEL,
    gyro = MIP_3DM_SENSOR_RANGE_TYPE_GYRO,
    mag = MIP_3DM_SENSOR_RANGE_TYPE_MAG,
    pressure = MIP_3DM_SENSOR_RANGE_TYPE_PRESSURE,
};
MIP_NAMES_OF(value_names, sensor_range_type, mip_names_3dm_sensor_range_type)

/** mip_3dm_sensor_range_entry */
using sensor_range_entry = ::mip_3dm_sensor_range_entry;

/** mip_3dm_internal_sensor: 3dm.internal_sensor */
enum class internal_sensor : uint8_t {
    imu = MIP_3DM_INTERNAL_SENSOR_IMU,
    gnss = MIP_3DM_INTERNAL_SENSOR_GNSS,
};
MIP_NAMES_OF(value_names, internal_sensor, mip_names_3dm_internal_sensor)

/** mip_3dm_stream_format: 3dm.stream_format */
enum class stream_format : uint8_t {
    standard = MIP_3DM_STREAM_FORMAT_STANDARD,
    wrapped_raw = MIP_3DM_STREAM_FORMAT_WRAPPED_RAW,
};
MIP_NAMES_OF(value_names, stream_format, mip_names_3dm_stream_format)

/** mip_3dm_sensor_power_state: 3dm.sensor_power_state */
enum class sensor_power_state : uint8_t {
    on = MIP_3DM_SENSOR_POWER_STATE_ON,
    low_power = MIP_3DM_SENSOR_POWER_STATE_LOW_POWER,
    sleep = MIP_3DM_SENSOR_POWER_STATE_SLEEP,
    off = MIP_3DM_SENSOR_POWER_STATE_OFF,
};
MIP_NAMES_OF(value_names, sensor_power_state, mip_names_3dm_sensor_power_state)

/** mip_3dm_device_status_selector: 3dm.device_status_selector */
enum class device_status_selector : uint8_t {
    basic = MIP_3DM_DEVICE_STATUS_SELECTOR_BASIC,
    diagnostic = MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC,
};
MIP_NAMES_OF(value_names, device_status_selector, mip_names_3dm_device_status_selector)

/** mip_3dm_legacy_data_stream: 3dm.legacy_data_stream */
enum class legacy_data_stream : uint8_t {
    all_streams = MIP_3DM_LEGACY_DATA_STREAM_ALL_STREAMS,
    imu = MIP_3DM_LEGACY_DATA_STREAM_IMU,
    gnss = MIP_3DM_LEGACY_DATA_STREAM_GNSS,
    filter = MIP_3DM_LEGACY_DATA_STREAM_FILTER,
};
MIP_NAMES_OF(value_names, legacy_data_stream, mip_names_3dm_legacy_data_stream)

/** mip_3dm_gx4_system_state: 3dm.gx4_system_state */
enum class gx4_system_state : uint16_t {
    init = MIP_3DM_GX4_SYSTEM_STATE_INIT,
    sensor_startup = MIP_3DM_GX4_SYSTEM_STATE_SENSOR_STARTUP,
    running = MIP_3DM_GX4_SYSTEM_STATE_RUNNING,
};
MIP_NAMES_OF(value_names, gx4_system_state, mip_names_3dm_gx4_system_state)

/** Get IMU data base rate response. See struct mip_3dm_get_imu_base_rate_response. */
using get_imu_base_rate_response = ::mip_3dm_get_imu_base_rate_response;

/** Get GNSS data base rate response. See struct mip_3dm_get_gnss_base_rate_response. */
using get_gnss_base_rate_response = ::mip_3dm_get_gnss_base_rate_response;

struct imu_message_format_response_ : ::mip_3dm_imu_message_format_response {
    using c_type = ::mip_3dm_imu_message_format_response;
    span<const ::mip_descriptor_rate> descriptors() const {
        return {c_type::descriptors, c_type::num_descriptors};
    }
};

/** IMU message format response. See struct mip_3dm_imu_message_format_response. */
using imu_message_format_response = imu_message_format_response_;

struct gnss_message_format_response_ : ::mip_3dm_gnss_message_format_response {
    using c_type = ::mip_3dm_gnss_message_format_response;
    span<const ::mip_descriptor_rate> descriptors() const {
        return {c_type::descriptors, c_type::num_descriptors};
    }
};

/** GNSS message format response. See struct mip_3dm_gnss_message_format_response. */
using gnss_message_format_response = gnss_message_format_response_;

struct filter_message_format_response_ : ::mip_3dm_filter_message_format_response {
    using c_type = ::mip_3dm_filter_message_format_response;
    span<const ::mip_descriptor_rate> descriptors() const {
        return {c_type::descriptors, c_type::num_descriptors};
    }
};

/** Estimation filter message format response. See struct mip_3dm_filter_message_format_response. */
using filter_message_format_response = filter_message_format_response_;

/**
 * Get estimation filter data base rate response. See struct mip_3dm_get_filter_base_rate_response.
 */
using get_filter_base_rate_response = ::mip_3dm_get_filter_base_rate_response;

struct nmea_message_format_response_ : ::mip_3dm_nmea_message_format_response {
    using c_type = ::mip_3dm_nmea_message_format_response;
    span<const ::mip_nmea_message> format_entries() const {
        return {c_type::format_entries, c_type::count};
    }
};

/** NMEA message format response. See struct mip_3dm_nmea_message_format_response. */
using nmea_message_format_response = nmea_message_format_response_;

/** Get data base rate response. See struct mip_3dm_get_base_rate_response. */
using get_base_rate_response = ::mip_3dm_get_base_rate_response;

struct message_format_response_ : ::mip_3dm_message_format_response {
    using c_type = ::mip_3dm_message_format_response;
    span<const ::mip_descriptor_rate> descriptors() const {
        return {c_type::descriptors, c_type::num_descriptors};
    }
};

/** Message format response. See struct mip_3dm_message_format_response. */
using message_format_response = message_format_response_;

/** Data stream control response. See struct mip_3dm_data_stream_control_response. */
using data_stream_control_response = ::mip_3dm_data_stream_control_response;

struct constellation_settings_response_ : ::mip_3dm_constellation_settings_response {
    using c_type = ::mip_3dm_constellation_settings_response;
    span<const ::mip_3dm_constellation_settings_entry> settings() const {
        return {c_type::settings, c_type::config_count};
    }
};

/** Constellation settings response. See struct mip_3dm_constellation_settings_response. */
using constellation_settings_response = constellation_settings_response_;

struct gnss_sbas_settings_response_ : ::mip_3dm_gnss_sbas_settings_response {
    using c_type = ::mip_3dm_gnss_sbas_settings_response;
    ::mip::mip_3dm::sbas_options sbas_options() const {
        return static_cast<::mip::mip_3dm::sbas_options>(c_type::sbas_options);
    }
    span<const uint16_t> included_prns() const {
        return {c_type::included_prns, c_type::num_included_prns};
    }
};

/** GNSS SBAS settings response. See struct mip_3dm_gnss_sbas_settings_response. */
using gnss_sbas_settings_response = gnss_sbas_settings_response_;

struct gnss_assisted_fix_response_ : ::mip_3dm_gnss_assisted_fix_response {
    using c_type = ::mip_3dm_gnss_assisted_fix_response;
    ::mip::mip_3dm::assisted_fix_option option() const {
        return static_cast<::mip::mip_3dm::assisted_fix_option>(c_type::option);
    }
};

/** GNSS assisted fix response. See struct mip_3dm_gnss_assisted_fix_response. */
using gnss_assisted_fix_response = gnss_assisted_fix_response_;

/** GNSS time assistance response. See struct mip_3dm_gnss_time_assistance_response. */
using gnss_time_assistance_response = ::mip_3dm_gnss_time_assistance_response;

struct pps_source_control_response_ : ::mip_3dm_pps_source_control_response {
    using c_type = ::mip_3dm_pps_source_control_response;
    ::mip::mip_3dm::pps_source source() const {
        return static_cast<::mip::mip_3dm::pps_source>(c_type::source);
    }
};

/** PPS source control response. See struct mip_3dm_pps_source_control_response. */
using pps_source_control_response = pps_source_control_response_;

struct get_event_support_response_ : ::mip_3dm_get_event_support_response {
    using c_type = ::mip_3dm_get_event_support_response;
    ::mip::mip_3dm::event_support_query query() const {
        return static_cast<::mip::mip_3dm::event_support_query>(c_type::query);
    }
    span<const ::mip_3dm_event_support_info> entries() const {
        return {c_type::entries, c_type::num_entries};
    }
};

/** Get supported events response. See struct mip_3dm_get_event_support_response. */
using get_event_support_response = get_event_support_response_;

struct event_control_response_ : ::mip_3dm_event_control_response {
    using c_type = ::mip_3dm_event_control_response;
    ::mip::event_trigger_mode mode() const {
        return static_cast<::mip::event_trigger_mode>(c_type::mode);
    }
};

/** Event control response. See struct mip_3dm_event_control_response. */
using event_control_response = event_control_response_;

struct get_event_trigger_status_response_ : ::mip_3dm_get_event_trigger_status_response {
    using c_type = ::mip_3dm_get_event_trigger_status_response;
    span<const ::mip_3dm_event_trigger_status_entry> triggers() const {
        return {c_type::triggers, c_type::count};
    }
};

/** Get event trigger status response. See struct mip_3dm_get_event_trigger_status_response. */
using get_event_trigger_status_response = get_event_trigger_status_response_;

struct get_event_action_status_response_ : ::mip_3dm_get_event_action_status_response {
    using c_type = ::mip_3dm_get_event_action_status_response;
    span<const ::mip_3dm_event_action_status_entry> actions() const {
        return {c_type::actions, c_type::count};
    }
};

/** Get event action status response. See struct mip_3dm_get_event_action_status_response. */
using get_event_action_status_response = get_event_action_status_response_;

struct event_trigger_config_response_ : ::mip_3dm_event_trigger_config_response {
    using c_type = ::mip_3dm_event_trigger_config_response;
    ::mip::event_trigger_type type() const {
        return static_cast<::mip::event_trigger_type>(c_type::type);
    }
};

/** Event trigger configuration response. See struct mip_3dm_event_trigger_config_response. */
using event_trigger_config_response = event_trigger_config_response_;

struct event_action_config_response_ : ::mip_3dm_event_action_config_response {
    using c_type = ::mip_3dm_event_action_config_response;
    ::mip::event_action_type type() const {
        return static_cast<::mip::event_action_type>(c_type::type);
    }
};

/** Event action configuration response. See struct mip_3dm_event_action_config_response. */
using event_action_config_response = event_action_config_response_;

/**
 * Sensor-to-vehicle frame transformation Euler response. See struct
 * mip_3dm_sensor_to_vehicle_transform_euler_response.
 */
using sensor_to_vehicle_transform_euler_response =
    ::mip_3dm_sensor_to_vehicle_transform_euler_response;

/**
 * Sensor-to-vehicle frame transformation quaternion response. See struct
 * mip_3dm_sensor_to_vehicle_transform_quaternion_response.
 */
using sensor_to_vehicle_transform_quaternion_response =
    ::mip_3dm_sensor_to_vehicle_transform_quaternion_response;

/**
 * Sensor-to-vehicle frame transformation direction cosine matrix response. See struct
 * mip_3dm_sensor_to_vehicle_transform_dcm_response.
 */
using sensor_to_vehicle_transform_dcm_response = ::mip_3dm_sensor_to_vehicle_transform_dcm_response;

struct gps_dynamics_mode_response_ : ::mip_3dm_gps_dynamics_mode_response {
    using c_type = ::mip_3dm_gps_dynamics_mode_response;
    ::mip::mip_3dm::receiver_dynamics mode() const {
        return static_cast<::mip::mip_3dm::receiver_dynamics>(c_type::mode);
    }
};

/** GPS dynamics mode response. See struct mip_3dm_gps_dynamics_mode_response. */
using gps_dynamics_mode_response = gps_dynamics_mode_response_;

struct imu_signal_conditioning_response_ : ::mip_3dm_imu_signal_conditioning_response {
    using c_type = ::mip_3dm_imu_signal_conditioning_response;
    ::mip::mip_3dm::data_conditioning_flags data_conditioning_flags() const {
        return static_cast<::mip::mip_3dm::data_conditioning_flags>(
            c_type::data_conditioning_flags);
    }
    ::mip::mip_3dm::mag_bandwidth mag_bandwidth() const {
        return static_cast<::mip::mip_3dm::mag_bandwidth>(c_type::mag_bandwidth);
    }
};

/** IMU signal conditioning response. See struct mip_3dm_imu_signal_conditioning_response. */
using imu_signal_conditioning_response = imu_signal_conditioning_response_;

struct imu_timestamp_response_ : ::mip_3dm_imu_timestamp_response {
    using c_type = ::mip_3dm_imu_timestamp_response;
    ::mip::mip_3dm::imu_timestamp_selector selector() const {
        return static_cast<::mip::mip_3dm::imu_timestamp_selector>(c_type::selector);
    }
};

/** IMU timestamp response. See struct mip_3dm_imu_timestamp_response. */
using imu_timestamp_response = imu_timestamp_response_;

/** Accelerometer bias configuration response. See struct mip_3dm_accel_bias_response. */
using accel_bias_response = ::mip_3dm_accel_bias_response;

/** Gyroscope bias configuration response. See struct mip_3dm_gyro_bias_response. */
using gyro_bias_response = ::mip_3dm_gyro_bias_response;

/** Magnetometer hard iron offset response. See struct mip_3dm_mag_hard_iron_offset_response. */
using mag_hard_iron_offset_response = ::mip_3dm_mag_hard_iron_offset_response;

/** Magnetometer soft iron matrix response. See struct mip_3dm_mag_soft_iron_matrix_response. */
using mag_soft_iron_matrix_response = ::mip_3dm_mag_soft_iron_matrix_response;

/** Coning and sculling enable response. See struct mip_3dm_coning_sculling_enable_response. */
using coning_sculling_enable_response = ::mip_3dm_coning_sculling_enable_response;

/** UART baud rate response. See struct mip_3dm_uart_baud_rate_response. */
using uart_baud_rate_response = ::mip_3dm_uart_baud_rate_response;

struct gpio_config_response_ : ::mip_3dm_gpio_config_response {
    using c_type = ::mip_3dm_gpio_config_response;
    ::mip::gpio_feature feature() const {
        return static_cast<::mip::gpio_feature>(c_type::feature);
    }
    ::mip::gpio_pin_mode pin_mode() const {
        return static_cast<::mip::gpio_pin_mode>(c_type::pin_mode);
    }
};

/** GPIO configuration response. See struct mip_3dm_gpio_config_response. */
using gpio_config_response = gpio_config_response_;

/** GPIO state response. See struct mip_3dm_gpio_state_response. */
using gpio_state_response = ::mip_3dm_gpio_state_response;

struct odometer_config_response_ : ::mip_3dm_odometer_config_response {
    using c_type = ::mip_3dm_odometer_config_response;
    ::mip::mip_3dm::odometer_mode mode() const {
        return static_cast<::mip::mip_3dm::odometer_mode>(c_type::mode);
    }
};

/** Odometer configuration response. See struct mip_3dm_odometer_config_response. */
using odometer_config_response = odometer_config_response_;

/** Advanced low-pass filter settings response. See struct mip_3dm_imu_low_pass_filter_response. */
using imu_low_pass_filter_response = ::mip_3dm_imu_low_pass_filter_response;

/**
 * Complementary filter configuration response. See struct mip_3dm_complementary_filter_response.
 */
using complementary_filter_response = ::mip_3dm_complementary_filter_response;

struct sensor_range_response_ : ::mip_3dm_sensor_range_response {
    using c_type = ::mip_3dm_sensor_range_response;
    ::mip::mip_3dm::sensor_range_type sensor() const {
        return static_cast<::mip::mip_3dm::sensor_range_type>(c_type::sensor);
    }
};

/** Sensor range response. See struct mip_3dm_sensor_range_response. */
using sensor_range_response = sensor_range_response_;

struct get_calibrated_sensor_ranges_response_ : ::mip_3dm_get_calibrated_sensor_ranges_response {
    using c_type = ::mip_3dm_get_calibrated_sensor_ranges_response;
    ::mip::mip_3dm::sensor_range_type sensor() const {
        return static_cast<::mip::mip_3dm::sensor_range_type>(c_type::sensor);
    }
    span<const ::mip_3dm_sensor_range_entry> ranges() const {
        return {c_type::ranges, c_type::num_ranges};
    }
};

/**
 * Get calibrated sensor ranges response. See struct mip_3dm_get_calibrated_sensor_ranges_response.
 */
using get_calibrated_sensor_ranges_response = get_calibrated_sensor_ranges_response_;

/** Low-pass anti-aliasing filter response. See struct mip_3dm_low_pass_filter_response. */
using low_pass_filter_response = ::mip_3dm_low_pass_filter_response;

struct data_stream_format_response_ : ::mip_3dm_data_stream_format_response {
    using c_type = ::mip_3dm_data_stream_format_response;
    ::mip::mip_3dm::internal_sensor stream() const {
        return static_cast<::mip::mip_3dm::internal_sensor>(c_type::stream);
    }
    ::mip::mip_3dm::stream_format format() const {
        return static_cast<::mip::mip_3dm::stream_format>(c_type::format);
    }
};

/** Data stream format response. See struct mip_3dm_data_stream_format_response. */
using data_stream_format_response = data_stream_format_response_;

struct device_power_state_response_ : ::mip_3dm_device_power_state_response {
    using c_type = ::mip_3dm_device_power_state_response;
    ::mip::mip_3dm::internal_sensor device() const {
        return static_cast<::mip::mip_3dm::internal_sensor>(c_type::device);
    }
    ::mip::mip_3dm::sensor_power_state state() const {
        return static_cast<::mip::mip_3dm::sensor_power_state>(c_type::state);
    }
};

/** Device power state response. See struct mip_3dm_device_power_state_response. */
using device_power_state_response = device_power_state_response_;

/**
 * Basic device status (inertial sensor of the 3DM-RQ1-45). See struct
 * mip_3dm_device_status_basic_rq1_imu_response.
 */
using device_status_basic_rq1_imu_response = ::mip_3dm_device_status_basic_rq1_imu_response;

/** Basic device status. See struct mip_3dm_device_status_basic_response. */
using device_status_basic_response = ::mip_3dm_device_status_basic_response;

/**
 * Basic device status (without state). See struct
 * mip_3dm_device_status_basic_without_state_response.
 */
using device_status_basic_without_state_response =
    ::mip_3dm_device_status_basic_without_state_response;

/** Diagnostic device status. See struct mip_3dm_device_status_diagnostic_response. */
using device_status_diagnostic_response = ::mip_3dm_device_status_diagnostic_response;

/**
 * Diagnostic device status (with GNSS). See struct mip_3dm_device_status_diagnostic_gnss_response.
 */
using device_status_diagnostic_gnss_response = ::mip_3dm_device_status_diagnostic_gnss_response;

/**
 * Diagnostic device status (3DM-GQ4-45). See struct
 * mip_3dm_device_status_diagnostic_gq4_45_response.
 */
using device_status_diagnostic_gq4_45_response = ::mip_3dm_device_status_diagnostic_gq4_45_response;

/**
 * Diagnostic device status (3DM-RQ1-45). See struct
 * mip_3dm_device_status_diagnostic_rq1_45_response.
 */
using device_status_diagnostic_rq1_45_response = ::mip_3dm_device_status_diagnostic_rq1_45_response;

/**
 * Diagnostic device status (3DM-GX4-15, 3DM-GX4-25). See struct
 * mip_3dm_device_status_diagnostic_gx4_response.
 */
using device_status_diagnostic_gx4_response = ::mip_3dm_device_status_diagnostic_gx4_response;

/** Diagnostic device status (IMU). See struct mip_3dm_device_status_diagnostic_imu_response. */
using device_status_diagnostic_imu_response = ::mip_3dm_device_status_diagnostic_imu_response;

/**
 * Diagnostic device status (inertial sensor of the 3DM-GX4-45). See struct
 * mip_3dm_device_status_diagnostic_gx4_imu_response.
 */
using device_status_diagnostic_gx4_imu_response =
    ::mip_3dm_device_status_diagnostic_gx4_imu_response;

/**
 * Diagnostic device status (inertial sensor of the 3DM-RQ1-45). See struct
 * mip_3dm_device_status_diagnostic_rq1_imu_response.
 */
using device_status_diagnostic_rq1_imu_response =
    ::mip_3dm_device_status_diagnostic_rq1_imu_response;

/**
 * Basic device status (3DM-GX3-35, 3DM-GX3-45). See struct
 * mip_3dm_device_status_basic_gx3_response.
 */
using device_status_basic_gx3_response = ::mip_3dm_device_status_basic_gx3_response;

/**
 * Diagnostic device status (3DM-GX3-35, 3DM-GX3-45). See struct
 * mip_3dm_device_status_diagnostic_gx3_response.
 */
using device_status_diagnostic_gx3_response = ::mip_3dm_device_status_diagnostic_gx3_response;

/** @} */

} // namespace mip_3dm

} // namespace mip

#endif
