"""Renders a target: templates and runtime files in, the files of a folder out.

Everything is made in memory first, so that a failed run leaves nothing half-written; `output` writes the files.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import yaml

from mipgen.base import resources
from mipgen.base.errors import Failure
from mipgen.model import Model

from . import discovery, formatting, output
from .discovery import Source
from .naming import Identifier
from .target import File

if TYPE_CHECKING:
    from mipgen.model import Device, Family, Field, Set, Struct
    from mipgen.model.guides import Guide


def language(name: str) -> dict[str, Any]:
    """Reads the data of a language: templates/<name>/language.yaml."""
    text = (resources.root() / "templates" / name / "language.yaml").read_text("utf-8")
    data: dict[str, Any] = yaml.load(text, Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader))
    return data


def render(source: Source | str, model: Model) -> dict[str, bytes]:
    """Makes all files of a target; returns them by path."""
    from .templating import Templates  # imports Jinja, which checking names does not need

    if isinstance(source, str):
        source = discovery.targets()[source]
    target, place = source.load(), f"target {source.name}"
    templates = Templates(source, target.filters, {"model": model, "version": model.protocol.version})
    made = {"LICENSE": (resources.root() / "LICENSE").read_bytes(), **target.runtime(_runtime(source), model)}
    made = {path: data for path, data in made.items() if source.has(path)}
    paths = [*made]
    rename = target.renaming(model.protocol.package)
    if rename is not None:  # paths also contain the name
        made = {rename(path): rename(data.decode("utf-8")).encode("utf-8") for path, data in made.items()}
    for file in target.files(model):
        if not isinstance(file, File):
            raise Failure(f"files yields {file!r}; it must yield File(path, template)", place)
        if not source.has(file.path):
            continue
        path = file.path if rename is None else rename(file.path)
        output.admit(path, made, place)
        context = file.context(paths) if callable(file.context) else file.context
        text = templates.render(file.template, context, file.path) if file.template else str(context["text"])
        paths.append(file.path)
        made[path] = (text if rename is None else rename(text)).encode("utf-8")
    if target.formatter is not None:
        made = formatting.formatted(target.formatter, made)
    return output.with_manifest(made, place)


def paths(source: Source, model: Model) -> Iterator[Identifier]:
    """Yields the path of each file of a target, first of those that are the same for every specification."""
    target, whole = source.load(), model.protocol.position
    files = [file for file in target.files(model) if isinstance(file, File)]
    made: set[str] = set()
    for path in ("LICENSE", *target.runtime(_runtime(source), model), *(f.path for f in files if f.of is None)):
        output.admit(path, made, f"target {source.name}")
        made.add(path)
        yield Identifier("files", path, f"{path} of every package", whole, word=False)
    for file in files:
        if file.of is not None:
            yield Identifier("files", file.path, _named(file.of), file.of.position, word=False)


def _named(thing: Family | Set | Field | Struct | Device | Guide) -> str:
    """Writes which part of the specification it is, for a message."""
    if hasattr(thing, "full_name"):
        return thing.full_name
    return f"{type(thing).__name__.lower()} {getattr(thing, 'id', None) or thing.name}".replace("family", "set")


def _runtime(source: Source) -> dict[str, bytes]:
    """Returns the files that are copied."""
    made: dict[str, bytes] = {}
    for runtime in reversed(source.runtimes):
        if runtime.is_dir():
            made |= {path: file.read_bytes() for path, file in resources.files_in(runtime)}
    return made
