"""More measurements (0x81).

A second sensor with the fields of the first.
"""

from __future__ import annotations

from . import codec, measurements, types
from .field import Data, Field

_OWN_0 = codec.Block("B", "mode")


class Own(Data):
    """Own (0x81,0x07).

    Beside those that it repeats.

    Supported by Model A and Model C.

    - guide: Own
    """

    __slots__ = ("mode",)
    __match_args__ = ("mode",)

    SET = 0x81
    DESCRIPTOR = 0x07
    NAME = "more.own"
    ROLE = "data"
    _LAYOUT = (("mode", "B", types.Mode),)

    mode: types.Mode
    """Of the second sensor."""

    def __init__(self, mode: types.Mode) -> None:
        self.mode = mode

    @classmethod
    def _read(cls, raw: bytes, at: int) -> tuple[Own, int]:
        v = _OWN_0.read(raw, at)
        at += 1
        mode = types.Mode(v[0])
        return cls(mode), at

    def _write(self) -> bytes:
        out = _OWN_0.write(self.mode)
        return codec.finished(out)


class Accel(measurements.Accel):
    """Second acceleration (0x81,0x01).

    A vector whose elements are valid together.

    Has the layout of `measurements.Accel`. Maximum rate: 100 Hz. Supported by Model A and Model C.

    - guide: Second acceleration
    """

    __slots__ = ()

    SET = 0x81
    NAME = "more.accel"
    scaled_accel: types.Vector3f
    """Specific force. Elements: x, y, z. Unit: g. Frame: sensor. Each element has its own valid
    flag. x: `types.StateFlags.READY` of `valid_flags`, y: `types.StateFlags.HOT` of `valid_flags`,
    z: `types.StateFlags.READY` of `valid_flags`.
    """
    valid_flags: types.StateFlags
    """What is valid."""


class Strings(measurements.Strings):
    """Strings (0x81,0x03).

    Fixed, counted, and to the end.

    Has the layout of `measurements.Strings`. Supported by Model A.

    - guide: Second strings
    """

    __slots__ = ()

    SET = 0x81
    NAME = "more.strings"


#: The types of each descriptor; several if constants or the size of the data distinguish layouts.
FIELDS: dict[int, tuple[type[Field], ...]] = {0x01: (Accel,), 0x03: (Strings,), 0x07: (Own,)}
