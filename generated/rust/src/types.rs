//! Types that several descriptor sets share.

open_enum! {
    /// The operation that a settings command requests.
    FunctionSelector: u8 {
        /// Apply the new setting.
        WRITE = 1, "write";
        /// Return the current setting in a response.
        READ = 2, "read";
        /// Save the current setting to non-volatile memory.
        SAVE = 3, "save";
        /// Load the saved setting.
        LOAD = 4, "load";
        /// Load the factory default setting.
        DEFAULT = 5, "default";
        /// Apply the new setting without sending an ACK (5-series devices).
        APPLY = 6, "apply";
    }
}

#[cfg(feature = "base")]
bitfield! {
    /// Result of the built-in test of the 3DM-GX5-15: processor board, sensor board, filter.
    ///
    /// Source: 3dm-gx5-15: 4.1.5 Device Built-In Test (0x01, 0x05).
    Gx5BuiltInTest: u32 {
        /// The watchdog has reset the processor; cleared by the first commanded test. Bit 0.
        WATCHDOG_RESET: bool = 0,
            watchdog_reset, set_watchdog_reset, with_watchdog_reset;
        /// No communication with the inertial sensor. Bit 8.
        IMU_COMM_FAULT: bool = 8,
            imu_comm_fault, set_imu_comm_fault, with_imu_comm_fault;
        /// Magnetometer fault, on devices that have one. Bit 9. Affects
        /// [`sensor::ScaledMag`](crate::sensor::ScaledMag).
        MAG_FAULT: bool = 9,
            mag_fault, set_mag_fault, with_mag_fault;
        /// Pressure sensor fault, on devices that have one. Bit 10. Affects
        /// [`sensor::ScaledPressure`](crate::sensor::ScaledPressure).
        PRESSURE_SENSOR_FAULT: bool = 10,
            pressure_sensor_fault, set_pressure_sensor_fault, with_pressure_sensor_fault;
        /// Fault of the estimation filter solution. Bit 24. Affects
        /// [`filter::Reset`](crate::filter::Reset).
        SOLUTION_FAULT: bool = 24,
            solution_fault, set_solution_fault, with_solution_fault;
    }
}

#[cfg(feature = "base")]
bitfield! {
    /// Result of the commanded built-in test of the 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: Commanded Built-in Test.
    Cv7BuiltInTest: u32 {
        /// A critical part, such as the oscillator, has failed. Bit 0.
        GENERAL_HARDWARE_FAULT: bool = 0,
            general_hardware_fault, set_general_hardware_fault, with_general_hardware_fault;
        /// The firmware encountered a serious or unexpected condition. Bit 1.
        GENERAL_FIRMWARE_FAULT: bool = 1,
            general_firmware_fault, set_general_firmware_fault, with_general_firmware_fault;
        /// The processor cannot keep up; cleared by reading the result. Bit 2.
        TIMING_OVERLOAD: bool = 2,
            timing_overload, set_timing_overload, with_timing_overload;
        /// A data buffer was full, usually because too much data is streamed. Bit 3.
        BUFFER_OVERRUN: bool = 3,
            buffer_overrun, set_buffer_overrun, with_buffer_overrun;
        /// The accelerometer is damaged or does not work. Bit 12. Affects
        /// [`sensor::ScaledAccel`](crate::sensor::ScaledAccel).
        ACCEL_FAULT: bool = 12,
            accel_fault, set_accel_fault, with_accel_fault;
        /// The gyroscope is damaged or does not work. Bit 13. Affects
        /// [`sensor::ScaledGyro`](crate::sensor::ScaledGyro).
        GYRO_FAULT: bool = 13,
            gyro_fault, set_gyro_fault, with_gyro_fault;
        /// The magnetometer is damaged or does not work. Bit 14. Affects
        /// [`sensor::ScaledMag`](crate::sensor::ScaledMag).
        MAG_FAULT: bool = 14,
            mag_fault, set_mag_fault, with_mag_fault;
        /// The pressure sensor is damaged or does not work. Bit 15. Affects
        /// [`sensor::ScaledPressure`](crate::sensor::ScaledPressure).
        PRESSURE_SENSOR_FAULT: bool = 15,
            pressure_sensor_fault, set_pressure_sensor_fault, with_pressure_sensor_fault;
        /// At least one calibration table of the sensors is invalid. Bit 18.
        CALIBRATION_ERROR: bool = 18,
            calibration_error, set_calibration_error, with_calibration_error;
        /// A fault of the inertial sensor subsystem that no other bit covers. Bit 19.
        GENERAL_IMU_FAULT: bool = 19,
            general_imu_fault, set_general_imu_fault, with_general_imu_fault;
        /// The filter output is invalid (not a number); reset the filter. Bit 22. Affects
        /// [`filter::Reset`](crate::filter::Reset).
        FILTER_SOLUTION_FAULT: bool = 22,
            filter_solution_fault, set_filter_solution_fault, with_filter_solution_fault;
        /// A fault of the filter subsystem that no other bit covers. Bit 23.
        GENERAL_FILTER_FAULT: bool = 23,
            general_filter_fault, set_general_filter_fault, with_general_filter_fault;
    }
}

#[cfg(any(feature = "base", feature = "system_data"))]
bitfield! {
    /// Flags of the continuous built-in test of the 3DM-CV7-GNSS/INS: bits 0-31 system, 32-63
    /// inertial sensors, 64-95 navigation, 96-127 GNSS.
    ///
    /// Source: 3dm-cv7-gnss-ins: Continuous Built-in Test.
    Cv7ContinuousBuiltInTest: [u8; 16] {
        /// The system clock does not work properly. Bit 0.
        SYSTEM_CLOCK_FAILURE: bool = 0,
            system_clock_failure, set_system_clock_failure, with_system_clock_failure;
        /// The supply voltage is out of range, or an internal supply has failed. Bit 1.
        POWER_FAULT: bool = 1,
            power_fault, set_power_fault, with_power_fault;
        /// The firmware encountered an unexpected condition. Bit 4.
        FIRMWARE_FAULT: bool = 4,
            firmware_fault, set_firmware_fault, with_firmware_fault;
        /// The processor cannot keep up. Bit 5.
        TIMING_OVERLOAD: bool = 5,
            timing_overload, set_timing_overload, with_timing_overload;
        /// A data buffer was full and data may be lost. Bit 6.
        BUFFER_OVERRUN: bool = 6,
            buffer_overrun, set_buffer_overrun, with_buffer_overrun;
        /// The inertial sensor subsystem is not running or did not start. Bit 16.
        IMU_PROCESS_FAULT: bool = 16,
            imu_process_fault, set_imu_process_fault, with_imu_process_fault;
        /// The processing of sensor data took too long. Bit 17.
        IMU_DATA_PROCESS_TIME_EXCEEDED: bool = 17,
            imu_data_process_time_exceeded, set_imu_data_process_time_exceeded, with_imu_data_process_time_exceeded;
        /// Sensor data is not produced at its base rate. Bit 18.
        IMU_DATA_RATE_ERROR: bool = 18,
            imu_data_rate_error, set_imu_data_rate_error, with_imu_data_rate_error;
        /// The inertial sensor subsystem produces no data. Bit 19.
        IMU_STALL: bool = 19,
            imu_stall, set_imu_stall, with_imu_stall;
        /// Set if any filter fault (bits 20-23) is set. Bits 20 to 23. Overlaps other bits.
        FILTER_PROCESS_FAULT: u8 = 20..=23,
            filter_process_fault, set_filter_process_fault, with_filter_process_fault;
        /// Fault of the major cycle of the filter; bits 22 and 23 show which fault. Bit 20.
        FILTER_MAJOR_CYCLE_FAULT: bool = 20,
            filter_major_cycle_fault, set_filter_major_cycle_fault, with_filter_major_cycle_fault;
        /// Fault of the minor cycle of the filter; bits 22 and 23 show which fault. Bit 21.
        FILTER_MINOR_CYCLE_FAULT: bool = 21,
            filter_minor_cycle_fault, set_filter_minor_cycle_fault, with_filter_minor_cycle_fault;
        /// A filter process misses its base rate; bits 20 and 21 show which. Bit 22.
        FILTER_DATA_RATE_ERROR: bool = 22,
            filter_data_rate_error, set_filter_data_rate_error, with_filter_data_rate_error;
        /// A filter process produces no data; bits 20 and 21 show which. Bit 23.
        FILTER_PROCESS_STALL: bool = 23,
            filter_process_stall, set_filter_process_stall, with_filter_process_stall;
        /// Set if any GNSS fault (bits 24-27) is set. Bits 24 to 27. Overlaps other bits.
        GNSS_SUBSYSTEM_FAULT: u8 = 24..=27,
            gnss_subsystem_fault, set_gnss_subsystem_fault, with_gnss_subsystem_fault;
        /// The main GNSS process did not run in time. Bit 24.
        GNSS_MAIN_PROCESS_FAULT: bool = 24,
            gnss_main_process_fault, set_gnss_main_process_fault, with_gnss_main_process_fault;
        /// No data from internal receiver 1 in time. Bit 25. Affects
        /// [`gnss_data::FixInfo`](crate::gnss_data::FixInfo).
        GNSS_RECEIVER_1_STALL: bool = 25,
            gnss_receiver_1_stall, set_gnss_receiver_1_stall, with_gnss_receiver_1_stall;
        /// No data from internal receiver 2 in time. Bit 26. Affects
        /// [`gnss_data::FixInfo`](crate::gnss_data::FixInfo).
        GNSS_RECEIVER_2_STALL: bool = 26,
            gnss_receiver_2_stall, set_gnss_receiver_2_stall, with_gnss_receiver_2_stall;
        /// No communication with the inertial sensors. Bit 33.
        IMU_COMM_FAULT: bool = 33,
            imu_comm_fault, set_imu_comm_fault, with_imu_comm_fault;
        /// Inertial sensor processes take longer than their time slot. Bit 34.
        IMU_TIMING_OVERRUN: bool = 34,
            imu_timing_overrun, set_imu_timing_overrun, with_imu_timing_overrun;
        /// Accelerometer calibration fault. Bit 36. Affects
        /// [`sensor::ScaledAccel`](crate::sensor::ScaledAccel).
        IMU_CALIBRATION_ERROR_ACCEL: bool = 36,
            imu_calibration_error_accel, set_imu_calibration_error_accel, with_imu_calibration_error_accel;
        /// Gyroscope calibration fault. Bit 37. Affects
        /// [`sensor::ScaledGyro`](crate::sensor::ScaledGyro).
        IMU_CALIBRATION_ERROR_GYRO: bool = 37,
            imu_calibration_error_gyro, set_imu_calibration_error_gyro, with_imu_calibration_error_gyro;
        /// Magnetometer calibration fault. Bit 38. Affects
        /// [`sensor::ScaledMag`](crate::sensor::ScaledMag).
        IMU_CALIBRATION_ERROR_MAG: bool = 38,
            imu_calibration_error_mag, set_imu_calibration_error_mag, with_imu_calibration_error_mag;
        /// The accelerometer failed to initialize. Bit 40. Affects
        /// [`sensor::ScaledAccel`](crate::sensor::ScaledAccel).
        ACCEL_GENERAL_FAULT: bool = 40,
            accel_general_fault, set_accel_general_fault, with_accel_general_fault;
        /// The acceleration along an axis is near or outside the selected range. Bit 41. Affects
        /// [`sensor::ScaledAccel`](crate::sensor::ScaledAccel).
        ACCEL_OVER_RANGE: bool = 41,
            accel_over_range, set_accel_over_range, with_accel_over_range;
        /// The accelerometer self-test failed; the commanded built-in test updates this bit. Bit
        /// 42. Affects [`sensor::ScaledAccel`](crate::sensor::ScaledAccel).
        ACCEL_SELF_TEST_FAIL: bool = 42,
            accel_self_test_fail, set_accel_self_test_fail, with_accel_self_test_fail;
        /// The gyroscope failed to initialize. Bit 44. Affects
        /// [`sensor::ScaledGyro`](crate::sensor::ScaledGyro).
        GYRO_GENERAL_FAULT: bool = 44,
            gyro_general_fault, set_gyro_general_fault, with_gyro_general_fault;
        /// The angular rate about an axis is near or outside the selected range. Bit 45. Affects
        /// [`sensor::ScaledGyro`](crate::sensor::ScaledGyro).
        GYRO_OVER_RANGE: bool = 45,
            gyro_over_range, set_gyro_over_range, with_gyro_over_range;
        /// The gyroscope self-test failed; the commanded built-in test updates this bit. Bit 46.
        /// Affects [`sensor::ScaledGyro`](crate::sensor::ScaledGyro).
        GYRO_SELF_TEST_FAIL: bool = 46,
            gyro_self_test_fail, set_gyro_self_test_fail, with_gyro_self_test_fail;
        /// The magnetometer failed to initialize. Bit 48. Affects
        /// [`sensor::ScaledMag`](crate::sensor::ScaledMag).
        MAG_GENERAL_FAULT: bool = 48,
            mag_general_fault, set_mag_general_fault, with_mag_general_fault;
        /// The magnetic field along an axis is near or outside the supported range. Bit 49. Affects
        /// [`sensor::ScaledMag`](crate::sensor::ScaledMag).
        MAG_OVER_RANGE: bool = 49,
            mag_over_range, set_mag_over_range, with_mag_over_range;
        /// The magnetometer self-test failed; the commanded built-in test updates this bit. Bit 50.
        /// Affects [`sensor::ScaledMag`](crate::sensor::ScaledMag).
        MAG_SELF_TEST_FAIL: bool = 50,
            mag_self_test_fail, set_mag_self_test_fail, with_mag_self_test_fail;
        /// The pressure sensor failed to initialize. Bit 52. Affects
        /// [`sensor::ScaledPressure`](crate::sensor::ScaledPressure).
        PRESSURE_SENSOR_GENERAL_FAULT: bool = 52,
            pressure_sensor_general_fault, set_pressure_sensor_general_fault, with_pressure_sensor_general_fault;
        /// The pressure is outside the supported range. Bit 53. Affects
        /// [`sensor::ScaledPressure`](crate::sensor::ScaledPressure).
        PRESSURE_SENSOR_OVER_RANGE: bool = 53,
            pressure_sensor_over_range, set_pressure_sensor_over_range, with_pressure_sensor_over_range;
        /// The pressure sensor self-test failed; the commanded built-in test updates this bit. Bit
        /// 54. Affects [`sensor::ScaledPressure`](crate::sensor::ScaledPressure).
        PRESSURE_SENSOR_SELF_TEST_FAIL: bool = 54,
            pressure_sensor_self_test_fail, set_pressure_sensor_self_test_fail, with_pressure_sensor_self_test_fail;
        /// The device has lost its factory configuration. Bit 56.
        FACTORY_BITS_INVALID: bool = 56,
            factory_bits_invalid, set_factory_bits_invalid, with_factory_bits_invalid;
        /// Filter processes take longer than their time slot. Bit 66.
        FILTER_TIMING_OVERRUN: bool = 66,
            filter_timing_overrun, set_filter_timing_overrun, with_filter_timing_overrun;
        /// Filter processes are skipped. Bit 67.
        FILTER_TIMING_UNDERRUN: bool = 67,
            filter_timing_underrun, set_filter_timing_underrun, with_filter_timing_underrun;
        /// No communication with internal receiver 1. Bit 105. Affects
        /// [`gnss_data::FixInfo`](crate::gnss_data::FixInfo).
        RECEIVER_1_FAULT: bool = 105,
            receiver_1_fault, set_receiver_1_fault, with_receiver_1_fault;
        /// Internal receiver 1 has no valid solution; usually for lack of a sky view. Bit 108.
        /// Affects [`gnss_data::FixInfo`](crate::gnss_data::FixInfo).
        RECEIVER_1_NO_SOLUTION: bool = 108,
            receiver_1_no_solution, set_receiver_1_no_solution, with_receiver_1_no_solution;
        /// No communication with internal receiver 2. Bit 110. Affects
        /// [`gnss_data::FixInfo`](crate::gnss_data::FixInfo).
        RECEIVER_2_FAULT: bool = 110,
            receiver_2_fault, set_receiver_2_fault, with_receiver_2_fault;
        /// Internal receiver 2 has no valid solution; usually for lack of a sky view. Bit 113.
        /// Affects [`gnss_data::FixInfo`](crate::gnss_data::FixInfo).
        RECEIVER_2_NO_SOLUTION: bool = 113,
            receiver_2_no_solution, set_receiver_2_no_solution, with_receiver_2_no_solution;
    }
}

#[cfg(any(feature = "base", feature = "system_data"))]
bitfield! {
    /// Flags of the continuous built-in test of devices of generation 7 without a GNSS receiver:
    /// bits 0-31 system, 32-63 inertial sensors, 64-95 navigation.
    ///
    /// Uncertain: The sources list only the numbers and names of the bits; the descriptions are
    /// those of the 3DM-CV7-GNSS/INS where the names are the same.
    ///
    /// Source: ros-driver: Built-in test of the CV7; mscl: Continuous built-in test.
    Cv7InertialContinuousBuiltInTest: [u8; 16] {
        /// The system clock does not work properly. Bit 0.
        SYSTEM_CLOCK_FAILURE: bool = 0,
            system_clock_failure, set_system_clock_failure, with_system_clock_failure;
        /// The supply voltage is out of range, or an internal supply has failed. Bit 1.
        POWER_FAULT: bool = 1,
            power_fault, set_power_fault, with_power_fault;
        /// The firmware encountered an unexpected condition. Bit 4.
        FIRMWARE_FAULT: bool = 4,
            firmware_fault, set_firmware_fault, with_firmware_fault;
        /// The processor cannot keep up. Bit 5.
        TIMING_OVERLOAD: bool = 5,
            timing_overload, set_timing_overload, with_timing_overload;
        /// A data buffer was full and data may be lost. Bit 6.
        BUFFER_OVERRUN: bool = 6,
            buffer_overrun, set_buffer_overrun, with_buffer_overrun;
        /// The inertial sensor subsystem is not running or did not start. Bit 16.
        IMU_PROCESS_FAULT: bool = 16,
            imu_process_fault, set_imu_process_fault, with_imu_process_fault;
        /// Sensor data is not produced at its base rate. Bit 17.
        IMU_DATA_RATE_MISMATCH: bool = 17,
            imu_data_rate_mismatch, set_imu_data_rate_mismatch, with_imu_data_rate_mismatch;
        /// Sensor data was dropped. Bit 18.
        IMU_OVERRUN_DROPPED_DATA: bool = 18,
            imu_overrun_dropped_data, set_imu_overrun_dropped_data, with_imu_overrun_dropped_data;
        /// The inertial sensor process is stuck. Bit 19.
        IMU_STUCK: bool = 19,
            imu_stuck, set_imu_stuck, with_imu_stuck;
        /// The filter process failed. Bit 20.
        FILTER_PROCESS_FAULT: bool = 20,
            filter_process_fault, set_filter_process_fault, with_filter_process_fault;
        /// The filter dropped data. Bit 21.
        FILTER_DROPPED_DATA: bool = 21,
            filter_dropped_data, set_filter_dropped_data, with_filter_dropped_data;
        /// Filter data is not produced at its base rate. Bit 22.
        FILTER_RATE_MISMATCH: bool = 22,
            filter_rate_mismatch, set_filter_rate_mismatch, with_filter_rate_mismatch;
        /// The filter process is stuck. Bit 23.
        FILTER_STUCK: bool = 23,
            filter_stuck, set_filter_stuck, with_filter_stuck;
        /// The inertial sensor clock failed. Bit 32.
        IMU_CLOCK_FAULT: bool = 32,
            imu_clock_fault, set_imu_clock_fault, with_imu_clock_fault;
        /// No communication with the inertial sensors. Bit 33.
        IMU_COMM_FAULT: bool = 33,
            imu_comm_fault, set_imu_comm_fault, with_imu_comm_fault;
        /// Inertial sensor processes take longer than their time slot. Bit 34.
        IMU_TIMING_OVERRUN: bool = 34,
            imu_timing_overrun, set_imu_timing_overrun, with_imu_timing_overrun;
        /// Accelerometer calibration fault. Bit 36. Affects
        /// [`sensor::ScaledAccel`](crate::sensor::ScaledAccel).
        IMU_CALIBRATION_ERROR_ACCEL: bool = 36,
            imu_calibration_error_accel, set_imu_calibration_error_accel, with_imu_calibration_error_accel;
        /// Gyroscope calibration fault. Bit 37. Affects
        /// [`sensor::ScaledGyro`](crate::sensor::ScaledGyro).
        IMU_CALIBRATION_ERROR_GYRO: bool = 37,
            imu_calibration_error_gyro, set_imu_calibration_error_gyro, with_imu_calibration_error_gyro;
        /// Magnetometer calibration fault. Bit 38. Affects
        /// [`sensor::ScaledMag`](crate::sensor::ScaledMag).
        IMU_CALIBRATION_ERROR_MAG: bool = 38,
            imu_calibration_error_mag, set_imu_calibration_error_mag, with_imu_calibration_error_mag;
        /// The accelerometer failed to initialize. Bit 40. Affects
        /// [`sensor::ScaledAccel`](crate::sensor::ScaledAccel).
        ACCEL_GENERAL_FAULT: bool = 40,
            accel_general_fault, set_accel_general_fault, with_accel_general_fault;
        /// The acceleration along an axis is near or outside the selected range. Bit 41. Affects
        /// [`sensor::ScaledAccel`](crate::sensor::ScaledAccel).
        ACCEL_OVER_RANGE: bool = 41,
            accel_over_range, set_accel_over_range, with_accel_over_range;
        /// The accelerometer self-test failed; the commanded built-in test updates this bit. Bit
        /// 42. Affects [`sensor::ScaledAccel`](crate::sensor::ScaledAccel).
        ACCEL_SELF_TEST_FAIL: bool = 42,
            accel_self_test_fail, set_accel_self_test_fail, with_accel_self_test_fail;
        /// The gyroscope failed to initialize. Bit 44. Affects
        /// [`sensor::ScaledGyro`](crate::sensor::ScaledGyro).
        GYRO_GENERAL_FAULT: bool = 44,
            gyro_general_fault, set_gyro_general_fault, with_gyro_general_fault;
        /// The angular rate about an axis is near or outside the selected range. Bit 45. Affects
        /// [`sensor::ScaledGyro`](crate::sensor::ScaledGyro).
        GYRO_OVER_RANGE: bool = 45,
            gyro_over_range, set_gyro_over_range, with_gyro_over_range;
        /// The gyroscope self-test failed; the commanded built-in test updates this bit. Bit 46.
        /// Affects [`sensor::ScaledGyro`](crate::sensor::ScaledGyro).
        GYRO_SELF_TEST_FAIL: bool = 46,
            gyro_self_test_fail, set_gyro_self_test_fail, with_gyro_self_test_fail;
        /// The magnetometer failed to initialize. Bit 48. Affects
        /// [`sensor::ScaledMag`](crate::sensor::ScaledMag).
        MAG_GENERAL_FAULT: bool = 48,
            mag_general_fault, set_mag_general_fault, with_mag_general_fault;
        /// The magnetic field along an axis is near or outside the supported range. Bit 49. Affects
        /// [`sensor::ScaledMag`](crate::sensor::ScaledMag).
        MAG_OVER_RANGE: bool = 49,
            mag_over_range, set_mag_over_range, with_mag_over_range;
        /// The magnetometer self-test failed; the commanded built-in test updates this bit. Bit 50.
        /// Affects [`sensor::ScaledMag`](crate::sensor::ScaledMag).
        MAG_SELF_TEST_FAIL: bool = 50,
            mag_self_test_fail, set_mag_self_test_fail, with_mag_self_test_fail;
        /// The pressure sensor failed to initialize. Bit 52. Affects
        /// [`sensor::ScaledPressure`](crate::sensor::ScaledPressure).
        PRESSURE_SENSOR_GENERAL_FAULT: bool = 52,
            pressure_sensor_general_fault, set_pressure_sensor_general_fault, with_pressure_sensor_general_fault;
        /// The pressure is outside the supported range. Bit 53. Affects
        /// [`sensor::ScaledPressure`](crate::sensor::ScaledPressure).
        PRESSURE_SENSOR_OVER_RANGE: bool = 53,
            pressure_sensor_over_range, set_pressure_sensor_over_range, with_pressure_sensor_over_range;
        /// The pressure sensor self-test failed; the commanded built-in test updates this bit. Bit
        /// 54. Affects [`sensor::ScaledPressure`](crate::sensor::ScaledPressure).
        PRESSURE_SENSOR_SELF_TEST_FAIL: bool = 54,
            pressure_sensor_self_test_fail, set_pressure_sensor_self_test_fail, with_pressure_sensor_self_test_fail;
        /// The device has lost its factory configuration. Bit 56.
        FACTORY_BITS_INVALID: bool = 56,
            factory_bits_invalid, set_factory_bits_invalid, with_factory_bits_invalid;
        /// The filter does not work normally. Bit 64.
        FILTER_FAULT: bool = 64,
            filter_fault, set_filter_fault, with_filter_fault;
        /// Filter processes take longer than their time slot. Bit 66.
        FILTER_TIMING_OVERRUN: bool = 66,
            filter_timing_overrun, set_filter_timing_overrun, with_filter_timing_overrun;
        /// Filter processes are skipped. Bit 67.
        FILTER_TIMING_UNDERRUN: bool = 67,
            filter_timing_underrun, set_filter_timing_underrun, with_filter_timing_underrun;
    }
}

#[cfg(any(feature = "base", feature = "system_data"))]
bitfield! {
    /// Flags of the continuous built-in test of the 3DM-GQ7: bits 0-31 system, 32-63 inertial
    /// sensors, 64-95 navigation, 96-127 GNSS.
    ///
    /// Uncertain: The sources list only the numbers and names of the bits; the descriptions are
    /// those of the 3DM-CV7-GNSS/INS where the names are the same.
    ///
    /// Source: ros-driver: Built-in test of the GQ7; mscl: Continuous built-in test.
    Gq7ContinuousBuiltInTest: [u8; 16] {
        /// The system clock does not work properly. Bit 0.
        SYSTEM_CLOCK_FAILURE: bool = 0,
            system_clock_failure, set_system_clock_failure, with_system_clock_failure;
        /// The supply voltage is out of range, or an internal supply has failed. Bit 1.
        POWER_FAULT: bool = 1,
            power_fault, set_power_fault, with_power_fault;
        /// The firmware encountered an unexpected condition. Bit 4.
        FIRMWARE_FAULT: bool = 4,
            firmware_fault, set_firmware_fault, with_firmware_fault;
        /// The processor cannot keep up. Bit 5.
        TIMING_OVERLOAD: bool = 5,
            timing_overload, set_timing_overload, with_timing_overload;
        /// A data buffer was full and data may be lost. Bit 6.
        BUFFER_OVERRUN: bool = 6,
            buffer_overrun, set_buffer_overrun, with_buffer_overrun;
        /// Faults of the link to the inertial sensor processor. Bits 16 to 19.
        IMU_IPC_FAULT: u8 = 16..=19,
            imu_ipc_fault, set_imu_ipc_fault, with_imu_ipc_fault;
        /// Faults of the link to the filter processor. Bits 20 to 23.
        FILTER_IPC_FAULT: u8 = 20..=23,
            filter_ipc_fault, set_filter_ipc_fault, with_filter_ipc_fault;
        /// Faults of the link to the GNSS processor. Bits 24 to 27.
        GNSS_IPC_FAULT: u8 = 24..=27,
            gnss_ipc_fault, set_gnss_ipc_fault, with_gnss_ipc_fault;
        /// The inertial sensor clock failed. Bit 32.
        IMU_CLOCK_FAULT: bool = 32,
            imu_clock_fault, set_imu_clock_fault, with_imu_clock_fault;
        /// No communication with the inertial sensors. Bit 33.
        IMU_COMM_FAULT: bool = 33,
            imu_comm_fault, set_imu_comm_fault, with_imu_comm_fault;
        /// Inertial sensor processes take longer than their time slot. Bit 34.
        IMU_TIMING_OVERRUN: bool = 34,
            imu_timing_overrun, set_imu_timing_overrun, with_imu_timing_overrun;
        /// Accelerometer calibration fault. Bit 36. Affects
        /// [`sensor::ScaledAccel`](crate::sensor::ScaledAccel).
        IMU_CALIBRATION_ERROR_ACCEL: bool = 36,
            imu_calibration_error_accel, set_imu_calibration_error_accel, with_imu_calibration_error_accel;
        /// Gyroscope calibration fault. Bit 37. Affects
        /// [`sensor::ScaledGyro`](crate::sensor::ScaledGyro).
        IMU_CALIBRATION_ERROR_GYRO: bool = 37,
            imu_calibration_error_gyro, set_imu_calibration_error_gyro, with_imu_calibration_error_gyro;
        /// Magnetometer calibration fault. Bit 38. Affects
        /// [`sensor::ScaledMag`](crate::sensor::ScaledMag).
        IMU_CALIBRATION_ERROR_MAG: bool = 38,
            imu_calibration_error_mag, set_imu_calibration_error_mag, with_imu_calibration_error_mag;
        /// The accelerometer failed to initialize. Bit 40. Affects
        /// [`sensor::ScaledAccel`](crate::sensor::ScaledAccel).
        ACCEL_GENERAL_FAULT: bool = 40,
            accel_general_fault, set_accel_general_fault, with_accel_general_fault;
        /// The acceleration along an axis is near or outside the selected range. Bit 41. Affects
        /// [`sensor::ScaledAccel`](crate::sensor::ScaledAccel).
        ACCEL_OVER_RANGE: bool = 41,
            accel_over_range, set_accel_over_range, with_accel_over_range;
        /// The accelerometer self-test failed; the commanded built-in test updates this bit. Bit
        /// 42. Affects [`sensor::ScaledAccel`](crate::sensor::ScaledAccel).
        ACCEL_SELF_TEST_FAIL: bool = 42,
            accel_self_test_fail, set_accel_self_test_fail, with_accel_self_test_fail;
        /// The gyroscope failed to initialize. Bit 44. Affects
        /// [`sensor::ScaledGyro`](crate::sensor::ScaledGyro).
        GYRO_GENERAL_FAULT: bool = 44,
            gyro_general_fault, set_gyro_general_fault, with_gyro_general_fault;
        /// The angular rate about an axis is near or outside the selected range. Bit 45. Affects
        /// [`sensor::ScaledGyro`](crate::sensor::ScaledGyro).
        GYRO_OVER_RANGE: bool = 45,
            gyro_over_range, set_gyro_over_range, with_gyro_over_range;
        /// The gyroscope self-test failed; the commanded built-in test updates this bit. Bit 46.
        /// Affects [`sensor::ScaledGyro`](crate::sensor::ScaledGyro).
        GYRO_SELF_TEST_FAIL: bool = 46,
            gyro_self_test_fail, set_gyro_self_test_fail, with_gyro_self_test_fail;
        /// The magnetometer failed to initialize. Bit 48. Affects
        /// [`sensor::ScaledMag`](crate::sensor::ScaledMag).
        MAG_GENERAL_FAULT: bool = 48,
            mag_general_fault, set_mag_general_fault, with_mag_general_fault;
        /// The magnetic field along an axis is near or outside the supported range. Bit 49. Affects
        /// [`sensor::ScaledMag`](crate::sensor::ScaledMag).
        MAG_OVER_RANGE: bool = 49,
            mag_over_range, set_mag_over_range, with_mag_over_range;
        /// The magnetometer self-test failed; the commanded built-in test updates this bit. Bit 50.
        /// Affects [`sensor::ScaledMag`](crate::sensor::ScaledMag).
        MAG_SELF_TEST_FAIL: bool = 50,
            mag_self_test_fail, set_mag_self_test_fail, with_mag_self_test_fail;
        /// The pressure sensor failed to initialize. Bit 52. Affects
        /// [`sensor::ScaledPressure`](crate::sensor::ScaledPressure).
        PRESSURE_SENSOR_GENERAL_FAULT: bool = 52,
            pressure_sensor_general_fault, set_pressure_sensor_general_fault, with_pressure_sensor_general_fault;
        /// The pressure is outside the supported range. Bit 53. Affects
        /// [`sensor::ScaledPressure`](crate::sensor::ScaledPressure).
        PRESSURE_SENSOR_OVER_RANGE: bool = 53,
            pressure_sensor_over_range, set_pressure_sensor_over_range, with_pressure_sensor_over_range;
        /// The pressure sensor self-test failed; the commanded built-in test updates this bit. Bit
        /// 54. Affects [`sensor::ScaledPressure`](crate::sensor::ScaledPressure).
        PRESSURE_SENSOR_SELF_TEST_FAIL: bool = 54,
            pressure_sensor_self_test_fail, set_pressure_sensor_self_test_fail, with_pressure_sensor_self_test_fail;
        /// The filter clock failed. Bit 64.
        FILTER_CLOCK_FAULT: bool = 64,
            filter_clock_fault, set_filter_clock_fault, with_filter_clock_fault;
        /// Filter processor fault. Bit 65.
        FILTER_HARDWARE_FAULT: bool = 65,
            filter_hardware_fault, set_filter_hardware_fault, with_filter_hardware_fault;
        /// Filter processes take longer than their time slot. Bit 66.
        FILTER_TIMING_OVERRUN: bool = 66,
            filter_timing_overrun, set_filter_timing_overrun, with_filter_timing_overrun;
        /// Filter processes are skipped. Bit 67.
        FILTER_TIMING_UNDERRUN: bool = 67,
            filter_timing_underrun, set_filter_timing_underrun, with_filter_timing_underrun;
        /// Filter communication errors. Bits 68 to 71.
        FILTER_COMM_ERROR: u8 = 68..=71,
            filter_comm_error, set_filter_comm_error, with_filter_comm_error;
        /// The GNSS processor clock failed. Bit 96.
        GNSS_CLOCK_FAULT: bool = 96,
            gnss_clock_fault, set_gnss_clock_fault, with_gnss_clock_fault;
        /// GNSS processor fault. Bit 97.
        GNSS_HARDWARE_FAULT: bool = 97,
            gnss_hardware_fault, set_gnss_hardware_fault, with_gnss_hardware_fault;
        /// GNSS processor communication errors. Bits 98 to 100.
        GNSS_COMM_ERROR: u8 = 98..=100,
            gnss_comm_error, set_gnss_comm_error, with_gnss_comm_error;
        /// GPS time fault. Bit 101. Affects [`gnss_data::GpsTime`](crate::gnss_data::GpsTime).
        GPS_TIME_FAULT: bool = 101,
            gps_time_fault, set_gps_time_fault, with_gps_time_fault;
        /// A GNSS processor cycle exceeded its time slot. Bit 102.
        GNSS_TIMING_OVERRUN: bool = 102,
            gnss_timing_overrun, set_gnss_timing_overrun, with_gnss_timing_overrun;
        /// Receiver 1 power supply fault. Bit 104. Affects
        /// [`gnss_data::FixInfo`](crate::gnss_data::FixInfo).
        RECEIVER_1_POWER_FAULT: bool = 104,
            receiver_1_power_fault, set_receiver_1_power_fault, with_receiver_1_power_fault;
        /// No communication with internal receiver 1. Bit 105. Affects
        /// [`gnss_data::FixInfo`](crate::gnss_data::FixInfo).
        RECEIVER_1_FAULT: bool = 105,
            receiver_1_fault, set_receiver_1_fault, with_receiver_1_fault;
        /// Antenna 1 is shorted. Bit 106. Affects
        /// [`gnss_data::HardwareStatus`](crate::gnss_data::HardwareStatus).
        ANTENNA_1_SHORTED: bool = 106,
            antenna_1_shorted, set_antenna_1_shorted, with_antenna_1_shorted;
        /// Antenna 1 is not connected. Bit 107. Affects
        /// [`gnss_data::HardwareStatus`](crate::gnss_data::HardwareStatus).
        ANTENNA_1_OPEN: bool = 107,
            antenna_1_open, set_antenna_1_open, with_antenna_1_open;
        /// Receiver 1 has no solution. Bit 108. Affects
        /// [`gnss_data::FixInfo`](crate::gnss_data::FixInfo).
        RECEIVER_1_SOLUTION_FAULT: bool = 108,
            receiver_1_solution_fault, set_receiver_1_solution_fault, with_receiver_1_solution_fault;
        /// Receiver 2 power supply fault. Bit 109. Affects
        /// [`gnss_data::FixInfo`](crate::gnss_data::FixInfo).
        RECEIVER_2_POWER_FAULT: bool = 109,
            receiver_2_power_fault, set_receiver_2_power_fault, with_receiver_2_power_fault;
        /// No communication with internal receiver 2. Bit 110. Affects
        /// [`gnss_data::FixInfo`](crate::gnss_data::FixInfo).
        RECEIVER_2_FAULT: bool = 110,
            receiver_2_fault, set_receiver_2_fault, with_receiver_2_fault;
        /// Antenna 2 is shorted. Bit 111. Affects
        /// [`gnss_data::HardwareStatus`](crate::gnss_data::HardwareStatus).
        ANTENNA_2_SHORTED: bool = 111,
            antenna_2_shorted, set_antenna_2_shorted, with_antenna_2_shorted;
        /// Antenna 2 is not connected. Bit 112. Affects
        /// [`gnss_data::HardwareStatus`](crate::gnss_data::HardwareStatus).
        ANTENNA_2_OPEN: bool = 112,
            antenna_2_open, set_antenna_2_open, with_antenna_2_open;
        /// Receiver 2 has no solution. Bit 113. Affects
        /// [`gnss_data::FixInfo`](crate::gnss_data::FixInfo).
        RECEIVER_2_SOLUTION_FAULT: bool = 113,
            receiver_2_solution_fault, set_receiver_2_solution_fault, with_receiver_2_solution_fault;
        /// RTCM communication fault. Bit 114. Affects
        /// [`gnss_data::RtkCorrectionsStatus`](crate::gnss_data::RtkCorrectionsStatus).
        RTCM_COMM_FAULT: bool = 114,
            rtcm_comm_fault, set_rtcm_comm_fault, with_rtcm_comm_fault;
        /// RTK modem fault. Bit 115. Affects [`rtk::GetStatusFlags`](crate::rtk::GetStatusFlags).
        RTK_DONGLE_FAULT: bool = 115,
            rtk_dongle_fault, set_rtk_dongle_fault, with_rtk_dongle_fault;
    }
}

#[cfg(feature = "mip_3dm")]
open_enum! {
    /// Kind of an event trigger.
    ///
    /// Source: 3dm-cv7-gnss-ins: Event Trigger Configuration (0x0C,0x2E); 3dm-cv7-gnss-ins: Types
    /// of triggers.
    EventTriggerType: u8 {
        /// The instance is not in use: it is never active and cannot be enabled.
        NONE = 0, "none";
        /// Watches a GPIO pin.
        GPIO = 1, "gpio";
        /// Compares one value of a data field with thresholds.
        THRESHOLD = 2, "threshold";
        /// Combines up to four other triggers in a truth table.
        COMBINATION = 3, "combination";
    }
}

#[cfg(feature = "mip_3dm")]
open_enum! {
    /// Kind of an event action.
    ///
    /// Source: 3dm-cv7-gnss-ins: Event Action Configuration (0x0C,0x2F); 3dm-cv7-gnss-ins: Types of
    /// actions.
    EventActionType: u8 {
        /// The instance is not in use.
        NONE = 0, "none";
        /// Controls a GPIO pin.
        GPIO = 1, "gpio";
        /// Sends a data packet.
        MESSAGE = 2, "message";
    }
}

#[cfg(feature = "mip_3dm")]
open_enum! {
    /// Operating mode of an event trigger.
    ///
    /// Source: 3dm-cv7-gnss-ins: Event Control (0x0C,0x2B); 3dm-cv7-gnss-ins: Enabling & Disabling
    /// Triggers.
    EventTriggerMode: u8 {
        /// The trigger is never active. Configuring a trigger sets this mode.
        DISABLED = 0, "disabled";
        /// The trigger works as configured.
        ENABLED = 1, "enabled";
        /// The trigger is active all the time.
        TEST = 2, "test";
        /// The trigger is active for one event cycle and then returns to its previous mode.
        TEST_PULSE = 3, "test_pulse";
    }
}

#[cfg(feature = "mip_3dm")]
bitfield! {
    /// State of an event trigger.
    ///
    /// Source: 3dm-cv7-gnss-ins: Get Event Trigger Status (0x0C,0x2C).
    EventTriggerStatus: u8 {
        /// The trigger is active, because of its condition or a test mode. Bit 0.
        ACTIVE: bool = 0,
            active, set_active, with_active;
        /// The trigger is enabled. Bit 1.
        ENABLED: bool = 1,
            enabled, set_enabled, with_enabled;
        /// The trigger is in a test mode. Bit 2.
        TEST: bool = 2,
            test, set_test, with_test;
    }
}

open_enum! {
    /// Condition of a GPIO pin that activates a trigger.
    ///
    /// Source: 3dm-cv7-gnss-ins: Event Trigger Configuration (0x0C,0x2E); 3dm-cv7-gnss-ins:
    /// Trigger: GPIO.
    EventTriggerGpioMode: u8 {
        /// The trigger is never active.
        DISABLED = 0, "disabled";
        /// Active while the pin is high. The pin needs the gpio feature.
        WHILE_HIGH = 1, "while_high";
        /// Active while the pin is low. The pin needs the gpio feature.
        WHILE_LOW = 2, "while_low";
        /// Active for one event cycle after an edge. Each edge is a new activation, but actions run
        /// once per cycle: of several edges in one cycle, only one has an effect. The pin needs the
        /// timestamp feature, whose behavior selects the edge.
        EDGE = 4, "edge";
    }
}

open_enum! {
    /// Comparison of a threshold trigger.
    ///
    /// Source: 3dm-cv7-gnss-ins: ThresholdParams.
    EventThresholdType: u8 {
        /// The value is in a window between two thresholds, or outside of it.
        WINDOW = 1, "window";
        /// The remainder of the value divided by an interval is at most a threshold.
        INTERVAL = 2, "interval";
    }
}

open_enum! {
    /// Control of a GPIO pin by an action.
    ///
    /// Source: 3dm-cv7-gnss-ins: Event Action Configuration (0x0C,0x2F); 3dm-cv7-gnss-ins: Action:
    /// GPIO.
    EventActionGpioMode: u8 {
        /// The pin is not changed.
        DISABLED = 0, "disabled";
        /// High while the trigger is active and low otherwise.
        ACTIVE_HIGH = 1, "active_high";
        /// Low while the trigger is active and high otherwise.
        ACTIVE_LOW = 2, "active_low";
        /// Set high at each activation and never set low.
        ONESHOT_HIGH = 5, "oneshot_high";
        /// Set low at each activation and never set high.
        ONESHOT_LOW = 6, "oneshot_low";
        /// The pin is inverted each time the trigger activates.
        TOGGLE = 7, "toggle";
    }
}

record! {
    /// A trigger on a GPIO pin.
    ///
    /// Source: 3dm-cv7-gnss-ins: Event Trigger Configuration (0x0C,0x2E).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct EventTriggerGpio {
        /// GPIO pin, counted from 1.
        ///
        /// Range: at least 1.
        pub pin: u8,
        /// Condition of the pin that activates the trigger.
        pub mode: EventTriggerGpioMode,
    }
}

item! { EventTriggerGpio { pin mode } }
view! {
    EventTriggerGpio
    pin: u8, at 0;
    mode: EventTriggerGpioMode, at 1;
}

ranges! {
    EventTriggerGpio
    pin "pin" in "at least 1" From 1.0;
}

constructors! {
    EventTriggerGpio

    /// Creates it from its values.
    fn new(pin: u8, mode: EventTriggerGpioMode);
}

tuple! { EventTriggerGpio pin: u8, mode: EventTriggerGpioMode }

record! {
    /// Two thresholds with a window between them.
    ///
    /// Source: 3dm-cv7-gnss-ins: ThresholdParams; mip-sdk-4: Event Trigger (0x0C,0x2E).
    #[derive(Copy, Default)]
    pub struct EventThresholdWindow {
        /// Lower threshold, in the unit of the watched value.
        ///
        /// - The SDK calls it the first threshold.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub low_threshold: f64,
        /// Upper threshold, in the unit of the watched value. The trigger is active from the lower
        /// threshold to the upper one, both included. If the upper one is below the lower one, it
        /// is active below the upper and above the lower one, both excluded.
        ///
        /// - The SDK calls it the second threshold.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub high_threshold: f64,
    }
}

item! { EventThresholdWindow { low_threshold high_threshold } }
view! {
    EventThresholdWindow
    low_threshold: f64, at 0;
    high_threshold: f64, at 8;
}

constructors! {
    EventThresholdWindow

    /// Creates it from its values.
    fn new(low_threshold: f64, high_threshold: f64);
}

tuple! { EventThresholdWindow low_threshold: f64, high_threshold: f64 }

record! {
    /// A threshold inside a repeating interval.
    ///
    /// Source: 3dm-cv7-gnss-ins: ThresholdParams; mip-sdk-4: Event Trigger (0x0C,0x2E).
    #[derive(Copy, Default)]
    pub struct EventThresholdInterval {
        /// The trigger is active while the remainder is at most this, in the unit of the watched
        /// value.
        ///
        /// - The SDK calls it the first threshold.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub interval_threshold: f64,
        /// Divisor of the remainder, in the unit of the watched value. If it is below the
        /// threshold, the two swap roles: the trigger is active while the value modulo
        /// `interval_threshold` is above this.
        ///
        /// - The SDK calls it the second threshold.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub interval: f64,
    }
}

item! { EventThresholdInterval { interval_threshold interval } }
view! {
    EventThresholdInterval
    interval_threshold: f64, at 0;
    interval: f64, at 8;
}

constructors! {
    EventThresholdInterval

    /// Creates it from its values.
    fn new(interval_threshold: f64, interval: f64);
}

tuple! { EventThresholdInterval interval_threshold: f64, interval: f64 }

record! {
    /// A trigger on one value of a data field. The value is converted to double before it is
    /// compared.
    ///
    /// Source: 3dm-cv7-gnss-ins: ThresholdParams.
    #[derive(Copy, Default)]
    pub struct EventTriggerThreshold {
        /// Data descriptor set of the watched value.
        pub descriptor_set: crate::DescriptorSet,
        /// Field descriptor of the watched value.
        ///
        /// Refers to fields of [`descriptor_set`](EventTriggerThreshold::descriptor_set).
        pub field_descriptor: u8,
        /// Number of the value in its field, counted from 1; each element of a vector counts.
        ///
        /// Range: at least 1.
        pub parameter_id: u8,
        /// Kind of comparison.
        #[cfg_attr(feature = "serde", serde(rename = "type"))]
        pub type_: EventThresholdType,
        /// Thresholds of the comparison.
        ///
        /// Selected by [`type_`](EventTriggerThreshold::type_).
        pub thresholds: EventThreshold,
    }
    wire 20 {
        [descriptor_set]
        [field_descriptor]
        [parameter_id]
        [type_ "type"]
        [thresholds as type_]
    }
}

union! {
    /// The alternatives of `thresholds` in [`EventTriggerThreshold`].
    #[derive(Copy)]
    pub enum EventThreshold: EventThresholdType {
        /// The value is in a window between two thresholds, or outside of it.
        ///
        /// If [`type_`](EventTriggerThreshold::type_) is [`EventThresholdType::WINDOW`].
        #[cfg_attr(feature = "serde", serde(rename = "window"))]
        WINDOW => Window(EventThresholdWindow) "window",
        /// The remainder of the value divided by an interval is at most a threshold.
        ///
        /// If [`type_`](EventTriggerThreshold::type_) is [`EventThresholdType::INTERVAL`].
        #[cfg_attr(feature = "serde", serde(rename = "interval"))]
        INTERVAL => Interval(EventThresholdInterval) "interval",
    }
    default EventThreshold::Other(EventThresholdType(0))
}

item! { EventTriggerThreshold { descriptor_set field_descriptor parameter_id type_ thresholds } }
ranges! {
    EventTriggerThreshold
    parameter_id "parameter_id" in "at least 1" From 1.0;
}

constructors! {
    EventTriggerThreshold

    /// Creates it from its values.
    fn new(
        descriptor_set: impl Into<crate::DescriptorSet>,
        field_descriptor: u8,
        parameter_id: u8,
        thresholds: EventThreshold,
    ), type_: thresholds.tag();
}

record! {
    /// A trigger that combines up to four others.
    ///
    /// Source: 3dm-cv7-gnss-ins: CombinationParams; 3dm-cv7-gnss-ins: Logical Truth Table.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct EventTriggerCombination {
        /// Bit n is the output for n = a + 2b + 4c + 8d, where a to d are the states (0 or 1) of
        /// the four inputs.
        pub logic_table: u16,
        /// Trigger instances for the inputs a to d; 0 is always inactive.
        ///
        /// - An input may be the trigger itself; its value is then the output of the previous event
        ///   cycle.
        pub input_triggers: [u8; 4],
    }
}

item! { EventTriggerCombination { logic_table input_triggers } }
view! {
    EventTriggerCombination
    logic_table: u16, at 0;
    input_triggers: [u8; 4], at 2;
}

constructors! {
    EventTriggerCombination

    /// Creates it from its values.
    fn new(logic_table: u16, input_triggers: [u8; 4]);
}

tuple! { EventTriggerCombination logic_table: u16, input_triggers: [u8; 4] }

record! {
    /// An action on a GPIO pin, which needs the gpio feature and an output behavior.
    ///
    /// Source: 3dm-cv7-gnss-ins: GpioParams.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct EventActionGpio {
        /// GPIO pin, counted from 1.
        ///
        /// Range: at least 1.
        pub pin: u8,
        /// Pin level or pulse that the action generates.
        pub mode: EventActionGpioMode,
    }
}

item! { EventActionGpio { pin mode } }
view! {
    EventActionGpio
    pin: u8, at 0;
    mode: EventActionGpioMode, at 1;
}

ranges! {
    EventActionGpio
    pin "pin" in "at least 1" From 1.0;
}

constructors! {
    EventActionGpio

    /// Creates it from its values.
    fn new(pin: u8, mode: EventActionGpioMode);
}

tuple! { EventActionGpio pin: u8, mode: EventActionGpioMode }

record! {
    /// An action that sends data packets.
    ///
    /// The wire format also contains `num_fields`: Number of fields in the packet. Counts the
    /// elements of [`descriptors`](EventActionMessage::descriptors). Range: 0 to 12.
    ///
    /// Source: 3dm-cv7-gnss-ins: MessageParams.
    #[derive(Default, Eq, Hash)]
    pub struct EventActionMessage {
        /// Data descriptor set of the packet.
        pub descriptor_set: crate::DescriptorSet,
        /// 0 sends one packet per activation. Any other value streams while the trigger is active,
        /// at the base rate of the descriptor set divided by this value. At each activation, a
        /// packet is sent immediately and the count restarts.
        pub decimation: u16,
        /// Field descriptors, in order.
        ///
        /// Refers to fields of [`descriptor_set`](EventActionMessage::descriptor_set).
        pub descriptors: crate::List<u8, 249>,
    }
    wire 253 {
        [descriptor_set]
        [decimation]
        [num_fields: u8 counts descriptors]
        [descriptors by num_fields]
    }
}

item! { EventActionMessage { descriptor_set decimation descriptors } }
constructors! {
    EventActionMessage

    /// Creates it from its values.
    fn new(
        descriptor_set: impl Into<crate::DescriptorSet>,
        decimation: u16,
        descriptors: impl Into<crate::List<u8, 249>>,
    );
}

tuple! { EventActionMessage descriptor_set: crate::DescriptorSet, decimation: u16, descriptors: crate::List<u8, 249> }

#[cfg(feature = "gnss_data")]
open_enum! {
    /// Satellite constellation. QZSS has no value.
    ///
    /// Source: 3dm-cv7-gnss-ins: Satellite Status (0x91,0x20); 3dm-cv7-gnss-ins: Raw (0x91,0x22).
    GnssConstellation: u8 {
        /// Not known.
        UNKNOWN = 0, "unknown";
        /// Gps.
        GPS = 1, "gps";
        /// Glonass.
        GLONASS = 2, "glonass";
        /// Galileo.
        GALILEO = 3, "galileo";
        /// Beidou.
        BEIDOU = 4, "beidou";
        /// Satellites of augmentation systems (SBAS).
        SBAS = 5, "sbas";
    }
}

#[cfg(feature = "gnss_data")]
open_enum! {
    /// Type of a GNSS position fix.
    ///
    /// Source: 3dm-cv7-gnss-ins: Fix Info (0x91,0x0B).
    GnssFixType: u8 {
        /// Fix in three dimensions.
        FIX_3D = 0, "fix_3d";
        /// Fix in two dimensions.
        FIX_2D = 1, "fix_2d";
        /// The receiver computes the time, but no position.
        FIX_TIME_ONLY = 2, "fix_time_only";
        /// No fix.
        FIX_NONE = 3, "fix_none";
        /// The fix is not valid.
        FIX_INVALID = 4, "fix_invalid";
        /// RTK fix with float ambiguities.
        FIX_RTK_FLOAT = 5, "fix_rtk_float";
        /// RTK fix with integer ambiguities.
        FIX_RTK_FIXED = 6, "fix_rtk_fixed";
        /// The position uses differential corrections.
        FIX_DIFFERENTIAL = 7, "fix_differential";
    }
}

#[cfg(feature = "gnss_data")]
open_enum! {
    /// Signal of a satellite.
    ///
    /// Source: 3dm-cv7-gnss-ins: Raw (0x91,0x22).
    GnssSignal: u8 {
        /// Not known.
        UNKNOWN = 0, "unknown";
        /// GPS L1 C/A.
        GPS_L1CA = 1, "gps_l1ca";
        /// GPS L1 P(Y).
        GPS_L1P = 2, "gps_l1p";
        /// GPS L1 P(Y) by Z-tracking.
        GPS_L1Z = 3, "gps_l1z";
        /// GPS L2 C/A.
        GPS_L2CA = 4, "gps_l2ca";
        /// GPS L2 P(Y).
        GPS_L2P = 5, "gps_l2p";
        /// GPS L2 P(Y) by Z-tracking.
        GPS_L2Z = 6, "gps_l2z";
        /// GPS L2C(L).
        GPS_L2CL = 7, "gps_l2cl";
        /// GPS L2C(M).
        GPS_L2CM = 8, "gps_l2cm";
        /// GPS L2C(M+L).
        GPS_L2CML = 9, "gps_l2cml";
        /// GPS L5 I.
        GPS_L5I = 10, "gps_l5i";
        /// GPS L5 Q.
        GPS_L5Q = 11, "gps_l5q";
        /// GPS L5 I+Q.
        GPS_L5IQ = 12, "gps_l5iq";
        /// GPS L1C(D).
        GPS_L1CD = 13, "gps_l1cd";
        /// GPS L1C(P).
        GPS_L1CP = 14, "gps_l1cp";
        /// GPS L1C(D+P).
        GPS_L1CDP = 15, "gps_l1cdp";
        /// GLONASS G1 C/A.
        GLONASS_G1CA = 32, "glonass_g1ca";
        /// GLONASS G1 P.
        GLONASS_G1P = 33, "glonass_g1p";
        /// GLONASS G2 C/A.
        GLONASS_G2C = 34, "glonass_g2c";
        /// GLONASS G2 P.
        GLONASS_G2P = 35, "glonass_g2p";
        /// Galileo E1 C.
        GALILEO_E1C = 64, "galileo_e1c";
        /// Galileo E1 A.
        GALILEO_E1A = 65, "galileo_e1a";
        /// Galileo E1 B.
        GALILEO_E1B = 66, "galileo_e1b";
        /// Galileo E1 B+C.
        GALILEO_E1BC = 67, "galileo_e1bc";
        /// Galileo E1 A+B+C.
        GALILEO_E1ABC = 68, "galileo_e1abc";
        /// Galileo E6 C.
        GALILEO_E6C = 69, "galileo_e6c";
        /// Galileo E6 A.
        GALILEO_E6A = 70, "galileo_e6a";
        /// Galileo E6 B.
        GALILEO_E6B = 71, "galileo_e6b";
        /// Galileo E6 B+C.
        GALILEO_E6BC = 72, "galileo_e6bc";
        /// Galileo E6 A+B+C.
        GALILEO_E6ABC = 73, "galileo_e6abc";
        /// Galileo E5b I.
        GALILEO_E5BI = 74, "galileo_e5bi";
        /// Galileo E5b Q.
        GALILEO_E5BQ = 75, "galileo_e5bq";
        /// Galileo E5b I+Q.
        GALILEO_E5BIQ = 76, "galileo_e5biq";
        /// Galileo E5 (a+b) I.
        GALILEO_E5ABI = 77, "galileo_e5abi";
        /// Galileo E5 (a+b) Q.
        GALILEO_E5ABQ = 78, "galileo_e5abq";
        /// Galileo E5 (a+b) I+Q.
        GALILEO_E5ABIQ = 79, "galileo_e5abiq";
        /// Galileo E5a I.
        GALILEO_E5AI = 80, "galileo_e5ai";
        /// Galileo E5a Q.
        GALILEO_E5AQ = 81, "galileo_e5aq";
        /// Galileo E5a I+Q.
        GALILEO_E5AIQ = 82, "galileo_e5aiq";
        /// SBAS L1 C/A.
        SBAS_L1CA = 96, "sbas_l1ca";
        /// SBAS L5 I.
        SBAS_L5I = 97, "sbas_l5i";
        /// SBAS L5 Q.
        SBAS_L5Q = 98, "sbas_l5q";
        /// SBAS L5 I+Q.
        SBAS_L5IQ = 99, "sbas_l5iq";
        /// QZSS L1 C/A.
        QZSS_L1CA = 128, "qzss_l1ca";
        /// QZSS LEX S.
        QZSS_LEXS = 129, "qzss_lexs";
        /// QZSS LEX L.
        QZSS_LEXL = 130, "qzss_lexl";
        /// QZSS LEX S+L.
        QZSS_LEXSL = 131, "qzss_lexsl";
        /// QZSS L2C(M).
        QZSS_L2CM = 132, "qzss_l2cm";
        /// QZSS L2C(L).
        QZSS_L2CL = 133, "qzss_l2cl";
        /// QZSS L2C(M+L).
        QZSS_L2CML = 134, "qzss_l2cml";
        /// QZSS L5 I.
        QZSS_L5I = 135, "qzss_l5i";
        /// QZSS L5 Q.
        QZSS_L5Q = 136, "qzss_l5q";
        /// QZSS L5 I+Q.
        QZSS_L5IQ = 137, "qzss_l5iq";
        /// QZSS L1C(D).
        QZSS_L1CD = 138, "qzss_l1cd";
        /// QZSS L1C(P).
        QZSS_L1CP = 139, "qzss_l1cp";
        /// QZSS L1C(D+P).
        QZSS_L1CDP = 140, "qzss_l1cdp";
        /// BeiDou B1 I.
        BEIDOU_B1I = 160, "beidou_b1i";
        /// BeiDou B1 Q.
        BEIDOU_B1Q = 161, "beidou_b1q";
        /// BeiDou B1 I+Q.
        BEIDOU_B1IQ = 162, "beidou_b1iq";
        /// BeiDou B3 I.
        BEIDOU_B3I = 163, "beidou_b3i";
        /// BeiDou B3 Q.
        BEIDOU_B3Q = 164, "beidou_b3q";
        /// BeiDou B3 I+Q.
        BEIDOU_B3IQ = 165, "beidou_b3iq";
        /// BeiDou B2 I.
        BEIDOU_B2I = 166, "beidou_b2i";
        /// BeiDou B2 Q.
        BEIDOU_B2Q = 167, "beidou_b2q";
        /// BeiDou B2 I+Q.
        BEIDOU_B2IQ = 168, "beidou_b2iq";
        /// Beidou b2a.
        BEIDOU_B2A = 169, "beidou_b2a";
    }
}

#[cfg(feature = "mip_3dm")]
open_enum! {
    /// Use of a GPIO pin.
    ///
    /// Source: 3dm-cv7-gnss-ins: GPIO Configuration (0x0C,0x41); 3dm-cv7-gnss-ins: GPIO Features.
    GpioFeature: u8 {
        /// Not connected. Reading the pin may work but is not guaranteed.
        UNUSED = 0, "unused";
        /// General input or output.
        GPIO = 1, "gpio";
        /// Input or output of the pulse per second.
        PPS = 2, "pps";
        /// Input of a motor encoder or odometer.
        ENCODER = 3, "encoder";
        /// Input whose edges get precise timestamps for event triggers.
        TIMESTAMP = 4, "timestamp";
        /// Data or control line of a UART.
        UART = 5, "uart";
    }
}

#[cfg(feature = "mip_3dm")]
open_enum! {
    /// Behavior of a pin whose feature is unused.
    GpioUnusedBehavior: u8 {
        /// No other value is defined.
        UNUSED = 0, "unused";
    }
}

#[cfg(feature = "mip_3dm")]
open_enum! {
    /// Behavior of a pin whose feature is gpio.
    GpioBehavior: u8 {
        /// Input; the default.
        INPUT = 1, "input";
        /// Output, initially low; also low at power-up if the configuration is saved.
        OUTPUT_LOW = 2, "output_low";
        /// Output, initially high; also high at power-up if the configuration is saved.
        OUTPUT_HIGH = 3, "output_high";
    }
}

#[cfg(feature = "mip_3dm")]
open_enum! {
    /// Behavior of a pin whose feature is pps.
    GpioPpsBehavior: u8 {
        /// The pin receives the pulse; the PPS source must be gpio. At most one pin.
        INPUT = 1, "input";
        /// The pin sends the pulse of the device.
        OUTPUT = 2, "output";
    }
}

#[cfg(feature = "mip_3dm")]
open_enum! {
    /// Behavior of a pin whose feature is encoder.
    GpioEncoderBehavior: u8 {
        /// Quadrature input A. At most one pin; the last one configured takes precedence.
        A = 1, "a";
        /// Quadrature input B. At most one pin; the last one configured takes precedence.
        B = 2, "b";
    }
}

#[cfg(feature = "mip_3dm")]
open_enum! {
    /// Behavior of a pin whose feature is timestamp.
    GpioTimestampBehavior: u8 {
        /// Rising edges get timestamps.
        RISING = 1, "rising";
        /// Falling edges get timestamps.
        FALLING = 2, "falling";
        /// Both edges get timestamps.
        EITHER = 3, "either";
    }
}

#[cfg(feature = "mip_3dm")]
open_enum! {
    /// Behavior of a pin whose feature is uart.
    GpioUartBehavior: u8 {
        /// UART 2 transmits.
        PORT_2_TX = 33, "port_2_tx";
        /// UART 2 receives.
        PORT_2_RX = 34, "port_2_rx";
        /// UART 3 transmits.
        PORT_3_TX = 49, "port_3_tx";
        /// UART 3 receives.
        PORT_3_RX = 50, "port_3_rx";
    }
}

#[cfg(feature = "mip_3dm")]
bitfield! {
    /// Electrical options of a GPIO pin. The allowed ones depend on the device, the pin, the
    /// feature and the behavior.
    ///
    /// Source: 3dm-cv7-gnss-ins: GPIO Configuration (0x0C,0x41); 3dm-cv7-gnss-ins: Pin Mode.
    GpioPinMode: u8 {
        /// The output drives low or floats. It usually needs a pull-up. Bit 0.
        OPEN_DRAIN: bool = 0,
            open_drain, set_open_drain, with_open_drain;
        /// Internal pull-down resistor; not together with the pull-up. Bit 1.
        PULLDOWN: bool = 1,
            pulldown, set_pulldown, with_pulldown;
        /// Internal pull-up resistor; not together with the pull-down. May lower the allowed input
        /// voltage. Bit 2.
        PULLUP: bool = 2,
            pullup, set_pullup, with_pullup;
    }
}

open_enum! {
    /// An NMEA-0183 sentence that a device can send.
    ///
    /// Source: 3dm-cv7-gnss-ins: Supported Sentences and Talker IDs; 3dm-cv7-gnss-ins: PMSRA -
    /// Euler Angles; 3dm-cv7-gnss-ins: PMSRR - Angular Rate and Acceleration.
    NmeaMessageId: u8 {
        /// GNSS fix, from a GNSS data set or the filter data set.
        GGA = 1, "gga";
        /// Latitude and longitude, from a GNSS data set or the filter data set.
        GLL = 2, "gll";
        /// Satellites in view, from a GNSS data set. The constellation determines the talker.
        GSV = 3, "gsv";
        /// Recommended minimum GNSS data, from a GNSS data set or the filter data set.
        RMC = 4, "rmc";
        /// Course and speed over ground, from a GNSS data set or the filter data set.
        VTG = 5, "vtg";
        /// True heading, from a GNSS data set or the filter data set.
        HDT = 6, "hdt";
        /// Time and date, from a GNSS data set.
        ZDA = 7, "zda";
        /// GNSS error statistics, from a GNSS data set or the filter data set.
        GST = 8, "gst";
        /// Proprietary sentence `$PMSRA,hhmmss.ss,roll,pitch,yaw*hh`: UTC time and Euler angles in
        /// degrees with three decimals. From the filter data set.
        MSRA = 129, "msra";
        /// Proprietary sentence `$PMSRR,hhmmss.ss,ax,ay,az,wx,wy,wz*hh`: UTC time, acceleration in
        /// g and angular rate in deg/s about the x, y and z axes, with six decimals. From the
        /// sensor data set.
        MSRR = 130, "msrr";
    }
}

open_enum! {
    /// The first letters of an NMEA-0183 sentence, which identify its talker.
    ///
    /// Source: 3dm-cv7-gnss-ins: Supported Sentences and Talker IDs.
    NmeaTalkerId: u8 {
        /// For sentences whose talker cannot be chosen (GSV and the proprietary ones).
        IGNORED = 0, "ignored";
        /// Talker GN: several constellations.
        GNSS = 1, "gnss";
        /// Talker GP: GPS only.
        GPS = 2, "gps";
        /// Talker GA: Galileo only.
        GALILEO = 3, "galileo";
        /// Talker GL: GLONASS only.
        GLONASS = 4, "glonass";
    }
}

record! {
    /// An NMEA-0183 sentence with its talker, its data source and how often it is sent.
    ///
    /// Source: 3dm-cv7-gnss-ins: Sources and Talker IDs.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct NmeaMessage {
        /// The sentence.
        pub message_id: NmeaMessageId,
        /// The talker in the sentence.
        pub talker_id: NmeaTalkerId,
        /// Data descriptor set from which the contents are taken.
        pub source_descriptor_set: crate::DescriptorSet,
        /// Base rate of the source descriptor set divided by the desired rate; a poll ignores it.
        pub decimation: u16,
    }
}

item! { NmeaMessage { message_id talker_id source_descriptor_set decimation } }
view! {
    NmeaMessage
    message_id: NmeaMessageId, at 0;
    talker_id: NmeaTalkerId, at 1;
    source_descriptor_set: crate::DescriptorSet, at 2;
    decimation: u16, at 3;
}

constructors! {
    NmeaMessage

    /// Creates it from its values.
    fn new(
        message_id: NmeaMessageId,
        talker_id: NmeaTalkerId,
        source_descriptor_set: impl Into<crate::DescriptorSet>,
        decimation: u16,
    );
}

tuple! { NmeaMessage message_id: NmeaMessageId, talker_id: NmeaTalkerId, source_descriptor_set: crate::DescriptorSet, decimation: u16 }

#[cfg(any(feature = "base", feature = "system"))]
open_enum! {
    /// A port of a device.
    ///
    /// Source: 3dm-cv7-gnss-ins: Ports; mip-sdk-4: Interface Control (0x7F,0x02).
    CommInterface: u8 {
        /// All ports.
        ALL = 0, "all";
        /// The main port: USB while a host has it open (DTR), else the main UART.
        MAIN = 1, "main";
        /// The first port that is a UART or can be one.
        UART_1 = 17, "uart_1";
        /// The second UART, on GPIO pins 1 and 2 of the 3DM-CV7 and 3DM-GV7 models.
        UART_2 = 18, "uart_2";
        /// The third UART, on GPIO pins 3 and 4 of the 3DM-CV7 models.
        UART_3 = 19, "uart_3";
        /// First USB virtual serial port.
        USB_1 = 33, "usb_1";
        /// Second USB virtual serial port; on GNSS/INS models, intended for NMEA and RTCM.
        USB_2 = 34, "usb_2";
    }
}

#[cfg(any(feature = "gnss_data", feature = "rtk"))]
bitfield! {
    /// State of the modem and of the corrections. If `version` is 0, as sent by modems of the first
    /// generation, the other bits have no meaning here: read the word as [`RtkStatusFlagsLegacy`].
    ///
    /// Uncertain: The SDK states only that the form depends on the model number. Uncertain: Other
    /// software of the vendor evaluates `version`: 0 is the legacy form, 1 is this one. In the
    /// legacy form of the SDK the same two bits are `sinr`. Uncertain: The SDK lists only the
    /// names, from which the descriptions are inferred. The meaning of the values is not known.
    ///
    /// Source: mip-sdk-4: Get Status Flags (0x0F,0x01).
    RtkStatusFlags: u32 {
        /// State of the modem. Bits 0 to 3.
        MODEM_STATE: u8 = 0..=3,
            modem_state, set_modem_state, with_modem_state;
        /// Kind of cellular connection. Bits 4 to 7.
        CONNECTION_TYPE: u8 = 4..=7,
            connection_type, set_connection_type, with_connection_type;
        /// Received signal strength. Bits 8 to 15. Uncertain: No source states the unit and the
        /// sign; other software of the vendor treats it as negative.
        RSSI: u8 = 8..=15,
            rssi, set_rssi, with_rssi;
        /// Quality of the modem's radio signal. Bits 16 to 19.
        SIGNAL_QUALITY: u8 = 16..=19,
            signal_quality, set_signal_quality, with_signal_quality;
        /// Cell tower changes. Bits 20 to 23.
        TOWER_CHANGE_INDICATOR: u8 = 20..=23,
            tower_change_indicator, set_tower_change_indicator, with_tower_change_indicator;
        /// No NMEA was received from the device in time. Bit 24.
        NMEA_TIMEOUT: bool = 24,
            nmea_timeout, set_nmea_timeout, with_nmea_timeout;
        /// The server did not answer in time. Bit 25.
        SERVER_TIMEOUT: bool = 25,
            server_timeout, set_server_timeout, with_server_timeout;
        /// No corrections were received in time. Bit 26.
        CORRECTIONS_TIMEOUT: bool = 26,
            corrections_timeout, set_corrections_timeout, with_corrections_timeout;
        /// The device is outside the service area. Bit 27.
        DEVICE_OUT_OF_RANGE: bool = 27,
            device_out_of_range, set_device_out_of_range, with_device_out_of_range;
        /// There are no corrections. Bit 28.
        CORRECTIONS_UNAVAILABLE: bool = 28,
            corrections_unavailable, set_corrections_unavailable, with_corrections_unavailable;
        /// Form of these flags. Bits 30 to 31.
        VERSION: u8 = 30..=31,
            version, set_version, with_version;
    }
}

bitfield! {
    /// State of the modem and the corrections, in the older layout.
    ///
    /// Uncertain: The form depends on the model; see [`RtkStatusFlags`]. Uncertain: The SDK calls
    /// bits 20-31 reserved, but also puts the last four numbers there. Uncertain: The SDK lists
    /// only the names, from which the descriptions are inferred. The meaning of the values is not
    /// known.
    ///
    /// Source: mip-sdk-4: Get Status Flags (0x0F,0x01).
    RtkStatusFlagsLegacy: u32 {
        /// State of the controller. Bits 0 to 2.
        CONTROLLER_STATE: u8 = 0..=2,
            controller_state, set_controller_state, with_controller_state;
        /// State of the platform. Bits 3 to 7.
        PLATFORM_STATE: u8 = 3..=7,
            platform_state, set_platform_state, with_platform_state;
        /// Status code of the controller. Bits 8 to 10.
        CONTROLLER_STATUS_CODE: u8 = 8..=10,
            controller_status_code, set_controller_status_code, with_controller_status_code;
        /// Status code of the platform. Bits 11 to 13.
        PLATFORM_STATUS_CODE: u8 = 11..=13,
            platform_status_code, set_platform_status_code, with_platform_status_code;
        /// Reason for the last reset. Bits 14 to 15.
        RESET_CODE: u8 = 14..=15,
            reset_code, set_reset_code, with_reset_code;
        /// Quality of the modem's radio signal. Bits 16 to 19.
        SIGNAL_QUALITY: u8 = 16..=19,
            signal_quality, set_signal_quality, with_signal_quality;
        /// Received signal strength. Bits 20 to 25.
        RSSI: u8 = 20..=25,
            rssi, set_rssi, with_rssi;
        /// Received power of the reference signal. Bits 26 to 27.
        RSRP: u8 = 26..=27,
            rsrp, set_rsrp, with_rsrp;
        /// Received quality of the reference signal. Bits 28 to 29.
        RSRQ: u8 = 28..=29,
            rsrq, set_rsrq, with_rsrq;
        /// Signal to interference and noise ratio. Bits 30 to 31.
        SINR: u8 = 30..=31,
            sinr, set_sinr, with_sinr;
    }
}

vector! {
    /// Three floats.
    Vector3f: [f32; 3] {
        /// The element x.
        x,
        /// The element y.
        y,
        /// The element z.
        z,
    }
}

vector! {
    /// Three doubles.
    Vector3d: [f64; 3] {
        /// The element x.
        x,
        /// The element y.
        y,
        /// The element z.
        z,
    }
}

vector! {
    /// Three floats in the NED frame.
    Ned3f: [f32; 3] {
        /// The element north.
        north,
        /// The element east.
        east,
        /// The element down.
        down,
    }
}

vector! {
    /// Three doubles in the NED frame.
    Ned3d: [f64; 3] {
        /// The element north.
        north,
        /// The element east.
        east,
        /// The element down.
        down,
    }
}

vector! {
    /// Three by three floats in row-major order.
    Matrix3f: [f32; 9] {
        /// The element m11.
        m11,
        /// The element m12.
        m12,
        /// The element m13.
        m13,
        /// The element m21.
        m21,
        /// The element m22.
        m22,
        /// The element m23.
        m23,
        /// The element m31.
        m31,
        /// The element m32.
        m32,
        /// The element m33.
        m33,
    }
}

vector! {
    /// A quaternion, scalar part first.
    Quatf: [f32; 4] {
        /// The element w.
        w,
        /// The element x.
        x,
        /// The element y.
        y,
        /// The element z.
        z,
    }
}

open_enum! {
    /// The result of a command.
    ///
    /// Source: 3dm-gx5-15: 4.5 Error Codes; 3dm-cv7-gnss-ins: Ack/Nack Codes.
    AckCode: u8 {
        /// The command was carried out.
        OK = 0, "ok";
        /// The device does not know the command descriptor.
        UNKNOWN_COMMAND = 1, "unknown_command";
        /// A complete packet had a wrong checksum.
        BAD_CHECKSUM = 2, "bad_checksum";
        /// A parameter is out of range, or of the wrong size or type.
        INVALID_PARAMETER = 3, "invalid_parameter";
        /// The device could not carry out the command.
        COMMAND_FAILED = 4, "command_failed";
        /// The command did not finish in time.
        COMMAND_TIMEOUT = 5, "command_timeout";
        /// The device does not know the descriptor set.
        UNKNOWN_DESCRIPTOR_SET = 6, "unknown_descriptor_set";
    }
}

record! {
    /// A field of a message format and how often it is sent.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct DescriptorRate {
        /// Field descriptor.
        pub descriptor: u8,
        /// Base rate divided by the desired rate.
        ///
        /// Range: at least 1.
        pub decimation: u16,
    }
}

item! { DescriptorRate { descriptor decimation } }
view! {
    DescriptorRate
    descriptor: u8, at 0;
    decimation: u16, at 1;
}

ranges! {
    DescriptorRate
    decimation "decimation" in "at least 1" From 1.0;
}

constructors! {
    DescriptorRate

    /// Creates it from its values.
    fn new(descriptor: u8, decimation: u16);
}

tuple! { DescriptorRate descriptor: u8, decimation: u16 }

#[cfg(feature = "sensor")]
bitfield! {
    /// State of the GPS time of sensor data.
    ///
    /// Source: 3dm-cv7-gnss-ins: GPS Timestamp (0x80,0x12).
    SensorGpsTimestampFlags: u16 {
        /// The PPS signal is present. Bit 0.
        PPS_VALID: bool = 0,
            pps_valid, set_pps_valid, with_pps_valid;
        /// Toggles each time the time is updated. Bit 1.
        TIME_REFRESH: bool = 1,
            time_refresh, set_time_refresh, with_time_refresh;
        /// The time has been set at least once. Bit 2.
        TIME_INITIALIZED: bool = 2,
            time_initialized, set_time_initialized, with_time_initialized;
        /// The time of week is valid. Bit 3.
        TOW_VALID: bool = 3,
            tow_valid, set_tow_valid, with_tow_valid;
        /// The week number is valid. Bit 4.
        WEEK_NUMBER_VALID: bool = 4,
            week_number_valid, set_week_number_valid, with_week_number_valid;
    }
}

#[cfg(feature = "sensor")]
bitfield! {
    /// State of the GPS time of sensor data on the 3DM-GX5-15, which has no bits for the validity
    /// of the values.
    ///
    /// Source: 3dm-gx5-15: 5.1.11 GPS Correlation Timestamp (0x80, 0x12).
    Gx5SensorGpsTimestampFlags: u16 {
        /// The PPS signal is present; without it, the internal clock drives the time. Bit 0.
        PPS_VALID: bool = 0,
            pps_valid, set_pps_valid, with_pps_valid;
        /// Toggles each time the time is updated. Bit 1.
        TIME_REFRESH: bool = 1,
            time_refresh, set_time_refresh, with_time_refresh;
        /// The time has been set at least once. Bit 2.
        TIME_INITIALIZED: bool = 2,
            time_initialized, set_time_initialized, with_time_initialized;
    }
}

/// On the [3DM-CV5-10](crate::devices::CV5_10), [3DM-CV5-15](crate::devices::CV5_15),
/// [3DM-CV5-25](crate::devices::CV5_25), [3DM-CX5-10](crate::devices::CX5_10),
/// [3DM-CX5-15](crate::devices::CX5_15), [3DM-CX5-25](crate::devices::CX5_25),
/// [3DM-CX5-45](crate::devices::CX5_45), [3DM-DH3](crate::devices::DH3),
/// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX3-15](crate::devices::GX3_15),
/// [3DM-GX3-25](crate::devices::GX3_25), [3DM-GX3-35](crate::devices::GX3_35),
/// [3DM-GX3-45](crate::devices::GX3_45), [3DM-GX4-15](crate::devices::GX4_15),
/// [3DM-GX4-25](crate::devices::GX4_25), [3DM-GX4-45](crate::devices::GX4_45),
/// [3DM-GX4-IMU](crate::devices::GX4_IMU), [3DM-GX5-25](crate::devices::GX5_25),
/// [3DM-GX5-45](crate::devices::GX5_45), [3DM-MV5-AR](crate::devices::MV5_AR),
/// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT), [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST) and
/// [3DM-RQ1-IMU](crate::devices::RQ1_IMU): values of [`Gx5SensorGpsTimestampFlags`] (inferred: the
/// 3DM-GX5-15 has it). On the [3DM-GX5-15](crate::devices::GX5_15) and
/// [3DM-GX5-35](crate::devices::GX5_35): values of [`Gx5SensorGpsTimestampFlags`].
#[cfg(feature = "sensor")]
#[rustfmt::skip]
impl From<SensorGpsTimestampFlags> for Gx5SensorGpsTimestampFlags {
    fn from(value: SensorGpsTimestampFlags) -> Self {
        Self(value.0)
    }
}
