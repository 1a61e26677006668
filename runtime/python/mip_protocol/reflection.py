"""The structure and meaning of fields, for generic tools.

>>> from mip_protocol import reflection, sensor
>>> reflection.info(sensor.ScaledAccel)["scaled_accel"].unit
'g'

The descriptions of a set are loaded on first use.
"""

from __future__ import annotations

from enum import IntEnum, IntFlag
from functools import cache
from typing import Any, overload

from . import prose
from ._sets import MODULES, SETS
from .described import Described, description
from .field import Field, Structure
from .info import BitsInfo, EnumInfo, FieldInfo, Item, SetInfo, StructureInfo
from .parameter import Flag, Parameter, Variant


@overload
def info(kind: type[Field]) -> FieldInfo: ...
@overload
def info(kind: type[Structure] | type[Described]) -> StructureInfo: ...
@overload
def info(kind: type[IntEnum]) -> EnumInfo: ...
@overload
def info(kind: type[IntFlag]) -> BitsInfo: ...
def info(kind: type) -> Any:
    """Returns the description of a field, structure, enumeration or bitfield of the specification.

    Raises LookupError for any other class.
    """
    return description(kind)


def items(holder: Described, device: str | None = None) -> list[Item]:
    """Returns an object's values, without absent ones, each with its text and its validity."""
    values: list[Item] = holder.INFO.items(holder, device)
    return values


@cache
def set_info(number: int) -> SetInfo:
    """Returns the description of a descriptor set. Raises LookupError if the set is unknown."""
    name, title = SETS[number]
    return SetInfo(name, number, title, prose.of_set(f"{__package__}.{MODULES[number]}", name))


__all__ = ["Flag", "Item", "Parameter", "Variant", "info", "items", "set_info"]
