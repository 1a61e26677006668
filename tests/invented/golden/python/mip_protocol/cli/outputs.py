"""Files that are either complete or absent."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO

from ..errors import Failure


@contextmanager
def whole(name: str, keep: bool = False) -> Iterator[IO[bytes]]:
    """A file to write, or standard output for `-`. It gets its name when it is complete.

    After an interrupt or an error nothing is left, unless the written part is to be kept. Raises Failure.
    """
    if name == "-":
        yield sys.stdout.buffer
        sys.stdout.buffer.flush()
        return
    with whole_path(name, keep) as part:
        try:
            file = open(part, "wb")
        except OSError as error:
            raise Failure(f"{name} cannot be written: {error.strerror}") from None
        with file:
            yield file


@contextmanager
def whole_path(name: str, keep: bool = False) -> Iterator[Path]:
    """A path beside a file, which replaces the file at the end. Raises Failure."""
    path = Path(name)
    if path.is_dir():
        raise Failure(f"{name} is a folder; name a file in it")
    if path.exists() and not path.is_file():  # such as /dev/null, which must not be replaced
        yield path
        return
    part = path.with_name(f"{path.name}.{os.getpid()}.part")
    try:
        yield part
    except BaseException as error:
        keeps = keep and isinstance(error, (KeyboardInterrupt, OSError)) and part.exists()
        if keeps:
            _rename(part, path)
        else:
            with suppress(OSError):
                part.unlink()
        if isinstance(error, OSError) and not isinstance(error, BrokenPipeError):
            kept = "; what came before is kept" if keeps else ""
            raise Failure(f"{name} cannot be written: {error.strerror or error}{kept}") from None
        raise
    _rename(part, path)


def _rename(part: Path, path: Path) -> None:
    try:
        os.replace(part, path)
    except OSError as error:
        with suppress(OSError):
            part.unlink()
        raise Failure(f"{path} cannot be written: {error.strerror}") from None


def note(text: str) -> None:
    """Reports what was done, only on a terminal."""
    if sys.stderr.isatty():
        print(text, file=sys.stderr)


__all__ = ["note", "whole", "whole_path"]
