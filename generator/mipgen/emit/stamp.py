"""Remembers the output of each input, so that a run without changes is fast.

It compares contents: a hash of the whole input, and digests of the output. If one byte of either
differs, everything is generated again.
"""

from __future__ import annotations

import functools
import hashlib
import json
import os
import sys
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from mipgen.base import cache, resources

from . import output

TOO_MUCH = 100 * 1024 * 1024  # bytes of input; a larger folder is not just a specification


@functools.cache
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


def run_key(folders: Sequence[Path], *options: str) -> str | None:
    """Computes a key of the program, its options and all files in these folders; None if there is too much input."""
    parts: list[bytes | str] = [program(), repr(options)]
    size = 0
    for folder in folders:
        parts.append("folder")
        for path, data in _files(folder):
            size += len(data)
            if size > TOO_MUCH:
                return None
            parts += [path, data]
    return cache.key(*parts)


def remember(name: str | None, summary: str, made: Mapping[str, tuple[str, Mapping[str, bytes]]]) -> None:
    """Remembers the output: target -> its title and its files."""
    if name is not None:
        targets = {
            target: {"title": title, "files": {path: _digest(data) for path, data in files.items()}}
            for target, (title, files) in made.items()
        }
        cache.put("made", {name: json.dumps({"summary": summary, "targets": targets}).encode("utf-8")})


def remembered(name: str | None, out: Path | None) -> dict[str, Any] | None:
    """Returns the output for this input, if all files exist unchanged and none is half-written."""
    data = None if name is None else cache.get("made", name)
    if data is None:
        return None
    stored: dict[str, Any] = json.loads(data)
    for target, made in stored["targets"].items():
        folder = (out or Path()) / target
        try:
            for path, wanted in made["files"].items():
                here = folder / path
                if not here.is_file() or _digest(here.read_bytes()) != wanted:  # a pipe would never end
                    return None
        except OSError:
            return None
        if output.unfinished(made["files"], folder):
            return None
    return stored


def _digest(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()


def _files(folder: Path) -> Iterator[tuple[str, bytes]]:
    """Yields all files below a folder, in order, except those in hidden folders. Folders may be links."""
    seen = {os.path.realpath(folder)}
    for place, folders, files in os.walk(folder, followlinks=True):
        real = {f: os.path.realpath(os.path.join(place, f)) for f in sorted(folders) if f[0] != "."}
        folders[:] = [f for f, path in real.items() if path not in seen]
        seen.update(real.values())
        for file in sorted(files):
            path = Path(place, file)
            try:
                data = path.read_bytes() if path.is_file() else b"no file"  # a pipe would never end
            except OSError:
                data = b"unreadable"
            yield path.relative_to(folder).as_posix(), data
