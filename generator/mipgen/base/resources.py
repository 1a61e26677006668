"""The files that come with the program: templates, schemas, the licence, a specification to start from."""

from __future__ import annotations

import functools
import importlib.resources
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from importlib.resources.abc import Traversable

#: Programs that show the bindings with fields of MIP, and parts of the bindings' READMEs about them.
PROGRAMS = ("examples", "docs/parts")

MANIFEST = ".manifest"  # the list of the files in an output folder


@functools.cache
def root() -> Traversable:
    """Returns the folder that contains `templates/`, `spec/schema/` and `LICENSE`.

    In a wheel they are in `mipgen/data`. In a checkout they are at the top, where people look for them.
    """
    installed = package() / "data"
    return installed if installed.is_dir() else Path(__file__).parents[3]


def package() -> Traversable:
    return importlib.resources.files("mipgen")


def files_in(folder: Traversable, under: str = "") -> Iterator[tuple[str, Traversable]]:
    """Yields all files below a folder with their paths, in order, without hidden files and Python's caches."""
    for entry in sorted(folder.iterdir(), key=lambda e: e.name):
        if entry.is_file():
            yield under + entry.name, entry
        elif entry.name != "__pycache__" and not entry.name.startswith("."):
            yield from files_in(entry, f"{under}{entry.name}/")
