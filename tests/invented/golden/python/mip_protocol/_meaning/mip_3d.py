"""The meaning of the types of `mip_3d`."""

from __future__ import annotations

from .. import mip_3d
from ..info import FieldInfo, Info
from ..parameter import Parameter

# fmt: off

#: Class -> its description.
TYPES: dict[str, Info] = {
    "Default": FieldInfo(
        "3d.default", mip_3d.Default, devices=("model-a",),
        parameters=(
            Parameter("class", "class_", "scalar", scalar="u8"),
            Parameter("type", "type", "scalar", scalar="u8"),
            Parameter("register", "register", "scalar", scalar="u8"),
            Parameter("self", "self_", "scalar", scalar="u8"),
            Parameter("present", "present", "scalar", scalar="u8"),
        ),
    ),
}
