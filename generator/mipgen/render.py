"""Renders a target: templates and runtime files in, a folder out.

Everything is made in memory first; files are written only where they change, and files of an
earlier run that are no longer made are removed, so a failing run leaves nothing half-written.
"""

from __future__ import annotations

import sys
import traceback
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Protocol

import jinja2
import yaml

from . import cache, discovery, formatting, resources
from .discovery import Source
from .errors import Failure
from .model import Model
from .naming import Identifier

MANIFEST = ".manifest"
RUNTIME = "runtime"

_SETTINGS: dict[str, Any] = {
    "trim_blocks": True,
    "lstrip_blocks": True,
    "keep_trailing_newline": True,
    "autoescape": False,
    "extensions": ["jinja2.ext.do"],
}


@dataclass(frozen=True, slots=True)
class File:
    """One file to make: where, from which template, with what."""

    path: str
    template: str
    context: Mapping[str, Any] = field(default_factory=dict)


class Target(Protocol):
    """What the module of a target offers; FORMATTER, a `formatting.Formatter`, may be left out."""

    TITLE: str  # "C99", shown by `mipgen generate`

    def files(self, model: Model) -> Iterable[File]: ...

    def identifiers(self, model: Model) -> Iterable[Identifier]: ...

    def filters(self, model: Model) -> Mapping[str, Callable[..., Any]]: ...


def names() -> list[str]:
    """All targets that come with the program, in order."""
    return discovery.names()


def target(name: str) -> Target:
    loaded: Target = discovery.sources()[name].load()
    return loaded


def language(name: str) -> dict[str, Any]:
    """The facts of a language that are data: templates/<name>/language.yaml."""
    text = (resources.root() / "templates" / name / "language.yaml").read_text("utf-8")
    found: dict[str, Any] = yaml.safe_load(text)
    return found


def render(source: Source | str, model: Model) -> dict[str, bytes]:
    """All files of a target, by path."""
    if isinstance(source, str):
        source = discovery.sources()[source]
    module: Target = source.load()
    environment = _environment(source, module.filters(model))
    environment.globals.update(model=model, version=model.protocol.version)
    made = _runtime(source)
    made["LICENSE"] = (resources.root() / "LICENSE").read_bytes()
    for file in module.files(model):
        if file.path in made:
            raise Failure(f"{file.path} is made twice", f"target {source.name}")
        made[file.path] = _rendered(environment, file, source).encode("utf-8")
    formatter = getattr(module, "FORMATTER", None)
    if formatter is not None:
        made = formatting.formatted(formatter, made)
    made[MANIFEST] = "".join(f"{path}\n" for path in sorted(made)).encode("utf-8")
    return made


def _environment(source: Source, filters: Mapping[str, Callable[..., Any]]) -> jinja2.Environment:
    def load(name: str) -> tuple[str, str, Callable[[], bool]] | None:
        for folder in source.folders:
            path = folder / name
            if path.is_file():
                return path.read_text("utf-8"), str(path), lambda: True
        return None

    environment = jinja2.Environment(
        loader=jinja2.FunctionLoader(load),
        undefined=jinja2.StrictUndefined,
        bytecode_cache=_Compiled([*sorted(filters)]),
        **_SETTINGS,
    )
    environment.filters.update({name: _at_run_time(function) for name, function in filters.items()})
    return environment


class _Compiled(jinja2.BytecodeCache):
    """Keeps templates compiled. What they are compiled to depends on the names of the filters too."""

    def __init__(self, filters: list[str]) -> None:
        self.how = repr((jinja2.__version__, sys.version, sorted(_SETTINGS.items()), filters))

    def load_bytecode(self, bucket: Any) -> None:
        data = cache.get("templates", cache.key(self.how, bucket.key, bucket.checksum))
        if data is not None:
            bucket.bytecode_from_string(data)

    def dump_bytecode(self, bucket: Any) -> None:
        cache.put("templates", {cache.key(self.how, bucket.key, bucket.checksum): bucket.bytecode_to_string()})


def _at_run_time(function: Callable[..., Any]) -> Callable[..., Any]:
    """The filter, never called while a template is compiled: Jinja would put its answer into what is kept."""
    if hasattr(function, "jinja_pass_arg"):
        return function

    @jinja2.pass_context
    def call(_: Any, *arguments: Any, **named: Any) -> Any:
        return function(*arguments, **named)

    return call


def _rendered(environment: jinja2.Environment, file: File, source: Source) -> str:
    try:
        return environment.get_template(file.template).render(file.context)
    except jinja2.TemplateNotFound as error:
        raise Failure(f"there is no template {error.name} (for {file.path})", f"target {source.name}") from None
    except jinja2.TemplateSyntaxError as error:
        raise Failure(f"{error.message} (for {file.path})", f"{error.filename}:{error.lineno}") from None
    except jinja2.TemplateRuntimeError as error:
        raise Failure(f"{error.message} (for {file.path})", _place(error, source)) from None


def _place(error: BaseException, source: Source) -> str:
    """The line of a template where it happened."""
    folders = tuple(map(str, source.folders))
    frames = reversed(traceback.extract_tb(error.__traceback__))
    return next((f"{f.filename}:{f.lineno}" for f in frames if f.filename.startswith(folders)), source.name)


def _runtime(source: Source) -> dict[str, bytes]:
    """The files that are copied as they are."""
    made: dict[str, bytes] = {}
    for folder in reversed(source.folders):
        runtime = folder / RUNTIME
        if runtime.is_dir():
            made |= {path: file.read_bytes() for path, file in resources.files(runtime)}
    return made


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
    """Makes the folder hold these files. Files that a user added are kept."""
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
