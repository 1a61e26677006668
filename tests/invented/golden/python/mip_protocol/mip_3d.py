"""Awkward names (0x0C).

Names that are keywords or begin with a digit.
"""

from __future__ import annotations

from dataclasses import dataclass

from . import codec
from .field import Command, Field

_DEFAULT_0 = codec.Block("BBBBB", "class_", "type", "register", "self_", "present")


@dataclass(slots=True)
class Default(Command[None]):
    """Default (0x0C,0x10).

    Its parameters are keywords here and there.

    Not acknowledged if `mode` of `tools.Settings` is `types.Mode.FAST`. Supported by Model A.

    - guide: Default
    """

    SET = 0x0C
    DESCRIPTOR = 0x10
    NAME = "3d.default"
    ROLE = "command"
    SILENCED_BY = ((0x01, 0x02, "mode", 1),)

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


#: The types of each descriptor; several where constants or the size of the data tell layouts apart.
FIELDS: dict[int, tuple[type[Field], ...]] = {0x10: (Default,)}
