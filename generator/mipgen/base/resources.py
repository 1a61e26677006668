"""The files that come with the program: templates, schemas, the licence, a specification to start from."""

from __future__ import annotations

import functools
from collections.abc import Iterator
from pathlib import Path

#: Programs that show the bindings with fields of MIP, and parts of the bindings' READMEs about them.
PROGRAMS = ("examples", "docs/parts")

MANIFEST = ".manifest"  # the list of the files in an output folder


#: The folder of this program.
PACKAGE = Path(__file__).parents[1]


@functools.cache
def root() -> Path:
    """Returns the folder that contains `templates/`, `spec/schema/` and `LICENSE`.

    In a wheel they are in `mipgen/data`. In a checkout they are at the top, where people look for them.
    """
    installed = PACKAGE / "data"
    return installed if installed.is_dir() else PACKAGE.parents[1]


def files_in(folder: Path, under: str = "") -> Iterator[tuple[str, Path]]:
    """Yields all files below a folder with their paths, in order, without hidden folders and Python's caches."""
    for entry in sorted(folder.iterdir(), key=lambda e: e.name):
        if entry.is_file():
            yield under + entry.name, entry
        elif entry.name != "__pycache__" and not entry.name.startswith("."):
            yield from files_in(entry, f"{under}{entry.name}/")
