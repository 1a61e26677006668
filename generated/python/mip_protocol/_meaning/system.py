"""The meaning of the types of `system`."""

from __future__ import annotations

from .. import protocol, system, types
from ..info import BitsInfo, EnumInfo, FieldInfo, Info
from ..parameter import Parameter, Variant

# fmt: off

#: Class -> its description.
TYPES: dict[str, Info] = {
    "CommProtocols": BitsInfo("system.comm_protocols", system.CommProtocols),
    "ProtocolMode": EnumInfo("system.protocol_mode", system.ProtocolMode),
    "InterfaceControl": FieldInfo(
        "system.interface_control", system.InterfaceControl, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins",), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("port", "port", "scalar", scalar="u8", required=("write", "read", "save", "load", "default"), type=types.CommInterface),
            Parameter("protocols_incoming", "protocols_incoming", "scalar", scalar="u32", required=("write",), type=system.CommProtocols),
            Parameter("protocols_outgoing", "protocols_outgoing", "scalar", scalar="u32", required=("write",), type=system.CommProtocols),
        )),
    "CommMode": FieldInfo(
        "system.comm_mode", system.CommMode, functions=("write", "read", "save", "load", "default"), devices=("3dm-gx5-15", "3dm-gx5-35", "3dm-gx5-45"), likely=("3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-25", "3dm-rq1-45-lt", "3dm-rq1-imu", "3dm-rtk"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gq4-45", "3dm-rq1-45-st"), advanced=True, parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("mode", "mode", "scalar", scalar="u8", default=1, required=("write",), type=system.ProtocolMode, variants=(Variant("device", ("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx5-15", "3dm-gx5-25"), {"only": ("standard", "sensor_direct")}), Variant("device", ("3dm-gx5-35",), {"default": 1}),)),
        )),
    "InterfaceControlResponse": FieldInfo(
        "system.interface_control_response", system.InterfaceControlResponse, devices=("3dm-cv7-gnss-ins",), parameters=(
            Parameter("port", "port", "scalar", scalar="u8", type=types.CommInterface),
            Parameter("protocols_incoming", "protocols_incoming", "scalar", scalar="u32", type=system.CommProtocols),
            Parameter("protocols_outgoing", "protocols_outgoing", "scalar", scalar="u32", type=system.CommProtocols),
        )),
    "CommModeResponse": FieldInfo(
        "system.comm_mode_response", system.CommModeResponse, devices=("3dm-gx5-15", "3dm-gx5-35", "3dm-gx5-45"), likely=("3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-25", "3dm-rq1-45-lt", "3dm-rq1-imu", "3dm-rtk"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("mode", "mode", "scalar", scalar="u8", default=1, type=system.ProtocolMode),
        )),
}
