"""Finds the logs of a fleet: their locations, their names, and whether two are the same."""

from __future__ import annotations

import hashlib
import shutil
import tempfile
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from fnmatch import fnmatch
from importlib import import_module
from pathlib import Path, PurePosixPath
from typing import IO, Any, cast

from ..binding import MissingExtra
from ..errors import Failure, Misuse

#: The number of bytes at the beginning and at the end of a log that, with its size, identify it.
_ENDS = 1 << 16


@dataclass(frozen=True)
class Log:
    """A log: its name in the data set, and its path or URL."""

    name: str
    place: str

    @property
    def remote(self) -> bool:
        """Is the location a URL, for example of a bucket?"""
        return is_url(self.place)

    def identity(self) -> tuple[str, int]:
        """Returns an identity that does not depend on the name, and the size. Raises OSError."""
        with self._opened() as file:
            size = file.seek(0, 2)
            digest = hashlib.sha256(b"%d" % size)
            for begin in (0, max(0, size - _ENDS)):
                file.seek(begin)
                digest.update(file.read(_ENDS))
        return digest.hexdigest()[:24], size

    @contextmanager
    def local(self) -> Iterator[str]:
        """Provides a path on this machine; for a URL, the path of a temporary copy. Raises OSError."""
        if not self.remote:
            yield self.place
            return
        with tempfile.TemporaryDirectory(prefix="mip-") as folder:
            path = Path(folder, "log")
            with self._opened() as source, path.open("wb") as copy:
                shutil.copyfileobj(source, copy, 1 << 20)
            yield str(path)

    def _opened(self) -> IO[bytes]:
        if not self.remote:
            return open(self.place, "rb")
        system, path = file_system(self.place)
        return cast(IO[bytes], system.open(path, "rb"))


def find_logs(sources: Iterable[str], pattern: str) -> list[Log]:
    """Finds the logs whose names match a pattern in folders and under URLs, and the logs that are named directly.

    Returns them sorted by name. Raises Misuse.
    """
    logs: dict[str, Log] = {}
    for source in sources:
        several = list(_in(source, pattern))
        if not several:
            raise Misuse(f"{source} has no files that match {pattern}; see --pattern")
        for log in several:
            other = logs.setdefault(log.name, log)
            if other.place != log.place:
                raise Misuse(f"{other.place} and {log.place} are both called {log.name}; name a folder with both")
    return [logs[name] for name in sorted(logs)]


def is_url(place: str) -> bool:
    return "://" in place


def _in(source: str, pattern: str) -> Iterator[Log]:
    if is_url(source):
        with store_errors(source, "read"):
            yield from _in_store(source, pattern)
        return
    place = Path(source)
    if not place.is_dir():
        if not place.exists():
            raise Misuse(f"{source} does not exist")
        yield Log(place.name, str(place.resolve()))
        return
    for path in place.rglob(pattern):
        if path.is_file():
            yield Log(path.relative_to(place).as_posix(), str(path.resolve()))


def _in_store(source: str, pattern: str) -> Iterator[Log]:
    system, top = file_system(source)
    if not system.isdir(top):
        yield Log(PurePosixPath(top).name, source)
        return
    for path in system.find(top):
        name = PurePosixPath(path).relative_to(top.rstrip("/")).as_posix()
        if fnmatch(PurePosixPath(path).name, pattern):
            yield Log(name, system.unstrip_protocol(path))


@contextmanager
def store_errors(url: str, what: str) -> Iterator[None]:
    """Words the errors of a store, of which each has its own kinds. Raises Failure."""
    try:
        yield
    except (Failure, Misuse):
        raise
    except Exception as error:
        reason = str(error).splitlines() or [type(error).__name__]
        raise Failure(f"{url} cannot be {what}: {reason[0]}") from None


def file_system(url: str) -> tuple[Any, str]:
    """Returns the file system of a URL, and the path in it. Raises Misuse if its package is not installed."""
    try:
        core = import_module("fsspec.core")
    except ImportError:
        raise Misuse(f"{url}: {MissingExtra('fsspec', 'fleet')}") from None
    try:
        return cast(tuple[Any, str], core.url_to_fs(url))
    except (ImportError, ValueError) as error:
        raise Misuse(f"{url}: {error}") from None
