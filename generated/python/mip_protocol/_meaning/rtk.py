"""The meaning of the types of `rtk`."""

from __future__ import annotations

from .. import protocol, rtk, types
from ..info import BitsInfo, EnumInfo, FieldInfo, Info
from ..parameter import Flag, Parameter

# fmt: off

#: Class -> its description.
TYPES: dict[str, Info] = {
    "ConnectedDevice": EnumInfo("rtk.connected_device", rtk.ConnectedDevice),
    "ServiceFlags": BitsInfo("rtk.service_flags", rtk.ServiceFlags),
    "StorageMedium": EnumInfo("rtk.storage_medium", rtk.StorageMedium),
    "LedAction": EnumInfo("rtk.led_action", rtk.LedAction),
    "GetStatusFlags": FieldInfo(
        "rtk.get_status_flags", rtk.GetStatusFlags, likely=("3dm-rtk",), parameters=(
        )),
    "GetImei": FieldInfo(
        "rtk.get_imei", rtk.GetImei, parameters=(
        )),
    "GetImsi": FieldInfo(
        "rtk.get_imsi", rtk.GetImsi, parameters=(
        )),
    "GetIccid": FieldInfo(
        "rtk.get_iccid", rtk.GetIccid, parameters=(
        )),
    "GetRssi": FieldInfo(
        "rtk.get_rssi", rtk.GetRssi, parameters=(
        )),
    "ConnectedDeviceType": FieldInfo(
        "rtk.connected_device_type", rtk.ConnectedDeviceType, functions=("write", "read", "save", "load", "default"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("device_type", "device_type", "scalar", scalar="u8", required=("write",), type=rtk.ConnectedDevice),
        )),
    "GetActivationCode": FieldInfo(
        "rtk.get_activation_code", rtk.GetActivationCode, likely=("3dm-rtk",), parameters=(
        )),
    "GetModemFirmwareVersion": FieldInfo(
        "rtk.get_modem_firmware_version", rtk.GetModemFirmwareVersion, parameters=(
        )),
    "ServiceStatus": FieldInfo(
        "rtk.service_status", rtk.ServiceStatus, parameters=(
            Parameter("reserved1", "reserved1", "scalar", scalar="u32", reserved=True, default=0),
            Parameter("reserved2", "reserved2", "scalar", scalar="u32", reserved=True, default=0),
        )),
    "EraseStorage": FieldInfo(
        "rtk.erase_storage", rtk.EraseStorage, advanced=True, parameters=(
            Parameter("media", "media", "scalar", scalar="u8", type=rtk.StorageMedium),
        )),
    "LedControl": FieldInfo(
        "rtk.led_control", rtk.LedControl, advanced=True, parameters=(
            Parameter("primary_color", "primary_color", "array", scalar="u8", length=3),
            Parameter("alternate_color", "alternate_color", "array", scalar="u8", length=3),
            Parameter("action", "action", "scalar", scalar="u8", type=rtk.LedAction),
            Parameter("period", "period", "scalar", scalar="u32"),
        )),
    "ModemHardReset": FieldInfo(
        "rtk.modem_hard_reset", rtk.ModemHardReset, advanced=True, parameters=(
        )),
    "GetStatusFlagsResponse": FieldInfo(
        "rtk.get_status_flags_response", rtk.GetStatusFlagsResponse, likely=("3dm-rtk",), parameters=(
            Parameter("flags", "flags", "scalar", scalar="u32", type=types.RtkStatusFlags),
        )),
    "GetImeiResponse": FieldInfo(
        "rtk.get_imei_response", rtk.GetImeiResponse, parameters=(
            Parameter("imei", "imei", "text", scalar="char", length=32),
        )),
    "GetImsiResponse": FieldInfo(
        "rtk.get_imsi_response", rtk.GetImsiResponse, parameters=(
            Parameter("imsi", "imsi", "text", scalar="char", length=32),
        )),
    "GetIccidResponse": FieldInfo(
        "rtk.get_iccid_response", rtk.GetIccidResponse, parameters=(
            Parameter("iccid", "iccid", "text", scalar="char", length=32),
        )),
    "GetRssiResponse": FieldInfo(
        "rtk.get_rssi_response", rtk.GetRssiResponse, parameters=(
            Parameter("valid", "valid", "scalar", scalar="bool"),
            Parameter("rssi", "rssi", "scalar", scalar="s32", valid=("valid",), flags=(Flag("valid", "valid", 0x0),)),
            Parameter("signal_quality", "signal_quality", "scalar", scalar="s32", valid=("valid",), flags=(Flag("valid", "valid", 0x0),)),
        )),
    "ConnectedDeviceTypeResponse": FieldInfo(
        "rtk.connected_device_type_response", rtk.ConnectedDeviceTypeResponse, parameters=(
            Parameter("device_type", "device_type", "scalar", scalar="u8", type=rtk.ConnectedDevice),
        )),
    "GetActivationCodeResponse": FieldInfo(
        "rtk.get_activation_code_response", rtk.GetActivationCodeResponse, likely=("3dm-rtk",), parameters=(
            Parameter("activation_code", "activation_code", "text", scalar="char", length=32),
        )),
    "GetModemFirmwareVersionResponse": FieldInfo(
        "rtk.get_modem_firmware_version_response", rtk.GetModemFirmwareVersionResponse, parameters=(
            Parameter("modem_firmware_version", "modem_firmware_version", "text", scalar="char", length=32),
        )),
    "ServiceStatusResponse": FieldInfo(
        "rtk.service_status_response", rtk.ServiceStatusResponse, parameters=(
            Parameter("flags", "flags", "scalar", scalar="u8", type=rtk.ServiceFlags),
            Parameter("received_bytes", "received_bytes", "scalar", scalar="u32", units=("byte",)),
            Parameter("last_bytes", "last_bytes", "scalar", scalar="u32", units=("byte",)),
            Parameter("last_bytes_time", "last_bytes_time", "scalar", scalar="u64"),
        )),
}
