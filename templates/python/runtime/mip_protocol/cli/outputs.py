"""Files that are either complete or absent."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO

from ..errors import Failure, Misuse


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
        try:
            yield path
        except OSError as error:
            raise _failed(name, error) from None
        return
    part = path.with_name(f"{path.name}.{os.getpid()}.part")
    try:
        yield part
    except BaseException as error:
        keeps = keep and isinstance(error, (KeyboardInterrupt, OSError)) and holds_bytes(part)
        if keeps:
            _rename(part, path, keep)
        else:
            with suppress(OSError):
                part.unlink()
        if isinstance(error, OSError):
            raise _failed(name, error, "; what came before is kept" if keeps else "") from None
        raise
    _rename(part, path, keep)


def _failed(name: str, error: OSError, more: str = "") -> Exception:
    """A pipe whose reader has stopped is no failure."""
    if isinstance(error, BrokenPipeError):
        return error
    return Failure(f"{name} cannot be written: {error.strerror or error}{more}")


def _rename(part: Path, path: Path, keep: bool) -> None:
    try:
        os.replace(part, path)
    except OSError as error:
        if keep:
            raise _failed(str(path), error, f"; the bytes are in {part}") from None
        with suppress(OSError):
            part.unlink()
        raise _failed(str(path), error) from None


def holds_bytes(path: str | Path) -> bool:
    """Is this a file that is not empty?"""
    return os.path.isfile(path) and os.path.getsize(path) > 0


def refuse_input(output: str, source: str) -> None:
    """Raises Failure if a log would be replaced by what is made of it, whatever the two are called."""
    try:
        given = os.fstat(sys.stdin.fileno()) if source == "-" else os.stat(source)
        same = output != "-" and os.path.samestat(given, os.stat(output))
    except (OSError, ValueError):  # one of them does not exist, or standard input is no file
        return
    if same and os.path.isfile(output):
        raise Misuse(f"{output} is the log itself; name another file")


def note(text: str) -> None:
    """Reports what was done, only on a terminal."""
    if sys.stderr.isatty():
        print(text, file=sys.stderr)


__all__ = ["holds_bytes", "note", "refuse_input", "whole", "whole_path"]
