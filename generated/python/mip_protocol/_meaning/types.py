"""The meaning of the types of `types`."""

from __future__ import annotations

from .. import types
from ..info import BitsInfo, EnumInfo, Info, StructureInfo
from ..parameter import Parameter

# fmt: off

#: Class -> its description.
TYPES: dict[str, Info] = {
    "Gx5BuiltInTest": BitsInfo("gx5_built_in_test", types.Gx5BuiltInTest, concerns={"mag_fault": ("sensor.scaled_mag",), "pressure_sensor_fault": ("sensor.scaled_pressure",), "solution_fault": ("filter.reset",)}),
    "Cv7BuiltInTest": BitsInfo("cv7_built_in_test", types.Cv7BuiltInTest, concerns={"accel_fault": ("sensor.scaled_accel",), "gyro_fault": ("sensor.scaled_gyro",), "mag_fault": ("sensor.scaled_mag",), "pressure_sensor_fault": ("sensor.scaled_pressure",), "filter_solution_fault": ("filter.reset",)}),
    "Cv7ContinuousBuiltInTest": BitsInfo("cv7_continuous_built_in_test", types.Cv7ContinuousBuiltInTest, aliases=("filter_process_fault", "gnss_subsystem_fault"), concerns={"gnss_receiver_1_stall": ("gnss_data.fix_info",), "gnss_receiver_2_stall": ("gnss_data.fix_info",), "imu_calibration_error_accel": ("sensor.scaled_accel",), "imu_calibration_error_gyro": ("sensor.scaled_gyro",), "imu_calibration_error_mag": ("sensor.scaled_mag",), "accel_general_fault": ("sensor.scaled_accel",), "accel_over_range": ("sensor.scaled_accel",), "accel_self_test_fail": ("sensor.scaled_accel",), "gyro_general_fault": ("sensor.scaled_gyro",), "gyro_over_range": ("sensor.scaled_gyro",), "gyro_self_test_fail": ("sensor.scaled_gyro",), "mag_general_fault": ("sensor.scaled_mag",), "mag_over_range": ("sensor.scaled_mag",), "mag_self_test_fail": ("sensor.scaled_mag",), "pressure_sensor_general_fault": ("sensor.scaled_pressure",), "pressure_sensor_over_range": ("sensor.scaled_pressure",), "pressure_sensor_self_test_fail": ("sensor.scaled_pressure",), "receiver_1_fault": ("gnss_data.fix_info",), "receiver_1_no_solution": ("gnss_data.fix_info",), "receiver_2_fault": ("gnss_data.fix_info",), "receiver_2_no_solution": ("gnss_data.fix_info",)}),
    "Cv7InertialContinuousBuiltInTest": BitsInfo("cv7_inertial_continuous_built_in_test", types.Cv7InertialContinuousBuiltInTest, concerns={"imu_calibration_error_accel": ("sensor.scaled_accel",), "imu_calibration_error_gyro": ("sensor.scaled_gyro",), "imu_calibration_error_mag": ("sensor.scaled_mag",), "accel_general_fault": ("sensor.scaled_accel",), "accel_over_range": ("sensor.scaled_accel",), "accel_self_test_fail": ("sensor.scaled_accel",), "gyro_general_fault": ("sensor.scaled_gyro",), "gyro_over_range": ("sensor.scaled_gyro",), "gyro_self_test_fail": ("sensor.scaled_gyro",), "mag_general_fault": ("sensor.scaled_mag",), "mag_over_range": ("sensor.scaled_mag",), "mag_self_test_fail": ("sensor.scaled_mag",), "pressure_sensor_general_fault": ("sensor.scaled_pressure",), "pressure_sensor_over_range": ("sensor.scaled_pressure",), "pressure_sensor_self_test_fail": ("sensor.scaled_pressure",)}),
    "Gq7ContinuousBuiltInTest": BitsInfo("gq7_continuous_built_in_test", types.Gq7ContinuousBuiltInTest, concerns={"imu_calibration_error_accel": ("sensor.scaled_accel",), "imu_calibration_error_gyro": ("sensor.scaled_gyro",), "imu_calibration_error_mag": ("sensor.scaled_mag",), "accel_general_fault": ("sensor.scaled_accel",), "accel_over_range": ("sensor.scaled_accel",), "accel_self_test_fail": ("sensor.scaled_accel",), "gyro_general_fault": ("sensor.scaled_gyro",), "gyro_over_range": ("sensor.scaled_gyro",), "gyro_self_test_fail": ("sensor.scaled_gyro",), "mag_general_fault": ("sensor.scaled_mag",), "mag_over_range": ("sensor.scaled_mag",), "mag_self_test_fail": ("sensor.scaled_mag",), "pressure_sensor_general_fault": ("sensor.scaled_pressure",), "pressure_sensor_over_range": ("sensor.scaled_pressure",), "pressure_sensor_self_test_fail": ("sensor.scaled_pressure",), "gps_time_fault": ("gnss_data.gps_time",), "receiver_1_power_fault": ("gnss_data.fix_info",), "receiver_1_fault": ("gnss_data.fix_info",), "antenna_1_shorted": ("gnss_data.hardware_status",), "antenna_1_open": ("gnss_data.hardware_status",), "receiver_1_solution_fault": ("gnss_data.fix_info",), "receiver_2_power_fault": ("gnss_data.fix_info",), "receiver_2_fault": ("gnss_data.fix_info",), "antenna_2_shorted": ("gnss_data.hardware_status",), "antenna_2_open": ("gnss_data.hardware_status",), "receiver_2_solution_fault": ("gnss_data.fix_info",), "rtcm_comm_fault": ("gnss_data.rtk_corrections_status",), "rtk_dongle_fault": ("rtk.get_status_flags",)}),
    "EventTriggerType": EnumInfo("event_trigger_type", types.EventTriggerType),
    "EventActionType": EnumInfo("event_action_type", types.EventActionType),
    "EventTriggerMode": EnumInfo("event_trigger_mode", types.EventTriggerMode),
    "EventTriggerStatus": BitsInfo("event_trigger_status", types.EventTriggerStatus),
    "EventTriggerGpioMode": EnumInfo("event_trigger_gpio_mode", types.EventTriggerGpioMode),
    "EventThresholdType": EnumInfo("event_threshold_type", types.EventThresholdType),
    "EventActionGpioMode": EnumInfo("event_action_gpio_mode", types.EventActionGpioMode),
    "EventTriggerGpio": StructureInfo("event_trigger_gpio", types.EventTriggerGpio, (
            Parameter("pin", "pin", "scalar", scalar="u8", minimum=1),
            Parameter("mode", "mode", "scalar", scalar="u8", type=types.EventTriggerGpioMode),
        )),
    "EventThresholdWindow": StructureInfo("event_threshold_window", types.EventThresholdWindow, (
            Parameter("low_threshold", "low_threshold", "scalar", scalar="double"),
            Parameter("high_threshold", "high_threshold", "scalar", scalar="double"),
        )),
    "EventThresholdInterval": StructureInfo("event_threshold_interval", types.EventThresholdInterval, (
            Parameter("interval_threshold", "interval_threshold", "scalar", scalar="double"),
            Parameter("interval", "interval", "scalar", scalar="double"),
        )),
    "EventTriggerThreshold": StructureInfo("event_trigger_threshold", types.EventTriggerThreshold, (
            Parameter("descriptor_set", "descriptor_set", "scalar", scalar="u8", refers="set"),
            Parameter("field_descriptor", "field_descriptor", "scalar", scalar="u8", refers="field", fields_of="descriptor_set"),
            Parameter("parameter_id", "parameter_id", "scalar", scalar="u8", minimum=1),
            Parameter("type", "type", "scalar", scalar="u8", type=types.EventThresholdType),
            Parameter("thresholds", "thresholds", "switch", tag="type", cases={1: Parameter("window", "window", "struct", type=types.EventThresholdWindow), 2: Parameter("interval", "interval", "struct", type=types.EventThresholdInterval), }),
        )),
    "EventTriggerCombination": StructureInfo("event_trigger_combination", types.EventTriggerCombination, (
            Parameter("logic_table", "logic_table", "scalar", scalar="u16"),
            Parameter("input_triggers", "input_triggers", "array", scalar="u8", length=4),
        )),
    "EventActionGpio": StructureInfo("event_action_gpio", types.EventActionGpio, (
            Parameter("pin", "pin", "scalar", scalar="u8", minimum=1),
            Parameter("mode", "mode", "scalar", scalar="u8", type=types.EventActionGpioMode),
        )),
    "EventActionMessage": StructureInfo("event_action_message", types.EventActionMessage, (
            Parameter("descriptor_set", "descriptor_set", "scalar", scalar="u8", refers="set"),
            Parameter("decimation", "decimation", "scalar", scalar="u16"),
            Parameter("num_fields", "num_fields", "counter", scalar="u8", counts="descriptors", maximum=12, minimum=0),
            Parameter("descriptors", "descriptors", "array", scalar="u8", length="num_fields", refers="field", fields_of="descriptor_set"),
        )),
    "GnssConstellation": EnumInfo("gnss_constellation", types.GnssConstellation),
    "GnssFixType": EnumInfo("gnss_fix_type", types.GnssFixType),
    "GnssSignal": EnumInfo("gnss_signal", types.GnssSignal),
    "GpioFeature": EnumInfo("gpio_feature", types.GpioFeature),
    "GpioUnusedBehavior": EnumInfo("gpio_unused_behavior", types.GpioUnusedBehavior),
    "GpioBehavior": EnumInfo("gpio_behavior", types.GpioBehavior),
    "GpioPpsBehavior": EnumInfo("gpio_pps_behavior", types.GpioPpsBehavior),
    "GpioEncoderBehavior": EnumInfo("gpio_encoder_behavior", types.GpioEncoderBehavior),
    "GpioTimestampBehavior": EnumInfo("gpio_timestamp_behavior", types.GpioTimestampBehavior),
    "GpioUartBehavior": EnumInfo("gpio_uart_behavior", types.GpioUartBehavior),
    "GpioPinMode": BitsInfo("gpio_pin_mode", types.GpioPinMode),
    "NmeaMessageId": EnumInfo("nmea_message_id", types.NmeaMessageId),
    "NmeaTalkerId": EnumInfo("nmea_talker_id", types.NmeaTalkerId),
    "NmeaMessage": StructureInfo("nmea_message", types.NmeaMessage, (
            Parameter("message_id", "message_id", "scalar", scalar="u8", type=types.NmeaMessageId),
            Parameter("talker_id", "talker_id", "scalar", scalar="u8", type=types.NmeaTalkerId),
            Parameter("source_descriptor_set", "source_descriptor_set", "scalar", scalar="u8", refers="set"),
            Parameter("decimation", "decimation", "scalar", scalar="u16"),
        )),
    "CommInterface": EnumInfo("comm_interface", types.CommInterface),
    "RtkStatusFlags": BitsInfo("rtk_status_flags", types.RtkStatusFlags),
    "RtkStatusFlagsLegacy": BitsInfo("rtk_status_flags_legacy", types.RtkStatusFlagsLegacy),
    "AckCode": EnumInfo("ack_code", types.AckCode),
    "DescriptorRate": StructureInfo("descriptor_rate", types.DescriptorRate, (
            Parameter("descriptor", "descriptor", "scalar", scalar="u8", refers="field"),
            Parameter("decimation", "decimation", "scalar", scalar="u16", minimum=1),
        )),
    "SensorGpsTimestampFlags": BitsInfo("sensor_gps_timestamp_flags", types.SensorGpsTimestampFlags),
    "Gx5SensorGpsTimestampFlags": BitsInfo("gx5_sensor_gps_timestamp_flags", types.Gx5SensorGpsTimestampFlags),
}
