"""Renders a target: templates and runtime files in, a folder out.

Everything is made in memory first; files are written only where they change, and files of an
earlier run that are no longer made are removed, so a failing run leaves nothing half-written.
"""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Protocol

import jinja2
import yaml

from . import formatting
from . import targets as targets_package
from .model import Model
from .naming import Identifier

ROOT = Path(__file__).parents[2]
MANIFEST = ".manifest"


@dataclass(frozen=True, slots=True)
class File:
    """One file to make: where, from which template, with what."""

    path: str
    template: str
    context: Mapping[str, Any] = field(default_factory=dict)


class Target(Protocol):
    """What a module of `mipgen.targets` offers; FORMATTER, a `formatting.Formatter`, may be left out."""

    TITLE: str  # "C99", shown by `mipgen generate`

    def files(self, model: Model) -> Iterable[File]: ...

    def identifiers(self, model: Model) -> Iterable[Identifier]: ...

    def filters(self, model: Model) -> Mapping[str, Callable[..., Any]]: ...


def names() -> list[str]:
    """All targets, in order."""
    return sorted(module.name for module in pkgutil.iter_modules(targets_package.__path__))


def target(name: str) -> Target:
    module: Any = importlib.import_module(f"{targets_package.__name__}.{name}")
    loaded: Target = module
    return loaded


def language(name: str) -> dict[str, Any]:
    """The facts of a language that are data: templates/<name>/language.yaml."""
    path = ROOT / "templates" / name / "language.yaml"
    found: dict[str, Any] = yaml.safe_load(path.read_text("utf-8"))
    return found


def render(name: str, model: Model) -> dict[str, bytes]:
    """All files of a target, by path."""
    module, folder = target(name), ROOT / "templates" / name
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(folder),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
        auto_reload=False,
        extensions=["jinja2.ext.do"],
    )
    environment.filters.update(module.filters(model))
    environment.globals.update(model=model, version=model.protocol.version)
    made = {path: data for path, data in _runtime(folder / "runtime")}
    made["LICENSE"] = (ROOT / "LICENSE").read_bytes()
    for file in module.files(model):
        if file.path in made:
            raise ValueError(f"{name}: {file.path} is made twice")
        text = environment.get_template(file.template).render(file.context)
        made[file.path] = text.encode("utf-8")
    formatter = getattr(module, "FORMATTER", None)
    if formatter is not None:
        made = formatting.formatted(formatter, made)
    made[MANIFEST] = "".join(f"{path}\n" for path in sorted(made)).encode("utf-8")
    return made


def _runtime(folder: Path) -> Iterator[tuple[str, bytes]]:
    for path in sorted(folder.rglob("*")) if folder.is_dir() else ():
        if path.is_file() and "__pycache__" not in path.parts:
            yield path.relative_to(folder).as_posix(), path.read_bytes()


@dataclass(frozen=True, slots=True)
class Difference:
    path: str
    what: str  # "missing", "changed", "stale" or "untracked"


def compare(made: Mapping[str, bytes], folder: Path) -> list[Difference]:
    """How a folder differs from what it should hold."""
    there = _present(folder)
    found = [
        Difference(p, "missing" if p not in there else "changed")
        for p in sorted(made)
        if p not in there or (folder / p).read_bytes() != made[p]
    ]
    stale = _manifest(folder)
    found += [Difference(p, "stale" if p in stale else "untracked") for p in sorted(there - made.keys())]
    return found


def write(made: Mapping[str, bytes], folder: Path) -> list[Difference]:
    """Makes the folder hold these files. What a user put beside them stays."""
    done = []
    for d in compare(made, folder):
        path = folder / d.path
        if d.what in ("missing", "changed"):
            path.parent.mkdir(parents=True, exist_ok=True)
            part = path.with_name(path.name + ".part")
            part.write_bytes(made[d.path])
            part.replace(path)
            done.append(d)
        elif d.what == "stale":
            path.unlink()
            done.append(d)
            for parent in path.parents:
                if parent == folder or any(parent.iterdir()):
                    break
                parent.rmdir()
    return done


def _present(folder: Path) -> set[str]:
    """The files of a folder; what build tools leave behind does not count."""
    ignored = {"__pycache__", "target", "build", "dist", ".mypy_cache", ".ruff_cache", ".pytest_cache"}
    return {
        p.relative_to(folder).as_posix()
        for p in folder.rglob("*")
        if p.is_file() and not ignored.intersection(p.relative_to(folder).parts) and ".egg-info" not in str(p)
    } if folder.is_dir() else set()  # fmt: skip


def _manifest(folder: Path) -> set[str]:
    path = folder / MANIFEST
    return set(path.read_text("utf-8").splitlines()) if path.is_file() else set()
