"""The meaning of the types of `tools`."""

from __future__ import annotations

from .. import protocol, tools, types
from ..info import BitsInfo, EnumInfo, FieldInfo, Info, StructureInfo
from ..parameter import Parameter, Variant

# fmt: off

#: Class -> its description.
TYPES: dict[str, Info] = {
    "Shape": EnumInfo("tools.shape", tools.Shape),
    "Fill": EnumInfo("tools.fill", tools.Fill),
    "Stripes": StructureInfo("tools.stripes", tools.Stripes, (
            Parameter("width", "width", "scalar", scalar="double", units=("m",)),
            Parameter("angle", "angle", "scalar", scalar="float", units=("deg",), minimum=-180, maximum=180),
        )),
    "Circle": StructureInfo("tools.circle", tools.Circle, (
            Parameter("center", "center", "struct", type=types.Point),
            Parameter("fill", "fill", "scalar", scalar="u8", type=tools.Fill),
            Parameter("filling", "filling", "switch", tag="fill", cases={0: None, 1: Parameter("solid", "solid", "scalar", scalar="u32"), 2: Parameter("striped", "striped", "struct", type=tools.Stripes), }),
        )),
    "Path": StructureInfo("tools.path", tools.Path, (
            Parameter("closed", "closed", "scalar", scalar="bool"),
            Parameter("num_points", "num_points", "counter", scalar="u8", counts="points"),
            Parameter("points", "points", "array", length="num_points", type=types.Point),
        )),
    "Drive": EnumInfo("tools.drive", tools.Drive),
    "PulseUse": EnumInfo("tools.pulse_use", tools.PulseUse),
    "SerialUse": EnumInfo("tools.serial_use", tools.SerialUse),
    "Reading": StructureInfo("tools.reading", tools.Reading, (
            Parameter("kind", "kind", "scalar", scalar="u8"),
            Parameter("value", "value", "scalar", scalar="float"),
        )),
    "ModelAFaults": BitsInfo("tools.model_a_faults", tools.ModelAFaults, concerns={"sensor": ("measurements.accel", "tools.capture_bias")}),
    "ModelBFaults": BitsInfo("tools.model_b_faults", tools.ModelBFaults),
    "Ping": FieldInfo(
        "tools.ping", tools.Ping, devices=("model-a", "model-b", "model-c", "old-1"), perhaps=("old-2",),
        parameters=(
        ),
    ),
    "Settings": FieldInfo(
        "tools.settings", tools.Settings, functions=("write", "read", "save", "load", "default", "apply"), devices=("model-a", "model-b", "model-c"),
        parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("port", "port", "scalar", scalar="u8", maximum=8, required=("write", "read", "save", "load", "default", "apply"), minimum=0),
            Parameter("mode", "mode", "scalar", scalar="u8", default=1, required=("write", "read", "apply"), type=types.Mode, variants=(Variant("device", ("model-c",), {"only": ("default", "fast"), "deprecated": False}),)),
            Parameter("baud", "baud", "scalar", scalar="u32", units=("Bd",), default=115200, required=("write", "apply")),
            Parameter("limit", "limit", "scalar", scalar="u16", optional=True, variants=(Variant("mode", (1,), {"units": ("s",), "minimum": 1, "maximum": 10, "default": 5}), Variant("mode", (2,), {"units": ("m",)}),)),
            Parameter("reserved", "reserved", "scalar", scalar="u8", default=1, optional=True, reserved=True),
        ),
    ),
    "SetTime": FieldInfo(
        "tools.set_time", tools.SetTime, functions=("write", "read", "apply"), devices=("model-a", "model-c"),
        parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("part", "part", "scalar", scalar="u8", required=("write", "read", "apply"), type=types.Mode),
            Parameter("value", "value", "scalar", scalar="u32", units=("s",), required=("write", "apply")),
        ),
    ),
    "Status": FieldInfo(
        "tools.status", tools.Status, devices=("model-a", "model-b", "model-c"), advanced=True,
        parameters=(
            Parameter("model", "model", "constant", scalar="u16", constant=4711),
            Parameter("selector", "selector", "scalar", scalar="u8", minimum=1, maximum=2, variants=(Variant("device", ("model-c",), {"constant": 2}),)),
        ),
    ),
    "Bias": FieldInfo(
        "tools.bias", tools.Bias, functions=("write", "read", "save", "load", "default"), devices=("model-a", "model-c"),
        parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("bias", "bias", "array", scalar="float", elements=("x", "y", "z"), units=("g",), frame="sensor", required=("write",)),
        ),
    ),
    "CaptureBias": FieldInfo(
        "tools.capture_bias", tools.CaptureBias, devices=("model-a", "model-c"),
        parameters=(
            Parameter("time", "time", "scalar", scalar="u16", units=("s",), minimum=1, maximum=30),
        ),
    ),
    "Formats": FieldInfo(
        "tools.formats", tools.Formats, devices=("model-a", "model-c"),
        parameters=(
            Parameter("suppress_ack", "suppress_ack", "scalar", scalar="bool"),
            Parameter("num_segments", "num_segments", "counter", scalar="u8", counts="segments"),
            Parameter("checkpoint", "checkpoint", "scalar", scalar="u8", deprecated=True),
            Parameter("segments", "segments", "array", length="num_segments", type=types.Segment),
        ),
    ),
    "Choice": FieldInfo(
        "tools.choice", tools.Choice, functions=("write", "read"), devices=("model-a",),
        parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("instance", "instance", "scalar", scalar="u8", required=("write", "read")),
            Parameter("shape", "shape", "scalar", scalar="u8", required=("write",), type=tools.Shape),
            Parameter("parameters", "parameters", "switch", tag="shape", required=("write",), cases={0: None, 1: Parameter("circle", "circle", "struct", type=tools.Circle), 2: Parameter("path", "path", "struct", type=tools.Path), 3: Parameter("rotation", "rotation", "array", scalar="float", elements=("w", "x", "y", "z"), units=("1",)), 4: Parameter("label", "label", "text", scalar="char", length=8), }),
        ),
    ),
    "List": FieldInfo(
        "tools.list", tools.List, functions=("write", "read", "save"), devices=("model-a", "model-c"),
        parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("count", "count", "counter", scalar="u8", counts="items", required=("write",)),
            Parameter("items", "items", "array", scalar="u16", length="count", required=("write",)),
        ),
    ),
    "Inventory": FieldInfo(
        "tools.inventory", tools.Inventory, devices=("model-a", "model-c"),
        parameters=(
        ),
    ),
    "Pin": FieldInfo(
        "tools.pin", tools.Pin, functions=("write", "read"), devices=("model-a", "model-c"),
        parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("drive", "drive", "scalar", scalar="u8", required=("write", "read"), type=tools.Drive),
            Parameter("use", "use", "scalar", scalar="u8", required=("write",), variants=(Variant("drive", (1,), {"type": tools.PulseUse}), Variant("drive", (2,), {"type": tools.SerialUse}),)),
        ),
    ),
    "Hello": FieldInfo(
        "tools.hello", tools.Hello, perhaps=("model-c",),
        parameters=(
            Parameter("reserved", "reserved", "scalar", scalar="float", default=1.0, reserved=True),
            Parameter("later", "later", "array", scalar="double", length=2, optional=True, reserved=True, default=0.0),
        ),
    ),
    "Readings": FieldInfo(
        "tools.readings", tools.Readings, devices=("model-a", "model-c"),
        parameters=(
            Parameter("drive", "drive", "scalar", scalar="u8", type=tools.Drive),
        ),
    ),
    "Poll": FieldInfo(
        "tools.poll", tools.Poll, devices=("model-c",),
        parameters=(
            Parameter("descriptor_set", "descriptor_set", "scalar", scalar="u8", minimum=128, maximum=254, refers="set"),
            Parameter("first", "first", "scalar", scalar="u8", default=1, refers="field", fields_of="measurements"),
            Parameter("count", "count", "counter", scalar="u8", counts="descriptors"),
            Parameter("descriptors", "descriptors", "array", scalar="u8", length="count", refers="field", fields_of="descriptor_set"),
        ),
    ),
    "SettingsResponse": FieldInfo(
        "tools.settings_response", tools.SettingsResponse, devices=("model-a", "model-b", "model-c"),
        parameters=(
            Parameter("port", "port", "scalar", scalar="u8", maximum=8, minimum=0),
            Parameter("mode", "mode", "scalar", scalar="u8", default=1, type=types.Mode),
            Parameter("baud", "baud", "scalar", scalar="u32", units=("Bd",), default=115200),
            Parameter("limit", "limit", "scalar", scalar="u16", variants=(Variant("mode", (1,), {"units": ("s",), "minimum": 1, "maximum": 10, "default": 5}), Variant("mode", (2,), {"units": ("m",)}),)),
            Parameter("reserved", "reserved", "scalar", scalar="u8", default=1, reserved=True),
        ),
    ),
    "SetTimeFastResponse": FieldInfo(
        "tools.set_time_fast_response", tools.SetTimeFastResponse, devices=("model-a", "model-c"),
        parameters=(
            Parameter("value", "value", "scalar", scalar="u32", units=("s",)),
        ),
    ),
    "SetTimeSlowResponse": FieldInfo(
        "tools.set_time_slow_response", tools.SetTimeSlowResponse, devices=("model-a", "model-c"),
        parameters=(
            Parameter("value", "value", "scalar", scalar="u32", units=("s",)),
        ),
    ),
    "ChoiceResponse": FieldInfo(
        "tools.choice_response", tools.ChoiceResponse, devices=("model-a",),
        parameters=(
            Parameter("instance", "instance", "scalar", scalar="u8"),
            Parameter("shape", "shape", "scalar", scalar="u8", type=tools.Shape),
            Parameter("parameters", "parameters", "switch", tag="shape", cases={0: None, 1: Parameter("circle", "circle", "struct", type=tools.Circle), 2: Parameter("path", "path", "struct", type=tools.Path), 3: Parameter("rotation", "rotation", "array", scalar="float", elements=("w", "x", "y", "z"), units=("1",)), 4: Parameter("label", "label", "text", scalar="char", length=8), }),
        ),
    ),
    "ListResponse": FieldInfo(
        "tools.list_response", tools.ListResponse, devices=("model-a", "model-c"),
        parameters=(
            Parameter("count", "count", "counter", scalar="u8", counts="items"),
            Parameter("items", "items", "array", scalar="u16", length="count"),
        ),
    ),
    "InventoryResponse": FieldInfo(
        "tools.inventory_response", tools.InventoryResponse, devices=("model-a", "model-c"),
        parameters=(
            Parameter("descriptors", "descriptors", "array", scalar="u16", length="rest"),
        ),
    ),
    "PinResponse": FieldInfo(
        "tools.pin_response", tools.PinResponse, devices=("model-a", "model-c"),
        parameters=(
            Parameter("drive", "drive", "scalar", scalar="u8", type=tools.Drive),
            Parameter("use", "use", "scalar", scalar="u8", variants=(Variant("drive", (1,), {"type": tools.PulseUse}), Variant("drive", (2,), {"type": tools.SerialUse}),)),
        ),
    ),
    "HelloResponse": FieldInfo(
        "tools.hello_response", tools.HelloResponse, perhaps=("model-c",),
        parameters=(
            Parameter("seen", "seen", "scalar", scalar="u32", units=("s",)),
        ),
    ),
    "ReadingsResponse": FieldInfo(
        "tools.readings_response", tools.ReadingsResponse, devices=("model-a", "model-c"),
        parameters=(
            Parameter("drive", "drive", "scalar", scalar="u8", type=tools.Drive),
            Parameter("count", "count", "counter", scalar="u8", counts="readings"),
            Parameter("readings", "readings", "array", length="count", type=tools.Reading, variants=(Variant("drive", (1,), {"type": tools.PulseUse}, member="kind"), Variant("drive", (2,), {"type": tools.SerialUse}, member="kind"),)),
            Parameter("last", "last", "struct", type=tools.Reading, variants=(Variant("drive", (1,), {"units": ("s",), "minimum": 0, "maximum": 1}, member="value"), Variant("drive", (2,), {}, member="value"),)),
        ),
    ),
    "StatusPaged": FieldInfo(
        "tools.status_paged", tools.StatusPaged, devices=("model-c",),
        parameters=(
            Parameter("model", "model", "constant", scalar="u16", constant=4711),
            Parameter("selector", "selector", "constant", scalar="u8", constant=1),
            Parameter("page", "page", "constant", scalar="u8", constant=7),
            Parameter("uptime", "uptime", "scalar", scalar="u16", units=("s",)),
            Parameter("level", "level", "scalar", scalar="u8"),
        ),
    ),
    "StatusShort": FieldInfo(
        "tools.status_short", tools.StatusShort, devices=("model-a", "model-b"),
        parameters=(
            Parameter("model", "model", "constant", scalar="u16", constant=4711),
            Parameter("selector", "selector", "constant", scalar="u8", constant=1),
            Parameter("flags", "flags", "scalar", scalar="u32", variants=(Variant("device", ("model-a", "model-c"), {"type": tools.ModelAFaults}), Variant("device", ("model-b",), {"type": tools.ModelBFaults}),)),
        ),
    ),
    "StatusLong": FieldInfo(
        "tools.status_long", tools.StatusLong, devices=("model-b",),
        parameters=(
            Parameter("model", "model", "constant", scalar="u16", constant=4711),
            Parameter("selector", "selector", "constant", scalar="u8", constant=2),
            Parameter("flags", "flags", "scalar", scalar="u32", variants=(Variant("device", ("model-a",), {"type": tools.ModelAFaults}), Variant("device", ("model-b",), {"type": tools.ModelBFaults}), Variant("device", ("model-c",), {"type": None}),)),
            Parameter("uptime", "uptime", "scalar", scalar="u64", units=("s",)),
        ),
    ),
    "StatusOld": FieldInfo(
        "tools.status_old", tools.StatusOld, devices=("model-a",),
        parameters=(
            Parameter("model", "model", "constant", scalar="u16", constant=4711),
            Parameter("selector", "selector", "constant", scalar="u8", constant=2),
            Parameter("uptime", "uptime", "scalar", scalar="u32", units=("s",)),
        ),
    ),
    "StatusFull": FieldInfo(
        "tools.status_full", tools.StatusFull, devices=("model-c",),
        parameters=(
            Parameter("model", "model", "constant", scalar="u16", constant=4711),
            Parameter("selector", "selector", "constant", scalar="u8", constant=2),
            Parameter("place", "place", "struct", type=types.Point),
            Parameter("uptime", "uptime", "scalar", scalar="u64", units=("s",)),
            Parameter("mode", "mode", "scalar", scalar="u8", type=types.Mode),
        ),
    ),
    "BiasVector": FieldInfo(
        "tools.bias_vector", tools.BiasVector, devices=("model-a", "model-c"),
        parameters=(
            Parameter("bias", "bias", "array", scalar="float", elements=("x", "y", "z"), units=("g",), frame="sensor"),
        ),
    ),
}
