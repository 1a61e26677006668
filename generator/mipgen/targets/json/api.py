"""What other targets may ask of JSON: the document, and the names in it."""

from __future__ import annotations

from . import identifiers
from .document import text

__all__ = ["identifiers", "text"]
