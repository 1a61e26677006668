"""Renders a target: templates and runtime files in, the files of a folder out.

Everything is made in memory first, so that a failing run leaves nothing half-written; `output` writes it.
"""

from __future__ import annotations

from typing import Any

import yaml

from mipgen.base import resources
from mipgen.base.errors import Failure
from mipgen.model import Model

from . import discovery, formatting, output
from .discovery import Source
from .target import File, Target


def names() -> list[str]:
    """All built-in targets, in order."""
    return discovery.names()


def target(name: str) -> Target:
    """A built-in target."""
    return discovery.sources()[name].load()


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

    target = source.load()

    templates = Templates(source, target.filters(model), {"model": model, "version": model.protocol.version})
    place = f"target {source.name}"
    made = _runtime(source)
    made["LICENSE"] = (resources.root() / "LICENSE").read_bytes()
    for file in target.files(model):
        if not isinstance(file, File):
            raise Failure(f"files yields {file!r}; it must yield File(path, template)", place)
        output.admit(file.path, made, place)
        made[file.path] = templates.render(file.template, file.context, file.path).encode("utf-8")
    rename = target.renaming(model.protocol.package)
    if rename is not None:  # in paths too
        made = {rename(path): rename(data.decode("utf-8")).encode("utf-8") for path, data in made.items()}
    if target.formatter is not None:
        made = formatting.formatted(target.formatter, made)
    return output.finished(made, place)


def _runtime(source: Source) -> dict[str, bytes]:
    """The files that are copied unchanged."""
    made: dict[str, bytes] = {}
    for runtime in reversed(source.runtimes):
        if runtime.is_dir():
            made |= {path: file.read_bytes() for path, file in resources.files(runtime)}
    return made
