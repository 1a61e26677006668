"""Copied measurements (0x92).

All the fields of another set.

Uncertain: Which device sends it.
"""

from __future__ import annotations

from . import measurements, types
from .field import Field


class Accel(measurements.Accel):
    """Third acceleration (0x92,0x01).

    A vector whose elements are valid together.

    Has the layout of `measurements.Accel`. Maximum rate: 100 Hz. May be supported by Model C.

    - guide: Third acceleration
    """

    __slots__ = ()

    SET = 0x92
    NAME = "copy.accel"
    scaled_accel: types.Vector3f
    """Specific force. Elements: x, y, z. Unit: g. Frame: sensor. Each element has its own valid
    flag. x: `types.StateFlags.READY` of `valid_flags`, y: `types.StateFlags.HOT` of `valid_flags`,
    z: `types.StateFlags.READY` of `valid_flags`.
    """
    valid_flags: types.StateFlags
    """What is valid."""


class Numbers(measurements.Numbers):
    """Numbers (0x92,0x02).

    One of each.

    Has the layout of `measurements.Numbers`. Not listed in any device profile. Known only from the
    Kit of names.

    - sheet: Copied measurements
    """

    __slots__ = ()

    SET = 0x92
    NAME = "copy.numbers"


class Strings(measurements.Strings):
    """Strings (0x92,0x03).

    Fixed, counted, and to the end.

    Has the layout of `measurements.Strings`. Not listed in any device profile. Known only from the
    Kit of names.

    - sheet: Copied measurements
    """

    __slots__ = ()

    SET = 0x92
    NAME = "copy.strings"


class Health(measurements.Health):
    """Health (0x92,0x04).

    The wide bitfield.

    Deprecated: use `measurements.Numbers` instead. Has the layout of `measurements.Health`. Not
    listed in any device profile. Known only from the Kit of names.

    - sheet: Copied measurements
    """

    __slots__ = ()

    SET = 0x92
    NAME = "copy.health"


class Arrays(measurements.Arrays):
    """Arrays (0x92,0x05).

    Arrays of all that can stand in one.

    Has the layout of `measurements.Arrays`. Not listed in any device profile. Known only from the
    Kit of names.

    - sheet: Copied measurements
    """

    __slots__ = ()

    SET = 0x92
    NAME = "copy.arrays"


class Growing(measurements.Growing):
    """Growing (0x92,0x06).

    Newer devices send more of it.

    Has the layout of `measurements.Growing`. Not listed in any device profile. Known only from the
    Kit of names.

    - sheet: Copied measurements
    """

    __slots__ = ()

    SET = 0x92
    NAME = "copy.growing"


class Radio(measurements.Radio):
    """Radio (0x92,0x07).

    A bool vouches for values; one source has no layout that agrees with it.

    Has the layout of `measurements.Radio`. Also called `modem` and `rf`. Not listed in any device
    profile. Known only from the Kit of names. Uncertain: The leaflet gives the strength two bytes.
    Uncertain: Inferred: the strength is never positive.

    - sheet: Copied measurements
    """

    __slots__ = ()

    SET = 0x92
    NAME = "copy.radio"
    noise: float
    """Never nothing. Unit: m. Range: greater than 0, at most 10. Valid if `connected` is true."""


class Cloud(measurements.Cloud):
    """Cloud (0x92,0x08).

    The count can exceed what a field holds beside the value behind the array.

    Has the layout of `measurements.Cloud`. Not listed in any device profile. Known only from the
    Kit of names.

    - sheet: Copied measurements
    """

    __slots__ = ()

    SET = 0x92
    NAME = "copy.cloud"


class Gust(measurements.Gust):
    """Gust (0x92,0x09).

    One valid flag for all values but one; `measurements.Breeze` has the same place.

    Has the layout of `measurements.Gust`. Not listed in any device profile. Known only from the Kit
    of names.

    `speed * 3.6` is in km/h, and `valid_flags` tells whether `speed` counts; see `types.Mode` and
    `tools.Shape`.

    - sheet: Copied measurements
    """

    __slots__ = ()

    SET = 0x92
    NAME = "copy.gust"


class Breeze(measurements.Breeze):
    """Breeze (0x92,0x0A).

    Its place is told as in `measurements.Gust`.

    Has the layout of `measurements.Breeze`. Not listed in any device profile. Known only from the
    Kit of names.

    - sheet: Copied measurements
    """

    __slots__ = ()

    SET = 0x92
    NAME = "copy.breeze"


#: The types of each descriptor; several if constants or the size of the data distinguish layouts.
FIELDS: dict[int, tuple[type[Field], ...]] = {
    0x01: (Accel,),
    0x02: (Numbers,),
    0x03: (Strings,),
    0x04: (Health,),
    0x05: (Arrays,),
    0x06: (Growing,),
    0x07: (Radio,),
    0x08: (Cloud,),
    0x09: (Gust,),
    0x0A: (Breeze,),
}
