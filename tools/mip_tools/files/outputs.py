"""Files that are either complete or absent."""

from __future__ import annotations

import errno
import glob
import os
import shutil
import stat
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO, TextIO

from ..errors import Failure, Misuse
from . import signals

#: The longest file name that every common file system allows, in bytes.
_LONGEST = 255


@contextmanager
def whole(name: str, keep: bool = False, replace: bool = True) -> Iterator[IO[bytes]]:
    """Opens a file for writing, or standard output for `-`. The file gets its name when it is complete.

    After an interrupt or an error nothing is left, unless `keep` is set: then the file has what was written before.
    Without `replace`, a file that has appeared meanwhile is not replaced: this raises Failure, and the written part is
    kept. Raises Failure for other errors, too.
    """
    if name == "-" or _is_output(name):
        yield sys.stdout.buffer
        sys.stdout.buffer.flush()
        return
    with _whole_path(name, keep, replace) as part:
        try:
            file = open(part, "wb")
        except OSError as error:
            raise Failure(f"{name} cannot be written: {error.strerror}") from None
        with file:
            yield file


@contextmanager
def _whole_path(name: str, keep: bool, replace: bool) -> Iterator[Path]:
    """Provides a path beside a file, which replaces that file at the end. Raises Failure."""
    path, special = _target(name)
    if special:
        try:
            yield path
        except OSError as error:
            raise _failed(name, error) from None
        return
    if replace and not keep:
        _remove_abandoned(path)
    part = _beside(path)
    interrupts = signals.Deferred()  # so that no interrupt occurs while files get or lose their names
    with signals.handled(interrupts):
        try:
            interrupts.open = True
            yield part
            interrupts.open = False
        except BaseException as error:
            interrupts.open = False
            # An interrupt at the very end of the caller's `with` arrives here as GeneratorExit.
            # A lost port and a time-out are a Failure: what came before may be all that there is of it.
            ended = isinstance(error, (KeyboardInterrupt, GeneratorExit, OSError, Failure))
            keeps = keep and ended and holds_bytes(part)
            if keeps:
                _rename(part, path, name, keep, replace)
            else:
                with suppress(OSError):
                    part.unlink()
            if isinstance(error, OSError):
                more = "; the part before is kept" if keeps else ""
                raise _failed(name, error, more) from None
            raise
        _rename(part, path, name, keep, replace)
    if interrupts.waits:
        raise KeyboardInterrupt


def _is_output(name: str) -> bool:
    """Is this the same file as standard output, such as /dev/stdout?"""
    try:
        return os.path.samestat(os.stat(name), os.fstat(sys.stdout.fileno()))
    except (OSError, ValueError):  # there is no such file yet, or standard output is not a file
        return False


def _target(name: str) -> tuple[Path, bool]:
    """Resolves links. Returns the path, and whether the file is special, such as /dev/null, and must not be replaced.

    Raises Failure if the file cannot be written.
    """
    if not name:
        raise Misuse("the name of the output file is empty")
    try:
        mode = os.stat(name).st_mode
        if not os.access(name, os.W_OK):
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
    except FileNotFoundError:
        mode = stat.S_IFREG
    except OSError as error:  # such as a name that is too long
        raise _failed(name, error) from None
    if stat.S_ISDIR(mode) or name.endswith(os.sep):
        raise Failure(f"{name} is a folder; name a file in it")
    special = not stat.S_ISREG(mode)
    return Path(name if special else os.path.realpath(name)), special


def _beside(path: Path) -> Path:
    """Returns an unused name for the incomplete file, which is not too long if the name of the file is not."""
    number = os.getpid()
    while True:
        end, begin = f".{number}.part", path.name
        while len(os.fsencode(begin + end)) > _LONGEST:
            begin = begin[:-1]
        part = path.with_name(begin + end)
        if not part.exists():
            return part
        number += 1  # a killed program has left this part; process IDs repeat


def _remove_abandoned(path: Path) -> None:
    """Removes what killed programs have left of this file, except parts that may be all that is left of a recording."""
    for part in path.parent.glob(f"{glob.escape(path.name)}.*.part"):
        number = part.name[len(path.name) + 1 : -len(".part")]
        if number.isdigit() and not _is_running(int(number)):
            with suppress(OSError):
                part.unlink()


def _is_running(process: int) -> bool:
    if os.name == "nt":
        return False  # nothing can be tried there without an effect, but files that are open cannot be removed
    try:
        os.kill(process, 0)
    except (ProcessLookupError, OverflowError):
        return False
    except PermissionError:
        pass
    return True


def _failed(name: str, error: OSError, more: str = "") -> Exception:
    """Returns the exception to raise: a Failure, unless the program that reads a pipe has ended."""
    if isinstance(error, BrokenPipeError):
        return error
    return Failure(f"{name} cannot be written: {error.strerror or error}{more}")


def _rename(part: Path, path: Path, name: str, keep: bool, replace: bool) -> None:
    if not replace and holds_bytes(path):
        raise Failure(f"{name} has appeared meanwhile; the bytes are in {part}")
    try:
        with suppress(OSError):  # there is no older file, or the file system has no permissions
            shutil.copymode(path, part)
        os.replace(part, path)
    except OSError as error:
        if keep:
            raise _failed(name, error, f"; the bytes are in {part}") from None
        with suppress(OSError):
            part.unlink()
        raise _failed(name, error) from None


def holds_bytes(path: str | Path) -> bool:
    """Is this an existing file that is not empty?"""
    return os.path.isfile(path) and os.path.getsize(path) > 0


def refuse_input(output: str, source: str) -> None:
    """Raises Misuse if the output would replace the log, even under another name."""
    try:  # one of them may not exist, or standard input or output may not be a file
        source_stat = os.fstat(sys.stdin.fileno()) if source == "-" else os.stat(source)
        taken = os.fstat(sys.stdout.fileno()) if output == "-" else os.stat(output)
    except (OSError, ValueError):
        return
    if os.path.samestat(source_stat, taken) and stat.S_ISREG(taken.st_mode):
        name = "standard output" if output == "-" else output
        raise Misuse(f"{name} is the log itself; name another file")


def redraws(stream: TextIO) -> bool:
    """Is this a terminal on which text can be replaced?"""
    return stream.isatty() and os.environ.get("TERM", "dumb") not in ("", "dumb")


def progress(text: str) -> None:
    """Replaces the progress line on standard error; an empty text removes it."""
    if redraws(sys.stderr):
        sys.stderr.write(f"\r\x1b[K{text}")
        sys.stderr.flush()


def note(text: str) -> None:
    """Reports on standard error what was done, but only on a terminal."""
    if sys.stderr.isatty():
        print(text, file=sys.stderr)
