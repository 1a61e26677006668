"""What the types of `protocol` mean."""

from __future__ import annotations

from .. import protocol, types
from ..info import EnumInfo, FieldInfo, Info, ValueInfo
from ..parameter import Parameter

# fmt: off

#: Class -> what is known of it.
TYPES: dict[str, Info] = {
    "FunctionSelector": EnumInfo(
        "function_selector", type=protocol.FunctionSelector, description="What a settings command is asked to do.",
        values=(
            ValueInfo("write", value=1, description="Apply the new setting."),
            ValueInfo("read", value=2, description="Return the current setting in a response."),
            ValueInfo("save", value=3, description="Save the current setting to non-volatile memory."),
            ValueInfo("load", value=4, description="Load the saved setting."),
            ValueInfo("default", value=5, description="Load the factory default setting."),
            ValueInfo("apply", value=6, description="Apply the new setting and send no acknowledge (5-series devices)."),
        ),
    ),
    "Acknowledge": FieldInfo(
        "protocol.acknowledge", type=protocol.Acknowledge,
        title="Acknowledge",
        description="Answers one command field. A response, if there is one, follows it in the same packet.",
        sources=("3dm-gx5-15: 2.2.2 Example “Ping” Reply Packet", "3dm-cv7-gnss-ins: Ack/Nack Field Specification"),
        parameters=(
            Parameter("command", "command", "scalar", description="Descriptor of the command that is answered.", scalar="u8"),
            Parameter("code", "code", "scalar", description="0 if the command is acknowledged, else the reason why it is refused.", scalar="u8", type=types.AckCode),
        ),
    ),
}
