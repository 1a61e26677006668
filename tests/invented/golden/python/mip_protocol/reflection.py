"""What fields are made of, for tools that treat all of them alike.

Importing this module imports all descriptor sets.
"""

from __future__ import annotations

from . import copy, measurements, mip_3d, more, protocol, shared, tools, types
from .parameter import Parameter

__all__ = ["PARAMETERS", "Parameter"]

#: Fields and structures -> their parameters.
PARAMETERS: dict[type, tuple[Parameter, ...]] = {
    protocol.Acknowledge: (
        Parameter("command", "command", "scalar", scalar="u8"),
        Parameter("code", "code", "scalar", scalar="u8", type=types.AckCode),
    ),
    types.Point: (
        Parameter("x", "x", "scalar", scalar="s16", units=("m",)),
        Parameter("y", "y", "scalar", scalar="s16", units=("m",)),
    ),
    types.Segment: (
        Parameter("from", "from_", "struct", type=types.Point),
        Parameter("to", "to", "struct", type=types.Point),
        Parameter("weights", "weights", "array", scalar="u8", length=2),
    ),
    tools.Stripes: (
        Parameter("width", "width", "scalar", scalar="double", units=("m",)),
        Parameter(
            "angle", "angle", "scalar", scalar="float", units=("deg",), minimum=-180, maximum=180
        ),
    ),
    tools.Circle: (
        Parameter("center", "center", "struct", type=types.Point),
        Parameter("fill", "fill", "scalar", scalar="u8", type=tools.Fill),
        Parameter(
            "filling",
            "filling",
            "switch",
            tag="fill",
            cases={
                0: None,
                1: Parameter("solid", "solid", "scalar", scalar="u32"),
                2: Parameter("striped", "striped", "struct", type=tools.Stripes),
            },
        ),
    ),
    tools.Path: (
        Parameter("closed", "closed", "scalar", scalar="bool"),
        Parameter("num_points", "num_points", "counter", scalar="u8", counts="points"),
        Parameter("points", "points", "array", length="num_points", type=types.Point),
    ),
    tools.Reading: (
        Parameter("kind", "kind", "scalar", scalar="u8"),
        Parameter("value", "value", "scalar", scalar="float"),
    ),
    tools.Ping: (),
    tools.Settings: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("port", "port", "scalar", scalar="u8", minimum=0, maximum=8),
        Parameter("mode", "mode", "scalar", scalar="u8", default=1, type=types.Mode),
        Parameter("baud", "baud", "scalar", scalar="u32", units=("Bd",), default=115200),
        Parameter("limit", "limit", "scalar", scalar="u16"),
        Parameter("reserved", "reserved", "scalar", scalar="u8", default=1),
    ),
    tools.SetTime: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("part", "part", "scalar", scalar="u8", type=types.Mode),
        Parameter("value", "value", "scalar", scalar="u32", units=("s",)),
    ),
    tools.Status: (
        Parameter("model", "model", "constant", scalar="u16", constant=4711),
        Parameter("selector", "selector", "scalar", scalar="u8", minimum=1, maximum=2),
    ),
    tools.Bias: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter(
            "bias",
            "bias",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("g",),
            frame="sensor",
        ),
    ),
    tools.CaptureBias: (
        Parameter("time", "time", "scalar", scalar="u16", units=("s",), minimum=1, maximum=30),
    ),
    tools.Formats: (
        Parameter("suppress_ack", "suppress_ack", "scalar", scalar="bool"),
        Parameter("num_segments", "num_segments", "counter", scalar="u8", counts="segments"),
        Parameter("checkpoint", "checkpoint", "scalar", scalar="u8"),
        Parameter("segments", "segments", "array", length="num_segments", type=types.Segment),
    ),
    tools.Choice: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("instance", "instance", "scalar", scalar="u8"),
        Parameter("shape", "shape", "scalar", scalar="u8", type=tools.Shape),
        Parameter(
            "parameters",
            "parameters",
            "switch",
            tag="shape",
            cases={
                0: None,
                1: Parameter("circle", "circle", "struct", type=tools.Circle),
                2: Parameter("path", "path", "struct", type=tools.Path),
                3: Parameter(
                    "rotation",
                    "rotation",
                    "array",
                    scalar="float",
                    elements=("w", "x", "y", "z"),
                    units=("1",),
                ),
                4: Parameter("label", "label", "text", scalar="char", length=8),
            },
        ),
    ),
    tools.List: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("count", "count", "counter", scalar="u8", counts="items"),
        Parameter("items", "items", "array", scalar="u16", length="count"),
    ),
    tools.Inventory: (),
    tools.Pin: (
        Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        Parameter("drive", "drive", "scalar", scalar="u8", type=tools.Drive),
        Parameter("use", "use", "scalar", scalar="u8"),
    ),
    tools.Hello: (
        Parameter("reserved", "reserved", "scalar", scalar="float", default=1.0),
        Parameter("later", "later", "array", scalar="double", length=2, default=0.0),
    ),
    tools.Readings: (Parameter("drive", "drive", "scalar", scalar="u8", type=tools.Drive),),
    tools.SettingsResponse: (
        Parameter("port", "port", "scalar", scalar="u8", minimum=0, maximum=8),
        Parameter("mode", "mode", "scalar", scalar="u8", default=1, type=types.Mode),
        Parameter("baud", "baud", "scalar", scalar="u32", units=("Bd",), default=115200),
        Parameter("limit", "limit", "scalar", scalar="u16"),
        Parameter("reserved", "reserved", "scalar", scalar="u8", default=1),
    ),
    tools.SetTimeFastResponse: (Parameter("value", "value", "scalar", scalar="u32", units=("s",)),),
    tools.SetTimeSlowResponse: (Parameter("value", "value", "scalar", scalar="u32", units=("s",)),),
    tools.ChoiceResponse: (
        Parameter("instance", "instance", "scalar", scalar="u8"),
        Parameter("shape", "shape", "scalar", scalar="u8", type=tools.Shape),
        Parameter(
            "parameters",
            "parameters",
            "switch",
            tag="shape",
            cases={
                0: None,
                1: Parameter("circle", "circle", "struct", type=tools.Circle),
                2: Parameter("path", "path", "struct", type=tools.Path),
                3: Parameter(
                    "rotation",
                    "rotation",
                    "array",
                    scalar="float",
                    elements=("w", "x", "y", "z"),
                    units=("1",),
                ),
                4: Parameter("label", "label", "text", scalar="char", length=8),
            },
        ),
    ),
    tools.ListResponse: (
        Parameter("count", "count", "counter", scalar="u8", counts="items"),
        Parameter("items", "items", "array", scalar="u16", length="count"),
    ),
    tools.InventoryResponse: (
        Parameter("descriptors", "descriptors", "array", scalar="u16", length="rest"),
    ),
    tools.PinResponse: (
        Parameter("drive", "drive", "scalar", scalar="u8", type=tools.Drive),
        Parameter("use", "use", "scalar", scalar="u8"),
    ),
    tools.HelloResponse: (Parameter("seen", "seen", "scalar", scalar="u32", units=("s",)),),
    tools.ReadingsResponse: (
        Parameter("drive", "drive", "scalar", scalar="u8", type=tools.Drive),
        Parameter("count", "count", "counter", scalar="u8", counts="readings"),
        Parameter("readings", "readings", "array", length="count", type=tools.Reading),
        Parameter("last", "last", "struct", type=tools.Reading),
    ),
    tools.StatusShort: (
        Parameter("model", "model", "constant", scalar="u16", constant=4711),
        Parameter("selector", "selector", "constant", scalar="u8", constant=1),
        Parameter("flags", "flags", "scalar", scalar="u32"),
    ),
    tools.StatusLong: (
        Parameter("model", "model", "constant", scalar="u16", constant=4711),
        Parameter("selector", "selector", "constant", scalar="u8", constant=2),
        Parameter("flags", "flags", "scalar", scalar="u32"),
        Parameter("uptime", "uptime", "scalar", scalar="u64", units=("s",)),
    ),
    tools.StatusOld: (
        Parameter("model", "model", "constant", scalar="u16", constant=4711),
        Parameter("selector", "selector", "constant", scalar="u8", constant=2),
        Parameter("uptime", "uptime", "scalar", scalar="u32", units=("s",)),
    ),
    tools.StatusFull: (
        Parameter("model", "model", "constant", scalar="u16", constant=4711),
        Parameter("selector", "selector", "constant", scalar="u8", constant=2),
        Parameter("place", "place", "struct", type=types.Point),
        Parameter("uptime", "uptime", "scalar", scalar="u64", units=("s",)),
        Parameter("mode", "mode", "scalar", scalar="u8", type=types.Mode),
    ),
    tools.BiasVector: (
        Parameter(
            "bias",
            "bias",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("g",),
            frame="sensor",
        ),
    ),
    mip_3d.Default: (
        Parameter("class", "class_", "scalar", scalar="u8"),
        Parameter("type", "type", "scalar", scalar="u8"),
        Parameter("register", "register", "scalar", scalar="u8"),
        Parameter("self", "self_", "scalar", scalar="u8"),
        Parameter("present", "present", "scalar", scalar="u8"),
    ),
    measurements.Accel: (
        Parameter(
            "scaled_accel",
            "scaled_accel",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("g",),
            valid=("valid_flags.ready", "valid_flags.hot", "valid_flags.ready"),
            frame="sensor",
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=types.StateFlags),
    ),
    measurements.Numbers: (
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
    measurements.Strings: (
        Parameter("model", "model", "text", scalar="char", length=16),
        Parameter("length", "length", "counter", scalar="u8", counts="name"),
        Parameter("name", "name", "text", scalar="char", length="length"),
        Parameter("rest", "rest", "text", scalar="char", length="rest"),
    ),
    measurements.Health: (
        Parameter("result", "result", "bits", scalar="bits", size=16, type=types.Health),
        Parameter("code", "code", "scalar", scalar="u32", type=types.WideCode),
    ),
    measurements.Arrays: (
        Parameter("modes", "modes", "array", scalar="u8", length=3, type=types.Mode),
        Parameter("flags", "flags", "array", scalar="u16", length=2, type=types.StateFlags),
        Parameter(
            "vectors",
            "vectors",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            length=2,
            units=("m",),
        ),
        Parameter("points", "points", "array", length=2, units=("m",), type=types.Point),
        Parameter("track", "track", "struct", type=types.Segment),
        Parameter("offsets", "offsets", "array", scalar="s8", length=4, default=0),
    ),
    measurements.Growing: (
        Parameter("first", "first", "scalar", scalar="u16"),
        Parameter("second", "second", "scalar", scalar="u16"),
        Parameter("third", "third", "scalar", scalar="float", units=("deg",)),
    ),
    measurements.Radio: (
        Parameter("connected", "connected", "scalar", scalar="bool"),
        Parameter("strength", "strength", "scalar", scalar="s32", valid=("connected",), below=1),
        Parameter(
            "noise",
            "noise",
            "scalar",
            scalar="float",
            units=("m",),
            valid=("connected",),
            maximum=10,
            above=0,
        ),
        Parameter("gap", "gap", "scalar", scalar="float", default=0.0),
        Parameter("gaps", "gaps", "array", scalar="double", length=2, default=0.0),
    ),
    measurements.Cloud: (
        Parameter("num_points", "num_points", "counter", scalar="u8", counts="points"),
        Parameter("points", "points", "array", length="num_points", type=types.Point),
        Parameter("stamp", "stamp", "scalar", scalar="u64", units=("s",)),
    ),
    measurements.Gust: (
        Parameter("station", "station", "scalar", scalar="u8"),
        Parameter("place", "place", "struct", valid=("valid_flags.ready",), type=types.Point),
        Parameter(
            "height", "height", "scalar", scalar="float", units=("m",), valid=("valid_flags.ready",)
        ),
        Parameter(
            "speed",
            "speed",
            "array",
            scalar="float",
            elements=("x", "y", "z"),
            units=("m",),
            valid=("valid_flags.ready",),
            magnitude=(None, 40),
        ),
        Parameter("gap", "gap", "constant", scalar="u8", constant=7),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=types.StateFlags),
    ),
    measurements.Breeze: (
        Parameter("place", "place", "struct", type=types.Point),
        Parameter("height", "height", "scalar", scalar="float", units=("m",)),
        Parameter(
            "turn",
            "turn",
            "array",
            scalar="float",
            elements=("w", "x", "y", "z"),
            units=("1",),
            minimum=-1,
            maximum=1,
            magnitude=(0.5, 1.5),
            default=(1, 0, 0, 0),
        ),
    ),
    more.Own: (Parameter("mode", "mode", "scalar", scalar="u8", type=types.Mode),),
    shared.Timestamp: (
        Parameter(
            "tow", "tow", "scalar", scalar="double", units=("s",), valid=("valid_flags.ready",)
        ),
        Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=types.StateFlags),
    ),
}

PARAMETERS[more.Accel] = PARAMETERS[measurements.Accel]
PARAMETERS[more.Strings] = PARAMETERS[measurements.Strings]
PARAMETERS[copy.Accel] = PARAMETERS[measurements.Accel]
PARAMETERS[copy.Numbers] = PARAMETERS[measurements.Numbers]
PARAMETERS[copy.Strings] = PARAMETERS[measurements.Strings]
PARAMETERS[copy.Health] = PARAMETERS[measurements.Health]
PARAMETERS[copy.Arrays] = PARAMETERS[measurements.Arrays]
PARAMETERS[copy.Growing] = PARAMETERS[measurements.Growing]
PARAMETERS[copy.Radio] = PARAMETERS[measurements.Radio]
PARAMETERS[copy.Cloud] = PARAMETERS[measurements.Cloud]
PARAMETERS[copy.Gust] = PARAMETERS[measurements.Gust]
PARAMETERS[copy.Breeze] = PARAMETERS[measurements.Breeze]
