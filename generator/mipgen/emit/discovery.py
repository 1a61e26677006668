"""Finds targets and their templates.

Built-in targets are the packages of `mipgen.targets`, with templates in `templates/<name>/` and files that are
copied unchanged in `runtime/<name>/`. A user's folder (`--target-path`) contains a folder `<name>/` for each
target, with templates, a `target.py` and perhaps `runtime/`. If it has the name of a built-in target, its files
take precedence. Each module defines `TARGET`, a `Target`.
"""

from __future__ import annotations

import importlib
import importlib.util
import pkgutil
import re
import sys
import traceback
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from mipgen.base import resources
from mipgen.base.errors import Failure
from mipgen.read.problems import nearest

if TYPE_CHECKING:
    from .target import Target

BUILT_IN = "mipgen.targets"  # named, not imported: targets import this package
MODULE = "target.py"
RUNTIME = "runtime"


@dataclass(frozen=True, slots=True)
class Source:
    """The files of a target."""

    name: str
    folders: tuple[Path, ...]  # of templates; the first folder that contains a file takes precedence
    runtimes: tuple[Path, ...]  # of files that are copied unchanged, likewise
    module: Path | None = None  # the user's target.py
    without: tuple[str, ...] = ()  # the parts to leave out

    @property
    def ours(self) -> bool:
        return self.module is None and len(self.folders) == 1

    def has(self, path: str) -> bool:
        """Is this path in no part that is left out?"""
        return not any(re.match(self.load().parts[name], path) for name in self.without)

    def load(self) -> Target:
        """Loads the target that its module defines."""
        from .target import Target  # slow to import, and not needed if nothing has changed

        if self.module is None:
            built_in: Target = importlib.import_module(f"{BUILT_IN}.{self.name}").TARGET
            return built_in
        name = f"mipgen_target_{self.name}"
        beside = [str(self.module.parent)]  # so that it can import its own modules: `from . import names`
        spec = importlib.util.spec_from_file_location(name, self.module, submodule_search_locations=beside)
        assert spec is not None and spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        sys.modules[name] = module
        try:
            spec.loader.exec_module(module)
        except SyntaxError as error:
            raise Failure(f"not Python: {error.msg}", f"{error.filename}:{error.lineno}") from None
        except TypeError as error:  # a Target with an unknown attribute, or without a required one
            lines = [f.lineno for f in traceback.extract_tb(error.__traceback__) if f.filename == str(self.module)]
            raise Failure(str(error), f"{self.module}:{lines[-1]}") from None
        target = getattr(module, "TARGET", None)
        if not isinstance(target, Target):
            raise Failure("TARGET is missing; add TARGET = Target(title=..., files=...)", str(self.module))
        return target


def target_names() -> list[str]:
    """Returns the names of the built-in targets, in order."""
    return sorted(module.name for module in pkgutil.iter_modules(importlib.import_module(BUILT_IN).__path__))


def targets(paths: Sequence[Path] = ()) -> dict[str, Source]:
    """Returns all targets by name, in order; earlier folders take precedence."""
    by_name = {name: built_in(name) for name in target_names()}
    for path in reversed(paths):
        for folder in _folders(path):
            name, module = folder.name, folder / MODULE
            before = by_name.get(name)
            if before is None and not module.is_file():
                near = nearest(name, by_name)
                raise Failure(f"{MODULE} is missing, and there is no target '{name}'{near}", str(folder))
            by_name[name] = Source(
                name,
                (folder, *(before.folders if before else ())),
                (folder / RUNTIME, *(before.runtimes if before else ())),
                module if module.is_file() else before.module if before else None,
            )
    return dict(sorted(by_name.items()))


def built_in(name: str) -> Source:
    root = resources.root()
    return Source(name, (root / "templates" / name,), (root / RUNTIME / name,))


def chosen(wanted: Sequence[str] | None, paths: Sequence[Path] = (), without: Sequence[str] = ()) -> list[Source]:
    """Returns the selected targets, or all, without these parts."""
    by_name = targets(paths)
    for name in wanted or ():
        if name not in by_name:
            raise Failure(f"unknown target '{name}'{nearest(name, by_name)}")
    sources = [source for name, source in by_name.items() if not wanted or name in wanted]
    return _without(sources, without) if without else sources


def _without(sources: list[Source], names: Sequence[str]) -> list[Source]:
    parts = {source.name: sorted(source.load().parts) for source in sources}
    known = "; ".join(f"{name} has {', '.join(of)}" for name, of in parts.items() if of)
    for name in names:
        if not any(name in of for of in parts.values()):
            raise Failure(f"no selected target has the part '{name}'" + (f"; {known}" if known else ", or any other"))
    return [replace(x, without=tuple(n for n in names if n in parts[x.name])) for x in sources]


def _folders(path: Path) -> Iterator[Path]:
    if not path.is_dir():
        raise Failure("there is no such folder; --target-path must contain a folder for each target", str(path))
    folders = sorted(p for p in path.iterdir() if p.is_dir() and p.name[0] not in "._")
    if not folders:
        raise Failure(f"this folder contains no target; add one: {path}/<name>/{MODULE}", str(path))
    yield from folders
