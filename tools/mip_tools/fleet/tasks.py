"""The tasks of workers. Modules that need the generated package are imported after it has been chosen."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .. import binding
from .sources import Log


@dataclass(frozen=True)
class Work:
    """The parameters that are the same for all logs."""

    package: str  # name or folder
    folder: Path  # of unfinished work
    names: tuple[str, ...]
    invalid: str


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


def decode(work: Work, log: Log, identity: str) -> dict[str, Any]:
    """Makes the fragments of a log. Returns its facts, or, as `failed`, the reason why there are none."""
    binding.use(work.package)
    from .decode import decoded

    return decoded(work, log, identity)


def pack(work: Pack) -> tuple[int, int]:
    """Makes a file of rows. Returns their number, and their size in memory."""
    from .pack import packed

    return packed(work)


__all__ = ["Pack", "Source", "Work", "decode", "pack"]
