"""Columns of a log: an array for each parameter of each type of field.

Needs NumPy, the extra `numpy`; frames also need pandas, Polars or PyArrow.

kernel.c does the same as `scan` and `walk`, if tools/setup.py compiled it. `tests/tools/test_columns.py` compares
columns with objects, compiled code with Python, and both wheels; `tests/tools/test_log_tables.py` compares tables
with plain rows.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ..binding import MissingExtra

try:
    import numpy as _numpy  # noqa: F401
except ImportError:
    if not TYPE_CHECKING:  # type checkers would accept any name

        def __getattr__(name: str) -> Any:
            if name.startswith("__"):
                raise AttributeError(name)
            raise MissingExtra("numpy", "numpy")

else:
    from .column import Column
    from .contents import TypeCount
    from .general import Ragged
    from .log import Log, read_log
    from .native import compiled
    from .stamps import Times

__all__ = ["Column", "Log", "Ragged", "Times", "TypeCount", "compiled", "read_log"]
