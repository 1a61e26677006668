/**
 * @file
 * The commands of 3DM, in C++17: see mip/3dm_commands.h.
 */
#ifndef MIP_3DM_COMMANDS_HPP
#define MIP_3DM_COMMANDS_HPP

#include "mip/3dm_commands.h"
#include "mip/cpp/3dm.hpp"
#include "mip/cpp/device.hpp"

namespace mip {

MIP_COMMAND_OF(mip_3dm_poll_imu_data, void)
MIP_COMMAND_OF(mip_3dm_poll_gnss_data, void)
MIP_COMMAND_OF(mip_3dm_poll_filter_data, void)
MIP_COMMAND_OF(mip_3dm_poll_nmea_data, void)
MIP_COMMAND_OF(mip_3dm_get_imu_base_rate, ::mip::mip_3dm::get_imu_base_rate_response)
MIP_COMMAND_OF(mip_3dm_get_gnss_base_rate, ::mip::mip_3dm::get_gnss_base_rate_response)
MIP_COMMAND_OF(mip_3dm_imu_message_format, ::mip::mip_3dm::imu_message_format_response)
MIP_CHANGE_OF(mip_3dm_imu_message_format, ::mip::mip_3dm::imu_message_format_response,
              mip_3dm_imu_message_format_write_from)
MIP_COMMAND_OF(mip_3dm_gnss_message_format, ::mip::mip_3dm::gnss_message_format_response)
MIP_CHANGE_OF(mip_3dm_gnss_message_format, ::mip::mip_3dm::gnss_message_format_response,
              mip_3dm_gnss_message_format_write_from)
MIP_COMMAND_OF(mip_3dm_filter_message_format, ::mip::mip_3dm::filter_message_format_response)
MIP_CHANGE_OF(mip_3dm_filter_message_format, ::mip::mip_3dm::filter_message_format_response,
              mip_3dm_filter_message_format_write_from)
MIP_COMMAND_OF(mip_3dm_get_filter_base_rate, ::mip::mip_3dm::get_filter_base_rate_response)
MIP_COMMAND_OF(mip_3dm_nmea_message_format, ::mip::mip_3dm::nmea_message_format_response)
MIP_CHANGE_OF(mip_3dm_nmea_message_format, ::mip::mip_3dm::nmea_message_format_response,
              mip_3dm_nmea_message_format_write_from)
MIP_COMMAND_OF(mip_3dm_poll_data, void)
MIP_COMMAND_OF(mip_3dm_get_base_rate, ::mip::mip_3dm::get_base_rate_response)
MIP_COMMAND_OF(mip_3dm_message_format, ::mip::mip_3dm::message_format_response)
MIP_CHANGE_OF(mip_3dm_message_format, ::mip::mip_3dm::message_format_response,
              mip_3dm_message_format_write_from)
MIP_COMMAND_OF(mip_3dm_factory_streaming, void)
MIP_COMMAND_OF(mip_3dm_data_stream_control, ::mip::mip_3dm::data_stream_control_response)
MIP_COMMAND_OF(mip_3dm_raw_rtcm_2_3_message, void)
MIP_COMMAND_OF(mip_3dm_constellation_settings, ::mip::mip_3dm::constellation_settings_response)
MIP_COMMAND_OF(mip_3dm_gnss_sbas_settings, ::mip::mip_3dm::gnss_sbas_settings_response)
MIP_CHANGE_OF(mip_3dm_gnss_sbas_settings, ::mip::mip_3dm::gnss_sbas_settings_response,
              mip_3dm_gnss_sbas_settings_write_from)
MIP_COMMAND_OF(mip_3dm_gnss_assisted_fix, ::mip::mip_3dm::gnss_assisted_fix_response)
MIP_CHANGE_OF(mip_3dm_gnss_assisted_fix, ::mip::mip_3dm::gnss_assisted_fix_response,
              mip_3dm_gnss_assisted_fix_write_from)
MIP_COMMAND_OF(mip_3dm_gnss_time_assistance, ::mip::mip_3dm::gnss_time_assistance_response)
MIP_CHANGE_OF(mip_3dm_gnss_time_assistance, ::mip::mip_3dm::gnss_time_assistance_response,
              mip_3dm_gnss_time_assistance_write_from)
MIP_COMMAND_OF(mip_3dm_pps_source_control, ::mip::mip_3dm::pps_source_control_response)
MIP_CHANGE_OF(mip_3dm_pps_source_control, ::mip::mip_3dm::pps_source_control_response,
              mip_3dm_pps_source_control_write_from)
MIP_COMMAND_OF(mip_3dm_get_event_support, ::mip::mip_3dm::get_event_support_response)
MIP_COMMAND_OF(mip_3dm_event_control, ::mip::mip_3dm::event_control_response)
MIP_CHANGE_OF(mip_3dm_event_control, ::mip::mip_3dm::event_control_response,
              mip_3dm_event_control_write_from)
MIP_COMMAND_OF(mip_3dm_get_event_trigger_status, ::mip::mip_3dm::get_event_trigger_status_response)
MIP_COMMAND_OF(mip_3dm_get_event_action_status, ::mip::mip_3dm::get_event_action_status_response)
MIP_COMMAND_OF(mip_3dm_event_trigger_config, ::mip::mip_3dm::event_trigger_config_response)
MIP_CHANGE_OF(mip_3dm_event_trigger_config, ::mip::mip_3dm::event_trigger_config_response,
              mip_3dm_event_trigger_config_write_from)
MIP_COMMAND_OF(mip_3dm_event_action_config, ::mip::mip_3dm::event_action_config_response)
MIP_CHANGE_OF(mip_3dm_event_action_config, ::mip::mip_3dm::event_action_config_response,
              mip_3dm_event_action_config_write_from)
MIP_COMMAND_OF(mip_3dm_device_settings, void)
MIP_COMMAND_OF(mip_3dm_sensor_to_vehicle_transform_euler,
               ::mip::mip_3dm::sensor_to_vehicle_transform_euler_response)
MIP_CHANGE_OF(mip_3dm_sensor_to_vehicle_transform_euler,
              ::mip::mip_3dm::sensor_to_vehicle_transform_euler_response,
              mip_3dm_sensor_to_vehicle_transform_euler_write_from)
MIP_COMMAND_OF(mip_3dm_sensor_to_vehicle_transform_quaternion,
               ::mip::mip_3dm::sensor_to_vehicle_transform_quaternion_response)
MIP_CHANGE_OF(mip_3dm_sensor_to_vehicle_transform_quaternion,
              ::mip::mip_3dm::sensor_to_vehicle_transform_quaternion_response,
              mip_3dm_sensor_to_vehicle_transform_quaternion_write_from)
MIP_COMMAND_OF(mip_3dm_sensor_to_vehicle_transform_dcm,
               ::mip::mip_3dm::sensor_to_vehicle_transform_dcm_response)
MIP_CHANGE_OF(mip_3dm_sensor_to_vehicle_transform_dcm,
              ::mip::mip_3dm::sensor_to_vehicle_transform_dcm_response,
              mip_3dm_sensor_to_vehicle_transform_dcm_write_from)
MIP_COMMAND_OF(mip_3dm_gps_dynamics_mode, ::mip::mip_3dm::gps_dynamics_mode_response)
MIP_CHANGE_OF(mip_3dm_gps_dynamics_mode, ::mip::mip_3dm::gps_dynamics_mode_response,
              mip_3dm_gps_dynamics_mode_write_from)
MIP_COMMAND_OF(mip_3dm_imu_signal_conditioning, ::mip::mip_3dm::imu_signal_conditioning_response)
MIP_CHANGE_OF(mip_3dm_imu_signal_conditioning, ::mip::mip_3dm::imu_signal_conditioning_response,
              mip_3dm_imu_signal_conditioning_write_from)
MIP_COMMAND_OF(mip_3dm_imu_timestamp, ::mip::mip_3dm::imu_timestamp_response)
MIP_CHANGE_OF(mip_3dm_imu_timestamp, ::mip::mip_3dm::imu_timestamp_response,
              mip_3dm_imu_timestamp_write_from)
MIP_COMMAND_OF(mip_3dm_accel_bias, ::mip::mip_3dm::accel_bias_response)
MIP_CHANGE_OF(mip_3dm_accel_bias, ::mip::mip_3dm::accel_bias_response,
              mip_3dm_accel_bias_write_from)
MIP_COMMAND_OF(mip_3dm_gyro_bias, ::mip::mip_3dm::gyro_bias_response)
MIP_CHANGE_OF(mip_3dm_gyro_bias, ::mip::mip_3dm::gyro_bias_response, mip_3dm_gyro_bias_write_from)
MIP_COMMAND_OF(mip_3dm_capture_gyro_bias, ::mip::mip_3dm::gyro_bias_response)
MIP_COMMAND_OF(mip_3dm_mag_hard_iron_offset, ::mip::mip_3dm::mag_hard_iron_offset_response)
MIP_CHANGE_OF(mip_3dm_mag_hard_iron_offset, ::mip::mip_3dm::mag_hard_iron_offset_response,
              mip_3dm_mag_hard_iron_offset_write_from)
MIP_COMMAND_OF(mip_3dm_mag_soft_iron_matrix, ::mip::mip_3dm::mag_soft_iron_matrix_response)
MIP_CHANGE_OF(mip_3dm_mag_soft_iron_matrix, ::mip::mip_3dm::mag_soft_iron_matrix_response,
              mip_3dm_mag_soft_iron_matrix_write_from)
MIP_COMMAND_OF(mip_3dm_coning_sculling_enable, ::mip::mip_3dm::coning_sculling_enable_response)
MIP_CHANGE_OF(mip_3dm_coning_sculling_enable, ::mip::mip_3dm::coning_sculling_enable_response,
              mip_3dm_coning_sculling_enable_write_from)
MIP_COMMAND_OF(mip_3dm_uart_baud_rate, ::mip::mip_3dm::uart_baud_rate_response)
MIP_CHANGE_OF(mip_3dm_uart_baud_rate, ::mip::mip_3dm::uart_baud_rate_response,
              mip_3dm_uart_baud_rate_write_from)
MIP_COMMAND_OF(mip_3dm_gpio_config, ::mip::mip_3dm::gpio_config_response)
MIP_CHANGE_OF(mip_3dm_gpio_config, ::mip::mip_3dm::gpio_config_response,
              mip_3dm_gpio_config_write_from)
MIP_COMMAND_OF(mip_3dm_gpio_state, ::mip::mip_3dm::gpio_state_response)
MIP_CHANGE_OF(mip_3dm_gpio_state, ::mip::mip_3dm::gpio_state_response,
              mip_3dm_gpio_state_write_from)
MIP_COMMAND_OF(mip_3dm_odometer_config, ::mip::mip_3dm::odometer_config_response)
MIP_CHANGE_OF(mip_3dm_odometer_config, ::mip::mip_3dm::odometer_config_response,
              mip_3dm_odometer_config_write_from)
MIP_COMMAND_OF(mip_3dm_imu_low_pass_filter, ::mip::mip_3dm::imu_low_pass_filter_response)
MIP_CHANGE_OF(mip_3dm_imu_low_pass_filter, ::mip::mip_3dm::imu_low_pass_filter_response,
              mip_3dm_imu_low_pass_filter_write_from)
MIP_COMMAND_OF(mip_3dm_complementary_filter, ::mip::mip_3dm::complementary_filter_response)
MIP_CHANGE_OF(mip_3dm_complementary_filter, ::mip::mip_3dm::complementary_filter_response,
              mip_3dm_complementary_filter_write_from)
MIP_COMMAND_OF(mip_3dm_sensor_range, ::mip::mip_3dm::sensor_range_response)
MIP_CHANGE_OF(mip_3dm_sensor_range, ::mip::mip_3dm::sensor_range_response,
              mip_3dm_sensor_range_write_from)
MIP_COMMAND_OF(mip_3dm_get_calibrated_sensor_ranges,
               ::mip::mip_3dm::get_calibrated_sensor_ranges_response)
MIP_COMMAND_OF(mip_3dm_low_pass_filter, ::mip::mip_3dm::low_pass_filter_response)
MIP_CHANGE_OF(mip_3dm_low_pass_filter, ::mip::mip_3dm::low_pass_filter_response,
              mip_3dm_low_pass_filter_write_from)
MIP_COMMAND_OF(mip_3dm_data_stream_format, ::mip::mip_3dm::data_stream_format_response)
MIP_CHANGE_OF(mip_3dm_data_stream_format, ::mip::mip_3dm::data_stream_format_response,
              mip_3dm_data_stream_format_write_from)
MIP_COMMAND_OF(mip_3dm_device_power_state, ::mip::mip_3dm::device_power_state_response)
MIP_CHANGE_OF(mip_3dm_device_power_state, ::mip::mip_3dm::device_power_state_response,
              mip_3dm_device_power_state_write_from)
MIP_COMMAND_OF(mip_3dm_gps_advanced_settings, void)
MIP_COMMAND_OF(mip_3dm_device_status, void)

namespace mip_3dm {

/** @addtogroup mip_3dm
 * @{ */

/** Poll IMU data. See mip_call_3dm_poll_imu_data. */
struct poll_imu_data {
    bool suppress_ack;
    span<const ::mip_3dm_poll_entry> descriptors;

    using command = ::mip_3dm_poll_imu_data;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_poll_imu_data(device_, suppress_ack, detail::count(descriptors),
                                            descriptors.data());
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_poll_imu_data_make(to_, suppress_ack, detail::count(descriptors),
                                            descriptors.data());
    }
};

/** Poll GNSS data. See mip_call_3dm_poll_gnss_data. */
struct poll_gnss_data {
    bool suppress_ack;
    span<const ::mip_3dm_poll_entry> descriptors;

    using command = ::mip_3dm_poll_gnss_data;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_poll_gnss_data(device_, suppress_ack, detail::count(descriptors),
                                             descriptors.data());
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_poll_gnss_data_make(to_, suppress_ack, detail::count(descriptors),
                                             descriptors.data());
    }
};

/** Poll estimation filter data. See mip_call_3dm_poll_filter_data. */
struct poll_filter_data {
    bool suppress_ack;
    span<const ::mip_3dm_poll_entry> descriptors;

    using command = ::mip_3dm_poll_filter_data;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_poll_filter_data(device_, suppress_ack, detail::count(descriptors),
                                               descriptors.data());
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_poll_filter_data_make(to_, suppress_ack, detail::count(descriptors),
                                               descriptors.data());
    }
};

/** Poll NMEA data. See mip_call_3dm_poll_nmea_data. */
struct poll_nmea_data {
    bool suppress_ack;
    span<const ::mip_nmea_message> format_entries;

    using command = ::mip_3dm_poll_nmea_data;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_poll_nmea_data(device_, suppress_ack, detail::count(format_entries),
                                             format_entries.data());
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_poll_nmea_data_make(to_, suppress_ack, detail::count(format_entries),
                                             format_entries.data());
    }
};

/** Get IMU data base rate. See mip_call_3dm_get_imu_base_rate. */
struct get_imu_base_rate
    : fixed_command<::mip_3dm_get_imu_base_rate, ::mip::mip_3dm::get_imu_base_rate_response> {};

/** Get GNSS data base rate. See mip_call_3dm_get_gnss_base_rate. */
struct get_gnss_base_rate
    : fixed_command<::mip_3dm_get_gnss_base_rate, ::mip::mip_3dm::get_gnss_base_rate_response> {};

/** IMU message format: write. See mip_call_3dm_imu_message_format_write. */
struct write_imu_message_format {
    span<const ::mip_descriptor_rate> descriptors;

    using command = ::mip_3dm_imu_message_format;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_imu_message_format_write(device_, detail::count(descriptors),
                                                       descriptors.data());
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_imu_message_format_write(to_, detail::count(descriptors),
                                                  descriptors.data());
    }
};

/** IMU message format: read. See mip_call_3dm_imu_message_format_read. */
struct read_imu_message_format
    : fixed_command<::mip_3dm_imu_message_format, ::mip::mip_3dm::imu_message_format_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** IMU message format: save. See mip_call_3dm_imu_message_format_save. */
struct save_imu_message_format
    : fixed_command<::mip_3dm_imu_message_format, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** IMU message format: load. See mip_call_3dm_imu_message_format_load. */
struct load_imu_message_format
    : fixed_command<::mip_3dm_imu_message_format, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** IMU message format: default. See mip_call_3dm_imu_message_format_default. */
struct default_imu_message_format
    : fixed_command<::mip_3dm_imu_message_format, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** GNSS message format: write. See mip_call_3dm_gnss_message_format_write. */
struct write_gnss_message_format {
    span<const ::mip_descriptor_rate> descriptors;

    using command = ::mip_3dm_gnss_message_format;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_gnss_message_format_write(device_, detail::count(descriptors),
                                                        descriptors.data());
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_gnss_message_format_write(to_, detail::count(descriptors),
                                                   descriptors.data());
    }
};

/** GNSS message format: read. See mip_call_3dm_gnss_message_format_read. */
struct read_gnss_message_format
    : fixed_command<::mip_3dm_gnss_message_format, ::mip::mip_3dm::gnss_message_format_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** GNSS message format: save. See mip_call_3dm_gnss_message_format_save. */
struct save_gnss_message_format
    : fixed_command<::mip_3dm_gnss_message_format, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** GNSS message format: load. See mip_call_3dm_gnss_message_format_load. */
struct load_gnss_message_format
    : fixed_command<::mip_3dm_gnss_message_format, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** GNSS message format: default. See mip_call_3dm_gnss_message_format_default. */
struct default_gnss_message_format
    : fixed_command<::mip_3dm_gnss_message_format, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Estimation filter message format: write. See mip_call_3dm_filter_message_format_write. */
struct write_filter_message_format {
    span<const ::mip_descriptor_rate> descriptors;

    using command = ::mip_3dm_filter_message_format;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_filter_message_format_write(device_, detail::count(descriptors),
                                                          descriptors.data());
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_filter_message_format_write(to_, detail::count(descriptors),
                                                     descriptors.data());
    }
};

/** Estimation filter message format: read. See mip_call_3dm_filter_message_format_read. */
struct read_filter_message_format
    : fixed_command<::mip_3dm_filter_message_format, ::mip::mip_3dm::filter_message_format_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Estimation filter message format: save. See mip_call_3dm_filter_message_format_save. */
struct save_filter_message_format
    : fixed_command<::mip_3dm_filter_message_format, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Estimation filter message format: load. See mip_call_3dm_filter_message_format_load. */
struct load_filter_message_format
    : fixed_command<::mip_3dm_filter_message_format, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Estimation filter message format: default. See mip_call_3dm_filter_message_format_default. */
struct default_filter_message_format
    : fixed_command<::mip_3dm_filter_message_format, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Get estimation filter data base rate. See mip_call_3dm_get_filter_base_rate. */
struct get_filter_base_rate
    : fixed_command<::mip_3dm_get_filter_base_rate, ::mip::mip_3dm::get_filter_base_rate_response> {
};

/** NMEA message format: write. See mip_call_3dm_nmea_message_format_write. */
struct write_nmea_message_format {
    span<const ::mip_nmea_message> format_entries;

    using command = ::mip_3dm_nmea_message_format;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_nmea_message_format_write(device_, detail::count(format_entries),
                                                        format_entries.data());
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_nmea_message_format_write(to_, detail::count(format_entries),
                                                   format_entries.data());
    }
};

/** NMEA message format: read. See mip_call_3dm_nmea_message_format_read. */
struct read_nmea_message_format
    : fixed_command<::mip_3dm_nmea_message_format, ::mip::mip_3dm::nmea_message_format_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** NMEA message format: save. See mip_call_3dm_nmea_message_format_save. */
struct save_nmea_message_format
    : fixed_command<::mip_3dm_nmea_message_format, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** NMEA message format: load. See mip_call_3dm_nmea_message_format_load. */
struct load_nmea_message_format
    : fixed_command<::mip_3dm_nmea_message_format, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** NMEA message format: default. See mip_call_3dm_nmea_message_format_default. */
struct default_nmea_message_format
    : fixed_command<::mip_3dm_nmea_message_format, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Poll data. See mip_call_3dm_poll_data. */
struct poll_data {
    uint8_t descriptor_set;
    bool suppress_ack;
    span<const uint8_t> descriptors;

    using command = ::mip_3dm_poll_data;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_poll_data(device_, descriptor_set, suppress_ack,
                                        detail::count(descriptors), descriptors.data());
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_poll_data_make(to_, descriptor_set, suppress_ack,
                                        detail::count(descriptors), descriptors.data());
    }
};

/** Get data base rate. See mip_call_3dm_get_base_rate. */
struct get_base_rate {
    uint8_t descriptor_set;

    using command = ::mip_3dm_get_base_rate;
    using response = ::mip::mip_3dm::get_base_rate_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_3dm_get_base_rate(device_, descriptor_set, to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_get_base_rate_make(to_, descriptor_set);
    }
};

/** Message format: write. See mip_call_3dm_message_format_write. */
struct write_message_format {
    uint8_t descriptor_set;
    span<const ::mip_descriptor_rate> descriptors;

    using command = ::mip_3dm_message_format;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_message_format_write(device_, descriptor_set,
                                                   detail::count(descriptors), descriptors.data());
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_message_format_write(to_, descriptor_set, detail::count(descriptors),
                                              descriptors.data());
    }
};

/** Message format: read. See mip_call_3dm_message_format_read. */
struct read_message_format {
    uint8_t descriptor_set;

    using command = ::mip_3dm_message_format;
    using response = ::mip::mip_3dm::message_format_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_3dm_message_format_read(device_, descriptor_set, to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_message_format_read(to_, descriptor_set);
    }
};

/** Message format: save. See mip_call_3dm_message_format_save. */
struct save_message_format {
    uint8_t descriptor_set;

    using command = ::mip_3dm_message_format;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_message_format_save(device_, descriptor_set);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_message_format_save(to_, descriptor_set);
    }
};

/** Message format: load. See mip_call_3dm_message_format_load. */
struct load_message_format {
    uint8_t descriptor_set;

    using command = ::mip_3dm_message_format;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_message_format_load(device_, descriptor_set);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_message_format_load(to_, descriptor_set);
    }
};

/** Message format: default. See mip_call_3dm_message_format_default. */
struct default_message_format {
    uint8_t descriptor_set;

    using command = ::mip_3dm_message_format;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_message_format_default(device_, descriptor_set);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_message_format_default(to_, descriptor_set);
    }
};

/** Factory streaming. See mip_call_3dm_factory_streaming. */
struct factory_streaming {
    ::mip::mip_3dm::factory_streaming_action action;

    using command = ::mip_3dm_factory_streaming;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_factory_streaming(
            device_, static_cast<enum mip_3dm_factory_streaming_action>(action));
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_factory_streaming_make(
            to_, static_cast<enum mip_3dm_factory_streaming_action>(action));
    }
};

/** Data stream control: write. See mip_call_3dm_data_stream_control_write. */
struct write_data_stream_control {
    uint8_t descriptor_set;
    bool enable;

    using command = ::mip_3dm_data_stream_control;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_data_stream_control_write(device_, descriptor_set, enable);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_data_stream_control_write(to_, descriptor_set, enable);
    }
};

/** Data stream control: read. See mip_call_3dm_data_stream_control_read. */
struct read_data_stream_control {
    uint8_t descriptor_set;

    using command = ::mip_3dm_data_stream_control;
    using response = ::mip::mip_3dm::data_stream_control_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_3dm_data_stream_control_read(device_, descriptor_set, to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_data_stream_control_read(to_, descriptor_set);
    }
};

/** Data stream control: save. See mip_call_3dm_data_stream_control_save. */
struct save_data_stream_control {
    uint8_t descriptor_set;

    using command = ::mip_3dm_data_stream_control;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_data_stream_control_save(device_, descriptor_set);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_data_stream_control_save(to_, descriptor_set);
    }
};

/** Data stream control: load. See mip_call_3dm_data_stream_control_load. */
struct load_data_stream_control {
    uint8_t descriptor_set;

    using command = ::mip_3dm_data_stream_control;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_data_stream_control_load(device_, descriptor_set);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_data_stream_control_load(to_, descriptor_set);
    }
};

/** Data stream control: default. See mip_call_3dm_data_stream_control_default. */
struct default_data_stream_control {
    uint8_t descriptor_set;

    using command = ::mip_3dm_data_stream_control;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_data_stream_control_default(device_, descriptor_set);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_data_stream_control_default(to_, descriptor_set);
    }
};

/** Raw RTCM 2.3 message. See mip_call_3dm_raw_rtcm_2_3_message. */
struct raw_rtcm_2_3_message {
    span<const uint8_t> data;

    using command = ::mip_3dm_raw_rtcm_2_3_message;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_raw_rtcm_2_3_message(device_, detail::count(data), data.data());
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_raw_rtcm_2_3_message_make(to_, detail::count(data), data.data());
    }
};

/** Constellation settings: write. See mip_call_3dm_constellation_settings_write. */
struct write_constellation_settings {
    uint16_t max_channels;
    span<const ::mip_3dm_constellation_settings_entry> settings;

    using command = ::mip_3dm_constellation_settings;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_constellation_settings_write(
            device_, max_channels, detail::count(settings), settings.data());
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_constellation_settings_write(to_, max_channels, detail::count(settings),
                                                      settings.data());
    }
};

/** Constellation settings: read. See mip_call_3dm_constellation_settings_read. */
struct read_constellation_settings
    : fixed_command<::mip_3dm_constellation_settings,
                    ::mip::mip_3dm::constellation_settings_response, MIP_FUNCTION_SELECTOR_READ> {};

/** Constellation settings: save. See mip_call_3dm_constellation_settings_save. */
struct save_constellation_settings
    : fixed_command<::mip_3dm_constellation_settings, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Constellation settings: load. See mip_call_3dm_constellation_settings_load. */
struct load_constellation_settings
    : fixed_command<::mip_3dm_constellation_settings, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Constellation settings: default. See mip_call_3dm_constellation_settings_default. */
struct default_constellation_settings
    : fixed_command<::mip_3dm_constellation_settings, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** GNSS SBAS settings: write. See mip_call_3dm_gnss_sbas_settings_write. */
struct write_gnss_sbas_settings {
    uint8_t enable_sbas;
    ::mip::mip_3dm::sbas_options sbas_options;
    span<const uint16_t> included_prns;

    using command = ::mip_3dm_gnss_sbas_settings;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_gnss_sbas_settings_write(
            device_, enable_sbas, ::mip::number(sbas_options), detail::count(included_prns),
            included_prns.data());
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_gnss_sbas_settings_write(to_, enable_sbas, ::mip::number(sbas_options),
                                                  detail::count(included_prns),
                                                  included_prns.data());
    }
};

/** GNSS SBAS settings: read. See mip_call_3dm_gnss_sbas_settings_read. */
struct read_gnss_sbas_settings
    : fixed_command<::mip_3dm_gnss_sbas_settings, ::mip::mip_3dm::gnss_sbas_settings_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** GNSS SBAS settings: save. See mip_call_3dm_gnss_sbas_settings_save. */
struct save_gnss_sbas_settings
    : fixed_command<::mip_3dm_gnss_sbas_settings, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** GNSS SBAS settings: load. See mip_call_3dm_gnss_sbas_settings_load. */
struct load_gnss_sbas_settings
    : fixed_command<::mip_3dm_gnss_sbas_settings, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** GNSS SBAS settings: default. See mip_call_3dm_gnss_sbas_settings_default. */
struct default_gnss_sbas_settings
    : fixed_command<::mip_3dm_gnss_sbas_settings, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** GNSS assisted fix: write. See mip_call_3dm_gnss_assisted_fix_write. */
struct write_gnss_assisted_fix {
    ::mip::mip_3dm::assisted_fix_option option;

    using command = ::mip_3dm_gnss_assisted_fix;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_gnss_assisted_fix_write(
            device_, static_cast<enum mip_3dm_assisted_fix_option>(option));
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_gnss_assisted_fix_write(
            to_, static_cast<enum mip_3dm_assisted_fix_option>(option));
    }
};

/** GNSS assisted fix: read. See mip_call_3dm_gnss_assisted_fix_read. */
struct read_gnss_assisted_fix {

    using command = ::mip_3dm_gnss_assisted_fix;
    using response = ::mip::mip_3dm::gnss_assisted_fix_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_3dm_gnss_assisted_fix_read(device_, to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_gnss_assisted_fix_read(to_);
    }
};

/** GNSS assisted fix: save. See mip_call_3dm_gnss_assisted_fix_save. */
struct save_gnss_assisted_fix {

    using command = ::mip_3dm_gnss_assisted_fix;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_gnss_assisted_fix_save(device_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_gnss_assisted_fix_save(to_);
    }
};

/** GNSS assisted fix: load. See mip_call_3dm_gnss_assisted_fix_load. */
struct load_gnss_assisted_fix {

    using command = ::mip_3dm_gnss_assisted_fix;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_gnss_assisted_fix_load(device_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_gnss_assisted_fix_load(to_);
    }
};

/** GNSS assisted fix: default. See mip_call_3dm_gnss_assisted_fix_default. */
struct default_gnss_assisted_fix {

    using command = ::mip_3dm_gnss_assisted_fix;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_gnss_assisted_fix_default(device_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_gnss_assisted_fix_default(to_);
    }
};

/** GNSS time assistance: write. See mip_call_3dm_gnss_time_assistance_write. */
struct write_gnss_time_assistance {
    double tow;
    uint16_t week_number;
    float accuracy;

    using command = ::mip_3dm_gnss_time_assistance;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_gnss_time_assistance_write(device_, tow, week_number, accuracy);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_gnss_time_assistance_write(to_, tow, week_number, accuracy);
    }
};

/** GNSS time assistance: read. See mip_call_3dm_gnss_time_assistance_read. */
struct read_gnss_time_assistance
    : fixed_command<::mip_3dm_gnss_time_assistance, ::mip::mip_3dm::gnss_time_assistance_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** PPS source control: write. See mip_call_3dm_pps_source_control_write. */
struct write_pps_source_control {
    ::mip::mip_3dm::pps_source source;

    using command = ::mip_3dm_pps_source_control;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_pps_source_control_write(
            device_, static_cast<enum mip_3dm_pps_source>(source));
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_pps_source_control_write(to_,
                                                  static_cast<enum mip_3dm_pps_source>(source));
    }
};

/** PPS source control: read. See mip_call_3dm_pps_source_control_read. */
struct read_pps_source_control
    : fixed_command<::mip_3dm_pps_source_control, ::mip::mip_3dm::pps_source_control_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** PPS source control: save. See mip_call_3dm_pps_source_control_save. */
struct save_pps_source_control
    : fixed_command<::mip_3dm_pps_source_control, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** PPS source control: load. See mip_call_3dm_pps_source_control_load. */
struct load_pps_source_control
    : fixed_command<::mip_3dm_pps_source_control, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** PPS source control: default. See mip_call_3dm_pps_source_control_default. */
struct default_pps_source_control
    : fixed_command<::mip_3dm_pps_source_control, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Get supported events. See mip_call_3dm_get_event_support. */
struct get_event_support {
    ::mip::mip_3dm::event_support_query query;

    using command = ::mip_3dm_get_event_support;
    using response = ::mip::mip_3dm::get_event_support_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_3dm_get_event_support(
            device_, static_cast<enum mip_3dm_event_support_query>(query), to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_get_event_support_make(
            to_, static_cast<enum mip_3dm_event_support_query>(query));
    }
};

/** Event control: write. See mip_call_3dm_event_control_write. */
struct write_event_control {
    uint8_t instance;
    ::mip::event_trigger_mode mode;

    using command = ::mip_3dm_event_control;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_event_control_write(device_, instance,
                                                  static_cast<enum mip_event_trigger_mode>(mode));
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_event_control_write(to_, instance,
                                             static_cast<enum mip_event_trigger_mode>(mode));
    }
};

/** Event control: read. See mip_call_3dm_event_control_read. */
struct read_event_control {
    uint8_t instance;

    using command = ::mip_3dm_event_control;
    using response = ::mip::mip_3dm::event_control_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_3dm_event_control_read(device_, instance, to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_event_control_read(to_, instance);
    }
};

/** Event control: save. See mip_call_3dm_event_control_save. */
struct save_event_control {
    uint8_t instance;

    using command = ::mip_3dm_event_control;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_event_control_save(device_, instance);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_event_control_save(to_, instance);
    }
};

/** Event control: load. See mip_call_3dm_event_control_load. */
struct load_event_control {
    uint8_t instance;

    using command = ::mip_3dm_event_control;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_event_control_load(device_, instance);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_event_control_load(to_, instance);
    }
};

/** Event control: default. See mip_call_3dm_event_control_default. */
struct default_event_control {
    uint8_t instance;

    using command = ::mip_3dm_event_control;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_event_control_default(device_, instance);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_event_control_default(to_, instance);
    }
};

/** Get event trigger status. See mip_call_3dm_get_event_trigger_status. */
struct get_event_trigger_status {
    span<const uint8_t> requested_instances;

    using command = ::mip_3dm_get_event_trigger_status;
    using response = ::mip::mip_3dm::get_event_trigger_status_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_3dm_get_event_trigger_status(device_, detail::count(requested_instances),
                                                       requested_instances.data(), to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_get_event_trigger_status_make(to_, detail::count(requested_instances),
                                                       requested_instances.data());
    }
};

/** Get event action status. See mip_call_3dm_get_event_action_status. */
struct get_event_action_status {
    span<const uint8_t> requested_instances;

    using command = ::mip_3dm_get_event_action_status;
    using response = ::mip::mip_3dm::get_event_action_status_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_3dm_get_event_action_status(device_, detail::count(requested_instances),
                                                      requested_instances.data(), to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_get_event_action_status_make(to_, detail::count(requested_instances),
                                                      requested_instances.data());
    }
};

/** Event trigger configuration: write. See mip_call_3dm_event_trigger_config_write. */
struct write_event_trigger_config {
    uint8_t instance;
    ::mip::event_trigger_type type;
    ::mip_3dm_event_trigger_config_parameters parameters;

    using command = ::mip_3dm_event_trigger_config;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_event_trigger_config_write(
            device_, instance, static_cast<enum mip_event_trigger_type>(type), &parameters);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_event_trigger_config_write(
            to_, instance, static_cast<enum mip_event_trigger_type>(type), &parameters);
    }
};

/** Event trigger configuration: read. See mip_call_3dm_event_trigger_config_read. */
struct read_event_trigger_config {
    uint8_t instance;

    using command = ::mip_3dm_event_trigger_config;
    using response = ::mip::mip_3dm::event_trigger_config_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_3dm_event_trigger_config_read(device_, instance, to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_event_trigger_config_read(to_, instance);
    }
};

/** Event trigger configuration: save. See mip_call_3dm_event_trigger_config_save. */
struct save_event_trigger_config {
    uint8_t instance;

    using command = ::mip_3dm_event_trigger_config;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_event_trigger_config_save(device_, instance);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_event_trigger_config_save(to_, instance);
    }
};

/** Event trigger configuration: load. See mip_call_3dm_event_trigger_config_load. */
struct load_event_trigger_config {
    uint8_t instance;

    using command = ::mip_3dm_event_trigger_config;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_event_trigger_config_load(device_, instance);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_event_trigger_config_load(to_, instance);
    }
};

/** Event trigger configuration: default. See mip_call_3dm_event_trigger_config_default. */
struct default_event_trigger_config {
    uint8_t instance;

    using command = ::mip_3dm_event_trigger_config;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_event_trigger_config_default(device_, instance);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_event_trigger_config_default(to_, instance);
    }
};

/** Event action configuration: write. See mip_call_3dm_event_action_config_write. */
struct write_event_action_config {
    uint8_t instance;
    uint8_t trigger;
    ::mip::event_action_type type;
    ::mip_3dm_event_action_config_parameters parameters;

    using command = ::mip_3dm_event_action_config;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_event_action_config_write(
            device_, instance, trigger, static_cast<enum mip_event_action_type>(type), &parameters);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_event_action_config_write(
            to_, instance, trigger, static_cast<enum mip_event_action_type>(type), &parameters);
    }
};

/** Event action configuration: read. See mip_call_3dm_event_action_config_read. */
struct read_event_action_config {
    uint8_t instance;

    using command = ::mip_3dm_event_action_config;
    using response = ::mip::mip_3dm::event_action_config_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_3dm_event_action_config_read(device_, instance, to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_event_action_config_read(to_, instance);
    }
};

/** Event action configuration: save. See mip_call_3dm_event_action_config_save. */
struct save_event_action_config {
    uint8_t instance;

    using command = ::mip_3dm_event_action_config;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_event_action_config_save(device_, instance);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_event_action_config_save(to_, instance);
    }
};

/** Event action configuration: load. See mip_call_3dm_event_action_config_load. */
struct load_event_action_config {
    uint8_t instance;

    using command = ::mip_3dm_event_action_config;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_event_action_config_load(device_, instance);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_event_action_config_load(to_, instance);
    }
};

/** Event action configuration: default. See mip_call_3dm_event_action_config_default. */
struct default_event_action_config {
    uint8_t instance;

    using command = ::mip_3dm_event_action_config;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_event_action_config_default(device_, instance);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_event_action_config_default(to_, instance);
    }
};

/** Device start up settings: save. See mip_call_3dm_device_settings_save. */
struct save_device_settings
    : fixed_command<::mip_3dm_device_settings, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Device start up settings: load. See mip_call_3dm_device_settings_load. */
struct load_device_settings
    : fixed_command<::mip_3dm_device_settings, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Device start up settings: default. See mip_call_3dm_device_settings_default. */
struct default_device_settings
    : fixed_command<::mip_3dm_device_settings, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/**
 * Sensor-to-vehicle frame transformation Euler: write. See
 * mip_call_3dm_sensor_to_vehicle_transform_euler_write.
 */
struct write_sensor_to_vehicle_transform_euler {
    float roll;
    float pitch;
    float yaw;

    using command = ::mip_3dm_sensor_to_vehicle_transform_euler;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_sensor_to_vehicle_transform_euler_write(device_, roll, pitch, yaw);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_sensor_to_vehicle_transform_euler_write(to_, roll, pitch, yaw);
    }
};

/**
 * Sensor-to-vehicle frame transformation Euler: read. See
 * mip_call_3dm_sensor_to_vehicle_transform_euler_read.
 */
struct read_sensor_to_vehicle_transform_euler
    : fixed_command<::mip_3dm_sensor_to_vehicle_transform_euler,
                    ::mip::mip_3dm::sensor_to_vehicle_transform_euler_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/**
 * Sensor-to-vehicle frame transformation Euler: save. See
 * mip_call_3dm_sensor_to_vehicle_transform_euler_save.
 */
struct save_sensor_to_vehicle_transform_euler
    : fixed_command<::mip_3dm_sensor_to_vehicle_transform_euler, void, MIP_FUNCTION_SELECTOR_SAVE> {
};

/**
 * Sensor-to-vehicle frame transformation Euler: load. See
 * mip_call_3dm_sensor_to_vehicle_transform_euler_load.
 */
struct load_sensor_to_vehicle_transform_euler
    : fixed_command<::mip_3dm_sensor_to_vehicle_transform_euler, void, MIP_FUNCTION_SELECTOR_LOAD> {
};

/**
 * Sensor-to-vehicle frame transformation Euler: default. See
 * mip_call_3dm_sensor_to_vehicle_transform_euler_default.
 */
struct default_sensor_to_vehicle_transform_euler
    : fixed_command<::mip_3dm_sensor_to_vehicle_transform_euler, void,
                    MIP_FUNCTION_SELECTOR_DEFAULT> {};

/**
 * Sensor-to-vehicle frame transformation quaternion: write. See
 * mip_call_3dm_sensor_to_vehicle_transform_quaternion_write.
 */
struct write_sensor_to_vehicle_transform_quaternion {
    float q[4];

    using command = ::mip_3dm_sensor_to_vehicle_transform_quaternion;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_sensor_to_vehicle_transform_quaternion_write(device_, q);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_sensor_to_vehicle_transform_quaternion_write(to_, q);
    }
};

/**
 * Sensor-to-vehicle frame transformation quaternion: read. See
 * mip_call_3dm_sensor_to_vehicle_transform_quaternion_read.
 */
struct read_sensor_to_vehicle_transform_quaternion
    : fixed_command<::mip_3dm_sensor_to_vehicle_transform_quaternion,
                    ::mip::mip_3dm::sensor_to_vehicle_transform_quaternion_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/**
 * Sensor-to-vehicle frame transformation quaternion: save. See
 * mip_call_3dm_sensor_to_vehicle_transform_quaternion_save.
 */
struct save_sensor_to_vehicle_transform_quaternion
    : fixed_command<::mip_3dm_sensor_to_vehicle_transform_quaternion, void,
                    MIP_FUNCTION_SELECTOR_SAVE> {};

/**
 * Sensor-to-vehicle frame transformation quaternion: load. See
 * mip_call_3dm_sensor_to_vehicle_transform_quaternion_load.
 */
struct load_sensor_to_vehicle_transform_quaternion
    : fixed_command<::mip_3dm_sensor_to_vehicle_transform_quaternion, void,
                    MIP_FUNCTION_SELECTOR_LOAD> {};

/**
 * Sensor-to-vehicle frame transformation quaternion: default. See
 * mip_call_3dm_sensor_to_vehicle_transform_quaternion_default.
 */
struct default_sensor_to_vehicle_transform_quaternion
    : fixed_command<::mip_3dm_sensor_to_vehicle_transform_quaternion, void,
                    MIP_FUNCTION_SELECTOR_DEFAULT> {};

/**
 * Sensor-to-vehicle frame transformation direction cosine matrix: write. See
 * mip_call_3dm_sensor_to_vehicle_transform_dcm_write.
 */
struct write_sensor_to_vehicle_transform_dcm {
    float dcm[9];

    using command = ::mip_3dm_sensor_to_vehicle_transform_dcm;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_sensor_to_vehicle_transform_dcm_write(device_, dcm);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_sensor_to_vehicle_transform_dcm_write(to_, dcm);
    }
};

/**
 * Sensor-to-vehicle frame transformation direction cosine matrix: read. See
 * mip_call_3dm_sensor_to_vehicle_transform_dcm_read.
 */
struct read_sensor_to_vehicle_transform_dcm
    : fixed_command<::mip_3dm_sensor_to_vehicle_transform_dcm,
                    ::mip::mip_3dm::sensor_to_vehicle_transform_dcm_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/**
 * Sensor-to-vehicle frame transformation direction cosine matrix: save. See
 * mip_call_3dm_sensor_to_vehicle_transform_dcm_save.
 */
struct save_sensor_to_vehicle_transform_dcm
    : fixed_command<::mip_3dm_sensor_to_vehicle_transform_dcm, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/**
 * Sensor-to-vehicle frame transformation direction cosine matrix: load. See
 * mip_call_3dm_sensor_to_vehicle_transform_dcm_load.
 */
struct load_sensor_to_vehicle_transform_dcm
    : fixed_command<::mip_3dm_sensor_to_vehicle_transform_dcm, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/**
 * Sensor-to-vehicle frame transformation direction cosine matrix: default. See
 * mip_call_3dm_sensor_to_vehicle_transform_dcm_default.
 */
struct default_sensor_to_vehicle_transform_dcm
    : fixed_command<::mip_3dm_sensor_to_vehicle_transform_dcm, void,
                    MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** GPS dynamics mode: write. See mip_call_3dm_gps_dynamics_mode_write. */
struct write_gps_dynamics_mode {
    ::mip::mip_3dm::receiver_dynamics mode;

    using command = ::mip_3dm_gps_dynamics_mode;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_gps_dynamics_mode_write(
            device_, static_cast<enum mip_3dm_receiver_dynamics>(mode));
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_gps_dynamics_mode_write(to_,
                                                 static_cast<enum mip_3dm_receiver_dynamics>(mode));
    }
};

/** GPS dynamics mode: read. See mip_call_3dm_gps_dynamics_mode_read. */
struct read_gps_dynamics_mode
    : fixed_command<::mip_3dm_gps_dynamics_mode, ::mip::mip_3dm::gps_dynamics_mode_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** GPS dynamics mode: save. See mip_call_3dm_gps_dynamics_mode_save. */
struct save_gps_dynamics_mode
    : fixed_command<::mip_3dm_gps_dynamics_mode, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** GPS dynamics mode: load. See mip_call_3dm_gps_dynamics_mode_load. */
struct load_gps_dynamics_mode
    : fixed_command<::mip_3dm_gps_dynamics_mode, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** GPS dynamics mode: default. See mip_call_3dm_gps_dynamics_mode_default. */
struct default_gps_dynamics_mode
    : fixed_command<::mip_3dm_gps_dynamics_mode, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** IMU signal conditioning: write. See mip_call_3dm_imu_signal_conditioning_write. */
struct write_imu_signal_conditioning {
    uint16_t orientation_decimation;
    ::mip::mip_3dm::data_conditioning_flags data_conditioning_flags;
    uint8_t inertial_filter_width;
    uint8_t mag_filter_width;
    uint16_t up_compensation;
    uint16_t north_compensation;
    ::mip::mip_3dm::mag_bandwidth mag_bandwidth;

    using command = ::mip_3dm_imu_signal_conditioning;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_imu_signal_conditioning_write(
            device_, orientation_decimation, ::mip::number(data_conditioning_flags),
            inertial_filter_width, mag_filter_width, up_compensation, north_compensation,
            static_cast<enum mip_3dm_mag_bandwidth>(mag_bandwidth));
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_imu_signal_conditioning_write(
            to_, orientation_decimation, ::mip::number(data_conditioning_flags),
            inertial_filter_width, mag_filter_width, up_compensation, north_compensation,
            static_cast<enum mip_3dm_mag_bandwidth>(mag_bandwidth));
    }
};

/** IMU signal conditioning: read. See mip_call_3dm_imu_signal_conditioning_read. */
struct read_imu_signal_conditioning
    : fixed_command<::mip_3dm_imu_signal_conditioning,
                    ::mip::mip_3dm::imu_signal_conditioning_response, MIP_FUNCTION_SELECTOR_READ> {
};

/** IMU signal conditioning: save. See mip_call_3dm_imu_signal_conditioning_save. */
struct save_imu_signal_conditioning
    : fixed_command<::mip_3dm_imu_signal_conditioning, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** IMU signal conditioning: load. See mip_call_3dm_imu_signal_conditioning_load. */
struct load_imu_signal_conditioning
    : fixed_command<::mip_3dm_imu_signal_conditioning, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** IMU signal conditioning: default. See mip_call_3dm_imu_signal_conditioning_default. */
struct default_imu_signal_conditioning
    : fixed_command<::mip_3dm_imu_signal_conditioning, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** IMU timestamp: write. See mip_call_3dm_imu_timestamp_write. */
struct write_imu_timestamp {
    ::mip::mip_3dm::imu_timestamp_selector selector;
    uint32_t time;

    using command = ::mip_3dm_imu_timestamp;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_imu_timestamp_write(
            device_, static_cast<enum mip_3dm_imu_timestamp_selector>(selector), time);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_imu_timestamp_write(
            to_, static_cast<enum mip_3dm_imu_timestamp_selector>(selector), time);
    }
};

/** IMU timestamp: read. See mip_call_3dm_imu_timestamp_read. */
struct read_imu_timestamp {
    ::mip::mip_3dm::imu_timestamp_selector selector;

    using command = ::mip_3dm_imu_timestamp;
    using response = ::mip::mip_3dm::imu_timestamp_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_3dm_imu_timestamp_read(
            device_, static_cast<enum mip_3dm_imu_timestamp_selector>(selector), to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_imu_timestamp_read(
            to_, static_cast<enum mip_3dm_imu_timestamp_selector>(selector));
    }
};

/** Accelerometer bias configuration: write. See mip_call_3dm_accel_bias_write. */
struct write_accel_bias {
    float bias[3];

    using command = ::mip_3dm_accel_bias;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_accel_bias_write(device_, bias);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_accel_bias_write(to_, bias);
    }
};

/** Accelerometer bias configuration: read. See mip_call_3dm_accel_bias_read. */
struct read_accel_bias : fixed_command<::mip_3dm_accel_bias, ::mip::mip_3dm::accel_bias_response,
                                       MIP_FUNCTION_SELECTOR_READ> {};

/** Accelerometer bias configuration: save. See mip_call_3dm_accel_bias_save. */
struct save_accel_bias : fixed_command<::mip_3dm_accel_bias, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Accelerometer bias configuration: load. See mip_call_3dm_accel_bias_load. */
struct load_accel_bias : fixed_command<::mip_3dm_accel_bias, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Accelerometer bias configuration: default. See mip_call_3dm_accel_bias_default. */
struct default_accel_bias
    : fixed_command<::mip_3dm_accel_bias, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Accelerometer bias configuration: apply. See mip_call_3dm_accel_bias_apply. */
struct apply_accel_bias {
    float bias[3];

    using command = ::mip_3dm_accel_bias;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_accel_bias_apply(device_, bias);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_accel_bias_apply(to_, bias);
    }
};

/** Gyroscope bias configuration: write. See mip_call_3dm_gyro_bias_write. */
struct write_gyro_bias {
    float bias[3];

    using command = ::mip_3dm_gyro_bias;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_gyro_bias_write(device_, bias);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_gyro_bias_write(to_, bias);
    }
};

/** Gyroscope bias configuration: read. See mip_call_3dm_gyro_bias_read. */
struct read_gyro_bias : fixed_command<::mip_3dm_gyro_bias, ::mip::mip_3dm::gyro_bias_response,
                                      MIP_FUNCTION_SELECTOR_READ> {};

/** Gyroscope bias configuration: save. See mip_call_3dm_gyro_bias_save. */
struct save_gyro_bias : fixed_command<::mip_3dm_gyro_bias, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Gyroscope bias configuration: load. See mip_call_3dm_gyro_bias_load. */
struct load_gyro_bias : fixed_command<::mip_3dm_gyro_bias, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Gyroscope bias configuration: default. See mip_call_3dm_gyro_bias_default. */
struct default_gyro_bias : fixed_command<::mip_3dm_gyro_bias, void, MIP_FUNCTION_SELECTOR_DEFAULT> {
};

/** Gyroscope bias configuration: apply. See mip_call_3dm_gyro_bias_apply. */
struct apply_gyro_bias {
    float bias[3];

    using command = ::mip_3dm_gyro_bias;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_gyro_bias_apply(device_, bias);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_gyro_bias_apply(to_, bias);
    }
};

/** Capture gyroscope bias. See mip_call_3dm_capture_gyro_bias. */
struct capture_gyro_bias {
    uint16_t averaging_time_ms;

    using command = ::mip_3dm_capture_gyro_bias;
    using response = ::mip::mip_3dm::gyro_bias_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_3dm_capture_gyro_bias(device_, averaging_time_ms, to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_capture_gyro_bias_make(to_, averaging_time_ms);
    }
};

/** Magnetometer hard iron offset: write. See mip_call_3dm_mag_hard_iron_offset_write. */
struct write_mag_hard_iron_offset {
    float offset[3];

    using command = ::mip_3dm_mag_hard_iron_offset;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_mag_hard_iron_offset_write(device_, offset);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_mag_hard_iron_offset_write(to_, offset);
    }
};

/** Magnetometer hard iron offset: read. See mip_call_3dm_mag_hard_iron_offset_read. */
struct read_mag_hard_iron_offset
    : fixed_command<::mip_3dm_mag_hard_iron_offset, ::mip::mip_3dm::mag_hard_iron_offset_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Magnetometer hard iron offset: save. See mip_call_3dm_mag_hard_iron_offset_save. */
struct save_mag_hard_iron_offset
    : fixed_command<::mip_3dm_mag_hard_iron_offset, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Magnetometer hard iron offset: load. See mip_call_3dm_mag_hard_iron_offset_load. */
struct load_mag_hard_iron_offset
    : fixed_command<::mip_3dm_mag_hard_iron_offset, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Magnetometer hard iron offset: default. See mip_call_3dm_mag_hard_iron_offset_default. */
struct default_mag_hard_iron_offset
    : fixed_command<::mip_3dm_mag_hard_iron_offset, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Magnetometer hard iron offset: apply. See mip_call_3dm_mag_hard_iron_offset_apply. */
struct apply_mag_hard_iron_offset {
    float offset[3];

    using command = ::mip_3dm_mag_hard_iron_offset;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_mag_hard_iron_offset_apply(device_, offset);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_mag_hard_iron_offset_apply(to_, offset);
    }
};

/** Magnetometer soft iron matrix: write. See mip_call_3dm_mag_soft_iron_matrix_write. */
struct write_mag_soft_iron_matrix {
    float matrix[9];

    using command = ::mip_3dm_mag_soft_iron_matrix;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_mag_soft_iron_matrix_write(device_, matrix);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_mag_soft_iron_matrix_write(to_, matrix);
    }
};

/** Magnetometer soft iron matrix: read. See mip_call_3dm_mag_soft_iron_matrix_read. */
struct read_mag_soft_iron_matrix
    : fixed_command<::mip_3dm_mag_soft_iron_matrix, ::mip::mip_3dm::mag_soft_iron_matrix_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Magnetometer soft iron matrix: save. See mip_call_3dm_mag_soft_iron_matrix_save. */
struct save_mag_soft_iron_matrix
    : fixed_command<::mip_3dm_mag_soft_iron_matrix, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Magnetometer soft iron matrix: load. See mip_call_3dm_mag_soft_iron_matrix_load. */
struct load_mag_soft_iron_matrix
    : fixed_command<::mip_3dm_mag_soft_iron_matrix, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Magnetometer soft iron matrix: default. See mip_call_3dm_mag_soft_iron_matrix_default. */
struct default_mag_soft_iron_matrix
    : fixed_command<::mip_3dm_mag_soft_iron_matrix, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Magnetometer soft iron matrix: apply. See mip_call_3dm_mag_soft_iron_matrix_apply. */
struct apply_mag_soft_iron_matrix {
    float matrix[9];

    using command = ::mip_3dm_mag_soft_iron_matrix;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_mag_soft_iron_matrix_apply(device_, matrix);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_mag_soft_iron_matrix_apply(to_, matrix);
    }
};

/** Coning and sculling enable: write. See mip_call_3dm_coning_sculling_enable_write. */
struct write_coning_sculling_enable {
    bool enable;

    using command = ::mip_3dm_coning_sculling_enable;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_coning_sculling_enable_write(device_, enable);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_coning_sculling_enable_write(to_, enable);
    }
};

/** Coning and sculling enable: read. See mip_call_3dm_coning_sculling_enable_read. */
struct read_coning_sculling_enable
    : fixed_command<::mip_3dm_coning_sculling_enable,
                    ::mip::mip_3dm::coning_sculling_enable_response, MIP_FUNCTION_SELECTOR_READ> {};

/** Coning and sculling enable: save. See mip_call_3dm_coning_sculling_enable_save. */
struct save_coning_sculling_enable
    : fixed_command<::mip_3dm_coning_sculling_enable, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Coning and sculling enable: load. See mip_call_3dm_coning_sculling_enable_load. */
struct load_coning_sculling_enable
    : fixed_command<::mip_3dm_coning_sculling_enable, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Coning and sculling enable: default. See mip_call_3dm_coning_sculling_enable_default. */
struct default_coning_sculling_enable
    : fixed_command<::mip_3dm_coning_sculling_enable, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** UART baud rate: write. See mip_call_3dm_uart_baud_rate_write. */
struct write_uart_baud_rate {
    uint32_t baud;

    using command = ::mip_3dm_uart_baud_rate;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_uart_baud_rate_write(device_, baud);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_uart_baud_rate_write(to_, baud);
    }
};

/** UART baud rate: read. See mip_call_3dm_uart_baud_rate_read. */
struct read_uart_baud_rate
    : fixed_command<::mip_3dm_uart_baud_rate, ::mip::mip_3dm::uart_baud_rate_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** UART baud rate: save. See mip_call_3dm_uart_baud_rate_save. */
struct save_uart_baud_rate
    : fixed_command<::mip_3dm_uart_baud_rate, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** UART baud rate: load. See mip_call_3dm_uart_baud_rate_load. */
struct load_uart_baud_rate
    : fixed_command<::mip_3dm_uart_baud_rate, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** UART baud rate: default. See mip_call_3dm_uart_baud_rate_default. */
struct default_uart_baud_rate
    : fixed_command<::mip_3dm_uart_baud_rate, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** GPIO configuration: write. See mip_call_3dm_gpio_config_write. */
struct write_gpio_config {
    uint8_t pin;
    ::mip::gpio_feature feature;
    uint8_t behavior;
    ::mip::gpio_pin_mode pin_mode;

    using command = ::mip_3dm_gpio_config;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_gpio_config_write(device_, pin,
                                                static_cast<enum mip_gpio_feature>(feature),
                                                behavior, ::mip::number(pin_mode));
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_gpio_config_write(to_, pin, static_cast<enum mip_gpio_feature>(feature),
                                           behavior, ::mip::number(pin_mode));
    }
};

/** GPIO configuration: read. See mip_call_3dm_gpio_config_read. */
struct read_gpio_config {
    uint8_t pin;

    using command = ::mip_3dm_gpio_config;
    using response = ::mip::mip_3dm::gpio_config_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_3dm_gpio_config_read(device_, pin, to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_gpio_config_read(to_, pin);
    }
};

/** GPIO configuration: save. See mip_call_3dm_gpio_config_save. */
struct save_gpio_config {
    uint8_t pin;

    using command = ::mip_3dm_gpio_config;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_gpio_config_save(device_, pin);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_gpio_config_save(to_, pin);
    }
};

/** GPIO configuration: load. See mip_call_3dm_gpio_config_load. */
struct load_gpio_config {
    uint8_t pin;

    using command = ::mip_3dm_gpio_config;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_gpio_config_load(device_, pin);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_gpio_config_load(to_, pin);
    }
};

/** GPIO configuration: default. See mip_call_3dm_gpio_config_default. */
struct default_gpio_config {
    uint8_t pin;

    using command = ::mip_3dm_gpio_config;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_gpio_config_default(device_, pin);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_gpio_config_default(to_, pin);
    }
};

/** GPIO state: write. See mip_call_3dm_gpio_state_write. */
struct write_gpio_state {
    uint8_t pin;
    bool state;

    using command = ::mip_3dm_gpio_state;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_gpio_state_write(device_, pin, state);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_gpio_state_write(to_, pin, state);
    }
};

/** GPIO state: read. See mip_call_3dm_gpio_state_read. */
struct read_gpio_state {
    uint8_t pin;

    using command = ::mip_3dm_gpio_state;
    using response = ::mip::mip_3dm::gpio_state_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_3dm_gpio_state_read(device_, pin, to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_gpio_state_read(to_, pin);
    }
};

/** Odometer configuration: write. See mip_call_3dm_odometer_config_write. */
struct write_odometer_config {
    ::mip::mip_3dm::odometer_mode mode;
    float scaling;
    float uncertainty;

    using command = ::mip_3dm_odometer_config;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_odometer_config_write(
            device_, static_cast<enum mip_3dm_odometer_mode>(mode), scaling, uncertainty);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_odometer_config_write(to_, static_cast<enum mip_3dm_odometer_mode>(mode),
                                               scaling, uncertainty);
    }
};

/** Odometer configuration: read. See mip_call_3dm_odometer_config_read. */
struct read_odometer_config
    : fixed_command<::mip_3dm_odometer_config, ::mip::mip_3dm::odometer_config_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Odometer configuration: save. See mip_call_3dm_odometer_config_save. */
struct save_odometer_config
    : fixed_command<::mip_3dm_odometer_config, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Odometer configuration: load. See mip_call_3dm_odometer_config_load. */
struct load_odometer_config
    : fixed_command<::mip_3dm_odometer_config, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Odometer configuration: default. See mip_call_3dm_odometer_config_default. */
struct default_odometer_config
    : fixed_command<::mip_3dm_odometer_config, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Advanced low-pass filter settings: write. See mip_call_3dm_imu_low_pass_filter_write. */
struct write_imu_low_pass_filter {
    uint8_t target_descriptor;
    bool enable;
    bool manual;
    uint16_t frequency;

    using command = ::mip_3dm_imu_low_pass_filter;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_imu_low_pass_filter_write(device_, target_descriptor, enable, manual,
                                                        frequency);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_imu_low_pass_filter_write(to_, target_descriptor, enable, manual,
                                                   frequency);
    }
};

/** Advanced low-pass filter settings: read. See mip_call_3dm_imu_low_pass_filter_read. */
struct read_imu_low_pass_filter {
    uint8_t target_descriptor;

    using command = ::mip_3dm_imu_low_pass_filter;
    using response = ::mip::mip_3dm::imu_low_pass_filter_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_3dm_imu_low_pass_filter_read(device_, target_descriptor, to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_imu_low_pass_filter_read(to_, target_descriptor);
    }
};

/** Advanced low-pass filter settings: save. See mip_call_3dm_imu_low_pass_filter_save. */
struct save_imu_low_pass_filter {
    uint8_t target_descriptor;

    using command = ::mip_3dm_imu_low_pass_filter;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_imu_low_pass_filter_save(device_, target_descriptor);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_imu_low_pass_filter_save(to_, target_descriptor);
    }
};

/** Advanced low-pass filter settings: load. See mip_call_3dm_imu_low_pass_filter_load. */
struct load_imu_low_pass_filter {
    uint8_t target_descriptor;

    using command = ::mip_3dm_imu_low_pass_filter;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_imu_low_pass_filter_load(device_, target_descriptor);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_imu_low_pass_filter_load(to_, target_descriptor);
    }
};

/** Advanced low-pass filter settings: default. See mip_call_3dm_imu_low_pass_filter_default. */
struct default_imu_low_pass_filter {
    uint8_t target_descriptor;

    using command = ::mip_3dm_imu_low_pass_filter;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_imu_low_pass_filter_default(device_, target_descriptor);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_imu_low_pass_filter_default(to_, target_descriptor);
    }
};

/** Complementary filter configuration: write. See mip_call_3dm_complementary_filter_write. */
struct write_complementary_filter {
    bool pitch_roll_enable;
    bool heading_enable;
    float pitch_roll_time_constant;
    float heading_time_constant;

    using command = ::mip_3dm_complementary_filter;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_complementary_filter_write(device_, pitch_roll_enable, heading_enable,
                                                         pitch_roll_time_constant,
                                                         heading_time_constant);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_complementary_filter_write(to_, pitch_roll_enable, heading_enable,
                                                    pitch_roll_time_constant,
                                                    heading_time_constant);
    }
};

/** Complementary filter configuration: read. See mip_call_3dm_complementary_filter_read. */
struct read_complementary_filter
    : fixed_command<::mip_3dm_complementary_filter, ::mip::mip_3dm::complementary_filter_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Complementary filter configuration: save. See mip_call_3dm_complementary_filter_save. */
struct save_complementary_filter
    : fixed_command<::mip_3dm_complementary_filter, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Complementary filter configuration: load. See mip_call_3dm_complementary_filter_load. */
struct load_complementary_filter
    : fixed_command<::mip_3dm_complementary_filter, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Complementary filter configuration: default. See mip_call_3dm_complementary_filter_default. */
struct default_complementary_filter
    : fixed_command<::mip_3dm_complementary_filter, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Sensor range: write. See mip_call_3dm_sensor_range_write. */
struct write_sensor_range {
    ::mip::mip_3dm::sensor_range_type sensor;
    uint8_t setting;

    using command = ::mip_3dm_sensor_range;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_sensor_range_write(
            device_, static_cast<enum mip_3dm_sensor_range_type>(sensor), setting);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_sensor_range_write(
            to_, static_cast<enum mip_3dm_sensor_range_type>(sensor), setting);
    }
};

/** Sensor range: read. See mip_call_3dm_sensor_range_read. */
struct read_sensor_range {
    ::mip::mip_3dm::sensor_range_type sensor;

    using command = ::mip_3dm_sensor_range;
    using response = ::mip::mip_3dm::sensor_range_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_3dm_sensor_range_read(
            device_, static_cast<enum mip_3dm_sensor_range_type>(sensor), to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_sensor_range_read(to_,
                                           static_cast<enum mip_3dm_sensor_range_type>(sensor));
    }
};

/** Sensor range: save. See mip_call_3dm_sensor_range_save. */
struct save_sensor_range {
    ::mip::mip_3dm::sensor_range_type sensor;

    using command = ::mip_3dm_sensor_range;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_sensor_range_save(
            device_, static_cast<enum mip_3dm_sensor_range_type>(sensor));
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_sensor_range_save(to_,
                                           static_cast<enum mip_3dm_sensor_range_type>(sensor));
    }
};

/** Sensor range: load. See mip_call_3dm_sensor_range_load. */
struct load_sensor_range {
    ::mip::mip_3dm::sensor_range_type sensor;

    using command = ::mip_3dm_sensor_range;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_sensor_range_load(
            device_, static_cast<enum mip_3dm_sensor_range_type>(sensor));
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_sensor_range_load(to_,
                                           static_cast<enum mip_3dm_sensor_range_type>(sensor));
    }
};

/** Sensor range: default. See mip_call_3dm_sensor_range_default. */
struct default_sensor_range {
    ::mip::mip_3dm::sensor_range_type sensor;

    using command = ::mip_3dm_sensor_range;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_sensor_range_default(
            device_, static_cast<enum mip_3dm_sensor_range_type>(sensor));
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_sensor_range_default(to_,
                                              static_cast<enum mip_3dm_sensor_range_type>(sensor));
    }
};

/** Get calibrated sensor ranges. See mip_call_3dm_get_calibrated_sensor_ranges. */
struct get_calibrated_sensor_ranges {
    ::mip::mip_3dm::sensor_range_type sensor;

    using command = ::mip_3dm_get_calibrated_sensor_ranges;
    using response = ::mip::mip_3dm::get_calibrated_sensor_ranges_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_3dm_get_calibrated_sensor_ranges(
            device_, static_cast<enum mip_3dm_sensor_range_type>(sensor), to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_get_calibrated_sensor_ranges_make(
            to_, static_cast<enum mip_3dm_sensor_range_type>(sensor));
    }
};

/** Low-pass anti-aliasing filter: write. See mip_call_3dm_low_pass_filter_write. */
struct write_low_pass_filter {
    uint8_t descriptor_set;
    uint8_t field_descriptor;
    bool enable;
    bool manual;
    float frequency;

    using command = ::mip_3dm_low_pass_filter;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_low_pass_filter_write(device_, descriptor_set, field_descriptor,
                                                    enable, manual, frequency);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_low_pass_filter_write(to_, descriptor_set, field_descriptor, enable,
                                               manual, frequency);
    }
};

/** Low-pass anti-aliasing filter: read. See mip_call_3dm_low_pass_filter_read. */
struct read_low_pass_filter {
    uint8_t descriptor_set;
    uint8_t field_descriptor;

    using command = ::mip_3dm_low_pass_filter;
    using response = ::mip::mip_3dm::low_pass_filter_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_3dm_low_pass_filter_read(device_, descriptor_set, field_descriptor, to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_low_pass_filter_read(to_, descriptor_set, field_descriptor);
    }
};

/** Low-pass anti-aliasing filter: save. See mip_call_3dm_low_pass_filter_save. */
struct save_low_pass_filter {
    uint8_t descriptor_set;
    uint8_t field_descriptor;

    using command = ::mip_3dm_low_pass_filter;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_low_pass_filter_save(device_, descriptor_set, field_descriptor);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_low_pass_filter_save(to_, descriptor_set, field_descriptor);
    }
};

/** Low-pass anti-aliasing filter: load. See mip_call_3dm_low_pass_filter_load. */
struct load_low_pass_filter {
    uint8_t descriptor_set;
    uint8_t field_descriptor;

    using command = ::mip_3dm_low_pass_filter;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_low_pass_filter_load(device_, descriptor_set, field_descriptor);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_low_pass_filter_load(to_, descriptor_set, field_descriptor);
    }
};

/** Low-pass anti-aliasing filter: default. See mip_call_3dm_low_pass_filter_default. */
struct default_low_pass_filter {
    uint8_t descriptor_set;
    uint8_t field_descriptor;

    using command = ::mip_3dm_low_pass_filter;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_low_pass_filter_default(device_, descriptor_set, field_descriptor);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_low_pass_filter_default(to_, descriptor_set, field_descriptor);
    }
};

/** Data stream format: write. See mip_call_3dm_data_stream_format_write. */
struct write_data_stream_format {
    ::mip::mip_3dm::internal_sensor stream;
    ::mip::mip_3dm::stream_format format;

    using command = ::mip_3dm_data_stream_format;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_data_stream_format_write(
            device_, static_cast<enum mip_3dm_internal_sensor>(stream),
            static_cast<enum mip_3dm_stream_format>(format));
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_data_stream_format_write(to_,
                                                  static_cast<enum mip_3dm_internal_sensor>(stream),
                                                  static_cast<enum mip_3dm_stream_format>(format));
    }
};

/** Data stream format: read. See mip_call_3dm_data_stream_format_read. */
struct read_data_stream_format {
    ::mip::mip_3dm::internal_sensor stream;
    ::mip::mip_3dm::stream_format format;

    using command = ::mip_3dm_data_stream_format;
    using response = ::mip::mip_3dm::data_stream_format_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_3dm_data_stream_format_read(
            device_, static_cast<enum mip_3dm_internal_sensor>(stream),
            static_cast<enum mip_3dm_stream_format>(format), to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_data_stream_format_read(to_,
                                                 static_cast<enum mip_3dm_internal_sensor>(stream),
                                                 static_cast<enum mip_3dm_stream_format>(format));
    }
};

/** Data stream format: save. See mip_call_3dm_data_stream_format_save. */
struct save_data_stream_format {
    ::mip::mip_3dm::internal_sensor stream;
    ::mip::mip_3dm::stream_format format;

    using command = ::mip_3dm_data_stream_format;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_data_stream_format_save(
            device_, static_cast<enum mip_3dm_internal_sensor>(stream),
            static_cast<enum mip_3dm_stream_format>(format));
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_data_stream_format_save(to_,
                                                 static_cast<enum mip_3dm_internal_sensor>(stream),
                                                 static_cast<enum mip_3dm_stream_format>(format));
    }
};

/** Data stream format: load. See mip_call_3dm_data_stream_format_load. */
struct load_data_stream_format {
    ::mip::mip_3dm::internal_sensor stream;
    ::mip::mip_3dm::stream_format format;

    using command = ::mip_3dm_data_stream_format;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_data_stream_format_load(
            device_, static_cast<enum mip_3dm_internal_sensor>(stream),
            static_cast<enum mip_3dm_stream_format>(format));
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_data_stream_format_load(to_,
                                                 static_cast<enum mip_3dm_internal_sensor>(stream),
                                                 static_cast<enum mip_3dm_stream_format>(format));
    }
};

/** Data stream format: default. See mip_call_3dm_data_stream_format_default. */
struct default_data_stream_format {
    ::mip::mip_3dm::internal_sensor stream;
    ::mip::mip_3dm::stream_format format;

    using command = ::mip_3dm_data_stream_format;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_data_stream_format_default(
            device_, static_cast<enum mip_3dm_internal_sensor>(stream),
            static_cast<enum mip_3dm_stream_format>(format));
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_data_stream_format_default(
            to_, static_cast<enum mip_3dm_internal_sensor>(stream),
            static_cast<enum mip_3dm_stream_format>(format));
    }
};

/** Device power state: write. See mip_call_3dm_device_power_state_write. */
struct write_device_power_state {
    ::mip::mip_3dm::internal_sensor device;
    ::mip::mip_3dm::sensor_power_state state;

    using command = ::mip_3dm_device_power_state;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_device_power_state_write(
            device_, static_cast<enum mip_3dm_internal_sensor>(device),
            static_cast<enum mip_3dm_sensor_power_state>(state));
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_device_power_state_write(
            to_, static_cast<enum mip_3dm_internal_sensor>(device),
            static_cast<enum mip_3dm_sensor_power_state>(state));
    }
};

/** Device power state: read. See mip_call_3dm_device_power_state_read. */
struct read_device_power_state {
    ::mip::mip_3dm::internal_sensor device;

    using command = ::mip_3dm_device_power_state;
    using response = ::mip::mip_3dm::device_power_state_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_3dm_device_power_state_read(
            device_, static_cast<enum mip_3dm_internal_sensor>(device), to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_device_power_state_read(to_,
                                                 static_cast<enum mip_3dm_internal_sensor>(device));
    }
};

/** Device power state: save. See mip_call_3dm_device_power_state_save. */
struct save_device_power_state {
    ::mip::mip_3dm::internal_sensor device;

    using command = ::mip_3dm_device_power_state;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_device_power_state_save(
            device_, static_cast<enum mip_3dm_internal_sensor>(device));
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_device_power_state_save(to_,
                                                 static_cast<enum mip_3dm_internal_sensor>(device));
    }
};

/** Device power state: load. See mip_call_3dm_device_power_state_load. */
struct load_device_power_state {
    ::mip::mip_3dm::internal_sensor device;

    using command = ::mip_3dm_device_power_state;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_device_power_state_load(
            device_, static_cast<enum mip_3dm_internal_sensor>(device));
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_device_power_state_load(to_,
                                                 static_cast<enum mip_3dm_internal_sensor>(device));
    }
};

/** Device power state: default. See mip_call_3dm_device_power_state_default. */
struct default_device_power_state {
    ::mip::mip_3dm::internal_sensor device;

    using command = ::mip_3dm_device_power_state;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_device_power_state_default(
            device_, static_cast<enum mip_3dm_internal_sensor>(device));
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_device_power_state_default(
            to_, static_cast<enum mip_3dm_internal_sensor>(device));
    }
};

/** GPS advanced settings: save. See mip_call_3dm_gps_advanced_settings_save. */
struct save_gps_advanced_settings
    : fixed_command<::mip_3dm_gps_advanced_settings, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** GPS advanced settings: load. See mip_call_3dm_gps_advanced_settings_load. */
struct load_gps_advanced_settings
    : fixed_command<::mip_3dm_gps_advanced_settings, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** GPS advanced settings: default. See mip_call_3dm_gps_advanced_settings_default. */
struct default_gps_advanced_settings
    : fixed_command<::mip_3dm_gps_advanced_settings, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Device status. See mip_call_3dm_device_status. */
struct device_status {
    uint16_t model_number;
    ::mip::mip_3dm::device_status_selector status_selector;

    using command = ::mip_3dm_device_status;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3dm_device_status(
            device_, model_number,
            static_cast<enum mip_3dm_device_status_selector>(status_selector));
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_device_status_make(
            to_, model_number, static_cast<enum mip_3dm_device_status_selector>(status_selector));
    }
};

/** Device status. See mip_call_for_3dm_device_status_basic_rq1_imu_response. */
struct for_device_status_basic_rq1_imu_response {
    uint16_t model_number;

    using command = ::mip_3dm_device_status;
    using response = ::mip::mip_3dm::device_status_basic_rq1_imu_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_for_3dm_device_status_basic_rq1_imu_response(device_, model_number, to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_device_status_make(to_, model_number,
                                            MIP_3DM_DEVICE_STATUS_SELECTOR_BASIC);
    }
};

/** Device status. See mip_call_for_3dm_device_status_basic_response. */
struct for_device_status_basic_response {
    uint16_t model_number;

    using command = ::mip_3dm_device_status;
    using response = ::mip::mip_3dm::device_status_basic_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_for_3dm_device_status_basic_response(device_, model_number, to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_device_status_make(to_, model_number,
                                            MIP_3DM_DEVICE_STATUS_SELECTOR_BASIC);
    }
};

/** Device status. See mip_call_for_3dm_device_status_basic_without_state_response. */
struct for_device_status_basic_without_state_response {
    uint16_t model_number;

    using command = ::mip_3dm_device_status;
    using response = ::mip::mip_3dm::device_status_basic_without_state_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_for_3dm_device_status_basic_without_state_response(device_, model_number,
                                                                             to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_device_status_make(to_, model_number,
                                            MIP_3DM_DEVICE_STATUS_SELECTOR_BASIC);
    }
};

/** Device status. See mip_call_for_3dm_device_status_basic_gx3_response. */
struct for_device_status_basic_gx3_response {
    uint16_t model_number;

    using command = ::mip_3dm_device_status;
    using response = ::mip::mip_3dm::device_status_basic_gx3_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_for_3dm_device_status_basic_gx3_response(device_, model_number, to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_device_status_make(to_, model_number,
                                            MIP_3DM_DEVICE_STATUS_SELECTOR_BASIC);
    }
};

/** Device status. See mip_call_for_3dm_device_status_diagnostic_response. */
struct for_device_status_diagnostic_response {
    uint16_t model_number;

    using command = ::mip_3dm_device_status;
    using response = ::mip::mip_3dm::device_status_diagnostic_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_for_3dm_device_status_diagnostic_response(device_, model_number, to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_device_status_make(to_, model_number,
                                            MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC);
    }
};

/** Device status. See mip_call_for_3dm_device_status_diagnostic_gnss_response. */
struct for_device_status_diagnostic_gnss_response {
    uint16_t model_number;

    using command = ::mip_3dm_device_status;
    using response = ::mip::mip_3dm::device_status_diagnostic_gnss_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_for_3dm_device_status_diagnostic_gnss_response(device_, model_number,
                                                                         to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_device_status_make(to_, model_number,
                                            MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC);
    }
};

/** Device status. See mip_call_for_3dm_device_status_diagnostic_gq4_45_response. */
struct for_device_status_diagnostic_gq4_45_response {
    uint16_t model_number;

    using command = ::mip_3dm_device_status;
    using response = ::mip::mip_3dm::device_status_diagnostic_gq4_45_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_for_3dm_device_status_diagnostic_gq4_45_response(device_, model_number,
                                                                           to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_device_status_make(to_, model_number,
                                            MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC);
    }
};

/** Device status. See mip_call_for_3dm_device_status_diagnostic_rq1_45_response. */
struct for_device_status_diagnostic_rq1_45_response {
    uint16_t model_number;

    using command = ::mip_3dm_device_status;
    using response = ::mip::mip_3dm::device_status_diagnostic_rq1_45_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_for_3dm_device_status_diagnostic_rq1_45_response(device_, model_number,
                                                                           to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_device_status_make(to_, model_number,
                                            MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC);
    }
};

/** Device status. See mip_call_for_3dm_device_status_diagnostic_gx4_response. */
struct for_device_status_diagnostic_gx4_response {
    uint16_t model_number;

    using command = ::mip_3dm_device_status;
    using response = ::mip::mip_3dm::device_status_diagnostic_gx4_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_for_3dm_device_status_diagnostic_gx4_response(device_, model_number, to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_device_status_make(to_, model_number,
                                            MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC);
    }
};

/** Device status. See mip_call_for_3dm_device_status_diagnostic_imu_response. */
struct for_device_status_diagnostic_imu_response {
    uint16_t model_number;

    using command = ::mip_3dm_device_status;
    using response = ::mip::mip_3dm::device_status_diagnostic_imu_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_for_3dm_device_status_diagnostic_imu_response(device_, model_number, to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_device_status_make(to_, model_number,
                                            MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC);
    }
};

/** Device status. See mip_call_for_3dm_device_status_diagnostic_gx4_imu_response. */
struct for_device_status_diagnostic_gx4_imu_response {
    uint16_t model_number;

    using command = ::mip_3dm_device_status;
    using response = ::mip::mip_3dm::device_status_diagnostic_gx4_imu_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_for_3dm_device_status_diagnostic_gx4_imu_response(device_, model_number,
                                                                            to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_device_status_make(to_, model_number,
                                            MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC);
    }
};

/** Device status. See mip_call_for_3dm_device_status_diagnostic_rq1_imu_response. */
struct for_device_status_diagnostic_rq1_imu_response {
    uint16_t model_number;

    using command = ::mip_3dm_device_status;
    using response = ::mip::mip_3dm::device_status_diagnostic_rq1_imu_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_for_3dm_device_status_diagnostic_rq1_imu_response(device_, model_number,
                                                                            to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_device_status_make(to_, model_number,
                                            MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC);
    }
};

/** Device status. See mip_call_for_3dm_device_status_diagnostic_gx3_response. */
struct for_device_status_diagnostic_gx3_response {
    uint16_t model_number;

    using command = ::mip_3dm_device_status;
    using response = ::mip::mip_3dm::device_status_diagnostic_gx3_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_for_3dm_device_status_diagnostic_gx3_response(device_, model_number, to_);
    }
    const command *fill(command *to_) const {
        return ::mip_3dm_device_status_make(to_, model_number,
                                            MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC);
    }
};

/** @} */

} // namespace mip_3dm

} // namespace mip

#endif
