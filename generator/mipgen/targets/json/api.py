"""The JSON target's interface for other targets: the document, and the names in it."""

from __future__ import annotations

from collections.abc import Iterator

from mipgen import model as m
from mipgen.emit.target import Identifier

from . import document

__all__ = ["identifiers", "text"]


def text(model: m.Model) -> str:
    """Returns the document, with one line for each item of a list. Several targets include it in a file."""
    return model.derived(document.Document).text


def identifiers(model: m.Model) -> Iterator[Identifier]:
    """Yields the names that references to fields and types use. Scalars are types too."""
    return document.identifiers(model)
