"""The meaning of the types of `shared`."""

from __future__ import annotations

from .. import shared, types
from ..info import FieldInfo, Info
from ..parameter import Flag, Parameter

# fmt: off

#: Class -> its description.
TYPES: dict[str, Info] = {
    "Timestamp": FieldInfo(
        "shared.timestamp", shared.Timestamp, devices=("model-a", "model-c"),
        parameters=(
            Parameter("tow", "tow", "scalar", scalar="double", units=("s",), valid=("valid_flags.ready",), flags=(Flag("valid_flags.ready", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=types.StateFlags),
        ),
    ),
}
