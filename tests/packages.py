"""The generated packages, each imported under a name of its own, and the tools on top of each."""

from __future__ import annotations

import importlib.util
import sys
from functools import cached_property
from pathlib import Path
from typing import Any

from support import ROOT, SPECS

INVENTED = SPECS["invented"][1] / "python"
REAL = SPECS["real"][1] / "python"


class Package:
    """A package, imported under a name of its own."""

    def __init__(self, path: Path, name: str) -> None:
        spec = importlib.util.spec_from_file_location(
            name, path / "__init__.py", submodule_search_locations=[str(path)]
        )
        assert spec and spec.loader
        self.name = name
        self.top = sys.modules[name] = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(self.top)

    def __getattr__(self, name: str) -> Any:
        return importlib.import_module(f"{self.name}.{name}")

    @cached_property
    def mip_tools(self) -> Package:
        """The tools that use this package."""
        found = Package(ROOT / "tools/mip_tools", f"{self.name}_tools")
        found.binding.use(self.name)
        return found


mip = Package(INVENTED / "mip_protocol", "invented_mip")
real = Package(REAL / "mip_protocol", "real_mip")
