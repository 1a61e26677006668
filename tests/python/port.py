"""A serial port, a pseudo-terminal or a TCP connection, for the `live` requests of the conformance driver."""

from __future__ import annotations

import os
import select
import socket
import tty


class Port:
    """`name` is the path of a terminal, or HOST:PORT."""

    def __init__(self, name: str) -> None:
        self.closed = False
        host, colon, number = name.rpartition(":")
        if colon and not number.isdecimal():
            raise OSError(f"{number} is not a TCP port")
        if colon:
            connection = socket.create_connection((host, int(number)), timeout=120)
            connection.setblocking(True)
            self.handle = connection.detach()
        else:
            self.handle = os.open(name, os.O_RDWR | os.O_NOCTTY)
            tty.setraw(self.handle)

    def write(self, data: bytes) -> None:
        try:
            while data and not self.closed:
                data = data[os.write(self.handle, data) :]
        except OSError:
            self.closed = True

    def read(self, seconds: float) -> bytes:
        """Reads what has arrived, waiting at most that long; nothing also if the port is closed."""
        ready = select.select([] if self.closed else [self.handle], [], [], seconds)[0]
        try:
            data = os.read(self.handle, 4096) if ready else b""
        except OSError:  # the other end of a pseudo-terminal is closed
            data = b""
        self.closed = self.closed or (bool(ready) and not data)
        return data

    def close(self) -> None:
        os.close(self.handle)
