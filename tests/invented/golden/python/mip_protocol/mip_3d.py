"""Awkward names (0x0C).

Names that are keywords or begin with a digit.
"""

from __future__ import annotations

from typing import Any

from . import codec
from .field import Command, Field

# Numbers that are read and written together, by their letters for `struct`.
_5B = codec.Block("5B")


class Default(Command[None]):
    """Default (0x0C,0x10).

    Its parameters are keywords here and there.

    Not acknowledged if `mode` of `tools.Settings` is `types.Mode.FAST`. Supported by Model A.

    - guide: Default
    """

    __slots__ = ("class_", "type", "register", "self_", "present")
    __match_args__ = ("class_", "type", "register", "self_", "present")

    SET = 0x0C
    DESCRIPTOR = 0x10
    NAME = "3d.default"
    SILENCED_BY = ((0x01, 0x02, "mode", 1),)
    _SIZE = 5

    class_: int
    """A keyword."""
    type: int
    """A keyword."""
    register: int
    """A keyword."""
    self_: int
    """A keyword."""
    present: int
    """Used by generated code elsewhere."""

    def __init__(self, class_: int, type: int, register: int, self_: int, present: int) -> None:
        self.class_ = class_
        self.type = type
        self.register = register
        self.self_ = self_
        self.present = present

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.class_, self.type, self.register, self.self_, self.present = _5B.unpack(raw, at)
        return at + 5

    def _write(self) -> bytes:
        return _5B.write(
            "class_ type register self_ present",
            self.class_,
            self.type,
            self.register,
            self.self_,
            self.present,
        )


#: Descriptor -> its types; several if constants or the size of the data distinguish layouts.
FIELDS: dict[int, tuple[type[Field], ...]] = {0x10: (Default,)}
