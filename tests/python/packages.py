"""The generated packages, each imported under a name of its own."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from typing import Any

from support import SPECS

INVENTED = SPECS["invented"][1] / "python"
REAL = SPECS["real"][1] / "python"


class Package:
    """A generated package, imported under a name of its own."""

    def __init__(self, folder: Path, name: str) -> None:
        path = folder / "mip_protocol"
        spec = importlib.util.spec_from_file_location(
            name, path / "__init__.py", submodule_search_locations=[str(path)]
        )
        assert spec and spec.loader
        self.name = name
        self.top = sys.modules[name] = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(self.top)

    def __getattr__(self, name: str) -> Any:
        return importlib.import_module(f"{self.name}.{name}")


mip = Package(INVENTED, "invented_mip")
real = Package(REAL, "real_mip")
