/**
 * @file
 * Types that more than one descriptor set uses.
 */
#ifndef MIP_TYPES_H
#define MIP_TYPES_H

#include "mip/core.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/types.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Result of the built-in test of the 3DM-GX5-15: processor board, sensor board, filter.
 *
 * - 3dm-gx5-15: 4.1.5 Device Built-In Test (0x01, 0x05)
 */
typedef uint32_t mip_gx5_built_in_test;
/** Bit 0. The watchdog has reset the processor; cleared by the first commanded test. */
#define MIP_GX5_BUILT_IN_TEST_WATCHDOG_RESET UINT32_C(0x00000001)
/** Bit 8. No communication with the inertial sensor. */
#define MIP_GX5_BUILT_IN_TEST_IMU_COMM_FAULT UINT32_C(0x00000100)
/** Bit 9. Magnetometer fault, on devices that have one. Affects mip_sensor_scaled_mag. */
#define MIP_GX5_BUILT_IN_TEST_MAG_FAULT UINT32_C(0x00000200)
/** Bit 10. Pressure sensor fault, on devices that have one. Affects mip_sensor_scaled_pressure. */
#define MIP_GX5_BUILT_IN_TEST_PRESSURE_SENSOR_FAULT UINT32_C(0x00000400)
/** Bit 24. Fault of the estimation filter solution. Affects mip_filter_reset. */
#define MIP_GX5_BUILT_IN_TEST_SOLUTION_FAULT UINT32_C(0x01000000)

/**
 * Result of the commanded built-in test of the 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Commanded Built-in Test
 */
typedef uint32_t mip_cv7_built_in_test;
/** Bit 0. A critical part, such as the oscillator, has failed. */
#define MIP_CV7_BUILT_IN_TEST_GENERAL_HARDWARE_FAULT UINT32_C(0x00000001)
/** Bit 1. The firmware encountered a serious or unexpected condition. */
#define MIP_CV7_BUILT_IN_TEST_GENERAL_FIRMWARE_FAULT UINT32_C(0x00000002)
/** Bit 2. The processor cannot keep up; cleared by reading the result. */
#define MIP_CV7_BUILT_IN_TEST_TIMING_OVERLOAD UINT32_C(0x00000004)
/** Bit 3. A data buffer was full, usually because too much data is streamed. */
#define MIP_CV7_BUILT_IN_TEST_BUFFER_OVERRUN UINT32_C(0x00000008)
/** Bit 12. The accelerometer is damaged or does not work. Affects mip_sensor_scaled_accel. */
#define MIP_CV7_BUILT_IN_TEST_ACCEL_FAULT UINT32_C(0x00001000)
/** Bit 13. The gyroscope is damaged or does not work. Affects mip_sensor_scaled_gyro. */
#define MIP_CV7_BUILT_IN_TEST_GYRO_FAULT UINT32_C(0x00002000)
/** Bit 14. The magnetometer is damaged or does not work. Affects mip_sensor_scaled_mag. */
#define MIP_CV7_BUILT_IN_TEST_MAG_FAULT UINT32_C(0x00004000)
/** Bit 15. The pressure sensor is damaged or does not work. Affects mip_sensor_scaled_pressure. */
#define MIP_CV7_BUILT_IN_TEST_PRESSURE_SENSOR_FAULT UINT32_C(0x00008000)
/** Bit 18. At least one calibration table of the sensors is invalid. */
#define MIP_CV7_BUILT_IN_TEST_CALIBRATION_ERROR UINT32_C(0x00040000)
/** Bit 19. A fault of the inertial sensor subsystem that no other bit covers. */
#define MIP_CV7_BUILT_IN_TEST_GENERAL_IMU_FAULT UINT32_C(0x00080000)
/**
 * Bit 22. The filter output is invalid (not a number); reset the filter. Affects mip_filter_reset.
 */
#define MIP_CV7_BUILT_IN_TEST_FILTER_SOLUTION_FAULT UINT32_C(0x00400000)
/** Bit 23. A fault of the filter subsystem that no other bit covers. */
#define MIP_CV7_BUILT_IN_TEST_GENERAL_FILTER_FAULT UINT32_C(0x00800000)

/**
 * Flags of the continuous built-in test of the 3DM-CV7-GNSS/INS: bits 0-31 system, 32-63 inertial
 * sensors, 64-95 navigation, 96-127 GNSS.
 *
 * - 3dm-cv7-gnss-ins: Continuous Built-in Test
 */
struct mip_cv7_continuous_built_in_test {
    /** Least significant byte first. */
    uint8_t bytes[16];
};
/** Bit 0. The system clock does not work properly. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_SYSTEM_CLOCK_FAILURE MIP_BITS(0, 1)
/** Bit 1. The supply voltage is out of range, or an internal supply has failed. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_POWER_FAULT MIP_BITS(1, 1)
/** Bit 4. The firmware encountered an unexpected condition. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_FIRMWARE_FAULT MIP_BITS(4, 1)
/** Bit 5. The processor cannot keep up. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_TIMING_OVERLOAD MIP_BITS(5, 1)
/** Bit 6. A data buffer was full and data may be lost. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_BUFFER_OVERRUN MIP_BITS(6, 1)
/** Bit 16. The inertial sensor subsystem is not running or did not start. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_IMU_PROCESS_FAULT MIP_BITS(16, 1)
/** Bit 17. The processing of sensor data took too long. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_IMU_DATA_PROCESS_TIME_EXCEEDED MIP_BITS(17, 1)
/** Bit 18. Sensor data is not produced at its base rate. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_IMU_DATA_RATE_ERROR MIP_BITS(18, 1)
/** Bit 19. The inertial sensor subsystem produces no data. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_IMU_STALL MIP_BITS(19, 1)
/** Bits 20 to 23. Set if any filter fault (bits 20-23) is set. Overlaps other bits. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_FILTER_PROCESS_FAULT MIP_BITS(20, 4)
/** Bit 20. Fault of the major cycle of the filter; bits 22 and 23 show which fault. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_FILTER_MAJOR_CYCLE_FAULT MIP_BITS(20, 1)
/** Bit 21. Fault of the minor cycle of the filter; bits 22 and 23 show which fault. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_FILTER_MINOR_CYCLE_FAULT MIP_BITS(21, 1)
/** Bit 22. A filter process misses its base rate; bits 20 and 21 show which. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_FILTER_DATA_RATE_ERROR MIP_BITS(22, 1)
/** Bit 23. A filter process produces no data; bits 20 and 21 show which. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_FILTER_PROCESS_STALL MIP_BITS(23, 1)
/** Bits 24 to 27. Set if any GNSS fault (bits 24-27) is set. Overlaps other bits. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_GNSS_SUBSYSTEM_FAULT MIP_BITS(24, 4)
/** Bit 24. The main GNSS process did not run in time. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_GNSS_MAIN_PROCESS_FAULT MIP_BITS(24, 1)
/** Bit 25. No data from internal receiver 1 in time. Affects mip_gnss_data_fix_info. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_GNSS_RECEIVER_1_STALL MIP_BITS(25, 1)
/** Bit 26. No data from internal receiver 2 in time. Affects mip_gnss_data_fix_info. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_GNSS_RECEIVER_2_STALL MIP_BITS(26, 1)
/** Bit 33. No communication with the inertial sensors. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_IMU_COMM_FAULT MIP_BITS(33, 1)
/** Bit 34. Inertial sensor processes take longer than their time slot. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_IMU_TIMING_OVERRUN MIP_BITS(34, 1)
/** Bit 36. Accelerometer calibration fault. Affects mip_sensor_scaled_accel. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_IMU_CALIBRATION_ERROR_ACCEL MIP_BITS(36, 1)
/** Bit 37. Gyroscope calibration fault. Affects mip_sensor_scaled_gyro. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_IMU_CALIBRATION_ERROR_GYRO MIP_BITS(37, 1)
/** Bit 38. Magnetometer calibration fault. Affects mip_sensor_scaled_mag. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_IMU_CALIBRATION_ERROR_MAG MIP_BITS(38, 1)
/** Bit 40. The accelerometer failed to initialize. Affects mip_sensor_scaled_accel. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_ACCEL_GENERAL_FAULT MIP_BITS(40, 1)
/**
 * Bit 41. The acceleration along an axis is near or outside the selected range. Affects
 * mip_sensor_scaled_accel.
 */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_ACCEL_OVER_RANGE MIP_BITS(41, 1)
/**
 * Bit 42. The accelerometer self-test failed; the commanded built-in test updates this bit. Affects
 * mip_sensor_scaled_accel.
 */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_ACCEL_SELF_TEST_FAIL MIP_BITS(42, 1)
/** Bit 44. The gyroscope failed to initialize. Affects mip_sensor_scaled_gyro. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_GYRO_GENERAL_FAULT MIP_BITS(44, 1)
/**
 * Bit 45. The angular rate about an axis is near or outside the selected range. Affects
 * mip_sensor_scaled_gyro.
 */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_GYRO_OVER_RANGE MIP_BITS(45, 1)
/**
 * Bit 46. The gyroscope self-test failed; the commanded built-in test updates this bit. Affects
 * mip_sensor_scaled_gyro.
 */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_GYRO_SELF_TEST_FAIL MIP_BITS(46, 1)
/** Bit 48. The magnetometer failed to initialize. Affects mip_sensor_scaled_mag. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_MAG_GENERAL_FAULT MIP_BITS(48, 1)
/**
 * Bit 49. The magnetic field along an axis is near or outside the supported range. Affects
 * mip_sensor_scaled_mag.
 */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_MAG_OVER_RANGE MIP_BITS(49, 1)
/**
 * Bit 50. The magnetometer self-test failed; the commanded built-in test updates this bit. Affects
 * mip_sensor_scaled_mag.
 */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_MAG_SELF_TEST_FAIL MIP_BITS(50, 1)
/** Bit 52. The pressure sensor failed to initialize. Affects mip_sensor_scaled_pressure. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_PRESSURE_SENSOR_GENERAL_FAULT MIP_BITS(52, 1)
/** Bit 53. The pressure is outside the supported range. Affects mip_sensor_scaled_pressure. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_PRESSURE_SENSOR_OVER_RANGE MIP_BITS(53, 1)
/**
 * Bit 54. The pressure sensor self-test failed; the commanded built-in test updates this bit.
 * Affects mip_sensor_scaled_pressure.
 */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_PRESSURE_SENSOR_SELF_TEST_FAIL MIP_BITS(54, 1)
/** Bit 56. The device has lost its factory configuration. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_FACTORY_BITS_INVALID MIP_BITS(56, 1)
/** Bit 66. Filter processes take longer than their time slot. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_FILTER_TIMING_OVERRUN MIP_BITS(66, 1)
/** Bit 67. Filter processes are skipped. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_FILTER_TIMING_UNDERRUN MIP_BITS(67, 1)
/** Bit 105. No communication with internal receiver 1. Affects mip_gnss_data_fix_info. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_RECEIVER_1_FAULT MIP_BITS(105, 1)
/**
 * Bit 108. Internal receiver 1 has no valid solution; usually for lack of a sky view. Affects
 * mip_gnss_data_fix_info.
 */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_RECEIVER_1_NO_SOLUTION MIP_BITS(108, 1)
/** Bit 110. No communication with internal receiver 2. Affects mip_gnss_data_fix_info. */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_RECEIVER_2_FAULT MIP_BITS(110, 1)
/**
 * Bit 113. Internal receiver 2 has no valid solution; usually for lack of a sky view. Affects
 * mip_gnss_data_fix_info.
 */
#define MIP_CV7_CONTINUOUS_BUILT_IN_TEST_RECEIVER_2_NO_SOLUTION MIP_BITS(113, 1)

/**
 * Flags of the continuous built-in test of devices of generation 7 without a GNSS receiver: bits
 * 0-31 system, 32-63 inertial sensors, 64-95 navigation. Full name:
 * cv7_inertial_continuous_built_in_test. Uncertain: The sources list only the numbers and names of
 * the bits; the descriptions are those of the 3DM-CV7-GNSS/INS where the names are the same.
 *
 * - ros-driver: Built-in test of the CV7
 * - mscl: Continuous built-in test
 */
struct mip_cv7_inertial_bit {
    /** Least significant byte first. */
    uint8_t bytes[16];
};
/** Bit 0. The system clock does not work properly. */
#define MIP_CV7_INERTIAL_BIT_SYSTEM_CLOCK_FAILURE MIP_BITS(0, 1)
/** Bit 1. The supply voltage is out of range, or an internal supply has failed. */
#define MIP_CV7_INERTIAL_BIT_POWER_FAULT MIP_BITS(1, 1)
/** Bit 4. The firmware encountered an unexpected condition. */
#define MIP_CV7_INERTIAL_BIT_FIRMWARE_FAULT MIP_BITS(4, 1)
/** Bit 5. The processor cannot keep up. */
#define MIP_CV7_INERTIAL_BIT_TIMING_OVERLOAD MIP_BITS(5, 1)
/** Bit 6. A data buffer was full and data may be lost. */
#define MIP_CV7_INERTIAL_BIT_BUFFER_OVERRUN MIP_BITS(6, 1)
/** Bit 16. The inertial sensor subsystem is not running or did not start. */
#define MIP_CV7_INERTIAL_BIT_IMU_PROCESS_FAULT MIP_BITS(16, 1)
/** Bit 17. Sensor data is not produced at its base rate. */
#define MIP_CV7_INERTIAL_BIT_IMU_DATA_RATE_MISMATCH MIP_BITS(17, 1)
/** Bit 18. Sensor data was dropped. */
#define MIP_CV7_INERTIAL_BIT_IMU_OVERRUN_DROPPED_DATA MIP_BITS(18, 1)
/** Bit 19. The inertial sensor process is stuck. */
#define MIP_CV7_INERTIAL_BIT_IMU_STUCK MIP_BITS(19, 1)
/** Bit 20. The filter process failed. */
#define MIP_CV7_INERTIAL_BIT_FILTER_PROCESS_FAULT MIP_BITS(20, 1)
/** Bit 21. The filter dropped data. */
#define MIP_CV7_INERTIAL_BIT_FILTER_DROPPED_DATA MIP_BITS(21, 1)
/** Bit 22. Filter data is not produced at its base rate. */
#define MIP_CV7_INERTIAL_BIT_FILTER_RATE_MISMATCH MIP_BITS(22, 1)
/** Bit 23. The filter process is stuck. */
#define MIP_CV7_INERTIAL_BIT_FILTER_STUCK MIP_BITS(23, 1)
/** Bit 32. The inertial sensor clock failed. */
#define MIP_CV7_INERTIAL_BIT_IMU_CLOCK_FAULT MIP_BITS(32, 1)
/** Bit 33. No communication with the inertial sensors. */
#define MIP_CV7_INERTIAL_BIT_IMU_COMM_FAULT MIP_BITS(33, 1)
/** Bit 34. Inertial sensor processes take longer than their time slot. */
#define MIP_CV7_INERTIAL_BIT_IMU_TIMING_OVERRUN MIP_BITS(34, 1)
/** Bit 36. Accelerometer calibration fault. Affects mip_sensor_scaled_accel. */
#define MIP_CV7_INERTIAL_BIT_IMU_CALIBRATION_ERROR_ACCEL MIP_BITS(36, 1)
/** Bit 37. Gyroscope calibration fault. Affects mip_sensor_scaled_gyro. */
#define MIP_CV7_INERTIAL_BIT_IMU_CALIBRATION_ERROR_GYRO MIP_BITS(37, 1)
/** Bit 38. Magnetometer calibration fault. Affects mip_sensor_scaled_mag. */
#define MIP_CV7_INERTIAL_BIT_IMU_CALIBRATION_ERROR_MAG MIP_BITS(38, 1)
/** Bit 40. The accelerometer failed to initialize. Affects mip_sensor_scaled_accel. */
#define MIP_CV7_INERTIAL_BIT_ACCEL_GENERAL_FAULT MIP_BITS(40, 1)
/**
 * Bit 41. The acceleration along an axis is near or outside the selected range. Affects
 * mip_sensor_scaled_accel.
 */
#define MIP_CV7_INERTIAL_BIT_ACCEL_OVER_RANGE MIP_BITS(41, 1)
/**
 * Bit 42. The accelerometer self-test failed; the commanded built-in test updates this bit. Affects
 * mip_sensor_scaled_accel.
 */
#define MIP_CV7_INERTIAL_BIT_ACCEL_SELF_TEST_FAIL MIP_BITS(42, 1)
/** Bit 44. The gyroscope failed to initialize. Affects mip_sensor_scaled_gyro. */
#define MIP_CV7_INERTIAL_BIT_GYRO_GENERAL_FAULT MIP_BITS(44, 1)
/**
 * Bit 45. The angular rate about an axis is near or outside the selected range. Affects
 * mip_sensor_scaled_gyro.
 */
#define MIP_CV7_INERTIAL_BIT_GYRO_OVER_RANGE MIP_BITS(45, 1)
/**
 * Bit 46. The gyroscope self-test failed; the commanded built-in test updates this bit. Affects
 * mip_sensor_scaled_gyro.
 */
#define MIP_CV7_INERTIAL_BIT_GYRO_SELF_TEST_FAIL MIP_BITS(46, 1)
/** Bit 48. The magnetometer failed to initialize. Affects mip_sensor_scaled_mag. */
#define MIP_CV7_INERTIAL_BIT_MAG_GENERAL_FAULT MIP_BITS(48, 1)
/**
 * Bit 49. The magnetic field along an axis is near or outside the supported range. Affects
 * mip_sensor_scaled_mag.
 */
#define MIP_CV7_INERTIAL_BIT_MAG_OVER_RANGE MIP_BITS(49, 1)
/**
 * Bit 50. The magnetometer self-test failed; the commanded built-in test updates this bit. Affects
 * mip_sensor_scaled_mag.
 */
#define MIP_CV7_INERTIAL_BIT_MAG_SELF_TEST_FAIL MIP_BITS(50, 1)
/** Bit 52. The pressure sensor failed to initialize. Affects mip_sensor_scaled_pressure. */
#define MIP_CV7_INERTIAL_BIT_PRESSURE_SENSOR_GENERAL_FAULT MIP_BITS(52, 1)
/** Bit 53. The pressure is outside the supported range. Affects mip_sensor_scaled_pressure. */
#define MIP_CV7_INERTIAL_BIT_PRESSURE_SENSOR_OVER_RANGE MIP_BITS(53, 1)
/**
 * Bit 54. The pressure sensor self-test failed; the commanded built-in test updates this bit.
 * Affects mip_sensor_scaled_pressure.
 */
#define MIP_CV7_INERTIAL_BIT_PRESSURE_SENSOR_SELF_TEST_FAIL MIP_BITS(54, 1)
/** Bit 56. The device has lost its factory configuration. */
#define MIP_CV7_INERTIAL_BIT_FACTORY_BITS_INVALID MIP_BITS(56, 1)
/** Bit 64. The filter does not work normally. */
#define MIP_CV7_INERTIAL_BIT_FILTER_FAULT MIP_BITS(64, 1)
/** Bit 66. Filter processes take longer than their time slot. */
#define MIP_CV7_INERTIAL_BIT_FILTER_TIMING_OVERRUN MIP_BITS(66, 1)
/** Bit 67. Filter processes are skipped. */
#define MIP_CV7_INERTIAL_BIT_FILTER_TIMING_UNDERRUN MIP_BITS(67, 1)

/**
 * Flags of the continuous built-in test of the 3DM-GQ7: bits 0-31 system, 32-63 inertial sensors,
 * 64-95 navigation, 96-127 GNSS. Uncertain: The sources list only the numbers and names of the
 * bits; the descriptions are those of the 3DM-CV7-GNSS/INS where the names are the same.
 *
 * - ros-driver: Built-in test of the GQ7
 * - mscl: Continuous built-in test
 */
struct mip_gq7_continuous_built_in_test {
    /** Least significant byte first. */
    uint8_t bytes[16];
};
/** Bit 0. The system clock does not work properly. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_SYSTEM_CLOCK_FAILURE MIP_BITS(0, 1)
/** Bit 1. The supply voltage is out of range, or an internal supply has failed. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_POWER_FAULT MIP_BITS(1, 1)
/** Bit 4. The firmware encountered an unexpected condition. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_FIRMWARE_FAULT MIP_BITS(4, 1)
/** Bit 5. The processor cannot keep up. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_TIMING_OVERLOAD MIP_BITS(5, 1)
/** Bit 6. A data buffer was full and data may be lost. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_BUFFER_OVERRUN MIP_BITS(6, 1)
/** Bits 16 to 19. Faults of the link to the inertial sensor processor. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_IMU_IPC_FAULT MIP_BITS(16, 4)
/** Bits 20 to 23. Faults of the link to the filter processor. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_FILTER_IPC_FAULT MIP_BITS(20, 4)
/** Bits 24 to 27. Faults of the link to the GNSS processor. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_GNSS_IPC_FAULT MIP_BITS(24, 4)
/** Bit 32. The inertial sensor clock failed. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_IMU_CLOCK_FAULT MIP_BITS(32, 1)
/** Bit 33. No communication with the inertial sensors. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_IMU_COMM_FAULT MIP_BITS(33, 1)
/** Bit 34. Inertial sensor processes take longer than their time slot. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_IMU_TIMING_OVERRUN MIP_BITS(34, 1)
/** Bit 36. Accelerometer calibration fault. Affects mip_sensor_scaled_accel. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_IMU_CALIBRATION_ERROR_ACCEL MIP_BITS(36, 1)
/** Bit 37. Gyroscope calibration fault. Affects mip_sensor_scaled_gyro. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_IMU_CALIBRATION_ERROR_GYRO MIP_BITS(37, 1)
/** Bit 38. Magnetometer calibration fault. Affects mip_sensor_scaled_mag. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_IMU_CALIBRATION_ERROR_MAG MIP_BITS(38, 1)
/** Bit 40. The accelerometer failed to initialize. Affects mip_sensor_scaled_accel. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_ACCEL_GENERAL_FAULT MIP_BITS(40, 1)
/**
 * Bit 41. The acceleration along an axis is near or outside the selected range. Affects
 * mip_sensor_scaled_accel.
 */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_ACCEL_OVER_RANGE MIP_BITS(41, 1)
/**
 * Bit 42. The accelerometer self-test failed; the commanded built-in test updates this bit. Affects
 * mip_sensor_scaled_accel.
 */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_ACCEL_SELF_TEST_FAIL MIP_BITS(42, 1)
/** Bit 44. The gyroscope failed to initialize. Affects mip_sensor_scaled_gyro. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_GYRO_GENERAL_FAULT MIP_BITS(44, 1)
/**
 * Bit 45. The angular rate about an axis is near or outside the selected range. Affects
 * mip_sensor_scaled_gyro.
 */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_GYRO_OVER_RANGE MIP_BITS(45, 1)
/**
 * Bit 46. The gyroscope self-test failed; the commanded built-in test updates this bit. Affects
 * mip_sensor_scaled_gyro.
 */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_GYRO_SELF_TEST_FAIL MIP_BITS(46, 1)
/** Bit 48. The magnetometer failed to initialize. Affects mip_sensor_scaled_mag. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_MAG_GENERAL_FAULT MIP_BITS(48, 1)
/**
 * Bit 49. The magnetic field along an axis is near or outside the supported range. Affects
 * mip_sensor_scaled_mag.
 */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_MAG_OVER_RANGE MIP_BITS(49, 1)
/**
 * Bit 50. The magnetometer self-test failed; the commanded built-in test updates this bit. Affects
 * mip_sensor_scaled_mag.
 */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_MAG_SELF_TEST_FAIL MIP_BITS(50, 1)
/** Bit 52. The pressure sensor failed to initialize. Affects mip_sensor_scaled_pressure. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_PRESSURE_SENSOR_GENERAL_FAULT MIP_BITS(52, 1)
/** Bit 53. The pressure is outside the supported range. Affects mip_sensor_scaled_pressure. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_PRESSURE_SENSOR_OVER_RANGE MIP_BITS(53, 1)
/**
 * Bit 54. The pressure sensor self-test failed; the commanded built-in test updates this bit.
 * Affects mip_sensor_scaled_pressure.
 */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_PRESSURE_SENSOR_SELF_TEST_FAIL MIP_BITS(54, 1)
/** Bit 64. The filter clock failed. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_FILTER_CLOCK_FAULT MIP_BITS(64, 1)
/** Bit 65. Filter processor fault. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_FILTER_HARDWARE_FAULT MIP_BITS(65, 1)
/** Bit 66. Filter processes take longer than their time slot. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_FILTER_TIMING_OVERRUN MIP_BITS(66, 1)
/** Bit 67. Filter processes are skipped. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_FILTER_TIMING_UNDERRUN MIP_BITS(67, 1)
/** Bits 68 to 71. Filter communication errors. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_FILTER_COMM_ERROR MIP_BITS(68, 4)
/** Bit 96. The GNSS processor clock failed. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_GNSS_CLOCK_FAULT MIP_BITS(96, 1)
/** Bit 97. GNSS processor fault. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_GNSS_HARDWARE_FAULT MIP_BITS(97, 1)
/** Bits 98 to 100. GNSS processor communication errors. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_GNSS_COMM_ERROR MIP_BITS(98, 3)
/** Bit 101. GPS time fault. Affects mip_gnss_data_gps_time. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_GPS_TIME_FAULT MIP_BITS(101, 1)
/** Bit 102. A GNSS processor cycle exceeded its time slot. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_GNSS_TIMING_OVERRUN MIP_BITS(102, 1)
/** Bit 104. Receiver 1 power supply fault. Affects mip_gnss_data_fix_info. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_RECEIVER_1_POWER_FAULT MIP_BITS(104, 1)
/** Bit 105. No communication with internal receiver 1. Affects mip_gnss_data_fix_info. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_RECEIVER_1_FAULT MIP_BITS(105, 1)
/** Bit 106. Antenna 1 is shorted. Affects mip_gnss_data_hardware_status. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_ANTENNA_1_SHORTED MIP_BITS(106, 1)
/** Bit 107. Antenna 1 is not connected. Affects mip_gnss_data_hardware_status. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_ANTENNA_1_OPEN MIP_BITS(107, 1)
/** Bit 108. Receiver 1 has no solution. Affects mip_gnss_data_fix_info. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_RECEIVER_1_SOLUTION_FAULT MIP_BITS(108, 1)
/** Bit 109. Receiver 2 power supply fault. Affects mip_gnss_data_fix_info. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_RECEIVER_2_POWER_FAULT MIP_BITS(109, 1)
/** Bit 110. No communication with internal receiver 2. Affects mip_gnss_data_fix_info. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_RECEIVER_2_FAULT MIP_BITS(110, 1)
/** Bit 111. Antenna 2 is shorted. Affects mip_gnss_data_hardware_status. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_ANTENNA_2_SHORTED MIP_BITS(111, 1)
/** Bit 112. Antenna 2 is not connected. Affects mip_gnss_data_hardware_status. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_ANTENNA_2_OPEN MIP_BITS(112, 1)
/** Bit 113. Receiver 2 has no solution. Affects mip_gnss_data_fix_info. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_RECEIVER_2_SOLUTION_FAULT MIP_BITS(113, 1)
/** Bit 114. RTCM communication fault. Affects mip_gnss_data_rtk_corrections_status. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_RTCM_COMM_FAULT MIP_BITS(114, 1)
/** Bit 115. RTK modem fault. Affects mip_rtk_get_status_flags. */
#define MIP_GQ7_CONTINUOUS_BUILT_IN_TEST_RTK_DONGLE_FAULT MIP_BITS(115, 1)

/**
 * Kind of an event trigger.
 *
 * - 3dm-cv7-gnss-ins: Event Trigger Configuration (0x0C,0x2E)
 * - 3dm-cv7-gnss-ins: Types of triggers
 */
enum mip_event_trigger_type MIP_ENUM_8 {
    /** The instance is not in use: it is never active and cannot be enabled. */
    MIP_EVENT_TRIGGER_TYPE_NONE = 0,
    /** Watches a GPIO pin. */
    MIP_EVENT_TRIGGER_TYPE_GPIO = 1,
    /** Compares one value of a data field with thresholds. */
    MIP_EVENT_TRIGGER_TYPE_THRESHOLD = 2,
    /** Combines up to four other triggers in a truth table. */
    MIP_EVENT_TRIGGER_TYPE_COMBINATION = 3
};

/**
 * Kind of an event action.
 *
 * - 3dm-cv7-gnss-ins: Event Action Configuration (0x0C,0x2F)
 * - 3dm-cv7-gnss-ins: Types of actions
 */
enum mip_event_action_type MIP_ENUM_8 {
    /** The instance is not in use. */
    MIP_EVENT_ACTION_TYPE_NONE = 0,
    /** Controls a GPIO pin. */
    MIP_EVENT_ACTION_TYPE_GPIO = 1,
    /** Sends a data packet. */
    MIP_EVENT_ACTION_TYPE_MESSAGE = 2
};

/**
 * Operating mode of an event trigger.
 *
 * - 3dm-cv7-gnss-ins: Event Control (0x0C,0x2B)
 * - 3dm-cv7-gnss-ins: Enabling & Disabling Triggers
 */
enum mip_event_trigger_mode MIP_ENUM_8 {
    /** The trigger is never active. Configuring a trigger sets this mode. */
    MIP_EVENT_TRIGGER_MODE_DISABLED = 0,
    /** The trigger works as configured. */
    MIP_EVENT_TRIGGER_MODE_ENABLED = 1,
    /** The trigger is active all the time. */
    MIP_EVENT_TRIGGER_MODE_TEST = 2,
    /** The trigger is active for one event cycle and then returns to its previous mode. */
    MIP_EVENT_TRIGGER_MODE_TEST_PULSE = 3
};

/**
 * State of an event trigger.
 *
 * - 3dm-cv7-gnss-ins: Get Event Trigger Status (0x0C,0x2C)
 */
typedef uint8_t mip_event_trigger_status;
/** Bit 0. The trigger is active, because of its condition or a test mode. */
#define MIP_EVENT_TRIGGER_STATUS_ACTIVE 0x01U
/** Bit 1. The trigger is enabled. */
#define MIP_EVENT_TRIGGER_STATUS_ENABLED 0x02U
/** Bit 2. The trigger is in a test mode. */
#define MIP_EVENT_TRIGGER_STATUS_TEST 0x04U

/**
 * Condition of a GPIO pin that activates a trigger.
 *
 * - 3dm-cv7-gnss-ins: Event Trigger Configuration (0x0C,0x2E)
 * - 3dm-cv7-gnss-ins: Trigger: GPIO
 */
enum mip_event_trigger_gpio_mode MIP_ENUM_8 {
    /** The trigger is never active. */
    MIP_EVENT_TRIGGER_GPIO_MODE_DISABLED = 0,
    /** Active while the pin is high. The pin needs the gpio feature. */
    MIP_EVENT_TRIGGER_GPIO_MODE_WHILE_HIGH = 1,
    /** Active while the pin is low. The pin needs the gpio feature. */
    MIP_EVENT_TRIGGER_GPIO_MODE_WHILE_LOW = 2,
    /**
     * Active for one event cycle after an edge. Each edge is a new activation, but actions run once
     * per cycle: of several edges in one cycle, only one has an effect. The pin needs the timestamp
     * feature, whose behavior selects the edge.
     */
    MIP_EVENT_TRIGGER_GPIO_MODE_EDGE = 4
};

/**
 * Comparison of a threshold trigger.
 *
 * - 3dm-cv7-gnss-ins: ThresholdParams
 */
enum mip_event_threshold_type MIP_ENUM_8 {
    /** The value is in a window between two thresholds, or outside of it. */
    MIP_EVENT_THRESHOLD_TYPE_WINDOW = 1,
    /** The remainder of the value divided by an interval is at most a threshold. */
    MIP_EVENT_THRESHOLD_TYPE_INTERVAL = 2
};

/**
 * Control of a GPIO pin by an action.
 *
 * - 3dm-cv7-gnss-ins: Event Action Configuration (0x0C,0x2F)
 * - 3dm-cv7-gnss-ins: Action: GPIO
 */
enum mip_event_action_gpio_mode MIP_ENUM_8 {
    /** The pin is not changed. */
    MIP_EVENT_ACTION_GPIO_MODE_DISABLED = 0,
    /** High while the trigger is active and low otherwise. */
    MIP_EVENT_ACTION_GPIO_MODE_ACTIVE_HIGH = 1,
    /** Low while the trigger is active and high otherwise. */
    MIP_EVENT_ACTION_GPIO_MODE_ACTIVE_LOW = 2,
    /** Set high at each activation and never set low. */
    MIP_EVENT_ACTION_GPIO_MODE_ONESHOT_HIGH = 5,
    /** Set low at each activation and never set high. */
    MIP_EVENT_ACTION_GPIO_MODE_ONESHOT_LOW = 6,
    /** The pin is inverted each time the trigger activates. */
    MIP_EVENT_ACTION_GPIO_MODE_TOGGLE = 7
};

/**
 * A trigger on a GPIO pin.
 *
 * - 3dm-cv7-gnss-ins: Event Trigger Configuration (0x0C,0x2E)
 */
struct mip_event_trigger_gpio {
    /** GPIO pin, counted from 1. Range: at least 1. */
    uint8_t pin;
    /**
     * Condition of the pin that activates the trigger. A value of enum mip_event_trigger_gpio_mode.
     */
    uint8_t mode;
};

/**
 * Two thresholds with a window between them.
 *
 * - 3dm-cv7-gnss-ins: ThresholdParams
 * - mip-sdk-4: Event Trigger (0x0C,0x2E)
 */
struct mip_event_threshold_window {
    /**
     * Lower threshold, in the unit of the watched value.
     *
     * The SDK calls it the first threshold.
     */
    double low_threshold;
    /**
     * Upper threshold, in the unit of the watched value. The trigger is active from the lower
     * threshold to the upper one, both included. If the upper one is below the lower one, it is
     * active below the upper and above the lower one, both excluded.
     *
     * The SDK calls it the second threshold.
     */
    double high_threshold;
};

/**
 * A threshold inside a repeating interval.
 *
 * - 3dm-cv7-gnss-ins: ThresholdParams
 * - mip-sdk-4: Event Trigger (0x0C,0x2E)
 */
struct mip_event_threshold_interval {
    /**
     * The trigger is active while the remainder is at most this, in the unit of the watched value.
     *
     * The SDK calls it the first threshold.
     */
    double interval_threshold;
    /**
     * Divisor of the remainder, in the unit of the watched value. If it is below the threshold, the
     * two swap roles: the trigger is active while the value modulo `interval_threshold` is above
     * this.
     *
     * The SDK calls it the second threshold.
     */
    double interval;
};

/** The member of mip_event_trigger_threshold that `type` selects. */
union mip_event_threshold {
    /**
     * If type is MIP_EVENT_THRESHOLD_TYPE_WINDOW. The value is in a window between two thresholds,
     * or outside of it.
     */
    struct mip_event_threshold_window window;
    /**
     * If type is MIP_EVENT_THRESHOLD_TYPE_INTERVAL. The remainder of the value divided by an
     * interval is at most a threshold.
     */
    struct mip_event_threshold_interval interval;
};

/**
 * A trigger on one value of a data field. The value is converted to double before it is compared.
 *
 * - 3dm-cv7-gnss-ins: ThresholdParams
 */
struct mip_event_trigger_threshold {
    /** Data descriptor set of the watched value. */
    uint8_t descriptor_set;
    /** Field descriptor of the watched value. Refers to fields of descriptor_set. */
    uint8_t field_descriptor;
    /**
     * Number of the value in its field, counted from 1; each element of a vector counts. Range: at
     * least 1.
     */
    uint8_t parameter_id;
    /** Kind of comparison. A value of enum mip_event_threshold_type. */
    uint8_t type;
    /** Thresholds of the comparison. Selected by type. */
    union mip_event_threshold thresholds;
};

/**
 * A trigger that combines up to four others.
 *
 * - 3dm-cv7-gnss-ins: CombinationParams
 * - 3dm-cv7-gnss-ins: Logical Truth Table
 */
struct mip_event_trigger_combination {
    /**
     * Bit n is the output for n = a + 2b + 4c + 8d, where a to d are the states (0 or 1) of the
     * four inputs.
     */
    uint16_t logic_table;
    /**
     * Trigger instances for the inputs a to d; 0 is always inactive.
     *
     * An input may be the trigger itself; its value is then the output of the previous event cycle.
     */
    uint8_t input_triggers[4];
};

/**
 * An action on a GPIO pin, which needs the gpio feature and an output behavior.
 *
 * - 3dm-cv7-gnss-ins: GpioParams
 */
struct mip_event_action_gpio {
    /** GPIO pin, counted from 1. Range: at least 1. */
    uint8_t pin;
    /** Pin level or pulse that the action generates. A value of enum mip_event_action_gpio_mode. */
    uint8_t mode;
};

/**
 * An action that sends data packets.
 *
 * - 3dm-cv7-gnss-ins: MessageParams
 */
struct mip_event_action_message {
    /** Data descriptor set of the packet. */
    uint8_t descriptor_set;
    /**
     * 0 sends one packet per activation. Any other value streams while the trigger is active, at
     * the base rate of the descriptor set divided by this value. At each activation, a packet is
     * sent immediately and the count restarts.
     */
    uint16_t decimation;
    /** Number of fields in the packet. Counts the elements of descriptors. Range: 0 to 12. */
    uint8_t num_fields;
    /** Field descriptors, in order. Refers to fields of descriptor_set. */
    uint8_t descriptors[MIP_ROOM(12, 249)];
};

/**
 * Satellite constellation. QZSS has no value.
 *
 * - 3dm-cv7-gnss-ins: Satellite Status (0x91,0x20)
 * - 3dm-cv7-gnss-ins: Raw (0x91,0x22)
 */
enum mip_gnss_constellation MIP_ENUM_8 {
    /** Not known. */
    MIP_GNSS_CONSTELLATION_UNKNOWN = 0,
    /** The value `gps`. */
    MIP_GNSS_CONSTELLATION_GPS = 1,
    /** The value `glonass`. */
    MIP_GNSS_CONSTELLATION_GLONASS = 2,
    /** The value `galileo`. */
    MIP_GNSS_CONSTELLATION_GALILEO = 3,
    /** The value `beidou`. */
    MIP_GNSS_CONSTELLATION_BEIDOU = 4,
    /** Satellites of augmentation systems (SBAS). */
    MIP_GNSS_CONSTELLATION_SBAS = 5
};

/**
 * Type of a GNSS position fix.
 *
 * - 3dm-cv7-gnss-ins: Fix Info (0x91,0x0B)
 */
enum mip_gnss_fix_type MIP_ENUM_8 {
    /** Fix in three dimensions. */
    MIP_GNSS_FIX_TYPE_FIX_3D = 0,
    /** Fix in two dimensions. */
    MIP_GNSS_FIX_TYPE_FIX_2D = 1,
    /** The receiver computes the time, but no position. */
    MIP_GNSS_FIX_TYPE_FIX_TIME_ONLY = 2,
    /** No fix. */
    MIP_GNSS_FIX_TYPE_FIX_NONE = 3,
    /** The fix is not valid. */
    MIP_GNSS_FIX_TYPE_FIX_INVALID = 4,
    /** RTK fix with float ambiguities. */
    MIP_GNSS_FIX_TYPE_FIX_RTK_FLOAT = 5,
    /** RTK fix with integer ambiguities. */
    MIP_GNSS_FIX_TYPE_FIX_RTK_FIXED = 6,
    /** The position uses differential corrections. */
    MIP_GNSS_FIX_TYPE_FIX_DIFFERENTIAL = 7
};

/**
 * Signal of a satellite.
 *
 * - 3dm-cv7-gnss-ins: Raw (0x91,0x22)
 */
enum mip_gnss_signal MIP_ENUM_8 {
    /** Not known. */
    MIP_GNSS_SIGNAL_UNKNOWN = 0,
    /** GPS L1 C/A. */
    MIP_GNSS_SIGNAL_GPS_L1CA = 1,
    /** GPS L1 P(Y). */
    MIP_GNSS_SIGNAL_GPS_L1P = 2,
    /** GPS L1 P(Y) by Z-tracking. */
    MIP_GNSS_SIGNAL_GPS_L1Z = 3,
    /** GPS L2 C/A. */
    MIP_GNSS_SIGNAL_GPS_L2CA = 4,
    /** GPS L2 P(Y). */
    MIP_GNSS_SIGNAL_GPS_L2P = 5,
    /** GPS L2 P(Y) by Z-tracking. */
    MIP_GNSS_SIGNAL_GPS_L2Z = 6,
    /** GPS L2C(L). */
    MIP_GNSS_SIGNAL_GPS_L2CL = 7,
    /** GPS L2C(M). */
    MIP_GNSS_SIGNAL_GPS_L2CM = 8,
    /** GPS L2C(M+L). */
    MIP_GNSS_SIGNAL_GPS_L2CML = 9,
    /** GPS L5 I. */
    MIP_GNSS_SIGNAL_GPS_L5I = 10,
    /** GPS L5 Q. */
    MIP_GNSS_SIGNAL_GPS_L5Q = 11,
    /** GPS L5 I+Q. */
    MIP_GNSS_SIGNAL_GPS_L5IQ = 12,
    /** GPS L1C(D). */
    MIP_GNSS_SIGNAL_GPS_L1CD = 13,
    /** GPS L1C(P). */
    MIP_GNSS_SIGNAL_GPS_L1CP = 14,
    /** GPS L1C(D+P). */
    MIP_GNSS_SIGNAL_GPS_L1CDP = 15,
    /** GLONASS G1 C/A. */
    MIP_GNSS_SIGNAL_GLONASS_G1CA = 32,
    /** GLONASS G1 P. */
    MIP_GNSS_SIGNAL_GLONASS_G1P = 33,
    /** GLONASS G2 C/A. */
    MIP_GNSS_SIGNAL_GLONASS_G2C = 34,
    /** GLONASS G2 P. */
    MIP_GNSS_SIGNAL_GLONASS_G2P = 35,
    /** Galileo E1 C. */
    MIP_GNSS_SIGNAL_GALILEO_E1C = 64,
    /** Galileo E1 A. */
    MIP_GNSS_SIGNAL_GALILEO_E1A = 65,
    /** Galileo E1 B. */
    MIP_GNSS_SIGNAL_GALILEO_E1B = 66,
    /** Galileo E1 B+C. */
    MIP_GNSS_SIGNAL_GALILEO_E1BC = 67,
    /** Galileo E1 A+B+C. */
    MIP_GNSS_SIGNAL_GALILEO_E1ABC = 68,
    /** Galileo E6 C. */
    MIP_GNSS_SIGNAL_GALILEO_E6C = 69,
    /** Galileo E6 A. */
    MIP_GNSS_SIGNAL_GALILEO_E6A = 70,
    /** Galileo E6 B. */
    MIP_GNSS_SIGNAL_GALILEO_E6B = 71,
    /** Galileo E6 B+C. */
    MIP_GNSS_SIGNAL_GALILEO_E6BC = 72,
    /** Galileo E6 A+B+C. */
    MIP_GNSS_SIGNAL_GALILEO_E6ABC = 73,
    /** Galileo E5b I. */
    MIP_GNSS_SIGNAL_GALILEO_E5BI = 74,
    /** Galileo E5b Q. */
    MIP_GNSS_SIGNAL_GALILEO_E5BQ = 75,
    /** Galileo E5b I+Q. */
    MIP_GNSS_SIGNAL_GALILEO_E5BIQ = 76,
    /** Galileo E5 (a+b) I. */
    MIP_GNSS_SIGNAL_GALILEO_E5ABI = 77,
    /** Galileo E5 (a+b) Q. */
    MIP_GNSS_SIGNAL_GALILEO_E5ABQ = 78,
    /** Galileo E5 (a+b) I+Q. */
    MIP_GNSS_SIGNAL_GALILEO_E5ABIQ = 79,
    /** Galileo E5a I. */
    MIP_GNSS_SIGNAL_GALILEO_E5AI = 80,
    /** Galileo E5a Q. */
    MIP_GNSS_SIGNAL_GALILEO_E5AQ = 81,
    /** Galileo E5a I+Q. */
    MIP_GNSS_SIGNAL_GALILEO_E5AIQ = 82,
    /** SBAS L1 C/A. */
    MIP_GNSS_SIGNAL_SBAS_L1CA = 96,
    /** SBAS L5 I. */
    MIP_GNSS_SIGNAL_SBAS_L5I = 97,
    /** SBAS L5 Q. */
    MIP_GNSS_SIGNAL_SBAS_L5Q = 98,
    /** SBAS L5 I+Q. */
    MIP_GNSS_SIGNAL_SBAS_L5IQ = 99,
    /** QZSS L1 C/A. */
    MIP_GNSS_SIGNAL_QZSS_L1CA = 128,
    /** QZSS LEX S. */
    MIP_GNSS_SIGNAL_QZSS_LEXS = 129,
    /** QZSS LEX L. */
    MIP_GNSS_SIGNAL_QZSS_LEXL = 130,
    /** QZSS LEX S+L. */
    MIP_GNSS_SIGNAL_QZSS_LEXSL = 131,
    /** QZSS L2C(M). */
    MIP_GNSS_SIGNAL_QZSS_L2CM = 132,
    /** QZSS L2C(L). */
    MIP_GNSS_SIGNAL_QZSS_L2CL = 133,
    /** QZSS L2C(M+L). */
    MIP_GNSS_SIGNAL_QZSS_L2CML = 134,
    /** QZSS L5 I. */
    MIP_GNSS_SIGNAL_QZSS_L5I = 135,
    /** QZSS L5 Q. */
    MIP_GNSS_SIGNAL_QZSS_L5Q = 136,
    /** QZSS L5 I+Q. */
    MIP_GNSS_SIGNAL_QZSS_L5IQ = 137,
    /** QZSS L1C(D). */
    MIP_GNSS_SIGNAL_QZSS_L1CD = 138,
    /** QZSS L1C(P). */
    MIP_GNSS_SIGNAL_QZSS_L1CP = 139,
    /** QZSS L1C(D+P). */
    MIP_GNSS_SIGNAL_QZSS_L1CDP = 140,
    /** BeiDou B1 I. */
    MIP_GNSS_SIGNAL_BEIDOU_B1I = 160,
    /** BeiDou B1 Q. */
    MIP_GNSS_SIGNAL_BEIDOU_B1Q = 161,
    /** BeiDou B1 I+Q. */
    MIP_GNSS_SIGNAL_BEIDOU_B1IQ = 162,
    /** BeiDou B3 I. */
    MIP_GNSS_SIGNAL_BEIDOU_B3I = 163,
    /** BeiDou B3 Q. */
    MIP_GNSS_SIGNAL_BEIDOU_B3Q = 164,
    /** BeiDou B3 I+Q. */
    MIP_GNSS_SIGNAL_BEIDOU_B3IQ = 165,
    /** BeiDou B2 I. */
    MIP_GNSS_SIGNAL_BEIDOU_B2I = 166,
    /** BeiDou B2 Q. */
    MIP_GNSS_SIGNAL_BEIDOU_B2Q = 167,
    /** BeiDou B2 I+Q. */
    MIP_GNSS_SIGNAL_BEIDOU_B2IQ = 168,
    /** The value `beidou_b2a`. */
    MIP_GNSS_SIGNAL_BEIDOU_B2A = 169
};

/**
 * Use of a GPIO pin.
 *
 * - 3dm-cv7-gnss-ins: GPIO Configuration (0x0C,0x41)
 * - 3dm-cv7-gnss-ins: GPIO Features
 */
enum mip_gpio_feature MIP_ENUM_8 {
    /** Not connected. Reading the pin may work but is not guaranteed. */
    MIP_GPIO_FEATURE_UNUSED = 0,
    /** General input or output. */
    MIP_GPIO_FEATURE_GPIO = 1,
    /** Input or output of the pulse per second. */
    MIP_GPIO_FEATURE_PPS = 2,
    /** Input of a motor encoder or odometer. */
    MIP_GPIO_FEATURE_ENCODER = 3,
    /** Input whose edges get precise timestamps for event triggers. */
    MIP_GPIO_FEATURE_TIMESTAMP = 4,
    /** Data or control line of a UART. */
    MIP_GPIO_FEATURE_UART = 5
};

/** Behavior of a pin whose feature is unused. */
enum mip_gpio_unused_behavior MIP_ENUM_8 {
    /** No other value is defined. */
    MIP_GPIO_UNUSED_BEHAVIOR_UNUSED = 0
};

/** Behavior of a pin whose feature is gpio. */
enum mip_gpio_behavior MIP_ENUM_8 {
    /** Input; the default. */
    MIP_GPIO_BEHAVIOR_INPUT = 1,
    /** Output, initially low; also low at power-up if the configuration is saved. */
    MIP_GPIO_BEHAVIOR_OUTPUT_LOW = 2,
    /** Output, initially high; also high at power-up if the configuration is saved. */
    MIP_GPIO_BEHAVIOR_OUTPUT_HIGH = 3
};

/** Behavior of a pin whose feature is pps. */
enum mip_gpio_pps_behavior MIP_ENUM_8 {
    /** The pin receives the pulse; the PPS source must be gpio. At most one pin. */
    MIP_GPIO_PPS_BEHAVIOR_INPUT = 1,
    /** The pin sends the pulse of the device. */
    MIP_GPIO_PPS_BEHAVIOR_OUTPUT = 2
};

/** Behavior of a pin whose feature is encoder. */
enum mip_gpio_encoder_behavior MIP_ENUM_8 {
    /** Quadrature input A. At most one pin; the last one configured takes precedence. */
    MIP_GPIO_ENCODER_BEHAVIOR_A = 1,
    /** Quadrature input B. At most one pin; the last one configured takes precedence. */
    MIP_GPIO_ENCODER_BEHAVIOR_B = 2
};

/** Behavior of a pin whose feature is timestamp. */
enum mip_gpio_timestamp_behavior MIP_ENUM_8 {
    /** Rising edges get timestamps. */
    MIP_GPIO_TIMESTAMP_BEHAVIOR_RISING = 1,
    /** Falling edges get timestamps. */
    MIP_GPIO_TIMESTAMP_BEHAVIOR_FALLING = 2,
    /** Both edges get timestamps. */
    MIP_GPIO_TIMESTAMP_BEHAVIOR_EITHER = 3
};

/** Behavior of a pin whose feature is uart. */
enum mip_gpio_uart_behavior MIP_ENUM_8 {
    /** UART 2 transmits. */
    MIP_GPIO_UART_BEHAVIOR_PORT_2_TX = 33,
    /** UART 2 receives. */
    MIP_GPIO_UART_BEHAVIOR_PORT_2_RX = 34,
    /** UART 3 transmits. */
    MIP_GPIO_UART_BEHAVIOR_PORT_3_TX = 49,
    /** UART 3 receives. */
    MIP_GPIO_UART_BEHAVIOR_PORT_3_RX = 50
};

/**
 * Electrical options of a GPIO pin. The allowed ones depend on the device, the pin, the feature and
 * the behavior.
 *
 * - 3dm-cv7-gnss-ins: GPIO Configuration (0x0C,0x41)
 * - 3dm-cv7-gnss-ins: Pin Mode
 */
typedef uint8_t mip_gpio_pin_mode;
/** Bit 0. The output drives low or floats. It usually needs a pull-up. */
#define MIP_GPIO_PIN_MODE_OPEN_DRAIN 0x01U
/** Bit 1. Internal pull-down resistor; not together with the pull-up. */
#define MIP_GPIO_PIN_MODE_PULLDOWN 0x02U
/**
 * Bit 2. Internal pull-up resistor; not together with the pull-down. May lower the allowed input
 * voltage.
 */
#define MIP_GPIO_PIN_MODE_PULLUP 0x04U

/**
 * An NMEA-0183 sentence that a device can send.
 *
 * - 3dm-cv7-gnss-ins: Supported Sentences and Talker IDs
 * - 3dm-cv7-gnss-ins: PMSRA - Euler Angles
 * - 3dm-cv7-gnss-ins: PMSRR - Angular Rate and Acceleration
 */
enum mip_nmea_message_id MIP_ENUM_8 {
    /** GNSS fix, from a GNSS data set or the filter data set. */
    MIP_NMEA_MESSAGE_ID_GGA = 1,
    /** Latitude and longitude, from a GNSS data set or the filter data set. */
    MIP_NMEA_MESSAGE_ID_GLL = 2,
    /** Satellites in view, from a GNSS data set. The constellation determines the talker. */
    MIP_NMEA_MESSAGE_ID_GSV = 3,
    /** Recommended minimum GNSS data, from a GNSS data set or the filter data set. */
    MIP_NMEA_MESSAGE_ID_RMC = 4,
    /** Course and speed over ground, from a GNSS data set or the filter data set. */
    MIP_NMEA_MESSAGE_ID_VTG = 5,
    /** True heading, from a GNSS data set or the filter data set. */
    MIP_NMEA_MESSAGE_ID_HDT = 6,
    /** Time and date, from a GNSS data set. */
    MIP_NMEA_MESSAGE_ID_ZDA = 7,
    /** GNSS error statistics, from a GNSS data set or the filter data set. */
    MIP_NMEA_MESSAGE_ID_GST = 8,
    /**
     * Proprietary sentence `$PMSRA,hhmmss.ss,roll,pitch,yaw*hh`: UTC time and Euler angles in
     * degrees with three decimals. From the filter data set.
     */
    MIP_NMEA_MESSAGE_ID_MSRA = 129,
    /**
     * Proprietary sentence `$PMSRR,hhmmss.ss,ax,ay,az,wx,wy,wz*hh`: UTC time, acceleration in g and
     * angular rate in deg/s about the x, y and z axes, with six decimals. From the sensor data set.
     */
    MIP_NMEA_MESSAGE_ID_MSRR = 130
};

/**
 * The first letters of an NMEA-0183 sentence, which identify its talker.
 *
 * - 3dm-cv7-gnss-ins: Supported Sentences and Talker IDs
 */
enum mip_nmea_talker_id MIP_ENUM_8 {
    /** For sentences whose talker cannot be chosen (GSV and the proprietary ones). */
    MIP_NMEA_TALKER_ID_IGNORED = 0,
    /** Talker GN: several constellations. */
    MIP_NMEA_TALKER_ID_GNSS = 1,
    /** Talker GP: GPS only. */
    MIP_NMEA_TALKER_ID_GPS = 2,
    /** Talker GA: Galileo only. */
    MIP_NMEA_TALKER_ID_GALILEO = 3,
    /** Talker GL: GLONASS only. */
    MIP_NMEA_TALKER_ID_GLONASS = 4
};

/**
 * An NMEA-0183 sentence with its talker, its data source and how often it is sent.
 *
 * - 3dm-cv7-gnss-ins: Sources and Talker IDs
 */
struct mip_nmea_message {
    /** The sentence. A value of enum mip_nmea_message_id. */
    uint8_t message_id;
    /** The talker in the sentence. A value of enum mip_nmea_talker_id. */
    uint8_t talker_id;
    /** Data descriptor set from which the contents are taken. */
    uint8_t source_descriptor_set;
    /** Base rate of the source descriptor set divided by the desired rate; a poll ignores it. */
    uint16_t decimation;
};

/**
 * A port of a device.
 *
 * - 3dm-cv7-gnss-ins: Ports
 * - mip-sdk-4: Interface Control (0x7F,0x02)
 */
enum mip_comm_interface MIP_ENUM_8 {
    /** All ports. */
    MIP_COMM_INTERFACE_ALL = 0,
    /** The main port: USB while a host has it open (DTR), else the main UART. */
    MIP_COMM_INTERFACE_MAIN = 1,
    /** The first port that is a UART or can be one. */
    MIP_COMM_INTERFACE_UART_1 = 17,
    /** The second UART, on GPIO pins 1 and 2 of the 3DM-CV7 and 3DM-GV7 models. */
    MIP_COMM_INTERFACE_UART_2 = 18,
    /** The third UART, on GPIO pins 3 and 4 of the 3DM-CV7 models. */
    MIP_COMM_INTERFACE_UART_3 = 19,
    /** First USB virtual serial port. */
    MIP_COMM_INTERFACE_USB_1 = 33,
    /** Second USB virtual serial port; on GNSS/INS models, intended for NMEA and RTCM. */
    MIP_COMM_INTERFACE_USB_2 = 34
};

/**
 * State of the modem and of the corrections. If `version` is 0, as sent by modems of the first
 * generation, the other bits have no meaning here: read the word as mip_rtk_status_flags_legacy.
 * Uncertain: The SDK states only that the form depends on the model number. Uncertain: Other
 * software of the vendor evaluates `version`: 0 is the legacy form, 1 is this one. In the legacy
 * form of the SDK the same two bits are `sinr`. Uncertain: The SDK lists only the names, from which
 * the descriptions are inferred. The meaning of the values is not known.
 *
 * - mip-sdk-4: Get Status Flags (0x0F,0x01)
 */
typedef uint32_t mip_rtk_status_flags;
/** Bits 0 to 3. State of the modem. */
#define MIP_RTK_STATUS_FLAGS_MODEM_STATE UINT32_C(0x0000000F)
/** Bits 4 to 7. Kind of cellular connection. */
#define MIP_RTK_STATUS_FLAGS_CONNECTION_TYPE UINT32_C(0x000000F0)
/**
 * Bits 8 to 15. Received signal strength. Uncertain: No source states the unit and the sign; other
 * software of the vendor treats it as negative.
 */
#define MIP_RTK_STATUS_FLAGS_RSSI UINT32_C(0x0000FF00)
/** Bits 16 to 19. Quality of the modem's radio signal. */
#define MIP_RTK_STATUS_FLAGS_SIGNAL_QUALITY UINT32_C(0x000F0000)
/** Bits 20 to 23. Cell tower changes. */
#define MIP_RTK_STATUS_FLAGS_TOWER_CHANGE_INDICATOR UINT32_C(0x00F00000)
/** Bit 24. No NMEA was received from the device in time. */
#define MIP_RTK_STATUS_FLAGS_NMEA_TIMEOUT UINT32_C(0x01000000)
/** Bit 25. The server did not answer in time. */
#define MIP_RTK_STATUS_FLAGS_SERVER_TIMEOUT UINT32_C(0x02000000)
/** Bit 26. No corrections were received in time. */
#define MIP_RTK_STATUS_FLAGS_CORRECTIONS_TIMEOUT UINT32_C(0x04000000)
/** Bit 27. The device is outside the service area. */
#define MIP_RTK_STATUS_FLAGS_DEVICE_OUT_OF_RANGE UINT32_C(0x08000000)
/** Bit 28. There are no corrections. */
#define MIP_RTK_STATUS_FLAGS_CORRECTIONS_UNAVAILABLE UINT32_C(0x10000000)
/** Bits 30 to 31. Form of these flags. */
#define MIP_RTK_STATUS_FLAGS_VERSION UINT32_C(0xC0000000)

/** Bits 0 to 3. State of the modem. */
static inline uint8_t mip_rtk_status_flags_get_modem_state(mip_rtk_status_flags flags) {
    const uint32_t bits = flags & MIP_RTK_STATUS_FLAGS_MODEM_STATE;
    return (uint8_t)bits;
}

/** Sets it. */
static inline void mip_rtk_status_flags_set_modem_state(mip_rtk_status_flags *flags,
                                                        uint8_t value) {
    const uint32_t mask = MIP_RTK_STATUS_FLAGS_MODEM_STATE;
    const uint32_t bits = value;
    *flags = (mip_rtk_status_flags)((*flags & ~mask) | (bits & mask));
}

/** Bits 4 to 7. Kind of cellular connection. */
static inline uint8_t mip_rtk_status_flags_get_connection_type(mip_rtk_status_flags flags) {
    const uint32_t bits = flags & MIP_RTK_STATUS_FLAGS_CONNECTION_TYPE;
    return (uint8_t)(bits >> 4);
}

/** Sets it. */
static inline void mip_rtk_status_flags_set_connection_type(mip_rtk_status_flags *flags,
                                                            uint8_t value) {
    const uint32_t mask = MIP_RTK_STATUS_FLAGS_CONNECTION_TYPE;
    const uint32_t bits = (uint32_t)value << 4;
    *flags = (mip_rtk_status_flags)((*flags & ~mask) | (bits & mask));
}

/**
 * Bits 8 to 15. Received signal strength. Uncertain: No source states the unit and the sign; other
 * software of the vendor treats it as negative.
 */
static inline uint8_t mip_rtk_status_flags_get_rssi(mip_rtk_status_flags flags) {
    const uint32_t bits = flags & MIP_RTK_STATUS_FLAGS_RSSI;
    return (uint8_t)(bits >> 8);
}

/** Sets it. */
static inline void mip_rtk_status_flags_set_rssi(mip_rtk_status_flags *flags, uint8_t value) {
    const uint32_t mask = MIP_RTK_STATUS_FLAGS_RSSI;
    const uint32_t bits = (uint32_t)value << 8;
    *flags = (mip_rtk_status_flags)((*flags & ~mask) | (bits & mask));
}

/** Bits 16 to 19. Quality of the modem's radio signal. */
static inline uint8_t mip_rtk_status_flags_get_signal_quality(mip_rtk_status_flags flags) {
    const uint32_t bits = flags & MIP_RTK_STATUS_FLAGS_SIGNAL_QUALITY;
    return (uint8_t)(bits >> 16);
}

/** Sets it. */
static inline void mip_rtk_status_flags_set_signal_quality(mip_rtk_status_flags *flags,
                                                           uint8_t value) {
    const uint32_t mask = MIP_RTK_STATUS_FLAGS_SIGNAL_QUALITY;
    const uint32_t bits = (uint32_t)value << 16;
    *flags = (mip_rtk_status_flags)((*flags & ~mask) | (bits & mask));
}

/** Bits 20 to 23. Cell tower changes. */
static inline uint8_t mip_rtk_status_flags_get_tower_change_indicator(mip_rtk_status_flags flags) {
    const uint32_t bits = flags & MIP_RTK_STATUS_FLAGS_TOWER_CHANGE_INDICATOR;
    return (uint8_t)(bits >> 20);
}

/** Sets it. */
static inline void mip_rtk_status_flags_set_tower_change_indicator(mip_rtk_status_flags *flags,
                                                                   uint8_t value) {
    const uint32_t mask = MIP_RTK_STATUS_FLAGS_TOWER_CHANGE_INDICATOR;
    const uint32_t bits = (uint32_t)value << 20;
    *flags = (mip_rtk_status_flags)((*flags & ~mask) | (bits & mask));
}

/** Bits 30 to 31. Form of these flags. */
static inline uint8_t mip_rtk_status_flags_get_version(mip_rtk_status_flags flags) {
    const uint32_t bits = flags & MIP_RTK_STATUS_FLAGS_VERSION;
    return (uint8_t)(bits >> 30);
}

/** Sets it. */
static inline void mip_rtk_status_flags_set_version(mip_rtk_status_flags *flags, uint8_t value) {
    const uint32_t mask = MIP_RTK_STATUS_FLAGS_VERSION;
    const uint32_t bits = (uint32_t)value << 30;
    *flags = (mip_rtk_status_flags)((*flags & ~mask) | (bits & mask));
}

/**
 * State of the modem and the corrections, in the older layout. Uncertain: The form depends on the
 * model; see mip_rtk_status_flags. Uncertain: The SDK calls bits 20-31 reserved, but also puts the
 * last four numbers there. Uncertain: The SDK lists only the names, from which the descriptions are
 * inferred. The meaning of the values is not known.
 *
 * - mip-sdk-4: Get Status Flags (0x0F,0x01)
 */
typedef uint32_t mip_rtk_status_flags_legacy;
/** Bits 0 to 2. State of the controller. */
#define MIP_RTK_STATUS_FLAGS_LEGACY_CONTROLLER_STATE UINT32_C(0x00000007)
/** Bits 3 to 7. State of the platform. */
#define MIP_RTK_STATUS_FLAGS_LEGACY_PLATFORM_STATE UINT32_C(0x000000F8)
/** Bits 8 to 10. Status code of the controller. */
#define MIP_RTK_STATUS_FLAGS_LEGACY_CONTROLLER_STATUS_CODE UINT32_C(0x00000700)
/** Bits 11 to 13. Status code of the platform. */
#define MIP_RTK_STATUS_FLAGS_LEGACY_PLATFORM_STATUS_CODE UINT32_C(0x00003800)
/** Bits 14 to 15. Reason for the last reset. */
#define MIP_RTK_STATUS_FLAGS_LEGACY_RESET_CODE UINT32_C(0x0000C000)
/** Bits 16 to 19. Quality of the modem's radio signal. */
#define MIP_RTK_STATUS_FLAGS_LEGACY_SIGNAL_QUALITY UINT32_C(0x000F0000)
/** Bits 20 to 25. Received signal strength. */
#define MIP_RTK_STATUS_FLAGS_LEGACY_RSSI UINT32_C(0x03F00000)
/** Bits 26 to 27. Received power of the reference signal. */
#define MIP_RTK_STATUS_FLAGS_LEGACY_RSRP UINT32_C(0x0C000000)
/** Bits 28 to 29. Received quality of the reference signal. */
#define MIP_RTK_STATUS_FLAGS_LEGACY_RSRQ UINT32_C(0x30000000)
/** Bits 30 to 31. Signal to interference and noise ratio. */
#define MIP_RTK_STATUS_FLAGS_LEGACY_SINR UINT32_C(0xC0000000)

/** Bits 0 to 2. State of the controller. */
static inline uint8_t
mip_rtk_status_flags_legacy_get_controller_state(mip_rtk_status_flags_legacy flags) {
    const uint32_t bits = flags & MIP_RTK_STATUS_FLAGS_LEGACY_CONTROLLER_STATE;
    return (uint8_t)bits;
}

/** Sets it. */
static inline void mip_rtk_status_flags_legacy_set_controller_state(
    mip_rtk_status_flags_legacy *flags, uint8_t value) {
    const uint32_t mask = MIP_RTK_STATUS_FLAGS_LEGACY_CONTROLLER_STATE;
    const uint32_t bits = value;
    *flags = (mip_rtk_status_flags_legacy)((*flags & ~mask) | (bits & mask));
}

/** Bits 3 to 7. State of the platform. */
static inline uint8_t
mip_rtk_status_flags_legacy_get_platform_state(mip_rtk_status_flags_legacy flags) {
    const uint32_t bits = flags & MIP_RTK_STATUS_FLAGS_LEGACY_PLATFORM_STATE;
    return (uint8_t)(bits >> 3);
}

/** Sets it. */
static inline void
mip_rtk_status_flags_legacy_set_platform_state(mip_rtk_status_flags_legacy *flags, uint8_t value) {
    const uint32_t mask = MIP_RTK_STATUS_FLAGS_LEGACY_PLATFORM_STATE;
    const uint32_t bits = (uint32_t)value << 3;
    *flags = (mip_rtk_status_flags_legacy)((*flags & ~mask) | (bits & mask));
}

/** Bits 8 to 10. Status code of the controller. */
static inline uint8_t
mip_rtk_status_flags_legacy_get_controller_status_code(mip_rtk_status_flags_legacy flags) {
    const uint32_t bits = flags & MIP_RTK_STATUS_FLAGS_LEGACY_CONTROLLER_STATUS_CODE;
    return (uint8_t)(bits >> 8);
}

/** Sets it. */
static inline void mip_rtk_status_flags_legacy_set_controller_status_code(
    mip_rtk_status_flags_legacy *flags, uint8_t value) {
    const uint32_t mask = MIP_RTK_STATUS_FLAGS_LEGACY_CONTROLLER_STATUS_CODE;
    const uint32_t bits = (uint32_t)value << 8;
    *flags = (mip_rtk_status_flags_legacy)((*flags & ~mask) | (bits & mask));
}

/** Bits 11 to 13. Status code of the platform. */
static inline uint8_t
mip_rtk_status_flags_legacy_get_platform_status_code(mip_rtk_status_flags_legacy flags) {
    const uint32_t bits = flags & MIP_RTK_STATUS_FLAGS_LEGACY_PLATFORM_STATUS_CODE;
    return (uint8_t)(bits >> 11);
}

/** Sets it. */
static inline void mip_rtk_status_flags_legacy_set_platform_status_code(
    mip_rtk_status_flags_legacy *flags, uint8_t value) {
    const uint32_t mask = MIP_RTK_STATUS_FLAGS_LEGACY_PLATFORM_STATUS_CODE;
    const uint32_t bits = (uint32_t)value << 11;
    *flags = (mip_rtk_status_flags_legacy)((*flags & ~mask) | (bits & mask));
}

/** Bits 14 to 15. Reason for the last reset. */
static inline uint8_t
mip_rtk_status_flags_legacy_get_reset_code(mip_rtk_status_flags_legacy flags) {
    const uint32_t bits = flags & MIP_RTK_STATUS_FLAGS_LEGACY_RESET_CODE;
    return (uint8_t)(bits >> 14);
}

/** Sets it. */
static inline void mip_rtk_status_flags_legacy_set_reset_code(mip_rtk_status_flags_legacy *flags,
                                                              uint8_t value) {
    const uint32_t mask = MIP_RTK_STATUS_FLAGS_LEGACY_RESET_CODE;
    const uint32_t bits = (uint32_t)value << 14;
    *flags = (mip_rtk_status_flags_legacy)((*flags & ~mask) | (bits & mask));
}

/** Bits 16 to 19. Quality of the modem's radio signal. */
static inline uint8_t
mip_rtk_status_flags_legacy_get_signal_quality(mip_rtk_status_flags_legacy flags) {
    const uint32_t bits = flags & MIP_RTK_STATUS_FLAGS_LEGACY_SIGNAL_QUALITY;
    return (uint8_t)(bits >> 16);
}

/** Sets it. */
static inline void
mip_rtk_status_flags_legacy_set_signal_quality(mip_rtk_status_flags_legacy *flags, uint8_t value) {
    const uint32_t mask = MIP_RTK_STATUS_FLAGS_LEGACY_SIGNAL_QUALITY;
    const uint32_t bits = (uint32_t)value << 16;
    *flags = (mip_rtk_status_flags_legacy)((*flags & ~mask) | (bits & mask));
}

/** Bits 20 to 25. Received signal strength. */
static inline uint8_t mip_rtk_status_flags_legacy_get_rssi(mip_rtk_status_flags_legacy flags) {
    const uint32_t bits = flags & MIP_RTK_STATUS_FLAGS_LEGACY_RSSI;
    return (uint8_t)(bits >> 20);
}

/** Sets it. */
static inline void mip_rtk_status_flags_legacy_set_rssi(mip_rtk_status_flags_legacy *flags,
                                                        uint8_t value) {
    const uint32_t mask = MIP_RTK_STATUS_FLAGS_LEGACY_RSSI;
    const uint32_t bits = (uint32_t)value << 20;
    *flags = (mip_rtk_status_flags_legacy)((*flags & ~mask) | (bits & mask));
}

/** Bits 26 to 27. Received power of the reference signal. */
static inline uint8_t mip_rtk_status_flags_legacy_get_rsrp(mip_rtk_status_flags_legacy flags) {
    const uint32_t bits = flags & MIP_RTK_STATUS_FLAGS_LEGACY_RSRP;
    return (uint8_t)(bits >> 26);
}

/** Sets it. */
static inline void mip_rtk_status_flags_legacy_set_rsrp(mip_rtk_status_flags_legacy *flags,
                                                        uint8_t value) {
    const uint32_t mask = MIP_RTK_STATUS_FLAGS_LEGACY_RSRP;
    const uint32_t bits = (uint32_t)value << 26;
    *flags = (mip_rtk_status_flags_legacy)((*flags & ~mask) | (bits & mask));
}

/** Bits 28 to 29. Received quality of the reference signal. */
static inline uint8_t mip_rtk_status_flags_legacy_get_rsrq(mip_rtk_status_flags_legacy flags) {
    const uint32_t bits = flags & MIP_RTK_STATUS_FLAGS_LEGACY_RSRQ;
    return (uint8_t)(bits >> 28);
}

/** Sets it. */
static inline void mip_rtk_status_flags_legacy_set_rsrq(mip_rtk_status_flags_legacy *flags,
                                                        uint8_t value) {
    const uint32_t mask = MIP_RTK_STATUS_FLAGS_LEGACY_RSRQ;
    const uint32_t bits = (uint32_t)value << 28;
    *flags = (mip_rtk_status_flags_legacy)((*flags & ~mask) | (bits & mask));
}

/** Bits 30 to 31. Signal to interference and noise ratio. */
static inline uint8_t mip_rtk_status_flags_legacy_get_sinr(mip_rtk_status_flags_legacy flags) {
    const uint32_t bits = flags & MIP_RTK_STATUS_FLAGS_LEGACY_SINR;
    return (uint8_t)(bits >> 30);
}

/** Sets it. */
static inline void mip_rtk_status_flags_legacy_set_sinr(mip_rtk_status_flags_legacy *flags,
                                                        uint8_t value) {
    const uint32_t mask = MIP_RTK_STATUS_FLAGS_LEGACY_SINR;
    const uint32_t bits = (uint32_t)value << 30;
    *flags = (mip_rtk_status_flags_legacy)((*flags & ~mask) | (bits & mask));
}

/**
 * The result of a command.
 *
 * - 3dm-gx5-15: 4.5 Error Codes
 * - 3dm-cv7-gnss-ins: Ack/Nack Codes
 */
enum mip_ack_code MIP_ENUM_8 {
    /** The command was carried out. */
    MIP_ACK_CODE_OK = 0,
    /** The device does not know the command descriptor. */
    MIP_ACK_CODE_UNKNOWN_COMMAND = 1,
    /** A complete packet had a wrong checksum. */
    MIP_ACK_CODE_BAD_CHECKSUM = 2,
    /** A parameter is out of range, or of the wrong size or type. */
    MIP_ACK_CODE_INVALID_PARAMETER = 3,
    /** The device could not carry out the command. */
    MIP_ACK_CODE_COMMAND_FAILED = 4,
    /** The command did not finish in time. */
    MIP_ACK_CODE_COMMAND_TIMEOUT = 5,
    /** The device does not know the descriptor set. */
    MIP_ACK_CODE_UNKNOWN_DESCRIPTOR_SET = 6
};

/** A field of a message format and how often it is sent. */
struct mip_descriptor_rate {
    /** Field descriptor. */
    uint8_t descriptor;
    /** Base rate divided by the desired rate. Range: at least 1. */
    uint16_t decimation;
};

/**
 * State of the GPS time of sensor data.
 *
 * - 3dm-cv7-gnss-ins: GPS Timestamp (0x80,0x12)
 */
typedef uint16_t mip_sensor_gps_timestamp_flags;
/** Bit 0. The PPS signal is present. */
#define MIP_SENSOR_GPS_TIMESTAMP_FLAGS_PPS_VALID 0x0001U
/** Bit 1. Toggles each time the time is updated. */
#define MIP_SENSOR_GPS_TIMESTAMP_FLAGS_TIME_REFRESH 0x0002U
/** Bit 2. The time has been set at least once. */
#define MIP_SENSOR_GPS_TIMESTAMP_FLAGS_TIME_INITIALIZED 0x0004U
/** Bit 3. The time of week is valid. */
#define MIP_SENSOR_GPS_TIMESTAMP_FLAGS_TOW_VALID 0x0008U
/** Bit 4. The week number is valid. */
#define MIP_SENSOR_GPS_TIMESTAMP_FLAGS_WEEK_NUMBER_VALID 0x0010U

/**
 * State of the GPS time of sensor data on the 3DM-GX5-15, which has no bits for the validity of the
 * values.
 *
 * - 3dm-gx5-15: 5.1.11 GPS Correlation Timestamp (0x80, 0x12)
 */
typedef uint16_t mip_gx5_sensor_gps_timestamp_flags;
/** Bit 0. The PPS signal is present; without it, the internal clock drives the time. */
#define MIP_GX5_SENSOR_GPS_TIMESTAMP_FLAGS_PPS_VALID 0x0001U
/** Bit 1. Toggles each time the time is updated. */
#define MIP_GX5_SENSOR_GPS_TIMESTAMP_FLAGS_TIME_REFRESH 0x0002U
/** Bit 2. The time has been set at least once. */
#define MIP_GX5_SENSOR_GPS_TIMESTAMP_FLAGS_TIME_INITIALIZED 0x0004U

#ifdef __cplusplus
}
#endif

#endif
