"""The connections of clients to the device: pseudo-terminals and TCP ports."""

from __future__ import annotations

import errno
import os
import select
import socket
from array import array
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from random import Random
from typing import Any

from ..errors import Failure, Misuse

fcntl: Any
termios: Any
tty: Any
try:
    fcntl, termios, tty = map(import_module, ("fcntl", "termios", "tty"))
except ImportError:  # Windows has no pseudo-terminals
    fcntl = termios = tty = None

DEFAULT_HOST = "localhost"


@dataclass(frozen=True)
class Endpoint:
    """One place to connect to: `pty` at a path (empty: no link is made), or `tcp` at a host."""

    kind: str
    host: str = ""
    number: int = 0
    path: str = ""
    port: str | None = None
    """The port of the device, as its profile calls it; None: its main port."""


def pty_at(path: str, port: str | None = None) -> Endpoint:
    return Endpoint("pty", path=path, port=port)


def tcp_at(text: str, port: str | None = None) -> Endpoint:
    """From "5000", "localhost:5000" or "[::1]:5000"; 0 lets the system choose. Raises Failure."""
    host, _, digits = text.rpartition(":")
    if not (digits.isascii() and digits.isdigit()) or int(digits) > 65535:
        raise Misuse(f"'{text}' is not a TCP port; write PORT or HOST:PORT, as in 5000 or 0.0.0.0:5000")
    return Endpoint("tcp", host=host.strip("[]") or DEFAULT_HOST, number=int(digits), port=port)


class Pty:
    """A pseudo-terminal in raw mode. It stays open while clients connect and disconnect."""

    def __init__(self, path: str) -> None:
        if termios is None:
            raise Failure("this system has no pseudo-terminals; use --tcp")
        self._path = Path(path) if path else None
        try:
            self._master, self._slave = os.openpty()
        except OSError as error:
            raise Failure(f"no pseudo-terminal: {error.strerror}; close some, or use --tcp") from None
        # The slave stays open: without it, a client that leaves ends the terminal.
        tty.setraw(self._slave)
        os.set_blocking(self._master, False)
        # Packet mode: a byte before what is read tells when a client discards what it has not read.
        fcntl.ioctl(self._master, termios.TIOCPKT, array("i", [1]))
        self._flushed = self._full = False
        self.name = os.ttyname(self._slave)
        try:
            self._make_link()
        except BaseException:
            self._close_files()
            raise

    def _make_link(self) -> None:
        if self._path is None:
            return
        if self._path.is_symlink():
            leads = os.readlink(self._path)
            if not leads.startswith("/dev/"):
                raise Failure(f"{self._path} is a link to something else; choose another path, or remove it")
            # A simulator that was killed leaves its link, and the system gives its terminal again.
            if self._path.exists() and leads != self.name:
                raise Failure(
                    f"{self._path} leads to {leads}, perhaps of another simulator; "
                    "end that one, remove the link, or choose another path"
                )
        elif self._path.exists():
            raise Failure(f"{self._path} exists; choose another path, or remove it")
        part = self._path.with_name(f"{self._path.name}.{os.getpid()}.part")
        try:
            os.symlink(self.name, part)
            part.replace(self._path)
        except OSError as error:
            with suppress(OSError):
                part.unlink()
            raise Failure(f"{self._path} cannot be made: {error.strerror}; choose another path") from None

    def fileno(self) -> int:
        return self._master

    def __str__(self) -> str:
        return str(self._path or self.name)

    def read(self) -> bytes:
        data = os.read(self._master, 4097)
        if data[:1] > b"\0":  # an event, no data
            self._flushed |= bool(data[0] & termios.TIOCPKT_FLUSHREAD)
            raise BlockingIOError
        return data[1:]

    def flushed(self) -> bool:
        """Has a client discarded what it has not read, while there was no room for more? Since the last call.

        Most do when they open a terminal.
        """
        events = select.poll()
        events.register(self._master, select.POLLPRI)
        if events.poll(0):
            with suppress(BlockingIOError):
                self.read()
        flushed, self._flushed = self._flushed and self._full, False
        return flushed

    def write(self, data: bytes | memoryview) -> int:
        self._full = True
        done = os.write(self._master, data)
        self._full = False
        return done

    @property
    def speed(self) -> int | None:
        """The baud rate that the client has set; None if it has no name."""
        code = termios.tcgetattr(self._slave)[5]
        return _SPEEDS.get(code)

    @property
    def unread(self) -> int:
        """Bytes that the client has not read; they are lost when the terminal ends."""
        select.select([self._slave], [], [], 0)  # makes the system hand over what is in between
        size = array("i", [0])
        fcntl.ioctl(self._slave, termios.FIONREAD, size)
        return size[0]

    def set_speed(self, baud: int) -> None:
        """Shows the baud rate of the device, where the system has a name for it."""
        code = getattr(termios, f"B{baud}", None)
        if code is not None:
            mode = termios.tcgetattr(self._slave)
            mode[4] = mode[5] = code
            termios.tcsetattr(self._slave, termios.TCSANOW, mode)

    def close(self) -> None:
        path = self._path
        if path is not None and path.is_symlink() and os.readlink(path) == self.name:  # not one made by others since
            path.unlink(missing_ok=True)
        self._close_files()

    def _close_files(self) -> None:
        os.close(self._master)
        os.close(self._slave)


_SPEEDS: dict[int, int] = {
    code: int(name[1:])
    for name, code in (vars(termios) if termios else {}).items()
    if name[:1] == "B" and name[1:].isdigit()
}


class Client:
    """A TCP connection."""

    def __init__(self, connection: socket.socket) -> None:
        self._socket = connection
        connection.setblocking(False)
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        # What waits here is old when it is read: no more of it than a device would keep.
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, 32768)
        peer = connection.getpeername()
        self.name = f"{peer[0]}:{peer[1]}"

    def fileno(self) -> int:
        return self._socket.fileno()

    def __str__(self) -> str:
        return self.name

    def read(self) -> bytes:
        return self._socket.recv(4096)

    def write(self, data: bytes | memoryview) -> int:
        return self._socket.send(data)

    speed: int | None = None  # a connection has none
    unread = 0  # the system delivers what was sent

    def flushed(self) -> bool:
        return False

    def set_speed(self, baud: int) -> None:
        pass

    def close(self) -> None:
        try:
            while self._socket.recv(4096):  # unread bytes would make the system discard what was sent
                pass
        except OSError:
            pass
        self._socket.close()


class Listener:
    """A TCP port that accepts clients."""

    def __init__(self, host: str, number: int) -> None:
        self._host = host
        try:
            family, kind, protocol, _, address = socket.getaddrinfo(
                "127.0.0.1" if host == DEFAULT_HOST else host, number, type=socket.SOCK_STREAM
            )[0]
        except OSError:
            raise Failure(f"host '{host}' is unknown; use localhost, or 0.0.0.0 for all networks") from None
        self._socket = socket.socket(family, kind, protocol)
        try:
            if os.name == "posix":
                self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            self._socket.bind(address)
            self._socket.listen()
        except OSError as error:
            self._socket.close()
            raise Failure(_refused(error, host, number)) from None
        self._socket.setblocking(False)

    def fileno(self) -> int:
        return self._socket.fileno()

    def __str__(self) -> str:
        host = f"[{self._host}]" if ":" in self._host else self._host
        return f"{host}:{self._socket.getsockname()[1]}"

    def accept(self) -> Client | None:
        """The next client; None if it has left already."""
        try:
            return Client(self._socket.accept()[0])
        except OSError:
            return None

    def close(self) -> None:
        self._socket.close()


def _refused(error: OSError, host: str, number: int) -> str:
    if error.errno == errno.EADDRINUSE:
        return f"TCP port {number} is in use; end the program that has it, or use another: --tcp {number + 1}"
    if error.errno == errno.EACCES:
        return f"TCP port {number} needs privileges; use one from 1024 on"
    if error.errno == errno.EADDRNOTAVAIL:
        return f"{host} is not an address of this machine; use localhost, or 0.0.0.0 for all networks"
    return f"TCP port {number} of {host} cannot be opened: {error.strerror}"


Scramble = Callable[[bytes], bytes]


def scrambler(seed: int) -> Scramble:
    """The effect of a wrong baud rate on bytes."""
    random = Random(f"{seed}:baud")
    return lambda data: random.randbytes(len(data))
