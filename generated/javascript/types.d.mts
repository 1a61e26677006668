// Types that several sets use.

import type { Bitfield, Enumeration, Flavor } from "./mip/index.mjs";

export type Gx5BuiltInTest = Flavor<number, "gx5_built_in_test">;
/**
 * Result of the built-in test of the 3DM-GX5-15: processor board, sensor board, filter.
 *
 * - 3dm-gx5-15: 4.1.5 Device Built-In Test (0x01, 0x05)
 */
export declare const Gx5BuiltInTest: Bitfield<Gx5BuiltInTest> & {
    /** The watchdog has reset the processor; cleared by the first commanded test. Bit 0. */
    readonly WATCHDOG_RESET: Gx5BuiltInTest;
    /** No communication with the inertial sensor. Bit 8. */
    readonly IMU_COMM_FAULT: Gx5BuiltInTest;
    /** Magnetometer fault, on devices that have one. Bit 9. Affects `sensor.ScaledMag`. */
    readonly MAG_FAULT: Gx5BuiltInTest;
    /** Pressure sensor fault, on devices that have one. Bit 10. Affects `sensor.ScaledPressure`. */
    readonly PRESSURE_SENSOR_FAULT: Gx5BuiltInTest;
    /** Fault of the estimation filter solution. Bit 24. Affects `filter.Reset`. */
    readonly SOLUTION_FAULT: Gx5BuiltInTest;
};

export type Cv7BuiltInTest = Flavor<number, "cv7_built_in_test">;
/**
 * Result of the commanded built-in test of the 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Commanded Built-in Test
 */
export declare const Cv7BuiltInTest: Bitfield<Cv7BuiltInTest> & {
    /** A critical part, such as the oscillator, has failed. Bit 0. */
    readonly GENERAL_HARDWARE_FAULT: Cv7BuiltInTest;
    /** The firmware encountered a serious or unexpected condition. Bit 1. */
    readonly GENERAL_FIRMWARE_FAULT: Cv7BuiltInTest;
    /** The processor cannot keep up; cleared by reading the result. Bit 2. */
    readonly TIMING_OVERLOAD: Cv7BuiltInTest;
    /** A data buffer was full, usually because too much data is streamed. Bit 3. */
    readonly BUFFER_OVERRUN: Cv7BuiltInTest;
    /** The accelerometer is damaged or does not work. Bit 12. Affects `sensor.ScaledAccel`. */
    readonly ACCEL_FAULT: Cv7BuiltInTest;
    /** The gyroscope is damaged or does not work. Bit 13. Affects `sensor.ScaledGyro`. */
    readonly GYRO_FAULT: Cv7BuiltInTest;
    /** The magnetometer is damaged or does not work. Bit 14. Affects `sensor.ScaledMag`. */
    readonly MAG_FAULT: Cv7BuiltInTest;
    /** The pressure sensor is damaged or does not work. Bit 15. Affects `sensor.ScaledPressure`. */
    readonly PRESSURE_SENSOR_FAULT: Cv7BuiltInTest;
    /** At least one calibration table of the sensors is invalid. Bit 18. */
    readonly CALIBRATION_ERROR: Cv7BuiltInTest;
    /** A fault of the inertial sensor subsystem that no other bit covers. Bit 19. */
    readonly GENERAL_IMU_FAULT: Cv7BuiltInTest;
    /** The filter output is invalid (not a number); reset the filter. Bit 22. Affects `filter.Reset`. */
    readonly FILTER_SOLUTION_FAULT: Cv7BuiltInTest;
    /** A fault of the filter subsystem that no other bit covers. Bit 23. */
    readonly GENERAL_FILTER_FAULT: Cv7BuiltInTest;
};

export type Cv7ContinuousBuiltInTest = Flavor<bigint, "cv7_continuous_built_in_test">;
/**
 * Flags of the continuous built-in test of the 3DM-CV7-GNSS/INS: bits 0-31 system, 32-63 inertial sensors, 64-95
 * navigation, 96-127 GNSS.
 *
 * - 3dm-cv7-gnss-ins: Continuous Built-in Test
 */
export declare const Cv7ContinuousBuiltInTest: Bitfield<Cv7ContinuousBuiltInTest> & {
    /** The system clock does not work properly. Bit 0. */
    readonly SYSTEM_CLOCK_FAILURE: Cv7ContinuousBuiltInTest;
    /** The supply voltage is out of range, or an internal supply has failed. Bit 1. */
    readonly POWER_FAULT: Cv7ContinuousBuiltInTest;
    /** The firmware encountered an unexpected condition. Bit 4. */
    readonly FIRMWARE_FAULT: Cv7ContinuousBuiltInTest;
    /** The processor cannot keep up. Bit 5. */
    readonly TIMING_OVERLOAD: Cv7ContinuousBuiltInTest;
    /** A data buffer was full and data may be lost. Bit 6. */
    readonly BUFFER_OVERRUN: Cv7ContinuousBuiltInTest;
    /** The inertial sensor subsystem is not running or did not start. Bit 16. */
    readonly IMU_PROCESS_FAULT: Cv7ContinuousBuiltInTest;
    /** The processing of sensor data took too long. Bit 17. */
    readonly IMU_DATA_PROCESS_TIME_EXCEEDED: Cv7ContinuousBuiltInTest;
    /** Sensor data is not produced at its base rate. Bit 18. */
    readonly IMU_DATA_RATE_ERROR: Cv7ContinuousBuiltInTest;
    /** The inertial sensor subsystem produces no data. Bit 19. */
    readonly IMU_STALL: Cv7ContinuousBuiltInTest;
    /** Set if any filter fault (bits 20-23) is set. Bits 20 to 23. Overlaps other bits. */
    readonly FILTER_PROCESS_FAULT: Cv7ContinuousBuiltInTest;
    /** Fault of the major cycle of the filter; bits 22 and 23 show which fault. Bit 20. */
    readonly FILTER_MAJOR_CYCLE_FAULT: Cv7ContinuousBuiltInTest;
    /** Fault of the minor cycle of the filter; bits 22 and 23 show which fault. Bit 21. */
    readonly FILTER_MINOR_CYCLE_FAULT: Cv7ContinuousBuiltInTest;
    /** A filter process misses its base rate; bits 20 and 21 show which. Bit 22. */
    readonly FILTER_DATA_RATE_ERROR: Cv7ContinuousBuiltInTest;
    /** A filter process produces no data; bits 20 and 21 show which. Bit 23. */
    readonly FILTER_PROCESS_STALL: Cv7ContinuousBuiltInTest;
    /** Set if any GNSS fault (bits 24-27) is set. Bits 24 to 27. Overlaps other bits. */
    readonly GNSS_SUBSYSTEM_FAULT: Cv7ContinuousBuiltInTest;
    /** The main GNSS process did not run in time. Bit 24. */
    readonly GNSS_MAIN_PROCESS_FAULT: Cv7ContinuousBuiltInTest;
    /** No data from internal receiver 1 in time. Bit 25. Affects `gnss_data.FixInfo`. */
    readonly GNSS_RECEIVER_1_STALL: Cv7ContinuousBuiltInTest;
    /** No data from internal receiver 2 in time. Bit 26. Affects `gnss_data.FixInfo`. */
    readonly GNSS_RECEIVER_2_STALL: Cv7ContinuousBuiltInTest;
    /** No communication with the inertial sensors. Bit 33. */
    readonly IMU_COMM_FAULT: Cv7ContinuousBuiltInTest;
    /** Inertial sensor processes take longer than their time slot. Bit 34. */
    readonly IMU_TIMING_OVERRUN: Cv7ContinuousBuiltInTest;
    /** Accelerometer calibration fault. Bit 36. Affects `sensor.ScaledAccel`. */
    readonly IMU_CALIBRATION_ERROR_ACCEL: Cv7ContinuousBuiltInTest;
    /** Gyroscope calibration fault. Bit 37. Affects `sensor.ScaledGyro`. */
    readonly IMU_CALIBRATION_ERROR_GYRO: Cv7ContinuousBuiltInTest;
    /** Magnetometer calibration fault. Bit 38. Affects `sensor.ScaledMag`. */
    readonly IMU_CALIBRATION_ERROR_MAG: Cv7ContinuousBuiltInTest;
    /** The accelerometer failed to initialize. Bit 40. Affects `sensor.ScaledAccel`. */
    readonly ACCEL_GENERAL_FAULT: Cv7ContinuousBuiltInTest;
    /** The acceleration along an axis is near or outside the selected range. Bit 41. Affects `sensor.ScaledAccel`. */
    readonly ACCEL_OVER_RANGE: Cv7ContinuousBuiltInTest;
    /**
     * The accelerometer self-test failed; the commanded built-in test updates this bit. Bit 42. Affects
     * `sensor.ScaledAccel`.
     */
    readonly ACCEL_SELF_TEST_FAIL: Cv7ContinuousBuiltInTest;
    /** The gyroscope failed to initialize. Bit 44. Affects `sensor.ScaledGyro`. */
    readonly GYRO_GENERAL_FAULT: Cv7ContinuousBuiltInTest;
    /** The angular rate about an axis is near or outside the selected range. Bit 45. Affects `sensor.ScaledGyro`. */
    readonly GYRO_OVER_RANGE: Cv7ContinuousBuiltInTest;
    /**
     * The gyroscope self-test failed; the commanded built-in test updates this bit. Bit 46. Affects
     * `sensor.ScaledGyro`.
     */
    readonly GYRO_SELF_TEST_FAIL: Cv7ContinuousBuiltInTest;
    /** The magnetometer failed to initialize. Bit 48. Affects `sensor.ScaledMag`. */
    readonly MAG_GENERAL_FAULT: Cv7ContinuousBuiltInTest;
    /** The magnetic field along an axis is near or outside the supported range. Bit 49. Affects `sensor.ScaledMag`. */
    readonly MAG_OVER_RANGE: Cv7ContinuousBuiltInTest;
    /**
     * The magnetometer self-test failed; the commanded built-in test updates this bit. Bit 50. Affects
     * `sensor.ScaledMag`.
     */
    readonly MAG_SELF_TEST_FAIL: Cv7ContinuousBuiltInTest;
    /** The pressure sensor failed to initialize. Bit 52. Affects `sensor.ScaledPressure`. */
    readonly PRESSURE_SENSOR_GENERAL_FAULT: Cv7ContinuousBuiltInTest;
    /** The pressure is outside the supported range. Bit 53. Affects `sensor.ScaledPressure`. */
    readonly PRESSURE_SENSOR_OVER_RANGE: Cv7ContinuousBuiltInTest;
    /**
     * The pressure sensor self-test failed; the commanded built-in test updates this bit. Bit 54. Affects
     * `sensor.ScaledPressure`.
     */
    readonly PRESSURE_SENSOR_SELF_TEST_FAIL: Cv7ContinuousBuiltInTest;
    /** The device has lost its factory configuration. Bit 56. */
    readonly FACTORY_BITS_INVALID: Cv7ContinuousBuiltInTest;
    /** Filter processes take longer than their time slot. Bit 66. */
    readonly FILTER_TIMING_OVERRUN: Cv7ContinuousBuiltInTest;
    /** Filter processes are skipped. Bit 67. */
    readonly FILTER_TIMING_UNDERRUN: Cv7ContinuousBuiltInTest;
    /** No communication with internal receiver 1. Bit 105. Affects `gnss_data.FixInfo`. */
    readonly RECEIVER_1_FAULT: Cv7ContinuousBuiltInTest;
    /**
     * Internal receiver 1 has no valid solution; usually for lack of a sky view. Bit 108. Affects `gnss_data.FixInfo`.
     */
    readonly RECEIVER_1_NO_SOLUTION: Cv7ContinuousBuiltInTest;
    /** No communication with internal receiver 2. Bit 110. Affects `gnss_data.FixInfo`. */
    readonly RECEIVER_2_FAULT: Cv7ContinuousBuiltInTest;
    /**
     * Internal receiver 2 has no valid solution; usually for lack of a sky view. Bit 113. Affects `gnss_data.FixInfo`.
     */
    readonly RECEIVER_2_NO_SOLUTION: Cv7ContinuousBuiltInTest;
};

export type Cv7InertialContinuousBuiltInTest = Flavor<bigint, "cv7_inertial_continuous_built_in_test">;
/**
 * Flags of the continuous built-in test of devices of generation 7 without a GNSS receiver: bits 0-31 system, 32-63
 * inertial sensors, 64-95 navigation. Uncertain: The sources list only the numbers and names of the bits; the
 * descriptions are those of the 3DM-CV7-GNSS/INS where the names are the same.
 *
 * - ros-driver: Built-in test of the CV7
 * - mscl: Continuous built-in test
 */
export declare const Cv7InertialContinuousBuiltInTest: Bitfield<Cv7InertialContinuousBuiltInTest> & {
    /** The system clock does not work properly. Bit 0. */
    readonly SYSTEM_CLOCK_FAILURE: Cv7InertialContinuousBuiltInTest;
    /** The supply voltage is out of range, or an internal supply has failed. Bit 1. */
    readonly POWER_FAULT: Cv7InertialContinuousBuiltInTest;
    /** The firmware encountered an unexpected condition. Bit 4. */
    readonly FIRMWARE_FAULT: Cv7InertialContinuousBuiltInTest;
    /** The processor cannot keep up. Bit 5. */
    readonly TIMING_OVERLOAD: Cv7InertialContinuousBuiltInTest;
    /** A data buffer was full and data may be lost. Bit 6. */
    readonly BUFFER_OVERRUN: Cv7InertialContinuousBuiltInTest;
    /** The inertial sensor subsystem is not running or did not start. Bit 16. */
    readonly IMU_PROCESS_FAULT: Cv7InertialContinuousBuiltInTest;
    /** Sensor data is not produced at its base rate. Bit 17. */
    readonly IMU_DATA_RATE_MISMATCH: Cv7InertialContinuousBuiltInTest;
    /** Sensor data was dropped. Bit 18. */
    readonly IMU_OVERRUN_DROPPED_DATA: Cv7InertialContinuousBuiltInTest;
    /** The inertial sensor process is stuck. Bit 19. */
    readonly IMU_STUCK: Cv7InertialContinuousBuiltInTest;
    /** The filter process failed. Bit 20. */
    readonly FILTER_PROCESS_FAULT: Cv7InertialContinuousBuiltInTest;
    /** The filter dropped data. Bit 21. */
    readonly FILTER_DROPPED_DATA: Cv7InertialContinuousBuiltInTest;
    /** Filter data is not produced at its base rate. Bit 22. */
    readonly FILTER_RATE_MISMATCH: Cv7InertialContinuousBuiltInTest;
    /** The filter process is stuck. Bit 23. */
    readonly FILTER_STUCK: Cv7InertialContinuousBuiltInTest;
    /** The inertial sensor clock failed. Bit 32. */
    readonly IMU_CLOCK_FAULT: Cv7InertialContinuousBuiltInTest;
    /** No communication with the inertial sensors. Bit 33. */
    readonly IMU_COMM_FAULT: Cv7InertialContinuousBuiltInTest;
    /** Inertial sensor processes take longer than their time slot. Bit 34. */
    readonly IMU_TIMING_OVERRUN: Cv7InertialContinuousBuiltInTest;
    /** Accelerometer calibration fault. Bit 36. Affects `sensor.ScaledAccel`. */
    readonly IMU_CALIBRATION_ERROR_ACCEL: Cv7InertialContinuousBuiltInTest;
    /** Gyroscope calibration fault. Bit 37. Affects `sensor.ScaledGyro`. */
    readonly IMU_CALIBRATION_ERROR_GYRO: Cv7InertialContinuousBuiltInTest;
    /** Magnetometer calibration fault. Bit 38. Affects `sensor.ScaledMag`. */
    readonly IMU_CALIBRATION_ERROR_MAG: Cv7InertialContinuousBuiltInTest;
    /** The accelerometer failed to initialize. Bit 40. Affects `sensor.ScaledAccel`. */
    readonly ACCEL_GENERAL_FAULT: Cv7InertialContinuousBuiltInTest;
    /** The acceleration along an axis is near or outside the selected range. Bit 41. Affects `sensor.ScaledAccel`. */
    readonly ACCEL_OVER_RANGE: Cv7InertialContinuousBuiltInTest;
    /**
     * The accelerometer self-test failed; the commanded built-in test updates this bit. Bit 42. Affects
     * `sensor.ScaledAccel`.
     */
    readonly ACCEL_SELF_TEST_FAIL: Cv7InertialContinuousBuiltInTest;
    /** The gyroscope failed to initialize. Bit 44. Affects `sensor.ScaledGyro`. */
    readonly GYRO_GENERAL_FAULT: Cv7InertialContinuousBuiltInTest;
    /** The angular rate about an axis is near or outside the selected range. Bit 45. Affects `sensor.ScaledGyro`. */
    readonly GYRO_OVER_RANGE: Cv7InertialContinuousBuiltInTest;
    /**
     * The gyroscope self-test failed; the commanded built-in test updates this bit. Bit 46. Affects
     * `sensor.ScaledGyro`.
     */
    readonly GYRO_SELF_TEST_FAIL: Cv7InertialContinuousBuiltInTest;
    /** The magnetometer failed to initialize. Bit 48. Affects `sensor.ScaledMag`. */
    readonly MAG_GENERAL_FAULT: Cv7InertialContinuousBuiltInTest;
    /** The magnetic field along an axis is near or outside the supported range. Bit 49. Affects `sensor.ScaledMag`. */
    readonly MAG_OVER_RANGE: Cv7InertialContinuousBuiltInTest;
    /**
     * The magnetometer self-test failed; the commanded built-in test updates this bit. Bit 50. Affects
     * `sensor.ScaledMag`.
     */
    readonly MAG_SELF_TEST_FAIL: Cv7InertialContinuousBuiltInTest;
    /** The pressure sensor failed to initialize. Bit 52. Affects `sensor.ScaledPressure`. */
    readonly PRESSURE_SENSOR_GENERAL_FAULT: Cv7InertialContinuousBuiltInTest;
    /** The pressure is outside the supported range. Bit 53. Affects `sensor.ScaledPressure`. */
    readonly PRESSURE_SENSOR_OVER_RANGE: Cv7InertialContinuousBuiltInTest;
    /**
     * The pressure sensor self-test failed; the commanded built-in test updates this bit. Bit 54. Affects
     * `sensor.ScaledPressure`.
     */
    readonly PRESSURE_SENSOR_SELF_TEST_FAIL: Cv7InertialContinuousBuiltInTest;
    /** The device has lost its factory configuration. Bit 56. */
    readonly FACTORY_BITS_INVALID: Cv7InertialContinuousBuiltInTest;
    /** The filter does not work normally. Bit 64. */
    readonly FILTER_FAULT: Cv7InertialContinuousBuiltInTest;
    /** Filter processes take longer than their time slot. Bit 66. */
    readonly FILTER_TIMING_OVERRUN: Cv7InertialContinuousBuiltInTest;
    /** Filter processes are skipped. Bit 67. */
    readonly FILTER_TIMING_UNDERRUN: Cv7InertialContinuousBuiltInTest;
};

export type Gq7ContinuousBuiltInTest = Flavor<bigint, "gq7_continuous_built_in_test">;
/**
 * Flags of the continuous built-in test of the 3DM-GQ7: bits 0-31 system, 32-63 inertial sensors, 64-95 navigation,
 * 96-127 GNSS. Uncertain: The sources list only the numbers and names of the bits; the descriptions are those of the
 * 3DM-CV7-GNSS/INS where the names are the same.
 *
 * - ros-driver: Built-in test of the GQ7
 * - mscl: Continuous built-in test
 */
export declare const Gq7ContinuousBuiltInTest: Bitfield<Gq7ContinuousBuiltInTest> & {
    /** The system clock does not work properly. Bit 0. */
    readonly SYSTEM_CLOCK_FAILURE: Gq7ContinuousBuiltInTest;
    /** The supply voltage is out of range, or an internal supply has failed. Bit 1. */
    readonly POWER_FAULT: Gq7ContinuousBuiltInTest;
    /** The firmware encountered an unexpected condition. Bit 4. */
    readonly FIRMWARE_FAULT: Gq7ContinuousBuiltInTest;
    /** The processor cannot keep up. Bit 5. */
    readonly TIMING_OVERLOAD: Gq7ContinuousBuiltInTest;
    /** A data buffer was full and data may be lost. Bit 6. */
    readonly BUFFER_OVERRUN: Gq7ContinuousBuiltInTest;
    /** Faults of the link to the inertial sensor processor. Bits 16 to 19. */
    readonly IMU_IPC_FAULT: Gq7ContinuousBuiltInTest;
    /** Faults of the link to the filter processor. Bits 20 to 23. */
    readonly FILTER_IPC_FAULT: Gq7ContinuousBuiltInTest;
    /** Faults of the link to the GNSS processor. Bits 24 to 27. */
    readonly GNSS_IPC_FAULT: Gq7ContinuousBuiltInTest;
    /** The inertial sensor clock failed. Bit 32. */
    readonly IMU_CLOCK_FAULT: Gq7ContinuousBuiltInTest;
    /** No communication with the inertial sensors. Bit 33. */
    readonly IMU_COMM_FAULT: Gq7ContinuousBuiltInTest;
    /** Inertial sensor processes take longer than their time slot. Bit 34. */
    readonly IMU_TIMING_OVERRUN: Gq7ContinuousBuiltInTest;
    /** Accelerometer calibration fault. Bit 36. Affects `sensor.ScaledAccel`. */
    readonly IMU_CALIBRATION_ERROR_ACCEL: Gq7ContinuousBuiltInTest;
    /** Gyroscope calibration fault. Bit 37. Affects `sensor.ScaledGyro`. */
    readonly IMU_CALIBRATION_ERROR_GYRO: Gq7ContinuousBuiltInTest;
    /** Magnetometer calibration fault. Bit 38. Affects `sensor.ScaledMag`. */
    readonly IMU_CALIBRATION_ERROR_MAG: Gq7ContinuousBuiltInTest;
    /** The accelerometer failed to initialize. Bit 40. Affects `sensor.ScaledAccel`. */
    readonly ACCEL_GENERAL_FAULT: Gq7ContinuousBuiltInTest;
    /** The acceleration along an axis is near or outside the selected range. Bit 41. Affects `sensor.ScaledAccel`. */
    readonly ACCEL_OVER_RANGE: Gq7ContinuousBuiltInTest;
    /**
     * The accelerometer self-test failed; the commanded built-in test updates this bit. Bit 42. Affects
     * `sensor.ScaledAccel`.
     */
    readonly ACCEL_SELF_TEST_FAIL: Gq7ContinuousBuiltInTest;
    /** The gyroscope failed to initialize. Bit 44. Affects `sensor.ScaledGyro`. */
    readonly GYRO_GENERAL_FAULT: Gq7ContinuousBuiltInTest;
    /** The angular rate about an axis is near or outside the selected range. Bit 45. Affects `sensor.ScaledGyro`. */
    readonly GYRO_OVER_RANGE: Gq7ContinuousBuiltInTest;
    /**
     * The gyroscope self-test failed; the commanded built-in test updates this bit. Bit 46. Affects
     * `sensor.ScaledGyro`.
     */
    readonly GYRO_SELF_TEST_FAIL: Gq7ContinuousBuiltInTest;
    /** The magnetometer failed to initialize. Bit 48. Affects `sensor.ScaledMag`. */
    readonly MAG_GENERAL_FAULT: Gq7ContinuousBuiltInTest;
    /** The magnetic field along an axis is near or outside the supported range. Bit 49. Affects `sensor.ScaledMag`. */
    readonly MAG_OVER_RANGE: Gq7ContinuousBuiltInTest;
    /**
     * The magnetometer self-test failed; the commanded built-in test updates this bit. Bit 50. Affects
     * `sensor.ScaledMag`.
     */
    readonly MAG_SELF_TEST_FAIL: Gq7ContinuousBuiltInTest;
    /** The pressure sensor failed to initialize. Bit 52. Affects `sensor.ScaledPressure`. */
    readonly PRESSURE_SENSOR_GENERAL_FAULT: Gq7ContinuousBuiltInTest;
    /** The pressure is outside the supported range. Bit 53. Affects `sensor.ScaledPressure`. */
    readonly PRESSURE_SENSOR_OVER_RANGE: Gq7ContinuousBuiltInTest;
    /**
     * The pressure sensor self-test failed; the commanded built-in test updates this bit. Bit 54. Affects
     * `sensor.ScaledPressure`.
     */
    readonly PRESSURE_SENSOR_SELF_TEST_FAIL: Gq7ContinuousBuiltInTest;
    /** The filter clock failed. Bit 64. */
    readonly FILTER_CLOCK_FAULT: Gq7ContinuousBuiltInTest;
    /** Filter processor fault. Bit 65. */
    readonly FILTER_HARDWARE_FAULT: Gq7ContinuousBuiltInTest;
    /** Filter processes take longer than their time slot. Bit 66. */
    readonly FILTER_TIMING_OVERRUN: Gq7ContinuousBuiltInTest;
    /** Filter processes are skipped. Bit 67. */
    readonly FILTER_TIMING_UNDERRUN: Gq7ContinuousBuiltInTest;
    /** Filter communication errors. Bits 68 to 71. */
    readonly FILTER_COMM_ERROR: Gq7ContinuousBuiltInTest;
    /** The GNSS processor clock failed. Bit 96. */
    readonly GNSS_CLOCK_FAULT: Gq7ContinuousBuiltInTest;
    /** GNSS processor fault. Bit 97. */
    readonly GNSS_HARDWARE_FAULT: Gq7ContinuousBuiltInTest;
    /** GNSS processor communication errors. Bits 98 to 100. */
    readonly GNSS_COMM_ERROR: Gq7ContinuousBuiltInTest;
    /** GPS time fault. Bit 101. Affects `gnss_data.GpsTime`. */
    readonly GPS_TIME_FAULT: Gq7ContinuousBuiltInTest;
    /** A GNSS processor cycle exceeded its time slot. Bit 102. */
    readonly GNSS_TIMING_OVERRUN: Gq7ContinuousBuiltInTest;
    /** Receiver 1 power supply fault. Bit 104. Affects `gnss_data.FixInfo`. */
    readonly RECEIVER_1_POWER_FAULT: Gq7ContinuousBuiltInTest;
    /** No communication with internal receiver 1. Bit 105. Affects `gnss_data.FixInfo`. */
    readonly RECEIVER_1_FAULT: Gq7ContinuousBuiltInTest;
    /** Antenna 1 is shorted. Bit 106. Affects `gnss_data.HardwareStatus`. */
    readonly ANTENNA_1_SHORTED: Gq7ContinuousBuiltInTest;
    /** Antenna 1 is not connected. Bit 107. Affects `gnss_data.HardwareStatus`. */
    readonly ANTENNA_1_OPEN: Gq7ContinuousBuiltInTest;
    /** Receiver 1 has no solution. Bit 108. Affects `gnss_data.FixInfo`. */
    readonly RECEIVER_1_SOLUTION_FAULT: Gq7ContinuousBuiltInTest;
    /** Receiver 2 power supply fault. Bit 109. Affects `gnss_data.FixInfo`. */
    readonly RECEIVER_2_POWER_FAULT: Gq7ContinuousBuiltInTest;
    /** No communication with internal receiver 2. Bit 110. Affects `gnss_data.FixInfo`. */
    readonly RECEIVER_2_FAULT: Gq7ContinuousBuiltInTest;
    /** Antenna 2 is shorted. Bit 111. Affects `gnss_data.HardwareStatus`. */
    readonly ANTENNA_2_SHORTED: Gq7ContinuousBuiltInTest;
    /** Antenna 2 is not connected. Bit 112. Affects `gnss_data.HardwareStatus`. */
    readonly ANTENNA_2_OPEN: Gq7ContinuousBuiltInTest;
    /** Receiver 2 has no solution. Bit 113. Affects `gnss_data.FixInfo`. */
    readonly RECEIVER_2_SOLUTION_FAULT: Gq7ContinuousBuiltInTest;
    /** RTCM communication fault. Bit 114. Affects `gnss_data.RtkCorrectionsStatus`. */
    readonly RTCM_COMM_FAULT: Gq7ContinuousBuiltInTest;
    /** RTK modem fault. Bit 115. Affects `rtk.GetStatusFlags`. */
    readonly RTK_DONGLE_FAULT: Gq7ContinuousBuiltInTest;
};

export type EventTriggerType = Flavor<number, "event_trigger_type">;
/**
 * Kind of an event trigger.
 *
 * - 3dm-cv7-gnss-ins: Event Trigger Configuration (0x0C,0x2E)
 * - 3dm-cv7-gnss-ins: Types of triggers
 */
export declare const EventTriggerType: Enumeration<EventTriggerType> & {
    /** The instance is not in use: it is never active and cannot be enabled. */
    readonly NONE: EventTriggerType & 0;
    /** Watches a GPIO pin. */
    readonly GPIO: EventTriggerType & 1;
    /** Compares one value of a data field with thresholds. */
    readonly THRESHOLD: EventTriggerType & 2;
    /** Combines up to four other triggers in a truth table. */
    readonly COMBINATION: EventTriggerType & 3;
};

export type EventActionType = Flavor<number, "event_action_type">;
/**
 * Kind of an event action.
 *
 * - 3dm-cv7-gnss-ins: Event Action Configuration (0x0C,0x2F)
 * - 3dm-cv7-gnss-ins: Types of actions
 */
export declare const EventActionType: Enumeration<EventActionType> & {
    /** The instance is not in use. */
    readonly NONE: EventActionType & 0;
    /** Controls a GPIO pin. */
    readonly GPIO: EventActionType & 1;
    /** Sends a data packet. */
    readonly MESSAGE: EventActionType & 2;
};

export type EventTriggerMode = Flavor<number, "event_trigger_mode">;
/**
 * Operating mode of an event trigger.
 *
 * - 3dm-cv7-gnss-ins: Event Control (0x0C,0x2B)
 * - 3dm-cv7-gnss-ins: Enabling & Disabling Triggers
 */
export declare const EventTriggerMode: Enumeration<EventTriggerMode> & {
    /** The trigger is never active. Configuring a trigger sets this mode. */
    readonly DISABLED: EventTriggerMode & 0;
    /** The trigger works as configured. */
    readonly ENABLED: EventTriggerMode & 1;
    /** The trigger is active all the time. */
    readonly TEST: EventTriggerMode & 2;
    /** The trigger is active for one event cycle and then returns to its previous mode. */
    readonly TEST_PULSE: EventTriggerMode & 3;
};

export type EventTriggerStatus = Flavor<number, "event_trigger_status">;
/**
 * State of an event trigger.
 *
 * - 3dm-cv7-gnss-ins: Get Event Trigger Status (0x0C,0x2C)
 */
export declare const EventTriggerStatus: Bitfield<EventTriggerStatus> & {
    /** The trigger is active, because of its condition or a test mode. Bit 0. */
    readonly ACTIVE: EventTriggerStatus;
    /** The trigger is enabled. Bit 1. */
    readonly ENABLED: EventTriggerStatus;
    /** The trigger is in a test mode. Bit 2. */
    readonly TEST: EventTriggerStatus;
};

export type EventTriggerGpioMode = Flavor<number, "event_trigger_gpio_mode">;
/**
 * Condition of a GPIO pin that activates a trigger.
 *
 * - 3dm-cv7-gnss-ins: Event Trigger Configuration (0x0C,0x2E)
 * - 3dm-cv7-gnss-ins: Trigger: GPIO
 */
export declare const EventTriggerGpioMode: Enumeration<EventTriggerGpioMode> & {
    /** The trigger is never active. */
    readonly DISABLED: EventTriggerGpioMode & 0;
    /** Active while the pin is high. The pin needs the gpio feature. */
    readonly WHILE_HIGH: EventTriggerGpioMode & 1;
    /** Active while the pin is low. The pin needs the gpio feature. */
    readonly WHILE_LOW: EventTriggerGpioMode & 2;
    /**
     * Active for one event cycle after an edge. Each edge is a new activation, but actions run once per cycle: of
     * several edges in one cycle, only one has an effect. The pin needs the timestamp feature, whose behavior selects
     * the edge.
     */
    readonly EDGE: EventTriggerGpioMode & 4;
};

export type EventThresholdType = Flavor<number, "event_threshold_type">;
/**
 * Comparison of a threshold trigger.
 *
 * - 3dm-cv7-gnss-ins: ThresholdParams
 */
export declare const EventThresholdType: Enumeration<EventThresholdType> & {
    /** The value is in a window between two thresholds, or outside of it. */
    readonly WINDOW: EventThresholdType & 1;
    /** The remainder of the value divided by an interval is at most a threshold. */
    readonly INTERVAL: EventThresholdType & 2;
};

export type EventActionGpioMode = Flavor<number, "event_action_gpio_mode">;
/**
 * Control of a GPIO pin by an action.
 *
 * - 3dm-cv7-gnss-ins: Event Action Configuration (0x0C,0x2F)
 * - 3dm-cv7-gnss-ins: Action: GPIO
 */
export declare const EventActionGpioMode: Enumeration<EventActionGpioMode> & {
    /** The pin is not changed. */
    readonly DISABLED: EventActionGpioMode & 0;
    /** High while the trigger is active and low otherwise. */
    readonly ACTIVE_HIGH: EventActionGpioMode & 1;
    /** Low while the trigger is active and high otherwise. */
    readonly ACTIVE_LOW: EventActionGpioMode & 2;
    /** Set high at each activation and never set low. */
    readonly ONESHOT_HIGH: EventActionGpioMode & 5;
    /** Set low at each activation and never set high. */
    readonly ONESHOT_LOW: EventActionGpioMode & 6;
    /** The pin is inverted each time the trigger activates. */
    readonly TOGGLE: EventActionGpioMode & 7;
};

/**
 * A trigger on a GPIO pin.
 *
 * - 3dm-cv7-gnss-ins: Event Trigger Configuration (0x0C,0x2E)
 */
export interface EventTriggerGpio {
    /** GPIO pin, counted from 1. Range: at least 1. */
    pin: number;
    /** Condition of the pin that activates the trigger. */
    mode: EventTriggerGpioMode;
}

/**
 * Two thresholds with a window between them.
 *
 * - 3dm-cv7-gnss-ins: ThresholdParams
 * - mip-sdk-4: Event Trigger (0x0C,0x2E)
 */
export interface EventThresholdWindow {
    /** Lower threshold, in the unit of the watched value. The SDK calls it the first threshold. */
    lowThreshold: number;
    /**
     * Upper threshold, in the unit of the watched value. The trigger is active from the lower threshold to the upper
     * one, both included. If the upper one is below the lower one, it is active below the upper and above the lower
     * one, both excluded. The SDK calls it the second threshold.
     */
    highThreshold: number;
}

/**
 * A threshold inside a repeating interval.
 *
 * - 3dm-cv7-gnss-ins: ThresholdParams
 * - mip-sdk-4: Event Trigger (0x0C,0x2E)
 */
export interface EventThresholdInterval {
    /**
     * The trigger is active while the remainder is at most this, in the unit of the watched value. The SDK calls it the
     * first threshold.
     */
    intervalThreshold: number;
    /**
     * Divisor of the remainder, in the unit of the watched value. If it is below the threshold, the two swap roles: the
     * trigger is active while the value modulo `interval_threshold` is above this. The SDK calls it the second
     * threshold.
     */
    interval: number;
}

/**
 * A trigger on one value of a data field. The value is converted to double before it is compared.
 *
 * - 3dm-cv7-gnss-ins: ThresholdParams
 */
export interface EventTriggerThreshold {
    /** Data descriptor set of the watched value. */
    descriptorSet: number;
    /** Field descriptor of the watched value. Refers to fields of `descriptorSet`. */
    fieldDescriptor: number;
    /** Number of the value in its field, counted from 1; each element of a vector counts. Range: at least 1. */
    parameterId: number;
    /** Kind of comparison. */
    type: EventThresholdType;
    /**
     * Thresholds of the comparison. Selected by `type`.
     *
     * - If `type` is `EventThresholdType.WINDOW`: `window: EventThresholdWindow`.
     * - If `type` is `EventThresholdType.INTERVAL`: `interval: EventThresholdInterval`.
     */
    thresholds: { window?: EventThresholdWindow; interval?: EventThresholdInterval };
}

/**
 * A trigger that combines up to four others.
 *
 * - 3dm-cv7-gnss-ins: CombinationParams
 * - 3dm-cv7-gnss-ins: Logical Truth Table
 */
export interface EventTriggerCombination {
    /** Bit n is the output for n = a + 2b + 4c + 8d, where a to d are the states (0 or 1) of the four inputs. */
    logicTable: number;
    /**
     * Trigger instances for the inputs a to d; 0 is always inactive. An input may be the trigger itself; its value is
     * then the output of the previous event cycle.
     */
    inputTriggers: [number, number, number, number];
}

/**
 * An action on a GPIO pin, which needs the gpio feature and an output behavior.
 *
 * - 3dm-cv7-gnss-ins: GpioParams
 */
export interface EventActionGpio {
    /** GPIO pin, counted from 1. Range: at least 1. */
    pin: number;
    /** Pin level or pulse that the action generates. */
    mode: EventActionGpioMode;
}

/**
 * An action that sends data packets.
 *
 * - 3dm-cv7-gnss-ins: MessageParams
 */
export interface EventActionMessage {
    /** Data descriptor set of the packet. */
    descriptorSet: number;
    /**
     * 0 sends one packet per activation. Any other value streams while the trigger is active, at the base rate of the
     * descriptor set divided by this value. At each activation, a packet is sent immediately and the count restarts.
     */
    decimation: number;
    /**
     * On the wire only: num_fields. Number of fields in the packet. Counts the elements of `descriptors`. Range: 0 to
     * 12.
     */
    /** Field descriptors, in order. Refers to fields of `descriptorSet`. */
    descriptors: number[];
}

export type GnssConstellation = Flavor<number, "gnss_constellation">;
/**
 * Satellite constellation. QZSS has no value.
 *
 * - 3dm-cv7-gnss-ins: Satellite Status (0x91,0x20)
 * - 3dm-cv7-gnss-ins: Raw (0x91,0x22)
 */
export declare const GnssConstellation: Enumeration<GnssConstellation> & {
    /** Not known. */
    readonly UNKNOWN: GnssConstellation & 0;
    readonly GPS: GnssConstellation & 1;
    readonly GLONASS: GnssConstellation & 2;
    readonly GALILEO: GnssConstellation & 3;
    readonly BEIDOU: GnssConstellation & 4;
    /** Satellites of augmentation systems (SBAS). */
    readonly SBAS: GnssConstellation & 5;
};

export type GnssFixType = Flavor<number, "gnss_fix_type">;
/**
 * Type of a GNSS position fix.
 *
 * - 3dm-cv7-gnss-ins: Fix Info (0x91,0x0B)
 */
export declare const GnssFixType: Enumeration<GnssFixType> & {
    /** Fix in three dimensions. */
    readonly FIX_3D: GnssFixType & 0;
    /** Fix in two dimensions. */
    readonly FIX_2D: GnssFixType & 1;
    /** The receiver computes the time, but no position. */
    readonly FIX_TIME_ONLY: GnssFixType & 2;
    /** No fix. */
    readonly FIX_NONE: GnssFixType & 3;
    /** The fix is not valid. */
    readonly FIX_INVALID: GnssFixType & 4;
    /** RTK fix with float ambiguities. */
    readonly FIX_RTK_FLOAT: GnssFixType & 5;
    /** RTK fix with integer ambiguities. */
    readonly FIX_RTK_FIXED: GnssFixType & 6;
    /** The position uses differential corrections. */
    readonly FIX_DIFFERENTIAL: GnssFixType & 7;
};

export type GnssSignal = Flavor<number, "gnss_signal">;
/**
 * Signal of a satellite.
 *
 * - 3dm-cv7-gnss-ins: Raw (0x91,0x22)
 */
export declare const GnssSignal: Enumeration<GnssSignal> & {
    /** Not known. */
    readonly UNKNOWN: GnssSignal & 0;
    /** GPS L1 C/A. */
    readonly GPS_L1CA: GnssSignal & 1;
    /** GPS L1 P(Y). */
    readonly GPS_L1P: GnssSignal & 2;
    /** GPS L1 P(Y) by Z-tracking. */
    readonly GPS_L1Z: GnssSignal & 3;
    /** GPS L2 C/A. */
    readonly GPS_L2CA: GnssSignal & 4;
    /** GPS L2 P(Y). */
    readonly GPS_L2P: GnssSignal & 5;
    /** GPS L2 P(Y) by Z-tracking. */
    readonly GPS_L2Z: GnssSignal & 6;
    /** GPS L2C(L). */
    readonly GPS_L2CL: GnssSignal & 7;
    /** GPS L2C(M). */
    readonly GPS_L2CM: GnssSignal & 8;
    /** GPS L2C(M+L). */
    readonly GPS_L2CML: GnssSignal & 9;
    /** GPS L5 I. */
    readonly GPS_L5I: GnssSignal & 10;
    /** GPS L5 Q. */
    readonly GPS_L5Q: GnssSignal & 11;
    /** GPS L5 I+Q. */
    readonly GPS_L5IQ: GnssSignal & 12;
    /** GPS L1C(D). */
    readonly GPS_L1CD: GnssSignal & 13;
    /** GPS L1C(P). */
    readonly GPS_L1CP: GnssSignal & 14;
    /** GPS L1C(D+P). */
    readonly GPS_L1CDP: GnssSignal & 15;
    /** GLONASS G1 C/A. */
    readonly GLONASS_G1CA: GnssSignal & 32;
    /** GLONASS G1 P. */
    readonly GLONASS_G1P: GnssSignal & 33;
    /** GLONASS G2 C/A. */
    readonly GLONASS_G2C: GnssSignal & 34;
    /** GLONASS G2 P. */
    readonly GLONASS_G2P: GnssSignal & 35;
    /** Galileo E1 C. */
    readonly GALILEO_E1C: GnssSignal & 64;
    /** Galileo E1 A. */
    readonly GALILEO_E1A: GnssSignal & 65;
    /** Galileo E1 B. */
    readonly GALILEO_E1B: GnssSignal & 66;
    /** Galileo E1 B+C. */
    readonly GALILEO_E1BC: GnssSignal & 67;
    /** Galileo E1 A+B+C. */
    readonly GALILEO_E1ABC: GnssSignal & 68;
    /** Galileo E6 C. */
    readonly GALILEO_E6C: GnssSignal & 69;
    /** Galileo E6 A. */
    readonly GALILEO_E6A: GnssSignal & 70;
    /** Galileo E6 B. */
    readonly GALILEO_E6B: GnssSignal & 71;
    /** Galileo E6 B+C. */
    readonly GALILEO_E6BC: GnssSignal & 72;
    /** Galileo E6 A+B+C. */
    readonly GALILEO_E6ABC: GnssSignal & 73;
    /** Galileo E5b I. */
    readonly GALILEO_E5BI: GnssSignal & 74;
    /** Galileo E5b Q. */
    readonly GALILEO_E5BQ: GnssSignal & 75;
    /** Galileo E5b I+Q. */
    readonly GALILEO_E5BIQ: GnssSignal & 76;
    /** Galileo E5 (a+b) I. */
    readonly GALILEO_E5ABI: GnssSignal & 77;
    /** Galileo E5 (a+b) Q. */
    readonly GALILEO_E5ABQ: GnssSignal & 78;
    /** Galileo E5 (a+b) I+Q. */
    readonly GALILEO_E5ABIQ: GnssSignal & 79;
    /** Galileo E5a I. */
    readonly GALILEO_E5AI: GnssSignal & 80;
    /** Galileo E5a Q. */
    readonly GALILEO_E5AQ: GnssSignal & 81;
    /** Galileo E5a I+Q. */
    readonly GALILEO_E5AIQ: GnssSignal & 82;
    /** SBAS L1 C/A. */
    readonly SBAS_L1CA: GnssSignal & 96;
    /** SBAS L5 I. */
    readonly SBAS_L5I: GnssSignal & 97;
    /** SBAS L5 Q. */
    readonly SBAS_L5Q: GnssSignal & 98;
    /** SBAS L5 I+Q. */
    readonly SBAS_L5IQ: GnssSignal & 99;
    /** QZSS L1 C/A. */
    readonly QZSS_L1CA: GnssSignal & 128;
    /** QZSS LEX S. */
    readonly QZSS_LEXS: GnssSignal & 129;
    /** QZSS LEX L. */
    readonly QZSS_LEXL: GnssSignal & 130;
    /** QZSS LEX S+L. */
    readonly QZSS_LEXSL: GnssSignal & 131;
    /** QZSS L2C(M). */
    readonly QZSS_L2CM: GnssSignal & 132;
    /** QZSS L2C(L). */
    readonly QZSS_L2CL: GnssSignal & 133;
    /** QZSS L2C(M+L). */
    readonly QZSS_L2CML: GnssSignal & 134;
    /** QZSS L5 I. */
    readonly QZSS_L5I: GnssSignal & 135;
    /** QZSS L5 Q. */
    readonly QZSS_L5Q: GnssSignal & 136;
    /** QZSS L5 I+Q. */
    readonly QZSS_L5IQ: GnssSignal & 137;
    /** QZSS L1C(D). */
    readonly QZSS_L1CD: GnssSignal & 138;
    /** QZSS L1C(P). */
    readonly QZSS_L1CP: GnssSignal & 139;
    /** QZSS L1C(D+P). */
    readonly QZSS_L1CDP: GnssSignal & 140;
    /** BeiDou B1 I. */
    readonly BEIDOU_B1I: GnssSignal & 160;
    /** BeiDou B1 Q. */
    readonly BEIDOU_B1Q: GnssSignal & 161;
    /** BeiDou B1 I+Q. */
    readonly BEIDOU_B1IQ: GnssSignal & 162;
    /** BeiDou B3 I. */
    readonly BEIDOU_B3I: GnssSignal & 163;
    /** BeiDou B3 Q. */
    readonly BEIDOU_B3Q: GnssSignal & 164;
    /** BeiDou B3 I+Q. */
    readonly BEIDOU_B3IQ: GnssSignal & 165;
    /** BeiDou B2 I. */
    readonly BEIDOU_B2I: GnssSignal & 166;
    /** BeiDou B2 Q. */
    readonly BEIDOU_B2Q: GnssSignal & 167;
    /** BeiDou B2 I+Q. */
    readonly BEIDOU_B2IQ: GnssSignal & 168;
    readonly BEIDOU_B2A: GnssSignal & 169;
};

export type GpioFeature = Flavor<number, "gpio_feature">;
/**
 * Use of a GPIO pin.
 *
 * - 3dm-cv7-gnss-ins: GPIO Configuration (0x0C,0x41)
 * - 3dm-cv7-gnss-ins: GPIO Features
 */
export declare const GpioFeature: Enumeration<GpioFeature> & {
    /** Not connected. Reading the pin may work but is not guaranteed. */
    readonly UNUSED: GpioFeature & 0;
    /** General input or output. */
    readonly GPIO: GpioFeature & 1;
    /** Input or output of the pulse per second. */
    readonly PPS: GpioFeature & 2;
    /** Input of a motor encoder or odometer. */
    readonly ENCODER: GpioFeature & 3;
    /** Input whose edges get precise timestamps for event triggers. */
    readonly TIMESTAMP: GpioFeature & 4;
    /** Data or control line of a UART. */
    readonly UART: GpioFeature & 5;
};

export type GpioUnusedBehavior = Flavor<number, "gpio_unused_behavior">;
/** Behavior of a pin whose feature is unused. */
export declare const GpioUnusedBehavior: Enumeration<GpioUnusedBehavior> & {
    /** No other value is defined. */
    readonly UNUSED: GpioUnusedBehavior & 0;
};

export type GpioBehavior = Flavor<number, "gpio_behavior">;
/** Behavior of a pin whose feature is gpio. */
export declare const GpioBehavior: Enumeration<GpioBehavior> & {
    /** Input; the default. */
    readonly INPUT: GpioBehavior & 1;
    /** Output, initially low; also low at power-up if the configuration is saved. */
    readonly OUTPUT_LOW: GpioBehavior & 2;
    /** Output, initially high; also high at power-up if the configuration is saved. */
    readonly OUTPUT_HIGH: GpioBehavior & 3;
};

export type GpioPpsBehavior = Flavor<number, "gpio_pps_behavior">;
/** Behavior of a pin whose feature is pps. */
export declare const GpioPpsBehavior: Enumeration<GpioPpsBehavior> & {
    /** The pin receives the pulse; the PPS source must be gpio. At most one pin. */
    readonly INPUT: GpioPpsBehavior & 1;
    /** The pin sends the pulse of the device. */
    readonly OUTPUT: GpioPpsBehavior & 2;
};

export type GpioEncoderBehavior = Flavor<number, "gpio_encoder_behavior">;
/** Behavior of a pin whose feature is encoder. */
export declare const GpioEncoderBehavior: Enumeration<GpioEncoderBehavior> & {
    /** Quadrature input A. At most one pin; the last one configured takes precedence. */
    readonly A: GpioEncoderBehavior & 1;
    /** Quadrature input B. At most one pin; the last one configured takes precedence. */
    readonly B: GpioEncoderBehavior & 2;
};

export type GpioTimestampBehavior = Flavor<number, "gpio_timestamp_behavior">;
/** Behavior of a pin whose feature is timestamp. */
export declare const GpioTimestampBehavior: Enumeration<GpioTimestampBehavior> & {
    /** Rising edges get timestamps. */
    readonly RISING: GpioTimestampBehavior & 1;
    /** Falling edges get timestamps. */
    readonly FALLING: GpioTimestampBehavior & 2;
    /** Both edges get timestamps. */
    readonly EITHER: GpioTimestampBehavior & 3;
};

export type GpioUartBehavior = Flavor<number, "gpio_uart_behavior">;
/** Behavior of a pin whose feature is uart. */
export declare const GpioUartBehavior: Enumeration<GpioUartBehavior> & {
    /** UART 2 transmits. */
    readonly PORT_2_TX: GpioUartBehavior & 33;
    /** UART 2 receives. */
    readonly PORT_2_RX: GpioUartBehavior & 34;
    /** UART 3 transmits. */
    readonly PORT_3_TX: GpioUartBehavior & 49;
    /** UART 3 receives. */
    readonly PORT_3_RX: GpioUartBehavior & 50;
};

export type GpioPinMode = Flavor<number, "gpio_pin_mode">;
/**
 * Electrical options of a GPIO pin. The allowed ones depend on the device, the pin, the feature and the behavior.
 *
 * - 3dm-cv7-gnss-ins: GPIO Configuration (0x0C,0x41)
 * - 3dm-cv7-gnss-ins: Pin Mode
 */
export declare const GpioPinMode: Bitfield<GpioPinMode> & {
    /** The output drives low or floats. It usually needs a pull-up. Bit 0. */
    readonly OPEN_DRAIN: GpioPinMode;
    /** Internal pull-down resistor; not together with the pull-up. Bit 1. */
    readonly PULLDOWN: GpioPinMode;
    /** Internal pull-up resistor; not together with the pull-down. May lower the allowed input voltage. Bit 2. */
    readonly PULLUP: GpioPinMode;
};

export type NmeaMessageId = Flavor<number, "nmea_message_id">;
/**
 * An NMEA-0183 sentence that a device can send.
 *
 * - 3dm-cv7-gnss-ins: Supported Sentences and Talker IDs
 * - 3dm-cv7-gnss-ins: PMSRA - Euler Angles
 * - 3dm-cv7-gnss-ins: PMSRR - Angular Rate and Acceleration
 */
export declare const NmeaMessageId: Enumeration<NmeaMessageId> & {
    /** GNSS fix, from a GNSS data set or the filter data set. */
    readonly GGA: NmeaMessageId & 1;
    /** Latitude and longitude, from a GNSS data set or the filter data set. */
    readonly GLL: NmeaMessageId & 2;
    /** Satellites in view, from a GNSS data set. The constellation determines the talker. */
    readonly GSV: NmeaMessageId & 3;
    /** Recommended minimum GNSS data, from a GNSS data set or the filter data set. */
    readonly RMC: NmeaMessageId & 4;
    /** Course and speed over ground, from a GNSS data set or the filter data set. */
    readonly VTG: NmeaMessageId & 5;
    /** True heading, from a GNSS data set or the filter data set. */
    readonly HDT: NmeaMessageId & 6;
    /** Time and date, from a GNSS data set. */
    readonly ZDA: NmeaMessageId & 7;
    /** GNSS error statistics, from a GNSS data set or the filter data set. */
    readonly GST: NmeaMessageId & 8;
    /**
     * Proprietary sentence `$PMSRA,hhmmss.ss,roll,pitch,yaw*hh`: UTC time and Euler angles in degrees with three
     * decimals. From the filter data set.
     */
    readonly MSRA: NmeaMessageId & 129;
    /**
     * Proprietary sentence `$PMSRR,hhmmss.ss,ax,ay,az,wx,wy,wz*hh`: UTC time, acceleration in g and angular rate in
     * deg/s about the x, y and z axes, with six decimals. From the sensor data set.
     */
    readonly MSRR: NmeaMessageId & 130;
};

export type NmeaTalkerId = Flavor<number, "nmea_talker_id">;
/**
 * The first letters of an NMEA-0183 sentence, which identify its talker.
 *
 * - 3dm-cv7-gnss-ins: Supported Sentences and Talker IDs
 */
export declare const NmeaTalkerId: Enumeration<NmeaTalkerId> & {
    /** For sentences whose talker cannot be chosen (GSV and the proprietary ones). */
    readonly IGNORED: NmeaTalkerId & 0;
    /** Talker GN: several constellations. */
    readonly GNSS: NmeaTalkerId & 1;
    /** Talker GP: GPS only. */
    readonly GPS: NmeaTalkerId & 2;
    /** Talker GA: Galileo only. */
    readonly GALILEO: NmeaTalkerId & 3;
    /** Talker GL: GLONASS only. */
    readonly GLONASS: NmeaTalkerId & 4;
};

/**
 * An NMEA-0183 sentence with its talker, its data source and how often it is sent.
 *
 * - 3dm-cv7-gnss-ins: Sources and Talker IDs
 */
export interface NmeaMessage {
    /** The sentence. */
    messageId: NmeaMessageId;
    /** The talker in the sentence. */
    talkerId: NmeaTalkerId;
    /** Data descriptor set from which the contents are taken. */
    sourceDescriptorSet: number;
    /** Base rate of the source descriptor set divided by the desired rate; a poll ignores it. */
    decimation: number;
}

export type CommInterface = Flavor<number, "comm_interface">;
/**
 * A port of a device.
 *
 * - 3dm-cv7-gnss-ins: Ports
 * - mip-sdk-4: Interface Control (0x7F,0x02)
 */
export declare const CommInterface: Enumeration<CommInterface> & {
    /** All ports. */
    readonly ALL: CommInterface & 0;
    /** The main port: USB while a host has it open (DTR), else the main UART. */
    readonly MAIN: CommInterface & 1;
    /** The first port that is a UART or can be one. */
    readonly UART_1: CommInterface & 17;
    /** The second UART, on GPIO pins 1 and 2 of the 3DM-CV7 and 3DM-GV7 models. */
    readonly UART_2: CommInterface & 18;
    /** The third UART, on GPIO pins 3 and 4 of the 3DM-CV7 models. */
    readonly UART_3: CommInterface & 19;
    /** First USB virtual serial port. */
    readonly USB_1: CommInterface & 33;
    /** Second USB virtual serial port; on GNSS/INS models, intended for NMEA and RTCM. */
    readonly USB_2: CommInterface & 34;
};

export type RtkStatusFlags = Flavor<number, "rtk_status_flags">;
/**
 * State of the modem and of the corrections. If `version` is 0, as sent by modems of the first generation, the other
 * bits have no meaning here: read the word as `RtkStatusFlagsLegacy`. Uncertain: The SDK states only that the form
 * depends on the model number. Uncertain: Other software of the vendor evaluates `version`: 0 is the legacy form, 1 is
 * this one. In the legacy form of the SDK the same two bits are `sinr`. Uncertain: The SDK lists only the names, from
 * which the descriptions are inferred. The meaning of the values is not known.
 *
 * - mip-sdk-4: Get Status Flags (0x0F,0x01)
 */
export declare const RtkStatusFlags: Bitfield<RtkStatusFlags> & {
    /** State of the modem. Bits 0 to 3. */
    readonly MODEM_STATE: RtkStatusFlags;
    /** Kind of cellular connection. Bits 4 to 7. */
    readonly CONNECTION_TYPE: RtkStatusFlags;
    /**
     * Received signal strength. Bits 8 to 15. Uncertain: No source states the unit and the sign; other software of the
     * vendor treats it as negative.
     */
    readonly RSSI: RtkStatusFlags;
    /** Quality of the modem's radio signal. Bits 16 to 19. */
    readonly SIGNAL_QUALITY: RtkStatusFlags;
    /** Cell tower changes. Bits 20 to 23. */
    readonly TOWER_CHANGE_INDICATOR: RtkStatusFlags;
    /** No NMEA was received from the device in time. Bit 24. */
    readonly NMEA_TIMEOUT: RtkStatusFlags;
    /** The server did not answer in time. Bit 25. */
    readonly SERVER_TIMEOUT: RtkStatusFlags;
    /** No corrections were received in time. Bit 26. */
    readonly CORRECTIONS_TIMEOUT: RtkStatusFlags;
    /** The device is outside the service area. Bit 27. */
    readonly DEVICE_OUT_OF_RANGE: RtkStatusFlags;
    /** There are no corrections. Bit 28. */
    readonly CORRECTIONS_UNAVAILABLE: RtkStatusFlags;
    /** Form of these flags. Bits 30 to 31. */
    readonly VERSION: RtkStatusFlags;
};

export type RtkStatusFlagsLegacy = Flavor<number, "rtk_status_flags_legacy">;
/**
 * State of the modem and the corrections, in the older layout. Uncertain: The form depends on the model; see
 * `RtkStatusFlags`. Uncertain: The SDK calls bits 20-31 reserved, but also puts the last four numbers there. Uncertain:
 * The SDK lists only the names, from which the descriptions are inferred. The meaning of the values is not known.
 *
 * - mip-sdk-4: Get Status Flags (0x0F,0x01)
 */
export declare const RtkStatusFlagsLegacy: Bitfield<RtkStatusFlagsLegacy> & {
    /** State of the controller. Bits 0 to 2. */
    readonly CONTROLLER_STATE: RtkStatusFlagsLegacy;
    /** State of the platform. Bits 3 to 7. */
    readonly PLATFORM_STATE: RtkStatusFlagsLegacy;
    /** Status code of the controller. Bits 8 to 10. */
    readonly CONTROLLER_STATUS_CODE: RtkStatusFlagsLegacy;
    /** Status code of the platform. Bits 11 to 13. */
    readonly PLATFORM_STATUS_CODE: RtkStatusFlagsLegacy;
    /** Reason for the last reset. Bits 14 to 15. */
    readonly RESET_CODE: RtkStatusFlagsLegacy;
    /** Quality of the modem's radio signal. Bits 16 to 19. */
    readonly SIGNAL_QUALITY: RtkStatusFlagsLegacy;
    /** Received signal strength. Bits 20 to 25. */
    readonly RSSI: RtkStatusFlagsLegacy;
    /** Received power of the reference signal. Bits 26 to 27. */
    readonly RSRP: RtkStatusFlagsLegacy;
    /** Received quality of the reference signal. Bits 28 to 29. */
    readonly RSRQ: RtkStatusFlagsLegacy;
    /** Signal to interference and noise ratio. Bits 30 to 31. */
    readonly SINR: RtkStatusFlagsLegacy;
};

/** Three floats. Elements: x, y, z. */
export type Vector3f = [x: number, y: number, z: number];

/** Three doubles. Elements: x, y, z. */
export type Vector3d = [x: number, y: number, z: number];

/** Three floats in the NED frame. Elements: north, east, down. */
export type Ned3f = [north: number, east: number, down: number];

/** Three doubles in the NED frame. Elements: north, east, down. */
export type Ned3d = [north: number, east: number, down: number];

/** Three by three floats in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. */
export type Matrix3f = [m11: number, m12: number, m13: number, m21: number, m22: number, m23: number, m31: number, m32: number, m33: number];

/** A quaternion, scalar part first. Elements: w, x, y, z. */
export type Quatf = [w: number, x: number, y: number, z: number];

export type AckCode = Flavor<number, "ack_code">;
/**
 * The result of a command.
 *
 * - 3dm-gx5-15: 4.5 Error Codes
 * - 3dm-cv7-gnss-ins: Ack/Nack Codes
 */
export declare const AckCode: Enumeration<AckCode> & {
    /** The command was carried out. */
    readonly OK: AckCode & 0;
    /** The device does not know the command descriptor. */
    readonly UNKNOWN_COMMAND: AckCode & 1;
    /** A complete packet had a wrong checksum. */
    readonly BAD_CHECKSUM: AckCode & 2;
    /** A parameter is out of range, or of the wrong size or type. */
    readonly INVALID_PARAMETER: AckCode & 3;
    /** The device could not carry out the command. */
    readonly COMMAND_FAILED: AckCode & 4;
    /** The command did not finish in time. */
    readonly COMMAND_TIMEOUT: AckCode & 5;
    /** The device does not know the descriptor set. */
    readonly UNKNOWN_DESCRIPTOR_SET: AckCode & 6;
};

/** A field of a message format and how often it is sent. */
export interface DescriptorRate {
    /** Field descriptor. */
    descriptor: number;
    /** Base rate divided by the desired rate. Range: at least 1. */
    decimation: number;
}

export type SensorGpsTimestampFlags = Flavor<number, "sensor_gps_timestamp_flags">;
/**
 * State of the GPS time of sensor data.
 *
 * - 3dm-cv7-gnss-ins: GPS Timestamp (0x80,0x12)
 */
export declare const SensorGpsTimestampFlags: Bitfield<SensorGpsTimestampFlags> & {
    /** The PPS signal is present. Bit 0. */
    readonly PPS_VALID: SensorGpsTimestampFlags;
    /** Toggles each time the time is updated. Bit 1. */
    readonly TIME_REFRESH: SensorGpsTimestampFlags;
    /** The time has been set at least once. Bit 2. */
    readonly TIME_INITIALIZED: SensorGpsTimestampFlags;
    /** The time of week is valid. Bit 3. */
    readonly TOW_VALID: SensorGpsTimestampFlags;
    /** The week number is valid. Bit 4. */
    readonly WEEK_NUMBER_VALID: SensorGpsTimestampFlags;
};

export type Gx5SensorGpsTimestampFlags = Flavor<number, "gx5_sensor_gps_timestamp_flags">;
/**
 * State of the GPS time of sensor data on the 3DM-GX5-15, which has no bits for the validity of the values.
 *
 * - 3dm-gx5-15: 5.1.11 GPS Correlation Timestamp (0x80, 0x12)
 */
export declare const Gx5SensorGpsTimestampFlags: Bitfield<Gx5SensorGpsTimestampFlags> & {
    /** The PPS signal is present; without it, the internal clock drives the time. Bit 0. */
    readonly PPS_VALID: Gx5SensorGpsTimestampFlags;
    /** Toggles each time the time is updated. Bit 1. */
    readonly TIME_REFRESH: Gx5SensorGpsTimestampFlags;
    /** The time has been set at least once. Bit 2. */
    readonly TIME_INITIALIZED: Gx5SensorGpsTimestampFlags;
};
