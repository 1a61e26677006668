"""Positions in the files of a specification."""

from __future__ import annotations

from typing import NamedTuple


class Position(NamedTuple):
    """A position in a specification file; lines and columns count from 1."""

    file: str
    line: int
    column: int

    def __str__(self) -> str:
        return f"{self.file}:{self.line}:{self.column}"
