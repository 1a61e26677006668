"""What the types of `shared` mean."""

from __future__ import annotations

from .. import shared, types
from ..info import FieldInfo, Info, SetInfo
from ..parameter import Flag, Parameter

# fmt: off
SET = SetInfo("shared", number=0xFF, title="Shared", description="Valid in every data set.")

#: Class -> what is known of it.
TYPES: dict[str, Info] = {
    "Timestamp": FieldInfo(
        "shared.timestamp", type=shared.Timestamp,
        title="Timestamp",
        description="When the packet was sent.",
        facts=("Supported by Model A and Model C.",),
        sources=("guide: Timestamp",),
        devices=("model-a", "model-c"),
        parameters=(
            Parameter("tow", "tow", "scalar", description="Time of week.", facts=("Unit: s.", "Valid if `types.StateFlags.READY` of `valid_flags` is set."), scalar="double", units=("s",), valid=("valid_flags.ready",), flags=(Flag("valid_flags.ready", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", description="What is valid.", scalar="u16", type=types.StateFlags),
        ),
    ),
}
