"""The structure and meaning of fields, for generic tools.

>>> from mip_protocol import reflection, sensor
>>> reflection.info(sensor.ScaledAccel)["scaled_accel"].unit
'g'

The descriptions of a set are loaded on first use.
"""

from __future__ import annotations

from enum import IntEnum, IntFlag
from functools import cache
from importlib import import_module
from typing import Any, overload

from ._sets import MODULES
from .described import Described
from .field import Field, Structure
from .info import BitsInfo, EnumInfo, FieldInfo, Info, SetInfo, StructureInfo
from .parameter import Flag, Parameter, Variant
from .text import Item, items


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
    return _info(kind)


@cache
def _info(kind: type) -> Info:
    for base in kind.__mro__:
        package, _, module = base.__module__.rpartition(".")
        if package == __package__ and module in _modules():
            found = _table(module).get(base.__name__)
            if found is not None:
                return found
    raise LookupError(f"{kind.__module__}.{kind.__qualname__} is not a type of the specification")


@cache
def set_info(number: int) -> SetInfo:
    """Returns the description of a descriptor set. Raises LookupError if the set is unknown."""
    from . import prose
    from ._index import SETS

    name, title = SETS[number]
    return SetInfo(name, number, title, prose.of_set(f"{__package__}.{MODULES[number]}", name))


@cache
def _modules() -> frozenset[str]:
    return frozenset((*MODULES.values(), "protocol", "types"))


@cache
def _table(module: str) -> dict[str, Info]:
    """Returns a module's table: class -> its description."""
    table: dict[str, Info] = import_module(f"._meaning.{module}", __package__).TYPES
    return table


__all__ = ["Flag", "Item", "Parameter", "Variant", "info", "items", "set_info"]
