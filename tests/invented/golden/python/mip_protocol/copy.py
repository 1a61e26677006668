"""Copied measurements (0x92).

All the fields of another set.
"""

from __future__ import annotations

from . import measurements, types
from .field import Field


class Accel(measurements.Accel):
    """Third acceleration (0x92,0x01).

    A vector whose elements are valid together.

    Has the layout of `measurements.Accel`. Sent at 100 Hz at most.

    - guide: Third acceleration
    """

    __slots__ = ()

    SET = 0x92
    NAME = "copy.accel"

    scaled_accel: types.Vector3f
    """Specific force. Elements: x, y, z. Unit: g. Frame: sensor. Each element is valid by its bit:
    x by `types.StateFlags.READY` of `valid_flags`, y by `types.StateFlags.HOT` of `valid_flags`, z
    by `types.StateFlags.READY` of `valid_flags`.
    """


class Numbers(measurements.Numbers):
    """Numbers (0x92,0x02).

    One of each.

    Has the layout of `measurements.Numbers`.

    - sheet: Copied measurements
    """

    __slots__ = ()

    SET = 0x92
    NAME = "copy.numbers"


class Strings(measurements.Strings):
    """Strings (0x92,0x03).

    Fixed, counted, and to the end.

    Has the layout of `measurements.Strings`.

    - sheet: Copied measurements
    """

    __slots__ = ()

    SET = 0x92
    NAME = "copy.strings"


class Health(measurements.Health):
    """Health (0x92,0x04).

    The wide bitfield.

    Deprecated: use `measurements.Numbers` instead. Has the layout of `measurements.Health`.

    - sheet: Copied measurements
    """

    __slots__ = ()

    SET = 0x92
    NAME = "copy.health"


class Arrays(measurements.Arrays):
    """Arrays (0x92,0x05).

    Arrays of all that can stand in one.

    Has the layout of `measurements.Arrays`.

    - sheet: Copied measurements
    """

    __slots__ = ()

    SET = 0x92
    NAME = "copy.arrays"


class Growing(measurements.Growing):
    """Growing (0x92,0x06).

    Newer devices send more of it.

    Has the layout of `measurements.Growing`.

    - sheet: Copied measurements
    """

    __slots__ = ()

    SET = 0x92
    NAME = "copy.growing"


class Radio(measurements.Radio):
    """Radio (0x92,0x07).

    A bool vouches for values; one source has no layout that agrees with it.

    Has the layout of `measurements.Radio`. Also called `modem` and `rf`. Uncertain: The leaflet
    gives the strength two bytes. Uncertain: Inferred: the strength is never positive.

    - sheet: Copied measurements
    """

    __slots__ = ()

    SET = 0x92
    NAME = "copy.radio"


class Cloud(measurements.Cloud):
    """Cloud (0x92,0x08).

    The count can exceed what a field holds beside the value behind the array.

    Has the layout of `measurements.Cloud`.

    - sheet: Copied measurements
    """

    __slots__ = ()

    SET = 0x92
    NAME = "copy.cloud"


#: The types of each descriptor; several where constants or the size of the data tell layouts apart.
FIELDS: dict[int, tuple[type[Field], ...]] = {
    0x01: (Accel,),
    0x02: (Numbers,),
    0x03: (Strings,),
    0x04: (Health,),
    0x05: (Arrays,),
    0x06: (Growing,),
    0x07: (Radio,),
    0x08: (Cloud,),
}
