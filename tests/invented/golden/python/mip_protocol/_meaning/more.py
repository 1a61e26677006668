"""What the types of `more` mean."""

from __future__ import annotations

from .. import measurements, more, types
from ..info import FieldInfo, Info, SetInfo
from ..parameter import Flag, Parameter

# fmt: off
SET = SetInfo("more", number=0x81, title="More measurements", description="A second sensor with the fields of the first.")

#: Class -> what is known of it.
TYPES: dict[str, Info] = {
    "Accel": FieldInfo(
        "more.accel", type=more.Accel,
        title="Second acceleration",
        description="A vector whose elements are valid together.",
        facts=("Has the layout of `measurements.Accel`.", "Maximum rate: 100 Hz.", "Supported by Model A and Model C."),
        sources=("guide: Second acceleration",),
        devices=("model-a", "model-c"),
        max_rate=100,
        parameters=(
            Parameter("scaled_accel", "scaled_accel", "array", description="Specific force.", facts=("Elements: x, y, z.", "Unit: g.", "Frame: sensor.", "Each element has its own valid flag. x: `types.StateFlags.READY` of `valid_flags`, y: `types.StateFlags.HOT` of `valid_flags`, z: `types.StateFlags.READY` of `valid_flags`."), scalar="float", elements=("x", "y", "z"), units=("g",), valid=("valid_flags.ready", "valid_flags.hot", "valid_flags.ready"), frame="sensor", flags=(Flag("valid_flags.ready", "valid_flags", 0x1), Flag("valid_flags.hot", "valid_flags", 0x2), Flag("valid_flags.ready", "valid_flags", 0x1))),
            Parameter("valid_flags", "valid_flags", "scalar", description="What is valid.", scalar="u16", type=types.StateFlags),
        ),
    ),
    "Strings": FieldInfo(
        "more.strings", type=more.Strings,
        title="Strings",
        description="Fixed, counted, and to the end.",
        facts=("Has the layout of `measurements.Strings`.", "Supported by Model A."),
        sources=("guide: Second strings",),
        devices=("model-a",),
        parameters=measurements.Strings.INFO.parameters,
    ),
    "Own": FieldInfo(
        "more.own", type=more.Own,
        title="Own",
        description="Beside those that it repeats.",
        facts=("Supported by Model A and Model C.",),
        sources=("guide: Own",),
        devices=("model-a", "model-c"),
        parameters=(
            Parameter("mode", "mode", "scalar", description="Of the second sensor.", scalar="u8", type=types.Mode),
        ),
    ),
}
