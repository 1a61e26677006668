"""The meaning of the types of `displacement_data`."""

from __future__ import annotations

from .. import displacement_data
from ..info import BitsInfo, FieldInfo, Info
from ..parameter import Flag, Parameter

# fmt: off

#: Class -> its description.
TYPES: dict[str, Info] = {
    "TimestampFlags": BitsInfo("displacement_data.timestamp_flags", displacement_data.TimestampFlags),
    "DisplacementRaw": FieldInfo(
        "displacement_data.displacement_raw", displacement_data.DisplacementRaw, likely=("demod-dc",), parameters=(
            Parameter("counts", "counts", "scalar", scalar="u32", units=("1",)),
        )),
    "Displacement": FieldInfo(
        "displacement_data.displacement", displacement_data.Displacement, likely=("demod-dc",), parameters=(
            Parameter("displacement", "displacement", "scalar", scalar="float", units=("mm",)),
        )),
    "Timestamp": FieldInfo(
        "displacement_data.timestamp", displacement_data.Timestamp, likely=("demod-dc",), parameters=(
            Parameter("flags", "flags", "scalar", scalar="u8", type=displacement_data.TimestampFlags),
            Parameter("time", "time", "scalar", scalar="u64", units=("ns",), valid=("flags.time",), flags=(Flag("flags.time", "flags", 0x1),)),
        )),
}
