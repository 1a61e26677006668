"""Writes what a device sends to a file."""

from __future__ import annotations

import time
from typing import IO

from ..files import outputs
from ..logs.scan import Scanner
from ..text.numbers import readable
from . import connection
from .silence import Line, Silence


class Recording:
    """The bytes that a device sends, written as they arrive."""

    def __init__(self, line: Line, seconds: float | None, most: int | None, begin: connection.Begin) -> None:
        """`seconds` and `most` packets end it. `begin` is called with the device as soon as the port is open."""
        self._line, self._seconds, self._most, self._begin = line, seconds, most, begin
        self._scanner = Scanner()
        self.size = 0
        self.packets = 0
        self.skipped = 0
        self._shown = self._start = time.monotonic()

    def write(self, out: IO[bytes]) -> None:
        """Writes the received bytes until the requested duration or number of packets is reached."""
        watch: Silence | None = None
        for data in connection.received_bytes(self._line, self._seconds, self._begin):
            watch = watch or Silence(self._line)
            keep = len(data)
            if data:
                watch.data(data)
            for piece in self._scanner.feed(data):
                if piece.packet is not None:
                    watch.packet()
                self.packets += piece.packet is not None
                self.skipped += len(piece.data) * (piece.packet is None)
                if self.packets == self._most:
                    keep = piece.offset + len(piece.data) - self.size
                    break
            out.write(data[:keep])
            out.flush()  # so that written bytes are safe even if this program is killed
            self.size += keep
            self._show()
            watch.check()
            if self.packets == self._most:
                return

    def status(self) -> str:
        """Summarizes the recording."""
        spent = max(time.monotonic() - self._start, 1e-9)
        return (
            f"{spent:.0f} s, {readable(self.size)}, {self.packets} packets, "
            f"{self.packets / spent:.0f} per second, {self.skipped} bytes skipped"
        )

    def _show(self) -> None:
        now = time.monotonic()
        if now - self._shown > 0.5:
            self._shown = now
            outputs.progress(self.status())
