"""Renders a target: templates and runtime files in, the files of a folder out.

Everything is made in memory first, so that a failed run leaves nothing half-written; `output` writes the files.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import yaml

from mipgen.base import resources
from mipgen.base.errors import Failure
from mipgen.model import Model

from . import discovery, formatting, output
from .discovery import Source
from .output import Made
from .slices import PLAN, Anew
from .target import File, Target

if TYPE_CHECKING:
    from .templating import Templates


def names() -> list[str]:
    """Returns the names of all built-in targets, in order."""
    return discovery.names()


def target(name: str) -> Target:
    """Loads a built-in target."""
    return discovery.sources()[name].load()


def language(name: str) -> dict[str, Any]:
    """Reads the data of a language: templates/<name>/language.yaml."""
    text = (resources.root() / "templates" / name / "language.yaml").read_text("utf-8")
    data: dict[str, Any] = yaml.load(text, Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader))
    return data


def render(source: Source | str, model: Model) -> dict[str, bytes]:
    """Makes all files of a target; returns them by path."""
    made = renew(discovery.sources()[source] if isinstance(source, str) else source, model, Anew())
    return {path: data for path, data in made.items() if isinstance(data, bytes)}


def renew(source: Source, model: Model, past: Anew) -> dict[str, Made]:
    """Makes the files of a target, except those that are still up to date since the last run."""
    right = past.all_right()
    if right is not None:
        past.keep(right)
        return right
    target, place = source.load(), f"target {source.name}"
    files, finished, templates, rename = past.make(PLAN, _plan, source, model)
    made: dict[str, Made] = {}
    for path, data in finished.items():
        if rename is None:
            made[path] = data
        else:  # paths also contain the name
            made[rename(path)] = rename(data.decode("utf-8")).encode("utf-8")
    for file in files:
        if not isinstance(file, File):
            raise Failure(f"files yields {file!r}; it must yield File(path, template)", place)
        path = file.path if rename is None else rename(file.path)
        output.admit(path, made, place)
        same = past.right(path)
        if same is None:
            text = past.make(path, templates.render, file.template, file.context, file.path)
            made[path] = (text if rename is None else rename(text)).encode("utf-8")
        else:
            made[path] = same
    if target.formatter is not None:
        made = formatting.formatted(target.formatter, made)
    made = output.finished(made, place)
    past.keep(made)
    return made


def _plan(
    source: Source, model: Model
) -> tuple[list[File], Mapping[str, bytes], Templates, Callable[[str], str] | None]:
    """Collects the files of a target, and what they share."""
    from .templating import Templates  # imports Jinja, which checking names does not need

    target = source.load()
    templates = Templates(source, target.filters(model), {"model": model, "version": model.protocol.version})
    finished = {"LICENSE": (resources.root() / "LICENSE").read_bytes(), **target.runtime(_runtime(source), model)}
    return list(target.files(model)), finished, templates, target.renaming(model.protocol.package)


def _runtime(source: Source) -> dict[str, bytes]:
    """Returns the files that are copied."""
    made: dict[str, bytes] = {}
    for runtime in reversed(source.runtimes):
        if runtime.is_dir():
            made |= {path: file.read_bytes() for path, file in resources.files(runtime)}
    return made
