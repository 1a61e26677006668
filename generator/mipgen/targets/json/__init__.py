"""The whole specification as one JSON file, for tools in any language."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from mipgen import model as m
from mipgen.emit import package
from mipgen.emit.target import File, Target
from mipgen.facts.sample_values import SampleValues

from . import document


def files(model: m.Model) -> Iterator[File]:
    yield File("mip.json", "mip.json.j2")
    yield File("README.md", "README.md.j2", {"format": document.FORMAT, "shown": shown(model)})


def shown(model: m.Model) -> m.Field:
    """Returns a short, instructive field for the README: a command with a selector and an enumeration."""
    commands = [f for f in model.fields if f.functions and any(isinstance(p.element, m.Enum) for p in f.counted)]
    return min(commands or model.fields, key=lambda f: len(f.parameters))


def filters(model: m.Model) -> Mapping[str, Callable[..., Any]]:
    return {"document": document.text, "lines": lambda f: document.lines(f, model.derived(SampleValues))}


TARGET = Target(
    title="the specification as JSON, with a JSON Schema",
    files=files,
    filters=filters,
    identifiers=document.identifiers,
    rename=package.in_source,
    conformance=("decode", "encode"),
)
