"""What the types of `displacement_data` mean."""

from __future__ import annotations

from .. import displacement_data
from ..info import FieldInfo, Info
from ..parameter import Parameter

# fmt: off

#: Class -> what is known of it.
TYPES: dict[str, Info] = {
    "DisplacementRaw": FieldInfo(
        "displacement_data.displacement_raw", displacement_data.DisplacementRaw,
        parameters=(
            Parameter("counts", "counts", "scalar", scalar="u32", units=("1",)),
        ),
    ),
    "Displacement": FieldInfo(
        "displacement_data.displacement", displacement_data.Displacement,
        parameters=(
            Parameter("displacement", "displacement", "scalar", scalar="float", units=("mm",)),
        ),
    ),
}
