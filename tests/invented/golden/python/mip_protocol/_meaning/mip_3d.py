"""What the types of `mip_3d` mean."""

from __future__ import annotations

from .. import mip_3d
from ..info import FieldInfo, Info, SetInfo
from ..parameter import Parameter

# fmt: off
SET = SetInfo("3d", number=0x0C, title="Awkward names", description="Names that are keywords or begin with a digit.")

#: Class -> what is known of it.
TYPES: dict[str, Info] = {
    "Default": FieldInfo(
        "3d.default", type=mip_3d.Default,
        title="Default",
        description="Its parameters are keywords here and there.",
        facts=("Not acknowledged if `mode` of `tools.Settings` is `types.Mode.FAST`.", "Supported by Model A."),
        sources=("guide: Default",),
        devices=("model-a",),
        parameters=(
            Parameter("class", "class_", "scalar", description="A keyword.", scalar="u8"),
            Parameter("type", "type", "scalar", description="A keyword.", scalar="u8"),
            Parameter("register", "register", "scalar", description="A keyword.", scalar="u8"),
            Parameter("self", "self_", "scalar", description="A keyword.", scalar="u8"),
            Parameter("present", "present", "scalar", description="Used by generated code elsewhere.", scalar="u8"),
        ),
    ),
}
