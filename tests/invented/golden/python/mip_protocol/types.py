"""Types that several descriptor sets use."""

from __future__ import annotations

if __name__ == "types":
    raise ImportError(
        "this is types.py of mip_protocol, not Python's own: run Python in another folder"
    )

from collections.abc import Sequence
from enum import IntFlag
from typing import NamedTuple

from . import codec
from .field import Structure


class Vector3f(NamedTuple):
    """Three floats. Elements: x, y, z."""

    x: float
    y: float
    z: float


class Quatf(NamedTuple):
    """A quaternion, scalar part first. Elements: w, x, y, z."""

    w: float
    x: float
    y: float
    z: float


class AckCode(codec.OpenEnum):
    """The result of a command."""

    OK = 0
    """Done."""
    UNKNOWN_COMMAND = 1
    """No such command."""
    INVALID_PARAMETER = 3
    """A parameter is out of range."""


class Mode(codec.OpenEnum):
    """What the device does. Uncertain: Whether there are more."""

    DEFAULT = 0
    """A keyword in three languages."""
    FAST = 1
    """Quick. Uncertain: How quick."""
    SLOW = 2
    """Careful. Deprecated."""


class WideCode(codec.OpenEnum):
    """An enumeration over four bytes."""

    LOW = 1
    HIGH = 0xFFFF0000


@codec.open_flag(16)
class StateFlags(IntFlag):
    """Bits of all kinds."""

    READY = 1 << 0
    """Ready to measure. Bit 0."""
    HOT = 1 << 1
    """Too hot. Bit 1. Uncertain: The limit; 85 degrees is likely."""
    LEVEL = 0x70
    """A number from 0 to 7. Bits 4 to 6."""
    MODE = 0x300
    """An enumeration inside the bitfield. Bits 8 to 9. A value of `Mode`."""
    ANY = 0x3
    """Ready or hot. Bits 0 to 1. Overlaps other bits."""

    @property
    def level(self) -> int:
        """Bits 4 to 6 as a number."""
        return int((self >> 4) & 0x7)

    def with_level(self, value: int) -> StateFlags:
        """Returns a copy with bits 4 to 6 set to a number."""
        value = codec.fits("level", value, 3)
        return StateFlags(int(self) & ~0x70 | value << 4)

    @property
    def mode(self) -> Mode:
        """Bits 8 to 9 as a number."""
        return Mode((self >> 8) & 0x3)

    def with_mode(self, value: int) -> StateFlags:
        """Returns a copy with bits 8 to 9 set to a number."""
        value = codec.fits("mode", value, 2)
        return StateFlags(int(self) & ~0x300 | value << 8)


@codec.open_flag(128)
class Health(IntFlag):
    """One hundred and twenty-eight bits, least significant byte first."""

    CLOCK = 1 << 0
    """The clock has failed. Bit 0."""
    HOT = 1 << 1
    """Too hot. Bit 1. Uncertain: The limit; 85 degrees is likely."""
    LEVEL = 0x70
    """A number from 0 to 7. Bits 4 to 6."""
    POWER = 1 << 9
    """The supply is out of range. Bit 9."""
    COUNT = 0x3C0000000
    """A number across two bytes. Bits 30 to 33."""
    LAST = 1 << 127
    """The very last bit. Bit 127."""

    @property
    def level(self) -> int:
        """Bits 4 to 6 as a number."""
        return int((self >> 4) & 0x7)

    def with_level(self, value: int) -> Health:
        """Returns a copy with bits 4 to 6 set to a number."""
        value = codec.fits("level", value, 3)
        return Health(int(self) & ~0x70 | value << 4)

    @property
    def count(self) -> int:
        """Bits 30 to 33 as a number."""
        return int((self >> 30) & 0xF)

    def with_count(self, value: int) -> Health:
        """Returns a copy with bits 30 to 33 set to a number."""
        value = codec.fits("count", value, 4)
        return Health(int(self) & ~0x3C0000000 | value << 30)


class Point(Structure):
    """A place in a plane."""

    __slots__ = ("x", "y")
    __match_args__ = ("x", "y")

    _LAYOUT = (("x", "h", None), ("y", "h", None))

    x: int
    """Eastward. Unit: m."""
    y: int
    """Northward. Unit: m."""

    def __init__(self, x: int, y: int) -> None:
        self.x = x
        self.y = y


class Segment(Structure):
    """Two places, nested."""

    __slots__ = ("from_", "to", "weights")
    __match_args__ = ("from_", "to", "weights")

    _LAYOUT = (("from_", "", Point), ("to", "", Point), ("weights", "BB", tuple))

    from_: Point
    """Begins here."""
    to: Point
    """Ends here."""
    weights: tuple[int, int]
    """Of its ends."""

    def __init__(self, from_: Point, to: Point, weights: Sequence[int]) -> None:
        self.from_ = from_
        self.to = to
        self.weights = codec.several(weights)
