"""The command line `mip`, logs as columns, and a virtual device, for any generated package.

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
    from .simulator import VirtualDevice as VirtualDevice
else:

    def __getattr__(name: str) -> Any:
        homes = {"read_log": ".columns", "VirtualDevice": ".simulator"}
        if name not in homes:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        return getattr(import_module(homes[name], __name__), name)

    def __dir__() -> list[str]:
        return ["VirtualDevice", "__version__", "read_log", "use"]


__all__ = ["use"]
