"""The bytes of a log: a file, which is mapped and not read, or a buffer."""

from __future__ import annotations

import io
import mmap
import os
from typing import Any

import numpy as np

from .scan import Array

#: Reading a byte maps up to this many bytes around it, even if they were released before.
_AROUND = 1 << 21


class Source:
    """Bytes that are read piece by piece."""

    def __init__(self, source: Any) -> None:
        self._map: mmap.mmap | None = None
        self._begin = 0  # where the log begins in that file
        #: Facts about all of it, which parts of a log share.
        self.notes: dict[Any, Any] = {}
        #: A source for another process: a path or bytes.
        self.origin: str | bytes | None = source if isinstance(source, bytes) else None
        if isinstance(source, (str, os.PathLike)):
            self.origin = os.path.abspath(os.fsdecode(source))
            with open(source, "rb") as file:
                data = self._mapped(file)
        elif hasattr(source, "read"):
            data = self._mapped(source)
        else:
            data = source
        try:
            self._view = memoryview(data).cast("B")
        except TypeError:
            name = type(source).__name__
            raise TypeError(f"a log is a path, a binary file or bytes without gaps, not {name}") from None
        self.size = len(self._view)

    def _mapped(self, file: Any) -> Any:
        """Returns the rest of a file, mapped if possible, else read."""
        if isinstance(file, (io.BufferedReader, io.BufferedRandom, io.FileIO)):  # not one that decompresses
            try:
                self._begin = file.tell()
                self._map = mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)
                return memoryview(self._map)[self._begin :]
            except (OSError, ValueError):  # a pipe, an empty file
                pass
        data = file.read()
        if isinstance(data, str):
            raise TypeError("a log is bytes: open the file in binary mode")
        return data

    def piece(self, begin: int, size: int, ahead: int) -> tuple[Array, int]:
        """Returns `size` bytes from `begin` on and `ahead` more, and how many of them belong to the log.

        The result always has this length: zeros follow the end of the log.
        """
        try:
            bytes_ = self._view[begin : begin + size + ahead]
        except ValueError:
            raise ValueError("the log is closed") from None
        data = np.frombuffer(bytes_, np.uint8)
        missing = size + ahead - len(data)
        if not missing:
            return data, len(data)
        return np.concatenate((data, np.zeros(missing, np.uint8))), len(data)

    def forget(self, begin: int, end: int) -> None:
        """Releases the memory of a part of a mapped file, which is read again if it is needed."""
        if self._map is None or not hasattr(mmap, "MADV_DONTNEED"):
            return
        page = mmap.PAGESIZE
        first = max(0, self._begin + begin - _AROUND) // page * page
        last = (self._begin + end) // page * page
        if last > first:
            self._map.madvise(mmap.MADV_DONTNEED, first, last - first)

    def close(self) -> None:
        """Closes the file. Columns already read remain valid."""
        self._view.release()
        if self._map is not None:
            try:
                self._map.close()
            except BufferError:  # another part of the program still uses it
                pass
