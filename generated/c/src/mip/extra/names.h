/**
 * @file
 * The names of all values and bits. Only those that a program uses are linked.
 */
#ifndef MIP_NAMES_H
#define MIP_NAMES_H

#include "mip/constants.h"
#include "mip/extra/reflect.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/extra/names.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** function_selector */
extern MIP_API const struct mip_names mip_names_function_selector;
MIP_VALUE_NAME(mip_function_selector, mip_names_function_selector);
/** gx5_built_in_test */
extern MIP_API const struct mip_names mip_names_gx5_built_in_test;
/** cv7_built_in_test */
extern MIP_API const struct mip_names mip_names_cv7_built_in_test;
/** cv7_continuous_built_in_test */
extern MIP_API const struct mip_names mip_names_cv7_continuous_built_in_test;
/** cv7_inertial_continuous_built_in_test */
extern MIP_API const struct mip_names mip_names_cv7_inertial_bit;
/** gq7_continuous_built_in_test */
extern MIP_API const struct mip_names mip_names_gq7_continuous_built_in_test;
/** event_trigger_type */
extern MIP_API const struct mip_names mip_names_event_trigger_type;
MIP_VALUE_NAME(mip_event_trigger_type, mip_names_event_trigger_type);
/** event_action_type */
extern MIP_API const struct mip_names mip_names_event_action_type;
MIP_VALUE_NAME(mip_event_action_type, mip_names_event_action_type);
/** event_trigger_mode */
extern MIP_API const struct mip_names mip_names_event_trigger_mode;
MIP_VALUE_NAME(mip_event_trigger_mode, mip_names_event_trigger_mode);
/** event_trigger_status */
extern MIP_API const struct mip_names mip_names_event_trigger_status;
/** event_trigger_gpio_mode */
extern MIP_API const struct mip_names mip_names_event_trigger_gpio_mode;
MIP_VALUE_NAME(mip_event_trigger_gpio_mode, mip_names_event_trigger_gpio_mode);
/** event_threshold_type */
extern MIP_API const struct mip_names mip_names_event_threshold_type;
MIP_VALUE_NAME(mip_event_threshold_type, mip_names_event_threshold_type);
/** event_action_gpio_mode */
extern MIP_API const struct mip_names mip_names_event_action_gpio_mode;
MIP_VALUE_NAME(mip_event_action_gpio_mode, mip_names_event_action_gpio_mode);
/** gnss_constellation */
extern MIP_API const struct mip_names mip_names_gnss_constellation;
MIP_VALUE_NAME(mip_gnss_constellation, mip_names_gnss_constellation);
/** gnss_fix_type */
extern MIP_API const struct mip_names mip_names_gnss_fix_type;
MIP_VALUE_NAME(mip_gnss_fix_type, mip_names_gnss_fix_type);
/** gnss_signal */
extern MIP_API const struct mip_names mip_names_gnss_signal;
MIP_VALUE_NAME(mip_gnss_signal, mip_names_gnss_signal);
/** gpio_feature */
extern MIP_API const struct mip_names mip_names_gpio_feature;
MIP_VALUE_NAME(mip_gpio_feature, mip_names_gpio_feature);
/** gpio_unused_behavior */
extern MIP_API const struct mip_names mip_names_gpio_unused_behavior;
MIP_VALUE_NAME(mip_gpio_unused_behavior, mip_names_gpio_unused_behavior);
/** gpio_behavior */
extern MIP_API const struct mip_names mip_names_gpio_behavior;
MIP_VALUE_NAME(mip_gpio_behavior, mip_names_gpio_behavior);
/** gpio_pps_behavior */
extern MIP_API const struct mip_names mip_names_gpio_pps_behavior;
MIP_VALUE_NAME(mip_gpio_pps_behavior, mip_names_gpio_pps_behavior);
/** gpio_encoder_behavior */
extern MIP_API const struct mip_names mip_names_gpio_encoder_behavior;
MIP_VALUE_NAME(mip_gpio_encoder_behavior, mip_names_gpio_encoder_behavior);
/** gpio_timestamp_behavior */
extern MIP_API const struct mip_names mip_names_gpio_timestamp_behavior;
MIP_VALUE_NAME(mip_gpio_timestamp_behavior, mip_names_gpio_timestamp_behavior);
/** gpio_uart_behavior */
extern MIP_API const struct mip_names mip_names_gpio_uart_behavior;
MIP_VALUE_NAME(mip_gpio_uart_behavior, mip_names_gpio_uart_behavior);
/** gpio_pin_mode */
extern MIP_API const struct mip_names mip_names_gpio_pin_mode;
/** nmea_message_id */
extern MIP_API const struct mip_names mip_names_nmea_message_id;
MIP_VALUE_NAME(mip_nmea_message_id, mip_names_nmea_message_id);
/** nmea_talker_id */
extern MIP_API const struct mip_names mip_names_nmea_talker_id;
MIP_VALUE_NAME(mip_nmea_talker_id, mip_names_nmea_talker_id);
/** comm_interface */
extern MIP_API const struct mip_names mip_names_comm_interface;
MIP_VALUE_NAME(mip_comm_interface, mip_names_comm_interface);
/** rtk_status_flags */
extern MIP_API const struct mip_names mip_names_rtk_status_flags;
/** rtk_status_flags_legacy */
extern MIP_API const struct mip_names mip_names_rtk_status_flags_legacy;
/** ack_code */
extern MIP_API const struct mip_names mip_names_ack_code;
/** sensor_gps_timestamp_flags */
extern MIP_API const struct mip_names mip_names_sensor_gps_timestamp_flags;
/** gx5_sensor_gps_timestamp_flags */
extern MIP_API const struct mip_names mip_names_gx5_sensor_gps_timestamp_flags;
/** base.gps_time_field */
extern MIP_API const struct mip_names mip_names_base_gps_time_field;
MIP_VALUE_NAME(mip_base_gps_time_field, mip_names_base_gps_time_field);
/** 3dm.factory_streaming_action */
extern MIP_API const struct mip_names mip_names_3dm_factory_streaming_action;
MIP_VALUE_NAME(mip_3dm_factory_streaming_action, mip_names_3dm_factory_streaming_action);
/** 3dm.constellation_id */
extern MIP_API const struct mip_names mip_names_3dm_constellation_id;
MIP_VALUE_NAME(mip_3dm_constellation_id, mip_names_3dm_constellation_id);
/** 3dm.constellation_options */
extern MIP_API const struct mip_names mip_names_3dm_constellation_options;
/** 3dm.sbas_options */
extern MIP_API const struct mip_names mip_names_3dm_sbas_options;
/** 3dm.assisted_fix_option */
extern MIP_API const struct mip_names mip_names_3dm_assisted_fix_option;
MIP_VALUE_NAME(mip_3dm_assisted_fix_option, mip_names_3dm_assisted_fix_option);
/** 3dm.pps_source */
extern MIP_API const struct mip_names mip_names_3dm_pps_source;
MIP_VALUE_NAME(mip_3dm_pps_source, mip_names_3dm_pps_source);
/** 3dm.event_support_query */
extern MIP_API const struct mip_names mip_names_3dm_event_support_query;
MIP_VALUE_NAME(mip_3dm_event_support_query, mip_names_3dm_event_support_query);
/** 3dm.receiver_dynamics */
extern MIP_API const struct mip_names mip_names_3dm_receiver_dynamics;
MIP_VALUE_NAME(mip_3dm_receiver_dynamics, mip_names_3dm_receiver_dynamics);
/** 3dm.data_conditioning_flags */
extern MIP_API const struct mip_names mip_names_3dm_data_conditioning_flags;
/** 3dm.mag_bandwidth */
extern MIP_API const struct mip_names mip_names_3dm_mag_bandwidth;
MIP_VALUE_NAME(mip_3dm_mag_bandwidth, mip_names_3dm_mag_bandwidth);
/** 3dm.imu_timestamp_selector */
extern MIP_API const struct mip_names mip_names_3dm_imu_timestamp_selector;
MIP_VALUE_NAME(mip_3dm_imu_timestamp_selector, mip_names_3dm_imu_timestamp_selector);
/** 3dm.odometer_mode */
extern MIP_API const struct mip_names mip_names_3dm_odometer_mode;
MIP_VALUE_NAME(mip_3dm_odometer_mode, mip_names_3dm_odometer_mode);
/** 3dm.sensor_range_type */
extern MIP_API const struct mip_names mip_names_3dm_sensor_range_type;
MIP_VALUE_NAME(mip_3dm_sensor_range_type, mip_names_3dm_sensor_range_type);
/** 3dm.internal_sensor */
extern MIP_API const struct mip_names mip_names_3dm_internal_sensor;
MIP_VALUE_NAME(mip_3dm_internal_sensor, mip_names_3dm_internal_sensor);
/** 3dm.stream_format */
extern MIP_API const struct mip_names mip_names_3dm_stream_format;
MIP_VALUE_NAME(mip_3dm_stream_format, mip_names_3dm_stream_format);
/** 3dm.sensor_power_state */
extern MIP_API const struct mip_names mip_names_3dm_sensor_power_state;
MIP_VALUE_NAME(mip_3dm_sensor_power_state, mip_names_3dm_sensor_power_state);
/** 3dm.device_status_selector */
extern MIP_API const struct mip_names mip_names_3dm_device_status_selector;
MIP_VALUE_NAME(mip_3dm_device_status_selector, mip_names_3dm_device_status_selector);
/** 3dm.legacy_data_stream */
extern MIP_API const struct mip_names mip_names_3dm_legacy_data_stream;
MIP_VALUE_NAME(mip_3dm_legacy_data_stream, mip_names_3dm_legacy_data_stream);
/** 3dm.gx4_system_state */
extern MIP_API const struct mip_names mip_names_3dm_gx4_system_state;
MIP_VALUE_NAME(mip_3dm_gx4_system_state, mip_names_3dm_gx4_system_state);
/** filter.dynamics_mode */
extern MIP_API const struct mip_names mip_names_filter_dynamics_mode;
MIP_VALUE_NAME(mip_filter_dynamics_mode, mip_names_filter_dynamics_mode);
/** filter.estimated_states */
extern MIP_API const struct mip_names mip_names_filter_estimated_states;
/** filter.gnss_aiding_source */
extern MIP_API const struct mip_names mip_names_filter_gnss_aiding_source;
MIP_VALUE_NAME(mip_filter_gnss_aiding_source, mip_names_filter_gnss_aiding_source);
/** filter.heading_type */
extern MIP_API const struct mip_names mip_names_filter_heading_type;
MIP_VALUE_NAME(mip_filter_heading_type, mip_names_filter_heading_type);
/** filter.heading_update_source */
extern MIP_API const struct mip_names mip_names_filter_heading_update_source;
MIP_VALUE_NAME(mip_filter_heading_update_source, mip_names_filter_heading_update_source);
/** filter.tare_axes */
extern MIP_API const struct mip_names mip_names_filter_tare_axes;
/** filter.measurement_flags */
extern MIP_API const struct mip_names mip_names_filter_measurement_flags;
/** filter.mag_parameter_source */
extern MIP_API const struct mip_names mip_names_filter_mag_parameter_source;
MIP_VALUE_NAME(mip_filter_mag_parameter_source, mip_names_filter_mag_parameter_source);
/** filter.adaptive_measurement_selector */
extern MIP_API const struct mip_names mip_names_filter_adaptive_measurement_selector;
MIP_VALUE_NAME(mip_filter_adaptive_measurement_selector,
               mip_names_filter_adaptive_measurement_selector);
/** filter.altitude_aiding_source */
extern MIP_API const struct mip_names mip_names_filter_altitude_aiding_source;
MIP_VALUE_NAME(mip_filter_altitude_aiding_source, mip_names_filter_altitude_aiding_source);
/** filter.pitch_roll_aiding_source */
extern MIP_API const struct mip_names mip_names_filter_pitch_roll_aiding_source;
MIP_VALUE_NAME(mip_filter_pitch_roll_aiding_source, mip_names_filter_pitch_roll_aiding_source);
/** filter.aiding_source */
extern MIP_API const struct mip_names mip_names_filter_aiding_source;
MIP_VALUE_NAME(mip_filter_aiding_source, mip_names_filter_aiding_source);
/** filter.accel_constraint */
extern MIP_API const struct mip_names mip_names_filter_accel_constraint;
MIP_VALUE_NAME(mip_filter_accel_constraint, mip_names_filter_accel_constraint);
/** filter.velocity_constraint */
extern MIP_API const struct mip_names mip_names_filter_velocity_constraint;
MIP_VALUE_NAME(mip_filter_velocity_constraint, mip_names_filter_velocity_constraint);
/** filter.angular_constraint */
extern MIP_API const struct mip_names mip_names_filter_angular_constraint;
MIP_VALUE_NAME(mip_filter_angular_constraint, mip_names_filter_angular_constraint);
/** filter.initial_condition_source */
extern MIP_API const struct mip_names mip_names_filter_initial_condition_source;
MIP_VALUE_NAME(mip_filter_initial_condition_source, mip_names_filter_initial_condition_source);
/** filter.heading_alignment */
extern MIP_API const struct mip_names mip_names_filter_heading_alignment;
/** filter.reference_frame */
extern MIP_API const struct mip_names mip_names_filter_reference_frame;
MIP_VALUE_NAME(mip_filter_reference_frame, mip_names_filter_reference_frame);
/** filter.adaptive_level */
extern MIP_API const struct mip_names mip_names_filter_adaptive_level;
MIP_VALUE_NAME(mip_filter_adaptive_level, mip_names_filter_adaptive_level);
/** filter.relative_position_source */
extern MIP_API const struct mip_names mip_names_filter_relative_position_source;
MIP_VALUE_NAME(mip_filter_relative_position_source, mip_names_filter_relative_position_source);
/** filter.reference_point */
extern MIP_API const struct mip_names mip_names_filter_reference_point;
MIP_VALUE_NAME(mip_filter_reference_point, mip_names_filter_reference_point);
/** gnss.gps_signals */
extern MIP_API const struct mip_names mip_names_gnss_gps_signals;
/** gnss.glonass_signals */
extern MIP_API const struct mip_names mip_names_gnss_glonass_signals;
/** gnss.galileo_signals */
extern MIP_API const struct mip_names mip_names_gnss_galileo_signals;
/** gnss.beidou_signals */
extern MIP_API const struct mip_names mip_names_gnss_beidou_signals;
/** gnss.receiver_id */
extern MIP_API const struct mip_names mip_names_gnss_receiver_id;
MIP_VALUE_NAME(mip_gnss_receiver_id, mip_names_gnss_receiver_id);
/** gnss.receiver_reset_type */
extern MIP_API const struct mip_names mip_names_gnss_receiver_reset_type;
MIP_VALUE_NAME(mip_gnss_receiver_reset_type, mip_names_gnss_receiver_reset_type);
/** gnss.ambiguity_fix_mode */
extern MIP_API const struct mip_names mip_names_gnss_ambiguity_fix_mode;
MIP_VALUE_NAME(mip_gnss_ambiguity_fix_mode, mip_names_gnss_ambiguity_fix_mode);
/** gnss.spartn_connection */
extern MIP_API const struct mip_names mip_names_gnss_spartn_connection;
MIP_VALUE_NAME(mip_gnss_spartn_connection, mip_names_gnss_spartn_connection);
/** rtk.connected_device */
extern MIP_API const struct mip_names mip_names_rtk_connected_device;
MIP_VALUE_NAME(mip_rtk_connected_device, mip_names_rtk_connected_device);
/** rtk.service_flags */
extern MIP_API const struct mip_names mip_names_rtk_service_flags;
/** rtk.storage_medium */
extern MIP_API const struct mip_names mip_names_rtk_storage_medium;
MIP_VALUE_NAME(mip_rtk_storage_medium, mip_names_rtk_storage_medium);
/** rtk.led_action */
extern MIP_API const struct mip_names mip_names_rtk_led_action;
MIP_VALUE_NAME(mip_rtk_led_action, mip_names_rtk_led_action);
/** aiding.aiding_frame_format */
extern MIP_API const struct mip_names mip_names_aiding_frame_format;
MIP_VALUE_NAME(mip_aiding_frame_format, mip_names_aiding_frame_format);
/** aiding.aiding_echo_mode */
extern MIP_API const struct mip_names mip_names_aiding_echo_mode;
MIP_VALUE_NAME(mip_aiding_echo_mode, mip_names_aiding_echo_mode);
/** aiding.timebase */
extern MIP_API const struct mip_names mip_names_aiding_timebase;
MIP_VALUE_NAME(mip_aiding_timebase, mip_names_aiding_timebase);
/** aiding.axis_flags */
extern MIP_API const struct mip_names mip_names_aiding_axis_flags;
/** aiding.llh_axis_flags */
extern MIP_API const struct mip_names mip_names_aiding_llh_axis_flags;
/** system.comm_protocols */
extern MIP_API const struct mip_names mip_names_system_comm_protocols;
/** system.protocol_mode */
extern MIP_API const struct mip_names mip_names_system_protocol_mode;
MIP_VALUE_NAME(mip_system_protocol_mode, mip_names_system_protocol_mode);
/** sensor.overrange_flags */
extern MIP_API const struct mip_names mip_names_sensor_overrange_flags;
/** sensor.odometer_flags */
extern MIP_API const struct mip_names mip_names_sensor_odometer_flags;
/** gnss_data.llh_position_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_llh_position_flags;
/** gnss_data.ecef_position_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_ecef_position_flags;
/** gnss_data.ned_velocity_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_ned_velocity_flags;
/** gnss_data.ecef_velocity_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_ecef_velocity_flags;
/** gnss_data.dop_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_dop_flags;
/** gnss_data.utc_time_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_utc_time_flags;
/** gnss_data.gps_time_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_gps_time_flags;
/** gnss_data.clock_info_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_clock_info_flags;
/** gnss_data.fix_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_fix_flags;
/** gnss_data.fix_info_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_fix_info_flags;
/** gnss_data.sv_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_sv_flags;
/** gnss_data.sv_info_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_sv_info_flags;
/** gnss_data.receiver_state */
extern MIP_API const struct mip_names mip_names_gnss_data_receiver_state;
MIP_VALUE_NAME(mip_gnss_data_receiver_state, mip_names_gnss_data_receiver_state);
/** gnss_data.antenna_state */
extern MIP_API const struct mip_names mip_names_gnss_data_antenna_state;
MIP_VALUE_NAME(mip_gnss_data_antenna_state, mip_names_gnss_data_antenna_state);
/** gnss_data.antenna_power */
extern MIP_API const struct mip_names mip_names_gnss_data_antenna_power;
MIP_VALUE_NAME(mip_gnss_data_antenna_power, mip_names_gnss_data_antenna_power);
/** gnss_data.hardware_status_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_hardware_status_flags;
/** gnss_data.dgps_info_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_dgps_info_flags;
/** gnss_data.dgps_channel_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_dgps_channel_flags;
/** gnss_data.clock_info_2_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_clock_info_2_flags;
/** gnss_data.gps_leap_seconds_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_gps_leap_seconds_flags;
/** gnss_data.sbas_system */
extern MIP_API const struct mip_names mip_names_gnss_data_sbas_system;
MIP_VALUE_NAME(mip_gnss_data_sbas_system, mip_names_gnss_data_sbas_system);
/** gnss_data.sbas_status */
extern MIP_API const struct mip_names mip_names_gnss_data_sbas_status;
/** gnss_data.sbas_info_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_sbas_info_flags;
/** gnss_data.sbas_correction_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_sbas_correction_flags;
/** gnss_data.rf_band */
extern MIP_API const struct mip_names mip_names_gnss_data_rf_band;
MIP_VALUE_NAME(mip_gnss_data_rf_band, mip_names_gnss_data_rf_band);
/** gnss_data.jamming_state */
extern MIP_API const struct mip_names mip_names_gnss_data_jamming_state;
MIP_VALUE_NAME(mip_gnss_data_jamming_state, mip_names_gnss_data_jamming_state);
/** gnss_data.spoofing_state */
extern MIP_API const struct mip_names mip_names_gnss_data_spoofing_state;
MIP_VALUE_NAME(mip_gnss_data_spoofing_state, mip_names_gnss_data_spoofing_state);
/** gnss_data.rf_error_detection_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_rf_error_detection_flags;
/** gnss_data.heading_fix_type */
extern MIP_API const struct mip_names mip_names_gnss_data_heading_fix_type;
MIP_VALUE_NAME(mip_gnss_data_heading_fix_type, mip_names_gnss_data_heading_fix_type);
/** gnss_data.heading_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_heading_flags;
/** gnss_data.satellite_status_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_satellite_status_flags;
/** gnss_data.signal_quality */
extern MIP_API const struct mip_names mip_names_gnss_data_signal_quality;
MIP_VALUE_NAME(mip_gnss_data_signal_quality, mip_names_gnss_data_signal_quality);
/** gnss_data.raw_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_raw_flags;
/** gnss_data.base_station_indicators */
extern MIP_API const struct mip_names mip_names_gnss_data_base_station_indicators;
/** gnss_data.base_station_info_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_base_station_info_flags;
/** gnss_data.rtk_epoch_status */
extern MIP_API const struct mip_names mip_names_gnss_data_rtk_epoch_status;
/** gnss_data.rtk_corrections_status_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_rtk_corrections_status_flags;
/** gnss_data.ephemeris_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_ephemeris_flags;
/** gnss_data.glonass_satellite_type */
extern MIP_API const struct mip_names mip_names_gnss_data_glonass_satellite_type;
MIP_VALUE_NAME(mip_gnss_data_glonass_satellite_type, mip_names_gnss_data_glonass_satellite_type);
/** gnss_data.glonass_ephemeris_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_glonass_ephemeris_flags;
/** gnss_data.gps_iono_correction_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_gps_iono_correction_flags;
/** gnss_data.galileo_iono_correction_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_galileo_iono_correction_flags;
/** gnss_data.beidou_iono_correction_flags */
extern MIP_API const struct mip_names mip_names_gnss_data_beidou_iono_correction_flags;
/** filter_data.valid_flags */
extern MIP_API const struct mip_names mip_names_filter_data_valid_flags;
/** filter_data.heading_source_flags */
extern MIP_API const struct mip_names mip_names_filter_data_heading_source_flags;
/** filter_data.gnss_aiding_status */
extern MIP_API const struct mip_names mip_names_filter_data_gnss_aiding_status;
/** filter_data.heading_aiding_type */
extern MIP_API const struct mip_names mip_names_filter_data_heading_aiding_type;
MIP_VALUE_NAME(mip_filter_data_heading_aiding_type, mip_names_filter_data_heading_aiding_type);
/** filter_data.aiding_measurement_type */
extern MIP_API const struct mip_names mip_names_filter_data_aiding_measurement_type;
MIP_VALUE_NAME(mip_filter_data_aiding_measurement_type,
               mip_names_filter_data_aiding_measurement_type);
/** filter_data.aiding_measurement_indicator */
extern MIP_API const struct mip_names mip_names_filter_data_aiding_measurement_indicator;
/** filter_data.dual_antenna_fix_type */
extern MIP_API const struct mip_names mip_names_filter_data_dual_antenna_fix_type;
MIP_VALUE_NAME(mip_filter_data_dual_antenna_fix_type, mip_names_filter_data_dual_antenna_fix_type);
/** filter_data.dual_antenna_status_flags */
extern MIP_API const struct mip_names mip_names_filter_data_dual_antenna_status_flags;
/** filter_data.gx5_filter_state */
extern MIP_API const struct mip_names mip_names_filter_data_gx5_filter_state;
MIP_VALUE_NAME(mip_filter_data_gx5_filter_state, mip_names_filter_data_gx5_filter_state);
/** filter_data.cv7_filter_state */
extern MIP_API const struct mip_names mip_names_filter_data_cv7_filter_state;
MIP_VALUE_NAME(mip_filter_data_cv7_filter_state, mip_names_filter_data_cv7_filter_state);
/** filter_data.gx5_dynamics_mode */
extern MIP_API const struct mip_names mip_names_filter_data_gx5_dynamics_mode;
MIP_VALUE_NAME(mip_filter_data_gx5_dynamics_mode, mip_names_filter_data_gx5_dynamics_mode);
/** filter_data.cv7_dynamics_mode */
extern MIP_API const struct mip_names mip_names_filter_data_cv7_dynamics_mode;
MIP_VALUE_NAME(mip_filter_data_cv7_dynamics_mode, mip_names_filter_data_cv7_dynamics_mode);
/** filter_data.gx5_status_flags */
extern MIP_API const struct mip_names mip_names_filter_data_gx5_status_flags;
/** filter_data.filter_condition */
extern MIP_API const struct mip_names mip_names_filter_data_filter_condition;
MIP_VALUE_NAME(mip_filter_data_filter_condition, mip_names_filter_data_filter_condition);
/** filter_data.cv7_status_flags */
extern MIP_API const struct mip_names mip_names_filter_data_cv7_status_flags;
/** displacement_data.timestamp_flags */
extern MIP_API const struct mip_names mip_names_displacement_data_timestamp_flags;
/** system_data.gpio_pin_states */
extern MIP_API const struct mip_names mip_names_system_data_gpio_pin_states;
/** shared.gps_timestamp_flags */
extern MIP_API const struct mip_names mip_names_shared_gps_timestamp_flags;
/** shared.external_timestamp_flags */
extern MIP_API const struct mip_names mip_names_shared_external_timestamp_flags;
/** shared.external_time_delta_flags */
extern MIP_API const struct mip_names mip_names_shared_external_time_delta_flags;

#ifdef __cplusplus
}
#endif

#endif
