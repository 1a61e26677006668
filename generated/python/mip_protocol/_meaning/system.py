"""What the types of `system` mean."""

from __future__ import annotations

from .. import protocol, system, types
from ..info import BitInfo, BitsInfo, EnumInfo, FieldInfo, Info, SetInfo, ValueInfo
from ..parameter import Parameter, Variant

# fmt: off
SET = SetInfo("system", number=0x7F, title="System", description="Advanced commands of devices that consist of several intelligent parts.", sources=("3dm-gx5-15: 4.4 System Commands",))

#: Class -> what is known of it.
TYPES: dict[str, Info] = {
    "CommProtocols": BitsInfo(
        "system.comm_protocols", type=system.CommProtocols, description="Protocols of a port.", sources=("mip-sdk-4: Interface Control (0x7F,0x02)",),
        bits=(
            BitInfo("mip", first=0, last=0, description="MIP."),
            BitInfo("nmea", first=8, last=8, description="NMEA-0183."),
            BitInfo("rtcm", first=9, last=9, description="RTCM corrections."),
            BitInfo("spartn", first=24, last=24, description="SPARTN corrections."),
        ),
    ),
    "ProtocolMode": EnumInfo(
        "system.protocol_mode", type=system.ProtocolMode, description="Which part of the device the host communicates with, and by which protocol.",
        values=(
            ValueInfo("standard", value=1, description="The device itself, MIP."),
            ValueInfo("sensor_direct", value=2, description="The internal inertial sensor, MIP."),
            ValueInfo("gnss_direct", value=3, description="The internal GNSS receiver, NMEA and UBX; only on models that have one."),
        ),
    ),
    "InterfaceControl": FieldInfo(
        "system.interface_control", type=system.InterfaceControl,
        title="Interface control",
        description="Protocols that a port receives and sends.",
        facts=("Functions: `write`, `read`, `save`, `load` and `default`.", "Answered by `system.InterfaceControlResponse`.", "May be supported by 3DM-CV7-GNSS/INS.", "Accepted on the main port only. The main port always keeps MIP in both directions.", "The change comes before the acknowledge, which is sent on the main port; bytes that arrive during the change may be lost.", "The device refuses protocols that it or the port does not have, and more parsers than it has; then nothing is changed.", "Answers to an incoming protocol are sent on the same port, even if the protocol is not an outgoing one.", "Devices differ in how many protocols they receive and send at a time."),
        sources=("mip-sdk-4: Interface Control (0x7F,0x02)", "3dm-cv7-gnss-ins: Ports"),
        functions=("write", "read", "save", "load", "default"),
        perhaps=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("function", "function", "scalar", description="What to do with the setting.", scalar="u8", type=protocol.FunctionSelector),
            Parameter("port", "port", "scalar", description="The port.", facts=("Uncertain: Whether write and read accept `all`.",), scalar="u8", required=("write", "read", "save", "load", "default"), type=types.CommInterface),
            Parameter("protocols_incoming", "protocols_incoming", "scalar", description="Protocols that it receives.", facts=("Required for `write`.",), scalar="u32", required=("write",), type=system.CommProtocols),
            Parameter("protocols_outgoing", "protocols_outgoing", "scalar", description="Protocols that it sends.", facts=("Required for `write`.",), scalar="u32", required=("write",), type=system.CommProtocols),
        ),
    ),
    "CommMode": FieldInfo(
        "system.comm_mode", type=system.CommMode,
        title="Communication mode",
        description="Switches the port between the device and one of its internal sensors.",
        facts=("For advanced use.", "Functions: `write`, `read`, `save`, `load` and `default`.", "Answered by `system.CommModeResponse`.", "Supported by 3DM-GX5-15, 3DM-GX5-35 and 3DM-GX5-45.", "The acknowledge is sent in the old mode, just before the switch.", "In a direct mode only this command and `mip_3dm.DeviceStatus` of the device itself are answered."),
        sources=("3dm-gx5-15: 4.4.1 Communication Mode (0x7F, 0x10)",),
        functions=("write", "read", "save", "load", "default"),
        devices=("3dm-gx5-15", "3dm-gx5-35", "3dm-gx5-45"),
        advanced=True,
        parameters=(
            Parameter("function", "function", "scalar", description="What to do with the setting.", scalar="u8", type=protocol.FunctionSelector),
            Parameter("mode", "mode", "scalar", description="Communication mode.", facts=("Default: `system.ProtocolMode.STANDARD`.", "Required for `write`.", "On the 3DM-GX5-35: default `system.ProtocolMode.STANDARD`."), scalar="u8", default=1, required=("write",), type=system.ProtocolMode, variants=(Variant("device", ("3dm-gx5-35",), "On the 3DM-GX5-35: default `system.ProtocolMode.STANDARD`.", {"default": 1}),)),
        ),
    ),
    "InterfaceControlResponse": FieldInfo(
        "system.interface_control_response", type=system.InterfaceControlResponse,
        title="Interface control response",
        facts=("Answers `system.InterfaceControl`.", "May be supported by 3DM-CV7-GNSS/INS."),
        sources=("mip-sdk-4: Interface Control (0x7F,0x02)", "3dm-cv7-gnss-ins: Ports"),
        perhaps=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("port", "port", "scalar", description="The port.", facts=("Uncertain: Whether write and read accept `all`.",), scalar="u8", type=types.CommInterface),
            Parameter("protocols_incoming", "protocols_incoming", "scalar", description="Protocols that it receives.", scalar="u32", type=system.CommProtocols),
            Parameter("protocols_outgoing", "protocols_outgoing", "scalar", description="Protocols that it sends.", scalar="u32", type=system.CommProtocols),
        ),
    ),
    "CommModeResponse": FieldInfo(
        "system.comm_mode_response", type=system.CommModeResponse,
        title="Communication mode response",
        facts=("Answers `system.CommMode`.", "Supported by 3DM-GX5-15, 3DM-GX5-35 and 3DM-GX5-45."),
        sources=("3dm-gx5-15: 4.4.1 Communication Mode (0x7F, 0x10)",),
        devices=("3dm-gx5-15", "3dm-gx5-35", "3dm-gx5-45"),
        parameters=(
            Parameter("mode", "mode", "scalar", description="Communication mode.", facts=("Default: `system.ProtocolMode.STANDARD`.",), scalar="u8", default=1, type=system.ProtocolMode),
        ),
    ),
}
