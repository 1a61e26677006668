"""What the types of `measurements` mean."""

from __future__ import annotations

from .. import measurements, types
from ..info import FieldInfo, Info, SetInfo
from ..parameter import Flag, Parameter, Variant

# fmt: off
SET = SetInfo("measurements", number=0x80, title="Measurements", description="Data of every type; `tools` has what they are set up with.")

#: Class -> what is known of it.
TYPES: dict[str, Info] = {
    "Accel": FieldInfo(
        "measurements.accel", type=measurements.Accel,
        title="Acceleration",
        description="A vector whose elements are valid together.",
        facts=("Maximum rate: 100 Hz.", "Supported by Model A, Model B and Model C."),
        sources=("guide: Acceleration", "leaflet: Acceleration"),
        devices=("model-a", "model-b", "model-c"),
        max_rate=100,
        parameters=(
            Parameter("scaled_accel", "scaled_accel", "array", description="Specific force.", facts=("Elements: x, y, z.", "Unit: g.", "Frame: sensor.", "Each element has its own valid flag. x: `types.StateFlags.READY` of `valid_flags`, y: `types.StateFlags.HOT` of `valid_flags`, z: `types.StateFlags.READY` of `valid_flags`.", "On the Model B: unit m, m, s; frame ned; valid flags x: `types.StateFlags.HOT` of `valid_flags`, y: `types.StateFlags.READY` of `valid_flags`, z: `types.StateFlags.HOT` of `valid_flags`. Turned by the device.", "On the Model C: no flag says whether it is valid."), scalar="float", elements=("x", "y", "z"), units=("g",), valid=("valid_flags.ready", "valid_flags.hot", "valid_flags.ready"), frame="sensor", flags=(Flag("valid_flags.ready", "valid_flags", 0x1), Flag("valid_flags.hot", "valid_flags", 0x2), Flag("valid_flags.ready", "valid_flags", 0x1)), variants=(Variant("device", ("model-b",), "On the Model B: unit m, m, s; frame ned; valid flags x: `types.StateFlags.HOT` of `valid_flags`, y: `types.StateFlags.READY` of `valid_flags`, z: `types.StateFlags.HOT` of `valid_flags`. Turned by the device.", {"units": ("m", "m", "s"), "frame": "ned", "valid": ("valid_flags.hot", "valid_flags.ready", "valid_flags.hot")}), Variant("device", ("model-c",), "On the Model C: no flag says whether it is valid.", {"valid": ()}),), flags_on={"model-b": (Flag("valid_flags.hot", "valid_flags", 0x2), Flag("valid_flags.ready", "valid_flags", 0x1), Flag("valid_flags.hot", "valid_flags", 0x2)), "model-c": ()}),
            Parameter("valid_flags", "valid_flags", "scalar", description="What is valid.", facts=("On the Model C: only `types.StateFlags.READY` and `types.StateFlags.LEVEL`.",), scalar="u16", type=types.StateFlags, variants=(Variant("device", ("model-c",), "On the Model C: only `types.StateFlags.READY` and `types.StateFlags.LEVEL`.", {"only": ("ready", "level")}),)),
        ),
    ),
    "Numbers": FieldInfo(
        "measurements.numbers", type=measurements.Numbers,
        title="Numbers",
        description="One of each.",
        facts=("Supported by Model A and Model C.", "May be supported by Old 1 and Old 2."),
        sources=("guide: Numbers",),
        devices=("model-a", "model-c"),
        perhaps=("old-1", "old-2"),
        parameters=(
            Parameter("u8", "u8", "scalar", description="Unsigned.", scalar="u8"),
            Parameter("u16", "u16", "scalar", description="Unsigned.", scalar="u16"),
            Parameter("u32", "u32", "scalar", description="Unsigned.", scalar="u32"),
            Parameter("u64", "u64", "scalar", description="Unsigned.", scalar="u64"),
            Parameter("s8", "s8", "scalar", description="Signed.", scalar="s8"),
            Parameter("s16", "s16", "scalar", description="Signed.", scalar="s16"),
            Parameter("s32", "s32", "scalar", description="Signed.", scalar="s32"),
            Parameter("s64", "s64", "scalar", description="Signed.", scalar="s64"),
            Parameter("float", "float_", "scalar", description="Four bytes.", facts=("Unit: 1.",), scalar="float", units=("1",)),
            Parameter("double", "double", "scalar", description="Eight bytes.", facts=("Unit: 1.",), scalar="double", units=("1",)),
            Parameter("bool", "bool_", "scalar", description="True or false.", scalar="bool"),
            Parameter("char", "char", "scalar", description="One character.", scalar="char"),
        ),
    ),
    "Strings": FieldInfo(
        "measurements.strings", type=measurements.Strings,
        title="Strings",
        description="Fixed, counted, and to the end.",
        facts=("Supported by Model A and Model C.",),
        sources=("guide: Strings",),
        devices=("model-a", "model-c"),
        parameters=(
            Parameter("model", "model", "text", description="Padded with spaces.", scalar="char", length=16),
            Parameter("length", "length", "counter", description="Of the name.", facts=("The number of elements of `name`.",), scalar="u8", counts="name"),
            Parameter("name", "name", "text", description="The name.", scalar="char", length="length"),
            Parameter("rest", "rest", "text", description="All that follows.", scalar="char", length="rest"),
        ),
    ),
    "Health": FieldInfo(
        "measurements.health", type=measurements.Health,
        title="Health",
        description="The wide bitfield.",
        facts=("Deprecated: use `measurements.Numbers` instead.", "Supported by Model A and Model C."),
        sources=("guide: Health",),
        devices=("model-a", "model-c"),
        deprecated="use `measurements.Numbers` instead",
        parameters=(
            Parameter("result", "result", "bits", description="The bits.", scalar="bits", size=16, type=types.Health),
            Parameter("code", "code", "scalar", description="An enumeration over four bytes.", scalar="u32", type=types.WideCode),
        ),
    ),
    "Arrays": FieldInfo(
        "measurements.arrays", type=measurements.Arrays,
        title="Arrays",
        description="Arrays of all that can stand in one.",
        facts=("Supported by Model A and Model C.",),
        sources=("guide: Arrays",),
        devices=("model-a", "model-c"),
        parameters=(
            Parameter("modes", "modes", "array", description="Enumerations.", scalar="u8", length=3, type=types.Mode),
            Parameter("flags", "flags", "array", description="Bitfields.", scalar="u16", length=2, type=types.StateFlags),
            Parameter("vectors", "vectors", "array", description="Vectors.", facts=("Elements: x, y, z.", "Unit: m."), scalar="float", elements=("x", "y", "z"), length=2, units=("m",)),
            Parameter("points", "points", "array", description="Structures.", facts=("Unit: m.",), length=2, units=("m",), type=types.Point),
            Parameter("track", "track", "struct", description="A nested structure.", type=types.Segment),
            Parameter("offsets", "offsets", "array", facts=("Reserved.",), scalar="s8", length=4, reserved=True, default=0),
        ),
    ),
    "Growing": FieldInfo(
        "measurements.growing", type=measurements.Growing,
        title="Growing",
        description="Newer devices send more of it.",
        facts=("Supported by Model A and Model C.",),
        sources=("guide: Growing",),
        devices=("model-a", "model-c"),
        parameters=(
            Parameter("first", "first", "scalar", description="Always there.", scalar="u16"),
            Parameter("second", "second", "scalar", description="From version 2 on.", facts=("Optional.",), scalar="u16", optional=True),
            Parameter("third", "third", "scalar", description="From version 3 on.", facts=("Unit: deg.", "Optional."), scalar="float", units=("deg",), optional=True),
        ),
    ),
    "Radio": FieldInfo(
        "measurements.radio", type=measurements.Radio,
        title="Radio",
        description="A bool vouches for values; one source has no layout that agrees with it.",
        facts=("Also called `modem` and `rf`.", "Supported by Model C.", "Known only from the Kit of names.", "Uncertain: The leaflet gives the strength two bytes.", "Uncertain: Inferred: the strength is never positive."),
        sources=("sheet: Radio",),
        also=("modem", "rf"),
        devices=("model-c",),
        parameters=(
            Parameter("connected", "connected", "scalar", description="Whether there is a connection.", scalar="bool"),
            Parameter("strength", "strength", "scalar", description="Of the signal.", facts=("Range: less than 1.", "Valid if `connected` is true.", "Uncertain: Its unit."), scalar="s32", valid=("connected",), below=1, flags=(Flag("connected", "connected", 0x0),)),
            Parameter("noise", "noise", "scalar", description="Never nothing.", facts=("Unit: m.", "Range: greater than 0, at most 10.", "Valid if `connected` is true.", "On the Model C: valid if `connected` is true; deprecated."), scalar="float", units=("m",), valid=("connected",), maximum=10, above=0, flags=(Flag("connected", "connected", 0x0),), variants=(Variant("device", ("model-c",), "On the Model C: valid if `connected` is true; deprecated.", {"valid": ("connected",), "deprecated": True}),)),
            Parameter("gap", "gap", "scalar", description="Reserved.", facts=("Reserved.",), scalar="float", reserved=True, default=0.0),
            Parameter("gaps", "gaps", "array", facts=("Reserved.",), scalar="double", length=2, reserved=True, default=0.0),
        ),
    ),
    "Cloud": FieldInfo(
        "measurements.cloud", type=measurements.Cloud,
        title="Cloud",
        description="The count can exceed what a field holds beside the value behind the array.",
        facts=("Supported by Model A and Model C.",),
        sources=("guide: Cloud",),
        devices=("model-a", "model-c"),
        parameters=(
            Parameter("num_points", "num_points", "counter", description="Number of points.", facts=("The number of elements of `points`.",), scalar="u8", counts="points"),
            Parameter("points", "points", "array", description="The points.", length="num_points", type=types.Point),
            Parameter("stamp", "stamp", "scalar", description="Behind an array that fills the field.", facts=("Unit: s.",), scalar="u64", units=("s",)),
        ),
    ),
    "Gust": FieldInfo(
        "measurements.gust", type=measurements.Gust,
        title="Gust",
        description="One valid flag for all values but one; `measurements.Breeze` has the same place.",
        facts=("Not listed in any device profile.", "`speed * 3.6` is in km/h, and `valid_flags` tells whether `speed` counts; see `types.Mode` and `tools.Shape`."),
        sources=("guide: Gust",),
        parameters=(
            Parameter("station", "station", "scalar", description="Which one.", scalar="u8"),
            Parameter("place", "place", "struct", description="Where it was measured.", facts=("Valid if `types.StateFlags.READY` of `valid_flags` is set.",), valid=("valid_flags.ready",), type=types.Point, flags=(Flag("valid_flags.ready", "valid_flags", 0x1),)),
            Parameter("height", "height", "scalar", description="Above the plane.", facts=("Unit: m.", "Valid if `types.StateFlags.READY` of `valid_flags` is set."), scalar="float", units=("m",), valid=("valid_flags.ready",), flags=(Flag("valid_flags.ready", "valid_flags", 0x1),)),
            Parameter("speed", "speed", "array", description="Of the wind.", facts=("Elements: x, y, z.", "Unit: m.", "Range: magnitude at most 40.", "Valid if `types.StateFlags.READY` of `valid_flags` is set."), scalar="float", elements=("x", "y", "z"), units=("m",), valid=("valid_flags.ready",), magnitude=(None, 40), flags=(Flag("valid_flags.ready", "valid_flags", 0x1),)),
            Parameter("gap", "gap", "constant", description="Always the same.", facts=("Always 7.",), scalar="u8", constant=7),
            Parameter("valid_flags", "valid_flags", "scalar", description="What is valid.", scalar="u16", type=types.StateFlags),
        ),
    ),
    "Breeze": FieldInfo(
        "measurements.breeze", type=measurements.Breeze,
        title="Breeze",
        description="Its place is told as in `measurements.Gust`.",
        facts=("Supported by Model A and Model C.",),
        sources=("guide: Breeze",),
        devices=("model-a", "model-c"),
        parameters=(
            Parameter("place", "place", "struct", description="Where it was measured.", type=types.Point),
            Parameter("height", "height", "scalar", description="Above the plane.", facts=("Unit: m.",), scalar="float", units=("m",)),
            Parameter("turn", "turn", "array", description="Of the vane.", facts=("Elements: w, x, y, z.", "Unit: 1.", "Range: -1 to 1, magnitude 0.5 to 1.5.", "Default: 1, 0, 0, 0."), scalar="float", elements=("w", "x", "y", "z"), units=("1",), minimum=-1, maximum=1, magnitude=(0.5, 1.5), default=(1, 0, 0, 0)),
        ),
    ),
}
