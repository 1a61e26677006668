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
    gnss_data,
    gnss_external,
    gnss_external_2,
    mip_3dm,
    protocol,
    rtk,
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
        Parameter("pin", "pin", "scalar", scalar="u8", minimum=1),
        Parameter("mode", "mode", "scalar", scalar="u8", type=types.EventTriggerGpioMode),
    ),
    types.EventThresholdWindow: (
        Parameter("low_threshold", "low_threshold", "scalar", scalar="double"),
        Parameter("high_threshold", "high_threshold", "scalar", scalar="double"),
    ),
    types.EventThresholdInterval: (
        Parameter("interval_threshold", "interval_threshold", "scalar", scalar="double"),
        Parameter("interval", "interval", "scalar", scalar="double"),
    ),
    types.EventTriggerThreshold: (
        Parameter("descriptor_set", "descriptor_set", "scalar", scalar="u8"),
        Parameter("field_descriptor", "field_descriptor", "scalar", scalar="u8"),
        Parameter("parameter_id", "parameter_id", "scalar", scalar="u8", minimum=1),
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
        Parameter("pin", "pin", "scalar", scalar="u8", minimum=1),
        Parameter("mode", "mode", "scalar", scalar="u8", type=types.EventActionGpioMode),
    ),
    types.EventActionMessage: (
        Parameter("descriptor_set", "descriptor_set", "scalar", scalar="u8"),
        Parameter("decimation", "decimation", "scalar", scalar="u16"),
        Parameter(
            "num_fields",
            "num_fields",
            "counter",
            scalar="u8",
            counts="descriptors",
            minimum=0,
            maximum=12,
        ),
        Parameter("descriptors", "descriptors", "array", scalar="u8", length="num_fields"),
    ),
    types.NmeaMessage: (
        Parameter("message_id", "message_id", "scalar", scalar="u8", type=types.NmeaMessageId),
        Parameter("talker_id", "talker_id", "scalar", scalar="u8", type=types.NmeaTalkerId),
        Parameter("source_descriptor_set", "source_descriptor_set", "scalar", scalar="u8"),
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
    base.SetIdle: (),
    base.GetDeviceInfo: (),
    base.GetDeviceDescriptors: (),
    base.BuiltInTest: (),
    base.Resume: (),
    base.GetExtendedDescriptors: (),
    base.ContinuousBuiltInTest: (),
    base.CommSpeed: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("port", "port", "scalar", scalar="u8"),
        Parameter("baud", "baud", "scalar", scalar="u32", units=("Bd",)),
    ),
    base.GpsTimeUpdate: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("field_id", "field_id", "scalar", scalar="u8", type=base.GpsTimeField),
        Parameter("value", "value", "scalar", scalar="u32"),
    ),
    base.SoftReset: (),
    base.GetDeviceInfoResponse: (
        Parameter("device_info", "device_info", "struct", type=base.BaseDeviceInfo),
    ),
    base.GetDeviceDescriptorsResponse: (
        Parameter("descriptors", "descriptors", "array", scalar="u16", length="rest"),
    ),
    base.BuiltInTestResponse: (Parameter("result", "result", "scalar", scalar="u32"),),
    base.GpsTimeUpdateWeekNumberResponse: (
        Parameter("week_number", "week_number", "scalar", scalar="u32", units=("week",)),
    ),
    base.GpsTimeUpdateTowResponse: (Parameter("tow", "tow", "scalar", scalar="u32", units=("s",)),),
    base.GetExtendedDescriptorsResponse: (
        Parameter("descriptors", "descriptors", "array", scalar="u16", length="rest"),
    ),
    base.ContinuousBuiltInTestResponse: (
        Parameter("result", "result", "array", scalar="u8", length=16),
    ),
    base.CommSpeedResponse: (
        Parameter("port", "port", "scalar", scalar="u8"),
        Parameter("baud", "baud", "scalar", scalar="u32", units=("Bd",)),
    ),
    mip_3dm.PollEntry: (
        Parameter("descriptor", "descriptor", "scalar", scalar="u8"),
        Parameter("reserved", "reserved", "scalar", scalar="u16", default=0),
    ),
    mip_3dm.ConstellationSettingsEntry: (
        Parameter(
            "constellation_id",
            "constellation_id",
            "scalar",
            scalar="u8",
            type=mip_3dm.ConstellationId,
        ),
        Parameter("enable", "enable", "scalar", scalar="u8", minimum=0, maximum=1),
        Parameter(
            "reserved_channels",
            "reserved_channels",
            "scalar",
            scalar="u8",
            units=("1",),
            minimum=0,
            maximum=32,
        ),
        Parameter(
            "max_channels",
            "max_channels",
            "scalar",
            scalar="u8",
            units=("1",),
            minimum=0,
            maximum=32,
        ),
        Parameter(
            "option_flags",
            "option_flags",
            "scalar",
            scalar="u16",
            type=mip_3dm.ConstellationOptions,
        ),
    ),
    mip_3dm.EventSupportInfo: (
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
    mip_3dm.PollGnssData: (
        Parameter("suppress_ack", "suppress_ack", "scalar", scalar="bool"),
        Parameter(
            "num_descriptors",
            "num_descriptors",
            "counter",
            scalar="u8",
            counts="descriptors",
            minimum=0,
            maximum=83,
        ),
        Parameter(
            "descriptors", "descriptors", "array", length="num_descriptors", type=mip_3dm.PollEntry
        ),
    ),
    mip_3dm.PollFilterData: (
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
    mip_3dm.GetImuBaseRate: (),
    mip_3dm.GetGnssBaseRate: (),
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
    mip_3dm.GnssMessageFormat: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "num_descriptors",
            "num_descriptors",
            "counter",
            scalar="u8",
            counts="descriptors",
            minimum=0,
            maximum=82,
        ),
        Parameter(
            "descriptors",
            "descriptors",
            "array",
            length="num_descriptors",
            type=types.DescriptorRate,
        ),
    ),
    mip_3dm.FilterMessageFormat: (
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
    mip_3dm.GetFilterBaseRate: (),
    mip_3dm.NmeaMessageFormat: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("count", "count", "counter", scalar="u8", counts="format_entries"),
        Parameter(
            "format_entries", "format_entries", "array", length="count", type=types.NmeaMessage
        ),
    ),
    mip_3dm.PollData: (
        Parameter(
            "descriptor_set", "descriptor_set", "scalar", scalar="u8", minimum=128, maximum=254
        ),
        Parameter("suppress_ack", "suppress_ack", "scalar", scalar="bool"),
        Parameter(
            "num_descriptors", "num_descriptors", "counter", scalar="u8", counts="descriptors"
        ),
        Parameter("descriptors", "descriptors", "array", scalar="u8", length="num_descriptors"),
    ),
    mip_3dm.GetBaseRate: (
        Parameter(
            "descriptor_set", "descriptor_set", "scalar", scalar="u8", minimum=128, maximum=254
        ),
    ),
    mip_3dm.MessageFormat: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("descriptor_set", "descriptor_set", "scalar", scalar="u8"),
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
        Parameter("reserved", "reserved", "scalar", scalar="u8", default=0),
    ),
    mip_3dm.DataStreamControl: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("descriptor_set", "descriptor_set", "scalar", scalar="u8"),
        Parameter("enable", "enable", "scalar", scalar="bool", default=True),
    ),
    mip_3dm.ConstellationSettings: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("max_channels", "max_channels", "scalar", scalar="u16", units=("1",)),
        Parameter(
            "config_count",
            "config_count",
            "counter",
            scalar="u8",
            counts="settings",
            minimum=0,
            maximum=41,
        ),
        Parameter(
            "settings",
            "settings",
            "array",
            length="config_count",
            type=mip_3dm.ConstellationSettingsEntry,
        ),
    ),
    mip_3dm.GnssSbasSettings: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("enable_sbas", "enable_sbas", "scalar", scalar="u8", minimum=0, maximum=1),
        Parameter("sbas_options", "sbas_options", "scalar", scalar="u16", type=mip_3dm.SbasOptions),
        Parameter(
            "num_included_prns", "num_included_prns", "counter", scalar="u8", counts="included_prns"
        ),
        Parameter(
            "included_prns", "included_prns", "array", scalar="u16", length="num_included_prns"
        ),
    ),
    mip_3dm.GnssAssistedFix: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "option", "option", "scalar", scalar="u8", default=0, type=mip_3dm.AssistedFixOption
        ),
        Parameter("flags", "flags", "scalar", scalar="u8", default=255),
    ),
    mip_3dm.GnssTimeAssistance: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("tow", "tow", "scalar", scalar="double", units=("s",)),
        Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",)),
        Parameter("accuracy", "accuracy", "scalar", scalar="float", units=("s",)),
    ),
    mip_3dm.PpsSourceControl: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("source", "source", "scalar", scalar="u8", default=1, type=mip_3dm.PpsSource),
    ),
    mip_3dm.GetEventSupport: (
        Parameter("query", "query", "scalar", scalar="u8", type=mip_3dm.EventSupportQuery),
    ),
    mip_3dm.EventControl: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("instance", "instance", "scalar", scalar="u8"),
        Parameter("mode", "mode", "scalar", scalar="u8", default=0, type=types.EventTriggerMode),
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
    mip_3dm.EventTriggerConfig: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("instance", "instance", "scalar", scalar="u8"),
        Parameter("type", "type", "scalar", scalar="u8", default=0, type=types.EventTriggerType),
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
    mip_3dm.EventActionConfig: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("instance", "instance", "scalar", scalar="u8"),
        Parameter("trigger", "trigger", "scalar", scalar="u8"),
        Parameter("type", "type", "scalar", scalar="u8", default=0, type=types.EventActionType),
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
    mip_3dm.DeviceSettings: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
    ),
    mip_3dm.SensorToVehicleTransformEuler: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("roll", "roll", "scalar", scalar="float", units=("rad",)),
        Parameter("pitch", "pitch", "scalar", scalar="float", units=("rad",)),
        Parameter("yaw", "yaw", "scalar", scalar="float", units=("rad",)),
    ),
    mip_3dm.SensorToVehicleTransformQuaternion: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("q", "q", "array", scalar="float", elements=("w", "x", "y", "z"), units=("1",)),
    ),
    mip_3dm.SensorToVehicleTransformDcm: (
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
    mip_3dm.AccelBias: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "bias",
            "bias",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("g",),
            frame="sensor",
        ),
    ),
    mip_3dm.GyroBias: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "bias",
            "bias",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("rad/s",),
            frame="sensor",
        ),
    ),
    mip_3dm.CaptureGyroBias: (
        Parameter(
            "averaging_time_ms",
            "averaging_time_ms",
            "scalar",
            scalar="u16",
            units=("ms",),
            minimum=1000,
            maximum=30000,
        ),
    ),
    mip_3dm.MagHardIronOffset: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "offset",
            "offset",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("gauss",),
            frame="sensor",
        ),
    ),
    mip_3dm.MagSoftIronMatrix: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "matrix",
            "matrix",
            "array",
            scalar="float",
            elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"),
            units=("1",),
            frame="sensor",
        ),
    ),
    mip_3dm.ConingScullingEnable: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("enable", "enable", "scalar", scalar="bool", default=True),
    ),
    mip_3dm.UartBaudRate: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("baud", "baud", "scalar", scalar="u32", units=("Bd",)),
    ),
    mip_3dm.GpioConfig: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("pin", "pin", "scalar", scalar="u8"),
        Parameter("feature", "feature", "scalar", scalar="u8", default=0, type=types.GpioFeature),
        Parameter("behavior", "behavior", "scalar", scalar="u8"),
        Parameter("pin_mode", "pin_mode", "scalar", scalar="u8", type=types.GpioPinMode),
    ),
    mip_3dm.GpioState: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("pin", "pin", "scalar", scalar="u8", minimum=1),
        Parameter("state", "state", "scalar", scalar="bool"),
    ),
    mip_3dm.OdometerConfig: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("mode", "mode", "scalar", scalar="u8", type=mip_3dm.OdometerMode),
        Parameter("scaling", "scaling", "scalar", scalar="float", units=("pulse/m",)),
        Parameter("uncertainty", "uncertainty", "scalar", scalar="float", units=("1",)),
    ),
    mip_3dm.ImuLowPassFilter: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("target_descriptor", "target_descriptor", "scalar", scalar="u8"),
        Parameter("enable", "enable", "scalar", scalar="bool", default=True),
        Parameter("manual", "manual", "scalar", scalar="bool", default=False),
        Parameter("frequency", "frequency", "scalar", scalar="u16", units=("Hz",)),
        Parameter("reserved", "reserved", "scalar", scalar="u8", default=0),
    ),
    mip_3dm.ComplementaryFilter: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("pitch_roll_enable", "pitch_roll_enable", "scalar", scalar="bool"),
        Parameter("heading_enable", "heading_enable", "scalar", scalar="bool"),
        Parameter(
            "pitch_roll_time_constant",
            "pitch_roll_time_constant",
            "scalar",
            scalar="float",
            units=("s",),
            minimum=1,
            maximum=1000,
            default=10,
        ),
        Parameter(
            "heading_time_constant",
            "heading_time_constant",
            "scalar",
            scalar="float",
            units=("s",),
            minimum=1,
            maximum=1000,
            default=10,
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
    mip_3dm.LowPassFilter: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("descriptor_set", "descriptor_set", "scalar", scalar="u8"),
        Parameter("field_descriptor", "field_descriptor", "scalar", scalar="u8"),
        Parameter("enable", "enable", "scalar", scalar="bool"),
        Parameter("manual", "manual", "scalar", scalar="bool"),
        Parameter("frequency", "frequency", "scalar", scalar="float", units=("Hz",)),
    ),
    mip_3dm.DeviceStatus: (
        Parameter("model_number", "model_number", "scalar", scalar="u16"),
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
    mip_3dm.GnssMessageFormatResponse: (
        Parameter(
            "num_descriptors",
            "num_descriptors",
            "counter",
            scalar="u8",
            counts="descriptors",
            minimum=0,
            maximum=82,
        ),
        Parameter(
            "descriptors",
            "descriptors",
            "array",
            length="num_descriptors",
            type=types.DescriptorRate,
        ),
    ),
    mip_3dm.FilterMessageFormatResponse: (
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
    mip_3dm.GetImuBaseRateResponse: (
        Parameter("rate", "rate", "scalar", scalar="u16", units=("Hz",)),
    ),
    mip_3dm.GetGnssBaseRateResponse: (
        Parameter("rate", "rate", "scalar", scalar="u16", units=("Hz",)),
    ),
    mip_3dm.DataStreamControlResponse: (
        Parameter("descriptor_set", "descriptor_set", "scalar", scalar="u8"),
        Parameter("enabled", "enabled", "scalar", scalar="bool"),
    ),
    mip_3dm.UartBaudRateResponse: (
        Parameter("baud", "baud", "scalar", scalar="u32", units=("Bd",)),
    ),
    mip_3dm.GetFilterBaseRateResponse: (
        Parameter("rate", "rate", "scalar", scalar="u16", units=("Hz",)),
    ),
    mip_3dm.ImuLowPassFilterResponse: (
        Parameter("target_descriptor", "target_descriptor", "scalar", scalar="u8"),
        Parameter("enable", "enable", "scalar", scalar="bool", default=True),
        Parameter("manual", "manual", "scalar", scalar="bool", default=False),
        Parameter("frequency", "frequency", "scalar", scalar="u16", units=("Hz",)),
        Parameter("reserved", "reserved", "scalar", scalar="u8", default=0),
    ),
    mip_3dm.NmeaMessageFormatResponse: (
        Parameter("count", "count", "counter", scalar="u8", counts="format_entries"),
        Parameter(
            "format_entries", "format_entries", "array", length="count", type=types.NmeaMessage
        ),
    ),
    mip_3dm.GetBaseRateResponse: (
        Parameter("descriptor_set", "descriptor_set", "scalar", scalar="u8"),
        Parameter("rate", "rate", "scalar", scalar="u16", units=("Hz",)),
    ),
    mip_3dm.MessageFormatResponse: (
        Parameter("descriptor_set", "descriptor_set", "scalar", scalar="u8"),
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
        Parameter("model_number", "model_number", "scalar", scalar="u16"),
        Parameter("status_selector", "status_selector", "constant", scalar="u8", constant=1),
        Parameter("status_flags", "status_flags", "scalar", scalar="u32"),
        Parameter("system_state", "system_state", "scalar", scalar="u16"),
        Parameter("system_timer", "system_timer", "scalar", scalar="u32", units=("ms",)),
    ),
    mip_3dm.DeviceStatusBasicWithoutStateResponse: (
        Parameter("model_number", "model_number", "scalar", scalar="u16"),
        Parameter("status_selector", "status_selector", "constant", scalar="u8", constant=1),
        Parameter("status_flags", "status_flags", "scalar", scalar="u32"),
        Parameter("system_timer", "system_timer", "scalar", scalar="u32", units=("ms",)),
    ),
    mip_3dm.DeviceStatusDiagnosticResponse: (
        Parameter("model_number", "model_number", "scalar", scalar="u16"),
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
            "comm_port_bytes_written",
            "comm_port_bytes_written",
            "scalar",
            scalar="u32",
            units=("byte",),
        ),
        Parameter(
            "comm_port_bytes_read", "comm_port_bytes_read", "scalar", scalar="u32", units=("byte",)
        ),
        Parameter(
            "comm_port_write_overruns",
            "comm_port_write_overruns",
            "scalar",
            scalar="u32",
            units=("1",),
        ),
        Parameter(
            "comm_port_read_overruns",
            "comm_port_read_overruns",
            "scalar",
            scalar="u32",
            units=("1",),
        ),
        Parameter("imu_parser_errors", "imu_parser_errors", "scalar", scalar="u32", units=("1",)),
        Parameter("imu_message_count", "imu_message_count", "scalar", scalar="u32", units=("1",)),
        Parameter(
            "imu_last_message_time", "imu_last_message_time", "scalar", scalar="u32", units=("ms",)
        ),
    ),
    mip_3dm.DeviceStatusDiagnosticGnssResponse: (
        Parameter("model_number", "model_number", "scalar", scalar="u16"),
        Parameter("status_selector", "status_selector", "constant", scalar="u8", constant=2),
        Parameter("status_flags", "status_flags", "scalar", scalar="u32"),
        Parameter("system_state", "system_state", "scalar", scalar="u16"),
        Parameter("system_timer", "system_timer", "scalar", scalar="u32", units=("ms",)),
        Parameter("gnss_power_state", "gnss_power_state", "scalar", scalar="u8"),
        Parameter("pps_count", "pps_count", "scalar", scalar="u32", units=("1",)),
        Parameter("pps_last_time", "pps_last_time", "scalar", scalar="u32", units=("ms",)),
        Parameter("imu_stream_enabled", "imu_stream_enabled", "scalar", scalar="bool"),
        Parameter("gnss_stream_enabled", "gnss_stream_enabled", "scalar", scalar="bool"),
        Parameter("filter_stream_enabled", "filter_stream_enabled", "scalar", scalar="bool"),
        Parameter(
            "imu_dropped_packets", "imu_dropped_packets", "scalar", scalar="u32", units=("1",)
        ),
        Parameter(
            "gnss_dropped_packets", "gnss_dropped_packets", "scalar", scalar="u32", units=("1",)
        ),
        Parameter(
            "filter_dropped_packets", "filter_dropped_packets", "scalar", scalar="u32", units=("1",)
        ),
        Parameter(
            "comm_port_bytes_written",
            "comm_port_bytes_written",
            "scalar",
            scalar="u32",
            units=("byte",),
        ),
        Parameter(
            "comm_port_bytes_read", "comm_port_bytes_read", "scalar", scalar="u32", units=("byte",)
        ),
        Parameter(
            "comm_port_write_overruns",
            "comm_port_write_overruns",
            "scalar",
            scalar="u32",
            units=("1",),
        ),
        Parameter(
            "comm_port_read_overruns",
            "comm_port_read_overruns",
            "scalar",
            scalar="u32",
            units=("1",),
        ),
        Parameter("imu_parser_errors", "imu_parser_errors", "scalar", scalar="u32", units=("1",)),
        Parameter("imu_message_count", "imu_message_count", "scalar", scalar="u32", units=("1",)),
        Parameter(
            "imu_last_message_time", "imu_last_message_time", "scalar", scalar="u32", units=("ms",)
        ),
        Parameter("gnss_parser_errors", "gnss_parser_errors", "scalar", scalar="u32", units=("1",)),
        Parameter("gnss_message_count", "gnss_message_count", "scalar", scalar="u32", units=("1",)),
        Parameter(
            "gnss_last_message_time",
            "gnss_last_message_time",
            "scalar",
            scalar="u32",
            units=("ms",),
        ),
    ),
    mip_3dm.DeviceStatusDiagnosticGq4_45Response: (
        Parameter("model_number", "model_number", "scalar", scalar="u16"),
        Parameter("status_selector", "status_selector", "constant", scalar="u8", constant=2),
        Parameter("status_flags", "status_flags", "scalar", scalar="u32"),
        Parameter("system_state", "system_state", "scalar", scalar="u16"),
        Parameter("system_timer", "system_timer", "scalar", scalar="u32", units=("ms",)),
        Parameter("gnss_power_state", "gnss_power_state", "scalar", scalar="u8"),
        Parameter("pps_count", "pps_count", "scalar", scalar="u32", units=("1",)),
        Parameter("pps_last_time", "pps_last_time", "scalar", scalar="u32", units=("ms",)),
        Parameter("imu_stream_enabled", "imu_stream_enabled", "scalar", scalar="bool"),
        Parameter("gnss_stream_enabled", "gnss_stream_enabled", "scalar", scalar="bool"),
        Parameter("filter_stream_enabled", "filter_stream_enabled", "scalar", scalar="bool"),
        Parameter(
            "imu_dropped_packets", "imu_dropped_packets", "scalar", scalar="u32", units=("1",)
        ),
        Parameter(
            "gnss_dropped_packets", "gnss_dropped_packets", "scalar", scalar="u32", units=("1",)
        ),
        Parameter(
            "filter_dropped_packets", "filter_dropped_packets", "scalar", scalar="u32", units=("1",)
        ),
        Parameter(
            "comm_port_bytes_written",
            "comm_port_bytes_written",
            "scalar",
            scalar="u32",
            units=("byte",),
        ),
        Parameter(
            "comm_port_bytes_read", "comm_port_bytes_read", "scalar", scalar="u32", units=("byte",)
        ),
        Parameter(
            "comm_port_write_overruns",
            "comm_port_write_overruns",
            "scalar",
            scalar="u32",
            units=("1",),
        ),
        Parameter(
            "comm_port_read_overruns",
            "comm_port_read_overruns",
            "scalar",
            scalar="u32",
            units=("1",),
        ),
        Parameter("imu_parser_errors", "imu_parser_errors", "scalar", scalar="u32", units=("1",)),
        Parameter("imu_message_count", "imu_message_count", "scalar", scalar="u32", units=("1",)),
        Parameter(
            "imu_last_message_time", "imu_last_message_time", "scalar", scalar="u32", units=("ms",)
        ),
        Parameter("gnss_parser_errors", "gnss_parser_errors", "scalar", scalar="u32", units=("1",)),
        Parameter("gnss_message_count", "gnss_message_count", "scalar", scalar="u32", units=("1",)),
        Parameter(
            "gnss_last_message_time",
            "gnss_last_message_time",
            "scalar",
            scalar="u32",
            units=("ms",),
        ),
        Parameter("mag_init_failed", "mag_init_failed", "scalar", scalar="bool"),
        Parameter("pressure_init_failed", "pressure_init_failed", "scalar", scalar="bool"),
        Parameter("receiver_init_failed", "receiver_init_failed", "scalar", scalar="bool"),
    ),
    mip_3dm.DeviceStatusDiagnosticRq1_45Response: (
        Parameter("model_number", "model_number", "scalar", scalar="u16"),
        Parameter("status_selector", "status_selector", "constant", scalar="u8", constant=2),
        Parameter("status_flags", "status_flags", "scalar", scalar="u32"),
        Parameter("system_state", "system_state", "scalar", scalar="u16"),
        Parameter("system_timer", "system_timer", "scalar", scalar="u32", units=("ms",)),
        Parameter("gnss_power_state", "gnss_power_state", "scalar", scalar="u8"),
        Parameter("cold_start_on_power_on", "cold_start_on_power_on", "scalar", scalar="u8"),
        Parameter("temperature", "temperature", "scalar", scalar="float", units=("degC",)),
        Parameter(
            "temperature_last_time", "temperature_last_time", "scalar", scalar="u32", units=("ms",)
        ),
        Parameter("pps_count", "pps_count", "scalar", scalar="u32", units=("1",)),
        Parameter("pps_last_time", "pps_last_time", "scalar", scalar="u32", units=("ms",)),
        Parameter("imu_stream_enabled", "imu_stream_enabled", "scalar", scalar="bool"),
        Parameter("gnss_stream_enabled", "gnss_stream_enabled", "scalar", scalar="bool"),
        Parameter("filter_stream_enabled", "filter_stream_enabled", "scalar", scalar="bool"),
        Parameter(
            "imu_dropped_packets", "imu_dropped_packets", "scalar", scalar="u32", units=("1",)
        ),
        Parameter(
            "gnss_dropped_packets", "gnss_dropped_packets", "scalar", scalar="u32", units=("1",)
        ),
        Parameter(
            "filter_dropped_packets", "filter_dropped_packets", "scalar", scalar="u32", units=("1",)
        ),
        Parameter(
            "comm_port_bytes_written",
            "comm_port_bytes_written",
            "scalar",
            scalar="u32",
            units=("byte",),
        ),
        Parameter(
            "comm_port_bytes_read", "comm_port_bytes_read", "scalar", scalar="u32", units=("byte",)
        ),
        Parameter(
            "comm_port_write_overruns",
            "comm_port_write_overruns",
            "scalar",
            scalar="u32",
            units=("1",),
        ),
        Parameter(
            "comm_port_read_overruns",
            "comm_port_read_overruns",
            "scalar",
            scalar="u32",
            units=("1",),
        ),
        Parameter("imu_parser_errors", "imu_parser_errors", "scalar", scalar="u32", units=("1",)),
        Parameter("imu_message_count", "imu_message_count", "scalar", scalar="u32", units=("1",)),
        Parameter(
            "imu_last_message_time", "imu_last_message_time", "scalar", scalar="u32", units=("ms",)
        ),
        Parameter("gnss_parser_errors", "gnss_parser_errors", "scalar", scalar="u32", units=("1",)),
        Parameter("gnss_message_count", "gnss_message_count", "scalar", scalar="u32", units=("1",)),
        Parameter(
            "gnss_last_message_time",
            "gnss_last_message_time",
            "scalar",
            scalar="u32",
            units=("ms",),
        ),
    ),
    mip_3dm.DeviceStatusDiagnosticGx4Response: (
        Parameter("model_number", "model_number", "scalar", scalar="u16"),
        Parameter("status_selector", "status_selector", "constant", scalar="u8", constant=2),
        Parameter("status_flags", "status_flags", "scalar", scalar="u32"),
        Parameter("system_timer", "system_timer", "scalar", scalar="u32", units=("ms",)),
        Parameter("pps_count", "pps_count", "scalar", scalar="u32", units=("1",)),
        Parameter("pps_last_time", "pps_last_time", "scalar", scalar="u32", units=("ms",)),
        Parameter("imu_stream_enabled", "imu_stream_enabled", "scalar", scalar="bool"),
        Parameter("filter_stream_enabled", "filter_stream_enabled", "scalar", scalar="bool"),
        Parameter(
            "imu_dropped_packets", "imu_dropped_packets", "scalar", scalar="u32", units=("1",)
        ),
        Parameter(
            "filter_dropped_packets", "filter_dropped_packets", "scalar", scalar="u32", units=("1",)
        ),
        Parameter(
            "comm_port_bytes_written",
            "comm_port_bytes_written",
            "scalar",
            scalar="u32",
            units=("byte",),
        ),
        Parameter(
            "comm_port_bytes_read", "comm_port_bytes_read", "scalar", scalar="u32", units=("byte",)
        ),
        Parameter(
            "comm_port_write_overruns",
            "comm_port_write_overruns",
            "scalar",
            scalar="u32",
            units=("1",),
        ),
        Parameter(
            "comm_port_read_overruns",
            "comm_port_read_overruns",
            "scalar",
            scalar="u32",
            units=("1",),
        ),
        Parameter(
            "usb_bytes_written", "usb_bytes_written", "scalar", scalar="u32", units=("byte",)
        ),
        Parameter("usb_bytes_read", "usb_bytes_read", "scalar", scalar="u32", units=("byte",)),
        Parameter("usb_write_overruns", "usb_write_overruns", "scalar", scalar="u32", units=("1",)),
        Parameter("usb_read_overruns", "usb_read_overruns", "scalar", scalar="u32", units=("1",)),
        Parameter("imu_parser_errors", "imu_parser_errors", "scalar", scalar="u32", units=("1",)),
        Parameter("imu_message_count", "imu_message_count", "scalar", scalar="u32", units=("1",)),
        Parameter(
            "imu_last_message_time", "imu_last_message_time", "scalar", scalar="u32", units=("ms",)
        ),
    ),
    mip_3dm.DeviceStatusDiagnosticImuResponse: (
        Parameter("model_number", "model_number", "scalar", scalar="u16"),
        Parameter("status_selector", "status_selector", "constant", scalar="u8", constant=2),
        Parameter("status_flags", "status_flags", "scalar", scalar="u32"),
        Parameter("system_timer", "system_timer", "scalar", scalar="u32", units=("ms",)),
        Parameter("has_mag", "has_mag", "scalar", scalar="bool"),
        Parameter("has_pressure", "has_pressure", "scalar", scalar="bool"),
        Parameter("power_state", "power_state", "scalar", scalar="u8"),
        Parameter("gyro_range", "gyro_range", "scalar", scalar="u16"),
        Parameter("accel_range", "accel_range", "scalar", scalar="u16"),
        Parameter("reserved", "reserved", "scalar", scalar="u32", default=0),
        Parameter("temperature", "temperature", "scalar", scalar="float", units=("degC",)),
        Parameter(
            "temperature_last_time", "temperature_last_time", "scalar", scalar="u32", units=("ms",)
        ),
        Parameter("temperature_error", "temperature_error", "scalar", scalar="u8"),
        Parameter("pps_count", "pps_count", "scalar", scalar="u32", units=("1",)),
        Parameter("pps_last_time", "pps_last_time", "scalar", scalar="u32", units=("ms",)),
        Parameter("imu_stream_enabled", "imu_stream_enabled", "scalar", scalar="bool"),
        Parameter(
            "imu_dropped_packets", "imu_dropped_packets", "scalar", scalar="u32", units=("1",)
        ),
        Parameter(
            "comm_port_bytes_written",
            "comm_port_bytes_written",
            "scalar",
            scalar="u32",
            units=("byte",),
        ),
        Parameter(
            "comm_port_bytes_read", "comm_port_bytes_read", "scalar", scalar="u32", units=("byte",)
        ),
        Parameter(
            "comm_port_write_overruns",
            "comm_port_write_overruns",
            "scalar",
            scalar="u32",
            units=("1",),
        ),
        Parameter(
            "comm_port_read_overruns",
            "comm_port_read_overruns",
            "scalar",
            scalar="u32",
            units=("1",),
        ),
    ),
    mip_3dm.ComplementaryFilterResponse: (
        Parameter("pitch_roll_enable", "pitch_roll_enable", "scalar", scalar="bool"),
        Parameter("heading_enable", "heading_enable", "scalar", scalar="bool"),
        Parameter(
            "pitch_roll_time_constant",
            "pitch_roll_time_constant",
            "scalar",
            scalar="float",
            units=("s",),
            minimum=1,
            maximum=1000,
            default=10,
        ),
        Parameter(
            "heading_time_constant",
            "heading_time_constant",
            "scalar",
            scalar="float",
            units=("s",),
            minimum=1,
            maximum=1000,
            default=10,
        ),
    ),
    mip_3dm.AccelBiasResponse: (
        Parameter(
            "bias",
            "bias",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("g",),
            frame="sensor",
        ),
    ),
    mip_3dm.GyroBiasResponse: (
        Parameter(
            "bias",
            "bias",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("rad/s",),
            frame="sensor",
        ),
    ),
    mip_3dm.MagHardIronOffsetResponse: (
        Parameter(
            "offset",
            "offset",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("gauss",),
            frame="sensor",
        ),
    ),
    mip_3dm.MagSoftIronMatrixResponse: (
        Parameter(
            "matrix",
            "matrix",
            "array",
            scalar="float",
            elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"),
            units=("1",),
            frame="sensor",
        ),
    ),
    mip_3dm.ConingScullingEnableResponse: (
        Parameter("enable", "enable", "scalar", scalar="bool", default=True),
    ),
    mip_3dm.ConstellationSettingsResponse: (
        Parameter(
            "max_channels_available", "max_channels_available", "scalar", scalar="u16", units=("1",)
        ),
        Parameter("max_channels_use", "max_channels_use", "scalar", scalar="u16", units=("1",)),
        Parameter(
            "config_count",
            "config_count",
            "counter",
            scalar="u8",
            counts="settings",
            minimum=0,
            maximum=41,
        ),
        Parameter(
            "settings",
            "settings",
            "array",
            length="config_count",
            type=mip_3dm.ConstellationSettingsEntry,
        ),
    ),
    mip_3dm.GnssSbasSettingsResponse: (
        Parameter("enable_sbas", "enable_sbas", "scalar", scalar="u8", minimum=0, maximum=1),
        Parameter("sbas_options", "sbas_options", "scalar", scalar="u16", type=mip_3dm.SbasOptions),
        Parameter(
            "num_included_prns", "num_included_prns", "counter", scalar="u8", counts="included_prns"
        ),
        Parameter(
            "included_prns", "included_prns", "array", scalar="u16", length="num_included_prns"
        ),
    ),
    mip_3dm.GnssAssistedFixResponse: (
        Parameter(
            "option", "option", "scalar", scalar="u8", default=0, type=mip_3dm.AssistedFixOption
        ),
        Parameter("flags", "flags", "scalar", scalar="u8", default=255),
    ),
    mip_3dm.GnssTimeAssistanceResponse: (
        Parameter("tow", "tow", "scalar", scalar="double", units=("s",)),
        Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",)),
        Parameter("accuracy", "accuracy", "scalar", scalar="float", units=("s",)),
    ),
    mip_3dm.PpsSourceControlResponse: (
        Parameter("source", "source", "scalar", scalar="u8", default=1, type=mip_3dm.PpsSource),
    ),
    mip_3dm.SensorToVehicleTransformEulerResponse: (
        Parameter("roll", "roll", "scalar", scalar="float", units=("rad",)),
        Parameter("pitch", "pitch", "scalar", scalar="float", units=("rad",)),
        Parameter("yaw", "yaw", "scalar", scalar="float", units=("rad",)),
    ),
    mip_3dm.SensorToVehicleTransformQuaternionResponse: (
        Parameter("q", "q", "array", scalar="float", elements=("w", "x", "y", "z"), units=("1",)),
    ),
    mip_3dm.SensorToVehicleTransformDcmResponse: (
        Parameter(
            "dcm",
            "dcm",
            "array",
            scalar="float",
            elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"),
            units=("1",),
        ),
    ),
    mip_3dm.GetEventSupportResponse: (
        Parameter("query", "query", "scalar", scalar="u8", type=mip_3dm.EventSupportQuery),
        Parameter("max_instances", "max_instances", "scalar", scalar="u8", units=("1",)),
        Parameter("num_entries", "num_entries", "counter", scalar="u8", counts="entries"),
        Parameter(
            "entries", "entries", "array", length="num_entries", type=mip_3dm.EventSupportInfo
        ),
    ),
    mip_3dm.EventControlResponse: (
        Parameter("instance", "instance", "scalar", scalar="u8"),
        Parameter("mode", "mode", "scalar", scalar="u8", default=0, type=types.EventTriggerMode),
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
    mip_3dm.EventTriggerConfigResponse: (
        Parameter("instance", "instance", "scalar", scalar="u8"),
        Parameter("type", "type", "scalar", scalar="u8", default=0, type=types.EventTriggerType),
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
    mip_3dm.EventActionConfigResponse: (
        Parameter("instance", "instance", "scalar", scalar="u8"),
        Parameter("trigger", "trigger", "scalar", scalar="u8"),
        Parameter("type", "type", "scalar", scalar="u8", default=0, type=types.EventActionType),
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
    mip_3dm.GpioConfigResponse: (
        Parameter("pin", "pin", "scalar", scalar="u8"),
        Parameter("feature", "feature", "scalar", scalar="u8", default=0, type=types.GpioFeature),
        Parameter("behavior", "behavior", "scalar", scalar="u8"),
        Parameter("pin_mode", "pin_mode", "scalar", scalar="u8", type=types.GpioPinMode),
    ),
    mip_3dm.GpioStateResponse: (
        Parameter("pin", "pin", "scalar", scalar="u8", minimum=1),
        Parameter("state", "state", "scalar", scalar="bool"),
    ),
    mip_3dm.OdometerConfigResponse: (
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
    mip_3dm.LowPassFilterResponse: (
        Parameter("descriptor_set", "descriptor_set", "scalar", scalar="u8"),
        Parameter("field_descriptor", "field_descriptor", "scalar", scalar="u8"),
        Parameter("enable", "enable", "scalar", scalar="bool"),
        Parameter("manual", "manual", "scalar", scalar="bool"),
        Parameter("frequency", "frequency", "scalar", scalar="float", units=("Hz",)),
    ),
    filter.Reset: (),
    filter.SetInitialAttitude: (
        Parameter(
            "roll",
            "roll",
            "scalar",
            scalar="float",
            units=("rad",),
            minimum=-3.141592653589793,
            maximum=3.141592653589793,
            frame="ned",
        ),
        Parameter(
            "pitch",
            "pitch",
            "scalar",
            scalar="float",
            units=("rad",),
            minimum=-1.5707963267948966,
            maximum=1.5707963267948966,
            frame="ned",
        ),
        Parameter(
            "heading",
            "heading",
            "scalar",
            scalar="float",
            units=("rad",),
            minimum=-3.141592653589793,
            maximum=3.141592653589793,
            frame="ned",
        ),
    ),
    filter.SetInitialHeading: (
        Parameter(
            "heading",
            "heading",
            "scalar",
            scalar="float",
            units=("rad",),
            minimum=-3.141592653589793,
            maximum=3.141592653589793,
            frame="ned",
        ),
    ),
    filter.Run: (),
    filter.VehicleDynamicsMode: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("mode", "mode", "scalar", scalar="u8", type=filter.DynamicsMode),
    ),
    filter.SensorToVehicleRotationEuler: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("roll", "roll", "scalar", scalar="float", units=("rad",)),
        Parameter("pitch", "pitch", "scalar", scalar="float", units=("rad",)),
        Parameter("yaw", "yaw", "scalar", scalar="float", units=("rad",)),
    ),
    filter.SensorToVehicleOffset: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "offset",
            "offset",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
            magnitude=(None, 10),
            frame="sensor",
        ),
    ),
    filter.AntennaOffset: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "offset",
            "offset",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
            magnitude=(None, 10),
            frame="vehicle",
        ),
    ),
    filter.EstimationControl: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("flags", "flags", "scalar", scalar="u16", type=filter.EstimatedStates),
    ),
    filter.GnssSource: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("source", "source", "scalar", scalar="u8", type=filter.GnssAidingSource),
    ),
    filter.ExternalGnssUpdate: (
        Parameter("tow", "tow", "scalar", scalar="double", units=("s",)),
        Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",)),
        Parameter("latitude", "latitude", "scalar", scalar="double", units=("deg",), frame="llh"),
        Parameter("longitude", "longitude", "scalar", scalar="double", units=("deg",), frame="llh"),
        Parameter("height", "height", "scalar", scalar="double", units=("m",), frame="llh"),
        Parameter(
            "velocity",
            "velocity",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s",),
            frame="ned",
        ),
        Parameter(
            "position_uncertainty",
            "position_uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
            frame="ned",
        ),
        Parameter(
            "velocity_uncertainty",
            "velocity_uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s",),
            frame="ned",
        ),
    ),
    filter.ExternalHeadingUpdate: (
        Parameter(
            "heading",
            "heading",
            "scalar",
            scalar="float",
            units=("rad",),
            minimum=-3.141592653589793,
            maximum=3.141592653589793,
            frame="ned",
        ),
        Parameter(
            "heading_uncertainty",
            "heading_uncertainty",
            "scalar",
            scalar="float",
            units=("rad",),
            above=0,
        ),
        Parameter("type", "type", "scalar", scalar="u8", type=filter.HeadingType),
    ),
    filter.HeadingSource: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("source", "source", "scalar", scalar="u8", type=filter.HeadingUpdateSource),
    ),
    filter.AutoInitializationControl: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("enable", "enable", "scalar", scalar="u8", minimum=0, maximum=1),
    ),
    filter.AccelNoise: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "noise",
            "noise",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s^2",),
            above=0,
        ),
    ),
    filter.GyroNoise: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "noise",
            "noise",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("rad/s",),
            above=0,
        ),
    ),
    filter.AccelBiasModel: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "beta", "beta", "array", scalar="float", elements=("x", "y", "z"), units=("1/s",)
        ),
        Parameter(
            "noise",
            "noise",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s^2",),
            above=0,
        ),
    ),
    filter.GyroBiasModel: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "beta", "beta", "array", scalar="float", elements=("x", "y", "z"), units=("1/s",)
        ),
        Parameter(
            "noise",
            "noise",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("rad/s",),
            above=0,
        ),
    ),
    filter.AutoZupt: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("enable", "enable", "scalar", scalar="u8", minimum=0, maximum=1),
        Parameter("threshold", "threshold", "scalar", scalar="float", units=("m/s",), minimum=0),
    ),
    filter.ExternalHeadingUpdateWithTime: (
        Parameter("tow", "tow", "scalar", scalar="double", units=("s",)),
        Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",)),
        Parameter(
            "heading",
            "heading",
            "scalar",
            scalar="float",
            units=("rad",),
            minimum=-3.141592653589793,
            maximum=3.141592653589793,
            frame="ned",
        ),
        Parameter(
            "heading_uncertainty",
            "heading_uncertainty",
            "scalar",
            scalar="float",
            units=("rad",),
            above=0,
        ),
        Parameter("type", "type", "scalar", scalar="u8", type=filter.HeadingType),
    ),
    filter.AutoAngularZupt: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("enable", "enable", "scalar", scalar="u8", minimum=0, maximum=1),
        Parameter("threshold", "threshold", "scalar", scalar="float", units=("rad/s",), minimum=0),
    ),
    filter.TareOrientation: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("axes", "axes", "scalar", scalar="u8", type=filter.TareAxes),
    ),
    filter.CommandedZupt: (),
    filter.CommandedAngularZupt: (),
    filter.ReferencePosition: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("enable", "enable", "scalar", scalar="u8", minimum=0, maximum=1),
        Parameter("latitude", "latitude", "scalar", scalar="double", units=("deg",), frame="llh"),
        Parameter("longitude", "longitude", "scalar", scalar="double", units=("deg",), frame="llh"),
        Parameter("altitude", "altitude", "scalar", scalar="double", units=("m",), frame="llh"),
    ),
    filter.MagCaptureAutoCalibration: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
    ),
    filter.GravityNoise: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "noise",
            "noise",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("g",),
            above=0,
        ),
    ),
    filter.PressureAltitudeNoise: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("noise", "noise", "scalar", scalar="float", units=("m",), above=0),
    ),
    filter.HardIronOffsetNoise: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "noise",
            "noise",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("gauss",),
            above=0,
        ),
    ),
    filter.SoftIronMatrixNoise: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "noise",
            "noise",
            "array",
            scalar="float",
            elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"),
            units=("1",),
            above=0,
        ),
    ),
    filter.EnableMeasurements: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("control", "control", "scalar", scalar="u16", type=filter.MeasurementFlags),
    ),
    filter.MagNoise: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "noise",
            "noise",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("gauss",),
            above=0,
        ),
    ),
    filter.MagneticDeclinationSource: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("source", "source", "scalar", scalar="u8", type=filter.MagParameterSource),
        Parameter("declination", "declination", "scalar", scalar="float", units=("rad",)),
    ),
    filter.AccelMagnitudeErrorAdaptiveMeasurement: (
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
    filter.MagMagnitudeErrorAdaptiveMeasurement: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "adaptive_measurement",
            "adaptive_measurement",
            "scalar",
            scalar="u8",
            type=filter.AdaptiveMeasurementSelector,
        ),
        Parameter("frequency", "frequency", "scalar", scalar="float", units=("Hz",)),
        Parameter("low_limit", "low_limit", "scalar", scalar="float", units=("gauss",)),
        Parameter("high_limit", "high_limit", "scalar", scalar="float", units=("gauss",)),
        Parameter(
            "low_limit_uncertainty",
            "low_limit_uncertainty",
            "scalar",
            scalar="float",
            units=("gauss",),
        ),
        Parameter(
            "high_limit_uncertainty",
            "high_limit_uncertainty",
            "scalar",
            scalar="float",
            units=("gauss",),
        ),
        Parameter(
            "minimum_uncertainty", "minimum_uncertainty", "scalar", scalar="float", units=("gauss",)
        ),
    ),
    filter.MagDipAngleErrorAdaptiveMeasurement: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("enable", "enable", "scalar", scalar="bool"),
        Parameter("frequency", "frequency", "scalar", scalar="float", units=("Hz",)),
        Parameter("high_limit", "high_limit", "scalar", scalar="float", units=("rad",)),
        Parameter(
            "high_limit_uncertainty",
            "high_limit_uncertainty",
            "scalar",
            scalar="float",
            units=("rad",),
        ),
        Parameter(
            "minimum_uncertainty", "minimum_uncertainty", "scalar", scalar="float", units=("rad",)
        ),
    ),
    filter.AltitudeAiding: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("selector", "selector", "scalar", scalar="u8", type=filter.AltitudeAidingSource),
    ),
    filter.PitchRollAiding: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("aiding", "aiding", "scalar", scalar="u8", type=filter.PitchRollAidingSource),
    ),
    filter.MagneticInclinationSource: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("source", "source", "scalar", scalar="u8", type=filter.MagParameterSource),
        Parameter("inclination", "inclination", "scalar", scalar="float", units=("rad",)),
    ),
    filter.MagneticMagnitudeSource: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("source", "source", "scalar", scalar="u8", type=filter.MagParameterSource),
        Parameter("magnitude", "magnitude", "scalar", scalar="float", units=("gauss",)),
    ),
    filter.SensorToVehicleRotationDcm: (
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
    filter.SensorToVehicleRotationQuaternion: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "q",
            "q",
            "array",
            scalar="float",
            elements=("w", "x", "y", "z"),
            units=("1",),
            magnitude=(0.999, 1.001),
        ),
    ),
    filter.AidingMeasurementEnable: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "aiding_source", "aiding_source", "scalar", scalar="u16", type=filter.AidingSource
        ),
        Parameter("enable", "enable", "scalar", scalar="bool"),
    ),
    filter.KinematicConstraint: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "accel_constraint",
            "accel_constraint",
            "scalar",
            scalar="u8",
            default=0,
            type=filter.AccelConstraint,
        ),
        Parameter(
            "velocity_constraint",
            "velocity_constraint",
            "scalar",
            scalar="u8",
            default=0,
            type=filter.VelocityConstraint,
        ),
        Parameter(
            "angular_constraint",
            "angular_constraint",
            "scalar",
            scalar="u8",
            default=0,
            type=filter.AngularConstraint,
        ),
    ),
    filter.InitializationConfig: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "wait_for_run_command",
            "wait_for_run_command",
            "scalar",
            scalar="u8",
            minimum=0,
            maximum=1,
        ),
        Parameter(
            "initial_condition_source",
            "initial_condition_source",
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
    filter.AdaptiveFilterOptions: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("level", "level", "scalar", scalar="u8", default=2, type=filter.AdaptiveLevel),
        Parameter("time_limit", "time_limit", "scalar", scalar="u16", units=("ms",)),
    ),
    filter.MultiAntennaOffset: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("receiver_id", "receiver_id", "scalar", scalar="u8", minimum=1),
        Parameter(
            "antenna_offset",
            "antenna_offset",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
            magnitude=(None, 10),
            frame="vehicle",
        ),
    ),
    filter.RelativePositionConfig: (
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
            "reference_point", "reference_point", "scalar", scalar="u8", type=filter.ReferencePoint
        ),
        Parameter(
            "lever_arm_offset",
            "lever_arm_offset",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
            magnitude=(None, 10),
            frame="vehicle",
        ),
    ),
    filter.SpeedMeasurement: (
        Parameter("source", "source", "scalar", scalar="u8", default=1),
        Parameter("tow", "tow", "scalar", scalar="float", units=("s",)),
        Parameter("speed", "speed", "scalar", scalar="float", units=("m/s",), frame="vehicle"),
        Parameter(
            "speed_uncertainty", "speed_uncertainty", "scalar", scalar="float", units=("m/s",)
        ),
    ),
    filter.SpeedLeverArm: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("source", "source", "scalar", scalar="u8", default=1),
        Parameter(
            "lever_arm_offset",
            "lever_arm_offset",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
            frame="vehicle",
        ),
    ),
    filter.VerticalGyroConstraintControl: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("enable", "enable", "scalar", scalar="u8", minimum=0, maximum=1),
    ),
    filter.WheeledVehicleConstraintControl: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("enable", "enable", "scalar", scalar="u8", minimum=0, maximum=1),
    ),
    filter.GnssAntennaCalibrationControl: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("enable", "enable", "scalar", scalar="u8", minimum=0, maximum=1),
        Parameter(
            "max_offset",
            "max_offset",
            "scalar",
            scalar="float",
            units=("m",),
            minimum=0,
            maximum=0.5,
            default=0.1,
            frame="vehicle",
        ),
    ),
    filter.VehicleDynamicsModeResponse: (
        Parameter("mode", "mode", "scalar", scalar="u8", type=filter.DynamicsMode),
    ),
    filter.SensorToVehicleRotationEulerResponse: (
        Parameter("roll", "roll", "scalar", scalar="float", units=("rad",)),
        Parameter("pitch", "pitch", "scalar", scalar="float", units=("rad",)),
        Parameter("yaw", "yaw", "scalar", scalar="float", units=("rad",)),
    ),
    filter.SensorToVehicleOffsetResponse: (
        Parameter(
            "offset",
            "offset",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
            magnitude=(None, 10),
            frame="sensor",
        ),
    ),
    filter.AntennaOffsetResponse: (
        Parameter(
            "offset",
            "offset",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
            magnitude=(None, 10),
            frame="vehicle",
        ),
    ),
    filter.EstimationControlResponse: (
        Parameter("flags", "flags", "scalar", scalar="u16", type=filter.EstimatedStates),
    ),
    filter.GnssSourceResponse: (
        Parameter("source", "source", "scalar", scalar="u8", type=filter.GnssAidingSource),
    ),
    filter.HeadingSourceResponse: (
        Parameter("source", "source", "scalar", scalar="u8", type=filter.HeadingUpdateSource),
    ),
    filter.AutoInitializationControlResponse: (
        Parameter("enable", "enable", "scalar", scalar="u8", minimum=0, maximum=1),
    ),
    filter.AccelNoiseResponse: (
        Parameter(
            "noise",
            "noise",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s^2",),
            above=0,
        ),
    ),
    filter.GyroNoiseResponse: (
        Parameter(
            "noise",
            "noise",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("rad/s",),
            above=0,
        ),
    ),
    filter.AccelBiasModelResponse: (
        Parameter(
            "beta", "beta", "array", scalar="float", elements=("x", "y", "z"), units=("1/s",)
        ),
        Parameter(
            "noise",
            "noise",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s^2",),
            above=0,
        ),
    ),
    filter.GyroBiasModelResponse: (
        Parameter(
            "beta", "beta", "array", scalar="float", elements=("x", "y", "z"), units=("1/s",)
        ),
        Parameter(
            "noise",
            "noise",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("rad/s",),
            above=0,
        ),
    ),
    filter.AutoZuptResponse: (
        Parameter("enable", "enable", "scalar", scalar="u8", minimum=0, maximum=1),
        Parameter("threshold", "threshold", "scalar", scalar="float", units=("m/s",), minimum=0),
    ),
    filter.AutoAngularZuptResponse: (
        Parameter("enable", "enable", "scalar", scalar="u8", minimum=0, maximum=1),
        Parameter("threshold", "threshold", "scalar", scalar="float", units=("rad/s",), minimum=0),
    ),
    filter.ReferencePositionResponse: (
        Parameter("enable", "enable", "scalar", scalar="u8", minimum=0, maximum=1),
        Parameter("latitude", "latitude", "scalar", scalar="double", units=("deg",), frame="llh"),
        Parameter("longitude", "longitude", "scalar", scalar="double", units=("deg",), frame="llh"),
        Parameter("altitude", "altitude", "scalar", scalar="double", units=("m",), frame="llh"),
    ),
    filter.GravityNoiseResponse: (
        Parameter(
            "noise",
            "noise",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("g",),
            above=0,
        ),
    ),
    filter.PressureAltitudeNoiseResponse: (
        Parameter("noise", "noise", "scalar", scalar="float", units=("m",), above=0),
    ),
    filter.HardIronOffsetNoiseResponse: (
        Parameter(
            "noise",
            "noise",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("gauss",),
            above=0,
        ),
    ),
    filter.SoftIronMatrixNoiseResponse: (
        Parameter(
            "noise",
            "noise",
            "array",
            scalar="float",
            elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"),
            units=("1",),
            above=0,
        ),
    ),
    filter.TareOrientationResponse: (
        Parameter("axes", "axes", "scalar", scalar="u8", type=filter.TareAxes),
    ),
    filter.EnableMeasurementsResponse: (
        Parameter("control", "control", "scalar", scalar="u16", type=filter.MeasurementFlags),
    ),
    filter.MagNoiseResponse: (
        Parameter(
            "noise",
            "noise",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("gauss",),
            above=0,
        ),
    ),
    filter.MagneticDeclinationSourceResponse: (
        Parameter("source", "source", "scalar", scalar="u8", type=filter.MagParameterSource),
        Parameter("declination", "declination", "scalar", scalar="float", units=("rad",)),
    ),
    filter.AccelMagnitudeErrorAdaptiveMeasurementResponse: (
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
    filter.MagMagnitudeErrorAdaptiveMeasurementResponse: (
        Parameter(
            "adaptive_measurement",
            "adaptive_measurement",
            "scalar",
            scalar="u8",
            type=filter.AdaptiveMeasurementSelector,
        ),
        Parameter("frequency", "frequency", "scalar", scalar="float", units=("Hz",)),
        Parameter("low_limit", "low_limit", "scalar", scalar="float", units=("gauss",)),
        Parameter("high_limit", "high_limit", "scalar", scalar="float", units=("gauss",)),
        Parameter(
            "low_limit_uncertainty",
            "low_limit_uncertainty",
            "scalar",
            scalar="float",
            units=("gauss",),
        ),
        Parameter(
            "high_limit_uncertainty",
            "high_limit_uncertainty",
            "scalar",
            scalar="float",
            units=("gauss",),
        ),
        Parameter(
            "minimum_uncertainty", "minimum_uncertainty", "scalar", scalar="float", units=("gauss",)
        ),
    ),
    filter.MagDipAngleErrorAdaptiveMeasurementResponse: (
        Parameter("enable", "enable", "scalar", scalar="bool"),
        Parameter("frequency", "frequency", "scalar", scalar="float", units=("Hz",)),
        Parameter("high_limit", "high_limit", "scalar", scalar="float", units=("rad",)),
        Parameter(
            "high_limit_uncertainty",
            "high_limit_uncertainty",
            "scalar",
            scalar="float",
            units=("rad",),
        ),
        Parameter(
            "minimum_uncertainty", "minimum_uncertainty", "scalar", scalar="float", units=("rad",)
        ),
    ),
    filter.AltitudeAidingResponse: (
        Parameter("selector", "selector", "scalar", scalar="u8", type=filter.AltitudeAidingSource),
    ),
    filter.PitchRollAidingResponse: (
        Parameter("aiding", "aiding", "scalar", scalar="u8", type=filter.PitchRollAidingSource),
    ),
    filter.MagneticInclinationSourceResponse: (
        Parameter("source", "source", "scalar", scalar="u8", type=filter.MagParameterSource),
        Parameter("inclination", "inclination", "scalar", scalar="float", units=("rad",)),
    ),
    filter.MagneticMagnitudeSourceResponse: (
        Parameter("source", "source", "scalar", scalar="u8", type=filter.MagParameterSource),
        Parameter("magnitude", "magnitude", "scalar", scalar="float", units=("gauss",)),
    ),
    filter.SensorToVehicleRotationDcmResponse: (
        Parameter(
            "dcm",
            "dcm",
            "array",
            scalar="float",
            elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"),
            units=("1",),
        ),
    ),
    filter.SensorToVehicleRotationQuaternionResponse: (
        Parameter(
            "q",
            "q",
            "array",
            scalar="float",
            elements=("w", "x", "y", "z"),
            units=("1",),
            magnitude=(0.999, 1.001),
        ),
    ),
    filter.AidingMeasurementEnableResponse: (
        Parameter(
            "aiding_source", "aiding_source", "scalar", scalar="u16", type=filter.AidingSource
        ),
        Parameter("enable", "enable", "scalar", scalar="bool"),
    ),
    filter.KinematicConstraintResponse: (
        Parameter(
            "accel_constraint",
            "accel_constraint",
            "scalar",
            scalar="u8",
            default=0,
            type=filter.AccelConstraint,
        ),
        Parameter(
            "velocity_constraint",
            "velocity_constraint",
            "scalar",
            scalar="u8",
            default=0,
            type=filter.VelocityConstraint,
        ),
        Parameter(
            "angular_constraint",
            "angular_constraint",
            "scalar",
            scalar="u8",
            default=0,
            type=filter.AngularConstraint,
        ),
    ),
    filter.InitializationConfigResponse: (
        Parameter(
            "wait_for_run_command",
            "wait_for_run_command",
            "scalar",
            scalar="u8",
            minimum=0,
            maximum=1,
        ),
        Parameter(
            "initial_condition_source",
            "initial_condition_source",
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
    filter.AdaptiveFilterOptionsResponse: (
        Parameter("level", "level", "scalar", scalar="u8", default=2, type=filter.AdaptiveLevel),
        Parameter("time_limit", "time_limit", "scalar", scalar="u16", units=("ms",)),
    ),
    filter.MultiAntennaOffsetResponse: (
        Parameter("receiver_id", "receiver_id", "scalar", scalar="u8", minimum=1),
        Parameter(
            "antenna_offset",
            "antenna_offset",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
            magnitude=(None, 10),
            frame="vehicle",
        ),
    ),
    filter.RelativePositionConfigResponse: (
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
            "reference_point", "reference_point", "scalar", scalar="u8", type=filter.ReferencePoint
        ),
        Parameter(
            "lever_arm_offset",
            "lever_arm_offset",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
            magnitude=(None, 10),
            frame="vehicle",
        ),
    ),
    filter.SpeedLeverArmResponse: (
        Parameter("source", "source", "scalar", scalar="u8", default=1),
        Parameter(
            "lever_arm_offset",
            "lever_arm_offset",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
            frame="vehicle",
        ),
    ),
    filter.VerticalGyroConstraintControlResponse: (
        Parameter("enable", "enable", "scalar", scalar="u8", minimum=0, maximum=1),
    ),
    filter.WheeledVehicleConstraintControlResponse: (
        Parameter("enable", "enable", "scalar", scalar="u8", minimum=0, maximum=1),
    ),
    filter.GnssAntennaCalibrationControlResponse: (
        Parameter("enable", "enable", "scalar", scalar="u8", minimum=0, maximum=1),
        Parameter(
            "max_offset",
            "max_offset",
            "scalar",
            scalar="float",
            units=("m",),
            minimum=0,
            maximum=0.5,
            default=0.1,
            frame="vehicle",
        ),
    ),
    gnss.ReceiverInfoEntry: (
        Parameter("receiver_id", "receiver_id", "scalar", scalar="u8", minimum=1),
        Parameter(
            "mip_data_descriptor_set",
            "mip_data_descriptor_set",
            "scalar",
            scalar="u8",
            minimum=128,
            maximum=254,
        ),
        Parameter("description", "description", "text", scalar="char", length=32),
    ),
    gnss.ReceiverInfo: (),
    gnss.SignalConfig: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("gps_enable", "gps_enable", "scalar", scalar="u8", type=gnss.GpsSignals),
        Parameter(
            "glonass_enable", "glonass_enable", "scalar", scalar="u8", type=gnss.GlonassSignals
        ),
        Parameter(
            "galileo_enable", "galileo_enable", "scalar", scalar="u8", type=gnss.GalileoSignals
        ),
        Parameter("beidou_enable", "beidou_enable", "scalar", scalar="u8", type=gnss.BeidouSignals),
        Parameter("reserved", "reserved", "array", scalar="u8", length=4, default=0),
    ),
    gnss.RtkDongleConfig: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("enable", "enable", "scalar", scalar="u8", minimum=0, maximum=1),
        Parameter("reserved", "reserved", "array", scalar="u8", length=3, default=0),
    ),
    gnss.SpartnConfig: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("enable", "enable", "scalar", scalar="u8", minimum=0, maximum=1),
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
    gnss.SignalConfigResponse: (
        Parameter("gps_enable", "gps_enable", "scalar", scalar="u8", type=gnss.GpsSignals),
        Parameter(
            "glonass_enable", "glonass_enable", "scalar", scalar="u8", type=gnss.GlonassSignals
        ),
        Parameter(
            "galileo_enable", "galileo_enable", "scalar", scalar="u8", type=gnss.GalileoSignals
        ),
        Parameter("beidou_enable", "beidou_enable", "scalar", scalar="u8", type=gnss.BeidouSignals),
        Parameter("reserved", "reserved", "array", scalar="u8", length=4, default=0),
    ),
    gnss.RtkDongleConfigResponse: (
        Parameter("enable", "enable", "scalar", scalar="u8", minimum=0, maximum=1),
        Parameter("reserved", "reserved", "array", scalar="u8", length=3, default=0),
    ),
    gnss.SpartnConfigResponse: (
        Parameter("enable", "enable", "scalar", scalar="u8", minimum=0, maximum=1),
        Parameter("type", "type", "scalar", scalar="u8", type=gnss.SpartnConnection),
        Parameter("current_key_tow", "current_key_tow", "scalar", scalar="u32", units=("s",)),
        Parameter("current_key_week", "current_key_week", "scalar", scalar="u16", units=("week",)),
        Parameter("current_key", "current_key", "array", scalar="u8", length=32),
        Parameter("next_key_tow", "next_key_tow", "scalar", scalar="u32", units=("s",)),
        Parameter("next_key_week", "next_key_week", "scalar", scalar="u16", units=("week",)),
        Parameter("next_key", "next_key", "array", scalar="u8", length=32),
    ),
    rtk.GetStatusFlags: (),
    rtk.GetImei: (),
    rtk.GetImsi: (),
    rtk.GetIccid: (),
    rtk.GetRssi: (),
    rtk.ConnectedDeviceType: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("device_type", "device_type", "scalar", scalar="u8", type=rtk.ConnectedDevice),
    ),
    rtk.GetActivationCode: (),
    rtk.GetModemFirmwareVersion: (),
    rtk.ServiceStatus: (
        Parameter("reserved1", "reserved1", "scalar", scalar="u32", default=0),
        Parameter("reserved2", "reserved2", "scalar", scalar="u32", default=0),
    ),
    rtk.EraseStorage: (Parameter("media", "media", "scalar", scalar="u8", type=rtk.StorageMedium),),
    rtk.LedControl: (
        Parameter("primary_color", "primary_color", "array", scalar="u8", length=3),
        Parameter("alternate_color", "alternate_color", "array", scalar="u8", length=3),
        Parameter("action", "action", "scalar", scalar="u8", type=rtk.LedAction),
        Parameter("period", "period", "scalar", scalar="u32"),
    ),
    rtk.ModemHardReset: (),
    rtk.GetStatusFlagsResponse: (
        Parameter("flags", "flags", "scalar", scalar="u32", type=types.RtkStatusFlags),
    ),
    rtk.GetImeiResponse: (Parameter("imei", "imei", "text", scalar="char", length=32),),
    rtk.GetImsiResponse: (Parameter("imsi", "imsi", "text", scalar="char", length=32),),
    rtk.GetIccidResponse: (Parameter("iccid", "iccid", "text", scalar="char", length=32),),
    rtk.GetRssiResponse: (
        Parameter("valid", "valid", "scalar", scalar="bool"),
        Parameter("rssi", "rssi", "scalar", scalar="s32", valid=("valid",)),
        Parameter("signal_quality", "signal_quality", "scalar", scalar="s32", valid=("valid",)),
    ),
    rtk.ConnectedDeviceTypeResponse: (
        Parameter("device_type", "device_type", "scalar", scalar="u8", type=rtk.ConnectedDevice),
    ),
    rtk.GetActivationCodeResponse: (
        Parameter("activation_code", "activation_code", "text", scalar="char", length=32),
    ),
    rtk.GetModemFirmwareVersionResponse: (
        Parameter(
            "modem_firmware_version", "modem_firmware_version", "text", scalar="char", length=32
        ),
    ),
    rtk.ServiceStatusResponse: (
        Parameter("flags", "flags", "scalar", scalar="u8", type=rtk.ServiceFlags),
        Parameter("received_bytes", "received_bytes", "scalar", scalar="u32", units=("byte",)),
        Parameter("last_bytes", "last_bytes", "scalar", scalar="u32", units=("byte",)),
        Parameter("last_bytes_time", "last_bytes_time", "scalar", scalar="u64"),
    ),
    aiding.MeasurementTime: (
        Parameter("timebase", "timebase", "scalar", scalar="u8", type=aiding.Timebase),
        Parameter("reserved", "reserved", "scalar", scalar="u8", default=1),
        Parameter("nanoseconds", "nanoseconds", "scalar", scalar="u64", units=("ns",)),
    ),
    aiding.FrameConfig: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("frame_id", "frame_id", "scalar", scalar="u8", minimum=1, maximum=4),
        Parameter("format", "format", "scalar", scalar="u8", type=aiding.AidingFrameFormat),
        Parameter("tracking_enabled", "tracking_enabled", "scalar", scalar="bool"),
        Parameter(
            "translation",
            "translation",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
            frame="vehicle",
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
                    minimum=-3.141592653589793,
                    maximum=3.141592653589793,
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
        Parameter("frame_id", "frame_id", "scalar", scalar="u8", minimum=1, maximum=4),
        Parameter(
            "position",
            "position",
            "array",
            scalar="double",
            elements=("x", "y", "z"),
            units=("m",),
            valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"),
            frame="ecef",
        ),
        Parameter(
            "uncertainty",
            "uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
            valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"),
            above=0,
            frame="ecef",
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=aiding.AxisFlags),
    ),
    aiding.LlhPosition: (
        Parameter("time", "time", "struct", type=aiding.MeasurementTime),
        Parameter("frame_id", "frame_id", "scalar", scalar="u8", minimum=1, maximum=4),
        Parameter(
            "latitude",
            "latitude",
            "scalar",
            scalar="double",
            units=("deg",),
            valid=("valid_flags.latitude",),
            frame="llh",
        ),
        Parameter(
            "longitude",
            "longitude",
            "scalar",
            scalar="double",
            units=("deg",),
            valid=("valid_flags.longitude",),
            frame="llh",
        ),
        Parameter(
            "height",
            "height",
            "scalar",
            scalar="double",
            units=("m",),
            valid=("valid_flags.height",),
            frame="llh",
        ),
        Parameter(
            "uncertainty",
            "uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
            valid=("valid_flags.latitude", "valid_flags.longitude", "valid_flags.height"),
            above=0,
            frame="ned",
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=aiding.LlhAxisFlags),
    ),
    aiding.HeightAboveEllipsoid: (
        Parameter("time", "time", "struct", type=aiding.MeasurementTime),
        Parameter("frame_id", "frame_id", "scalar", scalar="u8", minimum=1, maximum=4),
        Parameter("height", "height", "scalar", scalar="float", units=("m",), frame="llh"),
        Parameter("uncertainty", "uncertainty", "scalar", scalar="float", units=("m",)),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16"),
    ),
    aiding.EcefVelocity: (
        Parameter("time", "time", "struct", type=aiding.MeasurementTime),
        Parameter("frame_id", "frame_id", "scalar", scalar="u8", minimum=1, maximum=4),
        Parameter(
            "velocity",
            "velocity",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s",),
            valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"),
            frame="ecef",
        ),
        Parameter(
            "uncertainty",
            "uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s",),
            valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"),
            above=0,
            frame="ecef",
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=aiding.AxisFlags),
    ),
    aiding.NedVelocity: (
        Parameter("time", "time", "struct", type=aiding.MeasurementTime),
        Parameter("frame_id", "frame_id", "scalar", scalar="u8", minimum=1, maximum=4),
        Parameter(
            "velocity",
            "velocity",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s",),
            valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"),
            frame="ned",
        ),
        Parameter(
            "uncertainty",
            "uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s",),
            valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"),
            above=0,
            frame="ned",
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=aiding.AxisFlags),
    ),
    aiding.BodyFrameVelocity: (
        Parameter("time", "time", "struct", type=aiding.MeasurementTime),
        Parameter("frame_id", "frame_id", "scalar", scalar="u8", minimum=1, maximum=4),
        Parameter(
            "velocity",
            "velocity",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s",),
            valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"),
            frame="aiding",
        ),
        Parameter(
            "uncertainty",
            "uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s",),
            valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"),
            above=0,
            frame="aiding",
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=aiding.AxisFlags),
    ),
    aiding.TrueHeading: (
        Parameter("time", "time", "struct", type=aiding.MeasurementTime),
        Parameter("frame_id", "frame_id", "scalar", scalar="u8", minimum=1, maximum=4),
        Parameter(
            "heading",
            "heading",
            "scalar",
            scalar="float",
            units=("rad",),
            minimum=-3.141592653589793,
            maximum=3.141592653589793,
            frame="ned",
        ),
        Parameter("uncertainty", "uncertainty", "scalar", scalar="float", units=("rad",), above=0),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16"),
    ),
    aiding.MagneticField: (
        Parameter("time", "time", "struct", type=aiding.MeasurementTime),
        Parameter("frame_id", "frame_id", "scalar", scalar="u8", minimum=1, maximum=4),
        Parameter(
            "magnetic_field",
            "magnetic_field",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("gauss",),
            valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"),
            frame="aiding",
        ),
        Parameter(
            "uncertainty",
            "uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("gauss",),
            valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"),
            above=0,
            frame="aiding",
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=aiding.AxisFlags),
    ),
    aiding.Pressure: (
        Parameter("time", "time", "struct", type=aiding.MeasurementTime),
        Parameter("frame_id", "frame_id", "scalar", scalar="u8", minimum=1, maximum=4),
        Parameter("pressure", "pressure", "scalar", scalar="float", units=("mbar",)),
        Parameter("uncertainty", "uncertainty", "scalar", scalar="float", units=("mbar",), above=0),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16"),
    ),
    aiding.FrameConfigResponse: (
        Parameter("frame_id", "frame_id", "scalar", scalar="u8", minimum=1, maximum=4),
        Parameter("format", "format", "scalar", scalar="u8", type=aiding.AidingFrameFormat),
        Parameter("tracking_enabled", "tracking_enabled", "scalar", scalar="bool"),
        Parameter(
            "translation",
            "translation",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
            frame="vehicle",
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
                    minimum=-3.141592653589793,
                    maximum=3.141592653589793,
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
    system.InterfaceControl: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("port", "port", "scalar", scalar="u8", type=system.CommInterface),
        Parameter(
            "protocols_incoming",
            "protocols_incoming",
            "scalar",
            scalar="u32",
            type=system.CommProtocols,
        ),
        Parameter(
            "protocols_outgoing",
            "protocols_outgoing",
            "scalar",
            scalar="u32",
            type=system.CommProtocols,
        ),
    ),
    system.CommMode: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("mode", "mode", "scalar", scalar="u8", default=1, type=system.ProtocolMode),
    ),
    system.InterfaceControlResponse: (
        Parameter("port", "port", "scalar", scalar="u8", type=system.CommInterface),
        Parameter(
            "protocols_incoming",
            "protocols_incoming",
            "scalar",
            scalar="u32",
            type=system.CommProtocols,
        ),
        Parameter(
            "protocols_outgoing",
            "protocols_outgoing",
            "scalar",
            scalar="u32",
            type=system.CommProtocols,
        ),
    ),
    system.CommModeResponse: (
        Parameter("mode", "mode", "scalar", scalar="u8", default=1, type=system.ProtocolMode),
    ),
    sensor.RawAccel: (
        Parameter(
            "raw_accel",
            "raw_accel",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("1",),
            frame="sensor",
        ),
    ),
    sensor.RawGyro: (
        Parameter(
            "raw_gyro",
            "raw_gyro",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("1",),
            frame="sensor",
        ),
    ),
    sensor.RawMag: (
        Parameter(
            "raw_mag",
            "raw_mag",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("1",),
            frame="vehicle",
        ),
    ),
    sensor.ScaledAccel: (
        Parameter(
            "scaled_accel",
            "scaled_accel",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("g",),
            frame="vehicle",
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
            frame="vehicle",
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
            frame="vehicle",
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
            frame="vehicle",
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
            frame="vehicle",
        ),
    ),
    sensor.CompOrientationMatrix: (
        Parameter(
            "m",
            "m",
            "array",
            scalar="float",
            elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"),
            units=("1",),
        ),
    ),
    sensor.CompQuaternion: (
        Parameter("q", "q", "array", scalar="float", elements=("w", "x", "y", "z"), units=("1",)),
    ),
    sensor.CompOrientationUpdateMatrix: (
        Parameter(
            "m",
            "m",
            "array",
            scalar="float",
            elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"),
            units=("1",),
        ),
    ),
    sensor.CompEulerAngles: (
        Parameter("roll", "roll", "scalar", scalar="float", units=("rad",)),
        Parameter("pitch", "pitch", "scalar", scalar="float", units=("rad",)),
        Parameter("yaw", "yaw", "scalar", scalar="float", units=("rad",)),
    ),
    sensor.OrientationRawTemperature: (
        Parameter(
            "raw_temperature", "raw_temperature", "array", scalar="u16", length=4, units=("1",)
        ),
    ),
    sensor.InternalTimestamp: (
        Parameter("counts", "counts", "scalar", scalar="u32", units=("1",)),
    ),
    sensor.PpsTimestamp: (
        Parameter("seconds", "seconds", "scalar", scalar="u32", units=("s",)),
        Parameter("useconds", "useconds", "scalar", scalar="u32", units=("us",)),
    ),
    sensor.NorthVector: (
        Parameter(
            "stabilized_mag",
            "stabilized_mag",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("gauss",),
            frame="sensor",
        ),
    ),
    sensor.UpVector: (
        Parameter(
            "stabilized_accel",
            "stabilized_accel",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("g",),
            frame="sensor",
        ),
    ),
    sensor.GpsTimestamp: (
        Parameter(
            "tow", "tow", "scalar", scalar="double", units=("s",), valid=("valid_flags.tow_valid",)
        ),
        Parameter(
            "week_number",
            "week_number",
            "scalar",
            scalar="u16",
            units=("week",),
            valid=("valid_flags.week_number_valid",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=types.SensorGpsTimestampFlags
        ),
    ),
    sensor.TemperatureStatistics: (
        Parameter("min_temperature", "min_temperature", "scalar", scalar="float", units=("degC",)),
        Parameter("max_temperature", "max_temperature", "scalar", scalar="float", units=("degC",)),
        Parameter(
            "mean_temperature", "mean_temperature", "scalar", scalar="float", units=("degC",)
        ),
    ),
    sensor.RawPressure: (
        Parameter("raw_pressure", "raw_pressure", "scalar", scalar="float", units=("1",)),
    ),
    sensor.ScaledPressure: (
        Parameter("scaled_pressure", "scaled_pressure", "scalar", scalar="float", units=("mbar",)),
    ),
    sensor.OverrangeStatus: (
        Parameter("status", "status", "scalar", scalar="u16", type=sensor.OverrangeFlags),
    ),
    sensor.Odometer: (
        Parameter(
            "speed",
            "speed",
            "scalar",
            scalar="float",
            units=("m/s",),
            valid=("valid_flags.odometer",),
        ),
        Parameter(
            "uncertainty",
            "uncertainty",
            "scalar",
            scalar="float",
            units=("m/s",),
            valid=("valid_flags.odometer",),
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=sensor.OdometerFlags),
    ),
    filter_data.LlhPosition: (
        Parameter(
            "latitude",
            "latitude",
            "scalar",
            scalar="double",
            units=("deg",),
            valid=("valid_flags.valid",),
            frame="llh",
        ),
        Parameter(
            "longitude",
            "longitude",
            "scalar",
            scalar="double",
            units=("deg",),
            valid=("valid_flags.valid",),
            frame="llh",
        ),
        Parameter(
            "ellipsoid_height",
            "ellipsoid_height",
            "scalar",
            scalar="double",
            units=("m",),
            valid=("valid_flags.valid",),
            frame="llh",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.NedVelocity: (
        Parameter(
            "north",
            "north",
            "scalar",
            scalar="float",
            units=("m/s",),
            valid=("valid_flags.valid",),
            frame="ned",
        ),
        Parameter(
            "east",
            "east",
            "scalar",
            scalar="float",
            units=("m/s",),
            valid=("valid_flags.valid",),
            frame="ned",
        ),
        Parameter(
            "down",
            "down",
            "scalar",
            scalar="float",
            units=("m/s",),
            valid=("valid_flags.valid",),
            frame="ned",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.AttitudeQuaternion: (
        Parameter(
            "q",
            "q",
            "array",
            scalar="float",
            elements=("w", "x", "y", "z"),
            units=("1",),
            valid=("valid_flags.valid",),
            frame="ned",
        ),
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
            valid=("valid_flags.valid",),
            frame="ned",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.EulerAngles: (
        Parameter(
            "roll",
            "roll",
            "scalar",
            scalar="float",
            units=("rad",),
            valid=("valid_flags.valid",),
            frame="ned",
        ),
        Parameter(
            "pitch",
            "pitch",
            "scalar",
            scalar="float",
            units=("rad",),
            valid=("valid_flags.valid",),
            frame="ned",
        ),
        Parameter(
            "yaw",
            "yaw",
            "scalar",
            scalar="float",
            units=("rad",),
            valid=("valid_flags.valid",),
            frame="ned",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.GyroBias: (
        Parameter(
            "bias",
            "bias",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("rad/s",),
            valid=("valid_flags.valid",),
            frame="sensor",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.AccelBias: (
        Parameter(
            "bias",
            "bias",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s^2",),
            valid=("valid_flags.valid",),
            frame="sensor",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.LlhPositionUncertainty: (
        Parameter(
            "north",
            "north",
            "scalar",
            scalar="float",
            units=("m",),
            valid=("valid_flags.valid",),
            frame="ned",
        ),
        Parameter(
            "east",
            "east",
            "scalar",
            scalar="float",
            units=("m",),
            valid=("valid_flags.valid",),
            frame="ned",
        ),
        Parameter(
            "down",
            "down",
            "scalar",
            scalar="float",
            units=("m",),
            valid=("valid_flags.valid",),
            frame="ned",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.NedVelocityUncertainty: (
        Parameter(
            "north",
            "north",
            "scalar",
            scalar="float",
            units=("m/s",),
            valid=("valid_flags.valid",),
            frame="ned",
        ),
        Parameter(
            "east",
            "east",
            "scalar",
            scalar="float",
            units=("m/s",),
            valid=("valid_flags.valid",),
            frame="ned",
        ),
        Parameter(
            "down",
            "down",
            "scalar",
            scalar="float",
            units=("m/s",),
            valid=("valid_flags.valid",),
            frame="ned",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.EulerAnglesUncertainty: (
        Parameter(
            "roll", "roll", "scalar", scalar="float", units=("rad",), valid=("valid_flags.valid",)
        ),
        Parameter(
            "pitch", "pitch", "scalar", scalar="float", units=("rad",), valid=("valid_flags.valid",)
        ),
        Parameter(
            "yaw", "yaw", "scalar", scalar="float", units=("rad",), valid=("valid_flags.valid",)
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.GyroBiasUncertainty: (
        Parameter(
            "bias_uncertainty",
            "bias_uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("rad/s",),
            valid=("valid_flags.valid",),
            frame="sensor",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.AccelBiasUncertainty: (
        Parameter(
            "bias_uncertainty",
            "bias_uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s^2",),
            valid=("valid_flags.valid",),
            frame="sensor",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.LinearAccel: (
        Parameter(
            "accel",
            "accel",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s^2",),
            valid=("valid_flags.valid",),
            frame="vehicle",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.CompAngularRate: (
        Parameter(
            "gyro",
            "gyro",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("rad/s",),
            valid=("valid_flags.valid",),
            frame="vehicle",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.Wgs84GravityMagnitude: (
        Parameter(
            "gravity_magnitude",
            "gravity_magnitude",
            "scalar",
            scalar="float",
            units=("m/s^2",),
            valid=("valid_flags.valid",),
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
        Parameter(
            "tow", "tow", "scalar", scalar="double", units=("s",), valid=("valid_flags.valid",)
        ),
        Parameter(
            "week_number",
            "week_number",
            "scalar",
            scalar="u16",
            units=("week",),
            valid=("valid_flags.valid",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.QuaternionAttitudeUncertainty: (
        Parameter(
            "q",
            "q",
            "array",
            scalar="float",
            elements=("w", "x", "y", "z"),
            units=("1",),
            valid=("valid_flags.valid",),
        ),
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
            valid=("valid_flags.valid",),
            frame="vehicle",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.HeadingUpdateState: (
        Parameter(
            "heading",
            "heading",
            "scalar",
            scalar="float",
            units=("rad",),
            valid=("valid_flags.valid",),
        ),
        Parameter(
            "heading_uncertainty",
            "heading_uncertainty",
            "scalar",
            scalar="float",
            units=("rad",),
            valid=("valid_flags.valid",),
        ),
        Parameter("source", "source", "scalar", scalar="u16", type=filter_data.HeadingSourceFlags),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.MagneticModel: (
        Parameter(
            "intensity_north",
            "intensity_north",
            "scalar",
            scalar="float",
            units=("gauss",),
            valid=("valid_flags.valid",),
            frame="ned",
        ),
        Parameter(
            "intensity_east",
            "intensity_east",
            "scalar",
            scalar="float",
            units=("gauss",),
            valid=("valid_flags.valid",),
            frame="ned",
        ),
        Parameter(
            "intensity_down",
            "intensity_down",
            "scalar",
            scalar="float",
            units=("gauss",),
            valid=("valid_flags.valid",),
            frame="ned",
        ),
        Parameter(
            "inclination",
            "inclination",
            "scalar",
            scalar="float",
            units=("rad",),
            valid=("valid_flags.valid",),
        ),
        Parameter(
            "declination",
            "declination",
            "scalar",
            scalar="float",
            units=("rad",),
            valid=("valid_flags.valid",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.GyroScaleFactor: (
        Parameter(
            "scale_factor",
            "scale_factor",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("1",),
            valid=("valid_flags.valid",),
            frame="sensor",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.AccelScaleFactor: (
        Parameter(
            "scale_factor",
            "scale_factor",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("1",),
            valid=("valid_flags.valid",),
            frame="sensor",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.GyroScaleFactorUncertainty: (
        Parameter(
            "scale_factor_uncertainty",
            "scale_factor_uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("1",),
            valid=("valid_flags.valid",),
            frame="sensor",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.AccelScaleFactorUncertainty: (
        Parameter(
            "scale_factor_uncertainty",
            "scale_factor_uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("1",),
            valid=("valid_flags.valid",),
            frame="sensor",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.MagBias: (
        Parameter(
            "bias",
            "bias",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("gauss",),
            valid=("valid_flags.valid",),
            frame="sensor",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.MagBiasUncertainty: (
        Parameter(
            "bias_uncertainty",
            "bias_uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("gauss",),
            valid=("valid_flags.valid",),
            frame="sensor",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.CompAccel: (
        Parameter(
            "accel",
            "accel",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s^2",),
            valid=("valid_flags.valid",),
            frame="vehicle",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.StandardAtmosphere: (
        Parameter(
            "geometric_altitude",
            "geometric_altitude",
            "scalar",
            scalar="float",
            units=("m",),
            valid=("valid_flags.valid",),
        ),
        Parameter(
            "geopotential_altitude",
            "geopotential_altitude",
            "scalar",
            scalar="float",
            units=("m",),
            valid=("valid_flags.valid",),
        ),
        Parameter(
            "standard_temperature",
            "standard_temperature",
            "scalar",
            scalar="float",
            units=("degC",),
            valid=("valid_flags.valid",),
        ),
        Parameter(
            "standard_pressure",
            "standard_pressure",
            "scalar",
            scalar="float",
            units=("mbar",),
            valid=("valid_flags.valid",),
        ),
        Parameter(
            "standard_density",
            "standard_density",
            "scalar",
            scalar="float",
            units=("kg/m^3",),
            valid=("valid_flags.valid",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.PressureAltitude: (
        Parameter(
            "pressure_altitude",
            "pressure_altitude",
            "scalar",
            scalar="float",
            units=("m",),
            valid=("valid_flags.valid",),
            maximum=84852,
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.DensityAltitude: (
        Parameter(
            "density_altitude",
            "density_altitude",
            "scalar",
            scalar="float",
            units=("m",),
            valid=("valid_flags.valid",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.MagOffset: (
        Parameter(
            "hard_iron",
            "hard_iron",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("gauss",),
            valid=("valid_flags.valid",),
            frame="sensor",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.MagMatrix: (
        Parameter(
            "soft_iron",
            "soft_iron",
            "array",
            scalar="float",
            elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"),
            units=("1",),
            valid=("valid_flags.valid",),
            frame="sensor",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.MagOffsetUncertainty: (
        Parameter(
            "hard_iron_uncertainty",
            "hard_iron_uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("gauss",),
            valid=("valid_flags.valid",),
            frame="sensor",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.MagMatrixUncertainty: (
        Parameter(
            "soft_iron_uncertainty",
            "soft_iron_uncertainty",
            "array",
            scalar="float",
            elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"),
            units=("1",),
            valid=("valid_flags.valid",),
            frame="sensor",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.MagCovarianceMatrix: (
        Parameter(
            "covariance",
            "covariance",
            "array",
            scalar="float",
            elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"),
            valid=("valid_flags.valid",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.MagResidualVector: (
        Parameter(
            "residual",
            "residual",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("gauss",),
            valid=("valid_flags.valid",),
            frame="vehicle",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.AntennaOffsetCorrection: (
        Parameter(
            "offset",
            "offset",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
            valid=("valid_flags.valid",),
            frame="vehicle",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.AntennaOffsetCorrectionUncertainty: (
        Parameter(
            "offset_uncertainty",
            "offset_uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
            valid=("valid_flags.valid",),
            frame="vehicle",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.ClockCorrection: (
        Parameter("receiver_id", "receiver_id", "scalar", scalar="u8", minimum=1),
        Parameter(
            "bias", "bias", "scalar", scalar="float", units=("s",), valid=("valid_flags.valid",)
        ),
        Parameter(
            "bias_drift",
            "bias_drift",
            "scalar",
            scalar="float",
            units=("s/s",),
            valid=("valid_flags.valid",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.ClockCorrectionUncertainty: (
        Parameter("receiver_id", "receiver_id", "scalar", scalar="u8", minimum=1),
        Parameter(
            "bias_uncertainty",
            "bias_uncertainty",
            "scalar",
            scalar="float",
            units=("s",),
            valid=("valid_flags.valid",),
        ),
        Parameter(
            "bias_drift_uncertainty",
            "bias_drift_uncertainty",
            "scalar",
            scalar="float",
            units=("s/s",),
            valid=("valid_flags.valid",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.MultiAntennaOffsetCorrection: (
        Parameter("receiver_id", "receiver_id", "scalar", scalar="u8"),
        Parameter(
            "offset",
            "offset",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
            valid=("valid_flags.valid",),
            frame="vehicle",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.MultiAntennaOffsetCorrectionUncertainty: (
        Parameter("receiver_id", "receiver_id", "scalar", scalar="u8"),
        Parameter(
            "offset_uncertainty",
            "offset_uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
            valid=("valid_flags.valid",),
            frame="vehicle",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.EcefPositionUncertainty: (
        Parameter(
            "position_uncertainty",
            "position_uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
            valid=("valid_flags.valid",),
            frame="ecef",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.EcefVelocityUncertainty: (
        Parameter(
            "velocity_uncertainty",
            "velocity_uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s",),
            valid=("valid_flags.valid",),
            frame="ecef",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.EcefPosition: (
        Parameter(
            "position",
            "position",
            "array",
            scalar="double",
            elements=("x", "y", "z"),
            units=("m",),
            valid=("valid_flags.valid",),
            frame="ecef",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.EcefVelocity: (
        Parameter(
            "velocity",
            "velocity",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s",),
            valid=("valid_flags.valid",),
            frame="ecef",
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
            valid=("valid_flags.valid",),
            frame="ned",
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.GnssPositionAidingStatus: (
        Parameter("receiver_id", "receiver_id", "scalar", scalar="u8"),
        Parameter("tow", "tow", "scalar", scalar="float", units=("s",)),
        Parameter("status", "status", "scalar", scalar="u16", type=filter_data.GnssAidingStatus),
        Parameter("reserved", "reserved", "array", scalar="u8", length=8, default=0),
    ),
    filter_data.GnssAttitudeAidingStatus: (
        Parameter("tow", "tow", "scalar", scalar="float", units=("s",)),
        Parameter("status", "status", "scalar", scalar="u16", type=filter_data.GnssAidingStatus),
        Parameter("reserved", "reserved", "array", scalar="u8", length=8, default=0),
    ),
    filter_data.HeadingAidingStatus: (
        Parameter("tow", "tow", "scalar", scalar="float", units=("s",)),
        Parameter("type", "type", "scalar", scalar="u8", type=filter_data.HeadingAidingType),
        Parameter("reserved", "reserved", "array", scalar="float", length=2, default=0.0),
    ),
    filter_data.AidingMeasurementSummary: (
        Parameter("tow", "tow", "scalar", scalar="float", units=("s",)),
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
            "scale_factor_error",
            "scale_factor_error",
            "scalar",
            scalar="float",
            units=("1",),
            valid=("valid_flags.valid",),
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
            valid=("valid_flags.valid",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags
        ),
    ),
    filter_data.GnssDualAntennaStatus: (
        Parameter(
            "tow", "tow", "scalar", scalar="float", units=("s",), valid=("valid_flags.valid",)
        ),
        Parameter(
            "heading",
            "heading",
            "scalar",
            scalar="float",
            units=("rad",),
            valid=("valid_flags.valid",),
        ),
        Parameter(
            "heading_uncertainty",
            "heading_uncertainty",
            "scalar",
            scalar="float",
            units=("rad",),
            valid=("valid_flags.valid",),
        ),
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
    filter_data.AidingFrameConfigError: (
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
    filter_data.AidingFrameConfigErrorUncertainty: (
        Parameter("frame_id", "frame_id", "scalar", scalar="u8"),
        Parameter(
            "translation_uncertainty",
            "translation_uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
        ),
        Parameter(
            "attitude_uncertainty",
            "attitude_uncertainty",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("rad",),
        ),
    ),
    gnss_1.LlhPosition: (
        Parameter(
            "latitude",
            "latitude",
            "scalar",
            scalar="double",
            units=("deg",),
            valid=("valid_flags.lat_lon",),
            frame="llh",
        ),
        Parameter(
            "longitude",
            "longitude",
            "scalar",
            scalar="double",
            units=("deg",),
            valid=("valid_flags.lat_lon",),
            frame="llh",
        ),
        Parameter(
            "ellipsoid_height",
            "ellipsoid_height",
            "scalar",
            scalar="double",
            units=("m",),
            valid=("valid_flags.ellipsoid_height",),
            frame="llh",
        ),
        Parameter(
            "msl_height",
            "msl_height",
            "scalar",
            scalar="double",
            units=("m",),
            valid=("valid_flags.msl_height",),
        ),
        Parameter(
            "horizontal_accuracy",
            "horizontal_accuracy",
            "scalar",
            scalar="float",
            units=("m",),
            valid=("valid_flags.horizontal_accuracy",),
        ),
        Parameter(
            "vertical_accuracy",
            "vertical_accuracy",
            "scalar",
            scalar="float",
            units=("m",),
            valid=("valid_flags.vertical_accuracy",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.LlhPositionFlags
        ),
    ),
    gnss_1.EcefPosition: (
        Parameter(
            "position",
            "position",
            "array",
            scalar="double",
            elements=("x", "y", "z"),
            units=("m",),
            valid=("valid_flags.position",),
            frame="ecef",
        ),
        Parameter(
            "position_accuracy",
            "position_accuracy",
            "scalar",
            scalar="float",
            units=("m",),
            valid=("valid_flags.position_accuracy",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.EcefPositionFlags
        ),
    ),
    gnss_1.NedVelocity: (
        Parameter(
            "velocity",
            "velocity",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s",),
            valid=("valid_flags.velocity",),
            frame="ned",
        ),
        Parameter(
            "speed",
            "speed",
            "scalar",
            scalar="float",
            units=("m/s",),
            valid=("valid_flags.speed_3d",),
        ),
        Parameter(
            "ground_speed",
            "ground_speed",
            "scalar",
            scalar="float",
            units=("m/s",),
            valid=("valid_flags.ground_speed",),
        ),
        Parameter(
            "heading",
            "heading",
            "scalar",
            scalar="float",
            units=("deg",),
            valid=("valid_flags.heading",),
            frame="ned",
        ),
        Parameter(
            "speed_accuracy",
            "speed_accuracy",
            "scalar",
            scalar="float",
            units=("m/s",),
            valid=("valid_flags.speed_accuracy",),
        ),
        Parameter(
            "heading_accuracy",
            "heading_accuracy",
            "scalar",
            scalar="float",
            units=("deg",),
            valid=("valid_flags.heading_accuracy",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.NedVelocityFlags
        ),
    ),
    gnss_1.EcefVelocity: (
        Parameter(
            "velocity",
            "velocity",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s",),
            valid=("valid_flags.velocity",),
            frame="ecef",
        ),
        Parameter(
            "velocity_accuracy",
            "velocity_accuracy",
            "scalar",
            scalar="float",
            units=("m/s",),
            valid=("valid_flags.velocity_accuracy",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.EcefVelocityFlags
        ),
    ),
    gnss_1.Dop: (
        Parameter(
            "gdop", "gdop", "scalar", scalar="float", units=("1",), valid=("valid_flags.gdop",)
        ),
        Parameter(
            "pdop", "pdop", "scalar", scalar="float", units=("1",), valid=("valid_flags.pdop",)
        ),
        Parameter(
            "hdop", "hdop", "scalar", scalar="float", units=("1",), valid=("valid_flags.hdop",)
        ),
        Parameter(
            "vdop", "vdop", "scalar", scalar="float", units=("1",), valid=("valid_flags.vdop",)
        ),
        Parameter(
            "tdop", "tdop", "scalar", scalar="float", units=("1",), valid=("valid_flags.tdop",)
        ),
        Parameter(
            "ndop", "ndop", "scalar", scalar="float", units=("1",), valid=("valid_flags.ndop",)
        ),
        Parameter(
            "edop", "edop", "scalar", scalar="float", units=("1",), valid=("valid_flags.edop",)
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.DopFlags),
    ),
    gnss_1.UtcTime: (
        Parameter("year", "year", "scalar", scalar="u16", valid=("valid_flags.gnss_date_time",)),
        Parameter(
            "month",
            "month",
            "scalar",
            scalar="u8",
            valid=("valid_flags.gnss_date_time",),
            minimum=1,
            maximum=12,
        ),
        Parameter(
            "day",
            "day",
            "scalar",
            scalar="u8",
            valid=("valid_flags.gnss_date_time",),
            minimum=1,
            maximum=31,
        ),
        Parameter(
            "hour",
            "hour",
            "scalar",
            scalar="u8",
            valid=("valid_flags.gnss_date_time",),
            minimum=0,
            maximum=23,
        ),
        Parameter(
            "min",
            "min",
            "scalar",
            scalar="u8",
            valid=("valid_flags.gnss_date_time",),
            minimum=0,
            maximum=59,
        ),
        Parameter(
            "sec",
            "sec",
            "scalar",
            scalar="u8",
            units=("s",),
            valid=("valid_flags.gnss_date_time",),
            minimum=0,
            maximum=59,
        ),
        Parameter(
            "msec",
            "msec",
            "scalar",
            scalar="u32",
            units=("ms",),
            valid=("valid_flags.gnss_date_time",),
            minimum=0,
            maximum=999,
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.UtcTimeFlags),
    ),
    gnss_1.GpsTime: (
        Parameter(
            "tow", "tow", "scalar", scalar="double", units=("s",), valid=("valid_flags.tow",)
        ),
        Parameter(
            "week_number",
            "week_number",
            "scalar",
            scalar="u16",
            units=("week",),
            valid=("valid_flags.week_number",),
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.GpsTimeFlags),
    ),
    gnss_1.ClockInfo: (
        Parameter(
            "bias", "bias", "scalar", scalar="double", units=("s",), valid=("valid_flags.bias",)
        ),
        Parameter(
            "drift",
            "drift",
            "scalar",
            scalar="double",
            units=("s/s",),
            valid=("valid_flags.drift",),
        ),
        Parameter(
            "accuracy_estimate",
            "accuracy_estimate",
            "scalar",
            scalar="double",
            units=("s",),
            valid=("valid_flags.accuracy_estimate",),
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.ClockInfoFlags),
    ),
    gnss_1.FixInfo: (
        Parameter(
            "fix_type",
            "fix_type",
            "scalar",
            scalar="u8",
            valid=("valid_flags.fix_type",),
            type=types.GnssFixType,
        ),
        Parameter(
            "num_sv", "num_sv", "scalar", scalar="u8", units=("1",), valid=("valid_flags.num_sv",)
        ),
        Parameter(
            "fix_flags",
            "fix_flags",
            "scalar",
            scalar="u16",
            valid=("valid_flags.fix_flags",),
            type=gnss_1.FixFlags,
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.FixInfoFlags),
    ),
    gnss_1.SvInfo: (
        Parameter("channel", "channel", "scalar", scalar="u8", valid=("valid_flags.channel",)),
        Parameter(
            "satellite_id",
            "satellite_id",
            "scalar",
            scalar="u8",
            valid=("valid_flags.satellite_id",),
        ),
        Parameter(
            "carrier_noise_ratio",
            "carrier_noise_ratio",
            "scalar",
            scalar="u16",
            units=("dB-Hz",),
            valid=("valid_flags.carrier_noise_ratio",),
        ),
        Parameter(
            "azimuth",
            "azimuth",
            "scalar",
            scalar="s16",
            units=("deg",),
            valid=("valid_flags.azimuth",),
        ),
        Parameter(
            "elevation",
            "elevation",
            "scalar",
            scalar="s16",
            units=("deg",),
            valid=("valid_flags.elevation",),
        ),
        Parameter(
            "sv_flags",
            "sv_flags",
            "scalar",
            scalar="u16",
            valid=("valid_flags.sv_flags",),
            type=gnss_1.SvFlags,
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.SvInfoFlags),
    ),
    gnss_1.HardwareStatus: (
        Parameter(
            "receiver_state",
            "receiver_state",
            "scalar",
            scalar="u8",
            valid=("valid_flags.sensor_state",),
            type=gnss_1.ReceiverState,
        ),
        Parameter(
            "antenna_state",
            "antenna_state",
            "scalar",
            scalar="u8",
            valid=("valid_flags.antenna_state",),
            type=gnss_1.AntennaState,
        ),
        Parameter(
            "antenna_power",
            "antenna_power",
            "scalar",
            scalar="u8",
            valid=("valid_flags.antenna_power",),
            type=gnss_1.AntennaPower,
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.HardwareStatusFlags
        ),
    ),
    gnss_1.DgpsInfo: (
        Parameter("age", "age", "scalar", scalar="float", units=("s",), valid=("valid_flags.age",)),
        Parameter(
            "base_station_id",
            "base_station_id",
            "scalar",
            scalar="s16",
            valid=("valid_flags.base_station_id",),
        ),
        Parameter(
            "base_station_status",
            "base_station_status",
            "scalar",
            scalar="s16",
            valid=("valid_flags.base_station_status",),
        ),
        Parameter(
            "num_channels",
            "num_channels",
            "scalar",
            scalar="u16",
            units=("1",),
            valid=("valid_flags.num_channels",),
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.DgpsInfoFlags),
    ),
    gnss_1.DgpsChannel: (
        Parameter(
            "satellite_id",
            "satellite_id",
            "scalar",
            scalar="u8",
            valid=("valid_flags.satellite_id",),
        ),
        Parameter("age", "age", "scalar", scalar="float", units=("s",), valid=("valid_flags.age",)),
        Parameter(
            "range_correction",
            "range_correction",
            "scalar",
            scalar="float",
            units=("m",),
            valid=("valid_flags.range_correction",),
        ),
        Parameter(
            "range_rate_correction",
            "range_rate_correction",
            "scalar",
            scalar="float",
            units=("m/s",),
            valid=("valid_flags.range_rate_correction",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.DgpsChannelFlags
        ),
    ),
    gnss_1.ClockInfo2: (
        Parameter(
            "bias", "bias", "scalar", scalar="double", units=("s",), valid=("valid_flags.bias",)
        ),
        Parameter(
            "drift",
            "drift",
            "scalar",
            scalar="double",
            units=("s/s",),
            valid=("valid_flags.drift",),
        ),
        Parameter(
            "bias_accuracy_estimate",
            "bias_accuracy_estimate",
            "scalar",
            scalar="double",
            units=("s",),
            valid=("valid_flags.bias_accuracy",),
        ),
        Parameter(
            "drift_accuracy_estimate",
            "drift_accuracy_estimate",
            "scalar",
            scalar="double",
            units=("s/s",),
            valid=("valid_flags.drift_accuracy",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.ClockInfo2Flags
        ),
    ),
    gnss_1.GpsLeapSeconds: (
        Parameter(
            "leap_seconds",
            "leap_seconds",
            "scalar",
            scalar="u8",
            units=("s",),
            valid=("valid_flags.leap_seconds",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.GpsLeapSecondsFlags
        ),
    ),
    gnss_1.SbasInfo: (
        Parameter(
            "tow", "tow", "scalar", scalar="double", units=("s",), valid=("valid_flags.tow",)
        ),
        Parameter(
            "week_number",
            "week_number",
            "scalar",
            scalar="u16",
            units=("week",),
            valid=("valid_flags.week_number",),
        ),
        Parameter(
            "sbas_system",
            "sbas_system",
            "scalar",
            scalar="u8",
            valid=("valid_flags.sbas_system",),
            type=gnss_1.SbasSystem,
        ),
        Parameter("sbas_id", "sbas_id", "scalar", scalar="u8", valid=("valid_flags.sbas_id",)),
        Parameter(
            "count", "count", "scalar", scalar="u8", units=("1",), valid=("valid_flags.count",)
        ),
        Parameter(
            "sbas_status",
            "sbas_status",
            "scalar",
            scalar="u8",
            valid=("valid_flags.sbas_status",),
            type=gnss_1.SbasStatus,
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.SbasInfoFlags),
    ),
    gnss_1.SbasCorrection: (
        Parameter("index", "index", "scalar", scalar="u8"),
        Parameter("count", "count", "scalar", scalar="u8"),
        Parameter("tow", "tow", "scalar", scalar="double", units=("s",)),
        Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",)),
        Parameter("gnss_id", "gnss_id", "scalar", scalar="u8", type=types.GnssConstellation),
        Parameter("satellite_id", "satellite_id", "scalar", scalar="u8"),
        Parameter(
            "udrei",
            "udrei",
            "scalar",
            scalar="u8",
            valid=("valid_flags.udrei",),
            minimum=0,
            maximum=15,
        ),
        Parameter(
            "pseudorange_correction",
            "pseudorange_correction",
            "scalar",
            scalar="float",
            units=("m",),
            valid=("valid_flags.pseudorange_correction",),
        ),
        Parameter(
            "iono_correction",
            "iono_correction",
            "scalar",
            scalar="float",
            units=("m",),
            valid=("valid_flags.iono_correction",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.SbasCorrectionFlags
        ),
    ),
    gnss_1.RfErrorDetection: (
        Parameter(
            "rf_band",
            "rf_band",
            "scalar",
            scalar="u8",
            valid=("valid_flags.rf_band",),
            type=gnss_1.RfBand,
        ),
        Parameter(
            "jamming_state",
            "jamming_state",
            "scalar",
            scalar="u8",
            valid=("valid_flags.jamming_state",),
            type=gnss_1.JammingState,
        ),
        Parameter(
            "spoofing_state",
            "spoofing_state",
            "scalar",
            scalar="u8",
            valid=("valid_flags.spoofing_state",),
            type=gnss_1.SpoofingState,
        ),
        Parameter("reserved", "reserved", "array", scalar="u8", length=4, default=0),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.RfErrorDetectionFlags
        ),
    ),
    gnss_1.SatelliteStatus: (
        Parameter("index", "index", "scalar", scalar="u8"),
        Parameter("count", "count", "scalar", scalar="u8"),
        Parameter(
            "tow", "tow", "scalar", scalar="double", units=("s",), valid=("valid_flags.tow",)
        ),
        Parameter(
            "week_number",
            "week_number",
            "scalar",
            scalar="u16",
            units=("week",),
            valid=("valid_flags.week_number",),
        ),
        Parameter(
            "gnss_id",
            "gnss_id",
            "scalar",
            scalar="u8",
            valid=("valid_flags.gnss_id",),
            type=types.GnssConstellation,
        ),
        Parameter(
            "satellite_id",
            "satellite_id",
            "scalar",
            scalar="u8",
            valid=("valid_flags.satellite_id",),
        ),
        Parameter(
            "elevation",
            "elevation",
            "scalar",
            scalar="float",
            units=("deg",),
            valid=("valid_flags.elevation",),
        ),
        Parameter(
            "azimuth",
            "azimuth",
            "scalar",
            scalar="float",
            units=("deg",),
            valid=("valid_flags.azimuth",),
        ),
        Parameter("health", "health", "scalar", scalar="bool", valid=("valid_flags.health",)),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.SatelliteStatusFlags
        ),
    ),
    gnss_1.Raw: (
        Parameter("index", "index", "scalar", scalar="u8"),
        Parameter("count", "count", "scalar", scalar="u8"),
        Parameter(
            "tow", "tow", "scalar", scalar="double", units=("s",), valid=("valid_flags.tow",)
        ),
        Parameter(
            "week_number",
            "week_number",
            "scalar",
            scalar="u16",
            units=("week",),
            valid=("valid_flags.week_number",),
        ),
        Parameter(
            "receiver_id", "receiver_id", "scalar", scalar="u16", valid=("valid_flags.receiver_id",)
        ),
        Parameter(
            "tracking_channel",
            "tracking_channel",
            "scalar",
            scalar="u8",
            valid=("valid_flags.tracking_channel",),
        ),
        Parameter(
            "gnss_id",
            "gnss_id",
            "scalar",
            scalar="u8",
            valid=("valid_flags.gnss_id",),
            type=types.GnssConstellation,
        ),
        Parameter(
            "satellite_id",
            "satellite_id",
            "scalar",
            scalar="u8",
            valid=("valid_flags.satellite_id",),
        ),
        Parameter(
            "signal_id",
            "signal_id",
            "scalar",
            scalar="u8",
            valid=("valid_flags.signal_id",),
            type=types.GnssSignal,
        ),
        Parameter(
            "signal_strength",
            "signal_strength",
            "scalar",
            scalar="float",
            units=("dB-Hz",),
            valid=("valid_flags.signal_strength",),
        ),
        Parameter(
            "quality",
            "quality",
            "scalar",
            scalar="u8",
            valid=("valid_flags.quality",),
            type=gnss_1.SignalQuality,
        ),
        Parameter(
            "pseudorange",
            "pseudorange",
            "scalar",
            scalar="double",
            units=("m",),
            valid=("valid_flags.pseudorange",),
        ),
        Parameter(
            "carrier_phase",
            "carrier_phase",
            "scalar",
            scalar="double",
            units=("cycle",),
            valid=("valid_flags.carrier_phase",),
        ),
        Parameter(
            "doppler",
            "doppler",
            "scalar",
            scalar="float",
            units=("Hz",),
            valid=("valid_flags.doppler",),
        ),
        Parameter(
            "range_uncertainty",
            "range_uncertainty",
            "scalar",
            scalar="float",
            units=("m",),
            valid=("valid_flags.range_uncertainty",),
        ),
        Parameter(
            "phase_uncertainty",
            "phase_uncertainty",
            "scalar",
            scalar="float",
            units=("cycle",),
            valid=("valid_flags.carrier_phase_uncertainty",),
        ),
        Parameter(
            "doppler_uncertainty",
            "doppler_uncertainty",
            "scalar",
            scalar="float",
            units=("Hz",),
            valid=("valid_flags.doppler_uncertainty",),
        ),
        Parameter(
            "lock_time",
            "lock_time",
            "scalar",
            scalar="float",
            units=("s",),
            valid=("valid_flags.lock_time",),
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.RawFlags),
    ),
    gnss_1.BaseStationInfo: (
        Parameter(
            "tow", "tow", "scalar", scalar="double", units=("s",), valid=("valid_flags.tow",)
        ),
        Parameter(
            "week_number",
            "week_number",
            "scalar",
            scalar="u16",
            units=("week",),
            valid=("valid_flags.week_number",),
        ),
        Parameter(
            "ecef_position",
            "ecef_position",
            "array",
            scalar="double",
            elements=("x", "y", "z"),
            units=("m",),
            valid=("valid_flags.ecef_position",),
            frame="ecef",
        ),
        Parameter(
            "height",
            "height",
            "scalar",
            scalar="float",
            units=("m",),
            valid=("valid_flags.height",),
        ),
        Parameter(
            "station_id",
            "station_id",
            "scalar",
            scalar="u16",
            valid=("valid_flags.station_id",),
            minimum=0,
            maximum=4095,
        ),
        Parameter(
            "indicators",
            "indicators",
            "scalar",
            scalar="u16",
            valid=("valid_flags.indicators",),
            type=gnss_1.BaseStationIndicators,
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.BaseStationInfoFlags
        ),
    ),
    gnss_1.RtkCorrectionsStatus: (
        Parameter(
            "tow", "tow", "scalar", scalar="double", units=("s",), valid=("valid_flags.tow",)
        ),
        Parameter(
            "week_number",
            "week_number",
            "scalar",
            scalar="u16",
            units=("week",),
            valid=("valid_flags.week_number",),
        ),
        Parameter(
            "epoch_status",
            "epoch_status",
            "scalar",
            scalar="u16",
            valid=("valid_flags.epoch_status",),
            type=gnss_1.RtkEpochStatus,
        ),
        Parameter(
            "dongle_status",
            "dongle_status",
            "scalar",
            scalar="u32",
            valid=("valid_flags.dongle_status",),
            type=types.RtkStatusFlags,
        ),
        Parameter(
            "gps_correction_latency",
            "gps_correction_latency",
            "scalar",
            scalar="float",
            units=("s",),
            valid=("valid_flags.gps_latency",),
        ),
        Parameter(
            "glonass_correction_latency",
            "glonass_correction_latency",
            "scalar",
            scalar="float",
            units=("s",),
            valid=("valid_flags.glonass_latency",),
        ),
        Parameter(
            "galileo_correction_latency",
            "galileo_correction_latency",
            "scalar",
            scalar="float",
            units=("s",),
            valid=("valid_flags.galileo_latency",),
        ),
        Parameter(
            "beidou_correction_latency",
            "beidou_correction_latency",
            "scalar",
            scalar="float",
            units=("s",),
            valid=("valid_flags.beidou_latency",),
        ),
        Parameter("reserved", "reserved", "array", scalar="u32", length=4, default=0),
        Parameter(
            "valid_flags",
            "valid_flags",
            "scalar",
            scalar="u16",
            type=gnss_1.RtkCorrectionsStatusFlags,
        ),
    ),
    gnss_1.GpsEphemeris: (
        Parameter("index", "index", "scalar", scalar="u8"),
        Parameter("count", "count", "scalar", scalar="u8"),
        Parameter("tow", "tow", "scalar", scalar="double", units=("s",)),
        Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",)),
        Parameter("satellite_id", "satellite_id", "scalar", scalar="u8"),
        Parameter("health", "health", "scalar", scalar="u8", valid=("valid_flags.ephemeris",)),
        Parameter("iodc", "iodc", "scalar", scalar="u8", valid=("valid_flags.ephemeris",)),
        Parameter("iode", "iode", "scalar", scalar="u8", valid=("valid_flags.ephemeris",)),
        Parameter(
            "t_oc",
            "t_oc",
            "scalar",
            scalar="double",
            units=("s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "af0", "af0", "scalar", scalar="double", units=("s",), valid=("valid_flags.ephemeris",)
        ),
        Parameter(
            "af1",
            "af1",
            "scalar",
            scalar="double",
            units=("s/s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "af2",
            "af2",
            "scalar",
            scalar="double",
            units=("s/s^2",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "t_gd",
            "t_gd",
            "scalar",
            scalar="double",
            units=("s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "isc_l1ca",
            "isc_l1ca",
            "scalar",
            scalar="double",
            units=("s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "isc_l2c",
            "isc_l2c",
            "scalar",
            scalar="double",
            units=("s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "t_oe",
            "t_oe",
            "scalar",
            scalar="double",
            units=("s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "a", "a", "scalar", scalar="double", units=("m",), valid=("valid_flags.ephemeris",)
        ),
        Parameter(
            "a_dot",
            "a_dot",
            "scalar",
            scalar="double",
            units=("m/s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "mean_anomaly",
            "mean_anomaly",
            "scalar",
            scalar="double",
            units=("rad",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "delta_mean_motion",
            "delta_mean_motion",
            "scalar",
            scalar="double",
            units=("rad/s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "delta_mean_motion_dot",
            "delta_mean_motion_dot",
            "scalar",
            scalar="double",
            units=("rad/s^2",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "eccentricity",
            "eccentricity",
            "scalar",
            scalar="double",
            units=("1",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "argument_of_perigee",
            "argument_of_perigee",
            "scalar",
            scalar="double",
            units=("rad",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "omega",
            "omega",
            "scalar",
            scalar="double",
            units=("rad",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "omega_dot",
            "omega_dot",
            "scalar",
            scalar="double",
            units=("rad/s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "inclination",
            "inclination",
            "scalar",
            scalar="double",
            units=("rad",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "inclination_dot",
            "inclination_dot",
            "scalar",
            scalar="double",
            units=("rad/s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "c_ic",
            "c_ic",
            "scalar",
            scalar="double",
            units=("rad",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "c_is",
            "c_is",
            "scalar",
            scalar="double",
            units=("rad",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "c_uc",
            "c_uc",
            "scalar",
            scalar="double",
            units=("rad",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "c_us",
            "c_us",
            "scalar",
            scalar="double",
            units=("rad",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "c_rc",
            "c_rc",
            "scalar",
            scalar="double",
            units=("m",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "c_rs",
            "c_rs",
            "scalar",
            scalar="double",
            units=("m",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.EphemerisFlags),
    ),
    gnss_1.GlonassEphemeris: (
        Parameter("index", "index", "scalar", scalar="u8"),
        Parameter("count", "count", "scalar", scalar="u8"),
        Parameter("tow", "tow", "scalar", scalar="double", units=("s",)),
        Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",)),
        Parameter("satellite_id", "satellite_id", "scalar", scalar="u8"),
        Parameter(
            "frequency_number",
            "frequency_number",
            "scalar",
            scalar="s8",
            valid=("valid_flags.ephemeris",),
            minimum=-7,
            maximum=24,
        ),
        Parameter(
            "tk", "tk", "scalar", scalar="u32", units=("s",), valid=("valid_flags.ephemeris",)
        ),
        Parameter(
            "tb", "tb", "scalar", scalar="u32", units=("s",), valid=("valid_flags.ephemeris",)
        ),
        Parameter(
            "satellite_type",
            "satellite_type",
            "scalar",
            scalar="u8",
            valid=("valid_flags.ephemeris",),
            type=gnss_1.GlonassSatelliteType,
        ),
        Parameter(
            "gamma",
            "gamma",
            "scalar",
            scalar="double",
            units=("1",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "tau_n",
            "tau_n",
            "scalar",
            scalar="double",
            units=("s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "position",
            "position",
            "array",
            scalar="double",
            elements=("x", "y", "z"),
            units=("m",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "velocity",
            "velocity",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "accel",
            "accel",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m/s^2",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter("health", "health", "scalar", scalar="u8", valid=("valid_flags.ephemeris",)),
        Parameter("p", "p", "scalar", scalar="u8", valid=("valid_flags.ephemeris",)),
        Parameter(
            "nt", "nt", "scalar", scalar="u8", units=("day",), valid=("valid_flags.ephemeris",)
        ),
        Parameter(
            "delta_tau_n",
            "delta_tau_n",
            "scalar",
            scalar="float",
            units=("s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter("ft", "ft", "scalar", scalar="u8", valid=("valid_flags.ephemeris",)),
        Parameter(
            "en", "en", "scalar", scalar="u8", units=("day",), valid=("valid_flags.ephemeris",)
        ),
        Parameter(
            "p1", "p1", "scalar", scalar="u8", units=("min",), valid=("valid_flags.ephemeris",)
        ),
        Parameter(
            "p2",
            "p2",
            "scalar",
            scalar="u8",
            valid=("valid_flags.ephemeris",),
            minimum=0,
            maximum=1,
        ),
        Parameter(
            "p3", "p3", "scalar", scalar="u8", units=("1",), valid=("valid_flags.ephemeris",)
        ),
        Parameter("p4", "p4", "scalar", scalar="u8", valid=("valid_flags.ephemeris",)),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.GlonassEphemerisFlags
        ),
    ),
    gnss_1.GalileoEphemeris: (
        Parameter("index", "index", "scalar", scalar="u8"),
        Parameter("count", "count", "scalar", scalar="u8"),
        Parameter("tow", "tow", "scalar", scalar="double", units=("s",)),
        Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",)),
        Parameter("satellite_id", "satellite_id", "scalar", scalar="u8"),
        Parameter("health", "health", "scalar", scalar="u8", valid=("valid_flags.ephemeris",)),
        Parameter("iodc", "iodc", "scalar", scalar="u8", valid=("valid_flags.ephemeris",)),
        Parameter("iode", "iode", "scalar", scalar="u8", valid=("valid_flags.ephemeris",)),
        Parameter(
            "t_oc",
            "t_oc",
            "scalar",
            scalar="double",
            units=("s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "af0", "af0", "scalar", scalar="double", units=("s",), valid=("valid_flags.ephemeris",)
        ),
        Parameter(
            "af1",
            "af1",
            "scalar",
            scalar="double",
            units=("s/s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "af2",
            "af2",
            "scalar",
            scalar="double",
            units=("s/s^2",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "t_gd",
            "t_gd",
            "scalar",
            scalar="double",
            units=("s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "isc_l1ca",
            "isc_l1ca",
            "scalar",
            scalar="double",
            units=("s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "isc_l2c",
            "isc_l2c",
            "scalar",
            scalar="double",
            units=("s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "t_oe",
            "t_oe",
            "scalar",
            scalar="double",
            units=("s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "a", "a", "scalar", scalar="double", units=("m",), valid=("valid_flags.ephemeris",)
        ),
        Parameter(
            "a_dot",
            "a_dot",
            "scalar",
            scalar="double",
            units=("m/s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "mean_anomaly",
            "mean_anomaly",
            "scalar",
            scalar="double",
            units=("rad",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "delta_mean_motion",
            "delta_mean_motion",
            "scalar",
            scalar="double",
            units=("rad/s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "delta_mean_motion_dot",
            "delta_mean_motion_dot",
            "scalar",
            scalar="double",
            units=("rad/s^2",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "eccentricity",
            "eccentricity",
            "scalar",
            scalar="double",
            units=("1",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "argument_of_perigee",
            "argument_of_perigee",
            "scalar",
            scalar="double",
            units=("rad",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "omega",
            "omega",
            "scalar",
            scalar="double",
            units=("rad",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "omega_dot",
            "omega_dot",
            "scalar",
            scalar="double",
            units=("rad/s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "inclination",
            "inclination",
            "scalar",
            scalar="double",
            units=("rad",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "inclination_dot",
            "inclination_dot",
            "scalar",
            scalar="double",
            units=("rad/s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "c_ic",
            "c_ic",
            "scalar",
            scalar="double",
            units=("rad",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "c_is",
            "c_is",
            "scalar",
            scalar="double",
            units=("rad",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "c_uc",
            "c_uc",
            "scalar",
            scalar="double",
            units=("rad",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "c_us",
            "c_us",
            "scalar",
            scalar="double",
            units=("rad",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "c_rc",
            "c_rc",
            "scalar",
            scalar="double",
            units=("m",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "c_rs",
            "c_rs",
            "scalar",
            scalar="double",
            units=("m",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.EphemerisFlags),
    ),
    gnss_1.BeidouEphemeris: (
        Parameter("index", "index", "scalar", scalar="u8"),
        Parameter("count", "count", "scalar", scalar="u8"),
        Parameter("tow", "tow", "scalar", scalar="double", units=("s",)),
        Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",)),
        Parameter("satellite_id", "satellite_id", "scalar", scalar="u8"),
        Parameter("health", "health", "scalar", scalar="u8", valid=("valid_flags.ephemeris",)),
        Parameter("iodc", "iodc", "scalar", scalar="u8", valid=("valid_flags.ephemeris",)),
        Parameter("iode", "iode", "scalar", scalar="u8", valid=("valid_flags.ephemeris",)),
        Parameter(
            "t_oc",
            "t_oc",
            "scalar",
            scalar="double",
            units=("s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "af0", "af0", "scalar", scalar="double", units=("s",), valid=("valid_flags.ephemeris",)
        ),
        Parameter(
            "af1",
            "af1",
            "scalar",
            scalar="double",
            units=("s/s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "af2",
            "af2",
            "scalar",
            scalar="double",
            units=("s/s^2",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "t_gd",
            "t_gd",
            "scalar",
            scalar="double",
            units=("s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "isc_l1ca",
            "isc_l1ca",
            "scalar",
            scalar="double",
            units=("s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "isc_l2c",
            "isc_l2c",
            "scalar",
            scalar="double",
            units=("s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "t_oe",
            "t_oe",
            "scalar",
            scalar="double",
            units=("s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "a", "a", "scalar", scalar="double", units=("m",), valid=("valid_flags.ephemeris",)
        ),
        Parameter(
            "a_dot",
            "a_dot",
            "scalar",
            scalar="double",
            units=("m/s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "mean_anomaly",
            "mean_anomaly",
            "scalar",
            scalar="double",
            units=("rad",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "delta_mean_motion",
            "delta_mean_motion",
            "scalar",
            scalar="double",
            units=("rad/s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "delta_mean_motion_dot",
            "delta_mean_motion_dot",
            "scalar",
            scalar="double",
            units=("rad/s^2",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "eccentricity",
            "eccentricity",
            "scalar",
            scalar="double",
            units=("1",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "argument_of_perigee",
            "argument_of_perigee",
            "scalar",
            scalar="double",
            units=("rad",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "omega",
            "omega",
            "scalar",
            scalar="double",
            units=("rad",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "omega_dot",
            "omega_dot",
            "scalar",
            scalar="double",
            units=("rad/s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "inclination",
            "inclination",
            "scalar",
            scalar="double",
            units=("rad",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "inclination_dot",
            "inclination_dot",
            "scalar",
            scalar="double",
            units=("rad/s",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "c_ic",
            "c_ic",
            "scalar",
            scalar="double",
            units=("rad",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "c_is",
            "c_is",
            "scalar",
            scalar="double",
            units=("rad",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "c_uc",
            "c_uc",
            "scalar",
            scalar="double",
            units=("rad",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "c_us",
            "c_us",
            "scalar",
            scalar="double",
            units=("rad",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "c_rc",
            "c_rc",
            "scalar",
            scalar="double",
            units=("m",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter(
            "c_rs",
            "c_rs",
            "scalar",
            scalar="double",
            units=("m",),
            valid=("valid_flags.ephemeris",),
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.EphemerisFlags),
    ),
    gnss_1.GpsIonoCorrection: (
        Parameter(
            "tow", "tow", "scalar", scalar="double", units=("s",), valid=("valid_flags.tow",)
        ),
        Parameter(
            "week_number",
            "week_number",
            "scalar",
            scalar="u16",
            units=("week",),
            valid=("valid_flags.week_number",),
        ),
        Parameter(
            "alpha", "alpha", "array", scalar="double", length=4, valid=("valid_flags.alpha",)
        ),
        Parameter("beta", "beta", "array", scalar="double", length=4, valid=("valid_flags.beta",)),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=gnss_1.GpsIonoCorrectionFlags
        ),
    ),
    gnss_1.GalileoIonoCorrection: (
        Parameter(
            "tow", "tow", "scalar", scalar="double", units=("s",), valid=("valid_flags.tow",)
        ),
        Parameter(
            "week_number",
            "week_number",
            "scalar",
            scalar="u16",
            units=("week",),
            valid=("valid_flags.week_number",),
        ),
        Parameter(
            "alpha", "alpha", "array", scalar="double", length=3, valid=("valid_flags.alpha",)
        ),
        Parameter(
            "disturbance_flags",
            "disturbance_flags",
            "scalar",
            scalar="u8",
            valid=("valid_flags.disturbance_flags",),
        ),
        Parameter(
            "valid_flags",
            "valid_flags",
            "scalar",
            scalar="u16",
            type=gnss_1.GalileoIonoCorrectionFlags,
        ),
    ),
    gnss_1.BeidouIonoCorrection: (
        Parameter(
            "tow", "tow", "scalar", scalar="double", units=("s",), valid=("valid_flags.tow",)
        ),
        Parameter(
            "week_number",
            "week_number",
            "scalar",
            scalar="u16",
            units=("week",),
            valid=("valid_flags.week_number",),
        ),
        Parameter(
            "alpha", "alpha", "array", scalar="double", length=4, valid=("valid_flags.alpha",)
        ),
        Parameter("beta", "beta", "array", scalar="double", length=4, valid=("valid_flags.beta",)),
        Parameter(
            "alpha_correction",
            "alpha_correction",
            "array",
            scalar="double",
            length=9,
            valid=("valid_flags.alpha_correction",),
        ),
        Parameter(
            "valid_flags",
            "valid_flags",
            "scalar",
            scalar="u16",
            type=gnss_1.BeidouIonoCorrectionFlags,
        ),
    ),
    system_data.BuiltInTest: (Parameter("result", "result", "array", scalar="u8", length=16),),
    system_data.TimeSyncStatus: (
        Parameter("time_sync", "time_sync", "scalar", scalar="bool"),
        Parameter("last_pps_received", "last_pps_received", "scalar", scalar="u8", units=("s",)),
    ),
    system_data.GpioState: (
        Parameter("states", "states", "scalar", scalar="u8", type=system_data.GpioPinStates),
    ),
    system_data.GpioAnalogValue: (
        Parameter("gpio_id", "gpio_id", "scalar", scalar="u8", minimum=1),
        Parameter("value", "value", "scalar", scalar="float", units=("V",)),
    ),
    shared.EventSource: (Parameter("trigger_id", "trigger_id", "scalar", scalar="u8"),),
    shared.Ticks: (Parameter("ticks", "ticks", "scalar", scalar="u32", units=("1",)),),
    shared.DeltaTicks: (Parameter("ticks", "ticks", "scalar", scalar="u32", units=("1",)),),
    shared.GpsTimestamp: (
        Parameter(
            "tow", "tow", "scalar", scalar="double", units=("s",), valid=("valid_flags.tow",)
        ),
        Parameter(
            "week_number",
            "week_number",
            "scalar",
            scalar="u16",
            units=("week",),
            valid=("valid_flags.week_number",),
        ),
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
        Parameter(
            "nanoseconds",
            "nanoseconds",
            "scalar",
            scalar="u64",
            units=("ns",),
            valid=("valid_flags.nanoseconds",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=shared.ExternalTimestampFlags
        ),
    ),
    shared.ExternalTimeDelta: (
        Parameter(
            "dt_nanos",
            "dt_nanos",
            "scalar",
            scalar="u64",
            units=("ns",),
            valid=("valid_flags.dt_nanos",),
        ),
        Parameter(
            "valid_flags", "valid_flags", "scalar", scalar="u16", type=shared.ExternalTimeDeltaFlags
        ),
    ),
}

PARAMETERS[gnss_data.LlhPosition] = PARAMETERS[gnss_1.LlhPosition]
PARAMETERS[gnss_data.EcefPosition] = PARAMETERS[gnss_1.EcefPosition]
PARAMETERS[gnss_data.NedVelocity] = PARAMETERS[gnss_1.NedVelocity]
PARAMETERS[gnss_data.EcefVelocity] = PARAMETERS[gnss_1.EcefVelocity]
PARAMETERS[gnss_data.Dop] = PARAMETERS[gnss_1.Dop]
PARAMETERS[gnss_data.UtcTime] = PARAMETERS[gnss_1.UtcTime]
PARAMETERS[gnss_data.GpsTime] = PARAMETERS[gnss_1.GpsTime]
PARAMETERS[gnss_data.ClockInfo] = PARAMETERS[gnss_1.ClockInfo]
PARAMETERS[gnss_data.FixInfo] = PARAMETERS[gnss_1.FixInfo]
PARAMETERS[gnss_data.SvInfo] = PARAMETERS[gnss_1.SvInfo]
PARAMETERS[gnss_data.HardwareStatus] = PARAMETERS[gnss_1.HardwareStatus]
PARAMETERS[gnss_data.DgpsInfo] = PARAMETERS[gnss_1.DgpsInfo]
PARAMETERS[gnss_data.DgpsChannel] = PARAMETERS[gnss_1.DgpsChannel]
PARAMETERS[gnss_data.ClockInfo2] = PARAMETERS[gnss_1.ClockInfo2]
PARAMETERS[gnss_data.GpsLeapSeconds] = PARAMETERS[gnss_1.GpsLeapSeconds]
PARAMETERS[gnss_data.SbasInfo] = PARAMETERS[gnss_1.SbasInfo]
PARAMETERS[gnss_data.SbasCorrection] = PARAMETERS[gnss_1.SbasCorrection]
PARAMETERS[gnss_data.RfErrorDetection] = PARAMETERS[gnss_1.RfErrorDetection]
PARAMETERS[gnss_data.SatelliteStatus] = PARAMETERS[gnss_1.SatelliteStatus]
PARAMETERS[gnss_data.Raw] = PARAMETERS[gnss_1.Raw]
PARAMETERS[gnss_data.BaseStationInfo] = PARAMETERS[gnss_1.BaseStationInfo]
PARAMETERS[gnss_data.RtkCorrectionsStatus] = PARAMETERS[gnss_1.RtkCorrectionsStatus]
PARAMETERS[gnss_data.GpsEphemeris] = PARAMETERS[gnss_1.GpsEphemeris]
PARAMETERS[gnss_data.GlonassEphemeris] = PARAMETERS[gnss_1.GlonassEphemeris]
PARAMETERS[gnss_data.GalileoEphemeris] = PARAMETERS[gnss_1.GalileoEphemeris]
PARAMETERS[gnss_data.BeidouEphemeris] = PARAMETERS[gnss_1.BeidouEphemeris]
PARAMETERS[gnss_data.GpsIonoCorrection] = PARAMETERS[gnss_1.GpsIonoCorrection]
PARAMETERS[gnss_data.GalileoIonoCorrection] = PARAMETERS[gnss_1.GalileoIonoCorrection]
PARAMETERS[gnss_data.BeidouIonoCorrection] = PARAMETERS[gnss_1.BeidouIonoCorrection]
PARAMETERS[gnss_2.LlhPosition] = PARAMETERS[gnss_1.LlhPosition]
PARAMETERS[gnss_2.EcefPosition] = PARAMETERS[gnss_1.EcefPosition]
PARAMETERS[gnss_2.NedVelocity] = PARAMETERS[gnss_1.NedVelocity]
PARAMETERS[gnss_2.EcefVelocity] = PARAMETERS[gnss_1.EcefVelocity]
PARAMETERS[gnss_2.Dop] = PARAMETERS[gnss_1.Dop]
PARAMETERS[gnss_2.UtcTime] = PARAMETERS[gnss_1.UtcTime]
PARAMETERS[gnss_2.GpsTime] = PARAMETERS[gnss_1.GpsTime]
PARAMETERS[gnss_2.ClockInfo] = PARAMETERS[gnss_1.ClockInfo]
PARAMETERS[gnss_2.FixInfo] = PARAMETERS[gnss_1.FixInfo]
PARAMETERS[gnss_2.SvInfo] = PARAMETERS[gnss_1.SvInfo]
PARAMETERS[gnss_2.HardwareStatus] = PARAMETERS[gnss_1.HardwareStatus]
PARAMETERS[gnss_2.DgpsInfo] = PARAMETERS[gnss_1.DgpsInfo]
PARAMETERS[gnss_2.DgpsChannel] = PARAMETERS[gnss_1.DgpsChannel]
PARAMETERS[gnss_2.ClockInfo2] = PARAMETERS[gnss_1.ClockInfo2]
PARAMETERS[gnss_2.GpsLeapSeconds] = PARAMETERS[gnss_1.GpsLeapSeconds]
PARAMETERS[gnss_2.SbasInfo] = PARAMETERS[gnss_1.SbasInfo]
PARAMETERS[gnss_2.SbasCorrection] = PARAMETERS[gnss_1.SbasCorrection]
PARAMETERS[gnss_2.RfErrorDetection] = PARAMETERS[gnss_1.RfErrorDetection]
PARAMETERS[gnss_2.SatelliteStatus] = PARAMETERS[gnss_1.SatelliteStatus]
PARAMETERS[gnss_2.Raw] = PARAMETERS[gnss_1.Raw]
PARAMETERS[gnss_2.BaseStationInfo] = PARAMETERS[gnss_1.BaseStationInfo]
PARAMETERS[gnss_2.RtkCorrectionsStatus] = PARAMETERS[gnss_1.RtkCorrectionsStatus]
PARAMETERS[gnss_2.GpsEphemeris] = PARAMETERS[gnss_1.GpsEphemeris]
PARAMETERS[gnss_2.GlonassEphemeris] = PARAMETERS[gnss_1.GlonassEphemeris]
PARAMETERS[gnss_2.GalileoEphemeris] = PARAMETERS[gnss_1.GalileoEphemeris]
PARAMETERS[gnss_2.BeidouEphemeris] = PARAMETERS[gnss_1.BeidouEphemeris]
PARAMETERS[gnss_2.GpsIonoCorrection] = PARAMETERS[gnss_1.GpsIonoCorrection]
PARAMETERS[gnss_2.GalileoIonoCorrection] = PARAMETERS[gnss_1.GalileoIonoCorrection]
PARAMETERS[gnss_2.BeidouIonoCorrection] = PARAMETERS[gnss_1.BeidouIonoCorrection]
PARAMETERS[gnss_corrections.LlhPosition] = PARAMETERS[gnss_1.LlhPosition]
PARAMETERS[gnss_corrections.EcefPosition] = PARAMETERS[gnss_1.EcefPosition]
PARAMETERS[gnss_corrections.NedVelocity] = PARAMETERS[gnss_1.NedVelocity]
PARAMETERS[gnss_corrections.EcefVelocity] = PARAMETERS[gnss_1.EcefVelocity]
PARAMETERS[gnss_corrections.Dop] = PARAMETERS[gnss_1.Dop]
PARAMETERS[gnss_corrections.UtcTime] = PARAMETERS[gnss_1.UtcTime]
PARAMETERS[gnss_corrections.GpsTime] = PARAMETERS[gnss_1.GpsTime]
PARAMETERS[gnss_corrections.ClockInfo] = PARAMETERS[gnss_1.ClockInfo]
PARAMETERS[gnss_corrections.FixInfo] = PARAMETERS[gnss_1.FixInfo]
PARAMETERS[gnss_corrections.SvInfo] = PARAMETERS[gnss_1.SvInfo]
PARAMETERS[gnss_corrections.HardwareStatus] = PARAMETERS[gnss_1.HardwareStatus]
PARAMETERS[gnss_corrections.DgpsInfo] = PARAMETERS[gnss_1.DgpsInfo]
PARAMETERS[gnss_corrections.DgpsChannel] = PARAMETERS[gnss_1.DgpsChannel]
PARAMETERS[gnss_corrections.ClockInfo2] = PARAMETERS[gnss_1.ClockInfo2]
PARAMETERS[gnss_corrections.GpsLeapSeconds] = PARAMETERS[gnss_1.GpsLeapSeconds]
PARAMETERS[gnss_corrections.SbasInfo] = PARAMETERS[gnss_1.SbasInfo]
PARAMETERS[gnss_corrections.SbasCorrection] = PARAMETERS[gnss_1.SbasCorrection]
PARAMETERS[gnss_corrections.RfErrorDetection] = PARAMETERS[gnss_1.RfErrorDetection]
PARAMETERS[gnss_corrections.SatelliteStatus] = PARAMETERS[gnss_1.SatelliteStatus]
PARAMETERS[gnss_corrections.Raw] = PARAMETERS[gnss_1.Raw]
PARAMETERS[gnss_corrections.BaseStationInfo] = PARAMETERS[gnss_1.BaseStationInfo]
PARAMETERS[gnss_corrections.RtkCorrectionsStatus] = PARAMETERS[gnss_1.RtkCorrectionsStatus]
PARAMETERS[gnss_corrections.GpsEphemeris] = PARAMETERS[gnss_1.GpsEphemeris]
PARAMETERS[gnss_corrections.GlonassEphemeris] = PARAMETERS[gnss_1.GlonassEphemeris]
PARAMETERS[gnss_corrections.GalileoEphemeris] = PARAMETERS[gnss_1.GalileoEphemeris]
PARAMETERS[gnss_corrections.BeidouEphemeris] = PARAMETERS[gnss_1.BeidouEphemeris]
PARAMETERS[gnss_corrections.GpsIonoCorrection] = PARAMETERS[gnss_1.GpsIonoCorrection]
PARAMETERS[gnss_corrections.GalileoIonoCorrection] = PARAMETERS[gnss_1.GalileoIonoCorrection]
PARAMETERS[gnss_corrections.BeidouIonoCorrection] = PARAMETERS[gnss_1.BeidouIonoCorrection]
PARAMETERS[gnss_external.LlhPosition] = PARAMETERS[gnss_1.LlhPosition]
PARAMETERS[gnss_external.EcefPosition] = PARAMETERS[gnss_1.EcefPosition]
PARAMETERS[gnss_external.NedVelocity] = PARAMETERS[gnss_1.NedVelocity]
PARAMETERS[gnss_external.EcefVelocity] = PARAMETERS[gnss_1.EcefVelocity]
PARAMETERS[gnss_external.Dop] = PARAMETERS[gnss_1.Dop]
PARAMETERS[gnss_external.UtcTime] = PARAMETERS[gnss_1.UtcTime]
PARAMETERS[gnss_external.GpsTime] = PARAMETERS[gnss_1.GpsTime]
PARAMETERS[gnss_external.ClockInfo] = PARAMETERS[gnss_1.ClockInfo]
PARAMETERS[gnss_external.FixInfo] = PARAMETERS[gnss_1.FixInfo]
PARAMETERS[gnss_external.SvInfo] = PARAMETERS[gnss_1.SvInfo]
PARAMETERS[gnss_external.HardwareStatus] = PARAMETERS[gnss_1.HardwareStatus]
PARAMETERS[gnss_external.DgpsInfo] = PARAMETERS[gnss_1.DgpsInfo]
PARAMETERS[gnss_external.DgpsChannel] = PARAMETERS[gnss_1.DgpsChannel]
PARAMETERS[gnss_external.ClockInfo2] = PARAMETERS[gnss_1.ClockInfo2]
PARAMETERS[gnss_external.GpsLeapSeconds] = PARAMETERS[gnss_1.GpsLeapSeconds]
PARAMETERS[gnss_external.SbasInfo] = PARAMETERS[gnss_1.SbasInfo]
PARAMETERS[gnss_external.SbasCorrection] = PARAMETERS[gnss_1.SbasCorrection]
PARAMETERS[gnss_external.RfErrorDetection] = PARAMETERS[gnss_1.RfErrorDetection]
PARAMETERS[gnss_external.SatelliteStatus] = PARAMETERS[gnss_1.SatelliteStatus]
PARAMETERS[gnss_external.Raw] = PARAMETERS[gnss_1.Raw]
PARAMETERS[gnss_external.BaseStationInfo] = PARAMETERS[gnss_1.BaseStationInfo]
PARAMETERS[gnss_external.RtkCorrectionsStatus] = PARAMETERS[gnss_1.RtkCorrectionsStatus]
PARAMETERS[gnss_external.GpsEphemeris] = PARAMETERS[gnss_1.GpsEphemeris]
PARAMETERS[gnss_external.GlonassEphemeris] = PARAMETERS[gnss_1.GlonassEphemeris]
PARAMETERS[gnss_external.GalileoEphemeris] = PARAMETERS[gnss_1.GalileoEphemeris]
PARAMETERS[gnss_external.BeidouEphemeris] = PARAMETERS[gnss_1.BeidouEphemeris]
PARAMETERS[gnss_external.GpsIonoCorrection] = PARAMETERS[gnss_1.GpsIonoCorrection]
PARAMETERS[gnss_external.GalileoIonoCorrection] = PARAMETERS[gnss_1.GalileoIonoCorrection]
PARAMETERS[gnss_external.BeidouIonoCorrection] = PARAMETERS[gnss_1.BeidouIonoCorrection]
PARAMETERS[gnss_external_2.LlhPosition] = PARAMETERS[gnss_1.LlhPosition]
PARAMETERS[gnss_external_2.EcefPosition] = PARAMETERS[gnss_1.EcefPosition]
PARAMETERS[gnss_external_2.NedVelocity] = PARAMETERS[gnss_1.NedVelocity]
PARAMETERS[gnss_external_2.EcefVelocity] = PARAMETERS[gnss_1.EcefVelocity]
PARAMETERS[gnss_external_2.Dop] = PARAMETERS[gnss_1.Dop]
PARAMETERS[gnss_external_2.UtcTime] = PARAMETERS[gnss_1.UtcTime]
PARAMETERS[gnss_external_2.GpsTime] = PARAMETERS[gnss_1.GpsTime]
PARAMETERS[gnss_external_2.ClockInfo] = PARAMETERS[gnss_1.ClockInfo]
PARAMETERS[gnss_external_2.FixInfo] = PARAMETERS[gnss_1.FixInfo]
PARAMETERS[gnss_external_2.SvInfo] = PARAMETERS[gnss_1.SvInfo]
PARAMETERS[gnss_external_2.HardwareStatus] = PARAMETERS[gnss_1.HardwareStatus]
PARAMETERS[gnss_external_2.DgpsInfo] = PARAMETERS[gnss_1.DgpsInfo]
PARAMETERS[gnss_external_2.DgpsChannel] = PARAMETERS[gnss_1.DgpsChannel]
PARAMETERS[gnss_external_2.ClockInfo2] = PARAMETERS[gnss_1.ClockInfo2]
PARAMETERS[gnss_external_2.GpsLeapSeconds] = PARAMETERS[gnss_1.GpsLeapSeconds]
PARAMETERS[gnss_external_2.SbasInfo] = PARAMETERS[gnss_1.SbasInfo]
PARAMETERS[gnss_external_2.SbasCorrection] = PARAMETERS[gnss_1.SbasCorrection]
PARAMETERS[gnss_external_2.RfErrorDetection] = PARAMETERS[gnss_1.RfErrorDetection]
PARAMETERS[gnss_external_2.SatelliteStatus] = PARAMETERS[gnss_1.SatelliteStatus]
PARAMETERS[gnss_external_2.Raw] = PARAMETERS[gnss_1.Raw]
PARAMETERS[gnss_external_2.BaseStationInfo] = PARAMETERS[gnss_1.BaseStationInfo]
PARAMETERS[gnss_external_2.RtkCorrectionsStatus] = PARAMETERS[gnss_1.RtkCorrectionsStatus]
PARAMETERS[gnss_external_2.GpsEphemeris] = PARAMETERS[gnss_1.GpsEphemeris]
PARAMETERS[gnss_external_2.GlonassEphemeris] = PARAMETERS[gnss_1.GlonassEphemeris]
PARAMETERS[gnss_external_2.GalileoEphemeris] = PARAMETERS[gnss_1.GalileoEphemeris]
PARAMETERS[gnss_external_2.BeidouEphemeris] = PARAMETERS[gnss_1.BeidouEphemeris]
PARAMETERS[gnss_external_2.GpsIonoCorrection] = PARAMETERS[gnss_1.GpsIonoCorrection]
PARAMETERS[gnss_external_2.GalileoIonoCorrection] = PARAMETERS[gnss_1.GalileoIonoCorrection]
PARAMETERS[gnss_external_2.BeidouIonoCorrection] = PARAMETERS[gnss_1.BeidouIonoCorrection]
