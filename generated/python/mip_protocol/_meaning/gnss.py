"""The meaning of the types of `gnss`."""

from __future__ import annotations

from .. import gnss, protocol
from ..info import BitsInfo, EnumInfo, FieldInfo, Info, StructureInfo
from ..parameter import Parameter

# fmt: off

#: Class -> its description.
TYPES: dict[str, Info] = {
    "ReceiverInfoEntry": StructureInfo("gnss.receiver_info_entry", gnss.ReceiverInfoEntry, (
            Parameter("receiver_id", "receiver_id", "scalar", scalar="u8", minimum=1),
            Parameter("mip_data_descriptor_set", "mip_data_descriptor_set", "scalar", scalar="u8", minimum=128, maximum=254, refers="set"),
            Parameter("description", "description", "text", scalar="char", length=32),
        )),
    "GpsSignals": BitsInfo("gnss.gps_signals", gnss.GpsSignals),
    "GlonassSignals": BitsInfo("gnss.glonass_signals", gnss.GlonassSignals),
    "GalileoSignals": BitsInfo("gnss.galileo_signals", gnss.GalileoSignals),
    "BeidouSignals": BitsInfo("gnss.beidou_signals", gnss.BeidouSignals),
    "ReceiverId": EnumInfo("gnss.receiver_id", gnss.ReceiverId),
    "ReceiverResetType": EnumInfo("gnss.receiver_reset_type", gnss.ReceiverResetType),
    "AmbiguityFixMode": EnumInfo("gnss.ambiguity_fix_mode", gnss.AmbiguityFixMode),
    "SpartnConnection": EnumInfo("gnss.spartn_connection", gnss.SpartnConnection),
    "ReceiverInfo": FieldInfo(
        "gnss.receiver_info", gnss.ReceiverInfo, devices=("3dm-cv7-gnss-ins",), assumed=("3dm-gq7",), parameters=(
        )),
    "SignalConfig": FieldInfo(
        "gnss.signal_config", gnss.SignalConfig, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins",), likely=("3dm-gq7",), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("gps_enable", "gps_enable", "scalar", scalar="u8", required=("write",), type=gnss.GpsSignals),
            Parameter("glonass_enable", "glonass_enable", "scalar", scalar="u8", required=("write",), type=gnss.GlonassSignals),
            Parameter("galileo_enable", "galileo_enable", "scalar", scalar="u8", required=("write",), type=gnss.GalileoSignals),
            Parameter("beidou_enable", "beidou_enable", "scalar", scalar="u8", required=("write",), type=gnss.BeidouSignals),
            Parameter("reserved", "reserved", "array", scalar="u8", length=4, required=("write",), reserved=True, default=0),
        )),
    "ReceiverReset": FieldInfo(
        "gnss.receiver_reset", gnss.ReceiverReset, parameters=(
            Parameter("receiver_id", "receiver_id", "scalar", scalar="u8", type=gnss.ReceiverId),
            Parameter("reset_type", "reset_type", "scalar", scalar="u8", type=gnss.ReceiverResetType),
        )),
    "RtkConfig": FieldInfo(
        "gnss.rtk_config", gnss.RtkConfig, functions=("write", "read", "save", "load", "default"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("ambiguity_fix_mode", "ambiguity_fix_mode", "scalar", scalar="u8", required=("write",), type=gnss.AmbiguityFixMode),
            Parameter("reserved", "reserved", "array", scalar="u8", length=4, required=("write",), reserved=True, default=0),
        )),
    "RtkDongleConfig": FieldInfo(
        "gnss.rtk_dongle_config", gnss.RtkDongleConfig, functions=("write", "read", "save", "load", "default"), likely=("3dm-gq7",), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("enable", "enable", "scalar", scalar="u8", maximum=1, required=("write",), minimum=0),
            Parameter("reserved", "reserved", "array", scalar="u8", length=3, required=("write",), reserved=True, default=0),
        )),
    "SpartnConfig": FieldInfo(
        "gnss.spartn_config", gnss.SpartnConfig, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins",), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("enable", "enable", "scalar", scalar="u8", maximum=1, required=("write",), minimum=0),
            Parameter("type", "type", "scalar", scalar="u8", required=("write",), type=gnss.SpartnConnection),
            Parameter("current_key_tow", "current_key_tow", "scalar", scalar="u32", units=("s",), required=("write",)),
            Parameter("current_key_week", "current_key_week", "scalar", scalar="u16", units=("week",), required=("write",)),
            Parameter("current_key", "current_key", "array", scalar="u8", length=32, required=("write",)),
            Parameter("next_key_tow", "next_key_tow", "scalar", scalar="u32", units=("s",), required=("write",)),
            Parameter("next_key_week", "next_key_week", "scalar", scalar="u16", units=("week",), required=("write",)),
            Parameter("next_key", "next_key", "array", scalar="u8", length=32, required=("write",)),
        )),
    "ReceiverSafeMode": FieldInfo(
        "gnss.receiver_safe_mode", gnss.ReceiverSafeMode, parameters=(
            Parameter("receiver_id", "receiver_id", "scalar", scalar="u8", minimum=1),
            Parameter("enable", "enable", "scalar", scalar="u8", maximum=1, minimum=0),
        )),
    "ReceiverInfoResponse": FieldInfo(
        "gnss.receiver_info_response", gnss.ReceiverInfoResponse, devices=("3dm-cv7-gnss-ins",), assumed=("3dm-gq7",), parameters=(
            Parameter("num_receivers", "num_receivers", "counter", scalar="u8", counts="receiver_info"),
            Parameter("receiver_info", "receiver_info", "array", length="num_receivers", type=gnss.ReceiverInfoEntry),
        )),
    "SignalConfigResponse": FieldInfo(
        "gnss.signal_config_response", gnss.SignalConfigResponse, devices=("3dm-cv7-gnss-ins",), likely=("3dm-gq7",), parameters=(
            Parameter("gps_enable", "gps_enable", "scalar", scalar="u8", type=gnss.GpsSignals),
            Parameter("glonass_enable", "glonass_enable", "scalar", scalar="u8", type=gnss.GlonassSignals),
            Parameter("galileo_enable", "galileo_enable", "scalar", scalar="u8", type=gnss.GalileoSignals),
            Parameter("beidou_enable", "beidou_enable", "scalar", scalar="u8", type=gnss.BeidouSignals),
            Parameter("reserved", "reserved", "array", scalar="u8", length=4, reserved=True, default=0),
        )),
    "RtkConfigResponse": FieldInfo(
        "gnss.rtk_config_response", gnss.RtkConfigResponse, parameters=(
            Parameter("ambiguity_fix_mode", "ambiguity_fix_mode", "scalar", scalar="u8", type=gnss.AmbiguityFixMode),
            Parameter("reserved", "reserved", "array", scalar="u8", length=4, reserved=True, default=0),
        )),
    "RtkDongleConfigResponse": FieldInfo(
        "gnss.rtk_dongle_config_response", gnss.RtkDongleConfigResponse, likely=("3dm-gq7",), parameters=(
            Parameter("enable", "enable", "scalar", scalar="u8", maximum=1, minimum=0),
            Parameter("reserved", "reserved", "array", scalar="u8", length=3, reserved=True, default=0),
        )),
    "SpartnConfigResponse": FieldInfo(
        "gnss.spartn_config_response", gnss.SpartnConfigResponse, devices=("3dm-cv7-gnss-ins",), parameters=(
            Parameter("enable", "enable", "scalar", scalar="u8", maximum=1, minimum=0),
            Parameter("type", "type", "scalar", scalar="u8", type=gnss.SpartnConnection),
            Parameter("current_key_tow", "current_key_tow", "scalar", scalar="u32", units=("s",)),
            Parameter("current_key_week", "current_key_week", "scalar", scalar="u16", units=("week",)),
            Parameter("current_key", "current_key", "array", scalar="u8", length=32),
            Parameter("next_key_tow", "next_key_tow", "scalar", scalar="u32", units=("s",)),
            Parameter("next_key_week", "next_key_week", "scalar", scalar="u16", units=("week",)),
            Parameter("next_key", "next_key", "array", scalar="u8", length=32),
        )),
}
