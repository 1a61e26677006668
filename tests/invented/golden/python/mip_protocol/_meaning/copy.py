"""What the types of `copy` mean."""

from __future__ import annotations

from .. import copy, measurements, types
from ..info import FieldInfo, Info, SetInfo
from ..parameter import Flag, Parameter

# fmt: off
SET = SetInfo("copy", number=0x92, title="Copied measurements", description="All the fields of another set.", facts=("Uncertain: Which device sends it.",))

#: Class -> what is known of it.
TYPES: dict[str, Info] = {
    "Accel": FieldInfo(
        "copy.accel", type=copy.Accel,
        title="Third acceleration",
        description="A vector whose elements are valid together.",
        facts=("Has the layout of `measurements.Accel`.", "Maximum rate: 100 Hz.", "May be supported by Model C."),
        sources=("guide: Third acceleration",),
        perhaps=("model-c",),
        max_rate=100,
        parameters=(
            Parameter("scaled_accel", "scaled_accel", "array", description="Specific force.", facts=("Elements: x, y, z.", "Unit: g.", "Frame: sensor.", "Each element has its own valid flag. x: `types.StateFlags.READY` of `valid_flags`, y: `types.StateFlags.HOT` of `valid_flags`, z: `types.StateFlags.READY` of `valid_flags`."), scalar="float", elements=("x", "y", "z"), units=("g",), valid=("valid_flags.ready", "valid_flags.hot", "valid_flags.ready"), frame="sensor", flags=(Flag("valid_flags.ready", "valid_flags", 0x1), Flag("valid_flags.hot", "valid_flags", 0x2), Flag("valid_flags.ready", "valid_flags", 0x1))),
            Parameter("valid_flags", "valid_flags", "scalar", description="What is valid.", scalar="u16", type=types.StateFlags),
        ),
    ),
    "Numbers": FieldInfo(
        "copy.numbers", type=copy.Numbers,
        title="Numbers",
        description="One of each.",
        facts=("Has the layout of `measurements.Numbers`.", "Not listed in any device profile.", "Known only from the Kit of names."),
        sources=("sheet: Copied measurements",),
        parameters=measurements.Numbers.INFO.parameters,
    ),
    "Strings": FieldInfo(
        "copy.strings", type=copy.Strings,
        title="Strings",
        description="Fixed, counted, and to the end.",
        facts=("Has the layout of `measurements.Strings`.", "Not listed in any device profile.", "Known only from the Kit of names."),
        sources=("sheet: Copied measurements",),
        parameters=measurements.Strings.INFO.parameters,
    ),
    "Health": FieldInfo(
        "copy.health", type=copy.Health,
        title="Health",
        description="The wide bitfield.",
        facts=("Deprecated: use `measurements.Numbers` instead.", "Has the layout of `measurements.Health`.", "Not listed in any device profile.", "Known only from the Kit of names."),
        sources=("sheet: Copied measurements",),
        deprecated="use `measurements.Numbers` instead",
        parameters=measurements.Health.INFO.parameters,
    ),
    "Arrays": FieldInfo(
        "copy.arrays", type=copy.Arrays,
        title="Arrays",
        description="Arrays of all that can stand in one.",
        facts=("Has the layout of `measurements.Arrays`.", "Not listed in any device profile.", "Known only from the Kit of names."),
        sources=("sheet: Copied measurements",),
        parameters=measurements.Arrays.INFO.parameters,
    ),
    "Growing": FieldInfo(
        "copy.growing", type=copy.Growing,
        title="Growing",
        description="Newer devices send more of it.",
        facts=("Has the layout of `measurements.Growing`.", "Not listed in any device profile.", "Known only from the Kit of names."),
        sources=("sheet: Copied measurements",),
        parameters=measurements.Growing.INFO.parameters,
    ),
    "Radio": FieldInfo(
        "copy.radio", type=copy.Radio,
        title="Radio",
        description="A bool vouches for values; one source has no layout that agrees with it.",
        facts=("Has the layout of `measurements.Radio`.", "Also called `modem` and `rf`.", "Not listed in any device profile.", "Known only from the Kit of names.", "Uncertain: The leaflet gives the strength two bytes.", "Uncertain: Inferred: the strength is never positive."),
        sources=("sheet: Copied measurements",),
        also=("modem", "rf"),
        parameters=(
            Parameter("connected", "connected", "scalar", description="Whether there is a connection.", scalar="bool"),
            Parameter("strength", "strength", "scalar", description="Of the signal.", facts=("Range: less than 1.", "Valid if `connected` is true.", "Uncertain: Its unit."), scalar="s32", valid=("connected",), below=1, flags=(Flag("connected", "connected", 0x0),)),
            Parameter("noise", "noise", "scalar", description="Never nothing.", facts=("Unit: m.", "Range: greater than 0, at most 10.", "Valid if `connected` is true."), scalar="float", units=("m",), valid=("connected",), maximum=10, above=0, flags=(Flag("connected", "connected", 0x0),)),
            Parameter("gap", "gap", "scalar", description="Reserved.", facts=("Reserved.",), scalar="float", reserved=True, default=0.0),
            Parameter("gaps", "gaps", "array", facts=("Reserved.",), scalar="double", length=2, reserved=True, default=0.0),
        ),
    ),
    "Cloud": FieldInfo(
        "copy.cloud", type=copy.Cloud,
        title="Cloud",
        description="The count can exceed what a field holds beside the value behind the array.",
        facts=("Has the layout of `measurements.Cloud`.", "Not listed in any device profile.", "Known only from the Kit of names."),
        sources=("sheet: Copied measurements",),
        parameters=measurements.Cloud.INFO.parameters,
    ),
    "Gust": FieldInfo(
        "copy.gust", type=copy.Gust,
        title="Gust",
        description="One valid flag for all values but one; `measurements.Breeze` has the same place.",
        facts=("Has the layout of `measurements.Gust`.", "Not listed in any device profile.", "Known only from the Kit of names.", "`speed * 3.6` is in km/h, and `valid_flags` tells whether `speed` counts; see `types.Mode` and `tools.Shape`."),
        sources=("sheet: Copied measurements",),
        parameters=measurements.Gust.INFO.parameters,
    ),
    "Breeze": FieldInfo(
        "copy.breeze", type=copy.Breeze,
        title="Breeze",
        description="Its place is told as in `measurements.Gust`.",
        facts=("Has the layout of `measurements.Breeze`.", "Not listed in any device profile.", "Known only from the Kit of names."),
        sources=("sheet: Copied measurements",),
        parameters=measurements.Breeze.INFO.parameters,
    ),
}
