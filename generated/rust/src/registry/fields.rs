//! The fields, as [`registry!`] wants them.

use super::*;

registry! {
    /// Ping (0x01,0x01).
    BasePing(crate::base::Ping):
        Command 0x01, 0x01, in 0x01..=0x01, of 1,
        "base.ping", "Ping",
        [];
    /// Set to idle (0x01,0x02).
    BaseSetToIdle(crate::base::SetToIdle):
        Command 0x01, 0x02, in 0x01..=0x01, of 1,
        "base.set_to_idle", "Set to idle",
        [];
    /// Get device information (0x01,0x03).
    BaseGetDeviceInformation(crate::base::GetDeviceInformation):
        Command 0x01, 0x03, in 0x01..=0x01, of 1,
        "base.get_device_information", "Get device information",
        ["base.get_device_information_response"];
    /// Get device descriptors (0x01,0x04).
    BaseGetDeviceDescriptors(crate::base::GetDeviceDescriptors):
        Command 0x01, 0x04, in 0x01..=0x01, of 1,
        "base.get_device_descriptors", "Get device descriptors",
        ["base.get_device_descriptors_response"];
    /// Built-in test (0x01,0x05).
    BaseBuiltInTest(crate::base::BuiltInTest):
        Command 0x01, 0x05, in 0x01..=0x01, of 1,
        "base.built_in_test", "Built-in test",
        ["base.built_in_test_response"];
    /// Resume (0x01,0x06).
    BaseResume(crate::base::Resume):
        Command 0x01, 0x06, in 0x01..=0x01, of 1,
        "base.resume", "Resume",
        [];
    /// Get device descriptors (extended) (0x01,0x07).
    BaseGetDeviceDescriptorsExtended(crate::base::GetDeviceDescriptorsExtended):
        Command 0x01, 0x07, in 0x01..=0x01, of 1,
        "base.get_device_descriptors_extended", "Get device descriptors (extended)",
        ["base.get_device_descriptors_extended_response"];
    /// Continuous built-in test (0x01,0x08).
    BaseContinuousBuiltInTest(crate::base::ContinuousBuiltInTest):
        Command 0x01, 0x08, in 0x01..=0x01, of 1,
        "base.continuous_built_in_test", "Continuous built-in test",
        ["base.continuous_built_in_test_response"];
    /// Comm port speed (0x01,0x09).
    BaseCommPortSpeed(crate::base::CommPortSpeed):
        Command 0x01, 0x09, in 0x01..=0x01, of 1,
        "base.comm_port_speed", "Comm port speed",
        ["base.comm_port_speed_response"];
    /// GPS time update (0x01,0x72).
    BaseGpsTimeUpdate(crate::base::GpsTimeUpdate):
        Command 0x01, 0x72, in 0x01..=0x01, of 1,
        "base.gps_time_update", "GPS time update",
        ["base.gps_time_update_week_number_response", "base.gps_time_update_time_of_week_response"];
    /// Reset device (0x01,0x7E).
    BaseResetDevice(crate::base::ResetDevice):
        Command 0x01, 0x7E, in 0x01..=0x01, of 1,
        "base.reset_device", "Reset device",
        [];
    /// Get device information response (0x01,0x81).
    BaseGetDeviceInformationResponse(crate::base::GetDeviceInformationResponse):
        Response 0x01, 0x81, in 0x01..=0x01, of 1,
        "base.get_device_information_response", "Get device information response",
        ["base.get_device_information"];
    /// Get device descriptors response (0x01,0x82).
    BaseGetDeviceDescriptorsResponse(crate::base::GetDeviceDescriptorsResponse):
        Response 0x01, 0x82, in 0x01..=0x01, of 1,
        "base.get_device_descriptors_response", "Get device descriptors response",
        ["base.get_device_descriptors"];
    /// Built-in test response (0x01,0x83).
    BaseBuiltInTestResponse(crate::base::BuiltInTestResponse):
        Response 0x01, 0x83, in 0x01..=0x01, of 1,
        "base.built_in_test_response", "Built-in test response",
        ["base.built_in_test"];
    /// GPS time update, week number (0x01,0x84).
    BaseGpsTimeUpdateWeekNumberResponse(crate::base::GpsTimeUpdateWeekNumberResponse):
        Response 0x01, 0x84, in 0x01..=0x01, of 1,
        "base.gps_time_update_week_number_response", "GPS time update, week number",
        ["base.gps_time_update"];
    /// GPS time update, time of week (0x01,0x85).
    BaseGpsTimeUpdateTimeOfWeekResponse(crate::base::GpsTimeUpdateTimeOfWeekResponse):
        Response 0x01, 0x85, in 0x01..=0x01, of 1,
        "base.gps_time_update_time_of_week_response", "GPS time update, time of week",
        ["base.gps_time_update"];
    /// Get device descriptors (extended) response (0x01,0x86).
    BaseGetDeviceDescriptorsExtendedResponse(crate::base::GetDeviceDescriptorsExtendedResponse):
        Response 0x01, 0x86, in 0x01..=0x01, of 1,
        "base.get_device_descriptors_extended_response", "Get device descriptors (extended) response",
        ["base.get_device_descriptors_extended"];
    /// Continuous built-in test response (0x01,0x88).
    BaseContinuousBuiltInTestResponse(crate::base::ContinuousBuiltInTestResponse):
        Response 0x01, 0x88, in 0x01..=0x01, of 1,
        "base.continuous_built_in_test_response", "Continuous built-in test response",
        ["base.continuous_built_in_test"];
    /// Comm port speed response (0x01,0x89).
    BaseCommPortSpeedResponse(crate::base::CommPortSpeedResponse):
        Response 0x01, 0x89, in 0x01..=0x01, of 1,
        "base.comm_port_speed_response", "Comm port speed response",
        ["base.comm_port_speed"];
    /// Poll IMU Data (0x0C,0x01).
    Mip3dmPollImuData(crate::mip_3dm::PollImuData):
        Command 0x0C, 0x01, in 0x0C..=0x0C, of 1,
        "3dm.poll_imu_data", "Poll IMU Data",
        [];
    /// Poll Estimation Filter Data (0x0C,0x03).
    Mip3dmPollEstimationFilterData(crate::mip_3dm::PollEstimationFilterData):
        Command 0x0C, 0x03, in 0x0C..=0x0C, of 1,
        "3dm.poll_estimation_filter_data", "Poll Estimation Filter Data",
        [];
    /// Poll NMEA Data (0x0C,0x04).
    Mip3dmPollNmeaData(crate::mip_3dm::PollNmeaData):
        Command 0x0C, 0x04, in 0x0C..=0x0C, of 1,
        "3dm.poll_nmea_data", "Poll NMEA Data",
        [];
    /// Get IMU Data Base Rate (0x0C,0x06).
    Mip3dmGetImuDataBaseRate(crate::mip_3dm::GetImuDataBaseRate):
        Command 0x0C, 0x06, in 0x0C..=0x0C, of 1,
        "3dm.get_imu_data_base_rate", "Get IMU Data Base Rate",
        ["3dm.get_imu_data_base_rate_response"];
    /// IMU Message Format (0x0C,0x08).
    Mip3dmImuMessageFormat(crate::mip_3dm::ImuMessageFormat):
        Command 0x0C, 0x08, in 0x0C..=0x0C, of 1,
        "3dm.imu_message_format", "IMU Message Format",
        ["3dm.imu_message_format_response"];
    /// Estimation Filter Message Format (0x0C,0x0A).
    Mip3dmEstimationFilterMessageFormat(crate::mip_3dm::EstimationFilterMessageFormat):
        Command 0x0C, 0x0A, in 0x0C..=0x0C, of 1,
        "3dm.estimation_filter_message_format", "Estimation Filter Message Format",
        ["3dm.estimation_filter_message_format_response"];
    /// Get Estimation Filter Data Base Rate (0x0C,0x0B).
    Mip3dmGetEstimationFilterDataBaseRate(crate::mip_3dm::GetEstimationFilterDataBaseRate):
        Command 0x0C, 0x0B, in 0x0C..=0x0C, of 1,
        "3dm.get_estimation_filter_data_base_rate", "Get Estimation Filter Data Base Rate",
        ["3dm.get_estimation_filter_data_base_rate_response"];
    /// NMEA Message Format (0x0C,0x0C).
    Mip3dmNmeaMessageFormat(crate::mip_3dm::NmeaMessageFormat):
        Command 0x0C, 0x0C, in 0x0C..=0x0C, of 1,
        "3dm.nmea_message_format", "NMEA Message Format",
        ["3dm.nmea_message_format_response"];
    /// Poll Data (0x0C,0x0D).
    Mip3dmPollData(crate::mip_3dm::PollData):
        Command 0x0C, 0x0D, in 0x0C..=0x0C, of 1,
        "3dm.poll_data", "Poll Data",
        [];
    /// Get Data Base Rate (0x0C,0x0E).
    Mip3dmGetDataBaseRate(crate::mip_3dm::GetDataBaseRate):
        Command 0x0C, 0x0E, in 0x0C..=0x0C, of 1,
        "3dm.get_data_base_rate", "Get Data Base Rate",
        ["3dm.get_data_base_rate_response"];
    /// Message Format (0x0C,0x0F).
    Mip3dmMessageFormat(crate::mip_3dm::MessageFormat):
        Command 0x0C, 0x0F, in 0x0C..=0x0C, of 1,
        "3dm.message_format", "Message Format",
        ["3dm.message_format_response"];
    /// Factory Streaming (0x0C,0x10).
    Mip3dmFactoryStreaming(crate::mip_3dm::FactoryStreaming):
        Command 0x0C, 0x10, in 0x0C..=0x0C, of 1,
        "3dm.factory_streaming", "Factory Streaming",
        [];
    /// Data Stream Control (0x0C,0x11).
    Mip3dmDataStreamControl(crate::mip_3dm::DataStreamControl):
        Command 0x0C, 0x11, in 0x0C..=0x0C, of 1,
        "3dm.data_stream_control", "Data Stream Control",
        ["3dm.data_stream_control_response"];
    /// GNSS SBAS Settings (0x0C,0x22).
    Mip3dmGnssSbasSettings(crate::mip_3dm::GnssSbasSettings):
        Command 0x0C, 0x22, in 0x0C..=0x0C, of 1,
        "3dm.gnss_sbas_settings", "GNSS SBAS Settings",
        ["3dm.gnss_sbas_settings_response"];
    /// PPS Source Control (0x0C,0x28).
    Mip3dmPpsSourceControl(crate::mip_3dm::PpsSourceControl):
        Command 0x0C, 0x28, in 0x0C..=0x0C, of 1,
        "3dm.pps_source_control", "PPS Source Control",
        ["3dm.pps_source_control_response"];
    /// Get Supported Events (0x0C,0x2A).
    Mip3dmGetSupportedEvents(crate::mip_3dm::GetSupportedEvents):
        Command 0x0C, 0x2A, in 0x0C..=0x0C, of 1,
        "3dm.get_supported_events", "Get Supported Events",
        ["3dm.get_supported_events_response"];
    /// Event Control (0x0C,0x2B).
    Mip3dmEventControl(crate::mip_3dm::EventControl):
        Command 0x0C, 0x2B, in 0x0C..=0x0C, of 1,
        "3dm.event_control", "Event Control",
        ["3dm.event_control_response"];
    /// Get Event Trigger Status (0x0C,0x2C).
    Mip3dmGetEventTriggerStatus(crate::mip_3dm::GetEventTriggerStatus):
        Command 0x0C, 0x2C, in 0x0C..=0x0C, of 1,
        "3dm.get_event_trigger_status", "Get Event Trigger Status",
        ["3dm.get_event_trigger_status_response"];
    /// Get Event Action Status (0x0C,0x2D).
    Mip3dmGetEventActionStatus(crate::mip_3dm::GetEventActionStatus):
        Command 0x0C, 0x2D, in 0x0C..=0x0C, of 1,
        "3dm.get_event_action_status", "Get Event Action Status",
        ["3dm.get_event_action_status_response"];
    /// Event Trigger Configuration (0x0C,0x2E).
    Mip3dmEventTriggerConfiguration(crate::mip_3dm::EventTriggerConfiguration):
        Command 0x0C, 0x2E, in 0x0C..=0x0C, of 1,
        "3dm.event_trigger_configuration", "Event Trigger Configuration",
        ["3dm.event_trigger_configuration_response"];
    /// Event Action Configuration (0x0C,0x2F).
    Mip3dmEventActionConfiguration(crate::mip_3dm::EventActionConfiguration):
        Command 0x0C, 0x2F, in 0x0C..=0x0C, of 1,
        "3dm.event_action_configuration", "Event Action Configuration",
        ["3dm.event_action_configuration_response"];
    /// Device Start Up Settings (0x0C,0x30).
    Mip3dmDeviceStartUpSettings(crate::mip_3dm::DeviceStartUpSettings):
        Command 0x0C, 0x30, in 0x0C..=0x0C, of 1,
        "3dm.device_start_up_settings", "Device Start Up Settings",
        [];
    /// Sensor-to-Vehicle Frame Transformation Euler (0x0C,0x31).
    Mip3dmSensorToVehicleFrameTransformationEuler(crate::mip_3dm::SensorToVehicleFrameTransformationEuler):
        Command 0x0C, 0x31, in 0x0C..=0x0C, of 1,
        "3dm.sensor_to_vehicle_frame_transformation_euler", "Sensor-to-Vehicle Frame Transformation Euler",
        ["3dm.sensor_to_vehicle_frame_transformation_euler_response"];
    /// Sensor-to-Vehicle Frame Transformation Quaternion (0x0C,0x32).
    Mip3dmSensorToVehicleFrameTransformationQuaternion(crate::mip_3dm::SensorToVehicleFrameTransformationQuaternion):
        Command 0x0C, 0x32, in 0x0C..=0x0C, of 1,
        "3dm.sensor_to_vehicle_frame_transformation_quaternion", "Sensor-to-Vehicle Frame Transformation Quaternion",
        ["3dm.sensor_to_vehicle_frame_transformation_quaternion_response"];
    /// Sensor-to-Vehicle Frame Transformation Direction Cosine Matrix (0x0C,0x33).
    Mip3dmSensorToVehicleFrameTransformationDirectionCosineMatrix(crate::mip_3dm::SensorToVehicleFrameTransformationDirectionCosineMatrix):
        Command 0x0C, 0x33, in 0x0C..=0x0C, of 1,
        "3dm.sensor_to_vehicle_frame_transformation_direction_cosine_matrix", "Sensor-to-Vehicle Frame Transformation Direction Cosine Matrix",
        ["3dm.sensor_to_vehicle_frame_transformation_direction_cosine_matrix_response"];
    /// Accelerometer Bias Configuration (0x0C,0x37).
    Mip3dmAccelerometerBiasConfiguration(crate::mip_3dm::AccelerometerBiasConfiguration):
        Command 0x0C, 0x37, in 0x0C..=0x0C, of 1,
        "3dm.accelerometer_bias_configuration", "Accelerometer Bias Configuration",
        ["3dm.accelerometer_bias_configuration_response"];
    /// Gyroscope Bias Configuration (0x0C,0x38).
    Mip3dmGyroscopeBiasConfiguration(crate::mip_3dm::GyroscopeBiasConfiguration):
        Command 0x0C, 0x38, in 0x0C..=0x0C, of 1,
        "3dm.gyroscope_bias_configuration", "Gyroscope Bias Configuration",
        ["3dm.gyroscope_bias_configuration_response"];
    /// Capture Gyroscope Bias (0x0C,0x39).
    Mip3dmCaptureGyroscopeBias(crate::mip_3dm::CaptureGyroscopeBias):
        Command 0x0C, 0x39, in 0x0C..=0x0C, of 1,
        "3dm.capture_gyroscope_bias", "Capture Gyroscope Bias",
        ["3dm.gyroscope_bias_configuration_response"];
    /// Magnetometer Hard Iron Offset (0x0C,0x3A).
    Mip3dmMagnetometerHardIronOffset(crate::mip_3dm::MagnetometerHardIronOffset):
        Command 0x0C, 0x3A, in 0x0C..=0x0C, of 1,
        "3dm.magnetometer_hard_iron_offset", "Magnetometer Hard Iron Offset",
        ["3dm.magnetometer_hard_iron_offset_response"];
    /// Magnetometer Soft Iron Matrix (0x0C,0x3B).
    Mip3dmMagnetometerSoftIronMatrix(crate::mip_3dm::MagnetometerSoftIronMatrix):
        Command 0x0C, 0x3B, in 0x0C..=0x0C, of 1,
        "3dm.magnetometer_soft_iron_matrix", "Magnetometer Soft Iron Matrix",
        ["3dm.magnetometer_soft_iron_matrix_response"];
    /// Coning and Sculling Enable (0x0C,0x3E).
    Mip3dmConingAndScullingEnable(crate::mip_3dm::ConingAndScullingEnable):
        Command 0x0C, 0x3E, in 0x0C..=0x0C, of 1,
        "3dm.coning_and_sculling_enable", "Coning and Sculling Enable",
        ["3dm.coning_and_sculling_enable_response"];
    /// UART Baud Rate (0x0C,0x40).
    Mip3dmUartBaudRate(crate::mip_3dm::UartBaudRate):
        Command 0x0C, 0x40, in 0x0C..=0x0C, of 1,
        "3dm.uart_baud_rate", "UART Baud Rate",
        ["3dm.uart_baud_rate_response"];
    /// GPIO Configuration (0x0C,0x41).
    Mip3dmGpioConfiguration(crate::mip_3dm::GpioConfiguration):
        Command 0x0C, 0x41, in 0x0C..=0x0C, of 1,
        "3dm.gpio_configuration", "GPIO Configuration",
        ["3dm.gpio_configuration_response"];
    /// GPIO State (0x0C,0x42).
    Mip3dmGpioState(crate::mip_3dm::GpioState):
        Command 0x0C, 0x42, in 0x0C..=0x0C, of 1,
        "3dm.gpio_state", "GPIO State",
        ["3dm.gpio_state_response"];
    /// Odometer Configuration (0x0C,0x43).
    Mip3dmOdometerConfiguration(crate::mip_3dm::OdometerConfiguration):
        Command 0x0C, 0x43, in 0x0C..=0x0C, of 1,
        "3dm.odometer_configuration", "Odometer Configuration",
        ["3dm.odometer_configuration_response"];
    /// Advanced Low-Pass Filter Settings (0x0C,0x50).
    Mip3dmAdvancedLowPassFilterSettings(crate::mip_3dm::AdvancedLowPassFilterSettings):
        Command 0x0C, 0x50, in 0x0C..=0x0C, of 1,
        "3dm.advanced_low_pass_filter_settings", "Advanced Low-Pass Filter Settings",
        ["3dm.advanced_low_pass_filter_settings_response"];
    /// Complementary Filter Configuration (0x0C,0x51).
    Mip3dmComplementaryFilterConfiguration(crate::mip_3dm::ComplementaryFilterConfiguration):
        Command 0x0C, 0x51, in 0x0C..=0x0C, of 1,
        "3dm.complementary_filter_configuration", "Complementary Filter Configuration",
        ["3dm.complementary_filter_configuration_response"];
    /// Sensor Range (0x0C,0x52).
    Mip3dmSensorRange(crate::mip_3dm::SensorRange):
        Command 0x0C, 0x52, in 0x0C..=0x0C, of 1,
        "3dm.sensor_range", "Sensor Range",
        ["3dm.sensor_range_response"];
    /// Get Calibrated Sensor Ranges (0x0C,0x53).
    Mip3dmGetCalibratedSensorRanges(crate::mip_3dm::GetCalibratedSensorRanges):
        Command 0x0C, 0x53, in 0x0C..=0x0C, of 1,
        "3dm.get_calibrated_sensor_ranges", "Get Calibrated Sensor Ranges",
        ["3dm.get_calibrated_sensor_ranges_response"];
    /// Low-Pass Anti-Aliasing Filter (0x0C,0x54).
    Mip3dmLowPassAntiAliasingFilter(crate::mip_3dm::LowPassAntiAliasingFilter):
        Command 0x0C, 0x54, in 0x0C..=0x0C, of 1,
        "3dm.low_pass_anti_aliasing_filter", "Low-Pass Anti-Aliasing Filter",
        ["3dm.low_pass_anti_aliasing_filter_response"];
    /// Device Status (0x0C,0x64).
    Mip3dmDeviceStatus(crate::mip_3dm::DeviceStatus):
        Command 0x0C, 0x64, in 0x0C..=0x0C, of 1,
        "3dm.device_status", "Device Status",
        ["3dm.device_status_basic_response", "3dm.device_status_diagnostic_response"];
    /// IMU Message Format response (0x0C,0x80).
    Mip3dmImuMessageFormatResponse(crate::mip_3dm::ImuMessageFormatResponse):
        Response 0x0C, 0x80, in 0x0C..=0x0C, of 1,
        "3dm.imu_message_format_response", "IMU Message Format response",
        ["3dm.imu_message_format"];
    /// Estimation Filter Message Format response (0x0C,0x82).
    Mip3dmEstimationFilterMessageFormatResponse(crate::mip_3dm::EstimationFilterMessageFormatResponse):
        Response 0x0C, 0x82, in 0x0C..=0x0C, of 1,
        "3dm.estimation_filter_message_format_response", "Estimation Filter Message Format response",
        ["3dm.estimation_filter_message_format"];
    /// Get IMU Data Base Rate response (0x0C,0x83).
    Mip3dmGetImuDataBaseRateResponse(crate::mip_3dm::GetImuDataBaseRateResponse):
        Response 0x0C, 0x83, in 0x0C..=0x0C, of 1,
        "3dm.get_imu_data_base_rate_response", "Get IMU Data Base Rate response",
        ["3dm.get_imu_data_base_rate"];
    /// Data Stream Control response (0x0C,0x85).
    Mip3dmDataStreamControlResponse(crate::mip_3dm::DataStreamControlResponse):
        Response 0x0C, 0x85, in 0x0C..=0x0C, of 1,
        "3dm.data_stream_control_response", "Data Stream Control response",
        ["3dm.data_stream_control"];
    /// UART Baud Rate response (0x0C,0x87).
    Mip3dmUartBaudRateResponse(crate::mip_3dm::UartBaudRateResponse):
        Response 0x0C, 0x87, in 0x0C..=0x0C, of 1,
        "3dm.uart_baud_rate_response", "UART Baud Rate response",
        ["3dm.uart_baud_rate"];
    /// Get Estimation Filter Data Base Rate response (0x0C,0x8A).
    Mip3dmGetEstimationFilterDataBaseRateResponse(crate::mip_3dm::GetEstimationFilterDataBaseRateResponse):
        Response 0x0C, 0x8A, in 0x0C..=0x0C, of 1,
        "3dm.get_estimation_filter_data_base_rate_response", "Get Estimation Filter Data Base Rate response",
        ["3dm.get_estimation_filter_data_base_rate"];
    /// Advanced Low-Pass Filter Settings response (0x0C,0x8B).
    Mip3dmAdvancedLowPassFilterSettingsResponse(crate::mip_3dm::AdvancedLowPassFilterSettingsResponse):
        Response 0x0C, 0x8B, in 0x0C..=0x0C, of 1,
        "3dm.advanced_low_pass_filter_settings_response", "Advanced Low-Pass Filter Settings response",
        ["3dm.advanced_low_pass_filter_settings"];
    /// NMEA Message Format response (0x0C,0x8C).
    Mip3dmNmeaMessageFormatResponse(crate::mip_3dm::NmeaMessageFormatResponse):
        Response 0x0C, 0x8C, in 0x0C..=0x0C, of 1,
        "3dm.nmea_message_format_response", "NMEA Message Format response",
        ["3dm.nmea_message_format"];
    /// Get Data Base Rate response (0x0C,0x8E).
    Mip3dmGetDataBaseRateResponse(crate::mip_3dm::GetDataBaseRateResponse):
        Response 0x0C, 0x8E, in 0x0C..=0x0C, of 1,
        "3dm.get_data_base_rate_response", "Get Data Base Rate response",
        ["3dm.get_data_base_rate"];
    /// Message Format response (0x0C,0x8F).
    Mip3dmMessageFormatResponse(crate::mip_3dm::MessageFormatResponse):
        Response 0x0C, 0x8F, in 0x0C..=0x0C, of 1,
        "3dm.message_format_response", "Message Format response",
        ["3dm.message_format"];
    /// Basic Device Status (0x0C,0x90).
    Mip3dmDeviceStatusBasicResponse(crate::mip_3dm::DeviceStatusBasicResponse):
        Response 0x0C, 0x90, in 0x0C..=0x0C, of 2,
        "3dm.device_status_basic_response", "Basic Device Status",
        ["3dm.device_status"];
    /// Diagnostic Device Status (0x0C,0x90).
    Mip3dmDeviceStatusDiagnosticResponse(crate::mip_3dm::DeviceStatusDiagnosticResponse):
        Response 0x0C, 0x90, in 0x0C..=0x0C, of 2,
        "3dm.device_status_diagnostic_response", "Diagnostic Device Status",
        ["3dm.device_status"];
    /// Complementary Filter Configuration response (0x0C,0x97).
    Mip3dmComplementaryFilterConfigurationResponse(crate::mip_3dm::ComplementaryFilterConfigurationResponse):
        Response 0x0C, 0x97, in 0x0C..=0x0C, of 1,
        "3dm.complementary_filter_configuration_response", "Complementary Filter Configuration response",
        ["3dm.complementary_filter_configuration"];
    /// Accelerometer Bias Configuration response (0x0C,0x9A).
    Mip3dmAccelerometerBiasConfigurationResponse(crate::mip_3dm::AccelerometerBiasConfigurationResponse):
        Response 0x0C, 0x9A, in 0x0C..=0x0C, of 1,
        "3dm.accelerometer_bias_configuration_response", "Accelerometer Bias Configuration response",
        ["3dm.accelerometer_bias_configuration"];
    /// Gyroscope Bias Configuration response (0x0C,0x9B).
    Mip3dmGyroscopeBiasConfigurationResponse(crate::mip_3dm::GyroscopeBiasConfigurationResponse):
        Response 0x0C, 0x9B, in 0x0C..=0x0C, of 1,
        "3dm.gyroscope_bias_configuration_response", "Gyroscope Bias Configuration response",
        ["3dm.gyroscope_bias_configuration", "3dm.capture_gyroscope_bias"];
    /// Magnetometer Hard Iron Offset response (0x0C,0x9C).
    Mip3dmMagnetometerHardIronOffsetResponse(crate::mip_3dm::MagnetometerHardIronOffsetResponse):
        Response 0x0C, 0x9C, in 0x0C..=0x0C, of 1,
        "3dm.magnetometer_hard_iron_offset_response", "Magnetometer Hard Iron Offset response",
        ["3dm.magnetometer_hard_iron_offset"];
    /// Magnetometer Soft Iron Matrix response (0x0C,0x9D).
    Mip3dmMagnetometerSoftIronMatrixResponse(crate::mip_3dm::MagnetometerSoftIronMatrixResponse):
        Response 0x0C, 0x9D, in 0x0C..=0x0C, of 1,
        "3dm.magnetometer_soft_iron_matrix_response", "Magnetometer Soft Iron Matrix response",
        ["3dm.magnetometer_soft_iron_matrix"];
    /// Coning and Sculling Enable response (0x0C,0x9E).
    Mip3dmConingAndScullingEnableResponse(crate::mip_3dm::ConingAndScullingEnableResponse):
        Response 0x0C, 0x9E, in 0x0C..=0x0C, of 1,
        "3dm.coning_and_sculling_enable_response", "Coning and Sculling Enable response",
        ["3dm.coning_and_sculling_enable"];
    /// GNSS SBAS Settings response (0x0C,0xA1).
    Mip3dmGnssSbasSettingsResponse(crate::mip_3dm::GnssSbasSettingsResponse):
        Response 0x0C, 0xA1, in 0x0C..=0x0C, of 1,
        "3dm.gnss_sbas_settings_response", "GNSS SBAS Settings response",
        ["3dm.gnss_sbas_settings"];
    /// PPS Source Control response (0x0C,0xA8).
    Mip3dmPpsSourceControlResponse(crate::mip_3dm::PpsSourceControlResponse):
        Response 0x0C, 0xA8, in 0x0C..=0x0C, of 1,
        "3dm.pps_source_control_response", "PPS Source Control response",
        ["3dm.pps_source_control"];
    /// Sensor-to-Vehicle Frame Transformation Euler response (0x0C,0xB1).
    Mip3dmSensorToVehicleFrameTransformationEulerResponse(crate::mip_3dm::SensorToVehicleFrameTransformationEulerResponse):
        Response 0x0C, 0xB1, in 0x0C..=0x0C, of 1,
        "3dm.sensor_to_vehicle_frame_transformation_euler_response", "Sensor-to-Vehicle Frame Transformation Euler response",
        ["3dm.sensor_to_vehicle_frame_transformation_euler"];
    /// Sensor-to-Vehicle Frame Transformation Quaternion response (0x0C,0xB2).
    Mip3dmSensorToVehicleFrameTransformationQuaternionResponse(crate::mip_3dm::SensorToVehicleFrameTransformationQuaternionResponse):
        Response 0x0C, 0xB2, in 0x0C..=0x0C, of 1,
        "3dm.sensor_to_vehicle_frame_transformation_quaternion_response", "Sensor-to-Vehicle Frame Transformation Quaternion response",
        ["3dm.sensor_to_vehicle_frame_transformation_quaternion"];
    /// Sensor-to-Vehicle Frame Transformation Direction Cosine Matrix response (0x0C,0xB3).
    Mip3dmSensorToVehicleFrameTransformationDirectionCosineMatrixResponse(crate::mip_3dm::SensorToVehicleFrameTransformationDirectionCosineMatrixResponse):
        Response 0x0C, 0xB3, in 0x0C..=0x0C, of 1,
        "3dm.sensor_to_vehicle_frame_transformation_direction_cosine_matrix_response", "Sensor-to-Vehicle Frame Transformation Direction Cosine Matrix response",
        ["3dm.sensor_to_vehicle_frame_transformation_direction_cosine_matrix"];
    /// Get Supported Events response (0x0C,0xB4).
    Mip3dmGetSupportedEventsResponse(crate::mip_3dm::GetSupportedEventsResponse):
        Response 0x0C, 0xB4, in 0x0C..=0x0C, of 1,
        "3dm.get_supported_events_response", "Get Supported Events response",
        ["3dm.get_supported_events"];
    /// Event Control response (0x0C,0xB5).
    Mip3dmEventControlResponse(crate::mip_3dm::EventControlResponse):
        Response 0x0C, 0xB5, in 0x0C..=0x0C, of 1,
        "3dm.event_control_response", "Event Control response",
        ["3dm.event_control"];
    /// Get Event Trigger Status response (0x0C,0xB6).
    Mip3dmGetEventTriggerStatusResponse(crate::mip_3dm::GetEventTriggerStatusResponse):
        Response 0x0C, 0xB6, in 0x0C..=0x0C, of 1,
        "3dm.get_event_trigger_status_response", "Get Event Trigger Status response",
        ["3dm.get_event_trigger_status"];
    /// Get Event Action Status response (0x0C,0xB7).
    Mip3dmGetEventActionStatusResponse(crate::mip_3dm::GetEventActionStatusResponse):
        Response 0x0C, 0xB7, in 0x0C..=0x0C, of 1,
        "3dm.get_event_action_status_response", "Get Event Action Status response",
        ["3dm.get_event_action_status"];
    /// Event Trigger Configuration response (0x0C,0xB8).
    Mip3dmEventTriggerConfigurationResponse(crate::mip_3dm::EventTriggerConfigurationResponse):
        Response 0x0C, 0xB8, in 0x0C..=0x0C, of 1,
        "3dm.event_trigger_configuration_response", "Event Trigger Configuration response",
        ["3dm.event_trigger_configuration"];
    /// Event Action Configuration response (0x0C,0xB9).
    Mip3dmEventActionConfigurationResponse(crate::mip_3dm::EventActionConfigurationResponse):
        Response 0x0C, 0xB9, in 0x0C..=0x0C, of 1,
        "3dm.event_action_configuration_response", "Event Action Configuration response",
        ["3dm.event_action_configuration"];
    /// GPIO Configuration response (0x0C,0xC1).
    Mip3dmGpioConfigurationResponse(crate::mip_3dm::GpioConfigurationResponse):
        Response 0x0C, 0xC1, in 0x0C..=0x0C, of 1,
        "3dm.gpio_configuration_response", "GPIO Configuration response",
        ["3dm.gpio_configuration"];
    /// GPIO State response (0x0C,0xC2).
    Mip3dmGpioStateResponse(crate::mip_3dm::GpioStateResponse):
        Response 0x0C, 0xC2, in 0x0C..=0x0C, of 1,
        "3dm.gpio_state_response", "GPIO State response",
        ["3dm.gpio_state"];
    /// Odometer Configuration response (0x0C,0xC3).
    Mip3dmOdometerConfigurationResponse(crate::mip_3dm::OdometerConfigurationResponse):
        Response 0x0C, 0xC3, in 0x0C..=0x0C, of 1,
        "3dm.odometer_configuration_response", "Odometer Configuration response",
        ["3dm.odometer_configuration"];
    /// Sensor Range response (0x0C,0xD2).
    Mip3dmSensorRangeResponse(crate::mip_3dm::SensorRangeResponse):
        Response 0x0C, 0xD2, in 0x0C..=0x0C, of 1,
        "3dm.sensor_range_response", "Sensor Range response",
        ["3dm.sensor_range"];
    /// Get Calibrated Sensor Ranges response (0x0C,0xD3).
    Mip3dmGetCalibratedSensorRangesResponse(crate::mip_3dm::GetCalibratedSensorRangesResponse):
        Response 0x0C, 0xD3, in 0x0C..=0x0C, of 1,
        "3dm.get_calibrated_sensor_ranges_response", "Get Calibrated Sensor Ranges response",
        ["3dm.get_calibrated_sensor_ranges"];
    /// Low-Pass Anti-Aliasing Filter response (0x0C,0xD4).
    Mip3dmLowPassAntiAliasingFilterResponse(crate::mip_3dm::LowPassAntiAliasingFilterResponse):
        Response 0x0C, 0xD4, in 0x0C..=0x0C, of 1,
        "3dm.low_pass_anti_aliasing_filter_response", "Low-Pass Anti-Aliasing Filter response",
        ["3dm.low_pass_anti_aliasing_filter"];
    /// Reset navigation filter (0x0D,0x01).
    FilterResetNavigationFilter(crate::filter::ResetNavigationFilter):
        Command 0x0D, 0x01, in 0x0D..=0x0D, of 1,
        "filter.reset_navigation_filter", "Reset navigation filter",
        [];
    /// Set initial attitude (0x0D,0x02).
    FilterSetInitialAttitude(crate::filter::SetInitialAttitude):
        Command 0x0D, 0x02, in 0x0D..=0x0D, of 1,
        "filter.set_initial_attitude", "Set initial attitude",
        [];
    /// Set initial heading (0x0D,0x03).
    FilterSetInitialHeadingControl(crate::filter::SetInitialHeadingControl):
        Command 0x0D, 0x03, in 0x0D..=0x0D, of 1,
        "filter.set_initial_heading_control", "Set initial heading",
        [];
    /// Run navigation filter (0x0D,0x05).
    FilterRunNavigationFilter(crate::filter::RunNavigationFilter):
        Command 0x0D, 0x05, in 0x0D..=0x0D, of 1,
        "filter.run_navigation_filter", "Run navigation filter",
        [];
    /// Sensor to vehicle frame transformation (0x0D,0x11).
    FilterSensorToVehicleFrameTransformation(crate::filter::SensorToVehicleFrameTransformation):
        Command 0x0D, 0x11, in 0x0D..=0x0D, of 1,
        "filter.sensor_to_vehicle_frame_transformation", "Sensor to vehicle frame transformation",
        ["filter.sensor_to_vehicle_frame_transformation_response"];
    /// GNSS antenna offset (0x0D,0x13).
    FilterGnssAntennaOffsetControl(crate::filter::GnssAntennaOffsetControl):
        Command 0x0D, 0x13, in 0x0D..=0x0D, of 1,
        "filter.gnss_antenna_offset_control", "GNSS antenna offset",
        ["filter.gnss_antenna_offset_control_response"];
    /// Estimation control flags (0x0D,0x14).
    FilterEstimationControlFlags(crate::filter::EstimationControlFlags):
        Command 0x0D, 0x14, in 0x0D..=0x0D, of 1,
        "filter.estimation_control_flags", "Estimation control flags",
        ["filter.estimation_control_flags_response"];
    /// GNSS aiding source (0x0D,0x15).
    FilterGnssAidingSourceControl(crate::filter::GnssAidingSourceControl):
        Command 0x0D, 0x15, in 0x0D..=0x0D, of 1,
        "filter.gnss_aiding_source_control", "GNSS aiding source",
        ["filter.gnss_aiding_source_control_response"];
    /// External heading update (0x0D,0x17).
    FilterExternalHeadingUpdate(crate::filter::ExternalHeadingUpdate):
        Command 0x0D, 0x17, in 0x0D..=0x0D, of 1,
        "filter.external_heading_update", "External heading update",
        [];
    /// Heading update control (0x0D,0x18).
    FilterHeadingUpdateControl(crate::filter::HeadingUpdateControl):
        Command 0x0D, 0x18, in 0x0D..=0x0D, of 1,
        "filter.heading_update_control", "Heading update control",
        ["filter.heading_update_control_response"];
    /// Automatic initialization (0x0D,0x19).
    FilterAutoInitializationControl(crate::filter::AutoInitializationControl):
        Command 0x0D, 0x19, in 0x0D..=0x0D, of 1,
        "filter.auto_initialization_control", "Automatic initialization",
        ["filter.auto_initialization_control_response"];
    /// Accelerometer noise (0x0D,0x1A).
    FilterAccelerometerNoiseStandardDeviation(crate::filter::AccelerometerNoiseStandardDeviation):
        Command 0x0D, 0x1A, in 0x0D..=0x0D, of 1,
        "filter.accelerometer_noise_standard_deviation", "Accelerometer noise",
        ["filter.accelerometer_noise_standard_deviation_response"];
    /// Gyroscope noise (0x0D,0x1B).
    FilterGyroscopeNoiseStandardDeviation(crate::filter::GyroscopeNoiseStandardDeviation):
        Command 0x0D, 0x1B, in 0x0D..=0x0D, of 1,
        "filter.gyroscope_noise_standard_deviation", "Gyroscope noise",
        ["filter.gyroscope_noise_standard_deviation_response"];
    /// Accelerometer bias model (0x0D,0x1C).
    FilterAccelerometerBiasModelParameters(crate::filter::AccelerometerBiasModelParameters):
        Command 0x0D, 0x1C, in 0x0D..=0x0D, of 1,
        "filter.accelerometer_bias_model_parameters", "Accelerometer bias model",
        ["filter.accelerometer_bias_model_parameters_response"];
    /// Gyroscope bias model (0x0D,0x1D).
    FilterGyroscopeBiasModelParameters(crate::filter::GyroscopeBiasModelParameters):
        Command 0x0D, 0x1D, in 0x0D..=0x0D, of 1,
        "filter.gyroscope_bias_model_parameters", "Gyroscope bias model",
        ["filter.gyroscope_bias_model_parameters_response"];
    /// External heading update with time (0x0D,0x1F).
    FilterExternalHeadingUpdateWithTime(crate::filter::ExternalHeadingUpdateWithTime):
        Command 0x0D, 0x1F, in 0x0D..=0x0D, of 1,
        "filter.external_heading_update_with_time", "External heading update with time",
        [];
    /// Zero angular rate update (0x0D,0x20).
    FilterZeroAngularRateUpdateControl(crate::filter::ZeroAngularRateUpdateControl):
        Command 0x0D, 0x20, in 0x0D..=0x0D, of 1,
        "filter.zero_angular_rate_update_control", "Zero angular rate update",
        ["filter.zero_angular_rate_update_control_response"];
    /// Tare orientation (0x0D,0x21).
    FilterTareOrientation(crate::filter::TareOrientation):
        Command 0x0D, 0x21, in 0x0D..=0x0D, of 1,
        "filter.tare_orientation", "Tare orientation",
        [];
    /// Commanded zero angular rate update (0x0D,0x23).
    FilterCommandedZeroAngularRateUpdate(crate::filter::CommandedZeroAngularRateUpdate):
        Command 0x0D, 0x23, in 0x0D..=0x0D, of 1,
        "filter.commanded_zero_angular_rate_update", "Commanded zero angular rate update",
        [];
    /// Set reference position (0x0D,0x26).
    FilterSetReferencePosition(crate::filter::SetReferencePosition):
        Command 0x0D, 0x26, in 0x0D..=0x0D, of 1,
        "filter.set_reference_position", "Set reference position",
        ["filter.set_reference_position_response"];
    /// Gravity noise (0x0D,0x28).
    FilterGravityNoiseStandardDeviation(crate::filter::GravityNoiseStandardDeviation):
        Command 0x0D, 0x28, in 0x0D..=0x0D, of 1,
        "filter.gravity_noise_standard_deviation", "Gravity noise",
        ["filter.gravity_noise_standard_deviation_response"];
    /// Enable or disable measurements (0x0D,0x41).
    FilterEnableDisableMeasurements(crate::filter::EnableDisableMeasurements):
        Command 0x0D, 0x41, in 0x0D..=0x0D, of 1,
        "filter.enable_disable_measurements", "Enable or disable measurements",
        ["filter.enable_disable_measurements_response"];
    /// Magnetic declination source (0x0D,0x43).
    FilterMagneticFieldDeclinationSourceControl(crate::filter::MagneticFieldDeclinationSourceControl):
        Command 0x0D, 0x43, in 0x0D..=0x0D, of 1,
        "filter.magnetic_field_declination_source_control", "Magnetic declination source",
        ["filter.magnetic_field_declination_source_control_response"];
    /// Gravity magnitude error adaptive measurement (0x0D,0x44).
    FilterGravityMagnitudeErrorAdaptiveMeasurement(crate::filter::GravityMagnitudeErrorAdaptiveMeasurement):
        Command 0x0D, 0x44, in 0x0D..=0x0D, of 1,
        "filter.gravity_magnitude_error_adaptive_measurement", "Gravity magnitude error adaptive measurement",
        ["filter.gravity_magnitude_error_adaptive_measurement_response"];
    /// Pitch and roll aiding (0x0D,0x4B).
    FilterPitchRollAidingControl(crate::filter::PitchRollAidingControl):
        Command 0x0D, 0x4B, in 0x0D..=0x0D, of 1,
        "filter.pitch_roll_aiding_control", "Pitch and roll aiding",
        ["filter.pitch_roll_aiding_control_response"];
    /// Aiding measurement control (0x0D,0x50).
    FilterAidingMeasurementControl(crate::filter::AidingMeasurementControl):
        Command 0x0D, 0x50, in 0x0D..=0x0D, of 1,
        "filter.aiding_measurement_control", "Aiding measurement control",
        ["filter.aiding_measurement_control_response"];
    /// Navigation filter initialization (0x0D,0x52).
    FilterNavigationFilterInitialization(crate::filter::NavigationFilterInitialization):
        Command 0x0D, 0x52, in 0x0D..=0x0D, of 1,
        "filter.navigation_filter_initialization", "Navigation filter initialization",
        ["filter.navigation_filter_initialization_response"];
    /// Adaptive filter control (0x0D,0x53).
    FilterAdaptiveFilterControl(crate::filter::AdaptiveFilterControl):
        Command 0x0D, 0x53, in 0x0D..=0x0D, of 1,
        "filter.adaptive_filter_control", "Adaptive filter control",
        ["filter.adaptive_filter_control_response"];
    /// GNSS multi-antenna offset (0x0D,0x54).
    FilterGnssMultiAntennaOffsetControl(crate::filter::GnssMultiAntennaOffsetControl):
        Command 0x0D, 0x54, in 0x0D..=0x0D, of 1,
        "filter.gnss_multi_antenna_offset_control", "GNSS multi-antenna offset",
        ["filter.gnss_multi_antenna_offset_control_response"];
    /// Relative position configuration (0x0D,0x55).
    FilterRelativePositionConfiguration(crate::filter::RelativePositionConfiguration):
        Command 0x0D, 0x55, in 0x0D..=0x0D, of 1,
        "filter.relative_position_configuration", "Relative position configuration",
        ["filter.relative_position_configuration_response"];
    /// Reference point lever arm (0x0D,0x56).
    FilterReferencePointLeverArm(crate::filter::ReferencePointLeverArm):
        Command 0x0D, 0x56, in 0x0D..=0x0D, of 1,
        "filter.reference_point_lever_arm", "Reference point lever arm",
        ["filter.reference_point_lever_arm_response"];
    /// Speed measurement lever arm (0x0D,0x61).
    FilterMeasurementSpeedLeverArm(crate::filter::MeasurementSpeedLeverArm):
        Command 0x0D, 0x61, in 0x0D..=0x0D, of 1,
        "filter.measurement_speed_lever_arm", "Speed measurement lever arm",
        ["filter.measurement_speed_lever_arm_response"];
    /// Wheeled vehicle constraint (0x0D,0x63).
    FilterWheeledVehicleConstraintControl(crate::filter::WheeledVehicleConstraintControl):
        Command 0x0D, 0x63, in 0x0D..=0x0D, of 1,
        "filter.wheeled_vehicle_constraint_control", "Wheeled vehicle constraint",
        ["filter.wheeled_vehicle_constraint_control_response"];
    /// GNSS antenna offset calibration (0x0D,0x64).
    FilterGnssAntennaOffsetCalibrationControl(crate::filter::GnssAntennaOffsetCalibrationControl):
        Command 0x0D, 0x64, in 0x0D..=0x0D, of 1,
        "filter.gnss_antenna_offset_calibration_control", "GNSS antenna offset calibration",
        ["filter.gnss_antenna_offset_calibration_control_response"];
    /// Sensor to vehicle frame transformation response (0x0D,0x81).
    FilterSensorToVehicleFrameTransformationResponse(crate::filter::SensorToVehicleFrameTransformationResponse):
        Response 0x0D, 0x81, in 0x0D..=0x0D, of 1,
        "filter.sensor_to_vehicle_frame_transformation_response", "Sensor to vehicle frame transformation response",
        ["filter.sensor_to_vehicle_frame_transformation"];
    /// GNSS antenna offset response (0x0D,0x83).
    FilterGnssAntennaOffsetControlResponse(crate::filter::GnssAntennaOffsetControlResponse):
        Response 0x0D, 0x83, in 0x0D..=0x0D, of 1,
        "filter.gnss_antenna_offset_control_response", "GNSS antenna offset response",
        ["filter.gnss_antenna_offset_control"];
    /// Estimation control flags response (0x0D,0x84).
    FilterEstimationControlFlagsResponse(crate::filter::EstimationControlFlagsResponse):
        Response 0x0D, 0x84, in 0x0D..=0x0D, of 1,
        "filter.estimation_control_flags_response", "Estimation control flags response",
        ["filter.estimation_control_flags"];
    /// GNSS aiding source response (0x0D,0x86).
    FilterGnssAidingSourceControlResponse(crate::filter::GnssAidingSourceControlResponse):
        Response 0x0D, 0x86, in 0x0D..=0x0D, of 1,
        "filter.gnss_aiding_source_control_response", "GNSS aiding source response",
        ["filter.gnss_aiding_source_control"];
    /// Heading update control response (0x0D,0x87).
    FilterHeadingUpdateControlResponse(crate::filter::HeadingUpdateControlResponse):
        Response 0x0D, 0x87, in 0x0D..=0x0D, of 1,
        "filter.heading_update_control_response", "Heading update control response",
        ["filter.heading_update_control"];
    /// Automatic initialization response (0x0D,0x88).
    FilterAutoInitializationControlResponse(crate::filter::AutoInitializationControlResponse):
        Response 0x0D, 0x88, in 0x0D..=0x0D, of 1,
        "filter.auto_initialization_control_response", "Automatic initialization response",
        ["filter.auto_initialization_control"];
    /// Accelerometer noise response (0x0D,0x89).
    FilterAccelerometerNoiseStandardDeviationResponse(crate::filter::AccelerometerNoiseStandardDeviationResponse):
        Response 0x0D, 0x89, in 0x0D..=0x0D, of 1,
        "filter.accelerometer_noise_standard_deviation_response", "Accelerometer noise response",
        ["filter.accelerometer_noise_standard_deviation"];
    /// Gyroscope noise response (0x0D,0x8A).
    FilterGyroscopeNoiseStandardDeviationResponse(crate::filter::GyroscopeNoiseStandardDeviationResponse):
        Response 0x0D, 0x8A, in 0x0D..=0x0D, of 1,
        "filter.gyroscope_noise_standard_deviation_response", "Gyroscope noise response",
        ["filter.gyroscope_noise_standard_deviation"];
    /// Accelerometer bias model response (0x0D,0x8B).
    FilterAccelerometerBiasModelParametersResponse(crate::filter::AccelerometerBiasModelParametersResponse):
        Response 0x0D, 0x8B, in 0x0D..=0x0D, of 1,
        "filter.accelerometer_bias_model_parameters_response", "Accelerometer bias model response",
        ["filter.accelerometer_bias_model_parameters"];
    /// Gyroscope bias model response (0x0D,0x8C).
    FilterGyroscopeBiasModelParametersResponse(crate::filter::GyroscopeBiasModelParametersResponse):
        Response 0x0D, 0x8C, in 0x0D..=0x0D, of 1,
        "filter.gyroscope_bias_model_parameters_response", "Gyroscope bias model response",
        ["filter.gyroscope_bias_model_parameters"];
    /// Zero angular rate update response (0x0D,0x8E).
    FilterZeroAngularRateUpdateControlResponse(crate::filter::ZeroAngularRateUpdateControlResponse):
        Response 0x0D, 0x8E, in 0x0D..=0x0D, of 1,
        "filter.zero_angular_rate_update_control_response", "Zero angular rate update response",
        ["filter.zero_angular_rate_update_control"];
    /// Set reference position response (0x0D,0x90).
    FilterSetReferencePositionResponse(crate::filter::SetReferencePositionResponse):
        Response 0x0D, 0x90, in 0x0D..=0x0D, of 1,
        "filter.set_reference_position_response", "Set reference position response",
        ["filter.set_reference_position"];
    /// Gravity noise response (0x0D,0x93).
    FilterGravityNoiseStandardDeviationResponse(crate::filter::GravityNoiseStandardDeviationResponse):
        Response 0x0D, 0x93, in 0x0D..=0x0D, of 1,
        "filter.gravity_noise_standard_deviation_response", "Gravity noise response",
        ["filter.gravity_noise_standard_deviation"];
    /// Enable or disable measurements response (0x0D,0xB0).
    FilterEnableDisableMeasurementsResponse(crate::filter::EnableDisableMeasurementsResponse):
        Response 0x0D, 0xB0, in 0x0D..=0x0D, of 1,
        "filter.enable_disable_measurements_response", "Enable or disable measurements response",
        ["filter.enable_disable_measurements"];
    /// Magnetic declination source response (0x0D,0xB2).
    FilterMagneticFieldDeclinationSourceControlResponse(crate::filter::MagneticFieldDeclinationSourceControlResponse):
        Response 0x0D, 0xB2, in 0x0D..=0x0D, of 1,
        "filter.magnetic_field_declination_source_control_response", "Magnetic declination source response",
        ["filter.magnetic_field_declination_source_control"];
    /// Gravity magnitude error adaptive measurement response (0x0D,0xB3).
    FilterGravityMagnitudeErrorAdaptiveMeasurementResponse(crate::filter::GravityMagnitudeErrorAdaptiveMeasurementResponse):
        Response 0x0D, 0xB3, in 0x0D..=0x0D, of 1,
        "filter.gravity_magnitude_error_adaptive_measurement_response", "Gravity magnitude error adaptive measurement response",
        ["filter.gravity_magnitude_error_adaptive_measurement"];
    /// Pitch and roll aiding response (0x0D,0xBB).
    FilterPitchRollAidingControlResponse(crate::filter::PitchRollAidingControlResponse):
        Response 0x0D, 0xBB, in 0x0D..=0x0D, of 1,
        "filter.pitch_roll_aiding_control_response", "Pitch and roll aiding response",
        ["filter.pitch_roll_aiding_control"];
    /// Aiding measurement control response (0x0D,0xD0).
    FilterAidingMeasurementControlResponse(crate::filter::AidingMeasurementControlResponse):
        Response 0x0D, 0xD0, in 0x0D..=0x0D, of 1,
        "filter.aiding_measurement_control_response", "Aiding measurement control response",
        ["filter.aiding_measurement_control"];
    /// Navigation filter initialization response (0x0D,0xD2).
    FilterNavigationFilterInitializationResponse(crate::filter::NavigationFilterInitializationResponse):
        Response 0x0D, 0xD2, in 0x0D..=0x0D, of 1,
        "filter.navigation_filter_initialization_response", "Navigation filter initialization response",
        ["filter.navigation_filter_initialization"];
    /// Adaptive filter control response (0x0D,0xD3).
    FilterAdaptiveFilterControlResponse(crate::filter::AdaptiveFilterControlResponse):
        Response 0x0D, 0xD3, in 0x0D..=0x0D, of 1,
        "filter.adaptive_filter_control_response", "Adaptive filter control response",
        ["filter.adaptive_filter_control"];
    /// GNSS multi-antenna offset response (0x0D,0xD4).
    FilterGnssMultiAntennaOffsetControlResponse(crate::filter::GnssMultiAntennaOffsetControlResponse):
        Response 0x0D, 0xD4, in 0x0D..=0x0D, of 1,
        "filter.gnss_multi_antenna_offset_control_response", "GNSS multi-antenna offset response",
        ["filter.gnss_multi_antenna_offset_control"];
    /// Relative position configuration response (0x0D,0xD5).
    FilterRelativePositionConfigurationResponse(crate::filter::RelativePositionConfigurationResponse):
        Response 0x0D, 0xD5, in 0x0D..=0x0D, of 1,
        "filter.relative_position_configuration_response", "Relative position configuration response",
        ["filter.relative_position_configuration"];
    /// Reference point lever arm response (0x0D,0xD6).
    FilterReferencePointLeverArmResponse(crate::filter::ReferencePointLeverArmResponse):
        Response 0x0D, 0xD6, in 0x0D..=0x0D, of 1,
        "filter.reference_point_lever_arm_response", "Reference point lever arm response",
        ["filter.reference_point_lever_arm"];
    /// Speed measurement lever arm response (0x0D,0xE1).
    FilterMeasurementSpeedLeverArmResponse(crate::filter::MeasurementSpeedLeverArmResponse):
        Response 0x0D, 0xE1, in 0x0D..=0x0D, of 1,
        "filter.measurement_speed_lever_arm_response", "Speed measurement lever arm response",
        ["filter.measurement_speed_lever_arm"];
    /// Wheeled vehicle constraint response (0x0D,0xE3).
    FilterWheeledVehicleConstraintControlResponse(crate::filter::WheeledVehicleConstraintControlResponse):
        Response 0x0D, 0xE3, in 0x0D..=0x0D, of 1,
        "filter.wheeled_vehicle_constraint_control_response", "Wheeled vehicle constraint response",
        ["filter.wheeled_vehicle_constraint_control"];
    /// GNSS antenna offset calibration response (0x0D,0xE4).
    FilterGnssAntennaOffsetCalibrationControlResponse(crate::filter::GnssAntennaOffsetCalibrationControlResponse):
        Response 0x0D, 0xE4, in 0x0D..=0x0D, of 1,
        "filter.gnss_antenna_offset_calibration_control_response", "GNSS antenna offset calibration response",
        ["filter.gnss_antenna_offset_calibration_control"];
    /// Receiver info (0x0E,0x01).
    GnssReceiverInfo(crate::gnss::ReceiverInfo):
        Command 0x0E, 0x01, in 0x0E..=0x0E, of 1,
        "gnss.receiver_info", "Receiver info",
        ["gnss.receiver_info_response"];
    /// Signal configuration (0x0E,0x02).
    GnssSignalConfiguration(crate::gnss::SignalConfiguration):
        Command 0x0E, 0x02, in 0x0E..=0x0E, of 1,
        "gnss.signal_configuration", "Signal configuration",
        ["gnss.signal_configuration_response"];
    /// SPARTN configuration (0x0E,0x20).
    GnssSpartnConfiguration(crate::gnss::SpartnConfiguration):
        Command 0x0E, 0x20, in 0x0E..=0x0E, of 1,
        "gnss.spartn_configuration", "SPARTN configuration",
        ["gnss.spartn_configuration_response"];
    /// Receiver info response (0x0E,0x81).
    GnssReceiverInfoResponse(crate::gnss::ReceiverInfoResponse):
        Response 0x0E, 0x81, in 0x0E..=0x0E, of 1,
        "gnss.receiver_info_response", "Receiver info response",
        ["gnss.receiver_info"];
    /// Signal configuration response (0x0E,0x82).
    GnssSignalConfigurationResponse(crate::gnss::SignalConfigurationResponse):
        Response 0x0E, 0x82, in 0x0E..=0x0E, of 1,
        "gnss.signal_configuration_response", "Signal configuration response",
        ["gnss.signal_configuration"];
    /// SPARTN configuration response (0x0E,0xA0).
    GnssSpartnConfigurationResponse(crate::gnss::SpartnConfigurationResponse):
        Response 0x0E, 0xA0, in 0x0E..=0x0E, of 1,
        "gnss.spartn_configuration_response", "SPARTN configuration response",
        ["gnss.spartn_configuration"];
    /// Frame configuration (0x13,0x01).
    AidingFrameConfiguration(crate::aiding::FrameConfiguration):
        Command 0x13, 0x01, in 0x13..=0x13, of 1,
        "aiding.frame_configuration", "Frame configuration",
        ["aiding.frame_configuration_response"];
    /// Echo control (0x13,0x1F).
    AidingEchoControl(crate::aiding::EchoControl):
        Command 0x13, 0x1F, in 0x13..=0x13, of 1,
        "aiding.echo_control", "Echo control",
        ["aiding.echo_control_response"];
    /// ECEF position (0x13,0x21).
    AidingEcefPosition(crate::aiding::EcefPosition):
        Command 0x13, 0x21, in 0x13..=0x13, of 1,
        "aiding.ecef_position", "ECEF position",
        [];
    /// LLH position (0x13,0x22).
    AidingLlhPosition(crate::aiding::LlhPosition):
        Command 0x13, 0x22, in 0x13..=0x13, of 1,
        "aiding.llh_position", "LLH position",
        [];
    /// Height above ellipsoid (0x13,0x23).
    AidingHeightAboveEllipsoid(crate::aiding::HeightAboveEllipsoid):
        Command 0x13, 0x23, in 0x13..=0x13, of 1,
        "aiding.height_above_ellipsoid", "Height above ellipsoid",
        [];
    /// ECEF velocity (0x13,0x28).
    AidingEcefVelocity(crate::aiding::EcefVelocity):
        Command 0x13, 0x28, in 0x13..=0x13, of 1,
        "aiding.ecef_velocity", "ECEF velocity",
        [];
    /// NED velocity (0x13,0x29).
    AidingNedVelocity(crate::aiding::NedVelocity):
        Command 0x13, 0x29, in 0x13..=0x13, of 1,
        "aiding.ned_velocity", "NED velocity",
        [];
    /// Body frame velocity (0x13,0x2A).
    AidingBodyFrameVelocity(crate::aiding::BodyFrameVelocity):
        Command 0x13, 0x2A, in 0x13..=0x13, of 1,
        "aiding.body_frame_velocity", "Body frame velocity",
        [];
    /// True heading (0x13,0x31).
    AidingTrueHeading(crate::aiding::TrueHeading):
        Command 0x13, 0x31, in 0x13..=0x13, of 1,
        "aiding.true_heading", "True heading",
        [];
    /// Magnetic field (0x13,0x32).
    AidingMagneticField(crate::aiding::MagneticField):
        Command 0x13, 0x32, in 0x13..=0x13, of 1,
        "aiding.magnetic_field", "Magnetic field",
        [];
    /// Pressure (0x13,0x33).
    AidingPressure(crate::aiding::Pressure):
        Command 0x13, 0x33, in 0x13..=0x13, of 1,
        "aiding.pressure", "Pressure",
        [];
    /// Frame configuration response (0x13,0x81).
    AidingFrameConfigurationResponse(crate::aiding::FrameConfigurationResponse):
        Response 0x13, 0x81, in 0x13..=0x13, of 1,
        "aiding.frame_configuration_response", "Frame configuration response",
        ["aiding.frame_configuration"];
    /// Echo control response (0x13,0x9F).
    AidingEchoControlResponse(crate::aiding::EchoControlResponse):
        Response 0x13, 0x9F, in 0x13..=0x13, of 1,
        "aiding.echo_control_response", "Echo control response",
        ["aiding.echo_control"];
    /// Communication mode (0x7F,0x10).
    SystemCommunicationMode(crate::system::CommunicationMode):
        Command 0x7F, 0x10, in 0x7F..=0x7F, of 1,
        "system.communication_mode", "Communication mode",
        ["system.communication_mode_response"];
    /// Communication mode response (0x7F,0x90).
    SystemCommunicationModeResponse(crate::system::CommunicationModeResponse):
        Response 0x7F, 0x90, in 0x7F..=0x7F, of 1,
        "system.communication_mode_response", "Communication mode response",
        ["system.communication_mode"];
    /// Scaled accel (0x80,0x04).
    SensorScaledAccel(crate::sensor::ScaledAccel):
        Data 0x80, 0x04, in 0x80..=0x80, of 1,
        "sensor.scaled_accel", "Scaled accel",
        [];
    /// Scaled gyro (0x80,0x05).
    SensorScaledGyro(crate::sensor::ScaledGyro):
        Data 0x80, 0x05, in 0x80..=0x80, of 1,
        "sensor.scaled_gyro", "Scaled gyro",
        [];
    /// Scaled mag (0x80,0x06).
    SensorScaledMag(crate::sensor::ScaledMag):
        Data 0x80, 0x06, in 0x80..=0x80, of 1,
        "sensor.scaled_mag", "Scaled mag",
        [];
    /// Delta theta (0x80,0x07).
    SensorDeltaTheta(crate::sensor::DeltaTheta):
        Data 0x80, 0x07, in 0x80..=0x80, of 1,
        "sensor.delta_theta", "Delta theta",
        [];
    /// Delta velocity (0x80,0x08).
    SensorDeltaVelocity(crate::sensor::DeltaVelocity):
        Data 0x80, 0x08, in 0x80..=0x80, of 1,
        "sensor.delta_velocity", "Delta velocity",
        [];
    /// Complementary filter orientation matrix (0x80,0x09).
    SensorComplementaryFilterOrientationMatrix(crate::sensor::ComplementaryFilterOrientationMatrix):
        Data 0x80, 0x09, in 0x80..=0x80, of 1,
        "sensor.complementary_filter_orientation_matrix", "Complementary filter orientation matrix",
        [];
    /// Complementary filter quaternion (0x80,0x0A).
    SensorComplementaryFilterQuaternion(crate::sensor::ComplementaryFilterQuaternion):
        Data 0x80, 0x0A, in 0x80..=0x80, of 1,
        "sensor.complementary_filter_quaternion", "Complementary filter quaternion",
        [];
    /// Complementary filter Euler angles (0x80,0x0C).
    SensorComplementaryFilterEulerAngles(crate::sensor::ComplementaryFilterEulerAngles):
        Data 0x80, 0x0C, in 0x80..=0x80, of 1,
        "sensor.complementary_filter_euler_angles", "Complementary filter Euler angles",
        [];
    /// Complementary filter stabilized north vector (0x80,0x10).
    SensorComplementaryFilterStabilizedNorthVector(crate::sensor::ComplementaryFilterStabilizedNorthVector):
        Data 0x80, 0x10, in 0x80..=0x80, of 1,
        "sensor.complementary_filter_stabilized_north_vector", "Complementary filter stabilized north vector",
        [];
    /// Complementary filter stabilized up vector (0x80,0x11).
    SensorComplementaryFilterStabilizedUpVector(crate::sensor::ComplementaryFilterStabilizedUpVector):
        Data 0x80, 0x11, in 0x80..=0x80, of 1,
        "sensor.complementary_filter_stabilized_up_vector", "Complementary filter stabilized up vector",
        [];
    /// GPS timestamp (0x80,0x12).
    SensorGpsTimestamp(crate::sensor::GpsTimestamp):
        Data 0x80, 0x12, in 0x80..=0x80, of 1,
        "sensor.gps_timestamp", "GPS timestamp",
        [];
    /// Temperature statistics (0x80,0x14).
    SensorTemperatureStatistics(crate::sensor::TemperatureStatistics):
        Data 0x80, 0x14, in 0x80..=0x80, of 1,
        "sensor.temperature_statistics", "Temperature statistics",
        [];
    /// Scaled pressure (0x80,0x17).
    SensorScaledPressure(crate::sensor::ScaledPressure):
        Data 0x80, 0x17, in 0x80..=0x80, of 1,
        "sensor.scaled_pressure", "Scaled pressure",
        [];
    /// Overrange status (0x80,0x18).
    SensorOverrangeStatus(crate::sensor::OverrangeStatus):
        Data 0x80, 0x18, in 0x80..=0x80, of 1,
        "sensor.overrange_status", "Overrange status",
        [];
    /// Odometer data (0x80,0x40).
    SensorOdometer(crate::sensor::Odometer):
        Data 0x80, 0x40, in 0x80..=0x80, of 1,
        "sensor.odometer", "Odometer data",
        [];
    /// LLH position (0x82,0x01).
    FilterDataLlhPosition(crate::filter_data::LlhPosition):
        Data 0x82, 0x01, in 0x82..=0x82, of 1,
        "filter_data.llh_position", "LLH position",
        [];
    /// NED velocity (0x82,0x02).
    FilterDataVelocityNed(crate::filter_data::VelocityNed):
        Data 0x82, 0x02, in 0x82..=0x82, of 1,
        "filter_data.velocity_ned", "NED velocity",
        [];
    /// Attitude quaternion (0x82,0x03).
    FilterDataAttitudeQuaternion(crate::filter_data::AttitudeQuaternion):
        Data 0x82, 0x03, in 0x82..=0x82, of 1,
        "filter_data.attitude_quaternion", "Attitude quaternion",
        [];
    /// Attitude direction cosine matrix (0x82,0x04).
    FilterDataAttitudeDcm(crate::filter_data::AttitudeDcm):
        Data 0x82, 0x04, in 0x82..=0x82, of 1,
        "filter_data.attitude_dcm", "Attitude direction cosine matrix",
        [];
    /// Euler angles (0x82,0x05).
    FilterDataEulerAngles(crate::filter_data::EulerAngles):
        Data 0x82, 0x05, in 0x82..=0x82, of 1,
        "filter_data.euler_angles", "Euler angles",
        [];
    /// Gyroscope bias (0x82,0x06).
    FilterDataGyroBias(crate::filter_data::GyroBias):
        Data 0x82, 0x06, in 0x82..=0x82, of 1,
        "filter_data.gyro_bias", "Gyroscope bias",
        [];
    /// Accelerometer bias (0x82,0x07).
    FilterDataAccelBias(crate::filter_data::AccelBias):
        Data 0x82, 0x07, in 0x82..=0x82, of 1,
        "filter_data.accel_bias", "Accelerometer bias",
        [];
    /// Position uncertainty (0x82,0x08).
    FilterDataLlhPositionUncertainty(crate::filter_data::LlhPositionUncertainty):
        Data 0x82, 0x08, in 0x82..=0x82, of 1,
        "filter_data.llh_position_uncertainty", "Position uncertainty",
        [];
    /// NED velocity uncertainty (0x82,0x09).
    FilterDataNedVelocityUncertainty(crate::filter_data::NedVelocityUncertainty):
        Data 0x82, 0x09, in 0x82..=0x82, of 1,
        "filter_data.ned_velocity_uncertainty", "NED velocity uncertainty",
        [];
    /// Euler angles uncertainty (0x82,0x0A).
    FilterDataEulerAnglesUncertainty(crate::filter_data::EulerAnglesUncertainty):
        Data 0x82, 0x0A, in 0x82..=0x82, of 1,
        "filter_data.euler_angles_uncertainty", "Euler angles uncertainty",
        [];
    /// Gyroscope bias uncertainty (0x82,0x0B).
    FilterDataGyroBiasUncertainty(crate::filter_data::GyroBiasUncertainty):
        Data 0x82, 0x0B, in 0x82..=0x82, of 1,
        "filter_data.gyro_bias_uncertainty", "Gyroscope bias uncertainty",
        [];
    /// Accelerometer bias uncertainty (0x82,0x0C).
    FilterDataAccelBiasUncertainty(crate::filter_data::AccelBiasUncertainty):
        Data 0x82, 0x0C, in 0x82..=0x82, of 1,
        "filter_data.accel_bias_uncertainty", "Accelerometer bias uncertainty",
        [];
    /// Linear acceleration (0x82,0x0D).
    FilterDataLinearAccel(crate::filter_data::LinearAccel):
        Data 0x82, 0x0D, in 0x82..=0x82, of 1,
        "filter_data.linear_accel", "Linear acceleration",
        [];
    /// Compensated angular rate (0x82,0x0E).
    FilterDataCompAngularRate(crate::filter_data::CompAngularRate):
        Data 0x82, 0x0E, in 0x82..=0x82, of 1,
        "filter_data.comp_angular_rate", "Compensated angular rate",
        [];
    /// WGS84 local gravity magnitude (0x82,0x0F).
    FilterDataWgs84LocalGravityMagnitude(crate::filter_data::Wgs84LocalGravityMagnitude):
        Data 0x82, 0x0F, in 0x82..=0x82, of 1,
        "filter_data.wgs84_local_gravity_magnitude", "WGS84 local gravity magnitude",
        [];
    /// Filter status (0x82,0x10).
    FilterDataStatus(crate::filter_data::Status):
        Data 0x82, 0x10, in 0x82..=0x82, of 1,
        "filter_data.status", "Filter status",
        [];
    /// Filter timestamp (0x82,0x11).
    FilterDataTimestamp(crate::filter_data::Timestamp):
        Data 0x82, 0x11, in 0x82..=0x82, of 1,
        "filter_data.timestamp", "Filter timestamp",
        [];
    /// Quaternion uncertainty (0x82,0x12).
    FilterDataQuaternionAttitudeUncertainty(crate::filter_data::QuaternionAttitudeUncertainty):
        Data 0x82, 0x12, in 0x82..=0x82, of 1,
        "filter_data.quaternion_attitude_uncertainty", "Quaternion uncertainty",
        [];
    /// Gravity vector (0x82,0x13).
    FilterDataGravityVector(crate::filter_data::GravityVector):
        Data 0x82, 0x13, in 0x82..=0x82, of 1,
        "filter_data.gravity_vector", "Gravity vector",
        [];
    /// Heading update source state (0x82,0x14).
    FilterDataHeadingUpdateSourceState(crate::filter_data::HeadingUpdateSourceState):
        Data 0x82, 0x14, in 0x82..=0x82, of 1,
        "filter_data.heading_update_source_state", "Heading update source state",
        [];
    /// Magnetic model (0x82,0x15).
    FilterDataMagneticModel(crate::filter_data::MagneticModel):
        Data 0x82, 0x15, in 0x82..=0x82, of 1,
        "filter_data.magnetic_model", "Magnetic model",
        [];
    /// Compensated acceleration (0x82,0x1C).
    FilterDataCompensatedAcceleration(crate::filter_data::CompensatedAcceleration):
        Data 0x82, 0x1C, in 0x82..=0x82, of 1,
        "filter_data.compensated_acceleration", "Compensated acceleration",
        [];
    /// Pressure altitude (0x82,0x21).
    FilterDataPressureAltitude(crate::filter_data::PressureAltitude):
        Data 0x82, 0x21, in 0x82..=0x82, of 1,
        "filter_data.pressure_altitude", "Pressure altitude",
        [];
    /// Multi-antenna offset correction (0x82,0x34).
    FilterDataMultiAntennaOffsetCorrection(crate::filter_data::MultiAntennaOffsetCorrection):
        Data 0x82, 0x34, in 0x82..=0x82, of 1,
        "filter_data.multi_antenna_offset_correction", "Multi-antenna offset correction",
        [];
    /// Multi-antenna offset correction uncertainty (0x82,0x35).
    FilterDataMultiAntennaOffsetCorrectionUncertainty(crate::filter_data::MultiAntennaOffsetCorrectionUncertainty):
        Data 0x82, 0x35, in 0x82..=0x82, of 1,
        "filter_data.multi_antenna_offset_correction_uncertainty", "Multi-antenna offset correction uncertainty",
        [];
    /// ECEF position uncertainty (0x82,0x36).
    FilterDataEcefPositionUncertainty(crate::filter_data::EcefPositionUncertainty):
        Data 0x82, 0x36, in 0x82..=0x82, of 1,
        "filter_data.ecef_position_uncertainty", "ECEF position uncertainty",
        [];
    /// ECEF velocity uncertainty (0x82,0x37).
    FilterDataEcefVelocityUncertainty(crate::filter_data::EcefVelocityUncertainty):
        Data 0x82, 0x37, in 0x82..=0x82, of 1,
        "filter_data.ecef_velocity_uncertainty", "ECEF velocity uncertainty",
        [];
    /// ECEF position (0x82,0x40).
    FilterDataEcefPosition(crate::filter_data::EcefPosition):
        Data 0x82, 0x40, in 0x82..=0x82, of 1,
        "filter_data.ecef_position", "ECEF position",
        [];
    /// ECEF velocity (0x82,0x41).
    FilterDataEcefVelocity(crate::filter_data::EcefVelocity):
        Data 0x82, 0x41, in 0x82..=0x82, of 1,
        "filter_data.ecef_velocity", "ECEF velocity",
        [];
    /// NED relative position (0x82,0x42).
    FilterDataNedRelativePosition(crate::filter_data::NedRelativePosition):
        Data 0x82, 0x42, in 0x82..=0x82, of 1,
        "filter_data.ned_relative_position", "NED relative position",
        [];
    /// GNSS position aiding status (0x82,0x43).
    FilterDataGnssPositionAidingStatus(crate::filter_data::GnssPositionAidingStatus):
        Data 0x82, 0x43, in 0x82..=0x82, of 1,
        "filter_data.gnss_position_aiding_status", "GNSS position aiding status",
        [];
    /// Aiding measurement summary (0x82,0x46).
    FilterDataAidingMeasurementSummary(crate::filter_data::AidingMeasurementSummary):
        Data 0x82, 0x46, in 0x82..=0x82, of 1,
        "filter_data.aiding_measurement_summary", "Aiding measurement summary",
        [];
    /// Odometer scale factor error (0x82,0x47).
    FilterDataOdometerScaleFactorError(crate::filter_data::OdometerScaleFactorError):
        Data 0x82, 0x47, in 0x82..=0x82, of 1,
        "filter_data.odometer_scale_factor_error", "Odometer scale factor error",
        [];
    /// Odometer scale factor error uncertainty (0x82,0x48).
    FilterDataOdometerScaleFactorErrorUncertainty(crate::filter_data::OdometerScaleFactorErrorUncertainty):
        Data 0x82, 0x48, in 0x82..=0x82, of 1,
        "filter_data.odometer_scale_factor_error_uncertainty", "Odometer scale factor error uncertainty",
        [];
    /// GNSS dual antenna status (0x82,0x49).
    FilterDataGnssDualAntennaStatus(crate::filter_data::GnssDualAntennaStatus):
        Data 0x82, 0x49, in 0x82..=0x82, of 1,
        "filter_data.gnss_dual_antenna_status", "GNSS dual antenna status",
        [];
    /// Aiding frame configuration error (0x82,0x50).
    FilterDataAidingFrameConfigurationError(crate::filter_data::AidingFrameConfigurationError):
        Data 0x82, 0x50, in 0x82..=0x82, of 1,
        "filter_data.aiding_frame_configuration_error", "Aiding frame configuration error",
        [];
    /// Aiding frame configuration error uncertainty (0x82,0x51).
    FilterDataAidingFrameConfigurationErrorUncertainty(crate::filter_data::AidingFrameConfigurationErrorUncertainty):
        Data 0x82, 0x51, in 0x82..=0x82, of 1,
        "filter_data.aiding_frame_configuration_error_uncertainty", "Aiding frame configuration error uncertainty",
        [];
    /// GNSS LLH position (0x91,0x03).
    Gnss1GnssLlhPosition(crate::gnss_1::GnssLlhPosition):
        Data 0x91, 0x03, in 0x91..=0x91, of 1,
        "gnss_1.gnss_llh_position", "GNSS LLH position",
        [];
    /// GNSS ECEF position (0x91,0x04).
    Gnss1GnssEcefPosition(crate::gnss_1::GnssEcefPosition):
        Data 0x91, 0x04, in 0x91..=0x91, of 1,
        "gnss_1.gnss_ecef_position", "GNSS ECEF position",
        [];
    /// NED velocity (0x91,0x05).
    Gnss1NedVelocity(crate::gnss_1::NedVelocity):
        Data 0x91, 0x05, in 0x91..=0x91, of 1,
        "gnss_1.ned_velocity", "NED velocity",
        [];
    /// GNSS ECEF velocity (0x91,0x06).
    Gnss1GnssEcefVelocity(crate::gnss_1::GnssEcefVelocity):
        Data 0x91, 0x06, in 0x91..=0x91, of 1,
        "gnss_1.gnss_ecef_velocity", "GNSS ECEF velocity",
        [];
    /// DOP (0x91,0x07).
    Gnss1Dop(crate::gnss_1::Dop):
        Data 0x91, 0x07, in 0x91..=0x91, of 1,
        "gnss_1.dop", "DOP",
        [];
    /// UTC time (0x91,0x08).
    Gnss1UtcTime(crate::gnss_1::UtcTime):
        Data 0x91, 0x08, in 0x91..=0x91, of 1,
        "gnss_1.utc_time", "UTC time",
        [];
    /// GPS time (0x91,0x09).
    Gnss1GpsTime(crate::gnss_1::GpsTime):
        Data 0x91, 0x09, in 0x91..=0x91, of 1,
        "gnss_1.gps_time", "GPS time",
        [];
    /// Fix info (0x91,0x0B).
    Gnss1FixInfo(crate::gnss_1::FixInfo):
        Data 0x91, 0x0B, in 0x91..=0x91, of 1,
        "gnss_1.fix_info", "Fix info",
        [];
    /// GNSS hardware status (0x91,0x0D).
    Gnss1GnssHardwareStatus(crate::gnss_1::GnssHardwareStatus):
        Data 0x91, 0x0D, in 0x91..=0x91, of 1,
        "gnss_1.gnss_hardware_status", "GNSS hardware status",
        [];
    /// Clock info 2 (0x91,0x10).
    Gnss1ClockInfo2(crate::gnss_1::ClockInfo2):
        Data 0x91, 0x10, in 0x91..=0x91, of 1,
        "gnss_1.clock_info_2", "Clock info 2",
        [];
    /// GPS leap seconds (0x91,0x11).
    Gnss1GpsLeapSeconds(crate::gnss_1::GpsLeapSeconds):
        Data 0x91, 0x11, in 0x91..=0x91, of 1,
        "gnss_1.gps_leap_seconds", "GPS leap seconds",
        [];
    /// SBAS info (0x91,0x12).
    Gnss1SbasInfo(crate::gnss_1::SbasInfo):
        Data 0x91, 0x12, in 0x91..=0x91, of 1,
        "gnss_1.sbas_info", "SBAS info",
        [];
    /// Satellite status (0x91,0x20).
    Gnss1SatelliteStatus(crate::gnss_1::SatelliteStatus):
        Data 0x91, 0x20, in 0x91..=0x91, of 1,
        "gnss_1.satellite_status", "Satellite status",
        [];
    /// Raw (0x91,0x22).
    Gnss1Raw(crate::gnss_1::Raw):
        Data 0x91, 0x22, in 0x91..=0x91, of 1,
        "gnss_1.raw", "Raw",
        [];
    /// GPS ephemeris (0x91,0x61).
    Gnss1GpsEphemeris(crate::gnss_1::GpsEphemeris):
        Data 0x91, 0x61, in 0x91..=0x91, of 1,
        "gnss_1.gps_ephemeris", "GPS ephemeris",
        [];
    /// GLONASS ephemeris (0x91,0x62).
    Gnss1GlonassEphemeris(crate::gnss_1::GlonassEphemeris):
        Data 0x91, 0x62, in 0x91..=0x91, of 1,
        "gnss_1.glonass_ephemeris", "GLONASS ephemeris",
        [];
    /// Galileo ephemeris (0x91,0x63).
    Gnss1GalileoEphemeris(crate::gnss_1::GalileoEphemeris):
        Data 0x91, 0x63, in 0x91..=0x91, of 1,
        "gnss_1.galileo_ephemeris", "Galileo ephemeris",
        [];
    /// BeiDou ephemeris (0x91,0x64).
    Gnss1BeidouEphemeris(crate::gnss_1::BeidouEphemeris):
        Data 0x91, 0x64, in 0x91..=0x91, of 1,
        "gnss_1.beidou_ephemeris", "BeiDou ephemeris",
        [];
    /// GNSS LLH position (0x92,0x03).
    Gnss2GnssLlhPosition(crate::gnss_2::GnssLlhPosition):
        Data 0x92, 0x03, in 0x92..=0x92, of 1,
        "gnss_2.gnss_llh_position", "GNSS LLH position",
        [];
    /// GNSS ECEF position (0x92,0x04).
    Gnss2GnssEcefPosition(crate::gnss_2::GnssEcefPosition):
        Data 0x92, 0x04, in 0x92..=0x92, of 1,
        "gnss_2.gnss_ecef_position", "GNSS ECEF position",
        [];
    /// NED velocity (0x92,0x05).
    Gnss2NedVelocity(crate::gnss_2::NedVelocity):
        Data 0x92, 0x05, in 0x92..=0x92, of 1,
        "gnss_2.ned_velocity", "NED velocity",
        [];
    /// GNSS ECEF velocity (0x92,0x06).
    Gnss2GnssEcefVelocity(crate::gnss_2::GnssEcefVelocity):
        Data 0x92, 0x06, in 0x92..=0x92, of 1,
        "gnss_2.gnss_ecef_velocity", "GNSS ECEF velocity",
        [];
    /// DOP (0x92,0x07).
    Gnss2Dop(crate::gnss_2::Dop):
        Data 0x92, 0x07, in 0x92..=0x92, of 1,
        "gnss_2.dop", "DOP",
        [];
    /// UTC time (0x92,0x08).
    Gnss2UtcTime(crate::gnss_2::UtcTime):
        Data 0x92, 0x08, in 0x92..=0x92, of 1,
        "gnss_2.utc_time", "UTC time",
        [];
    /// GPS time (0x92,0x09).
    Gnss2GpsTime(crate::gnss_2::GpsTime):
        Data 0x92, 0x09, in 0x92..=0x92, of 1,
        "gnss_2.gps_time", "GPS time",
        [];
    /// Fix info (0x92,0x0B).
    Gnss2FixInfo(crate::gnss_2::FixInfo):
        Data 0x92, 0x0B, in 0x92..=0x92, of 1,
        "gnss_2.fix_info", "Fix info",
        [];
    /// GNSS hardware status (0x92,0x0D).
    Gnss2GnssHardwareStatus(crate::gnss_2::GnssHardwareStatus):
        Data 0x92, 0x0D, in 0x92..=0x92, of 1,
        "gnss_2.gnss_hardware_status", "GNSS hardware status",
        [];
    /// Clock info 2 (0x92,0x10).
    Gnss2ClockInfo2(crate::gnss_2::ClockInfo2):
        Data 0x92, 0x10, in 0x92..=0x92, of 1,
        "gnss_2.clock_info_2", "Clock info 2",
        [];
    /// GPS leap seconds (0x92,0x11).
    Gnss2GpsLeapSeconds(crate::gnss_2::GpsLeapSeconds):
        Data 0x92, 0x11, in 0x92..=0x92, of 1,
        "gnss_2.gps_leap_seconds", "GPS leap seconds",
        [];
    /// SBAS info (0x92,0x12).
    Gnss2SbasInfo(crate::gnss_2::SbasInfo):
        Data 0x92, 0x12, in 0x92..=0x92, of 1,
        "gnss_2.sbas_info", "SBAS info",
        [];
    /// Satellite status (0x92,0x20).
    Gnss2SatelliteStatus(crate::gnss_2::SatelliteStatus):
        Data 0x92, 0x20, in 0x92..=0x92, of 1,
        "gnss_2.satellite_status", "Satellite status",
        [];
    /// Raw (0x92,0x22).
    Gnss2Raw(crate::gnss_2::Raw):
        Data 0x92, 0x22, in 0x92..=0x92, of 1,
        "gnss_2.raw", "Raw",
        [];
    /// GPS ephemeris (0x92,0x61).
    Gnss2GpsEphemeris(crate::gnss_2::GpsEphemeris):
        Data 0x92, 0x61, in 0x92..=0x92, of 1,
        "gnss_2.gps_ephemeris", "GPS ephemeris",
        [];
    /// GLONASS ephemeris (0x92,0x62).
    Gnss2GlonassEphemeris(crate::gnss_2::GlonassEphemeris):
        Data 0x92, 0x62, in 0x92..=0x92, of 1,
        "gnss_2.glonass_ephemeris", "GLONASS ephemeris",
        [];
    /// Galileo ephemeris (0x92,0x63).
    Gnss2GalileoEphemeris(crate::gnss_2::GalileoEphemeris):
        Data 0x92, 0x63, in 0x92..=0x92, of 1,
        "gnss_2.galileo_ephemeris", "Galileo ephemeris",
        [];
    /// BeiDou ephemeris (0x92,0x64).
    Gnss2BeidouEphemeris(crate::gnss_2::BeidouEphemeris):
        Data 0x92, 0x64, in 0x92..=0x92, of 1,
        "gnss_2.beidou_ephemeris", "BeiDou ephemeris",
        [];
    /// Base station info (0x93,0x30).
    GnssCorrectionsBaseStationInfo(crate::gnss_corrections::BaseStationInfo):
        Data 0x93, 0x30, in 0x93..=0x93, of 1,
        "gnss_corrections.base_station_info", "Base station info",
        [];
    /// RTK corrections status (0x93,0x31).
    GnssCorrectionsRtkCorrectionsStatus(crate::gnss_corrections::RtkCorrectionsStatus):
        Data 0x93, 0x31, in 0x93..=0x93, of 1,
        "gnss_corrections.rtk_corrections_status", "RTK corrections status",
        [];
    /// GNSS LLH position (0x94,0x03).
    GnssExternalGnssLlhPosition(crate::gnss_external::GnssLlhPosition):
        Data 0x94, 0x03, in 0x94..=0x94, of 1,
        "gnss_external.gnss_llh_position", "GNSS LLH position",
        [];
    /// NED velocity (0x94,0x05).
    GnssExternalNedVelocity(crate::gnss_external::NedVelocity):
        Data 0x94, 0x05, in 0x94..=0x94, of 1,
        "gnss_external.ned_velocity", "NED velocity",
        [];
    /// UTC time (0x94,0x08).
    GnssExternalUtcTime(crate::gnss_external::UtcTime):
        Data 0x94, 0x08, in 0x94..=0x94, of 1,
        "gnss_external.utc_time", "UTC time",
        [];
    /// Fix info (0x94,0x0B).
    GnssExternalFixInfo(crate::gnss_external::FixInfo):
        Data 0x94, 0x0B, in 0x94..=0x94, of 1,
        "gnss_external.fix_info", "Fix info",
        [];
    /// Satellite status (0x94,0x20).
    GnssExternalSatelliteStatus(crate::gnss_external::SatelliteStatus):
        Data 0x94, 0x20, in 0x94..=0x94, of 1,
        "gnss_external.satellite_status", "Satellite status",
        [];
    /// Built-in test (0xA0,0x01).
    SystemDataBuiltInTest(crate::system_data::BuiltInTest):
        Data 0xA0, 0x01, in 0xA0..=0xA0, of 1,
        "system_data.built_in_test", "Built-in test",
        [];
    /// Time sync status (0xA0,0x02).
    SystemDataTimeSyncStatus(crate::system_data::TimeSyncStatus):
        Data 0xA0, 0x02, in 0xA0..=0xA0, of 1,
        "system_data.time_sync_status", "Time sync status",
        [];
    /// GPIO state (0xA0,0x03).
    SystemDataGpioState(crate::system_data::GpioState):
        Data 0xA0, 0x03, in 0xA0..=0xA0, of 1,
        "system_data.gpio_state", "GPIO state",
        [];
    /// Event source (0xFF,0xD0).
    SharedEventSource(crate::shared::EventSource):
        Data 0xFF, 0xD0, in 0x80..=0xFF, of 1,
        "shared.event_source", "Event source",
        [];
    /// GPS timestamp (0xFF,0xD3).
    SharedGpsTimestamp(crate::shared::GpsTimestamp):
        Data 0xFF, 0xD3, in 0x80..=0xFF, of 1,
        "shared.gps_timestamp", "GPS timestamp",
        [];
    /// Delta time (0xFF,0xD4).
    SharedDeltaTime(crate::shared::DeltaTime):
        Data 0xFF, 0xD4, in 0x80..=0xFF, of 1,
        "shared.delta_time", "Delta time",
        [];
    /// Reference timestamp (0xFF,0xD5).
    SharedReferenceTimestamp(crate::shared::ReferenceTimestamp):
        Data 0xFF, 0xD5, in 0x80..=0xFF, of 1,
        "shared.reference_timestamp", "Reference timestamp",
        [];
    /// Reference time delta (0xFF,0xD6).
    SharedReferenceTimeDelta(crate::shared::ReferenceTimeDelta):
        Data 0xFF, 0xD6, in 0x80..=0xFF, of 1,
        "shared.reference_time_delta", "Reference time delta",
        [];
    /// External timestamp (0xFF,0xD7).
    SharedExternalTimestamp(crate::shared::ExternalTimestamp):
        Data 0xFF, 0xD7, in 0x80..=0xFF, of 1,
        "shared.external_timestamp", "External timestamp",
        [];
    /// External time delta (0xFF,0xD8).
    SharedExternalTimeDelta(crate::shared::ExternalTimeDelta):
        Data 0xFF, 0xD8, in 0x80..=0xFF, of 1,
        "shared.external_time_delta", "External time delta",
        [];
    /// Acknowledge (0x00,0xF1).
    ProtocolAcknowledge(crate::protocol::Acknowledge):
        Response 0x00, 0xF1, in 0x01..=0x7F, of 1,
        "protocol.acknowledge", "Acknowledge",
        [];
}
