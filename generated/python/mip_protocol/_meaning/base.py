"""The meaning of the types of `base`."""

from __future__ import annotations

from .. import base, protocol, types
from ..info import EnumInfo, FieldInfo, Info, StructureInfo
from ..parameter import Parameter, Variant

# fmt: off

#: Class -> its description.
TYPES: dict[str, Info] = {
    "BaseDeviceInfo": StructureInfo("base.base_device_info", base.BaseDeviceInfo, (
            Parameter("firmware_version", "firmware_version", "scalar", scalar="u16"),
            Parameter("model_name", "model_name", "text", scalar="char", length=16),
            Parameter("model_number", "model_number", "text", scalar="char", length=16),
            Parameter("serial_number", "serial_number", "text", scalar="char", length=16),
            Parameter("lot_number", "lot_number", "text", scalar="char", length=16),
            Parameter("device_options", "device_options", "text", scalar="char", length=16),
        )),
    "GpsTimeField": EnumInfo("base.gps_time_field", base.GpsTimeField),
    "Ping": FieldInfo(
        "base.ping", base.Ping, devices=("3dm-cv5-10", "3dm-cv5-15", "3dm-cv7-gnss-ins", "3dm-cx5-10", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-35", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-dh3", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-25", "3dm-gx5-45", "3dm-mv5-ar", "3dm-rq1-imu", "3dm-rtk", "demod-dc"), assumed=("3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gx3-15", "3dm-gx3-25"), parameters=(
        )),
    "SetIdle": FieldInfo(
        "base.set_idle", base.SetIdle, devices=("3dm-cv5-10", "3dm-cv5-15", "3dm-cv7-gnss-ins", "3dm-cx5-10", "3dm-gq4-45", "3dm-gx5-15", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-dh3", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-25", "3dm-gx5-45", "3dm-mv5-ar", "3dm-rq1-imu", "3dm-rtk", "demod-dc"), assumed=("3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gx3-15", "3dm-gx3-25", "3dm-gx5-35"), parameters=(
        )),
    "GetDeviceInfo": FieldInfo(
        "base.get_device_info", base.GetDeviceInfo, devices=("3dm-cv5-10", "3dm-cv5-15", "3dm-cv7-gnss-ins", "3dm-cx5-10", "3dm-gq4-45", "3dm-gq7", "3dm-gx5-15", "3dm-gx5-35", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-dh3", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-25", "3dm-mv5-ar", "3dm-rq1-imu", "3dm-rtk", "demod-dc"), assumed=("3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gx3-15", "3dm-gx3-25"), parameters=(
        )),
    "GetDeviceDescriptors": FieldInfo(
        "base.get_device_descriptors", base.GetDeviceDescriptors, devices=("3dm-cv5-10", "3dm-cv5-15", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-cx5-10", "3dm-gq4-45", "3dm-gq7", "3dm-gx5-15", "3dm-gx5-35", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cv7-ins", "3dm-dh3", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-mv5-ar", "3dm-rq1-imu", "3dm-rtk", "demod-dc"), assumed=("3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx3-15", "3dm-gx3-25", "3dm-gx5-25", "3dm-gx5-45"), parameters=(
        )),
    "BuiltInTest": FieldInfo(
        "base.built_in_test", base.BuiltInTest, devices=("3dm-cv5-10", "3dm-cv5-15", "3dm-cv7-gnss-ins", "3dm-cx5-10", "3dm-gq4-45", "3dm-gx5-15", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cv7-ahrs", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-rq1-imu", "3dm-rtk"), assumed=("3dm-cv5-25", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx3-15", "3dm-gx3-25", "3dm-gx5-25", "3dm-gx5-35", "3dm-gx5-45"), parameters=(
        )),
    "Resume": FieldInfo(
        "base.resume", base.Resume, devices=("3dm-cv5-10", "3dm-cv5-15", "3dm-cv7-gnss-ins", "3dm-cx5-10", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-dh3", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx3-35", "3dm-gx4-25", "3dm-gx5-25", "3dm-mv5-ar", "3dm-rtk", "demod-dc"), assumed=("3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gx3-15", "3dm-gx3-25", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-35", "3dm-rq1-imu"), parameters=(
        )),
    "GetExtendedDescriptors": FieldInfo(
        "base.get_extended_descriptors", base.GetExtendedDescriptors, devices=("3dm-cv5-15", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gq7", "3dm-gx5-15", "3dm-gx5-35", "3dm-gx5-45"), likely=("3dm-cv7-ins",), assumed=("3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx5-25"), parameters=(
        )),
    "ContinuousBuiltInTest": FieldInfo(
        "base.continuous_built_in_test", base.ContinuousBuiltInTest, devices=("3dm-cv7-ar", "3dm-cv7-gnss-ins"), assumed=("3dm-cv7-ahrs", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
        )),
    "CommSpeed": FieldInfo(
        "base.comm_speed", base.CommSpeed, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gq7"), likely=("3dm-cv7-ins", "3dm-gv7-ins", "3dm-rtk"), assumed=("3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("port", "port", "scalar", scalar="u8", required=("write", "read", "save", "load", "default"), variants=(Variant("device", ("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-gv7-ahrs", "3dm-gv7-ar"), {"only": ("main", "uart_1", "usb_1"), "type": types.CommInterface}), Variant("device", ("3dm-cv7-gnss-ins",), {"type": types.CommInterface}), Variant("device", ("3dm-cv7-ins", "3dm-cx7-ins"), {"only": ("main", "uart_1", "uart_2", "uart_3", "usb_1"), "type": types.CommInterface}), Variant("device", ("3dm-gq7",), {}), Variant("device", ("3dm-gv7-ins",), {"only": ("main", "uart_1", "uart_2", "usb_1"), "type": types.CommInterface}), Variant("device", ("3dm-rtk",), {"type": None}),)),
            Parameter("baud", "baud", "scalar", scalar="u32", units=("Bd",), required=("write",)),
        )),
    "GpsTimeUpdate": FieldInfo(
        "base.gps_time_update", base.GpsTimeUpdate, functions=("write", "read", "apply"), devices=("3dm-cv5-10", "3dm-cv5-15", "3dm-cv7-gnss-ins", "3dm-cx5-10", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-35"), assumed=("3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx5-25", "3dm-gx5-45"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("field_id", "field_id", "scalar", scalar="u8", required=("write", "read", "apply"), type=base.GpsTimeField),
            Parameter("value", "value", "scalar", scalar="u32", required=("write", "apply"), variants=(Variant("field_id", (1,), {"units": ("week",)}), Variant("field_id", (2,), {"units": ("s",)}),)),
        )),
    "SoftReset": FieldInfo(
        "base.soft_reset", base.SoftReset, devices=("3dm-cv5-10", "3dm-cv5-15", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-cx5-10", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-rtk",), assumed=("3dm-cv5-25", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-gx5-35"), parameters=(
        )),
    "GetDeviceInfoResponse": FieldInfo(
        "base.get_device_info_response", base.GetDeviceInfoResponse, devices=("3dm-cv5-10", "3dm-cv5-15", "3dm-cv7-gnss-ins", "3dm-cx5-10", "3dm-gq4-45", "3dm-gq7", "3dm-gx5-15", "3dm-gx5-35", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-dh3", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-25", "3dm-mv5-ar", "3dm-rq1-imu", "3dm-rtk", "demod-dc"), assumed=("3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gx3-15", "3dm-gx3-25"), parameters=(
            Parameter("device_info", "device_info", "struct", type=base.BaseDeviceInfo),
        )),
    "GetDeviceDescriptorsResponse": FieldInfo(
        "base.get_device_descriptors_response", base.GetDeviceDescriptorsResponse, devices=("3dm-cv5-10", "3dm-cv5-15", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-cx5-10", "3dm-gq4-45", "3dm-gq7", "3dm-gx5-15", "3dm-gx5-35", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cv7-ins", "3dm-dh3", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-mv5-ar", "3dm-rq1-imu", "3dm-rtk", "demod-dc"), assumed=("3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx3-15", "3dm-gx3-25", "3dm-gx5-25", "3dm-gx5-45"), parameters=(
            Parameter("descriptors", "descriptors", "array", scalar="u16", length="rest"),
        )),
    "BuiltInTestResponse": FieldInfo(
        "base.built_in_test_response", base.BuiltInTestResponse, devices=("3dm-cv5-10", "3dm-cv5-15", "3dm-cv7-gnss-ins", "3dm-cx5-10", "3dm-gq4-45", "3dm-gx5-15", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cv7-ahrs", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-rq1-imu", "3dm-rtk"), assumed=("3dm-cv5-25", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx3-15", "3dm-gx3-25", "3dm-gx5-25", "3dm-gx5-35", "3dm-gx5-45"), parameters=(
            Parameter("result", "result", "scalar", scalar="u32", variants=(Variant("device", ("3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-gx5-25"), {"type": types.Gx5BuiltInTest}), Variant("device", ("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-rtk"), {"type": types.Cv7BuiltInTest}), Variant("device", ("3dm-cv7-gnss-ins",), {"type": types.Cv7BuiltInTest}), Variant("device", ("3dm-cx5-45", "3dm-gq4-45", "3dm-gx3-15", "3dm-gx3-25", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-35", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st", "3dm-rq1-imu"), {"type": None}), Variant("device", ("3dm-gx5-15",), {"type": types.Gx5BuiltInTest}),)),
        )),
    "GpsTimeUpdateWeekNumberResponse": FieldInfo(
        "base.gps_time_update_week_number_response", base.GpsTimeUpdateWeekNumberResponse, devices=("3dm-cv5-10", "3dm-cv5-15", "3dm-cx5-10", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-35"), assumed=("3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx5-25", "3dm-gx5-45"), parameters=(
            Parameter("week_number", "week_number", "scalar", scalar="u32", units=("week",)),
        )),
    "GpsTimeUpdateTowResponse": FieldInfo(
        "base.gps_time_update_tow_response", base.GpsTimeUpdateTowResponse, devices=("3dm-cv5-10", "3dm-cv5-15", "3dm-cx5-10", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-35"), assumed=("3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx5-25", "3dm-gx5-45"), parameters=(
            Parameter("tow", "tow", "scalar", scalar="u32", units=("s",)),
        )),
    "GetExtendedDescriptorsResponse": FieldInfo(
        "base.get_extended_descriptors_response", base.GetExtendedDescriptorsResponse, devices=("3dm-cv5-15", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gq7", "3dm-gx5-15", "3dm-gx5-35", "3dm-gx5-45"), likely=("3dm-cv7-ins",), assumed=("3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx5-25"), parameters=(
            Parameter("descriptors", "descriptors", "array", scalar="u16", length="rest"),
        )),
    "ContinuousBuiltInTestResponse": FieldInfo(
        "base.continuous_built_in_test_response", base.ContinuousBuiltInTestResponse, devices=("3dm-cv7-ar", "3dm-cv7-gnss-ins"), assumed=("3dm-cv7-ahrs", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("result", "result", "array", scalar="u8", length=16, variants=(Variant("device", ("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), {"type": types.Cv7InertialContinuousBuiltInTest}), Variant("device", ("3dm-cv7-gnss-ins",), {"type": types.Cv7ContinuousBuiltInTest}), Variant("device", ("3dm-gq7",), {"type": types.Gq7ContinuousBuiltInTest}),)),
        )),
    "CommSpeedResponse": FieldInfo(
        "base.comm_speed_response", base.CommSpeedResponse, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gq7"), likely=("3dm-cv7-ins", "3dm-gv7-ins", "3dm-rtk"), assumed=("3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar"), parameters=(
            Parameter("port", "port", "scalar", scalar="u8", variants=(Variant("device", ("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-gv7-ahrs", "3dm-gv7-ar"), {"only": ("main", "uart_1", "usb_1"), "type": types.CommInterface}), Variant("device", ("3dm-cv7-gnss-ins",), {"type": types.CommInterface}), Variant("device", ("3dm-cv7-ins", "3dm-cx7-ins"), {"only": ("main", "uart_1", "uart_2", "uart_3", "usb_1"), "type": types.CommInterface}), Variant("device", ("3dm-gq7",), {}), Variant("device", ("3dm-gv7-ins",), {"only": ("main", "uart_1", "uart_2", "usb_1"), "type": types.CommInterface}), Variant("device", ("3dm-rtk",), {"type": None}),)),
            Parameter("baud", "baud", "scalar", scalar="u32", units=("Bd",)),
        )),
}
