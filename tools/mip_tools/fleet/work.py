"""What workers are asked to do."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Work:
    """The parameters that are the same for all logs."""

    package: str  # name or folder
    folder: Path  # of unfinished work
    names: tuple[str, ...]
    invalid: str
    sender: str | None = None  # the id of the device whose flags these are


@dataclass(frozen=True)
class Source:
    """A source of rows for a file: a fragment, or a small file of an earlier run."""

    path: Path
    bytes: int
    log: str = ""  # of a fragment
    device: str | None = None


@dataclass(frozen=True)
class Pack:
    """A file to make."""

    path: Path
    sources: tuple[Source, ...]
    group: int  # the minimum size of a row group, in bytes
