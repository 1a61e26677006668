// 3DM: the names and layouts of its fields. The declarations describe their meaning.

import * as codec from "./mip/codec.mjs";
import * as field from "./mip/field.mjs";
import { FunctionSelector } from "./protocol.mjs";
import * as types from "./types.mjs";

export const PollEntry = /* @__PURE__ */ codec.struct({
    descriptor: codec.u8,
    reserved: /* @__PURE__ */ codec.reserved(codec.u16, 0),
});

export const FactoryStreamingAction = /* @__PURE__ */ codec.enumeration(codec.u8, {
    OVERWRITE: 0,
    MERGE: 1,
    ADD: 2,
});

export const ConstellationId = /* @__PURE__ */ codec.enumeration(codec.u8, {
    GPS: 0,
    SBAS: 1,
    GALILEO: 2,
    BEIDOU: 3,
    QZSS: 5,
    GLONASS: 6,
});

export const ConstellationOptions = /* @__PURE__ */ codec.bitfield(codec.u16, {
    L1SAIF: [0, 0],
});

export const ConstellationSettingsEntry = /* @__PURE__ */ codec.struct({
    constellation_id: ConstellationId,
    enable: codec.u8,
    reserved_channels: codec.u8,
    max_channels: codec.u8,
    option_flags: ConstellationOptions,
});

export const SbasOptions = /* @__PURE__ */ codec.bitfield(codec.u16, {
    ENABLE_RANGING: [0, 0],
    ENABLE_CORRECTIONS: [1, 1],
    APPLY_INTEGRITY: [2, 2],
});

export const AssistedFixOption = /* @__PURE__ */ codec.enumeration(codec.u8, {
    NONE: 0,
    ENABLED: 1,
});

export const PpsSource = /* @__PURE__ */ codec.enumeration(codec.u8, {
    DISABLED: 0,
    RECEIVER_1: 1,
    RECEIVER_2: 2,
    GPIO: 3,
    GENERATED: 4,
});

export const EventSupportQuery = /* @__PURE__ */ codec.enumeration(codec.u8, {
    TRIGGER_TYPES: 1,
    ACTION_TYPES: 2,
});

export const EventSupportInfo = /* @__PURE__ */ codec.struct({
    type: codec.u8,
    count: codec.u8,
});

export const EventTriggerStatusEntry = /* @__PURE__ */ codec.struct({
    type: types.EventTriggerType,
    status: types.EventTriggerStatus,
});

export const EventActionStatusEntry = /* @__PURE__ */ codec.struct({
    action_type: types.EventActionType,
    trigger_id: codec.u8,
});

export const ReceiverDynamics = /* @__PURE__ */ codec.enumeration(codec.u8, {
    PORTABLE: 0,
    FIXED: 1,
    STATIONARY: 2,
    PEDESTRIAN: 3,
    AUTOMOTIVE: 4,
    SEA: 5,
    AIRBORNE_1G: 6,
    AIRBORNE_2G: 7,
    AIRBORNE_4G: 8,
});

export const DataConditioningFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    ORIENTATION_CALCULATION: [0, 0],
    CONING_SCULLING: [1, 1],
    LITTLE_ENDIAN_FLOATS: [4, 4],
    NAN_SUPPRESSED: [5, 5],
    FINITE_SIZE_CORRECTION: [6, 6],
    DISABLE_MAG: [8, 8],
    MAG_LOW_POWER: [9, 9],
    DISABLE_NORTH_COMPENSATION: [10, 10],
    DISABLE_UP_COMPENSATION: [11, 11],
    QUATERNION_CALCULATION: [12, 12],
});

export const MagBandwidth = /* @__PURE__ */ codec.enumeration(codec.u8, {
    HIGH: 0,
    LOW: 1,
});

export const ImuTimestampSelector = /* @__PURE__ */ codec.enumeration(codec.u8, {
    BEACON_SECONDS: 1,
    BEACON_NANOSECONDS: 2,
    INTERNAL_TICKS: 3,
});

export const OdometerMode = /* @__PURE__ */ codec.enumeration(codec.u8, {
    DISABLED: 0,
    QUADRATURE: 2,
});

export const SensorRangeType = /* @__PURE__ */ codec.enumeration(codec.u8, {
    ALL: 0,
    ACCEL: 1,
    GYRO: 2,
    MAG: 3,
    PRESSURE: 4,
});

export const SensorRangeEntry = /* @__PURE__ */ codec.struct({
    setting: codec.u8,
    range: codec.float,
});

export const InternalSensor = /* @__PURE__ */ codec.enumeration(codec.u8, {
    IMU: 1,
    GNSS: 2,
});

export const StreamFormat = /* @__PURE__ */ codec.enumeration(codec.u8, {
    STANDARD: 1,
    WRAPPED_RAW: 2,
});

export const SensorPowerState = /* @__PURE__ */ codec.enumeration(codec.u8, {
    ON: 1,
    LOW_POWER: 2,
    SLEEP: 3,
    OFF: 4,
});

export const DeviceStatusSelector = /* @__PURE__ */ codec.enumeration(codec.u8, {
    BASIC: 1,
    DIAGNOSTIC: 2,
});

export const LegacyDataStream = /* @__PURE__ */ codec.enumeration(codec.u8, {
    ALL_STREAMS: 0,
    IMU: 1,
    GNSS: 2,
    FILTER: 3,
});

export const Gx4SystemState = /* @__PURE__ */ codec.enumeration(codec.u16, {
    INIT: 1,
    SENSOR_STARTUP: 2,
    RUNNING: 3,
});

export const ImuMessageFormatResponse = /* @__PURE__ */ field.response("3dm.imu_message_format_response", 0x0c, 0x80, {
    num_descriptors: /* @__PURE__ */ codec.counter(codec.u8, "descriptors"),
    descriptors: /* @__PURE__ */ codec.counted("num_descriptors", types.DescriptorRate, 84),
});

export const GnssMessageFormatResponse = /* @__PURE__ */ field.response("3dm.gnss_message_format_response", 0x0c, 0x81, {
    num_descriptors: /* @__PURE__ */ codec.counter(codec.u8, "descriptors"),
    descriptors: /* @__PURE__ */ codec.counted("num_descriptors", types.DescriptorRate, 84),
});

export const FilterMessageFormatResponse = /* @__PURE__ */ field.response("3dm.filter_message_format_response", 0x0c, 0x82, {
    num_descriptors: /* @__PURE__ */ codec.counter(codec.u8, "descriptors"),
    descriptors: /* @__PURE__ */ codec.counted("num_descriptors", types.DescriptorRate, 84),
});

export const GetImuBaseRateResponse = /* @__PURE__ */ field.response("3dm.get_imu_base_rate_response", 0x0c, 0x83, {
    rate: codec.u16,
});

export const GetGnssBaseRateResponse = /* @__PURE__ */ field.response("3dm.get_gnss_base_rate_response", 0x0c, 0x84, {
    rate: codec.u16,
});

export const DataStreamControlResponse = /* @__PURE__ */ field.response("3dm.data_stream_control_response", 0x0c, 0x85, {
    descriptor_set: codec.u8,
    enabled: codec.bool,
});

export const ImuSignalConditioningResponse = /* @__PURE__ */ field.response("3dm.imu_signal_conditioning_response", 0x0c, 0x86, {
    orientation_decimation: codec.u16,
    data_conditioning_flags: DataConditioningFlags,
    inertial_filter_width: codec.u8,
    mag_filter_width: codec.u8,
    up_compensation: codec.u16,
    north_compensation: codec.u16,
    mag_bandwidth: MagBandwidth,
    reserved: /* @__PURE__ */ codec.reserved(codec.u16, 0),
});

export const UartBaudRateResponse = /* @__PURE__ */ field.response("3dm.uart_baud_rate_response", 0x0c, 0x87, {
    baud: codec.u32,
});

export const DataStreamFormatResponse = /* @__PURE__ */ field.response("3dm.data_stream_format_response", 0x0c, 0x88, {
    stream: InternalSensor,
    format: StreamFormat,
});

export const DevicePowerStateResponse = /* @__PURE__ */ field.response("3dm.device_power_state_response", 0x0c, 0x89, {
    device: InternalSensor,
    state: SensorPowerState,
});

export const GetFilterBaseRateResponse = /* @__PURE__ */ field.response("3dm.get_filter_base_rate_response", 0x0c, 0x8a, {
    rate: codec.u16,
});

export const ImuLowPassFilterResponse = /* @__PURE__ */ field.response("3dm.imu_low_pass_filter_response", 0x0c, 0x8b, {
    target_descriptor: codec.u8,
    enable: codec.bool,
    manual: codec.bool,
    frequency: codec.u16,
    reserved: /* @__PURE__ */ codec.reserved(codec.u8, 0),
});

export const NmeaMessageFormatResponse = /* @__PURE__ */ field.response("3dm.nmea_message_format_response", 0x0c, 0x8c, {
    count: /* @__PURE__ */ codec.counter(codec.u8, "format_entries"),
    format_entries: /* @__PURE__ */ codec.counted("count", types.NmeaMessage, 50),
});

export const GetBaseRateResponse = /* @__PURE__ */ field.response("3dm.get_base_rate_response", 0x0c, 0x8e, {
    descriptor_set: codec.u8,
    rate: codec.u16,
});

export const MessageFormatResponse = /* @__PURE__ */ field.response("3dm.message_format_response", 0x0c, 0x8f, {
    descriptor_set: codec.u8,
    num_descriptors: /* @__PURE__ */ codec.counter(codec.u8, "descriptors"),
    descriptors: /* @__PURE__ */ codec.counted("num_descriptors", types.DescriptorRate, 83),
});

export const DeviceStatusBasicRq1ImuResponse = /* @__PURE__ */ field.response("3dm.device_status_basic_rq1_imu_response", 0x0c, 0x90, {
    model_number: /* @__PURE__ */ codec.constant(codec.u16, 6238),
    status_selector: /* @__PURE__ */ codec.constant(codec.u8, 1),
    status_flags: codec.u32,
    system_timer: codec.u64,
}, {
    fits: [15, 253, [[0, [24, 94]], [2, [1]]]],
});

export const DeviceStatusBasicResponse = /* @__PURE__ */ field.response("3dm.device_status_basic_response", 0x0c, 0x90, {
    model_number: codec.u16,
    status_selector: /* @__PURE__ */ codec.constant(codec.u8, 1),
    status_flags: codec.u32,
    system_state: codec.u16,
    system_timer: codec.u32,
}, {
    fits: [13, 14, [[2, [1]]]],
});

export const DeviceStatusBasicWithoutStateResponse = /* @__PURE__ */ field.response("3dm.device_status_basic_without_state_response", 0x0c, 0x90, {
    model_number: codec.u16,
    status_selector: /* @__PURE__ */ codec.constant(codec.u8, 1),
    status_flags: codec.u32,
    system_timer: codec.u32,
}, {
    fits: [0, 12, [[2, [1]]]],
});

export const DeviceStatusDiagnosticResponse = /* @__PURE__ */ field.response("3dm.device_status_diagnostic_response", 0x0c, 0x90, {
    model_number: codec.u16,
    status_selector: /* @__PURE__ */ codec.constant(codec.u8, 2),
    status_flags: codec.u32,
    system_state: codec.u16,
    system_timer: codec.u32,
    imu_stream_enabled: codec.bool,
    filter_stream_enabled: codec.bool,
    imu_dropped_packets: codec.u32,
    filter_dropped_packets: codec.u32,
    comm_port_bytes_written: codec.u32,
    comm_port_bytes_read: codec.u32,
    comm_port_write_overruns: codec.u32,
    comm_port_read_overruns: codec.u32,
    imu_parser_errors: codec.u32,
    imu_message_count: codec.u32,
    imu_last_message_time: codec.u32,
}, {
    fits: [0, 59, [[2, [2]]]],
});

export const DeviceStatusDiagnosticGnssResponse = /* @__PURE__ */ field.response("3dm.device_status_diagnostic_gnss_response", 0x0c, 0x90, {
    model_number: codec.u16,
    status_selector: /* @__PURE__ */ codec.constant(codec.u8, 2),
    status_flags: codec.u32,
    system_state: codec.u16,
    system_timer: codec.u32,
    gnss_power_state: codec.u8,
    pps_count: codec.u32,
    pps_last_time: codec.u32,
    imu_stream_enabled: codec.bool,
    gnss_stream_enabled: codec.bool,
    filter_stream_enabled: codec.bool,
    imu_dropped_packets: codec.u32,
    gnss_dropped_packets: codec.u32,
    filter_dropped_packets: codec.u32,
    comm_port_bytes_written: codec.u32,
    comm_port_bytes_read: codec.u32,
    comm_port_write_overruns: codec.u32,
    comm_port_read_overruns: codec.u32,
    imu_parser_errors: codec.u32,
    imu_message_count: codec.u32,
    imu_last_message_time: codec.u32,
    gnss_parser_errors: codec.u32,
    gnss_message_count: codec.u32,
    gnss_last_message_time: codec.u32,
}, {
    fits: [77, 79, [[2, [2]]]],
});

export const DeviceStatusDiagnosticGq4_45Response = /* @__PURE__ */ field.response("3dm.device_status_diagnostic_gq4_45_response", 0x0c, 0x90, {
    model_number: codec.u16,
    status_selector: /* @__PURE__ */ codec.constant(codec.u8, 2),
    status_flags: codec.u32,
    system_state: codec.u16,
    system_timer: codec.u32,
    gnss_power_state: codec.u8,
    pps_count: codec.u32,
    pps_last_time: codec.u32,
    imu_stream_enabled: codec.bool,
    gnss_stream_enabled: codec.bool,
    filter_stream_enabled: codec.bool,
    imu_dropped_packets: codec.u32,
    gnss_dropped_packets: codec.u32,
    filter_dropped_packets: codec.u32,
    comm_port_bytes_written: codec.u32,
    comm_port_bytes_read: codec.u32,
    comm_port_write_overruns: codec.u32,
    comm_port_read_overruns: codec.u32,
    imu_parser_errors: codec.u32,
    imu_message_count: codec.u32,
    imu_last_message_time: codec.u32,
    gnss_parser_errors: codec.u32,
    gnss_message_count: codec.u32,
    gnss_last_message_time: codec.u32,
    mag_init_failed: codec.bool,
    pressure_init_failed: codec.bool,
    receiver_init_failed: codec.bool,
}, {
    fits: [80, 85, [[2, [2]]]],
});

export const DeviceStatusDiagnosticRq1_45Response = /* @__PURE__ */ field.response("3dm.device_status_diagnostic_rq1_45_response", 0x0c, 0x90, {
    model_number: codec.u16,
    status_selector: /* @__PURE__ */ codec.constant(codec.u8, 2),
    status_flags: codec.u32,
    system_state: codec.u16,
    system_timer: codec.u32,
    gnss_power_state: codec.u8,
    cold_start_on_power_on: codec.u8,
    temperature: codec.float,
    temperature_last_time: codec.u32,
    pps_count: codec.u32,
    pps_last_time: codec.u32,
    imu_stream_enabled: codec.bool,
    gnss_stream_enabled: codec.bool,
    filter_stream_enabled: codec.bool,
    imu_dropped_packets: codec.u32,
    gnss_dropped_packets: codec.u32,
    filter_dropped_packets: codec.u32,
    comm_port_bytes_written: codec.u32,
    comm_port_bytes_read: codec.u32,
    comm_port_write_overruns: codec.u32,
    comm_port_read_overruns: codec.u32,
    imu_parser_errors: codec.u32,
    imu_message_count: codec.u32,
    imu_last_message_time: codec.u32,
    gnss_parser_errors: codec.u32,
    gnss_message_count: codec.u32,
    gnss_last_message_time: codec.u32,
}, {
    fits: [86, 104, [[2, [2]]]],
});

export const DeviceStatusDiagnosticGx4Response = /* @__PURE__ */ field.response("3dm.device_status_diagnostic_gx4_response", 0x0c, 0x90, {
    model_number: codec.u16,
    status_selector: /* @__PURE__ */ codec.constant(codec.u8, 2),
    status_flags: codec.u32,
    system_timer: codec.u32,
    pps_count: codec.u32,
    pps_last_time: codec.u32,
    imu_stream_enabled: codec.bool,
    filter_stream_enabled: codec.bool,
    imu_dropped_packets: codec.u32,
    filter_dropped_packets: codec.u32,
    comm_port_bytes_written: codec.u32,
    comm_port_bytes_read: codec.u32,
    comm_port_write_overruns: codec.u32,
    comm_port_read_overruns: codec.u32,
    usb_bytes_written: codec.u32,
    usb_bytes_read: codec.u32,
    usb_write_overruns: codec.u32,
    usb_read_overruns: codec.u32,
    imu_parser_errors: codec.u32,
    imu_message_count: codec.u32,
    imu_last_message_time: codec.u32,
}, {
    fits: [73, 76, [[2, [2]]]],
});

export const DeviceStatusDiagnosticImuResponse = /* @__PURE__ */ field.response("3dm.device_status_diagnostic_imu_response", 0x0c, 0x90, {
    model_number: codec.u16,
    status_selector: /* @__PURE__ */ codec.constant(codec.u8, 2),
    status_flags: codec.u32,
    system_timer: codec.u32,
    has_mag: codec.bool,
    has_pressure: codec.bool,
    power_state: codec.u8,
    gyro_range: codec.u16,
    accel_range: codec.u16,
    reserved: /* @__PURE__ */ codec.reserved(codec.u32, 0),
    temperature: codec.float,
    temperature_last_time: codec.u32,
    temperature_error: codec.u8,
    pps_count: codec.u32,
    pps_last_time: codec.u32,
    imu_stream_enabled: codec.bool,
    imu_dropped_packets: codec.u32,
    comm_port_bytes_written: codec.u32,
    comm_port_bytes_read: codec.u32,
    comm_port_write_overruns: codec.u32,
    comm_port_read_overruns: codec.u32,
}, {
    fits: [60, 60, [[2, [2]]]],
});

export const DeviceStatusDiagnosticGx4ImuResponse = /* @__PURE__ */ field.response("3dm.device_status_diagnostic_gx4_imu_response", 0x0c, 0x90, {
    model_number: codec.u16,
    status_selector: /* @__PURE__ */ codec.constant(codec.u8, 2),
    status_flags: codec.u32,
    system_timer: codec.u32,
    has_mag: codec.bool,
    has_pressure: codec.bool,
    gyro_range: codec.u16,
    accel_range: codec.u8,
    mag_range: codec.float,
    pressure_range: codec.float,
    temperature: codec.float,
    temperature_last_time: codec.u32,
    temperature_error: codec.u8,
    pps_count: codec.u32,
    pps_last_time: codec.u32,
    imu_stream_enabled: codec.bool,
    imu_dropped_packets: codec.u32,
    comm_port_bytes_written: codec.u32,
    comm_port_bytes_read: codec.u32,
    comm_port_write_overruns: codec.u32,
    comm_port_read_overruns: codec.u32,
}, {
    fits: [62, 72, [[2, [2]]]],
});

export const DeviceStatusDiagnosticRq1ImuResponse = /* @__PURE__ */ field.response("3dm.device_status_diagnostic_rq1_imu_response", 0x0c, 0x90, {
    model_number: codec.u16,
    status_selector: /* @__PURE__ */ codec.constant(codec.u8, 2),
    status_flags: codec.u32,
    system_timer: codec.u64,
    temperature: codec.float,
    temperature_last_time: codec.u32,
    bad_temperature_sensor_detected: codec.bool,
    cold_temperature_detected: codec.bool,
    bad_voltage_detected: codec.bool,
    pps_count: codec.u32,
    pps_last_time: codec.u32,
    imu_stream_enabled: codec.bool,
    imu_dropped_packets: codec.u32,
    comm_port_state: codec.u16,
    comm_port_baud_rate: codec.u32,
    comm_port_bytes_written: codec.u32,
    comm_port_bytes_read: codec.u32,
    comm_port_write_overruns: codec.u32,
    comm_port_read_overruns: codec.u32,
}, {
    fits: [61, 61, [[2, [2]]]],
});

export const DeviceStatusBasicGx3Response = /* @__PURE__ */ field.response("3dm.device_status_basic_gx3_response", 0x0c, 0x90, {
    model_number: codec.u16,
    status_selector: /* @__PURE__ */ codec.constant(codec.u8, 1),
    comm_mode: codec.u8,
    comm_device: codec.u8,
    settings_flags: codec.u32,
    comm_state: codec.u16,
    comm_baud_rate: codec.u32,
}, {
    fits: [15, 253, [[2, [1]]]],
});

export const DeviceStatusDiagnosticGx3Response = /* @__PURE__ */ field.response("3dm.device_status_diagnostic_gx3_response", 0x0c, 0x90, {
    model_number: codec.u16,
    status_selector: /* @__PURE__ */ codec.constant(codec.u8, 2),
    comm_mode: codec.u8,
    comm_device: codec.u8,
    settings_flags: codec.u32,
    comm_state: codec.u16,
    comm_baud_rate: codec.u32,
    comm_port_bytes_written: codec.u32,
    comm_port_bytes_read: codec.u32,
    comm_port_write_overruns: codec.u32,
    comm_port_read_overruns: codec.u32,
    usb_state: codec.u16,
    usb_bytes_written: codec.u32,
    usb_bytes_read: codec.u32,
    usb_write_overruns: codec.u32,
    usb_read_overruns: codec.u32,
    gnss_driver_state: codec.u16,
    gnss_port_state: codec.u16,
    gnss_bytes_written: codec.u32,
    gnss_bytes_read: codec.u32,
    gnss_write_overruns: codec.u32,
    gnss_read_overruns: codec.u32,
    gnss_message_count: codec.u32,
    gnss_delayed_message_count: codec.u32,
    imu_driver_state: codec.u16,
    imu_port_state: codec.u16,
    imu_bytes_written: codec.u32,
    imu_bytes_read: codec.u32,
    imu_write_overruns: codec.u32,
    imu_read_overruns: codec.u32,
    imu_message_count: codec.u32,
    imu_delayed_message_count: codec.u32,
}, {
    fits: [105, 253, [[2, [2]]]],
});

export const GpsDynamicsModeResponse = /* @__PURE__ */ field.response("3dm.gps_dynamics_mode_response", 0x0c, 0x92, {
    mode: ReceiverDynamics,
});

export const ImuTimestampResponse = /* @__PURE__ */ field.response("3dm.imu_timestamp_response", 0x0c, 0x93, {
    selector: ImuTimestampSelector,
    time: codec.u32,
});

export const ComplementaryFilterResponse = /* @__PURE__ */ field.response("3dm.complementary_filter_response", 0x0c, 0x97, {
    pitch_roll_enable: codec.bool,
    heading_enable: codec.bool,
    pitch_roll_time_constant: codec.float,
    heading_time_constant: codec.float,
});

export const AccelBiasResponse = /* @__PURE__ */ field.response("3dm.accel_bias_response", 0x0c, 0x9a, {
    bias: types.Vector3f,
});

export const GyroBiasResponse = /* @__PURE__ */ field.response("3dm.gyro_bias_response", 0x0c, 0x9b, {
    bias: types.Vector3f,
});

export const MagHardIronOffsetResponse = /* @__PURE__ */ field.response("3dm.mag_hard_iron_offset_response", 0x0c, 0x9c, {
    offset: types.Vector3f,
});

export const MagSoftIronMatrixResponse = /* @__PURE__ */ field.response("3dm.mag_soft_iron_matrix_response", 0x0c, 0x9d, {
    matrix: types.Matrix3f,
});

export const ConingScullingEnableResponse = /* @__PURE__ */ field.response("3dm.coning_sculling_enable_response", 0x0c, 0x9e, {
    enable: codec.bool,
});

export const ConstellationSettingsResponse = /* @__PURE__ */ field.response("3dm.constellation_settings_response", 0x0c, 0xa0, {
    max_channels_available: codec.u16,
    max_channels_use: codec.u16,
    config_count: /* @__PURE__ */ codec.counter(codec.u8, "settings"),
    settings: /* @__PURE__ */ codec.counted("config_count", ConstellationSettingsEntry, 41),
});

export const GnssSbasSettingsResponse = /* @__PURE__ */ field.response("3dm.gnss_sbas_settings_response", 0x0c, 0xa1, {
    enable_sbas: codec.u8,
    sbas_options: SbasOptions,
    num_included_prns: /* @__PURE__ */ codec.counter(codec.u8, "included_prns"),
    included_prns: /* @__PURE__ */ codec.counted("num_included_prns", codec.u16, 124),
});

export const GnssAssistedFixResponse = /* @__PURE__ */ field.response("3dm.gnss_assisted_fix_response", 0x0c, 0xa2, {
    option: AssistedFixOption,
    flags: /* @__PURE__ */ codec.reserved(codec.u8, 255),
});

export const GnssTimeAssistanceResponse = /* @__PURE__ */ field.response("3dm.gnss_time_assistance_response", 0x0c, 0xa3, {
    tow: codec.double,
    week_number: codec.u16,
    accuracy: codec.float,
});

export const PpsSourceControlResponse = /* @__PURE__ */ field.response("3dm.pps_source_control_response", 0x0c, 0xa8, {
    source: PpsSource,
});

export const SensorToVehicleTransformEulerResponse = /* @__PURE__ */ field.response("3dm.sensor_to_vehicle_transform_euler_response", 0x0c, 0xb1, {
    roll: codec.float,
    pitch: codec.float,
    yaw: codec.float,
});

export const SensorToVehicleTransformQuaternionResponse = /* @__PURE__ */ field.response("3dm.sensor_to_vehicle_transform_quaternion_response", 0x0c, 0xb2, {
    q: types.Quatf,
});

export const SensorToVehicleTransformDcmResponse = /* @__PURE__ */ field.response("3dm.sensor_to_vehicle_transform_dcm_response", 0x0c, 0xb3, {
    dcm: types.Matrix3f,
});

export const GetEventSupportResponse = /* @__PURE__ */ field.response("3dm.get_event_support_response", 0x0c, 0xb4, {
    query: EventSupportQuery,
    max_instances: codec.u8,
    num_entries: /* @__PURE__ */ codec.counter(codec.u8, "entries"),
    entries: /* @__PURE__ */ codec.counted("num_entries", EventSupportInfo, 125),
});

export const EventControlResponse = /* @__PURE__ */ field.response("3dm.event_control_response", 0x0c, 0xb5, {
    instance: codec.u8,
    mode: types.EventTriggerMode,
});

export const GetEventTriggerStatusResponse = /* @__PURE__ */ field.response("3dm.get_event_trigger_status_response", 0x0c, 0xb6, {
    count: /* @__PURE__ */ codec.counter(codec.u8, "triggers"),
    triggers: /* @__PURE__ */ codec.counted("count", EventTriggerStatusEntry, 126),
});

export const GetEventActionStatusResponse = /* @__PURE__ */ field.response("3dm.get_event_action_status_response", 0x0c, 0xb7, {
    count: /* @__PURE__ */ codec.counter(codec.u8, "actions"),
    actions: /* @__PURE__ */ codec.counted("count", EventActionStatusEntry, 126),
});

export const EventTriggerConfigResponse = /* @__PURE__ */ field.response("3dm.event_trigger_config_response", 0x0c, 0xb8, {
    instance: codec.u8,
    type: types.EventTriggerType,
    parameters: /* @__PURE__ */ codec.union("type", [[1, "gpio", types.EventTriggerGpio], [2, "threshold", types.EventTriggerThreshold], [3, "combination", types.EventTriggerCombination]]),
});

export const EventActionConfigResponse = /* @__PURE__ */ field.response("3dm.event_action_config_response", 0x0c, 0xb9, {
    instance: codec.u8,
    trigger: codec.u8,
    type: types.EventActionType,
    parameters: /* @__PURE__ */ codec.union("type", [[1, "gpio", types.EventActionGpio], [2, "message", types.EventActionMessage]]),
});

export const GpioConfigResponse = /* @__PURE__ */ field.response("3dm.gpio_config_response", 0x0c, 0xc1, {
    pin: codec.u8,
    feature: types.GpioFeature,
    behavior: codec.u8,
    pin_mode: types.GpioPinMode,
});

export const GpioStateResponse = /* @__PURE__ */ field.response("3dm.gpio_state_response", 0x0c, 0xc2, {
    pin: codec.u8,
    state: codec.bool,
});

export const OdometerConfigResponse = /* @__PURE__ */ field.response("3dm.odometer_config_response", 0x0c, 0xc3, {
    mode: OdometerMode,
    scaling: codec.float,
    uncertainty: codec.float,
});

export const SensorRangeResponse = /* @__PURE__ */ field.response("3dm.sensor_range_response", 0x0c, 0xd2, {
    sensor: SensorRangeType,
    setting: codec.u8,
});

export const GetCalibratedSensorRangesResponse = /* @__PURE__ */ field.response("3dm.get_calibrated_sensor_ranges_response", 0x0c, 0xd3, {
    sensor: SensorRangeType,
    num_ranges: /* @__PURE__ */ codec.counter(codec.u8, "ranges"),
    ranges: /* @__PURE__ */ codec.counted("num_ranges", SensorRangeEntry, 50),
});

export const LowPassFilterResponse = /* @__PURE__ */ field.response("3dm.low_pass_filter_response", 0x0c, 0xd4, {
    descriptor_set: codec.u8,
    field_descriptor: codec.u8,
    enable: codec.bool,
    manual: codec.bool,
    frequency: codec.float,
});

export const PollImuData = /* @__PURE__ */ field.command("3dm.poll_imu_data", 0x0c, 0x01, {
    suppress_ack: codec.bool,
    num_descriptors: /* @__PURE__ */ codec.counter(codec.u8, "descriptors"),
    descriptors: /* @__PURE__ */ codec.counted("num_descriptors", PollEntry, 83),
}, {
    SILENT: [[], [["suppress_ack", 1, true]]],
});

export const PollGnssData = /* @__PURE__ */ field.command("3dm.poll_gnss_data", 0x0c, 0x02, {
    suppress_ack: codec.bool,
    num_descriptors: /* @__PURE__ */ codec.counter(codec.u8, "descriptors"),
    descriptors: /* @__PURE__ */ codec.counted("num_descriptors", PollEntry, 83),
}, {
    SILENT: [[], [["suppress_ack", 1, true]]],
});

export const PollFilterData = /* @__PURE__ */ field.command("3dm.poll_filter_data", 0x0c, 0x03, {
    suppress_ack: codec.bool,
    num_descriptors: /* @__PURE__ */ codec.counter(codec.u8, "descriptors"),
    descriptors: /* @__PURE__ */ codec.counted("num_descriptors", PollEntry, 83),
}, {
    SILENT: [[], [["suppress_ack", 1, true]]],
});

export const PollNmeaData = /* @__PURE__ */ field.command("3dm.poll_nmea_data", 0x0c, 0x04, {
    suppress_ack: codec.bool,
    count: /* @__PURE__ */ codec.counter(codec.u8, "format_entries"),
    format_entries: /* @__PURE__ */ codec.counted("count", types.NmeaMessage, 50),
}, {
    SILENT: [[], [["suppress_ack", 1, true]]],
});

export const GetImuBaseRate = /* @__PURE__ */ field.command("3dm.get_imu_base_rate", 0x0c, 0x06, {}, {
    REPLIES: [[null, [], [GetImuBaseRateResponse]]],
});

export const GetGnssBaseRate = /* @__PURE__ */ field.command("3dm.get_gnss_base_rate", 0x0c, 0x07, {}, {
    REPLIES: [[null, [], [GetGnssBaseRateResponse]]],
});

export const ImuMessageFormat = /* @__PURE__ */ field.command("3dm.imu_message_format", 0x0c, 0x08, {
    function: FunctionSelector,
    num_descriptors: /* @__PURE__ */ codec.counter(codec.u8, "descriptors"),
    descriptors: /* @__PURE__ */ codec.counted("num_descriptors", types.DescriptorRate, 83),
}, {
    calls: { 1: 2, 2: 0, 3: 0, 4: 0, 5: 0 },
    REPLIES: [[[2], [], [ImuMessageFormatResponse]]],
});

export const GnssMessageFormat = /* @__PURE__ */ field.command("3dm.gnss_message_format", 0x0c, 0x09, {
    function: FunctionSelector,
    num_descriptors: /* @__PURE__ */ codec.counter(codec.u8, "descriptors"),
    descriptors: /* @__PURE__ */ codec.counted("num_descriptors", types.DescriptorRate, 83),
}, {
    calls: { 1: 2, 2: 0, 3: 0, 4: 0, 5: 0 },
    REPLIES: [[[2], [], [GnssMessageFormatResponse]]],
});

export const FilterMessageFormat = /* @__PURE__ */ field.command("3dm.filter_message_format", 0x0c, 0x0a, {
    function: FunctionSelector,
    num_descriptors: /* @__PURE__ */ codec.counter(codec.u8, "descriptors"),
    descriptors: /* @__PURE__ */ codec.counted("num_descriptors", types.DescriptorRate, 83),
}, {
    calls: { 1: 2, 2: 0, 3: 0, 4: 0, 5: 0 },
    REPLIES: [[[2], [], [FilterMessageFormatResponse]]],
});

export const GetFilterBaseRate = /* @__PURE__ */ field.command("3dm.get_filter_base_rate", 0x0c, 0x0b, {}, {
    REPLIES: [[null, [], [GetFilterBaseRateResponse]]],
});

export const NmeaMessageFormat = /* @__PURE__ */ field.command("3dm.nmea_message_format", 0x0c, 0x0c, {
    function: FunctionSelector,
    count: /* @__PURE__ */ codec.counter(codec.u8, "format_entries"),
    format_entries: /* @__PURE__ */ codec.counted("count", types.NmeaMessage, 50),
}, {
    calls: { 1: 2, 2: 0, 3: 0, 4: 0, 5: 0 },
    REPLIES: [[[2], [], [NmeaMessageFormatResponse]]],
});

export const PollData = /* @__PURE__ */ field.command("3dm.poll_data", 0x0c, 0x0d, {
    descriptor_set: codec.u8,
    suppress_ack: codec.bool,
    num_descriptors: /* @__PURE__ */ codec.counter(codec.u8, "descriptors"),
    descriptors: /* @__PURE__ */ codec.counted("num_descriptors", codec.u8, 250),
}, {
    SILENT: [[], [["suppress_ack", 1, true]]],
});

export const GetBaseRate = /* @__PURE__ */ field.command("3dm.get_base_rate", 0x0c, 0x0e, {
    descriptor_set: codec.u8,
}, {
    REPLIES: [[null, [], [GetBaseRateResponse]]],
});

export const MessageFormat = /* @__PURE__ */ field.command("3dm.message_format", 0x0c, 0x0f, {
    function: FunctionSelector,
    descriptor_set: codec.u8,
    num_descriptors: /* @__PURE__ */ codec.counter(codec.u8, "descriptors"),
    descriptors: /* @__PURE__ */ codec.counted("num_descriptors", types.DescriptorRate, 83),
}, {
    calls: { 1: 3, 2: 1, 3: 1, 4: 1, 5: 1 },
    REPLIES: [[[2], [], [MessageFormatResponse]]],
});

export const FactoryStreaming = /* @__PURE__ */ field.command("3dm.factory_streaming", 0x0c, 0x10, {
    action: FactoryStreamingAction,
    reserved: /* @__PURE__ */ codec.reserved(codec.u8, 0),
});

export const DataStreamControl = /* @__PURE__ */ field.command("3dm.data_stream_control", 0x0c, 0x11, {
    function: FunctionSelector,
    descriptor_set: codec.u8,
    enable: codec.bool,
}, {
    calls: { 1: 2, 2: 1, 3: 1, 4: 1, 5: 1 },
    REPLIES: [[[2], [], [DataStreamControlResponse]]],
});

export const RawRtcm2_3Message = /* @__PURE__ */ field.command("3dm.raw_rtcm_2_3_message", 0x0c, 0x20, {
    data: /* @__PURE__ */ codec.rest(codec.u8, 253),
});

export const ConstellationSettings = /* @__PURE__ */ field.command("3dm.constellation_settings", 0x0c, 0x21, {
    function: FunctionSelector,
    max_channels: codec.u16,
    config_count: /* @__PURE__ */ codec.counter(codec.u8, "settings"),
    settings: /* @__PURE__ */ codec.counted("config_count", ConstellationSettingsEntry, 41),
}, {
    calls: { 1: 3, 2: 0, 3: 0, 4: 0, 5: 0 },
    REPLIES: [[[2], [], [ConstellationSettingsResponse]]],
});

export const GnssSbasSettings = /* @__PURE__ */ field.command("3dm.gnss_sbas_settings", 0x0c, 0x22, {
    function: FunctionSelector,
    enable_sbas: codec.u8,
    sbas_options: SbasOptions,
    num_included_prns: /* @__PURE__ */ codec.counter(codec.u8, "included_prns"),
    included_prns: /* @__PURE__ */ codec.counted("num_included_prns", codec.u16, 124),
}, {
    calls: { 1: 4, 2: 0, 3: 0, 4: 0, 5: 0 },
    REPLIES: [[[2], [], [GnssSbasSettingsResponse]]],
});

export const GnssAssistedFix = /* @__PURE__ */ field.command("3dm.gnss_assisted_fix", 0x0c, 0x23, {
    function: FunctionSelector,
    option: AssistedFixOption,
    flags: /* @__PURE__ */ codec.reserved(codec.u8, 255),
}, {
    calls: { 1: 2, 2: 0, 3: 0, 4: 0, 5: 0 },
    REPLIES: [[[2], [], [GnssAssistedFixResponse]]],
});

export const GnssTimeAssistance = /* @__PURE__ */ field.command("3dm.gnss_time_assistance", 0x0c, 0x24, {
    function: FunctionSelector,
    tow: codec.double,
    week_number: codec.u16,
    accuracy: codec.float,
}, {
    calls: { 1: 3, 2: 0 },
    REPLIES: [[[2], [], [GnssTimeAssistanceResponse]]],
});

export const PpsSourceControl = /* @__PURE__ */ field.command("3dm.pps_source_control", 0x0c, 0x28, {
    function: FunctionSelector,
    source: PpsSource,
}, {
    calls: { 1: 1, 2: 0, 3: 0, 4: 0, 5: 0 },
    REPLIES: [[[2], [], [PpsSourceControlResponse]]],
});

export const GetEventSupport = /* @__PURE__ */ field.command("3dm.get_event_support", 0x0c, 0x2a, {
    query: EventSupportQuery,
}, {
    REPLIES: [[null, [], [GetEventSupportResponse]]],
});

export const EventControl = /* @__PURE__ */ field.command("3dm.event_control", 0x0c, 0x2b, {
    function: FunctionSelector,
    instance: codec.u8,
    mode: types.EventTriggerMode,
}, {
    calls: { 1: 2, 2: 1, 3: 1, 4: 1, 5: 1 },
    REPLIES: [[[2], [], [EventControlResponse]]],
});

export const GetEventTriggerStatus = /* @__PURE__ */ field.command("3dm.get_event_trigger_status", 0x0c, 0x2c, {
    requested_count: /* @__PURE__ */ codec.counter(codec.u8, "requested_instances"),
    requested_instances: /* @__PURE__ */ codec.counted("requested_count", codec.u8, 252),
}, {
    REPLIES: [[null, [], [GetEventTriggerStatusResponse]]],
});

export const GetEventActionStatus = /* @__PURE__ */ field.command("3dm.get_event_action_status", 0x0c, 0x2d, {
    requested_count: /* @__PURE__ */ codec.counter(codec.u8, "requested_instances"),
    requested_instances: /* @__PURE__ */ codec.counted("requested_count", codec.u8, 252),
}, {
    REPLIES: [[null, [], [GetEventActionStatusResponse]]],
});

export const EventTriggerConfig = /* @__PURE__ */ field.command("3dm.event_trigger_config", 0x0c, 0x2e, {
    function: FunctionSelector,
    instance: codec.u8,
    type: types.EventTriggerType,
    parameters: /* @__PURE__ */ codec.union("type", [[1, "gpio", types.EventTriggerGpio], [2, "threshold", types.EventTriggerThreshold], [3, "combination", types.EventTriggerCombination]]),
}, {
    calls: { 1: 3, 2: 1, 3: 1, 4: 1, 5: 1 },
    REPLIES: [[[2], [], [EventTriggerConfigResponse]]],
});

export const EventActionConfig = /* @__PURE__ */ field.command("3dm.event_action_config", 0x0c, 0x2f, {
    function: FunctionSelector,
    instance: codec.u8,
    trigger: codec.u8,
    type: types.EventActionType,
    parameters: /* @__PURE__ */ codec.union("type", [[1, "gpio", types.EventActionGpio], [2, "message", types.EventActionMessage]]),
}, {
    calls: { 1: 4, 2: 1, 3: 1, 4: 1, 5: 1 },
    REPLIES: [[[2], [], [EventActionConfigResponse]]],
});

export const DeviceSettings = /* @__PURE__ */ field.command("3dm.device_settings", 0x0c, 0x30, {
    function: FunctionSelector,
}, {
    calls: { 3: 0, 4: 0, 5: 0 },
    TIMEOUT: 2,
});

export const SensorToVehicleTransformEuler = /* @__PURE__ */ field.command("3dm.sensor_to_vehicle_transform_euler", 0x0c, 0x31, {
    function: FunctionSelector,
    roll: codec.float,
    pitch: codec.float,
    yaw: codec.float,
}, {
    calls: { 1: 3, 2: 0, 3: 0, 4: 0, 5: 0 },
    REPLIES: [[[2], [], [SensorToVehicleTransformEulerResponse]]],
});

export const SensorToVehicleTransformQuaternion = /* @__PURE__ */ field.command("3dm.sensor_to_vehicle_transform_quaternion", 0x0c, 0x32, {
    function: FunctionSelector,
    q: types.Quatf,
}, {
    calls: { 1: 1, 2: 0, 3: 0, 4: 0, 5: 0 },
    REPLIES: [[[2], [], [SensorToVehicleTransformQuaternionResponse]]],
});

export const SensorToVehicleTransformDcm = /* @__PURE__ */ field.command("3dm.sensor_to_vehicle_transform_dcm", 0x0c, 0x33, {
    function: FunctionSelector,
    dcm: types.Matrix3f,
}, {
    calls: { 1: 1, 2: 0, 3: 0, 4: 0, 5: 0 },
    REPLIES: [[[2], [], [SensorToVehicleTransformDcmResponse]]],
});

export const GpsDynamicsMode = /* @__PURE__ */ field.command("3dm.gps_dynamics_mode", 0x0c, 0x34, {
    function: FunctionSelector,
    mode: ReceiverDynamics,
}, {
    calls: { 1: 1, 2: 0, 3: 0, 4: 0, 5: 0 },
    REPLIES: [[[2], [], [GpsDynamicsModeResponse]]],
});

export const ImuSignalConditioning = /* @__PURE__ */ field.command("3dm.imu_signal_conditioning", 0x0c, 0x35, {
    function: FunctionSelector,
    orientation_decimation: codec.u16,
    data_conditioning_flags: DataConditioningFlags,
    inertial_filter_width: codec.u8,
    mag_filter_width: codec.u8,
    up_compensation: codec.u16,
    north_compensation: codec.u16,
    mag_bandwidth: MagBandwidth,
    reserved: /* @__PURE__ */ codec.reserved(codec.u16, 0),
}, {
    calls: { 1: 8, 2: 0, 3: 0, 4: 0, 5: 0 },
    REPLIES: [[[2], [], [ImuSignalConditioningResponse]]],
});

export const ImuTimestamp = /* @__PURE__ */ field.command("3dm.imu_timestamp", 0x0c, 0x36, {
    function: FunctionSelector,
    selector: ImuTimestampSelector,
    time: codec.u32,
}, {
    calls: { 1: 2, 2: 1 },
    REPLIES: [[[2], [], [ImuTimestampResponse]]],
});

export const AccelBias = /* @__PURE__ */ field.command("3dm.accel_bias", 0x0c, 0x37, {
    function: FunctionSelector,
    bias: types.Vector3f,
}, {
    calls: { 1: 1, 2: 0, 3: 0, 4: 0, 5: 0, 6: 1 },
    REPLIES: [[[2], [], [AccelBiasResponse]]],
    SILENT: [[6], []],
});

export const GyroBias = /* @__PURE__ */ field.command("3dm.gyro_bias", 0x0c, 0x38, {
    function: FunctionSelector,
    bias: types.Vector3f,
}, {
    calls: { 1: 1, 2: 0, 3: 0, 4: 0, 5: 0, 6: 1 },
    REPLIES: [[[2], [], [GyroBiasResponse]]],
    SILENT: [[6], []],
});

export const CaptureGyroBias = /* @__PURE__ */ field.command("3dm.capture_gyro_bias", 0x0c, 0x39, {
    averaging_time_ms: codec.u16,
}, {
    REPLIES: [[null, [], [GyroBiasResponse]]],
    TIMEOUT: 31,
});

export const MagHardIronOffset = /* @__PURE__ */ field.command("3dm.mag_hard_iron_offset", 0x0c, 0x3a, {
    function: FunctionSelector,
    offset: types.Vector3f,
}, {
    calls: { 1: 1, 2: 0, 3: 0, 4: 0, 5: 0, 6: 1 },
    REPLIES: [[[2], [], [MagHardIronOffsetResponse]]],
    SILENT: [[6], []],
});

export const MagSoftIronMatrix = /* @__PURE__ */ field.command("3dm.mag_soft_iron_matrix", 0x0c, 0x3b, {
    function: FunctionSelector,
    matrix: types.Matrix3f,
}, {
    calls: { 1: 1, 2: 0, 3: 0, 4: 0, 5: 0, 6: 1 },
    REPLIES: [[[2], [], [MagSoftIronMatrixResponse]]],
    SILENT: [[6], []],
});

export const ConingScullingEnable = /* @__PURE__ */ field.command("3dm.coning_sculling_enable", 0x0c, 0x3e, {
    function: FunctionSelector,
    enable: codec.bool,
}, {
    calls: { 1: 1, 2: 0, 3: 0, 4: 0, 5: 0 },
    REPLIES: [[[2], [], [ConingScullingEnableResponse]]],
});

export const UartBaudRate = /* @__PURE__ */ field.command("3dm.uart_baud_rate", 0x0c, 0x40, {
    function: FunctionSelector,
    baud: codec.u32,
}, {
    calls: { 1: 1, 2: 0, 3: 0, 4: 0, 5: 0 },
    REPLIES: [[[2], [], [UartBaudRateResponse]]],
});

export const GpioConfig = /* @__PURE__ */ field.command("3dm.gpio_config", 0x0c, 0x41, {
    function: FunctionSelector,
    pin: codec.u8,
    feature: types.GpioFeature,
    behavior: codec.u8,
    pin_mode: types.GpioPinMode,
}, {
    calls: { 1: 4, 2: 1, 3: 1, 4: 1, 5: 1 },
    REPLIES: [[[2], [], [GpioConfigResponse]]],
});

export const GpioState = /* @__PURE__ */ field.command("3dm.gpio_state", 0x0c, 0x42, {
    function: FunctionSelector,
    pin: codec.u8,
    state: codec.bool,
}, {
    calls: { 1: 2, 2: 1 },
    REPLIES: [[[2], [], [GpioStateResponse]]],
});

export const OdometerConfig = /* @__PURE__ */ field.command("3dm.odometer_config", 0x0c, 0x43, {
    function: FunctionSelector,
    mode: OdometerMode,
    scaling: codec.float,
    uncertainty: codec.float,
}, {
    calls: { 1: 3, 2: 0, 3: 0, 4: 0, 5: 0 },
    REPLIES: [[[2], [], [OdometerConfigResponse]]],
});

export const ImuLowPassFilter = /* @__PURE__ */ field.command("3dm.imu_low_pass_filter", 0x0c, 0x50, {
    function: FunctionSelector,
    target_descriptor: codec.u8,
    enable: codec.bool,
    manual: codec.bool,
    frequency: codec.u16,
    reserved: /* @__PURE__ */ codec.reserved(codec.u8, 0),
}, {
    calls: { 1: 5, 2: 1, 3: 1, 4: 1, 5: 1 },
    REPLIES: [[[2], [], [ImuLowPassFilterResponse]]],
});

export const ComplementaryFilter = /* @__PURE__ */ field.command("3dm.complementary_filter", 0x0c, 0x51, {
    function: FunctionSelector,
    pitch_roll_enable: codec.bool,
    heading_enable: codec.bool,
    pitch_roll_time_constant: codec.float,
    heading_time_constant: codec.float,
}, {
    calls: { 1: 4, 2: 0, 3: 0, 4: 0, 5: 0 },
    REPLIES: [[[2], [], [ComplementaryFilterResponse]]],
});

export const SensorRange = /* @__PURE__ */ field.command("3dm.sensor_range", 0x0c, 0x52, {
    function: FunctionSelector,
    sensor: SensorRangeType,
    setting: codec.u8,
}, {
    calls: { 1: 2, 2: 1, 3: 1, 4: 1, 5: 1 },
    REPLIES: [[[2], [], [SensorRangeResponse]]],
});

export const GetCalibratedSensorRanges = /* @__PURE__ */ field.command("3dm.get_calibrated_sensor_ranges", 0x0c, 0x53, {
    sensor: SensorRangeType,
}, {
    REPLIES: [[null, [], [GetCalibratedSensorRangesResponse]]],
});

export const LowPassFilter = /* @__PURE__ */ field.command("3dm.low_pass_filter", 0x0c, 0x54, {
    function: FunctionSelector,
    descriptor_set: codec.u8,
    field_descriptor: codec.u8,
    enable: codec.bool,
    manual: codec.bool,
    frequency: codec.float,
}, {
    calls: { 1: 5, 2: 2, 3: 2, 4: 2, 5: 2 },
    REPLIES: [[[2], [], [LowPassFilterResponse]]],
});

export const DataStreamFormat = /* @__PURE__ */ field.command("3dm.data_stream_format", 0x0c, 0x60, {
    function: FunctionSelector,
    stream: InternalSensor,
    format: StreamFormat,
}, {
    calls: { 1: 2, 2: 2, 3: 2, 4: 2, 5: 2 },
    REPLIES: [[[2], [], [DataStreamFormatResponse]]],
});

export const DevicePowerState = /* @__PURE__ */ field.command("3dm.device_power_state", 0x0c, 0x61, {
    function: FunctionSelector,
    device: InternalSensor,
    state: SensorPowerState,
}, {
    calls: { 1: 2, 2: 1, 3: 1, 4: 1, 5: 1 },
    REPLIES: [[[2], [], [DevicePowerStateResponse]]],
    TIMEOUT: 5,
});

export const GpsAdvancedSettings = /* @__PURE__ */ field.command("3dm.gps_advanced_settings", 0x0c, 0x62, {
    function: FunctionSelector,
}, {
    calls: { 3: 0, 4: 0, 5: 0 },
});

export const DeviceStatus = /* @__PURE__ */ field.command("3dm.device_status", 0x0c, 0x64, {
    model_number: codec.u16,
    status_selector: DeviceStatusSelector,
}, {
    REPLIES: [[null, [["status_selector", 1, false]], [DeviceStatusBasicRq1ImuResponse, DeviceStatusBasicResponse, DeviceStatusBasicWithoutStateResponse, DeviceStatusBasicGx3Response]], [null, [["status_selector", 2, false]], [DeviceStatusDiagnosticResponse, DeviceStatusDiagnosticGnssResponse, DeviceStatusDiagnosticGq4_45Response, DeviceStatusDiagnosticRq1_45Response, DeviceStatusDiagnosticGx4Response, DeviceStatusDiagnosticImuResponse, DeviceStatusDiagnosticGx4ImuResponse, DeviceStatusDiagnosticRq1ImuResponse, DeviceStatusDiagnosticGx3Response]]],
});
