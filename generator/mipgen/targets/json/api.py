"""The interface of JSON for other targets: the document, and the names in it."""

from __future__ import annotations

from collections.abc import Iterator

from mipgen import model as m
from mipgen.emit.target import Identifier

from . import document

__all__ = ["identifiers", "text"]


def text(model: m.Model) -> str:
    """The document: one line for each item of a list. Several targets have it in one of their files."""
    return document.text(model)


def identifiers(model: m.Model) -> Iterator[Identifier]:
    """Fields and types are referred to by name. Scalars are types too."""
    return document.identifiers(model)
