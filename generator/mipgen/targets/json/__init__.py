"""The whole specification as one JSON file, for tools in any language.

`document` writes it; mip.schema.json and the README in runtime/json describe it.
"""

from __future__ import annotations

from collections.abc import Iterator

from mipgen import model as m
from mipgen.emit import package
from mipgen.emit.target import File, Target

from . import document


def files(model: m.Model) -> Iterator[File]:
    for name in ("mip.json", "README.md"):
        yield File(name, f"{name}.j2", {"document": model.derived(document.Document)})


TARGET = Target(
    title="the specification as JSON, with a JSON Schema",
    files=files,
    identifiers=document.identifiers,
    rename=package.in_source,
    conformance=("decode", "encode"),
)
