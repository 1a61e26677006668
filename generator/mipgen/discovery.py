"""Finds targets and their templates.

Built-in targets are the modules of `mipgen.targets` and the folders of `templates/`. A user's folder
(`--target-path`) contains a folder `<name>/` for each target, with templates and a `target.py`. If it
has the name of a built-in target, its templates, files of `runtime/` and module take precedence.
"""

from __future__ import annotations

import importlib
import importlib.util
import pkgutil
import sys
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import resources
from . import targets as ours
from .errors import Failure

if TYPE_CHECKING:
    from importlib.resources.abc import Traversable

MODULE = "target.py"
MANIFEST = ".manifest"  # the list of the files in a folder of output
CONTENTS = ("TITLE", "files", "identifiers", "filters")  # what a module of a target must have
OPERATIONS = ("parse", "decode", "encode", "client", "live")  # what a target may declare in CONFORMANCE


@dataclass(frozen=True, slots=True)
class Source:
    """The files of a target."""

    name: str
    folders: tuple[Traversable, ...]  # the first that has a file wins
    module: Path | None = None  # the user's target.py

    @property
    def ours(self) -> bool:
        return self.module is None and len(self.folders) == 1

    def load(self) -> Any:
        """The module of the target."""
        if self.module is None:
            return _declared(importlib.import_module(f"{ours.__name__}.{self.name}"), f"target {self.name}")
        name = f"mipgen_target_{self.name}"
        beside = [str(self.module.parent)]  # allows modules of its own: `from . import names`
        spec = importlib.util.spec_from_file_location(name, self.module, submodule_search_locations=beside)
        assert spec is not None and spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        sys.modules[name] = module
        try:
            spec.loader.exec_module(module)
        except SyntaxError as error:
            raise Failure(f"not Python: {error.msg}", f"{error.filename}:{error.lineno}") from None
        missing = [c for c in CONTENTS if not hasattr(module, c)]
        if missing:
            raise Failure(f"a target must have {' and '.join(missing)}", str(self.module))
        return _declared(module, str(self.module))


def _declared(module: Any, place: str) -> Any:
    """The module, if what it says about its driver can be understood."""
    conformance = getattr(module, "CONFORMANCE", ())
    unknown = [o for o in conformance if o not in OPERATIONS] if isinstance(conformance, tuple) else [conformance]
    if unknown:
        raise Failure(f"CONFORMANCE must be a tuple of {', '.join(map(repr, OPERATIONS))}, not {unknown[0]!r}", place)
    if not isinstance(getattr(module, "NEEDS", ""), str):
        raise Failure("NEEDS must be text: the tools of the driver, in few words", place)
    if not isinstance(getattr(module, "PROGRAM", ""), str):
        raise Failure("PROGRAM must be text: the name of a program that runs the driver", place)
    return module


def names() -> list[str]:
    """The built-in targets, in order."""
    return sorted(module.name for module in pkgutil.iter_modules(ours.__path__))


def sources(paths: Sequence[Path] = ()) -> dict[str, Source]:
    """All targets by name, in order; earlier folders take precedence."""
    found = {name: Source(name, (resources.root() / "templates" / name,)) for name in names()}
    for path in reversed(paths):
        for folder in _folders(path):
            name, module = folder.name, folder / MODULE
            before = found.get(name)
            if before is None and not module.is_file():
                near = _nearest(name, found)
                raise Failure(f"{MODULE} is missing, and there is no target '{name}'{near}", str(folder))
            found[name] = Source(
                name,
                (folder, *(before.folders if before else ())),
                module if module.is_file() else before.module if before else None,
            )
    return dict(sorted(found.items()))


def chosen(wanted: Sequence[str] | None, paths: Sequence[Path] = ()) -> list[Source]:
    """The selected targets, or all."""
    known = sources(paths)
    for name in wanted or ():
        if name not in known:
            raise Failure(f"unknown target '{name}'{_nearest(name, known)}")
    return [source for name, source in known.items() if not wanted or name in wanted]


def _folders(path: Path) -> Iterator[Path]:
    if not path.is_dir():
        raise Failure("there is no such folder; --target-path names the one above those of the targets", str(path))
    found = sorted(p for p in path.iterdir() if p.is_dir() and p.name[0] not in "._")
    if not found:
        raise Failure(f"there is no target in it; write one: {path}/<name>/{MODULE}", str(path))
    yield from found


def _nearest(name: str, known: Iterable[str]) -> str:
    from .problems import nearest  # imports the model, which a run with nothing to do does not need

    return nearest(name, known)
