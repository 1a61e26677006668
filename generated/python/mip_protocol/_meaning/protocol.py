"""What the types of `protocol` mean."""

from __future__ import annotations

from .. import protocol, types
from ..info import EnumInfo, FieldInfo, Info
from ..parameter import Parameter

# fmt: off

#: Class -> what is known of it.
TYPES: dict[str, Info] = {
    "FunctionSelector": EnumInfo("function_selector", protocol.FunctionSelector),
    "Acknowledge": FieldInfo(
        "protocol.acknowledge", protocol.Acknowledge,
        parameters=(
            Parameter("command", "command", "scalar", scalar="u8", refers="field"),
            Parameter("code", "code", "scalar", scalar="u8", type=types.AckCode),
        ),
    ),
}
