"""The meaning of the types of `mip_3dm`."""

from __future__ import annotations

from .. import mip_3dm, protocol, types
from ..info import BitsInfo, EnumInfo, FieldInfo, Info, StructureInfo
from ..parameter import Parameter, Variant

# fmt: off

#: Class -> its description.
TYPES: dict[str, Info] = {
    "PollEntry": StructureInfo("3dm.poll_entry", mip_3dm.PollEntry, (
            Parameter("descriptor", "descriptor", "scalar", scalar="u8", refers="field"),
            Parameter("reserved", "reserved", "scalar", scalar="u16", reserved=True, default=0),
        )),
    "FactoryStreamingAction": EnumInfo("3dm.factory_streaming_action", mip_3dm.FactoryStreamingAction),
    "ConstellationId": EnumInfo("3dm.constellation_id", mip_3dm.ConstellationId),
    "ConstellationOptions": BitsInfo("3dm.constellation_options", mip_3dm.ConstellationOptions),
    "ConstellationSettingsEntry": StructureInfo("3dm.constellation_settings_entry", mip_3dm.ConstellationSettingsEntry, (
            Parameter("constellation_id", "constellation_id", "scalar", scalar="u8", type=mip_3dm.ConstellationId),
            Parameter("enable", "enable", "scalar", scalar="u8", maximum=1, minimum=0),
            Parameter("reserved_channels", "reserved_channels", "scalar", scalar="u8", units=("1",), maximum=32, minimum=0),
            Parameter("max_channels", "max_channels", "scalar", scalar="u8", units=("1",), maximum=32, minimum=0),
            Parameter("option_flags", "option_flags", "scalar", scalar="u16", type=mip_3dm.ConstellationOptions),
        )),
    "SbasOptions": BitsInfo("3dm.sbas_options", mip_3dm.SbasOptions),
    "AssistedFixOption": EnumInfo("3dm.assisted_fix_option", mip_3dm.AssistedFixOption),
    "PpsSource": EnumInfo("3dm.pps_source", mip_3dm.PpsSource),
    "EventSupportQuery": EnumInfo("3dm.event_support_query", mip_3dm.EventSupportQuery),
    "EventSupportInfo": StructureInfo("3dm.event_support_info", mip_3dm.EventSupportInfo, (
            Parameter("type", "type", "scalar", scalar="u8"),
            Parameter("count", "count", "scalar", scalar="u8", units=("1",)),
        )),
    "EventTriggerStatusEntry": StructureInfo("3dm.event_trigger_status_entry", mip_3dm.EventTriggerStatusEntry, (
            Parameter("type", "type", "scalar", scalar="u8", type=types.EventTriggerType),
            Parameter("status", "status", "scalar", scalar="u8", type=types.EventTriggerStatus),
        )),
    "EventActionStatusEntry": StructureInfo("3dm.event_action_status_entry", mip_3dm.EventActionStatusEntry, (
            Parameter("action_type", "action_type", "scalar", scalar="u8", type=types.EventActionType),
            Parameter("trigger_id", "trigger_id", "scalar", scalar="u8"),
        )),
    "ReceiverDynamics": EnumInfo("3dm.receiver_dynamics", mip_3dm.ReceiverDynamics),
    "DataConditioningFlags": BitsInfo("3dm.data_conditioning_flags", mip_3dm.DataConditioningFlags),
    "MagBandwidth": EnumInfo("3dm.mag_bandwidth", mip_3dm.MagBandwidth),
    "ImuTimestampSelector": EnumInfo("3dm.imu_timestamp_selector", mip_3dm.ImuTimestampSelector),
    "OdometerMode": EnumInfo("3dm.odometer_mode", mip_3dm.OdometerMode),
    "SensorRangeType": EnumInfo("3dm.sensor_range_type", mip_3dm.SensorRangeType),
    "SensorRangeEntry": StructureInfo("3dm.sensor_range_entry", mip_3dm.SensorRangeEntry, (
            Parameter("setting", "setting", "scalar", scalar="u8"),
            Parameter("range", "range", "scalar", scalar="float"),
        )),
    "InternalSensor": EnumInfo("3dm.internal_sensor", mip_3dm.InternalSensor),
    "StreamFormat": EnumInfo("3dm.stream_format", mip_3dm.StreamFormat),
    "SensorPowerState": EnumInfo("3dm.sensor_power_state", mip_3dm.SensorPowerState),
    "DeviceStatusSelector": EnumInfo("3dm.device_status_selector", mip_3dm.DeviceStatusSelector),
    "LegacyDataStream": EnumInfo("3dm.legacy_data_stream", mip_3dm.LegacyDataStream),
    "Gx4SystemState": EnumInfo("3dm.gx4_system_state", mip_3dm.Gx4SystemState),
    "PollImuData": FieldInfo(
        "3dm.poll_imu_data", mip_3dm.PollImuData, devices=("3dm-cv5-10", "3dm-cv5-15", "3dm-cx5-10", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-35", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-gx3-35", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-rq1-imu"), assumed=("3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx3-15", "3dm-gx3-25", "3dm-gx3-45", "3dm-gx5-25", "3dm-gx5-45"), parameters=(
            Parameter("suppress_ack", "suppress_ack", "scalar", scalar="bool"),
            Parameter("num_descriptors", "num_descriptors", "counter", scalar="u8", counts="descriptors"),
            Parameter("descriptors", "descriptors", "array", length="num_descriptors", fields_of="sensor", type=mip_3dm.PollEntry),
        )),
    "PollGnssData": FieldInfo(
        "3dm.poll_gnss_data", mip_3dm.PollGnssData, devices=("3dm-gq4-45", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-gx3-35", "3dm-gx4-45"), assumed=("3dm-cx5-45", "3dm-gx3-45", "3dm-gx5-35"), parameters=(
            Parameter("suppress_ack", "suppress_ack", "scalar", scalar="bool"),
            Parameter("num_descriptors", "num_descriptors", "counter", scalar="u8", counts="descriptors", maximum=83, minimum=0),
            Parameter("descriptors", "descriptors", "array", length="num_descriptors", fields_of="gnss_data", type=mip_3dm.PollEntry),
        )),
    "PollFilterData": FieldInfo(
        "3dm.poll_filter_data", mip_3dm.PollFilterData, devices=("3dm-cv5-15", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45"), assumed=("3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx5-25"), parameters=(
            Parameter("suppress_ack", "suppress_ack", "scalar", scalar="bool"),
            Parameter("num_descriptors", "num_descriptors", "counter", scalar="u8", counts="descriptors"),
            Parameter("descriptors", "descriptors", "array", length="num_descriptors", fields_of="filter_data", type=mip_3dm.PollEntry),
        )),
    "PollNmeaData": FieldInfo(
        "3dm.poll_nmea_data", mip_3dm.PollNmeaData, devices=("3dm-cv7-gnss-ins", "3dm-gq7"), assumed=("3dm-cv7-ins", "3dm-cx7-ins", "3dm-gv7-ins"), parameters=(
            Parameter("suppress_ack", "suppress_ack", "scalar", scalar="bool"),
            Parameter("count", "count", "counter", scalar="u8", counts="format_entries"),
            Parameter("format_entries", "format_entries", "array", length="count", type=types.NmeaMessage),
        )),
    "GetImuBaseRate": FieldInfo(
        "3dm.get_imu_base_rate", mip_3dm.GetImuBaseRate, devices=("3dm-cv5-10", "3dm-cv5-15", "3dm-cx5-10", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-25", "3dm-rq1-imu"), assumed=("3dm-gx3-15", "3dm-gx3-25", "3dm-gx5-35"), parameters=(
        )),
    "GetGnssBaseRate": FieldInfo(
        "3dm.get_gnss_base_rate", mip_3dm.GetGnssBaseRate, devices=("3dm-gq4-45", "3dm-gx5-35", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cx5-45", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-45"), parameters=(
        )),
    "ImuMessageFormat": FieldInfo(
        "3dm.imu_message_format", mip_3dm.ImuMessageFormat, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv5-10", "3dm-cv5-15", "3dm-cx5-10", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-35", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-25", "3dm-rq1-imu"), assumed=("3dm-gx3-15", "3dm-gx3-25"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("num_descriptors", "num_descriptors", "counter", scalar="u8", counts="descriptors", required=("write",)),
            Parameter("descriptors", "descriptors", "array", length="num_descriptors", required=("write",), fields_of="sensor", type=types.DescriptorRate),
        )),
    "GnssMessageFormat": FieldInfo(
        "3dm.gnss_message_format", mip_3dm.GnssMessageFormat, functions=("write", "read", "save", "load", "default"), devices=("3dm-gq4-45", "3dm-gx5-35", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cx5-45", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-45"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("num_descriptors", "num_descriptors", "counter", scalar="u8", counts="descriptors", maximum=82, required=("write",), minimum=0),
            Parameter("descriptors", "descriptors", "array", length="num_descriptors", required=("write",), fields_of="gnss_data", type=types.DescriptorRate),
        )),
    "FilterMessageFormat": FieldInfo(
        "3dm.filter_message_format", mip_3dm.FilterMessageFormat, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv5-15", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("num_descriptors", "num_descriptors", "counter", scalar="u8", counts="descriptors", required=("write",)),
            Parameter("descriptors", "descriptors", "array", length="num_descriptors", required=("write",), fields_of="filter_data", type=types.DescriptorRate),
        )),
    "GetFilterBaseRate": FieldInfo(
        "3dm.get_filter_base_rate", mip_3dm.GetFilterBaseRate, devices=("3dm-cv5-15", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25"), parameters=(
        )),
    "NmeaMessageFormat": FieldInfo(
        "3dm.nmea_message_format", mip_3dm.NmeaMessageFormat, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins",), likely=("3dm-gq7",), assumed=("3dm-cv7-ins", "3dm-cx7-ins", "3dm-gv7-ins"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("count", "count", "counter", scalar="u8", counts="format_entries", required=("write",)),
            Parameter("format_entries", "format_entries", "array", length="count", required=("write",), type=types.NmeaMessage),
        )),
    "PollData": FieldInfo(
        "3dm.poll_data", mip_3dm.PollData, devices=("3dm-cv7-gnss-ins",), assumed=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("descriptor_set", "descriptor_set", "scalar", scalar="u8", minimum=128, maximum=254, refers="set"),
            Parameter("suppress_ack", "suppress_ack", "scalar", scalar="bool"),
            Parameter("num_descriptors", "num_descriptors", "counter", scalar="u8", counts="descriptors"),
            Parameter("descriptors", "descriptors", "array", scalar="u8", length="num_descriptors", refers="field", fields_of="descriptor_set"),
        )),
    "GetBaseRate": FieldInfo(
        "3dm.get_base_rate", mip_3dm.GetBaseRate, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gq7"), likely=("3dm-cv7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), assumed=("3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins"), parameters=(
            Parameter("descriptor_set", "descriptor_set", "scalar", scalar="u8", minimum=128, maximum=254, refers="set"),
        )),
    "MessageFormat": FieldInfo(
        "3dm.message_format", mip_3dm.MessageFormat, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins",), likely=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), assumed=("3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("descriptor_set", "descriptor_set", "scalar", scalar="u8", required=("write", "read", "save", "load", "default"), refers="set"),
            Parameter("num_descriptors", "num_descriptors", "counter", scalar="u8", counts="descriptors", required=("write",)),
            Parameter("descriptors", "descriptors", "array", length="num_descriptors", required=("write",), fields_of="descriptor_set", type=types.DescriptorRate),
        )),
    "FactoryStreaming": FieldInfo(
        "3dm.factory_streaming", mip_3dm.FactoryStreaming, devices=("3dm-cv7-gnss-ins",), likely=("3dm-gq7",), assumed=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("action", "action", "scalar", scalar="u8", type=mip_3dm.FactoryStreamingAction),
            Parameter("reserved", "reserved", "scalar", scalar="u8", reserved=True, default=0),
        )),
    "DataStreamControl": FieldInfo(
        "3dm.data_stream_control", mip_3dm.DataStreamControl, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-cx5-10", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-35", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cv7-ins", "3dm-dh3", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-gx5-45", "3dm-mv5-ar"), assumed=("3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx3-15", "3dm-gx3-25"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("descriptor_set", "descriptor_set", "scalar", scalar="u8", required=("write", "read", "save", "load", "default"), refers="set", variants=(Variant("device", ("3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-gx3-15", "3dm-gx3-25", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx5-25", "3dm-mv5-ar"), {"only": ("all_streams", "imu", "filter"), "type": mip_3dm.LegacyDataStream}), Variant("device", ("3dm-cx5-45", "3dm-dh3", "3dm-gq4-45", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-35", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st", "3dm-rq1-imu"), {"type": mip_3dm.LegacyDataStream}), Variant("device", ("3dm-gx5-15",), {"only": ("imu", "filter"), "type": mip_3dm.LegacyDataStream}),)),
            Parameter("enable", "enable", "scalar", scalar="bool", default=True, required=("write",)),
        )),
    "RawRtcm2_3Message": FieldInfo(
        "3dm.raw_rtcm_2_3_message", mip_3dm.RawRtcm2_3Message, devices=("3dm-gq4-45", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), parameters=(
            Parameter("data", "data", "array", scalar="u8", length="rest"),
        )),
    "ConstellationSettings": FieldInfo(
        "3dm.constellation_settings", mip_3dm.ConstellationSettings, functions=("write", "read", "save", "load", "default"), devices=("3dm-gq4-45", "3dm-gx5-35"), assumed=("3dm-cx5-45", "3dm-gx5-45"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("max_channels", "max_channels", "scalar", scalar="u16", units=("1",), required=("write",)),
            Parameter("config_count", "config_count", "counter", scalar="u8", counts="settings", maximum=41, required=("write",), minimum=0),
            Parameter("settings", "settings", "array", length="config_count", required=("write",), type=mip_3dm.ConstellationSettingsEntry),
        )),
    "GnssSbasSettings": FieldInfo(
        "3dm.gnss_sbas_settings", mip_3dm.GnssSbasSettings, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gx5-35"), likely=("3dm-gq7",), assumed=("3dm-cx5-45", "3dm-gx5-45"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("enable_sbas", "enable_sbas", "scalar", scalar="u8", maximum=1, required=("write",), minimum=0, variants=(Variant("device", ("3dm-gx5-35",), {"default": 1}),)),
            Parameter("sbas_options", "sbas_options", "scalar", scalar="u16", required=("write",), type=mip_3dm.SbasOptions, variants=(Variant("device", ("3dm-gx5-35",), {"default": 3}),)),
            Parameter("num_included_prns", "num_included_prns", "counter", scalar="u8", counts="included_prns", required=("write",)),
            Parameter("included_prns", "included_prns", "array", scalar="u16", length="num_included_prns", required=("write",)),
        )),
    "GnssAssistedFix": FieldInfo(
        "3dm.gnss_assisted_fix", mip_3dm.GnssAssistedFix, functions=("write", "read", "save", "load", "default"), devices=("3dm-gx5-35",), assumed=("3dm-cx5-45", "3dm-gx5-45"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("option", "option", "scalar", scalar="u8", required=("write",), default=0, type=mip_3dm.AssistedFixOption, variants=(Variant("device", ("3dm-gx5-35",), {"default": 0}),)),
            Parameter("flags", "flags", "scalar", scalar="u8", default=255, required=("write",), reserved=True, variants=(Variant("device", ("3dm-gx5-35",), {"default": 255}),)),
        )),
    "GnssTimeAssistance": FieldInfo(
        "3dm.gnss_time_assistance", mip_3dm.GnssTimeAssistance, functions=("write", "read"), devices=("3dm-gx5-35",), assumed=("3dm-cx5-45", "3dm-gx5-45"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("tow", "tow", "scalar", scalar="double", units=("s",), below=604800, required=("write",), minimum=0),
            Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",), required=("write",)),
            Parameter("accuracy", "accuracy", "scalar", scalar="float", units=("s",), required=("write",), minimum=0),
        )),
    "PpsSourceControl": FieldInfo(
        "3dm.pps_source_control", mip_3dm.PpsSourceControl, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins",), likely=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("source", "source", "scalar", scalar="u8", required=("write",), type=mip_3dm.PpsSource, variants=(Variant("device", ("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), {"only": ("disabled", "gpio", "generated")}), Variant("device", ("3dm-cv7-gnss-ins",), {"default": 1}), Variant("device", ("3dm-gq7",), {"only": ("disabled", "receiver_1", "receiver_2", "gpio", "generated")}),)),
        )),
    "GetEventSupport": FieldInfo(
        "3dm.get_event_support", mip_3dm.GetEventSupport, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins"), assumed=("3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("query", "query", "scalar", scalar="u8", type=mip_3dm.EventSupportQuery),
        )),
    "EventControl": FieldInfo(
        "3dm.event_control", mip_3dm.EventControl, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins",), likely=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-gv7-ahrs", "3dm-gv7-ar"), assumed=("3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ins"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("instance", "instance", "scalar", scalar="u8", required=("write", "read", "save", "load", "default")),
            Parameter("mode", "mode", "scalar", scalar="u8", required=("write",), default=0, type=types.EventTriggerMode),
        )),
    "GetEventTriggerStatus": FieldInfo(
        "3dm.get_event_trigger_status", mip_3dm.GetEventTriggerStatus, devices=("3dm-cv7-gnss-ins",), assumed=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("requested_count", "requested_count", "counter", scalar="u8", counts="requested_instances"),
            Parameter("requested_instances", "requested_instances", "array", scalar="u8", length="requested_count"),
        )),
    "GetEventActionStatus": FieldInfo(
        "3dm.get_event_action_status", mip_3dm.GetEventActionStatus, devices=("3dm-cv7-gnss-ins",), assumed=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("requested_count", "requested_count", "counter", scalar="u8", counts="requested_instances"),
            Parameter("requested_instances", "requested_instances", "array", scalar="u8", length="requested_count"),
        )),
    "EventTriggerConfig": FieldInfo(
        "3dm.event_trigger_config", mip_3dm.EventTriggerConfig, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins"), likely=("3dm-gv7-ahrs", "3dm-gv7-ar"), assumed=("3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ins"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("instance", "instance", "scalar", scalar="u8", required=("write", "read", "save", "load", "default")),
            Parameter("type", "type", "scalar", scalar="u8", required=("write",), default=0, type=types.EventTriggerType),
            Parameter("parameters", "parameters", "switch", tag="type", required=("write",), cases={0: None, 1: Parameter("gpio", "gpio", "struct", type=types.EventTriggerGpio), 2: Parameter("threshold", "threshold", "struct", type=types.EventTriggerThreshold), 3: Parameter("combination", "combination", "struct", type=types.EventTriggerCombination), }),
        )),
    "EventActionConfig": FieldInfo(
        "3dm.event_action_config", mip_3dm.EventActionConfig, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins"), likely=("3dm-gv7-ahrs", "3dm-gv7-ar"), assumed=("3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ins"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("instance", "instance", "scalar", scalar="u8", required=("write", "read", "save", "load", "default")),
            Parameter("trigger", "trigger", "scalar", scalar="u8", required=("write",)),
            Parameter("type", "type", "scalar", scalar="u8", required=("write",), default=0, type=types.EventActionType),
            Parameter("parameters", "parameters", "switch", tag="type", required=("write",), cases={0: None, 1: Parameter("gpio", "gpio", "struct", type=types.EventActionGpio), 2: Parameter("message", "message", "struct", type=types.EventActionMessage), }),
        )),
    "DeviceSettings": FieldInfo(
        "3dm.device_settings", mip_3dm.DeviceSettings, functions=("save", "load", "default"), devices=("3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-35", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx5-25", "3dm-rtk"), assumed=("3dm-cv5-10", "3dm-cx5-10", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        )),
    "SensorToVehicleTransformEuler": FieldInfo(
        "3dm.sensor_to_vehicle_transform_euler", mip_3dm.SensorToVehicleTransformEuler, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins", "3dm-gq7"), likely=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar"), assumed=("3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gv7-ins"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("roll", "roll", "scalar", scalar="float", units=("rad",), frame="vehicle", required=("write",)),
            Parameter("pitch", "pitch", "scalar", scalar="float", units=("rad",), frame="vehicle", required=("write",)),
            Parameter("yaw", "yaw", "scalar", scalar="float", units=("rad",), frame="vehicle", required=("write",)),
        )),
    "SensorToVehicleTransformQuaternion": FieldInfo(
        "3dm.sensor_to_vehicle_transform_quaternion", mip_3dm.SensorToVehicleTransformQuaternion, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins",), assumed=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("q", "q", "array", scalar="float", elements=("w", "x", "y", "z"), units=("1",), required=("write",)),
        )),
    "SensorToVehicleTransformDcm": FieldInfo(
        "3dm.sensor_to_vehicle_transform_dcm", mip_3dm.SensorToVehicleTransformDcm, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins",), assumed=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("dcm", "dcm", "array", scalar="float", elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"), units=("1",), required=("write",)),
        )),
    "GpsDynamicsMode": FieldInfo(
        "3dm.gps_dynamics_mode", mip_3dm.GpsDynamicsMode, functions=("write", "read", "save", "load", "default"), likely=("3dm-gx3-35",), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("mode", "mode", "scalar", scalar="u8", required=("write",), type=mip_3dm.ReceiverDynamics),
        )),
    "ImuSignalConditioning": FieldInfo(
        "3dm.imu_signal_conditioning", mip_3dm.ImuSignalConditioning, functions=("write", "read", "save", "load", "default"), likely=("3dm-gx3-15", "3dm-gx3-25", "3dm-gx3-35"), assumed=("3dm-gx3-45",), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("orientation_decimation", "orientation_decimation", "scalar", scalar="u16", units=("1",), minimum=1, maximum=1000, required=("write",)),
            Parameter("data_conditioning_flags", "data_conditioning_flags", "scalar", scalar="u16", default=3, required=("write",), type=mip_3dm.DataConditioningFlags),
            Parameter("inertial_filter_width", "inertial_filter_width", "scalar", scalar="u8", units=("1",), minimum=1, maximum=32, default=15, required=("write",)),
            Parameter("mag_filter_width", "mag_filter_width", "scalar", scalar="u8", units=("1",), minimum=1, maximum=32, default=17, required=("write",)),
            Parameter("up_compensation", "up_compensation", "scalar", scalar="u16", units=("s",), minimum=1, maximum=1000, default=10, required=("write",)),
            Parameter("north_compensation", "north_compensation", "scalar", scalar="u16", units=("s",), minimum=1, maximum=1000, default=10, required=("write",)),
            Parameter("mag_bandwidth", "mag_bandwidth", "scalar", scalar="u8", required=("write",), type=mip_3dm.MagBandwidth),
            Parameter("reserved", "reserved", "scalar", scalar="u16", required=("write",), reserved=True, default=0),
        )),
    "ImuTimestamp": FieldInfo(
        "3dm.imu_timestamp", mip_3dm.ImuTimestamp, functions=("write", "read"), likely=("3dm-gx3-35",), assumed=("3dm-gx3-15", "3dm-gx3-25", "3dm-gx3-45"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("selector", "selector", "scalar", scalar="u8", required=("write", "read"), type=mip_3dm.ImuTimestampSelector),
            Parameter("time", "time", "scalar", scalar="u32", required=("write",)),
        )),
    "AccelBias": FieldInfo(
        "3dm.accel_bias", mip_3dm.AccelBias, functions=("write", "read", "save", "load", "default", "apply"), devices=("3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-35", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-25", "3dm-gx5-45", "3dm-rq1-imu"), assumed=("3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), advanced=True, parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("bias", "bias", "array", scalar="float", elements=("x", "y", "z"), units=("g",), frame="sensor", required=("write", "apply")),
        )),
    "GyroBias": FieldInfo(
        "3dm.gyro_bias", mip_3dm.GyroBias, functions=("write", "read", "save", "load", "default", "apply"), devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gx5-15", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-25", "3dm-gx5-45", "3dm-rq1-imu"), assumed=("3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ins", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx5-35"), advanced=True, parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("bias", "bias", "array", scalar="float", elements=("x", "y", "z"), units=("rad/s",), frame="sensor", required=("write", "apply")),
        )),
    "CaptureGyroBias": FieldInfo(
        "3dm.capture_gyro_bias", mip_3dm.CaptureGyroBias, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gq7", "3dm-gx5-15", "3dm-gx5-35", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-25", "3dm-gx5-45", "3dm-rq1-imu"), assumed=("3dm-cv5-10", "3dm-cx5-10", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins"), parameters=(
            Parameter("averaging_time_ms", "averaging_time_ms", "scalar", scalar="u16", units=("ms",), minimum=1000, maximum=30000),
        )),
    "MagHardIronOffset": FieldInfo(
        "3dm.mag_hard_iron_offset", mip_3dm.MagHardIronOffset, functions=("write", "read", "save", "load", "default", "apply"), devices=("3dm-cv7-ahrs", "3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-25"), assumed=("3dm-cv5-25", "3dm-cv7-ins", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ins", "3dm-gx5-35"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("offset", "offset", "array", scalar="float", elements=("x", "y", "z"), units=("gauss",), frame="sensor", required=("write", "apply"), variants=(Variant("device", ("3dm-gx5-45",), {"default": (0, 0, 0)}),)),
        )),
    "MagSoftIronMatrix": FieldInfo(
        "3dm.mag_soft_iron_matrix", mip_3dm.MagSoftIronMatrix, functions=("write", "read", "save", "load", "default", "apply"), devices=("3dm-cv7-ahrs", "3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gx5-35", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-25", "3dm-gx5-45"), assumed=("3dm-cv5-25", "3dm-cv7-ins", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ins"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("matrix", "matrix", "array", scalar="float", elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"), units=("1",), frame="sensor", required=("write", "apply")),
        )),
    "ConingScullingEnable": FieldInfo(
        "3dm.coning_sculling_enable", mip_3dm.ConingScullingEnable, functions=("write", "read", "save", "load", "default"), devices=("3dm-gq4-45", "3dm-gx5-15", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-gx4-imu", "3dm-gx5-25", "3dm-gx5-45", "3dm-rq1-imu"), assumed=("3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-35"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("enable", "enable", "scalar", scalar="bool", default=True, required=("write",)),
        )),
    "UartBaudRate": FieldInfo(
        "3dm.uart_baud_rate", mip_3dm.UartBaudRate, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-gx4-25",), assumed=("3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx4-15", "3dm-gx4-45", "3dm-gx5-25", "3dm-gx5-35"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("baud", "baud", "scalar", scalar="u32", units=("Bd",), required=("write",), variants=(Variant("device", ("3dm-gx5-15", "3dm-gx5-45"), {"default": 115200}),)),
        )),
    "GpioConfig": FieldInfo(
        "3dm.gpio_config", mip_3dm.GpioConfig, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins"), likely=("3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("pin", "pin", "scalar", scalar="u8", required=("write", "read", "save", "load", "default")),
            Parameter("feature", "feature", "scalar", scalar="u8", required=("write",), default=0, type=types.GpioFeature),
            Parameter("behavior", "behavior", "scalar", scalar="u8", required=("write",), variants=(Variant("feature", (0,), {"type": types.GpioUnusedBehavior}), Variant("feature", (1,), {"type": types.GpioBehavior}), Variant("feature", (2,), {"type": types.GpioPpsBehavior}), Variant("feature", (3,), {"type": types.GpioEncoderBehavior}), Variant("feature", (4,), {"type": types.GpioTimestampBehavior}), Variant("feature", (5,), {"type": types.GpioUartBehavior}),)),
            Parameter("pin_mode", "pin_mode", "scalar", scalar="u8", required=("write",), type=types.GpioPinMode),
        )),
    "GpioState": FieldInfo(
        "3dm.gpio_state", mip_3dm.GpioState, functions=("write", "read"), devices=("3dm-cv7-gnss-ins", "3dm-gq7"), likely=("3dm-cv7-ins", "3dm-gv7-ins"), assumed=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("pin", "pin", "scalar", scalar="u8", minimum=1, required=("write", "read")),
            Parameter("state", "state", "scalar", scalar="bool", required=("write",)),
        )),
    "OdometerConfig": FieldInfo(
        "3dm.odometer_config", mip_3dm.OdometerConfig, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins",), likely=("3dm-gq7",), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("mode", "mode", "scalar", scalar="u8", required=("write",), type=mip_3dm.OdometerMode),
            Parameter("scaling", "scaling", "scalar", scalar="float", units=("pulse/m",), required=("write",)),
            Parameter("uncertainty", "uncertainty", "scalar", scalar="float", units=("1",), required=("write",), minimum=0),
        )),
    "ImuLowPassFilter": FieldInfo(
        "3dm.imu_low_pass_filter", mip_3dm.ImuLowPassFilter, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gq7", "3dm-gx5-15", "3dm-rq1-45-lt", "3dm-rq1-45-st"), assumed=("3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ins", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-gx5-35", "3dm-gx5-45"), advanced=True, parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("target_descriptor", "target_descriptor", "scalar", scalar="u8", required=("write", "read", "save", "load", "default"), refers="field", fields_of="sensor", variants=(Variant("device", ("3dm-cv7-gnss-ins",), {}),)),
            Parameter("enable", "enable", "scalar", scalar="bool", default=True, required=("write",)),
            Parameter("manual", "manual", "scalar", scalar="bool", required=("write",), default=False),
            Parameter("frequency", "frequency", "scalar", scalar="u16", units=("Hz",), required=("write",), variants=(Variant("device", ("3dm-gx5-15",), {"maximum": 250}),)),
            Parameter("reserved", "reserved", "scalar", scalar="u8", required=("write",), reserved=True, default=0),
        )),
    "ComplementaryFilter": FieldInfo(
        "3dm.complementary_filter", mip_3dm.ComplementaryFilter, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-35"), likely=("3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-gx5-45"), assumed=("3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("pitch_roll_enable", "pitch_roll_enable", "scalar", scalar="bool", required=("write",), variants=(Variant("device", ("3dm-gx5-15",), {"default": True}),)),
            Parameter("heading_enable", "heading_enable", "scalar", scalar="bool", required=("write",), variants=(Variant("device", ("3dm-cv5-10", "3dm-cv5-15", "3dm-cx5-10", "3dm-cx5-15"), {}), Variant("device", ("3dm-gx5-15",), {"default": True}),)),
            Parameter("pitch_roll_time_constant", "pitch_roll_time_constant", "scalar", scalar="float", units=("s",), minimum=1, maximum=1000, default=10, required=("write",)),
            Parameter("heading_time_constant", "heading_time_constant", "scalar", scalar="float", units=("s",), minimum=1, maximum=1000, default=10, required=("write",)),
        )),
    "SensorRange": FieldInfo(
        "3dm.sensor_range", mip_3dm.SensorRange, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins",), likely=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins"), assumed=("3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("sensor", "sensor", "scalar", scalar="u8", required=("write", "read", "save", "load", "default"), type=mip_3dm.SensorRangeType, variants=(Variant("device", ("3dm-cv7-ar", "3dm-cx7-ar", "3dm-gv7-ar"), {"only": ("all", "accel", "gyro", "pressure")}),)),
            Parameter("setting", "setting", "scalar", scalar="u8", required=("write",)),
        )),
    "GetCalibratedSensorRanges": FieldInfo(
        "3dm.get_calibrated_sensor_ranges", mip_3dm.GetCalibratedSensorRanges, devices=("3dm-cv7-gnss-ins",), assumed=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("sensor", "sensor", "scalar", scalar="u8", type=mip_3dm.SensorRangeType, variants=(Variant("device", ("3dm-cv7-ar", "3dm-cx7-ar", "3dm-gv7-ar"), {"only": ("all", "accel", "gyro", "pressure")}),)),
        )),
    "LowPassFilter": FieldInfo(
        "3dm.low_pass_filter", mip_3dm.LowPassFilter, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gq7"), assumed=("3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("descriptor_set", "descriptor_set", "scalar", scalar="u8", required=("write", "read", "save", "load", "default"), refers="set"),
            Parameter("field_descriptor", "field_descriptor", "scalar", scalar="u8", required=("write", "read", "save", "load", "default"), refers="field", fields_of="descriptor_set"),
            Parameter("enable", "enable", "scalar", scalar="bool", required=("write",)),
            Parameter("manual", "manual", "scalar", scalar="bool", required=("write",)),
            Parameter("frequency", "frequency", "scalar", scalar="float", units=("Hz",), required=("write",), minimum=0),
        )),
    "DataStreamFormat": FieldInfo(
        "3dm.data_stream_format", mip_3dm.DataStreamFormat, functions=("write", "read", "save", "load", "default"), likely=("3dm-gx3-35",), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("stream", "stream", "scalar", scalar="u8", required=("write", "read", "save", "load", "default"), type=mip_3dm.InternalSensor),
            Parameter("format", "format", "scalar", scalar="u8", required=("write", "read", "save", "load", "default"), type=mip_3dm.StreamFormat),
        )),
    "DevicePowerState": FieldInfo(
        "3dm.device_power_state", mip_3dm.DevicePowerState, functions=("write", "read", "save", "load", "default"), likely=("3dm-gx3-25", "3dm-gx3-35"), assumed=("3dm-gx3-15",), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("device", "device", "scalar", scalar="u8", required=("write", "read", "save", "load", "default"), type=mip_3dm.InternalSensor, variants=(Variant("device", ("3dm-gx3-15", "3dm-gx3-25"), {"only": ("imu",)}),)),
            Parameter("state", "state", "scalar", scalar="u8", required=("write",), type=mip_3dm.SensorPowerState),
        )),
    "GpsAdvancedSettings": FieldInfo(
        "3dm.gps_advanced_settings", mip_3dm.GpsAdvancedSettings, functions=("save", "load", "default"), likely=("3dm-gx3-35",), advanced=True, parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        )),
    "DeviceStatus": FieldInfo(
        "3dm.device_status", mip_3dm.DeviceStatus, devices=("3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-35", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-gx3-35", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-25", "3dm-rq1-imu"), assumed=("3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx3-15", "3dm-gx3-25", "3dm-gx3-45"), advanced=True, parameters=(
            Parameter("model_number", "model_number", "scalar", scalar="u16", variants=(Variant("device", ("3dm-gx5-15",), {"constant": 6254}), Variant("device", ("3dm-gx5-35",), {"constant": 6252}), Variant("device", ("3dm-gx5-45",), {"constant": 6251}),)),
            Parameter("status_selector", "status_selector", "scalar", scalar="u8", type=mip_3dm.DeviceStatusSelector),
        )),
    "ImuMessageFormatResponse": FieldInfo(
        "3dm.imu_message_format_response", mip_3dm.ImuMessageFormatResponse, devices=("3dm-cv5-10", "3dm-cv5-15", "3dm-cx5-10", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-35", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-25", "3dm-rq1-imu"), assumed=("3dm-gx3-15", "3dm-gx3-25"), parameters=(
            Parameter("num_descriptors", "num_descriptors", "counter", scalar="u8", counts="descriptors"),
            Parameter("descriptors", "descriptors", "array", length="num_descriptors", fields_of="sensor", type=types.DescriptorRate),
        )),
    "GnssMessageFormatResponse": FieldInfo(
        "3dm.gnss_message_format_response", mip_3dm.GnssMessageFormatResponse, devices=("3dm-gq4-45", "3dm-gx5-35", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cx5-45", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-45"), parameters=(
            Parameter("num_descriptors", "num_descriptors", "counter", scalar="u8", counts="descriptors", maximum=82, minimum=0),
            Parameter("descriptors", "descriptors", "array", length="num_descriptors", fields_of="gnss_data", type=types.DescriptorRate),
        )),
    "FilterMessageFormatResponse": FieldInfo(
        "3dm.filter_message_format_response", mip_3dm.FilterMessageFormatResponse, devices=("3dm-cv5-15", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25"), parameters=(
            Parameter("num_descriptors", "num_descriptors", "counter", scalar="u8", counts="descriptors"),
            Parameter("descriptors", "descriptors", "array", length="num_descriptors", fields_of="filter_data", type=types.DescriptorRate),
        )),
    "GetImuBaseRateResponse": FieldInfo(
        "3dm.get_imu_base_rate_response", mip_3dm.GetImuBaseRateResponse, devices=("3dm-cv5-10", "3dm-cv5-15", "3dm-cx5-10", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-25", "3dm-rq1-imu"), assumed=("3dm-gx3-15", "3dm-gx3-25", "3dm-gx5-35"), parameters=(
            Parameter("rate", "rate", "scalar", scalar="u16", units=("Hz",)),
        )),
    "GetGnssBaseRateResponse": FieldInfo(
        "3dm.get_gnss_base_rate_response", mip_3dm.GetGnssBaseRateResponse, devices=("3dm-gq4-45", "3dm-gx5-35", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cx5-45", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-45"), parameters=(
            Parameter("rate", "rate", "scalar", scalar="u16", units=("Hz",)),
        )),
    "DataStreamControlResponse": FieldInfo(
        "3dm.data_stream_control_response", mip_3dm.DataStreamControlResponse, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-cx5-10", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-35", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cv7-ins", "3dm-dh3", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-gx5-45", "3dm-mv5-ar"), assumed=("3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx3-15", "3dm-gx3-25"), parameters=(
            Parameter("descriptor_set", "descriptor_set", "scalar", scalar="u8", refers="set", variants=(Variant("device", ("3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-gx3-15", "3dm-gx3-25", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx5-25", "3dm-mv5-ar"), {"only": ("all_streams", "imu", "filter"), "type": mip_3dm.LegacyDataStream}), Variant("device", ("3dm-cx5-45", "3dm-dh3", "3dm-gq4-45", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-35", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st", "3dm-rq1-imu"), {"type": mip_3dm.LegacyDataStream}), Variant("device", ("3dm-gx5-15",), {"only": ("imu", "filter"), "type": mip_3dm.LegacyDataStream}),)),
            Parameter("enabled", "enabled", "scalar", scalar="bool"),
        )),
    "ImuSignalConditioningResponse": FieldInfo(
        "3dm.imu_signal_conditioning_response", mip_3dm.ImuSignalConditioningResponse, likely=("3dm-gx3-15", "3dm-gx3-25", "3dm-gx3-35"), assumed=("3dm-gx3-45",), parameters=(
            Parameter("orientation_decimation", "orientation_decimation", "scalar", scalar="u16", units=("1",), minimum=1, maximum=1000),
            Parameter("data_conditioning_flags", "data_conditioning_flags", "scalar", scalar="u16", default=3, type=mip_3dm.DataConditioningFlags),
            Parameter("inertial_filter_width", "inertial_filter_width", "scalar", scalar="u8", units=("1",), minimum=1, maximum=32, default=15),
            Parameter("mag_filter_width", "mag_filter_width", "scalar", scalar="u8", units=("1",), minimum=1, maximum=32, default=17),
            Parameter("up_compensation", "up_compensation", "scalar", scalar="u16", units=("s",), minimum=1, maximum=1000, default=10),
            Parameter("north_compensation", "north_compensation", "scalar", scalar="u16", units=("s",), minimum=1, maximum=1000, default=10),
            Parameter("mag_bandwidth", "mag_bandwidth", "scalar", scalar="u8", type=mip_3dm.MagBandwidth),
            Parameter("reserved", "reserved", "scalar", scalar="u16", reserved=True, default=0),
        )),
    "UartBaudRateResponse": FieldInfo(
        "3dm.uart_baud_rate_response", mip_3dm.UartBaudRateResponse, devices=("3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-gx4-25",), assumed=("3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx4-15", "3dm-gx4-45", "3dm-gx5-25", "3dm-gx5-35"), parameters=(
            Parameter("baud", "baud", "scalar", scalar="u32", units=("Bd",)),
        )),
    "DataStreamFormatResponse": FieldInfo(
        "3dm.data_stream_format_response", mip_3dm.DataStreamFormatResponse, likely=("3dm-gx3-35",), parameters=(
            Parameter("stream", "stream", "scalar", scalar="u8", type=mip_3dm.InternalSensor),
            Parameter("format", "format", "scalar", scalar="u8", type=mip_3dm.StreamFormat),
        )),
    "DevicePowerStateResponse": FieldInfo(
        "3dm.device_power_state_response", mip_3dm.DevicePowerStateResponse, likely=("3dm-gx3-25", "3dm-gx3-35"), assumed=("3dm-gx3-15",), parameters=(
            Parameter("device", "device", "scalar", scalar="u8", type=mip_3dm.InternalSensor),
            Parameter("state", "state", "scalar", scalar="u8", type=mip_3dm.SensorPowerState),
        )),
    "GetFilterBaseRateResponse": FieldInfo(
        "3dm.get_filter_base_rate_response", mip_3dm.GetFilterBaseRateResponse, devices=("3dm-cv5-15", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25"), parameters=(
            Parameter("rate", "rate", "scalar", scalar="u16", units=("Hz",)),
        )),
    "ImuLowPassFilterResponse": FieldInfo(
        "3dm.imu_low_pass_filter_response", mip_3dm.ImuLowPassFilterResponse, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gq7", "3dm-gx5-15", "3dm-rq1-45-lt", "3dm-rq1-45-st"), assumed=("3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ins", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-gx5-35", "3dm-gx5-45"), parameters=(
            Parameter("target_descriptor", "target_descriptor", "scalar", scalar="u8", refers="field", fields_of="sensor"),
            Parameter("enable", "enable", "scalar", scalar="bool", default=True),
            Parameter("manual", "manual", "scalar", scalar="bool", default=False),
            Parameter("frequency", "frequency", "scalar", scalar="u16", units=("Hz",)),
            Parameter("reserved", "reserved", "scalar", scalar="u8", reserved=True, default=0),
        )),
    "NmeaMessageFormatResponse": FieldInfo(
        "3dm.nmea_message_format_response", mip_3dm.NmeaMessageFormatResponse, devices=("3dm-cv7-gnss-ins",), likely=("3dm-gq7",), assumed=("3dm-cv7-ins", "3dm-cx7-ins", "3dm-gv7-ins"), parameters=(
            Parameter("count", "count", "counter", scalar="u8", counts="format_entries"),
            Parameter("format_entries", "format_entries", "array", length="count", type=types.NmeaMessage),
        )),
    "GetBaseRateResponse": FieldInfo(
        "3dm.get_base_rate_response", mip_3dm.GetBaseRateResponse, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gq7"), likely=("3dm-cv7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), assumed=("3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins"), parameters=(
            Parameter("descriptor_set", "descriptor_set", "scalar", scalar="u8", refers="set"),
            Parameter("rate", "rate", "scalar", scalar="u16", units=("Hz",)),
        )),
    "MessageFormatResponse": FieldInfo(
        "3dm.message_format_response", mip_3dm.MessageFormatResponse, devices=("3dm-cv7-gnss-ins",), likely=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), assumed=("3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins"), parameters=(
            Parameter("descriptor_set", "descriptor_set", "scalar", scalar="u8", refers="set"),
            Parameter("num_descriptors", "num_descriptors", "counter", scalar="u8", counts="descriptors"),
            Parameter("descriptors", "descriptors", "array", length="num_descriptors", fields_of="descriptor_set", type=types.DescriptorRate),
        )),
    "DeviceStatusBasicRq1ImuResponse": FieldInfo(
        "3dm.device_status_basic_rq1_imu_response", mip_3dm.DeviceStatusBasicRq1ImuResponse, likely=("3dm-rq1-imu",), parameters=(
            Parameter("model_number", "model_number", "constant", scalar="u16", constant=6238),
            Parameter("status_selector", "status_selector", "constant", scalar="u8", constant=1),
            Parameter("status_flags", "status_flags", "scalar", scalar="u32"),
            Parameter("system_timer", "system_timer", "scalar", scalar="u64", units=("us",)),
        )),
    "DeviceStatusBasicResponse": FieldInfo(
        "3dm.device_status_basic_response", mip_3dm.DeviceStatusBasicResponse, devices=("3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-35", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-gx4-45", "3dm-gx5-25"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx3-15", "3dm-gx3-25"), parameters=(
            Parameter("model_number", "model_number", "scalar", scalar="u16"),
            Parameter("status_selector", "status_selector", "constant", scalar="u8", constant=1),
            Parameter("status_flags", "status_flags", "scalar", scalar="u32"),
            Parameter("system_state", "system_state", "scalar", scalar="u16", variants=(Variant("device", ("3dm-gx4-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), {"type": mip_3dm.Gx4SystemState}),)),
            Parameter("system_timer", "system_timer", "scalar", scalar="u32", units=("ms",)),
        )),
    "DeviceStatusBasicWithoutStateResponse": FieldInfo(
        "3dm.device_status_basic_without_state_response", mip_3dm.DeviceStatusBasicWithoutStateResponse, likely=("3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-imu"), assumed=("3dm-cv5-10", "3dm-cx5-10"), parameters=(
            Parameter("model_number", "model_number", "scalar", scalar="u16"),
            Parameter("status_selector", "status_selector", "constant", scalar="u8", constant=1),
            Parameter("status_flags", "status_flags", "scalar", scalar="u32"),
            Parameter("system_timer", "system_timer", "scalar", scalar="u32", units=("ms",)),
        )),
    "DeviceStatusDiagnosticResponse": FieldInfo(
        "3dm.device_status_diagnostic_response", mip_3dm.DeviceStatusDiagnosticResponse, devices=("3dm-gx5-15",), likely=("3dm-gx5-25",), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-gx3-15", "3dm-gx3-25"), parameters=(
            Parameter("model_number", "model_number", "scalar", scalar="u16"),
            Parameter("status_selector", "status_selector", "constant", scalar="u8", constant=2),
            Parameter("status_flags", "status_flags", "scalar", scalar="u32"),
            Parameter("system_state", "system_state", "scalar", scalar="u16"),
            Parameter("system_timer", "system_timer", "scalar", scalar="u32", units=("ms",)),
            Parameter("imu_stream_enabled", "imu_stream_enabled", "scalar", scalar="bool"),
            Parameter("filter_stream_enabled", "filter_stream_enabled", "scalar", scalar="bool"),
            Parameter("imu_dropped_packets", "imu_dropped_packets", "scalar", scalar="u32", units=("1",)),
            Parameter("filter_dropped_packets", "filter_dropped_packets", "scalar", scalar="u32", units=("1",)),
            Parameter("comm_port_bytes_written", "comm_port_bytes_written", "scalar", scalar="u32", units=("byte",)),
            Parameter("comm_port_bytes_read", "comm_port_bytes_read", "scalar", scalar="u32", units=("byte",)),
            Parameter("comm_port_write_overruns", "comm_port_write_overruns", "scalar", scalar="u32", units=("1",)),
            Parameter("comm_port_read_overruns", "comm_port_read_overruns", "scalar", scalar="u32", units=("1",)),
            Parameter("imu_parser_errors", "imu_parser_errors", "scalar", scalar="u32", units=("1",)),
            Parameter("imu_message_count", "imu_message_count", "scalar", scalar="u32", units=("1",)),
            Parameter("imu_last_message_time", "imu_last_message_time", "scalar", scalar="u32", units=("ms",)),
        )),
    "DeviceStatusDiagnosticGnssResponse": FieldInfo(
        "3dm.device_status_diagnostic_gnss_response", mip_3dm.DeviceStatusDiagnosticGnssResponse, devices=("3dm-gx5-35", "3dm-gx5-45"), likely=("3dm-gx4-45",), assumed=("3dm-cx5-45",), parameters=(
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
            Parameter("imu_dropped_packets", "imu_dropped_packets", "scalar", scalar="u32", units=("1",)),
            Parameter("gnss_dropped_packets", "gnss_dropped_packets", "scalar", scalar="u32", units=("1",)),
            Parameter("filter_dropped_packets", "filter_dropped_packets", "scalar", scalar="u32", units=("1",)),
            Parameter("comm_port_bytes_written", "comm_port_bytes_written", "scalar", scalar="u32", units=("byte",)),
            Parameter("comm_port_bytes_read", "comm_port_bytes_read", "scalar", scalar="u32", units=("byte",)),
            Parameter("comm_port_write_overruns", "comm_port_write_overruns", "scalar", scalar="u32", units=("1",)),
            Parameter("comm_port_read_overruns", "comm_port_read_overruns", "scalar", scalar="u32", units=("1",)),
            Parameter("imu_parser_errors", "imu_parser_errors", "scalar", scalar="u32", units=("1",)),
            Parameter("imu_message_count", "imu_message_count", "scalar", scalar="u32", units=("1",)),
            Parameter("imu_last_message_time", "imu_last_message_time", "scalar", scalar="u32", units=("ms",)),
            Parameter("gnss_parser_errors", "gnss_parser_errors", "scalar", scalar="u32", units=("1",)),
            Parameter("gnss_message_count", "gnss_message_count", "scalar", scalar="u32", units=("1",)),
            Parameter("gnss_last_message_time", "gnss_last_message_time", "scalar", scalar="u32", units=("ms",)),
        )),
    "DeviceStatusDiagnosticGq4_45Response": FieldInfo(
        "3dm.device_status_diagnostic_gq4_45_response", mip_3dm.DeviceStatusDiagnosticGq4_45Response, devices=("3dm-gq4-45",), parameters=(
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
            Parameter("imu_dropped_packets", "imu_dropped_packets", "scalar", scalar="u32", units=("1",)),
            Parameter("gnss_dropped_packets", "gnss_dropped_packets", "scalar", scalar="u32", units=("1",)),
            Parameter("filter_dropped_packets", "filter_dropped_packets", "scalar", scalar="u32", units=("1",)),
            Parameter("comm_port_bytes_written", "comm_port_bytes_written", "scalar", scalar="u32", units=("byte",)),
            Parameter("comm_port_bytes_read", "comm_port_bytes_read", "scalar", scalar="u32", units=("byte",)),
            Parameter("comm_port_write_overruns", "comm_port_write_overruns", "scalar", scalar="u32", units=("1",)),
            Parameter("comm_port_read_overruns", "comm_port_read_overruns", "scalar", scalar="u32", units=("1",)),
            Parameter("imu_parser_errors", "imu_parser_errors", "scalar", scalar="u32", units=("1",)),
            Parameter("imu_message_count", "imu_message_count", "scalar", scalar="u32", units=("1",)),
            Parameter("imu_last_message_time", "imu_last_message_time", "scalar", scalar="u32", units=("ms",)),
            Parameter("gnss_parser_errors", "gnss_parser_errors", "scalar", scalar="u32", units=("1",)),
            Parameter("gnss_message_count", "gnss_message_count", "scalar", scalar="u32", units=("1",)),
            Parameter("gnss_last_message_time", "gnss_last_message_time", "scalar", scalar="u32", units=("ms",)),
            Parameter("mag_init_failed", "mag_init_failed", "scalar", scalar="bool"),
            Parameter("pressure_init_failed", "pressure_init_failed", "scalar", scalar="bool"),
            Parameter("receiver_init_failed", "receiver_init_failed", "scalar", scalar="bool"),
        )),
    "DeviceStatusDiagnosticRq1_45Response": FieldInfo(
        "3dm.device_status_diagnostic_rq1_45_response", mip_3dm.DeviceStatusDiagnosticRq1_45Response, devices=("3dm-rq1-45-lt", "3dm-rq1-45-st"), parameters=(
            Parameter("model_number", "model_number", "scalar", scalar="u16"),
            Parameter("status_selector", "status_selector", "constant", scalar="u8", constant=2),
            Parameter("status_flags", "status_flags", "scalar", scalar="u32"),
            Parameter("system_state", "system_state", "scalar", scalar="u16"),
            Parameter("system_timer", "system_timer", "scalar", scalar="u32", units=("ms",)),
            Parameter("gnss_power_state", "gnss_power_state", "scalar", scalar="u8"),
            Parameter("cold_start_on_power_on", "cold_start_on_power_on", "scalar", scalar="u8"),
            Parameter("temperature", "temperature", "scalar", scalar="float", units=("degC",)),
            Parameter("temperature_last_time", "temperature_last_time", "scalar", scalar="u32", units=("ms",)),
            Parameter("pps_count", "pps_count", "scalar", scalar="u32", units=("1",)),
            Parameter("pps_last_time", "pps_last_time", "scalar", scalar="u32", units=("ms",)),
            Parameter("imu_stream_enabled", "imu_stream_enabled", "scalar", scalar="bool"),
            Parameter("gnss_stream_enabled", "gnss_stream_enabled", "scalar", scalar="bool"),
            Parameter("filter_stream_enabled", "filter_stream_enabled", "scalar", scalar="bool"),
            Parameter("imu_dropped_packets", "imu_dropped_packets", "scalar", scalar="u32", units=("1",)),
            Parameter("gnss_dropped_packets", "gnss_dropped_packets", "scalar", scalar="u32", units=("1",)),
            Parameter("filter_dropped_packets", "filter_dropped_packets", "scalar", scalar="u32", units=("1",)),
            Parameter("comm_port_bytes_written", "comm_port_bytes_written", "scalar", scalar="u32", units=("byte",)),
            Parameter("comm_port_bytes_read", "comm_port_bytes_read", "scalar", scalar="u32", units=("byte",)),
            Parameter("comm_port_write_overruns", "comm_port_write_overruns", "scalar", scalar="u32", units=("1",)),
            Parameter("comm_port_read_overruns", "comm_port_read_overruns", "scalar", scalar="u32", units=("1",)),
            Parameter("imu_parser_errors", "imu_parser_errors", "scalar", scalar="u32", units=("1",)),
            Parameter("imu_message_count", "imu_message_count", "scalar", scalar="u32", units=("1",)),
            Parameter("imu_last_message_time", "imu_last_message_time", "scalar", scalar="u32", units=("ms",)),
            Parameter("gnss_parser_errors", "gnss_parser_errors", "scalar", scalar="u32", units=("1",)),
            Parameter("gnss_message_count", "gnss_message_count", "scalar", scalar="u32", units=("1",)),
            Parameter("gnss_last_message_time", "gnss_last_message_time", "scalar", scalar="u32", units=("ms",)),
        )),
    "DeviceStatusDiagnosticGx4Response": FieldInfo(
        "3dm.device_status_diagnostic_gx4_response", mip_3dm.DeviceStatusDiagnosticGx4Response, likely=("3dm-gx4-15", "3dm-gx4-25"), parameters=(
            Parameter("model_number", "model_number", "scalar", scalar="u16"),
            Parameter("status_selector", "status_selector", "constant", scalar="u8", constant=2),
            Parameter("status_flags", "status_flags", "scalar", scalar="u32"),
            Parameter("system_timer", "system_timer", "scalar", scalar="u32", units=("ms",)),
            Parameter("pps_count", "pps_count", "scalar", scalar="u32", units=("1",)),
            Parameter("pps_last_time", "pps_last_time", "scalar", scalar="u32", units=("ms",)),
            Parameter("imu_stream_enabled", "imu_stream_enabled", "scalar", scalar="bool"),
            Parameter("filter_stream_enabled", "filter_stream_enabled", "scalar", scalar="bool"),
            Parameter("imu_dropped_packets", "imu_dropped_packets", "scalar", scalar="u32", units=("1",)),
            Parameter("filter_dropped_packets", "filter_dropped_packets", "scalar", scalar="u32", units=("1",)),
            Parameter("comm_port_bytes_written", "comm_port_bytes_written", "scalar", scalar="u32", units=("byte",)),
            Parameter("comm_port_bytes_read", "comm_port_bytes_read", "scalar", scalar="u32", units=("byte",)),
            Parameter("comm_port_write_overruns", "comm_port_write_overruns", "scalar", scalar="u32", units=("1",)),
            Parameter("comm_port_read_overruns", "comm_port_read_overruns", "scalar", scalar="u32", units=("1",)),
            Parameter("usb_bytes_written", "usb_bytes_written", "scalar", scalar="u32", units=("byte",)),
            Parameter("usb_bytes_read", "usb_bytes_read", "scalar", scalar="u32", units=("byte",)),
            Parameter("usb_write_overruns", "usb_write_overruns", "scalar", scalar="u32", units=("1",)),
            Parameter("usb_read_overruns", "usb_read_overruns", "scalar", scalar="u32", units=("1",)),
            Parameter("imu_parser_errors", "imu_parser_errors", "scalar", scalar="u32", units=("1",)),
            Parameter("imu_message_count", "imu_message_count", "scalar", scalar="u32", units=("1",)),
            Parameter("imu_last_message_time", "imu_last_message_time", "scalar", scalar="u32", units=("ms",)),
        )),
    "DeviceStatusDiagnosticImuResponse": FieldInfo(
        "3dm.device_status_diagnostic_imu_response", mip_3dm.DeviceStatusDiagnosticImuResponse, assumed=("3dm-cv5-10", "3dm-cx5-10"), parameters=(
            Parameter("model_number", "model_number", "scalar", scalar="u16"),
            Parameter("status_selector", "status_selector", "constant", scalar="u8", constant=2),
            Parameter("status_flags", "status_flags", "scalar", scalar="u32"),
            Parameter("system_timer", "system_timer", "scalar", scalar="u32", units=("ms",)),
            Parameter("has_mag", "has_mag", "scalar", scalar="bool"),
            Parameter("has_pressure", "has_pressure", "scalar", scalar="bool"),
            Parameter("power_state", "power_state", "scalar", scalar="u8"),
            Parameter("gyro_range", "gyro_range", "scalar", scalar="u16"),
            Parameter("accel_range", "accel_range", "scalar", scalar="u16"),
            Parameter("reserved", "reserved", "scalar", scalar="u32", reserved=True, default=0),
            Parameter("temperature", "temperature", "scalar", scalar="float", units=("degC",)),
            Parameter("temperature_last_time", "temperature_last_time", "scalar", scalar="u32", units=("ms",)),
            Parameter("temperature_error", "temperature_error", "scalar", scalar="u8"),
            Parameter("pps_count", "pps_count", "scalar", scalar="u32", units=("1",)),
            Parameter("pps_last_time", "pps_last_time", "scalar", scalar="u32", units=("ms",)),
            Parameter("imu_stream_enabled", "imu_stream_enabled", "scalar", scalar="bool"),
            Parameter("imu_dropped_packets", "imu_dropped_packets", "scalar", scalar="u32", units=("1",)),
            Parameter("comm_port_bytes_written", "comm_port_bytes_written", "scalar", scalar="u32", units=("byte",)),
            Parameter("comm_port_bytes_read", "comm_port_bytes_read", "scalar", scalar="u32", units=("byte",)),
            Parameter("comm_port_write_overruns", "comm_port_write_overruns", "scalar", scalar="u32", units=("1",)),
            Parameter("comm_port_read_overruns", "comm_port_read_overruns", "scalar", scalar="u32", units=("1",)),
        )),
    "DeviceStatusDiagnosticGx4ImuResponse": FieldInfo(
        "3dm.device_status_diagnostic_gx4_imu_response", mip_3dm.DeviceStatusDiagnosticGx4ImuResponse, likely=("3dm-gx4-imu",), parameters=(
            Parameter("model_number", "model_number", "scalar", scalar="u16"),
            Parameter("status_selector", "status_selector", "constant", scalar="u8", constant=2),
            Parameter("status_flags", "status_flags", "scalar", scalar="u32"),
            Parameter("system_timer", "system_timer", "scalar", scalar="u32", units=("ms",)),
            Parameter("has_mag", "has_mag", "scalar", scalar="bool"),
            Parameter("has_pressure", "has_pressure", "scalar", scalar="bool"),
            Parameter("gyro_range", "gyro_range", "scalar", scalar="u16"),
            Parameter("accel_range", "accel_range", "scalar", scalar="u8"),
            Parameter("mag_range", "mag_range", "scalar", scalar="float"),
            Parameter("pressure_range", "pressure_range", "scalar", scalar="float"),
            Parameter("temperature", "temperature", "scalar", scalar="float", units=("degC",)),
            Parameter("temperature_last_time", "temperature_last_time", "scalar", scalar="u32", units=("ms",)),
            Parameter("temperature_error", "temperature_error", "scalar", scalar="u8"),
            Parameter("pps_count", "pps_count", "scalar", scalar="u32", units=("1",)),
            Parameter("pps_last_time", "pps_last_time", "scalar", scalar="u32", units=("ms",)),
            Parameter("imu_stream_enabled", "imu_stream_enabled", "scalar", scalar="bool"),
            Parameter("imu_dropped_packets", "imu_dropped_packets", "scalar", scalar="u32", units=("1",)),
            Parameter("comm_port_bytes_written", "comm_port_bytes_written", "scalar", scalar="u32", units=("byte",)),
            Parameter("comm_port_bytes_read", "comm_port_bytes_read", "scalar", scalar="u32", units=("byte",)),
            Parameter("comm_port_write_overruns", "comm_port_write_overruns", "scalar", scalar="u32", units=("1",)),
            Parameter("comm_port_read_overruns", "comm_port_read_overruns", "scalar", scalar="u32", units=("1",)),
        )),
    "DeviceStatusDiagnosticRq1ImuResponse": FieldInfo(
        "3dm.device_status_diagnostic_rq1_imu_response", mip_3dm.DeviceStatusDiagnosticRq1ImuResponse, likely=("3dm-rq1-imu",), parameters=(
            Parameter("model_number", "model_number", "scalar", scalar="u16"),
            Parameter("status_selector", "status_selector", "constant", scalar="u8", constant=2),
            Parameter("status_flags", "status_flags", "scalar", scalar="u32"),
            Parameter("system_timer", "system_timer", "scalar", scalar="u64", units=("us",)),
            Parameter("temperature", "temperature", "scalar", scalar="float", units=("degC",)),
            Parameter("temperature_last_time", "temperature_last_time", "scalar", scalar="u32", units=("ms",)),
            Parameter("bad_temperature_sensor_detected", "bad_temperature_sensor_detected", "scalar", scalar="bool"),
            Parameter("cold_temperature_detected", "cold_temperature_detected", "scalar", scalar="bool"),
            Parameter("bad_voltage_detected", "bad_voltage_detected", "scalar", scalar="bool"),
            Parameter("pps_count", "pps_count", "scalar", scalar="u32", units=("1",)),
            Parameter("pps_last_time", "pps_last_time", "scalar", scalar="u32", units=("ms",)),
            Parameter("imu_stream_enabled", "imu_stream_enabled", "scalar", scalar="bool"),
            Parameter("imu_dropped_packets", "imu_dropped_packets", "scalar", scalar="u32", units=("1",)),
            Parameter("comm_port_state", "comm_port_state", "scalar", scalar="u16"),
            Parameter("comm_port_baud_rate", "comm_port_baud_rate", "scalar", scalar="u32", units=("Bd",)),
            Parameter("comm_port_bytes_written", "comm_port_bytes_written", "scalar", scalar="u32", units=("byte",)),
            Parameter("comm_port_bytes_read", "comm_port_bytes_read", "scalar", scalar="u32", units=("byte",)),
            Parameter("comm_port_write_overruns", "comm_port_write_overruns", "scalar", scalar="u32", units=("1",)),
            Parameter("comm_port_read_overruns", "comm_port_read_overruns", "scalar", scalar="u32", units=("1",)),
        )),
    "DeviceStatusBasicGx3Response": FieldInfo(
        "3dm.device_status_basic_gx3_response", mip_3dm.DeviceStatusBasicGx3Response, likely=("3dm-gx3-35",), assumed=("3dm-gx3-45",), parameters=(
            Parameter("model_number", "model_number", "scalar", scalar="u16"),
            Parameter("status_selector", "status_selector", "constant", scalar="u8", constant=1),
            Parameter("comm_mode", "comm_mode", "scalar", scalar="u8"),
            Parameter("comm_device", "comm_device", "scalar", scalar="u8"),
            Parameter("settings_flags", "settings_flags", "scalar", scalar="u32"),
            Parameter("comm_state", "comm_state", "scalar", scalar="u16"),
            Parameter("comm_baud_rate", "comm_baud_rate", "scalar", scalar="u32", units=("Bd",)),
        )),
    "DeviceStatusDiagnosticGx3Response": FieldInfo(
        "3dm.device_status_diagnostic_gx3_response", mip_3dm.DeviceStatusDiagnosticGx3Response, likely=("3dm-gx3-35",), assumed=("3dm-gx3-45",), parameters=(
            Parameter("model_number", "model_number", "scalar", scalar="u16"),
            Parameter("status_selector", "status_selector", "constant", scalar="u8", constant=2),
            Parameter("comm_mode", "comm_mode", "scalar", scalar="u8"),
            Parameter("comm_device", "comm_device", "scalar", scalar="u8"),
            Parameter("settings_flags", "settings_flags", "scalar", scalar="u32"),
            Parameter("comm_state", "comm_state", "scalar", scalar="u16"),
            Parameter("comm_baud_rate", "comm_baud_rate", "scalar", scalar="u32", units=("Bd",)),
            Parameter("comm_port_bytes_written", "comm_port_bytes_written", "scalar", scalar="u32", units=("byte",)),
            Parameter("comm_port_bytes_read", "comm_port_bytes_read", "scalar", scalar="u32", units=("byte",)),
            Parameter("comm_port_write_overruns", "comm_port_write_overruns", "scalar", scalar="u32", units=("1",)),
            Parameter("comm_port_read_overruns", "comm_port_read_overruns", "scalar", scalar="u32", units=("1",)),
            Parameter("usb_state", "usb_state", "scalar", scalar="u16"),
            Parameter("usb_bytes_written", "usb_bytes_written", "scalar", scalar="u32", units=("byte",)),
            Parameter("usb_bytes_read", "usb_bytes_read", "scalar", scalar="u32", units=("byte",)),
            Parameter("usb_write_overruns", "usb_write_overruns", "scalar", scalar="u32", units=("1",)),
            Parameter("usb_read_overruns", "usb_read_overruns", "scalar", scalar="u32", units=("1",)),
            Parameter("gnss_driver_state", "gnss_driver_state", "scalar", scalar="u16"),
            Parameter("gnss_port_state", "gnss_port_state", "scalar", scalar="u16"),
            Parameter("gnss_bytes_written", "gnss_bytes_written", "scalar", scalar="u32", units=("byte",)),
            Parameter("gnss_bytes_read", "gnss_bytes_read", "scalar", scalar="u32", units=("byte",)),
            Parameter("gnss_write_overruns", "gnss_write_overruns", "scalar", scalar="u32", units=("1",)),
            Parameter("gnss_read_overruns", "gnss_read_overruns", "scalar", scalar="u32", units=("1",)),
            Parameter("gnss_message_count", "gnss_message_count", "scalar", scalar="u32", units=("1",)),
            Parameter("gnss_delayed_message_count", "gnss_delayed_message_count", "scalar", scalar="u32", units=("1",)),
            Parameter("imu_driver_state", "imu_driver_state", "scalar", scalar="u16"),
            Parameter("imu_port_state", "imu_port_state", "scalar", scalar="u16"),
            Parameter("imu_bytes_written", "imu_bytes_written", "scalar", scalar="u32", units=("byte",)),
            Parameter("imu_bytes_read", "imu_bytes_read", "scalar", scalar="u32", units=("byte",)),
            Parameter("imu_write_overruns", "imu_write_overruns", "scalar", scalar="u32", units=("1",)),
            Parameter("imu_read_overruns", "imu_read_overruns", "scalar", scalar="u32", units=("1",)),
            Parameter("imu_message_count", "imu_message_count", "scalar", scalar="u32", units=("1",)),
            Parameter("imu_delayed_message_count", "imu_delayed_message_count", "scalar", scalar="u32", units=("1",)),
        )),
    "GpsDynamicsModeResponse": FieldInfo(
        "3dm.gps_dynamics_mode_response", mip_3dm.GpsDynamicsModeResponse, likely=("3dm-gx3-35",), parameters=(
            Parameter("mode", "mode", "scalar", scalar="u8", type=mip_3dm.ReceiverDynamics),
        )),
    "ImuTimestampResponse": FieldInfo(
        "3dm.imu_timestamp_response", mip_3dm.ImuTimestampResponse, likely=("3dm-gx3-35",), assumed=("3dm-gx3-15", "3dm-gx3-25", "3dm-gx3-45"), parameters=(
            Parameter("selector", "selector", "scalar", scalar="u8", type=mip_3dm.ImuTimestampSelector),
            Parameter("time", "time", "scalar", scalar="u32"),
        )),
    "ComplementaryFilterResponse": FieldInfo(
        "3dm.complementary_filter_response", mip_3dm.ComplementaryFilterResponse, devices=("3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-35"), likely=("3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-gx5-45"), assumed=("3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("pitch_roll_enable", "pitch_roll_enable", "scalar", scalar="bool"),
            Parameter("heading_enable", "heading_enable", "scalar", scalar="bool"),
            Parameter("pitch_roll_time_constant", "pitch_roll_time_constant", "scalar", scalar="float", units=("s",), minimum=1, maximum=1000, default=10),
            Parameter("heading_time_constant", "heading_time_constant", "scalar", scalar="float", units=("s",), minimum=1, maximum=1000, default=10),
        )),
    "AccelBiasResponse": FieldInfo(
        "3dm.accel_bias_response", mip_3dm.AccelBiasResponse, devices=("3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-35", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-25", "3dm-gx5-45", "3dm-rq1-imu"), assumed=("3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("bias", "bias", "array", scalar="float", elements=("x", "y", "z"), units=("g",), frame="sensor"),
        )),
    "GyroBiasResponse": FieldInfo(
        "3dm.gyro_bias_response", mip_3dm.GyroBiasResponse, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gq7", "3dm-gx5-15", "3dm-gx5-35", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-25", "3dm-gx5-45", "3dm-rq1-imu"), assumed=("3dm-cv5-10", "3dm-cx5-10", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins"), parameters=(
            Parameter("bias", "bias", "array", scalar="float", elements=("x", "y", "z"), units=("rad/s",), frame="sensor"),
        )),
    "MagHardIronOffsetResponse": FieldInfo(
        "3dm.mag_hard_iron_offset_response", mip_3dm.MagHardIronOffsetResponse, devices=("3dm-cv7-ahrs", "3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-25"), assumed=("3dm-cv5-25", "3dm-cv7-ins", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ins", "3dm-gx5-35"), parameters=(
            Parameter("offset", "offset", "array", scalar="float", elements=("x", "y", "z"), units=("gauss",), frame="sensor"),
        )),
    "MagSoftIronMatrixResponse": FieldInfo(
        "3dm.mag_soft_iron_matrix_response", mip_3dm.MagSoftIronMatrixResponse, devices=("3dm-cv7-ahrs", "3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gx5-35", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-25", "3dm-gx5-45"), assumed=("3dm-cv5-25", "3dm-cv7-ins", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ins"), parameters=(
            Parameter("matrix", "matrix", "array", scalar="float", elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"), units=("1",), frame="sensor"),
        )),
    "ConingScullingEnableResponse": FieldInfo(
        "3dm.coning_sculling_enable_response", mip_3dm.ConingScullingEnableResponse, devices=("3dm-gq4-45", "3dm-gx5-15", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-gx4-imu", "3dm-gx5-25", "3dm-gx5-45", "3dm-rq1-imu"), assumed=("3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-35"), parameters=(
            Parameter("enable", "enable", "scalar", scalar="bool", default=True),
        )),
    "ConstellationSettingsResponse": FieldInfo(
        "3dm.constellation_settings_response", mip_3dm.ConstellationSettingsResponse, devices=("3dm-gq4-45", "3dm-gx5-35"), assumed=("3dm-cx5-45", "3dm-gx5-45"), parameters=(
            Parameter("max_channels_available", "max_channels_available", "scalar", scalar="u16", units=("1",)),
            Parameter("max_channels_use", "max_channels_use", "scalar", scalar="u16", units=("1",)),
            Parameter("config_count", "config_count", "counter", scalar="u8", counts="settings", maximum=41, minimum=0),
            Parameter("settings", "settings", "array", length="config_count", type=mip_3dm.ConstellationSettingsEntry),
        )),
    "GnssSbasSettingsResponse": FieldInfo(
        "3dm.gnss_sbas_settings_response", mip_3dm.GnssSbasSettingsResponse, devices=("3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gx5-35"), likely=("3dm-gq7",), assumed=("3dm-cx5-45", "3dm-gx5-45"), parameters=(
            Parameter("enable_sbas", "enable_sbas", "scalar", scalar="u8", maximum=1, minimum=0),
            Parameter("sbas_options", "sbas_options", "scalar", scalar="u16", type=mip_3dm.SbasOptions),
            Parameter("num_included_prns", "num_included_prns", "counter", scalar="u8", counts="included_prns"),
            Parameter("included_prns", "included_prns", "array", scalar="u16", length="num_included_prns"),
        )),
    "GnssAssistedFixResponse": FieldInfo(
        "3dm.gnss_assisted_fix_response", mip_3dm.GnssAssistedFixResponse, devices=("3dm-gx5-35",), assumed=("3dm-cx5-45", "3dm-gx5-45"), parameters=(
            Parameter("option", "option", "scalar", scalar="u8", default=0, type=mip_3dm.AssistedFixOption),
            Parameter("flags", "flags", "scalar", scalar="u8", default=255, reserved=True),
        )),
    "GnssTimeAssistanceResponse": FieldInfo(
        "3dm.gnss_time_assistance_response", mip_3dm.GnssTimeAssistanceResponse, devices=("3dm-gx5-35",), assumed=("3dm-cx5-45", "3dm-gx5-45"), parameters=(
            Parameter("tow", "tow", "scalar", scalar="double", units=("s",), below=604800, minimum=0),
            Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",)),
            Parameter("accuracy", "accuracy", "scalar", scalar="float", units=("s",), minimum=0),
        )),
    "PpsSourceControlResponse": FieldInfo(
        "3dm.pps_source_control_response", mip_3dm.PpsSourceControlResponse, devices=("3dm-cv7-gnss-ins",), likely=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("source", "source", "scalar", scalar="u8", type=mip_3dm.PpsSource),
        )),
    "SensorToVehicleTransformEulerResponse": FieldInfo(
        "3dm.sensor_to_vehicle_transform_euler_response", mip_3dm.SensorToVehicleTransformEulerResponse, devices=("3dm-cv7-gnss-ins", "3dm-gq7"), likely=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar"), assumed=("3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gv7-ins"), parameters=(
            Parameter("roll", "roll", "scalar", scalar="float", units=("rad",), frame="vehicle"),
            Parameter("pitch", "pitch", "scalar", scalar="float", units=("rad",), frame="vehicle"),
            Parameter("yaw", "yaw", "scalar", scalar="float", units=("rad",), frame="vehicle"),
        )),
    "SensorToVehicleTransformQuaternionResponse": FieldInfo(
        "3dm.sensor_to_vehicle_transform_quaternion_response", mip_3dm.SensorToVehicleTransformQuaternionResponse, devices=("3dm-cv7-gnss-ins",), assumed=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("q", "q", "array", scalar="float", elements=("w", "x", "y", "z"), units=("1",)),
        )),
    "SensorToVehicleTransformDcmResponse": FieldInfo(
        "3dm.sensor_to_vehicle_transform_dcm_response", mip_3dm.SensorToVehicleTransformDcmResponse, devices=("3dm-cv7-gnss-ins",), assumed=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("dcm", "dcm", "array", scalar="float", elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"), units=("1",)),
        )),
    "GetEventSupportResponse": FieldInfo(
        "3dm.get_event_support_response", mip_3dm.GetEventSupportResponse, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins"), assumed=("3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("query", "query", "scalar", scalar="u8", type=mip_3dm.EventSupportQuery),
            Parameter("max_instances", "max_instances", "scalar", scalar="u8", units=("1",)),
            Parameter("num_entries", "num_entries", "counter", scalar="u8", counts="entries"),
            Parameter("entries", "entries", "array", length="num_entries", type=mip_3dm.EventSupportInfo, variants=(Variant("query", (1,), {"type": types.EventTriggerType}, member="type"), Variant("query", (2,), {"type": types.EventActionType}, member="type"),)),
        )),
    "EventControlResponse": FieldInfo(
        "3dm.event_control_response", mip_3dm.EventControlResponse, devices=("3dm-cv7-gnss-ins",), likely=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-gv7-ahrs", "3dm-gv7-ar"), assumed=("3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ins"), parameters=(
            Parameter("instance", "instance", "scalar", scalar="u8"),
            Parameter("mode", "mode", "scalar", scalar="u8", default=0, type=types.EventTriggerMode),
        )),
    "GetEventTriggerStatusResponse": FieldInfo(
        "3dm.get_event_trigger_status_response", mip_3dm.GetEventTriggerStatusResponse, devices=("3dm-cv7-gnss-ins",), assumed=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("count", "count", "counter", scalar="u8", counts="triggers"),
            Parameter("triggers", "triggers", "array", length="count", type=mip_3dm.EventTriggerStatusEntry),
        )),
    "GetEventActionStatusResponse": FieldInfo(
        "3dm.get_event_action_status_response", mip_3dm.GetEventActionStatusResponse, devices=("3dm-cv7-gnss-ins",), assumed=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("count", "count", "counter", scalar="u8", counts="actions"),
            Parameter("actions", "actions", "array", length="count", type=mip_3dm.EventActionStatusEntry),
        )),
    "EventTriggerConfigResponse": FieldInfo(
        "3dm.event_trigger_config_response", mip_3dm.EventTriggerConfigResponse, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins"), likely=("3dm-gv7-ahrs", "3dm-gv7-ar"), assumed=("3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ins"), parameters=(
            Parameter("instance", "instance", "scalar", scalar="u8"),
            Parameter("type", "type", "scalar", scalar="u8", default=0, type=types.EventTriggerType),
            Parameter("parameters", "parameters", "switch", tag="type", cases={0: None, 1: Parameter("gpio", "gpio", "struct", type=types.EventTriggerGpio), 2: Parameter("threshold", "threshold", "struct", type=types.EventTriggerThreshold), 3: Parameter("combination", "combination", "struct", type=types.EventTriggerCombination), }),
        )),
    "EventActionConfigResponse": FieldInfo(
        "3dm.event_action_config_response", mip_3dm.EventActionConfigResponse, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins"), likely=("3dm-gv7-ahrs", "3dm-gv7-ar"), assumed=("3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ins"), parameters=(
            Parameter("instance", "instance", "scalar", scalar="u8"),
            Parameter("trigger", "trigger", "scalar", scalar="u8"),
            Parameter("type", "type", "scalar", scalar="u8", default=0, type=types.EventActionType),
            Parameter("parameters", "parameters", "switch", tag="type", cases={0: None, 1: Parameter("gpio", "gpio", "struct", type=types.EventActionGpio), 2: Parameter("message", "message", "struct", type=types.EventActionMessage), }),
        )),
    "GpioConfigResponse": FieldInfo(
        "3dm.gpio_config_response", mip_3dm.GpioConfigResponse, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins"), likely=("3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("pin", "pin", "scalar", scalar="u8"),
            Parameter("feature", "feature", "scalar", scalar="u8", default=0, type=types.GpioFeature),
            Parameter("behavior", "behavior", "scalar", scalar="u8", variants=(Variant("feature", (0,), {"type": types.GpioUnusedBehavior}), Variant("feature", (1,), {"type": types.GpioBehavior}), Variant("feature", (2,), {"type": types.GpioPpsBehavior}), Variant("feature", (3,), {"type": types.GpioEncoderBehavior}), Variant("feature", (4,), {"type": types.GpioTimestampBehavior}), Variant("feature", (5,), {"type": types.GpioUartBehavior}),)),
            Parameter("pin_mode", "pin_mode", "scalar", scalar="u8", type=types.GpioPinMode),
        )),
    "GpioStateResponse": FieldInfo(
        "3dm.gpio_state_response", mip_3dm.GpioStateResponse, devices=("3dm-cv7-gnss-ins", "3dm-gq7"), likely=("3dm-cv7-ins", "3dm-gv7-ins"), assumed=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar"), parameters=(
            Parameter("pin", "pin", "scalar", scalar="u8", minimum=1),
            Parameter("state", "state", "scalar", scalar="bool"),
        )),
    "OdometerConfigResponse": FieldInfo(
        "3dm.odometer_config_response", mip_3dm.OdometerConfigResponse, devices=("3dm-cv7-gnss-ins",), likely=("3dm-gq7",), parameters=(
            Parameter("mode", "mode", "scalar", scalar="u8", type=mip_3dm.OdometerMode),
            Parameter("scaling", "scaling", "scalar", scalar="float", units=("pulse/m",)),
            Parameter("uncertainty", "uncertainty", "scalar", scalar="float", units=("1",), minimum=0),
        )),
    "SensorRangeResponse": FieldInfo(
        "3dm.sensor_range_response", mip_3dm.SensorRangeResponse, devices=("3dm-cv7-gnss-ins",), likely=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins"), assumed=("3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("sensor", "sensor", "scalar", scalar="u8", type=mip_3dm.SensorRangeType),
            Parameter("setting", "setting", "scalar", scalar="u8"),
        )),
    "GetCalibratedSensorRangesResponse": FieldInfo(
        "3dm.get_calibrated_sensor_ranges_response", mip_3dm.GetCalibratedSensorRangesResponse, devices=("3dm-cv7-gnss-ins",), assumed=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("sensor", "sensor", "scalar", scalar="u8", type=mip_3dm.SensorRangeType),
            Parameter("num_ranges", "num_ranges", "counter", scalar="u8", counts="ranges"),
            Parameter("ranges", "ranges", "array", length="num_ranges", type=mip_3dm.SensorRangeEntry, variants=(Variant("sensor", (1,), {"units": ("g",)}, member="range"), Variant("sensor", (2,), {"units": ("deg/s",)}, member="range"), Variant("sensor", (3,), {"units": ("gauss",)}, member="range"), Variant("sensor", (4,), {"units": ("mbar",)}, member="range"),)),
        )),
    "LowPassFilterResponse": FieldInfo(
        "3dm.low_pass_filter_response", mip_3dm.LowPassFilterResponse, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gq7"), assumed=("3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("descriptor_set", "descriptor_set", "scalar", scalar="u8", refers="set"),
            Parameter("field_descriptor", "field_descriptor", "scalar", scalar="u8", refers="field", fields_of="descriptor_set"),
            Parameter("enable", "enable", "scalar", scalar="bool"),
            Parameter("manual", "manual", "scalar", scalar="bool"),
            Parameter("frequency", "frequency", "scalar", scalar="float", units=("Hz",), minimum=0),
        )),
}
