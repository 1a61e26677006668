"""Types that several descriptor sets use."""

from __future__ import annotations

if __name__ == "types":
    raise ImportError(
        "this is types.py of mip_protocol, not Python's own: run Python in another folder"
    )

from collections.abc import Sequence
from enum import IntFlag
from typing import Any, NamedTuple, SupportsIndex, overload

from . import codec
from .field import Structure

# Numbers that are read and written together, by their letters for `struct`.
_2B = codec.Block("2B")

_2d = codec.Block("2d")

_3BH = codec.Block("3BH")

_4B = codec.Block("4B")

_BH = codec.Block("BH")

_BHB = codec.Block("BHB")

_H4B = codec.Block("H4B")


@codec.open_flag(32)
class Gx5BuiltInTest(IntFlag):
    """Result of the built-in test of the 3DM-GX5-15: processor board, sensor board, filter.

    - 3dm-gx5-15: 4.1.5 Device Built-In Test (0x01, 0x05)
    """

    WATCHDOG_RESET = 1 << 0
    """The watchdog has reset the processor; cleared by the first commanded test. Bit 0."""
    IMU_COMM_FAULT = 1 << 8
    """No communication with the inertial sensor. Bit 8."""
    MAG_FAULT = 1 << 9
    """Magnetometer fault, on devices that have one. Bit 9. Affects `sensor.ScaledMag`."""
    PRESSURE_SENSOR_FAULT = 1 << 10
    """Pressure sensor fault, on devices that have one. Bit 10. Affects `sensor.ScaledPressure`."""
    SOLUTION_FAULT = 1 << 24
    """Fault of the estimation filter solution. Bit 24. Affects `filter.Reset`."""


@codec.open_flag(32)
class Cv7BuiltInTest(IntFlag):
    """Result of the commanded built-in test of the 3DM-CV7-GNSS/INS.

    - 3dm-cv7-gnss-ins: Commanded Built-in Test
    """

    GENERAL_HARDWARE_FAULT = 1 << 0
    """A critical part, such as the oscillator, has failed. Bit 0."""
    GENERAL_FIRMWARE_FAULT = 1 << 1
    """The firmware encountered a serious or unexpected condition. Bit 1."""
    TIMING_OVERLOAD = 1 << 2
    """The processor cannot keep up; cleared by reading the result. Bit 2."""
    BUFFER_OVERRUN = 1 << 3
    """A data buffer was full, usually because too much data is streamed. Bit 3."""
    ACCEL_FAULT = 1 << 12
    """The accelerometer is damaged or does not work. Bit 12. Affects `sensor.ScaledAccel`."""
    GYRO_FAULT = 1 << 13
    """The gyroscope is damaged or does not work. Bit 13. Affects `sensor.ScaledGyro`."""
    MAG_FAULT = 1 << 14
    """The magnetometer is damaged or does not work. Bit 14. Affects `sensor.ScaledMag`."""
    PRESSURE_SENSOR_FAULT = 1 << 15
    """The pressure sensor is damaged or does not work. Bit 15. Affects `sensor.ScaledPressure`."""
    CALIBRATION_ERROR = 1 << 18
    """At least one calibration table of the sensors is invalid. Bit 18."""
    GENERAL_IMU_FAULT = 1 << 19
    """A fault of the inertial sensor subsystem that no other bit covers. Bit 19."""
    FILTER_SOLUTION_FAULT = 1 << 22
    """The filter output is invalid (not a number); reset the filter. Bit 22. Affects
    `filter.Reset`.
    """
    GENERAL_FILTER_FAULT = 1 << 23
    """A fault of the filter subsystem that no other bit covers. Bit 23."""


@codec.open_flag(128)
class Cv7ContinuousBuiltInTest(IntFlag):
    """Flags of the continuous built-in test of the 3DM-CV7-GNSS/INS: bits 0-31 system, 32-63
    inertial sensors, 64-95 navigation, 96-127 GNSS.

    - 3dm-cv7-gnss-ins: Continuous Built-in Test
    """

    SYSTEM_CLOCK_FAILURE = 1 << 0
    """The system clock does not work properly. Bit 0."""
    POWER_FAULT = 1 << 1
    """The supply voltage is out of range, or an internal supply has failed. Bit 1."""
    FIRMWARE_FAULT = 1 << 4
    """The firmware encountered an unexpected condition. Bit 4."""
    TIMING_OVERLOAD = 1 << 5
    """The processor cannot keep up. Bit 5."""
    BUFFER_OVERRUN = 1 << 6
    """A data buffer was full and data may be lost. Bit 6."""
    IMU_PROCESS_FAULT = 1 << 16
    """The inertial sensor subsystem is not running or did not start. Bit 16."""
    IMU_DATA_PROCESS_TIME_EXCEEDED = 1 << 17
    """The processing of sensor data took too long. Bit 17."""
    IMU_DATA_RATE_ERROR = 1 << 18
    """Sensor data is not produced at its base rate. Bit 18."""
    IMU_STALL = 1 << 19
    """The inertial sensor subsystem produces no data. Bit 19."""
    FILTER_PROCESS_FAULT = 0xF00000
    """Set if any filter fault (bits 20-23) is set. Bits 20 to 23. Overlaps other bits."""
    FILTER_MAJOR_CYCLE_FAULT = 1 << 20
    """Fault of the major cycle of the filter; bits 22 and 23 show which fault. Bit 20."""
    FILTER_MINOR_CYCLE_FAULT = 1 << 21
    """Fault of the minor cycle of the filter; bits 22 and 23 show which fault. Bit 21."""
    FILTER_DATA_RATE_ERROR = 1 << 22
    """A filter process misses its base rate; bits 20 and 21 show which. Bit 22."""
    FILTER_PROCESS_STALL = 1 << 23
    """A filter process produces no data; bits 20 and 21 show which. Bit 23."""
    GNSS_SUBSYSTEM_FAULT = 0xF000000
    """Set if any GNSS fault (bits 24-27) is set. Bits 24 to 27. Overlaps other bits."""
    GNSS_MAIN_PROCESS_FAULT = 1 << 24
    """The main GNSS process did not run in time. Bit 24."""
    GNSS_RECEIVER_1_STALL = 1 << 25
    """No data from internal receiver 1 in time. Bit 25. Affects `gnss_data.FixInfo`."""
    GNSS_RECEIVER_2_STALL = 1 << 26
    """No data from internal receiver 2 in time. Bit 26. Affects `gnss_data.FixInfo`."""
    IMU_COMM_FAULT = 1 << 33
    """No communication with the inertial sensors. Bit 33."""
    IMU_TIMING_OVERRUN = 1 << 34
    """Inertial sensor processes take longer than their time slot. Bit 34."""
    IMU_CALIBRATION_ERROR_ACCEL = 1 << 36
    """Accelerometer calibration fault. Bit 36. Affects `sensor.ScaledAccel`."""
    IMU_CALIBRATION_ERROR_GYRO = 1 << 37
    """Gyroscope calibration fault. Bit 37. Affects `sensor.ScaledGyro`."""
    IMU_CALIBRATION_ERROR_MAG = 1 << 38
    """Magnetometer calibration fault. Bit 38. Affects `sensor.ScaledMag`."""
    ACCEL_GENERAL_FAULT = 1 << 40
    """The accelerometer failed to initialize. Bit 40. Affects `sensor.ScaledAccel`."""
    ACCEL_OVER_RANGE = 1 << 41
    """The acceleration along an axis is near or outside the selected range. Bit 41. Affects
    `sensor.ScaledAccel`.
    """
    ACCEL_SELF_TEST_FAIL = 1 << 42
    """The accelerometer self-test failed; the commanded built-in test updates this bit. Bit 42.
    Affects `sensor.ScaledAccel`.
    """
    GYRO_GENERAL_FAULT = 1 << 44
    """The gyroscope failed to initialize. Bit 44. Affects `sensor.ScaledGyro`."""
    GYRO_OVER_RANGE = 1 << 45
    """The angular rate about an axis is near or outside the selected range. Bit 45. Affects
    `sensor.ScaledGyro`.
    """
    GYRO_SELF_TEST_FAIL = 1 << 46
    """The gyroscope self-test failed; the commanded built-in test updates this bit. Bit 46. Affects
    `sensor.ScaledGyro`.
    """
    MAG_GENERAL_FAULT = 1 << 48
    """The magnetometer failed to initialize. Bit 48. Affects `sensor.ScaledMag`."""
    MAG_OVER_RANGE = 1 << 49
    """The magnetic field along an axis is near or outside the supported range. Bit 49. Affects
    `sensor.ScaledMag`.
    """
    MAG_SELF_TEST_FAIL = 1 << 50
    """The magnetometer self-test failed; the commanded built-in test updates this bit. Bit 50.
    Affects `sensor.ScaledMag`.
    """
    PRESSURE_SENSOR_GENERAL_FAULT = 1 << 52
    """The pressure sensor failed to initialize. Bit 52. Affects `sensor.ScaledPressure`."""
    PRESSURE_SENSOR_OVER_RANGE = 1 << 53
    """The pressure is outside the supported range. Bit 53. Affects `sensor.ScaledPressure`."""
    PRESSURE_SENSOR_SELF_TEST_FAIL = 1 << 54
    """The pressure sensor self-test failed; the commanded built-in test updates this bit. Bit 54.
    Affects `sensor.ScaledPressure`.
    """
    FACTORY_BITS_INVALID = 1 << 56
    """The device has lost its factory configuration. Bit 56."""
    FILTER_TIMING_OVERRUN = 1 << 66
    """Filter processes take longer than their time slot. Bit 66."""
    FILTER_TIMING_UNDERRUN = 1 << 67
    """Filter processes are skipped. Bit 67."""
    RECEIVER_1_FAULT = 1 << 105
    """No communication with internal receiver 1. Bit 105. Affects `gnss_data.FixInfo`."""
    RECEIVER_1_NO_SOLUTION = 1 << 108
    """Internal receiver 1 has no valid solution; usually for lack of a sky view. Bit 108. Affects
    `gnss_data.FixInfo`.
    """
    RECEIVER_2_FAULT = 1 << 110
    """No communication with internal receiver 2. Bit 110. Affects `gnss_data.FixInfo`."""
    RECEIVER_2_NO_SOLUTION = 1 << 113
    """Internal receiver 2 has no valid solution; usually for lack of a sky view. Bit 113. Affects
    `gnss_data.FixInfo`.
    """


@codec.open_flag(128)
class Cv7InertialContinuousBuiltInTest(IntFlag):
    """Flags of the continuous built-in test of devices of generation 7 without a GNSS receiver:
    bits 0-31 system, 32-63 inertial sensors, 64-95 navigation. Uncertain: The sources list only the
    numbers and names of the bits; the descriptions are those of the 3DM-CV7-GNSS/INS where the
    names are the same.

    - ros-driver: Built-in test of the CV7
    - mscl: Continuous built-in test
    """

    SYSTEM_CLOCK_FAILURE = 1 << 0
    """The system clock does not work properly. Bit 0."""
    POWER_FAULT = 1 << 1
    """The supply voltage is out of range, or an internal supply has failed. Bit 1."""
    FIRMWARE_FAULT = 1 << 4
    """The firmware encountered an unexpected condition. Bit 4."""
    TIMING_OVERLOAD = 1 << 5
    """The processor cannot keep up. Bit 5."""
    BUFFER_OVERRUN = 1 << 6
    """A data buffer was full and data may be lost. Bit 6."""
    IMU_PROCESS_FAULT = 1 << 16
    """The inertial sensor subsystem is not running or did not start. Bit 16."""
    IMU_DATA_RATE_MISMATCH = 1 << 17
    """Sensor data is not produced at its base rate. Bit 17."""
    IMU_OVERRUN_DROPPED_DATA = 1 << 18
    """Sensor data was dropped. Bit 18."""
    IMU_STUCK = 1 << 19
    """The inertial sensor process is stuck. Bit 19."""
    FILTER_PROCESS_FAULT = 1 << 20
    """The filter process failed. Bit 20."""
    FILTER_DROPPED_DATA = 1 << 21
    """The filter dropped data. Bit 21."""
    FILTER_RATE_MISMATCH = 1 << 22
    """Filter data is not produced at its base rate. Bit 22."""
    FILTER_STUCK = 1 << 23
    """The filter process is stuck. Bit 23."""
    IMU_CLOCK_FAULT = 1 << 32
    """The inertial sensor clock failed. Bit 32."""
    IMU_COMM_FAULT = 1 << 33
    """No communication with the inertial sensors. Bit 33."""
    IMU_TIMING_OVERRUN = 1 << 34
    """Inertial sensor processes take longer than their time slot. Bit 34."""
    IMU_CALIBRATION_ERROR_ACCEL = 1 << 36
    """Accelerometer calibration fault. Bit 36. Affects `sensor.ScaledAccel`."""
    IMU_CALIBRATION_ERROR_GYRO = 1 << 37
    """Gyroscope calibration fault. Bit 37. Affects `sensor.ScaledGyro`."""
    IMU_CALIBRATION_ERROR_MAG = 1 << 38
    """Magnetometer calibration fault. Bit 38. Affects `sensor.ScaledMag`."""
    ACCEL_GENERAL_FAULT = 1 << 40
    """The accelerometer failed to initialize. Bit 40. Affects `sensor.ScaledAccel`."""
    ACCEL_OVER_RANGE = 1 << 41
    """The acceleration along an axis is near or outside the selected range. Bit 41. Affects
    `sensor.ScaledAccel`.
    """
    ACCEL_SELF_TEST_FAIL = 1 << 42
    """The accelerometer self-test failed; the commanded built-in test updates this bit. Bit 42.
    Affects `sensor.ScaledAccel`.
    """
    GYRO_GENERAL_FAULT = 1 << 44
    """The gyroscope failed to initialize. Bit 44. Affects `sensor.ScaledGyro`."""
    GYRO_OVER_RANGE = 1 << 45
    """The angular rate about an axis is near or outside the selected range. Bit 45. Affects
    `sensor.ScaledGyro`.
    """
    GYRO_SELF_TEST_FAIL = 1 << 46
    """The gyroscope self-test failed; the commanded built-in test updates this bit. Bit 46. Affects
    `sensor.ScaledGyro`.
    """
    MAG_GENERAL_FAULT = 1 << 48
    """The magnetometer failed to initialize. Bit 48. Affects `sensor.ScaledMag`."""
    MAG_OVER_RANGE = 1 << 49
    """The magnetic field along an axis is near or outside the supported range. Bit 49. Affects
    `sensor.ScaledMag`.
    """
    MAG_SELF_TEST_FAIL = 1 << 50
    """The magnetometer self-test failed; the commanded built-in test updates this bit. Bit 50.
    Affects `sensor.ScaledMag`.
    """
    PRESSURE_SENSOR_GENERAL_FAULT = 1 << 52
    """The pressure sensor failed to initialize. Bit 52. Affects `sensor.ScaledPressure`."""
    PRESSURE_SENSOR_OVER_RANGE = 1 << 53
    """The pressure is outside the supported range. Bit 53. Affects `sensor.ScaledPressure`."""
    PRESSURE_SENSOR_SELF_TEST_FAIL = 1 << 54
    """The pressure sensor self-test failed; the commanded built-in test updates this bit. Bit 54.
    Affects `sensor.ScaledPressure`.
    """
    FACTORY_BITS_INVALID = 1 << 56
    """The device has lost its factory configuration. Bit 56."""
    FILTER_FAULT = 1 << 64
    """The filter does not work normally. Bit 64."""
    FILTER_TIMING_OVERRUN = 1 << 66
    """Filter processes take longer than their time slot. Bit 66."""
    FILTER_TIMING_UNDERRUN = 1 << 67
    """Filter processes are skipped. Bit 67."""


@codec.open_flag(128)
class Gq7ContinuousBuiltInTest(IntFlag):
    """Flags of the continuous built-in test of the 3DM-GQ7: bits 0-31 system, 32-63 inertial
    sensors, 64-95 navigation, 96-127 GNSS. Uncertain: The sources list only the numbers and names
    of the bits; the descriptions are those of the 3DM-CV7-GNSS/INS where the names are the same.

    - ros-driver: Built-in test of the GQ7
    - mscl: Continuous built-in test
    """

    SYSTEM_CLOCK_FAILURE = 1 << 0
    """The system clock does not work properly. Bit 0."""
    POWER_FAULT = 1 << 1
    """The supply voltage is out of range, or an internal supply has failed. Bit 1."""
    FIRMWARE_FAULT = 1 << 4
    """The firmware encountered an unexpected condition. Bit 4."""
    TIMING_OVERLOAD = 1 << 5
    """The processor cannot keep up. Bit 5."""
    BUFFER_OVERRUN = 1 << 6
    """A data buffer was full and data may be lost. Bit 6."""
    IMU_IPC_FAULT = 0xF0000
    """Faults of the link to the inertial sensor processor. Bits 16 to 19."""
    FILTER_IPC_FAULT = 0xF00000
    """Faults of the link to the filter processor. Bits 20 to 23."""
    GNSS_IPC_FAULT = 0xF000000
    """Faults of the link to the GNSS processor. Bits 24 to 27."""
    IMU_CLOCK_FAULT = 1 << 32
    """The inertial sensor clock failed. Bit 32."""
    IMU_COMM_FAULT = 1 << 33
    """No communication with the inertial sensors. Bit 33."""
    IMU_TIMING_OVERRUN = 1 << 34
    """Inertial sensor processes take longer than their time slot. Bit 34."""
    IMU_CALIBRATION_ERROR_ACCEL = 1 << 36
    """Accelerometer calibration fault. Bit 36. Affects `sensor.ScaledAccel`."""
    IMU_CALIBRATION_ERROR_GYRO = 1 << 37
    """Gyroscope calibration fault. Bit 37. Affects `sensor.ScaledGyro`."""
    IMU_CALIBRATION_ERROR_MAG = 1 << 38
    """Magnetometer calibration fault. Bit 38. Affects `sensor.ScaledMag`."""
    ACCEL_GENERAL_FAULT = 1 << 40
    """The accelerometer failed to initialize. Bit 40. Affects `sensor.ScaledAccel`."""
    ACCEL_OVER_RANGE = 1 << 41
    """The acceleration along an axis is near or outside the selected range. Bit 41. Affects
    `sensor.ScaledAccel`.
    """
    ACCEL_SELF_TEST_FAIL = 1 << 42
    """The accelerometer self-test failed; the commanded built-in test updates this bit. Bit 42.
    Affects `sensor.ScaledAccel`.
    """
    GYRO_GENERAL_FAULT = 1 << 44
    """The gyroscope failed to initialize. Bit 44. Affects `sensor.ScaledGyro`."""
    GYRO_OVER_RANGE = 1 << 45
    """The angular rate about an axis is near or outside the selected range. Bit 45. Affects
    `sensor.ScaledGyro`.
    """
    GYRO_SELF_TEST_FAIL = 1 << 46
    """The gyroscope self-test failed; the commanded built-in test updates this bit. Bit 46. Affects
    `sensor.ScaledGyro`.
    """
    MAG_GENERAL_FAULT = 1 << 48
    """The magnetometer failed to initialize. Bit 48. Affects `sensor.ScaledMag`."""
    MAG_OVER_RANGE = 1 << 49
    """The magnetic field along an axis is near or outside the supported range. Bit 49. Affects
    `sensor.ScaledMag`.
    """
    MAG_SELF_TEST_FAIL = 1 << 50
    """The magnetometer self-test failed; the commanded built-in test updates this bit. Bit 50.
    Affects `sensor.ScaledMag`.
    """
    PRESSURE_SENSOR_GENERAL_FAULT = 1 << 52
    """The pressure sensor failed to initialize. Bit 52. Affects `sensor.ScaledPressure`."""
    PRESSURE_SENSOR_OVER_RANGE = 1 << 53
    """The pressure is outside the supported range. Bit 53. Affects `sensor.ScaledPressure`."""
    PRESSURE_SENSOR_SELF_TEST_FAIL = 1 << 54
    """The pressure sensor self-test failed; the commanded built-in test updates this bit. Bit 54.
    Affects `sensor.ScaledPressure`.
    """
    FILTER_CLOCK_FAULT = 1 << 64
    """The filter clock failed. Bit 64."""
    FILTER_HARDWARE_FAULT = 1 << 65
    """Filter processor fault. Bit 65."""
    FILTER_TIMING_OVERRUN = 1 << 66
    """Filter processes take longer than their time slot. Bit 66."""
    FILTER_TIMING_UNDERRUN = 1 << 67
    """Filter processes are skipped. Bit 67."""
    FILTER_COMM_ERROR = 0xF00000000000000000
    """Filter communication errors. Bits 68 to 71."""
    GNSS_CLOCK_FAULT = 1 << 96
    """The GNSS processor clock failed. Bit 96."""
    GNSS_HARDWARE_FAULT = 1 << 97
    """GNSS processor fault. Bit 97."""
    GNSS_COMM_ERROR = 0x1C000000000000000000000000
    """GNSS processor communication errors. Bits 98 to 100."""
    GPS_TIME_FAULT = 1 << 101
    """GPS time fault. Bit 101. Affects `gnss_data.GpsTime`."""
    GNSS_TIMING_OVERRUN = 1 << 102
    """A GNSS processor cycle exceeded its time slot. Bit 102."""
    RECEIVER_1_POWER_FAULT = 1 << 104
    """Receiver 1 power supply fault. Bit 104. Affects `gnss_data.FixInfo`."""
    RECEIVER_1_FAULT = 1 << 105
    """No communication with internal receiver 1. Bit 105. Affects `gnss_data.FixInfo`."""
    ANTENNA_1_SHORTED = 1 << 106
    """Antenna 1 is shorted. Bit 106. Affects `gnss_data.HardwareStatus`."""
    ANTENNA_1_OPEN = 1 << 107
    """Antenna 1 is not connected. Bit 107. Affects `gnss_data.HardwareStatus`."""
    RECEIVER_1_SOLUTION_FAULT = 1 << 108
    """Receiver 1 has no solution. Bit 108. Affects `gnss_data.FixInfo`."""
    RECEIVER_2_POWER_FAULT = 1 << 109
    """Receiver 2 power supply fault. Bit 109. Affects `gnss_data.FixInfo`."""
    RECEIVER_2_FAULT = 1 << 110
    """No communication with internal receiver 2. Bit 110. Affects `gnss_data.FixInfo`."""
    ANTENNA_2_SHORTED = 1 << 111
    """Antenna 2 is shorted. Bit 111. Affects `gnss_data.HardwareStatus`."""
    ANTENNA_2_OPEN = 1 << 112
    """Antenna 2 is not connected. Bit 112. Affects `gnss_data.HardwareStatus`."""
    RECEIVER_2_SOLUTION_FAULT = 1 << 113
    """Receiver 2 has no solution. Bit 113. Affects `gnss_data.FixInfo`."""
    RTCM_COMM_FAULT = 1 << 114
    """RTCM communication fault. Bit 114. Affects `gnss_data.RtkCorrectionsStatus`."""
    RTK_DONGLE_FAULT = 1 << 115
    """RTK modem fault. Bit 115. Affects `rtk.GetStatusFlags`."""

    @property
    def imu_ipc_fault(self) -> int:
        """Bits 16 to 19 as a number."""
        return int((self >> 16) & 0xF)

    def with_imu_ipc_fault(self, value: int) -> Gq7ContinuousBuiltInTest:
        """Returns a copy with bits 16 to 19 set to a number."""
        value = codec.fits("imu_ipc_fault", value, 4)
        return Gq7ContinuousBuiltInTest(int(self) & ~0xF0000 | value << 16)

    @property
    def filter_ipc_fault(self) -> int:
        """Bits 20 to 23 as a number."""
        return int((self >> 20) & 0xF)

    def with_filter_ipc_fault(self, value: int) -> Gq7ContinuousBuiltInTest:
        """Returns a copy with bits 20 to 23 set to a number."""
        value = codec.fits("filter_ipc_fault", value, 4)
        return Gq7ContinuousBuiltInTest(int(self) & ~0xF00000 | value << 20)

    @property
    def gnss_ipc_fault(self) -> int:
        """Bits 24 to 27 as a number."""
        return int((self >> 24) & 0xF)

    def with_gnss_ipc_fault(self, value: int) -> Gq7ContinuousBuiltInTest:
        """Returns a copy with bits 24 to 27 set to a number."""
        value = codec.fits("gnss_ipc_fault", value, 4)
        return Gq7ContinuousBuiltInTest(int(self) & ~0xF000000 | value << 24)

    @property
    def filter_comm_error(self) -> int:
        """Bits 68 to 71 as a number."""
        return int((self >> 68) & 0xF)

    def with_filter_comm_error(self, value: int) -> Gq7ContinuousBuiltInTest:
        """Returns a copy with bits 68 to 71 set to a number."""
        value = codec.fits("filter_comm_error", value, 4)
        return Gq7ContinuousBuiltInTest(int(self) & ~0xF00000000000000000 | value << 68)

    @property
    def gnss_comm_error(self) -> int:
        """Bits 98 to 100 as a number."""
        return int((self >> 98) & 0x7)

    def with_gnss_comm_error(self, value: int) -> Gq7ContinuousBuiltInTest:
        """Returns a copy with bits 98 to 100 set to a number."""
        value = codec.fits("gnss_comm_error", value, 3)
        return Gq7ContinuousBuiltInTest(int(self) & ~0x1C000000000000000000000000 | value << 98)


class EventTriggerType(codec.OpenEnum):
    """Kind of an event trigger.

    - 3dm-cv7-gnss-ins: Event Trigger Configuration (0x0C,0x2E)
    - 3dm-cv7-gnss-ins: Types of triggers
    """

    NONE = 0
    """The instance is not in use: it is never active and cannot be enabled."""
    GPIO = 1
    """Watches a GPIO pin."""
    THRESHOLD = 2
    """Compares one value of a data field with thresholds."""
    COMBINATION = 3
    """Combines up to four other triggers in a truth table."""


class EventActionType(codec.OpenEnum):
    """Kind of an event action.

    - 3dm-cv7-gnss-ins: Event Action Configuration (0x0C,0x2F)
    - 3dm-cv7-gnss-ins: Types of actions
    """

    NONE = 0
    """The instance is not in use."""
    GPIO = 1
    """Controls a GPIO pin."""
    MESSAGE = 2
    """Sends a data packet."""


class EventTriggerMode(codec.OpenEnum):
    """Operating mode of an event trigger.

    - 3dm-cv7-gnss-ins: Event Control (0x0C,0x2B)
    - 3dm-cv7-gnss-ins: Enabling & Disabling Triggers
    """

    DISABLED = 0
    """The trigger is never active. Configuring a trigger sets this mode."""
    ENABLED = 1
    """The trigger works as configured."""
    TEST = 2
    """The trigger is active all the time."""
    TEST_PULSE = 3
    """The trigger is active for one event cycle and then returns to its previous mode."""


@codec.open_flag(8)
class EventTriggerStatus(IntFlag):
    """State of an event trigger.

    - 3dm-cv7-gnss-ins: Get Event Trigger Status (0x0C,0x2C)
    """

    ACTIVE = 1 << 0
    """The trigger is active, because of its condition or a test mode. Bit 0."""
    ENABLED = 1 << 1
    """The trigger is enabled. Bit 1."""
    TEST = 1 << 2
    """The trigger is in a test mode. Bit 2."""


class EventTriggerGpioMode(codec.OpenEnum):
    """Condition of a GPIO pin that activates a trigger.

    - 3dm-cv7-gnss-ins: Event Trigger Configuration (0x0C,0x2E)
    - 3dm-cv7-gnss-ins: Trigger: GPIO
    """

    DISABLED = 0
    """The trigger is never active."""
    WHILE_HIGH = 1
    """Active while the pin is high. The pin needs the gpio feature."""
    WHILE_LOW = 2
    """Active while the pin is low. The pin needs the gpio feature."""
    EDGE = 4
    """Active for one event cycle after an edge. Each edge is a new activation, but actions run once
    per cycle: of several edges in one cycle, only one has an effect. The pin needs the timestamp
    feature, whose behavior selects the edge.
    """


class EventThresholdType(codec.OpenEnum):
    """Comparison of a threshold trigger.

    - 3dm-cv7-gnss-ins: ThresholdParams
    """

    WINDOW = 1
    """The value is in a window between two thresholds, or outside of it."""
    INTERVAL = 2
    """The remainder of the value divided by an interval is at most a threshold."""


class EventActionGpioMode(codec.OpenEnum):
    """Control of a GPIO pin by an action.

    - 3dm-cv7-gnss-ins: Event Action Configuration (0x0C,0x2F)
    - 3dm-cv7-gnss-ins: Action: GPIO
    """

    DISABLED = 0
    """The pin is not changed."""
    ACTIVE_HIGH = 1
    """High while the trigger is active and low otherwise."""
    ACTIVE_LOW = 2
    """Low while the trigger is active and high otherwise."""
    ONESHOT_HIGH = 5
    """Set high at each activation and never set low."""
    ONESHOT_LOW = 6
    """Set low at each activation and never set high."""
    TOGGLE = 7
    """The pin is inverted each time the trigger activates."""


class EventTriggerGpio(Structure):
    """A trigger on a GPIO pin.

    - 3dm-cv7-gnss-ins: Event Trigger Configuration (0x0C,0x2E)
    """

    __slots__ = ("pin", "mode")
    __match_args__ = ("pin", "mode")

    _SIZE = 2

    pin: int
    """GPIO pin, counted from 1. Range: at least 1."""
    mode: EventTriggerGpioMode
    """Condition of the pin that activates the trigger."""

    def __init__(self, pin: int, mode: EventTriggerGpioMode) -> None:
        self.pin = pin
        self.mode = mode

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2B.unpack(raw, at)
        self.pin = v[0]
        self.mode = codec.KNOWN[EventTriggerGpioMode][v[1]]
        return at + 2

    def _write(self) -> bytes:
        return _2B.write("pin mode", self.pin, self.mode)


class EventThresholdWindow(Structure):
    """Two thresholds with a window between them.

    - 3dm-cv7-gnss-ins: ThresholdParams
    - mip-sdk-4: Event Trigger (0x0C,0x2E)
    """

    __slots__ = ("low_threshold", "high_threshold")
    __match_args__ = ("low_threshold", "high_threshold")

    _SIZE = 16

    low_threshold: float
    """Lower threshold, in the unit of the watched value. The SDK calls it the first threshold."""
    high_threshold: float
    """Upper threshold, in the unit of the watched value. The trigger is active from the lower
    threshold to the upper one, both included. If the upper one is below the lower one, it is active
    below the upper and above the lower one, both excluded. The SDK calls it the second threshold.
    """

    def __init__(self, low_threshold: float, high_threshold: float) -> None:
        self.low_threshold = low_threshold
        self.high_threshold = high_threshold

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.low_threshold, self.high_threshold = _2d.unpack(raw, at)
        return at + 16

    def _write(self) -> bytes:
        return _2d.write("low_threshold high_threshold", self.low_threshold, self.high_threshold)


class EventThresholdInterval(Structure):
    """A threshold inside a repeating interval.

    - 3dm-cv7-gnss-ins: ThresholdParams
    - mip-sdk-4: Event Trigger (0x0C,0x2E)
    """

    __slots__ = ("interval_threshold", "interval")
    __match_args__ = ("interval_threshold", "interval")

    _SIZE = 16

    interval_threshold: float
    """The trigger is active while the remainder is at most this, in the unit of the watched value.
    The SDK calls it the first threshold.
    """
    interval: float
    """Divisor of the remainder, in the unit of the watched value. If it is below the threshold, the
    two swap roles: the trigger is active while the value modulo `interval_threshold` is above this.
    The SDK calls it the second threshold.
    """

    def __init__(self, interval_threshold: float, interval: float) -> None:
        self.interval_threshold = interval_threshold
        self.interval = interval

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.interval_threshold, self.interval = _2d.unpack(raw, at)
        return at + 16

    def _write(self) -> bytes:
        return _2d.write("interval_threshold interval", self.interval_threshold, self.interval)


class EventTriggerThreshold(Structure):
    """A trigger on one value of a data field. The value is converted to double before it is
    compared.

    - 3dm-cv7-gnss-ins: ThresholdParams
    """

    __slots__ = ("descriptor_set", "field_descriptor", "parameter_id", "type", "thresholds")
    __match_args__ = ("descriptor_set", "field_descriptor", "parameter_id", "type", "thresholds")

    descriptor_set: int
    """Data descriptor set of the watched value."""
    field_descriptor: int
    """Field descriptor of the watched value. Refers to fields of `descriptor_set`."""
    parameter_id: int
    """Number of the value in its field, counted from 1; each element of a vector counts. Range: at
    least 1.
    """
    type: EventThresholdType
    """Kind of comparison."""
    thresholds: EventThresholdWindow | EventThresholdInterval | None
    """Thresholds of the comparison. Selected by `type`.

    - If `type` is `EventThresholdType.WINDOW`: `EventThresholdWindow`.
    - If `type` is `EventThresholdType.INTERVAL`: `EventThresholdInterval`.
    """

    def __init__(
        self,
        descriptor_set: int,
        field_descriptor: int,
        parameter_id: int,
        type: EventThresholdType,
        thresholds: EventThresholdWindow | EventThresholdInterval | None = None,
    ) -> None:
        self.descriptor_set = descriptor_set
        self.field_descriptor = field_descriptor
        self.parameter_id = parameter_id
        self.type = type
        self.thresholds = thresholds

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _4B.read(raw, at)
        self.descriptor_set = v[0]
        self.field_descriptor = v[1]
        self.parameter_id = v[2]
        self.type = codec.KNOWN[EventThresholdType][v[3]]
        at += 4
        self.thresholds = None
        if self.type == 1:
            self.thresholds, at = EventThresholdWindow._decoded(raw, at)
        if self.type == 2:
            self.thresholds, at = EventThresholdInterval._decoded(raw, at)
        return at

    def _write(self) -> bytes:
        out = _4B.write(
            "descriptor_set field_descriptor parameter_id type",
            self.descriptor_set,
            self.field_descriptor,
            self.parameter_id,
            self.type,
        )
        if self.type == 1:
            codec.check_selected("thresholds", self.thresholds, self.type, EventThresholdWindow)
            out += codec.structure("thresholds", self.thresholds, EventThresholdWindow)
        elif self.type == 2:
            codec.check_selected("thresholds", self.thresholds, self.type, EventThresholdInterval)
            out += codec.structure("thresholds", self.thresholds, EventThresholdInterval)
        else:
            codec.check_unselected("thresholds", self.thresholds, self.type)
        return out


class EventTriggerCombination(Structure):
    """A trigger that combines up to four others.

    - 3dm-cv7-gnss-ins: CombinationParams
    - 3dm-cv7-gnss-ins: Logical Truth Table
    """

    __slots__ = ("logic_table", "input_triggers")
    __match_args__ = ("logic_table", "input_triggers")

    _SIZE = 6

    logic_table: int
    """Bit n is the output for n = a + 2b + 4c + 8d, where a to d are the states (0 or 1) of the
    four inputs.
    """
    input_triggers: tuple[int, int, int, int]
    """Trigger instances for the inputs a to d; 0 is always inactive. An input may be the trigger
    itself; its value is then the output of the previous event cycle.
    """

    def __init__(self, logic_table: int, input_triggers: Sequence[int]) -> None:
        self.logic_table = logic_table
        self.input_triggers = codec.several(input_triggers)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _H4B.unpack(raw, at)
        self.logic_table = v[0]
        self.input_triggers = v[1:5]
        return at + 6

    def _write(self) -> bytes:
        return _H4B.write(
            "logic_table input_triggers*4",
            self.logic_table,
            *codec.exactly("input_triggers", self.input_triggers, 4),
        )


class EventActionGpio(Structure):
    """An action on a GPIO pin, which needs the gpio feature and an output behavior.

    - 3dm-cv7-gnss-ins: GpioParams
    """

    __slots__ = ("pin", "mode")
    __match_args__ = ("pin", "mode")

    _SIZE = 2

    pin: int
    """GPIO pin, counted from 1. Range: at least 1."""
    mode: EventActionGpioMode
    """Pin level or pulse that the action generates."""

    def __init__(self, pin: int, mode: EventActionGpioMode) -> None:
        self.pin = pin
        self.mode = mode

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2B.unpack(raw, at)
        self.pin = v[0]
        self.mode = codec.KNOWN[EventActionGpioMode][v[1]]
        return at + 2

    def _write(self) -> bytes:
        return _2B.write("pin mode", self.pin, self.mode)


class EventActionMessage(Structure):
    """An action that sends data packets.

    - 3dm-cv7-gnss-ins: MessageParams
    """

    __slots__ = ("descriptor_set", "decimation", "descriptors")
    __match_args__ = ("descriptor_set", "decimation", "descriptors")

    descriptor_set: int
    """Data descriptor set of the packet."""
    decimation: int
    """0 sends one packet per activation. Any other value streams while the trigger is active, at
    the base rate of the descriptor set divided by this value. At each activation, a packet is sent
    immediately and the count restarts.
    """
    # On the wire only: num_fields. Number of fields in the packet. Counts the elements of
    # `descriptors`. Range: 0 to 12.
    descriptors: tuple[int, ...]
    """Field descriptors, in order. Refers to fields of `descriptor_set`."""

    def __init__(self, descriptor_set: int, decimation: int, descriptors: Sequence[int]) -> None:
        self.descriptor_set = descriptor_set
        self.decimation = decimation
        self.descriptors = codec.several(descriptors)

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _BHB.read(raw, at)
        self.descriptor_set = v[0]
        self.decimation = v[1]
        n_num_fields = v[2]
        at += 4
        n = codec.counted(raw, at, n_num_fields, 1, 249)
        self.descriptors = codec.read_numbers("B", raw, at, n)
        at += n
        return at

    def _write(self) -> bytes:
        out = _BHB.write(
            "descriptor_set decimation num_fields",
            self.descriptor_set,
            self.decimation,
            codec.count("descriptors", self.descriptors, 249),
        )
        out += codec.write_numbers(
            "descriptors", "B", codec.at_most("descriptors", self.descriptors, 249)
        )
        return out


class GnssConstellation(codec.OpenEnum):
    """Satellite constellation. QZSS has no value.

    - 3dm-cv7-gnss-ins: Satellite Status (0x91,0x20)
    - 3dm-cv7-gnss-ins: Raw (0x91,0x22)
    """

    UNKNOWN = 0
    """Not known."""
    GPS = 1
    GLONASS = 2
    GALILEO = 3
    BEIDOU = 4
    SBAS = 5
    """Satellites of augmentation systems (SBAS)."""


class GnssFixType(codec.OpenEnum):
    """Type of a GNSS position fix.

    - 3dm-cv7-gnss-ins: Fix Info (0x91,0x0B)
    """

    FIX_3D = 0
    """Fix in three dimensions."""
    FIX_2D = 1
    """Fix in two dimensions."""
    FIX_TIME_ONLY = 2
    """The receiver computes the time, but no position."""
    FIX_NONE = 3
    """No fix."""
    FIX_INVALID = 4
    """The fix is not valid."""
    FIX_RTK_FLOAT = 5
    """RTK fix with float ambiguities."""
    FIX_RTK_FIXED = 6
    """RTK fix with integer ambiguities."""
    FIX_DIFFERENTIAL = 7
    """The position uses differential corrections."""


class GnssSignal(codec.OpenEnum):
    """Signal of a satellite.

    - 3dm-cv7-gnss-ins: Raw (0x91,0x22)
    """

    UNKNOWN = 0
    """Not known."""
    GPS_L1CA = 1
    """GPS L1 C/A."""
    GPS_L1P = 2
    """GPS L1 P(Y)."""
    GPS_L1Z = 3
    """GPS L1 P(Y) by Z-tracking."""
    GPS_L2CA = 4
    """GPS L2 C/A."""
    GPS_L2P = 5
    """GPS L2 P(Y)."""
    GPS_L2Z = 6
    """GPS L2 P(Y) by Z-tracking."""
    GPS_L2CL = 7
    """GPS L2C(L)."""
    GPS_L2CM = 8
    """GPS L2C(M)."""
    GPS_L2CML = 9
    """GPS L2C(M+L)."""
    GPS_L5I = 10
    """GPS L5 I."""
    GPS_L5Q = 11
    """GPS L5 Q."""
    GPS_L5IQ = 12
    """GPS L5 I+Q."""
    GPS_L1CD = 13
    """GPS L1C(D)."""
    GPS_L1CP = 14
    """GPS L1C(P)."""
    GPS_L1CDP = 15
    """GPS L1C(D+P)."""
    GLONASS_G1CA = 32
    """GLONASS G1 C/A."""
    GLONASS_G1P = 33
    """GLONASS G1 P."""
    GLONASS_G2C = 34
    """GLONASS G2 C/A."""
    GLONASS_G2P = 35
    """GLONASS G2 P."""
    GALILEO_E1C = 64
    """Galileo E1 C."""
    GALILEO_E1A = 65
    """Galileo E1 A."""
    GALILEO_E1B = 66
    """Galileo E1 B."""
    GALILEO_E1BC = 67
    """Galileo E1 B+C."""
    GALILEO_E1ABC = 68
    """Galileo E1 A+B+C."""
    GALILEO_E6C = 69
    """Galileo E6 C."""
    GALILEO_E6A = 70
    """Galileo E6 A."""
    GALILEO_E6B = 71
    """Galileo E6 B."""
    GALILEO_E6BC = 72
    """Galileo E6 B+C."""
    GALILEO_E6ABC = 73
    """Galileo E6 A+B+C."""
    GALILEO_E5BI = 74
    """Galileo E5b I."""
    GALILEO_E5BQ = 75
    """Galileo E5b Q."""
    GALILEO_E5BIQ = 76
    """Galileo E5b I+Q."""
    GALILEO_E5ABI = 77
    """Galileo E5 (a+b) I."""
    GALILEO_E5ABQ = 78
    """Galileo E5 (a+b) Q."""
    GALILEO_E5ABIQ = 79
    """Galileo E5 (a+b) I+Q."""
    GALILEO_E5AI = 80
    """Galileo E5a I."""
    GALILEO_E5AQ = 81
    """Galileo E5a Q."""
    GALILEO_E5AIQ = 82
    """Galileo E5a I+Q."""
    SBAS_L1CA = 96
    """SBAS L1 C/A."""
    SBAS_L5I = 97
    """SBAS L5 I."""
    SBAS_L5Q = 98
    """SBAS L5 Q."""
    SBAS_L5IQ = 99
    """SBAS L5 I+Q."""
    QZSS_L1CA = 128
    """QZSS L1 C/A."""
    QZSS_LEXS = 129
    """QZSS LEX S."""
    QZSS_LEXL = 130
    """QZSS LEX L."""
    QZSS_LEXSL = 131
    """QZSS LEX S+L."""
    QZSS_L2CM = 132
    """QZSS L2C(M)."""
    QZSS_L2CL = 133
    """QZSS L2C(L)."""
    QZSS_L2CML = 134
    """QZSS L2C(M+L)."""
    QZSS_L5I = 135
    """QZSS L5 I."""
    QZSS_L5Q = 136
    """QZSS L5 Q."""
    QZSS_L5IQ = 137
    """QZSS L5 I+Q."""
    QZSS_L1CD = 138
    """QZSS L1C(D)."""
    QZSS_L1CP = 139
    """QZSS L1C(P)."""
    QZSS_L1CDP = 140
    """QZSS L1C(D+P)."""
    BEIDOU_B1I = 160
    """BeiDou B1 I."""
    BEIDOU_B1Q = 161
    """BeiDou B1 Q."""
    BEIDOU_B1IQ = 162
    """BeiDou B1 I+Q."""
    BEIDOU_B3I = 163
    """BeiDou B3 I."""
    BEIDOU_B3Q = 164
    """BeiDou B3 Q."""
    BEIDOU_B3IQ = 165
    """BeiDou B3 I+Q."""
    BEIDOU_B2I = 166
    """BeiDou B2 I."""
    BEIDOU_B2Q = 167
    """BeiDou B2 Q."""
    BEIDOU_B2IQ = 168
    """BeiDou B2 I+Q."""
    BEIDOU_B2A = 169


class GpioFeature(codec.OpenEnum):
    """Use of a GPIO pin.

    - 3dm-cv7-gnss-ins: GPIO Configuration (0x0C,0x41)
    - 3dm-cv7-gnss-ins: GPIO Features
    """

    UNUSED = 0
    """Not connected. Reading the pin may work but is not guaranteed."""
    GPIO = 1
    """General input or output."""
    PPS = 2
    """Input or output of the pulse per second."""
    ENCODER = 3
    """Input of a motor encoder or odometer."""
    TIMESTAMP = 4
    """Input whose edges get precise timestamps for event triggers."""
    UART = 5
    """Data or control line of a UART."""


class GpioUnusedBehavior(codec.OpenEnum):
    """Behavior of a pin whose feature is unused."""

    UNUSED = 0
    """No other value is defined."""


class GpioBehavior(codec.OpenEnum):
    """Behavior of a pin whose feature is gpio."""

    INPUT = 1
    """Input; the default."""
    OUTPUT_LOW = 2
    """Output, initially low; also low at power-up if the configuration is saved."""
    OUTPUT_HIGH = 3
    """Output, initially high; also high at power-up if the configuration is saved."""


class GpioPpsBehavior(codec.OpenEnum):
    """Behavior of a pin whose feature is pps."""

    INPUT = 1
    """The pin receives the pulse; the PPS source must be gpio. At most one pin."""
    OUTPUT = 2
    """The pin sends the pulse of the device."""


class GpioEncoderBehavior(codec.OpenEnum):
    """Behavior of a pin whose feature is encoder."""

    A = 1
    """Quadrature input A. At most one pin; the last one configured takes precedence."""
    B = 2
    """Quadrature input B. At most one pin; the last one configured takes precedence."""


class GpioTimestampBehavior(codec.OpenEnum):
    """Behavior of a pin whose feature is timestamp."""

    RISING = 1
    """Rising edges get timestamps."""
    FALLING = 2
    """Falling edges get timestamps."""
    EITHER = 3
    """Both edges get timestamps."""


class GpioUartBehavior(codec.OpenEnum):
    """Behavior of a pin whose feature is uart."""

    PORT_2_TX = 33
    """UART 2 transmits."""
    PORT_2_RX = 34
    """UART 2 receives."""
    PORT_3_TX = 49
    """UART 3 transmits."""
    PORT_3_RX = 50
    """UART 3 receives."""


@codec.open_flag(8)
class GpioPinMode(IntFlag):
    """Electrical options of a GPIO pin. The allowed ones depend on the device, the pin, the feature
    and the behavior.

    - 3dm-cv7-gnss-ins: GPIO Configuration (0x0C,0x41)
    - 3dm-cv7-gnss-ins: Pin Mode
    """

    OPEN_DRAIN = 1 << 0
    """The output drives low or floats. It usually needs a pull-up. Bit 0."""
    PULLDOWN = 1 << 1
    """Internal pull-down resistor; not together with the pull-up. Bit 1."""
    PULLUP = 1 << 2
    """Internal pull-up resistor; not together with the pull-down. May lower the allowed input
    voltage. Bit 2.
    """


class NmeaMessageId(codec.OpenEnum):
    """An NMEA-0183 sentence that a device can send.

    - 3dm-cv7-gnss-ins: Supported Sentences and Talker IDs
    - 3dm-cv7-gnss-ins: PMSRA - Euler Angles
    - 3dm-cv7-gnss-ins: PMSRR - Angular Rate and Acceleration
    """

    GGA = 1
    """GNSS fix, from a GNSS data set or the filter data set."""
    GLL = 2
    """Latitude and longitude, from a GNSS data set or the filter data set."""
    GSV = 3
    """Satellites in view, from a GNSS data set. The constellation determines the talker."""
    RMC = 4
    """Recommended minimum GNSS data, from a GNSS data set or the filter data set."""
    VTG = 5
    """Course and speed over ground, from a GNSS data set or the filter data set."""
    HDT = 6
    """True heading, from a GNSS data set or the filter data set."""
    ZDA = 7
    """Time and date, from a GNSS data set."""
    GST = 8
    """GNSS error statistics, from a GNSS data set or the filter data set."""
    MSRA = 129
    """Proprietary sentence `$PMSRA,hhmmss.ss,roll,pitch,yaw*hh`: UTC time and Euler angles in
    degrees with three decimals. From the filter data set.
    """
    MSRR = 130
    """Proprietary sentence `$PMSRR,hhmmss.ss,ax,ay,az,wx,wy,wz*hh`: UTC time, acceleration in g and
    angular rate in deg/s about the x, y and z axes, with six decimals. From the sensor data set.
    """


class NmeaTalkerId(codec.OpenEnum):
    """The first letters of an NMEA-0183 sentence, which identify its talker.

    - 3dm-cv7-gnss-ins: Supported Sentences and Talker IDs
    """

    IGNORED = 0
    """For sentences whose talker cannot be chosen (GSV and the proprietary ones)."""
    GNSS = 1
    """Talker GN: several constellations."""
    GPS = 2
    """Talker GP: GPS only."""
    GALILEO = 3
    """Talker GA: Galileo only."""
    GLONASS = 4
    """Talker GL: GLONASS only."""


class NmeaMessage(Structure):
    """An NMEA-0183 sentence with its talker, its data source and how often it is sent.

    - 3dm-cv7-gnss-ins: Sources and Talker IDs
    """

    __slots__ = ("message_id", "talker_id", "source_descriptor_set", "decimation")
    __match_args__ = ("message_id", "talker_id", "source_descriptor_set", "decimation")

    _SIZE = 5

    message_id: NmeaMessageId
    """The sentence."""
    talker_id: NmeaTalkerId
    """The talker in the sentence."""
    source_descriptor_set: int
    """Data descriptor set from which the contents are taken."""
    decimation: int
    """Base rate of the source descriptor set divided by the desired rate; a poll ignores it."""

    def __init__(
        self,
        message_id: NmeaMessageId,
        talker_id: NmeaTalkerId,
        source_descriptor_set: int,
        decimation: int,
    ) -> None:
        self.message_id = message_id
        self.talker_id = talker_id
        self.source_descriptor_set = source_descriptor_set
        self.decimation = decimation

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _3BH.unpack(raw, at)
        self.message_id = codec.KNOWN[NmeaMessageId][v[0]]
        self.talker_id = codec.KNOWN[NmeaTalkerId][v[1]]
        self.source_descriptor_set = v[2]
        self.decimation = v[3]
        return at + 5

    def _write(self) -> bytes:
        return _3BH.write(
            "message_id talker_id source_descriptor_set decimation",
            self.message_id,
            self.talker_id,
            self.source_descriptor_set,
            self.decimation,
        )


class CommInterface(codec.OpenEnum):
    """A port of a device.

    - 3dm-cv7-gnss-ins: Ports
    - mip-sdk-4: Interface Control (0x7F,0x02)
    """

    ALL = 0
    """All ports."""
    MAIN = 1
    """The main port: USB while a host has it open (DTR), else the main UART."""
    UART_1 = 17
    """The first port that is a UART or can be one."""
    UART_2 = 18
    """The second UART, on GPIO pins 1 and 2 of the 3DM-CV7 and 3DM-GV7 models."""
    UART_3 = 19
    """The third UART, on GPIO pins 3 and 4 of the 3DM-CV7 models."""
    USB_1 = 33
    """First USB virtual serial port."""
    USB_2 = 34
    """Second USB virtual serial port; on GNSS/INS models, intended for NMEA and RTCM."""


@codec.open_flag(32)
class RtkStatusFlags(IntFlag):
    """State of the modem and of the corrections. If `version` is 0, as sent by modems of the first
    generation, the other bits have no meaning here: read the word as `RtkStatusFlagsLegacy`.
    Uncertain: The SDK states only that the form depends on the model number. Uncertain: Other
    software of the vendor evaluates `version`: 0 is the legacy form, 1 is this one. In the legacy
    form of the SDK the same two bits are `sinr`. Uncertain: The SDK lists only the names, from
    which the descriptions are inferred. The meaning of the values is not known.

    - mip-sdk-4: Get Status Flags (0x0F,0x01)
    """

    MODEM_STATE = 0xF
    """State of the modem. Bits 0 to 3."""
    CONNECTION_TYPE = 0xF0
    """Kind of cellular connection. Bits 4 to 7."""
    RSSI = 0xFF00
    """Received signal strength. Bits 8 to 15. Uncertain: No source states the unit and the sign;
    other software of the vendor treats it as negative.
    """
    SIGNAL_QUALITY = 0xF0000
    """Quality of the modem's radio signal. Bits 16 to 19."""
    TOWER_CHANGE_INDICATOR = 0xF00000
    """Cell tower changes. Bits 20 to 23."""
    NMEA_TIMEOUT = 1 << 24
    """No NMEA was received from the device in time. Bit 24."""
    SERVER_TIMEOUT = 1 << 25
    """The server did not answer in time. Bit 25."""
    CORRECTIONS_TIMEOUT = 1 << 26
    """No corrections were received in time. Bit 26."""
    DEVICE_OUT_OF_RANGE = 1 << 27
    """The device is outside the service area. Bit 27."""
    CORRECTIONS_UNAVAILABLE = 1 << 28
    """There are no corrections. Bit 28."""
    VERSION = 0xC0000000
    """Form of these flags. Bits 30 to 31."""

    @property
    def modem_state(self) -> int:
        """Bits 0 to 3 as a number."""
        return int((self >> 0) & 0xF)

    def with_modem_state(self, value: int) -> RtkStatusFlags:
        """Returns a copy with bits 0 to 3 set to a number."""
        value = codec.fits("modem_state", value, 4)
        return RtkStatusFlags(int(self) & ~0xF | value << 0)

    @property
    def connection_type(self) -> int:
        """Bits 4 to 7 as a number."""
        return int((self >> 4) & 0xF)

    def with_connection_type(self, value: int) -> RtkStatusFlags:
        """Returns a copy with bits 4 to 7 set to a number."""
        value = codec.fits("connection_type", value, 4)
        return RtkStatusFlags(int(self) & ~0xF0 | value << 4)

    @property
    def rssi(self) -> int:
        """Bits 8 to 15 as a number."""
        return int((self >> 8) & 0xFF)

    def with_rssi(self, value: int) -> RtkStatusFlags:
        """Returns a copy with bits 8 to 15 set to a number."""
        value = codec.fits("rssi", value, 8)
        return RtkStatusFlags(int(self) & ~0xFF00 | value << 8)

    @property
    def signal_quality(self) -> int:
        """Bits 16 to 19 as a number."""
        return int((self >> 16) & 0xF)

    def with_signal_quality(self, value: int) -> RtkStatusFlags:
        """Returns a copy with bits 16 to 19 set to a number."""
        value = codec.fits("signal_quality", value, 4)
        return RtkStatusFlags(int(self) & ~0xF0000 | value << 16)

    @property
    def tower_change_indicator(self) -> int:
        """Bits 20 to 23 as a number."""
        return int((self >> 20) & 0xF)

    def with_tower_change_indicator(self, value: int) -> RtkStatusFlags:
        """Returns a copy with bits 20 to 23 set to a number."""
        value = codec.fits("tower_change_indicator", value, 4)
        return RtkStatusFlags(int(self) & ~0xF00000 | value << 20)

    @property
    def version(self) -> int:
        """Bits 30 to 31 as a number."""
        return int((self >> 30) & 0x3)

    def with_version(self, value: int) -> RtkStatusFlags:
        """Returns a copy with bits 30 to 31 set to a number."""
        value = codec.fits("version", value, 2)
        return RtkStatusFlags(int(self) & ~0xC0000000 | value << 30)


@codec.open_flag(32)
class RtkStatusFlagsLegacy(IntFlag):
    """State of the modem and the corrections, in the older layout. Uncertain: The form depends on
    the model; see `RtkStatusFlags`. Uncertain: The SDK calls bits 20-31 reserved, but also puts the
    last four numbers there. Uncertain: The SDK lists only the names, from which the descriptions
    are inferred. The meaning of the values is not known.

    - mip-sdk-4: Get Status Flags (0x0F,0x01)
    """

    CONTROLLER_STATE = 0x7
    """State of the controller. Bits 0 to 2."""
    PLATFORM_STATE = 0xF8
    """State of the platform. Bits 3 to 7."""
    CONTROLLER_STATUS_CODE = 0x700
    """Status code of the controller. Bits 8 to 10."""
    PLATFORM_STATUS_CODE = 0x3800
    """Status code of the platform. Bits 11 to 13."""
    RESET_CODE = 0xC000
    """Reason for the last reset. Bits 14 to 15."""
    SIGNAL_QUALITY = 0xF0000
    """Quality of the modem's radio signal. Bits 16 to 19."""
    RSSI = 0x3F00000
    """Received signal strength. Bits 20 to 25."""
    RSRP = 0xC000000
    """Received power of the reference signal. Bits 26 to 27."""
    RSRQ = 0x30000000
    """Received quality of the reference signal. Bits 28 to 29."""
    SINR = 0xC0000000
    """Signal to interference and noise ratio. Bits 30 to 31."""

    @property
    def controller_state(self) -> int:
        """Bits 0 to 2 as a number."""
        return int((self >> 0) & 0x7)

    def with_controller_state(self, value: int) -> RtkStatusFlagsLegacy:
        """Returns a copy with bits 0 to 2 set to a number."""
        value = codec.fits("controller_state", value, 3)
        return RtkStatusFlagsLegacy(int(self) & ~0x7 | value << 0)

    @property
    def platform_state(self) -> int:
        """Bits 3 to 7 as a number."""
        return int((self >> 3) & 0x1F)

    def with_platform_state(self, value: int) -> RtkStatusFlagsLegacy:
        """Returns a copy with bits 3 to 7 set to a number."""
        value = codec.fits("platform_state", value, 5)
        return RtkStatusFlagsLegacy(int(self) & ~0xF8 | value << 3)

    @property
    def controller_status_code(self) -> int:
        """Bits 8 to 10 as a number."""
        return int((self >> 8) & 0x7)

    def with_controller_status_code(self, value: int) -> RtkStatusFlagsLegacy:
        """Returns a copy with bits 8 to 10 set to a number."""
        value = codec.fits("controller_status_code", value, 3)
        return RtkStatusFlagsLegacy(int(self) & ~0x700 | value << 8)

    @property
    def platform_status_code(self) -> int:
        """Bits 11 to 13 as a number."""
        return int((self >> 11) & 0x7)

    def with_platform_status_code(self, value: int) -> RtkStatusFlagsLegacy:
        """Returns a copy with bits 11 to 13 set to a number."""
        value = codec.fits("platform_status_code", value, 3)
        return RtkStatusFlagsLegacy(int(self) & ~0x3800 | value << 11)

    @property
    def reset_code(self) -> int:
        """Bits 14 to 15 as a number."""
        return int((self >> 14) & 0x3)

    def with_reset_code(self, value: int) -> RtkStatusFlagsLegacy:
        """Returns a copy with bits 14 to 15 set to a number."""
        value = codec.fits("reset_code", value, 2)
        return RtkStatusFlagsLegacy(int(self) & ~0xC000 | value << 14)

    @property
    def signal_quality(self) -> int:
        """Bits 16 to 19 as a number."""
        return int((self >> 16) & 0xF)

    def with_signal_quality(self, value: int) -> RtkStatusFlagsLegacy:
        """Returns a copy with bits 16 to 19 set to a number."""
        value = codec.fits("signal_quality", value, 4)
        return RtkStatusFlagsLegacy(int(self) & ~0xF0000 | value << 16)

    @property
    def rssi(self) -> int:
        """Bits 20 to 25 as a number."""
        return int((self >> 20) & 0x3F)

    def with_rssi(self, value: int) -> RtkStatusFlagsLegacy:
        """Returns a copy with bits 20 to 25 set to a number."""
        value = codec.fits("rssi", value, 6)
        return RtkStatusFlagsLegacy(int(self) & ~0x3F00000 | value << 20)

    @property
    def rsrp(self) -> int:
        """Bits 26 to 27 as a number."""
        return int((self >> 26) & 0x3)

    def with_rsrp(self, value: int) -> RtkStatusFlagsLegacy:
        """Returns a copy with bits 26 to 27 set to a number."""
        value = codec.fits("rsrp", value, 2)
        return RtkStatusFlagsLegacy(int(self) & ~0xC000000 | value << 26)

    @property
    def rsrq(self) -> int:
        """Bits 28 to 29 as a number."""
        return int((self >> 28) & 0x3)

    def with_rsrq(self, value: int) -> RtkStatusFlagsLegacy:
        """Returns a copy with bits 28 to 29 set to a number."""
        value = codec.fits("rsrq", value, 2)
        return RtkStatusFlagsLegacy(int(self) & ~0x30000000 | value << 28)

    @property
    def sinr(self) -> int:
        """Bits 30 to 31 as a number."""
        return int((self >> 30) & 0x3)

    def with_sinr(self, value: int) -> RtkStatusFlagsLegacy:
        """Returns a copy with bits 30 to 31 set to a number."""
        value = codec.fits("sinr", value, 2)
        return RtkStatusFlagsLegacy(int(self) & ~0xC0000000 | value << 30)


class Vector3f(NamedTuple):
    """Three floats. Elements: x, y, z."""

    x: float
    y: float
    z: float


class Vector3d(NamedTuple):
    """Three doubles. Elements: x, y, z."""

    x: float
    y: float
    z: float


class Ned3f(NamedTuple):
    """Three floats in the NED frame. Elements: north, east, down."""

    north: float
    east: float
    down: float


class Ned3d(NamedTuple):
    """Three doubles in the NED frame. Elements: north, east, down."""

    north: float
    east: float
    down: float


class Matrix3f(NamedTuple):
    """Three by three floats in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33."""

    m11: float
    m12: float
    m13: float
    m21: float
    m22: float
    m23: float
    m31: float
    m32: float
    m33: float

    @property
    def rows(self) -> tuple[tuple[float, ...], ...]:
        """The rows of the matrix."""
        return tuple([tuple(self[i : i + 3]) for i in range(0, 9, 3)])

    @overload
    def __getitem__(self, at: SupportsIndex | tuple[int, int]) -> float: ...
    @overload
    def __getitem__(self, at: slice) -> tuple[float, ...]: ...
    def __getitem__(self, at: Any) -> Any:
        """`matrix[row, column]`, counted from 0; with one number, the element of the tuple."""
        return codec.element(self, at, 3)


class Quatf(NamedTuple):
    """A quaternion, scalar part first. Elements: w, x, y, z."""

    w: float
    x: float
    y: float
    z: float


class AckCode(codec.OpenEnum):
    """The result of a command.

    - 3dm-gx5-15: 4.5 Error Codes
    - 3dm-cv7-gnss-ins: Ack/Nack Codes
    """

    OK = 0
    """The command was carried out."""
    UNKNOWN_COMMAND = 1
    """The device does not know the command descriptor."""
    BAD_CHECKSUM = 2
    """A complete packet had a wrong checksum."""
    INVALID_PARAMETER = 3
    """A parameter is out of range, or of the wrong size or type."""
    COMMAND_FAILED = 4
    """The device could not carry out the command."""
    COMMAND_TIMEOUT = 5
    """The command did not finish in time."""
    UNKNOWN_DESCRIPTOR_SET = 6
    """The device does not know the descriptor set."""


class DescriptorRate(Structure):
    """A field of a message format and how often it is sent."""

    __slots__ = ("descriptor", "decimation")
    __match_args__ = ("descriptor", "decimation")

    _SIZE = 3

    descriptor: int
    """Field descriptor."""
    decimation: int
    """Base rate divided by the desired rate. Range: at least 1."""

    def __init__(self, descriptor: int, decimation: int) -> None:
        self.descriptor = descriptor
        self.decimation = decimation

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.descriptor, self.decimation = _BH.unpack(raw, at)
        return at + 3

    def _write(self) -> bytes:
        return _BH.write("descriptor decimation", self.descriptor, self.decimation)


@codec.open_flag(16)
class SensorGpsTimestampFlags(IntFlag):
    """State of the GPS time of sensor data.

    - 3dm-cv7-gnss-ins: GPS Timestamp (0x80,0x12)
    """

    PPS_VALID = 1 << 0
    """The PPS signal is present. Bit 0."""
    TIME_REFRESH = 1 << 1
    """Toggles each time the time is updated. Bit 1."""
    TIME_INITIALIZED = 1 << 2
    """The time has been set at least once. Bit 2."""
    TOW_VALID = 1 << 3
    """The time of week is valid. Bit 3."""
    WEEK_NUMBER_VALID = 1 << 4
    """The week number is valid. Bit 4."""


@codec.open_flag(16)
class Gx5SensorGpsTimestampFlags(IntFlag):
    """State of the GPS time of sensor data on the 3DM-GX5-15, which has no bits for the validity of
    the values.

    - 3dm-gx5-15: 5.1.11 GPS Correlation Timestamp (0x80, 0x12)
    """

    PPS_VALID = 1 << 0
    """The PPS signal is present; without it, the internal clock drives the time. Bit 0."""
    TIME_REFRESH = 1 << 1
    """Toggles each time the time is updated. Bit 1."""
    TIME_INITIALIZED = 1 << 2
    """The time has been set at least once. Bit 2."""
