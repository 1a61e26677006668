"""The meaning of the types of `measurements`."""

from __future__ import annotations

from .. import measurements, types
from ..info import FieldInfo, Info
from ..parameter import Flag, Parameter, Variant

# fmt: off

#: Class -> its description.
TYPES: dict[str, Info] = {
    "Accel": FieldInfo(
        "measurements.accel", measurements.Accel, devices=("model-a", "model-b", "model-c"), max_rate=100,
        parameters=(
            Parameter("scaled_accel", "scaled_accel", "array", scalar="float", elements=("x", "y", "z"), units=("g",), valid=("valid_flags.ready", "valid_flags.hot", "valid_flags.ready"), frame="sensor", flags=(Flag("valid_flags.ready", "valid_flags", 0x1), Flag("valid_flags.hot", "valid_flags", 0x2), Flag("valid_flags.ready", "valid_flags", 0x1)), variants=(Variant("device", ("model-b",), {"units": ("m", "m", "s"), "frame": "ned", "valid": ("valid_flags.hot", "valid_flags.ready", "valid_flags.hot")}), Variant("device", ("model-c",), {"valid": ()}),), flags_on={"model-b": (Flag("valid_flags.hot", "valid_flags", 0x2), Flag("valid_flags.ready", "valid_flags", 0x1), Flag("valid_flags.hot", "valid_flags", 0x2)), "model-c": ()}),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=types.StateFlags, variants=(Variant("device", ("model-c",), {"only": ("ready", "level")}),)),
        ),
    ),
    "Numbers": FieldInfo(
        "measurements.numbers", measurements.Numbers, devices=("model-a", "model-c"), perhaps=("old-1", "old-2"),
        parameters=(
            Parameter("u8", "u8", "scalar", scalar="u8"),
            Parameter("u16", "u16", "scalar", scalar="u16"),
            Parameter("u32", "u32", "scalar", scalar="u32"),
            Parameter("u64", "u64", "scalar", scalar="u64"),
            Parameter("s8", "s8", "scalar", scalar="s8"),
            Parameter("s16", "s16", "scalar", scalar="s16"),
            Parameter("s32", "s32", "scalar", scalar="s32"),
            Parameter("s64", "s64", "scalar", scalar="s64"),
            Parameter("float", "float_", "scalar", scalar="float", units=("1",)),
            Parameter("double", "double", "scalar", scalar="double", units=("1",)),
            Parameter("bool", "bool_", "scalar", scalar="bool"),
            Parameter("char", "char", "scalar", scalar="char"),
        ),
    ),
    "Strings": FieldInfo(
        "measurements.strings", measurements.Strings, devices=("model-a", "model-c"),
        parameters=(
            Parameter("model", "model", "text", scalar="char", length=16),
            Parameter("length", "length", "counter", scalar="u8", counts="name"),
            Parameter("name", "name", "text", scalar="char", length="length"),
            Parameter("rest", "rest", "text", scalar="char", length="rest"),
        ),
    ),
    "Health": FieldInfo(
        "measurements.health", measurements.Health, devices=("model-a", "model-c"), deprecated=True,
        parameters=(
            Parameter("result", "result", "bits", scalar="bits", size=16, type=types.Health),
            Parameter("code", "code", "scalar", scalar="u32", type=types.WideCode),
        ),
    ),
    "Arrays": FieldInfo(
        "measurements.arrays", measurements.Arrays, devices=("model-a", "model-c"),
        parameters=(
            Parameter("modes", "modes", "array", scalar="u8", length=3, type=types.Mode),
            Parameter("flags", "flags", "array", scalar="u16", length=2, type=types.StateFlags),
            Parameter("vectors", "vectors", "array", scalar="float", elements=("x", "y", "z"), length=2, units=("m",)),
            Parameter("points", "points", "array", length=2, units=("m",), type=types.Point),
            Parameter("track", "track", "struct", type=types.Segment),
            Parameter("offsets", "offsets", "array", scalar="s8", length=4, reserved=True, default=0),
        ),
    ),
    "Growing": FieldInfo(
        "measurements.growing", measurements.Growing, devices=("model-a", "model-c"),
        parameters=(
            Parameter("first", "first", "scalar", scalar="u16"),
            Parameter("second", "second", "scalar", scalar="u16", optional=True),
            Parameter("third", "third", "scalar", scalar="float", units=("deg",), optional=True),
        ),
    ),
    "Radio": FieldInfo(
        "measurements.radio", measurements.Radio, devices=("model-c",),
        parameters=(
            Parameter("connected", "connected", "scalar", scalar="bool"),
            Parameter("strength", "strength", "scalar", scalar="s32", valid=("connected",), below=1, flags=(Flag("connected", "connected", 0x0),)),
            Parameter("noise", "noise", "scalar", scalar="float", units=("m",), valid=("connected",), maximum=10, above=0, flags=(Flag("connected", "connected", 0x0),), variants=(Variant("device", ("model-c",), {"valid": ("connected",), "deprecated": True}),)),
            Parameter("gap", "gap", "scalar", scalar="float", reserved=True, default=0.0),
            Parameter("gaps", "gaps", "array", scalar="double", length=2, reserved=True, default=0.0),
        ),
    ),
    "Own": FieldInfo(
        "measurements.own", measurements.Own, devices=("model-a", "model-c"),
        parameters=(
            Parameter("mode", "mode", "scalar", scalar="u8", type=types.Mode),
        ),
    ),
    "Cloud": FieldInfo(
        "measurements.cloud", measurements.Cloud, devices=("model-a", "model-c"),
        parameters=(
            Parameter("num_points", "num_points", "counter", scalar="u8", counts="points"),
            Parameter("points", "points", "array", length="num_points", type=types.Point),
            Parameter("stamp", "stamp", "scalar", scalar="u64", units=("s",)),
        ),
    ),
    "Gust": FieldInfo(
        "measurements.gust", measurements.Gust,
        parameters=(
            Parameter("station", "station", "scalar", scalar="u8"),
            Parameter("place", "place", "struct", valid=("valid_flags.ready",), type=types.Point, flags=(Flag("valid_flags.ready", "valid_flags", 0x1),)),
            Parameter("height", "height", "scalar", scalar="float", units=("m",), valid=("valid_flags.ready",), flags=(Flag("valid_flags.ready", "valid_flags", 0x1),)),
            Parameter("speed", "speed", "array", scalar="float", elements=("x", "y", "z"), units=("m",), valid=("valid_flags.ready",), magnitude=(None, 40), flags=(Flag("valid_flags.ready", "valid_flags", 0x1),)),
            Parameter("gap", "gap", "constant", scalar="u8", constant=7),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=types.StateFlags),
        ),
    ),
    "Breeze": FieldInfo(
        "measurements.breeze", measurements.Breeze, devices=("model-a", "model-c"),
        parameters=(
            Parameter("place", "place", "struct", type=types.Point),
            Parameter("height", "height", "scalar", scalar="float", units=("m",)),
            Parameter("turn", "turn", "array", scalar="float", elements=("w", "x", "y", "z"), units=("1",), minimum=-1, maximum=1, magnitude=(0.5, 1.5), default=(1, 0, 0, 0)),
        ),
    ),
}
