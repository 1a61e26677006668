"""Renders a target: templates and runtime files in, the files of a folder out.

Everything is made in memory first, so that a failing run leaves nothing half-written; `output` writes it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import cache
from pathlib import PurePosixPath
from typing import Any, Protocol

import yaml

from . import discovery, formatting, output, resources
from .discovery import MANIFEST, Source
from .errors import Failure
from .model import Model
from .naming import Identifier

RUNTIME = "runtime"


@dataclass(frozen=True, slots=True)
class File:
    """One file to make: its path, its template, and the template's variables."""

    path: str
    template: str
    context: Mapping[str, Any] = field(default_factory=dict)
    target: str | None = None  # the built-in target whose template it is, if it is another's


class Target(Protocol):
    """The interface of a target's module.

    It may also have FORMATTER, a `formatting.Formatter`; MAX_IDENTIFIER, how many characters of a name its language
    looks at; LONG, true if it takes longer than others, so that it is begun first; and for its conformance driver
    CONFORMANCE, the operations that it offers, NEEDS, tools other than Python, a C compiler and cargo, and PROGRAM, a
    program without which it does not run.
    """

    TITLE: str  # "C99", shown by `mipgen generate`

    def files(self, model: Model) -> Iterable[File]: ...

    def identifiers(self, model: Model) -> Iterable[Identifier]: ...

    def filters(self, model: Model) -> Mapping[str, Callable[..., Any]]: ...


def names() -> list[str]:
    """All built-in targets, in order."""
    return discovery.names()


def target(name: str) -> Target:
    loaded: Target = discovery.sources()[name].load()
    return loaded


def language(name: str) -> dict[str, Any]:
    """The data of a language: templates/<name>/language.yaml."""
    text = (resources.root() / "templates" / name / "language.yaml").read_text("utf-8")
    found: dict[str, Any] = yaml.load(text, Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader))
    return found


def render(source: Source | str, model: Model) -> dict[str, bytes]:
    """All files of a target, by path."""
    if isinstance(source, str):
        source = discovery.sources()[source]
    from .templating import Templates  # imports Jinja, which checking names does not need

    module: Target = source.load()

    @cache
    def templates(other: str | None) -> Templates:
        of = discovery.sources()[other] if other else source
        return Templates(of, of.load().filters(model), {"model": model, "version": model.protocol.version})

    made = _runtime(source)
    made["LICENSE"] = (resources.root() / "LICENSE").read_bytes()
    for file in module.files(model):
        if PurePosixPath(file.path).is_absolute() or ".." in PurePosixPath(file.path).parts:
            raise Failure(f"{file.path} is outside of its folder", f"target {source.name}")
        if file.path in made or file.path == MANIFEST:
            raise Failure(f"{file.path} is made twice", f"target {source.name}")
        made[file.path] = templates(file.target).render(file.template, file.context, file.path).encode("utf-8")
    formatter = getattr(module, "FORMATTER", None)
    if formatter is not None:
        made = formatting.formatted(formatter, made)
    made[MANIFEST] = output.manifest(made)
    return made


def _runtime(source: Source) -> dict[str, bytes]:
    """The files that are copied unchanged."""
    made: dict[str, bytes] = {}
    for folder in reversed(source.folders):
        runtime = folder / RUNTIME
        if runtime.is_dir():
            made |= {path: file.read_bytes() for path, file in resources.files(runtime)}
    return made
