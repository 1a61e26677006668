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
    constellationId: ConstellationId,
    enable: codec.u8,
    reservedChannels: codec.u8,
    maxChannels: codec.u8,
    optionFlags: ConstellationOptions,
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
    actionType: types.EventActionType,
    triggerId: codec.u8,
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
    numDescriptors: /* @__PURE__ */ codec.counter(codec.u8, "descriptors"),
    descriptors: /* @__PURE__ */ codec.counted("numDescriptors", types.DescriptorRate, 84),
});

export const GnssMessageFormatResponse = /* @__PURE__ */ field.response("3dm.gnss_message_format_response", 0x0c, 0x81, {
    numDescriptors: /* @__PURE__ */ codec.counter(codec.u8, "descriptors"),
    descriptors: /* @__PURE__ */ codec.counted("numDescriptors", types.DescriptorRate, 84),
});

export const FilterMessageFormatResponse = /* @__PURE__ */ field.response("3dm.filter_message_format_response", 0x0c, 0x82, {
    numDescriptors: /* @__PURE__ */ codec.counter(codec.u8, "descriptors"),
    descriptors: /* @__PURE__ */ codec.counted("numDescriptors", types.DescriptorRate, 84),
});

export const GetImuBaseRateResponse = /* @__PURE__ */ field.response("3dm.get_imu_base_rate_response", 0x0c, 0x83, {
    rate: codec.u16,
});

export const GetGnssBaseRateResponse = /* @__PURE__ */ field.response("3dm.get_gnss_base_rate_response", 0x0c, 0x84, {
    rate: codec.u16,
});

export const DataStreamControlResponse = /* @__PURE__ */ field.response("3dm.data_stream_control_response", 0x0c, 0x85, {
    descriptorSet: codec.u8,
    enabled: codec.bool,
});

export const ImuSignalConditioningResponse = /* @__PURE__ */ field.response("3dm.imu_signal_conditioning_response", 0x0c, 0x86, {
    orientationDecimation: codec.u16,
    dataConditioningFlags: DataConditioningFlags,
    inertialFilterWidth: codec.u8,
    magFilterWidth: codec.u8,
    upCompensation: codec.u16,
    northCompensation: codec.u16,
    magBandwidth: MagBandwidth,
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
    targetDescriptor: codec.u8,
    enable: codec.bool,
    manual: codec.bool,
    frequency: codec.u16,
    reserved: /* @__PURE__ */ codec.reserved(codec.u8, 0),
});

export const NmeaMessageFormatResponse = /* @__PURE__ */ field.response("3dm.nmea_message_format_response", 0x0c, 0x8c, {
    count: /* @__PURE__ */ codec.counter(codec.u8, "formatEntries"),
    formatEntries: /* @__PURE__ */ codec.counted("count", types.NmeaMessage, 50),
});

export const GetBaseRateResponse = /* @__PURE__ */ field.response("3dm.get_base_rate_response", 0x0c, 0x8e, {
    descriptorSet: codec.u8,
    rate: codec.u16,
});

export const MessageFormatResponse = /* @__PURE__ */ field.response("3dm.message_format_response", 0x0c, 0x8f, {
    descriptorSet: codec.u8,
    numDescriptors: /* @__PURE__ */ codec.counter(codec.u8, "descriptors"),
    descriptors: /* @__PURE__ */ codec.counted("numDescriptors", types.DescriptorRate, 83),
});

export const DeviceStatusBasicRq1ImuResponse = /* @__PURE__ */ field.response("3dm.device_status_basic_rq1_imu_response", 0x0c, 0x90, {
    modelNumber: /* @__PURE__ */ codec.constant(codec.u16, 6238),
    statusSelector: /* @__PURE__ */ codec.constant(codec.u8, 1),
    statusFlags: codec.u32,
    systemTimer: codec.u64,
}, {
    fits: [15, 253, [[0, [24, 94]], [2, [1]]]],
});

export const DeviceStatusBasicResponse = /* @__PURE__ */ field.response("3dm.device_status_basic_response", 0x0c, 0x90, {
    modelNumber: codec.u16,
    statusSelector: /* @__PURE__ */ codec.constant(codec.u8, 1),
    statusFlags: codec.u32,
    systemState: codec.u16,
    systemTimer: codec.u32,
}, {
    fits: [13, 14, [[2, [1]]]],
});

export const DeviceStatusBasicWithoutStateResponse = /* @__PURE__ */ field.response("3dm.device_status_basic_without_state_response", 0x0c, 0x90, {
    modelNumber: codec.u16,
    statusSelector: /* @__PURE__ */ codec.constant(codec.u8, 1),
    statusFlags: codec.u32,
    systemTimer: codec.u32,
}, {
    fits: [0, 12, [[2, [1]]]],
});

export const DeviceStatusDiagnosticResponse = /* @__PURE__ */ field.response("3dm.device_status_diagnostic_response", 0x0c, 0x90, {
    modelNumber: codec.u16,
    statusSelector: /* @__PURE__ */ codec.constant(codec.u8, 2),
    statusFlags: codec.u32,
    systemState: codec.u16,
    systemTimer: codec.u32,
    imuStreamEnabled: codec.bool,
    filterStreamEnabled: codec.bool,
    imuDroppedPackets: codec.u32,
    filterDroppedPackets: codec.u32,
    commPortBytesWritten: codec.u32,
    commPortBytesRead: codec.u32,
    commPortWriteOverruns: codec.u32,
    commPortReadOverruns: codec.u32,
    imuParserErrors: codec.u32,
    imuMessageCount: codec.u32,
    imuLastMessageTime: codec.u32,
}, {
    fits: [0, 59, [[2, [2]]]],
});

export const DeviceStatusDiagnosticGnssResponse = /* @__PURE__ */ field.response("3dm.device_status_diagnostic_gnss_response", 0x0c, 0x90, {
    modelNumber: codec.u16,
    statusSelector: /* @__PURE__ */ codec.constant(codec.u8, 2),
    statusFlags: codec.u32,
    systemState: codec.u16,
    systemTimer: codec.u32,
    gnssPowerState: codec.u8,
    ppsCount: codec.u32,
    ppsLastTime: codec.u32,
    imuStreamEnabled: codec.bool,
    gnssStreamEnabled: codec.bool,
    filterStreamEnabled: codec.bool,
    imuDroppedPackets: codec.u32,
    gnssDroppedPackets: codec.u32,
    filterDroppedPackets: codec.u32,
    commPortBytesWritten: codec.u32,
    commPortBytesRead: codec.u32,
    commPortWriteOverruns: codec.u32,
    commPortReadOverruns: codec.u32,
    imuParserErrors: codec.u32,
    imuMessageCount: codec.u32,
    imuLastMessageTime: codec.u32,
    gnssParserErrors: codec.u32,
    gnssMessageCount: codec.u32,
    gnssLastMessageTime: codec.u32,
}, {
    fits: [77, 79, [[2, [2]]]],
});

export const DeviceStatusDiagnosticGq4_45Response = /* @__PURE__ */ field.response("3dm.device_status_diagnostic_gq4_45_response", 0x0c, 0x90, {
    modelNumber: codec.u16,
    statusSelector: /* @__PURE__ */ codec.constant(codec.u8, 2),
    statusFlags: codec.u32,
    systemState: codec.u16,
    systemTimer: codec.u32,
    gnssPowerState: codec.u8,
    ppsCount: codec.u32,
    ppsLastTime: codec.u32,
    imuStreamEnabled: codec.bool,
    gnssStreamEnabled: codec.bool,
    filterStreamEnabled: codec.bool,
    imuDroppedPackets: codec.u32,
    gnssDroppedPackets: codec.u32,
    filterDroppedPackets: codec.u32,
    commPortBytesWritten: codec.u32,
    commPortBytesRead: codec.u32,
    commPortWriteOverruns: codec.u32,
    commPortReadOverruns: codec.u32,
    imuParserErrors: codec.u32,
    imuMessageCount: codec.u32,
    imuLastMessageTime: codec.u32,
    gnssParserErrors: codec.u32,
    gnssMessageCount: codec.u32,
    gnssLastMessageTime: codec.u32,
    magInitFailed: codec.bool,
    pressureInitFailed: codec.bool,
    receiverInitFailed: codec.bool,
}, {
    fits: [80, 85, [[2, [2]]]],
});

export const DeviceStatusDiagnosticRq1_45Response = /* @__PURE__ */ field.response("3dm.device_status_diagnostic_rq1_45_response", 0x0c, 0x90, {
    modelNumber: codec.u16,
    statusSelector: /* @__PURE__ */ codec.constant(codec.u8, 2),
    statusFlags: codec.u32,
    systemState: codec.u16,
    systemTimer: codec.u32,
    gnssPowerState: codec.u8,
    coldStartOnPowerOn: codec.u8,
    temperature: codec.float,
    temperatureLastTime: codec.u32,
    ppsCount: codec.u32,
    ppsLastTime: codec.u32,
    imuStreamEnabled: codec.bool,
    gnssStreamEnabled: codec.bool,
    filterStreamEnabled: codec.bool,
    imuDroppedPackets: codec.u32,
    gnssDroppedPackets: codec.u32,
    filterDroppedPackets: codec.u32,
    commPortBytesWritten: codec.u32,
    commPortBytesRead: codec.u32,
    commPortWriteOverruns: codec.u32,
    commPortReadOverruns: codec.u32,
    imuParserErrors: codec.u32,
    imuMessageCount: codec.u32,
    imuLastMessageTime: codec.u32,
    gnssParserErrors: codec.u32,
    gnssMessageCount: codec.u32,
    gnssLastMessageTime: codec.u32,
}, {
    fits: [86, 104, [[2, [2]]]],
});

export const DeviceStatusDiagnosticGx4Response = /* @__PURE__ */ field.response("3dm.device_status_diagnostic_gx4_response", 0x0c, 0x90, {
    modelNumber: codec.u16,
    statusSelector: /* @__PURE__ */ codec.constant(codec.u8, 2),
    statusFlags: codec.u32,
    systemTimer: codec.u32,
    ppsCount: codec.u32,
    ppsLastTime: codec.u32,
    imuStreamEnabled: codec.bool,
    filterStreamEnabled: codec.bool,
    imuDroppedPackets: codec.u32,
    filterDroppedPackets: codec.u32,
    commPortBytesWritten: codec.u32,
    commPortBytesRead: codec.u32,
    commPortWriteOverruns: codec.u32,
    commPortReadOverruns: codec.u32,
    usbBytesWritten: codec.u32,
    usbBytesRead: codec.u32,
    usbWriteOverruns: codec.u32,
    usbReadOverruns: codec.u32,
    imuParserErrors: codec.u32,
    imuMessageCount: codec.u32,
    imuLastMessageTime: codec.u32,
}, {
    fits: [73, 76, [[2, [2]]]],
});

export const DeviceStatusDiagnosticImuResponse = /* @__PURE__ */ field.response("3dm.device_status_diagnostic_imu_response", 0x0c, 0x90, {
    modelNumber: codec.u16,
    statusSelector: /* @__PURE__ */ codec.constant(codec.u8, 2),
    statusFlags: codec.u32,
    systemTimer: codec.u32,
    hasMag: codec.bool,
    hasPressure: codec.bool,
    powerState: codec.u8,
    gyroRange: codec.u16,
    accelRange: codec.u16,
    reserved: /* @__PURE__ */ codec.reserved(codec.u32, 0),
    temperature: codec.float,
    temperatureLastTime: codec.u32,
    temperatureError: codec.u8,
    ppsCount: codec.u32,
    ppsLastTime: codec.u32,
    imuStreamEnabled: codec.bool,
    imuDroppedPackets: codec.u32,
    commPortBytesWritten: codec.u32,
    commPortBytesRead: codec.u32,
    commPortWriteOverruns: codec.u32,
    commPortReadOverruns: codec.u32,
}, {
    fits: [60, 60, [[2, [2]]]],
});

export const DeviceStatusDiagnosticGx4ImuResponse = /* @__PURE__ */ field.response("3dm.device_status_diagnostic_gx4_imu_response", 0x0c, 0x90, {
    modelNumber: codec.u16,
    statusSelector: /* @__PURE__ */ codec.constant(codec.u8, 2),
    statusFlags: codec.u32,
    systemTimer: codec.u32,
    hasMag: codec.bool,
    hasPressure: codec.bool,
    gyroRange: codec.u16,
    accelRange: codec.u8,
    magRange: codec.float,
    pressureRange: codec.float,
    temperature: codec.float,
    temperatureLastTime: codec.u32,
    temperatureError: codec.u8,
    ppsCount: codec.u32,
    ppsLastTime: codec.u32,
    imuStreamEnabled: codec.bool,
    imuDroppedPackets: codec.u32,
    commPortBytesWritten: codec.u32,
    commPortBytesRead: codec.u32,
    commPortWriteOverruns: codec.u32,
    commPortReadOverruns: codec.u32,
}, {
    fits: [62, 72, [[2, [2]]]],
});

export const DeviceStatusDiagnosticRq1ImuResponse = /* @__PURE__ */ field.response("3dm.device_status_diagnostic_rq1_imu_response", 0x0c, 0x90, {
    modelNumber: codec.u16,
    statusSelector: /* @__PURE__ */ codec.constant(codec.u8, 2),
    statusFlags: codec.u32,
    systemTimer: codec.u64,
    temperature: codec.float,
    temperatureLastTime: codec.u32,
    badTemperatureSensorDetected: codec.bool,
    coldTemperatureDetected: codec.bool,
    badVoltageDetected: codec.bool,
    ppsCount: codec.u32,
    ppsLastTime: codec.u32,
    imuStreamEnabled: codec.bool,
    imuDroppedPackets: codec.u32,
    commPortState: codec.u16,
    commPortBaudRate: codec.u32,
    commPortBytesWritten: codec.u32,
    commPortBytesRead: codec.u32,
    commPortWriteOverruns: codec.u32,
    commPortReadOverruns: codec.u32,
}, {
    fits: [61, 61, [[2, [2]]]],
});

export const DeviceStatusBasicGx3Response = /* @__PURE__ */ field.response("3dm.device_status_basic_gx3_response", 0x0c, 0x90, {
    modelNumber: codec.u16,
    statusSelector: /* @__PURE__ */ codec.constant(codec.u8, 1),
    commMode: codec.u8,
    commDevice: codec.u8,
    settingsFlags: codec.u32,
    commState: codec.u16,
    commBaudRate: codec.u32,
}, {
    fits: [15, 253, [[2, [1]]]],
});

export const DeviceStatusDiagnosticGx3Response = /* @__PURE__ */ field.response("3dm.device_status_diagnostic_gx3_response", 0x0c, 0x90, {
    modelNumber: codec.u16,
    statusSelector: /* @__PURE__ */ codec.constant(codec.u8, 2),
    commMode: codec.u8,
    commDevice: codec.u8,
    settingsFlags: codec.u32,
    commState: codec.u16,
    commBaudRate: codec.u32,
    commPortBytesWritten: codec.u32,
    commPortBytesRead: codec.u32,
    commPortWriteOverruns: codec.u32,
    commPortReadOverruns: codec.u32,
    usbState: codec.u16,
    usbBytesWritten: codec.u32,
    usbBytesRead: codec.u32,
    usbWriteOverruns: codec.u32,
    usbReadOverruns: codec.u32,
    gnssDriverState: codec.u16,
    gnssPortState: codec.u16,
    gnssBytesWritten: codec.u32,
    gnssBytesRead: codec.u32,
    gnssWriteOverruns: codec.u32,
    gnssReadOverruns: codec.u32,
    gnssMessageCount: codec.u32,
    gnssDelayedMessageCount: codec.u32,
    imuDriverState: codec.u16,
    imuPortState: codec.u16,
    imuBytesWritten: codec.u32,
    imuBytesRead: codec.u32,
    imuWriteOverruns: codec.u32,
    imuReadOverruns: codec.u32,
    imuMessageCount: codec.u32,
    imuDelayedMessageCount: codec.u32,
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
    pitchRollEnable: codec.bool,
    headingEnable: codec.bool,
    pitchRollTimeConstant: codec.float,
    headingTimeConstant: codec.float,
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
    maxChannelsAvailable: codec.u16,
    maxChannelsUse: codec.u16,
    configCount: /* @__PURE__ */ codec.counter(codec.u8, "settings"),
    settings: /* @__PURE__ */ codec.counted("configCount", ConstellationSettingsEntry, 41),
});

export const GnssSbasSettingsResponse = /* @__PURE__ */ field.response("3dm.gnss_sbas_settings_response", 0x0c, 0xa1, {
    enableSbas: codec.u8,
    sbasOptions: SbasOptions,
    numIncludedPrns: /* @__PURE__ */ codec.counter(codec.u8, "includedPrns"),
    includedPrns: /* @__PURE__ */ codec.counted("numIncludedPrns", codec.u16, 124),
});

export const GnssAssistedFixResponse = /* @__PURE__ */ field.response("3dm.gnss_assisted_fix_response", 0x0c, 0xa2, {
    option: AssistedFixOption,
    flags: /* @__PURE__ */ codec.reserved(codec.u8, 255),
});

export const GnssTimeAssistanceResponse = /* @__PURE__ */ field.response("3dm.gnss_time_assistance_response", 0x0c, 0xa3, {
    tow: codec.double,
    weekNumber: codec.u16,
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
    maxInstances: codec.u8,
    numEntries: /* @__PURE__ */ codec.counter(codec.u8, "entries"),
    entries: /* @__PURE__ */ codec.counted("numEntries", EventSupportInfo, 125),
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
    pinMode: types.GpioPinMode,
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
    numRanges: /* @__PURE__ */ codec.counter(codec.u8, "ranges"),
    ranges: /* @__PURE__ */ codec.counted("numRanges", SensorRangeEntry, 50),
});

export const LowPassFilterResponse = /* @__PURE__ */ field.response("3dm.low_pass_filter_response", 0x0c, 0xd4, {
    descriptorSet: codec.u8,
    fieldDescriptor: codec.u8,
    enable: codec.bool,
    manual: codec.bool,
    frequency: codec.float,
});

export const PollImuData = /* @__PURE__ */ field.command("3dm.poll_imu_data", 0x0c, 0x01, {
    suppressAck: codec.bool,
    numDescriptors: /* @__PURE__ */ codec.counter(codec.u8, "descriptors"),
    descriptors: /* @__PURE__ */ codec.counted("numDescriptors", PollEntry, 83),
}, {
    SILENT: [[], [["suppressAck", 1, true]]],
});

export const PollGnssData = /* @__PURE__ */ field.command("3dm.poll_gnss_data", 0x0c, 0x02, {
    suppressAck: codec.bool,
    numDescriptors: /* @__PURE__ */ codec.counter(codec.u8, "descriptors"),
    descriptors: /* @__PURE__ */ codec.counted("numDescriptors", PollEntry, 83),
}, {
    SILENT: [[], [["suppressAck", 1, true]]],
});

export const PollFilterData = /* @__PURE__ */ field.command("3dm.poll_filter_data", 0x0c, 0x03, {
    suppressAck: codec.bool,
    numDescriptors: /* @__PURE__ */ codec.counter(codec.u8, "descriptors"),
    descriptors: /* @__PURE__ */ codec.counted("numDescriptors", PollEntry, 83),
}, {
    SILENT: [[], [["suppressAck", 1, true]]],
});

export const PollNmeaData = /* @__PURE__ */ field.command("3dm.poll_nmea_data", 0x0c, 0x04, {
    suppressAck: codec.bool,
    count: /* @__PURE__ */ codec.counter(codec.u8, "formatEntries"),
    formatEntries: /* @__PURE__ */ codec.counted("count", types.NmeaMessage, 50),
}, {
    SILENT: [[], [["suppressAck", 1, true]]],
});

export const GetImuBaseRate = /* @__PURE__ */ field.command("3dm.get_imu_base_rate", 0x0c, 0x06, {}, {
    REPLIES: [[null, [], [GetImuBaseRateResponse]]],
});

export const GetGnssBaseRate = /* @__PURE__ */ field.command("3dm.get_gnss_base_rate", 0x0c, 0x07, {}, {
    REPLIES: [[null, [], [GetGnssBaseRateResponse]]],
});

export const ImuMessageFormat = /* @__PURE__ */ field.command("3dm.imu_message_format", 0x0c, 0x08, {
    function: FunctionSelector,
    numDescriptors: /* @__PURE__ */ codec.counter(codec.u8, "descriptors"),
    descriptors: /* @__PURE__ */ codec.counted("numDescriptors", types.DescriptorRate, 83),
}, {
    calls: [, 2, 0, 0, 0, 0],
    REPLIES: [[[2], [], [ImuMessageFormatResponse]]],
});

export const GnssMessageFormat = /* @__PURE__ */ field.command("3dm.gnss_message_format", 0x0c, 0x09, {
    function: FunctionSelector,
    numDescriptors: /* @__PURE__ */ codec.counter(codec.u8, "descriptors"),
    descriptors: /* @__PURE__ */ codec.counted("numDescriptors", types.DescriptorRate, 83),
}, {
    calls: [, 2, 0, 0, 0, 0],
    REPLIES: [[[2], [], [GnssMessageFormatResponse]]],
});

export const FilterMessageFormat = /* @__PURE__ */ field.command("3dm.filter_message_format", 0x0c, 0x0a, {
    function: FunctionSelector,
    numDescriptors: /* @__PURE__ */ codec.counter(codec.u8, "descriptors"),
    descriptors: /* @__PURE__ */ codec.counted("numDescriptors", types.DescriptorRate, 83),
}, {
    calls: [, 2, 0, 0, 0, 0],
    REPLIES: [[[2], [], [FilterMessageFormatResponse]]],
});

export const GetFilterBaseRate = /* @__PURE__ */ field.command("3dm.get_filter_base_rate", 0x0c, 0x0b, {}, {
    REPLIES: [[null, [], [GetFilterBaseRateResponse]]],
});

export const NmeaMessageFormat = /* @__PURE__ */ field.command("3dm.nmea_message_format", 0x0c, 0x0c, {
    function: FunctionSelector,
    count: /* @__PURE__ */ codec.counter(codec.u8, "formatEntries"),
    formatEntries: /* @__PURE__ */ codec.counted("count", types.NmeaMessage, 50),
}, {
    calls: [, 2, 0, 0, 0, 0],
    REPLIES: [[[2], [], [NmeaMessageFormatResponse]]],
});

export const PollData = /* @__PURE__ */ field.command("3dm.poll_data", 0x0c, 0x0d, {
    descriptorSet: codec.u8,
    suppressAck: codec.bool,
    numDescriptors: /* @__PURE__ */ codec.counter(codec.u8, "descriptors"),
    descriptors: /* @__PURE__ */ codec.counted("numDescriptors", codec.u8, 250),
}, {
    SILENT: [[], [["suppressAck", 1, true]]],
});

export const GetBaseRate = /* @__PURE__ */ field.command("3dm.get_base_rate", 0x0c, 0x0e, {
    descriptorSet: codec.u8,
}, {
    REPLIES: [[null, [], [GetBaseRateResponse]]],
});

export const MessageFormat = /* @__PURE__ */ field.command("3dm.message_format", 0x0c, 0x0f, {
    function: FunctionSelector,
    descriptorSet: codec.u8,
    numDescriptors: /* @__PURE__ */ codec.counter(codec.u8, "descriptors"),
    descriptors: /* @__PURE__ */ codec.counted("numDescriptors", types.DescriptorRate, 83),
}, {
    calls: [, 3, 1, 1, 1, 1],
    REPLIES: [[[2], [], [MessageFormatResponse]]],
});

export const FactoryStreaming = /* @__PURE__ */ field.command("3dm.factory_streaming", 0x0c, 0x10, {
    action: FactoryStreamingAction,
    reserved: /* @__PURE__ */ codec.reserved(codec.u8, 0),
});

export const DataStreamControl = /* @__PURE__ */ field.command("3dm.data_stream_control", 0x0c, 0x11, {
    function: FunctionSelector,
    descriptorSet: codec.u8,
    enable: codec.bool,
}, {
    calls: [, 2, 1, 1, 1, 1],
    REPLIES: [[[2], [], [DataStreamControlResponse]]],
});

export const RawRtcm2_3Message = /* @__PURE__ */ field.command("3dm.raw_rtcm_2_3_message", 0x0c, 0x20, {
    data: /* @__PURE__ */ codec.rest(codec.u8, 253),
});

export const ConstellationSettings = /* @__PURE__ */ field.command("3dm.constellation_settings", 0x0c, 0x21, {
    function: FunctionSelector,
    maxChannels: codec.u16,
    configCount: /* @__PURE__ */ codec.counter(codec.u8, "settings"),
    settings: /* @__PURE__ */ codec.counted("configCount", ConstellationSettingsEntry, 41),
}, {
    calls: [, 3, 0, 0, 0, 0],
    REPLIES: [[[2], [], [ConstellationSettingsResponse]]],
});

export const GnssSbasSettings = /* @__PURE__ */ field.command("3dm.gnss_sbas_settings", 0x0c, 0x22, {
    function: FunctionSelector,
    enableSbas: codec.u8,
    sbasOptions: SbasOptions,
    numIncludedPrns: /* @__PURE__ */ codec.counter(codec.u8, "includedPrns"),
    includedPrns: /* @__PURE__ */ codec.counted("numIncludedPrns", codec.u16, 124),
}, {
    calls: [, 4, 0, 0, 0, 0],
    REPLIES: [[[2], [], [GnssSbasSettingsResponse]]],
});

export const GnssAssistedFix = /* @__PURE__ */ field.command("3dm.gnss_assisted_fix", 0x0c, 0x23, {
    function: FunctionSelector,
    option: AssistedFixOption,
    flags: /* @__PURE__ */ codec.reserved(codec.u8, 255),
}, {
    calls: [, 2, 0, 0, 0, 0],
    REPLIES: [[[2], [], [GnssAssistedFixResponse]]],
});

export const GnssTimeAssistance = /* @__PURE__ */ field.command("3dm.gnss_time_assistance", 0x0c, 0x24, {
    function: FunctionSelector,
    tow: codec.double,
    weekNumber: codec.u16,
    accuracy: codec.float,
}, {
    calls: [, 3, 0],
    REPLIES: [[[2], [], [GnssTimeAssistanceResponse]]],
});

export const PpsSourceControl = /* @__PURE__ */ field.command("3dm.pps_source_control", 0x0c, 0x28, {
    function: FunctionSelector,
    source: PpsSource,
}, {
    calls: [, 1, 0, 0, 0, 0],
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
    calls: [, 2, 1, 1, 1, 1],
    REPLIES: [[[2], [], [EventControlResponse]]],
});

export const GetEventTriggerStatus = /* @__PURE__ */ field.command("3dm.get_event_trigger_status", 0x0c, 0x2c, {
    requestedCount: /* @__PURE__ */ codec.counter(codec.u8, "requestedInstances"),
    requestedInstances: /* @__PURE__ */ codec.counted("requestedCount", codec.u8, 252),
}, {
    REPLIES: [[null, [], [GetEventTriggerStatusResponse]]],
});

export const GetEventActionStatus = /* @__PURE__ */ field.command("3dm.get_event_action_status", 0x0c, 0x2d, {
    requestedCount: /* @__PURE__ */ codec.counter(codec.u8, "requestedInstances"),
    requestedInstances: /* @__PURE__ */ codec.counted("requestedCount", codec.u8, 252),
}, {
    REPLIES: [[null, [], [GetEventActionStatusResponse]]],
});

export const EventTriggerConfig = /* @__PURE__ */ field.command("3dm.event_trigger_config", 0x0c, 0x2e, {
    function: FunctionSelector,
    instance: codec.u8,
    type: types.EventTriggerType,
    parameters: /* @__PURE__ */ codec.union("type", [[1, "gpio", types.EventTriggerGpio], [2, "threshold", types.EventTriggerThreshold], [3, "combination", types.EventTriggerCombination]]),
}, {
    calls: [, 3, 1, 1, 1, 1],
    REPLIES: [[[2], [], [EventTriggerConfigResponse]]],
});

export const EventActionConfig = /* @__PURE__ */ field.command("3dm.event_action_config", 0x0c, 0x2f, {
    function: FunctionSelector,
    instance: codec.u8,
    trigger: codec.u8,
    type: types.EventActionType,
    parameters: /* @__PURE__ */ codec.union("type", [[1, "gpio", types.EventActionGpio], [2, "message", types.EventActionMessage]]),
}, {
    calls: [, 4, 1, 1, 1, 1],
    REPLIES: [[[2], [], [EventActionConfigResponse]]],
});

export const DeviceSettings = /* @__PURE__ */ field.command("3dm.device_settings", 0x0c, 0x30, {
    function: FunctionSelector,
}, {
    calls: [,,, 0, 0, 0],
    TIMEOUT: 2,
});

export const SensorToVehicleTransformEuler = /* @__PURE__ */ field.command("3dm.sensor_to_vehicle_transform_euler", 0x0c, 0x31, {
    function: FunctionSelector,
    roll: codec.float,
    pitch: codec.float,
    yaw: codec.float,
}, {
    calls: [, 3, 0, 0, 0, 0],
    REPLIES: [[[2], [], [SensorToVehicleTransformEulerResponse]]],
});

export const SensorToVehicleTransformQuaternion = /* @__PURE__ */ field.command("3dm.sensor_to_vehicle_transform_quaternion", 0x0c, 0x32, {
    function: FunctionSelector,
    q: types.Quatf,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [SensorToVehicleTransformQuaternionResponse]]],
});

export const SensorToVehicleTransformDcm = /* @__PURE__ */ field.command("3dm.sensor_to_vehicle_transform_dcm", 0x0c, 0x33, {
    function: FunctionSelector,
    dcm: types.Matrix3f,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [SensorToVehicleTransformDcmResponse]]],
});

export const GpsDynamicsMode = /* @__PURE__ */ field.command("3dm.gps_dynamics_mode", 0x0c, 0x34, {
    function: FunctionSelector,
    mode: ReceiverDynamics,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [GpsDynamicsModeResponse]]],
});

export const ImuSignalConditioning = /* @__PURE__ */ field.command("3dm.imu_signal_conditioning", 0x0c, 0x35, {
    function: FunctionSelector,
    orientationDecimation: codec.u16,
    dataConditioningFlags: DataConditioningFlags,
    inertialFilterWidth: codec.u8,
    magFilterWidth: codec.u8,
    upCompensation: codec.u16,
    northCompensation: codec.u16,
    magBandwidth: MagBandwidth,
    reserved: /* @__PURE__ */ codec.reserved(codec.u16, 0),
}, {
    calls: [, 8, 0, 0, 0, 0],
    REPLIES: [[[2], [], [ImuSignalConditioningResponse]]],
});

export const ImuTimestamp = /* @__PURE__ */ field.command("3dm.imu_timestamp", 0x0c, 0x36, {
    function: FunctionSelector,
    selector: ImuTimestampSelector,
    time: codec.u32,
}, {
    calls: [, 2, 1],
    REPLIES: [[[2], [], [ImuTimestampResponse]]],
});

export const AccelBias = /* @__PURE__ */ field.command("3dm.accel_bias", 0x0c, 0x37, {
    function: FunctionSelector,
    bias: types.Vector3f,
}, {
    calls: [, 1, 0, 0, 0, 0, 1],
    REPLIES: [[[2], [], [AccelBiasResponse]]],
    SILENT: [[6], []],
});

export const GyroBias = /* @__PURE__ */ field.command("3dm.gyro_bias", 0x0c, 0x38, {
    function: FunctionSelector,
    bias: types.Vector3f,
}, {
    calls: [, 1, 0, 0, 0, 0, 1],
    REPLIES: [[[2], [], [GyroBiasResponse]]],
    SILENT: [[6], []],
});

export const CaptureGyroBias = /* @__PURE__ */ field.command("3dm.capture_gyro_bias", 0x0c, 0x39, {
    averagingTimeMs: codec.u16,
}, {
    REPLIES: [[null, [], [GyroBiasResponse]]],
    TIMEOUT: 31,
});

export const MagHardIronOffset = /* @__PURE__ */ field.command("3dm.mag_hard_iron_offset", 0x0c, 0x3a, {
    function: FunctionSelector,
    offset: types.Vector3f,
}, {
    calls: [, 1, 0, 0, 0, 0, 1],
    REPLIES: [[[2], [], [MagHardIronOffsetResponse]]],
    SILENT: [[6], []],
});

export const MagSoftIronMatrix = /* @__PURE__ */ field.command("3dm.mag_soft_iron_matrix", 0x0c, 0x3b, {
    function: FunctionSelector,
    matrix: types.Matrix3f,
}, {
    calls: [, 1, 0, 0, 0, 0, 1],
    REPLIES: [[[2], [], [MagSoftIronMatrixResponse]]],
    SILENT: [[6], []],
});

export const ConingScullingEnable = /* @__PURE__ */ field.command("3dm.coning_sculling_enable", 0x0c, 0x3e, {
    function: FunctionSelector,
    enable: codec.bool,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [ConingScullingEnableResponse]]],
});

export const UartBaudRate = /* @__PURE__ */ field.command("3dm.uart_baud_rate", 0x0c, 0x40, {
    function: FunctionSelector,
    baud: codec.u32,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [UartBaudRateResponse]]],
});

export const GpioConfig = /* @__PURE__ */ field.command("3dm.gpio_config", 0x0c, 0x41, {
    function: FunctionSelector,
    pin: codec.u8,
    feature: types.GpioFeature,
    behavior: codec.u8,
    pinMode: types.GpioPinMode,
}, {
    calls: [, 4, 1, 1, 1, 1],
    REPLIES: [[[2], [], [GpioConfigResponse]]],
});

export const GpioState = /* @__PURE__ */ field.command("3dm.gpio_state", 0x0c, 0x42, {
    function: FunctionSelector,
    pin: codec.u8,
    state: codec.bool,
}, {
    calls: [, 2, 1],
    REPLIES: [[[2], [], [GpioStateResponse]]],
});

export const OdometerConfig = /* @__PURE__ */ field.command("3dm.odometer_config", 0x0c, 0x43, {
    function: FunctionSelector,
    mode: OdometerMode,
    scaling: codec.float,
    uncertainty: codec.float,
}, {
    calls: [, 3, 0, 0, 0, 0],
    REPLIES: [[[2], [], [OdometerConfigResponse]]],
});

export const ImuLowPassFilter = /* @__PURE__ */ field.command("3dm.imu_low_pass_filter", 0x0c, 0x50, {
    function: FunctionSelector,
    targetDescriptor: codec.u8,
    enable: codec.bool,
    manual: codec.bool,
    frequency: codec.u16,
    reserved: /* @__PURE__ */ codec.reserved(codec.u8, 0),
}, {
    calls: [, 5, 1, 1, 1, 1],
    REPLIES: [[[2], [], [ImuLowPassFilterResponse]]],
});

export const ComplementaryFilter = /* @__PURE__ */ field.command("3dm.complementary_filter", 0x0c, 0x51, {
    function: FunctionSelector,
    pitchRollEnable: codec.bool,
    headingEnable: codec.bool,
    pitchRollTimeConstant: codec.float,
    headingTimeConstant: codec.float,
}, {
    calls: [, 4, 0, 0, 0, 0],
    REPLIES: [[[2], [], [ComplementaryFilterResponse]]],
});

export const SensorRange = /* @__PURE__ */ field.command("3dm.sensor_range", 0x0c, 0x52, {
    function: FunctionSelector,
    sensor: SensorRangeType,
    setting: codec.u8,
}, {
    calls: [, 2, 1, 1, 1, 1],
    REPLIES: [[[2], [], [SensorRangeResponse]]],
});

export const GetCalibratedSensorRanges = /* @__PURE__ */ field.command("3dm.get_calibrated_sensor_ranges", 0x0c, 0x53, {
    sensor: SensorRangeType,
}, {
    REPLIES: [[null, [], [GetCalibratedSensorRangesResponse]]],
});

export const LowPassFilter = /* @__PURE__ */ field.command("3dm.low_pass_filter", 0x0c, 0x54, {
    function: FunctionSelector,
    descriptorSet: codec.u8,
    fieldDescriptor: codec.u8,
    enable: codec.bool,
    manual: codec.bool,
    frequency: codec.float,
}, {
    calls: [, 5, 2, 2, 2, 2],
    REPLIES: [[[2], [], [LowPassFilterResponse]]],
});

export const DataStreamFormat = /* @__PURE__ */ field.command("3dm.data_stream_format", 0x0c, 0x60, {
    function: FunctionSelector,
    stream: InternalSensor,
    format: StreamFormat,
}, {
    calls: [, 2, 2, 2, 2, 2],
    REPLIES: [[[2], [], [DataStreamFormatResponse]]],
});

export const DevicePowerState = /* @__PURE__ */ field.command("3dm.device_power_state", 0x0c, 0x61, {
    function: FunctionSelector,
    device: InternalSensor,
    state: SensorPowerState,
}, {
    calls: [, 2, 1, 1, 1, 1],
    REPLIES: [[[2], [], [DevicePowerStateResponse]]],
    TIMEOUT: 5,
});

export const GpsAdvancedSettings = /* @__PURE__ */ field.command("3dm.gps_advanced_settings", 0x0c, 0x62, {
    function: FunctionSelector,
}, {
    calls: [,,, 0, 0, 0],
});

export const DeviceStatus = /* @__PURE__ */ field.command("3dm.device_status", 0x0c, 0x64, {
    modelNumber: codec.u16,
    statusSelector: DeviceStatusSelector,
}, {
    REPLIES: [[null, [["statusSelector", 1, false]], [DeviceStatusBasicRq1ImuResponse, DeviceStatusBasicResponse, DeviceStatusBasicWithoutStateResponse, DeviceStatusBasicGx3Response]], [null, [["statusSelector", 2, false]], [DeviceStatusDiagnosticResponse, DeviceStatusDiagnosticGnssResponse, DeviceStatusDiagnosticGq4_45Response, DeviceStatusDiagnosticRq1_45Response, DeviceStatusDiagnosticGx4Response, DeviceStatusDiagnosticImuResponse, DeviceStatusDiagnosticGx4ImuResponse, DeviceStatusDiagnosticRq1ImuResponse, DeviceStatusDiagnosticGx3Response]]],
});
