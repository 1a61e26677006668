"""What the types of `protocol` mean."""

from __future__ import annotations

from .. import protocol, types
from ..info import EnumInfo, FieldInfo, Info, ValueInfo
from ..parameter import Parameter, Variant

# fmt: off

#: Class -> what is known of it.
TYPES: dict[str, Info] = {
    "FunctionSelector": EnumInfo(
        "function_selector", type=protocol.FunctionSelector, description="What a settings command is asked to do.",
        values=(
            ValueInfo("write", value=1, description="Apply the new setting."),
            ValueInfo("read", value=2, description="Send the current setting back in a response."),
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
        sources=("guide: Acknowledge",),
        parameters=(
            Parameter("command", "command", "scalar", description="Descriptor of the command that is answered.", scalar="u8"),
            Parameter("code", "code", "scalar", description="Zero acknowledges, any other value refuses.", facts=("On the Model B: values of `types.Mode`.",), scalar="u8", type=types.AckCode, variants=(Variant("device", ("model-b",), "On the Model B: values of `types.Mode`.", {"type": types.Mode}),)),
        ),
    ),
}
