"""What fields are made of, for tools that treat all of them alike.

Importing this module imports all descriptor sets.
"""

from __future__ import annotations

from . import (
    aiding,
    base,
    filter,
    filter_data,
    gnss,
    gnss_1,
    gnss_2,
    gnss_corrections,
    gnss_external,
    mip_3dm,
    protocol,
    sensor,
    shared,
    system,
    system_data,
    types,
)
from .parameter import Parameter

__all__ = ["PARAMETERS", "Parameter"]

#: Fields and structures -> their parameters.
PARAMETERS: dict[type, tuple[Parameter, ...]] = {
    protocol.Acknowledge: (
        Parameter("command", "command", "scalar", scalar="u8"),
        Parameter("code", "code", "scalar", scalar="u8", type=types.AckCode),
    ),
    types.EventTriggerGpio: (
        Parameter("pin", "pin", "scalar", scalar="u8"),
        Parameter("mode", "mode", "scalar", scalar="u8", type=types.EventTriggerGpioMode),
    ),
    types.EventThresholdWindow: (
        Parameter("low_thres", "low_thres", "scalar", scalar="double"),
        Parameter("high_thres", "high_thres", "scalar", scalar="double"),
    ),
    types.EventThresholdInterval: (
        Parameter("int_thres", "int_thres", "scalar", scalar="double"),
        Parameter("interval", "interval", "scalar", scalar="double"),
    ),
    types.EventTriggerThreshold: (
        Parameter("desc_set", "desc_set", "scalar", scalar="u8"),
        Parameter("field_desc", "field_desc", "scalar", scalar="u8"),
        Parameter("param_id", "param_id", "scalar", scalar="u8"),
        Parameter("type", "type", "scalar", scalar="u8", type=types.EventThresholdType),
        Parameter(
            "thresholds",
            "thresholds",
            "switch",
            tag="type",
            cases={
                1: Parameter("window", "window", "struct", type=types.EventThresholdWindow),
                2: Parameter("interval", "interval", "struct", type=types.EventThresholdInterval),
            },
        ),
    ),
    types.EventTriggerCombination: (
        Parameter("logic_table", "logic_table", "scalar", scalar="u16"),
        Parameter("input_triggers", "input_triggers", "array", scalar="u8", length=4),
    ),
    types.EventActionGpio: (
        Parameter("pin", "pin", "scalar", scalar="u8"),
        Parameter("mode", "mode", "scalar", scalar="u8", type=types.EventActionGpioMode),
    ),
    types.EventActionMessage: (
        Parameter("desc_set", "desc_set", "scalar", scalar="u8"),
        Parameter("decimation", "decimation", "scalar", scalar="u16"),
        Parameter("num_fields", "num_fields", "counter", scalar="u8", counts="descriptors"),
        Parameter("descriptors", "descriptors", "array", scalar="u8", length="num_fields"),
    ),
    types.NmeaMessage: (
        Parameter("message_id", "message_id", "scalar", scalar="u8", type=types.NmeaMessageId),
        Parameter("talker_id", "talker_id", "scalar", scalar="u8", type=types.NmeaTalkerId),
        Parameter("source_desc_set", "source_desc_set", "scalar", scalar="u8"),
        Parameter("decimation", "decimation", "scalar", scalar="u16"),
    ),
    types.DescriptorRate: (
        Parameter("descriptor", "descriptor", "scalar", scalar="u8"),
        Parameter("decimation", "decimation", "scalar", scalar="u16"),
    ),
    base.BaseDeviceInfo: (
        Parameter("firmware_version", "firmware_version", "scalar", scalar="u16"),
        Parameter("model_name", "model_name", "text", scalar="char", length=16),
        Parameter("model_number", "model_number", "text", scalar="char", length=16),
        Parameter("serial_number", "serial_number", "text", scalar="char", length=16),
        Parameter("lot_number", "lot_number", "text", scalar="char", length=16),
        Parameter("device_options", "device_options", "text", scalar="char", length=16),
    ),
    base.Ping: (),
    base.SetToIdle: (),
    base.GetDeviceInformation: (),
    base.GetDeviceDescriptors: (),
    base.BuiltInTest: (),
    base.Resume: (),
    base.GetDeviceDescriptorsExtended: (),
    base.ContinuousBuiltInTest: (),
    base.CommPortSpeed: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("port", "port", "scalar", scalar="u8"),
        Parameter("baud", "baud", "scalar", scalar="u32", units=("Bd",)),
    ),
    base.GpsTimeUpdate: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("field_id", "field_id", "scalar", scalar="u8", type=base.GpsTimeField),
        Parameter("value", "value", "scalar", scalar="u32"),
    ),
    base.ResetDevice: (),
    base.GetDeviceInformationResponse: (
        Parameter("device_info", "device_info", "struct", type=base.BaseDeviceInfo),
    ),
    base.GetDeviceDescriptorsResponse: (
        Parameter("descriptors", "descriptors", "array", scalar="u16", length="rest"),
    ),
    base.BuiltInTestResponse: (Parameter("result", "result", "scalar", scalar="u32"),),
    base.GpsTimeUpdateWeekNumberResponse: (
        Parameter("week_number", "week_number", "scalar", scalar="u32", units=("week",)),
    ),
    base.GpsTimeUpdateTimeOfWeekResponse: (
        Parameter("time_of_week", "time_of_week", "scalar", scalar="u32", units=("s",)),
    ),
    base.GetDeviceDescriptorsExtendedResponse: (
        Parameter("descriptors", "descriptors", "array", scalar="u16", length="rest"),
    ),
    base.ContinuousBuiltInTestResponse: (
        Parameter("result", "result", "array", scalar="u8", length=16),
    ),
    base.CommPortSpeedResponse: (
        Parameter("port", "port", "scalar", scalar="u8"),
        Parameter("baud", "baud", "scalar", scalar="u32", units=("Bd",)),
    ),
    mip_3dm.PollEntry: (
        Parameter("descriptor", "descriptor", "scalar", scalar="u8"),
        Parameter("reserved", "reserved", "scalar", scalar="u16"),
    ),
    mip_3dm.SupportedEventInfo: (
        Parameter("type", "type", "scalar", scalar="u8"),
        Parameter("count", "count", "scalar", scalar="u8", units=("1",)),
    ),
    mip_3dm.EventTriggerStatusEntry: (
        Parameter("type", "type", "scalar", scalar="u8", type=types.EventTriggerType),
        Parameter("status", "status", "scalar", scalar="u8", type=types.EventTriggerStatus),
    ),
    mip_3dm.EventActionStatusEntry: (
        Parameter("action_type", "action_type", "scalar", scalar="u8", type=types.EventActionType),
        Parameter("trigger_id", "trigger_id", "scalar", scalar="u8"),
    ),
    mip_3dm.SensorRangeEntry: (
        Parameter("setting", "setting", "scalar", scalar="u8"),
        Parameter("range", "range", "scalar", scalar="float"),
    ),
    mip_3dm.PollImuData: (
        Parameter("suppress_ack", "suppress_ack", "scalar", scalar="bool"),
        Parameter(
            "num_descriptors", "num_descriptors", "counter", scalar="u8", counts="descriptors"
        ),
        Parameter(
            "descriptors", "descriptors", "array", length="num_descriptors", type=mip_3dm.PollEntry
        ),
    ),
    mip_3dm.PollEstimationFilterData: (
        Parameter("suppress_ack", "suppress_ack", "scalar", scalar="bool"),
        Parameter(
            "num_descriptors", "num_descriptors", "counter", scalar="u8", counts="descriptors"
        ),
        Parameter(
            "descriptors", "descriptors", "array", length="num_descriptors", type=mip_3dm.PollEntry
        ),
    ),
    mip_3dm.PollNmeaData: (
        Parameter("suppress_ack", "suppress_ack", "scalar", scalar="bool"),
        Parameter("count", "count", "counter", scalar="u8", counts="format_entries"),
        Parameter(
            "format_entries", "format_entries", "array", length="count", type=types.NmeaMessage
        ),
    ),
    mip_3dm.GetImuDataBaseRate: (),
    mip_3dm.ImuMessageFormat: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "num_descriptors", "num_descriptors", "counter", scalar="u8", counts="descriptors"
        ),
        Parameter(
            "descriptors",
            "descriptors",
            "array",
            length="num_descriptors",
            type=types.DescriptorRate,
        ),
    ),
    mip_3dm.EstimationFilterMessageFormat: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "num_descriptors", "num_descriptors", "counter", scalar="u8", counts="descriptors"
        ),
        Parameter(
            "descriptors",
            "descriptors",
            "array",
            length="num_descriptors",
            type=types.DescriptorRate,
        ),
    ),
    mip_3dm.GetEstimationFilterDataBaseRate: (),
    mip_3dm.NmeaMessageFormat: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("count", "count", "counter", scalar="u8", counts="format_entries"),
        Parameter(
            "format_entries", "format_entries", "array", length="count", type=types.NmeaMessage
        ),
    ),
    mip_3dm.PollData: (
        Parameter("desc_set", "desc_set", "scalar", scalar="u8"),
        Parameter("suppress_ack", "suppress_ack", "scalar", scalar="bool"),
        Parameter(
            "num_descriptors", "num_descriptors", "counter", scalar="u8", counts="descriptors"
        ),
        Parameter("descriptors", "descriptors", "array", scalar="u8", length="num_descriptors"),
    ),
    mip_3dm.GetDataBaseRate: (Parameter("desc_set", "desc_set", "scalar", scalar="u8"),),
    mip_3dm.MessageFormat: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("desc_set", "desc_set", "scalar", scalar="u8"),
        Parameter(
            "num_descriptors", "num_descriptors", "counter", scalar="u8", counts="descriptors"
        ),
        Parameter(
            "descriptors",
            "descriptors",
            "array",
            length="num_descriptors",
            type=types.DescriptorRate,
        ),
    ),
    mip_3dm.FactoryStreaming: (
        Parameter("action", "action", "scalar", scalar="u8", type=mip_3dm.FactoryStreamingAction),
        Parameter("reserved", "reserved", "scalar", scalar="u8"),
    ),
    mip_3dm.DataStreamControl: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("desc_set", "desc_set", "scalar", scalar="u8"),
        Parameter("enable", "enable", "scalar", scalar="bool"),
    ),
    mip_3dm.GnssSbasSettings: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("enable_sbas", "enable_sbas", "scalar", scalar="u8"),
        Parameter("sbas_options", "sbas_options", "scalar", scalar="u16", type=mip_3dm.SbasOptions),
        Parameter(
            "num_included_prns", "num_included_prns", "counter", scalar="u8", counts="included_prns"
        ),
        Parameter(
            "included_prns", "included_prns", "array", scalar="u16", length="num_included_prns"
        ),
    ),
    mip_3dm.PpsSourceControl: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("source", "source", "scalar", scalar="u8", type=mip_3dm.PpsSource),
    ),
    mip_3dm.GetSupportedEvents: (
        Parameter("query", "query", "scalar", scalar="u8", type=mip_3dm.SupportedEventsQuery),
    ),
    mip_3dm.EventControl: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("instance", "instance", "scalar", scalar="u8"),
        Parameter("mode", "mode", "scalar", scalar="u8", type=types.EventTriggerMode),
    ),
    mip_3dm.GetEventTriggerStatus: (
        Parameter(
            "requested_count",
            "requested_count",
            "counter",
            scalar="u8",
            counts="requested_instances",
        ),
        Parameter(
            "requested_instances",
            "requested_instances",
            "array",
            scalar="u8",
            length="requested_count",
        ),
    ),
    mip_3dm.GetEventActionStatus: (
        Parameter(
            "requested_count",
            "requested_count",
            "counter",
            scalar="u8",
            counts="requested_instances",
        ),
        Parameter(
            "requested_instances",
            "requested_instances",
            "array",
            scalar="u8",
            length="requested_count",
        ),
    ),
    mip_3dm.EventTriggerConfiguration: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("instance", "instance", "scalar", scalar="u8"),
        Parameter("type", "type", "scalar", scalar="u8", type=types.EventTriggerType),
        Parameter(
            "parameters",
            "parameters",
            "switch",
            tag="type",
            cases={
                0: None,
                1: Parameter("gpio", "gpio", "struct", type=types.EventTriggerGpio),
                2: Parameter("threshold", "threshold", "struct", type=types.EventTriggerThreshold),
                3: Parameter(
                    "combination", "combination", "struct", type=types.EventTriggerCombination
                ),
            },
        ),
    ),
    mip_3dm.EventActionConfiguration: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("instance", "instance", "scalar", scalar="u8"),
        Parameter("trigger", "trigger", "scalar", scalar="u8"),
        Parameter("type", "type", "scalar", scalar="u8", type=types.EventActionType),
        Parameter(
            "parameters",
            "parameters",
            "switch",
            tag="type",
            cases={
                0: None,
                1: Parameter("gpio", "gpio", "struct", type=types.EventActionGpio),
                2: Parameter("message", "message", "struct", type=types.EventActionMessage),
            },
        ),
    ),
    mip_3dm.DeviceStartUpSettings: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
    ),
    mip_3dm.SensorToVehicleFrameTransformationEuler: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("roll", "roll", "scalar", scalar="float", units=("rad",)),
        Parameter("pitch", "pitch", "scalar", scalar="float", units=("rad",)),
        Parameter("yaw", "yaw", "scalar", scalar="float", units=("rad",)),
    ),
    mip_3dm.SensorToVehicleFrameTransformationQuaternion: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("q", "q", "array", scalar="float", elements=("w", "x", "y", "z"), units=("1",)),
    ),
    mip_3dm.SensorToVehicleFrameTransformationDirectionCosineMatrix: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "dcm",
            "dcm",
            "array",
            scalar="float",
            elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"),
            units=("1",),
        ),
    ),
    mip_3dm.AccelerometerBiasConfiguration: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("bias", "bias", "array", scalar="float", elements=("x", "y", "z"), units=("g",)),
    ),
    mip_3dm.GyroscopeBiasConfiguration: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "bias", "bias", "array", scalar="float", elements=("x", "y", "z"), units=("rad/s",)
        ),
    ),
    mip_3dm.CaptureGyroscopeBias: (
        Parameter("averaging_time_ms", "averaging_time_ms", "scalar", scalar="u16", units=("ms",)),
    ),
    mip_3dm.MagnetometerHardIronOffset: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "offset", "offset", "array", scalar="float", elements=("x", "y", "z"), units=("gauss",)
        ),
    ),
    mip_3dm.MagnetometerSoftIronMatrix: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "offset",
            "offset",
            "array",
            scalar="float",
            elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"),
            units=("1",),
        ),
    ),
    mip_3dm.ConingAndScullingEnable: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("enable", "enable", "scalar", scalar="bool"),
    ),
    mip_3dm.UartBaudRate: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("baud", "baud", "scalar", scalar="u32", units=("Bd",)),
    ),
    mip_3dm.GpioConfiguration: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("pin", "pin", "scalar", scalar="u8"),
        Parameter("feature", "feature", "scalar", scalar="u8", type=types.GpioFeature),
        Parameter("behavior", "behavior", "scalar", scalar="u8"),
        Parameter("pin_mode", "pin_mode", "scalar", scalar="u8", type=types.GpioPinMode),
    ),
    mip_3dm.GpioState: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("pin", "pin", "scalar", scalar="u8"),
        Parameter("state", "state", "scalar", scalar="bool"),
    ),
    mip_3dm.OdometerConfiguration: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("mode", "mode", "scalar", scalar="u8", type=mip_3dm.OdometerMode),
        Parameter("scaling", "scaling", "scalar", scalar="float", units=("pulse/m",)),
        Parameter("uncertainty", "uncertainty", "scalar", scalar="float", units=("1",)),
    ),
    mip_3dm.AdvancedLowPassFilterSettings: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("target_descriptor", "target_descriptor", "scalar", scalar="u8"),
        Parameter("enable", "enable", "scalar", scalar="bool"),
        Parameter("manual", "manual", "scalar", scalar="bool"),
        Parameter("frequency", "frequency", "scalar", scalar="u16", units=("Hz",)),
        Parameter("reserved", "reserved", "scalar", scalar="u8"),
    ),
    mip_3dm.ComplementaryFilterConfiguration: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("pitch_roll_enable", "pitch_roll_enable", "scalar", scalar="bool"),
        Parameter("heading_enable", "heading_enable", "scalar", scalar="bool"),
        Parameter(
            "pitch_roll_time_constant",
            "pitch_roll_time_constant",
            "scalar",
            scalar="float",
            units=("s",),
        ),
        Parameter(
            "heading_time_constant", "heading_time_constant", "scalar", scalar="float", units=("s",)
        ),
    ),
    mip_3dm.SensorRange: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("sensor", "sensor", "scalar", scalar="u8", type=mip_3dm.SensorRangeType),
        Parameter("setting", "setting", "scalar", scalar="u8"),
    ),
    mip_3dm.GetCalibratedSensorRanges: (
        Parameter("sensor", "sensor", "scalar", scalar="u8", type=mip_3dm.SensorRangeType),
    ),
    mip_3dm.LowPassAntiAliasingFilter: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("desc_set", "desc_set", "scalar", scalar="u8"),
        Parameter("field_desc", "field_desc", "scalar", scalar="u8"),
        Parameter("enable", "enable", "scalar", scalar="bool"),
        Parameter("manual", "manual", "scalar", scalar="bool"),
        Parameter("frequency", "frequency", "scalar", scalar="float", units=("Hz",)),
    ),
    mip_3dm.DeviceStatus: (
        Parameter("model_number", "model_number", "constant", scalar="u16", constant=6254),
        Parameter(
            "status_selector",
            "status_selector",
            "scalar",
            scalar="u8",
            type=mip_3dm.DeviceStatusSelector,
        ),
    ),
    mip_3dm.ImuMessageFormatResponse: (
        Parameter(
            "num_descriptors", "num_descriptors", "counter", scalar="u8", counts="descriptors"
        ),
        Parameter(
            "descriptors",
            "descriptors",
            "array",
            length="num_descriptors",
            type=types.DescriptorRate,
        ),
    ),
    mip_3dm.EstimationFilterMessageFormatResponse: (
        Parameter(
            "num_descriptors", "num_descriptors", "counter", scalar="u8", counts="descriptors"
        ),
        Parameter(
            "descriptors",
            "descriptors",
            "array",
            length="num_descriptors",
            type=types.DescriptorRate,
        ),
    ),
    mip_3dm.GetImuDataBaseRateResponse: (
        Parameter("rate", "rate", "scalar", scalar="u16", units=("Hz",)),
    ),
    mip_3dm.DataStreamControlResponse: (
        Parameter("desc_set", "desc_set", "scalar", scalar="u8"),
        Parameter("enabled", "enabled", "scalar", scalar="bool"),
    ),
    mip_3dm.UartBaudRateResponse: (
        Parameter("baud", "baud", "scalar", scalar="u32", units=("Bd",)),
    ),
    mip_3dm.GetEstimationFilterDataBaseRateResponse: (
        Parameter("rate", "rate", "scalar", scalar="u16", units=("Hz",)),
    ),
    mip_3dm.AdvancedLowPassFilterSettingsResponse: (
        Parameter("target_descriptor", "target_descriptor", "scalar", scalar="u8"),
        Parameter("enable", "enable", "scalar", scalar="bool"),
        Parameter("manual", "manual", "scalar", scalar="bool"),
        Parameter("frequency", "frequency", "scalar", scalar="u16", units=("Hz",)),
        Parameter("reserved", "reserved", "scalar", scalar="u8"),
    ),
    mip_3dm.NmeaMessageFormatResponse: (
        Parameter("count", "count", "counter", scalar="u8", counts="format_entries"),
        Parameter(
            "format_entries", "format_entries", "array", length="count", type=types.NmeaMessage
        ),
    ),
    mip_3dm.GetDataBaseRateResponse: (
        Parameter("desc_set", "desc_set", "scalar", scalar="u8"),
        Parameter("rate", "rate", "scalar", scalar="u16", units=("Hz",)),
    ),
    mip_3dm.MessageFormatResponse: (
        Parameter("desc_set", "desc_set", "scalar", scalar="u8"),
        Parameter(
            "num_descriptors", "num_descriptors", "counter", scalar="u8", counts="descriptors"
        ),
        Parameter(
            "descriptors",
            "descriptors",
            "array",
            length="num_descriptors",
            type=types.DescriptorRate,
        ),
    ),
    mip_3dm.DeviceStatusBasicResponse: (
        Parameter("model_number", "model_number", "constant", scalar="u16", constant=6254),
        Parameter("status_selector", "status_selector", "constant", scalar="u8", constant=1),
        Parameter("status_flags", "status_flags", "scalar", scalar="u32"),
        Parameter("system_state", "system_state", "scalar", scalar="u16"),
        Parameter("system_timer", "system_timer", "scalar", scalar="u32", units=("ms",)),
    ),
    mip_3dm.DeviceStatusDiagnosticResponse: (
        Parameter("model_number", "model_number", "constant", scalar="u16", constant=6254),
        Parameter("status_selector", "status_selector", "constant", scalar="u8", constant=2),
        Parameter("status_flags", "status_flags", "scalar", scalar="u32"),
        Parameter("system_state", "system_state", "scalar", scalar="u16"),
        Parameter("system_timer", "system_timer", "scalar", scalar="u32", units=("ms",)),
        Parameter("imu_stream_enabled", "imu_stream_enabled", "scalar", scalar="bool"),
        Parameter("filter_stream_enabled", "filter_stream_enabled", "scalar", scalar="bool"),
        Parameter(
            "imu_dropped_packets", "imu_dropped_packets", "scalar", scalar="u32", units=("1",)
        ),
        Parameter(
            "filter_dropped_packets", "filter_dropped_packets", "scalar", scalar="u32", units=("1",)
        ),
        Parameter(
            "com_port_bytes_written",
            "com_port_bytes_written",
            "scalar",
            scalar="u32",
            units=("byte",),
        ),
        Parameter(
            "com_port_bytes_read", "com_port_bytes_read", "scalar", scalar="u32", units=("byte",)
        ),
        Parameter(
            "com_port_write_overruns",
            "com_port_write_overruns",
            "scalar",
            scalar="u32",
            units=("1",),
        ),
        Parameter(
            "com_port_read_overruns", "com_port_read_overruns", "scalar", scalar="u32", units=("1",)
        ),
        Parameter("imu_parser_errors", "imu_parser_errors", "scalar", scalar="u32", units=("1",)),
        Parameter("imu_message_count", "imu_message_count", "scalar", scalar="u32", units=("1",)),
        Parameter(
            "imu_last_message_time", "imu_last_message_time", "scalar", scalar="u32", units=("ms",)
        ),
    ),
    mip_3dm.ComplementaryFilterConfigurationResponse: (
        Parameter("pitch_roll_enable", "pitch_roll_enable", "scalar", scalar="bool"),
        Parameter("heading_enable", "heading_enable", "scalar", scalar="bool"),
        Parameter(
            "pitch_roll_time_constant",
            "pitch_roll_time_constant",
            "scalar",
            scalar="float",
            units=("s",),
        ),
        Parameter(
            "heading_time_constant", "heading_time_constant", "scalar", scalar="float", units=("s",)
        ),
    ),
    mip_3dm.AccelerometerBiasConfigurationResponse: (
        Parameter("bias", "bias", "array", scalar="float", elements=("x", "y", "z"), units=("g",)),
    ),
    mip_3dm.GyroscopeBiasConfigurationResponse: (
        Parameter(
            "bias", "bias", "array", scalar="float", elements=("x", "y", "z"), units=("rad/s",)
        ),
    ),
    mip_3dm.MagnetometerHardIronOffsetResponse: (
        Parameter(
            "offset", "offset", "array", scalar="float", elements=("x", "y", "z"), units=("gauss",)
        ),
    ),
    mip_3dm.MagnetometerSoftIronMatrixResponse: (
        Parameter(
            "offset",
            "offset",
            "array",
            scalar="float",
            elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"),
            units=("1",),
        ),
    ),
    mip_3dm.ConingAndScullingEnableResponse: (
        Parameter("enable", "enable", "scalar", scalar="bool"),
    ),
    mip_3dm.GnssSbasSettingsResponse: (
        Parameter("enable_sbas", "enable_sbas", "scalar", scalar="u8"),
        Parameter("sbas_options", "sbas_options", "scalar", scalar="u16", type=mip_3dm.SbasOptions),
        Parameter(
            "num_included_prns", "num_included_prns", "counter", scalar="u8", counts="included_prns"
        ),
        Parameter(
            "included_prns", "included_prns", "array", scalar="u16", length="num_included_prns"
        ),
    ),
    mip_3dm.PpsSourceControlResponse: (
        Parameter("source", "source", "scalar", scalar="u8", type=mip_3dm.PpsSource),
    ),
    mip_3dm.SensorToVehicleFrameTransformationEulerResponse: (
        Parameter("roll", "roll", "scalar", scalar="float", units=("rad",)),
        Parameter("pitch", "pitch", "scalar", scalar="float", units=("rad",)),
        Parameter("yaw", "yaw", "scalar", scalar="float", units=("rad",)),
    ),
    mip_3dm.SensorToVehicleFrameTransformationQuaternionResponse: (
        Parameter("q", "q", "array", scalar="float", elements=("w", "x", "y", "z"), units=("1",)),
    ),
    mip_3dm.SensorToVehicleFrameTransformationDirectionCosineMatrixResponse: (
        Parameter(
            "dcm",
            "dcm",
            "array",
            scalar="float",
            elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"),
            units=("1",),
        ),
    ),
    mip_3dm.GetSupportedEventsResponse: (
        Parameter("query", "query", "scalar", scalar="u8", type=mip_3dm.SupportedEventsQuery),
        Parameter("max_instances", "max_instances", "scalar", scalar="u8", units=("1",)),
        Parameter("num_entries", "num_entries", "counter", scalar="u8", counts="entries"),
        Parameter(
            "entries", "entries", "array", length="num_entries", type=mip_3dm.SupportedEventInfo
        ),
    ),
    mip_3dm.EventControlResponse: (
        Parameter("instance", "instance", "scalar", scalar="u8"),
        Parameter("mode", "mode", "scalar", scalar="u8", type=types.EventTriggerMode),
    ),
    mip_3dm.GetEventTriggerStatusResponse: (
        Parameter("count", "count", "counter", scalar="u8", counts="triggers"),
        Parameter(
            "triggers", "triggers", "array", length="count", type=mip_3dm.EventTriggerStatusEntry
        ),
    ),
    mip_3dm.GetEventActionStatusResponse: (
        Parameter("count", "count", "counter", scalar="u8", counts="actions"),
        Parameter(
            "actions", "actions", "array", length="count", type=mip_3dm.EventActionStatusEntry
        ),
    ),
    mip_3dm.EventTriggerConfigurationResponse: (
        Parameter("instance", "instance", "scalar", scalar="u8"),
        Parameter("type", "type", "scalar", scalar="u8", type=types.EventTriggerType),
        Parameter(
            "parameters",
            "parameters",
            "switch",
            tag="type",
            cases={
                0: None,
                1: Parameter("gpio", "gpio", "struct", type=types.EventTriggerGpio),
                2: Parameter("threshold", "threshold", "struct", type=types.EventTriggerThreshold),
                3: Parameter(
                    "combination", "combination", "struct", type=types.EventTriggerCombination
                ),
            },
        ),
    ),
    mip_3dm.EventActionConfigurationResponse: (
        Parameter("instance", "instance", "scalar", scalar="u8"),
        Parameter("trigger", "trigger", "scalar", scalar="u8"),
        Parameter("type", "type", "scalar", scalar="u8", type=types.EventActionType),
        Parameter(
            "parameters",
            "parameters",
            "switch",
            tag="type",
            cases={
                0: None,
                1: Parameter("gpio", "gpio", "struct", type=types.EventActionGpio),
                2: Parameter("message", "message", "struct", type=types.EventActionMessage),
            },
        ),
    ),
    mip_3dm.GpioConfigurationResponse: (
        Parameter("pin", "pin", "scalar", scalar="u8"),
        Parameter("feature", "feature", "scalar", scalar="u8", type=types.GpioFeature),
        Parameter("behavior", "behavior", "scalar", scalar="u8"),
        Parameter("pin_mode", "pin_mode", "scalar", scalar="u8", type=types.GpioPinMode),
    ),
    mip_3dm.GpioStateResponse: (
        Parameter("pin", "pin", "scalar", scalar="u8"),
        Parameter("state", "state", "scalar", scalar="bool"),
    ),
    mip_3dm.OdometerConfigurationResponse: (
        Parameter("mode", "mode", "scalar", scalar="u8", type=mip_3dm.OdometerMode),
        Parameter("scaling", "scaling", "scalar", scalar="float", units=("pulse/m",)),
        Parameter("uncertainty", "uncertainty", "scalar", scalar="float", units=("1",)),
    ),
    mip_3dm.SensorRangeResponse: (
        Parameter("sensor", "sensor", "scalar", scalar="u8", type=mip_3dm.SensorRangeType),
        Parameter("setting", "setting", "scalar", scalar="u8"),
    ),
    mip_3dm.GetCalibratedSensorRangesResponse: (
        Parameter("sensor", "sensor", "scalar", scalar="u8", type=mip_3dm.SensorRangeType),
        Parameter("num_ranges", "num_ranges", "counter", scalar="u8", counts="ranges"),
        Parameter("ranges", "ranges", "array", length="num_ranges", type=mip_3dm.SensorRangeEntry),
    ),
    mip_3dm.LowPassAntiAliasingFilterResponse: (
        Parameter("desc_set", "desc_set", "scalar", scalar="u8"),
        Parameter("field_desc", "field_desc", "scalar", scalar="u8"),
        Parameter("enable", "enable", "scalar", scalar="bool"),
        Parameter("manual", "manual", "scalar", scalar="bool"),
        Parameter("frequency", "frequency", "scalar", scalar="float", units=("Hz",)),
    ),
    filter.ResetNavigationFilter: (),
    filter.SetInitialAttitude: (
        Parameter("roll", "roll", "scalar", scalar="float", units=("rad",)),
        Parameter("pitch", "pitch", "scalar", scalar="float", units=("rad",)),
        Parameter("heading", "heading", "scalar", scalar="float", units=("rad",)),
    ),
    filter.SetInitialHeadingControl: (
        Parameter("heading", "heading", "scalar", scalar="float", units=("rad",)),
    ),
    filter.RunNavigationFilter: (),
    filter.SensorToVehicleFrameTransformation: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("roll", "roll", "scalar", scalar="float", units=("rad",)),
        Parameter("pitch", "pitch", "scalar", scalar="float", units=("rad",)),
        Parameter("yaw", "yaw", "scalar", scalar="float", units=("rad",)),
    ),
    filter.GnssAntennaOffsetControl: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "offset", "offset", "array", scalar="float", elements=("x", "y", "z"), units=("m",)
        ),
    ),
    filter.EstimationControlFlags: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("flags", "flags", "scalar", scalar="u16", type=filter.EstimatedStates),
    ),
    filter.GnssAidingSourceControl: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("source", "source", "scalar", scalar="u8", type=filter.GnssAidingSource),
    ),
    filter.ExternalHeadingUpdate: (
        Parameter("heading", "heading", "scalar", scalar="float", units=("rad",)),
        Parameter(
            "heading_uncertainty", "heading_uncertainty", "scalar", scalar="float", units=("rad",)
        ),
        Parameter("type", "type", "scalar", scalar="u8", type=filter.HeadingType),
    ),
    filter.HeadingUpdateControl: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("enable", "enable", "scalar", scalar="u8", type=filter.HeadingUpdateSource),
    ),
    filter.AutoInitializationControl: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("enable", "enable", "scalar", scalar="u8"),
    ),
    filter.AccelerometerNoiseStandardDeviation: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "noise", "noise", "array", scalar="float", elements=("x", "y", "z"), units=("m/s^2",)
        ),
    ),
    filter.GyroscopeNoiseStandardDeviation: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "noise", "noise", "array", scalar="float", elements=("x", "y", "z"), units=("rad/s",)
        ),
    ),
    filter.AccelerometerBiasModelParameters: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "beta", "beta", "array", scalar="float", elements=("x", "y", "z"), units=("1/s",)
        ),
        Parameter(
            "noise", "noise", "array", scalar="float", elements=("x", "y", "z"), units=("m/s^2",)
        ),
    ),
    filter.GyroscopeBiasModelParameters: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "beta", "beta", "array", scalar="float", elements=("x", "y", "z"), units=("1/s",)
        ),
        Parameter(
            "noise", "noise", "array", scalar="float", elements=("x", "y", "z"), units=("rad/s",)
        ),
    ),
    filter.ExternalHeadingUpdateWithTime: (
        Parameter("gps_time", "gps_time", "scalar", scalar="double", units=("s",)),
        Parameter("gps_week", "gps_week", "scalar", scalar="u16", units=("week",)),
        Parameter("heading", "heading", "scalar", scalar="float", units=("rad",)),
        Parameter(
            "heading_uncertainty", "heading_uncertainty", "scalar", scalar="float", units=("rad",)
        ),
        Parameter("type", "type", "scalar", scalar="u8", type=filter.HeadingType),
    ),
    filter.ZeroAngularRateUpdateControl: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("enable", "enable", "scalar", scalar="u8"),
        Parameter("threshold", "threshold", "scalar", scalar="float", units=("rad/s",)),
    ),
    filter.TareOrientation: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("axes", "axes", "scalar", scalar="u8", type=filter.TareAxes),
    ),
    filter.CommandedZeroAngularRateUpdate: (),
    filter.SetReferencePosition: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("enable", "enable", "scalar", scalar="u8"),
        Parameter("latitude", "latitude", "scalar", scalar="double", units=("deg",)),
        Parameter("longitude", "longitude", "scalar", scalar="double", units=("deg",)),
        Parameter("altitude", "altitude", "scalar", scalar="double", units=("m",)),
    ),
    filter.GravityNoiseStandardDeviation: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "noise", "noise", "array", scalar="float", elements=("x", "y", "z"), units=("g",)
        ),
    ),
    filter.EnableDisableMeasurements: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("control", "control", "scalar", scalar="u16", type=filter.MeasurementFlags),
    ),
    filter.MagneticFieldDeclinationSourceControl: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("source", "source", "scalar", scalar="u8", type=filter.DeclinationSource),
        Parameter("declination", "declination", "scalar", scalar="float", units=("rad",)),
    ),
    filter.GravityMagnitudeErrorAdaptiveMeasurement: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "adaptive_measurement",
            "adaptive_measurement",
            "scalar",
            scalar="u8",
            type=filter.AdaptiveMeasurementSelector,
        ),
        Parameter("frequency", "frequency", "scalar", scalar="float", units=("Hz",)),
        Parameter("low_limit", "low_limit", "scalar", scalar="float", units=("m/s^2",)),
        Parameter("high_limit", "high_limit", "scalar", scalar="float", units=("m/s^2",)),
        Parameter(
            "low_limit_uncertainty",
            "low_limit_uncertainty",
            "scalar",
            scalar="float",
            units=("m/s^2",),
        ),
        Parameter(
            "high_limit_uncertainty",
            "high_limit_uncertainty",
            "scalar",
            scalar="float",
            units=("m/s^2",),
        ),
        Parameter(
            "minimum_uncertainty", "minimum_uncertainty", "scalar", scalar="float", units=("m/s^2",)
        ),
    ),
    filter.PitchRollAidingControl: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("aiding", "aiding", "scalar", scalar="u8", type=filter.PitchRollAidingSource),
    ),
    filter.AidingMeasurementControl: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "aiding_source", "aiding_source", "scalar", scalar="u16", type=filter.AidingSource
        ),
        Parameter("enable", "enable", "scalar", scalar="bool"),
    ),
    filter.NavigationFilterInitialization: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("wait_for_run_command", "wait_for_run_command", "scalar", scalar="u8"),
        Parameter(
            "initial_cond_src",
            "initial_cond_src",
            "scalar",
            scalar="u8",
            type=filter.InitialConditionSource,
        ),
        Parameter(
            "auto_heading_alignment_selector",
            "auto_heading_alignment_selector",
            "scalar",
            scalar="u8",
            type=filter.HeadingAlignment,
        ),
        Parameter("initial_heading", "initial_heading", "scalar", scalar="float", units=("deg",)),
        Parameter("initial_pitch", "initial_pitch", "scalar", scalar="float", units=("deg",)),
        Parameter("initial_roll", "initial_roll", "scalar", scalar="float", units=("deg",)),
        Parameter(
            "initial_position",
            "initial_position",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
        ),
        Parameter(
            "initial_velocity",
            "initial_velocity",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s",),
        ),
        Parameter(
            "reference_frame_selector",
            "reference_frame_selector",
            "scalar",
            scalar="u8",
            type=filter.ReferenceFrame,
        ),
    ),
    filter.AdaptiveFilterControl: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("level", "level", "scalar", scalar="u8", type=filter.AdaptiveLevel),
        Parameter("time_limit", "time_limit", "scalar", scalar="u16", units=("ms",)),
    ),
    filter.GnssMultiAntennaOffsetControl: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("receiver_id", "receiver_id", "scalar", scalar="u8"),
        Parameter(
            "antenna_offset",
            "antenna_offset",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
        ),
    ),
    filter.RelativePositionConfiguration: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("source", "source", "scalar", scalar="u8", type=filter.RelativePositionSource),
        Parameter(
            "reference_frame_selector",
            "reference_frame_selector",
            "scalar",
            scalar="u8",
            type=filter.ReferenceFrame,
        ),
        Parameter(
            "reference_coordinates",
            "reference_coordinates",
            "array",
            scalar="double",
            elements=("x", "y", "z"),
        ),
    ),
    filter.ReferencePointLeverArm: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "ref_point_sel", "ref_point_sel", "scalar", scalar="u8", type=filter.ReferencePoint
        ),
        Parameter(
            "lever_arm_offset",
            "lever_arm_offset",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
        ),
    ),
    filter.MeasurementSpeedLeverArm: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("source", "source", "scalar", scalar="u8"),
        Parameter(
            "lever_arm_offset",
            "lever_arm_offset",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
        ),
    ),
    filter.WheeledVehicleConstraintControl: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("enable", "enable", "scalar", scalar="u8"),
    ),
    filter.GnssAntennaOffsetCalibrationControl: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("enable", "enable", "scalar", scalar="u8"),
        Parameter("max_offset", "max_offset", "scalar", scalar="float", units=("m",)),
    ),
    filter.SensorToVehicleFrameTransformationResponse: (
        Parameter("roll", "roll", "scalar", scalar="float", units=("rad",)),
        Parameter("pitch", "pitch", "scalar", scalar="float", units=("rad",)),
        Parameter("yaw", "yaw", "scalar", scalar="float", units=("rad",)),
    ),
    filter.GnssAntennaOffsetControlResponse: (
        Parameter(
            "offset", "offset", "array", scalar="float", elements=("x", "y", "z"), units=("m",)
        ),
    ),
    filter.EstimationControlFlagsResponse: (
        Parameter("flags", "flags", "scalar", scalar="u16", type=filter.EstimatedStates),
    ),
    filter.GnssAidingSourceControlResponse: (
        Parameter("source", "source", "scalar", scalar="u8", type=filter.GnssAidingSource),
    ),
    filter.HeadingUpdateControlResponse: (
        Parameter("enable", "enable", "scalar", scalar="u8", type=filter.HeadingUpdateSource),
    ),
    filter.AutoInitializationControlResponse: (
        Parameter("enable", "enable", "scalar", scalar="u8"),
    ),
    filter.AccelerometerNoiseStandardDeviationResponse: (
        Parameter(
            "noise", "noise", "array", scalar="float", elements=("x", "y", "z"), units=("m/s^2",)
        ),
    ),
    filter.GyroscopeNoiseStandardDeviationResponse: (
        Parameter(
            "noise", "noise", "array", scalar="float", elements=("x", "y", "z"), units=("rad/s",)
        ),
    ),
    filter.AccelerometerBiasModelParametersResponse: (
        Parameter(
            "beta", "beta", "array", scalar="float", elements=("x", "y", "z"), units=("1/s",)
        ),
        Parameter(
            "noise", "noise", "array", scalar="float", elements=("x", "y", "z"), units=("m/s^2",)
        ),
    ),
    filter.GyroscopeBiasModelParametersResponse: (
        Parameter(
            "beta", "beta", "array", scalar="float", elements=("x", "y", "z"), units=("1/s",)
        ),
        Parameter(
            "noise", "noise", "array", scalar="float", elements=("x", "y", "z"), units=("rad/s",)
        ),
    ),
    filter.ZeroAngularRateUpdateControlResponse: (
        Parameter("enable", "enable", "scalar", scalar="u8"),
        Parameter("threshold", "threshold", "scalar", scalar="float", units=("rad/s",)),
    ),
    filter.SetReferencePositionResponse: (
        Parameter("enable", "enable", "scalar", scalar="u8"),
        Parameter("latitude", "latitude", "scalar", scalar="double", units=("deg",)),
        Parameter("longitude", "longitude", "scalar", scalar="double", units=("deg",)),
        Parameter("altitude", "altitude", "scalar", scalar="double", units=("m",)),
    ),
    filter.GravityNoiseStandardDeviationResponse: (
        Parameter(
            "noise", "noise", "array", scalar="float", elements=("x", "y", "z"), units=("g",)
        ),
    ),
    filter.EnableDisableMeasurementsResponse: (
        Parameter("control", "control", "scalar", scalar="u16", type=filter.MeasurementFlags),
    ),
    filter.MagneticFieldDeclinationSourceControlResponse: (
        Parameter("source", "source", "scalar", scalar="u8", type=filter.DeclinationSource),
        Parameter("declination", "declination", "scalar", scalar="float", units=("rad",)),
    ),
    filter.GravityMagnitudeErrorAdaptiveMeasurementResponse: (
        Parameter(
            "adaptive_measurement",
            "adaptive_measurement",
            "scalar",
            scalar="u8",
            type=filter.AdaptiveMeasurementSelector,
        ),
        Parameter("frequency", "frequency", "scalar", scalar="float", units=("Hz",)),
        Parameter("low_limit", "low_limit", "scalar", scalar="float", units=("m/s^2",)),
        Parameter("high_limit", "high_limit", "scalar", scalar="float", units=("m/s^2",)),
        Parameter(
            "low_limit_uncertainty",
            "low_limit_uncertainty",
            "scalar",
            scalar="float",
            units=("m/s^2",),
        ),
        Parameter(
            "high_limit_uncertainty",
            "high_limit_uncertainty",
            "scalar",
            scalar="float",
            units=("m/s^2",),
        ),
        Parameter(
            "minimum_uncertainty", "minimum_uncertainty", "scalar", scalar="float", units=("m/s^2",)
        ),
    ),
    filter.PitchRollAidingControlResponse: (
        Parameter("aiding", "aiding", "scalar", scalar="u8", type=filter.PitchRollAidingSource),
    ),
    filter.AidingMeasurementControlResponse: (
        Parameter(
            "aiding_source", "aiding_source", "scalar", scalar="u16", type=filter.AidingSource
        ),
        Parameter("enable", "enable", "scalar", scalar="bool"),
    ),
    filter.NavigationFilterInitializationResponse: (
        Parameter("wait_for_run_command", "wait_for_run_command", "scalar", scalar="u8"),
        Parameter(
            "initial_cond_src",
            "initial_cond_src",
            "scalar",
            scalar="u8",
            type=filter.InitialConditionSource,
        ),
        Parameter(
            "auto_heading_alignment_selector",
            "auto_heading_alignment_selector",
            "scalar",
            scalar="u8",
            type=filter.HeadingAlignment,
        ),
        Parameter("initial_heading", "initial_heading", "scalar", scalar="float", units=("deg",)),
        Parameter("initial_pitch", "initial_pitch", "scalar", scalar="float", units=("deg",)),
        Parameter("initial_roll", "initial_roll", "scalar", scalar="float", units=("deg",)),
        Parameter(
            "initial_position",
            "initial_position",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
        ),
        Parameter(
            "initial_velocity",
            "initial_velocity",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s",),
        ),
        Parameter(
            "reference_frame_selector",
            "reference_frame_selector",
            "scalar",
            scalar="u8",
            type=filter.ReferenceFrame,
        ),
    ),
    filter.AdaptiveFilterControlResponse: (
        Parameter("level", "level", "scalar", scalar="u8", type=filter.AdaptiveLevel),
        Parameter("time_limit", "time_limit", "scalar", scalar="u16", units=("ms",)),
    ),
    filter.GnssMultiAntennaOffsetControlResponse: (
        Parameter("receiver_id", "receiver_id", "scalar", scalar="u8"),
        Parameter(
            "antenna_offset",
            "antenna_offset",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
        ),
    ),
    filter.RelativePositionConfigurationResponse: (
        Parameter("source", "source", "scalar", scalar="u8", type=filter.RelativePositionSource),
        Parameter(
            "reference_frame_selector",
            "reference_frame_selector",
            "scalar",
            scalar="u8",
            type=filter.ReferenceFrame,
        ),
        Parameter(
            "reference_coordinates",
            "reference_coordinates",
            "array",
            scalar="double",
            elements=("x", "y", "z"),
        ),
    ),
    filter.ReferencePointLeverArmResponse: (
        Parameter(
            "ref_point_sel", "ref_point_sel", "scalar", scalar="u8", type=filter.ReferencePoint
        ),
        Parameter(
            "lever_arm_offset",
            "lever_arm_offset",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
        ),
    ),
    filter.MeasurementSpeedLeverArmResponse: (
        Parameter("source", "source", "scalar", scalar="u8"),
        Parameter(
            "lever_arm_offset",
            "lever_arm_offset",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
        ),
    ),
    filter.WheeledVehicleConstraintControlResponse: (
        Parameter("enable", "enable", "scalar", scalar="u8"),
    ),
    filter.GnssAntennaOffsetCalibrationControlResponse: (
        Parameter("enable", "enable", "scalar", scalar="u8"),
        Parameter("max_offset", "max_offset", "scalar", scalar="float", units=("m",)),
    ),
    gnss.ReceiverInfoEntry: (
        Parameter("receiver_id", "receiver_id", "scalar", scalar="u8"),
        Parameter("mip_data_descriptor_set", "mip_data_descriptor_set", "scalar", scalar="u8"),
        Parameter("description", "description", "text", scalar="char", length=32),
    ),
    gnss.ReceiverInfo: (),
    gnss.SignalConfiguration: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("gps_enable", "gps_enable", "scalar", scalar="u8", type=gnss.GpsSignals),
        Parameter(
            "glonass_enable", "glonass_enable", "scalar", scalar="u8", type=gnss.GlonassSignals
        ),
        Parameter(
            "galileo_enable", "galileo_enable", "scalar", scalar="u8", type=gnss.GalileoSignals
        ),
        Parameter("beidou_enable", "beidou_enable", "scalar", scalar="u8", type=gnss.BeidouSignals),
        Parameter("reserved", "reserved", "array", scalar="u8", length=4),
    ),
    gnss.SpartnConfiguration: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("enable", "enable", "scalar", scalar="u8"),
        Parameter("type", "type", "scalar", scalar="u8", type=gnss.SpartnConnection),
        Parameter("current_key_tow", "current_key_tow", "scalar", scalar="u32", units=("s",)),
        Parameter("current_key_week", "current_key_week", "scalar", scalar="u16", units=("week",)),
        Parameter("current_key", "current_key", "array", scalar="u8", length=32),
        Parameter("next_key_tow", "next_key_tow", "scalar", scalar="u32", units=("s",)),
        Parameter("next_key_week", "next_key_week", "scalar", scalar="u16", units=("week",)),
        Parameter("next_key", "next_key", "array", scalar="u8", length=32),
    ),
    gnss.ReceiverInfoResponse: (
        Parameter("num_receivers", "num_receivers", "counter", scalar="u8", counts="receiver_info"),
        Parameter(
            "receiver_info",
            "receiver_info",
            "array",
            length="num_receivers",
            type=gnss.ReceiverInfoEntry,
        ),
    ),
    gnss.SignalConfigurationResponse: (
        Parameter("gps_enable", "gps_enable", "scalar", scalar="u8", type=gnss.GpsSignals),
        Parameter(
            "glonass_enable", "glonass_enable", "scalar", scalar="u8", type=gnss.GlonassSignals
        ),
        Parameter(
            "galileo_enable", "galileo_enable", "scalar", scalar="u8", type=gnss.GalileoSignals
        ),
        Parameter("beidou_enable", "beidou_enable", "scalar", scalar="u8", type=gnss.BeidouSignals),
        Parameter("reserved", "reserved", "array", scalar="u8", length=4),
    ),
    gnss.SpartnConfigurationResponse: (
        Parameter("enable", "enable", "scalar", scalar="u8"),
        Parameter("type", "type", "scalar", scalar="u8", type=gnss.SpartnConnection),
        Parameter("current_key_tow", "current_key_tow", "scalar", scalar="u32", units=("s",)),
        Parameter("current_key_week", "current_key_week", "scalar", scalar="u16", units=("week",)),
        Parameter("current_key", "current_key", "array", scalar="u8", length=32),
        Parameter("next_key_tow", "next_key_tow", "scalar", scalar="u32", units=("s",)),
        Parameter("next_key_week", "next_key_week", "scalar", scalar="u16", units=("week",)),
        Parameter("next_key", "next_key", "array", scalar="u8", length=32),
    ),
    aiding.MeasurementTime: (
        Parameter("timebase", "timebase", "scalar", scalar="u8", type=aiding.Timebase),
        Parameter("reserved", "reserved", "scalar", scalar="u8"),
        Parameter("nanoseconds", "nanoseconds", "scalar", scalar="u64", units=("ns",)),
    ),
    aiding.FrameConfiguration: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("frame_id", "frame_id", "scalar", scalar="u8"),
        Parameter("format", "format", "scalar", scalar="u8", type=aiding.AidingFrameFormat),
        Parameter("tracking_enabled", "tracking_enabled", "scalar", scalar="bool"),
        Parameter(
            "translation",
            "translation",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
        ),
        Parameter(
            "rotation",
            "rotation",
            "switch",
            tag="format",
            cases={
                1: Parameter(
                    "euler",
                    "euler",
                    "array",
                    scalar="float",
                    elements=("x", "y", "z"),
                    units=("rad",),
                ),
                2: Parameter(
                    "quaternion",
                    "quaternion",
                    "array",
                    scalar="float",
                    elements=("w", "x", "y", "z"),
                    units=("1",),
                ),
            },
        ),
    ),
    aiding.EchoControl: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("mode", "mode", "scalar", scalar="u8", type=aiding.AidingEchoMode),
    ),
    aiding.EcefPosition: (
        Parameter("time", "time", "struct", type=aiding.MeasurementTime),
        Parameter("frame_id", "frame_id", "scalar", scalar="u8"),
        Parameter(
            "position", "position", "array", scalar="double", elements=("x", "y", "z"), units=("m",)
        ),
        Parameter(
            "uncertainty",
            "uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=aiding.AxisFlags),
    ),
    aiding.LlhPosition: (
        Parameter("time", "time", "struct", type=aiding.MeasurementTime),
        Parameter("frame_id", "frame_id", "scalar", scalar="u8"),
        Parameter("latitude", "latitude", "scalar", scalar="double", units=("deg",)),
        Parameter("longitude", "longitude", "scalar", scalar="double", units=("deg",)),
        Parameter("height", "height", "scalar", scalar="double", units=("m",)),
        Parameter(
            "uncertainty",
            "uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=aiding.LlhAxisFlags),
    ),
    aiding.HeightAboveEllipsoid: (
        Parameter("time", "time", "struct", type=aiding.MeasurementTime),
        Parameter("frame_id", "frame_id", "scalar", scalar="u8"),
        Parameter("height", "height", "scalar", scalar="float", units=("m",)),
        Parameter("uncertainty", "uncertainty", "scalar", scalar="float", units=("m",)),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16"),
    ),
    aiding.EcefVelocity: (
        Parameter("time", "time", "struct", type=aiding.MeasurementTime),
        Parameter("frame_id", "frame_id", "scalar", scalar="u8"),
        Parameter(
            "velocity",
            "velocity",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s",),
        ),
        Parameter(
            "uncertainty",
            "uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s",),
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=aiding.AxisFlags),
    ),
    aiding.NedVelocity: (
        Parameter("time", "time", "struct", type=aiding.MeasurementTime),
        Parameter("frame_id", "frame_id", "scalar", scalar="u8"),
        Parameter(
            "velocity",
            "velocity",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s",),
        ),
        Parameter(
            "uncertainty",
            "uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s",),
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=aiding.AxisFlags),
    ),
    aiding.BodyFrameVelocity: (
        Parameter("time", "time", "struct", type=aiding.MeasurementTime),
        Parameter("frame_id", "frame_id", "scalar", scalar="u8"),
        Parameter(
            "velocity",
            "velocity",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s",),
        ),
        Parameter(
            "uncertainty",
            "uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s",),
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=aiding.AxisFlags),
    ),
    aiding.TrueHeading: (
        Parameter("time", "time", "struct", type=aiding.MeasurementTime),
        Parameter("frame_id", "frame_id", "scalar", scalar="u8"),
        Parameter("heading", "heading", "scalar", scalar="float", units=("rad",)),
        Parameter("uncertainty", "uncertainty", "scalar", scalar="float", units=("rad",)),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16"),
    ),
    aiding.MagneticField: (
        Parameter("time", "time", "struct", type=aiding.MeasurementTime),
        Parameter("frame_id", "frame_id", "scalar", scalar="u8"),
        Parameter(
            "magnetic_field",
            "magnetic_field",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("gauss",),
        ),
        Parameter(
            "uncertainty",
            "uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("gauss",),
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=aiding.AxisFlags),
    ),
    aiding.Pressure: (
        Parameter("time", "time", "struct", type=aiding.MeasurementTime),
        Parameter("frame_id", "frame_id", "scalar", scalar="u8"),
        Parameter("pressure", "pressure", "scalar", scalar="float", units=("mbar",)),
        Parameter("uncertainty", "uncertainty", "scalar", scalar="float", units=("mbar",)),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16"),
    ),
    aiding.FrameConfigurationResponse: (
        Parameter("frame_id", "frame_id", "scalar", scalar="u8"),
        Parameter("format", "format", "scalar", scalar="u8", type=aiding.AidingFrameFormat),
        Parameter("tracking_enabled", "tracking_enabled", "scalar", scalar="bool"),
        Parameter(
            "translation",
            "translation",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
        ),
        Parameter(
            "rotation",
            "rotation",
            "switch",
            tag="format",
            cases={
                1: Parameter(
                    "euler",
                    "euler",
                    "array",
                    scalar="float",
                    elements=("x", "y", "z"),
                    units=("rad",),
                ),
                2: Parameter(
                    "quaternion",
                    "quaternion",
                    "array",
                    scalar="float",
                    elements=("w", "x", "y", "z"),
                    units=("1",),
                ),
            },
        ),
    ),
    aiding.EchoControlResponse: (
        Parameter("mode", "mode", "scalar", scalar="u8", type=aiding.AidingEchoMode),
    ),
    system.CommunicationMode: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("mode", "mode", "scalar", scalar="u8", type=system.ProtocolMode),
    ),
    system.CommunicationModeResponse: (
        Parameter("mode", "mode", "scalar", scalar="u8", type=system.ProtocolMode),
    ),
    sensor.ScaledAccel: (
        Parameter(
            "scaled_accel",
            "scaled_accel",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("g",),
        ),
    ),
    sensor.ScaledGyro: (
        Parameter(
            "scaled_gyro",
            "scaled_gyro",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("rad/s",),
        ),
    ),
    sensor.ScaledMag: (
        Parameter(
            "scaled_mag",
            "scaled_mag",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("gauss",),
        ),
    ),
    sensor.DeltaTheta: (
        Parameter(
            "delta_theta",
            "delta_theta",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("rad",),
        ),
    ),
    sensor.DeltaVelocity: (
        Parameter(
            "delta_velocity",
            "delta_velocity",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("g*s",),
        ),
    ),
    sensor.ComplementaryFilterOrientationMatrix: (
        Parameter(
            "m",
            "m",
            "array",
            scalar="float",
            elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"),
            units=("1",),
        ),
    ),
    sensor.ComplementaryFilterQuaternion: (
        Parameter("q", "q", "array", scalar="float", elements=("w", "x", "y", "z"), units=("1",)),
    ),
    sensor.ComplementaryFilterEulerAngles: (
        Parameter("roll", "roll", "scalar", scalar="float", units=("rad",)),
        Parameter("pitch", "pitch", "scalar", scalar="float", units=("rad",)),
        Parameter("yaw", "yaw", "scalar", scalar="float", units=("rad",)),
    ),
    sensor.ComplementaryFilterStabilizedNorthVector: (
        Parameter(
            "stabilized_mag",
            "stabilized_mag",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("gauss",),
        ),
    ),
    sensor.ComplementaryFilterStabilizedUpVector: (
        Parameter(
            "stabilized_accel",
            "stabilized_accel",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("g",),
        ),
    ),
    sensor.GpsTimestamp: (
        Parameter("tow", "tow", "scalar", scalar="double", units=("s",)),
        Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",)),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=types.SensorGpsTimestampFlags
        ),
    ),
    sensor.TemperatureStatistics: (
        Parameter("min_temp", "min_temp", "scalar", scalar="float", units=("degC",)),
        Parameter("max_temp", "max_temp", "scalar", scalar="float", units=("degC",)),
        Parameter("mean_temp", "mean_temp", "scalar", scalar="float", units=("degC",)),
    ),
    sensor.ScaledPressure: (
        Parameter("scaled_pressure", "scaled_pressure", "scalar", scalar="float", units=("mbar",)),
    ),
    sensor.OverrangeStatus: (
        Parameter("status", "status", "scalar", scalar="u16", type=sensor.OverrangeFlags),
    ),
    sensor.Odometer: (
        Parameter("speed", "speed", "scalar", scalar="float", units=("m/s",)),
        Parameter("uncertainty", "uncertainty", "scalar", scalar="float", units=("m/s",)),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=sensor.OdometerFlags),
    ),
    filter_data.LlhPosition: (
        Parameter("latitude", "latitude", "scalar", scalar="double", units=("deg",)),
        Parameter("longitude", "longitude", "scalar", scalar="double", units=("deg",)),
        Parameter("ellipsoid_height", "ellipsoid_height", "scalar", scalar="double", units=("m",)),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.VelocityNed: (
        Parameter("north", "north", "scalar", scalar="float", units=("m/s",)),
        Parameter("east", "east", "scalar", scalar="float", units=("m/s",)),
        Parameter("down", "down", "scalar", scalar="float", units=("m/s",)),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.AttitudeQuaternion: (
        Parameter("q", "q", "array", scalar="float", elements=("w", "x", "y", "z"), units=("1",)),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.AttitudeDcm: (
        Parameter(
            "dcm",
            "dcm",
            "array",
            scalar="float",
            elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"),
            units=("1",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.EulerAngles: (
        Parameter("roll", "roll", "scalar", scalar="float", units=("rad",)),
        Parameter("pitch", "pitch", "scalar", scalar="float", units=("rad",)),
        Parameter("yaw", "yaw", "scalar", scalar="float", units=("rad",)),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.GyroBias: (
        Parameter(
            "bias", "bias", "array", scalar="float", elements=("x", "y", "z"), units=("rad/s",)
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.AccelBias: (
        Parameter(
            "bias", "bias", "array", scalar="float", elements=("x", "y", "z"), units=("m/s^2",)
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.LlhPositionUncertainty: (
        Parameter("north", "north", "scalar", scalar="float", units=("m",)),
        Parameter("east", "east", "scalar", scalar="float", units=("m",)),
        Parameter("down", "down", "scalar", scalar="float", units=("m",)),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.NedVelocityUncertainty: (
        Parameter("north", "north", "scalar", scalar="float", units=("m/s",)),
        Parameter("east", "east", "scalar", scalar="float", units=("m/s",)),
        Parameter("down", "down", "scalar", scalar="float", units=("m/s",)),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.EulerAnglesUncertainty: (
        Parameter("roll", "roll", "scalar", scalar="float", units=("rad",)),
        Parameter("pitch", "pitch", "scalar", scalar="float", units=("rad",)),
        Parameter("yaw", "yaw", "scalar", scalar="float", units=("rad",)),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.GyroBiasUncertainty: (
        Parameter(
            "bias_uncert",
            "bias_uncert",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("rad/s",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.AccelBiasUncertainty: (
        Parameter(
            "bias_uncert",
            "bias_uncert",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s^2",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.LinearAccel: (
        Parameter(
            "accel", "accel", "array", scalar="float", elements=("x", "y", "z"), units=("m/s^2",)
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.CompAngularRate: (
        Parameter(
            "gyro", "gyro", "array", scalar="float", elements=("x", "y", "z"), units=("rad/s",)
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.Wgs84LocalGravityMagnitude: (
        Parameter(
            "gravity_magnitude", "gravity_magnitude", "scalar", scalar="float", units=("m/s^2",)
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.Status: (
        Parameter("filter_state", "filter_state", "scalar", scalar="u16"),
        Parameter("dynamics_mode", "dynamics_mode", "scalar", scalar="u16"),
        Parameter("status_flags", "status_flags", "scalar", scalar="u16"),
    ),
    filter_data.Timestamp: (
        Parameter("tow", "tow", "scalar", scalar="double", units=("s",)),
        Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",)),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.QuaternionAttitudeUncertainty: (
        Parameter("q", "q", "array", scalar="float", elements=("w", "x", "y", "z"), units=("1",)),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.GravityVector: (
        Parameter(
            "gravity",
            "gravity",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s^2",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.HeadingUpdateSourceState: (
        Parameter("heading", "heading", "scalar", scalar="float", units=("rad",)),
        Parameter(
            "heading_uncertainty", "heading_uncertainty", "scalar", scalar="float", units=("rad",)
        ),
        Parameter("source", "source", "scalar", scalar="u16", type=filter_data.HeadingSourceFlags),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.MagneticModel: (
        Parameter("intensity_north", "intensity_north", "scalar", scalar="float", units=("gauss",)),
        Parameter("intensity_east", "intensity_east", "scalar", scalar="float", units=("gauss",)),
        Parameter("intensity_down", "intensity_down", "scalar", scalar="float", units=("gauss",)),
        Parameter("inclination", "inclination", "scalar", scalar="float", units=("rad",)),
        Parameter("declination", "declination", "scalar", scalar="float", units=("rad",)),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.CompensatedAcceleration: (
        Parameter(
            "accel", "accel", "array", scalar="float", elements=("x", "y", "z"), units=("m/s^2",)
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.PressureAltitude: (
        Parameter("pressure_altitude", "pressure_altitude", "scalar", scalar="float", units=("m",)),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.MultiAntennaOffsetCorrection: (
        Parameter("receiver_id", "receiver_id", "scalar", scalar="u8"),
        Parameter(
            "offset", "offset", "array", scalar="float", elements=("x", "y", "z"), units=("m",)
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.MultiAntennaOffsetCorrectionUncertainty: (
        Parameter("receiver_id", "receiver_id", "scalar", scalar="u8"),
        Parameter(
            "offset_uncert",
            "offset_uncert",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.EcefPositionUncertainty: (
        Parameter(
            "pos_uncertainty",
            "pos_uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.EcefVelocityUncertainty: (
        Parameter(
            "vel_uncertainty",
            "vel_uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.EcefPosition: (
        Parameter(
            "position_ecef",
            "position_ecef",
            "array",
            scalar="double",
            elements=("x", "y", "z"),
            units=("m",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.EcefVelocity: (
        Parameter(
            "velocity_ecef",
            "velocity_ecef",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.NedRelativePosition: (
        Parameter(
            "relative_position",
            "relative_position",
            "array",
            scalar="double",
            elements=("x", "y", "z"),
            units=("m",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.GnssPositionAidingStatus: (
        Parameter("receiver_id", "receiver_id", "scalar", scalar="u8"),
        Parameter("time_of_week", "time_of_week", "scalar", scalar="float", units=("s",)),
        Parameter("status", "status", "scalar", scalar="u16", type=filter_data.GnssAidingStatus),
        Parameter("reserved", "reserved", "array", scalar="u8", length=8),
    ),
    filter_data.AidingMeasurementSummary: (
        Parameter("time_of_week", "time_of_week", "scalar", scalar="float", units=("s",)),
        Parameter("source", "source", "scalar", scalar="u8"),
        Parameter("type", "type", "scalar", scalar="u8", type=filter_data.AidingMeasurementType),
        Parameter(
            "indicator",
            "indicator",
            "scalar",
            scalar="u8",
            type=filter_data.AidingMeasurementIndicator,
        ),
    ),
    filter_data.OdometerScaleFactorError: (
        Parameter(
            "scale_factor_error", "scale_factor_error", "scalar", scalar="float", units=("1",)
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.OdometerScaleFactorErrorUncertainty: (
        Parameter(
            "scale_factor_error_uncertainty",
            "scale_factor_error_uncertainty",
            "scalar",
            scalar="float",
            units=("1",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.GnssDualAntennaStatus: (
        Parameter("time_of_week", "time_of_week", "scalar", scalar="float", units=("s",)),
        Parameter("heading", "heading", "scalar", scalar="float", units=("rad",)),
        Parameter("heading_unc", "heading_unc", "scalar", scalar="float", units=("rad",)),
        Parameter(
            "fix_type", "fix_type", "scalar", scalar="u8", type=filter_data.DualAntennaFixType
        ),
        Parameter(
            "status_flags",
            "status_flags",
            "scalar",
            scalar="u16",
            type=filter_data.DualAntennaStatusFlags,
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.AidingFrameConfigurationError: (
        Parameter("frame_id", "frame_id", "scalar", scalar="u8"),
        Parameter(
            "translation",
            "translation",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
        ),
        Parameter(
            "attitude",
            "attitude",
            "array",
            scalar="float",
            elements=("w", "x", "y", "z"),
            units=("1",),
        ),
    ),
    filter_data.AidingFrameConfigurationErrorUncertainty: (
        Parameter("frame_id", "frame_id", "scalar", scalar="u8"),
        Parameter(
            "translation_unc",
            "translation_unc",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
        ),
        Parameter(
            "attitude_unc",
            "attitude_unc",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("rad",),
        ),
    ),
    gnss_1.GnssLlhPosition: (
        Parameter("latitude", "latitude", "scalar", scalar="double", units=("deg",)),
        Parameter("longitude", "longitude", "scalar", scalar="double", units=("deg",)),
        Parameter("ellipsoid_height", "ellipsoid_height", "scalar", scalar="double", units=("m",)),
        Parameter("msl_height", "msl_height", "scalar", scalar="double", units=("m",)),
        Parameter(
            "horizontal_accuracy", "horizontal_accuracy", "scalar", scalar="float", units=("m",)
        ),
        Parameter("vertical_accuracy", "vertical_accuracy", "scalar", scalar="float", units=("m",)),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.GnssLlhPositionFlags
        ),
    ),
    gnss_1.GnssEcefPosition: (
        Parameter("x", "x", "array", scalar="double", elements=("x", "y", "z"), units=("m",)),
        Parameter("x_accuracy", "x_accuracy", "scalar", scalar="float", units=("m",)),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.GnssEcefPositionFlags
        ),
    ),
    gnss_1.NedVelocity: (
        Parameter("v", "v_", "array", scalar="float", elements=("x", "y", "z"), units=("m/s",)),
        Parameter("speed", "speed", "scalar", scalar="float", units=("m/s",)),
        Parameter("ground_speed", "ground_speed", "scalar", scalar="float", units=("m/s",)),
        Parameter("heading", "heading", "scalar", scalar="float", units=("deg",)),
        Parameter("speed_accuracy", "speed_accuracy", "scalar", scalar="float", units=("m/s",)),
        Parameter("heading_accuracy", "heading_accuracy", "scalar", scalar="float", units=("deg",)),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.NedVelocityFlags
        ),
    ),
    gnss_1.GnssEcefVelocity: (
        Parameter("v", "v_", "array", scalar="float", elements=("x", "y", "z"), units=("m/s",)),
        Parameter("v_accuracy", "v_accuracy", "scalar", scalar="float", units=("m/s",)),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.GnssEcefVelocityFlags
        ),
    ),
    gnss_1.Dop: (
        Parameter("gdop", "gdop", "scalar", scalar="float", units=("1",)),
        Parameter("pdop", "pdop", "scalar", scalar="float", units=("1",)),
        Parameter("hdop", "hdop", "scalar", scalar="float", units=("1",)),
        Parameter("vdop", "vdop", "scalar", scalar="float", units=("1",)),
        Parameter("tdop", "tdop", "scalar", scalar="float", units=("1",)),
        Parameter("ndop", "ndop", "scalar", scalar="float", units=("1",)),
        Parameter("edop", "edop", "scalar", scalar="float", units=("1",)),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.DopFlags),
    ),
    gnss_1.UtcTime: (
        Parameter("year", "year", "scalar", scalar="u16"),
        Parameter("month", "month", "scalar", scalar="u8"),
        Parameter("day", "day", "scalar", scalar="u8"),
        Parameter("hour", "hour", "scalar", scalar="u8"),
        Parameter("min", "min", "scalar", scalar="u8"),
        Parameter("sec", "sec", "scalar", scalar="u8", units=("s",)),
        Parameter("msec", "msec", "scalar", scalar="u32", units=("ms",)),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.UtcTimeFlags),
    ),
    gnss_1.GpsTime: (
        Parameter("tow", "tow", "scalar", scalar="double", units=("s",)),
        Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",)),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.GpsTimeFlags),
    ),
    gnss_1.FixInfo: (
        Parameter("fix_type", "fix_type", "scalar", scalar="u8", type=types.GnssFixType),
        Parameter("num_sv", "num_sv", "scalar", scalar="u8", units=("1",)),
        Parameter("fix_flags", "fix_flags", "scalar", scalar="u16", type=gnss_1.FixFlags),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.FixInfoFlags),
    ),
    gnss_1.GnssHardwareStatus: (
        Parameter(
            "receiver_state", "receiver_state", "scalar", scalar="u8", type=gnss_1.ReceiverState
        ),
        Parameter(
            "antenna_state", "antenna_state", "scalar", scalar="u8", type=gnss_1.AntennaState
        ),
        Parameter(
            "antenna_power", "antenna_power", "scalar", scalar="u8", type=gnss_1.AntennaPower
        ),
        Parameter(
            "valid_flags",
            "valid_flags",
            "scalar",
            scalar="u16",
            type=gnss_1.GnssHardwareStatusFlags,
        ),
    ),
    gnss_1.ClockInfo2: (
        Parameter("bias", "bias", "scalar", scalar="double", units=("s",)),
        Parameter("drift", "drift", "scalar", scalar="double", units=("s/s",)),
        Parameter(
            "bias_accuracy_estimate",
            "bias_accuracy_estimate",
            "scalar",
            scalar="double",
            units=("s",),
        ),
        Parameter(
            "drift_accuracy_estimate",
            "drift_accuracy_estimate",
            "scalar",
            scalar="double",
            units=("s/s",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.ClockInfo2Flags
        ),
    ),
    gnss_1.GpsLeapSeconds: (
        Parameter("leap_seconds", "leap_seconds", "scalar", scalar="u8", units=("s",)),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.GpsLeapSecondsFlags
        ),
    ),
    gnss_1.SbasInfo: (
        Parameter("time_of_week", "time_of_week", "scalar", scalar="double", units=("s",)),
        Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",)),
        Parameter("sbas_system", "sbas_system", "scalar", scalar="u8", type=gnss_1.SbasSystem),
        Parameter("sbas_id", "sbas_id", "scalar", scalar="u8"),
        Parameter("count", "count", "scalar", scalar="u8", units=("1",)),
        Parameter("sbas_status", "sbas_status", "scalar", scalar="u8", type=gnss_1.SbasStatus),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.SbasInfoFlags),
    ),
    gnss_1.SatelliteStatus: (
        Parameter("index", "index", "scalar", scalar="u8"),
        Parameter("count", "count", "scalar", scalar="u8"),
        Parameter("time_of_week", "time_of_week", "scalar", scalar="double", units=("s",)),
        Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",)),
        Parameter("gnss_id", "gnss_id", "scalar", scalar="u8", type=types.GnssConstellation),
        Parameter("satellite_id", "satellite_id", "scalar", scalar="u8"),
        Parameter("elevation", "elevation", "scalar", scalar="float", units=("deg",)),
        Parameter("azimuth", "azimuth", "scalar", scalar="float", units=("deg",)),
        Parameter("health", "health", "scalar", scalar="bool"),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.SatelliteStatusFlags
        ),
    ),
    gnss_1.Raw: (
        Parameter("index", "index", "scalar", scalar="u8"),
        Parameter("count", "count", "scalar", scalar="u8"),
        Parameter("time_of_week", "time_of_week", "scalar", scalar="double", units=("s",)),
        Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",)),
        Parameter("receiver_id", "receiver_id", "scalar", scalar="u16"),
        Parameter("tracking_channel", "tracking_channel", "scalar", scalar="u8"),
        Parameter("gnss_id", "gnss_id", "scalar", scalar="u8", type=types.GnssConstellation),
        Parameter("satellite_id", "satellite_id", "scalar", scalar="u8"),
        Parameter("signal_id", "signal_id", "scalar", scalar="u8", type=types.GnssSignal),
        Parameter("signal_strength", "signal_strength", "scalar", scalar="float", units=("dB-Hz",)),
        Parameter("quality", "quality", "scalar", scalar="u8", type=gnss_1.SignalQuality),
        Parameter("pseudorange", "pseudorange", "scalar", scalar="double", units=("m",)),
        Parameter("carrier_phase", "carrier_phase", "scalar", scalar="double", units=("cycle",)),
        Parameter("doppler", "doppler", "scalar", scalar="float", units=("Hz",)),
        Parameter("range_uncert", "range_uncert", "scalar", scalar="float", units=("m",)),
        Parameter("phase_uncert", "phase_uncert", "scalar", scalar="float", units=("cycle",)),
        Parameter("doppler_uncert", "doppler_uncert", "scalar", scalar="float", units=("Hz",)),
        Parameter("lock_time", "lock_time", "scalar", scalar="float", units=("s",)),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.RawFlags),
    ),
    gnss_1.GpsEphemeris: (
        Parameter("index", "index", "scalar", scalar="u8"),
        Parameter("count", "count", "scalar", scalar="u8"),
        Parameter("time_of_week", "time_of_week", "scalar", scalar="double", units=("s",)),
        Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",)),
        Parameter("satellite_id", "satellite_id", "scalar", scalar="u8"),
        Parameter("health", "health", "scalar", scalar="u8"),
        Parameter("iodec", "iodec", "scalar", scalar="u8"),
        Parameter("iode", "iode", "scalar", scalar="u8"),
        Parameter("t_oc", "t_oc", "scalar", scalar="double", units=("s",)),
        Parameter("af0", "af0", "scalar", scalar="double", units=("s",)),
        Parameter("af1", "af1", "scalar", scalar="double", units=("s/s",)),
        Parameter("af2", "af2", "scalar", scalar="double", units=("s/s^2",)),
        Parameter("t_gd", "t_gd", "scalar", scalar="double", units=("s",)),
        Parameter("isc_l1ca", "isc_l1ca", "scalar", scalar="double", units=("s",)),
        Parameter("isc_l2c", "isc_l2c", "scalar", scalar="double", units=("s",)),
        Parameter("t_oe", "t_oe", "scalar", scalar="double", units=("s",)),
        Parameter("a", "a", "scalar", scalar="double", units=("m",)),
        Parameter("a_dot", "a_dot", "scalar", scalar="double", units=("m/s",)),
        Parameter("mean_anomaly", "mean_anomaly", "scalar", scalar="double", units=("rad",)),
        Parameter(
            "delta_mean_motion", "delta_mean_motion", "scalar", scalar="double", units=("rad/s",)
        ),
        Parameter(
            "delta_mean_motion_dot",
            "delta_mean_motion_dot",
            "scalar",
            scalar="double",
            units=("rad/s^2",),
        ),
        Parameter("eccentricity", "eccentricity", "scalar", scalar="double", units=("1",)),
        Parameter(
            "argument_of_perigee", "argument_of_perigee", "scalar", scalar="double", units=("rad",)
        ),
        Parameter("omega", "omega", "scalar", scalar="double", units=("rad",)),
        Parameter("omega_dot", "omega_dot", "scalar", scalar="double", units=("rad/s",)),
        Parameter("inclination", "inclination", "scalar", scalar="double", units=("rad",)),
        Parameter(
            "inclination_dot", "inclination_dot", "scalar", scalar="double", units=("rad/s",)
        ),
        Parameter("c_ic", "c_ic", "scalar", scalar="double", units=("rad",)),
        Parameter("c_is", "c_is", "scalar", scalar="double", units=("rad",)),
        Parameter("c_uc", "c_uc", "scalar", scalar="double", units=("rad",)),
        Parameter("c_us", "c_us", "scalar", scalar="double", units=("rad",)),
        Parameter("c_rc", "c_rc", "scalar", scalar="double", units=("m",)),
        Parameter("c_rs", "c_rs", "scalar", scalar="double", units=("m",)),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.EphemerisFlags),
    ),
    gnss_1.GlonassEphemeris: (
        Parameter("index", "index", "scalar", scalar="u8"),
        Parameter("count", "count", "scalar", scalar="u8"),
        Parameter("time_of_week", "time_of_week", "scalar", scalar="double", units=("s",)),
        Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",)),
        Parameter("satellite_id", "satellite_id", "scalar", scalar="u8"),
        Parameter("freq_number", "freq_number", "scalar", scalar="s8"),
        Parameter("tk", "tk", "scalar", scalar="u32", units=("s",)),
        Parameter("tb", "tb", "scalar", scalar="u32", units=("s",)),
        Parameter("sat_type", "sat_type", "scalar", scalar="u8", type=gnss_1.GlonassSatelliteType),
        Parameter("gamma", "gamma", "scalar", scalar="double", units=("1",)),
        Parameter("tau_n", "tau_n", "scalar", scalar="double", units=("s",)),
        Parameter("x", "x", "array", scalar="double", elements=("x", "y", "z"), units=("m",)),
        Parameter("v", "v_", "array", scalar="float", elements=("x", "y", "z"), units=("m/s",)),
        Parameter("a", "a", "array", scalar="float", elements=("x", "y", "z"), units=("m/s^2",)),
        Parameter("health", "health", "scalar", scalar="u8"),
        Parameter("p", "p", "scalar", scalar="u8"),
        Parameter("nt", "nt", "scalar", scalar="u8", units=("day",)),
        Parameter("delta_tau_n", "delta_tau_n", "scalar", scalar="float", units=("s",)),
        Parameter("ft", "ft", "scalar", scalar="u8"),
        Parameter("en", "en", "scalar", scalar="u8", units=("day",)),
        Parameter("p1", "p1", "scalar", scalar="u8", units=("min",)),
        Parameter("p2", "p2", "scalar", scalar="u8"),
        Parameter("p3", "p3", "scalar", scalar="u8", units=("1",)),
        Parameter("p4", "p4", "scalar", scalar="u8"),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.GlonassEphemerisFlags
        ),
    ),
    gnss_1.GalileoEphemeris: (
        Parameter("index", "index", "scalar", scalar="u8"),
        Parameter("count", "count", "scalar", scalar="u8"),
        Parameter("time_of_week", "time_of_week", "scalar", scalar="double", units=("s",)),
        Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",)),
        Parameter("satellite_id", "satellite_id", "scalar", scalar="u8"),
        Parameter("health", "health", "scalar", scalar="u8"),
        Parameter("iodec", "iodec", "scalar", scalar="u8"),
        Parameter("iode", "iode", "scalar", scalar="u8"),
        Parameter("t_oc", "t_oc", "scalar", scalar="double", units=("s",)),
        Parameter("af0", "af0", "scalar", scalar="double", units=("s",)),
        Parameter("af1", "af1", "scalar", scalar="double", units=("s/s",)),
        Parameter("af2", "af2", "scalar", scalar="double", units=("s/s^2",)),
        Parameter("t_gd", "t_gd", "scalar", scalar="double", units=("s",)),
        Parameter("isc_l1ca", "isc_l1ca", "scalar", scalar="double", units=("s",)),
        Parameter("isc_l2c", "isc_l2c", "scalar", scalar="double", units=("s",)),
        Parameter("t_oe", "t_oe", "scalar", scalar="double", units=("s",)),
        Parameter("a", "a", "scalar", scalar="double", units=("m",)),
        Parameter("a_dot", "a_dot", "scalar", scalar="double", units=("m/s",)),
        Parameter("mean_anomaly", "mean_anomaly", "scalar", scalar="double", units=("rad",)),
        Parameter(
            "delta_mean_motion", "delta_mean_motion", "scalar", scalar="double", units=("rad/s",)
        ),
        Parameter(
            "delta_mean_motion_dot",
            "delta_mean_motion_dot",
            "scalar",
            scalar="double",
            units=("rad/s^2",),
        ),
        Parameter("eccentricity", "eccentricity", "scalar", scalar="double", units=("1",)),
        Parameter(
            "argument_of_perigee", "argument_of_perigee", "scalar", scalar="double", units=("rad",)
        ),
        Parameter("omega", "omega", "scalar", scalar="double", units=("rad",)),
        Parameter("omega_dot", "omega_dot", "scalar", scalar="double", units=("rad/s",)),
        Parameter("inclination", "inclination", "scalar", scalar="double", units=("rad",)),
        Parameter(
            "inclination_dot", "inclination_dot", "scalar", scalar="double", units=("rad/s",)
        ),
        Parameter("c_ic", "c_ic", "scalar", scalar="double", units=("rad",)),
        Parameter("c_is", "c_is", "scalar", scalar="double", units=("rad",)),
        Parameter("c_uc", "c_uc", "scalar", scalar="double", units=("rad",)),
        Parameter("c_us", "c_us", "scalar", scalar="double", units=("rad",)),
        Parameter("c_rc", "c_rc", "scalar", scalar="double", units=("m",)),
        Parameter("c_rs", "c_rs", "scalar", scalar="double", units=("m",)),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.EphemerisFlags),
    ),
    gnss_1.BeidouEphemeris: (
        Parameter("index", "index", "scalar", scalar="u8"),
        Parameter("count", "count", "scalar", scalar="u8"),
        Parameter("time_of_week", "time_of_week", "scalar", scalar="double", units=("s",)),
        Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",)),
        Parameter("satellite_id", "satellite_id", "scalar", scalar="u8"),
        Parameter("health", "health", "scalar", scalar="u8"),
        Parameter("iodec", "iodec", "scalar", scalar="u8"),
        Parameter("iode", "iode", "scalar", scalar="u8"),
        Parameter("t_oc", "t_oc", "scalar", scalar="double", units=("s",)),
        Parameter("af0", "af0", "scalar", scalar="double", units=("s",)),
        Parameter("af1", "af1", "scalar", scalar="double", units=("s/s",)),
        Parameter("af2", "af2", "scalar", scalar="double", units=("s/s^2",)),
        Parameter("t_gd", "t_gd", "scalar", scalar="double", units=("s",)),
        Parameter("isc_l1ca", "isc_l1ca", "scalar", scalar="double", units=("s",)),
        Parameter("isc_l2c", "isc_l2c", "scalar", scalar="double", units=("s",)),
        Parameter("t_oe", "t_oe", "scalar", scalar="double", units=("s",)),
        Parameter("a", "a", "scalar", scalar="double", units=("m",)),
        Parameter("a_dot", "a_dot", "scalar", scalar="double", units=("m/s",)),
        Parameter("mean_anomaly", "mean_anomaly", "scalar", scalar="double", units=("rad",)),
        Parameter(
            "delta_mean_motion", "delta_mean_motion", "scalar", scalar="double", units=("rad/s",)
        ),
        Parameter(
            "delta_mean_motion_dot",
            "delta_mean_motion_dot",
            "scalar",
            scalar="double",
            units=("rad/s^2",),
        ),
        Parameter("eccentricity", "eccentricity", "scalar", scalar="double", units=("1",)),
        Parameter(
            "argument_of_perigee", "argument_of_perigee", "scalar", scalar="double", units=("rad",)
        ),
        Parameter("omega", "omega", "scalar", scalar="double", units=("rad",)),
        Parameter("omega_dot", "omega_dot", "scalar", scalar="double", units=("rad/s",)),
        Parameter("inclination", "inclination", "scalar", scalar="double", units=("rad",)),
        Parameter(
            "inclination_dot", "inclination_dot", "scalar", scalar="double", units=("rad/s",)
        ),
        Parameter("c_ic", "c_ic", "scalar", scalar="double", units=("rad",)),
        Parameter("c_is", "c_is", "scalar", scalar="double", units=("rad",)),
        Parameter("c_uc", "c_uc", "scalar", scalar="double", units=("rad",)),
        Parameter("c_us", "c_us", "scalar", scalar="double", units=("rad",)),
        Parameter("c_rc", "c_rc", "scalar", scalar="double", units=("m",)),
        Parameter("c_rs", "c_rs", "scalar", scalar="double", units=("m",)),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.EphemerisFlags),
    ),
    gnss_corrections.BaseStationInfo: (
        Parameter("time_of_week", "time_of_week", "scalar", scalar="double", units=("s",)),
        Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",)),
        Parameter(
            "ecef_pos", "ecef_pos", "array", scalar="double", elements=("x", "y", "z"), units=("m",)
        ),
        Parameter("height", "height", "scalar", scalar="float", units=("m",)),
        Parameter("station_id", "station_id", "scalar", scalar="u16"),
        Parameter(
            "indicators",
            "indicators",
            "scalar",
            scalar="u16",
            type=gnss_corrections.BaseStationIndicators,
        ),
        Parameter(
            "valid_flags",
            "valid_flags",
            "scalar",
            scalar="u16",
            type=gnss_corrections.BaseStationInfoFlags,
        ),
    ),
    gnss_corrections.RtkCorrectionsStatus: (
        Parameter("time_of_week", "time_of_week", "scalar", scalar="double", units=("s",)),
        Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",)),
        Parameter(
            "epoch_status",
            "epoch_status",
            "scalar",
            scalar="u16",
            type=gnss_corrections.RtkEpochStatus,
        ),
        Parameter("dongle_status", "dongle_status", "scalar", scalar="u32"),
        Parameter(
            "gps_correction_latency",
            "gps_correction_latency",
            "scalar",
            scalar="float",
            units=("s",),
        ),
        Parameter(
            "glonass_correction_latency",
            "glonass_correction_latency",
            "scalar",
            scalar="float",
            units=("s",),
        ),
        Parameter(
            "galileo_correction_latency",
            "galileo_correction_latency",
            "scalar",
            scalar="float",
            units=("s",),
        ),
        Parameter(
            "beidou_correction_latency",
            "beidou_correction_latency",
            "scalar",
            scalar="float",
            units=("s",),
        ),
        Parameter("reserved", "reserved", "array", scalar="u32", length=4),
        Parameter(
            "valid_flags",
            "valid_flags",
            "scalar",
            scalar="u16",
            type=gnss_corrections.RtkCorrectionsStatusFlags,
        ),
    ),
    system_data.BuiltInTest: (Parameter("result", "result", "array", scalar="u8", length=16),),
    system_data.TimeSyncStatus: (
        Parameter("time_sync", "time_sync", "scalar", scalar="bool"),
        Parameter("last_pps_rcvd", "last_pps_rcvd", "scalar", scalar="u8", units=("s",)),
    ),
    system_data.GpioState: (
        Parameter("states", "states", "scalar", scalar="u8", type=system_data.GpioPinStates),
    ),
    shared.EventSource: (Parameter("trigger_id", "trigger_id", "scalar", scalar="u8"),),
    shared.GpsTimestamp: (
        Parameter("tow", "tow", "scalar", scalar="double", units=("s",)),
        Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",)),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=shared.GpsTimestampFlags
        ),
    ),
    shared.DeltaTime: (Parameter("seconds", "seconds", "scalar", scalar="double", units=("s",)),),
    shared.ReferenceTimestamp: (
        Parameter("nanoseconds", "nanoseconds", "scalar", scalar="u64", units=("ns",)),
    ),
    shared.ReferenceTimeDelta: (
        Parameter("dt_nanos", "dt_nanos", "scalar", scalar="u64", units=("ns",)),
    ),
    shared.ExternalTimestamp: (
        Parameter("nanoseconds", "nanoseconds", "scalar", scalar="u64", units=("ns",)),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=shared.ExternalTimestampFlags
        ),
    ),
    shared.ExternalTimeDelta: (
        Parameter("dt_nanos", "dt_nanos", "scalar", scalar="u64", units=("ns",)),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=shared.ExternalTimeDeltaFlags
        ),
    ),
}

PARAMETERS[gnss_2.GnssLlhPosition] = PARAMETERS[gnss_1.GnssLlhPosition]
PARAMETERS[gnss_2.GnssEcefPosition] = PARAMETERS[gnss_1.GnssEcefPosition]
PARAMETERS[gnss_2.NedVelocity] = PARAMETERS[gnss_1.NedVelocity]
PARAMETERS[gnss_2.GnssEcefVelocity] = PARAMETERS[gnss_1.GnssEcefVelocity]
PARAMETERS[gnss_2.Dop] = PARAMETERS[gnss_1.Dop]
PARAMETERS[gnss_2.UtcTime] = PARAMETERS[gnss_1.UtcTime]
PARAMETERS[gnss_2.GpsTime] = PARAMETERS[gnss_1.GpsTime]
PARAMETERS[gnss_2.FixInfo] = PARAMETERS[gnss_1.FixInfo]
PARAMETERS[gnss_2.GnssHardwareStatus] = PARAMETERS[gnss_1.GnssHardwareStatus]
PARAMETERS[gnss_2.ClockInfo2] = PARAMETERS[gnss_1.ClockInfo2]
PARAMETERS[gnss_2.GpsLeapSeconds] = PARAMETERS[gnss_1.GpsLeapSeconds]
PARAMETERS[gnss_2.SbasInfo] = PARAMETERS[gnss_1.SbasInfo]
PARAMETERS[gnss_2.SatelliteStatus] = PARAMETERS[gnss_1.SatelliteStatus]
PARAMETERS[gnss_2.Raw] = PARAMETERS[gnss_1.Raw]
PARAMETERS[gnss_2.GpsEphemeris] = PARAMETERS[gnss_1.GpsEphemeris]
PARAMETERS[gnss_2.GlonassEphemeris] = PARAMETERS[gnss_1.GlonassEphemeris]
PARAMETERS[gnss_2.GalileoEphemeris] = PARAMETERS[gnss_1.GalileoEphemeris]
PARAMETERS[gnss_2.BeidouEphemeris] = PARAMETERS[gnss_1.BeidouEphemeris]
PARAMETERS[gnss_external.GnssLlhPosition] = PARAMETERS[gnss_1.GnssLlhPosition]
PARAMETERS[gnss_external.NedVelocity] = PARAMETERS[gnss_1.NedVelocity]
PARAMETERS[gnss_external.UtcTime] = PARAMETERS[gnss_1.UtcTime]
PARAMETERS[gnss_external.FixInfo] = PARAMETERS[gnss_1.FixInfo]
PARAMETERS[gnss_external.SatelliteStatus] = PARAMETERS[gnss_1.SatelliteStatus]
