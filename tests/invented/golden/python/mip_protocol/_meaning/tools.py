"""What the types of `tools` mean."""

from __future__ import annotations

from .. import protocol, tools, types
from ..info import BitInfo, BitsInfo, EnumInfo, FieldInfo, Info, SetInfo, StructureInfo, ValueInfo
from ..parameter import Parameter, Variant

# fmt: off
SET = SetInfo("tools", number=0x01, title="Tools", description="Commands of every shape.")

#: Class -> what is known of it.
TYPES: dict[str, Info] = {
    "Shape": EnumInfo(
        "tools.shape", type=tools.Shape, description="Which member the union has.",
        values=(
            ValueInfo("none", value=0),
            ValueInfo("circle", value=1),
            ValueInfo("path", value=2),
            ValueInfo("turn", value=3),
            ValueInfo("label", value=4),
        ),
    ),
    "Fill": EnumInfo(
        "tools.fill", type=tools.Fill, description="How a circle is filled.",
        values=(
            ValueInfo("empty", value=0),
            ValueInfo("solid", value=1),
            ValueInfo("striped", value=2),
        ),
    ),
    "Stripes": StructureInfo(
        "tools.stripes", type=tools.Stripes, description="Two numbers.",
        parameters=(
            Parameter("width", "width", "scalar", description="Of a stripe.", facts=("Unit: m.",), scalar="double", units=("m",)),
            Parameter("angle", "angle", "scalar", description="Of all stripes.", facts=("Unit: deg.", "Range: -180 to 180."), scalar="float", units=("deg",), minimum=-180, maximum=180),
        ),
    ),
    "Circle": StructureInfo(
        "tools.circle", type=tools.Circle, description="Ends in a union of its own.",
        parameters=(
            Parameter("center", "center", "struct", description="The middle.", type=types.Point),
            Parameter("fill", "fill", "scalar", description="Which member follows.", scalar="u8", type=tools.Fill),
            Parameter("filling", "filling", "switch", description="How it is filled.", facts=("Selected by `fill`.", "Empty if `fill` is `tools.Fill.EMPTY`."), tag="fill", cases={0: None, 1: Parameter("solid", "solid", "scalar", description="A colour.", facts=("If `fill` is `tools.Fill.SOLID`.",), scalar="u32"), 2: Parameter("striped", "striped", "struct", facts=("If `fill` is `tools.Fill.STRIPED`.",), type=tools.Stripes), }),
        ),
    ),
    "Path": StructureInfo(
        "tools.path", type=tools.Path, description="A counted array at its end.",
        parameters=(
            Parameter("closed", "closed", "scalar", description="Does it return to its start?", scalar="bool"),
            Parameter("num_points", "num_points", "counter", description="Number of points.", facts=("The number of elements of `points`.",), scalar="u8", counts="points"),
            Parameter("points", "points", "array", description="The points.", length="num_points", type=types.Point),
        ),
    ),
    "Drive": EnumInfo(
        "tools.drive", type=tools.Drive, description="What drives a pin.",
        values=(
            ValueInfo("off", value=0),
            ValueInfo("pulse", value=1),
            ValueInfo("serial", value=2),
        ),
    ),
    "PulseUse": EnumInfo(
        "tools.pulse_use", type=tools.PulseUse, description="Of a pulse.",
        values=(
            ValueInfo("input", value=1),
            ValueInfo("output", value=2),
        ),
    ),
    "SerialUse": EnumInfo(
        "tools.serial_use", type=tools.SerialUse, description="Of a serial line.",
        values=(
            ValueInfo("receive", value=1),
            ValueInfo("transmit", value=33),
        ),
    ),
    "Reading": StructureInfo(
        "tools.reading", type=tools.Reading, description="One of a list; what it is depends on what was asked for.",
        parameters=(
            Parameter("kind", "kind", "scalar", description="Of the reading.", scalar="u8"),
            Parameter("value", "value", "scalar", description="Of the reading.", scalar="float"),
        ),
    ),
    "ModelAFaults": BitsInfo(
        "tools.model_a_faults", type=tools.ModelAFaults, description="Of the model A.",
        bits=(
            BitInfo("clock", first=0, last=0),
            BitInfo("sensor", first=8, last=8),
            BitInfo("solution", first=24, last=24),
        ),
    ),
    "ModelBFaults": BitsInfo(
        "tools.model_b_faults", type=tools.ModelBFaults, description="Of the model B.",
        bits=(
            BitInfo("general", first=0, last=0),
            BitInfo("overload", first=1, last=1),
            BitInfo("accel", first=12, last=12),
        ),
    ),
    "Ping": FieldInfo(
        "tools.ping", type=tools.Ping,
        title="Ping",
        description="Tests the line.",
        facts=("Supported by Model A, Model B, Model C and Old 1.", "May be supported by Old 2."),
        sources=("guide: Ping", "leaflet: Ping"),
        devices=("model-a", "model-b", "model-c", "old-1"),
        perhaps=("old-2",),
        parameters=(
        ),
    ),
    "Settings": FieldInfo(
        "tools.settings", type=tools.Settings,
        title="Settings",
        description="Every function, and a prefix of parameters for each.",
        facts=("Functions: `write`, `read`, `save`, `load`, `default` and `apply`.", "Answered by `tools.SettingsResponse`.", "Supported by Model A, Model B and Model C.", "On the Model B: `write` and `read` only.", "On the Model C: `write`, `read` and `save` only."),
        sources=("guide: Settings", "leaflet: Settings"),
        functions=("write", "read", "save", "load", "default", "apply"),
        devices=("model-a", "model-b", "model-c"),
        parameters=(
            Parameter("function", "function", "scalar", description="What to do with the setting.", scalar="u8", type=protocol.FunctionSelector),
            Parameter("port", "port", "scalar", description="Number of the port, 0 for all.", facts=("Range: 0 to 8.",), scalar="u8", maximum=8, required=("write", "read", "save", "load", "default", "apply"), minimum=0),
            Parameter("mode", "mode", "scalar", description="What to do.", facts=("Default: `types.Mode.FAST`.", "Required for `write`, `read` and `apply`.", "On the Model C: only `types.Mode.DEFAULT` and `types.Mode.FAST`; not deprecated."), scalar="u8", default=1, required=("write", "read", "apply"), type=types.Mode, variants=(Variant("device", ("model-c",), "On the Model C: only `types.Mode.DEFAULT` and `types.Mode.FAST`; not deprecated.", {"only": ("default", "fast"), "deprecated": False}),)),
            Parameter("baud", "baud", "scalar", description="Speed.", facts=("Unit: Bd.", "Default: 115200.", "Required for `write` and `apply`."), scalar="u32", units=("Bd",), default=115200, required=("write", "apply")),
            Parameter("limit", "limit", "scalar", description="Required by no function, not even by write.", facts=("Optional.", "If `mode` is `types.Mode.FAST`: unit s; range 1 to 10; default 5.", "If `mode` is `types.Mode.SLOW`: unit m."), scalar="u16", optional=True, variants=(Variant("mode", (1,), "If `mode` is `types.Mode.FAST`: unit s; range 1 to 10; default 5.", {"units": ("s",), "minimum": 1, "maximum": 10, "default": 5}), Variant("mode", (2,), "If `mode` is `types.Mode.SLOW`: unit m.", {"units": ("m",)}),)),
            Parameter("reserved", "reserved", "scalar", facts=("Reserved: send 1.", "Optional."), scalar="u8", default=1, optional=True, reserved=True),
        ),
    ),
    "SetTime": FieldInfo(
        "tools.set_time", type=tools.SetTime,
        title="Set time",
        description="Two responses for one command.",
        facts=("Functions: `write`, `read` and `apply`.", "Answered by `tools.SetTimeFastResponse` or `tools.SetTimeSlowResponse`.", "Supported by Model A and Model C.", "Send it once a second."),
        sources=("guide: Set time",),
        functions=("write", "read", "apply"),
        devices=("model-a", "model-c"),
        parameters=(
            Parameter("function", "function", "scalar", description="What to do with the setting.", scalar="u8", type=protocol.FunctionSelector),
            Parameter("part", "part", "scalar", description="Which half of the time.", scalar="u8", required=("write", "read", "apply"), type=types.Mode),
            Parameter("value", "value", "scalar", description="The new value.", facts=("Unit: s.", "Required for `write` and `apply`."), scalar="u32", units=("s",), required=("write", "apply")),
        ),
    ),
    "Status": FieldInfo(
        "tools.status", type=tools.Status,
        title="Status",
        description="Layouts of one response, told apart by constants and by size.",
        facts=("For advanced use.", "Answered by `tools.StatusShort`, `tools.StatusLong`, `tools.StatusOld` or `tools.StatusFull`.", "The device may take 2.5 s to answer.", "Supported by Model A, Model B and Model C."),
        sources=("guide: Status",),
        devices=("model-a", "model-b", "model-c"),
        advanced=True,
        parameters=(
            Parameter("model", "model", "constant", description="The model that the layouts belong to.", facts=("Always 4711.",), scalar="u16", constant=4711),
            Parameter("selector", "selector", "scalar", description="Which layout.", facts=("Range: 1 to 2.", "On the Model C: always 2."), scalar="u8", minimum=1, maximum=2, variants=(Variant("device", ("model-c",), "On the Model C: always 2.", {"constant": 2}),)),
        ),
    ),
    "Bias": FieldInfo(
        "tools.bias", type=tools.Bias,
        title="Bias",
        description="Its response serves another command too.",
        facts=("Functions: `write`, `read`, `save`, `load` and `default`.", "Answered by `tools.BiasVector`.", "Supported by Model A and Model C."),
        sources=("guide: Bias", "leaflet: Bias"),
        functions=("write", "read", "save", "load", "default"),
        devices=("model-a", "model-c"),
        parameters=(
            Parameter("function", "function", "scalar", description="What to do with the setting.", scalar="u8", type=protocol.FunctionSelector),
            Parameter("bias", "bias", "array", description="Taken off the measurement.", facts=("Elements: x, y, z.", "Unit: g.", "Frame: sensor.", "Required for `write`."), scalar="float", elements=("x", "y", "z"), units=("g",), frame="sensor", required=("write",)),
        ),
    ),
    "CaptureBias": FieldInfo(
        "tools.capture_bias", type=tools.CaptureBias,
        title="Capture bias",
        description="Measures the bias.",
        facts=("Answered by `tools.BiasVector`.", "Supported by Model A and Model C.", "Deprecated on the Model C: use `tools.Bias` instead."),
        sources=("guide: Capture bias",),
        devices=("model-a", "model-c"),
        parameters=(
            Parameter("time", "time", "scalar", description="How long.", facts=("Unit: s.", "Range: 1 to 30."), scalar="u16", units=("s",), minimum=1, maximum=30),
        ),
    ),
    "Formats": FieldInfo(
        "tools.formats", type=tools.Formats,
        title="Formats",
        description="Counted arrays of structures and of numbers; not answered if told so.",
        facts=("Not acknowledged if `suppress_ack` is true.", "Supported by Model A and Model C."),
        sources=("guide: Formats",),
        devices=("model-a", "model-c"),
        parameters=(
            Parameter("suppress_ack", "suppress_ack", "scalar", description="Send no acknowledge.", scalar="bool"),
            Parameter("num_segments", "num_segments", "counter", description="Number of segments.", facts=("The number of elements of `segments`.",), scalar="u8", counts="segments"),
            Parameter("checkpoint", "checkpoint", "scalar", description="Between a counter and its array.", scalar="u8"),
            Parameter("segments", "segments", "array", description="The segments.", length="num_segments", type=types.Segment),
        ),
    ),
    "Choice": FieldInfo(
        "tools.choice", type=tools.Choice,
        title="Choice",
        description="A tagged union with an empty variant, nested unions, arrays and strings in it.",
        facts=("Functions: `write` and `read`.", "Answered by `tools.ChoiceResponse`.", "Supported by Model A."),
        sources=("guide: Choice",),
        functions=("write", "read"),
        devices=("model-a",),
        parameters=(
            Parameter("function", "function", "scalar", description="What to do with the setting.", scalar="u8", type=protocol.FunctionSelector),
            Parameter("instance", "instance", "scalar", description="Which one.", scalar="u8", required=("write", "read")),
            Parameter("shape", "shape", "scalar", description="Which member follows.", facts=("Required for `write`.",), scalar="u8", required=("write",), type=tools.Shape),
            Parameter("parameters", "parameters", "switch", description="The member.", facts=("Selected by `shape`.", "Required for `write`.", "Empty if `shape` is `tools.Shape.NONE`."), tag="shape", required=("write",), cases={0: None, 1: Parameter("circle", "circle", "struct", facts=("If `shape` is `tools.Shape.CIRCLE`.",), type=tools.Circle), 2: Parameter("path", "path", "struct", facts=("If `shape` is `tools.Shape.PATH`.",), type=tools.Path), 3: Parameter("rotation", "rotation", "array", description="A rotation.", facts=("If `shape` is `tools.Shape.TURN`.", "Elements: w, x, y, z.", "Unit: 1."), scalar="float", elements=("w", "x", "y", "z"), units=("1",)), 4: Parameter("label", "label", "text", description="A name.", facts=("If `shape` is `tools.Shape.LABEL`.",), scalar="char", length=8), }),
        ),
    ),
    "List": FieldInfo(
        "tools.list", type=tools.List,
        title="List",
        description="Optional counted array; a read may carry a zero count.",
        facts=("Functions: `write`, `read` and `save`.", "Answered by `tools.ListResponse`.", "Supported by Model A and Model C."),
        sources=("guide: List",),
        functions=("write", "read", "save"),
        devices=("model-a", "model-c"),
        parameters=(
            Parameter("function", "function", "scalar", description="What to do with the setting.", scalar="u8", type=protocol.FunctionSelector),
            Parameter("count", "count", "counter", description="Number of items.", facts=("The number of elements of `items`.", "Required for `write`."), scalar="u8", counts="items", required=("write",)),
            Parameter("items", "items", "array", description="The items.", facts=("Required for `write`.",), scalar="u16", length="count", required=("write",)),
        ),
    ),
    "Inventory": FieldInfo(
        "tools.inventory", type=tools.Inventory,
        title="Inventory",
        description="Answers with an array to the end of the field.",
        facts=("Answered by `tools.InventoryResponse`.", "Supported by Model A and Model C."),
        sources=("guide: Inventory",),
        devices=("model-a", "model-c"),
        parameters=(
        ),
    ),
    "Pin": FieldInfo(
        "tools.pin", type=tools.Pin,
        title="Pin",
        description="The names of one number depend on another.",
        facts=("Functions: `write` and `read`.", "Answered by `tools.PinResponse`.", "Supported by Model A and Model C."),
        sources=("guide: Pin",),
        functions=("write", "read"),
        devices=("model-a", "model-c"),
        parameters=(
            Parameter("function", "function", "scalar", description="What to do with the setting.", scalar="u8", type=protocol.FunctionSelector),
            Parameter("drive", "drive", "scalar", description="What drives it.", scalar="u8", required=("write", "read"), type=tools.Drive),
            Parameter("use", "use", "scalar", description="How it is used.", facts=("Required for `write`.", "If `drive` is `tools.Drive.PULSE`: values of `tools.PulseUse`.", "If `drive` is `tools.Drive.SERIAL`: values of `tools.SerialUse`."), scalar="u8", required=("write",), variants=(Variant("drive", (1,), "If `drive` is `tools.Drive.PULSE`: values of `tools.PulseUse`.", {"type": tools.PulseUse}), Variant("drive", (2,), "If `drive` is `tools.Drive.SERIAL`: values of `tools.SerialUse`.", {"type": tools.SerialUse}),)),
        ),
    ),
    "Hello": FieldInfo(
        "tools.hello", type=tools.Hello,
        title="Hello",
        description="The device asks and a host answers.",
        facts=("Also called `keep_alive`.", "Answered by `tools.HelloResponse`.", "Sent by the device; the host answers.", "May be supported by Model C.", "Known only from the Kit of names."),
        sources=("sheet: Hello",),
        also=("keep_alive",),
        perhaps=("model-c",),
        parameters=(
            Parameter("reserved", "reserved", "scalar", facts=("Reserved: send 1.0.",), scalar="float", default=1.0, reserved=True),
            Parameter("later", "later", "array", facts=("Reserved: send 0.0.", "Optional."), scalar="double", length=2, optional=True, reserved=True, default=0.0),
        ),
    ),
    "Readings": FieldInfo(
        "tools.readings", type=tools.Readings,
        title="Readings",
        description="A parameter outside of a structure says how its members are read.",
        facts=("Answered by `tools.ReadingsResponse`.", "Supported by Model A and Model C."),
        sources=("guide: Readings",),
        devices=("model-a", "model-c"),
        parameters=(
            Parameter("drive", "drive", "scalar", description="What is asked for.", scalar="u8", type=tools.Drive),
        ),
    ),
    "Poll": FieldInfo(
        "tools.poll", type=tools.Poll,
        title="Poll",
        description="Descriptors of a set that a parameter names, and of one that is always the same.",
        facts=("Not listed in any device profile.",),
        sources=("guide: Formats",),
        parameters=(
            Parameter("descriptor_set", "descriptor_set", "scalar", description="Data descriptor set.", facts=("Range: 0x80 to 0xFE.",), scalar="u8", minimum=128, maximum=254),
            Parameter("first", "first", "scalar", description="Field descriptor.", facts=("Refers to fields of Measurements.", "Default: 0x01."), scalar="u8", default=1),
            Parameter("count", "count", "counter", description="Number of fields.", facts=("The number of elements of `descriptors`.",), scalar="u8", counts="descriptors"),
            Parameter("descriptors", "descriptors", "array", description="Field descriptors.", facts=("Refers to fields of `descriptor_set`.",), scalar="u8", length="count"),
        ),
    ),
    "SettingsResponse": FieldInfo(
        "tools.settings_response", type=tools.SettingsResponse,
        title="Settings response",
        facts=("Answers `tools.Settings`.", "Supported by Model A, Model B and Model C."),
        sources=("guide: Settings", "leaflet: Settings"),
        devices=("model-a", "model-b", "model-c"),
        parameters=(
            Parameter("port", "port", "scalar", description="Number of the port, 0 for all.", facts=("Range: 0 to 8.",), scalar="u8", maximum=8, minimum=0),
            Parameter("mode", "mode", "scalar", description="What to do.", facts=("Default: `types.Mode.FAST`.",), scalar="u8", default=1, type=types.Mode),
            Parameter("baud", "baud", "scalar", description="Speed.", facts=("Unit: Bd.", "Default: 115200."), scalar="u32", units=("Bd",), default=115200),
            Parameter("limit", "limit", "scalar", description="Required by no function, not even by write.", facts=("If `mode` is `types.Mode.FAST`: unit s; range 1 to 10; default 5.", "If `mode` is `types.Mode.SLOW`: unit m."), scalar="u16", variants=(Variant("mode", (1,), "If `mode` is `types.Mode.FAST`: unit s; range 1 to 10; default 5.", {"units": ("s",), "minimum": 1, "maximum": 10, "default": 5}), Variant("mode", (2,), "If `mode` is `types.Mode.SLOW`: unit m.", {"units": ("m",)}),)),
            Parameter("reserved", "reserved", "scalar", facts=("Reserved.",), scalar="u8", default=1, reserved=True),
        ),
    ),
    "SetTimeFastResponse": FieldInfo(
        "tools.set_time_fast_response", type=tools.SetTimeFastResponse,
        title="Set time response",
        facts=("Answers `tools.SetTime`.", "Sent if `part` is `types.Mode.FAST`.", "Supported by Model A and Model C."),
        sources=("guide: Set time",),
        devices=("model-a", "model-c"),
        parameters=(
            Parameter("value", "value", "scalar", description="The fast half.", facts=("Unit: s.",), scalar="u32", units=("s",)),
        ),
    ),
    "SetTimeSlowResponse": FieldInfo(
        "tools.set_time_slow_response", type=tools.SetTimeSlowResponse,
        title="Set time response",
        facts=("Answers `tools.SetTime`.", "Sent if `part` is `types.Mode.SLOW`.", "Supported by Model A and Model C."),
        sources=("guide: Set time",),
        devices=("model-a", "model-c"),
        parameters=(
            Parameter("value", "value", "scalar", description="The slow half.", facts=("Unit: s.",), scalar="u32", units=("s",)),
        ),
    ),
    "ChoiceResponse": FieldInfo(
        "tools.choice_response", type=tools.ChoiceResponse,
        title="Choice response",
        facts=("Answers `tools.Choice`.", "Supported by Model A."),
        sources=("guide: Choice",),
        devices=("model-a",),
        parameters=(
            Parameter("instance", "instance", "scalar", description="Which one.", scalar="u8"),
            Parameter("shape", "shape", "scalar", description="Which member follows.", scalar="u8", type=tools.Shape),
            Parameter("parameters", "parameters", "switch", description="The member.", facts=("Selected by `shape`.", "Empty if `shape` is `tools.Shape.NONE`."), tag="shape", cases={0: None, 1: Parameter("circle", "circle", "struct", facts=("If `shape` is `tools.Shape.CIRCLE`.",), type=tools.Circle), 2: Parameter("path", "path", "struct", facts=("If `shape` is `tools.Shape.PATH`.",), type=tools.Path), 3: Parameter("rotation", "rotation", "array", description="A rotation.", facts=("If `shape` is `tools.Shape.TURN`.", "Elements: w, x, y, z.", "Unit: 1."), scalar="float", elements=("w", "x", "y", "z"), units=("1",)), 4: Parameter("label", "label", "text", description="A name.", facts=("If `shape` is `tools.Shape.LABEL`.",), scalar="char", length=8), }),
        ),
    ),
    "ListResponse": FieldInfo(
        "tools.list_response", type=tools.ListResponse,
        title="List response",
        facts=("Answers `tools.List`.", "Supported by Model A and Model C."),
        sources=("guide: List",),
        devices=("model-a", "model-c"),
        parameters=(
            Parameter("count", "count", "counter", description="Number of items.", facts=("The number of elements of `items`.",), scalar="u8", counts="items"),
            Parameter("items", "items", "array", description="The items.", scalar="u16", length="count"),
        ),
    ),
    "InventoryResponse": FieldInfo(
        "tools.inventory_response", type=tools.InventoryResponse,
        title="Inventory response",
        facts=("Answers `tools.Inventory`.", "Supported by Model A and Model C."),
        sources=("guide: Inventory",),
        devices=("model-a", "model-c"),
        parameters=(
            Parameter("descriptors", "descriptors", "array", description="As many as there are.", scalar="u16", length="rest"),
        ),
    ),
    "PinResponse": FieldInfo(
        "tools.pin_response", type=tools.PinResponse,
        title="Pin response",
        facts=("Answers `tools.Pin`.", "Supported by Model A and Model C."),
        sources=("guide: Pin",),
        devices=("model-a", "model-c"),
        parameters=(
            Parameter("drive", "drive", "scalar", description="What drives it now.", scalar="u8", type=tools.Drive),
            Parameter("use", "use", "scalar", description="How it is used.", facts=("If `drive` is `tools.Drive.PULSE`: values of `tools.PulseUse`.", "If `drive` is `tools.Drive.SERIAL`: values of `tools.SerialUse`."), scalar="u8", variants=(Variant("drive", (1,), "If `drive` is `tools.Drive.PULSE`: values of `tools.PulseUse`.", {"type": tools.PulseUse}), Variant("drive", (2,), "If `drive` is `tools.Drive.SERIAL`: values of `tools.SerialUse`.", {"type": tools.SerialUse}),)),
        ),
    ),
    "HelloResponse": FieldInfo(
        "tools.hello_response", type=tools.HelloResponse,
        title="Hello response",
        facts=("Also called `keep_alive_response` and `welcome`.", "Answers `tools.Hello`.", "May be supported by Model C.", "Known only from the Kit of names.", "Uncertain: When it comes."),
        sources=("sheet: Hello",),
        also=("keep_alive_response", "welcome"),
        perhaps=("model-c",),
        parameters=(
            Parameter("seen", "seen", "scalar", description="When the device was seen.", facts=("Unit: s.",), scalar="u32", units=("s",)),
        ),
    ),
    "ReadingsResponse": FieldInfo(
        "tools.readings_response", type=tools.ReadingsResponse,
        title="Readings response",
        facts=("Answers `tools.Readings`.", "Supported by Model A and Model C."),
        sources=("guide: Readings",),
        devices=("model-a", "model-c"),
        parameters=(
            Parameter("drive", "drive", "scalar", description="What was asked for.", scalar="u8", type=tools.Drive),
            Parameter("count", "count", "counter", description="Number of readings.", facts=("The number of elements of `readings`.",), scalar="u8", counts="readings"),
            Parameter("readings", "readings", "array", description="The readings.", facts=("If `drive` is `tools.Drive.PULSE`: `kind` has values of `tools.PulseUse`. Seldom 2.", "If `drive` is `tools.Drive.SERIAL`: `kind` has values of `tools.SerialUse`."), length="count", type=tools.Reading, variants=(Variant("drive", (1,), "If `drive` is `tools.Drive.PULSE`: `kind` has values of `tools.PulseUse`. Seldom 2.", {"type": tools.PulseUse}, member="kind"), Variant("drive", (2,), "If `drive` is `tools.Drive.SERIAL`: `kind` has values of `tools.SerialUse`.", {"type": tools.SerialUse}, member="kind"),)),
            Parameter("last", "last", "struct", description="The last one.", facts=("If `drive` is `tools.Drive.PULSE`: `value` has unit s; range 0 to 1.", "If `drive` is `tools.Drive.SERIAL`: `value`: Nothing."), type=tools.Reading, variants=(Variant("drive", (1,), "If `drive` is `tools.Drive.PULSE`: `value` has unit s; range 0 to 1.", {"units": ("s",), "minimum": 0, "maximum": 1}, member="value"), Variant("drive", (2,), "If `drive` is `tools.Drive.SERIAL`: `value`: Nothing.", {}, member="value"),)),
        ),
    ),
    "StatusShort": FieldInfo(
        "tools.status_short", type=tools.StatusShort,
        title="Status response",
        facts=("Answers `tools.Status`.", "Sent if `selector` is 1.", "Supported by Model A, Model B and Model C."),
        sources=("guide: Status",),
        devices=("model-a", "model-b", "model-c"),
        parameters=(
            Parameter("model", "model", "constant", description="The model.", facts=("Always 4711.",), scalar="u16", constant=4711),
            Parameter("selector", "selector", "constant", description="The short layout.", facts=("Always 1.",), scalar="u8", constant=1),
            Parameter("flags", "flags", "scalar", description="Faults.", facts=("On the Model A and Model C: values of `tools.ModelAFaults`.", "On the Model B: values of `tools.ModelBFaults`."), scalar="u32", variants=(Variant("device", ("model-a", "model-c"), "On the Model A and Model C: values of `tools.ModelAFaults`.", {"type": tools.ModelAFaults}), Variant("device", ("model-b",), "On the Model B: values of `tools.ModelBFaults`.", {"type": tools.ModelBFaults}),)),
        ),
    ),
    "StatusLong": FieldInfo(
        "tools.status_long", type=tools.StatusLong,
        title="Status response",
        facts=("Answers `tools.Status`.", "Distinguished from `tools.StatusOld` and `tools.StatusFull` by the size of its data.", "Sent if `selector` is 2.", "Supported by Model B."),
        sources=("guide: Status",),
        devices=("model-b",),
        parameters=(
            Parameter("model", "model", "constant", description="The model.", facts=("Always 4711.",), scalar="u16", constant=4711),
            Parameter("selector", "selector", "constant", description="The long layout.", facts=("Always 2.",), scalar="u8", constant=2),
            Parameter("flags", "flags", "scalar", description="Faults.", facts=("On the Model A: values of `tools.ModelAFaults`.", "On the Model B: values of `tools.ModelBFaults`.", "On the Model C: the values are not known."), scalar="u32", variants=(Variant("device", ("model-a",), "On the Model A: values of `tools.ModelAFaults`.", {"type": tools.ModelAFaults}), Variant("device", ("model-b",), "On the Model B: values of `tools.ModelBFaults`.", {"type": tools.ModelBFaults}), Variant("device", ("model-c",), "On the Model C: the values are not known.", {"type": None}),)),
            Parameter("uptime", "uptime", "scalar", description="Since start.", facts=("Unit: s.",), scalar="u64", units=("s",)),
        ),
    ),
    "StatusOld": FieldInfo(
        "tools.status_old", type=tools.StatusOld,
        title="Status response",
        description="The long layout of old devices. Its size tells it from the others.",
        facts=("Answers `tools.Status`.", "Distinguished from `tools.StatusLong` and `tools.StatusFull` by the size of its data.", "Sent if `selector` is 2.", "Supported by Model A."),
        sources=("guide: Status",),
        devices=("model-a",),
        parameters=(
            Parameter("model", "model", "constant", description="The model.", facts=("Always 4711.",), scalar="u16", constant=4711),
            Parameter("selector", "selector", "constant", description="The long layout.", facts=("Always 2.",), scalar="u8", constant=2),
            Parameter("uptime", "uptime", "scalar", description="Since start.", facts=("Unit: s.",), scalar="u32", units=("s",)),
        ),
    ),
    "StatusFull": FieldInfo(
        "tools.status_full", type=tools.StatusFull,
        title="Status response",
        facts=("Answers `tools.Status`.", "Distinguished from `tools.StatusLong` and `tools.StatusOld` by the size of its data.", "Sent if `selector` is 2.", "Supported by Model C."),
        sources=("guide: Status",),
        devices=("model-c",),
        parameters=(
            Parameter("model", "model", "constant", description="The model.", facts=("Always 4711.",), scalar="u16", constant=4711),
            Parameter("selector", "selector", "constant", description="The long layout.", facts=("Always 2.",), scalar="u8", constant=2),
            Parameter("place", "place", "struct", description="Where it is.", type=types.Point),
            Parameter("uptime", "uptime", "scalar", description="Since start.", facts=("Unit: s.",), scalar="u64", units=("s",)),
            Parameter("mode", "mode", "scalar", description="What it does.", scalar="u8", type=types.Mode),
        ),
    ),
    "BiasVector": FieldInfo(
        "tools.bias_vector", type=tools.BiasVector,
        title="Bias response",
        facts=("Answers `tools.Bias` and `tools.CaptureBias`.", "Supported by Model A and Model C."),
        sources=("guide: Bias", "leaflet: Bias"),
        devices=("model-a", "model-c"),
        parameters=(
            Parameter("bias", "bias", "array", description="Taken off the measurement.", facts=("Elements: x, y, z.", "Unit: g.", "Frame: sensor."), scalar="float", elements=("x", "y", "z"), units=("g",), frame="sensor"),
        ),
    ),
}
