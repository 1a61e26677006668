// Types that several sets use.

import * as codec from "./mip/codec.mjs";

export const Gx5BuiltInTest = /* @__PURE__ */ codec.bitfield(codec.u32, {
    WATCHDOG_RESET: [0, 0],
    IMU_COMM_FAULT: [8, 8],
    MAG_FAULT: [9, 9],
    PRESSURE_SENSOR_FAULT: [10, 10],
    SOLUTION_FAULT: [24, 24],
});

export const Cv7BuiltInTest = /* @__PURE__ */ codec.bitfield(codec.u32, {
    GENERAL_HARDWARE_FAULT: [0, 0],
    GENERAL_FIRMWARE_FAULT: [1, 1],
    TIMING_OVERLOAD: [2, 2],
    BUFFER_OVERRUN: [3, 3],
    ACCEL_FAULT: [12, 12],
    GYRO_FAULT: [13, 13],
    MAG_FAULT: [14, 14],
    PRESSURE_SENSOR_FAULT: [15, 15],
    CALIBRATION_ERROR: [18, 18],
    GENERAL_IMU_FAULT: [19, 19],
    FILTER_SOLUTION_FAULT: [22, 22],
    GENERAL_FILTER_FAULT: [23, 23],
});

export const Cv7ContinuousBuiltInTest = /* @__PURE__ */ codec.bitfield(/* @__PURE__ */ codec.octets(16), {
    SYSTEM_CLOCK_FAILURE: [0, 0],
    POWER_FAULT: [1, 1],
    FIRMWARE_FAULT: [4, 4],
    TIMING_OVERLOAD: [5, 5],
    BUFFER_OVERRUN: [6, 6],
    IMU_PROCESS_FAULT: [16, 16],
    IMU_DATA_PROCESS_TIME_EXCEEDED: [17, 17],
    IMU_DATA_RATE_ERROR: [18, 18],
    IMU_STALL: [19, 19],
    FILTER_PROCESS_FAULT: [20, 23],
    FILTER_MAJOR_CYCLE_FAULT: [20, 20],
    FILTER_MINOR_CYCLE_FAULT: [21, 21],
    FILTER_DATA_RATE_ERROR: [22, 22],
    FILTER_PROCESS_STALL: [23, 23],
    GNSS_SUBSYSTEM_FAULT: [24, 27],
    GNSS_MAIN_PROCESS_FAULT: [24, 24],
    GNSS_RECEIVER_1_STALL: [25, 25],
    GNSS_RECEIVER_2_STALL: [26, 26],
    IMU_COMM_FAULT: [33, 33],
    IMU_TIMING_OVERRUN: [34, 34],
    IMU_CALIBRATION_ERROR_ACCEL: [36, 36],
    IMU_CALIBRATION_ERROR_GYRO: [37, 37],
    IMU_CALIBRATION_ERROR_MAG: [38, 38],
    ACCEL_GENERAL_FAULT: [40, 40],
    ACCEL_OVER_RANGE: [41, 41],
    ACCEL_SELF_TEST_FAIL: [42, 42],
    GYRO_GENERAL_FAULT: [44, 44],
    GYRO_OVER_RANGE: [45, 45],
    GYRO_SELF_TEST_FAIL: [46, 46],
    MAG_GENERAL_FAULT: [48, 48],
    MAG_OVER_RANGE: [49, 49],
    MAG_SELF_TEST_FAIL: [50, 50],
    PRESSURE_SENSOR_GENERAL_FAULT: [52, 52],
    PRESSURE_SENSOR_OVER_RANGE: [53, 53],
    PRESSURE_SENSOR_SELF_TEST_FAIL: [54, 54],
    FACTORY_BITS_INVALID: [56, 56],
    FILTER_TIMING_OVERRUN: [66, 66],
    FILTER_TIMING_UNDERRUN: [67, 67],
    RECEIVER_1_FAULT: [105, 105],
    RECEIVER_1_NO_SOLUTION: [108, 108],
    RECEIVER_2_FAULT: [110, 110],
    RECEIVER_2_NO_SOLUTION: [113, 113],
});

export const Cv7InertialContinuousBuiltInTest = /* @__PURE__ */ codec.bitfield(/* @__PURE__ */ codec.octets(16), {
    SYSTEM_CLOCK_FAILURE: [0, 0],
    POWER_FAULT: [1, 1],
    FIRMWARE_FAULT: [4, 4],
    TIMING_OVERLOAD: [5, 5],
    BUFFER_OVERRUN: [6, 6],
    IMU_PROCESS_FAULT: [16, 16],
    IMU_DATA_RATE_MISMATCH: [17, 17],
    IMU_OVERRUN_DROPPED_DATA: [18, 18],
    IMU_STUCK: [19, 19],
    FILTER_PROCESS_FAULT: [20, 20],
    FILTER_DROPPED_DATA: [21, 21],
    FILTER_RATE_MISMATCH: [22, 22],
    FILTER_STUCK: [23, 23],
    IMU_CLOCK_FAULT: [32, 32],
    IMU_COMM_FAULT: [33, 33],
    IMU_TIMING_OVERRUN: [34, 34],
    IMU_CALIBRATION_ERROR_ACCEL: [36, 36],
    IMU_CALIBRATION_ERROR_GYRO: [37, 37],
    IMU_CALIBRATION_ERROR_MAG: [38, 38],
    ACCEL_GENERAL_FAULT: [40, 40],
    ACCEL_OVER_RANGE: [41, 41],
    ACCEL_SELF_TEST_FAIL: [42, 42],
    GYRO_GENERAL_FAULT: [44, 44],
    GYRO_OVER_RANGE: [45, 45],
    GYRO_SELF_TEST_FAIL: [46, 46],
    MAG_GENERAL_FAULT: [48, 48],
    MAG_OVER_RANGE: [49, 49],
    MAG_SELF_TEST_FAIL: [50, 50],
    PRESSURE_SENSOR_GENERAL_FAULT: [52, 52],
    PRESSURE_SENSOR_OVER_RANGE: [53, 53],
    PRESSURE_SENSOR_SELF_TEST_FAIL: [54, 54],
    FACTORY_BITS_INVALID: [56, 56],
    FILTER_FAULT: [64, 64],
    FILTER_TIMING_OVERRUN: [66, 66],
    FILTER_TIMING_UNDERRUN: [67, 67],
});

export const Gq7ContinuousBuiltInTest = /* @__PURE__ */ codec.bitfield(/* @__PURE__ */ codec.octets(16), {
    SYSTEM_CLOCK_FAILURE: [0, 0],
    POWER_FAULT: [1, 1],
    FIRMWARE_FAULT: [4, 4],
    TIMING_OVERLOAD: [5, 5],
    BUFFER_OVERRUN: [6, 6],
    IMU_IPC_FAULT: [16, 19],
    FILTER_IPC_FAULT: [20, 23],
    GNSS_IPC_FAULT: [24, 27],
    IMU_CLOCK_FAULT: [32, 32],
    IMU_COMM_FAULT: [33, 33],
    IMU_TIMING_OVERRUN: [34, 34],
    IMU_CALIBRATION_ERROR_ACCEL: [36, 36],
    IMU_CALIBRATION_ERROR_GYRO: [37, 37],
    IMU_CALIBRATION_ERROR_MAG: [38, 38],
    ACCEL_GENERAL_FAULT: [40, 40],
    ACCEL_OVER_RANGE: [41, 41],
    ACCEL_SELF_TEST_FAIL: [42, 42],
    GYRO_GENERAL_FAULT: [44, 44],
    GYRO_OVER_RANGE: [45, 45],
    GYRO_SELF_TEST_FAIL: [46, 46],
    MAG_GENERAL_FAULT: [48, 48],
    MAG_OVER_RANGE: [49, 49],
    MAG_SELF_TEST_FAIL: [50, 50],
    PRESSURE_SENSOR_GENERAL_FAULT: [52, 52],
    PRESSURE_SENSOR_OVER_RANGE: [53, 53],
    PRESSURE_SENSOR_SELF_TEST_FAIL: [54, 54],
    FILTER_CLOCK_FAULT: [64, 64],
    FILTER_HARDWARE_FAULT: [65, 65],
    FILTER_TIMING_OVERRUN: [66, 66],
    FILTER_TIMING_UNDERRUN: [67, 67],
    FILTER_COMM_ERROR: [68, 71],
    GNSS_CLOCK_FAULT: [96, 96],
    GNSS_HARDWARE_FAULT: [97, 97],
    GNSS_COMM_ERROR: [98, 100],
    GPS_TIME_FAULT: [101, 101],
    GNSS_TIMING_OVERRUN: [102, 102],
    RECEIVER_1_POWER_FAULT: [104, 104],
    RECEIVER_1_FAULT: [105, 105],
    ANTENNA_1_SHORTED: [106, 106],
    ANTENNA_1_OPEN: [107, 107],
    RECEIVER_1_SOLUTION_FAULT: [108, 108],
    RECEIVER_2_POWER_FAULT: [109, 109],
    RECEIVER_2_FAULT: [110, 110],
    ANTENNA_2_SHORTED: [111, 111],
    ANTENNA_2_OPEN: [112, 112],
    RECEIVER_2_SOLUTION_FAULT: [113, 113],
    RTCM_COMM_FAULT: [114, 114],
    RTK_DONGLE_FAULT: [115, 115],
});

export const EventTriggerType = /* @__PURE__ */ codec.enumeration(codec.u8, {
    NONE: 0,
    GPIO: 1,
    THRESHOLD: 2,
    COMBINATION: 3,
});

export const EventActionType = /* @__PURE__ */ codec.enumeration(codec.u8, {
    NONE: 0,
    GPIO: 1,
    MESSAGE: 2,
});

export const EventTriggerMode = /* @__PURE__ */ codec.enumeration(codec.u8, {
    DISABLED: 0,
    ENABLED: 1,
    TEST: 2,
    TEST_PULSE: 3,
});

export const EventTriggerStatus = /* @__PURE__ */ codec.bitfield(codec.u8, {
    ACTIVE: [0, 0],
    ENABLED: [1, 1],
    TEST: [2, 2],
});

export const EventTriggerGpioMode = /* @__PURE__ */ codec.enumeration(codec.u8, {
    DISABLED: 0,
    WHILE_HIGH: 1,
    WHILE_LOW: 2,
    EDGE: 4,
});

export const EventThresholdType = /* @__PURE__ */ codec.enumeration(codec.u8, {
    WINDOW: 1,
    INTERVAL: 2,
});

export const EventActionGpioMode = /* @__PURE__ */ codec.enumeration(codec.u8, {
    DISABLED: 0,
    ACTIVE_HIGH: 1,
    ACTIVE_LOW: 2,
    ONESHOT_HIGH: 5,
    ONESHOT_LOW: 6,
    TOGGLE: 7,
});

export const EventTriggerGpio = /* @__PURE__ */ codec.struct({
    pin: codec.u8,
    mode: EventTriggerGpioMode,
});

export const EventThresholdWindow = /* @__PURE__ */ codec.struct({
    lowThreshold: codec.double,
    highThreshold: codec.double,
});

export const EventThresholdInterval = /* @__PURE__ */ codec.struct({
    intervalThreshold: codec.double,
    interval: codec.double,
});

export const EventTriggerThreshold = /* @__PURE__ */ codec.struct({
    descriptorSet: codec.u8,
    fieldDescriptor: codec.u8,
    parameterId: codec.u8,
    type: EventThresholdType,
    thresholds: /* @__PURE__ */ codec.union("type", [[1, "window", EventThresholdWindow], [2, "interval", EventThresholdInterval]]),
});

export const EventTriggerCombination = /* @__PURE__ */ codec.struct({
    logicTable: codec.u16,
    inputTriggers: /* @__PURE__ */ codec.array(codec.u8, 4),
});

export const EventActionGpio = /* @__PURE__ */ codec.struct({
    pin: codec.u8,
    mode: EventActionGpioMode,
});

export const EventActionMessage = /* @__PURE__ */ codec.struct({
    descriptorSet: codec.u8,
    decimation: codec.u16,
    numFields: /* @__PURE__ */ codec.counter(codec.u8, "descriptors"),
    descriptors: /* @__PURE__ */ codec.counted("numFields", codec.u8, 249),
});

export const GnssConstellation = /* @__PURE__ */ codec.enumeration(codec.u8, {
    UNKNOWN: 0,
    GPS: 1,
    GLONASS: 2,
    GALILEO: 3,
    BEIDOU: 4,
    SBAS: 5,
});

export const GnssFixType = /* @__PURE__ */ codec.enumeration(codec.u8, {
    FIX_3D: 0,
    FIX_2D: 1,
    FIX_TIME_ONLY: 2,
    FIX_NONE: 3,
    FIX_INVALID: 4,
    FIX_RTK_FLOAT: 5,
    FIX_RTK_FIXED: 6,
    FIX_DIFFERENTIAL: 7,
});

export const GnssSignal = /* @__PURE__ */ codec.enumeration(codec.u8, {
    UNKNOWN: 0,
    GPS_L1CA: 1,
    GPS_L1P: 2,
    GPS_L1Z: 3,
    GPS_L2CA: 4,
    GPS_L2P: 5,
    GPS_L2Z: 6,
    GPS_L2CL: 7,
    GPS_L2CM: 8,
    GPS_L2CML: 9,
    GPS_L5I: 10,
    GPS_L5Q: 11,
    GPS_L5IQ: 12,
    GPS_L1CD: 13,
    GPS_L1CP: 14,
    GPS_L1CDP: 15,
    GLONASS_G1CA: 32,
    GLONASS_G1P: 33,
    GLONASS_G2C: 34,
    GLONASS_G2P: 35,
    GALILEO_E1C: 64,
    GALILEO_E1A: 65,
    GALILEO_E1B: 66,
    GALILEO_E1BC: 67,
    GALILEO_E1ABC: 68,
    GALILEO_E6C: 69,
    GALILEO_E6A: 70,
    GALILEO_E6B: 71,
    GALILEO_E6BC: 72,
    GALILEO_E6ABC: 73,
    GALILEO_E5BI: 74,
    GALILEO_E5BQ: 75,
    GALILEO_E5BIQ: 76,
    GALILEO_E5ABI: 77,
    GALILEO_E5ABQ: 78,
    GALILEO_E5ABIQ: 79,
    GALILEO_E5AI: 80,
    GALILEO_E5AQ: 81,
    GALILEO_E5AIQ: 82,
    SBAS_L1CA: 96,
    SBAS_L5I: 97,
    SBAS_L5Q: 98,
    SBAS_L5IQ: 99,
    QZSS_L1CA: 128,
    QZSS_LEXS: 129,
    QZSS_LEXL: 130,
    QZSS_LEXSL: 131,
    QZSS_L2CM: 132,
    QZSS_L2CL: 133,
    QZSS_L2CML: 134,
    QZSS_L5I: 135,
    QZSS_L5Q: 136,
    QZSS_L5IQ: 137,
    QZSS_L1CD: 138,
    QZSS_L1CP: 139,
    QZSS_L1CDP: 140,
    BEIDOU_B1I: 160,
    BEIDOU_B1Q: 161,
    BEIDOU_B1IQ: 162,
    BEIDOU_B3I: 163,
    BEIDOU_B3Q: 164,
    BEIDOU_B3IQ: 165,
    BEIDOU_B2I: 166,
    BEIDOU_B2Q: 167,
    BEIDOU_B2IQ: 168,
    BEIDOU_B2A: 169,
});

export const GpioFeature = /* @__PURE__ */ codec.enumeration(codec.u8, {
    UNUSED: 0,
    GPIO: 1,
    PPS: 2,
    ENCODER: 3,
    TIMESTAMP: 4,
    UART: 5,
});

export const GpioUnusedBehavior = /* @__PURE__ */ codec.enumeration(codec.u8, {
    UNUSED: 0,
});

export const GpioBehavior = /* @__PURE__ */ codec.enumeration(codec.u8, {
    INPUT: 1,
    OUTPUT_LOW: 2,
    OUTPUT_HIGH: 3,
});

export const GpioPpsBehavior = /* @__PURE__ */ codec.enumeration(codec.u8, {
    INPUT: 1,
    OUTPUT: 2,
});

export const GpioEncoderBehavior = /* @__PURE__ */ codec.enumeration(codec.u8, {
    A: 1,
    B: 2,
});

export const GpioTimestampBehavior = /* @__PURE__ */ codec.enumeration(codec.u8, {
    RISING: 1,
    FALLING: 2,
    EITHER: 3,
});

export const GpioUartBehavior = /* @__PURE__ */ codec.enumeration(codec.u8, {
    PORT_2_TX: 33,
    PORT_2_RX: 34,
    PORT_3_TX: 49,
    PORT_3_RX: 50,
});

export const GpioPinMode = /* @__PURE__ */ codec.bitfield(codec.u8, {
    OPEN_DRAIN: [0, 0],
    PULLDOWN: [1, 1],
    PULLUP: [2, 2],
});

export const NmeaMessageId = /* @__PURE__ */ codec.enumeration(codec.u8, {
    GGA: 1,
    GLL: 2,
    GSV: 3,
    RMC: 4,
    VTG: 5,
    HDT: 6,
    ZDA: 7,
    GST: 8,
    MSRA: 129,
    MSRR: 130,
});

export const NmeaTalkerId = /* @__PURE__ */ codec.enumeration(codec.u8, {
    IGNORED: 0,
    GNSS: 1,
    GPS: 2,
    GALILEO: 3,
    GLONASS: 4,
});

export const NmeaMessage = /* @__PURE__ */ codec.struct({
    messageId: NmeaMessageId,
    talkerId: NmeaTalkerId,
    sourceDescriptorSet: codec.u8,
    decimation: codec.u16,
});

export const CommInterface = /* @__PURE__ */ codec.enumeration(codec.u8, {
    ALL: 0,
    MAIN: 1,
    UART_1: 17,
    UART_2: 18,
    UART_3: 19,
    USB_1: 33,
    USB_2: 34,
});

export const RtkStatusFlags = /* @__PURE__ */ codec.bitfield(codec.u32, {
    MODEM_STATE: [0, 3],
    CONNECTION_TYPE: [4, 7],
    RSSI: [8, 15],
    SIGNAL_QUALITY: [16, 19],
    TOWER_CHANGE_INDICATOR: [20, 23],
    NMEA_TIMEOUT: [24, 24],
    SERVER_TIMEOUT: [25, 25],
    CORRECTIONS_TIMEOUT: [26, 26],
    DEVICE_OUT_OF_RANGE: [27, 27],
    CORRECTIONS_UNAVAILABLE: [28, 28],
    VERSION: [30, 31],
});

export const RtkStatusFlagsLegacy = /* @__PURE__ */ codec.bitfield(codec.u32, {
    CONTROLLER_STATE: [0, 2],
    PLATFORM_STATE: [3, 7],
    CONTROLLER_STATUS_CODE: [8, 10],
    PLATFORM_STATUS_CODE: [11, 13],
    RESET_CODE: [14, 15],
    SIGNAL_QUALITY: [16, 19],
    RSSI: [20, 25],
    RSRP: [26, 27],
    RSRQ: [28, 29],
    SINR: [30, 31],
});

export const Vector3f = /* @__PURE__ */ codec.vector((reader, at) => [codec.float(reader, at), codec.float(reader, at + 4), codec.float(reader, at + 8)]);

export const Vector3d = /* @__PURE__ */ codec.vector((reader, at) => [codec.double(reader, at), codec.double(reader, at + 8), codec.double(reader, at + 16)]);

export const Ned3f = /* @__PURE__ */ codec.vector((reader, at) => [codec.float(reader, at), codec.float(reader, at + 4), codec.float(reader, at + 8)]);

export const Ned3d = /* @__PURE__ */ codec.vector((reader, at) => [codec.double(reader, at), codec.double(reader, at + 8), codec.double(reader, at + 16)]);

export const Matrix3f = /* @__PURE__ */ codec.vector((reader, at) => [
    codec.float(reader, at),
    codec.float(reader, at + 4),
    codec.float(reader, at + 8),
    codec.float(reader, at + 12),
    codec.float(reader, at + 16),
    codec.float(reader, at + 20),
    codec.float(reader, at + 24),
    codec.float(reader, at + 28),
    codec.float(reader, at + 32),
]);

export const Quatf = /* @__PURE__ */ codec.vector((reader, at) => [
    codec.float(reader, at),
    codec.float(reader, at + 4),
    codec.float(reader, at + 8),
    codec.float(reader, at + 12),
]);

export const AckCode = /* @__PURE__ */ codec.enumeration(codec.u8, {
    OK: 0,
    UNKNOWN_COMMAND: 1,
    BAD_CHECKSUM: 2,
    INVALID_PARAMETER: 3,
    COMMAND_FAILED: 4,
    COMMAND_TIMEOUT: 5,
    UNKNOWN_DESCRIPTOR_SET: 6,
});

export const DescriptorRate = /* @__PURE__ */ codec.struct({
    descriptor: codec.u8,
    decimation: codec.u16,
});

export const SensorGpsTimestampFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    PPS_VALID: [0, 0],
    TIME_REFRESH: [1, 1],
    TIME_INITIALIZED: [2, 2],
    TOW_VALID: [3, 3],
    WEEK_NUMBER_VALID: [4, 4],
});

export const Gx5SensorGpsTimestampFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    PPS_VALID: [0, 0],
    TIME_REFRESH: [1, 1],
    TIME_INITIALIZED: [2, 2],
});
