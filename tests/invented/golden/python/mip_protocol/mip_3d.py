"""Awkward names (0x0C).

Names that are keywords or begin with a digit.
"""

from __future__ import annotations

from . import codec
from .field import Command, Field

_DEFAULT_0 = codec.Block("BBBBB", "class_", "type", "register", "self_", "present")


class Default(Command[None]):
    """Default (0x0C,0x10).

    Its parameters are keywords here and there.

    Not acknowledged if `mode` of `tools.Settings` is `types.Mode.FAST`. Supported by Model A.

    - guide: Default
    """

    __slots__ = ("class_", "type", "register", "self_", "present")
    __match_args__ = ("class_", "type", "register", "self_", "present")

    SET = 0x0C
    SETS = (0x0C,)
    DESCRIPTOR = 0x10
    NAME = "3d.default"
    ROLE = "command"
    SILENCED_BY = ((0x01, 0x02, "mode", 1),)
    _LAYOUT = (
        ("class_", "B", None),
        ("type", "B", None),
        ("register", "B", None),
        ("self_", "B", None),
        ("present", "B", None),
    )

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

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[Default, int]:
        v = _DEFAULT_0.read(raw, at)
        at += 5
        class_ = v[0]
        type = v[1]
        register = v[2]
        self_ = v[3]
        present = v[4]
        return cls(class_, type, register, self_, present), at

    def _write(self) -> bytes:
        out = _DEFAULT_0.write(self.class_, self.type, self.register, self.self_, self.present)
        return codec.finished(out)


#: The types of each descriptor; several if constants or the size of the data distinguish layouts.
FIELDS: dict[int, tuple[type[Field], ...]] = {0x10: (Default,)}
