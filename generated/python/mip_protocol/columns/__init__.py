"""Columns of a log: an array for each parameter of each type of field.

Needs NumPy, `pip install mip-protocol[numpy]`; frames need pandas, Polars or PyArrow too.
"""

from __future__ import annotations

try:
    import numpy as _numpy  # noqa: F401
except ImportError as _error:
    from ..errors import MissingExtra

    raise MissingExtra("numpy", "numpy") from _error

from .column import Column
from .contents import TypeCount
from .general import Ragged
from .log import Log, read_log
from .native import compiled
from .times import Times

__all__ = ["Column", "Log", "Ragged", "Times", "TypeCount", "compiled", "read_log"]
