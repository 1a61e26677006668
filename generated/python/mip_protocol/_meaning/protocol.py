"""The meaning of the types of `protocol`."""

from __future__ import annotations

from .. import protocol, types
from ..info import EnumInfo, FieldInfo, Info
from ..parameter import Parameter

# fmt: off

#: Class -> its description.
TYPES: dict[str, Info] = {
    "FunctionSelector": EnumInfo("function_selector", protocol.FunctionSelector),
    "Acknowledge": FieldInfo(
        "protocol.acknowledge", protocol.Acknowledge, parameters=(
            Parameter("command", "command", "scalar", scalar="u8", refers="field"),
            Parameter("code", "code", "scalar", scalar="u8", type=types.AckCode),
        )),
}
