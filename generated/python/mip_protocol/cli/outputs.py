"""Files that are either complete or absent."""

from __future__ import annotations

import os
import stat
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO

from ..errors import Failure, Misuse


@contextmanager
def whole(name: str, keep: bool = False, replace: bool = True) -> Iterator[IO[bytes]]:
    """A file to write, or standard output for `-`. It gets its name when it is complete.

    After an interrupt or an error nothing is left, unless the written part is to be kept. Raises Failure, also if a
    file that is not to be replaced has appeared meanwhile; the part is then kept.
    """
    if name == "-":
        yield sys.stdout.buffer
        sys.stdout.buffer.flush()
        return
    with whole_path(name, keep, replace) as part:
        try:
            file = open(part, "wb")
        except OSError as error:
            raise Failure(f"{name} cannot be written: {error.strerror}") from None
        with file:
            yield file


@contextmanager
def whole_path(name: str, keep: bool = False, replace: bool = True) -> Iterator[Path]:
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
    number = os.getpid()
    while (part := path.with_name(f"{path.name}.{number}.part")).exists():
        number += 1  # kept by a program that was killed; numbers of processes repeat
    try:
        yield part
    except BaseException as error:
        keeps = keep and isinstance(error, (KeyboardInterrupt, OSError)) and holds_bytes(part)
        if keeps:
            _rename(part, path, keep, replace)
        else:
            with suppress(OSError):
                part.unlink()
        if isinstance(error, OSError):
            raise _failed(name, error, "; what came before is kept" if keeps else "") from None
        raise
    _rename(part, path, keep, replace)


def _failed(name: str, error: OSError, more: str = "") -> Exception:
    """A pipe whose reader has stopped is no failure."""
    if isinstance(error, BrokenPipeError):
        return error
    return Failure(f"{name} cannot be written: {error.strerror or error}{more}")


def _rename(part: Path, path: Path, keep: bool, replace: bool) -> None:
    if not replace and holds_bytes(path):
        raise Failure(f"{path} has appeared meanwhile; the bytes are in {part}")
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
    """Raises Misuse if a log would be replaced by what is made of it, whatever the two are called."""
    try:  # one of them may not exist, or standard input or output may be no file
        given = os.fstat(sys.stdin.fileno()) if source == "-" else os.stat(source)
        taken = os.fstat(sys.stdout.fileno()) if output == "-" else os.stat(output)
    except (OSError, ValueError):
        return
    if os.path.samestat(given, taken) and stat.S_ISREG(taken.st_mode):
        name = "standard output" if output == "-" else output
        raise Misuse(f"{name} is the log itself; name another file")


def note(text: str) -> None:
    """Reports what was done, only on a terminal."""
    if sys.stderr.isatty():
        print(text, file=sys.stderr)


__all__ = ["holds_bytes", "note", "refuse_input", "whole", "whole_path"]
