"""Sources of bytes: a file, standard input, the command line or a port."""

from __future__ import annotations

import os
import queue
import re
import stat
import sys
import tempfile
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import chain
from pathlib import Path
from typing import IO, TYPE_CHECKING

from ..binding import MissingExtra
from ..errors import Failure
from ..files import outputs
from ..text.numbers import readable, spent
from .recognize import MOST, from_text, need_packets, no_packets
from .scan import Piece, Scanner

if TYPE_CHECKING:
    from ..columns import Log
    from ..columns.sender import Sender

CHUNK = 1 << 16
#: The size from which on a batch of pieces is complete, even if more have arrived.
_BATCH = 1 << 20
#: Seconds without data after which `arriving` yields None.
_TURN = 0.1
_HEX = re.compile(rb"(?:0[xX])?[0-9A-Fa-f]{2}(?:[\s,:]*(?:0[xX])?[0-9A-Fa-f]{2})*[\s,]*")
_TEXT = re.compile(rb"[0-9A-Fa-fxX\s,:]*")
_SEPARATORS = re.compile(rb"0[xX]|[\s,:]")
_ADDRESS = re.compile(r"(\[[0-9A-Fa-f:]+\]|[\w.-]+):\d{1,5}")


def is_port(text: str) -> bool:
    """Is this a port and not a file: a device, COM3, HOST:PORT, or a URL such as socket://?"""
    if "://" in text:
        return True
    if os.path.exists(text):
        return stat.S_ISCHR(os.stat(text).st_mode) and text != os.devnull
    return bool(re.fullmatch(r"(?i)com\d+", text) or _ADDRESS.fullmatch(text)) or text.startswith(
        ("/dev/tty", "/dev/cu.", "/dev/serial/")
    )


def exists(name: str) -> bool:
    """Is there a file of this name, although it looks like hexadecimal bytes?"""
    return name == "-" or os.path.exists(name)


def typed_bytes(words: list[str]) -> bytes | None:
    """Parses words as hexadecimal bytes, or in another notation of bytes; None if they are anything else."""
    text = " ".join(words).encode("utf-8", "replace")
    if _HEX.fullmatch(text.strip()):
        return bytes.fromhex(_SEPARATORS.sub(b"", text).decode("ascii"))
    mistake = _TEXT.fullmatch(text) and len(re.findall(rb"(?<!\S)\w(?!\S)", text)) < 2  # a digit is missing
    return None if mistake else from_text(text)


def chunks(name: str, progress: bool = True) -> Iterator[bytes]:
    """Yields the bytes of a file, or of standard input for `-`, as they arrive. Hexadecimal text is converted.

    `progress`: for long files, the progress is shown on a terminal. Raises Failure if the file cannot be read.
    """
    if is_port(name):
        raise Failure(f"{name} is a port, not a log; `mip record` records a log from it")
    try:
        if name == "-":
            # Unbuffered: a thread blocked in a read would hold the buffer's lock when the program ends.
            yield from _converted(_read(getattr(sys.stdin.buffer, "raw", sys.stdin.buffer)), name)
        else:
            with open(name, "rb") as file:
                yield from _converted(_shown(file) if progress else _read(file), name)
    except OSError as error:
        if isinstance(error, BrokenPipeError):
            raise
        raise Failure(f"{name} cannot be read: {error.strerror or error}") from None


def file_pieces(name: str, progress: bool = True) -> Iterator[Piece]:
    """Yields the packets of a file or of standard input, and the bytes between them."""
    return (piece for piece in arriving(name, progress, empty=True) if piece is not None)


def arriving(name: str, progress: bool = True, empty: bool = False) -> Iterator[Piece | None]:
    """Yields the same as `file_pieces`, and None after each read and regularly while nothing arrives.

    Raises Failure at the end if there were no packets, unless `empty` is set.
    """
    begin: bytes | None = b""  # before the first packet
    for piece in _scanned(name, progress):
        if piece is not None and begin is not None:
            begin = None if piece.packet is not None else begin + piece.data[: MOST - len(begin)]
        yield piece
    if begin is not None and not empty:
        raise no_packets(name, begin)


def _scanned(name: str, progress: bool) -> Iterator[Piece | None]:
    scanner = Scanner()
    source = chunks(name, progress)
    for chunk in _waited_for(source) if name == "-" else source:
        yield from scanner.feed(chunk)
        yield None
    yield from scanner.flush()


def batches(arriving: Iterator[Piece | None]) -> Iterator[list[Piece]]:
    """Yields lists of the pieces that arrive together."""
    batch: list[Piece] = []
    size = 0
    for piece in arriving:
        if piece is not None:
            batch.append(piece)
            size += len(piece.data)
        if batch and (piece is None or size > _BATCH):
            yield batch
            batch, size = [], 0
    if batch:
        yield batch


def _waited_for(source: Iterator[bytes]) -> Iterator[bytes]:
    """Yields the data of a source as it arrives, and empty bytes during pauses, in which a thread waits for data."""
    came: queue.Queue[bytes | BaseException | None] = queue.Queue(maxsize=16)

    def read() -> None:
        try:
            for chunk in source:
                came.put(chunk)
            came.put(None)
        except BaseException as error:
            came.put(error)

    threading.Thread(target=read, daemon=True).start()
    while True:
        try:
            item = came.get(timeout=_TURN)
        except queue.Empty:
            item = b""
        if item is None:
            return
        if isinstance(item, BaseException):
            raise item
        yield item


def is_log(name: str) -> bool:
    """Is this a readable file of raw bytes: not hexadecimal text, not a pipe, not standard input?"""
    try:
        if name == "-" or not os.path.isfile(name):
            return False
        with open(name, "rb") as file:
            return not _is_text(file.read(CHUNK))
    except OSError:
        return False


def need_numpy() -> None:
    """Raises Failure if NumPy is not installed, which reading whole logs needs."""
    try:
        import numpy  # noqa: F401
    except ImportError:
        raise Failure(str(MissingExtra("numpy", "numpy"))) from None


@contextmanager
def open_columns(name: str, device: str | Sender | None = None, empty: bool = False) -> Iterator[Log]:
    """Opens a log, from a file or from standard input, as columns; `device` is who sent it.

    Raises Failure; also if the log has no packets, unless `empty` is set.
    """
    need_numpy()
    from ..columns import read_log

    with seekable(name) as path, read_log(existing(path), device=device) as log:
        if not empty:
            need_packets(name, log)
        yield log


@contextmanager
def seekable(name: str) -> Iterator[str]:
    """Provides a file of bytes that can be read twice: the file itself, or a temporary copy."""
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
    read = getattr(file, "read1", file.read)  # what has arrived, without waiting for more
    while chunk := read(CHUNK):
        yield chunk


def _is_text(first: bytes) -> bool:
    """Is this a notation of bytes? A packet is never mistaken for one: its first sync byte is `u`."""
    return bool(first.strip()) and (_is_hex(first) or from_text(first) is not None)


def _is_hex(first: bytes) -> bool:
    """Are these hexadecimal digits, two for each byte? The last ones may be cut off."""
    digits = _SEPARATORS.split(first)[:-1]
    return bool(_TEXT.fullmatch(first)) and not any(len(each) & 1 for each in digits)


def _converted(source: Iterator[bytes], name: str) -> Iterator[bytes]:
    first = next(source, b"")
    while len(first) < 16 and _TEXT.fullmatch(first) and (more := next(source, b"")):
        first += more  # the first read may return one byte only
    if not _is_text(first):
        yield first
        yield from source
        return
    if not _is_hex(first):
        whole = b"".join([first, *source])
        yield from_text(whole) or whole
        return
    rest = b""
    for chunk in chain((first,), source):
        digits = _SEPARATORS.sub(b"", rest + chunk)
        rest = digits[len(digits) & ~1 :]
        try:
            yield bytes.fromhex(digits[: len(digits) & ~1].decode("ascii"))
        except ValueError:
            raise Failure(f"{name} begins with hexadecimal digits but also has other text; remove that") from None
    if rest:
        raise Failure(f"{name} has an odd number of hexadecimal digits; each byte needs two")


# --------------------------------------------------------------------------- progress


class Progress:
    """Shows the progress of a long task, its speed and the remaining time, on standard error if it is a terminal."""

    def __init__(self, size: int) -> None:
        self._size = size
        self._begun = self._shown = time.monotonic()
        self._on = size >= 1 << 22

    def at(self, done: int) -> None:
        """Shows the progress, but not too often."""
        now = time.monotonic()
        if self._on and done and now - self._shown > 0.2:
            self._shown = now
            rate = done / (now - self._begun)
            left = (self._size - done) / rate
            outputs.progress(
                f"{done / self._size:.0%} of {readable(self._size)}, {readable(rate)}/s, {spent(left)} left"
            )

    def clear(self) -> None:
        """Removes the progress from the terminal."""
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


def existing(name: str) -> Path:
    """Returns the path of a file. Raises Failure if it cannot be read."""
    path = Path(name)
    try:
        with open(path, "rb"):
            pass
    except OSError as error:
        raise Failure(f"{name} cannot be read: {error.strerror or error}") from None
    return path
