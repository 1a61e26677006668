"""The command line `mip`, and logs as columns, for any generated package.

`mip_tools.use` selects the package; the default is `mip_protocol`.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from .binding import use

__version__ = "0.2.0"

# For type checkers and editors; otherwise modules are imported when they are first used.
if TYPE_CHECKING:
    from .columns import read_log as read_log  # not in __all__, as it needs NumPy
else:

    def __getattr__(name: str) -> Any:
        if name != "read_log":
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        return import_module(".columns", __name__).read_log

    def __dir__() -> list[str]:
        return ["__version__", "read_log", "use"]


__all__ = ["use"]
