"""A file of a specification, read."""

from __future__ import annotations

from dataclasses import dataclass

from .nodes import Node


@dataclass(frozen=True, slots=True)
class Document:
    kind: str  # the schema that checks it
    path: str  # below the folder of its specification
    root: Node
