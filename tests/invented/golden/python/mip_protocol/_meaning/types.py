"""What the types of `types` mean."""

from __future__ import annotations

from .. import types
from ..info import BitInfo, BitsInfo, EnumInfo, Info, StructureInfo, ValueInfo
from ..parameter import Parameter

# fmt: off

#: Class -> what is known of it.
TYPES: dict[str, Info] = {
    "AckCode": EnumInfo(
        "ack_code", type=types.AckCode, description="The result of a command.",
        values=(
            ValueInfo("ok", value=0, description="Done."),
            ValueInfo("unknown_command", value=1, description="No such command."),
            ValueInfo("invalid_parameter", value=3, description="A parameter is out of range."),
        ),
    ),
    "Mode": EnumInfo(
        "mode", type=types.Mode, description="What the device does.", facts=("Uncertain: Whether there are more.",),
        values=(
            ValueInfo("default", value=0, description="A keyword in three languages."),
            ValueInfo("fast", value=1, description="Quick.", facts=("Uncertain: How quick.",)),
            ValueInfo("slow", value=2, description="Careful.", deprecated=True),
        ),
    ),
    "WideCode": EnumInfo(
        "wide_code", type=types.WideCode, description="An enumeration over four bytes.",
        values=(
            ValueInfo("low", value=1),
            ValueInfo("high", value=4294901760),
        ),
    ),
    "StateFlags": BitsInfo(
        "state_flags", type=types.StateFlags, description="Bits of all kinds.",
        bits=(
            BitInfo("ready", first=0, last=0, description="Ready to measure."),
            BitInfo("hot", first=1, last=1, description="Too hot.", facts=("Uncertain: The limit; 85 degrees is likely.",)),
            BitInfo("level", first=4, last=6, description="A number from 0 to 7."),
            BitInfo("mode", first=8, last=9, description="An enumeration inside the bitfield.", type=types.Mode),
            BitInfo("any", first=0, last=1, description="Ready or hot.", alias=True),
        ),
    ),
    "Health": BitsInfo(
        "health", type=types.Health, description="One hundred and twenty-eight bits, least significant byte first.",
        bits=(
            BitInfo("clock", first=0, last=0, description="The clock has failed."),
            BitInfo("power", first=9, last=9, description="The supply is out of range."),
            BitInfo("count", first=30, last=33, description="A number across two bytes."),
            BitInfo("last", first=127, last=127, description="The very last bit."),
        ),
    ),
    "Point": StructureInfo(
        "point", type=types.Point, description="A place in a plane.",
        parameters=(
            Parameter("x", "x", "scalar", description="Eastward.", facts=("Unit: m.",), scalar="s16", units=("m",)),
            Parameter("y", "y", "scalar", description="Northward.", facts=("Unit: m.",), scalar="s16", units=("m",)),
        ),
    ),
    "Segment": StructureInfo(
        "segment", type=types.Segment, description="Two places, nested.",
        parameters=(
            Parameter("from", "from_", "struct", description="Begins here.", type=types.Point),
            Parameter("to", "to", "struct", description="Ends here.", type=types.Point),
            Parameter("weights", "weights", "array", description="Of its ends.", scalar="u8", length=2),
        ),
    ),
}
