"""The connections of clients to the device: pseudo-terminals, TCP and UDP ports."""

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

from mip_tools.binding import SYNC
from mip_tools.errors import Failure, Misuse

fcntl: Any
termios: Any
tty: Any
try:
    fcntl, termios, tty = map(import_module, ("fcntl", "termios", "tty"))
except ImportError:  # Windows has no pseudo-terminals
    fcntl = termios = tty = None

DEFAULT_HOST = "localhost"


@dataclass(frozen=True, eq=False)
class Endpoint:
    """A place to connect to: `pty` at a path (empty: no link is made), or `tcp` or `udp` at a host."""

    kind: str
    host: str = ""
    number: int = 0
    path: str = ""
    port: str | None = None
    """The name of the device's port in its profile; None: its main port."""


def pty_at(path: str, port: str | None = None) -> Endpoint:
    return Endpoint("pty", path=path, port=port)


def tcp_at(text: str, port: str | None = None) -> Endpoint:
    """Parses "5000", "localhost:5000" or "[::1]:5000"; with 0, the system chooses a port. Raises Failure."""
    return _at_host("tcp", text, port)


def udp_at(text: str, port: str | None = None) -> Endpoint:
    """Parses the same for UDP."""
    return _at_host("udp", text, port)


def _at_host(kind: str, text: str, port: str | None) -> Endpoint:
    host, _, digits = text.rpartition(":")
    if not (digits.isascii() and digits.isdigit()) or int(digits) > 65535:
        forms = "write PORT or HOST:PORT, as in 5000 or 0.0.0.0:5000"
        raise Misuse(f"'{text}' is not a {kind.upper()} port; {forms}")
    return Endpoint(kind, host=host.strip("[]") or DEFAULT_HOST, number=int(digits), port=port)


#: Kind of an endpoint -> the function that parses its address.
KINDS: dict[str, Callable[[str, str | None], Endpoint]] = {"pty": pty_at, "tcp": tcp_at, "udp": udp_at}


class Pty:
    """A pseudo-terminal in raw mode. It stays open while clients connect and disconnect."""

    def __init__(self, path: str) -> None:
        if termios is None:
            raise Failure("this system has no pseudo-terminals; use --tcp")
        self._path = Path(path) if path else None
        try:
            self._master, self._slave = os.openpty()
        except OSError as error:
            raise Failure(f"no pseudo-terminal is available: {error.strerror}; close some, or use --tcp") from None
        # The slave stays open: otherwise, the terminal would end when a client closes it.
        tty.setraw(self._slave)
        os.set_blocking(self._master, False)
        # Packet mode: the first byte of a read shows when a client discards its unread data.
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
            # A killed simulator leaves its link, and the system may assign the same terminal again.
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
            raise Failure(f"{self._path} cannot be created: {error.strerror}; choose another path") from None

    def fileno(self) -> int:
        return self._master

    def __str__(self) -> str:
        return str(self._path or self.name)

    def read(self) -> bytes:
        data = os.read(self._master, 4097)
        if data[:1] > b"\0":  # an event, not data
            self._flushed |= bool(data[0] & termios.TIOCPKT_FLUSHREAD)
            raise BlockingIOError
        return data[1:]

    def flushed(self) -> bool:
        """Has a client, since the last call, discarded its unread data while the buffer was full?

        Most clients do so when they open a terminal.
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
        """The baud rate that the client has set; None if the system has no constant for it."""
        code = termios.tcgetattr(self._slave)[5]
        return _SPEEDS.get(code)

    @property
    def unread(self) -> int:
        """The number of bytes that the client has not read, which are lost when the terminal ends."""
        select.select([self._slave], [], [], 0)  # makes the system pass on bytes that are in transit
        size = array("i", [0])
        fcntl.ioctl(self._slave, termios.FIONREAD, size)
        return size[0]

    def set_speed(self, baud: int) -> None:
        """Sets the terminal to the baud rate of the device, if the system has a constant for it."""
        code = getattr(termios, f"B{baud}", None)
        if code is not None:
            mode = termios.tcgetattr(self._slave)
            mode[4] = mode[5] = code
            termios.tcsetattr(self._slave, termios.TCSANOW, mode)

    def close(self) -> None:
        path = self._path
        if path is not None and path.is_symlink() and os.readlink(path) == self.name:  # unless it was replaced
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
        # Bytes that wait here are old when they are read, so the buffer is not larger than that of a device.
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

    speed: int | None = None  # a TCP connection has no baud rate
    unread = 0  # the system delivers all sent bytes

    def flushed(self) -> bool:
        return False

    def set_speed(self, baud: int) -> None:
        pass

    def close(self) -> None:
        try:
            while self._socket.recv(4096):  # if unread bytes remained, the system would discard sent ones
                pass
        except OSError:
            pass
        self._socket.close()


class Listener:
    """A TCP port that accepts clients."""

    def __init__(self, host: str, number: int) -> None:
        self._host = host
        self._socket = _bound("tcp", host, number)
        self.number: int = self._socket.getsockname()[1]

    def fileno(self) -> int:
        return self._socket.fileno()

    def __str__(self) -> str:
        return _address(self._host, self.number)

    def accept(self) -> Client | None:
        """Accepts the next client; None if it has already left."""
        try:
            return Client(self._socket.accept()[0])
        except OSError:
            return None

    def close(self) -> None:
        self._socket.close()


class Udp:
    """A UDP port. The device sends to the host of the last datagram; before the first one, its output is lost."""

    #: The size of a datagram that most networks do not fragment.
    MOST = 1400

    def __init__(self, host: str, number: int) -> None:
        self._host = host
        self._socket = _bound("udp", host, number)
        self._client: Any = None
        self.number: int = self._socket.getsockname()[1]

    def fileno(self) -> int:
        return self._socket.fileno()

    def __str__(self) -> str:
        return _address(self._host, self.number)

    def read(self) -> bytes:
        try:
            data, self._client = self._socket.recvfrom(65536)
        except OSError:  # may report that a host is gone; others may connect
            raise BlockingIOError from None
        if not data:
            raise BlockingIOError
        return data

    def write(self, data: bytes | memoryview) -> int:
        """Sends one datagram, which contains only whole packets if it has several."""
        if self._client is None:
            return len(data)
        if len(data) > self.MOST:
            end = bytes(data[: self.MOST]).rfind(SYNC)
            data = data[: end if end > 0 else self.MOST]
        try:
            return self._socket.sendto(data, self._client)
        except BlockingIOError:
            raise
        except OSError:  # the host cannot be reached
            return len(data)

    speed: int | None = None
    unread = 0

    def flushed(self) -> bool:
        return False

    def set_speed(self, baud: int) -> None:
        pass

    def close(self) -> None:
        self._socket.close()


def _address(host: str, number: int) -> str:
    return f"[{host}]:{number}" if ":" in host else f"{host}:{number}"


def _bound(kind: str, host: str, number: int) -> socket.socket:
    """Opens a non-blocking socket at this address; a TCP socket listens. Raises Failure."""
    wanted = socket.SOCK_STREAM if kind == "tcp" else socket.SOCK_DGRAM
    try:
        family, socket_type, protocol, _, address = socket.getaddrinfo(
            "127.0.0.1" if host == DEFAULT_HOST else host, number, type=wanted
        )[0]
    except OSError:
        raise Failure(f"host '{host}' is unknown; use localhost, or 0.0.0.0 for all networks") from None
    made = socket.socket(family, socket_type, protocol)
    try:
        if kind == "tcp" and os.name == "posix":
            made.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        made.bind(address)
        if kind == "tcp":
            made.listen()
    except OSError as error:
        made.close()
        raise Failure(_refused(error, kind, host, number)) from None
    made.setblocking(False)
    return made


def _refused(error: OSError, kind: str, host: str, number: int) -> str:
    what = f"{kind.upper()} port {number}"
    if error.errno == errno.EADDRINUSE:
        return f"{what} is in use; end the program that uses it, or choose another: --{kind} {number + 1}"
    if error.errno == errno.EACCES:
        return f"{what} needs privileges; use 1024 or above"
    if error.errno == errno.EADDRNOTAVAIL:
        return f"{host} is not an address of this machine; use localhost, or 0.0.0.0 for all networks"
    return f"{what} of {host} cannot be opened: {error.strerror}"


Scramble = Callable[[bytes], bytes]


def scrambler(seed: int) -> Scramble:
    """Makes the function that changes bytes as a wrong baud rate does."""
    random = Random(f"{seed}:baud")
    return lambda data: random.randbytes(len(data))
