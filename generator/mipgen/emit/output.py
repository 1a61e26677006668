"""Compares an output folder with the files that it should contain, and writes these.

The manifest of a folder lists the files that mipgen wrote; only these are replaced or removed. It lists new files
before they are written, and old files until they are removed, so that a run completes an interrupted one.
"""

from __future__ import annotations

import contextlib
import os
import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

from mipgen.base.errors import Failure
from mipgen.base.resources import MANIFEST

#: The first line of a manifest. A file of that name without it is a user's.
HEADER = "# Files that mipgen wrote, and may replace or remove"

#: The suffix of a file's name until it is completely written.
_PART = re.compile(r"\.[0-9]+\.part$")

#: Folders of build tools.
_BUILT = {"__pycache__", "target", "build", "dist", ".mypy_cache", ".ruff_cache", ".pytest_cache"}


#: The kinds of differences for files that mipgen did not write: in the way, or not.
OTHERS = ("foreign", "untracked")


@dataclass(frozen=True, slots=True)
class Difference:
    path: str
    what: str  # "missing", "changed", "stale", or one of OTHERS


def admit(path: str, made: Collection[str], place: str) -> None:
    """Raises Failure if a target may not add this file to the files that it has made."""
    plain = PurePosixPath(path)
    if plain.is_absolute() or ".." in plain.parts:
        raise Failure(f"{path} is outside of its folder", place)
    if str(plain) != path or path == "." or "\\" in path or not path.isprintable():
        raise Failure(f"{path!r} is not a file path; separate names with /", place)
    if path in made or path == MANIFEST:
        raise Failure(f"{path} is made twice", place)


def with_manifest(made: Mapping[str, bytes], place: str) -> dict[str, bytes]:
    """Returns all files of a target, with the manifest."""
    both = sorted(made.keys() & _parents(made))
    if both:
        raise Failure(f"{both[0]} is both a file and a folder", place)
    return {**made, MANIFEST: manifest(made)}


def manifest(paths: Iterable[str]) -> bytes:
    return "".join(f"{line}\n" for line in (HEADER, *sorted(paths))).encode("utf-8")


def compare(made: Mapping[str, bytes], folder: Path) -> list[Difference]:
    """Compares a folder with its intended content."""
    ours = _ours(folder)
    paths = ours | made.keys()
    parents = ((p, folder / p) for p in sorted(_parents(made)))
    differences = [Difference(p, "foreign") for p, path in parents if os.path.lexists(path) and not path.is_dir()]
    for p in sorted(made):
        path = folder / p
        if not os.path.lexists(path):
            differences.append(Difference(p, "missing"))
        elif not path.is_file() or path.read_bytes() != made[p]:
            differences.append(Difference(p, "changed" if p in ours and _plain(path) else "foreign"))
    for p in sorted(_present(folder, paths) - made.keys()):
        stale = _PART.sub("", p) in paths and _plain(folder / p)
        differences.append(Difference(p, "stale" if stale else "untracked"))
    return differences


def write(made: Mapping[str, bytes], folder: Path, differences: Sequence[Difference] | None = None) -> list[Difference]:
    """Writes these files to the folder, also over foreign files; untracked files are kept. `differences` are those of
    the folder, if they are known.
    """
    differences = [d for d in (compare(made, folder) if differences is None else differences) if d.what != "untracked"]
    ours = _ours(folder)
    if not made.keys() <= ours:  # before these files, so that they are known as ours
        _put(folder / MANIFEST, manifest((ours | made.keys()) - {MANIFEST}))
    for d in differences:
        if d.what == "stale":
            (folder / d.path).unlink(missing_ok=True)  # removes a partial file of an earlier process with the same id
    for parent in sorted(_parents(ours) - _parents(made), reverse=True):
        with contextlib.suppress(OSError):  # it is not empty, or does not exist
            (folder / parent).rmdir()
    for d in differences:
        if d.path in made:
            _put(folder / d.path, made[d.path])
    return differences


def unfinished(made: Collection[str], folder: Path) -> bool:
    """True if a run was interrupted while it wrote one of these files."""
    return any(_PART.search(p) and _PART.sub("", p) in made for p in _present(folder, made))


def _put(path: Path, data: bytes) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_name(f"{path.name}.{os.getpid()}.part")
    part.write_bytes(data)
    part.replace(path)


def _plain(path: Path) -> bool:
    return path.is_file() and not path.is_symlink()


def _ours(folder: Path) -> set[str]:
    """Returns the files that mipgen wrote, even if they no longer exist."""
    path = folder / MANIFEST
    lines = path.read_text("utf-8", "replace").splitlines() if path.is_file() else []
    return {MANIFEST, *lines[1:]} if lines[:1] == [HEADER] else set()


def _parents(paths: Iterable[str]) -> set[str]:
    """Returns the folders above these paths; "" is the outermost one."""
    folders: set[str] = set()
    for p in paths:
        while (p := os.path.dirname(p)) not in folders:
            folders.add(p)
    return folders


def _present(folder: Path, written: Iterable[str]) -> set[str]:
    """Returns the files of a folder, except in build folders that contain no known file."""
    paths: set[str] = set()
    wanted = _parents(written)
    for place, folders, files in os.walk(folder):
        under = "".join(f"{part}/" for part in Path(place).relative_to(folder).parts)
        folders[:] = [f for f in folders if under + f in wanted or not (f in _BUILT or f.endswith(".egg-info"))]
        paths.update(under + f for f in files)
    return paths
