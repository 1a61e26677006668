"""A cache in the user's folder for results that are slow to compute and depend only on their input.

The cache is optional: an entry that is missing, damaged or cannot be written costs only time.
`MIPGEN_CACHE` selects another folder; an empty value turns the cache off.
"""

from __future__ import annotations

import hashlib
import os
import tempfile
from pathlib import Path

LIMIT = 64 * 1024 * 1024  # bytes of one kind of entries; the oldest are removed first

_OVERHEAD = 4096  # of a file, about
_DIGEST = 32  # each entry begins with the SHA-256 of the rest


def cache_folder() -> Path | None:
    """Returns the folder of the cache, if it is enabled."""
    chosen = os.environ.get("MIPGEN_CACHE")
    if chosen is not None:
        return Path(chosen) if chosen else None
    base = os.environ.get("XDG_CACHE_HOME", "")
    if os.path.isabs(base):
        return Path(base, "mipgen")
    try:
        return Path.home() / ".cache" / "mipgen"
    except RuntimeError:  # the user has no home folder
        return None


def key(*parts: bytes | str) -> str:
    """Returns a name for the result of these inputs."""
    digest = hashlib.sha256()
    for part in parts:
        data = part.encode("utf-8", "surrogateescape") if isinstance(part, str) else part
        digest.update(len(data).to_bytes(8, "big"))
        digest.update(data)
    return digest.hexdigest()


def get(kind: str, name: str) -> bytes | None:
    path = _path(kind, name)
    if path is None:
        return None
    try:
        data = path.read_bytes()
        if hashlib.sha256(data[_DIGEST:]).digest() != data[:_DIGEST]:
            return None
        os.utime(path)  # so that entries in use are not the oldest
    except OSError:
        return None
    return data[_DIGEST:]


def put(kind: str, entries: dict[str, bytes]) -> None:
    """Stores entries by name, each atomically."""
    for name, data in entries.items():
        path = _path(kind, name)
        if path is None:
            return
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            handle, part = tempfile.mkstemp(dir=path.parent, prefix=".")
            with os.fdopen(handle, "wb") as file:
                file.write(hashlib.sha256(data).digest() + data)
            os.replace(part, path)
        except OSError:
            return
    if any(name.startswith("0") for name in entries):  # only now and then: examining all entries is slow
        _prune(kind)


def _path(kind: str, name: str) -> Path | None:
    base = cache_folder()
    return None if base is None else base / kind / name


def _prune(kind: str) -> None:
    base = cache_folder()
    if base is None:
        return
    try:
        entries = [(x.stat(), x.path) for x in os.scandir(base / kind)]
    except OSError:
        return
    size = 0
    for status, path in sorted(entries, key=lambda x: x[0].st_mtime, reverse=True):
        size += status.st_size + _OVERHEAD
        if size > LIMIT:
            try:
                os.unlink(path)
            except OSError:
                pass
