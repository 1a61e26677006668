"""What the types of `rtk` mean."""

from __future__ import annotations

from .. import protocol, rtk, types
from ..info import BitInfo, BitsInfo, EnumInfo, FieldInfo, Info, SetInfo, ValueInfo
from ..parameter import Flag, Parameter

# fmt: off
SET = SetInfo("rtk", number=0x0F, title="RTK commands", description="Commands of a corrections modem (RTK dongle), such as the 3DM-RTK.", facts=("Uncertain: The SDK describes hardly anything of this set; most descriptions follow from the names.", "Uncertain: How the strings are padded or ended."), sources=("mip-sdk-4: Rtk Commands (0x0F)",))

#: Class -> what is known of it.
TYPES: dict[str, Info] = {
    "ConnectedDevice": EnumInfo(
        "rtk.connected_device", type=rtk.ConnectedDevice, description="A device that a corrections modem serves.", sources=("mip-sdk-4: Connected Device Type (0x0F,0x06)",),
        values=(
            ValueInfo("generic", value=0, description="Any device."),
            ValueInfo("gq7", value=1, description="3DM-GQ7."),
        ),
    ),
    "ServiceFlags": BitsInfo(
        "rtk.service_flags", type=rtk.ServiceFlags, description="State of the correction service.", sources=("mip-sdk-4: Service Status (0x0F,0x0A)",),
        bits=(
            BitInfo("throttle", first=0, last=0, description="The server limits the rate."),
            BitInfo("corrections_unavailable", first=1, last=1, description="There are no corrections."),
        ),
    ),
    "StorageMedium": EnumInfo(
        "rtk.storage_medium", type=rtk.StorageMedium, description="A storage medium of a corrections modem.", sources=("mip-sdk-4: Prod Erase Storage (0x0F,0x20)",),
        values=(
            ValueInfo("external_flash", value=0, description="External flash memory."),
            ValueInfo("sd", value=1, description="SD card."),
        ),
    ),
    "LedAction": EnumInfo(
        "rtk.led_action", type=rtk.LedAction, description="Pattern of an LED.", sources=("mip-sdk-4: Led Control (0x0F,0x21)",),
        values=(
            ValueInfo("none", value=0, description="No pattern."),
            ValueInfo("flash", value=1, description="Flashing."),
            ValueInfo("pulsate", value=2, description="Pulsating."),
        ),
    ),
    "GetStatusFlags": FieldInfo(
        "rtk.get_status_flags", type=rtk.GetStatusFlags,
        title="Get status flags",
        description="Gets the state of the modem and of the corrections.",
        facts=("Answered by `rtk.GetStatusFlagsResponse`.", "Not listed in any device profile.", "Known only from the MicroStrain MIP SDK.", "The word of the response has two forms, `types.RtkStatusFlags` and `types.RtkStatusFlagsLegacy`."),
        sources=("mip-sdk-4: Get Status Flags (0x0F,0x01)",),
        parameters=(
        ),
    ),
    "GetImei": FieldInfo(
        "rtk.get_imei", type=rtk.GetImei,
        title="Get IMEI",
        description="Gets the identity of the modem.",
        facts=("Answered by `rtk.GetImeiResponse`.", "Not listed in any device profile.", "Known only from the MicroStrain MIP SDK."),
        sources=("mip-sdk-4: Get Imei (0x0F,0x02)",),
        parameters=(
        ),
    ),
    "GetImsi": FieldInfo(
        "rtk.get_imsi", type=rtk.GetImsi,
        title="Get IMSI",
        description="Gets the identity of the subscriber.",
        facts=("Answered by `rtk.GetImsiResponse`.", "Not listed in any device profile.", "Known only from the MicroStrain MIP SDK."),
        sources=("mip-sdk-4: Get Imsi (0x0F,0x03)",),
        parameters=(
        ),
    ),
    "GetIccid": FieldInfo(
        "rtk.get_iccid", type=rtk.GetIccid,
        title="Get ICCID",
        description="Gets the number of the SIM card.",
        facts=("Answered by `rtk.GetIccidResponse`.", "Not listed in any device profile.", "Known only from the MicroStrain MIP SDK."),
        sources=("mip-sdk-4: Get Iccid (0x0F,0x04)",),
        parameters=(
        ),
    ),
    "GetRssi": FieldInfo(
        "rtk.get_rssi", type=rtk.GetRssi,
        title="Get RSSI",
        description="Gets the strength of the cellular signal.",
        facts=("Answered by `rtk.GetRssiResponse`.", "Not listed in any device profile.", "Known only from the MicroStrain MIP SDK."),
        sources=("mip-sdk-4: Get Rssi (0x0F,0x05)",),
        parameters=(
        ),
    ),
    "ConnectedDeviceType": FieldInfo(
        "rtk.connected_device_type", type=rtk.ConnectedDeviceType,
        title="Connected device type",
        description="The device that the modem serves.",
        facts=("Functions: `write`, `read`, `save`, `load` and `default`.", "Answered by `rtk.ConnectedDeviceTypeResponse`.", "Not listed in any device profile.", "Known only from the MicroStrain MIP SDK."),
        sources=("mip-sdk-4: Connected Device Type (0x0F,0x06)",),
        functions=("write", "read", "save", "load", "default"),
        parameters=(
            Parameter("function", "function", "scalar", description="What to do with the setting.", scalar="u8", type=protocol.FunctionSelector),
            Parameter("device_type", "device_type", "scalar", description="Type of the device.", facts=("Required for `write`.",), scalar="u8", required=("write",), type=rtk.ConnectedDevice),
        ),
    ),
    "GetActivationCode": FieldInfo(
        "rtk.get_activation_code", type=rtk.GetActivationCode,
        title="Get activation code",
        description="Gets the activation code.",
        facts=("Also called `get_act_code`.", "Answered by `rtk.GetActivationCodeResponse`.", "Not listed in any device profile.", "Known only from the MicroStrain MIP SDK."),
        sources=("mip-sdk-4: Get Act Code (0x0F,0x07)",),
        also=("get_act_code",),
        parameters=(
        ),
    ),
    "GetModemFirmwareVersion": FieldInfo(
        "rtk.get_modem_firmware_version", type=rtk.GetModemFirmwareVersion,
        title="Get modem firmware version",
        description="Gets the firmware version of the cellular modem.",
        facts=("Answered by `rtk.GetModemFirmwareVersionResponse`.", "Not listed in any device profile.", "Known only from the MicroStrain MIP SDK."),
        sources=("mip-sdk-4: Get Modem Firmware Version (0x0F,0x08)",),
        parameters=(
        ),
    ),
    "ServiceStatus": FieldInfo(
        "rtk.service_status", type=rtk.ServiceStatus,
        title="Service status",
        description="Queries a correction server about the connection, which also keeps it open.",
        facts=("Answered by `rtk.ServiceStatusResponse`.", "Sent by the device; the host answers.", "Not listed in any device profile.", "Known only from the MicroStrain MIP SDK.", "The modem sends it as a host would, and the server answers as a device would."),
        sources=("mip-sdk-4: Service Status (0x0F,0x0A)",),
        parameters=(
            Parameter("reserved1", "reserved1", "scalar", facts=("Reserved: send 0.", "Uncertain: What the modem sends; 0 is assumed."), scalar="u32", reserved=True, default=0),
            Parameter("reserved2", "reserved2", "scalar", facts=("Reserved: send 0.", "Uncertain: What the modem sends; 0 is assumed."), scalar="u32", reserved=True, default=0),
        ),
    ),
    "EraseStorage": FieldInfo(
        "rtk.erase_storage", type=rtk.EraseStorage,
        title="Erase storage",
        description="Returns a storage medium to its raw state; everything on it is erased.",
        facts=("For advanced use.", "Also called `prod_erase_storage`.", "Not listed in any device profile.", "Known only from the MicroStrain MIP SDK.", "All stored data is lost. The command is for production.", "Accepted in calibration mode only."),
        sources=("mip-sdk-4: Prod Erase Storage (0x0F,0x20)",),
        also=("prod_erase_storage",),
        advanced=True,
        parameters=(
            Parameter("media", "media", "scalar", description="The medium.", scalar="u8", type=rtk.StorageMedium),
        ),
    ),
    "LedControl": FieldInfo(
        "rtk.led_control", type=rtk.LedControl,
        title="LED control",
        description="Colours and pattern of the LED.",
        facts=("For advanced use.", "Not listed in any device profile.", "Known only from the MicroStrain MIP SDK.", "Only in calibration mode or production test mode; otherwise it is refused."),
        sources=("mip-sdk-4: Led Control (0x0F,0x21)",),
        advanced=True,
        parameters=(
            Parameter("primary_color", "primary_color", "array", description="First colour.", facts=("Uncertain: The order of its parts; red, green, blue is likely.",), scalar="u8", length=3),
            Parameter("alternate_color", "alternate_color", "array", description="Second colour.", facts=("Uncertain: The order of its parts; red, green, blue is likely.",), scalar="u8", length=3),
            Parameter("action", "action", "scalar", description="Pattern.", scalar="u8", type=rtk.LedAction),
            Parameter("period", "period", "scalar", description="Period of the pattern.", facts=("Uncertain: The unit; ms is likely.",), scalar="u32"),
        ),
    ),
    "ModemHardReset": FieldInfo(
        "rtk.modem_hard_reset", type=rtk.ModemHardReset,
        title="Modem hard reset",
        description="Clears the flash memory of the modem.",
        facts=("For advanced use.", "Not listed in any device profile.", "Known only from the MicroStrain MIP SDK.", "It wears out the flash memory; use it rarely.", "Accepted in calibration mode only."),
        sources=("mip-sdk-4: Modem Hard Reset (0x0F,0x22)",),
        advanced=True,
        parameters=(
        ),
    ),
    "GetStatusFlagsResponse": FieldInfo(
        "rtk.get_status_flags_response", type=rtk.GetStatusFlagsResponse,
        title="Get status flags response",
        facts=("Answers `rtk.GetStatusFlags`.", "Known only from the MicroStrain MIP SDK."),
        sources=("mip-sdk-4: Get Status Flags (0x0F,0x01)",),
        parameters=(
            Parameter("flags", "flags", "scalar", description="State of the modem and of the corrections.", scalar="u32", type=types.RtkStatusFlags),
        ),
    ),
    "GetImeiResponse": FieldInfo(
        "rtk.get_imei_response", type=rtk.GetImeiResponse,
        title="Get IMEI response",
        facts=("Answers `rtk.GetImei`.", "Known only from the MicroStrain MIP SDK."),
        sources=("mip-sdk-4: Get Imei (0x0F,0x02)",),
        parameters=(
            Parameter("imei", "imei", "text", description="International mobile equipment identity.", scalar="char", length=32),
        ),
    ),
    "GetImsiResponse": FieldInfo(
        "rtk.get_imsi_response", type=rtk.GetImsiResponse,
        title="Get IMSI response",
        facts=("Answers `rtk.GetImsi`.", "Known only from the MicroStrain MIP SDK."),
        sources=("mip-sdk-4: Get Imsi (0x0F,0x03)",),
        parameters=(
            Parameter("imsi", "imsi", "text", description="International mobile subscriber identity.", scalar="char", length=32),
        ),
    ),
    "GetIccidResponse": FieldInfo(
        "rtk.get_iccid_response", type=rtk.GetIccidResponse,
        title="Get ICCID response",
        facts=("Answers `rtk.GetIccid`.", "Known only from the MicroStrain MIP SDK."),
        sources=("mip-sdk-4: Get Iccid (0x0F,0x04)",),
        parameters=(
            Parameter("iccid", "iccid", "text", description="Number of the SIM card.", scalar="char", length=32),
        ),
    ),
    "GetRssiResponse": FieldInfo(
        "rtk.get_rssi_response", type=rtk.GetRssiResponse,
        title="Get RSSI response",
        facts=("Answers `rtk.GetRssi`.", "Known only from the MicroStrain MIP SDK.", "Uncertain: That `valid` applies to the other values is inferred."),
        sources=("mip-sdk-4: Get Rssi (0x0F,0x05)",),
        parameters=(
            Parameter("valid", "valid", "scalar", description="Whether the modem is connected.", scalar="bool"),
            Parameter("rssi", "rssi", "scalar", description="Received signal strength.", facts=("Valid if `valid` is true.", "Uncertain: The unit; dBm is likely."), scalar="s32", valid=("valid",), flags=(Flag("valid", "valid", 0x0),)),
            Parameter("signal_quality", "signal_quality", "scalar", description="Signal quality.", facts=("Valid if `valid` is true.", "Uncertain: The unit."), scalar="s32", valid=("valid",), flags=(Flag("valid", "valid", 0x0),)),
        ),
    ),
    "ConnectedDeviceTypeResponse": FieldInfo(
        "rtk.connected_device_type_response", type=rtk.ConnectedDeviceTypeResponse,
        title="Connected device type response",
        facts=("Answers `rtk.ConnectedDeviceType`.", "Known only from the MicroStrain MIP SDK."),
        sources=("mip-sdk-4: Connected Device Type (0x0F,0x06)",),
        parameters=(
            Parameter("device_type", "device_type", "scalar", description="Type of the device.", scalar="u8", type=rtk.ConnectedDevice),
        ),
    ),
    "GetActivationCodeResponse": FieldInfo(
        "rtk.get_activation_code_response", type=rtk.GetActivationCodeResponse,
        title="Get activation code response",
        facts=("Also called `get_act_code_response`.", "Answers `rtk.GetActivationCode`.", "Known only from the MicroStrain MIP SDK."),
        sources=("mip-sdk-4: Get Act Code (0x0F,0x07)",),
        also=("get_act_code_response",),
        parameters=(
            Parameter("activation_code", "activation_code", "text", description="Activation code.", scalar="char", length=32),
        ),
    ),
    "GetModemFirmwareVersionResponse": FieldInfo(
        "rtk.get_modem_firmware_version_response", type=rtk.GetModemFirmwareVersionResponse,
        title="Get modem firmware version response",
        facts=("Answers `rtk.GetModemFirmwareVersion`.", "Known only from the MicroStrain MIP SDK."),
        sources=("mip-sdk-4: Get Modem Firmware Version (0x0F,0x08)",),
        parameters=(
            Parameter("modem_firmware_version", "modem_firmware_version", "text", description="Firmware version.", scalar="char", length=32),
        ),
    ),
    "ServiceStatusResponse": FieldInfo(
        "rtk.service_status_response", type=rtk.ServiceStatusResponse,
        title="Service status response",
        description="What the server knows of the connection.",
        facts=("Answers `rtk.ServiceStatus`.", "Known only from the MicroStrain MIP SDK.", "Uncertain: What the counters count."),
        sources=("mip-sdk-4: Service Status (0x0F,0x0A)",),
        parameters=(
            Parameter("flags", "flags", "scalar", description="State of the service.", scalar="u8", type=rtk.ServiceFlags),
            Parameter("received_bytes", "received_bytes", "scalar", description="Bytes received.", facts=("Unit: byte.",), scalar="u32", units=("byte",)),
            Parameter("last_bytes", "last_bytes", "scalar", description="Bytes of the last transfer.", facts=("Unit: byte.",), scalar="u32", units=("byte",)),
            Parameter("last_bytes_time", "last_bytes_time", "scalar", description="Time of the last transfer.", facts=("Uncertain: The unit and the epoch.",), scalar="u64"),
        ),
    ),
}
