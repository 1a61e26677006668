"""Makes a package from a `mip.json` when the tools start, instead of a generated package.

Its runtime is that of an installed generated package. Each of its other modules is built when it is first imported,
with the classes that a generated module would have.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from importlib import import_module
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec
from importlib.util import spec_from_file_location, spec_from_loader
from pathlib import Path
from types import ModuleType
from typing import Any

from . import meaning, modules, prose
from .document import Document

#: The name of the package.
NAME = "mip_definitions"

#: Module -> the function that fills it. The modules of descriptor sets are added for each file.
_BUILDERS: dict[str, Callable[[Document, ModuleType], None]] = {
    "_clocks": modules.clocks,
    "_index": modules.index,
    "_session": modules.session,
    "_sets": modules.sets,
    "devices": modules.devices,
    "protocol": modules.protocol,
    "types": modules.types,
}


class Finder(MetaPathFinder, Loader):
    """Finds the modules of the package: those to build, and those of the runtime in its folder."""

    def __init__(self, document: Document, runtime: ModuleType) -> None:
        self.document, self.runtime = document, runtime
        self.folder = [str(p) for p in runtime.__path__]
        generated = import_module(f"{runtime.__name__}._sets").MODULES.values()
        own = document.homes
        self.builders = {
            **_BUILDERS,
            **dict.fromkeys(own, modules.of_set),
            **{f"_meaning.{home}": meaning.of_module for home in (*own, "protocol", "types")},
        }
        self.hidden = {*generated} - self.builders.keys()

    def find_spec(
        self, fullname: str, path: Sequence[str] | None = None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        first, _, home = fullname.partition(".")
        if first != self.document.package:
            return None
        if not home:
            return spec_from_file_location(first, self.runtime.__file__, submodule_search_locations=self.folder)
        if home.removeprefix("_meaning.") in self.hidden:
            raise ModuleNotFoundError(f"{self.document.path} has no set {home}", name=fullname)
        return spec_from_loader(fullname, self) if home in self.builders else None  # else in the folder

    def get_source(self, fullname: str) -> str:
        """Returns the source from which `help` and the package read their texts."""
        return prose.source(self.document, fullname.rpartition(".")[2])

    def exec_module(self, module: ModuleType) -> None:
        self.builders[module.__name__.partition(".")[2]](self.document, module)


def load(file: Path, runtime: ModuleType, name: str = NAME) -> str:
    """Makes the package of a file importable, and returns its name. Raises NoBinding."""
    sys.meta_path.insert(0, Finder(Document(file, name), runtime))
    return import_module(name).__name__


def simulation(package: str) -> dict[str, Any] | None:
    """Returns the behaviour of virtual devices, the `simulation.json` of a package; None for a generated package."""
    made = (f.document for f in sys.meta_path if isinstance(f, Finder) and f.document.package == package)
    return next(map(modules.simulation, made), None)


__all__ = ["NAME", "load", "simulation"]
