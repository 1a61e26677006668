"""What the types of `types` mean."""

from __future__ import annotations

from .. import types
from ..info import BitsInfo, EnumInfo, Info, StructureInfo
from ..parameter import Parameter

# fmt: off

#: Class -> what is known of it.
TYPES: dict[str, Info] = {
    "Gx5BuiltInTest": BitsInfo("gx5_built_in_test", types.Gx5BuiltInTest),
    "Cv7BuiltInTest": BitsInfo("cv7_built_in_test", types.Cv7BuiltInTest),
    "Cv7ContinuousBuiltInTest": BitsInfo("cv7_continuous_built_in_test", types.Cv7ContinuousBuiltInTest, aliases=("filter_process_fault", "gnss_subsystem_fault")),
    "Cv7InertialContinuousBuiltInTest": BitsInfo("cv7_inertial_continuous_built_in_test", types.Cv7InertialContinuousBuiltInTest),
    "Gq7ContinuousBuiltInTest": BitsInfo("gq7_continuous_built_in_test", types.Gq7ContinuousBuiltInTest),
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
            Parameter("decimation", "decimation", "scalar", scalar="u16"),
        )),
    "SensorGpsTimestampFlags": BitsInfo("sensor_gps_timestamp_flags", types.SensorGpsTimestampFlags),
    "Gx5SensorGpsTimestampFlags": BitsInfo("gx5_sensor_gps_timestamp_flags", types.Gx5SensorGpsTimestampFlags),
}
