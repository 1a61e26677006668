"""What the types of `gnss` mean."""

from __future__ import annotations

from .. import gnss, protocol
from ..info import BitInfo, BitsInfo, EnumInfo, FieldInfo, Info, SetInfo, StructureInfo, ValueInfo
from ..parameter import Parameter

# fmt: off
SET = SetInfo("gnss", number=0x0E, title="GNSS commands", description="Commands that describe and set up the internal GNSS receivers.", sources=("3dm-cv7-gnss-ins: GNSS (0x0E)",))

#: Class -> what is known of it.
TYPES: dict[str, Info] = {
    "ReceiverInfoEntry": StructureInfo(
        "gnss.receiver_info_entry", type=gnss.ReceiverInfoEntry, description="One GNSS receiver.", sources=("3dm-cv7-gnss-ins: Info",),
        parameters=(
            Parameter("receiver_id", "receiver_id", "scalar", description="Receiver, counted from 1.", facts=("Range: at least 1.",), scalar="u8", minimum=1),
            Parameter("mip_data_descriptor_set", "mip_data_descriptor_set", "scalar", description="Descriptor set of the data of this receiver.", facts=("Range: 0x80 to 0xFE.",), scalar="u8", minimum=128, maximum=254),
            Parameter("description", "description", "text", description="Module name or model and firmware version, separated by a comma.", scalar="char", length=32),
        ),
    ),
    "GpsSignals": BitsInfo(
        "gnss.gps_signals", type=gnss.GpsSignals, description="GPS signals that are enabled.",
        bits=(
            BitInfo("l1ca", first=0, last=0, description="L1 C/A."),
            BitInfo("l2c", first=1, last=1, description="L2C."),
            BitInfo("l5", first=2, last=2, description="L5."),
        ),
    ),
    "GlonassSignals": BitsInfo(
        "gnss.glonass_signals", type=gnss.GlonassSignals, description="GLONASS signals that are enabled.",
        bits=(
            BitInfo("l1of", first=0, last=0, description="L1OF."),
            BitInfo("l2of", first=1, last=1, description="L2OF."),
        ),
    ),
    "GalileoSignals": BitsInfo(
        "gnss.galileo_signals", type=gnss.GalileoSignals, description="Galileo signals that are enabled.",
        bits=(
            BitInfo("e1", first=0, last=0, description="E1."),
            BitInfo("e5b", first=1, last=1, description="E5b."),
            BitInfo("e5a", first=2, last=2, description="E5a."),
        ),
    ),
    "BeidouSignals": BitsInfo(
        "gnss.beidou_signals", type=gnss.BeidouSignals, description="BeiDou signals that are enabled.",
        bits=(
            BitInfo("b1", first=0, last=0, description="B1."),
            BitInfo("b2", first=1, last=1, description="B2."),
            BitInfo("b2a", first=2, last=2, description="B2a."),
        ),
    ),
    "SpartnConnection": EnumInfo(
        "gnss.spartn_connection", type=gnss.SpartnConnection, description="How SPARTN corrections are received.",
        values=(
            ValueInfo("none", value=0, description="No connection."),
            ValueInfo("network", value=1, description="Over a network."),
            ValueInfo("l_band", value=2, description="By satellite in the L band."),
        ),
    ),
    "ReceiverInfo": FieldInfo(
        "gnss.receiver_info", type=gnss.ReceiverInfo,
        title="Receiver info",
        description="Gets the GNSS receivers of the device.",
        facts=("Answered by `gnss.ReceiverInfoResponse`.", "Supported by 3DM-CV7-GNSS/INS."),
        sources=("3dm-cv7-gnss-ins: Receiver Info (0x0E,0x01)",),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
        ),
    ),
    "SignalConfig": FieldInfo(
        "gnss.signal_config", type=gnss.SignalConfig,
        title="Signal configuration",
        description="GNSS signals that the device uses.",
        facts=("Also called `signal_configuration`.", "Functions: `write`, `read`, `save`, `load` and `default`.", "Answered by `gnss.SignalConfigResponse`.", "Supported by 3DM-CV7-GNSS/INS.", "A device accepts certain combinations only.", "The 3DM-CV7-GNSS/INS needs GPS or Galileo, and refuses GPS L1 with BeiDou L1 alone. For GPS and BeiDou it accepts none, L1, or L1 and L5; for Galileo none, or L1 and L5; for GLONASS none or L1."),
        sources=("3dm-cv7-gnss-ins: Signal Configuration (0x0E,0x02)", "3dm-cv7-gnss-ins: GNSS"),
        also=("signal_configuration",),
        functions=("write", "read", "save", "load", "default"),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("function", "function", "scalar", description="What to do with the setting.", scalar="u8", type=protocol.FunctionSelector),
            Parameter("gps_enable", "gps_enable", "scalar", description="GPS signals.", facts=("Required for `write`.",), scalar="u8", required=("write",), type=gnss.GpsSignals),
            Parameter("glonass_enable", "glonass_enable", "scalar", description="GLONASS signals.", facts=("Required for `write`.",), scalar="u8", required=("write",), type=gnss.GlonassSignals),
            Parameter("galileo_enable", "galileo_enable", "scalar", description="Galileo signals.", facts=("Required for `write`.",), scalar="u8", required=("write",), type=gnss.GalileoSignals),
            Parameter("beidou_enable", "beidou_enable", "scalar", description="BeiDou signals.", facts=("Required for `write`.",), scalar="u8", required=("write",), type=gnss.BeidouSignals),
            Parameter("reserved", "reserved", "array", facts=("Reserved: send 0.", "Required for `write`."), scalar="u8", length=4, required=("write",), reserved=True, default=0),
        ),
    ),
    "RtkDongleConfig": FieldInfo(
        "gnss.rtk_dongle_config", type=gnss.RtkDongleConfig,
        title="RTK dongle configuration",
        description="Switches the communication with a connected RTK dongle on or off.",
        facts=("Also called `rtk_dongle_configuration`.", "Functions: `write`, `read`, `save`, `load` and `default`.", "Answered by `gnss.RtkDongleConfigResponse`.", "Not listed in any device profile.", "Known only from the MicroStrain MIP SDK."),
        sources=("mip-sdk-4: Rtk Dongle Configuration (0x0E,0x10)",),
        also=("rtk_dongle_configuration",),
        functions=("write", "read", "save", "load", "default"),
        parameters=(
            Parameter("function", "function", "scalar", description="What to do with the setting.", scalar="u8", type=protocol.FunctionSelector),
            Parameter("enable", "enable", "scalar", description="1 enables the dongle, 0 disables it.", facts=("Range: 0 to 1.", "Required for `write`."), scalar="u8", maximum=1, required=("write",), minimum=0),
            Parameter("reserved", "reserved", "array", facts=("Reserved: send 0.", "Required for `write`.", "Uncertain: What to send; 0 is assumed."), scalar="u8", length=3, required=("write",), reserved=True, default=0),
        ),
    ),
    "SpartnConfig": FieldInfo(
        "gnss.spartn_config", type=gnss.SpartnConfig,
        title="SPARTN configuration",
        description="Source and keys of SPARTN corrections.",
        facts=("Also called `spartn_configuration`.", "Functions: `write`, `read`, `save`, `load` and `default`.", "Answered by `gnss.SpartnConfigResponse`.", "Supported by 3DM-CV7-GNSS/INS.", "A change of `enable` or `type` takes effect only after a power cycle; keys can be changed at any time.", "While SPARTN corrections are enabled, RTCM corrections are blocked.", "A key of 16 bytes, none of them 0, is sent as 32 ASCII digits in hexadecimal, two for each byte.", "Uncertain: Whether the device accepts upper and lower case. The section on UART has the digits 0-9 and A-F, the description of the command has \"bc\" for 0xBC."),
        sources=("3dm-cv7-gnss-ins: Spartn Configuration (0x0E,0x20)", "3dm-cv7-gnss-ins: SPARTN Corrections", "3dm-cv7-gnss-ins: SPARTN Corrections via UART"),
        also=("spartn_configuration",),
        functions=("write", "read", "save", "load", "default"),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("function", "function", "scalar", description="What to do with the setting.", scalar="u8", type=protocol.FunctionSelector),
            Parameter("enable", "enable", "scalar", description="1 enables SPARTN corrections, 0 disables them.", facts=("Range: 0 to 1.", "Required for `write`."), scalar="u8", maximum=1, required=("write",), minimum=0),
            Parameter("type", "type", "scalar", description="How the corrections are received.", facts=("Required for `write`.",), scalar="u8", required=("write",), type=gnss.SpartnConnection),
            Parameter("current_key_tow", "current_key_tow", "scalar", description="GPS time of week until which the current key is valid.", facts=("Unit: s.", "Required for `write`."), scalar="u32", units=("s",), required=("write",)),
            Parameter("current_key_week", "current_key_week", "scalar", description="GPS week number until which the current key is valid.", facts=("Unit: week.", "Required for `write`."), scalar="u16", units=("week",), required=("write",)),
            Parameter("current_key", "current_key", "array", description="Current key in ASCII digits.", facts=("Required for `write`.",), scalar="u8", length=32, required=("write",)),
            Parameter("next_key_tow", "next_key_tow", "scalar", description="GPS time of week until which the next key is valid.", facts=("Unit: s.", "Required for `write`."), scalar="u32", units=("s",), required=("write",)),
            Parameter("next_key_week", "next_key_week", "scalar", description="GPS week number until which the next key is valid.", facts=("Unit: week.", "Required for `write`."), scalar="u16", units=("week",), required=("write",)),
            Parameter("next_key", "next_key", "array", description="Next key in ASCII digits.", facts=("Required for `write`.",), scalar="u8", length=32, required=("write",)),
        ),
    ),
    "ReceiverInfoResponse": FieldInfo(
        "gnss.receiver_info_response", type=gnss.ReceiverInfoResponse,
        title="Receiver info response",
        facts=("Answers `gnss.ReceiverInfo`.", "Supported by 3DM-CV7-GNSS/INS."),
        sources=("3dm-cv7-gnss-ins: Receiver Info (0x0E,0x01)",),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("num_receivers", "num_receivers", "counter", description="Number of physical receivers.", facts=("The number of elements of `receiver_info`.",), scalar="u8", counts="receiver_info"),
            Parameter("receiver_info", "receiver_info", "array", description="The receivers.", length="num_receivers", type=gnss.ReceiverInfoEntry),
        ),
    ),
    "SignalConfigResponse": FieldInfo(
        "gnss.signal_config_response", type=gnss.SignalConfigResponse,
        title="Signal configuration response",
        facts=("Also called `signal_configuration_response`.", "Answers `gnss.SignalConfig`.", "Supported by 3DM-CV7-GNSS/INS."),
        sources=("3dm-cv7-gnss-ins: Signal Configuration (0x0E,0x02)", "3dm-cv7-gnss-ins: GNSS"),
        also=("signal_configuration_response",),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("gps_enable", "gps_enable", "scalar", description="GPS signals.", scalar="u8", type=gnss.GpsSignals),
            Parameter("glonass_enable", "glonass_enable", "scalar", description="GLONASS signals.", scalar="u8", type=gnss.GlonassSignals),
            Parameter("galileo_enable", "galileo_enable", "scalar", description="Galileo signals.", scalar="u8", type=gnss.GalileoSignals),
            Parameter("beidou_enable", "beidou_enable", "scalar", description="BeiDou signals.", scalar="u8", type=gnss.BeidouSignals),
            Parameter("reserved", "reserved", "array", facts=("Reserved.",), scalar="u8", length=4, reserved=True, default=0),
        ),
    ),
    "RtkDongleConfigResponse": FieldInfo(
        "gnss.rtk_dongle_config_response", type=gnss.RtkDongleConfigResponse,
        title="RTK dongle configuration response",
        facts=("Also called `rtk_dongle_configuration_response`.", "Answers `gnss.RtkDongleConfig`.", "Known only from the MicroStrain MIP SDK."),
        sources=("mip-sdk-4: Rtk Dongle Configuration (0x0E,0x10)",),
        also=("rtk_dongle_configuration_response",),
        parameters=(
            Parameter("enable", "enable", "scalar", description="1 enables the dongle, 0 disables it.", facts=("Range: 0 to 1.",), scalar="u8", maximum=1, minimum=0),
            Parameter("reserved", "reserved", "array", facts=("Reserved.", "Uncertain: What to send; 0 is assumed."), scalar="u8", length=3, reserved=True, default=0),
        ),
    ),
    "SpartnConfigResponse": FieldInfo(
        "gnss.spartn_config_response", type=gnss.SpartnConfigResponse,
        title="SPARTN configuration response",
        facts=("Also called `spartn_configuration_response`.", "Answers `gnss.SpartnConfig`.", "Supported by 3DM-CV7-GNSS/INS."),
        sources=("3dm-cv7-gnss-ins: Spartn Configuration (0x0E,0x20)", "3dm-cv7-gnss-ins: SPARTN Corrections", "3dm-cv7-gnss-ins: SPARTN Corrections via UART"),
        also=("spartn_configuration_response",),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("enable", "enable", "scalar", description="1 enables SPARTN corrections, 0 disables them.", facts=("Range: 0 to 1.",), scalar="u8", maximum=1, minimum=0),
            Parameter("type", "type", "scalar", description="How the corrections are received.", scalar="u8", type=gnss.SpartnConnection),
            Parameter("current_key_tow", "current_key_tow", "scalar", description="GPS time of week until which the current key is valid.", facts=("Unit: s.",), scalar="u32", units=("s",)),
            Parameter("current_key_week", "current_key_week", "scalar", description="GPS week number until which the current key is valid.", facts=("Unit: week.",), scalar="u16", units=("week",)),
            Parameter("current_key", "current_key", "array", description="Current key in ASCII digits.", scalar="u8", length=32),
            Parameter("next_key_tow", "next_key_tow", "scalar", description="GPS time of week until which the next key is valid.", facts=("Unit: s.",), scalar="u32", units=("s",)),
            Parameter("next_key_week", "next_key_week", "scalar", description="GPS week number until which the next key is valid.", facts=("Unit: week.",), scalar="u16", units=("week",)),
            Parameter("next_key", "next_key", "array", description="Next key in ASCII digits.", scalar="u8", length=32),
        ),
    ),
}
