"""Copied measurements (0x82).

All the fields of another set.
"""

from __future__ import annotations

from . import measurements
from .field import Field


class Accel(measurements.Accel):
    """Third acceleration (0x82,0x01).

    Has the values of measurements.Accel.

    - guide: Third acceleration
    """

    __slots__ = ()

    SET = 0x82
    NAME = "copy.accel"


class Numbers(measurements.Numbers):
    """Numbers (0x82,0x02).

    Has the values of measurements.Numbers.

    - sheet: Copied measurements
    """

    __slots__ = ()

    SET = 0x82
    NAME = "copy.numbers"


class Strings(measurements.Strings):
    """Strings (0x82,0x03).

    Has the values of measurements.Strings.

    - sheet: Copied measurements
    """

    __slots__ = ()

    SET = 0x82
    NAME = "copy.strings"


class Health(measurements.Health):
    """Health (0x82,0x04).

    Has the values of measurements.Health.

    - sheet: Copied measurements
    """

    __slots__ = ()

    SET = 0x82
    NAME = "copy.health"


class Arrays(measurements.Arrays):
    """Arrays (0x82,0x05).

    Has the values of measurements.Arrays.

    - sheet: Copied measurements
    """

    __slots__ = ()

    SET = 0x82
    NAME = "copy.arrays"


class Growing(measurements.Growing):
    """Growing (0x82,0x06).

    Has the values of measurements.Growing.

    - sheet: Copied measurements
    """

    __slots__ = ()

    SET = 0x82
    NAME = "copy.growing"


class Radio(measurements.Radio):
    """Radio (0x82,0x07).

    Has the values of measurements.Radio.

    - sheet: Copied measurements
    """

    __slots__ = ()

    SET = 0x82
    NAME = "copy.radio"


#: The types of each descriptor; several where constants in the data tell layouts apart.
FIELDS: dict[int, tuple[type[Field], ...]] = {
    0x01: (Accel,),
    0x02: (Numbers,),
    0x03: (Strings,),
    0x04: (Health,),
    0x05: (Arrays,),
    0x06: (Growing,),
    0x07: (Radio,),
}
