"""Shared (0xFF).

Valid in every data set.
"""

from __future__ import annotations

from . import types
from .field import Data, Field, Shared


class Timestamp(Shared, Data):
    """Timestamp (0xFF,0xD3).

    When the packet was sent.

    Supported by Model A and Model C.

    - guide: Timestamp
    """

    __slots__ = ("tow", "valid_flags")
    __match_args__ = ("tow", "valid_flags")

    SET = 0xFF
    SETS = range(0x80, 0xFF)
    DESCRIPTOR = 0xD3
    NAME = "shared.timestamp"
    ROLE = "data"
    _LAYOUT = (("tow", "d", None), ("valid_flags", "H", types.StateFlags))

    tow: float
    """Time of week. Unit: s. Valid if `types.StateFlags.READY` of `valid_flags` is set."""
    valid_flags: types.StateFlags
    """What is valid."""

    def __init__(self, tow: float, valid_flags: types.StateFlags) -> None:
        self.tow = tow
        self.valid_flags = valid_flags


#: Descriptor -> its types; several if constants or the size of the data distinguish layouts.
FIELDS: dict[int, tuple[type[Field], ...]] = {0xD3: (Timestamp,)}
