"""Details: attributes that may change without changing the shape of a model, such as texts, units, limits and sources.

Reads of them are noted by `base.reads`, so that a changed description affects only the files that show it.
"""

from __future__ import annotations

import re
from dataclasses import fields, is_dataclass
from functools import cache
from types import ModuleType
from typing import Annotated, TypeVar

from mipgen.base import reads

Value = TypeVar("Value")

#: An attribute with a plain value, from which `resolve` derives only other such attributes and numbers.
Detail = Annotated[Value, "detail"]

#: A text for readers, with names in backticks.
Prose = str

_DETAIL = re.compile(r"\b(Detail|Prose|Position)\b")


def names(cls: type) -> list[str]:
    """Returns the details of a class of the model."""
    return [f.name for f in fields(cls) if _DETAIL.search(str(f.type))]


#: The classes of the model, without the model itself.
CLASSES: list[type] = []


def classes(*modules: ModuleType) -> list[type]:
    """Returns the classes that modules define."""
    return [
        cls
        for module in modules
        for cls in vars(module).values()
        if isinstance(cls, type) and is_dataclass(cls) and cls.__module__ == module.__name__
    ]


@cache
def watch(model: type) -> None:
    """Starts to note reads of details, and of the parts of a model. Call it after loading, which it would slow down."""
    for cls in CLASSES:
        reads.watch(cls, names(cls))
    reads.watch(model, [part.name for part in fields(model)])
