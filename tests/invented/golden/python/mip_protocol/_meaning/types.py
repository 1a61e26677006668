"""The meaning of the types of `types`."""

from __future__ import annotations

from .. import types
from ..info import BitsInfo, EnumInfo, Info, StructureInfo
from ..parameter import Parameter

# fmt: off

#: Class -> its description.
TYPES: dict[str, Info] = {
    "AckCode": EnumInfo("ack_code", types.AckCode),
    "Mode": EnumInfo("mode", types.Mode, deprecated=("slow",)),
    "WideCode": EnumInfo("wide_code", types.WideCode),
    "StateFlags": BitsInfo("state_flags", types.StateFlags, aliases=("any",), numbers={"mode": types.Mode}),
    "Health": BitsInfo("health", types.Health),
    "Point": StructureInfo("point", types.Point, (
            Parameter("x", "x", "scalar", scalar="s16", units=("m",)),
            Parameter("y", "y", "scalar", scalar="s16", units=("m",)),
        )),
    "Segment": StructureInfo("segment", types.Segment, (
            Parameter("from", "from_", "struct", type=types.Point),
            Parameter("to", "to", "struct", type=types.Point),
            Parameter("weights", "weights", "array", scalar="u8", length=2),
        )),
}
