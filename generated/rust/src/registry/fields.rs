//! The fields, in the form that [`registry!`] expects.

use super::*;

registry! {
    #[cfg(feature = "base")]
    0x01 => {
        /// Ping (0x01,0x01).
        BasePing(crate::base::Ping):
            Command 0x01, of 1,
            "base.ping", "Ping",
            [], {};
        /// Set to idle (0x01,0x02).
        BaseSetIdle(crate::base::SetIdle):
            Command 0x02, of 1,
            "base.set_idle", "Set to idle",
            [], {};
        /// Get device information (0x01,0x03).
        BaseGetDeviceInfo(crate::base::GetDeviceInfo):
            Command 0x03, of 1,
            "base.get_device_info", "Get device information",
            ["base.get_device_info_response"], {};
        /// Get device descriptors (0x01,0x04).
        BaseGetDeviceDescriptors(crate::base::GetDeviceDescriptors):
            Command 0x04, of 1,
            "base.get_device_descriptors", "Get device descriptors",
            ["base.get_device_descriptors_response"], {};
        /// Built-in test (0x01,0x05).
        BaseBuiltInTest(crate::base::BuiltInTest):
            Command 0x05, of 1,
            "base.built_in_test", "Built-in test",
            ["base.built_in_test_response"], {};
        /// Resume (0x01,0x06).
        BaseResume(crate::base::Resume):
            Command 0x06, of 1,
            "base.resume", "Resume",
            [], {};
        /// Get device descriptors (extended) (0x01,0x07).
        BaseGetExtendedDescriptors(crate::base::GetExtendedDescriptors):
            Command 0x07, of 1,
            "base.get_extended_descriptors", "Get device descriptors (extended)",
            ["base.get_extended_descriptors_response"], {};
        /// Continuous built-in test (0x01,0x08).
        BaseContinuousBuiltInTest(crate::base::ContinuousBuiltInTest):
            Command 0x08, of 1,
            "base.continuous_built_in_test", "Continuous built-in test",
            ["base.continuous_built_in_test_response"], {};
        /// Comm port speed (0x01,0x09).
        BaseCommSpeed(crate::base::CommSpeed):
            Command 0x09, of 1,
            "base.comm_speed", "Comm port speed",
            ["base.comm_speed_response"], {
                "function";
                "port";
                "baud" in ["Bd"];
            };
        /// GPS time update (0x01,0x72).
        BaseGpsTimeUpdate(crate::base::GpsTimeUpdate):
            Command 0x72, of 1,
            "base.gps_time_update", "GPS time update",
            ["base.gps_time_update_week_number_response", "base.gps_time_update_tow_response"], {
                "function";
                "field_id";
                "value";
            };
        /// Reset device (0x01,0x7E).
        BaseSoftReset(crate::base::SoftReset):
            Command 0x7E, of 1,
            "base.soft_reset", "Reset device",
            [], {};
        /// Get device information response (0x01,0x81).
        BaseGetDeviceInfoResponse(crate::base::GetDeviceInfoResponse):
            Response 0x81, of 1,
            "base.get_device_info_response", "Get device information response",
            ["base.get_device_info"], {
                "device_info" {
                    "firmware_version";
                    "model_name";
                    "model_number";
                    "serial_number";
                    "lot_number";
                    "device_options";
                };
            };
        /// Get device descriptors response (0x01,0x82).
        BaseGetDeviceDescriptorsResponse(crate::base::GetDeviceDescriptorsResponse):
            Response 0x82, of 1,
            "base.get_device_descriptors_response", "Get device descriptors response",
            ["base.get_device_descriptors"], {
                "descriptors";
            };
        /// Built-in test response (0x01,0x83).
        BaseBuiltInTestResponse(crate::base::BuiltInTestResponse):
            Response 0x83, of 1,
            "base.built_in_test_response", "Built-in test response",
            ["base.built_in_test"], {
                "result";
            };
        /// GPS time update, week number (0x01,0x84).
        BaseGpsTimeUpdateWeekNumberResponse(crate::base::GpsTimeUpdateWeekNumberResponse):
            Response 0x84, of 1,
            "base.gps_time_update_week_number_response", "GPS time update, week number",
            ["base.gps_time_update"], {
                "week_number" in ["week"];
            };
        /// GPS time update, time of week (0x01,0x85).
        BaseGpsTimeUpdateTowResponse(crate::base::GpsTimeUpdateTowResponse):
            Response 0x85, of 1,
            "base.gps_time_update_tow_response", "GPS time update, time of week",
            ["base.gps_time_update"], {
                "tow" in ["s"];
            };
        /// Get device descriptors (extended) response (0x01,0x86).
        BaseGetExtendedDescriptorsResponse(crate::base::GetExtendedDescriptorsResponse):
            Response 0x86, of 1,
            "base.get_extended_descriptors_response", "Get device descriptors (extended) response",
            ["base.get_extended_descriptors"], {
                "descriptors";
            };
        /// Continuous built-in test response (0x01,0x88).
        BaseContinuousBuiltInTestResponse(crate::base::ContinuousBuiltInTestResponse):
            Response 0x88, of 1,
            "base.continuous_built_in_test_response", "Continuous built-in test response",
            ["base.continuous_built_in_test"], {
                "result";
            };
        /// Comm port speed response (0x01,0x89).
        BaseCommSpeedResponse(crate::base::CommSpeedResponse):
            Response 0x89, of 1,
            "base.comm_speed_response", "Comm port speed response",
            ["base.comm_speed"], {
                "port";
                "baud" in ["Bd"];
            };
    }
    #[cfg(feature = "mip_3dm")]
    0x0C => {
        /// Poll IMU data (0x0C,0x01).
        Mip3dmPollImuData(crate::mip_3dm::PollImuData):
            Command 0x01, of 1,
            "3dm.poll_imu_data", "Poll IMU data",
            [], {
                "suppress_ack";
                "descriptors" {
                    "descriptor";
                    "reserved";
                };
            };
        /// Poll GNSS data (0x0C,0x02).
        Mip3dmPollGnssData(crate::mip_3dm::PollGnssData):
            Command 0x02, of 1,
            "3dm.poll_gnss_data", "Poll GNSS data",
            [], {
                "suppress_ack";
                "descriptors" {
                    "descriptor";
                    "reserved";
                };
            };
        /// Poll estimation filter data (0x0C,0x03).
        Mip3dmPollFilterData(crate::mip_3dm::PollFilterData):
            Command 0x03, of 1,
            "3dm.poll_filter_data", "Poll estimation filter data",
            [], {
                "suppress_ack";
                "descriptors" {
                    "descriptor";
                    "reserved";
                };
            };
        /// Poll NMEA data (0x0C,0x04).
        Mip3dmPollNmeaData(crate::mip_3dm::PollNmeaData):
            Command 0x04, of 1,
            "3dm.poll_nmea_data", "Poll NMEA data",
            [], {
                "suppress_ack";
                "format_entries" {
                    "message_id";
                    "talker_id";
                    "source_descriptor_set";
                    "decimation";
                };
            };
        /// Get IMU data base rate (0x0C,0x06).
        Mip3dmGetImuBaseRate(crate::mip_3dm::GetImuBaseRate):
            Command 0x06, of 1,
            "3dm.get_imu_base_rate", "Get IMU data base rate",
            ["3dm.get_imu_base_rate_response"], {};
        /// Get GNSS data base rate (0x0C,0x07).
        Mip3dmGetGnssBaseRate(crate::mip_3dm::GetGnssBaseRate):
            Command 0x07, of 1,
            "3dm.get_gnss_base_rate", "Get GNSS data base rate",
            ["3dm.get_gnss_base_rate_response"], {};
        /// IMU message format (0x0C,0x08).
        Mip3dmImuMessageFormat(crate::mip_3dm::ImuMessageFormat):
            Command 0x08, of 1,
            "3dm.imu_message_format", "IMU message format",
            ["3dm.imu_message_format_response"], {
                "function";
                "descriptors" {
                    "descriptor";
                    "decimation";
                };
            };
        /// GNSS message format (0x0C,0x09).
        Mip3dmGnssMessageFormat(crate::mip_3dm::GnssMessageFormat):
            Command 0x09, of 1,
            "3dm.gnss_message_format", "GNSS message format",
            ["3dm.gnss_message_format_response"], {
                "function";
                "descriptors" {
                    "descriptor";
                    "decimation";
                };
            };
        /// Estimation filter message format (0x0C,0x0A).
        Mip3dmFilterMessageFormat(crate::mip_3dm::FilterMessageFormat):
            Command 0x0A, of 1,
            "3dm.filter_message_format", "Estimation filter message format",
            ["3dm.filter_message_format_response"], {
                "function";
                "descriptors" {
                    "descriptor";
                    "decimation";
                };
            };
        /// Get estimation filter data base rate (0x0C,0x0B).
        Mip3dmGetFilterBaseRate(crate::mip_3dm::GetFilterBaseRate):
            Command 0x0B, of 1,
            "3dm.get_filter_base_rate", "Get estimation filter data base rate",
            ["3dm.get_filter_base_rate_response"], {};
        /// NMEA message format (0x0C,0x0C).
        Mip3dmNmeaMessageFormat(crate::mip_3dm::NmeaMessageFormat):
            Command 0x0C, of 1,
            "3dm.nmea_message_format", "NMEA message format",
            ["3dm.nmea_message_format_response"], {
                "function";
                "format_entries" {
                    "message_id";
                    "talker_id";
                    "source_descriptor_set";
                    "decimation";
                };
            };
        /// Poll data (0x0C,0x0D).
        Mip3dmPollData(crate::mip_3dm::PollData):
            Command 0x0D, of 1,
            "3dm.poll_data", "Poll data",
            [], {
                "descriptor_set";
                "suppress_ack";
                "descriptors";
            };
        /// Get data base rate (0x0C,0x0E).
        Mip3dmGetBaseRate(crate::mip_3dm::GetBaseRate):
            Command 0x0E, of 1,
            "3dm.get_base_rate", "Get data base rate",
            ["3dm.get_base_rate_response"], {
                "descriptor_set";
            };
        /// Message format (0x0C,0x0F).
        Mip3dmMessageFormat(crate::mip_3dm::MessageFormat):
            Command 0x0F, of 1,
            "3dm.message_format", "Message format",
            ["3dm.message_format_response"], {
                "function";
                "descriptor_set";
                "descriptors" {
                    "descriptor";
                    "decimation";
                };
            };
        /// Factory streaming (0x0C,0x10).
        Mip3dmFactoryStreaming(crate::mip_3dm::FactoryStreaming):
            Command 0x10, of 1,
            "3dm.factory_streaming", "Factory streaming",
            [], {
                "action";
                "reserved";
            };
        /// Data stream control (0x0C,0x11).
        Mip3dmDataStreamControl(crate::mip_3dm::DataStreamControl):
            Command 0x11, of 1,
            "3dm.data_stream_control", "Data stream control",
            ["3dm.data_stream_control_response"], {
                "function";
                "descriptor_set";
                "enable";
            };
        /// Raw RTCM 2.3 message (0x0C,0x20).
        Mip3dmRawRtcm2_3Message(crate::mip_3dm::RawRtcm2_3Message):
            Command 0x20, of 1,
            "3dm.raw_rtcm_2_3_message", "Raw RTCM 2.3 message",
            [], {
                "data";
            };
        /// Constellation settings (0x0C,0x21).
        Mip3dmConstellationSettings(crate::mip_3dm::ConstellationSettings):
            Command 0x21, of 1,
            "3dm.constellation_settings", "Constellation settings",
            ["3dm.constellation_settings_response"], {
                "function";
                "max_channels" in ["1"];
                "settings" {
                    "constellation_id";
                    "enable";
                    "reserved_channels" in ["1"];
                    "max_channels" in ["1"];
                    "option_flags";
                };
            };
        /// GNSS SBAS settings (0x0C,0x22).
        Mip3dmGnssSbasSettings(crate::mip_3dm::GnssSbasSettings):
            Command 0x22, of 1,
            "3dm.gnss_sbas_settings", "GNSS SBAS settings",
            ["3dm.gnss_sbas_settings_response"], {
                "function";
                "enable_sbas";
                "sbas_options";
                "included_prns";
            };
        /// GNSS assisted fix (0x0C,0x23).
        Mip3dmGnssAssistedFix(crate::mip_3dm::GnssAssistedFix):
            Command 0x23, of 1,
            "3dm.gnss_assisted_fix", "GNSS assisted fix",
            ["3dm.gnss_assisted_fix_response"], {
                "function";
                "option";
                "flags";
            };
        /// GNSS time assistance (0x0C,0x24).
        Mip3dmGnssTimeAssistance(crate::mip_3dm::GnssTimeAssistance):
            Command 0x24, of 1,
            "3dm.gnss_time_assistance", "GNSS time assistance",
            ["3dm.gnss_time_assistance_response"], {
                "function";
                "tow" in ["s"];
                "week_number" in ["week"];
                "accuracy" in ["s"];
            };
        /// PPS source control (0x0C,0x28).
        Mip3dmPpsSourceControl(crate::mip_3dm::PpsSourceControl):
            Command 0x28, of 1,
            "3dm.pps_source_control", "PPS source control",
            ["3dm.pps_source_control_response"], {
                "function";
                "source";
            };
        /// Get supported events (0x0C,0x2A).
        Mip3dmGetEventSupport(crate::mip_3dm::GetEventSupport):
            Command 0x2A, of 1,
            "3dm.get_event_support", "Get supported events",
            ["3dm.get_event_support_response"], {
                "query";
            };
        /// Event control (0x0C,0x2B).
        Mip3dmEventControl(crate::mip_3dm::EventControl):
            Command 0x2B, of 1,
            "3dm.event_control", "Event control",
            ["3dm.event_control_response"], {
                "function";
                "instance";
                "mode";
            };
        /// Get event trigger status (0x0C,0x2C).
        Mip3dmGetEventTriggerStatus(crate::mip_3dm::GetEventTriggerStatus):
            Command 0x2C, of 1,
            "3dm.get_event_trigger_status", "Get event trigger status",
            ["3dm.get_event_trigger_status_response"], {
                "requested_instances";
            };
        /// Get event action status (0x0C,0x2D).
        Mip3dmGetEventActionStatus(crate::mip_3dm::GetEventActionStatus):
            Command 0x2D, of 1,
            "3dm.get_event_action_status", "Get event action status",
            ["3dm.get_event_action_status_response"], {
                "requested_instances";
            };
        /// Event trigger configuration (0x0C,0x2E).
        Mip3dmEventTriggerConfig(crate::mip_3dm::EventTriggerConfig):
            Command 0x2E, of 1,
            "3dm.event_trigger_config", "Event trigger configuration",
            ["3dm.event_trigger_config_response"], {
                "function";
                "instance";
                "type";
                "parameters" {
                    "gpio" {
                        "pin";
                        "mode";
                    };
                    "threshold" {
                        "descriptor_set";
                        "field_descriptor";
                        "parameter_id";
                        "type";
                        "thresholds" {
                            "window" {
                                "low_threshold";
                                "high_threshold";
                            };
                            "interval" {
                                "interval_threshold";
                                "interval";
                            };
                        };
                    };
                    "combination" {
                        "logic_table";
                        "input_triggers";
                    };
                };
            };
        /// Event action configuration (0x0C,0x2F).
        Mip3dmEventActionConfig(crate::mip_3dm::EventActionConfig):
            Command 0x2F, of 1,
            "3dm.event_action_config", "Event action configuration",
            ["3dm.event_action_config_response"], {
                "function";
                "instance";
                "trigger";
                "type";
                "parameters" {
                    "gpio" {
                        "pin";
                        "mode";
                    };
                    "message" {
                        "descriptor_set";
                        "decimation";
                        "descriptors";
                    };
                };
            };
        /// Device start up settings (0x0C,0x30).
        Mip3dmDeviceSettings(crate::mip_3dm::DeviceSettings):
            Command 0x30, of 1,
            "3dm.device_settings", "Device start up settings",
            [], {
                "function";
            };
        /// Sensor-to-vehicle frame transformation Euler (0x0C,0x31).
        Mip3dmSensorToVehicleTransformEuler(crate::mip_3dm::SensorToVehicleTransformEuler):
            Command 0x31, of 1,
            "3dm.sensor_to_vehicle_transform_euler", "Sensor-to-vehicle frame transformation Euler",
            ["3dm.sensor_to_vehicle_transform_euler_response"], {
                "function";
                "roll" in ["rad"] of "vehicle";
                "pitch" in ["rad"] of "vehicle";
                "yaw" in ["rad"] of "vehicle";
            };
        /// Sensor-to-vehicle frame transformation quaternion (0x0C,0x32).
        Mip3dmSensorToVehicleTransformQuaternion(crate::mip_3dm::SensorToVehicleTransformQuaternion):
            Command 0x32, of 1,
            "3dm.sensor_to_vehicle_transform_quaternion", "Sensor-to-vehicle frame transformation quaternion",
            ["3dm.sensor_to_vehicle_transform_quaternion_response"], {
                "function";
                "q": ["w" "x" "y" "z"] in ["1"];
            };
        /// Sensor-to-vehicle frame transformation direction cosine matrix (0x0C,0x33).
        Mip3dmSensorToVehicleTransformDcm(crate::mip_3dm::SensorToVehicleTransformDcm):
            Command 0x33, of 1,
            "3dm.sensor_to_vehicle_transform_dcm", "Sensor-to-vehicle frame transformation direction cosine matrix",
            ["3dm.sensor_to_vehicle_transform_dcm_response"], {
                "function";
                "dcm": ["m11" "m12" "m13" "m21" "m22" "m23" "m31" "m32" "m33"] in ["1"];
            };
        /// GPS dynamics mode (0x0C,0x34).
        Mip3dmGpsDynamicsMode(crate::mip_3dm::GpsDynamicsMode):
            Command 0x34, of 1,
            "3dm.gps_dynamics_mode", "GPS dynamics mode",
            ["3dm.gps_dynamics_mode_response"], {
                "function";
                "mode";
            };
        /// IMU signal conditioning (0x0C,0x35).
        Mip3dmImuSignalConditioning(crate::mip_3dm::ImuSignalConditioning):
            Command 0x35, of 1,
            "3dm.imu_signal_conditioning", "IMU signal conditioning",
            ["3dm.imu_signal_conditioning_response"], {
                "function";
                "orientation_decimation" in ["1"];
                "data_conditioning_flags";
                "inertial_filter_width" in ["1"];
                "mag_filter_width" in ["1"];
                "up_compensation" in ["s"];
                "north_compensation" in ["s"];
                "mag_bandwidth";
                "reserved";
            };
        /// IMU timestamp (0x0C,0x36).
        Mip3dmImuTimestamp(crate::mip_3dm::ImuTimestamp):
            Command 0x36, of 1,
            "3dm.imu_timestamp", "IMU timestamp",
            ["3dm.imu_timestamp_response"], {
                "function";
                "selector";
                "time";
            };
        /// Accelerometer bias configuration (0x0C,0x37).
        Mip3dmAccelBias(crate::mip_3dm::AccelBias):
            Command 0x37, of 1,
            "3dm.accel_bias", "Accelerometer bias configuration",
            ["3dm.accel_bias_response"], {
                "function";
                "bias": ["x" "y" "z"] in ["g"] of "sensor";
            };
        /// Gyroscope bias configuration (0x0C,0x38).
        Mip3dmGyroBias(crate::mip_3dm::GyroBias):
            Command 0x38, of 1,
            "3dm.gyro_bias", "Gyroscope bias configuration",
            ["3dm.gyro_bias_response"], {
                "function";
                "bias": ["x" "y" "z"] in ["rad/s"] of "sensor";
            };
        /// Capture gyroscope bias (0x0C,0x39).
        Mip3dmCaptureGyroBias(crate::mip_3dm::CaptureGyroBias):
            Command 0x39, of 1,
            "3dm.capture_gyro_bias", "Capture gyroscope bias",
            ["3dm.gyro_bias_response"], {
                "averaging_time_ms" in ["ms"];
            };
        /// Magnetometer hard iron offset (0x0C,0x3A).
        Mip3dmMagHardIronOffset(crate::mip_3dm::MagHardIronOffset):
            Command 0x3A, of 1,
            "3dm.mag_hard_iron_offset", "Magnetometer hard iron offset",
            ["3dm.mag_hard_iron_offset_response"], {
                "function";
                "offset": ["x" "y" "z"] in ["gauss"] of "sensor";
            };
        /// Magnetometer soft iron matrix (0x0C,0x3B).
        Mip3dmMagSoftIronMatrix(crate::mip_3dm::MagSoftIronMatrix):
            Command 0x3B, of 1,
            "3dm.mag_soft_iron_matrix", "Magnetometer soft iron matrix",
            ["3dm.mag_soft_iron_matrix_response"], {
                "function";
                "matrix": ["m11" "m12" "m13" "m21" "m22" "m23" "m31" "m32" "m33"] in ["1"] of "sensor";
            };
        /// Coning and sculling enable (0x0C,0x3E).
        Mip3dmConingScullingEnable(crate::mip_3dm::ConingScullingEnable):
            Command 0x3E, of 1,
            "3dm.coning_sculling_enable", "Coning and sculling enable",
            ["3dm.coning_sculling_enable_response"], {
                "function";
                "enable";
            };
        /// UART baud rate (0x0C,0x40).
        Mip3dmUartBaudRate(crate::mip_3dm::UartBaudRate):
            Command 0x40, of 1,
            "3dm.uart_baud_rate", "UART baud rate",
            ["3dm.uart_baud_rate_response"], {
                "function";
                "baud" in ["Bd"];
            };
        /// GPIO configuration (0x0C,0x41).
        Mip3dmGpioConfig(crate::mip_3dm::GpioConfig):
            Command 0x41, of 1,
            "3dm.gpio_config", "GPIO configuration",
            ["3dm.gpio_config_response"], {
                "function";
                "pin";
                "feature";
                "behavior";
                "pin_mode";
            };
        /// GPIO state (0x0C,0x42).
        Mip3dmGpioState(crate::mip_3dm::GpioState):
            Command 0x42, of 1,
            "3dm.gpio_state", "GPIO state",
            ["3dm.gpio_state_response"], {
                "function";
                "pin";
                "state";
            };
        /// Odometer configuration (0x0C,0x43).
        Mip3dmOdometerConfig(crate::mip_3dm::OdometerConfig):
            Command 0x43, of 1,
            "3dm.odometer_config", "Odometer configuration",
            ["3dm.odometer_config_response"], {
                "function";
                "mode";
                "scaling" in ["pulse/m"];
                "uncertainty" in ["1"];
            };
        /// Advanced low-pass filter settings (0x0C,0x50).
        Mip3dmImuLowPassFilter(crate::mip_3dm::ImuLowPassFilter):
            Command 0x50, of 1,
            "3dm.imu_low_pass_filter", "Advanced low-pass filter settings",
            ["3dm.imu_low_pass_filter_response"], {
                "function";
                "target_descriptor";
                "enable";
                "manual";
                "frequency" in ["Hz"];
                "reserved";
            };
        /// Complementary filter configuration (0x0C,0x51).
        Mip3dmComplementaryFilter(crate::mip_3dm::ComplementaryFilter):
            Command 0x51, of 1,
            "3dm.complementary_filter", "Complementary filter configuration",
            ["3dm.complementary_filter_response"], {
                "function";
                "pitch_roll_enable";
                "heading_enable";
                "pitch_roll_time_constant" in ["s"];
                "heading_time_constant" in ["s"];
            };
        /// Sensor range (0x0C,0x52).
        Mip3dmSensorRange(crate::mip_3dm::SensorRange):
            Command 0x52, of 1,
            "3dm.sensor_range", "Sensor range",
            ["3dm.sensor_range_response"], {
                "function";
                "sensor";
                "setting";
            };
        /// Get calibrated sensor ranges (0x0C,0x53).
        Mip3dmGetCalibratedSensorRanges(crate::mip_3dm::GetCalibratedSensorRanges):
            Command 0x53, of 1,
            "3dm.get_calibrated_sensor_ranges", "Get calibrated sensor ranges",
            ["3dm.get_calibrated_sensor_ranges_response"], {
                "sensor";
            };
        /// Low-pass anti-aliasing filter (0x0C,0x54).
        Mip3dmLowPassFilter(crate::mip_3dm::LowPassFilter):
            Command 0x54, of 1,
            "3dm.low_pass_filter", "Low-pass anti-aliasing filter",
            ["3dm.low_pass_filter_response"], {
                "function";
                "descriptor_set";
                "field_descriptor";
                "enable";
                "manual";
                "frequency" in ["Hz"];
            };
        /// Data stream format (0x0C,0x60).
        Mip3dmDataStreamFormat(crate::mip_3dm::DataStreamFormat):
            Command 0x60, of 1,
            "3dm.data_stream_format", "Data stream format",
            ["3dm.data_stream_format_response"], {
                "function";
                "stream";
                "format";
            };
        /// Device power state (0x0C,0x61).
        Mip3dmDevicePowerState(crate::mip_3dm::DevicePowerState):
            Command 0x61, of 1,
            "3dm.device_power_state", "Device power state",
            ["3dm.device_power_state_response"], {
                "function";
                "device";
                "state";
            };
        /// GPS advanced settings (0x0C,0x62).
        Mip3dmGpsAdvancedSettings(crate::mip_3dm::GpsAdvancedSettings):
            Command 0x62, of 1,
            "3dm.gps_advanced_settings", "GPS advanced settings",
            [], {
                "function";
            };
        /// Device status (0x0C,0x64).
        Mip3dmDeviceStatus(crate::mip_3dm::DeviceStatus):
            Command 0x64, of 1,
            "3dm.device_status", "Device status",
            ["3dm.device_status_basic_rq1_imu_response", "3dm.device_status_basic_response", "3dm.device_status_basic_without_state_response", "3dm.device_status_diagnostic_response", "3dm.device_status_diagnostic_gnss_response", "3dm.device_status_diagnostic_gq4_45_response", "3dm.device_status_diagnostic_rq1_45_response", "3dm.device_status_diagnostic_gx4_response", "3dm.device_status_diagnostic_imu_response", "3dm.device_status_diagnostic_gx4_imu_response", "3dm.device_status_diagnostic_rq1_imu_response", "3dm.device_status_basic_gx3_response", "3dm.device_status_diagnostic_gx3_response"], {
                "model_number";
                "status_selector";
            };
        /// IMU message format response (0x0C,0x80).
        Mip3dmImuMessageFormatResponse(crate::mip_3dm::ImuMessageFormatResponse):
            Response 0x80, of 1,
            "3dm.imu_message_format_response", "IMU message format response",
            ["3dm.imu_message_format"], {
                "descriptors" {
                    "descriptor";
                    "decimation";
                };
            };
        /// GNSS message format response (0x0C,0x81).
        Mip3dmGnssMessageFormatResponse(crate::mip_3dm::GnssMessageFormatResponse):
            Response 0x81, of 1,
            "3dm.gnss_message_format_response", "GNSS message format response",
            ["3dm.gnss_message_format"], {
                "descriptors" {
                    "descriptor";
                    "decimation";
                };
            };
        /// Estimation filter message format response (0x0C,0x82).
        Mip3dmFilterMessageFormatResponse(crate::mip_3dm::FilterMessageFormatResponse):
            Response 0x82, of 1,
            "3dm.filter_message_format_response", "Estimation filter message format response",
            ["3dm.filter_message_format"], {
                "descriptors" {
                    "descriptor";
                    "decimation";
                };
            };
        /// Get IMU data base rate response (0x0C,0x83).
        Mip3dmGetImuBaseRateResponse(crate::mip_3dm::GetImuBaseRateResponse):
            Response 0x83, of 1,
            "3dm.get_imu_base_rate_response", "Get IMU data base rate response",
            ["3dm.get_imu_base_rate"], {
                "rate" in ["Hz"];
            };
        /// Get GNSS data base rate response (0x0C,0x84).
        Mip3dmGetGnssBaseRateResponse(crate::mip_3dm::GetGnssBaseRateResponse):
            Response 0x84, of 1,
            "3dm.get_gnss_base_rate_response", "Get GNSS data base rate response",
            ["3dm.get_gnss_base_rate"], {
                "rate" in ["Hz"];
            };
        /// Data stream control response (0x0C,0x85).
        Mip3dmDataStreamControlResponse(crate::mip_3dm::DataStreamControlResponse):
            Response 0x85, of 1,
            "3dm.data_stream_control_response", "Data stream control response",
            ["3dm.data_stream_control"], {
                "descriptor_set";
                "enabled";
            };
        /// IMU signal conditioning response (0x0C,0x86).
        Mip3dmImuSignalConditioningResponse(crate::mip_3dm::ImuSignalConditioningResponse):
            Response 0x86, of 1,
            "3dm.imu_signal_conditioning_response", "IMU signal conditioning response",
            ["3dm.imu_signal_conditioning"], {
                "orientation_decimation" in ["1"];
                "data_conditioning_flags";
                "inertial_filter_width" in ["1"];
                "mag_filter_width" in ["1"];
                "up_compensation" in ["s"];
                "north_compensation" in ["s"];
                "mag_bandwidth";
                "reserved";
            };
        /// UART baud rate response (0x0C,0x87).
        Mip3dmUartBaudRateResponse(crate::mip_3dm::UartBaudRateResponse):
            Response 0x87, of 1,
            "3dm.uart_baud_rate_response", "UART baud rate response",
            ["3dm.uart_baud_rate"], {
                "baud" in ["Bd"];
            };
        /// Data stream format response (0x0C,0x88).
        Mip3dmDataStreamFormatResponse(crate::mip_3dm::DataStreamFormatResponse):
            Response 0x88, of 1,
            "3dm.data_stream_format_response", "Data stream format response",
            ["3dm.data_stream_format"], {
                "stream";
                "format";
            };
        /// Device power state response (0x0C,0x89).
        Mip3dmDevicePowerStateResponse(crate::mip_3dm::DevicePowerStateResponse):
            Response 0x89, of 1,
            "3dm.device_power_state_response", "Device power state response",
            ["3dm.device_power_state"], {
                "device";
                "state";
            };
        /// Get estimation filter data base rate response (0x0C,0x8A).
        Mip3dmGetFilterBaseRateResponse(crate::mip_3dm::GetFilterBaseRateResponse):
            Response 0x8A, of 1,
            "3dm.get_filter_base_rate_response", "Get estimation filter data base rate response",
            ["3dm.get_filter_base_rate"], {
                "rate" in ["Hz"];
            };
        /// Advanced low-pass filter settings response (0x0C,0x8B).
        Mip3dmImuLowPassFilterResponse(crate::mip_3dm::ImuLowPassFilterResponse):
            Response 0x8B, of 1,
            "3dm.imu_low_pass_filter_response", "Advanced low-pass filter settings response",
            ["3dm.imu_low_pass_filter"], {
                "target_descriptor";
                "enable";
                "manual";
                "frequency" in ["Hz"];
                "reserved";
            };
        /// NMEA message format response (0x0C,0x8C).
        Mip3dmNmeaMessageFormatResponse(crate::mip_3dm::NmeaMessageFormatResponse):
            Response 0x8C, of 1,
            "3dm.nmea_message_format_response", "NMEA message format response",
            ["3dm.nmea_message_format"], {
                "format_entries" {
                    "message_id";
                    "talker_id";
                    "source_descriptor_set";
                    "decimation";
                };
            };
        /// Get data base rate response (0x0C,0x8E).
        Mip3dmGetBaseRateResponse(crate::mip_3dm::GetBaseRateResponse):
            Response 0x8E, of 1,
            "3dm.get_base_rate_response", "Get data base rate response",
            ["3dm.get_base_rate"], {
                "descriptor_set";
                "rate" in ["Hz"];
            };
        /// Message format response (0x0C,0x8F).
        Mip3dmMessageFormatResponse(crate::mip_3dm::MessageFormatResponse):
            Response 0x8F, of 1,
            "3dm.message_format_response", "Message format response",
            ["3dm.message_format"], {
                "descriptor_set";
                "descriptors" {
                    "descriptor";
                    "decimation";
                };
            };
        /// Basic device status (inertial sensor of the 3DM-RQ1-45) (0x0C,0x90).
        Mip3dmDeviceStatusBasicRq1ImuResponse(crate::mip_3dm::DeviceStatusBasicRq1ImuResponse):
            Response 0x90, of 13,
            "3dm.device_status_basic_rq1_imu_response", "Basic device status (inertial sensor of the 3DM-RQ1-45)",
            ["3dm.device_status"], {
                "status_flags";
                "system_timer" in ["us"];
            };
        /// Basic device status (0x0C,0x90).
        Mip3dmDeviceStatusBasicResponse(crate::mip_3dm::DeviceStatusBasicResponse):
            Response 0x90, of 13,
            "3dm.device_status_basic_response", "Basic device status",
            ["3dm.device_status"], {
                "model_number";
                "status_flags";
                "system_state";
                "system_timer" in ["ms"];
            };
        /// Basic device status (without state) (0x0C,0x90).
        Mip3dmDeviceStatusBasicWithoutStateResponse(crate::mip_3dm::DeviceStatusBasicWithoutStateResponse):
            Response 0x90, of 13,
            "3dm.device_status_basic_without_state_response", "Basic device status (without state)",
            ["3dm.device_status"], {
                "model_number";
                "status_flags";
                "system_timer" in ["ms"];
            };
        /// Diagnostic device status (0x0C,0x90).
        Mip3dmDeviceStatusDiagnosticResponse(crate::mip_3dm::DeviceStatusDiagnosticResponse):
            Response 0x90, of 13,
            "3dm.device_status_diagnostic_response", "Diagnostic device status",
            ["3dm.device_status"], {
                "model_number";
                "status_flags";
                "system_state";
                "system_timer" in ["ms"];
                "imu_stream_enabled";
                "filter_stream_enabled";
                "imu_dropped_packets" in ["1"];
                "filter_dropped_packets" in ["1"];
                "comm_port_bytes_written" in ["byte"];
                "comm_port_bytes_read" in ["byte"];
                "comm_port_write_overruns" in ["1"];
                "comm_port_read_overruns" in ["1"];
                "imu_parser_errors" in ["1"];
                "imu_message_count" in ["1"];
                "imu_last_message_time" in ["ms"];
            };
        /// Diagnostic device status (with GNSS) (0x0C,0x90).
        Mip3dmDeviceStatusDiagnosticGnssResponse(crate::mip_3dm::DeviceStatusDiagnosticGnssResponse):
            Response 0x90, of 13,
            "3dm.device_status_diagnostic_gnss_response", "Diagnostic device status (with GNSS)",
            ["3dm.device_status"], {
                "model_number";
                "status_flags";
                "system_state";
                "system_timer" in ["ms"];
                "gnss_power_state";
                "pps_count" in ["1"];
                "pps_last_time" in ["ms"];
                "imu_stream_enabled";
                "gnss_stream_enabled";
                "filter_stream_enabled";
                "imu_dropped_packets" in ["1"];
                "gnss_dropped_packets" in ["1"];
                "filter_dropped_packets" in ["1"];
                "comm_port_bytes_written" in ["byte"];
                "comm_port_bytes_read" in ["byte"];
                "comm_port_write_overruns" in ["1"];
                "comm_port_read_overruns" in ["1"];
                "imu_parser_errors" in ["1"];
                "imu_message_count" in ["1"];
                "imu_last_message_time" in ["ms"];
                "gnss_parser_errors" in ["1"];
                "gnss_message_count" in ["1"];
                "gnss_last_message_time" in ["ms"];
            };
        /// Diagnostic device status (3DM-GQ4-45) (0x0C,0x90).
        Mip3dmDeviceStatusDiagnosticGq4_45Response(crate::mip_3dm::DeviceStatusDiagnosticGq4_45Response):
            Response 0x90, of 13,
            "3dm.device_status_diagnostic_gq4_45_response", "Diagnostic device status (3DM-GQ4-45)",
            ["3dm.device_status"], {
                "model_number";
                "status_flags";
                "system_state";
                "system_timer" in ["ms"];
                "gnss_power_state";
                "pps_count" in ["1"];
                "pps_last_time" in ["ms"];
                "imu_stream_enabled";
                "gnss_stream_enabled";
                "filter_stream_enabled";
                "imu_dropped_packets" in ["1"];
                "gnss_dropped_packets" in ["1"];
                "filter_dropped_packets" in ["1"];
                "comm_port_bytes_written" in ["byte"];
                "comm_port_bytes_read" in ["byte"];
                "comm_port_write_overruns" in ["1"];
                "comm_port_read_overruns" in ["1"];
                "imu_parser_errors" in ["1"];
                "imu_message_count" in ["1"];
                "imu_last_message_time" in ["ms"];
                "gnss_parser_errors" in ["1"];
                "gnss_message_count" in ["1"];
                "gnss_last_message_time" in ["ms"];
                "mag_init_failed";
                "pressure_init_failed";
                "receiver_init_failed";
            };
        /// Diagnostic device status (3DM-RQ1-45) (0x0C,0x90).
        Mip3dmDeviceStatusDiagnosticRq1_45Response(crate::mip_3dm::DeviceStatusDiagnosticRq1_45Response):
            Response 0x90, of 13,
            "3dm.device_status_diagnostic_rq1_45_response", "Diagnostic device status (3DM-RQ1-45)",
            ["3dm.device_status"], {
                "model_number";
                "status_flags";
                "system_state";
                "system_timer" in ["ms"];
                "gnss_power_state";
                "cold_start_on_power_on";
                "temperature" in ["degC"];
                "temperature_last_time" in ["ms"];
                "pps_count" in ["1"];
                "pps_last_time" in ["ms"];
                "imu_stream_enabled";
                "gnss_stream_enabled";
                "filter_stream_enabled";
                "imu_dropped_packets" in ["1"];
                "gnss_dropped_packets" in ["1"];
                "filter_dropped_packets" in ["1"];
                "comm_port_bytes_written" in ["byte"];
                "comm_port_bytes_read" in ["byte"];
                "comm_port_write_overruns" in ["1"];
                "comm_port_read_overruns" in ["1"];
                "imu_parser_errors" in ["1"];
                "imu_message_count" in ["1"];
                "imu_last_message_time" in ["ms"];
                "gnss_parser_errors" in ["1"];
                "gnss_message_count" in ["1"];
                "gnss_last_message_time" in ["ms"];
            };
        /// Diagnostic device status (3DM-GX4-15, 3DM-GX4-25) (0x0C,0x90).
        Mip3dmDeviceStatusDiagnosticGx4Response(crate::mip_3dm::DeviceStatusDiagnosticGx4Response):
            Response 0x90, of 13,
            "3dm.device_status_diagnostic_gx4_response", "Diagnostic device status (3DM-GX4-15, 3DM-GX4-25)",
            ["3dm.device_status"], {
                "model_number";
                "status_flags";
                "system_timer" in ["ms"];
                "pps_count" in ["1"];
                "pps_last_time" in ["ms"];
                "imu_stream_enabled";
                "filter_stream_enabled";
                "imu_dropped_packets" in ["1"];
                "filter_dropped_packets" in ["1"];
                "comm_port_bytes_written" in ["byte"];
                "comm_port_bytes_read" in ["byte"];
                "comm_port_write_overruns" in ["1"];
                "comm_port_read_overruns" in ["1"];
                "usb_bytes_written" in ["byte"];
                "usb_bytes_read" in ["byte"];
                "usb_write_overruns" in ["1"];
                "usb_read_overruns" in ["1"];
                "imu_parser_errors" in ["1"];
                "imu_message_count" in ["1"];
                "imu_last_message_time" in ["ms"];
            };
        /// Diagnostic device status (IMU) (0x0C,0x90).
        Mip3dmDeviceStatusDiagnosticImuResponse(crate::mip_3dm::DeviceStatusDiagnosticImuResponse):
            Response 0x90, of 13,
            "3dm.device_status_diagnostic_imu_response", "Diagnostic device status (IMU)",
            ["3dm.device_status"], {
                "model_number";
                "status_flags";
                "system_timer" in ["ms"];
                "has_mag";
                "has_pressure";
                "power_state";
                "gyro_range";
                "accel_range";
                "reserved";
                "temperature" in ["degC"];
                "temperature_last_time" in ["ms"];
                "temperature_error";
                "pps_count" in ["1"];
                "pps_last_time" in ["ms"];
                "imu_stream_enabled";
                "imu_dropped_packets" in ["1"];
                "comm_port_bytes_written" in ["byte"];
                "comm_port_bytes_read" in ["byte"];
                "comm_port_write_overruns" in ["1"];
                "comm_port_read_overruns" in ["1"];
            };
        /// Diagnostic device status (inertial sensor of the 3DM-GX4-45) (0x0C,0x90).
        Mip3dmDeviceStatusDiagnosticGx4ImuResponse(crate::mip_3dm::DeviceStatusDiagnosticGx4ImuResponse):
            Response 0x90, of 13,
            "3dm.device_status_diagnostic_gx4_imu_response", "Diagnostic device status (inertial sensor of the 3DM-GX4-45)",
            ["3dm.device_status"], {
                "model_number";
                "status_flags";
                "system_timer" in ["ms"];
                "has_mag";
                "has_pressure";
                "gyro_range";
                "accel_range";
                "mag_range";
                "pressure_range";
                "temperature" in ["degC"];
                "temperature_last_time" in ["ms"];
                "temperature_error";
                "pps_count" in ["1"];
                "pps_last_time" in ["ms"];
                "imu_stream_enabled";
                "imu_dropped_packets" in ["1"];
                "comm_port_bytes_written" in ["byte"];
                "comm_port_bytes_read" in ["byte"];
                "comm_port_write_overruns" in ["1"];
                "comm_port_read_overruns" in ["1"];
            };
        /// Diagnostic device status (inertial sensor of the 3DM-RQ1-45) (0x0C,0x90).
        Mip3dmDeviceStatusDiagnosticRq1ImuResponse(crate::mip_3dm::DeviceStatusDiagnosticRq1ImuResponse):
            Response 0x90, of 13,
            "3dm.device_status_diagnostic_rq1_imu_response", "Diagnostic device status (inertial sensor of the 3DM-RQ1-45)",
            ["3dm.device_status"], {
                "model_number";
                "status_flags";
                "system_timer" in ["us"];
                "temperature" in ["degC"];
                "temperature_last_time" in ["ms"];
                "bad_temperature_sensor_detected";
                "cold_temperature_detected";
                "bad_voltage_detected";
                "pps_count" in ["1"];
                "pps_last_time" in ["ms"];
                "imu_stream_enabled";
                "imu_dropped_packets" in ["1"];
                "comm_port_state";
                "comm_port_baud_rate" in ["Bd"];
                "comm_port_bytes_written" in ["byte"];
                "comm_port_bytes_read" in ["byte"];
                "comm_port_write_overruns" in ["1"];
                "comm_port_read_overruns" in ["1"];
            };
        /// Basic device status (3DM-GX3-35, 3DM-GX3-45) (0x0C,0x90).
        Mip3dmDeviceStatusBasicGx3Response(crate::mip_3dm::DeviceStatusBasicGx3Response):
            Response 0x90, of 13,
            "3dm.device_status_basic_gx3_response", "Basic device status (3DM-GX3-35, 3DM-GX3-45)",
            ["3dm.device_status"], {
                "model_number";
                "comm_mode";
                "comm_device";
                "settings_flags";
                "comm_state";
                "comm_baud_rate" in ["Bd"];
            };
        /// Diagnostic device status (3DM-GX3-35, 3DM-GX3-45) (0x0C,0x90).
        Mip3dmDeviceStatusDiagnosticGx3Response(crate::mip_3dm::DeviceStatusDiagnosticGx3Response):
            Response 0x90, of 13,
            "3dm.device_status_diagnostic_gx3_response", "Diagnostic device status (3DM-GX3-35, 3DM-GX3-45)",
            ["3dm.device_status"], {
                "model_number";
                "comm_mode";
                "comm_device";
                "settings_flags";
                "comm_state";
                "comm_baud_rate" in ["Bd"];
                "comm_port_bytes_written" in ["byte"];
                "comm_port_bytes_read" in ["byte"];
                "comm_port_write_overruns" in ["1"];
                "comm_port_read_overruns" in ["1"];
                "usb_state";
                "usb_bytes_written" in ["byte"];
                "usb_bytes_read" in ["byte"];
                "usb_write_overruns" in ["1"];
                "usb_read_overruns" in ["1"];
                "gnss_driver_state";
                "gnss_port_state";
                "gnss_bytes_written" in ["byte"];
                "gnss_bytes_read" in ["byte"];
                "gnss_write_overruns" in ["1"];
                "gnss_read_overruns" in ["1"];
                "gnss_message_count" in ["1"];
                "gnss_delayed_message_count" in ["1"];
                "imu_driver_state";
                "imu_port_state";
                "imu_bytes_written" in ["byte"];
                "imu_bytes_read" in ["byte"];
                "imu_write_overruns" in ["1"];
                "imu_read_overruns" in ["1"];
                "imu_message_count" in ["1"];
                "imu_delayed_message_count" in ["1"];
            };
        /// GPS dynamics mode response (0x0C,0x92).
        Mip3dmGpsDynamicsModeResponse(crate::mip_3dm::GpsDynamicsModeResponse):
            Response 0x92, of 1,
            "3dm.gps_dynamics_mode_response", "GPS dynamics mode response",
            ["3dm.gps_dynamics_mode"], {
                "mode";
            };
        /// IMU timestamp response (0x0C,0x93).
        Mip3dmImuTimestampResponse(crate::mip_3dm::ImuTimestampResponse):
            Response 0x93, of 1,
            "3dm.imu_timestamp_response", "IMU timestamp response",
            ["3dm.imu_timestamp"], {
                "selector";
                "time";
            };
        /// Complementary filter configuration response (0x0C,0x97).
        Mip3dmComplementaryFilterResponse(crate::mip_3dm::ComplementaryFilterResponse):
            Response 0x97, of 1,
            "3dm.complementary_filter_response", "Complementary filter configuration response",
            ["3dm.complementary_filter"], {
                "pitch_roll_enable";
                "heading_enable";
                "pitch_roll_time_constant" in ["s"];
                "heading_time_constant" in ["s"];
            };
        /// Accelerometer bias configuration response (0x0C,0x9A).
        Mip3dmAccelBiasResponse(crate::mip_3dm::AccelBiasResponse):
            Response 0x9A, of 1,
            "3dm.accel_bias_response", "Accelerometer bias configuration response",
            ["3dm.accel_bias"], {
                "bias": ["x" "y" "z"] in ["g"] of "sensor";
            };
        /// Gyroscope bias configuration response (0x0C,0x9B).
        Mip3dmGyroBiasResponse(crate::mip_3dm::GyroBiasResponse):
            Response 0x9B, of 1,
            "3dm.gyro_bias_response", "Gyroscope bias configuration response",
            ["3dm.gyro_bias", "3dm.capture_gyro_bias"], {
                "bias": ["x" "y" "z"] in ["rad/s"] of "sensor";
            };
        /// Magnetometer hard iron offset response (0x0C,0x9C).
        Mip3dmMagHardIronOffsetResponse(crate::mip_3dm::MagHardIronOffsetResponse):
            Response 0x9C, of 1,
            "3dm.mag_hard_iron_offset_response", "Magnetometer hard iron offset response",
            ["3dm.mag_hard_iron_offset"], {
                "offset": ["x" "y" "z"] in ["gauss"] of "sensor";
            };
        /// Magnetometer soft iron matrix response (0x0C,0x9D).
        Mip3dmMagSoftIronMatrixResponse(crate::mip_3dm::MagSoftIronMatrixResponse):
            Response 0x9D, of 1,
            "3dm.mag_soft_iron_matrix_response", "Magnetometer soft iron matrix response",
            ["3dm.mag_soft_iron_matrix"], {
                "matrix": ["m11" "m12" "m13" "m21" "m22" "m23" "m31" "m32" "m33"] in ["1"] of "sensor";
            };
        /// Coning and sculling enable response (0x0C,0x9E).
        Mip3dmConingScullingEnableResponse(crate::mip_3dm::ConingScullingEnableResponse):
            Response 0x9E, of 1,
            "3dm.coning_sculling_enable_response", "Coning and sculling enable response",
            ["3dm.coning_sculling_enable"], {
                "enable";
            };
        /// Constellation settings response (0x0C,0xA0).
        Mip3dmConstellationSettingsResponse(crate::mip_3dm::ConstellationSettingsResponse):
            Response 0xA0, of 1,
            "3dm.constellation_settings_response", "Constellation settings response",
            ["3dm.constellation_settings"], {
                "max_channels_available" in ["1"];
                "max_channels_use" in ["1"];
                "settings" {
                    "constellation_id";
                    "enable";
                    "reserved_channels" in ["1"];
                    "max_channels" in ["1"];
                    "option_flags";
                };
            };
        /// GNSS SBAS settings response (0x0C,0xA1).
        Mip3dmGnssSbasSettingsResponse(crate::mip_3dm::GnssSbasSettingsResponse):
            Response 0xA1, of 1,
            "3dm.gnss_sbas_settings_response", "GNSS SBAS settings response",
            ["3dm.gnss_sbas_settings"], {
                "enable_sbas";
                "sbas_options";
                "included_prns";
            };
        /// GNSS assisted fix response (0x0C,0xA2).
        Mip3dmGnssAssistedFixResponse(crate::mip_3dm::GnssAssistedFixResponse):
            Response 0xA2, of 1,
            "3dm.gnss_assisted_fix_response", "GNSS assisted fix response",
            ["3dm.gnss_assisted_fix"], {
                "option";
                "flags";
            };
        /// GNSS time assistance response (0x0C,0xA3).
        Mip3dmGnssTimeAssistanceResponse(crate::mip_3dm::GnssTimeAssistanceResponse):
            Response 0xA3, of 1,
            "3dm.gnss_time_assistance_response", "GNSS time assistance response",
            ["3dm.gnss_time_assistance"], {
                "tow" in ["s"];
                "week_number" in ["week"];
                "accuracy" in ["s"];
            };
        /// PPS source control response (0x0C,0xA8).
        Mip3dmPpsSourceControlResponse(crate::mip_3dm::PpsSourceControlResponse):
            Response 0xA8, of 1,
            "3dm.pps_source_control_response", "PPS source control response",
            ["3dm.pps_source_control"], {
                "source";
            };
        /// Sensor-to-vehicle frame transformation Euler response (0x0C,0xB1).
        Mip3dmSensorToVehicleTransformEulerResponse(crate::mip_3dm::SensorToVehicleTransformEulerResponse):
            Response 0xB1, of 1,
            "3dm.sensor_to_vehicle_transform_euler_response", "Sensor-to-vehicle frame transformation Euler response",
            ["3dm.sensor_to_vehicle_transform_euler"], {
                "roll" in ["rad"] of "vehicle";
                "pitch" in ["rad"] of "vehicle";
                "yaw" in ["rad"] of "vehicle";
            };
        /// Sensor-to-vehicle frame transformation quaternion response (0x0C,0xB2).
        Mip3dmSensorToVehicleTransformQuaternionResponse(crate::mip_3dm::SensorToVehicleTransformQuaternionResponse):
            Response 0xB2, of 1,
            "3dm.sensor_to_vehicle_transform_quaternion_response", "Sensor-to-vehicle frame transformation quaternion response",
            ["3dm.sensor_to_vehicle_transform_quaternion"], {
                "q": ["w" "x" "y" "z"] in ["1"];
            };
        /// Sensor-to-vehicle frame transformation direction cosine matrix response (0x0C,0xB3).
        Mip3dmSensorToVehicleTransformDcmResponse(crate::mip_3dm::SensorToVehicleTransformDcmResponse):
            Response 0xB3, of 1,
            "3dm.sensor_to_vehicle_transform_dcm_response", "Sensor-to-vehicle frame transformation direction cosine matrix response",
            ["3dm.sensor_to_vehicle_transform_dcm"], {
                "dcm": ["m11" "m12" "m13" "m21" "m22" "m23" "m31" "m32" "m33"] in ["1"];
            };
        /// Get supported events response (0x0C,0xB4).
        Mip3dmGetEventSupportResponse(crate::mip_3dm::GetEventSupportResponse):
            Response 0xB4, of 1,
            "3dm.get_event_support_response", "Get supported events response",
            ["3dm.get_event_support"], {
                "query";
                "max_instances" in ["1"];
                "entries" {
                    "type";
                    "count" in ["1"];
                };
            };
        /// Event control response (0x0C,0xB5).
        Mip3dmEventControlResponse(crate::mip_3dm::EventControlResponse):
            Response 0xB5, of 1,
            "3dm.event_control_response", "Event control response",
            ["3dm.event_control"], {
                "instance";
                "mode";
            };
        /// Get event trigger status response (0x0C,0xB6).
        Mip3dmGetEventTriggerStatusResponse(crate::mip_3dm::GetEventTriggerStatusResponse):
            Response 0xB6, of 1,
            "3dm.get_event_trigger_status_response", "Get event trigger status response",
            ["3dm.get_event_trigger_status"], {
                "triggers" {
                    "type";
                    "status";
                };
            };
        /// Get event action status response (0x0C,0xB7).
        Mip3dmGetEventActionStatusResponse(crate::mip_3dm::GetEventActionStatusResponse):
            Response 0xB7, of 1,
            "3dm.get_event_action_status_response", "Get event action status response",
            ["3dm.get_event_action_status"], {
                "actions" {
                    "action_type";
                    "trigger_id";
                };
            };
        /// Event trigger configuration response (0x0C,0xB8).
        Mip3dmEventTriggerConfigResponse(crate::mip_3dm::EventTriggerConfigResponse):
            Response 0xB8, of 1,
            "3dm.event_trigger_config_response", "Event trigger configuration response",
            ["3dm.event_trigger_config"], {
                "instance";
                "type";
                "parameters" {
                    "gpio" {
                        "pin";
                        "mode";
                    };
                    "threshold" {
                        "descriptor_set";
                        "field_descriptor";
                        "parameter_id";
                        "type";
                        "thresholds" {
                            "window" {
                                "low_threshold";
                                "high_threshold";
                            };
                            "interval" {
                                "interval_threshold";
                                "interval";
                            };
                        };
                    };
                    "combination" {
                        "logic_table";
                        "input_triggers";
                    };
                };
            };
        /// Event action configuration response (0x0C,0xB9).
        Mip3dmEventActionConfigResponse(crate::mip_3dm::EventActionConfigResponse):
            Response 0xB9, of 1,
            "3dm.event_action_config_response", "Event action configuration response",
            ["3dm.event_action_config"], {
                "instance";
                "trigger";
                "type";
                "parameters" {
                    "gpio" {
                        "pin";
                        "mode";
                    };
                    "message" {
                        "descriptor_set";
                        "decimation";
                        "descriptors";
                    };
                };
            };
        /// GPIO configuration response (0x0C,0xC1).
        Mip3dmGpioConfigResponse(crate::mip_3dm::GpioConfigResponse):
            Response 0xC1, of 1,
            "3dm.gpio_config_response", "GPIO configuration response",
            ["3dm.gpio_config"], {
                "pin";
                "feature";
                "behavior";
                "pin_mode";
            };
        /// GPIO state response (0x0C,0xC2).
        Mip3dmGpioStateResponse(crate::mip_3dm::GpioStateResponse):
            Response 0xC2, of 1,
            "3dm.gpio_state_response", "GPIO state response",
            ["3dm.gpio_state"], {
                "pin";
                "state";
            };
        /// Odometer configuration response (0x0C,0xC3).
        Mip3dmOdometerConfigResponse(crate::mip_3dm::OdometerConfigResponse):
            Response 0xC3, of 1,
            "3dm.odometer_config_response", "Odometer configuration response",
            ["3dm.odometer_config"], {
                "mode";
                "scaling" in ["pulse/m"];
                "uncertainty" in ["1"];
            };
        /// Sensor range response (0x0C,0xD2).
        Mip3dmSensorRangeResponse(crate::mip_3dm::SensorRangeResponse):
            Response 0xD2, of 1,
            "3dm.sensor_range_response", "Sensor range response",
            ["3dm.sensor_range"], {
                "sensor";
                "setting";
            };
        /// Get calibrated sensor ranges response (0x0C,0xD3).
        Mip3dmGetCalibratedSensorRangesResponse(crate::mip_3dm::GetCalibratedSensorRangesResponse):
            Response 0xD3, of 1,
            "3dm.get_calibrated_sensor_ranges_response", "Get calibrated sensor ranges response",
            ["3dm.get_calibrated_sensor_ranges"], {
                "sensor";
                "ranges" {
                    "setting";
                    "range";
                };
            };
        /// Low-pass anti-aliasing filter response (0x0C,0xD4).
        Mip3dmLowPassFilterResponse(crate::mip_3dm::LowPassFilterResponse):
            Response 0xD4, of 1,
            "3dm.low_pass_filter_response", "Low-pass anti-aliasing filter response",
            ["3dm.low_pass_filter"], {
                "descriptor_set";
                "field_descriptor";
                "enable";
                "manual";
                "frequency" in ["Hz"];
            };
    }
    #[cfg(feature = "filter")]
    0x0D => {
        /// Reset navigation filter (0x0D,0x01).
        FilterReset(crate::filter::Reset):
            Command 0x01, of 1,
            "filter.reset", "Reset navigation filter",
            [], {};
        /// Set initial attitude (0x0D,0x02).
        FilterSetInitialAttitude(crate::filter::SetInitialAttitude):
            Command 0x02, of 1,
            "filter.set_initial_attitude", "Set initial attitude",
            [], {
                "roll" in ["rad"] of "ned";
                "pitch" in ["rad"] of "ned";
                "heading" in ["rad"] of "ned";
            };
        /// Set initial heading (0x0D,0x03).
        FilterSetInitialHeading(crate::filter::SetInitialHeading):
            Command 0x03, of 1,
            "filter.set_initial_heading", "Set initial heading",
            [], {
                "heading" in ["rad"] of "ned";
            };
        /// Set initial attitude from IMU (0x0D,0x04).
        FilterSetInitialAttitudeFromImu(crate::filter::SetInitialAttitudeFromImu):
            Command 0x04, of 1,
            "filter.set_initial_attitude_from_imu", "Set initial attitude from IMU",
            [], {
                "declination" in ["rad"] of "ned";
            };
        /// Run navigation filter (0x0D,0x05).
        FilterRun(crate::filter::Run):
            Command 0x05, of 1,
            "filter.run", "Run navigation filter",
            [], {};
        /// Vehicle dynamics mode (0x0D,0x10).
        FilterVehicleDynamicsMode(crate::filter::VehicleDynamicsMode):
            Command 0x10, of 1,
            "filter.vehicle_dynamics_mode", "Vehicle dynamics mode",
            ["filter.vehicle_dynamics_mode_response"], {
                "function";
                "mode";
            };
        /// Sensor to vehicle frame transformation (0x0D,0x11).
        FilterSensorToVehicleRotationEuler(crate::filter::SensorToVehicleRotationEuler):
            Command 0x11, of 1,
            "filter.sensor_to_vehicle_rotation_euler", "Sensor to vehicle frame transformation",
            ["filter.sensor_to_vehicle_rotation_euler_response"], {
                "function";
                "roll" in ["rad"] of "sensor";
                "pitch" in ["rad"] of "sensor";
                "yaw" in ["rad"] of "sensor";
            };
        /// Sensor to vehicle offset (0x0D,0x12).
        FilterSensorToVehicleOffset(crate::filter::SensorToVehicleOffset):
            Command 0x12, of 1,
            "filter.sensor_to_vehicle_offset", "Sensor to vehicle offset",
            ["filter.sensor_to_vehicle_offset_response"], {
                "function";
                "offset": ["x" "y" "z"] in ["m"] of "sensor";
            };
        /// GNSS antenna offset (0x0D,0x13).
        FilterAntennaOffset(crate::filter::AntennaOffset):
            Command 0x13, of 1,
            "filter.antenna_offset", "GNSS antenna offset",
            ["filter.antenna_offset_response"], {
                "function";
                "offset": ["x" "y" "z"] in ["m"] of "vehicle";
            };
        /// Estimation control flags (0x0D,0x14).
        FilterEstimationControl(crate::filter::EstimationControl):
            Command 0x14, of 1,
            "filter.estimation_control", "Estimation control flags",
            ["filter.estimation_control_response"], {
                "function";
                "flags";
            };
        /// GNSS aiding source (0x0D,0x15).
        FilterGnssSource(crate::filter::GnssSource):
            Command 0x15, of 1,
            "filter.gnss_source", "GNSS aiding source",
            ["filter.gnss_source_response"], {
                "function";
                "source";
            };
        /// External GNSS update (0x0D,0x16).
        FilterExternalGnssUpdate(crate::filter::ExternalGnssUpdate):
            Command 0x16, of 1,
            "filter.external_gnss_update", "External GNSS update",
            [], {
                "tow" in ["s"];
                "week_number" in ["week"];
                "latitude" in ["deg"] of "llh";
                "longitude" in ["deg"] of "llh";
                "height" in ["m"] of "llh";
                "velocity": ["north" "east" "down"] in ["m/s"] of "ned";
                "position_uncertainty": ["north" "east" "down"] in ["m"] of "ned";
                "velocity_uncertainty": ["north" "east" "down"] in ["m/s"] of "ned";
            };
        /// External heading update (0x0D,0x17).
        FilterExternalHeadingUpdate(crate::filter::ExternalHeadingUpdate):
            Command 0x17, of 1,
            "filter.external_heading_update", "External heading update",
            [], {
                "heading" in ["rad"] of "ned";
                "heading_uncertainty" in ["rad"];
                "type";
            };
        /// Heading update control (0x0D,0x18).
        FilterHeadingSource(crate::filter::HeadingSource):
            Command 0x18, of 1,
            "filter.heading_source", "Heading update control",
            ["filter.heading_source_response"], {
                "function";
                "source";
            };
        /// Automatic initialization (0x0D,0x19).
        FilterAutoInitializationControl(crate::filter::AutoInitializationControl):
            Command 0x19, of 1,
            "filter.auto_initialization_control", "Automatic initialization",
            ["filter.auto_initialization_control_response"], {
                "function";
                "enable";
            };
        /// Accelerometer noise (0x0D,0x1A).
        FilterAccelNoise(crate::filter::AccelNoise):
            Command 0x1A, of 1,
            "filter.accel_noise", "Accelerometer noise",
            ["filter.accel_noise_response"], {
                "function";
                "noise": ["x" "y" "z"] in ["m/s^2"];
            };
        /// Gyroscope noise (0x0D,0x1B).
        FilterGyroNoise(crate::filter::GyroNoise):
            Command 0x1B, of 1,
            "filter.gyro_noise", "Gyroscope noise",
            ["filter.gyro_noise_response"], {
                "function";
                "noise": ["x" "y" "z"] in ["rad/s"];
            };
        /// Accelerometer bias model (0x0D,0x1C).
        FilterAccelBiasModel(crate::filter::AccelBiasModel):
            Command 0x1C, of 1,
            "filter.accel_bias_model", "Accelerometer bias model",
            ["filter.accel_bias_model_response"], {
                "function";
                "beta": ["x" "y" "z"] in ["1/s"];
                "noise": ["x" "y" "z"] in ["m/s^2"];
            };
        /// Gyroscope bias model (0x0D,0x1D).
        FilterGyroBiasModel(crate::filter::GyroBiasModel):
            Command 0x1D, of 1,
            "filter.gyro_bias_model", "Gyroscope bias model",
            ["filter.gyro_bias_model_response"], {
                "function";
                "beta": ["x" "y" "z"] in ["1/s"];
                "noise": ["x" "y" "z"] in ["rad/s"];
            };
        /// Automatic zero velocity update (0x0D,0x1E).
        FilterAutoZupt(crate::filter::AutoZupt):
            Command 0x1E, of 1,
            "filter.auto_zupt", "Automatic zero velocity update",
            ["filter.auto_zupt_response"], {
                "function";
                "enable";
                "threshold" in ["m/s"];
            };
        /// External heading update with time (0x0D,0x1F).
        FilterExternalHeadingUpdateWithTime(crate::filter::ExternalHeadingUpdateWithTime):
            Command 0x1F, of 1,
            "filter.external_heading_update_with_time", "External heading update with time",
            [], {
                "tow" in ["s"];
                "week_number" in ["week"];
                "heading" in ["rad"] of "ned";
                "heading_uncertainty" in ["rad"];
                "type";
            };
        /// Zero angular rate update (0x0D,0x20).
        FilterAutoAngularZupt(crate::filter::AutoAngularZupt):
            Command 0x20, of 1,
            "filter.auto_angular_zupt", "Zero angular rate update",
            ["filter.auto_angular_zupt_response"], {
                "function";
                "enable";
                "threshold" in ["rad/s"];
            };
        /// Tare orientation (0x0D,0x21).
        FilterTareOrientation(crate::filter::TareOrientation):
            Command 0x21, of 1,
            "filter.tare_orientation", "Tare orientation",
            ["filter.tare_orientation_response"], {
                "function";
                "axes";
            };
        /// Commanded zero velocity update (0x0D,0x22).
        FilterCommandedZupt(crate::filter::CommandedZupt):
            Command 0x22, of 1,
            "filter.commanded_zupt", "Commanded zero velocity update",
            [], {};
        /// Commanded zero angular rate update (0x0D,0x23).
        FilterCommandedAngularZupt(crate::filter::CommandedAngularZupt):
            Command 0x23, of 1,
            "filter.commanded_angular_zupt", "Commanded zero angular rate update",
            [], {};
        /// Set reference position (0x0D,0x26).
        FilterReferencePosition(crate::filter::ReferencePosition):
            Command 0x26, of 1,
            "filter.reference_position", "Set reference position",
            ["filter.reference_position_response"], {
                "function";
                "enable";
                "latitude" in ["deg"] of "llh";
                "longitude" in ["deg"] of "llh";
                "altitude" in ["m"];
            };
        /// Capture automatic magnetometer calibration (0x0D,0x27).
        FilterMagCaptureAutoCalibration(crate::filter::MagCaptureAutoCalibration):
            Command 0x27, of 1,
            "filter.mag_capture_auto_calibration", "Capture automatic magnetometer calibration",
            [], {
                "function";
            };
        /// Gravity noise (0x0D,0x28).
        FilterGravityNoise(crate::filter::GravityNoise):
            Command 0x28, of 1,
            "filter.gravity_noise", "Gravity noise",
            ["filter.gravity_noise_response"], {
                "function";
                "noise": ["x" "y" "z"] in ["g"];
            };
        /// Pressure altitude noise (0x0D,0x29).
        FilterPressureAltitudeNoise(crate::filter::PressureAltitudeNoise):
            Command 0x29, of 1,
            "filter.pressure_altitude_noise", "Pressure altitude noise",
            ["filter.pressure_altitude_noise_response"], {
                "function";
                "noise" in ["m"];
            };
        /// Hard iron offset noise (0x0D,0x2B).
        FilterHardIronOffsetNoise(crate::filter::HardIronOffsetNoise):
            Command 0x2B, of 1,
            "filter.hard_iron_offset_noise", "Hard iron offset noise",
            ["filter.hard_iron_offset_noise_response"], {
                "function";
                "noise": ["x" "y" "z"] in ["gauss"];
            };
        /// Soft iron matrix noise (0x0D,0x2C).
        FilterSoftIronMatrixNoise(crate::filter::SoftIronMatrixNoise):
            Command 0x2C, of 1,
            "filter.soft_iron_matrix_noise", "Soft iron matrix noise",
            ["filter.soft_iron_matrix_noise_response"], {
                "function";
                "noise": ["m11" "m12" "m13" "m21" "m22" "m23" "m31" "m32" "m33"] in ["1"];
            };
        /// Enable or disable measurements (0x0D,0x41).
        FilterEnableMeasurements(crate::filter::EnableMeasurements):
            Command 0x41, of 1,
            "filter.enable_measurements", "Enable or disable measurements",
            ["filter.enable_measurements_response"], {
                "function";
                "control";
            };
        /// Magnetometer noise (0x0D,0x42).
        FilterMagNoise(crate::filter::MagNoise):
            Command 0x42, of 1,
            "filter.mag_noise", "Magnetometer noise",
            ["filter.mag_noise_response"], {
                "function";
                "noise": ["x" "y" "z"] in ["gauss"];
            };
        /// Magnetic declination source (0x0D,0x43).
        FilterMagneticDeclinationSource(crate::filter::MagneticDeclinationSource):
            Command 0x43, of 1,
            "filter.magnetic_declination_source", "Magnetic declination source",
            ["filter.magnetic_declination_source_response"], {
                "function";
                "source";
                "declination" in ["rad"] of "ned";
            };
        /// Gravity magnitude error adaptive measurement (0x0D,0x44).
        FilterAccelMagnitudeErrorAdaptiveMeasurement(crate::filter::AccelMagnitudeErrorAdaptiveMeasurement):
            Command 0x44, of 1,
            "filter.accel_magnitude_error_adaptive_measurement", "Gravity magnitude error adaptive measurement",
            ["filter.accel_magnitude_error_adaptive_measurement_response"], {
                "function";
                "adaptive_measurement";
                "frequency" in ["Hz"];
                "low_limit" in ["m/s^2"];
                "high_limit" in ["m/s^2"];
                "low_limit_uncertainty" in ["m/s^2"];
                "high_limit_uncertainty" in ["m/s^2"];
                "minimum_uncertainty" in ["m/s^2"];
            };
        /// Magnetometer magnitude error adaptive measurement (0x0D,0x45).
        FilterMagMagnitudeErrorAdaptiveMeasurement(crate::filter::MagMagnitudeErrorAdaptiveMeasurement):
            Command 0x45, of 1,
            "filter.mag_magnitude_error_adaptive_measurement", "Magnetometer magnitude error adaptive measurement",
            ["filter.mag_magnitude_error_adaptive_measurement_response"], {
                "function";
                "adaptive_measurement";
                "frequency" in ["Hz"];
                "low_limit" in ["gauss"];
                "high_limit" in ["gauss"];
                "low_limit_uncertainty" in ["gauss"];
                "high_limit_uncertainty" in ["gauss"];
                "minimum_uncertainty" in ["gauss"];
            };
        /// Magnetometer dip angle error adaptive measurement (0x0D,0x46).
        FilterMagDipAngleErrorAdaptiveMeasurement(crate::filter::MagDipAngleErrorAdaptiveMeasurement):
            Command 0x46, of 1,
            "filter.mag_dip_angle_error_adaptive_measurement", "Magnetometer dip angle error adaptive measurement",
            ["filter.mag_dip_angle_error_adaptive_measurement_response"], {
                "function";
                "enable";
                "frequency" in ["Hz"];
                "high_limit" in ["rad"];
                "high_limit_uncertainty" in ["rad"];
                "minimum_uncertainty" in ["rad"];
            };
        /// Altitude aiding (0x0D,0x47).
        FilterAltitudeAiding(crate::filter::AltitudeAiding):
            Command 0x47, of 1,
            "filter.altitude_aiding", "Altitude aiding",
            ["filter.altitude_aiding_response"], {
                "function";
                "selector";
            };
        /// Pitch and roll aiding (0x0D,0x4B).
        FilterPitchRollAiding(crate::filter::PitchRollAiding):
            Command 0x4B, of 1,
            "filter.pitch_roll_aiding", "Pitch and roll aiding",
            ["filter.pitch_roll_aiding_response"], {
                "function";
                "aiding";
            };
        /// Magnetic inclination source (0x0D,0x4C).
        FilterMagneticInclinationSource(crate::filter::MagneticInclinationSource):
            Command 0x4C, of 1,
            "filter.magnetic_inclination_source", "Magnetic inclination source",
            ["filter.magnetic_inclination_source_response"], {
                "function";
                "source";
                "inclination" in ["rad"] of "ned";
            };
        /// Magnetic field magnitude source (0x0D,0x4D).
        FilterMagneticMagnitudeSource(crate::filter::MagneticMagnitudeSource):
            Command 0x4D, of 1,
            "filter.magnetic_magnitude_source", "Magnetic field magnitude source",
            ["filter.magnetic_magnitude_source_response"], {
                "function";
                "source";
                "magnitude" in ["gauss"];
            };
        /// Sensor to vehicle rotation, matrix (0x0D,0x4E).
        FilterSensorToVehicleRotationDcm(crate::filter::SensorToVehicleRotationDcm):
            Command 0x4E, of 1,
            "filter.sensor_to_vehicle_rotation_dcm", "Sensor to vehicle rotation, matrix",
            ["filter.sensor_to_vehicle_rotation_dcm_response"], {
                "function";
                "dcm": ["m11" "m12" "m13" "m21" "m22" "m23" "m31" "m32" "m33"] in ["1"];
            };
        /// Sensor to vehicle rotation, quaternion (0x0D,0x4F).
        FilterSensorToVehicleRotationQuaternion(crate::filter::SensorToVehicleRotationQuaternion):
            Command 0x4F, of 1,
            "filter.sensor_to_vehicle_rotation_quaternion", "Sensor to vehicle rotation, quaternion",
            ["filter.sensor_to_vehicle_rotation_quaternion_response"], {
                "function";
                "q": ["w" "x" "y" "z"] in ["1"];
            };
        /// Aiding measurement control (0x0D,0x50).
        FilterAidingMeasurementEnable(crate::filter::AidingMeasurementEnable):
            Command 0x50, of 1,
            "filter.aiding_measurement_enable", "Aiding measurement control",
            ["filter.aiding_measurement_enable_response"], {
                "function";
                "aiding_source";
                "enable";
            };
        /// Kinematic constraint (0x0D,0x51).
        FilterKinematicConstraint(crate::filter::KinematicConstraint):
            Command 0x51, of 1,
            "filter.kinematic_constraint", "Kinematic constraint",
            ["filter.kinematic_constraint_response"], {
                "function";
                "accel_constraint";
                "velocity_constraint";
                "angular_constraint";
            };
        /// Navigation filter initialization (0x0D,0x52).
        FilterInitializationConfig(crate::filter::InitializationConfig):
            Command 0x52, of 1,
            "filter.initialization_config", "Navigation filter initialization",
            ["filter.initialization_config_response"], {
                "function";
                "wait_for_run_command";
                "initial_condition_source";
                "auto_heading_alignment_selector";
                "initial_heading" in ["deg"] of "ned";
                "initial_pitch" in ["deg"] of "ned";
                "initial_roll" in ["deg"] of "ned";
                "initial_position": ["x" "y" "z"];
                "initial_velocity": ["x" "y" "z"] in ["m/s"];
                "reference_frame_selector";
            };
        /// Adaptive filter control (0x0D,0x53).
        FilterAdaptiveFilterOptions(crate::filter::AdaptiveFilterOptions):
            Command 0x53, of 1,
            "filter.adaptive_filter_options", "Adaptive filter control",
            ["filter.adaptive_filter_options_response"], {
                "function";
                "level";
                "time_limit" in ["ms"];
            };
        /// GNSS multi-antenna offset (0x0D,0x54).
        FilterMultiAntennaOffset(crate::filter::MultiAntennaOffset):
            Command 0x54, of 1,
            "filter.multi_antenna_offset", "GNSS multi-antenna offset",
            ["filter.multi_antenna_offset_response"], {
                "function";
                "receiver_id";
                "antenna_offset": ["x" "y" "z"] in ["m"] of "vehicle";
            };
        /// Relative position configuration (0x0D,0x55).
        FilterRelativePositionConfig(crate::filter::RelativePositionConfig):
            Command 0x55, of 1,
            "filter.relative_position_config", "Relative position configuration",
            ["filter.relative_position_config_response"], {
                "function";
                "source";
                "reference_frame_selector";
                "reference_coordinates": ["x" "y" "z"];
            };
        /// Reference point lever arm (0x0D,0x56).
        FilterReferencePointLeverArm(crate::filter::ReferencePointLeverArm):
            Command 0x56, of 1,
            "filter.reference_point_lever_arm", "Reference point lever arm",
            ["filter.reference_point_lever_arm_response"], {
                "function";
                "reference_point";
                "lever_arm_offset": ["x" "y" "z"] in ["m"] of "vehicle";
            };
        /// Speed measurement (0x0D,0x60).
        FilterSpeedMeasurement(crate::filter::SpeedMeasurement):
            Command 0x60, of 1,
            "filter.speed_measurement", "Speed measurement",
            [], {
                "source";
                "tow" in ["s"];
                "speed" in ["m/s"] of "vehicle";
                "speed_uncertainty" in ["m/s"];
            };
        /// Speed measurement lever arm (0x0D,0x61).
        FilterSpeedLeverArm(crate::filter::SpeedLeverArm):
            Command 0x61, of 1,
            "filter.speed_lever_arm", "Speed measurement lever arm",
            ["filter.speed_lever_arm_response"], {
                "function";
                "source";
                "lever_arm_offset": ["x" "y" "z"] in ["m"] of "vehicle";
            };
        /// Vertical gyro constraint (0x0D,0x62).
        FilterVerticalGyroConstraintControl(crate::filter::VerticalGyroConstraintControl):
            Command 0x62, of 1,
            "filter.vertical_gyro_constraint_control", "Vertical gyro constraint",
            ["filter.vertical_gyro_constraint_control_response"], {
                "function";
                "enable";
            };
        /// Wheeled vehicle constraint (0x0D,0x63).
        FilterWheeledVehicleConstraintControl(crate::filter::WheeledVehicleConstraintControl):
            Command 0x63, of 1,
            "filter.wheeled_vehicle_constraint_control", "Wheeled vehicle constraint",
            ["filter.wheeled_vehicle_constraint_control_response"], {
                "function";
                "enable";
            };
        /// GNSS antenna offset calibration (0x0D,0x64).
        FilterGnssAntennaCalibrationControl(crate::filter::GnssAntennaCalibrationControl):
            Command 0x64, of 1,
            "filter.gnss_antenna_calibration_control", "GNSS antenna offset calibration",
            ["filter.gnss_antenna_calibration_control_response"], {
                "function";
                "enable";
                "max_offset" in ["m"] of "vehicle";
            };
        /// Vehicle dynamics mode response (0x0D,0x80).
        FilterVehicleDynamicsModeResponse(crate::filter::VehicleDynamicsModeResponse):
            Response 0x80, of 1,
            "filter.vehicle_dynamics_mode_response", "Vehicle dynamics mode response",
            ["filter.vehicle_dynamics_mode"], {
                "mode";
            };
        /// Sensor to vehicle frame transformation response (0x0D,0x81).
        FilterSensorToVehicleRotationEulerResponse(crate::filter::SensorToVehicleRotationEulerResponse):
            Response 0x81, of 1,
            "filter.sensor_to_vehicle_rotation_euler_response", "Sensor to vehicle frame transformation response",
            ["filter.sensor_to_vehicle_rotation_euler"], {
                "roll" in ["rad"] of "sensor";
                "pitch" in ["rad"] of "sensor";
                "yaw" in ["rad"] of "sensor";
            };
        /// Sensor to vehicle offset response (0x0D,0x82).
        FilterSensorToVehicleOffsetResponse(crate::filter::SensorToVehicleOffsetResponse):
            Response 0x82, of 1,
            "filter.sensor_to_vehicle_offset_response", "Sensor to vehicle offset response",
            ["filter.sensor_to_vehicle_offset"], {
                "offset": ["x" "y" "z"] in ["m"] of "sensor";
            };
        /// GNSS antenna offset response (0x0D,0x83).
        FilterAntennaOffsetResponse(crate::filter::AntennaOffsetResponse):
            Response 0x83, of 1,
            "filter.antenna_offset_response", "GNSS antenna offset response",
            ["filter.antenna_offset"], {
                "offset": ["x" "y" "z"] in ["m"] of "vehicle";
            };
        /// Estimation control flags response (0x0D,0x84).
        FilterEstimationControlResponse(crate::filter::EstimationControlResponse):
            Response 0x84, of 1,
            "filter.estimation_control_response", "Estimation control flags response",
            ["filter.estimation_control"], {
                "flags";
            };
        /// GNSS aiding source response (0x0D,0x86).
        FilterGnssSourceResponse(crate::filter::GnssSourceResponse):
            Response 0x86, of 1,
            "filter.gnss_source_response", "GNSS aiding source response",
            ["filter.gnss_source"], {
                "source";
            };
        /// Heading update control response (0x0D,0x87).
        FilterHeadingSourceResponse(crate::filter::HeadingSourceResponse):
            Response 0x87, of 1,
            "filter.heading_source_response", "Heading update control response",
            ["filter.heading_source"], {
                "source";
            };
        /// Automatic initialization response (0x0D,0x88).
        FilterAutoInitializationControlResponse(crate::filter::AutoInitializationControlResponse):
            Response 0x88, of 1,
            "filter.auto_initialization_control_response", "Automatic initialization response",
            ["filter.auto_initialization_control"], {
                "enable";
            };
        /// Accelerometer noise response (0x0D,0x89).
        FilterAccelNoiseResponse(crate::filter::AccelNoiseResponse):
            Response 0x89, of 1,
            "filter.accel_noise_response", "Accelerometer noise response",
            ["filter.accel_noise"], {
                "noise": ["x" "y" "z"] in ["m/s^2"];
            };
        /// Gyroscope noise response (0x0D,0x8A).
        FilterGyroNoiseResponse(crate::filter::GyroNoiseResponse):
            Response 0x8A, of 1,
            "filter.gyro_noise_response", "Gyroscope noise response",
            ["filter.gyro_noise"], {
                "noise": ["x" "y" "z"] in ["rad/s"];
            };
        /// Accelerometer bias model response (0x0D,0x8B).
        FilterAccelBiasModelResponse(crate::filter::AccelBiasModelResponse):
            Response 0x8B, of 1,
            "filter.accel_bias_model_response", "Accelerometer bias model response",
            ["filter.accel_bias_model"], {
                "beta": ["x" "y" "z"] in ["1/s"];
                "noise": ["x" "y" "z"] in ["m/s^2"];
            };
        /// Gyroscope bias model response (0x0D,0x8C).
        FilterGyroBiasModelResponse(crate::filter::GyroBiasModelResponse):
            Response 0x8C, of 1,
            "filter.gyro_bias_model_response", "Gyroscope bias model response",
            ["filter.gyro_bias_model"], {
                "beta": ["x" "y" "z"] in ["1/s"];
                "noise": ["x" "y" "z"] in ["rad/s"];
            };
        /// Automatic zero velocity update response (0x0D,0x8D).
        FilterAutoZuptResponse(crate::filter::AutoZuptResponse):
            Response 0x8D, of 1,
            "filter.auto_zupt_response", "Automatic zero velocity update response",
            ["filter.auto_zupt"], {
                "enable";
                "threshold" in ["m/s"];
            };
        /// Zero angular rate update response (0x0D,0x8E).
        FilterAutoAngularZuptResponse(crate::filter::AutoAngularZuptResponse):
            Response 0x8E, of 1,
            "filter.auto_angular_zupt_response", "Zero angular rate update response",
            ["filter.auto_angular_zupt"], {
                "enable";
                "threshold" in ["rad/s"];
            };
        /// Set reference position response (0x0D,0x90).
        FilterReferencePositionResponse(crate::filter::ReferencePositionResponse):
            Response 0x90, of 1,
            "filter.reference_position_response", "Set reference position response",
            ["filter.reference_position"], {
                "enable";
                "latitude" in ["deg"] of "llh";
                "longitude" in ["deg"] of "llh";
                "altitude" in ["m"];
            };
        /// Gravity noise response (0x0D,0x93).
        FilterGravityNoiseResponse(crate::filter::GravityNoiseResponse):
            Response 0x93, of 1,
            "filter.gravity_noise_response", "Gravity noise response",
            ["filter.gravity_noise"], {
                "noise": ["x" "y" "z"] in ["g"];
            };
        /// Pressure altitude noise response (0x0D,0x94).
        FilterPressureAltitudeNoiseResponse(crate::filter::PressureAltitudeNoiseResponse):
            Response 0x94, of 1,
            "filter.pressure_altitude_noise_response", "Pressure altitude noise response",
            ["filter.pressure_altitude_noise"], {
                "noise" in ["m"];
            };
        /// Hard iron offset noise response (0x0D,0x96).
        FilterHardIronOffsetNoiseResponse(crate::filter::HardIronOffsetNoiseResponse):
            Response 0x96, of 1,
            "filter.hard_iron_offset_noise_response", "Hard iron offset noise response",
            ["filter.hard_iron_offset_noise"], {
                "noise": ["x" "y" "z"] in ["gauss"];
            };
        /// Soft iron matrix noise response (0x0D,0x97).
        FilterSoftIronMatrixNoiseResponse(crate::filter::SoftIronMatrixNoiseResponse):
            Response 0x97, of 1,
            "filter.soft_iron_matrix_noise_response", "Soft iron matrix noise response",
            ["filter.soft_iron_matrix_noise"], {
                "noise": ["m11" "m12" "m13" "m21" "m22" "m23" "m31" "m32" "m33"] in ["1"];
            };
        /// Tare orientation response (0x0D,0xA1).
        FilterTareOrientationResponse(crate::filter::TareOrientationResponse):
            Response 0xA1, of 1,
            "filter.tare_orientation_response", "Tare orientation response",
            ["filter.tare_orientation"], {
                "axes";
            };
        /// Enable or disable measurements response (0x0D,0xB0).
        FilterEnableMeasurementsResponse(crate::filter::EnableMeasurementsResponse):
            Response 0xB0, of 1,
            "filter.enable_measurements_response", "Enable or disable measurements response",
            ["filter.enable_measurements"], {
                "control";
            };
        /// Magnetometer noise response (0x0D,0xB1).
        FilterMagNoiseResponse(crate::filter::MagNoiseResponse):
            Response 0xB1, of 1,
            "filter.mag_noise_response", "Magnetometer noise response",
            ["filter.mag_noise"], {
                "noise": ["x" "y" "z"] in ["gauss"];
            };
        /// Magnetic declination source response (0x0D,0xB2).
        FilterMagneticDeclinationSourceResponse(crate::filter::MagneticDeclinationSourceResponse):
            Response 0xB2, of 1,
            "filter.magnetic_declination_source_response", "Magnetic declination source response",
            ["filter.magnetic_declination_source"], {
                "source";
                "declination" in ["rad"] of "ned";
            };
        /// Gravity magnitude error adaptive measurement response (0x0D,0xB3).
        FilterAccelMagnitudeErrorAdaptiveMeasurementResponse(crate::filter::AccelMagnitudeErrorAdaptiveMeasurementResponse):
            Response 0xB3, of 1,
            "filter.accel_magnitude_error_adaptive_measurement_response", "Gravity magnitude error adaptive measurement response",
            ["filter.accel_magnitude_error_adaptive_measurement"], {
                "adaptive_measurement";
                "frequency" in ["Hz"];
                "low_limit" in ["m/s^2"];
                "high_limit" in ["m/s^2"];
                "low_limit_uncertainty" in ["m/s^2"];
                "high_limit_uncertainty" in ["m/s^2"];
                "minimum_uncertainty" in ["m/s^2"];
            };
        /// Magnetometer magnitude error adaptive measurement response (0x0D,0xB4).
        FilterMagMagnitudeErrorAdaptiveMeasurementResponse(crate::filter::MagMagnitudeErrorAdaptiveMeasurementResponse):
            Response 0xB4, of 1,
            "filter.mag_magnitude_error_adaptive_measurement_response", "Magnetometer magnitude error adaptive measurement response",
            ["filter.mag_magnitude_error_adaptive_measurement"], {
                "adaptive_measurement";
                "frequency" in ["Hz"];
                "low_limit" in ["gauss"];
                "high_limit" in ["gauss"];
                "low_limit_uncertainty" in ["gauss"];
                "high_limit_uncertainty" in ["gauss"];
                "minimum_uncertainty" in ["gauss"];
            };
        /// Magnetometer dip angle error adaptive measurement response (0x0D,0xB5).
        FilterMagDipAngleErrorAdaptiveMeasurementResponse(crate::filter::MagDipAngleErrorAdaptiveMeasurementResponse):
            Response 0xB5, of 1,
            "filter.mag_dip_angle_error_adaptive_measurement_response", "Magnetometer dip angle error adaptive measurement response",
            ["filter.mag_dip_angle_error_adaptive_measurement"], {
                "enable";
                "frequency" in ["Hz"];
                "high_limit" in ["rad"];
                "high_limit_uncertainty" in ["rad"];
                "minimum_uncertainty" in ["rad"];
            };
        /// Altitude aiding response (0x0D,0xB7).
        FilterAltitudeAidingResponse(crate::filter::AltitudeAidingResponse):
            Response 0xB7, of 1,
            "filter.altitude_aiding_response", "Altitude aiding response",
            ["filter.altitude_aiding"], {
                "selector";
            };
        /// Pitch and roll aiding response (0x0D,0xBB).
        FilterPitchRollAidingResponse(crate::filter::PitchRollAidingResponse):
            Response 0xBB, of 1,
            "filter.pitch_roll_aiding_response", "Pitch and roll aiding response",
            ["filter.pitch_roll_aiding"], {
                "aiding";
            };
        /// Magnetic inclination source response (0x0D,0xBC).
        FilterMagneticInclinationSourceResponse(crate::filter::MagneticInclinationSourceResponse):
            Response 0xBC, of 1,
            "filter.magnetic_inclination_source_response", "Magnetic inclination source response",
            ["filter.magnetic_inclination_source"], {
                "source";
                "inclination" in ["rad"] of "ned";
            };
        /// Magnetic field magnitude source response (0x0D,0xBD).
        FilterMagneticMagnitudeSourceResponse(crate::filter::MagneticMagnitudeSourceResponse):
            Response 0xBD, of 1,
            "filter.magnetic_magnitude_source_response", "Magnetic field magnitude source response",
            ["filter.magnetic_magnitude_source"], {
                "source";
                "magnitude" in ["gauss"];
            };
        /// Sensor to vehicle rotation, matrix response (0x0D,0xBE).
        FilterSensorToVehicleRotationDcmResponse(crate::filter::SensorToVehicleRotationDcmResponse):
            Response 0xBE, of 1,
            "filter.sensor_to_vehicle_rotation_dcm_response", "Sensor to vehicle rotation, matrix response",
            ["filter.sensor_to_vehicle_rotation_dcm"], {
                "dcm": ["m11" "m12" "m13" "m21" "m22" "m23" "m31" "m32" "m33"] in ["1"];
            };
        /// Sensor to vehicle rotation, quaternion response (0x0D,0xBF).
        FilterSensorToVehicleRotationQuaternionResponse(crate::filter::SensorToVehicleRotationQuaternionResponse):
            Response 0xBF, of 1,
            "filter.sensor_to_vehicle_rotation_quaternion_response", "Sensor to vehicle rotation, quaternion response",
            ["filter.sensor_to_vehicle_rotation_quaternion"], {
                "q": ["w" "x" "y" "z"] in ["1"];
            };
        /// Aiding measurement control response (0x0D,0xD0).
        FilterAidingMeasurementEnableResponse(crate::filter::AidingMeasurementEnableResponse):
            Response 0xD0, of 1,
            "filter.aiding_measurement_enable_response", "Aiding measurement control response",
            ["filter.aiding_measurement_enable"], {
                "aiding_source";
                "enable";
            };
        /// Kinematic constraint response (0x0D,0xD1).
        FilterKinematicConstraintResponse(crate::filter::KinematicConstraintResponse):
            Response 0xD1, of 1,
            "filter.kinematic_constraint_response", "Kinematic constraint response",
            ["filter.kinematic_constraint"], {
                "accel_constraint";
                "velocity_constraint";
                "angular_constraint";
            };
        /// Navigation filter initialization response (0x0D,0xD2).
        FilterInitializationConfigResponse(crate::filter::InitializationConfigResponse):
            Response 0xD2, of 1,
            "filter.initialization_config_response", "Navigation filter initialization response",
            ["filter.initialization_config"], {
                "wait_for_run_command";
                "initial_condition_source";
                "auto_heading_alignment_selector";
                "initial_heading" in ["deg"] of "ned";
                "initial_pitch" in ["deg"] of "ned";
                "initial_roll" in ["deg"] of "ned";
                "initial_position": ["x" "y" "z"];
                "initial_velocity": ["x" "y" "z"] in ["m/s"];
                "reference_frame_selector";
            };
        /// Adaptive filter control response (0x0D,0xD3).
        FilterAdaptiveFilterOptionsResponse(crate::filter::AdaptiveFilterOptionsResponse):
            Response 0xD3, of 1,
            "filter.adaptive_filter_options_response", "Adaptive filter control response",
            ["filter.adaptive_filter_options"], {
                "level";
                "time_limit" in ["ms"];
            };
        /// GNSS multi-antenna offset response (0x0D,0xD4).
        FilterMultiAntennaOffsetResponse(crate::filter::MultiAntennaOffsetResponse):
            Response 0xD4, of 1,
            "filter.multi_antenna_offset_response", "GNSS multi-antenna offset response",
            ["filter.multi_antenna_offset"], {
                "receiver_id";
                "antenna_offset": ["x" "y" "z"] in ["m"] of "vehicle";
            };
        /// Relative position configuration response (0x0D,0xD5).
        FilterRelativePositionConfigResponse(crate::filter::RelativePositionConfigResponse):
            Response 0xD5, of 1,
            "filter.relative_position_config_response", "Relative position configuration response",
            ["filter.relative_position_config"], {
                "source";
                "reference_frame_selector";
                "reference_coordinates": ["x" "y" "z"];
            };
        /// Reference point lever arm response (0x0D,0xD6).
        FilterReferencePointLeverArmResponse(crate::filter::ReferencePointLeverArmResponse):
            Response 0xD6, of 1,
            "filter.reference_point_lever_arm_response", "Reference point lever arm response",
            ["filter.reference_point_lever_arm"], {
                "reference_point";
                "lever_arm_offset": ["x" "y" "z"] in ["m"] of "vehicle";
            };
        /// Speed measurement lever arm response (0x0D,0xE1).
        FilterSpeedLeverArmResponse(crate::filter::SpeedLeverArmResponse):
            Response 0xE1, of 1,
            "filter.speed_lever_arm_response", "Speed measurement lever arm response",
            ["filter.speed_lever_arm"], {
                "source";
                "lever_arm_offset": ["x" "y" "z"] in ["m"] of "vehicle";
            };
        /// Vertical gyro constraint response (0x0D,0xE2).
        FilterVerticalGyroConstraintControlResponse(crate::filter::VerticalGyroConstraintControlResponse):
            Response 0xE2, of 1,
            "filter.vertical_gyro_constraint_control_response", "Vertical gyro constraint response",
            ["filter.vertical_gyro_constraint_control"], {
                "enable";
            };
        /// Wheeled vehicle constraint response (0x0D,0xE3).
        FilterWheeledVehicleConstraintControlResponse(crate::filter::WheeledVehicleConstraintControlResponse):
            Response 0xE3, of 1,
            "filter.wheeled_vehicle_constraint_control_response", "Wheeled vehicle constraint response",
            ["filter.wheeled_vehicle_constraint_control"], {
                "enable";
            };
        /// GNSS antenna offset calibration response (0x0D,0xE4).
        FilterGnssAntennaCalibrationControlResponse(crate::filter::GnssAntennaCalibrationControlResponse):
            Response 0xE4, of 1,
            "filter.gnss_antenna_calibration_control_response", "GNSS antenna offset calibration response",
            ["filter.gnss_antenna_calibration_control"], {
                "enable";
                "max_offset" in ["m"] of "vehicle";
            };
    }
    #[cfg(feature = "gnss")]
    0x0E => {
        /// Receiver info (0x0E,0x01).
        GnssReceiverInfo(crate::gnss::ReceiverInfo):
            Command 0x01, of 1,
            "gnss.receiver_info", "Receiver info",
            ["gnss.receiver_info_response"], {};
        /// Signal configuration (0x0E,0x02).
        GnssSignalConfig(crate::gnss::SignalConfig):
            Command 0x02, of 1,
            "gnss.signal_config", "Signal configuration",
            ["gnss.signal_config_response"], {
                "function";
                "gps_enable";
                "glonass_enable";
                "galileo_enable";
                "beidou_enable";
                "reserved";
            };
        /// Receiver reset (0x0E,0x03).
        GnssReceiverReset(crate::gnss::ReceiverReset):
            Command 0x03, of 1,
            "gnss.receiver_reset", "Receiver reset",
            [], {
                "receiver_id";
                "reset_type";
            };
        /// RTK configuration (0x0E,0x04).
        GnssRtkConfig(crate::gnss::RtkConfig):
            Command 0x04, of 1,
            "gnss.rtk_config", "RTK configuration",
            ["gnss.rtk_config_response"], {
                "function";
                "ambiguity_fix_mode";
                "reserved";
            };
        /// RTK dongle configuration (0x0E,0x10).
        GnssRtkDongleConfig(crate::gnss::RtkDongleConfig):
            Command 0x10, of 1,
            "gnss.rtk_dongle_config", "RTK dongle configuration",
            ["gnss.rtk_dongle_config_response"], {
                "function";
                "enable";
                "reserved";
            };
        /// SPARTN configuration (0x0E,0x20).
        GnssSpartnConfig(crate::gnss::SpartnConfig):
            Command 0x20, of 1,
            "gnss.spartn_config", "SPARTN configuration",
            ["gnss.spartn_config_response"], {
                "function";
                "enable";
                "type";
                "current_key_tow" in ["s"];
                "current_key_week" in ["week"];
                "current_key";
                "next_key_tow" in ["s"];
                "next_key_week" in ["week"];
                "next_key";
            };
        /// Receiver safe mode (0x0E,0x60).
        GnssReceiverSafeMode(crate::gnss::ReceiverSafeMode):
            Command 0x60, of 1,
            "gnss.receiver_safe_mode", "Receiver safe mode",
            [], {
                "receiver_id";
                "enable";
            };
        /// Receiver info response (0x0E,0x81).
        GnssReceiverInfoResponse(crate::gnss::ReceiverInfoResponse):
            Response 0x81, of 1,
            "gnss.receiver_info_response", "Receiver info response",
            ["gnss.receiver_info"], {
                "receiver_info" {
                    "receiver_id";
                    "mip_data_descriptor_set";
                    "description";
                };
            };
        /// Signal configuration response (0x0E,0x82).
        GnssSignalConfigResponse(crate::gnss::SignalConfigResponse):
            Response 0x82, of 1,
            "gnss.signal_config_response", "Signal configuration response",
            ["gnss.signal_config"], {
                "gps_enable";
                "glonass_enable";
                "galileo_enable";
                "beidou_enable";
                "reserved";
            };
        /// RTK configuration response (0x0E,0x84).
        GnssRtkConfigResponse(crate::gnss::RtkConfigResponse):
            Response 0x84, of 1,
            "gnss.rtk_config_response", "RTK configuration response",
            ["gnss.rtk_config"], {
                "ambiguity_fix_mode";
                "reserved";
            };
        /// RTK dongle configuration response (0x0E,0x90).
        GnssRtkDongleConfigResponse(crate::gnss::RtkDongleConfigResponse):
            Response 0x90, of 1,
            "gnss.rtk_dongle_config_response", "RTK dongle configuration response",
            ["gnss.rtk_dongle_config"], {
                "enable";
                "reserved";
            };
        /// SPARTN configuration response (0x0E,0xA0).
        GnssSpartnConfigResponse(crate::gnss::SpartnConfigResponse):
            Response 0xA0, of 1,
            "gnss.spartn_config_response", "SPARTN configuration response",
            ["gnss.spartn_config"], {
                "enable";
                "type";
                "current_key_tow" in ["s"];
                "current_key_week" in ["week"];
                "current_key";
                "next_key_tow" in ["s"];
                "next_key_week" in ["week"];
                "next_key";
            };
    }
    #[cfg(feature = "rtk")]
    0x0F => {
        /// Get status flags (0x0F,0x01).
        RtkGetStatusFlags(crate::rtk::GetStatusFlags):
            Command 0x01, of 1,
            "rtk.get_status_flags", "Get status flags",
            ["rtk.get_status_flags_response"], {};
        /// Get IMEI (0x0F,0x02).
        RtkGetImei(crate::rtk::GetImei):
            Command 0x02, of 1,
            "rtk.get_imei", "Get IMEI",
            ["rtk.get_imei_response"], {};
        /// Get IMSI (0x0F,0x03).
        RtkGetImsi(crate::rtk::GetImsi):
            Command 0x03, of 1,
            "rtk.get_imsi", "Get IMSI",
            ["rtk.get_imsi_response"], {};
        /// Get ICCID (0x0F,0x04).
        RtkGetIccid(crate::rtk::GetIccid):
            Command 0x04, of 1,
            "rtk.get_iccid", "Get ICCID",
            ["rtk.get_iccid_response"], {};
        /// Get RSSI (0x0F,0x05).
        RtkGetRssi(crate::rtk::GetRssi):
            Command 0x05, of 1,
            "rtk.get_rssi", "Get RSSI",
            ["rtk.get_rssi_response"], {};
        /// Connected device type (0x0F,0x06).
        RtkConnectedDeviceType(crate::rtk::ConnectedDeviceType):
            Command 0x06, of 1,
            "rtk.connected_device_type", "Connected device type",
            ["rtk.connected_device_type_response"], {
                "function";
                "device_type";
            };
        /// Get activation code (0x0F,0x07).
        RtkGetActivationCode(crate::rtk::GetActivationCode):
            Command 0x07, of 1,
            "rtk.get_activation_code", "Get activation code",
            ["rtk.get_activation_code_response"], {};
        /// Get modem firmware version (0x0F,0x08).
        RtkGetModemFirmwareVersion(crate::rtk::GetModemFirmwareVersion):
            Command 0x08, of 1,
            "rtk.get_modem_firmware_version", "Get modem firmware version",
            ["rtk.get_modem_firmware_version_response"], {};
        /// Service status (0x0F,0x0A).
        RtkServiceStatus(crate::rtk::ServiceStatus):
            Command 0x0A, of 1,
            "rtk.service_status", "Service status",
            ["rtk.service_status_response"], {
                "reserved1";
                "reserved2";
            };
        /// Erase storage (0x0F,0x20).
        RtkEraseStorage(crate::rtk::EraseStorage):
            Command 0x20, of 1,
            "rtk.erase_storage", "Erase storage",
            [], {
                "media";
            };
        /// LED control (0x0F,0x21).
        RtkLedControl(crate::rtk::LedControl):
            Command 0x21, of 1,
            "rtk.led_control", "LED control",
            [], {
                "primary_color";
                "alternate_color";
                "action";
                "period";
            };
        /// Modem hard reset (0x0F,0x22).
        RtkModemHardReset(crate::rtk::ModemHardReset):
            Command 0x22, of 1,
            "rtk.modem_hard_reset", "Modem hard reset",
            [], {};
        /// Get status flags response (0x0F,0x81).
        RtkGetStatusFlagsResponse(crate::rtk::GetStatusFlagsResponse):
            Response 0x81, of 1,
            "rtk.get_status_flags_response", "Get status flags response",
            ["rtk.get_status_flags"], {
                "flags";
            };
        /// Get IMEI response (0x0F,0x82).
        RtkGetImeiResponse(crate::rtk::GetImeiResponse):
            Response 0x82, of 1,
            "rtk.get_imei_response", "Get IMEI response",
            ["rtk.get_imei"], {
                "imei";
            };
        /// Get IMSI response (0x0F,0x83).
        RtkGetImsiResponse(crate::rtk::GetImsiResponse):
            Response 0x83, of 1,
            "rtk.get_imsi_response", "Get IMSI response",
            ["rtk.get_imsi"], {
                "imsi";
            };
        /// Get ICCID response (0x0F,0x84).
        RtkGetIccidResponse(crate::rtk::GetIccidResponse):
            Response 0x84, of 1,
            "rtk.get_iccid_response", "Get ICCID response",
            ["rtk.get_iccid"], {
                "iccid";
            };
        /// Get RSSI response (0x0F,0x85).
        RtkGetRssiResponse(crate::rtk::GetRssiResponse):
            Response 0x85, of 1,
            "rtk.get_rssi_response", "Get RSSI response",
            ["rtk.get_rssi"], {
                "valid";
                "rssi";
                "signal_quality";
            };
        /// Connected device type response (0x0F,0x86).
        RtkConnectedDeviceTypeResponse(crate::rtk::ConnectedDeviceTypeResponse):
            Response 0x86, of 1,
            "rtk.connected_device_type_response", "Connected device type response",
            ["rtk.connected_device_type"], {
                "device_type";
            };
        /// Get activation code response (0x0F,0x87).
        RtkGetActivationCodeResponse(crate::rtk::GetActivationCodeResponse):
            Response 0x87, of 1,
            "rtk.get_activation_code_response", "Get activation code response",
            ["rtk.get_activation_code"], {
                "activation_code";
            };
        /// Get modem firmware version response (0x0F,0x88).
        RtkGetModemFirmwareVersionResponse(crate::rtk::GetModemFirmwareVersionResponse):
            Response 0x88, of 1,
            "rtk.get_modem_firmware_version_response", "Get modem firmware version response",
            ["rtk.get_modem_firmware_version"], {
                "modem_firmware_version";
            };
        /// Service status response (0x0F,0x8A).
        RtkServiceStatusResponse(crate::rtk::ServiceStatusResponse):
            Response 0x8A, of 1,
            "rtk.service_status_response", "Service status response",
            ["rtk.service_status"], {
                "flags";
                "received_bytes" in ["byte"];
                "last_bytes" in ["byte"];
                "last_bytes_time";
            };
    }
    #[cfg(feature = "displacement")]
    0x11 => {
        /// Get analog to displacement calibration (0x11,0x01).
        DisplacementGetCalibration(crate::displacement::GetCalibration):
            Command 0x01, of 1,
            "displacement.get_calibration", "Get analog to displacement calibration",
            ["displacement.get_calibration_response"], {};
        /// Displacement output data rate (0x11,0x02).
        DisplacementOutputRate(crate::displacement::OutputRate):
            Command 0x02, of 1,
            "displacement.output_rate", "Displacement output data rate",
            ["displacement.output_rate_response"], {
                "function";
            };
        /// Displacement device time (0x11,0x04).
        DisplacementDeviceTime(crate::displacement::DeviceTime):
            Command 0x04, of 1,
            "displacement.device_time", "Displacement device time",
            [], {
                "function";
                "time" in ["ns"];
            };
        /// Get analog to displacement calibration response (0x11,0x81).
        DisplacementGetCalibrationResponse(crate::displacement::GetCalibrationResponse):
            Response 0x81, of 1,
            "displacement.get_calibration_response", "Get analog to displacement calibration response",
            ["displacement.get_calibration"], {
                "slope";
                "offset";
            };
        /// Displacement output data rate response (0x11,0x82).
        DisplacementOutputRateResponse(crate::displacement::OutputRateResponse):
            Response 0x82, of 1,
            "displacement.output_rate_response", "Displacement output data rate response",
            ["displacement.output_rate"], {
                "rate" in ["Hz"];
            };
    }
    #[cfg(feature = "aiding")]
    0x13 => {
        /// Frame configuration (0x13,0x01).
        AidingFrameConfig(crate::aiding::FrameConfig):
            Command 0x01, of 1,
            "aiding.frame_config", "Frame configuration",
            ["aiding.frame_config_response"], {
                "function";
                "frame_id";
                "format";
                "tracking_enabled";
                "translation": ["x" "y" "z"] in ["m"] of "vehicle";
                "rotation" {
                    "euler": ["x" "y" "z"] in ["rad"] of "vehicle";
                    "quaternion": ["w" "x" "y" "z"] in ["1"];
                };
            };
        /// Sensor frame map (0x13,0x02).
        AidingSensorFrameMap(crate::aiding::SensorFrameMap):
            Command 0x02, of 1,
            "aiding.sensor_frame_map", "Sensor frame map",
            ["aiding.sensor_frame_map_response"], {
                "function";
                "sensor_id";
                "frame_id";
            };
        /// Echo control (0x13,0x1F).
        AidingEchoControl(crate::aiding::EchoControl):
            Command 0x1F, of 1,
            "aiding.echo_control", "Echo control",
            ["aiding.echo_control_response"], {
                "function";
                "mode";
            };
        /// ECEF position (0x13,0x21).
        AidingEcefPosition(crate::aiding::EcefPosition):
            Command 0x21, of 1,
            "aiding.ecef_position", "ECEF position",
            [], {
                "time" {
                    "timebase";
                    "reserved";
                    "nanoseconds" in ["ns"];
                };
                "frame_id";
                "position": ["x" "y" "z"] in ["m"] of "ecef";
                "uncertainty": ["x" "y" "z"] in ["m"] of "ecef";
                "valid_flags";
            };
        /// LLH position (0x13,0x22).
        AidingLlhPosition(crate::aiding::LlhPosition):
            Command 0x22, of 1,
            "aiding.llh_position", "LLH position",
            [], {
                "time" {
                    "timebase";
                    "reserved";
                    "nanoseconds" in ["ns"];
                };
                "frame_id";
                "latitude" in ["deg"] of "llh";
                "longitude" in ["deg"] of "llh";
                "height" in ["m"] of "llh";
                "uncertainty": ["north" "east" "down"] in ["m"] of "ned";
                "valid_flags";
            };
        /// Height above ellipsoid (0x13,0x23).
        AidingHeightAboveEllipsoid(crate::aiding::HeightAboveEllipsoid):
            Command 0x23, of 1,
            "aiding.height_above_ellipsoid", "Height above ellipsoid",
            [], {
                "time" {
                    "timebase";
                    "reserved";
                    "nanoseconds" in ["ns"];
                };
                "frame_id";
                "height" in ["m"] of "llh";
                "uncertainty" in ["m"];
                "valid_flags";
            };
        /// Pressure (old) (0x13,0x25).
        AidingPressureOld(crate::aiding::PressureOld):
            Command 0x25, of 1,
            "aiding.pressure_old", "Pressure (old)",
            [], {
                "time" {
                    "timebase";
                    "reserved";
                    "nanoseconds" in ["ns"];
                };
                "frame_id";
                "pressure" in ["mbar"];
                "uncertainty" in ["mbar"];
                "valid_flags";
            };
        /// ECEF velocity (0x13,0x28).
        AidingEcefVelocity(crate::aiding::EcefVelocity):
            Command 0x28, of 1,
            "aiding.ecef_velocity", "ECEF velocity",
            [], {
                "time" {
                    "timebase";
                    "reserved";
                    "nanoseconds" in ["ns"];
                };
                "frame_id";
                "velocity": ["x" "y" "z"] in ["m/s"] of "ecef";
                "uncertainty": ["x" "y" "z"] in ["m/s"] of "ecef";
                "valid_flags";
            };
        /// NED velocity (0x13,0x29).
        AidingNedVelocity(crate::aiding::NedVelocity):
            Command 0x29, of 1,
            "aiding.ned_velocity", "NED velocity",
            [], {
                "time" {
                    "timebase";
                    "reserved";
                    "nanoseconds" in ["ns"];
                };
                "frame_id";
                "velocity": ["north" "east" "down"] in ["m/s"] of "ned";
                "uncertainty": ["north" "east" "down"] in ["m/s"] of "ned";
                "valid_flags";
            };
        /// Body frame velocity (0x13,0x2A).
        AidingBodyFrameVelocity(crate::aiding::BodyFrameVelocity):
            Command 0x2A, of 1,
            "aiding.body_frame_velocity", "Body frame velocity",
            [], {
                "time" {
                    "timebase";
                    "reserved";
                    "nanoseconds" in ["ns"];
                };
                "frame_id";
                "velocity": ["x" "y" "z"] in ["m/s"] of "aiding";
                "uncertainty": ["x" "y" "z"] in ["m/s"] of "aiding";
                "valid_flags";
            };
        /// True heading (0x13,0x31).
        AidingTrueHeading(crate::aiding::TrueHeading):
            Command 0x31, of 1,
            "aiding.true_heading", "True heading",
            [], {
                "time" {
                    "timebase";
                    "reserved";
                    "nanoseconds" in ["ns"];
                };
                "frame_id";
                "heading" in ["rad"] of "ned";
                "uncertainty" in ["rad"];
                "valid_flags";
            };
        /// Magnetic field (0x13,0x32).
        AidingMagneticField(crate::aiding::MagneticField):
            Command 0x32, of 1,
            "aiding.magnetic_field", "Magnetic field",
            [], {
                "time" {
                    "timebase";
                    "reserved";
                    "nanoseconds" in ["ns"];
                };
                "frame_id";
                "magnetic_field": ["x" "y" "z"] in ["gauss"] of "aiding";
                "uncertainty": ["x" "y" "z"] in ["gauss"] of "aiding";
                "valid_flags";
            };
        /// Pressure (0x13,0x33).
        AidingPressure(crate::aiding::Pressure):
            Command 0x33, of 1,
            "aiding.pressure", "Pressure",
            [], {
                "time" {
                    "timebase";
                    "reserved";
                    "nanoseconds" in ["ns"];
                };
                "frame_id";
                "pressure" in ["mbar"];
                "uncertainty" in ["mbar"];
                "valid_flags";
            };
        /// Frame configuration response (0x13,0x81).
        AidingFrameConfigResponse(crate::aiding::FrameConfigResponse):
            Response 0x81, of 1,
            "aiding.frame_config_response", "Frame configuration response",
            ["aiding.frame_config"], {
                "frame_id";
                "format";
                "tracking_enabled";
                "translation": ["x" "y" "z"] in ["m"] of "vehicle";
                "rotation" {
                    "euler": ["x" "y" "z"] in ["rad"] of "vehicle";
                    "quaternion": ["w" "x" "y" "z"] in ["1"];
                };
            };
        /// Sensor frame map response (0x13,0x82).
        AidingSensorFrameMapResponse(crate::aiding::SensorFrameMapResponse):
            Response 0x82, of 1,
            "aiding.sensor_frame_map_response", "Sensor frame map response",
            ["aiding.sensor_frame_map"], {
                "sensor_id";
                "frame_id";
            };
        /// Echo control response (0x13,0x9F).
        AidingEchoControlResponse(crate::aiding::EchoControlResponse):
            Response 0x9F, of 1,
            "aiding.echo_control_response", "Echo control response",
            ["aiding.echo_control"], {
                "mode";
            };
    }
    #[cfg(feature = "system")]
    0x7F => {
        /// Interface control (0x7F,0x02).
        SystemInterfaceControl(crate::system::InterfaceControl):
            Command 0x02, of 1,
            "system.interface_control", "Interface control",
            ["system.interface_control_response"], {
                "function";
                "port";
                "protocols_incoming";
                "protocols_outgoing";
            };
        /// Communication mode (0x7F,0x10).
        SystemCommMode(crate::system::CommMode):
            Command 0x10, of 1,
            "system.comm_mode", "Communication mode",
            ["system.comm_mode_response"], {
                "function";
                "mode";
            };
        /// Interface control response (0x7F,0x82).
        SystemInterfaceControlResponse(crate::system::InterfaceControlResponse):
            Response 0x82, of 1,
            "system.interface_control_response", "Interface control response",
            ["system.interface_control"], {
                "port";
                "protocols_incoming";
                "protocols_outgoing";
            };
        /// Communication mode response (0x7F,0x90).
        SystemCommModeResponse(crate::system::CommModeResponse):
            Response 0x90, of 1,
            "system.comm_mode_response", "Communication mode response",
            ["system.comm_mode"], {
                "mode";
            };
    }
    #[cfg(feature = "sensor")]
    0x80 => {
        /// Raw accel (0x80,0x01).
        SensorRawAccel(crate::sensor::RawAccel):
            Data 0x01, of 1,
            "sensor.raw_accel", "Raw accel",
            [], {
                "raw_accel": ["x" "y" "z"] in ["1"] of "sensor";
            };
        /// Raw gyro (0x80,0x02).
        SensorRawGyro(crate::sensor::RawGyro):
            Data 0x02, of 1,
            "sensor.raw_gyro", "Raw gyro",
            [], {
                "raw_gyro": ["x" "y" "z"] in ["1"] of "sensor";
            };
        /// Raw mag (0x80,0x03).
        SensorRawMag(crate::sensor::RawMag):
            Data 0x03, of 1,
            "sensor.raw_mag", "Raw mag",
            [], {
                "raw_mag": ["x" "y" "z"] in ["1"] of "vehicle";
            };
        /// Scaled accel (0x80,0x04).
        SensorScaledAccel(crate::sensor::ScaledAccel):
            Data 0x04, of 1,
            "sensor.scaled_accel", "Scaled accel",
            [], {
                "scaled_accel": ["x" "y" "z"] in ["g"] of "vehicle";
            };
        /// Scaled gyro (0x80,0x05).
        SensorScaledGyro(crate::sensor::ScaledGyro):
            Data 0x05, of 1,
            "sensor.scaled_gyro", "Scaled gyro",
            [], {
                "scaled_gyro": ["x" "y" "z"] in ["rad/s"] of "vehicle";
            };
        /// Scaled mag (0x80,0x06).
        SensorScaledMag(crate::sensor::ScaledMag):
            Data 0x06, of 1,
            "sensor.scaled_mag", "Scaled mag",
            [], {
                "scaled_mag": ["x" "y" "z"] in ["gauss"] of "vehicle";
            };
        /// Delta theta (0x80,0x07).
        SensorDeltaTheta(crate::sensor::DeltaTheta):
            Data 0x07, of 1,
            "sensor.delta_theta", "Delta theta",
            [], {
                "delta_theta": ["x" "y" "z"] in ["rad"] of "vehicle";
            };
        /// Delta velocity (0x80,0x08).
        SensorDeltaVelocity(crate::sensor::DeltaVelocity):
            Data 0x08, of 1,
            "sensor.delta_velocity", "Delta velocity",
            [], {
                "delta_velocity": ["x" "y" "z"] in ["g*s"] of "vehicle";
            };
        /// Complementary filter orientation matrix (0x80,0x09).
        SensorCompOrientationMatrix(crate::sensor::CompOrientationMatrix):
            Data 0x09, of 1,
            "sensor.comp_orientation_matrix", "Complementary filter orientation matrix",
            [], {
                "m": ["m11" "m12" "m13" "m21" "m22" "m23" "m31" "m32" "m33"] in ["1"] of "ned";
            };
        /// Complementary filter quaternion (0x80,0x0A).
        SensorCompQuaternion(crate::sensor::CompQuaternion):
            Data 0x0A, of 1,
            "sensor.comp_quaternion", "Complementary filter quaternion",
            [], {
                "q": ["w" "x" "y" "z"] in ["1"] of "ned";
            };
        /// Complementary filter orientation update matrix (0x80,0x0B).
        SensorCompOrientationUpdateMatrix(crate::sensor::CompOrientationUpdateMatrix):
            Data 0x0B, of 1,
            "sensor.comp_orientation_update_matrix", "Complementary filter orientation update matrix",
            [], {
                "m": ["m11" "m12" "m13" "m21" "m22" "m23" "m31" "m32" "m33"] in ["1"];
            };
        /// Complementary filter Euler angles (0x80,0x0C).
        SensorCompEulerAngles(crate::sensor::CompEulerAngles):
            Data 0x0C, of 1,
            "sensor.comp_euler_angles", "Complementary filter Euler angles",
            [], {
                "roll" in ["rad"] of "ned";
                "pitch" in ["rad"] of "ned";
                "yaw" in ["rad"] of "ned";
            };
        /// Orientation raw temperatures (0x80,0x0D).
        SensorOrientationRawTemperature(crate::sensor::OrientationRawTemperature):
            Data 0x0D, of 1,
            "sensor.orientation_raw_temperature", "Orientation raw temperatures",
            [], {
                "raw_temperature" in ["1"];
            };
        /// Internal timestamp (0x80,0x0E).
        SensorInternalTimestamp(crate::sensor::InternalTimestamp):
            Data 0x0E, of 1,
            "sensor.internal_timestamp", "Internal timestamp",
            [], {
                "counts" in ["1"];
            };
        /// PPS timestamp (0x80,0x0F).
        SensorPpsTimestamp(crate::sensor::PpsTimestamp):
            Data 0x0F, of 2,
            "sensor.pps_timestamp", "PPS timestamp",
            [], {
                "seconds" in ["s"];
                "useconds" in ["us"];
            };
        /// PPS timestamp with flags (0x80,0x0F).
        SensorPpsTimestampWithFlags(crate::sensor::PpsTimestampWithFlags):
            Data 0x0F, of 2,
            "sensor.pps_timestamp_with_flags", "PPS timestamp with flags",
            [], {
                "flags";
                "seconds" in ["s"];
                "nanoseconds" in ["ns"];
            };
        /// Complementary filter stabilized north vector (0x80,0x10).
        SensorNorthVector(crate::sensor::NorthVector):
            Data 0x10, of 1,
            "sensor.north_vector", "Complementary filter stabilized north vector",
            [], {
                "stabilized_mag": ["x" "y" "z"] in ["gauss"] of "sensor";
            };
        /// Complementary filter stabilized up vector (0x80,0x11).
        SensorUpVector(crate::sensor::UpVector):
            Data 0x11, of 1,
            "sensor.up_vector", "Complementary filter stabilized up vector",
            [], {
                "stabilized_accel": ["x" "y" "z"] in ["g"] of "sensor";
            };
        /// GPS timestamp (0x80,0x12).
        SensorGpsTimestamp(crate::sensor::GpsTimestamp):
            Data 0x12, of 1,
            "sensor.gps_timestamp", "GPS timestamp",
            [], {
                "tow" in ["s"];
                "week_number" in ["week"];
                "valid_flags";
            };
        /// Temperature statistics (0x80,0x14).
        SensorTemperatureStatistics(crate::sensor::TemperatureStatistics):
            Data 0x14, of 1,
            "sensor.temperature_statistics", "Temperature statistics",
            [], {
                "min_temperature" in ["degC"];
                "max_temperature" in ["degC"];
                "mean_temperature" in ["degC"];
            };
        /// Raw pressure (0x80,0x16).
        SensorRawPressure(crate::sensor::RawPressure):
            Data 0x16, of 1,
            "sensor.raw_pressure", "Raw pressure",
            [], {
                "raw_pressure" in ["1"];
            };
        /// Scaled pressure (0x80,0x17).
        SensorScaledPressure(crate::sensor::ScaledPressure):
            Data 0x17, of 1,
            "sensor.scaled_pressure", "Scaled pressure",
            [], {
                "scaled_pressure" in ["mbar"];
            };
        /// Overrange status (0x80,0x18).
        SensorOverrangeStatus(crate::sensor::OverrangeStatus):
            Data 0x18, of 1,
            "sensor.overrange_status", "Overrange status",
            [], {
                "status";
            };
        /// Odometer data (0x80,0x40).
        SensorOdometer(crate::sensor::Odometer):
            Data 0x40, of 1,
            "sensor.odometer", "Odometer data",
            [], {
                "speed" in ["m/s"] of "vehicle";
                "uncertainty" in ["m/s"];
                "valid_flags";
            };
    }
    #[cfg(feature = "gnss_data")]
    0x81 | 0x91 | 0x92 | 0x93 | 0x94 | 0x95 => {
        /// GNSS LLH position (0x03).
        GnssDataLlhPosition(crate::gnss_data::LlhPosition):
            Data 0x03, of 1,
            "gnss_data.llh_position", "GNSS LLH position",
            {
                0x81 "gnss_data.llh_position",
                0x91 "gnss_1.llh_position",
                0x92 "gnss_2.llh_position",
                0x93 "gnss_corrections.llh_position",
                0x94 "gnss_external.llh_position",
                0x95 "gnss_external_2.llh_position",
            }
            [], {
                "latitude" in ["deg"] of "llh";
                "longitude" in ["deg"] of "llh";
                "ellipsoid_height" in ["m"] of "llh";
                "msl_height" in ["m"];
                "horizontal_accuracy" in ["m"];
                "vertical_accuracy" in ["m"];
                "valid_flags";
            };
        /// GNSS ECEF position (0x04).
        GnssDataEcefPosition(crate::gnss_data::EcefPosition):
            Data 0x04, of 1,
            "gnss_data.ecef_position", "GNSS ECEF position",
            {
                0x81 "gnss_data.ecef_position",
                0x91 "gnss_1.ecef_position",
                0x92 "gnss_2.ecef_position",
                0x93 "gnss_corrections.ecef_position",
                0x94 "gnss_external.ecef_position",
                0x95 "gnss_external_2.ecef_position",
            }
            [], {
                "position": ["x" "y" "z"] in ["m"] of "ecef";
                "position_accuracy" in ["m"];
                "valid_flags";
            };
        /// NED velocity (0x05).
        GnssDataNedVelocity(crate::gnss_data::NedVelocity):
            Data 0x05, of 1,
            "gnss_data.ned_velocity", "NED velocity",
            {
                0x81 "gnss_data.ned_velocity",
                0x91 "gnss_1.ned_velocity",
                0x92 "gnss_2.ned_velocity",
                0x93 "gnss_corrections.ned_velocity",
                0x94 "gnss_external.ned_velocity",
                0x95 "gnss_external_2.ned_velocity",
            }
            [], {
                "velocity": ["north" "east" "down"] in ["m/s"] of "ned";
                "speed" in ["m/s"];
                "ground_speed" in ["m/s"];
                "heading" in ["deg"] of "ned";
                "speed_accuracy" in ["m/s"];
                "heading_accuracy" in ["deg"];
                "valid_flags";
            };
        /// GNSS ECEF velocity (0x06).
        GnssDataEcefVelocity(crate::gnss_data::EcefVelocity):
            Data 0x06, of 1,
            "gnss_data.ecef_velocity", "GNSS ECEF velocity",
            {
                0x81 "gnss_data.ecef_velocity",
                0x91 "gnss_1.ecef_velocity",
                0x92 "gnss_2.ecef_velocity",
                0x93 "gnss_corrections.ecef_velocity",
                0x94 "gnss_external.ecef_velocity",
                0x95 "gnss_external_2.ecef_velocity",
            }
            [], {
                "velocity": ["x" "y" "z"] in ["m/s"] of "ecef";
                "velocity_accuracy" in ["m/s"];
                "valid_flags";
            };
        /// DOP (0x07).
        GnssDataDop(crate::gnss_data::Dop):
            Data 0x07, of 1,
            "gnss_data.dop", "DOP",
            {
                0x81 "gnss_data.dop",
                0x91 "gnss_1.dop",
                0x92 "gnss_2.dop",
                0x93 "gnss_corrections.dop",
                0x94 "gnss_external.dop",
                0x95 "gnss_external_2.dop",
            }
            [], {
                "gdop" in ["1"];
                "pdop" in ["1"];
                "hdop" in ["1"];
                "vdop" in ["1"];
                "tdop" in ["1"];
                "ndop" in ["1"];
                "edop" in ["1"];
                "valid_flags";
            };
        /// UTC time (0x08).
        GnssDataUtcTime(crate::gnss_data::UtcTime):
            Data 0x08, of 1,
            "gnss_data.utc_time", "UTC time",
            {
                0x81 "gnss_data.utc_time",
                0x91 "gnss_1.utc_time",
                0x92 "gnss_2.utc_time",
                0x93 "gnss_corrections.utc_time",
                0x94 "gnss_external.utc_time",
                0x95 "gnss_external_2.utc_time",
            }
            [], {
                "year";
                "month";
                "day";
                "hour";
                "min";
                "sec" in ["s"];
                "msec" in ["ms"];
                "valid_flags";
            };
        /// GPS time (0x09).
        GnssDataGpsTime(crate::gnss_data::GpsTime):
            Data 0x09, of 1,
            "gnss_data.gps_time", "GPS time",
            {
                0x81 "gnss_data.gps_time",
                0x91 "gnss_1.gps_time",
                0x92 "gnss_2.gps_time",
                0x93 "gnss_corrections.gps_time",
                0x94 "gnss_external.gps_time",
                0x95 "gnss_external_2.gps_time",
            }
            [], {
                "tow" in ["s"];
                "week_number" in ["week"];
                "valid_flags";
            };
        /// Clock info (0x0A).
        GnssDataClockInfo(crate::gnss_data::ClockInfo):
            Data 0x0A, of 1,
            "gnss_data.clock_info", "Clock info",
            {
                0x81 "gnss_data.clock_info",
                0x91 "gnss_1.clock_info",
                0x92 "gnss_2.clock_info",
                0x93 "gnss_corrections.clock_info",
                0x94 "gnss_external.clock_info",
                0x95 "gnss_external_2.clock_info",
            }
            [], {
                "bias" in ["s"];
                "drift" in ["s/s"];
                "accuracy_estimate" in ["s"];
                "valid_flags";
            };
        /// Fix info (0x0B).
        GnssDataFixInfo(crate::gnss_data::FixInfo):
            Data 0x0B, of 1,
            "gnss_data.fix_info", "Fix info",
            {
                0x81 "gnss_data.fix_info",
                0x91 "gnss_1.fix_info",
                0x92 "gnss_2.fix_info",
                0x93 "gnss_corrections.fix_info",
                0x94 "gnss_external.fix_info",
                0x95 "gnss_external_2.fix_info",
            }
            [], {
                "fix_type";
                "num_sv" in ["1"];
                "fix_flags";
                "valid_flags";
            };
        /// Satellite info (0x0C).
        GnssDataSvInfo(crate::gnss_data::SvInfo):
            Data 0x0C, of 1,
            "gnss_data.sv_info", "Satellite info",
            {
                0x81 "gnss_data.sv_info",
                0x91 "gnss_1.sv_info",
                0x92 "gnss_2.sv_info",
                0x93 "gnss_corrections.sv_info",
                0x94 "gnss_external.sv_info",
                0x95 "gnss_external_2.sv_info",
            }
            [], {
                "channel";
                "satellite_id";
                "carrier_noise_ratio" in ["dB-Hz"];
                "azimuth" in ["deg"] of "ned";
                "elevation" in ["deg"] of "ned";
                "sv_flags";
                "valid_flags";
            };
        /// GNSS hardware status (0x0D).
        GnssDataHardwareStatus(crate::gnss_data::HardwareStatus):
            Data 0x0D, of 1,
            "gnss_data.hardware_status", "GNSS hardware status",
            {
                0x81 "gnss_data.hardware_status",
                0x91 "gnss_1.hardware_status",
                0x92 "gnss_2.hardware_status",
                0x93 "gnss_corrections.hardware_status",
                0x94 "gnss_external.hardware_status",
                0x95 "gnss_external_2.hardware_status",
            }
            [], {
                "receiver_state";
                "antenna_state";
                "antenna_power";
                "valid_flags";
            };
        /// DGPS info (0x0E).
        GnssDataDgpsInfo(crate::gnss_data::DgpsInfo):
            Data 0x0E, of 2,
            "gnss_data.dgps_info", "DGPS info",
            {
                0x81 "gnss_data.dgps_info",
                0x91 "gnss_1.dgps_info",
                0x92 "gnss_2.dgps_info",
                0x93 "gnss_corrections.dgps_info",
                0x94 "gnss_external.dgps_info",
                0x95 "gnss_external_2.dgps_info",
            }
            [], {
                "age" in ["s"];
                "base_station_id";
                "base_station_status";
                "num_channels" in ["1"];
                "valid_flags";
            };
        /// DGPS info for one satellite (0x0E).
        GnssDataDgpsInfoSatellite(crate::gnss_data::DgpsInfoSatellite):
            Data 0x0E, of 2,
            "gnss_data.dgps_info_satellite", "DGPS info for one satellite",
            {
                0x81 "gnss_data.dgps_info_satellite",
                0x91 "gnss_1.dgps_info_satellite",
                0x92 "gnss_2.dgps_info_satellite",
                0x93 "gnss_corrections.dgps_info_satellite",
                0x94 "gnss_external.dgps_info_satellite",
                0x95 "gnss_external_2.dgps_info_satellite",
            }
            [], {
                "satellite_id";
                "age" in ["s"];
                "range_correction" in ["m"];
                "range_rate_correction" in ["m/s"];
                "valid_flags";
            };
        /// DGPS channel (0x0F).
        GnssDataDgpsChannel(crate::gnss_data::DgpsChannel):
            Data 0x0F, of 1,
            "gnss_data.dgps_channel", "DGPS channel",
            {
                0x81 "gnss_data.dgps_channel",
                0x91 "gnss_1.dgps_channel",
                0x92 "gnss_2.dgps_channel",
                0x93 "gnss_corrections.dgps_channel",
                0x94 "gnss_external.dgps_channel",
                0x95 "gnss_external_2.dgps_channel",
            }
            [], {
                "satellite_id";
                "age" in ["s"];
                "range_correction" in ["m"];
                "range_rate_correction" in ["m/s"];
                "valid_flags";
            };
        /// Clock info 2 (0x10).
        GnssDataClockInfo2(crate::gnss_data::ClockInfo2):
            Data 0x10, of 1,
            "gnss_data.clock_info_2", "Clock info 2",
            {
                0x81 "gnss_data.clock_info_2",
                0x91 "gnss_1.clock_info_2",
                0x92 "gnss_2.clock_info_2",
                0x93 "gnss_corrections.clock_info_2",
                0x94 "gnss_external.clock_info_2",
                0x95 "gnss_external_2.clock_info_2",
            }
            [], {
                "bias" in ["s"];
                "drift" in ["s/s"];
                "bias_accuracy_estimate" in ["s"];
                "drift_accuracy_estimate" in ["s/s"];
                "valid_flags";
            };
        /// GPS leap seconds (0x11).
        GnssDataGpsLeapSeconds(crate::gnss_data::GpsLeapSeconds):
            Data 0x11, of 1,
            "gnss_data.gps_leap_seconds", "GPS leap seconds",
            {
                0x81 "gnss_data.gps_leap_seconds",
                0x91 "gnss_1.gps_leap_seconds",
                0x92 "gnss_2.gps_leap_seconds",
                0x93 "gnss_corrections.gps_leap_seconds",
                0x94 "gnss_external.gps_leap_seconds",
                0x95 "gnss_external_2.gps_leap_seconds",
            }
            [], {
                "leap_seconds" in ["s"];
                "valid_flags";
            };
        /// SBAS info (0x12).
        GnssDataSbasInfo(crate::gnss_data::SbasInfo):
            Data 0x12, of 1,
            "gnss_data.sbas_info", "SBAS info",
            {
                0x81 "gnss_data.sbas_info",
                0x91 "gnss_1.sbas_info",
                0x92 "gnss_2.sbas_info",
                0x93 "gnss_corrections.sbas_info",
                0x94 "gnss_external.sbas_info",
                0x95 "gnss_external_2.sbas_info",
            }
            [], {
                "tow" in ["s"];
                "week_number" in ["week"];
                "sbas_system";
                "sbas_id";
                "count" in ["1"];
                "sbas_status";
                "valid_flags";
            };
        /// SBAS correction (0x13).
        GnssDataSbasCorrection(crate::gnss_data::SbasCorrection):
            Data 0x13, of 1,
            "gnss_data.sbas_correction", "SBAS correction",
            {
                0x81 "gnss_data.sbas_correction",
                0x91 "gnss_1.sbas_correction",
                0x92 "gnss_2.sbas_correction",
                0x93 "gnss_corrections.sbas_correction",
                0x94 "gnss_external.sbas_correction",
                0x95 "gnss_external_2.sbas_correction",
            }
            [], {
                "index";
                "count";
                "tow" in ["s"];
                "week_number" in ["week"];
                "gnss_id";
                "satellite_id";
                "udrei";
                "pseudorange_correction" in ["m"];
                "iono_correction" in ["m"];
                "valid_flags";
            };
        /// RF error detection (0x14).
        GnssDataRfErrorDetection(crate::gnss_data::RfErrorDetection):
            Data 0x14, of 1,
            "gnss_data.rf_error_detection", "RF error detection",
            {
                0x81 "gnss_data.rf_error_detection",
                0x91 "gnss_1.rf_error_detection",
                0x92 "gnss_2.rf_error_detection",
                0x93 "gnss_corrections.rf_error_detection",
                0x94 "gnss_external.rf_error_detection",
                0x95 "gnss_external_2.rf_error_detection",
            }
            [], {
                "rf_band";
                "jamming_state";
                "spoofing_state";
                "frequency" in ["MHz"];
                "reserved";
                "valid_flags";
            };
        /// GNSS heading (0x15).
        GnssDataHeading(crate::gnss_data::Heading):
            Data 0x15, of 1,
            "gnss_data.heading", "GNSS heading",
            {
                0x81 "gnss_data.heading",
                0x91 "gnss_1.heading",
                0x92 "gnss_2.heading",
                0x93 "gnss_corrections.heading",
                0x94 "gnss_external.heading",
                0x95 "gnss_external_2.heading",
            }
            [], {
                "heading" in ["deg"] of "ned";
                "uncertainty" in ["deg"];
                "fix_type";
                "valid_flags";
            };
        /// Satellite status (0x20).
        GnssDataSatelliteStatus(crate::gnss_data::SatelliteStatus):
            Data 0x20, of 1,
            "gnss_data.satellite_status", "Satellite status",
            {
                0x81 "gnss_data.satellite_status",
                0x91 "gnss_1.satellite_status",
                0x92 "gnss_2.satellite_status",
                0x93 "gnss_corrections.satellite_status",
                0x94 "gnss_external.satellite_status",
                0x95 "gnss_external_2.satellite_status",
            }
            [], {
                "index";
                "count";
                "tow" in ["s"];
                "week_number" in ["week"];
                "gnss_id";
                "satellite_id";
                "elevation" in ["deg"] of "ned";
                "azimuth" in ["deg"] of "ned";
                "health";
                "valid_flags";
            };
        /// Raw (0x22).
        GnssDataRaw(crate::gnss_data::Raw):
            Data 0x22, of 1,
            "gnss_data.raw", "Raw",
            {
                0x81 "gnss_data.raw",
                0x91 "gnss_1.raw",
                0x92 "gnss_2.raw",
                0x93 "gnss_corrections.raw",
                0x94 "gnss_external.raw",
                0x95 "gnss_external_2.raw",
            }
            [], {
                "index";
                "count";
                "tow" in ["s"];
                "week_number" in ["week"];
                "receiver_id";
                "tracking_channel";
                "gnss_id";
                "satellite_id";
                "signal_id";
                "signal_strength" in ["dB-Hz"];
                "quality";
                "pseudorange" in ["m"];
                "carrier_phase" in ["cycle"];
                "doppler" in ["Hz"];
                "range_uncertainty" in ["m"];
                "phase_uncertainty" in ["cycle"];
                "doppler_uncertainty" in ["Hz"];
                "lock_time" in ["s"];
                "valid_flags";
            };
        /// Base station info (0x30).
        GnssDataBaseStationInfo(crate::gnss_data::BaseStationInfo):
            Data 0x30, of 1,
            "gnss_data.base_station_info", "Base station info",
            {
                0x81 "gnss_data.base_station_info",
                0x91 "gnss_1.base_station_info",
                0x92 "gnss_2.base_station_info",
                0x93 "gnss_corrections.base_station_info",
                0x94 "gnss_external.base_station_info",
                0x95 "gnss_external_2.base_station_info",
            }
            [], {
                "tow" in ["s"];
                "week_number" in ["week"];
                "ecef_position": ["x" "y" "z"] in ["m"] of "ecef";
                "height" in ["m"];
                "station_id";
                "indicators";
                "valid_flags";
            };
        /// RTK corrections status (0x31).
        GnssDataRtkCorrectionsStatus(crate::gnss_data::RtkCorrectionsStatus):
            Data 0x31, of 1,
            "gnss_data.rtk_corrections_status", "RTK corrections status",
            {
                0x81 "gnss_data.rtk_corrections_status",
                0x91 "gnss_1.rtk_corrections_status",
                0x92 "gnss_2.rtk_corrections_status",
                0x93 "gnss_corrections.rtk_corrections_status",
                0x94 "gnss_external.rtk_corrections_status",
                0x95 "gnss_external_2.rtk_corrections_status",
            }
            [], {
                "tow" in ["s"];
                "week_number" in ["week"];
                "epoch_status";
                "dongle_status";
                "gps_correction_latency" in ["s"];
                "glonass_correction_latency" in ["s"];
                "galileo_correction_latency" in ["s"];
                "beidou_correction_latency" in ["s"];
                "reserved";
                "valid_flags";
            };
        /// GPS ephemeris (0x61).
        GnssDataGpsEphemeris(crate::gnss_data::GpsEphemeris):
            Data 0x61, of 1,
            "gnss_data.gps_ephemeris", "GPS ephemeris",
            {
                0x81 "gnss_data.gps_ephemeris",
                0x91 "gnss_1.gps_ephemeris",
                0x92 "gnss_2.gps_ephemeris",
                0x93 "gnss_corrections.gps_ephemeris",
                0x94 "gnss_external.gps_ephemeris",
                0x95 "gnss_external_2.gps_ephemeris",
            }
            [], {
                "index";
                "count";
                "tow" in ["s"];
                "week_number" in ["week"];
                "satellite_id";
                "health";
                "iodc";
                "iode";
                "t_oc" in ["s"];
                "af0" in ["s"];
                "af1" in ["s/s"];
                "af2" in ["s/s^2"];
                "t_gd" in ["s"];
                "isc_l1ca" in ["s"];
                "isc_l2c" in ["s"];
                "t_oe" in ["s"];
                "a" in ["m"];
                "a_dot" in ["m/s"];
                "mean_anomaly" in ["rad"];
                "delta_mean_motion" in ["rad/s"];
                "delta_mean_motion_dot" in ["rad/s^2"];
                "eccentricity" in ["1"];
                "argument_of_perigee" in ["rad"];
                "omega" in ["rad"];
                "omega_dot" in ["rad/s"];
                "inclination" in ["rad"];
                "inclination_dot" in ["rad/s"];
                "c_ic" in ["rad"];
                "c_is" in ["rad"];
                "c_uc" in ["rad"];
                "c_us" in ["rad"];
                "c_rc" in ["m"];
                "c_rs" in ["m"];
                "valid_flags";
            };
        /// GLONASS ephemeris (0x62).
        GnssDataGlonassEphemeris(crate::gnss_data::GlonassEphemeris):
            Data 0x62, of 1,
            "gnss_data.glonass_ephemeris", "GLONASS ephemeris",
            {
                0x81 "gnss_data.glonass_ephemeris",
                0x91 "gnss_1.glonass_ephemeris",
                0x92 "gnss_2.glonass_ephemeris",
                0x93 "gnss_corrections.glonass_ephemeris",
                0x94 "gnss_external.glonass_ephemeris",
                0x95 "gnss_external_2.glonass_ephemeris",
            }
            [], {
                "index";
                "count";
                "tow" in ["s"];
                "week_number" in ["week"];
                "satellite_id";
                "frequency_number";
                "tk" in ["s"];
                "tb" in ["s"];
                "satellite_type";
                "gamma" in ["1"];
                "tau_n" in ["s"];
                "position": ["x" "y" "z"] in ["m"];
                "velocity": ["x" "y" "z"] in ["m/s"];
                "accel": ["x" "y" "z"] in ["m/s^2"];
                "health";
                "p";
                "nt" in ["day"];
                "delta_tau_n" in ["s"];
                "ft";
                "en" in ["day"];
                "p1" in ["min"];
                "p2";
                "p3" in ["1"];
                "p4";
                "valid_flags";
            };
        /// Galileo ephemeris (0x63).
        GnssDataGalileoEphemeris(crate::gnss_data::GalileoEphemeris):
            Data 0x63, of 1,
            "gnss_data.galileo_ephemeris", "Galileo ephemeris",
            {
                0x81 "gnss_data.galileo_ephemeris",
                0x91 "gnss_1.galileo_ephemeris",
                0x92 "gnss_2.galileo_ephemeris",
                0x93 "gnss_corrections.galileo_ephemeris",
                0x94 "gnss_external.galileo_ephemeris",
                0x95 "gnss_external_2.galileo_ephemeris",
            }
            [], {
                "index";
                "count";
                "tow" in ["s"];
                "week_number" in ["week"];
                "satellite_id";
                "health";
                "iodc";
                "iode";
                "t_oc" in ["s"];
                "af0" in ["s"];
                "af1" in ["s/s"];
                "af2" in ["s/s^2"];
                "t_gd" in ["s"];
                "isc_l1ca" in ["s"];
                "isc_l2c" in ["s"];
                "t_oe" in ["s"];
                "a" in ["m"];
                "a_dot" in ["m/s"];
                "mean_anomaly" in ["rad"];
                "delta_mean_motion" in ["rad/s"];
                "delta_mean_motion_dot" in ["rad/s^2"];
                "eccentricity" in ["1"];
                "argument_of_perigee" in ["rad"];
                "omega" in ["rad"];
                "omega_dot" in ["rad/s"];
                "inclination" in ["rad"];
                "inclination_dot" in ["rad/s"];
                "c_ic" in ["rad"];
                "c_is" in ["rad"];
                "c_uc" in ["rad"];
                "c_us" in ["rad"];
                "c_rc" in ["m"];
                "c_rs" in ["m"];
                "valid_flags";
            };
        /// BeiDou ephemeris (0x64).
        GnssDataBeidouEphemeris(crate::gnss_data::BeidouEphemeris):
            Data 0x64, of 1,
            "gnss_data.beidou_ephemeris", "BeiDou ephemeris",
            {
                0x81 "gnss_data.beidou_ephemeris",
                0x91 "gnss_1.beidou_ephemeris",
                0x92 "gnss_2.beidou_ephemeris",
                0x93 "gnss_corrections.beidou_ephemeris",
                0x94 "gnss_external.beidou_ephemeris",
                0x95 "gnss_external_2.beidou_ephemeris",
            }
            [], {
                "index";
                "count";
                "tow" in ["s"];
                "week_number" in ["week"];
                "satellite_id";
                "health";
                "iodc";
                "iode";
                "t_oc" in ["s"];
                "af0" in ["s"];
                "af1" in ["s/s"];
                "af2" in ["s/s^2"];
                "t_gd" in ["s"];
                "isc_l1ca" in ["s"];
                "isc_l2c" in ["s"];
                "t_oe" in ["s"];
                "a" in ["m"];
                "a_dot" in ["m/s"];
                "mean_anomaly" in ["rad"];
                "delta_mean_motion" in ["rad/s"];
                "delta_mean_motion_dot" in ["rad/s^2"];
                "eccentricity" in ["1"];
                "argument_of_perigee" in ["rad"];
                "omega" in ["rad"];
                "omega_dot" in ["rad/s"];
                "inclination" in ["rad"];
                "inclination_dot" in ["rad/s"];
                "c_ic" in ["rad"];
                "c_is" in ["rad"];
                "c_uc" in ["rad"];
                "c_us" in ["rad"];
                "c_rc" in ["m"];
                "c_rs" in ["m"];
                "valid_flags";
            };
        /// GPS ionospheric correction (0x71).
        GnssDataGpsIonoCorrection(crate::gnss_data::GpsIonoCorrection):
            Data 0x71, of 1,
            "gnss_data.gps_iono_correction", "GPS ionospheric correction",
            {
                0x81 "gnss_data.gps_iono_correction",
                0x91 "gnss_1.gps_iono_correction",
                0x92 "gnss_2.gps_iono_correction",
                0x93 "gnss_corrections.gps_iono_correction",
                0x94 "gnss_external.gps_iono_correction",
                0x95 "gnss_external_2.gps_iono_correction",
            }
            [], {
                "tow" in ["s"];
                "week_number" in ["week"];
                "alpha";
                "beta";
                "valid_flags";
            };
        /// Galileo ionospheric correction (0x73).
        GnssDataGalileoIonoCorrection(crate::gnss_data::GalileoIonoCorrection):
            Data 0x73, of 1,
            "gnss_data.galileo_iono_correction", "Galileo ionospheric correction",
            {
                0x81 "gnss_data.galileo_iono_correction",
                0x91 "gnss_1.galileo_iono_correction",
                0x92 "gnss_2.galileo_iono_correction",
                0x93 "gnss_corrections.galileo_iono_correction",
                0x94 "gnss_external.galileo_iono_correction",
                0x95 "gnss_external_2.galileo_iono_correction",
            }
            [], {
                "tow" in ["s"];
                "week_number" in ["week"];
                "alpha";
                "disturbance_flags";
                "valid_flags";
            };
        /// BeiDou ionospheric correction (0x74).
        GnssDataBeidouIonoCorrection(crate::gnss_data::BeidouIonoCorrection):
            Data 0x74, of 1,
            "gnss_data.beidou_iono_correction", "BeiDou ionospheric correction",
            {
                0x81 "gnss_data.beidou_iono_correction",
                0x91 "gnss_1.beidou_iono_correction",
                0x92 "gnss_2.beidou_iono_correction",
                0x93 "gnss_corrections.beidou_iono_correction",
                0x94 "gnss_external.beidou_iono_correction",
                0x95 "gnss_external_2.beidou_iono_correction",
            }
            [], {
                "tow" in ["s"];
                "week_number" in ["week"];
                "alpha";
                "beta";
                "alpha_correction";
                "valid_flags";
            };
    }
    #[cfg(feature = "filter_data")]
    0x82 => {
        /// LLH position (0x82,0x01).
        FilterDataLlhPosition(crate::filter_data::LlhPosition):
            Data 0x01, of 1,
            "filter_data.llh_position", "LLH position",
            [], {
                "latitude" in ["deg"] of "llh";
                "longitude" in ["deg"] of "llh";
                "ellipsoid_height" in ["m"] of "llh";
                "valid_flags";
            };
        /// NED velocity (0x82,0x02).
        FilterDataNedVelocity(crate::filter_data::NedVelocity):
            Data 0x02, of 1,
            "filter_data.ned_velocity", "NED velocity",
            [], {
                "north" in ["m/s"] of "ned";
                "east" in ["m/s"] of "ned";
                "down" in ["m/s"] of "ned";
                "valid_flags";
            };
        /// Attitude quaternion (0x82,0x03).
        FilterDataAttitudeQuaternion(crate::filter_data::AttitudeQuaternion):
            Data 0x03, of 1,
            "filter_data.attitude_quaternion", "Attitude quaternion",
            [], {
                "q": ["w" "x" "y" "z"] in ["1"] of "ned";
                "valid_flags";
            };
        /// Attitude direction cosine matrix (0x82,0x04).
        FilterDataAttitudeDcm(crate::filter_data::AttitudeDcm):
            Data 0x04, of 1,
            "filter_data.attitude_dcm", "Attitude direction cosine matrix",
            [], {
                "dcm": ["m11" "m12" "m13" "m21" "m22" "m23" "m31" "m32" "m33"] in ["1"] of "ned";
                "valid_flags";
            };
        /// Euler angles (0x82,0x05).
        FilterDataEulerAngles(crate::filter_data::EulerAngles):
            Data 0x05, of 1,
            "filter_data.euler_angles", "Euler angles",
            [], {
                "roll" in ["rad"] of "ned";
                "pitch" in ["rad"] of "ned";
                "yaw" in ["rad"] of "ned";
                "valid_flags";
            };
        /// Gyroscope bias (0x82,0x06).
        FilterDataGyroBias(crate::filter_data::GyroBias):
            Data 0x06, of 1,
            "filter_data.gyro_bias", "Gyroscope bias",
            [], {
                "bias": ["x" "y" "z"] in ["rad/s"] of "sensor";
                "valid_flags";
            };
        /// Accelerometer bias (0x82,0x07).
        FilterDataAccelBias(crate::filter_data::AccelBias):
            Data 0x07, of 1,
            "filter_data.accel_bias", "Accelerometer bias",
            [], {
                "bias": ["x" "y" "z"] in ["m/s^2"] of "sensor";
                "valid_flags";
            };
        /// Position uncertainty (0x82,0x08).
        FilterDataLlhPositionUncertainty(crate::filter_data::LlhPositionUncertainty):
            Data 0x08, of 1,
            "filter_data.llh_position_uncertainty", "Position uncertainty",
            [], {
                "north" in ["m"] of "ned";
                "east" in ["m"] of "ned";
                "down" in ["m"] of "ned";
                "valid_flags";
            };
        /// NED velocity uncertainty (0x82,0x09).
        FilterDataNedVelocityUncertainty(crate::filter_data::NedVelocityUncertainty):
            Data 0x09, of 1,
            "filter_data.ned_velocity_uncertainty", "NED velocity uncertainty",
            [], {
                "north" in ["m/s"] of "ned";
                "east" in ["m/s"] of "ned";
                "down" in ["m/s"] of "ned";
                "valid_flags";
            };
        /// Euler angles uncertainty (0x82,0x0A).
        FilterDataEulerAnglesUncertainty(crate::filter_data::EulerAnglesUncertainty):
            Data 0x0A, of 1,
            "filter_data.euler_angles_uncertainty", "Euler angles uncertainty",
            [], {
                "roll" in ["rad"];
                "pitch" in ["rad"];
                "yaw" in ["rad"];
                "valid_flags";
            };
        /// Gyroscope bias uncertainty (0x82,0x0B).
        FilterDataGyroBiasUncertainty(crate::filter_data::GyroBiasUncertainty):
            Data 0x0B, of 1,
            "filter_data.gyro_bias_uncertainty", "Gyroscope bias uncertainty",
            [], {
                "bias_uncertainty": ["x" "y" "z"] in ["rad/s"] of "sensor";
                "valid_flags";
            };
        /// Accelerometer bias uncertainty (0x82,0x0C).
        FilterDataAccelBiasUncertainty(crate::filter_data::AccelBiasUncertainty):
            Data 0x0C, of 1,
            "filter_data.accel_bias_uncertainty", "Accelerometer bias uncertainty",
            [], {
                "bias_uncertainty": ["x" "y" "z"] in ["m/s^2"] of "sensor";
                "valid_flags";
            };
        /// Linear acceleration (0x82,0x0D).
        FilterDataLinearAccel(crate::filter_data::LinearAccel):
            Data 0x0D, of 1,
            "filter_data.linear_accel", "Linear acceleration",
            [], {
                "accel": ["x" "y" "z"] in ["m/s^2"] of "vehicle";
                "valid_flags";
            };
        /// Compensated angular rate (0x82,0x0E).
        FilterDataCompAngularRate(crate::filter_data::CompAngularRate):
            Data 0x0E, of 1,
            "filter_data.comp_angular_rate", "Compensated angular rate",
            [], {
                "gyro": ["x" "y" "z"] in ["rad/s"] of "vehicle";
                "valid_flags";
            };
        /// WGS84 local gravity magnitude (0x82,0x0F).
        FilterDataWgs84GravityMagnitude(crate::filter_data::Wgs84GravityMagnitude):
            Data 0x0F, of 1,
            "filter_data.wgs84_gravity_magnitude", "WGS84 local gravity magnitude",
            [], {
                "gravity_magnitude" in ["m/s^2"];
                "valid_flags";
            };
        /// Filter status (0x82,0x10).
        FilterDataStatus(crate::filter_data::Status):
            Data 0x10, of 1,
            "filter_data.status", "Filter status",
            [], {
                "filter_state";
                "dynamics_mode";
                "status_flags";
            };
        /// Filter timestamp (0x82,0x11).
        FilterDataTimestamp(crate::filter_data::Timestamp):
            Data 0x11, of 1,
            "filter_data.timestamp", "Filter timestamp",
            [], {
                "tow" in ["s"];
                "week_number" in ["week"];
                "valid_flags";
            };
        /// Quaternion uncertainty (0x82,0x12).
        FilterDataQuaternionAttitudeUncertainty(crate::filter_data::QuaternionAttitudeUncertainty):
            Data 0x12, of 1,
            "filter_data.quaternion_attitude_uncertainty", "Quaternion uncertainty",
            [], {
                "q": ["w" "x" "y" "z"] in ["1"];
                "valid_flags";
            };
        /// Gravity vector (0x82,0x13).
        FilterDataGravityVector(crate::filter_data::GravityVector):
            Data 0x13, of 1,
            "filter_data.gravity_vector", "Gravity vector",
            [], {
                "gravity": ["x" "y" "z"] in ["m/s^2"] of "vehicle";
                "valid_flags";
            };
        /// Heading update source state (0x82,0x14).
        FilterDataHeadingUpdateState(crate::filter_data::HeadingUpdateState):
            Data 0x14, of 1,
            "filter_data.heading_update_state", "Heading update source state",
            [], {
                "heading" in ["rad"] of "ned";
                "heading_uncertainty" in ["rad"];
                "source";
                "valid_flags";
            };
        /// Magnetic model (0x82,0x15).
        FilterDataMagneticModel(crate::filter_data::MagneticModel):
            Data 0x15, of 1,
            "filter_data.magnetic_model", "Magnetic model",
            [], {
                "intensity_north" in ["gauss"] of "ned";
                "intensity_east" in ["gauss"] of "ned";
                "intensity_down" in ["gauss"] of "ned";
                "inclination" in ["rad"] of "ned";
                "declination" in ["rad"] of "ned";
                "valid_flags";
            };
        /// Gyroscope scale factor (0x82,0x16).
        FilterDataGyroScaleFactor(crate::filter_data::GyroScaleFactor):
            Data 0x16, of 1,
            "filter_data.gyro_scale_factor", "Gyroscope scale factor",
            [], {
                "scale_factor": ["x" "y" "z"] in ["1"] of "sensor";
                "valid_flags";
            };
        /// Accelerometer scale factor (0x82,0x17).
        FilterDataAccelScaleFactor(crate::filter_data::AccelScaleFactor):
            Data 0x17, of 1,
            "filter_data.accel_scale_factor", "Accelerometer scale factor",
            [], {
                "scale_factor": ["x" "y" "z"] in ["1"] of "sensor";
                "valid_flags";
            };
        /// Gyroscope scale factor uncertainty (0x82,0x18).
        FilterDataGyroScaleFactorUncertainty(crate::filter_data::GyroScaleFactorUncertainty):
            Data 0x18, of 1,
            "filter_data.gyro_scale_factor_uncertainty", "Gyroscope scale factor uncertainty",
            [], {
                "scale_factor_uncertainty": ["x" "y" "z"] in ["1"] of "sensor";
                "valid_flags";
            };
        /// Accelerometer scale factor uncertainty (0x82,0x19).
        FilterDataAccelScaleFactorUncertainty(crate::filter_data::AccelScaleFactorUncertainty):
            Data 0x19, of 1,
            "filter_data.accel_scale_factor_uncertainty", "Accelerometer scale factor uncertainty",
            [], {
                "scale_factor_uncertainty": ["x" "y" "z"] in ["1"] of "sensor";
                "valid_flags";
            };
        /// Magnetometer bias (0x82,0x1A).
        FilterDataMagBias(crate::filter_data::MagBias):
            Data 0x1A, of 1,
            "filter_data.mag_bias", "Magnetometer bias",
            [], {
                "bias": ["x" "y" "z"] in ["gauss"] of "sensor";
                "valid_flags";
            };
        /// Magnetometer bias uncertainty (0x82,0x1B).
        FilterDataMagBiasUncertainty(crate::filter_data::MagBiasUncertainty):
            Data 0x1B, of 1,
            "filter_data.mag_bias_uncertainty", "Magnetometer bias uncertainty",
            [], {
                "bias_uncertainty": ["x" "y" "z"] in ["gauss"] of "sensor";
                "valid_flags";
            };
        /// Compensated acceleration (0x82,0x1C).
        FilterDataCompAccel(crate::filter_data::CompAccel):
            Data 0x1C, of 1,
            "filter_data.comp_accel", "Compensated acceleration",
            [], {
                "accel": ["x" "y" "z"] in ["m/s^2"] of "vehicle";
                "valid_flags";
            };
        /// Standard atmosphere (0x82,0x20).
        FilterDataStandardAtmosphere(crate::filter_data::StandardAtmosphere):
            Data 0x20, of 1,
            "filter_data.standard_atmosphere", "Standard atmosphere",
            [], {
                "geometric_altitude" in ["m"];
                "geopotential_altitude" in ["m"];
                "standard_temperature" in ["degC"];
                "standard_pressure" in ["mbar"];
                "standard_density" in ["kg/m^3"];
                "valid_flags";
            };
        /// Pressure altitude (0x82,0x21).
        FilterDataPressureAltitude(crate::filter_data::PressureAltitude):
            Data 0x21, of 1,
            "filter_data.pressure_altitude", "Pressure altitude",
            [], {
                "pressure_altitude" in ["m"];
                "valid_flags";
            };
        /// Density altitude (0x82,0x22).
        FilterDataDensityAltitude(crate::filter_data::DensityAltitude):
            Data 0x22, of 1,
            "filter_data.density_altitude", "Density altitude",
            [], {
                "density_altitude" in ["m"];
                "valid_flags";
            };
        /// Magnetometer offset (0x82,0x25).
        FilterDataMagOffset(crate::filter_data::MagOffset):
            Data 0x25, of 1,
            "filter_data.mag_offset", "Magnetometer offset",
            [], {
                "hard_iron": ["x" "y" "z"] in ["gauss"] of "sensor";
                "valid_flags";
            };
        /// Magnetometer matrix (0x82,0x26).
        FilterDataMagMatrix(crate::filter_data::MagMatrix):
            Data 0x26, of 1,
            "filter_data.mag_matrix", "Magnetometer matrix",
            [], {
                "soft_iron": ["m11" "m12" "m13" "m21" "m22" "m23" "m31" "m32" "m33"] in ["1"] of "sensor";
                "valid_flags";
            };
        /// Magnetometer offset uncertainty (0x82,0x28).
        FilterDataMagOffsetUncertainty(crate::filter_data::MagOffsetUncertainty):
            Data 0x28, of 1,
            "filter_data.mag_offset_uncertainty", "Magnetometer offset uncertainty",
            [], {
                "hard_iron_uncertainty": ["x" "y" "z"] in ["gauss"] of "sensor";
                "valid_flags";
            };
        /// Magnetometer matrix uncertainty (0x82,0x29).
        FilterDataMagMatrixUncertainty(crate::filter_data::MagMatrixUncertainty):
            Data 0x29, of 1,
            "filter_data.mag_matrix_uncertainty", "Magnetometer matrix uncertainty",
            [], {
                "soft_iron_uncertainty": ["m11" "m12" "m13" "m21" "m22" "m23" "m31" "m32" "m33"] in ["1"] of "sensor";
                "valid_flags";
            };
        /// Magnetometer covariance matrix (0x82,0x2A).
        FilterDataMagCovarianceMatrix(crate::filter_data::MagCovarianceMatrix):
            Data 0x2A, of 1,
            "filter_data.mag_covariance_matrix", "Magnetometer covariance matrix",
            [], {
                "covariance": ["m11" "m12" "m13" "m21" "m22" "m23" "m31" "m32" "m33"];
                "valid_flags";
            };
        /// Magnetometer residual vector (0x82,0x2C).
        FilterDataMagResidualVector(crate::filter_data::MagResidualVector):
            Data 0x2C, of 1,
            "filter_data.mag_residual_vector", "Magnetometer residual vector",
            [], {
                "residual": ["x" "y" "z"] in ["gauss"] of "vehicle";
                "valid_flags";
            };
        /// Antenna offset correction (0x82,0x30).
        FilterDataAntennaOffsetCorrection(crate::filter_data::AntennaOffsetCorrection):
            Data 0x30, of 1,
            "filter_data.antenna_offset_correction", "Antenna offset correction",
            [], {
                "offset": ["x" "y" "z"] in ["m"] of "vehicle";
                "valid_flags";
            };
        /// Antenna offset correction uncertainty (0x82,0x31).
        FilterDataAntennaOffsetCorrectionUncertainty(crate::filter_data::AntennaOffsetCorrectionUncertainty):
            Data 0x31, of 1,
            "filter_data.antenna_offset_correction_uncertainty", "Antenna offset correction uncertainty",
            [], {
                "offset_uncertainty": ["x" "y" "z"] in ["m"] of "vehicle";
                "valid_flags";
            };
        /// Clock correction (0x82,0x32).
        FilterDataClockCorrection(crate::filter_data::ClockCorrection):
            Data 0x32, of 1,
            "filter_data.clock_correction", "Clock correction",
            [], {
                "receiver_id";
                "bias" in ["s"];
                "bias_drift" in ["s/s"];
                "valid_flags";
            };
        /// Clock correction uncertainty (0x82,0x33).
        FilterDataClockCorrectionUncertainty(crate::filter_data::ClockCorrectionUncertainty):
            Data 0x33, of 1,
            "filter_data.clock_correction_uncertainty", "Clock correction uncertainty",
            [], {
                "receiver_id";
                "bias_uncertainty" in ["s"];
                "bias_drift_uncertainty" in ["s/s"];
                "valid_flags";
            };
        /// Multi-antenna offset correction (0x82,0x34).
        FilterDataMultiAntennaOffsetCorrection(crate::filter_data::MultiAntennaOffsetCorrection):
            Data 0x34, of 1,
            "filter_data.multi_antenna_offset_correction", "Multi-antenna offset correction",
            [], {
                "receiver_id";
                "offset": ["x" "y" "z"] in ["m"] of "vehicle";
                "valid_flags";
            };
        /// Multi-antenna offset correction uncertainty (0x82,0x35).
        FilterDataMultiAntennaOffsetCorrectionUncertainty(crate::filter_data::MultiAntennaOffsetCorrectionUncertainty):
            Data 0x35, of 1,
            "filter_data.multi_antenna_offset_correction_uncertainty", "Multi-antenna offset correction uncertainty",
            [], {
                "receiver_id";
                "offset_uncertainty": ["x" "y" "z"] in ["m"] of "vehicle";
                "valid_flags";
            };
        /// ECEF position uncertainty (0x82,0x36).
        FilterDataEcefPositionUncertainty(crate::filter_data::EcefPositionUncertainty):
            Data 0x36, of 1,
            "filter_data.ecef_position_uncertainty", "ECEF position uncertainty",
            [], {
                "position_uncertainty": ["x" "y" "z"] in ["m"] of "ecef";
                "valid_flags";
            };
        /// ECEF velocity uncertainty (0x82,0x37).
        FilterDataEcefVelocityUncertainty(crate::filter_data::EcefVelocityUncertainty):
            Data 0x37, of 1,
            "filter_data.ecef_velocity_uncertainty", "ECEF velocity uncertainty",
            [], {
                "velocity_uncertainty": ["x" "y" "z"] in ["m/s"] of "ecef";
                "valid_flags";
            };
        /// ECEF position (0x82,0x40).
        FilterDataEcefPosition(crate::filter_data::EcefPosition):
            Data 0x40, of 1,
            "filter_data.ecef_position", "ECEF position",
            [], {
                "position": ["x" "y" "z"] in ["m"] of "ecef";
                "valid_flags";
            };
        /// ECEF velocity (0x82,0x41).
        FilterDataEcefVelocity(crate::filter_data::EcefVelocity):
            Data 0x41, of 1,
            "filter_data.ecef_velocity", "ECEF velocity",
            [], {
                "velocity": ["x" "y" "z"] in ["m/s"] of "ecef";
                "valid_flags";
            };
        /// NED relative position (0x82,0x42).
        FilterDataNedRelativePosition(crate::filter_data::NedRelativePosition):
            Data 0x42, of 1,
            "filter_data.ned_relative_position", "NED relative position",
            [], {
                "relative_position": ["north" "east" "down"] in ["m"] of "ned";
                "valid_flags";
            };
        /// GNSS position aiding status (0x82,0x43).
        FilterDataGnssPositionAidingStatus(crate::filter_data::GnssPositionAidingStatus):
            Data 0x43, of 1,
            "filter_data.gnss_position_aiding_status", "GNSS position aiding status",
            [], {
                "receiver_id";
                "tow" in ["s"];
                "status";
                "reserved";
            };
        /// GNSS attitude aiding status (0x82,0x44).
        FilterDataGnssAttitudeAidingStatus(crate::filter_data::GnssAttitudeAidingStatus):
            Data 0x44, of 1,
            "filter_data.gnss_attitude_aiding_status", "GNSS attitude aiding status",
            [], {
                "tow" in ["s"];
                "status";
                "reserved";
            };
        /// Heading aiding status (0x82,0x45).
        FilterDataHeadingAidingStatus(crate::filter_data::HeadingAidingStatus):
            Data 0x45, of 1,
            "filter_data.heading_aiding_status", "Heading aiding status",
            [], {
                "tow" in ["s"];
                "type";
                "reserved";
            };
        /// Aiding measurement summary (0x82,0x46).
        FilterDataAidingMeasurementSummary(crate::filter_data::AidingMeasurementSummary):
            Data 0x46, of 1,
            "filter_data.aiding_measurement_summary", "Aiding measurement summary",
            [], {
                "tow" in ["s"];
                "source";
                "type";
                "indicator";
            };
        /// Odometer scale factor error (0x82,0x47).
        FilterDataOdometerScaleFactorError(crate::filter_data::OdometerScaleFactorError):
            Data 0x47, of 1,
            "filter_data.odometer_scale_factor_error", "Odometer scale factor error",
            [], {
                "scale_factor_error" in ["1"];
                "valid_flags";
            };
        /// Odometer scale factor error uncertainty (0x82,0x48).
        FilterDataOdometerScaleFactorErrorUncertainty(crate::filter_data::OdometerScaleFactorErrorUncertainty):
            Data 0x48, of 1,
            "filter_data.odometer_scale_factor_error_uncertainty", "Odometer scale factor error uncertainty",
            [], {
                "scale_factor_error_uncertainty" in ["1"];
                "valid_flags";
            };
        /// GNSS dual antenna status (0x82,0x49).
        FilterDataGnssDualAntennaStatus(crate::filter_data::GnssDualAntennaStatus):
            Data 0x49, of 1,
            "filter_data.gnss_dual_antenna_status", "GNSS dual antenna status",
            [], {
                "tow" in ["s"];
                "heading" in ["rad"] of "ned";
                "heading_uncertainty" in ["rad"];
                "fix_type";
                "status_flags";
                "valid_flags";
            };
        /// Aiding frame configuration error (0x82,0x50).
        FilterDataAidingFrameConfigError(crate::filter_data::AidingFrameConfigError):
            Data 0x50, of 1,
            "filter_data.aiding_frame_config_error", "Aiding frame configuration error",
            [], {
                "frame_id";
                "translation": ["x" "y" "z"] in ["m"];
                "attitude": ["w" "x" "y" "z"] in ["1"];
            };
        /// Aiding frame configuration error uncertainty (0x82,0x51).
        FilterDataAidingFrameConfigErrorUncertainty(crate::filter_data::AidingFrameConfigErrorUncertainty):
            Data 0x51, of 1,
            "filter_data.aiding_frame_config_error_uncertainty", "Aiding frame configuration error uncertainty",
            [], {
                "frame_id";
                "translation_uncertainty": ["x" "y" "z"] in ["m"];
                "attitude_uncertainty": ["x" "y" "z"] in ["rad"];
            };
    }
    #[cfg(feature = "displacement_data")]
    0x90 => {
        /// Raw displacement (0x90,0x01).
        DisplacementDataDisplacementRaw(crate::displacement_data::DisplacementRaw):
            Data 0x01, of 1,
            "displacement_data.displacement_raw", "Raw displacement",
            [], {
                "counts" in ["1"];
            };
        /// Displacement (0x90,0x02).
        DisplacementDataDisplacement(crate::displacement_data::Displacement):
            Data 0x02, of 1,
            "displacement_data.displacement", "Displacement",
            [], {
                "displacement" in ["mm"];
            };
        /// Displacement device timestamp (0x90,0x04).
        DisplacementDataTimestamp(crate::displacement_data::Timestamp):
            Data 0x04, of 1,
            "displacement_data.timestamp", "Displacement device timestamp",
            [], {
                "flags";
                "time" in ["ns"];
            };
    }
    #[cfg(feature = "system_data")]
    0xA0 => {
        /// Built-in test (0xA0,0x01).
        SystemDataBuiltInTest(crate::system_data::BuiltInTest):
            Data 0x01, of 1,
            "system_data.built_in_test", "Built-in test",
            [], {
                "result";
            };
        /// Time sync status (0xA0,0x02).
        SystemDataTimeSyncStatus(crate::system_data::TimeSyncStatus):
            Data 0x02, of 1,
            "system_data.time_sync_status", "Time sync status",
            [], {
                "time_sync";
                "last_pps_received" in ["s"];
            };
        /// GPIO state (0xA0,0x03).
        SystemDataGpioState(crate::system_data::GpioState):
            Data 0x03, of 1,
            "system_data.gpio_state", "GPIO state",
            [], {
                "states";
            };
        /// GPIO analog value (0xA0,0x04).
        SystemDataGpioAnalogValue(crate::system_data::GpioAnalogValue):
            Data 0x04, of 1,
            "system_data.gpio_analog_value", "GPIO analog value",
            [], {
                "gpio_id";
                "value" in ["V"];
            };
    }
    #[cfg(feature = "shared")]
    0x80..=0xFE => {
        /// Event source (0xFF,0xD0).
        SharedEventSource(crate::shared::EventSource):
            Data 0xD0, of 1,
            "shared.event_source", "Event source",
            [], {
                "trigger_id";
            };
        /// Ticks (0xFF,0xD1).
        SharedTicks(crate::shared::Ticks):
            Data 0xD1, of 1,
            "shared.ticks", "Ticks",
            [], {
                "ticks" in ["1"];
            };
        /// Delta ticks (0xFF,0xD2).
        SharedDeltaTicks(crate::shared::DeltaTicks):
            Data 0xD2, of 1,
            "shared.delta_ticks", "Delta ticks",
            [], {
                "ticks" in ["1"];
            };
        /// GPS timestamp (0xFF,0xD3).
        SharedGpsTimestamp(crate::shared::GpsTimestamp):
            Data 0xD3, of 1,
            "shared.gps_timestamp", "GPS timestamp",
            [], {
                "tow" in ["s"];
                "week_number" in ["week"];
                "valid_flags";
            };
        /// Delta time (0xFF,0xD4).
        SharedDeltaTime(crate::shared::DeltaTime):
            Data 0xD4, of 1,
            "shared.delta_time", "Delta time",
            [], {
                "seconds" in ["s"];
            };
        /// Reference timestamp (0xFF,0xD5).
        SharedReferenceTimestamp(crate::shared::ReferenceTimestamp):
            Data 0xD5, of 1,
            "shared.reference_timestamp", "Reference timestamp",
            [], {
                "nanoseconds" in ["ns"];
            };
        /// Reference time delta (0xFF,0xD6).
        SharedReferenceTimeDelta(crate::shared::ReferenceTimeDelta):
            Data 0xD6, of 1,
            "shared.reference_time_delta", "Reference time delta",
            [], {
                "dt_nanos" in ["ns"];
            };
        /// External timestamp (0xFF,0xD7).
        SharedExternalTimestamp(crate::shared::ExternalTimestamp):
            Data 0xD7, of 1,
            "shared.external_timestamp", "External timestamp",
            [], {
                "nanoseconds" in ["ns"];
                "valid_flags";
            };
        /// External time delta (0xFF,0xD8).
        SharedExternalTimeDelta(crate::shared::ExternalTimeDelta):
            Data 0xD8, of 1,
            "shared.external_time_delta", "External time delta",
            [], {
                "dt_nanos" in ["ns"];
                "valid_flags";
            };
    }
    #[cfg(all())]
    0x01..=0x7F => {
        /// Acknowledge (0x00,0xF1).
        ProtocolAcknowledge(crate::protocol::Acknowledge):
            Response 0xF1, of 1,
            "protocol.acknowledge", "Acknowledge",
            [], {
                "command";
                "code";
            };
    }
}
