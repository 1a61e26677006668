"""A specification file that has been read."""

from __future__ import annotations

from dataclasses import dataclass

from .nodes import Node


@dataclass(frozen=True, slots=True)
class Document:
    kind: str  # the schema that validates it
    path: str  # relative to the folder of its specification
    root: Node
