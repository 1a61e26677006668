"""JavaScript: a codec that interprets the model."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from mipgen import model as m
from mipgen.emit import package
from mipgen.emit.target import File, Target
from mipgen.targets.json import api as json


def files(model: m.Model) -> Iterator[File]:
    yield File("model.mjs", "model.mjs.j2")
    yield File("package.json", "package.json.j2")
    quickstart = model.program("quickstart.mjs")
    if quickstart:
        yield File("quickstart.mjs", "verbatim.j2", {"text": quickstart})
    yield File("README.md", "README.md.j2", {"quickstart": quickstart.rstrip()})


def filters(_: m.Model) -> Mapping[str, Callable[..., Any]]:
    return {"document": json.text}


TARGET = Target(
    title="JavaScript modules without dependencies",
    files=files,
    filters=filters,
    identifiers=json.identifiers,  # fields and types are found by the names that they have in JSON
    rename=package.in_source,
    beside="json",
    conformance=("parse", "decode", "encode"),
    program="node",
)
