"""A key of the program itself, so that results of another version are not used."""

from __future__ import annotations

import os
import sys
from functools import cache as once

from . import cache, resources


@once
def program() -> str:
    """Returns a key of everything except the input: this program, its templates and schemas, Python, the libraries."""
    parts: list[bytes | str] = [sys.version, *_libraries()]
    root = resources.root()
    data = ("templates", "runtime", "spec/schema", *resources.PROGRAMS)
    for folder in (resources.PACKAGE, *(root / name for name in data)):
        for path, file in resources.files_in(folder):
            parts += [path, file.read_bytes()]
    return cache.key(*parts, (root / "LICENSE").read_bytes())


def _libraries() -> list[str]:
    """Returns names and versions of installed packages, taken from folder names, because reading the contents is
    slow."""
    places = [entry for entry in sys.path if os.path.isdir(entry)]
    return sorted(name for place in places for name in os.listdir(place) if name.endswith((".dist-info", ".egg-info")))
