"""Sources of bytes: a file, standard input, the command line or a port."""

from __future__ import annotations

import os
import re
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import chain
from pathlib import Path
from typing import IO, Any

from ..errors import Failure
from . import outputs
from .scan import Piece, Scanner

CHUNK = 1 << 16
_HEX = re.compile(rb"(?:0[xX])?[0-9A-Fa-f]{2}(?:[\s,:]*(?:0[xX])?[0-9A-Fa-f]{2})*[\s,]*")
_TEXT = re.compile(rb"[0-9A-Fa-fxX\s,:]*")
_SEPARATORS = re.compile(rb"0[xX]|[\s,:]")
_ADDRESS = re.compile(r"(\[[0-9A-Fa-f:]+\]|[\w.-]+):\d{1,5}")


def is_port(text: str) -> bool:
    """Is this a port and not a file: a device, COM3, HOST:PORT, or a URL such as socket://?"""
    if "://" in text:
        return True
    if os.path.exists(text):
        import stat

        return stat.S_ISCHR(os.stat(text).st_mode) and text != os.devnull
    return bool(re.fullmatch(r"(?i)com\d+", text) or _ADDRESS.fullmatch(text)) or text.startswith(
        ("/dev/tty", "/dev/cu.", "/dev/serial/")
    )


def exists(name: str) -> bool:
    """Is there a file of this name, even if it looks like bytes?"""
    return name == "-" or os.path.exists(name)


def hex_bytes(words: list[str]) -> bytes | None:
    """The bytes that these words give in hexadecimal digits; None if they are something else."""
    text = " ".join(words).encode("utf-8", "replace")
    return _plain(text) if _HEX.fullmatch(text.strip()) else None


def _plain(text: bytes) -> bytes:
    return bytes.fromhex(_SEPARATORS.sub(b"", text).decode("ascii"))


def chunks(name: str, progress: bool = True) -> Iterator[bytes]:
    """The bytes of a file, or of standard input for `-`, as they arrive. Text of hex digits is
    converted.

    `progress` of long files is shown on a terminal. Raises Failure if it cannot be read.
    """
    if is_port(name):
        raise Failure(f"{name} is a port, not a log; `mip record` writes a log of what it sends")
    try:
        if name == "-":
            yield from _converted(_read(sys.stdin.buffer), name)
        else:
            with open(name, "rb") as file:
                yield from _converted(_shown(file) if progress else _read(file), name)
    except OSError as error:
        if isinstance(error, BrokenPipeError):
            raise
        raise Failure(f"{name} cannot be read: {error.strerror or error}") from None


def pieces(name: str, progress: bool = True) -> Iterator[Piece]:
    """The packets of a file or of standard input, and the bytes between them."""
    scanner = Scanner()
    for chunk in chunks(name, progress):
        yield from scanner.feed(chunk)
    yield from scanner.flush()


def is_log(name: str) -> bool:
    """Is this a file of bytes that can be read: not hexadecimal digits, no pipe, not standard input?"""
    try:
        if name == "-" or not os.path.isfile(name):
            return False
        with open(name, "rb") as file:
            return not _is_text(file.read(CHUNK))
    except OSError:
        return False


def as_columns(name: str) -> Any:
    """The log in columns, a `columns.Log`; None without NumPy, or if it is no file of bytes."""
    if not is_log(name):
        return None
    try:
        from ..columns import read_log
    except ImportError:
        return None
    return read_log(name)


@contextmanager
def seekable(name: str) -> Iterator[str]:
    """A file of bytes that can be read twice: the file itself, or a temporary one with its bytes."""
    if is_log(name):
        yield name
        return
    with tempfile.TemporaryDirectory(prefix="mip-") as folder:
        path = os.path.join(folder, "input")
        with open(path, "wb") as file:
            for chunk in chunks(name):
                file.write(chunk)
        yield path


def _read(file: IO[bytes]) -> Iterator[bytes]:
    read = getattr(file, "read1", file.read)  # what has come, without waiting for more
    while chunk := read(CHUNK):
        yield chunk


def _is_text(first: bytes) -> bool:
    """Are they hexadecimal digits? A packet has a `u`, which is none."""
    return bool(first.strip() and _TEXT.fullmatch(first))


def _converted(source: Iterator[bytes], name: str) -> Iterator[bytes]:
    first = next(source, b"")
    while len(first) < 16 and _TEXT.fullmatch(first) and (more := next(source, b"")):
        first += more  # a port may give one byte at first
    if not _is_text(first):
        yield first
        yield from source
        return
    rest = b""
    for chunk in chain((first,), source):
        digits = _SEPARATORS.sub(b"", rest + chunk)
        rest = digits[len(digits) & ~1 :]
        try:
            yield bytes.fromhex(digits[: len(digits) & ~1].decode("ascii"))
        except ValueError:
            raise Failure(f"{name} begins with hexadecimal digits but has other text, too; remove it") from None
    if rest:
        raise Failure(f"{name} has an odd number of hexadecimal digits; two make a byte")


# --------------------------------------------------------------------------- progress


class Progress:
    """The progress of a long task, on standard error if that is a terminal."""

    def __init__(self, size: int) -> None:
        self._size = size
        self._shown = time.monotonic()
        self._on = size >= 1 << 22

    def at(self, done: int) -> None:
        """Shows it, but not too often."""
        now = time.monotonic()
        if self._on and now - self._shown > 0.2:
            self._shown = now
            outputs.progress(f"{done / self._size:.0%} of {readable(self._size)}")

    def clear(self) -> None:
        """Removes it from the terminal."""
        if self._on:
            outputs.progress("")


def _shown(file: IO[bytes]) -> Iterator[bytes]:
    progress, done = Progress(os.fstat(file.fileno()).st_size), 0
    try:
        for chunk in _read(file):
            yield chunk
            done += len(chunk)
            progress.at(done)
    finally:
        progress.clear()


def readable(size: float) -> str:
    """A number of bytes for people."""
    for unit in ("B", "kB", "MB", "GB"):
        if size < 1000 or unit == "GB":
            return f"{size:.0f} {unit}" if unit == "B" else f"{size:.3g} {unit}"
        size /= 1000
    raise AssertionError


def counted(number: int, what: str) -> str:
    """A number of things: `1 byte`, `2 bytes`."""
    return f"{number} {what}{'s' * (number != 1)}"


def existing(name: str) -> Path:
    """A file that can be read. Raises Failure."""
    path = Path(name)
    try:
        with open(path, "rb"):
            pass
    except OSError as error:
        raise Failure(f"{name} cannot be read: {error.strerror or error}") from None
    return path


__all__ = [
    "CHUNK",
    "Progress",
    "as_columns",
    "chunks",
    "counted",
    "existing",
    "exists",
    "hex_bytes",
    "is_log",
    "is_port",
    "pieces",
    "readable",
    "seekable",
]
